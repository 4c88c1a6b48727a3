(** What holds at one point whatever the motions are, and goals shown of it; same accelerations make the same motion. *)
From Coq Require Import String List Bool NArith ZArith Reals Lra Lia.
From Slipproof Require Import Text Syntax Meaning Poly Normal NormalSound.
From Slipproof.claim Require Import Expression Mechanism Claim Forms FormsSound Entails Covers Scopes Inline Points Rising Obligations MotionForms.
Import ListNotations.
Local Open Scope R_scope.

Section Claim.
Variable c : claim.
Notation s := (in_setting c).
Notation m := (of_mechanism s).
Variable x : string -> R.
Hypothesis two_apart : no_name_twice (names_of_motions s 2) = true.

(** Facts that hold at this point, whatever the motions are. *)
Definition here (facts : list form) : Prop :=
  forall u us, no_name_twice (names_of_motions s (length (u :: us))) = true -> Forall (holds (valuation s x (u :: us))) facts.

Lemma agrees_here u us i w : no_name_twice (names_of_motions s (length (u :: us))) = true -> nth_error (u :: us) i = Some w ->
  agrees_with s (valuation s x (u :: us)) (suffix s i) x w.
Proof. apply valuation_agrees. Qed.

Lemma point_here : point s x -> here (point_facts s).
Proof. intros P u us N. apply (point_facts_hold s _ x u P). exact (agrees_here u us 0 u N eq_refl). Qed.
Lemma bicycle_here : bicycle s x -> here (bicycle_facts s).
Proof. intros P u us N. apply (bicycle_facts_hold s _ x u P). exact (agrees_here u us 0 u N eq_refl). Qed.

Lemma here_also f d facts : normal_condition (paper_scope s None) true d = Some f -> is (paper s x) true d -> here facts -> here (f :: facts).
Proof.
  intros N T H u us A. constructor; [|apply H, A]. destruct (agrees_here u us 0 u A eq_refl) as [B _].
  apply (normal_condition_sound _ _ _ (paper_agrees _ s x B) _ _ _ N), T.
Qed.

Lemma paper_condition v i u truth d f : agrees_with s v i x u -> normal_condition (paper_scope s None) truth d = Some f ->
  (holds v f <-> is (paper s x) truth d).
Proof. intros [A _] N. apply (normal_condition_sound v _ _ (paper_agrees v s x A) _ _ _ N). Qed.

Lemma has_value_sound facts d g : here facts -> has_value_goal c facts d = Some g -> goal_holds g -> has_value (paper s x) d.
Proof.
  intros H E G. unfold has_value_goal, value_goal in E. options E. inversion E; subst; clear E.
  set (v := valuation s x [x; x]). destruct (goal_shown _ _ v G (H x [x] two_apart)) as [w [S K]].
  assert (A := agrees_same s _ _ _ _ _ S (agrees_here x [x] 0 x two_apart eq_refl)).
  apply holds_any in K. inversion K as [? ? L|? ? L]; subst; [|inversion L as [? ? M|? ? M]; subst; [|inversion M as [? ? Q|? ? Q]; subst; [|inversion Q]]].
  - apply apart_from_zero_sound in L. destruct A as [A _].
    exact (divisors_sound w _ _ (paper_agrees w s x A) _ _ E2 L).
  - left. apply (paper_condition w _ _ _ _ _ A E0), M.
  - right. apply (paper_condition w _ _ _ _ _ A E1), Q.
Qed.

(** A goal about one motion. *)
Lemma shown_of_motion facts md u fs shown : here facts -> motion s x md u -> motion_forms s 0 md = Some fs ->
  goal_holds (Goal (fs ++ facts) [] shown) -> exists w, agrees_with s w (suffix s 0) x u /\ holds w shown.
Proof.
  intros H M F G. set (v := valuation s x [u; u]). assert (A := agrees_here u [u] 0 u two_apart eq_refl).
  destruct (goal_shown _ _ v G) as [w [S K]].
  - apply Forall_app. split; [apply (motion_forms_sound s v 0 md x u fs A F), M|apply H, two_apart].
  - exists w. split; [exact (agrees_same s _ _ _ _ _ S A)|exact K].
Qed.

Lemma shown_here facts shown : here facts -> goal_holds (Goal facts [] shown) ->
  exists w, agrees_with s w (suffix s 0) x x /\ holds w shown.
Proof.
  intros H G. assert (A := agrees_here x [x] 0 x two_apart eq_refl). destruct (goal_shown _ _ _ G (H x [x] two_apart)) as [w [S K]].
  exists w. split; [exact (agrees_same s _ _ _ _ _ S A)|exact K].
Qed.

Lemma symbols_apart name : In name (symbols s) -> ~ In name (suffixed s 0).
Proof.
  unfold names_of_motions in two_apart. simpl in two_apart. revert two_apart. generalize (symbols s) as ns.
  induction ns as [|n ns IH]; simpl; [tauto|]. intros T [E|I] J; apply andb_true_iff in T; destruct T as [T U]; [|exact (IH U I J)]. subst.
  rewrite negb_true_iff in T. assert (L : is_in name (ns ++ suffixed s 0 ++ suffixed s 1 ++ []) = true); [|congruence].
  apply is_in_In, in_or_app. right. apply in_or_app. left. exact J.
Qed.

Lemma motion_exists facts md fs : here facts -> motion_forms s 0 md = Some fs ->
  goal_holds (Goal facts (suffixed s 0) (All fs)) -> exists u, motion s x md u.
Proof.
  intros H F G. destruct (goal_near _ (valuation s x [x; x]) G (H x [x] two_apart)) as [w [N K]]. apply holds_all in K.
  destruct (agrees_here x [x] 0 x two_apart eq_refl) as [A _]. exists (fun name => w (code name)).
  apply (motion_forms_sound s w 0 md x _ fs); [|exact F|exact K]. split; intros name I.
  - rewrite N; [apply A, I|]. intro J. unfold names_of_motions in two_apart. simpl in two_apart.
    clear - I J two_apart. unfold suffixed in J. revert I two_apart. generalize (symbols s) as ns. induction ns as [|n ns IH]; simpl; [tauto|].
    intros [E|I] T; apply andb_true_iff in T; destruct T as [T U]; [|exact (IH I U)]. subst.
    rewrite negb_true_iff in T. assert (L : is_in name (ns ++ suffixed s 0 ++ suffixed s 1 ++ []) = true); [|congruence].
    apply is_in_In, in_or_app. right. apply in_or_app. left. exact J.
  - simpl. now rewrite append_nil_r.
Qed.

Lemma each_motion_sound facts modes shown ws md : each_motion c facts modes shown = Some ws -> Forall way_holds ws -> In md modes ->
  exists fs g, motion_forms s 0 md = Some fs /\ shown = Some g /\ goal_holds (Goal (fs ++ facts) [] g).
Proof.
  intros E W I. unfold each_motion in E. destruct (map_option_In _ _ _ E _ I) as [w [F J]]. options F. inversion F; subst.
  exists l, f. repeat split; auto. rewrite Forall_forall in W. apply one_goal, W, J.
Qed.

(** Same accelerations, same motion *)

Lemma fraction_free_value v w vs f y z : (forall q, ~ In q vs -> v q = w q) -> fraction_free vs f = true ->
  stands v f y -> stands w f z -> y = z.
Proof.
  intros E F S T. unfold fraction_free in F. apply andb_true_iff in F. destruct F as [F D]. apply andb_true_iff in F. destruct F as [N Q].
  assert (G : apart v (divs f) <-> apart w (divs f)).
  { unfold apart. rewrite !Forall_forall. rewrite forallb_forall in D.
    split; intros H p I; specialize (H p I); rewrite (poly_free_value vs v w p (D p I) E) in *; exact H. }
  destruct y as [y|], z as [z|]; auto.
  - apply stands_some in S, T. destruct S as [_ [_ S]], T as [_ [_ T]]. subst.
    now rewrite (poly_free_value vs v w _ N E), (poly_free_value vs v w _ Q E).
  - apply stands_some in S. apply stands_none in T. tauto.
  - apply stands_none in S. apply stands_some in T. tauto.
Qed.

(** The values of the symbols and of one motion's unknowns. *)
Definition plain_values (u : string -> R) (p : positive) : R :=
  if in_list p (map code (unknowns m)) then u (decode p) else x (decode p).

Lemma in_codes name names : in_list (code name) (map code names) = true <-> In name names.
Proof.
  rewrite in_list_iff, in_map_iff. split; [|intro I; exists name; auto]. intros [n [E I]]. apply code_injective in E. now subst.
Qed.

Lemma plain_agrees u : agrees_with s (plain_values u) (suffix s 0) x u.
Proof.
  split; intros name I; unfold plain_values; simpl suffix; rewrite ?append_nil_r, decode_code.
  - destruct (in_list (code name) (map code (unknowns m))) eqn:J; [|reflexivity]. exfalso. apply in_codes in J.
    clear - I J two_apart. unfold names_of_motions in two_apart. simpl in two_apart. revert I two_apart.
    generalize (symbols s) as ns. induction ns as [|n ns IH]; simpl; [tauto|].
    intros [E|I] T; apply andb_true_iff in T; destruct T as [T U]; [|exact (IH I U)]. subst.
    rewrite negb_true_iff in T. assert (L : is_in name (ns ++ suffixed s 0 ++ suffixed s 1 ++ []) = true); [|congruence].
    apply is_in_In, in_or_app. right. apply in_or_app. left. unfold suffixed. apply in_map_iff. exists name.
    simpl. now rewrite append_nil_r.
  - apply in_codes in I. now rewrite I.
Qed.

Lemma quantity_value u qs : no_name_twice (map fst qs) = true -> forall meant name,
  fold_left (fun names q => with_name (fst q) (value (in_scene s x u) (snd q)) names) qs meant name
  = match find (fun q => String.eqb (fst q) name) qs with Some q => value (in_scene s x u) (snd q) | None => meant name end.
Proof.
  induction qs as [|[n e] qs IH]; intros N meant name; simpl; [reflexivity|]. simpl in N. apply andb_true_iff in N. destruct N as [N M'].
  rewrite (IH M'). unfold with_name. simpl. rewrite (String.eqb_sym name n). destruct (String.eqb_spec n name) as [E|E]; [|reflexivity].
  subst. destruct (find _ qs) as [q|] eqn:F; [|reflexivity]. exfalso. apply find_some in F. destruct F as [F G].
  apply String.eqb_eq in G. assert (J : In name (map fst qs)) by (apply in_map_iff; exists q; auto).
  apply is_in_In in J. now rewrite J in N.
Qed.

Lemma same_accelerations_sound u w : quantities_fit s = true -> (forall a, In a (accelerations m) -> u a = w a) -> same_motion s x u w.
Proof.
  intros Q E name I. unfold quantities_fit in Q. apply andb_true_iff in Q. destruct Q as [Q N].
  apply andb_true_iff in Q. destruct Q as [Q A]. rewrite forallb_forall in Q, A. unfold mechanism_names. rewrite !(quantity_value _ _ N).
  destruct (find (fun q => String.eqb (fst q) name) (quantities m)) as [[n e]|] eqn:F; simpl.
  - apply find_some in F. destruct F as [F G]. simpl in G. apply String.eqb_eq in G. subst n.
    assert (J : In (name, normal_term (inner_scope s "") e) (quantity_forms s "")) by (unfold quantity_forms; apply in_map_iff; exists (name, e); auto).
    specialize (Q _ J). simpl in Q. destruct (normal_term (inner_scope s "") e) as [f|] eqn:T; [|discriminate].
    apply (fraction_free_value (plain_values u) (plain_values w) (map code (forces_of s)) f); [|exact Q| |].
    + intros q K. unfold plain_values. destruct (in_list q (map code (unknowns m))) eqn:L; [|reflexivity].
      apply in_list_iff, in_map_iff in L. destruct L as [k [L M]]. subst q. rewrite !decode_code.
      apply E. destruct (is_in k (accelerations m)) eqn:B; [apply is_in_In, B|]. exfalso. apply K, in_map. unfold forces_of.
      apply filter_In. split; [exact M|]. now rewrite B.
    + apply (normal_term_sound _ _ _ (inner_agrees _ s x (proj1 (plain_agrees u)) "" u (proj2 (plain_agrees u))) _ _ T).
    + apply (normal_term_sound _ _ _ (inner_agrees _ s x (proj1 (plain_agrees w)) "" w (proj2 (plain_agrees w))) _ _ T).
  - apply in_app_or in I. destruct I as [I|I].
    + specialize (A _ I). apply andb_true_iff in A. destruct A as [A D].
      assert (V : forall y, in_scene s x y name = Some (y name)).
      { intro y. unfold in_scene. rewrite define_other.
        - unfold is_in in A. now rewrite A.
        - intro J. apply is_in_In in J. now rewrite J in D. }
      now rewrite !V, (E _ I).
    + exfalso. apply in_map_iff in I. destruct I as [q [I J]]. assert (K := find_none _ _ F _ J). simpl in K. subst.
      now rewrite String.eqb_refl in K.
Qed.
Lemma same_accelerations_hold v i j u w : agrees_with s v (suffix s i) x u -> agrees_with s v (suffix s j) x w -> quantities_fit s = true ->
  holds v (same_accelerations s i j) -> same_motion s x u w.
Proof.
  intros [_ U] [_ W] Q H. apply same_accelerations_sound; [exact Q|]. intros a I.
  assert (J : In a (unknowns m)).
  { unfold quantities_fit in Q. apply andb_true_iff in Q. destruct Q as [Q _]. apply andb_true_iff in Q. destruct Q as [_ A].
    rewrite forallb_forall in A. specialize (A _ I). apply andb_true_iff in A. apply is_in_In, A. }
  unfold same_accelerations in H. apply holds_all in H. rewrite Forall_map, Forall_forall in H. specialize (H _ I).
  change (value_at v (add (variable (code (a ++ suffix s i)%string)) (neg (variable (code (a ++ suffix s j)%string)))) = 0) in H.
  rewrite add_value, neg_value in H. rewrite <- (U _ J), <- (W _ J). unfold variable in H. simpl in H. lra.
Qed.
End Claim.
