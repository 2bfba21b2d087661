(** Where there is no Montgomery phase: at c = -b the body spins about its x axis, so that the momentum rests in the body frame; at c = 0 it rests
    at the y axis or moves on the separatrix and never returns; c = a is the spin about the z axis, where sin theta = 0 is outside the chart.
    So theorems 1 and 2 are about all loops that there are: a motion has one if and only if -b < c < 0 or 0 < c < a. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Polhode Require Import Uniqueness FreeBody Loop Theorems.
Open Scope R_scope.

Section NoLoop.
Variable moment : axis -> R.
Variables th ps ph : R -> R.
Hypothesis M : motion moment th ps ph.
Notation a := (par_a moment).
Notation b := (par_b moment).
Notation x t := (cos (ps t) ^ 2).
Notation c := (par_c moment (th 0) (ps 0)).

(** A momentum with two zero components at all times rests. *)
Lemma on_an_axis_rests : (forall t, cos (th t) = 0) -> (forall t, sin (ps t) * cos (ps t) = 0) -> forall s t, same_momentum th ps s t.
Proof.
intros Z W s t i. apply (equal_everywhere (fun t => momentum (th t) (ps t) i)). intros z. evar_last. apply (euler_equations moment th ps ph M).
unfold cross, sum3, cross_matrix, velocity, momentum. rewrite (Z z). unfold Rdiv.
destruct i; match goal with |- @eq _ ?l ?r => change (@eq R l r) end; try ring.
replace (_ + _ + _) with (sin (th z) * sin (th z) * (sin (ps z) * cos (ps z)) * (/ moment x_axis - / moment y_axis)) by ring. rewrite (W z). ring.
Qed.
Lemma resting_has_no_loop t0 t1 : (forall s t, same_momentum th ps s t) -> ~ one_loop th ps t0 t1.
Proof. intros R [L [_ N]]. apply (N ((t0 + t1)/2)); [lra|apply R]. Qed.

(** c = -b. *)
Theorem no_loop_at_minus_b t0 t1 : c = - b -> ~ one_loop th ps t0 t1.
Proof.
intros E. apply resting_has_no_loop. assert (B := b_range moment th ps ph M). assert (A := a_positive moment th ps ph M).
assert (H : forall t, cos (th t) = 0 /\ sin (ps t) = 0).
{ intros t. assert (Q := cos_squared moment th ps ph M t). rewrite E in Q. assert (X := x_range ps t). assert (S := sin2_cos2 (ps t)). unfold Rsqr in S.
  assert (D := denominator_positive moment th ps ph M t). assert (C := pow2_ge_0 (cos (th t))).
  assert (0 <= (a + b * x t) * cos (th t) ^2) by (apply Rmult_le_pos; lra). assert (X1 : x t = 1) by nra.
  assert (Z : (a + b * x t) * cos (th t) ^2 = 0) by (rewrite Q, X1; ring). apply Rmult_integral in Z.
  split; apply Rsqr_0_uniq; unfold Rsqr; simpl in *; destruct Z; lra. }
apply on_an_axis_rests; intros t; destruct (H t) as [H1 H2]; [exact H1|rewrite H2; ring].
Qed.

(** c = 0: cos psi is 0 always or never, by Groenwall's lemma. *)
Lemma cos_psi_derive t : is_derive (fun t => cos (ps t) ^2) t (- 2 * cos (ps t) * sin (ps t) * Derive ps t).
Proof. evar_last. apply (is_derive_ext (fun t => cos (ps t) * cos (ps t))). { intros s. simpl. ring. }
apply (is_derive_mult (fun t => cos (ps t)) (fun t => cos (ps t))); [apply (is_derive_comp cos ps); [apply is_derive_cos|apply (ps_derive moment th ps ph M)]|apply (is_derive_comp cos ps); [apply is_derive_cos|apply (ps_derive moment th ps ph M)]|intros; apply Rmult_comm].
unfold plus, mult, scal; simpl; unfold mult; simpl. ring. Qed.
Lemma separatrix_cos_theta t : c = 0 -> Rabs (cos (th t)) <= sqrt (b / a) * Rabs (cos (ps t)).
Proof.
intros E. assert (B := b_range moment th ps ph M). assert (A := a_positive moment th ps ph M).
assert (Q := cos_squared moment th ps ph M t). rewrite E in Q. assert (X := x_range ps t).
assert (BX : 0 <= b * x t) by (apply Rmult_le_pos; lra). assert (C := pow2_ge_0 (cos (th t))).
rewrite <- !sqrt_Rsqr_abs, <- sqrt_mult_alt by (left; apply Rdiv_lt_0_compat; lra). apply sqrt_le_1_alt. unfold Rsqr.
apply (Rmult_le_reg_l a); [exact A|]. replace (a * (b / a * (cos (ps t) * cos (ps t)))) with (b * x t) by (simpl; field; lra).
replace (cos (th t) * cos (th t)) with (cos (th t) ^2) by ring. nra.
Qed.
Lemma separatrix_rests t : c = 0 -> cos (ps t) = 0 -> forall s, cos (ps s) = 0.
Proof.
intros E Z s. assert (B := b_range moment th ps ph M). assert (A := a_positive moment th ps ph M). assert (Im := moments moment th ps ph M).
set (K := 2 * ((a + b) / moment y_axis * sqrt (b / a))).
assert (G : cos (ps s) ^2 = 0).
{ apply (gronwall (fun t => cos (ps t) ^2) (fun t => - 2 * cos (ps t) * sin (ps t) * Derive ps t) K (Rmin s t) (Rmax s t)) with (t0 := t).
  - intros z _. apply cos_psi_derive.
  - intros z _. apply pow2_ge_0.
  - intros z _. rewrite (psi_rate moment th ps ph M z). assert (X := x_range ps z). assert (BX : 0 <= b * x z <= b) by (split; nra).
    assert (W := separatrix_cos_theta z E). assert (Sb := SIN_bound (ps z)). assert (S1 : Rabs (sin (ps z)) <= 1) by (apply Rabs_le; lra).
    assert (I0 : 0 < / moment y_axis) by (apply Rinv_0_lt_compat; lra).
    replace (- 2 * cos (ps z) * sin (ps z) * ((a + b * x z) * cos (th z) / moment y_axis))
      with (- (2 * (sin (ps z) * ((a + b * x z) / moment y_axis * (cos (ps z) * cos (th z)))))) by (unfold Rdiv; ring).
    rewrite Rabs_Ropp, Rabs_mult, (Rabs_pos_eq 2), !Rabs_mult by lra.
    assert (P1 : 0 <= (a + b * x z) / moment y_axis <= (a + b) / moment y_axis).
    { unfold Rdiv. split; [apply Rmult_le_pos; lra|apply Rmult_le_compat_r; lra]. }
    rewrite (Rabs_pos_eq ((a + b * x z) / moment y_axis)) by apply P1. unfold K.
    replace (2 * ((a + b) / moment y_axis * sqrt (b / a)) * cos (ps z) ^2) with (2 * (1 * ((a + b) / moment y_axis * (Rabs (cos (ps z)) * (sqrt (b/a) * Rabs (cos (ps z))))))).
    2:{ rewrite <- (pow2_abs (cos (ps z))). ring. }
    apply Rmult_le_compat_l; [lra|]. assert (Pc := Rabs_pos (cos (ps z))). assert (Pt := Rabs_pos (cos (th z))). assert (Ps := Rabs_pos (sin (ps z))).
    apply Rmult_le_compat; trivial. { apply Rmult_le_pos; [apply P1|now apply Rmult_le_pos]. }
    apply Rmult_le_compat; [apply P1|now apply Rmult_le_pos|apply P1|]. now apply Rmult_le_compat_l.
  - split; [apply Rmin_r|apply Rmax_r].
  - rewrite Z. ring.
  - split; [apply Rmin_l|apply Rmax_l]. }
apply Rsqr_0_uniq. unfold Rsqr. simpl in G. lra.
Qed.
Lemma sin_psi_derive t : is_derive (fun t => sin (ps t)) t (cos (ps t) * Derive ps t).
Proof. evar_last. apply (is_derive_comp sin ps); [apply is_derive_sin|apply (ps_derive moment th ps ph M)]. unfold scal; simpl; unfold mult; simpl. ring. Qed.
Theorem no_loop_at_0 t0 t1 : c = 0 -> ~ one_loop th ps t0 t1.
Proof.
intros E. assert (B := b_range moment th ps ph M). assert (A := a_positive moment th ps ph M). assert (Im := moments moment th ps ph M).
destruct (Req_dec (cos (ps t0)) 0) as [Z|N].
- assert (H := separatrix_rests t0 E Z). apply resting_has_no_loop, on_an_axis_rests; intros t.
  + assert (W := separatrix_cos_theta t E). rewrite (H t), Rabs_R0, Rmult_0_r in W. assert (P := Rabs_pos (cos (th t))).
    destruct (Req_dec (cos (th t)) 0) as [Y|Y]; trivial. apply Rabs_no_R0 in Y. lra.
  + rewrite (H t). ring.
- assert (NP : forall t, cos (ps t) <> 0) by (intros t Z; apply N; exact (separatrix_rests t E Z t0)).
  assert (NT : forall t, cos (th t) <> 0).
  { intros t Z. assert (Q := cos_squared moment th ps ph M t). rewrite E, Z in Q. apply (NP t). apply Rsqr_0_uniq. unfold Rsqr.
    assert (b * x t = 0) by (replace (0 ^2) with 0 in Q by ring; lra). apply Rmult_integral in H. simpl in H. destruct H; lra. }
  assert (CP : forall t, continuous ps t) by (intros t; apply (ex_derive_continuous ps), (ps_differentiable _ _ _ _ M)).
  assert (CT : forall t, continuous th t) by (intros t; apply (ex_derive_continuous th), (th_differentiable _ _ _ _ M)).
  destruct (sign_of (fun t => cos (ps t) * cos (th t))) as [k [K1 K2]].
  { intros t. apply (continuous_mult (fun t => cos (ps t)) (fun t => cos (th t))); apply continuous_comp; trivial; apply continuous_cos. }
  { intros t Z. apply Rmult_integral in Z. destruct Z as [Z|Z]; [now apply (NP t)|now apply (NT t)]. }
  intros [L [S _]]. apply same_momentum_angles in S; [|apply (chart _ _ _ _ M)|apply (chart _ _ _ _ M)]. destruct S as [_ [_ S]].
  destruct (MVT_gen (fun t => sin (ps t)) t0 t1 (fun t => cos (ps t) * Derive ps t)) as [z [_ Ez]].
  + intros z _. apply sin_psi_derive.
  + intros z _. apply continuity_pt_filterlim, (ex_derive_continuous (fun t => sin (ps t))). eexists. apply sin_psi_derive.
  + rewrite S in Ez. rewrite (psi_rate moment th ps ph M z) in Ez. assert (D := denominator_positive moment th ps ph M z). assert (Kz := K2 z).
    assert (I0 : 0 < / moment y_axis) by (apply Rinv_0_lt_compat; lra).
    assert (P : 0 < (k * (cos (ps z) * cos (th z))) * ((a + b * x z) * / moment y_axis) * (t1 - t0)).
    { apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat; trivial; now apply Rmult_lt_0_compat|lra]. }
    assert (Q : (k * (cos (ps z) * cos (th z))) * ((a + b * x z) * / moment y_axis) * (t1 - t0) = k * (cos (ps z) * ((a + b * x z) * cos (th z) / moment y_axis) * (t1 - t0))) by (unfold Rdiv; ring).
    rewrite <- Ez in Q. rewrite Rminus_eq_0, Rmult_0_r in Q. lra.
Qed.
End NoLoop.

(** There is a Montgomery phase at c if and only if -b < c < 0 or 0 < c < a. *)
Theorem phase_exists_iff moment c : body moment -> ((exists D, montgomery_phase moment c D) <-> - par_b moment < c < 0 \/ 0 < c < par_a moment).
Proof.
intros H. split.
- intros [D [th [ps [ph [t0 [t1 [M [E [L _]]]]]]]]]. assert (R := c_range moment th ps ph M). rewrite E in R.
  destruct (Req_dec c (- par_b moment)) as [Z|N]. { exfalso. rewrite <- E in Z. exact (no_loop_at_minus_b moment th ps ph M t0 t1 Z L). }
  destruct (Req_dec c 0) as [Z|N0]. { exfalso. rewrite <- E in Z. exact (no_loop_at_0 moment th ps ph M t0 t1 Z L). }
  destruct (Rlt_or_le c 0); [left|right]; lra.
- intros [C|C].
  + eexists. now apply (oscillating_phase_at moment H c _ C).
  + eexists. now apply (rotating_phase_at moment H c _ C).
Qed.
