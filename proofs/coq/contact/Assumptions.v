(** What the theorems rest on: the axioms of Coq's real numbers, and nothing else. *)
From Slipproof.contact Require Import Sound Different.
Print Assumptions check_sound.
Print Assumptions accepts_sound.
Print Assumptions all_solutions_in_words.
