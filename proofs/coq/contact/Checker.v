(** The checker: for each claim a function that computes (FORMAT.md, "Claims", "To check"). *)
From Coq Require Import NArith ZArith List Bool String FMapPositive.
From Slipproof.contact Require Import Coulomb Number Linear Zero Certificate.
Import ListNotations.
Local Open Scope N_scope.

Fixpoint range (i : N) (count : nat) : list N := match count with O => [] | S n => i :: range (N.succ i) n end.

Definition total (l : list number) : number := List.fold_left add l zero.
Definition square (x : number) : number := mul x x.

(** A problem with its numbers in tables. *)
Record tables := Tables {
  t_dim : N;
  t_frees : N;
  t_size : N;
  t_mus : list number;
  t_rows : PositiveMap.t linear;
  t_constants : table
}.

Definition by_rows (l : list (N * N * number)) : PositiveMap.t linear :=
  List.fold_left (fun m e => match e with (i, j, a) => PositiveMap.add (key i) ((j, a) :: look [] m i) m end) l
    (PositiveMap.empty linear).

Definition size_of_instance (i : instance) : N := frees i + dim i * N.of_nat (List.length (frictions i)).

Definition table_of (l : list number) : table := tabulate 0 l empty.

Definition tables_of (i : instance) : tables :=
  Tables (dim i) (frees i) (size_of_instance i) (frictions i) (by_rows (entries i)) (table_of (constants i)).

(** w_i *)
Definition row (p : tables) (i : N) : equation := Equation (get (t_constants p) i) (look [] (t_rows p) i) [].

(** What the text says, and the numbers of a problem. *)
Definition is_whole (i : instance) : bool :=
  let n := size_of_instance i in
  N.eqb (N.of_nat (List.length (constants i))) n
  && match answer i with Some x => N.eqb (N.of_nat (List.length x)) n | None => true end
  && forallb (fun e => match e with (k, m, _) => N.ltb k n && N.ltb m n end) (entries i)
  && distinct (map (fun e => match e with (k, m, _) => k * n + m end) (entries i)) (PositiveMap.empty unit).

Definition is_proper (i : instance) : bool :=
  N.leb 1 (dim i) && N.leb (dim i) 3
  && forallb (fun m => nonnegative m && (N.ltb 1 (dim i) || is_zero m)) (frictions i).

(** A contact: its first component, the index of its slip, friction, mode. *)
Record contact := Contact { first : N; slip : N; mu : number; its_mode : mode }.

Fixpoint layout (d at_ slip_ : N) (mus : list number) (modes : list mode) : list contact :=
  match mus, modes with
  | m :: mus, s :: modes => Contact at_ slip_ m s :: layout d (at_ + d) (N.succ slip_) mus modes
  | _, _ => []
  end.

Definition contacts_of (p : tables) (modes : list mode) : list contact :=
  layout (t_dim p) (t_frees p) (t_size p) (t_mus p) modes.

Definition has_friction (d : N) (c : contact) : bool := N.ltb 1 d && negb (is_zero (mu c)).

Definition unknowns_of (d : N) (c : contact) : list N :=
  match its_mode c with
  | Open => []
  | Touch => [first c]
  | m => (if has_friction d c then range (first c) (N.to_nat d) else [first c])
         ++ match m with Slide => [slip c] | _ => [] end
  end.

Definition unknowns (p : tables) (modes : list mode) : list N :=
  range 0 (N.to_nat (t_frees p)) ++ flat_map (unknowns_of (t_dim p)) (contacts_of p modes).

(** u_T + s r_T *)
Definition sliding (p : tables) (c : contact) (t : N) : equation :=
  let w := row p (first c + t) in Equation (constant_part w) (linear_part w) [(one, slip c, first c + t)].

Definition cone (c : contact) : equation :=
  let n := first c in Equation zero [] [(one, n + 1, n + 1); (one, n + 2, n + 2); (opp (square (mu c)), n, n)].

Definition edge (c : contact) (m : number) : equation := Equation zero [(first c + 1, one); (first c, m)] [].

Definition equations_of (p : tables) (c : contact) : list equation :=
  match its_mode c with
  | Open => []
  | Touch => [row p (first c)]
  | Stick => row p (first c) ::
             (if has_friction (t_dim p) c then map (row p) (range (first c + 1) (N.to_nat (t_dim p - 1))) else [])
  | Slide => [row p (first c); sliding p c 1; sliding p c 2; cone c]
  | SlidePlus => [row p (first c); edge c (mu c)]
  | SlideMinus => [row p (first c); edge c (opp (mu c))]
  end.

Definition equations (p : tables) (modes : list mode) : list equation :=
  map (row p) (range 0 (N.to_nat (t_frees p))) ++ flat_map (equations_of p) (contacts_of p modes).

(** A box: its center and radii; both are 0 where they are not told. *)
Record box := Box { center_of : table; radius_of : table }.

(** The component is 0 everywhere in the box. *)
Definition vanishes (b : box) (i : N) : bool := is_zero (get (center_of b) i) && is_zero (get (radius_of b) i).

(** The least and the greatest value of a linear function. *)
Definition spread (b : box) (e : equation) : number := size_of (linear_part e) (radius_of b).
Definition middle (b : box) (e : equation) : number := add (constant_part e) (sum_of (linear_part e) (center_of b)).
Definition least (b : box) (e : equation) : number := sub (middle b e) (spread b e).
Definition greatest (b : box) (e : equation) : number := add (middle b e) (spread b e).

Definition low (b : box) (i : N) : number := sub (get (center_of b) i) (abs (get (radius_of b) i)).
Definition most (b : box) (i : N) : number := add (abs (get (center_of b) i)) (abs (get (radius_of b) i)).

(** What holds everywhere in the box, beside the equations. *)
Definition conditions (p : tables) (b : box) (c : contact) : bool :=
  let d := t_dim p in let n := first c in
  let tangents := range (n + 1) (N.to_nat (d - 1)) in
  match its_mode c with
  | Open => forallb (vanishes b) (n :: tangents) && nonnegative (least b (row p n))
  | Touch => forallb (vanishes b) (n :: tangents)
  | Stick =>
      nonnegative (low b n) &&
      (if has_friction d c
       then le (total (map (fun i => square (most b i)) tangents)) (square (mul (mu c) (low b n)))
       else forallb (vanishes b) tangents)
  | Slide => N.eqb d 3 && nonnegative (low b n) && nonnegative (low b (slip c))
  | SlidePlus => N.eqb d 2 && nonnegative (low b n) && nonnegative (least b (row p (n + 1)))
  | SlideMinus => N.eqb d 2 && nonnegative (low b n) && nonnegative (opp (greatest b (row p (n + 1))))
  end.

(** Tables of unknowns: those of a list have these numbers. *)
Fixpoint assign (keys : list N) (l : list number) (m : table) : table :=
  match keys, l with k :: keys, x :: l => assign keys l (put m k x) | _, _ => m end.

Definition is_in (m : PositiveMap.t unit) (i : N) : bool := PositiveMap.mem (key i) m.
Definition indices (l : list N) : PositiveMap.t unit :=
  List.fold_left (fun m i => PositiveMap.add (key i) tt m) l (PositiveMap.empty unit).

(** Those of a list whose places are not among the indices. *)
Fixpoint others {A} (i : N) (taken : PositiveMap.t unit) (l : list A) : list A :=
  match l with [] => [] | x :: r => if is_in taken i then others (N.succ i) taken r else x :: others (N.succ i) taken r end.

Definition is_linear (e : equation) : bool := match quadratic_part e with [] => true | _ => false end.

(** A dropped equation is the combination of kept ones, where they are linear. *)
Definition combined (z : table) (left : list N) (taken : PositiveMap.t unit) (all : PositiveMap.t equation)
    (d : N * list (N * number)) : bool :=
  let e := look nothing all (fst d) in
  is_linear e
  && forallb (fun c => negb (is_in taken (fst c)) && is_linear (look nothing all (fst c))) (snd d)
  && is_zero (List.fold_left (fun s c => add s (mul (opp (snd c)) (at_center (look nothing all (fst c)) z))) (snd d)
                (at_center e z))
  && (let m := List.fold_left (fun m c => accumulate m (opp (snd c)) (slope (look nothing all (fst c)) z)) (snd d)
                 (accumulate empty one (slope e z)) in
      forallb (fun k => is_zero (get m k)) left).

(** The rows of the inverse, each for an unknown that is left. *)
Fixpoint name_rows (i : N) (left : list N) (inverse : PositiveMap.t linear) : list (N * linear) :=
  match left with [] => [] | j :: r => (j, look [] inverse i) :: name_rows (N.succ i) r inverse end.

(** Parts of the box in which a fixed point is looked for. *)
Definition fractions : list number :=
  [one; Number 1 1 1; Number 1 3 1; Number 1 6 1; Number 1 10 1].

Definition has_zero (z p : table) (left : list N) (kept : list equation) (inverse : PositiveMap.t linear) : bool :=
  let known_of := tabulate 0 (map (expand z p) kept) (PositiveMap.empty expansion) in
  let known := look flat known_of in
  let found := map (fun e => match e with (j, r) =>
      (shift_row known r, spread_row known left p j r, bend_row known r, abs (get p j)) end) (name_rows 0 left inverse) in
  Nat.eqb (List.length left) (List.length kept)
  && distinct left (PositiveMap.empty unit)
  && forallb (fun e => match e with (_, s, _, r) => lt s r end) found
  && existsb (fun t => forallb (fun e => match e with (f, s, q, r) => mapped t f s q r end) found) fractions.

Definition check_enclosure (p : tables) (x : list number) (rho : number) (eta : option number) (modes : list mode)
    (center radius : list number) (pinned : list N) (dropped : list (N * list (N * number)))
    (inverse : list (N * N * number)) : bool :=
  let variables := unknowns p modes in
  let all := equations p modes in
  let left := others 0 (indices pinned) variables in
  let taken := indices (map fst dropped) in
  let z := assign variables center empty in
  let r := assign left (others 0 (indices pinned) radius) empty in
  let b := Box z r in
  let answers := table_of x in
  let index_all := tabulate 0 all (PositiveMap.empty equation) in
  nonnegative rho
  && Nat.eqb (List.length modes) (List.length (t_mus p))
  && forallb positive_number radius
  && forallb (combined z left taken index_all) dropped
  && has_zero z r left (others 0 taken all) (by_rows inverse)
  && forallb (conditions p b) (contacts_of p modes)
  && forallb (fun i => le (add (abs (sub (get z i) (get answers i))) (abs (get r i))) rho) (range 0 (N.to_nat (t_size p)))
  && match eta with
     | None => true
     | Some eta =>
         forallb (fun i => let w := row p i in
             le (add (abs (sub (middle b w) (middle (Box answers empty) w))) (spread b w)) eta)
           (range (t_frees p) (N.to_nat (t_size p - t_frees p)))
     end.

(** Coulomb's law of exact numbers, without roots. *)
Definition obeys (d : N) (m : number) (r u : N -> number) : bool :=
  let tangents := range 1 (N.to_nat (d - 1)) in
  let dot a b := total (map (fun t => mul (a t) (b t)) tangents) in
  let limit := square (mul m (r 0)) in
  nonnegative (u 0) && nonnegative (r 0) && is_zero (mul (r 0) (u 0)) && le (dot r r) limit
  && (is_zero (dot u u)
      || (eq (dot r r) limit && nonnegative (opp (dot r u))
          && (N.ltb d 3 || eq (mul (r 1) (u 2)) (mul (r 2) (u 1))))).

Definition check_eps (p : tables) (x : list number) (bound moved : number) (point motions : list number) : bool :=
  let x_ := table_of point in let w := table_of motions in let answers := table_of x in
  nonnegative bound && nonnegative moved
  && forallb (fun i => is_zero (get w i)) (range 0 (N.to_nat (t_frees p)))
  && forallb (fun c => obeys (t_dim p) (mu c) (fun t => get x_ (first c + t)) (fun t => get w (first c + t)))
       (contacts_of p (map (fun _ => Open) (t_mus p)))
  && forallb (fun i =>
       le (abs (sub (get w i) (middle (Box x_ empty) (row p i)))) bound
       && le (abs (sub (get x_ i) (get answers i))) moved) (range 0 (N.to_nat (t_size p))).
