(** The paper's "abstract limit" a -> infinity at a fixed b (section 6, remark 2): the perfect twist c0 and the defect on the separatrix e0
    both tend to 0, as does the first point in which C meets S, so that the curve passes through c = e = 0 in the limit and for no body. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Polhode Require Beta HalfPhase MeetingPoint.
From Polhode Require Import GaussIntegral Theorem1 FirstEquation Separatrix Infima.
Open Scope R_scope.

(** For every body c0 < 1/(4a). *)
Theorem perfect_twist_below a b c : 0 < a -> 0 < b < 1 -> perfect_twist a b c -> c < 1/(4*a).
Proof.
intros Ha Hb Hc. assert (P := PI_RGT_0). destruct (perfect_twist_bounds a b c Ha Hb Hc) as [L _]. destruct Hc as [Hc _].
assert (Hcb : 0 < c/b) by (apply Rdiv_lt_0_compat; lra). assert (S := sqrt_lt_R0 _ Hcb).
assert (U : Beta.G (c/b) <= PI/2/sqrt (c/b)).
{ rewrite Beta.G_gauss_integral by trivial. apply gauss_integral_le; try lra. apply sqrt_le_1_alt; lra. }
assert (M : PI * sqrt (a*b) * sqrt (c/b) < PI/2).
{ apply Rlt_le_trans with (Beta.G (c/b) * sqrt (c/b)). now apply Rmult_lt_compat_r.
  apply (Rmult_le_compat_r (sqrt (c/b))) in U; [|lra]. replace (PI/2/sqrt (c/b)*sqrt (c/b)) with (PI/2) in U by (field; lra). exact U. }
rewrite Rmult_assoc, <- sqrt_mult_alt in M by (apply Rmult_le_pos; lra).
replace (a*b*(c/b)) with (a*c) in M by (field; lra).
assert (AC : 0 < a*c) by (apply Rmult_lt_0_compat; lra). assert (Q := sqrt_sqrt _ (Rlt_le _ _ AC)). assert (T := sqrt_lt_R0 _ AC).
assert (T2 : sqrt (a*c) < 1/2) by (apply (Rmult_lt_reg_l PI); lra).
apply (Rmult_lt_reg_r (4*a)); [lra|]. replace (1/(4*a)*(4*a)) with 1 by (field; lra). nra.
Qed.

(** For every body e0 < 2 / (pi sqrt (ab)), by the bound 2 arctan exp (-pi sqrt (ab)). *)
Theorem defect_below a b e : 0 < a -> 0 < b < 1 -> defect_on_separatrix a b e -> e < 2 / (PI * sqrt (a*b)).
Proof.
intros Ha Hb [He E]. assert (P := PI_RGT_0). destruct (defect_on_separatrix_bounds a b Ha Hb e He E) as [_ L].
apply Rlt_le_trans with (1 := L). assert (S := sqrt_ab_pos a b Ha Hb). assert (Y : 0 < PI * sqrt (a*b)) by (apply Rmult_lt_0_compat; lra).
set (y := PI * sqrt (a*b)) in *. unfold Rdiv. apply Rmult_le_compat_l; [lra|].
assert (X : 0 < exp (-y)) by apply exp_pos.
assert (A : atan (exp (-y)) < exp (-y)).
{ destruct (MVT_cor2 (fun x => x - atan x) (fun x => 1 - / (1 + x²)) 0 (exp (-y)) X) as [z [Ez Hz]].
  - intros z _. apply derivable_pt_lim_minus. apply derivable_pt_lim_id. apply is_derive_Reals, is_derive_atan.
  - rewrite atan_0 in Ez. assert (Z : 0 < z²) by (unfold Rsqr; nra).
    assert (/ (1 + z²) < 1). { rewrite <- Rinv_1. apply Rinv_lt_contravar; lra. }
    assert (0 < (1 - / (1 + z²)) * (exp (-y) - 0)) by (apply Rmult_lt_0_compat; lra). lra. }
apply Rle_trans with (exp (-y)); [lra|]. rewrite exp_Ropp. apply Rinv_le_contravar; trivial. assert (D := exp_ineq1 y ltac:(lra)). lra.
Qed.

(** Both tend to 0. *)
Theorem perfect_twist_vanishes b d : 0 < b < 1 -> 0 < d -> exists A, forall a c, A < a -> perfect_twist a b c -> 0 < c < d.
Proof.
intros Hb Hd. assert (D : 0 < 1/d) by (apply Rdiv_lt_0_compat; lra). exists (1/d). intros a c Hac Hc. assert (Ha : 0 < a) by lra.
assert (U := perfect_twist_below a b c Ha Hb Hc). split; [apply Hc|]. apply Rlt_trans with (1 := U).
apply (Rmult_lt_reg_r (4*a)); [lra|]. replace (1/(4*a)*(4*a)) with 1 by (field; lra).
apply (Rmult_lt_compat_r d) in Hac; [|lra]. replace (1/d*d) with 1 in Hac by (field; lra). lra.
Qed.

Theorem defect_vanishes b d : 0 < b < 1 -> 0 < d -> exists A, forall a e, A < a -> defect_on_separatrix a b e -> 0 < e < d.
Proof.
intros Hb Hd. assert (P := PI_RGT_0). assert (P2 := PI2_1). set (m := 2/d). assert (M : 0 < m) by (unfold m; apply Rdiv_lt_0_compat; lra).
exists (m^2/b). intros a e Hae He. 
assert (A0 : 0 < m^2/b) by (apply Rdiv_lt_0_compat; [nra|lra]). assert (Ha : 0 < a) by lra.
assert (U := defect_below a b e Ha Hb He). split; [apply He|]. apply Rlt_trans with (1 := U).
assert (AB : m^2 < a*b). { apply (Rmult_lt_compat_r b) in Hae; [|lra]. replace (m^2/b*b) with (m^2) in Hae by (field; lra). exact Hae. }
assert (S : m < sqrt (a*b)). { rewrite <- (sqrt_pow2 m) by lra. apply sqrt_lt_1_alt. split; [apply pow2_ge_0|trivial]. }
assert (Y : 2 * m < PI * sqrt (a*b)) by (apply Rmult_le_0_lt_compat; lra).
apply (Rmult_lt_reg_r (PI * sqrt (a*b))); [lra|]. replace (2/(PI * sqrt (a*b)) * (PI * sqrt (a*b))) with 2 by (field; split; lra).
apply Rlt_trans with (d * (2*m)). { unfold m. replace (d*(2*(2/d))) with 4 by (field; lra). lra. } apply Rmult_lt_compat_l; lra.
Qed.

(** For every body the first point in which C meets S has sin^2 e1 <= 1/(4ab), and c1 = -b sin^2 e1 >= -1/(4a). *)
Lemma G_upper a b u : 0 < a -> 0 < b < 1 -> 0 < u <= 1 -> HalfPhase.G a b u <= PI / sqrt (a*b*u).
Proof.
intros Ha Hb Hu. assert (P := PI_RGT_0). assert (AB : 0 < a*b) by (apply Rmult_lt_0_compat; lra). assert (S := sqrt_lt_R0 _ AB). assert (U := sqrt_lt_R0 _ (proj1 Hu)).
assert (B : forall t, HalfPhase.h a b (HalfPhase.X u (sin t)) <= / sqrt u).
{ intros t. assert (X1 : u <= HalfPhase.X u (sin t) <= 1).
  { unfold HalfPhase.X. assert (Q := SIN_bound t). assert (0 <= sin t ^2 <= 1) by nra. assert (0 <= (1-u) * sin t ^2) by (apply Rmult_le_pos; lra). nra. }
  set (x := HalfPhase.X u (sin t)) in *. unfold HalfPhase.h, HalfPhase.Q.
  assert (BX : 0 <= b*x < 1) by (split; [apply Rmult_le_pos; lra|nra]). assert (BA : 0 <= b*x/a) by (apply Rmult_le_pos; [lra|left; now apply Rinv_0_lt_compat]).
  assert (R : sqrt u <= sqrt (x * (1 + b*x/a))). { apply sqrt_le_1_alt. assert (0 <= x * (b*x/a)) by (apply Rmult_le_pos; lra). lra. }
  apply Rle_trans with (1 / sqrt (x * (1 + b*x/a))).
  - unfold Rdiv. apply Rmult_le_compat_r; [left; apply Rinv_0_lt_compat; lra|lra].
  - unfold Rdiv. rewrite Rmult_1_l. now apply Rinv_le_contravar. }
unfold HalfPhase.G. apply Rle_trans with (2 / sqrt (a*b) * RInt (fun _ => / sqrt u) 0 (PI/2)).
- apply Rmult_le_compat_l; [left; apply Rdiv_lt_0_compat; lra|]. apply RInt_le; [lra| |apply (ex_RInt_const (V:=R_NormedModule))|intros t _; apply B].
  apply (@ex_RInt_continuous R_CompleteNormedModule). intros t _. apply (continuous_comp (fun t => HalfPhase.X u (sin t)) (HalfPhase.h a b)).
  apply HalfPhase.X_continuous. apply HalfPhase.h_continuous; trivial. apply HalfPhase.X_pos_any; lra.
- rewrite (RInt_const (V:=R_CompleteNormedModule)). unfold scal; simpl; unfold mult; simpl. rewrite (sqrt_mult_alt (a*b)) by lra.
  right. match goal with |- @eq _ ?l ?r => change (@eq R l r) end. field. lra.
Qed.
Theorem first_meeting_below a b e : 0 < a -> 0 < b < 1 -> MeetingPoint.meeting_point a b e -> sin e ^2 <= 1/(4*a*b).
Proof.
intros Ha Hb [He E]. assert (P := PI_RGT_0). assert (Se : 0 < sin e) by (apply sin_gt_0; lra). assert (Ce : 0 < cos e) by (apply cos_gt_0; lra).
assert (Q := sin2_cos2 e). unfold Rsqr in Q. set (u := sin e ^2) in *. assert (U : 0 < u <= 1) by (unfold u; split; [now apply pow_lt|simpl; nra]).
assert (G := G_upper a b u Ha Hb U). rewrite E in G. assert (AB : 0 < a*b*u) by (repeat apply Rmult_lt_0_compat; lra).
assert (S := sqrt_lt_R0 _ AB). assert (S2 := sqrt_sqrt _ (Rlt_le _ _ AB)).
apply (Rmult_le_compat_r (sqrt (a*b*u))) in G; [|lra]. replace (PI / sqrt (a*b*u) * sqrt (a*b*u)) with PI in G by (field; lra).
assert (S1 : sqrt (a*b*u) <= 1/2) by (apply (Rmult_le_reg_l (2*PI)); lra).
assert (AB2 : 0 < 4*a*b) by (repeat apply Rmult_lt_0_compat; lra).
apply (Rmult_le_reg_r (4*a*b)); [lra|]. replace (1/(4*a*b)*(4*a*b)) with 1 by (field; lra). nra.
Qed.
Theorem first_meeting_vanishes b d : 0 < b < 1 -> 0 < d -> exists A, forall a e, A < a -> MeetingPoint.meeting_point a b e -> 0 < sin e ^2 < d /\ - d < - b * sin e ^2 < 0.
Proof.
intros Hb Hd. assert (D : 0 < 1/(b*d)) by (apply Rdiv_lt_0_compat; [lra|apply Rmult_lt_0_compat; lra]). exists (1/(b*d)). intros a e Hae M. assert (Ha : 0 < a) by lra.
assert (U := first_meeting_below a b e Ha Hb M). destruct M as [He _]. assert (Se : 0 < sin e) by (apply sin_gt_0; lra). assert (S2 : 0 < sin e ^2) by now apply pow_lt.
assert (L : 1/(4*a*b) < d).
{ assert (BD : 0 < b*d) by (apply Rmult_lt_0_compat; lra). apply (Rmult_lt_compat_r (b*d)) in Hae; [|lra]. replace (1/(b*d)*(b*d)) with 1 in Hae by (field; lra).
  assert (AB2 : 0 < 4*a*b) by (repeat apply Rmult_lt_0_compat; lra). apply (Rmult_lt_reg_r (4*a*b)); [lra|]. replace (1/(4*a*b)*(4*a*b)) with 1 by (field; lra).
  replace (d*(4*a*b)) with (4*(a*(b*d))) by ring. lra. }
assert (B1 : 0 < b * sin e ^2) by (apply Rmult_lt_0_compat; lra). assert (B2 : b * sin e ^2 < sin e ^2) by nra. split; [lra|]. split; lra.
Qed.
