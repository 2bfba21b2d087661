(** Theorem 3 and proposition 4 for the motions of the body in time, on the whole range -b < c < a: the curve of the body (BodyCurve.v) is C, is the graph of a
    function of c, and is injective if and only if I_x <= I_y + I_z. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Polhode Require Physical Motion.
From Polhode Require Import FreeBody HalfPhase Theorem1 Uniqueness Oscillation Symmetry Curve TimeMotion BodyCurve FirstBranch CentredMotions Theorem3.
Open Scope R_scope.

(** sin theta > 0 all along, for c < a. *)
Lemma sin_theta_positive a b c psi theta : 0 < a -> 0 < b < 1 -> c < a -> centred_motion a b c psi theta -> forall v, 0 < sin (theta v).
Proof.
intros Ha Hb Hc M v. apply Rnot_le_lt. intros N. assert (S0 : 0 < sin (theta 0)). { destruct M as [_ [_ [T _]]]. apply sin_gt_0; lra. }
destruct (IVT_gen (fun v => sin (theta v)) 0 v 0) as [z [_ E]].
- intros x. apply (continuity_pt_comp theta sin); [exact (theta_continuous a b c psi theta M x)|apply continuity_sin].
- split; [apply Rle_trans with (1 := Rmin_r _ _); lra|apply Rle_trans with (2 := Rmax_l _ _); lra].
- assert (F := first_integral_at a b Hb c psi theta z M). unfold first_integral in F. rewrite E in F. replace (0 ^2) with 0 in F by ring. lra.
Qed.

Section BodyTheorem3.
Variable moment : axis -> R.
Hypothesis Hbody : 0 < moment z_axis < moment y_axis /\ moment y_axis < moment x_axis.
Notation Ix := (moment x_axis).
Notation Iy := (moment y_axis).
Notation Iz := (moment z_axis).
Notation a := (par_a moment).
Notation b := (par_b moment).

Theorem body_C_is_C c eps : -b < c < a -> (body_C moment c eps <-> curve_C a b c eps).
Proof.
intros Hc. assert (A := BodyCurve.Ha moment Hbody). assert (B := BodyCurve.Hb moment Hbody). split.
- intros [th [ps [ph [t [M [C [Z [T [F [P E]]]]]]]]]].
  destruct (centred_motion_every_c a b A B c Hc) as [Psi [Theta N]]. assert (N' := N). destruct N' as [RM [Z' [T' C']]].
  exists Psi, Theta. split; [exact N|].
  assert (Q : th 0 = Theta 0).
  { apply (polar_angle a b A B (ps 0) (Psi 0)); trivial; [lra|]. rewrite C', <- C. symmetry. apply (c_first_integral moment Hbody). }
  destruct (time_motion Ix Iy Iz Hbody ps th ph (body_angles moment th ps ph M) Psi Theta 0 RM) with (t := t) as [D _].
  + rewrite F. lra.
  + rewrite F. exact Q.
  + rewrite P in D. lra.
- intros [Psi [Theta [N ->]]]. assert (N' := N). destruct N' as [M [Z [T C]]].
  destruct (run_in_time moment Hbody Psi Theta M) as [ph [F D]]; [now apply (sin_theta_positive a b c Psi Theta A B (proj2 Hc))|].
  destruct (phi_takes_every_value Ix Iy Iz Hbody _ _ ph (body_angles moment _ _ _ D) PI) as [t [E _]].
  exists (fun t => Theta (ph t)), (fun t => Psi (ph t)), ph, t. split; [exact D|]. rewrite F, E.
  split. { rewrite <- C. apply (c_first_integral moment Hbody). } split; [exact Z|]. split; [exact T|]. split; [reflexivity|]. split; [reflexivity|]. ring.
Qed.
(** Lemma 1 for the body. *)
Theorem body_lemma_1 c : -b < c < a -> exists eps, body_C moment c eps /\ forall eps', body_C moment c eps' -> eps' = eps.
Proof.
intros Hc. assert (A := BodyCurve.Ha moment Hbody). assert (B := BodyCurve.Hb moment Hbody).
destruct (lemma_1_graph a b A B c Hc) as [e [Ce U]]. exists e. split; [now apply body_C_is_C|]. intros e' C'. apply U. now apply body_C_is_C.
Qed.
Lemma physical_body : 1 <= geometric_constant a b <-> Ix <= Iy + Iz.
Proof.
assert (A := BodyCurve.Ha moment Hbody). assert (B := BodyCurve.Hb moment Hbody). assert (X := not_physical_iff_crossing moment Hbody).
assert (Y : (exists c, -b < c < 0 /\ body_C moment c (PI/2)) <-> exists c, crossing a b c).
{ split; intros [c [Hc C]]; exists c; (split; [exact Hc|]); apply body_C_is_C; trivial; lra. }
rewrite Y, (lemma_3_crossing a b A B) in X. split; intros L; apply Rnot_lt_le; intros N; apply X in N; lra.
Qed.
(** Theorem 3 for the body: different c have different eps if and only if the body is physical. *)
Theorem body_theorem_3 : (forall c d e, -b < c < a -> -b < d < a -> body_C moment c e -> body_C moment d e -> c = d) <-> Ix <= Iy + Iz.
Proof.
assert (A := BodyCurve.Ha moment Hbody). assert (B := BodyCurve.Hb moment Hbody). rewrite <- physical_body, <- (theorem_3_curve a b A B).
split; intros H c d e Hc Hd Ce De; apply (H c d e); trivial; now apply body_C_is_C.
Qed.
(** A physical body's flip defect decreases as c grows. *)
Theorem body_defect_decreases c d e f : Ix <= Iy + Iz -> -b < c -> c < d -> d < a -> body_C moment c e -> body_C moment d f -> f < e.
Proof.
intros H Hc L Hd Ce Df. assert (A := BodyCurve.Ha moment Hbody). assert (B := BodyCurve.Hb moment Hbody).
apply physical_body in H. apply body_C_is_C in Ce; [|lra]. apply body_C_is_C in Df; [|lra]. exact (physical_curve_decreases a b A B c d e f H Hc L Ce Df).
Qed.
End BodyTheorem3.
