(** Conditions run: disjunctions of linear systems. *)
From Coq Require Import String List Bool ZArith QArith Qreals Reals Lra.
From Slipproof Require Import Text Syntax.
From Slipproof.claim Require Import Expression RunValues.
From Slipproof.claim Require Linear.
Import ListNotations.
Local Open Scope R_scope.

Notation system := (list (Linear.relation * linear)).

Section Conditions.
Variable names : scope.

(** A disjunction of systems; an empty system is true. [None]: unknown. *)
Definition certain (ss : list system) : bool := existsb (fun s => match s with [] => true | _ => false end) ss.
Definition atom (r : Linear.relation) (l : linear) : list system :=
  match constant_of l with Some q => if meets r q then [[]] else [] | None => [[(r, l)]] end.
Definition compared (l : linear) (r : rel) (m : linear) : list system :=
  let d := add l (opposed m) in
  let e := opposed d in
  match r with
  | Syntax.Lt => atom Linear.Positive e
  | Le => atom Linear.NonNegative e
  | Syntax.Eq => atom Linear.Zero d
  | Ne => atom Linear.Positive d ++ atom Linear.Positive e
  | Ge => atom Linear.NonNegative d
  | Syntax.Gt => atom Linear.Positive d
  end.
Definition contrary (r : rel) : rel :=
  match r with Syntax.Lt => Ge | Le => Syntax.Gt | Syntax.Eq => Ne | Ne => Syntax.Eq | Ge => Syntax.Lt | Syntax.Gt => Le end.

Definition both (x y : option (list system)) : option (list system) :=
  match x, y with
  | Some [], _ | _, Some [] => Some []
  | Some xs, Some ys => Some (flat_map (fun a => map (fun b => a ++ b) ys) xs)
  | _, _ => None
  end.
Definition either (x y : option (list system)) : option (list system) :=
  match x, y with
  | Some xs, Some ys => Some (xs ++ ys)
  | Some xs, None | None, Some xs => if certain xs then Some [[]] else None
  | None, None => None
  end.

Definition linked (truth : bool) (a : answer) (r : rel) (b : answer) : option (list system) :=
  match a, b with
  | Undefined, _ | _, Undefined => Some []
  | Affine l, Affine m => Some (compared l (if truth then r else contrary r) m)
  | _, _ => None
  end.
Fixpoint links_true (a : answer) (links : list (rel * term)) : option (list system) :=
  match links with
  | [] => Some [[]]
  | (r, e) :: rest => let b := answer_of names e in both (linked true a r b) (links_true b rest)
  end.
Fixpoint links_false (a : answer) (links : list (rel * term)) : option (list system) :=
  match links with
  | [] => Some []
  | (r, e) :: rest => let b := answer_of names e in either (linked false a r b) (links_false b rest)
  end.

(** Where the condition has this truth value. *)
Fixpoint where_it_is (truth : bool) (c : condition) : option (list system) :=
  match c with
  | Constant b => Some (if Bool.eqb b truth then [[]] else [])
  | Compare a links => if truth then links_true (answer_of names a) links else links_false (answer_of names a) links
  | Not c => where_it_is (negb truth) c
  | Both c d => if truth then both (where_it_is true c) (where_it_is true d) else either (where_it_is false c) (where_it_is false d)
  | Either c d => if truth then either (where_it_is true c) (where_it_is true d) else both (where_it_is false c) (where_it_is false d)
  end.
Definition where_all_are (cs : list condition) : option (list system) :=
  fold_right (fun c ss => both (where_it_is true c) ss) (Some [[]]) cs.

(** A condition without unknowns. *)
Inductive status := Yes | No | Neither | Unknown.
Definition decided (ss : option (list system)) : option bool :=
  match ss with Some [] => Some false | Some ss => if certain ss then Some true else None | None => None end.
Definition status_of (c : condition) : status :=
  match decided (where_it_is true c) with
  | Some true => Yes
  | Some false => match decided (where_it_is false c) with Some true => No | Some false => Neither | None => Unknown end
  | None => match decided (where_it_is false c) with Some true => No | _ => Unknown end
  end.
End Conditions.

(** Where none of these systems holds. *)
Definition contradicted (c : Linear.relation * linear) : list system :=
  match fst c with
  | Linear.Zero => [[(Linear.Positive, snd c)]; [(Linear.Positive, opposed (snd c))]]
  | Linear.Positive => [[(Linear.NonNegative, opposed (snd c))]]
  | Linear.NonNegative => [[(Linear.Positive, opposed (snd c))]]
  end.
Definition outside (ss : list system) : option (list system) :=
  fold_right (fun s rest => both (Some (flat_map contradicted s)) rest) (Some [[]]) ss.

(** Soundness *)

(** A condition is not both. *)
Lemma consistent names c : is names true c -> is names false c -> False.
Proof.
  assert (L : forall links a, links_hold names a links -> links_fail names a links -> False).
  { induction links as [|[r b] links IH]; intros a H F; simpl in *; [exact F|]. destruct H as [[v [w [X [Y C]]]] H].
    destruct F as [[v' [w' [X' [Y' N]]]]|F]; [|exact (IH b H F)]. congruence. }
  induction c as [b|a links|c IH|c IHc d IHd|c IHc d IHd]; simpl; intros T F; eauto.
  - congruence.
  - destruct T, F; auto.
  - destruct T, F; auto.
Qed.

(** It is true, or it is not. *)
Lemma true_or_not names c : forall truth, is names truth c \/ ~ is names truth c.
Proof.
  assert (L : forall truth a r b, link names truth a r b \/ ~ link names truth a r b).
  { intros truth a r b. unfold link. destruct (value names a) as [v|]; [|right; intros [? [? [E _]]]; discriminate].
    destruct (value names b) as [w|]; [|right; intros [? [? [_ [E _]]]]; discriminate].
    assert (D : compares v r w \/ ~ compares v r w) by (destruct r; simpl; lra).
    destruct D as [D|D], truth; try (left; exists v, w; auto; fail);
      (right; intros [? [? [E [F C]]]]; inversion E; inversion F; subst; auto). }
  induction c as [b|a links|c IH|c IHc d IHd|c IHc d IHd]; intro truth; cbn [is].
  - destruct b, truth; auto; right; discriminate.
  - revert a. induction links as [|[r b] links IH]; intro a; destruct truth; simpl; auto.
    + destruct (L true a r b), (IH b); tauto.
    + destruct (L false a r b), (IH b); tauto.
  - apply IH.
  - destruct truth; [destruct (IHc true), (IHd true)|destruct (IHc false), (IHd false)]; tauto.
  - destruct truth; [destruct (IHc true), (IHd true)|destruct (IHc false), (IHd false)]; tauto.
Qed.

Section Sound.
Variable z : nat -> R.
Notation val := (affine_value z).
Notation means := (means z).

Section Names.
Variable names : scope.
Variable meant : meanings.
Hypothesis agree : forall name, means (names name) (meant name).

Definition some_hold (ss : list system) : Prop := Exists (Forall (Linear.holds z)) ss.
Definition says (d : option (list system)) (P : Prop) : Prop := match d with Some ss => some_hold ss <-> P | None => True end.

Lemma certain_holds ss : certain ss = true -> some_hold ss.
Proof.
  intro H. apply existsb_exists in H. destruct H as [[|c s] [I H]]; [|discriminate]. apply Exists_exists. exists []. auto.
Qed.
Lemma some_hold_empty : some_hold [[]].
Proof. apply Exists_cons_hd. constructor. Qed.

Lemma atom_sound r l : some_hold (atom r l) <-> Linear.meets r (val l).
Proof.
  unfold atom, some_hold. destruct (constant_of l) as [q|] eqn:E.
  - rewrite (constant_of_value z _ _ E), <- meets_real. destruct (meets r q); rewrite ?Exists_cons, Exists_nil.
    + split; auto.
    + split; [tauto|discriminate].
  - rewrite Exists_cons, Exists_nil. split.
    + intros [H|[]]. inversion H; subst. assumption.
    + intro H. left. constructor; [exact H|constructor].
Qed.
Lemma some_hold_app xs ys : some_hold (xs ++ ys) <-> some_hold xs \/ some_hold ys.
Proof. apply Exists_app. Qed.

Lemma compared_sound l r m : some_hold (compared l r m) <-> compares (val l) r (val m).
Proof.
  unfold compared. destruct r; rewrite ?some_hold_app, !atom_sound; simpl; rewrite ?opposed_value, ?add_value, ?opposed_value; lra.
Qed.
Lemma contrary_sound x r y : compares x (contrary r) y <-> ~ compares x r y.
Proof. destruct r; simpl; lra. Qed.

Lemma both_holds xs ys : some_hold (flat_map (fun a => map (fun b => a ++ b) ys) xs) <-> some_hold xs /\ some_hold ys.
Proof.
  unfold some_hold. rewrite !Exists_exists. split.
  - intros [s [I H]]. apply in_flat_map in I. destruct I as [a [J I]]. apply in_map_iff in I. destruct I as [b [E I]]. subst.
    apply Forall_app in H. destruct H as [A B]. split; eauto.
  - intros [[a [I A]] [b [J B]]]. exists (a ++ b). split; [|apply Forall_app; auto]. apply in_flat_map. exists a. split; [exact I|].
    apply in_map_iff. eauto.
Qed.
Lemma none_holds : ~ some_hold [].
Proof. unfold some_hold. rewrite Exists_nil. tauto. Qed.

(** The second need only be known where the first is true. *)
Lemma both_sound_under x y P Q : says x P -> (P -> says y Q) -> says (both x y) (P /\ Q).
Proof.
  intros A B. assert (N := none_holds). unfold both, says in *.
  destruct x as [[|a xs]|], y as [[|b ys]|]; rewrite ?both_holds; tauto.
Qed.
Lemma both_sound x y P Q : says x P -> says y Q -> says (both x y) (P /\ Q).
Proof. intros A B. apply both_sound_under; auto. Qed.
Lemma either_sound x y P Q : says x P -> says y Q -> says (either x y) (P \/ Q).
Proof.
  intros A B. assert (E := some_hold_empty). unfold either, says in *. destruct x as [xs|], y as [ys|]; rewrite ?some_hold_app; try tauto.
  - destruct (certain xs) eqn:C; [|exact I]. apply certain_holds in C. tauto.
  - destruct (certain ys) eqn:C; [|exact I]. apply certain_holds in C. tauto.
Qed.

Lemma linked_sound (truth : bool) a r b e f : means a (value meant e) -> means b (value meant f) ->
  says (linked truth a r b) (link meant truth e r f).
Proof.
  intros A B. unfold linked, link. assert (N := none_holds).
  assert (U : value meant e = None \/ value meant f = None -> says (Some [])
      (exists x y, value meant e = Some x /\ value meant f = Some y /\ (if truth then compares x r y else ~ compares x r y))).
  { simpl. intro U. split; [tauto|]. intros [x [y [X [Y _]]]]. destruct U; congruence. }
  destruct a as [| |l], b as [| |m]; simpl in A, B; try exact I; try (apply U; tauto).
  simpl. rewrite compared_sound. rewrite A, B. destruct truth.
  - split; [eauto|]. intros [x [y [X [Y C]]]]. inversion X; inversion Y; subst. exact C.
  - rewrite contrary_sound. split; [eauto|]. intros [x [y [X [Y C]]]]. inversion X; inversion Y; subst. exact C.
Qed.

Lemma links_sound links : forall a e, means a (value meant e) ->
  says (links_true names a links) (links_hold meant e links) /\ says (links_false names a links) (links_fail meant e links).
Proof.
  induction links as [|[r b] links IH]; intros a e A; simpl.
  - assert (E := some_hold_empty). assert (N := none_holds). tauto.
  - assert (B := answer_means z names meant agree b). destruct (IH _ _ B). split; [apply both_sound|apply either_sound]; auto; now apply linked_sound.
Qed.

Lemma where_sound c : forall truth, says (where_it_is names truth c) (is meant truth c).
Proof.
  induction c as [b|a links|c IH|c IHc d IHd|c IHc d IHd]; intro truth; cbn [where_it_is is].
  - assert (E := some_hold_empty). assert (N := none_holds). destruct b, truth; simpl; split; try tauto; discriminate.
  - destruct (links_sound links _ _ (answer_means z names meant agree a)). now destruct truth.
  - apply IH.
  - destruct truth; [apply both_sound|apply either_sound]; auto.
  - destruct truth; [apply either_sound|apply both_sound]; auto.
Qed.
Lemma where_all_sound cs : says (where_all_are names cs) (Forall (is meant true) cs).
Proof.
  induction cs as [|c cs IH]; simpl.
  - split; [constructor|]. intros _. apply some_hold_empty.
  - assert (B := both_sound _ _ _ _ (where_sound c true) IH). unfold where_all_are in B. simpl in *.
    destruct (both _ _); [|exact I]. simpl in *. rewrite B. split; [intros []; now constructor|]. intro F. inversion F. auto.
Qed.

Lemma decided_sound d P : says d P -> match decided d with Some true => P | Some false => ~ P | None => True end.
Proof.
  unfold decided, says. assert (N := none_holds). destruct d as [[|s ss]|]; auto; [tauto|].
  destruct (certain (s :: ss)) eqn:C; [|auto]. apply certain_holds in C. tauto.
Qed.
Lemma status_sound c : match status_of names c with
  | Yes => is meant true c | No => is meant false c | Neither => ~ has_value meant c | Unknown => True end.
Proof.
  unfold status_of, has_value. assert (A := decided_sound _ _ (where_sound c true)). assert (B := decided_sound _ _ (where_sound c false)).
  destruct (decided (where_it_is names true c)) as [[|]|], (decided (where_it_is names false c)) as [[|]|]; tauto.
Qed.
End Names.

Lemma contradicted_sound c : some_hold (contradicted c) <-> ~ Linear.holds z c.
Proof.
  destruct c as [r l]. unfold contradicted, some_hold, Linear.holds; simpl.
  assert (S : forall k, Forall (Linear.holds z) [k] <-> Linear.holds z k).
  { intro k. split; [intro F; inversion F; assumption|]. intro H. constructor; [exact H|constructor]. }
  destruct r; rewrite !Exists_cons, Exists_nil, !S; unfold Linear.holds; simpl; rewrite opposed_value; lra.
Qed.
Lemma outside_sound ss : says (outside ss) (~ some_hold ss).
Proof.
  induction ss as [|s ss IH]; simpl.
  - assert (N := none_holds). assert (E := some_hold_empty). tauto.
  - assert (A : says (Some (flat_map contradicted s)) (~ Forall (Linear.holds z) s)).
    { simpl. clear IH ss. induction s as [|c s IH]; simpl.
      - assert (N := none_holds). split; [tauto|]. intro H. exfalso. apply H. constructor.
      - rewrite some_hold_app, contradicted_sound, IH. assert (D : Linear.holds z c \/ ~ Linear.holds z c).
        { destruct c as [r l]. destruct r; unfold Linear.holds; simpl; lra. }
        split; [intros H F; inversion F; tauto|]. intro H. destruct D; [right|tauto]. intro F. apply H. now constructor. }
    assert (B := both_sound _ _ _ _ A IH). unfold outside in B. simpl in B. unfold says in *.
    destruct (match flat_map contradicted s with [] => _ | _ => _ end); [|exact I]. unfold some_hold in *. rewrite B, Exists_cons. tauto.
Qed.
End Sound.
