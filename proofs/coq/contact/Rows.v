(** The tables have the numbers of the problem. *)
From Coq Require Import NArith ZArith Reals List Bool Lra Lia FMapPositive.
From Slipproof.contact Require Import Coulomb Number Fixed Linear Zero Certificate Checker.
Import ListNotations.
Local Open Scope R_scope.

Ltac split_and H :=
  cbv zeta in H; repeat match type of H with
  | (_ && _)%bool = true => let A := fresh "H" in apply andb_prop in H; destruct H as [H A]
  end.

Definition row_sum (l : list (N * N * number)) (i : N) (v : vector) : R :=
  fold_right (fun e s => match e with (k, j, a) => if N.eq_dec k i then value a * v j + s else s end) 0 l.

Lemma by_rows_value l i v : apply (look [] (by_rows l) i) v = row_sum l i v.
Proof.
  unfold by_rows.
  assert (G : forall m, apply (look [] (List.fold_left
      (fun m e => match e with (i, j, a) => PositiveMap.add (key i) ((j, a) :: look [] m i) m end) l m) i) v
    = apply (look [] m i) v + row_sum l i v).
  { unfold row_sum. induction l as [|[[k j] a] l IH]; intros m; cbn [List.fold_left fold_right]; [lra|].
    rewrite IH, look_add. destruct (N.eq_dec i k) as [->|D].
    - destruct (N.eq_dec k k); [cbn; lra | contradiction].
    - destruct (N.eq_dec k i); [congruence | reflexivity]. }
  rewrite G, look_empty. cbn. lra.
Qed.

Lemma row_sum_entries n l k v :
  Forall (fun e => match e with (_, m, _) => (N.to_nat m < n)%nat end) l ->
  row_sum l (N.of_nat k) v = sum n (fun j => entry l k j * v (N.of_nat j)).
Proof.
  induction 1 as [|[[r m] a] l B _ IH].
  - cbn. rewrite sum_zero; [reflexivity|]. intros; lra.
  - assert (E : forall j, entry ((r, m, a) :: l) k j
        = (if (Nat.eqb (N.to_nat r) k && Nat.eqb (N.to_nat m) j)%bool then value a else 0) + entry l k j).
    { intros j. unfold entry. cbn [fold_right]. destruct (Nat.eqb (N.to_nat r) k && _)%bool; lra. }
    rewrite (sum_ext _ _ (fun j => (if (Nat.eqb (N.to_nat r) k && Nat.eqb (N.to_nat m) j)%bool then value a else 0)
      * v (N.of_nat j) + entry l k j * v (N.of_nat j))) by (intros; rewrite E; ring).
    rewrite sum_plus, <- IH. unfold row_sum. cbn [fold_right]. destruct (N.eq_dec r (N.of_nat k)) as [->|D].
    + f_equal. rewrite (sum_single _ (N.to_nat m)); [|exact B|].
      * rewrite Nat2N.id, !Nat.eqb_refl, N2Nat.id. reflexivity.
      * intros j _ D. destruct (Nat.eqb_spec (N.to_nat m) j); [congruence|]. rewrite andb_false_r. ring.
    + rewrite sum_zero; [lra|]. intros j _. destruct (Nat.eqb_spec (N.to_nat r) k); [|cbn; ring].
      exfalso. apply D. subst. symmetry. apply N2Nat.id.
Qed.

Section Instance.
  Variable i : instance.
  Hypothesis whole : is_whole i = true.
  Let p := tables_of i.
  Let P := problem_of i.

  Lemma size_is : N.to_nat (t_size p) = size P.
  Proof. unfold p, P, tables_of, problem_of, size_of_instance, size; cbn. rewrite N2Nat.inj_add, N2Nat.inj_mul, Nat2N.id. reflexivity. Qed.

  Lemma columns : Forall (fun e => match e with (_, m, _) => (N.to_nat m < size P)%nat end) (entries i).
  Proof.
    assert (W := whole). unfold is_whole in W. split_and W. apply Forall_forall. intros [[k m] a] I.
    rewrite forallb_forall in H0. specialize (H0 _ I). cbn in H0. apply andb_prop in H0. destruct H0 as [_ L].
    apply N.ltb_lt in L. rewrite <- size_is. unfold p, tables_of; cbn. lia.
  Qed.

  Lemma row_linear k v : apply (look [] (t_rows p) (N.of_nat k)) v = sum (size P) (fun j => matrix P k j * v (N.of_nat j)).
  Proof. unfold p, tables_of; cbn [t_rows]. rewrite by_rows_value. apply row_sum_entries, columns. Qed.

  Lemma row_constant k : value (get (t_constants p) (N.of_nat k)) = constant P k.
  Proof. unfold p, tables_of, table_of, get, empty; cbn [t_constants]. rewrite look_list, Nat2N.id. reflexivity. Qed.

  Lemma row_motion k v : eval (row p (N.of_nat k)) v = motion P (fun j => v (N.of_nat j)) k.
  Proof.
    unfold eval, row, motion; cbn [constant_part linear_part quadratic_part products].
    rewrite row_linear, row_constant. lra.
  Qed.

  Lemma table_of_value l k : value (get (table_of l) (N.of_nat k)) = numbers l k.
  Proof. unfold table_of, get, empty. rewrite look_list, Nat2N.id. reflexivity. Qed.
End Instance.

Lemma whole_complete i : is_whole i = true -> complete i.
Proof.
  intros W. assert (S := size_is i). unfold is_whole in W. split_and W.
  change (size_of_instance i) with (t_size (tables_of i)) in *. apply N.eqb_eq in W.
  split; [lia|]. split; [|split].
  - intros x E. rewrite E in H1. apply N.eqb_eq in H1. lia.
  - intros k m a I. rewrite forallb_forall in H0. specialize (H0 _ I). cbv beta iota in H0.
    apply andb_prop in H0. destruct H0 as [A B]. apply N.ltb_lt in A. apply N.ltb_lt in B. lia.
  - apply distinct_NoDup in H. apply (NoDup_map_inv (fun e => fst e * t_size (tables_of i) + snd e)%N).
    rewrite map_map. erewrite map_ext; [exact H|]. intros [[k m] a]. reflexivity.
Qed.

(** The sizes of a row's coefficients. *)
Lemma apply_abs_by_rows l i v : apply_abs (look [] (by_rows l) i) v
  = fold_right (fun e s => match e with (k, j, a) => if N.eq_dec k i then Rabs (value a) * v j + s else s end) 0 l.
Proof.
  unfold by_rows.
  assert (G : forall m, apply_abs (look [] (List.fold_left
      (fun m e => match e with (i, j, a) => PositiveMap.add (key i) ((j, a) :: look [] m i) m end) l m) i) v
    = apply_abs (look [] m i) v + fold_right (fun e s =>
        match e with (k, j, a) => if N.eq_dec k i then Rabs (value a) * v j + s else s end) 0 l).
  { induction l as [|[[k j] a] l IH]; intros m; cbn [List.fold_left fold_right]; [lra|].
    rewrite IH, look_add. destruct (N.eq_dec i k) as [->|D].
    - destruct (N.eq_dec k k); [cbn; lra | contradiction].
    - destruct (N.eq_dec k i); [congruence | reflexivity]. }
  rewrite G, look_empty. cbn. lra.
Qed.

Lemma entry_absent l i j : ~ In (N.of_nat i, N.of_nat j) (map fst l) -> entry l i j = 0.
Proof.
  induction l as [|[[k m] a] l IH]; intros A; [reflexivity|]. unfold entry in *. cbn [fold_right map fst] in *.
  rewrite IH by (intros I; apply A; right; exact I).
  destruct (Nat.eqb_spec (N.to_nat k) i), (Nat.eqb_spec (N.to_nat m) j); try reflexivity.
  exfalso. apply A. left. f_equal; lia.
Qed.

Lemma row_sizes i k v : is_whole i = true -> apply_abs (look [] (t_rows (tables_of i)) (N.of_nat k)) v
  = sum (size (problem_of i)) (fun j => Rabs (matrix (problem_of i) k j) * v (N.of_nat j)).
Proof.
  intros W. destruct (whole_complete i W) as [_ [_ [C ND]]]. set (n := size (problem_of i)) in *.
  change (matrix (problem_of i)) with (entry (entries i)). unfold tables_of; cbn [t_rows].
  rewrite apply_abs_by_rows. revert C ND. generalize (entries i) as l.
  induction l as [|[[r m] a] l IH]; intros C ND.
  - cbn. rewrite sum_zero; [reflexivity|]. intros j _. rewrite Rabs_R0. ring.
  - cbn [map fst] in ND. inversion ND as [|? ? A ND']; subst. cbn [fold_right].
    rewrite IH by (try exact ND'; intros k' m' a' I; apply (C k' m' a'); right; exact I).
    assert (M := proj2 (C r m a (or_introl eq_refl))).
    destruct (N.eq_dec r (N.of_nat k)) as [->|D].
    + rewrite (sum_ext n (fun j => Rabs (entry ((N.of_nat k, m, a) :: l) k j) * v (N.of_nat j))
        (fun j => (if Nat.eqb (N.to_nat m) j then Rabs (value a) else 0) * v (N.of_nat j) + Rabs (entry l k j) * v (N.of_nat j))).
      * rewrite sum_plus.
        rewrite (sum_single n (N.to_nat m) (fun j => (if Nat.eqb (N.to_nat m) j then Rabs (value a) else 0) * v (N.of_nat j)));
          [|exact M|].
        -- rewrite Nat.eqb_refl, N2Nat.id. reflexivity.
        -- intros j _ J. destruct (Nat.eqb_spec (N.to_nat m) j); [congruence | ring].
      * intros j _. unfold entry at 1. cbn [fold_right]. fold (entry l k j). rewrite Nat2N.id, Nat.eqb_refl. cbn [andb].
        destruct (Nat.eqb_spec (N.to_nat m) j) as [<-|J]; [|ring].
        rewrite entry_absent by (rewrite N2Nat.id; exact A). rewrite Rplus_0_r, Rabs_R0. ring.
    + apply sum_ext. intros j _. unfold entry at 2. cbn [fold_right]. fold (entry l k j).
      destruct (Nat.eqb_spec (N.to_nat r) k); [lia | reflexivity].
Qed.

(** The contacts in the tables are those of the problem. *)
Lemma layout_In d at_ slip_ mus modes k :
  length modes = length mus -> (k < length mus)%nat ->
  In (Contact (at_ + d * N.of_nat k) (slip_ + N.of_nat k) (nth k mus zero) (nth k modes Open)) (layout d at_ slip_ mus modes).
Proof.
  revert at_ slip_ modes k. induction mus as [|m mus IH]; intros at_ slip_ [|s modes] k L K; cbn in *; try lia.
  destruct k as [|k].
  - left. f_equal; lia.
  - right. specialize (IH (at_ + d)%N (N.succ slip_) modes k ltac:(lia) ltac:(lia)).
    replace (at_ + d * N.of_nat (S k))%N with (at_ + d + d * N.of_nat k)%N by lia.
    replace (slip_ + N.of_nat (S k))%N with (N.succ slip_ + N.of_nat k)%N by lia. exact IH.
Qed.

Lemma range_In i n j : In j (range i n) <-> (i <= j < i + N.of_nat n)%N.
Proof.
  revert i. induction n as [|n IH]; intros i; cbn [range In].
  - split; [intros [] | lia].
  - rewrite IH. split; [intros [<-|H]; lia|]. intros H. destruct (N.eq_dec i j); [left; assumption | right; lia].
Qed.

Lemma range_NoDup i n : NoDup (range i n).
Proof.
  revert i. induction n as [|n IH]; intros i; cbn; constructor; [|apply IH]. rewrite range_In. lia.
Qed.

Lemma sum_over_range i n f : sum_over (range i n) f = sum n (fun t => f (i + N.of_nat t)%N).
Proof.
  revert i. induction n as [|n IH]; intros i; [reflexivity|]. rewrite sum_first. cbn [range sum_over]. rewrite IH. f_equal.
  - rewrite N.add_0_r. reflexivity.
  - apply sum_ext. intros t _. f_equal. lia.
Qed.

(** Linear functions in a box. *)
Definition within (b : box) (d : vector) : Prop := forall k, Rabs (d k) <= absolute (radius_of b) k.

Lemma linear_middle b e d : quadratic_part e = [] -> within b d ->
  Rabs (eval e (fun k => values (center_of b) k + d k) - value (middle b e)) <= value (spread b e).
Proof.
  intros Q W. unfold eval. rewrite Q. unfold middle, spread. rewrite value_add, sum_of_value, size_of_value, apply_plus. cbn.
  eapply Rle_trans; [|apply apply_bound, W]. apply Req_le. f_equal. lra.
Qed.

Lemma Rabs_between x y a : Rabs (x - y) <= a -> y - a <= x <= y + a.
Proof. unfold Rabs; destruct Rcase_abs; lra. Qed.

Lemma linear_least b e d : quadratic_part e = [] -> within b d ->
  value (least b e) <= eval e (fun k => values (center_of b) k + d k) <= value (greatest b e).
Proof.
  intros Q W. unfold least, greatest. rewrite value_add, value_sub. apply Rabs_between, linear_middle; assumption.
Qed.

Lemma low_le b d k : within b d -> value (low b k) <= values (center_of b) k + d k.
Proof.
  intros W. specialize (W k). unfold low. rewrite value_sub, value_abs. unfold values, absolute in *.
  assert (A := Rle_abs (- d k)). rewrite Rabs_Ropp in A. lra.
Qed.

Lemma most_ge b d k : within b d -> Rabs (values (center_of b) k + d k) <= value (most b k).
Proof.
  intros W. specialize (W k). unfold most. rewrite value_add, !value_abs. unfold values, absolute in *.
  eapply Rle_trans; [apply Rabs_triang|]. lra.
Qed.

Lemma vanishes_zero b d k : within b d -> vanishes b k = true -> values (center_of b) k + d k = 0.
Proof.
  intros W H. unfold vanishes in H. apply andb_prop in H. destruct H as [A B]. apply sign_zero in A. apply sign_zero in B.
  specialize (W k). unfold absolute in W. rewrite B, Rabs_R0 in W. unfold values. rewrite A.
  assert (P := Rabs_pos (d k)). destruct (Req_dec (d k) 0) as [->|D]; [lra|]. apply Rabs_no_R0 in D. lra.
Qed.

Lemma total_value l : value (total l) = fold_right (fun x s => value x + s) 0 l.
Proof.
  unfold total.
  assert (G : forall s, value (List.fold_left add l s) = value s + fold_right (fun x s => value x + s) 0 l).
  { induction l as [|x l IH]; intros s; cbn; [lra|]. rewrite IH, value_add. lra. }
  rewrite G, value_zero. lra.
Qed.

Lemma total_range n (f : N -> number) (i : N) :
  value (total (map f (range i n))) = sum n (fun t => value (f (i + N.of_nat t)%N)).
Proof.
  rewrite total_value. revert i.
  induction n as [|n IH]; intros i; [reflexivity|].
  rewrite sum_first. cbn [range map fold_right]. rewrite IH. f_equal.
  - rewrite N.add_0_r. reflexivity.
  - apply sum_ext. intros t _. do 2 f_equal. lia.
Qed.
