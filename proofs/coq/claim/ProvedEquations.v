(** Equations that follow from others, at any force. *)
From Coq Require Import String List Bool NArith ZArith Reals Lra Lia.
From Slipproof Require Import Text Syntax Meaning Poly Normal NormalSound.
From Slipproof.claim Require Import Expression Mechanism Claim Forms Entails Covers Scopes Points Rising Obligations MotionForms Here.
Import ListNotations.
Local Open Scope R_scope.

Section Claim.
Variable c : claim.
Notation s := (in_setting c).
Notation m := (of_mechanism s).
Variable x : string -> R.
Hypothesis two_apart : no_name_twice (names_of_motions s 2) = true.
Notation here := (Here.here c x).
Let agrees_here := Here.agrees_here c x.

Definition moved (v : positive -> R) (f : R) (p : positive) : R := if Pos.eqb p (code (force s)) then f else v p.

Lemma moved_agrees u f : ~ In (force s) (unknowns m) ->
  agrees_with s (moved (valuation s x [u; u]) f) (suffix 0) (with_force s x f) u.
Proof.
  intro F. destruct (agrees_here u [u] 0 u two_apart eq_refl) as [A U]. unfold moved, with_force. split; intros name I.
  - destruct (Pos.eqb_spec (code name) (code (force s))) as [E|E]; destruct (String.eqb_spec name (force s)) as [G|G];
      try (apply code_injective in E); try congruence. apply A, I.
  - destruct (Pos.eqb_spec (code (name ++ suffix 0)%string) (code (force s))) as [E|E]; [|apply U, I].
    apply code_injective in E. simpl suffix in E. rewrite append_nil_r in E. subst. contradiction.
Qed.

Lemma without_force_moved facts u f : here facts -> Forall (holds (moved (valuation s x [u; u]) f)) (without_force c facts).
Proof.
  intro H. specialize (H u [u] two_apart). rewrite Forall_forall in *. intros g I. unfold without_force in I. apply filter_In in I.
  destruct I as [I F]. apply (form_free_holds [code (force s)] (valuation s x [u; u])); [|exact F|apply H, I].
  intros q Q. unfold moved. destruct (Pos.eqb_spec q (code (force s))) as [E|E]; [|reflexivity]. exfalso. apply Q. now left.
Qed.

Lemma consequence_kind model hs es facts forces ws : what c = Consequence model hs es -> here facts ->
  ways_of_kind c facts forces = Some ws -> Forall way_holds ws -> ~ no_value_here c x /\ right_here c x.
Proof.
  intros K H E W. unfold ways_of_kind, no_value_here, right_here in *. rewrite K in *. options E. inversion E; subst; clear E.
  inversion W as [|? ? A B]; subst; clear W. apply one_goal in A. apply andb_true_iff in E0. destruct E0 as [U E0].
  assert (U' : ~ In (force s) (unknowns m)) by (intro I; apply is_in_In in I; now rewrite I in U).
  clear U. rename U' into U. rewrite forallb_forall in E0. rewrite Forall_forall in B.
  rename E0 into L, E1 into M, E2 into G, E3 into S, E4 into V. split.
  - intros [[md [Q N]]|[e [I [N|[f [u N]]]]]].
    + subst. unfold model_forms in M. rewrite N in M. discriminate.
    + rewrite (L e I) in N. discriminate.
    + apply N. destruct (map_option_In _ _ _ V _ I) as [g [F J]]. unfold equation_goal, value_goal in F. options F. inversion F; subst; clear F.
      assert (T := B _ (in_map (fun g => [g]) _ _ J)). apply one_goal in T.
      destruct (goal_shown _ _ _ T (without_force_moved facts u f H)) as [w [X Z]].
      destruct (agrees_same s _ _ _ _ _ X (moved_agrees u f U)) as [P Q].
      assert (Y := motion_agrees w s (with_force s x f) P (suffix 0) u Q).
      apply holds_any in Z. inversion Z as [? ? D|? ? D]; subst; [|inversion D as [? ? O|? ? O]; subst; [|inversion O as [? ? R|? ? R]; subst; [|inversion R]]].
      * apply apart_from_zero_sound in D. exact (divisors_sound w _ _ Y _ _ E1 D).
      * left. exact (proj1 (normal_condition_sound w _ _ Y _ _ _ E) O).
      * right. exact (proj1 (normal_condition_sound w _ _ Y _ _ _ E0) R).
  - intros f u [Mo Hy]. assert (Ag := moved_agrees u f U). destruct Ag as [P Q].
    destruct (goal_shown _ _ (moved (valuation s x [u; u]) f) A) as [w [X Z]].
    + apply Forall_app. split; [|apply Forall_app; split; [|exact (without_force_moved facts u f H)]].
      * destruct model as [md|]; simpl in M; [|inversion M; constructor]. destruct (Mo md eq_refl) as [cs [C T]]. rewrite C in M.
        apply (normal_all_sound _ _ _ _ _ (mechanism_agrees _ s _ P (suffix 0) u Q) M), T.
      * apply (normal_all_sound _ _ _ _ _ (motion_agrees _ s _ P (suffix 0) u Q) G), Hy.
    + destruct (agrees_same s _ _ _ _ _ X (moved_agrees u f U)) as [P' Q']. apply holds_all in Z.
      apply (normal_all_sound _ _ _ _ _ (motion_agrees w s _ P' (suffix 0) u Q') S), Z.
Qed.
End Claim.
