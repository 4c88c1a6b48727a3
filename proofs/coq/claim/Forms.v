(** Normal forms of terms and conditions, over the variables of polynomials. A variable is a name in another coding, so
    that no list of names is needed. *)
From Coq Require Import Ascii String List Bool NArith ZArith.
From Slipproof Require Import Text Syntax Meaning Poly Normal.
From Slipproof.claim Require Import Expression.
Import ListNotations.

(** Names as positive numbers *)

Definition bit (b : bool) (p : positive) : positive := if b then xI p else xO p.
Fixpoint code (name : string) : positive :=
  match name with
  | EmptyString => xH
  | String (Ascii a b c d e f g h) rest =>
      bit a (bit b (bit c (bit d (bit e (bit f (bit g (bit h (code rest))))))))
  end.
Fixpoint decode_bits (p : positive) (bits : list bool) : string :=
  let next b p :=
    match bits with
    | [h; g; f; e; d; c; a] => String (Ascii a c d e f g h b) (decode_bits p [])
    | _ => decode_bits p (b :: bits)
    end in
  match p with xI p => next true p | xO p => next false p | xH => EmptyString end.
Definition decode (p : positive) : string := decode_bits p [].

Definition symbol (name : string) : fraction := Fraction (variable (code name)) None [].

(** Terms *)

Section Normal.
Variable names : Normal.scope.

Fixpoint normal_term (e : term) : option fraction :=
  match e with
  | Number n =>
      require coefficients_fit (constant (Z.of_N n)) in Some (Fraction (constant (Z.of_N n)) None [])
  | Symbol name => match Map.find name names with Some (Normal.Value x) => Some x | _ => None end
  | Minus a => let* x := normal_term a in Some (minus x)
  | Plus a b => let* x := normal_term a in let* y := normal_term b in plus x y
  | Difference a b => let* x := normal_term a in let* y := normal_term b in plus x (minus y)
  | Product a b => let* x := normal_term a in let* y := normal_term b in times x y
  | Quotient a b =>
      let* x := normal_term a in
      let* y := normal_term b in
      let* z := inverse y in times x z
  | Power a k =>
      let* x := normal_term a in
      match k with
      | Zpos n => require Pos.leb n 64 in power x (pred (Pos.to_nat n)) x
      | Z0 => Some (Fraction one None (divs x))
      | Zneg n =>
          require Pos.leb n 64 in
          let* y := power x (pred (Pos.to_nat n)) x in
          let* z := inverse y in times (Fraction one None []) z
      end
  | _ => None
  end.

(** Functions, by cases: the innermost function of a term, and the term around it. *)
Definition here := fun x : term => x.
Fixpoint innermost (e : term) : option (term * (term -> term)) :=
  let one a make := match innermost a with Some (f, k) => Some (f, fun x => make (k x)) | None => None end in
  let two a b make :=
    match innermost a with
    | Some (f, k) => Some (f, fun x => make (k x) b)
    | None => match innermost b with Some (f, k) => Some (f, fun x => make a (k x)) | None => None end
    end in
  let or_this found := match found with Some _ => found | None => Some (e, here) end in
  match e with
  | Number _ | Symbol _ => None
  | Minus a => one a Minus
  | Plus a b => two a b Plus
  | Difference a b => two a b Difference
  | Product a b => two a b Product
  | Quotient a b => two a b Quotient
  | Power a n => one a (fun x => Power x n)
  | Absolute a => or_this (one a Absolute)
  | Signum a => or_this (one a Signum)
  | Minimum a b => or_this (two a b Minimum)
  | Maximum a b => or_this (two a b Maximum)
  end.

(** A comparison without functions. *)
Definition plain_link (a : term) (r : rel) (b : term) : option form :=
  let* x := normal_term a in
  let* y := normal_term b in comparison x r y.

Definition by_case (f : term) (rest : term -> option form) : option form :=
  let one_case a r b value := let* g := plain_link a r b in let* h := rest value in Some (All [g; h]) in
  match f with
  | Absolute a =>
      let* x := one_case a Ge (Number 0) a in
      let* y := one_case a Syntax.Lt (Number 0) (Minus a) in Some (Any [x; y])
  | Signum a =>
      let* x := one_case a Syntax.Gt (Number 0) (Number 1) in
      let* y := one_case a Syntax.Eq (Number 0) (Number 0) in
      let* z := one_case a Syntax.Lt (Number 0) (Minus (Number 1)) in Some (Any [x; y; z])
  | Minimum a b =>
      let* x := one_case a Ge b b in
      let* y := one_case a Syntax.Lt b a in Some (Any [x; y])
  | Maximum a b =>
      let* x := one_case a Ge b a in
      let* y := one_case a Syntax.Lt b b in Some (Any [x; y])
  | _ => None
  end.

(** Of [max] or [min] on one side of an inequality, both operands are on it, or one of them is, and both have a value. *)
Definition below (r : rel) : bool := match r with Syntax.Lt | Le => true | _ => false end.
Definition unequal (r : rel) : bool := match r with Syntax.Eq | Ne => false | _ => true end.
Definition takes_both (maximum on_left : bool) (r : rel) : bool := Bool.eqb maximum (Bool.eqb (below r) on_left).

Definition extreme (e : term) : option (bool * term * term) :=
  match e with Maximum x y => Some (true, x, y) | Minimum x y => Some (false, x, y) | _ => None end.

(** All numbers in it have a value where these are not 0. *)
Fixpoint term_divisors (e : term) : option (list poly) :=
  match innermost e with
  | None => let* x := normal_term e in Some (divs x)
  | Some _ =>
      match e with
      | Minus a | Absolute a | Signum a => term_divisors a
      | Plus a b | Difference a b | Product a b | Minimum a b | Maximum a b =>
          let* ps := term_divisors a in let* qs := term_divisors b in Some (ps ++ qs)
      | _ => None
      end
  end.

Definition apart_from_zero (ps : list poly) : form := All (map non_zero ps).

Fixpoint normal_link (n : nat) (a : term) (r : rel) (b : term) : option form :=
  let operands maximum on_left x y rest :=
    let* f := rest x in
    let* g := rest y in
    if takes_both maximum on_left r then Some (All [f; g])
    else let* ps := term_divisors x in let* qs := term_divisors y in Some (All [Any [f; g]; apart_from_zero (ps ++ qs)]) in
  match n with
  | O => None
  | S n =>
      let any_function :=
        match innermost a, innermost b with
        | None, None => plain_link a r b
        | Some (f, k), _ => by_case f (fun x => normal_link n (k x) r b)
        | None, Some (f, k) => by_case f (fun x => normal_link n a r (k x))
        end in
      if unequal r then
        match extreme a, extreme b with
        | Some (maximum, x, y), _ => operands maximum true x y (fun x => normal_link n x r b)
        | None, Some (maximum, x, y) => operands maximum false x y (fun x => normal_link n a r x)
        | None, None => any_function
        end
      else any_function
  end.
Definition most_functions : nat := 20.

Section Links.
Variable form_of_link : term -> rel -> term -> option form.
Fixpoint links_with (truth : bool) (a : term) (links : list (rel * term)) : option (list form) :=
  match links with
  | [] => Some []
  | (r, b) :: rest =>
      let* f := form_of_link a (if truth then r else opposite r) b in
      let* fs := links_with truth b rest in Some (f :: fs)
  end.
End Links.
Definition normal_links := links_with (normal_link most_functions).

Definition all (f g : form) : form :=
  match f, g with All fs, All gs => All (fs ++ gs) | All fs, g => All (fs ++ [g]) | f, All gs => All (f :: gs) | f, g => All [f; g] end.
Definition any (f g : form) : form := Any [f; g].

(** The condition has this truth value. *)
Fixpoint normal_condition (truth : bool) (c : condition) : option form :=
  match c with
  | Expression.Constant b => Some (if Bool.eqb b truth then All [] else Any [])
  | Compare a links => let* fs := normal_links truth a links in Some (if truth then All fs else Any fs)
  | Not c => normal_condition (negb truth) c
  | Both c d =>
      let* f := normal_condition truth c in
      let* g := normal_condition truth d in Some (if truth then all f g else any f g)
  | Either c d =>
      let* f := normal_condition truth c in
      let* g := normal_condition truth d in Some (if truth then any f g else all f g)
  end.

(** All numbers in it have a value: enough for a truth value. *)
Fixpoint divisors_of_links (links : list (rel * term)) : option (list poly) :=
  match links with
  | [] => Some []
  | (_, e) :: rest =>
      let* qs := term_divisors e in
      let* ps := divisors_of_links rest in Some (qs ++ ps)
  end.
Fixpoint divisors (c : condition) : option (list poly) :=
  match c with
  | Expression.Constant _ => Some []
  | Compare a links =>
      let* qs := term_divisors a in
      let* ps := divisors_of_links links in Some (qs ++ ps)
  | Not c => divisors c
  | Both c d | Either c d => let* ps := divisors c in let* qs := divisors d in Some (ps ++ qs)
  end.
End Normal.
