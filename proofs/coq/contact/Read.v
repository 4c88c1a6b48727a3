(** Reads what certificates consist of: numbers, entries, modes. *)
From Coq Require Import Ascii String NArith ZArith List Bool FMapPositive.
From Slipproof Require Import Text.
From Slipproof.contact Require Import Coulomb Number Linear Certificate.
Import ListNotations.
Local Open Scope string_scope.
Local Open Scope N_scope.

(** What was read, and the tokens that follow. *)
Definition reader (A : Type) := list string -> option (A * list string).

Definition word (s : string) : reader unit := fun ts =>
  match ts with t :: r => if (t =? s)%string then Some (tt, r) else None | [] => None end.

Definition at_word (s : string) (ts : list string) : bool := match ts with t :: _ => (t =? s)%string | [] => false end.

Definition index : reader N := fun ts =>
  match ts with t :: r => require at_most 19 t in let* n := natural t in Some (n, r) | [] => None end.

Definition index_below (n : N) : reader N := fun ts =>
  let* x := index ts in require N.ltb (fst x) n in Some x.

(** How many of something follow, at most half the size of the file. *)
Definition counted (most : N) : reader N := index_below (N.succ most).

Definition one_number : reader number := fun ts =>
  match ts with t :: r => let* x := number_of t in Some (x, r) | [] => None end.

Fixpoint some_numbers (n : N) (done : list number) (ts : list string) : option (list number * list string) :=
  if n =? 0 then Some (rev' done, ts) else
  match ts with t :: r => let* x := number_of t in some_numbers (N.pred n) (x :: done) r | [] => None end.

Definition numbers_after (s : string) (n : N) : reader (list number) := fun ts =>
  let* x := word s ts in some_numbers n [] (snd x).

Fixpoint some_entries (n rows columns : N) (seen : PositiveMap.t unit) (done : list (N * N * number)) (ts : list string) :
    option (list (N * N * number) * list string) :=
  if n =? 0 then Some (rev' done, ts) else
  match ts with
  | a :: b :: c :: r =>
      let* i := index_below rows [a] in let* j := index_below columns [b] in let* x := number_of c in
      let k := key (fst i * columns + fst j) in
      require negb (PositiveMap.mem k seen) in
      some_entries (N.pred n) rows columns (PositiveMap.add k tt seen) ((fst i, fst j, x) :: done) r
  | _ => None
  end.

Definition matrix_after (s : string) (most rows columns : N) : reader (list (N * N * number)) := fun ts =>
  let* x := word s ts in let* n := counted most (snd x) in
  some_entries (fst n) rows columns (PositiveMap.empty unit) [] (snd n).

Fixpoint some_indices (n below : N) (seen : PositiveMap.t unit) (done : list N) (ts : list string) : option (list N * list string) :=
  if n =? 0 then Some (rev' done, ts) else
  match ts with
  | a :: r =>
      let* i := index_below below [a] in
      require negb (PositiveMap.mem (key (fst i)) seen) in
      some_indices (N.pred n) below (PositiveMap.add (key (fst i)) tt seen) (fst i :: done) r
  | [] => None
  end.

(** Columns and numbers. *)
Fixpoint some_columns (n below : N) (seen : PositiveMap.t unit) (done : list (N * number)) (ts : list string) :
    option (list (N * number) * list string) :=
  if n =? 0 then Some (rev' done, ts) else
  match ts with
  | a :: b :: r =>
      let* i := index_below below [a] in let* x := number_of b in
      require negb (PositiveMap.mem (key (fst i)) seen) in
      some_columns (N.pred n) below (PositiveMap.add (key (fst i)) tt seen) ((fst i, x) :: done) r
  | _ => None
  end.

Definition row_of_columns (most below : N) : reader (list (N * number)) := fun ts =>
  let* n := counted most ts in some_columns (fst n) below (PositiveMap.empty unit) [] (snd n).

(** The fuel is a list that is longer than what can be read. *)
Fixpoint some_dropped (fuel : list string) (most n below : N) (seen : PositiveMap.t unit) (done : list (N * list (N * number)))
    (ts : list string) : option (list (N * list (N * number)) * list string) :=
  if n =? 0 then Some (rev' done, ts) else
  match fuel with
  | [] => None
  | _ :: fuel =>
      let* i := index_below below ts in
      require negb (PositiveMap.mem (key (fst i)) seen) in
      let* c := row_of_columns most below (snd i) in
      some_dropped fuel most (N.pred n) below (PositiveMap.add (key (fst i)) tt seen) ((fst i, fst c) :: done) (snd c)
  end.

Definition one_mode (d : N) (m : number) (t : string) : option mode :=
  let friction := N.ltb 1 d && negb (is_zero m) in
  if (t =? "open")%string then Some Open else
  if (t =? "touch")%string then Some Touch else
  if (t =? "stick")%string then Some Stick else
  if ((t =? "slide")%string && friction && (d =? 3)) then Some Slide else
  if ((t =? "slide+")%string && friction && (d =? 2)) then Some SlidePlus else
  if ((t =? "slide-")%string && friction && (d =? 2)) then Some SlideMinus else None.

Fixpoint some_modes (d : N) (mus : list number) (done : list mode) (ts : list string) : option (list mode * list string) :=
  match mus, ts with
  | [], _ => Some (rev' done, ts)
  | m :: mus, t :: r => let* s := one_mode d m t in some_modes d mus (s :: done) r
  | _, [] => None
  end.
