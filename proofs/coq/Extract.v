(** The checker in OCaml. The directives are those of the two files that come with Coq: [positive], [N] and [Z] become
    the integers of zarith, and their operations zarith's; [ascii] becomes [char], and [string] lists of these. *)
From Coq Require Import Extraction ExtrOcamlZBigInt ExtrOcamlString.
From Slipproof Require Import Checker.

Extraction Language OCaml.
Extraction "checker.ml" read_statement accepts_for is_undecided accepts.
