(** A zero of quadratic equations in a ball, by a bound on the least singular value of their derivative (FORMAT.md, `ball`). *)
From Coq Require Import NArith Reals List Bool Lra Lia Psatz FMapPositive FunctionalExtensionality.
From Slipproof.contact Require Import Coulomb Number Fixed Linear Zero Certificate Checker Rows Law Enclose Unique Definite.
Import ListNotations.
Local Open Scope R_scope.

Definition norm2 (n : nat) (y : nat -> R) : R := sum n (fun i => y i * y i).

Lemma norm2_nonnegative n y : 0 <= norm2 n y.
Proof. apply sum_nonnegative. intros i _. exact (Rle_0_sqr _). Qed.

Lemma component_below n y i : (i < n)%nat -> y i * y i <= norm2 n y.
Proof. intros I. apply (sum_member n (fun i => y i * y i)); [intros j _; exact (Rle_0_sqr _) | exact I]. Qed.

(** |a + b| <= |a| + |b| *)
Lemma norm2_plus n a b s t : 0 <= s -> 0 <= t -> norm2 n a <= s * s -> norm2 n b <= t * t ->
  norm2 n (fun i => a i + b i) <= (s + t) * (s + t).
Proof.
  intros S T A B. unfold norm2.
  rewrite (sum_ext _ _ (fun i => a i * a i + (2 * (a i * b i) + b i * b i))) by (intros; ring).
  rewrite !sum_plus, sum_scale. fold (norm2 n a) (norm2 n b).
  assert (C := cauchy_schwarz n a b). fold (norm2 n a) (norm2 n b) in C. set (x := sum n (fun i => a i * b i)) in *.
  assert (X : x <= s * t).
  { apply Rsqr_incr_0_var; [|nra]. unfold Rsqr. eapply Rle_trans; [exact C|].
    replace (s * t * (s * t)) with ((s * s) * (t * t)) by ring.
    apply Rmult_le_compat; auto using norm2_nonnegative. }
  lra.
Qed.

(** A contraction of the unit ball has a fixed point. *)
Section Contraction.
  Variables (n : nat) (T : (nat -> R) -> nat -> R) (rate : R).
  Hypothesis rate_size : 0 <= rate < 1.
  Hypothesis inside : forall y, norm2 n y <= 1 -> norm2 n (T y) <= 1.
  Hypothesis contracts : forall x y, norm2 n x <= 1 -> norm2 n y <= 1 ->
    norm2 n (fun i => T x i - T y i) <= rate * norm2 n (fun i => x i - y i).

  Fixpoint orbit (k : nat) : nat -> R := match k with O => fun _ => 0 | S m => T (orbit m) end.
  Let q := (1 + rate) / 2.

  Lemma orbit_inside k : norm2 n (orbit k) <= 1.
  Proof.
    induction k as [|k IH]; [|apply inside, IH]. unfold norm2. rewrite sum_zero; [lra|]. intros; cbn; ring.
  Qed.

  Lemma orbit_shrinks : exists C, 0 <= C /\ forall k i, (i < n)%nat -> Rabs (orbit (S k) i - orbit k i) <= C * q ^ k.
  Proof.
    set (D := fun k => norm2 n (fun i => orbit (S k) i - orbit k i)).
    assert (D0 : forall k, 0 <= D k) by (intros k; apply norm2_nonnegative).
    assert (Q : 0 <= q /\ rate <= q * q).
    { unfold q. split; [lra|]. assert (0 <= ((1 - rate) / 2) * ((1 - rate) / 2)) by nra. nra. }
    assert (B : forall k, D k <= (q ^ k * q ^ k) * D 0%nat).
    { induction k as [|k IH]; [cbn [pow]; lra|].
      apply Rle_trans with (rate * D k); [apply contracts; [exact (orbit_inside (S k)) | apply orbit_inside]|].
      cbn [pow]. assert (D00 := D0 0%nat). specialize (D0 k). assert (P : 0 <= q ^ k * q ^ k) by nra.
      apply Rle_trans with ((q * q) * D k); [apply Rmult_le_compat_r; lra|].
      replace (q * q ^ k * (q * q ^ k) * D 0%nat) with (q * q * (q ^ k * q ^ k * D 0%nat)) by ring.
      apply Rmult_le_compat_l; [nra | exact IH]. }
    exists (1 + D 0%nat). assert (D00 := D0 0%nat). split; [lra|]. intros k i I.
    assert (P : 0 <= q ^ k) by (apply pow_le; lra).
    apply Rsqr_incr_0_var; [|nra]. unfold Rsqr. rewrite square_abs.
    apply Rle_trans with (D k); [apply (component_below n (fun i => orbit (S k) i - orbit k i)), I|].
    eapply Rle_trans; [apply B|]. assert (PP : 0 <= q ^ k * q ^ k) by nra.
    replace ((1 + D 0%nat) * q ^ k * ((1 + D 0%nat) * q ^ k)) with (q ^ k * q ^ k * ((1 + D 0%nat) * (1 + D 0%nat))) by ring.
    apply Rmult_le_compat_l; [exact PP | nra].
  Qed.

  Lemma sum_limit m (f : nat -> nat -> R) g : (forall i, (i < m)%nat -> Un_cv (fun k => f k i) (g i)) ->
    Un_cv (fun k => sum m (f k)) (sum m g).
  Proof.
    induction m as [|m IH]; intros C; cbn [sum]; [apply Un_cv_const|].
    apply (CV_plus (fun k => sum m (f k)) (fun k => f k m)); [apply IH; auto | apply C; lia].
  Qed.

  Lemma limit_below u l b : Un_cv u l -> (forall k, u k <= b) -> l <= b.
  Proof.
    intros C B. apply Rnot_lt_le. intros L. destruct (C (l - b) ltac:(lra)) as [k K]. specialize (K k ltac:(lia)).
    specialize (B k). unfold R_dist, Rabs in K. destruct Rcase_abs in K; lra.
  Qed.

  Theorem contraction_fixed : exists y, norm2 n y <= 1 /\ forall i, (i < n)%nat -> T y i = y i.
  Proof.
    destruct orbit_shrinks as [C [C0 B]].
    assert (Q : 0 <= q < 1) by (unfold q; lra).
    assert (Ch : forall i, (i < n)%nat -> Cauchy_crit (fun k => orbit k i)).
    { intros i I. apply geometric_cauchy with C q; [exact C0 | exact Q | intros k; apply B, I]. }
    pose (y := fun i => match Compare_dec.lt_dec i n with left L => proj1_sig (R_complete _ (Ch i L)) | right _ => 0 end).
    assert (Y : forall i, (i < n)%nat -> Un_cv (fun k => orbit k i) (y i)).
    { intros i I. unfold y. destruct (Compare_dec.lt_dec i n) as [J|J]; [|contradiction].
      apply (proj2_sig (R_complete _ (Ch i J))). }
    assert (In : norm2 n y <= 1).
    { apply limit_below with (fun k => norm2 n (orbit k)); [|apply orbit_inside].
      apply (sum_limit n (fun k i => orbit k i * orbit k i) (fun i => y i * y i)). intros i I.
      apply (CV_mult (fun k => orbit k i) (fun k => orbit k i)); apply Y, I. }
    exists y. split; [exact In|]. intros i I.
    apply UL_sequence with (fun k => orbit (S k) i).
    - assert (Z : Un_cv (fun k => norm2 n (fun i => orbit k i - y i)) 0).
      { rewrite <- (sum_zero n (fun _ => 0)) by reflexivity.
        apply (sum_limit n (fun k i => (orbit k i - y i) * (orbit k i - y i)) (fun _ => 0)). intros j J.
        replace 0 with ((y j - y j) * (y j - y j)) by ring.
        apply (CV_mult (fun k => orbit k j - y j) (fun k => orbit k j - y j));
          apply (CV_minus (fun k => orbit k j) (fun _ => y j)); (apply Y, J || apply Un_cv_const). }
      intros e E. destruct (Z (e * e) ltac:(nra)) as [m M]. exists m. intros k K. specialize (M k K).
      unfold R_dist in *. rewrite Rminus_0_r, Rabs_right in M by (apply Rle_ge, norm2_nonnegative).
      apply Rsqr_incrst_0; [|apply Rabs_pos | lra]. unfold Rsqr. rewrite square_abs.
      eapply Rle_lt_trans; [|exact M].
      apply Rle_trans with (norm2 n (fun i => T (orbit k) i - T y i)).
      + apply (component_below n (fun i => T (orbit k) i - T y i)), I.
      + eapply Rle_trans; [apply contracts; [apply orbit_inside | exact In]|].
        assert (N := norm2_nonnegative n (fun i => orbit k i - y i)). nra.
    - intros e E. destruct (Y i I e E) as [m M]. exists m. intros k K. apply M. lia.
  Qed.
End Contraction.

(** A square matrix that makes nothing shorter by more than a factor has an inverse. *)
Lemma finite_choice n (Q : nat -> (nat -> R) -> Prop) : (forall k, (k < n)%nat -> exists u, Q k u) ->
  exists U, forall k, (k < n)%nat -> Q k (U k).
Proof.
  induction n as [|n IH]; intros E.
  - exists (fun _ _ => 0). intros; lia.
  - destruct IH as [U H]; [intros; apply E; lia|]. destruct (E n ltac:(lia)) as [u V].
    exists (fun k => if Nat.eq_dec k n then u else U k). intros k K. destruct (Nat.eq_dec k n) as [->|]; [exact V | apply H; lia].
Qed.

Section Inverse.
  Variables (n : nat) (m : nat -> nat -> R) (s : R).
  Hypothesis s_pos : 0 < s.
  Hypothesis low : forall z, s * s * norm2 n z <= norm2 n (fun i => sum n (fun j => m i j * z j)).

  Lemma norm2_zero z : norm2 n z = 0 -> forall i, (i < n)%nat -> z i = 0.
  Proof. apply (sum_square_zero n z). Qed.

  Lemma onto v : exists u, forall i, (i < n)%nat -> sum n (fun j => m i j * u j) = v i.
  Proof.
    destruct (dependent n (fun i k => if Nat.eq_dec k n then v i else m i k)) as [x [[k [K X]] E]].
    assert (E' : forall i, (i < n)%nat -> sum n (fun j => m i j * x j) + v i * x n = 0).
    { intros i I. specialize (E i I). cbn [sum] in E. destruct (Nat.eq_dec n n) as [_|]; [|contradiction].
      rewrite <- E. f_equal. apply sum_ext. intros j J. destruct (Nat.eq_dec j n); [lia | reflexivity]. }
    assert (N : x n <> 0).
    { intros Z. assert (L := low x).
      assert (O : norm2 n (fun i => sum n (fun j => m i j * x j)) = 0).
      { apply sum_zero. intros i I. specialize (E' i I). rewrite Z in E'.
        replace (sum n (fun j => m i j * x j)) with 0 by lra. ring. }
      rewrite O in L. assert (P := norm2_nonnegative n x). assert (SS : 0 < s * s) by nra.
      assert (N0 : norm2 n x = 0).
      { destruct P as [P|P]; [|symmetry; exact P]. assert (Q := Rmult_lt_0_compat _ _ SS P). lra. }
      apply X. destruct (Nat.eq_dec k n) as [->|]; [exact Z | apply (norm2_zero x N0); lia]. }
    exists (fun j => - / x n * x j). intros i I. specialize (E' i I).
    rewrite (sum_ext _ _ (fun j => - / x n * (m i j * x j))) by (intros; ring). rewrite sum_scale.
    replace (sum n (fun j => m i j * x j)) with (- (v i * x n)) by lra. field. exact N.
  Qed.

  Variables (g : (nat -> R) -> nat -> R) (rate : R).
  Hypothesis rate_size : 0 <= rate < 1.
  Hypothesis g_size : forall y, norm2 n y <= 1 -> norm2 n (g y) <= s * s.
  Hypothesis g_moves : forall x y, norm2 n x <= 1 -> norm2 n y <= 1 ->
    norm2 n (fun i => g x i - g y i) <= rate * (s * s) * norm2 n (fun i => x i - y i).

  Theorem zero_in_unit_ball : exists y, norm2 n y <= 1 /\ forall i, (i < n)%nat -> sum n (fun j => m i j * y j) + g y i = 0.
  Proof.
    destruct (finite_choice n (fun k u => forall i, (i < n)%nat -> sum n (fun j => m i j * u j) = if Nat.eq_dec i k then 1 else 0))
      as [U H]; [intros k _; apply onto|].
    pose (T := fun (y : nat -> R) j => sum n (fun k => - g y k * U k j)).
    assert (M : forall y i, (i < n)%nat -> sum n (fun j => m i j * T y j) = - g y i).
    { intros y i I. unfold T.
      rewrite (sum_ext _ _ (fun j => sum n (fun k => - g y k * (m i j * U k j)))).
      - rewrite sum_exchange. rewrite (sum_ext _ _ (fun k => - g y k * (if Nat.eq_dec i k then 1 else 0))).
        + rewrite (sum_single _ i); [|exact I|].
          * cbv beta. destruct (Nat.eq_dec i i); [ring | contradiction].
          * intros j _ D. destruct (Nat.eq_dec i j); [congruence | ring].
        + intros k K. rewrite sum_scale, H by assumption. reflexivity.
      - intros j _. rewrite <- sum_scale. apply sum_ext. intros k _. ring. }
    assert (SS : 0 < s * s) by nra.
    destruct (contraction_fixed n T rate rate_size) as [y [Y F]].
    - intros y Y. assert (L := low (T y)).
      assert (E : norm2 n (fun i => sum n (fun j => m i j * T y j)) = norm2 n (g y)).
      { apply sum_ext. intros i I. rewrite M by exact I. ring. }
      rewrite E in L. specialize (g_size y Y). apply Rmult_le_reg_l with (s * s); lra.
    - intros x y X Y. assert (L := low (fun j => T x j - T y j)). cbv beta in L.
      assert (E : norm2 n (fun i => sum n (fun j => m i j * (T x j - T y j))) = norm2 n (fun i => g x i - g y i)).
      { apply sum_ext. intros i I.
        rewrite (sum_ext _ (fun j => m i j * (T x j - T y j)) (fun j => m i j * T x j + (-1) * (m i j * T y j))) by (intros; ring).
        rewrite sum_plus, sum_scale, !M by exact I. ring. }
      rewrite E in L. specialize (g_moves x y X Y). apply Rmult_le_reg_l with (s * s); [exact SS|].
      eapply Rle_trans; [exact L|]. eapply Rle_trans; [exact g_moves|]. apply Req_le. ring.
    - exists y. split; [exact Y|]. intros i I. rewrite (sum_ext _ _ (fun j => m i j * T y j)).
      + rewrite M by exact I. ring.
      + intros j J. rewrite F by exact J. reflexivity.
  Qed.
End Inverse.

(** Quadratic parts around the center. *)
Lemma products_differ q d e w c : 0 <= c -> (forall k, Rabs (d k) <= w k) -> (forall k, Rabs (e k) <= w k) ->
  (forall k, Rabs (d k - e k) <= c * w k) -> Rabs (products q d d - products q e e) <= 2 * c * products_abs q w.
Proof.
  intros C D E B. induction q as [|[[a j] k] q IH]; cbn; [rewrite Rminus_0_r, Rabs_R0; lra|].
  replace (value a * (d j * d k) + products q d d - (value a * (e j * e k) + products q e e))
    with (value a * ((d j - e j) * d k + e j * (d k - e k)) + (products q d d - products q e e)) by ring.
  eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_mult.
  assert (S : Rabs ((d j - e j) * d k + e j * (d k - e k)) <= 2 * c * (w j * w k)).
  { eapply Rle_trans; [apply Rabs_triang|]. rewrite !Rabs_mult.
    assert (A1 : Rabs (d j - e j) * Rabs (d k) <= c * w j * w k) by (apply Rmult_le_compat; auto using Rabs_pos).
    assert (A2 : Rabs (e j) * Rabs (d k - e k) <= w j * (c * w k)) by (apply Rmult_le_compat; auto using Rabs_pos).
    lra. }
  assert (A := Rabs_pos (value a)).
  assert (T : Rabs (value a) * Rabs ((d j - e j) * d k + e j * (d k - e k)) <= Rabs (value a) * (2 * c * (w j * w k)))
    by (apply Rmult_le_compat_l; assumption).
  lra.
Qed.

Lemma squares_norm F ls : value (squares F ls) = norm2 (length ls)
  (fun i => value (snd (nth i ls (nothing, zero))) * value (F (fst (nth i ls (nothing, zero))))).
Proof.
  unfold squares, norm2. rewrite total_value. induction ls as [|[e r] ls IH]; [reflexivity|].
  cbn [length map fold_right]. rewrite sum_first, IH. unfold Checker.square. rewrite !value_mul. reflexivity.
Qed.

Lemma positions_find k l i m b : PositiveMap.find (key k) (positions i l m) = Some b ->
  PositiveMap.find (key k) m = Some b \/ exists j, nth_error l j = Some k /\ b = (i + N.of_nat j)%N.
Proof.
  revert i m. induction l as [|h l IH]; intros i m F; cbn in F; [left; exact F|].
  destruct (IH _ _ F) as [G|[j [J ->]]].
  - destruct (Pos.eq_dec (key k) (key h)) as [E|E].
    + rewrite E, PositiveMap.gss in G. inversion G; subst. apply key_inj in E. subst. right. exists 0%nat. split; [reflexivity | lia].
    + rewrite PositiveMap.gso in G by exact E. left. exact G.
  - right. exists (S j). split; [exact J | lia].
Qed.

Lemma row_sum_app l k i v : row_sum (l ++ k) i v = row_sum l i v + row_sum k i v.
Proof.
  unfold row_sum. induction l as [|[[r c] a] l IH]; cbn [app fold_right]; [lra|]. rewrite IH. destruct N.eq_dec; lra.
Qed.

Section Zero.
  Variables (z p : table) (left : list N) (kept : list equation) (rows : list number) (s f q : number)
    (factor : list (N * N * number)).
  Hypothesis checked : ball_has_zero rows s f q factor z p left kept = true.
  Let n := length left.
  Let l := combine kept rows.
  Let places := positions 0 left (PositiveMap.empty N).
  Let slopes := scaled_slopes z p places 0 l.

  Lemma lengths : length kept = n /\ length rows = n /\ length l = n.
  Proof.
    assert (C := checked). unfold ball_has_zero in C. split_and C. apply Nat.eqb_eq in C. apply Nat.eqb_eq in H11.
    split; [exact C|]. split; [exact H11|]. unfold l. rewrite combine_length. fold n in C, H11. lia.
  Qed.

  Lemma place_of k b : PositiveMap.find (key k) places = Some b -> nth_error left (N.to_nat b) = Some k.
  Proof.
    intros F. apply positions_find in F. destruct F as [F|[j [J ->]]].
    - rewrite PositiveMap.gempty in F. discriminate.
    - replace (N.to_nat (0 + N.of_nat j)) with j by lia. exact J.
  Qed.

  Lemma place_below k b : PositiveMap.find (key k) places = Some b -> (N.to_nat b < n)%nat.
  Proof. intros F. apply place_of in F. apply nth_error_Some. rewrite F. discriminate. Qed.

  (** The displacements of y. *)
  Definition moved (v : vector) : vector :=
    fun k => match PositiveMap.find (key k) places with Some b => value (get p k) * v b | None => 0 end.

  Definition one_row (i : N) (r : number) (t : linear) : list (N * N * number) :=
    flat_map (fun t => match PositiveMap.find (key (fst t)) places with
      | Some b => [(i, b, mul r (mul (snd t) (get p (fst t))))]
      | None => []
      end) t.

  Lemma one_row_sum i r t c v : row_sum (one_row i r t) c v = if N.eq_dec i c then value r * apply t (moved v) else 0.
  Proof.
    unfold one_row. induction t as [|[k a] t IH]; cbn [flat_map apply fst snd].
    - destruct N.eq_dec; unfold row_sum; cbn; lra.
    - rewrite row_sum_app, IH. unfold moved at 2. destruct (PositiveMap.find (key k) places) as [b|].
      + unfold row_sum. cbn [fold_right]. destruct (N.eq_dec i c); [rewrite !value_mul; ring | ring].
      + unfold row_sum at 1. cbn [fold_right]. destruct (N.eq_dec i c); ring.
  Qed.

  Lemma slopes_above ls i c v : (c < i)%N -> row_sum (scaled_slopes z p places i ls) c v = 0.
  Proof.
    revert i. induction ls as [|[e r] ls IH]; intros i L; [reflexivity|]. cbn [scaled_slopes].
    rewrite row_sum_app, IH by lia. fold (one_row i r (slope e z)). rewrite one_row_sum.
    destruct (N.eq_dec i c); [lia | lra].
  Qed.

  Lemma slopes_sum ls i j e r v : nth_error ls j = Some (e, r) ->
    row_sum (scaled_slopes z p places i ls) (i + N.of_nat j) v = value r * apply (slope e z) (moved v).
  Proof.
    revert i j. induction ls as [|[e' r'] ls IH]; intros i j E; [destruct j; discriminate|]. cbn [scaled_slopes].
    rewrite row_sum_app. fold (one_row i r' (slope e' z)). rewrite one_row_sum. destruct j as [|j].
    - inversion E; subst. rewrite slopes_above by lia. destruct (N.eq_dec i (i + N.of_nat 0)); [lra | lia].
    - replace (i + N.of_nat (S j))%N with (N.succ i + N.of_nat j)%N by lia. rewrite (IH _ _ E).
      destruct (N.eq_dec i (N.succ i + N.of_nat j)); [lia | lra].
  Qed.

  Lemma slopes_inside ls i : Forall (fun e => match e with (k, m, _) =>
      (N.to_nat i <= N.to_nat k < N.to_nat i + length ls)%nat /\ (N.to_nat m < n)%nat end) (scaled_slopes z p places i ls).
  Proof.
    revert i. induction ls as [|[e r] ls IH]; intros i; cbn [scaled_slopes]; [constructor|].
    apply Forall_app. split.
    - apply Forall_forall. intros [[k m] a] I. apply in_flat_map in I. destruct I as [t [_ I]].
      destruct (PositiveMap.find (key (fst t)) places) as [b|] eqn:F; [|destruct I].
      destruct I as [E|[]]. inversion E; subst. split; [cbn; lia | apply (place_below _ _ F)].
    - eapply Forall_impl; [|apply IH]. intros [[k m] a]. cbn. lia.
  Qed.

  Let m (i b : nat) : R := entry slopes i b.
  Let lo := entry factor.

  Lemma columns_inside : Forall (fun e => match e with (_, c, _) => (N.to_nat c < n)%nat end) slopes.
  Proof. eapply Forall_impl; [|apply (slopes_inside l 0)]. intros [[k c] a]. tauto. Qed.

  Lemma rows_inside : Forall (fun e => match e with (_, c, _) => (N.to_nat c < n)%nat end) (transposed slopes).
  Proof.
    destruct lengths as [_ [_ L]]. apply Forall_forall. intros [[k c] a] I. unfold transposed in I.
    apply in_map_iff in I. destruct I as [[[k' c'] a'] [E I]]. inversion E; subst.
    assert (Q := slopes_inside l 0). rewrite Forall_forall in Q. specialize (Q _ I). cbv beta iota in Q. lia.
  Qed.

  Lemma factor_inside : Forall (fun e => match e with (_, c, _) => (N.to_nat c < n)%nat end) factor /\
    Forall (fun e => match e with (_, c, _) => (N.to_nat c < n)%nat end) (transposed factor).
  Proof.
    assert (C := checked). unfold ball_has_zero in C. split_and C. rewrite forallb_forall in H0. fold n in H0.
    split; apply Forall_forall; intros [[k c] a] I.
    - specialize (H0 _ I). cbv beta iota in H0. apply andb_prop in H0. destruct H0 as [_ B]. apply N.ltb_lt in B. lia.
    - unfold transposed in I. apply in_map_iff in I. destruct I as [[[k' c'] a'] [E I]]. inversion E; subst.
      specialize (H0 _ I). cbv beta iota in H0. apply andb_prop in H0. destruct H0 as [B _]. apply N.ltb_lt in B. lia.
  Qed.

  Lemma gram_value a b : (b < n)%nat ->
    value (get (gram_row (by_rows slopes) (by_rows (transposed slopes)) (by_rows factor) (by_rows (transposed factor)) (N.of_nat a))
      (N.of_nat b)) = sum n (fun i => m i a * m i b) - sum n (fun k => lo a k * lo b k).
  Proof.
    intros K. set (all := range 0 n).
    assert (J : In (N.of_nat b) all) by (apply range_In; lia).
    pose (unit := fun c : N => if N.eq_dec c (N.of_nat b) then 1 else 0).
    assert (U : forall c, ~ In c all -> unit c = 0).
    { intros c M. unfold unit. destruct (N.eq_dec c (N.of_nat b)) as [->|]; [contradiction | reflexivity]. }
    assert (U' : forall c, unit (N.of_nat c) = if Nat.eq_dec c b then 1 else 0).
    { intros c. unfold unit. destruct (N.eq_dec (N.of_nat c) (N.of_nat b)), (Nat.eq_dec c b); try reflexivity; lia. }
    assert (One : forall g, sum n (fun c => g c * unit (N.of_nat c)) = g b).
    { intros g. rewrite (sum_single _ b); [|exact K|].
      - rewrite U'. destruct (Nat.eq_dec b b); [lra | contradiction].
      - intros c _ M. rewrite U'. destruct (Nat.eq_dec c b); [contradiction | lra]. }
    set (t := gram_row _ _ _ _ _).
    assert (Q : sum_over all (fun c => value (get t c) * unit c) = value (get t (N.of_nat b))).
    { rewrite (sum_over_changed all (N.of_nat b) (value (get t (N.of_nat b))) _ (fun _ => 0) (range_NoDup _ _) J).
      - rewrite (sum_over_zero all (fun _ => 0)) by reflexivity. lra.
      - intros c C. unfold unit. destruct (N.eq_dec c (N.of_nat b)); [contradiction | lra].
      - unfold unit. destruct (N.eq_dec (N.of_nat b) (N.of_nat b)); [lra | contradiction]. }
    rewrite <- Q. unfold t, gram_row.
    assert (G1 : forall r t, sum_over all (fun c => value (get (List.fold_left (fun m e =>
        accumulate m (opp (snd e)) (look [] (by_rows (transposed factor)) (fst e))) r t) c) * unit c)
      = sum_over all (fun c => value (get t c) * unit c)
        - apply r (fun c => apply (look [] (by_rows (transposed factor)) c) unit)).
    { induction r as [|[c x] r IH]; intros w; cbn [List.fold_left apply fst snd]; [lra|].
      rewrite IH, accumulate_value, value_opp by (apply range_NoDup || exact U). lra. }
    assert (G2 : forall r t, sum_over all (fun c => value (get (List.fold_left (fun m e =>
        accumulate m (snd e) (look [] (by_rows slopes) (fst e))) r t) c) * unit c)
      = sum_over all (fun c => value (get t c) * unit c) + apply r (fun c => apply (look [] (by_rows slopes) c) unit)).
    { induction r as [|[c x] r IH]; intros w; cbn [List.fold_left apply fst snd]; [lra|].
      rewrite IH, accumulate_value by (apply range_NoDup || exact U). lra. }
    rewrite G1, G2.
    rewrite (sum_over_zero all (fun c => value (get empty c) * unit c)) by (intros; rewrite get_empty, value_zero; lra).
    destruct factor_inside as [F1 F2].
    rewrite !by_rows_value, (row_sum_entries n _ _ _ rows_inside), (row_sum_entries n _ _ _ F1), Rplus_0_l. f_equal.
    - apply sum_ext. intros c _. rewrite entry_transposed. unfold m. f_equal.
      rewrite by_rows_value, (row_sum_entries n _ _ _ columns_inside), One. reflexivity.
    - apply sum_ext. intros c _. unfold lo. f_equal.
      rewrite by_rows_value, (row_sum_entries n _ _ _ F2), One. apply entry_transposed.
  Qed.

  Lemma least_singular_value y : value s * value s * norm2 n y <= norm2 n (fun i => sum n (fun b => m i b * y b)).
  Proof.
    set (g := fun a b => sum n (fun i => m i a * m i b) - sum n (fun k => lo a k * lo b k)
      - (if Nat.eq_dec b a then value s * value s else 0)).
    assert (D := dominant_form n g 0).
    assert (E : 0 * sum n (fun i => y i * y i) <= sum n (fun i => y i * sum n (fun j => g i j * y j))).
    { apply D.
      - intros a b. unfold g. rewrite (sum_ext _ (fun i => m i a * m i b) (fun i => m i b * m i a)) by (intros; ring).
        rewrite (sum_ext _ (fun k => lo a k * lo b k) (fun k => lo b k * lo a k)) by (intros; ring).
        destruct (Nat.eq_dec b a), (Nat.eq_dec a b); congruence || reflexivity.
      - intros a A. assert (C := checked). unfold ball_has_zero in C. split_and C. rewrite forallb_forall in H. fold n places l in H.
        change (scaled_slopes z p places 0 l) with slopes in H.
        assert (I : In (N.of_nat a) (range 0 n)) by (apply range_In; lia).
        specialize (H _ I). cbv zeta in H. apply le_value in H. rewrite value_sub, total_range in H.
        unfold Checker.square in H. rewrite value_mul, (gram_value a a A) in H.
        unfold g at 2. destruct (Nat.eq_dec a a) as [_|]; [|contradiction]. rewrite Rplus_0_r.
        eapply Rle_trans; [|exact H]. apply Req_le. apply sum_ext. intros b B. cbn [N.add].
        destruct (Nat.eq_dec b a) as [->|X].
        + rewrite N.eqb_refl, value_zero. reflexivity.
        + destruct (N.eqb_spec (N.of_nat b) (N.of_nat a)) as [Y|_]; [lia|].
          rewrite value_abs, (gram_value a b B). unfold g. destruct (Nat.eq_dec b a); [contradiction|]. f_equal. lra. }
    assert (Square : forall u : nat -> nat -> R, sum n (fun i => y i * sum n (fun j => sum n (fun k => u i k * u j k) * y j))
      = sum n (fun k => sum n (fun j => u j k * y j) * sum n (fun j => u j k * y j))).
    { intros u. rewrite (sum_ext n (fun k => sum n (fun j => u j k * y j) * sum n (fun j => u j k * y j))
        (fun k => sum n (fun i => y i * (u i k * sum n (fun j => u j k * y j))))).
      - rewrite sum_exchange. apply sum_ext. intros i _. rewrite sum_scale. f_equal.
        rewrite (sum_ext n (fun j => sum n (fun k => u i k * u j k) * y j) (fun j => sum n (fun k => u i k * u j k * y j))).
        + rewrite sum_exchange. apply sum_ext. intros k _. rewrite <- sum_scale. apply sum_ext. intros j _. ring.
        + intros j _. rewrite Rmult_comm, <- sum_scale. apply sum_ext. intros k _. ring.
      - intros k _. set (c := sum n (fun j => u j k * y j)). transitivity (c * sum n (fun j => u j k * y j)); [reflexivity|].
        rewrite <- sum_scale. apply sum_ext. intros j _. ring. }
    assert (V : sum n (fun i => y i * sum n (fun j => g i j * y j))
      = norm2 n (fun i => sum n (fun b => m i b * y b)) - norm2 n (fun k => sum n (fun j => lo j k * y j))
        - value s * value s * norm2 n y).
    { assert (M := Square (fun b i => m i b)). assert (Lo := Square lo). cbv beta in M.
      unfold norm2. rewrite <- M, <- Lo. rewrite <- sum_scale.
      unfold Rminus. rewrite <- (Rmult_1_l (sum n (fun i => y i * sum n (fun j => sum n (fun k => lo i k * lo j k) * y j)))).
      rewrite <- (Rmult_1_l (sum n (fun i => value s * value s * (y i * y i)))).
      rewrite !Ropp_mult_distr_l, <- !sum_scale, <- !sum_plus. apply sum_ext. intros i I.
      rewrite (sum_ext _ (fun j => g i j * y j) (fun j => sum n (fun k => m k i * m k j) * y j
        + ((-1) * (sum n (fun k => lo i k * lo j k) * y j) + (-1) * ((if Nat.eq_dec j i then value s * value s else 0) * y j))))
        by (intros; unfold g; ring).
      rewrite !sum_plus, !sum_scale.
      rewrite (sum_single n i (fun j => (if Nat.eq_dec j i then value s * value s else 0) * y j)); [|exact I|].
      - destruct (Nat.eq_dec i i); [ring | contradiction].
      - intros j _ X. destruct (Nat.eq_dec j i); [contradiction | ring]. }
    rewrite V in E. assert (P := norm2_nonnegative n (fun k => sum n (fun j => lo j k * y j))). lra.
  Qed.

  Let equation_at (i : nat) : equation := fst (nth i l (nothing, zero)).
  Let scale_at (i : nat) : R := value (snd (nth i l (nothing, zero))).
  Let v_of (y : nat -> R) : vector := fun b => y (N.to_nat b).
  Let bend (i : nat) : R := products_abs (quadratic_part (equation_at i)) (absolute p).
  Let g (y : nat -> R) (i : nat) : R := scale_at i * value (at_center (equation_at i) z)
    + scale_at i * products (quadratic_part (equation_at i)) (moved (v_of y)) (moved (v_of y)).

  Lemma squares_value F : value (squares F l) = norm2 n (fun i => scale_at i * value (F (equation_at i))).
  Proof.
    destruct lengths as [_ [_ L]]. rewrite <- L. unfold scale_at, equation_at. apply squares_norm.
  Qed.

  Lemma component_one y b : norm2 n y <= 1 -> (b < n)%nat -> Rabs (y b) <= 1.
  Proof.
    intros Y B. apply Rsqr_incr_0_var; [|lra]. unfold Rsqr. rewrite square_abs.
    eapply Rle_trans; [apply (component_below n y b B)|]. lra.
  Qed.

  Lemma moved_inside y : norm2 n y <= 1 -> forall k, Rabs (moved (v_of y) k) <= absolute p k.
  Proof.
    intros Y k. unfold moved, v_of, absolute. destruct (PositiveMap.find (key k) places) as [b|] eqn:F.
    - rewrite Rabs_mult. rewrite <- (Rmult_1_r (Rabs (value (get p k)))) at 2.
      apply Rmult_le_compat_l; [apply Rabs_pos|]. apply component_one; [exact Y | apply (place_below _ _ F)].
    - rewrite Rabs_R0. apply Rabs_pos.
  Qed.

  Lemma bends_value : norm2 n (fun i => scale_at i * bend i)
    = value (squares (fun e => size_of_products (quadratic_part e) p) l).
  Proof. rewrite squares_value. apply sum_ext. intros i _. rewrite size_of_products_value. reflexivity. Qed.

  Lemma scaled_le i x w : Rabs x <= w -> (scale_at i * x) * (scale_at i * x) <= (scale_at i * w) * (scale_at i * w).
  Proof.
    intros B. replace ((scale_at i * x) * (scale_at i * x)) with ((scale_at i * scale_at i) * (x * x)) by ring.
    replace ((scale_at i * w) * (scale_at i * w)) with ((scale_at i * scale_at i) * (w * w)) by ring.
    apply Rmult_le_compat_l; [exact (Rle_0_sqr _)|]. rewrite <- (square_abs x).
    assert (P := Rabs_pos x). apply Rmult_le_compat; assumption.
  Qed.

  Theorem ball_zero : exists d, (forall k, Rabs (d k) <= absolute p k) /\ (forall k, ~ In k left -> d k = 0) /\ NoDup left /\
    forall e, In e kept -> eval e (fun k => values z k + d k) = 0.
  Proof.
    destruct lengths as [LK [LR LL]]. assert (C := checked). unfold ball_has_zero in C. split_and C.
    fold l in H1, H2, H3, H4. apply distinct_NoDup in H10. rewrite forallb_forall in H9.
    apply sign_positive in H8. apply sign_nonnegative in H7. apply le_value in H5. apply sign_nonnegative in H6.
    apply lt_value in H1. apply le_value in H2. apply le_value in H4. rewrite value_add in H5.
    assert (B2 := bends_value). assert (BN := norm2_nonnegative n (fun i => scale_at i * bend i)).
    assert (SS : 0 < value s * value s) by nra.
    unfold Checker.square in *. rewrite !value_mul in *. rewrite !value_sub in *. rewrite <- B2 in H1, H2.
    assert (Four : value (Number 4 0 1) = 4) by (unfold value; cbn; lra). rewrite Four in H1.
    set (B := norm2 n (fun i => scale_at i * bend i)) in *.
    destruct (zero_in_unit_ball n m (value s) H8 least_singular_value g (4 * B / (value s * value s))) as [y [Y Z]].
    - split.
      + apply Rmult_le_pos; [lra | apply Rlt_le, Rinv_0_lt_compat, SS].
      + apply Rmult_lt_reg_r with (value s * value s); [exact SS|].
        unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra.
    - intros x X. rewrite squares_value in H4.
      assert (N := norm2_plus n (fun i => scale_at i * value (at_center (equation_at i) z))
        (fun i => scale_at i * products (quadratic_part (equation_at i)) (moved (v_of x)) (moved (v_of x)))
        (value f) (value s - value f) H7 ltac:(lra) H4).
      fold g in N. replace (value f + (value s - value f)) with (value s) in N by ring. apply N.
      eapply Rle_trans; [|exact H2]. apply sum_le. intros i _. apply scaled_le.
      apply (majorised_value _ _ _ _ (majorises_products _)). apply moved_inside, X.
    - intros x w X W. set (D := norm2 n (fun i => x i - w i)).
      replace (4 * B / (value s * value s) * (value s * value s) * D) with (4 * D * B) by (field; nra).
      set (c := sqrt D). assert (D0 : 0 <= D) by apply norm2_nonnegative.
      assert (CC : c * c = D) by (apply sqrt_sqrt, D0). assert (C0 : 0 <= c) by apply sqrt_pos.
      apply Rle_trans with (norm2 n (fun i => scale_at i * (2 * c * bend i))).
      + apply sum_le. intros i _.
        replace (g x i - g w i) with (scale_at i * (products (quadratic_part (equation_at i)) (moved (v_of x)) (moved (v_of x))
          - products (quadratic_part (equation_at i)) (moved (v_of w)) (moved (v_of w)))) by (unfold g; ring).
        apply scaled_le. apply products_differ; [exact C0 | apply moved_inside, X | apply moved_inside, W|].
        intros k. unfold moved, v_of, absolute. destruct (PositiveMap.find (key k) places) as [b|] eqn:F.
        * rewrite <- Rmult_minus_distr_l, Rabs_mult, Rmult_comm. apply Rmult_le_compat_r; [apply Rabs_pos|].
          apply Rsqr_incr_0_var; [|exact C0]. unfold Rsqr. rewrite square_abs, CC.
          apply (component_below n (fun i => x i - w i)), (place_below _ _ F).
        * rewrite Rminus_0_r, Rabs_R0. apply Rmult_le_pos; [exact C0 | apply Rabs_pos].
      + apply Req_le. unfold B, norm2.
        rewrite (sum_ext _ _ (fun i => (4 * D) * ((scale_at i * bend i) * (scale_at i * bend i)))) by (intros; rewrite <- CC; ring).
        apply sum_scale.
    - exists (moved (v_of y)). split; [apply moved_inside, Y|]. split; [|split; [exact H10|]].
      + intros k K. unfold moved. destruct (PositiveMap.find (key k) places) as [b|] eqn:F; [|reflexivity].
        exfalso. apply K. apply (nth_error_In _ (N.to_nat b)), place_of, F.
      + intros e E. apply (In_nth _ _ nothing) in E. destruct E as [i [I <-]]. rewrite LK in I.
        assert (N : nth i l (nothing, zero) = (nth i kept nothing, nth i rows zero)) by (apply combine_nth; lia).
        assert (R0 : value (nth i rows zero) <> 0).
        { assert (IR : (i < length rows)%nat) by lia. assert (Q := H9 (nth i rows zero) (nth_In _ _ IR)).
          apply negb_true_iff in Q. apply sign_nonzero, Q. }
        specialize (Z i I). unfold g, scale_at, equation_at in Z. rewrite N in Z. cbn [fst snd] in Z.
        assert (M : sum n (fun b => m i b * y b) = value (nth i rows zero) * apply (slope (nth i kept nothing) z) (moved (v_of y))).
        { rewrite <- (slopes_sum l 0 i (nth i kept nothing) (nth i rows zero)).
          - rewrite N.add_0_l. fold slopes. rewrite (row_sum_entries n _ _ _ columns_inside). apply sum_ext. intros b _.
            unfold v_of. rewrite Nat2N.id. reflexivity.
          - rewrite (nth_error_nth' l (nothing, zero)) by lia. rewrite N. reflexivity. }
        rewrite M in Z. rewrite eval_shift. apply Rmult_eq_reg_l with (value (nth i rows zero)); [|exact R0]. lra.
  Qed.
End Zero.

Section Instance.
  Variable i : instance.
  Hypothesis whole : is_whole i = true.
  Hypothesis fine : is_proper i = true.
  Let P := problem_of i.

  Theorem check_ball_sound x rho eta modes center radius pinned dropped rows s f q factor :
    check_ball (tables_of i) x rho eta modes center radius pinned dropped rows s f q factor = true ->
    exists X, solution P X /\ near (size P) (value rho) X (numbers x) /\
      (forall k, (k < contacts P)%nat -> in_mode (dimension P) (friction P k) (nth k modes Open)
        (of_contact P k X) (of_contact P k (motion P X))) /\
      match eta with
      | None => True
      | Some eta => forall j, (free P <= j < size P)%nat -> Rabs (motion P X j - motion P (numbers x) j) <= value eta
      end.
  Proof. apply (check_near_sound i whole fine). intros z r left kept. apply ball_zero. Qed.
End Instance.
