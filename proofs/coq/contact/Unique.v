(** A complementarity problem with a diagonally dominant matrix has one solution: a projection is a contraction. *)
From Coq Require Import NArith Reals List Bool Lra Lia Psatz FMapPositive.
From Slipproof.contact Require Import Coulomb Number Fixed Linear Zero Certificate Checker Rows Law Enclose.
Import ListNotations.
Local Open Scope R_scope.

Lemma sum_over_member l f i : (forall j, In j l -> 0 <= f j) -> In i l -> f i <= sum_over l f.
Proof.
  induction l as [|k l IH]; intros P I; [destruct I|]. cbn.
  assert (S : 0 <= sum_over l f).
  { rewrite <- (sum_over_zero l (fun _ => 0)) by reflexivity. apply sum_over_le. intros j J. apply P. right. exact J. }
  assert (F := P k (or_introl eq_refl)). destruct I as [->|I]; [lra|].
  assert (A := IH (fun j J => P j (or_intror J)) I). lra.
Qed.

Lemma complementary_fixed a z w : 0 < a -> (z = Rmax (z - w / a) 0 <-> 0 <= z /\ 0 <= w /\ z * w = 0).
Proof.
  intros A. assert (I := Rinv_0_lt_compat a A). split.
  - intros E. unfold Rmax in E. destruct (Rle_dec (z - w / a) 0) as [L|L].
    + rewrite E in *. unfold Rdiv in L. split; [lra|]. split; [|lra]. nra.
    + assert (w / a = 0) by lra. assert (w = 0) by (replace w with (w / a * a) by (field; lra); rewrite H; lra). subst.
      unfold Rdiv in L. split; [nra|]. split; lra.
  - intros [Z [W E]]. apply Rmult_integral in E. destruct E as [->| ->].
    + rewrite Rmax_right; [reflexivity|]. unfold Rdiv. nra.
    + unfold Rdiv. rewrite Rmult_0_l, Rminus_0_r, Rmax_left; lra.
Qed.

Lemma law_in_one_dimension m r u : m = 0 -> (coulomb 1 m r u <-> 0 <= r 0%nat /\ 0 <= u 0%nat /\ r 0%nat * u 0%nat = 0).
Proof.
  intros ->. split.
  - intros [A B C _ _]. auto.
  - intros [A [B C]]. split; auto; [|intros; lia]. rewrite tangential_zero; [lra | intros; lia].
Qed.

Section Instance.
  Variable i : instance.
  Hypothesis whole : is_whole i = true.
  Hypothesis fine : is_proper i = true.
  Let p := tables_of i.
  Let P := problem_of i.
  Variable weights : list number.
  Hypothesis checked : check_dominant p weights = true.
  Let d (k : N) : R := value (get (table_of weights) k).
  Let left := range 0 (N.to_nat (t_size p)).
  Let a (k j : N) : R := matrix P (N.to_nat k) (N.to_nat j).

  Lemma shape : free P = 0%nat /\ dimension P = 1%nat.
  Proof.
    assert (C := checked). unfold check_dominant in C. split_and C. apply N.eqb_eq in C. apply N.eqb_eq in H0.
    unfold P, problem_of; cbn. change (frees i) with (t_frees p). change (dim i) with (t_dim p). lia.
  Qed.

  Lemma size_one : N.to_nat (t_size p) = size P /\ size P = contacts P.
  Proof. split; [apply size_is|]. unfold size. destruct shape as [-> ->]. lia. Qed.

  Lemma in_left k : In k left <-> (N.to_nat k < size P)%nat.
  Proof. unfold left. rewrite range_In. destruct size_one as [S _]. rewrite S. lia. Qed.

  Lemma entry_value k j : In j left ->
    value (get (accumulate empty one (linear_part (row p k))) j) = a k j.
  Proof.
    intros J. pose (unit := fun n : N => if N.eq_dec n j then 1 else 0).
    assert (U : forall n, ~ In n left -> unit n = 0).
    { intros n M. unfold unit. destruct (N.eq_dec n j) as [->|]; [contradiction | reflexivity]. }
    assert (Q := accumulate_value left empty one (linear_part (row p k)) unit (range_NoDup _ _) U).
    rewrite (sum_over_changed left j (value (get (accumulate empty one (linear_part (row p k))) j)) _ (fun _ => 0)
      (range_NoDup _ _) J) in Q.
    2: { intros n M. unfold unit. destruct (N.eq_dec n j); [contradiction | lra]. }
    2: { unfold unit. destruct (N.eq_dec j j); [lra | contradiction]. }
    rewrite (sum_over_zero left (fun _ => 0)) in Q by reflexivity.
    rewrite sum_over_zero in Q by (intros; rewrite get_empty, value_zero; lra).
    assert (RL : apply (linear_part (row p k)) unit = a k j).
    { assert (K := row_linear i whole (N.to_nat k) unit). rewrite N2Nat.id in K.
      cbn [linear_part row]. unfold p. rewrite K. fold P.
      rewrite (sum_single _ (N.to_nat j)).
      - unfold unit. rewrite N2Nat.id. destruct (N.eq_dec j j); [|contradiction]. unfold a. lra.
      - apply in_left, J.
      - intros n _ M. unfold unit. destruct (N.eq_dec (N.of_nat n) j) as [E|]; [|lra]. exfalso. apply M. lia. }
    rewrite value_one, RL in Q. lra.
  Qed.

  Definition off (k j : N) : R := if N.eqb j k then 0 else - (a k j / a k k).

  Lemma dominance k : In k left -> 0 < d k /\ 0 < a k k /\ sum_over left (fun j => Rabs (off k j) * d j) < d k.
  Proof.
    intros K. assert (C := checked). unfold check_dominant in C. split_and C. rewrite forallb_forall in H.
    specialize (H k K). cbv zeta in H. split_and H. apply sign_positive in H. apply sign_positive in H2.
    rewrite (entry_value k k K) in H2. apply lt_value in H1. rewrite value_mul, (entry_value k k K) in H1.
    split; [exact H|]. split; [exact H2|].
    rewrite total_range in H1.
    apply Rmult_lt_reg_l with (a k k); [exact H2|]. rewrite <- sum_over_scale.
    eapply Rle_lt_trans; [|exact H1]. apply Req_le. unfold left. rewrite sum_over_range. apply sum_ext. intros j J.
    set (n := (0 + N.of_nat j)%N). unfold off. destruct (N.eqb_spec n k) as [E|E].
    - rewrite value_zero, Rabs_R0. ring.
    - rewrite value_mul, value_abs, entry_value.
      + rewrite Rabs_Ropp. unfold Rdiv. rewrite Rabs_mult, Rabs_inv, (Rabs_right (a k k)) by lra. unfold d. field. lra.
      + apply range_In. unfold n. lia.
  Qed.

  Section Constant.
    Variable c : nat -> R.
    Let Q := with_constant P c.
    Let shift (k : N) : R := - (c (N.to_nat k) / a k k).

    Lemma moved k (v : vector) : In k left ->
      shift k + sum_over left (fun j => off k j * v j) = v k - motion Q (fun j => v (N.of_nat j)) (N.to_nat k) / a k k.
    Proof.
      intros K. destruct (dominance k K) as [_ [A _]].
      unfold motion, Q, with_constant; cbn [constant]. unfold size; cbn [free dimension contacts]. fold (size P).
      unfold shift. rewrite <- (proj1 size_one).
      assert (E : sum (N.to_nat (t_size p)) (fun j => matrix P (N.to_nat k) j * v (N.of_nat j))
        = sum_over left (fun j => a k j * v j)).
      { unfold left. rewrite sum_over_range. apply sum_ext. intros j _. unfold a.
        replace (N.to_nat (0 + N.of_nat j)) with j by lia. reflexivity. }
      cbn [matrix]. rewrite E.
      assert (F : sum_over left (fun j => off k j * v j) = sum_over left (fun j => - / a k k * (a k j * v j)) + v k).
      { apply sum_over_changed with k.
        - apply range_NoDup.
        - exact K.
        - intros j J. unfold off. destruct (N.eqb_spec j k); [contradiction|]. field. lra.
        - unfold off. rewrite N.eqb_refl. field. lra. }
      rewrite F, sum_over_scale. field. lra.
    Qed.

    Let G (v : vector) (k : N) : R :=
      if in_dec N.eq_dec k left then Rmax (shift k + sum_over left (fun j => off k j * v j)) 0 else 0.
    Let H (t : vector) (k : N) : R :=
      if in_dec N.eq_dec k left then Rabs (shift k) + sum_over left (fun j => Rabs (off k j) * t j) else Rabs 0.

    (** Solutions are the fixed points. *)
    Lemma solution_fixed x : solution Q x <->
      forall k, In k left -> x (N.to_nat k) = Rmax (shift k + sum_over left (fun j => off k j * x (N.to_nat j))) 0.
    Proof.
      destruct shape as [F0 D1]. destruct size_one as [_ S1].
      assert (X : forall k, In k left ->
        (coulomb (dimension Q) (friction Q (N.to_nat k)) (of_contact Q (N.to_nat k) x) (of_contact Q (N.to_nat k) (motion Q x))
         <-> x (N.to_nat k) = Rmax (shift k + sum_over left (fun j => off k j * x (N.to_nat j))) 0)).
      { intros k K. rewrite (moved k (fun j => x (N.to_nat j)) K).
        assert (M : motion Q (fun j => x (N.to_nat (N.of_nat j))) (N.to_nat k) = motion Q x (N.to_nat k)).
        { unfold motion. f_equal. apply sum_ext. intros j _. rewrite Nat2N.id. reflexivity. }
        rewrite M. destruct (dominance k K) as [_ [A _]].
        rewrite (complementary_fixed (a k k) (x (N.to_nat k)) (motion Q x (N.to_nat k)) A).
        change (dimension Q) with (dimension P). rewrite D1. rewrite law_in_one_dimension.
        - unfold of_contact. change (free Q) with (free P). change (dimension Q) with (dimension P). rewrite F0, D1.
          replace (0 + 1 * N.to_nat k + 0)%nat with (N.to_nat k) by lia. reflexivity.
        - apply (friction_is i fine); [|unfold P, problem_of in D1; cbn in D1; lia].
          apply in_left in K. rewrite S1 in K. exact K. }
      split.
      - intros [_ L] k K. apply (X k K), L. change (contacts Q) with (contacts P). rewrite <- S1. apply in_left, K.
      - intros E. split; [intros j J; change (free Q) with (free P) in J; lia|].
        intros k K. change (contacts Q) with (contacts P) in K.
        assert (I : In (N.of_nat k) left) by (apply in_left; rewrite Nat2N.id, S1; exact K).
        specialize (X _ I). rewrite Nat2N.id in X. apply X. specialize (E _ I). rewrite Nat2N.id in E. exact E.
    Qed.

    Lemma has_solution : exists x, solution Q x.
    Proof.
      pose (gap := fun k => d k - sum_over left (fun j => Rabs (off k j) * d j)).
      pose (scale := sum_over left (fun k => Rabs (shift k) / gap k)).
      assert (Gap : forall k, In k left -> 0 < gap k) by (intros k K; destruct (dominance k K) as [_ [_ B]]; unfold gap; lra).
      assert (Terms : forall k, In k left -> 0 <= Rabs (shift k) / gap k).
      { intros k K. apply Rmult_le_pos; [apply Rabs_pos|]. apply Rlt_le, Rinv_0_lt_compat, Gap, K. }
      assert (S0 : 0 <= scale).
      { unfold scale. rewrite <- (sum_over_zero left (fun _ => 0)) by reflexivity. apply sum_over_le, Terms. }
      destruct (fixed_point G H (fun k => if in_dec N.eq_dec k left then scale * d k else 0)) as [v V].
      - intros k. unfold G, H. destruct (in_dec N.eq_dec k left) as [K|K]; [|apply majorises_const].
        apply majorises_cut, majorises_plus; [apply majorises_const|]. apply majorises_sum_over.
        intros j _. apply majorises_scale, majorises_component.
      - intros k. destruct (in_dec N.eq_dec k left) as [K|K]; [|lra]. destruct (dominance k K). nra.
      - intros k. unfold H. destruct (in_dec N.eq_dec k left) as [K|K]; [|rewrite Rabs_R0; lra].
        rewrite (sum_over_ext _ _ (fun j => scale * (Rabs (off k j) * d j))).
        2: { intros j J. destruct (in_dec N.eq_dec j left); [ring | contradiction]. }
        rewrite sum_over_scale.
        assert (B : Rabs (shift k) / gap k <= scale) by (apply (sum_over_member left (fun k => Rabs (shift k) / gap k)); assumption).
        assert (A := Gap k K). apply (Rmult_le_compat_r (gap k)) in B; [|lra].
        replace (Rabs (shift k) / gap k * gap k) with (Rabs (shift k)) in B by (field; lra). unfold gap in B. lra.
      - exists (fun j => v (N.of_nat j)). apply solution_fixed. intros k K. destruct (V k) as [E _].
        unfold G in E. destruct (in_dec N.eq_dec k left) as [_|O]; [|contradiction].
        rewrite N2Nat.id, <- E at 1. f_equal. f_equal. apply sum_over_ext. intros j _. rewrite N2Nat.id. reflexivity.
    Qed.

    Lemma one_solution x y : solution Q x -> solution Q y -> forall j, (j < size P)%nat -> y j = x j.
    Proof.
      intros X Y j J. rewrite solution_fixed in X, Y.
      pose (e := fun k => y (N.to_nat k) - x (N.to_nat k)).
      assert (B : forall k, In k left -> Rabs (e k) <= sum_over left (fun j => Rabs (off k j) * Rabs (e j))).
      { intros k K. unfold e at 1. rewrite (X k K), (Y k K).
        set (f := fun z => sum_over left (fun j => off k j * z (N.to_nat j))).
        fold (f x) (f y).
        apply Rle_trans with (Rabs (f y - f x)).
        - unfold Rmax. destruct (Rle_dec (shift k + f y) 0), (Rle_dec (shift k + f x) 0); unfold Rabs;
            repeat destruct Rcase_abs; lra.
        - unfold f. rewrite <- (Rmult_1_l (sum_over left (fun j => off k j * x (N.to_nat j)))).
          unfold Rminus. rewrite Ropp_mult_distr_l, <- sum_over_scale, <- sum_over_plus.
          rewrite (sum_over_ext _ _ (fun j => off k j * e j)) by (intros; unfold e; ring).
          eapply Rle_trans; [apply sum_over_abs|]. apply sum_over_le. intros n _. rewrite Rabs_mult. lra. }
      assert (I : In (N.of_nat j) left) by (apply in_left; rewrite Nat2N.id; exact J).
      destruct (largest_ratio (table_of weights) e left) as [m [M R]].
      - intros E. rewrite E in I. destruct I.
      - intros k K. destruct (dominance k K) as [D _]. unfold absolute. fold (d k). rewrite Rabs_right; lra.
      - destruct (dominance m M) as [D [_ S]].
        assert (A : forall k, In k left -> absolute (table_of weights) k = d k).
        { intros k K. destruct (dominance k K) as [D' _]. unfold absolute. fold (d k). rewrite Rabs_right; lra. }
        assert (Z : Rabs (e m) = 0).
        { destruct (Rabs_pos (e m)) as [L|<-]; [|reflexivity]. exfalso.
          assert (T : Rabs (e m) * d m <= Rabs (e m) * sum_over left (fun j => Rabs (off m j) * d j)).
          { rewrite Rmult_comm. eapply Rle_trans; [apply Rmult_le_compat_l; [lra | apply (B m M)]|].
            rewrite <- !sum_over_scale. apply sum_over_le. intros k K. specialize (R k K). rewrite !A in R by assumption.
            replace (d m * (Rabs (off m k) * Rabs (e k))) with (Rabs (off m k) * (Rabs (e k) * d m)) by ring.
            replace (Rabs (e m) * (Rabs (off m k) * d k)) with (Rabs (off m k) * (Rabs (e m) * d k)) by ring.
            apply Rmult_le_compat_l; [apply Rabs_pos | exact R]. }
          apply (Rmult_lt_compat_l (Rabs (e m))) in S; lra. }
        specialize (R _ I). rewrite Z, !A in R by assumption.
        assert (Rabs (e (N.of_nat j)) = 0).
        { destruct (Rabs_pos (e (N.of_nat j))) as [L|<-]; [|reflexivity]. exfalso.
          assert (0 < Rabs (e (N.of_nat j)) * d m) by (apply Rmult_lt_0_compat; assumption). lra. }
        destruct (Req_dec (e (N.of_nat j)) 0) as [E|E]; [|apply Rabs_no_R0 in E; contradiction].
        unfold e in E. rewrite Nat2N.id in E. lra.
    Qed.
  End Constant.

  Theorem check_dominant_sound : unique P.
  Proof.
    intros c. destruct (has_solution c) as [x X]. exists x. split; [exact X|].
    intros y Y. apply (one_solution c); assumption.
  Qed.
End Instance.
