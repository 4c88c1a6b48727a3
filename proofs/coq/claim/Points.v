(** The conditions of a point as normal forms; that the load is of degree 1, and the forces are an interval. *)
From Coq Require Import String List Bool NArith ZArith Reals Lra Lia.
From Slipproof Require Import Text Syntax Meaning Poly Normal NormalSound.
From Slipproof.claim Require Import Expression Mechanism Claim Forms FormsSound Entails Covers Scopes.
Import ListNotations.
Local Open Scope R_scope.
Local Open Scope string_scope.

(** Without these variables; of degree 1 at most in the variable [k]. *)
Fixpoint mono_free (vs : list positive) (m : mono) : bool :=
  match m with One => true | Times w _ m => negb (in_list w vs) && mono_free vs m end.
Definition poly_free (vs : list positive) (p : poly) : bool := all_monos (mono_free vs) p.
Fixpoint form_free (vs : list positive) (f : form) : bool :=
  match f with Atom _ p => poly_free vs p | All fs | Any fs => forallb (form_free vs) fs end.
Fixpoint mono_affine (k : positive) (m : mono) : bool :=
  match m with
  | One => true
  | Times w e m => if Pos.eqb w k then Pos.eqb e 1 && mono_free [k] m else mono_affine k m
  end.
Definition poly_affine (k : positive) (p : poly) : bool := all_monos (mono_affine k) p.
Definition affine (k : positive) (f : fraction) : bool :=
  poly_affine k (num f) && poly_free [k] (or_one (den f)) && forallb (poly_free [k]) (divs f).

Section Points.
Variable s : setting.
Notation m := (of_mechanism s).
Let names := paper_scope s None.
Let inner := inner_scope s "".

Definition defined_form (f : option fraction) : option form := option_map (fun f => apart_from_zero (divs f)) f.
Definition slope_form (e : term) : option form :=
  let* f := normal_term (paper_scope s (Some 1%Z)) e in
  let* g := normal_term (paper_scope s (Some 0%Z)) e in comparison f Ne g.

Definition paper_forms : list (option form) :=
  map (fun d => normal_condition names true (snd d)) (paper_parameters s)
  ++ flat_map (fun '(c, n, d) => [normal_condition names true d; normal_condition names true (square_sum c n)]) (paper_angles s)
  ++ map (fun name => defined_form (scene_form s name)) (scene_symbols s)
  ++ match load m with
     | Some (l, _) => match given s l with Some e => [slope_form e] | None => [] end
     | None => []
     end.
Definition inner_forms : list (option form) :=
  flat_map (fun d => if is_given s (fst d) then [normal_condition inner true (snd d)] else []) (parameters m)
  ++ flat_map (fun '(c, n, d) => [normal_condition inner true d; normal_condition inner true (square_sum c n)]) (angles m)
  ++ map (normal_condition inner true) (assumptions m)
  ++ map (fun e => defined_form (normal_term inner e)) (numbers s).
Definition load_forms : list (option form) :=
  match load m with Some (_, c) => [normal_condition inner true c] | None => [] end.
Definition force_form : option form := normal_condition names true (force_domain s).

Fixpoint some_of (fs : list (option form)) : list form :=
  match fs with [] => [] | Some f :: fs => f :: some_of fs | None :: fs => some_of fs end.
Definition bicycle_facts : list form := some_of (paper_forms ++ inner_forms).
Definition point_facts : list form := bicycle_facts ++ some_of (force_form :: load_forms).

(** All of them, where none is missing and the unknowns do not occur: enough for a point. *)
Definition all_given (fs : list (option form)) : bool := forallb (fun f => match f with Some _ => true | None => false end) fs.
Definition load_fits : bool :=
  match load m with
  | None => true
  | Some (l, _) =>
      match given s l with
      | Some e => match normal_term names e with Some f => affine (code (force s)) f | None => false end
      | None => false
      end
  end.
Definition bicycle_fits : bool :=
  all_given (paper_forms ++ inner_forms)
  && forallb (form_free (map code (unknowns m))) (some_of inner_forms)
  && forallb (fun u => negb (is_in u (symbols s))) (unknowns m)
  && load_fits.
Definition point_forms : option (list form) :=
  require bicycle_fits && all_given (force_form :: load_forms)
          && forallb (form_free (map code (unknowns m))) (some_of load_forms) in
  Some point_facts.

Fixpoint convex (c : condition) : bool :=
  let fits e := match normal_term names e with
                | Some f => match den f, divs f with None, [] => poly_affine (code (force s)) (num f) | _, _ => false end
                | None => false
                end in
  match c with
  | Expression.Constant _ => true
  | Compare a links => fits a && forallb (fun l => match fst l with Ne => false | _ => fits (snd l) end) links
  | Both c d => convex c && convex d
  | _ => false
  end.
End Points.

(** Soundness *)

Lemma in_list_iff x xs : in_list x xs = true <-> In x xs.
Proof.
  split; [apply in_list_In|]. intro I. unfold in_list. apply existsb_exists. exists x. split; [exact I|apply Pos.eqb_refl].
Qed.

Lemma mono_free_value vs v w m : mono_free vs m = true -> (forall p, ~ In p vs -> v p = w p) -> value_mono v m = value_mono w m.
Proof.
  intros H E. induction m as [|x e m IH]; simpl in *; [reflexivity|]. apply andb_true_iff in H. destruct H as [A B].
  rewrite (IH B), E; [reflexivity|]. intro I. apply in_list_iff in I. now rewrite I in A.
Qed.

Lemma poly_free_value vs v w p : poly_free vs p = true -> (forall q, ~ In q vs -> v q = w q) -> value_at v p = value_at w p.
Proof.
  intros H E. unfold poly_free in H. induction p as [|c m p IH]; simpl in *; [reflexivity|].
  apply andb_true_iff in H. destruct H as [A B]. rewrite (IH B), (mono_free_value vs v w m A E). reflexivity.
Qed.

Lemma form_free_holds vs v w f : (forall q, ~ In q vs -> v q = w q) -> form_free vs f = true -> (holds v f <-> holds w f).
Proof.
  intro E. induction f as [s p|fs IH|fs IH] using form_nested_ind; intro H; simpl in H.
  - assert (V := poly_free_value _ _ _ _ H E). destruct s; simpl; rewrite V; tauto.
  - rewrite !holds_all, !Forall_forall. rewrite forallb_forall in H. rewrite Forall_forall in IH.
    split; intros K f I; apply (IH f I (H f I)), K, I.
  - rewrite !holds_any, !Exists_exists. rewrite forallb_forall in H. rewrite Forall_forall in IH.
    split; intros [f [I K]]; exists f; split; try exact I; apply (IH f I (H f I)), K.
Qed.

Lemma mono_affine_value k v m : mono_affine k m = true ->
  exists A B, forall w, (forall p, p <> k -> w p = v p) -> value_mono w m = A + B * w k.
Proof.
  induction m as [|x e m IH]; cbn [mono_affine value_mono]; intro H.
  - exists 1, 0. intros w E. ring.
  - destruct (Pos.eqb_spec x k) as [X|X].
    + subst x. apply andb_true_iff in H. destruct H as [L F]. apply Pos.eqb_eq in L. subst e.
      exists 0, (value_mono v m). intros w E. rewrite (mono_free_value [k] w v m F).
      * simpl. ring.
      * intros p I. apply E. intro Q. apply I. now left.
    + destruct (IH H) as [A [B K]]. exists (v x ^ Pos.to_nat e * A), (v x ^ Pos.to_nat e * B). intros w E.
      rewrite (K w E), (E x X). ring.
Qed.

Lemma poly_affine_value k v p : poly_affine k p = true ->
  exists A B, forall w, (forall q, q <> k -> w q = v q) -> value_at w p = A + B * w k.
Proof.
  unfold poly_affine. induction p as [|c m p IH]; simpl; intro H.
  - exists 0, 0. intros w E. ring.
  - apply andb_true_iff in H. destruct H as [L R]. destruct (IH R) as [A [B K]], (mono_affine_value k v m L) as [A' [B' K']].
    exists (IZR c * A' + A), (IZR c * B' + B). intros w E. rewrite (K w E), (K' w E). ring.
Qed.

Lemma some_of_In f fs : In f (some_of fs) <-> In (Some f) fs.
Proof.
  induction fs as [|[g|] fs IH]; simpl; [tauto| |].
  - rewrite IH. split; intros [H|H]; auto; [left; congruence|left; congruence].
  - rewrite IH. split; [auto|]. intros [H|H]; [discriminate|auto].
Qed.

Lemma append_nil_r name : (name ++ "")%string = name.
Proof. induction name as [|a name IH]; simpl; [reflexivity|now rewrite IH]. Qed.

Lemma affine_between a f g h : f <= g -> g <= h -> a * f <= a * g <= a * h \/ a * h <= a * g <= a * f.
Proof.
  intros F G. destruct (Rle_dec 0 a) as [A|A].
  - left. split; apply Rmult_le_compat_l; assumption.
  - right. assert (B : 0 <= - a) by lra. assert (P := Rmult_le_compat_l _ _ _ B F). assert (Q := Rmult_le_compat_l _ _ _ B G). lra.
Qed.

Lemma Rmult_minus_distr_r a b c : (a - b) * c = a * c - b * c.
Proof. ring. Qed.

Section Sound.
Variable s : setting.
Notation m := (of_mechanism s).

Definition agrees_with (v : positive -> R) (suffix : string) (x u : string -> R) : Prop :=
  (forall name, In name (symbols s) -> v (code name) = x name)
  /\ forall name, In name (unknowns m) -> v (code (name ++ suffix)) = u name.

Lemma defined_form_sound v f x g : defined_form f = Some g -> (forall h, f = Some h -> stands v h x) ->
  (holds v g <-> x <> None).
Proof.
  unfold defined_form. destruct f as [f|]; [|discriminate]. intros E S. inversion E; subst.
  rewrite apart_from_zero_sound. specialize (S f eq_refl). destruct x as [x|].
  - apply stands_some in S. intuition discriminate.
  - apply stands_none in S. intuition.
Qed.

Lemma slope_form_sound v x e f : (forall name, In name (symbols s) -> v (code name) = x name) -> slope_form s e = Some f ->
  (holds v f <-> exists a b, value (paper s (with_force s x 1)) e = Some a /\ value (paper s (with_force s x 0)) e = Some b /\ a <> b).
Proof.
  intros A H. unfold slope_form in H. options H.
  assert (S := normal_term_sound v _ _ (paper_agrees_with v s x A 1) _ _ E).
  assert (T := normal_term_sound v _ _ (paper_agrees_with v s x A 0) _ _ E0).
  rewrite (comparison_sound v _ _ _ _ _ _ H S T). unfold compare. simpl.
  destruct (value (paper s (with_force s x 1)) e) as [a|], (value (paper s (with_force s x 0)) e) as [b|]; simpl.
  - split; [intros [_ [_ N]]; exists a, b; auto|]. intros [a' [b' [E1 [E2 N]]]]. inversion E1; inversion E2; subst. repeat split; congruence.
  - split; [intros [_ [N _]]; congruence|intros [? [? [_ [N _]]]]; discriminate].
  - split; [intros [N _]; congruence|intros [? [? [N _]]]; discriminate].
  - split; [intros [N _]; congruence|intros [? [? [N _]]]; discriminate].
Qed.

Ltac in_parts I := repeat (apply in_app_or in I; destruct I as [I|I]).

(** At a point, its conditions hold. *)
Lemma bicycle_facts_hold v x u : bicycle s x -> agrees_with v "" x u -> Forall (holds v) (bicycle_facts s).
Proof.
  intros P [A U]. apply Forall_forall. intros f I. unfold bicycle_facts in I. apply some_of_In in I.
  assert (N := paper_agrees v s x A). assert (J := inner_agrees v s x A "" u U).
  apply in_app_or in I. destruct I as [I|I]; unfold paper_forms, inner_forms in I; in_parts I.
  - apply in_map_iff in I. destruct I as [[p c] [E I]]. apply (normal_condition_sound v _ _ N _ _ _ E), (domains s x P _ _ I).
  - apply in_flat_map in I. destruct I as [[[c n] d] [I K]]. destruct (paper_circles s x P _ _ _ I) as [D Q].
    destruct K as [E|[E|[]]]; apply (normal_condition_sound v _ _ N _ _ _ E); assumption.
  - apply in_map_iff in I. destruct I as [name [E I]].
    apply (defined_form_sound v _ (from_scene s x name) _ E); [|apply (scene_values s x P _ I)].
    intros h K. exact (scene_agrees v s x A name h K).
  - destruct (load m) as [[l c]|] eqn:L; [|contradiction]. destruct (given s l) as [e|] eqn:G; [|contradiction].
    destruct I as [E|[]]. apply (slope_form_sound v x e f A E).
    assert (D := degree_one s x P). unfold load_has_degree_one in D. rewrite L in D.
    destruct D as [e' [a [b [E' [Z V]]]]]. rewrite G in E'. inversion E'; subst.
    exists (a * 1 + b), (a * 0 + b). rewrite !V. repeat split; auto. lra.
  - apply in_flat_map in I. destruct I as [[p c] [I K]]. simpl in K. destruct (is_given s p) eqn:G; [|contradiction].
    destruct K as [E|[]]. apply (normal_condition_sound v _ _ J _ _ _ E), (mechanism_domains s x P u _ _ I G).
  - apply in_flat_map in I. destruct I as [[[c n] d] [I K]]. destruct (circles s x P u _ _ _ I) as [D Q].
    destruct K as [E|[E|[]]]; apply (normal_condition_sound v _ _ J _ _ _ E); assumption.
  - apply in_map_iff in I. destruct I as [c [E I]]. apply (normal_condition_sound v _ _ J _ _ _ E), (assumed s x P u _ I).
  - apply in_map_iff in I. destruct I as [e [E I]].
    apply (defined_form_sound v _ (value (in_scene s x u) e) _ E); [|apply (coefficients s x P u _ I)].
    intros h K. exact (normal_term_sound v _ _ J _ _ K).
Qed.

Lemma point_facts_hold v x u : point s x -> agrees_with v "" x u -> Forall (holds v) (point_facts s).
Proof.
  intros P Q. apply Forall_app. split; [exact (bicycle_facts_hold v x u (of_bicycle s x P) Q)|]. destruct Q as [A U].
  apply Forall_forall. intros f I. apply some_of_In in I. destruct I as [E|I].
  - apply (normal_condition_sound v _ _ (paper_agrees v s x A) _ _ _ E), (force_in_domain s x P).
  - unfold load_forms in I. destruct (load m) as [[l c]|] eqn:L; [|contradiction].
    destruct I as [E|[]]. apply (normal_condition_sound v _ _ (inner_agrees v s x A "" u U) _ _ _ E), (load_in_domain s x P u l c L).
Qed.

Lemma code_injective name other : code name = code other -> name = other.
Proof. intro E. rewrite <- (decode_code name), E. apply decode_code. Qed.

(** The values of the paper's symbols at which the force is [t]. *)
Definition at_force (x : string -> R) (t : R) (p : positive) : R := if Pos.eqb p (code (force s)) then t else x (decode p).

Lemma at_force_agrees x t name : at_force x t (code name) = with_force s x t name.
Proof.
  unfold at_force, with_force. destruct (String.eqb_spec name (force s)) as [E|E].
  - subst. now rewrite Pos.eqb_refl.
  - destruct (Pos.eqb_spec (code name) (code (force s))) as [F|F]; [now apply code_injective in F|]. now rewrite decode_code.
Qed.

Lemma at_force_scope x t : agrees (at_force x t) (paper_scope s None) (paper s (with_force s x t)).
Proof. apply paper_agrees. intros name _. apply at_force_agrees. Qed.

Lemma at_force_other x t q : q <> code (force s) -> at_force x t q = at_force x 0 q.
Proof. intro H. unfold at_force. destruct (Pos.eqb_spec q (code (force s))); [contradiction|reflexivity]. Qed.

Lemma at_force_force x t : at_force x t (code (force s)) = t.
Proof. unfold at_force. now rewrite Pos.eqb_refl. Qed.

Lemma affine_sound x e f y : normal_term (paper_scope s None) e = Some f -> affine (code (force s)) f = true ->
  value (paper s (with_force s x y)) e <> None ->
  exists a b, forall t, value (paper s (with_force s x t)) e = Some (a * t + b).
Proof.
  intros N F Y. unfold affine in F. apply andb_true_iff in F. destruct F as [F D]. apply andb_true_iff in F. destruct F as [P Q].
  assert (A : forall t, stands (at_force x t) f (value (paper s (with_force s x t)) e)).
  { intro t. apply (normal_term_sound _ _ _ (at_force_scope x t) _ _ N). }
  assert (O : forall t q, ~ In q [code (force s)] -> at_force x t q = at_force x 0 q).
  { intros t q H. apply at_force_other. intro E. apply H. now left. }
  destruct (poly_affine_value _ (at_force x 0) _ P) as [c [d K]].
  set (z := value_at (at_force x 0) (or_one (den f))).
  assert (Z : forall t, value_at (at_force x t) (or_one (den f)) = z) by (intro t; apply (poly_free_value _ _ _ _ Q), O).
  assert (G : forall t, apart (at_force x t) (divs f) <-> apart (at_force x 0) (divs f)).
  { intro t. unfold apart. rewrite !Forall_forall. rewrite forallb_forall in D.
    split; intros H p I; specialize (H p I); rewrite (poly_free_value _ _ _ p (D p I) (O t)) in *; exact H. }
  assert (B : apart (at_force x 0) (divs f)).
  { apply (G y). specialize (A y). destruct (value (paper s (with_force s x y)) e) as [r|]; [|congruence].
    apply stands_some in A. tauto. }
  exists (d / z), (c / z). intro t. specialize (A t). destruct (value (paper s (with_force s x t)) e) as [r|].
  - apply stands_some in A. destruct A as [_ [E R]]. rewrite Z in E, R. rewrite R, (K (at_force x t)), at_force_force.
    + f_equal. field. exact E.
    + intros q H. apply at_force_other, H.
  - exfalso. apply stands_none in A. apply A, (G t), B.
Qed.

Definition with_unknowns (v : positive -> R) (u : string -> R) (p : positive) : R :=
  if in_list p (map code (unknowns m)) then u (decode p) else v p.

Lemma with_unknowns_symbol v x u name : forallb (fun u => negb (is_in u (symbols s))) (unknowns m) = true ->
  (forall name, In name (symbols s) -> v (code name) = x name) -> In name (symbols s) -> with_unknowns v u (code name) = x name.
Proof.
  intros C A I. rewrite forallb_forall in C. unfold with_unknowns. destruct (in_list (code name) (map code (unknowns m))) eqn:J; [|apply A, I].
  apply in_list_iff, in_map_iff in J. destruct J as [n [J K]]. apply code_injective in J. subst.
  specialize (C _ K). apply is_in_In in I. rewrite I in C. discriminate.
Qed.

Lemma with_unknowns_unknown v u name : In name (unknowns m) -> with_unknowns v u (code (name ++ "")) = u name.
Proof.
  intro I. rewrite append_nil_r. unfold with_unknowns.
  assert (J : in_list (code name) (map code (unknowns m)) = true) by (apply in_list_iff, in_map, I).
  now rewrite J, decode_code.
Qed.

(** A form without unknowns holds whatever they are. *)
Lemma with_unknowns_holds v u f : form_free (map code (unknowns m)) f = true -> holds v f -> holds (with_unknowns v u) f.
Proof.
  intros F H. apply (form_free_holds (map code (unknowns m)) v); [|exact F|exact H].
  intros q Q. unfold with_unknowns. destruct (in_list q (map code (unknowns m))) eqn:K; [|reflexivity].
  apply in_list_iff in K. contradiction.
Qed.

Lemma all_given_In fs o : all_given fs = true -> In o fs -> exists f, o = Some f /\ In f (some_of fs).
Proof.
  unfold all_given. rewrite forallb_forall. intros G I. specialize (G _ I). destruct o as [f|]; [|discriminate].
  exists f. split; [reflexivity|]. apply some_of_In, I.
Qed.

(** Where all conditions hold, there is a bicycle, or a point. *)
Lemma bicycle_of_forms v x : bicycle_fits s = true -> Forall (holds v) (bicycle_facts s) ->
  (forall name, In name (symbols s) -> v (code name) = x name) -> bicycle s x.
Proof.
  intros E F A. unfold bicycle_fits in E. apply andb_true_iff in E. destruct E as [E L]. apply andb_true_iff in E. destruct E as [E C].
  apply andb_true_iff in E. destruct E as [G W]. rewrite forallb_forall in W. rewrite Forall_forall in F.
  assert (N := paper_agrees v s x A).
  assert (have : forall o, In o (paper_forms s ++ inner_forms s) -> exists f, o = Some f /\ holds v f).
  { intros o I. destruct (all_given_In _ _ G I) as [f [E J]]. exists f. split; [exact E|apply F, J]. }
  assert (M : forall u, agrees (with_unknowns v u) (inner_scope s "") (in_scene s x u)).
  { intro u. apply inner_agrees; [intros name I; exact (with_unknowns_symbol v x u name C A I)|apply with_unknowns_unknown]. }
  assert (have_inner : forall o, In o (inner_forms s) -> exists f, o = Some f /\ forall u, holds (with_unknowns v u) f).
  { intros o I. destruct (have o) as [f [E H]]; [apply in_or_app; now right|]. exists f. split; [exact E|]. intro u.
    apply with_unknowns_holds; [|exact H]. apply W, some_of_In. congruence. }
  assert (paper_true : forall c, In (normal_condition (paper_scope s None) true c) (paper_forms s) -> is (paper s x) true c).
  { intros c I. destruct (have (normal_condition (paper_scope s None) true c)) as [f [E H]]; [apply in_or_app; now left|].
    exact (proj1 (normal_condition_sound v _ _ N _ _ _ E) H). }
  assert (inner_true : forall u c, In (normal_condition (inner_scope s "") true c) (inner_forms s) -> is (in_scene s x u) true c).
  { intros u c I. destruct (have_inner _ I) as [f [E H]]. exact (proj1 (normal_condition_sound _ _ _ (M u) _ _ _ E) (H u)). }
  unfold paper_forms, inner_forms in *. constructor.
  - intros p c I. apply paper_true. apply in_or_app. left. apply in_map_iff. exists (p, c). split; [reflexivity|exact I].
  - intros c n d I. split; apply paper_true; apply in_or_app; right; apply in_or_app; left; apply in_flat_map; exists (c, n, d);
      (split; [exact I|]); [left; reflexivity|right; left; reflexivity].
  - intros name I. destruct (have (defined_form (scene_form s name))) as [f [E H]].
    { apply in_or_app; left. apply in_or_app; right; apply in_or_app; right; apply in_or_app; left.
      apply in_map_iff. exists name. split; [reflexivity|exact I]. }
    apply (defined_form_sound v _ (from_scene s x name) _ E); [|exact H]. intros h K. exact (scene_agrees v s x A name h K).
  - intros u p c I Q. apply inner_true. apply in_or_app. left. apply in_flat_map. exists (p, c).
    split; [exact I|]. change (fst (p, c)) with p. rewrite Q. left. reflexivity.
  - intros u c n d I. split; apply inner_true; apply in_or_app; right; apply in_or_app; left; apply in_flat_map; exists (c, n, d);
      (split; [exact I|]); [left; reflexivity|right; left; reflexivity].
  - intros u c I. apply inner_true. do 2 (apply in_or_app; right). apply in_or_app; left. apply in_map_iff. exists c. split; [reflexivity|exact I].
  - intros u e I. destruct (have_inner (defined_form (normal_term (inner_scope s "") e))) as [f [E H]].
    { do 3 (apply in_or_app; right). apply in_map_iff. exists e. split; [reflexivity|exact I]. }
    apply (defined_form_sound (with_unknowns v u) _ (value (in_scene s x u) e) _ E); [|apply H].
    intros h K. exact (normal_term_sound _ _ _ (M u) _ _ K).
  - unfold load_has_degree_one, load_fits in *. destruct (load m) as [[l c]|] eqn:Q; [|exact Logic.I].
    destruct (given s l) as [e|] eqn:K; [|discriminate]. destruct (normal_term (paper_scope s None) e) as [f|] eqn:T; [|discriminate].
    destruct (have (slope_form s e)) as [g [E H]].
    { apply in_or_app; left. do 3 (apply in_or_app; right). now left. }
    apply (slope_form_sound v x e g A E) in H. destruct H as [y1 [y0 [Y1 [Y0 Y]]]].
    destruct (affine_sound x e f 0 T L) as [a [b B]]; [congruence|].
    exists e, a, b. repeat split; [|exact B]. intro Z. subst. rewrite B in Y1, Y0. inversion Y1; inversion Y0; subst. apply Y. ring.
Qed.

Lemma point_of_forms v x fs : point_forms s = Some fs -> Forall (holds v) fs ->
  (forall name, In name (symbols s) -> v (code name) = x name) -> point s x.
Proof.
  intros H F A. unfold point_forms in H. options H. inversion H; subst; clear H.
  apply andb_true_iff in E. destruct E as [E W]. apply andb_true_iff in E. destruct E as [B G].
  assert (C : forallb (fun u => negb (is_in u (symbols s))) (unknowns m) = true).
  { unfold bicycle_fits in B. apply andb_true_iff in B. destruct B as [B _]. apply andb_true_iff in B. tauto. }
  apply Forall_app in F. destruct F as [F P]. rewrite forallb_forall in W. rewrite Forall_forall in P. constructor.
  - exact (bicycle_of_forms v x B F A).
  - intros u l c Q. destruct (all_given_In _ (normal_condition (inner_scope s "") true c) G) as [f [E I]].
    { right. unfold load_forms. rewrite Q. now left. }
    assert (J : In f (some_of (load_forms s))) by (apply some_of_In; unfold load_forms; rewrite Q, E; now left).
    assert (M : agrees (with_unknowns v u) (inner_scope s "") (in_scene s x u)).
    { apply inner_agrees; [intros name K; exact (with_unknowns_symbol v x u name C A K)|apply with_unknowns_unknown]. }
    exact (proj1 (normal_condition_sound _ _ _ M _ _ _ E) (with_unknowns_holds v u f (W _ J) (P _ I))).
  - destruct (all_given_In _ (force_form s) G (or_introl eq_refl)) as [f [E I]].
    exact (proj1 (normal_condition_sound v _ _ (paper_agrees v s x A) _ _ _ E) (P _ I)).
Qed.

(** The forces *)

Lemma convex_fits x e f : normal_term (paper_scope s None) e = Some f -> den f = None -> divs f = [] ->
  poly_affine (code (force s)) (num f) = true ->
  exists a b, forall t, value (paper s (with_force s x t)) e = Some (a * t + b).
Proof.
  intros N D V P. apply (affine_sound x e f 0 N).
  - unfold affine. rewrite P, D, V. reflexivity.
  - assert (S := normal_term_sound _ _ _ (at_force_scope x 0) _ _ N). intro E. rewrite E in S. apply stands_none in S.
    apply S. rewrite V. constructor.
Qed.

Definition fits_affinely (x : string -> R) (e : term) : Prop :=
  exists a b, forall t, value (paper s (with_force s x t)) e = Some (a * t + b).

Lemma convex_links x links : forall e, fits_affinely x e ->
  Forall (fun l => fst l <> Ne /\ fits_affinely x (snd l)) links ->
  let at_t t := links_hold (paper s (with_force s x t)) e links in
  (forall t, at_t t \/ links_fail (paper s (with_force s x t)) e links)
  /\ forall f g h, f <= g -> g <= h -> at_t f -> at_t h -> at_t g.
Proof.
  induction links as [|[r b] links IH]; intros e [a1 [b1 E]] L; simpl; [tauto|].
  inversion L as [|? ? [Q [a2 [b2 B]]] Ls]; subst. simpl in Q, B. destruct (IH b (ex_intro _ a2 (ex_intro _ b2 B)) Ls) as [H K].
  unfold link. split.
  - intro t. destruct (H t) as [J|J]; [|tauto]. rewrite E, B.
    assert (D : compares (a1 * t + b1) r (a2 * t + b2) \/ ~ compares (a1 * t + b1) r (a2 * t + b2)) by (destruct r; simpl; lra).
    destruct D as [D|D]; [left; split; [|exact J]|right; left]; eexists; eexists; eauto.
  - intros f g h F G [[y [z [Y [Z C]]]] A] [[y' [z' [Y' [Z' C']]]] A']. split; [|exact (K f g h F G A A')].
    rewrite E in *. rewrite B in *. inversion Y; inversion Z; inversion Y'; inversion Z'; subst.
    eexists; eexists. repeat split. clear E B Ls IH L H K A A' Y Z Y' Z'.
    assert (S := affine_between (a1 - a2) f g h F G). rewrite !Rmult_minus_distr_r in S.
    destruct r; simpl in *; try congruence; lra.
Qed.

Lemma convex_sound x c : convex s c = true ->
  (forall t, has_value (paper s (with_force s x t)) c)
  /\ forall f g h, f <= g -> g <= h -> is (paper s (with_force s x f)) true c -> is (paper s (with_force s x h)) true c ->
                   is (paper s (with_force s x g)) true c.
Proof.
  unfold has_value. induction c as [b|e links|c IH|c IHc d IHd|c IHc d IHd]; intro H; cbn [convex is] in *; try discriminate.
  - split; [intro; destruct b; auto|auto].
  - apply andb_true_iff in H. destruct H as [A L].
    assert (fits : forall e, match normal_term (paper_scope s None) e with
                | Some f => match den f, divs f with None, [] => poly_affine (code (force s)) (num f) | _, _ => false end
                | None => false end = true -> fits_affinely x e).
    { intros t T. destruct (normal_term (paper_scope s None) t) as [f|] eqn:N; [|discriminate].
      destruct (den f) eqn:D; [discriminate|]. destruct (divs f) eqn:V; [|discriminate]. exact (convex_fits x t f N D V T). }
    apply convex_links; [apply fits, A|]. rewrite forallb_forall in L. apply Forall_forall. intros [r t] I. specialize (L _ I).
    simpl in *. destruct r; try discriminate; (split; [discriminate|apply fits, L]).
  - apply andb_true_iff in H. destruct H as [A B]. destruct (IHc A) as [V C], (IHd B) as [W D]. split.
    + intro t. destruct (V t), (W t); tauto.
    + intros f g h F G [P Q] [P' Q']. split; [exact (C f g h F G P P')|exact (D f g h F G Q Q')].
Qed.

Lemma interval_sound x : convex s (force_domain s) = true -> forces_are_an_interval s x.
Proof. apply convex_sound. Qed.
End Sound.
