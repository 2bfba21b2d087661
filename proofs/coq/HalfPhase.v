(** Appendix A of the paper: half the Montgomery phase of an oscillating body with c = -b u,
      G(u) = (2/sqrt (ab)) integral over y in 0..1 of (1 - b X) / sqrt ((1 - y^2) X (1 + b X/a)),  X = u + (1-u) y^2,
    its derivative, and its sign: G decreases, for all a > 0 and 0 < b < 1. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
Open Scope R_scope.
Section HalfPhase.
Variables a b : R.
Hypothesis Ha : 0 < a.
Hypothesis Hb : 0 < b < 1.
Definition X (u y : R) := u + (1 - u) * y^2.
Definition Q (x : R) := x * (1 + b * x / a).

Lemma X_pos u y : 0 < u <= 1 -> 0 <= y <= 1 -> 0 < X u y.
Proof. intros Hu Hy. unfold X. assert (0 <= (1-u)*y^2) by (apply Rmult_le_pos; [lra|apply pow2_ge_0]). lra. Qed.

Lemma Q_pos x : 0 < x -> 0 < Q x.
Proof. intros Hx. unfold Q. assert (0 < b*x/a) by (apply Rdiv_lt_0_compat; nra). nra. Qed.

(** The kernel in one variable: d/dx (1-bx)/sqrt(Q x) = -(a+(a+2)bx)/(2 a Q^(3/2)) *)
Definition h (x : R) := (1 - b * x) / sqrt (Q x).
Definition dh (x : R) := - (a + (a + 2) * b * x) / (2 * a * (Q x * sqrt (Q x))).

Lemma h_derive x : 0 < x -> is_derive h x (dh x).
Proof.
intros Hx. assert (HQ := Q_pos x Hx). assert (Hs : 0 < sqrt (Q x)) by now apply sqrt_lt_R0.
unfold h. unfold Q in *. auto_derive.
- split; [exact HQ|split; [apply Rgt_not_eq; exact Hs|trivial]].
- unfold dh. change (x * (1 + b * x * / a)) with (Q x) in *. change (x * (1 + b * x / a)) with (Q x) in *.
  replace (1 * (1 + b * x * / a) + x * (b * 1 * / a)) with (1 + 2 * b * x / a) by (field; lra).
  set (s := sqrt (Q x)) in *.
  assert (Es : Q x = s * s) by (unfold s; rewrite sqrt_sqrt; lra).
  rewrite Es. 
  assert (E2 : s * s = x * (1 + b * x / a)) by (rewrite <- Es; reflexivity).
  apply Rminus_diag_uniq.
  replace (_ - _) with ((- b * (s*s) - (1 - b*x) * (1 + 2*b*x/a) / 2 + (a + (a+2)*b*x)/(2*a)) / (s*s*s)) by (field; lra).
  rewrite E2 at 1. replace (_ + _) with 0 by (field; lra). unfold Rdiv; ring.
Qed.

Lemma dh_negative x : 0 < x -> dh x < 0.
Proof.
intros Hx. unfold dh. assert (HQ := Q_pos x Hx). assert (Hs : 0 < sqrt (Q x)) by now apply sqrt_lt_R0.
assert (0 < (a+2)*b*x) by (repeat apply Rmult_lt_0_compat; lra). assert (0 < a + (a+2)*b*x) by lra.
unfold Rdiv. rewrite Ropp_mult_distr_l_reverse. apply Ropp_lt_gt_0_contravar, Rmult_lt_0_compat; trivial.
apply Rinv_0_lt_compat. repeat first [assumption | apply Rmult_lt_0_compat]; lra.
Qed.

(** In the variable y of the paper. *)
Definition f (u y : R) := (1 - b * X u y) / sqrt ((1 - y^2) * X u y * (1 + b * X u y / a)).
Lemma f_derive u y : 0 < u <= 1 -> 0 <= y < 1 ->
  is_derive (fun u => f u y) u
   (- / (2*a) * sqrt (1 - y^2) * (a + (a+2)*b*X u y) / (X u y * (1 + b * X u y / a) * sqrt (X u y * (1 + b * X u y / a)))).
Proof.
intros Hu Hy. assert (HX := X_pos u y Hu ltac:(lra)).
assert (Hy1 : 0 < 1 - y^2) by nra.
assert (Hsy : 0 < sqrt (1 - y^2)) by now apply sqrt_lt_R0.
assert (HQ := Q_pos (X u y) HX). assert (Hs : 0 < sqrt (Q (X u y))) by now apply sqrt_lt_R0.
apply (is_derive_ext_loc (fun u => / sqrt (1-y^2) * h (X u y))).
{ unfold f, h, Q. apply (filter_imp (fun v => 0 < X v y)).
  - intros v Hv. rewrite (Rmult_assoc (1-y^2)), (sqrt_mult_alt (1-y^2)) by lra. 
    assert (Hsv : 0 < sqrt (Q (X v y))) by now apply sqrt_lt_R0, Q_pos. unfold Q in Hsv. match goal with |- @eq _ ?l ?r => change (@eq R l r) end. field. lra.
  - assert (CX : continuous (fun v => X v y) u).
    { apply (ex_derive_continuous (fun v => X v y)). unfold X. auto_derive; trivial. }
    apply CX. now apply (open_gt 0). }
evar_last.
apply (is_derive_scal (fun v => h (X v y))).
apply (is_derive_comp h (fun v => X v y)). now apply h_derive.
instantiate (1 := 1 - y^2). unfold X. auto_derive; trivial. ring.
unfold scal; simpl; unfold mult; simpl. unfold dh. fold (Q (X u y)).
change (y * (y * 1)) with (y^2). 
replace (1 - y^2) with (sqrt (1-y^2) * sqrt (1-y^2)) at 2 by (apply sqrt_sqrt; lra).
field. repeat split; lra.
Qed.

Lemma f_derive_negative u y : 0 < u <= 1 -> 0 <= y < 1 ->
   (- / (2*a) * sqrt (1 - y^2) * (a + (a+2)*b*X u y) / (X u y * (1 + b * X u y / a) * sqrt (X u y * (1 + b * X u y / a)))) < 0.
Proof.
intros Hu Hy. assert (HX := X_pos u y Hu ltac:(lra)).
assert (Hsy : 0 < sqrt (1 - y^2)) by (apply sqrt_lt_R0; nra).
assert (HQ := Q_pos (X u y) HX). assert (Hs : 0 < sqrt (Q (X u y))) by now apply sqrt_lt_R0.
unfold Q in *. 
assert (0 < (a+2)*b*X u y) by (repeat apply Rmult_lt_0_compat; lra). assert (0 < a + (a+2)*b*X u y) by lra. assert (0 < /(2*a)) by (apply Rinv_0_lt_compat; lra).
unfold Rdiv. rewrite !Ropp_mult_distr_l_reverse. apply Ropp_lt_gt_0_contravar.
repeat apply Rmult_lt_0_compat; trivial. apply Rinv_0_lt_compat, Rmult_lt_0_compat; trivial.
Qed.

(** The half phase, after y = sin t, which removes the singularity at the end. *)
Definition G (u : R) : R := 2 / sqrt (a*b) * RInt (fun t => h (X u (sin t))) 0 (PI/2).

Lemma sin01 t : Rmin 0 (PI/2) <= t <= Rmax 0 (PI/2) -> 0 <= sin t <= 1.
Proof.
assert (HPI := PI_RGT_0). rewrite Rmin_left, Rmax_right by lra. intros Ht. split; [|apply SIN_bound].
apply sin_ge_0; lra.
Qed.

Lemma X_pos_any u t : 0 < u -> u < 2 -> 0 < X u (sin t).
Proof.
intros Hu Hu2. unfold X. assert (H := sin2_cos2 t). unfold Rsqr in H.
assert (0 <= sin t ^2) by apply pow2_ge_0. assert (sin t ^2 <= 1) by nra. nra.
Qed.

Lemma X_continuous u t : continuous (fun t => X u (sin t)) t.
Proof. apply (ex_derive_continuous (fun t => X u (sin t))). unfold X. auto_derive; trivial. Qed.

Lemma h_continuous x : 0 < x -> continuous h x.
Proof. intros Hx. apply (ex_derive_continuous h). eexists. now apply h_derive. Qed.

Lemma G_decreasing u v : 0 < u -> u < v -> v <= 1 -> G v < G u.
Proof.
intros Hu Huv Hv. assert (HPI := PI_RGT_0). unfold G.
apply Rmult_lt_compat_l. { apply Rdiv_lt_0_compat; [lra|]. apply sqrt_lt_R0; nra. }
assert (C : forall w, u <= w <= 1 -> forall t, continuous (fun t => h (X w (sin t))) t).
{ intros w Hw t. apply (continuous_comp (fun t => X w (sin t)) h). apply X_continuous. apply h_continuous, X_pos_any; lra. }
apply RInt_lt; try lra.
- intros t _; apply C; lra.
- intros t _; apply C; lra.
- intros t Ht. 
  assert (Ht1 : 0 <= sin t < 1). { split. apply sin_ge_0; lra. rewrite <- sin_PI2. apply sin_increasing_1; lra. }
  assert (HXX : X u (sin t) < X v (sin t)). { unfold X. assert (sin t ^2 < 1) by nra. nra. }
  assert (HX0 := X_pos_any u t ltac:(lra) ltac:(lra)).
  destruct (MVT_gen h (X u (sin t)) (X v (sin t)) dh) as [c [Hc E]].
  + rewrite Rmin_left, Rmax_right by lra. intros x Hx. apply h_derive. lra.
  + rewrite Rmin_left, Rmax_right by lra. intros x Hx. apply continuity_pt_filterlim, h_continuous. lra.
  + rewrite Rmin_left, Rmax_right in Hc by lra. assert (N := dh_negative c ltac:(lra)). nra.
Qed.

(** The derivative under the integral sign. *)
Lemma dh_continuous x : 0 < x -> continuous dh x.
Proof.
intros Hx. assert (HQ := Q_pos x Hx). assert (Hs : 0 < sqrt (Q x)) by now apply sqrt_lt_R0.
apply (ex_derive_continuous dh). unfold dh, Q in *. auto_derive. unfold Rdiv in *.
split; [exact HQ|split; [|trivial]]. 
apply Rgt_not_eq. repeat first [assumption | apply Rmult_lt_0_compat]; lra.
Qed.

Lemma G_derive u : 0 < u -> u < 2 ->
  is_derive G u (2 / sqrt (a*b) * RInt (fun t => (1 - sin t ^2) * dh (X u (sin t))) 0 (PI/2)).
Proof.
intros Hu Hu2. unfold G. apply is_derive_scal.
assert (D : forall v t, 0 < v -> v < 2 -> is_derive (fun u => h (X u (sin t))) v ((1 - sin t ^2) * dh (X v (sin t)))).
{ intros v t Hv Hv2. apply (is_derive_comp h (fun v => X v (sin t))).
  - now apply h_derive, X_pos_any.
  - unfold X. auto_derive; trivial. ring. }
assert (Loc : locally u (fun v => 0 < v /\ v < 2)).
{ apply filter_and. now apply (open_gt 0). now apply (open_lt 2). }
evar_last.
apply is_derive_RInt_param.
- revert Loc. apply filter_imp. intros v [H1 H2] t _. eexists. now apply D.
- intros t _. apply (continuity_2d_pt_ext_loc (fun v t => (1 - sin t ^2) * dh (X v (sin t)))).
  + destruct Loc as [e He]. exists e. intros v s Hv _. symmetry. apply is_derive_unique. apply D; now apply He.
  + apply continuity_2d_pt_filterlim.
    apply (continuous_mult (fun z : R*R => 1 - sin (snd z) ^2) (fun z : R*R => dh (X (fst z) (sin (snd z)))) (u,t)).
    * apply (continuous_comp (fun z : R*R => snd z) (fun s => 1 - sin s ^2)). apply continuous_snd.
      apply (ex_derive_continuous (fun s => 1 - sin s ^2)). auto_derive; trivial.
    * apply (continuous_comp (fun z : R*R => X (fst z) (sin (snd z))) dh).
      2: now apply dh_continuous, X_pos_any.
      unfold X. 
      apply (continuous_plus (fun z : R*R => fst z) (fun z : R*R => (1 - fst z) * sin (snd z) ^2)). apply continuous_fst.
      apply (continuous_mult (fun z : R*R => 1 - fst z) (fun z : R*R => sin (snd z) ^2)).
      apply (continuous_comp (fun z : R*R => fst z) (fun s => 1 - s)). apply continuous_fst.
      apply (ex_derive_continuous (fun s => 1 - s)). auto_derive; trivial.
      apply (continuous_comp (fun z : R*R => snd z) (fun s => sin s ^2)). apply continuous_snd.
      apply (ex_derive_continuous (fun s => sin s ^2)). auto_derive; trivial.
- revert Loc. apply filter_imp. intros v [H1 H2]. apply (@ex_RInt_continuous R_CompleteNormedModule).
  intros t _. apply (continuous_comp (fun t => X v (sin t)) h). apply X_continuous. now apply h_continuous, X_pos_any.
- apply RInt_ext. intros t _. apply is_derive_unique. now apply D.
Qed.

Lemma G_derive_negative u : 0 < u <= 1 ->
  2 / sqrt (a*b) * RInt (fun t => (1 - sin t ^2) * dh (X u (sin t))) 0 (PI/2) < 0.
Proof.
intros Hu. assert (HPI := PI_RGT_0).
assert (0 < 2 / sqrt (a*b)). { apply Rdiv_lt_0_compat; [lra|]. apply sqrt_lt_R0; nra. }
assert (C : forall t, continuous (fun t => (1 - sin t ^2) * dh (X u (sin t))) t).
{ intros t. apply (continuous_mult (fun t => 1 - sin t ^2) (fun t => dh (X u (sin t)))).
  apply (ex_derive_continuous (fun t => 1 - sin t ^2)). auto_derive; trivial.
  apply (continuous_comp (fun t => X u (sin t)) dh). apply X_continuous. apply dh_continuous, X_pos_any; lra. }
assert (RInt (fun t => (1 - sin t ^2) * dh (X u (sin t))) 0 (PI/2) < RInt (fun t => 0) 0 (PI/2)).
{ apply RInt_lt; try lra.
  - intros t _. apply continuous_const.
  - intros t _. apply C.
  - intros t Ht. 
    assert (Ht1 : 0 <= sin t < 1). { split. apply sin_ge_0; lra. rewrite <- sin_PI2. apply sin_increasing_1; lra. }
    assert (N := dh_negative (X u (sin t)) (X_pos_any u t ltac:(lra) ltac:(lra))). 
    assert (0 < 1 - sin t ^2) by nra. nra. }
rewrite RInt_const in H0. unfold scal in H0; simpl in H0; unfold mult in H0; simpl in H0. 
rewrite Rmult_0_r in H0. simpl. nra.
Qed.
End HalfPhase.
