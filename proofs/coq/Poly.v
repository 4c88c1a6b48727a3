(** Polynomials with integer coefficients that compute, and their values at real numbers. *)
From Coq Require Import List Bool ZArith NArith Reals Lra Lia.
From Slipproof Require Import Text.
Import ListNotations.

(** A product of powers of variables; the variables ascend. *)
Inductive mono := One | Times (variable exponent : positive) (rest : mono).

(** A sum of terms; the monomials ascend, and no coefficient is 0. (No proof rests on this.) *)
Inductive poly := Nil | Plus (coefficient : Z) (m : mono) (rest : poly).

(** Lexicographic: the degree in the first variable decides, then that in the second, ... *)
Fixpoint compare_mono (a b : mono) : comparison :=
  match a, b with
  | One, One => Eq
  | One, Times _ _ _ => Lt
  | Times _ _ _, One => Gt
  | Times v e a, Times w f b =>
      match Pos.compare v w with
      | Lt => Gt
      | Gt => Lt
      | Eq => match Pos.compare e f with Eq => compare_mono a b | c => c end
      end
  end.

Fixpoint mul_mono (a : mono) : mono -> mono :=
  match a with
  | One => fun b => b
  | Times v e rest =>
      fix with_a (b : mono) : mono :=
        match b with
        | One => a
        | Times w f others =>
            match Pos.compare v w with
            | Lt => Times v e (mul_mono rest b)
            | Eq => Times v (Pos.add e f) (mul_mono rest others)
            | Gt => Times w f (with_a others)
            end
        end
  end.

Fixpoint add (p : poly) : poly -> poly :=
  match p with
  | Nil => fun q => q
  | Plus c m rest =>
      fix with_p (q : poly) : poly :=
        match q with
        | Nil => p
        | Plus d n others =>
            match compare_mono m n with
            | Lt => Plus c m (add rest q)
            | Eq => match Z.add c d with Z0 => add rest others | sum => Plus sum m (add rest others) end
            | Gt => Plus d n (with_p others)
            end
        end
  end.

Fixpoint neg (p : poly) : poly :=
  match p with Nil => Nil | Plus c m rest => Plus (Z.opp c) m (neg rest) end.

(** The term c m times p. *)
Fixpoint scale (c : Z) (m : mono) (p : poly) : poly :=
  match p with Nil => Nil | Plus d n rest => Plus (Z.mul c d) (mul_mono m n) (scale c m rest) end.

Fixpoint add_pairs (ps : list poly) : list poly :=
  match ps with p :: q :: rest => add p q :: add_pairs rest | _ => ps end.

(** The sum of all, by halves. *)
Fixpoint add_all (rounds : nat) (ps : list poly) : poly :=
  match rounds, ps with
  | _, [] => Nil
  | _, [p] => p
  | S n, _ => add_all n (add_pairs ps)
  | O, _ => fold_right add Nil ps
  end.
Definition rounds : nat := 20.
Definition sum (ps : list poly) : poly := add_all rounds ps.

Fixpoint multiples (p q : poly) : list poly :=
  match p with Nil => [] | Plus c m rest => scale c m q :: multiples rest q end.

Definition mul_unbounded (p q : poly) : poly := sum (multiples p q).

Definition constant (c : Z) : poly := match c with Z0 => Nil | _ => Plus c One Nil end.
Definition variable (v : positive) : poly := Plus 1 (Times v 1 One) Nil.
Definition is_zero (p : poly) : bool := match p with Nil => true | _ => false end.
(** A number that is not 0. *)
Definition is_constant (p : poly) : bool := match p with Plus c One Nil => negb (Z.eqb c 0) | _ => false end.

Fixpoint same_poly (p q : poly) : bool :=
  match p, q with
  | Nil, Nil => true
  | Plus c m p, Plus d n q => Z.eqb c d && match compare_mono m n with Eq => same_poly p q | _ => false end
  | _, _ => false
  end.

(** Limits (FORMAT.md): the result of an operation is refused beyond them. *)

Fixpoint degree (m : mono) (d : positive) : positive := match m with One => d | Times _ e m => degree m (Pos.max e d) end.
(** The largest exponent of a variable. *)
Fixpoint max_degree (p : poly) (d : positive) : positive :=
  match p with Nil => d | Plus _ m p => max_degree p (degree m d) end.
Fixpoint all_monos (good : mono -> bool) (p : poly) : bool :=
  match p with Nil => true | Plus _ m p => good m && all_monos good p end.
Definition degree_limit : positive := 255.
Definition degrees_fit (p q : poly) : bool :=
  Pos.leb (Pos.add (max_degree p 1) (max_degree q 1)) degree_limit
  || all_monos (fun m => all_monos (fun n => Pos.leb (degree (mul_mono m n) 1) degree_limit) q) p.

Fixpoint size (p : poly) (n : N) : N := match p with Nil => n | Plus _ _ p => size p (N.succ n) end.
Definition max_products : N := 200000.

Definition coefficient_limit : Z := Z.pow 2 8192.
Definition coefficient_limit_negative : Z := Z.opp coefficient_limit.
Fixpoint coefficients_fit (p : poly) : bool :=
  match p with
  | Nil => true
  | Plus c _ p => Z.ltb c coefficient_limit && Z.ltb coefficient_limit_negative c && coefficients_fit p
  end.

Definition mul (p q : poly) : option poly :=
  let m := size p 0 in
  let n := size q 0 in
  require N.leb (N.mul m n) max_products && degrees_fit p q in
  let product := if N.leb m n then mul_unbounded p q else mul_unbounded q p in
  require coefficients_fit product in Some product.

(** Values *)
Local Open Scope R_scope.

Section Values.
Variable x : positive -> R.

Fixpoint value_mono (m : mono) : R :=
  match m with One => 1 | Times v e m => x v ^ Pos.to_nat e * value_mono m end.

Fixpoint value_at (p : poly) : R :=
  match p with Nil => 0 | Plus c m p => IZR c * value_mono m + value_at p end.

Lemma compare_mono_eq a : forall b, compare_mono a b = Eq -> a = b.
Proof.
  induction a as [|v e a IH]; intros [|w f b]; simpl; try discriminate; auto.
  destruct (Pos.compare_spec v w); try discriminate; subst.
  destruct (Pos.compare_spec e f); try discriminate; subst.
  intro H; f_equal; auto.
Qed.

Lemma mul_mono_value a : forall b, value_mono (mul_mono a b) = value_mono a * value_mono b.
Proof.
  induction a as [|v e a IH]; intro b; [simpl; ring|].
  induction b as [|w f b IHb]; [simpl; ring|].
  cbn [mul_mono]. destruct (Pos.compare_spec v w) as [E|E|E].
  - subst w. cbn [value_mono]. rewrite IH, Pos2Nat.inj_add, pow_add. ring.
  - cbn [value_mono]. rewrite IH. cbn [value_mono]. ring.
  - cbn [value_mono]. cbn [mul_mono] in IHb. rewrite IHb. cbn [value_mono]. ring.
Qed.

Lemma add_value p : forall q, value_at (add p q) = value_at p + value_at q.
Proof.
  induction p as [|c m p IH]; intro q; [simpl; ring|].
  induction q as [|d n q IHq]; [simpl; ring|].
  cbn [add]. destruct (compare_mono m n) eqn:E.
  - apply compare_mono_eq in E; subst n.
    assert (S : IZR (c + d) = IZR c + IZR d) by apply plus_IZR.
    destruct (c + d)%Z eqn:F; cbn [value_at]; rewrite IH; replace (IZR d) with (IZR (c + d)%Z - IZR c) by (rewrite plus_IZR; ring);
      rewrite F; ring.
  - cbn [value_at]. rewrite IH. cbn [value_at]. ring.
  - cbn [value_at]. cbn [add] in IHq. rewrite IHq. cbn [value_at]. ring.
Qed.

Lemma neg_value p : value_at (neg p) = - value_at p.
Proof. induction p as [|c m p IH]; simpl; [ring|]. rewrite IH, opp_IZR. ring. Qed.

Lemma scale_value c m p : value_at (scale c m p) = IZR c * value_mono m * value_at p.
Proof. induction p as [|d n p IH]; simpl; [ring|]. rewrite IH, mult_IZR, mul_mono_value. ring. Qed.

Fixpoint total (ps : list poly) : R := match ps with [] => 0 | p :: ps => value_at p + total ps end.

Lemma add_pairs_value n : forall ps, (length ps <= n)%nat -> total (add_pairs ps) = total ps.
Proof.
  induction n as [|n IH]; intros [|p [|q ps]] L; simpl in *; auto; try lia.
  rewrite add_value, IH by lia. ring.
Qed.

Lemma add_all_value n : forall ps, value_at (add_all n ps) = total ps.
Proof.
  induction n as [|n IH]; intros [|p [|q ps]]; try (simpl; ring).
  - cbn [add_all]. generalize (p :: q :: ps); intro l.
    induction l as [|r l IHl]; simpl; [ring|]. rewrite add_value, IHl. ring.
  - change (value_at (add_all n (add_pairs (p :: q :: ps))) = total (p :: q :: ps)).
    rewrite IH. eapply add_pairs_value; reflexivity.
Qed.

Lemma sum_value ps : value_at (sum ps) = total ps.
Proof. apply add_all_value. Qed.

Lemma mul_unbounded_value p q : value_at (mul_unbounded p q) = value_at p * value_at q.
Proof.
  unfold mul_unbounded. rewrite sum_value.
  induction p as [|c m p IH]; simpl; [ring|]. rewrite IH, scale_value. ring.
Qed.

Lemma mul_value p q r : mul p q = Some r -> value_at r = value_at p * value_at q.
Proof.
  unfold mul. destruct (_ && _); [|discriminate].
  destruct (coefficients_fit _); [|discriminate]. intro H; inversion H; subst r.
  destruct (N.leb _ _); rewrite mul_unbounded_value; ring.
Qed.

Lemma constant_value c : value_at (constant c) = IZR c.
Proof. destruct c; simpl; ring. Qed.

Lemma variable_value v : value_at (variable v) = x v.
Proof. unfold variable. simpl. ring. Qed.

Lemma same_poly_eq p : forall q, same_poly p q = true -> p = q.
Proof.
  induction p as [|c m p IH]; intros [|d n q]; simpl; try discriminate; auto.
  destruct (Z.eqb_spec c d); [|discriminate]. destruct (compare_mono m n) eqn:E; try discriminate.
  apply compare_mono_eq in E. simpl. intro H. apply IH in H. congruence.
Qed.

Lemma is_constant_value p : is_constant p = true -> value_at p <> 0.
Proof.
  destruct p as [|c [|v e m] [|d n p]]; simpl; try discriminate.
  destruct (Z.eqb_spec c 0) as [E|E]; [discriminate|]. intros _ F. apply E, eq_IZR. lra.
Qed.

Lemma is_zero_value p : is_zero p = true -> value_at p = 0.
Proof. destruct p; [reflexivity|discriminate]. Qed.
End Values.
