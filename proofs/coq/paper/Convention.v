(** The definition of the curve C as the paper prints it, against the convention of Curve.v.

    The paper: (c, eps) is in C if on a trajectory with this c the way from psi = -pi/2 + eps to psi = pi/2 - eps takes 2 pi in phi. The theorems
    say which pairs these are. For c >= 0: the graph of epsilon (c) and its mirror image eps -> pi - eps. For -b < c < 0 and 0 <= eps <= pi: these,
    and, where C meets S, the whole vertical segment between the two branches of S (so lemma 1 is false as printed). *)
Require Import Reals Lra Lia Psatz Ratan.
From Coquelicot Require Import Coquelicot.
From Polhode Require Import HalfPhase Uniqueness Oscillation Symmetry Curve FirstBranch.
From Polhode Require Phase.
Open Scope R_scope.
Local Notation P := Phase.P.

(** A point of the unit circle has an angle. *)
Lemma angle_of s k : s * s + k * k = 1 -> exists t, sin t = s /\ cos t = k.
Proof.
intros E. assert (S : -1 <= s <= 1) by (split; nra).
assert (C : cos (asin s) = Rabs k). { rewrite cos_asin by exact S. unfold Rsqr. replace (1 - s * s) with (k * k) by lra. apply sqrt_Rsqr_abs. }
destruct (Rle_dec 0 k) as [K|K].
- exists (asin s). rewrite sin_asin, C by exact S. split; trivial. now apply Rabs_pos_eq.
- exists (PI - asin s). rewrite sin_PI_x, sin_asin by exact S. split; trivial. rewrite cos_supplement, C, Rabs_left by lra. ring.
Qed.

Section Convention.
Variables a b : R.
Hypothesis Ha : 0 < a.
Hypothesis Hb : 0 < b < 1.
(** The paper's C: psi_i = -pi/2 + eps, psi_f = pi/2 - eps, Delta phi = 2 pi. *)
Definition printed_C (c eps : R) := exists psi theta phi0,
  reduced_motion a b psi theta /\ 0 < theta phi0 < PI /\ first_integral a b (psi phi0) (theta phi0) = c /\
  psi phi0 = - PI/2 + eps /\ psi (phi0 + 2*PI) = PI/2 - eps.

Section Oscillating.
Variable u : R.
Hypothesis Hu : 0 < u < 1.
Notation osc := (oscillation_psi a b u).
Notation r := (sqrt (1 - u)).
(** All motions with c = -b u in the same well are shifts of the one in closed form. *)
Theorem every_motion psi theta phi0 : reduced_motion a b psi theta -> 0 < theta phi0 < PI ->
  first_integral a b (psi phi0) (theta phi0) = - b * u -> - PI/2 <= psi phi0 <= PI/2 ->
  exists s, forall phi, psi phi = osc (phi + s) /\ theta phi = oscillation_theta a b u (phi + s).
Proof.
intros M T C I. set (p := psi phi0) in *. set (q := theta phi0) in *.
destruct (r_bounds u Hu) as [R0 R1]. assert (Q := equation_20 a b p q). rewrite C in Q.
assert (S := sin2_cos2 p). unfold Rsqr in S. assert (B0 : 0 < sqrt b) by (apply sqrt_lt_R0; lra).
assert (B2 : sqrt b * sqrt b = b) by (apply sqrt_sqrt; lra).
assert (A : 0 < a + b * cos p ^2). { assert (0 <= b * cos p ^2) by (apply Rmult_le_pos; [lra|apply pow2_ge_0]). lra. }
assert (A0 : 0 < sqrt (a + b * cos p ^2)) by now apply sqrt_lt_R0.
assert (A2 : sqrt (a + b * cos p ^2) * sqrt (a + b * cos p ^2) = a + b * cos p ^2) by (apply sqrt_sqrt; lra).
destruct (angle_of (sin p / r) (cos q * sqrt (a + b * cos p ^2) / (sqrt b * r))) as [t [St Ct]].
{ replace (sin p / r * (sin p / r) + cos q * sqrt (a + b * cos p ^2) / (sqrt b * r) * (cos q * sqrt (a + b * cos p ^2) / (sqrt b * r)))
    with ((sin p * sin p * (sqrt b * sqrt b) + cos q ^2 * (sqrt (a + b * cos p ^2) * sqrt (a + b * cos p ^2))) / ((sqrt b * sqrt b) * (r * r))) by (field; lra).
  rewrite A2, Q, B2, R1. replace (sin p * sin p) with (1 - cos p * cos p) by lra. field. lra. }
assert (X1 : X u (cos t) = cos p ^2).
{ assert (S' := sin2_cos2 t). unfold Rsqr in S'. unfold X. replace (cos t ^2) with (1 - sin t * sin t) by (simpl; lra). rewrite St.
  replace (sin p / r * (sin p / r)) with (sin p * sin p / (r * r)) by (field; lra). rewrite R1. replace (sin p * sin p) with (1 - cos p * cos p) by lra. field. lra. }
assert (E1 : psi_of u t = p).
{ unfold psi_of. rewrite St. replace (r * (sin p / r)) with (sin p) by (field; lra). apply asin_sin. lra. }
assert (E2 : theta_of a b u t = q).
{ unfold theta_of, cos_theta_of. rewrite X1, Ct.
  replace (sqrt b * r * (cos q * sqrt (a + b * cos p ^2) / (sqrt b * r)) / sqrt (a + b * cos p ^2)) with (cos q) by (field; lra). apply acos_cos. lra. }
assert (Zt : phi0 + (P a b u t - phi0) = P a b u t) by (in_R; ring).
exists (P a b u t - phi0).
apply (motion_unique a b Ha Hb psi theta _ _ phi0 M).
- exact (shift_symmetry a b _ _ (P a b u t - phi0) (oscillation_is_motion a b u Ha Hb Hu)).
- cbv beta. rewrite Zt. unfold oscillation_psi. rewrite turn_P by assumption. now rewrite E1.
- cbv beta. rewrite Zt. unfold oscillation_theta. rewrite turn_P by assumption. now rewrite E2.
Qed.

Lemma turn_multiple k phi : turn a b u (phi + IZR k * G a b u) = turn a b u phi + IZR k * PI.
Proof. rewrite <- (P_turn a b u Ha Hb Hu phi) at 1. rewrite <- P_half_turns by assumption. now apply turn_P. Qed.
Lemma sin_multiple k t : sin (t + IZR k * PI) = sin t \/ sin (t + IZR k * PI) = - sin t.
Proof.
rewrite sin_plus. assert (Z : sin (IZR k * PI) = 0) by (apply sin_eq_0_1; now exists k). rewrite Z.
assert (S := sin2_cos2 (IZR k * PI)). unfold Rsqr in S. rewrite Z in S.
assert (C : (cos (IZR k * PI) - 1) * (cos (IZR k * PI) + 1) = 0) by lra.
apply Rmult_integral in C. destruct C as [C|C]; [left|right]; [replace (cos (IZR k * PI)) with 1 by lra|replace (cos (IZR k * PI)) with (-1) by lra]; ring.
Qed.
Lemma sin_odd_multiple k t : sin (t + IZR (2 * k + 1) * PI) = - sin t.
Proof.
rewrite sin_plus. assert (Z : sin (IZR (2 * k + 1) * PI) = 0) by (apply sin_eq_0_1; now exists (2 * k + 1)%Z). rewrite Z.
rewrite plus_IZR, mult_IZR. replace ((2 * IZR k + 1) * PI) with (2 * (IZR k * PI) + PI) by ring. rewrite neg_cos, cos_2a_sin.
assert (Z' : sin (IZR k * PI) = 0) by (apply sin_eq_0_1; now exists k). rewrite Z'. ring.
Qed.
Lemma psi_of_opposite t t' : sin t' = - sin t -> psi_of u t' = - psi_of u t.
Proof. intros E. unfold psi_of. rewrite E, <- asin_opp. f_equal. ring. Qed.
Lemma osc_multiple k phi : osc (phi + IZR k * G a b u) = osc phi \/ osc (phi + IZR k * G a b u) = - osc phi.
Proof.
unfold oscillation_psi. rewrite turn_multiple. destruct (sin_multiple k (turn a b u phi)) as [E|E].
- left. unfold psi_of. now rewrite E.
- right. now apply psi_of_opposite.
Qed.
Lemma osc_odd_multiple k phi : osc (phi + IZR (2 * k + 1) * G a b u) = - osc phi.
Proof. unfold oscillation_psi. rewrite turn_multiple. apply psi_of_opposite, sin_odd_multiple. Qed.
Lemma osc_odd phi : osc (- phi) = - osc phi.
Proof. exact (psi_odd a b Ha Hb u _ _ (centred_oscillation a b Ha Hb u Hu) phi). Qed.

(** Two points with opposite psi, 2 pi apart: the middle is a passage through psi = 0, or 2 pi is an odd number of half phases. *)
Theorem symmetric_points phi : osc (phi + 2*PI) = - osc phi ->
  (exists k : Z, phi = IZR k * G a b u - PI) \/ (exists k : Z, 2*PI = IZR (2 * k + 1) * G a b u).
Proof.
intros E. set (t1 := turn a b u phi). set (t2 := turn a b u (phi + 2*PI)).
destruct (r_bounds u Hu) as [R0 _].
assert (S : sin t2 + sin t1 = 0).
{ assert (S1 := sin_psi u Hu t1). assert (S2 := sin_psi u Hu t2).
  change (psi_of u t1) with (osc phi) in S1. change (psi_of u t2) with (osc (phi + 2*PI)) in S2. rewrite E, sin_neg, S1 in S2. nra. }
assert (P1 : P a b u t1 = phi) by now apply P_turn. assert (P2 : P a b u t2 = phi + 2*PI) by now apply P_turn.
rewrite form3 in S. apply Rmult_integral in S. destruct S as [S|S].
- assert (C : cos ((t2 - t1)/2) = 0) by lra. apply cos_eq_0_0 in C. destruct C as [k Hk]. right. exists k.
  assert (T : t2 = t1 + IZR (2 * k + 1) * PI) by (rewrite plus_IZR, mult_IZR; lra).
  rewrite T, P_half_turns, P1 in P2 by assumption. lra.
- apply sin_eq_0_0 in S. destruct S as [k Hk]. left. exists k.
  assert (T : t2 = - t1 + IZR (2 * k) * PI) by (rewrite mult_IZR; lra).
  rewrite T, P_half_turns, P_odd, P1, mult_IZR in P2 by assumption. lra.
Qed.
End Oscillating.

(** The pairs of the paper's definition, for -b < c < 0. *)
Theorem printed_C_pairs c eps : -b < c < 0 -> 0 <= eps <= PI ->
  (printed_C c eps <-> eps = epsilon a b c \/ eps = PI - epsilon a b c \/ (meeting a b c /\ 0 <= c + b * sin eps ^2)).
Proof.
intros H He. destruct (oscillation_of_c b Hb c H) as [Hu W]. set (u := - c / b) in *. assert (HPI := PI_RGT_0).
assert (ME := centred_oscillation a b Ha Hb u Hu). assert (GP := G_pos a b u Ha Hb Hu).
unfold epsilon. fold u. split.
- intros [psi [theta [phi0 [M [T [C [I F]]]]]]]. rewrite <- W in C.
  destruct (every_motion u Hu psi theta phi0 M T C ltac:(lra)) as [s D].
  assert (Z : oscillation_psi a b u (phi0 + s + 2*PI) = - oscillation_psi a b u (phi0 + s)).
  { rewrite <- (proj1 (D phi0)). replace (phi0 + s + 2*PI) with (phi0 + 2*PI + s) by ring. rewrite <- (proj1 (D (phi0 + 2*PI))). lra. }
  apply symmetric_points in Z; trivial. destruct Z as [[k Hk]|[k Hk]].
  + assert (E := proj1 (D phi0)). rewrite Hk in E. replace (IZR k * G a b u - PI) with (- PI + IZR k * G a b u) in E by ring.
    destruct (osc_multiple u Hu k (- PI)) as [V|V]; rewrite V, osc_odd in E by assumption; [left|right; left]; lra.
  + right. right. split.
    * split; [exact H|]. rewrite <- W. exists (PI/2 - oscillation_psi a b u PI). split. { eexists. eexists. split; [exact ME|reflexivity]. }
      apply (on_S_iff_turning a b Ha Hb _ _ (oscillation_theta a b u) PI); [apply ME|now apply oscillation_first_integral|].
      apply (turning_points a b u Ha Hb Hu). exists k. rewrite plus_IZR, mult_IZR in Hk. lra.
    * assert (Q := equation_20 a b (psi phi0) (theta phi0)). rewrite C, W, I in Q.
      assert (N : 0 <= cos (theta phi0) ^2 * (a + b * cos (- PI/2 + eps) ^2)).
      { apply Rmult_le_pos; [apply pow2_ge_0|]. assert (0 <= b * cos (- PI/2 + eps) ^2) by (apply Rmult_le_pos; [lra|apply pow2_ge_0]). lra. }
      rewrite Q in N. replace (- PI/2 + eps) with (- (PI/2 - eps)) in N by field. rewrite cos_neg, cos_shift in N. exact N.
- assert (B : forall phi, 0 < oscillation_theta a b u phi < PI) by (intros phi; unfold oscillation_theta; now apply theta_bounds).
  assert (O := oscillation_is_motion a b u Ha Hb Hu).
  intros [->|[->|[MC L]]].
  + exists (oscillation_psi a b u), (oscillation_theta a b u), (- PI). split; [exact O|]. split; [apply B|].
    split; [rewrite <- W; now apply oscillation_first_integral|]. rewrite osc_odd by assumption. replace (- PI + 2*PI) with PI by ring. split; field.
  + exists (fun phi => oscillation_psi a b u (phi + G a b u)), (fun phi => oscillation_theta a b u (phi + G a b u)), (- PI).
    split; [now apply shift_symmetry|]. split; [apply B|]. split; [rewrite <- W; now apply oscillation_first_integral|].
    destruct (half_phase_symmetry a b Ha Hb u Hu _ _ ME (- PI)) as [V _]. destruct (half_phase_symmetry a b Ha Hb u Hu _ _ ME PI) as [V' _].
    replace (- PI + 2*PI) with PI by ring. rewrite V, V', osc_odd by assumption. split; field.
  + rewrite <- W in MC. apply (meeting_iff a b Ha Hb u Hu) in MC. destruct MC as [k [Hk E]].
    destruct (r_bounds u Hu) as [R0 R1]. assert (K : 1 <= INR k) by (apply (le_INR 1); exact Hk).
    set (p := - PI/2 + eps). assert (SE : sin eps ^2 = cos p ^2).
    { unfold p. replace (- PI/2 + eps) with (- (PI/2 - eps)) by field. now rewrite cos_neg, cos_shift. }
    assert (S := sin2_cos2 p). unfold Rsqr in S.
    assert (LE : u <= cos p ^2). { rewrite <- SE. apply (Rmult_le_reg_l b); [lra|]. replace (b * u) with (- c) by (rewrite <- W; ring). lra. }
    assert (SB : (sin p / sqrt (1 - u)) * (sin p / sqrt (1 - u)) <= 1).
    { replace (sin p / sqrt (1 - u) * (sin p / sqrt (1 - u))) with (sin p * sin p / (sqrt (1 - u) * sqrt (1 - u))) by (field; lra). rewrite R1.
      apply (Rmult_le_reg_r (1 - u)); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. simpl in LE. lra. }
    set (t := asin (sin p / sqrt (1 - u))).
    assert (St : sin t = sin p / sqrt (1 - u)) by (apply sin_asin; split; nra).
    assert (V : oscillation_psi a b u (P a b u t) = p).
    { unfold oscillation_psi. rewrite turn_P by assumption. unfold psi_of. rewrite St.
      replace (sqrt (1 - u) * (sin p / sqrt (1 - u))) with (sin p) by (field; lra). apply asin_sin. unfold p. lra. }
    exists (oscillation_psi a b u), (oscillation_theta a b u), (P a b u t). split; [exact O|]. split; [apply B|].
    split; [rewrite <- W; now apply oscillation_first_integral|]. split; [exact V|].
    assert (TP : 2*PI = IZR (2 * (Z.of_nat k - 1) + 1) * G a b u).
    { rewrite plus_IZR, mult_IZR, minus_IZR, <- INR_IZR_INZ, E. field. lra. }
    rewrite TP, osc_odd_multiple, V by assumption. unfold p. field.
Qed.

(** Away from the meeting points, the printed definition gives epsilon (c) and its mirror image, *)
Theorem printed_C_elsewhere c eps : -b < c < 0 -> 0 <= eps <= PI -> ~ meeting a b c ->
  (printed_C c eps <-> eps = epsilon a b c \/ eps = PI - epsilon a b c).
Proof. intros H He N. rewrite printed_C_pairs by assumption. tauto. Qed.
(** and where C meets S, the segment between the two branches of S: lemma 1 fails there as printed. *)
Theorem printed_C_at_meeting c eps : meeting a b c -> 0 <= eps <= PI -> 0 <= c + b * sin eps ^2 -> printed_C c eps.
Proof. intros M He L. apply printed_C_pairs; trivial. apply M. right. right. now split. Qed.
(** For every body with I < 2 there is a c for which lemma 1 fails as printed: two different eps below pi/2. *)
Theorem lemma_1_as_printed_fails : Theorem1.geometric_constant a b < 2 ->
  exists c eps eps', -b < c < 0 /\ 0 < eps < eps' /\ eps' < PI/2 /\ printed_C c eps /\ printed_C c eps'.
Proof.
intros J. apply (lemma_2 a b Ha Hb) in J. destruct J as [c F]. apply (first_is_first a b Ha Hb) in F. destruct F as [M _].
assert (H := proj1 M). destruct (oscillation_of_c b Hb c H) as [Hu W]. set (u := - c / b) in *. assert (HPI := PI_RGT_0).
assert (U : 0 < sqrt u < 1). { split. apply sqrt_lt_R0; lra. rewrite <- sqrt_1. apply sqrt_lt_1_alt. lra. }
assert (U2 : sqrt u * sqrt u = u) by (apply sqrt_sqrt; lra).
assert (A0 : 0 < asin (sqrt u) < PI/2).
{ destruct (asin_bound_lt (sqrt u)) as [B1 B2]; [lra|]. split; trivial. apply Rnot_le_lt. intros N.
  assert (Z : sin (asin (sqrt u)) <= sin 0) by (apply sin_incr_1; lra). rewrite sin_asin, sin_0 in Z by lra. lra. }
set (e := asin (sqrt u)) in *. assert (Se : sin e = sqrt u) by (apply sin_asin; lra).
set (e' := (e + PI/2) / 2). assert (E' : e < e' < PI/2) by (unfold e'; lra).
assert (S' : sin e < sin e') by (apply sin_increasing_1; lra).
exists c, e, e'. split; [exact H|]. split; [lra|]. split; [lra|].
assert (BU : c = - b * u) by (symmetry; exact W).
split; apply printed_C_at_meeting; try exact M; try lra.
- rewrite Se, BU. replace (sqrt u ^2) with u by (simpl; lra). lra.
- rewrite BU. assert (u <= sin e' ^2) by (rewrite <- U2, <- Se; simpl; nra). nra.
Qed.

(** * c >= 0 *)
(** theta stays between 0 and pi, *)
Lemma theta_stays psi theta phi0 : reduced_motion a b psi theta -> 0 < theta phi0 < PI -> forall phi, 0 < theta phi < PI.
Proof.
intros M T phi. assert (S0 : 0 < sin (theta phi0)) by (apply sin_gt_0; lra).
assert (A : forall p, 0 < a + b * cos p ^2). { intros p. assert (0 <= b * cos p ^2) by (apply Rmult_le_pos; [lra|apply pow2_ge_0]). lra. }
assert (N : forall z, sin (theta z) <> 0).
{ intros z Z. assert (E := first_integral_constant a b Hb psi theta M z phi0). unfold first_integral in E. rewrite Z in E.
  assert (0 < sin (theta phi0) ^2 * (a + b * cos (psi phi0) ^2)) by (apply Rmult_lt_0_compat; [now apply pow_lt|apply A]).
  replace (0 ^2) with 0 in E by ring. lra. }
assert (C : forall z, continuity_pt theta z) by (intros z; apply continuity_pt_filterlim, (ex_derive_continuous theta); exact (ex_intro _ _ (proj2 (M z)))).
split; apply Rnot_le_lt; intros L.
- destruct (IVT_gen theta phi0 phi 0 C) as [z [_ E]].
  + split; [apply Rle_trans with (1 := Rmin_r _ _); lra|apply Rle_trans with (2 := Rmax_l _ _); lra].
  + apply (N z). rewrite E. apply sin_0.
- destruct (IVT_gen theta phi0 phi PI C) as [z [_ E]].
  + split; [apply Rle_trans with (1 := Rmin_l _ _); lra|apply Rle_trans with (2 := Rmax_r _ _); lra].
  + apply (N z). rewrite E. apply sin_PI.
Qed.
(** the definition has a mirror, *)
Lemma printed_mirror c eps : printed_C c eps -> printed_C c (PI - eps).
Proof.
intros [psi [theta [phi0 [M [T [E [A B]]]]]]]. set (d := 2 * phi0 + 2*PI).
assert (E0 : d - phi0 = phi0 + 2*PI) by (unfold d; ring). assert (E1 : d - (phi0 + 2*PI) = phi0) by (unfold d; ring).
assert (T1 := theta_stays psi theta phi0 M T (phi0 + 2*PI)).
exists (fun phi => psi (d - phi)), (fun phi => PI - theta (d - phi)), phi0. split; [now apply theta_symmetry|]. rewrite E0, E1. split; [lra|].
split; [|split; lra]. rewrite <- E, (first_integral_constant a b Hb psi theta M phi0 (phi0 + 2*PI)). unfold first_integral. now rewrite sin_PI_x.
Qed.
(** and a rising motion of it is a shift of psi_c. *)
Lemma printed_rising c eps psi theta phi0 : 0 <= c -> reduced_motion a b psi theta -> 0 < theta phi0 < PI -> first_integral a b (psi phi0) (theta phi0) = c ->
  psi phi0 = - PI/2 + eps -> psi (phi0 + 2*PI) = PI/2 - eps -> (forall phi, 0 < cos (theta phi)) -> curve_C a b c eps.
Proof.
intros Hc M T E A B C. assert (P := PI_RGT_0).
assert (Cp : forall z, continuity_pt psi z) by (intros z; apply continuity_pt_filterlim, (ex_derive_continuous psi); exact (ex_intro _ _ (proj1 (M z)))).
assert (Rate : forall z, 0 < psi_rate a b (psi z) (theta z)).
{ intros z. assert (Bx := cos2_bound (psi z)). assert (D := denominator b Hb (psi z)). unfold psi_rate. apply Rdiv_lt_0_compat; [|lra].
  apply Rmult_lt_0_compat; [|apply C]. assert (0 <= b * cos (psi z) ^2) by (apply Rmult_le_pos; lra). lra. }
assert (Up : forall s t, s < t -> psi s < psi t).
{ intros s t L. destruct (MVT_gen psi s t (fun phi => psi_rate a b (psi phi) (theta phi))) as [z [_ Ez]]; [intros z _; apply (M z)|intros z _; apply Cp|].
  assert (Q := Rate z). nra. }
assert (U := Up phi0 (phi0 + 2*PI) ltac:(lra)).
destruct (IVT_gen psi phi0 (phi0 + 2*PI) 0 Cp) as [m [_ Em]].
{ rewrite A, B. split; [apply Rle_trans with (1 := Rmin_l _ _); lra|apply Rle_trans with (2 := Rmax_r _ _); lra]. }
assert (Tm := theta_stays psi theta phi0 M T m).
assert (Cm : 0 < theta m < PI/2).
{ split; [lra|]. apply Rnot_le_lt. intros L. assert (Q := C m). assert (W := cos_le_0 (theta m) L ltac:(lra)). lra. }
set (f := fun phi => psi (phi + m)). set (h := fun phi => theta (phi + m)).
assert (Mc : centred_motion a b c f h).
{ split; [now apply shift_symmetry|]. unfold f, h. rewrite Rplus_0_l. split; [exact Em|]. split; [exact Cm|].
  rewrite <- E. now apply first_integral_constant. }
assert (O := odd_motion a b Ha Hb f h (proj1 Mc) (proj1 (proj2 Mc))).
exists f, h. split; [exact Mc|].
assert (S : f (m - phi0) = f (phi0 + 2*PI - m)).
{ replace (m - phi0) with (- (phi0 - m)) by ring. rewrite (proj1 (O _)). unfold f. replace (phi0 - m + m) with phi0 by ring.
  replace (phi0 + 2*PI - m + m) with (phi0 + 2*PI) by ring. lra. }
assert (D : m - phi0 = phi0 + 2*PI - m).
{ unfold f in S. destruct (Rtotal_order (m - phi0) (phi0 + 2*PI - m)) as [L|[L|L]]; trivial.
  - assert (W := Up (m - phi0 + m) (phi0 + 2*PI - m + m) ltac:(lra)). lra.
  - assert (W := Up (phi0 + 2*PI - m + m) (m - phi0 + m) ltac:(lra)). lra. }
unfold f. replace (PI + m) with (phi0 + 2*PI) by lra. lra.
Qed.
(** The pairs of the paper's definition, for c >= 0. *)
Theorem printed_C_non_negative c eps : 0 <= c -> (printed_C c eps <-> curve_C a b c eps \/ curve_C a b c (PI - eps)).
Proof.
intros Hc. assert (P := PI_RGT_0). assert (W : forall e, curve_C a b c e -> printed_C c e).
{ intros e [psi [theta [M ->]]]. assert (O := odd_motion a b Ha Hb psi theta (proj1 M) (proj1 (proj2 M)) PI).
  exists psi, theta, (- PI). split; [apply M|]. split.
  - apply (theta_stays psi theta 0); [apply M|]. destruct M as [_ [_ [T _]]]. lra.
  - split; [now apply first_integral_at|]. replace (- PI + 2*PI) with PI by ring. lra. }
split.
- intros [psi [theta [phi0 [M [T [E [A B]]]]]]].
  assert (N : forall phi, cos (theta phi) <> 0).
  { intros z Z. assert (Ez : first_integral a b (psi z) (theta z) = c) by (rewrite <- E; now apply first_integral_constant).
    destruct (turning_is_rest a b Ha Hb c psi theta z M Hc Ez Z) as [Z3 R].
    assert (R0 := proj1 (R phi0)). assert (R1 := proj1 (R (phi0 + 2*PI))). assert (psi z = 0) by lra. rewrite H, cos_0 in Z3. lra. }
  assert (Sign : forall s t, 0 < cos (theta s) -> 0 < cos (theta t)).
  { intros s t L. apply Rnot_le_lt. intros K. destruct (IVT_gen (fun phi => cos (theta phi)) s t 0) as [z [_ Ez]].
    - intros x. apply (continuity_pt_comp theta cos); [|apply continuity_cos]. apply continuity_pt_filterlim, (ex_derive_continuous theta). exact (ex_intro _ _ (proj2 (M x))).
    - split; [apply Rle_trans with (1 := Rmin_r _ _); lra|apply Rle_trans with (2 := Rmax_l _ _); lra].
    - now apply (N z). }
  destruct (Rtotal_order (cos (theta phi0)) 0) as [L|[L|L]]; [|now apply N in L|].
  + right. set (d := 2 * phi0 + 2*PI). assert (E0 : d - phi0 = phi0 + 2*PI) by (unfold d; ring). assert (E1 : d - (phi0 + 2*PI) = phi0) by (unfold d; ring).
    assert (T1 := theta_stays psi theta phi0 M T (phi0 + 2*PI)).
    apply (printed_rising c (PI - eps) (fun phi => psi (d - phi)) (fun phi => PI - theta (d - phi)) phi0 Hc); rewrite ?E0, ?E1; try lra.
    * now apply theta_symmetry.
    * rewrite <- E, (first_integral_constant a b Hb psi theta M phi0 (phi0 + 2*PI)). unfold first_integral. now rewrite sin_PI_x.
    * intros phi. rewrite cos_supplement. assert (Q : ~ 0 < cos (theta (d - phi))). { intros Q. assert (Q' := Sign _ phi0 Q). lra. }
      assert (Q' := N (d - phi)). lra.
  + left. apply (printed_rising c eps psi theta phi0); trivial. intros phi. now apply (Sign phi0).
- intros [C|C]; [now apply W|]. apply W, printed_mirror in C. replace (PI - (PI - eps)) with eps in C by ring. exact C.
Qed.
End Convention.
