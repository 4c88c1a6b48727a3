(** What the checker accepts is true: [check_sound] for data, [accepts_sound] for texts. *)
From Coq Require Import String List Bool ZArith Reals Lra Lia.
From Slipproof Require Import Text Syntax Meaning Print Parse Poly Normal NormalSound Checker.
Import ListNotations.
Local Open Scope R_scope.

Section Proofs.
Variable v : positive -> R.
Notation val := (value_at v).
Notation holds := (holds v).
Notation agree := (agree v).

Definition in_force (hs : hypotheses) : Prop := forall name f, Map.find name hs = Some f -> holds f.

Lemma assume_one name f hs : in_force hs -> holds f -> in_force (Map.add name f hs).
Proof.
  intros H F other g. rewrite find_add. destruct (String.eqb other name); [|apply H]. intro E. inversion E; subst. exact F.
Qed.

Lemma assume_sound f : forall name hs more,
  assume name f hs = Some more -> in_force hs -> holds f -> in_force more.
Proof.
  induction f as [s p|parts IH|parts IH] using form_nested_ind; intros name hs more A H F; cbn [assume] in A.
  - destruct (Map.find name hs); [discriminate|]. inversion A; subst. now apply assume_one.
  - apply holds_all in F. revert A. generalize 1%nat as i. revert hs H.
    induction parts as [|g parts IHparts]; intros hs H i A.
    + inversion A; subst. exact H.
    + inversion IH as [|? ? G IHs]; inversion F as [|? ? K Ks]; subst.
      options A. exact (IHparts IHs Ks h (G _ _ _ E H K) (S i) A).
  - destruct (Map.find name hs); [discriminate|]. inversion A; subst. now apply assume_one.
Qed.

(** Identities *)

Lemma times_power_value p n : forall done r, times_power p n done = Some r -> val r = val done * val p ^ n.
Proof.
  induction n as [|n IH]; intros done r H; simpl in H.
  - inversion H; subst. simpl. ring.
  - options H. rewrite (IH _ _ H), (mul_value v _ _ _ E). simpl. ring.
Qed.

Definition signed (w : poly * bool) : Prop := val (fst w) >= 0 /\ (snd w = true -> val (fst w) > 0).

Lemma product_sound hs : in_force hs -> forall factors done strict w,
  product hs factors done strict = Some w -> signed (done, strict) -> signed w.
Proof.
  intros H factors. induction factors as [|[name n] factors IH]; intros done strict w P S; simpl in P.
  - inversion P; subst. exact S.
  - destruct (Map.find name hs) as [f|] eqn:F; [|discriminate]. apply H in F.
    destruct S as [S T]; simpl in S, T.
    destruct f as [[| |] p| |]; try discriminate; options P; apply (IH _ _ _ P);
      apply times_power_value in E; split; simpl; rewrite E; simpl in F.
    + assert (0 < val p ^ n) by (apply pow_lt; lra). nra.
    + intro Q. apply T in Q. assert (0 < val p ^ n) by (apply pow_lt; lra). nra.
    + assert (0 <= val p ^ n) by (apply pow_le; lra). nra.
    + discriminate.
Qed.

Lemma worth_sound names hs s w : in_force hs -> worth names hs s = Some w -> signed w.
Proof.
  intros H W. destruct s as [token factors|name e]; simpl in W.
  - options W. apply andb_true_iff in E0. destruct E0 as [L _]. apply Z.ltb_lt, IZR_lt in L.
    eapply product_sound; [exact H|exact W|]. split; simpl; rewrite constant_value; lra.
  - destruct (Map.find name hs) as [[[| |] p| |]|] eqn:F; try discriminate. apply H in F. simpl in F.
    options W. inversion W; subst. split; simpl; [|discriminate].
    rewrite (mul_value v _ _ _ E0), F. lra.
Qed.

Lemma worths_sound names hs i : in_force hs -> forall ws, worths names hs i = Some ws -> Forall signed ws.
Proof.
  intro H. induction i as [|s i IH]; intros ws W; simpl in W.
  - inversion W. constructor.
  - options W. inversion W; subst. constructor; [eapply worth_sound; eassumption|]. now apply IH.
Qed.

Lemma total_signed ws : Forall signed ws ->
  total v (map fst ws) >= 0 /\ (existsb snd ws = true -> total v (map fst ws) > 0).
Proof.
  induction 1 as [|[p s] ws [S T] _ [IH K]]; simpl in *.
  - split; [lra|discriminate].
  - split; [lra|]. intro E. apply orb_true_iff in E. destruct E as [E|E]; [apply T in E|apply K in E]; lra.
Qed.

Lemma refutes_sound names hs i : refutes names hs i = true -> in_force hs -> False.
Proof.
  intros R H. unfold refutes in R. destruct (worths names hs i) as [ws|] eqn:W; [|discriminate].
  apply andb_true_iff in R. destruct R as [R _]. apply andb_true_iff in R. destruct R as [S Z].
  apply (is_zero_value v) in Z. rewrite sum_value in Z.
  destruct (total_signed ws) as [_ P]; [eapply worths_sound; eassumption|]. apply P in S. lra.
Qed.

Lemma refutes_with_sound name f names hs i : refutes_with name f names hs i = true -> in_force hs -> ~ holds f.
Proof.
  intros R H F. unfold refutes_with in R. apply andb_true_iff in R. destruct R as [_ R].
  destruct (assume name f hs) as [more|] eqn:A; [|discriminate].
  eapply refutes_sound; [exact R|]. eapply assume_sound; eassumption.
Qed.

(** Witnesses *)

Section Conclusion.
Variable names : Normal.scope.
Variable meant : Meaning.scope.
Variable unknowns : list string.
Variable abbreviations : list abbreviation.
Variable conclusion : formula.
Hypothesis names_agree : agree names meant.

Lemma normal_shown_sound more : forall names meant f, normal_shown conclusion more names = Some f -> agree names meant ->
  (holds f <-> shown more conclusion meant).
Proof.
  induction more as [|a more IH]; intros ns m f N A; simpl in *.
  - destruct (normal_formula_sound v _ _ A _ _ N) as [P [T L]]. now rewrite T.
  - options N. destruct (abbreviate_sound v _ _ A _ _ E) as [wider [W B]]. rewrite W. now apply IH with (names := s).
Qed.

Lemma give_spec y us : forall m name,
  give y us m name = if in_dec string_dec name us then Some (Meaning.Value (Quantity True (y name))) else m name.
Proof.
  induction us as [|u us IH]; intros m name; simpl; [reflexivity|].
  unfold give in *. simpl. rewrite IH. unfold bind. destruct (string_dec u name) as [E|E].
  - subst. rewrite String.eqb_refl. now destruct (in_dec string_dec name us).
  - destruct (in_dec string_dec name us); [reflexivity|]. destruct (String.eqb_spec name u); congruence.
Qed.

Lemma give_values_spec us : forall values given divisors g ds,
  give_values names us values given divisors = Some (g, ds) -> apart v ds ->
  apart v divisors
  /\ forall name,
       (In name us -> exists f, Map.find name g = Some (Normal.Value f) /\ apart v (divs f) /\ exists q, represents v f q)
       /\ (~ In name us -> Map.find name g = Map.find name given).
Proof.
  induction us as [|u us IH]; intros [|[n e] values] given divisors g ds G A; simpl in G; try discriminate.
  - inversion G; subst. split; [exact A|]. intro name. split; [intros []|reflexivity].
  - destruct (String.eqb n u); [|discriminate]. options G.
    destruct (IH _ _ _ _ _ G A) as [B C]. unfold apart in B. rewrite Forall_app in B. destruct B as [B D].
    split; [exact B|]. intro name. destruct (C name) as [I O]. split.
    + intros [->|J]; [|auto]. destruct (in_dec string_dec name us) as [J|J]; [auto|].
      rewrite (O J), find_add, String.eqb_refl. exists f. split; [reflexivity|]. split; [exact D|].
      destruct (normal_value_sound v _ _ names_agree _ _ E) as [q [_ R]]. eauto.
    + intro J. simpl in J. rewrite (O (fun K => J (or_intror K))), find_add.
      destruct (String.eqb_spec name u); [subst; tauto|reflexivity].
Qed.

Definition value_of (g : Normal.scope) (u : string) : R :=
  match Map.find u g with Some (Normal.Value f) => val (num f) / val (or_one (den f)) | _ => 0 end.

Lemma give_values_agree values g ds : give_values names unknowns values names [] = Some (g, ds) -> apart v ds ->
  agree g (give (value_of g) unknowns meant).
Proof.
  intros G A name e F. destruct (give_values_spec _ _ _ _ _ _ G A) as [_ S]. destruct (S name) as [I O].
  rewrite give_spec. destruct (in_dec string_dec name unknowns) as [J|J].
  - destruct (I J) as [f [K [B [q [D V]]]]]. rewrite K in F. inversion F; subst. eexists; split; [reflexivity|].
    unfold value_of. rewrite K. split; simpl; [tauto|]. intros _. destruct (V B) as [N _]. split; [exact N|reflexivity].
  - rewrite (O J) in F. apply (names_agree _ _ F).
Qed.

Lemma zero_or_apart ds : Exists (fun p => val p = 0) ds \/ apart v ds.
Proof.
  unfold apart. induction ds as [|p ds [IH|IH]].
  - right. constructor.
  - left. now apply Exists_cons_tl.
  - destruct (Req_dec (val p) 0); [left; now apply Exists_cons_hd|right; now constructor].
Qed.

Definition goal : Prop := exists y : string -> R, shown abbreviations conclusion (give y unknowns meant).

Lemma failure_sound values f : failure names unknowns abbreviations conclusion values = Some f -> holds f \/ goal.
Proof.
  intro F. unfold failure in F. options F. destruct p as [g ds]. simpl in *. inversion F; subst f; clear F.
  destruct (zero_or_apart ds) as [Z|A].
  - left. rewrite holds_any_of, Exists_app, Exists_exists. left. apply Exists_exists in Z. destruct Z as [p [I Z]].
    exists (Atom Zero p). split; [now apply in_map|exact Z].
  - assert (B := give_values_agree _ _ _ E A). destruct (holds_dec v f0) as [H|H].
    + right. eexists. eapply normal_shown_sound; eassumption.
    + left. rewrite holds_any_of, Exists_app. right. constructor. now apply negation_sound.
Qed.

(** Proofs *)

Let check_it := check_proof names unknowns abbreviations conclusion.
Let check_them := check_branches names unknowns abbreviations conclusion.

Lemma below p : holds (Atom Positive (neg p)) <-> val p < 0.
Proof. simpl. rewrite neg_value. lra. Qed.

Lemma check_proof_branches_sound :
  (forall p hs, check_it hs p = true -> in_force hs -> goal)
  /\ (forall bs hs name i parts, check_them hs name i parts bs = true -> in_force hs -> holds (Any parts) -> goal).
Proof.
  unfold check_it, check_them. apply proof_branches_ind.
  - intros name e s first second rest IH hs C H. cbn [check_proof check_branches] in C. destruct (normal_poly names e) as [p|]; [|discriminate].
    apply andb_true_iff in C. destruct C as [C D].
    destruct (assume name (Atom s p) hs) as [more|] eqn:A; [|discriminate].
    apply (IH _ D). eapply assume_sound; [exact A|exact H|].
    destruct s; [apply andb_true_iff in C; destruct C as [C K]; apply refutes_with_sound in K; [|exact H]| |];
      (apply refutes_with_sound in C; [|exact H]); simpl in *; rewrite ?neg_value in *; lra.
  - intros name values rest IH hs C H. cbn [check_proof check_branches] in C.
    destruct unknowns as [|u us] eqn:U; [discriminate|]. rewrite <- U in *.
    destruct (failure names unknowns abbreviations conclusion values) as [f|] eqn:F; [|discriminate].
    destruct (assume name f hs) as [more|] eqn:A; [|discriminate].
    apply failure_sound in F. destruct F as [F|G]; [|exact G].
    apply (IH _ C). eapply assume_sound; eassumption.
  - intros name e n IHn z IHz p IHp hs C H. cbn [check_proof check_branches] in C. destruct (normal_poly names e) as [q|]; [|discriminate].
    destruct (assume name (Atom Positive (neg q)) hs) as [below_zero|] eqn:A; [|discriminate].
    destruct (assume name (Atom Zero q) hs) as [at_zero|] eqn:B; [|discriminate].
    destruct (assume name (Atom Positive q) hs) as [above|] eqn:D; [|discriminate].
    apply andb_true_iff in C. destruct C as [C P]. apply andb_true_iff in C. destruct C as [N Z].
    destruct (Rtotal_order (val q) 0) as [T|[T|T]].
    + apply (IHn _ N). eapply assume_sound; [exact A|exact H|]. now apply below.
    + apply (IHz _ Z). eapply assume_sound; [exact B|exact H|exact T].
    + apply (IHp _ P). eapply assume_sound; [exact D|exact H|exact T].
  - intros name bs IH hs C H. cbn [check_proof check_branches] in C. destruct (Map.find name hs) as [[|parts|parts]|] eqn:F; try discriminate.
    exact (IH _ _ _ _ C H (H _ _ F)).
  - intros i hs C H. exfalso. exact (refutes_sound _ _ _ C H).
  - intros hs name i [|f parts] C H F; [contradiction|discriminate].
  - intros p IHp bs IHbs hs name i [|f parts] C H F; cbn [check_proof check_branches] in C; [discriminate|].
    destruct (assume (name ++ "." ++ show_nat i)%string f hs) as [more|] eqn:A; [|discriminate].
    apply andb_true_iff in C. destruct C as [C D]. destruct F as [F|F].
    + apply (IHp _ C). eapply assume_sound; eassumption.
    + exact (IHbs _ _ _ _ D H F).
Qed.
Lemma check_proof_sound p hs : check_it hs p = true -> in_force hs -> goal.
Proof. apply (proj1 check_proof_branches_sound). Qed.
End Conclusion.
End Proofs.

(** Statements *)

Section Premises.
Variable variables : list string.
Variable x : string -> R.
Let v (i : positive) : R := x (variable_name variables i).

Lemma give_variables_sound new : forall next names given after meant,
  give_variables variables new next names = Some (given, after) -> agree v names meant -> agree v given (give x new meant).
Proof.
  induction new as [|name new IH]; intros next names given after meant G A; simpl in G.
  - inversion G; subst. exact A.
  - destruct (String.eqb_spec (variable_name variables (Pos.of_nat next)) name) as [E|]; [|discriminate].
    apply (IH _ _ _ _ _ G). apply agree_bind; [exact A|]. unfold numbered. split; cbn [defined Meaning.value num den divs or_one].
    + split; intros; [constructor|exact I].
    + intros _. rewrite one_value, variable_value. split; [lra|]. unfold v. rewrite E. field.
Qed.

Lemma take_premises_sound ps : forall next names hs taken more meant (conclude : Meaning.scope -> Prop),
  take_premises variables ps next names hs = Some (taken, more) -> agree v names meant -> in_force v hs ->
  (forall meant, agree v taken meant -> in_force v more -> conclude meant) ->
  under x ps meant conclude.
Proof.
  induction ps as [|[new|a|name f] ps IH]; intros next names hs taken more meant conclude T A H C; simpl in T |- *.
  - inversion T; subst. auto.
  - options T. destruct p as [given after]. simpl in T. eapply IH; try eassumption. eapply give_variables_sound; eassumption.
  - options T. destruct (abbreviate_sound v _ _ A _ _ E) as [wider [W B]]. rewrite W. eapply IH; eassumption.
  - options T. destruct (normal_formula_sound v _ _ A _ _ E) as [P [R L]]. rewrite R. intro K. apply L in K.
    eapply IH; try eassumption. eapply assume_sound; eassumption.
Qed.
End Premises.

Lemma empty_agrees v : agree v (Map.empty Normal.entry) nothing.
Proof. intros name e F. rewrite MapFacts.empty_o in F. discriminate. Qed.

Lemma empty_in_force v : in_force v (Map.empty form).
Proof. intros name e F. rewrite MapFacts.empty_o in F. discriminate. Qed.

Lemma proves_sound s taken p : take_statement s = Some taken -> proves s taken p = true -> meaning s.
Proof.
  intros T C x. unfold take_statement in T. options T. destruct p0 as [names hs]. simpl in T.
  eapply take_premises_sound; [exact E0|apply empty_agrees|apply empty_in_force|].
  intros meant A H. destruct taken as [ns more]. unfold proves in C. simpl in C, E1.
  destruct (unknowns s) as [|u us] eqn:U.
  - options T. inversion T; subst ns more; clear T.
    destruct (holds_dec (fun i => x (variable_name (variables_of s) i)) f) as [F|F].
    + exists (fun _ => 0). eapply normal_shown_sound; eassumption.
    + apply negation_sound in F. eapply check_proof_sound; [exact A|exact C|].
      eapply assume_sound; eassumption.
  - inversion T; subst ns more. eapply check_proof_sound; eassumption.
Qed.

(** What the checker accepts of data is true. *)
Theorem check_sound s p : check s p = true -> meaning s.
Proof. unfold check. destruct (take_statement s) eqn:T; [|discriminate]. now apply proves_sound. Qed.

(** Texts *)

Lemma same_tokens_eq a : forall b, same_tokens a b = true -> a = b.
Proof.
  induction a as [|s a IH]; intros [|t b]; simpl; try discriminate; auto.
  rewrite andb_true_iff, String.eqb_eq. intros [-> H]. f_equal. auto.
Qed.

Lemma same_lines_eq a : forall b, same_lines a b = true -> map words a = b.
Proof.
  induction a as [|l a IH]; intros [|t b]; simpl; try discriminate; auto.
  rewrite andb_true_iff. intros [H K]. f_equal; [now apply same_tokens_eq|auto].
Qed.

Lemma parse_statement_states text ls s : lines text = Some ls -> parse_statement ls = Some s -> states text s.
Proof.
  intros L P. destruct ls as [|header [|title body]]; try discriminate. unfold parse_statement in P. options P.
  inversion P; subst s; clear P. exists header, title, body. apply andb_true_iff in E3. destruct E3 as [S G].
  apply String.eqb_eq in E, E2. apply same_lines_eq in S. auto.
Qed.

(** What the checker accepts of texts is true: the text states a statement, token for token, and that is true. *)
Theorem accepts_sound statement certificate :
  accepts statement certificate = true -> exists s, states statement s /\ meaning s.
Proof.
  unfold accepts. destruct (read_statement statement) as [r|] eqn:R; [|discriminate]. intro C.
  unfold read_statement in R. options R. inversion R; subst r; clear R. unfold accepts_for in C. simpl in C.
  destruct (lines certificate); [|discriminate]. destruct (parse_certificate _ _ _) as [proof|]; [|discriminate].
  eexists. split; [eapply parse_statement_states; eassumption|eapply proves_sound; eassumption].
Qed.
