(** The Montgomery phase without coordinates. A free motion is a differentiable rotation matrix R(t) with R' = R [omega]x, omega = I^-1 J,
    J = the third row of R (the angular momentum, 1 along Z, seen from the body). For c < a it has Euler angles (a motion as in FreeBody.v),
    and over a loop of J the body turns about Z by the gain of phi: R(t1) = Rz(phi(t1) - phi(t0)) R(t0). *)
Require Import Reals Lra Psatz Ratan.
From Coquelicot Require Import Coquelicot.
From Polhode Require HalfPhase Theorem2.
From Polhode Require Import FreeBody Loop MotionPhase Rotating Theorems Existence.
Open Scope R_scope.

Definition transpose (A : matrix) : matrix := fun i j => A j i.
Definition unit_matrix : matrix := fun i j => match i, j with x_axis, x_axis | y_axis, y_axis | z_axis, z_axis => 1 | _, _ => 0 end.
Definition determinant (A : matrix) : R := sum3 (fun i => A x_axis i * cross (A y_axis) (A z_axis) i).
Definition rotation (A : matrix) := (forall i j, product A (transpose A) i j = unit_matrix i j) /\
  (forall i j, product (transpose A) A i j = unit_matrix i j) /\ determinant A = 1.

(** Over a loop of the momentum the attitude is turned about Z by the gain of phi. *)
Theorem loop_turns_body th ps ph t0 t1 : (forall t, 0 < sin (th t)) -> one_loop th ps t0 t1 ->
  forall i j, attitude (th t1) (ps t1) (ph t1) i j = product (Rz (ph t1 - ph t0)) (attitude (th t0) (ps t0) (ph t0)) i j.
Proof.
intros S [L [E _]] i j. apply same_momentum_angles in E; trivial. destruct E as [E1 [E2 E3]].
assert (E4 : sin (th t1) = sin (th t0)).
{ assert (P := sin2_cos2 (th t1)). assert (Q := sin2_cos2 (th t0)). unfold Rsqr in P, Q. rewrite E1 in P. assert (S0 := S t0). assert (S1 := S t1). nra. }
assert (P := sin2_cos2 (ph t0)). unfold Rsqr in P. assert (P' : sin (ph t0) * sin (ph t0) = 1 - cos (ph t0) * cos (ph t0)) by lra.
destruct i, j; unfold attitude, product, sum3, Rz, Ry; rewrite ?E1, ?E2, ?E3, ?E4, ?cos_minus, ?sin_minus; try ring; ring [P'].
Qed.

(** A free motion, without angles. *)
Record free_motion (moment : axis -> R) (Q : R -> matrix) : Prop := {
  free_body : body moment;
  free_rotation : forall t, rotation (Q t);
  free_kinematics : forall t i j, is_derive (fun t => Q t i j) t (product (Q t) (cross_matrix (fun k => Q t z_axis k / moment k)) i j) }.
(** c = 2 I_y H - 1, from the matrix. *)
Definition matrix_c (moment : axis -> R) (A : matrix) := 2 * moment y_axis * sum3 (fun i => A z_axis i ^ 2 / (2 * moment i)) - 1.

Lemma combine p q s d x y z r : p = 0 -> q = 0 -> s = 1 -> d = 1 -> r * d - z * s = x * p + y * q -> r = z.
Proof. intros -> -> -> -> E. lra. Qed.

Section Angles.
Variable moment : axis -> R.
Variable Q : R -> matrix.
Hypothesis F : free_motion moment Q.
Hypothesis below : matrix_c moment (Q 0) < par_a moment.
Notation Ix := (moment x_axis).
Notation Iy := (moment y_axis).
Notation Iz := (moment z_axis).
Let J1 t := Q t z_axis x_axis.
Let J2 t := Q t z_axis y_axis.
Let J3 t := Q t z_axis z_axis.
Let r11 t := Q t x_axis x_axis.
Let r12 t := Q t x_axis y_axis.
Let r13 t := Q t x_axis z_axis.
Let r21 t := Q t y_axis x_axis.
Let r22 t := Q t y_axis y_axis.
Let r23 t := Q t y_axis z_axis.

Lemma fm_moments : 0 < Iz /\ Iz < Iy /\ Iy < Ix.
Proof. destruct (free_body _ _ F) as [[H1 H2] H3]. lra. Qed.
Lemma J1_derive t : is_derive J1 t (J2 t * (J3 t / Iz) - J3 t * (J2 t / Iy)).
Proof. evar_last. apply (free_kinematics _ _ F t z_axis x_axis). unfold product, sum3, cross_matrix. unfold J1, J2, J3. ring. Qed.
Lemma J2_derive t : is_derive J2 t (J3 t * (J1 t / Ix) - J1 t * (J3 t / Iz)).
Proof. evar_last. apply (free_kinematics _ _ F t z_axis y_axis). unfold product, sum3, cross_matrix. unfold J1, J2, J3. ring. Qed.
Lemma J3_derive t : is_derive J3 t (J1 t * (J2 t / Iy) - J2 t * (J1 t / Ix)).
Proof. evar_last. apply (free_kinematics _ _ F t z_axis z_axis). unfold product, sum3, cross_matrix. unfold J1, J2, J3. ring. Qed.
Lemma r13_derive t : is_derive r13 t (J2 t / Iy * r11 t - J1 t / Ix * r12 t).
Proof. evar_last. apply (free_kinematics _ _ F t x_axis z_axis). unfold product, sum3, cross_matrix. unfold J1, J2, r11, r12. ring. Qed.
Lemma r23_derive t : is_derive r23 t (J2 t / Iy * r21 t - J1 t / Ix * r22 t).
Proof. evar_last. apply (free_kinematics _ _ F t y_axis z_axis). unfold product, sum3, cross_matrix. unfold J1, J2, r21, r22. ring. Qed.

(** What being a rotation says. *)
Lemma third_row t : J1 t * J1 t + J2 t * J2 t + J3 t * J3 t = 1.
Proof. destruct (free_rotation _ _ F t) as [H _]. exact (H z_axis z_axis). Qed.
Lemma third_column t : r13 t * r13 t + r23 t * r23 t + J3 t * J3 t = 1.
Proof. destruct (free_rotation _ _ F t) as [_ [H _]]. exact (H z_axis z_axis). Qed.
Lemma rows_1_3 t : r11 t * J1 t + r12 t * J2 t + r13 t * J3 t = 0.
Proof. destruct (free_rotation _ _ F t) as [H _]. exact (H x_axis z_axis). Qed.
Lemma rows_2_3 t : r21 t * J1 t + r22 t * J2 t + r23 t * J3 t = 0.
Proof. destruct (free_rotation _ _ F t) as [H _]. exact (H y_axis z_axis). Qed.
Lemma row_1_cross t : r13 t = r21 t * J2 t - r22 t * J1 t.
Proof.
destruct (free_rotation _ _ F t) as [_ [H D]]. unfold determinant, sum3, cross, cross_matrix, sum3 in D.
assert (Hx := H z_axis x_axis). assert (Hy := H z_axis y_axis). assert (Hz := H z_axis z_axis). unfold product, sum3, transpose, unit_matrix in Hx, Hy, Hz.
change (r13 t = Q t y_axis x_axis * Q t z_axis y_axis - Q t y_axis y_axis * Q t z_axis x_axis). unfold r13.
set (cx := Q t y_axis y_axis * Q t z_axis z_axis - Q t y_axis z_axis * Q t z_axis y_axis). set (cy := Q t y_axis z_axis * Q t z_axis x_axis - Q t y_axis x_axis * Q t z_axis z_axis).
set (cz := Q t y_axis x_axis * Q t z_axis y_axis - Q t y_axis y_axis * Q t z_axis x_axis).
apply combine with (1 := Hx) (2 := Hy) (3 := Hz) (4 := D) (x := cx) (y := cy). unfold cx, cy, cz. ring.
Qed.
Lemma row_2_cross t : r23 t = J1 t * r12 t - J2 t * r11 t.
Proof.
destruct (free_rotation _ _ F t) as [_ [H D]]. unfold determinant, sum3, cross, cross_matrix, sum3 in D.
assert (Hx := H z_axis x_axis). assert (Hy := H z_axis y_axis). assert (Hz := H z_axis z_axis). unfold product, sum3, transpose, unit_matrix in Hx, Hy, Hz.
change (r23 t = Q t z_axis x_axis * Q t x_axis y_axis - Q t z_axis y_axis * Q t x_axis x_axis). unfold r23.
set (cx := Q t z_axis y_axis * Q t x_axis z_axis - Q t z_axis z_axis * Q t x_axis y_axis). set (cy := Q t z_axis z_axis * Q t x_axis x_axis - Q t z_axis x_axis * Q t x_axis z_axis).
set (cz := Q t z_axis x_axis * Q t x_axis y_axis - Q t z_axis y_axis * Q t x_axis x_axis).
apply combine with (1 := Hx) (2 := Hy) (3 := Hz) (4 := D) (x := cx) (y := cy). unfold cx, cy, cz. ring.
Qed.

(** c is constant, and c < a keeps J off the z axis. *)
Lemma matrix_c_constant t : matrix_c moment (Q t) = matrix_c moment (Q 0).
Proof.
apply (equal_everywhere (fun t => 2 * Iy * (J1 t ^ 2 / (2 * Ix) + J2 t ^ 2 / (2 * Iy) + J3 t ^ 2 / (2 * Iz)) - 1)). intros s.
assert (E1 := J1_derive s). assert (E2 := J2_derive s). assert (E3 := J3_derive s). assert (I := fm_moments).
auto_derive. repeat split; eexists; [apply E1|apply E2|apply E3].
change (fun x => J1 x) with J1. change (fun x => J2 x) with J2. change (fun x => J3 x) with J3.
rewrite (is_derive_unique J1 _ _ E1), (is_derive_unique J2 _ _ E2), (is_derive_unique J3 _ _ E3). field. lra.
Qed.
Lemma off_the_axis t : 0 < 1 - J3 t * J3 t.
Proof.
assert (E := third_row t). assert (I := fm_moments). apply Rnot_le_lt. intros L.
assert (0 <= J1 t * J1 t) by nra. assert (0 <= J2 t * J2 t) by nra.
assert (Z1 : J1 t * J1 t = 0) by lra. assert (Z2 : J2 t * J2 t = 0) by lra. assert (Z3 : J3 t * J3 t = 1) by lra.
assert (C := matrix_c_constant t). unfold matrix_c at 1 in C. unfold sum3 in C.
replace (Q t z_axis x_axis ^ 2) with (J1 t * J1 t) in C by (unfold J1; ring). replace (Q t z_axis y_axis ^ 2) with (J2 t * J2 t) in C by (unfold J2; ring).
replace (Q t z_axis z_axis ^ 2) with (J3 t * J3 t) in C by (unfold J3; ring). rewrite Z1, Z2, Z3 in C.
assert (C' : 2 * Iy * (0 / (2 * Ix) + 0 / (2 * Iy) + 1 / (2 * Iz)) - 1 = par_a moment) by (unfold par_a; field; lra). lra.
Qed.
Let S t := sqrt (1 - J3 t * J3 t).
Lemma S_positive t : 0 < S t.
Proof. apply sqrt_lt_R0, off_the_axis. Qed.
Lemma S_squared t : S t * S t = 1 - J3 t * J3 t.
Proof. apply sqrt_sqrt, Rlt_le, off_the_axis. Qed.
Lemma S_derive t : is_derive S t (- (J3 t * (J1 t * (J2 t / Iy) - J2 t * (J1 t / Ix)) / S t)).
Proof.
assert (P := S_positive t). assert (E3 := J3_derive t). assert (I := fm_moments).
evar_last. apply (is_derive_comp sqrt (fun t => 1 - J3 t * J3 t)).
- instantiate (1 := / (2 * S t)). unfold S. auto_derive. apply off_the_axis. field. apply Rgt_not_eq, P.
- auto_derive. repeat split; eexists; apply E3. reflexivity.
- change (fun x => J3 x) with J3. rewrite (is_derive_unique J3 _ _ E3). unfold scal; simpl; unfold mult; simpl. 
  match goal with |- @eq _ ?l ?r => change (@eq R l r) end. field. lra.
Qed.
Lemma over_S (f : R -> R) t l : is_derive f t l -> is_derive (fun t => f t / S t) t (l / S t + f t * (J3 t * (J1 t * (J2 t / Iy) - J2 t * (J1 t / Ix))) / (S t * S t * S t)).
Proof.
intros D. assert (P := S_positive t). assert (E := S_derive t). assert (I := fm_moments).
evar_last. apply (is_derive_mult f (fun t => / S t)). exact D. apply is_derive_inv. apply E. lra. intros; apply Rmult_comm.
unfold plus, mult; simpl. match goal with |- @eq _ ?l ?r => change (@eq R l r) end. field. lra.
Qed.
Lemma polynomial_continuous (w : R -> R) t : ex_derive w t -> continuous w t.
Proof. apply (ex_derive_continuous w). Qed.

Lemma psi_exists : exists ps : R -> R, (forall t, ex_derive ps t) /\ forall t, cos (ps t) = - J1 t / S t /\ sin (ps t) = J2 t / S t.
Proof.
assert (I := fm_moments).
set (w := fun t => (/ Iz - / Iy * (J2 t * J2 t) / (1 - J3 t * J3 t) - / Ix * (J1 t * J1 t) / (1 - J3 t * J3 t)) * J3 t).
destruct (angle_lift (fun t => - J1 t / S t) (fun t => J2 t / S t) w) as [ps [D E]].
- intros t. assert (P := S_positive t). assert (P2 := S_squared t). assert (E := third_row t).
  replace (- J1 t / S t * (- J1 t / S t) + J2 t / S t * (J2 t / S t)) with ((J1 t * J1 t + J2 t * J2 t) / (S t * S t)) by (field; lra). rewrite P2.
  replace (J1 t * J1 t + J2 t * J2 t) with (1 - J3 t * J3 t) by lra. unfold Rdiv. apply Rinv_r. assert (O := off_the_axis t). lra.
- intros t. apply polynomial_continuous. assert (X1 : ex_derive J1 t) by (eexists; apply J1_derive). assert (X2 : ex_derive J2 t) by (eexists; apply J2_derive). assert (X3 : ex_derive J3 t) by (eexists; apply J3_derive).
  assert (O := off_the_axis t). unfold w. auto_derive. repeat match goal with |- _ /\ _ => split | |- True => trivial | |- ex_derive (fun y => J1 y) _ => exact X1
    | |- ex_derive (fun y => J2 y) _ => exact X2 | |- ex_derive (fun y => J3 y) _ => exact X3 end; lra.
- intros t. assert (P := S_positive t). assert (P2 := S_squared t). assert (E := third_row t). assert (O := off_the_axis t).
  evar_last. apply (over_S (fun t => - J1 t)). apply (is_derive_opp J1). apply J1_derive. unfold opp; simpl. unfold w. rewrite <- P2.
  assert (P3 : S t * S t = J1 t * J1 t + J2 t * J2 t) by lra. match goal with |- @eq _ ?l ?r => change (@eq R l r) end.
  field_simplify_eq; [|lra]. replace (S t ^ 2) with (J1 t * J1 t + J2 t * J2 t) by (rewrite <- P3; ring). ring.
- intros t. assert (P := S_positive t). assert (P2 := S_squared t). assert (E := third_row t). assert (O := off_the_axis t).
  evar_last. apply (over_S J2). apply J2_derive. unfold w. rewrite <- P2.
  assert (P3 : S t * S t = J1 t * J1 t + J2 t * J2 t) by lra. match goal with |- @eq _ ?l ?r => change (@eq R l r) end.
  field_simplify_eq; [|lra]. replace (S t ^ 2) with (J1 t * J1 t + J2 t * J2 t) by (rewrite <- P3; ring). ring.
- exists ps. split; [intros t; eexists; apply D|exact E].
Qed.

(** The first two rows from the third row and the third column. *)
Lemma P3 t : S t * S t = J1 t * J1 t + J2 t * J2 t.
Proof. rewrite S_squared. assert (E := third_row t). lra. Qed.
Lemma divide z n t : z * (S t * S t) = n -> z = n / (S t * S t).
Proof. intros <-. assert (P := S_positive t). field. lra. Qed.
Lemma r11_solved t : r11 t = (- J1 t * r13 t * J3 t - J2 t * r23 t) / (S t * S t).
Proof. apply divide. rewrite P3, (row_2_cross t). assert (E := rows_1_3 t). replace (- J1 t * r13 t * J3 t) with (- J1 t * (r13 t * J3 t)) by ring. replace (r13 t * J3 t) with (- (r11 t * J1 t + r12 t * J2 t)) by lra. ring. Qed.
Lemma r12_solved t : r12 t = (- J2 t * r13 t * J3 t + J1 t * r23 t) / (S t * S t).
Proof. apply divide. rewrite P3, (row_2_cross t). assert (E := rows_1_3 t). replace (- J2 t * r13 t * J3 t) with (- J2 t * (r13 t * J3 t)) by ring. replace (r13 t * J3 t) with (- (r11 t * J1 t + r12 t * J2 t)) by lra. ring. Qed.
Lemma r21_solved t : r21 t = (- J1 t * r23 t * J3 t + J2 t * r13 t) / (S t * S t).
Proof. apply divide. rewrite P3, (row_1_cross t). assert (E := rows_2_3 t). replace (- J1 t * r23 t * J3 t) with (- J1 t * (r23 t * J3 t)) by ring. replace (r23 t * J3 t) with (- (r21 t * J1 t + r22 t * J2 t)) by lra. ring. Qed.
Lemma r22_solved t : r22 t = (- J2 t * r23 t * J3 t - J1 t * r13 t) / (S t * S t).
Proof. apply divide. rewrite P3, (row_1_cross t). assert (E := rows_2_3 t). replace (- J2 t * r23 t * J3 t) with (- J2 t * (r23 t * J3 t)) by ring. replace (r23 t * J3 t) with (- (r21 t * J1 t + r22 t * J2 t)) by lra. ring. Qed.

Lemma phi_exists : exists ph : R -> R, (forall t, ex_derive ph t) /\ forall t, cos (ph t) = r13 t / S t /\ sin (ph t) = r23 t / S t.
Proof.
assert (I := fm_moments).
set (w := fun t => (/ Iy * (J2 t * J2 t) + / Ix * (J1 t * J1 t)) / (1 - J3 t * J3 t)).
destruct (angle_lift (fun t => r13 t / S t) (fun t => r23 t / S t) w) as [ph [D E]].
- intros t. assert (P := S_positive t). assert (P2 := S_squared t). assert (E := third_column t).
  replace (r13 t / S t * (r13 t / S t) + r23 t / S t * (r23 t / S t)) with ((r13 t * r13 t + r23 t * r23 t) / (S t * S t)) by (field; lra). rewrite P2.
  replace (r13 t * r13 t + r23 t * r23 t) with (1 - J3 t * J3 t) by lra. unfold Rdiv. apply Rinv_r. assert (O := off_the_axis t). lra.
- intros t. apply polynomial_continuous. assert (X1 : ex_derive J1 t) by (eexists; apply J1_derive). assert (X2 : ex_derive J2 t) by (eexists; apply J2_derive). assert (X3 : ex_derive J3 t) by (eexists; apply J3_derive).
  assert (O := off_the_axis t). unfold w. auto_derive. repeat match goal with |- _ /\ _ => split | |- True => trivial | |- ex_derive (fun y => J1 y) _ => exact X1
    | |- ex_derive (fun y => J2 y) _ => exact X2 | |- ex_derive (fun y => J3 y) _ => exact X3 end; lra.
- intros t. assert (P := S_positive t). assert (P2 := S_squared t).
  evar_last. apply (over_S r13). apply r13_derive. unfold w. rewrite <- P2, r11_solved, r12_solved. match goal with |- @eq _ ?l ?r => change (@eq R l r) end. field. lra.
- intros t. assert (P := S_positive t). assert (P2 := S_squared t).
  evar_last. apply (over_S r23). apply r23_derive. unfold w. rewrite <- P2, r21_solved, r22_solved. match goal with |- @eq _ ?l ?r => change (@eq R l r) end. field. lra.
- exists ph. split; [intros t; eexists; apply D|exact E].
Qed.

(** Every free motion with c < a has Euler angles as in the paper, with theta in (0, pi). *)
Theorem angles_exist : exists th ps ph, motion moment th ps ph /\ forall t i j, Q t i j = attitude (th t) (ps t) (ph t) i j.
Proof.
destruct psi_exists as [ps [Dps Eps]]. destruct phi_exists as [ph [Dph Eph]].
assert (B : forall t, -1 < J3 t < 1). { intros t. assert (O := off_the_axis t). split; nra. }
assert (Co : forall t, cos (acos (J3 t)) = J3 t). { intros t. apply cos_acos. specialize (B t). lra. }
assert (Si : forall t, sin (acos (J3 t)) = S t). { intros t. apply sin_acos. specialize (B t). lra. }
assert (A : forall t i j, Q t i j = attitude (acos (J3 t)) (ps t) (ph t) i j).
{ intros t i j. assert (P := S_positive t). destruct (Eps t) as [C1 S1]. destruct (Eph t) as [C2 S2].
  destruct i, j; unfold attitude, product, sum3, Rz, Ry; rewrite ?Co, ?Si, ?C1, ?S1, ?C2, ?S2.
  - change (Q t x_axis x_axis) with (r11 t). rewrite r11_solved. field. lra.
  - change (Q t x_axis y_axis) with (r12 t). rewrite r12_solved. field. lra.
  - change (Q t x_axis z_axis) with (r13 t). field. lra.
  - change (Q t y_axis x_axis) with (r21 t). rewrite r21_solved. field. lra.
  - change (Q t y_axis y_axis) with (r22 t). rewrite r22_solved. field. lra.
  - change (Q t y_axis z_axis) with (r23 t). field. lra.
  - change (Q t z_axis x_axis) with (J1 t). field. lra.
  - change (Q t z_axis y_axis) with (J2 t). field. lra.
  - change (Q t z_axis z_axis) with (J3 t). field. }
exists (fun t => acos (J3 t)), ps, ph. split; [|exact A]. split; trivial.
- exact (free_body _ _ F).
- intros t. eexists. apply (is_derive_comp acos J3). apply acos_derive, B. apply J3_derive.
- intros t. rewrite Si. apply S_positive.
- intros t i j. apply (is_derive_ext (fun t => Q t i j)). { intros s. apply A. }
  evar_last. apply (free_kinematics _ _ F). unfold product, sum3. rewrite <- !A. unfold cross_matrix, velocity.
  rewrite <- !(momentum_is_third_row _ _ (ph t)), <- !A. reflexivity.
Qed.
End Angles.

(** A loop of the momentum, the third row of the attitude. *)
Definition matrix_loop (Q : R -> matrix) (t0 t1 : R) := t0 < t1 /\ (forall i, Q t1 z_axis i = Q t0 z_axis i) /\
  forall t, t0 < t < t1 -> ~ forall i, Q t z_axis i = Q t0 z_axis i.
Section Link.
Variable moment : axis -> R.
Variable Q : R -> matrix.
Variables th ps ph : R -> R.
Hypothesis A : forall t i j, Q t i j = attitude (th t) (ps t) (ph t) i j.
Lemma same_third_row s t : (forall i, Q s z_axis i = Q t z_axis i) <-> same_momentum th ps s t.
Proof. split; intros H i; assert (E := H i); rewrite !A, !momentum_is_third_row in *; exact E. Qed.
Lemma loops_agree t0 t1 : matrix_loop Q t0 t1 <-> one_loop th ps t0 t1.
Proof.
unfold matrix_loop, one_loop. rewrite same_third_row. split; intros [H1 [H2 H3]]; (split; [exact H1|split; [exact H2|]]); intros t Ht W; apply (H3 t Ht); now apply same_third_row.
Qed.
Lemma matrix_c_agrees : matrix_c moment (Q 0) = par_c moment (th 0) (ps 0).
Proof. unfold matrix_c, par_c, energy, sum3. rewrite !A, !momentum_is_third_row. reflexivity. Qed.
End Link.

(** The Montgomery phase of every oscillating free motion: the momentum goes through a loop from every time on,
    and over the loop the body turns about Z, the direction of the angular momentum, by 2 G(-c/b). *)
Theorem oscillating_body_turns moment Q : free_motion moment Q -> let c := matrix_c moment (Q 0) in - par_b moment < c < 0 ->
  forall t0, (exists t1, matrix_loop Q t0 t1) /\ forall t1, matrix_loop Q t0 t1 ->
  forall i j, Q t1 i j = product (Rz (2 * HalfPhase.G (par_a moment) (par_b moment) (- c / par_b moment))) (Q t0) i j.
Proof.
intros F c Hc t0. assert (PA := Theorems.body_a_positive moment (free_body _ _ F)).
destruct (angles_exist moment Q F) as [th [ps [ph [M A]]]]. { unfold c in Hc. lra. }
unfold c in *. rewrite (matrix_c_agrees moment Q th ps ph A) in *. split.
- destruct (oscillating_loop_exists moment th ps ph M Hc t0) as [t1 L]. exists t1. now apply (loops_agree Q th ps ph A).
- intros t1 L i j. apply (loops_agree Q th ps ph A) in L. rewrite <- (oscillating_phase moment th ps ph M Hc t0 t1 L).
  rewrite A, (loop_turns_body th ps ph t0 t1 (chart _ _ _ _ M) L i j). unfold product, sum3. rewrite !A. reflexivity.
Qed.
(** The same for every rotating free motion, with 2 F(c,0). *)
Theorem rotating_body_turns moment Q : free_motion moment Q -> let c := matrix_c moment (Q 0) in 0 < c < par_a moment ->
  forall t0, (exists t1, matrix_loop Q t0 t1) /\ forall t1, matrix_loop Q t0 t1 ->
  forall i j, Q t1 i j = product (Rz (2 * Theorem2.F (par_a moment) (par_b moment) c)) (Q t0) i j.
Proof.
intros F c [Hc Hc2] t0.
destruct (angles_exist moment Q F) as [th [ps [ph [M A]]]]. { exact Hc2. }
unfold c in *. rewrite (matrix_c_agrees moment Q th ps ph A) in *. split.
- destruct (rotating_loop_exists moment th ps ph M Hc t0) as [t1 L]. exists t1. now apply (loops_agree Q th ps ph A).
- intros t1 L i j. apply (loops_agree Q th ps ph A) in L. rewrite <- (rotating_phase moment th ps ph M Hc t0 t1 L).
  rewrite A, (loop_turns_body th ps ph t0 t1 (chart _ _ _ _ M) L i j). unfold product, sum3. rewrite !A. reflexivity.
Qed.
