(** Motions exist: eq. (6) is enough for a motion, and every body has an oscillating one at every -b < c < 0 and a rotating one at every 0 < c < a. *)
Require Import Reals Lra Psatz Ratan.
From Coquelicot Require Import Coquelicot.
From Polhode Require Import FreeBody Loop Autonomous.
Open Scope R_scope.

Lemma asin_derive y : -1 < y < 1 -> is_derive asin y (1 / sqrt (1 - y²)).
Proof. intros H. apply is_derive_Reals. apply (derive_pt_eq_1 asin y _ (derivable_pt_asin y H)). apply derive_pt_asin. Qed.
Lemma acos_derive y : -1 < y < 1 -> is_derive acos y (-1 / sqrt (1 - y²)).
Proof. intros H. apply is_derive_Reals. apply (derive_pt_eq_1 acos y _ (derivable_pt_acos y H)). apply derive_pt_acos. Qed.

Section Existence.
Variable moment : axis -> R.
Hypothesis Hbody : 0 < moment z_axis < moment y_axis /\ moment y_axis < moment x_axis.
Notation Iy := (moment y_axis).
Notation a := (par_a moment).
Notation b := (par_b moment).

Lemma Iy_positive : 0 < Iy.
Proof. lra. Qed.
Lemma body_a_positive : 0 < a.
Proof. destruct Hbody as [[H1 H2] H3]. unfold par_a. apply (Rmult_lt_reg_r (moment z_axis)); trivial. field_simplify; lra. Qed.
Lemma body_b_range : 0 < b < 1.
Proof. destruct Hbody as [[H1 H2] H3]. unfold par_b. split; apply (Rmult_lt_reg_r (moment x_axis)); try lra; field_simplify; lra. Qed.

(** Differentiable angles with 0 < sin theta that satisfy eq. (6) (here in a and b) are a motion. *)
Theorem equation_6_suffices th ps ph :
  (forall t, 0 < sin (th t)) ->
  (forall t, is_derive th t (b * sin (th t) * sin (ps t) * cos (ps t) / Iy)) ->
  (forall t, is_derive ps t ((a + b * cos (ps t) ^ 2) * cos (th t) / Iy)) ->
  (forall t, is_derive ph t ((1 - b * cos (ps t) ^ 2) / Iy)) -> motion moment th ps ph.
Proof.
intros S Dth Dps Dph. split; trivial.
- intros t. eexists. apply Dth.
- intros t. eexists. apply Dps.
- intros t. eexists. apply Dph.
- intros t i j. destruct Hbody as [[H1 H2] H3].
  assert (P := sin2_cos2 (ps t)). assert (Q := sin2_cos2 (th t)). unfold Rsqr in P, Q.
  assert (P' : sin (ps t) * sin (ps t) = 1 - cos (ps t) * cos (ps t)) by lra. assert (Q' : sin (th t) * sin (th t) = 1 - cos (th t) * cos (th t)) by lra.
  assert (E1 : is_derive th t ((/ moment y_axis - / moment x_axis) * sin (th t) * sin (ps t) * cos (ps t))).
  { evar_last. apply Dth. unfold par_b. field. lra. }
  assert (E2 : is_derive ps t ((/ moment z_axis - / moment y_axis * (1 - cos (ps t) * cos (ps t)) - / moment x_axis * (cos (ps t) * cos (ps t))) * cos (th t))).
  { evar_last. apply Dps. unfold par_a, par_b. field. lra. }
  assert (E3 : is_derive ph t (/ moment y_axis * (1 - cos (ps t) * cos (ps t)) + / moment x_axis * (cos (ps t) * cos (ps t)))).
  { evar_last. apply Dph. unfold par_b. field. lra. }
  unfold attitude, product, sum3, cross_matrix, velocity, momentum, Rdiv.
  revert E1 E2 E3. generalize (/ moment x_axis) (/ moment y_axis) (/ moment z_axis). intros ix iy iz E1 E2 E3.
  assert (X1 : ex_derive th t) by (eexists; apply E1). assert (X2 : ex_derive ps t) by (eexists; apply E2). assert (X3 : ex_derive ph t) by (eexists; apply E3).
  destruct i, j; unfold Rz, Ry;
  (auto_derive; [repeat match goal with |- _ /\ _ => split | |- True => trivial | |- ex_derive (fun y => th y) _ => exact X1
    | |- ex_derive (fun y => ps y) _ => exact X2 | |- ex_derive (fun y => ph y) _ => exact X3 end|]);
  change (fun y => th y) with th; change (fun y => ps y) with ps; change (fun y => ph y) with ph;
  rewrite ?(is_derive_unique th _ _ E1), ?(is_derive_unique ps _ _ E2), ?(is_derive_unique ph _ _ E3);
  clear E1 E2 E3; revert P' Q'; generalize (sin (ps t)) (cos (ps t)) (sin (th t)) (cos (th t)) (sin (ph t)) (cos (ph t)); clear; intros sp cp st ct sf cf P' Q';
  ring [P' Q'].
Qed.

(** psi and C = cos theta are enough: theta = arccos C, and phi is an integral. *)
Lemma motion_from_psi_and_cosine ps C : (forall t, -1 < C t < 1) ->
  (forall t, is_derive ps t ((a + b * cos (ps t) ^ 2) * C t / Iy)) ->
  (forall t, is_derive C t (- (b * sin (ps t) * cos (ps t) * (1 - C t ^ 2) / Iy))) ->
  exists ph, motion moment (fun t => acos (C t)) ps ph.
Proof.
intros HC Dps DC. set (k := fun t => (1 - b * cos (ps t) ^ 2) / Iy). exists (fun t => RInt k 0 t).
assert (HI := Iy_positive).
assert (Kc : forall t, continuous k t).
{ intros t. apply (ex_derive_continuous k). unfold k. auto_derive. eexists; apply Dps. }
assert (Sq : forall t, 0 < sqrt (1 - (C t)²)). { intros t. apply sqrt_lt_R0. specialize (HC t). unfold Rsqr. nra. }
assert (Co : forall t, cos (acos (C t)) = C t). { intros t. apply cos_acos. specialize (HC t). lra. }
assert (Si : forall t, sin (acos (C t)) = sqrt (1 - (C t)²)). { intros t. apply sin_acos. specialize (HC t). lra. }
apply equation_6_suffices.
- intros t. rewrite Si. apply Sq.
- intros t. evar_last. apply (is_derive_comp acos C). apply acos_derive, HC. apply DC.
  rewrite Si. unfold scal; simpl; unfold mult; simpl. assert (Q := Sq t). assert (R2 : sqrt (1 - (C t)²) * sqrt (1 - (C t)²) = 1 - (C t)²). { apply sqrt_sqrt. specialize (HC t). unfold Rsqr. nra. }
  replace (1 - C t * (C t * 1)) with (sqrt (1 - (C t)²) * sqrt (1 - (C t)²)) by (rewrite R2; unfold Rsqr; ring).
  match goal with |- @eq _ ?l ?r => change (@eq R l r) end. field. lra.
- intros t. rewrite Co. apply Dps.
- intros t. apply (is_derive_RInt k _ 0). 2: apply Kc.
  exists (mkposreal 1 Rlt_0_1). intros z _. apply (@RInt_correct R_CompleteNormedModule). apply (@ex_RInt_continuous R_CompleteNormedModule). intros v _. apply Kc.
Qed.
Lemma par_c_of_cosine C psi : -1 < C < 1 -> par_c moment (acos C) psi = a - (1 - C ^ 2) * (a + b * cos psi ^ 2).
Proof.
intros HC. assert (E := Motion.c_in_angles _ _ _ Hbody (fun _ => acos C) (fun _ => psi) 0).
transitivity (Motion.c (moment x_axis) (moment y_axis) (moment z_axis) (fun _ => acos C) (fun _ => psi) 0); [reflexivity|]. rewrite E.
assert (S := sin2_cos2 (acos C)). unfold Rsqr in S. rewrite cos_acos in S by lra. 
replace (sin (acos C) ^ 2) with (1 - C^2) by (simpl; lra). reflexivity.
Qed.

(** The rotating motions: psi' = sqrt ((a + b cos^2 psi)(c + b cos^2 psi)) / I_y has a solution, and cos theta = sqrt ((c + b cos^2 psi)/(a + b cos^2 psi)). *)
Theorem rotating_motion_exists c : 0 < c < a -> exists th ps ph, motion moment th ps ph /\ par_c moment (th 0) (ps 0) = c.
Proof.
intros Hc. destruct body_b_range as [B1 B2]. assert (A := body_a_positive). assert (HI := Iy_positive).
set (x := fun y => cos y ^ 2). assert (X : forall y, 0 <= x y <= 1). { intros y. unfold x. generalize (COS_bound y). intros. nra. }
assert (BX : forall y, 0 <= b * x y <= b). { intros y. specialize (X y). split. apply Rmult_le_pos; lra. nra. }
set (f := fun y => sqrt ((a + b * x y) * (c + b * x y)) / Iy).
assert (Pos : forall y, 0 < (a + b * x y) * (c + b * x y)). { intros y. specialize (BX y). apply Rmult_lt_0_compat; lra. }
destruct (autonomous_solution f (sqrt ((a + b) * (a + b)) / Iy)) as [ps Dps].
- intros y. apply (ex_derive_continuous f). unfold f, x. auto_derive. apply Pos.
- intros y. unfold f. apply Rdiv_lt_0_compat; trivial. apply sqrt_lt_R0, Pos.
- intros y. unfold f, Rdiv. apply Rmult_le_compat_r. apply Rlt_le; now apply Rinv_0_lt_compat. apply sqrt_le_1_alt. specialize (BX y). apply Rmult_le_compat; lra.
- set (C := fun t => sqrt ((c + b * x (ps t)) / (a + b * x (ps t)))).
  assert (Q : forall y, 0 < (c + b * x y) / (a + b * x y) < 1).
  { intros y. specialize (BX y). split. apply Rdiv_lt_0_compat; lra. apply (Rmult_lt_reg_r (a + b * x y)); [lra|]. field_simplify; lra. }
  assert (C0 : forall t, 0 < C t < 1).
  { intros t. unfold C. split. apply sqrt_lt_R0, Q. rewrite <- sqrt_1. apply sqrt_lt_1_alt. specialize (Q (ps t)). lra. }
  assert (C2 : forall t, C t * C t = (c + b * x (ps t)) / (a + b * x (ps t))). { intros t. apply sqrt_sqrt. specialize (Q (ps t)). lra. }
  assert (Fe : forall t, f (ps t) = (a + b * x (ps t)) * C t / Iy).
  { intros t. unfold f. f_equal. specialize (BX (ps t)). specialize (C0 t).
    replace ((a + b * x (ps t)) * (c + b * x (ps t))) with (Rsqr ((a + b * x (ps t)) * C t)).
    2:{ unfold Rsqr. replace ((a + b * x (ps t)) * C t * ((a + b * x (ps t)) * C t)) with ((a + b * x (ps t)) * (a + b * x (ps t)) * (C t * C t)) by ring. rewrite C2. field. lra. }
    apply sqrt_Rsqr. apply Rmult_le_pos; lra. }
  destruct (motion_from_psi_and_cosine ps C) as [ph Mo].
  + intros t. specialize (C0 t). lra.
  + intros t. evar_last. apply Dps. apply Fe.
  + intros t. evar_last.
    apply (is_derive_comp sqrt (fun t => (c + b * x (ps t)) / (a + b * x (ps t)))).
    * instantiate (1 := / (2 * C t)). unfold C. auto_derive. apply Q. simpl. field. apply Rgt_not_eq. apply C0.
    * unfold x. auto_derive. repeat split; try (eexists; apply Dps). specialize (BX (ps t)). unfold x in BX. simpl in BX. lra. reflexivity.
    * change (Derive (fun y => ps y) t) with (Derive ps t). rewrite (is_derive_unique ps _ _ (Dps t)), Fe. unfold scal; simpl; unfold mult; simpl.
      assert (C2' := C2 t). assert (C0' := C0 t). assert (BX' := BX (ps t)).
      replace (1 - C t * (C t * 1)) with (1 - C t * C t) by ring. rewrite C2'. unfold x in *. simpl in *.
      match goal with |- @eq _ ?l ?r => change (@eq R l r) end. field. lra.
  + exists (fun t => acos (C t)), ps, ph. split; trivial. rewrite par_c_of_cosine by (specialize (C0 0); lra).
    assert (C2' := C2 0). assert (BX' := BX (ps 0)). replace (C 0 ^ 2) with (C 0 * C 0) by ring. rewrite C2'. unfold x in *. field. lra.
Qed.

(** The oscillating motions: the amplitude alpha has alpha' = sqrt X sqrt (b (a + b X)) / I_y with X = 1 - r^2 sin^2 alpha, r^2 = 1 + c/b;
    then sin psi = r sin alpha and cos theta = r b cos alpha / sqrt (b (a + b X)). *)
Theorem oscillating_motion_exists c : - b < c < 0 -> exists th ps ph, motion moment th ps ph /\ par_c moment (th 0) (ps 0) = c.
Proof.
intros Hc. destruct body_b_range as [B1 B2]. assert (A := body_a_positive). assert (HI := Iy_positive).
set (r := sqrt (1 + c/b)).
assert (U : 0 < 1 + c/b < 1).
{ split; apply (Rmult_lt_reg_r b); trivial; field_simplify; lra. }
assert (R0 : 0 < r < 1). { unfold r. split. apply sqrt_lt_R0; lra. rewrite <- sqrt_1 at 2. apply sqrt_lt_1_alt. lra. }
assert (R2 : r * r = 1 + c/b) by (apply sqrt_sqrt; lra).
assert (R3 : b * (r * r) = b + c) by (rewrite R2; field; lra).
set (X := fun y => 1 - r * r * (sin y * sin y)). 
assert (HX : forall y, 0 < X y <= 1). { intros y. unfold X. generalize (SIN_bound y). intros. assert (0 <= sin y * sin y <= 1) by (split; nra). split; nra. }
assert (BX : forall y, 0 <= b * X y <= b). { intros y. specialize (HX y). split. apply Rmult_le_pos; lra. nra. }
set (g := fun y => sqrt (b * (a + b * X y))).
assert (Gp : forall y, 0 < b * (a + b * X y)). { intros y. specialize (BX y). apply Rmult_lt_0_compat; lra. }
assert (G0 : forall y, 0 < g y). { intros y. apply sqrt_lt_R0, Gp. }
assert (G2 : forall y, g y * g y = b * (a + b * X y)). { intros y. apply sqrt_sqrt. left; apply Gp. }
set (k := fun y => sqrt (X y)).
assert (K0 : forall y, 0 < k y). { intros y. apply sqrt_lt_R0, HX. }
assert (K2 : forall y, k y * k y = X y). { intros y. apply sqrt_sqrt. left; apply HX. }
set (f := fun y => k y * g y / Iy).
destruct (autonomous_solution f (1 * sqrt (b * (a + b)) / Iy)) as [al Dal].
- intros y. apply (ex_derive_continuous f). unfold f, k, g, X. auto_derive. repeat split; trivial. apply HX. apply Gp.
- intros y. unfold f. apply Rdiv_lt_0_compat; trivial. now apply Rmult_lt_0_compat.
- intros y. unfold f, Rdiv. apply Rmult_le_compat_r. apply Rlt_le; now apply Rinv_0_lt_compat. apply Rmult_le_compat. left; apply K0. left; apply G0.
  rewrite <- sqrt_1. apply sqrt_le_1_alt, HX. apply sqrt_le_1_alt. specialize (BX y). apply Rmult_le_compat_l; lra.
- set (ps := fun t => asin (r * sin (al t))). set (C := fun t => r * b * cos (al t) / g (al t)).
  assert (Sb : forall t, -1 < r * sin (al t) < 1). { intros t. generalize (SIN_bound (al t)). intros. split; nra. }
  assert (Sp : forall t, sin (ps t) = r * sin (al t)). { intros t. apply sin_asin. specialize (Sb t). lra. }
  assert (Cp : forall t, cos (ps t) = k (al t)).
  { intros t. unfold ps. rewrite cos_asin by (specialize (Sb t); lra). unfold k, X. f_equal. unfold Rsqr. ring. }
  assert (C2 : forall t, (a + b * X (al t)) * (1 - C t * C t) = a - c).
  { intros t. assert (P := sin2_cos2 (al t)). unfold Rsqr in P. specialize (BX (al t)). specialize (G0 (al t)).
    replace (C t * C t) with (r * r * b * b * (cos (al t) * cos (al t)) / (g (al t) * g (al t))) by (unfold C; field; lra). rewrite G2.
    replace ((a + b * X (al t)) * (1 - r * r * b * b * (cos (al t) * cos (al t)) / (b * (a + b * X (al t))))) with (a + b * X (al t) - b * (r * r) * (cos (al t) * cos (al t))) by (field; lra).
    unfold X. replace (cos (al t) * cos (al t)) with (1 - sin (al t) * sin (al t)) by lra. replace (a + b * (1 - r * r * (sin (al t) * sin (al t))) - b * (r * r) * (1 - sin (al t) * sin (al t))) with (a + b - b * (r * r)) by ring. lra. }
  assert (C0 : forall t, -1 < C t < 1).
  { intros t. specialize (C2 t). specialize (BX (al t)). assert (C t * C t < 1). { apply Rnot_le_lt. intros L. assert ((a + b * X (al t)) * (1 - C t * C t) <= 0) by nra. lra. } split; nra. }
  destruct (motion_from_psi_and_cosine ps C C0) as [ph Mo].
  + intros t. rewrite Cp. evar_last. unfold ps. apply (is_derive_comp asin (fun t => r * sin (al t))).
    * apply asin_derive, Sb.
    * auto_derive. eexists; apply Dal. reflexivity.
    * change (Derive (fun y => al y) t) with (Derive al t). rewrite (is_derive_unique al _ _ (Dal t)). unfold scal; simpl; unfold mult; simpl.
      replace (1 - (r * sin (al t))²) with (X (al t)) by (unfold X, Rsqr; ring). fold (k (al t)). rewrite Rmult_1_r, K2. unfold f, C.
      replace (a + b * X (al t)) with (g (al t) * g (al t) / b) by (rewrite G2; field; lra).
      assert (K0' := K0 (al t)). assert (G0' := G0 (al t)). match goal with |- @eq _ ?l ?r => change (@eq R l r) end. field. lra.
  + intros t. rewrite Sp, Cp. assert (K0' := K0 (al t)). assert (G0' := G0 (al t)). assert (G2' := G2 (al t)). assert (K2' := K2 (al t)).
    assert (Dg : is_derive (fun t => g (al t)) t (- (b * b * (r * r) * sin (al t) * cos (al t) * f (al t) / g (al t)))).
    { evar_last. apply (is_derive_comp sqrt (fun t => b * (a + b * X (al t)))).
      - instantiate (1 := / (2 * g (al t))). unfold g. auto_derive. apply Gp. simpl. field. apply Rgt_not_eq, G0.
      - unfold X. auto_derive. repeat match goal with |- _ /\ _ => split | |- True => trivial end; exists (f (al t)); apply Dal. reflexivity.
      - change (Derive (fun y => al y) t) with (Derive al t). rewrite (is_derive_unique al _ _ (Dal t)). unfold scal; simpl; unfold mult; simpl.
        match goal with |- @eq _ ?l ?r => change (@eq R l r) end. field. lra. }
    evar_last. unfold C. apply (is_derive_ext (fun t => (r * b * cos (al t)) * / g (al t))). { reflexivity. }
    apply (is_derive_mult (fun t => r * b * cos (al t)) (fun t => / g (al t))).
    * auto_derive. eexists; apply Dal. reflexivity.
    * apply is_derive_inv. apply Dg. lra.
    * intros; apply Rmult_comm.
    * change (Derive (fun y => al y) t) with (Derive al t). rewrite (is_derive_unique al _ _ (Dal t)). unfold plus, mult; simpl. unfold C, f.
      match goal with |- @eq _ ?l ?r => change (@eq R l r) end. field. lra.
  + exists (fun t => acos (C t)), ps, ph. split; trivial. rewrite par_c_of_cosine by apply C0. rewrite Cp.
    replace (k (al 0) ^ 2) with (X (al 0)) by (rewrite <- K2; ring). assert (C2' := C2 0). replace (C 0 ^ 2) with (C 0 * C 0) by ring. lra.
Qed.
End Existence.
