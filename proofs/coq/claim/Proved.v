(** Where all goals hold, the claim is right or says nothing at every point; or it is wrong at one. *)
From Coq Require Import String List Bool NArith ZArith Reals Lra Lia.
From Slipproof Require Import Text Syntax Meaning Poly Normal NormalSound.
From Slipproof.claim Require Import Expression Mechanism Claim Forms FormsSound Entails Covers Scopes Points Rising Obligations MotionForms Here ProvedEquations ProvedLimits ProvedUnique.
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
Let here_also := Here.here_also c x.
Let paper_condition := Here.paper_condition c x.
Let has_value_sound := Here.has_value_sound c x two_apart.
Let shown_of_motion := Here.shown_of_motion c x two_apart.
Let shown_here := Here.shown_here c x two_apart.
Let motion_exists := Here.motion_exists c x two_apart.
Let each_motion_sound := Here.each_motion_sound c.
Let same_accelerations_hold := Here.same_accelerations_hold c x two_apart.

Lemma interval_kind md facts forces ws : what c = Interval md -> here facts ->
  normal_condition (paper_scope s None) true (at_forces c) = Some forces -> has_value (paper s x) (at_forces c) ->
  ways_of_kind c cells facts forces = Some ws -> Forall way_holds ws -> ~ no_value_here c x /\ right_here c x.
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
  ways_of_kind c cells facts forces = Some ws -> Forall way_holds ws -> ~ no_value_here c x /\ right_here c x.
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
  ways_of_kind c cells facts forces = Some ws -> Forall way_holds ws -> ~ no_value_here c x /\ right_here c x.
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
  ways_of_kind c cells facts forces = Some ws -> Forall way_holds ws -> ~ no_value_here c x /\ right_here c x.
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
  ways_of_kind c cells facts forces = Some ws -> Forall way_holds ws -> ~ no_value_here c x /\ right_here c x.
Proof.
  intros K H E W. unfold ways_of_kind, no_value_here, right_here in *. rewrite K in *. options E. inversion E; subst.
  inversion W as [|? ? A _]; subst. apply one_goal in A. destruct (shown_here _ _ H A) as [w [G S]].
  assert (R := one_region_sound _ _ _ _ _ G E0 S). split; [intros [U _]; exact (U R)|exact R].
Qed.

Lemma force_cover_kind claims facts forces ws : what c = ForceCover claims -> here facts ->
  normal_condition (paper_scope s None) true (at_forces c) = Some forces -> is (paper s x) true (at_forces c) ->
  ways_of_kind c cells facts forces = Some ws -> Forall way_holds ws -> ~ no_value_here c x /\ right_here c x.
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
  ways_of_kind c cells facts forces = Some ws -> Forall way_holds ws -> ~ no_value_here c x /\ right_here c x.
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

(** Where the forces are not those that the claim is about. *)
Lemma forces_false facts forces ws : ways_of_kind c cells facts forces = Some ws -> is (paper s x) false (at_forces c) ->
  (match what c with Impossible _ | Formula _ _ | Motions _ | ForceCover _ => True | _ => False end) ->
  ~ no_value_here c x /\ nothing_here c x.
Proof.
  intros E F K. assert (V : has_value (paper s x) (at_forces c)) by (now right).
  assert (N : ~ is (paper s x) true (at_forces c)) by (intro T; exact (consistent _ _ T F)).
  unfold ways_of_kind, no_value_here, nothing_here in *. destruct (what c) as [| modes |[|md modes] h|modes| | | |claims| | | |]; try contradiction; split; try (now left); try exact F.
  all: intros [U|[T _]]; [exact (U V)|exact (N T)].
Qed.
End Claim.

(** Of the kinds of which a region that is false says nothing. *)
Lemma others_prove c cells ws : ways c cells = Some ws -> Forall way_holds ws -> (forall modes, what c <> Claim.Exists modes) ->
  judged_where c = region c -> (forall p holds from, what c <> Limit p holds from) ->
  forall x, (if of_any_force (what c) then bicycle (in_setting c) x else point (in_setting c) x) ->
  judged c x Right \/ judged c x SaysNothing.
Proof.
  intros E W X RE Y x P. unfold ways in E. options E. apply andb_true_iff in E0. destruct E0 as [C T].
  assert (I := interval_sound _ x C). unfold judged. rewrite RE. clear RE.
  set (facts := if of_any_force (what c) then bicycle_facts (in_setting c) else point_facts (in_setting c)) in *.
  assert (G : exists yes region_goal forces forces_goal rest,
    normal_condition (paper_scope (in_setting c) None) true (region c) = Some yes
    /\ has_value_goal c (bicycle_facts (in_setting c)) (region c) = Some region_goal
    /\ normal_condition (paper_scope (in_setting c) None) true (at_forces c) = Some forces
    /\ (if without_forces (what c) then Some [] else let* g := has_value_goal c (yes :: facts) (at_forces c) in Some [[g]]) = Some forces_goal
    /\ ways_of_kind c cells (yes :: facts) forces = Some rest
    /\ ws = [region_goal] :: forces_goal ++ rest).
  { unfold facts in *. destruct (what c) eqn:K; try (exfalso; exact (X _ eq_refl)); options E; inversion E; subst;
      exists f, g, f0, l, l0; repeat (split; [reflexivity || assumption|]); reflexivity. }
  clear E. destruct G as [yes [rg [forces [fg [rest [R0 [RG [F [FG [K S]]]]]]]]]]. subst ws.
  inversion W as [|? ? A B]; subst. apply one_goal in A. apply Forall_app in B. destruct B as [B D].
  assert (B0 : bicycle (in_setting c) x) by (destruct (of_any_force (what c)); [exact P|exact (of_bicycle _ _ P)]).
  assert (H : here c x facts).
  { unfold facts. destruct (of_any_force (what c)); [exact (bicycle_here c x P)|exact (point_here c x P)]. }
  destruct (has_value_sound c x T _ _ _ (bicycle_here c x B0) RG A) as [R|R]; [|right; split; [exact I|now left]].
  assert (H' := here_also c x _ _ _ R0 R H).
  assert (V : if without_forces (what c) then True else has_value (paper (in_setting c) x) (at_forces c)).
  { destruct (without_forces (what c)); [exact Logic.I|]. options FG; inversion FG; subst; inversion B as [|? ? G _]; subst; apply one_goal in G;
      exact (has_value_sound c x T _ _ _ H' E G). }
  assert (L := forces_false c x cells _ _ _ K).
  assert (both : ~ no_value_here c x /\ right_here c x \/ ~ no_value_here c x /\ nothing_here c x).
  { destruct (what c) as [md|modes|modes h|modes|modes|h|claims|claims|model hs es|model given hs es|claims except modes|p h from] eqn:Q.
    - left. exact (interval_kind c x T cells md _ _ _ Q H' F V K D).
    - destruct V as [V|V]; [left; exact (impossible_kind c x T cells modes _ _ _ Q H' F V K D)|right; apply L; [exact V|exact Logic.I]].
    - destruct V as [V|V]; [left; exact (formula_kind c x T cells modes h _ _ _ Q H' F V K D)|right; apply L; [exact V|exact Logic.I]].
    - destruct V as [V|V]; [left; exact (motions_kind c x T cells modes _ _ _ Q H' F V K D)|right; apply L; [exact V|exact Logic.I]].
    - exfalso. exact (X _ eq_refl).
    - left. exact (equivalence_kind c x T cells h _ _ _ Q H' F V K D).
    - left. exact (cover_kind c x T cells claims _ _ _ Q H' K D).
    - destruct V as [V|V]; [left; exact (force_cover_kind c x T cells claims _ _ _ Q H' F V K D)|right; apply L; [exact V|exact Logic.I]].
    - left. exact (consequence_kind c x T cells model hs es _ _ _ Q H' K D).
    - left. exact (system_kind c x T cells model given hs es _ _ _ Q H' K D).
    - destruct (unique_kind c x cells claims except modes yes forces rest T Q P R0 R F V K D) as [N [B'|B']]; [left|right]; split; assumption.
    - exfalso. exact (Y _ _ _ eq_refl). }
  destruct both as [[N B']|[N B']]; [left|right]; auto.
Qed.

(** At every bicycle, with a force or without. *)
Lemma ways_value c cells ws : ways c cells = Some ws -> Forall way_holds ws -> (forall modes, what c <> Claim.Exists modes) ->
  forall x, bicycle (in_setting c) x -> valued_at c x.
Proof.
  intros E W X x P. unfold ways in E. options E. apply andb_true_iff in E0. destruct E0 as [C T].
  split; [exact (interval_sound _ x C)|].
  assert (G : exists facts region_goal forces forces_goal rest,
    has_value_goal c (bicycle_facts (in_setting c)) (region c) = Some region_goal
    /\ ways_of_kind c cells facts forces = Some rest /\ ws = [region_goal] :: forces_goal ++ rest).
  { destruct (what c) eqn:K; try (exfalso; exact (X _ eq_refl)); options E; inversion E; subst;
      eexists; exists g, f0, l, l0; repeat (split; [reflexivity || eassumption|]); reflexivity. }
  destruct G as [facts [rg [forces [fg [rest [RG [K Q]]]]]]]. subst ws. inversion W as [|? ? A B]; subst. apply one_goal in A.
  apply Forall_app in B. destruct B as [_ D]. split; [exact (has_value_sound c x T _ _ _ (bicycle_here c x P) RG A)|].
  intro R. destruct (what c) as [md|modes|modes h|modes|modes|h|claims|claims|model hs es|model given hs es|claims except modes|p h from] eqn:O; try exact Logic.I.
  - unfold ways_of_kind in K. rewrite O in K. options K. exact (motion_forms_modelled _ _ _ _ E0).
  - exact (unique_valued c x cells claims except modes _ _ _ T O P R K D).
Qed.

Theorem ways_prove c cells ws : ways c cells = Some ws -> Forall way_holds ws -> (forall modes, what c <> Claim.Exists modes) ->
  forall x, (if of_any_force (what c) then bicycle (in_setting c) x else point (in_setting c) x) ->
  judged c x Right \/ judged c x SaysNothing.
Proof.
  intros E W X x P. destruct (what c) as [ | | | | | | | | | | |p holds from] eqn:Q; rewrite <- Q in P.
  12: { rewrite Q in P. exact (limit_kind c cells p holds from ws Q E W x P). }
  all: apply (others_prove c cells ws E W); try exact P; try (intros; rewrite Q; discriminate); unfold judged_where; now rewrite Q.
Qed.
