(** Values of all names at a point and at motions, and that the forms of motions hold of motions. *)
From Coq Require Import String List Bool NArith ZArith Reals Lra Lia.
From Slipproof Require Import Text Syntax Meaning Poly Normal NormalSound.
From Slipproof.claim Require Import Expression Mechanism Claim Forms FormsSound Entails Covers Scopes Points Rising Obligations.
Import ListNotations.
Local Open Scope R_scope.

Definition way_holds (w : way) : Prop := List.Exists goal_holds w.

Lemma one_goal g : way_holds [g] -> goal_holds g.
Proof. intro H. inversion H as [? ? G|? ? G]; subst; [exact G|inversion G]. Qed.

Lemma map_option_In {A B} (f : A -> option B) xs : forall ys, map_option f xs = Some ys ->
  forall x, In x xs -> exists y, f x = Some y /\ In y ys.
Proof.
  induction xs as [|x xs IH]; intros ys H y I; simpl in H; [contradiction|]. options H. inversion H; subst. destruct I as [I|I].
  - subst. exists b. split; [exact E|now left].
  - destruct (IH _ eq_refl _ I) as [z [F J]]. exists z. split; [exact F|now right].
Qed.

Lemma map_option_from {A B} (f : A -> option B) xs : forall ys, map_option f xs = Some ys ->
  forall y, In y ys -> exists x, f x = Some y /\ In x xs.
Proof.
  induction xs as [|x xs IH]; intros ys H y I; simpl in H; options H; inversion H; subst; [contradiction|]. destruct I as [I|I].
  - subst. exists x. split; [exact E|now left].
  - destruct (IH _ eq_refl _ I) as [z [F J]]. exists z. split; [exact F|now right].
Qed.

(** A condition is not both. *)
Lemma links_consistent names links : forall a, links_hold names a links -> links_fail names a links -> False.
Proof.
  induction links as [|[r b] links IH]; intros a H F; simpl in *; [exact F|]. destruct H as [[x [y [X [Y C]]]] H].
  destruct F as [[x' [y' [X' [Y' N]]]]|F]; [|exact (IH b H F)]. congruence.
Qed.
Lemma consistent names c : is names true c -> is names false c -> False.
Proof.
  induction c as [b|a links|c IH|c IHc d IHd|c IHc d IHd]; simpl; intros T F.
  - congruence.
  - exact (links_consistent _ _ _ T F).
  - apply IH; assumption.
  - destruct T, F; auto.
  - destruct T, F; auto.
Qed.

(** Values of all names *)

Definition lookup (t : list (string * R)) (name : string) : R :=
  match find (fun e => String.eqb (fst e) name) t with Some e => snd e | None => 0 end.

Lemma lookup_in t name r : no_name_twice (map fst t) = true -> In (name, r) t -> lookup t name = r.
Proof.
  unfold lookup. induction t as [|[n q] t IH]; simpl; intros N I; [contradiction|]. apply andb_true_iff in N. destruct N as [N M].
  destruct I as [I|I].
  - inversion I; subst. now rewrite String.eqb_refl.
  - destruct (String.eqb_spec n name) as [E|E]; [|apply IH; assumption]. subst. exfalso.
    assert (J : In name (map fst t)) by (apply in_map_iff; exists (name, r); auto). apply is_in_In in J. now rewrite J in N.
Qed.

Section Setting.
Variable s : setting.
Notation m := (of_mechanism s).

Definition values_of (x : string -> R) (us : list (string -> R)) : list (string * R) :=
  map (fun name => (name, x name)) (symbols s)
  ++ flat_map (fun iu => map (fun name => ((name ++ suffix s (fst iu))%string, snd iu name)) (unknowns m)) (combine (seq 0 (length us)) us).
Definition valuation (x : string -> R) (us : list (string -> R)) (p : positive) : R := lookup (values_of x us) (decode p).

Lemma values_of_names x us : map fst (values_of x us) = names_of_motions s (length us).
Proof.
  unfold values_of, names_of_motions, suffixed. rewrite map_app, map_map. simpl. rewrite map_id. f_equal.
  generalize 0%nat as i. induction us as [|u us IH]; intro i; simpl; [reflexivity|]. rewrite map_app, map_map. simpl. f_equal. apply IH.
Qed.

Lemma valuation_agrees x us i u : no_name_twice (names_of_motions s (length us)) = true -> nth_error us i = Some u ->
  agrees_with s (valuation x us) (suffix s i) x u.
Proof.
  intros N E. rewrite <- (values_of_names x us) in N. split; intros name I; unfold valuation; rewrite decode_code; apply lookup_in;
    try exact N; unfold values_of; apply in_or_app.
  - left. apply in_map_iff. exists name. auto.
  - right. apply in_flat_map. exists (i, u). split.
    + assert (K : forall us j, nth_error us i = Some u -> In ((j + i)%nat, u) (combine (seq j (length us)) us)).
      { clear. intro us. revert i. induction us as [|w us IH]; intros [|i] j E; simpl in *; try discriminate.
        - inversion E. left. now rewrite Nat.add_0_r.
        - right. replace (j + S i)%nat with (S j + i)%nat by lia. apply IH, E. }
      exact (K us 0%nat E).
    + apply in_map_iff. exists name. auto.
Qed.

Definition same_names (w v : positive -> R) : Prop := forall name, w (code name) = v (code name).

Lemma agrees_same w v i x u : same_names w v -> agrees_with s v i x u -> agrees_with s w i x u.
Proof. intros S [A U]. split; intros name I; rewrite S; auto. Qed.

Lemma goal_shown facts shown v : goal_holds (Goal facts [] shown) -> Forall (holds v) facts ->
  exists w, same_names w v /\ holds w shown.
Proof. intros G F. exists v. split; [intro name; reflexivity|exact (G v F)]. Qed.

(** Motions *)

Lemma normal_all_sound v scope meant cs fs : agrees v scope meant -> normal_all scope cs = Some fs ->
  (Forall (holds v) fs <-> all_true meant cs).
Proof.
  intro A. unfold normal_all, all_true. revert fs. induction cs as [|c cs IH]; intros fs H; simpl in H.
  - inversion H; subst. split; constructor.
  - options H. inversion H; subst. rewrite (Forall_cons_iff (holds v)), (Forall_cons_iff (is meant true)), (IH _ eq_refl).
    rewrite (normal_condition_sound v _ _ A _ _ _ E). tauto.
Qed.

Lemma motion_forms_sound v i md x u fs : agrees_with s v (suffix s i) x u -> motion_forms s i md = Some fs ->
  (Forall (holds v) fs <-> motion s x md u).
Proof.
  intros [A U] H. unfold motion_forms in H. options H. rewrite (normal_all_sound v _ _ _ _ (mechanism_agrees v s x A _ u U) H).
  unfold motion, all_true. rewrite E, Forall_app. split.
  - intros [D C]. eauto.
  - intros [cs [F [D C]]]. inversion F; subst. auto.
Qed.

Lemma motion_forms_modelled i md fs : motion_forms s i md = Some fs -> modelled s md.
Proof. intro H. unfold motion_forms in H. options H. unfold modelled. congruence. Qed.

Lemma of_contacts_each strict given names cs : forall md conds rest, of_contacts strict given cs md = Some (conds, rest) ->
  all_true names conds -> forall c, In c cs -> exists st, In st (contact_states given c) /\ all_true names (contact_conditions strict c st).
Proof.
  induction cs as [|c cs IH]; intros md conds rest H T k I; [contradiction|].
  destruct md as [|st md]; simpl in H; [discriminate|]. options H. inversion H; subst. apply Forall_app in T. destruct T as [T R].
  destruct I as [I|I].
  - subst. unfold state_in in E. apply existsb_exists in E. destruct E as [st' [J Q]].
    assert (st' = st) by (destruct st, st'; try discriminate; reflexivity). subst. eauto.
  - destruct p as [conds' rest']. simpl in *. exact (IH _ _ _ E0 R _ I).
Qed.

Lemma of_rubbings_each strict cs names full rs : forall md conds, of_rubbings strict cs full rs md = Some conds ->
  all_true names conds -> forall r, In r rs -> exists st, In st (rubbing_states cs full r) /\ all_true names (rubbing_conditions strict r st).
Proof.
  induction rs as [|r rs IH]; intros md conds H T k I; [contradiction|].
  destruct md as [|st md]; simpl in H; [discriminate|]. options H. inversion H; subst. apply Forall_app in T. destruct T as [T R].
  destruct I as [I|I].
  - subst. unfold state_in in E. apply existsb_exists in E. destruct E as [st' [J Q]].
    assert (st' = st) by (destruct st, st'; try discriminate; reflexivity). subst. eauto.
  - exact (IH _ _ E0 R _ I).
Qed.

(** A friction element's states, whatever its contact does. *)
Lemma contact_in_state strict given cs : forall md conds rest i c st, of_contacts strict given cs md = Some (conds, rest) ->
  nth_error cs i = Some c -> nth_error md i = Some st -> In st (contact_states given c).
Proof.
  induction cs as [|k cs IH]; intros md conds rest i c st H C S; [destruct i; discriminate|].
  destruct md as [|t md]; simpl in H; [discriminate|]. options H. inversion H; subst. destruct i as [|i]; simpl in C, S.
  - inversion C; inversion S; subst. unfold state_in in E. apply existsb_exists in E. destruct E as [t' [J Q]].
    assert (t' = st) by (destruct st, t'; try discriminate; reflexivity). now subst.
  - destruct p as [conds' rest']. exact (IH _ _ _ i c st E0 C S).
Qed.

Lemma lifts_only given c : In Lift (contact_states given c) ->
  may_lift given c || match begins c with Apart => true | _ => false end = true.
Proof.
  unfold contact_states. destruct (may_lift given c); [reflexivity|]. simpl. destruct (friction c), (begins c), (bilateral c); simpl;
    intuition; try discriminate.
Qed.

Lemma pulled_only given c st : In st (contact_states given c) -> is_pulled st = true -> bilateral c = true.
Proof.
  unfold contact_states. destruct (bilateral c); [reflexivity|]. destruct (friction c), (begins c), (may_lift given c); simpl;
    intuition; subst; try discriminate.
Qed.

Lemma rubbing_states_all strict md conds rest r st : of_contacts strict (given_parameters s) (contacts m) md = Some (conds, rest) ->
  In st (rubbing_states (contacts m) md r) -> In st (all_rubbing_states s r).
Proof.
  intros H I. unfold rubbing_states, all_rubbing_states in *. destruct (holder r) as [i|]; [|exact I].
  destruct (nth_error (contacts m) i) as [c|] eqn:C; [|contradiction]. destruct (nth_error md i) as [t|] eqn:T; [|contradiction].
  assert (S := contact_in_state _ _ _ _ _ _ _ _ _ H C T).
  assert (B : is_pulled t = true -> bilateral c = true) by (apply (pulled_only _ _ _ S)).
  destruct t; simpl in *; rewrite ?B in * by reflexivity; try (apply in_or_app; left; exact I);
    try (apply in_or_app; right; apply in_or_app; left; exact I).
  - destruct I as [I|[]]. subst. rewrite (lifts_only _ _ S). apply in_or_app. right. apply in_or_app. right. now left.
  - apply in_app_or in I. apply in_or_app. destruct I as [I|I]; [now left|right; apply in_or_app; now left].
Qed.

Lemma any_of_states_sound v scope meant states f : agrees v scope meant -> any_of_states scope states = Some f ->
  (exists cs, In cs states /\ all_true meant cs) -> holds v f.
Proof.
  intros A H [cs [I T]]. unfold any_of_states in H. options H. inversion H; subst.
  destruct (map_option_In _ _ _ E _ I) as [g [G J]]. simpl in G. options G. inversion G; subst.
  apply holds_any, Exists_exists. exists (All l0). split; [exact J|]. apply holds_all.
  apply (normal_all_sound v _ _ _ _ A E0), T.
Qed.

Lemma any_motion_sound v x md u fs : agrees_with s v (suffix s 0) x u -> any_motion_forms s = Some fs -> motion s x md u ->
  Forall (holds v) fs.
Proof.
  intros [A U] H [conds [M [D C]]]. assert (N := mechanism_agrees v s x A (suffix s 0) u U).
  unfold any_motion_forms in H. options H. inversion H; subst. unfold mode_conditions in M. options M. inversion M; subst.
  destruct p as [cc rest]. simpl in *. apply Forall_app in C. destruct C as [C R]. apply Forall_app. split; [|apply Forall_app; split].
  - apply (normal_all_sound v _ _ _ _ N E), D.
  - apply Forall_forall. intros f I. destruct (map_option_from _ _ _ E0 _ I) as [k [F J]].
    apply (any_of_states_sound v _ _ _ _ N F). destruct (of_contacts_each _ _ _ _ _ _ _ E2 C _ J) as [st [S T]].
    exists (contact_conditions (strict s) k st). split; [|exact T]. apply in_map, S.
  - apply Forall_forall. intros f I. destruct (map_option_from _ _ _ E1 _ I) as [k [F J]].
    apply (any_of_states_sound v _ _ _ _ N F). destruct (of_rubbings_each _ _ _ _ _ _ _ E3 R _ J) as [st [S T]].
    exists (rubbing_conditions (strict s) k st). split; [|exact T]. apply in_map. exact (rubbing_states_all _ _ _ _ _ _ E2 S).
Qed.
End Setting.
