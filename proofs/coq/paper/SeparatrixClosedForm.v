(** The integral of the first implicit equation on the separatrix in elementary functions: with u = sin^2 e and w = sqrt ((1-u)/(a+bu)),
      F(0,e) = (2/sqrt (ab)) artanh (sqrt a w) - 2 arctan (sqrt b w);
    so the defect on the separatrix, equation (25) of the paper, is the root of an elementary equation. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Polhode Require Import FirstEquation Separatrix.
Open Scope R_scope.

Definition artanh (y : R) : R := (ln (1 + y) - ln (1 - y)) / 2.

Section ClosedForm.
Variables a b : R.
Hypothesis Ha : 0 < a.
Hypothesis Hb : 0 < b < 1.

Definition w (t : R) : R := sin t / sqrt (a + b * cos t ^2).
Definition primitive (y : R) : R := / sqrt (a*b) * artanh (sqrt a * y) - atan (sqrt b * y).

Lemma radicand_positive t : 0 < a + b * cos t ^2.
Proof. assert (B := bcos2_range b Hb t). lra. Qed.

Lemma w_derive t : is_derive w t ((a + b) * cos t / (sqrt (a + b * cos t ^2) * (a + b * cos t ^2))).
Proof.
assert (P := radicand_positive t). unfold w. auto_derive.
- simpl in *. repeat split; trivial. apply Rgt_not_eq, sqrt_lt_R0, P.
- replace (a + b * (cos t * (cos t * 1))) with (a + b * cos t ^2) by ring.
  assert (S := sqrt_lt_R0 _ P). assert (Q := sqrt_sqrt _ (Rlt_le _ _ P)).
  set (s := sqrt (a + b * cos t ^2)) in *. rewrite <- Q. 
  assert (E := sin2_cos2 t). unfold Rsqr in E. set (x := cos t) in *. set (y := sin t) in *.
  apply Rminus_diag_uniq.
  match goal with |- ?l = 0 => replace l with (x / (s*s*s) * (s*s + b*(y*y) - (a+b))) by (field; lra) end.
  rewrite Q. replace (y*y) with (1 - x*x) by lra. ring.
Qed.

Lemma w_square t : a * w t ^2 = 1 - (a+b) * cos t ^2 / (a + b * cos t ^2) /\ 1 + b * w t ^2 = (a+b) / (a + b * cos t ^2).
Proof.
assert (P := radicand_positive t). assert (S := sqrt_lt_R0 _ P). assert (Q := sqrt_sqrt _ (Rlt_le _ _ P)).
assert (E := sin2_cos2 t). unfold Rsqr in E.
assert (W : w t ^2 = (1 - cos t ^2) / (a + b * cos t ^2)).
{ unfold w. set (s := sqrt (a + b * cos t ^2)) in *. rewrite <- Q. replace (1 - cos t ^2) with (sin t * sin t) by (simpl; lra). field. lra. }
rewrite W. split; field; lra.
Qed.

Lemma primitive_derive y : a * y^2 < 1 -> is_derive primitive y (/ sqrt b * / (1 - a * y^2) - sqrt b * / (1 + b * y^2)).
Proof.
intros Hy. assert (Sa := sqrt_lt_R0 _ Ha). assert (Sb : 0 < sqrt b) by (apply sqrt_lt_R0; lra).
assert (Qa := sqrt_sqrt a ltac:(lra)). assert (Qb := sqrt_sqrt b ltac:(lra)).
assert (V : Rabs (sqrt a * y) < 1).
{ apply Rsqr_lt_abs_0 || idtac. rewrite <- (Rabs_right 1) by lra. apply Rsqr_lt_abs_0. unfold Rsqr.
  replace (sqrt a * y * (sqrt a * y)) with ((sqrt a * sqrt a) * y^2) by ring. rewrite Qa. lra. }
apply Rabs_def2 in V.
unfold primitive, artanh. auto_derive.
- repeat split; lra.
- rewrite (sqrt_mult_alt a) by lra. 
  assert (0 <= b * y^2) by (apply Rmult_le_pos; [lra|apply pow2_ge_0]).
  unfold Rsqr. set (p := sqrt a) in *. set (q := sqrt b) in *.
  replace (1 - a*y^2) with ((1 + p*y)*(1 - p*y)) by (rewrite <- Qa; ring).
  replace (1 + b*y^2) with (1 + q*y*(q*y)) by (rewrite <- Qb; ring).
  assert (0 < 1 + q*y*(q*y)) by nra. unfold Rminus in *. field. repeat split; lra.
Qed.

Lemma k_separatrix t : 0 < cos t -> k a b 0 t = (1 - b * cos t ^2) / (sqrt b * cos t * sqrt (a + b * cos t ^2)).
Proof.
intros C. assert (P := radicand_positive t). unfold k. f_equal.
replace ((a + b * cos t ^2) * (0 + b * cos t ^2)) with (b * (cos t ^2 * (a + b * cos t ^2))) by ring.
rewrite sqrt_mult_alt by lra. rewrite sqrt_mult_alt by apply pow2_ge_0. rewrite sqrt_pow2 by lra. ring.
Qed.

Lemma closed_form_derive t : 0 < cos t -> is_derive (fun t => primitive (w t)) t (k a b 0 t).
Proof.
intros C. assert (P := radicand_positive t). assert (S := sqrt_lt_R0 _ P). assert (Q := sqrt_sqrt _ (Rlt_le _ _ P)).
assert (Sb : 0 < sqrt b) by (apply sqrt_lt_R0; lra). assert (Qb := sqrt_sqrt b ltac:(lra)).
destruct (w_square t) as [W1 W2].
assert (C2 : 0 < cos t ^2) by nra.
assert (M : 0 < (a+b) * cos t ^2 / (a + b * cos t ^2)) by (apply Rdiv_lt_0_compat; trivial; apply Rmult_lt_0_compat; lra).
evar_last. apply (is_derive_comp primitive w). apply primitive_derive. lra. apply w_derive.
unfold scal; simpl; unfold mult; simpl.
change (w t * (w t * 1)) with (w t ^2). change (cos t * (cos t * 1)) with (cos t ^2).
replace (1 - a * w t ^2) with ((a+b) * cos t ^2 / (a + b * cos t ^2)) by lra. rewrite W2, k_separatrix by trivial.
set (s := sqrt (a + b * cos t ^2)) in *. set (q := sqrt b) in *. set (x := cos t) in *.
assert (E : b = q*q) by lra. match goal with |- @eq _ ?l ?r => change (@eq R l r) end.
transitivity ((/ (q*x) - q*x)/s). { rewrite <- Q. field. repeat split; lra. }
replace (1 - b*x^2) with (1 - q*q*x^2) by (rewrite <- E; ring). field. repeat split; lra.
Qed.

(** The closed form *)
Theorem separatrix_closed_form e : 0 < e < PI/2 ->
  let u := sin e ^2 in let y := sqrt ((1-u)/(a+b*u)) in
  F a b 0 e = 2 / sqrt (a*b) * artanh (sqrt a * y) - 2 * atan (sqrt b * y).
Proof.
intros He u y. assert (P := PI_RGT_0). assert (Sab := sqrt_ab_pos a b Ha Hb).
assert (S : 0 < sin e) by (apply sin_gt_0; lra). assert (C : 0 < cos e) by (apply cos_gt_0; lra).
assert (Y : y = w (PI/2 - e)).
{ unfold y, w. rewrite sin_shift, cos_shift. fold u.
  assert (0 <= b*u) by (apply Rmult_le_pos; [lra|apply pow2_ge_0]).
  rewrite sqrt_div_alt by lra. f_equal. replace (1 - u) with (cos e ^2). apply sqrt_pow2; lra.
  unfold u. generalize (sin2_cos2 e). unfold Rsqr. simpl. lra. }
assert (W : is_RInt (k a b 0) 0 (PI/2 - e) (minus (primitive (w (PI/2 - e))) (primitive (w 0)))).
{ apply (is_RInt_derive (V:=R_CompleteNormedModule) (fun t => primitive (w t))); rewrite Rmin_left, Rmax_right by lra; intros t Ht.
  - apply closed_form_derive. apply cos_gt_0; lra.
  - apply k_continuous; trivial. now apply (regular_separatrix b e). }
unfold F. rewrite (is_RInt_unique _ _ _ _ W), <- Y.
assert (Z : primitive (w 0) = 0).
{ unfold primitive, w, artanh. rewrite sin_0. unfold Rdiv. rewrite !Rmult_0_l, !Rmult_0_r, Rplus_0_r, Rminus_0_r, atan_0, ln_1. ring. }
rewrite Z. unfold primitive, minus, plus, opp; simpl. match goal with |- @eq _ ?l ?r => change (@eq R l r) end. field. lra.
Qed.
End ClosedForm.
