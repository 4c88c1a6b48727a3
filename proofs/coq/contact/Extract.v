(** The checker of contact certificates in OCaml, by the directives of ../Extract.v. *)
From Coq Require Import Extraction ExtrOcamlZBigInt ExtrOcamlString.
From Slipproof.contact Require Import Parse Different.

Extraction Language OCaml.
Extraction "contact_checker.ml" read judge accepts are_different greatest_reach.
