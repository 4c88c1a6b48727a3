(** One motion, and in which modes it is. *)
From Coq Require Import String List Bool NArith ZArith Reals Lra Lia.
From Slipproof Require Import Text Syntax Meaning Poly Normal NormalSound.
From Slipproof.claim Require Import Expression Mechanism Claim Forms FormsSound Entails Covers Scopes Points Rising Obligations MotionForms Here.
Import ListNotations.
Local Open Scope R_scope.

Lemma in_pairs {A} (xs : list A) y z : In y xs -> In z xs -> In (y, z) (pairs xs) \/ In (z, y) (pairs xs).
Proof.
  induction xs as [|x xs IH]; [contradiction|]. cbn [pairs]. intros Y Z. rewrite !in_app_iff. destruct Y as [Y|Y].
  - subst. left. left. apply in_map, Z.
  - destruct Z as [Z|Z]; [subst; right; left; apply in_map; now right|]. destruct (IH Y Z); tauto.
Qed.

Lemma same_motion_sym s x u w : same_motion s x u w -> same_motion s x w u.
Proof. intros S name I. symmetry. exact (S name I). Qed.
Lemma same_motion_trans s x u w v : same_motion s x u w -> same_motion s x w v -> same_motion s x u v.
Proof. intros S T name I. rewrite (S name I). exact (T name I). Qed.

(** Of one setting, with or without boundary motions. *)
Section OneMotion.
Variable c : claim.
Notation s := (in_setting c).
Variable x : string -> R.
Hypothesis two_apart : no_name_twice (names_of_motions s 2) = true.

Lemma listed_motion v i modes f u : agrees_with s v (suffix s i) x u -> listed_forms s i modes = Some f ->
  (holds v f <-> exists md, In md modes /\ motion s x md u).
Proof.
  intros A E. unfold listed_forms in E. options E. inversion E; subst. rewrite holds_any, Exists_exists. split.
  - intros [g [I H]]. destruct (map_option_from _ _ _ E0 _ I) as [md [F J]]. options F. inversion F; subst.
    exists md. split; [exact J|]. apply (motion_forms_sound s v i md x u _ A E1). apply holds_all, H.
  - intros [md [J M]]. destruct (map_option_In _ _ _ E0 _ J) as [g [F I]]. simpl in F. options F. inversion F; subst.
    exists (All l0). split; [exact I|]. apply holds_all. apply (motion_forms_sound s v i md x u _ A E1), M.
Qed.

Lemma one_motion_sound facts cells modes ws : quantities_fit s = true -> here c x facts ->
  one_motion_ways s facts cells modes = Some ws -> Forall way_holds ws ->
  (exists md u, motion s x md u)
  /\ (forall md u, motion s x md u -> exists listed, In listed modes /\ motion_in s x listed u)
  /\ forall md u other w, motion s x md u -> motion s x other w -> same_motion s x u w.
Proof.
  intros Q H E W. unfold one_motion_ways in E. options E. inversion E; subst; clear E. rename f into listed, f0 into again, l into any.
  inversion W as [|? ? C W']; subst; clear W. apply one_goal in C. apply Forall_app in W'. destruct W' as [Cells One].
  rewrite Forall_flat_map, Forall_forall in Cells. rewrite Forall_forall in One.
  assert (cell_at : forall u w, exists cell, In cell cells /\ holds (valuation s x [u; w]) cell).
  { intros u w. assert (Z := C _ (H u [w] two_apart)). apply holds_any, Exists_exists in Z. exact Z. }
  assert (there : exists md u, In md modes /\ motion s x md u).
  { destruct (cell_at x x) as [cell [I Z]]. specialize (Cells _ I). inversion Cells as [|? ? G _]; subst. apply one_goal in G.
    destruct (goal_near _ (valuation s x [x; x]) G) as [w [N L]].
    - constructor; [exact Z|exact (H x [x] two_apart)].
    - simpl in N, L. set (u := fun name => w (code (name ++ suffix s 0)%string)).
      assert (A : agrees_with s w (suffix s 0) x u).
      { split; intros name J; [|reflexivity]. rewrite N; [apply (agrees_here c x x [x] 0 x two_apart eq_refl), J|].
        exact (symbols_apart c x two_apart name J). }
      apply (listed_motion w 0 modes listed u A E0) in L. destruct L as [md [J M]]. eauto. }
  assert (one : forall md u other w, In md modes -> In other modes -> motion s x md u -> motion s x other w -> same_motion s x u w).
  { assert (each : forall md u other w, In (md, other) (pairs modes) -> motion s x md u -> motion s x other w -> same_motion s x u w).
    { intros md u other w I M M'. destruct (map_option_In _ _ _ E3 _ I) as [g [F J]]. simpl in F. options F. inversion F; subst.
      assert (G := one_goal _ (One _ J)). assert (A := agrees_here c x u [w] 0 u two_apart eq_refl).
      assert (B := agrees_here c x u [w] 1 w two_apart eq_refl).
      apply (same_accelerations_hold c x two_apart (valuation s x [u; w]) 0 1 u w A B Q). apply G.
      apply Forall_app. split; [apply (motion_forms_sound s _ 0 md x u _ A E), M|].
      apply Forall_app. split; [apply (motion_forms_sound s _ 1 other x w _ B E4), M'|apply H, two_apart]. }
    intros md u other w I J M M'. destruct (in_pairs modes md other I J) as [P|P]; [exact (each _ _ _ _ P M M')|].
    apply same_motion_sym. exact (each _ _ _ _ P M' M). }
  assert (listed_in : forall md u, motion s x md u -> exists listed, In listed modes /\ motion_in s x listed u).
  { intros md u M. destruct there as [other [w [J M']]]. destruct (cell_at u w) as [cell [I Z]]. specialize (Cells _ I).
    inversion Cells as [|? ? _ G]; subst. inversion G as [|? ? G' _]; subst.
    assert (A := agrees_here c x u [w] 0 u two_apart eq_refl). assert (B := agrees_here c x u [w] 1 w two_apart eq_refl).
    assert (F : Forall (holds (valuation s x [u; w])) (cell :: facts)) by (constructor; [exact Z|apply H, two_apart]).
    assert (Y := any_motion_sound s _ x md u _ A E2 M).
    inversion G' as [? ? K|? ? K]; subst; [|inversion K as [? ? K'|? ? K']; subst; [|inversion K']].
    - assert (L := K (valuation s x [u; w])). apply (listed_motion _ 0 modes listed u A E0) in L.
      + destruct L as [md' [J' L]]. exists md'. split; [exact J'|]. exists u. split; [exact L|]. intros name _. reflexivity.
      + apply Forall_app. split; [exact Y|exact F].
    - exists other. split; [exact J|]. exists w. split; [exact M'|].
      apply (same_accelerations_hold c x two_apart (valuation s x [u; w]) 0 1 u w A B Q). apply K'.
      apply Forall_app. split; [exact Y|]. constructor; [|exact F]. apply (listed_motion _ 1 modes again w B E1). eauto. }
  split; [|split; [exact listed_in|]].
  - destruct there as [md [u [_ M]]]. eauto.
  - intros md u other w M M'. destruct (listed_in _ _ M) as [p [I [y [Y S]]]]. destruct (listed_in _ _ M') as [q [J [z [Z S']]]].
    apply (same_motion_trans s x u y w S). apply (same_motion_trans s x y z w (one p y q z I J Y Z)). exact (same_motion_sym s x w z S').
Qed.
End OneMotion.

Section Claim.
Variable c : claim.
Notation s := (in_setting c).
Variable x : string -> R.
Hypothesis two_apart : no_name_twice (names_of_motions s 2) = true.
Let closed : claim := Claim (with_boundaries s) (what c) (region c) (at_forces c).

(** What is claimed of the motions is claimed of those with boundary motions. *)
Lemma all_motions_sound facts cells modes ws : quantities_fit (with_boundaries s) = true -> here c x facts ->
  one_motion_ways (with_boundaries s) facts cells modes = Some ws -> Forall way_holds ws -> one_motion_in c x modes.
Proof.
  intros Q H E W. assert (H' : here closed x facts) by exact H.
  destruct (one_motion_sound closed x two_apart facts cells modes ws Q H' E W) as [A [B C]].
  split; [exact A|]. split; [exact B|exact C].
Qed.

Lemma reference_region_sound without_force facts r ws : here c x without_force ->
  reference_ways c without_force facts r = Some ws -> Forall way_holds ws -> has_value (paper s x) (fst r).
Proof.
  intros H E W. unfold reference_ways in E. options E. inversion E; subst; clear E. inversion W as [|? ? A _]; subst.
  apply one_goal in A. exact (has_value_sound c x two_apart _ _ _ H E1 A).
Qed.

Lemma reference_sound without_force facts r ws : here c x without_force -> here c x facts ->
  reference_ways c without_force facts r = Some ws -> Forall way_holds ws ->
  has_value (paper s x) (fst r)
  /\ (is (paper s x) true (fst r) -> has_value (paper s x) (snd r) /\ has_value (paper s x) (closure true (snd r))).
Proof.
  intros H0 H E W. split; [exact (reference_region_sound without_force facts r ws H0 E W)|].
  unfold reference_ways in E. options E. inversion E; subst; clear E.
  inversion W as [|? ? A W']; subst. inversion W' as [|? ? B W'']; subst. inversion W'' as [|? ? D _]; subst. apply one_goal in A, B, D.
  intro R. assert (H' := here_also c x _ _ _ E0 R H).
  split; [exact (has_value_sound c x two_apart _ _ _ H' E2 B)|exact (has_value_sound c x two_apart _ _ _ H' E3 D)].
Qed.

(** Near, or plainly not. *)
Lemma near_or_not r : has_value (paper s x) (fst r) ->
  (is (paper s x) true (fst r) -> has_value (paper s x) (closure true (snd r))) ->
  Claim.near c x r \/ is (paper s x) false (Both (fst r) (closure true (snd r))).
Proof.
  intros [R|R] V; [|right; now left]. destruct (V R) as [F|F]; [left; split; assumption|right; now right].
Qed.

Lemma here_is truth f d facts : normal_condition (paper_scope s None) truth d = Some f -> is (paper s x) truth d ->
  here c x facts -> here c x (f :: facts).
Proof.
  intros N T H u us A. constructor; [|apply H, A]. destruct (agrees_here c x u us 0 u A eq_refl) as [B _].
  apply (normal_condition_sound _ _ _ (paper_agrees _ s x B) _ _ _ N), T.
Qed.

Lemma here_beyond {A} (of : A -> reference) items facts : forall fs, map_option (fun i => beyond_form c (of i)) items = Some fs ->
  (forall i, In i items -> is (paper s x) false (Both (fst (of i)) (closure true (snd (of i))))) -> here c x facts -> here c x (fs ++ facts).
Proof.
  induction items as [|i items IH]; intros fs E F H; simpl in E; [inversion E; exact H|]. options E. inversion E; subst. simpl.
  apply (here_is false f _ _ E0).
  - apply F. now left.
  - apply IH; [reflexivity| |exact H]. intros j J. apply F. now right.
Qed.

Lemma one_or_all {A} (P Q : A -> Prop) items : (forall i, In i items -> P i \/ Q i) ->
  (exists i, In i items /\ P i) \/ forall i, In i items -> Q i.
Proof.
  induction items as [|i items IH]; intro H; [right; intros i []|]. destruct (H i (or_introl eq_refl)) as [Y|Y].
  - left. exists i. split; [now left|exact Y].
  - destruct IH as [[j [J Z]]|Z]; [intros j J; apply H; now right|left; exists j; split; [now right|exact Z]|].
    right. intros j [J|J]; [now subst|exact (Z j J)].
Qed.

(** A condition without the force, at another force. *)
Lemma at_another_force d f t : normal_condition (paper_scope s None) true d = Some f -> form_free [code (force s)] f = true ->
  is (paper s x) true d -> is (paper s (with_force s x t)) true d.
Proof.
  intros N F T. apply (normal_condition_sound _ _ _ (at_force_scope s x t) _ _ _ N).
  assert (A : agrees (fun q => x (decode q)) (paper_scope s None) (paper s x)).
  { apply paper_agrees. intros name _. now rewrite decode_code. }
  apply (form_free_holds [code (force s)] (fun q => x (decode q))); [|exact F|apply (normal_condition_sound _ _ _ A _ _ _ N), T].
  intros q O. unfold at_force. destruct (Pos.eqb_spec q (code (force s))) as [E|E]; [|reflexivity]. destruct O. left. congruence.
Qed.
End Claim.

Section Kind.
Variable c : claim.
Notation s := (in_setting c).

Lemma unique_valued x cells claims except modes facts forces ws :
  no_name_twice (names_of_motions s 2) = true -> what c = Unique claims except modes -> bicycle s x ->
  is (paper s x) true (region c) -> ways_of_kind c cells facts forces = Some ws -> Forall way_holds ws ->
  forall r, In r (map snd claims ++ except) -> has_value (paper s x) (fst r).
Proof.
  intros T K B R E W r I. unfold ways_of_kind in E. rewrite K in E. options E. inversion E; subst; clear E.
  apply Forall_app in W. destruct W as [Values _]. apply Forall_concat in Values. rewrite Forall_forall in Values.
  destruct (map_option_In _ _ _ E2 _ I) as [w [G J]].
  refine (reference_region_sound c x T _ _ r w _ G (Values _ J)). exact (here_also c x _ _ _ E0 R (bicycle_here c x B)).
Qed.

Lemma unique_kind x cells claims except modes yes forces ws :
  no_name_twice (names_of_motions s 2) = true -> what c = Unique claims except modes -> point s x ->
  normal_condition (paper_scope s None) true (region c) = Some yes -> is (paper s x) true (region c) ->
  normal_condition (paper_scope s None) true (at_forces c) = Some forces -> has_value (paper s x) (at_forces c) ->
  ways_of_kind c cells (yes :: point_facts s) forces = Some ws -> Forall way_holds ws ->
  ~ no_value_here c x /\ (right_here c x \/ nothing_here c x).
Proof.
  intros T K P Y R F V E W. unfold ways_of_kind in E. rewrite K in E. options E. inversion E; subst; clear E.
  repeat match goal with J : _ && _ = true |- _ => apply andb_true_iff in J; destruct J end.
  assert (S : f = yes) by congruence. subst f.
  apply Forall_app in W. destruct W as [Values W]. apply Forall_app in W. destruct W as [Stated Rest].
  apply Forall_concat in Values, Stated. rewrite Forall_forall in Values, Stated.
  assert (facts_at : forall y, point s y -> is (paper s y) true (region c) -> here c y (yes :: point_facts s)).
  { intros y Q Z. apply (here_also c y _ _ _ E0 Z), point_here, Q. }
  assert (valued : forall r, In r (map snd claims ++ except) -> forall y, point s y -> is (paper s y) true (region c) ->
    has_value (paper s y) (fst r)
    /\ (is (paper s y) true (fst r) -> has_value (paper s y) (snd r) /\ has_value (paper s y) (closure true (snd r)))).
  { intros r I y Q Z. destruct (map_option_In _ _ _ E2 _ I) as [w [G J]].
    refine (reference_sound c y T _ _ r w _ (facts_at y Q Z) G (Values _ J)).
    exact (here_also c y _ _ _ E0 Z (bicycle_here c y (of_bicycle _ _ Q))). }
  assert (Hx := facts_at x P R).
  assert (decided : forall r, In r (map snd claims ++ except) ->
    Claim.near c x r \/ is (paper s x) false (Both (fst r) (closure true (snd r)))).
  { intros r I. destruct (valued r I x P R) as [A B]. apply (near_or_not c x r A). intro Z. apply B, Z. }
  split.
  - unfold no_value_here. rewrite K. intros [[r [I [U|[t [Q [Z U]]]]]]|[[_ U]|[_ [_ [_ U]]]]].
    + exact (U (proj1 (valued r I x P R))).
    + apply U. apply (valued r I _ Q); [|exact Z]. apply (at_another_force c x _ yes t E0); assumption.
    + exact (U V).
    + apply U. intros k I B. unfold all_modelled_here in *. rewrite forallb_forall in *. 
      match goal with J : forall k, In k (contacts _) -> _ |- _ => specialize (J _ I); now rewrite B in J end.
  - destruct V as [V|V]; [|right; unfold nothing_here; rewrite K; now left].
    destruct (one_or_all _ _ except (fun r I => decided r (in_or_app _ _ _ (or_intror I)))) as [X|X].
    { right. unfold nothing_here. rewrite K. right; left. exact X. }
    left. unfold right_here. rewrite K. assert (Common : here c x (l0 ++ forces :: yes :: point_facts s)).
    { apply (here_beyond c x (fun r => r) except _ _ E3 X). apply (here_also c x _ _ _ F V), Hx. }
    intros ms [[md [r [I [S M]]]]|[N M]]; subst ms.
    + destruct (map_option_In _ _ _ E4 _ I) as [w [G J]]. simpl in G. destruct (stated_form c r) as [h|] eqn:S0; [|discriminate].
      apply (all_motions_sound c x T (h :: l0 ++ forces :: yes :: point_facts s) [All []] [md] w); auto.
      apply (here_is c x true h (Both (fst r) (snd r)) _ S0); [exact S|exact Common].
    + apply (all_motions_sound c x T (l2 ++ l0 ++ forces :: yes :: point_facts s) cells modes l3); auto.
      apply (here_beyond c x snd claims _ _ E5); [|exact Common]. intros [md r] I.
      destruct (decided r) as [Z|Z]; [apply in_or_app; left; apply in_map_iff; exists (md, r); auto|destruct (N md r I Z)|exact Z].
Qed.
End Kind.
