(** Forms that stay true where one variable grows: as the conditions of a point, with a parameter that has no upper end. *)
From Coq Require Import String List Bool ZArith Reals Lra Lia.
From Slipproof Require Import Text Syntax Meaning Poly Normal NormalSound.
From Slipproof.claim Require Import Expression Mechanism Claim Forms FormsSound Entails Covers Scopes Points.
Import ListNotations.

(** The variable stands alone in its monomial, with a positive coefficient. *)
Fixpoint rising_poly (k : positive) (p : poly) : bool :=
  match p with
  | Nil => true
  | Poly.Plus c m p =>
      (mono_free [k] m || Z.leb 0 c && match m with Times v 1 One => Pos.eqb v k | _ => false end) && rising_poly k p
  end.
Fixpoint rising (k : positive) (f : form) : bool :=
  match f with
  | Atom Zero p => poly_free [k] p
  | Atom _ p => rising_poly k p
  | All fs | Any fs => forallb (rising k) fs
  end.

(** Facts of which each is rising, or follows from those that are. *)
Definition all_rising (k : positive) (facts : list form) : bool :=
  let up := filter (rising k) facts in forallb (fun f => rising k f || entails up f) facts.

Local Open Scope R_scope.

Section Sound.
Variable k : positive.
Variables v w : positive -> R.
Hypothesis others : forall q, ~ In q [k] -> v q = w q.
Hypothesis grows : v k <= w k.

Lemma rising_poly_value p : rising_poly k p = true -> value_at v p <= value_at w p.
Proof.
  induction p as [|c m p IH]; simpl; intro H; [lra|]. apply andb_true_iff in H. destruct H as [H R]. specialize (IH R).
  apply orb_true_iff in H. destruct H as [H|H].
  - rewrite (mono_free_value [k] v w m H others). lra.
  - apply andb_true_iff in H. destruct H as [C H]. apply Z.leb_le, IZR_le in C.
    destruct m as [|u e m]; [discriminate|]. destruct e; try discriminate. destruct m; [|discriminate].
    apply Pos.eqb_eq in H. subst u. simpl. nra.
Qed.

Lemma rising_holds f : rising k f = true -> holds v f -> holds w f.
Proof.
  induction f as [s p|fs IH|fs IH] using form_nested_ind; intros R H; simpl in R.
  - destruct s; [simpl in H |- *; rewrite <- (poly_free_value [k] v w p R others)| |]; try exact H;
      assert (L := rising_poly_value p R); simpl in *; lra.
  - rewrite Forall_forall in IH. rewrite forallb_forall in R. apply holds_all, Forall_forall. apply holds_all in H.
    rewrite Forall_forall in H. auto.
  - rewrite Forall_forall in IH. rewrite forallb_forall in R. apply holds_any, Exists_exists. apply holds_any, Exists_exists in H.
    destruct H as [f [I H]]. exists f. auto.
Qed.
End Sound.

Lemma all_rising_hold k v w facts : (forall q, ~ In q [k] -> v q = w q) -> v k <= w k -> all_rising k facts = true ->
  Forall (holds v) facts -> Forall (holds w) facts.
Proof.
  intros O L R H. unfold all_rising in R. rewrite forallb_forall in R. rewrite Forall_forall in H.
  assert (Up : Forall (holds w) (filter (rising k) facts)).
  { apply Forall_forall. intros f I. apply filter_In in I. destruct I as [I U]. exact (rising_holds k v w O L f U (H f I)). }
  apply Forall_forall. intros f I. specialize (R f I). apply orb_true_iff in R. destruct R as [R|R].
  - exact (rising_holds k v w O L f R (H f I)).
  - exact (entails_sound w _ _ R Up).
Qed.

(** The values of the paper's symbols, as they are, but one. *)
Definition values_with (x : string -> R) (name : string) (p : R) (q : positive) : R :=
  if Pos.eqb q (code name) then p else x (decode q).

Lemma values_with_agree x name p other : values_with x name p (code other) = with_parameter x name p other.
Proof.
  unfold values_with, with_parameter. destruct (Pos.eqb_spec (code other) (code name)) as [E|E].
  - apply code_injective in E. subst. now rewrite String.eqb_refl.
  - rewrite decode_code. destruct (String.eqb_spec other name); [subst; congruence|reflexivity].
Qed.

Lemma values_with_other x name p r q : ~ In q [code name] -> values_with x name p q = values_with x name r q.
Proof. intro N. unfold values_with. destruct (Pos.eqb_spec q (code name)) as [E|E]; [|reflexivity]. destruct N. left. congruence. Qed.

Lemma rising_bicycle s name x p : bicycle_fits s = true -> all_rising (code name) (bicycle_facts s) = true ->
  bicycle s x -> x name <= p -> bicycle s (with_parameter x name p).
Proof.
  intros F R B L. apply (bicycle_of_forms s (values_with x name p)); [exact F| |intros other _; apply values_with_agree].
  assert (H : Forall (holds (values_with x name (x name))) (bicycle_facts s)).
  { assert (E : forall other, values_with x name (x name) (code other) = x other).
    { intro other. rewrite values_with_agree. unfold with_parameter. destruct (String.eqb_spec other name); [now subst|reflexivity]. }
    apply (bicycle_facts_hold s _ x x B). split; intros other _; [apply E|]. rewrite append_nil_r. apply E. }
  apply (all_rising_hold (code name) (values_with x name (x name))); [apply values_with_other| |exact R|exact H].
  unfold values_with. now rewrite Pos.eqb_refl.
Qed.
