(** The normal form says what the expression or formula says. *)
From Coq Require Import String List Bool ZArith Reals Lra Lia FMapFacts OrderedTypeEx.
From Slipproof Require Import Text Syntax Meaning Poly Normal.
Import ListNotations.
Local Open Scope R_scope.

Module MapFacts := FMapFacts.WFacts_fun String_as_OT Map.

Lemma find_add {A} (m : Map.t A) name other (a : A) :
  Map.find other (Map.add name a m) = if String.eqb other name then Some a else Map.find other m.
Proof.
  rewrite MapFacts.add_o. destruct (String_as_OT.eq_dec name other) as [E|E]; destruct (String.eqb_spec other name); congruence.
Qed.

Section Sound.
Variable x : positive -> R.
Notation val := (value_at x).

(** Fractions *)

Definition apart (ps : list poly) : Prop := Forall (fun p => val p <> 0) ps.

Definition represents (f : fraction) (q : quantity) : Prop :=
  (defined q <-> apart (divs f))
  /\ (apart (divs f) -> val (or_one (den f)) <> 0 /\ Meaning.value q = val (num f) / val (or_one (den f))).

Lemma one_value : val one = 1.
Proof. unfold one. now rewrite constant_value. Qed.
Local Opaque one.

Lemma apart_add_divs qs : forall ps, apart (add_divs ps qs) <-> apart ps /\ apart qs.
Proof.
  unfold apart. induction qs as [|q qs IH]; intro ps; simpl.
  - intuition.
  - destruct (existsb (same_poly q) ps) eqn:E; rewrite IH.
    + apply existsb_exists in E. destruct E as [p [I E]]. apply same_poly_eq in E. subst p.
      split; intros [H K]; split; auto.
      * constructor; auto. rewrite Forall_forall in H. auto.
      * inversion K; auto.
    + rewrite Forall_app. split.
      * intros [[H I] K]. inversion I. auto.
      * intros [H K]. inversion K. auto.
Qed.

Lemma represents_same f q r :
  (defined q <-> defined r) -> Meaning.value q = Meaning.value r -> represents f q -> represents f r.
Proof. intros D V [H K]. split; [tauto|]. rewrite <- V. exact K. Qed.

Lemma minus_sound f q : represents f q -> represents (minus f) (Quantity (defined q) (- Meaning.value q)).
Proof.
  intros [H K]. split; [exact H|]. simpl. intro A. destruct (K A) as [N V]. split; [exact N|].
  rewrite V, neg_value. field. exact N.
Qed.

Lemma same_den_eq p q : same_den p q = true -> p = q.
Proof. destruct p, q; simpl; try discriminate; auto. intro H. apply same_poly_eq in H. congruence. Qed.

Lemma plus_sound f g h q r : plus f g = Some h -> represents f q -> represents g r ->
  represents h (Quantity (defined q /\ defined r) (Meaning.value q + Meaning.value r)).
Proof.
  intros P [H K] [I L]. unfold plus in P. destruct (same_den (den f) (den g)) eqn:S.
  - apply same_den_eq in S. inversion P; subst h; clear P. split; simpl; rewrite apart_add_divs; [tauto|].
    intros [A B]. destruct (K A) as [N V], (L B) as [M W]. split; [exact N|].
    rewrite V, W, add_value, S. field. congruence.
  - options P. inversion P; subst h; clear P. split; simpl; rewrite apart_add_divs; [tauto|].
    intros [A B]. destruct (K A) as [N V], (L B) as [M W].
    apply (mul_value x) in E, E0, E1. rewrite E1. split; [apply Rmult_integral_contrapositive_currified; assumption|].
    rewrite V, W, add_value, E, E0. field. tauto.
Qed.

Lemma times_sound f g h q r : times f g = Some h -> represents f q -> represents g r ->
  represents h (Quantity (defined q /\ defined r) (Meaning.value q * Meaning.value r)).
Proof.
  intros P [H K] [I L]. unfold times in P. options P. inversion P; subst h; clear P.
  apply (mul_value x) in E. split; simpl; rewrite apart_add_divs; [tauto|].
  intros [A B]. destruct (K A) as [N V], (L B) as [M W]. rewrite V, W, E.
  destruct (den g) as [d|] eqn:D.
  - options E0. inversion E0; subst o; clear E0. apply (mul_value x) in E1. simpl in *. rewrite E1.
    split; [apply Rmult_integral_contrapositive_currified; assumption|]. field. tauto.
  - inversion E0; subst o; clear E0. split; [exact N|]. simpl. rewrite one_value. field. exact N.
Qed.

Lemma inverse_sound f h q : inverse f = Some h -> represents f q ->
  represents h (Quantity (defined q /\ Meaning.value q <> 0) (/ Meaning.value q)).
Proof.
  intros P [H K]. unfold inverse in P. options P. inversion P; subst h; clear P.
  assert (D : apart (if is_constant (num f) then divs f else add_divs (divs f) [num f])
              <-> apart (divs f) /\ val (num f) <> 0).
  { destruct (is_constant (num f)) eqn:C.
    - apply (is_constant_value x) in C. tauto.
    - rewrite apart_add_divs. unfold apart. rewrite (Forall_cons_iff _ (num f) []). intuition. }
  split; simpl; rewrite D.
  - split.
    + intros [A B]. apply H in A. split; [exact A|]. destruct (K A) as [N V]. intro Z. apply B. rewrite V, Z. field. exact N.
    + intros [A B]. split; [tauto|]. destruct (K A) as [N V]. rewrite V. unfold Rdiv.
      apply Rmult_integral_contrapositive_currified; [exact B|]. apply Rinv_neq_0_compat, N.
  - intros [A B]. destruct (K A) as [N V]. split; [exact B|]. rewrite V. field. tauto.
Qed.

Lemma power_sound f q n : represents f q -> forall m g h, power f n g = Some h ->
  represents g (Quantity (defined q) (Meaning.value q ^ m)) ->
  represents h (Quantity (defined q) (Meaning.value q ^ (m + n))).
Proof.
  intro F. induction n as [|n IH]; intros m g h P G; simpl in P.
  - inversion P; subst. now rewrite Nat.add_0_r.
  - options P. replace (m + S n)%nat with (S m + n)%nat by lia. eapply IH; [exact P|].
    eapply represents_same; [| |eapply times_sound; eassumption]; simpl; [tauto|ring].
Qed.

(** Formulas *)

Fixpoint holds (f : form) : Prop :=
  match f with
  | Atom Zero p => val p = 0
  | Atom Positive p => val p > 0
  | Atom NonNegative p => val p >= 0
  | All parts => fold_right (fun g P => holds g /\ P) True parts
  | Any parts => fold_right (fun g P => holds g \/ P) False parts
  end.

Lemma holds_all parts : holds (All parts) <-> Forall holds parts.
Proof.
  simpl. induction parts as [|g parts IH]; simpl; [intuition|]. rewrite IH, (Forall_cons_iff holds g parts). tauto.
Qed.

Lemma holds_any parts : holds (Any parts) <-> Exists holds parts.
Proof.
  simpl. induction parts as [|g parts IH]; simpl; [rewrite Exists_nil; tauto|]. rewrite IH, Exists_cons. tauto.
Qed.

Lemma holds_all_of parts : holds (all_of parts) <-> Forall holds parts.
Proof. destruct parts as [|g [|h parts]]; try apply holds_all. simpl. rewrite (Forall_cons_iff holds g []). intuition. Qed.

Lemma holds_any_of parts : holds (any_of parts) <-> Exists holds parts.
Proof.
  destruct parts as [|g [|h parts]]; try apply holds_any. simpl. rewrite Exists_cons, Exists_nil. tauto.
Qed.

Lemma form_nested_ind (P : form -> Prop) :
  (forall s p, P (Atom s p)) ->
  (forall parts, Forall P parts -> P (All parts)) -> (forall parts, Forall P parts -> P (Any parts)) ->
  forall f, P f.
Proof.
  intros A B C. fix IH 1. intros [s p|parts|parts].
  - apply A.
  - apply B. induction parts; constructor; auto.
  - apply C. induction parts; constructor; auto.
Qed.

Lemma holds_dec f : holds f \/ ~ holds f.
Proof.
  induction f as [s p|parts IH|parts IH] using form_nested_ind.
  - destruct s; simpl; lra.
  - rewrite holds_all. induction IH as [|g parts D IH [K|K]]; [left; constructor| |].
    + destruct D; [left; auto|right]. intro F; inversion F; auto.
    + right. intro F; inversion F; auto.
  - rewrite holds_any. induction IH as [|g parts D IH [K|K]]; [right; intro F; inversion F|left; auto|].
    destruct D; [left; auto|right]. intro F; inversion F; auto.
Qed.

Lemma non_zero_sound p : holds (non_zero p) <-> val p <> 0.
Proof. simpl. rewrite neg_value. lra. Qed.

Lemma negation_sound f : holds (negation f) <-> ~ holds f.
Proof.
  induction f as [s p|parts IH|parts IH] using form_nested_ind.
  - destruct s; [apply non_zero_sound| |]; simpl; rewrite neg_value; lra.
  - simpl negation. rewrite holds_any_of, holds_all, <- Exists_Forall_neg; [|intro; apply holds_dec].
    induction IH as [|g parts D IH K]; simpl; [rewrite !Exists_nil; tauto|]. rewrite !Exists_cons, K, D. tauto.
  - simpl negation. rewrite holds_all_of, holds_any, <- Forall_Exists_neg.
    induction IH as [|g parts D IH K]; simpl; [intuition|].
    rewrite (Forall_cons_iff holds), (Forall_cons_iff (fun h => ~ holds h)), K, D. tauto.
Qed.

(** Names *)

Definition entry_agrees (e : Normal.entry) (m : Meaning.entry) : Prop :=
  match e, m with
  | Normal.Value f, Meaning.Value q => represents f q
  | Normal.Truth f, Meaning.Truth P => holds f <-> P
  | _, _ => False
  end.

Definition agree (names : Normal.scope) (meant : Meaning.scope) : Prop :=
  forall name e, Map.find name names = Some e -> exists m, meant name = Some m /\ entry_agrees e m.

Lemma agree_bind names meant name e m :
  agree names meant -> entry_agrees e m -> agree (Map.add name e names) (bind name m meant).
Proof.
  intros A E other f. rewrite find_add. unfold bind. destruct (String.eqb other name); [|apply A].
  intro F. inversion F; subst. eauto.
Qed.

Section Names.
Variable names : Normal.scope.
Variable meant : Meaning.scope.
Hypothesis names_agree : agree names meant.

Lemma normal_sound e : forall f, normal names e = Some f ->
  exists q, quantity_of meant e = Some q /\ represents f q.
Proof.
  induction e as [token|name|a IH|a IH|a IH token|a IHa b IHb|a IHa b IHb|a IHa b IHb|a IHa b IHb]; intros f H; simpl in H.
  - options H. inversion H; subst; clear H. simpl. rewrite E. eexists; split; [reflexivity|].
    split; simpl; [split; intros; auto; constructor|]. intros _. rewrite one_value, constant_value. split; [lra|field].
  - options H. destruct e as [g|]; [|discriminate]. inversion H; subst; clear H.
    destruct (names_agree _ _ E) as [[q|P] [M A]]; [|contradiction]. simpl. rewrite M. eauto.
  - apply IH, H.
  - options H. inversion H; subst; clear H. destruct (IH _ eq_refl) as [q [Q R]]. simpl. rewrite Q.
    eexists; split; [reflexivity|]. apply minus_sound, R.
  - options H. destruct (IH _ eq_refl) as [q [Q R]]. simpl. rewrite Q, E0. eexists; split; [reflexivity|].
    assert (L : (1 <= n)%nat).
    { unfold exponent in E0. options E0. apply andb_true_iff in E2. destruct E2 as [L _]. apply Z.leb_le in L.
      inversion E0. lia. }
    assert (P := power_sound _ _ _ R 1 _ _ H). replace (1 + pred n)%nat with n in P by lia. apply P.
    eapply represents_same; [| |exact R]; simpl; [tauto|ring].
  - options H. destruct (IHa _ eq_refl) as [q [Q R]], (IHb _ eq_refl) as [r [S T]]. simpl. rewrite Q, S.
    eexists; split; [reflexivity|]. eapply times_sound; eassumption.
  - options H. destruct (IHa _ eq_refl) as [q [Q R]], (IHb _ eq_refl) as [r [S T]]. simpl. rewrite Q, S.
    eexists; split; [reflexivity|]. eapply inverse_sound in E1; [|exact T].
    exact (times_sound _ _ _ _ _ H R E1).
  - options H. destruct (IHa _ eq_refl) as [q [Q R]], (IHb _ eq_refl) as [r [S T]]. simpl. rewrite Q, S.
    eexists; split; [reflexivity|]. eapply plus_sound; eassumption.
  - options H. destruct (IHa _ eq_refl) as [q [Q R]], (IHb _ eq_refl) as [r [S T]]. simpl. rewrite Q, S.
    eexists; split; [reflexivity|]. exact (plus_sound _ _ _ _ _ H R (minus_sound _ _ T)).
Qed.

Lemma normal_value_sound e f : normal_value names e = Some f ->
  exists q, quantity_of meant e = Some q /\ represents f q.
Proof. intro H. unfold normal_value in H. options H. inversion H; subst. apply normal_sound, E0. Qed.

(** n/d and n d have the same sign. *)
Lemma fraction_sign n d : d <> 0 ->
  (n / d > 0 <-> n * d > 0) /\ (n / d >= 0 <-> n * d >= 0) /\ (n / d < 0 <-> - (n * d) > 0)
  /\ (n / d <= 0 <-> - (n * d) >= 0) /\ (n / d = 0 <-> n = 0).
Proof.
  intro D. assert (S : 0 < d * d) by nra. set (t := n / d). assert (E : n = t * d) by (unfold t; field; exact D).
  rewrite E. replace (t * d * d) with (t * (d * d)) by ring. repeat split; intro H; nra.
Qed.

Lemma condition_sound n d r c : condition n d r = Some c -> val (or_one d) <> 0 ->
  let t := val n / val (or_one d) in
  holds c <-> match r with Syntax.Lt => t < 0 | Le => t <= 0 | Syntax.Eq => t = 0 | Ne => t <> 0 | Ge => t >= 0 | Syntax.Gt => t > 0 end.
Proof.
  intros C D t. assert (S := fraction_sign (val n) _ D). fold t in S.
  unfold condition in C.
  destruct r; options C; inversion C; subst c; clear C; rewrite ?non_zero_sound; simpl; rewrite ?neg_value;
    try (apply (mul_value x) in E; rewrite E); tauto.
Qed.

Lemma comparison_sound f g r q s c : comparison f r g = Some c -> represents f q -> represents g s ->
  (holds c <-> compare q r s).
Proof.
  intros C F G. unfold comparison in C. options C. inversion C; subst c; clear C.
  destruct (plus_sound _ _ _ _ _ E F (minus_sound _ _ G)) as [D V]. simpl in D, V.
  rewrite holds_all_of, Forall_app, (Forall_cons_iff holds f1 []), Forall_map.
  assert (A : Forall (fun p => holds (non_zero p)) (divs f0) <-> apart (divs f0)).
  { unfold apart. rewrite !Forall_forall. setoid_rewrite non_zero_sound. tauto. }
  rewrite A. unfold compare. split.
  - intros [B [K _]]. destruct (V B) as [N W]. apply D in B. split; [tauto|]. split; [tauto|].
    apply (condition_sound _ _ _ _ E0 N) in K. rewrite <- W in K. destruct r; lra.
  - intros [B [I K]]. assert (L : apart (divs f0)) by tauto. destruct (V L) as [N W]. split; [exact L|].
    split; [|constructor]. apply (condition_sound _ _ _ _ E0 N). rewrite <- W. destruct r; lra.
Qed.

Lemma comparisons_sound links : forall f q fs, comparisons names f links = Some fs -> represents f q ->
  exists P, chain meant q links = Some P /\ (Forall holds fs <-> P).
Proof.
  induction links as [|[r e] links IH]; intros f q fs C F; simpl in C.
  - inversion C; subst. exists True. split; [reflexivity|]. intuition.
  - options C. inversion C; subst fs; clear C. destruct (normal_value_sound _ _ E) as [s [S G]].
    destruct (IH _ _ _ E1 G) as [P [K L]]. simpl. rewrite S, K. eexists; split; [reflexivity|].
    rewrite (Forall_cons_iff holds), L, (comparison_sound _ _ _ _ _ _ E0 F G). tauto.
Qed.

Lemma close_conjuncts ps : Forall holds (conjuncts ps) <-> holds (close ps).
Proof.
  assert (W : forall f, Forall holds [f] <-> holds f) by (intro f; rewrite (Forall_cons_iff holds f []); intuition).
  destruct ps as [f|fs|fs]; simpl conjuncts; try apply W. simpl. rewrite holds_all_of. unfold rev'. rewrite <- rev_alt.
  split; [apply Forall_rev|]. intro H. apply Forall_rev in H. now rewrite rev_involutive in H.
Qed.

Lemma close_disjuncts ps : Exists holds (disjuncts ps) <-> holds (close ps).
Proof.
  assert (W : forall f, Exists holds [f] <-> holds f) by (intro f; rewrite Exists_cons, Exists_nil; tauto).
  destruct ps as [f|fs|fs]; simpl disjuncts; try apply W. simpl. rewrite holds_any_of. unfold rev'. rewrite <- rev_alt.
  rewrite !Exists_exists. setoid_rewrite <- in_rev. tauto.
Qed.

Lemma close_and f fs : holds (close (Conjuncts (f :: fs))) <-> holds f /\ Forall holds fs.
Proof. rewrite <- close_conjuncts. apply (Forall_cons_iff holds). Qed.

Lemma close_or f fs : holds (close (Disjuncts (f :: fs))) <-> holds f \/ Exists holds fs.
Proof. rewrite <- close_disjuncts. simpl disjuncts. rewrite Exists_cons. tauto. Qed.

Lemma normal_parts_sound f : forall ps, normal_parts names f = Some ps ->
  exists P, truth meant f = Some P /\ (holds (close ps) <-> P).
Proof.
  induction f as [|name|e links|g IH|g IHg h IHh|g IHg h IHh]; intros ps H; simpl in H.
  - inversion H; subst. exists False. simpl. tauto.
  - options H. destruct e as [|g]; [discriminate|]. inversion H; subst; clear H.
    destruct (names_agree _ _ E) as [[q|P] [M A]]; [contradiction|]. simpl. rewrite M. eauto.
  - options H. inversion H; subst; clear H. destruct (normal_value_sound _ _ E) as [q [Q R]].
    destruct (comparisons_sound _ _ _ _ E0 R) as [P [C L]]. simpl. rewrite Q, C. eexists; split; [reflexivity|].
    rewrite holds_all_of. exact L.
  - options H. inversion H; subst; clear H. destruct (IH _ eq_refl) as [P [T L]]. eauto.
  - options H. inversion H; subst; clear H. destruct (IHg _ eq_refl) as [P [T L]], (IHh _ eq_refl) as [Q [U M]].
    simpl truth. rewrite T, U. eexists; split; [reflexivity|]. rewrite close_and, close_conjuncts, L, M. tauto.
  - options H. inversion H; subst; clear H. destruct (IHg _ eq_refl) as [P [T L]], (IHh _ eq_refl) as [Q [U M]].
    simpl truth. rewrite T, U. eexists; split; [reflexivity|]. rewrite close_or, close_disjuncts, L, M. tauto.
Qed.

Lemma normal_formula_sound f g : normal_formula names f = Some g ->
  exists P, truth meant f = Some P /\ (holds g <-> P).
Proof. intro H. unfold normal_formula in H. options H. inversion H; subst. apply normal_parts_sound, E. Qed.

Lemma abbreviate_sound a more : Normal.abbreviate names a = Some more ->
  exists wider, Meaning.abbreviate a meant = Some wider /\ agree more wider.
Proof.
  destruct a as [name e|name f]; simpl; intro H; options H; inversion H; subst; clear H.
  - destruct (normal_value_sound _ _ E) as [q [Q R]]. rewrite Q. eexists; split; [reflexivity|]. now apply agree_bind.
  - destruct (normal_formula_sound _ _ E) as [P [T L]]. rewrite T. eexists; split; [reflexivity|]. now apply agree_bind.
Qed.
End Names.
End Sound.
