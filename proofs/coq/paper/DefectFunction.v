(** The twist defect as a function of c where the first implicit equation describes the curve (lemma 1 and proposition 2): it is defined
    for 0 <= c, and for those c in (-b,0) with G(-c/b) > 2 pi; there it is differentiable, with the derivative of equation (24), which is
    negative; so it decreases strictly and is injective. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Polhode Require HalfPhase.
From Polhode Require Import FirstEquation Separatrix FirstEquationEnds.
Open Scope R_scope.

Section DefectFunction.
Variables a b : R.
Hypothesis Ha : 0 < a.
Hypothesis Hb : 0 < b < 1.

(** (c,e) is a point of the curve that the first implicit equation describes. *)
Definition solution (c e : R) : Prop := regular b c e /\ F a b c e = 2*PI.
(** The greatest lower bound of the set of the defects at c, which has one element at most. *)
Definition defect (c : R) : R := real (Glb_Rbar (solution c)).

Theorem defect_is_the_solution c e : solution c e -> defect c = e.
Proof.
intros H. unfold defect. rewrite (is_glb_Rbar_unique (solution c) e). reflexivity. split.
- intros x Hx. simpl. destruct H as [H1 H2], Hx as [H3 H4]. right. now apply (one_defect a b Ha Hb c).
- intros m Hm. exact (Hm e H).
Qed.

Theorem defect_defined c : - b < c -> 0 <= c \/ 2*PI < HalfPhase.G a b (- c / b) -> solution c (defect c).
Proof.
intros Hc H. apply (first_equation_solvable a b Ha Hb c Hc) in H. destruct H as [e He]. now rewrite (defect_is_the_solution c e).
Qed.

Theorem defect_decreasing c d : solution c (defect c) -> solution d (defect d) -> c < d -> defect d < defect c.
Proof. intros [H1 E1] [H2 E2]. now apply (proposition_2 a b Ha Hb). Qed.

Theorem defect_injective c d : solution c (defect c) -> solution d (defect d) -> defect c = defect d -> c = d.
Proof.
intros H1 H2 E. destruct (Rtotal_order c d) as [L|[L|L]]; trivial.
- assert (N := defect_decreasing c d H1 H2 L). lra.
- assert (N := defect_decreasing d c H2 H1 L). lra.
Qed.

Lemma continuity_pt_near f x d : continuity_pt f x -> 0 < d -> exists m, 0 < m /\ forall y, Rabs (y - x) < m -> Rabs (f y - f x) < d.
Proof.
intros C Hd. destruct (C d Hd) as [m [Hm N]]. exists m. split; trivial. intros y Hy.
destruct (Req_dec x y) as [->|Ne]. rewrite Rminus_eq_0, Rabs_R0. exact Hd.
apply N. split; trivial. split; [exact Logic.I|exact Ne].
Qed.

(** Near a solution there are solutions for all c nearby: the function is defined in an open set, and continuous. *)
Lemma solution_nearby c e : solution c e -> forall d, 0 < d -> exists m, 0 < m /\ regular b (c - m) e /\
  forall c', Rabs (c' - c) < m -> exists e', solution c' e' /\ Rabs (e' - e) < d.
Proof.
intros [H E] d Hd. assert (He : e < PI/2) by apply H.
destruct (regular_open_e b c e H) as [r0 [P0 Reg0]].
set (r := Rmin (d/2) (Rmin r0 ((PI/2 - e)/2))).
assert (Q1 := Rmin_l (d/2) (Rmin r0 ((PI/2 - e)/2))). assert (Q2 := Rmin_r (d/2) (Rmin r0 ((PI/2 - e)/2))). fold r in Q1, Q2.
assert (Q3 := Rmin_l r0 ((PI/2 - e)/2)). assert (Q4 := Rmin_r r0 ((PI/2 - e)/2)).
assert (Pr : 0 < r) by (unfold r; repeat apply Rmin_pos; lra).
assert (Reg1 : regular b c (e - r)) by (apply (regular_more_e b c (e - r0)); trivial; lra).
assert (Reg2 : regular b c (e + r)) by (apply (regular_more_e b c e); trivial; lra).
assert (N1 := F_decreasing_e a b Ha Hb c (e - r) e Reg1 ltac:(lra)). assert (N2 := F_decreasing_e a b Ha Hb c e (e + r) H ltac:(lra)).
destruct (continuity_pt_near _ _ (F a b c (e-r) - 2*PI) (F_continuity_c a b Ha Hb c (e - r) Reg1) ltac:(lra)) as [m1 [M1 C1]].
destruct (continuity_pt_near _ _ (2*PI - F a b c (e+r)) (F_continuity_c a b Ha Hb c (e + r) Reg2) ltac:(lra)) as [m2 [M2 C2]].
destruct (regular_open_c b c (e - r) Reg1) as [m3 [M3 Reg3]].
exists (Rmin m1 (Rmin m2 m3)). split; [repeat apply Rmin_pos; lra|].
assert (L1 := Rmin_l m1 (Rmin m2 m3)). assert (L2 := Rmin_r m1 (Rmin m2 m3)). assert (L3 := Rmin_l m2 m3). assert (L4 := Rmin_r m2 m3).
split. { apply (regular_more_e b _ (e - r)); [|lra]. apply (regular_more_c b (c - m3)); trivial; lra. }
intros c' Hc'. specialize (C1 c' ltac:(lra)). specialize (C2 c' ltac:(lra)). apply Rabs_def2 in C1. apply Rabs_def2 in C2. apply Rabs_def2 in Hc'.
assert (Reg : forall f, e - r <= f <= e + r -> regular b c' f).
{ intros f Hf. apply (regular_more_e b c' (e - r)); [|lra]. apply (regular_more_c b (c - m3)); trivial; lra. }
destruct (Ranalysis5.IVT_interv (fun f => 2*PI - F a b c' f) (e - r) (e + r)) as [f [Hf Ef]]; try lra.
- intros f Hf. apply continuity_pt_minus. apply continuity_pt_const; now intros ? ?. apply F_continuity_e, Reg; trivial.
- exists f. split. split; [now apply Reg|lra]. apply Rabs_def1; lra.
Qed.

Lemma k_continuity_2d c t : 0 < c + b * cos t ^2 -> continuity_2d_pt (k a b) c t.
Proof.
intros H. assert (B := bcos2_range b Hb t).
assert (C1 : continuity_2d_pt (fun _ t => b * cos t ^2) c t).
{ apply (continuity_1d_2d_pt_comp (fun s => b * cos s ^2) (fun _ t => t)). 2: apply continuity_2d_pt_id2.
  apply continuity_pt_filterlim, (ex_derive_continuous (fun s => b * cos s ^2)). auto_derive; trivial. }
unfold k, Rdiv. apply continuity_2d_pt_mult.
- apply (continuity_1d_2d_pt_comp (fun s => 1 - s) (fun _ t => b * cos t ^2)); trivial.
  apply continuity_pt_filterlim, (ex_derive_continuous (fun s => 1 - s)). auto_derive; trivial.
- apply continuity_2d_pt_inv.
  + apply (continuity_1d_2d_pt_comp sqrt (fun d s => (a + b * cos s ^2) * (d + b * cos s ^2))).
    { apply continuity_pt_sqrt. apply Rmult_le_pos; lra. }
    apply continuity_2d_pt_mult; apply continuity_2d_pt_plus; trivial. apply continuity_2d_pt_const. apply continuity_2d_pt_id1.
  + apply Rgt_not_eq, sqrt_lt_R0, Rmult_lt_0_compat; lra.
Qed.

(** Equation (24) *)
Theorem equation_24 c e : solution c e ->
  is_derive defect c (- RInt (fun t => k a b c t / (c + b * cos t ^2)) 0 (PI/2 - e) / (2 * k a b c (PI/2 - e))).
Proof.
intros H. destruct H as [Reg E]. assert (He : e < PI/2) by apply Reg.
assert (Ct : 0 < c + b * cos (PI/2 - e) ^2) by (apply Reg; lra).
assert (Kp := k_pos a b Ha Hb c (PI/2 - e) Ct).
set (Fc := - RInt (fun t => k a b c t / (c + b * cos t ^2)) 0 (PI/2 - e)). set (k0 := k a b c (PI/2 - e)) in *.
assert (DF : derivable_pt_lim (fun c => F a b c e) c Fc) by (apply is_derive_Reals, F_derive_c; trivial).
apply is_derive_Reals. intros v Hv.
assert (CQ : continuity_2d_pt (fun q x => q * / (2 * x)) Fc k0).
{ apply continuity_2d_pt_mult. apply continuity_2d_pt_id1. apply continuity_2d_pt_inv; [|lra].
  apply continuity_2d_pt_mult. apply continuity_2d_pt_const. apply continuity_2d_pt_id2. }
destruct (CQ (mkposreal v Hv)) as [d1 D1]. simpl in D1.
destruct (DF d1 (cond_pos d1)) as [d2 D2].
destruct (k_continuity_2d c (PI/2 - e) Ct d1) as [d3 D3]. fold k0 in D3.
assert (P2 := cond_pos d2). assert (P3 := cond_pos d3).
destruct (solution_nearby c e (conj Reg E) d3 P3) as [d4 [P4 [Reg4 D4]]].
assert (DD : 0 < Rmin d2 (Rmin d3 d4)) by (repeat apply Rmin_pos; lra).
assert (L1 := Rmin_l d2 (Rmin d3 d4)). assert (L2 := Rmin_r d2 (Rmin d3 d4)). assert (L3 := Rmin_l d3 d4). assert (L4 := Rmin_r d3 d4).
exists (mkposreal _ DD). simpl. intros s Hs0 Hs.
destruct (D4 (c + s)) as [e' [[Reg' E'] He']]. { replace (c + s - c) with s by ring. lra. }
rewrite (defect_is_the_solution c e (conj Reg E)), (defect_is_the_solution (c+s) e' (conj Reg' E')).
assert (Hs1 := Rabs_def2 s d4 ltac:(lra)).
assert (Rs : regular b (c+s) e) by (apply (regular_more_c b (c - d4)); trivial; lra).
assert (Rm : forall x, Rmin e e' <= x <= Rmax e e' -> regular b (c+s) x).
{ intros x [Hx1 Hx2]. assert (Hx3 : x < PI/2). { apply Rle_lt_trans with (1 := Hx2). apply Rmax_lub_lt; [apply Reg|apply Reg']. }
  unfold Rmin in Hx1. destruct (Rle_dec e e'). apply (regular_more_e b (c+s) e); trivial; lra. apply (regular_more_e b (c+s) e'); trivial; lra. }
destruct (MVT_gen (F a b (c+s)) e e' (fun x => - (2 * k a b (c+s) (PI/2 - x)))) as [x [Hx M]].
{ intros x Hx. apply F_derive_e; trivial. apply Rm; lra. }
{ intros x Hx. apply F_continuity_e; trivial. now apply Rm. }
set (kx := k a b (c+s) (PI/2 - x)) in *.
assert (Rx := Rm x Hx).
assert (Kx : 0 < kx) by (apply (k_pos a b Ha Hb); apply Rx; destruct Rx; lra).
assert (Xe : Rabs ((PI/2 - x) - (PI/2 - e)) < d3).
{ apply Rle_lt_trans with (2 := He'). replace ((PI/2 - x) - (PI/2 - e)) with (e - x) by ring.
  unfold Rmin, Rmax in Hx. destruct (Rle_dec e e'). rewrite Rabs_left1, Rabs_right; lra. rewrite Rabs_right, (Rabs_left (e' - e)); lra. }
assert (K3 := D3 (c+s) (PI/2 - x) ltac:(replace (c + s - c) with s by ring; lra) Xe). fold kx in K3.
assert (Q2 := D2 s Hs0 ltac:(lra)).
assert (Fin := D1 ((F a b (c+s) e - F a b c e)/s) kx Q2 K3).
replace ((e' - e)/s) with ((F a b (c+s) e - F a b c e)/s * / (2 * kx)). exact Fin.
replace (F a b (c+s) e - F a b c e) with (2 * kx * (e' - e)) by lra. field. lra.
Qed.

(** It is negative. *)
Theorem equation_24_negative c e : regular b c e ->
  - RInt (fun t => k a b c t / (c + b * cos t ^2)) 0 (PI/2 - e) / (2 * k a b c (PI/2 - e)) < 0.
Proof.
intros [He H].
assert (Kp := k_pos a b Ha Hb c (PI/2 - e) (H (PI/2 - e) ltac:(lra))).
assert (0 < RInt (fun t => k a b c t / (c + b * cos t ^2)) 0 (PI/2 - e)).
{ apply RInt_gt_0; [lra| |].
  - intros t Ht. apply Rdiv_lt_0_compat. apply (k_pos a b); trivial. apply H; lra. apply H; lra.
  - intros t Ht. assert (P := H t Ht). apply (continuous_mult (k a b c) (fun t => / (c + b * cos t ^2))). now apply k_continuous.
    apply (ex_derive_continuous (fun t => / (c + b * cos t ^2))). auto_derive. simpl in P. lra. }
unfold Rdiv. rewrite Ropp_mult_distr_l_reverse. apply Ropp_lt_gt_0_contravar, Rmult_lt_0_compat; trivial. apply Rinv_0_lt_compat. lra.
Qed.
End DefectFunction.
