(** C is tangent to S at every point in which they meet: where C meets S at c_k, the point of C at a c nearby has a distance from S, in c, of at
    most a multiple of (c - c_k)^2, on either side of c_k. (The paper says so of the limit a -> infinity, where the point is c = eps = 0.)

    By equation (20) the distance c + b sin^2 eps of a point of C from S is (a + b cos^2 psi) cos^2 theta at phi = pi. At c_k this is a turning
    point; near c_k the turning point is at phi = (k - 1/2) G(-c/b), theta is a Lipschitz function of phi, and G has a derivative. *)
Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Polhode Require HalfPhase.
From Polhode Require Import Uniqueness Oscillation Symmetry Curve.
Open Scope R_scope.
Local Notation G := HalfPhase.G.

Section Tangency.
Variables a b : R.
Hypothesis Ha : 0 < a.
Hypothesis Hb : 0 < b < 1.

Lemma theta_rate_bound p q : Rabs (theta_rate a b p q) <= b / (1 - b).
Proof.
assert (D := denominator b Hb p). unfold theta_rate. rewrite Rabs_div by lra. rewrite (Rabs_pos_eq (1 - b * cos p ^2)) by lra.
assert (A : Rabs (b * sin q * sin p * cos p) <= b).
{ replace (b * sin q * sin p * cos p) with (b * (sin q * (sin p * cos p))) by ring. rewrite Rabs_mult, (Rabs_pos_eq b) by lra.
  rewrite <- (Rmult_1_r b) at 2. apply Rmult_le_compat_l; [lra|]. assert (S := SIN_bound q). assert (S2 := SIN_bound p). assert (C2 := COS_bound p).
  rewrite !Rabs_mult. assert (Rabs (sin q) <= 1) by (apply Rabs_le; lra). assert (Rabs (sin p) <= 1) by (apply Rabs_le; lra). assert (Rabs (cos p) <= 1) by (apply Rabs_le; lra).
  assert (0 <= Rabs (sin q)) by apply Rabs_pos. assert (0 <= Rabs (sin p)) by apply Rabs_pos. assert (0 <= Rabs (cos p)) by apply Rabs_pos.
  assert (Rabs (sin p) * Rabs (cos p) <= 1) by nra. assert (0 <= Rabs (sin p) * Rabs (cos p)) by nra. nra. }
assert (I : / (1 - b * cos p ^2) <= / (1 - b)) by (apply Rinv_le_contravar; lra).
assert (0 < / (1 - b * cos p ^2)) by (apply Rinv_0_lt_compat; lra). unfold Rdiv.
apply Rmult_le_compat; trivial; try lra. apply Rabs_pos.
Qed.
(** How far C is from S, by how far phi = pi is from a turning point. *)
Lemma distance_from_S c psi theta T : centred_motion a b c psi theta -> cos (theta T) = 0 ->
  c + b * sin (PI/2 - psi PI) ^2 <= (a + b) * (b / (1 - b) * (PI - T))^2.
Proof.
intros M Z. rewrite sin_shift, <- (first_integral_at a b Hb c psi theta PI M), <- equation_20.
assert (L : Rabs (cos (theta PI)) <= b / (1 - b) * Rabs (PI - T)).
{ replace (cos (theta PI)) with (cos (theta PI) - cos (theta T)) by lra. apply Rle_trans with (1 := cos_lipschitz _ _).
  destruct (MVT_gen theta T PI (fun phi => theta_rate a b (psi phi) (theta phi))) as [z [_ E]].
  - intros z _. apply (proj1 M z).
  - intros z _. apply continuity_pt_filterlim, (ex_derive_continuous theta). exact (ex_intro _ _ (proj2 (proj1 M z))).
  - rewrite E, Rabs_mult. apply Rmult_le_compat_r; [apply Rabs_pos|apply theta_rate_bound]. }
assert (S : cos (theta PI) ^2 <= (b / (1 - b) * (PI - T))^2).
{ assert (B0 : 0 < b / (1 - b)) by (apply Rdiv_lt_0_compat; lra).
  rewrite <- (pow2_abs (cos (theta PI))), <- (pow2_abs (b / (1 - b) * (PI - T))), Rabs_mult, (Rabs_pos_eq (b / (1 - b))) by lra.
  apply pow_incr. split; [apply Rabs_pos|exact L]. }
assert (C := cos2_bound (psi PI)). assert (0 <= b * cos (psi PI) ^2 <= b) by (split; nra). assert (P := pow2_ge_0 (cos (theta PI))).
rewrite (Rmult_comm (a + b)). apply Rmult_le_compat; lra.
Qed.

(** The theorem. *)
Theorem tangent_at_every_meeting_point ck : meeting a b ck ->
  exists M m, 0 < M /\ 0 < m /\ forall c eps, -b < c < 0 -> Rabs (c - ck) < m -> curve_C a b c eps -> 0 <= c + b * sin eps ^2 <= M * (c - ck)^2.
Proof.
intros H. apply meeting_c in H; trivial. destruct H as [k [Hk [Hck Ek]]]. destruct (oscillation_of_c b Hb ck Hck) as [Huk _].
set (uk := - ck / b) in *. assert (K : 1 <= INR k) by (apply (le_INR 1); exact Hk). set (w := INR k - 1/2). assert (W : 0 < w) by (unfold w; lra).
assert (Tk : w * G a b uk = PI) by (rewrite Ek; unfold w; field; lra).
assert (DG := HalfPhase.G_derive a b Ha Hb uk ltac:(lra) ltac:(lra)). apply is_derive_Reals in DG.
match type of DG with derivable_pt_lim _ _ ?l => set (dG := l) in * end.
destruct (DG 1 ltac:(lra)) as [eta N]. assert (Eta := cond_pos eta). assert (A0 := Rabs_pos dG).
set (L := b / (1 - b) * (w * (Rabs dG + 1)) / b).
assert (L0 : 0 < L). { unfold L. apply Rdiv_lt_0_compat; [|lra]. apply Rmult_lt_0_compat; [apply Rdiv_lt_0_compat; lra|apply Rmult_lt_0_compat; lra]. }
exists ((a + b) * L^2), (b * eta). split; [apply Rmult_lt_0_compat; [lra|apply pow_lt, L0]|]. split; [apply Rmult_lt_0_compat; lra|].
intros c eps Hc Near C. split; [now apply (C_beside_S a b Ha Hb)|].
destruct (oscillation_of_c b Hb c Hc) as [Hu E]. set (u := - c / b) in *.
assert (M := centred_oscillation a b Ha Hb u Hu). rewrite E in M.
assert (Eps : eps = PI/2 - oscillation_psi a b u PI). { apply (lemma_1 a b Ha Hb c); trivial. eexists. eexists. split; [exact M|reflexivity]. }
assert (Z : cos (oscillation_theta a b u (w * G a b u)) = 0).
{ apply (turning_points a b u Ha Hb Hu). exists (Z.of_nat k - 1)%Z. rewrite minus_IZR, <- INR_IZR_INZ. unfold w. f_equal. lra. }
assert (D := distance_from_S c _ _ _ M Z). rewrite <- Eps in D. apply Rle_trans with (1 := D).
rewrite Rmult_assoc. apply Rmult_le_compat_l; [lra|]. rewrite <- Rpow_mult_distr, <- (pow2_abs (_ * (PI - _))), <- (pow2_abs (L * _)). apply pow_incr. split; [apply Rabs_pos|].
assert (B0 : 0 < b / (1 - b)) by (apply Rdiv_lt_0_compat; lra).
assert (Uc : u - uk = - (c - ck) / b) by (unfold u, uk; field; lra).
assert (GL : Rabs (G a b u - G a b uk) <= (Rabs dG + 1) * Rabs (u - uk)).
{ destruct (Req_dec u uk) as [->|D0]. { unfold Rminus. rewrite !Rplus_opp_r, Rabs_R0. lra. }
  assert (Q : Rabs (u - uk) < eta).
  { rewrite Uc, Rabs_div, Rabs_Ropp, (Rabs_pos_eq b) by lra. apply (Rmult_lt_reg_r b); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra. }
  specialize (N (u - uk) ltac:(lra) Q). replace (uk + (u - uk)) with u in N by ring.
  assert (Y := Rabs_triang ((G a b u - G a b uk) / (u - uk) - dG) dG). replace ((G a b u - G a b uk) / (u - uk) - dG + dG) with ((G a b u - G a b uk) / (u - uk)) in Y by ring.
  rewrite Rabs_div in Y by lra. assert (U0 : 0 < Rabs (u - uk)) by (apply Rabs_pos_lt; lra).
  apply (Rmult_le_reg_r (/ Rabs (u - uk))); [now apply Rinv_0_lt_compat|]. rewrite Rmult_assoc, Rinv_r by lra. unfold Rdiv in Y. lra. }
replace (PI - w * G a b u) with (- (w * (G a b u - G a b uk))) by (rewrite <- Tk; ring).
rewrite !Rabs_mult, Rabs_Ropp, Rabs_mult, (Rabs_pos_eq (b/(1-b))), (Rabs_pos_eq w), (Rabs_pos_eq L) by lra.
replace (L * Rabs (c - ck)) with (b/(1-b) * (w * ((Rabs dG + 1) * Rabs (u - uk)))).
2:{ rewrite Uc, Rabs_div, Rabs_Ropp, (Rabs_pos_eq b) by lra. unfold L. field. lra. }
apply Rmult_le_compat_l; [lra|]. apply Rmult_le_compat_l; [lra|exact GL].
Qed.
End Tangency.
