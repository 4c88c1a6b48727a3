(** Coulomb's law from conditions without roots. *)
From Coq Require Import NArith Reals List Bool Lra Lia Psatz.
From Slipproof.contact Require Import Coulomb Number Fixed Linear Zero Certificate Checker Rows.
Local Open Scope R_scope.

Definition square_of (d : nat) (v : nat -> R) : R := sum (d - 1) (fun t => v (S t) * v (S t)).

Lemma sum_nonnegative n f : (forall i, (i < n)%nat -> 0 <= f i) -> 0 <= sum n f.
Proof. induction n as [|n IH]; intros P; cbn; [lra|]. assert (A := P n ltac:(lia)). specialize (IH ltac:(auto)). lra. Qed.

Lemma square_of_nonnegative d v : 0 <= square_of d v.
Proof. apply sum_nonnegative. intros; nra. Qed.

Lemma tangential_nonnegative d v : 0 <= tangential d v.
Proof. apply sqrt_pos. Qed.

Lemma tangential_square d v : tangential d v * tangential d v = square_of d v.
Proof. apply sqrt_sqrt, square_of_nonnegative. Qed.

Lemma tangential_zero d v : (forall t, (1 <= t < d)%nat -> v t = 0) -> tangential d v = 0.
Proof.
  intros Z. unfold tangential. rewrite sum_zero; [apply sqrt_0|]. intros t T. rewrite Z by lia. ring.
Qed.

Lemma tangential_le d v a : 0 <= a -> square_of d v <= a * a -> tangential d v <= a.
Proof. intros A B. unfold tangential. rewrite <- (sqrt_square a A). apply sqrt_le_1_alt, B. Qed.

Lemma tangential_eq d v a : 0 <= a -> square_of d v = a * a -> tangential d v = a.
Proof. intros A B. unfold tangential. fold (square_of d v). rewrite B. apply sqrt_square, A. Qed.

Lemma law_without_force d m r u : (1 <= d)%nat -> (forall t, (t < d)%nat -> r t = 0) -> 0 <= u 0%nat -> coulomb d m r u.
Proof.
  intros D Z U. assert (R0 := Z 0%nat ltac:(lia)). split; try rewrite R0; try lra.
  - rewrite tangential_zero; [lra|]. intros t T. apply Z. lia.
  - intros t T. rewrite (Z t) by lia. lra.
Qed.

Lemma law_without_velocity d m r u : 0 <= m -> u 0%nat = 0 -> (forall t, (1 <= t < d)%nat -> u t = 0) -> 0 <= r 0%nat ->
  square_of d r <= (m * r 0%nat) * (m * r 0%nat) -> coulomb d m r u.
Proof.
  intros M U Z P S. split; try lra.
  - rewrite U; lra.
  - apply tangential_le; [nra | exact S].
  - intros t T. rewrite (Z t T), tangential_zero by exact Z. lra.
Qed.

Lemma law_without_friction d m r u : (m = 0 \/ d = 1%nat) -> 0 <= m -> u 0%nat = 0 -> (forall t, (1 <= t < d)%nat -> r t = 0) ->
  0 <= r 0%nat -> coulomb d m r u.
Proof.
  intros F M U Z P. split; try lra.
  - rewrite U; lra.
  - rewrite tangential_zero by exact Z. nra.
  - intros t T. rewrite (Z t T). destruct F as [->|E]; [lra | lia].
Qed.

Lemma sum_square_zero n f : sum n (fun t => f t * f t) = 0 -> forall t, (t < n)%nat -> f t = 0.
Proof.
  induction n as [|n IH]; intros E t T; [lia|]. cbn in E.
  assert (A := sum_nonnegative n (fun t => f t * f t) (fun i _ => ltac:(cbv beta; nra))).
  destruct (Nat.eq_dec t n) as [->|D]; [nra|]. apply IH; [nra | lia].
Qed.

Lemma antiparallel L T x : 0 <= L -> 0 <= T -> x <= 0 -> x * x = (L * T) * (L * T) -> x = - (L * T).
Proof.
  intros A B C E. assert (F : (x - L * T) * (x + L * T) = 0) by nra.
  assert (G := Rmult_le_pos _ _ A B). apply Rmult_integral in F. destruct F; lra.
Qed.

Lemma sliding_law d L r u : (1 <= d <= 3)%nat -> 0 <= L -> square_of d r = L * L ->
  sum (d - 1) (fun t => r (S t) * u (S t)) <= 0 -> (d = 3%nat -> r 1%nat * u 2%nat = r 2%nat * u 1%nat) ->
  forall t, (1 <= t < d)%nat -> tangential d u * r t = - L * u t.
Proof.
  intros D A SQ N C t T. set (V := tangential d u).
  assert (V0 : 0 <= V) by apply tangential_nonnegative.
  assert (VV : V * V = square_of d u) by apply tangential_square.
  assert (X : sum (d - 1) (fun t => r (S t) * u (S t)) = - (L * V)).
  { apply antiparallel; auto.
    replace ((L * V) * (L * V)) with ((L * L) * (V * V)) by ring. rewrite VV, <- SQ. clear - D C. unfold square_of.
    destruct d as [|[|[|[|d]]]]; try lia; cbn; try ring. specialize (C eq_refl). nra. }
  assert (Z : sum (d - 1) (fun t => (V * r (S t) + L * u (S t)) * (V * r (S t) + L * u (S t))) = 0).
  { rewrite (sum_ext _ _ (fun t => (V * V) * (r (S t) * r (S t)) + ((2 * (V * L)) * (r (S t) * u (S t))
      + (L * L) * (u (S t) * u (S t))))) by (intros; ring).
    rewrite !sum_plus, !sum_scale, X. fold (square_of d r) (square_of d u). rewrite SQ, <- VV. ring. }
  destruct t as [|t]; [lia|].
  assert (Q := sum_square_zero _ (fun t => V * r (S t) + L * u (S t)) Z t ltac:(lia)). cbv beta in Q. lra.
Qed.

Lemma law_sliding d m r u : (1 <= d <= 3)%nat -> 0 <= m -> 0 <= r 0%nat -> u 0%nat = 0 ->
  square_of d r = (m * r 0%nat) * (m * r 0%nat) -> sum (d - 1) (fun t => r (S t) * u (S t)) <= 0 ->
  (d = 3%nat -> r 1%nat * u 2%nat = r 2%nat * u 1%nat) -> coulomb d m r u.
Proof.
  intros D M P U S N C. assert (L : 0 <= m * r 0%nat) by nra. split; try lra.
  - rewrite U; lra.
  - rewrite (tangential_eq d r (m * r 0%nat)); auto; lra.
  - apply sliding_law; auto.
Qed.

(** The law of exact numbers. *)
Lemma dot_value d (a b : N -> number) :
  value (total (List.map (fun t => mul (a t) (b t)) (range 1 (N.to_nat (d - 1)))))
  = sum (N.to_nat d - 1) (fun t => value (a (N.of_nat (S t))) * value (b (N.of_nat (S t)))).
Proof.
  rewrite total_range. replace (N.to_nat (d - 1)) with (N.to_nat d - 1)%nat by lia.
  apply sum_ext. intros t _. rewrite value_mul. replace (1 + N.of_nat t)%N with (N.of_nat (S t)) by lia. reflexivity.
Qed.

Lemma obeys_law d m r u : (1 <= N.to_nat d <= 3)%nat -> 0 <= value m -> obeys d m r u = true ->
  coulomb (N.to_nat d) (value m) (fun t => value (r (N.of_nat t))) (fun t => value (u (N.of_nat t))).
Proof.
  intros D M H. unfold obeys in H. split_and H.
  apply sign_nonnegative in H. apply sign_nonnegative in H3. apply sign_zero in H2. rewrite value_mul in H2.
  apply le_value in H1. rewrite dot_value in H1. unfold Checker.square in *. rewrite !value_mul in H1.
  set (rr := fun t => value (r (N.of_nat t))) in *. set (uu := fun t => value (u (N.of_nat t))) in *.
  change (value (r 0%N)) with (rr 0%nat) in *. change (value (u 0%N)) with (uu 0%nat) in *.
  change (sum (N.to_nat d - 1) _) with (square_of (N.to_nat d) rr) in H1.
  assert (L : 0 <= value m * rr 0%nat) by nra.
  split; auto; [apply tangential_le; auto|].
  apply orb_prop in H0. destruct H0 as [Z|Z].
  - apply sign_zero in Z. rewrite dot_value in Z.
    assert (U : forall t, (1 <= t < N.to_nat d)%nat -> uu t = 0).
    { intros [|t] T; [lia|]. apply (sum_square_zero (N.to_nat d - 1) (fun t => uu (S t))); [exact Z | lia]. }
    intros t T. rewrite (U t T), tangential_zero by exact U. lra.
  - split_and Z. apply eq_value in Z. rewrite dot_value, !value_mul in Z.
    apply sign_nonnegative in H4. rewrite value_opp, dot_value in H4.
    apply sliding_law; auto.
    + match type of H4 with 0 <= - ?x => assert (Q : x <= 0) by lra end. exact Q.
    + intros E. apply orb_prop in H0. destruct H0 as [F|F]; [apply N.ltb_lt in F; lia|].
      apply eq_value in F. rewrite !value_mul in F. exact F.
Qed.
