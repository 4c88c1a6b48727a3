(** What is judged of a claim at a rational point and force where its region is true: as a function, and that it is so
    for the kinds that are not about the numbers of motions. *)
From Coq Require Import String List Bool ZArith QArith Qreals Reals Lra Lia.
From Slipproof Require Import Text Syntax.
From Slipproof.claim Require Import Expression Mechanism Claim RunValues RunConditions RunPoint RunMotion RunModes.
Import ListNotations.
Local Open Scope R_scope.

Section Kinds.
Variable c : claim.
Notation s := (in_setting c).
Notation m := (of_mechanism s).

Variables paper_here mech : scope.
Variable moving : option (list system).

Definition status_here : condition -> status := status_of paper_here.
Definition forces_here : status := status_here (at_forces c).
Definition where_forces (o : option outcome) : option outcome :=
  match forces_here with Yes => o | No => Some SaysNothing | Neither => Some NoValue | Unknown => None end.
Definition all_listed_modelled (modes : list mode) : bool := forallb (is_modelled s) modes.
Definition some_motion (modes : list mode) : option bool := any_of (map (has_motion s mech moving) modes).

(** Some motion of a mode is in one of its systems. *)
Definition some_where (ys : mode -> option (list system)) (modes : list mode) : option bool :=
  any_of (map (fun md => one_solvable s (both (systems s mech moving md) (ys md))) modes).
Definition where_in (truth : bool) (holds : condition) (md : mode) : option (list system) :=
  where_of_mode s mech moving (motion_scope s paper_here mech) md truth holds.
Definition where_neither (holds : condition) (md : mode) : option (list system) :=
  let* yes := where_in true holds md in
  let* no := where_in false holds md in both (outside yes) (outside no).

Definition run_formula (modes : list mode) (holds : condition) : option outcome :=
  let* there := some_motion modes in
  if there then
    let* bad := some_where (where_in false holds) modes in
    if bad then Some Wrong
    else if all_listed_modelled modes then
      let* odd := some_where (where_neither holds) modes in Some (if odd then NoValue else Right)
    else Some NoValue
  else Some (if all_listed_modelled modes then SaysNothing else NoValue).

Definition everything_modelled : bool :=
  forallb (fun k => bilateral k || may_lift (given_parameters s) k) (contacts m).
Definition is_several (f : found) : bool := match f with Several => true | _ => false end.
Definition is_unsolved (f : found) : bool := match f with Unsolved => true | _ => false end.
Definition is_unique (f : found) : bool := match f with Unique _ => true | _ => false end.
Definition values_of (f : found) : list (list Q) := match f with Unique V => [V] | _ => [] end.

(** A mode that is modelled has no motion. *)
Definition is_empty (f : found) : bool := match f with NoMotion => true | _ => false end.
Definition lacks numbers (md : mode) : bool :=
  is_empty (solve s mech moving numbers md) && is_modelled s md.

Definition run_motions (modes : list mode) : option outcome :=
  let* numbers := affines (map mech (accelerations m ++ map fst (quantities m))) in
  let listed := map (solve s mech moving numbers) modes in
  if existsb is_several listed then Some Wrong
  else if existsb is_unsolved listed then None
  else if existsb (lacks numbers) modes then Some Wrong
  else if all_listed_modelled modes then
    let values := flat_map values_of listed in
    let* stray := any_of (map (strays s mech moving numbers values) (all_modes (given_parameters s) m)) in
    Some (if stray then Wrong else if everything_modelled then if forallb is_unique listed then Right else Wrong else NoValue)
  else Some NoValue.

Definition run_exists (modes : list mode) : option outcome :=
  let without := Some (if all_listed_modelled modes then SaysNothing else NoValue) in
  match forces_here with
  | Yes => let* lacking := any_of (map (fun md => option_map negb (has_motion s mech moving md)) modes) in
           if lacking then without else Some Right
  | No => without
  | Neither => Some NoValue
  | Unknown => None
  end.

Definition agreed (a b : status) : option outcome :=
  match a, b with
  | Neither, _ | _, Neither => Some NoValue
  | Yes, Yes | No, No => Some Right
  | Yes, No | No, Yes => Some Wrong
  | _, _ => None
  end.
Definition has_status (a b : status) : bool :=
  match a, b with Yes, Yes | No, No | Neither, Neither | Unknown, Unknown => true | _, _ => false end.
Definition covered (bs : list status) : option outcome :=
  if existsb (has_status Yes) bs then Some Right
  else if existsb (has_status Unknown) bs then None
  else if existsb (has_status Neither) bs then Some NoValue else Some Wrong.
Definition reference_status (r : reference) : status :=
  match status_here (fst r), status_here (snd r) with
  | Yes, Yes => Yes
  | No, _ | _, No => No
  | Unknown, _ | _, Unknown => Unknown
  | _, _ => Neither
  end.

Definition run_kind : option outcome :=
  match what c with
  | Interval md =>
      if is_modelled s md then
        let* there := has_motion s mech moving md in agreed forces_here (if there then Yes else No)
      else match forces_here with Unknown => None | _ => Some NoValue end
  | Impossible modes =>
      where_forces
        (let* there := some_motion modes in
         Some (if there then Wrong else if all_listed_modelled modes then Right else NoValue))
  | Formula [] holds => where_forces (agreed Yes (status_here holds))
  | Formula modes holds => where_forces (run_formula modes holds)
  | Motions modes => where_forces (run_motions modes)
  | Claim.Exists modes => run_exists modes
  | Equivalence holds => agreed forces_here (status_here holds)
  | Cover claims => covered (map (fun r => status_here (fst r)) claims)
  | ForceCover claims => where_forces (covered (map reference_status claims))
  | Consequence _ _ _ | System _ _ _ _ | Claim.Unique _ _ _ | Limit _ _ _ => None
  end.
End Kinds.

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

(** Of a region that is true: exactly one outcome. *)
Definition verdict_here (o : outcome) : Prop :=
  match o with
  | NoValue => no_value_here c x
  | SaysNothing => ~ no_value_here c x /\ nothing_here c x
  | Right => ~ no_value_here c x /\ right_here c x /\ ~ nothing_here c x
  | Wrong => ~ no_value_here c x /\ ~ right_here c x /\ ~ nothing_here c x
  end.
Definition proven (o : option outcome) : Prop := match o with Some o => verdict_here o | None => True end.

Lemma status_known d : match status_here paper_here d with
  | Yes => is (paper s x) true d | No => is (paper s x) false d | Neither => ~ has_value (paper s x) d | Unknown => True end.
Proof. exact (status_sound (fun _ => 0) _ _ (here_agree s q _) d). Qed.

Lemma motion_known md : match has_motion s mech moving md with
  | Some true => exists u, motion s x md u | Some false => forall u, ~ motion s x md u | None => True end.
Proof. exact (has_motion_sound s q mech moving (mechanism_agree s q) eq_refl md). Qed.

Lemma some_motion_known modes : match some_motion c mech moving modes with
  | Some true => exists md u, In md modes /\ motion s x md u
  | Some false => forall md u, In md modes -> ~ motion s x md u
  | None => True end.
Proof.
  unfold some_motion. destruct (any_of _) as [[|]|] eqn:E; [| |exact I].
  - apply any_of_true, in_map_iff in E. destruct E as [md [E J]]. assert (M := motion_known md). rewrite E in M. destruct M. eauto.
  - intros md u J. assert (F := any_of_false _ E _ (in_map _ _ _ J)). assert (M := motion_known md). rewrite F in M. apply M.
Qed.

Lemma listed_modelled modes : if all_listed_modelled c modes then forall md, In md modes -> modelled s md
                              else exists md, In md modes /\ ~ modelled s md.
Proof.
  unfold all_listed_modelled. destruct (forallb _ modes) eqn:E.
  - rewrite forallb_forall in E. intros md J. apply is_modelled_sound, E, J.
  - induction modes as [|md modes IH]; simpl in E; [discriminate|]. apply andb_false_iff in E. destruct E as [E|E].
    + exists md. split; [now left|]. intro M. apply is_modelled_sound in M. congruence.
    + destruct (IH E) as [md' [J N]]. exists md'. split; [now right|exact N].
Qed.

Definition true_forces : Prop := is (paper s x) true (at_forces c).

Lemma forces_valued : true_forces -> has_value (paper s x) (at_forces c).
Proof. now left. Qed.
Lemma forces_not_false : true_forces -> ~ is (paper s x) false (at_forces c).
Proof. intros T F. exact (consistent _ _ T F). Qed.

Lemma all_modelled_known : if everything_modelled c then all_modelled c else ~ all_modelled c.
Proof.
  unfold everything_modelled, all_modelled. destruct (forallb _ (contacts m)) eqn:E.
  - rewrite forallb_forall in E. intros k J B. specialize (E k J). now rewrite B in E.
  - intro H. apply not_true_iff_false in E. apply E, forallb_forall. intros k J. specialize (H k J). destruct (bilateral k); auto.
Qed.

(** Kinds that are judged only where [forces] is true. *)
Lemma where_forces_proven o :
  (true_forces -> proven o) ->
  (is (paper s x) false (at_forces c) -> ~ true_forces -> ~ no_value_here c x /\ nothing_here c x) ->
  (~ has_value (paper s x) (at_forces c) -> no_value_here c x) ->
  proven (where_forces c paper_here o).
Proof.
  intros T F U. assert (S := status_known (at_forces c)). unfold where_forces, forces_here.
  destruct (status_here paper_here (at_forces c)); [exact (T S)| |exact (U S)|exact I].
  assert (N : ~ true_forces) by (intro Y; exact (consistent _ _ Y S)). exact (F S N).
Qed.

Lemma agreed_known a b P Q : match a with Yes => P | No => ~ P | _ => True end -> match b with Yes => Q | No => ~ Q | _ => True end ->
  match agreed a b with
  | Some Right => P <-> Q
  | Some Wrong => ~ (P <-> Q)
  | Some NoValue => a = Neither \/ b = Neither
  | Some SaysNothing => False
  | None => True
  end.
Proof. destruct a, b; simpl; tauto. Qed.
Lemma agreed_defined a b : match agreed a b with Some Right | Some Wrong => a <> Neither /\ b <> Neither | _ => True end.
Proof. destruct a, b; simpl; auto; split; discriminate. Qed.

Lemma status_truth d : match status_here paper_here d with
  | Yes => is (paper s x) true d | No => ~ is (paper s x) true d | _ => True end.
Proof.
  assert (S := status_known d). destruct (status_here paper_here d); auto. intro T. exact (consistent _ _ T S).
Qed.
Lemma status_undefined d : status_here paper_here d = Neither -> ~ has_value (paper s x) d.
Proof. intro E. assert (S := status_known d). now rewrite E in S. Qed.
Lemma status_defined d : status_here paper_here d = Yes \/ status_here paper_here d = No -> has_value (paper s x) d.
Proof. intro E. assert (S := status_known d). unfold has_value. destruct E as [E|E]; rewrite E in S; auto. Qed.
Lemma agreed_values a b : match agreed a b with Some Right | Some Wrong => (a = Yes \/ a = No) /\ (b = Yes \/ b = No) | _ => True end.
Proof. destruct a, b; simpl; auto. Qed.


Ltac of_kind K := unfold proven, verdict_here, no_value_here, right_here, nothing_here, wrong_anyway in *; rewrite ?K in *.

Lemma interval_proven md : what c = Interval md ->
  proven (if is_modelled s md then let* there := has_motion s mech moving md in agreed (forces_here c paper_here) (if there then Yes else No)
          else match forces_here c paper_here with Unknown => None | _ => Some NoValue end).
Proof.
  intro K. destruct (is_modelled s md) eqn:M.
  - assert (D := motion_known md). destruct (has_motion s mech moving md) as [b|]; [|exact I].
    assert (Q : match (if b then Yes else No) with Yes => exists u, motion s x md u | No => ~ exists u, motion s x md u | _ => True end).
    { destruct b; [exact D|]. intros [u U]. exact (D u U). }
    assert (A := agreed_known _ _ _ _ (status_truth (at_forces c)) Q). assert (V := agreed_values (forces_here c paper_here) (if b then Yes else No)).
    apply is_modelled_sound in M. unfold forces_here in *. destruct (agreed _ _) as [[| | |]|]; of_kind K; try contradiction; try exact I.
    + destruct V as [V _]. apply status_defined in V. tauto.
    + destruct V as [V _]. apply status_defined in V. tauto.
    + destruct A as [A|A]; [left; exact (status_undefined _ A)|destruct b; discriminate].
  - assert (N : ~ modelled s md) by (intro Y; apply is_modelled_sound in Y; congruence).
    destruct (forces_here c paper_here); of_kind K; try exact I; now right.
Qed.

Lemma impossible_proven modes : what c = Impossible modes ->
  proven (where_forces c paper_here
            (let* there := some_motion c mech moving modes in
             Some (if there then Wrong else if all_listed_modelled c modes then Right else NoValue))).
Proof.
  intro K. assert (L := listed_modelled modes). apply where_forces_proven.
  - intro T. assert (V := forces_valued T). assert (N := forces_not_false T). assert (M := some_motion_known modes).
    destruct (some_motion _ _ _ _) as [[|]|]; [| |exact I].
    + of_kind K. destruct M as [md [u [J M]]]. split; [|split; [|exact N]].
      * intros [U|[_ [U _]]]; [exact (U V)|]. apply U. split; [exact T|]. eauto.
      * intro R. exact (R _ _ J M).
    + destruct (all_listed_modelled c modes); of_kind K.
      * split; [|split; [exact M|exact N]]. intros [U|[_ [_ [md [J U]]]]]; [exact (U V)|exact (U (L _ J))].
      * right. split; [exact T|]. split; [|exact L]. intros [_ [md [u [J U]]]]. exact (M _ _ J U).
  - intros F N. assert (V : has_value (paper s x) (at_forces c)) by now right. of_kind K. split; [|exact F].
    intros [U|[U _]]; [exact (U V)|exact (N U)].
  - intro U. of_kind K. now left.
Qed.

Lemma plain_formula_proven h : what c = Formula [] h ->
  proven (where_forces c paper_here (agreed Yes (status_here paper_here h))).
Proof.
  intro K. apply where_forces_proven.
  - intro T. assert (V := forces_valued T). assert (N := forces_not_false T). assert (S := status_known h).
    destruct (status_here paper_here h); simpl; try exact I; of_kind K.
    + split; [|auto]. intros [U|[_ U]]; [exact (U V)|]. apply U. now left.
    + split; [|split; [|exact N]]; [|intro Y; exact (consistent _ _ Y S)]. intros [U|[_ U]]; [exact (U V)|]. apply U. now right.
    + right. auto.
  - intros F N. assert (V : has_value (paper s x) (at_forces c)) by now right. of_kind K. split; [|exact F]. intros [U|[U _]]; [exact (U V)|exact (N U)].
  - intro U. of_kind K. now left.
Qed.

Lemma equivalence_proven h : what c = Equivalence h -> proven (agreed (forces_here c paper_here) (status_here paper_here h)).
Proof.
  intro K. assert (A := agreed_known _ _ _ _ (status_truth (at_forces c)) (status_truth h)).
  assert (V := agreed_values (forces_here c paper_here) (status_here paper_here h)). unfold forces_here in *.
  destruct (agreed _ _) as [[| | |]|]; of_kind K; try contradiction; try exact I.
  - destruct V as [V W]. apply status_defined in V, W. tauto.
  - destruct V as [V W]. apply status_defined in V, W. tauto.
  - destruct A as [A|A]; apply status_undefined in A; tauto.
Qed.

Lemma exists_proven modes : what c = Claim.Exists modes -> proven (run_exists c paper_here mech moving modes).
Proof.
  intro K. assert (L := listed_modelled modes). unfold run_exists, forces_here.
  assert (W : has_value (paper s x) (at_forces c) -> ~ right_here c x ->
              proven (Some (if all_listed_modelled c modes then SaysNothing else NoValue))).
  { intros V R. unfold proven, verdict_here, no_value_here, nothing_here. destruct (all_listed_modelled c modes); rewrite K.
    - split; [|exact R]. intros [_ [U|[md [J U]]]]; [exact (U V)|exact (U (L _ J))].
    - auto. }
  assert (S := status_known (at_forces c)). destruct (status_here paper_here (at_forces c)).
  - destruct (any_of _) as [[|]|] eqn:E; [| |exact I].
    + apply W; [now left|]. apply any_of_true, in_map_iff in E. destruct E as [md [E J]]. unfold right_here. rewrite K. intros [_ R].
      destruct (R md J) as [u M]. assert (H := motion_known md). destruct (has_motion s mech moving md) as [[|]|]; try discriminate. exact (H u M).
    + unfold proven, verdict_here, no_value_here, nothing_here. rewrite K. assert (R : right_here c x).
      { unfold right_here. rewrite K. split; [exact S|]. intros md J. assert (F := any_of_false _ E _ (in_map _ _ _ J)). simpl in F.
        assert (H := motion_known md). destruct (has_motion s mech moving md) as [[|]|]; try discriminate. exact H. }
      tauto.
  - apply W; [now right|]. unfold right_here. rewrite K. intros [T _]. exact (consistent _ _ T S).
  - unfold proven, verdict_here, no_value_here. rewrite K. split; [|now left]. unfold right_here. rewrite K. intros [T _]. apply S. now left.
  - exact I.
Qed.

Lemma has_status_iff a b : has_status a b = true <-> a = b.
Proof. destruct a, b; simpl; split; congruence. Qed.
Lemma covered_known {A} (f : A -> status) xs : match covered (map f xs) with
  | Some Right => exists r, In r xs /\ f r = Yes
  | Some NoValue => (forall r, In r xs -> f r = No \/ f r = Neither) /\ exists r, In r xs /\ f r = Neither
  | Some Wrong => forall r, In r xs -> f r = No
  | Some SaysNothing => False
  | None => True
  end.
Proof.
  unfold covered. assert (H : forall a, if existsb (has_status a) (map f xs) then exists r, In r xs /\ f r = a else forall r, In r xs -> f r <> a).
  { intro a. destruct (existsb _ _) eqn:E.
    - apply existsb_exists in E. destruct E as [b [J E]]. apply in_map_iff in J. destruct J as [r [F J]]. apply has_status_iff in E.
      exists r. split; congruence.
    - intros r J F. apply not_true_iff_false in E. apply E, existsb_exists. exists (f r). split; [now apply in_map|]. now apply has_status_iff. }
  assert (Y := H Yes). assert (U := H Unknown). assert (N := H Neither). clear H.
  destruct (existsb (has_status Yes) _); [exact Y|]. destruct (existsb (has_status Unknown) _); [exact I|].
  destruct (existsb (has_status Neither) _).
  - split; [|exact N]. intros r J. specialize (Y r J). specialize (U r J). destruct (f r); tauto.
  - intros r J. specialize (Y r J). specialize (U r J). specialize (N r J). destruct (f r); tauto.
Qed.

Lemma cover_proven claims : what c = Cover claims -> proven (covered (map (fun r => status_here paper_here (fst r)) claims)).
Proof.
  intro K. assert (H := covered_known (fun r : reference => status_here paper_here (fst r)) claims).
  destruct (covered _) as [[| | |]|]; of_kind K; try contradiction; try exact I.
  - destruct H as [[r f] [J H]]. assert (S := status_known r). simpl in H. rewrite H in S.
    assert (R : exists r f, In (r, f) claims /\ is (paper s x) true r) by eauto. tauto.
  - assert (F : forall r f, In (r, f) claims -> is (paper s x) false r).
    { intros r f J. assert (S := status_known r). specialize (H _ J). simpl in H. now rewrite H in S. }
    split; [|split; [|tauto]].
    + intros [_ [r [f [J U]]]]. apply U. right. exact (F _ _ J).
    + intros [r [f [J T]]]. exact (consistent _ _ T (F _ _ J)).
  - destruct H as [A [[r f] [J H]]]. split.
    + intros [r' [f' [J' T]]]. specialize (A _ J'). simpl in A. assert (S := status_known r').
      destruct A as [A|A]; rewrite A in S; [exact (consistent _ _ T S)|apply S; now left].
    + exists r, f. split; [exact J|]. exact (status_undefined _ H).
Qed.

Lemma reference_known (r : reference) : match reference_status paper_here r with
  | Yes => is (paper s x) true (fst r) /\ is (paper s x) true (snd r)
  | No => is (paper s x) false (fst r) \/ is (paper s x) false (snd r)
  | Neither => ~ has_value (paper s x) (fst r) /\ ~ is (paper s x) false (snd r)
               \/ is (paper s x) true (fst r) /\ ~ has_value (paper s x) (snd r)
  | Unknown => True
  end.
Proof.
  unfold reference_status. assert (A := status_known (fst r)). assert (B := status_known (snd r)).
  assert (C := consistent (paper s x) (snd r)). unfold has_value in *.
  destruct (status_here paper_here (fst r)), (status_here paper_here (snd r)); tauto.
Qed.

Lemma force_cover_proven claims : what c = ForceCover claims ->
  proven (where_forces c paper_here (covered (map (reference_status paper_here) claims))).
Proof.
  intro K. apply where_forces_proven.
  - intro T. assert (V := forces_valued T). assert (N := forces_not_false T).
    assert (H := covered_known (reference_status paper_here) claims).
    destruct (covered _) as [[| | |]|]; of_kind K; try contradiction; try exact I.
    + destruct H as [[r f] [J H]]. assert (S := reference_known (r, f)). rewrite H in S.
      assert (R : exists r f, In (r, f) claims /\ is (paper s x) true r /\ is (paper s x) true f) by (exists r, f; tauto). tauto.
    + assert (F : forall r f, In (r, f) claims -> is (paper s x) false r \/ is (paper s x) false f).
      { intros r f J. assert (S := reference_known (r, f)). specialize (H _ J). now rewrite H in S. }
      split; [|split; [|exact N]].
      * intros [U|[_ [_ [r [f [J [[U W]|[U W]]]]]]]]; [exact (U V)| |].
        -- destruct (F _ _ J) as [B|B]; [apply U; now right|exact (W B)].
        -- destruct (F _ _ J) as [B|B]; [exact (consistent _ _ U B)|apply W; now right].
      * intros [r [f [J [U W]]]]. destruct (F _ _ J) as [B|B]; [exact (consistent _ _ U B)|exact (consistent _ _ W B)].
    + destruct H as [A [[r f] [J H]]]. right. split; [exact T|]. split.
      * intros [r' [f' [J' [U W]]]]. assert (S := reference_known (r', f')). destruct (A _ J') as [B|B]; rewrite B in S; simpl in S.
        -- destruct S as [S|S]; [exact (consistent _ _ U S)|exact (consistent _ _ W S)].
        -- destruct S as [[S _]|[_ S]]; apply S; now left.
      * exists r, f. split; [exact J|]. assert (S := reference_known (r, f)). now rewrite H in S.
  - intros F N. assert (V : has_value (paper s x) (at_forces c)) by now right. of_kind K. split; [|exact F].
    intros [U|[U _]]; [exact (U V)|exact (N U)].
  - intro U. of_kind K. now left.
Qed.
End Sound.
