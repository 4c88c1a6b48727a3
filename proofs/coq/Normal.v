(** The normal form of expressions and formulas (FORMAT.md, "Normal form"). *)
From Coq Require Import String List Bool NArith ZArith FMapAVL FMapFacts OrderedTypeEx.
From Slipproof Require Import Text Syntax Poly.
Import ListNotations.

Module Map := FMapAVL.Make String_as_OT.

(** num/den, defined where no polynomial in [divs] is zero; no [den] is 1, where nothing is divided. *)
Record fraction := Fraction { num : poly; den : option poly; divs : list poly }.

Definition one : poly := constant 1.
Definition or_one (p : option poly) : poly := match p with Some p => p | None => one end.

Definition same_den (p q : option poly) : bool :=
  match p, q with Some p, Some q => same_poly p q | None, None => true | _, _ => false end.

(** Each divisor once, in the order in which they come. *)
Fixpoint add_divs (ps qs : list poly) : list poly :=
  match qs with
  | [] => ps
  | q :: qs => if existsb (same_poly q) ps then add_divs ps qs else add_divs (ps ++ [q]) qs
  end.

Definition minus (x : fraction) : fraction := Fraction (neg (num x)) (den x) (divs x).

Definition plus (x y : fraction) : option fraction :=
  let divs := add_divs (divs x) (divs y) in
  if same_den (den x) (den y) then Some (Fraction (add (num x) (num y)) (den x) divs)
  else
    let* a := mul (num x) (or_one (den y)) in
    let* b := mul (num y) (or_one (den x)) in
    let* d := mul (or_one (den x)) (or_one (den y)) in Some (Fraction (add a b) (Some d) divs).

Definition times (x y : fraction) : option fraction :=
  let* n := mul (num x) (num y) in
  let* d := match den y with
            | None => Some (den x)
            | Some e => let* d := mul (or_one (den x)) e in Some (Some d)
            end in
  Some (Fraction n d (add_divs (divs x) (divs y))).

(** Division by the zero polynomial is refused. *)
Definition inverse (x : fraction) : option fraction :=
  require negb (is_zero (num x)) in
  Some (Fraction (or_one (den x)) (Some (num x))
                 (if is_constant (num x) then divs x else add_divs (divs x) [num x])).

(** [done] times the n-th power of x. *)
Fixpoint power (x : fraction) (n : nat) (done : fraction) : option fraction :=
  match n with O => Some done | S n => let* done := times done x in power x n done end.

(** p = 0, p > 0, p >= 0, a conjunction, or a disjunction. *)
Inductive form := Atom (s : sign) (p : poly) | All (parts : list form) | Any (parts : list form).

Definition all_of (parts : list form) : form := match parts with [f] => f | _ => All parts end.
Definition any_of (parts : list form) : form := match parts with [f] => f | _ => Any parts end.

Definition non_zero (p : poly) : form := Any [Atom Positive p; Atom Positive (neg p)].

Fixpoint negation (f : form) : form :=
  match f with
  | Atom Zero p => non_zero p
  | Atom Positive p => Atom NonNegative (neg p)
  | Atom NonNegative p => Atom Positive (neg p)
  | All parts => any_of (map negation parts)
  | Any parts => all_of (map negation parts)
  end.

(** At most [max_atoms] atoms, and [max_depth] conjunctions and disjunctions within each other: what remains of the
    former, none if they are exceeded. *)
Definition max_atoms : N := 100000.
Definition max_depth : nat := 100.
Fixpoint room (d : nat) (f : form) (n : N) : option N :=
  match f with
  | Atom _ _ => match n with N0 => None | _ => Some (N.pred n) end
  | All parts | Any parts =>
      match parts, d with
      | [], _ => Some n
      | _, O => None
      | _, S d => fold_left (fun n g => let* n := n in room d g n) parts (Some n)
      end
  end.
Definition fits (f : form) : bool := match room max_depth f max_atoms with Some _ => true | None => false end.

Inductive entry := Value (x : fraction) | Truth (f : form).
Definition scope := Map.t entry.

Section Normal.
Variable names : scope.

Fixpoint normal (e : expr) : option fraction :=
  match e with
  | Num token => let* n := number token in require coefficients_fit (constant n) in Some (Fraction (constant n) None [])
  | Name name => match Map.find name names with Some (Value x) => Some x | _ => None end
  | Paren a => normal a
  | Neg a => let* x := normal a in Some (minus x)
  | Pow a token =>
      let* x := normal a in
      let* n := exponent token in power x (pred n) x
  | Mul a b => let* x := normal a in let* y := normal b in times x y
  | Div a b => let* x := normal a in let* y := normal b in let* z := inverse y in times x z
  | Add a b => let* x := normal a in let* y := normal b in plus x y
  | Sub a b => let* x := normal a in let* y := normal b in plus x (minus y)
  end.

(** Signs [+ - * /] between values. *)
Fixpoint operators (e : expr) (n : N) : N :=
  match e with
  | Num _ | Name _ => n
  | Paren a | Neg a | Pow a _ => operators a n
  | Mul a b | Div a b | Add a b | Sub a b => operators a (operators b (N.succ n))
  end.
Definition max_operators : N := 1000.

(** The value of an expression of a statement or of [set]. *)
Definition normal_value (e : expr) : option fraction :=
  require N.leb (operators e 0) max_operators in
  let* x := normal e in require coefficients_fit (num x) in Some x.

(** The polynomial of an expression of a certificate: nothing is divided, nor in the names. *)
Definition normal_poly (e : expr) : option poly :=
  let* x := normal e in
  match den x with None => require coefficients_fit (num x) in Some (num x) | Some _ => None end.

(** The sign condition on n/d. *)
Definition condition (n : poly) (d : option poly) (r : rel) : option form :=
  match r with
  | Syntax.Eq => Some (Atom Zero n)
  | Ne => Some (non_zero n)
  | _ =>
      let* p := mul n (or_one d) in
      Some match r with
           | Syntax.Gt => Atom Positive p
           | Ge => Atom NonNegative p
           | Syntax.Lt => Atom Positive (neg p)
           | _ => Atom NonNegative (neg p)
           end
  end.

Definition comparison (x : fraction) (r : rel) (y : fraction) : option form :=
  let* z := plus x (minus y) in
  let* c := condition (num z) (den z) r in Some (all_of (map non_zero (divs z) ++ [c])).

Fixpoint comparisons (x : fraction) (links : list (rel * expr)) : option (list form) :=
  match links with
  | [] => Some []
  | (r, e) :: rest =>
      let* y := normal_value e in
      let* f := comparison x r y in
      let* fs := comparisons y rest in Some (f :: fs)
  end.

(** What was read of a formula; the parts are backwards. *)
Inductive parts := Whole (f : form) | Conjuncts (fs : list form) | Disjuncts (fs : list form).
Definition close (ps : parts) : form :=
  match ps with Whole f => f | Conjuncts fs => all_of (rev' fs) | Disjuncts fs => any_of (rev' fs) end.
Definition conjuncts (ps : parts) : list form := match ps with Conjuncts fs => fs | _ => [close ps] end.
Definition disjuncts (ps : parts) : list form := match ps with Disjuncts fs => fs | _ => [close ps] end.

Fixpoint normal_parts (f : formula) : option parts :=
  match f with
  | False_ => Some (Whole (Any []))
  | Named name => match Map.find name names with Some (Truth g) => Some (Whole g) | _ => None end
  | Chain e links =>
      let* x := normal_value e in
      let* fs := comparisons x links in Some (Whole (all_of fs))
  | Braces g => let* ps := normal_parts g in Some (Whole (close ps))
  | And g h =>
      let* ps := normal_parts g in
      let* qs := normal_parts h in Some (Conjuncts (close qs :: conjuncts ps))
  | Or g h =>
      let* ps := normal_parts g in
      let* qs := normal_parts h in Some (Disjuncts (close qs :: disjuncts ps))
  end.

Definition normal_formula (f : formula) : option form :=
  let* ps := normal_parts f in require fits (close ps) in Some (close ps).

Definition abbreviate (a : abbreviation) : option scope :=
  match a with
  | Let name e => let* x := normal_value e in Some (Map.add name (Value x) names)
  | Define name f => let* g := normal_formula f in Some (Map.add name (Truth g) names)
  end.
End Normal.
