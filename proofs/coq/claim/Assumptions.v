(** What the theorem rests on: the axioms of Coq's real numbers, and nothing else. *)
From Slipproof.claim Require Import Run Judge.
Print Assumptions run_sound.
Print Assumptions judge_sound.
