(** What is accepted as a refutation is one. *)
From Coq Require Import NArith Reals List Bool Lra Lia Psatz FMapPositive FunctionalExtensionality.
From Slipproof.contact Require Import Coulomb Number Fixed Linear Zero Certificate Checker Rows Law Enclose.
Import ListNotations.
Local Open Scope R_scope.

(** Intervals *)

Definition contains (x : interval) (a : R) : Prop := value (from x) <= a <= value (upto x).

Lemma smaller_value x y : value (smaller x y) = Rmin (value x) (value y).
Proof.
  unfold smaller. destruct (le x y) eqn:L.
  - apply le_value in L. rewrite Rmin_left; lra.
  - apply le_false in L. rewrite Rmin_right; lra.
Qed.

Lemma larger_value x y : value (larger x y) = Rmax (value x) (value y).
Proof.
  unfold larger. destruct (le x y) eqn:L.
  - apply le_value in L. rewrite Rmax_right; lra.
  - apply le_false in L. rewrite Rmax_left; lra.
Qed.

Lemma not_missed x : contains x 0 -> misses_zero x = false.
Proof.
  intros [A B]. unfold misses_zero. apply orb_false_iff. split.
  - destruct (positive_number (from x)) eqn:P; [|reflexivity]. apply sign_positive in P. lra.
  - destruct (positive_number (opp (upto x))) eqn:P; [|reflexivity]. apply sign_positive in P. rewrite value_opp in P. lra.
Qed.

Lemma contains_add x y a b : contains x a -> contains y b -> contains (add_intervals x y) (a + b).
Proof. intros [A B] [C D]. split; cbn [add_intervals from upto]; rewrite value_add; lra. Qed.

Lemma contains_sub x y a b : contains x a -> contains y b -> contains (sub_intervals x y) (a - b).
Proof. intros [A B] [C D]. split; cbn [sub_intervals from upto]; rewrite value_sub; lra. Qed.

Lemma mul_bounds a b c d x y : a <= x <= b -> c <= y <= d ->
  Rmin (Rmin (a * c) (a * d)) (Rmin (b * c) (b * d)) <= x * y <= Rmax (Rmax (a * c) (a * d)) (Rmax (b * c) (b * d)).
Proof.
  assert (G : forall s t u z, s <= z <= t -> Rmin (s * u) (t * u) <= z * u <= Rmax (s * u) (t * u)).
  { intros s t u z Z. unfold Rmin, Rmax. destruct (Rle_dec (s * u) (t * u)); destruct (Rle_lt_dec 0 u); split; nra. }
  assert (G' : forall s t u z, s <= z <= t -> Rmin (u * s) (u * t) <= u * z <= Rmax (u * s) (u * t)).
  { intros s t u z Z. rewrite (Rmult_comm u s), (Rmult_comm u t), (Rmult_comm u z). apply G, Z. }
  intros X Y. assert (P := G a b y x X). assert (Q := G' c d a y Y). assert (S := G' c d b y Y).
  revert P Q S. unfold Rmin, Rmax. repeat destruct Rle_dec; intros; lra.
Qed.

Lemma contains_mul x y a b : contains x a -> contains y b -> contains (mul_intervals x y) (a * b).
Proof.
  intros A B. unfold contains, mul_intervals; cbn [from upto].
  rewrite ?smaller_value, ?larger_value, ?value_mul.
  apply mul_bounds; assumption.
Qed.

Lemma contains_square x a : contains x a -> contains (square_interval x) (a * a).
Proof.
  intros [A B]. unfold contains, square_interval; cbn [from upto]. split.
  - destruct (misses_zero x) eqn:M; [|rewrite value_zero; nra].
    unfold misses_zero in M. rewrite smaller_value. unfold Checker.square. rewrite !value_mul. apply orb_prop in M.
    destruct M as [M|M]; apply sign_positive in M.
    + eapply Rle_trans; [apply Rmin_l|]. nra.
    + rewrite value_opp in M. eapply Rle_trans; [apply Rmin_r|]. nra.
  - rewrite larger_value. unfold Checker.square. rewrite !value_mul.
    destruct (Rle_lt_dec 0 a).
    + eapply Rle_trans; [|apply Rmax_r]. nra.
    + eapply Rle_trans; [|apply Rmax_l]. nra.
Qed.

Lemma contains_around x r a : Rabs (a - value x) <= value r -> contains (around x r) a.
Proof. intros B. apply Rabs_between in B. split; cbn [around from upto]; rewrite ?value_sub, ?value_add; lra. Qed.

Lemma contains_total n (f : N -> interval) (g : nat -> R) i :
  (forall t, (t < n)%nat -> contains (f (i + N.of_nat t)%N) (g t)) ->
  contains (total_interval (map f (range i n))) (sum n g).
Proof.
  revert i g. induction n as [|n IH]; intros i g C.
  - cbn. unfold contains; cbn. rewrite value_zero. lra.
  - rewrite sum_first. cbn [range map total_interval fold_right]. apply contains_add.
    + specialize (C 0%nat ltac:(lia)). rewrite N.add_0_r in C. exact C.
    + apply IH. intros t T. specialize (C (S t) ltac:(lia)).
      replace (N.succ i + N.of_nat t)%N with (i + N.of_nat (S t))%N by lia. exact C.
Qed.

Lemma antiparallel_parts d L r u : (1 <= d <= 3)%nat -> 0 <= L ->
  (forall t, (1 <= t < d)%nat -> tangential d u * r t = - L * u t) -> tangential d u <> 0 ->
  square_of d r = L * L /\ sum (d - 1) (fun t => r (S t) * u (S t)) <= 0 /\
  (d = 3%nat -> r 1%nat * u 2%nat - r 2%nat * u 1%nat = 0).
Proof.
  intros D L0 O N. set (V := tangential d u) in *.
  assert (V0 : 0 < V) by (destruct (tangential_nonnegative d u) as [A|A]; [exact A | symmetry in A; contradiction]).
  assert (VV : V * V = square_of d u) by apply tangential_square.
  assert (R' : forall t, (1 <= t < d)%nat -> r t = - (L / V) * u t).
  { intros t T. specialize (O t T). apply Rmult_eq_reg_l with V; [|exact N]. rewrite O. field. exact N. }
  split; [|split].
  - unfold square_of. rewrite (sum_ext _ _ (fun t => (L / V) * (L / V) * (u (S t) * u (S t)))).
    + rewrite sum_scale. fold (square_of d u). rewrite <- VV. field. exact N.
    + intros t T. rewrite R' by lia. ring.
  - rewrite (sum_ext _ _ (fun t => - (L / V) * (u (S t) * u (S t)))).
    + rewrite sum_scale. fold (square_of d u). rewrite <- VV.
      replace (- (L / V) * (V * V)) with (- (L * V)) by (field; exact N). nra.
    + intros t T. rewrite R' by lia. ring.
  - intros E. rewrite (R' 1%nat), (R' 2%nat) by lia. ring.
Qed.

Lemma square_of_zero d r : square_of d r <= 0 -> forall t, (1 <= t < d)%nat -> r t = 0.
Proof.
  intros Q [|t] T; [lia|]. apply (sum_square_zero (d - 1) (fun t => r (S t))); [|lia].
  apply Rle_antisym; [exact Q | apply square_of_nonnegative].
Qed.

Lemma fails_law (d : N) m (fr fu : N -> interval) (r u : nat -> R) : (1 <= N.to_nat d <= 3)%nat -> 0 <= value m ->
  (forall t, (t < N.to_nat d)%nat -> contains (fr (N.of_nat t)) (r t) /\ contains (fu (N.of_nat t)) (u t)) ->
  fails d m fr fu = true -> ~ coulomb (N.to_nat d) (value m) r u.
Proof.
  intros D M C H [P U Z K O]. unfold fails in H. split_and H.
  set (n := N.to_nat d) in *. replace (N.to_nat (d - 1)) with (n - 1)%nat in * by (unfold n; lia).
  destruct (C 0%nat ltac:(lia)) as [R0 U0]. cbn [N.of_nat] in R0, U0.
  assert (T0 := tangential_nonnegative n r). assert (TS := tangential_square n r).
  assert (Tangents : forall (v : nat -> R) (f : N -> interval), (forall t, (1 <= t < n)%nat -> v t = 0) ->
      (forall t, (t < n)%nat -> contains (f (N.of_nat t)) (v t)) ->
      forallb (fun t => negb (misses_zero (f t))) (range 1 (n - 1)) = true).
  { intros v f V F. apply forallb_forall. intros t T. apply range_In in T. apply negb_true_iff, not_missed.
    specialize (F (N.to_nat t) ltac:(lia)). rewrite V, N2Nat.id in F by lia. exact F. }
  assert (NR : nonnegative (upto (fr 0%N)) = true).
  { apply nonnegative_of. destruct R0. lra. }
  assert (NU : nonnegative (upto (fu 0%N)) = true).
  { apply nonnegative_of. destruct U0. lra. }
  destruct (Req_dec (r 0%nat) 0) as [E|E].
  - (* open *)
    rewrite E, Rmult_0_r in K. assert (Q : forall t, (1 <= t < n)%nat -> r t = 0).
    { apply square_of_zero. rewrite <- TS. nra. }
    rewrite NU, (Tangents r fr Q) in H by (intros; apply C; assumption).
    rewrite E in R0. rewrite (not_missed _ R0) in H. discriminate.
  - assert (u0 : u 0%nat = 0) by (apply Rmult_integral in Z; destruct Z; [contradiction | assumption]).
    rewrite u0 in U0. assert (L0 : 0 <= value m * r 0%nat) by nra.
    assert (Force : contains (total_interval (map (fun t => square_interval (fr t)) (range 1 (n - 1)))) (square_of n r)).
    { apply contains_total. intros t T. apply contains_square. replace (1 + N.of_nat t)%N with (N.of_nat (S t)) by lia.
      apply C. lia. }
    assert (Limit : forall x y, value x <= r 0%nat <= value y ->
        value (Checker.square (mul m (larger x zero))) <= (value m * r 0%nat) * (value m * r 0%nat)
        <= value (Checker.square (mul m (larger y zero)))).
    { intros x y [X Y]. unfold Checker.square. rewrite !value_mul, !larger_value, value_zero.
      assert (A : 0 <= Rmax (value x) 0 <= r 0%nat) by (split; [apply Rmax_r | apply Rmax_lub; lra]).
      assert (B : r 0%nat <= Rmax (value y) 0) by (eapply Rle_trans; [exact Y | apply Rmax_l]).
      assert (0 <= value m * Rmax (value x) 0 <= value m * r 0%nat) by (split; nra).
      assert (value m * r 0%nat <= value m * Rmax (value y) 0) by nra.
      split; apply Rmult_le_compat; lra. }
    destruct R0 as [R1 R2]. destruct (Limit _ _ (conj R1 R2)) as [LA LB].
    assert (InCone : le (from (total_interval (map (fun t => square_interval (fr t)) (range 1 (n - 1)))))
        (Checker.square (mul m (larger (upto (fr 0%N)) zero))) = true).
    { apply le_of. destruct Force as [F _].
      assert (square_of n r <= (value m * r 0%nat) * (value m * r 0%nat)).
      { rewrite <- TS. apply Rmult_le_compat; lra. }
      lra. }
    rewrite NR, (not_missed _ U0), InCone in H0, H1.
    destruct (Req_dec (tangential n u) 0) as [V|V].
    + (* sticking *)
      assert (Q : forall t, (1 <= t < n)%nat -> u t = 0).
      { apply square_of_zero. rewrite <- tangential_square, V. lra. }
      rewrite (Tangents u fu Q) in H1 by (intros t T; apply C, T). discriminate.
    + (* sliding *)
      destruct (antiparallel_parts n (value m * r 0%nat) r u D L0 O V) as [SQ [X Y]].
      assert (AtEdge : le (Checker.square (mul m (larger (from (fr 0%N)) zero)))
          (upto (total_interval (map (fun t => square_interval (fr t)) (range 1 (n - 1))))) = true).
      { apply le_of. destruct Force as [_ F]. lra. }
      assert (Down : nonnegative (opp (from (total_interval (map (fun t => mul_intervals (fr t) (fu t)) (range 1 (n - 1))))))
          = true).
      { assert (W : contains (total_interval (map (fun t => mul_intervals (fr t) (fu t)) (range 1 (n - 1))))
            (sum (n - 1) (fun t => r (S t) * u (S t)))).
        { apply contains_total. intros t T. replace (1 + N.of_nat t)%N with (N.of_nat (S t)) by lia.
          apply contains_mul; apply C; lia. }
        apply nonnegative_of. rewrite value_opp. destruct W. lra. }
      assert (Par : (N.ltb d 3 || negb (misses_zero (sub_intervals (mul_intervals (fr 1%N) (fu 2%N))
          (mul_intervals (fr 2%N) (fu 1%N)))))%bool = true).
      { destruct (N.ltb_spec d 3) as [A|A]; [reflexivity|]. cbn. apply negb_true_iff, not_missed.
        rewrite <- (Y ltac:(unfold n in *; lia)). apply contains_sub; apply contains_mul;
          [apply (C 1%nat) | apply (C 2%nat) | apply (C 2%nat) | apply (C 1%nat)]; unfold n in *; lia. }
      rewrite AtEdge, Down, Par in H0. discriminate.
Qed.

Section Instance.
  Variable i : instance.
  Hypothesis whole : is_whole i = true.
  Hypothesis fine : is_proper i = true.
  Let p := tables_of i.
  Let P := problem_of i.
  Let modes := map (fun _ => Open) (t_mus p).

  Lemma modes_length : length modes = length (frictions i).
  Proof. apply map_length. Qed.

  Lemma contact_component l k t : get (table_of l) (first (contact_at i modes k) + N.of_nat t)
    = get (table_of l) (N.of_nat (free P + dimension P * k + t)).
  Proof. f_equal. unfold contact_at; cbn [first]. unfold P, problem_of; cbn [free dimension]. lia. Qed.

  Lemma middle_answer x j : value (middle (Box (table_of x) empty) (row p (N.of_nat j))) = motion P (numbers x) j.
  Proof.
    unfold middle, motion. rewrite value_add, sum_of_value. cbn [constant_part linear_part row center_of].
    unfold p, P. rewrite (row_linear i whole), (row_constant i). rewrite Rplus_comm. f_equal.
    apply sum_ext. intros t _. unfold values. rewrite table_of_value. reflexivity.
  Qed.

  Theorem check_none_within_sound x rho : check_none_within p x rho = true -> none_within P (numbers x) (value rho).
  Proof.
    intros H X N [F L]. unfold check_none_within in H. split_and H.
    assert (Motion : forall j, contains (around (middle (Box (table_of x) empty) (row p (N.of_nat j)))
        (total (map (fun e => mul (abs (snd e)) rho) (linear_part (row p (N.of_nat j)))))) (motion P X j)).
    { intros j. apply contains_around. rewrite middle_answer.
      assert (E : motion P X j - motion P (numbers x) j
        = apply (linear_part (row p (N.of_nat j))) (fun k => X (N.to_nat k) - numbers x (N.to_nat k))).
      { cbn [linear_part row]. unfold p. rewrite (row_linear i whole). unfold motion. fold P.
        rewrite (sum_ext _ (fun k => matrix P j k * (X (N.to_nat (N.of_nat k)) - numbers x (N.to_nat (N.of_nat k))))
          (fun k => matrix P j k * X k + (-1) * (matrix P j k * numbers x k))) by (intros; rewrite Nat2N.id; ring).
        rewrite sum_plus, sum_scale. ring. }
      rewrite E. rewrite total_value.
      assert (B : forall e, In e (linear_part (row p (N.of_nat j))) -> (N.to_nat (fst e) < size P)%nat).
      { cbn [linear_part row]. assert (Q := columns i whole). fold P in Q. revert Q. unfold p, tables_of; cbn [t_rows].
        clear. unfold by_rows. intros Q.
        assert (G : forall l m, Forall (fun e => match e with (_, c, _) => (N.to_nat c < size P)%nat end) l ->
          (forall e : N * number, In e (look [] m (N.of_nat j)) -> (N.to_nat (fst e) < size P)%nat) ->
          forall e : N * number, In e (look [] (List.fold_left (fun m e => match e with (i, j, a) =>
            PositiveMap.add (key i) ((j, a) :: look [] m i) m end) l m) (N.of_nat j)) -> (N.to_nat (fst e) < size P)%nat).
        { induction l as [|[[r c] a] l IH]; intros m A B; [exact B|]. inversion A; subst. cbn [List.fold_left]. apply IH; [assumption|].
          intros e. rewrite look_add. destruct (N.eq_dec (N.of_nat j) r) as [E|]; [|apply B].
          intros [<-|I]; [assumption | apply B; rewrite E; exact I]. }
        apply (G _ _ Q). intros e. rewrite look_empty. intros []. }
      clear E. induction (linear_part (row p (N.of_nat j))) as [|[k a] l IH]; cbn [apply map fold_right snd].
      - rewrite Rabs_R0. lra.
      - eapply Rle_trans; [apply Rabs_triang|]. rewrite value_mul, value_abs, Rabs_mult. apply Rplus_le_compat.
        + apply Rmult_le_compat_l; [apply Rabs_pos|]. apply N. apply (B (k, a)). left. reflexivity.
        + apply IH. intros e I. apply B. right. exact I. }
    apply orb_prop in H0. destruct H0 as [Q|Q]; apply existsb_exists in Q.
    - destruct Q as [j [J Q]]. apply range_In in J. change (t_frees p) with (frees i) in J.
      rewrite <- (N2Nat.id j) in Q. specialize (Motion (N.to_nat j)). rewrite F in Motion.
      + rewrite (not_missed _ Motion) in Q. discriminate.
      + unfold P, problem_of; cbn [free]. lia.
    - destruct Q as [c [C Q]].
      assert (E : exists k, (k < contacts P)%nat /\ c = contact_at i modes k).
      { fold modes in C. unfold contacts_of in C. change (t_mus p) with (frictions i) in *.
        change (t_dim p) with (dim i) in C. change (t_frees p) with (frees i) in C.
        assert (G : forall d mus ms f s, length ms = length mus -> In c (layout d f s mus ms) ->
          exists k, (k < length mus)%nat /\ c = Contact (f + d * N.of_nat k) (s + N.of_nat k) (nth k mus zero) (nth k ms Open)).
        { clear. intros d. induction mus as [|m mus IH]; intros [|y ms] f s L I; cbn in *; try lia; try contradiction.
          destruct I as [<-|I].
          - exists 0%nat. split; [lia|]. f_equal; lia.
          - destruct (IH ms _ _ ltac:(lia) I) as [k [K E]]. exists (S k). split; [lia|]. rewrite E. f_equal; lia. }
        apply (G _ _ _ _ _ modes_length) in C. exact C. }
      destruct E as [k [K ->]]. destruct (friction_is i fine k K) as [A _].
      refine (fails_law (t_dim p) _ _ _ _ _ (dimension_is i fine) A _ Q (L k K)).
      intros t T. unfold of_contact. split.
      + rewrite contact_component. apply contains_around. rewrite table_of_value. apply N.
        unfold size. change (dimension P) with (N.to_nat (t_dim p)) in *. nia.
      + replace (first (contact_at i modes k) + N.of_nat t)%N with (N.of_nat (free P + dimension P * k + t))
          by (unfold contact_at; cbn [first]; unfold P, problem_of; cbn [free dimension]; lia).
        apply Motion.
  Qed.

  Lemma motion_work multipliers X :
    let g := combination p (table_of multipliers) in
    sum (size P) (fun j => numbers multipliers j * motion P X j)
    = sum (size P) (fun j => value (get g (N.of_nat j)) * X j) + sum (size P) (fun j => numbers multipliers j * constant P j).
  Proof.
    intros g. unfold combination in g. assert (SZ := size_is i). fold p P in SZ.
    set (left := range 0 (N.to_nat (t_size p))) in *.
    set (c := fun k : N => if (N.to_nat k <? size P)%nat then X (N.to_nat k) else 0).
    assert (O : forall k, ~ In k left -> c k = 0).
    { intros k K. unfold c. destruct (Nat.ltb_spec (N.to_nat k) (size P)); [|reflexivity].
      exfalso. apply K, range_In. lia. }
    assert (G : forall l m, sum_over left (fun k => value (get (List.fold_left (fun m j =>
        accumulate m (get (table_of multipliers) j) (linear_part (row p j))) l m) k) * c k)
      = sum_over left (fun k => value (get m k) * c k)
        + sum_over l (fun j => value (get (table_of multipliers) j) * apply (linear_part (row p j)) c)).
    { induction l as [|j l IH]; intros m; cbn [List.fold_left sum_over]; [lra|].
      rewrite IH, accumulate_value; [lra | apply range_NoDup | exact O]. }
    specialize (G left empty). fold g in G.
    rewrite (sum_over_zero left (fun k => value (get empty k) * c k)) in G
      by (intros; rewrite get_empty, value_zero; lra).
    unfold left in G. rewrite !sum_over_range, SZ in G. cbn [N.add] in G.
    rewrite (sum_ext _ (fun j => value (get g (N.of_nat j)) * X j) (fun j => value (get g (N.of_nat j)) * c (N.of_nat j))).
    2: { intros j J. unfold c. rewrite Nat2N.id. destruct (Nat.ltb_spec j (size P)); [reflexivity | lia]. }
    rewrite G, Rplus_0_l, <- sum_plus. apply sum_ext. intros j J. rewrite table_of_value.
    cbn [linear_part row]. unfold p. rewrite (row_linear i whole). fold P. unfold motion.
    rewrite (sum_ext _ (fun k => matrix P j k * c (N.of_nat k)) (fun k => matrix P j k * X k)).
    - ring.
    - intros k K. unfold c. rewrite Nat2N.id. destruct (Nat.ltb_spec k (size P)); [reflexivity | lia].
  Qed.

  Lemma component_at k t : (first (contact_at i modes k) + N.of_nat t)%N = N.of_nat (free P + (dimension P * k + t)).
  Proof. unfold contact_at; cbn [first]. unfold P, problem_of; cbn [free dimension]. lia. Qed.

  Lemma squares_of_tangents k m : value (total (map (fun j => Checker.square (get m j)) (tangents p (contact_at i modes k))))
    = square_of (dimension P) (fun t => value (get m (N.of_nat (free P + (dimension P * k + t))))).
  Proof.
    unfold tangents. rewrite total_range. unfold square_of, Checker.square. change (dimension P) with (N.to_nat (t_dim p)) at 1.
    replace (N.to_nat (t_dim p - 1)) with (N.to_nat (t_dim p) - 1)%nat by lia. apply sum_ext. intros t _.
    rewrite value_mul, <- (component_at k (S t)).
    replace (first (contact_at i modes k) + N.of_nat (S t))%N with (first (contact_at i modes k) + 1 + N.of_nat t)%N by lia.
    reflexivity.
  Qed.

  Lemma normal_at k (m : table) :
    get m (first (contact_at i modes k)) = get m (N.of_nat (free P + (dimension P * k + 0))).
  Proof. rewrite <- component_at. cbn [N.of_nat]. rewrite N.add_0_r. reflexivity. Qed.

  Lemma loses_sound multipliers : loses p (table_of multipliers) = true ->
    sum (size P) (fun j => numbers multipliers j * constant P j) < 0.
  Proof.
    intros H. assert (SZ := size_is i). fold p P in SZ. unfold loses in H. apply sign_positive in H.
    rewrite value_opp, total_range, SZ in H. rewrite (sum_ext _ _ (fun j => numbers multipliers j * constant P j)) in H; [lra|].
    intros j _. rewrite N.add_0_l, value_mul, table_of_value. unfold p. rewrite (row_constant i). reflexivity.
  Qed.

  Lemma falls_sound zeros g X : (zeros <= t_frees p)%N -> falls p zeros g = true ->
    (forall j, (j < N.to_nat zeros)%nat -> X j = 0) ->
    (forall k, (k < contacts P)%nat -> 0 <= of_contact P k X 0%nat /\
      tangential (dimension P) (of_contact P k X) <= friction P k * of_contact P k X 0%nat) ->
    sum (size P) (fun j => value (get g (N.of_nat j)) * X j) <= 0.
  Proof.
    intros Z H N C. unfold falls in H. apply andb_prop in H. destruct H as [H H1]. rewrite forallb_forall in H, H1.
    assert (DD := dimension_is i fine). change (dim i) with (t_dim p) in DD.
    unfold size. rewrite sum_split, sum_blocks. rewrite sum_zero.
    2: { intros j J. destruct (Nat.ltb_spec j (N.to_nat zeros)) as [L|L]; [rewrite (N j L); ring|].
         assert (Q : is_zero (get g (N.of_nat j)) = true).
         { apply H, range_In. change (free P) with (N.to_nat (t_frees p)) in J. lia. }
         apply sign_zero in Q. rewrite Q. ring. }
    rewrite Rplus_0_l. apply Ropp_le_cancel. rewrite Ropp_0. rewrite <- (Rmult_1_l (sum _ _)), <- Ropp_mult_distr_l_reverse, <- sum_scale.
    apply sum_nonnegative. intros k K. assert (Q := H1 _ (contact_at_In i modes k modes_length K)).
    apply andb_prop in Q. destruct Q as [G0 G]. destruct (C k K) as [R0 IC].
    set (r := of_contact P k X) in *. set (gg := fun t => value (get g (N.of_nat (free P + (dimension P * k + t))))).
    apply sign_nonnegative in G0. rewrite value_opp, normal_at in G0. apply le_value in G.
    rewrite value_mul, squares_of_tangents, normal_at in G. unfold Checker.square in G. rewrite !value_mul in G.
    change (value (get g (N.of_nat (free P + (dimension P * k + 0))))) with (gg 0%nat) in G0, G.
    fold gg in G. change (value (mu (contact_at i modes k))) with (friction P k) in G.
    assert (M : 0 <= friction P k) by (apply friction_is; assumption).
    rewrite (sum_ext _ _ (fun t => gg t * r t)).
    2: { intros t _. unfold gg, r, of_contact. rewrite Nat.add_assoc. reflexivity. }
    enough (sum (dimension P) (fun t => gg t * r t) <= 0) by lra.
    assert (D1 : dimension P = S (dimension P - 1)) by (unfold P, problem_of; cbn; change (dim i) with (t_dim p); lia).
    rewrite D1 at 1. rewrite sum_first.
    assert (A0 := tangential_nonnegative (dimension P) gg). assert (AA := tangential_square (dimension P) gg).
    assert (B0 := tangential_nonnegative (dimension P) r). assert (BB := tangential_square (dimension P) r).
    rewrite <- AA in G.
    set (a := tangential (dimension P) gg) in *. set (b := tangential (dimension P) r) in *.
    assert (CS : sum (dimension P - 1) (fun t => gg (S t) * r (S t)) <= a * b).
    { apply Rsqr_incr_0_var; [|nra]. unfold Rsqr. replace (a * b * (a * b)) with ((a * a) * (b * b)) by ring.
      rewrite AA, BB. clear - DD. unfold square_of. change (dimension P) with (N.to_nat (t_dim p)).
      assert (Q := Rle_0_sqr (gg 1%nat * r 2%nat - gg 2%nat * r 1%nat)). unfold Rsqr in Q.
      destruct (N.to_nat (t_dim p)) as [|[|[|[|d]]]]; try lia; cbn; lra. }
    assert (E : friction P k * a <= - gg 0%nat).
    { apply Rsqr_incr_0_var; [|lra]. unfold Rsqr. nra. }
    assert (a * b <= a * (friction P k * r 0%nat)) by (apply Rmult_le_compat_l; assumption).
    assert ((friction P k * a) * r 0%nat <= - gg 0%nat * r 0%nat) by (apply Rmult_le_compat_r; assumption).
    lra.
  Qed.

  Theorem check_no_solution_sound multipliers : check_no_solution p multipliers = true -> no_solution P.
  Proof.
    intros H X [F L]. unfold check_no_solution in H. split_and H.
    assert (W := motion_work multipliers X). cbv zeta in W. apply loses_sound in H0. rewrite forallb_forall in H1.
    assert (DD := dimension_is i fine). change (dim i) with (t_dim p) in DD.
    assert (Work : 0 <= sum (size P) (fun j => numbers multipliers j * motion P X j)).
    { unfold size. rewrite sum_split, sum_blocks.
      rewrite sum_zero by (intros j J; rewrite (F j J); ring). rewrite Rplus_0_l.
      apply sum_nonnegative. intros k K. assert (Q := H1 _ (contact_at_In i modes k modes_length K)).
      apply andb_prop in Q. destruct Q as [Q T]. destruct (L k K) as [_ U _ _ _]. unfold of_contact in U. rewrite Nat.add_0_r in U.
      apply sign_nonnegative in Q. rewrite normal_at, table_of_value, Nat.add_0_r in Q. rewrite forallb_forall in T.
      assert (D1 : dimension P = S (dimension P - 1)) by (unfold P, problem_of; cbn; change (dim i) with (t_dim p); lia).
      rewrite D1 at 1. rewrite sum_first, sum_zero.
      - rewrite Rplus_0_r. rewrite Nat.add_0_r in *. apply Rmult_le_pos; assumption.
      - intros t I. rewrite <- (table_of_value multipliers), <- (component_at k (S t)).
        assert (Z : is_zero (get (table_of multipliers) (first (contact_at i modes k) + N.of_nat (S t))) = true).
        { apply T, range_In. change (dimension P) with (N.to_nat (t_dim p)) in I. lia. }
        apply sign_zero in Z. rewrite Z. ring. }
    assert (Less := falls_sound 0 _ X (N.le_0_l _) H (fun j J => False_ind _ (Nat.nlt_0_r j J))
      (fun k K => conj (no_pull _ _ _ _ (L k K)) (in_cone _ _ _ _ (L k K)))).
    lra.
  Qed.
End Instance.
