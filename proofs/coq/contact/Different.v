(** How many of the motions are different, and how far from one of them each is at most: what a program says of all motions. *)
From Coq Require Import NArith Reals List Bool Lra Lia.
From Slipproof.contact Require Import Coulomb Number Fixed Linear Zero Certificate Checker Rows Law Enclose Refute Motions.
From Slipproof.contact Require Import Multipliers Eliminate AllMotions.
Import ListNotations.
Local Open Scope R_scope.

(** The ranges of the velocities of a motion *)
Definition ranges (p : tables) (m : listed) : list interval :=
  let b := box_of_motion p m in
  map (fun j => let w := row p j in Interval (least b w) (greatest b w)) (range 0 (N.to_nat (t_size p))).

Definition apart (x y : list interval) : bool := existsb (fun e => misses_zero (sub_intervals (fst e) (snd e))) (combine x y).

Fixpoint all_apart (l : list (list interval)) : bool :=
  match l with [] => true | x :: r => forallb (apart x) r && all_apart r end.

Definition are_different (i : instance) (eliminated : option (list (N * N * number))) (motions : list listed) : bool :=
  all_apart (map (ranges (tables_of (without_free i eliminated))) motions).

(** Between a motion's velocities and those of others that count as this one *)
Definition reach (p : tables) (m : listed) : number :=
  match vicinity_of m with
  | OnlyThis _ => zero
  | UpTo e =>
      let distances := table_of e in let b := box_of_motion p m in
      List.fold_left (fun s j => let w := row p j in larger s (sub (add (greatest b w) (get distances j)) (least b w)))
        (range 0 (N.to_nat (t_size p))) zero
  end.

Definition greatest_reach (i : instance) (eliminated : option (list (N * N * number))) (motions : list listed) : number :=
  let p := tables_of (without_free i eliminated) in List.fold_left (fun s m => larger s (reach p m)) motions zero.

Lemma larger_all {A} (f : A -> number) l s : value s <= value (List.fold_left (fun s a => larger s (f a)) l s) /\
  forall a, In a l -> value (f a) <= value (List.fold_left (fun s a => larger s (f a)) l s).
Proof.
  revert s. induction l as [|a l IH]; intros s; cbn [List.fold_left]; [split; [lra | intros _ []]|].
  destruct (IH (larger s (f a))) as [B E]. rewrite larger_value in B.
  assert (M := Rmax_l (value s) (value (f a))). assert (M' := Rmax_r (value s) (value (f a))).
  split; [lra|]. intros c [<-|C]; [lra | apply E, C].
Qed.

Lemma all_apart_each l : all_apart l = true -> forall j k x y, (j < k)%nat -> nth_error l j = Some x -> nth_error l k = Some y ->
  apart x y = true.
Proof.
  induction l as [|a l IH]; intros H j k x y L J K; [destruct j; discriminate|].
  cbn [all_apart] in H. apply andb_prop in H. destruct H as [A H]. destruct k as [|k]; [lia|]. cbn in K.
  destruct j as [|j]; cbn in J.
  - inversion J; subst. rewrite forallb_forall in A. apply A. apply nth_error_In with k, K.
  - apply (IH H j k); auto. lia.
Qed.

Section Instance.
  Variables (i : instance) (eliminated : option (list (N * N * number))) (motions : list listed) (tree : list node).
  Hypothesis whole : is_whole i = true.
  Hypothesis fine_numbers : is_proper i = true.
  Hypothesis accepted : check_all_solutions i eliminated motions tree = true.
  Let P := problem_of i.
  Let F := free P.
  Let n := (dimension P * contacts P)%nat.
  Let inverse := match eliminated with Some b => b | None => [] end.
  Let small := reduced i inverse.
  Let p := tables_of small.

  Lemma parts : is_inverse i inverse = true /\ is_whole small = true /\ forallb (check_motion small p) motions = true.
  Proof. assert (H := accepted). unfold check_all_solutions in H. split_and H. repeat split; assumption. Qed.

  (** Velocities of forces in the box are in the ranges. *)
  Lemma in_range m x j : In m motions -> in_box P (listed_of i m) x -> (j < n)%nat ->
    let b := box_of_motion p m in let w := row p (N.of_nat j) in
    value (least b w) <= motion P x (F + j)%nat <= value (greatest b w).
  Proof.
    intros M [Z B] J. destruct parts as [I [W C]]. rewrite forallb_forall in C.
    assert (S := check_motion_box small eq_refl m (C m M)). cbv zeta. fold p in S. set (b := box_of_motion p m) in *.
    assert (MX := motion_of_forces i inverse whole I W x Z j J). fold P F in MX. rewrite MX.
    set (d := fun k : N => if Nat.ltb (N.to_nat k) n then x (F + N.to_nat k)%nat - values (center_of b) k else 0).
    assert (D : within b d).
    { intros k. unfold d. destruct (Nat.ltb_spec (N.to_nat k) n) as [K|K]; [|rewrite Rabs_R0; apply Rabs_pos].
      destruct (S (N.to_nat k) K) as [E1 E2]. rewrite N2Nat.id in E1, E2. rewrite E1, E2. apply (B _ K). }
    assert (L := linear_least b (row p (N.of_nat j)) d eq_refl D). 
    assert (RM := row_motion small W j (fun k => values (center_of b) k + d k)). fold p in RM. rewrite RM in L.
    assert (E : motion (problem_of small) (fun k => values (center_of b) (N.of_nat k) + d (N.of_nat k)) j
      = motion (problem_of small) (fun k => x (F + k)%nat) j).
    { unfold motion. f_equal. apply sum_ext. intros k K. f_equal. unfold d. rewrite Nat2N.id.
      change (size (problem_of small)) with n in K. destruct (Nat.ltb_spec k n); [ring | lia]. }
    rewrite E in L. exact L.
  Qed.

  Lemma ranges_at m j : (j < n)%nat -> nth_error (ranges p m) j
    = Some (Interval (least (box_of_motion p m) (row p (N.of_nat j))) (greatest (box_of_motion p m) (row p (N.of_nat j)))).
  Proof.
    intros J. unfold ranges. cbv zeta. assert (SZ : N.to_nat (t_size p) = n) by exact (size_is small). rewrite SZ.
    rewrite nth_error_map. assert (R : nth_error (range 0 n) j = Some (N.of_nat j)).
    { rewrite (nth_error_nth' _ 0%N) by (rewrite range_length; exact J). rewrite nth_range by exact J. f_equal. }
    rewrite R. reflexivity.
  Qed.

  Lemma apart_differ m m' x y : In m motions -> In m' motions -> in_box P (listed_of i m) x -> in_box P (listed_of i m') y ->
    apart (ranges p m) (ranges p m') = true -> exists j, (j < n)%nat /\ motion P x (F + j)%nat <> motion P y (F + j)%nat.
  Proof.
    intros M M' X Y H. unfold apart in H. apply existsb_exists in H. destruct H as [e [E H]].
    apply (In_nth_error (combine _ _)) in E. destruct E as [j E].
    assert (J : (j < n)%nat).
    { assert (L : (j < length (combine (ranges p m) (ranges p m')))%nat) by (apply nth_error_Some; rewrite E; discriminate).
      rewrite combine_length in L. unfold ranges in L. rewrite !map_length, !range_length in L.
      assert (SZ : N.to_nat (t_size p) = n) by exact (size_is small). lia. }
    exists j. split; [exact J|]. intros Q. assert (X' := in_range m x j M X J). assert (Y' := in_range m' y j M' Y J).
    cbv zeta in X', Y'. rewrite Q in X'.
    assert (EE : e = (nth j (ranges p m) nought, nth j (ranges p m') nought)).
    { apply (nth_error_nth _ _ (nought, nought)) in E. rewrite combine_nth in E; [auto|]. unfold ranges. rewrite !map_length. reflexivity. }
    rewrite (nth_error_nth _ _ nought (ranges_at m j J)), (nth_error_nth _ _ nought (ranges_at m' j J)) in EE. subst e.
    cbn [fst snd] in H. rewrite not_missed in H; [discriminate|].
    assert (C : forall a, a - a = 0) by (intros; ring). rewrite <- (C (motion P y (F + j)%nat)).
    apply contains_sub; [exact X' | exact Y'].
  Qed.

  (** What is said of motions that were accepted: they exist, each solution is within the reach of one of them, and no two of
      them are the same where they are said to be different. *)
  Theorem all_solutions_in_words : exists found : nat -> nat -> R,
    (forall k m, nth_error motions k = Some m -> is_listed P (listed_of i m) (found k)) /\
    (forall x, solution P x -> exists k m, nth_error motions k = Some m /\ forall j, (j < n)%nat ->
      Rabs (motion P x (F + j)%nat - motion P (found k) (F + j)%nat) <= value (greatest_reach i eliminated motions)) /\
    (are_different i eliminated motions = true ->
      forall k l m m', k <> l -> nth_error motions k = Some m -> nth_error motions l = Some m' ->
        exists j, (j < n)%nat /\ motion P (found k) (F + j)%nat <> motion P (found l) (F + j)%nat).
  Proof.
    destruct (check_all_solutions_sound i whole fine_numbers eliminated motions tree accepted) as [found [L A]].
    assert (L' : forall k m, nth_error motions k = Some m -> is_listed P (listed_of i m) (found k)).
    { intros k m M. apply (L k). rewrite nth_error_map, M. reflexivity. }
    exists found. split; [exact L'|]. split.
    - intros x X. destruct (A x X) as [k [lm [M N]]]. rewrite nth_error_map in M.
      destruct (nth_error motions k) as [m|] eqn:E; [|discriminate]. cbn in M. inversion M; subst lm. exists k, m. split; [exact E|].
      intros j J. specialize (N j J). fold P F in N. set (g := value (greatest_reach i eliminated motions)).
      destruct (larger_all (reach p) motions zero) as [G0 G]. rewrite value_zero in G0.
      change (List.fold_left (fun s m => larger s (reach p m)) motions zero) with (greatest_reach i eliminated motions) in G0, G.
      fold g in G0, G. specialize (G m (nth_error_In _ _ E)).
      destruct (distance (listed_of i m)) as [e|] eqn:D.
      + destruct N as [y [Y U]]. assert (IY := in_range m y j (nth_error_In _ _ E) Y J).
        assert (IF := in_range m (found k) j (nth_error_In _ _ E) (proj1 (proj2 (L' k m E))) J). cbv zeta in IY, IF.
        assert (V : exists f, vicinity_of m = UpTo f /\ numbers f j = e j).
        { assert (Zero : numbers [] j = 0) by (unfold numbers; destruct j; apply value_zero).
          destruct m as [l [f|]|modes c r ps ds inv [|f|f]]; cbn [listed_of distance option_map vicinity_of] in *;
            inversion D; subst; eexists; (split; [reflexivity | auto]). }
        destruct V as [f [V FE]]. unfold reach in G. rewrite V in G. cbv zeta in G.
        destruct (larger_all (fun j => sub (add (greatest (box_of_motion p m) (row p j)) (get (table_of f) j))
          (least (box_of_motion p m) (row p j))) (range 0 (N.to_nat (t_size p))) zero) as [_ R].
        assert (RJ : In (N.of_nat j) (range 0 (N.to_nat (t_size p)))).
        { apply range_In. assert (SZ : N.to_nat (t_size p) = n) by exact (size_is small). lia. }
        specialize (R _ RJ). rewrite value_sub, value_add, table_of_value, FE in R.
        apply Rabs_between in U. apply Rabs_le. lra.
      + rewrite N, Rminus_diag_eq, Rabs_R0; [exact G0 | reflexivity].
    - intros H k l m m' KL K L0.
      assert (Each := all_apart_each _ H). change (tables_of (without_free i eliminated)) with p in Each.
      assert (At : forall k m, nth_error motions k = Some m -> nth_error (map (ranges p) motions) k = Some (ranges p m)).
      { intros q a Q. rewrite nth_error_map, Q. reflexivity. }
      destruct (Nat.lt_ge_cases k l) as [Q|Q].
      + apply (apart_differ m m'); try (eapply nth_error_In; eassumption); [apply (L' k m K) | apply (L' l m' L0)|].
        apply (Each k l); auto.
      + destruct (apart_differ m' m (found l) (found k)) as [j [J D]];
          try (eapply nth_error_In; eassumption); [apply (L' l m' L0) | apply (L' k m K) | apply (Each l k); auto; lia|].
        exists j. split; [exact J|]. intros Z. apply D. symmetry. exact Z.
  Qed.
End Instance.
