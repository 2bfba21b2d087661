(** Theorems 1 and 2 of the paper, about the motions of the body. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Polhode Require HalfPhase Prop1 Theorem1 Theorem2 Values Existence.
From Polhode Require Import FreeBody Loop MotionPhase Rotating.
Open Scope R_scope.

(** The geometric constants (eq. 5) of a body, and what makes it physical (eq. 1). *)
Definition constant_I (moment : axis -> R) := (1 - par_b moment) / sqrt (par_b moment * (par_a moment + par_b moment)).
Definition constant_J (moment : axis -> R) := (par_a moment + 1) / sqrt (par_a moment * (par_a moment + par_b moment)) - 1.
Definition body (moment : axis -> R) := 0 < moment z_axis < moment y_axis /\ moment y_axis < moment x_axis.
Definition physical (moment : axis -> R) := moment x_axis <= moment y_axis + moment z_axis /\
  moment y_axis <= moment x_axis + moment z_axis /\ moment z_axis <= moment x_axis + moment y_axis.

(** D is a Montgomery phase of the body at c: what phi gains over one loop of the momentum, in some free motion with this c. *)
Definition montgomery_phase (moment : axis -> R) (c D : R) := exists th ps ph t0 t1,
  motion moment th ps ph /\ par_c moment (th 0) (ps 0) = c /\ one_loop th ps t0 t1 /\ D = ph t1 - ph t0.

Lemma body_a_positive moment : body moment -> 0 < par_a moment.
Proof. intros [[H1 H2] H3]. unfold par_a. apply (Rmult_lt_reg_r (moment z_axis)); trivial. field_simplify; lra. Qed.
Lemma body_b_range moment : body moment -> 0 < par_b moment < 1.
Proof. intros [[H1 H2] H3]. unfold par_b. split; apply (Rmult_lt_reg_r (moment x_axis)); try lra; field_simplify; lra. Qed.

(** Proposition 1: a body is physical iff I >= 1. *)
Theorem proposition_1 moment : body moment -> (physical moment <-> 1 <= constant_I moment).
Proof. intros [[H1 H2] H3]. apply (Prop1.proposition_1 (moment x_axis) (moment y_axis) (moment z_axis)); trivial. Qed.

Lemma glb_twice (E : R -> Prop) (l : R) : is_glb_Rbar E l -> is_glb_Rbar (fun y => exists z, E z /\ y = 2*z) (2*l).
Proof.
intros [L G]. split.
- intros y [z [Hz ->]]. assert (H := L z Hz). simpl in *. lra.
- intros m Hm. destruct m as [m| |]; simpl; trivial.
  + assert (H : Rbar_le (m/2) l). { apply G. intros z Hz. assert (H := Hm (2*z)). simpl in *. assert (m <= 2*z) by (apply H; exists z; auto). lra. }
    simpl in H. lra.
  + apply (G p_infty). intros z Hz. apply (Hm (2*z)). exists z; auto.
Qed.
Lemma glb_ext (E F : R -> Prop) (l : Rbar) : (forall y, E y <-> F y) -> is_glb_Rbar E l -> is_glb_Rbar F l.
Proof. intros H [L G]. split; [intros y Hy; apply L; now apply H | intros m Hm; apply G; intros y Hy; apply Hm; now apply H]. Qed.

Section Theorems.
Variable moment : axis -> R.
Hypothesis Hbody : body moment.
Notation a := (par_a moment).
Notation b := (par_b moment).
Notation I := (constant_I moment).
Notation J := (constant_J moment).

(** The Montgomery phase of the oscillating motions is a function of c, 2 G(-c/b) ... *)
Theorem oscillating_phase_at c D : - b < c < 0 -> (montgomery_phase moment c D <-> D = 2 * HalfPhase.G a b (- c / b)).
Proof.
intros Hc. split.
- intros [th [ps [ph [t0 [t1 [M [E [L ->]]]]]]]]. subst c. now apply (oscillating_phase moment th ps ph M Hc).
- intros ->. destruct (Existence.oscillating_motion_exists moment Hbody c Hc) as [th [ps [ph [M E]]]]. subst c.
  destruct (oscillating_loop_exists moment th ps ph M Hc 0) as [t1 L]. exists th, ps, ph, 0, t1. split; [exact M|]. split; [reflexivity|]. split; [exact L|].
  symmetry. now apply (oscillating_phase moment th ps ph M Hc).
Qed.
(** ... which increases. *)
Theorem oscillating_phase_increases c d D E : - b < c -> c < d -> d < 0 -> montgomery_phase moment c D -> montgomery_phase moment d E -> D < E.
Proof.
intros H1 H2 H3 P Q. destruct (body_b_range moment Hbody) as [B1 B2]. assert (A := body_a_positive moment Hbody).
apply oscillating_phase_at in P; [|lra]. apply oscillating_phase_at in Q; [|lra]. subst D E. apply Rmult_lt_compat_l; [lra|].
apply HalfPhase.G_decreasing; trivial. lra. apply Rdiv_lt_0_compat; lra.
unfold Rdiv. apply Rmult_lt_compat_r. now apply Rinv_0_lt_compat. lra.
apply (Rmult_le_reg_r b); trivial. field_simplify; lra.
Qed.

(** Theorem 1. Of all oscillating motions of a body the Montgomery phases have the greatest lower bound 2 pi I, ... *)
Theorem theorem_1_infimum : is_glb_Rbar (fun D => exists c, - b < c < 0 /\ montgomery_phase moment c D) (2 * PI * I).
Proof.
assert (B := body_b_range moment Hbody). assert (A := body_a_positive moment Hbody).
replace (2 * PI * I) with (2 * (PI * Theorem1.geometric_constant a b)) by (unfold constant_I, Theorem1.geometric_constant; ring).
apply (glb_ext (fun y => exists z, (exists u, 0 < u < 1 /\ z = HalfPhase.G a b u) /\ y = 2*z)).
2:{ apply glb_twice. now apply Theorem1.half_phase_infimum. }
intros D. split.
- intros [z [[u [Hu ->]] ->]]. exists (- (b*u)). assert (Hc : - b < - (b*u) < 0) by (split; nra). split; trivial.
  apply oscillating_phase_at; trivial. replace (- - (b*u) / b) with u by (field; lra). reflexivity.
- intros [c [Hc P]]. apply oscillating_phase_at in P; trivial. exists (HalfPhase.G a b (- c / b)). split; trivial. exists (- c / b). split; trivial.
  split. apply Rdiv_lt_0_compat; lra. apply (Rmult_lt_reg_r b); [lra|]. field_simplify; lra.
Qed.
(** ... which none of them has, ... *)
Theorem theorem_1_not_attained c D : - b < c < 0 -> montgomery_phase moment c D -> 2 * PI * I < D.
Proof.
intros Hc P. assert (B := body_b_range moment Hbody). assert (A := body_a_positive moment Hbody).
apply oscillating_phase_at in P; trivial. subst D.
destruct (Theorem1.half_phase_infimum a b A B) as [_ H]. assert (U : 0 < - c / b < 1).
{ split. apply Rdiv_lt_0_compat; lra. apply (Rmult_lt_reg_r b); [lra|]. field_simplify; lra. }
assert (H' := H _ U). change (Theorem1.geometric_constant a b) with I in H'. lra.
Qed.
(** ... and the body is physical if and only if that bound is at least 2 pi. *)
Theorem theorem_1_physical : physical moment <->
  forall l, is_glb_Rbar (fun D => exists c, - b < c < 0 /\ montgomery_phase moment c D) l -> Rbar_le (2 * PI) l.
Proof.
assert (HPI := PI_RGT_0). rewrite (proposition_1 moment Hbody). split.
- intros H l L. apply Rbar_le_trans with (2 * PI * I); [simpl; nra|]. destruct L as [_ G]. apply G. apply theorem_1_infimum.
- intros H. assert (L := H _ theorem_1_infimum). simpl in L. nra.
Qed.

(** In other words: a body is physical if and only if every oscillating motion of it has a Montgomery phase above 2 pi. *)
Theorem physical_iff_phases_above_2pi : physical moment <-> forall c D, - b < c < 0 -> montgomery_phase moment c D -> 2 * PI < D.
Proof.
assert (HPI := PI_RGT_0). split.
- intros H c D Hc P. apply (proposition_1 moment Hbody) in H. assert (L := theorem_1_not_attained c D Hc P). nra.
- intros H. apply theorem_1_physical. intros l [_ G]. apply (G (2 * PI)). intros D [c [Hc P]]. simpl. left. now apply (H c).
Qed.
(** The Montgomery phase takes every value above 2 pi I, at one c, and no other. *)
Theorem oscillating_phase_values D : 2 * PI * I < D <-> exists c, - b < c < 0 /\ montgomery_phase moment c D.
Proof.
assert (B := body_b_range moment Hbody). assert (A := body_a_positive moment Hbody). split.
- intros H. assert (H' : PI * Theorem1.geometric_constant a b < D/2) by (change (Theorem1.geometric_constant a b) with I; lra).
  apply (Values.takes_each_value_once a b A B) in H'. destruct H' as [u [Hu [E _]]]. exists (- (b*u)). assert (Hc : - b < - (b*u) < 0) by (split; nra). split; trivial.
  apply oscillating_phase_at; trivial. replace (- - (b*u) / b) with u by (field; lra). lra.
- intros [c [Hc P]]. now apply (theorem_1_not_attained c).
Qed.

(** The Montgomery phase of the rotating motions is a function of c, 2 F(c,0) ... *)
Theorem rotating_phase_at c D : 0 < c < a -> (montgomery_phase moment c D <-> D = 2 * Theorem2.F a b c).
Proof.
intros Hc. split.
- intros [th [ps [ph [t0 [t1 [M [E [L ->]]]]]]]]. subst c. now apply (rotating_phase moment th ps ph M (proj1 Hc)).
- intros ->. destruct (Existence.rotating_motion_exists moment Hbody c Hc) as [th [ps [ph [M E]]]]. subst c.
  destruct (rotating_loop_exists moment th ps ph M (proj1 Hc) 0) as [t1 L]. exists th, ps, ph, 0, t1. split; [exact M|]. split; [reflexivity|]. split; [exact L|].
  symmetry. now apply (rotating_phase moment th ps ph M (proj1 Hc)).
Qed.
(** ... which decreases. *)
Theorem rotating_phase_decreases c d D E : 0 < c -> c < d -> d < a -> montgomery_phase moment c D -> montgomery_phase moment d E -> E < D.
Proof.
intros H1 H2 H3 P Q. apply rotating_phase_at in P; [|lra]. apply rotating_phase_at in Q; [|lra]. subst D E. apply Rmult_lt_compat_l; [lra|].
apply Theorem2.F_decreasing; trivial. now apply body_a_positive. now apply body_b_range.
Qed.
(** Theorem 2. Of all rotating motions of a body the Montgomery phases have the greatest lower bound 2 pi J, ... *)
Theorem theorem_2_infimum : is_glb_Rbar (fun D => exists c, 0 < c < a /\ montgomery_phase moment c D) (2 * PI * J).
Proof.
assert (B := body_b_range moment Hbody). assert (A := body_a_positive moment Hbody).
replace (2 * PI * J) with (2 * (PI * Theorem2.second_constant a b)) by (unfold constant_J, Theorem2.second_constant; ring).
apply (glb_ext (fun y => exists z, (exists c, 0 < c < a /\ z = Theorem2.F a b c) /\ y = 2*z)).
2:{ apply glb_twice. now apply Theorem2.rotating_infimum. }
intros D. split.
- intros [z [[c [Hc ->]] ->]]. exists c. split; trivial. now apply rotating_phase_at.
- intros [c [Hc P]]. apply rotating_phase_at in P; trivial. exists (Theorem2.F a b c). split; trivial. now exists c.
Qed.
(** ... which none of them has. *)
Theorem theorem_2_not_attained c D : 0 < c < a -> montgomery_phase moment c D -> 2 * PI * J < D.
Proof.
intros Hc P. assert (B := body_b_range moment Hbody). assert (A := body_a_positive moment Hbody).
apply rotating_phase_at in P; trivial. subst D.
destruct (Theorem2.rotating_infimum a b A B) as [_ H]. assert (H' := H c Hc). change (Theorem2.second_constant a b) with J in H'. lra.
Qed.
End Theorems.
