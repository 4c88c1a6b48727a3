(** The checker (FORMAT.md, "Certificates"): from the data of a statement and of a certificate, and from their texts. *)
From Coq Require Import Ascii String List Bool NArith ZArith DecimalString.
From Slipproof Require Import Text Syntax Print Parse Poly Normal.
Import ListNotations.
Local Open Scope string_scope.

Definition show_nat (n : nat) : string := NilEmpty.string_of_uint (N.to_uint (N.of_nat n)).

(** The hypotheses in force, by their names: atoms and disjunctions. *)
Definition hypotheses := Map.t form.

(** Takes a formula as a hypothesis: of a conjunction its parts, NAME.1, NAME.2, ... No name may be in force twice. *)
Fixpoint assume (name : string) (f : form) (hs : hypotheses) : option hypotheses :=
  match f with
  | All parts =>
      (fix all (i : nat) (parts : list form) (hs : hypotheses) : option hypotheses :=
         match parts with
         | [] => Some hs
         | g :: rest => let* hs := assume (name ++ "." ++ show_nat i) g hs in all (S i) rest hs
         end) 1 parts hs
  | _ => match Map.find name hs with None => Some (Map.add name f hs) | Some _ => None end
  end.

(** Identities *)

Fixpoint times_power (p : poly) (n : nat) (done : poly) : option poly :=
  match n with O => Some done | S n => let* done := mul done p in times_power p n done end.

(** The product of inequalities, and whether all are strict. *)
Fixpoint product (hs : hypotheses) (factors : list (string * nat)) (done : poly) (strict : bool) : option (poly * bool) :=
  match factors with
  | [] => Some (done, strict)
  | (name, n) :: rest =>
      match Map.find name hs with
      | Some (Atom Positive p) => let* done := times_power p n done in product hs rest done strict
      | Some (Atom NonNegative p) => let* done := times_power p n done in product hs rest done false
      | _ => None
      end
  end.

(** What a line of an identity is worth, and whether it is strict. *)
Definition worth (names : scope) (hs : hypotheses) (s : summand) : option (poly * bool) :=
  match s with
  | Term token factors =>
      let* c := number token in
      require Z.ltb 0 c && coefficients_fit (constant c) in product hs factors (constant c) true
  | Equation name e =>
      match Map.find name hs with
      | Some (Atom Zero p) =>
          let* q := normal_poly names e in
          let* r := mul q p in Some (r, false)
      | _ => None
      end
  end.

Fixpoint worths (names : scope) (hs : hypotheses) (i : identity) : option (list (poly * bool)) :=
  match i with
  | [] => Some []
  | s :: rest => let* w := worth names hs s in let* ws := worths names hs rest in Some (w :: ws)
  end.

Definition superfluous (ws : list (poly * bool)) : bool :=
  match ws with [_] => false | _ => existsb (fun w => is_zero (fst w)) ws end.

(** The identity refutes the hypotheses. *)
Definition refutes (names : scope) (hs : hypotheses) (i : identity) : bool :=
  match worths names hs i with
  | Some ws => existsb snd ws && is_zero (sum (map fst ws)) && negb (superfluous ws)
  | None => false
  end.

Definition uses (name : string) (i : identity) : bool :=
  existsb (fun s => match s with
                    | Term _ factors => existsb (fun factor => String.eqb (fst factor) name) factors
                    | Equation other _ => String.eqb other name
                    end) i.

(** The identity refutes the hypotheses with this one more, which it uses. *)
Definition refutes_with (name : string) (f : form) (names : scope) (hs : hypotheses) (i : identity) : bool :=
  uses name i && match assume name f hs with Some hs => refutes names hs i | None => false end.

(** Proofs *)

Section Proofs.
(** Names before [exists]; and the lines after it. *)
Variable names : scope.
Variable unknowns : list string.
Variable abbreviations : list abbreviation.
Variable conclusion : formula.

Fixpoint normal_shown (abbreviations : list abbreviation) (names : scope) : option form :=
  match abbreviations with
  | [] => normal_formula names conclusion
  | a :: rest => let* names := abbreviate names a in normal_shown rest names
  end.

(** The values of a witness in their order, which is that of the unknowns. *)
Fixpoint give_values (unknowns : list string) (values : list (string * expr)) (given : scope) (divisors : list poly)
  : option (scope * list poly) :=
  match unknowns, values with
  | [], [] => Some (given, divisors)
  | u :: unknowns, (name, e) :: values =>
      require String.eqb name u in
      let* x := normal_value names e in
      give_values unknowns values (Map.add u (Value x) given) (divisors ++ divs x)
  | _, _ => None
  end.

(** That these values fail: a divisor is zero, or the conclusion is false. *)
Definition failure (values : list (string * expr)) : option form :=
  let* given := give_values unknowns values names [] in
  let* f := normal_shown abbreviations (fst given) in
  let g := negation f in
  require fits g in Some (any_of (map (Atom Zero) (snd given) ++ [g])).

Fixpoint check_proof (hs : hypotheses) (p : proof) : bool :=
  match p with
  | Have name e s first second rest =>
      match normal_poly names e with
      | None => false
      | Some p =>
          match s with
          | Zero => refutes_with name (Atom Positive p) names hs first
                    && refutes_with name (Atom Positive (neg p)) names hs second
          | Positive => refutes_with name (Atom NonNegative (neg p)) names hs first
          | NonNegative => refutes_with name (Atom Positive (neg p)) names hs first
          end
          && match assume name (Atom s p) hs with Some hs => check_proof hs rest | None => false end
      end
  | Witness name values rest =>
      match unknowns, failure values with
      | _ :: _, Some f => match assume name f hs with Some hs => check_proof hs rest | None => false end
      | _, _ => false
      end
  | Split name e negative zero positive =>
      match normal_poly names e with
      | None => false
      | Some p =>
          match assume name (Atom Positive (neg p)) hs, assume name (Atom Zero p) hs, assume name (Atom Positive p) hs with
          | Some below, Some at_zero, Some above =>
              check_proof below negative && check_proof at_zero zero && check_proof above positive
          | _, _, _ => false
          end
      end
  | Cases name alternatives =>
      match Map.find name hs with
      | Some (Any parts) => check_branches hs name 1 parts alternatives
      | _ => false
      end
  | Contradiction i => refutes names hs i
  end
with check_branches (hs : hypotheses) (name : string) (i : nat) (parts : list form) (bs : branches) : bool :=
  match parts, bs with
  | [], End => true
  | f :: parts, Branch p rest =>
      match assume (name ++ "." ++ show_nat i) f hs with
      | Some more => check_proof more p && check_branches hs name (S i) parts rest
      | None => false
      end
  | _, _ => false
  end.
End Proofs.

(** Statements *)

Definition max_variables : nat := 64.

(** [variables] are those of the statement in their order; the i-th is the variable i of polynomials, from 1. *)
Definition variable_name (variables : list string) (v : positive) : string := nth (Pos.to_nat v) (EmptyString :: variables) EmptyString.

Definition numbered (name : string) (v : nat) : entry := Value (Fraction (variable (Pos.of_nat v)) None []).

(** [next] is the number of the next variable. *)
Fixpoint give_variables (variables new : list string) (next : nat) (names : scope) : option (scope * nat) :=
  match new with
  | [] => Some (names, next)
  | name :: rest =>
      require String.eqb (variable_name variables (Pos.of_nat next)) name in
      give_variables variables rest (S next) (Map.add name (numbered name next) names)
  end.

Fixpoint take_premises (variables : list string) (ps : list premise) (next : nat) (names : scope) (hs : hypotheses)
  : option (scope * hypotheses) :=
  match ps with
  | [] => Some (names, hs)
  | Real new :: rest =>
      let* given := give_variables variables new next names in take_premises variables rest (snd given) (fst given) hs
  | Abbreviate a :: rest => let* names := abbreviate names a in take_premises variables rest next names hs
  | Assume name f :: rest =>
      let* g := normal_formula names f in
      let* hs := assume name g hs in take_premises variables rest next names hs
  end.

Definition variables_of (s : statement) : list string :=
  flat_map (fun p => match p with Real names => names | _ => [] end) (premises s).

(** What the names of a statement have to be. *)

Definition abbreviated (a : abbreviation) : string := match a with Let name _ | Define name _ => name end.

Definition given_names (s : statement) : list string :=
  flat_map (fun p => match p with Real names => names | Abbreviate a => [abbreviated a] | Assume name _ => [name] end)
           (premises s)
  ++ unknowns s ++ map abbreviated (abbreviations s).

Definition name_set := Map.t unit.

Fixpoint distinct (names : list string) (given : name_set) : bool :=
  match names with
  | [] => true
  | name :: rest => is_name name && negb (Map.mem name given) && distinct rest (Map.add name tt given)
  end.

(** Of the name of a part, backwards, that of what it is a part of: [H] for [H.2]. *)
Fixpoint whole_of (part : string) : option string :=
  match part with
  | String c rest => match kind_of c with Digit => whole_of rest | _ => require Ascii.eqb c "." in Some rest end
  | EmptyString => None
  end.

Fixpoint no_part (steps : nat) (part : string) (wholes : name_set) : bool :=
  match steps, whole_of part with
  | S n, Some whole => negb (Map.mem (reverse whole) wholes) && no_part n whole wholes
  | _, _ => true
  end.

Definition assumed (s : statement) : list string :=
  flat_map (fun p => match p with Assume name _ => [name] | _ => [] end) (premises s).

(** No assumption is called [goal], or like a part of another or of [goal]. *)
Definition parts_apart (s : statement) : bool :=
  let wholes := fold_left (fun set name => Map.add name tt set) (assumed s) (Map.add "goal" tt (Map.empty unit)) in
  forallb (fun name => negb (name =? "goal") && no_part 100 (reverse name) wholes) (assumed s).

Definition real_and_exists_given (s : statement) : bool :=
  forallb (fun p => match p with Real [] => false | _ => true end) (premises s)
  && match unknowns s, abbreviations s with [], _ :: _ => false | _, _ => true end.

Definition names_fit (s : statement) : bool :=
  is_theorem_name (theorem s) && distinct (given_names s) (Map.empty unit) && parts_apart s && real_and_exists_given s
  && Nat.leb (length (variables_of s) + length (unknowns s)) max_variables.

(** A well-formed statement: the names before [exists], and the assumptions. *)
Definition take_statement (s : statement) : option (scope * hypotheses) :=
  require names_fit s in
  let* taken := take_premises (variables_of s) (premises s) 1 (Map.empty entry) (Map.empty form) in
  let unknowns_numbered :=
    fold_left (fun done u => (S (fst done), Map.add u (numbered u (fst done)) (snd done))) (unknowns s)
              (S (length (variables_of s)), fst taken) in
  let* f := normal_shown (conclusion s) (abbreviations s) (snd unknowns_numbered) in
  match unknowns s with
  | [] => let* hs := assume "goal" (negation f) (snd taken) in require fits (negation f) in Some (fst taken, hs)
  | _ => Some taken
  end.

Definition proves (s : statement) (taken : scope * hypotheses) (p : proof) : bool :=
  check_proof (fst taken) (unknowns s) (abbreviations s) (conclusion s) (snd taken) p.

Definition check (s : statement) (p : proof) : bool :=
  match take_statement s with Some taken => proves s taken p | None => false end.

(** Texts *)

Definition max_statement : N := 1048576.

(** FNV-1a, 64 bit. *)
Definition fnv_prime : N := 1099511628211.
Definition fnv_basis : N := 14695981039346656037.
Definition low_64_bits : N := 18446744073709551615.
Definition mix (h byte : N) : N := N.land (N.mul fnv_prime (N.lxor h byte)) low_64_bits.
Fixpoint mix_string (s : string) (h : N) : N :=
  match s with EmptyString => mix h 10 | String c rest => mix_string rest (mix h (N_of_ascii c)) end.
Definition hash (ls : list line) : N := fold_left (fun h l => mix_string (raw l) h) ls fnv_basis.

Fixpoint hexadecimal (digits : nat) (n : N) (done : string) : string :=
  match digits with
  | O => done
  | S digits =>
      let d := N.land n 15 in
      hexadecimal digits (N.shiftr n 4) (String (ascii_of_N (if N.ltb d 10 then 48 + d else 87 + d)%N) done)
  end.
Definition fingerprint (ls : list line) : string := hexadecimal 16 (hash ls) "".

Definition parse_certificate (s : statement) (print : string) (ls : list line) : option proof :=
  let* ls := expect_raw "slipproof-certificate 1" ls in
  let* ls := expect_raw ("theorem " ++ theorem s ++ " " ++ print) ls in
  match parse_proof (unknowns s) show_nat (S (length ls)) max_nesting ls with Some (p, []) => Some p | _ => None end.

(** A statement that was read: itself, its names and assumptions, and its fingerprint. *)
Record reading := Reading { read : statement; taken : scope * hypotheses; print_of : string }.

Definition read_statement (text : string) : option reading :=
  require at_most max_statement text in
  let* ls := lines text in
  let* s := parse_statement ls in
  let* t := take_statement s in Some (Reading s t (fingerprint ls)).

Definition accepts_for (r : reading) (certificate : string) : bool :=
  match lines certificate with
  | Some ls => match parse_certificate (read r) (print_of r) ls with Some p => proves (read r) (taken r) p | None => false end
  | None => false
  end.

(** The certificate proves the statement. *)
Definition accepts (statement certificate : string) : bool :=
  match read_statement statement with Some r => accepts_for r certificate | None => false end.

(** In the place of a certificate: a record that the search for one ended without, with its reasons, if any. *)
Definition gives_reason (l : line) : bool := match words l with w :: _ :: _ => w =? "because" | _ => false end.

Definition is_undecided (r : reading) (record : string) : bool :=
  let reasons :=
    let* ls := lines record in
    let* ls := expect_raw "slipproof-undecided 1" ls in
    expect_raw ("theorem " ++ theorem (read r)) ls in
  match reasons with Some ls => forallb gives_reason ls | None => false end.
