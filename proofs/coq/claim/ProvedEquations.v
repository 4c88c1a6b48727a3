(** Equations that follow from others, at any force. *)
From Coq Require Import String List Bool NArith ZArith Reals Lra Lia.
From Slipproof Require Import Text Syntax Meaning Poly Normal NormalSound.
From Slipproof.claim Require Import Expression Mechanism Claim Forms FormsSound Entails Covers Scopes Inline Points Rising Obligations MotionForms Here.
Import ListNotations.
Local Open Scope R_scope.

Section Claim.
Variable c : claim.
Notation s := (in_setting c).
Notation m := (of_mechanism s).
Variable x : string -> R.
Hypothesis two_apart : no_name_twice (names_of_motions s 2) = true.
Variable cells : list form.
Notation here := (Here.here c x).
Let agrees_here := Here.agrees_here c x.

Definition moved (v : positive -> R) (f : R) (p : positive) : R := if Pos.eqb p (code (force s)) then f else v p.

Lemma moved_agrees u f : ~ In (force s) (unknowns m) ->
  agrees_with s (moved (valuation s x [u; u]) f) (suffix s 0) (with_force s x f) u.
Proof.
  intro F. destruct (agrees_here u [u] 0 u two_apart eq_refl) as [A U]. unfold moved, with_force. split; intros name I.
  - destruct (Pos.eqb_spec (code name) (code (force s))) as [E|E]; destruct (String.eqb_spec name (force s)) as [G|G];
      try (apply code_injective in E); try congruence. apply A, I.
  - destruct (Pos.eqb_spec (code (name ++ suffix s 0)%string) (code (force s))) as [E|E]; [|apply U, I].
    apply code_injective in E. simpl suffix in E. rewrite append_nil_r in E. subst. contradiction.
Qed.

Lemma without_force_moved facts u f : here facts -> Forall (holds (moved (valuation s x [u; u]) f)) (without_force c facts).
Proof.
  intro H. specialize (H u [u] two_apart). rewrite Forall_forall in *. intros g I. unfold without_force in I. apply filter_In in I.
  destruct I as [I F]. apply (form_free_holds [code (force s)] (valuation s x [u; u])); [|exact F|apply H, I].
  intros q Q. unfold moved. destruct (Pos.eqb_spec q (code (force s))) as [E|E]; [|reflexivity]. exfalso. apply Q. now left.
Qed.

Lemma equations_have_values model ms es facts values : here facts -> ~ In (force s) (unknowns m) ->
  (forall e, In e es -> linear_equation s e = true) -> model_forms c model = Some ms ->
  map_option (equation_goal c (without_force c facts)) es = Some values -> Forall way_holds (map (fun g => [g]) values) ->
  ~ no_equations c x model es.
Proof.
  intros H U L M V B. rewrite Forall_forall in B. intros [[md [Q N]]|[e [I [N|[f [u N]]]]]].
  - subst. unfold model_forms in M. rewrite N in M. discriminate.
  - rewrite (L e I) in N. discriminate.
  - apply N. destruct (map_option_In _ _ _ V _ I) as [g [F J]]. unfold equation_goal, value_goal in F. options F. inversion F; subst; clear F.
    assert (T := B _ (in_map (fun g => [g]) _ _ J)). apply one_goal in T.
    destruct (goal_shown _ _ _ T (without_force_moved facts u f H)) as [w [X Z]].
    destruct (agrees_same s _ _ _ _ _ X (moved_agrees u f U)) as [P Q].
    assert (Y := motion_agrees w s (with_force s x f) P (suffix s 0) u Q).
    apply holds_any in Z. inversion Z as [? ? D|? ? D]; subst; [|inversion D as [? ? O|? ? O]; subst; [|inversion O as [? ? R|? ? R]; subst; [|inversion R]]].
    + apply apart_from_zero_sound in D. exact (divisors_sound w _ _ Y _ _ E1 D).
    + left. exact (proj1 (normal_condition_sound w _ _ Y _ _ _ E) O).
    + right. exact (proj1 (normal_condition_sound w _ _ Y _ _ _ E0) R).
Qed.

(** Equations and the forms of them, at values that agree. *)
Lemma equations_sound v f u es fs : agrees_with s v (suffix s 0) (with_force s x f) u ->
  normal_all (motion_scope s (suffix s 0)) es = Some fs -> (Forall (holds v) fs <-> satisfies c x f u es).
Proof. intros [P Q] N. apply (normal_all_sound v _ _ _ _ (motion_agrees _ s _ P (suffix s 0) u Q) N). Qed.

Lemma model_sound v f u model ms : agrees_with s v (suffix s 0) (with_force s x f) u -> model_forms c model = Some ms ->
  (Forall (holds v) ms <-> forall md, model = Some md ->
     exists cs, model_equations s md = Some cs /\ all_true (mechanism_names s (with_force s x f) u) cs).
Proof.
  intros [P Q] M. unfold model_forms in M. destruct model as [md|].
  - options M. rewrite (normal_all_sound v _ _ _ _ (mechanism_agrees _ s _ P (suffix s 0) u Q) M). split.
    + intros T md' F. inversion F; subst. eauto.
    + intro T. destruct (T md eq_refl) as [cs [C R]]. congruence.
  - inversion M; subst. split; [discriminate|constructor].
Qed.

Lemma solves_sound v f u model hs ms fs : agrees_with s v (suffix s 0) (with_force s x f) u -> model_forms c model = Some ms ->
  normal_all (motion_scope s (suffix s 0)) hs = Some fs -> (Forall (holds v) (ms ++ fs) <-> solves c x model hs f u).
Proof.
  intros A M N. rewrite Forall_app, (model_sound v f u model ms A M), (equations_sound v f u hs fs A N). unfold solves, satisfies. tauto.
Qed.

Lemma satisfies_app f u es ds : satisfies c x f u (es ++ ds) <-> satisfies c x f u es /\ satisfies c x f u ds.
Proof. apply Forall_app. Qed.
Lemma solves_app model f u es ds : solves c x model (es ++ ds) f u <-> solves c x model es f u /\ satisfies c x f u ds.
Proof. unfold solves, satisfies, all_true. rewrite Forall_app. tauto. Qed.

Lemma normal_all_app scope es ds fs gs : normal_all scope es = Some fs -> normal_all scope ds = Some gs -> normal_all scope (es ++ ds) = Some (fs ++ gs).
Proof.
  unfold normal_all. revert fs. induction es as [|e es IH]; intros fs E D; simpl in *; [inversion E; subst; exact D|].
  options E. inversion E; subst. rewrite (IH _ eq_refl D). reflexivity.
Qed.

Lemma consequence_kind model hs es facts forces ws : what c = Consequence model hs es -> here facts ->
  ways_of_kind c cells facts forces = Some ws -> Forall way_holds ws -> ~ no_value_here c x /\ right_here c x.
Proof.
  intros K H E W. unfold ways_of_kind, no_value_here, right_here in *. rewrite K in *. options E. inversion E; subst; clear E.
  inversion W as [|? ? A B]; subst; clear W. apply one_goal in A. apply andb_true_iff in E0. destruct E0 as [U E0].
  assert (U' : ~ In (force s) (unknowns m)) by (intro I; apply is_in_In in I; now rewrite I in U).
  clear U. rename U' into U. rewrite forallb_forall in E0.
  rename E0 into L, E1 into M, E2 into G, E3 into S, E4 into V. split; [exact (equations_have_values _ _ _ _ _ H U L M V B)|].
  intros f u So. assert (Ag := moved_agrees u f U). apply (solves_sound _ f u model hs _ _ Ag M G) in So.
  destruct (goal_shown _ _ (moved (valuation s x [u; u]) f) A) as [w [X Z]].
  - rewrite app_assoc. apply Forall_app. split; [exact So|exact (without_force_moved facts u f H)].
  - apply holds_all in Z. apply (equations_sound w f u es _ (agrees_same s _ _ _ _ _ X Ag) S), Z.
Qed.

(** Systems *)

(** What is true of an equation depends on the numbers in it. *)
Lemma mentions_link (n k : meanings) truth a r b :
  (forall name, mentions [name] a || mentions [name] b = true -> n name = k name) -> link n truth a r b -> link k truth a r b.
Proof.
  intros H [y [z [Y [Z C]]]]. exists y, z. rewrite <- (mentions_value n k a), <- (mentions_value n k b); auto;
    intros name M; apply H; rewrite M; auto using orb_true_r.
Qed.

Lemma mentions_is (n k : meanings) d : forall truth,
  (forall name, mentions_in [name] d = true -> n name = k name) -> is n truth d -> is k truth d.
Proof.
  induction d as [b|a links|d IH|d IHd e IHe|d IHd e IHe]; intros truth H T; cbn [is mentions_in] in *.
  - exact T.
  - revert a H T. induction links as [|[r b] links IH]; intros a H T; [exact T|].
    assert (H1 : forall name, mentions [name] a || mentions [name] b = true -> n name = k name).
    { intros name M. apply H. simpl. apply orb_true_iff in M. destruct M as [M|M]; rewrite M; rewrite ?orb_true_r; auto. }
    assert (H2 : forall name, mentions [name] b || existsb (fun l => mentions [name] (snd l)) links = true -> n name = k name).
    { intros name M. apply H. simpl. rewrite M. apply orb_true_r. }
    specialize (IH b H2). destruct truth; simpl in *.
    + destruct T as [T R]. split; [exact (mentions_link n k true a r b H1 T)|exact (IH R)].
    + destruct T as [T|R]; [left; exact (mentions_link n k false a r b H1 T)|right; exact (IH R)].
  - apply IH; auto.
  - assert (H1 := fun name M => H name (orb_true_intro _ _ (or_introl M))). assert (H2 := fun name M => H name (orb_true_intro _ _ (or_intror M))).
    destruct truth; [destruct T; split; auto|destruct T; [left|right]; auto].
  - assert (H1 := fun name M => H name (orb_true_intro _ _ (or_introl M))). assert (H2 := fun name M => H name (orb_true_intro _ _ (or_intror M))).
    destruct truth; [destruct T; [left|right]; auto|destruct T; split; auto].
Qed.

Lemma mentions_some_in names d : forall name, In name names -> mentions_in [name] d = true -> mentions_in names d = true.
Proof.
  intros name I. induction d as [b|a links|d IH|d IHd e IHe|d IHd e IHe]; simpl; intro M; auto;
    apply orb_true_iff in M; apply orb_true_iff; destruct M as [M|M]; auto.
  - left. exact (mentions_some names a name I M).
  - right. apply existsb_exists in M. apply existsb_exists. destruct M as [l [J M]]. exists l. split; [exact J|exact (mentions_some names _ name I M)].
Qed.

Lemma unknown_value y u name : unknowns_fit s = true -> In name (unknowns m) -> mechanism_names s y u name = Some (u name).
Proof.
  intros F I. unfold unknowns_fit in F. rewrite forallb_forall in F. specialize (F _ I). apply andb_true_iff in F. destruct F as [D Q].
  apply negb_true_iff in D, Q.
  assert (V : in_scene s y u name = Some (u name)).
  { unfold in_scene. rewrite define_other by (intro J; apply is_in_In in J; congruence). apply is_in_In in I. unfold is_in in I. now rewrite I. }
  rewrite <- V. unfold mechanism_names. clear - Q. generalize (in_scene s y u) at 2 3. revert Q.
  induction (quantities m) as [|[n e] qs IH]; intros Q start; simpl in *; [reflexivity|]. apply orb_false_iff in Q. destruct Q as [Q R].
  rewrite (IH R). unfold with_name. now rewrite Q.
Qed.

Lemma chosen_same f u w es : unknowns_fit s = true -> existsb (mentions_in (map fst (quantities m))) es = false ->
  (forall name, In name (chosen c es) -> w name = u name) -> satisfies c x f w es -> satisfies c x f u es.
Proof.
  intros F Q A S. unfold satisfies, all_true in *. rewrite Forall_forall in *. intros e I. specialize (S e I).
  apply (mentions_is _ _ e true) with (2 := S). intros name M. unfold names_of_motion.
  destruct (existsb (String.eqb name) (unknowns m ++ map fst (quantities m))) eqn:J; [|reflexivity].
  apply is_in_In, in_app_or in J. destruct J as [J|J].
  - rewrite !unknown_value by assumption. f_equal. apply A. apply filter_In. split; [exact J|]. apply existsb_exists. eauto.
  - exfalso. apply not_true_iff_false in Q. apply Q, existsb_exists. exists e. split; [exact I|exact (mentions_some_in _ e name J M)].
Qed.

Lemma system_kind model given hs es facts forces ws : what c = System model given hs es -> here facts ->
  ways_of_kind c cells facts forces = Some ws -> Forall way_holds ws -> ~ no_value_here c x /\ right_here c x.
Proof.
  intros K H E W. unfold ways_of_kind, no_value_here, right_here in *. rewrite K in *. options E. inversion E; subst; clear E.
  inversion W as [|? ? A W']; subst; clear W. inversion W' as [|? ? B W]; subst; clear W'. apply one_goal in A, B.
  repeat match goal with J : _ && _ = true |- _ => apply andb_true_iff in J; destruct J end.
  repeat match goal with J : negb _ = true |- _ => apply negb_true_iff in J end.
  assert (U : ~ In (force s) (unknowns m)) by (intro I; apply is_in_In in I; congruence).
  rewrite forallb_forall in *.
  split; [eapply equations_have_values; eassumption|].
  intros f u. split.
  - intros [w [Same So]]. assert (Ag := moved_agrees w f U). apply (chosen_same f u w); [assumption|assumption|exact Same|].
    apply satisfies_app. assert (So' := So). apply solves_app in So. destruct So as [So Others].
    split; [unfold solves in So; tauto|].
    destruct (goal_shown _ _ (moved (valuation s x [w; w]) f) A) as [v [X Z]].
    + rewrite !app_assoc. apply Forall_app. split; [|exact (without_force_moved facts w f H)]. rewrite <- app_assoc.
      apply (solves_sound _ f w model (given ++ hs) _ _ Ag); [eassumption|apply normal_all_app; eassumption|exact So'].
    + apply holds_all in Z. eapply equations_sound; [exact (agrees_same s _ _ _ _ _ X Ag)|eassumption|exact Z].
  - intro S. apply satisfies_app in S. destruct S as [Sg Se]. assert (Ag := moved_agrees u f U).
    destruct (goal_near _ (moved (valuation s x [u; u]) f) B) as [v [N Z]].
    + apply Forall_app. split; [eapply equations_sound; eassumption|]. apply Forall_app.
      split; [eapply equations_sound; eassumption|exact (without_force_moved facts u f H)].
    + simpl in N, Z. set (w := fun name => v (code (name ++ suffix s 0)%string)).
      assert (Aw : agrees_with s v (suffix s 0) (with_force s x f) w).
      { split; intros name I; [|reflexivity]. destruct Ag as [P _]. rewrite <- (P name I). apply N. intro J.
        apply (symbols_apart c x two_apart name I). unfold not_chosen in J. apply filter_In in J. unfold suffixed. apply in_map_iff.
        exists name. simpl. rewrite append_nil_r. tauto. }
      exists w. split.
      * intros name I. unfold w. rewrite N.
        { apply Ag. unfold chosen in I. apply filter_In in I. tauto. }
        simpl. rewrite append_nil_r. intro J. unfold not_chosen in J. apply filter_In in J. destruct J as [_ J].
        apply is_in_In in I. rewrite I in J. discriminate.
      * apply holds_all in Z. rewrite app_assoc in Z. eapply solves_sound; [exact Aw|eassumption|apply normal_all_app; eassumption|].
        rewrite app_assoc. exact Z.
Qed.
End Claim.
