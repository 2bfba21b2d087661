(** C is tangent to S where they meet: at the first meeting point (c1,e1) of any body with I < 2 the curve C stays above S by no more than
    a multiple of (c - c1)^2. (The paper says so of the limit a -> infinity, where the point is c = e = 0.) *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Polhode Require HalfPhase Values.
From Polhode Require Import Theorem1 FirstEquation Separatrix FirstEquationEnds DefectFunction MeetingPoint.
Open Scope R_scope.

Theorem tangent_at_meeting_point a b e1 : 0 < a -> 0 < b < 1 -> meeting_point a b e1 ->
  exists M m, 0 < M /\ 0 < m /\ forall e x, 0 < e < e1 ->
    let c := - b * sin e ^2 in let c1 := - b * sin e1 ^2 in
    c < c1 + m -> solution a b c x -> e < x < e + M * (c - c1)^2.
Proof.
intros Ha Hb [H1 E1]. assert (P := PI_RGT_0).
set (u1 := sin e1 ^2) in *. set (u0 := sin (e1/2) ^2).
assert (S := sin2_between (e1/2) e1 ltac:(lra) ltac:(lra) ltac:(lra)). fold u1 u0 in S.
assert (DG := HalfPhase.G_derive a b Ha Hb u1 ltac:(lra) ltac:(lra)). apply is_derive_Reals in DG.
match type of DG with derivable_pt_lim _ _ ?l => set (dG := l) in * end.
destruct (DG 1 ltac:(lra)) as [eta N]. assert (Eta := cond_pos eta).
assert (K := Values.m_pos a b Ha Hb). set (kappa := Values.m a b) in *.
assert (A0 := Rabs_pos dG).
set (L := (Rabs dG + 1) / (b * kappa)). assert (L0 : 0 < L). { unfold L. apply Rdiv_lt_0_compat; [lra|]. apply Rmult_lt_0_compat; lra. }
assert (SP : 0 < sin (e1/2)) by (apply sin_gt_0; lra). assert (CP : 0 < cos e1) by (apply cos_gt_0; lra).
set (q := 2 * sin (e1/2) * cos e1). assert (Q : 0 < q) by (unfold q; repeat apply Rmult_lt_0_compat; lra).
assert (LQ : 0 < L^2/q) by (apply Rdiv_lt_0_compat; trivial; nra).
exists (L^2/q + 1), (b * Rmin eta (u1 - u0)). split; [lra|].
assert (M0 : 0 < Rmin eta (u1 - u0)) by (apply Rmin_pos; lra).
split; [apply Rmult_lt_0_compat; lra|]. intros e x He. set (u := sin e ^2). intros c c1 Hc Hx.
assert (He2 : 0 < e < PI/2) by lra.
assert (Se := sin2_between e e1 ltac:(lra) ltac:(lra) ltac:(lra)). fold u u1 in Se.
assert (M1 := Rmin_l eta (u1 - u0)). assert (M2 := Rmin_r eta (u1 - u0)).
assert (Cc : c - c1 = b * (u1 - u)) by (unfold c, c1; fold u1; ring).
assert (Hu : u1 - u < Rmin eta (u1 - u0)) by (apply (Rmult_lt_reg_l b); lra).
assert (Lo : e1/2 < e).
{ apply Rnot_le_lt. intros [Z|Z]; [|unfold u, u0 in *; rewrite Z in *; lra].
  assert (Z2 := sin2_between e (e1/2) ltac:(lra) Z ltac:(lra)). fold u u0 in Z2. lra. }
assert (Ex := defect_above_S a b Hb e c x He2 eq_refl Hx).
assert (Bx := defect_below_meeting_point a b Ha Hb e1 c x (conj H1 E1) ltac:(unfold c; fold u u1; assert (b*u < b*u1) by (apply Rmult_lt_compat_l; lra); lra) Hx).
split; [lra|].
destruct (psi_onto e He2 x Ex) as [s [Hs Es]].
assert (FP := F_psi a b Ha Hb e He2 s Hs). fold u in FP. rewrite Es in FP. replace (PI/2 - (PI/2 - x)) with x in FP by ring.
destruct Hx as [_ Fx]. unfold c in Fx. rewrite Fx in FP.
destruct (MVT_cor2 (Phi a b e) (fun s => - (2 / sqrt (a*b) * h a b (X u (sin s)))) 0 s ltac:(lra)) as [z [Ez Hz]].
{ intros z _. apply is_derive_Reals. apply (Phi_derive a b Ha Hb e He2). }
change (Phi a b e 0) with (HalfPhase.G a b u) in Ez. rewrite <- FP, <- E1 in Ez.
assert (X1 : 0 < X u (sin z) <= 1).
{ split. apply (X_positive e He2). unfold HalfPhase.X. generalize (SIN_bound z). intros. assert (sin z ^2 <= 1) by nra. nra. }
assert (KS : kappa * s <= HalfPhase.G a b u - HalfPhase.G a b u1).
{ assert (HL := Values.h_lower a b Ha Hb _ X1). set (r := (1-b) / sqrt (1 + b/a)) in *.
  assert (R0 : 0 < r). { unfold r. apply Rdiv_lt_0_compat; [lra|]. apply sqrt_lt_R0. assert (0 < b/a) by (apply Rdiv_lt_0_compat; lra). lra. }
  assert (SX : 0 < sqrt (X u (sin z))) by (apply sqrt_lt_R0; lra).
  assert (SX1 : sqrt (X u (sin z)) <= 1) by (rewrite <- sqrt_1; apply sqrt_le_1_alt; lra).
  assert (RL : r <= h a b (X u (sin z))).
  { apply Rle_trans with (2 := HL). unfold Rdiv. rewrite <- (Rmult_1_r r) at 1. apply Rmult_le_compat_l; [lra|]. rewrite <- Rinv_1. apply Rinv_le_contravar; lra. }
  assert (Sab := sqrt_ab_pos a b Ha Hb). assert (T0 : 0 < 2 / sqrt (a*b)) by (apply Rdiv_lt_0_compat; lra).
  assert (KH : kappa <= 2 / sqrt (a*b) * h a b (X u (sin z))) by (unfold kappa, Values.m; fold r; apply Rmult_le_compat_l; lra).
  apply (Rmult_le_compat_r s) in KH; [|lra]. lra. }
assert (GL : HalfPhase.G a b u - HalfPhase.G a b u1 <= (Rabs dG + 1) * (u1 - u)).
{ assert (Y := N (u - u1) ltac:(lra) ltac:(rewrite Rabs_left; lra)). replace (u1 + (u - u1)) with u in Y by ring.
  set (quot := (HalfPhase.G a b u - HalfPhase.G a b u1) / (u - u1)) in *.
  assert (Eq : HalfPhase.G a b u - HalfPhase.G a b u1 = (- quot) * (u1 - u)) by (unfold quot; field; lra).
  rewrite Eq. apply Rmult_le_compat_r; [lra|]. apply Rabs_def2 in Y. assert (Z := Rle_abs (- dG)). rewrite Rabs_Ropp in Z. lra. }
assert (SL : s <= L * (c - c1)).
{ rewrite Cc. replace (L * (b * (u1 - u))) with ((Rabs dG + 1) * (u1 - u) / kappa) by (unfold L; field; lra).
  apply (Rmult_le_reg_l kappa); trivial. replace (kappa * ((Rabs dG + 1) * (u1 - u) / kappa)) with ((Rabs dG + 1) * (u1 - u)) by (field; lra). lra. }
(* sin^2 x - sin^2 e = cos^2 e sin^2 s *)
assert (D1 : sin x ^2 - u <= s^2).
{ assert (C2 := psi_cos2 e He2 s). rewrite Es, cos_shift in C2. unfold HalfPhase.X in C2. fold u in C2. rewrite C2.
  assert (sin s < s) by (apply sin_lt_x; lra). assert (0 < sin s) by (apply sin_gt_0; lra).
  assert (sin s ^2 <= s^2) by nra. assert (0 <= sin s ^2) by apply pow2_ge_0. nra. }
destruct (MVT_cor2 (fun y => sin y ^2) (fun y => 2 * sin y * cos y) e x ltac:(lra)) as [y [Ey Hy]].
{ intros y _. apply is_derive_Reals. auto_derive; trivial. ring. }
fold u in Ey. rewrite Ey in D1.
assert (QY : q <= 2 * sin y * cos y).
{ unfold q. assert (sin (e1/2) <= sin y) by (apply sin_incr_1; lra). assert (cos e1 <= cos y) by (apply cos_decr_1; lra). apply Rmult_le_compat; lra. }
assert (XE : q * (x - e) <= s^2) by (apply Rle_trans with (2 := D1); apply Rmult_le_compat_r; lra).
assert (S2 : s^2 <= L^2 * (c - c1)^2). { rewrite <- Rpow_mult_distr. apply pow_incr. lra. }
assert (CC : 0 < (c - c1)^2). { assert (0 < c - c1) by (rewrite Cc; apply Rmult_lt_0_compat; lra). nra. }
assert (x - e <= L^2/q * (c - c1)^2); [|lra].
apply (Rmult_le_reg_l q); trivial. replace (q * (L^2/q * (c - c1)^2)) with (L^2 * (c - c1)^2) by (field; lra). lra.
Qed.
