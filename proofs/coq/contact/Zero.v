(** A zero of quadratic equations in a box, by an approximate inverse (FORMAT.md, `enclosure`). *)
From Coq Require Import Reals NArith List Bool Lra Lia FMapPositive.
From Slipproof.contact Require Import Coulomb Number Fixed Linear.
Import ListNotations.
Local Open Scope R_scope.

(** Multiples of products of two unknowns. *)
Definition quadratic := list (number * N * N).
Record equation := Equation { constant_part : number; linear_part : linear; quadratic_part : quadratic }.
Definition nothing : equation := Equation zero [] [].

Fixpoint products (q : quadratic) (v w : vector) : R :=
  match q with [] => 0 | (a, j, k) :: r => value a * (v j * w k) + products r v w end.
Fixpoint products_abs (q : quadratic) (v : vector) : R :=
  match q with [] => 0 | (a, j, k) :: r => Rabs (value a) * (v j * v k) + products_abs r v end.

Definition eval (e : equation) (v : vector) : R :=
  value (constant_part e) + apply (linear_part e) v + products (quadratic_part e) v v.

(** e (z + d) = f + J d + Q(d): f, J, and a bound on |Q| where |d| <= p. *)
Fixpoint sum_of_products (q : quadratic) (z : table) : number :=
  match q with [] => zero | (a, j, k) :: r => add (mul a (mul (get z j) (get z k))) (sum_of_products r z) end.
Fixpoint size_of_products (q : quadratic) (p : table) : number :=
  match q with [] => zero | (a, j, k) :: r => add (mul (abs a) (mul (abs (get p j)) (abs (get p k)))) (size_of_products r p) end.
Definition at_center (e : equation) (z : table) : number :=
  add (add (constant_part e) (sum_of (linear_part e) z)) (sum_of_products (quadratic_part e) z).
Fixpoint slope_of_products (q : quadratic) (z : table) (l : linear) : linear :=
  match q with [] => l | (a, j, k) :: r => (j, mul a (get z k)) :: (k, mul a (get z j)) :: slope_of_products r z l end.
Definition slope (e : equation) (z : table) : linear := slope_of_products (quadratic_part e) z (linear_part e).

Lemma sum_of_products_value q z : value (sum_of_products q z) = products q (values z) (values z).
Proof.
  induction q as [|[[a j] k] q IH]; cbn; [apply value_zero|]. rewrite value_add, !value_mul, IH. unfold values; lra.
Qed.

Lemma size_of_products_value q p : value (size_of_products q p) = products_abs q (absolute p).
Proof.
  induction q as [|[[a j] k] q IH]; cbn; [apply value_zero|].
  rewrite value_add, !value_mul, !value_abs, IH. unfold absolute; lra.
Qed.

Lemma products_ext q v w v' w' : (forall i, v i = v' i) -> (forall i, w i = w' i) -> products q v w = products q v' w'.
Proof. intros V W. induction q as [|[[a j] k] q IH]; cbn; [reflexivity|]. rewrite V, W, IH. reflexivity. Qed.

Lemma eval_ext e v w : (forall i, v i = w i) -> eval e v = eval e w.
Proof. intros E. unfold eval. rewrite (apply_ext _ v w E), (products_ext _ v v w w E E). reflexivity. Qed.

Lemma eval_shift e z d :
  eval e (fun i => values z i + d i)
  = value (at_center e z) + apply (slope e z) d + products (quadratic_part e) d d.
Proof.
  unfold eval, at_center, slope. rewrite !value_add, sum_of_value, sum_of_products_value, apply_plus.
  assert (S : forall l, apply (slope_of_products (quadratic_part e) z l) d
    = apply l d + products (quadratic_part e) (values z) d + products (quadratic_part e) d (values z)).
  { intros l. generalize (quadratic_part e) as q. induction q as [|[[a j] k] q IH]; cbn; [lra|].
    rewrite IH, !value_mul. unfold values; lra. }
  rewrite S.
  assert (P : products (quadratic_part e) (fun i => values z i + d i) (fun i => values z i + d i)
    = products (quadratic_part e) (values z) (values z) + products (quadratic_part e) (values z) d
      + products (quadratic_part e) d (values z) + products (quadratic_part e) d d).
  { clear S. generalize (quadratic_part e) as q. induction q as [|[[a j] k] q IH]; cbn; [lra|]. rewrite IH; ring. }
  rewrite P. lra.
Qed.

Lemma majorises_products q : majorises (products_abs q) (fun d => products q d d).
Proof.
  induction q as [|[[a j] k] q IH]; cbn.
  - apply (majorises_ext (fun _ => Rabs 0) (fun _ => 0) _ _ (majorises_const 0)); intros; [apply Rabs_R0 | reflexivity].
  - apply majorises_plus; [|exact IH]. apply majorises_scale, majorises_mult; apply majorises_component.
Qed.

Lemma products_abs_scale q c v : products_abs q (fun i => c * v i) = c * c * products_abs q v.
Proof. induction q as [|[[a j] k] q IH]; cbn; [lra|]. rewrite IH; lra. Qed.

Lemma products_zero q v w : (forall i, v i = 0) -> products q v w = 0.
Proof. intros E. induction q as [|[[a j] k] q IH]; cbn; [reflexivity|]. rewrite E, IH; lra. Qed.

(** What is computed once of an equation. *)
Record expansion := Expansion { f_of : number; slope_of : linear; bend_of : number }.
Definition expand (z p : table) (e : equation) : expansion :=
  Expansion (at_center e z) (slope e z) (size_of_products (quadratic_part e) p).
Definition flat : expansion := Expansion zero [] zero.

Section Row.
  Variables (known : N -> expansion) (left : list N) (p : table) (j : N) (row : linear).

  Definition product_row : table := List.fold_left (fun m e => accumulate m (snd e) (slope_of (known (fst e)))) row empty.
  Definition shift_row : number :=
    abs (List.fold_left (fun s e => add s (mul (snd e) (f_of (known (fst e))))) row zero).
  Definition bend_row : number :=
    List.fold_left (fun s e => add s (mul (abs (snd e)) (bend_of (known (fst e))))) row zero.
  Definition identity (k : N) : number := if N.eqb k j then one else zero.
  Definition spread_row : number :=
    let m := product_row in
    List.fold_left (fun s k => add s (mul (abs (sub (identity k) (get m k))) (abs (get p k)))) left zero.
End Row.

(** The box times t is mapped into itself. *)
Definition mapped (t : number) (shift spread bend radius : number) : bool :=
  le (add shift (mul t (add spread (mul t bend)))) (mul t radius).

Section Zero.
  Variables (equations : N -> equation) (z p : table) (left : list N) (rows : list (N * linear)) (t : number).
  Variable known : N -> expansion.
  Hypothesis knows : forall b, known b = expand z p (equations b).
  Hypothesis names : map fst rows = left.
  Hypothesis distinct : NoDup left.
  Hypothesis no_more : forall b, (length left <= N.to_nat b)%nat -> equations b = nothing.
  Hypothesis t_size : 0 <= value t <= 1.
  Hypothesis contracts : forall j row, In (j, row) rows -> value (spread_row known left p j row) < Rabs (value (get p j)).
  Hypothesis into : forall j row, In (j, row) rows ->
    mapped t (shift_row known row) (spread_row known left p j row) (bend_row known row) (abs (get p j)) = true.

  Let spread_of (j : N) (row : linear) (k : N) : R := value (identity j k) - value (get (product_row known row) k).

  Lemma product_row_value row c : (forall k, ~ In k left -> c k = 0) ->
    sum_over left (fun k => value (get (product_row known row) k) * c k)
    = apply row (fun b => apply (slope (equations b) z) c).
  Proof.
    intros O. unfold product_row.
    assert (G : forall m, sum_over left (fun k => value (get (List.fold_left
        (fun m e => accumulate m (snd e) (slope_of (known (fst e)))) row m) k) * c k)
      = sum_over left (fun k => value (get m k) * c k) + apply row (fun b => apply (slope (equations b) z) c)).
    { induction row as [|[b r] l IH]; intros m; cbn [List.fold_left apply fst snd]; [lra|].
      rewrite IH, accumulate_value by assumption. rewrite knows; cbn. lra. }
    rewrite G, sum_over_zero; [lra|]. intros k _. rewrite get_empty, value_zero; lra.
  Qed.

  Lemma identity_sum j c : In j left -> sum_over left (fun k => value (identity j k) * c k) = c j.
  Proof.
    intros I. rewrite (sum_over_changed left j (c j) _ (fun _ => 0) distinct I).
    - rewrite sum_over_zero; [lra|]. reflexivity.
    - intros k K. unfold identity. destruct (N.eqb_spec k j); [contradiction|]. rewrite value_zero; lra.
    - unfold identity. rewrite N.eqb_refl, value_one; lra.
  Qed.

  Lemma spread_sum j row c : In j left -> (forall k, ~ In k left -> c k = 0) ->
    sum_over left (fun k => spread_of j row k * c k) = c j - apply row (fun b => apply (slope (equations b) z) c).
  Proof.
    intros I O. rewrite <- (product_row_value row c O), <- (identity_sum j c I).
    rewrite (sum_over_ext _ _ (fun k => value (identity j k) * c k + (-1) * (value (get (product_row known row) k) * c k)))
      by (intros; unfold spread_of; ring).
    rewrite sum_over_plus, sum_over_scale. lra.
  Qed.

  Lemma spread_row_value j row :
    value (spread_row known left p j row) = sum_over left (fun k => Rabs (spread_of j row k) * absolute p k).
  Proof.
    unfold spread_row, spread_of.
    assert (G : forall m l s, value (List.fold_left
        (fun s k => add s (mul (abs (sub (identity j k) (get m k))) (abs (get p k)))) l s)
      = value s + sum_over l (fun k => Rabs (value (identity j k) - value (get m k)) * absolute p k)).
    { intros m l. induction l as [|k l IH]; intros s; cbn; [lra|].
      rewrite IH, value_add, value_mul, !value_abs, value_sub. unfold absolute; lra. }
    rewrite G, value_zero. lra.
  Qed.

  Lemma shift_row_value row : value (shift_row known row) = Rabs (apply row (fun b => value (at_center (equations b) z))).
  Proof.
    unfold shift_row. rewrite value_abs. f_equal.
    assert (G : forall s, value (List.fold_left (fun s e => add s (mul (snd e) (f_of (known (fst e))))) row s)
      = value s + apply row (fun b => value (at_center (equations b) z))).
    { induction row as [|[b r] l IH]; intros s; cbn [List.fold_left apply apply_abs fst snd]; [lra|].
      rewrite IH, value_add, value_mul. rewrite knows; cbn; lra. }
    rewrite G, value_zero; lra.
  Qed.

  Lemma bend_row_value row :
    value (bend_row known row) = apply_abs row (fun b => products_abs (quadratic_part (equations b)) (absolute p)).
  Proof.
    unfold bend_row.
    assert (G : forall s, value (List.fold_left (fun s e => add s (mul (abs (snd e)) (bend_of (known (fst e))))) row s)
      = value s + apply_abs row (fun b => products_abs (quadratic_part (equations b)) (absolute p))).
    { induction row as [|[b r] l IH]; intros s; cbn [List.fold_left apply apply_abs fst snd]; [lra|].
      rewrite IH, value_add, value_mul, value_abs. rewrite knows; cbn. rewrite size_of_products_value. lra. }
    rewrite G, value_zero; lra.
  Qed.

  Definition find_row (i : N) : option linear :=
    match find (fun e => N.eqb (fst e) i) rows with Some (_, r) => Some r | None => None end.

  Lemma find_row_some i r : find_row i = Some r -> In (i, r) rows.
  Proof.
    unfold find_row. destruct (find _ rows) as [[k r']|] eqn:F; intros E; inversion E; subst.
    apply find_some in F. destruct F as [I Q]. apply N.eqb_eq in Q. cbn in Q; subst. exact I.
  Qed.

  Lemma find_row_none i : find_row i = None -> ~ In i left.
  Proof.
    unfold find_row. destruct (find _ rows) as [[k r']|] eqn:F; intros E I; [discriminate|].
    rewrite <- names in I. apply in_map_iff in I. destruct I as [e [<- I]].
    assert (Q := find_none _ _ F e I). cbv beta in Q. rewrite N.eqb_refl in Q. discriminate.
  Qed.

  Lemma row_left i r : In (i, r) rows -> In i left.
  Proof. intros I. rewrite <- names. apply (in_map fst) in I. exact I. Qed.

  (** d - R F(z + d) *)
  Let G (d : vector) (i : N) : R :=
    match find_row i with
    | Some r => - apply r (fun b => value (at_center (equations b) z)) + sum_over left (fun k => spread_of i r k * d k)
                + -1 * apply r (fun b => products (quadratic_part (equations b)) d d)
    | None => 0
    end.
  Let H (s : vector) (i : N) : R :=
    match find_row i with
    | Some r => Rabs (- apply r (fun b => value (at_center (equations b) z)))
                + sum_over left (fun k => Rabs (spread_of i r k) * s k)
                + Rabs (-1) * apply_abs r (fun b => products_abs (quadratic_part (equations b)) s)
    | None => Rabs 0
    end.

  Lemma newton_fixed : exists d, (forall i, Rabs (d i) <= absolute p i) /\ (forall i, ~ In i left -> d i = 0) /\
    forall i r, find_row i = Some r -> apply r (fun b => eval (equations b) (fun k => values z k + d k)) = 0.
  Proof.
    destruct (fixed_point G H (fun i => value t * absolute p i)) as [d D].
    - intros i. unfold G, H. destruct (find_row i) as [r|]; [|apply majorises_const].
      apply majorises_plus; [apply majorises_plus; [apply majorises_const|]|].
      + apply majorises_sum_over. intros k _. apply majorises_scale, majorises_component.
      + apply majorises_scale. apply majorises_apply. intros b. apply majorises_products.
    - intros i. apply Rmult_le_pos; [lra | apply Rabs_pos].
    - intros i. unfold H. destruct (find_row i) as [r|] eqn:F.
      + apply find_row_some in F. assert (Q := into i r F). apply le_value in Q.
        rewrite !value_add, !value_mul, !value_add, !value_mul, value_abs in Q.
        rewrite shift_row_value, spread_row_value, bend_row_value in Q.
        rewrite Rabs_Ropp. replace (Rabs (-1)) with 1 by (rewrite Rabs_left; lra). rewrite Rmult_1_l.
        rewrite (sum_over_ext _ _ (fun k => value t * (Rabs (spread_of i r k) * absolute p k))) by (intros; ring).
        rewrite sum_over_scale.
        replace (apply_abs r (fun b => products_abs (quadratic_part (equations b)) (fun i0 => value t * absolute p i0)))
          with (value t * value t * apply_abs r (fun b => products_abs (quadratic_part (equations b)) (absolute p))).
        * unfold absolute at 3. lra.
        * rewrite <- apply_abs_scale.
          clear. induction r as [|[b a] r IH]; cbn; [reflexivity|]. rewrite IH, products_abs_scale. reflexivity.
      + rewrite Rabs_R0. apply Rmult_le_pos; [lra | apply Rabs_pos].
    - assert (O : forall i, ~ In i left -> d i = 0).
      { intros i I. destruct (D i) as [<- _]. unfold G. destruct (find_row i) eqn:F; [|reflexivity].
        apply find_row_some, row_left in F. contradiction. }
      exists d. split; [|split; [exact O|]].
      + intros i. eapply Rle_trans; [apply D|]. rewrite <- (Rmult_1_l (absolute p i)) at 2.
        apply Rmult_le_compat_r; [apply Rabs_pos | lra].
      + intros i r F. destruct (D i) as [E _]. unfold G in E. rewrite F in E.
        apply find_row_some, row_left in F. rewrite (spread_sum i r d F O) in E.
        rewrite (apply_ext _ _ (fun b => (value (at_center (equations b) z) + apply (slope (equations b) z) d)
          + products (quadratic_part (equations b)) d d)) by (intros; apply eval_shift).
        rewrite !apply_plus. lra.
  Qed.

  Lemma largest_ratio (c : vector) l : l <> [] -> (forall k, In k l -> 0 < absolute p k) ->
    exists j, In j l /\ forall k, In k l -> Rabs (c k) * absolute p j <= Rabs (c j) * absolute p k.
  Proof.
    induction l as [|a l IH]; intros E P; [contradiction|].
    destruct l as [|b l].
    - exists a. split; [left; reflexivity|]. intros k [->|[]]. lra.
    - destruct IH as [j [J B]]; [discriminate | intros; apply P; right; assumption|].
      assert (PJ := P j (or_intror J)). assert (PA := P a (or_introl eq_refl)).
      destruct (Rle_lt_dec (Rabs (c a) * absolute p j) (Rabs (c j) * absolute p a)) as [Q|Q].
      + exists j. split; [right; exact J|]. intros k [<-|K]; [exact Q | apply B, K].
      + exists a. split; [left; reflexivity|]. intros k [<-|K]; [lra|].
        specialize (B k K). apply Rmult_le_reg_r with (absolute p j); [exact PJ|].
        assert (PK := P k (or_intror K)).
        apply Rle_trans with (Rabs (c j) * absolute p k * absolute p a).
        * replace (Rabs (c k) * absolute p a * absolute p j) with (Rabs (c k) * absolute p j * absolute p a) by ring.
          apply Rmult_le_compat_r; lra.
        * replace (Rabs (c j) * absolute p k * absolute p a) with (Rabs (c j) * absolute p a * absolute p k) by ring.
          replace (Rabs (c a) * absolute p k * absolute p j) with (Rabs (c a) * absolute p j * absolute p k) by ring.
          apply Rmult_le_compat_r; lra.
  Qed.

  Lemma spread_nonnegative j row : 0 <= value (spread_row known left p j row).
  Proof.
    rewrite spread_row_value. rewrite <- (sum_over_zero left (fun _ => 0)) by reflexivity.
    apply sum_over_le. intros k _. apply Rmult_le_pos; apply Rabs_pos.
  Qed.

  Lemma row_of j : In j left -> exists r, find_row j = Some r /\ In (j, r) rows.
  Proof.
    intros J. destruct (find_row j) as [r|] eqn:F.
    - exists r. split; [reflexivity | apply find_row_some, F].
    - apply find_row_none in F. contradiction.
  Qed.

  (** R J c = 0 only where c = 0. *)
  Lemma injective c : (forall k, ~ In k left -> c k = 0) ->
    (forall i r, find_row i = Some r -> apply r (fun b => apply (slope (equations b) z) c) = 0) -> forall k, c k = 0.
  Proof.
    intros O Z k. destruct (in_dec N.eq_dec k left) as [K|K]; [|apply O, K].
    assert (P : forall i, In i left -> 0 < absolute p i).
    { intros i I. destruct (row_of i I) as [r [_ F]]. assert (C := contracts i r F).
      assert (S := spread_nonnegative i r). unfold absolute. lra. }
    destruct (largest_ratio c left) as [j [J B]]; [intros E; rewrite E in K; destruct K | exact P|].
    destruct (row_of j J) as [r [F I]]. assert (S := spread_sum j r c J O). rewrite (Z j r F), Rminus_0_r in S.
    assert (C := contracts j r I). rewrite spread_row_value in C. fold (absolute p j) in C.
    assert (Q : Rabs (c j) * absolute p j
      <= Rabs (c j) * sum_over left (fun k => Rabs (spread_of j r k) * absolute p k)).
    { rewrite <- S at 1. rewrite <- sum_over_scale. rewrite Rmult_comm.
      eapply Rle_trans; [apply Rmult_le_compat_l; [apply Rlt_le, P, J | apply sum_over_abs]|].
      rewrite <- sum_over_scale. apply sum_over_le. intros i I'. rewrite Rabs_mult.
      specialize (B i I'). assert (A := Rabs_pos (spread_of j r i)).
      replace (absolute p j * (Rabs (spread_of j r i) * Rabs (c i)))
        with (Rabs (spread_of j r i) * (Rabs (c i) * absolute p j)) by ring.
      replace (Rabs (c j) * (Rabs (spread_of j r i) * absolute p i))
        with (Rabs (spread_of j r i) * (Rabs (c j) * absolute p i)) by ring.
      apply Rmult_le_compat_l; assumption. }
    assert (Cj : Rabs (c j) = 0).
    { destruct (Rabs_pos (c j)) as [L|<-]; [|reflexivity]. exfalso.
      apply (Rmult_lt_compat_l (Rabs (c j))) in C; lra. }
    specialize (B k K). rewrite Cj, Rmult_0_l in B. assert (PJ := P j J). assert (A := Rabs_pos (c k)).
    assert (Rabs (c k) = 0).
    { destruct A as [A|A]; [|auto]. exfalso. assert (0 < Rabs (c k) * absolute p j) by (apply Rmult_lt_0_compat; assumption).
      lra. }
    destruct (Req_dec (c k) 0) as [E|E]; [exact E|]. apply Rabs_no_R0 in E. contradiction.
  Qed.

  Theorem zero_in_box : exists d, (forall i, Rabs (d i) <= absolute p i) /\ (forall i, ~ In i left -> d i = 0) /\
    forall b, eval (equations b) (fun k => values z k + d k) = 0.
  Proof.
    destruct newton_fixed as [d [D [O Z]]]. exists d. split; [exact D|]. split; [exact O|].
    pose (F := fun b => eval (equations b) (fun k => values z k + d k)). fold F in Z.
    pose (m := length left). pose (unit := fun (k : nat) (i : N) => if N.eq_dec i (nth k left 0%N) then 1 else 0).
    destruct (dependent m (fun i k => if Nat.eq_dec k m then F (N.of_nat i)
      else apply (slope (equations (N.of_nat i)) z) (unit k))) as [x [[n [N X]] E]].
    pose (c := fun i => sum m (fun k => x k * unit k i)).
    assert (E' : forall b, apply (slope (equations b) z) c + x m * F b = 0).
    { intros b. destruct (Nat.lt_ge_cases (N.to_nat b) m) as [L|L].
      - specialize (E _ L). cbn [sum] in E. rewrite N2Nat.id in E.
        destruct (Nat.eq_dec m m) as [_|]; [|contradiction].
        unfold c. rewrite apply_sum. rewrite Rmult_comm. rewrite <- E. f_equal. apply sum_ext. intros k K.
        destruct (Nat.eq_dec k m); [lia | ring].
      - unfold F. rewrite (no_more b L). cbn. unfold eval; cbn. rewrite value_zero. lra. }
    assert (C0 : forall k, ~ In k left -> c k = 0).
    { intros k K. apply sum_zero. intros i I. unfold unit.
      destruct (N.eq_dec k (nth i left 0%N)) as [->|]; [|lra]. exfalso. apply K, nth_In, I. }
    assert (C : forall k, c k = 0).
    { apply injective; [exact C0|]. intros i r R. specialize (Z i r R).
      assert (A : apply r (fun b => apply (slope (equations b) z) c + x m * F b) = 0) by (apply apply_zero; exact E').
      rewrite apply_plus, apply_scale, Z in A. lra. }
    assert (X0 : forall k, (k < m)%nat -> x k = 0).
    { intros k K. specialize (C (nth k left 0%N)). unfold c in C. rewrite (sum_single _ k) in C; [|exact K|].
      - unfold unit in C. destruct (N.eq_dec _ _) as [_|Q]; [lra | contradiction].
      - intros j J D'. unfold unit. destruct (N.eq_dec _ _) as [Q|_]; [|lra]. exfalso. apply D'.
        symmetry. apply (proj1 (NoDup_nth left 0%N) distinct); assumption. }
    assert (XM : x m <> 0).
    { destruct (Nat.eq_dec n m) as [<-|D']; [exact X|]. exfalso. apply X, X0. lia. }
    intros b. specialize (E' b). rewrite (apply_zero _ c C) in E'. fold F.
    rewrite Rplus_0_l in E'. apply Rmult_integral in E'. destruct E' as [E'|E']; [contradiction | exact E'].
  Qed.
End Zero.
