(** How the oscillating motion at a given phi depends on c = -b u, for all a > 0, 0 < b < 1. With sin psi = sqrt (1-u) sin t (Oscillation.v):
    the swing angle t = turn (phi) grows with u, continuously, and the motion with the smaller u reaches every psi of the rising branch first.
    Nothing is supposed on G or I. *)
Require Import Reals Lra Psatz Ratan.
From Coquelicot Require Import Coquelicot.
From Polhode Require Import HalfPhase Uniqueness Oscillation.
From Polhode Require Phase.
Open Scope R_scope.
Local Notation P := Phase.P.
Local Notation kernel := Phase.kernel.

Section SwingInC.
Variables a b : R.
Hypothesis Ha : 0 < a.
Hypothesis Hb : 0 < b < 1.

Lemma sqrt_ab_positive : 0 < sqrt (a*b).
Proof. apply sqrt_lt_R0, Rmult_lt_0_compat; lra. Qed.
Lemma h_mvt x y : 0 < x -> x < y -> exists z, x <= z <= y /\ h a b y - h a b x = dh a b z * (y - x).
Proof.
intros Hx L. destruct (MVT_gen (h a b) x y (dh a b)) as [z [Hz E]].
- intros z Hz. rewrite Rmin_left, Rmax_right in Hz by lra. apply h_derive; trivial. lra.
- intros z Hz. rewrite Rmin_left, Rmax_right in Hz by lra. apply continuity_pt_filterlim, h_continuous; trivial. lra.
- rewrite Rmin_left, Rmax_right in Hz by lra. exists z. now split.
Qed.
Lemma h_decreasing x y : 0 < x -> x < y -> h a b y < h a b x.
Proof. intros Hx L. destruct (h_mvt x y Hx L) as [z [Hz E]]. assert (D := dh_negative a b Ha Hb z ltac:(lra)). nra. Qed.
(** A bound of the slope of h to the right of m. *)
Definition slope (m : R) := (a + (a + 2)*b) / (2 * a * (m * sqrt m)).
Lemma slope_pos m : 0 < m -> 0 < slope m.
Proof.
intros Hm. assert (0 < sqrt m) by now apply sqrt_lt_R0. unfold slope. apply Rdiv_lt_0_compat; [nra|]. repeat apply Rmult_lt_0_compat; lra.
Qed.
Lemma dh_bound m x : 0 < m -> m <= x <= 1 -> - slope m <= dh a b x.
Proof.
intros Hm Hx. unfold dh, slope. assert (S : 0 < sqrt m) by now apply sqrt_lt_R0.
assert (0 <= b * x / a). { apply Rmult_le_pos; [apply Rmult_le_pos; lra|left; apply Rinv_0_lt_compat; lra]. }
assert (Q1 : m <= Q a b x) by (unfold Q; nra). assert (S1 : sqrt m <= sqrt (Q a b x)) by now apply sqrt_le_1_alt.
unfold Rdiv. rewrite <- Ropp_mult_distr_l. apply Ropp_le_contravar. apply Rmult_le_compat.
- assert (0 <= (a + 2) * b * x). { apply Rmult_le_pos; [apply Rmult_le_pos; lra|lra]. } lra.
- left. apply Rinv_0_lt_compat. repeat apply Rmult_lt_0_compat; lra.
- assert (0 <= (a + 2) * b) by (apply Rmult_le_pos; lra). nra.
- apply Rinv_le_contravar; [repeat apply Rmult_lt_0_compat; lra|]. apply Rmult_le_compat_l; [lra|]. apply Rmult_le_compat; lra.
Qed.
Lemma X_difference u v t : X v (cos t) - X u (cos t) = (v - u) * sin t ^2.
Proof. unfold X. assert (E := sin2_cos2 t). unfold Rsqr in E. assert (S : sin t ^2 = 1 - cos t ^2) by (simpl; lra). rewrite S. ring. Qed.

(** The phase phi = P t at a given swing angle 0 < t <= pi (t = pi is the return to psi = 0) falls as u grows, *)
Lemma kernel_order u v t : 0 < u -> u < v -> v < 1 -> sin t <> 0 -> kernel a b v t < kernel a b u t.
Proof.
intros Hu L Hv S. assert (D := X_difference u v t). assert (0 < sin t ^2) by now apply pow2_gt_0.
assert (0 < (v - u) * sin t ^2) by (apply Rmult_lt_0_compat; lra). assert (B := x_bounds u ltac:(lra) t).
unfold kernel. unfold Rdiv. apply Rmult_lt_compat_r; [apply Rinv_0_lt_compat, sqrt_ab_positive|]. apply h_decreasing; lra.
Qed.
Theorem P_order u v t : 0 < u -> u < v -> v < 1 -> 0 < t <= PI -> P a b v t < P a b u t.
Proof.
intros Hu L Hv Ht. unfold P. apply RInt_lt; [lra| | |].
- intros s _. apply Phase.kernel_continuous; lra.
- intros s _. apply Phase.kernel_continuous; lra.
- intros s Hs. apply kernel_order; trivial. apply Rgt_not_eq, sin_gt_0; lra.
Qed.
(** by a bounded amount. *)
Lemma kernel_near m u v t : 0 < m -> m <= u -> u < v -> v < 1 -> Rabs (kernel a b v t - kernel a b u t) <= slope m / sqrt (a*b) * (v - u).
Proof.
intros Hm Hu L Hv. assert (SP := slope_pos m Hm). assert (Q0 := sqrt_ab_positive). unfold kernel.
replace (h a b (X v (cos t)) / sqrt (a*b) - h a b (X u (cos t)) / sqrt (a*b)) with ((h a b (X v (cos t)) - h a b (X u (cos t))) * / sqrt (a*b)) by (field; lra).
assert (Qi : 0 < / sqrt (a*b)) by now apply Rinv_0_lt_compat.
rewrite Rabs_mult, (Rabs_pos_eq (/ sqrt (a*b))) by lra.
replace (slope m / sqrt (a*b) * (v - u)) with (slope m * (v - u) * / sqrt (a*b)) by (field; lra). apply Rmult_le_compat_r; [lra|].
assert (D := X_difference u v t). assert (S2 : 0 <= sin t ^2 <= 1).
{ split; [apply pow2_ge_0|]. assert (E := sin2_cos2 t). unfold Rsqr in E. assert (0 <= cos t * cos t) by (apply Rle_0_sqr). simpl. lra. }
assert (B := x_bounds u ltac:(lra) t). assert (B' := x_bounds v ltac:(lra) t).
destruct (Rle_lt_or_eq_dec (X u (cos t)) (X v (cos t))) as [C|C]; [nra| |].
- destruct (h_mvt (X u (cos t)) (X v (cos t)) ltac:(lra) C) as [z [Hz E]]. rewrite E, D.
  assert (N := dh_negative a b Ha Hb z ltac:(lra)). assert (M := dh_bound m z Hm ltac:(lra)).
  rewrite Rabs_mult, (Rabs_left (dh a b z)) by lra. rewrite Rabs_pos_eq by nra. apply Rmult_le_compat; [lra|nra|lra|nra].
- rewrite C, Rminus_eq_0, Rabs_R0. apply Rmult_le_pos; lra.
Qed.
Lemma P_near m u v t : 0 < m -> m <= u -> u < v -> v < 1 -> 0 <= t -> Rabs (P a b v t - P a b u t) <= t * (slope m / sqrt (a*b) * (v - u)).
Proof.
intros Hm Hu L Hv Ht. unfold P.
assert (E : RInt (fun s => kernel a b v s - kernel a b u s) 0 t = RInt (kernel a b v) 0 t - RInt (kernel a b u) 0 t).
{ apply (RInt_minus (V:=R_CompleteNormedModule)); apply Phase.kernel_integrable; lra. }
rewrite <- E. replace t with (t - 0) at 2 by ring. apply abs_RInt_le_const; trivial.
- apply (ex_RInt_minus (V:=R_NormedModule)); apply Phase.kernel_integrable; lra.
- intros s _. now apply kernel_near.
Qed.

(** The swing angle at a phi > 0 (it is positive) grows with u, as long as it is at most pi, *)
Lemma turn_positive u phi : 0 < u < 1 -> 0 < phi -> 0 < turn a b u phi.
Proof.
intros Hu Hp. apply Rnot_le_lt. intros [N|N].
- apply (P_increasing_strictly a b u Ha Hb Hu) in N. rewrite P_zero, P_turn in N by trivial. lra.
- assert (E := P_turn a b u Ha Hb Hu phi). rewrite N, P_zero in E. lra.
Qed.
Lemma turn_below u phi t : 0 < u < 1 -> phi < P a b u t -> turn a b u phi < t.
Proof.
intros Hu H. apply Rnot_le_lt. intros [N|N].
- apply (P_increasing_strictly a b u Ha Hb Hu) in N. rewrite P_turn in N by trivial. lra.
- rewrite N, P_turn in H by trivial. lra.
Qed.
Lemma turn_above u phi t : 0 < u < 1 -> P a b u t < phi -> t < turn a b u phi.
Proof.
intros Hu H. apply Rnot_le_lt. intros [N|N].
- apply (P_increasing_strictly a b u Ha Hb Hu) in N. rewrite P_turn in N by trivial. lra.
- rewrite <- N, P_turn in H by trivial. lra.
Qed.
Theorem turn_order u v phi : 0 < u -> u < v -> v < 1 -> 0 < phi -> turn a b v phi <= PI -> turn a b u phi < turn a b v phi.
Proof.
intros Hu L Hv Hp T. assert (T0 := turn_positive v phi ltac:(lra) Hp). apply turn_below; [lra|].
rewrite <- (P_turn a b v Ha Hb ltac:(lra) phi) at 1. apply P_order; trivial. lra.
Qed.
(** and depends on u continuously. *)
Lemma turn_near m u v phi : 0 < m -> m <= u -> u < v -> v < 1 -> 0 < phi ->
  Rabs (turn a b v phi - turn a b u phi) <= phi * (slope m / sqrt (a*b) * (v - u)) / (slowest a b)^2.
Proof.
intros Hm Hu L Hv Hp. assert (S := slowest_pos a b Ha Hb). set (t := turn a b u phi). set (w := turn a b v phi).
assert (T0 : 0 < t) by (apply turn_positive; lra).
assert (Et : P a b u t = phi) by (apply P_turn; lra). assert (Ew : P a b v w = phi) by (apply P_turn; lra).
assert (N := P_near m u v t Hm Hu L Hv ltac:(lra)). rewrite Et, <- Ew in N.
assert (K : slowest a b * Rabs (w - t) <= Rabs (P a b v t - P a b v w)).
{ destruct (Rtotal_order w t) as [C|[C|C]].
  - assert (I := P_increasing a b v Ha Hb ltac:(lra) w t C). rewrite Rabs_left by lra. assert (J := Rle_abs (P a b v t - P a b v w)). lra.
  - rewrite C, !Rminus_eq_0, !Rabs_R0. lra.
  - assert (I := P_increasing a b v Ha Hb ltac:(lra) t w C). rewrite Rabs_pos_eq by lra. assert (J := Rle_abs (- (P a b v t - P a b v w))). rewrite Rabs_Ropp in J. lra. }
assert (B : slowest a b * t <= phi). { assert (I := P_increasing a b u Ha Hb ltac:(lra) 0 t T0). rewrite P_zero, Et in I. lra. }
set (q := slope m / sqrt (a*b) * (v - u)) in *.
assert (Q0 : 0 <= q). { apply Rmult_le_pos; [|lra]. left. apply Rdiv_lt_0_compat; [now apply slope_pos|apply sqrt_ab_positive]. }
apply (Rmult_le_reg_r ((slowest a b)^2)); [now apply pow_lt|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by (apply pow_nonzero; lra).
rewrite Rmult_1_r. apply Rle_trans with (slowest a b * (t * q)).
- replace (Rabs (w - t) * slowest a b ^2) with (slowest a b * (slowest a b * Rabs (w - t))) by ring. apply Rmult_le_compat_l; lra.
- replace (slowest a b * (t * q)) with (slowest a b * t * q) by ring. apply Rmult_le_compat_r; lra.
Qed.
Theorem turn_continuous_in_u u phi : 0 < u < 1 -> 0 < phi -> continuity_pt (fun u => turn a b u phi) u.
Proof.
intros Hu Hp. assert (S := slowest_pos a b Ha Hb). set (m := u/2). set (K := phi * (slope m / sqrt (a*b)) / (slowest a b)^2).
assert (Hm : 0 < m) by (unfold m; lra).
assert (K0 : 0 < K). { unfold K. apply Rdiv_lt_0_compat; [|now apply pow_lt]. apply Rmult_lt_0_compat; [lra|]. apply Rdiv_lt_0_compat; [now apply slope_pos|apply sqrt_ab_positive]. }
assert (N : forall v w, m <= v -> v < w -> w < 1 -> Rabs (turn a b w phi - turn a b v phi) <= K * (w - v)).
{ intros v w H1 H2 H3. assert (J := turn_near m v w phi Hm H1 H2 H3 Hp). unfold K.
  replace (phi * (slope m / sqrt (a*b)) / (slowest a b)^2 * (w - v)) with (phi * (slope m / sqrt (a*b) * (w - v)) / (slowest a b)^2); trivial.
  field. split; [apply Rgt_not_eq, sqrt_ab_positive|lra]. }
intros e He. exists (Rmin (e/K/2) (Rmin (u/2) (1-u))). split.
- apply Rmin_pos; [|apply Rmin_pos; lra]. apply Rdiv_lt_0_compat; [|lra]. apply Rdiv_lt_0_compat; lra.
- intros v [_ D]. simpl in *. unfold R_dist in *.
  assert (D1 := Rlt_le_trans _ _ _ D (Rmin_l _ _)). assert (D2 := Rlt_le_trans _ _ _ D (Rmin_r _ _)).
  assert (D3 := Rlt_le_trans _ _ _ D2 (Rmin_l _ _)). assert (D4 := Rlt_le_trans _ _ _ D2 (Rmin_r _ _)).
  apply Rabs_def2 in D3. apply Rabs_def2 in D4.
  assert (E1 : K * Rabs (v - u) < e). { apply (Rmult_lt_compat_l K) in D1; trivial. replace (K * (e/K/2)) with (e/2) in D1 by (field; lra). lra. }
  destruct (Rtotal_order v u) as [C|[C|C]].
  + assert (J := N v u ltac:(unfold m; lra) C ltac:(lra)). rewrite <- Rabs_Ropp. rewrite Ropp_minus_distr. rewrite Rabs_left in E1 by lra.
    replace (K * - (v - u)) with (K * (u - v)) in E1 by ring. lra.
  + rewrite C, Rminus_eq_0, Rabs_R0. lra.
  + assert (J := N u v ltac:(unfold m; lra) C ltac:(lra)). rewrite Rabs_pos_eq in E1 by lra. lra.
Qed.

(** Of two motions the one with the smaller u is ahead: psi_of w t is the swing angle at which it has the psi that the other one has at t,
    sqrt (1-u) sin (psi_of w t) = sqrt (1-v) sin t, and it comes to it at a smaller phi. *)
Definition ratio (u v : R) := (v - u) / (1 - u).
Lemma ratio_bounds u v : 0 < u -> u < v -> v < 1 -> 0 < ratio u v < 1.
Proof.
intros. unfold ratio. split; [apply Rdiv_lt_0_compat; lra|]. apply (Rmult_lt_reg_r (1 - u)); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra.
Qed.
Lemma ratio_root u v : 0 < u -> u < v -> v < 1 -> sqrt (1 - u) * sqrt (1 - ratio u v) = sqrt (1 - v).
Proof. intros. rewrite <- sqrt_mult_alt by lra. f_equal. unfold ratio. field. lra. Qed.
Lemma same_psi u v t : 0 < u -> u < v -> v < 1 -> X u (cos (psi_of (ratio u v) t)) = X v (cos t).
Proof.
intros Hu L Hv. assert (W := ratio_bounds u v Hu L Hv). unfold X at 1. rewrite (cos_psi_square _ W). unfold X, ratio. field. lra.
Qed.
Theorem smaller_u_is_ahead u v t : 0 < u -> u < v -> v < 1 -> 0 < t -> P a b u (psi_of (ratio u v) t) < P a b v t.
Proof.
intros Hu L Hv Ht. assert (W := ratio_bounds u v Hu L Hv). set (w := ratio u v) in *.
set (g := fun t => P a b v t - P a b u (psi_of w t)).
set (dg := fun t => kernel a b v t * (1 - sqrt (1 - w) * cos t / sqrt (X w (cos t)))).
assert (D : forall s, is_derive g s (dg s)).
{ intros s. assert (E : dg s = kernel a b v s - sqrt (1 - w) * cos s / sqrt (X w (cos s)) * kernel a b u (psi_of w s)).
  { assert (K : kernel a b u (psi_of w s) = kernel a b v s) by (unfold kernel, w; rewrite same_psi; trivial). rewrite K. unfold dg. ring. }
  rewrite E. apply (is_derive_minus (P a b v) (fun s => P a b u (psi_of w s))).
  - apply P_derive; lra.
  - apply (is_derive_comp (P a b u) (psi_of w)); [apply P_derive; lra|now apply psi_of_derive]. }
assert (G0 : g 0 = 0). { unfold g, psi_of. now rewrite sin_0, Rmult_0_r, asin_0, !P_zero, Rminus_eq_0. }
assert (F : forall s, 0 < dg s).
{ intros s. apply Rmult_lt_0_compat; [apply kernel_pos; lra|]. assert (B := x_bounds w W s). assert (S : 0 < sqrt (X w (cos s))) by (apply sqrt_lt_R0; lra).
  assert (C : sqrt (1 - w) * cos s < sqrt (X w (cos s))).
  { apply Rle_lt_trans with (1 := Rle_abs _). rewrite <- sqrt_Rsqr_abs. apply sqrt_lt_1_alt. split; [apply Rle_0_sqr|].
    rewrite Rsqr_mult, Rsqr_sqrt by lra. unfold X, Rsqr. simpl. lra. }
  assert (sqrt (1 - w) * cos s / sqrt (X w (cos s)) < 1); [|lra].
  apply (Rmult_lt_reg_r (sqrt (X w (cos s)))); trivial. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra. }
destruct (MVT_gen g 0 t dg) as [z [_ E]].
- intros s _. apply D.
- intros s _. apply continuity_pt_filterlim, (ex_derive_continuous g). exists (dg s). apply D.
- rewrite G0 in E. assert (0 < dg z * (t - 0)) by (apply Rmult_lt_0_compat; [apply F|lra]). unfold g in E. fold g in E. change (g t - 0 = dg z * (t - 0)) in E. unfold g in E. lra.
Qed.
End SwingInC.
