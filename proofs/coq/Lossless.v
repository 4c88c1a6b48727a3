(** Nothing of a text gets lost or comes to it: its lines, put together again, are the text, and the tokens of a line,
    put together again, are the line but for its blanks. *)
From Coq Require Import Ascii String List Bool Lia.
From Slipproof Require Import Text.
Import ListNotations.
Local Open Scope string_scope.

Fixpoint together (parts : list string) : string := match parts with [] => "" | s :: rest => s ++ together rest end.

Definition line_feed : string := String "010" "".

Fixpoint without_blanks (s : string) : string :=
  match s with
  | EmptyString => ""
  | String c rest => match kind_of c with Blank => without_blanks rest | _ => String c (without_blanks rest) end
  end.

Lemma append_assoc a b c : (a ++ b) ++ c = a ++ (b ++ c).
Proof. induction a as [|x a IH]; simpl; congruence. Qed.

Lemma append_empty a : a ++ "" = a.
Proof. induction a as [|x a IH]; simpl; congruence. Qed.

Lemma together_app a b : together (a ++ b)%list = together a ++ together b.
Proof. induction a as [|s a IH]; simpl; [reflexivity|]. now rewrite IH, append_assoc. Qed.

Lemma reverse_onto_append s : forall t, reverse_onto s t = reverse s ++ t.
Proof.
  unfold reverse. induction s as [|c s IH]; intro t; simpl; [reflexivity|].
  now rewrite IH, (IH (String c "")), append_assoc.
Qed.

Lemma reverse_cons c s : reverse (String c s) = reverse s ++ String c "".
Proof. unfold reverse at 1. simpl. apply reverse_onto_append. Qed.

Lemma together_finish word done : together (rev (finish_word word done)) = together (rev done) ++ reverse word.
Proof.
  destruct word as [|c word]; simpl finish_word.
  - now rewrite append_empty.
  - simpl rev. rewrite together_app. simpl together. now rewrite append_empty.
Qed.

Lemma tokens_together n : forall line word done ts, String.length line <= n -> tokens line word done = Some ts ->
  together ts = together (rev done) ++ reverse word ++ without_blanks line.
Proof.
  induction n as [|n IH]; intros [|c rest] word done ts L T; simpl in L; try lia; cbn [tokens] in T.
  1, 2: inversion T; unfold rev'; rewrite <- rev_alt, together_finish; simpl; now rewrite append_empty.
  assert (single : forall ts, tokens rest "" (String c "" :: finish_word word done) = Some ts ->
            together ts = together (rev done) ++ reverse word ++ String c (without_blanks rest)).
  { intros us U. apply IH in U; [|lia]. rewrite U. simpl rev. rewrite together_app, together_finish. simpl.
    rewrite !append_assoc. reflexivity. }
  simpl without_blanks. destruct (kind_of c) eqn:K; try discriminate.
  1, 2, 3: apply IH in T; [|lia]; rewrite T, reverse_cons, !append_assoc; reflexivity.
  - apply IH in T; [|lia]. rewrite T, together_finish, !append_assoc. reflexivity.
  - destruct rest as [|d after]; [now apply single|].
    destruct (before_equals c && Ascii.eqb d "=")%bool eqn:E; [|now apply single].
    apply andb_true_iff in E. destruct E as [_ E]. apply Ascii.eqb_eq in E. subst d.
    apply IH in T; [|simpl in L; lia]. rewrite T. simpl rev. rewrite together_app, together_finish. simpl.
    rewrite !append_assoc. reflexivity.
Qed.

Theorem tokens_lossless line ts : tokens line "" [] = Some ts -> together ts = without_blanks line.
Proof. intro T. now rewrite (tokens_together _ _ _ _ _ (le_n _) T). Qed.

Lemma line_feed_only c : kind_of c = LineFeed -> c = "010"%char.
Proof. destruct c as [[] [] [] [] [] [] [] []]; simpl; try discriminate; reflexivity. Qed.

Lemma split_together text : forall line done, exists ending, (ending = "" \/ ending = line_feed) /\
  together (map (fun l => l ++ line_feed) (split_lines text line done))
  = together (map (fun l => l ++ line_feed) (rev done)) ++ reverse line ++ text ++ ending.
Proof.
  induction text as [|c text IH]; intros line done; cbn [split_lines].
  - unfold rev'. rewrite <- rev_alt. destruct line as [|c line].
    + exists "". split; [now left|]. simpl. now rewrite append_empty.
    + exists line_feed. split; [now right|]. simpl rev. rewrite map_app, together_app. simpl together.
      now rewrite append_empty.
  - destruct (kind_of c) eqn:K; try (destruct (IH (String c line) done) as [e [E T]]; exists e; split; [exact E|];
      rewrite T, reverse_cons, !append_assoc; reflexivity).
    apply line_feed_only in K. subst c. destruct (IH "" (reverse line :: done)) as [e [E T]]. exists e. split; [exact E|].
    rewrite T. simpl rev. rewrite map_app, together_app. simpl together. rewrite !append_assoc. reflexivity.
Qed.

Theorem lines_lossless text : exists ending, (ending = "" \/ ending = line_feed) /\
  together (map (fun l => l ++ line_feed) (split_lines text "" [])) = text ++ ending.
Proof. exact (split_together text "" []). Qed.
