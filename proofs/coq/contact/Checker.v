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

(** FORMAT.md has a closer bound for each equation: the greater one of what the positive and the negative products add. *)
Definition close_bend (p : table) (e : equation) : number :=
  let part positive := size_of_products
    (filter (fun t => match t with (a, _, _) => Bool.eqb (nonnegative a) positive end) (quadratic_part e)) p in
  let a := part true in let b := part false in if le a b then b else a.

Definition has_zero (z p : table) (left : list N) (kept : list equation) (inverse : PositiveMap.t linear) : bool :=
  let known_of := tabulate 0 (map (expand z p) kept) (PositiveMap.empty expansion) in
  let known := look flat known_of in
  let close_of := tabulate 0 (map (close_bend p) kept) empty in
  let closely b := Expansion zero [] (get close_of b) in
  let found := map (fun e => match e with (j, r) =>
      (shift_row known r, spread_row known left p j r, bend_row known r, abs (get p j), bend_row closely r) end)
      (name_rows 0 left inverse) in
  Nat.eqb (List.length left) (List.length kept)
  && distinct left (PositiveMap.empty unit)
  && forallb (fun e => match e with (f, s, _, r, q) => lt s r && le (add (add f s) q) r end) found
  && existsb (fun t => forallb (fun e => match e with (f, s, q, r, _) => mapped t f s q r end) found) fractions.

(** The unknowns that are left, and their box; the equations that are kept. *)
Definition unknowns_left (p : tables) (modes : list mode) (pinned : list N) : list N := others 0 (indices pinned) (unknowns p modes).
Definition box_of (p : tables) (modes : list mode) (center radius : list number) (pinned : list N) : box :=
  Box (assign (unknowns p modes) center empty)
    (assign (unknowns_left p modes pinned) (others 0 (indices pinned) radius) empty).
Definition equations_kept (p : tables) (modes : list mode) (dropped : list (N * list (N * number))) : list equation :=
  others 0 (indices (map fst dropped)) (equations p modes).

(** There is a zero of the equations that are left, by what a claim gives for it; and everywhere around it the conditions hold. *)
Definition check_box (p : tables) (modes : list mode) (center radius : list number) (pinned : list N)
    (dropped : list (N * list (N * number))) (zero_near : table -> table -> list N -> list equation -> bool) : bool :=
  let left := unknowns_left p modes pinned in
  let b := box_of p modes center radius pinned in
  let index_all := tabulate 0 (equations p modes) (PositiveMap.empty equation) in
  Nat.eqb (List.length modes) (List.length (t_mus p))
  && forallb positive_number radius
  && forallb (combined (center_of b) left (indices (map fst dropped)) index_all) dropped
  && zero_near (center_of b) (radius_of b) left (equations_kept p modes dropped)
  && forallb (conditions p b) (contacts_of p modes).

Definition check_near (p : tables) (x : list number) (rho : number) (eta : option number) (modes : list mode)
    (center radius : list number) (pinned : list N) (dropped : list (N * list (N * number)))
    (zero_near : table -> table -> list N -> list equation -> bool) : bool :=
  let b := box_of p modes center radius pinned in
  let answers := table_of x in
  nonnegative rho
  && check_box p modes center radius pinned dropped zero_near
  && forallb (fun i => le (add (abs (sub (get (center_of b) i) (get answers i))) (abs (get (radius_of b) i))) rho)
       (range 0 (N.to_nat (t_size p)))
  && match eta with
     | None => true
     | Some eta =>
         forallb (fun i => let w := row p i in
             le (add (abs (sub (middle b w) (middle (Box answers empty) w))) (spread b w)) eta)
           (range (t_frees p) (N.to_nat (t_size p - t_frees p)))
     end.

Definition check_enclosure (p : tables) (x : list number) (rho : number) (eta : option number) (modes : list mode)
    (center radius : list number) (pinned : list N) (dropped : list (N * list (N * number)))
    (inverse : list (N * N * number)) : bool :=
  check_near p x rho eta modes center radius pinned dropped (fun z r left kept => has_zero z r left kept (by_rows inverse)).

(** Places of unknowns in a list. *)
Fixpoint positions (i : N) (l : list N) (m : PositiveMap.t N) : PositiveMap.t N :=
  match l with [] => m | k :: r => positions (N.succ i) r (PositiveMap.add (key k) i m) end.

(** The slopes of equations, times a factor each, with the radii for units, by places: a matrix from row i on. *)
Fixpoint scaled_slopes (z p : table) (places : PositiveMap.t N) (i : N) (l : list (equation * number)) : list (N * N * number) :=
  match l with
  | [] => []
  | (e, r) :: rest =>
      flat_map (fun t => match PositiveMap.find (key (fst t)) places with
        | Some b => [(i, b, mul r (mul (snd t) (get p (fst t))))]
        | None => []
        end) (slope e z)
      ++ scaled_slopes z p places (N.succ i) rest
  end.

Definition transposed (l : list (N * N * number)) : list (N * N * number) :=
  map (fun e => match e with (i, j, a) => (j, i, a) end) l.

(** Row a of M^T M - L L^T. *)
Definition gram_row (m_rows m_columns lower lower_columns : PositiveMap.t linear) (a : N) : table :=
  List.fold_left (fun m e => accumulate m (opp (snd e)) (look [] lower_columns (fst e))) (look [] lower a)
    (List.fold_left (fun m e => accumulate m (snd e) (look [] m_rows (fst e))) (look [] m_columns a) empty).

Definition squares (f : equation -> number) (l : list (equation * number)) : number :=
  total (map (fun e => square (mul (snd e) (f (fst e)))) l).

Definition ball_has_zero (rows : list number) (s f q : number) (factor : list (N * N * number))
    (z p : table) (left : list N) (kept : list equation) : bool :=
  let n := List.length left in
  let l := combine kept rows in
  let slopes := scaled_slopes z p (positions 0 left (PositiveMap.empty N)) 0 l in
  let m_rows := by_rows slopes in let m_columns := by_rows (transposed slopes) in
  let lower := by_rows factor in let lower_columns := by_rows (transposed factor) in
  let bends := squares (fun e => size_of_products (quadratic_part e) p) l in
  Nat.eqb (List.length kept) n && Nat.eqb (List.length rows) n && distinct left (PositiveMap.empty unit)
  && forallb (fun r => negb (is_zero r)) rows
  && positive_number s && nonnegative f && nonnegative q && le (add f q) s
  && le (squares (fun e => at_center e z) l) (square f) && le (squares (close_bend p) l) (square q)
  && le bends (square (sub s f)) && lt (mul (Number 4 0 1) bends) (square s)
  && forallb (fun e => match e with (i, j, _) => N.ltb i (N.of_nat n) && N.ltb j (N.of_nat n) end) factor
  && forallb (fun a =>
       let m := gram_row m_rows m_columns lower lower_columns a in
       le (total (map (fun j => if N.eqb j a then zero else abs (get m j)) (range 0 n))) (sub (get m a) (square s)))
     (range 0 n).

Definition check_ball (p : tables) (x : list number) (rho : number) (eta : option number) (modes : list mode)
    (center radius : list number) (pinned : list N) (dropped : list (N * list (N * number)))
    (rows : list number) (s f q : number) (factor : list (N * N * number)) : bool :=
  check_near p x rho eta modes center radius pinned dropped (ball_has_zero rows s f q factor).

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

(** The numbers from low to high. *)
Record interval := Interval { from : number; upto : number }.

Definition smaller (x y : number) : number := if le x y then x else y.
Definition larger (x y : number) : number := if le x y then y else x.
Definition misses_zero (x : interval) : bool := positive_number (from x) || positive_number (opp (upto x)).
Definition add_intervals (x y : interval) : interval := Interval (add (from x) (from y)) (add (upto x) (upto y)).
Definition sub_intervals (x y : interval) : interval := Interval (sub (from x) (upto y)) (sub (upto x) (from y)).
Definition mul_intervals (x y : interval) : interval :=
  let a := mul (from x) (from y) in let b := mul (from x) (upto y) in
  let c := mul (upto x) (from y) in let d := mul (upto x) (upto y) in
  Interval (smaller (smaller a b) (smaller c d)) (larger (larger a b) (larger c d)).
Definition square_interval (x : interval) : interval :=
  let a := square (from x) in let b := square (upto x) in
  Interval (if misses_zero x then smaller a b else zero) (larger a b).
Definition around (x r : number) : interval := Interval (sub x r) (add x r).
Definition nought : interval := Interval zero zero.
Definition total_interval (l : list interval) : interval := fold_right add_intervals nought l.

(** That contact c fails its law for all forces and velocities in these ranges, by components. *)
Definition fails (d : N) (m : number) (r u : N -> interval) : bool :=
  let tangents := range 1 (N.to_nat (d - 1)) in
  let force := total_interval (map (fun t => square_interval (r t)) tangents) in
  let product := total_interval (map (fun t => mul_intervals (r t) (u t)) tangents) in
  let limit x := square (mul m (larger x zero)) in
  let pushes := nonnegative (upto (r 0)) in
  let in_cone := le (from force) (limit (upto (r 0))) in
  let parallel := N.ltb d 3 || negb (misses_zero (sub_intervals (mul_intervals (r 1) (u 2)) (mul_intervals (r 2) (u 1)))) in
  negb (nonnegative (upto (u 0)) && negb (misses_zero (r 0)) && forallb (fun t => negb (misses_zero (r t))) tangents)
  && negb (pushes && negb (misses_zero (u 0)) && forallb (fun t => negb (misses_zero (u t))) tangents && in_cone)
  && negb (pushes && negb (misses_zero (u 0)) && in_cone && le (limit (from (r 0))) (upto force) && parallel
           && nonnegative (opp (from product))).

Definition check_none_within (p : tables) (x : list number) (rho : number) : bool :=
  let answers := table_of x in
  let motion_of i := around (middle (Box answers empty) (row p i))
      (total (map (fun e => mul (abs (snd e)) rho) (linear_part (row p i)))) in
  let force_of i := around (get answers i) rho in
  nonnegative rho
  && (existsb (fun i => misses_zero (motion_of i)) (range 0 (N.to_nat (t_frees p)))
      || existsb (fun c => fails (t_dim p) (mu c) (fun t => force_of (first c + t)) (fun t => motion_of (first c + t)))
           (contacts_of p (map (fun _ => Open) (t_mus p)))).

Definition tangents (p : tables) (c : contact) : list N := range (first c + 1) (N.to_nat (t_dim p - 1)).
Definition all_open (p : tables) : list contact := contacts_of p (map (fun _ => Open) (t_mus p)).

(** A^T y *)
Definition combination (p : tables) (y : table) : table :=
  List.fold_left (fun m i => accumulate m (get y i) (linear_part (row p i))) (range 0 (N.to_nat (t_size p))) empty.

(** g . x <= 0 for all x that are 0 in the first components, any number in the other free ones, and in the cones. *)
Definition falls (p : tables) (zeros : N) (g : table) : bool :=
  forallb (fun j => is_zero (get g j)) (range zeros (N.to_nat (t_frees p - zeros)))
  && forallb (fun c =>
       nonnegative (opp (get g (first c)))
       && le (mul (square (mu c)) (total (map (fun j => square (get g j)) (tangents p c)))) (square (get g (first c))))
     (all_open p).

(** c . y < 0 *)
Definition loses (p : tables) (y : table) : bool :=
  positive_number (opp (total (map (fun i => mul (get y i) (get (t_constants p) i)) (range 0 (N.to_nat (t_size p)))))).

(** y^T w has no negative terms where there is a solution, and is (A^T y) . x + c . y < 0. *)
Definition check_no_solution (p : tables) (multipliers : list number) : bool :=
  let y := table_of multipliers in
  falls p 0 (combination p y)
  && forallb (fun c => nonnegative (get y (first c)) && forallb (fun i => is_zero (get y i)) (tangents p c)) (all_open p)
  && loses p y.

(** Forces in the cones with w = 0, without accelerations. *)
Definition check_rest (p : tables) (accelerations : N) (forces : list number) : bool :=
  let x := table_of (repeat zero (N.to_nat accelerations) ++ forces) in
  forallb (fun i => is_zero (middle (Box x empty) (row p i))) (range 0 (N.to_nat (t_size p)))
  && forallb (fun c =>
       nonnegative (get x (first c))
       && le (total (map (fun j => square (get x j)) (tangents p c))) (square (mul (mu c) (get x (first c)))))
     (all_open p).

(** y^T w = 0 at rest, and is (A^T y) . x + c . y < 0. *)
Definition check_no_rest (p : tables) (accelerations : N) (multipliers : list number) : bool :=
  let y := table_of multipliers in
  N.leb accelerations (t_frees p) && falls p accelerations (combination p y) && loses p y.

(** d > 0 and a_ii d_i > the sum of the other |a_ij| d_j, with a_ii > 0. *)
Definition check_dominant (p : tables) (weights : list number) : bool :=
  let d := table_of weights in
  N.eqb (t_frees p) 0 && N.eqb (t_dim p) 1
  && forallb (fun i =>
       let a := accumulate empty one (linear_part (row p i)) in
       positive_number (get d i) && positive_number (get a i)
       && lt (total (map (fun j => if N.eqb j i then zero else mul (abs (get a j)) (get d j)) (range 0 (N.to_nat (t_size p)))))
             (mul (get a i) (get d i)))
     (range 0 (N.to_nat (t_size p))).

(** Row i of A + A^T - L L^T, where all that is given are rows and columns. *)
Definition remainder_row (p : tables) (columns lower lower_columns : PositiveMap.t linear) (i : N) : table :=
  List.fold_left (fun m e => accumulate m (opp (snd e)) (look [] lower_columns (fst e))) (look [] lower i)
    (accumulate (accumulate empty one (linear_part (row p i))) one (look [] columns i)).

(** In each row of A + A^T - L L^T the diagonal entry is greater than the sum of the absolute values of the others. *)
Definition check_definite (p : tables) (matrix factor : list (N * N * number)) : bool :=
  let columns := by_rows (transposed matrix) in
  let lower := by_rows factor in let lower_columns := by_rows (transposed factor) in
  N.eqb (t_frees p) 0 && N.eqb (t_dim p) 1
  && forallb (fun e => match e with (i, j, _) => N.ltb i (t_size p) && N.leb j i end) factor
  && forallb (fun i =>
       let m := remainder_row p columns lower lower_columns i in
       lt (total (map (fun j => if N.eqb j i then zero else abs (get m j)) (range 0 (N.to_nat (t_size p))))) (get m i))
     (range 0 (N.to_nat (t_size p))).
