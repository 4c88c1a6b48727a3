(** What the states of a contact allow; the cases of a node are all that Coulomb's law has; and which forms are not negative
    in a state (FORMAT.md, `all-solutions`, "States", "Multipliers"). *)
From Coq Require Import NArith Reals List Bool Lra Lia Psatz FMapPositive.
From Slipproof.contact Require Import Coulomb Number Fixed Linear Zero Certificate Checker Rows Law Motions Arcs.
Import ListNotations.
Local Open Scope R_scope.

(** The tangential part of a vector; what the dimension does not have is 0. *)
Definition plane (d : nat) (v : nat -> R) : arrow := (if Nat.ltb 1 d then v 1%nat else 0, if Nat.ltb 2 d then v 2%nat else 0).

Definition allows (d : nat) (m : R) (s : state) (r u : nat -> R) : Prop :=
  match s with
  | AnyState => True
  | OpenState => 0 < u 0%nat /\ forall t, (t < d)%nat -> r t = 0
  | ClosedState => u 0%nat = 0
  | StickState => forall t, (t < d)%nat -> u t = 0
  | SlipState a b => u 0%nat = 0 /\ exists e v, in_arc (arrow_of a) (arrow_of b) e /\ 0 < v /\
      plane d u = stretch v e /\ plane d r = stretch (- (m * r 0%nat)) e
  end.

Ltac by_dimension d := destruct d as [|[|[|[|d]]]]; try lia; cbn.

Lemma sum_plane d v w : (1 <= d <= 3)%nat ->
  sum d (fun t => v t * w t) = v 0%nat * w 0%nat + inner (plane d v) (plane d w).
Proof. intros D. unfold inner, plane. by_dimension d; ring. Qed.

Lemma square_plane d v : (1 <= d <= 3)%nat -> square_of d v = inner (plane d v) (plane d v).
Proof. intros D. unfold square_of, inner, plane. by_dimension d; ring. Qed.

Lemma plane_components d v a : (1 <= d <= 3)%nat -> plane d v = a ->
  ((1 < d)%nat -> v 1%nat = fst a) /\ ((2 < d)%nat -> v 2%nat = snd a).
Proof. intros D <-. unfold plane. by_dimension d; split; intros; try lia; reflexivity. Qed.

Lemma stretch_inner x a b : inner (stretch x a) b = x * inner a b.
Proof. unfold inner, stretch; cbn; ring. Qed.

Lemma inner_stretch x a b : inner b (stretch x a) = x * inner b a.
Proof. unfold inner, stretch; cbn; ring. Qed.

Lemma inner_zero a : inner a a = 0 -> a = (0, 0).
Proof. destruct a as [x y]. unfold inner; cbn. intros E. f_equal; nra. Qed.

(** Coulomb's law in the plane. *)
Lemma coulomb_plane d m r u : (1 <= d <= 3)%nat -> coulomb d m r u ->
  inner (plane d r) (plane d r) <= (m * r 0%nat) * (m * r 0%nat) /\
  exists v, 0 <= v /\ v * v = inner (plane d u) (plane d u) /\
    stretch v (plane d r) = stretch (- (m * r 0%nat)) (plane d u).
Proof.
  intros D [_ _ _ C O]. split.
  - rewrite <- square_plane, <- tangential_square by exact D. assert (Q := tangential_nonnegative d r). nra.
  - exists (tangential d u). split; [apply tangential_nonnegative|]. split.
    + rewrite <- square_plane by exact D. apply tangential_square.
    + unfold stretch, plane. assert (O1 := O 1%nat). assert (O2 := O 2%nat).
      destruct d as [|[|[|[|d]]]]; try lia; cbn [Nat.ltb Nat.leb fst snd]; f_equal; try ring; (apply O1 || apply O2); lia.
Qed.

Lemma tangents_zero d v : (1 <= d <= 3)%nat -> inner (plane d v) (plane d v) = 0 -> forall t, (1 <= t < d)%nat -> v t = 0.
Proof.
  intros D Z [|t] T; [lia|]. rewrite <- square_plane in Z by exact D.
  apply (sum_square_zero (d - 1) (fun t => v (S t))); [exact Z | lia].
Qed.

(** The cases are all *)

Lemma open_or_closed d m r u : (1 <= d <= 3)%nat -> coulomb d m r u ->
  allows d m OpenState r u \/ allows d m ClosedState r u.
Proof.
  intros D C. destruct (coulomb_plane _ _ _ _ D C) as [R0 _]. destruct C as [_ U Z0 _ _].
  destruct (Rle_lt_dec (u 0%nat) 0) as [L|L]; [right; cbn; lra|]. left. split; [exact L|].
  assert (Z : r 0%nat = 0) by nra. intros [|t] T; [exact Z|]. apply (tangents_zero d r D); [|lia].
  rewrite Z in R0. assert (Q : 0 <= inner (plane d r) (plane d r)) by (unfold inner; nra). nra.
Qed.

(** A contact that does not stick slips in some direction. *)
Lemma stick_or_slip d m r u : (1 <= d <= 3)%nat -> coulomb d m r u -> u 0%nat = 0 ->
  allows d m StickState r u \/
  exists e v, inner e e = 1 /\ 0 < v /\ plane d u = stretch v e /\ plane d r = stretch (- (m * r 0%nat)) e.
Proof.
  intros D C Z. destruct (coulomb_plane _ _ _ _ D C) as [_ [v [V [VV O]]]].
  destruct V as [V|V].
  - right. exists (stretch (/ v) (plane d u)), v. rewrite stretch_inner, inner_stretch, <- VV.
    split; [field; lra|]. split; [exact V|].
    assert (O1 := f_equal fst O). assert (O2 := f_equal snd O). unfold stretch in *; cbn [fst snd] in *. split.
    + rewrite (surjective_pairing (plane d u)) at 1. f_equal; field; lra.
    + rewrite (surjective_pairing (plane d r)) at 1. f_equal; apply Rmult_eq_reg_l with v; try lra;
        [rewrite O1 | rewrite O2]; field; lra.
  - left. intros [|t] T; [exact Z|]. apply (tangents_zero d u D); [|lia]. rewrite <- VV, <- V. ring.
Qed.

Lemma slips_some d m r u l : (1 <= d <= 3)%nat -> u 0%nat = 0 -> forall e v a,
  0 < v -> plane d u = stretch v e -> plane d r = stretch (- (m * r 0%nat)) e -> some_arc a l e ->
  exists s, In s (slips_in (arcs a l)) /\ allows d m s r u.
Proof.
  intros D P e v a V U R [s [I A]]. exists (SlipState (fst s) (snd s)). split.
  - apply (in_map (fun a => SlipState (fst a) (snd a))), I.
  - split; [exact P|]. exists e, v. auto.
Qed.

Lemma are_arcs_all a l : are_arcs (arcs a l) = true -> all_arcs a l.
Proof.
  intros H. unfold are_arcs in H. apply andb_prop in H. destruct H as [_ H]. apply Forall_forall. intros s S.
  rewrite forallb_forall in H. apply is_arc_arc, H, S.
Qed.

Lemma last_of_app a l b : last_of a (l ++ [b]) = b.
Proof. revert a. induction l as [|c l IH]; intros a; [reflexivity|]. cbn. apply IH. Qed.

Lemma planar_direction d u e v : d = 2%nat -> inner e e = 1 -> 0 < v -> plane d u = stretch v e ->
  e = arrow_of ahead \/ e = arrow_of (opposite_direction ahead).
Proof.
  intros -> E V U. unfold plane, stretch in U; cbn in U. injection U as _ U2.
  unfold arrow_of, ahead, opposite_direction; cbn [fst snd]. rewrite !value_opp, !value_one, !value_zero.
  destruct e as [x y]; cbn in *. unfold inner in E; cbn in E. assert (y = 0) by nra. subst y.
  assert (Q : (x - 1) * (x + 1) = 0) by lra. apply Rmult_integral in Q. destruct Q; [left | right]; f_equal; lra.
Qed.

Lemma single_arc a : inner a a = 1 -> in_arc a a a.
Proof. intros A. split; [split; auto|]. split; [exact A|]. exists 1, 0. repeat split; lra. Qed.

Theorem cases_cover p n s r u : let d := N.to_nat (t_dim p) in let m := value (nth (N.to_nat (of_node n)) (t_mus p) zero) in
  (1 <= d <= 3)%nat -> covers p n s = true -> coulomb d m r u -> allows d m s r u ->
  exists t, In t (cases (t_dim p) n s) /\ allows d m t r u.
Proof.
  intros d m D H C A. unfold covers in H. apply andb_prop in H. destruct H as [_ H].
  destruct n as [k|k l|k l|y|k ys|k q], s as [| | | |a b]; try discriminate; cbn [cases of_node] in *.
  - destruct (open_or_closed d m r u D C) as [Q|Q]; eexists; (split; [|exact Q]); [left | right; left]; reflexivity.
  - split_and H. cbn in A. destruct (stick_or_slip d m r u D C A) as [Q|[e [v [E [V [U R]]]]]].
    { exists StickState. split; [left; reflexivity | exact Q]. }
    destruct (N.ltb_spec (t_dim p) 3) as [L|L].
    + apply N.ltb_lt in H1.
      assert (Two : d = 2%nat) by (unfold d; lia).
      assert (Slips : forall a, e = arrow_of a -> allows d m (SlipState a a) r u).
      { intros a Q. split; [exact A|]. exists e, v. rewrite <- Q. auto using single_arc. }
      destruct (planar_direction d u e v Two E V U) as [Q|Q]; apply Slips in Q; eexists; (split; [|exact Q]);
        [right; left | right; right; left]; reflexivity.
    + cbn in H0. destruct l as [|a l]; [discriminate|]. cbn [arcs_around] in *.
      assert (S : some_arc a (l ++ [a]) e).
      { apply arcs_go_round; [exact E | destruct l; discriminate | apply last_of_app | apply are_arcs_all, H0]. }
      destruct (slips_some d m r u _ D A e v a V U R S) as [t [I T]]. exists t. split; [right; exact I | exact T].
  - split_and H. destruct A as [P [e [v [E [V [U R]]]]]]. cbn [arcs_within] in *.
    assert (S := arcs_cut a b l e (are_arcs_all _ _ H0) E).
    apply (slips_some d m r u _ D P e v a V U R S).
Qed.

(** Forms that are not negative *)

Lemma in_arc_positive a b e v : in_arc a b e -> 0 <= inner v a -> 0 <= inner v b ->
  0 <= inner v e /\ (0 < inner v a -> 0 < inner v b -> 0 < inner v e).
Proof.
  intros [_ [E [x [y [X [Y [E1 E2]]]]]]] A B.
  assert (S : inner v e = x * inner v a + y * inner v b) by (unfold inner; rewrite E1, E2; ring).
  rewrite S. split; [nra|]. intros A' B'. destruct X as [X| <-]; [nra|]. destruct Y as [Y| <-]; [nra|].
  exfalso. unfold inner in E. rewrite E1, E2 in E. lra.
Qed.

Section State.
  Variables (d : nat) (m : number) (s : state) (r u : nat -> R).
  Hypothesis dimension : (1 <= d <= 3)%nat.
  Hypothesis friction : 0 <= value m.
  Hypothesis law : coulomb d (value m) r u.
  Hypothesis allowed : allows d (value m) s r u.

  Lemma velocities_sound vn v : fine_velocities s vn v = true ->
    0 <= value vn * u 0%nat + inner (arrow_of v) (plane d u) /\
    (more_velocities s vn v = true -> 0 < value vn * u 0%nat + inner (arrow_of v) (plane d u)).
  Proof.
    intros H. destruct law as [P U C _ _].
    assert (Zero : is_zero (fst v) = true -> is_zero (snd v) = true -> inner (arrow_of v) (plane d u) = 0).
    { intros A B. apply sign_zero in A. apply sign_zero in B. unfold inner, arrow_of; cbn. rewrite A, B. ring. }
    destruct s as [| | | |a b]; cbn [fine_velocities more_velocities allows] in *.
    - split_and H. apply sign_nonnegative in H. rewrite Zero by assumption. split; [nra | discriminate].
    - destruct allowed as [U0 _]. split_and H. apply sign_nonnegative in H. rewrite Zero by assumption. split; [nra|].
      intros M. apply sign_positive in M. nra.
    - split_and H. rewrite Zero, allowed by assumption. split; [lra | discriminate].
    - split; [|discriminate]. unfold plane, inner. rewrite (allowed 0%nat) by lia.
      assert (Z1 := allowed 1%nat). assert (Z2 := allowed 2%nat).
      destruct (Nat.ltb_spec 1 d); destruct (Nat.ltb_spec 2 d); cbn; rewrite ?Z1, ?Z2 by lia; lra.
    - destruct allowed as [U0 [e [w [A [W [PU _]]]]]].
      split_and H. apply sign_nonnegative in H. apply sign_nonnegative in H0. rewrite dot_is in *.
      destruct (in_arc_positive _ _ _ _ A H H0) as [Q Q']. rewrite U0, PU, inner_stretch. split; [nra|].
      intros M. split_and M. apply sign_positive in M. apply sign_positive in H1. rewrite dot_is in *.
      specialize (Q' M H1). nra.
  Qed.

  Lemma cone_sound gn g : over_cone m gn g = true ->
    0 <= value gn * r 0%nat + inner (arrow_of g) (plane d r).
  Proof.
    intros H. destruct (coulomb_plane _ _ _ _ dimension law) as [K _]. destruct law as [P _ _ _ _].
    unfold over_cone, Checker.square in *. split_and H. apply sign_nonnegative in H. apply le_value in H0.
    rewrite !value_mul, dot_is in H0. set (gt := arrow_of g) in *. set (rt := plane d r) in *.
    set (x := value gn) in *. set (y := r 0%nat) in *. set (f := value m) in *.
    assert (CS : inner gt rt * inner gt rt <= inner gt gt * inner rt rt).
    { assert (Q := Rle_0_sqr (fst gt * snd rt - snd gt * fst rt)). unfold Rsqr, inner in *. nra. }
    assert (GG : 0 <= inner gt gt) by (unfold inner; nra).
    assert (B : inner gt rt * inner gt rt <= (x * y) * (x * y)).
    { eapply Rle_trans; [exact CS|]. eapply Rle_trans; [apply Rmult_le_compat_l; [exact GG | exact K]|].
      replace (inner gt gt * (f * y * (f * y))) with (f * f * inner gt gt * (y * y)) by ring.
      replace (x * y * (x * y)) with (x * x * (y * y)) by ring. apply Rmult_le_compat_r; [nra | exact H0]. }
    assert (XY : 0 <= x * y) by nra. nra.
  Qed.

  Lemma forces_sound gn g : fine_forces s m gn g = true ->
    0 <= value gn * r 0%nat + inner (arrow_of g) (plane d r).
  Proof.
    intros H. destruct s as [| | | |a b] eqn:S; cbn [fine_forces allows] in *.
    - apply cone_sound, H.
    - destruct allowed as [_ Z]. unfold plane, inner. rewrite (Z 0%nat) by lia.
      destruct (Nat.ltb_spec 1 d); destruct (Nat.ltb_spec 2 d); cbn; rewrite ?(Z 1%nat), ?(Z 2%nat) by lia; lra.
    - apply cone_sound, H.
    - apply cone_sound, H.
    - destruct allowed as [_ [e [v [A [_ [_ PR]]]]]]. destruct law as [R0 _ _ _ _]. destruct (points_into a b g) eqn:I.
      + apply cone_sound, H.
      + assert (G : inner (arrow_of g) e <= Rmax (inner (arrow_of g) (arrow_of a)) (inner (arrow_of g) (arrow_of b))).
        { apply greatest_at_ends; [exact A|]. intros [T1 T2]. unfold points_into in I.
          apply andb_false_iff in I. rewrite <- !cross_is in *.
          destruct I as [I|I]; unfold positive_number in I; apply Z.ltb_ge in I;
            [assert (N := T1) | assert (N := T2)]; unfold value in N;
            apply IZR_le in I; assert (P := Rinv_0_lt_compat _ (scale_pos (cross a g)));
            assert (P' := Rinv_0_lt_compat _ (scale_pos (cross g b))); unfold Rdiv in N; nra. }
        rewrite PR, inner_stretch. set (x := inner (arrow_of g) e) in *.
        split_and H. apply le_value in H. apply le_value in H0. rewrite value_mul, dot_is in *.
        assert (X : value m * x <= value gn).
        { unfold Rmax in G. destruct (Rle_dec _ _) in G; nra. }
        nra.
  Qed.
End State.
