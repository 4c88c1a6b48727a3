(** Limits: from some value of the parameter on. *)
From Coq Require Import String List Bool NArith ZArith Reals Lra Lia.
From Slipproof Require Import Text Syntax Meaning Poly Normal NormalSound.
From Slipproof.claim Require Import Expression Mechanism Claim Forms FormsSound Entails Covers Scopes Inline Points Rising Obligations MotionForms Here.
Import ListNotations.
Local Open Scope R_scope.

Section Claim.
Variable c : claim.
Notation s := (in_setting c).

Lemma limit_kind cells p h from ws : what c = Limit p h from -> ways c cells = Some ws -> Forall way_holds ws ->
  forall x, bicycle s x -> judged c x Right \/ judged c x SaysNothing.
Proof.
  intros K E W x B. unfold ways in E. rewrite K in E. simpl in E. options E. inversion E; subst; clear E.
  apply andb_true_iff in E0. destruct E0 as [C T]. assert (I := interval_sound s x C).
  unfold ways_of_kind in E4. rewrite K in E4. destruct from as [from|]; [|discriminate]. options E4. inversion E4; subst; clear E4.
  inversion W as [|? ? W1 W']; subst. inversion W' as [|? ? W2 W'']; subst. inversion W'' as [|? ? W3 _]; subst.
  apply one_goal in W1, W2, W3. clear W W' W''.
  repeat match goal with J : _ && _ = true |- _ => apply andb_true_iff in J; destruct J end.
  repeat match goal with J : negb _ = true |- _ => apply negb_true_iff in J end.
  inversion E1; subst. rename f into yes.
  (* The bicycles with other values of the parameter. *)
  set (y := with_parameter x p). assert (agree : forall r name, values_with x p r (code name) = y r name) by apply values_with_agree.
  assert (paper_at : forall r, agrees (values_with x p r) (paper_scope s None) (paper s (y r))).
  { intro r. apply paper_agrees. intros name _. apply agree. }
  assert (valued : forall r, bicycle s (y r) -> has_value (paper s (y r)) (region c)).
  { intros r Q. exact (has_value_sound c (y r) T _ _ _ (bicycle_here c (y r) Q) E2 W1). }
  assert (grows : forall r, x p <= r -> bicycle s (y r)) by (intros r L; now apply rising_bicycle).
  assert (region_at : forall r, is (paper s (y r)) true (region c) <-> is (paper s (y (x p))) true (region c)).
  { intro r. rewrite <- !(normal_condition_sound _ _ _ (paper_at _) _ _ _ E6).
    apply (form_free_holds [code p]); [apply values_with_other|assumption]. }
  assert (same : forall r t, value (paper s (y (x p))) from = Some t -> value (paper s (y r)) from = Some t).
  { intros r t Q. rewrite <- Q. apply (fraction_free_value (values_with x p r) (values_with x p (x p)) [code p] f1); try assumption.
    - apply values_with_other.
    - exact (normal_term_sound _ _ _ (paper_at r) _ _ E).
    - exact (normal_term_sound _ _ _ (paper_at (x p)) _ _ E). }
  assert (lies : forall r, value (paper s (y r)) (Symbol p) = Some r).
  { intro r. simpl. unfold paper. rewrite define_other by (intro J; apply is_in_In in J; congruence).
    unfold is_in in *. match goal with J : existsb _ (symbols s) = true |- _ => rewrite J end.
    unfold y, with_parameter. now rewrite String.eqb_refl. }
  assert (shown : forall r t, is (paper s (y (x p))) true (region c) -> value (paper s (y (x p))) from = Some t -> t < r ->
                    bicycle s (y r) -> is (paper s (y r)) true h).
  { intros r t R V L Q. assert (A := here_also c (y r) _ _ _ E6 (proj2 (region_at r) R) (bicycle_here c (y r) Q)).
    destruct (shown_here c (y r) T (f2 :: yes :: bicycle_facts s) f5) as [w [N Z]]; [|exact W2|].
    - refine (here_also c (y r) _ _ _ E0 _ A). simpl. split; [|exact Logic.I]. exists t, r. split; [apply same, V|]. split; [apply lies|exact L].
    - exact (proj1 (paper_condition c (y r) w _ _ _ _ _ N E7) Z). }
  assert (start : is (paper s (y (x p))) true (region c) -> exists t, value (paper s (y (x p))) from = Some t).
  { intro R. assert (A := here_also c (y (x p)) _ _ _ E6 R (bicycle_here c _ (grows _ (Rle_refl _)))).
    destruct (shown_here c _ T _ _ A W3) as [w [N Z]]. apply (paper_condition c _ w _ _ _ _ _ N E5) in Z.
    destruct Z as [[t [_ [V _]]] _]. eauto. }
  assert (beyond : forall v, exists r, v < r /\ x p <= r).
  { intro v. exists (Rmax v (x p) + 1). assert (P := Rmax_l v (x p)). assert (Q := Rmax_r v (x p)). lra. }
  unfold judged, judged_where, right_here, nothing_here, no_value_here, mostly, mostly_nothing, mostly_no_value, at_the_end. rewrite K.
  fold y. destruct (valued _ (grows _ (Rle_refl _))) as [R|R].
  - left. destruct (start R) as [t V]. assert (R' := fun r => proj2 (region_at r) R).
    assert (ends : exists r, t < r /\ bicycle s (y r) /\ True) by (destruct (beyond t) as [r [L Q]]; eauto).
    assert (N : ~ (forall v, (exists r, v < r /\ bicycle s (y r) /\ True) ->
                   exists r, v < r /\ bicycle s (y r) /\ is (paper s (y r)) true (region c) /\ is (paper s (y r)) false h)).
    { intro M. destruct (M t ends) as [r [L [Q [_ Z]]]]. exact (consistent _ _ (shown r t R V L Q) Z). }
    split; [exact I|]. split; [reflexivity|]. split; [|split; [exact N|]].
    + intros [_ M]. destruct (M t ends) as [r [L [Q [U|[_ U]]]]]; apply U; [exact (valued r Q)|left; exact (shown r t R V L Q)].
    + intros v _. destruct (beyond (Rmax v t)) as [r [L Q]]. exists r. assert (L1 := Rmax_l v t). assert (L2 := Rmax_r v t).
      split; [lra|]. split; [exact (grows r Q)|]. split; [exact (R' r)|]. apply (shown r t R V); [lra|exact (grows r Q)].
  - right. assert (F' : forall r, bicycle s (y r) -> is (paper s (y r)) false (region c)).
    { intros r Q. destruct (valued r Q) as [Z|Z]; [|exact Z]. apply (proj1 (region_at r)) in Z. destruct (consistent _ _ Z R). }
    assert (some_one : exists r, x p - 1 < r /\ bicycle s (y r) /\ True).
    { exists (x p). split; [lra|]. split; [exact (grows _ (Rle_refl _))|exact Logic.I]. }
    assert (N : forall truth, ~ (forall v, (exists r, v < r /\ bicycle s (y r) /\ True) ->
                   exists r, v < r /\ bicycle s (y r) /\ is (paper s (y r)) true (region c) /\ is (paper s (y r)) truth h)).
    { intros truth M. destruct (M _ some_one) as [r [_ [Q [Z _]]]]. exact (consistent _ _ Z (F' r Q)). }
    split; [exact I|]. right. split; [reflexivity|]. split; [|split; [exact (N false)|split; [exact (N true)|]]].
    + intros [_ M]. destruct (M _ some_one) as [r [_ [Q [U|[Z _]]]]]; [exact (U (valued r Q))|exact (consistent _ _ Z (F' r Q))].
    + intros v [r [L [Q _]]]. exists r. split; [exact L|]. split; [exact Q|exact (F' r Q)].
Qed.
End Claim.
