(** What the checker accepts is true. *)
From Coq Require Import NArith Reals List Bool String Lia Lra FMapPositive.
From Slipproof.contact Require Import Coulomb Number Fixed Linear Zero Certificate Checker Rows Law Enclose Refute.
From Slipproof.contact Require Import Rest Unique Definite Ball AllMotions Read Parse.
Import ListNotations.

Lemma check_body_sound i b : is_whole i = true -> is_proper i = true -> check_body i (tables_of i) b = true -> meaning i b.
Proof.
  intros W F H. unfold meaning, of_answer.
  assert (A : match b, answer i with
    | Eps _ _ _ _, None | NoneWithin _, None | Enclosure _ _ _ _ _ _ _ _, None | Ball _ _ _ _ _ _ _ _ _ _ _ _, None => False
    | _, _ => True
    end)
    by (unfold check_body in H; destruct b, (answer i); try exact I; discriminate H).
  unfold check_body in H. destruct b; destruct (answer i) as [x|]; try contradiction.
  - apply (check_eps_sound i W F) in H. exact H.
  - apply (check_none_within_sound i W F) in H. exact H.
  - apply (check_no_solution_sound i W F) in H. exact H.
  - apply (check_no_solution_sound i W F) in H. exact H.
  - apply (check_rest_sound i W F) in H. exact H.
  - apply (check_rest_sound i W F) in H. exact H.
  - apply (check_no_rest_sound i W F) in H. exact H.
  - apply (check_no_rest_sound i W F) in H. exact H.
  - apply (check_enclosure_sound i W F) in H. destruct H as [X [S [N [M V]]]]. destruct eta as [eta|].
    + exists X. split; [exact S|]. split; [exact N|]. split; [exact M | exact V].
    + exists X. split; [exact S|]. split; [exact N | exact M].
  - apply (check_ball_sound i W F) in H. destruct H as [X [S [N [M V]]]]. destruct eta as [eta|].
    + exists X. split; [exact S|]. split; [exact N|]. split; [exact M | exact V].
    + exists X. split; [exact S|]. split; [exact N | exact M].
  - apply (check_dominant_sound i W F) in H. exact H.
  - apply (check_dominant_sound i W F) in H. exact H.
  - apply (check_definite_sound i W F) in H. exact H.
  - apply (check_definite_sound i W F) in H. exact H.
  - apply (check_all_solutions_sound i W F) in H. exact H.
  - apply (check_all_solutions_sound i W F) in H. exact H.
Qed.

(** The theorem for data instead of a text. *)
Theorem check_sound c : check c = true ->
  complete (about c) /\ proper (problem_of (about c)) /\ claims c <> [] /\ Forall (meaning (about c)) (claims c).
Proof.
  intros H. unfold check in H. split_and H. split; [|split; [|split]].
  - apply whole_complete, H.
  - apply proper_problem. assumption.
  - intros E. rewrite E in H1. discriminate.
  - apply Forall_forall. intros b B. rewrite forallb_forall in H0. apply check_body_sound; auto.
Qed.

Lemma spells_all_spells ts ps : spells_all ts ps = true -> Forall2 spells ts ps.
Proof.
  revert ps. induction ts as [|t ts IH]; intros [|q ps] H; cbn in H; try discriminate; [constructor|].
  apply andb_prop in H. destruct H as [A B]. constructor; [|apply IH, B]. destruct q as [s|n|x]; cbn in *.
  - apply String.eqb_eq, A.
  - destruct (natural t) as [m|]; [|discriminate]. apply N.eqb_eq in A. subst. reflexivity.
  - destruct (number_of t) as [y|]; [|discriminate]. apply same_equal in A. subst. reflexivity.
Qed.

Theorem accepts_sound text : accepts text = true ->
  exists c, states text c /\
    complete (about c) /\ proper (problem_of (about c)) /\ claims c <> [] /\ Forall (meaning (about c)) (claims c).
Proof.
  intros H. unfold accepts, judge in H. destruct (read text) as [| |c ts] eqn:R; try discriminate.
  destruct (spells_all ts (pieces c) && check c)%bool eqn:E; [|discriminate]. apply andb_prop in E. destruct E as [A B].
  exists c. split; [|apply check_sound, B]. exists ts. split; [|apply spells_all_spells, A].
  unfold read in R. destruct (tokens text) as [us|]; [|discriminate].
  destruct (read_header _ us) as [[[[name [mus [d f]]] [a k]] r]|]; [|destruct (unknown_form us); discriminate].
  destruct (at_word "law" r); [discriminate|].
  destruct (if at_word "no-answer" r then _ else _) as [[x r']|]; [|discriminate].
  destruct (some_claims _ _ _ _ _); try discriminate. inversion R; subst. reflexivity.
Qed.
