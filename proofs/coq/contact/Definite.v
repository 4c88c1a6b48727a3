(** A complementarity problem with a positive definite matrix has one solution: a projection is a contraction in the
    Euclidean norm. *)
From Coq Require Import NArith Reals List Bool Lra Lia Psatz.
From Slipproof.contact Require Import Coulomb Number Fixed Linear Zero Certificate Checker Rows Law Enclose Unique.
Import ListNotations.
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
      - apply (sum_member n (fun i => (steps (S k) i - steps k i) * (steps (S k) i - steps k i))); [intros j _; exact (Rle_0_sqr _) | exact I].
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
      pose (z := fun i => match Compare_dec.lt_dec i n with left L => proj1_sig (R_complete _ (Ch i L)) | right _ => 0 end).
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
  { intros i j. unfold o. destruct (Nat.eq_dec j i), (Nat.eq_dec i j); congruence. }
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

Lemma positive_bound n (f : nat -> R) : (forall i, (i < n)%nat -> 0 < f i) ->
  exists a, 0 < a /\ forall i, (i < n)%nat -> a <= f i.
Proof.
  induction n as [|n IH]; intros P; [exists 1; split; [lra | intros; lia]|].
  destruct IH as [a [A B]]; [intros; apply P; lia|]. assert (Q := P n ltac:(lia)).
  exists (Rmin a (f n)). split; [unfold Rmin; destruct Rle_dec; assumption|].
  intros i I. destruct (Nat.eq_dec i n) as [->|D]; [apply Rmin_r|].
  eapply Rle_trans; [apply Rmin_l | apply B; lia].
Qed.

Lemma entry_transposed l i j : entry (transposed l) i j = entry l j i.
Proof.
  unfold entry, transposed. induction l as [|[[k m] a] l IH]; cbn [map fold_right]; [reflexivity|].
  rewrite IH, andb_comm. reflexivity.
Qed.

Section Instance.
  Variable i : instance.
  Hypothesis whole : is_whole i = true.
  Hypothesis fine : is_proper i = true.
  Let p := tables_of i.
  Let P := problem_of i.
  Variable factor : list (N * N * number).
  Hypothesis checked : check_definite p (entries i) factor = true.
  Let n := size P.
  Let A := matrix P.
  Let l := entry factor.

  Lemma one_dimension : free P = 0%nat /\ dimension P = 1%nat /\ n = contacts P /\ N.to_nat (t_size p) = n.
  Proof.
    assert (C := checked). unfold check_definite in C. split_and C. apply N.eqb_eq in C. apply N.eqb_eq in H1.
    assert (F : free P = 0%nat) by (unfold P, problem_of; cbn; change (frees i) with (t_frees p); lia).
    assert (D : dimension P = 1%nat) by (unfold P, problem_of; cbn; change (dim i) with (t_dim p); lia).
    split; [exact F|]. split; [exact D|]. split; [unfold n, size; rewrite F, D; lia | apply size_is].
  Qed.

  Lemma factor_columns : Forall (fun e => match e with (_, m, _) => (N.to_nat m < n)%nat end) factor /\
    Forall (fun e => match e with (_, m, _) => (N.to_nat m < n)%nat end) (transposed factor).
  Proof.
    destruct one_dimension as [_ [_ [_ S]]]. assert (C := checked). unfold check_definite in C. split_and C.
    rewrite forallb_forall in H0. split; apply Forall_forall.
    - intros [[k m] a] I. specialize (H0 _ I). cbv beta iota in H0. apply andb_prop in H0. destruct H0 as [B D].
      apply N.ltb_lt in B. apply N.leb_le in D. lia.
    - intros [[k m] a] I. unfold transposed in I. apply in_map_iff in I. destruct I as [[[k' m'] a'] [E I]].
      inversion E; subst. specialize (H0 _ I). cbv beta iota in H0. apply andb_prop in H0. destruct H0 as [B _].
      apply N.ltb_lt in B. lia.
  Qed.

  Definition rest (j k : nat) : R := A j k + A k j - sum n (fun m => l j m * l k m).

  Lemma columns_value j v : apply (look [] (by_rows (transposed (entries i))) (N.of_nat j)) v
    = sum n (fun k => A k j * v (N.of_nat k)).
  Proof.
    rewrite by_rows_value, (row_sum_entries n).
    - apply sum_ext. intros k _. rewrite entry_transposed. reflexivity.
    - assert (W := whole). unfold is_whole in W. split_and W. rewrite forallb_forall in H0.
      apply Forall_forall. intros [[k m] a] I. unfold transposed in I. apply in_map_iff in I.
      destruct I as [[[k' m'] a'] [E I]]. inversion E; subst. specialize (H0 _ I). cbv beta iota in H0.
      apply andb_prop in H0. destruct H0 as [B _]. apply N.ltb_lt in B. unfold n, P.
      assert (S := size_is i). change (size_of_instance i) with (t_size (tables_of i)) in B. lia.
  Qed.

  Lemma rest_value j k : (k < n)%nat ->
    value (get (remainder_row p (by_rows (transposed (entries i))) (by_rows factor) (by_rows (transposed factor)) (N.of_nat j))
      (N.of_nat k)) = rest j k.
  Proof.
    intros K. destruct one_dimension as [_ [_ [_ S]]]. set (left := range 0 n).
    assert (J : In (N.of_nat k) left) by (apply range_In; lia).
    pose (unit := fun m : N => if N.eq_dec m (N.of_nat k) then 1 else 0).
    assert (U : forall m, ~ In m left -> unit m = 0).
    { intros m M. unfold unit. destruct (N.eq_dec m (N.of_nat k)) as [->|]; [contradiction | reflexivity]. }
    assert (U' : forall m, unit (N.of_nat m) = if Nat.eq_dec m k then 1 else 0).
    { intros m. unfold unit. destruct (N.eq_dec (N.of_nat m) (N.of_nat k)), (Nat.eq_dec m k); try reflexivity; lia. }
    assert (One : forall f, sum n (fun m => f m * unit (N.of_nat m)) = f k).
    { intros f. rewrite (sum_single _ k); [|exact K|].
      - rewrite U'. destruct (Nat.eq_dec k k); [lra | contradiction].
      - intros m _ M. rewrite U'. destruct (Nat.eq_dec m k); [contradiction | lra]. }
    set (m := remainder_row _ _ _ _ _).
    assert (Q : sum_over left (fun c => value (get m c) * unit c) = value (get m (N.of_nat k))).
    { rewrite (sum_over_changed left (N.of_nat k) (value (get m (N.of_nat k))) _ (fun _ => 0) (range_NoDup _ _) J).
      - rewrite (sum_over_zero left (fun _ => 0)) by reflexivity. lra.
      - intros c C. unfold unit. destruct (N.eq_dec c (N.of_nat k)); [contradiction | lra].
      - unfold unit. destruct (N.eq_dec (N.of_nat k) (N.of_nat k)); [lra | contradiction]. }
    rewrite <- Q. unfold m, remainder_row.
    assert (G : forall r t, sum_over left (fun c => value (get (List.fold_left (fun m e =>
        accumulate m (opp (snd e)) (look [] (by_rows (transposed factor)) (fst e))) r t) c) * unit c)
      = sum_over left (fun c => value (get t c) * unit c)
        - apply r (fun c => apply (look [] (by_rows (transposed factor)) c) unit)).
    { induction r as [|[c a] r IH]; intros t; cbn [List.fold_left apply fst snd]; [lra|].
      rewrite IH, accumulate_value, value_opp by (apply range_NoDup || exact U). lra. }
    rewrite G, !accumulate_value by (apply range_NoDup || exact U).
    rewrite (sum_over_zero left (fun c => value (get empty c) * unit c)) by (intros; rewrite get_empty, value_zero; lra).
    cbn [linear_part row]. unfold p. rewrite (row_linear i whole), columns_value. fold P n A. rewrite !One, value_one.
    destruct factor_columns as [F1 F2].
    rewrite by_rows_value, (row_sum_entries n _ _ _ F1).
    unfold rest. fold l. rewrite Rplus_0_l, !Rmult_1_l. f_equal. apply sum_ext. intros c _. f_equal.
    rewrite by_rows_value, (row_sum_entries n _ _ _ F2), One. apply entry_transposed.
  Qed.

  Lemma definite_matrix : exists alpha, 0 < alpha /\
    forall z, alpha * sum n (fun j => z j * z j) <= sum n (fun j => z j * sum n (fun k => A j k * z k)).
  Proof.
    destruct one_dimension as [_ [_ [_ S]]].
    set (others := fun j => sum n (fun k => if Nat.eq_dec k j then 0 else Rabs (rest j k))).
    destruct (positive_bound n (fun j => rest j j - others j)) as [a [A0 B]].
    - intros j J. assert (C := checked). unfold check_definite in C. split_and C. rewrite forallb_forall in H.
      assert (I : In (N.of_nat j) (range 0 (N.to_nat (t_size p)))) by (apply range_In; lia).
      specialize (H _ I). cbv zeta in H. apply lt_value in H. rewrite (rest_value j j J), total_range, S in H.
      enough (E : others j = sum n (fun t => value (if N.eqb (0 + N.of_nat t) (N.of_nat j) then zero else
        abs (get (remainder_row p (by_rows (transposed (entries i))) (by_rows factor) (by_rows (transposed factor)) (N.of_nat j))
          (0 + N.of_nat t))))) by lra.
      apply sum_ext. intros t T. cbn [N.add]. destruct (N.eqb_spec (N.of_nat t) (N.of_nat j)) as [E|E], (Nat.eq_dec t j); try lia.
      + rewrite value_zero. reflexivity.
      + rewrite value_abs, rest_value by exact T. reflexivity.
    - exists (a / 2). split; [lra|]. intros z.
      assert (D := dominant_form n rest a).
      assert (E : a * sum n (fun j => z j * z j) <= sum n (fun j => z j * sum n (fun k => rest j k * z k))).
      { apply D.
        - intros j k. unfold rest. rewrite (sum_ext _ (fun m => l j m * l k m) (fun m => l k m * l j m)) by (intros; ring). ring.
        - intros j J. specialize (B j J). cbv beta in B. fold (others j). lra. }
      assert (T : sum n (fun j => z j * sum n (fun k => A k j * z k)) = sum n (fun j => z j * sum n (fun k => A j k * z k))).
      { rewrite (sum_ext _ _ (fun j => sum n (fun k => A k j * z k * z j))).
        - rewrite sum_exchange. apply sum_ext. intros k _. rewrite <- sum_scale. apply sum_ext. intros j _. ring.
        - intros j _. rewrite <- sum_scale. apply sum_ext. intros k _. ring. }
      assert (V : sum n (fun j => z j * sum n (fun k => rest j k * z k))
        = 2 * sum n (fun j => z j * sum n (fun k => A j k * z k))
          - sum n (fun m => sum n (fun j => l j m * z j) * sum n (fun j => l j m * z j))).
      { replace (2 * sum n (fun j => z j * sum n (fun k => A j k * z k))) with
          (sum n (fun j => z j * sum n (fun k => A j k * z k)) + sum n (fun j => z j * sum n (fun k => A k j * z k)))
          by (rewrite T; ring).
        assert (X : sum n (fun m => sum n (fun j => l j m * z j) * sum n (fun j => l j m * z j))
          = sum n (fun j => z j * sum n (fun k => sum n (fun m => l j m * l k m) * z k))).
        { rewrite (sum_ext n (fun m => sum n (fun j => l j m * z j) * sum n (fun j => l j m * z j))
            (fun m => sum n (fun j => z j * (l j m * sum n (fun k => l k m * z k))))).
          - rewrite sum_exchange. apply sum_ext. intros j _. rewrite sum_scale. f_equal.
            rewrite (sum_ext n (fun k => sum n (fun m => l j m * l k m) * z k) (fun k => sum n (fun m => l j m * l k m * z k))).
            + rewrite sum_exchange. apply sum_ext. intros m _. rewrite <- sum_scale. apply sum_ext. intros k _. ring.
            + intros k _. rewrite Rmult_comm, <- sum_scale. apply sum_ext. intros m _. ring.
          - intros m _. set (s := sum n (fun k => l k m * z k)). transitivity (s * sum n (fun j => l j m * z j)); [reflexivity|].
            rewrite <- sum_scale. apply sum_ext. intros j _. ring. }
        rewrite X, <- sum_plus. unfold Rminus. rewrite <- (Rmult_1_l (sum n (fun j => z j * sum n (fun k => sum n _ * z k)))).
        rewrite Ropp_mult_distr_l, <- sum_scale, <- sum_plus. apply sum_ext. intros j _.
        rewrite (sum_ext _ (fun k => rest j k * z k) (fun k => A j k * z k + (A k j * z k + (-1) * (sum n (fun m => l j m * l k m) * z k))))
          by (intros; unfold rest; ring).
        rewrite !sum_plus, sum_scale. ring. }
      assert (Q := sum_nonnegative n (fun m => sum n (fun j => l j m * z j) * sum n (fun j => l j m * z j))
        (fun m _ => Rle_0_sqr _)).
      rewrite V in E. lra.
  Qed.

  Lemma solution_complementary c x : solution (with_constant P c) x <->
    forall k, (k < n)%nat -> 0 <= x k /\ 0 <= sum n (fun j => A k j * x j) + c k /\ x k * (sum n (fun j => A k j * x j) + c k) = 0.
  Proof.
    destruct one_dimension as [F [D [S _]]].
    assert (X : forall k, (k < n)%nat ->
      (coulomb (dimension P) (friction P k) (of_contact (with_constant P c) k x)
         (of_contact (with_constant P c) k (motion (with_constant P c) x))
       <-> 0 <= x k /\ 0 <= sum n (fun j => A k j * x j) + c k /\ x k * (sum n (fun j => A k j * x j) + c k) = 0)).
    { intros k K. rewrite D, law_in_one_dimension.
      - unfold of_contact. change (free (with_constant P c)) with (free P).
        change (dimension (with_constant P c)) with (dimension P). rewrite F, D.
        replace (0 + 1 * k + 0)%nat with k by lia. reflexivity.
      - apply (friction_is i fine); [rewrite S in K; exact K|]. unfold P, problem_of in D; cbn in D. lia. }
    split.
    - intros [_ L] k K. apply (X k K), L. change (contacts (with_constant P c)) with (contacts P). rewrite <- S. exact K.
    - intros E. split.
      + intros j J. change (free (with_constant P c)) with (free P) in J. lia.
      + intros k K. change (contacts (with_constant P c)) with (contacts P) in K. rewrite <- S in K. apply (X k K), E, K.
  Qed.

  Theorem check_definite_sound : unique P.
  Proof.
    intros c. destruct definite_matrix as [alpha [A0 B]].
    destruct (complementary_exists n A alpha A0 B c) as [x X]. exists x. split; [apply solution_complementary, X|].
    intros y Y. assert (Z := proj1 (solution_complementary c y) Y). exact (complementary_unique n A alpha A0 B c x y X Z).
  Qed.
End Instance.
