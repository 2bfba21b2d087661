(** The equation alpha' = f(alpha) with f continuous, positive and bounded has a solution on the whole line: the inverse of the integral of 1/f. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Polhode Require Import FreeBody Loop.
Open Scope R_scope.

Section Autonomous.
Variable f : R -> R.
Variable B : R.
Hypothesis Hf : forall y, continuous f y.
Hypothesis positive : forall y, 0 < f y.
Hypothesis bounded : forall y, f y <= B.
Let T y := RInt (fun v => / f v) 0 y.

Lemma B_positive : 0 < B.
Proof. assert (P := positive 0). assert (Q := bounded 0). lra. Qed.
Lemma inverse_continuous y : continuous (fun v => / f v) y.
Proof. apply (continuous_comp f Rinv). apply Hf. apply continuous_Rinv. assert (P := positive y). lra. Qed.
Lemma T_derive y : is_derive T y (/ f y).
Proof.
apply (is_derive_RInt (fun v => / f v) T 0). 2: apply inverse_continuous.
exists (mkposreal 1 Rlt_0_1). intros z _. apply (@RInt_correct R_CompleteNormedModule). apply (@ex_RInt_continuous R_CompleteNormedModule). intros v _. apply inverse_continuous.
Qed.
Lemma T_growth y z : y <= z -> (z - y) / B <= T z - T y.
Proof.
intros L. assert (G := growth T (fun v => / f v) (/ B) T_derive). replace ((z - y) / B) with (/ B * (z - y)) by (unfold Rdiv; ring). apply G; trivial.
intros v. apply Rinv_le_contravar. apply positive. apply bounded.
Qed.
Lemma T_onto t : { y | T y = t }.
Proof.
assert (BP := B_positive). set (z := B * (Rabs t)). assert (Z : 0 <= z) by (apply Rmult_le_pos; [lra|apply Rabs_pos]).
assert (T0 : T 0 = 0) by (exact (RInt_point (V:=R_CompleteNormedModule) 0 _)).
assert (U := T_growth 0 z Z). assert (V := T_growth (-z) 0 ltac:(lra)). rewrite T0 in U, V.
replace ((z - 0) / B) with (Rabs t) in U by (unfold z; field; lra). replace ((0 - - z) / B) with (Rabs t) in V by (unfold z; field; lra).
assert (A1 := Rle_abs t). assert (A2 := Rle_abs (- t)). rewrite Rabs_Ropp in A2.
destruct (IVT_gen T (-z) z t) as [y [_ E]].
- intros v. apply continuity_pt_filterlim. apply (ex_derive_continuous T). eexists. apply T_derive.
- rewrite Rmin_left, Rmax_right by lra. lra.
- now exists y.
Qed.
Let al t := proj1_sig (T_onto t).
Lemma T_al t : T (al t) = t.
Proof. unfold al. now destruct (T_onto t). Qed.
Lemma al_lipschitz s t : Rabs (al t - al s) <= B * Rabs (t - s).
Proof.
assert (BP := B_positive).
assert (W : forall s t, al s <= al t -> Rabs (al t - al s) <= B * Rabs (t - s)).
{ intros s' t' L. assert (G := T_growth _ _ L). rewrite !T_al in G. rewrite Rabs_right by lra.
  assert (A := Rle_abs (t' - s')). apply (Rmult_le_reg_r (/ B)). now apply Rinv_0_lt_compat. replace (B * Rabs (t' - s') * / B) with (Rabs (t' - s')) by (field; lra). unfold Rdiv in G. lra. }
destruct (Rle_dec (al s) (al t)) as [L|L]. now apply W.
rewrite Rabs_minus_sym, (Rabs_minus_sym t). apply W. lra.
Qed.
Lemma al_solves t : is_derive al t (f (al t)).
Proof.
assert (BP := B_positive). apply is_derive_Reals. intros e He.
assert (C := proj2 (continuity_pt_filterlim f (al t)) (Hf (al t)) e He). destruct C as [d [Hd C]].
assert (Hd' : 0 < d / B) by (apply Rdiv_lt_0_compat; lra). exists (mkposreal _ Hd'). intros h Hh Lh. simpl in Lh.
destruct (MVT_gen T (al t) (al (t + h)) (fun v => / f v)) as [z [Z E]].
- intros v _. apply T_derive.
- intros v _. apply continuity_pt_filterlim. apply (ex_derive_continuous T). eexists. apply T_derive.
- rewrite !T_al in E. assert (P := positive z).
  assert (Q : (al (t + h) - al t) / h = f z).
  { assert (E' : al (t + h) - al t = f z * h). { replace h with (t + h - t) at 2 by ring. rewrite E. field. lra. } rewrite E'. field. exact Hh. }
  rewrite Q. destruct (Req_dec z (al t)) as [->|N]. { rewrite Rminus_eq_0, Rabs_R0. exact He. }
  apply C. split. { split; [exact I|auto]. } simpl. unfold R_dist.
  assert (L := al_lipschitz t (t + h)). replace (t + h - t) with h in L by ring.
  assert (S : Rabs (z - al t) <= Rabs (al (t + h) - al t)).
  { destruct (Rle_dec (al t) (al (t + h))) as [O|O].
    - rewrite Rmin_left, Rmax_right in Z by lra. rewrite !Rabs_right by lra. lra.
    - rewrite Rmin_right, Rmax_left in Z by lra. rewrite !Rabs_left1 by lra. lra. }
  apply Rle_lt_trans with (1 := S). apply Rle_lt_trans with (1 := L). apply (Rmult_lt_compat_l B) in Lh; trivial. replace (B * (d / B)) with d in Lh by (field; lra). exact Lh.
Qed.
(** alpha' = f(alpha) has a solution. *)
Theorem autonomous_solution : exists al : R -> R, forall t, is_derive al t (f (al t)).
Proof. exists al. apply al_solves. Qed.
End Autonomous.
