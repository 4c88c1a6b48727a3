(** All modes of a mechanism that are modelled. *)
From Coq Require Import String List Bool ZArith Lia.
From Slipproof Require Import Text Syntax.
From Slipproof.claim Require Import Expression Mechanism Claim.
Import ListNotations.

Fixpoint choices (options : list (list state)) : list mode :=
  match options with [] => [[]] | states :: options => flat_map (fun st => map (cons st) (choices options)) states end.
Definition all_modes (given : list string) (m : mechanism) : list mode :=
  flat_map (fun front => map (fun back => front ++ back) (choices (map (rubbing_states (contacts m) front) (rubbings m))))
           (choices (map (contact_states given) (contacts m))).

Section Run.
Variable s : setting.
Notation m := (of_mechanism s).

Lemma state_in_In st states : state_in st states = true -> In st states.
Proof.
  unfold state_in. intro E. apply existsb_exists in E. destruct E as [t [J E]].
  assert (st = t) by (destruct st, t; try discriminate; reflexivity). now subst.
Qed.
Lemma of_contacts_choice given cs : forall md conds rest, of_contacts (strict s) given cs md = Some (conds, rest) ->
  exists front, md = front ++ rest /\ length front = length cs /\ In front (choices (map (contact_states given) cs)).
Proof.
  induction cs as [|c cs IH]; intros md conds rest H.
  - simpl in H. inversion H; subst. exists []. simpl. auto.
  - destruct md as [|st md]; simpl in H; [discriminate|]. options H. inversion H; subst. destruct p as [conds' rest']. simpl in *.
    destruct (IH _ _ _ E0) as [front [E1 [L J]]]. exists (st :: front). simpl. split; [congruence|]. split; [congruence|].
    apply in_flat_map. exists st. split; [apply state_in_In, E|]. apply in_map, J.
Qed.
Lemma rubbing_states_front cs front back r : length front = length cs -> rubbing_states cs (front ++ back) r = rubbing_states cs front r.
Proof.
  intro L. unfold rubbing_states. destruct (holder r) as [i|]; [|reflexivity]. destruct (nth_error cs i) eqn:E; [|reflexivity].
  rewrite nth_error_app1; [reflexivity|]. rewrite L. apply nth_error_Some. congruence.
Qed.
Lemma of_rubbings_choice cs front back rs : length front = length cs -> forall md conds,
  of_rubbings (strict s) cs (front ++ back) rs md = Some conds -> In md (choices (map (rubbing_states cs front) rs)).
Proof.
  intro L. induction rs as [|r rs IH]; intros md conds H; destruct md as [|st md]; simpl in H; try discriminate; [simpl; auto|].
  options H. simpl. apply in_flat_map. exists st. split; [|apply in_map; eauto].
  rewrite <- (rubbing_states_front cs front back r L). apply state_in_In, E.
Qed.
Lemma all_modes_sound x md u : motion s x md u -> In md (all_modes (given_parameters s) m).
Proof.
  intros [cs [E _]]. unfold mode_conditions in E. options E. destruct p as [conds rest]. simpl in *.
  destruct (of_contacts_choice _ _ _ _ _ E0) as [front [F [L J]]]. subst md. unfold all_modes. apply in_flat_map. exists front.
  split; [exact J|]. apply in_map. exact (of_rubbings_choice _ _ _ _ L _ _ E1).
Qed.
End Run.
