(** What is accepted of an enclosure, and of an exact solution of a problem nearby, is true. *)
From Coq Require Import NArith Reals List Bool Lra Lia Psatz FMapPositive FunctionalExtensionality.
From Slipproof.contact Require Import Coulomb Number Fixed Linear Zero Certificate Checker Rows Law.
Import ListNotations.
Local Open Scope R_scope.

Lemma apply_ext_in l v w : (forall e, In e l -> v (fst e) = w (fst e)) -> apply l v = apply l w.
Proof.
  induction l as [|[j a] l IH]; intros E; cbn; [reflexivity|].
  assert (A := E (j, a) (or_introl eq_refl)). cbn in A. rewrite A, IH; [reflexivity|]. intros e I. apply E. right. exact I.
Qed.

Lemma is_in_indices l i : is_in (indices l) i = true -> In i l.
Proof.
  unfold indices, is_in.
  assert (G : forall m, PositiveMap.mem (key i) (List.fold_left (fun m i => PositiveMap.add (key i) tt m) l m) = true ->
    In i l \/ PositiveMap.mem (key i) m = true).
  { induction l as [|j l IH]; intros m H; cbn in *; [right; exact H|].
    destruct (IH _ H) as [A|A]; [left; right; exact A|]. rewrite PositiveMap.mem_find in *.
    destruct (Pos.eq_dec (key i) (key j)) as [E|E].
    - left. left. symmetry. apply key_inj, E.
    - right. rewrite PositiveMap.gso in A by exact E. exact A. }
  intros H. destruct (G _ H) as [A|A]; [exact A|]. rewrite PositiveMap.mem_find, PositiveMap.gempty in A. discriminate.
Qed.

Lemma others_In {A} taken (l : list A) b x i :
  nth_error l b = Some x -> is_in taken (i + N.of_nat b) = false -> In x (others i taken l).
Proof.
  revert b i. induction l as [|y l IH]; intros b i E T; [destruct b; discriminate|].
  destruct b as [|b]; cbn in *.
  - inversion E; subst. rewrite N.add_0_r in T. rewrite T. left. reflexivity.
  - specialize (IH b (N.succ i) E). replace (N.succ i + N.of_nat b)%N with (i + N.pos (Pos.of_succ_nat b))%N in IH by lia.
    specialize (IH T). destruct (is_in taken i); [exact IH | right; exact IH].
Qed.

Lemma name_rows_names i left inverse : map fst (name_rows i left inverse) = left.
Proof. revert i. induction left as [|j l IH]; intros i; cbn; [reflexivity|]. rewrite IH. reflexivity. Qed.

Lemma map_tabulate z p kept b :
  look flat (tabulate 0 (map (expand z p) kept) (PositiveMap.empty expansion)) b = expand z p (nth (N.to_nat b) kept nothing).
Proof.
  rewrite look_list. replace flat with (expand z p nothing) by reflexivity. apply map_nth.
Qed.

Lemma fractions_size t : In t fractions -> 0 <= value t <= 1.
Proof.
  intros I. cbn in I.
  destruct I as [<-|[<-|[<-|[<-|[<-|[]]]]]];
    (split; [apply sign_nonnegative; reflexivity | rewrite <- value_one; apply le_value; reflexivity]).
Qed.

Lemma has_zero_sound z p left kept inverse : has_zero z p left kept inverse = true ->
  exists d, (forall k, Rabs (d k) <= absolute p k) /\ (forall k, ~ In k left -> d k = 0) /\ NoDup left /\
    forall e, In e kept -> eval e (fun k => values z k + d k) = 0.
Proof.
  intros H. unfold has_zero in H. split_and H. apply Nat.eqb_eq in H. apply distinct_NoDup in H2.
  apply existsb_exists in H0. destruct H0 as [t [T H0]]. rewrite forallb_forall in H0, H1.
  set (known := look flat (tabulate 0 (map (expand z p) kept) (PositiveMap.empty expansion))) in *.
  set (rows := name_rows 0 left inverse) in *.
  set (found := fun e : N * linear => _) in *.
  destruct (zero_in_box (fun b => nth (N.to_nat b) kept nothing) z p left rows t known) as [d [D [O Z]]].
  - intros b. apply map_tabulate.
  - apply name_rows_names.
  - exact H2.
  - intros b B. apply nth_overflow. lia.
  - apply fractions_size, T.
  - intros j row I. apply (in_map found) in I. apply H1 in I. unfold found in I.
    apply andb_prop in I. destruct I as [A _]. apply lt_value in A. rewrite value_abs in A. exact A.
  - intros j row I. apply (in_map found) in I. apply H0 in I. exact I.
  - exists d. split; [exact D|]. split; [exact O|]. split; [exact H2|]. intros e E.
    apply (In_nth _ _ nothing) in E. destruct E as [n [L <-]]. specialize (Z (N.of_nat n)). cbv beta in Z.
    rewrite Nat2N.id in Z. exact Z.
Qed.

Lemma linear_eval e z d : is_linear e = true ->
  eval e (fun k => values z k + d k) = value (at_center e z) + apply (slope e z) d.
Proof. intros L. rewrite eval_shift. unfold is_linear in L. destruct (quadratic_part e); [cbn; lra | discriminate]. Qed.

Lemma combined_zero z left taken all dd d : NoDup left -> (forall k, ~ In k left -> d k = 0) ->
  (forall b, is_in taken b = false -> eval (look nothing all b) (fun k => values z k + d k) = 0) ->
  combined z left taken all dd = true -> eval (look nothing all (fst dd)) (fun k => values z k + d k) = 0.
Proof.
  intros N O K H. unfold combined in H. split_and H. set (e := look nothing all (fst dd)) in *.
  rewrite linear_eval by exact H.
  assert (Z : apply (snd dd) (fun b => eval (look nothing all b) (fun k => values z k + d k)) = 0).
  { rewrite (apply_ext_in _ _ (fun _ => 0)); [apply apply_zero; reflexivity|].
    intros c C. rewrite forallb_forall in H2. specialize (H2 c C). apply andb_prop in H2. destruct H2 as [A _].
    apply K. apply negb_true_iff, A. }
  rewrite (apply_ext_in _ _ (fun b => value (at_center (look nothing all b) z) + apply (slope (look nothing all b) z) d)) in Z.
  2: { intros c C. apply linear_eval. rewrite forallb_forall in H2. specialize (H2 c C).
       apply andb_prop in H2. apply H2. }
  rewrite apply_plus in Z.
  assert (V : value (at_center e z) = apply (snd dd) (fun b => value (at_center (look nothing all b) z))).
  { apply sign_zero in H1.
    assert (G : forall l s, value (List.fold_left
        (fun s c => add s (mul (opp (snd c)) (at_center (look nothing all (fst c)) z))) l s)
      = value s - apply l (fun b => value (at_center (look nothing all b) z))).
    { induction l as [|[j a] l IH]; intros s; cbn [List.fold_left apply fst snd]; [lra|].
      rewrite IH, value_add, value_mul, value_opp. lra. }
    rewrite G in H1. lra. }
  assert (S : apply (slope e z) d = apply (snd dd) (fun b => apply (slope (look nothing all b) z) d)).
  { assert (G : forall l m, sum_over left (fun k => value (get (List.fold_left
        (fun m c => accumulate m (opp (snd c)) (slope (look nothing all (fst c)) z)) l m) k) * d k)
      = sum_over left (fun k => value (get m k) * d k) - apply l (fun b => apply (slope (look nothing all b) z) d)).
    { induction l as [|[j a] l IH]; intros m; cbn [List.fold_left apply fst snd]; [lra|].
      rewrite IH, accumulate_value, value_opp by assumption. lra. }
    specialize (G (snd dd) (accumulate empty one (slope e z))). rewrite accumulate_value, value_one in G by assumption.
    rewrite sum_over_zero in G.
    - rewrite sum_over_zero in G; [lra|]. intros k _. rewrite get_empty, value_zero. lra.
    - intros k L. rewrite forallb_forall in H0. specialize (H0 k L). apply sign_zero in H0. rewrite H0. lra. }
  lra.
Qed.

Section Instance.
  Variable i : instance.
  Hypothesis whole : is_whole i = true.
  Hypothesis fine : is_proper i = true.
  Let p := tables_of i.
  Let P := problem_of i.

  Lemma dimension_is : (1 <= N.to_nat (dim i) <= 3)%nat.
  Proof. assert (F := fine). unfold is_proper in F. split_and F. apply N.leb_le in F. apply N.leb_le in H0. lia. Qed.

  Lemma friction_is k : (k < length (frictions i))%nat ->
    0 <= value (nth k (frictions i) zero) /\ (dim i = 1%N -> value (nth k (frictions i) zero) = 0).
  Proof.
    intros K. assert (F := fine). unfold is_proper in F. split_and F. rewrite forallb_forall in H.
    specialize (H _ (nth_In _ zero K)). apply andb_prop in H. destruct H as [A B].
    split; [apply sign_nonnegative, A|]. intros D. rewrite D in B. apply sign_zero, B.
  Qed.

  Lemma proper_problem : proper P.
  Proof.
    split; [apply dimension_is|]. intros k K. destruct (friction_is k K) as [A B]. split; [exact A|].
    intros D. apply B. unfold P, problem_of in D; cbn in D. lia.
  Qed.

  Section Contact.
    Variables (b : box) (d : vector) (c : contact).
    Hypothesis inside : within b d.
    Let v : vector := fun k => values (center_of b) k + d k.
    Let r (t : nat) : R := v (first c + N.of_nat t)%N.
    Let u (t : nat) : R := eval (row p (first c + N.of_nat t)) v.
    Let D := N.to_nat (dim i).
    Hypothesis mu_size : 0 <= value (mu c) /\ (dim i = 1%N -> value (mu c) = 0).
    Hypothesis zeros : forall e, In e (equations_of p c) -> eval e v = 0.

    Lemma tangents_vanish : forallb (vanishes b) (range (first c + 1) (N.to_nat (dim i - 1))) = true ->
      forall t, (1 <= t < D)%nat -> r t = 0.
    Proof.
      intros H t T. rewrite forallb_forall in H. apply vanishes_zero; [exact inside|]. apply H, range_In. unfold D in T. lia.
    Qed.

    Lemma all_vanish : forallb (vanishes b) (first c :: range (first c + 1) (N.to_nat (dim i - 1))) = true ->
      forall t, (t < D)%nat -> r t = 0.
    Proof.
      intros H t T. cbn in H. apply andb_prop in H. destruct H as [A B]. destruct t as [|t].
      - unfold r. cbn. rewrite N.add_0_r. apply vanishes_zero; assumption.
      - apply tangents_vanish; [exact B | lia].
    Qed.

    Lemma first_zero : eval (row p (first c)) v = u 0%nat.
    Proof. unfold u; cbn. rewrite N.add_0_r. reflexivity. Qed.

    Lemma normal_low : nonnegative (low b (first c)) = true -> 0 <= value (low b (first c)) <= r 0%nat.
    Proof.
      intros H. apply sign_nonnegative in H. split; [exact H|]. unfold r; cbn. rewrite N.add_0_r.
      apply low_le, inside.
    Qed.

    Lemma friction_cases : has_friction (dim i) c = false -> value (mu c) = 0.
    Proof.
      unfold has_friction. intros F. apply andb_false_iff in F. destruct F as [F|F].
      - apply N.ltb_ge in F. apply mu_size. assert (Q := dimension_is). lia.
      - apply negb_false_iff in F. apply sign_zero, F.
    Qed.

    Lemma contact_law : conditions p b c = true ->
      coulomb D (value (mu c)) r u /\ in_mode D (value (mu c)) (its_mode c) r u.
    Proof.
      assert (DD := dimension_is). fold D in DD. destruct mu_size as [M M1].
      intros H. unfold conditions in H. unfold equations_of in zeros.
      change (t_dim p) with (dim i) in *.
      destruct (its_mode c) eqn:E; cbn [in_mode].
      - (* Open *)
        apply andb_prop in H. destruct H as [Z L]. assert (R0 := all_vanish Z). split; [|exact R0].
        apply law_without_force; [lia | exact R0|]. rewrite <- first_zero.
        apply sign_nonnegative in L. eapply Rle_trans; [exact L|]. apply linear_least; [reflexivity | exact inside].
      - (* Touch *)
        assert (R0 := all_vanish H). assert (U := zeros _ (or_introl eq_refl)). rewrite first_zero in U.
        split; [|split; [exact U | exact R0]]. apply law_without_force; [lia | exact R0 | lra].
      - (* Stick *)
        apply andb_prop in H. destruct H as [L C]. assert (U := zeros _ (or_introl eq_refl)). rewrite first_zero in U.
        destruct (normal_low L) as [L0 L1]. destruct (has_friction (dim i) c) eqn:F.
        + assert (Z : forall t, (1 <= t < D)%nat -> u t = 0).
          { intros t T. apply zeros. right. apply in_map, range_In. unfold D in T. lia. }
          split.
          * apply law_without_velocity; auto; [lra|].
            apply le_value in C. unfold Checker.square in C at 2. rewrite !value_mul in C. rewrite total_range in C.
            apply Rle_trans with ((value (mu c) * value (low b (first c))) * (value (mu c) * value (low b (first c)))).
            -- eapply Rle_trans; [|exact C]. unfold square_of. replace (N.to_nat (dim i - 1)) with (D - 1)%nat by (unfold D; lia).
               clear - inside.
               assert (G : forall n, sum n (fun t => r (S t) * r (S t))
                 <= sum n (fun t => value (Checker.square (most b (first c + 1 + N.of_nat t))))).
               { induction n as [|n IH]; cbn [sum]; [lra|]. apply Rplus_le_compat; [exact IH|].
                 unfold Checker.square. rewrite value_mul.
                 assert (B := most_ge b d (first c + 1 + N.of_nat n) inside).
                 replace (first c + 1 + N.of_nat n)%N with (first c + N.of_nat (S n))%N in * by lia.
                 fold (v (first c + N.of_nat (S n))%N) in B. fold (r (S n)) in B.
                 replace (r (S n) * r (S n)) with (Rabs (r (S n)) * Rabs (r (S n)))
                   by (unfold Rabs; destruct Rcase_abs; ring).
                 apply Rmult_le_compat; auto using Rabs_pos. }
               apply G.
            -- assert (Q : 0 <= value (mu c) * value (low b (first c)) <= value (mu c) * r 0%nat) by (split; nra).
               apply Rmult_le_compat; lra.
          * split; [exact U|]. intros _ t T. destruct t as [|t]; [exact U | apply Z; lia].
        + assert (M0 := friction_cases F). split.
          * apply law_without_friction; auto; [apply tangents_vanish, C | lra].
          * split; [exact U|]. intros Q. contradiction.
      - (* Slide *)
        apply andb_prop in H. destruct H as [H S]. apply andb_prop in H. destruct H as [D3 L].
        apply N.eqb_eq in D3. assert (D3' : D = 3%nat) by (unfold D; lia).
        destruct (normal_low L) as [L0 L1]. apply sign_nonnegative in S.
        assert (SS := low_le b d (slip c) inside). fold (v (slip c)) in SS.
        assert (U := zeros _ (or_introl eq_refl)). rewrite first_zero in U.
        assert (U1 : u 1%nat = - v (slip c) * r 1%nat).
        { assert (Q := zeros _ (or_intror (or_introl eq_refl))).
          unfold u, r, sliding, eval, row in *.
          cbn [constant_part linear_part quadratic_part products N.of_nat Pos.of_succ_nat Pos.succ] in Q |- *.
          rewrite value_one in Q. lra. }
        assert (U2 : u 2%nat = - v (slip c) * r 2%nat).
        { assert (Q := zeros _ (or_intror (or_intror (or_introl eq_refl)))).
          unfold u, r, sliding, eval, row in *.
          cbn [constant_part linear_part quadratic_part products N.of_nat Pos.of_succ_nat Pos.succ] in Q |- *.
          rewrite value_one in Q. lra. }
        assert (K : r 1%nat * r 1%nat + r 2%nat * r 2%nat = (value (mu c) * r 0%nat) * (value (mu c) * r 0%nat)).
        { assert (Q := zeros _ (or_intror (or_intror (or_intror (or_introl eq_refl))))).
          unfold r, cone, eval in *. cbn in Q |- *. unfold Checker.square in Q.
          rewrite value_one, value_zero, value_opp, value_mul in Q. rewrite N.add_0_r. lra. }
        assert (KK : square_of D r = (value (mu c) * r 0%nat) * (value (mu c) * r 0%nat)).
        { rewrite <- K, D3'. unfold square_of. cbn. lra. }
        split; [|split; [exact U|]].
        + apply law_sliding; auto; try lra.
          * rewrite D3'. cbn. rewrite U1, U2. nra.
          * intros _. rewrite U1, U2. ring.
        + apply tangential_eq; [nra | exact KK].
      - (* SlidePlus *)
        apply andb_prop in H. destruct H as [H S]. apply andb_prop in H. destruct H as [D2 L].
        apply N.eqb_eq in D2. assert (D2' : D = 2%nat) by (unfold D; lia).
        destruct (normal_low L) as [L0 L1]. apply sign_nonnegative in S.
        assert (U := zeros _ (or_introl eq_refl)). rewrite first_zero in U.
        assert (U1 : 0 <= u 1%nat).
        { eapply Rle_trans; [exact S|]. apply linear_least; [reflexivity | exact inside]. }
        assert (K : r 1%nat = - (value (mu c) * r 0%nat)).
        { assert (Q := zeros _ (or_intror (or_introl eq_refl))). unfold r, edge, eval in *. cbn in Q |- *.
          rewrite value_one, value_zero in Q. rewrite N.add_0_r. lra. }
        split; [|repeat split; auto].
        apply law_sliding; auto; try lra.
        + rewrite D2'. unfold square_of. cbn. rewrite K. ring.
        + rewrite D2'. cbn. rewrite K. assert (Q : 0 <= value (mu c) * r 0%nat) by nra. nra.
        + intros Q. lia.
      - (* SlideMinus *)
        apply andb_prop in H. destruct H as [H S]. apply andb_prop in H. destruct H as [D2 L].
        apply N.eqb_eq in D2. assert (D2' : D = 2%nat) by (unfold D; lia).
        destruct (normal_low L) as [L0 L1]. apply sign_nonnegative in S. rewrite value_opp in S.
        assert (U := zeros _ (or_introl eq_refl)). rewrite first_zero in U.
        assert (U1 : u 1%nat <= 0).
        { eapply Rle_trans; [apply (linear_least b (row p (first c + 1)) d); [reflexivity | exact inside]|]. lra. }
        assert (K : r 1%nat = value (mu c) * r 0%nat).
        { assert (Q := zeros _ (or_intror (or_introl eq_refl))). unfold r, edge, eval in *. cbn in Q |- *.
          rewrite value_one, value_zero, value_opp in Q. rewrite N.add_0_r. lra. }
        split; [|repeat split; auto].
        apply law_sliding; auto; try lra.
        + rewrite D2'. unfold square_of. cbn. rewrite K. ring.
        + rewrite D2'. cbn. rewrite K. assert (Q : 0 <= value (mu c) * r 0%nat) by nra. nra.
        + intros Q. lia.
    Qed.
  End Contact.

  (** Of contact k among the tables. *)
  Definition contact_at (modes : list mode) (k : nat) : contact :=
    Contact (frees i + dim i * N.of_nat k) (t_size p + N.of_nat k) (nth k (frictions i) zero) (nth k modes Open).

  Lemma contact_at_In modes k : length modes = length (frictions i) -> (k < contacts P)%nat ->
    In (contact_at modes k) (contacts_of p modes).
  Proof. intros L K. apply layout_In; assumption. Qed.

  Lemma of_contact_vector modes k (v : vector) :
    of_contact P k (fun j => v (N.of_nat j)) = fun t => v (first (contact_at modes k) + N.of_nat t)%N.
  Proof.
    apply functional_extensionality. intros t. unfold of_contact, contact_at; cbn [first]. f_equal.
    unfold P, problem_of; cbn [free dimension]. lia.
  Qed.

  Lemma of_contact_motion modes k v :
    of_contact P k (motion P (fun j => v (N.of_nat j)))
    = fun t => eval (row p (first (contact_at modes k) + N.of_nat t)) v.
  Proof.
    apply functional_extensionality. intros t. unfold of_contact. rewrite <- (row_motion i whole).
    unfold contact_at; cbn [first]. do 2 f_equal. unfold P, problem_of; cbn [free dimension]. lia.
  Qed.

  Lemma middle_motion l j : value (middle (Box (table_of l) empty) (row p (N.of_nat j))) = motion P (numbers l) j.
  Proof.
    unfold middle, motion. rewrite value_add, sum_of_value. cbn [constant_part linear_part row center_of].
    unfold p, P. rewrite (row_linear i whole), (row_constant i). rewrite Rplus_comm. f_equal.
    apply sum_ext. intros t _. unfold values. rewrite table_of_value. reflexivity.
  Qed.

  Definition zero_of (b : box) (d : vector) : vector := fun k => values (center_of b) k + d k.

  Lemma check_box_sound modes center radius pinned dropped zero_near :
    (forall z r left kept, zero_near z r left kept = true ->
      exists d, (forall k, Rabs (d k) <= absolute r k) /\ (forall k, ~ In k left -> d k = 0) /\ NoDup left /\
        forall e, In e kept -> eval e (fun k => values z k + d k) = 0) ->
    check_box p modes center radius pinned dropped zero_near = true ->
    exists d, let b := box_of p modes center radius pinned in let X := fun j => zero_of b d (N.of_nat j) in
      within b d /\ (forall k, ~ In k (unknowns_left p modes pinned) -> d k = 0) /\
      (forall e, In e (equations_kept p modes dropped) -> eval e (zero_of b d) = 0) /\
      solution P X /\
      forall k, (k < contacts P)%nat -> in_mode (dimension P) (friction P k) (nth k modes Open)
        (of_contact P k X) (of_contact P k (motion P X)).
  Proof.
    intros ZN H. unfold check_box in H.
    set (left := unknowns_left p modes pinned) in *. set (b := box_of p modes center radius pinned) in *.
    split_and H. apply Nat.eqb_eq in H. change (t_mus p) with (frictions i) in H.
    destruct (ZN _ _ _ _ H1) as [d [D [O [ND Z]]]]. exists d. cbv zeta. assert (W : within b d) by exact D.
    split; [exact W|]. split; [exact O|]. split; [exact Z|].
    set (v := fun k => values (center_of b) k + d k) in *. change (zero_of b d) with v.
    set (all := tabulate 0 (equations p modes) (PositiveMap.empty equation)) in *.
    set (taken := indices (map fst dropped)) in *.
    assert (A : forall n, look nothing all n = nth (N.to_nat n) (equations p modes) nothing) by (intros n; apply look_list).
    assert (Kept : forall n, is_in taken n = false -> eval (look nothing all n) v = 0).
    { intros n T. rewrite A. destruct (nth_error (equations p modes) (N.to_nat n)) as [e|] eqn:E.
      - rewrite (nth_error_nth _ _ nothing E). apply Z. apply (others_In _ _ _ _ 0%N E). rewrite N.add_0_l, N2Nat.id. exact T.
      - apply nth_error_None in E. rewrite nth_overflow by assumption. unfold eval; cbn. rewrite value_zero. lra. }
    assert (All : forall e, In e (equations p modes) -> eval e v = 0).
    { intros e E. apply (In_nth _ _ nothing) in E. destruct E as [n [L <-]].
      assert (Q : eval (look nothing all (N.of_nat n)) v = 0).
      { destruct (is_in taken (N.of_nat n)) eqn:T; [|apply Kept, T].
        apply is_in_indices, in_map_iff in T. destruct T as [dd [F I]]. rewrite <- F.
        rewrite forallb_forall in H2. apply (combined_zero (center_of b) left taken all dd d ND O Kept), H2, I. }
      rewrite A, Nat2N.id in Q. exact Q. }
    assert (Contacts : forall k, (k < contacts P)%nat ->
      coulomb (dimension P) (friction P k) (of_contact P k (fun j => v (N.of_nat j)))
        (of_contact P k (motion P (fun j => v (N.of_nat j)))) /\
      in_mode (dimension P) (friction P k) (nth k modes Open) (of_contact P k (fun j => v (N.of_nat j)))
        (of_contact P k (motion P (fun j => v (N.of_nat j))))).
    { intros k K. assert (I := contact_at_In modes k H K).
      rewrite (of_contact_vector modes), (of_contact_motion modes).
      apply (contact_law b d (contact_at modes k) W).
      - apply friction_is, K.
      - intros e E. apply All. apply in_or_app. right. apply in_flat_map. exists (contact_at modes k). split; assumption.
      - rewrite forallb_forall in H0. apply H0, I. }
    split; [split|].
    - intros k K. rewrite <- (row_motion i whole). apply All. apply in_or_app. left. apply in_map, range_In.
      unfold P, problem_of in K; cbn in K. change (t_frees p) with (frees i). lia.
    - intros k K. apply Contacts, K.
    - intros k K. apply Contacts, K.
  Qed.

  Theorem check_near_sound x rho eta modes center radius pinned dropped zero_near :
    (forall z r left kept, zero_near z r left kept = true ->
      exists d, (forall k, Rabs (d k) <= absolute r k) /\ (forall k, ~ In k left -> d k = 0) /\ NoDup left /\
        forall e, In e kept -> eval e (fun k => values z k + d k) = 0) ->
    check_near p x rho eta modes center radius pinned dropped zero_near = true ->
    exists X, solution P X /\ near (size P) (value rho) X (numbers x) /\
      (forall k, (k < contacts P)%nat -> in_mode (dimension P) (friction P k) (nth k modes Open)
        (of_contact P k X) (of_contact P k (motion P X))) /\
      match eta with
      | None => True
      | Some eta => forall j, (free P <= j < size P)%nat -> Rabs (motion P X j - motion P (numbers x) j) <= value eta
      end.
  Proof.
    intros ZN H. unfold check_near in H. set (b := box_of p modes center radius pinned) in *.
    split_and H. destruct (check_box_sound _ _ _ _ _ _ ZN H2) as [d [W [_ [_ [S M]]]]]. fold b in W, S, M.
    set (v := zero_of b d) in *. exists (fun j => v (N.of_nat j)). split; [exact S|]. split; [|split; [exact M|]].
    - intros k K. rewrite forallb_forall in H1.
      assert (Q : In (N.of_nat k) (range 0 (N.to_nat (t_size p)))).
      { apply range_In. assert (SZ := size_is i). fold p P in SZ. rewrite SZ. lia. }
      specialize (H1 _ Q). apply le_value in H1.
      rewrite value_add, !value_abs, value_sub, (table_of_value x k) in H1.
      eapply Rle_trans; [|exact H1]. unfold v, zero_of, values.
      replace (value (get (center_of b) (N.of_nat k)) + d (N.of_nat k) - numbers x k)
        with (value (get (center_of b) (N.of_nat k)) - numbers x k + d (N.of_nat k)) by ring.
      eapply Rle_trans; [apply Rabs_triang|]. specialize (W (N.of_nat k)). unfold absolute in W. lra.
    - destruct eta as [eta|]; [|trivial]. intros j J. rewrite forallb_forall in H0.
      assert (Q : In (N.of_nat j) (range (t_frees p) (N.to_nat (t_size p - t_frees p)))).
      { apply range_In. assert (SZ := size_is i). fold p P in SZ. change (free P) with (N.to_nat (frees i)) in J.
        change (t_frees p) with (frees i). lia. }
      specialize (H0 _ Q). cbv zeta in H0. apply le_value in H0.
      rewrite value_add, value_abs, value_sub in H0.
      eapply Rle_trans; [|exact H0].
      assert (L := linear_middle b (row p (N.of_nat j)) d eq_refl W). fold (zero_of b d) in L. fold v in L.
      rewrite <- (row_motion i whole). fold p.
      rewrite middle_motion. set (e := eval _ v) in *.
      replace (e - motion P (numbers x) j)
        with ((value (middle b (row p (N.of_nat j))) - motion P (numbers x) j) + (e - value (middle b (row p (N.of_nat j))))) by ring.
      eapply Rle_trans; [apply Rabs_triang|]. apply Rplus_le_compat_l. exact L.
  Qed.

  Theorem check_enclosure_sound x rho eta modes center radius pinned dropped inverse :
    check_enclosure p x rho eta modes center radius pinned dropped inverse = true ->
    exists X, solution P X /\ near (size P) (value rho) X (numbers x) /\
      (forall k, (k < contacts P)%nat -> in_mode (dimension P) (friction P k) (nth k modes Open)
        (of_contact P k X) (of_contact P k (motion P X))) /\
      match eta with
      | None => True
      | Some eta => forall j, (free P <= j < size P)%nat -> Rabs (motion P X j - motion P (numbers x) j) <= value eta
      end.
  Proof. apply check_near_sound. intros z r left kept. apply has_zero_sound. Qed.

  Theorem check_eps_sound x bound moved point motions :
    check_eps p x bound moved point motions = true -> eps P (numbers x) (value bound) (value moved).
  Proof.
    intros H. unfold check_eps in H. split_and H.
    set (X := numbers point). set (w := numbers motions).
    set (c := fun j => w j - sum (size P) (fun k => matrix P j k * X k)).
    assert (Mid := middle_motion point). fold X in Mid.
    assert (M : forall j, motion (with_constant P c) X j = w j) by (intros j; unfold motion, with_constant, c, size; cbn; lra).
    rewrite forallb_forall in H0.
    assert (Near : forall j, (j < size P)%nat -> In (N.of_nat j) (range 0 (N.to_nat (t_size p)))).
    { intros j J. apply range_In. assert (SZ := size_is i). fold p P in SZ. rewrite SZ. lia. }
    exists c, X. split; [|split; [|split]].
    - intros j J. specialize (H0 _ (Near j J)). apply andb_prop in H0. destruct H0 as [A _]. apply le_value in A.
      rewrite value_abs, value_sub, Mid, table_of_value in A. fold w in A.
      replace (c j - constant P j) with (w j - motion P X j) by (unfold c, motion; ring). exact A.
    - intros j J. specialize (H0 _ (Near j J)). apply andb_prop in H0. destruct H0 as [_ A]. apply le_value in A.
      rewrite value_abs, value_sub, !table_of_value in A. exact A.
    - intros j J. rewrite M. rewrite forallb_forall in H2.
      assert (Q : In (N.of_nat j) (range 0 (N.to_nat (t_frees p)))).
      { apply range_In. unfold with_constant, P, problem_of in J; cbn in J. change (t_frees p) with (frees i). lia. }
      specialize (H2 _ Q). apply sign_zero in H2. rewrite table_of_value in H2. exact H2.
    - intros k K. change (contacts (with_constant P c)) with (contacts P) in K.
      rewrite (functional_extensionality (motion (with_constant P c) X) w M).
      rewrite forallb_forall in H1.
      set (modes := map (fun _ => Open) (t_mus p)) in *.
      assert (L : length modes = length (frictions i)) by apply map_length.
      specialize (H1 _ (contact_at_In modes k L K)). destruct (friction_is k K) as [A B].
      apply obeys_law in H1; [|apply dimension_is | exact A].
      change (dimension (with_constant P c)) with (N.to_nat (t_dim p)).
      change (friction (with_constant P c) k) with (value (mu (contact_at modes k))).
      assert (E : forall l t, value (get (table_of l) (first (contact_at modes k) + N.of_nat t))
        = of_contact P k (numbers l) t).
      { intros l t. unfold of_contact. rewrite <- table_of_value. do 2 f_equal.
        unfold contact_at; cbn [first]. unfold P, problem_of; cbn [free dimension]. lia. }
      rewrite (functional_extensionality _ _ (E point)), (functional_extensionality _ _ (E motions)) in H1.
      exact H1.
  Qed.
End Instance.
