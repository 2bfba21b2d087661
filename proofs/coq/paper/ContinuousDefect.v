(** epsilon (c) is continuous on all of -b < c < a, through the separatrix and through its meetings with S; so for every a > 0, 0 < b < 1. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Polhode Require FirstEquation DefectFunction.
From Polhode Require Import HalfPhase Theorem1 Symmetry Curve DecreasesOscillating NotInjective FirstBranch CentredMotions Theorem3.
Open Scope R_scope.

Section ContinuousDefect.
Variables a b : R.
Hypothesis Ha : 0 < a.
Hypothesis Hb : 0 < b < 1.
Notation solution := (DefectFunction.solution a b).

(** For -b < c < 0 flip_defect is the closed form epsilon. *)
Theorem flip_defect_oscillating c : -b < c < 0 -> flip_defect a b c = epsilon a b c.
Proof. intros Hc. apply (curve_C_epsilon a b Ha Hb c _ Hc). apply flip_defect_on_C; trivial. lra. Qed.
(** From some c0 < 0 up to a it solves the first implicit equation. *)
Theorem flip_defect_solution : exists c0, -b < c0 < 0 /\ forall c, c0 < c < a -> solution c (flip_defect a b c).
Proof.
destruct (near_separatrix a b Ha Hb (- b / 2) ltac:(lra)) as [c0 [H0 G0]]. exists c0. split; [lra|]. intros c Hc.
assert (C := flip_defect_on_C a b Ha Hb c ltac:(lra)). destruct (Rlt_le_dec c 0) as [N|N].
- apply (curve_C_before_meeting a b Ha Hb c _ ltac:(lra)); trivial. apply Rlt_trans with (1 := G0).
  assert (O := u_order b Hb c0 c (proj1 Hc)). destruct (oscillation_of_c b Hb c ltac:(lra)) as [Hu _]. destruct (oscillation_of_c b Hb c0 ltac:(lra)) as [Hv _].
  apply G_decreasing; trivial; lra.
- now apply (curve_C_non_negative a b Ha Hb c).
Qed.
Theorem flip_defect_continuous c : -b < c < a -> continuity_pt (flip_defect a b) c.
Proof.
intros Hc e He. destruct (Rlt_le_dec c 0) as [N|N].
- destruct (epsilon_continuous a b Ha Hb c ltac:(lra) e He) as [m [Hm H]]. exists (Rmin m (Rmin (c + b) (- c))).
  split; [apply Rmin_pos; [exact Hm|apply Rmin_pos; lra]|]. intros x [D L]. simpl in L. unfold R_dist in L.
  assert (L1 := Rlt_le_trans _ _ _ L (Rmin_l _ _)). assert (L2 := Rlt_le_trans _ _ _ L (Rmin_r _ _)).
  assert (L3 := Rlt_le_trans _ _ _ L2 (Rmin_l _ _)). assert (L4 := Rlt_le_trans _ _ _ L2 (Rmin_r _ _)).
  apply Rabs_def2 in L3. apply Rabs_def2 in L4. rewrite (flip_defect_oscillating x), (flip_defect_oscillating c) by lra. apply H. now split.
- destruct flip_defect_solution as [c0 [H0 S]]. destruct (DefectFunction.solution_nearby a b Ha Hb c _ (S c ltac:(lra)) e He) as [m [Hm [_ H]]].
  exists (Rmin m (Rmin (a - c) (- c0))). split; [apply Rmin_pos; [exact Hm|apply Rmin_pos; lra]|]. intros x [_ L]. simpl in *. unfold R_dist in *.
  assert (L1 := Rlt_le_trans _ _ _ L (Rmin_l _ _)). assert (L2 := Rlt_le_trans _ _ _ L (Rmin_r _ _)).
  assert (L3 := Rlt_le_trans _ _ _ L2 (Rmin_l _ _)). assert (L4 := Rlt_le_trans _ _ _ L2 (Rmin_r _ _)).
  apply Rabs_def2 in L3. apply Rabs_def2 in L4. destruct (H x L1) as [e' [[R1 E1] B]].
  destruct (S x ltac:(lra)) as [R2 E2]. now rewrite (FirstEquation.one_defect a b Ha Hb x _ e' R2 R1 E2 E1).
Qed.
End ContinuousDefect.
