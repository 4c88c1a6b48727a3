(** Reads certificates. Nothing rests on it: what was read is written and compared with the text. *)
From Coq Require Import Ascii String NArith ZArith List Bool FMapPositive.
From Slipproof Require Import Text.
From Slipproof.contact Require Import Coulomb Number Linear Zero Certificate Checker Motions Read.
Import ListNotations.
Local Open Scope string_scope.
Local Open Scope N_scope.

Section Claims.
  Variables (i : instance) (most : N).
  Let n := size_of_instance i.

  Definition read_eps : reader body := fun ts =>
    let* b := one_number ts in let* m := one_number (snd b) in
    let* x := numbers_after "point" n (snd m) in let* w := numbers_after "motion" n (snd x) in
    Some (Eps (fst b) (fst m) (fst x) (fst w), snd w).

  (** What enclosures, balls and boxes of motions have in common, and how many unknowns and equations are left. *)
  Definition read_box (i : instance) : reader ((list mode * list number * list number * list N * list (N * list (N * number)))
      * (N * N)) := fun ts =>
    let* _m := word "modes" ts in
    let* modes := some_modes (dim i) (frictions i) [] (snd _m) in
    let count := N.of_nat (List.length (unknowns (tables_of i) (fst modes))) in
    let* z := numbers_after "center" count (snd modes) in
    let* p := numbers_after "radius" count (snd z) in
    let* _p := word "pinned" (snd p) in
    let* np := counted most (snd _p) in
    let* pinned := some_indices (fst np) count (PositiveMap.empty unit) [] (snd np) in
    let* _d := word "dropped" (snd pinned) in
    let* nd := counted most (snd _d) in
    let* dropped := some_dropped (snd nd) most (fst nd) count (PositiveMap.empty unit) [] (snd nd) in
    Some ((fst modes, fst z, fst p, fst pinned, fst dropped, (count - fst np, count - fst nd)), snd dropped).

  Definition read_distance : reader (number * option number) := fun ts =>
    let* rho := one_number ts in
    if at_word "velocities" (snd rho)
    then let* e := one_number (tl (snd rho)) in Some ((fst rho, Some (fst e)), snd e) else Some ((fst rho, None), snd rho).

  Definition read_enclosure : reader body := fun ts =>
    let* distance := read_distance ts in let (rho, eta) := fst distance in
    match read_box i (snd distance) with
    | Some ((modes, z, p, pinned, dropped, (free_, kept)), r) =>
        let* a := matrix_after "inverse" most free_ kept r in
        Some (Enclosure rho eta modes z p pinned dropped (fst a), snd a)
    | None => None
    end.

  Definition read_ball : reader body := fun ts =>
    let* distance := read_distance ts in let (rho, eta) := fst distance in
    match read_box i (snd distance) with
    | Some ((modes, z, p, pinned, dropped, (free_, kept)), r) =>
        let* rows := numbers_after "rows" kept r in
        let* _s := word "least" (snd rows) in let* s := one_number (snd _s) in
        let* _f := word "defect" (snd s) in let* f := one_number (snd _f) in
        let* _q := word "bend" (snd f) in let* q := one_number (snd _q) in
        let* l := matrix_after "factor" most free_ free_ (snd q) in
        Some (Ball rho eta modes z p pinned dropped (fst rows) (fst s) (fst f) (fst q) (fst l), snd l)
    | None => None
    end.

  (** All motions *)
  Let small := Instance (dim i) 0 (frictions i) [] [] None.
  Let k := N.of_nat (List.length (frictions i)).
  Let forces := dim i * k.

  Definition read_distances : reader (option (list number)) := fun ts =>
    if at_word "within" ts then let* e := some_numbers forces [] (tl ts) in Some (Some (fst e), snd e) else Some (None, ts).

  Definition read_listed : reader listed := fun ts =>
    let* _m := word "motion" ts in
    if at_word "exact" (snd _m) then
      let* r := some_numbers forces [] (tl (snd _m)) in let* e := read_distances (snd r) in
      Some (Exact (fst r) (fst e), snd e)
    else
      let* _b := word "box" (snd _m) in
      match read_box small (snd _b) with
      | Some ((modes, z, p, pinned, dropped, (free_, kept)), r) =>
          let* a := matrix_after "inverse" most free_ kept r in
          let box := Boxed modes z p pinned dropped (fst a) in
          if at_word "alone" (snd a) then let* l := one_number (tl (snd a)) in Some (box (Alone (fst l)), snd l) else
          let* e := read_distances (snd a) in
          Some (box (match fst e with Some e => Within e | None => Bare end), snd e)
      | None => None
      end.

  Fixpoint some_listed (fuel : list string) (n : N) (done : list listed) (ts : list string) : option (list listed * list string) :=
    if n =? 0 then Some (rev' done, ts) else
    match fuel with
    | [] => None
    | _ :: fuel => let* m := read_listed ts in some_listed fuel (N.pred n) (fst m :: done) (snd m)
    end.

  Fixpoint some_directions (n : N) (done : list direction) (ts : list string) : option (list direction * list string) :=
    if n =? 0 then Some (rev' done, ts) else
    match ts with
    | a :: b :: r => let* x := number_of a in let* y := number_of b in some_directions (N.pred n) ((x, y) :: done) r
    | _ => None
    end.

  Definition directions_of : reader (list direction) := fun ts =>
    let* n := counted most ts in some_directions (fst n) [] (snd n).

  Fixpoint some_multipliers (fuel : list bound) (done : list (list number)) (ts : list string) :
      option (list (list number) * list string) :=
    match fuel with
    | [] => Some (rev' done, ts)
    | _ :: fuel => let* y := some_numbers forces [] ts in some_multipliers fuel (fst y :: done) (snd y)
    end.

  Fixpoint some_squares (fuel : list string) (n : N) (done : list (number * list number)) (ts : list string) :
      option (list (number * list number) * list string) :=
    if n =? 0 then Some (rev' done, ts) else
    match fuel with
    | [] => None
    | _ :: fuel =>
        let* d := one_number ts in let* l := some_numbers forces [] (snd d) in
        some_squares fuel (N.pred n) ((fst d, fst l) :: done) (snd l)
    end.

  (** How many multipliers a known case has depends on its pattern. *)
  Definition read_node (motions : PositiveMap.t listed) (count : N) (s : pattern) : reader node := fun ts =>
    if at_word "decide" ts then let* k := index_below k (tl ts) in Some (Decide (fst k), snd k) else
    if at_word "slips" ts then
      let* k := index_below k (tl ts) in
      if N.ltb (dim i) 3 then Some (Slips (fst k) [], snd k)
      else let* l := directions_of (snd k) in Some (Slips (fst k) (fst l), snd l)
    else
    if at_word "arcs" ts then
      let* k := index_below k (tl ts) in let* l := directions_of (snd k) in Some (Arcs (fst k) (fst l), snd l) else
    if at_word "empty" ts then let* y := some_numbers forces [] (tl ts) in Some (Empty (fst y), snd y) else
    if at_word "frictionless" ts then
      let* m := index_below count (tl ts) in let* n := counted most (snd m) in
      let* l := some_squares ts (fst n) [] (snd n) in Some (Frictionless (fst m) (fst l), snd l)
    else
    let* _k := word "known" ts in
    let* m := index_below count (snd _k) in
    let* ys := some_multipliers (bounds_of (tables_of small) s (look (Exact [] None) motions (fst m))) [] (snd m) in
    Some (Known (fst m) (fst ys), snd ys).

  Fixpoint some_nodes (fuel : list string) (motions : PositiveMap.t listed) (count : N) (patterns : list pattern) (done : list node)
      (ts : list string) : option (list node * list string) :=
    match patterns with
    | [] => Some (rev' done, ts)
    | s :: rest =>
        match fuel with
        | [] => None
        | _ :: fuel =>
            let* n := read_node motions count s ts in
            some_nodes fuel motions count (children (dim i) (fst n) s ++ rest) (fst n :: done) (snd n)
        end
    end.

  Definition read_all_solutions : reader body := fun ts =>
    let* m := counted most ts in
    let* b := (if frees i =? 0 then Some (None, snd m)
               else let* b := matrix_after "eliminated" most (frees i) (frees i) (snd m) in Some (Some (fst b), snd b)) in
    let* l := some_listed ts (fst m) [] (snd b) in
    let* t := some_nodes ts (tabulate 0 (fst l) (PositiveMap.empty listed)) (fst m) [PositiveMap.empty state] [] (snd l) in
    Some (AllSolutions (fst b) (fst l) (fst t), snd t).

  (** Unknowns that are accelerations; at most as many as are free. *)
  Definition accelerations_of : reader N := index_below (N.succ (frees i)).

  Definition read_claim : reader body := fun ts =>
    if at_word "rest" ts then
      let* v := accelerations_of (tl ts) in
      let* x := numbers_after "forces" (n - fst v) (snd v) in Some (Rest (fst v) (fst x), snd x)
    else
    if at_word "no-rest" ts then
      let* v := accelerations_of (tl ts) in
      let* y := numbers_after "multipliers" (fst v) (snd v) in Some (NoRest (fst v) (fst y), snd y)
    else
    if at_word "eps" ts then read_eps (tl ts) else
    if at_word "enclosure" ts then read_enclosure (tl ts) else
    if at_word "ball" ts then read_ball (tl ts) else
    if at_word "all-solutions" ts then read_all_solutions (tl ts) else
    if at_word "none-within" ts then let* rho := one_number (tl ts) in Some (NoneWithin (fst rho), snd rho) else
    if at_word "no-solution" ts then let* y := numbers_after "multipliers" n (tl ts) in Some (NoSolution (fst y), snd y) else
    if at_word "unique" ts && at_word "definite" (tl ts)
    then let* l := matrix_after "definite" most n n (tl ts) in Some (Definite (fst l), snd l) else
    if at_word "unique" ts then let* d := numbers_after "dominant" n (tl ts) in Some (Dominant (fst d), snd d) else
    None.
End Claims.

(** Claims that this checker does not know. *)
Definition unknown_claim (ts : list string) : bool :=
  at_word "every-solution" ts
  || (at_word "unique" ts && existsb (fun w => at_word w (tl ts)) ["bound"; "determinants"]).

(** Forms of a matrix, or of a proof of a ball, that it does not know. *)
Definition unknown_form (ts : list string) : bool := existsb (fun t => existsb (String.eqb t) ["mirrored"; "order"]) ts.

Inductive outcome := Unreadable | NotCovered | Claims (l : list body).

Fixpoint some_claims (fuel : list string) (i : instance) (most : N) (done : list body) (ts : list string) : outcome :=
  match fuel with
  | [] => Unreadable
  | _ :: fuel =>
      if unknown_claim ts then NotCovered else
      match read_claim i most ts with
      | None => if unknown_form ts then NotCovered else Unreadable
      | Some (b, r) =>
          if at_word "end" r then match r with [_] => Claims (rev' (b :: done)) | _ => Unreadable end
          else some_claims fuel i most (b :: done) r
      end
  end.

Definition is_problem_name (s : string) : bool :=
  (length_onto s 0 =? 64) && all_in (fun c => match digit_in 16 c with Some _ => true | None => false end) s.

Definition read_header (most : N) : reader (option string * (list number * (N * N)) * (list (N * N * number) * list number)) :=
  fun ts =>
    let* _a := word "slipproof-contact" ts in let* _b := word "1" (snd _a) in
    let* name := (if at_word "problem" (snd _b)
                  then match tl (snd _b) with
                       | s :: r => require is_problem_name s in Some (Some s, r)
                       | [] => None
                       end
                  else Some (None, snd _b)) in
    let* _c := word "dimension" (snd name) in let* d := index_below 4 (snd _c) in
    require existsb (fun w => at_word w (snd _c)) ["1"; "2"; "3"] in
    let* _d := word "free" (snd d) in let* f := counted most (snd _d) in
    let* _e := word "contacts" (snd f) in let* k := counted most (snd _e) in
    let* mus := numbers_after "mu" (fst k) (snd k) in
    let n := fst f + fst d * fst k in
    require N.leb n most in
    let* a := matrix_after "matrix" most n n (snd mus) in
    let* c := numbers_after "constant" n (snd a) in
    Some ((fst name, (fst mus, (fst d, fst f)), (fst a, fst c)), snd c).

Inductive file := UnreadableFile | NotCoveredFile | File (c : certificate) (ts : list string).

Definition read (text : string) : file :=
  match tokens text with
  | None => UnreadableFile
  | Some ts =>
      let most := N.div (length_onto text 0) 2 in
      match read_header most ts with
      | None => if unknown_form ts then NotCoveredFile else UnreadableFile
      | Some ((name, (mus, (d, f)), (a, c)), r) =>
          if at_word "law" r then NotCoveredFile else
          let i := Instance d f mus a c None in
          match (if at_word "no-answer" r then Some (None, tl r)
                 else let* x := numbers_after "answer" (size_of_instance i) r in Some (Some (fst x), snd x)) with
          | None => UnreadableFile
          | Some (x, r) =>
              let i := Instance d f mus a c x in
              match some_claims r i most [] r with
              | Unreadable => UnreadableFile
              | NotCovered => NotCoveredFile
              | Claims l => File (Certificate name i l) ts
              end
          end
      end
  end.

(** The tokens of the file are those of the certificate. *)
Definition spells_piece (token : string) (p : piece) : bool :=
  match p with
  | Word s => (token =? s)%string
  | Count n => match natural token with Some m => N.eqb m n | None => false end
  | Numeral x => match number_of token with Some y => same y x | None => false end
  end.

Fixpoint spells_all (ts : list string) (ps : list piece) : bool :=
  match ts, ps with
  | [], [] => true
  | t :: ts, p :: ps => spells_piece t p && spells_all ts ps
  | _, _ => false
  end.

Definition check_body (i : instance) (p : tables) (b : body) : bool :=
  match b, answer i with
  | Eps bound moved point motions, Some x => check_eps p x bound moved point motions
  | Enclosure rho eta modes center radius pinned dropped inverse, Some x =>
      check_enclosure p x rho eta modes center radius pinned dropped inverse
  | Ball rho eta modes center radius pinned dropped rows least defect bend factor, Some x =>
      check_ball p x rho eta modes center radius pinned dropped rows least defect bend factor
  | NoneWithin rho, Some x => check_none_within p x rho
  | NoSolution y, _ => check_no_solution p y
  | Rest v x, _ => check_rest p v x
  | NoRest v y, _ => check_no_rest p v y
  | Dominant d, _ => check_dominant p d
  | Definite l, _ => check_definite p (entries i) l
  | AllSolutions eliminated motions tree, _ => check_all_solutions i eliminated motions tree
  | _, None => false
  end.

Definition check (c : certificate) : bool :=
  let i := about c in let p := tables_of i in
  is_whole i && is_proper i && negb (match claims c with [] => true | _ => false end) && forallb (check_body i p) (claims c).

Inductive verdict := Accepted | Rejected | Refused (* unreadable *) | Unknown (* not covered *).

Definition judge (f : file) : verdict :=
  match f with
  | UnreadableFile => Refused
  | NotCoveredFile => Unknown
  | File c ts => if spells_all ts (pieces c) && check c then Accepted else Rejected
  end.

Definition accepts (text : string) : bool := match judge (read text) with Accepted => true | _ => false end.
