(** The curve C of a rigid body, from its motion in time (FreeBody.v: a differentiable attitude R with R' = R [omega]x, from which Euler's
    equations follow), and theorem 4 and lemmas 2 and 3 for it. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Polhode Require Import HalfPhase Theorem1 Uniqueness Oscillation Symmetry Curve TimeMotion.
From Polhode Require Import FreeBody.
From Polhode Require Autonomous Existence Motion Physical.
Open Scope R_scope.

Section BodyCurve.
Variable moment : axis -> R.
Hypothesis Hbody : 0 < moment z_axis < moment y_axis /\ moment y_axis < moment x_axis.
Notation Ix := (moment x_axis).
Notation Iy := (moment y_axis).
Notation Iz := (moment z_axis).
Notation a := (par_a moment).
Notation b := (par_b moment).
Lemma Ha : 0 < a. Proof. exact (a_pos Ix Iy Iz Hbody). Qed.
Lemma Hb : 0 < b < 1. Proof. exact (b_bounds Ix Iy Iz Hbody). Qed.

(** The motions of the body satisfy (6), and c = 2 I_y H - 1 is the first integral of the reduced system. *)
Lemma body_angles th ps ph : motion moment th ps ph -> angle_motion Ix Iy Iz ps th ph.
Proof.
intros M t. split; [|split].
- rewrite <- (equation_6_theta moment th ps ph M t). exact (th_derive moment th ps ph M t).
- rewrite <- (equation_6_phi moment th ps ph M t). exact (ph_derive moment th ps ph M t).
- rewrite <- (equation_6_psi moment th ps ph M t). exact (ps_derive moment th ps ph M t).
Qed.
Lemma c_first_integral q p : par_c moment q p = first_integral a b p q.
Proof. exact (Motion.c_in_angles Ix Iy Iz Hbody (fun _ => q) (fun _ => p) 0). Qed.

(** The pairs (c, eps) of the body: a motion with this c passes psi = 0 with cos theta > 0, phi = 0, at the time 0 (the middle of the flip), and has
    psi = pi/2 - eps when phi = pi. By racket_in_time it then had psi = -pi/2 + eps when phi was -pi: Delta phi = 2 pi for Delta psi = pi - 2 eps. *)
Definition body_C (c eps : R) := exists th ps ph t, motion moment th ps ph /\ par_c moment (th 0) (ps 0) = c /\
  ps 0 = 0 /\ 0 < th 0 < PI/2 /\ ph 0 = 0 /\ ph t = PI /\ ps t = PI/2 - eps.

(** A reduced motion is run through in time: phi' = (1 - b cos^2 psi)/I_y has a solution that passes 0 at the time 0. *)
Lemma run_in_time Psi Theta : reduced_motion a b Psi Theta -> (forall v, 0 < sin (Theta v)) ->
  exists ph, ph 0 = 0 /\ motion moment (fun t => Theta (ph t)) (fun t => Psi (ph t)) ph.
Proof.
intros N S. assert (A := Ha). assert (B := Hb). assert (Y : 0 < Iy) by lra.
set (f := fun v => (1 - b * cos (Psi v) ^2) / Iy).
destruct (Autonomous.autonomous_solution f (1 / Iy)) as [al Dal].
- intros v. apply (ex_derive_continuous f). unfold f. auto_derive. exact (ex_intro _ _ (proj1 (N v))).
- intros v. assert (D := denominator b B (Psi v)). unfold f. apply Rdiv_lt_0_compat; lra.
- intros v. exact (proj2 (phi_rate_bounds Ix Iy Iz Hbody (Psi v))).
- assert (run : forall be, (forall t, is_derive be t (f (be t))) -> motion moment (fun t => Theta (be t)) (fun t => Psi (be t)) be).
  { intros be Dbe. apply Existence.equation_6_suffices; trivial; intros t.
    - evar_last. exact (is_derive_comp Theta be t _ _ (proj2 (N (be t))) (Dbe t)).
      unfold f, Uniqueness.theta_rate, scal; simpl; unfold mult; simpl. assert (D := denominator b B (Psi (be t))). simpl in D. field. lra.
    - evar_last. exact (is_derive_comp Psi be t _ _ (proj1 (N (be t))) (Dbe t)).
      unfold f, Uniqueness.psi_rate, scal; simpl; unfold mult; simpl. assert (D := denominator b B (Psi (be t))). simpl in D. field. lra. }
  destruct (phi_takes_every_value Ix Iy Iz Hbody _ _ al (body_angles _ _ _ (run al Dal)) 0) as [t0 [E _]].
  exists (fun t => al (t + t0)). split. { rewrite Rplus_0_l. exact E. }
  apply run. intros t. apply shifted_derive, Dal.
Qed.

(** For -b < c < 0 the curve of the body is the curve C of Curve.v, the graph of epsilon (c). *)
Theorem body_C_iff c eps : -b < c < 0 -> (body_C c eps <-> curve_C a b c eps).
Proof.
intros Hc. rewrite (curve_C_epsilon a b Ha Hb c eps Hc). split.
- intros [th [ps [ph [t [M [C [Z [T [F [P E]]]]]]]]]].
  destruct (racket_in_time Ix Iy Iz Hbody ps th ph (body_angles th ps ph M) c t Z T F) as [R _]; trivial.
  { rewrite <- C. symmetry. apply c_first_integral. }
  specialize (R P). change (ps t = PI/2 - epsilon a b c) in R. lra.
- intros ->. destruct (centred_motion_exists a b Ha Hb c Hc) as [Psi [Theta N]]. assert (N' := N). destruct N' as [M [Z [T C]]].
  destruct (oscillation_of_c b Hb c Hc) as [Hu W]. rewrite <- W in N.
  destruct (run_in_time Psi Theta M) as [ph [F B]].
  { intros v. assert (Q := theta_range a b Ha Hb (- c / b) Hu Psi Theta N v). apply sin_gt_0; apply Q. }
  destruct (phi_takes_every_value Ix Iy Iz Hbody _ _ ph (body_angles _ _ _ B) PI) as [t [E _]].
  exists (fun t => Theta (ph t)), (fun t => Psi (ph t)), ph, t. split; [exact B|]. rewrite F, E.
  split. { rewrite <- C. apply c_first_integral. } split; [exact Z|]. split; [exact T|]. split; [reflexivity|]. split; [reflexivity|].
  unfold epsilon. destruct (closed_form a b Ha Hb (- c / b) Hu Psi Theta N PI) as [-> _]. ring.
Qed.

(** Theorem 4 for the body, sharp: its C meets S in exactly ceiling (1/I + 1/2) - 1 points with -b < c < 0. *)
Theorem theorem_4_of_the_body : has_exactly (count_below (1 / geometric_constant a b + 1/2))
  (fun c => -b < c < 0 /\ exists eps, body_C c eps /\ curve_S b c eps).
Proof.
apply (has_exactly_ext _ (meeting a b)); [|exact (theorem_4_sharp a b Ha Hb)].
intros c. unfold meeting. split; intros [Hc [eps [C S]]]; (split; [exact Hc|]); exists eps; (split; [|exact S]); now apply body_C_iff.
Qed.
(** Lemma 3 for the body, sharp: eps = pi/2 is taken exactly ceiling (1/I) - 1 times; *)
Theorem lemma_3_of_the_body : has_exactly (count_below (1 / geometric_constant a b)) (fun c => -b < c < 0 /\ body_C c (PI/2)).
Proof.
apply (has_exactly_ext _ (crossing a b)); [|exact (lemma_3_sharp a b Ha Hb)].
intros c. unfold crossing. split; intros [Hc C]; (split; [exact Hc|]); now apply body_C_iff.
Qed.
(** so never for a physical body, I_x <= I_y + I_z, and for every body that is not physical. *)
Theorem not_physical_iff_crossing : (exists c, -b < c < 0 /\ body_C c (PI/2)) <-> Iy + Iz < Ix.
Proof.
assert (A := Ha). assert (B := Hb).
assert (E : (exists c, -b < c < 0 /\ body_C c (PI/2)) <-> exists c, crossing a b c).
{ split; intros [c [Hc C]]; exists c; (split; [exact Hc|]); now apply body_C_iff. }
rewrite E, (lemma_3_crossing a b A B).
assert (P := Physical.physical_iff a b A B). fold (geometric_constant a b) in P.
assert (Q : 2 * b + a * b <= 1 <-> Ix <= Iy + Iz).
{ assert (F : (1 - (2 * b + a * b)) * (Ix * Iz) = Iy * (Iy + Iz - Ix)) by (unfold par_a, par_b; field; lra).
  assert (X0 : 0 < Ix * Iz) by (apply Rmult_lt_0_compat; lra). split; intros L.
  - apply Rnot_lt_le. intros N. assert (0 <= (1 - (2 * b + a * b)) * (Ix * Iz)) by (apply Rmult_le_pos; lra).
    assert (Iy * (Iy + Iz - Ix) < 0). { rewrite <- (Rmult_0_r Iy). apply Rmult_lt_compat_l; lra. } lra.
  - apply Rnot_lt_le. intros N. assert (0 <= Iy * (Iy + Iz - Ix)) by (apply Rmult_le_pos; lra).
    assert (0 < (2 * b + a * b - 1) * (Ix * Iz)) by (apply Rmult_lt_0_compat; lra). lra. }
split; intros L.
- apply Rnot_le_lt. intros N. apply Q, P in N. lra.
- apply Rnot_le_lt. intros N. apply P, Q in N. lra.
Qed.
End BodyCurve.
