(** Terms run: numbers that are affine in unknowns, with rational coefficients. Nothing here uses normal forms. *)
From Coq Require Import String List Bool ZArith QArith Qreals Reals Lra Lia.
From Slipproof Require Import Text Syntax.
From Slipproof.claim Require Import Expression.
From Slipproof.claim Require Linear.
Import ListNotations.
Local Open Scope R_scope.

Notation linear := Linear.linear.
Notation affine_value := Linear.value.

(** Rational numbers, reduced. *)
Definition divided (g : Z) (q : Q) : Q :=
  let a := (Qnum q / g)%Z in
  match (Zpos (Qden q) / g)%Z with
  | Zpos d => if Z.eqb (g * a) (Qnum q) && Z.eqb (g * Zpos d) (Zpos (Qden q)) then Qmake a d else q
  | _ => q
  end.
Definition reduce (q : Q) : Q :=
  match Qden q with xH => q | d => divided (Z.abs (Linear.common Linear.fuel (Qnum q) (Zpos d))) q end.
Definition sum (a b : Q) : Q := reduce (Qplus a b).
Definition product (a b : Q) : Q := reduce (Qmult a b).
Definition is_zero (a : Q) : bool := Z.eqb (Qnum a) 0.
Fixpoint power (a : Q) (n : nat) : Q := match n with O => 1%Q | S n => product a (power a n) end.

Definition fixed (q : Q) : linear := Linear.Linear [] q.
Fixpoint add_lists (l m : list Q) : list Q :=
  match l, m with [], _ => m | _, [] => l | a :: l, b :: m => sum a b :: add_lists l m end.
Definition add (l m : linear) : linear :=
  Linear.Linear (add_lists (Linear.coefficients l) (Linear.coefficients m)) (sum (Linear.constant l) (Linear.constant m)).
Definition times (a : Q) (l : linear) : linear :=
  Linear.Linear (map (product a) (Linear.coefficients l)) (product a (Linear.constant l)).
Definition opposed (l : linear) : linear := Linear.Linear (map Qopp (Linear.coefficients l)) (Qopp (Linear.constant l)).
Definition constant_of (l : linear) : option Q :=
  if forallb is_zero (Linear.coefficients l) then Some (Linear.constant l) else None.

Definition meets (r : Linear.relation) (q : Q) : bool :=
  match r with Linear.Zero => Z.eqb (Qnum q) 0 | Linear.Positive => Z.ltb 0 (Qnum q) | Linear.NonNegative => Z.leb 0 (Qnum q) end.

(** What is known of a number: nothing, that it has no value, or its value. *)
Inductive answer := Unclear | Undefined | Affine (l : linear).
Definition scope := string -> answer.
Definition with_answer (name : string) (a : answer) (names : scope) : scope :=
  fun other => if String.eqb other name then a else names other.

Definition one (f : linear -> answer) (a : answer) : answer := match a with Affine l => f l | a => a end.
Definition two (f : linear -> linear -> answer) (a b : answer) : answer :=
  match a, b with
  | Undefined, _ | _, Undefined => Undefined
  | Affine l, Affine m => f l m
  | _, _ => Unclear
  end.
Definition of_constant (f : Q -> answer) (l : linear) : answer := match constant_of l with Some a => f a | None => Unclear end.
Definition number (q : Q) : answer := Affine (fixed q).

Section Values.
Variable names : scope.

Fixpoint answer_of (e : term) : answer :=
  match e with
  | Number n => number (inject_Z (Z.of_N n))
  | Symbol name => names name
  | Minus a => one (fun l => Affine (opposed l)) (answer_of a)
  | Plus a b => two (fun l m => Affine (add l m)) (answer_of a) (answer_of b)
  | Difference a b => two (fun l m => Affine (add l (opposed m))) (answer_of a) (answer_of b)
  | Product a b =>
      two (fun l m => match constant_of l with Some a => Affine (times a m) | None => of_constant (fun b => Affine (times b l)) m end)
          (answer_of a) (answer_of b)
  | Quotient a b =>
      two (fun l => of_constant (fun b => if is_zero b then Undefined else Affine (times (Qinv b) l))) (answer_of a) (answer_of b)
  | Power a k =>
      one (fun l => match k with
                    | Z0 => number 1
                    | Zpos xH => Affine l
                    | Zpos n => of_constant (fun a => number (power a (Pos.to_nat n))) l
                    | Zneg n => of_constant (fun a => if is_zero a then Undefined else number (Qinv (power a (Pos.to_nat n)))) l
                    end) (answer_of a)
  | Absolute a => one (of_constant (fun a => number (Qmake (Z.abs (Qnum a)) (Qden a)))) (answer_of a)
  | Signum a => one (of_constant (fun a => number (inject_Z (Z.sgn (Qnum a))))) (answer_of a)
  | Minimum a b => two (fun l m => of_constant (fun a => of_constant (fun b => number (if Qle_bool a b then a else b)) m) l)
                       (answer_of a) (answer_of b)
  | Maximum a b => two (fun l m => of_constant (fun a => of_constant (fun b => number (if Qle_bool a b then b else a)) m) l)
                       (answer_of a) (answer_of b)
  end.
End Values.

(** Soundness *)

Lemma divided_equal g q : (divided g q == q)%Q.
Proof.
  unfold divided. generalize (Qnum q / g)%Z. intro a. destruct (Z.pos (Qden q) / g)%Z as [|d|d]; try reflexivity. destruct (_ && _) eqn:F; [|reflexivity].
  apply andb_true_iff in F. destruct F as [A B]. apply Z.eqb_eq in A, B. unfold Qeq. cbn [Qnum Qden]. rewrite <- A, <- B. ring.
Qed.
Lemma reduce_equal q : (reduce q == q)%Q.
Proof.
  unfold reduce. generalize (fun d => Z.abs (Linear.common Linear.fuel (Qnum q) (Zpos d))). intro g.
  destruct (Qden q); try reflexivity; apply divided_equal.
Qed.
Lemma sum_real a b : Q2R (sum a b) = Q2R a + Q2R b.
Proof. unfold sum. rewrite (Qeq_eqR _ _ (reduce_equal _)). apply Q2R_plus. Qed.
Lemma product_real a b : Q2R (product a b) = Q2R a * Q2R b.
Proof. unfold product. rewrite (Qeq_eqR _ _ (reduce_equal _)). apply Q2R_mult. Qed.

Lemma real_zero : Q2R 0 = 0.
Proof. unfold Q2R; simpl. ring. Qed.
Lemma real_integer n : Q2R (inject_Z n) = IZR n.
Proof. unfold Q2R, inject_Z; simpl. field. Qed.

Lemma denominator_positive (q : Q) : 0 < / IZR (Zpos (Qden q)).
Proof. apply Rinv_0_lt_compat, IZR_lt. reflexivity. Qed.
Lemma numerator_zero q : is_zero q = true <-> Q2R q = 0.
Proof.
  unfold is_zero, Q2R. assert (P := denominator_positive q). rewrite Z.eqb_eq. split; intro H.
  - rewrite H. ring.
  - apply Rmult_integral in H. destruct H; [now apply eq_IZR|lra].
Qed.
Lemma not_zero q : is_zero q = false -> Q2R q <> 0.
Proof. intros H E. apply numerator_zero in E. congruence. Qed.
Lemma inverse_real q : is_zero q = false -> Q2R (Qinv q) = / Q2R q.
Proof. intro H. apply Q2R_inv. intro E. apply (not_zero q H). rewrite (Qeq_eqR _ _ E). apply real_zero. Qed.

Lemma power_real a n : Q2R (power a n) = Q2R a ^ n.
Proof. induction n as [|n IH]; simpl; [unfold Q2R; simpl; field|]. now rewrite product_real, IH. Qed.

Lemma meets_real r q : meets r q = true <-> Linear.meets r (Q2R q).
Proof.
  unfold Q2R. assert (P := denominator_positive q).
  assert (S : IZR (Qnum q) = IZR (Qnum q) * / IZR (Zpos (Qden q)) * IZR (Zpos (Qden q))).
  { field. intro E. rewrite E, Rinv_0 in P. lra. }
  assert (D : 0 < IZR (Zpos (Qden q))) by (apply IZR_lt; reflexivity).
  set (v := IZR (Qnum q) * / IZR (Z.pos (Qden q))) in *. destruct r; simpl.
  - rewrite Z.eqb_eq. split; intro H; [unfold v; rewrite H; ring|]. apply eq_IZR. rewrite S, H. ring.
  - rewrite Z.ltb_lt. split; intro H; [apply IZR_lt in H|apply lt_IZR]; nra.
  - rewrite Z.leb_le. split; intro H; [apply IZR_le in H|apply le_IZR]; nra.
Qed.

Section Sound.
Variable z : nat -> R.
Notation val := (affine_value z).

Lemma fixed_value q : val (fixed q) = Q2R q.
Proof. unfold Linear.value; simpl. ring. Qed.

Lemma add_value l m : val (add l m) = val l + val m.
Proof.
  unfold Linear.value, add; simpl. rewrite sum_real.
  enough (H : forall l m y, Linear.total y (add_lists l m) = Linear.total y l + Linear.total y m) by (rewrite H; ring).
  clear. induction l as [|a l IH]; intros [|b m] y; simpl; try ring. rewrite IH, sum_real. ring.
Qed.
Lemma times_value a l : val (times a l) = Q2R a * val l.
Proof.
  unfold Linear.value, times; simpl. rewrite product_real.
  enough (H : forall l y, Linear.total y (map (product a) l) = Q2R a * Linear.total y l) by (rewrite H; ring).
  clear. induction l as [|b l IH]; intro y; simpl; [ring|]. rewrite IH, product_real. ring.
Qed.
Lemma opposed_value l : val (opposed l) = - val l.
Proof.
  unfold Linear.value, opposed; simpl. rewrite Q2R_opp.
  enough (H : forall l y, Linear.total y (map Qopp l) = - Linear.total y l) by (rewrite H; ring).
  clear. induction l as [|b l IH]; intro y; simpl; [ring|]. rewrite IH, Q2R_opp. ring.
Qed.
Lemma constant_of_value l q : constant_of l = Some q -> val l = Q2R q.
Proof.
  unfold constant_of. destruct (forallb _ _) eqn:F; [|discriminate]. intro E; inversion E; subst. unfold Linear.value.
  enough (H : forall l y, forallb is_zero l = true -> Linear.total y l = 0) by (rewrite H; [ring|exact F]).
  clear. induction l as [|b l IH]; intros y H; simpl in *; [reflexivity|]. apply andb_true_iff in H. destruct H as [A B].
  rewrite (IH _ B). apply numerator_zero in A. rewrite A. ring.
Qed.

(** An answer is true of a number. *)
Definition means (a : answer) (o : option R) : Prop :=
  match a with Unclear => True | Undefined => o = None | Affine l => o = Some (val l) end.

Lemma one_means f g a o : (forall l, means (f l) (g (val l))) -> means a o -> means (one f a) (let* x := o in g x).
Proof. intros F A. destruct a; simpl in *; subst; auto. Qed.
Lemma two_means f g a b o p : (forall l m, means (f l m) (g (val l) (val m))) -> means a o -> means b p ->
  means (two f a b) (let* x := o in let* y := p in g x y).
Proof. intros F A B. destruct a, b; simpl in *; subst; auto; now destruct o. Qed.
Lemma of_constant_means f o l : (forall q, val l = Q2R q -> means (f q) o) -> means (of_constant f l) o.
Proof. intro F. unfold of_constant. destruct (constant_of l) as [q|] eqn:E; [|exact I]. apply F, constant_of_value, E. Qed.

Section Names.
Variable names : scope.
Variable meant : meanings.
Hypothesis agree : forall name, means (names name) (meant name).

Lemma absolute_real q : Q2R (Qmake (Z.abs (Qnum q)) (Qden q)) = Rabs (Q2R q).
Proof.
  unfold Q2R; simpl. rewrite Rabs_mult, abs_IZR, (Rabs_right (/ _)); [reflexivity|].
  assert (P := denominator_positive q). lra.
Qed.
Lemma sign_real q : IZR (Z.sgn (Qnum q)) = sign_of (Q2R q).
Proof.
  unfold sign_of. assert (A := meets_real Linear.Positive q). assert (B := meets_real Linear.NonNegative q). simpl in A, B.
  rewrite Z.ltb_lt in A. rewrite Z.leb_le in B.
  destruct (Rlt_dec 0 (Q2R q)) as [P|P]; [|destruct (Rlt_dec (Q2R q) 0) as [N|N]].
  - rewrite Z.sgn_pos; [reflexivity|]. apply A, P.
  - rewrite Z.sgn_neg; [reflexivity|]. apply Z.nle_gt. intro L. apply B in L. lra.
  - replace (Qnum q) with 0%Z; [reflexivity|]. symmetry. apply Z.eqb_eq. apply numerator_zero. lra.
Qed.
Lemma least_real a b : Q2R (if Qle_bool a b then a else b) = Rmin (Q2R a) (Q2R b)
                       /\ Q2R (if Qle_bool a b then b else a) = Rmax (Q2R a) (Q2R b).
Proof.
  destruct (Qle_bool a b) eqn:E.
  - apply Qle_bool_iff, Qle_Rle in E. now rewrite Rmin_left, Rmax_right.
  - assert (L : Q2R b <= Q2R a).
    { apply Rnot_lt_le. intro L. apply not_true_iff_false in E. apply E, Qle_bool_iff, Rle_Qle. lra. }
    now rewrite Rmin_right, Rmax_left.
Qed.

Lemma answer_means e : means (answer_of names e) (value meant e).
Proof.
  induction e as [n|name|a IH|a IHa b IHb|a IHa b IHb|a IHa b IHb|a IHa b IHb|a IH k|a IH|a IH|a IHa b IHb|a IHa b IHb];
    cbn [answer_of value].
  - simpl. now rewrite fixed_value, real_integer.
  - apply agree.
  - apply (one_means _ (fun x => Some (- x))); [|exact IH]. intro l. simpl. now rewrite opposed_value.
  - apply (two_means _ (fun x y => Some (x + y))); [|exact IHa|exact IHb]. intros l m. simpl. now rewrite add_value.
  - apply (two_means _ (fun x y => Some (x - y))); [|exact IHa|exact IHb]. intros l m. simpl. now rewrite add_value, opposed_value.
  - apply (two_means _ (fun x y => Some (x * y))); [|exact IHa|exact IHb]. intros l m.
    destruct (constant_of l) as [q|] eqn:E.
    + simpl. now rewrite times_value, (constant_of_value _ _ E).
    + apply of_constant_means. intros q V. simpl. now rewrite times_value, V, Rmult_comm.
  - apply (two_means _ (fun x y => if Req_EM_T y 0 then None else Some (x / y))); [|exact IHa|exact IHb]. intros l m.
    apply of_constant_means. intros q V. rewrite V. destruct (is_zero q) eqn:Z.
    + apply numerator_zero in Z. rewrite Z. simpl. destruct (Req_EM_T 0 0); congruence.
    + simpl. destruct (Req_EM_T (Q2R q) 0) as [N|N]; [now apply not_zero in Z|].
      rewrite times_value, inverse_real by exact Z. f_equal. field. exact N.
  - destruct k as [|n|n].
    + apply (one_means _ (fun x => Some (x ^ 0))); [|exact IH]. intro l. simpl. f_equal. unfold Linear.value, Q2R; simpl. field.
    + apply (one_means _ (fun x => Some (x ^ Pos.to_nat n))); [|exact IH]. intro l.
      destruct n; [|
        |simpl; now rewrite Rmult_1_r]; apply of_constant_means; intros q V; unfold number, means; now rewrite fixed_value, power_real, V.
    + apply (one_means _ (fun x => if Req_EM_T x 0 then None else Some (/ x ^ Pos.to_nat n))); [|exact IH].
      intro l. apply of_constant_means. intros q V. rewrite V. destruct (is_zero q) eqn:Z.
      * apply numerator_zero in Z. rewrite Z. simpl. destruct (Req_EM_T 0 0); congruence.
      * unfold number, means. destruct (Req_EM_T (Q2R q) 0) as [N|N]; [now apply not_zero in Z|].
        rewrite fixed_value, inverse_real, power_real; [reflexivity|].
        destruct (is_zero (power q (Pos.to_nat n))) eqn:F; [|reflexivity]. apply numerator_zero in F. rewrite power_real in F.
        now apply pow_nonzero in F.
  - apply (one_means _ (fun x => Some (Rabs x))); [|exact IH]. intro l. apply of_constant_means. intros q V. simpl.
    now rewrite fixed_value, absolute_real, V.
  - apply (one_means _ (fun x => Some (sign_of x))); [|exact IH]. intro l. apply of_constant_means. intros q V. simpl.
    now rewrite fixed_value, real_integer, sign_real, V.
  - apply (two_means _ (fun x y => Some (Rmin x y))); [|exact IHa|exact IHb]. intros l m. apply of_constant_means. intros q V.
    apply of_constant_means. intros p W. unfold number, means. rewrite fixed_value, V, W. f_equal. symmetry. apply least_real.
  - apply (two_means _ (fun x y => Some (Rmax x y))); [|exact IHa|exact IHb]. intros l m. apply of_constant_means. intros q V.
    apply of_constant_means. intros p W. unfold number, means. rewrite fixed_value, V, W. f_equal. symmetry. apply least_real.
Qed.
End Names.
End Sound.
