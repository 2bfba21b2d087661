(** Lemma 2 of the paper, and what it says of the first branch of the curve C: C meets S at a point with 0 < e < pi/2 if and only if I < 2,
    and then once on this branch, at c1 = -b sin^2 e1; the first implicit equation then describes C exactly for c > c1, and C runs into the
    meeting point. For I >= 2 it describes C for all c in (-b,a), and the defect tends to pi/2 as c tends to -b. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Polhode Require HalfPhase Values.
From Polhode Require Import Theorem1 FirstEquation Separatrix FirstEquationEnds DefectFunction.
Open Scope R_scope.

Section MeetingPoint.
Variables a b : R.
Hypothesis Ha : 0 < a.
Hypothesis Hb : 0 < b < 1.

(** (c,e) with c = -b sin^2 e is the first point in which C meets S: half the phase is 2 pi there. *)
Definition meeting_point (e : R) : Prop := 0 < e < PI/2 /\ HalfPhase.G a b (sin e ^2) = 2*PI.

Lemma sin2_between e f : 0 < e -> e < f -> f < PI/2 -> 0 < sin e ^2 < sin f ^2 /\ sin f ^2 < 1.
Proof.
intros He L Hf. assert (P := PI_RGT_0). assert (0 < sin e) by (apply sin_gt_0; lra). assert (sin e < sin f) by (apply sin_increasing_1; lra).
assert (sin f < 1) by (rewrite <- sin_PI2; apply sin_increasing_1; lra). nra.
Qed.

Lemma Cu (x : R) : x = - b * (- x / b).
Proof. field. lra. Qed.

(** Lemma 2 (the case I = 2, where the point is only a limit, left out) *)
Theorem lemma_2 : geometric_constant a b < 2 <-> exists e, meeting_point e /\ forall f, meeting_point f -> f = e.
Proof.
assert (P := PI_RGT_0). assert (V := Values.takes_each_value_once a b Ha Hb (2*PI)). split.
- intros HI. destruct (proj1 V ltac:(nra)) as [u [Hu [E U]]]. destruct (angle_of_u u Hu) as [e [He Ee]]. exists e.
  split. split; trivial. now rewrite Ee. intros f [Hf Ef].
  assert (Z : sin f ^2 = u). { apply U; trivial. destruct (sin2_between (f/2) f); lra. }
  assert (0 < sin f) by (apply sin_gt_0; lra). assert (0 < sin e) by (apply sin_gt_0; lra).
  assert (SE : sin f = sin e) by nra. rewrite <- (asin_sin f), <- (asin_sin e) by lra. now rewrite SE.
- intros [e [[He E] _]]. apply Rnot_le_lt. intros N.
  assert (S := sin2_between (e/2) e ltac:(lra) ltac:(lra) ltac:(lra)).
  assert (D := HalfPhase.G_decreasing a b Ha Hb (sin e ^2) 1 ltac:(lra) ltac:(lra) ltac:(lra)). rewrite G_at_one, E in D by assumption. nra.
Qed.

(** For I < 2: the first equation holds exactly to the right of the meeting point. *)
Theorem first_branch_from_meeting_point e1 c : meeting_point e1 -> - b < c ->
  ((exists e, solution a b c e) <-> - b * sin e1 ^2 < c).
Proof.
intros [H1 E1] Hc. assert (P := PI_RGT_0). unfold solution. rewrite (first_equation_solvable a b Ha Hb c Hc).
assert (S := sin2_between (e1/2) e1 ltac:(lra) ltac:(lra) ltac:(lra)).
assert (B1 : 0 < b * sin e1 ^2) by (apply Rmult_lt_0_compat; lra). split.
- intros [H|H]; [lra|]. destruct (Rle_dec 0 c) as [C0|C0]; [lra|].
  assert (U : 0 < - c/b < 1).
  { split. apply Rdiv_lt_0_compat; lra. apply (Rmult_lt_reg_r b); [lra|]. replace (- c/b*b) with (- c) by (field; lra). lra. }
  apply Rnot_le_lt. intros L. 
  assert (M : sin e1 ^2 <= - c/b). { apply (Rmult_le_reg_r b); [lra|]. replace (- c/b*b) with (- c) by (field; lra). lra. }
  destruct M as [M|M].
  + assert (D := HalfPhase.G_decreasing a b Ha Hb (sin e1 ^2) (- c/b) ltac:(lra) M ltac:(lra)). lra.
  + rewrite <- M in H. lra.
- intros L. destruct (Rle_dec 0 c) as [C0|C0]; [now left|right].
  assert (M : - c/b < sin e1 ^2). { apply (Rmult_lt_reg_r b); [lra|]. replace (- c/b*b) with (- c) by (field; lra). lra. }
  rewrite <- E1. apply HalfPhase.G_decreasing; trivial; try lra. apply Rdiv_lt_0_compat; lra.
Qed.

(** For I >= 2: everywhere. *)
Theorem first_branch_everywhere c : 2 <= geometric_constant a b -> - b < c -> exists e, solution a b c e.
Proof.
intros HI Hc. assert (P := PI_RGT_0). apply (first_equation_solvable a b Ha Hb c Hc).
destruct (Rle_dec 0 c) as [C0|C0]; [now left|right].
assert (U : 0 < - c/b < 1).
{ split. apply Rdiv_lt_0_compat; lra. apply (Rmult_lt_reg_r b); [lra|]. replace (- c/b*b) with (- c) by (field; lra). lra. }
assert (D := HalfPhase.G_decreasing a b Ha Hb (- c/b) 1 ltac:(lra) ltac:(lra) ltac:(lra)). rewrite G_at_one in D by assumption. nra.
Qed.

(** C lies above S, and to the right of a meeting point below its defect. *)
Theorem defect_above_S e c d : 0 < e < PI/2 -> c = - b * sin e ^2 -> solution a b c d -> e < d < PI/2.
Proof. intros He -> [H _]. now apply (regular_oscillating b Hb). Qed.

Theorem defect_below_meeting_point e1 c d : meeting_point e1 -> - b * sin e1 ^2 < c -> solution a b c d -> d < e1.
Proof. intros [H1 E1] Hc [H E]. now apply (proposition_2_from_S a b Ha Hb c d e1). Qed.

(** C runs into the meeting point: the defect tends to e1 as c decreases to c1. *)
Theorem defect_tends_to_meeting_point e1 : meeting_point e1 ->
  filterlim (defect a b) (at_right (- b * sin e1 ^2)) (locally e1).
Proof.
intros M. assert (H1 : 0 < e1 < PI/2) by apply M. apply filterlim_locally. intros d. assert (D := cond_pos d).
set (f := Rmax (e1/2) (e1 - d/2)). assert (F1 := Rmax_l (e1/2) (e1 - d/2)). assert (F2 := Rmax_r (e1/2) (e1 - d/2)). fold f in F1, F2.
assert (F3 : f < e1) by (unfold f; apply Rmax_lub_lt; lra).
assert (S := sin2_between f e1 ltac:(lra) F3 ltac:(lra)).
assert (G0 : 0 < b * sin e1 ^2 - b * sin f ^2). { assert (b * sin f ^2 < b * sin e1 ^2) by (apply Rmult_lt_compat_l; lra). lra. }
exists (mkposreal _ G0). intros c Hc Lc. change (Rabs (c - - b * sin e1 ^2) < b * sin e1 ^2 - b * sin f ^2) in Hc. apply Rabs_def2 in Hc.
change (Rabs (defect a b c - e1) < d).
assert (Bf : 0 < b * sin f ^2) by (apply Rmult_lt_0_compat; lra).
assert (Be : b * sin e1 ^2 < b) by (rewrite <- (Rmult_1_r b) at 2; apply Rmult_lt_compat_l; lra).
assert (U : 0 < - c/b < 1).
{ split. apply Rdiv_lt_0_compat; lra. apply (Rmult_lt_reg_r b); [lra|]. replace (- c/b*b) with (- c) by (field; lra). lra. }
destruct (proj2 (first_branch_from_meeting_point e1 c M ltac:(lra)) ltac:(lra)) as [x Hx].
rewrite (defect_is_the_solution a b Ha Hb c x Hx).
destruct (angle_of_u _ U) as [e [He Ee]].
assert (A := defect_above_S e c x He ltac:(rewrite Ee; apply Cu) Hx).
assert (B := defect_below_meeting_point e1 c x M ltac:(lra) Hx).
assert (FE : sin f ^2 < sin e ^2). { rewrite Ee. apply (Rmult_lt_reg_r b); [lra|]. replace (- c/b*b) with (- c) by (field; lra). lra. }
assert (f < e).
{ apply Rnot_le_lt. intros [N|N]; [|rewrite N in FE; lra]. assert (N2 := sin2_between e f ltac:(lra) N ltac:(lra)). lra. }
rewrite Rabs_left; lra.
Qed.

(** For I >= 2 the defect tends to pi/2 as c decreases to -b. *)
Theorem defect_tends_to_half_pi : 2 <= geometric_constant a b -> filterlim (defect a b) (at_right (- b)) (locally (PI/2)).
Proof.
intros HI. assert (P := PI_RGT_0). apply filterlim_locally. intros d. assert (D := cond_pos d).
set (f := Rmax (PI/4) (PI/2 - d/2)). assert (F1 := Rmax_l (PI/4) (PI/2 - d/2)). assert (F2 := Rmax_r (PI/4) (PI/2 - d/2)). fold f in F1, F2.
assert (F3 : f < PI/2) by (unfold f; apply Rmax_lub_lt; lra).
assert (S := sin2_between (f/2) f ltac:(lra) ltac:(lra) F3).
assert (Be : b * sin f ^2 < b) by (rewrite <- (Rmult_1_r b) at 2; apply Rmult_lt_compat_l; lra).
assert (G0 : 0 < b - b * sin f ^2) by lra.
exists (mkposreal _ G0). intros c Hc Lc. change (Rabs (c - - b) < b - b * sin f ^2) in Hc. apply Rabs_def2 in Hc.
change (Rabs (defect a b c - PI/2) < d).
assert (Bf : 0 < b * sin f ^2) by (apply Rmult_lt_0_compat; lra).
assert (U : 0 < - c/b < 1).
{ split. apply Rdiv_lt_0_compat; lra. apply (Rmult_lt_reg_r b); [lra|]. replace (- c/b*b) with (- c) by (field; lra). lra. }
destruct (first_branch_everywhere c HI Lc) as [x Hx].
rewrite (defect_is_the_solution a b Ha Hb c x Hx).
destruct (angle_of_u _ U) as [e [He Ee]].
assert (A := defect_above_S e c x He ltac:(rewrite Ee; apply Cu) Hx).
assert (FE : sin f ^2 < sin e ^2). { rewrite Ee. apply (Rmult_lt_reg_r b); [lra|]. replace (- c/b*b) with (- c) by (field; lra). lra. }
assert (f < e).
{ apply Rnot_le_lt. intros [N|N]; [|rewrite N in FE; lra]. assert (N2 := sin2_between e f ltac:(lra) N ltac:(lra)). lra. }
rewrite Rabs_left; lra.
Qed.

(** Theorem 3 where I >= 2: the whole curve is decreasing and injective. *)
Theorem curve_injective_above_2 c d : 2 <= geometric_constant a b -> - b < c -> c < d -> defect a b d < defect a b c.
Proof.
intros HI Hc L. destruct (first_branch_everywhere c HI Hc) as [x Hx]. destruct (first_branch_everywhere d HI ltac:(lra)) as [y Hy].
apply (defect_decreasing a b Ha Hb); trivial.
- now rewrite (defect_is_the_solution a b Ha Hb c x Hx).
- now rewrite (defect_is_the_solution a b Ha Hb d y Hy).
Qed.
End MeetingPoint.
