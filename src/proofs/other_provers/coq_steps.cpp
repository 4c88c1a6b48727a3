#include "proofs/other_provers/coq_formula.hpp"

namespace slipproof::coq {

const char* const kSteps = R"coq(Module Steps.
(* Signs and products. *)
Lemma signs (x : real) : 0 < - x \/ x = 0 \/ 0 < x.
Proof. destruct (Rtotal_order x 0) as [H | [H | H]]; [left; lra | right; left; exact H | right; right; exact H]. Qed.
Lemma zero_or (x : real) : x = 0 \/ 0 < x \/ 0 < - x.
Proof. destruct (signs x) as [H | [H | H]]; auto. Qed.
Lemma positive_or (x : real) : 0 < x \/ 0 <= - x.
Proof. destruct (signs x) as [H | [H | H]]; [right | right | left]; lra. Qed.
Lemma non_negative_or (x : real) : 0 <= x \/ 0 < - x.
Proof. destruct (signs x) as [H | [H | H]]; [right | left | left]; lra. Qed.
Lemma nonzero_or (x : real) : x <> 0 \/ x = 0.
Proof. destruct (Req_dec x 0); auto. Qed.
Lemma mul [x y : real] : 0 < x -> 0 < y -> 0 < x * y.
Proof. exact (Rmult_lt_0_compat x y). Qed.
Lemma mul0 [x y : real] : 0 <= x -> 0 <= y -> 0 <= x * y.
Proof. exact (Rmult_le_pos x y). Qed.
Lemma power [x : real] (n : nat) : 0 < x -> 0 < x ^ n.
Proof. exact (pow_lt x n). Qed.
Lemma power0 [x : real] (n : nat) : 0 <= x -> 0 <= x ^ n.
Proof. exact (pow_le x n). Qed.
Lemma weak [x : real] : 0 < x -> 0 <= x.
Proof. exact (Rlt_le 0 x). Qed.
Lemma add [x y : real] : 0 < x -> 0 <= y -> 0 < x + y.
Proof. exact (Rplus_lt_le_0_compat x y). Qed.
Lemma multiple [x p : real] (q : real) : 0 < x -> p = 0 -> 0 < x + q * p.
Proof. intros H E. rewrite E, Rmult_0_r, Rplus_0_r. exact H. Qed.
Lemma absurd (x : real) : 0 < x -> x = 0 -> False.
Proof. intros H E. rewrite E in H. exact (Rlt_irrefl 0 H). Qed.
(* A formula or its negation. *)
Lemma either_false : False \/ True.
Proof. right; exact I. Qed.
Lemma either_true : True \/ False.
Proof. left; exact I. Qed.
Lemma either_and [A B A' B' : Prop] : A \/ A' -> B \/ B' -> A /\ B \/ A' \/ B'.
Proof. tauto. Qed.
Lemma either_or [A B A' B' : Prop] : A \/ A' -> B \/ B' -> (A \/ B) \/ A' /\ B'.
Proof. tauto. Qed.
(* x = n / d, without the division. *)
Definition frac (x n d : real) : Prop := d <> 0 /\ x * d = n.
Lemma frac_poly (x n : real) : x = n -> frac x n 1.
Proof. intros ->. split; lra. Qed.
Lemma frac_opp (x n d N : real) : frac x n d -> N = - n -> frac (- x) N d.
Proof. intros [D E] ->. split; [exact D | rewrite <- E; ring]. Qed.
Lemma frac_add_same (x y n m d N : real) : frac x n d -> frac y m d -> N = n + m -> frac (x + y) N d.
Proof. intros [D E] [_ E'] ->. split; [exact D | rewrite <- E, <- E'; ring]. Qed.
Lemma frac_sub_same (x y n m d N : real) : frac x n d -> frac y m d -> N = n - m -> frac (x - y) N d.
Proof. intros [D E] [_ E'] ->. split; [exact D | rewrite <- E, <- E'; ring]. Qed.
Lemma frac_add (x y n d m e N D : real) :
  frac x n d -> frac y m e -> N = n * e + m * d -> D = d * e -> frac (x + y) N D.
Proof. intros [H E] [H' E'] -> ->. split; [apply Rmult_integral_contrapositive; auto | rewrite <- E, <- E'; ring]. Qed.
Lemma frac_sub (x y n d m e N D : real) :
  frac x n d -> frac y m e -> N = n * e - m * d -> D = d * e -> frac (x - y) N D.
Proof. intros [H E] [H' E'] -> ->. split; [apply Rmult_integral_contrapositive; auto | rewrite <- E, <- E'; ring]. Qed.
Lemma frac_mul (x y n d m e N D : real) : frac x n d -> frac y m e -> N = n * m -> D = d * e -> frac (x * y) N D.
Proof. intros [H E] [H' E'] -> ->. split; [apply Rmult_integral_contrapositive; auto | rewrite <- E, <- E'; ring]. Qed.
Lemma frac_div (x y n d m e N D : real) :
  frac x n d -> frac y m e -> m <> 0 -> N = n * e -> D = d * m -> frac (x / y) N D.
Proof.
  intros [H E] [H' E'] M -> ->. split; [apply Rmult_integral_contrapositive; auto |].
  rewrite <- E. rewrite <- E' in M |- *. field. intro Y. apply M. rewrite Y. ring.
Qed.
Lemma frac_pow (k : nat) (x n d N D : real) : frac x n d -> N = n ^ k -> D = d ^ k -> frac (x ^ k) N D.
Proof. intros [H E] -> ->. split; [apply pow_nonzero; exact H | rewrite <- E, Rpow_mult_distr; reflexivity]. Qed.
(* Formulas with the same meaning: a comparison of fractions, and the sign of a polynomial. *)
Lemma same_and [A B A' B' : Prop] : (A <-> A') -> (B <-> B') -> (A /\ B <-> A' /\ B').
Proof. tauto. Qed.
Lemma same_or [A B A' B' : Prop] : (A <-> A') -> (B <-> B') -> (A \/ B <-> A' \/ B').
Proof. tauto. Qed.
Lemma forward [A B : Prop] : (A <-> B) -> A -> B.
Proof. tauto. Qed.
Lemma backward [A B : Prop] : (A <-> B) -> B -> A.
Proof. tauto. Qed.
Lemma nonzero (p : real) : p <> 0 <-> 0 < p \/ 0 < - p.
Proof. destruct (signs p) as [H | [H | H]]; split; intros; lra. Qed.
Lemma guard (x p d : real) [A A' : Prop] :
  frac x p d -> (p <> 0 -> (A <-> A')) -> (x <> 0 /\ A <-> (0 < p \/ 0 < - p) /\ A').
Proof.
  intros [D E] H. rewrite <- nonzero. assert (S : x <> 0 <-> p <> 0).
  { split; intros N Z; apply N; [| rewrite <- E, Z; ring].
    destruct (Rmult_integral x d) as [Y | Y]; [rewrite E; exact Z | exact Y | contradiction]. }
  tauto.
Qed.
Lemma known (p : real) [A A' : Prop] : p <> 0 -> (A <-> A') -> (A <-> (0 < p \/ 0 < - p) /\ A').
Proof. rewrite <- nonzero. tauto. Qed.
Lemma product_sign (x n d : real) : frac x n d -> n * d = x * (d * d) /\ 0 < d * d.
Proof. intros [D E]. split; [rewrite <- E; ring | exact (Rlt_0_sqr d D)]. Qed.
Lemma frac_gt (x y n d q : real) : frac (x - y) n d -> q = n * d -> (x > y <-> 0 < q).
Proof.
  intros F ->. destruct (product_sign _ _ _ F) as [-> S]. split; intros H.
  - apply mul; lra.
  - apply Rnot_le_gt. intros L. pose proof (Rmult_le_compat_r (d * d) (x - y) 0 (Rlt_le _ _ S) ltac:(lra)). lra.
Qed.
Lemma frac_ge (x y n d q : real) : frac (x - y) n d -> q = n * d -> (x >= y <-> 0 <= q).
Proof.
  intros F ->. destruct (product_sign _ _ _ F) as [-> S]. split; intros H.
  - apply mul0; lra.
  - apply Rnot_lt_ge. intros L. pose proof (Rmult_lt_compat_r (d * d) (x - y) 0 S ltac:(lra)). lra.
Qed.
Lemma frac_lt (x y n d q : real) : frac (x - y) n d -> q = - (n * d) -> (x < y <-> 0 < q).
Proof.
  intros F ->. destruct (product_sign _ _ _ F) as [-> S]. split; intros H.
  - replace (- ((x - y) * (d * d))) with ((y - x) * (d * d)) by ring. apply mul; lra.
  - apply Rnot_le_lt. intros L. pose proof (Rmult_le_compat_r (d * d) 0 (x - y) (Rlt_le _ _ S) ltac:(lra)). lra.
Qed.
Lemma frac_le (x y n d q : real) : frac (x - y) n d -> q = - (n * d) -> (x <= y <-> 0 <= q).
Proof.
  intros F ->. destruct (product_sign _ _ _ F) as [-> S]. split; intros H.
  - replace (- ((x - y) * (d * d))) with ((y - x) * (d * d)) by ring. apply mul0; lra.
  - apply Rnot_lt_le. intros L. pose proof (Rmult_lt_compat_r (d * d) 0 (x - y) S ltac:(lra)). lra.
Qed.
Lemma frac_eq (x y n d q : real) : frac (x - y) n d -> q = n -> (x = y <-> q = 0).
Proof.
  intros [D E] ->. rewrite <- E. split; intros H; [rewrite H; ring |].
  destruct (Rmult_integral _ _ H); [lra | contradiction].
Qed.
Lemma frac_ne (x y n d q : real) : frac (x - y) n d -> q = n -> (x <> y <-> 0 < q \/ 0 < - q).
Proof. intros F E. rewrite <- nonzero. pose proof (frac_eq x y n d q F E). tauto. Qed.
Lemma poly_gt (x y q : real) : x - y = q -> (x > y <-> 0 < q).
Proof. intros <-. split; lra. Qed.
Lemma poly_ge (x y q : real) : x - y = q -> (x >= y <-> 0 <= q).
Proof. intros <-. split; lra. Qed.
Lemma poly_lt (x y q : real) : y - x = q -> (x < y <-> 0 < q).
Proof. intros <-. split; lra. Qed.
Lemma poly_le (x y q : real) : y - x = q -> (x <= y <-> 0 <= q).
Proof. intros <-. split; lra. Qed.
Lemma poly_eq (x y q : real) : x - y = q -> (x = y <-> q = 0).
Proof. intros <-. split; lra. Qed.
Lemma poly_ne (x y q : real) : x - y = q -> (x <> y <-> 0 < q \/ 0 < - q).
Proof. intros <-. rewrite <- nonzero. split; lra. Qed.
End Steps.
)coq";

}  // namespace slipproof::coq
