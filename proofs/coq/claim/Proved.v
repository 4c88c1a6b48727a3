(** Where all goals hold, the claim is right or says nothing at every point; or it is wrong at one. *)
From Coq Require Import String List Bool NArith ZArith Reals Lra Lia.
From Slipproof Require Import Text Syntax Meaning Poly Normal NormalSound.
From Slipproof.claim Require Import Expression Mechanism Claim Forms Entails Covers Scopes Points Obligations.
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
  ++ flat_map (fun iu => map (fun name => ((name ++ suffix (fst iu))%string, snd iu name)) (unknowns m)) (combine (seq 0 (length us)) us).
Definition valuation (x : string -> R) (us : list (string -> R)) (p : positive) : R := lookup (values_of x us) (decode p).

Lemma values_of_names x us : map fst (values_of x us) = names_of_motions s (length us).
Proof.
  unfold values_of, names_of_motions, suffixed. rewrite map_app, map_map. simpl. rewrite map_id. f_equal.
  generalize 0%nat as i. induction us as [|u us IH]; intro i; simpl; [reflexivity|]. rewrite map_app, map_map. simpl. f_equal. apply IH.
Qed.

Lemma valuation_agrees x us i u : no_name_twice (names_of_motions s (length us)) = true -> nth_error us i = Some u ->
  agrees_with s (valuation x us) (suffix i) x u.
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
Proof. intros G F. destruct (G v F) as [w [N H]]. exists w. split; [intro name; apply N; intros []|exact H]. Qed.

(** Motions *)

Lemma normal_all_sound v scope meant cs fs : agrees v scope meant -> normal_all scope cs = Some fs ->
  (Forall (holds v) fs <-> all_true meant cs).
Proof.
  intro A. unfold normal_all, all_true. revert fs. induction cs as [|c cs IH]; intros fs H; simpl in H.
  - inversion H; subst. split; constructor.
  - options H. inversion H; subst. rewrite (Forall_cons_iff (holds v)), (Forall_cons_iff (is meant true)), (IH _ eq_refl).
    rewrite (normal_condition_sound v _ _ A _ _ _ E). tauto.
Qed.

Lemma motion_forms_sound v i md x u fs : agrees_with s v (suffix i) x u -> motion_forms s i md = Some fs ->
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

Lemma any_motion_sound v x md u fs : agrees_with s v (suffix 0) x u -> any_motion_forms s = Some fs -> motion s x md u ->
  Forall (holds v) fs.
Proof.
  intros [A U] H [conds [M [D C]]]. assert (N := mechanism_agrees v s x A (suffix 0) u U).
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
  agrees_with s (valuation s x (u :: us)) (suffix i) x w.
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
  goal_holds (Goal (fs ++ facts) [] shown) -> exists w, agrees_with s w (suffix 0) x u /\ holds w shown.
Proof.
  intros H M F G. set (v := valuation s x [u; u]). assert (A := agrees_here u [u] 0 u two_apart eq_refl).
  destruct (goal_shown _ _ v G) as [w [S K]].
  - apply Forall_app. split; [apply (motion_forms_sound s v 0 md x u fs A F), M|apply H, two_apart].
  - exists w. split; [exact (agrees_same s _ _ _ _ _ S A)|exact K].
Qed.

Lemma shown_here facts shown : here facts -> goal_holds (Goal facts [] shown) ->
  exists w, agrees_with s w (suffix 0) x x /\ holds w shown.
Proof.
  intros H G. assert (A := agrees_here x [x] 0 x two_apart eq_refl). destruct (goal_shown _ _ _ G (H x [x] two_apart)) as [w [S K]].
  exists w. split; [exact (agrees_same s _ _ _ _ _ S A)|exact K].
Qed.

Lemma motion_exists facts md fs : here facts -> motion_forms s 0 md = Some fs ->
  goal_holds (Goal facts (suffixed s 0) (All fs)) -> exists u, motion s x md u.
Proof.
  intros H F G. destruct (G (valuation s x [x; x]) (H x [x] two_apart)) as [w [N K]]. apply holds_all in K.
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

Lemma plain_agrees u : agrees_with s (plain_values u) (suffix 0) x u.
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

Lemma define_other ds name : ~ In name (map fst ds) -> forall names, define ds names name = names name.
Proof.
  unfold define. induction ds as [|[n e] ds IH]; simpl; intros N names; [reflexivity|].
  rewrite IH by tauto. unfold with_name. destruct (String.eqb_spec name n); [subst; tauto|reflexivity].
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
Lemma same_accelerations_hold v i j u w : agrees_with s v (suffix i) x u -> agrees_with s v (suffix j) x w -> quantities_fit s = true ->
  holds v (same_accelerations s i j) -> same_motion s x u w.
Proof.
  intros [_ U] [_ W] Q H. apply same_accelerations_sound; [exact Q|]. intros a I.
  assert (J : In a (unknowns m)).
  { unfold quantities_fit in Q. apply andb_true_iff in Q. destruct Q as [Q _]. apply andb_true_iff in Q. destruct Q as [_ A].
    rewrite forallb_forall in A. specialize (A _ I). apply andb_true_iff in A. apply is_in_In, A. }
  unfold same_accelerations in H. apply holds_all in H. rewrite Forall_map, Forall_forall in H. specialize (H _ I).
  change (value_at v (add (variable (code (a ++ suffix i)%string)) (neg (variable (code (a ++ suffix j)%string)))) = 0) in H.
  rewrite add_value, neg_value in H. rewrite <- (U _ J), <- (W _ J). unfold variable in H. simpl in H. lra.
Qed.

(** The kinds *)

Lemma interval_kind md facts forces ws : what c = Interval md -> here facts ->
  normal_condition (paper_scope s None) true (at_forces c) = Some forces -> has_value (paper s x) (at_forces c) ->
  ways_of_kind c facts forces = Some ws -> Forall way_holds ws -> ~ no_value_here c x /\ right_here c x.
Proof.
  intros K H N V E W. unfold ways_of_kind, no_value_here, right_here in *. rewrite K in *. options E. inversion E; subst.
  inversion W as [|? ? A W']; subst. inversion W' as [|? ? B _]; subst. apply one_goal in A, B.
  split; [intros [U|U]; [exact (U V)|exact (U (motion_forms_modelled _ _ _ _ E0))]|]. split.
  - intro T. apply (motion_exists (forces :: facts) md l); [|exact E0|exact B]. apply (here_also _ _ _ N T H).
  - intros [u M]. destruct (shown_of_motion facts md u l forces H M E0 A) as [w [G S]].
    apply (paper_condition w _ _ _ _ _ G N), S.
Qed.

Lemma impossible_kind modes facts forces ws : what c = Impossible modes -> here facts ->
  normal_condition (paper_scope s None) true (at_forces c) = Some forces -> is (paper s x) true (at_forces c) ->
  ways_of_kind c facts forces = Some ws -> Forall way_holds ws -> ~ no_value_here c x /\ right_here c x.
Proof.
  intros K H N T E W. unfold ways_of_kind, no_value_here, right_here in *. rewrite K in *.
  assert (R : forall md u, In md modes -> ~ motion s x md u).
  { intros md u I M. destruct (each_motion_sound _ _ _ _ _ E W I) as [fs [g [F [S G]]]]. inversion S; subst.
    destruct (shown_of_motion _ md u fs _ (here_also _ _ _ N T H) M F G) as [w [_ Z]]. exact Z. }
  split; [|exact R]. intros [U|[_ [_ [md [I U]]]]]; [apply U; now left|].
  destruct (each_motion_sound _ _ _ _ _ E W I) as [fs [g [F _]]]. exact (U (motion_forms_modelled _ _ _ _ F)).
Qed.

Lemma formula_kind modes holds_here facts forces ws : what c = Formula modes holds_here -> here facts ->
  normal_condition (paper_scope s None) true (at_forces c) = Some forces -> is (paper s x) true (at_forces c) ->
  ways_of_kind c facts forces = Some ws -> Forall way_holds ws -> ~ no_value_here c x /\ right_here c x.
Proof.
  intros K H N T E W. unfold ways_of_kind, no_value_here, right_here in *. rewrite K in *.
  assert (F := here_also _ _ _ N T H). destruct modes as [|md modes].
  - options E. inversion E; subst. inversion W as [|? ? A _]; subst. apply one_goal in A.
    destruct (shown_here _ _ F A) as [w [G S]]. apply (paper_condition w _ _ _ _ _ G E0) in S.
    split; [|exact S]. intros [U|[_ U]]; apply U; now left.
  - assert (R : forall md' u, In md' (md :: modes) -> motion s x md' u -> is (names_of_motion s x u) true holds_here).
    { intros md' u I M. destruct (each_motion_sound _ _ _ _ _ E W I) as [fs [g [L [S G]]]].
      destruct (shown_of_motion _ md' u fs _ F M L G) as [w [A Z]].
      destruct A as [A U]. apply (normal_condition_sound w _ _ (motion_agrees w s x A _ u U) _ _ _ S), Z. }
    split; [|exact R]. intros [U|[_ [_ [[md' [I U]]|[md' [u [I [M U]]]]]]]].
    + apply U. now left.
    + destruct (each_motion_sound _ _ _ _ _ E W I) as [fs [g [L _]]]. exact (U (motion_forms_modelled _ _ _ _ L)).
    + apply U. left. exact (R md' u I M).
Qed.

Lemma equivalence_kind holds_here facts forces ws : what c = Equivalence holds_here -> here facts ->
  normal_condition (paper_scope s None) true (at_forces c) = Some forces -> has_value (paper s x) (at_forces c) ->
  ways_of_kind c facts forces = Some ws -> Forall way_holds ws -> ~ no_value_here c x /\ right_here c x.
Proof.
  intros K H N V E W. unfold ways_of_kind, no_value_here, right_here in *. rewrite K in *. options E. inversion E; subst.
  inversion W as [|? ? A W']; subst. inversion W' as [|? ? B W'']; subst. inversion W'' as [|? ? D _]; subst. apply one_goal in A, B, D.
  split.
  - intros [U|U]; [exact (U V)|]. exact (U (has_value_sound _ _ _ H E1 D)).
  - split; intro T.
    + destruct (shown_here _ _ (here_also _ _ _ N T H) A) as [w [G S]]. apply (paper_condition w _ _ _ _ _ G E0), S.
    + destruct (shown_here _ _ (here_also _ _ _ E0 T H) B) as [w [G S]]. apply (paper_condition w _ _ _ _ _ G N), S.
Qed.

Lemma one_region_sound v i u claims f : agrees_with s v i x u -> one_region c claims = Some f -> holds v f ->
  exists r g, In (r, g) claims /\ is (paper s x) true r.
Proof.
  intros A E H. unfold one_region in E. options E. inversion E; subst. apply holds_any, Exists_exists in H. destruct H as [f [I H]].
  destruct (map_option_from _ _ _ E0 _ I) as [[r g] [F J]]. exists r, g. split; [exact J|]. apply (paper_condition v _ _ _ _ _ A F), H.
Qed.

Lemma one_stated_sound v i u claims f : agrees_with s v i x u -> one_stated c claims = Some f -> holds v f ->
  exists r g, In (r, g) claims /\ is (paper s x) true r /\ is (paper s x) true g.
Proof.
  intros A E H. unfold one_stated in E. options E. inversion E; subst. apply holds_any, Exists_exists in H. destruct H as [f [I H]].
  destruct (map_option_from _ _ _ E0 _ I) as [[r g] [F J]]. simpl in F. options F. inversion F; subst. exists r, g. split; [exact J|].
  apply holds_all in H. inversion H as [|? ? B H']; subst. inversion H' as [|? ? D _]; subst.
  split; [apply (paper_condition v _ _ _ _ _ A E1), B|apply (paper_condition v _ _ _ _ _ A E2), D].
Qed.

Lemma cover_kind claims facts forces ws : what c = Cover claims -> here facts ->
  ways_of_kind c facts forces = Some ws -> Forall way_holds ws -> ~ no_value_here c x /\ right_here c x.
Proof.
  intros K H E W. unfold ways_of_kind, no_value_here, right_here in *. rewrite K in *. options E. inversion E; subst.
  inversion W as [|? ? A _]; subst. apply one_goal in A. destruct (shown_here _ _ H A) as [w [G S]].
  assert (R := one_region_sound _ _ _ _ _ G E0 S). split; [intros [U _]; exact (U R)|exact R].
Qed.

Lemma force_cover_kind claims facts forces ws : what c = ForceCover claims -> here facts ->
  normal_condition (paper_scope s None) true (at_forces c) = Some forces -> is (paper s x) true (at_forces c) ->
  ways_of_kind c facts forces = Some ws -> Forall way_holds ws -> ~ no_value_here c x /\ right_here c x.
Proof.
  intros K H N T E W. unfold ways_of_kind, no_value_here, right_here in *. rewrite K in *. options E. inversion E; subst.
  inversion W as [|? ? A _]; subst. apply one_goal in A. destruct (shown_here _ _ (here_also _ _ _ N T H) A) as [w [G S]].
  assert (R := one_stated_sound _ _ _ _ _ G E0 S). split; [|exact R]. intros [U|[_ [U _]]]; [apply U; now left|exact (U R)].
Qed.

Lemma same_motion_self u : same_motion s x u u.
Proof. intros name _. reflexivity. Qed.

Lemma motions_for modes : (forall md, In md modes -> exists u, motion s x md u) -> exists us, Forall2 (motion s x) modes us.
Proof.
  induction modes as [|md modes IH]; intro H.
  - exists []. constructor.
  - destruct (H md (or_introl eq_refl)) as [u U]. destruct IH as [us W]; [intros md' I; apply H; now right|]. exists (u :: us). now constructor.
Qed.

Lemma Forall2_length {A B} (Q : A -> B -> Prop) xs ys : Forall2 Q xs ys -> length xs = length ys.
Proof. induction 1; simpl; congruence. Qed.

Lemma numbered_motion modes us : Forall2 (motion s x) modes us -> forall k i md, In (i, md) (combine (seq k (length modes)) modes) ->
  exists u, nth_error us (i - k) = Some u /\ (k <= i)%nat /\ motion s x md u.
Proof.
  induction 1 as [|md u modes us M _ IH]; intros k i md' I; simpl in I; [contradiction|]. destruct I as [I|I].
  - inversion I; subst. exists u. rewrite Nat.sub_diag. auto.
  - destruct (IH _ _ _ I) as [w [N [L W]]]. exists w. split; [|split; [lia|exact W]].
    replace (i - k)%nat with (S (i - S k)) by lia. exact N.
Qed.

Lemma motions_kind modes facts forces ws : what c = Motions modes -> here facts ->
  normal_condition (paper_scope s None) true (at_forces c) = Some forces -> is (paper s x) true (at_forces c) ->
  ways_of_kind c facts forces = Some ws -> Forall way_holds ws -> ~ no_value_here c x /\ right_here c x.
Proof.
  intros K H0 N T E W. unfold ways_of_kind, no_value_here, right_here in *. rewrite K in *. options E.
  assert (H := here_also _ _ _ N T H0). apply andb_true_iff in E0. destruct E0 as [Q D]. apply andb_true_iff in Q. destruct Q as [Q _].
  apply andb_true_iff in Q. destruct Q as [Q M]. unfold motions_ways in E. options E. inversion E; subst; clear E.
  apply Forall_app in W. destruct W as [There W]. apply Forall_app in W. destruct W as [One W].
  inversion W as [|? ? Complete _]; subst; clear W. rewrite Forall_forall in There, One.
  assert (there : forall md, In md modes -> exists u, motion s x md u).
  { intros md I. destruct (map_option_In _ _ _ E0 _ I) as [w [F J]]. options F. inversion F; subst.
    apply (motion_exists _ md l4 H E); [apply one_goal, There, J]. }
  assert (modelled_all : forall md, In md modes -> modelled s md).
  { intros md I. destruct (there md I) as [u [cs [F _]]]. unfold modelled. congruence. }
  split; [|split].
  - intros [U|[_ [_ [[md [I U]]|U]]]].
    + apply U. now left.
    + exact (U (modelled_all md I)).
    + apply U. intros k I B. unfold all_modelled_here in M. rewrite forallb_forall in M. specialize (M _ I). now rewrite B in M.
  - intros md I. split; [exact (there md I)|]. intros u w U V.
    destruct (map_option_In _ _ _ E1 _ I) as [g [F J]]. options F. inversion F; subst.
    assert (G := one_goal _ (One _ J)).
    assert (A := agrees_here u [w] 0 u two_apart eq_refl). assert (B := agrees_here u [w] 1 w two_apart eq_refl).
    destruct (goal_shown _ _ (valuation s x [u; w]) G) as [v [S Z]].
    + apply Forall_app. split; [apply (motion_forms_sound s _ 0 md x u _ A E), U|].
      apply Forall_app. split; [apply (motion_forms_sound s _ 1 md x w _ B E5), V|apply H, two_apart].
    + exact (same_accelerations_hold v 0 1 u w (agrees_same s _ _ _ _ _ S A) (agrees_same s _ _ _ _ _ S B) Q Z).
  - intros md0 u U. inversion Complete as [? ? G|? ? C']; subst; [|inversion C' as [? ? G|? ? Nil]; subst; [|inversion Nil]].
    + assert (A := agrees_here u [u] 0 u two_apart eq_refl).
      destruct (goal_shown _ _ (valuation s x [u; u]) G) as [v [S Z]].
      * apply Forall_app. split; [exact (any_motion_sound s _ x md0 u _ A E2 U)|apply H, two_apart].
      * apply holds_any, Exists_exists in Z. destruct Z as [f [I Z]]. destruct (map_option_from _ _ _ E3 _ I) as [md [F J]].
        options F. inversion F; subst. apply holds_all in Z.
        exists md. split; [exact J|]. exists u. split; [|apply same_motion_self].
        apply (motion_forms_sound s v 0 md x u l4 (agrees_same s _ _ _ _ _ S A) E), Z.
    + destruct (motions_for modes there) as [us V]. assert (L := Forall2_length _ _ _ V).
      assert (D' : no_name_twice (names_of_motions s (length (u :: us))) = true) by (simpl length; rewrite <- L; exact D).
      assert (A := agrees_here u us 0 u D' eq_refl).
      destruct (goal_shown _ _ (valuation s x (u :: us)) G) as [v [S Z]].
      * apply Forall_app. split; [exact (any_motion_sound s _ x md0 u _ A E2 U)|]. apply Forall_app. split; [|apply H, D'].
        apply Forall_forall. intros f I. apply in_concat in I. destruct I as [fs [I J]].
        destruct (map_option_from _ _ _ E4 _ I) as [[i md] [F O]]. simpl in F.
        destruct (numbered_motion _ _ V _ _ _ O) as [w [B [C W]]].
        assert (B' : nth_error (u :: us) i = Some w) by (replace i with (S (i - 1)) by lia; exact B).
        assert (X := proj2 (motion_forms_sound s _ i md x w fs (agrees_here u us i w D' B') F) W).
        rewrite Forall_forall in X. exact (X _ J).
      * apply holds_any, Exists_exists in Z. destruct Z as [f [I Z]]. apply in_map_iff in I. destruct I as [[i md] [F O]]. simpl in F. subst f.
        destruct (numbered_motion _ _ V _ _ _ O) as [w [B [C W]]].
        assert (B' : nth_error (u :: us) i = Some w) by (replace i with (Datatypes.S (i - 1)) by lia; exact B).
        exists md. split; [exact (in_combine_r _ _ _ _ O)|]. exists w. split; [exact W|].
        apply (same_accelerations_hold v 0 i u w); [exact (agrees_same s _ _ _ _ _ S A)| |exact Q|exact Z].
        exact (agrees_same s _ _ _ _ _ S (agrees_here u us i w D' B')).
Qed.

(** Consequences, at any force *)

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

(** Where the forces are not those that the claim is about. *)
Lemma forces_false facts forces ws : ways_of_kind c facts forces = Some ws -> is (paper s x) false (at_forces c) ->
  (match what c with Impossible _ | Formula _ _ | Motions _ | ForceCover _ => True | _ => False end) ->
  ~ no_value_here c x /\ nothing_here c x.
Proof.
  intros E F K. assert (V : has_value (paper s x) (at_forces c)) by (now right).
  assert (N : ~ is (paper s x) true (at_forces c)) by (intro T; exact (consistent _ _ T F)).
  unfold ways_of_kind, no_value_here, nothing_here in *. destruct (what c) as [| modes |[|md modes] h|modes| | | |claims|]; try contradiction; split; try (now left); try exact F.
  all: intros [U|[T _]]; [exact (U V)|exact (N T)].
Qed.
End Claim.

Theorem ways_prove c ws : ways c = Some ws -> Forall way_holds ws -> (forall modes, what c <> Claim.Exists modes) ->
  forall x, match what c with Cover _ | Consequence _ _ _ => bicycle (in_setting c) x | _ => point (in_setting c) x end ->
  judged c x Right \/ judged c x SaysNothing.
Proof.
  intros E W X x P. unfold ways in E. options E. apply andb_true_iff in E0. destruct E0 as [C T].
  assert (I := interval_sound _ x C). unfold judged.
  set (facts := match what c with Cover _ | Consequence _ _ _ => bicycle_facts (in_setting c) | _ => point_facts (in_setting c) end) in *.
  assert (G : exists yes region_goal forces forces_goal rest,
    normal_condition (paper_scope (in_setting c) None) true (region c) = Some yes
    /\ has_value_goal c facts (region c) = Some region_goal
    /\ normal_condition (paper_scope (in_setting c) None) true (at_forces c) = Some forces
    /\ (match what c with Cover _ => Some [] | _ => let* g := has_value_goal c (yes :: facts) (at_forces c) in Some [[g]] end) = Some forces_goal
    /\ ways_of_kind c (yes :: facts) forces = Some rest
    /\ ws = [region_goal] :: forces_goal ++ rest).
  { unfold facts in *. destruct (what c) eqn:K; try (exfalso; exact (X _ eq_refl)); options E; inversion E; subst;
      do 5 eexists; repeat split; eauto; rewrite ?E4; reflexivity. }
  clear E. destruct G as [yes [rg [forces [fg [rest [Y [RG [F [FG [K S]]]]]]]]]]. subst ws.
  inversion W as [|? ? A B]; subst. apply one_goal in A. apply Forall_app in B. destruct B as [B D].
  assert (H : here c x facts).
  { unfold facts. destruct (what c); try exact (point_here c x P); exact (bicycle_here c x P). }
  destruct (has_value_sound c x T _ _ _ H RG A) as [R|R]; [|right; split; [exact I|now left]].
  assert (H' := here_also c x _ _ _ Y R H).
  assert (V : match what c with Cover _ => True | _ => has_value (paper (in_setting c) x) (at_forces c) end).
  { destruct (what c) eqn:Q; try exact Logic.I; options FG; inversion FG; subst; inversion B as [|? ? G _]; subst; apply one_goal in G;
      exact (has_value_sound c x T _ _ _ H' E G). }
  assert (L := forces_false c x _ _ _ K).
  assert (both : ~ no_value_here c x /\ right_here c x \/ ~ no_value_here c x /\ nothing_here c x).
  { destruct (what c) as [md|modes|modes h|modes|modes|h|claims|claims|model hs es] eqn:Q.
    - left. exact (interval_kind c x T md _ _ _ Q H' F V K D).
    - destruct V as [V|V]; [left; exact (impossible_kind c x T modes _ _ _ Q H' F V K D)|right; apply L; [exact V|exact Logic.I]].
    - destruct V as [V|V]; [left; exact (formula_kind c x T modes h _ _ _ Q H' F V K D)|right; apply L; [exact V|exact Logic.I]].
    - destruct V as [V|V]; [left; exact (motions_kind c x T modes _ _ _ Q H' F V K D)|right; apply L; [exact V|exact Logic.I]].
    - exfalso. exact (X _ eq_refl).
    - left. exact (equivalence_kind c x T h _ _ _ Q H' F V K D).
    - left. exact (cover_kind c x T claims _ _ _ Q H' K D).
    - destruct V as [V|V]; [left; exact (force_cover_kind c x T claims _ _ _ Q H' F V K D)|right; apply L; [exact V|exact Logic.I]].
    - left. exact (consequence_kind c x T model hs es _ _ _ Q H' K D). }
  destruct both as [[N B']|[N B']]; [left|right]; auto.
Qed.
