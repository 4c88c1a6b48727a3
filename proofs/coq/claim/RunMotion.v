(** The motions of a mode as linear systems: whether there is one, and whether its accelerations, gaps and slips are
    determined. *)
From Coq Require Import String List Bool ZArith QArith Qreals Reals Lra Lia.
From Slipproof Require Import Text Syntax.
From Slipproof.claim Require Import Expression Mechanism Claim RunValues RunConditions RunPoint.
From Slipproof.claim Require Linear.
Import ListNotations.
Local Open Scope R_scope.

(** The first of: one is true, all are false, it is not known. *)
Definition any_of (bs : list (option bool)) : option bool :=
  if existsb (fun b => match b with Some true => true | _ => false end) bs then Some true
  else if forallb (fun b => match b with Some false => true | _ => false end) bs then Some false else None.

Fixpoint each {A} (f : linear -> option A) (ls : list linear) : option (list A) :=
  match ls with [] => Some [] | l :: ls => let* a := f l in let* rest := each f ls in Some (a :: rest) end.
Fixpoint same_values (V W : list Q) : bool :=
  match V, W with [], [] => true | a :: V, b :: W => Qeq_bool a b && same_values V W | _, _ => false end.

(** The numbers that make a motion; those without a value are the same for all. *)
Fixpoint affines (answers : list answer) : option (list linear) :=
  match answers with
  | [] => Some []
  | Affine l :: rest => let* ls := affines rest in Some (l :: ls)
  | Undefined :: rest => affines rest
  | Unclear :: _ => None
  end.

Inductive found := NoMotion | Unique (V : list Q) | Several | Unsolved.

Section Run.
Variable s : setting.
Variable q : list (string * Q).
Notation m := (of_mechanism s).
Notation x := (x q).
Notation reads := (reads s).

(** The names of the mechanism, and where the equations of motion hold. *)
Variable mech : scope.
Variable moving : option (list system).

Definition size : nat := length (unknowns m).
Definition fits (y : system) : bool := forallb (fun c => Nat.leb (length (Linear.coefficients (snd c))) size) y.
Definition solvable (y : system) : option bool := if fits y then Some (Linear.feasible size y) else None.
Definition one_solvable (ys : option (list system)) : option bool := let* ys := ys in any_of (map solvable ys).

Definition is_modelled (md : mode) : bool :=
  match mode_conditions (strict s) (given_parameters s) m md with Some _ => true | None => false end.
Definition systems (md : mode) : option (list system) :=
  match mode_conditions (strict s) (given_parameters s) m md with
  | None => Some []
  | Some cs => both moving (where_all_are mech cs)
  end.
Definition has_motion (md : mode) : option bool := one_solvable (systems md).

(** Names with the values that all motions of a mode give to them, where they do. *)
Definition sharpened (y : system) (names : scope) : scope :=
  fun name =>
    match names name with
    | Affine l =>
        match constant_of l with
        | Some _ => Affine l
        | None => if Nat.leb (length (Linear.coefficients l)) size
                  then match Linear.determined size y l with Some a => number a | None => Affine l end
                  else Affine l
        end
    | a => a
    end.
(** Where a condition has a truth value; it need only be known for motions of the mode. *)
Definition where_of_mode (names : scope) (md : mode) (truth : bool) (d : condition) : option (list system) :=
  match where_it_is names truth d with
  | Some ys => Some ys
  | None => match systems md with
            | Some [y] => if fits y then where_it_is (sharpened y names) truth d else None
            | _ => None
            end
  end.

Variable numbers : list linear.

Definition solve (md : mode) : found :=
  match systems md with
  | Some [] => NoMotion
  | Some [y] =>
      if fits y && forallb (fun l => Nat.leb (length (Linear.coefficients l)) size) numbers then
        if Linear.feasible size y then
          match each (Linear.determined size y) numbers with Some V => Unique V | None => Several end
        else NoMotion
      else Unsolved
  | _ => Unsolved
  end.

(** A motion at which [l] is none of these. *)
Fixpoint differs (y : system) (l : linear) (values : list Q) : bool :=
  match values with
  | [] => match solvable y with Some b => b | None => false end
  | a :: values =>
      let d := add l (opposed (fixed a)) in
      differs ((Linear.Positive, d) :: y) l values || differs ((Linear.Positive, opposed d) :: y) l values
  end.
Fixpoint differs_somewhere (y : system) (i : nat) (ls : list linear) (listed : list (list Q)) : bool :=
  match ls with
  | [] => false
  | l :: ls => differs y l (map (fun V => nth i V 0%Q) listed) || differs_somewhere y (S i) ls listed
  end.

(** Whether the mode has a motion with other numbers than those listed. *)
Definition strays (listed : list (list Q)) (md : mode) : option bool :=
  match solve md with
  | NoMotion => Some false
  | Unique V => Some (negb (existsb (same_values V) listed))
  | Several =>
      match systems md with
      | Some [y] => if differs_somewhere y 0 numbers listed then Some true else None
      | _ => None
      end
  | Unsolved => None
  end.

(** Soundness *)
Hypothesis mech_agree : forall z u, reads z u -> agree z mech (mechanism_names s x u).
Hypothesis moving_is : moving = where_all_are mech (dynamics m).

Lemma any_of_true bs : any_of bs = Some true -> In (Some true) bs.
Proof.
  unfold any_of. destruct (existsb _ bs) eqn:E; [|destruct (forallb _ bs); discriminate]. intros _.
  apply existsb_exists in E. destruct E as [[[|]|] [I E]]; try discriminate. exact I.
Qed.
Lemma any_of_false bs : any_of bs = Some false -> forall b, In b bs -> b = Some false.
Proof.
  unfold any_of. destruct (existsb _ bs); [discriminate|]. destruct (forallb _ bs) eqn:E; [|discriminate]. intros _ b I.
  rewrite forallb_forall in E. specialize (E b I). destruct b as [[|]|]; congruence.
Qed.

Lemma fits_sound y : fits y = true -> Forall (fun c => Linear.fit size (snd c)) y.
Proof. unfold fits. rewrite forallb_forall, Forall_forall. intros H c I. apply Nat.leb_le, H, I. Qed.

Lemma solvable_sound y : match solvable y with
  | Some true => exists z, Forall (Linear.holds z) y | Some false => forall z, ~ Forall (Linear.holds z) y | None => True end.
Proof.
  unfold solvable. destruct (fits y) eqn:F; [|exact I]. apply fits_sound in F. assert (H := Linear.feasible_iff size y F).
  destruct (Linear.feasible size y); [tauto|]. intros z Z. destruct H as [_ H]. discriminate H. eauto.
Qed.
Lemma one_solvable_sound ys : match one_solvable ys with
  | Some true => exists z, match ys with Some ys => some_hold z ys | None => False end
  | Some false => forall z, match ys with Some ys => ~ some_hold z ys | None => False end
  | None => True end.
Proof.
  unfold one_solvable. destruct ys as [ys|]; [|exact I]. destruct (any_of _) as [[|]|] eqn:E; [| |exact I].
  - apply any_of_true, in_map_iff in E. destruct E as [y [E J]]. assert (H := solvable_sound y). rewrite E in H.
    destruct H as [z H]. exists z. apply Exists_exists. eauto.
  - intros z H. apply Exists_exists in H. destruct H as [y [J H]]. assert (F := any_of_false _ E (solvable y) (in_map _ _ _ J)).
    assert (K := solvable_sound y). rewrite F in K. exact (K z H).
Qed.

Lemma systems_sound z u md : reads z u -> says z (systems md) (motion s x md u).
Proof.
  intro U. unfold systems, motion. destruct (mode_conditions _ _ _ md) as [cs|].
  - assert (A := where_all_sound z _ _ (mech_agree z u U) (dynamics m)). rewrite <- moving_is in A.
    assert (B := both_sound z _ _ _ _ A (where_all_sound z _ _ (mech_agree z u U) cs)).
    destruct (both _ _); [|exact I]. simpl in *. rewrite B. split.
    + intros [D C]. exists cs. auto.
    + intros [cs' [E [D C]]]. inversion E; subst. auto.
  - simpl. split; [intro H; now apply none_holds in H|]. intros [cs [E _]]. discriminate.
Qed.
Lemma has_motion_sound md : match has_motion md with
  | Some true => exists u, motion s x md u | Some false => forall u, ~ motion s x md u | None => True end.
Proof.
  unfold has_motion. assert (H := one_solvable_sound (systems md)). destruct (one_solvable (systems md)) as [[|]|]; [| |exact I].
  - destruct H as [z H]. exists (by_name s z). assert (S := systems_sound z _ md (reads_by_name s z)).
    destruct (systems md); [|contradiction]. apply S, H.
  - intros u M. specialize (H (in_order s u)). assert (S := systems_sound _ u md (reads_in_order s u)).
    destruct (systems md); [|contradiction]. apply H, S, M.
Qed.
Lemma is_modelled_sound md : is_modelled md = true <-> modelled s md.
Proof. unfold is_modelled, modelled. destruct (mode_conditions _ _ _ md); split; congruence. Qed.
Lemma motion_modelled md u : motion s x md u -> modelled s md.
Proof. intros [cs [E _]]. unfold modelled. congruence. Qed.

Lemma where_of_mode_sound z u names meant md truth d : reads z u -> motion s x md u -> agree z names meant ->
  says z (where_of_mode names md truth d) (is meant truth d).
Proof.
  intros U M A. unfold where_of_mode. assert (W := where_sound z names meant A d truth).
  destruct (where_it_is names truth d); [exact W|]. destruct (systems md) as [[|y [|y' ys]]|] eqn:E; try exact I.
  destruct (fits y) eqn:F; [|exact I]. apply where_sound. intro name. specialize (A name). unfold sharpened.
  destruct (names name) as [| |l]; try exact A. destruct (constant_of l); [exact A|]. destruct (Nat.leb _ _) eqn:L; [|exact A].
  destruct (Linear.determined size y l) as [a|] eqn:D; [|exact A]. unfold number, means in *. rewrite A, fixed_value. f_equal.
  apply (Linear.determined_sound size y l a D (fits_sound y F)); [apply Nat.leb_le, L|].
  assert (S := systems_sound z u md U). rewrite E in S. apply S in M. unfold some_hold in M.
  rewrite Exists_cons, Exists_nil in M. tauto.
Qed.

(** Numbers of a motion *)
Hypothesis numbers_are : affines (map mech (accelerations m ++ map fst (quantities m))) = Some numbers.

Definition have (z : nat -> R) (V : list Q) : Prop := Forall2 (fun l a => affine_value z l = Q2R a) numbers V.

Lemma affines_same z y f g names : forall ls, affines (map mech names) = Some ls ->
  (forall name, In name names -> means z (mech name) (f name)) -> (forall name, In name names -> means y (mech name) (g name)) ->
  ((forall name, In name names -> f name = g name) <-> Forall (fun l => affine_value z l = affine_value y l) ls).
Proof.
  induction names as [|name names IH]; intros ls E F G; simpl in E.
  - inversion E; subst. split; [constructor|contradiction].
  - assert (Fs := F name (or_introl eq_refl)). assert (Gs := G name (or_introl eq_refl)).
    assert (Hs : forall ls, affines (map mech names) = Some ls ->
       ((forall n, In n names -> f n = g n) <-> Forall (fun l => affine_value z l = affine_value y l) ls)).
    { intros k K. apply IH; [exact K| |]; intros n J; [apply F|apply G]; now right. }
    destruct (mech name) as [| |l] eqn:M; [discriminate| |].
    + rewrite <- (Hs _ E). simpl in Fs, Gs. split; intros H n J; [apply H; now right|]. destruct J; [subst; congruence|auto].
    + destruct (affines (map mech names)) as [rest|] eqn:R; [|discriminate]. inversion E; subst. simpl in Fs, Gs. split.
      * intro H. constructor; [|apply (Hs _ eq_refl); intros n J; apply H; now right].
        specialize (H name (or_introl eq_refl)). congruence.
      * intro H. inversion H; subst. intros n J. destruct J; [subst; congruence|]. now apply (Hs _ eq_refl).
Qed.
Lemma same_numbers z y u w : reads z u -> reads y w ->
  (same_motion s x u w <-> Forall (fun l => affine_value z l = affine_value y l) numbers).
Proof.
  intros U W. unfold same_motion. apply affines_same; [exact numbers_are| |]; intros name _; now apply mech_agree.
Qed.
Lemma have_same z y V : have z V -> (have y V <-> Forall (fun l => affine_value z l = affine_value y l) numbers).
Proof.
  unfold have. clear numbers_are. intro H. split; intro K.
  - revert K. induction H as [|l a ls V E H IH]; intro K; inversion K; subst; constructor; [congruence|auto].
  - revert K. induction H as [|l a ls V E H IH]; intro K; inversion K; subst; constructor; [congruence|auto].
Qed.

Lemma each_sound y V : each (Linear.determined size y) numbers = Some V -> Forall (fun c => Linear.fit size (snd c)) y ->
  Forall (Linear.fit size) numbers -> forall z, Forall (Linear.holds z) y -> have z V.
Proof.
  unfold have. clear numbers_are. revert V. induction numbers as [|l ls IH]; intros V E F L z Z; simpl in E.
  - inversion E. constructor.
  - options E. inversion E; subst. inversion L; subst. constructor; [|now apply IH]. now apply (Linear.determined_sound size y).
Qed.
Lemma each_none y : each (Linear.determined size y) numbers = None ->
  exists l, In l numbers /\ Linear.determined size y l = None.
Proof.
  clear numbers_are. induction numbers as [|l ls IH]; intro E; simpl in E; [discriminate|].
  destruct (Linear.determined size y l) eqn:D; [|exists l; split; [now left|exact D]].
  destruct (each _ ls); [discriminate|]. destruct (IH eq_refl) as [k [I K]]. exists k. split; [now right|exact K].
Qed.

Lemma of_solution md ys z : systems md = Some ys -> some_hold z ys -> motion s x md (by_name s z).
Proof. intros E H. assert (S := systems_sound z _ md (reads_by_name s z)). rewrite E in S. apply S, H. Qed.
Lemma to_solution md ys z u : systems md = Some ys -> reads z u -> motion s x md u -> some_hold z ys.
Proof. intros E U M. assert (S := systems_sound z _ md U). rewrite E in S. apply S, M. Qed.
Lemma one_holds z y : some_hold z [y] <-> Forall (Linear.holds z) y.
Proof. unfold some_hold. rewrite Exists_cons, Exists_nil. tauto. Qed.

Lemma solve_sound md : match solve md with
  | NoMotion => forall u, ~ motion s x md u
  | Unique V => (exists u, motion s x md u) /\ forall z u, reads z u -> motion s x md u -> have z V
  | Several => exists u w, motion s x md u /\ motion s x md w /\ ~ same_motion s x u w
  | Unsolved => True
  end.
Proof.
  unfold solve. destruct (systems md) as [[|y [|y' ys]]|] eqn:E; try exact I.
  - intros u M. apply (none_holds (in_order s u)). exact (to_solution _ _ _ _ E (reads_in_order s u) M).
  - destruct (fits y && _) eqn:F; [|exact I]. apply andb_true_iff in F. destruct F as [F L]. apply fits_sound in F.
    assert (L' : Forall (Linear.fit size) numbers).
    { rewrite forallb_forall in L. apply Forall_forall. intros l J. apply Nat.leb_le, L, J. }
    assert (K := Linear.feasible_iff size y F). destruct (Linear.feasible size y) eqn:G.
    + destruct (each _ numbers) as [V|] eqn:D.
      * split.
        -- destruct (proj1 K eq_refl) as [z Z]. exists (by_name s z). apply (of_solution _ _ _ E), one_holds, Z.
        -- intros z u U M. apply (each_sound y V D F L'), one_holds. exact (to_solution _ _ _ _ E U M).
      * apply each_none in D. destruct D as [l [J D]]. rewrite Forall_forall in L'.
        destruct (Linear.determined_complete size y l D F (L' _ J) G) as [z [w [Z [W N]]]].
        exists (by_name s z), (by_name s w). split; [apply (of_solution _ _ _ E), one_holds, Z|].
        split; [apply (of_solution _ _ _ E), one_holds, W|]. intro S.
        apply (same_numbers z w _ _ (reads_by_name s z) (reads_by_name s w)) in S. rewrite Forall_forall in S. exact (N (S _ J)).
    + intros u M. assert (Z := to_solution _ _ _ _ E (reads_in_order s u) M). apply one_holds in Z.
      destruct K as [_ K]. discriminate K. eauto.
Qed.

Lemma differs_sound l values : forall y, differs y l values = true ->
  exists z, Forall (Linear.holds z) y /\ forall a, In a values -> affine_value z l <> Q2R a.
Proof.
  induction values as [|a values IH]; intros y H; simpl in H.
  - assert (S := solvable_sound y). destruct (solvable y) as [[|]|]; try discriminate. destruct S as [z Z]. exists z. split; [exact Z|tauto].
  - apply orb_true_iff in H. destruct H as [H|H]; apply IH in H; destruct H as [z [Z N]]; inversion Z as [|c cs P Zs]; subst;
      exists z; (split; [exact Zs|]); intros b [J|J]; try (apply N, J); subst b; unfold Linear.holds in P; simpl in P;
      rewrite ?opposed_value, add_value, opposed_value, fixed_value in P; lra.
Qed.
Lemma differs_somewhere_sound y ls listed : forall i, differs_somewhere y i ls listed = true ->
  exists z, Forall (Linear.holds z) y /\ forall V, In V listed ->
    ~ exists front, length front = i /\ exists back, V = front ++ back /\ Forall2 (fun l a => affine_value z l = Q2R a) ls back.
Proof.
  induction ls as [|l ls IH]; intros i H; simpl in H; [discriminate|]. apply orb_true_iff in H. destruct H as [H|H].
  - destruct (differs_sound l _ y H) as [z [Z N]]. exists z. split; [exact Z|]. intros V J [front [L [back [E F]]]].
    inversion F as [|? a ? more A Fs]; subst. apply (N a); [|exact A]. apply in_map_iff. exists (front ++ a :: more). split; [|exact J].
    rewrite app_nth2, Nat.sub_diag by lia. reflexivity.
  - destruct (IH _ H) as [z [Z N]]. exists z. split; [exact Z|]. intros V J [front [L [back [E F]]]].
    inversion F as [|? a ? more A Fs]; subst. apply (N _ J). exists (front ++ [a]). rewrite app_length. split; [simpl; lia|].
    exists more. rewrite <- app_assoc. auto.
Qed.

Lemma same_values_sound z V W : same_values V W = true -> have z V -> have z W.
Proof.
  unfold have. clear. intros S H. revert W S. induction H as [|l a ls V E H IH]; intros [|b W] S; simpl in S; try discriminate; constructor.
  - apply andb_true_iff in S. destruct S as [S _]. apply Qeq_bool_iff, Qeq_eqR in S. congruence.
  - apply IH. apply andb_true_iff in S. tauto.
Qed.
Lemma same_values_complete z V W : have z V -> have z W -> same_values V W = true.
Proof.
  unfold have. clear. intro H. revert W. induction H as [|l a ls V E H IH]; intros W K; inversion K; subst; [reflexivity|]. simpl.
  apply andb_true_iff. split; [|auto]. apply Qeq_bool_iff, eqR_Qeq. congruence.
Qed.

Lemma strays_sound listed md : match strays listed md with
  | Some true => exists z u, reads z u /\ motion s x md u /\ forall V, In V listed -> ~ have z V
  | Some false => forall z u, reads z u -> motion s x md u -> exists V, In V listed /\ have z V
  | None => True
  end.
Proof.
  unfold strays. assert (S := solve_sound md). destruct (solve md) as [|V| |]; [| | |exact I].
  - intros z u _ M. destruct (S u M).
  - destruct S as [[u M] S]. destruct (existsb (same_values V) listed) eqn:E; simpl.
    + apply existsb_exists in E. destruct E as [W [J E]]. intros z w U N. exists W. split; [exact J|].
      exact (same_values_sound z V W E (S z w U N)).
    + exists (in_order s u), u. split; [apply reads_in_order|]. split; [exact M|]. intros W J H.
      apply not_true_iff_false in E. apply E, existsb_exists. exists W. split; [exact J|].
      exact (same_values_complete _ _ _ (S _ u (reads_in_order s u) M) H).
  - destruct (systems md) as [[|y [|y' ys]]|] eqn:E; try exact I. destruct (differs_somewhere y 0 numbers listed) eqn:D; [|exact I].
    destruct (differs_somewhere_sound _ _ _ _ D) as [z [Z N]]. exists z, (by_name s z). split; [apply reads_by_name|].
    split; [apply (of_solution _ _ _ E), one_holds, Z|]. intros V J H. apply (N V J). exists []. split; [reflexivity|]. exists V. auto.
Qed.

End Run.
