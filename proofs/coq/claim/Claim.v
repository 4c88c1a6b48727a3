(** What a paper says of a mechanism, and when a claim is right, wrong, or neither: MEANING.md. *)
From Coq Require Import String List Bool ZArith Reals.
From Slipproof Require Import Text Syntax.
From Slipproof.claim Require Import Expression Mechanism.
Import ListNotations.
Local Open Scope R_scope.

(** A setting: the paper's symbols, and the values that they give to those of the mechanism. An angle is two symbols
    with c^2 + s^2 = 1. [force] is the paper's variable for the mechanism's load; "" if there is none. *)
Record setting := Setting {
  of_mechanism : mechanism;
  paper_parameters : list (string * condition);
  paper_angles : list (string * string * condition);
  force : string;
  force_domain : condition;
  paper_definitions : list (string * term);
  scene : list (string * term);
  strict : bool
}.

Section Point.
Variable s : setting.
Notation m := (of_mechanism s).

Definition symbols : list string :=
  map fst (paper_parameters s) ++ flat_map (fun '(c, n, _) => [c; n]) (paper_angles s)
  ++ if String.eqb (force s) "" then [] else [force s].

Definition define (ds : list (string * term)) (names : meanings) : meanings :=
  fold_left (fun names d => with_name (fst d) (value names (snd d)) names) ds names.

(** The paper's names, where its symbols have the values [x]. *)
Definition paper (x : string -> R) : meanings :=
  define (paper_definitions s) (fun name => if existsb (String.eqb name) symbols then Some (x name) else None).

(** The mechanism's names: what the scene does not give counts as 0; [u] are the unknowns. *)
Definition given (name : string) : option term := option_map snd (find (fun v => String.eqb (fst v) name) (scene s)).
Definition from_scene (x : string -> R) (name : string) : option R :=
  match given name with Some e => value (paper x) e | None => Some 0 end.
Definition scene_symbols : list string :=
  map fst (parameters m) ++ flat_map (fun '(c, n, _) => [c; n]) (angles m)
  ++ match load m with Some l => [fst l] | None => [] end.
Definition in_scene (x u : string -> R) : meanings :=
  define (definitions m)
    (fun name => if existsb (String.eqb name) (unknowns m) then Some (u name)
                 else if existsb (String.eqb name) scene_symbols then from_scene x name else None).
Definition mechanism_names (x u : string -> R) : meanings :=
  fold_left (fun names q => with_name (fst q) (value (in_scene x u) (snd q)) names) (quantities m) (in_scene x u).

Definition square_sum (c n : string) : condition :=
  Compare (Plus (Power (Symbol c) 2) (Power (Symbol n) 2)) [(Eq, Number 1)].
Definition is_given (name : string) : bool := match given name with Some _ => true | None => false end.

(** All numbers in equations and elements: "every coefficient has a value". *)
Definition numbers : list term :=
  flat_map (fun '(_, x, y) => [x; y]) (equations m)
  ++ flat_map (fun c => [gap c] ++ match slip c with Some e => [e] | None => [] end
                        ++ match friction c with Some mu => [fst mu; snd mu] | None => [] end) (contacts m)
  ++ flat_map (fun r => [rub r; static_limit r; kinetic_limit r]) (rubbings m) ++ map zero (links m).

Definition with_force (x : string -> R) (f : R) : string -> R := fun name => if String.eqb name (force s) then f else x name.

(** "The force is the mechanism's load", "of degree 1 in the force variable". *)
Definition load_has_degree_one (x : string -> R) : Prop :=
  match load m with
  | None => True
  | Some (l, _) =>
      exists e a b, given l = Some e /\ a <> 0 /\ forall f, value (paper (with_force x f)) e = Some (a * f + b)
  end.

(** A point of the mechanism, whatever the force: what MEANING.md calls a bicycle. *)
Record bicycle (x : string -> R) : Prop := {
  domains : forall p c, In (p, c) (paper_parameters s) -> is (paper x) true c;
  paper_circles : forall c n d, In (c, n, d) (paper_angles s) -> is (paper x) true d /\ is (paper x) true (square_sum c n);
  scene_values : forall name, In name scene_symbols -> from_scene x name <> None;
  mechanism_domains : forall u p c, In (p, c) (parameters m) -> is_given p = true -> is (in_scene x u) true c;
  circles : forall u c n d, In (c, n, d) (angles m) -> is (in_scene x u) true d /\ is (in_scene x u) true (square_sum c n);
  assumed : forall u c, In c (assumptions m) -> is (in_scene x u) true c;
  coefficients : forall u e, In e numbers -> value (in_scene x u) e <> None;
  degree_one : load_has_degree_one x
}.

(** The same, and a force x. *)
Record point (x : string -> R) : Prop := {
  of_bicycle : bicycle x;
  load_in_domain : forall u l c, load m = Some (l, c) -> is (in_scene x u) true c;
  force_in_domain : is (paper x) true (force_domain s)
}.

(** "The domain must be one interval (or empty) and have a truth value at every x." *)
Definition forces_are_an_interval (x : string -> R) : Prop :=
  let at_force f := is (paper (with_force x f)) true (force_domain s) in
  (forall f, has_value (paper (with_force x f)) (force_domain s))
  /\ forall f g h, f <= g -> g <= h -> at_force f -> at_force h -> at_force g.

(** Motions *)

Definition given_parameters : list string := filter is_given (map fst (parameters m)).
Definition modelled (md : mode) : Prop := mode_conditions (strict s) given_parameters m md <> None.

Definition all_true (names : meanings) (cs : list condition) : Prop := Forall (is names true) cs.

(** [u] gives the accelerations and forces of a motion in the mode. *)
Definition motion (x : string -> R) (md : mode) (u : string -> R) : Prop :=
  exists cs, mode_conditions (strict s) given_parameters m md = Some cs
             /\ all_true (mechanism_names x u) (dynamics m) /\ all_true (mechanism_names x u) cs.

(** "Two motions are the same if all their accelerations, gaps and slips are the same, whatever their forces are." *)
Definition same_motion (x u w : string -> R) : Prop :=
  forall name, In name (accelerations m ++ map fst (quantities m)) -> mechanism_names x u name = mechanism_names x w name.
Definition motion_in (x : string -> R) (md : mode) (u : string -> R) : Prop :=
  exists w, motion x md w /\ same_motion x u w.

(** The names that [holds] may use: the paper's, and those of the motion. *)
Definition names_of_motion (x u : string -> R) : meanings :=
  fun name => if existsb (String.eqb name) (unknowns m ++ map fst (quantities m)) then mechanism_names x u name
              else paper x name.
End Point.

(** Linear equations *)

Fixpoint mentions (names : list string) (e : term) : bool :=
  match e with
  | Number _ => false
  | Symbol name => existsb (String.eqb name) names
  | Minus a | Power a _ | Absolute a | Signum a => mentions names a
  | Plus a b | Difference a b | Product a b | Quotient a b | Minimum a b | Maximum a b => mentions names a || mentions names b
  end.

Fixpoint mentions_in (names : list string) (c : condition) : bool :=
  match c with
  | Constant _ => false
  | Compare a links => mentions names a || existsb (fun l => mentions names (snd l)) links
  | Not c => mentions_in names c
  | Both c d | Either c d => mentions_in names c || mentions_in names d
  end.

(** "An equation is linear if, as it stands, it multiplies no two numbers in which unknowns or the force occur, divides by
    no such number, and applies no power (except 0 and 1) and no function to one." *)
Definition varying (s : setting) : list string :=
  fold_left (fun known d => if mentions known (snd d) then fst d :: known else known) (paper_definitions s)
    (force s :: unknowns (of_mechanism s) ++ map fst (quantities (of_mechanism s))).
Fixpoint linear (vs : list string) (e : term) : bool :=
  match e with
  | Number _ | Symbol _ | Power _ 0 => true
  | Minus a | Power a 1 => linear vs a
  | Plus a b | Difference a b => linear vs a && linear vs b
  | Product a b => negb (mentions vs a) && linear vs b || linear vs a && negb (mentions vs b)
  | Quotient a b => linear vs a && negb (mentions vs b)
  | Power a _ | Absolute a | Signum a => negb (mentions vs a)
  | Minimum a b | Maximum a b => negb (mentions vs a || mentions vs b)
  end.
Definition is_equation (c : condition) : bool :=
  match c with Compare _ links => forallb (fun l => match fst l with Eq => true | _ => false end) links | _ => false end.
Definition linear_equation (s : setting) (c : condition) : bool :=
  is_equation c
  && match c with Compare a links => linear (varying s) a && forallb (fun l => linear (varying s) (snd l)) links | _ => false end.

(** The equations of motion, with those of a mode, or with no contact open. *)
Definition model_equations (s : setting) (md : option mode) : option (list condition) :=
  let m := of_mechanism s in
  match md with
  | Some md => let* cs := mode_conditions (strict s) (given_parameters s) m md in Some (dynamics m ++ filter is_equation cs)
  | None =>
      let closed c := match begins c with Apart => false | _ => true end in
      Some (dynamics m ++ map (fun c => equal (Symbol (gap_name c)) nought) (filter closed (contacts m)))
  end.

(** Claims *)

(** Region and forces of a claim that another one names. *)
Definition reference := (condition * condition)%type.

(** "The closure of a condition on forces is the condition in which each [not] is carried inwards to the comparisons and then
    < is read as <=, > as >=, and x <> y as x <= y or x >= y." *)
Definition closed_link (a : term) (r : rel) (b : term) : condition :=
  match r with
  | Lt | Le => Compare a [(Le, b)]
  | Gt | Ge => Compare a [(Ge, b)]
  | Ne => Either (Compare a [(Le, b)]) (Compare a [(Ge, b)])
  | Eq => Compare a [(Eq, b)]
  end.
Fixpoint closed_links (truth : bool) (a : term) (links : list (rel * term)) : condition :=
  match links with
  | [] => Constant truth
  | (r, b) :: rest =>
      (if truth then Both else Either) (closed_link a (if truth then r else opposite r) b) (closed_links truth b rest)
  end.
Fixpoint closure (truth : bool) (c : condition) : condition :=
  match c with
  | Constant b => Constant (Bool.eqb b truth)
  | Compare a links => closed_links truth a links
  | Not c => closure (negb truth) c
  | Both c d => (if truth then Both else Either) (closure truth c) (closure truth d)
  | Either c d => (if truth then Either else Both) (closure truth c) (closure truth d)
  end.

(** "Here all motions count, boundary motions included, also in strict settings." *)
Definition with_boundaries (s : setting) : setting :=
  Setting (of_mechanism s) (paper_parameters s) (paper_angles s) (force s) (force_domain s) (paper_definitions s) (scene s) false.

Inductive kind :=
| Interval (md : mode)
| Impossible (modes : list mode)
| Formula (modes : list mode) (holds : condition)
| Motions (modes : list mode)
| Exists (modes : list mode)
| Equivalence (holds : condition)
| Cover (claims : list reference)
| ForceCover (claims : list reference)
(* Of the mechanism's equations, if [model]: in a mode, or with no contact open. *)
| Consequence (model : option (option mode)) (hypotheses equations : list condition)
(* Of [given] and others, which [equations] with [given] are to replace. *)
| System (model : option (option mode)) (given hypotheses equations : list condition)
(* Each of [claims] is an interval, of its mode. *)
| Unique (claims : list (mode * reference)) (except : list reference) (modes : list mode)
(* [from] does not change what is claimed: proofs use it. *)
| Limit (parameter : string) (holds : condition) (from : option term).

Record claim := Claim { in_setting : setting; what : kind; region : condition; at_forces : condition }.

Section Judged.
Variable c : claim.
Notation s := (in_setting c).
Variable x : string -> R.
Let names := paper s x.
Let true_here (d : condition) : Prop := is names true d.
Let false_here (d : condition) : Prop := is names false d.
Let undefined (d : condition) : Prop := ~ has_value names d.

(** "The unknowns and the force variable are any real numbers: the force is not restricted to its domain, and conditions of
    contacts do not count." *)
Definition solves (model : option (option mode)) (hypotheses : list condition) (f : R) (u : string -> R) : Prop :=
  let y := with_force s x f in
  (forall md, model = Some md -> exists cs, model_equations s md = Some cs /\ all_true (mechanism_names s y u) cs)
  /\ all_true (names_of_motion s y u) hypotheses.

(** "The unknowns of the right side of a system are those that occur in the text of [equations] or of a claim in [given]." *)
Definition chosen (equations : list condition) : list string :=
  filter (fun u => existsb (mentions_in [u]) equations) (unknowns (of_mechanism s)).
Definition satisfies (f : R) (u : string -> R) (equations : list condition) : Prop :=
  all_true (names_of_motion s (with_force s x f) u) equations.
(** "An equation is undefined or not linear." *)
Definition no_equations (model : option (option mode)) (equations : list condition) : Prop :=
  (exists md, model = Some md /\ model_equations s md = None)
  \/ exists e, In e equations
               /\ (linear_equation s e = false
                   \/ exists f u, ~ has_value (names_of_motion s (with_force s x f) u) e).

(** "A claim states x if its region and its [forces] are true; it is near x if its region and the closure of its [forces] are
    true." *)
Definition states (r : reference) : Prop := true_here (fst r) /\ true_here (snd r).
Definition near (r : reference) : Prop := true_here (fst r) /\ true_here (closure true (snd r)).
(** "Where a claim states x", its mode; "where x is near no claim", [modes]: in one of these is the motion. *)
Definition expected (claims : list (mode * reference)) (modes expected : list mode) : Prop :=
  (exists md r, In (md, r) claims /\ states r /\ expected = [md])
  \/ (forall md r, In (md, r) claims -> ~ near r) /\ expected = modes.
Definition any_motion (md : mode) (u : string -> R) : Prop := motion (with_boundaries s) x md u.
Definition in_one_of (modes : list mode) (u : string -> R) : Prop :=
  exists md, In md modes /\ motion_in (with_boundaries s) x md u.
(** "Every motion is in one of these modes (and perhaps in others), and there is exactly one." *)
Definition one_motion_in (modes : list mode) : Prop :=
  (exists md u, any_motion md u)
  /\ (forall md u, any_motion md u -> in_one_of modes u)
  /\ forall md u other w, any_motion md u -> any_motion other w -> same_motion s x u w.
(** It "says nothing if x is near a claim of [except]", and "where x is near a claim and no claim states x". *)
Definition excepted (except : list reference) : Prop := exists r, In r except /\ near r.
Definition at_an_end (claims : list (mode * reference)) : Prop :=
  (exists md r, In (md, r) claims /\ near r) /\ forall md r, In (md, r) claims -> ~ states r.
(** It "has no value at a bicycle if the region of a claim that it names is undefined there, or if (in the region of that
    claim) its [forces] are undefined at some x". *)
Definition unvalued (r : reference) : Prop :=
  undefined (fst r)
  \/ exists f, let y := with_force s x f in point s y /\ is (paper s y) true (fst r) /\ ~ has_value (paper s y) (snd r).

(** "All parameters but one are fixed; the bicycles are those with these values of the others." What occurs for every v < s,
    the least upper bound of the parameter at these bicycles: beyond each v beyond which there is one of them. *)
Definition with_parameter (name : string) (p : R) : string -> R := fun other => if String.eqb other name then p else x other.
Definition at_the_end (parameter : string) (occurs : meanings -> Prop) : Prop :=
  let beyond v what := exists p, let y := with_parameter parameter p in v < p /\ bicycle s y /\ what (paper s y) in
  forall v, beyond v (fun _ => True) -> beyond v occurs.
(** A bicycle there "counts as says nothing if the region is false, as no value if the region is undefined, or is true and
    [holds] undefined, and otherwise as right or wrong as [holds] is true or false". *)
Definition mostly_nothing (parameter : string) : Prop := at_the_end parameter (fun n => is n false (region c)).
Definition mostly_no_value (parameter : string) (holds : condition) : Prop :=
  at_the_end parameter (fun n => ~ has_value n (region c) \/ is n true (region c) /\ ~ has_value n holds).
Definition mostly (truth : bool) (parameter : string) (holds : condition) : Prop :=
  at_the_end parameter (fun n => is n true (region c) /\ is n truth holds).

(** The table of MEANING.md, column by column; a region that is true, one force. Of a limit: "the first of wrong, no value,
    right, says nothing that occurs". *)
Definition right_here : Prop :=
  match what c with
  | Interval md => true_here (at_forces c) <-> exists u, motion s x md u
  | Impossible modes => forall md u, In md modes -> ~ motion s x md u
  | Formula [] holds => true_here holds
  | Formula modes holds => forall md u, In md modes -> motion s x md u -> is (names_of_motion s x u) true holds
  | Motions modes =>
      (forall md, In md modes ->
         (exists u, motion s x md u) /\ forall u w, motion s x md u -> motion s x md w -> same_motion s x u w)
      /\ forall md u, motion s x md u -> exists listed, In listed modes /\ motion_in s x listed u
  | Exists modes => true_here (at_forces c) /\ forall md, In md modes -> exists u, motion s x md u
  | Equivalence holds => true_here (at_forces c) <-> true_here holds
  | Cover claims => exists r f, In (r, f) claims /\ true_here r
  | ForceCover claims => exists r f, In (r, f) claims /\ true_here r /\ true_here f
  | Consequence model hs es => forall f u, solves model hs f u -> satisfies f u es
  | System model given hs es =>
      forall f u, (exists w, (forall name, In name (chosen (given ++ es)) -> w name = u name) /\ solves model (given ++ hs) f w)
                  <-> satisfies f u (given ++ es)
  | Unique claims _ modes => forall ms, expected claims modes ms -> one_motion_in ms
  | Limit p holds _ => ~ mostly false p holds /\ mostly true p holds
  end.

Definition nothing_here : Prop :=
  match what c with
  | Interval _ | Equivalence _ | Cover _ => False
  | Impossible _ | Motions _ | ForceCover _ | Formula [] _ => false_here (at_forces c)
  | Formula modes _ =>
      false_here (at_forces c)
      \/ (forall md, In md modes -> modelled s md) /\ forall md u, In md modes -> ~ motion s x md u
  | Exists _ => ~ right_here
  | Consequence model hs _ => forall f u, ~ solves model hs f u
  | System model given hs es => forall f u, ~ solves model (given ++ hs) f u /\ ~ satisfies f u (given ++ es)
  | Unique claims except _ => false_here (at_forces c) \/ excepted except \/ at_an_end claims
  | Limit p holds _ => ~ mostly false p holds /\ ~ mostly true p holds /\ mostly_nothing p
  end.

(** Something shows that the claim is wrong, whatever else has no value. *)
Definition wrong_anyway : Prop :=
  match what c with
  | Impossible modes => true_here (at_forces c) /\ exists md u, In md modes /\ motion s x md u
  | Formula ((_ :: _) as modes) holds =>
      true_here (at_forces c) /\ exists md u, In md modes /\ motion s x md u /\ is (names_of_motion s x u) false holds
  | Motions modes =>
      true_here (at_forces c)
      /\ ((exists md u w, In md modes /\ motion s x md u /\ motion s x md w /\ ~ same_motion s x u w)
          \/ (exists md u, motion s x md u /\ (forall listed, In listed modes -> modelled s listed)
                           /\ forall listed, In listed modes -> ~ motion_in s x listed u)
          \/ exists md, In md modes /\ modelled s md /\ forall u, ~ motion s x md u)
  (* "If there is one motion too many on the road, or none where all modes in question are modelled." *)
  | Unique claims except modes =>
      true_here (at_forces c) /\ ~ nothing_here
      /\ exists ms, expected claims modes ms
           /\ ((exists md u other w, any_motion md u /\ any_motion other w /\ ~ same_motion s x u w)
               \/ (forall md, In md ms -> modelled s md)
                  /\ ((forall md u, ~ any_motion md u) \/ exists md u, any_motion md u /\ ~ in_one_of ms u))
  | _ => False
  end.

(** Every state of every element is modelled. *)
Definition all_modelled : Prop := forall k, In k (contacts (of_mechanism s)) -> bilateral k = false ->
  may_lift (given_parameters s) k = true.

Definition no_value_here : Prop :=
  match what c with
  | Interval md => undefined (at_forces c) \/ ~ modelled s md
  | Impossible modes =>
      undefined (at_forces c) \/ true_here (at_forces c) /\ ~ wrong_anyway /\ exists md, In md modes /\ ~ modelled s md
  | Formula [] holds => undefined (at_forces c) \/ true_here (at_forces c) /\ undefined holds
  | Formula modes holds =>
      undefined (at_forces c)
      \/ true_here (at_forces c) /\ ~ wrong_anyway
         /\ ((exists md, In md modes /\ ~ modelled s md)
             \/ exists md u, In md modes /\ motion s x md u /\ ~ has_value (names_of_motion s x u) holds)
  | Motions modes =>
      undefined (at_forces c)
      \/ true_here (at_forces c) /\ ~ wrong_anyway /\ ((exists md, In md modes /\ ~ modelled s md) \/ ~ all_modelled)
  | Exists modes => ~ right_here /\ (undefined (at_forces c) \/ exists md, In md modes /\ ~ modelled s md)
  | Equivalence holds => undefined (at_forces c) \/ undefined holds
  | Cover claims => ~ right_here /\ exists r f, In (r, f) claims /\ undefined r
  | ForceCover claims =>
      undefined (at_forces c)
      \/ true_here (at_forces c) /\ ~ right_here
         /\ exists r f, In (r, f) claims /\ (undefined r /\ ~ false_here f \/ true_here r /\ undefined f)
  | Consequence model hs es => no_equations model (hs ++ es)
  | System model given hs es => no_equations model (given ++ hs ++ es)
  | Unique claims except _ =>
      (exists r, In r (map snd claims ++ except) /\ unvalued r)
      \/ ~ excepted except /\ undefined (at_forces c)
      \/ true_here (at_forces c) /\ ~ nothing_here /\ ~ wrong_anyway /\ ~ all_modelled
  | Limit p holds _ => ~ mostly false p holds /\ mostly_no_value p holds
  end.

Inductive outcome := Right | Wrong | SaysNothing | NoValue.

(** Two columns may be true at once: a formula about motions of which there are none is right, too.
    "If its region is false, it says nothing; if its region is undefined, it has no value. (For a limit see above.)
    Otherwise it is judged." *)
Definition judged_where : condition := match what c with Limit _ _ _ => Constant true | _ => region c end.
Definition judged (o : outcome) : Prop :=
  match o with
  | NoValue => undefined judged_where \/ ~ forces_are_an_interval s x \/ true_here judged_where /\ no_value_here
  | SaysNothing =>
      forces_are_an_interval s x
      /\ (false_here judged_where \/ true_here judged_where /\ ~ no_value_here /\ nothing_here)
  | Right => forces_are_an_interval s x /\ true_here judged_where /\ ~ no_value_here /\ right_here
  | Wrong => forces_are_an_interval s x /\ true_here judged_where /\ ~ no_value_here /\ ~ right_here /\ ~ nothing_here
  end.
End Judged.

(** What a bicycle decides, whether or not a force is in its domain. "Where it is not one interval, no claim of the setting has a
    value"; nor where its region is undefined; nor, in its region, an interval whose mode is not modelled, and a [Unique] of
    which a claim that it names has an undefined region. *)
Definition valued_at (c : claim) (x : string -> R) : Prop :=
  let names := paper (in_setting c) x in
  forces_are_an_interval (in_setting c) x /\ has_value names (region c)
  /\ (is names true (region c) ->
      match what c with
      | Interval md => modelled (in_setting c) md
      | Unique claims except _ => forall r, In r (map snd claims ++ except) -> has_value names (fst r)
      | _ => True
      end).

(** At every bicycle the claim has a value, and at every point and force it is right, or says nothing. A cover, a limit, or one
    about equations is right or says nothing at every bicycle, even if there is no force. It is wrong at one. [Exists] is
    right at one, or nowhere. *)
Definition of_any_force (k : kind) : bool := match k with Cover _ | Consequence _ _ _ | System _ _ _ _ | Limit _ _ _ => true | _ => false end.
Definition place (c : claim) (x : string -> R) : Prop :=
  if of_any_force (what c) then bicycle (in_setting c) x else point (in_setting c) x.
Definition right_or_nothing (c : claim) : Prop := forall x, place c x -> judged c x Right \/ judged c x SaysNothing.
Definition proved (c : claim) : Prop :=
  match what c with
  | Exists _ => exists x, place c x /\ judged c x Right
  | _ => (of_any_force (what c) = false -> forall x, bicycle (in_setting c) x -> valued_at c x) /\ right_or_nothing c
  end.
Definition refuted (c : claim) : Prop :=
  match what c with
  | Exists _ => forall x, place c x -> judged c x SaysNothing
  | _ => exists x, place c x /\ judged c x Wrong
  end.
