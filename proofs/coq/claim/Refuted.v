(** The other direction: a point at which a claim that something exists is right, or at which another is wrong. *)
From Coq Require Import String List Bool NArith ZArith Reals Lra Lia.
From Slipproof Require Import Text Syntax Meaning Poly Normal NormalSound.
From Slipproof.claim Require Import Expression Mechanism Claim Forms FormsSound Entails Covers Scopes Points Rising Obligations MotionForms Here ProvedEquations Proved.
Import ListNotations.
Local Open Scope R_scope.

Section Claim.
Variable c : claim.
Notation s := (in_setting c).

(** What values [w] say of the paper's symbols, and of the unknowns of a motion. *)
Definition symbols_in (w : positive -> R) (name : string) : R := w (code name).
Definition motion_in_values (w : positive -> R) (i : nat) (name : string) : R := w (code (name ++ suffix s i)%string).

Lemma values_agree w i : agrees_with s w (suffix s i) (symbols_in w) (motion_in_values w i).
Proof. split; intros name I; reflexivity. Qed.

Lemma here_and_more fs names more : point_forms s = Some fs -> goal_holds (Goal [] names (All (fs ++ more))) ->
  exists w, point s (symbols_in w) /\ Forall (holds w) more.
Proof.
  intros F G. destruct (goal_near _ (fun _ => 0) G (Forall_nil _)) as [w [_ H]]. apply holds_all, Forall_app in H. destruct H as [H M].
  exists w. split; [|exact M]. apply (point_of_forms s w _ _ F H). intros name _. reflexivity.
Qed.

Lemma somewhere_sound more modes g : somewhere c more modes = Some g -> goal_holds g ->
  exists w, point s (symbols_in w) /\ Forall (holds w) more
            /\ forall i md, In (i, md) (combine (seq 0 (length modes)) modes) -> motion s (symbols_in w) md (motion_in_values w i).
Proof.
  intros E G. unfold somewhere in E. options E. inversion E; subst.
  destruct (here_and_more _ _ _ E0 G) as [w [Q H]]. apply Forall_app in H. destruct H as [M H]. exists w. split; [exact Q|]. split; [exact M|].
  intros i md I. destruct (map_option_In _ _ _ E1 _ I) as [fs [F J]]. simpl in F.
  apply (motion_forms_sound s w i md _ _ fs (values_agree w i) F). rewrite Forall_forall in *. intros f K. apply H, in_concat. eauto.
Qed.

Lemma condition_in w truth d f : normal_condition (paper_scope s None) truth d = Some f ->
  (holds w f <-> is (paper s (symbols_in w)) truth d).
Proof. intro N. apply (paper_condition c (symbols_in w) w "" (motion_in_values w 0)); [exact (values_agree w 0)|exact N]. Qed.

Lemma listed_modes (modes : list mode) md : In md modes -> exists i, In (i, md) (combine (seq 0 (length modes)) modes).
Proof.
  generalize 0%nat. induction modes as [|k modes IH]; intros n I; [contradiction|]. simpl. destruct I as [I|I].
  - subst. exists n. now left.
  - destruct (IH (S n) I) as [i J]. exists i. now right.
Qed.

Lemma modelled_of_motion x md u : motion s x md u -> modelled s md.
Proof. intros [cs [F _]]. unfold modelled. congruence. Qed.

Lemma exists_proved cells modes ws : what c = Claim.Exists modes -> ways c cells = Some ws -> Forall way_holds ws ->
  exists x, point s x /\ judged c x Right.
Proof.
  intros K E W. unfold ways in E. rewrite K in E. options E. inversion E; subst. apply andb_true_iff in E0. destruct E0 as [C _].
  inversion W as [|? ? A _]; subst. apply one_goal in A. destruct (somewhere_sound _ _ _ E4 A) as [w [Q [M H]]].
  inversion M as [|? ? Y M']; subst. inversion M' as [|? ? F _]; subst.
  assert (R : right_here c (symbols_in w)).
  { unfold right_here. rewrite K. split; [apply (condition_in w _ _ _ E2), F|]. intros md I.
    destruct (listed_modes _ _ I) as [i J]. eexists. exact (H i md J). }
  exists (symbols_in w). split; [exact Q|]. unfold judged, judged_where. rewrite K. split; [exact (interval_sound _ _ C)|].
  split; [apply (condition_in w _ _ _ E1), Y|]. split; [|exact R]. unfold no_value_here. rewrite K. intros [N _]. exact (N R).
Qed.

Lemma exists_refuted modes ws : what c = Claim.Exists modes -> refuting_ways c = Some ws -> Forall way_holds ws ->
  forall x, point s x -> judged c x SaysNothing.
Proof.
  intros K E W x Q. unfold refuting_ways in E. rewrite K in E. options E. inversion E; subst. apply andb_true_iff in E0. destruct E0 as [C T].
  apply andb_true_iff in E3. destruct E3 as [_ D].
  inversion W as [|? ? A W']; subst. inversion W' as [|? ? B W'']; subst. inversion W'' as [|? ? G _]; subst. apply one_goal in A, B, G.
  assert (H := point_here c x Q). unfold judged, judged_where. rewrite K. split; [exact (interval_sound _ _ C)|].
  destruct (has_value_sound c x T _ _ _ H E5 A) as [R|R]; [right; split; [exact R|]|now left].
  assert (H' := here_also c x _ _ _ E1 R H). assert (V := has_value_sound c x T _ _ _ H' E6 B).
  assert (N : ~ right_here c x).
  { unfold right_here. rewrite K. intros [F M]. destruct (motions_for c x modes M) as [us U]. assert (L := Forall2_length _ _ _ U).
    destruct us as [|u us].
    - destruct modes; [|discriminate]. simpl in *. inversion E4; subst.
      destruct (goal_shown _ _ (valuation s x [x; x]) G) as [v [_ Z]]; [|exact Z].
      apply (here_also c x _ _ _ E2 F H' x [x] T).
    - assert (D' : no_name_twice (names_of_motions s (length (u :: us))) = true) by (rewrite <- L; exact D).
      destruct (goal_shown _ _ (valuation s x (u :: us)) G) as [v [_ Z]]; [|exact Z].
      apply Forall_app. split; [|exact (here_also c x _ _ _ E2 F H' u us D')].
      apply Forall_forall. intros z I. apply in_concat in I. destruct I as [fs [I J]].
      destruct (map_option_from _ _ _ E4 _ I) as [[i md] [O P]]. simpl in O.
      destruct (numbered_motion c x _ _ U _ _ _ P) as [w [X [_ Y]]]. rewrite Nat.sub_0_r in X.
      assert (M' := proj2 (motion_forms_sound s _ i md x w fs (agrees_here c x u us i w D' X) O) Y).
      rewrite Forall_forall in M'. exact (M' _ J). }
  split; [|unfold nothing_here; rewrite K; exact N].
  unfold no_value_here. rewrite K. intros [_ [U|[md [I U]]]]; [exact (U V)|].
  destruct (listed_modes _ _ I) as [i J]. destruct (map_option_In _ _ _ E4 _ J) as [fs [F _]].
  exact (U (motion_forms_modelled _ _ _ _ F)).
Qed.

(** Some listed motion, at values where everything else that is shown holds. *)
Lemma of_one_sound w any modes : map_option (fun md => let* fs := motion_forms s 0 md in Some (All fs)) modes = Some any ->
  holds w (Any any) -> exists md, In md modes /\ motion s (symbols_in w) md (motion_in_values w 0).
Proof.
  intros E H. apply holds_any, Exists_exists in H. destruct H as [f [I H]]. destruct (map_option_from _ _ _ E _ I) as [md [F J]].
  options F. inversion F; subst. exists md. split; [exact J|]. apply holds_all in H.
  exact (proj1 (motion_forms_sound s w 0 md _ _ _ (values_agree w 0) E0) H).
Qed.

(** A solution of the hypotheses of which an equation is false, at a point where all of them have values. *)
Lemma equations_refuted_sound yes model hs es ws : normal_condition (paper_scope s None) true (region c) = Some yes ->
  no_name_twice (names_of_motions s 2) = true -> equations_refuted c yes model hs es = Some ws -> Forall way_holds ws ->
  exists x, point s x /\ is (paper s x) true (region c) /\ ~ no_equations c x model (hs ++ es)
            /\ exists f u, solves c x model hs f u /\ ~ satisfies c x f u es.
Proof.
  intros Y T E W. unfold equations_refuted in E. options E. inversion E; subst; clear E.
  inversion W as [|? ? G B]; subst; clear W. apply one_goal in G. apply andb_true_iff in E0. destruct E0 as [U L].
  assert (U' : ~ In (force s) (unknowns (of_mechanism s))) by (intro I; apply is_in_In in I; now rewrite I in U).
  rewrite forallb_forall in L. destruct (here_and_more _ _ _ E1 G) as [w [Q M]]. inversion M as [|? ? R M']; subst.
  inversion M' as [|? ? N So]; subst. apply (condition_in w _ _ _ Y) in R. exists (symbols_in w). split; [exact Q|]. split; [exact R|].
  split.
  - apply (equations_have_values c (symbols_in w) T model l0 (hs ++ es) (yes :: bicycle_facts s) l3); auto.
    apply (here_also c _ _ _ _ Y R), bicycle_here, Q.
  - set (f := symbols_in w (force s)). exists f, (motion_in_values w 0).
    assert (A : agrees_with s w (suffix s 0) (with_force s (symbols_in w) f) (motion_in_values w 0)).
    { split; intros name I; [|reflexivity]. unfold with_force, f. destruct (String.eqb_spec name (force s)); [now subst|reflexivity]. }
    split; [exact (proj1 (solves_sound c _ w f _ model hs _ _ A E2 E3) So)|]. intro S.
    apply holds_any, Exists_exists in N. destruct N as [g [I N]]. destruct (map_option_from _ _ _ E4 _ I) as [e [F J]].
    destruct A as [P V]. apply (normal_condition_sound w _ _ (motion_agrees w s _ P _ _ V) _ _ _ F) in N.
    unfold satisfies, all_true in S. rewrite Forall_forall in S. exact (consistent _ _ (S e J) N).
Qed.

Ltac take_apart M := repeat match type of M with
  | Forall _ (_ :: _) => let A := fresh "A" in let B := fresh "M" in inversion M as [|? ? A B]; subst; clear M; rename B into M
  end.

Theorem ways_refute ws : refuting_ways c = Some ws -> Forall way_holds ws -> (forall modes, what c <> Claim.Exists modes) ->
  exists x, point s x /\ judged c x Wrong.
Proof.
  intros E W X. unfold refuting_ways in E. options E. apply andb_true_iff in E0. destruct E0 as [C T].
  assert (I := fun x => interval_sound _ x C). unfold judged, judged_where.
  destruct (what c) as [md|modes|[|md modes] h|modes|modes|h|claims|claims|model hs es|model given hs es|claims except modes|p h from] eqn:K; try discriminate;
    [| | | |exfalso; exact (X _ eq_refl)| | | | | ].
  8: { destruct (equations_refuted_sound _ _ _ _ _ E1 T E W) as [x [Q [R [V [t [u [So N]]]]]]]. exists x. split; [exact Q|].
       split; [apply I|]. split; [exact R|]. unfold no_value_here, right_here, nothing_here. rewrite K. repeat split; [exact V| |].
       - intro A. exact (N (A t u So)).
       - intro A. exact (A t u So). }
  8: { destruct (equations_refuted_sound _ _ _ _ _ E1 T E W) as [x [Q [R [V [t [u [So N]]]]]]]. exists x. split; [exact Q|].
       split; [apply I|]. split; [exact R|]. unfold no_value_here, right_here, nothing_here. rewrite K. repeat split.
       - rewrite app_assoc. exact V.
       - intro A. apply N. assert (B := proj1 (A t u)). apply satisfies_app in B; [tauto|]. exists u. auto.
       - intro A. exact (proj1 (A t u) So). }
  all: options E; inversion E; subst; inversion W as [|? ? G _]; subst; apply one_goal in G.
  - destruct (somewhere_sound _ _ _ E3 G) as [w [Q [M H]]]. take_apart M. exists (symbols_in w). split; [exact Q|].
    assert (N := H 0%nat md (or_introl eq_refl)). apply (condition_in w _ _ _ E1) in A. apply (condition_in w _ _ _ E0) in A0.
    split; [apply I|]. split; [exact A|]. unfold no_value_here, right_here, nothing_here. rewrite K. repeat split.
    + intros [U|U]; [apply U; now right|exact (U (modelled_of_motion _ _ _ N))].
    + intros [_ B]. exact (consistent _ _ (B (ex_intro _ _ N)) A0).
    + tauto.
  - destruct (here_and_more _ _ _ E3 G) as [w [Q M]]. take_apart M. exists (symbols_in w). split; [exact Q|].
    apply (condition_in w _ _ _ E1) in A. apply (condition_in w _ _ _ E2) in A0.
    destruct (of_one_sound w _ _ E0 A1) as [md [J N]].
    split; [apply I|]. split; [exact A|]. unfold no_value_here, right_here, nothing_here, wrong_anyway. rewrite K. repeat split.
    + intros [U|[_ [U _]]]; [apply U; now left|]. apply U. split; [exact A0|]. eauto.
    + intro B. exact (B _ _ J N).
    + intro B. exact (consistent _ _ A0 B).
  - destruct (somewhere_sound _ _ _ E3 G) as [w [Q [M _]]]. take_apart M. exists (symbols_in w). split; [exact Q|].
    apply (condition_in w _ _ _ E1) in A. apply (condition_in w _ _ _ E2) in A0. apply (condition_in w _ _ _ E0) in A1.
    split; [apply I|]. split; [exact A|]. unfold no_value_here, right_here, nothing_here. rewrite K. repeat split.
    + intros [U|[_ U]]; [apply U; now left|apply U; now right].
    + intro B. exact (consistent _ _ B A1).
    + intro B. exact (consistent _ _ A0 B).
  - destruct (here_and_more _ _ _ E3 G) as [w [Q M]]. take_apart M. exists (symbols_in w). split; [exact Q|].
    apply (condition_in w _ _ _ E1) in A. apply (condition_in w _ _ _ E2) in A0.
    destruct (of_one_sound w _ _ E0 A1) as [md' [J N]].
    assert (F : is (names_of_motion s (symbols_in w) (motion_in_values w 0)) false h).
    { destruct (values_agree w 0) as [B U].
      apply (normal_condition_sound w _ _ (motion_agrees w s _ B _ _ U) _ _ _ E4), A2. }
    split; [apply I|]. split; [exact A|]. unfold no_value_here, right_here, nothing_here, wrong_anyway. rewrite K. repeat split.
    + intros [U|[_ [U _]]]; [apply U; now left|]. apply U. split; [exact A0|]. exists md', (motion_in_values w 0). split; [exact J|split; [exact N|exact F]].
    + intro B. exact (consistent _ _ (B _ _ J N) F).
    + intros [B|[_ B]]; [exact (consistent _ _ A0 B)|exact (B _ _ J N)].
  - destruct (somewhere_sound _ _ _ E5 G) as [w [Q [M _]]]. take_apart M. exists (symbols_in w). split; [exact Q|].
    apply (condition_in w _ _ _ E1) in A. apply holds_any in A0.
    split; [apply I|]. split; [exact A|]. unfold no_value_here, right_here, nothing_here. rewrite K.
    inversion A0 as [? ? B|? ? B]; subst; [|inversion B as [? ? D|? ? D]; subst; [rename D into B'|inversion D]].
    + apply holds_all in B. take_apart B. apply (condition_in w _ _ _ E2) in A1. apply (condition_in w _ _ _ E4) in A2. repeat split.
      * intros [U|U]; apply U; [now left|now right].
      * intros [B' _]. exact (consistent _ _ (B' A1) A2).
      * tauto.
    + apply holds_all in B'. take_apart B'. apply (condition_in w _ _ _ E3) in A1. apply (condition_in w _ _ _ E0) in A2. repeat split.
      * intros [U|U]; apply U; [now right|now left].
      * intros [_ B'']. exact (consistent _ _ (B'' A1) A2).
      * tauto.
  - destruct (somewhere_sound _ _ _ E3 G) as [w [Q [M _]]]. take_apart M. rename A into Y. exists (symbols_in w). split; [exact Q|].
    apply (condition_in w _ _ _ E1) in Y. rewrite Forall_forall in M.
    assert (N : forall r f, In (r, f) claims -> is (paper s (symbols_in w)) false r).
    { intros r' f' J. destruct (map_option_In _ _ _ E0 _ J) as [z [F O]]. exact (proj1 (condition_in w _ _ _ F) (M _ O)). }
    split; [apply I|]. split; [exact Y|]. unfold no_value_here, right_here, nothing_here. rewrite K. repeat split.
    + intros [_ [r' [f' [J U]]]]. apply U. right. exact (N _ _ J).
    + intros [r' [f' [J U]]]. exact (consistent _ _ U (N _ _ J)).
    + tauto.
  - destruct (somewhere_sound _ _ _ E3 G) as [w [Q [M _]]]. take_apart M. rename A into Y. rename A0 into Z. exists (symbols_in w). split; [exact Q|].
    apply (condition_in w _ _ _ E1) in Y. apply (condition_in w _ _ _ E2) in Z. rewrite Forall_forall in M.
    assert (N : forall r f, In (r, f) claims -> is (paper s (symbols_in w)) false r \/ is (paper s (symbols_in w)) false f).
    { intros r' f' J. destruct (map_option_In _ _ _ E0 _ J) as [z [F O]]. simpl in F. options F. inversion F; subst. specialize (M _ O).
      apply holds_any in M. inversion M as [? ? B|? ? B]; subst; [left; exact (proj1 (condition_in w _ _ _ E4) B)|].
      inversion B as [? ? D|? ? D]; subst; [right; exact (proj1 (condition_in w _ _ _ E5) D)|inversion D]. }
    split; [apply I|]. split; [exact Y|]. unfold no_value_here, right_here, nothing_here. rewrite K. repeat split.
    + intros [U|[_ [_ [r' [f' [J [[U V]|[U V]]]]]]]]; [apply U; now left| |].
      * destruct (N _ _ J) as [B|B]; [apply U; now right|exact (V B)].
      * destruct (N _ _ J) as [B|B]; [exact (consistent _ _ U B)|apply V; now right].
    + intros [r' [f' [J [U V]]]]. destruct (N _ _ J) as [B|B]; [exact (consistent _ _ U B)|exact (consistent _ _ V B)].
    + intro B. exact (consistent _ _ Z B).
Qed.
End Claim.
