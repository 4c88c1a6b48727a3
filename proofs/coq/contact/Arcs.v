(** Arcs of directions in the plane: chains of them that leave out nothing, and what is greatest on one (FORMAT.md,
    `all-solutions`, "The tree" and "Multipliers"). *)
From Coq Require Import NArith Reals List Bool Lra Lia Psatz FMapPositive.
From Slipproof.contact Require Import Coulomb Number Fixed Linear Zero Certificate Checker Rows Law Motions.
Import ListNotations.
Local Open Scope R_scope.

(** Vectors in the plane *)

Definition arrow := (R * R)%type.
Definition inner (a b : arrow) : R := fst a * fst b + snd a * snd b.
Definition turn (a b : arrow) : R := fst a * snd b - snd a * fst b.
Definition stretch (x : R) (a : arrow) : arrow := (x * fst a, x * snd a).
Definition arrow_of (a : direction) : arrow := (value (fst a), value (snd a)).

Lemma dot_is a b : value (dot a b) = inner (arrow_of a) (arrow_of b).
Proof. unfold dot, inner, arrow_of; cbn. rewrite value_add, !value_mul. reflexivity. Qed.

Lemma cross_is a b : value (cross a b) = turn (arrow_of a) (arrow_of b).
Proof. unfold cross, turn, arrow_of; cbn. rewrite value_sub, !value_mul. reflexivity. Qed.

(** An arc below half a turn, or one direction; and a direction in it. *)
Definition arc (a b : arrow) : Prop := inner a a = 1 /\ inner b b = 1 /\ (0 < turn a b \/ a = b).
Definition in_arc (a b e : arrow) : Prop :=
  arc a b /\ inner e e = 1 /\ exists x y, 0 <= x /\ 0 <= y /\ fst e = x * fst a + y * fst b /\ snd e = x * snd a + y * snd b.

Lemma is_arc_arc a b : is_arc a b = true -> arc (arrow_of a) (arrow_of b) /\ 0 < turn (arrow_of a) (arrow_of b).
Proof.
  intros H. unfold is_arc in H. split_and H. apply eq_value in H. apply eq_value in H1. apply sign_positive in H0.
  rewrite dot_is, value_one in *. rewrite cross_is in H0. repeat split; auto.
Qed.

(** Between the ends, by two signs. *)
Lemma in_arc_turns a b e : arc a b -> 0 < turn a b -> inner e e = 1 -> 0 <= turn a e -> 0 <= turn e b -> in_arc a b e.
Proof.
  intros A T E P Q. split; [exact A|]. split; [exact E|]. exists (turn e b / turn a b), (turn a e / turn a b).
  assert (I : 0 < / turn a b) by (apply Rinv_0_lt_compat, T).
  split; [unfold Rdiv; nra|]. split; [unfold Rdiv; nra|].
  split; apply Rmult_eq_reg_r with (turn a b); try lra; unfold turn in *; field; lra.
Qed.

Lemma in_arc_ends a b e : in_arc a b e -> 0 <= turn a e /\ 0 <= turn e b.
Proof.
  intros [[_ [_ T]] [_ [x [y [X [Y [E F]]]]]]]. unfold turn in *. rewrite E, F.
  destruct T as [T| ->]; split; nra.
Qed.

(** A chain of arcs, from a on: its last end, and that each is an arc. *)
Fixpoint last_of (a : direction) (l : list direction) : direction := match l with [] => a | b :: r => last_of b r end.
Definition all_arcs (a : direction) (l : list direction) : Prop :=
  Forall (fun s => arc (arrow_of (fst s)) (arrow_of (snd s)) /\ 0 < turn (arrow_of (fst s)) (arrow_of (snd s))) (arcs a l).
Definition some_arc (a : direction) (l : list direction) (e : arrow) : Prop :=
  exists s, In s (arcs a l) /\ in_arc (arrow_of (fst s)) (arrow_of (snd s)) e.

Lemma some_arc_later a b l e : some_arc b l e -> some_arc a (b :: l) e.
Proof. intros [s [I A]]. exists s. split; [right; exact I | exact A]. Qed.

(** e is passed where the side on which it is changes. *)
Lemma passed l : forall a e, inner e e = 1 -> all_arcs a l -> 0 <= turn (arrow_of a) e ->
  (exists b, In b l /\ turn (arrow_of b) e <= 0) -> some_arc a l e.
Proof.
  induction l as [|b l IH]; intros a e E A S [c [C T]]; [destruct C|].
  inversion A as [|? ? [AB P] A']; subst. cbn [fst snd] in *.
  destruct (Rle_lt_dec (turn (arrow_of b) e) 0) as [B|B].
  - exists (a, b). split; [left; reflexivity|]. apply in_arc_turns; auto. cbn. unfold turn in *. lra.
  - apply some_arc_later, IH; auto; [lra|]. exists c. split; [|exact T].
    destruct C as [<-|C]; [lra | exact C].
Qed.

(** Where all are on one side of e, each is farther along it. *)
Lemma farther l : forall a e, inner e e = 1 -> all_arcs a l -> l <> [] ->
  (forall b c, In b (a :: l) -> In c (a :: l) -> 0 < turn (arrow_of b) e * turn (arrow_of c) e) ->
  inner e (arrow_of a) / turn (arrow_of a) e < inner e (arrow_of (last_of a l)) / turn (arrow_of (last_of a l)) e.
Proof.
  induction l as [|b l IH]; intros a e E A N S; [contradiction|].
  inversion A as [|? ? [_ P] A']; subst. cbn [fst snd last_of] in *.
  assert (Step : inner e (arrow_of a) / turn (arrow_of a) e < inner e (arrow_of b) / turn (arrow_of b) e).
  { assert (Q := S a b ltac:(left; reflexivity) ltac:(right; left; reflexivity)).
    assert (QA := S a a ltac:(left; reflexivity) ltac:(left; reflexivity)).
    assert (QB := S b b ltac:(right; left; reflexivity) ltac:(right; left; reflexivity)).
    set (p := turn (arrow_of a) e) in *. set (q := turn (arrow_of b) e) in *.
    assert (p <> 0) by (intros Z; rewrite Z in QA; lra). assert (q <> 0) by (intros Z; rewrite Z in QB; lra).
    assert (W : inner e (arrow_of b) * p - inner e (arrow_of a) * q = turn (arrow_of a) (arrow_of b)).
    { transitivity (turn (arrow_of a) (arrow_of b) * inner e e); [|rewrite E; ring].
      unfold p, q, inner, turn. ring. }
    assert (0 < / (p * q)) by (apply Rinv_0_lt_compat, Q).
    replace (inner e (arrow_of b) / q)
      with (inner e (arrow_of a) / p + (inner e (arrow_of b) * p - inner e (arrow_of a) * q) * / (p * q)) by (field; auto).
    rewrite W. nra. }
  destruct l as [|c l]; [exact Step|]. eapply Rlt_trans; [exact Step|].
  apply IH; auto; [discriminate|]. intros; apply S; right; assumption.
Qed.

Lemma some_or_none (l : list direction) (P : direction -> Prop) : (forall x, {P x} + {~ P x}) ->
  (exists x, In x l /\ P x) \/ (forall x, In x l -> ~ P x).
Proof.
  intros D. induction l as [|x l [[y [Y Q]]|N]]; [right; intros _ []| left; exists y; split; [right|]; assumption|].
  destruct (D x) as [Q|Q]; [left; exists x; split; [left; reflexivity | exact Q]|].
  right. intros y [<-|Y]; auto.
Qed.

Lemma last_In a l : l <> [] -> In (last_of a l) l.
Proof.
  revert a. induction l as [|b l IH]; intros a N; [contradiction|]. cbn. destruct l as [|c l]; [left; reflexivity|].
  right. apply IH. discriminate.
Qed.

(** Arcs that come back to where they begin leave out no direction. *)
Lemma arcs_go_round a l e : inner e e = 1 -> l <> [] -> last_of a l = a -> all_arcs a l -> some_arc a l e.
Proof.
  intros E N L A. set (side := fun b : direction => turn (arrow_of b) e). assert (LI := last_In a l N). rewrite L in LI.
  assert (Same : forall s, (forall b, In b l -> 0 < s * side b) -> False).
  { intros s P. apply (Rlt_irrefl (inner e (arrow_of a) / turn (arrow_of a) e)).
    rewrite <- L at 3 4. apply farther; auto.
    assert (P' : forall b, In b (a :: l) -> 0 < s * side b) by (intros b [<-|B]; apply P; assumption).
    intros b c B C. specialize (P' b B) as PB. specialize (P' c C) as PC. unfold side in *. nra. }
  destruct (Rle_lt_dec 0 (side a)) as [S|S].
  - destruct (some_or_none l (fun b => side b <= 0) (fun b => Rle_dec _ _)) as [X|X].
    + apply passed; auto.
    + exfalso. apply (Same 1). intros b B. apply X in B. lra.
  - destruct (some_or_none l (fun b => 0 <= side b) (fun b => Rle_dec _ _)) as [[b [B T]]|X].
    2: { exfalso. apply (Same (-1)). intros b B. apply X in B. lra. }
    clear LI Same. assert (Z : side (last_of a l) < 0) by (rewrite L; exact S). clear L N S.
    revert a A B Z. induction l as [|c l IH]; intros a A B Z; [destruct B|].
    inversion A as [|? ? _ A']; subst. cbn [last_of] in Z. apply some_arc_later.
    destruct B as [->|B].
    + assert (NE : l <> [] \/ l = []) by (destruct l; [right | left; discriminate]; reflexivity). destruct NE as [NE| ->].
      * apply passed; auto. exists (last_of b l). split; [apply last_In, NE | apply Rlt_le, Z].
      * cbn in Z. lra.
    + apply IH; auto.
Qed.

(** Arcs that cut an arc cover it. *)
Lemma arcs_cut a b l e : all_arcs a (l ++ [b]) -> in_arc (arrow_of a) (arrow_of b) e -> some_arc a (l ++ [b]) e.
Proof.
  intros A I. destruct (in_arc_ends _ _ _ I) as [P Q]. apply passed; auto; [apply I|].
  exists b. split; [apply in_or_app; right; left; reflexivity|]. unfold turn in *. lra.
Qed.

Lemma in_arc_single a e : in_arc a a e -> e = a.
Proof.
  intros [[A _] [E [x [y [X [Y [E1 E2]]]]]]].
  assert (Q : (x + y) * (x + y) = 1).
  { rewrite <- E. unfold inner in *. rewrite E1, E2.
    replace ((x + y) * (x + y)) with ((x + y) * (x + y) * (fst a * fst a + snd a * snd a)) by (rewrite A; ring). ring. }
  assert (S : x + y = 1) by nra. rewrite (surjective_pairing e), (surjective_pairing a). f_equal.
  - transitivity ((x + y) * fst a); [rewrite E1; ring | rewrite S; ring].
  - transitivity ((x + y) * snd a); [rewrite E2; ring | rewrite S; ring].
Qed.

(** A direction of an arc is a sum of its ends whose coefficients sum up to 1 at least. *)
Lemma in_arc_sum a b e : in_arc a b e -> exists s, 1 <= s /\
  forall c, inner c a + inner c b = 2 * inner c a -> inner c e = s * inner c a.
Proof.
  intros [[A [B _]] [E [x [y [X [Y [E1 E2]]]]]]]. exists (x + y). split; [|intros c C; unfold inner in *; rewrite E1, E2; nra].
  assert (K : inner a b <= 1).
  { assert (Q := Rle_0_sqr (fst a - fst b)). assert (Q' := Rle_0_sqr (snd a - snd b)). unfold Rsqr, inner in *. nra. }
  assert (S : x * x + y * y + 2 * (x * y) * inner a b = 1).
  { rewrite <- E at 1. unfold inner in *. rewrite E1, E2.
    transitivity (x * x * (fst a * fst a + snd a * snd a) + y * y * (fst b * fst b + snd b * snd b)
      + 2 * (x * y) * (fst a * fst b + snd a * snd b)); [rewrite A, B; ring | ring]. }
  assert (0 <= x * y) by (apply Rmult_le_pos; assumption). nra.
Qed.

(** With m = a + b and c = 1 + a . b, c <= e . m <= |m| = sqrt(2 c) <= 1 + c / 2. *)
Lemma in_arc_middle a b e : in_arc a b e -> let c := 1 + inner a b in let m := (fst a + fst b, snd a + snd b) in
  0 < c /\ c <= inner m e <= 1 + c / 2.
Proof.
  intros I c m. destruct (in_arc_sum _ _ _ I) as [s [S P]]. destruct I as [[A [B T]] [E _]].
  assert (C : 0 < c).
  { unfold c. destruct T as [T| ->]; [|rewrite B; lra].
    assert (Q : inner a b * inner a b + turn a b * turn a b = 1).
    { transitivity (inner a a * inner b b); [unfold inner, turn; ring | rewrite A, B; ring]. } nra. }
  assert (MA : inner m a = c) by (unfold c; rewrite <- A; unfold inner, m; cbn; ring).
  assert (MB : inner m b = c) by (unfold c; rewrite <- B; unfold inner, m; cbn; ring).
  split; [exact C|]. split; [rewrite P, MA by lra; nra|].
  assert (Q : inner m e * inner m e <= 2 * c).
  { assert (Q := Rle_0_sqr (fst m * snd e - snd m * fst e)). unfold Rsqr in Q.
    assert (MM : inner m m = 2 * c).
    { transitivity (inner a a + inner b b + 2 * inner a b); [unfold inner, m; cbn; ring | rewrite A, B; unfold c; ring]. }
    rewrite <- MM, <- (Rmult_1_r (inner m m)), <- E. unfold inner. nra. }
  assert (Q' := Rle_0_sqr (1 - c / 2)). unfold Rsqr in Q'. nra.
Qed.

(** On an arc no product is greater than at both ends, unless the other vector points into it. *)
Lemma greatest_at_ends a b e g : in_arc a b e -> ~ (0 < turn a g /\ 0 < turn g b) ->
  inner g e <= Rmax (inner g a) (inner g b).
Proof.
  intros I O. assert (T := in_arc_ends _ _ _ I). assert (Single := in_arc_single a e).
  destruct I as [[A [B [C | <-]]] [E [x [y [X [Y [E1 E2]]]]]]].
  2: { rewrite Single, Rmax_left; [lra | lra|]. split; [split; auto|]. split; [exact E|]. exists x, y. auto. }
  assert (Cos : forall c, inner c c = 1 -> inner c e <= 1).
  { intros c U. assert (Q := Rle_0_sqr (fst c - fst e)). assert (Q' := Rle_0_sqr (snd c - snd e)).
    unfold Rsqr, inner in *. nra. }
  set (k := inner a b).
  assert (K1 : k <= 1).
  { assert (Q := Rle_0_sqr (fst a - fst b)). assert (Q' := Rle_0_sqr (snd a - snd b)). unfold k, Rsqr, inner in *. nra. }
  assert (GA' : turn a b * inner g a = - turn b g + turn a g * k).
  { transitivity (- turn b g * inner a a + turn a g * k); [unfold k, inner, turn; ring | rewrite A; ring]. }
  assert (GB' : turn a b * inner g b = - turn b g * k + turn a g).
  { transitivity (- turn b g * k + turn a g * inner b b); [unfold k, inner, turn; ring | rewrite B; ring]. }
  assert (Parts : forall c, inner c c = 1 -> inner g e = inner g c * inner c e + turn c g * turn c e).
  { intros c U. transitivity (inner c c * inner g e); [rewrite U; ring | unfold inner, turn; ring]. }
  assert (XY : 1 <= x + y).
  { assert (S : x * x + y * y + 2 * (x * y) * k = 1).
    { rewrite <- E at 1. unfold k, inner in *. rewrite E1, E2.
      transitivity (x * x * (fst a * fst a + snd a * snd a) + y * y * (fst b * fst b + snd b * snd b)
        + 2 * (x * y) * (fst a * fst b + snd a * snd b)); [rewrite A, B; ring | ring]. }
    assert (0 <= x * y) by (apply Rmult_le_pos; assumption). nra. }
  assert (Sum : inner g e = x * inner g a + y * inner g b) by (unfold inner; rewrite E1, E2; ring).
  unfold Rmax. destruct (Rle_dec (inner g a) (inner g b)) as [L|L].
  - (* the end b *)
    destruct (Rle_lt_dec (inner g b) 0) as [G|G]; [nra|].
    assert (CB := Cos b B). rewrite (Parts b B).
    assert (TB : turn b e <= 0) by (unfold turn in *; lra).
    destruct (Rle_lt_dec 0 (turn b g)) as [N|N]; [nra|].
    assert (NA : turn a g <= 0) by (destruct (Rle_lt_dec (turn a g) 0); [assumption|]; exfalso; apply O; unfold turn in *; lra).
    destruct (Rle_lt_dec 0 (inner g a)) as [GA|GA].
    { assert (CA := Cos a A). rewrite <- (Parts b B), (Parts a A). nra. }
    exfalso. nra.
  - (* the end a *)
    apply Rnot_le_lt in L. destruct (Rle_lt_dec (inner g a) 0) as [G|G]; [nra|].
    assert (CA := Cos a A). rewrite (Parts a A).
    destruct (Rle_lt_dec (turn a g) 0) as [N|N]; [nra|].
    assert (NB : turn g b <= 0) by (destruct (Rle_lt_dec (turn g b) 0); [assumption|]; exfalso; apply O; lra).
    assert (TB : turn b e <= 0) by (unfold turn in *; lra).
    destruct (Rle_lt_dec 0 (inner g b)) as [GB|GB].
    { assert (CB := Cos b B). assert (0 <= turn b g) by (unfold turn in *; lra).
      rewrite <- (Parts a A), (Parts b B). nra. }
    exfalso. assert (0 <= turn b g) by (unfold turn in *; lra). nra.
Qed.
