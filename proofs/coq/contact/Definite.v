(** A complementarity problem with a positive definite matrix has one solution: a projection is a contraction in the
    Euclidean norm. *)
From Coq Require Import Reals Lra Lia Psatz.
From Slipproof.contact Require Import Coulomb Number Fixed Linear Law Unique.
Local Open Scope R_scope.

Lemma sum_le n f g : (forall i, (i < n)%nat -> f i <= g i) -> sum n f <= sum n g.
Proof. induction n as [|n IH]; intros L; cbn; [lra|]. apply Rplus_le_compat; auto. Qed.

Lemma sum_exchange n m f : sum n (fun i => sum m (fun j => f i j)) = sum m (fun j => sum n (fun i => f i j)).
Proof.
  induction n as [|n IH]; cbn.
  - rewrite sum_zero; [reflexivity|]. reflexivity.
  - rewrite IH, <- sum_plus. reflexivity.
Qed.

Lemma sum_member n f i : (forall j, (j < n)%nat -> 0 <= f j) -> (i < n)%nat -> f i <= sum n f.
Proof.
  induction n as [|n IH]; intros P L; [lia|]. cbn. assert (Q := P n ltac:(lia)).
  assert (S := sum_nonnegative n f (fun j J => P j ltac:(lia))).
  destruct (Nat.eq_dec i n) as [->|D]; [lra|]. assert (A := IH (fun j J => P j ltac:(lia)) ltac:(lia)). lra.
Qed.

Lemma cauchy_schwarz n a z : sum n (fun i => a i * z i) * sum n (fun i => a i * z i)
  <= sum n (fun i => a i * a i) * sum n (fun i => z i * z i).
Proof.
  induction n as [|n IH]; cbn; [lra|].
  assert (P := sum_nonnegative n (fun i => a i * a i) (fun i _ => ltac:(cbv beta; nra))).
  assert (Q := sum_nonnegative n (fun i => z i * z i) (fun i _ => ltac:(cbv beta; nra))).
  set (s := sum n (fun i => a i * z i)) in *. set (b := sum n (fun i => a i * a i)) in *.
  set (c := sum n (fun i => z i * z i)) in *. set (x := a n) in *. set (y := z n) in *.
  assert (E : 2 * s * x * y <= b * (y * y) + c * (x * x)).
  { apply Rsqr_incr_0_var; [|nra]. unfold Rsqr.
    assert (F : s * s * ((x * y) * (x * y)) <= b * c * ((x * y) * (x * y))) by (apply Rmult_le_compat_r; [nra | exact IH]).
    assert (G := Rle_0_sqr (b * (y * y) - c * (x * x))). unfold Rsqr in G. lra. }
  lra.
Qed.

(** Steps that shrink like powers make a Cauchy sequence. *)
Lemma geometric_cauchy u C q : 0 <= C -> 0 <= q < 1 -> (forall n, Rabs (u (S n) - u n) <= C * q ^ n) -> Cauchy_crit u.
Proof.
  intros C0 Q B. set (t := fun n => C * (1 - q ^ n) / (1 - q)).
  assert (Step : forall n, t (S n) - t n = C * q ^ n) by (intros n; unfold t; cbn; field; lra).
  assert (P : forall n, 0 <= q ^ n) by (intros n; apply pow_le; lra).
  assert (Apart : forall n m, (n <= m)%nat -> Rabs (u m - u n) <= t m - t n).
  { induction 1 as [|m _ IH].
    - replace (u n - u n) with 0 by lra. rewrite Rabs_R0. lra.
    - replace (u (S m) - u n) with ((u (S m) - u m) + (u m - u n)) by lra.
      eapply Rle_trans; [apply Rabs_triang|]. specialize (B m). specialize (Step m). lra. }
  destruct (growing_cv t) as [l L].
  - intros n. specialize (Step n). specialize (P n). nra.
  - exists (C / (1 - q)). intros x [n ->]. unfold t. apply Rmult_le_compat_r; [apply Rlt_le, Rinv_0_lt_compat; lra|].
    specialize (P n). nra.
  - intros e E. destruct (CV_Cauchy _ (exist _ l L) e E) as [k K]. exists k. intros n m N M.
    specialize (K n m N M). unfold R_dist in *. destruct (Nat.le_ge_cases n m) as [H|H].
    + rewrite Rabs_minus_sym. eapply Rle_lt_trans; [apply Apart, H|].
      eapply Rle_lt_trans; [apply Rle_abs|]. rewrite Rabs_minus_sym. exact K.
    + eapply Rle_lt_trans; [apply Apart, H|]. eapply Rle_lt_trans; [apply Rle_abs | exact K].
Qed.

Lemma cut_close a b : Rabs (Rmax a 0 - Rmax b 0) <= Rabs (a - b).
Proof. unfold Rmax. destruct (Rle_dec a 0), (Rle_dec b 0); unfold Rabs; repeat destruct Rcase_abs; lra. Qed.

Lemma square_abs x : Rabs x * Rabs x = x * x.
Proof. unfold Rabs. destruct Rcase_abs; ring. Qed.

Section Definite.
  Variables (n : nat) (A : nat -> nat -> R) (alpha : R).
  Hypothesis alpha_pos : 0 < alpha.
  Hypothesis definite : forall z, alpha * sum n (fun i => z i * z i) <= sum n (fun i => z i * sum n (fun j => A i j * z j)).

  Section Constant.
    Variable c : nat -> R.
    Let w (z : nat -> R) (i : nat) : R := sum n (fun j => A i j * z j) + c i.
    Let big := sum n (fun i => sum n (fun j => A i j * A i j)).
    Let t := alpha / (alpha * alpha + big).
    Let T (z : nat -> R) (i : nat) : R := Rmax (z i - t * w z i) 0.
    Let rate := 1 - alpha * alpha / (alpha * alpha + big).
    Let q := (1 + rate) / 2.

    Lemma big_nonnegative : 0 <= big.
    Proof. apply sum_nonnegative. intros i _. apply sum_nonnegative. intros; nra. Qed.

    Lemma t_positive : 0 < t.
    Proof. assert (B := big_nonnegative). apply Rmult_lt_0_compat; [exact alpha_pos|]. apply Rinv_0_lt_compat. nra. Qed.

    Lemma rate_size : 0 <= rate < 1.
    Proof.
      assert (B := big_nonnegative). unfold rate.
      assert (D : 0 < alpha * alpha + big) by nra.
      assert (0 < alpha * alpha / (alpha * alpha + big)) by (apply Rmult_lt_0_compat; [nra | apply Rinv_0_lt_compat, D]).
      assert (alpha * alpha / (alpha * alpha + big) <= 1).
      { apply Rmult_le_reg_r with (alpha * alpha + big); [exact D|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra. }
      lra.
    Qed.

    Lemma contraction x y :
      sum n (fun i => (T x i - T y i) * (T x i - T y i)) <= rate * sum n (fun i => (x i - y i) * (x i - y i)).
    Proof.
      set (e := fun i => x i - y i). set (Ae := fun i => sum n (fun j => A i j * e j)).
      assert (D : forall i, w x i - w y i = Ae i).
      { intros i. unfold w, Ae, e. rewrite (sum_ext _ (fun j => A i j * (x j - y j)) (fun j => A i j * x j + (-1) * (A i j * y j)))
          by (intros; ring). rewrite sum_plus, sum_scale. ring. }
      apply Rle_trans with (sum n (fun i => (e i - t * Ae i) * (e i - t * Ae i))).
      - apply sum_le. intros i _. rewrite <- (square_abs (T x i - T y i)), <- (square_abs (e i - t * Ae i)).
        assert (L : Rabs (T x i - T y i) <= Rabs (e i - t * Ae i)).
        { unfold T. eapply Rle_trans; [apply cut_close|]. apply Req_le. f_equal. rewrite <- D. unfold e. ring. }
        apply Rmult_le_compat; auto using Rabs_pos.
      - rewrite (sum_ext _ _ (fun i => e i * e i + ((- 2 * t) * (e i * Ae i) + (t * t) * (Ae i * Ae i)))) by (intros; ring).
        rewrite !sum_plus, !sum_scale.
        assert (P : alpha * sum n (fun i => e i * e i) <= sum n (fun i => e i * Ae i)) by apply definite.
        set (E := sum n (fun i => e i * e i)) in *.
        assert (Q : sum n (fun i => Ae i * Ae i) <= big * E).
        { unfold big. rewrite <- (Rmult_comm E), <- sum_scale. apply sum_le. intros i _.
          eapply Rle_trans; [apply cauchy_schwarz|]. apply Req_le. apply Rmult_comm. }
        assert (E0 : 0 <= E) by (apply sum_nonnegative; intros; nra).
        assert (B := big_nonnegative). assert (T0 := t_positive).
        assert (R1 : -2 * t * sum n (fun i => e i * Ae i) <= -2 * t * (alpha * E)) by nra.
        assert (R2 : t * t * sum n (fun i => Ae i * Ae i) <= t * t * (big * E)) by (apply Rmult_le_compat_l; nra).
        change (sum n (fun i => (x i - y i) * (x i - y i))) with E.
        assert (S : 1 - 2 * t * alpha + t * t * big <= rate).
        { unfold rate, t. set (m := alpha * alpha + big). assert (M : 0 < m) by (unfold m; nra).
          replace big with (m - alpha * alpha) by (unfold m; ring).
          replace (1 - 2 * (alpha / m) * alpha + alpha / m * (alpha / m) * (m - alpha * alpha))
            with (1 - alpha * alpha / m - (alpha * alpha / m) * (alpha * alpha / m)) by (field; lra).
          assert (0 <= (alpha * alpha / m) * (alpha * alpha / m)) by nra. lra. }
        apply (Rmult_le_compat_r E) in S; [|exact E0]. nra.
    Qed.

    Fixpoint steps (k : nat) : nat -> R := match k with O => fun _ => 0 | S m => T (steps m) end.

    Lemma steps_shrink : exists C, 0 <= C /\ forall k i, (i < n)%nat -> Rabs (steps (S k) i - steps k i) <= C * q ^ k.
    Proof.
      set (D := fun k => sum n (fun i => (steps (S k) i - steps k i) * (steps (S k) i - steps k i))).
      assert (R := rate_size).
      assert (D0 : forall k, 0 <= D k) by (intros k; apply sum_nonnegative; intros j _; exact (Rle_0_sqr _)).
      assert (Q : 0 <= q /\ rate <= q * q).
      { unfold q. split; [lra|]. assert (0 <= ((1 - rate) / 2) * ((1 - rate) / 2)) by nra. nra. }
      assert (B : forall k, D k <= (q ^ k * q ^ k) * D 0%nat).
      { induction k as [|k IH]; [cbn [pow]; lra|].
        apply Rle_trans with (rate * D k); [apply contraction|].
        cbn [pow]. assert (D00 := D0 0%nat). specialize (D0 k). assert (P : 0 <= q ^ k * q ^ k) by nra.
        apply Rle_trans with ((q * q) * D k); [apply Rmult_le_compat_r; lra|].
        replace (q * q ^ k * (q * q ^ k) * D 0%nat) with (q * q * (q ^ k * q ^ k * D 0%nat)) by ring.
        apply Rmult_le_compat_l; [nra | exact IH]. }
      exists (1 + D 0%nat). assert (D00 := D0 0%nat). split; [lra|]. intros k i I.
      assert (P : 0 <= q ^ k) by (apply pow_le; lra).
      apply Rsqr_incr_0_var; [|nra]. unfold Rsqr. rewrite square_abs.
      apply Rle_trans with (D k).
      - apply (sum_member n (fun i => (steps (S k) i - steps k i) * (steps (S k) i - steps k i))); [intros; nra | exact I].
      - eapply Rle_trans; [apply B|]. assert (PP : 0 <= q ^ k * q ^ k) by nra.
        replace ((1 + D 0%nat) * q ^ k * ((1 + D 0%nat) * q ^ k)) with (q ^ k * q ^ k * ((1 + D 0%nat) * (1 + D 0%nat))) by ring.
        apply Rmult_le_compat_l; [exact PP | nra].
    Qed.

    Lemma complementary_exists : exists z, forall i, (i < n)%nat -> 0 <= z i /\ 0 <= w z i /\ z i * w z i = 0.
    Proof.
      destruct steps_shrink as [C [C0 B]].
      assert (Q : 0 <= q < 1) by (assert (R := rate_size); unfold q; lra).
      assert (Ch : forall i, (i < n)%nat -> Cauchy_crit (fun k => steps k i)).
      { intros i I. apply geometric_cauchy with C q; [exact C0 | exact Q | intros k; apply B, I]. }
      pose (z := fun i => match Compare_dec.lt_dec i n with left I => proj1_sig (R_complete _ (Ch i I)) | right _ => 0 end).
      assert (Z : forall i, (i < n)%nat -> Un_cv (fun k => steps k i) (z i)).
      { intros i I. unfold z. destruct (Compare_dec.lt_dec i n) as [J|J]; [|contradiction].
        apply (proj2_sig (R_complete _ (Ch i J))). }
      exists z. intros i I.
      assert (W : Un_cv (fun k => w (steps k) i) (w z i)).
      { unfold w. apply (CV_plus (fun k => sum n (fun j => A i j * steps k j)) (fun _ => c i)); [|apply Un_cv_const].
        assert (G : forall m, (m <= n)%nat -> Un_cv (fun k => sum m (fun j => A i j * steps k j)) (sum m (fun j => A i j * z j))).
        { induction m as [|m IH]; intros M; cbn [sum]; [apply Un_cv_const|].
          apply (CV_plus (fun k => sum m (fun j => A i j * steps k j)) (fun k => A i m * steps k m)); [apply IH; lia|].
          apply (CV_mult (fun _ => A i m) (fun k => steps k m)); [apply Un_cv_const | apply Z; lia]. }
        apply G. lia. }
      assert (F : z i = T z i).
      { apply UL_sequence with (fun k => steps (S k) i).
        - intros e E. destruct (Z i I e E) as [m M]. exists m. intros k K. apply M. lia.
        - assert (V : Un_cv (fun k => steps k i - t * w (steps k) i) (z i - t * w z i)).
          { apply (CV_minus (fun k => steps k i) (fun k => t * w (steps k) i)); [apply Z, I|].
            apply (CV_mult (fun _ => t) (fun k => w (steps k) i)); [apply Un_cv_const | exact W]. }
          intros e E. destruct (V e E) as [m M]. exists m. intros k K. specialize (M k K). unfold R_dist in *.
          eapply Rle_lt_trans; [apply cut_close | exact M]. }
      assert (T0 := t_positive).
      apply (complementary_fixed (/ t)); [apply Rinv_0_lt_compat, T0|].
      replace (w z i / / t) with (t * w z i) by (field; lra). exact F.
    Qed.

    Lemma complementary_unique x y :
      (forall i, (i < n)%nat -> 0 <= x i /\ 0 <= w x i /\ x i * w x i = 0) ->
      (forall i, (i < n)%nat -> 0 <= y i /\ 0 <= w y i /\ y i * w y i = 0) -> forall i, (i < n)%nat -> y i = x i.
    Proof.
      intros X Y i I. pose (e := fun i => y i - x i).
      assert (P := definite e).
      assert (N : sum n (fun i => e i * sum n (fun j => A i j * e j)) <= 0).
      { apply Ropp_le_cancel. rewrite Ropp_0.
        replace (- sum n (fun i => e i * sum n (fun j => A i j * e j)))
          with (sum n (fun i => (-1) * (e i * sum n (fun j => A i j * e j)))) by (rewrite sum_scale; ring).
        apply sum_nonnegative. intros j J. destruct (X j J) as [X1 [X2 X3]]. destruct (Y j J) as [Y1 [Y2 Y3]].
        assert (D : sum n (fun k => A j k * e k) = w y j - w x j).
        { unfold w, e. rewrite (sum_ext _ (fun k => A j k * (y k - x k)) (fun k => A j k * y k + (-1) * (A j k * x k)))
            by (intros; ring). rewrite sum_plus, sum_scale. ring. }
        rewrite D. unfold e. assert (0 <= y j * w x j) by nra. assert (0 <= x j * w y j) by nra. nra. }
      assert (S := sum_nonnegative n (fun i => e i * e i) (fun i _ => ltac:(cbv beta; nra))).
      assert (S0 : sum n (fun i => e i * e i) = 0) by nra.
      assert (E := sum_square_zero n e S0 i I). unfold e in E. lra.
    Qed.
  End Constant.
End Definite.

(** Gershgorin's bound of a quadratic form. *)
Lemma dominant_form n (M : nat -> nat -> R) alpha : (forall i j, M i j = M j i) ->
  (forall i, (i < n)%nat -> sum n (fun j => if Nat.eq_dec j i then 0 else Rabs (M i j)) + alpha <= M i i) ->
  forall z, alpha * sum n (fun i => z i * z i) <= sum n (fun i => z i * sum n (fun j => M i j * z j)).
Proof.
  intros Sym Dom z.
  set (o := fun i j => if Nat.eq_dec j i then 0 else Rabs (M i j)).
  assert (Sym' : forall i j, o i j = o j i).
  { intros i j. unfold o. destruct (Nat.eq_dec j i), (Nat.eq_dec i j); try congruence. rewrite Sym. reflexivity. }
  (* z_i M_ij z_j >= - o_ij (z_i^2 + z_j^2) / 2, off the diagonal *)
  apply Rle_trans with (sum n (fun i => sum n (fun j => (if Nat.eq_dec j i then M i i * (z i * z i) else 0)
    + ((- / 2) * (o i j * (z i * z i)) + (- / 2) * (o i j * (z j * z j)))))).
  - assert (E1 : sum n (fun i => sum n (fun j => o i j * (z j * z j))) = sum n (fun i => sum n (fun j => o i j * (z i * z i)))).
    { rewrite sum_exchange. apply sum_ext. intros i _. apply sum_ext. intros j _. rewrite Sym'. reflexivity. }
    assert (E2 : sum n (fun i => sum n (fun j => (if Nat.eq_dec j i then M i i * (z i * z i) else 0)))
      = sum n (fun i => M i i * (z i * z i))).
    { apply sum_ext. intros i I. rewrite (sum_single _ i); [|exact I|].
      - destruct (Nat.eq_dec i i); [reflexivity | contradiction].
      - intros j _ D. destruct (Nat.eq_dec j i); [contradiction | reflexivity]. }
    rewrite (sum_ext n (fun i => sum n (fun j => (if Nat.eq_dec j i then M i i * (z i * z i) else 0)
        + ((- / 2) * (o i j * (z i * z i)) + (- / 2) * (o i j * (z j * z j)))))
      (fun i => sum n (fun j => if Nat.eq_dec j i then M i i * (z i * z i) else 0)
        + ((- / 2) * sum n (fun j => o i j * (z i * z i)) + (- / 2) * sum n (fun j => o i j * (z j * z j))))).
    2: { intros i _. rewrite !sum_plus, !sum_scale. reflexivity. }
    rewrite !sum_plus, !sum_scale, E1, E2.
    replace (- / 2 * sum n (fun i => sum n (fun j => o i j * (z i * z i)))
        + - / 2 * sum n (fun i => sum n (fun j => o i j * (z i * z i))))
      with ((-1) * sum n (fun i => sum n (fun j => o i j * (z i * z i)))) by lra.
    rewrite <- !sum_scale, <- sum_plus. apply sum_le. intros i I. specialize (Dom i I). fold (o i) in Dom.
    rewrite (sum_ext n (fun j => o i j * (z i * z i)) (fun j => (z i * z i) * o i j)) by (intros; ring).
    rewrite sum_scale. assert (Q : 0 <= z i * z i) by nra.
    change (sum n (fun j => if Nat.eq_dec j i then 0 else Rabs (M i j))) with (sum n (o i)) in Dom.
    change (sum n (fun j => o i j)) with (sum n (o i)). nra.
  - apply sum_le. intros i _. rewrite <- sum_scale. apply sum_le. intros j _. unfold o.
    destruct (Nat.eq_dec j i) as [->|D]; [lra|].
    assert (H : - (Rabs (M i j) * (z i * z i + z j * z j)) <= 2 * (M i j * (z i * z j))).
    { assert (B1 := Rle_0_sqr (z i - z j)). assert (B2 := Rle_0_sqr (z i + z j)). unfold Rsqr in B1, B2.
      unfold Rabs. destruct Rcase_abs; nra. }
    lra.
Qed.
