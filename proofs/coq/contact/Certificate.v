(** What a certificate about a contact problem says: its text, as data (FORMAT.md), and the meaning of the data. *)
From Coq Require Import Ascii String List Bool NArith ZArith Reals.
From Slipproof Require Import Text.
From Slipproof.contact Require Import Coulomb Number.
Import ListNotations.
Local Open Scope string_scope.

(** Tokens: separated by blanks, tabs and line ends; comments from # to the end of the line. *)
Definition tab : ascii := "009".
Definition line_feed : ascii := "010".
Definition is_blank (c : ascii) : bool := (Ascii.eqb c " " || Ascii.eqb c tab || Ascii.eqb c line_feed)%char.

Fixpoint scan (text : string) (comment : bool) (word : string) (done : list string) : option (list string) :=
  match text with
  | EmptyString => Some (rev' (finish_word word done))
  | String c rest =>
      if is_blank c then scan rest (comment && negb (Ascii.eqb c line_feed)) "" (finish_word word done)
      else match kind_of c with
      | Unprintable | LineFeed => None
      | _ => if comment || Ascii.eqb c "#" then scan rest true "" (finish_word word done)
             else scan rest false (String c word) done
      end
  end.
Definition tokens (text : string) : option (list string) := scan text false "" [].

(** Numbers: 7, 3/4, 0x1.8p-3, with an optional - in front. *)
Definition digit_in (base : Z) (c : ascii) : option Z :=
  match digit c with
  | Some d => Some d
  | None =>
      if Z.eqb base 10 then None else
      match c with
      | "a" => Some 10 | "b" => Some 11 | "c" => Some 12 | "d" => Some 13 | "e" => Some 14 | "f" => Some 15
      | _ => None
      end%char%Z
  end.

(** The value of the digits in front, how many they are, and what follows. *)
Fixpoint leading (base : Z) (s : string) (value : Z) (count : N) : Z * N * string :=
  match s with
  | EmptyString => (value, count, s)
  | String c r =>
      match digit_in base c with
      | Some d => leading base r (base * value + d) (N.succ count)
      | None => (value, count, s)
      end
  end%Z.

Definition natural (s : string) : option N :=
  match leading 10 s 0 0 with (n, count, rest) => if N.ltb 0 count && (rest =? "") then Some (Z.to_N n) else None end.

Definition fraction (s : string) : option number :=
  match leading 10 s 0 0 with (a, count, rest) =>
    if N.eqb count 0 then None else
    match rest with
    | EmptyString => Some (Number a 0 1)
    | String c r =>
        if Ascii.eqb c "/" then match natural r with Some (Npos d) => Some (Number a 0 d) | _ => None end else None
    end
  end.

Definition max_exponent : N := 5000.

(** p, a sign and digits. *)
Definition power (s : string) : option Z :=
  match s with
  | String "p" (String c r) =>
      let* e := natural (if (Ascii.eqb c "-" || Ascii.eqb c "+")%char then r else String c r) in
      require N.leb e max_exponent in Some (if Ascii.eqb c "-" then - Z.of_N e else Z.of_N e)%Z
  | _ => None
  end.

(** n 2^e *)
Definition scaled (n e : Z) : number :=
  if (0 <=? e)%Z then Number (shifted n (Z.to_N e)) 0 1 else Number n (Z.to_N (- e)) 1.

Definition hexadecimal (s : string) : option number :=
  match leading 16 s 0 0 with (a, count, rest) =>
    require N.ltb 0 count in
    match rest with
    | String "." r =>
        match leading 16 r a 0 with (n, places, rest) =>
          require N.ltb 0 places in let* e := power rest in Some (scaled n (e - 4 * Z.of_N places))
        end
    | _ => let* e := power rest in Some (scaled a e)
    end
  end.

Definition max_number : N := 5000.
Definition unsigned (s : string) : option number :=
  match s with String "0" (String "x" r) => hexadecimal r | _ => fraction s end.
Definition number_of (s : string) : option number :=
  require at_most max_number s in
  match s with String "-" r => let* x := unsigned r in Some (opp x) | _ => unsigned s end.

(** A problem with the answer that somebody gave. *)
Record instance := Instance {
  dim : N;
  frees : N;
  frictions : list number;
  entries : list (N * N * number);  (* row, column, number *)
  constants : list number;
  answer : option (list number)
}.

(** A motion in the list of all of them: its forces, or a box, of the problem without free unknowns; and what is known of
    others near it. Distances that are left out are 0. *)
Inductive others_near := Bare | Alone (factor : number) | Within (distances : list number).
Inductive listed :=
  | Exact (forces : list number) (within : option (list number))
  | Boxed (modes : list mode) (center radius : list number) (pinned : list N) (dropped : list (N * list (N * number)))
      (inverse : list (N * N * number)) (near : others_near).

(** Cases, depth first; directions are pairs. *)
Inductive node :=
  | Decide (k : N)
  | Slips (k : N) (directions : list (number * number))
  | Arcs (k : N) (directions : list (number * number))
  | Empty (multipliers : list number)
  | Known (motion : N) (multipliers : list (list number))
  | Frictionless (motion : N) (squares : list (number * list number)).

(** A claim with what proves it. *)
Inductive body :=
  | Eps (bound moved : number) (point motions : list number)
  | NoneWithin (rho : number)
  | NoSolution (multipliers : list number)
  | Rest (accelerations : N) (forces : list number)
  | NoRest (accelerations : N) (multipliers : list number)
  | Enclosure (rho : number) (eta : option number) (modes : list mode) (center radius : list number) (pinned : list N)
      (dropped : list (N * list (N * number))) (inverse : list (N * N * number))
  | Ball (rho : number) (eta : option number) (modes : list mode) (center radius : list number) (pinned : list N)
      (dropped : list (N * list (N * number))) (rows : list number) (least defect bend : number)
      (factor : list (N * N * number))
  | Dominant (weights : list number)
  | Definite (factor : list (N * N * number))
  | AllSolutions (eliminated : option (list (N * N * number))) (motions : list listed) (tree : list node).

Record certificate := Certificate { problem_name : option string; about : instance; claims : list body }.

(** How it is written. *)
Inductive piece := Word (s : string) | Count (n : N) | Numeral (x : number).

Definition numerals (l : list number) : list piece := map Numeral l.
Definition count {A} (l : list A) : piece := Count (N.of_nat (length l)).
Definition in_matrix (l : list (N * N * number)) : list piece :=
  count l :: flat_map (fun e => match e with (i, j, a) => [Count i; Count j; Numeral a] end) l.
Definition in_row (l : list (N * number)) : list piece :=
  count l :: flat_map (fun e => [Count (fst e); Numeral (snd e)]) l.

Definition mode_word (m : mode) : string :=
  match m with
  | Open => "open" | Touch => "touch" | Stick => "stick"
  | Slide => "slide" | SlidePlus => "slide+" | SlideMinus => "slide-"
  end.

(** What enclosures, balls and boxes of motions have in common. *)
Definition written_box (modes : list mode) (center radius : list number) (pinned : list N)
    (dropped : list (N * list (N * number))) : list piece :=
  [Word "modes"] ++ map (fun m => Word (mode_word m)) modes
  ++ [Word "center"] ++ numerals center ++ [Word "radius"] ++ numerals radius
  ++ [Word "pinned"; count pinned] ++ map Count pinned
  ++ [Word "dropped"; count dropped] ++ flat_map (fun d => Count (fst d) :: in_row (snd d)) dropped.

Definition written_near (word : string) (rho : number) (eta : option number) (modes : list mode) (center radius : list number)
    (pinned : list N) (dropped : list (N * list (N * number))) : list piece :=
  [Word word; Numeral rho] ++ match eta with Some x => [Word "velocities"; Numeral x] | None => [] end
  ++ written_box modes center radius pinned dropped.

Definition written_listed (m : listed) : list piece :=
  match m with
  | Exact r within =>
      [Word "motion"; Word "exact"] ++ numerals r ++ match within with Some e => Word "within" :: numerals e | None => [] end
  | Boxed modes center radius pinned dropped inverse near =>
      [Word "motion"; Word "box"] ++ written_box modes center radius pinned dropped ++ [Word "inverse"] ++ in_matrix inverse
      ++ match near with
         | Bare => []
         | Alone l => [Word "alone"; Numeral l]
         | Within e => Word "within" :: numerals e
         end
  end.

Definition in_directions (l : list (number * number)) : list piece :=
  count l :: flat_map (fun d => [Numeral (fst d); Numeral (snd d)]) l.

(** In dimension 2 a contact that slips has no directions to choose from. *)
Definition written_node (planar : bool) (n : node) : list piece :=
  match n with
  | Decide k => [Word "decide"; Count k]
  | Slips k l => [Word "slips"; Count k] ++ if planar then [] else in_directions l
  | Arcs k l => [Word "arcs"; Count k] ++ in_directions l
  | Empty y => Word "empty" :: numerals y
  | Known i ys => [Word "known"; Count i] ++ flat_map numerals ys
  | Frictionless i l =>
      [Word "frictionless"; Count i; count l] ++ flat_map (fun s => Numeral (fst s) :: numerals (snd s)) l
  end.

Definition written (planar : bool) (b : body) : list piece :=
  match b with
  | Eps bound moved point motions =>
      [Word "eps"; Numeral bound; Numeral moved; Word "point"] ++ numerals point ++ [Word "motion"] ++ numerals motions
  | NoneWithin rho => [Word "none-within"; Numeral rho]
  | NoSolution y => [Word "no-solution"; Word "multipliers"] ++ numerals y
  | Rest v x => [Word "rest"; Count v; Word "forces"] ++ numerals x
  | NoRest v y => [Word "no-rest"; Count v; Word "multipliers"] ++ numerals y
  | Enclosure rho eta modes center radius pinned dropped inverse =>
      written_near "enclosure" rho eta modes center radius pinned dropped ++ [Word "inverse"] ++ in_matrix inverse
  | Ball rho eta modes center radius pinned dropped rows least defect bend factor =>
      written_near "ball" rho eta modes center radius pinned dropped
      ++ [Word "rows"] ++ numerals rows ++ [Word "least"; Numeral least; Word "defect"; Numeral defect; Word "bend"; Numeral bend]
      ++ [Word "factor"] ++ in_matrix factor
  | Dominant d => [Word "unique"; Word "dominant"] ++ numerals d
  | Definite l => [Word "unique"; Word "definite"] ++ in_matrix l
  | AllSolutions eliminated motions tree =>
      [Word "all-solutions"; count motions] ++ match eliminated with Some b => Word "eliminated" :: in_matrix b | None => [] end
      ++ flat_map written_listed motions ++ flat_map (written_node planar) tree
  end.

Definition pieces (c : certificate) : list piece :=
  let i := about c in
  [Word "slipproof-contact"; Word "1"] ++ match problem_name c with Some s => [Word "problem"; Word s] | None => [] end
  ++ [Word "dimension"; Count (dim i); Word "free"; Count (frees i); Word "contacts"; count (frictions i)]
  ++ [Word "mu"] ++ numerals (frictions i) ++ [Word "matrix"] ++ in_matrix (entries i)
  ++ [Word "constant"] ++ numerals (constants i)
  ++ match answer i with Some x => Word "answer" :: numerals x | None => [Word "no-answer"] end
  ++ flat_map (written (N.ltb (dim i) 3)) (claims c) ++ [Word "end"].

Definition spells (token : string) (p : piece) : Prop :=
  match p with
  | Word s => token = s
  | Count n => natural token = Some n
  | Numeral x => number_of token = Some x
  end.

(** The tokens of the text are those of the certificate. *)
Definition states (text : string) (c : certificate) : Prop :=
  exists ts, tokens text = Some ts /\ Forall2 spells ts (pieces c).

(** What the data mean. *)
Definition numbers (l : list number) (i : nat) : R := value (nth i l zero).

Definition entry (l : list (N * N * number)) (i j : nat) : R :=
  fold_right (fun e s =>
    match e with (k, m, a) => if (Nat.eqb (N.to_nat k) i && Nat.eqb (N.to_nat m) j)%bool then value a + s else s end)%R 0%R l.

Definition problem_of (i : instance) : problem :=
  Problem (N.to_nat (dim i)) (N.to_nat (frees i)) (length (frictions i)) (numbers (frictions i))
    (entry (entries i)) (numbers (constants i)).

(** As many numbers as it has components, and no entry of the matrix twice. *)
Definition complete (i : instance) : Prop :=
  let n := size (problem_of i) in
  length (constants i) = n /\ (forall x, answer i = Some x -> length x = n) /\
  (forall k m a, In (k, m, a) (entries i) -> (N.to_nat k < n)%nat /\ (N.to_nat m < n)%nat) /\ NoDup (map fst (entries i)).

Definition of_answer (i : instance) (says : (nat -> R) -> Prop) : Prop :=
  match answer i with Some x => says (numbers x) | None => False end.

(** The numbers of unknowns, by the components of the contacts' forces: those that are no unknowns are 0, slips are left out. *)
Fixpoint by_forces (d : nat) (mus : list number) (modes : list mode) (l : list number) : list number :=
  match mus, modes with
  | m :: mus, s :: modes =>
      let forces := match s with
        | Open => 0
        | Touch => 1
        | _ => if Nat.ltb 1 d && negb (is_zero m) then d else 1
        end%nat in
      let unknowns := match s with Slide => S forces | _ => forces end in
      firstn forces l ++ repeat zero (d - forces) ++ by_forces d mus modes (skipn unknowns l)
  | _, _ => []
  end.

(** 0 at the indices, counted from i on. *)
Fixpoint pin (i : N) (indices : list N) (l : list number) : list number :=
  match l with [] => [] | x :: r => (if existsb (N.eqb i) indices then zero else x) :: pin (N.succ i) indices r end.

Definition listed_of (i : instance) (m : listed) : listed_motion :=
  match m with
  | Exact r within => ListedMotion (numbers r) (fun _ => 0%R) None (option_map numbers within)
  | Boxed modes center radius pinned _ _ near =>
      let forces l := numbers (by_forces (N.to_nat (dim i)) (frictions i) modes l) in
      ListedMotion (forces center) (forces (pin 0 pinned radius)) (Some (fun k => nth k modes Open))
        (match near with Bare => Some (fun _ => 0%R) | Alone _ => None | Within e => Some (numbers e) end)
  end.

Definition meaning (i : instance) (b : body) : Prop :=
  let p := problem_of i in
  match b with
  | Eps bound moved _ _ => of_answer i (fun x => eps p x (value bound) (value moved))
  | NoneWithin rho => of_answer i (fun x => none_within p x (value rho))
  | NoSolution _ => no_solution p
  | Rest v _ => can_rest p (N.to_nat v)
  | NoRest v _ => cannot_rest p (N.to_nat v)
  | Enclosure rho None modes _ _ _ _ _ | Ball rho None modes _ _ _ _ _ _ _ _ _ =>
      of_answer i (fun x => enclosure p x (value rho) (fun k => nth k modes Open))
  | Enclosure rho (Some eta) modes _ _ _ _ _ | Ball rho (Some eta) modes _ _ _ _ _ _ _ _ _ =>
      of_answer i (fun x => enclosure_with_velocities p x (value rho) (value eta) (fun k => nth k modes Open))
  | Dominant _ | Definite _ => unique p
  | AllSolutions _ motions _ => all_motions p (map (listed_of i) motions)
  end.
