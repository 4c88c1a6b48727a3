(** The judge: from a claim, and statements that are proved, to a verdict. *)
From Coq Require Import String List Bool QArith Qreals.
Local Open Scope string_scope.
From Slipproof Require Import Text Syntax Meaning Normal Checker Print Sound.
From Slipproof.claim Require Import Expression Mechanism Claim Entails Covers Inline Points Obligations MotionForms Proved Refuted Canonical RunValues Run.
Import ListNotations.

(** A way is open if one of its goals is obvious, or shown by a statement. *)
Definition way_open (ss : list statement) (w : way) : bool := existsb (fun g => obvious g || existsb (covers g) ss) w.
Definition all_open (ss : list statement) (ws : option (list way)) : bool :=
  match ws with Some ws => forallb (way_open ss) ws | None => false end.

(** The cases that statements distinguish; the only one, if they distinguish none. *)
Fixpoint distinct (fs : list form) : list form :=
  match fs with [] => [] | f :: fs => if existsb (same_form f) fs then distinct fs else f :: distinct fs end.
Definition cells (ss : list statement) : list form :=
  match distinct (flat_map (fun s => cell_of (premises s) (Map.empty _)) ss) with [] => [All []] | fs => fs end.
Definition proves (c : claim) (ss : list statement) : bool := all_open ss (ways (inlined_claim c) (cells ss)).
Definition refutes (c : claim) (ss : list statement) : bool := all_open ss (refuting_ways (inlined_claim c)).

Lemma all_open_sound ss ws : all_open ss (Some ws) = true -> Forall meaning ss -> Forall way_holds ws.
Proof.
  simpl. intros O M. rewrite forallb_forall in O. apply Forall_forall. intros w I. specialize (O _ I). unfold way_open in O.
  apply existsb_exists in O. destruct O as [g [J O]]. unfold way_holds. apply Exists_exists. exists g. split; [exact J|].
  apply orb_true_iff in O. destruct O as [O|O]; [apply obvious_sound, O|]. apply existsb_exists in O. destruct O as [t [L C]].
  rewrite Forall_forall in M. exact (covers_sound g t C (M t L)).
Qed.

Lemma point_place c x : point (in_setting c) x -> place c x.
Proof. intro Q. unfold place. destruct (of_any_force (what c)); [exact (of_bicycle _ _ Q)|exact Q]. Qed.

Theorem proves_sound c ss : proves c ss = true -> Forall meaning ss -> proved c.
Proof.
  unfold proves. destruct (ways (inlined_claim c) (cells ss)) as [ws|] eqn:E; [|discriminate]. intros O M.
  assert (W := all_open_sound ss ws O M). apply inlined_proved. unfold proved, right_or_nothing, place.
  assert (V := ways_value _ _ ws E W). assert (P := ways_prove _ _ ws E W).
  destruct (what (inlined_claim c)) eqn:K; try (split; [intro; apply V; intros; discriminate|apply P; intros; discriminate]).
  exact (exists_proved _ _ _ ws K E W).
Qed.

Theorem refutes_sound c ss : refutes c ss = true -> Forall meaning ss -> refuted c.
Proof.
  unfold refutes. destruct (refuting_ways (inlined_claim c)) as [ws|] eqn:E; [|discriminate]. intros O M.
  assert (W := all_open_sound ss ws O M). apply inlined_refuted. unfold refuted. assert (R := ways_refute _ ws E W).
  destruct (what (inlined_claim c)) eqn:K;
    try (destruct R as [x [Q J]]; [intros; discriminate|]; exists x; split; [|exact J]; exact (point_place _ _ Q)).
  intros x Q. unfold place in Q. rewrite K in Q. exact (exists_refuted _ _ ws K E W x Q).
Qed.

(** With the texts of statements and certificates. *)
Definition accepted (texts : list (string * string)) : list statement :=
  flat_map (fun t => match read_statement (fst t) with
                     | Some r => if accepts_for r (snd t) then [read r] else []
                     | None => []
                     end) texts.

Lemma accepted_sound texts : Forall meaning (accepted texts).
Proof.
  unfold accepted. induction texts as [|[statement certificate] texts IH]; simpl; [constructor|].
  apply Forall_app. split; [|exact IH]. destruct (read_statement statement) as [r|] eqn:R; [|constructor].
  destruct (accepts_for r certificate) eqn:A; [|constructor]. constructor; [|constructor].
  unfold accepts_for in A. destruct (lines certificate) as [ls|]; [|discriminate].
  destruct (parse_certificate (read r) (print_of r) ls) as [p|]; [|discriminate].
  apply (check_sound (read r) p). unfold check. unfold read_statement in R. options R. inversion R; subst. simpl in *. now rewrite E2.
Qed.

(** With the text of the claims *)

Fixpoint same_list {A} (same : A -> A -> bool) (xs ys : list A) : bool :=
  match xs, ys with [], [] => true | x :: xs, y :: ys => same x y && same_list same xs ys | _, _ => false end.

Lemma same_list_eq {A} (same : A -> A -> bool) : (forall x y, same x y = true -> x = y) ->
  forall xs ys, same_list same xs ys = true -> xs = ys.
Proof.
  intros E xs. induction xs as [|x xs IH]; intros [|y ys] H; simpl in H; try discriminate; [reflexivity|].
  apply andb_true_iff in H. destruct H as [A' B]. f_equal; auto.
Qed.

Definition stated (text : string) (f : file) : bool :=
  match lines text with
  | Some (header :: body) =>
      String.eqb (raw header) "slipproof-claims 1" && same_list (same_list String.eqb) (map words body) (print_file f)
  | _ => false
  end.

Lemma stated_sound text f : stated text f = true -> states_claims text f.
Proof.
  unfold stated, states_claims. destruct (lines text) as [[|header body]|]; try discriminate. intro H. apply andb_true_iff in H.
  destruct H as [H B]. apply String.eqb_eq in H. exists header, body. repeat split; auto.
  revert B. apply same_list_eq. apply same_list_eq. intros x y E. apply String.eqb_eq, E.
Qed.

Inductive verdict := Proved | Refuted | Open.

(** At one of these rational points and forces the claim is seen to be wrong. *)
Definition is_wrong_at (c : claim) (q : list (string * Q)) : bool :=
  match what c, run c q with Claim.Exists _, _ => false | _, Some Wrong => true | _, _ => false end.

Lemma wrong_at_sound c qs : existsb (is_wrong_at c) qs = true -> refuted c.
Proof.
  intro H. apply existsb_exists in H. destruct H as [q [_ H]]. unfold is_wrong_at in H.
  destruct (run c q) as [o|] eqn:R; [|destruct (what c); discriminate]. apply run_sound in R. destruct R as [P J].
  unfold refuted. destruct (what c) eqn:K; try discriminate; destruct o; try discriminate; eauto.
Qed.

(** The verdict on a claim of a file, if the text states it. [texts] are those of statements and certificates; at [points]
    the claim may be wrong. *)
Definition judge (is_stated : bool) (f : file) (n : named_claim) (texts : list (string * string))
  (points : list (list (string * Q))) : verdict :=
  match claim_of f n with
  | Some c => if is_stated then
                let ss := accepted texts in
                if proves c ss then Proved else if refutes c ss || existsb (is_wrong_at c) points then Refuted else Open
              else Open
  | None => Open
  end.

(** What the verdicts say: the text states claims, of which this is one, and it is right or says nothing at every point,
    or wrong at one. *)
Theorem judge_sound text f n texts points :
  match judge (stated text f) f n texts points with
  | Proved => states_claims text f /\ exists c, claim_of f n = Some c /\ proved c
  | Refuted => states_claims text f /\ exists c, claim_of f n = Some c /\ refuted c
  | Open => True
  end.
Proof.
  unfold judge. destruct (claim_of f n) as [c|] eqn:C; [|exact I]. destruct (stated text f) eqn:S; [|exact I].
  destruct (proves c (accepted texts)) eqn:P; [|destruct (refutes c (accepted texts) || existsb (is_wrong_at c) points) eqn:R; [|exact I]].
  - split; [exact (stated_sound _ _ S)|]. exists c. split; [reflexivity|]. exact (proves_sound c _ P (accepted_sound texts)).
  - split; [exact (stated_sound _ _ S)|]. exists c. split; [reflexivity|]. apply orb_true_iff in R. destruct R as [R|R].
    + exact (refutes_sound c _ R (accepted_sound texts)).
    + exact (wrong_at_sound c points R).
Qed.
