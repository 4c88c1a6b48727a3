(** What is known of the motions in a case: they are near those of a box, or the one that is alone (FORMAT.md,
    `all-solutions`, `known`). *)
From Coq Require Import NArith Reals List Bool Lra Lia Psatz FMapPositive FunctionalExtensionality.
From Slipproof.contact Require Import Coulomb Number Fixed Linear Zero Certificate Checker Rows Law Enclose Motions.
From Slipproof.contact Require Import Arcs States Multipliers Alone.
Import ListNotations.
Local Open Scope R_scope.

Lemma others_none {A} i (l : list A) : others i (indices []) l = l.
Proof.
  revert i. induction l as [|x l IH]; intros i; [reflexivity|]. cbn [others].
  replace (is_in (indices []) i) with false; [rewrite IH; reflexivity|].
  symmetry. unfold is_in, indices. cbn. rewrite PositiveMap.mem_find, PositiveMap.gempty. reflexivity.
Qed.

Lemma others_from {A} i taken (l : list A) x : In x (others i taken l) -> In x l.
Proof.
  revert i. induction l as [|y l IH]; intros i I; [exact I|]. cbn [others] in I. destruct (is_in taken i).
  - right. apply (IH _ I).
  - destruct I as [<-|I]; [left; reflexivity | right; apply (IH _ I)].
Qed.

Lemma assign_others keys l m k : ~ In k keys -> get (assign keys l m) k = get m k.
Proof.
  revert l m. induction keys as [|j keys IH]; intros [|x l] m K; try reflexivity. cbn [assign].
  rewrite IH by (intros I; apply K; right; exact I). rewrite get_put. destruct (N.eq_dec k j) as [->|]; [|reflexivity].
  exfalso. apply K. left. reflexivity.
Qed.

Lemma bend_row_is f row : value (bend_row f row) = apply_abs row (fun b => value (bend_of (f b))).
Proof.
  unfold bend_row.
  assert (G : forall s, value (List.fold_left (fun s e => add s (mul (abs (snd e)) (bend_of (f (fst e))))) row s)
    = value s + apply_abs row (fun b => value (bend_of (f b)))).
  { induction row as [|[b r] l IH]; intros s; cbn [List.fold_left apply_abs fst snd]; [lra|].
    rewrite IH, value_add, value_mul, value_abs. lra. }
  rewrite G, value_zero; lra.
Qed.

Section Instance.
  Variable i : instance.
  Hypothesis whole : is_whole i = true.
  Hypothesis fine_numbers : is_proper i = true.
  Let p := tables_of i.
  Let P := problem_of i.
  Let n := size P.
  Let d := dimension P.

  (** In a range of a row over a box each value is that of some forces in the box. *)
  Theorem range_attained b k u e : 0 <= e ->
    value (least b (row p (N.of_nat k))) - e <= u <= value (greatest b (row p (N.of_nat k))) + e ->
    exists y, (forall j, Rabs (y j - values (center_of b) (N.of_nat j)) <= absolute (radius_of b) (N.of_nat j)) /\
      Rabs (u - motion P y k) <= e.
  Proof.
    intros E [L H]. unfold least, greatest in L, H. rewrite value_sub in L. rewrite value_add in H.
    set (m := value (middle b (row p (N.of_nat k)))) in *. set (s := value (spread b (row p (N.of_nat k)))) in *.
    assert (S : s = sum n (fun j => Rabs (matrix P k j) * absolute (radius_of b) (N.of_nat j))).
    { unfold s, spread. rewrite size_of_value. cbn [linear_part row]. apply row_sizes, whole. }
    assert (S0 : 0 <= s).
    { rewrite S. apply sum_nonnegative. intros j _. apply Rmult_le_pos; apply Rabs_pos. }
    set (w := Rmax (m - s) (Rmin (m + s) u)).
    assert (W : m - s <= w <= m + s /\ Rabs (u - w) <= e).
    { unfold w, Rmax, Rmin, Rabs. destruct (Rle_dec (m + s) u); destruct (Rle_dec (m - s) _); destruct (Rcase_abs _); lra. }
    destruct W as [W UW].
    set (x := if Req_EM_T s 0 then 0 else (w - m) / s).
    assert (X : Rabs x <= 1 /\ x * s = w - m).
    { unfold x. destruct (Req_EM_T s 0) as [Z|Z]; [rewrite Rabs_R0; split; lra|].
      split; [|field; exact Z]. assert (I : 0 < / s) by (apply Rinv_0_lt_compat; lra).
      unfold Rdiv. rewrite Rabs_mult, (Rabs_right (/ s)) by lra. apply Rmult_le_reg_r with s; [lra|].
      rewrite Rmult_assoc, Rinv_l, Rmult_1_r, Rmult_1_l by exact Z. unfold Rabs; destruct (Rcase_abs _); lra. }
    destruct X as [X XS].
    set (sign := fun j => if Rle_dec 0 (matrix P k j) then 1 else -1).
    assert (Sign : forall j, Rabs (sign j) = 1 /\ matrix P k j * sign j = Rabs (matrix P k j)).
    { intros j. unfold sign. destruct (Rle_dec 0 (matrix P k j)).
      - rewrite Rabs_R1, (Rabs_right (matrix P k j)) by lra. split; ring.
      - rewrite (Rabs_left (matrix P k j)), Rabs_left by lra. split; ring. }
    exists (fun j => values (center_of b) (N.of_nat j) + x * (sign j * absolute (radius_of b) (N.of_nat j))). split.
    - intros j. replace (values (center_of b) (N.of_nat j) + x * (sign j * absolute (radius_of b) (N.of_nat j))
        - values (center_of b) (N.of_nat j)) with (x * (sign j * absolute (radius_of b) (N.of_nat j))) by ring.
      rewrite !Rabs_mult, (proj1 (Sign j)). unfold absolute. rewrite Rabs_Rabsolu.
      assert (Q := Rabs_pos (value (get (radius_of b) (N.of_nat j)))).
      nra.
    - assert (M : motion P (fun j => values (center_of b) (N.of_nat j) + x * (sign j * absolute (radius_of b) (N.of_nat j))) k = w).
      { unfold motion. fold n.
        rewrite (sum_ext n _ (fun j => matrix P k j * values (center_of b) (N.of_nat j)
          + x * (Rabs (matrix P k j) * absolute (radius_of b) (N.of_nat j)))).
        - rewrite sum_plus, sum_scale, <- S, XS. unfold m, middle. rewrite value_add, sum_of_value.
          cbn [constant_part linear_part row]. unfold p, P. rewrite (row_linear i whole), (row_constant i). fold P n. ring.
        - intros j _. rewrite <- (proj2 (Sign j)). ring. }
      rewrite M. exact UW.
  Qed.

  Hypothesis no_free : frees i = 0%N.

  Lemma free_none : free P = 0%nat.
  Proof. exact (no_free_here i no_free). Qed.

  Lemma component (x : nat -> R) k t : of_contact P k x t = x (d * k + t)%nat.
  Proof. unfold of_contact. rewrite free_none. reflexivity. Qed.

  Lemma component_below k t : (k < contacts P)%nat -> (t < d)%nat -> (d * k + t < n)%nat.
  Proof. intros K T. unfold n, size. rewrite free_none. fold d. nia. Qed.

  Section Motion.
    Variables (s : pattern) (r : nat -> R).
    Hypothesis solves : solution P r.
    Hypothesis inside : in_pattern i s r.
    Let u := motion P r.

    Lemma all_proved_each bounds ys : all_proved p s bounds ys = true ->
      forall b, In b bounds -> value (at_least b) <= apply (of_velocities b) (cut i u) + apply (of_forces b) (cut i r).
    Proof.
      revert ys. induction bounds as [|c bounds IH]; intros [|y ys] H b B; try discriminate; [destruct B|].
      cbn [all_proved] in H. apply andb_prop in H. destruct H as [H1 H2].
      destruct B as [<-|B]; [|apply (IH ys H2 b B)]. apply (proved_sound i whole fine_numbers no_free s r solves inside c y H1).
    Qed.

    Lemma rests_zero k t : (k < contacts P)%nat -> (t < d)%nat -> rests (state_of s (N.of_nat k)) (N.of_nat t) = true ->
      of_contact P k u t = 0.
    Proof.
      intros K T H. assert (A := inside k K). destruct (state_of s (N.of_nat k)) as [| | | |a b]; cbn [rests allows] in *; try discriminate.
      - apply N.eqb_eq in H. assert (t = 0%nat) by lia. subst t. exact A.
      - apply A. exact T.
      - apply N.eqb_eq in H. assert (t = 0%nat) by lia. subst t. apply A.
    Qed.

    (** Velocities are near the range of those in a box. *)
    Theorem known_range b e ys :
      all_proved p s (flat_map (velocity_bounds p s b e) (all_contacts p)) ys = true ->
      forallb (zero_in_range p s b e) (all_contacts p) = true ->
      forall j, (j < n)%nat -> value (least b (row p (N.of_nat j))) - value (get e (N.of_nat j)) <= u j
        <= value (greatest b (row p (N.of_nat j))) + value (get e (N.of_nat j)).
    Proof.
      intros A Z j J. assert (D := d_size i fine_numbers). fold P d in D.
      set (k := (j / d)%nat). set (t := (j mod d)%nat).
      assert (JK : j = (d * k + t)%nat) by (apply Nat.div_mod; lia).
      assert (T : (t < d)%nat) by (apply Nat.mod_upper_bound; lia).
      assert (K : (k < contacts P)%nat).
      { unfold n, size in J. rewrite free_none in J. fold d in J. apply Nat.div_lt_upper_bound; lia. }
      set (modes := map (fun _ => Open) (frictions i)).
      assert (I : In (contact_at i modes k) (all_contacts p)) by (apply contact_at_In; [apply map_length | exact K]).
      assert (TI : In (N.of_nat t) (range 0 (N.to_nat (t_dim p)))).
      { apply range_In. change (t_dim p) with (dim i). unfold d, P, problem_of in T; cbn [dimension] in T. lia. }
      assert (F := first_at i no_free modes k t). fold P d in F. rewrite <- JK in F.
      destruct (rests (state_of s (N.of_nat k)) (N.of_nat t)) eqn:RS.
      - assert (U : u j = 0) by (rewrite JK, <- component; apply rests_zero; assumption).
        rewrite forallb_forall in Z. specialize (Z _ I). unfold zero_in_range in Z. rewrite forallb_forall in Z. specialize (Z _ TI).
        cbv zeta in Z. fold p in Z. rewrite (state_at i no_free), RS, F in Z. cbn [negb orb] in Z. apply andb_prop in Z. destruct Z as [Z1 Z2].
        apply sign_nonnegative in Z1. apply sign_nonnegative in Z2. rewrite value_opp, value_sub in Z1. rewrite value_add in Z2. lra.
      - assert (Q := all_proved_each _ _ A).
        assert (In_ : forall c, In c [Bound [(N.of_nat j, one)] [] (sub (least b (row p (N.of_nat j))) (get e (N.of_nat j)));
            Bound [(N.of_nat j, opp one)] [] (opp (add (greatest b (row p (N.of_nat j))) (get e (N.of_nat j))))] ->
            In c (flat_map (velocity_bounds p s b e) (all_contacts p))).
        { intros c C. apply in_flat_map. exists (contact_at i modes k). split; [exact I|]. unfold velocity_bounds.
          apply in_flat_map. exists (N.of_nat t). split; [exact TI|]. cbv zeta. rewrite (state_at i no_free), RS, F. exact C. }
        assert (Q1 := Q _ (In_ _ (or_introl eq_refl))). assert (Q2 := Q _ (In_ _ (or_intror (or_introl eq_refl)))).
        cbn [at_least of_velocities of_forces apply] in Q1, Q2. rewrite (cut_at i u j J) in Q1, Q2.
        rewrite value_sub, value_one in Q1. rewrite !value_opp, value_add, value_one in Q2. lra.
    Qed.
  End Motion.
End Instance.
