(** What multipliers prove of the motions in a pattern (FORMAT.md, `all-solutions`, "Multipliers"). *)
From Coq Require Import NArith Reals List Bool Lra Lia Psatz FMapPositive FunctionalExtensionality.
From Slipproof.contact Require Import Coulomb Number Fixed Linear Zero Certificate Checker Rows Law Enclose Motions Arcs States.
Import ListNotations.
Local Open Scope R_scope.

Lemma sum_positive n f k : (k < n)%nat -> (forall j, (j < n)%nat -> 0 <= f j) -> 0 < f k -> 0 < sum n f.
Proof.
  induction n as [|n IH]; intros K N P; [lia|]. cbn. assert (S := sum_nonnegative n f (fun j J => N j ltac:(lia))).
  assert (F := N n ltac:(lia)). destruct (Nat.eq_dec k n) as [->|D]; [lra|].
  assert (Q : 0 < sum n f) by (apply IH; auto; lia). lra.
Qed.

Lemma layout_only d at_ slip_ mus modes c : length modes = length mus -> In c (layout d at_ slip_ mus modes) ->
  exists k, (k < length mus)%nat /\
    c = Contact (at_ + d * N.of_nat k) (slip_ + N.of_nat k) (nth k mus zero) (nth k modes Open).
Proof.
  revert at_ slip_ modes. induction mus as [|m mus IH]; intros at_ slip_ [|s modes] L I; cbn in *; try lia; try contradiction.
  destruct I as [<-|I].
  - exists 0%nat. split; [lia|]. cbn. f_equal; lia.
  - destruct (IH _ _ modes ltac:(lia) I) as [k [K ->]]. exists (S k). split; [lia|]. cbn [nth]. f_equal; lia.
Qed.

Section Instance.
  Variable i : instance.
  Hypothesis whole : is_whole i = true.
  Hypothesis fine_numbers : is_proper i = true.
  Let p := tables_of i.
  Let P := problem_of i.
  Let n := size P.
  Let d := dimension P.
  Let modes := map (fun _ => Open) (frictions i).

  (** A vector of the components that there are. *)
  Definition cut (x : nat -> R) : vector := fun k => if Nat.ltb (N.to_nat k) n then x (N.to_nat k) else 0.

  Lemma cut_at x j : (j < n)%nat -> cut x (N.of_nat j) = x j.
  Proof. intros J. unfold cut. rewrite Nat2N.id. destruct (Nat.ltb_spec j n); [reflexivity | lia]. Qed.

  Lemma rows_number : N.to_nat (t_size p) = n.
  Proof. exact (size_is i). Qed.

  Lemma d_size : (1 <= d <= 3)%nat.
  Proof. exact (dimension_is i fine_numbers). Qed.

  (** Sums over the components, of tables *)
  Lemma accumulated m x l v : sum n (fun j => value (get (accumulate m x l) (N.of_nat j)) * v j)
    = sum n (fun j => value (get m (N.of_nat j)) * v j) + value x * apply l (cut v).
  Proof.
    assert (G := accumulate_value (range 0 n) m x l (cut v) (range_NoDup _ _)). rewrite !sum_over_range in G.
    rewrite (sum_ext _ _ (fun t => value (get (accumulate m x l) (0 + N.of_nat t)%N) * cut v (0 + N.of_nat t)%N))
      by (intros; rewrite N.add_0_l, cut_at by assumption; reflexivity).
    rewrite G.
    - f_equal. apply sum_ext. intros t T. rewrite N.add_0_l, cut_at by exact T. reflexivity.
    - intros k K. unfold cut. destruct (Nat.ltb_spec (N.to_nat k) n) as [L|L]; [|reflexivity].
      exfalso. apply K, range_In. lia.
  Qed.

  Lemma row_applied j x : apply (linear_part (row p (N.of_nat j))) (cut x) = sum n (fun k => matrix P j k * x k).
  Proof.
    cbn [linear_part row]. unfold p. rewrite (row_linear i whole). apply sum_ext. intros k K. fold P n. rewrite cut_at by exact K.
    reflexivity.
  Qed.

  Hypothesis no_free : frees i = 0%N.

  Definition in_pattern (s : pattern) (r : nat -> R) : Prop := forall k, (k < contacts P)%nat ->
    allows d (friction P k) (state_of s (N.of_nat k)) (of_contact P k r) (of_contact P k (motion P r)).

  Lemma no_free_here : free P = 0%nat.
  Proof. unfold P, problem_of; cbn. rewrite no_free. reflexivity. Qed.

  Lemma v_of_sum b y u : sum n (fun j => value (get (v_of b y) (N.of_nat j)) * u j)
    = apply (of_velocities b) (cut u) - sum n (fun j => numbers y j * u j).
  Proof.
    unfold v_of. rewrite accumulated, value_one.
    rewrite (sum_ext _ (fun j => value (get (table_of (map opp y)) (N.of_nat j)) * u j) (fun j => -1 * (numbers y j * u j))).
    - rewrite sum_scale. lra.
    - intros j _. rewrite table_of_value. unfold numbers.
      replace zero with (opp zero) at 1 by reflexivity. rewrite map_nth, value_opp. ring.
  Qed.

  Lemma g_of_sum b y r : sum n (fun j => value (get (g_of p b y) (N.of_nat j)) * r j)
    = apply (of_forces b) (cut r) + sum n (fun j => numbers y j * sum n (fun k => matrix P j k * r k)).
  Proof.
    unfold g_of. rewrite rows_number.
    assert (G : forall count start m, sum n (fun j => value (get (List.fold_left (fun m j =>
          let x := get (table_of y) j in if is_zero x then m else accumulate m x (linear_part (row p j)))
        (range start count) m) (N.of_nat j)) * r j)
      = sum n (fun j => value (get m (N.of_nat j)) * r j)
        + sum count (fun t => numbers y (N.to_nat start + t)
            * sum n (fun k => matrix P (N.to_nat start + t) k * r k))).
    { induction count as [|count IH]; intros start m; [cbn; lra|]. rewrite sum_first. cbn [range List.fold_left]. cbv zeta.
      rewrite IH. assert (Q : sum n (fun j => value (get (if is_zero (get (table_of y) start) then m
          else accumulate m (get (table_of y) start) (linear_part (row p start))) (N.of_nat j)) * r j)
        = sum n (fun j => value (get m (N.of_nat j)) * r j)
          + numbers y (N.to_nat start) * sum n (fun k => matrix P (N.to_nat start) k * r k)).
      { rewrite <- (row_applied (N.to_nat start)), N2Nat.id.
        rewrite <- (table_of_value y), N2Nat.id.
        destruct (is_zero (get (table_of y) start)) eqn:Z; [apply sign_zero in Z; rewrite Z; lra|]. apply accumulated. }
      rewrite Q, Nat.add_0_r, Rplus_assoc. f_equal. f_equal. apply sum_ext. intros t _.
      replace (N.to_nat (N.succ start) + t)%nat with (N.to_nat start + S t)%nat by lia. reflexivity. }
    rewrite G, accumulated, value_one. cbn [N.to_nat Nat.add].
    rewrite (sum_zero _ (fun j => value (get empty (N.of_nat j)) * r j)); [|intros; rewrite get_empty, value_zero; ring].
    lra.
  Qed.

  Lemma work_sum y : value (work p y) = sum n (fun j => numbers y j * constant P j).
  Proof.
    unfold work. rewrite total_range, rows_number. apply sum_ext. intros j _.
    rewrite N.add_0_l, value_mul, table_of_value. unfold p. rewrite (row_constant i). reflexivity.
  Qed.

  Lemma first_at ms k t : (first (contact_at i ms k) + N.of_nat t)%N = N.of_nat (d * k + t).
  Proof. unfold contact_at; cbn [first]. rewrite no_free. unfold d, P, problem_of; cbn [dimension]. lia. Qed.

  Lemma state_at ms s k : of_contact_state p s (contact_at i ms k) = state_of s (N.of_nat k).
  Proof. unfold of_contact_state, contact_at; cbn [slip]. fold p. f_equal. lia. Qed.

  Lemma tangent_plane m k :
    arrow_of (tangent p m (contact_at i modes k)) = plane d (fun t => value (get m (N.of_nat (d * k + t)))).
  Proof.
    assert (F1 := first_at modes k 1). assert (F2 := first_at modes k 2). cbn [N.of_nat Pos.of_succ_nat Pos.succ] in F1, F2.
    unfold arrow_of, tangent, plane. rewrite <- (first_at modes), <- (first_at modes k 2). cbn [fst snd N.of_nat Pos.of_succ_nat Pos.succ].
    assert (D := d_size). unfold d, P, problem_of in *; cbn [dimension] in *. change (t_dim p) with (dim i) in *.
    destruct (N.ltb_spec 1 (dim i)), (Nat.ltb_spec 1 (N.to_nat (dim i))), (N.ltb_spec 2 (dim i)), (Nat.ltb_spec 2 (N.to_nat (dim i)));
      try lia; cbn [fst snd]; rewrite ?value_zero; reflexivity.
  Qed.

  Section Motion.
    Variables (s : pattern) (r : nat -> R).
    Hypothesis solves : solution P r.
    Hypothesis inside : in_pattern s r.
    Let u := motion P r.

    Lemma contact_terms v g k : (k < contacts P)%nat -> fine p s v g (contact_at i modes k) = true ->
      let terms := sum d (fun t => value (get v (N.of_nat (d * k + t))) * u (d * k + t)%nat)
        + sum d (fun t => value (get g (N.of_nat (d * k + t))) * r (d * k + t)%nat) in
      0 <= terms /\ (more p s v (contact_at i modes k) = true -> 0 < terms).
    Proof.
      intros K H. unfold fine, more in *. rewrite state_at in *. apply andb_prop in H. destruct H as [V G].
      assert (Law := proj2 solves k K). assert (A := inside k K).
      assert (M : value (mu (contact_at i modes k)) = friction P k) by reflexivity.
      assert (M0 : 0 <= friction P k) by (apply (friction_is i fine_numbers), K).
      assert (E : forall m, value (get m (first (contact_at i modes k))) = value (get m (N.of_nat (d * k + 0)))).
      { intros m. rewrite <- (first_at modes). cbn [N.of_nat]. rewrite N.add_0_r. reflexivity. }
      assert (OC : forall (x : nat -> R) t, x (d * k + t)%nat = of_contact P k x t).
      { intros x t. unfold of_contact. rewrite no_free_here. reflexivity. }
      destruct (velocities_sound d (mu (contact_at i modes k)) _ _ _ d_size Law A _ _ V) as [V0 V1].
      assert (G0 := forces_sound d (mu (contact_at i modes k)) _ _ _ d_size M0 Law A _ _ G).
      rewrite tangent_plane, E in V0, V1, G0. cbv zeta.
      rewrite (sum_ext d _ (fun t => value (get v (N.of_nat (d * k + t))) * of_contact P k u t)) by (intros; rewrite OC; reflexivity).
      rewrite (sum_ext d (fun t => value (get g (N.of_nat (d * k + t))) * r (d * k + t)%nat)
        (fun t => value (get g (N.of_nat (d * k + t))) * of_contact P k r t)) by (intros; rewrite OC; reflexivity).
      rewrite (sum_plane d (fun t => value (get v (N.of_nat (d * k + t)))) _ d_size).
      rewrite (sum_plane d (fun t => value (get g (N.of_nat (d * k + t)))) _ d_size).
      fold u in V0, V1. split; [lra|]. intros Q. specialize (V1 Q). lra.
    Qed.

    Lemma all_terms v g : forallb (fine p s v g) (all_contacts p) = true ->
      let terms := sum n (fun j => value (get v (N.of_nat j)) * u j) + sum n (fun j => value (get g (N.of_nat j)) * r j) in
      0 <= terms /\ (existsb (more p s v) (all_contacts p) = true -> 0 < terms).
    Proof.
      intros H. cbv zeta. unfold n, size. rewrite no_free_here. cbn [Nat.add]. rewrite !sum_blocks, <- sum_plus.
      rewrite forallb_forall in H.
      assert (T : forall k, (k < contacts P)%nat -> fine p s v g (contact_at i modes k) = true).
      { intros k K. apply H. apply contact_at_In; [apply map_length | exact K]. }
      assert (T0 := fun k K => proj1 (contact_terms v g k K (T k K))). cbv zeta in T0. split; [apply sum_nonnegative; exact T0|].
      intros X. apply existsb_exists in X. destruct X as [c [C M]]. unfold all_contacts, contacts_of in C.
      change (t_mus p) with (frictions i) in C. fold modes in C.
      assert (I : exists k, (k < contacts P)%nat /\ c = contact_at i modes k).
      { apply layout_only in C; [|apply map_length]. exact C. }
      destruct I as [k [K ->]]. apply (sum_positive _ _ k K); [exact T0|]. apply contact_terms; auto.
    Qed.

    Theorem proved_sound b y : proved p s b y = true ->
      value (at_least b) <= apply (of_velocities b) (cut u) + apply (of_forces b) (cut r).
    Proof.
      intros H. unfold proved in H. split_and H. destruct (all_terms _ _ H1) as [T _]. cbv zeta in T.
      rewrite v_of_sum, g_of_sum in T. apply le_value in H0. rewrite work_sum in H0.
      assert (U : sum n (fun j => numbers y j * u j)
        = sum n (fun j => numbers y j * sum n (fun k => matrix P j k * r k)) + sum n (fun j => numbers y j * constant P j)).
      { rewrite <- sum_plus. apply sum_ext. intros j _. unfold u, motion. fold n. ring. }
      lra.
    Qed.

    Theorem excluded_sound y : excluded p s y = true -> False.
    Proof.
      intros H. unfold excluded in H. split_and H. destruct (all_terms _ _ H1) as [T T']. cbv zeta in T, T'.
      rewrite v_of_sum, g_of_sum in T, T'. cbn [of_velocities of_forces apply] in T, T'.
      assert (U : sum n (fun j => numbers y j * u j)
        = sum n (fun j => numbers y j * sum n (fun k => matrix P j k * r k)) + sum n (fun j => numbers y j * constant P j)).
      { rewrite <- sum_plus. apply sum_ext. intros j _. unfold u, motion. fold n. ring. }
      apply orb_prop in H0. destruct H0 as [Q|Q].
      - apply sign_positive in Q. rewrite work_sum in Q. lra.
      - apply andb_prop in Q. destruct Q as [Q X]. apply sign_nonnegative in Q. rewrite work_sum in Q. specialize (T' X). lra.
    Qed.
  End Motion.
End Instance.
