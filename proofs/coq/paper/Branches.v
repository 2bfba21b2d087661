(** Appendix B: the curve C on all of -b < c < 0, between its meeting points with S. There (n - 1/2) G < pi < (n + 1/2) G for one n,
    the number of the meeting points passed, G = G(-c/b) the half phase; with F = F(c, u'), u' = sin^2 eps, C is given by
      2 n G - F = 2 pi   where n is odd and eps < pi/2 (50), or n is even and eps > pi/2 (52),
      2 n G + F = 2 pi   where n is odd and eps >= pi/2 (51), or n is even and eps <= pi/2 (53).
    n = 0 is the first implicit equation, n = 1 the second, (28) and (29). F is that of FirstEquation.v, F a b c e with the angle e = arcsin sqrt u'
    in (0, pi/2]: e = eps or pi - eps. *)
Require Import Reals Lra Lia Psatz Arith.
From Coquelicot Require Import Coquelicot.
From Polhode Require HalfPhase FirstEquation.
From Polhode Require Import Uniqueness Oscillation Symmetry Curve FirstBranch.
Open Scope R_scope.
Local Notation F := FirstEquation.F.
Local Notation regular := FirstEquation.regular.
Local Notation G := HalfPhase.G.

Section Branches.
Variables a b : R.
Hypothesis Ha : 0 < a.
Hypothesis Hb : 0 < b < 1.

(** C and S have met n times on the way from c = 0 down to c. *)
Definition after_meetings (n : nat) (c : R) := -b < c < 0 /\ (INR n - 1/2) * G a b (- c / b) < PI < (INR n + 1/2) * G a b (- c / b).
(** e is in the region of F(c, e), where C has not reached S; at e = pi/2 the integral is empty. *)
Definition reached (c e : R) := e = PI/2 \/ regular b c e.
Definition odd_sign (n : nat) : R := if Nat.even n then 1 else -1.

Lemma F_empty c : F a b c (PI/2) = 0.
Proof.
unfold FirstEquation.F. replace (PI/2 - PI/2) with 0 by ring. rewrite (RInt_point (V:=R_CompleteNormedModule)). unfold zero; simpl. ring.
Qed.
Lemma F_not_negative c e : reached c e -> 0 <= F a b c e.
Proof. intros [->|H]. rewrite F_empty; lra. left. now apply (FirstEquation.F_pos a b Ha Hb). Qed.
(** One e for one value of F. *)
Lemma F_one_e c d e : reached c d -> reached c e -> F a b c d = F a b c e -> d = e.
Proof.
intros [->|D] [->|E] H; trivial; try rewrite F_empty in H.
- assert (P := FirstEquation.F_pos a b Ha Hb c e E). lra.
- assert (P := FirstEquation.F_pos a b Ha Hb c d D). lra.
- destruct (Rtotal_order d e) as [L|[L|L]]; trivial.
  + assert (P := FirstEquation.F_decreasing_e a b Ha Hb c d e D (conj L (proj1 E))). lra.
  + assert (P := FirstEquation.F_decreasing_e a b Ha Hb c e d E (conj L (proj1 D))). lra.
Qed.

Section AtC.
Variable n : nat.
Variable c : R.
Hypothesis N : after_meetings n c.
Notation u := (- c / b).
Notation g := (G a b u).
Notation r := (PI - INR n * g).
Notation psi := (oscillation_psi a b u).
Lemma Hu : 0 < u < 1. Proof. apply (oscillation_of_c b Hb c (proj1 N)). Qed.
Lemma centred : centred_motion a b c psi (oscillation_theta a b u).
Proof. assert (M := centred_oscillation a b Ha Hb u Hu). destruct (oscillation_of_c b Hb c (proj1 N)) as [_ E]. now rewrite E in M. Qed.
Lemma centred_u : centred_motion a b (- b * u) psi (oscillation_theta a b u).
Proof. exact (centred_oscillation a b Ha Hb u Hu). Qed.
Lemma g_positive : 0 < g. Proof. exact (G_pos a b u Ha Hb Hu). Qed.
Lemma r_range : - g / 2 < r < g / 2. Proof. destruct N as [_ [H1 H2]]. lra. Qed.

(** psi_c (phi + k G) = (-1)^k psi_c (phi). *)
Lemma sweeps k phi : psi (phi + INR k * g) = odd_sign k * psi phi.
Proof.
unfold odd_sign. induction k as [|k IH]. { simpl. rewrite Rmult_0_l, Rplus_0_r. ring. }
rewrite S_INR. replace (phi + (INR k + 1) * g) with ((phi + INR k * g) + g) by ring.
rewrite (proj1 (half_phase_symmetry a b Ha Hb u Hu psi _ centred_u (phi + INR k * g))), IH.
rewrite Nat.even_succ, <- Nat.negb_even. destruct (Nat.even k); simpl; ring.
Qed.
Lemma psi_at_pi : psi PI = odd_sign n * psi r.
Proof. rewrite <- sweeps. f_equal. ring. Qed.
(** A sweep from psi = 0 on, before the turning point. *)
Lemma sweep s : 0 <= s < g / 2 -> (s = 0 /\ psi s = 0 \/ 0 < s /\ 0 < psi s) /\ reached c (PI/2 - psi s) /\ F a b c (PI/2 - psi s) = 2 * s.
Proof.
intros Hs. destruct (Rle_lt_or_eq_dec 0 s (proj1 Hs)) as [L|<-].
- destruct (rising_sweep a b Ha Hb c psi _ centred s L) as [Rg E].
  { intros phi Hp. apply (rises_to_first_turning_point a b Ha Hb u Hu psi _ centred_u). lra. }
  split; [right; split; [exact L|destruct Rg; lra]|]. split; [now right|exact E].
- assert (Z : psi 0 = 0) by apply centred. rewrite Z, Rminus_0_r, F_empty. split; [now left|]. split; [now left|ring].
Qed.
Lemma odd phi : psi (- phi) = - psi phi.
Proof. exact (psi_odd a b Ha Hb u psi _ centred_u phi). Qed.

(** The defect, by the sign of r. *)
Lemma after : 0 <= r -> 0 <= psi r /\ reached c (PI/2 - psi r) /\ 2 * INR n * g + F a b c (PI/2 - psi r) = 2*PI.
Proof. intros H. destruct (sweep r) as [S [R E]]. { assert (Q := r_range). lra. } split; [|split; [exact R|rewrite E; ring]]. destruct S as [[_ ->]|[_ S]]; lra. Qed.
Lemma before : r < 0 -> psi r < 0 /\ reached c (PI/2 + psi r) /\ 2 * INR n * g - F a b c (PI/2 + psi r) = 2*PI.
Proof.
intros H. destruct (sweep (- r)) as [S [R E]]. { assert (Q := r_range). lra. }
rewrite odd in *. replace (PI/2 - - psi r) with (PI/2 + psi r) in * by ring. split; [|split; [exact R|rewrite E; ring]]. destruct S as [[S _]|[_ S]]; lra.
Qed.
Lemma on_C eps : curve_C a b c eps <-> eps = PI/2 - odd_sign n * psi r.
Proof.
rewrite (curve_C_epsilon a b Ha Hb c eps (proj1 N)). unfold epsilon. now rewrite psi_at_pi.
Qed.

(** Which of the signs of r an equation has. *)
Lemma minus_is_before e : reached c e -> e <> PI/2 -> 2 * INR n * g - F a b c e = 2*PI -> r < 0.
Proof. intros [->|H] D E; [lra|]. assert (P := FirstEquation.F_pos a b Ha Hb c e H). lra. Qed.
Lemma plus_is_after e : reached c e -> 2 * INR n * g + F a b c e = 2*PI -> 0 <= r.
Proof. intros H E. assert (P := F_not_negative c e H). lra. Qed.

Ltac parity H := assert (Sg : odd_sign n = -1 \/ odd_sign n = 1) by (unfold odd_sign; destruct (Nat.even n); lra);
  unfold odd_sign in *; first [rewrite (proj2 (Nat.even_spec n) H) in * | (rewrite <- Nat.negb_odd in *; rewrite (proj2 (Nat.odd_spec n) H) in *; simpl negb in *)].

(** Equation (50). *)
Theorem equation_50 eps : Nat.Odd n -> eps < PI/2 -> (curve_C a b c eps <-> regular b c eps /\ 2 * INR n * g - F a b c eps = 2*PI).
Proof.
intros H L. rewrite on_C. parity H. split.
- intros E. destruct (Rle_or_lt 0 r) as [A|B].
  + destruct (after A) as [S _]. lra.
  + destruct (before B) as [S [R Q]]. replace (PI/2 + psi r) with eps in * by lra. split; [|exact Q]. destruct R as [R|R]; [lra|exact R].
- intros [R E]. assert (B := minus_is_before eps (or_intror R) ltac:(lra) E). destruct (before B) as [S [R' Q]].
  assert (eps = PI/2 + psi r) by (apply (F_one_e c); trivial; [now right|lra]). lra.
Qed.
(** Equation (51). *)
Theorem equation_51 eps : Nat.Odd n -> PI/2 <= eps -> (curve_C a b c eps <-> reached c (PI - eps) /\ 2 * INR n * g + F a b c (PI - eps) = 2*PI).
Proof.
intros H L. rewrite on_C. parity H. split.
- intros E. destruct (Rle_or_lt 0 r) as [A|B].
  + destruct (after A) as [S [R Q]]. replace (PI/2 - psi r) with (PI - eps) in * by lra. now split.
  + destruct (before B) as [S _]. lra.
- intros [R E]. assert (A := plus_is_after _ R E). destruct (after A) as [S [R' Q]].
  assert (PI - eps = PI/2 - psi r) by (apply (F_one_e c); trivial; lra). lra.
Qed.
(** Equation (52). *)
Theorem equation_52 eps : Nat.Even n -> PI/2 < eps -> (curve_C a b c eps <-> regular b c (PI - eps) /\ 2 * INR n * g - F a b c (PI - eps) = 2*PI).
Proof.
intros H L. rewrite on_C. parity H. split.
- intros E. destruct (Rle_or_lt 0 r) as [A|B].
  + destruct (after A) as [S _]. lra.
  + destruct (before B) as [S [R Q]]. replace (PI/2 + psi r) with (PI - eps) in * by lra. split; [|exact Q]. destruct R as [R|R]; [lra|exact R].
- intros [R E]. assert (B := minus_is_before (PI - eps) (or_intror R) ltac:(lra) E). destruct (before B) as [S [R' Q]].
  assert (PI - eps = PI/2 + psi r) by (apply (F_one_e c); trivial; [now right|lra]). lra.
Qed.
(** Equation (53). *)
Theorem equation_53 eps : Nat.Even n -> eps <= PI/2 -> (curve_C a b c eps <-> reached c eps /\ 2 * INR n * g + F a b c eps = 2*PI).
Proof.
intros H L. rewrite on_C. parity H. split.
- intros E. destruct (Rle_or_lt 0 r) as [A|B].
  + destruct (after A) as [S [R Q]]. replace (PI/2 - psi r) with eps in * by lra. now split.
  + destruct (before B) as [S _]. lra.
- intros [R E]. assert (A := plus_is_after _ R E). destruct (after A) as [S [R' Q]].
  assert (eps = PI/2 - psi r) by (apply (F_one_e c); trivial; lra). lra.
Qed.
End AtC.
End Branches.
