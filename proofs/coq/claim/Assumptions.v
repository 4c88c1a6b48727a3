(** What the theorem rests on: the axioms of Coq's real numbers, and nothing else. *)
From Slipproof.claim Require Import Judge.
Print Assumptions proves_sound.
Print Assumptions judge_sound.
