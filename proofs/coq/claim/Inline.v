(** Definitions without a normal form, as those with a minimum in them, in the place of their names; it does not change
    what is judged. *)
From Coq Require Import String List Bool ZArith Reals.
From Slipproof Require Import Text Syntax Normal.
From Slipproof.claim Require Import Expression Mechanism Claim Forms FormsSound Covers Scopes.
Import ListNotations.

Section Inline.
Variable ds : list (string * term).
Fixpoint inline (e : term) : term :=
  match e with
  | Number _ => e
  | Symbol name => match find (fun d => String.eqb (fst d) name) ds with Some d => snd d | None => e end
  | Minus a => Minus (inline a)
  | Plus a b => Plus (inline a) (inline b)
  | Difference a b => Difference (inline a) (inline b)
  | Product a b => Product (inline a) (inline b)
  | Quotient a b => Quotient (inline a) (inline b)
  | Power a k => Power (inline a) k
  | Absolute a => Absolute (inline a)
  | Signum a => Signum (inline a)
  | Minimum a b => Minimum (inline a) (inline b)
  | Maximum a b => Maximum (inline a) (inline b)
  end.
Fixpoint inline_in (c : condition) : condition :=
  match c with
  | Constant b => Constant b
  | Compare a links => Compare (inline a) (map (fun l => (fst l, inline (snd l))) links)
  | Not c => Not (inline_in c)
  | Both c d => Both (inline_in c) (inline_in d)
  | Either c d => Either (inline_in c) (inline_in d)
  end.
End Inline.

(** A definition whose own numbers, and whose name, have no other definition later. *)
Fixpoint inlinable (wanted : string -> bool) (ds : list (string * term)) : list (string * term) :=
  match ds with
  | [] => []
  | (name, e) :: after =>
      (if wanted name && negb (is_in name (map fst after)) && negb (mentions (name :: map fst after) e) then [(name, e)] else [])
      ++ inlinable wanted after
  end.
Definition without_form (s : setting) (name : string) : bool :=
  match Map.find name (paper_scope s None) with Some _ => false | None => true end.
Definition inlined (s : setting) (c : condition) : condition :=
  let ds := inlinable (without_form s) (paper_definitions s) in Nat.iter (length ds) (inline_in ds) c.

(** A claim that a limit is at the end of a parameter is about other points, too: it is left as it is. *)
Definition inlined_claim (c : claim) : claim :=
  match what c with
  | Limit _ _ _ => c
  | _ => let s := in_setting c in Claim s (what c) (inlined s (region c)) (inlined s (at_forces c))
  end.

(** Soundness *)

(** A number depends on the numbers in it. *)
Lemma mentions_value (n k : meanings) e : (forall name, mentions [name] e = true -> n name = k name) -> value n e = value k e.
Proof.
  induction e as [i|name|a IH|a IHa b IHb|a IHa b IHb|a IHa b IHb|a IHa b IHb|a IH i|a IH|a IH|a IHa b IHb|a IHa b IHb];
    intro H; simpl in *;
    try (rewrite IHa by (intros name M; apply H; now rewrite M); rewrite IHb by (intros name M; apply H; rewrite M; apply orb_true_r));
    try (rewrite IH by (intros name M; apply H; exact M)); try reflexivity.
  apply H. now rewrite String.eqb_refl.
Qed.

Lemma mentions_some names e : forall name, In name names -> mentions [name] e = true -> mentions names e = true.
Proof.
  intros name I. induction e; simpl; intro M; auto; try (apply orb_true_iff in M; apply orb_true_iff; destruct M; auto).
  rewrite orb_false_r in M. apply String.eqb_eq in M. subst. apply is_in_In, I.
Qed.

Lemma define_other ds name : ~ In name (map fst ds) -> forall names, define ds names name = names name.
Proof.
  unfold define. induction ds as [|[n e] ds IH]; simpl; intros N names; [reflexivity|].
  rewrite IH by tauto. unfold with_name. destruct (String.eqb_spec name n); [subst; tauto|reflexivity].
Qed.

Lemma inlinable_value wanted ds : forall names name e, In (name, e) (inlinable wanted ds) ->
  define ds names name = value (define ds names) e.
Proof.
  induction ds as [|[n d] ds IH]; intros names name e I; simpl in I; [contradiction|]. apply in_app_or in I. destruct I as [I|I].
  - destruct (_ && _) eqn:W in I; [|contradiction]. destruct I as [I|[]]. inversion I; subst. clear I.
    apply andb_true_iff in W. destruct W as [W M]. apply andb_true_iff in W. destruct W as [_ N]. apply negb_true_iff in N, M.
    assert (N' : ~ In name (map fst ds)) by (intro J; apply is_in_In in J; congruence).
    change (define ds (with_name name (value names e) names) name = value (define ds (with_name name (value names e) names)) e).
    rewrite define_other by exact N'. unfold with_name at 1. rewrite String.eqb_refl. apply mentions_value. intros k K.
    assert (O : ~ In k (name :: map fst ds)) by (intro J; rewrite (mentions_some _ e k J K) in M; discriminate).
    rewrite define_other by (intro J; apply O; now right). unfold with_name.
    destruct (String.eqb_spec k name); [subst; destruct O; now left|reflexivity].
  - exact (IH _ name e I).
Qed.

Lemma inline_value names ds e : (forall name d, In (name, d) ds -> names name = value names d) -> value names (inline ds e) = value names e.
Proof.
  intro H. induction e as [i|name|a IH|a IHa b IHb|a IHa b IHb|a IHa b IHb|a IHa b IHb|a IH i|a IH|a IH|a IHa b IHb|a IHa b IHb];
    simpl; try (rewrite IHa, IHb); try (rewrite IH); try reflexivity.
  destruct (find _ ds) as [[n d]|] eqn:F; [|reflexivity]. apply find_some in F. destruct F as [I E]. simpl in *.
  apply String.eqb_eq in E. subst. symmetry. exact (H _ _ I).
Qed.

(** The same statement, not only one that is true where the other is. *)
Lemma inline_is names ds c : (forall name d, In (name, d) ds -> names name = value names d) ->
  forall truth, is names truth (inline_in ds c) = is names truth c.
Proof.
  intro H. assert (V := inline_value names ds). induction c as [b|a links|c IH|c IHc d IHd|c IHc d IHd]; intro truth; cbn [is inline_in].
  - reflexivity.
  - revert a. induction links as [|[r b] links IH]; intro a; [reflexivity|]. specialize (IH b).
    destruct truth; simpl in *; rewrite IH; unfold link; rewrite !V by exact H; reflexivity.
  - apply IH.
  - destruct truth; rewrite IHc, IHd; reflexivity.
  - destruct truth; rewrite IHc, IHd; reflexivity.
Qed.

Lemma inlined_is s x c truth : is (paper s x) truth (inlined s c) = is (paper s x) truth c.
Proof.
  unfold inlined. induction (length _) as [|n IH]; [reflexivity|]. simpl. rewrite inline_is; [exact IH|].
  intros name d I. exact (inlinable_value _ _ _ name d I).
Qed.

Lemma inlined_setting c : in_setting (inlined_claim c) = in_setting c.
Proof. unfold inlined_claim. destruct (what c); reflexivity. Qed.
Lemma inlined_what c : what (inlined_claim c) = what c.
Proof. unfold inlined_claim. destruct (what c) eqn:K; auto. Qed.

Lemma inlined_judged c x o : judged (inlined_claim c) x o = judged c x o.
Proof.
  assert (F := fun truth => inlined_is (in_setting c) x (at_forces c) truth).
  assert (R := fun truth => inlined_is (in_setting c) x (region c) truth).
  unfold inlined_claim. destruct (what c) eqn:K; try reflexivity;
    destruct o; unfold judged, judged_where, no_value_here, wrong_anyway, right_here, nothing_here, has_value; simpl; rewrite K;
    rewrite ?F, ?R; try reflexivity; unfold right_here; simpl; rewrite K, ?F; reflexivity.
Qed.

Lemma inlined_valued_at c x : valued_at (inlined_claim c) x = valued_at c x.
Proof.
  assert (R := fun truth => inlined_is (in_setting c) x (region c) truth).
  unfold inlined_claim. destruct (what c) eqn:K; try reflexivity; unfold valued_at, has_value; simpl; rewrite K, ?R; reflexivity.
Qed.

(** What is proved of the one claim, and refuted, is so of the other. *)
Lemma inlined_place c x : place (inlined_claim c) x = place c x.
Proof. unfold place. now rewrite inlined_what, inlined_setting. Qed.
Lemma inlined_proved c : proved (inlined_claim c) -> proved c.
Proof.
  assert (A : right_or_nothing (inlined_claim c) -> right_or_nothing c).
  { intros P x B. rewrite <- inlined_place in B. specialize (P x B). now rewrite !inlined_judged in P. }
  unfold proved. rewrite inlined_what, inlined_setting. destruct (what c) eqn:K.
  all: try (intros [V P]; split; [|exact (A P)]; intros F x B; rewrite <- inlined_valued_at; exact (V F x B)).
  intros [x [B P]]. exists x. rewrite inlined_place in B. now rewrite inlined_judged in P.
Qed.
Lemma inlined_refuted c : refuted (inlined_claim c) -> refuted c.
Proof.
  unfold refuted. rewrite inlined_what. destruct (what c) eqn:K; intro P.
  all: try (destruct P as [x [B P]]; exists x; rewrite inlined_place in B; now rewrite inlined_judged in P).
  intros x B. rewrite <- inlined_place in B. specialize (P x B). now rewrite inlined_judged in P.
Qed.
