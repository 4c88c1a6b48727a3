(** What a statement says, over Coq's real numbers. This, [Text.v], [Syntax.v] and [Print.v] are all that has to be read
    to know what [Sound.v] proves. *)
From Coq Require Import String List Reals.
From Slipproof Require Import Text Syntax.
Import ListNotations.
Local Open Scope R_scope.

(** The value of an expression, and the condition under which it has one: that no divisor is zero. *)
Record quantity := Quantity { defined : Prop; value : R }.

Inductive entry := Value (q : quantity) | Truth (P : Prop).

(** What names stand for. *)
Definition scope := string -> option entry.
Definition nothing : scope := fun _ => None.
Definition bind (name : string) (e : entry) (names : scope) : scope :=
  fun other => if String.eqb other name then Some e else names other.

(** [None] is an expression with a name that stands for no value, or a token that is no number. *)
Fixpoint quantity_of (names : scope) (e : expr) : option quantity :=
  let both a b f :=
    let* x := quantity_of names a in
    let* y := quantity_of names b in Some (f x y) in
  match e with
  | Num token => let* n := number token in Some (Quantity True (IZR n))
  | Name name => match names name with Some (Value q) => Some q | _ => None end
  | Paren a => quantity_of names a
  | Neg a => let* x := quantity_of names a in Some (Quantity (defined x) (- value x))
  | Pow a token =>
      let* x := quantity_of names a in
      let* n := exponent token in Some (Quantity (defined x) (value x ^ n))
  | Mul a b => both a b (fun x y => Quantity (defined x /\ defined y) (value x * value y))
  | Div a b => both a b (fun x y => Quantity (defined x /\ defined y /\ value y <> 0) (value x / value y))
  | Add a b => both a b (fun x y => Quantity (defined x /\ defined y) (value x + value y))
  | Sub a b => both a b (fun x y => Quantity (defined x /\ defined y) (value x - value y))
  end.

Definition compare (x : quantity) (r : rel) (y : quantity) : Prop :=
  defined x /\ defined y /\
  match r with
  | Lt => value x < value y
  | Le => value x <= value y
  | Eq => value x = value y
  | Ne => value x <> value y
  | Ge => value x >= value y
  | Gt => value x > value y
  end.

Fixpoint chain (names : scope) (x : quantity) (links : list (rel * expr)) : option Prop :=
  match links with
  | [] => Some True
  | (r, e) :: rest =>
      let* y := quantity_of names e in
      let* P := chain names y rest in Some (compare x r y /\ P)
  end.

(** [None] is a formula with a name that stands for none, or with an expression that has no value. *)
Fixpoint truth (names : scope) (f : formula) : option Prop :=
  match f with
  | False_ => Some False
  | Named name => match names name with Some (Truth P) => Some P | _ => None end
  | Chain e links => let* x := quantity_of names e in chain names x links
  | Braces g => truth names g
  | And g h => let* P := truth names g in let* Q := truth names h in Some (P /\ Q)
  | Or g h => let* P := truth names g in let* Q := truth names h in Some (P \/ Q)
  end.

Definition abbreviate (a : abbreviation) (names : scope) : option scope :=
  match a with
  | Let name e => let* q := quantity_of names e in Some (bind name (Value q) names)
  | Define name f => let* P := truth names f in Some (bind name (Truth P) names)
  end.

(** The variables of a line are the values that [x] gives to their names. *)
Definition give (x : string -> R) (variables : list string) (names : scope) : scope :=
  fold_left (fun names v => bind v (Value (Quantity True (x v))) names) variables names.

(** Under the premises, [conclude] holds of the names they give; what has no meaning is false. *)
Fixpoint under (x : string -> R) (ps : list premise) (names : scope) (conclude : scope -> Prop) : Prop :=
  match ps with
  | [] => conclude names
  | Real variables :: rest => under x rest (give x variables names) conclude
  | Abbreviate a :: rest =>
      match abbreviate a names with Some names => under x rest names conclude | None => False end
  | Assume _ f :: rest =>
      match truth names f with Some P => P -> under x rest names conclude | None => False end
  end.

Fixpoint shown (abbreviations : list abbreviation) (f : formula) (names : scope) : Prop :=
  match abbreviations with
  | [] => match truth names f with Some P => P | None => False end
  | a :: rest => match abbreviate a names with Some names => shown rest f names | None => False end
  end.

(** For all values [x] of the variables, if all assumptions hold, then there are values [y] of the unknowns, if any, for
    which the formula shown holds. *)
Definition meaning (s : statement) : Prop :=
  forall x : string -> R,
    under x (premises s) nothing
      (fun names => exists y : string -> R, shown (abbreviations s) (conclusion s) (give y (unknowns s) names)).
