(** Without the free unknowns the motions are the same (FORMAT.md, `all-solutions`, `eliminated`). *)
From Coq Require Import NArith Reals List Bool Lra Lia FMapPositive.
From Slipproof.contact Require Import Coulomb Number Fixed Linear Zero Certificate Checker Rows Law Enclose Motions.
From Slipproof.contact Require Import Arcs States Multipliers.
Import ListNotations.
Local Open Scope R_scope.

Lemma row_sum_app l k j v : row_sum (l ++ k) j v = row_sum l j v + row_sum k j v.
Proof.
  unfold row_sum. induction l as [|[[a b] x] l IH]; cbn [app fold_right]; [lra|]. rewrite IH. destruct (N.eq_dec a j); lra.
Qed.

Lemma nth_range start count k o : (k < count)%nat -> nth k (range start count) o = (start + N.of_nat k)%N.
Proof.
  revert start k. induction count as [|count IH]; intros start k K; [lia|]. cbn [range]. destruct k as [|k]; cbn [nth]; [lia|].
  rewrite IH by lia. lia.
Qed.

Lemma listed_row_value start count m v : apply (listed_row (range start count) m) v
  = sum count (fun t => value (get m (start + N.of_nat t)%N) * v (start + N.of_nat t)%N).
Proof.
  revert start. induction count as [|count IH]; intros start; [reflexivity|].
  rewrite sum_first, N.add_0_r. unfold listed_row in *. cbn [range map filter].
  rewrite (sum_ext count _ (fun t => value (get m (N.succ start + N.of_nat t)%N) * v (N.succ start + N.of_nat t)%N)), <- IH.
  - destruct (is_zero (snd (start, get m start))) eqn:Z; cbn [negb apply snd] in *; [apply sign_zero in Z; rewrite Z|]; lra.
  - intros t _. replace (start + N.of_nat (S t))%N with (N.succ start + N.of_nat t)%N by lia. reflexivity.
Qed.

Lemma listed_row_keys columns m e : In e (listed_row columns m) -> In (fst e) columns.
Proof.
  intros I. apply filter_In in I. destruct I as [I _]. apply in_map_iff in I. destruct I as [j [<- J]]. exact J.
Qed.

Lemma range_length start count : length (range start count) = count.
Proof. revert start. induction count as [|count IH]; intros start; [reflexivity | cbn; f_equal; apply IH]. Qed.

Lemma look_range {A} (o : A) (f : N -> A) count j : (N.to_nat j < count)%nat ->
  look o (tabulate 0 (map f (range 0 count)) (PositiveMap.empty A)) j = f j.
Proof.
  intros J. rewrite look_list.
  rewrite (nth_indep _ o (f 0%N)) by (rewrite map_length, range_length; exact J).
  rewrite map_nth, nth_range by exact J. f_equal. lia.
Qed.

Lemma coulomb_ext d m r u r' u' : (1 <= d)%nat -> (forall t, (t < d)%nat -> r t = r' t /\ u t = u' t) ->
  coulomb d m r u -> coulomb d m r' u'.
Proof.
  intros D E [A B C K O]. assert (R0 := proj1 (E 0%nat ltac:(lia))). assert (U0 := proj2 (E 0%nat ltac:(lia))).
  assert (TR : tangential d r = tangential d r').
  { unfold tangential. f_equal. apply sum_ext. intros t T. rewrite (proj1 (E (S t) ltac:(lia))). reflexivity. }
  assert (TU : tangential d u = tangential d u').
  { unfold tangential. f_equal. apply sum_ext. intros t T. rewrite (proj2 (E (S t) ltac:(lia))). reflexivity. }
  rewrite R0, U0 in *. split; auto; [rewrite <- TR; exact K|].
  intros t T. rewrite <- TU, <- (proj1 (E t ltac:(lia))), <- (proj2 (E t ltac:(lia))). apply O, T.
Qed.

Section Instance.
  Variables (i : instance) (inverse : list (N * N * number)).
  Hypothesis whole : is_whole i = true.
  Hypothesis inverts : is_inverse i inverse = true.
  Let small := reduced i inverse.
  Hypothesis whole_small : is_whole small = true.
  Let p := tables_of i.
  Let P := problem_of i.
  Let Q := problem_of small.
  Let n := size P.
  Let F := free P.
  Let b := by_rows inverse.
  Let free_rows := range 0 (N.to_nat (frees i)).
  Let forces := range (frees i) (N.to_nat (size_of_instance i - frees i)).
  Let solved := tabulate 0 (map (fun j => listed_row forces (solved_row p b j)) free_rows) (PositiveMap.empty linear).
  Let solved_constants := tabulate 0 (map (solved_constant p b) free_rows) empty.
  Let row_of (j : N) : linear := look [] (t_rows p) j.

  Lemma size_small : size Q = (dimension P * contacts P)%nat.
  Proof. reflexivity. Qed.

  Lemma sizes : n = (F + size Q)%nat.
  Proof. reflexivity. Qed.

  Lemma forces_range : forces = range (N.of_nat F) (size Q).
  Proof.
    unfold forces. rewrite size_small. unfold F, P, size_of_instance, problem_of; cbn [free dimension contacts]. rewrite N2Nat.id. f_equal. lia.
  Qed.

  (** B y = 0 for y = 0 *)
  Lemma inverse_zero j y : (forall l, (N.to_nat l < F)%nat -> y l = 0) -> apply (look [] b j) y = 0.
  Proof.
    intros Z. unfold b. rewrite by_rows_value. assert (H := inverts). unfold is_inverse in H. apply andb_prop in H.
    destruct H as [H _]. revert H. unfold row_sum. generalize inverse as rows.
    induction rows as [|[[k l] a] r IH]; intros H; [reflexivity|]. cbn [fold_right].
    cbn [forallb] in H. apply andb_prop in H. destruct H as [L H]. rewrite (IH H). apply N.ltb_lt in L.
    rewrite Z by (unfold F, P, problem_of; cbn [free]; lia). destruct (N.eq_dec k j); lra.
  Qed.

  Definition solved_list (j : N) : linear := listed_row (range (N.of_nat F) (size Q)) (solved_row p b j).

  (** B A x *)
  Lemma solved_sum j x : (N.to_nat j < F)%nat ->
    apply (look [] b j) (fun l => apply (row_of l) (cut i x)) = x (N.to_nat j) + apply (solved_list j) (cut i x).
  Proof.
    intros J.
    assert (G : sum n (fun k => value (get (solved_row p b j) (N.of_nat k)) * x k)
      = apply (look [] b j) (fun l => apply (row_of l) (cut i x))).
    { unfold solved_row. fold b p.
      assert (G : forall l m, sum n (fun k => value (get (List.fold_left
          (fun m e => accumulate m (snd e) (look [] (t_rows p) (fst e))) l m) (N.of_nat k)) * x k)
        = sum n (fun k => value (get m (N.of_nat k)) * x k) + apply l (fun e => apply (row_of e) (cut i x))).
      { induction l as [|[e a] l IH]; intros m; cbn [List.fold_left apply fst snd]; [lra|].
        rewrite IH. unfold n, P. rewrite accumulated. unfold row_of. lra. }
      rewrite G, sum_zero; [lra|]. intros k _. rewrite get_empty, value_zero. ring. }
    rewrite <- G. rewrite sizes, sum_split.
    rewrite (sum_ext F _ (fun k => (if Nat.eq_dec k (N.to_nat j) then 1 else 0) * x k)).
    - rewrite (sum_single F (N.to_nat j)); [|exact J | intros k _ K; destruct (Nat.eq_dec k (N.to_nat j)); [contradiction | ring]].
      destruct (Nat.eq_dec (N.to_nat j) (N.to_nat j)); [|contradiction]. rewrite Rmult_1_l. f_equal.
      unfold solved_list. rewrite listed_row_value. apply sum_ext. intros t T.
      replace (N.of_nat F + N.of_nat t)%N with (N.of_nat (F + t)) by lia.
      rewrite cut_at; [reflexivity|]. fold P n. rewrite sizes. lia.
    - intros k K. f_equal. assert (H := inverts). unfold is_inverse in H. apply andb_prop in H. destruct H as [_ H].
      rewrite forallb_forall in H. specialize (H j). cbv zeta in H. rewrite forallb_forall in H.
      unfold F, P, problem_of in J, K; cbn [free] in J, K.
      specialize (H ltac:(apply range_In; lia) (N.of_nat k) ltac:(apply range_In; lia)). apply eq_value in H. fold p b in H. rewrite H.
      destruct (N.eqb_spec j (N.of_nat k)), (Nat.eq_dec k (N.to_nat j)); try lia; [apply value_one | apply value_zero].
  Qed.

  Lemma solved_constant_value j : value (solved_constant p b j) = apply (look [] b j) (fun l => constant P (N.to_nat l)).
  Proof.
    unfold solved_constant. rewrite sum_of_value. apply apply_ext. intros l. unfold values.
    rewrite <- (row_constant i), N2Nat.id. reflexivity.
  Qed.

  Lemma row_motion_is l x : motion P x (N.to_nat l) = apply (row_of l) (cut i x) + constant P (N.to_nat l).
  Proof.
    unfold motion. f_equal. assert (R := row_linear i whole (N.to_nat l) (cut i x)). rewrite N2Nat.id in R.
    unfold row_of, p. rewrite R. apply sum_ext. intros k K. rewrite cut_at by exact K. reflexivity.
  Qed.

  (** B (A x + c) *)
  Lemma solved_motion j x : (N.to_nat j < F)%nat ->
    apply (look [] b j) (fun l => motion P x (N.to_nat l))
    = x (N.to_nat j) + apply (solved_list j) (cut i x) + value (solved_constant p b j).
  Proof.
    intros J. rewrite (apply_ext _ _ _ (fun l => row_motion_is l x)), apply_plus, solved_sum by exact J.
    rewrite solved_constant_value. reflexivity.
  Qed.

  (** A row of a contact, with the free unknowns eliminated *)
  Lemma reduced_sum j x :
    (forall k, (N.to_nat k < F)%nat -> x (N.to_nat k) + apply (solved_list k) (cut i x) + value (solved_constant p b k) = 0) ->
    apply (row_of j) (cut i x) + constant P (N.to_nat j)
    = apply (reduced_row p forces solved j) (cut i x) + value (reduced_constant p solved_constants j).
  Proof.
    intros Z. set (x' := fun k => if Nat.ltb k F then 0 else x k).
    assert (Forces : forall m, apply (listed_row (range (N.of_nat F) (size Q)) m) (cut i x)
      = sum n (fun k => value (get m (N.of_nat k)) * x' k)).
    { intros m. rewrite listed_row_value, sizes, sum_split, (sum_zero F).
      - rewrite Rplus_0_l. apply sum_ext. intros t T. replace (N.of_nat F + N.of_nat t)%N with (N.of_nat (F + t)) by lia.
        rewrite cut_at by (fold P n; rewrite sizes; lia). unfold x'. destruct (Nat.ltb_spec (F + t) F); [lia | reflexivity].
      - intros k K. unfold x'. destruct (Nat.ltb_spec k F); [ring | lia]. }
    assert (Cut : forall k, cut i x' k = if Nat.ltb (N.to_nat k) F then 0 else cut i x k).
    { intros k. unfold cut, x'. destruct (Nat.ltb_spec (N.to_nat k) F), (Nat.ltb_spec (N.to_nat k) (size (problem_of i))); reflexivity. }
    assert (Same : forall k, apply (solved_list k) (cut i x') = apply (solved_list k) (cut i x)).
    { intros k. apply apply_ext_in. intros e E. apply listed_row_keys, range_In in E. rewrite Cut.
      destruct (Nat.ltb_spec (N.to_nat (fst e)) F); [lia | reflexivity]. }
    unfold reduced_row. rewrite forces_range, Forces.
    assert (Solved : forall k, (N.to_nat k < F)%nat -> look [] solved k = solved_list k).
    { intros k K. unfold solved_list. rewrite <- forces_range.
      apply (look_range [] (fun j => listed_row forces (solved_row p b j))). exact K. }
    change (t_frees p) with (frees i). change (look [] (t_rows p) j) with (row_of j).
    assert (G : forall l m, sum n (fun k => value (get (List.fold_left (fun m e =>
          if N.ltb (fst e) (frees i) then accumulate m (opp (snd e)) (look [] solved (fst e)) else accumulate m one [e])
          l m) (N.of_nat k)) * x' k)
      = sum n (fun k => value (get m (N.of_nat k)) * x' k)
        + apply l (fun k => if N.ltb k (frees i) then - apply (solved_list k) (cut i x) else cut i x k)).
    { induction l as [|[k a] l IH]; intros m; cbn [List.fold_left apply fst snd]; [lra|]. rewrite IH.
      destruct (N.ltb_spec k (frees i)) as [K|K].
      - assert (K' : (N.to_nat k < F)%nat) by (unfold F, P, problem_of; cbn [free]; lia).
        unfold n, P. rewrite accumulated, value_opp, (Solved k K'), Same. lra.
      - unfold n, P. rewrite accumulated, value_one. cbn [apply]. rewrite Cut.
        destruct (Nat.ltb_spec (N.to_nat k) F) as [K'|_]; [unfold F, P, problem_of in K'; cbn [free] in K'; lia | lra]. }
    rewrite G, sum_zero by (intros; rewrite get_empty, value_zero; ring). rewrite Rplus_0_l.
    unfold reduced_constant. change (t_frees p) with (frees i).
    change (look [] (t_rows p) j) with (row_of j).
    assert (Constants : forall k, (N.to_nat k < F)%nat -> get solved_constants k = solved_constant p b k).
    { intros k K. unfold solved_constants, free_rows. apply (look_range zero). exact K. }
    assert (C : forall l s, value (List.fold_left (fun s e =>
          if N.ltb (fst e) (frees i) then sub s (mul (snd e) (get solved_constants (fst e))) else s) l s)
      = value s - apply l (fun k => if N.ltb k (frees i) then value (solved_constant p b k) else 0)).
    { induction l as [|[k a] l IH]; intros s; cbn [List.fold_left apply fst snd]; [lra|]. rewrite IH.
      destruct (N.ltb_spec k (frees i)) as [K|K]; [|lra].
      rewrite value_sub, value_mul, Constants by (unfold F, P, problem_of; cbn [free]; lia). lra. }
    rewrite C. replace (value (get (t_constants p) j)) with (constant P (N.to_nat j))
      by (rewrite <- (row_constant i), N2Nat.id; reflexivity).
    enough (E : apply (row_of j) (cut i x)
      = apply (row_of j) (fun k => (if N.ltb k (frees i) then - apply (solved_list k) (cut i x) else cut i x k)
          + -1 * (if N.ltb k (frees i) then value (solved_constant p b k) else 0))).
    { rewrite E, apply_plus, apply_scale. lra. }
    apply apply_ext. intros k. destruct (N.ltb_spec k (frees i)) as [K|K]; [|lra].
    assert (K' : (N.to_nat k < F)%nat) by (unfold F, P, problem_of; cbn [free]; lia). specialize (Z k K').
    assert (X : cut i x k = x (N.to_nat k)).
    { unfold cut. destruct (Nat.ltb_spec (N.to_nat k) (size (problem_of i))) as [_|L]; [reflexivity|].
      fold P n in L. rewrite sizes in L. lia. }
    rewrite X. lra.
  Qed.

  Lemma reduced_motion r k : (k < size Q)%nat -> motion Q r k
    = apply (reduced_row p forces solved (N.of_nat (F + k))) (fun e => r (N.to_nat e - F)%nat)
      + value (reduced_constant p solved_constants (N.of_nat (F + k))).
  Proof.
    intros K. unfold motion. f_equal.
    - transitivity (apply (look [] (t_rows (tables_of small)) (N.of_nat k)) (fun e => r (N.to_nat e))).
      { rewrite (row_linear small whole_small). apply sum_ext. intros j _. rewrite Nat2N.id. reflexivity. }
      unfold tables_of; cbn [t_rows]. rewrite by_rows_value.
      change (entries small) with (flat_map (fun j => map (fun e => ((j - frees i)%N, (fst e - frees i)%N, snd e))
        (reduced_row p forces solved j)) forces). set (rows := reduced_row p forces solved). rewrite forces_range.
      assert (Keys : forall j e, In e (rows j) -> (F <= N.to_nat (fst e))%nat).
      { intros j e E. unfold rows, reduced_row in E. rewrite forces_range in E. apply listed_row_keys, range_In in E. lia. }
      assert (One : forall j l, (forall e, In e l -> (F <= N.to_nat (fst e))%nat) ->
        row_sum (map (fun e => ((j - frees i)%N, (fst e - frees i)%N, snd e)) l) (N.of_nat k) (fun e => r (N.to_nat e))
        = if N.eq_dec (j - frees i) (N.of_nat k) then apply l (fun e => r (N.to_nat e - F)%nat) else 0).
      { intros j l L. induction l as [|[e a] l IH]; [cbn; destruct (N.eq_dec _ _); reflexivity|].
        cbn [map fst snd]. unfold row_sum in *. cbn [fold_right]. rewrite IH by (intros; apply L; right; assumption).
        destruct (N.eq_dec _ _); [|reflexivity]. cbn [apply]. f_equal. f_equal. f_equal.
        unfold F, P, problem_of; cbn [free]. lia. }
      assert (G : forall count start, (F <= N.to_nat start)%nat ->
        row_sum (flat_map (fun j => map (fun e => ((j - frees i)%N, (fst e - frees i)%N, snd e)) (rows j)) (range start count))
          (N.of_nat k) (fun e => r (N.to_nat e))
        = if (Nat.leb (N.to_nat start) (F + k) && Nat.ltb (F + k) (N.to_nat start + count))%bool
          then apply (rows (N.of_nat (F + k))) (fun e => r (N.to_nat e - F)%nat) else 0).
      { induction count as [|count IH]; intros start B.
        - unfold row_sum; cbn [range flat_map fold_right].
          destruct (Nat.leb_spec (N.to_nat start) (F + k)), (Nat.ltb_spec (F + k) (N.to_nat start + 0)); cbn; reflexivity || (exfalso; lia).
        - cbn [range flat_map]. rewrite row_sum_app, One, IH by (try apply Keys; lia).
          assert (FI : N.to_nat (frees i) = F) by reflexivity.
          destruct (N.eq_dec (start - frees i) (N.of_nat k)) as [E|E].
          + assert (J : start = N.of_nat (F + k)) by lia. rewrite <- J.
            destruct (Nat.leb_spec (N.to_nat (N.succ start)) (F + k)), (Nat.leb_spec (N.to_nat start) (F + k)),
              (Nat.ltb_spec (F + k) (N.to_nat start + S count)); cbn [andb]; try (exfalso; lia); lra.
          + destruct (Nat.leb_spec (N.to_nat (N.succ start)) (F + k)), (Nat.leb_spec (N.to_nat start) (F + k)),
              (Nat.ltb_spec (F + k) (N.to_nat start + S count)), (Nat.ltb_spec (F + k) (N.to_nat (N.succ start) + count));
              cbn [andb]; try (exfalso; lia); lra. }
      rewrite G by lia. rewrite Nat2N.id.
      destruct (Nat.leb_spec F (F + k)), (Nat.ltb_spec (F + k) (F + size Q)); cbn [andb]; reflexivity || (exfalso; lia).
    - change (constant Q k) with (numbers (map (reduced_constant p solved_constants) forces) k). unfold numbers. rewrite forces_range.
      rewrite (nth_indep _ zero (reduced_constant p solved_constants 0%N)).
      + rewrite map_nth, nth_range by exact K. do 2 f_equal. lia.
      + rewrite map_length, range_length. exact K.
  Qed.

  Lemma reduced_agrees x k : (k < size Q)%nat ->
    (forall l, (N.to_nat l < F)%nat -> x (N.to_nat l) + apply (solved_list l) (cut i x) + value (solved_constant p b l) = 0) ->
    motion P x (F + k)%nat = motion Q (fun j => x (F + j)%nat) k.
  Proof.
    intros K Z. rewrite (reduced_motion _ k K), <- (Nat2N.id (F + k)), row_motion_is, (reduced_sum _ x Z), Nat2N.id. f_equal.
    apply apply_ext_in. intros e E. unfold reduced_row in E. rewrite forces_range in E. apply listed_row_keys, range_In in E.
    unfold cut. fold P n. destruct (Nat.ltb_spec (N.to_nat (fst e)) n) as [_|L]; [|rewrite sizes in L; lia].
    f_equal. lia.
  Qed.

  (** With rows of free unknowns 0, the velocities are those of the forces. *)
  Lemma motion_of_forces x : (forall l, (l < F)%nat -> motion P x l = 0) ->
    forall k, (k < size Q)%nat -> motion P x (F + k)%nat = motion Q (fun j => x (F + j)%nat) k.
  Proof.
    intros Z k K. apply reduced_agrees; [exact K|]. intros l L. rewrite <- solved_motion by exact L.
    apply inverse_zero. intros e E. apply Z, E.
  Qed.

  (** For all forces there are free unknowns, by which their rows are 0. *)
  Lemma with_free r : exists x, (forall l, (l < F)%nat -> motion P x l = 0) /\ forall k, x (F + k)%nat = r k.
  Proof.
    set (only := fun k => if Nat.ltb k F then 0 else r (k - F)%nat).
    set (x := fun k => if Nat.ltb k F
      then - apply (solved_list (N.of_nat k)) (cut i only) - value (solved_constant p b (N.of_nat k)) else r (k - F)%nat).
    assert (Z : forall l, (N.to_nat l < F)%nat ->
      x (N.to_nat l) + apply (solved_list l) (cut i x) + value (solved_constant p b l) = 0).
    { intros l L. unfold x at 1. destruct (Nat.ltb_spec (N.to_nat l) F); [|lia]. rewrite N2Nat.id.
      assert (E : apply (solved_list l) (cut i x) = apply (solved_list l) (cut i only)); [|lra].
      apply apply_ext_in. intros e E. apply listed_row_keys, range_In in E. unfold cut, x, only.
      destruct (Nat.ltb_spec (N.to_nat (fst e)) F); [lia | reflexivity]. }
    exists x. split.
    2: { intros k. unfold x. destruct (Nat.ltb_spec (F + k) F); [lia|]. f_equal. lia. }
    set (y := motion P x). assert (BY : forall l, (N.to_nat l < F)%nat -> apply (look [] b l) (fun e => y (N.to_nat e)) = 0).
    { intros l L. unfold y. rewrite solved_motion by exact L. apply Z, L. }
    destruct (dependent F (fun l k => if Nat.eq_dec k F then y l else matrix P l k)) as [z [[k [K N]] E]].
    set (c := fun k => if Nat.ltb k F then z k else 0).
    assert (E' : forall l, (l < F)%nat -> apply (row_of (N.of_nat l)) (cut i c) + z F * y l = 0).
    { intros l L. rewrite <- (E l L). cbn [sum]. destruct (Nat.eq_dec F F); [|contradiction]. rewrite (Rmult_comm (y l)). f_equal.
      unfold row_of, p. rewrite (row_linear i whole). fold P n. rewrite sizes, sum_split, (sum_zero (size Q)), Rplus_0_r.
      - apply sum_ext. intros j J. destruct (Nat.eq_dec j F); [lia|]. rewrite cut_at by (fold P n; rewrite sizes; lia).
        unfold c. destruct (Nat.ltb_spec j F); [reflexivity | lia].
      - intros j J. rewrite cut_at by (fold P n; rewrite sizes; lia). unfold c. destruct (Nat.ltb_spec (F + j) F); [lia | ring]. }
    assert (C0 : forall l, (l < F)%nat -> z l = 0).
    { intros l L. assert (J : (N.to_nat (N.of_nat l) < F)%nat) by lia.
      assert (A : apply (look [] b (N.of_nat l)) (fun e => apply (row_of e) (cut i c) + z F * y (N.to_nat e)) = 0).
      { apply inverse_zero. intros e L'. rewrite <- (N2Nat.id e) at 1. apply E', L'. }
      rewrite apply_plus, apply_scale, (BY _ J), (solved_sum _ c J) in A.
      assert (S : apply (solved_list (N.of_nat l)) (cut i c) = 0).
      { rewrite (apply_ext_in _ _ (fun _ => 0)); [apply apply_zero; reflexivity|]. intros e I.
        apply listed_row_keys, range_In in I. unfold cut, c. destruct (Nat.ltb_spec (N.to_nat (fst e)) F); [lia|].
        destruct (Nat.ltb_spec (N.to_nat (fst e)) (size (problem_of i))); reflexivity. }
      rewrite S, Nat2N.id in A. unfold c in A. destruct (Nat.ltb_spec l F); [lra | lia]. }
    assert (ZF : z F <> 0).
    { destruct (Nat.eq_dec k F) as [<-|D]; [exact N|]. exfalso. apply N, C0. lia. }
    intros l L. fold (y l). specialize (E' l L).
    assert (S : apply (row_of (N.of_nat l)) (cut i c) = 0).
    { apply apply_zero. intros e. unfold cut, c. destruct (Nat.ltb_spec (N.to_nat e) F) as [J|J];
        destruct (Nat.ltb_spec (N.to_nat e) (size (problem_of i))); try reflexivity. apply C0, J. }
    rewrite S, Rplus_0_l in E'. apply Rmult_integral in E'. destruct E'; [contradiction | assumption].
  Qed.

  (** The components of a contact's force and velocity are the same. *)
  Lemma same_contact x k t : (forall l, (l < F)%nat -> motion P x l = 0) -> (k < contacts P)%nat -> (t < dimension P)%nat ->
    of_contact P k x t = of_contact Q k (fun j => x (F + j)%nat) t /\
    of_contact P k (motion P x) t = of_contact Q k (motion Q (fun j => x (F + j)%nat)) t.
  Proof.
    intros Z K T. unfold of_contact. change (free Q) with 0%nat. change (dimension Q) with (dimension P). cbn [Nat.add].
    fold F. rewrite <- Nat.add_assoc. split; [reflexivity|]. apply motion_of_forces; [exact Z|]. rewrite size_small. nia.
  Qed.

  Hypothesis dimension_fine : (1 <= dimension P)%nat.

  Lemma solution_without_free x : solution P x -> solution Q (fun j => x (F + j)%nat).
  Proof.
    intros [Z L]. split; [intros l L'; inversion L'|]. intros k K.
    apply (coulomb_ext _ _ (of_contact P k x) (of_contact P k (motion P x))); [exact dimension_fine | | apply L, K].
    intros t T. apply same_contact; assumption.
  Qed.

  Lemma solution_with_free x : (forall l, (l < F)%nat -> motion P x l = 0) -> solution Q (fun j => x (F + j)%nat) -> solution P x.
  Proof.
    intros Z [_ L]. split; [exact Z|]. intros k K.
    apply (coulomb_ext _ _ (of_contact Q k (fun j => x (F + j)%nat)) (of_contact Q k (motion Q (fun j => x (F + j)%nat))));
      [exact dimension_fine | | apply L, K].
    intros t T. destruct (same_contact x k t Z K T) as [-> ->]. split; reflexivity.
  Qed.
End Instance.
