(** What normal forms of terms and conditions say: that the condition has this truth value. *)
From Coq Require Import Ascii String List Bool NArith ZArith Reals Lra Lia.
From Slipproof Require Import Text Syntax Meaning Poly Normal NormalSound.
From Slipproof.claim Require Import Expression Forms.
Import ListNotations.
Local Open Scope R_scope.

Lemma decode_code name : decode (code name) = name.
Proof.
  unfold decode. induction name as [|[a b c d e f g h] rest IH]; [reflexivity|].
  destruct a, b, c, d, e, f, g, h; cbn; rewrite IH; reflexivity.
Qed.

Section Sound.
Variable v : positive -> R.
Notation val := (value_at v).
Notation holds := (holds v).
Notation apart := (apart v).

Local Opaque Normal.one.

(** A number, or none. *)
Definition as_quantity (x : option R) : quantity :=
  Quantity (x <> None) (match x with Some x => x | None => 0 end).
Definition stands (f : fraction) (x : option R) : Prop := represents v f (as_quantity x).

Definition agrees (names : Normal.scope) (meant : meanings) : Prop :=
  forall name e, Map.find name names = Some e -> exists f, e = Normal.Value f /\ stands f (meant name).

Lemma stands_of f q x : represents v f q -> (defined q <-> x <> None) -> (defined q -> Some (Meaning.value q) = x) -> stands f x.
Proof.
  intros [H K] D V. split; simpl; [tauto|]. intro A. split; [apply K, A|].
  rewrite <- (proj2 (K A)). assert (E := V (proj2 H A)). rewrite <- E. reflexivity.
Qed.

Lemma stands_some f x : stands f (Some x) <-> (apart (divs f) /\ val (or_one (den f)) <> 0 /\ x = val (num f) / val (or_one (den f))).
Proof.
  unfold stands, represents; simpl. split.
  - intros [H K]. assert (A : apart (divs f)) by (apply H; discriminate). split; [exact A|]. apply K, A.
  - intros [A [B C]]. split; [split; auto; discriminate|]. auto.
Qed.

Lemma stands_none f : stands f None <-> ~ apart (divs f).
Proof.
  unfold stands, represents; simpl. split.
  - intros [H _] A. apply H in A. now apply A.
  - intro N. split; [split; [intro H; now contradict H|tauto]|tauto].
Qed.

Lemma represents_some f x : stands f (Some x) -> represents v f (Quantity True x).
Proof.
  intro S. apply stands_some in S. destruct S as [A [B C]]. split; simpl; [tauto|]. intros _. split; [exact B|exact C].
Qed.

Lemma stands_number n : stands (Fraction (constant n) None []) (Some (IZR n)).
Proof. apply stands_some. simpl. rewrite one_value, constant_value. split; [constructor|]. split; [lra|field]. Qed.

Lemma stands_symbol name : stands (symbol name) (Some (v (code name))).
Proof.
  apply stands_some. simpl. rewrite one_value. split; [constructor|]. split; [lra|].
  unfold variable. simpl. field.
Qed.

(** Of numbers that have a value. *)
Definition known (x : option R) : R := match x with Some x => x | None => 0 end.

Lemma stands_quantity f x D V : represents v f (Quantity D V) -> (D <-> x <> None) -> (x <> None -> V = known x) -> stands f x.
Proof.
  intros H D' E. eapply stands_of; [exact H|exact D'|]. simpl. intro K. destruct x as [x|]; simpl in *.
  - rewrite E; [reflexivity|discriminate].
  - apply D' in K. now contradict K.
Qed.

Lemma minus_stands f x : stands f x -> stands (minus f) (let* x := x in Some (- x)).
Proof.
  intro S. apply minus_sound in S. eapply stands_quantity; [exact S| |]; destruct x; simpl; try tauto; split; auto; discriminate.
Qed.

Ltac two x y := destruct x, y; simpl; try tauto; try (split; [intros _; discriminate|intros _; split; discriminate]);
  try (split; [intros [? ?]; congruence|congruence]).

Lemma plus_stands f g h x y : plus f g = Some h -> stands f x -> stands g y ->
  stands h (let* x := x in let* y := y in Some (x + y)).
Proof. intros P S T. assert (H := plus_sound _ _ _ _ _ _ P S T). eapply stands_quantity; [exact H| |]; two x y. Qed.

Lemma times_stands f g h x y : times f g = Some h -> stands f x -> stands g y ->
  stands h (let* x := x in let* y := y in Some (x * y)).
Proof. intros P S T. assert (H := times_sound _ _ _ _ _ _ P S T). eapply stands_quantity; [exact H| |]; two x y. Qed.

Lemma inverse_stands f h x : inverse f = Some h -> stands f x ->
  stands h (let* x := x in if Req_EM_T x 0 then None else Some (/ x)).
Proof.
  intros P S. assert (H := inverse_sound _ _ _ _ P S). eapply stands_quantity; [exact H| |]; destruct x as [x|]; simpl.
  - destruct (Req_EM_T x 0); [|split; [discriminate|split; [discriminate|assumption]]]. split; [tauto|congruence].
  - split; [tauto|congruence].
  - destruct (Req_EM_T x 0); [congruence|reflexivity].
  - congruence.
Qed.

Lemma power_stands f h x n : power f (pred n) f = Some h -> (0 < n)%nat -> stands f x ->
  stands h (let* x := x in Some (x ^ n)).
Proof.
  intros P L S. assert (H := power_sound v f _ (pred n) S 1 f h P).
  replace (1 + pred n)%nat with n in H by lia.
  assert (B : represents v f (Quantity (defined (as_quantity x)) (Meaning.value (as_quantity x) ^ 1))).
  { eapply represents_same; [| |exact S]; simpl; [tauto|ring]. }
  apply H in B. eapply stands_quantity; [exact B| |]; destruct x; simpl; try tauto; split; auto; discriminate.
Qed.

Section Names.
Variable names : Normal.scope.
Variable meant : meanings.
Hypothesis names_agree : agrees names meant.

Lemma normal_term_sound e : forall f, normal_term names e = Some f -> stands f (Expression.value meant e).
Proof.
  induction e as [n|name|a IH|a IHa b IHb|a IHa b IHb|a IHa b IHb|a IHa b IHb|a IH k|a IH|a IH|a IHa b IHb|a IHa b IHb];
    intros f H; cbn [normal_term Expression.value] in *; try discriminate.
  - options H. inversion H; subst. apply stands_number.
  - destruct (Map.find name names) as [[g|g]|] eqn:F; try discriminate. inversion H; subst.
    destruct (names_agree _ _ F) as [h [E S]]. inversion E; subst. exact S.
  - options H. inversion H; subst. apply minus_stands, IH. reflexivity.
  - options H. exact (plus_stands _ _ _ _ _ H (IHa _ eq_refl) (IHb _ eq_refl)).
  - options H. assert (K := plus_stands _ _ _ _ _ H (IHa _ eq_refl) (minus_stands _ _ (IHb _ eq_refl))).
    destruct (Expression.value meant a), (Expression.value meant b); exact K.
  - options H. exact (times_stands _ _ _ _ _ H (IHa _ eq_refl) (IHb _ eq_refl)).
  - options H. assert (K := times_stands _ _ _ _ _ H (IHa _ eq_refl) (inverse_stands _ _ _ E1 (IHb _ eq_refl))).
    destruct (Expression.value meant a) as [x|], (Expression.value meant b) as [y|]; try exact K.
    simpl in *. destruct (Req_EM_T y 0); exact K.
  - destruct (normal_term names a) as [g|] eqn:G; [|discriminate]. specialize (IH _ eq_refl).
    destruct k as [|n|n].
    + inversion H; subst; clear H. destruct (Expression.value meant a) as [x|]; simpl in *.
      * apply stands_some in IH. apply stands_some. simpl. rewrite one_value. repeat split; [tauto|lra|field].
      * apply stands_none in IH. apply stands_none. exact IH.
    + options H. assert (K := power_stands _ _ _ _ H (Pos2Nat.is_pos n) IH).
      destruct (Expression.value meant a) as [x|]; exact K.
    + options H. assert (K := power_stands _ _ _ _ E0 (Pos2Nat.is_pos n) IH).
      assert (O : stands (Fraction one None []) (Some 1)) by (apply (stands_number 1)).
      assert (T := times_stands _ _ _ _ _ H O (inverse_stands _ _ _ E1 K)).
      destruct (Expression.value meant a) as [x|]; [|exact T].
      change (Z.to_nat (- Z.neg n)) with (Pos.to_nat n). simpl in T. simpl.
      destruct (Req_EM_T x 0) as [Z|Z].
      * subst x. rewrite pow_i in T by apply Pos2Nat.is_pos. destruct (Req_EM_T 0 0) as [_|N]; [exact T|congruence].
      * destruct (Req_EM_T (x ^ Pos.to_nat n) 0) as [N|N]; [now apply pow_nonzero in N|].
        rewrite Rmult_1_l in T. exact T.
Qed.

Lemma opposite_sound x r y : compares x (opposite r) y <-> ~ compares x r y.
Proof. destruct r; simpl; lra. Qed.

Definition links_as (a : term) (r : rel) (b : term) : Prop := link meant true a r b.

Lemma link_true a r b : link meant true a r b <->
  match Expression.value meant a, Expression.value meant b with Some x, Some y => compares x r y | _, _ => False end.
Proof.
  unfold link. destruct (Expression.value meant a) as [x|]; [destruct (Expression.value meant b) as [y|]|].
  - split; [|eauto]. intros [x' [y' [E1 [E2 K]]]]. inversion E1; inversion E2; subst. exact K.
  - split; [intros [? [? [_ [K _]]]]; discriminate|tauto].
  - split; [intros [? [? [K _]]]; discriminate|tauto].
Qed.

Lemma link_false a r b : link meant false a r b <-> link meant true a (opposite r) b.
Proof.
  unfold link. split; intros [x [y [X [Y C]]]]; exists x, y; repeat split; auto; apply opposite_sound; exact C.
Qed.

Lemma plain_link_sound a r b h : plain_link names a r b = Some h -> (holds h <-> link meant true a r b).
Proof.
  intro C. unfold plain_link in C. options C. assert (F := normal_term_sound _ _ E). assert (G := normal_term_sound _ _ E0).
  rewrite (comparison_sound _ _ _ _ _ _ _ C F G), link_true. unfold compare.
  destruct (Expression.value meant a) as [x|]; simpl; [destruct (Expression.value meant b) as [y|]; simpl|].
  - split; [tauto|]. intro K. repeat split; try discriminate. exact K.
  - split; [intros [_ [K _]]; congruence|tauto].
  - split; [intros [K _]; congruence|tauto].
Qed.

(** A term depends on what is innermost by its value. *)
Lemma innermost_sound e : forall f k, innermost e = Some (f, k) ->
  k f = e /\ (forall g, Expression.value meant g = Expression.value meant f -> Expression.value meant (k g) = Expression.value meant e)
  /\ (Expression.value meant f = None -> Expression.value meant e = None).
Proof.
  induction e as [n|name|a IH|a IHa b IHb|a IHa b IHb|a IHa b IHb|a IHa b IHb|a IH n|a IH|a IH|a IHa b IHb|a IHa b IHb];
    intros f k H; cbn [innermost] in H; try discriminate;
    repeat match type of H with
      | context [match innermost ?x with _ => _ end] =>
          destruct (innermost x) as [[? ?]|] eqn:?; simpl in H
      end; try discriminate; inversion H; subst; clear H;
    try (split; [reflexivity|split; [intros g E; exact E|intro E; exact E]]);
    repeat match goal with
      | IH : forall f k, Some (?g, ?t) = Some (f, k) -> _ |- _ => specialize (IH _ _ eq_refl); destruct IH as [? [? ?]]
      end;
    (split; [congruence|split]);
    try (intros g E; cbn [Expression.value]; repeat match goal with V : forall g, _ -> _ |- _ => rewrite (V g E) end; reflexivity);
    try (intro E; cbn [Expression.value]; repeat match goal with V : _ = None -> _ |- _ => rewrite (V E) end;
         repeat match goal with |- context [match ?o with _ => _ end] => destruct o end; reflexivity).
Qed.

Lemma any_two f g : holds (Any [f; g]) <-> holds f \/ holds g.
Proof. rewrite holds_any, !Exists_cons, Exists_nil. tauto. Qed.
Lemma all_two f g : holds (All [f; g]) <-> holds f /\ holds g.
Proof. rewrite holds_all, (Forall_cons_iff holds), (Forall_cons_iff holds g []). intuition. Qed.

(** One case: where its condition holds, the function has the value of the term in its place. *)
Lemma one_case_sound f rest (P : Prop) a r b e h :
  (forall e g, Expression.value meant e = Expression.value meant f -> rest e = Some g -> (holds g <-> P)) ->
  (let* g := plain_link names a r b in let* k := rest e in Some (All [g; k])) = Some h ->
  (link meant true a r b -> Expression.value meant e = Expression.value meant f) ->
  (holds h <-> link meant true a r b /\ P).
Proof.
  intros R H V. options H. inversion H; subst. rewrite all_two, (plain_link_sound _ _ _ _ E). split; intros [L K].
  - split; [exact L|]. exact (proj1 (R _ _ (V L) E0) K).
  - split; [exact L|]. exact (proj2 (R _ _ (V L) E0) K).
Qed.

Lemma by_case_sound f rest (P : Prop) h :
  (forall e g, Expression.value meant e = Expression.value meant f -> rest e = Some g -> (holds g <-> P)) ->
  (Expression.value meant f = None -> ~ P) -> by_case names f rest = Some h -> (holds h <-> P).
Proof.
  intros R N H. destruct f; simpl in H; try discriminate; options H; inversion H; subst; clear H;
    rewrite holds_any, !Exists_cons, Exists_nil;
    repeat match goal with
      | E : (let* _ := plain_link names ?a ?r ?b in let* _ := rest ?e in _) = Some ?f |- _ =>
          rewrite (one_case_sound _ _ P a r b e f R E); [clear E|]
      end; rewrite ?link_true; cbn [Expression.value] in *.
  all: repeat match goal with |- context [Expression.value meant ?t] => destruct (Expression.value meant t) as [?|] end; simpl; try tauto.
  - split; [tauto|]. intro K. destruct (Rle_dec 0 r) as [L|L]; [left|right; left]; split; auto; lra.
  - intro L. rewrite Rabs_right by lra. reflexivity.
  - intro L. rewrite Rabs_left by lra. reflexivity.
  - split; [tauto|]. intro K. destruct (Rtotal_order r 0) as [L|[L|L]]; [right; right; left|right; left|left]; split; auto; lra.
  - intro L. unfold sign_of. destruct (Rlt_dec 0 r), (Rlt_dec r 0); try lra; f_equal; lra.
  - intro L. unfold sign_of. destruct (Rlt_dec 0 r), (Rlt_dec r 0); try lra; f_equal; lra.
  - intro L. unfold sign_of. destruct (Rlt_dec 0 r), (Rlt_dec r 0); try lra; f_equal; lra.
  - split; [tauto|]. intro K. destruct (Rle_dec r0 r) as [L|L]; [left|right; left]; split; auto; lra.
  - intro L. rewrite Rmin_right by lra. reflexivity.
  - intro L. rewrite Rmin_left by lra. reflexivity.
  - split; [tauto|]. intro K. destruct (Rle_dec r0 r) as [L|L]; [left|right; left]; split; auto; lra.
  - intro L. rewrite Rmax_left by lra. reflexivity.
  - intro L. rewrite Rmax_right by lra. reflexivity.
Qed.

Lemma apart_from_zero_sound ps : holds (apart_from_zero ps) <-> apart ps.
Proof.
  unfold apart_from_zero. rewrite holds_all, Forall_map. unfold NormalSound.apart. rewrite !Forall_forall.
  split; intros H p I; specialize (H p I); apply non_zero_sound; exact H.
Qed.

Lemma apart_app ps qs : apart (ps ++ qs) <-> apart ps /\ apart qs.
Proof. unfold NormalSound.apart. apply Forall_app. Qed.

Lemma term_divisors_sound e : forall ps, term_divisors names e = Some ps -> (apart ps <-> Expression.value meant e <> None).
Proof.
  assert (plain : forall d ps, (let* x := normal_term names d in Some (divs x)) = Some ps -> (apart ps <-> Expression.value meant d <> None)).
  { intros d ps H. options H. inversion H; subst. assert (S := normal_term_sound _ _ E).
    destruct (Expression.value meant d) as [x|].
    - apply stands_some in S. split; [discriminate|tauto].
    - apply stands_none in S. split; [tauto|congruence]. }
  induction e as [n|name|a IH|a IHa b IHb|a IHa b IHb|a IHa b IHb|a IHa b IHb|a IH n|a IH|a IH|a IHa b IHb|a IHa b IHb];
    intros ps H; cbn [term_divisors] in H;
    match type of H with (match ?i with _ => _ end) = _ => destruct i end; try discriminate;
    try (eapply plain; eassumption);
    try (cbn [Expression.value]; rewrite (IH _ H); destruct (Expression.value meant a); split; congruence);
    options H; inversion H; subst; rewrite apart_app, (IHa _ eq_refl), (IHb _ eq_refl); cbn [Expression.value];
    destruct (Expression.value meant a), (Expression.value meant b); split; try tauto; try congruence; try (intros _; split; discriminate).
Qed.

Lemma max_link (maximum on_left both : bool) r x y z :
  unequal r = true -> takes_both maximum on_left r = both ->
  let m := if maximum then Rmax x y else Rmin x y in
  (if on_left then compares m r z else compares z r m)
  <-> if both then (if on_left then compares x r z /\ compares y r z else compares z r x /\ compares z r y)
      else (if on_left then compares x r z \/ compares y r z else compares z r x \/ compares z r y).
Proof.
  intros U T. unfold Rmax, Rmin. destruct maximum, on_left, r; try discriminate; simpl in T; subst both; simpl;
    destruct (Rle_dec x y); split; intro H; try (destruct H; lra); try lra;
    try (destruct H as [H|H]; lra); try (left; lra); try (right; lra).
Qed.

Definition on_side (on_left : bool) (e : term) (r : rel) (z : term) : Prop :=
  if on_left then link meant true e r z else link meant true z r e.

Lemma operands_sound (maximum on_left : bool) r x y z h (rest : term -> option form) :
  unequal r = true ->
  (forall e g, rest e = Some g -> (holds g <-> on_side on_left e r z)) ->
  (let* f := rest x in
   let* g := rest y in
   if takes_both maximum on_left r then Some (All [f; g])
   else let* ps := term_divisors names x in let* qs := term_divisors names y in Some (All [Any [f; g]; apart_from_zero (ps ++ qs)])) = Some h ->
  (holds h <-> on_side on_left (if maximum then Maximum x y else Minimum x y) r z).
Proof.
  intros U R H. options H. apply R in E, E0. unfold on_side in *.
  destruct (takes_both maximum on_left r) eqn:T.
  - inversion H; subst. rewrite all_two, E, E0, !link_true || rewrite all_two, E, E0. clear E E0 H R.
    assert (M := fun x y z => max_link maximum on_left true r x y z U T). simpl in M.
    destruct on_left; rewrite !link_true; destruct maximum; cbn [Expression.value];
      destruct (Expression.value meant x) as [a|], (Expression.value meant y) as [b|], (Expression.value meant z) as [c|]; simpl; try tauto;
      specialize (M a b c); tauto.
  - options H. inversion H; subst. rewrite all_two, any_two, E, E0, apart_from_zero_sound, apart_app.
    assert (X := term_divisors_sound _ _ E1). assert (Y := term_divisors_sound _ _ E2). clear E E0 R H.
    assert (M := fun x y z => max_link maximum on_left false r x y z U T). simpl in M.
    destruct on_left; rewrite !link_true; destruct maximum; cbn [Expression.value];
      destruct (Expression.value meant x) as [a|], (Expression.value meant y) as [b|], (Expression.value meant z) as [c|];
      try (specialize (M a b c)); simpl in *; intuition congruence.
Qed.

Lemma normal_link_sound n : forall a r b h, normal_link names n a r b = Some h -> (holds h <-> link meant true a r b).
Proof.
  induction n as [|n IH]; intros a r b h H; [discriminate|]. cbn [normal_link] in H.
  assert (any : forall h, match innermost a, innermost b with
                | None, None => plain_link names a r b
                | Some (f, k), _ => by_case names f (fun x => normal_link names n (k x) r b)
                | None, Some (f, k) => by_case names f (fun x => normal_link names n a r (k x))
                end = Some h -> (holds h <-> link meant true a r b)).
  { clear h H. intros h H. destruct (innermost a) as [[f k]|] eqn:A; [|destruct (innermost b) as [[f k]|] eqn:B].
    - destruct (innermost_sound _ _ _ A) as [_ [V N]]. refine (by_case_sound f _ (link meant true a r b) h _ _ H).
      + intros e g E G. rewrite (IH _ _ _ _ G), !link_true, (V e E). tauto.
      + intros Z L. now rewrite link_true, (N Z) in L.
    - destruct (innermost_sound _ _ _ B) as [_ [V N]]. refine (by_case_sound f _ (link meant true a r b) h _ _ H).
      + intros e g E G. rewrite (IH _ _ _ _ G), !link_true, (V e E). tauto.
      + intros Z L. rewrite link_true, (N Z) in L. now destruct (Expression.value meant a).
    - apply plain_link_sound, H. }
  destruct (unequal r) eqn:U; [|apply any, H].
  assert (left_side : forall e g, normal_link names n e r b = Some g -> (holds g <-> on_side true e r b)) by (intros e g; apply IH).
  assert (right_side : forall e g, normal_link names n a r e = Some g -> (holds g <-> on_side false e r a)) by (intros e g; apply IH).
  assert (said : forall e m x y, extreme e = Some (m, x, y) -> e = if m then Maximum x y else Minimum x y).
  { intros e m x y E. destruct e; inversion E; reflexivity. }
  destruct (extreme a) as [[[m x] y]|] eqn:A; [|destruct (extreme b) as [[[m x] y]|] eqn:B; [|apply any, H]].
  - rewrite (said _ _ _ _ A). exact (operands_sound m true r x y b h _ U left_side H).
  - rewrite (said _ _ _ _ B). exact (operands_sound m false r x y a h _ U right_side H).
Qed.

Lemma links_with_sound form_of_link (truth : bool) links :
  (forall a r b h, form_of_link a r b = Some h -> (holds h <-> link meant true a r b)) ->
  forall a fs, links_with form_of_link truth a links = Some fs ->
  if truth then Forall holds fs <-> links_hold meant a links else Exists holds fs <-> links_fail meant a links.
Proof.
  intro S. induction links as [|[r b] links IH]; intros a fs H; simpl in H.
  - inversion H; subst. destruct truth; simpl; [split; auto|]. rewrite Exists_nil. tauto.
  - options H. inversion H; subst; clear H. assert (L := S _ _ _ _ E). specialize (IH _ _ E0). destruct truth; simpl.
    + rewrite (Forall_cons_iff holds), L, IH. tauto.
    + rewrite Exists_cons, L, IH, link_false. tauto.
Qed.
Definition normal_links_sound truth links := links_with_sound _ truth links (normal_link_sound most_functions).

Lemma all_sound f g : holds (all f g) <-> holds f /\ holds g.
Proof.
  assert (W : forall h, Forall holds [h] <-> holds h) by (intro h; rewrite (Forall_cons_iff holds h []); intuition).
  destruct f as [s p|fs|fs], g as [t q|gs|gs]; unfold all; rewrite holds_all, ?Forall_app, ?(Forall_cons_iff holds), ?W, ?holds_all;
    rewrite ?holds_all; intuition.
Qed.

Lemma any_sound f g : holds (any f g) <-> holds f \/ holds g.
Proof. unfold any. rewrite holds_any, !Exists_cons, Exists_nil. tauto. Qed.

Lemma normal_condition_sound c : forall truth f, normal_condition names truth c = Some f ->
  (holds f <-> is meant truth c).
Proof.
  induction c as [b|a links|c IH|c IHc d IHd|c IHc d IHd]; intros truth f H; cbn [normal_condition is] in *.
  - inversion H; subst. destruct b, truth; simpl; intuition discriminate.
  - options H. inversion H; subst; clear H.
    assert (K := normal_links_sound _ _ _ _ E). destruct truth; [rewrite holds_all|rewrite holds_any]; exact K.
  - apply IH, H.
  - options H. inversion H; subst; clear H. assert (A := IHc _ _ E). assert (B := IHd _ _ E0).
    destruct truth; [rewrite all_sound|rewrite any_sound]; tauto.
  - options H. inversion H; subst; clear H. assert (A := IHc _ _ E). assert (B := IHd _ _ E0).
    destruct truth; [rewrite any_sound|rewrite all_sound]; tauto.
Qed.

Lemma divisors_of_links_sound links : forall a ps, divisors_of_links names links = Some ps -> apart ps ->
  Expression.value meant a <> None -> links_hold meant a links \/ links_fail meant a links.
Proof.
  induction links as [|[r b] links IH]; intros a ps H A X; simpl in *; [tauto|].
  options H. inversion H; subst; clear H. apply apart_app in A. destruct A as [A B].
  assert (Y := proj1 (term_divisors_sound _ _ E) A). destruct (IH b _ eq_refl B Y) as [K|K]; [|tauto].
  destruct (Expression.value meant a) as [x|] eqn:F; [|congruence]. destruct (Expression.value meant b) as [y|] eqn:G; [|congruence].
  assert (D : compares x r y \/ ~ compares x r y) by (destruct r; simpl; lra).
  destruct D; [left; split; [|exact K]|right; left]; exists x, y; auto.
Qed.

Lemma divisors_sound c : forall ps, divisors names c = Some ps -> apart ps -> has_value meant c.
Proof.
  unfold has_value. induction c as [b|a links|c IH|c IHc d IHd|c IHc d IHd]; intros ps H A; cbn [divisors is] in *.
  - destruct b; tauto.
  - options H. inversion H; subst; clear H. apply apart_app in A. destruct A as [A B].
    exact (divisors_of_links_sound _ a _ E0 B (proj1 (term_divisors_sound _ _ E) A)).
  - specialize (IH _ H A). simpl. tauto.
  - options H. inversion H; subst; clear H. apply apart_app in A. destruct A as [A B].
    specialize (IHc _ eq_refl A). specialize (IHd _ eq_refl B). tauto.
  - options H. inversion H; subst; clear H. apply apart_app in A. destruct A as [A B].
    specialize (IHc _ eq_refl A). specialize (IHd _ eq_refl B). tauto.
Qed.
End Names.

End Sound.
