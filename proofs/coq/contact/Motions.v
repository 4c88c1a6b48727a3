(** The checker of `all-solutions`: motions that exist, and a tree of cases that has no others (FORMAT.md). *)
From Coq Require Import NArith ZArith List Bool FMapPositive.
From Slipproof.contact Require Import Coulomb Number Linear Zero Certificate Checker.
Import ListNotations.
Local Open Scope N_scope.

(** u = W r + q, by the inverse of the rows and columns of the free unknowns. *)
Section Eliminate.
  Variables (p : tables) (b : PositiveMap.t linear).

  (** Rows of B A and B c *)
  Definition solved_row (j : N) : table :=
    List.fold_left (fun m e => accumulate m (snd e) (look [] (t_rows p) (fst e))) (look [] b j) empty.
  Definition solved_constant (j : N) : number := sum_of (look [] b j) (t_constants p).

  Definition listed_row (columns : list N) (m : table) : linear :=
    filter (fun e => negb (is_zero (snd e))) (map (fun j => (j, get m j)) columns).

  Variables (forces : list N) (solved : PositiveMap.t linear) (solved_constants : table).

  Definition reduced_row (j : N) : linear :=
    listed_row forces (List.fold_left
      (fun m e => if N.ltb (fst e) (t_frees p) then accumulate m (opp (snd e)) (look [] solved (fst e)) else accumulate m one [e])
      (look [] (t_rows p) j) empty).
  Definition reduced_constant (j : N) : number :=
    List.fold_left
      (fun s e => if N.ltb (fst e) (t_frees p) then sub s (mul (snd e) (get solved_constants (fst e))) else s)
      (look [] (t_rows p) j) (get (t_constants p) j).
End Eliminate.

Definition reduced (i : instance) (inverse : list (N * N * number)) : instance :=
  let p := tables_of i in let b := by_rows inverse in
  let free_rows := range 0 (N.to_nat (frees i)) in
  let forces := range (frees i) (N.to_nat (size_of_instance i - frees i)) in
  let solved := tabulate 0 (map (fun j => listed_row forces (solved_row p b j)) free_rows) (PositiveMap.empty linear) in
  let solved_constants := tabulate 0 (map (solved_constant p b) free_rows) empty in
  Instance (dim i) 0 (frictions i)
    (flat_map (fun j => map (fun e => (j - frees i, fst e - frees i, snd e)) (reduced_row p forces solved j)) forces)
    (map (reduced_constant p solved_constants) forces) None.

(** B A is the identity in the free columns. *)
Definition is_inverse (i : instance) (inverse : list (N * N * number)) : bool :=
  let p := tables_of i in let b := by_rows inverse in let free_rows := range 0 (N.to_nat (frees i)) in
  forallb (fun e => match e with (_, k, _) => N.ltb k (frees i) end) inverse
  && forallb (fun j => let m := solved_row p b j in
       forallb (fun k => eq (get m k) (if N.eqb j k then one else zero)) free_rows) free_rows.

(** States *)

Definition direction := (number * number)%type.
Definition dot (a b : direction) : number := add (mul (fst a) (fst b)) (mul (snd a) (snd b)).
Definition cross (a b : direction) : number := sub (mul (fst a) (snd b)) (mul (snd a) (fst b)).
Definition opposite_direction (a : direction) : direction := (opp (fst a), opp (snd a)).
Definition nowhere : direction := (zero, zero).
Definition ahead : direction := (one, zero).

Definition same_direction (a b : direction) : bool := eq (fst a) (fst b) && eq (snd a) (snd b).

Inductive state := AnyState | OpenState | ClosedState | StickState | SlipState (a b : direction).

Definition pattern := PositiveMap.t state.
Definition state_of (s : pattern) (k : N) : state := look AnyState s k.

Definition is_arc (a b : direction) : bool := eq (dot a a) one && eq (dot b b) one && positive_number (cross a b).

(** From each direction to the next. *)
Fixpoint arcs (a : direction) (l : list direction) : list (direction * direction) :=
  match l with [] => [] | b :: r => (a, b) :: arcs b r end.

Definition arcs_around (l : list direction) : list (direction * direction) :=
  match l with [] => [] | a :: r => arcs a (r ++ [a]) end.
Definition arcs_within (s : state) (l : list direction) : list (direction * direction) :=
  match s with SlipState a b => arcs a (l ++ [b]) | _ => arcs nowhere (l ++ [nowhere]) end.

Definition slips_in (l : list (direction * direction)) : list state := map (fun a => SlipState (fst a) (snd a)) l.

(** The cases of a node, for its contact. *)
Definition cases (d : N) (n : node) (s : state) : list state :=
  match n with
  | Decide _ => [OpenState; ClosedState]
  | Slips _ l =>
      StickState :: (if N.ltb d 3 then [SlipState ahead ahead; SlipState (opposite_direction ahead) (opposite_direction ahead)]
                     else slips_in (arcs_around l))
  | Arcs _ l => slips_in (arcs_within s l)
  | Empty _ | Known _ _ | Frictionless _ _ => []
  end.

Definition of_node (n : node) : N :=
  match n with Decide k | Slips k _ | Arcs k _ => k | Empty _ | Known _ _ | Frictionless _ _ => 0 end.

Definition children (d : N) (n : node) (s : pattern) : list pattern :=
  let k := of_node n in map (fun t => PositiveMap.add (key k) t s) (cases d n (state_of s k)).

Definition are_arcs (l : list (direction * direction)) : bool :=
  negb (match l with [] => true | _ => false end) && forallb (fun a => is_arc (fst a) (snd a)) l.

(** That the cases are all. *)
Definition covers (p : tables) (n : node) (s : state) : bool :=
  N.ltb (of_node n) (N.of_nat (List.length (t_mus p))) &&
  match n, s with
  | Decide _, AnyState => true
  | Slips k l, ClosedState =>
      negb (is_zero (nth (N.to_nat k) (t_mus p) zero)) && N.ltb 1 (t_dim p) && (N.ltb (t_dim p) 3 || are_arcs (arcs_around l))
  | Arcs _ l, SlipState _ _ => N.eqb (t_dim p) 3 && are_arcs (arcs_within s l)
  | _, _ => false
  end.

(** What multipliers prove *)

(** f . u + h . r >= least *)
Record bound := Bound { of_velocities : linear; of_forces : linear; at_least : number }.

Definition over_cone (m gn : number) (g : direction) : bool :=
  nonnegative gn && le (mul (square m) (dot g g)) (square gn).
Definition points_into (a b g : direction) : bool := positive_number (cross a g) && positive_number (cross g b).

(** v . u >= 0 for all velocities of a state, v . u > 0; then g . r >= 0 for all forces. *)
Definition fine_velocities (s : state) (vn : number) (v : direction) : bool :=
  match s with
  | AnyState | OpenState => nonnegative vn && is_zero (fst v) && is_zero (snd v)
  | ClosedState => is_zero (fst v) && is_zero (snd v)
  | StickState => true
  | SlipState a b => nonnegative (dot v a) && nonnegative (dot v b)
  end.
Definition more_velocities (s : state) (vn : number) (v : direction) : bool :=
  match s with
  | OpenState => positive_number vn
  | SlipState a b => positive_number (dot v a) && positive_number (dot v b)
  | _ => false
  end.

Definition fine_forces (s : state) (m gn : number) (g : direction) : bool :=
  match s with
  | OpenState => true
  | SlipState a b =>
      if points_into a b g then over_cone m gn g else le (mul m (dot g a)) gn && le (mul m (dot g b)) gn
  | _ => over_cone m gn g
  end.

Section Prove.
  Variables (p : tables) (s : pattern).
  Let d := t_dim p.
  Let rows := range 0 (N.to_nat (t_size p)).

  Definition tangent (m : table) (c : contact) : direction :=
    (if N.ltb 1 d then get m (first c + 1) else zero, if N.ltb 2 d then get m (first c + 2) else zero).

  Definition all_contacts : list contact := contacts_of p (map (fun _ => Open) (t_mus p)).
  Definition of_contact_state (c : contact) : state := state_of s (slip c - t_size p).

  Definition v_of (b : bound) (y : list number) : table := accumulate (table_of (map opp y)) one (of_velocities b).
  Definition g_of (b : bound) (y : list number) : table :=
    let multipliers := table_of y in
    List.fold_left (fun m j => let r := get multipliers j in if is_zero r then m else accumulate m r (linear_part (row p j)))
      rows (accumulate empty one (of_forces b)).
  Definition work (y : list number) : number :=
    let multipliers := table_of y in
    total (map (fun j => mul (get multipliers j) (get (t_constants p) j)) rows).

  Definition fine (v g : table) (c : contact) : bool :=
    fine_velocities (of_contact_state c) (get v (first c)) (tangent v c)
    && fine_forces (of_contact_state c) (mu c) (get g (first c)) (tangent g c).
  Definition more (v : table) (c : contact) : bool :=
    more_velocities (of_contact_state c) (get v (first c)) (tangent v c).

  Definition proved (b : bound) (y : list number) : bool :=
    let v := v_of b y in let g := g_of b y in
    N.eqb (N.of_nat (List.length y)) (t_size p) && forallb (fine v g) all_contacts && le (at_least b) (work y).

  Definition excluded (y : list number) : bool :=
    let v := v_of (Bound [] [] zero) y in let g := g_of (Bound [] [] zero) y in
    N.eqb (N.of_nat (List.length y)) (t_size p) && forallb (fine v g) all_contacts
    && (positive_number (work y) || (nonnegative (work y) && existsb (more v) all_contacts)).

  Fixpoint all_proved (bounds : list bound) (ys : list (list number)) : bool :=
    match bounds, ys with
    | [], [] => true
    | b :: bounds, y :: ys => proved b y && all_proved bounds ys
    | _, _ => false
    end.
End Prove.

(** Motions in the list *)

Definition box_of_motion (p : tables) (m : listed) : box :=
  match m with
  | Exact r _ => Box (table_of r) empty
  | Boxed modes center radius pinned _ _ _ => box_of p modes center radius pinned
  end.
Definition modes_of (p : tables) (m : listed) : list mode :=
  match m with Exact _ _ => map (fun _ => Open) (t_mus p) | Boxed modes _ _ _ _ _ _ => modes end.

(** |I - R J| p + 4 L |R| q < p *)
Definition is_alone (z p : table) (left : list N) (kept : list equation) (inverse : PositiveMap.t linear) (l : number) : bool :=
  let known := look flat (tabulate 0 (map (expand z p) kept) (PositiveMap.empty expansion)) in
  let close_of := tabulate 0 (map (close_bend p) kept) empty in
  let closely b := Expansion zero [] (get close_of b) in
  le one l
  && forallb (fun e => match e with (j, r) =>
       lt (add (spread_row known left p j r) (mul (mul (Number 4 0 1) l) (bend_row closely r))) (abs (get p j)) end)
     (name_rows 0 left inverse).

Definition are_distances (p : tables) (e : list number) : bool :=
  N.eqb (N.of_nat (List.length e)) (t_size p) && forallb nonnegative e.

Definition check_motion (i : instance) (p : tables) (m : listed) : bool :=
  match m with
  | Exact r within =>
      let b := box_of_motion p m in
      forallb (fun c => obeys (t_dim p) (mu c) (fun t => get (center_of b) (first c + t)) (fun t => middle b (row p (first c + t))))
        (all_contacts p)
      && N.eqb (N.of_nat (List.length r)) (t_size p)
      && match within with None => true | Some e => are_distances p e end
  | Boxed modes center radius pinned dropped inverse near =>
      let b := box_of_motion p m in
      let forces l := table_of (by_forces (N.to_nat (dim i)) (frictions i) modes l) in
      let centers := forces center in let radii := forces (pin 0 pinned radius) in
      let left := unknowns_left p modes pinned in
      let kept := equations_kept p modes dropped in
      check_box p modes center radius pinned dropped (fun z r left kept => has_zero z r left kept (by_rows inverse))
      && forallb (fun j => eq (get (center_of b) j) (get centers j) && eq (abs (get (radius_of b) j)) (get radii j))
           (range 0 (N.to_nat (t_size p)))
      && match near with
         | Bare => true
         | Alone l =>
             match pinned with [] => true | _ => false end
             && is_alone (center_of b) (radius_of b) left kept (by_rows inverse) l
         | Within e => are_distances p e
         end
  end.

(** Known cases *)

Definition rests (s : state) (t : N) : bool :=
  match s with
  | StickState => true
  | ClosedState | SlipState _ _ => N.eqb t 0
  | AnyState | OpenState => false
  end.

Section Known.
  Variables (p : tables) (s : pattern) (b : box).
  Let state_at := of_contact_state p s.

  Definition velocity_bounds (e : table) (c : contact) : list bound :=
    flat_map (fun t => let j := first c + t in
      if rests (state_at c) t then [] else
      [Bound [(j, one)] [] (sub (least b (row p j)) (get e j));
       Bound [(j, opp one)] [] (opp (add (greatest b (row p j)) (get e j)))]) (range 0 (N.to_nat (t_dim p))).

  Definition zero_in_range (e : table) (c : contact) : bool :=
    forallb (fun t => let j := first c + t in
      negb (rests (state_at c) t)
      || (nonnegative (opp (sub (least b (row p j)) (get e j))) && nonnegative (add (greatest b (row p j)) (get e j))))
      (range 0 (N.to_nat (t_dim p))).

  (** The forces that are unknowns. *)
  Definition forces_of (c : contact) : list N := filter (fun j => N.ltb j (t_size p)) (unknowns_of (t_dim p) c).

  (** Between r_T = -s u_T and the arc from a to b: with m = a + b and c = 1 + a . b, c <= d . m <= 1 + c / 2. *)
  Definition slip_bounds (l : number) (c : contact) (a b_ : direction) : list bound :=
    let m1 := add (fst a) (fst b_) in let m2 := add (snd a) (snd b_) in let c1 := add one (dot a b_) in
    let z := get (center_of b) (slip c) in let r := mul l (abs (get (radius_of b) (slip c))) in
    let n := first c in
    [Bound [(n + 1, opp m1); (n + 2, opp m2)] [(n, mul (mul (add z r) (mu c)) c1)] zero;
     Bound [(n + 1, m1); (n + 2, m2)] [(n, opp (mul (mul (sub z r) (mu c)) (add one (mul (Number 1 1 1) c1))))] zero].

  Definition force_bounds (l : number) (c : contact) : list bound :=
    flat_map (fun j =>
      let z := get (center_of b) j in let r := mul l (abs (get (radius_of b) j)) in
      [Bound [] [(j, one)] (sub z r); Bound [] [(j, opp one)] (opp (add z r))]) (forces_of c)
    ++ match its_mode c, state_at c with
       | Slide, SlipState a b_ => slip_bounds l c a b_
       | Slide, _ => slip_bounds l c nowhere nowhere
       | _, _ => []
       end.

  Definition fits (c : contact) : bool :=
    match its_mode c, state_at c with
    | Open, OpenState => true
    | Stick, StickState => has_friction (t_dim p) c
    | Stick, ClosedState => negb (has_friction (t_dim p) c)
    | Slide, SlipState _ _ => has_friction (t_dim p) c && N.eqb (t_dim p) 3
    | SlidePlus, SlipState a b_ => has_friction (t_dim p) c && N.eqb (t_dim p) 2 && same_direction a ahead && same_direction b_ ahead
    | SlideMinus, SlipState a b_ =>
        has_friction (t_dim p) c && N.eqb (t_dim p) 2
        && same_direction a (opposite_direction ahead) && same_direction b_ (opposite_direction ahead)
    | _, _ => false
    end.
End Known.

(** Distances that are left out are 0. *)
Inductive vicinity := OnlyThis (l : number) | UpTo (e : list number).
Definition vicinity_of (m : listed) : vicinity :=
  match m with
  | Exact _ None | Boxed _ _ _ _ _ _ Bare => UpTo []
  | Exact _ (Some e) | Boxed _ _ _ _ _ _ (Within e) => UpTo e
  | Boxed _ _ _ _ _ _ (Alone l) => OnlyThis l
  end.

Definition bounds_of (p : tables) (s : pattern) (m : listed) : list bound :=
  let b := box_of_motion p m in
  match vicinity_of m with
  | UpTo e => flat_map (velocity_bounds p s b (table_of e)) (all_contacts p)
  | OnlyThis l => flat_map (force_bounds p s b l) (contacts_of p (modes_of p m))
  end.

Definition check_known (p : tables) (s : pattern) (m : listed) (ys : list (list number)) : bool :=
  all_proved p s (bounds_of p s m) ys &&
  match vicinity_of m with
  | UpTo e => forallb (zero_in_range p s (box_of_motion p m) (table_of e)) (all_contacts p)
  | OnlyThis _ => forallb (fits p s) (contacts_of p (modes_of p m))
  end.

(** A motion that needs no friction, where W is a sum of squares d l l^T *)
Section Frictionless.
  Variable p : tables.
  Let rows := range 0 (N.to_nat (t_size p)).

  (** No tangential force; and no tangential velocity where there is friction. *)
  Definition needs_no_friction (l : list number) : bool :=
    let b := Box (table_of l) empty in
    forallb (fun c => forallb (fun t => let j := first c + t in
        is_zero (get (center_of b) j) && (negb (has_friction (t_dim p) c) || is_zero (middle b (row p j))))
      (range 1 (N.to_nat (t_dim p - 1)))) (all_contacts p).

  (** d, and l as a linear function and as a table *)
  Definition square_tables (s : number * list number) : number * linear * table :=
    let l := filter (fun e => negb (is_zero (snd e))) (combine (range 0 (List.length (snd s))) (snd s)) in
    (fst s, l, accumulate empty one l).

  (** Row j of W, less those of the squares *)
  Definition rest_of_row (squares : list (number * linear * table)) (j : N) : table :=
    List.fold_left (fun m s => match s with (d, l, t) =>
        let x := get t j in if is_zero x then m else accumulate m (opp (mul d x)) l end)
      squares (accumulate empty one (linear_part (row p j))).

  Definition is_sum_of (squares : list (number * list number)) : bool :=
    let s := map square_tables squares in
    forallb (fun s => nonnegative (fst s) && N.eqb (N.of_nat (List.length (snd s))) (t_size p)) squares
    && forallb (fun j => let m := rest_of_row s j in forallb (fun k => is_zero (get m k)) rows) rows.

  Definition check_frictionless (m : listed) (squares : list (number * list number)) : bool :=
    match m with
    | Exact r _ => needs_no_friction r && is_sum_of squares
    | Boxed _ _ _ _ _ _ _ => false
    end.
End Frictionless.

(** A tree, depth first, and the patterns that it still has to cover. *)
Fixpoint check_tree (p : tables) (motions : list listed) (tree : list node) (patterns : list pattern) : bool :=
  match tree, patterns with
  | [], [] => true
  | n :: tree, s :: rest =>
      if match n with
         | Empty y => excluded p s y
         | Known i ys => match nth_error motions (N.to_nat i) with Some m => check_known p s m ys | None => false end
         | Frictionless i l => match nth_error motions (N.to_nat i) with Some m => check_frictionless p m l | None => false end
         | _ => covers p n (state_of s (of_node n))
         end
      then check_tree p motions tree (children (t_dim p) n s ++ rest) else false
  | _, _ => false
  end.

Definition without_free (i : instance) (eliminated : option (list (N * N * number))) : instance :=
  reduced i (match eliminated with Some b => b | None => [] end).

Definition check_all_solutions (i : instance) (eliminated : option (list (N * N * number))) (motions : list listed)
    (tree : list node) : bool :=
  let r := without_free i eliminated in let p := tables_of r in
  is_inverse i (match eliminated with Some b => b | None => [] end) && is_whole r
  && forallb (check_motion r p) motions
  && check_tree p motions tree [PositiveMap.empty state].
