(** Numbers and conditions as files write them, and what they are worth: MEANING.md, "Values". *)
From Coq Require Import String List Bool ZArith Reals.
From Slipproof Require Import Text Syntax.
Import ListNotations.
Local Open Scope R_scope.

(** A decimal is written as a quotient; a power has a fixed integer as its exponent. *)
Inductive term :=
| Number (n : N)
| Symbol (name : string)
| Minus (a : term)
| Plus (a b : term)
| Difference (a b : term)
| Product (a b : term)
| Quotient (a b : term)
| Power (a : term) (exponent : Z)
| Absolute (a : term)
| Signum (a : term)
| Minimum (a b : term)
| Maximum (a b : term).

Inductive condition :=
| Constant (b : bool)
| Compare (a : term) (links : list (rel * term))
| Not (c : condition)
| Both (c d : condition)
| Either (c d : condition).

(** What names stand for; [None] is an undefined number, or no name at all. *)
Definition meanings := string -> option R.
Definition with_name (name : string) (x : option R) (names : meanings) : meanings :=
  fun other => if String.eqb other name then x else names other.

Definition sign_of (x : R) : R := if Rlt_dec 0 x then 1 else if Rlt_dec x 0 then -1 else 0.

(** The comparison that is true where this one is false. *)
Definition opposite (r : rel) : rel := match r with Lt => Ge | Le => Gt | Eq => Ne | Ne => Eq | Ge => Lt | Gt => Le end.

Section Values.
Variable names : meanings.

(** "It comes from a division by zero, or from a negative power of zero, and makes every number undefined that is
    computed from it. Otherwise x^0 is 1. Nothing is cancelled." *)
Fixpoint value (e : term) : option R :=
  let of_one a f := let* x := value a in Some (f x) in
  let of_two a b f := let* x := value a in let* y := value b in Some (f x y) in
  match e with
  | Number n => Some (IZR (Z.of_N n))
  | Symbol name => names name
  | Minus a => of_one a (fun x => - x)
  | Plus a b => of_two a b Rplus
  | Difference a b => of_two a b Rminus
  | Product a b => of_two a b Rmult
  | Quotient a b =>
      let* x := value a in
      let* y := value b in if Req_EM_T y 0 then None else Some (x / y)
  | Power a k =>
      let* x := value a in
      if Z.ltb k 0 then if Req_EM_T x 0 then None else Some (/ (x ^ Z.to_nat (- k))) else Some (x ^ Z.to_nat k)
  | Absolute a => of_one a Rabs
  | Signum a => of_one a sign_of
  | Minimum a b => of_two a b Rmin
  | Maximum a b => of_two a b Rmax
  end.

Definition compares (x : R) (r : rel) (y : R) : Prop :=
  match r with Lt => x < y | Le => x <= y | Eq => x = y | Ne => x <> y | Ge => x >= y | Gt => x > y end.

(** "A comparison with an undefined side is undefined." *)
Definition link (truth : bool) (a : term) (r : rel) (b : term) : Prop :=
  exists x y, value a = Some x /\ value b = Some y /\ if truth then compares x r y else ~ compares x r y.

(** "A chain is the conjunction of its links." *)
Fixpoint links_hold (a : term) (links : list (rel * term)) : Prop :=
  match links with [] => True | (r, b) :: rest => link true a r b /\ links_hold b rest end.
Fixpoint links_fail (a : term) (links : list (rel * term)) : Prop :=
  match links with [] => False | (r, b) :: rest => link false a r b \/ links_fail b rest end.

(** A condition is true, it is false, or it is neither: undefined. "[not] of undefined is undefined; [false and u] is
    false and [true or u] is true, on either side; any other [and] or [or] with an undefined side is undefined." *)
Fixpoint is (truth : bool) (c : condition) : Prop :=
  match c with
  | Constant b => b = truth
  | Compare a links => if truth then links_hold a links else links_fail a links
  | Not c => is (negb truth) c
  | Both c d => if truth then is true c /\ is true d else is false c \/ is false d
  | Either c d => if truth then is true c \/ is true d else is false c /\ is false d
  end.

Definition has_value (c : condition) : Prop := is true c \/ is false c.
End Values.
