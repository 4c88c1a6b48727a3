(** Where W is symmetric and semidefinite, a motion that needs no friction is the only one (FORMAT.md, `all-solutions`,
    `frictionless`). *)
From Coq Require Import NArith Reals List Bool Lra Lia Psatz FMapPositive.
From Slipproof.contact Require Import Coulomb Number Fixed Linear Zero Certificate Checker Rows Law Enclose Motions.
From Slipproof.contact Require Import Multipliers Known.
Import ListNotations.
Local Open Scope R_scope.

Lemma tangents_vanish d v : tangential d v <= 0 -> forall t, (1 <= t < d)%nat -> v t = 0.
Proof.
  intros H [|t] T; [lia|]. assert (Q := tangential_square d v). assert (N := tangential_nonnegative d v).
  apply (sum_square_zero (d - 1) (fun t => v (S t))); [|lia]. change (square_of d v = 0). nra.
Qed.

(** Coulomb's law at two solutions of which one needs no friction: in no component does the force change as the velocity does. *)
Theorem changes_oppose d m r u r' u' : 0 <= m -> coulomb d m r u -> coulomb d m r' u' ->
  (forall t, (1 <= t < d)%nat -> r t = 0 /\ (m = 0 \/ u t = 0)) ->
  forall t, (t < d)%nat -> (r' t - r t) * (u' t - u t) <= 0.
Proof.
  intros M [P U Z _ _] [P' U' Z' C O] N [|t] T; [nra|].
  destruct (N (S t) ltac:(lia)) as [-> Q]. destruct Q as [Q| ->].
  - rewrite Q, Rmult_0_l in C. rewrite (tangents_vanish d r' C) by lia. lra.
  - specialize (O (S t) ltac:(lia)). assert (V := tangential_nonnegative d u'). destruct V as [V|V].
    + assert (S0 : tangential d u' * (r' (S t) * u' (S t)) = - (m * r' 0%nat * (u' (S t) * u' (S t))))
        by (rewrite <- Rmult_assoc, O; ring).
      assert (M0 : 0 <= m * r' 0%nat * (u' (S t) * u' (S t))) by (apply Rmult_le_pos; nra). nra.
    + rewrite (tangents_vanish d u') by (lra || lia). lra.
Qed.

Section Instance.
  Variable i : instance.
  Hypothesis whole : is_whole i = true.
  Hypothesis fine_numbers : is_proper i = true.
  Hypothesis no_free : frees i = 0%N.
  Let p := tables_of i.
  Let P := problem_of i.
  Let n := size P.
  Let d := dimension P.

  (** Row j of the sum of squares, applied to v; w times the sum of squares times v. *)
  Definition row_of_squares (squares : list (number * linear * table)) (j : nat) (v : nat -> R) : R :=
    fold_right (fun s a => match s with (d, l, t) => value d * value (get t (N.of_nat j)) * apply l (cut i v) + a end) 0 squares.
  Definition form_of_squares (squares : list (number * linear * table)) (w v : nat -> R) : R :=
    fold_right (fun s a => match s with (d, l, _) => value d * apply l (cut i w) * apply l (cut i v) + a end) 0 squares.

  Lemma rest_of_row_sum squares j v : sum n (fun k => value (get (rest_of_row p squares (N.of_nat j)) (N.of_nat k)) * v k)
    = sum n (fun k => matrix P j k * v k) - row_of_squares squares j v.
  Proof.
    unfold rest_of_row. set (m := accumulate empty one (linear_part (row p (N.of_nat j)))).
    assert (M : sum n (fun k => value (get m (N.of_nat k)) * v k) = sum n (fun k => matrix P j k * v k)).
    { unfold m, n, P. rewrite (accumulated i), value_one. unfold p. rewrite (row_applied i whole).
      rewrite sum_zero by (intros; rewrite get_empty, value_zero; ring). ring. }
    rewrite <- M. clear M. clearbody m. revert m. induction squares as [|[[f l] t] squares IH]; intros m; cbn [List.fold_left row_of_squares fold_right].
    - lra.
    - fold (row_of_squares squares j v). cbv zeta. rewrite IH. destruct (is_zero (get t (N.of_nat j))) eqn:Z.
      + apply sign_zero in Z. rewrite Z. lra.
      + unfold n, P. rewrite (accumulated i), value_opp, value_mul. lra.
  Qed.

  Lemma form_by_rows squares w v :
    sum n (fun j => w j * row_of_squares (map square_tables squares) j v) = form_of_squares (map square_tables squares) w v.
  Proof.
    induction squares as [|[f l] squares IH]; cbn [map]; unfold row_of_squares, form_of_squares; cbn [fold_right square_tables fst snd].
    - apply sum_zero. intros; ring.
    - set (e := filter _ _). fold (form_of_squares (map square_tables squares) w v). rewrite <- IH.
      rewrite (sum_ext n _ (fun j => value f * apply e (cut i v) * (value (get (accumulate empty one e) (N.of_nat j)) * w j)
        + w j * row_of_squares (map square_tables squares) j v))
        by (intros; fold (row_of_squares (map square_tables squares) i0 v); ring).
      rewrite sum_plus, sum_scale. unfold n at 1, P. rewrite (accumulated i), value_one.
      rewrite (sum_zero _ (fun j => value (get empty (N.of_nat j)) * w j)) by (intros; rewrite get_empty, value_zero; ring). ring.
  Qed.

  (** Where a sum of squares is not positive, all of it is 0. *)
  Lemma squares_vanish squares v : (forall s, In s squares -> 0 <= value (fst (fst s))) -> form_of_squares squares v v <= 0 ->
    form_of_squares squares v v = 0 /\ forall j, row_of_squares squares j v = 0.
  Proof.
    induction squares as [|[[f l] t] squares IH]; intros N H; [split; reflexivity|].
    unfold form_of_squares in H; cbn [fold_right] in H. fold (form_of_squares squares v v) in H.
    assert (F := N _ (or_introl eq_refl)). cbn [fst] in F. set (x := apply l (cut i v)) in *.
    assert (X : 0 <= value f * x * x) by (rewrite Rmult_assoc; apply Rmult_le_pos; [exact F | nra]).
    destruct IH as [Z R]; [intros s S; apply N; right; exact S | lra|]. rewrite Z in H.
    assert (E : value f * x = 0) by nra. split.
    - unfold form_of_squares; cbn [fold_right]. fold (form_of_squares squares v v) x. rewrite Z, E. ring.
    - intros j. unfold row_of_squares; cbn [fold_right]. fold (row_of_squares squares j v) x. rewrite R.
      replace (value f * value (get t (N.of_nat j)) * x) with (value f * x * value (get t (N.of_nat j))) by ring. rewrite E. ring.
  Qed.

  Lemma needs_no_friction_at l k t : needs_no_friction p l = true -> (k < contacts P)%nat -> (1 <= t < d)%nat ->
    of_contact P k (numbers l) t = 0 /\ (friction P k = 0 \/ of_contact P k (motion P (numbers l)) t = 0).
  Proof.
    intros H K T. unfold needs_no_friction in H. rewrite forallb_forall in H.
    set (modes := map (fun _ => Open) (frictions i)).
    assert (I : In (contact_at i modes k) (all_contacts p)) by (apply contact_at_In; [apply map_length | exact K]).
    specialize (H _ I). rewrite forallb_forall in H. specialize (H (N.of_nat t)).
    assert (TI : In (N.of_nat t) (range 1 (N.to_nat (t_dim p - 1)))).
    { apply range_In. change (t_dim p) with (dim i). unfold d, P, problem_of in T; cbn [dimension] in T. lia. }
    specialize (H TI). cbv zeta in H. apply andb_prop in H. destruct H as [Z S].
    apply sign_zero in Z. cbn [center_of] in Z. rewrite (first_at i no_free) in Z, S. rewrite table_of_value in Z.
    rewrite !(component i no_free). split; [exact Z|]. apply orb_prop in S. destruct S as [S|S].
    - left. unfold has_friction in S. apply negb_true_iff, andb_false_iff in S. destruct S as [S|S].
      + apply N.ltb_ge in S. change (t_dim p) with (dim i) in S. unfold d, P, problem_of in T; cbn [dimension] in T. lia.
      + apply negb_false_iff, sign_zero in S. exact S.
    - right. apply sign_zero in S. unfold p in S. rewrite (middle_motion i whole) in S. exact S.
  Qed.

  Theorem frictionless_only l e squares r : check_frictionless p (Exact l e) squares = true ->
    solution P (numbers l) -> solution P r -> forall j, (j < n)%nat -> motion P r j = motion P (numbers l) j.
  Proof.
    intros H SL SR. cbn [check_frictionless] in H. apply andb_prop in H. destruct H as [F H].
    unfold is_sum_of in H. cbv zeta in H. apply andb_prop in H. destruct H as [N H]. set (s := map square_tables squares) in *.
    set (v := fun j => r j - numbers l j).
    assert (W : forall j, (j < n)%nat -> motion P r j - motion P (numbers l) j = row_of_squares s j v).
    { intros j J. assert (E := rest_of_row_sum s j v). rewrite sum_zero in E.
      - unfold motion. fold n. unfold v in E at 1.
        rewrite (sum_ext n _ (fun k => matrix P j k * r k + -1 * (matrix P j k * numbers l k))) in E by (intros; ring).
        rewrite sum_plus, sum_scale in E. lra.
      - intros k K. assert (In_ : forall a, (a < n)%nat -> In (N.of_nat a) (range 0 (N.to_nat (t_size p)))).
        { intros a A. apply range_In. assert (SZ : N.to_nat (t_size p) = n) by exact (size_is i). lia. }
        rewrite forallb_forall in H. specialize (H _ (In_ j J)). rewrite forallb_forall in H.
        rewrite (sign_zero _ (H _ (In_ k K))). ring. }
    assert (Q : form_of_squares s v v <= 0).
    { unfold s. rewrite <- form_by_rows. fold s.
      rewrite (sum_ext n _ (fun j => (r j - numbers l j) * (motion P r j - motion P (numbers l) j))) by (intros; rewrite W by assumption; reflexivity).
      assert (B : 0 <= sum n (fun j => -1 * ((r j - numbers l j) * (motion P r j - motion P (numbers l) j)))); [|rewrite sum_scale in B; lra].
      assert (NS : n = (d * contacts P)%nat).
      { unfold n, size. unfold P at 1. rewrite (no_free_here i no_free). reflexivity. }
      rewrite NS, sum_blocks. apply sum_nonnegative. intros k K. apply sum_nonnegative. intros t T.
      assert (C := changes_oppose d (friction P k) _ _ _ _ (proj1 (friction_is i fine_numbers k K)) (proj2 SL k K) (proj2 SR k K)
        (fun t T => needs_no_friction_at l k t F K T) t T).
      rewrite !(component i no_free) in C. fold P d in C. lra. }
    destruct (squares_vanish s v) as [_ R]; [|exact Q|intros j J; specialize (W j J); rewrite R in W; lra].
    intros a A. unfold s in A. apply in_map_iff in A. destruct A as [b [<- B]]. cbn [square_tables fst].
    rewrite forallb_forall in N. specialize (N _ B). apply andb_prop in N. apply sign_nonnegative, N.
  Qed.
End Instance.
