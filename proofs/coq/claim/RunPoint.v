(** Whether rational values are a point of the mechanism, and a force. *)
From Coq Require Import String List Bool ZArith QArith Qreals Reals Lra Lia.
From Slipproof Require Import Text Syntax.
From Slipproof.claim Require Import Expression Mechanism Claim RunValues RunConditions.
From Slipproof.claim Require Linear Points.
Import ListNotations.
Local Open Scope R_scope.

Definition lookup (q : list (string * Q)) (name : string) : Q :=
  match find (fun e => String.eqb (fst e) name) q with Some e => snd e | None => 0%Q end.

Fixpoint position (name : string) (names : list string) : nat :=
  match names with [] => O | n :: names => if String.eqb name n then O else S (position name names) end.
Definition unknown (k : nat) : answer := Affine (Linear.Linear (repeat 0%Q k ++ [1%Q]) 0).

Definition defined_by (ds : list (string * term)) (names : scope) : scope :=
  fold_left (fun names d => with_answer (fst d) (answer_of names (snd d)) names) ds names.
Definition with_all (f : string -> answer) (names : list string) (base : scope) : scope :=
  fold_left (fun scope name => with_answer name (f name) scope) names base.

Definition must (s : status) : option bool := match s with Yes => Some true | No | Neither => Some false | Unknown => None end.
Definition has_answer (a : answer) : option bool := match a with Affine _ => Some true | Undefined => Some false | Unclear => None end.
Definition all_of (bs : list (option bool)) : option bool :=
  if existsb (fun b => match b with Some false => true | _ => false end) bs then Some false
  else if forallb (fun b => match b with Some true => true | _ => false end) bs then Some true else None.

Section Run.
Variable s : setting.
Variable q : list (string * Q).
Notation m := (of_mechanism s).

Definition paper_names (at_symbol : string -> linear) : scope :=
  defined_by (paper_definitions s) (with_all (fun name => Affine (at_symbol name)) (symbols s) (fun _ => Undefined)).
Definition here : scope := paper_names (fun name => fixed (lookup q name)).
(** With the force as the only unknown. *)
Definition along : scope :=
  paper_names (fun name => if String.eqb name (force s) then Linear.Linear [1%Q] 0 else fixed (lookup q name)).

Section Names.
(** What [here] is. *)
Variable paper_here : scope.

Definition of_scene (name : string) : answer :=
  match given s name with Some e => answer_of paper_here e | None => number 0 end.
Definition inner_names : scope :=
  defined_by (definitions m)
    (with_all (fun name => unknown (position name (unknowns m))) (unknowns m)
       (with_all of_scene (scene_symbols s) (fun _ => Undefined))).

Section Checks.
Variables paper_along inner : scope.

Definition load_check : option bool :=
  match load m with
  | None => Some true
  | Some (l, _) =>
      match given s l with
      | None => Some false
      | Some e =>
          match answer_of paper_along e with
          | Affine (Linear.Linear [] _) | Undefined => Some false
          | Affine (Linear.Linear [a] _) => Some (negb (is_zero a))
          | _ => None
          end
      end
  end.
Definition circle_checks (names : scope) (a : string * string * condition) : list (option bool) :=
  let '(c, n, d) := a in [must (status_of names d); must (status_of names (square_sum c n))].

Definition bicycle_checks : list (option bool) :=
  map (fun d => must (status_of paper_here (snd d))) (paper_parameters s)
  ++ flat_map (circle_checks paper_here) (paper_angles s)
  ++ map (fun name => has_answer (of_scene name)) (scene_symbols s)
  ++ map (fun d => if is_given s (fst d) then must (status_of inner (snd d)) else Some true) (parameters m)
  ++ flat_map (circle_checks inner) (angles m)
  ++ map (fun c => must (status_of inner c)) (assumptions m)
  ++ map (fun e => has_answer (answer_of inner e)) (numbers s)
  ++ [load_check].
Definition force_checks : list (option bool) :=
  [match load m with Some (_, c) => must (status_of inner c) | None => Some true end; must (status_of paper_here (force_domain s))].
(** With a force of the domain, or with any. *)
Definition is_point (of_domain : bool) : option bool := all_of (bicycle_checks ++ if of_domain then force_checks else []).

(** Comparisons of numbers that are affine in the force, and conjunctions of them, hold on an interval. *)
Definition is_affine (a : answer) : bool :=
  match a with Affine (Linear.Linear [] _) | Affine (Linear.Linear [_] _) => true | _ => false end.
Fixpoint on_interval (c : condition) : bool :=
  match c with
  | Constant _ => true
  | Compare a links => is_affine (answer_of paper_along a)
                       && forallb (fun l => match fst l with Ne => false | _ => is_affine (answer_of paper_along (snd l)) end) links
  | Both c d => on_interval c && on_interval d
  | _ => false
  end.
End Checks.
End Names.

Definition mechanism_scope (inner : scope) : scope :=
  fold_left (fun names d => with_answer (fst d) (answer_of inner (snd d)) names) (quantities m) inner.
Definition motion_scope (paper_here mech : scope) : scope :=
  let own := unknowns m ++ map fst (quantities m) in
  fun name => if existsb (String.eqb name) own then mech name else paper_here name.

(** Soundness *)

Definition agree (z : nat -> R) (names : scope) (meant : meanings) : Prop := forall name, means z (names name) (meant name).

Lemma with_answer_agree z names meant name a o : agree z names meant -> means z a o -> agree z (with_answer name a names) (with_name name o meant).
Proof. intros A M other. unfold with_answer, with_name. destruct (String.eqb other name); auto. Qed.

Lemma defined_by_agree z ds : forall names meant, agree z names meant -> agree z (defined_by ds names) (define ds meant).
Proof.
  unfold defined_by, define. induction ds as [|d ds IH]; intros names meant A; simpl; [exact A|].
  apply IH, with_answer_agree; [exact A|]. apply answer_means, A.
Qed.

Lemma with_all_is f names : forall base other,
  with_all f names base other = if existsb (String.eqb other) names then f other else base other.
Proof.
  unfold with_all. induction names as [|name names IH]; intros base other; simpl; [reflexivity|].
  rewrite IH. unfold with_answer. destruct (String.eqb_spec other name) as [E|E]; simpl; [|reflexivity]. subst. now destruct (existsb _ _).
Qed.

Lemma paper_names_agree z at_symbol y : (forall name, affine_value z (at_symbol name) = y name) ->
  agree z (paper_names at_symbol) (paper s y).
Proof.
  intro V. apply defined_by_agree. intro name. rewrite with_all_is. destruct (existsb _ _); simpl; [|reflexivity].
  now rewrite V.
Qed.

Definition x (name : string) : R := Q2R (lookup q name).

Lemma here_agree z : agree z here (paper s x).
Proof. apply paper_names_agree. intro name. apply fixed_value. Qed.
Lemma along_agree t : agree (fun _ => t) along (paper s (with_force s x t)).
Proof.
  apply paper_names_agree. intro name. unfold with_force. destruct (String.eqb name (force s)); [|apply fixed_value].
  unfold Linear.value; simpl. rewrite real_zero. unfold Q2R; simpl. field.
Qed.

(** [z] are the values of the unknowns in their order, [u] by their names. *)
Definition reads (z : nat -> R) (u : string -> R) : Prop := forall name, In name (unknowns m) -> z (position name (unknowns m)) = u name.
Definition by_name (z : nat -> R) (name : string) : R := z (position name (unknowns m)).
Definition in_order (u : string -> R) (i : nat) : R := u (nth i (unknowns m) ""%string).

Lemma reads_by_name z : reads z (by_name z).
Proof. intros name _. reflexivity. Qed.
Lemma reads_in_order u : reads (in_order u) u.
Proof.
  intros name I. unfold in_order. f_equal. induction (unknowns m) as [|n names IH]; simpl; [contradiction|].
  destruct (String.eqb_spec name n) as [E|E]; [auto|]. apply IH. destruct I; [congruence|assumption].
Qed.

Lemma unknown_value z k : affine_value z (Linear.Linear (repeat 0%Q k ++ [1%Q]) 0) = z k.
Proof.
  unfold Linear.value; simpl. rewrite real_zero, Rplus_0_l. revert z. induction k as [|k IH]; intro z; simpl.
  - unfold Q2R; simpl. field.
  - rewrite IH, real_zero. ring.
Qed.

Lemma of_scene_means z name : means z (of_scene here name) (from_scene s x name).
Proof.
  unfold of_scene, from_scene. destruct (given s name); [apply answer_means, here_agree|]. simpl. now rewrite fixed_value, real_zero.
Qed.
Lemma inner_agree z u : reads z u -> agree z (inner_names here) (in_scene s x u).
Proof.
  intro U. apply defined_by_agree. intro name. rewrite !with_all_is. destruct (existsb _ (unknowns m)) eqn:E.
  - unfold unknown, means. rewrite unknown_value, U; [reflexivity|]. apply existsb_exists in E. destruct E as [n [I E]].
    apply String.eqb_eq in E. now subst.
  - destruct (existsb _ (scene_symbols s)); [|reflexivity]. apply of_scene_means.
Qed.
Lemma mechanism_agree z u : reads z u -> agree z (mechanism_scope (inner_names here)) (mechanism_names s x u).
Proof.
  intro U. unfold mechanism_scope, mechanism_names. assert (A := inner_agree z u U).
  enough (H : forall qs names meant, agree z names meant ->
    agree z (fold_left (fun names d => with_answer (fst d) (answer_of (inner_names here) (snd d)) names) qs names)
            (fold_left (fun names d => with_name (fst d) (value (in_scene s x u) (snd d)) names) qs meant)) by (apply H, A).
  induction qs as [|d qs IH]; intros names meant B; simpl; [exact B|]. apply IH, with_answer_agree; [exact B|]. apply answer_means, A.
Qed.
Lemma motion_scope_agree z u : reads z u ->
  agree z (motion_scope here (mechanism_scope (inner_names here))) (names_of_motion s x u).
Proof.
  intros U name. unfold motion_scope, names_of_motion. destruct (existsb _ _); [apply mechanism_agree, U|apply here_agree].
Qed.

Lemma must_sound z names meant c : agree z names meant ->
  match must (status_of names c) with Some true => is meant true c | Some false => ~ is meant true c | None => True end.
Proof.
  intro A. assert (S := status_sound z names meant A c). destruct (status_of names c); simpl; auto.
  - intro T. exact (consistent _ _ T S).
  - intro T. apply S. now left.
Qed.
Lemma has_answer_sound z a o : means z a o ->
  match has_answer a with Some true => o <> None | Some false => ~ o <> None | None => True end.
Proof. destruct a; simpl; intro M; subst; [exact I|tauto|discriminate]. Qed.

Lemma all_of_true bs : all_of bs = Some true -> forall b, In b bs -> b = Some true.
Proof.
  unfold all_of. destruct (existsb _ bs); [discriminate|]. destruct (forallb _ bs) eqn:E; [|discriminate]. intros _ b I.
  rewrite forallb_forall in E. specialize (E b I). destruct b as [[|]|]; congruence.
Qed.
Lemma all_of_false bs : all_of bs = Some false -> In (Some false) bs.
Proof.
  unfold all_of. destruct (existsb _ bs) eqn:E; [|destruct (forallb _ bs); discriminate]. intros _.
  apply existsb_exists in E. destruct E as [[[|]|] [I E]]; try discriminate. exact I.
Qed.

Lemma must_here d : match must (status_of here d) with
  | Some true => is (paper s x) true d | Some false => ~ is (paper s x) true d | None => True end.
Proof. apply (must_sound (fun _ => 0)), here_agree. Qed.
Lemma must_inner d u : match must (status_of (inner_names here) d) with
  | Some true => is (in_scene s x u) true d | Some false => ~ is (in_scene s x u) true d | None => True end.
Proof. apply (must_sound (in_order u)), inner_agree, reads_in_order. Qed.

Ltac told H C := let T := fresh "T" in assert (T := H); rewrite C in T.

Lemma load_check_sound : match load_check along with
  | Some true => load_has_degree_one s x | Some false => ~ load_has_degree_one s x | None => True end.
Proof.
  unfold load_check, load_has_degree_one. destruct (load m) as [[l c]|]; [|exact I]. destruct (given s l) as [e|].
  - assert (A := fun t => answer_means _ _ _ (along_agree t) e). destruct (answer_of along e) as [| |[[|a [|b bs]] k]]; try exact I; simpl in A.
    + intros [e' [a [b [E [_ V]]]]]. inversion E; subst. specialize (A 0). rewrite V in A. discriminate.
    + intros [e' [a [b [E [N V]]]]]. inversion E; subst. assert (V0 := V 0). assert (V1 := V 1). rewrite A in V0, V1.
      inversion V0 as [W0]. inversion V1 as [W1]. unfold Linear.value in *. simpl in *. lra.
    + assert (W : forall t, value (paper s (with_force s x t)) e = Some (Q2R a * t + Q2R k)).
      { intro t. rewrite A. unfold Linear.value; simpl. f_equal. ring. }
      destruct (is_zero a) eqn:Z; simpl.
      * intros [e' [a' [b [E [N V]]]]]. inversion E; subst. assert (V0 := V 0). assert (V1 := V 1). rewrite W in V0, V1.
        inversion V0 as [W0]. inversion V1 as [W1]. apply numerator_zero in Z. rewrite Z in *. lra.
      * exists e, (Q2R a), (Q2R k). repeat split; [|exact W]. apply not_zero, Z.
  - intros [e [a [b [E _]]]]. discriminate.
Qed.

Lemma bicycle_checked : (forall b, In b (bicycle_checks here along (inner_names here)) -> b = Some true) -> bicycle s x.
Proof.
  intro A. unfold bicycle_checks in A. constructor.
  - intros p c J. told (must_here c) (A (must (status_of here c))); [exact T|]. apply in_or_app; left. apply in_map_iff. exists (p, c). auto.
  - intros c n d J. assert (B : forall b, In b (circle_checks here (c, n, d)) -> b = Some true).
    { intros b K. apply A. apply in_or_app; right; apply in_or_app; left. apply in_flat_map. eauto. }
    simpl in B. told (must_here d) (B _ (or_introl eq_refl)). told (must_here (square_sum c n)) (B _ (or_intror (or_introl eq_refl))). auto.
  - intros name J. assert (B := A (has_answer (of_scene here name))).
    told (has_answer_sound _ _ _ (of_scene_means (fun _ => 0) name)) B; [exact T|].
    do 2 (apply in_or_app; right). apply in_or_app; left. apply in_map_iff. eauto.
  - intros u p c J G. told (must_inner c u) (A (must (status_of (inner_names here) c))); [exact T|].
    do 3 (apply in_or_app; right). apply in_or_app; left. apply in_map_iff. exists (p, c). simpl. rewrite G. auto.
  - intros u c n d J. assert (B : forall b, In b (circle_checks (inner_names here) (c, n, d)) -> b = Some true).
    { intros b K. apply A. do 4 (apply in_or_app; right). apply in_or_app; left. apply in_flat_map. eauto. }
    simpl in B. told (must_inner d u) (B _ (or_introl eq_refl)). told (must_inner (square_sum c n) u) (B _ (or_intror (or_introl eq_refl))). auto.
  - intros u c J. told (must_inner c u) (A (must (status_of (inner_names here) c))); [exact T|].
    do 5 (apply in_or_app; right). apply in_or_app; left. apply in_map_iff. eauto.
  - intros u e J. assert (B := A (has_answer (answer_of (inner_names here) e))).
    told (has_answer_sound _ _ _ (answer_means _ _ _ (inner_agree _ _ (reads_in_order u)) e)) B; [exact T|].
    do 6 (apply in_or_app; right). apply in_or_app; left. apply in_map_iff. eauto.
  - told load_check_sound (A (load_check along)); [exact T|]. do 7 (apply in_or_app; right). now left.
Qed.

Lemma bicycle_missed : In (Some false) (bicycle_checks here along (inner_names here)) -> ~ bicycle s x.
Proof.
  intros E P. unfold bicycle_checks in E. repeat (apply in_app_or in E; destruct E as [E|E]).
  - apply in_map_iff in E. destruct E as [[p c] [C J]]. simpl in C. told (must_here c) C. exact (T (domains s x P _ _ J)).
  - apply in_flat_map in E. destruct E as [[[c n] d] [J K]]. destruct (paper_circles s x P _ _ _ J) as [D Q].
    destruct K as [C|[C|[]]]; [told (must_here d) C|told (must_here (square_sum c n)) C]; auto.
  - apply in_map_iff in E. destruct E as [name [C J]]. told (has_answer_sound _ _ _ (of_scene_means (fun _ => 0) name)) C.
    exact (T (scene_values s x P _ J)).
  - apply in_map_iff in E. destruct E as [[p c] [C J]]. simpl in C. destruct (is_given s p) eqn:G; [|discriminate].
    told (must_inner c (fun _ => 0)) C. exact (T (mechanism_domains s x P _ _ _ J G)).
  - apply in_flat_map in E. destruct E as [[[c n] d] [J K]]. destruct (circles s x P (fun _ => 0) _ _ _ J) as [D Q].
    destruct K as [C|[C|[]]]; [told (must_inner d (fun _ => 0)) C|told (must_inner (square_sum c n) (fun _ => 0)) C]; auto.
  - apply in_map_iff in E. destruct E as [c [C J]]. told (must_inner c (fun _ => 0)) C. exact (T (assumed s x P _ _ J)).
  - apply in_map_iff in E. destruct E as [e [C J]].
    told (has_answer_sound _ _ _ (answer_means _ _ _ (inner_agree _ _ (reads_in_order (fun _ => 0))) e)) C.
    exact (T (coefficients s x P _ _ J)).
  - destruct E as [C|[]]. told load_check_sound C. exact (T (degree_one s x P)).
Qed.

Theorem is_point_sound of_domain : match is_point here along (inner_names here) of_domain with
  | Some true => if of_domain then point s x else bicycle s x
  | Some false => ~ (if of_domain then point s x else bicycle s x)
  | None => True
  end.
Proof.
  destruct (is_point _ _ _ _) as [[|]|] eqn:E; [| |exact I].
  - assert (A := all_of_true _ E). assert (B := bicycle_checked (fun b J => A b (in_or_app _ _ _ (or_introl J)))).
    destruct of_domain; [|exact B]. constructor; [exact B| |].
    + intros u l c L. told (must_inner c u) (A (must (status_of (inner_names here) c))); [exact T|].
      apply in_or_app; right. left. now rewrite L.
    + told (must_here (force_domain s)) (A (must (status_of here (force_domain s)))); [exact T|]. apply in_or_app; right. right. now left.
  - apply all_of_false, in_app_or in E. intro P. destruct E as [E|E].
    + apply (bicycle_missed E). destruct of_domain; [exact (of_bicycle s x P)|exact P].
    + destruct of_domain; [|contradiction]. destruct E as [C|[C|[]]].
      * destruct (load m) as [[l c]|] eqn:L; [|discriminate]. told (must_inner c (fun _ => 0)) C. exact (T (load_in_domain s x P _ _ _ L)).
      * told (must_here (force_domain s)) C. exact (T (force_in_domain s x P)).
Qed.

Lemma is_affine_fits e : is_affine (answer_of along e) = true -> Points.fits_affinely s x e.
Proof.
  intro F. assert (A := fun t => answer_means _ _ _ (along_agree t) e). unfold Points.fits_affinely.
  destruct (answer_of along e) as [| |[[|a [|b bs]] k]]; try discriminate; simpl in A.
  - exists 0, (Q2R k). intro t. rewrite A. unfold Linear.value; simpl. f_equal. ring.
  - exists (Q2R a), (Q2R k). intro t. rewrite A. unfold Linear.value; simpl. f_equal. ring.
Qed.

Lemma on_interval_convex d : on_interval along d = true ->
  (forall f, has_value (paper s (with_force s x f)) d)
  /\ forall f g h, f <= g -> g <= h -> is (paper s (with_force s x f)) true d -> is (paper s (with_force s x h)) true d ->
                   is (paper s (with_force s x g)) true d.
Proof.
  unfold has_value. induction d as [b|e links|c IH|c IHc d IHd|c IHc d IHd];
    intro H; cbn [on_interval is] in *; try discriminate.
  - split; [intro; destruct b; auto|auto].
  - apply andb_true_iff in H. destruct H as [A L]. apply Points.convex_links; [apply is_affine_fits, A|].
    rewrite forallb_forall in L. apply Forall_forall. intros [r t] J. specialize (L _ J).
    simpl in *. destruct r; try discriminate; (split; [discriminate|apply is_affine_fits, L]).
  - apply andb_true_iff in H. destruct H as [A B]. destruct (IHc A) as [V C], (IHd B) as [W D]. split.
    + intro t. destruct (V t), (W t); tauto.
    + intros f g h F G [P Q] [P' Q']. split; [exact (C f g h F G P P')|exact (D f g h F G Q Q')].
Qed.

Theorem on_interval_sound : on_interval along (force_domain s) = true -> forces_are_an_interval s x.
Proof. apply on_interval_convex. Qed.
End Run.
