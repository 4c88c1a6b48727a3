(** What is accepted of all motions is true (FORMAT.md, `all-solutions`). *)
From Coq Require Import NArith Reals List Bool Lra Lia Psatz FMapPositive FunctionalExtensionality.
From Slipproof.contact Require Import Coulomb Number Fixed Linear Zero Certificate Checker Rows Law Enclose Motions.
From Slipproof.contact Require Import Arcs States Multipliers Eliminate Alone Known KnownAlone Frictionless.
Import ListNotations.
Local Open Scope R_scope.

Lemma in_mode_ext d m s r u r' u' : (1 <= d)%nat -> (forall t, (t < d)%nat -> r t = r' t /\ u t = u' t) ->
  in_mode d m s r u -> in_mode d m s r' u'.
Proof.
  intros D E M. assert (R0 := proj1 (E 0%nat ltac:(lia))). assert (U0 := proj2 (E 0%nat ltac:(lia))).
  assert (Zero : (forall t, (t < d)%nat -> r t = 0) -> forall t, (t < d)%nat -> r' t = 0).
  { intros Z t T. rewrite <- (proj1 (E t T)). apply Z, T. }
  destruct s; cbn [in_mode] in *; rewrite <- ?U0, <- ?R0.
  - apply Zero, M.
  - split; [apply M | apply Zero, M].
  - destruct M as [A B]. split; [exact A|]. intros F t T. rewrite <- (proj2 (E t T)). apply B; assumption.
  - split; [apply M|]. rewrite <- (proj2 M). unfold tangential. f_equal. symmetry. apply sum_ext. intros t T.
    rewrite (proj1 (E (S t) ltac:(lia))). reflexivity.
  - destruct M as [A [B [C G]]]. rewrite <- (proj1 (E 1%nat ltac:(lia))), <- (proj2 (E 1%nat ltac:(lia))). auto.
  - destruct M as [A [B [C G]]]. rewrite <- (proj1 (E 1%nat ltac:(lia))), <- (proj2 (E 1%nat ltac:(lia))). auto.
Qed.

Lemma choose_each {A B} (l : list A) (Q : A -> B -> Prop) (other : B) : (forall a, In a l -> exists b, Q a b) ->
  exists f : nat -> B, forall k a, nth_error l k = Some a -> Q a (f k).
Proof.
  induction l as [|a l IH]; intros E.
  - exists (fun _ => other). intros [|k] a H; discriminate.
  - destruct (E a (or_introl eq_refl)) as [b QB]. destruct IH as [f F]; [intros; apply E; right; assumption|].
    exists (fun k => match k with O => b | S k => f k end). intros [|k] c H; cbn in H.
    + inversion H; subst. exact QB.
    + apply F, H.
Qed.

(** Of a problem without free unknowns. *)
Section Small.
  Variable i : instance.
  Hypothesis whole : is_whole i = true.
  Hypothesis fine_numbers : is_proper i = true.
  Hypothesis no_free : frees i = 0%N.
  Let p := tables_of i.
  Let P := problem_of i.
  Let n := size P.
  Let d := dimension P.

  Lemma free_is_none : free P = 0%nat.
  Proof. exact (no_free_here i no_free). Qed.

  Lemma size_n : (dimension P * contacts P)%nat = n.
  Proof. unfold n, size. rewrite free_is_none. reflexivity. Qed.

  (** The box of the data is that of the tables. *)
  Definition same_box (m : listed_motion) (b : box) : Prop := forall j, (j < n)%nat ->
    values (center_of b) (N.of_nat j) = box_center m j /\ absolute (radius_of b) (N.of_nat j) = box_radius m j.

  Lemma in_the_box m b y : same_box m b ->
    (forall j, (j < n)%nat -> Rabs (y j - values (center_of b) (N.of_nat j)) <= absolute (radius_of b) (N.of_nat j)) -> in_box P m y.
  Proof.
    intros S Y. split; rewrite free_is_none; [intros k K; inversion K|]. rewrite size_n. intros j J. cbn [Nat.add].
    destruct (S j J) as [<- <-]. apply Y, J.
  Qed.

  Lemma up_to_near m b e f ys s r found : same_box m b -> distance m = Some f -> (forall j, f j = numbers e j) -> forallb nonnegative e = true ->
    solution P r -> in_pattern i s r ->
    all_proved p s (flat_map (velocity_bounds p s b (table_of e)) (all_contacts p)) ys = true ->
    forallb (zero_in_range p s b (table_of e)) (all_contacts p) = true -> is_near P m found r.
  Proof.
    intros S D E N SR IP A Z j J. rewrite D, E. rewrite size_n in J. rewrite free_is_none. cbn [Nat.add].
    assert (K := known_range i whole fine_numbers no_free s r SR IP b (table_of e) ys A Z j J). rewrite table_of_value in K.
    destruct (range_attained i whole b j (motion P r j) (numbers e j)) as [y [Y UY]]; [|exact K|].
    - unfold numbers. destruct (nth_in_or_default j e zero) as [I|Q].
      + rewrite forallb_forall in N. apply sign_nonnegative, N, I.
      + rewrite Q, value_zero. lra.
    - exists y. split; [|exact UY]. apply (in_the_box m b y S). intros; apply Y.
  Qed.

  Lemma exact_solution l :
    forallb (fun c => obeys (t_dim p) (mu c) (fun t => get (table_of l) (first c + t))
      (fun t => middle (Box (table_of l) empty) (row p (first c + t)))) (all_contacts p) = true -> solution P (numbers l).
  Proof.
    intros H. split; [rewrite free_is_none; intros k K; inversion K|]. intros k K. rewrite forallb_forall in H.
    set (modes := map (fun _ => Open) (frictions i)).
    assert (I : In (contact_at i modes k) (all_contacts p)) by (apply contact_at_In; [apply map_length | exact K]).
    specialize (H _ I). destruct (friction_is i fine_numbers k K) as [A _].
    apply obeys_law in H; [|exact (dimension_is i fine_numbers) | exact A].
    change (dimension P) with (N.to_nat (t_dim p)). change (friction P k) with (value (mu (contact_at i modes k))).
    assert (E : forall t, value (get (table_of l) (first (contact_at i modes k) + N.of_nat t)) = of_contact P k (numbers l) t).
    { intros t. rewrite (first_at i no_free), table_of_value. symmetry. apply (component i no_free). }
    assert (U : forall t, value (middle (Box (table_of l) empty) (row p (first (contact_at i modes k) + N.of_nat t)))
      = of_contact P k (motion P (numbers l)) t).
    { intros t. rewrite (first_at i no_free), (middle_motion i whole). symmetry. apply (component i no_free). }
    rewrite (functional_extensionality _ _ E), (functional_extensionality _ _ U) in H. exact H.
  Qed.

  Lemma exact_near l s r ys : solution P r -> in_pattern i s r ->
    check_known p s (Exact l None) ys = true -> is_near P (listed_of i (Exact l None)) (numbers l) r.
  Proof.
    intros SR IP H j J. cbn [listed_of distance option_map]. rewrite size_n in J. rewrite free_is_none. cbn [Nat.add].
    unfold check_known, bounds_of in H. cbn [vicinity_of box_of_motion] in H. apply andb_prop in H. destruct H as [A Z].
    assert (K := known_range i whole fine_numbers no_free s r SR IP _ _ ys A Z j J).
    rewrite table_of_value in K. unfold least, greatest in K. rewrite value_sub, value_add in K.
    rewrite (middle_motion i whole) in K. unfold spread in K. rewrite size_of_value in K. cbn [radius_of] in K.
    assert (S : forall e, apply_abs e (absolute empty) = 0).
    { induction e as [|[k a] e IH]; cbn; [reflexivity|]. rewrite IH. unfold absolute. rewrite get_empty, value_zero, Rabs_R0. ring. }
    rewrite S in K. assert (E : numbers [] j = 0) by (unfold numbers; destruct j; apply value_zero). rewrite E in K.
    fold P in K. lra.
  Qed.

  Lemma alone_is_near modes center radius dropped inverse l d0 s r ys :
    let b := box_of p modes center radius [] in let kept := equations_kept p modes dropped in
    length modes = length (frictions i) ->
    length (unknowns_left p modes []) = length kept -> NoDup (unknowns_left p modes []) ->
    within b d0 -> (forall k, ~ In k (unknowns_left p modes []) -> d0 k = 0) ->
    (forall e, In e kept -> eval e (zero_of b d0) = 0) ->
    is_alone (center_of b) (radius_of b) (unknowns_left p modes []) kept (by_rows inverse) l = true ->
    solution P r -> in_pattern i s r ->
    all_proved p s (flat_map (force_bounds p s b l) (contacts_of p modes)) ys = true ->
    forallb (fits p s) (contacts_of p modes) = true ->
    forall j, (j < n)%nat -> motion P r j = motion P (fun j => zero_of b d0 (N.of_nat j)) j.
  Proof.
    intros b kept L LK ND W O Z A SR IP AP F j J. unfold is_alone in A. split_and A. apply le_value in A. rewrite value_one in A.
    set (v := unknowns_at i modes r).
    assert (Left : unknowns_left p modes [] = unknowns p modes) by apply others_none.
    assert (Outside : forall k, ~ In k (unknowns p modes) -> values (center_of b) k = 0).
    { intros k K. unfold values, b, box_of. cbn [center_of]. rewrite assign_others, get_empty by exact K. apply value_zero. }
    set (a := fun k => v k - values (center_of b) k).
    assert (OA : forall k, ~ In k (unknowns_left p modes []) -> a k = 0).
    { intros k K. rewrite Left in K. unfold a, v. rewrite (others_zero i fine_numbers no_free modes s r) by assumption.
      rewrite Outside by exact K. ring. }
    assert (E : forall k, a k = d0 k).
    { apply (alone_in_box (fun e => nth (N.to_nat e) kept nothing) (center_of b) (radius_of b) (unknowns_left p modes [])
        (name_rows 0 (unknowns_left p modes []) (by_rows inverse)) (value l)
        (look flat (tabulate 0 (map (expand (center_of b) (radius_of b)) kept) (PositiveMap.empty expansion)))).
      - intros e. apply map_tabulate.
      - apply name_rows_names.
      - exact ND.
      - lra.
      - intros k row I. rewrite forallb_forall in H. specialize (H _ I). cbv beta iota in H. apply lt_value in H.
        rewrite value_add, !value_mul, value_abs, bend_row_is in H. cbn [bend_of] in H.
        eapply Rle_lt_trans; [|exact H]. apply Rplus_le_compat_l.
        replace (value (Number 4 0 1)) with 4 by (unfold value; simpl; field).
        assert (Q : apply_abs row (fun e => products_abs (quadratic_part (nth (N.to_nat e) kept nothing)) (absolute (radius_of b)))
          <= 2 * apply_abs row (fun e => value (get (tabulate 0 (map (close_bend (radius_of b)) kept) empty) e))).
        { rewrite <- apply_abs_scale. apply apply_abs_le. intros e. rewrite <- size_of_products_value.
          eapply Rle_trans; [apply bend_close|]. apply Req_le. f_equal. f_equal. unfold get, empty. rewrite look_list.
          replace zero with (close_bend (radius_of b) nothing) by reflexivity. symmetry. apply map_nth. }
        nra.
      - intros k. destruct (in_dec N.eq_dec k (unknowns p modes)) as [K|K].
        + apply (unknowns_near i whole fine_numbers no_free modes b l s r ys); assumption.
        + rewrite <- Left in K. rewrite (OA k K), Rabs_R0. apply Rmult_le_pos; [lra | apply Rabs_pos].
      - intros k. eapply Rle_trans; [apply W|]. rewrite <- (Rmult_1_l (absolute (radius_of b) k)) at 1.
        apply Rmult_le_compat_r; [apply Rabs_pos | lra].
      - exact OA.
      - exact O.
      - intros e. rewrite (eval_ext _ _ v) by (intros; unfold a; ring).
        destruct (nth_in_or_default (N.to_nat e) kept nothing) as [I|Q].
        + apply (equations_hold i whole fine_numbers no_free modes b l s r ys); auto. apply others_from in I. exact I.
        + rewrite Q. unfold eval; cbn. rewrite value_zero. lra.
      - intros e. destruct (nth_in_or_default (N.to_nat e) kept nothing) as [I|Q].
        + apply Z, I.
        + rewrite Q. unfold eval; cbn. rewrite value_zero. lra. }
    unfold motion. f_equal. apply sum_ext. intros k K. f_equal. unfold zero_of. rewrite <- E. unfold a.
    transitivity (v (N.of_nat k)); [|ring]. unfold v, unknowns_at. rewrite Nat2N.id. fold P.
    destruct (Nat.ltb_spec k (size P)); [reflexivity | lia].
  Qed.

  Lemma check_motion_box m : check_motion i p m = true -> same_box (listed_of i m) (box_of_motion p m).
  Proof.
    intros H. destruct m as [l e|modes center radius pinned dropped inverse near].
    - intros j _. cbn [box_of_motion center_of radius_of listed_of box_center box_radius]. unfold values, absolute.
      rewrite table_of_value, get_empty, value_zero, Rabs_R0. split; reflexivity.
    - cbn [check_motion] in H. cbv zeta in H. apply andb_prop in H. destruct H as [H _]. apply andb_prop in H. destruct H as [_ H].
      intros j J. rewrite forallb_forall in H.
      assert (I : In (N.of_nat j) (range 0 (N.to_nat (t_size p)))).
      { apply range_In. assert (SZ := size_is i). fold p P n in SZ. rewrite SZ. lia. }
      specialize (H _ I). apply andb_prop in H. destruct H as [C R]. apply eq_value in C. apply eq_value in R.
      rewrite value_abs in R. rewrite table_of_value in C, R. split; [exact C | exact R].
  Qed.

  (** That a motion stands for another one was judged. *)
  Definition stands_for m r : Prop :=
    (exists s ys, in_pattern i s r /\ check_known p s m ys = true) \/ exists squares, check_frictionless p m squares = true.

  Lemma frictionless_near l e squares r : check_motion i p (Exact l e) = true -> check_frictionless p (Exact l e) squares = true ->
    solution P (numbers l) -> solution P r -> is_near P (listed_of i (Exact l e)) (numbers l) r.
  Proof.
    intros H F SL SR j J. rewrite size_n in J. rewrite free_is_none. cbn [Nat.add listed_of distance].
    assert (E := frictionless_only i whole fine_numbers no_free l e squares r F SL SR j J). fold P in E.
    destruct e as [e|]; cbn [option_map]; [|exact E]. exists (numbers l). split.
    - apply (in_the_box _ _ _ (check_motion_box _ H)). intros k K. cbn [box_of_motion center_of radius_of].
      unfold values, absolute. rewrite table_of_value, Rminus_diag_eq, Rabs_R0; [apply Rabs_pos | reflexivity].
    - rewrite E, Rminus_diag_eq, Rabs_R0 by reflexivity. cbn [check_motion] in H. apply andb_prop in H. destruct H as [_ H].
      unfold are_distances in H. apply andb_prop in H. destruct H as [_ H]. unfold numbers.
      destruct (nth_in_or_default j e zero) as [I|Q]; [|rewrite Q, value_zero; lra].
      rewrite forallb_forall in H. apply sign_nonnegative, H, I.
  Qed.

  Theorem check_motion_sound m : check_motion i p m = true ->
    exists found, is_listed P (listed_of i m) found /\
      forall r, solution P r -> stands_for m r -> is_near P (listed_of i m) found r.
  Proof.
    intros H. assert (SB := check_motion_box m H). assert (H' := H).
    destruct m as [l e|modes center radius pinned dropped inverse near]; unfold check_motion in H.
    - cbv zeta in H. cbn [box_of_motion center_of] in H, SB. split_and H.
      exists (numbers l). split; [split; [apply exact_solution; assumption | split]|].
      + apply (in_the_box _ _ _ SB). intros j J. rewrite (proj1 (SB j J)), (proj2 (SB j J)). cbn [listed_of box_center box_radius].
        rewrite Rminus_diag_eq, Rabs_R0; [lra | reflexivity].
      + intros k K Q. discriminate.
      + intros r SR [[s [ys [IP KN]]]|[squares F]];
          [|apply (frictionless_near l e squares r H' F); [apply exact_solution; assumption | exact SR]].
        destruct e as [e|]; [|apply (exact_near l s r ys SR IP KN)].
        unfold check_known, bounds_of in KN. cbn [vicinity_of box_of_motion] in KN. apply andb_prop in KN. destruct KN as [A Z].
        unfold are_distances in H0. apply andb_prop in H0. destruct H0 as [_ N].
        apply (up_to_near _ _ e (numbers e) ys s r _ SB eq_refl (fun _ => eq_refl) N SR IP A Z).
    - cbv zeta in H. apply andb_prop in H. destruct H as [H More]. apply andb_prop in H. destruct H as [H _].
      set (b := box_of p modes center radius pinned) in *.
      change (box_of_motion p (Boxed modes center radius pinned dropped inverse near)) with b in *.
      set (m := Boxed modes center radius pinned dropped inverse near) in *.
      destruct (check_box_sound i whole fine_numbers modes center radius pinned dropped _
        (fun z r left kept => has_zero_sound z r left kept (by_rows inverse)) H) as [d0 [W [O [Z [S M]]]]].
      fold p b in W, O, Z, S, M. exists (fun j => zero_of b d0 (N.of_nat j)). split; [split; [exact S | split]|].
      + apply (in_the_box _ _ _ SB). intros j J. unfold zero_of.
        replace (values (center_of b) (N.of_nat j) + d0 (N.of_nat j) - values (center_of b) (N.of_nat j)) with (d0 (N.of_nat j)) by ring.
        apply W.
      + intros ms k Q K. inversion Q; subst. apply M, K.
      + intros r SR [[s [ys [IP KN]]]|[squares F]]; [|discriminate F].
        unfold check_known, bounds_of in KN. change (box_of_motion p m) with b in KN.
        destruct near as [|l|e]; cbn [m vicinity_of] in KN.
        * apply andb_prop in KN. destruct KN as [A F].
          apply (up_to_near _ _ [] (fun _ => 0) ys s r _ SB eq_refl); try assumption; try reflexivity.
          intros [|j]; symmetry; apply value_zero.
        * apply andb_prop in KN. destruct KN as [A F]. destruct pinned as [|x pinned]; [|discriminate].
          unfold check_box in H. split_and H. apply Nat.eqb_eq in H.
          destruct (has_zero_sound _ _ _ _ _ H1) as [_ [_ [_ [ND _]]]]. unfold has_zero in H1. split_and H1.
          apply Nat.eqb_eq in H1. intros j J. cbn [m listed_of distance]. rewrite size_n in J. rewrite free_is_none. cbn [Nat.add].
          apply (alone_is_near modes center radius dropped inverse l d0 s r ys); assumption.
        * apply andb_prop in KN. destruct KN as [A F]. unfold are_distances in More. apply andb_prop in More. destruct More as [_ N].
          apply (up_to_near _ _ e (numbers e) ys s r _ SB eq_refl (fun _ => eq_refl) N SR IP A F).
  Qed.

  (** Each motion of a pattern that is covered is in a case that is known. *)
  Theorem check_tree_sound motions tree : forall patterns, check_tree p motions tree patterns = true ->
    forall s r, In s patterns -> solution P r -> in_pattern i s r ->
      exists j m, nth_error motions j = Some m /\ stands_for m r.
  Proof.
    induction tree as [|x tree IH]; intros [|s0 rest] H s r I SR IP; cbn [check_tree] in H; try discriminate; [destruct I|].
    destruct (match x with Empty _ => _ | _ => _ end) eqn:X in H; [|discriminate]. specialize (IH _ H).
    destruct I as [->|I]; [|apply (IH s r); [apply in_or_app; right|..]; assumption].
    assert (Split : covers p x (state_of s (of_node x)) = true ->
      exists j m, nth_error motions j = Some m /\ stands_for m r).
    { intros C. set (k := N.to_nat (of_node x)).
      assert (K : (k < contacts P)%nat).
      { unfold covers in C. apply andb_prop in C. destruct C as [C _]. apply N.ltb_lt in C. change (t_mus p) with (frictions i) in C.
        change (contacts P) with (length (frictions i)). unfold k. lia. }
      assert (KX : of_node x = N.of_nat k) by (unfold k; rewrite N2Nat.id; reflexivity).
      assert (A := IP k K). rewrite <- KX in A.
      destruct (cases_cover p x (state_of s (of_node x)) (of_contact P k r) (of_contact P k (motion P r))
        (dimension_is i fine_numbers) C (proj2 SR k K) A) as [t [T AT]].
      apply (IH (PositiveMap.add (key (of_node x)) t s) r); [|exact SR|].
      - apply in_or_app. left. unfold children. apply (in_map (fun t => PositiveMap.add (key (of_node x)) t s)), T.
      - intros j J. unfold state_of. rewrite look_add. destruct (N.eq_dec (N.of_nat j) (of_node x)) as [E|E].
        + assert (j = k) by (unfold k; lia). subst j. exact AT.
        + apply IP, J. }
    destruct x as [k|k l|k l|y|k ys|k q]; try (apply Split, X).
    - exfalso. apply (excluded_sound i whole fine_numbers no_free s r SR IP y X).
    - destruct (nth_error motions (N.to_nat k)) as [m|] eqn:M; [|discriminate].
      exists (N.to_nat k), m. split; [exact M|]. left. exists s, ys. split; assumption.
    - destruct (nth_error motions (N.to_nat k)) as [m|] eqn:M; [|discriminate].
      exists (N.to_nat k), m. split; [exact M|]. right. exists q. exact X.
  Qed.
End Small.

Section Instance.
  Variable i : instance.
  Hypothesis whole : is_whole i = true.
  Hypothesis fine_numbers : is_proper i = true.

  Theorem check_all_solutions_sound eliminated motions tree : check_all_solutions i eliminated motions tree = true ->
    all_motions (problem_of i) (map (listed_of i) motions).
  Proof.
    intros H. unfold check_all_solutions in H. split_and H.
    set (inverse := match eliminated with Some b => b | None => [] end) in *.
    change (without_free i eliminated) with (reduced i inverse) in *. set (small := reduced i inverse) in *.
    set (P := problem_of i). set (Q := problem_of small). set (F := free P).
    assert (PS : is_proper small = true) by exact fine_numbers. assert (NF : frees small = 0%N) by reflexivity.
    assert (DS : (1 <= dimension P)%nat) by (assert (D := dimension_is i fine_numbers); exact (proj1 D)).
    assert (Ext : forall (x x' : nat -> R), (forall k, x (F + k)%nat = x' k) -> (fun j => x (F + j)%nat) = x')
      by (intros; apply functional_extensionality; assumption).
    assert (Found : forall m, In m motions -> exists X, is_listed P (listed_of i m) X /\
      forall x, solution P x -> stands_for small m (fun j => x (F + j)%nat) -> is_near P (listed_of i m) X x).
    { intros m M. rewrite forallb_forall in H1.
      destruct (check_motion_sound small H2 PS NF m (H1 m M)) as [X' [[S [[_ B] MO]] N]].
      destruct (with_free i inverse whole H X') as [X [Z E]]. fold P F in Z, E. exists X. split.
      - split; [|split; [split|]].
        + apply (solution_with_free i inverse whole H H2 DS X Z). fold P F. rewrite (Ext X X' E). exact S.
        + exact Z.
        + intros j J. fold F. rewrite E. apply (B j J).
        + intros ms k Q' K. apply (in_mode_ext _ _ _ (of_contact Q k X') (of_contact Q k (motion Q X'))); [exact DS| |apply (MO ms k Q' K)].
          intros t T. destruct (same_contact i inverse whole H H2 X k t Z K T) as [A A']. fold P F in A, A'.
          rewrite (Ext X X' E) in A, A'. split; symmetry; assumption.
      - intros x SX KN j J. assert (SX' := solution_without_free i inverse whole H H2 DS x SX).
        specialize (N _ SX' KN j J). change (distance (listed_of small m)) with (distance (listed_of i m)) in N.
        cbn [Nat.add free] in N. change (free (problem_of small)) with 0%nat in N. cbn [Nat.add] in N.
        assert (MX := motion_of_forces i inverse whole H H2 x (proj1 SX) j J).
        assert (MF := motion_of_forces i inverse whole H H2 X Z j J).
        fold P F in MX, MF. rewrite (Ext X X' E) in MF. fold F. rewrite MX, MF.
        destruct (distance (listed_of i m)) as [e|]; [|exact N]. destruct N as [y' [[_ Y] D]].
        destruct (with_free i inverse whole H y') as [y [ZY EY]]. fold P F in ZY, EY. exists y. split.
        + split; [exact ZY|]. intros k K. fold F. rewrite EY. apply (Y k K).
        + assert (MY := motion_of_forces i inverse whole H H2 y ZY j J). fold P F in MY. rewrite (Ext y y' EY) in MY.
          fold F. rewrite MY. exact D. }
    destruct (choose_each motions _ (fun _ => 0) Found) as [found FO]. exists found. split.
    - intros j m M. rewrite nth_error_map in M. destruct (nth_error motions j) as [m'|] eqn:E; [|discriminate].
      cbn in M. inversion M; subst. apply (FO j m' E).
    - intros x SX. assert (SX' := solution_without_free i inverse whole H H2 DS x SX).
      destruct (check_tree_sound small H2 PS NF motions tree _ H0 (PositiveMap.empty state) _ (or_introl eq_refl) SX')
        as [j [m [M KN]]].
      + intros k K. unfold state_of. rewrite look_empty. exact I.
      + exists j, (listed_of i m). split; [rewrite nth_error_map, M; reflexivity|].
        apply (proj2 (FO j m M) x SX KN).
  Qed.
End Instance.
