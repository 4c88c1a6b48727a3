(** What has to be shown of a claim, as goals, and when a statement shows one: it assumes nothing but what plainly follows
    from the facts, and what it shows plainly gives the goal. *)
From Coq Require Import String List Bool ZArith Reals.
From Slipproof Require Import Text Syntax Meaning Poly Normal NormalSound Checker Sound.
From Slipproof.claim Require Import Forms FormsSound Entails.
Import ListNotations.

(** For all values of the variables with these facts there are some of [unknowns] with which [shown] holds. *)
Record goal := Goal { facts : list form; some : list string; shown : form }.

Definition goal_holds (g : goal) : Prop :=
  forall v, Forall (holds v) (facts g) ->
  match some g with
  | [] => holds v (shown g)
  | _ => exists w, (forall name, ~ In name (some g) -> w (code name) = v (code name)) /\ holds w (shown g)
  end.

Lemma goal_near g v : goal_holds g -> Forall (holds v) (facts g) ->
  exists w, (forall name, ~ In name (some g) -> w (code name) = v (code name)) /\ holds w (shown g).
Proof. intros G F. specialize (G v F). destruct (some g); [exists v; auto|exact G]. Qed.

Definition is_in (name : string) (names : list string) : bool := existsb (String.eqb name) names.

Section Covers.
Variable g : goal.

Definition give_symbols (names : list string) (scope : Normal.scope) : Normal.scope :=
  fold_left (fun scope name => Map.add name (Normal.Value (symbol name)) scope) names scope.

Fixpoint take (ps : list premise) (names : Normal.scope) : option Normal.scope :=
  match ps with
  | [] => Some names
  | Real new :: rest => require forallb (fun name => negb (is_in name (some g))) new in take rest (give_symbols new names)
  | Abbreviate a :: rest => let* names := Normal.abbreviate names a in take rest names
  | Assume _ f :: rest =>
      let* h := normal_formula names f in
      require entails (facts g) h in take rest names
  end.

(** What a statement assumes as "cell": one of several cases, of which it is about this one. Nothing rests on it. *)
Fixpoint cell_of (ps : list premise) (names : Normal.scope) : list form :=
  match ps with
  | [] => []
  | Real new :: rest => cell_of rest (give_symbols new names)
  | Abbreviate a :: rest => match Normal.abbreviate names a with Some names => cell_of rest names | None => [] end
  | Assume name f :: rest =>
      (if String.eqb name "cell" then match normal_formula names f with Some h => [h] | None => [] end else [])
      ++ cell_of rest names
  end.

Definition covers (s : statement) : bool :=
  match take (premises s) (Map.empty _) with
  | None => false
  | Some names =>
      forallb (fun name => is_in name (some g)) (Syntax.unknowns s)
      && match normal_shown (conclusion s) (abbreviations s) (give_symbols (Syntax.unknowns s) names) with
         | Some h => entails (h :: match some g with [] => facts g | _ => [] end) (shown g)
         | None => false
         end
  end.

(** It follows without a statement. *)
Definition obvious : bool := match some g with [] => entails (facts g) (shown g) | _ => false end.
End Covers.

(** Soundness *)

Lemma is_in_In name names : is_in name names = true <-> In name names.
Proof.
  unfold is_in. rewrite existsb_exists. split.
  - intros [x [I E]]. apply String.eqb_eq in E. now subst.
  - intro I. exists name. split; [exact I|apply String.eqb_refl].
Qed.

Section Sound.
Variable g : goal.
Variable v : positive -> R.
Hypothesis facts_hold : Forall (holds v) (facts g).

(** The values that differ from [v] in [some] only. *)
Definition near (w : positive -> R) : Prop := forall name, ~ In name (some g) -> w (code name) = v (code name).
Definition all_agree (names : Normal.scope) (meant : Meaning.scope) : Prop := forall w, near w -> agree w names meant.

Lemma stands_represents w name x : x name = w (code name) ->
  represents w (symbol name) (Quantity True (x name)).
Proof.
  intro E. rewrite E. assert (S := stands_symbol w name). apply represents_some in S. exact S.
Qed.

Lemma give_symbols_agree w x names : forall meant scope, agree w scope meant ->
  (forall name, In name names -> x name = w (code name)) ->
  agree w (give_symbols names scope) (give x names meant).
Proof.
  induction names as [|name names IH]; intros meant scope A E; simpl; [exact A|].
  apply IH; [|intros other I; apply E; now right].
  apply agree_bind; [exact A|]. apply stands_represents, E. now left.
Qed.

Lemma near_self : near v.
Proof. intros name _. reflexivity. Qed.

Lemma take_sound (x := fun name => v (code name)) conclude ps : forall names meant last,
  take g ps names = Some last -> all_agree names meant -> under x ps meant conclude ->
  exists meant', all_agree last meant' /\ conclude meant'.
Proof.
  induction ps as [|[new|a|name f] ps IH]; intros names meant last T A U; simpl in T, U.
  - inversion T; subst. eauto.
  - options T. eapply IH; [exact T| |exact U]. intros w N. apply give_symbols_agree; [apply A, N|].
    intros name I. symmetry. apply N. rewrite forallb_forall in E. specialize (E _ I). intro J.
    apply is_in_In in J. rewrite J in E. discriminate.
  - options T. destruct (abbreviate_sound v _ _ (A _ near_self) _ _ E) as [wider [W _]]. rewrite W in U.
    eapply IH; [exact T| |exact U]. intros w N. destruct (abbreviate_sound w _ _ (A _ N) _ _ E) as [wider' [W' B]].
    rewrite W in W'. inversion W'; subst. exact B.
  - options T. destruct (normal_formula_sound v _ _ (A _ near_self) _ _ E) as [P [F H]]. rewrite F in U.
    eapply IH; [exact T|exact A|]. apply U, H. exact (entails_sound v _ _ E0 facts_hold).
Qed.
End Sound.

Theorem covers_sound g s : covers g s = true -> meaning s -> goal_holds g.
Proof.
  intros C M v F. unfold covers in C. destruct (take g (premises s) (Map.empty _)) as [names|] eqn:T; [|discriminate].
  apply andb_true_iff in C. destruct C as [U C].
  destruct (normal_shown _ _ _) as [h|] eqn:N; [|discriminate].
  assert (E : all_agree g v (Map.empty _) nothing).
  { intros w _ name e K. discriminate K. }
  destruct (take_sound g v F _ _ _ _ _ T E (M (fun name => v (code name)))) as [meant [A [y Y]]].
  set (w := fun p => if is_in (decode p) (Syntax.unknowns s) then y (decode p) else v p).
  assert (W : near g v w).
  { intros name I. unfold w. rewrite decode_code. destruct (is_in name (Syntax.unknowns s)) eqn:J; [|reflexivity].
    apply is_in_In in J. rewrite forallb_forall in U. specialize (U _ J). apply is_in_In in U. contradiction. }
  assert (B : agree w (give_symbols (Syntax.unknowns s) names) (give y (Syntax.unknowns s) meant)).
  { apply give_symbols_agree; [apply A, W|]. intros name I. unfold w. rewrite decode_code.
    apply is_in_In in I. now rewrite I. }
  assert (H : holds w h) by (apply (normal_shown_sound w _ _ _ _ _ N B), Y).
  destruct (some g) as [|u us] eqn:S.
  - apply (entails_sound v _ _ C). constructor; [|exact F].
    assert (V : holds v h).
    { (* without unknowns, w is v *)
      destruct (Syntax.unknowns s) as [|n ns]; [exact H|]. simpl in U. discriminate U. }
    exact V.
  - exists w. split; [intros name I; apply W; rewrite S; exact I|].
    apply (entails_sound w _ _ C). repeat constructor. exact H.
Qed.

Lemma obvious_sound g : obvious g = true -> goal_holds g.
Proof.
  unfold obvious. destruct (some g) eqn:S; [|discriminate]. intros O v F. rewrite S. exact (entails_sound v _ _ O F).
Qed.
