(** A motion in a case whose forces are near those of a motion that is alone is this motion (FORMAT.md, `all-solutions`,
    `known`). *)
From Coq Require Import NArith Reals List Bool Lra Lia Psatz FMapPositive FunctionalExtensionality.
From Slipproof.contact Require Import Coulomb Number Fixed Linear Zero Certificate Checker Rows Law Enclose Motions.
From Slipproof.contact Require Import Arcs States Multipliers Alone Known.
Import ListNotations.
Local Open Scope R_scope.

Ltac values_in H := repeat first
  [rewrite value_opp in H | rewrite value_add in H | rewrite value_sub in H | rewrite value_mul in H | rewrite value_abs in H
  | rewrite value_one in H | rewrite value_zero in H | rewrite dot_is in H].

Section Instance.
  Variable i : instance.
  Hypothesis whole : is_whole i = true.
  Hypothesis fine_numbers : is_proper i = true.
  Hypothesis no_free : frees i = 0%N.
  Let p := tables_of i.
  Let P := problem_of i.
  Let n := size P.
  Let d := dimension P.
  Variables (modes : list mode) (b : box) (l : number) (s : pattern) (r : nat -> R) (ys : list (list number)).
  Hypothesis lengths : length modes = length (frictions i).
  Hypothesis solves : solution P r.
  Hypothesis inside : in_pattern i s r.
  Hypothesis fitting : forallb (fits p s) (contacts_of p modes) = true.
  Hypothesis bounded : all_proved p s (flat_map (force_bounds p s b l) (contacts_of p modes)) ys = true.
  Let rr (k : nat) := of_contact P k r.
  Let uu (k : nat) := of_contact P k (motion P r).
  Let c (k : nat) := contact_at i modes k.
  Let friction_of (k : nat) := friction P k.

  Lemma dim_is : N.to_nat (t_dim p) = d.
  Proof. reflexivity. Qed.

  Lemma d_fine : (1 <= d <= 3)%nat.
  Proof. exact (d_size i fine_numbers). Qed.

  Lemma c_In k : (k < contacts P)%nat -> In (c k) (contacts_of p modes).
  Proof. intros K. apply contact_at_In; assumption. Qed.

  Lemma c_only e : In e (contacts_of p modes) -> exists k, (k < contacts P)%nat /\ e = c k.
  Proof. intros E. apply layout_only in E; [exact E | exact lengths]. Qed.

  Lemma fits_at k : (k < contacts P)%nat -> fits p s (c k) = true.
  Proof. intros K. assert (F := fitting). rewrite forallb_forall in F. apply F, c_In, K. Qed.

  Definition slip_value (k : nat) : R := tangential d (uu k) / (friction_of k * rr k 0%nat).

  (** The unknowns of the motion. *)
  Definition unknowns_at : vector := fun k => let j := N.to_nat k in
    if Nat.ltb j n then r j else match nth (j - n) modes Open with Slide => slip_value (j - n) | _ => 0 end.

  Lemma force_at k t : (k < contacts P)%nat -> (t < d)%nat -> unknowns_at (first (c k) + N.of_nat t)%N = rr k t.
  Proof.
    intros K T. unfold c. rewrite (first_at i no_free). unfold unknowns_at. rewrite Nat2N.id.
    assert (L := component_below i no_free k t K T). fold n in L. fold P d in L |- *.
    destruct (Nat.ltb_spec (d * k + t) n); [|lia]. symmetry. apply (component i no_free).
  Qed.

  Lemma normal_at k : (k < contacts P)%nat -> unknowns_at (first (c k)) = rr k 0%nat.
  Proof. intros K. rewrite <- force_at by (try exact K; assert (D := d_fine); lia). cbn. rewrite N.add_0_r. reflexivity. Qed.

  Lemma slip_index k : N.to_nat (slip (c k)) = (n + k)%nat.
  Proof. unfold c, contact_at; cbn [slip]. fold p. rewrite N2Nat.inj_add, Nat2N.id. f_equal. apply size_is. Qed.

  Lemma slip_at k : its_mode (c k) = Slide -> unknowns_at (slip (c k)) = slip_value k.
  Proof.
    intros M. unfold unknowns_at. rewrite slip_index. destruct (Nat.ltb_spec (n + k) n); [lia|].
    replace (n + k - n)%nat with k by lia. unfold c, contact_at in M; cbn [its_mode] in M. rewrite M. reflexivity.
  Qed.

  Lemma velocity_at k t : (k < contacts P)%nat -> (t < d)%nat -> eval (row p (first (c k) + N.of_nat t)) unknowns_at = uu k t.
  Proof.
    intros K T. unfold c. rewrite (first_at i no_free). unfold p. rewrite (row_motion i whole).
    unfold uu. rewrite (component i no_free). unfold motion. f_equal. apply sum_ext. intros j J. f_equal.
    unfold unknowns_at. rewrite Nat2N.id. fold P n in J. destruct (Nat.ltb_spec j n); [reflexivity | lia].
  Qed.

  Lemma normal_velocity k : (k < contacts P)%nat -> eval (row p (first (c k))) unknowns_at = uu k 0%nat.
  Proof. intros K. rewrite <- velocity_at by (try exact K; assert (D := d_fine); lia). cbn. rewrite N.add_0_r. reflexivity. Qed.

  Lemma friction_fine k : (k < contacts P)%nat -> 0 <= friction_of k.
  Proof. intros K. apply (friction_is i fine_numbers), K. Qed.

  Lemma friction_positive k : (k < contacts P)%nat -> has_friction (t_dim p) (c k) = true -> 0 < friction_of k.
  Proof.
    intros K H. unfold has_friction in H. apply andb_prop in H. destruct H as [_ H]. apply negb_true_iff, sign_nonzero in H.
    assert (F := friction_fine k K). change (value (mu (c k))) with (friction_of k) in H. lra.
  Qed.

  Lemma friction_none k : (k < contacts P)%nat -> has_friction (t_dim p) (c k) = false -> friction_of k = 0.
  Proof.
    intros K H. destruct (friction_is i fine_numbers k K) as [A B]. unfold has_friction in H. apply andb_false_iff in H.
    destruct H as [H|H].
    - apply N.ltb_ge in H. apply B. assert (D := d_fine). unfold d, P, problem_of in D; cbn [dimension] in D.
      change (t_dim p) with (dim i) in H. lia.
    - apply negb_false_iff, sign_zero in H. exact H.
  Qed.

  Lemma no_friction_force k : (k < contacts P)%nat -> friction_of k = 0 -> forall t, (1 <= t < d)%nat -> rr k t = 0.
  Proof.
    intros K F. destruct (coulomb_plane d _ _ _ d_fine (proj2 solves k K)) as [C _]. apply (tangents_zero d _ d_fine).
    fold (rr k) in *. fold (friction_of k) in C. rewrite F in C.
    assert (Q : 0 <= inner (plane d (rr k)) (plane d (rr k))) by (unfold inner; nra). lra.
  Qed.

  Lemma state_here k : of_contact_state p s (c k) = state_of s (N.of_nat k).
  Proof. apply (state_at i no_free). Qed.

  Lemma slipping k a e : (k < contacts P)%nat -> state_of s (N.of_nat k) = SlipState a e ->
    uu k 0%nat = 0 /\ exists x v, in_arc (arrow_of a) (arrow_of e) x /\ 0 < v /\
      plane d (uu k) = stretch v x /\ plane d (rr k) = stretch (- (friction_of k * rr k 0%nat)) x.
  Proof. intros K S. assert (A := inside k K). rewrite S in A. exact A. Qed.

  (** What the multipliers of a contact that slides in space bound. *)
  Lemma slip_bounded k a e x v : (k < contacts P)%nat -> its_mode (c k) = Slide -> state_of s (N.of_nat k) = SlipState a e ->
    in_arc (arrow_of a) (arrow_of e) x -> plane d (uu k) = stretch v x ->
    let z := values (center_of b) (slip (c k)) in let w := value l * absolute (radius_of b) (slip (c k)) in
    let q := friction_of k * rr k 0%nat in
    exists g m, 0 < g <= m /\ m <= 1 + g / 2 /\ v * m <= (z + w) * q * g /\ (z - w) * q * (1 + g / 2) <= v * m.
  Proof.
    intros K M S Y U z w q. assert (D := d_fine). assert (F := fits_at k K). unfold fits in F. rewrite state_here, M, S in F.
    apply andb_prop in F. destruct F as [_ D3]. apply N.eqb_eq in D3. assert (D3' : d = 3%nat) by (rewrite <- dim_is; lia).
    assert (B : forall y, In y (slip_bounds b l (c k) a e) ->
        value (at_least y) <= apply (of_velocities y) (cut i (motion P r)) + apply (of_forces y) (cut i r)).
    { intros y E. apply (all_proved_each i whole fine_numbers no_free s r solves inside _ _ bounded).
      apply in_flat_map. exists (c k). split; [apply c_In, K|].
      unfold force_bounds. apply in_or_app. right. fold p. rewrite M, state_here, S. exact E. }
    assert (B1 := B _ (or_introl eq_refl)). assert (B2 := B _ (or_intror (or_introl eq_refl))).
    cbn [at_least of_velocities of_forces apply] in B1, B2.
    assert (Cut : forall y t, (t < d)%nat -> cut i y (first (c k) + N.of_nat t)%N = of_contact P k y t).
    { intros y t T. unfold c. rewrite (first_at i no_free). rewrite cut_at by apply (component_below i no_free k t K T).
      symmetry. apply (component i no_free). }
    assert (V1 := Cut (motion P r) 1%nat ltac:(lia)). assert (V2 := Cut (motion P r) 2%nat ltac:(lia)).
    assert (R0 := Cut r 0%nat ltac:(lia)). cbn [N.of_nat Pos.of_succ_nat Pos.succ] in V1, V2, R0. rewrite N.add_0_r in R0.
    rewrite V1, V2, R0 in B1, B2. fold (rr k) (uu k) in B1, B2.
    destruct (plane_components _ _ _ D U) as [U1 U2].
    specialize (U1 ltac:(lia)). specialize (U2 ltac:(lia)). cbn [fst snd stretch] in U1, U2. rewrite U1, U2 in B1, B2.
    assert (Half : value (Number 1 1 1) = / 2) by (unfold value; simpl; field).
    values_in B1. values_in B2. rewrite Half in B2. change (value (mu (c k))) with (friction_of k) in B1, B2.
    destruct (in_arc_middle _ _ _ Y) as [C0 [C1 C2]].
    fold (absolute (radius_of b) (slip (c k))) (values (center_of b) (slip (c k))) in B1, B2. fold z w in B1, B2.
    exists (1 + inner (arrow_of a) (arrow_of e)), (inner (fst (arrow_of a) + fst (arrow_of e), snd (arrow_of a) + snd (arrow_of e)) x).
    split; [split; assumption|]. split; [exact C2|]. unfold inner at 1 4. unfold q. cbn [fst snd arrow_of] in *. split; lra.
  Qed.

  (** There it slips with a force: v > 0, so that the first bound could not be with r_N = 0. *)
  Lemma slipping_in_space k a e : (k < contacts P)%nat -> its_mode (c k) = Slide -> state_of s (N.of_nat k) = SlipState a e ->
    let q := friction_of k * rr k 0%nat in
    0 < q /\ uu k 0%nat = 0 /\ exists x, in_arc (arrow_of a) (arrow_of e) x /\
      plane d (uu k) = stretch (slip_value k * q) x /\ plane d (rr k) = stretch (- q) x.
  Proof.
    intros K M S q. destruct (slipping k a e K S) as [U0 [x [v [X [V [U R]]]]]].
    assert (Q : 0 < q).
    { destruct (slip_bounded k a e x v K M S X U) as [g [m [[G G'] [_ [B _]]]]]. fold q in B.
      assert (F := friction_fine k K). destruct (proj2 solves k K) as [R0 _ _ _ _]. change (0 <= rr k 0%nat) in R0.
      assert (Q0 : 0 <= q) by (apply Rmult_le_pos; assumption). destruct Q0 as [Q0|Q0]; [exact Q0|].
      rewrite <- Q0 in B. nra. }
    split; [exact Q|]. split; [exact U0|]. exists x. split; [exact X|]. split; [|exact R].
    assert (T : tangential d (uu k) = v).
    { apply tangential_eq; [lra|]. rewrite (square_plane _ _ d_fine), U, stretch_inner, inner_stretch.
      rewrite (proj1 (proj2 X)). ring. }
    unfold slip_value. rewrite T. fold q. replace (v / q * q) with v by (field; lra). exact U.
  Qed.

  Lemma slipping_in_plane k a e x : (k < contacts P)%nat -> d = 2%nat ->
    state_of s (N.of_nat k) = SlipState a e -> same_direction a x = true -> same_direction e x = true ->
    uu k 0%nat = 0 /\ rr k 1%nat = - (friction_of k * rr k 0%nat) * value (fst x).
  Proof.
    intros K D S A E. destruct (slipping k a e K S) as [U0 [y [v [Y [_ [_ R]]]]]]. split; [exact U0|].
    assert (Same : forall g, same_direction g x = true -> arrow_of g = arrow_of x).
    { intros g B. unfold same_direction in B. apply andb_prop in B. destruct B as [B1 B2]. apply eq_value in B1. apply eq_value in B2.
      unfold arrow_of. rewrite B1, B2. reflexivity. }
    rewrite (Same a A), (Same e E) in Y. apply in_arc_single in Y. subst y.
    destruct (plane_components _ _ _ d_fine R) as [R1 _]. apply R1. lia.
  Qed.

  Theorem equations_hold e : In e (equations p modes) -> eval e unknowns_at = 0.
  Proof.
    intros E. unfold equations in E. change (t_frees p) with (frees i) in E. rewrite no_free in E. cbn [N.to_nat range map app] in E.
    apply in_flat_map in E. destruct E as [c0 [C E]]. destruct (c_only c0 C) as [k [K ->]].
    assert (F := fits_at k K). unfold fits in F. rewrite state_here in F. unfold equations_of in E.
    assert (D := d_fine). assert (A := inside k K). fold P d (friction_of k) (rr k) (uu k) in A.
    assert (N0 := normal_velocity k K).
    destruct (its_mode (c k)) eqn:M; destruct (state_of s (N.of_nat k)) as [| | | |a x] eqn:S; try discriminate; try (destruct E; fail).
    - apply negb_true_iff in F. rewrite F in E. destruct E as [<-|[]]. rewrite N0. exact A.
    - rewrite F in E. rename A into U. destruct E as [<-|E]; [rewrite N0; apply U; lia|].
      apply in_map_iff in E. destruct E as [j [<- J]]. apply range_In in J.
      change (t_dim p) with (dim i) in J. unfold d, P, problem_of in U, D; cbn [dimension] in U, D.
      replace j with (first (c k) + N.of_nat (N.to_nat (j - first (c k))))%N by lia.
      rewrite velocity_at by (try exact K; unfold d, P, problem_of; cbn [dimension]; lia). apply U. lia.
    - apply andb_prop in F. destruct F as [F D3]. apply N.eqb_eq in D3. assert (D3' : d = 3%nat) by (rewrite <- dim_is; lia).
      destruct (slipping_in_space k a x K M S) as [Q [U0 [y [Y [U R]]]]].
      destruct (plane_components _ _ _ D U) as [U1 U2]. destruct (plane_components _ _ _ D R) as [R1 R2].
      cbn [fst snd stretch] in U1, U2, R1, R2. rewrite <- normal_velocity in U0 by exact K.
      specialize (U1 ltac:(lia)). specialize (U2 ltac:(lia)). specialize (R1 ltac:(lia)). specialize (R2 ltac:(lia)).
      assert (Slide_ : forall t, (1 <= t < 3)%nat -> uu k t = - slip_value k * rr k t -> eval (sliding p (c k) (N.of_nat t)) unknowns_at = 0).
      { intros t T E'. assert (V := velocity_at k t K ltac:(lia)). unfold sliding, eval, row in *.
        cbn [constant_part linear_part quadratic_part products] in *. rewrite value_one, (slip_at k M), (force_at k t K) by lia. lra. }
      destruct E as [<-|[<-|[<-|[<-|[]]]]]; [exact U0 | | |].
      + apply (Slide_ 1%nat); [lia|]. rewrite U1, R1. ring.
      + apply (Slide_ 2%nat); [lia|]. rewrite U2, R2. ring.
      + assert (F1 := force_at k 1 K ltac:(lia)). assert (F2 := force_at k 2 K ltac:(lia)). assert (F0 := normal_at k K).
        cbn [N.of_nat Pos.of_succ_nat Pos.succ] in F1, F2. unfold cone, eval.
        cbn [constant_part linear_part quadratic_part products apply]. unfold Checker.square.
        rewrite F1, F2, F0, value_one, value_zero, value_opp, value_mul.
        change (value (mu (c k))) with (friction_of k). rewrite R1, R2. destruct Y as [_ [Y _]]. unfold inner in Y.
        replace (0 + 0 + (1 * (- (friction_of k * rr k 0) * fst y * (- (friction_of k * rr k 0) * fst y))
          + (1 * (- (friction_of k * rr k 0) * snd y * (- (friction_of k * rr k 0) * snd y))
          + (- (friction_of k * friction_of k) * (rr k 0 * rr k 0) + 0))))%R
          with (friction_of k * rr k 0 * (friction_of k * rr k 0) * (fst y * fst y + snd y * snd y - 1)) by ring.
        rewrite Y. ring.
    - split_and F. apply N.eqb_eq in H1. assert (D2 : d = 2%nat) by (rewrite <- dim_is; lia).
      destruct (slipping_in_plane k a x ahead K D2 S H0 H) as [U0 R1]. rewrite <- normal_velocity in U0 by exact K.
      destruct E as [<-|[<-|[]]]; [exact U0|]. assert (F1 := force_at k 1 K ltac:(lia)). assert (F0 := normal_at k K).
      unfold edge, eval. cbn [constant_part linear_part quadratic_part products apply] in *.
      cbn [N.of_nat Pos.of_succ_nat] in F1. cbn [fst ahead] in R1. rewrite F1, F0, R1, value_one, value_zero.
      change (value (mu (c k))) with (friction_of k). ring.
    - split_and F. apply N.eqb_eq in H1. assert (D2 : d = 2%nat) by (rewrite <- dim_is; lia).
      destruct (slipping_in_plane k a x (opposite_direction ahead) K D2 S H0 H) as [U0 R1].
      rewrite <- normal_velocity in U0 by exact K.
      destruct E as [<-|[<-|[]]]; [exact U0|]. assert (F1 := force_at k 1 K ltac:(lia)). assert (F0 := normal_at k K).
      unfold edge, eval. cbn [constant_part linear_part quadratic_part products apply] in *.
      cbn [N.of_nat Pos.of_succ_nat] in F1. cbn [fst opposite_direction ahead] in R1.
      rewrite F1, F0, R1, !value_opp, value_one, value_zero. change (value (mu (c k))) with (friction_of k). ring.
  Qed.

  Lemma unknown_of k j : (k < contacts P)%nat -> In j (unknowns_of (t_dim p) (c k)) -> In j (unknowns p modes).
  Proof.
    intros K J. unfold unknowns. apply in_or_app. right. apply in_flat_map. exists (c k). split; [apply c_In, K | exact J].
  Qed.

  (** What is no unknown is 0. *)
  Theorem others_zero j : ~ In j (unknowns p modes) -> unknowns_at j = 0.
  Proof.
    intros O. assert (D := d_fine). unfold unknowns_at. cbv zeta. destruct (Nat.ltb_spec (N.to_nat j) n) as [J|J].
    - set (k := (N.to_nat j / d)%nat). set (t := (N.to_nat j mod d)%nat).
      assert (JK : N.to_nat j = (d * k + t)%nat) by (apply Nat.div_mod; lia).
      assert (T : (t < d)%nat) by (apply Nat.mod_upper_bound; lia).
      assert (K : (k < contacts P)%nat).
      { unfold n, size in J. assert (Z : free P = 0%nat) by exact (no_free_here i no_free). rewrite Z in J. fold d in J.
        apply Nat.div_lt_upper_bound; lia. }
      rewrite JK, <- (component i no_free). fold P (rr k).
      assert (JF : j = (first (c k) + N.of_nat t)%N).
      { unfold c. rewrite (first_at i no_free). fold P d. lia. }
      assert (U : ~ In j (unknowns_of (t_dim p) (c k))) by (intros Q; apply O, (unknown_of k j K Q)).
      assert (F := fits_at k K). unfold fits in F. rewrite state_here in F. unfold unknowns_of in U.
      assert (A := inside k K). fold P d (friction_of k) in A.
      assert (All : has_friction (t_dim p) (c k) = true -> In j (range (first (c k)) (N.to_nat (t_dim p)))).
      { intros _. apply range_In. rewrite dim_is. lia. }
      destruct (its_mode (c k)) eqn:M; destruct (state_of s (N.of_nat k)) as [| | | |a x] eqn:S; try discriminate.
      + apply A. exact T.
      + apply negb_true_iff in F. rewrite F in U. destruct t as [|t'] eqn:ET.
        * exfalso. apply U. left. rewrite JF. cbn. lia.
        * apply no_friction_force; [exact K | apply friction_none; assumption | lia].
      + exfalso. rewrite F in U. apply U, in_or_app. left. apply All, F.
      + apply andb_prop in F. destruct F as [F _]. exfalso. rewrite F in U. apply U, in_or_app. left. apply All, F.
      + split_and F. exfalso. rewrite F in U. apply U, in_or_app. left. apply All, F.
      + split_and F. exfalso. rewrite F in U. apply U, in_or_app. left. apply All, F.
    - set (k := (N.to_nat j - n)%nat). destruct (nth k modes Open) eqn:M; try reflexivity. exfalso.
      assert (K : (k < contacts P)%nat).
      { change (contacts P) with (length (frictions i)). rewrite <- lengths.
        destruct (Nat.lt_ge_cases k (length modes)) as [L|L]; [exact L|]. rewrite nth_overflow in M by exact L. discriminate. }
      apply O, (unknown_of k j K). unfold unknowns_of. change (its_mode (c k)) with (nth k modes Open). rewrite M.
      apply in_or_app. right. left. apply N2Nat.inj. rewrite slip_index. unfold k. lia.
  Qed.

  (** The unknowns are within so many radii of the center. *)
  Theorem unknowns_near j : In j (unknowns p modes) ->
    Rabs (unknowns_at j - values (center_of b) j) <= value l * absolute (radius_of b) j.
  Proof.
    intros I. assert (D := d_fine). unfold unknowns in I. change (t_frees p) with (frees i) in I. rewrite no_free in I.
    cbn [N.to_nat range app] in I.
    apply in_flat_map in I. destruct I as [c0 [C I]]. destruct (c_only c0 C) as [k [K ->]].
    assert (Proved := all_proved_each i whole fine_numbers no_free s r solves inside _ _ bounded).
    assert (Here : forall e, In e (force_bounds p s b l (c k)) -> In e (flat_map (force_bounds p s b l) (contacts_of p modes))).
    { intros e E. apply in_flat_map. exists (c k). split; [exact C | exact E]. }
    assert (SZ : N.to_nat (t_size p) = n) by exact (size_is i).
    destruct (Nat.lt_ge_cases (N.to_nat j) n) as [J|J].
    - assert (JF : In j (forces_of p (c k))).
      { unfold forces_of. apply filter_In. split; [exact I|]. apply N.ltb_lt. lia. }
      assert (B : forall e, In e [Bound [] [(j, one)] (sub (get (center_of b) j) (mul l (abs (get (radius_of b) j))));
          Bound [] [(j, opp one)] (opp (add (get (center_of b) j) (mul l (abs (get (radius_of b) j)))))] ->
          value (at_least e) <= apply (of_velocities e) (cut i (motion P r)) + apply (of_forces e) (cut i r)).
      { intros e E. apply Proved, Here. unfold force_bounds. apply in_or_app. left. apply in_flat_map. exists j.
        split; [exact JF | exact E]. }
      assert (B1 := B _ (or_introl eq_refl)). assert (B2 := B _ (or_intror (or_introl eq_refl))).
      cbn [at_least of_velocities of_forces apply] in B1, B2.
      rewrite value_sub, value_mul, value_abs, value_one in B1. rewrite !value_opp, value_add, value_mul, value_abs, value_one in B2.
      assert (X : cut i r j = unknowns_at j).
      { unfold cut, unknowns_at. fold P n. destruct (Nat.ltb_spec (N.to_nat j) n); [reflexivity | lia]. }
      rewrite X in B1, B2. unfold values, absolute. apply Rabs_le. lra.
    - assert (M : its_mode (c k) = Slide /\ j = slip (c k)).
      { unfold unknowns_of in I. assert (F0 := first_at i no_free modes k 0). fold P d (c k) in F0. cbn [N.of_nat] in F0.
        assert (L := component_below i no_free k (d - 1) K). fold P n d in L. specialize (L ltac:(lia)).
        assert (One : In j [first (c k)] -> False) by (intros [Q|[]]; lia).
        assert (Range : In j (range (first (c k)) (N.to_nat (t_dim p))) -> False).
        { intros Q. apply range_In in Q. rewrite dim_is in Q. nia. }
        destruct (its_mode (c k)); try (destruct I; fail); try (apply One in I; destruct I; fail);
          apply in_app_or in I; destruct I as [I|I]; try (destruct (has_friction _ _); [apply Range in I | apply One in I]; destruct I);
          try (destruct I; fail). destruct I as [<-|[]]. split; reflexivity. }
      destruct M as [M ->]. rewrite (slip_at k M). assert (F := fits_at k K). unfold fits in F. rewrite state_here, M in F.
      destruct (state_of s (N.of_nat k)) as [| | | |a x] eqn:S; try discriminate.
      destruct (slipping_in_space k a x K M S) as [Q [_ [y [Y [U _]]]]].
      destruct (slip_bounded k a x y _ K M S Y U) as [g [m [[C0 C1] [C2 [B1 B2]]]]].
      assert (S0 : 0 <= slip_value k).
      { unfold slip_value. assert (T := tangential_nonnegative d (uu k)). assert (I0 := Rinv_0_lt_compat _ Q). unfold Rdiv. nra. }
      set (z := values _ _) in *. set (w := value l * _) in *. set (q := friction_of k * rr k 0%nat) in *.
      assert (SQ : 0 <= slip_value k * q) by nra. apply Rabs_le. split.
      + assert (H : (z - w) * (q * (1 + g / 2)) <= slip_value k * (q * (1 + g / 2))) by nra.
        apply Rmult_le_reg_r in H; [lra | nra].
      + assert (H : slip_value k * (q * g) <= (z + w) * (q * g)) by nra.
        apply Rmult_le_reg_r in H; [lra | nra].
  Qed.
End Instance.
