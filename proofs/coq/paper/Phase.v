(** The oscillating motions, -b < c < 0, c = -b u: the smooth kernel dphi/dt of the swing angle t, its integral
    P, and P(pi/2) - P(-pi/2) = G(u): equations (10) to (14) without a limit at a turning point. *)
Require Import Reals Lra Psatz Ratan.
From Coquelicot Require Import Coquelicot.
From Polhode Require Import HalfPhase.
Open Scope R_scope.

Lemma asin_continuous_1 : continuity_pt asin 1.
Proof.
intros e He. assert (HPI := PI_RGT_0). set (e' := Rmin (e/2) (PI/2)).
assert (E0 : 0 < e') by (apply Rmin_pos; lra). assert (E1 := Rmin_l (e/2) (PI/2)). assert (E2 := Rmin_r (e/2) (PI/2)). fold e' in E1, E2.
assert (S : sin (PI/2 - e') < 1). { rewrite <- sin_PI2. apply sin_increasing_1; lra. }
exists (1 - sin (PI/2 - e')). split; [lra|]. intros x [_ Hx]. simpl in *. unfold R_dist in *.
rewrite asin_1. destruct (asin_bound x) as [B1 B2].
assert (L : PI/2 - e' < asin x).
{ apply Rnot_le_lt. intros L. apply Rabs_def2 in Hx.
  destruct (Rle_dec 1 x) as [D|D].
  - assert (asin x = PI/2). { destruct (Rle_lt_or_eq_dec 1 x D) as [D'|<-]; [|apply asin_1]. unfold asin. destruct (Rle_dec x (-1)); [lra|]. destruct (Rle_dec 1 x); lra. } lra.
  - assert (SB := SIN_bound (PI/2 - e')). assert (sin (asin x) <= sin (PI/2 - e')) by (apply sin_incr_1; lra). rewrite sin_asin in H by lra. lra. }
rewrite Rabs_left1; lra.
Qed.
Lemma asin_continuous_m1 : continuity_pt asin (-1).
Proof.
intros e He. destruct (asin_continuous_1 e He) as [d [Hd C]]. exists d. split; trivial. intros x [[_ N] Hx]. simpl in *. unfold R_dist in *.
assert (H : Rabs (asin (-x) - asin 1) < e).
{ apply C. split; [split; [exact I | intros Q; apply N; lra]|]. rewrite <- Rabs_Ropp. replace (- (- x - 1)) with (x - -1) by ring. exact Hx. }
rewrite asin_opp in H. replace (asin (-1)) with (- asin 1) by (rewrite <- asin_opp; reflexivity). rewrite <- Rabs_Ropp. replace (- (asin x - - asin 1)) with (- asin x - asin 1) by ring. exact H.
Qed.

Section Phase.
Variables a b u : R.
Hypothesis Ha : 0 < a.
Hypothesis Hb : 0 < b < 1.
Hypothesis Hu : 0 < u < 1.
Definition r := sqrt (1 - u).
Definition kernel (s : R) := h a b (X u (cos s)) / sqrt (a*b).
Definition P (t : R) := RInt kernel 0 t.
Lemma X_cos_pos s : 0 < X u (cos s).
Proof. unfold X. assert (0 <= (1-u) * cos s ^2) by (apply Rmult_le_pos; [lra|apply pow2_ge_0]). lra. Qed.
Lemma kernel_continuous s : continuous kernel s.
Proof.
unfold kernel. apply (continuous_mult (fun s => h a b (X u (cos s))) (fun _ => / sqrt (a*b))). 2: apply continuous_const.
apply (continuous_comp (fun s => X u (cos s)) (h a b)).
- apply (ex_derive_continuous (fun s => X u (cos s))). unfold X. auto_derive; trivial.
- apply h_continuous; try assumption. apply X_cos_pos.
Qed.
Lemma P_derive t : is_derive P t (kernel t).
Proof.
apply (is_derive_RInt kernel P 0). 2: apply kernel_continuous.
exists (mkposreal 1 Rlt_0_1). intros y _. apply (@RInt_correct R_CompleteNormedModule). apply (@ex_RInt_continuous R_CompleteNormedModule). intros z _. apply kernel_continuous.
Qed.
Lemma kernel_integrable x y : ex_RInt kernel x y.
Proof. apply (@ex_RInt_continuous R_CompleteNormedModule). intros z _. apply kernel_continuous. Qed.
(** A whole swing is G. *)
Lemma P_swing : P (PI/2) - P (-(PI/2)) = G a b u.
Proof.
assert (S1 : 0 < sqrt (a*b)) by (apply sqrt_lt_R0, Rmult_lt_0_compat; lra).
assert (O : P (-(PI/2)) = - P (PI/2)).
{ unfold P.
  assert (E : RInt (fun y => opp (kernel (- y))) 0 (PI/2) = RInt kernel (-0) (-(PI/2))).
  { apply is_RInt_unique, (is_RInt_comp_opp kernel 0 (PI/2)), (@RInt_correct R_CompleteNormedModule), kernel_integrable. }
  rewrite Ropp_0 in E. rewrite <- E. 
  assert (E2 : RInt (fun y => opp (kernel (-y))) 0 (PI/2) = opp (RInt kernel 0 (PI/2))).
  { rewrite <- (RInt_opp (V:=R_CompleteNormedModule)) by apply kernel_integrable. apply RInt_ext. intros t _. f_equal. unfold kernel. rewrite cos_neg. reflexivity. }
  exact E2. }
rewrite O. unfold P, G, kernel.
assert (R1 : RInt (fun s => h a b (X u (cos s)) / sqrt (a*b)) 0 (PI/2) = / sqrt (a*b) * RInt (fun s => h a b (X u (cos s))) 0 (PI/2)).
{ assert (E : RInt (fun s => scal (/ sqrt (a*b)) (h a b (X u (cos s)))) 0 (PI/2) = scal (/ sqrt (a*b)) (RInt (fun s => h a b (X u (cos s))) 0 (PI/2))).
  { apply (RInt_scal (V:=R_CompleteNormedModule)). apply (@ex_RInt_continuous R_CompleteNormedModule). intros s _.
    apply (continuous_comp (fun s => X u (cos s)) (h a b)). apply (ex_derive_continuous (fun s => X u (cos s))). unfold X. auto_derive; trivial.
    apply h_continuous; try assumption. apply X_cos_pos. }
  unfold scal in E; simpl in E; unfold mult in E; simpl in E. rewrite <- E. apply RInt_ext. intros s _. unfold Rdiv. apply Rmult_comm. }
rewrite R1.
assert (R2 : RInt (fun s => h a b (X u (cos s))) 0 (PI/2) = RInt (fun t => h a b (X u (sin t))) 0 (PI/2)).
{ assert (E : RInt (fun y => scal (-1) (h a b (X u (sin (-1 * y + PI/2))))) 0 (PI/2) = RInt (fun t => h a b (X u (sin t))) (-1*0 + PI/2) (-1*(PI/2) + PI/2)).
  { apply (RInt_comp_lin (V:=R_CompleteNormedModule) (fun t => h a b (X u (sin t))) (-1) (PI/2) 0 (PI/2)).
    apply (@ex_RInt_continuous R_CompleteNormedModule). intros t _. apply (continuous_comp (fun t => X u (sin t)) (h a b)). apply X_continuous.
    apply h_continuous; try assumption. apply X_pos_any; lra. }
  replace (-1*0 + PI/2) with (PI/2) in E by ring. replace (-1*(PI/2) + PI/2) with 0 in E by field.
  rewrite <- (opp_RInt_swap (V:=R_CompleteNormedModule) (fun t => h a b (X u (sin t))) 0 (PI/2)) in E.
  2:{ apply (@ex_RInt_continuous R_CompleteNormedModule). intros t _. apply (continuous_comp (fun t => X u (sin t)) (h a b)). apply X_continuous.
      apply h_continuous; try assumption. apply X_pos_any; lra. }
  rewrite (RInt_ext _ (fun y => opp (h a b (X u (cos y))))) in E.
  2:{ intros y _. unfold scal, opp; simpl; unfold mult; simpl. replace (-1*y + PI/2) with (PI/2 - y) by ring. rewrite sin_shift. ring. }
  rewrite (RInt_opp (V:=R_CompleteNormedModule)) in E.
  2:{ apply (@ex_RInt_continuous R_CompleteNormedModule). intros s _. apply (continuous_comp (fun s => X u (cos s)) (h a b)). apply (ex_derive_continuous (fun s => X u (cos s))). unfold X. auto_derive; trivial. apply h_continuous; try assumption. apply X_cos_pos. }
  unfold opp in E; simpl in E. apply Ropp_eq_compat in E. rewrite !Ropp_involutive in E. exact E. }
rewrite R2. match goal with |- @eq _ ?l ?r => change (@eq R l r) end. field. lra.
Qed.
End Phase.
