(** Forces that are accepted hold at rest, and multipliers that are accepted refute all. *)
From Coq Require Import NArith Reals List Bool Lra Lia.
From Slipproof.contact Require Import Coulomb Number Fixed Linear Zero Certificate Checker Rows Law Enclose Refute.
Import ListNotations.
Local Open Scope R_scope.

Section Instance.
  Variable i : instance.
  Hypothesis whole : is_whole i = true.
  Let p := tables_of i.
  Let P := problem_of i.
  Let modes := map (fun _ => Open) (t_mus p).

  Lemma numbers_after_zeros n l j : (j < n)%nat -> numbers (repeat zero n ++ l) j = 0.
  Proof.
    intros J. unfold numbers. rewrite app_nth1 by (rewrite repeat_length; exact J). rewrite nth_repeat. apply value_zero.
  Qed.

  Theorem check_rest_sound (fine : is_proper i = true) accelerations forces : check_rest p accelerations forces = true ->
    can_rest P (N.to_nat accelerations).
  Proof.
    intros H. unfold check_rest in H. split_and H. set (l := repeat zero (N.to_nat accelerations) ++ forces) in *.
    rewrite forallb_forall in H, H0. assert (SZ := size_is i). fold p P in SZ. exists (numbers l). split.
    - intros j J. apply numbers_after_zeros, J.
    - intros j J. rewrite <- (middle_answer i whole). apply sign_zero, H, range_In. lia.
    - intros k K. assert (Q := H0 _ (contact_at_In i modes k (modes_length i) K)). apply andb_prop in Q. destruct Q as [A B].
      apply sign_nonnegative in A. rewrite (normal_at i), table_of_value, Nat.add_assoc in A. fold P in A.
      apply le_value in B. rewrite (squares_of_tangents i) in B. unfold Checker.square in B. rewrite !value_mul, (normal_at i) in B.
      rewrite table_of_value, Nat.add_assoc in B. fold P in B. change (value (mu (contact_at i modes k))) with (friction P k) in B.
      split; [exact A|]. apply tangential_le.
      + apply Rmult_le_pos; [apply (friction_is i fine), K | exact A].
      + eapply Rle_trans; [apply Req_le|exact B]. apply sum_ext. intros t _. unfold of_contact.
        rewrite !table_of_value, Nat.add_assoc. reflexivity.
  Qed.

  Theorem check_no_rest_sound (fine : is_proper i = true) accelerations multipliers :
    check_no_rest p accelerations multipliers = true -> cannot_rest P (N.to_nat accelerations).
  Proof.
    intros H X [Z B C]. unfold check_no_rest in H. split_and H. apply N.leb_le in H.
    assert (W := motion_work i whole multipliers X). cbv zeta in W. fold p P in W.
    assert (Lost := loses_sound i multipliers H0). fold P in Lost.
    assert (Less := falls_sound i fine accelerations _ X H H1 Z C). fold P in Less.
    rewrite sum_zero in W by (intros j J; rewrite (B j J); ring). lra.
  Qed.
End Instance.
