(** A zero in a box is the only one within a multiple of the radii (FORMAT.md, `all-solutions`, `alone`). *)
From Coq Require Import NArith Reals List Bool Lra Lia Psatz FMapPositive.
From Slipproof.contact Require Import Coulomb Number Fixed Linear Zero Certificate Checker Rows Law Enclose Motions.
Import ListNotations.
Local Open Scope R_scope.

(** Products of vectors that differ by e, of size l p, where e is at most t p. *)
Lemma products_differ q p a b l t : (forall i, 0 <= p i) -> 0 <= l -> 0 <= t ->
  (forall i, Rabs (a i) <= l * p i) -> (forall i, Rabs (b i) <= l * p i) -> (forall i, Rabs (a i - b i) <= t * p i) ->
  Rabs (products q a a - products q b b) <= t * (2 * l * products_abs q p).
Proof.
  intros P L T A B E. induction q as [|[[x j] k] q IH]; cbn; [rewrite Rminus_0_r, Rabs_R0; lra|].
  replace (value x * (a j * a k) + products q a a - (value x * (b j * b k) + products q b b))
    with (value x * (a j * (a k - b k) + (a j - b j) * b k) + (products q a a - products q b b)) by ring.
  eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_mult.
  assert (Q : Rabs (a j * (a k - b k) + (a j - b j) * b k) <= t * (2 * l * (p j * p k))).
  { eapply Rle_trans; [apply Rabs_triang|]. rewrite !Rabs_mult.
    assert (Q1 := Rmult_le_compat _ _ _ _ (Rabs_pos _) (Rabs_pos _) (A j) (E k)).
    assert (Q2 := Rmult_le_compat _ _ _ _ (Rabs_pos _) (Rabs_pos _) (E j) (B k)). lra. }
  assert (V := Rabs_pos (value x)). apply (Rmult_le_compat_l _ _ _ V) in Q. lra.
Qed.

(** What all products add is at most twice the greater one of what the positive and the negative ones do. *)
Lemma bend_close p e : value (size_of_products (quadratic_part e) p) <= 2 * value (close_bend p e).
Proof.
  unfold close_bend. generalize (quadratic_part e) as q. intros q. cbv zeta.
  set (part := fun positive => size_of_products
    (filter (fun t : number * N * N => match t with (a, _, _) => Bool.eqb (nonnegative a) positive end) q) p).
  change (value (size_of_products q p) <= 2 * value (if le (part true) (part false) then part false else part true)).
  assert (S : value (size_of_products q p) = value (part true) + value (part false)).
  { unfold part. induction q as [|[[a j] k] q IH]; cbn [size_of_products filter]; [rewrite value_zero; lra|].
    rewrite value_add, IH.
    destruct (nonnegative a); cbn [Bool.eqb size_of_products]; rewrite value_add; lra. }
  rewrite S. destruct (le (part true) (part false)) eqn:L; [apply le_value in L | apply le_false in L]; lra.
Qed.

Lemma apply_abs_le l v w : (forall i, v i <= w i) -> apply_abs l v <= apply_abs l w.
Proof.
  intros E. induction l as [|[j a] l IH]; cbn; [lra|]. assert (Q := E j). assert (P := Rabs_pos (value a)). nra.
Qed.

Section Alone.
  Variables (equations : N -> equation) (z p : table) (left : list N) (rows : list (N * linear)) (l : R).
  Variable known : N -> expansion.
  Hypothesis knows : forall b, known b = expand z p (equations b).
  Hypothesis names : map fst rows = left.
  Hypothesis distinct : NoDup left.
  Hypothesis factor : 0 <= l.
  Let bend (row : linear) : R := apply_abs row (fun b => products_abs (quadratic_part (equations b)) (absolute p)).
  Hypothesis contracts : forall j row, In (j, row) rows ->
    value (spread_row known left p j row) + 2 * l * bend row < Rabs (value (get p j)).

  Lemma bend_nonnegative row : 0 <= bend row.
  Proof.
    unfold bend. induction row as [|[b a] r IH]; cbn; [lra|].
    assert (Q : 0 <= products_abs (quadratic_part (equations b)) (absolute p)).
    { generalize (quadratic_part (equations b)) as q. induction q as [|[[x j] k] q IHq]; cbn; [lra|].
      assert (0 <= Rabs (value x) * (absolute p j * absolute p k)); [|lra].
      apply Rmult_le_pos; [apply Rabs_pos | apply Rmult_le_pos; apply Rabs_pos]. }
    assert (P := Rabs_pos (value a)). nra.
  Qed.

  Theorem alone_in_box a b : (forall k, Rabs (a k) <= l * absolute p k) -> (forall k, Rabs (b k) <= l * absolute p k) ->
    (forall k, ~ In k left -> a k = 0) -> (forall k, ~ In k left -> b k = 0) ->
    (forall n, eval (equations n) (fun k => values z k + a k) = 0) ->
    (forall n, eval (equations n) (fun k => values z k + b k) = 0) -> forall k, a k = b k.
  Proof.
    intros A B OA OB ZA ZB k. destruct (in_dec N.eq_dec k left) as [K|K]; [|rewrite OA, OB by exact K; reflexivity].
    set (e := fun k => a k - b k).
    assert (O : forall k, ~ In k left -> e k = 0) by (intros j J; unfold e; rewrite OA, OB by exact J; ring).
    assert (Row : forall j, In j left -> exists row, In (j, row) rows).
    { intros j J. rewrite <- names in J. apply in_map_iff in J. destruct J as [[i row] [<- I]]. exists row. exact I. }
    assert (P : forall j, In j left -> 0 < absolute p j).
    { intros j J. destruct (Row j J) as [row I]. assert (C := contracts j row I).
      assert (S := spread_nonnegative p left known j row).
      assert (Q := bend_nonnegative row). unfold absolute. nra. }
    destruct (largest_ratio p e left) as [j [J L]]; [intros N; rewrite N in K; destruct K | exact P|].
    destruct (Row j J) as [row I]. assert (C := contracts j row I). fold (absolute p j) in C.
    assert (PJ := P j J). set (t := Rabs (e j) / absolute p j).
    assert (I0 : 0 < / absolute p j) by (apply Rinv_0_lt_compat, PJ).
    assert (T : 0 <= t) by (unfold t, Rdiv; assert (Q := Rabs_pos (e j)); nra).
    assert (TJ : t * absolute p j = Rabs (e j)) by (unfold t; field; lra).
    assert (E : forall i, Rabs (e i) <= t * absolute p i).
    { intros i. destruct (in_dec N.eq_dec i left) as [M|M].
      - specialize (L i M). apply Rmult_le_reg_r with (absolute p j); [exact PJ|].
        replace (t * absolute p i * absolute p j) with (t * absolute p j * absolute p i) by ring. rewrite TJ. exact L.
      - rewrite (O i M), Rabs_R0. apply Rmult_le_pos; [exact T | apply Rabs_pos]. }
    assert (S := spread_sum equations z p left known knows distinct j row e J O).
    assert (Slopes : apply row (fun n => apply (slope (equations n) z) e)
      = - apply row (fun n => products (quadratic_part (equations n)) a a - products (quadratic_part (equations n)) b b)).
    { replace (- apply row (fun n => products (quadratic_part (equations n)) a a - products (quadratic_part (equations n)) b b))
        with (-1 * apply row (fun n => products (quadratic_part (equations n)) a a - products (quadratic_part (equations n)) b b)) by ring.
      rewrite <- apply_scale. apply apply_ext. intros n.
      assert (X := ZA n). assert (Y := ZB n). rewrite eval_shift in X, Y.
      assert (D : apply (slope (equations n) z) e = apply (slope (equations n) z) a - apply (slope (equations n) z) b).
      { transitivity (apply (slope (equations n) z) (fun i => a i + -1 * b i));
          [apply apply_ext; intros; unfold e; ring | rewrite apply_plus, apply_scale; ring]. }
      rewrite D. lra. }
    assert (Bend : Rabs (apply row (fun n => products (quadratic_part (equations n)) a a - products (quadratic_part (equations n)) b b))
      <= t * (2 * l * bend row)).
    { eapply Rle_trans.
      - apply (apply_bound _ _ (fun n => (t * (2 * l)) * products_abs (quadratic_part (equations n)) (absolute p))). intros n.
        eapply Rle_trans; [apply (products_differ _ (absolute p) a b l t); auto; intros; apply Rabs_pos | apply Req_le; ring].
      - rewrite apply_abs_scale. fold (bend row). apply Req_le. ring. }
    assert (Spread : Rabs (sum_over left (fun k => (value (identity j k) - value (get (product_row known row) k)) * e k))
      <= t * value (spread_row known left p j row)).
    { eapply Rle_trans; [apply sum_over_abs|]. rewrite (spread_row_value p left known j row), <- sum_over_scale.
      apply sum_over_le. intros i _. rewrite Rabs_mult. specialize (E i).
      assert (Q := Rabs_pos (value (identity j i) - value (get (product_row known row) i))). nra. }
    assert (EJ : Rabs (e j) <= t * value (spread_row known left p j row) + t * (2 * l * bend row)).
    { replace (e j) with (sum_over left (fun k => (value (identity j k) - value (get (product_row known row) k)) * e k)
        + - apply row (fun n => products (quadratic_part (equations n)) a a - products (quadratic_part (equations n)) b b))
        by (rewrite S, Slopes; ring).
      eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp. lra. }
    assert (T0 : t = 0) by nra. specialize (E k). rewrite T0, Rmult_0_l in E.
    assert (Q := Rabs_pos (e k)). destruct (Req_dec (e k) 0) as [Z|Z]; [unfold e in Z; lra|]. apply Rabs_no_R0 in Z. lra.
  Qed.
End Alone.
