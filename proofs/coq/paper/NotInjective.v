(** epsilon (c) is continuous on (-b, 0), and where I < 1 it takes a value twice there: below c* (where it crosses pi/2) it exceeds pi/2, and it
    returns to pi/2 for c -> -b. With DecreasesOscillating.v this is theorem 3 and proposition 4 for the oscillating motions. *)
Require Import Reals Lra Psatz Ratan.
From Coquelicot Require Import Coquelicot.
From Polhode Require Import HalfPhase Theorem1 Values Uniqueness Oscillation Symmetry Curve SwingInC DecreasesOscillating.
From Polhode Require Phase.
Open Scope R_scope.

Section NotInjective.
Variables a b : R.
Hypothesis Ha : 0 < a.
Hypothesis Hb : 0 < b < 1.
Notation I := (geometric_constant a b).
Notation sine := (end_sine a b).

Lemma end_sine_continuous u : 0 < u < 1 -> continuity_pt sine u.
Proof.
intros Hu. unfold end_sine. apply (continuity_pt_mult (fun u => sqrt (1 - u)) (fun u => sin (turn a b u PI))).
- apply (continuity_pt_comp (fun u => 1 - u) sqrt); [|apply sqrt_continuity_pt; lra]. apply continuity_pt_minus; [|apply continuity_pt_id]. apply continuity_pt_const. now intros ? ?.
- apply (continuity_pt_comp (fun u => turn a b u PI) sin); [|apply continuity_sin]. apply turn_continuous_in_u; trivial. apply PI_RGT_0.
Qed.
(** epsilon is a continuous function of c on (-b, 0). *)
Theorem epsilon_continuous c : -b < c < 0 -> continuity_pt (epsilon a b) c.
Proof.
intros Hc. destruct (oscillation_of_c b Hb c Hc) as [Hu _].
apply (continuity_pt_ext (fun c => PI/2 - asin (sine (- c / b)))); [reflexivity|].
apply (continuity_pt_minus (fun _ => PI/2) (fun c => asin (sine (- c / b)))); [apply continuity_pt_const; now intros ? ?|].
apply (continuity_pt_comp (fun c => sine (- c / b)) asin); [|apply derivable_continuous_pt, derivable_pt_asin; now apply end_sine_bounds].
apply (continuity_pt_comp (fun c => - c / b) sine); [|now apply end_sine_continuous].
apply (continuity_pt_mult (fun c => - c) (fun _ => / b)); [apply continuity_pt_opp, continuity_pt_id|apply continuity_pt_const; now intros ? ?].
Qed.
(** It tends to pi/2 for c -> -b, in every body: |cos epsilon| <= sqrt (1 + c/b). *)
Theorem end_sine_small u : 0 < u < 1 -> Rabs (sine u) <= sqrt (1 - u).
Proof.
intros Hu. unfold end_sine. assert (S : 0 <= sqrt (1 - u)) by apply sqrt_pos. rewrite Rabs_mult, (Rabs_pos_eq (sqrt (1 - u))) by trivial.
rewrite <- (Rmult_1_r (sqrt (1 - u))) at 2. apply Rmult_le_compat_l; trivial. apply sin_abs.
Qed.
(** Just below c*, sin psi (pi) is negative. *)
Lemma end_sine_negative u : 0 < u < 1 -> PI/2 < G a b u < PI -> sine u < 0.
Proof.
intros Hu [L H]. assert (PP := PI_RGT_0). assert (E := P_half_turn a b u Ha Hb Hu 0). assert (E2 := P_half_turn a b u Ha Hb Hu PI).
rewrite P_zero, !Rplus_0_l in E. rewrite E in E2.
assert (A := turn_above a b Ha Hb u PI PI Hu ltac:(lra)). assert (B := turn_below a b Ha Hb u PI (PI + PI) Hu ltac:(lra)).
assert (N : sin (turn a b u PI) < 0) by (apply sin_lt_0; lra).
assert (S : 0 < sqrt (1 - u)) by (apply sqrt_lt_R0; lra). unfold end_sine. nra.
Qed.
Lemma end_sine_twice : I < 1 -> exists u v, 0 < u /\ u < v /\ v < 1 /\ sine u = sine v /\ sine u < 0.
Proof.
intros H. assert (PP := PI_RGT_0). assert (PI_I : PI * I < PI) by nra.
destruct (proj1 (takes_each_value_once a b Ha Hb PI) PI_I) as [us [Hs [Gs _]]].
set (w := (Rmax (PI * I) (PI/2) + PI)/2). assert (M1 := Rmax_l (PI * I) (PI/2)). assert (M2 := Rmax_r (PI * I) (PI/2)).
assert (M3 : Rmax (PI * I) (PI/2) < PI) by (apply Rmax_lub_lt; lra).
destruct (proj1 (takes_each_value_once a b Ha Hb w) ltac:(unfold w; lra)) as [u1 [H1 [G1 _]]].
assert (L1 : us < u1).
{ apply Rnot_le_lt. intros [N|N]; [assert (D := G_decreasing a b Ha Hb u1 us ltac:(lra) N ltac:(lra))|rewrite N in G1]; unfold w in *; lra. }
assert (N1 : sine u1 < 0) by (apply end_sine_negative; trivial; rewrite G1; unfold w; lra).
assert (Z : sine us = 0). { unfold end_sine. assert (T := turn_G a b Ha Hb us Hs). rewrite Gs in T. rewrite T, sin_PI. ring. }
set (s := - sine u1). set (y := Rmin ((1 - u1)/2) ((s/4)^2)). set (u2 := 1 - y).
assert (S0 : 0 < s) by (unfold s; lra).
assert (Y0 : 0 < y) by (apply Rmin_pos; [lra|apply pow_lt; lra]). assert (Y1 : y <= (1 - u1)/2) by apply Rmin_l. assert (Y2 : y <= (s/4)^2) by apply Rmin_r.
assert (H2 : u1 < u2 < 1) by (unfold u2; lra).
assert (N2 : - (s/4) <= sine u2).
{ assert (A := end_sine_small u2 ltac:(lra)). replace (1 - u2) with y in A by (unfold u2; ring).
  apply sqrt_le_1_alt in Y2. rewrite sqrt_pow2 in Y2 by lra. assert (B := Rle_abs (- sine u2)). rewrite Rabs_Ropp in B. lra. }
destruct (Ranalysis5.IVT_interv (fun u => sine u + s/2) u1 u2) as [v [Hv Ev]]; try (unfold s in *; lra).
{ intros u Hu. apply continuity_pt_plus; [apply end_sine_continuous; lra|apply continuity_pt_const; now intros ? ?]. }
destruct (Ranalysis5.IVT_interv (fun u => - sine u - s/2) us u1) as [u [Hu Eu]]; try (unfold s in *; lra).
{ intros x Hx. apply continuity_pt_minus; [apply continuity_pt_opp, end_sine_continuous; lra|apply continuity_pt_const; now intros ? ?]. }
exists u, v. assert (D : u <> u1) by (intros ->; unfold s in *; lra). unfold s in *. repeat split; lra.
Qed.
(** Where I < 1, two motions with different c in (-b, 0) have the same defect, which is larger than pi/2. *)
Theorem same_defect_twice : I < 1 -> exists c d, -b < c /\ c < d /\ d < 0 /\ epsilon a b c = epsilon a b d /\ PI/2 < epsilon a b c.
Proof.
intros H. destruct (end_sine_twice H) as [u [v [Hu [L [Hv [E N]]]]]]. exists (- b * v), (- b * u).
assert (B : forall x, - (- b * x) / b = x) by (intros; field; lra).
assert (0 < b * u) by (apply Rmult_lt_0_compat; lra). assert (b * u < b * v) by (apply Rmult_lt_compat_l; lra). assert (b * v < b) by nra.
split; [lra|]. split; [lra|]. split; [lra|]. rewrite !epsilon_by_end_sine, !B, E. split; trivial. rewrite <- E.
assert (A := asin_order (sine u) 0 (proj1 (end_sine_bounds a b u ltac:(lra))) N ltac:(lra)). rewrite asin_0 in A. lra.
Qed.

(** Theorem 3 for the oscillating motions: epsilon is injective on (-b, 0) if and only if I >= 1. *)
Theorem theorem_3_oscillating :
  (forall c d, -b < c < 0 -> -b < d < 0 -> epsilon a b c = epsilon a b d -> c = d) <-> 1 <= I.
Proof.
split.
- intros H. apply Rnot_lt_le. intros L. destruct (same_defect_twice L) as [c [d [Hc [O [Hd [E _]]]]]].
  assert (c = d) by (apply H; trivial; lra). lra.
- intros H c d Hc Hd E. destruct (Rtotal_order c d) as [L|[L|L]]; trivial.
  + assert (D := physical_epsilon_decreases a b Ha Hb c d H (proj1 Hc) L (proj2 Hd)). lra.
  + assert (D := physical_epsilon_decreases a b Ha Hb d c H (proj1 Hd) L (proj2 Hc)). lra.
Qed.
(** Proposition 4 for the oscillating motions: epsilon takes some value twice on (-b, 0) if and only if C passes through (c*, pi/2) there. *)
Theorem proposition_4_oscillating :
  (exists c d, -b < c /\ c < d /\ d < 0 /\ epsilon a b c = epsilon a b d) <-> exists cs, crossing a b cs.
Proof.
rewrite (lemma_3_crossing a b Ha Hb). split.
- intros [c [d [Hc [L [Hd E]]]]]. apply Rnot_le_lt. intros H. assert (D := physical_epsilon_decreases a b Ha Hb c d H Hc L Hd). lra.
- intros H. destruct (same_defect_twice H) as [c [d [Hc [L [Hd [E _]]]]]]. exists c, d. repeat split; trivial.
Qed.
End NotInjective.
