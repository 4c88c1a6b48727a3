(** The judge in OCaml; the directives are those of [Extract.v] of the checker. *)
From Coq Require Import Extraction ExtrOcamlZBigInt ExtrOcamlString.
From Slipproof Require Import Text Checker.
From Slipproof.claim Require Import Canonical Run Judge.

Extraction Language OCaml.
Extraction "judge.ml" read_statement accepts_for is_undecided lines stated judge claim_of run no_point.
