(** Sparse linear functions with numbers that compute, and what of linear algebra is needed: m equations in m + 1 unknowns
    have a solution that is not 0. *)
From Coq Require Import Reals NArith List Bool Lra Lia FMapPositive.
From Slipproof.contact Require Import Coulomb Number Fixed.
Import ListNotations.
Local Open Scope R_scope.

(** Sums *)

Lemma sum_ext n f g : (forall i, (i < n)%nat -> f i = g i) -> sum n f = sum n g.
Proof.
  induction n as [|n IH]; intros E; cbn; [reflexivity|]. rewrite IH, E; auto.
Qed.

Lemma sum_zero n f : (forall i, (i < n)%nat -> f i = 0) -> sum n f = 0.
Proof. induction n as [|n IH]; intros E; cbn; [reflexivity|]. rewrite IH, E; auto; lra. Qed.

Lemma sum_plus n f g : sum n (fun i => f i + g i) = sum n f + sum n g.
Proof. induction n as [|n IH]; cbn; [lra|]. rewrite IH; lra. Qed.

Lemma sum_scale n c f : sum n (fun i => c * f i) = c * sum n f.
Proof. induction n as [|n IH]; cbn; [lra|]. rewrite IH; lra. Qed.

Lemma sum_first n f : sum (S n) f = f 0%nat + sum n (fun i => f (S i)).
Proof. induction n as [|n IH]; cbn [sum] in *; [lra|]. rewrite IH. lra. Qed.

Lemma sum_single n i f : (i < n)%nat -> (forall j, (j < n)%nat -> j <> i -> f j = 0) -> sum n f = f i.
Proof.
  induction n as [|n IH]; intros L E; [lia|]. cbn.
  destruct (Nat.eq_dec i n) as [->|D].
  - rewrite sum_zero; [lra|]. intros j J. apply E; lia.
  - rewrite IH by (auto; lia). rewrite (E n); lia || lra.
Qed.

Lemma sum_split a b f : sum (a + b) f = sum a f + sum b (fun i => f (a + i)%nat).
Proof.
  induction b as [|b IH]; [rewrite Nat.add_0_r; cbn; lra|]. rewrite Nat.add_succ_r. cbn [sum]. rewrite IH. lra.
Qed.

Lemma sum_blocks d k f : sum (d * k) f = sum k (fun i => sum d (fun t => f (d * i + t)%nat)).
Proof.
  induction k as [|k IH]; [rewrite Nat.mul_0_r; reflexivity|].
  rewrite Nat.mul_succ_r, sum_split, IH. reflexivity.
Qed.

Fixpoint sum_over (l : list N) (f : N -> R) : R := match l with [] => 0 | i :: r => f i + sum_over r f end.

Lemma sum_over_ext l f g : (forall i, In i l -> f i = g i) -> sum_over l f = sum_over l g.
Proof. induction l as [|i l IH]; intros E; cbn; [reflexivity|]. rewrite IH, E; cbn; auto. intros; apply E; cbn; auto. Qed.

Lemma sum_over_le l f g : (forall i, In i l -> f i <= g i) -> sum_over l f <= sum_over l g.
Proof.
  induction l as [|i l IH]; intros E; cbn; [lra|].
  apply Rplus_le_compat; [apply E; cbn; auto | apply IH; intros; apply E; cbn; auto].
Qed.

Lemma sum_over_zero l f : (forall i, In i l -> f i = 0) -> sum_over l f = 0.
Proof. induction l as [|i l IH]; intros E; cbn; [reflexivity|]. rewrite IH, E; cbn; auto; try lra. intros; apply E; cbn; auto. Qed.

Lemma sum_over_scale l c f : sum_over l (fun i => c * f i) = c * sum_over l f.
Proof. induction l as [|i l IH]; cbn; [lra|]. rewrite IH; lra. Qed.

Lemma sum_over_plus l f g : sum_over l (fun i => f i + g i) = sum_over l f + sum_over l g.
Proof. induction l as [|i l IH]; cbn; [lra|]. rewrite IH; lra. Qed.

Lemma sum_over_abs l f : Rabs (sum_over l f) <= sum_over l (fun i => Rabs (f i)).
Proof.
  induction l as [|i l IH]; cbn; [rewrite Rabs_R0; lra|].
  eapply Rle_trans; [apply Rabs_triang|]. lra.
Qed.

(** The sum in which one of the terms is c more. *)
Lemma sum_over_changed l i c f g :
  NoDup l -> In i l -> (forall j, j <> i -> f j = g j) -> f i = g i + c -> sum_over l f = sum_over l g + c.
Proof.
  induction l as [|j l IH]; intros D I E F; [destruct I|]. inversion D; subst. cbn.
  destruct (N.eq_dec j i) as [->|J].
  - rewrite (sum_over_ext l f g); [lra|]. intros k K. apply E. intros ->. contradiction.
  - destruct I as [->|I]; [contradiction|]. rewrite IH, E; auto; lra.
Qed.

Lemma majorises_sum_over l (h g : N -> vector -> R) : (forall i, In i l -> majorises (h i) (g i)) ->
  majorises (fun t => sum_over l (fun i => h i t)) (fun d => sum_over l (fun i => g i d)).
Proof.
  induction l as [|i l IH]; intros M; cbn.
  - apply (majorises_ext (fun _ => Rabs 0) (fun _ => 0) _ _ (majorises_const 0)); intros; [apply Rabs_R0 | reflexivity].
  - apply majorises_plus; [apply M; cbn; auto | apply IH; intros; apply M; cbn; auto].
Qed.

(** m equations in m + 1 unknowns *)
Lemma dependent m (a : nat -> nat -> R) :
  exists x : nat -> R, (exists k, (k < S m)%nat /\ x k <> 0) /\
    forall i, (i < m)%nat -> sum (S m) (fun k => a i k * x k) = 0.
Proof.
  revert a. induction m as [|m IH]; intros a.
  - exists (fun _ => 1). split; [exists 0%nat; split; [lia | lra] | intros; lia].
  - assert (C : (forall i, (i < S m)%nat -> a i (S m) = 0) \/ exists i, (i < S m)%nat /\ a i (S m) <> 0).
    { generalize (S m) at 1 3 as n. induction n as [|n IHn]; [left; intros; lia|].
      destruct IHn as [Z|[i [L Z]]]; [|right; exists i; auto].
      destruct (Req_EM_T (a n (S m)) 0) as [E|E]; [left | right; exists n; auto].
      intros i L. destruct (Nat.eq_dec i n) as [->|]; [exact E | apply Z; lia]. }
    destruct C as [Z | [i [L Z]]].
    + exists (fun k => if Nat.eq_dec k (S m) then 1 else 0). split.
      * exists (S m). split; [lia|]. destruct (Nat.eq_dec (S m) (S m)); [lra | contradiction].
      * intros i L. rewrite (sum_single _ (S m)); [rewrite (Z i L); lra | lia |].
        intros k K D. destruct (Nat.eq_dec k (S m)); [contradiction | lra].
    + pose (other := fun j => if Nat.ltb j i then j else S j).
      destruct (IH (fun j k => a (other j) k - a (other j) (S m) / a i (S m) * a i k)) as [x [[k [K N]] E]].
      pose (last := - sum (S m) (fun k => a i k * x k) / a i (S m)).
      pose (y := fun k => if Nat.eq_dec k (S m) then last else x k).
      assert (S' : forall j, sum (S (S m)) (fun k => a j k * y k) = sum (S m) (fun k => a j k * x k) + a j (S m) * last).
      { intros j. cbn [sum]. f_equal; [f_equal|].
        - apply sum_ext. intros l Q. unfold y. destruct (Nat.eq_dec l (S m)); [lia | reflexivity].
        - unfold y. destruct (Nat.eq_dec m (S m)); [lia | reflexivity].
        - unfold y. destruct (Nat.eq_dec (S m) (S m)); [reflexivity | contradiction]. }
      exists y. split.
      * exists k. split; [lia|]. unfold y. destruct (Nat.eq_dec k (S m)); [lia | exact N].
      * intros j J. rewrite S'. destruct (Nat.eq_dec j i) as [->|D]; [unfold last; field; exact Z|].
        assert (O : exists l, (l < m)%nat /\ other l = j).
        { destruct (Nat.lt_ge_cases j i) as [Q|Q].
          - exists j. split; [lia|]. unfold other. destruct (Nat.ltb_spec j i); lia.
          - exists (j - 1)%nat. split; [lia|]. unfold other. destruct (Nat.ltb_spec (j - 1) i); lia. }
        destruct O as [l [Q <-]]. specialize (E l Q). cbv beta in E.
        rewrite (sum_ext _ _ (fun k => a (other l) k * x k + (- (a (other l) (S m) / a i (S m))) * (a i k * x k))) in E
          by (intros; ring).
        rewrite sum_plus, sum_scale in E. unfold last.
        replace (a (other l) (S m) * (- sum (S m) (fun k0 : nat => a i k0 * x k0) / a i (S m)))
          with (- (a (other l) (S m) / a i (S m)) * sum (S m) (fun k => a i k * x k)) by (field; exact Z).
        exact E.
Qed.

(** Vectors that compute *)

Definition key (i : N) : positive := N.succ_pos i.
Definition look {A} (otherwise : A) (m : PositiveMap.t A) (i : N) : A :=
  match PositiveMap.find (key i) m with Some x => x | None => otherwise end.
Definition table := PositiveMap.t number.
Definition get (m : table) (i : N) : number := look zero m i.
Definition put (m : table) (i : N) (x : number) : table := PositiveMap.add (key i) x m.
Definition empty : table := PositiveMap.empty number.

Lemma key_inj i j : key i = key j -> i = j.
Proof. unfold key. intros E. apply (f_equal Npos) in E. rewrite !N.succ_pos_spec in E. lia. Qed.

Lemma get_put m i x j : get (put m i x) j = if N.eq_dec j i then x else get m j.
Proof.
  unfold get, look, put. destruct (N.eq_dec j i) as [->|D].
  - rewrite PositiveMap.gss. reflexivity.
  - rewrite PositiveMap.gso; [reflexivity|]. intros E. apply D, key_inj, E.
Qed.

Lemma get_empty i : get empty i = zero.
Proof. unfold get, look, empty. rewrite PositiveMap.gempty. reflexivity. Qed.

Lemma look_add {A} (o : A) m i x j : look o (PositiveMap.add (key i) x m) j = if N.eq_dec j i then x else look o m j.
Proof.
  unfold look. destruct (N.eq_dec j i) as [->|D].
  - rewrite PositiveMap.gss. reflexivity.
  - rewrite PositiveMap.gso; [reflexivity|]. intros E. apply D, key_inj, E.
Qed.

Lemma look_empty {A} (o : A) i : look o (PositiveMap.empty A) i = o.
Proof. unfold look. rewrite PositiveMap.gempty. reflexivity. Qed.

(** A list as a table, from an index on. *)
Fixpoint tabulate {A} (i : N) (l : list A) (m : PositiveMap.t A) : PositiveMap.t A :=
  match l with [] => m | x :: r => tabulate (N.succ i) r (PositiveMap.add (key i) x m) end.

Lemma look_tabulate {A} (o : A) i l m j :
  look o (tabulate i l m) j = if N.ltb j i then look o m j else
    match nth_error l (N.to_nat (j - i)) with Some x => x | None => look o m j end.
Proof.
  revert i m. induction l as [|x l IH]; intros i m; cbn.
  - destruct (N.ltb j i); [reflexivity|]. destruct (N.to_nat (j - i)); reflexivity.
  - rewrite IH. unfold look.
    destruct (N.ltb_spec j i), (N.ltb_spec j (N.succ i)); try lia.
    + rewrite PositiveMap.gso; [reflexivity|]. intros E. apply key_inj in E. lia.
    + assert (j = i) by lia. subst. rewrite PositiveMap.gss, N.sub_diag. reflexivity.
    + replace (N.to_nat (j - i)) with (S (N.to_nat (j - N.succ i))) by lia. cbn.
      rewrite PositiveMap.gso; [reflexivity|]. intros E. apply key_inj in E. lia.
Qed.

Lemma look_list {A} (o : A) l j : look o (tabulate 0 l (PositiveMap.empty A)) j = nth (N.to_nat j) l o.
Proof.
  rewrite look_tabulate. destruct (N.ltb_spec j 0); [lia|]. rewrite N.sub_0_r.
  destruct (nth_error l (N.to_nat j)) as [x|] eqn:E.
  - symmetry. apply nth_error_nth, E.
  - apply nth_error_None in E. rewrite nth_overflow by assumption. unfold look. rewrite PositiveMap.gempty. reflexivity.
Qed.

(** That no index occurs twice. *)
Fixpoint distinct (l : list N) (seen : PositiveMap.t unit) : bool :=
  match l with
  | [] => true
  | i :: r => negb (PositiveMap.mem (key i) seen) && distinct r (PositiveMap.add (key i) tt seen)
  end.

Lemma distinct_from l seen : distinct l seen = true ->
  NoDup l /\ forall i, In i l -> PositiveMap.mem (key i) seen = false.
Proof.
  revert seen. induction l as [|i l IH]; intros seen D; cbn in D.
  - split; [constructor | intros i []].
  - apply andb_prop in D. destruct D as [A D]. apply negb_true_iff in A. destruct (IH _ D) as [N M]. split.
    + constructor; [|exact N]. intros I. specialize (M i I).
      rewrite PositiveMap.mem_find, PositiveMap.gss in M. discriminate.
    + intros j [<-|J]; [exact A|]. specialize (M j J). rewrite PositiveMap.mem_find in *.
      destruct (Pos.eq_dec (key j) (key i)) as [E|E].
      * rewrite E, PositiveMap.gss in M. discriminate.
      * rewrite PositiveMap.gso in M by exact E. exact M.
Qed.

Lemma distinct_NoDup l : distinct l (PositiveMap.empty unit) = true -> NoDup l.
Proof. intros D. apply (distinct_from l _ D). Qed.

(** The vector of a table. *)
Definition values (m : table) : vector := fun i => value (get m i).

(** A linear function: coefficients of components; several of the same are added. *)
Definition linear := list (N * number).

Fixpoint apply (l : linear) (v : vector) : R :=
  match l with [] => 0 | (j, a) :: r => value a * v j + apply r v end.

Definition sum_of (l : linear) (m : table) : number :=
  List.fold_left (fun s e => add s (mul (snd e) (get m (fst e)))) l zero.

Definition size_of (l : linear) (m : table) : number :=
  List.fold_left (fun s e => add s (mul (abs (snd e)) (abs (get m (fst e))))) l zero.

Lemma sum_of_from l m s :
  value (List.fold_left (fun s e => add s (mul (snd e) (get m (fst e)))) l s) = value s + apply l (values m).
Proof.
  revert s. induction l as [|[j a] l IH]; intros s; cbn; [lra|]. rewrite IH, value_add, value_mul. unfold values; lra.
Qed.

Lemma sum_of_value l m : value (sum_of l m) = apply l (values m).
Proof. unfold sum_of. rewrite sum_of_from, value_zero. lra. Qed.

Fixpoint apply_abs (l : linear) (v : vector) : R :=
  match l with [] => 0 | (j, a) :: r => Rabs (value a) * v j + apply_abs r v end.

Definition absolute (m : table) : vector := fun i => Rabs (value (get m i)).

Lemma size_of_from l m s :
  value (List.fold_left (fun s e => add s (mul (abs (snd e)) (abs (get m (fst e))))) l s) = value s + apply_abs l (absolute m).
Proof.
  revert s. induction l as [|[j a] l IH]; intros s; cbn; [lra|].
  rewrite IH, value_add, value_mul, !value_abs. unfold absolute; lra.
Qed.

Lemma size_of_value l m : value (size_of l m) = apply_abs l (absolute m).
Proof. unfold size_of. rewrite size_of_from, value_zero. lra. Qed.

Lemma apply_ext l v w : (forall i, v i = w i) -> apply l v = apply l w.
Proof. intros E. induction l as [|[j a] l IH]; cbn; [reflexivity|]. rewrite E, IH. reflexivity. Qed.

Lemma apply_plus l v w : apply l (fun i => v i + w i) = apply l v + apply l w.
Proof. induction l as [|[j a] l IH]; cbn; [lra|]. rewrite IH; lra. Qed.

Lemma apply_scale l c v : apply l (fun i => c * v i) = c * apply l v.
Proof. induction l as [|[j a] l IH]; cbn; [lra|]. rewrite IH; lra. Qed.

Lemma apply_zero l v : (forall i, v i = 0) -> apply l v = 0.
Proof. intros E. induction l as [|[j a] l IH]; cbn; [reflexivity|]. rewrite E, IH; lra. Qed.

Lemma apply_app l k v : apply (l ++ k) v = apply l v + apply k v.
Proof. induction l as [|[j a] l IH]; cbn; [lra|]. rewrite IH; lra. Qed.

Lemma apply_sum n l (e : nat -> vector) x :
  apply l (fun i => sum n (fun k => x k * e k i)) = sum n (fun k => x k * apply l (e k)).
Proof.
  induction n as [|n IH]; cbn.
  - apply apply_zero. reflexivity.
  - rewrite apply_plus, apply_scale, IH. reflexivity.
Qed.

Lemma apply_bound l v w : (forall i, Rabs (v i) <= w i) -> Rabs (apply l v) <= apply_abs l w.
Proof.
  intros B. induction l as [|[j a] l IH]; cbn; [rewrite Rabs_R0; lra|].
  eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_mult.
  apply Rplus_le_compat; [apply Rmult_le_compat_l; auto using Rabs_pos | exact IH].
Qed.

Lemma apply_abs_scale l c v : apply_abs l (fun i => c * v i) = c * apply_abs l v.
Proof. induction l as [|[j a] l IH]; cbn; [lra|]. rewrite IH; lra. Qed.

Lemma majorises_apply l (h g : N -> vector -> R) : (forall i, majorises (h i) (g i)) ->
  majorises (fun t => apply_abs l (fun i => h i t)) (fun d => apply l (fun i => g i d)).
Proof.
  intros M. induction l as [|[j a] l IH]; cbn.
  - apply (majorises_ext (fun _ => Rabs 0) (fun _ => 0) _ _ (majorises_const 0)); intros; [apply Rabs_R0 | reflexivity].
  - apply majorises_plus; [apply majorises_scale, M | exact IH].
Qed.

(** A multiple of a linear function, added to coefficients in a table. *)
Definition accumulate (m : table) (r : number) (l : linear) : table :=
  List.fold_left (fun m e => put m (fst e) (add (get m (fst e)) (mul r (snd e)))) l m.

Lemma accumulate_value left m r l c : NoDup left -> (forall k, ~ In k left -> c k = 0) ->
  sum_over left (fun k => value (get (accumulate m r l) k) * c k)
  = sum_over left (fun k => value (get m k) * c k) + value r * apply l c.
Proof.
  intros D O. revert m. induction l as [|[j a] l IH]; intros m; cbn; [lra|].
  unfold accumulate in IH. rewrite IH. clear IH.
  replace (value r * (value a * c j + apply l c)) with (value r * value a * c j + value r * apply l c) by ring.
  rewrite <- Rplus_assoc. f_equal.
  destruct (in_dec N.eq_dec j left) as [I|I].
  - apply sum_over_changed with j; auto.
    + intros k K. rewrite get_put. destruct (N.eq_dec k j); [contradiction | reflexivity].
    + rewrite get_put. destruct (N.eq_dec j j); [|contradiction]. rewrite value_add, value_mul. ring.
  - rewrite (O j I), Rmult_0_r, Rplus_0_r. apply sum_over_ext. intros k K. rewrite get_put.
    destruct (N.eq_dec k j) as [->|]; [contradiction | reflexivity].
Qed.
