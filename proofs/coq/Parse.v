(** From lines to statements and certificates. Nothing rests on this: what is read of a statement is printed back and
    compared with the text ([Print.v]), and a certificate may be anything. *)
From Coq Require Import Ascii String List Bool NArith ZArith.
From Slipproof Require Import Text Syntax Print.
Import ListNotations.
Local Open Scope string_scope.

Definition max_nesting : nat := 100.

(** A base, and the power of it that may follow. *)
Definition parse_exponent (a : expr) (ts : list string) : option (expr * list string) :=
  match ts with
  | t :: rest => if t =? "^" then match rest with k :: ts => Some (Pow a k, ts) | [] => None end else Some (a, ts)
  | [] => Some (a, [])
  end.

(** [n] bounds the steps, [d] the brackets within brackets. *)
Fixpoint parse_sum (n d : nat) (ts : list string) : option (expr * list string) :=
  match n with
  | O => None
  | S n => match parse_product n d ts with Some (a, ts) => more_sum n d a ts | None => None end
  end
with more_sum (n d : nat) (a : expr) (ts : list string) : option (expr * list string) :=
  match n, ts with
  | S n, t :: rest =>
      if t =? "+" then
        match parse_product n d rest with Some (b, ts) => more_sum n d (Add a b) ts | None => None end
      else if t =? "-" then
        match parse_product n d rest with Some (b, ts) => more_sum n d (Sub a b) ts | None => None end
      else Some (a, ts)
  | S _, [] => Some (a, [])
  | O, _ => None
  end
with parse_product (n d : nat) (ts : list string) : option (expr * list string) :=
  match n with
  | O => None
  | S n => match parse_power n d ts with Some (a, ts) => more_product n d a ts | None => None end
  end
with more_product (n d : nat) (a : expr) (ts : list string) : option (expr * list string) :=
  match n, ts with
  | S n, t :: rest =>
      if t =? "*" then
        match parse_power n d rest with Some (b, ts) => more_product n d (Mul a b) ts | None => None end
      else if t =? "/" then
        match parse_power n d rest with Some (b, ts) => more_product n d (Div a b) ts | None => None end
      else Some (a, ts)
  | S _, [] => Some (a, [])
  | O, _ => None
  end
with parse_power (n d : nat) (ts : list string) : option (expr * list string) :=
  match n, ts with
  | S n, t :: rest =>
      if t =? "-" then
        match parse_power n d rest with Some (a, ts) => Some (Neg a, ts) | None => None end
      else if t =? "(" then
        match d with
        | O => None
        | S d =>
            match parse_sum n d rest with
            | Some (a, t :: ts) => require t =? ")" in parse_exponent (Paren a) ts
            | _ => None
            end
        end
      else parse_exponent (if starts_with_letter t then Name t else Num t) rest
  | _, _ => None
  end.

(** More than the steps that these tokens take. *)
Definition steps (ts : list string) : nat := fold_left (fun n _ => S (S (S (S (S n))))) ts 10.

(** An expression, and the tokens after it. *)
Definition parse_expr (d : nat) (ts : list string) : option (expr * list string) := parse_sum (steps ts) d ts.

Definition relation (t : string) : option rel :=
  if t =? "<" then Some Lt else if t =? "<=" then Some Le else if t =? "=" then Some Eq
  else if t =? "!=" then Some Ne else if t =? ">=" then Some Ge else if t =? ">" then Some Gt else None.

Fixpoint parse_links (n d : nat) (ts : list string) (done : list (rel * expr)) : option (list (rel * expr) * list string) :=
  match n, ts with
  | S n, t :: rest =>
      match relation t with
      | None => Some (rev' done, ts)
      | Some r => match parse_expr d rest with Some (e, ts) => parse_links n d ts ((r, e) :: done) | None => None end
      end
  | _, _ => Some (rev' done, ts)
  end.

(** A name alone stands for a formula. *)
Definition parse_chain (d : nat) (ts : list string) : option (formula * list string) :=
  let* read := parse_expr d ts in
  match read with
  | (e, ts) =>
      let* links := parse_links (steps ts) d ts [] in
      match links, e with
      | ([], ts), Name name => Some (Named name, ts)
      | ([], _), _ => None
      | (links, ts), _ => Some (Chain e links, ts)
      end
  end.

Fixpoint parse_or (n d : nat) (ts : list string) : option (formula * list string) :=
  match n with
  | O => None
  | S n => match parse_and n d ts with Some (f, ts) => more_or n d f ts | None => None end
  end
with more_or (n d : nat) (f : formula) (ts : list string) : option (formula * list string) :=
  match n, ts with
  | S n, t :: rest =>
      if t =? "or" then
        match parse_and n d rest with Some (g, ts) => more_or n d (Or f g) ts | None => None end
      else Some (f, ts)
  | S _, [] => Some (f, [])
  | O, _ => None
  end
with parse_and (n d : nat) (ts : list string) : option (formula * list string) :=
  match n with
  | O => None
  | S n => match parse_unit n d ts with Some (f, ts) => more_and n d f ts | None => None end
  end
with more_and (n d : nat) (f : formula) (ts : list string) : option (formula * list string) :=
  match n, ts with
  | S n, t :: rest =>
      if t =? "and" then
        match parse_unit n d rest with Some (g, ts) => more_and n d (And f g) ts | None => None end
      else Some (f, ts)
  | S _, [] => Some (f, [])
  | O, _ => None
  end
with parse_unit (n d : nat) (ts : list string) : option (formula * list string) :=
  match n, ts with
  | S n, t :: rest =>
      if t =? "{" then
        match d with
        | O => None
        | S d =>
            match parse_or n d rest with
            | Some (f, t :: ts) => require t =? "}" in Some (Braces f, ts)
            | _ => None
            end
        end
      else if t =? "false" then Some (False_, rest)
      else parse_chain d ts
  | _, _ => None
  end.

(** All of these tokens. *)
Definition whole {A} (read : option (A * list string)) : option A :=
  match read with Some (a, []) => Some a | _ => None end.
Definition parse_value (ts : list string) : option expr := whole (parse_expr max_nesting ts).
Definition parse_formula (ts : list string) : option formula := whole (parse_or (steps ts) max_nesting ts).

(** Statements *)

Inductive directive := Premise (p : premise) | ToFind (names : list string) | Show (f : formula).

Definition parse_directive (ts : list string) : option directive :=
  match ts with
  | [] => None
  | t :: rest =>
      if t =? "real" then Some (Premise (Real rest))
      else if t =? "exists" then Some (ToFind rest)
      else if t =? "show" then let* f := parse_formula rest in Some (Show f)
      else
        match rest with
        | name :: mark :: rest =>
            if t =? "let" then
              require mark =? "=" in let* e := parse_value rest in Some (Premise (Abbreviate (Let name e)))
            else
              require mark =? ":" in
              let* f := parse_formula rest in
              if t =? "define" then Some (Premise (Abbreviate (Define name f)))
              else require t =? "assume" in Some (Premise (Assume name f))
        | _ => None
        end
  end.

Fixpoint parse_abbreviations (ls : list line) (done : list abbreviation) : option (list abbreviation * formula) :=
  match ls with
  | [] => None
  | l :: rest =>
      let* found := parse_directive (words l) in
      match found, rest with
      | Premise (Abbreviate a), _ => parse_abbreviations rest (a :: done)
      | Show f, [] => Some (rev' done, f)
      | _, _ => None
      end
  end.

Fixpoint parse_premises (name : string) (ls : list line) (done : list premise) : option statement :=
  match ls with
  | [] => None
  | l :: rest =>
      let* found := parse_directive (words l) in
      match found, rest with
      | Premise p, _ => parse_premises name rest (p :: done)
      | ToFind unknowns, _ =>
          let* read := parse_abbreviations rest [] in
          Some (Statement name (rev' done) unknowns (fst read) (snd read))
      | Show f, [] => Some (Statement name (rev' done) [] [] f)
      | Show _, _ => None
      end
  end.

Fixpoint after_prefix (prefix s : string) : option string :=
  match prefix, s with
  | EmptyString, _ => Some s
  | String c p, String d r => require Ascii.eqb c d in after_prefix p r
  | _, _ => None
  end.

Fixpoint same_tokens (a b : list string) : bool :=
  match a, b with
  | [], [] => true
  | s :: a, t :: b => (s =? t) && same_tokens a b
  | _, _ => false
  end.

Fixpoint same_lines (a : list line) (b : list (list string)) : bool :=
  match a, b with
  | [], [] => true
  | l :: a, ts :: b => same_tokens (words l) ts && same_lines a b
  | _, _ => false
  end.

(** The statement that a text states ([Print.states]). *)
Definition parse_statement (ls : list line) : option statement :=
  match ls with
  | header :: title :: body =>
      require raw header =? "slipproof-statement 1" in
      let* name := after_prefix "theorem " (raw title) in
      let* s := parse_premises name body [] in
      require raw title =? "theorem " ++ theorem s in
      require same_lines body (print_statement s) && grouped_statement s in Some s
  | _ => None
  end.

(** Certificates *)

Fixpoint parse_factors (ts : list string) (done : list (string * nat)) : option (list (string * nat)) :=
  match ts with
  | [] => Some (rev' done)
  | name :: rest =>
      require is_name name in
      match rest with
      | mark :: after =>
          if mark =? "^" then
            match after with
            | k :: after => let* n := exponent k in parse_factors after ((name, n) :: done)
            | [] => None
            end
          else parse_factors rest ((name, 1) :: done)
      | [] => Some (rev' ((name, 1) :: done))
      end
  end.

Definition parse_summand (ts : list string) : option summand :=
  match ts with
  | t :: c :: rest =>
      if t =? "term" then let* factors := parse_factors rest [] in Some (Term c factors)
      else
        match rest with
        | mark :: rest =>
            require (t =? "equation") && (mark =? ":") && is_name c in
            let* q := parse_value rest in Some (Equation c q)
        | [] => None
        end
  | _ => None
  end.

(** Lines up to [qed]. *)
Fixpoint parse_identity (ls : list line) (done : identity) : option (identity * list line) :=
  match ls with
  | [] => None
  | l :: rest =>
      if same_tokens (words l) ["qed"] then Some (rev' done, rest)
      else let* s := parse_summand (words l) in parse_identity rest (s :: done)
  end.

Definition parse_claim (ts : list string) : option (expr * sign) :=
  match parse_expr max_nesting ts with
  | Some (p, [r; zero]) =>
      require zero =? "0" in
      if r =? ">=" then Some (p, NonNegative)
      else if r =? ">" then Some (p, Positive) else require r =? "=" in Some (p, Zero)
  | _ => None
  end.

(** Lines [set u = EXPRESSION]. *)
Fixpoint parse_values (unknowns : list string) (ls : list line) (done : list (string * expr))
  : option (list (string * expr) * list line) :=
  match unknowns, ls with
  | [], _ => Some (rev' done, ls)
  | u :: unknowns, l :: rest =>
      match words l with
      | set :: name :: mark :: ts =>
          require (set =? "set") && (name =? u) && (mark =? "=") in
          let* e := parse_value ts in parse_values unknowns rest ((u, e) :: done)
      | _ => None
      end
  | _, [] => None
  end.

Definition expect_raw (text : string) (ls : list line) : option (list line) :=
  match ls with l :: rest => require raw l =? text in Some rest | [] => None end.

Section Proofs.
Variable unknowns : list string.
(** In decimal. *)
Variable show_nat : nat -> string.

(** [n] bounds the steps, [d] the branches within branches. *)
Fixpoint parse_proof (n d : nat) (ls : list line) : option (proof * list line) :=
  match n, ls with
  | S n, l :: rest =>
      match words l with
      | rule :: more =>
          if rule =? "have" then
            match more with
            | name :: mark :: ts =>
                require is_name name && (mark =? ":") in
                let* claim := parse_claim ts in
                let* first := parse_identity rest [] in
                let* second := match snd claim with Zero => parse_identity (snd first) [] | _ => Some ([], snd first) end in
                match parse_proof n d (snd second) with
                | Some (p, ls) => Some (Have name (fst claim) (snd claim) (fst first) (fst second) p, ls)
                | None => None
                end
            | _ => None
            end
          else if rule =? "contradiction" then
            match more, parse_identity rest [] with
            | [], Some (i, ls) => Some (Contradiction i, ls)
            | _, _ => None
            end
          else if rule =? "cases" then
            match more with
            | [name] =>
                require is_name name in
                match parse_branches n d 1 rest with Some (bs, ls) => Some (Cases name bs, ls) | None => None end
            | _ => None
            end
          else if rule =? "witness" then
            match more with
            | [name] =>
                require is_name name in
                let* values := parse_values unknowns rest [] in
                match parse_proof n d (snd values) with
                | Some (p, ls) => Some (Witness name (fst values) p, ls)
                | None => None
                end
            | _ => None
            end
          else if rule =? "split" then
            match more, d with
            | name :: mark :: ts, S d =>
                require is_name name && (mark =? ":") in
                let* e := parse_value ts in
                let* ls := expect_raw "branch negative" rest in
                let* p := parse_proof n d ls in
                let* ls := expect_raw "branch zero" (snd p) in
                let* q := parse_proof n d ls in
                let* ls := expect_raw "branch positive" (snd q) in
                let* r := parse_proof n d ls in
                let* ls := expect_raw "end" (snd r) in
                Some (Split name e (fst p) (fst q) (fst r), ls)
            | _, _ => None
            end
          else None
      | [] => None
      end
  | _, _ => None
  end
with parse_branches (n d i : nat) (ls : list line) : option (branches * list line) :=
  match n, ls with
  | S n, l :: rest =>
      if raw l =? "end" then Some (End, rest)
      else
        match d with
        | S e =>
            require raw l =? "branch " ++ show_nat i in
            let* p := parse_proof n e rest in
            match parse_branches n d (S i) (snd p) with
            | Some (bs, ls) => Some (Branch (fst p) bs, ls)
            | None => None
            end
        | O => None
        end
  | _, _ => None
  end.
End Proofs.
