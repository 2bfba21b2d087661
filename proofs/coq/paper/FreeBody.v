(** The free motion of an asymmetric rigid body, in the paper's Euler angles, and what the paper derives from it before theorem 1:
    Euler's equations, eq. (6), eq. (7) with c constant, phi' > 0, the reduced equations (8), (9), (18), (19) and (20). *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Polhode Require Motion Attitude.
Open Scope R_scope.

(** Three by three matrices, rows and columns named by the axes. *)
Inductive axis := x_axis | y_axis | z_axis.
Definition matrix := axis -> axis -> R.
Definition sum3 (f : axis -> R) : R := f x_axis + f y_axis + f z_axis.
Definition product (A B : matrix) : matrix := fun i j => sum3 (fun k => A i k * B k j).
Definition Rz (t : R) : matrix := fun i j => match i, j with
  | x_axis, x_axis => cos t | x_axis, y_axis => - sin t
  | y_axis, x_axis => sin t | y_axis, y_axis => cos t
  | z_axis, z_axis => 1 | _, _ => 0 end.
Definition Ry (t : R) : matrix := fun i j => match i, j with
  | x_axis, x_axis => cos t | x_axis, z_axis => sin t
  | z_axis, x_axis => - sin t | z_axis, z_axis => cos t
  | y_axis, y_axis => 1 | _, _ => 0 end.
(** [w]x, the matrix of the cross product with w. *)
Definition cross_matrix (w : axis -> R) : matrix := fun i j => match i, j with
  | x_axis, y_axis => - w z_axis | x_axis, z_axis => w y_axis
  | y_axis, x_axis => w z_axis | y_axis, z_axis => - w x_axis
  | z_axis, x_axis => - w y_axis | z_axis, y_axis => w x_axis
  | _, _ => 0 end.
Definition cross (v w : axis -> R) (i : axis) : R := sum3 (fun j => cross_matrix v i j * w j).

(** The attitude R = Rz(phi) Ry(theta) Rz(psi) takes the body frame to the space frame; the angular momentum is 1 along Z,
    so that in the body frame it is the third row of R, J = (-sin theta cos psi, sin theta sin psi, cos theta), as in the paper. *)
Definition attitude (th ps ph : R) : matrix := product (Rz ph) (product (Ry th) (Rz ps)).
Definition momentum (th ps : R) : axis -> R := fun i => match i with
  | x_axis => - sin th * cos ps | y_axis => sin th * sin ps | z_axis => cos th end.
(** omega = I^-1 J. *)
Definition velocity (moment : axis -> R) (th ps : R) : axis -> R := fun i => momentum th ps i / moment i.

(** A free motion of an asymmetric body, I_z < I_y < I_x: differentiable angles theta in (0, pi), psi, phi with R' = R [omega]x.
    Euler's equations J' = J x I^-1 J need not be asked for: they follow (euler_equations), as J is the third row of R. *)
Record motion (moment : axis -> R) (th ps ph : R -> R) : Prop := {
  asymmetric : 0 < moment z_axis < moment y_axis /\ moment y_axis < moment x_axis;
  th_differentiable : forall t, ex_derive th t;
  ps_differentiable : forall t, ex_derive ps t;
  ph_differentiable : forall t, ex_derive ph t;
  chart : forall t, 0 < sin (th t);
  kinematics : forall t i j, is_derive (fun t => attitude (th t) (ps t) (ph t) i j) t
    (product (attitude (th t) (ps t) (ph t)) (cross_matrix (velocity moment (th t) (ps t))) i j) }.

(** The paper's a, b (eq. 4) and c = 2 I_y H - 1. *)
Definition par_a (moment : axis -> R) := moment y_axis / moment z_axis - 1.
Definition par_b (moment : axis -> R) := 1 - moment y_axis / moment x_axis.
Definition energy (moment : axis -> R) (th ps : R) := sum3 (fun i => momentum th ps i ^ 2 / (2 * moment i)).
Definition par_c (moment : axis -> R) (th ps : R) := 2 * moment y_axis * energy moment th ps - 1.

(** The third row of the attitude is the momentum. *)
Lemma momentum_is_third_row th ps ph j : attitude th ps ph z_axis j = momentum th ps j.
Proof. destruct j; unfold attitude, product, sum3, Rz, Ry, momentum; ring. Qed.

Section Body.
Variable moment : axis -> R.
Variables th ps ph : R -> R.
Hypothesis M : motion moment th ps ph.
Notation Ix := (moment x_axis).
Notation Iy := (moment y_axis).
Notation Iz := (moment z_axis).
Notation a := (par_a moment).
Notation b := (par_b moment).
Notation x t := (cos (ps t) ^ 2).
Notation c := (par_c moment (th 0) (ps 0)).

(** Euler's equations, J' = J x I^-1 J: what the third row of R' = R [omega]x says. *)
Theorem euler_equations t i : is_derive (fun t => momentum (th t) (ps t) i) t
  (cross (momentum (th t) (ps t)) (velocity moment (th t) (ps t)) i).
Proof.
apply (is_derive_ext (fun t => attitude (th t) (ps t) (ph t) z_axis i)). { intros s. apply momentum_is_third_row. }
evar_last. apply (kinematics _ _ _ _ M). unfold product, cross, sum3. rewrite !momentum_is_third_row.
destruct i; unfold cross_matrix; ring.
Qed.

Lemma moments : 0 < Iz /\ 0 < Iy /\ 0 < Ix.
Proof. destruct (asymmetric _ _ _ _ M) as [[H1 H2] H3]. lra. Qed.
Lemma a_positive : 0 < a.
Proof. destruct (asymmetric _ _ _ _ M) as [[H1 H2] H3]. unfold par_a. apply (Rmult_lt_reg_r Iz); trivial. field_simplify; lra. Qed.
Lemma b_range : 0 < b < 1.
Proof. destruct (asymmetric _ _ _ _ M) as [[H1 H2] H3]. unfold par_b. split; apply (Rmult_lt_reg_r Ix); try lra; field_simplify; lra. Qed.
Lemma th_derive t : is_derive th t (Derive th t).
Proof. apply Derive_correct, (th_differentiable _ _ _ _ M). Qed.
Lemma ps_derive t : is_derive ps t (Derive ps t).
Proof. apply Derive_correct, (ps_differentiable _ _ _ _ M). Qed.
Lemma ph_derive t : is_derive ph t (Derive ph t).
Proof. apply Derive_correct, (ph_differentiable _ _ _ _ M). Qed.
Lemma euler_x t : is_derive (Motion.Jx th ps) t (Motion.Jy th ps t * (Motion.Jz th t / Iz) - Motion.Jz th t * (Motion.Jy th ps t / Iy)).
Proof.
apply (is_derive_ext (fun t => momentum (th t) (ps t) x_axis)). { reflexivity. } evar_last. apply euler_equations.
destruct moments as [H1 [H2 H3]]. unfold cross, sum3, cross_matrix, velocity, momentum, Motion.Jx, Motion.Jy, Motion.Jz. field. lra.
Qed.
Lemma euler_y t : is_derive (Motion.Jy th ps) t (Motion.Jz th t * (Motion.Jx th ps t / Ix) - Motion.Jx th ps t * (Motion.Jz th t / Iz)).
Proof.
apply (is_derive_ext (fun t => momentum (th t) (ps t) y_axis)). { reflexivity. } evar_last. apply euler_equations.
destruct moments as [H1 [H2 H3]]. unfold cross, sum3, cross_matrix, velocity, momentum, Motion.Jx, Motion.Jy, Motion.Jz. field. lra.
Qed.
Lemma euler_z t : is_derive (Motion.Jz th) t (Motion.Jx th ps t * (Motion.Jy th ps t / Iy) - Motion.Jy th ps t * (Motion.Jx th ps t / Ix)).
Proof.
apply (is_derive_ext (fun t => momentum (th t) (ps t) z_axis)). { reflexivity. } evar_last. apply euler_equations.
destruct moments as [H1 [H2 H3]]. unfold cross, sum3, cross_matrix, velocity, momentum, Motion.Jx, Motion.Jy, Motion.Jz. field. lra.
Qed.

(** Eq. (6). *)
Theorem equation_6_theta t : Derive th t = (1/Iy - 1/Ix) * sin (th t) * sin (ps t) * cos (ps t).
Proof. exact (Motion.theta_equation Ix Iy Iz (asymmetric _ _ _ _ M) th ps _ th_derive euler_z (chart _ _ _ _ M) t). Qed.
Theorem equation_6_psi t : Derive ps t = (1/Iz - 1/Iy * sin (ps t)^2 - 1/Ix * cos (ps t)^2) * cos (th t).
Proof. exact (Motion.psi_equation Ix Iy Iz (asymmetric _ _ _ _ M) th ps _ _ th_derive ps_derive euler_x euler_y (chart _ _ _ _ M) t). Qed.
Theorem equation_6_phi t : Derive ph t = 1/Iy * sin (ps t)^2 + 1/Ix * cos (ps t)^2.
Proof.
refine (Attitude.phi_equation Ix Iy Iz moments th ps ph _ _ th_derive ph_derive (chart _ _ _ _ M) _ _ t); intros s.
- apply (is_derive_ext (fun t => attitude (th t) (ps t) (ph t) x_axis z_axis)).
  { intros v. unfold attitude, product, sum3, Rz, Ry, Attitude.R13. match goal with |- @eq _ ?l ?r => change (@eq R l r) end. ring. }
  evar_last. apply (kinematics _ _ _ _ M).
  unfold attitude, product, sum3, Rz, Ry, cross_matrix, velocity, momentum, Attitude.R11, Attitude.R12, Attitude.wx, Attitude.wy.
  destruct moments as [H1 [H2 H3]]. match goal with |- @eq _ ?l ?r => change (@eq R l r) end. field. lra.
- apply (is_derive_ext (fun t => attitude (th t) (ps t) (ph t) y_axis z_axis)).
  { intros v. unfold attitude, product, sum3, Rz, Ry, Attitude.R23. match goal with |- @eq _ ?l ?r => change (@eq R l r) end. ring. }
  evar_last. apply (kinematics _ _ _ _ M).
  unfold attitude, product, sum3, Rz, Ry, cross_matrix, velocity, momentum, Attitude.R21, Attitude.R22, Attitude.wx, Attitude.wy.
  destruct moments as [H1 [H2 H3]]. match goal with |- @eq _ ?l ?r => change (@eq R l r) end. field. lra.
Qed.

(** c does not change, c(t) = c(0). *)
Theorem c_constant t : par_c moment (th t) (ps t) = c.
Proof.
set (f := fun t => par_c moment (th t) (ps t)). change (f t = f 0).
assert (D : forall t, is_derive f t 0) by (exact (Motion.c_constant Ix Iy Iz (asymmetric _ _ _ _ M) th ps euler_x euler_y euler_z)).
destruct (MVT_gen f 0 t (fun _ => 0)) as [z [_ E]].
- intros s _. apply D.
- intros s _. apply continuity_pt_filterlim. apply (ex_derive_continuous f). eexists. apply D.
- lra.
Qed.
(** Eq. (7), with c the constant of the motion. *)
Theorem equation_7 t : c = a - sin (th t)^2 * (a + b * x t).
Proof. rewrite <- (c_constant t). exact (Motion.c_in_angles Ix Iy Iz (asymmetric _ _ _ _ M) th ps t). Qed.

Lemma x_range t : 0 <= x t <= 1.
Proof. generalize (COS_bound (ps t)). intros H. nra. Qed.
Lemma numerator_positive t : 0 < 1 - b * x t.
Proof. destruct b_range as [B1 B2]. destruct (x_range t) as [X1 X2]. nra. Qed.
Lemma denominator_positive t : 0 < a + b * x t.
Proof. assert (A := a_positive). destruct b_range as [B1 B2]. destruct (x_range t) as [X1 X2]. assert (0 <= b * x t) by (apply Rmult_le_pos; lra). lra. Qed.
(** Eq. (6) in a and b. *)
Lemma phi_rate t : Derive ph t = (1 - b * x t) / Iy.
Proof.
rewrite equation_6_phi. destruct moments as [H1 [H2 H3]]. assert (E := sin2_cos2 (ps t)). unfold Rsqr in E. unfold par_b.
assert (E' : sin (ps t)^2 = 1 - x t) by (simpl; lra). rewrite E'. field. lra.
Qed.
Lemma psi_rate t : Derive ps t = (a + b * x t) * cos (th t) / Iy.
Proof.
rewrite equation_6_psi. destruct moments as [H1 [H2 H3]]. assert (E := sin2_cos2 (ps t)). unfold Rsqr in E. unfold par_a, par_b.
assert (E' : sin (ps t)^2 = 1 - x t) by (simpl; lra). rewrite E'. field. lra.
Qed.
Lemma theta_rate t : Derive th t = b * sin (th t) * sin (ps t) * cos (ps t) / Iy.
Proof. rewrite equation_6_theta. destruct moments as [H1 [H2 H3]]. unfold par_b. field. lra. Qed.
(** phi always grows, so it can take the place of the time. *)
Theorem phi_increases t : 0 < Derive ph t.
Proof. rewrite phi_rate. apply Rdiv_lt_0_compat. apply numerator_positive. apply moments. Qed.
(** Eqs. (18) and (19), psi'/phi' and theta'/phi'. *)
Theorem equation_18 t : Derive ps t / Derive ph t = (a + b * x t) * cos (th t) / (1 - b * x t).
Proof. rewrite psi_rate, phi_rate. assert (N := numerator_positive t). destruct moments as [H1 [H2 H3]]. field. lra. Qed.
Theorem equation_19 t : Derive th t / Derive ph t = b * sin (th t) * sin (ps t) * cos (ps t) / (1 - b * x t).
Proof. rewrite theta_rate, phi_rate. assert (N := numerator_positive t). destruct moments as [H1 [H2 H3]]. field. lra. Qed.

(** Eq. (20) squared, and c + b cos^2 psi >= 0. *)
Lemma cos_squared t : (a + b * x t) * cos (th t) ^ 2 = c + b * x t.
Proof. assert (E := equation_7 t). assert (S := sin2_cos2 (th t)). unfold Rsqr in S. replace (cos (th t) ^ 2) with (1 - sin (th t)^2) by (simpl; lra). lra. Qed.
Lemma c_plus_bx t : 0 <= c + b * x t.
Proof. rewrite <- cos_squared. apply Rmult_le_pos. apply Rlt_le, denominator_positive. apply pow2_ge_0. Qed.
Lemma c_below_a : c < a.
Proof.
assert (E := equation_7 0). assert (S := chart _ _ _ _ M 0). assert (D := denominator_positive 0). assert (0 < sin (th 0)^2) by (simpl; nra). 
assert (0 < sin (th 0)^2 * (a + b * x 0)) by (apply Rmult_lt_0_compat; lra). lra.
Qed.
(** -b <= c < a. *)
Theorem c_range : - b <= c < a.
Proof. split. 2: apply c_below_a. assert (E := c_plus_bx 0). destruct b_range as [B1 B2]. destruct (x_range 0) as [X1 X2]. nra. Qed.
(** Eq. (20): cos theta = +- sqrt ((c + b cos^2 psi)/(a + b cos^2 psi)). *)
Theorem equation_20 t : Rabs (cos (th t)) = sqrt ((c + b * x t) / (a + b * x t)).
Proof.
assert (D := denominator_positive t). rewrite <- (cos_squared t). replace ((a + b * x t) * cos (th t) ^ 2 / (a + b * x t)) with (Rsqr (cos (th t))).
symmetry; apply sqrt_Rsqr_abs. unfold Rsqr. field. lra.
Qed.
Lemma root_is_cos t : sqrt ((a + b * x t) * (c + b * x t)) = (a + b * x t) * Rabs (cos (th t)).
Proof.
assert (D := denominator_positive t). rewrite <- (cos_squared t).
replace ((a + b * x t) * ((a + b * x t) * cos (th t) ^ 2)) with (Rsqr ((a + b * x t) * cos (th t))) by (unfold Rsqr; ring).
rewrite sqrt_Rsqr_abs, Rabs_mult. rewrite (Rabs_right (a + b * x t)) by lra. reflexivity.
Qed.
(** Eq. (9): the sign is that of cos theta. *)
Theorem equation_9_plus t : 0 <= cos (th t) -> Derive ps t / Derive ph t = sqrt ((a + b * x t) * (c + b * x t)) / (1 - b * x t).
Proof. intros S. rewrite equation_18, root_is_cos, Rabs_right by lra. reflexivity. Qed.
Theorem equation_9_minus t : cos (th t) <= 0 -> Derive ps t / Derive ph t = - sqrt ((a + b * x t) * (c + b * x t)) / (1 - b * x t).
Proof. intros S. rewrite equation_18, root_is_cos, Rabs_left1 by lra. assert (N := numerator_positive t). field. lra. Qed.
(** Eq. (8): the sign is +, as 0 < sin theta. *)
Theorem equation_8 t : Derive th t / Derive ph t = b * sqrt (a - c) * sin (ps t) * cos (ps t) / ((1 - b * x t) * sqrt (a + b * x t)).
Proof.
rewrite equation_19. assert (D := denominator_positive t). assert (N := numerator_positive t). assert (S := chart _ _ _ _ M t).
assert (E : sqrt (a - c) = sin (th t) * sqrt (a + b * x t)).
{ replace (a - c) with (sin (th t)^2 * (a + b * x t)) by (rewrite (equation_7 t); ring). rewrite sqrt_mult_alt by apply pow2_ge_0. rewrite sqrt_pow2 by lra. reflexivity. }
assert (0 < sqrt (a + b * x t)) by (now apply sqrt_lt_R0). rewrite E. field. lra.
Qed.
End Body.
