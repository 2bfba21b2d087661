(** The oscillating motions exist, in closed form: a solution of the paper's reduced system (18), (19) on all of R for every
    -b < c < 0, c = -b u. With sin psi = sqrt (1-u) sin t, equation (9) becomes dphi/dt = kernel t, smooth and positive (Phase.v), so that
    phi = P t has an inverse t = turn phi on R. No theorem of Picard is needed. The turning points are t = pi/2 + k pi, the passages through
    psi = 0 are t = k pi, and P (t + pi) = P t + G u. *)
Require Import Reals Lra Psatz Ratan.
From Coquelicot Require Import Coquelicot.
From Polhode Require Import HalfPhase Uniqueness.
From Polhode Require Phase.
Open Scope R_scope.
Local Notation P := Phase.P.
Local Notation kernel := Phase.kernel.

(** The inverse of P: the greatest t with P t <= phi. *)
Definition turn (a b u phi : R) : R := real (Lub_Rbar (fun t => P a b u t <= phi)).
(** sin psi = sqrt (1-u) sin t, and cos theta = sqrt (b (1-u)/(a + b cos^2 psi)) cos t: psi and theta of the motion, as functions of phi. *)
Definition psi_of (u t : R) := asin (sqrt (1 - u) * sin t).
Definition cos_theta_of (a b u t : R) := sqrt b * sqrt (1 - u) * cos t / sqrt (a + b * X u (cos t)).
Definition theta_of (a b u t : R) := acos (cos_theta_of a b u t).
Definition oscillation_psi (a b u phi : R) := psi_of u (turn a b u phi).
Definition oscillation_theta (a b u phi : R) := theta_of a b u (turn a b u phi).

Lemma theta_algebra B d g q r s v : 0 < B -> 0 < d -> 0 < g -> 0 < q ->
  / (d / (B * g * q)) * (B * r * s * v / (q * q)) = B * B * (v / q) * (r * s) * g / d.
Proof. intros. field. repeat split; apply Rgt_not_eq; assumption. Qed.

Lemma opposite_derive t : is_derive (fun t => - t) t (-1).
Proof. auto_derive; trivial. Qed.
Lemma shift_derive d t : is_derive (fun t => t + d) t 1.
Proof. auto_derive; trivial. Qed.

(** Coquelicot's carriers hide from ring that a goal is an equation of reals. *)
Ltac in_R := match goal with |- @eq _ ?l ?r => change (@eq R l r) end.

Section Oscillation.
Variables a b u : R.
Hypothesis Ha : 0 < a.
Hypothesis Hb : 0 < b < 1.
Hypothesis Hu : 0 < u < 1.
Notation x t := (X u (cos t)).

Lemma x_bounds t : u <= x t <= 1.
Proof. unfold X. assert (H := cos2_bound t). assert (0 <= (1 - u) * cos t ^2) by (apply Rmult_le_pos; lra). nra. Qed.
Lemma ax_pos t : 0 < a + b * x t.
Proof. assert (H := x_bounds t). assert (0 < b * x t) by (apply Rmult_lt_0_compat; lra). lra. Qed.
Lemma bx_small t : 1 - b <= 1 - b * x t.
Proof. assert (H := x_bounds t). nra. Qed.

(** The kernel, (1 - b x)/sqrt ((a + b x) b x) with x = cos^2 psi. *)
Lemma kernel_value t : kernel a b u t = (1 - b * x t) / (sqrt b * sqrt (x t) * sqrt (a + b * x t)).
Proof.
assert (H := x_bounds t). assert (A := ax_pos t). unfold kernel, h, Q.
assert (E : sqrt (x t * (1 + b * x t / a)) * sqrt (a * b) = sqrt b * sqrt (x t) * sqrt (a + b * x t)).
{ rewrite <- !sqrt_mult_alt; try lra. f_equal. field. lra.
  - apply Rmult_le_pos; lra.
  - assert (0 < b * x t / a). { apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat; lra|lra]. } apply Rmult_le_pos; lra. }
rewrite <- E.
assert (0 < sqrt (a * b)) by (apply sqrt_lt_R0, Rmult_lt_0_compat; lra).
assert (0 < sqrt (x t * (1 + b * x t / a))).
{ apply sqrt_lt_R0. assert (0 < b * x t / a). { apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat; lra|lra]. } apply Rmult_lt_0_compat; lra. }
field. lra.
Qed.
Definition slowest := (1 - b) / (sqrt b * sqrt (a + b)).
Lemma slowest_pos : 0 < slowest.
Proof. unfold slowest. apply Rdiv_lt_0_compat; [lra|]. apply Rmult_lt_0_compat; apply sqrt_lt_R0; lra. Qed.
Lemma kernel_lower t : slowest <= kernel a b u t.
Proof.
rewrite kernel_value. unfold slowest. assert (H := x_bounds t). assert (A := ax_pos t). assert (B := bx_small t).
assert (S1 : 0 < sqrt b) by (apply sqrt_lt_R0; lra). assert (S2 : 0 < sqrt (x t)) by (apply sqrt_lt_R0; lra).
assert (S3 : 0 < sqrt (a + b * x t)) by (apply sqrt_lt_R0; lra).
assert (L2 : sqrt (x t) <= 1). { rewrite <- sqrt_1. apply sqrt_le_1_alt. lra. }
assert (L3 : sqrt (a + b * x t) <= sqrt (a + b)). { apply sqrt_le_1_alt. nra. }
unfold Rdiv. apply Rmult_le_compat; [lra| |lra|].
- left. apply Rinv_0_lt_compat, Rmult_lt_0_compat; lra.
- apply Rinv_le_contravar. repeat apply Rmult_lt_0_compat; lra.
  apply Rmult_le_compat; [apply Rmult_le_pos; lra|lra| |lra]. rewrite <- (Rmult_1_r (sqrt b)) at 2. apply Rmult_le_compat_l; lra.
Qed.
Lemma kernel_pos t : 0 < kernel a b u t.
Proof. assert (A := kernel_lower t). assert (B := slowest_pos). lra. Qed.

Lemma P_derive t : is_derive (P a b u) t (kernel a b u t).
Proof. now apply Phase.P_derive. Qed.
Lemma P_continuous t : continuity_pt (P a b u) t.
Proof. apply continuity_pt_filterlim, (ex_derive_continuous (P a b u)). eexists. apply P_derive. Qed.
Lemma P_zero : P a b u 0 = 0.
Proof. unfold Phase.P. now rewrite RInt_point. Qed.
Lemma P_mvt s t : exists z, Rmin s t <= z <= Rmax s t /\ P a b u t - P a b u s = kernel a b u z * (t - s).
Proof.
destruct (MVT_gen (P a b u) s t (kernel a b u)) as [z [Hz E]].
- intros z _. apply P_derive.
- intros z _. apply P_continuous.
- exists z. now split.
Qed.
Lemma P_increasing s t : s < t -> slowest * (t - s) <= P a b u t - P a b u s.
Proof. intros L. destruct (P_mvt s t) as [z [_ ->]]. apply Rmult_le_compat_r; [lra|apply kernel_lower]. Qed.
Lemma P_increasing_strictly s t : s < t -> P a b u s < P a b u t.
Proof. intros L. assert (A := P_increasing s t L). assert (0 < slowest * (t - s)). { apply Rmult_lt_0_compat; [apply slowest_pos|lra]. } lra. Qed.
Lemma P_injective s t : P a b u s = P a b u t -> s = t.
Proof. intros E. destruct (Rtotal_order s t) as [L|[L|L]]; trivial; apply P_increasing_strictly in L; lra. Qed.

(** P is onto, so turn is its inverse. *)
Lemma P_onto phi : exists t, P a b u t = phi.
Proof.
assert (S := slowest_pos). set (T := (Rabs phi + 1) / slowest).
assert (A := Rabs_pos phi). assert (B := Rle_abs phi). assert (B' := Rle_abs (- phi)). rewrite Rabs_Ropp in B'.
assert (T0 : 0 < T) by (apply Rdiv_lt_0_compat; lra).
assert (E : slowest * T = Rabs phi + 1) by (unfold T; field; lra).
assert (U := P_increasing 0 T T0). assert (D := P_increasing (-T) 0 ltac:(lra)). rewrite P_zero in U, D.
destruct (Ranalysis5.IVT_interv (fun t => P a b u t - phi) (-T) T) as [t [_ Et]]; try lra.
- intros t _. apply continuity_pt_minus. apply P_continuous. apply continuity_pt_const; now intros ? ?.
- exists t. lra.
Qed.
Theorem turn_P t : turn a b u (P a b u t) = t.
Proof.
unfold turn. rewrite (is_lub_Rbar_unique _ t); trivial. split.
- intros s Hs. simpl. apply Rnot_lt_le. intros L. apply P_increasing_strictly in L. lra.
- intros m Hm. apply Hm. lra.
Qed.
Theorem P_turn phi : P a b u (turn a b u phi) = phi.
Proof. destruct (P_onto phi) as [t <-]. now rewrite turn_P. Qed.
Lemma turn_zero : turn a b u 0 = 0.
Proof. rewrite <- P_zero at 1. apply turn_P. Qed.

Lemma turn_lipschitz phi phi' : Rabs (turn a b u phi - turn a b u phi') <= / slowest * Rabs (phi - phi').
Proof.
assert (S := slowest_pos).
destruct (P_mvt (turn a b u phi') (turn a b u phi)) as [z [_ E]]. rewrite !P_turn in E. rewrite E, Rabs_mult.
rewrite (Rabs_pos_eq (kernel a b u z)) by (left; apply kernel_pos). rewrite <- Rmult_assoc.
rewrite <- (Rmult_1_l (Rabs (turn a b u phi - _))) at 1. apply Rmult_le_compat_r; [apply Rabs_pos|].
rewrite <- (Rinv_l slowest) by lra. apply Rmult_le_compat_l; [left; now apply Rinv_0_lt_compat|apply kernel_lower].
Qed.
Theorem turn_derive phi : is_derive (turn a b u) phi (/ kernel a b u (turn a b u phi)).
Proof.
assert (S := slowest_pos). set (t := turn a b u phi). split. apply @is_linear_scal_l.
intros y Hy e. assert (Ey := is_filter_lim_locally_unique (K := R_AbsRing) (V := AbsRing_NormedModule R_AbsRing) phi y Hy). simpl in Ey. subst y.
assert (C : continuous (fun s => / kernel a b u s) t).
{ apply continuity_pt_filterlim. apply (continuity_pt_inv (kernel a b u)).
  - apply continuity_pt_filterlim. now apply Phase.kernel_continuous.
  - apply Rgt_not_eq, kernel_pos. }
assert (N : locally t (fun s => Rabs (/ kernel a b u s - / kernel a b u t) < e)).
{ apply (C (fun v => Rabs (v - / kernel a b u t) < e)). exists e. intros v Hv. exact Hv. }
destruct N as [d Hd]. assert (D : 0 < slowest * d) by (apply Rmult_lt_0_compat; [exact S|apply cond_pos]).
exists (mkposreal _ D). intros phi' Hphi.
unfold ball in Hphi; simpl in Hphi; unfold AbsRing_ball, abs, minus, plus, opp in Hphi; simpl in Hphi.
destruct (P_mvt t (turn a b u phi')) as [z [Hz E]]. rewrite P_turn in E. unfold t in E at 1. rewrite P_turn in E.
assert (L := turn_lipschitz phi' phi). fold t in L.
assert (L' : Rabs (turn a b u phi' - t) < d).
{ apply Rle_lt_trans with (1 := L). apply (Rmult_lt_reg_l slowest); trivial. rewrite <- Rmult_assoc, Rinv_r, Rmult_1_l by lra. exact Hphi. }
assert (Z : Rabs (z - t) < d).
{ apply Rle_lt_trans with (2 := L'). unfold Rmin, Rmax in Hz. destruct (Rle_dec t (turn a b u phi')).
  rewrite !Rabs_pos_eq; lra. rewrite (Rabs_left1 (z - t)) by lra. rewrite (Rabs_left1 (turn a b u phi' - t)) by lra. lra. }
specialize (Hd z Z). assert (KZ := kernel_pos z).
assert (E' : turn a b u phi' - t = / kernel a b u z * (phi' - phi)). { rewrite E. field. lra. }
unfold norm, minus, plus, opp, scal; simpl. unfold abs, mult; simpl. fold t.
change (turn a b u phi' + - t) with (turn a b u phi' - t). rewrite E'.
replace (/ kernel a b u z * (phi' - phi) + - ((phi' + - phi) * / kernel a b u t)) with ((/ kernel a b u z - / kernel a b u t) * (phi' - phi)) by ring.
rewrite Rabs_mult. apply Rmult_le_compat_r; [apply Rabs_pos|lra].
Qed.

(** * psi and theta as functions of t *)
Notation r := (sqrt (1 - u)).
Lemma r_bounds : 0 < r < 1 /\ r * r = 1 - u.
Proof.
assert (E : r * r = 1 - u) by (apply sqrt_sqrt; lra). assert (0 < r) by (apply sqrt_lt_R0; lra). repeat split; trivial. nra.
Qed.
Lemma rsin_bounds t : -1 < r * sin t < 1.
Proof. destruct r_bounds as [R0 R1]. assert (S := SIN_bound t). nra. Qed.
Lemma rsin_square t : 1 - (r * sin t) * (r * sin t) = x t.
Proof.
destruct r_bounds as [_ R1]. assert (S := sin2_cos2 t). unfold Rsqr in S.
replace ((r * sin t) * (r * sin t)) with ((r * r) * (sin t * sin t)) by ring. rewrite R1. unfold X. simpl.
replace (sin t * sin t) with (1 - cos t * cos t) by lra. ring.
Qed.
Lemma sin_psi t : sin (psi_of u t) = r * sin t.
Proof. unfold psi_of. apply sin_asin. assert (H := rsin_bounds t). lra. Qed.
Lemma cos_psi t : cos (psi_of u t) = sqrt (x t).
Proof. unfold psi_of. assert (H := rsin_bounds t). rewrite cos_asin by lra. f_equal. apply rsin_square. Qed.
Lemma cos_psi_square t : cos (psi_of u t) ^2 = x t.
Proof. rewrite cos_psi. simpl. rewrite Rmult_1_r. apply sqrt_sqrt. assert (H := x_bounds t). lra. Qed.
Lemma psi_of_derive t : is_derive (psi_of u) t (r * cos t / sqrt (x t)).
Proof.
assert (H := rsin_bounds t). unfold psi_of.
assert (D : is_derive asin (r * sin t) (1 / sqrt (1 - (r * sin t)^2))).
{ apply is_derive_Reals. replace (1 - (r * sin t)^2) with (1 - (r * sin t)²) by (unfold Rsqr; ring).
  apply (derive_pt_eq_1 asin (r * sin t) _ (derivable_pt_asin (r * sin t) H)). apply derive_pt_asin. }
assert (D' : is_derive (fun t => r * sin t) t (r * cos t)).
{ auto_derive; trivial. ring. }
evar_last. apply (is_derive_comp asin (fun t => r * sin t) t _ _ D D').
unfold scal; simpl; unfold mult; simpl. rewrite Rmult_1_r, rsin_square. field.
apply Rgt_not_eq, sqrt_lt_R0. assert (B := x_bounds t). lra.
Qed.

Lemma cos_theta_square t : 1 - cos_theta_of a b u t * cos_theta_of a b u t = (a + b * u) / (a + b * x t).
Proof.
destruct r_bounds as [_ R1]. assert (A := ax_pos t). unfold cos_theta_of.
assert (S : 0 < sqrt (a + b * x t)) by now apply sqrt_lt_R0.
assert (S2 : sqrt (a + b * x t) * sqrt (a + b * x t) = a + b * x t) by (apply sqrt_sqrt; lra).
assert (B2 : sqrt b * sqrt b = b) by (apply sqrt_sqrt; lra).
replace (sqrt b * r * cos t / sqrt (a + b * x t) * (sqrt b * r * cos t / sqrt (a + b * x t)))
  with ((sqrt b * sqrt b) * (r * r) * (cos t * cos t) / (sqrt (a + b * x t) * sqrt (a + b * x t))) by (field; lra).
rewrite S2, B2, R1. unfold X in *. field. lra.
Qed.
Lemma cos_theta_bounds t : -1 < cos_theta_of a b u t < 1.
Proof.
assert (E := cos_theta_square t). assert (A := ax_pos t). assert (0 < b * u) by (apply Rmult_lt_0_compat; lra).
assert (0 < (a + b * u) / (a + b * x t)) by (apply Rdiv_lt_0_compat; lra). split; nra.
Qed.
Lemma cos_theta t : cos (theta_of a b u t) = cos_theta_of a b u t.
Proof. unfold theta_of. apply cos_acos. assert (H := cos_theta_bounds t). lra. Qed.
Lemma theta_bounds t : 0 < theta_of a b u t < PI.
Proof.
assert (H := cos_theta_bounds t). assert (B := acos_bound (cos_theta_of a b u t)). fold (theta_of a b u t) in B.
assert (E := cos_theta t). split.
- destruct B as [[B|B] _]; trivial. rewrite <- B, cos_0 in E. lra.
- destruct B as [_ [B|B]]; trivial. rewrite B, cos_PI in E. lra.
Qed.
Lemma sin_theta t : sin (theta_of a b u t) = sqrt (a + b * u) / sqrt (a + b * x t).
Proof.
assert (H := theta_bounds t). assert (S : 0 < sin (theta_of a b u t)) by (apply sin_gt_0; lra).
assert (A := ax_pos t).
rewrite <- sqrt_div_alt by exact A. rewrite <- cos_theta_square, <- cos_theta.
assert (E := sin2_cos2 (theta_of a b u t)). unfold Rsqr in E.
replace (1 - cos (theta_of a b u t) * cos (theta_of a b u t)) with (sin (theta_of a b u t) * sin (theta_of a b u t)) by lra.
symmetry. apply sqrt_square. lra.
Qed.
Lemma cos_theta_derive t : is_derive (cos_theta_of a b u) t
  (- (sqrt b * r * sin t * (a + b * u) / (sqrt (a + b * x t) * sqrt (a + b * x t) * sqrt (a + b * x t)))).
Proof.
assert (A := ax_pos t). assert (S : 0 < sqrt (a + b * x t)) by now apply sqrt_lt_R0.
assert (S2 : sqrt (a + b * x t) * sqrt (a + b * x t) = a + b * x t) by (apply sqrt_sqrt; lra).
unfold cos_theta_of. unfold X in *. auto_derive.
- simpl in *. split; [exact A|]. split; [apply Rgt_not_eq; exact S|trivial].
- change (cos t * (cos t * 1)) with (cos t ^2). set (q := sqrt (a + b * (u + (1 - u) * cos t ^2))) in *.
  assert (U : a + b * u = q * q - b * (1 - u) * cos t ^2) by (rewrite S2; ring). rewrite U. field. lra.
Qed.
Lemma theta_of_derive t : is_derive (theta_of a b u) t (sqrt b * r * sin t * sqrt (a + b * u) / (a + b * x t)).
Proof.
assert (H := cos_theta_bounds t). assert (A := ax_pos t). assert (S : 0 < sqrt (a + b * x t)) by now apply sqrt_lt_R0.
assert (S2 : sqrt (a + b * x t) * sqrt (a + b * x t) = a + b * x t) by (apply sqrt_sqrt; lra).
assert (U : 0 < a + b * u). { assert (0 < b * u) by (apply Rmult_lt_0_compat; lra). lra. }
assert (V : 0 < sqrt (a + b * u)) by now apply sqrt_lt_R0.
assert (V2 : sqrt (a + b * u) * sqrt (a + b * u) = a + b * u) by (apply sqrt_sqrt; lra).
assert (D : is_derive acos (cos_theta_of a b u t) (-1 / sqrt (1 - (cos_theta_of a b u t)²))).
{ apply is_derive_Reals. apply (derive_pt_eq_1 acos _ _ (derivable_pt_acos (cos_theta_of a b u t) H)). apply derive_pt_acos. }
evar_last. apply (is_derive_comp acos (cos_theta_of a b u) t _ _ D (cos_theta_derive t)).
unfold scal; simpl; unfold mult; simpl. unfold Rsqr. rewrite cos_theta_square, sqrt_div_alt by exact A.
rewrite <- S2 at 5. rewrite <- V2 at 1. field. lra.
Qed.

(** * The motion *)
(** psi and theta satisfy (18) and (19). *)
Theorem oscillation_is_motion : reduced_motion a b (oscillation_psi a b u) (oscillation_theta a b u).
Proof.
intros phi. set (t := turn a b u phi).
assert (A := ax_pos t). assert (B := bx_small t). assert (C := x_bounds t).
assert (S : 0 < sqrt (a + b * x t)) by now apply sqrt_lt_R0.
assert (S2 : sqrt (a + b * x t) * sqrt (a + b * x t) = a + b * x t) by (apply sqrt_sqrt; lra).
assert (X0 : 0 < sqrt (x t)) by (apply sqrt_lt_R0; lra).
assert (B0 : 0 < sqrt b) by (apply sqrt_lt_R0; lra).
assert (B2 : sqrt b * sqrt b = b) by (apply sqrt_sqrt; lra).
split.
- evar_last. apply (is_derive_comp (psi_of u) (turn a b u) phi _ _ (psi_of_derive _) (turn_derive phi)).
  unfold oscillation_psi, oscillation_theta. fold t. unfold psi_rate. rewrite cos_theta, cos_psi_square, kernel_value.
  unfold scal; simpl; unfold mult; simpl. unfold cos_theta_of. rewrite <- S2 at 2. field. lra.
- evar_last. apply (is_derive_comp (theta_of a b u) (turn a b u) phi _ _ (theta_of_derive _) (turn_derive phi)).
  unfold oscillation_psi, oscillation_theta. fold t. unfold theta_rate. rewrite sin_theta, cos_psi_square, kernel_value, sin_psi, cos_psi.
  unfold scal; simpl; unfold mult; simpl. 
  set (d := 1 - b * x t) in *. set (q := sqrt (a + b * x t)) in *. set (g := sqrt (x t)) in *. set (v := sqrt (a + b * u)) in *.
  rewrite <- S2. replace (b * (v / q) * (r * sin t) * g / d) with ((sqrt b * sqrt b) * (v / q) * (r * sin t) * g / d) by (now rewrite B2).
  apply theta_algebra; lra.
Qed.
(** It starts at phi = 0 in psi = 0 with cos theta > 0, and its first integral is c = -b u. *)
Theorem oscillation_start : oscillation_psi a b u 0 = 0 /\ 0 < oscillation_theta a b u 0 < PI/2.
Proof.
unfold oscillation_psi, oscillation_theta. rewrite turn_zero. unfold psi_of. rewrite sin_0, Rmult_0_r, asin_0. split; trivial.
assert (T := theta_bounds 0). split; [lra|]. 
assert (E := cos_theta 0). unfold cos_theta_of in E. rewrite cos_0, Rmult_1_r in E. destruct r_bounds as [R0 _].
assert (0 < sqrt b * r / sqrt (a + b * X u 1)).
{ apply Rdiv_lt_0_compat. apply Rmult_lt_0_compat; [apply sqrt_lt_R0|]; lra. rewrite <- cos_0. apply sqrt_lt_R0, ax_pos. }
apply Rnot_le_lt. intros L. assert (cos (theta_of a b u 0) <= 0) by (apply cos_le_0; lra). lra.
Qed.
Theorem oscillation_first_integral phi : first_integral a b (oscillation_psi a b u phi) (oscillation_theta a b u phi) = - b * u.
Proof.
unfold oscillation_psi, oscillation_theta. set (t := turn a b u phi). unfold first_integral. rewrite sin_theta, cos_psi_square.
assert (A := ax_pos t). assert (S : 0 < sqrt (a + b * x t)) by now apply sqrt_lt_R0.
assert (S2 : sqrt (a + b * x t) * sqrt (a + b * x t) = a + b * x t) by (apply sqrt_sqrt; lra).
assert (U : 0 < a + b * u). { assert (0 < b * u) by (apply Rmult_lt_0_compat; lra). lra. }
assert (V2 : sqrt (a + b * u) * sqrt (a + b * u) = a + b * u) by (apply sqrt_sqrt; lra).
replace ((sqrt (a + b * u) / sqrt (a + b * x t))^2) with ((sqrt (a + b * u) * sqrt (a + b * u)) / (sqrt (a + b * x t) * sqrt (a + b * x t))) by (field; lra).
rewrite S2, V2. field. lra.
Qed.

(** * Its period *)
Lemma constant f : (forall t, is_derive f t 0) -> forall s t : R, f s = f t :> R.
Proof.
intros D s t. destruct (MVT_gen f t s (fun _ => 0)) as [z [_ E]].
- intros z _. apply D.
- intros z _. apply continuity_pt_filterlim, (ex_derive_continuous f). eexists. apply D.
- lra.
Qed.
Lemma kernel_even t : kernel a b u (- t) = kernel a b u t.
Proof. unfold kernel. now rewrite cos_neg. Qed.
Lemma kernel_period t : kernel a b u (t + PI) = kernel a b u t.
Proof. unfold kernel. rewrite neg_cos. unfold X. replace ((- cos t)^2) with (cos t ^2) by ring. reflexivity. Qed.
Lemma P_odd t : P a b u (- t) = - P a b u t.
Proof.
assert (E := constant (fun t => P a b u (- t) + P a b u t)). cbv beta in E.
assert (D : forall t, is_derive (fun t => P a b u (- t) + P a b u t) t 0).
{ intros s. evar_last. apply (is_derive_plus (fun t => P a b u (- t)) (P a b u)).
  apply (is_derive_comp (P a b u) (fun t => - t) s _ _ (P_derive (- s)) (opposite_derive s)). apply P_derive.
  rewrite kernel_even. unfold scal, plus; simpl; unfold mult; simpl. in_R. ring. }
specialize (E D t 0). rewrite Ropp_0, P_zero in E. lra.
Qed.
(** Half a turn in t takes the angle G u in phi. *)
Theorem P_half_turn t : P a b u (t + PI) = P a b u t + G a b u.
Proof.
assert (E := constant (fun t => P a b u (t + PI) - P a b u t)). cbv beta in E.
assert (D : forall t, is_derive (fun t => P a b u (t + PI) - P a b u t) t 0).
{ intros s. evar_last. apply (is_derive_minus (fun t => P a b u (t + PI)) (P a b u)).
  apply (is_derive_comp (P a b u) (fun t => t + PI) s _ _ (P_derive (s + PI)) (shift_derive PI s)).
  apply P_derive.
  rewrite kernel_period. unfold scal, minus, plus, opp; simpl; unfold mult; simpl. in_R. ring. }
specialize (E D t (-(PI/2))). replace (-(PI/2) + PI) with (PI/2) in E by field.
rewrite (Phase.P_swing a b u Ha Hb Hu) in E. lra.
Qed.
Lemma P_quarter_turn : P a b u (PI/2) = G a b u / 2.
Proof. assert (E := Phase.P_swing a b u Ha Hb Hu). rewrite P_odd in E. lra. Qed.
Lemma P_half_turns_nat n t : P a b u (t + INR n * PI) = P a b u t + INR n * G a b u.
Proof.
induction n as [|n IH]. simpl. rewrite !Rmult_0_l, !Rplus_0_r. reflexivity.
rewrite S_INR. replace (t + (INR n + 1) * PI) with (t + INR n * PI + PI) by ring. rewrite P_half_turn, IH. in_R. ring.
Qed.
Theorem P_half_turns k t : P a b u (t + IZR k * PI) = P a b u t + IZR k * G a b u.
Proof.
destruct (Z_le_gt_dec 0 k) as [H|H].
- rewrite <- (Z2Nat.id k) by exact H. rewrite <- INR_IZR_INZ. apply P_half_turns_nat.
- assert (E := P_half_turns_nat (Z.to_nat (- k)) (t + IZR k * PI)). rewrite INR_IZR_INZ, Z2Nat.id in E by lia. rewrite opp_IZR in E.
  replace (t + IZR k * PI + - IZR k * PI) with t in E by ring. lra.
Qed.
Lemma G_pos : 0 < G a b u.
Proof. assert (E := P_half_turn 0). rewrite P_zero in E. assert (L := P_increasing_strictly 0 (0 + PI)). assert (HPI := PI_RGT_0). rewrite P_zero in L. lra. Qed.

(** psi = 0 exactly at the multiples of the half phase. *)
Theorem passages phi : oscillation_psi a b u phi = 0 <-> exists k : Z, phi = IZR k * G a b u.
Proof.
unfold oscillation_psi. destruct r_bounds as [R0 _]. split.
- intros E. assert (S := sin_psi (turn a b u phi)). rewrite E, sin_0 in S.
  assert (Z : sin (turn a b u phi) = 0). { symmetry in S. apply Rmult_integral in S. destruct S; lra. }
  apply sin_eq_0_0 in Z. destruct Z as [k Hk]. exists k. rewrite <- (P_turn phi), Hk.
  rewrite <- (Rplus_0_l (IZR k * PI)), P_half_turns, P_zero. in_R. ring.
- intros [k ->]. assert (E : IZR k * G a b u = P a b u (0 + IZR k * PI)) by (rewrite P_half_turns, P_zero; in_R; ring).
  rewrite E, turn_P. unfold psi_of. rewrite (sin_eq_0_1 (0 + IZR k * PI)) by (exists k; ring). rewrite Rmult_0_r. apply asin_0.
Qed.
(** The turning points, cos theta = 0, are exactly the odd multiples of half of it. *)
Theorem turning_points phi : cos (oscillation_theta a b u phi) = 0 <-> exists k : Z, phi = (IZR k + 1/2) * G a b u.
Proof.
unfold oscillation_theta. destruct r_bounds as [R0 _]. rewrite cos_theta. unfold cos_theta_of.
assert (S : 0 < sqrt (a + b * x (turn a b u phi))) by (apply sqrt_lt_R0, ax_pos).
assert (B0 : 0 < sqrt b) by (apply sqrt_lt_R0; lra). assert (BR : 0 < sqrt b * r) by (apply Rmult_lt_0_compat; lra). split.
- intros E. assert (Z : cos (turn a b u phi) = 0).
  { apply (Rmult_eq_reg_l (sqrt b * r)); [|lra]. rewrite Rmult_0_r. apply (Rmult_eq_reg_r (/ sqrt (a + b * x (turn a b u phi)))).
    rewrite Rmult_0_l. exact E. apply Rinv_neq_0_compat. lra. }
  apply cos_eq_0_0 in Z. destruct Z as [k Hk]. exists k. rewrite <- (P_turn phi), Hk.
  rewrite Rplus_comm, P_half_turns, P_quarter_turn. in_R. field.
- intros [k ->]. assert (E : (IZR k + 1/2) * G a b u = P a b u (PI/2 + IZR k * PI)) by (rewrite P_half_turns, P_quarter_turn; in_R; field).
  rewrite E, turn_P. rewrite (cos_eq_0_1 (PI/2 + IZR k * PI)) by (exists k; ring). unfold Rdiv. ring.
Qed.
End Oscillation.
