(** What has to be shown of a claim: goals that are all to hold. Of several ways to show one thing, one is enough. *)
From Coq Require Import Ascii String List Bool NArith ZArith Reals Lra Lia.
From Slipproof Require Import Text Syntax Meaning Poly Normal NormalSound.
From Slipproof.claim Require Import Expression Mechanism Claim Forms FormsSound Entails Covers Scopes Points Rising.
Import ListNotations.

Fixpoint map_option {A B} (f : A -> option B) (xs : list A) : option (list B) :=
  match xs with [] => Some [] | x :: xs => let* y := f x in let* ys := map_option f xs in Some (y :: ys) end.

Definition way := list goal.

(** No name twice. *)
Fixpoint no_name_twice (names : list string) : bool :=
  match names with [] => true | name :: names => negb (is_in name names) && no_name_twice names end.

Section Setting.
Variable s : setting.
Notation m := (of_mechanism s).
Let names := paper_scope s None.

Definition normal_all (scope : Normal.scope) : list condition -> option (list form) := map_option (normal_condition scope true).

(** Of several motions the second has the suffix _2, and so on; or '2, if a name of the setting is that of an unknown with such a
    suffix of one digit: of bodies A and A_2. No name in a file has a prime. *)
Fixpoint rest_after (start name : string) : option string :=
  match start, name with
  | EmptyString, _ => Some name
  | String a start, String b name => if Ascii.eqb a b then rest_after start name else None
  | _, EmptyString => None
  end.
Definition is_digit (c : ascii) : bool := match digit c with Some _ => true | None => false end.
Definition of_further_motion (unknown name : string) : bool :=
  match rest_after (unknown ++ "_") name with Some (String c EmptyString) => is_digit c | _ => false end.
Definition mark : string :=
  let written := symbols s ++ map fst (paper_definitions s) ++ unknowns m ++ map fst (quantities m) in
  if existsb (fun unknown => existsb (of_further_motion unknown) written) (unknowns m) then "'" else "_".
Definition suffix (i : nat) : string :=
  let numbered number := (mark ++ number)%string in
  match i with
  | O => "" | 1 => numbered "2" | 2 => numbered "3" | 3 => numbered "4" | 4 => numbered "5" | 5 => numbered "6" | 6 => numbered "7"
  | 7 => numbered "8" | _ => numbered "9"
  end%string.
Definition suffixed (i : nat) : list string := let ending := suffix i in map (fun name => (name ++ ending)%string) (unknowns m).
Definition names_of_motions (n : nat) : list string := symbols s ++ flat_map suffixed (seq 0 n).

Definition motion_forms (i : nat) (md : mode) : option (list form) :=
  let* cs := mode_conditions (strict s) (given_parameters s) m md in
  normal_all (mechanism_scope s (suffix i)) (dynamics m ++ cs).

(** Some state of each element. *)
Definition any_of_states (scope : Normal.scope) (states : list (list condition)) : option form :=
  let* parts := map_option (fun cs => let* fs := normal_all scope cs in Some (All fs)) states in Some (Any parts).
Definition all_rubbing_states (r : rubbing) : list state :=
  let pushing := touching_states (rub_begins r) in
  match holder r with
  | None => pushing
  | Some i =>
      match nth_error (contacts m) i with
      | Some c => pushing ++ (if bilateral c then map pulled pushing else [])
                  ++ if may_lift (given_parameters s) c || match begins c with Apart => true | _ => false end then [Free] else []
      | None => []
      end
  end.
Definition any_motion_forms : option (list form) :=
  let scope := mechanism_scope s (suffix 0) in
  let* ds := normal_all scope (dynamics m) in
  let* cs := map_option (fun c => any_of_states scope (map (contact_conditions (strict s) c) (contact_states (given_parameters s) c)))
                        (contacts m) in
  let* rs := map_option (fun r => any_of_states scope (map (rubbing_conditions (strict s) r) (all_rubbing_states r)))
                        (rubbings m) in
  Some (ds ++ cs ++ rs).

Definition same_accelerations (i j : nat) : form :=
  let first := suffix i in let second := suffix j in
  All (map (fun a => Atom Zero (add (variable (code (a ++ first)%string)) (neg (variable (code (a ++ second)%string))))) (accelerations m)).

(** Gaps and slips depend on accelerations alone. *)
Definition fraction_free (vs : list positive) (f : fraction) : bool :=
  poly_free vs (num f) && poly_free vs (or_one (den f)) && forallb (poly_free vs) (divs f).
Definition forces_of : list string := filter (fun u => negb (is_in u (accelerations m))) (unknowns m).
Definition quantities_fit : bool :=
  forallb (fun q => match snd q with Some f => fraction_free (map code forces_of) f | None => false end) (quantity_forms s ""%string)
  && forallb (fun a => is_in a (unknowns m) && negb (is_in a (map fst (definitions m)))) (accelerations m)
  && no_name_twice (map fst (quantities m)).

(** Unknowns are no quantities, and no definition takes their names. *)
Definition unknowns_fit : bool :=
  forallb (fun u => negb (is_in u (map fst (definitions m))) && negb (is_in u (map fst (quantities m)))) (unknowns m).

Definition all_modelled_here : bool :=
  forallb (fun k => bilateral k || may_lift (given_parameters s) k) (contacts m).
End Setting.

(** Each with itself and those after it. *)
Fixpoint pairs {A} (xs : list A) : list (A * A) := match xs with [] => [] | x :: rest => map (pair x) xs ++ pairs rest end.

(** Of a claim that there is one motion, which is in one of these modes: in each of the cells, of which there is always one. *)
Section OneMotion.
Variable s : setting.
Definition listed_forms (i : nat) (modes : list mode) : option form :=
  let* fs := map_option (fun md => let* fs := motion_forms s i md in Some (All fs)) modes in Some (Any fs).
Definition one_motion_ways (facts cells : list form) (modes : list mode) : option (list way) :=
  let* listed := listed_forms 0 modes in
  let* again := listed_forms 1 modes in
  let* any := any_motion_forms s in
  let* one := map_option (fun p => let* fs := motion_forms s 0 (fst p) in
                                   let* gs := motion_forms s 1 (snd p) in
                                   Some [Goal (fs ++ gs ++ facts) [] (same_accelerations s 0 1)]) (pairs modes) in
  Some ([Goal facts [] (Any cells)]
        :: flat_map (fun cell =>
             [[Goal (cell :: facts) (suffixed s 0) listed];
              [Goal (any ++ cell :: facts) [] listed;
               Goal (any ++ again :: cell :: facts) [] (same_accelerations s 0 1)]]) cells ++ one).
End OneMotion.

Section Claim.
Variable c : claim.
Notation s := (in_setting c).
Let names := paper_scope s None.

(** A condition has a value: its divisors are not 0, or it is true, or it is false. *)
Definition value_goal (scope : Normal.scope) (facts : list form) (d : condition) : option goal :=
  let* yes := normal_condition scope true d in
  let* no := normal_condition scope false d in
  let* ds := divisors scope d in Some (Goal facts [] (Any [apart_from_zero ds; yes; no])).
(** Of a condition on the paper's names; of an equation about motions. *)
Definition has_value_goal := value_goal names.
Definition equation_goal := value_goal (motion_scope s (suffix s 0)).
Definition without_force (facts : list form) : list form := filter (form_free [code (force s)]) facts.
Definition model_forms (model : option (option mode)) : option (list form) :=
  match model with
  | Some md => let* cs := model_equations s md in normal_all (mechanism_scope s (suffix s 0)) cs
  | None => Some []
  end.

Definition not_chosen (equations : list condition) : list string :=
  filter (fun u => negb (is_in u (chosen c equations))) (unknowns (of_mechanism s)).

(** References of which one holds. *)
Definition one_region (claims : list reference) : option form :=
  let* parts := map_option (fun r => normal_condition names true (fst r)) claims in Some (Any parts).
Definition one_stated (claims : list reference) : option form :=
  let* parts := map_option (fun r => let* f := normal_condition names true (fst r) in
                                     let* g := normal_condition names true (snd r) in Some (All [f; g])) claims in
  Some (Any parts).

Definition each_motion (facts : list form) (modes : list mode) (shown : option form) : option (list way) :=
  map_option (fun md => let* fs := motion_forms s 0 md in let* g := shown in Some [Goal (fs ++ facts) [] g]) modes.

Definition motions_ways (facts : list form) (modes : list mode) : option (list way) :=
  let* there := map_option (fun md => let* fs := motion_forms s 0 md in Some [Goal facts (suffixed s 0) (All fs)]) modes in
  let* one := map_option (fun md => let* fs := motion_forms s 0 md in
                                    let* gs := motion_forms s 1 md in
                                    Some [Goal (fs ++ gs ++ facts) [] (same_accelerations s 0 1)]) modes in
  let* any := any_motion_forms s in
  let* listed := map_option (fun md => let* fs := motion_forms s 0 md in Some (All fs)) modes in
  let others := combine (seq 1 (length modes)) modes in
  let* with_others := map_option (fun im => motion_forms s (fst im) (snd im)) others in
  Some (there ++ one ++ [[Goal (any ++ facts) [] (Any listed);
                          Goal (any ++ concat with_others ++ facts) [] (Any (map (fun im => same_accelerations s 0 (fst im)) others))]]).

Definition somewhere (more : list form) (modes : list mode) : option goal :=
  let* here := point_forms s in
  let* motions := map_option (fun im => motion_forms s (fst im) (snd im)) (combine (seq 0 (length modes)) modes) in
  Some (Goal [] (names_of_motions s (length modes)) (All (here ++ more ++ concat motions))).

(** That a claim states a point, and that it is not near. *)
Definition stated_form (r : reference) : option form := normal_condition names true (Both (fst r) (snd r)).
Definition beyond_form (r : reference) : option form := normal_condition names false (Both (fst r) (closure true (snd r))).
(** What of it is so whether or not a force is in the domain, [without_force], and what at each force, [facts]. *)
Definition reference_ways (without_force facts : list form) (r : reference) : option (list way) :=
  let* here := normal_condition names true (fst r) in
  let* region_goal := has_value_goal without_force (fst r) in
  let* forces_goal := has_value_goal (here :: facts) (snd r) in
  let* closure_goal := has_value_goal (here :: facts) (closure true (snd r)) in Some [[region_goal]; [forces_goal]; [closure_goal]].

(** For a claim that is to be right or to say nothing everywhere. *)
Definition ways_of_kind (cells : list form) (facts : list form) (forces : form) : option (list way) :=
  let there := forces :: facts in
  match what c with
  | Interval md =>
      let* fs := motion_forms s 0 md in
      Some [[Goal (fs ++ facts) [] forces]; [Goal there (suffixed s 0) (All fs)]]
  | Impossible modes => each_motion there modes (Some (Any []))
  | Formula [] holds => let* g := normal_condition names true holds in Some [[Goal there [] g]]
  | Formula modes holds => each_motion there modes (normal_condition (motion_scope s (suffix s 0)) true holds)
  | Motions modes =>
      require quantities_fit s && all_modelled_here s && Nat.leb (length modes) 7
              && no_name_twice (names_of_motions s (S (length modes))) in
      motions_ways there modes
  | Exists _ => None
  | Equivalence holds =>
      let* g := normal_condition names true holds in
      let* d := has_value_goal facts holds in Some [[Goal there [] g]; [Goal (g :: facts) [] forces]; [d]]
  | Cover claims => let* g := one_region claims in Some [[Goal facts [] g]]
  | ForceCover claims => let* g := one_stated claims in Some [[Goal there [] g]]
  | Consequence model hs es =>
      require negb (is_in (force s) (unknowns (of_mechanism s))) && forallb (linear_equation s) (hs ++ es) in
      let still := without_force facts in
      let* ms := model_forms model in
      let* given := normal_all (motion_scope s (suffix s 0)) hs in
      let* shown := normal_all (motion_scope s (suffix s 0)) es in
      let* values := map_option (equation_goal still) (hs ++ es) in
      Some ([Goal (ms ++ given ++ still) [] (All shown)] :: map (fun g => [g]) values)
  | System model given hs es =>
      require negb (is_in (force s) (unknowns (of_mechanism s))) && forallb (linear_equation s) (given ++ hs ++ es)
              && unknowns_fit s && negb (existsb (mentions_in (map fst (quantities (of_mechanism s)))) (given ++ es)) in
      let still := without_force facts in
      let* ms := model_forms model in
      let* gs := normal_all (motion_scope s (suffix s 0)) given in
      let* others := normal_all (motion_scope s (suffix s 0)) hs in
      let* shown := normal_all (motion_scope s (suffix s 0)) es in
      let* values := map_option (equation_goal still) (given ++ hs ++ es) in
      Some ([Goal (ms ++ gs ++ others ++ still) [] (All shown)]
            :: [Goal (gs ++ shown ++ still) (not_chosen (given ++ es)) (All (ms ++ gs ++ others))] :: map (fun g => [g]) values)
  | Unique claims except modes =>
      let closed := with_boundaries s in
      let* region := normal_condition names true (region c) in
      require quantities_fit closed && all_modelled_here s && form_free [code (force s)] region in
      let* values := map_option (reference_ways (region :: bicycle_facts s) facts) (map snd claims ++ except) in
      let* outside := map_option beyond_form except in
      let common := outside ++ there in
      let* stated := map_option (fun i => let* here := stated_form (snd i) in one_motion_ways closed (here :: common) [All []] [fst i]) claims in
      let* beyond := map_option (fun i => beyond_form (snd i)) claims in
      let* rest := one_motion_ways closed (beyond ++ common) cells modes in
      Some (concat values ++ concat stated ++ rest)
  | Limit p holds (Some from) =>
      let* f := normal_term names from in
      let* beyond := normal_condition names true (Compare from [(Lt, Symbol p)]) in
      let* given := normal_condition names true (Compare from [(Eq, from)]) in
      let* region := normal_condition names true (region c) in
      let* g := normal_condition names true holds in
      require bicycle_fits s && all_rising (code p) (bicycle_facts s) && fraction_free [code p] f
              && form_free [code p] region && is_in p (symbols s) && negb (is_in p (map fst (paper_definitions s))) in
      Some [[Goal (beyond :: facts) [] g]; [Goal facts [] given]]
  | Limit _ _ None => None
  end.

Definition without_forces (k : kind) : bool := match k with Cover _ | Limit _ _ _ => true | _ => false end.
Definition ways (cells : list form) : option (list way) :=
  require convex s (force_domain s) && no_name_twice (names_of_motions s 2) in
  match what c with
  | Exists modes =>
      let* yes := normal_condition names true (region c) in
      let* forces := normal_condition names true (at_forces c) in
      require no_name_twice (names_of_motions s (length modes)) && Nat.leb (length modes) 8 in
      let* g := somewhere [yes; forces] modes in Some [[g]]
  | _ =>
      let facts := if of_any_force (what c) then bicycle_facts s else point_facts s in
      let* yes := normal_condition names true (region c) in
      let* region_goal := has_value_goal (bicycle_facts s) (region c) in
      let* forces := normal_condition names true (at_forces c) in
      let* forces_goal := if without_forces (what c) then Some [] else let* g := has_value_goal (yes :: facts) (at_forces c) in Some [[g]] in
      let* rest := ways_of_kind cells (yes :: facts) forces in Some ([region_goal] :: forces_goal ++ rest)
  end.

(** A solution of the hypotheses that does not satisfy the equations; everywhere they have values. *)
Definition equations_refuted (yes : form) (model : option (option mode)) (hs es : list condition) : option (list way) :=
  require negb (is_in (force s) (unknowns (of_mechanism s))) && forallb (linear_equation s) (hs ++ es) in
  let still := without_force (yes :: bicycle_facts s) in
  let* here := point_forms s in
  let* ms := model_forms model in
  let* given := normal_all (motion_scope s (suffix s 0)) hs in
  let* nos := map_option (normal_condition (motion_scope s (suffix s 0)) false) es in
  let* values := map_option (equation_goal still) (hs ++ es) in
  Some ([Goal [] (names_of_motions s 1) (All (here ++ yes :: Any nos :: ms ++ given))] :: map (fun g => [g]) values).

(** For a claim that is to be wrong at one point; for one that something exists, nowhere right. *)
Definition refuting_ways : option (list way) :=
  require convex s (force_domain s) && no_name_twice (names_of_motions s 2) in
  let facts := point_facts s in
  let* yes := normal_condition names true (region c) in
  let* forces := normal_condition names true (at_forces c) in
  let at_one more modes := let* g := somewhere (yes :: more) modes in Some [[g]] in
  let of_one modes more := map_option (fun md => let* fs := motion_forms s 0 md in Some (All fs)) modes in
  match what c with
  | Interval md => let* no := normal_condition names false (at_forces c) in at_one [no] [md]
  | Impossible modes => let* any := of_one modes tt in
      let* here := point_forms s in
      Some [[Goal [] (names_of_motions s 1) (All (here ++ [yes; forces; Any any]))]]
  | Formula [] holds => let* no := normal_condition names false holds in at_one [forces; no] []
  | Formula modes holds =>
      let* any := of_one modes tt in
      let* here := point_forms s in
      let* no := normal_condition (motion_scope s (suffix s 0)) false holds in
      Some [[Goal [] (names_of_motions s 1) (All (here ++ [yes; forces; Any any; no]))]]
  | Equivalence holds =>
      let* no := normal_condition names false (at_forces c) in
      let* g := normal_condition names true holds in
      let* h := normal_condition names false holds in at_one [Any [All [forces; h]; All [g; no]]] []
  | Cover claims =>
      let* nos := map_option (fun r => normal_condition names false (fst r)) claims in at_one nos []
  | ForceCover claims =>
      let* nos := map_option (fun r => let* f := normal_condition names false (fst r) in
                                       let* g := normal_condition names false (snd r) in Some (Any [f; g])) claims in
      at_one (forces :: nos) []
  | Exists modes =>
      require Nat.leb (length modes) 8 && no_name_twice (names_of_motions s (length modes)) in
      let* motions := map_option (fun im => motion_forms s (fst im) (snd im)) (combine (seq 0 (length modes)) modes) in
      let* region_goal := has_value_goal facts (region c) in
      let* forces_goal := has_value_goal (yes :: facts) (at_forces c) in
      Some [[region_goal]; [forces_goal]; [Goal (concat motions ++ forces :: yes :: facts) [] (Any [])]]
  | Consequence model hs es => equations_refuted yes model hs es
  | System model given hs es => equations_refuted yes model (given ++ hs) es
  | Motions _ | Unique _ _ _ | Limit _ _ _ => None
  end.
End Claim.
