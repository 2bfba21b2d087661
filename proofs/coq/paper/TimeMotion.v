(** The motion in time is the reduced motion, at turning points as well: whatever solves the paper's equations (6) in time is a solution of
    (18), (19) taken at phi = phi (t). With this the theorems on (18), (19) are theorems about the body: epsilon (c) is what is left of the
    half turn at the time when phi has grown by pi. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Polhode Require Import HalfPhase Uniqueness Oscillation Symmetry Curve.
Open Scope R_scope.

Lemma square_distance_derive (y z y' z' : R -> R) t p q p' q' :
  is_derive y t p -> is_derive z t q -> is_derive y' t p' -> is_derive z' t q' ->
  is_derive (fun t => (y t - y' t)^2 + (z t - z' t)^2) t (2 * (y t - y' t) * (p - p') + 2 * (z t - z' t) * (q - q')).
Proof.
intros A B A' B'. auto_derive.
- repeat split; eexists; eassumption.
- change (fun x => y x) with y. change (fun x => z x) with z. change (fun x => y' x) with y'. change (fun x => z' x) with z'.
  rewrite (is_derive_unique y _ _ A), (is_derive_unique z _ _ B), (is_derive_unique y' _ _ A'), (is_derive_unique z' _ _ B'). ring.
Qed.

Section TimeMotion.
Variables Ix Iy Iz : R.
Hypothesis moments : 0 < Iz < Iy /\ Iy < Ix.
Notation a := (Iy/Iz - 1).
Notation b := (1 - Iy/Ix).
(** Equations (6), |J| = 1: psi, theta, phi as functions of time. *)
Definition angle_motion (psi theta phi : R -> R) := forall t,
  is_derive theta t ((1/Iy - 1/Ix) * sin (theta t) * sin (psi t) * cos (psi t)) /\
  is_derive phi t (1/Iy * sin (psi t) ^2 + 1/Ix * cos (psi t) ^2) /\
  is_derive psi t ((1/Iz - 1/Iy * sin (psi t) ^2 - 1/Ix * cos (psi t) ^2) * cos (theta t)).

Lemma a_pos : 0 < a.
Proof. apply (Rplus_lt_reg_r 1). apply (Rmult_lt_reg_r Iz); [lra|]. replace ((Iy/Iz - 1 + 1)*Iz) with Iy by (field; lra). lra. Qed.
Lemma b_bounds : 0 < b < 1.
Proof.
assert (0 < Iy/Ix) by (apply Rdiv_lt_0_compat; lra).
assert (Iy/Ix < 1). { apply (Rmult_lt_reg_r Ix); [lra|]. replace (Iy/Ix*Ix) with Iy by (field; lra). lra. } lra.
Qed.
(** dphi/dt = (1 - b cos^2 psi)/I_y, *)
Lemma phi_rate p : 1/Iy * sin p ^2 + 1/Ix * cos p ^2 = (1 - b * cos p ^2) / Iy.
Proof. assert (E := sin2_cos2 p). unfold Rsqr in E. replace (sin p ^2) with (1 - cos p ^2) by (simpl; lra). field. lra. Qed.
Lemma phi_rate_bounds p : (1 - b) / Iy <= (1 - b * cos p ^2) / Iy <= 1 / Iy.
Proof.
assert (D := denominator b b_bounds p). assert (0 <= / Iy) by (left; apply Rinv_0_lt_compat; lra). unfold Rdiv. split; apply Rmult_le_compat_r; lra.
Qed.
(** and the other two of (6) are (18) and (19), times this. *)
Lemma psi_rate_in_time p q : (1/Iz - 1/Iy * sin p ^2 - 1/Ix * cos p ^2) * cos q = psi_rate a b p q * ((1 - b * cos p ^2) / Iy).
Proof.
assert (D := denominator b b_bounds p). assert (B := b_bounds). unfold psi_rate.
replace ((a + b * cos p ^2) * cos q / (1 - b * cos p ^2) * ((1 - b * cos p ^2) / Iy)) with ((a + b * cos p ^2) * cos q / Iy).
2:{ set (d := 1 - b * cos p ^2) in *. assert (d <> 0) by lra. clearbody d. field. lra. }
assert (E := sin2_cos2 p). unfold Rsqr in E. replace (sin p ^2) with (1 - cos p ^2) by (simpl; lra). field. lra.
Qed.
Lemma theta_rate_in_time p q : (1/Iy - 1/Ix) * sin q * sin p * cos p = theta_rate a b p q * ((1 - b * cos p ^2) / Iy).
Proof.
assert (D := denominator b b_bounds p). assert (B := b_bounds). unfold theta_rate.
replace (b * sin q * sin p * cos p / (1 - b * cos p ^2) * ((1 - b * cos p ^2) / Iy)) with (b * sin q * sin p * cos p / Iy).
2:{ set (d := 1 - b * cos p ^2) in *. assert (d <> 0) by lra. clearbody d. field. lra. }
field. lra.
Qed.

Variables psi theta phi : R -> R.
Hypothesis M : angle_motion psi theta phi.
Notation rate t := ((1 - b * cos (psi t) ^2) / Iy).
Lemma phi_derive t : is_derive phi t (rate t).
Proof. rewrite <- phi_rate. apply M. Qed.

(** A motion in time that agrees with a reduced motion at one time is this reduced motion at all times. *)
Theorem time_motion Psi Theta t0 : reduced_motion a b Psi Theta -> psi t0 = Psi (phi t0) -> theta t0 = Theta (phi t0) ->
  forall t, psi t = Psi (phi t) /\ theta t = Theta (phi t).
Proof.
intros N E1 E2 t. assert (Ha := a_pos). assert (Hb := b_bounds).
set (K := 8 * (a + 1) * (/ (1 - b))^2).
set (E := fun t => (psi t - Psi (phi t))^2 + (theta t - Theta (phi t))^2).
set (dp := fun t => psi_rate a b (psi t) (theta t) - psi_rate a b (Psi (phi t)) (Theta (phi t))).
set (dq := fun t => theta_rate a b (psi t) (theta t) - theta_rate a b (Psi (phi t)) (Theta (phi t))).
set (dE := fun t => (2 * (psi t - Psi (phi t)) * dp t + 2 * (theta t - Theta (phi t)) * dq t) * rate t).
assert (Z : E t = 0).
{ apply (gronwall E dE (4 * K * (1 / Iy)) (Rmin t0 t) (Rmax t0 t)) with (t0 := t0).
  - intros s _. destruct (M s) as [A [_ C]]. rewrite theta_rate_in_time in A. rewrite psi_rate_in_time in C. destruct (N (phi s)) as [P Q].
    assert (P' := is_derive_comp Psi phi s _ _ P (phi_derive s)). assert (Q' := is_derive_comp Theta phi s _ _ Q (phi_derive s)).
    evar_last. exact (square_distance_derive psi theta _ _ s _ _ _ _ C A P' Q').
    unfold dE, dp, dq, scal; simpl; unfold mult; simpl. ring.
  - intros s _. unfold E. apply Rplus_le_le_0_compat; apply pow2_ge_0.
  - intros s _. unfold dE. rewrite Rabs_mult. assert (R := phi_rate_bounds (psi s)).
    assert (0 < (1 - b) / Iy) by (apply Rdiv_lt_0_compat; lra). rewrite (Rabs_pos_eq (rate s)) by lra.
    replace (4 * K * (1 / Iy) * E s) with (4 * K * E s * (1 / Iy)) by ring.
    apply Rmult_le_compat; [apply Rabs_pos|lra| |lra].
    apply energy_bound; [now apply K_pos|apply psi_rate_lipschitz; trivial|apply theta_rate_lipschitz; trivial].
  - split; [apply Rmin_l|apply Rmax_l].
  - unfold E. rewrite E1, E2. ring.
  - split; [apply Rmin_r|apply Rmax_r]. }
unfold E in Z. assert (A := pow2_ge_0 (psi t - Psi (phi t))). assert (B := pow2_ge_0 (theta t - Theta (phi t))).
split; apply Rminus_diag_uniq; apply Rsqr_0_uniq; unfold Rsqr; simpl in *; lra.
Qed.

(** phi grows without bound and takes every value at exactly one time. *)
Lemma phi_mvt s t : s < t -> (1 - b) / Iy * (t - s) <= phi t - phi s.
Proof.
intros L. destruct (MVT_gen phi s t (fun t => rate t)) as [z [_ E]].
- intros z _. apply phi_derive.
- intros z _. apply continuity_pt_filterlim, (ex_derive_continuous phi). eexists. apply phi_derive.
- rewrite E. apply Rmult_le_compat_r; [lra|apply phi_rate_bounds].
Qed.
Theorem phi_takes_every_value v : exists t, phi t = v /\ forall s, phi s = v -> s = t.
Proof.
assert (B := b_bounds). assert (K : 0 < (1 - b) / Iy) by (apply Rdiv_lt_0_compat; lra). set (k := (1 - b) / Iy) in *.
assert (V := Rabs_pos (v - phi 0)). assert (V1 := Rle_abs (v - phi 0)). assert (V2 := Rle_abs (- (v - phi 0))). rewrite Rabs_Ropp in V2.
set (T := (Rabs (v - phi 0) + 1) / k). assert (T0 : 0 < T) by (apply Rdiv_lt_0_compat; lra).
assert (E : k * T = Rabs (v - phi 0) + 1) by (unfold T; field; lra).
assert (U := phi_mvt 0 T T0). assert (D := phi_mvt (-T) 0 ltac:(lra)). fold k in U, D.
destruct (Ranalysis5.IVT_interv (fun t => phi t - v) (-T) T) as [t [_ Et]]; try lra.
- intros t _. apply continuity_pt_minus. apply continuity_pt_filterlim, (ex_derive_continuous phi). eexists. apply phi_derive.
  apply continuity_pt_const; now intros ? ?.
- exists t. split; [lra|]. intros s Es. destruct (Rtotal_order s t) as [L|[L|L]]; trivial; apply phi_mvt in L as L'; fold k in L'.
  + assert (0 < k * (t - s)) by (apply Rmult_lt_0_compat; lra). lra.
  + assert (0 < k * (s - t)) by (apply Rmult_lt_0_compat; lra). lra.
Qed.

(** The tennis racket effect in time. The body passes psi = 0 at the time 0, where phi = 0 and cos theta > 0, and its c lies in (-b, 0); when phi
    has grown by pi, psi has come to pi/2 - epsilon (c), and it was at -pi/2 + epsilon (c) when phi was -pi: a rotation by 2 pi of phi. *)
Theorem racket_in_time c t : psi 0 = 0 -> 0 < theta 0 < PI/2 -> phi 0 = 0 -> first_integral a b (psi 0) (theta 0) = c -> -b < c < 0 ->
  (phi t = PI -> psi t = PI/2 - epsilon a b c) /\ (phi t = - PI -> psi t = - PI/2 + epsilon a b c).
Proof.
intros Z T F C H. assert (Ha := a_pos). assert (Hb := b_bounds). destruct (oscillation_of_c b Hb c H) as [Hu W].
set (Psi := oscillation_psi a b (- c / b)). set (Theta := oscillation_theta a b (- c / b)).
assert (N : centred_motion a b c Psi Theta). { rewrite <- W at 1. now apply centred_oscillation. }
assert (E0 : theta 0 = Theta 0).
{ destruct N as [_ [NZ [NT NC]]]. apply (polar_angle a b Ha Hb (psi 0) (Psi 0)); trivial; congruence. }
assert (D := time_motion Psi Theta 0 (proj1 N)). rewrite F in D. specialize (D ltac:(rewrite Z; symmetry; apply N) E0 t). destruct D as [D _].
unfold epsilon. fold Psi. split; intros P; rewrite D, P; [ring|].
assert (O := odd_motion a b Ha Hb Psi Theta (proj1 N) (proj1 (proj2 N)) PI). rewrite (proj1 O). field.
Qed.
End TimeMotion.
