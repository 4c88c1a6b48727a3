(** Fixed points: iterates that a growing sequence below a bound majorises converge, componentwise, to one. *)
From Coq Require Import Reals NArith Lra Lia Psatz.
Local Open Scope R_scope.

Definition vector := N -> R.

(** h, of bounds on a vector, bounds g and its differences. *)
Record majorises (h g : vector -> R) : Prop := Majorises {
  at_zero : Rabs (g (fun _ => 0)) <= h (fun _ => 0);
  differences : forall d e t s, (forall i, Rabs (e i) <= s i) -> (forall i, Rabs (d i - e i) <= t i - s i) ->
    Rabs (g d - g e) <= h t - h s;
  continuous : forall (t : nat -> vector) l, (forall i, Un_cv (fun k => t k i) (l i)) -> Un_cv (fun k => h (t k)) (h l)
}.

Lemma Un_cv_const c : Un_cv (fun _ => c) c.
Proof. intros e E. exists 0%nat. intros n _. unfold R_dist. replace (c - c) with 0 by lra. rewrite Rabs_R0. exact E. Qed.

Lemma majorised_value h g d t : majorises h g -> (forall i, Rabs (d i) <= t i) -> Rabs (g d) <= h t.
Proof.
  intros [Z D _] B.
  assert (Q := D d (fun _ => 0) t (fun _ => 0) (fun i => ltac:(cbv beta; rewrite Rabs_R0; lra))
    (fun i => ltac:(cbv beta; replace (d i - 0) with (d i) by lra; specialize (B i); lra))).
  replace (g d) with (g d - g (fun _ => 0) + g (fun _ => 0)) by lra.
  eapply Rle_trans; [apply Rabs_triang|]. lra.
Qed.

Lemma majorant_grows h g s t : majorises h g -> (forall i, 0 <= s i <= t i) -> h s <= h t.
Proof.
  intros [_ D _] B.
  assert (Q := D (fun _ => 0) (fun _ => 0) t s (fun i => ltac:(cbv beta; rewrite Rabs_R0; specialize (B i); lra))
    (fun i => ltac:(cbv beta; replace (0 - 0) with 0 by lra; rewrite Rabs_R0; specialize (B i); lra))).
  assert (P := Rabs_pos (g (fun _ => 0) - g (fun _ => 0))). lra.
Qed.

Lemma majorises_const c : majorises (fun _ => Rabs c) (fun _ => c).
Proof.
  split; [lra | | intros; apply Un_cv_const].
  intros. replace (c - c) with 0 by lra. rewrite Rabs_R0. lra.
Qed.

Lemma majorises_component i : majorises (fun t => t i) (fun d => d i).
Proof. split; [rewrite Rabs_R0; lra | auto | auto]. Qed.

Lemma majorises_plus h g h' g' : majorises h g -> majorises h' g' -> majorises (fun t => h t + h' t) (fun d => g d + g' d).
Proof.
  intros [Z D C] [Z' D' C']. split.
  - eapply Rle_trans; [apply Rabs_triang|]. lra.
  - intros d e t s E B. replace (g d + g' d - (g e + g' e)) with ((g d - g e) + (g' d - g' e)) by lra.
    eapply Rle_trans; [apply Rabs_triang|]. specialize (D d e t s E B). specialize (D' d e t s E B). lra.
  - intros t l T. apply (CV_plus (fun k => h (t k)) (fun k => h' (t k))); auto.
Qed.

Lemma majorises_scale c h g : majorises h g -> majorises (fun t => Rabs c * h t) (fun d => c * g d).
Proof.
  intros [Z D C]. split.
  - rewrite Rabs_mult. apply Rmult_le_compat_l; [apply Rabs_pos | exact Z].
  - intros d e t s E B. replace (c * g d - c * g e) with (c * (g d - g e)) by ring. rewrite Rabs_mult.
    replace (Rabs c * h t - Rabs c * h s) with (Rabs c * (h t - h s)) by ring.
    apply Rmult_le_compat_l; [apply Rabs_pos | apply D; assumption].
  - intros t l T. apply (CV_mult (fun _ => Rabs c) (fun k => h (t k))); [apply Un_cv_const | auto].
Qed.

Lemma majorises_mult h g h' g' : majorises h g -> majorises h' g' -> majorises (fun t => h t * h' t) (fun d => g d * g' d).
Proof.
  intros M M'. assert (V := fun d t => majorised_value h g d t M). assert (V' := fun d t => majorised_value h' g' d t M').
  assert (GR := fun s t => majorant_grows h g s t M). assert (GR' := fun s t => majorant_grows h' g' s t M').
  destruct M as [Z D C], M' as [Z' D' C']. split.
  - rewrite Rabs_mult. apply Rmult_le_compat; auto using Rabs_pos.
  - intros d e t s E B.
    assert (F : forall i, Rabs (d i) <= t i).
    { intros i. specialize (E i). specialize (B i). replace (d i) with (d i - e i + e i) by lra.
      eapply Rle_trans; [apply Rabs_triang|]. lra. }
    replace (g d * g' d - g e * g' e) with ((g d - g e) * g' d + g e * (g' d - g' e)) by ring.
    eapply Rle_trans; [apply Rabs_triang|]. rewrite !Rabs_mult.
    replace (h t * h' t - h s * h' s) with ((h t - h s) * h' t + h s * (h' t - h' s)) by ring.
    apply Rplus_le_compat; apply Rmult_le_compat; auto using Rabs_pos.
  - intros t l T. apply (CV_mult (fun k => h (t k)) (fun k => h' (t k))); auto.
Qed.

(** max (g, 0) *)
Lemma majorises_cut h g : majorises h g -> majorises h (fun d => Rmax (g d) 0).
Proof.
  assert (A : forall a b, Rabs (Rmax a 0 - Rmax b 0) <= Rabs (a - b)).
  { intros a b. unfold Rmax. destruct (Rle_dec a 0), (Rle_dec b 0); unfold Rabs;
      repeat destruct Rcase_abs; lra. }
  intros [Z D C]. split; [| | exact C].
  - eapply Rle_trans; [|exact Z]. specialize (A (g (fun _ => 0)) 0). rewrite (Rmax_left 0 0) in A by lra.
    rewrite !Rminus_0_r in A. exact A.
  - intros d e t s E B. eapply Rle_trans; [apply A | apply D; assumption].
Qed.

Lemma majorises_ext h g h' g' :
  majorises h g -> (forall t, h t = h' t) -> (forall d, g d = g' d) -> majorises h' g'.
Proof.
  intros [Z D C] H G. split.
  - rewrite <- H, <- G. exact Z.
  - intros. rewrite <- !H, <- !G. apply D; assumption.
  - intros t l T. rewrite <- H. intros e E. destruct (C t l T e E) as [n N]. exists n. intros m M. rewrite <- H. auto.
Qed.

(** The limit of a sequence that stays at most b away from c does so, too. *)
Lemma limit_near u l c b n : Un_cv u l -> (forall m, (m >= n)%nat -> Rabs (u m - c) <= b) -> Rabs (l - c) <= b.
Proof.
  intros U B. apply Rnot_lt_le. intros L.
  destruct (U (Rabs (l - c) - b)) as [k K]; [lra|].
  specialize (K (max n k) ltac:(lia)). specialize (B (max n k) ltac:(lia)). unfold R_dist in K.
  assert (T := Rabs_triang (l - u (max n k)) (u (max n k) - c)).
  replace (l - u (max n k) + (u (max n k) - c)) with (l - c) in T by lra.
  rewrite (Rabs_minus_sym l (u (max n k))) in T. lra.
Qed.

Section Iterates.
  Variables (G H : vector -> vector) (p : vector).
  Hypothesis majorised : forall i, majorises (fun t => H t i) (fun d => G d i).
  Hypothesis positive : forall i, 0 <= p i.
  Hypothesis bounded : forall i, H p i <= p i.

  Fixpoint iterate (F : vector -> vector) (n : nat) : vector :=
    match n with O => fun _ => 0 | S m => F (iterate F m) end.
  Let t := iterate H.
  Let d := iterate G.

  Lemma iterates_close n i : Rabs (d n i) <= t n i /\ Rabs (d (S n) i - d n i) <= t (S n) i - t n i.
  Proof.
    revert i. induction n as [|n IH]; intros i.
    - cbn. rewrite Rabs_R0. split; [lra|]. rewrite !Rminus_0_r. exact (at_zero _ _ (majorised i)).
    - split.
      + destruct (IH i) as [A B]. replace (d (S n) i) with (d (S n) i - d n i + d n i) by lra.
        eapply Rle_trans; [apply Rabs_triang|]. lra.
      + apply (differences _ _ (majorised i)); intros; apply IH.
  Qed.

  Lemma iterates_bounded n i : 0 <= t n i <= p i.
  Proof.
    revert i. induction n as [|n IH]; intros i.
    - cbn. split; [lra | apply positive].
    - split.
      + eapply Rle_trans; [apply Rabs_pos | apply (iterates_close (S n) i)].
      + eapply Rle_trans; [|apply bounded]. apply (majorant_grows _ _ (t n) p (majorised i) IH).
  Qed.

  Lemma iterates_grow i : Un_growing (fun n => t n i).
  Proof.
    intros n. assert (A := proj2 (iterates_close n i)). assert (P := Rabs_pos (d (S n) i - d n i)). lra.
  Qed.

  Lemma iterates_apart n m i : (n <= m)%nat -> Rabs (d m i - d n i) <= t m i - t n i.
  Proof.
    induction 1 as [|m _ IH].
    - replace (d n i - d n i) with 0 by lra. rewrite Rabs_R0. lra.
    - replace (d (S m) i - d n i) with ((d (S m) i - d m i) + (d m i - d n i)) by lra.
      eapply Rle_trans; [apply Rabs_triang|]. assert (A := proj2 (iterates_close m i)). lra.
  Qed.

  Definition bound_limit i : {l | Un_cv (fun n => t n i) l}.
  Proof.
    apply growing_cv; [apply iterates_grow|]. exists (p i). intros x [n ->]. apply iterates_bounded.
  Defined.

  Lemma iterates_cauchy i : Cauchy_crit (fun n => d n i).
  Proof.
    destruct (bound_limit i) as [l L]. intros e E.
    destruct (CV_Cauchy _ (exist _ l L) e E) as [k K]. exists k. intros n m N M.
    specialize (K n m N M). unfold R_dist in *.
    destruct (Nat.le_ge_cases n m) as [C|C].
    - rewrite Rabs_minus_sym. eapply Rle_lt_trans; [apply iterates_apart, C|].
      eapply Rle_lt_trans; [apply Rle_abs|]. rewrite Rabs_minus_sym. exact K.
    - eapply Rle_lt_trans; [apply iterates_apart, C|]. eapply Rle_lt_trans; [apply Rle_abs | exact K].
  Qed.

  Theorem fixed_point : exists d, forall i, G d i = d i /\ Rabs (d i) <= p i.
  Proof.
    pose (l := fun i => proj1_sig (R_complete _ (iterates_cauchy i))).
    assert (L : forall i, Un_cv (fun n => d n i) (l i)) by (intros i; apply (proj2_sig (R_complete _ (iterates_cauchy i)))).
    pose (b := fun i => proj1_sig (bound_limit i)).
    assert (B : forall i, Un_cv (fun n => t n i) (b i)) by (intros i; apply (proj2_sig (bound_limit i))).
    assert (TB : forall n i, t n i <= b i) by (intros n i; apply (growing_ineq _ _ (iterates_grow i) (B i))).
    assert (N : forall n i, Rabs (l i - d n i) <= b i - t n i).
    { intros n i. apply limit_near with (fun m => d m i) n; [apply L|]. intros m M.
      eapply Rle_trans; [apply iterates_apart; lia|]. specialize (TB m i). lra. }
    exists l. intros i. split.
    - apply UL_sequence with (fun n => d (S n) i).
      + intros e E. destruct (continuous _ _ (majorised i) t b B e E) as [k K]. exists k. intros n A.
        specialize (K n A). unfold R_dist in *. rewrite Rabs_minus_sym.
        eapply Rle_lt_trans; [|exact K]. rewrite (Rabs_minus_sym (H (t n) i)).
        eapply Rle_trans; [|apply Rle_abs].
        apply (differences _ _ (majorised i)); intros j; [apply iterates_close | apply N].
      + intros e E. destruct (L i e E) as [k K]. exists k. intros n A. apply K. lia.
    - replace (l i) with (l i - 0) by lra. apply limit_near with (fun m => d m i) 0%nat; [apply L|].
      intros m _. rewrite Rminus_0_r. eapply Rle_trans; [apply iterates_close | apply iterates_bounded].
  Qed.
End Iterates.
