(** Linear equations and inequalities with rational coefficients, over the real numbers: a decision procedure that
    computes. Equations are solved for an unknown and substituted; inequalities are combined in pairs
    (Fourier, Motzkin). To know what is proved, read the section [Meaning] and the theorems at the end: [feasible_iff],
    [solution_sound], [determined_sound], [determined_feasible], [determined_complete]. *)
From Coq Require Import List Bool Arith ZArith QArith Qreals Reals Lra Lia Permutation.
Import ListNotations.

(** A form is zero, is positive, is not negative. *)
Inductive relation := Zero | Positive | NonNegative.

(** The coefficients of unknown 0, 1, 2, ...; those that are missing are 0. *)
Record linear := Linear { coefficients : list Q; constant : Q }.

Section Meaning.
Local Open Scope R_scope.

Definition meets (r : relation) (v : R) : Prop :=
  match r with Zero => v = 0 | Positive => v > 0 | NonNegative => v >= 0 end.

Fixpoint total (x : nat -> R) (l : list Q) : R :=
  match l with [] => 0 | a :: l => Q2R a * x 0%nat + total (fun i => x (S i)) l end.
Definition value (x : nat -> R) (l : linear) : R := Q2R (constant l) + total x (coefficients l).
Definition holds (x : nat -> R) (c : relation * linear) : Prop := meets (fst c) (value x (snd c)).
End Meaning.

Definition fit (unknowns : nat) (l : linear) : Prop := (length (coefficients l) <= unknowns)%nat.

(** The computation: rows have integer coefficients. *)
Local Open Scope Z_scope.

Record row := Row { factors : list Z; offset : Z }.
Definition constraint := (relation * row)%type.
Definition factor (k : nat) (c : constraint) : Z := nth k (factors (snd c)) 0.

(** A form, times a positive number. *)
Fixpoint clear (l : list Q) (c : Q) : Z * row :=
  match l with
  | [] => (Zpos (Qden c), Row [] (Qnum c))
  | a :: l =>
      let (d, r) := clear l c in
      let e := Zpos (Qden a) in (e * d, Row (Qnum a * d :: map (Z.mul e) (factors r)) (e * offset r))
  end.
Definition whole (c : relation * linear) : constraint :=
  (fst c, snd (clear (coefficients (snd c)) (constant (snd c)))).

Definition fuel : nat := 64 * 64.
(** Nothing rests on it that this is the greatest common divisor. *)
Fixpoint common (n : nat) (a b : Z) : Z :=
  match n with O => 1 | S n => if b =? 0 then a else common n b (a mod b) end.

(** The quotients, without zeros at the end. *)
Fixpoint quotients (g : Z) (l : list Z) : list Z :=
  match l with
  | [] => []
  | a :: l => match quotients g l with [] => if a =? 0 then [] else [a / g] | m => a / g :: m end
  end.
Definition shrink (r : row) : row :=
  let g := Z.max 1 (Z.abs (fold_left (common fuel) (factors r) (offset r))) in
  if forallb (fun a => a mod g =? 0) (offset r :: factors r) then Row (quotients g (factors r)) (offset r / g) else r.

Fixpoint lead (l : list Z) : Z := match l with [] => 1 | a :: l => if a =? 0 then lead l else Z.abs a end.
(** Whether a l = b m. *)
Fixpoint proportional (a b : Z) (l m : list Z) : bool :=
  match l, m with
  | [], [] => true
  | p :: l, q :: m => (a * p =? b * q) && proportional a b l m
  | _, _ => false
  end.

(** The stronger of two inequalities, if they say the same but for the constant. *)
Definition stronger (c d : constraint) : option constraint :=
  match fst c, fst d with
  | Zero, _ | _, Zero => None
  | r, _ =>
      let a := lead (factors (snd d)) in
      let b := lead (factors (snd c)) in
      if proportional a b (factors (snd c)) (factors (snd d))
      then Some match a * offset (snd c) ?= b * offset (snd d) with
                | Lt => c | Gt => d | Eq => match r with Positive => c | _ => d end end
      else None
  end.
Fixpoint insert (c : constraint) (cs : list constraint) : list constraint :=
  match cs with
  | [] => [c]
  | d :: cs => match stronger c d with Some e => e :: cs | None => d :: insert c cs end
  end.

(** Whether a constraint holds if all unknowns are 0. *)
Definition at_zero (c : constraint) : bool :=
  match fst c with Zero => offset (snd c) =? 0 | Positive => 0 <? offset (snd c) | NonNegative => 0 <=? offset (snd c) end.
Definition trivial (c : constraint) : bool := match factors (snd c) with [] => at_zero c | _ => false end.
Definition impossible (c : constraint) : bool := match factors (snd c) with [] => negb (at_zero c) | _ => false end.

Definition add (cs : list constraint) (c : constraint) : list constraint :=
  let c := (fst c, shrink (snd c)) in if trivial c then cs else insert c cs.
(** An equivalent system. *)
Definition tidy (cs : list constraint) : list constraint :=
  let cs := fold_left add cs [] in match find impossible cs with Some c => [c] | None => cs end.

(** a l + b m *)
Fixpoint mix_lists (a b : Z) (l m : list Z) : list Z :=
  match l, m with
  | [], _ => map (Z.mul b) m
  | _, [] => map (Z.mul a) l
  | p :: l, q :: m => a * p + b * q :: mix_lists a b l m
  end.
Definition mix (a b : Z) (r s : row) : row :=
  Row (mix_lists a b (factors r) (factors s)) (a * offset r + b * offset s).

(** An equation to solve for unknown k. *)
Definition pivot (k : nat) (cs : list constraint) : option constraint :=
  find (fun c => match fst c with Zero => negb (factor k c =? 0) | _ => false end) cs.
Definition substitute (k : nat) (e c : constraint) : constraint :=
  let a := factor k e in
  let b := factor k c in
  if b =? 0 then c else (fst c, mix (Z.abs a) (- (Z.sgn a * b)) (snd c) (snd e)).

Definition below (k : nat) (c : constraint) : bool := 0 <? factor k c.
Definition above (k : nat) (c : constraint) : bool := factor k c <? 0.
Definition without (k : nat) (c : constraint) : bool := factor k c =? 0.
Definition stricter (r s : relation) : relation :=
  match r, s with NonNegative, NonNegative => NonNegative | _, _ => Positive end.
(** c bounds unknown k from below, d from above. *)
Definition paired (k : nat) (c d : constraint) : constraint :=
  (stricter (fst c) (fst d), mix (- factor k d) (factor k c) (snd c) (snd d)).

(** What the constraints say about the unknowns other than k. *)
Definition eliminate (k : nat) (cs : list constraint) : list constraint :=
  tidy match pivot k cs with
       | Some e => map (substitute k e) cs
       | None =>
           let ds := filter (above k) cs in
           filter (without k) cs ++ flat_map (fun c => map (paired k c) ds) (filter (below k) cs)
       end.

(** A value for unknown k, given values [x] of the others. *)
Fixpoint valueQ (x : nat -> Q) (l : list Z) : Q :=
  match l with [] => 0 | a :: l => inject_Z a * x 0%nat + valueQ (fun i => x (S i)) l end%Q.
Definition bound (k : nat) (x : nat -> Q) (c : constraint) : Q :=
  Qred (x k - (inject_Z (offset (snd c)) + valueQ x (factors (snd c))) / inject_Z (factor k c)).
Fixpoint highest (l : list Q) : option Q :=
  match l with
  | [] => None
  | a :: l => match highest l with Some b => Some (if Qle_bool a b then b else a) | None => Some a end
  end.
Definition lowest (l : list Q) : option Q := option_map Qopp (highest (map Qopp l)).
Definition choose (k : nat) (cs : list constraint) (x : nat -> Q) : Q :=
  match pivot k cs with
  | Some e => bound k x e
  | None =>
      match highest (map (bound k x) (filter (below k) cs)), lowest (map (bound k x) (filter (above k) cs)) with
      | Some l, Some u => Qred ((l + u) / 2)
      | Some l, None => l + 1
      | None, Some u => u - 1
      | None, None => 0
      end%Q
  end.
Definition update {T} (x : nat -> T) (k : nat) (v : T) : nat -> T := fun i => if Nat.eqb i k then v else x i.

(** How many constraints the elimination of unknown k adds; those with an equation come first. *)
Definition count (test : constraint -> bool) (cs : list constraint) : Z :=
  fold_left (fun n c => if test c then Z.succ n else n) cs 0.
Definition cost (cs : list constraint) (k : nat) : Z :=
  let m := count (below k) cs in
  let n := count (above k) cs in
  match pivot k cs with Some _ => -1 | None => m * n end - m - n.
(** The cheapest unknown, and the others. *)
Fixpoint cheapest (price : nat -> Z) (p : Z) (k : nat) (ks : list nat) : nat * list nat :=
  match ks with
  | [] => (k, [])
  | j :: ks =>
      let q := price j in
      if q <? p then let (i, rest) := cheapest price q j ks in (i, k :: rest)
      else let (i, rest) := cheapest price p k ks in (i, j :: rest)
  end.

(** Eliminates n unknowns [ks]: what is left, and values of [ks], given values [x] of the others. *)
Fixpoint reduce (n : nat) (ks : list nat) (cs : list constraint) : list constraint * ((nat -> Q) -> nat -> Q) :=
  match n, ks with
  | S n, k :: ks =>
      let (k, ks) := cheapest (cost cs) (cost cs k) k ks in
      let (left, extend) := reduce n ks (eliminate k cs) in
      (left, fun x => let y := extend x in update y k (choose k cs y))
  | _, _ => (cs, fun x => x)
  end.
Definition reduced (n : nat) (cs : list (relation * linear)) := reduce n (seq 0 n) (tidy (map whole cs)).

Definition origin : nat -> Q := fun _ => 0%Q.
Definition feasible (unknowns : nat) (cs : list (relation * linear)) : bool :=
  forallb at_zero (fst (reduced unknowns cs)).
(** A solution in rational numbers, if there is one. *)
Definition solution (unknowns : nat) (cs : list (relation * linear)) : nat -> Q := snd (reduced unknowns cs) origin.

(** l plus_new a times unknown n. *)
Definition plus_new (n : nat) (l : linear) (a : Q) : linear :=
  Linear (coefficients l ++ repeat 0%Q (n - length (coefficients l)) ++ [a]) (constant l).
(** A new unknown is l; the others are eliminated; q is a value that it may have; it must be neither more nor less. *)
Definition determined (unknowns : nat) (cs : list (relation * linear)) (l : linear) : option Q :=
  let n := unknowns in
  let left := fst (reduced n ((Zero, plus_new n l (-1)) :: cs)) in
  let possible cs := forallb at_zero (eliminate n cs) in
  let q := choose n left origin in
  if possible left
     && negb (possible (whole (Positive, plus_new n (Linear [] (-q)) 1) :: left))
     && negb (possible (whole (Positive, plus_new n (Linear [] q) (-1)) :: left))
  then Some q else None.

(** The proofs *)
Local Open Scope R_scope.
Opaque fuel.

Fixpoint sum (x : nat -> R) (l : list Z) : R :=
  match l with [] => 0 | a :: l => IZR a * x 0%nat + sum (fun i => x (S i)) l end.
Definition value_row (x : nat -> R) (r : row) : R := IZR (offset r) + sum x (factors r).
Definition true_at (x : nat -> R) (c : constraint) : Prop := meets (fst c) (value_row x (snd c)).
Definition real (x : nat -> Q) : nat -> R := fun i => Q2R (x i).

Lemma meets_times r s v : 0 < s -> meets r (s * v) <-> meets r v.
Proof. intro S. destruct r; simpl; split; intro; nra. Qed.

Lemma sum_map x a l : sum x (map (Z.mul a) l) = IZR a * sum x l.
Proof. revert x; induction l as [|b l IH]; intro x; simpl; [ring|]. rewrite IH, mult_IZR. ring. Qed.

Lemma sum_same x y l : (forall i, x i = y i) -> sum x l = sum y l.
Proof.
  revert x y; induction l as [|a l IH]; intros x y E; simpl; [reflexivity|].
  rewrite E, (IH _ (fun i => y (S i))); auto.
Qed.

Lemma true_same x y c : (forall i, x i = y i) -> true_at x c -> true_at y c.
Proof. intros E T. unfold true_at, value_row. rewrite <- (sum_same x y); auto. Qed.

Lemma update_same {T} (x : nat -> T) k v : update x k v k = v.
Proof. unfold update. rewrite Nat.eqb_refl. reflexivity. Qed.

Lemma Q2R_integer a : Q2R (a # 1) = IZR a.
Proof. unfold Q2R; simpl. field. Qed.

Lemma sum_update x k v l : sum (update x k v) l = sum x l + IZR (nth k l 0%Z) * (v - x k).
Proof.
  revert x k; induction l as [|a l IH]; intros x k; [destruct k; simpl; ring|]. destruct k as [|k].
  - simpl. rewrite (sum_same _ (fun i => x (S i))) by reflexivity. unfold update; simpl. ring.
  - simpl. change (fun i => update x (S k) v (S i)) with (update (fun i => x (S i)) k v).
    rewrite IH. unfold update; simpl. ring.
Qed.

Lemma value_update x k v c :
  value_row (update x k v) (snd c) = value_row x (snd c) + IZR (factor k c) * (v - x k).
Proof. unfold value_row, factor. rewrite sum_update. ring. Qed.

Lemma mix_value x a b r s : value_row x (mix a b r s) = IZR a * value_row x r + IZR b * value_row x s.
Proof.
  assert (forall l m y, sum y (mix_lists a b l m) = IZR a * sum y l + IZR b * sum y m) as H.
  { induction l as [|p l IH]; intros m y; [destruct m; simpl; rewrite ?sum_map, ?mult_IZR; ring|].
    destruct m as [|q m]; simpl; rewrite ?sum_map, ?IH, ?plus_IZR, ?mult_IZR; ring. }
  unfold value_row; simpl. rewrite H, plus_IZR, !mult_IZR. ring.
Qed.

Lemma whole_true x c : true_at x (whole c) <-> holds x c.
Proof.
  destruct c as [r [l c]]. unfold true_at, whole, holds, value; simpl.
  assert (forall y, let (d, r) := clear l c in 0 < IZR d /\ value_row y r = IZR d * (Q2R c + total y l)) as H.
  { unfold value_row. induction l as [|a l IH]; intro y; cbn -[Z.mul].
    - assert (0 < IZR (Zpos (Qden c))) by (apply IZR_lt; reflexivity). split; [auto|]. unfold Q2R. field. lra.
    - destruct (clear l c) as [d s]. cbn -[Z.mul]. destruct (IH (fun i => y (S i))) as [P E].
      assert (0 < IZR (Zpos (Qden a))) by (apply IZR_lt; reflexivity).
      rewrite !mult_IZR, sum_map. split; [apply Rmult_lt_0_compat; auto|].
      replace (sum (fun i => y (S i)) (factors s))
        with (IZR d * (Q2R c + total (fun i => y (S i)) l) - IZR (offset s)) by lra.
      change (Q2R a) with (IZR (Qnum a) * / IZR (Zpos (Qden a))). field. lra. }
  specialize (H x). destruct (clear l c) as [d s]; simpl. destruct H as [P E]. rewrite E. apply meets_times, P.
Qed.

Lemma shrink_true x r s : true_at x (r, shrink s) <-> true_at x (r, s).
Proof.
  unfold true_at, shrink; cbn [fst snd]. cbv zeta.
  set (g := Z.max 1 _). assert (0 < IZR g) as P by (apply IZR_lt, Z.max_lt_iff; left; reflexivity). clearbody g.
  destruct (forallb _ _) eqn:E; [|reflexivity]. simpl in E. apply andb_prop in E. destruct E as [F E].
  assert (forall a, (a mod g =? 0)%Z = true -> IZR a = IZR g * IZR (a / g)) as D.
  { intros a H. rewrite <- mult_IZR. f_equal. apply Z.eqb_eq in H. apply Z.div_exact; [|exact H].
    intro G. subst g. lra. }
  rewrite <- (meets_times r (IZR g)) by exact P.
  enough (forall y, sum y (factors s) = IZR g * sum y (quotients g (factors s))) as Q.
  { unfold value_row at 2. rewrite (D _ F), Q. unfold value_row; simpl. rewrite <- Rmult_plus_distr_l. reflexivity. }
  induction (factors s) as [|a l IH]; intro y; simpl; [ring|]. simpl in E. apply andb_prop in E.
  rewrite IH, (D a) by tauto. destruct (quotients g l); [|simpl; ring].
  destruct (Z.eqb_spec a 0) as [A|A]; simpl; [|ring]. subst a. rewrite Z.div_0_l; [ring|]. intro; subst g; lra.
Qed.

Lemma lead_positive l : 0 < IZR (lead l).
Proof. induction l as [|a l IH]; simpl; [lra|]. destruct (Z.eqb_spec a 0); [auto|]. apply IZR_lt. lia. Qed.

Lemma proportional_sum a b l : forall m x, proportional a b l m = true -> IZR a * sum x l = IZR b * sum x m.
Proof.
  induction l as [|p l IH]; intros [|q m] x; simpl; try discriminate; [intros; ring|].
  intro H. apply andb_prop in H. destruct H as [H F]. apply Z.eqb_eq, (f_equal IZR) in H.
  rewrite !mult_IZR in H. rewrite Rmult_plus_distr_l, <- Rmult_assoc, H, (IH m) by exact F. ring.
Qed.

Lemma stronger_true x c d e : stronger c d = Some e -> true_at x e <-> true_at x c /\ true_at x d.
Proof.
  destruct c as [r [l p]], d as [s [m q]]. unfold stronger, true_at, value_row; simpl.
  pose proof (lead_positive l). pose proof (lead_positive m).
  destruct (proportional _ _ _ _) eqn:E; [|destruct r, s; discriminate].
  apply proportional_sum with (x := x) in E.
  destruct (Z.compare_spec (lead m * p) (lead l * q)) as [C|C|C];
    try apply (f_equal IZR) in C; try apply IZR_lt in C; rewrite !mult_IZR in C;
    destruct r, s; intro H1; try discriminate; injection H1 as <-; simpl; split; intros; try split; try tauto; nra.
Qed.

Lemma insert_true x c cs : Forall (true_at x) (insert c cs) <-> true_at x c /\ Forall (true_at x) cs.
Proof.
  induction cs as [|d cs IH]; simpl; [rewrite Forall_cons_iff; tauto|]. destruct (stronger c d) eqn:E.
  - rewrite !Forall_cons_iff, (stronger_true _ _ _ _ E). tauto.
  - rewrite !Forall_cons_iff, IH. tauto.
Qed.

Lemma at_zero_true x c : (forall i, x i = 0) \/ factors (snd c) = [] -> at_zero c = true <-> true_at x c.
Proof.
  intro Z. unfold at_zero, true_at, value_row.
  assert (sum x (factors (snd c)) = 0) as ->.
  { destruct Z as [Z| ->]; [|reflexivity]. revert x Z; induction (factors (snd c)) as [|a l IH]; intros x Z; simpl; [ring|].
    rewrite Z, IH; auto; ring. }
  rewrite Rplus_0_r. destruct (fst c); simpl.
  - rewrite Z.eqb_eq. split; [intros ->; reflexivity|apply eq_IZR].
  - rewrite Z.ltb_lt. split; [apply IZR_lt|apply lt_IZR].
  - rewrite Z.leb_le. split; intro H; [apply Rle_ge, IZR_le, H|apply le_IZR, Rge_le, H].
Qed.

Lemma tidy_true x cs : Forall (true_at x) (tidy cs) <-> Forall (true_at x) cs.
Proof.
  assert (forall ds, Forall (true_at x) (fold_left add cs ds) <-> Forall (true_at x) cs /\ Forall (true_at x) ds) as H.
  { induction cs as [|[r s] cs IH]; intro ds; simpl; [intuition|]. rewrite IH, Forall_cons_iff.
    rewrite <- shrink_true. unfold add; simpl. destruct (trivial _) eqn:E; [|rewrite insert_true; tauto].
    unfold trivial in E. destruct (factors _) eqn:F; [|discriminate]. apply at_zero_true with (x := x) in E; tauto. }
  unfold tidy. transitivity (Forall (true_at x) (fold_left add cs [])); [|rewrite H; intuition].
  destruct (find _ _) as [c|] eqn:E; [|tauto]. apply find_some in E. destruct E as [I E].
  assert (~ true_at x c) as N.
  { unfold impossible in E. destruct (factors _) eqn:F; [|discriminate]. apply negb_true_iff in E.
    rewrite <- at_zero_true by auto. congruence. }
  rewrite !Forall_forall. split; intro A; exfalso; apply N, A; simpl; auto.
Qed.

Lemma pivot_some k cs e : pivot k cs = Some e -> In e cs /\ fst e = Zero /\ IZR (factor k e) <> 0.
Proof.
  intro H. apply find_some in H. destruct H as [I H]. destruct (fst e); try discriminate.
  apply negb_true_iff, Z.eqb_neq in H. repeat split; auto. apply not_0_IZR, H.
Qed.

Lemma pivot_none k cs c : pivot k cs = None -> In c cs -> IZR (factor k c) <> 0 -> fst c <> Zero.
Proof.
  intros H I F E. apply find_none with (x := c) in H; [|exact I]. rewrite E in H.
  apply negb_false_iff, Z.eqb_eq in H. rewrite H in F. auto.
Qed.

Lemma substitute_value k e c x v :
  IZR (factor k e) <> 0 -> exists s, 0 < s /\ exists t,
  value_row x (snd (substitute k e c)) = s * value_row (update x k v) (snd c) + t * value_row (update x k v) (snd e).
Proof.
  intro N. unfold substitute. destruct (Z.eqb_spec (factor k c) 0) as [E|E].
  - exists 1. split; [lra|]. exists 0. rewrite !value_update, E. ring.
  - exists (IZR (Z.abs (factor k e))). split; [rewrite abs_IZR; apply Rabs_pos_lt, N|]. exists (- IZR (Z.sgn (factor k e) * factor k c)).
    simpl. rewrite mix_value, !value_update, opp_IZR, !mult_IZR.
    replace (Z.abs (factor k e)) with (Z.sgn (factor k e) * factor k e)%Z by lia. rewrite mult_IZR. ring.
Qed.

Lemma substitute_true k e c x v :
  IZR (factor k e) <> 0 -> value_row (update x k v) (snd e) = 0 ->
  true_at x (substitute k e c) <-> true_at (update x k v) c.
Proof.
  intros N Z. unfold true_at. destruct (substitute_value k e c x v N) as [s [P [t ->]]].
  rewrite Z, Rmult_0_r, Rplus_0_r, meets_times by exact P. unfold substitute. destruct (_ =? _)%Z; tauto.
Qed.

Lemma pair_value k c d x v :
  value_row x (snd (paired k c d)) = - IZR (factor k d) * value_row (update x k v) (snd c)
                                   + IZR (factor k c) * value_row (update x k v) (snd d).
Proof. simpl. rewrite mix_value, !value_update, opp_IZR. ring. Qed.

Lemma filters k c cs :
  (In c (filter (below k) cs) <-> In c cs /\ 0 < IZR (factor k c)) /\
  (In c (filter (above k) cs) <-> In c cs /\ IZR (factor k c) < 0) /\
  (In c (filter (without k) cs) <-> In c cs /\ IZR (factor k c) = 0).
Proof.
  rewrite !filter_In. unfold below, above, without. rewrite !Z.ltb_lt, Z.eqb_eq.
  repeat split; intros; intuition auto using IZR_lt, lt_IZR, eq_IZR. congruence.
Qed.

Lemma eliminate_sound k cs x v : Forall (true_at (update x k v)) cs -> Forall (true_at x) (eliminate k cs).
Proof.
  unfold eliminate. rewrite tidy_true, !Forall_forall. intro H. destruct (pivot k cs) as [e|] eqn:E.
  - apply pivot_some in E. destruct E as [I [Z N]]. intros c J. apply in_map_iff in J. destruct J as [d [<- J]].
    specialize (H e I) as G. unfold true_at in G. rewrite Z in G.
    apply substitute_true with (v := v); auto.
  - intros c J. apply in_app_iff in J. rewrite in_flat_map in J. destruct J as [J|[d [L J]]].
    + apply filters in J. destruct J as [J Z]. specialize (H c J). unfold true_at in *.
      rewrite value_update, Z, Rmult_0_l, Rplus_0_r in H. exact H.
    + apply in_map_iff in J. destruct J as [u [<- U]]. apply filters in L, U. destruct L as [J L], U as [K U].
      pose proof (H d J) as D. pose proof (H u K) as F. unfold true_at in *. rewrite (pair_value _ _ _ _ v).
      set (p := value_row _ (snd d)) in *. set (q := value_row _ (snd u)) in *. clearbody p q.
      assert (fst d <> Zero) by (apply (pivot_none k cs); auto; lra).
      assert (fst u <> Zero) by (apply (pivot_none k cs); auto; lra).
      simpl. destruct (fst d), (fst u); simpl in *; try congruence; nra.
Qed.

Lemma bound_value k x c v :
  IZR (factor k c) <> 0 ->
  value_row (update (real x) k v) (snd c) = IZR (factor k c) * (v - Q2R (bound k x c)).
Proof.
  assert (forall a, Q2R (inject_Z a) = IZR a) as J by exact Q2R_integer.
  intro N. rewrite value_update. unfold bound. rewrite (Qeq_eqR _ _ (Qred_correct _)).
  rewrite Q2R_minus, Q2R_div, Q2R_plus, !J by (intro F; apply Qeq_eqR in F; rewrite J in F; unfold Q2R in F; simpl in F; lra).
  replace (Q2R (valueQ x (factors (snd c)))) with (sum (real x) (factors (snd c))).
  - unfold value_row, real. field. exact N.
  - clear N. revert x; induction (factors (snd c)) as [|a l IH]; intro x; simpl; [unfold Q2R; simpl; field|].
    rewrite Q2R_plus, Q2R_mult, J, <- IH. reflexivity.
Qed.

Lemma highest_spec {T} (f : T -> Q) l :
  match highest (map f l) with
  | Some m => exists a, In a l /\ Q2R (f a) = Q2R m /\ forall b, In b l -> Q2R (f b) <= Q2R m
  | None => l = []
  end.
Proof.
  induction l as [|a l IH]; simpl; [reflexivity|]. destruct (highest _) as [m|].
  - destruct IH as [b [I [E L]]]. destruct (Qle_bool (f a) m) eqn:C.
    + apply Qle_bool_iff, Qle_Rle in C. exists b. repeat split; auto. intros c [<-|D]; auto.
    + exists a. repeat split; auto. intros c [<-|D]; [lra|]. specialize (L c D). apply Rnot_lt_le. intro F.
      apply not_true_iff_false in C. apply C, Qle_bool_iff, Rle_Qle. lra.
  - subst l. exists a. repeat split; auto. intros b [<-|[]]. lra.
Qed.

Lemma lowest_spec {T} (f : T -> Q) l :
  match lowest (map f l) with
  | Some m => exists a, In a l /\ Q2R (f a) = Q2R m /\ forall b, In b l -> Q2R m <= Q2R (f b)
  | None => l = []
  end.
Proof.
  unfold lowest. rewrite map_map. pose proof (highest_spec (fun a => - f a)%Q l) as H. destruct (highest _) as [m|]; [|exact H].
  destruct H as [a [I [E L]]]. exists a. simpl. rewrite Q2R_opp in *. repeat split; [exact I|lra|].
  intros b B. specialize (L b B). rewrite Q2R_opp in L. lra.
Qed.

(** The value chosen is halfway between numbers that keep all bounds. *)
Lemma choose_between k cs x :
  pivot k cs = None -> Forall (true_at (real x)) (eliminate k cs) ->
  exists l u, Q2R (choose k cs x) = (l + u) / 2 /\
    (forall c, In c (filter (below k) cs) -> Q2R (bound k x c) <= l /\ meets (fst c) (u - Q2R (bound k x c))) /\
    (forall c, In c (filter (above k) cs) -> u <= Q2R (bound k x c) /\ meets (fst c) (Q2R (bound k x c) - l)).
Proof.
  intros E H. unfold eliminate in H. unfold choose. rewrite E in *. rewrite tidy_true, Forall_forall in H.
  assert (forall c, In c (filter (below k) cs) \/ In c (filter (above k) cs) -> fst c <> Zero) as N.
  { intros c I. rewrite !(proj1 (filters _ _ _)), (proj1 (proj2 (filters _ _ _))) in I.
    apply (pivot_none k cs); [auto|tauto|lra]. }
  assert (forall c d, In c (filter (below k) cs) -> In d (filter (above k) cs) ->
    meets (stricter (fst c) (fst d)) (Q2R (bound k x d) - Q2R (bound k x c))) as P.
  { intros c d C D. assert (true_at (real x) (paired k c d)) as T.
    { apply H, in_app_iff. right. apply in_flat_map. exists c. auto using in_map. }
    unfold true_at in T. apply filters in C, D. rewrite (pair_value _ _ _ _ 0), !bound_value in T by lra.
    apply (meets_times _ (IZR (factor k c) * - IZR (factor k d))); [nra|].
    match goal with |- meets _ ?w => match type of T with meets _ ?v => replace w with v by ring; exact T end end. }
  clear H E. pose proof (highest_spec (bound k x) (filter (below k) cs)) as L.
  pose proof (lowest_spec (bound k x) (filter (above k) cs)) as U.
  pose proof (Q2R_integer 1) as One. pose proof (Q2R_integer 2) as Two.
  destruct (highest _) as [l|]; [destruct L as [b [B [V L]]]|rewrite L in *];
    (destruct (lowest _) as [u|]; [destruct U as [d [D [W U]]]|rewrite U in *]).
  - exists (Q2R l), (Q2R u). split.
    { rewrite (Qeq_eqR _ _ (Qred_correct _)), Q2R_div, Q2R_plus by discriminate. rewrite Two. reflexivity. }
    split; intros c C.
    + specialize (L c C); specialize (P c d C D); specialize (N c (or_introl C)).
      destruct (fst c), (fst d); simpl in *; split; auto; try congruence; lra.
    + specialize (U c C); specialize (P b c B C); specialize (N c (or_intror C)).
      destruct (fst b), (fst c); simpl in *; split; auto; try congruence; lra.
  - exists (Q2R l), (Q2R l + 2). rewrite Q2R_plus. split; [lra|].
    split; [|intros c []]. intros c C. specialize (L c C); specialize (N c (or_introl C)).
    destruct (fst c); simpl; split; auto; try congruence; lra.
  - exists (Q2R u - 2), (Q2R u). rewrite Q2R_minus. split; [lra|].
    split; [intros c []|]. intros c C. specialize (U c C); specialize (N c (or_intror C)).
    destruct (fst c); simpl; split; auto; try congruence; lra.
  - exists 0, 0. split; [rewrite (Q2R_integer 0); lra|]. split; intros c [].
Qed.

Lemma eliminate_complete k cs x :
  Forall (true_at (real x)) (eliminate k cs) -> Forall (true_at (update (real x) k (Q2R (choose k cs x)))) cs.
Proof.
  intro H. destruct (pivot k cs) as [e|] eqn:E.
  - unfold eliminate, choose in *. rewrite E in *. rewrite tidy_true, Forall_map, Forall_forall in H.
    apply pivot_some in E. destruct E as [_ [_ N]]. apply Forall_forall. intros c I.
    apply (substitute_true k e); [exact N| |apply H, I]. rewrite bound_value by exact N. ring.
  - destruct (choose_between k cs x E H) as [l [u [-> [L U]]]]. apply Forall_forall. intros c I. unfold true_at.
    destruct (Rtotal_order (IZR (factor k c)) 0) as [S|[S|S]].
    + destruct (U c) as [V W]; [apply filters; auto|]. rewrite bound_value by lra.
      assert (fst c <> Zero) by (apply (pivot_none k cs); auto; lra).
      destruct (fst c); simpl in *; try congruence; nra.
    + unfold eliminate in H. rewrite E, tidy_true, Forall_app in H. destruct H as [H _]. rewrite Forall_forall in H.
      rewrite value_update, S, Rmult_0_l, Rplus_0_r. apply H, filters. auto.
    + destruct (L c) as [V W]; [apply filters; auto|]. rewrite bound_value by lra.
      assert (fst c <> Zero) by (apply (pivot_none k cs); auto; lra).
      destruct (fst c); simpl in *; try congruence; nra.
Qed.

Lemma cheapest_permutes price ks : forall p k,
  let (i, rest) := cheapest price p k ks in Permutation (i :: rest) (k :: ks).
Proof.
  induction ks as [|j ks IH]; intros p k; simpl; [auto|]. destruct (price j <? p)%Z.
  - specialize (IH (price j) j). destruct (cheapest _ _ _ _). rewrite perm_swap. auto.
  - specialize (IH p k). destruct (cheapest _ _ _ _). rewrite perm_swap, IH. apply perm_swap.
Qed.

Lemma reduce_sound n : forall ks cs x y, length ks = n ->
  (forall i, ~ In i ks -> x i = y i) -> Forall (true_at y) cs -> Forall (true_at x) (fst (reduce n ks cs)).
Proof.
  induction n as [|n IH]; intros [|k ks] cs x y L E T; try discriminate L.
  - eapply Forall_impl; [|exact T]. intro c. apply true_same. intro. symmetry. auto.
  - simpl. pose proof (cheapest_permutes (cost cs) ks (cost cs k) k) as P. destruct (cheapest _ _ _ _) as [i rest].
    specialize (IH rest (eliminate i cs) x (update y i (x i))). destruct (reduce _ _ _) as [left extend]. apply IH.
    + apply Permutation_length in P. simpl in *. lia.
    + intros j J. unfold update. destruct (Nat.eqb_spec j i) as [->|D]; [reflexivity|]. apply E. intro F.
      apply (Permutation_in j (Permutation_sym P)) in F. destruct F as [F|F]; auto.
    + apply (eliminate_sound i cs _ (y i)). eapply Forall_impl; [|exact T]. intro c. apply true_same.
      intro j. unfold update. destruct (Nat.eqb_spec j i) as [->|]; reflexivity.
Qed.

Lemma reduce_complete n : forall ks cs x,
  let (left, extend) := reduce n ks cs in
  Forall (true_at (real x)) left ->
  (forall i, ~ In i ks -> extend x i = x i) /\ Forall (true_at (real (extend x))) cs.
Proof.
  induction n as [|n IH]; intros ks cs x; [simpl; auto|]. destruct ks as [|k ks]; [simpl; auto|]. simpl.
  pose proof (cheapest_permutes (cost cs) ks (cost cs k) k) as P.
  destruct (cheapest _ _ _ _) as [i rest]. specialize (IH rest (eliminate i cs) x).
  destruct (reduce _ _ _) as [left extend]. intro T. destruct (IH T) as [E F]. split.
  - intros j J. unfold update. destruct (Nat.eqb_spec j i) as [->|D].
    + destruct J. apply (Permutation_in i P). simpl. auto.
    + apply E. intro K. apply J, (Permutation_in j P). simpl. auto.
  - apply eliminate_complete in F. eapply Forall_impl; [|exact F]. intro c. apply true_same.
    intro j. unfold real, update. destruct (Nat.eqb j i); reflexivity.
Qed.

Lemma reduced_sound n cs x y :
  (forall i, (n <= i)%nat -> x i = y i) -> Forall (holds y) cs -> Forall (true_at x) (fst (reduced n cs)).
Proof.
  intros E H. apply reduce_sound with (y := y); [apply seq_length| |].
  - intros i I. apply E. rewrite in_seq in I. lia.
  - rewrite tidy_true, Forall_map. eapply Forall_impl; [|exact H]. intro c. apply whole_true.
Qed.

Lemma reduced_complete n cs x : Forall (true_at (real x)) (fst (reduced n cs)) ->
  (forall i, (n <= i)%nat -> snd (reduced n cs) x i = x i) /\ Forall (holds (real (snd (reduced n cs) x))) cs.
Proof.
  unfold reduced. pose proof (reduce_complete n (seq 0 n) (tidy (map whole cs)) x) as H.
  destruct (reduce _ _ _) as [left extend]. simpl. intro T. destruct (H T) as [E F]. split.
  - intros i I. apply E. rewrite in_seq. lia.
  - rewrite tidy_true, Forall_map in F. eapply Forall_impl; [|exact F]. intro c. apply whole_true.
Qed.

Lemma all_at_zero cs : forallb at_zero cs = true <-> Forall (true_at (real origin)) cs.
Proof.
  rewrite forallb_forall, Forall_forall.
  assert (forall c, at_zero c = true <-> true_at (real origin) c) as H.
  { intro c. apply at_zero_true. left. intro. apply (Q2R_integer 0). }
  split; intros F c I; apply H, F, I.
Qed.

Lemma fit_value n l x y : fit n l -> (forall i, (i < n)%nat -> x i = y i) -> value x l = value y l.
Proof.
  unfold fit, value. intros F E. f_equal. revert n x y F E; induction (coefficients l) as [|a m IH]; intros n x y F E; simpl in *.
  - reflexivity.
  - rewrite E by lia. f_equal. apply (IH (pred n)); [lia|]. intros i I. apply E. lia.
Qed.

Lemma fit_holds n cs x y : Forall (fun c => fit n (snd c)) cs -> (forall i, (i < n)%nat -> x i = y i) ->
  Forall (holds x) cs -> Forall (holds y) cs.
Proof.
  rewrite !Forall_forall. intros F E H c I. specialize (H c I). unfold holds in *.
  rewrite <- (fit_value n _ x y); auto.
Qed.

Lemma plus_value n l a x : fit n l -> value x (plus_new n l a) = value x l + Q2R a * x n.
Proof.
  unfold fit, value, plus_new; simpl. intro F. rewrite Rplus_assoc. f_equal.
  revert n x F; induction (coefficients l) as [|b m IH]; intros n x F; simpl in *.
  - rewrite Nat.sub_0_r. clear F. revert x; induction n as [|n IH]; intro x; simpl; [ring|].
    rewrite (IH (fun i => x (S i))). unfold Q2R; simpl. ring.
  - destruct n as [|n]; [lia|]. simpl. rewrite (IH n (fun i => x (S i))) by lia. ring.
Qed.

Theorem solution_sound unknowns cs : feasible unknowns cs = true -> Forall (holds (real (solution unknowns cs))) cs.
Proof. intro H. apply all_at_zero in H. apply (reduced_complete unknowns cs origin H). Qed.

Theorem feasible_iff unknowns cs : Forall (fun c => fit unknowns (snd c)) cs ->
  feasible unknowns cs = true <-> exists x : nat -> R, Forall (holds x) cs.
Proof.
  intro F. split; [eauto using solution_sound|]. intros [x H]. apply all_at_zero.
  apply reduced_sound with (y := fun i => if (i <? unknowns)%nat then x i else real origin i).
  - intros i I. apply Nat.ltb_ge in I. rewrite I. reflexivity.
  - revert H. apply (fit_holds unknowns); auto. intros i I. apply Nat.ltb_lt in I. rewrite I. reflexivity.
Qed.

(** All unknowns but the new one are 0. *)
Definition point (n : nat) (v : R) : nat -> R := update (real origin) n v.

Lemma left_sound n cs l x :
  Forall (fun c => fit n (snd c)) cs -> fit n l -> Forall (holds x) cs ->
  Forall (true_at (point n (value x l))) (fst (reduced n ((Zero, plus_new n l (-1)) :: cs))).
Proof.
  intros F G H. set (y := fun i => if (i <? n)%nat then x i else point n (value x l) i).
  assert (forall i, (i < n)%nat -> x i = y i) as E by (intros i I; apply Nat.ltb_lt in I; unfold y; rewrite I; reflexivity).
  apply reduced_sound with (y := y).
  - intros i I. apply Nat.ltb_ge in I. unfold y. rewrite I. reflexivity.
  - constructor; [|eapply fit_holds; eauto]. unfold holds; simpl. rewrite plus_value, <- (fit_value n l x y) by auto.
    unfold y. rewrite Nat.ltb_irrefl. unfold point, update. rewrite Nat.eqb_refl. rewrite (Q2R_integer (-1)). lra.
Qed.

Lemma left_complete n cs l v : fit n l ->
  Forall (true_at (point n (Q2R v))) (fst (reduced n ((Zero, plus_new n l (-1)) :: cs))) ->
  exists x, Forall (holds x) cs /\ value x l = Q2R v.
Proof.
  intros G H. destruct (reduced_complete n ((Zero, plus_new n l (-1)) :: cs) (update origin n v)) as [E F].
  - eapply Forall_impl; [|exact H]. intro c. apply true_same. intro i. unfold point, real, update. destruct (Nat.eqb i n); auto.
  - inversion F as [|c ds Z T]; subst. eexists; split; [exact T|]. unfold holds in Z. simpl in Z.
    rewrite plus_value in Z by exact G. unfold real at 2 in Z. rewrite E, update_same, Q2R_integer in Z by lia. lra.
Qed.

Lemma possible_iff n cs :
  forallb at_zero (eliminate n cs) = true <-> Forall (true_at (point n (Q2R (choose n cs origin)))) cs.
Proof. rewrite all_at_zero. split; [apply eliminate_complete|apply eliminate_sound]. Qed.

Lemma new_true n q v :
  (true_at (point n v) (whole (Positive, plus_new n (Linear [] (- q)) 1)) <-> v > Q2R q) /\
  (true_at (point n v) (whole (Positive, plus_new n (Linear [] q) (-1))) <-> v < Q2R q).
Proof.
  assert (forall p, fit n (Linear [] p)) as F by (intro; unfold fit; simpl; lia).
  rewrite !whole_true. unfold holds; simpl. rewrite !plus_value by apply F. unfold value, point, update; simpl.
  rewrite Nat.eqb_refl, Q2R_opp, !Q2R_integer. split; split; intro; lra.
Qed.

Theorem determined_sound unknowns cs l q :
  determined unknowns cs l = Some q -> Forall (fun c => fit unknowns (snd c)) cs -> fit unknowns l ->
  forall x, Forall (holds x) cs -> value x l = Q2R q.
Proof.
  unfold determined. set (n := unknowns). set (left := fst _). set (p := choose n left origin).
  destruct (_ && _) eqn:E; [|discriminate]. intro S; injection S as <-. intros F G x H.
  apply (left_sound n cs l x F G) in H. fold left in H.
  rewrite !andb_true_iff, !negb_true_iff in E. destruct E as [[_ A] B].
  assert (forall c, forallb at_zero (eliminate n (c :: left)) = false -> ~ true_at (point n (value x l)) c) as N.
  { intros c C T. apply not_true_iff_false in C. apply C, all_at_zero, (eliminate_sound n _ _ (value x l)). constructor; auto. }
  destruct (new_true n p (value x l)) as [V W]. apply N in A, B. rewrite V in A. rewrite W in B. lra.
Qed.

Theorem determined_feasible unknowns cs l q : fit unknowns l ->
  determined unknowns cs l = Some q -> exists x, Forall (holds x) cs /\ value x l = Q2R q.
Proof.
  intro G. unfold determined. destruct (_ && _) eqn:E; [|discriminate]. intro S; injection S as <-.
  rewrite !andb_true_iff in E. apply (left_complete unknowns cs l _ G), possible_iff. tauto.
Qed.

Theorem determined_complete unknowns cs l :
  determined unknowns cs l = None -> Forall (fun c => fit unknowns (snd c)) cs -> fit unknowns l ->
  feasible unknowns cs = true ->
  exists x y, Forall (holds x) cs /\ Forall (holds y) cs /\ value x l <> value y l.
Proof.
  intros D F G H. apply feasible_iff in H; [|exact F]. destruct H as [x H]. apply (left_sound _ _ l x F G) in H.
  unfold determined in D. set (n := unknowns) in *. set (left := fst _) in *. set (p := choose n left origin) in *.
  assert (forallb at_zero (eliminate n left) = true) as E.
  { apply all_at_zero, (eliminate_sound n _ _ (value x l)). exact H. }
  rewrite E in D. simpl in D. apply possible_iff in E. destruct (left_complete n cs l p G E) as [y [Y V]].
  assert (forall c, forallb at_zero (eliminate n (c :: left)) = true ->
    exists v z, true_at (point n v) c /\ Forall (holds z) cs /\ value z l = v) as P.
  { intros c C. apply possible_iff in C. inversion C; subst. eexists.
    destruct (left_complete n cs l (choose n (c :: left) origin) G) as [z Z]; eauto. }
  destruct (forallb _ (eliminate n (_ :: left))) eqn:A in D; [clear D|simpl in D;
    destruct (forallb _ (eliminate n (_ :: left))) eqn:B in D; [clear D A; rename B into A|discriminate]];
    destruct (P _ A) as [v [z [T [Z W]]]]; apply new_true in T; exists y, z; repeat split; auto; lra.
Qed.
