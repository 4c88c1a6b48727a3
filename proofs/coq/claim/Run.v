(** The semantics run: what is judged of a claim at a rational point and force. Linear systems decide what motions there
    are (Linear.v); it says nothing where an unknown is multiplied by another, or divides. *)
From Coq Require Import String List Bool ZArith QArith Qreals Reals Lra Lia.
From Slipproof Require Import Text Syntax.
From Slipproof.claim Require Import Expression Mechanism Claim RunValues RunConditions RunPoint RunMotion RunModes RunKinds RunUnique.
Import ListNotations.
Local Open Scope R_scope.

(** The values of the paper's symbols; those that are missing are 0. [None]: they are no point, or no bicycle if the claim is
    about any force, or it is not known. *)
Definition run (c : claim) (q : list (string * Q)) : option outcome :=
  let s := in_setting c in
  let paper_here := here s q in
  let paper_along := along s q in
  let inner := inner_names s paper_here in
  match is_point s paper_here paper_along inner (negb (of_any_force (what c))) with
  | Some true =>
      if on_interval paper_along (force_domain s) then
        match status_of paper_here (judged_where c) with
        | No => Some SaysNothing
        | Neither => Some NoValue
        | Unknown => None
        | Yes =>
            let mech := mechanism_scope s inner in
            let moving := where_all_are mech (dynamics (of_mechanism s)) in
            match what c with
            | Claim.Unique claims except modes => run_unique c paper_here paper_along mech moving claims except modes
            | _ => run_kind c paper_here mech moving
            end
        end
      else None
  | _ => None
  end.
Definition no_point (c : claim) (q : list (string * Q)) : bool :=
  let s := in_setting c in
  let paper_here := here s q in
  match is_point s paper_here (along s q) (inner_names s paper_here) (negb (of_any_force (what c))) with
  | Some false => true
  | _ => false
  end.

(** Soundness *)

Section Sound.
Variable c : claim.
Variable q : list (string * Q).
Notation s := (in_setting c).
Notation m := (of_mechanism s).
Notation x := (x q).
Notation paper_here := (here s q).
Notation mech := (mechanism_scope s (inner_names s paper_here)).
Notation moving := (where_all_are mech (dynamics m)).
Notation proven := (proven c q).
Ltac of_kind K := unfold RunKinds.proven, verdict_here, no_value_here, right_here, nothing_here, wrong_anyway in *; rewrite ?K in *.

(** Motions of listed modes in systems that say [P]. *)
Lemma some_where_known modes ys (P : (string -> R) -> Prop) :
  (forall md z u, reads s z u -> motion s x md u -> says z (ys md) (P u)) ->
  match some_where c mech moving ys modes with
  | Some true => exists md u, In md modes /\ motion s x md u /\ P u
  | Some false => forall md u, In md modes -> motion s x md u -> ~ P u
  | None => True
  end.
Proof.
  intro H. unfold some_where.
  assert (B : forall md z u, reads s z u -> says z (both (systems s mech moving md) (ys md)) (motion s x md u /\ P u)).
  { intros md z u U. apply both_sound_under; [|exact (H md z u U)].
    exact (systems_sound s q mech moving (mechanism_agree s q) eq_refl z u md U). }
  destruct (any_of _) as [[|]|] eqn:E; [| |exact I].
  - apply any_of_true, in_map_iff in E. destruct E as [md [E J]].
    assert (S := one_solvable_sound s (both (systems s mech moving md) (ys md))). rewrite E in S. destruct S as [z S].
    exists md, (by_name s z). split; [exact J|]. assert (A := B md z _ (reads_by_name s z)).
    destruct (both _ (ys md)); [|contradiction]. apply A, S.
  - intros md u J M N. assert (F := any_of_false _ E _ (in_map _ _ _ J)). simpl in F.
    assert (S := one_solvable_sound s (both (systems s mech moving md) (ys md))). rewrite F in S. specialize (S (in_order s u)).
    assert (A := B md _ u (reads_in_order s u)). destruct (both _ (ys md)); [|contradiction]. apply S, A. auto.
Qed.

Lemma formula_proven md modes h : what c = Formula (md :: modes) h ->
  proven (where_forces c paper_here (run_formula c paper_here mech moving (md :: modes) h)).
Proof.
  intro K. apply (where_forces_proven c q).
  - intro T. assert (V := (forces_valued c q) T). assert (N := (forces_not_false c q) T). unfold run_formula.
    assert (M := (some_motion_known c q) (md :: modes)). assert (L := (listed_modelled c) (md :: modes)).
    assert (W : forall truth md z u, reads s z u -> motion s x md u ->
      says z (where_in c paper_here mech moving truth h md) (is (names_of_motion s x u) truth h)).
    { intros truth md' z u U M'.
      exact (where_of_mode_sound s q mech moving (mechanism_agree s q) eq_refl z u _ _ md' truth h U M' (motion_scope_agree s q z u U)). }
    destruct (some_motion _ _ _ _) as [[|]|]; [| |exact I].
    + destruct M as [md0 [u0 [J0 M0]]].
      assert (B := some_where_known (md :: modes) _ (fun u => is (names_of_motion s x u) false h) (W false)). destruct (some_where _ _ _ _ _) as [[|]|]; [| |exact I].
      * destruct B as [md' [u [J [M B]]]]. of_kind K. split; [|split].
        -- intros [U|[_ [U _]]]; [exact (U V)|]. apply U. split; [exact T|]. exists md', u. auto.
        -- intro R. exact (consistent _ _ (R _ _ J M) B).
        -- intros [F|[_ F]]; [exact (N F)|exact (F _ _ J M)].
      * assert (NW : ~ wrong_anyway c x). { of_kind K. intros [_ [md' [u [J [M F]]]]]. exact (B _ _ J M F). }
        destruct (all_listed_modelled c (md :: modes)).
        -- assert (O := some_where_known (md :: modes) (where_neither c paper_here mech moving h)
             (fun u => ~ is (names_of_motion s x u) true h /\ ~ is (names_of_motion s x u) false h)).
           match type of O with ?A -> _ => assert (H : A) end.
           { intros md' z u U M'. assert (X := W true md' z u U M'). assert (Y := W false md' z u U M'). unfold where_neither.
             destruct (where_in _ _ _ _ true h md') as [yes|]; [|exact I]. destruct (where_in _ _ _ _ false h md') as [no|]; [|exact I].
             assert (D := both_sound z _ _ _ _ (outside_sound z yes) (outside_sound z no)). destruct (both _ _); [|exact I].
             simpl in *. rewrite D, X, Y. tauto. }
           specialize (O H). clear H. destruct (some_where _ _ _ _ _) as [[|]|]; [| |exact I].
           ++ destruct O as [md' [u [J [M O]]]]. unfold proven, verdict_here, no_value_here. rewrite K. right. split; [exact T|].
              split; [exact NW|]. right. exists md', u. split; [exact J|]. split; [exact M|]. unfold has_value. tauto.
           ++ unfold proven, verdict_here, no_value_here, right_here, nothing_here. rewrite K.
              assert (R : forall md' u, In md' (md :: modes) -> motion s x md' u -> is (names_of_motion s x u) true h).
              { intros md' u J M. assert (B' := B _ _ J M). assert (O' := O _ _ J M). clear - B' O'.
                destruct (true_or_not (names_of_motion s x u) h true); tauto. }
              split; [|split].
              ** intros [U|[_ [_ [[md' [J U]]|[md' [u [J [M U]]]]]]]]; [exact (U V)|exact (U (L _ J))|]. apply U. left. exact (R _ _ J M).
              ** exact R.
              ** intros [F|[_ F]]; [exact (N F)|exact (F _ _ J0 M0)].
        -- unfold proven, verdict_here, no_value_here. rewrite K. right. split; [exact T|]. split; [exact NW|]. auto.
    + destruct (all_listed_modelled c (md :: modes)); unfold proven, verdict_here, no_value_here, nothing_here, wrong_anyway; rewrite K.
      * split; [|right; auto]. intros [U|[_ [_ [[md' [J U]]|[md' [u [J [M' U]]]]]]]]; [exact (U V)|exact (U (L _ J))|exact (M _ _ J M')].
      * right. split; [exact T|]. split; [|auto]. intros [_ [md' [u [J [M' _]]]]]. exact (M _ _ J M').
  - intros F N. assert (V : has_value (paper s x) (at_forces c)) by now right. of_kind K. split; [|now left].
    intros [U|[U _]]; [exact (U V)|exact (N U)].
  - intro U. of_kind K. now left.
Qed.

Lemma motions_proven modes : what c = Motions modes ->
  proven (where_forces c paper_here (run_motions c mech moving modes)).
Proof.
  intro K. assert (L := (listed_modelled c) modes). assert (A := (all_modelled_known c)). apply (where_forces_proven c q).
  - intro T. assert (V := (forces_valued c q) T). assert (N := (forces_not_false c q) T). unfold run_motions.
    destruct (affines _) as [numbers|] eqn:E; [|exact I].
    assert (Sol := solve_sound s q mech moving numbers (mechanism_agree s q) eq_refl E).
    assert (Same := same_numbers s q mech numbers (mechanism_agree s q) E).
    destruct (existsb is_several _) eqn:Sev.
    + apply existsb_exists in Sev. destruct Sev as [f [J Sev]]. apply in_map_iff in J. destruct J as [md [F J]].
      specialize (Sol md). rewrite F in Sol. destruct f; try discriminate. destruct Sol as [u [w [U [W D]]]].
      of_kind K. split; [|split; [|exact N]].
      * intros [X|[_ [X _]]]; [exact (X V)|]. apply X. split; [exact T|]. left. exists md, u, w. auto.
      * intros [R _]. exact (D (proj2 (R md J) u w U W)).
    + destruct (existsb is_unsolved _) eqn:Uns; [exact I|].
      assert (F : forall md, In md modes -> match solve s mech moving numbers md with NoMotion | Unique _ => True | _ => False end).
      { intros md J. apply not_true_iff_false in Sev, Uns. assert (J' := in_map (solve s mech moving numbers) _ _ J).
        destruct (solve s mech moving numbers md) eqn:G; auto.
        - apply Sev, existsb_exists. exists Several. auto.
        - apply Uns, existsb_exists. exists Unsolved. auto. }
      assert (One : forall md u w, In md modes -> motion s x md u -> motion s x md w -> same_motion s x u w).
      { intros md u w J U W. specialize (Sol md). specialize (F md J). destruct (solve s mech moving numbers md) as [|values| |]; try contradiction.
        - destruct (Sol u U).
        - destruct Sol as [_ Sol]. apply (Same (in_order s u) (in_order s w) u w (reads_in_order s u) (reads_in_order s w)).
          apply (have_same numbers _ _ values); apply (Sol _ _ (reads_in_order s _)); assumption. }
      destruct (existsb (lacks c mech moving numbers) modes) eqn:La.
      { apply existsb_exists in La. destruct La as [md [J La]]. unfold lacks, is_modelled in La. apply andb_true_iff in La. destruct La as [Em Mo].
        assert (M : modelled s md) by (unfold modelled; destruct (mode_conditions _ _ _ md); [discriminate|discriminate Mo]).
        assert (No : forall u, ~ motion s x md u).
        { intros u U. specialize (Sol md). destruct (solve s mech moving numbers md); try discriminate. exact (Sol u U). }
        of_kind K. split; [|split; [|exact N]].
        - intros [X|[_ [X _]]]; [exact (X V)|]. apply X. split; [exact T|]. right; right. exists md. auto.
        - intros [R _]. destruct (proj1 (R md J)) as [u U]. exact (No u U). }
      assert (Some_motion : forall md, In md modes -> modelled s md -> (forall u, ~ motion s x md u) -> False).
      { intros md J Mo No. apply not_true_iff_false in La. apply La, existsb_exists. exists md. split; [exact J|]. unfold lacks, is_modelled.
        specialize (Sol md). specialize (F md J). destruct (solve s mech moving numbers md); try contradiction.
        - simpl. unfold modelled in Mo. now destruct (mode_conditions _ _ _ md).
        - destruct Sol as [[u U] _]. destruct (No u U). }
      destruct (all_listed_modelled c modes).
      * set (values := flat_map values_of (map (solve s mech moving numbers) modes)).
        assert (Is : forall W, In W values -> exists md u, In md modes /\ motion s x md u /\ have numbers (in_order s u) W).
        { intros W J. apply in_flat_map in J. destruct J as [f [J I']]. apply in_map_iff in J. destruct J as [md [G J]]. specialize (Sol md).
          rewrite G in Sol. destruct f as [|W'| |]; simpl in I'; try contradiction. destruct I' as [I'|[]]. subst W'.
          destruct Sol as [[u M] Sol]. exists md, u. split; [exact J|]. split; [exact M|]. exact (Sol _ _ (reads_in_order s u) M). }
        assert (Has : forall md w, In md modes -> motion s x md w -> exists W, In W values /\ have numbers (in_order s w) W).
        { intros md w J M. specialize (Sol md). specialize (F md J). assert (J' := in_map (solve s mech moving numbers) _ _ J).
          destruct (solve s mech moving numbers md) as [|W| |] eqn:G; try contradiction.
          - destruct (Sol w M).
          - exists W. split; [apply in_flat_map; exists (Unique W); simpl; auto|]. exact (proj2 Sol _ _ (reads_in_order s w) M). }
        assert (St := strays_sound s q mech moving numbers (mechanism_agree s q) eq_refl E values).
        destruct (any_of _) as [[|]|] eqn:G; [| |exact I].
        -- apply any_of_true, in_map_iff in G. destruct G as [md [G J]]. specialize (St md). rewrite G in St.
           destruct St as [z [u [U [M D]]]].
           assert (Out : forall listed, In listed modes -> ~ motion_in s x listed u).
           { intros listed J' [w [W Sm]]. destruct (Has _ _ J' W) as [X [JX HX]]. apply (D X JX).
             apply (have_same numbers (in_order s w)); [exact HX|]. apply (Same z (in_order s w) u w U (reads_in_order s w)) in Sm.
             clear - Sm. induction Sm; constructor; auto. }
           of_kind K. split; [|split; [|exact N]].
           ++ intros [X|[_ [X _]]]; [exact (X V)|]. apply X. split; [exact T|]. right; left. exists md, u. auto.
           ++ intros [_ R]. destruct (R md u M) as [listed [J' B]]. exact (Out _ J' B).
        -- assert (NW : ~ wrong_anyway c x).
           { unfold wrong_anyway. rewrite K. intros [_ [[md [u [w [J [U [W D]]]]]]|[[md [u [M [_ D]]]]|[md [J [Mo No]]]]]]; [exact (D (One _ _ _ J U W))| |exact (Some_motion md J Mo No)].
             assert (J := all_modes_sound s x md u M). specialize (St md). rewrite (any_of_false _ G _ (in_map _ _ _ J)) in St.
             destruct (St _ _ (reads_in_order s u) M) as [W [JW HW]]. destruct (Is W JW) as [listed [w [J' [M' HW']]]].
             apply (D _ J'). exists w. split; [exact M'|]. apply (Same _ _ _ _ (reads_in_order s u) (reads_in_order s w)).
             apply (have_same numbers _ _ W); assumption. }
           destruct (everything_modelled c).
           ++ assert (NV : ~ no_value_here c x).
              { unfold no_value_here. rewrite K. intros [X|[_ [_ [[md [J X]]|X]]]]; [exact (X V)|exact (X (L _ J))|exact (X A)]. }
              destruct (forallb is_unique _) eqn:Un.
              ** assert (R : right_here c x).
                 { unfold right_here. rewrite K. split.
                   - intros md J. split; [|intros u w; exact (One md u w J)]. rewrite forallb_forall in Un. specialize (Sol md).
                     specialize (Un _ (in_map (solve s mech moving numbers) _ _ J)). destruct (solve s mech moving numbers md); try discriminate. tauto.
                   - intros md u M. assert (J := all_modes_sound s x md u M). specialize (St md). rewrite (any_of_false _ G _ (in_map _ _ _ J)) in St.
                     destruct (St _ _ (reads_in_order s u) M) as [W [JW HW]]. destruct (Is W JW) as [listed [w [J' [M' HW']]]].
                     exists listed. split; [exact J'|]. exists w. split; [exact M'|]. apply (Same _ _ _ _ (reads_in_order s u) (reads_in_order s w)).
                     apply (have_same numbers _ _ W); assumption. }
                 unfold proven, verdict_here, nothing_here. rewrite K. auto.
              ** unfold proven, verdict_here, nothing_here. rewrite K. split; [exact NV|]. split; [|exact N]. unfold right_here. rewrite K.
                 intros [R _]. apply not_true_iff_false in Un. apply Un, forallb_forall. intros f J. apply in_map_iff in J.
                 destruct J as [md [Gf J]]. specialize (Sol md). specialize (F md J). rewrite Gf in Sol, F. destruct f; try contradiction; [|reflexivity].
                 destruct (R md J) as [[u M] _]. destruct (Sol u M).
           ++ unfold proven, verdict_here, no_value_here. rewrite K. auto.
      * assert (NW : ~ wrong_anyway c x).
        { unfold wrong_anyway. rewrite K. intros [_ [[md [u [w [J [U [W D]]]]]]|[[md [u [M [D _]]]]|[md [J [Mo No]]]]]]; [exact (D (One _ _ _ J U W))| |exact (Some_motion md J Mo No)].
          destruct L as [md' [J X]]. exact (X (D _ J)). }
        unfold proven, verdict_here, no_value_here. rewrite K. auto.
  - intros F N. assert (V : has_value (paper s x) (at_forces c)) by now right. of_kind K. split; [|exact F].
    intros [U|[U _]]; [exact (U V)|exact (N U)].
  - intro U. of_kind K. now left.
Qed.

Lemma run_kind_proven : proven (run_kind c paper_here mech moving).
Proof.
  unfold run_kind. destruct (what c) as [md|modes|[|md modes] h|modes|modes|h|claims|claims|model hs es|model given hs es|claims except modes|p h from] eqn:K.
  - exact (interval_proven c q md K).
  - exact (impossible_proven c q modes K).
  - exact (plain_formula_proven c q h K).
  - exact (formula_proven md modes h K).
  - exact (motions_proven modes K).
  - exact (exists_proven c q modes K).
  - exact (equivalence_proven c q h K).
  - exact (cover_proven c q claims K).
  - exact (force_cover_proven c q claims K).
  - exact I.
  - exact I.
  - exact I.
  - exact I.
Qed.
End Sound.

Lemma is_place c q : match is_point (in_setting c) (here (in_setting c) q) (along (in_setting c) q)
                           (inner_names (in_setting c) (here (in_setting c) q)) (negb (of_any_force (what c))) with
  | Some true => place c (x q) | Some false => ~ place c (x q) | None => True end.
Proof.
  assert (P := is_point_sound (in_setting c) q (negb (of_any_force (what c)))). unfold place.
  destruct (is_point _ _ _ _ _) as [[|]|]; [| |exact I]; destruct (of_any_force (what c)); exact P.
Qed.

(** What is said is true; where nothing is said, and something is right, too, it is not called right. *)
Theorem run_sound c q o : run c q = Some o ->
  place c (fun name => Q2R (lookup q name)) /\ judged c (fun name => Q2R (lookup q name)) o.
Proof.
  change (fun name => Q2R (lookup q name)) with (x q). unfold run. assert (P := is_place c q).
  destruct (is_point _ _ _ _ _) as [[|]|]; try discriminate.
  destruct (on_interval _ _) eqn:F; [|discriminate]. apply on_interval_sound in F. intro H. split; [exact P|].
  assert (S := status_sound (fun _ => 0) _ _ (here_agree (in_setting c) q _) (judged_where c)). unfold judged.
  destruct (status_of _ (judged_where c)); [| | |discriminate].
  - assert (K : RunKinds.proven c q (Some o)).
    { rewrite <- H. destruct (what c) eqn:K; try exact (run_kind_proven c q). exact (unique_proven c q _ _ _ K). }
    destruct o; simpl in K; tauto.
  - inversion H; subst. tauto.
  - inversion H; subst. tauto.
Qed.

Theorem no_point_sound c q : no_point c q = true -> ~ place c (fun name => Q2R (lookup q name)).
Proof. unfold no_point. assert (P := is_place c q). destruct (is_point _ _ _ _ _) as [[|]|]; try discriminate. intros _. exact P. Qed.
