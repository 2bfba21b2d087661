(** From Euler's equations to the Montgomery phase. Given are J with J' = J x omega, omega = I^-1 J, and a rotation matrix R with R' = R [omega]x:
    then R J, the angular momentum in space, is constant; where it is the unit vector along Z this is a free motion as in FreeMotion.v. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Polhode Require HalfPhase Theorem2.
From Polhode Require Import FreeBody Loop Theorems FreeMotion.
Open Scope R_scope.

(** Euler's equations and the attitude that goes with them. *)
Record euler_solution (moment : axis -> R) (J : R -> axis -> R) (Q : R -> matrix) : Prop := {
  solution_body : body moment;
  euler : forall t i, is_derive (fun t => J t i) t (cross (J t) (fun k => J t k / moment k) i);
  attitude_is_rotation : forall t, rotation (Q t);
  attitude_follows : forall t i j, is_derive (fun t => Q t i j) t (product (Q t) (cross_matrix (fun k => J t k / moment k)) i j) }.
(** The angular momentum in space, R J. *)
Definition in_space (A : matrix) (v : axis -> R) (i : axis) : R := sum3 (fun k => A i k * v k).

Section Solution.
Variable moment : axis -> R.
Variable J : R -> axis -> R.
Variable Q : R -> matrix.
Hypothesis E : euler_solution moment J Q.

Theorem momentum_in_space_is_constant t i : in_space (Q t) (J t) i = in_space (Q 0) (J 0) i.
Proof.
apply (equal_everywhere (fun t => in_space (Q t) (J t) i)). intros s. unfold in_space, sum3.
assert (D : forall k, is_derive (fun t => Q t i k * J t k) s
  (product (Q s) (cross_matrix (fun k => J s k / moment k)) i k * J s k + Q s i k * cross (J s) (fun k => J s k / moment k) k)).
{ intros k. evar_last. apply (is_derive_mult (fun t => Q t i k) (fun t => J t k)). apply (attitude_follows _ _ _ E). apply (euler _ _ _ E). intros; apply Rmult_comm.
  unfold plus, mult; simpl. reflexivity. }
evar_last. apply (is_derive_plus (fun t => Q t i x_axis * J t x_axis + Q t i y_axis * J t y_axis) (fun t => Q t i z_axis * J t z_axis)).
apply (is_derive_plus (fun t => Q t i x_axis * J t x_axis) (fun t => Q t i y_axis * J t y_axis)). apply D. apply D. apply D.
unfold plus; simpl. unfold product, sum3, cross, sum3, cross_matrix. ring.
Qed.

Hypothesis along_Z : forall i, in_space (Q 0) (J 0) i = unit_matrix i z_axis.
(** J is the third row of R. *)
Theorem momentum_is_row t k : Q t z_axis k = J t k.
Proof.
assert (H : forall i, in_space (Q t) (J t) i = unit_matrix i z_axis). { intros i. rewrite momentum_in_space_is_constant. apply along_Z. }
assert (Hx := H x_axis). assert (Hy := H y_axis). assert (Hz := H z_axis). unfold unit_matrix in Hx, Hy, Hz.
destruct (attitude_is_rotation _ _ _ E t) as [_ [O _]].
assert (Ox := O k x_axis). assert (Oy := O k y_axis). assert (Oz := O k z_axis). unfold product, transpose, sum3 in Ox, Oy, Oz.
assert (S : sum3 (fun i => Q t i k * in_space (Q t) (J t) i) = unit_matrix k x_axis * J t x_axis + unit_matrix k y_axis * J t y_axis + unit_matrix k z_axis * J t z_axis).
{ rewrite <- Ox, <- Oy, <- Oz. unfold in_space, sum3. ring. }
unfold sum3 in S. rewrite Hx, Hy, Hz in S. destruct k; unfold unit_matrix in S; lra.
Qed.
Theorem solution_is_free_motion : free_motion moment Q.
Proof.
split. exact (solution_body _ _ _ E). exact (attitude_is_rotation _ _ _ E).
intros t i j. evar_last. apply (attitude_follows _ _ _ E).
unfold product, sum3, cross_matrix. rewrite !(momentum_is_row t). destruct j; reflexivity.
Qed.

(** c = 2 I_y H - 1. *)
Definition solution_c := 2 * moment y_axis * sum3 (fun i => J 0 i ^ 2 / (2 * moment i)) - 1.
Lemma solution_c_agrees : matrix_c moment (Q 0) = solution_c.
Proof. unfold matrix_c, solution_c, sum3. rewrite !(momentum_is_row 0). reflexivity. Qed.
(** t1 is the first return of J after t0. *)
Definition first_return t0 t1 := t0 < t1 /\ (forall i, J t1 i = J t0 i) /\ forall t, t0 < t < t1 -> ~ forall i, J t i = J t0 i.
Lemma first_return_agrees t0 t1 : matrix_loop Q t0 t1 <-> first_return t0 t1.
Proof.
assert (H : forall s t, (forall i, Q s z_axis i = Q t z_axis i) <-> (forall i, J s i = J t i)).
{ intros s t. split; intros W i; assert (W' := W i); rewrite !momentum_is_row in *; exact W'. }
unfold matrix_loop, first_return. rewrite (H t1 t0). split; intros [H1 [H2 H3]]; (split; [exact H1|split; [exact H2|]]); intros t Ht W; apply (H3 t Ht); now apply H.
Qed.

(** Every oscillating solution of Euler's equations, -b < c < 0: J returns, from every time on, and at its first return
    the body has turned about its angular momentum by 2 G(-c/b). *)
Theorem oscillating_solution : - par_b moment < solution_c < 0 -> forall t0, (exists t1, first_return t0 t1) /\ forall t1, first_return t0 t1 ->
  forall i j, Q t1 i j = product (Rz (2 * HalfPhase.G (par_a moment) (par_b moment) (- solution_c / par_b moment))) (Q t0) i j.
Proof.
rewrite <- solution_c_agrees. intros Hc t0. destruct (oscillating_body_turns moment Q solution_is_free_motion Hc t0) as [[t1 L] T]. split.
- exists t1. now apply first_return_agrees.
- intros s Ls. apply T. now apply first_return_agrees.
Qed.
(** Every rotating solution of Euler's equations, 0 < c < a: the same with 2 F(c,0). *)
Theorem rotating_solution : 0 < solution_c < par_a moment -> forall t0, (exists t1, first_return t0 t1) /\ forall t1, first_return t0 t1 ->
  forall i j, Q t1 i j = product (Rz (2 * Theorem2.F (par_a moment) (par_b moment) solution_c)) (Q t0) i j.
Proof.
rewrite <- solution_c_agrees. intros Hc t0. destruct (rotating_body_turns moment Q solution_is_free_motion Hc t0) as [[t1 L] T]. split.
- exists t1. now apply first_return_agrees.
- intros s Ls. apply T. now apply first_return_agrees.
Qed.
End Solution.

(** Any angular momentum, of a length L > 0 along Z: J(t/L)/L and R(t/L) solve Euler's equations with the length 1, so that only the times scale.
    c = 2 I_y H/L^2 - 1. *)
Section AnyLength.
Variable moment : axis -> R.
Variable J : R -> axis -> R.
Variable Q : R -> matrix.
Hypothesis E : euler_solution moment J Q.
Variable L : R.
Hypothesis HL : 0 < L.
Hypothesis along_Z : forall i, in_space (Q 0) (J 0) i = L * unit_matrix i z_axis.
Definition scaled_J (t : R) (i : axis) := J (t / L) i / L.
Definition scaled_Q (t : R) : matrix := Q (t / L).
Definition scaled_c := 2 * moment y_axis * sum3 (fun i => J 0 i ^ 2 / (2 * moment i)) / L^2 - 1.

Lemma slowed (f : R -> R) t l : is_derive f (t / L) l -> is_derive (fun t => f (t / L)) t (l / L).
Proof.
intros D. evar_last. apply (is_derive_comp f (fun t => t / L) t _ (/ L) D). { auto_derive; trivial. field. lra. }
unfold scal; simpl; unfold mult; simpl. unfold Rdiv. apply Rmult_comm.
Qed.
Theorem scaled_solution : euler_solution moment scaled_J scaled_Q.
Proof.
assert (Pm : forall k, moment k <> 0). { destruct (solution_body _ _ _ E) as [[H1 H2] H3]. intros k. destruct k; lra. }
split.
- exact (solution_body _ _ _ E).
- intros t i. unfold scaled_J. evar_last. apply (is_derive_ext (fun t => / L * J (t / L) i)). { intros s. unfold Rdiv. apply Rmult_comm. }
  apply (is_derive_scal (fun t => J (t / L) i) t (/ L)). apply (slowed (fun t => J t i)). apply (euler _ _ _ E).
  assert (Px := Pm x_axis). assert (Py := Pm y_axis). assert (Pz := Pm z_axis).
  unfold cross, sum3, cross_matrix. destruct i; match goal with |- @eq _ ?l ?r => change (@eq R l r) end; field; repeat split; trivial; lra.
- intros t. apply (attitude_is_rotation _ _ _ E).
- intros t i j. unfold scaled_Q. evar_last. apply (slowed (fun t => Q t i j)). apply (attitude_follows _ _ _ E).
  assert (Px := Pm x_axis). assert (Py := Pm y_axis). assert (Pz := Pm z_axis).
  unfold product, sum3, cross_matrix, scaled_J. destruct j; match goal with |- @eq _ ?l ?r => change (@eq R l r) end; field; repeat split; trivial; lra.
Qed.
Lemma zero_over : 0 / L = 0. Proof. unfold Rdiv. apply Rmult_0_l. Qed.
Lemma scaled_along_Z i : in_space (scaled_Q 0) (scaled_J 0) i = unit_matrix i z_axis.
Proof.
unfold scaled_Q, scaled_J. rewrite zero_over. apply (Rmult_eq_reg_l L); [|lra]. rewrite <- along_Z. unfold in_space, sum3. field. lra.
Qed.
Lemma scaled_c_agrees : solution_c moment scaled_J = scaled_c.
Proof.
assert (Pm : forall k, moment k <> 0). { destruct (solution_body _ _ _ E) as [[H1 H2] H3]. intros k. destruct k; lra. }
assert (Px := Pm x_axis). assert (Py := Pm y_axis). assert (Pz := Pm z_axis).
unfold solution_c, scaled_c, scaled_J, sum3. rewrite zero_over. field. repeat split; trivial; lra.
Qed.
Lemma times_L t : t * L / L = t. Proof. field. lra. Qed.
Lemma scaled_first_return t0 t1 : first_return scaled_J (t0 * L) (t1 * L) <-> first_return J t0 t1.
Proof.
assert (S : forall s t, (forall i, scaled_J (s * L) i = scaled_J (t * L) i) <-> (forall i, J s i = J t i)).
{ intros s t. unfold scaled_J. rewrite !times_L. split; intros H i; assert (W := H i); [apply (Rmult_eq_reg_r (/ L)); [exact W|apply Rinv_neq_0_compat; lra]|now rewrite W]. }
unfold first_return. rewrite (S t1 t0). split; intros [H1 [H2 H3]]; (split; [|split; [exact H2|]]).
- now apply (Rmult_lt_reg_r L).
- intros t Ht W. apply (H3 (t * L)); [split; apply Rmult_lt_compat_r; lra|]. now apply S.
- now apply Rmult_lt_compat_r.
- intros t Ht W. apply (H3 (t / L)).
  + split; apply (Rmult_lt_reg_r L); trivial; replace (t / L * L) with t by (field; lra); lra.
  + apply S. replace (t / L * L) with t by (field; lra). exact W.
Qed.
(** The two theorems, for any length of J. *)
Theorem oscillating_solution_any_length : - par_b moment < scaled_c < 0 -> forall t0, (exists t1, first_return J t0 t1) /\ forall t1, first_return J t0 t1 ->
  forall i j, Q t1 i j = product (Rz (2 * HalfPhase.G (par_a moment) (par_b moment) (- scaled_c / par_b moment))) (Q t0) i j.
Proof.
intros Hc t0. rewrite <- scaled_c_agrees in *.
destruct (oscillating_solution moment scaled_J scaled_Q scaled_solution scaled_along_Z Hc (t0 * L)) as [[t1 R1] T]. split.
- exists (t1 / L). apply scaled_first_return. replace (t1 / L * L) with t1 by (field; lra). exact R1.
- intros s Ls i j. apply scaled_first_return in Ls. assert (W := T _ Ls i j). unfold scaled_Q in W. rewrite !times_L in W. exact W.
Qed.
Theorem rotating_solution_any_length : 0 < scaled_c < par_a moment -> forall t0, (exists t1, first_return J t0 t1) /\ forall t1, first_return J t0 t1 ->
  forall i j, Q t1 i j = product (Rz (2 * Theorem2.F (par_a moment) (par_b moment) scaled_c)) (Q t0) i j.
Proof.
intros Hc t0. rewrite <- scaled_c_agrees in *.
destruct (rotating_solution moment scaled_J scaled_Q scaled_solution scaled_along_Z Hc (t0 * L)) as [[t1 R1] T]. split.
- exists (t1 / L). apply scaled_first_return. replace (t1 / L * L) with t1 by (field; lra). exact R1.
- intros s Ls i j. apply scaled_first_return in Ls. assert (W := T _ Ls i j). unfold scaled_Q in W. rewrite !times_L in W. exact W.
Qed.
End AnyLength.
