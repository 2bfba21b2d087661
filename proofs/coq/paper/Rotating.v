(** The rotating motions, 0 < c < a: the Montgomery phase of every one of them is 2 F(c,0). *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Polhode Require Theorem2.
From Polhode Require Import FreeBody Loop.
Open Scope R_scope.

(** Eq. (16): F(c,0) is half of the integral over any whole turn of psi, as the kernel is even and has the period pi. *)
Lemma turn_of_F a b c : 0 < a -> 0 < b < 1 -> 0 < c ->
  forall y, RInt (fun t => Theorem2.k a b c t) 0 (y + 2*PI) - RInt (fun t => Theorem2.k a b c t) 0 y = 2 * Theorem2.F a b c.
Proof.
intros Ha Hb Hc y. set (k := fun t => Theorem2.k a b c t). set (P := fun t => RInt k 0 t).
assert (D : forall t, is_derive P t (k t)).
{ intros t. apply (is_derive_RInt k P 0). 2: now apply Theorem2.k_continuous.
  exists (mkposreal 1 Rlt_0_1). intros z _. apply (@RInt_correct R_CompleteNormedModule). now apply Theorem2.k_integrable. }
assert (Pe : forall t, k (t + PI) = k t).
{ intros t. unfold k, Theorem2.k, Theorem2.x. rewrite neg_cos. replace ((- cos t)^2) with (cos t ^2) by ring. reflexivity. }
change (P (y + 2*PI) - P y = 2 * Theorem2.F a b c). rewrite (gain_of_turn P k D Pe y (-(PI/2))). replace (-(PI/2) + PI) with (PI/2) by field.
assert (O : forall t, P (- t) = - P t).
{ intros t. assert (E : P (- t) + P t = P (- 0) + P 0).
  { apply (equal_everywhere (fun t => P (- t) + P t)). intros v. evar_last. apply (is_derive_plus (fun t => P (- t)) P v).
    apply (is_derive_comp P (fun t => - t)). apply D. instantiate (1 := -1). auto_derive; trivial; ring. apply D.
    unfold plus, scal; simpl; unfold mult; simpl. replace (k (- v)) with (k v) by (unfold k, Theorem2.k, Theorem2.x; rewrite cos_neg; reflexivity). ring. }
  rewrite Ropp_0 in E. assert (P0 : P 0 = 0) by (exact (RInt_point (V:=R_CompleteNormedModule) 0 k)). lra. }
rewrite O. unfold Theorem2.F. fold k. fold (P (PI/2)). ring.
Qed.

Section Rotating.
Variable moment : axis -> R.
Variables th ps ph : R -> R.
Hypothesis M : motion moment th ps ph.
Notation Iy := (moment y_axis).
Notation a := (par_a moment).
Notation b := (par_b moment).
Notation x t := (cos (ps t) ^ 2).
Notation c := (par_c moment (th 0) (ps 0)).
Hypothesis Hc : 0 < c.

Lemma cos_theta_never_0 t : cos (th t) <> 0.
Proof.
intros E. assert (C := cos_squared moment th ps ph M t). rewrite E in C. destruct (b_range moment th ps ph M) as [B _].
assert (X := x_range ps t). assert (0 <= b * x t) by (apply Rmult_le_pos; lra). lra.
Qed.
Lemma cos_theta_sign : exists k, k * k = 1 /\ forall t, 0 < k * cos (th t).
Proof.
apply (sign_of (fun t => cos (th t))).
- intros t. apply (continuous_comp th cos). apply (ex_derive_continuous th), (th_differentiable _ _ _ _ M). apply continuous_cos.
- apply cos_theta_never_0.
Qed.

Section Sign.
Variable k : R.
Hypothesis Hk : k * k = 1.
Hypothesis Kc : forall t, 0 < k * cos (th t).
Let al t := k * ps t.
Let dal t := k * Derive ps t.
Lemma k_values : k = 1 \/ k = -1.
Proof. assert (E : (k - 1) * (k + 1) = 0) by lra. apply Rmult_integral in E. destruct E; [left|right]; lra. Qed.
Lemma al_derive t : is_derive al t (dal t).
Proof. apply (is_derive_scal ps). apply (ps_derive moment th ps ph M). Qed.
Lemma dal_is_root t : dal t = sqrt ((a + b * x t) * (c + b * x t)) / Iy.
Proof.
unfold dal. rewrite (psi_rate moment th ps ph M), (root_is_cos moment th ps ph M).
replace (Rabs (cos (th t))) with (k * cos (th t)). { unfold Rdiv. ring. }
assert (K := Kc t). destruct k_values as [->| ->]; [rewrite Rabs_right|rewrite Rabs_left]; lra.
Qed.
Lemma dal_bound t : sqrt (a * c) / Iy <= dal t.
Proof.
rewrite dal_is_root. unfold Rdiv. apply Rmult_le_compat_r. { apply Rlt_le, Rinv_0_lt_compat. apply (moments moment th ps ph M). }
apply sqrt_le_1_alt. destruct (b_range moment th ps ph M) as [B _]. assert (A := a_positive moment th ps ph M).
assert (X := x_range ps t). assert (0 <= b * x t) by (apply Rmult_le_pos; lra). apply Rmult_le_compat; lra.
Qed.
Lemma bound_positive : 0 < sqrt (a * c) / Iy.
Proof. apply Rdiv_lt_0_compat. apply sqrt_lt_R0, Rmult_lt_0_compat; trivial. apply (a_positive moment th ps ph M). apply (moments moment th ps ph M). Qed.
Lemma psi_determines s t : same_momentum th ps s t <-> cos (al s) = cos (al t) /\ sin (al s) = sin (al t).
Proof.
rewrite same_momentum_angles by apply (chart _ _ _ _ M).
assert (E : (cos (al s) = cos (al t) /\ sin (al s) = sin (al t)) <-> (cos (ps s) = cos (ps t) /\ sin (ps s) = sin (ps t))).
{ unfold al. destruct k_values as [->| ->]. rewrite !Rmult_1_l. tauto. replace (-1 * ps s) with (- ps s) by ring. replace (-1 * ps t) with (- ps t) by ring.
  rewrite !cos_neg, !sin_neg. split; intros [H1 H2]; split; lra. }
rewrite E. split; [tauto|]. intros [H1 H2]. split; [|tauto].
assert (Cs := cos_squared moment th ps ph M s). assert (Ct := cos_squared moment th ps ph M t). rewrite H1 in Cs. rewrite <- Ct in Cs.
apply Rmult_eq_reg_l in Cs. 2:{ apply Rgt_not_eq, (denominator_positive moment th ps ph M). }
assert (Ks := Kc s). assert (Kt := Kc t). destruct k_values as [Q|Q]; rewrite Q in Ks, Kt; simpl in Cs; nra.
Qed.
Lemma phi_by_psi t : is_derive ph t (Theorem2.k a b c (al t) * dal t).
Proof.
evar_last. apply (ph_derive moment th ps ph M). rewrite (phi_rate moment th ps ph M), dal_is_root. unfold Theorem2.k, Theorem2.x.
replace (cos (al t)) with (cos (ps t)).
2:{ unfold al. destruct k_values as [->| ->]. now rewrite Rmult_1_l. replace (-1 * ps t) with (- ps t) by ring. now rewrite cos_neg. }
assert (S : 0 < sqrt ((a + b * x t) * (c + b * x t))).
{ apply sqrt_lt_R0, Rmult_lt_0_compat. apply (denominator_positive moment th ps ph M). destruct (b_range moment th ps ph M) as [B _].
  assert (X := x_range ps t). assert (0 <= b * x t) by (apply Rmult_le_pos; lra). lra. }
assert (I := moments moment th ps ph M). field. lra.
Qed.
Lemma phi_gain s t : ph t - ph s = RInt (fun v => Theorem2.k a b c v) 0 (al t) - RInt (fun v => Theorem2.k a b c v) 0 (al s).
Proof.
apply (gain_by_lift ph al dal (fun y => RInt (fun v => Theorem2.k a b c v) 0 y) (fun v => Theorem2.k a b c v)).
- apply al_derive.
- intros y. apply (is_derive_RInt (fun v => Theorem2.k a b c v) _ 0). 2: now apply Theorem2.k_continuous; [apply (a_positive moment th ps ph M)|apply (b_range moment th ps ph M)|].
  exists (mkposreal 1 Rlt_0_1). intros z _. apply (@RInt_correct R_CompleteNormedModule). apply Theorem2.k_integrable; trivial. apply (a_positive moment th ps ph M). apply (b_range moment th ps ph M).
- apply phi_by_psi.
Qed.
Lemma gain_over_turn s t : al t = al s + 2*PI -> ph t - ph s = 2 * Theorem2.F a b c.
Proof. intros E. rewrite phi_gain, E. apply turn_of_F; trivial. apply (a_positive moment th ps ph M). apply (b_range moment th ps ph M). Qed.
End Sign.

(** The momentum of a rotating motion does return, from every time on. *)
Theorem rotating_loop_exists t0 : exists t1, one_loop th ps t0 t1.
Proof.
destruct cos_theta_sign as [k [Hk Kc]].
exact (loop_exists th ps _ _ _ bound_positive (al_derive k) (dal_bound k Hk Kc) (psi_determines k Hk Kc) t0).
Qed.
(** Eq. (16): while psi goes through 2 pi, one way or the other, phi gains 2 F(c,0). *)
Theorem rotating_turn t0 t1 : t0 < t1 -> Rabs (ps t1 - ps t0) = 2*PI -> ph t1 - ph t0 = 2 * Theorem2.F a b c.
Proof.
intros L E. destruct cos_theta_sign as [k [Hk Kc]]. apply (gain_over_turn k Hk Kc).
assert (I := al_increases _ _ _ bound_positive (al_derive k) (dal_bound k Hk Kc) t0 t1 L). 
destruct (k_values k Hk) as [Q|Q]; rewrite Q in I |- *; [rewrite Rabs_right in E by lra|rewrite Rabs_left in E by lra]; lra.
Qed.
(** The Montgomery phase of a rotating motion: over one loop of the momentum, wherever it starts, phi gains 2 F(c,0). *)
Theorem rotating_phase t0 t1 : one_loop th ps t0 t1 -> ph t1 - ph t0 = 2 * Theorem2.F a b c.
Proof.
intros L. destruct cos_theta_sign as [k [Hk Kc]]. apply (gain_over_turn k Hk Kc).
exact (loop_is_turn th ps _ _ _ bound_positive (al_derive k) (dal_bound k Hk Kc) (psi_determines k Hk Kc) t0 t1 L).
Qed.
End Rotating.
