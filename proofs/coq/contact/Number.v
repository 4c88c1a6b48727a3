(** Exact numbers that compute: n / (2^k d), so that those of floating point have d = 1. *)
From Coq Require Import ZArith NArith Reals Lra Lia Bool Psatz.
Local Open Scope Z_scope.

Record number := Number { num : Z; twos : N; den : positive }.

(** The real number that it is. *)
Definition value (x : number) : R := (IZR (num x) / (2 ^ N.to_nat (twos x) * IZR (Zpos (den x))))%R.

Definition zero : number := Number 0 0 1.
Definition one : number := Number 1 0 1.

Fixpoint euclid (fuel : nat) (a b : Z) : Z :=
  match fuel with
  | O => 1
  | S f => if b =? 0 then a else euclid f b (a mod b)
  end.

(** As many steps as numbers of 7,000 bits need. *)
Definition most_steps : nat := Z.to_nat 10000.

(** In lower terms, if what was found is a common divisor. *)
Definition reduce (x : number) : number :=
  if Pos.eqb (den x) 1 then x else
  let g := euclid most_steps (Zpos (den x)) (Z.abs (num x)) in
  let n := num x / g in let d := Zpos (den x) / g in
  match d with
  | Zpos e => if (n * Zpos (den x) =? num x * d) then Number n (twos x) e else x
  | _ => x
  end.

Definition shifted (n : Z) (k : N) : Z := if (k =? 0)%N then n else Z.shiftl n (Z.of_N k).

Definition add (x y : number) : number :=
  if num x =? 0 then y else if num y =? 0 then x else
  let k := N.max (twos x) (twos y) in
  let a := shifted (num x) (k - twos x) in let b := shifted (num y) (k - twos y) in
  if Pos.eqb (den x) (den y) then reduce (Number (a + b) k (den x))
  else reduce (Number (a * Zpos (den y) + b * Zpos (den x)) k (den x * den y)).

Definition opp (x : number) : number := Number (- num x) (twos x) (den x).
Definition sub (x y : number) : number := add x (opp y).
Definition abs (x : number) : number := Number (Z.abs (num x)) (twos x) (den x).
Definition mul (x y : number) : number :=
  if num x =? 0 then zero else if num y =? 0 then zero else
  reduce (Number (num x * num y) (twos x + twos y) (den x * den y)).

Definition is_zero (x : number) : bool := num x =? 0.
Definition nonnegative (x : number) : bool := 0 <=? num x.
Definition positive_number (x : number) : bool := 0 <? num x.
Definition le (x y : number) : bool := nonnegative (sub y x).
Definition lt (x y : number) : bool := positive_number (sub y x).
Definition eq (x y : number) : bool := is_zero (sub y x).
(** The same in all its parts. *)
Definition same (x y : number) : bool := (num x =? num y) && (twos x =? twos y)%N && Pos.eqb (den x) (den y).

Local Open Scope R_scope.

Lemma two_pow_pos k : 0 < 2 ^ N.to_nat k.
Proof. apply pow_lt; lra. Qed.

Lemma den_pos p : 0 < IZR (Zpos p).
Proof. apply IZR_lt; lia. Qed.

Lemma scale_pos x : 0 < 2 ^ N.to_nat (twos x) * IZR (Zpos (den x)).
Proof. apply Rmult_lt_0_compat; [apply two_pow_pos | apply den_pos]. Qed.

Ltac nonzero :=
  repeat match goal with
  | |- _ /\ _ => split
  | |- 2 ^ N.to_nat _ <> 0 => apply Rgt_not_eq, two_pow_pos
  | |- IZR (Zpos _) <> 0 => apply Rgt_not_eq, den_pos
  | |- _ * _ <> 0 => apply Rmult_integral_contrapositive_currified
  end.

Lemma value_zero : value zero = 0.
Proof. unfold value; simpl; lra. Qed.
Lemma value_one : value one = 1.
Proof. unfold value; simpl; lra. Qed.

Lemma value_reduce x : value (reduce x) = value x.
Proof.
  unfold reduce. destruct (Pos.eqb _ _); [reflexivity|].
  set (g := euclid _ _ _). set (n := (num x / g)%Z).
  destruct (Zpos (den x) / g)%Z as [|e|] eqn:D; try reflexivity.
  destruct (n * Zpos (den x) =? num x * Zpos e)%Z eqn:E; [|reflexivity].
  apply Z.eqb_eq in E. apply (f_equal IZR) in E. rewrite !mult_IZR in E.
  unfold value; cbn [num twos den].
  apply Rmult_eq_reg_r with (2 ^ N.to_nat (twos x) * IZR (Zpos e) * IZR (Zpos (den x))).
  2: { nonzero. }
  replace (IZR n / (2 ^ N.to_nat (twos x) * IZR (Zpos e)) * (2 ^ N.to_nat (twos x) * IZR (Zpos e) * IZR (Zpos (den x))))
    with (IZR n * IZR (Zpos (den x))) by (field; nonzero).
  rewrite E. field; nonzero.
Qed.

Lemma shifted_IZR n k : IZR (shifted n k) = IZR n * 2 ^ N.to_nat k.
Proof.
  unfold shifted. destruct (N.eqb_spec k 0) as [->|_]; [simpl; lra|].
  rewrite Z.shiftl_mul_pow2 by lia. rewrite mult_IZR. f_equal.
  rewrite pow_IZR. f_equal. f_equal. lia.
Qed.

Lemma value_zero_num x : num x = 0%Z -> value x = 0.
Proof. unfold value; intros ->; unfold Rdiv; lra. Qed.

Lemma value_add x y : value (add x y) = value x + value y.
Proof.
  unfold add.
  destruct (Z.eqb_spec (num x) 0) as [E|_]; [rewrite (value_zero_num x E); lra|].
  destruct (Z.eqb_spec (num y) 0) as [E|_]; [rewrite (value_zero_num y E); lra|].
  set (k := N.max _ _).
  assert (X : 2 ^ N.to_nat k = 2 ^ N.to_nat (twos x) * 2 ^ N.to_nat (k - twos x)).
  { rewrite <- pow_add. f_equal. lia. }
  assert (Y : 2 ^ N.to_nat k = 2 ^ N.to_nat (twos y) * 2 ^ N.to_nat (k - twos y)).
  { rewrite <- pow_add. f_equal. lia. }
  assert (A : value x = IZR (shifted (num x) (k - twos x)) / (2 ^ N.to_nat k * IZR (Zpos (den x)))).
  { rewrite shifted_IZR, X. unfold value. field. nonzero. }
  assert (B : value y = IZR (shifted (num y) (k - twos y)) / (2 ^ N.to_nat k * IZR (Zpos (den y)))).
  { rewrite shifted_IZR, Y. unfold value. field. nonzero. }
  rewrite A, B. clear A B.
  destruct (Pos.eqb_spec (den x) (den y)) as [E|_]; rewrite value_reduce; unfold value; cbn [num twos den].
  - rewrite <- E, plus_IZR. field. nonzero.
  - rewrite Pos2Z.inj_mul, plus_IZR, !mult_IZR. field. nonzero.
Qed.

Lemma value_opp x : value (opp x) = - value x.
Proof. unfold value, opp; cbn [num twos den]. rewrite opp_IZR. field. nonzero. Qed.

Lemma value_sub x y : value (sub x y) = value x - value y.
Proof. unfold sub. rewrite value_add, value_opp. lra. Qed.

Lemma value_mul x y : value (mul x y) = value x * value y.
Proof.
  unfold mul.
  destruct (Z.eqb_spec (num x) 0) as [E|_]; [rewrite (value_zero_num x E), value_zero; lra|].
  destruct (Z.eqb_spec (num y) 0) as [E|_]; [rewrite (value_zero_num y E), value_zero; lra|].
  rewrite value_reduce. unfold value; cbn [num twos den].
  rewrite N2Nat.inj_add, pow_add, Pos2Z.inj_mul, !mult_IZR. field. nonzero.
Qed.

Lemma value_abs x : value (abs x) = Rabs (value x).
Proof.
  unfold value, abs; cbn [num twos den]. unfold Rdiv. rewrite Rabs_mult, abs_IZR.
  rewrite (Rabs_right (/ _)); [reflexivity|]. apply Rle_ge, Rlt_le, Rinv_0_lt_compat, scale_pos.
Qed.

Lemma sign_nonnegative x : nonnegative x = true -> 0 <= value x.
Proof.
  unfold nonnegative, value; intros H. apply Z.leb_le, IZR_le in H.
  apply Rmult_le_pos; [exact H|]. apply Rlt_le, Rinv_0_lt_compat, scale_pos.
Qed.

Lemma sign_positive x : positive_number x = true -> 0 < value x.
Proof.
  unfold positive_number, value; intros H. apply Z.ltb_lt, IZR_lt in H.
  apply Rmult_lt_0_compat; [exact H|]. apply Rinv_0_lt_compat, scale_pos.
Qed.

Lemma sign_zero x : is_zero x = true -> value x = 0.
Proof. unfold is_zero; intros H. apply value_zero_num, Z.eqb_eq, H. Qed.

Lemma sign_nonzero x : is_zero x = false -> value x <> 0.
Proof.
  unfold is_zero, value. intros H E. apply Z.eqb_neq in H. apply H, eq_IZR.
  apply Rmult_integral in E. destruct E as [E|E]; [exact E|].
  exfalso. apply Rinv_neq_0_compat in E; [exact E | apply Rgt_not_eq, scale_pos].
Qed.

Lemma le_value x y : le x y = true -> value x <= value y.
Proof. unfold le; intros H; apply sign_nonnegative in H; rewrite value_sub in H; lra. Qed.
Lemma lt_value x y : lt x y = true -> value x < value y.
Proof. unfold lt; intros H; apply sign_positive in H; rewrite value_sub in H; lra. Qed.
Lemma eq_value x y : eq x y = true -> value x = value y.
Proof. unfold eq; intros H; apply sign_zero in H; rewrite value_sub in H; lra. Qed.

Lemma same_equal x y : same x y = true -> x = y.
Proof.
  destruct x, y; unfold same; cbn. intros H.
  apply andb_prop in H. destruct H as [H D]. apply andb_prop in H. destruct H as [A B].
  apply Z.eqb_eq in A. apply N.eqb_eq in B. apply Pos.eqb_eq in D. subst. reflexivity.
Qed.

Lemma negative_sign x : nonnegative x = false -> value x < 0.
Proof.
  unfold nonnegative, value. intros H. apply Z.leb_gt, IZR_lt in H.
  assert (P := Rinv_0_lt_compat _ (scale_pos x)). unfold Rdiv. nra.
Qed.

Lemma le_false x y : le x y = false -> value y < value x.
Proof. unfold le; intros H; apply negative_sign in H; rewrite value_sub in H; lra. Qed.

Lemma nonnegative_of x : 0 <= value x -> nonnegative x = true.
Proof. intros H. destruct (nonnegative x) eqn:E; [reflexivity|]. apply negative_sign in E. lra. Qed.

Lemma le_of x y : value x <= value y -> le x y = true.
Proof. intros H. apply nonnegative_of. rewrite value_sub. lra. Qed.
