(** The names of a setting as normal forms, and that they stand for what [Claim.v] says. *)
From Coq Require Import String List Bool NArith ZArith Reals Lra Lia FMapFacts OrderedTypeEx.
From Slipproof Require Import Text Syntax Meaning Poly Normal NormalSound.
From Slipproof.claim Require Import Expression Mechanism Claim Forms FormsSound Entails Covers.
Import ListNotations.
Local Open Scope R_scope.
Local Open Scope string_scope.

(** A name with its normal form; without one, the name is taken out. *)
Definition bind_form (scope : Normal.scope) (d : string * option fraction) : Normal.scope :=
  match snd d with Some f => Map.add (fst d) (Normal.Value f) scope | None => Map.remove (fst d) scope end.
Definition bind_value (names : meanings) (d : string * option R) : meanings := with_name (fst d) (snd d) names.

Definition define_forms (ds : list (string * term)) (scope : Normal.scope) : Normal.scope :=
  fold_left (fun scope d => bind_form scope (fst d, normal_term scope (snd d))) ds scope.

Definition zero_form : fraction := Fraction (constant 0) None [].

Section Scopes.
Variable s : setting.
Notation m := (of_mechanism s).

(** With a number in the place of the force, if one is given. *)
Definition symbol_form (at_force : option Z) (name : string) : fraction :=
  match at_force with
  | Some n => if String.eqb name (force s) then Fraction (constant n) None [] else symbol name
  | None => symbol name
  end.
Definition paper_scope (at_force : option Z) : Normal.scope :=
  define_forms (paper_definitions s)
    (fold_left (fun scope name => bind_form scope (name, Some (symbol_form at_force name))) (symbols s) (Map.empty _)).

Definition scene_form (name : string) : option fraction :=
  match given s name with Some e => normal_term (paper_scope None) e | None => Some zero_form end.
(** The unknowns of a motion have names of their own, with the suffix. *)
Definition inner_scope (suffix : string) : Normal.scope :=
  define_forms (definitions m)
    (fold_left (fun scope name => bind_form scope (name, Some (symbol (name ++ suffix)))) (unknowns m)
       (fold_left (fun scope name => bind_form scope (name, scene_form name)) (scene_symbols s) (Map.empty _))).
Definition quantity_forms (suffix : string) : list (string * option fraction) :=
  map (fun q => (fst q, normal_term (inner_scope suffix) (snd q))) (quantities m).
Definition mechanism_scope (suffix : string) : Normal.scope :=
  fold_left bind_form (quantity_forms suffix) (inner_scope suffix).
Definition motion_scope (suffix : string) : Normal.scope :=
  fold_left (fun scope name =>
               bind_form scope (name, match Map.find name (mechanism_scope suffix) with Some (Normal.Value f) => Some f | _ => None end))
            (unknowns m ++ map fst (quantities m)) (paper_scope None).
End Scopes.

(** Soundness *)

Lemma find_remove {A} (t : Map.t A) name other :
  Map.find other (Map.remove name t) = if String.eqb other name then None else Map.find other t.
Proof.
  rewrite MapFacts.remove_o. destruct (String_as_OT.eq_dec name other) as [E|E]; destruct (String.eqb_spec other name); congruence.
Qed.

Section Sound.
Variable v : positive -> R.

Lemma bind_agrees scope meant name f x :
  agrees v scope meant -> (forall g, f = Some g -> stands v g x) -> agrees v (bind_form scope (name, f)) (bind_value meant (name, x)).
Proof.
  intros A S other e F. unfold bind_form, bind_value, with_name in *. simpl in *. destruct f as [g|].
  - rewrite find_add in F. destruct (String.eqb other name); [|apply A, F]. inversion F; subst. exists g. auto.
  - rewrite find_remove in F. destruct (String.eqb other name); [discriminate|]. apply A, F.
Qed.

Lemma define_agrees ds : forall scope meant, agrees v scope meant -> agrees v (define_forms ds scope) (define ds meant).
Proof.
  unfold define_forms, define. induction ds as [|[name e] ds IH]; intros scope meant A; simpl; [exact A|].
  apply IH. apply (bind_agrees scope meant name (normal_term scope e) (value meant e) A).
  intros g E. exact (normal_term_sound v _ _ A _ _ E).
Qed.

Lemma fold_agrees (form : string -> option fraction) (number : string -> option R) names : forall scope meant,
  agrees v scope meant -> (forall name g, In name names -> form name = Some g -> stands v g (number name)) ->
  agrees v (fold_left (fun scope name => bind_form scope (name, form name)) names scope)
           (fold_left (fun meant name => bind_value meant (name, number name)) names meant).
Proof.
  induction names as [|name names IH]; intros scope meant A S; simpl; [exact A|].
  apply IH; [|intros other g I; apply S; now right].
  apply bind_agrees; [exact A|]. intros g E. apply S; [now left|exact E].
Qed.

(** The value that the fold gives to a name. *)
Lemma fold_values (number : string -> option R) names : forall meant other,
  fold_left (fun meant name => bind_value meant (name, number name)) names meant other
  = if is_in other names then number other else meant other.
Proof.
  induction names as [|name names IH]; intros meant other; simpl; [reflexivity|].
  rewrite IH. unfold bind_value, with_name. simpl. destruct (String.eqb_spec other name) as [E|E].
  - subst. now destruct (is_in name names).
  - reflexivity.
Qed.

Lemma agrees_ext scope meant other : (forall name, meant name = other name) -> agrees v scope meant -> agrees v scope other.
Proof. intros E A name e F. rewrite <- E. apply A, F. Qed.

Lemma agrees_empty meant : agrees v (Map.empty _) meant.
Proof. intros name e F. discriminate F. Qed.

Section Setting.
Variable s : setting.
Notation m := (of_mechanism s).
Variable x : string -> R.
Hypothesis symbols_agree : forall name, In name (symbols s) -> v (code name) = x name.

Lemma paper_agrees_at at_force y :
  (forall name, In name (symbols s) -> stands v (symbol_form s at_force name) (Some (y name))) ->
  agrees v (paper_scope s at_force) (paper s y).
Proof.
  intro S. unfold paper_scope, paper. apply define_agrees.
  eapply agrees_ext; [|apply (fold_agrees (fun name => Some (symbol_form s at_force name)) (fun name => Some (y name)) (symbols s)
                                _ (fun _ => None) (agrees_empty _))].
  - intro name. rewrite fold_values. reflexivity.
  - intros name g I E. inversion E; subst. apply S, I.
Qed.

Lemma paper_agrees : agrees v (paper_scope s None) (paper s x).
Proof.
  apply paper_agrees_at. intros name I. simpl. rewrite <- symbols_agree by exact I. apply stands_symbol.
Qed.

Lemma paper_agrees_with (n : Z) : agrees v (paper_scope s (Some n)) (paper s (with_force s x (IZR n))).
Proof.
  apply paper_agrees_at. intros name I. simpl. unfold with_force. destruct (String.eqb name (force s)).
  - apply stands_number.
  - rewrite <- symbols_agree by exact I. apply stands_symbol.
Qed.

Section Motion.
Variable suffix : string.
Variable u : string -> R.
Hypothesis unknowns_agree : forall name, In name (unknowns m) -> v (code (name ++ suffix)) = u name.

Lemma scene_agrees name g : scene_form s name = Some g -> stands v g (from_scene s x name).
Proof.
  unfold scene_form, from_scene. intro E. destruct (given s name).
  - exact (normal_term_sound v _ _ paper_agrees _ _ E).
  - inversion E; subst. apply (stands_number v 0).
Qed.

Lemma inner_agrees : agrees v (inner_scope s suffix) (in_scene s x u).
Proof.
  unfold inner_scope, in_scene. apply define_agrees.
  assert (A := fold_agrees (scene_form s) (from_scene s x) (scene_symbols s) _ (fun _ => None) (agrees_empty _)
                 (fun name g _ => scene_agrees name g)).
  eapply agrees_ext; [|apply (fold_agrees (fun name => Some (symbol (name ++ suffix))) (fun name => Some (u name)) (unknowns m) _ _ A)].
  - intro name. rewrite !fold_values. reflexivity.
  - intros name g I E. inversion E; subst. rewrite <- unknowns_agree by exact I. apply stands_symbol.
Qed.

Lemma mechanism_agrees : agrees v (mechanism_scope s suffix) (mechanism_names s x u).
Proof.
  unfold mechanism_scope, mechanism_names, quantity_forms.
  assert (H : forall qs scope meant, agrees v scope meant ->
    agrees v (fold_left bind_form (map (fun q => (fst q, normal_term (inner_scope s suffix) (snd q))) qs) scope)
             (fold_left (fun names q => with_name (fst q) (value (in_scene s x u) (snd q)) names) qs meant)).
  { induction qs as [|[name e] qs IH]; intros scope meant A; simpl; [exact A|]. apply IH.
    apply (bind_agrees scope meant name _ (value (in_scene s x u) e) A).
    intros g E. exact (normal_term_sound v _ _ inner_agrees _ _ E). }
  apply H, inner_agrees.
Qed.

Lemma motion_agrees : agrees v (motion_scope s suffix) (names_of_motion s x u).
Proof.
  unfold motion_scope. eapply agrees_ext; [|apply (fold_agrees _ (mechanism_names s x u) _ _ _ paper_agrees)].
  - intro name. rewrite fold_values. unfold names_of_motion. reflexivity.
  - intros name g I E. destruct (Map.find name (mechanism_scope s suffix)) as [[f|f]|] eqn:F; try discriminate.
    inversion E; subst. destruct (mechanism_agrees _ _ F) as [h [K S]]. inversion K; subst. exact S.
Qed.
End Motion.
End Setting.
End Sound.
