(** The oscillating motions, -b < c < 0: the Montgomery phase of every one of them is 2 G(u), u = -c/b.
    With x = cos^2 psi the point (s, q) = (sin psi / sqrt (1-u), cos theta sqrt (b(a+bx)) / (b sqrt (1-u))), with its signs,
    lies on the unit circle by eq. (7) and turns one way only: its angle alpha (the amplitude of the elliptic functions) always grows,
    determines the momentum up to whole turns, and phi' = kernel(alpha) alpha' with the kernel of Phase.v, smooth at the turning points. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Polhode Require HalfPhase Phase.
From Polhode Require Import FreeBody Loop.
Open Scope R_scope.

(** G(u) is half of the gain over a whole turn of alpha. *)
Lemma half_turn_of_G a b u : 0 < a -> 0 < b < 1 -> 0 < u < 1 -> forall y, Phase.P a b u (y + PI) - Phase.P a b u y = HalfPhase.G a b u.
Proof.
intros Ha Hb Hu y. rewrite (gain_of_half_turn (Phase.P a b u) (Phase.kernel a b u)) with (z := -(PI/2)).
- replace (-(PI/2) + PI) with (PI/2) by field. now apply Phase.P_swing.
- intros t. now apply Phase.P_derive.
- intros t. unfold Phase.kernel, HalfPhase.X. rewrite neg_cos. replace ((- cos t)^2) with (cos t ^2) by ring. reflexivity.
Qed.

Section Oscillating.
Variable moment : axis -> R.
Variables th ps ph : R -> R.
Hypothesis M : motion moment th ps ph.
Notation Iy := (moment y_axis).
Notation a := (par_a moment).
Notation b := (par_b moment).
Notation x t := (cos (ps t) ^ 2).
Notation c := (par_c moment (th 0) (ps 0)).
Hypothesis Hc : - b < c < 0.
Notation u := (- c / b).
Let I := moments moment th ps ph M.
Let A := a_positive moment th ps ph M.
Let B := b_range moment th ps ph M.

Lemma u_range : 0 < u < 1.
Proof. destruct B as [B1 B2]. split. apply Rdiv_lt_0_compat; lra. apply (Rmult_lt_reg_r b); trivial. field_simplify; lra. Qed.
Lemma bu : b * u = - c.
Proof. destruct B as [B1 B2]. field. lra. Qed.
(** psi stays where cos^2 psi >= u. *)
Lemma x_at_least_u t : u <= x t.
Proof.
destruct B as [B1 B2]. assert (E := c_plus_bx moment th ps ph M t). apply (Rmult_le_reg_l b); trivial. rewrite bu. lra.
Qed.
Lemma cos_psi_sign : exists k, k * k = 1 /\ forall t, 0 < k * cos (ps t).
Proof.
apply (sign_of (fun t => cos (ps t))).
- intros t. apply (continuous_comp ps cos). apply (ex_derive_continuous ps), (ps_differentiable _ _ _ _ M). apply continuous_cos.
- intros t E. assert (X := x_at_least_u t). rewrite E in X. assert (U := u_range). simpl in X. lra.
Qed.

Section Sign.
Variable k : R.
Hypothesis Hk : k * k = 1.
Hypothesis Kc : forall t, 0 < k * cos (ps t).
Let r := sqrt (1 - u).
Let g t := sqrt (b * (a + b * x t)).
Let s t := k * sin (ps t) / r.
Let q t := cos (th t) * g t / (r * b).
(** The speed of the point. *)
Let w t := k * cos (ps t) * g t / Iy.

Lemma r_positive : 0 < r.
Proof. apply sqrt_lt_R0. assert (U := u_range). lra. Qed.
Lemma r_squared : r * r = 1 - u.
Proof. apply sqrt_sqrt. assert (U := u_range). lra. Qed.
Lemma radicand_positive t : 0 < b * (a + b * x t).
Proof. destruct B as [B1 B2]. apply Rmult_lt_0_compat; trivial. apply (denominator_positive moment th ps ph M). Qed.
Lemma g_positive t : 0 < g t.
Proof. apply sqrt_lt_R0, radicand_positive. Qed.
Lemma g_squared t : g t * g t = b * (a + b * x t).
Proof. apply sqrt_sqrt, Rlt_le, radicand_positive. Qed.
Lemma on_the_circle t : s t * s t + q t * q t = 1.
Proof.
destruct B as [B1 B2]. assert (R0 := r_positive). assert (R2 := r_squared). assert (G2 := g_squared t).
assert (C := cos_squared moment th ps ph M t). assert (P := sin2_cos2 (ps t)). unfold Rsqr in P.
assert (E1 : s t * s t = (1 - x t) / (1 - u)).
{ unfold s. rewrite <- R2. replace (1 - x t) with (k * k * (sin (ps t) * sin (ps t))) by (rewrite Hk; simpl; lra). field. lra. }
assert (E2 : q t * q t = (x t - u) / (1 - u)).
{ unfold q. rewrite <- R2. replace (x t - u) with (b * (a + b * x t) * cos (th t) ^ 2 / (b * b)).
  2:{ rewrite Rmult_assoc, C. field. lra. }
  rewrite <- G2. field. lra. }
rewrite E1, E2. assert (U := u_range). set (v := u) in *. field. lra.
Qed.
Lemma g_derive t : is_derive g t (- (b * cos (ps t) * sin (ps t) * g t * cos (th t) / Iy)).
Proof.
assert (G0 := g_positive t). assert (G2 := g_squared t). assert (Q := radicand_positive t). destruct B as [B1 B2].
evar_last. apply (is_derive_comp sqrt (fun t => b * (a + b * x t))).
- instantiate (1 := / (2 * g t)). unfold g. auto_derive; trivial. simpl. field. apply Rgt_not_eq. exact G0.
- auto_derive. apply (ps_differentiable _ _ _ _ M). reflexivity.
- change (Derive (fun y => ps y) t) with (Derive ps t). rewrite (psi_rate moment th ps ph M). unfold scal; simpl; unfold mult; simpl.
  replace (a + b * (cos (ps t) * (cos (ps t) * 1))) with (g t * g t / b) by (rewrite G2; simpl; field; lra).
  match goal with |- @eq _ ?l ?r => change (@eq R l r) end. field. lra.
Qed.
Lemma s_derive t : is_derive s t (w t * q t).
Proof.
assert (G2 := g_squared t). assert (R0 := r_positive). destruct B as [B1 B2].
unfold s. auto_derive. apply (ps_differentiable _ _ _ _ M).
change (Derive (fun y => ps y) t) with (Derive ps t). rewrite (psi_rate moment th ps ph M). unfold w, q.
replace (a + b * x t) with (g t * g t / b) by (rewrite G2; field; lra). field. lra.
Qed.
Lemma q_derive t : is_derive q t (- (w t * s t)).
Proof.
assert (G2 := g_squared t). assert (R0 := r_positive). destruct B as [B1 B2]. assert (T := sin2_cos2 (th t)). unfold Rsqr in T.
evar_last. 
apply (is_derive_ext (fun t => scal (/ (r * b)) (cos (th t) * g t))). { intros v. unfold q, scal; simpl; unfold mult; simpl. unfold Rdiv. apply Rmult_comm. }
apply (is_derive_scal (fun t => cos (th t) * g t)). apply (is_derive_mult (fun t => cos (th t)) g).
apply (is_derive_comp cos th). apply is_derive_Reals, derivable_pt_lim_cos. apply (th_derive moment th ps ph M). apply g_derive. intros; apply Rmult_comm.
rewrite (theta_rate moment th ps ph M). unfold plus, scal; simpl; unfold mult; simpl. unfold w, s.
replace (- (k * cos (ps t) * g t / Iy * (k * sin (ps t) / r))) with (- (k * k * (sin (th t) * sin (th t) + cos (th t) * cos (th t)) * cos (ps t) * g t / Iy * (sin (ps t) / r))).
2:{ rewrite T. field. lra. }
rewrite Hk. match goal with |- @eq _ ?l ?r => change (@eq R l r) end. field. lra.
Qed.

Lemma w_continuous t : continuous w t.
Proof.
apply (ex_derive_continuous w). unfold w. apply (ex_derive_mult (fun t => k * cos (ps t) * g t) (fun _ => / Iy)). 2: apply ex_derive_const.
apply (ex_derive_mult (fun t => k * cos (ps t)) g). auto_derive. apply (ps_differentiable _ _ _ _ M). eexists. apply g_derive.
Qed.
Lemma kcos t : k * cos (ps t) = sqrt (x t).
Proof. replace (x t) with (k * k * (cos (ps t) * cos (ps t))) by (rewrite Hk; ring). replace (k * k * (cos (ps t) * cos (ps t))) with (Rsqr (k * cos (ps t))) by (unfold Rsqr; ring). rewrite sqrt_Rsqr; trivial. apply Rlt_le, Kc. Qed.
Lemma w_bound t : sqrt u * sqrt (b * a) / Iy <= w t.
Proof.
destruct B as [B1 B2]. unfold w. rewrite kcos. unfold Rdiv. apply Rmult_le_compat_r. { apply Rlt_le, Rinv_0_lt_compat, I. }
apply Rmult_le_compat; try apply sqrt_pos. apply sqrt_le_1_alt, x_at_least_u. apply sqrt_le_1_alt.
apply Rmult_le_compat_l; [lra|]. assert (0 <= b * x t) by (apply Rmult_le_pos; [lra|apply pow2_ge_0]). lra.
Qed.
Lemma w_bound_positive : 0 < sqrt u * sqrt (b * a) / Iy.
Proof.
destruct B as [B1 B2]. assert (U := u_range). apply Rdiv_lt_0_compat. 2: apply I. apply Rmult_lt_0_compat; apply sqrt_lt_R0. lra. now apply Rmult_lt_0_compat.
Qed.

(** The angle of the point. *)
Lemma amplitude_exists : exists al, (forall t, is_derive al t (w t)) /\ forall t, sin (al t) = s t /\ cos (al t) = q t.
Proof.
destruct (angle_lift q s w) as [al [D E]].
- intros t. rewrite Rplus_comm. apply on_the_circle.
- apply w_continuous.
- apply q_derive.
- apply s_derive.
- exists al. split; trivial. intros t. destruct (E t) as [E1 E2]. split; trivial.
Qed.

Section Amplitude.
Variable al : R -> R.
Hypothesis Dal : forall t, is_derive al t (w t).
Hypothesis point : forall t, sin (al t) = s t /\ cos (al t) = q t.

Lemma X_is_x t : HalfPhase.X u (cos (al t)) = x t.
Proof.
assert (E := sin2_cos2 (al t)). unfold Rsqr in E. destruct (point t) as [P1 P2]. unfold HalfPhase.X.
replace (cos (al t) ^ 2) with (1 - sin (al t) * sin (al t)) by (simpl; lra). rewrite P1. rewrite <- r_squared. unfold s. assert (R0 := r_positive).
assert (P := sin2_cos2 (ps t)). unfold Rsqr in P. assert (R2 := r_squared).
replace (r * r * (1 - k * sin (ps t) / r * (k * sin (ps t) / r))) with (r * r - k * k * (sin (ps t) * sin (ps t))) by (field; lra). rewrite Hk. simpl. lra.
Qed.
Lemma phi_by_amplitude t : is_derive ph t (Phase.kernel a b u (al t) * w t).
Proof.
destruct B as [B1 B2]. assert (A' := A). assert (I' := I). assert (X0 := x_at_least_u t). assert (U := u_range).
evar_last. apply (ph_derive moment th ps ph M). rewrite (phi_rate moment th ps ph M). unfold Phase.kernel. rewrite X_is_x. unfold HalfPhase.h, w.
assert (E : sqrt (HalfPhase.Q a b (x t)) * sqrt (a * b) = k * cos (ps t) * g t).
{ rewrite kcos. unfold g. rewrite <- !sqrt_mult_alt. f_equal. unfold HalfPhase.Q. field. lra. lra. apply Rlt_le, HalfPhase.Q_pos; lra. }
assert (S1 : 0 < sqrt (HalfPhase.Q a b (x t))) by (apply sqrt_lt_R0, HalfPhase.Q_pos; lra).
assert (S2 : 0 < sqrt (a * b)) by (apply sqrt_lt_R0; now apply Rmult_lt_0_compat).
rewrite <- E. field. lra.
Qed.
Lemma phi_gain v t : ph t - ph v = Phase.P a b u (al t) - Phase.P a b u (al v).
Proof.
apply (gain_by_lift ph al w (Phase.P a b u) (Phase.kernel a b u)); trivial.
- intros y. apply Phase.P_derive. exact A. exact B. apply u_range.
- apply phi_by_amplitude.
Qed.
Lemma amplitude_determines v t : same_momentum th ps v t <-> cos (al v) = cos (al t) /\ sin (al v) = sin (al t).
Proof.
rewrite same_momentum_angles by apply (chart _ _ _ _ M).
destruct (point v) as [S1 Q1]. destruct (point t) as [S2 Q2]. rewrite S1, S2, Q1, Q2. assert (R0 := r_positive). destruct B as [B1 B2].
assert (K0 : k <> 0) by (intros E; rewrite E in Hk; lra).
split.
- intros [H1 [H2 H3]]. unfold q, s, g. rewrite H1, H2, H3. split; reflexivity.
- intros [H1 H2].
  assert (S : sin (ps v) = sin (ps t)).
  { unfold s in H2. apply (f_equal (fun y => y * r / k)) in H2. replace (k * sin (ps v) / r * r / k) with (sin (ps v)) in H2 by (field; lra).
    replace (k * sin (ps t) / r * r / k) with (sin (ps t)) in H2 by (field; lra). exact H2. }
  assert (Xe : x v = x t).
  { assert (P := sin2_cos2 (ps v)). assert (P' := sin2_cos2 (ps t)). unfold Rsqr in P, P'. rewrite S in P. simpl. lra. }
  assert (C : cos (ps v) = cos (ps t)).
  { apply (Rmult_eq_reg_l k); trivial. rewrite !kcos, Xe. reflexivity. }
  split; [|split; trivial].
  assert (G0 := g_positive t). assert (Ge : g v = g t) by (unfold g; now rewrite Xe). unfold q in H1. rewrite Ge in H1.
  apply (f_equal (fun y => y * (r * b) / g t)) in H1. replace (cos (th v) * g t / (r * b) * (r * b) / g t) with (cos (th v)) in H1 by (field; lra).
  replace (cos (th t) * g t / (r * b) * (r * b) / g t) with (cos (th t)) in H1 by (field; lra). exact H1.
Qed.
(** Half a turn of alpha, from one turning point to the next, and a whole turn. *)
Lemma gain_over_half_turn v t : al t = al v + PI -> ph t - ph v = HalfPhase.G a b u.
Proof. intros E. rewrite phi_gain, E. apply half_turn_of_G. exact A. exact B. apply u_range. Qed.
Lemma gain_over_turn v t : al t = al v + 2*PI -> ph t - ph v = 2 * HalfPhase.G a b u.
Proof.
intros E. rewrite phi_gain, E. assert (E1 := half_turn_of_G a b u A B u_range (al v)). assert (E2 := half_turn_of_G a b u A B u_range (al v + PI)).
replace (al v + PI + PI) with (al v + 2*PI) in E2 by ring. lra.
Qed.
(** Turning points: cos theta = 0. *)
Lemma turning_point t : cos (th t) = 0 <-> cos (al t) = 0.
Proof.
destruct (point t) as [_ ->]. unfold q. assert (G0 := g_positive t). assert (R0 := r_positive). destruct B as [B1 B2]. split.
- intros ->. unfold Rdiv. ring.
- intros E. apply (f_equal (fun y => y * (r * b) / g t)) in E. replace (cos (th t) * g t / (r * b) * (r * b) / g t) with (cos (th t)) in E by (field; lra). rewrite E. field. lra.
Qed.
End Amplitude.
End Sign.

(** The momentum of an oscillating motion does return, from every time on. *)
Theorem oscillating_loop_exists t0 : exists t1, one_loop th ps t0 t1.
Proof.
destruct cos_psi_sign as [k [Hk Kc]]. destruct (amplitude_exists k Hk) as [al [D P]].
exact (loop_exists th ps al _ _ w_bound_positive D (w_bound k Hk Kc) (amplitude_determines k Hk Kc al P) t0).
Qed.
(** The Montgomery phase of an oscillating motion: over one loop of the momentum, wherever it starts, phi gains 2 G(-c/b). Eqs. (10) to (14). *)
Theorem oscillating_phase t0 t1 : one_loop th ps t0 t1 -> ph t1 - ph t0 = 2 * HalfPhase.G a b u.
Proof.
intros L. destruct cos_psi_sign as [k [Hk Kc]]. destruct (amplitude_exists k Hk) as [al [D P]]. apply (gain_over_turn k Hk Kc al D P).
exact (loop_is_turn th ps al _ _ w_bound_positive D (w_bound k Hk Kc) (amplitude_determines k Hk Kc al P) t0 t1 L).
Qed.
(** Between two consecutive turning points (cos theta = 0), whichever way psi swings, phi gains G(-c/b). *)
Definition consecutive_turning_points (t0 t1 : R) := t0 < t1 /\ cos (th t0) = 0 /\ cos (th t1) = 0 /\ forall t, t0 < t < t1 -> cos (th t) <> 0.
Lemma turning_points_are_half_a_turn (al dal : R -> R) (m t0 t1 : R) : 0 < m -> (forall t, is_derive al t (dal t)) -> (forall t, m <= dal t) ->
  (forall t, cos (th t) = 0 <-> cos (al t) = 0) -> consecutive_turning_points t0 t1 -> al t1 = al t0 + PI.
Proof.
intros Hm D F E [L [Z0 [Z1 N]]]. assert (HPI := PI_RGT_0). apply E in Z0. apply E in Z1.
assert (Inc := fun v t H => al_increases al dal m Hm D F v t H).
assert (S : forall d, 0 < d < PI -> cos (al t0 + d) <> 0).
{ intros d Hd. rewrite cos_plus, Z0. assert (Q := sin2_cos2 (al t0)). rewrite Z0 in Q. unfold Rsqr in Q. assert (0 < sin d) by (apply sin_gt_0; lra).
  intros W. assert (sin (al t0) * sin d = 0) by lra. apply Rmult_integral in H0. destruct H0 as [H0|H0]; [rewrite H0 in Q|]; lra. }
assert (L1 := Inc t0 t1 L). destruct (Rtotal_order (al t1) (al t0 + PI)) as [W|[W|W]]; trivial.
- exfalso. apply (S (al t1 - al t0)); [lra|]. replace (al t0 + (al t1 - al t0)) with (al t1) by ring. exact Z1.
- exfalso. destruct (IVT_gen al t0 t1 (al t0 + PI)) as [t [T Et]].
  + intros v. apply continuity_pt_filterlim. apply (ex_derive_continuous al). eexists. apply D.
  + rewrite Rmin_left, Rmax_right by lra. lra.
  + rewrite Rmin_left, Rmax_right in T by lra. apply (N t).
    * split; apply Rnot_le_lt; intros [V|V]; try (assert (V' := Inc _ _ V)); try rewrite V in Et; try rewrite <- V in Et; lra.
    * apply E. rewrite Et, neg_cos, Z0. ring.
Qed.
Theorem swing_phase t0 t1 : consecutive_turning_points t0 t1 -> ph t1 - ph t0 = HalfPhase.G a b u.
Proof.
intros T. destruct cos_psi_sign as [k [Hk Kc]]. destruct (amplitude_exists k Hk) as [al [D P]]. apply (gain_over_half_turn k Hk Kc al D P).
exact (turning_points_are_half_a_turn al _ _ t0 t1 w_bound_positive D (w_bound k Hk Kc) (turning_point k al P) T).
Qed.
(** There and back is one loop of the momentum, with the phase 2 G(-c/b). *)
Theorem two_swings_are_one_loop t0 t1 t2 : consecutive_turning_points t0 t1 -> consecutive_turning_points t1 t2 ->
  one_loop th ps t0 t2 /\ ph t2 - ph t0 = 2 * HalfPhase.G a b u.
Proof.
intros T1 T2. assert (E1 := swing_phase _ _ T1). assert (E2 := swing_phase _ _ T2). split; [|lra].
destruct cos_psi_sign as [k [Hk Kc]]. destruct (amplitude_exists k Hk) as [al [D P]].
assert (A1 := turning_points_are_half_a_turn al _ _ t0 t1 w_bound_positive D (w_bound k Hk Kc) (turning_point k al P) T1).
assert (A2 := turning_points_are_half_a_turn al _ _ t1 t2 w_bound_positive D (w_bound k Hk Kc) (turning_point k al P) T2).
apply (turn_is_loop th ps al _ _ w_bound_positive D (w_bound k Hk Kc) (amplitude_determines k Hk Kc al P)). lra.
Qed.
End Oscillating.
