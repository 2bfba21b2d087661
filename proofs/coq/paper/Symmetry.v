(** The symmetries of the reduced system (18), (19), and what uniqueness makes of them: the motion through psi = 0 is odd, every motion is
    mirrored at its turning points, and an oscillating motion satisfies psi (phi + G) = - psi phi, G the half phase. The curve C of the
    tennis racket effect rests on these (proofs/arguments/count.md). *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Polhode Require Import HalfPhase Uniqueness Oscillation.
Open Scope R_scope.

Lemma minus_derive d t : is_derive (fun t => d - t) t (-1).
Proof. auto_derive; trivial. Qed.
Lemma reflected_derive (f : R -> R) (d phi l : R) : is_derive f (d - phi) l -> is_derive (fun phi => f (d - phi)) phi (- l).
Proof.
intros D. evar_last. apply (is_derive_comp f (fun phi => d - phi) phi _ _ D (minus_derive d phi)).
unfold scal; simpl; unfold mult; simpl. ring.
Qed.
Lemma shifted_derive (f : R -> R) (d phi l : R) : is_derive f (phi + d) l -> is_derive (fun phi => f (phi + d)) phi l.
Proof.
intros D. evar_last. apply (is_derive_comp f (fun phi => phi + d) phi _ _ D (shift_derive d phi)).
unfold scal; simpl; unfold mult; simpl. ring.
Qed.

Section Symmetry.
Variables a b : R.
Hypothesis Ha : 0 < a.
Hypothesis Hb : 0 < b < 1.

(** * The system keeps its form *)
(** under a shift of phi, *)
Theorem shift_symmetry psi theta d : reduced_motion a b psi theta ->
  reduced_motion a b (fun phi => psi (phi + d)) (fun phi => theta (phi + d)).
Proof. intros M phi. destruct (M (phi + d)) as [A B]. split; now apply shifted_derive. Qed.
(** under (psi, phi) -> (-psi, d - phi), *)
Theorem psi_symmetry psi theta d : reduced_motion a b psi theta ->
  reduced_motion a b (fun phi => - psi (d - phi)) (fun phi => theta (d - phi)).
Proof.
intros M phi. destruct (M (d - phi)) as [A B]. split.
- evar_last. apply (is_derive_opp (fun phi => psi (d - phi))), reflected_derive, A.
  unfold opp; simpl. unfold psi_rate. rewrite cos_neg. ring.
- evar_last. apply reflected_derive, B. unfold theta_rate. rewrite cos_neg, sin_neg. unfold Rdiv. ring.
Qed.
(** and under (theta, phi) -> (pi - theta, d - phi). *)
Lemma cos_supplement q : cos (PI - q) = - cos q.
Proof. rewrite cos_minus, cos_PI, sin_PI. ring. Qed.
Theorem theta_symmetry psi theta d : reduced_motion a b psi theta ->
  reduced_motion a b (fun phi => psi (d - phi)) (fun phi => PI - theta (d - phi)).
Proof.
intros M phi. destruct (M (d - phi)) as [A B]. split.
- evar_last. apply reflected_derive, A. unfold psi_rate. rewrite cos_supplement. unfold Rdiv. ring.
- evar_last. apply (is_derive_minus (fun _ => PI) (fun phi => theta (d - phi))). apply is_derive_const. apply reflected_derive, B.
  unfold minus, plus, opp, zero; simpl. unfold theta_rate. rewrite sin_PI_x. in_R. ring.
Qed.

(** * What follows for the motions *)
(** A motion through psi = 0 at phi = 0 is odd in psi and even in theta. *)
Theorem odd_motion psi theta : reduced_motion a b psi theta -> psi 0 = 0 ->
  forall phi, psi (- phi) = - psi phi /\ theta (- phi) = theta phi.
Proof.
intros M Z phi.
destruct (motion_unique a b Ha Hb psi theta _ _ 0 M (psi_symmetry psi theta 0 M)) with (phi := - phi) as [E1 E2].
- rewrite Rminus_0_r, Z. ring.
- now rewrite Rminus_0_r.
- rewrite E1, E2. replace (0 - - phi) with phi by ring. now split.
Qed.
(** At a turning point, theta = pi/2, the motion returns as it came. *)
Theorem mirrored_motion psi theta phi1 : reduced_motion a b psi theta -> theta phi1 = PI/2 ->
  forall phi, psi (2 * phi1 - phi) = psi phi /\ theta (2 * phi1 - phi) = PI - theta phi.
Proof.
intros M T phi.
destruct (motion_unique a b Ha Hb psi theta _ _ phi1 M (theta_symmetry psi theta (2 * phi1) M)) with (phi := 2 * phi1 - phi) as [E1 E2].
- f_equal. ring.
- replace (2 * phi1 - phi1) with phi1 by ring. rewrite T. field.
- rewrite E1, E2. replace (2 * phi1 - (2 * phi1 - phi)) with phi by ring. now split.
Qed.
(** Both together: a motion through psi = 0 at phi = 0 with a turning point at phi1 changes sign after 2 phi1. *)
Theorem antiperiodic_motion psi theta phi1 : reduced_motion a b psi theta -> psi 0 = 0 -> theta phi1 = PI/2 ->
  forall phi, psi (phi + 2 * phi1) = - psi phi /\ theta (phi + 2 * phi1) = PI - theta phi.
Proof.
intros M Z T phi. destruct (odd_motion psi theta M Z phi) as [O1 O2].
destruct (mirrored_motion psi theta phi1 M T (- phi)) as [E1 E2].
replace (2 * phi1 - - phi) with (phi + 2 * phi1) in E1, E2 by ring. rewrite E1, E2, O1, O2. now split.
Qed.

(** * The motion psi_c of the curve C *)
(** The motion with the first integral c that passes psi = 0 at phi = 0, with cos theta > 0 there (and sin theta > 0: theta is a polar angle). *)
Definition centred_motion (c : R) (psi theta : R -> R) :=
  reduced_motion a b psi theta /\ psi 0 = 0 /\ 0 < theta 0 < PI/2 /\ first_integral a b (psi 0) (theta 0) = c.

(** psi and c determine theta in (0, pi/2). *)
Lemma polar_angle p p' q q' : p = p' -> 0 < q < PI/2 -> 0 < q' < PI/2 -> first_integral a b p q = first_integral a b p' q' -> q = q'.
Proof.
intros <- T T' C. unfold first_integral in C. assert (HPI := PI_RGT_0).
assert (S : 0 < sin q) by (apply sin_gt_0; lra). assert (S' : 0 < sin q') by (apply sin_gt_0; lra).
assert (0 <= b * cos p ^2) by (apply Rmult_le_pos; [lra|apply pow2_ge_0]).
assert (E : sin q ^2 = sin q' ^2). { apply (Rmult_eq_reg_r (a + b * cos p ^2)); lra. }
assert (E' : sin q = sin q'). { rewrite <- (sqrt_pow2 (sin q)), <- (sqrt_pow2 (sin q')), E by lra. reflexivity. }
destruct (Rtotal_order q q') as [L|[L|L]]; trivial.
- assert (sin q < sin q') by (apply sin_increasing_1; lra). lra.
- assert (sin q' < sin q) by (apply sin_increasing_1; lra). lra.
Qed.
(** For every c there is at most one. *)
Theorem centred_motion_unique c psi theta psi' theta' : centred_motion c psi theta -> centred_motion c psi' theta' ->
  forall phi, psi phi = psi' phi /\ theta phi = theta' phi.
Proof.
intros [M [Z [T C]]] [M' [Z' [T' C']]]. apply (motion_unique a b Ha Hb psi theta psi' theta' 0 M M'). now rewrite Z, Z'.
apply (polar_angle (psi 0) (psi' 0)); trivial; congruence.
Qed.
(** For -b < c < 0 there is one, in closed form. *)
Theorem centred_oscillation u : 0 < u < 1 -> centred_motion (- b * u) (oscillation_psi a b u) (oscillation_theta a b u).
Proof.
intros Hu. destruct (oscillation_start a b u Ha Hb Hu) as [Z T]. repeat split; try apply T; try apply (oscillation_is_motion a b u Ha Hb Hu); trivial.
now apply oscillation_first_integral.
Qed.
Lemma oscillation_of_c c : -b < c < 0 -> 0 < - c / b < 1 /\ - b * (- c / b) = c.
Proof.
intros H. repeat split.
- apply Rdiv_lt_0_compat; lra.
- apply (Rmult_lt_reg_r b); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra.
- field. lra.
Qed.
Theorem centred_motion_exists c : -b < c < 0 -> exists psi theta, centred_motion c psi theta.
Proof.
intros H. destruct (oscillation_of_c c H) as [Hu E]. exists (oscillation_psi a b (- c / b)), (oscillation_theta a b (- c / b)).
rewrite <- E at 1. now apply centred_oscillation.
Qed.

Section Oscillating.
Variable u : R.
Hypothesis Hu : 0 < u < 1.
Variables psi theta : R -> R.
Hypothesis H : centred_motion (- b * u) psi theta.
Lemma closed_form phi : psi phi = oscillation_psi a b u phi /\ theta phi = oscillation_theta a b u phi.
Proof. apply (centred_motion_unique (- b * u)); trivial. now apply centred_oscillation. Qed.
(** psi_c is odd. *)
Theorem psi_odd phi : psi (- phi) = - psi phi.
Proof. destruct H as [M [Z _]]. apply (odd_motion psi theta M Z). Qed.
(** psi_c vanishes exactly at the multiples of G u, *)
Theorem psi_passages phi : psi phi = 0 <-> exists k : Z, phi = IZR k * G a b u.
Proof. destruct (closed_form phi) as [-> _]. now apply passages. Qed.
(** and is at a turning point exactly at the odd multiples of G u/2; *)
Theorem theta_turning_points phi : cos (theta phi) = 0 <-> exists k : Z, phi = (IZR k + 1/2) * G a b u.
Proof. destruct (closed_form phi) as [_ ->]. now apply turning_points. Qed.
Lemma theta_range phi : 0 < theta phi < PI.
Proof. destruct (closed_form phi) as [_ ->]. unfold oscillation_theta. now apply theta_bounds. Qed.
Lemma right_angle phi : cos (theta phi) = 0 -> theta phi = PI/2.
Proof.
intros E. assert (T := theta_range phi). apply cos_inj; try lra. now rewrite cos_PI2.
Qed.
Lemma first_turning_point : theta (G a b u / 2) = PI/2.
Proof. apply right_angle, theta_turning_points. exists 0%Z. field. Qed.
(** before the first of them psi_c increases, cos theta > 0; *)
Theorem rises_to_first_turning_point phi : 0 <= phi < G a b u / 2 -> 0 < cos (theta phi).
Proof.
intros L. destruct H as [M [_ [T _]]]. assert (HPI := PI_RGT_0).
apply Rnot_le_lt. intros N. assert (C0 : 0 < cos (theta 0)) by (apply cos_gt_0; lra).
assert (P : 0 < phi). { destruct L as [[L|L] _]; trivial. rewrite <- L in N. lra. }
destruct (Ranalysis5.IVT_interv (fun t => - cos (theta t)) 0 phi) as [z [Hz Ez]]; trivial.
- intros t _. apply continuity_pt_opp, continuity_pt_filterlim. apply (continuous_comp theta cos).
  apply (ex_derive_continuous theta). eexists. apply M. apply continuous_cos.
- lra.
- destruct (Rle_lt_or_eq_dec _ _ N) as [N'|N']; [lra|]. exfalso. apply theta_turning_points in N'. destruct N' as [k Hk].
  assert (GP := G_pos a b u Ha Hb Hu). assert (K : 0 < IZR k + 1/2 < 1/2). { split; apply (Rmult_lt_reg_r (G a b u)); lra. }
  assert (K1 : IZR (-1) < IZR k) by lra. assert (K2 : IZR k < IZR 0) by lra. apply lt_IZR in K1. apply lt_IZR in K2. lia.
- assert (Z : cos (theta z) = 0) by lra. apply theta_turning_points in Z. destruct Z as [k Hk].
  assert (GP := G_pos a b u Ha Hb Hu). assert (K : 0 <= IZR k + 1/2 < 1/2). { split; [apply (Rmult_le_reg_r (G a b u))|apply (Rmult_lt_reg_r (G a b u))]; lra. }
  assert (K1 : IZR (-1) < IZR k) by lra. assert (K2 : IZR k < IZR 0) by lra. apply lt_IZR in K1. apply lt_IZR in K2. lia.
Qed.
(** and psi_c (phi + G) = - psi_c (phi). *)
Theorem half_phase_symmetry phi : psi (phi + G a b u) = - psi phi /\ theta (phi + G a b u) = PI - theta phi.
Proof.
destruct H as [M [Z _]]. assert (E := antiperiodic_motion psi theta (G a b u / 2) M Z first_turning_point phi).
replace (2 * (G a b u / 2)) with (G a b u) in E by field. exact E.
Qed.
(** A whole loop in the reduced phase space takes the Montgomery phase 2 G u. *)
Theorem loop phi : psi (phi + 2 * G a b u) = psi phi /\ theta (phi + 2 * G a b u) = theta phi.
Proof.
destruct (half_phase_symmetry phi) as [E1 E2]. destruct (half_phase_symmetry (phi + G a b u)) as [F1 F2].
replace (phi + G a b u + G a b u) with (phi + 2 * G a b u) in F1, F2 by ring. rewrite F1, F2, E1, E2. split; ring.
Qed.
End Oscillating.
End Symmetry.
