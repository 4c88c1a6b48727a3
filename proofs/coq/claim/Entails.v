(** A formula that plainly follows from others: it is one of them, up to a positive factor and the order of its parts, or
    its sign is plain from those of its variables. Incomplete; nothing rests on what it does not find. *)
From Coq Require Import List Bool ZArith Reals Lra Lia.
From Slipproof Require Import Syntax Poly Normal NormalSound.
Import ListNotations.

(** The same polynomials for the same sets of zeros and signs: no common factor; of p = 0 and -p = 0 the one with a
    positive first coefficient. *)
Fixpoint content (p : poly) (g : Z) : Z := match p with Nil => g | Plus c _ p => content p (Z.gcd c g) end.
Fixpoint divided (g : Z) (p : poly) : poly := match p with Nil => Nil | Plus c m p => Plus (c / g) m (divided g p) end.
Definition primitive (p : poly) : poly :=
  let g := content p 0 in
  let q := divided g p in if Z.ltb 0 g && same_poly (scale g One q) p then q else p.
Definition signless (p : poly) : poly := match p with Plus (Zneg _) _ _ => neg p | _ => p end.

Definition is_atom_of (s : sign) (p : poly) : form := Atom s (match s with Zero => signless (primitive p) | _ => primitive p end).

(** Conjunctions in conjunctions, and disjunctions in disjunctions, are taken apart. *)
Fixpoint tidy (f : form) : form :=
  match f with
  | Atom s p => is_atom_of s p
  | All fs => all_of (flat_map (fun g => match tidy g with All gs => gs | g => [g] end) fs)
  | Any fs => any_of (flat_map (fun g => match tidy g with Any gs => gs | g => [g] end) fs)
  end.
Definition conjuncts_of (f : form) : list form := match tidy f with All fs => fs | f => [f] end.

Definition same_sign (s t : sign) : bool :=
  match s, t with Zero, Zero | Positive, Positive | NonNegative, NonNegative => true | _, _ => false end.

(** [f] is [g]: what is in one list is in the other. *)
Fixpoint same_form (f g : form) : bool :=
  let within fs gs := forallb (fun f => existsb (same_form f) gs) fs in
  match f, g with
  | Atom s p, Atom t q => same_sign s t && same_poly p q
  | All fs, All gs | Any fs, Any gs =>
      within fs gs && forallb (fun g => existsb (fun f => same_form f g) fs) gs
  | _, _ => false
  end.

(** Signs of polynomials *)


Definition in_list (v : positive) (vs : list positive) : bool := existsb (Pos.eqb v) vs.

(** What an atom says of one variable: c x > 0, or c x - d > 0 with c, d > 0. *)
Definition positive_variables (f : form) : list positive :=
  match f with
  | Atom Positive (Plus (Zpos _) (Times v 1 One) Nil) => [v]
  | Atom Positive (Plus (Zneg _) One (Plus (Zpos _) (Times v 1 One) Nil)) => [v]
  | Atom NonNegative (Plus (Zneg _) One (Plus (Zpos _) (Times v 1 One) Nil)) => [v]
  | _ => []
  end.
Definition nonnegative_variables (f : form) : list positive :=
  match f with Atom NonNegative (Plus (Zpos _) (Times v 1 One) Nil) => [v] | _ => positive_variables f end.

Section Plain.
Variables above not_below : list positive.

Fixpoint positive_mono (m : mono) : bool := match m with One => true | Times v _ m => in_list v above && positive_mono m end.
Fixpoint nonnegative_mono (m : mono) : bool :=
  match m with
  | One => true
  | Times v e m => (in_list v not_below || match e with xO _ => true | _ => false end) && nonnegative_mono m
  end.
Fixpoint nonnegative (p : poly) : bool :=
  match p with Nil => true | Plus c m p => Z.leb 0 c && nonnegative_mono m && nonnegative p end.
Fixpoint some_positive (p : poly) : bool :=
  match p with Nil => false | Plus c m p => Z.ltb 0 c && positive_mono m || some_positive p end.
End Plain.

Section Implied.
Variable facts : list form.
Let above := flat_map positive_variables facts.
Let not_below := flat_map nonnegative_variables facts.

(** Plainly, or after a fact q > 0 or q >= 0 was taken from p, as often as fits its first coefficient. *)
Definition leading (p : poly) : option (Z * mono) := match p with Nil => None | Plus c m _ => Some (c, m) end.
Fixpoint coefficient_of (m : mono) (p : poly) : Z :=
  match p with Nil => 0 | Plus c n p => match compare_mono m n with Datatypes.Eq => c | _ => coefficient_of m p end end.
Fixpoint terms_of (p : poly) : list (Z * mono) := match p with Nil => [] | Plus c m p => (c, m) :: terms_of p end.

(** Numbers a, b > 0 for which a p - b q has lost a term. *)
Definition multiples_of (p q : poly) : list (Z * Z) :=
  flat_map (fun '(c, m) => let d := coefficient_of m p in if Z.ltb 0 (c * d) then [(Z.abs c, Z.abs d)] else []) (terms_of q).
Definition less (p q : poly) (ab : Z * Z) : poly := add (scale (fst ab) One p) (neg (scale (snd ab) One q)).

Definition plainly_nonnegative (p : poly) : bool :=
  nonnegative not_below p
  || existsb (fun f => match f with
                       | Atom Positive q | Atom NonNegative q =>
                           existsb (fun ab => Z.ltb 0 (fst ab) && Z.leb 0 (snd ab) && nonnegative not_below (less p q ab))
                                   (multiples_of p q)
                       | _ => false
                       end) facts.
Definition plainly_positive (p : poly) : bool :=
  nonnegative not_below p && some_positive above p
  || existsb (fun f => match f with
                       | Atom Positive q =>
                           existsb (fun ab => Z.ltb 0 (fst ab) && Z.ltb 0 (snd ab) && nonnegative not_below (less p q ab))
                                   (multiples_of p q)
                       | Atom NonNegative q =>
                           existsb (fun ab => Z.ltb 0 (fst ab) && Z.leb 0 (snd ab) && nonnegative not_below (less p q ab)
                                              && some_positive above (less p q ab))
                                   (multiples_of p q)
                       | _ => false
                       end) facts.

(** Facts times variables that are positive, so that they have a term of p. *)
Fixpoint quotient (m n : mono) : option mono :=
  match n, m with
  | One, _ => Some m
  | Times _ _ _, One => None
  | Times w f n', Times v e m' =>
      if Pos.eqb v w then
        if Pos.eqb e f then quotient m' n'
        else if Pos.ltb f e then option_map (Times v (e - f)) (quotient m' n') else None
      else option_map (Times v e) (quotient m' n)
  end.
Definition products_of (p q : poly) : list poly :=
  match leading q with
  | Some (_, n) =>
      flat_map (fun cm => match quotient (snd cm) n with
                          | Some (Times _ _ _ as k) => if positive_mono above k then [scale 1 k q] else []
                          | _ => []
                          end) (terms_of p)
  | None => []
  end.
Definition most_terms : nat := 12.
Definition products (p : poly) : list form :=
  if Nat.leb (length (terms_of p)) most_terms then
    flat_map (fun f => match f with Atom Zero _ => [] | Atom s q => map (Atom s) (products_of p q) | _ => [] end) facts
  else [].
End Implied.

Section Plainly.
Variable facts : list form.
Definition plain (f : form) : bool :=
  let or_by_products shown p := shown facts p || match products facts p with [] => false | more => shown (more ++ facts) p end in
  match f with
  | Atom Zero p => is_zero p || existsb (same_form (Atom NonNegative p)) facts && existsb (same_form (Atom NonNegative (neg p))) facts
  | Atom Positive p => or_by_products plainly_positive p
  | Atom NonNegative p => or_by_products plainly_nonnegative p || existsb (same_form (Atom Positive p)) facts
                          || existsb (same_form (is_atom_of Zero p)) facts
  | _ => false
  end.

Fixpoint follows (f : form) : bool :=
  existsb (same_form f) facts
  || match f with
     | Atom _ _ => plain f
     | All fs => forallb follows fs
     | Any fs => existsb follows fs
     end.
End Plainly.

(** [n] disjunctions among the facts may be taken by cases. *)
Fixpoint first_any (facts seen : list form) : option (list form * list form) :=
  match facts with
  | [] => None
  | Any parts :: rest => Some (parts, rev_append seen rest)
  | f :: rest => first_any rest (f :: seen)
  end.
Fixpoint implied (n : nat) (facts : list form) (f : form) : bool :=
  follows facts f
  || match n with
     | O => false
     | S n => match first_any facts [] with
              | Some (parts, rest) => forallb (fun part => implied n (conjuncts_of part ++ rest) f) parts
              | None => false
              end
     end.

Definition entails (facts : list form) (f : form) : bool := implied 4 (flat_map conjuncts_of facts) (tidy f).

(** Soundness *)
Local Open Scope R_scope.

Section Sound.
Variable v : positive -> R.
Notation val := (value_at v).
Notation holds := (holds v).

Lemma primitive_value p : exists k, (0 < k)%Z /\ val p = IZR k * val (primitive p).
Proof.
  unfold primitive. set (g := content p 0). destruct (Z.ltb 0 g && same_poly (scale g One (divided g p)) p) eqn:E.
  - apply andb_true_iff in E. destruct E as [P S]. apply Z.ltb_lt in P. apply same_poly_eq in S.
    exists g. split; [exact P|]. rewrite <- S at 1. rewrite scale_value. simpl. ring.
  - exists 1%Z. split; [reflexivity|]. ring.
Qed.

Lemma signless_value p : val (signless p) = 0 <-> val p = 0.
Proof. unfold signless. destruct p as [|[|c|c] m p]; try tauto. rewrite neg_value. lra. Qed.

Lemma is_atom_of_sound s p : holds (is_atom_of s p) <-> holds (Atom s p).
Proof.
  destruct (primitive_value p) as [k [K E]]. apply IZR_lt in K.
  destruct s; simpl; rewrite ?signless_value, E; set (t := val (primitive p)).
  - split; [intro Z; rewrite Z; ring|]. intro Z. apply Rmult_integral in Z. destruct Z; [lra|assumption].
  - split; intro H; nra.
  - split; intro H; nra.
Qed.

Lemma Forall_flat_map {A B} (P : B -> Prop) (f : A -> list B) xs : Forall P (flat_map f xs) <-> Forall (fun x => Forall P (f x)) xs.
Proof. induction xs as [|x xs IH]; simpl; [split; constructor|]. rewrite Forall_app, IH, (Forall_cons_iff _ x). tauto. Qed.
Lemma Exists_flat_map' {A B} (P : B -> Prop) (f : A -> list B) xs : Exists P (flat_map f xs) <-> Exists (fun x => Exists P (f x)) xs.
Proof. induction xs as [|x xs IH]; simpl; [rewrite !Exists_nil; tauto|]. rewrite Exists_app, IH, Exists_cons. tauto. Qed.

Lemma single f : Forall holds [f] <-> holds f.
Proof. rewrite (Forall_cons_iff holds f []). intuition. Qed.
Lemma single_any f : Exists holds [f] <-> holds f.
Proof. rewrite Exists_cons, Exists_nil. tauto. Qed.

Lemma tidy_sound f : holds (tidy f) <-> holds f.
Proof.
  induction f as [s p|fs IH|fs IH] using form_nested_ind; simpl tidy.
  - apply is_atom_of_sound.
  - rewrite holds_all_of, holds_all, Forall_flat_map. split; intro H; induction IH as [|g gs I _ K]; constructor; inversion H; subst; auto.
    + apply I. destruct (tidy g); try (apply single; assumption). apply holds_all. assumption.
    + apply I in H2. destruct (tidy g); try (apply single; assumption). apply holds_all in H2. assumption.
  - rewrite holds_any_of, holds_any, Exists_flat_map'. split; intro H; induction IH as [|g gs I _ K]; inversion H; subst; auto.
    + left. apply I. destruct (tidy g); try (apply single_any; assumption). apply holds_any. assumption.
    + left. apply I in H1. destruct (tidy g); try (apply single_any; assumption). apply holds_any in H1. assumption.
Qed.

Lemma conjuncts_of_sound f : Forall holds (conjuncts_of f) <-> holds f.
Proof.
  rewrite <- tidy_sound. unfold conjuncts_of. destruct (tidy f); try apply single. rewrite holds_all. tauto.
Qed.

Lemma same_form_sound f : forall g, same_form f g = true -> (holds f <-> holds g).
Proof.
  induction f as [s p|fs IH|fs IH] using form_nested_ind; intros [t q|gs|gs] H; simpl in H; try discriminate.
  - apply andb_true_iff in H. destruct H as [S P]. apply same_poly_eq in P. subst q.
    destruct s, t; try discriminate; tauto.
  - apply andb_true_iff in H. destruct H as [A B]. rewrite forallb_forall in A, B. rewrite Forall_forall in IH.
    rewrite !holds_all, !Forall_forall. split; intros H g I.
    + specialize (B _ I). apply existsb_exists in B. destruct B as [f [J E]]. apply (IH _ J _ E), H, J.
    + specialize (A _ I). apply existsb_exists in A. destruct A as [h [J E]]. apply (IH _ I _ E), H, J.
  - apply andb_true_iff in H. destruct H as [A B]. rewrite forallb_forall in A, B. rewrite Forall_forall in IH.
    rewrite !holds_any, !Exists_exists. split; intros [g [I H]].
    + specialize (A _ I). apply existsb_exists in A. destruct A as [h [J E]]. exists h. split; [exact J|]. apply (IH _ I _ E), H.
    + specialize (B _ I). apply existsb_exists in B. destruct B as [f [J E]]. exists f. split; [exact J|]. apply (IH _ J _ E), H.
Qed.

Section Signs.
Variables above not_below : list positive.
Hypothesis above_sound : forall x, In x above -> 0 < v x.
Hypothesis not_below_sound : forall x, In x not_below -> 0 <= v x.

Lemma in_list_In x xs : in_list x xs = true -> In x xs.
Proof. unfold in_list. intro H. apply existsb_exists in H. destruct H as [y [I E]]. apply Pos.eqb_eq in E. now subst. Qed.

Lemma positive_mono_sound m : positive_mono above m = true -> 0 < value_mono v m.
Proof.
  induction m as [|x e m IH]; simpl; [lra|]. intro H. apply andb_true_iff in H. destruct H as [A B].
  apply in_list_In, above_sound in A. apply IH in B. apply Rmult_lt_0_compat; [apply pow_lt, A|exact B].
Qed.

Lemma even_power x e : 0 <= x ^ Pos.to_nat (xO e).
Proof. rewrite Pos2Nat.inj_xO, pow_mult. apply pow_le. simpl. nra. Qed.

Lemma nonnegative_mono_sound m : nonnegative_mono not_below m = true -> 0 <= value_mono v m.
Proof.
  induction m as [|x e m IH]; cbn [nonnegative_mono value_mono]; [lra|]. intro H. apply andb_true_iff in H. destruct H as [A B].
  apply IH in B. apply Rmult_le_pos; [|exact B]. apply orb_true_iff in A. destruct A as [A|A].
  - apply in_list_In, not_below_sound in A. apply pow_le, A.
  - destruct e; try discriminate. apply even_power.
Qed.

Lemma nonnegative_sound p : nonnegative not_below p = true -> 0 <= val p.
Proof.
  induction p as [|c m p IH]; simpl; [lra|]. intro H. apply andb_true_iff in H. destruct H as [H B].
  apply andb_true_iff in H. destruct H as [A M]. apply Z.leb_le, IZR_le in A. apply nonnegative_mono_sound in M. apply IH in B. nra.
Qed.

Lemma some_positive_sound p : nonnegative not_below p = true -> some_positive above p = true -> 0 < val p.
Proof.
  induction p as [|c m p IH]; simpl; [discriminate|]. intros H K. apply andb_true_iff in H. destruct H as [H B].
  apply andb_true_iff in H. destruct H as [A M]. apply Z.leb_le, IZR_le in A. apply nonnegative_mono_sound in M.
  apply orb_true_iff in K. destruct K as [K|K].
  - apply andb_true_iff in K. destruct K as [C P]. apply Z.ltb_lt, IZR_lt in C. apply positive_mono_sound in P.
    apply nonnegative_sound in B. nra.
  - assert (L := IH B K). nra.
Qed.
End Signs.

Section Facts.
Variable facts : list form.
Hypothesis facts_hold : Forall holds facts.

Lemma fact_holds f : In f facts -> holds f.
Proof. rewrite Forall_forall in facts_hold. apply facts_hold. Qed.

Lemma positive_variables_sound x : In x (flat_map positive_variables facts) -> 0 < v x.
Proof.
  intro I. apply in_flat_map in I. destruct I as [f [J I]]. apply fact_holds in J.
  destruct f as [[| |] [|[|c|c] [|w [e|e|] [|]] [|[|d|d] [|y [h|h|] [|]] [|]]]| |]; simpl in I; try contradiction;
    destruct I as [I|[]]; subst; simpl in J.
  - assert (C : 0 < IZR (Z.pos c)) by (apply IZR_lt; reflexivity). nra.
  - assert (C : IZR (Z.neg c) < 0) by (apply IZR_lt; reflexivity). assert (D : 0 < IZR (Z.pos d)) by (apply IZR_lt; reflexivity). nra.
  - assert (C : IZR (Z.neg c) < 0) by (apply IZR_lt; reflexivity). assert (D : 0 < IZR (Z.pos d)) by (apply IZR_lt; reflexivity). nra.
Qed.

Lemma nonnegative_variables_sound x : In x (flat_map nonnegative_variables facts) -> 0 <= v x.
Proof.
  intro I. apply in_flat_map in I. destruct I as [f [J I]].
  assert (K : In x (positive_variables f) -> 0 <= v x).
  { intro K. left. apply positive_variables_sound. apply in_flat_map. eauto. }
  destruct f as [[| |] p| |]; try (apply K, I).
  apply fact_holds in J.
  destruct p as [|[|c|c] [|w [e|e|] [|]] [|d y q]]; try (apply K, I).
  simpl in I. destruct I as [I|[]]. subst. simpl in J.
  assert (C : 0 < IZR (Z.pos c)) by (apply IZR_lt; reflexivity). nra.
Qed.

Lemma less_value p q ab : val (less p q ab) = IZR (fst ab) * val p - IZR (snd ab) * val q.
Proof. unfold less. rewrite add_value, neg_value, !scale_value. simpl. ring. Qed.

Lemma plainly_nonnegative_sound p : plainly_nonnegative facts p = true -> 0 <= val p.
Proof.
  unfold plainly_nonnegative. intro H. apply orb_true_iff in H. destruct H as [H|H].
  - eapply nonnegative_sound; [apply nonnegative_variables_sound|exact H].
  - apply existsb_exists in H. destruct H as [f [I H]]. apply fact_holds in I.
    destruct f as [[| |] q| |]; try discriminate; apply existsb_exists in H; destruct H as [ab [_ H]];
      apply andb_true_iff in H; destruct H as [H N]; apply andb_true_iff in H; destruct H as [A B];
      apply Z.ltb_lt, IZR_lt in A; apply Z.leb_le, IZR_le in B;
      eapply nonnegative_sound in N; try apply nonnegative_variables_sound; rewrite less_value in N; simpl in I; nra.
Qed.

Lemma plainly_positive_sound p : plainly_positive facts p = true -> 0 < val p.
Proof.
  unfold plainly_positive. intro H. apply orb_true_iff in H. destruct H as [H|H].
  - apply andb_true_iff in H. destruct H as [N P].
    eapply some_positive_sound; [apply positive_variables_sound|apply nonnegative_variables_sound|exact N|exact P].
  - apply existsb_exists in H. destruct H as [f [I H]]. apply fact_holds in I.
    destruct f as [[| |] q| |]; try discriminate; apply existsb_exists in H; destruct H as [ab [_ H]].
    + apply andb_true_iff in H; destruct H as [H N]; apply andb_true_iff in H; destruct H as [A B];
        apply Z.ltb_lt, IZR_lt in A; apply Z.ltb_lt, IZR_lt in B.
      eapply nonnegative_sound in N; try apply nonnegative_variables_sound. rewrite less_value in N. simpl in I. nra.
    + apply andb_true_iff in H; destruct H as [H P]; apply andb_true_iff in H; destruct H as [H N];
        apply andb_true_iff in H; destruct H as [A B]; apply Z.ltb_lt, IZR_lt in A; apply Z.leb_le, IZR_le in B.
      eapply some_positive_sound in P; [|apply positive_variables_sound|apply nonnegative_variables_sound|exact N].
      rewrite less_value in P. simpl in I. nra.
Qed.

End Facts.

Section Plainly.
Variable facts : list form.
Hypothesis facts_hold : Forall holds facts.

Lemma products_hold p : Forall holds (products facts p).
Proof.
  unfold products. destruct (Nat.leb _ _); [|constructor]. apply Forall_forall. intros g I. apply in_flat_map in I.
  destruct I as [f [J I]]. assert (H : holds f) by (rewrite Forall_forall in facts_hold; auto).
  assert (K : forall q k, In k (products_of facts p q) -> exists y, 0 < y /\ val k = y * val q).
  { intros q k L. unfold products_of in L. destruct (leading q) as [[c n]|]; [|contradiction]. apply in_flat_map in L.
    destruct L as [cm [_ L]]. destruct (quotient (snd cm) n) as [[|v' e y]|]; try contradiction.
    destruct (positive_mono _ _) eqn:P; [|contradiction]. destruct L as [L|[]]. subst k. exists (value_mono v (Times v' e y)).
    split; [eapply positive_mono_sound; [|exact P]; exact (positive_variables_sound facts facts_hold)|].
    rewrite scale_value. simpl. ring. }
  destruct f as [[| |] q| |]; try contradiction; apply in_map_iff in I; destruct I as [k [<- I]]; destruct (K q k I) as [y [Y E]];
    simpl in *; rewrite E; nra.
Qed.

Lemma is_fact f : existsb (same_form f) facts = true -> holds f.
Proof.
  intro H. apply existsb_exists in H. destruct H as [g [I E]]. apply (same_form_sound _ _ E), (fact_holds facts facts_hold), I.
Qed.

Lemma plain_sound f : plain facts f = true -> holds f.
Proof.
  destruct f as [[| |] p| |]; unfold plain; try discriminate; intro H.
  - apply orb_true_iff in H. destruct H as [H|H]; [apply is_zero_value, H|].
    apply andb_true_iff in H. destruct H as [A B]. apply is_fact in A, B. change (val p = 0). simpl in A, B. rewrite neg_value in B. lra.
  - apply Rlt_gt. apply orb_true_iff in H. destruct H as [H|H]; [exact (plainly_positive_sound facts facts_hold p H)|].
    assert (M := products_hold p). destruct (products facts p) as [|g more]; [discriminate|].
    apply (plainly_positive_sound ((g :: more) ++ facts)); [apply Forall_app; auto|exact H].
  - apply orb_true_iff in H. destruct H as [H|H]; [apply orb_true_iff in H; destruct H as [H|H]|].
    + apply Rle_ge. apply orb_true_iff in H. destruct H as [H|H]; [exact (plainly_nonnegative_sound facts facts_hold p H)|].
      assert (M := products_hold p). destruct (products facts p) as [|g more]; [discriminate|].
      apply (plainly_nonnegative_sound ((g :: more) ++ facts)); [apply Forall_app; auto|exact H].
    + apply is_fact in H. change (val p > 0) in H. change (val p >= 0). lra.
    + apply is_fact in H. apply (is_atom_of_sound Zero p) in H. change (val p = 0) in H. change (val p >= 0). lra.
Qed.

Lemma follows_sound f : follows facts f = true -> holds f.
Proof.
  induction f as [s p|fs IH|fs IH] using form_nested_ind; intro H; simpl follows in H; apply orb_true_iff in H;
    destruct H as [H|H]; try (apply is_fact, H).
  - apply plain_sound, H.
  - apply holds_all. rewrite forallb_forall in H. rewrite Forall_forall in *. intros f I. apply IH; auto.
  - apply holds_any. apply existsb_exists in H. destruct H as [f [I H]]. rewrite Forall_forall in IH.
    apply Exists_exists. exists f. split; auto.
Qed.
End Plainly.

Lemma first_any_sound facts : forall seen parts rest, first_any facts seen = Some (parts, rest) ->
  Forall holds facts -> Forall holds seen -> holds (Any parts) /\ Forall holds rest.
Proof.
  induction facts as [|f facts IH]; intros seen parts rest H F S; simpl in H; [discriminate|].
  inversion F; subst. destruct f as [s p|fs|fs].
  - apply (IH _ _ _ H); auto.
  - apply (IH _ _ _ H); auto.
  - inversion H; subst. split; [assumption|]. rewrite rev_append_rev. apply Forall_app. split; [apply Forall_rev, S|assumption].
Qed.

Lemma implied_sound n : forall facts f, implied n facts f = true -> Forall holds facts -> holds f.
Proof.
  induction n as [|n IH]; intros facts f H F; simpl in H; apply orb_true_iff in H; destruct H as [H|H];
    try (eapply follows_sound; eassumption); [discriminate|].
  destruct (first_any facts []) as [[parts rest]|] eqn:E; [|discriminate].
  destruct (first_any_sound _ _ _ _ E F (Forall_nil _)) as [A R]. apply holds_any, Exists_exists in A.
  destruct A as [part [I P]]. rewrite forallb_forall in H. apply (IH _ _ (H _ I)). apply Forall_app. split; [|exact R].
  apply conjuncts_of_sound, P.
Qed.

Theorem entails_sound facts f : entails facts f = true -> Forall holds facts -> holds f.
Proof.
  intros H F. apply tidy_sound. apply (implied_sound _ _ _ H). apply Forall_flat_map. rewrite Forall_forall in *.
  intros g I. apply conjuncts_of_sound, F, I.
Qed.
End Sound.
