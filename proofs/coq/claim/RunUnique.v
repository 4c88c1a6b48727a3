(** What is judged of a claim of one motion at a rational point and force; it says nothing where some state is not
    modelled, or a motion has forces that are undetermined in a way that linear systems do not decide. *)
From Coq Require Import String List Bool ZArith QArith Qreals Reals Lra Lia.
From Slipproof Require Import Text Syntax.
From Slipproof.claim Require Import Expression Mechanism Claim RunValues RunConditions RunPoint RunMotion RunModes RunKinds.
Import ListNotations.
Local Open Scope R_scope.

Section Run.
Variable c : claim.
Notation s := (in_setting c).
Notation m := (of_mechanism s).
Variables paper_here paper_along mech : scope.
Variable moving : option (list system).

Definition stated_status (r : reference) : status := reference_status paper_here r.
Definition near_status (r : reference) : status := reference_status paper_here (fst r, closure true (snd r)).
Definition decided_region (r : reference) : bool :=
  match status_of paper_here (fst r) with Yes | No => true | _ => false end.
Definition valued_everywhere (r : reference) : bool :=
  match status_of paper_along (fst r) with No => true | _ => on_interval paper_along (snd r) end.

Definition solved (numbers : list linear) : mode -> found := solve (with_boundaries s) mech moving numbers.
(** Whether there is one motion, in each of these lists of modes. *)
Definition run_one_motion (lists : list (list mode)) : option outcome :=
  let* numbers := affines (map mech (accelerations m ++ map fst (quantities m))) in
  let all := map (solved numbers) (all_modes (given_parameters s) m) in
  if existsb is_unsolved all then None
  else if existsb is_several all then Some Wrong
  else match flat_map values_of all with
       | [] => Some Wrong
       | V :: Vs =>
           Some (if forallb (same_values V) Vs && forallb (existsb (fun md => is_unique (solved numbers md))) lists then Right else Wrong)
       end.

Definition run_unique (claims : list (mode * reference)) (except : list reference) (modes : list mode) : option outcome :=
  let named := map snd claims ++ except in
  if existsb (fun r => has_status Neither (status_of paper_here (fst r))) named then Some NoValue
  else if forallb (fun r => decided_region r && valued_everywhere r && negb (has_status Unknown (stated_status r))
                            && negb (has_status Unknown (near_status r))) named then
    if existsb (fun r => has_status Yes (near_status r)) except then Some SaysNothing
    else
      where_forces c paper_here
        (let stating := filter (fun i => has_status Yes (stated_status (snd i))) claims in
         let nearby := existsb (fun i => has_status Yes (near_status (snd i))) claims in
         let lists := map (fun i => [fst i]) stating ++ if nearby then [] else [modes] in
         match lists with
         | [] => Some SaysNothing
         | _ => if everything_modelled c then run_one_motion lists else None
         end)
  else None.
End Run.

(** Soundness *)

Section Sound.
Variable c : claim.
Variable q : list (string * Q).
Notation s := (in_setting c).
Notation m := (of_mechanism s).
Notation x := (x q).
Notation paper_here := (here s q).
Notation paper_along := (along s q).
Notation mech := (mechanism_scope s (inner_names s paper_here)).
Notation moving := (where_all_are mech (dynamics m)).
Notation closed := (with_boundaries s).

Lemma forallb_fails {A} (f : A -> bool) xs : forallb f xs = false -> exists a, In a xs /\ f a = false.
Proof.
  induction xs as [|a xs IH]; simpl; intro H; [discriminate|]. apply andb_false_iff in H. destruct H as [H|H]; [eauto|].
  destruct (IH H) as [b [J K]]. eauto.
Qed.
Lemma same_values_back numbers z V W : same_values V W = true -> have numbers z W -> have numbers z V.
Proof.
  unfold have. intros S H. revert V S. induction H as [|l a ls W E H IH]; intros [|b V] S; simpl in S; try discriminate; constructor.
  - apply andb_true_iff in S. destruct S as [S _]. apply Qeq_bool_iff, Qeq_eqR in S. congruence.
  - apply IH. apply andb_true_iff in S. tauto.
Qed.

Lemma one_motion_known lists : match run_one_motion c mech moving lists with
  | Some Right => forall ms, In ms lists -> one_motion_in c x ms
  | Some Wrong => lists <> [] -> exists ms, In ms lists /\ ~ one_motion_in c x ms
  | Some _ => False
  | None => True
  end.
Proof.
  unfold run_one_motion. destruct (affines _) as [numbers|] eqn:E; [|exact I].
  assert (Sol := solve_sound closed q mech moving numbers (mechanism_agree closed q) eq_refl E).
  assert (Same := same_numbers closed q mech numbers (mechanism_agree closed q) E).
  change (RunMotion.solve closed mech moving numbers) with (solved c mech moving numbers) in Sol.
  set (sol := solved c mech moving numbers) in *. set (everywhere := all_modes (given_parameters s) m).
  assert (listed : forall md u, any_motion c x md u -> In md everywhere) by (intros md u M; exact (all_modes_sound closed x md u M)).
  assert (some_list : lists <> [] -> exists ms, In ms lists) by (destruct lists as [|ms ?]; [congruence|intros _; exists ms; now left]).
  destruct (existsb is_unsolved _) eqn:Uns; [exact I|]. destruct (existsb is_several _) eqn:Sev.
  { intro N. destruct (some_list N) as [ms J]. exists ms. split; [exact J|]. intros [_ [_ One]].
    apply existsb_exists in Sev. destruct Sev as [f [K Sev]]. apply in_map_iff in K. destruct K as [md [F K]]. specialize (Sol md).
    rewrite F in Sol. destruct f; try discriminate. destruct Sol as [u [w [U [W D]]]]. exact (D (One md u md w U W)). }
  assert (found_all : forall md, In md everywhere -> match sol md with NoMotion | RunMotion.Unique _ => True | _ => False end).
  { intros md J. apply not_true_iff_false in Sev, Uns. assert (K := in_map sol _ _ J). destruct (sol md) eqn:F; auto.
    - apply Sev, existsb_exists. exists Several. auto.
    - apply Uns, existsb_exists. exists Unsolved. auto. }
  assert (has : forall md u, any_motion c x md u ->
            exists V, sol md = RunMotion.Unique V /\ In V (flat_map values_of (map sol everywhere)) /\ have numbers (in_order closed u) V).
  { intros md u M. assert (J := listed md u M). assert (F := found_all md J). specialize (Sol md).
    destruct (sol md) as [|V| |] eqn:G; try contradiction; [destruct (Sol u M)|]. exists V. split; [reflexivity|].
    split; [|exact (proj2 Sol _ _ (reads_in_order closed u) M)]. apply in_flat_map. exists (RunMotion.Unique V). split; [|now left].
    apply in_map_iff. exists md. auto. }
  assert (from : forall V, In V (flat_map values_of (map sol everywhere)) ->
            exists md u, any_motion c x md u /\ have numbers (in_order closed u) V).
  { intros V J. apply in_flat_map in J. destruct J as [f [J K]]. apply in_map_iff in J. destruct J as [md [G J]]. specialize (Sol md).
    rewrite G in Sol. destruct f as [|W| |]; simpl in K; try contradiction. destruct K as [K|[]]. subst W.
    destruct Sol as [[u M] Sol]. exists md, u. split; [exact M|exact (Sol _ _ (reads_in_order closed u) M)]. }
  destruct (flat_map values_of (map sol everywhere)) as [|V Vs] eqn:Vals.
  { intro N. destruct (some_list N) as [ms J]. exists ms. split; [exact J|]. intros [[md [u M]] _]. destruct (has md u M) as [V [_ [[] _]]]. }
  assert (differ : forall W, In W Vs -> same_values V W = false -> forall ms, ~ one_motion_in c x ms).
  { intros W J D ms [_ [_ One]]. destruct (from V (or_introl eq_refl)) as [md [u [M H]]]. destruct (from W (or_intror J)) as [other [w [M' H']]].
    assert (S := One md u other w M M'). apply (Same (in_order closed u) (in_order closed w) u w) in S; try apply reads_in_order.
    apply not_true_iff_false in D. apply D. apply (same_values_complete numbers (in_order closed w)); [|exact H'].
    apply (have_same numbers _ _ V H). clear - S. induction S; constructor; auto. }
  destruct (forallb (same_values V) Vs) eqn:Eq; simpl.
  - assert (have_V : forall md u, any_motion c x md u -> have numbers (in_order closed u) V).
    { intros md u M. destruct (has md u M) as [W [_ [[J|J] H]]]; [now subst|]. rewrite forallb_forall in Eq.
      exact (same_values_back numbers _ V W (Eq W J) H). }
    assert (same : forall md u other w, any_motion c x md u -> any_motion c x other w -> same_motion s x u w).
    { intros md u other w M M'. apply (Same (in_order closed u) (in_order closed w)); try apply reads_in_order.
      apply (have_same numbers _ _ V (have_V md u M)), (have_V other w M'). }
    destruct (forallb _ lists) eqn:All.
    + intros ms J. rewrite forallb_forall in All. specialize (All ms J). apply existsb_exists in All. destruct All as [md [K U]].
      assert (W := Sol md). destruct (sol md) as [|W'| |]; try discriminate. destruct W as [[w M] _].
      split; [exists md, w; exact M|]. split; [|exact same]. intros other u M'. exists md. split; [exact K|]. exists w.
      split; [exact M|exact (same other u md w M' M)].
    + intros _. apply forallb_fails in All. destruct All as [ms [J All]]. exists ms. split; [exact J|].
      intros [[md [u M]] [In_one _]]. destruct (In_one md u M) as [other [K [w [M' _]]]]. destruct (has other w M') as [W [G _]].
      apply not_true_iff_false in All. apply All, existsb_exists. exists other. rewrite G. auto.
  - intro N. destruct (some_list N) as [ms J]. exists ms. split; [exact J|]. apply forallb_fails in Eq. destruct Eq as [W [K Eq]].
    exact (differ W K Eq ms).
Qed.

(** A reference of which both conditions are known. *)
Lemma reference_yes r : has_status Unknown (reference_status paper_here r) = false ->
  if has_status Yes (reference_status paper_here r) then is (paper s x) true (fst r) /\ is (paper s x) true (snd r)
  else ~ (is (paper s x) true (fst r) /\ is (paper s x) true (snd r)).
Proof.
  assert (K := reference_known c q r). destruct (reference_status paper_here r); simpl; intro U; try discriminate; [exact K| |].
  - intros [A B]. destruct K as [K|K]; [exact (consistent _ _ A K)|exact (consistent _ _ B K)].
  - intros [A B]. destruct K as [[K _]|[_ K]]; apply K; now left.
Qed.

Lemma unique_proven claims except modes : what c = Claim.Unique claims except modes ->
  proven c q (run_unique c paper_here paper_along mech moving claims except modes).
Proof.
  intro K. unfold run_unique. set (named := map snd claims ++ except).
  match goal with |- context [existsb ?f named] => destruct (existsb f named) eqn:N end.
  { apply existsb_exists in N. destruct N as [r [J N]]. apply has_status_iff in N. unfold proven, verdict_here, no_value_here. rewrite K. left.
    exists r. split; [exact J|]. left. apply (status_undefined c q). symmetry. exact N. }
  clear N. match goal with |- context [forallb ?f named] => destruct (forallb f named) eqn:A end; [|exact I]. rewrite forallb_forall in A.
  assert (facts : forall r, In r named -> decided_region paper_here r = true /\ valued_everywhere paper_along r = true
    /\ has_status Unknown (stated_status paper_here r) = false /\ has_status Unknown (near_status paper_here r) = false).
  { intros r J. specialize (A r J). repeat (apply andb_true_iff in A; destruct A as [A ?]). rewrite !negb_true_iff in *. auto. }
  assert (stated : forall r, In r named -> if has_status Yes (stated_status paper_here r) then states c x r else ~ states c x r).
  { intros r J. destruct (facts r J) as [_ [_ [U _]]]. exact (reference_yes r U). }
  assert (near : forall r, In r named -> if has_status Yes (near_status paper_here r) then Claim.near c x r else ~ Claim.near c x r).
  { intros r J. destruct (facts r J) as [_ [_ [_ U]]]. exact (reference_yes (fst r, closure true (snd r)) U). }
  assert (valued : forall r, In r named -> ~ unvalued c x r).
  { intros r J. destruct (facts r J) as [R [V _]]. intros [U|[f [_ [T U]]]].
    - apply U. unfold decided_region in R. apply (status_defined c q). unfold status_here.
      destruct (status_of paper_here (fst r)); try discriminate; auto.
    - unfold valued_everywhere in V. assert (S := status_sound (fun _ => f) _ _ (along_agree s q f) (fst r)).
      destruct (status_of paper_along (fst r)); try exact (U (proj1 (on_interval_convex s q _ V) f)). exact (consistent _ _ T S). }
  assert (of_claims : forall i, In i claims -> In (snd i) named) by (intros i J; apply in_or_app; left; now apply in_map).
  assert (of_except : forall r, In r except -> In r named) by (intros r J; apply in_or_app; now right).
  clear A facts. match goal with |- context [match ?ls with [] => Some SaysNothing | _ => _ end] => set (lists := ls) end.
  assert (no_value : is (paper s x) true (at_forces c) \/ is (paper s x) false (at_forces c) \/ excepted c x except ->
    ~ is (paper s x) true (at_forces c) \/ nothing_here c x \/ all_modelled c -> ~ no_value_here c x).
  { intros F M. unfold no_value_here. rewrite K. intros [[r [J U]]|[[E U]|[T [O [_ U]]]]]; [exact (valued r J U)| |tauto].
    unfold has_value in U. tauto. }
  match goal with |- context [existsb ?f except] => destruct (existsb f except) eqn:E end.
  { apply existsb_exists in E. destruct E as [r [J E]]. assert (X : excepted c x except).
    { exists r. split; [exact J|]. assert (B := near r (of_except r J)). now rewrite E in B. }
    assert (O : nothing_here c x) by (unfold nothing_here; rewrite K; tauto). split; [|exact O]. apply no_value; tauto. }
  assert (X : ~ excepted c x except).
  { intros [r [J B]]. apply not_true_iff_false in E. apply E, existsb_exists. exists r. split; [exact J|].
    assert (C := near r (of_except r J)). destruct (has_status Yes (near_status paper_here r)); [reflexivity|contradiction]. }
  apply (where_forces_proven c q).
  - intro T. assert (N := forces_not_false c q T).
    assert (known : forall ms, expected c x claims modes ms <-> In ms lists).
    { intro ms. unfold expected, lists. rewrite in_app_iff. split.
      - intros [[md [r [J [B M]]]]|[B M]].
        + left. subst ms. apply in_map_iff. exists (md, r). split; [reflexivity|]. apply filter_In. split; [exact J|].
          assert (C := stated r (of_claims (md, r) J)). destruct (has_status Yes (stated_status paper_here r)) eqn:D; [exact D|contradiction].
        + right. subst ms. destruct (existsb (fun i => has_status Yes (near_status paper_here (snd i))) claims) eqn:D; [|now left]. apply existsb_exists in D. destruct D as [[md r] [J D]].
          assert (C := near r (of_claims (md, r) J)). cbn [snd] in D. rewrite D in C. destruct (B md r J C).
      - intros [J|J].
        + left. apply in_map_iff in J. destruct J as [[md r] [M J]]. apply filter_In in J. destruct J as [J D]. exists md, r.
          split; [exact J|]. split; [|now symmetry]. assert (C := stated r (of_claims (md, r) J)). cbn [snd] in D. now rewrite D in C.
        + right. destruct (existsb (fun i => has_status Yes (near_status paper_here (snd i))) claims) eqn:D; [contradiction|]. destruct J as [J|[]]. split; [|now symmetry].
          intros md r J' C. apply not_true_iff_false in D. apply D, existsb_exists. exists (md, r). split; [exact J'|].
          assert (B := near r (of_claims (md, r) J')). cbn [snd]. destruct (has_status Yes (near_status paper_here r)); [reflexivity|contradiction]. }
    assert (ends : lists = [] -> at_an_end c x claims).
    { intro L. assert (none : forall ms, ~ expected c x claims modes ms) by (intros ms P; apply known in P; now rewrite L in P). split.
      - unfold lists in L. apply app_eq_nil in L. destruct L as [_ L]. destruct (existsb (fun i => has_status Yes (near_status paper_here (snd i))) claims) eqn:D; [|discriminate].
        apply existsb_exists in D. destruct D as [[md r] [J D]]. exists md, r. split; [exact J|].
        assert (C := near r (of_claims (md, r) J)). cbn [snd] in D. now rewrite D in C.
      - intros md r J B. apply (none [md]). left. exists md, r. auto. }
    assert (not_ends : lists <> [] -> ~ at_an_end c x claims).
    { intros L [[md [r [J B]]] D]. destruct lists as [|ms ls] eqn:G; [congruence|].
      assert (P := proj2 (known ms) (or_introl eq_refl)). destruct P as [[md' [r' [J' [S _]]]]|[P _]]; [exact (D md' r' J' S)|exact (P md r J B)]. }
    destruct lists as [|l0 ls] eqn:L.
    { assert (O : nothing_here c x) by (unfold nothing_here; rewrite K; right; right; apply ends; reflexivity). split; [|exact O]. apply no_value; tauto. }
    assert (M := all_modelled_known c). destruct (everything_modelled c); [|exact I].
    assert (V : ~ no_value_here c x) by (apply no_value; tauto).
    assert (O : ~ nothing_here c x).
    { unfold nothing_here. rewrite K. intros [F|[F|F]]; [exact (N F)|exact (X F)|]. apply not_ends; [discriminate|exact F]. }
    assert (R := one_motion_known (l0 :: ls)). destruct (run_one_motion _ _ _ _) as [[| | |]|]; try contradiction; [| |exact I].
    + split; [exact V|]. split; [|exact O]. unfold right_here. rewrite K. intros ms P. apply R, known, P.
    + split; [exact V|]. split; [|exact O]. unfold right_here. rewrite K. intro P. destruct R as [ms [J R]]; [discriminate|].
      apply R, P, known, J.
  - intros F N. assert (O : nothing_here c x) by (unfold nothing_here; rewrite K; now left). split; [|exact O]. apply no_value; tauto.
  - intro U. unfold no_value_here. rewrite K. right; left. auto.
Qed.
End Sound.
