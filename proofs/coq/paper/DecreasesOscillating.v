(** The flip defect epsilon (c) = pi/2 - psi_c (pi) strictly decreases in c as long as the motion has not passed its return to
    psi = 0 at phi = pi, that is G (-c/b) >= pi; so on all of (-b, 0) where I >= 1 (the half of theorem 3 that concerns the oscillating motions, and
    proposition 4's "strictly decreasing", which covers the first implicit equation and the second, (27) to (29), at once). *)
Require Import Reals Lra Psatz Ratan.
From Coquelicot Require Import Coquelicot.
From Polhode Require Import HalfPhase Theorem1 Uniqueness Oscillation Symmetry Curve SwingInC.
From Polhode Require Phase.
Open Scope R_scope.
Local Notation P := Phase.P.

Section Decreases.
Variables a b : R.
Hypothesis Ha : 0 < a.
Hypothesis Hb : 0 < b < 1.
Notation I := (geometric_constant a b).

(** sin psi at phi = pi, which is cos epsilon. *)
Definition end_sine (u : R) := sqrt (1 - u) * sin (turn a b u PI).
Lemma end_sine_bounds u : 0 < u < 1 -> -1 < end_sine u < 1.
Proof. intros Hu. now apply rsin_bounds. Qed.
Lemma sin_at_pi u : 0 < u < 1 -> sin (oscillation_psi a b u PI) = end_sine u.
Proof. intros Hu. now apply sin_psi. Qed.
Lemma asin_order x y : -1 < x -> x < y -> y < 1 -> asin x < asin y.
Proof.
intros Hx L Hy. apply Rnot_le_lt. intros N. assert (B := asin_bound x). assert (B' := asin_bound y).
assert (sin (asin y) <= sin (asin x)) by (apply sin_incr_1; lra). rewrite !sin_asin in H by lra. lra.
Qed.
Theorem cos_epsilon c : -b < c < 0 -> cos (epsilon a b c) = end_sine (- c / b).
Proof.
intros H. destruct (oscillation_of_c b Hb c H) as [Hu _]. unfold epsilon. rewrite cos_shift. now apply sin_at_pi.
Qed.
Lemma epsilon_by_end_sine c : epsilon a b c = PI/2 - asin (end_sine (- c / b)).
Proof. reflexivity. Qed.

Lemma turn_G u : 0 < u < 1 -> turn a b u (G a b u) = PI.
Proof.
intros Hu. assert (E := P_half_turn a b u Ha Hb Hu 0). rewrite P_zero, !Rplus_0_l in E. rewrite <- E. now apply turn_P.
Qed.
Lemma turn_at_pi u : 0 < u < 1 -> PI <= G a b u -> 0 < turn a b u PI <= PI.
Proof.
intros Hu H. split; [apply turn_positive; trivial; apply PI_RGT_0|]. destruct H as [H|H].
- left. apply turn_below; trivial. rewrite <- (P_turn a b u Ha Hb Hu (G a b u)), turn_G in H; trivial.
- rewrite H at 1. right. now apply turn_G.
Qed.

(** The order of sin psi (pi) in u = -c/b. *)
Theorem end_sine_order u v : 0 < u -> u < v -> v < 1 -> PI <= G a b v -> end_sine v < end_sine u.
Proof.
intros Hu L Hv H. assert (PP := PI_RGT_0).
assert (V := turn_at_pi v ltac:(lra) H). assert (T := turn_order a b Ha Hb u v PI Hu L Hv PP ltac:(lra)).
assert (T0 := turn_positive a b Ha Hb u PI ltac:(lra) PP).
assert (Sv : 0 < sqrt (1 - v)) by (apply sqrt_lt_R0; lra). assert (Su : 0 < sqrt (1 - u)) by (apply sqrt_lt_R0; lra).
assert (Suv : sqrt (1 - v) < sqrt (1 - u)) by (apply sqrt_lt_1_alt; lra).
unfold end_sine. set (t := turn a b u PI) in *. set (w := turn a b v PI) in *.
assert (W0 : 0 <= sin w) by (apply sin_ge_0; lra).
destruct (Rle_lt_dec (PI/2) t) as [C|C].
- assert (D : sin w < sin t) by (apply sin_decreasing_1; lra).
  apply Rle_lt_trans with (sqrt (1 - u) * sin w); [apply Rmult_le_compat_r; lra|apply Rmult_lt_compat_l; lra].
- assert (R0 := ratio_bounds u v Hu L Hv). set (s := psi_of (ratio u v) w).
  assert (A : s < t). { apply turn_above; trivial; [lra|]. rewrite <- (P_turn a b v Ha Hb ltac:(lra) PI). apply smaller_u_is_ahead; trivial. exact (proj1 V). }
  assert (B := asin_bound (sqrt (1 - ratio u v) * sin w)). fold (psi_of (ratio u v) w) in B. fold s in B.
  assert (D : sin s < sin t) by (apply sin_increasing_1; lra).
  unfold s in D. rewrite sin_psi in D by trivial. apply (Rmult_lt_compat_l (sqrt (1 - u))) in D; trivial.
  rewrite <- Rmult_assoc, ratio_root in D; trivial.
Qed.

Lemma u_order c d : c < d -> - d / b < - c / b.
Proof. intros L. unfold Rdiv. apply Rmult_lt_compat_r; [apply Rinv_0_lt_compat|]; lra. Qed.
(** epsilon strictly decreases in c where G (-c/b) >= pi, that is from the crossing c* of epsilon = pi/2 (if there is one) up to c = 0. *)
Theorem epsilon_decreases c d : -b < c -> c < d -> d < 0 -> PI <= G a b (- c / b) -> epsilon a b d < epsilon a b c.
Proof.
intros Hc L Hd H. destruct (oscillation_of_c b Hb c ltac:(lra)) as [Hu _]. destruct (oscillation_of_c b Hb d ltac:(lra)) as [Hv _].
assert (O := u_order c d L). assert (S := end_sine_order (- d / b) (- c / b) ltac:(lra) O ltac:(lra) H).
rewrite !epsilon_by_end_sine. assert (B := end_sine_bounds (- c / b) Hu). assert (B' := end_sine_bounds (- d / b) Hv).
assert (A := asin_order _ _ (proj1 B) S (proj2 B')). lra.
Qed.
Lemma physical_G u : 1 <= I -> 0 < u < 1 -> PI < G a b u.
Proof.
intros H Hu. assert (L := proj2 (half_phase_infimum a b Ha Hb) u Hu). assert (PP := PI_RGT_0).
apply Rle_lt_trans with (2 := L). rewrite <- (Rmult_1_r PI) at 1. apply Rmult_le_compat_l; lra.
Qed.
(** Theorem 3, oscillating motions, I >= 1: epsilon strictly decreases on (-b, 0), *)
Theorem physical_epsilon_decreases c d : 1 <= I -> -b < c -> c < d -> d < 0 -> epsilon a b d < epsilon a b c.
Proof.
intros H Hc L Hd. apply epsilon_decreases; trivial. left. apply physical_G; trivial. now apply oscillation_of_c; trivial; lra.
Qed.
(** and stays below pi/2. *)
Theorem physical_epsilon_below c : 1 <= I -> -b < c < 0 -> 0 < epsilon a b c < PI/2.
Proof.
intros H Hc. destruct (oscillation_of_c b Hb c Hc) as [Hu _]. assert (PP := PI_RGT_0). rewrite epsilon_by_end_sine.
assert (T := turn_below a b Ha Hb (- c / b) PI PI Hu).
assert (E := P_turn a b (- c / b) Ha Hb Hu (G a b (- c / b))). rewrite turn_G in E by trivial.
specialize (T ltac:(rewrite E; now apply physical_G)). assert (T0 := turn_positive a b Ha Hb (- c / b) PI Hu PP).
assert (B := end_sine_bounds (- c / b) Hu).
assert (S : 0 < end_sine (- c / b)). { apply Rmult_lt_0_compat; [apply sqrt_lt_R0; lra|apply sin_gt_0; lra]. }
assert (A := asin_order 0 _ ltac:(lra) S (proj2 B)). rewrite asin_0 in A.
assert (A2 := asin_order (end_sine (- c / b)) ((end_sine (- c / b) + 1)/2) ltac:(lra) ltac:(lra) ltac:(lra)).
assert (A3 := asin_bound ((end_sine (- c / b) + 1)/2)). lra.
Qed.
End Decreases.
