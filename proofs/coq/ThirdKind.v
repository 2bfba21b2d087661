(** The complete elliptic integral of the third kind with a weight,
      T(x,y; A,B,C,D) = integral over 0..pi/2 of w(t) dt / sqrt ((x cos t)^2 + (y sin t)^2),
      w(t) = (A cos^2 t + B sin^2 t) / (C cos^2 t + D sin^2 t),
    is left unchanged by a step of the arithmetic-geometric mean with a step of the weight:
      T(x,y; A,B,C,D) = T((x+y)/2, sqrt (xy); (AD+BC)/(2D'), (Ay+Bx)/(x+y), CD/D', D'),
      D' = (Cy+Dx)/(x+y).
    It lies between the least and the greatest value of w times Gauss's integral. (This is Bartky's
    transformation. The proof takes the mean of w(t) and of w at the angle of tangent (x/y) cot t;
    Landen's angle is the same for both but for a reflection.) *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Polhode Require Import GaussIntegral.
Open Scope R_scope.

Lemma form_pos C D t : 0 < C -> 0 < D -> 0 < C * cos t^2 + D * sin t^2.
Proof.
intros HC HD. assert (R := radicand_pos (sqrt C) (sqrt D) t (sqrt_lt_R0 _ HC) (sqrt_lt_R0 _ HD)).
unfold radicand in R. rewrite !Rpow_mult_distr, !pow2_sqrt in R by lra. exact R.
Qed.

Definition weight (A B C D t : R) : R := (A * cos t^2 + B * sin t^2) / (C * cos t^2 + D * sin t^2).

Lemma weight_continuous A B C D t : 0 < C -> 0 < D -> continuous (weight A B C D) t.
Proof.
intros HC HD. apply (ex_derive_continuous (weight A B C D)). unfold weight.
assert (P := form_pos C D t HC HD).
auto_derive. simpl in P |- *. lra.
Qed.

Definition third_kind (x y A B C D : R) : R := RInt (fun t => weight A B C D t * integrand x y t) 0
  (PI/2).

Lemma third_kind_continuous x y A B C D t : 0 < x -> 0 < y -> 0 < C -> 0 < D -> continuous (fun t =>
  weight A B C D t * integrand x y t) t.
Proof.
intros Hx Hy HC HD. apply (continuous_mult (weight A B C D) (integrand x y)).
now apply weight_continuous. now apply integrand_continuous.
Qed.

(** The angle of tangent m tan t *)
Definition stretched (m t : R) : R :=
  t + atan ((m - 1) * sin t * cos t / (cos t * cos t + m * (sin t * sin t))).
Definition stretch_rate (m t : R) : R := m / (cos t^2 + m^2 * sin t^2).

Lemma stretch_denominator_pos m t : 0 < m -> 0 < cos t * cos t + m * (sin t * sin t).
Proof. intros Hm. assert (P := form_pos 1 m t ltac:(lra) Hm). simpl in P. lra. Qed.

Lemma squares_at_stretched m t : 0 < m ->
  cos (stretched m t)^2 = cos t^2 / (cos t^2 + m^2 * sin t^2) /\ sin (stretched m t)^2 = m^2 * sin
    t^2 / (cos t^2 + m^2 * sin t^2).
Proof.
intros Hm. assert (HD := stretch_denominator_pos m t Hm).
assert (HR := form_pos 1 (m^2) t ltac:(lra) ltac:(nra)). rewrite Rmult_1_l in HR.
assert (Hs := cos_sq t). unfold stretched. rewrite cos_plus, sin_plus, cos_atan, sin_atan.
set (N := (m-1) * sin t * cos t). set (D := cos t * cos t + m * (sin t * sin t)) in *.
set (q := sqrt (1 + (N / D)²)).
assert (ND : N*N + D*D = cos t^2 + m^2 * sin t^2) by (unfold N, D; ring [Hs]).
assert (Hq2 : q*q = (cos t^2 + m^2 * sin t^2) / (D*D)).
{ unfold q. rewrite sqrt_sqrt. rewrite <- ND. unfold Rsqr. field. lra.
  unfold Rsqr. assert (0 <= N / D * (N / D)) by nra. lra. }
assert (Hq : 0 < q). { unfold q. apply sqrt_lt_R0. assert (0 <= (N / D)²) by apply Rle_0_sqr. lra. }
assert (E1 : cos t * D - sin t * N = cos t) by (unfold N, D; ring [Hs]).
assert (E2 : sin t * D + cos t * N = m * sin t) by (unfold N, D; ring [Hs]).
replace (m^2 * sin t^2) with ((m * sin t)^2) at 2 by ring.
replace (cos t^2) with ((cos t)^2) at 1 by ring.
assert (EQ : cos t^2 + m^2 * sin t^2 = D*D*(q*q)) by (rewrite Hq2; field; lra).
rewrite EQ. split.
- transitivity ((cos t * D - sin t * N)^2 / (D*D*(q*q))); [field; lra|]. rewrite E1. reflexivity.
- transitivity ((sin t * D + cos t * N)^2 / (D*D*(q*q))); [field; lra|]. rewrite E2. reflexivity.
Qed.

Lemma stretched_derive m t : 0 < m -> is_derive (stretched m) t (stretch_rate m t).
Proof.
intros Hm. assert (HD := stretch_denominator_pos m t Hm).
assert (HR := form_pos 1 (m^2) t ltac:(lra) ltac:(nra)). rewrite Rmult_1_l in HR.
assert (Hs := cos_sq t). unfold stretched.
set (N := fun t => (m-1) * sin t * cos t). set (D := fun t => cos t * cos t + m * (sin t * sin t)).
assert (ND : N t * N t + D t * D t = cos t^2 + m^2 * sin t^2) by (unfold N, D; ring [Hs]).
change (0 < D t) in HD.
assert (Hq : is_derive (fun x => N x / D x) t
   (((m-1)*(cos t * cos t - sin t * sin t) * D t - N t * (2*(m-1)*sin t * cos t))/(D t)^2)).
{ unfold N, D. auto_derive. unfold D in HD; lra. unfold N, D in *. field. lra. }
evar_last.
apply (is_derive_plus (fun x => x) (fun x => atan (N x / D x))).
auto_derive; [trivial|reflexivity].
apply (is_derive_comp atan (fun x => N x / D x)).
apply is_derive_atan. exact Hq.
unfold plus, scal; simpl; unfold mult; simpl.
unfold stretch_rate. rewrite <- ND.
assert (0 < N t * N t + D t * D t) by (rewrite ND; exact HR).
apply Rminus_diag_uniq.
match goal with |- ?l = 0 => replace l with
 (((N t * N t + D t * D t) + ((m-1)*(cos t * cos t - sin t * sin t) * D t - N t * (2*(m-1)*sin t *
   cos t)) - m) / (N t * N t + D t * D t)) end.
2:{ unfold Rsqr. field. split; nra. }
unfold Rdiv. apply Rmult_eq_0_compat_r.
unfold N, D. set (s := sin t) in *. set (c := cos t) in *.
assert (Hc4 : c^4 = (1 - s*s)^2) by (replace (c^4) with ((c*c)^2) by ring; rewrite Hs; ring).
assert (Hc2 : c^2 = 1 - s*s) by (rewrite <- Hs; ring).
ring_simplify. rewrite ?Hc4, ?Hc2. ring.
Qed.

Lemma stretch_substitution (g : R -> R) m : 0 < m -> (forall t, continuous g t) ->
  RInt g 0 (PI/2) = RInt (fun t => stretch_rate m t * g (stretched m t)) 0 (PI/2).
Proof.
intros Hm C. assert (HC := RInt_comp (V:=R_CompleteNormedModule) g (stretched m) (stretch_rate m) 0
  (PI/2)).
assert (P0 : stretched m 0 = 0).
{ unfold stretched. rewrite sin_0, cos_0. replace ((m-1)*0*1/(1*1+m*(0*0))) with 0 by (field; lra).
rewrite atan_0. ring. }
assert (P1 : stretched m (PI/2) = PI/2).
{ unfold stretched. rewrite sin_PI2, cos_PI2.
replace ((m-1)*1*0/(0*0+m*(1*1))) with 0 by (field; lra). rewrite atan_0. ring. }
rewrite P0, P1 in HC. symmetry. apply HC.
- intros x _. apply C.
- intros x _. split. now apply stretched_derive.
  apply (ex_derive_continuous (stretch_rate m)). unfold stretch_rate. auto_derive.
  assert (HR := form_pos 1 (m^2) x ltac:(lra) ltac:(nra)). simpl in HR |- *. lra.
Qed.

Lemma reflection (g : R -> R) : (forall t, continuous g t) -> RInt g 0 (PI/2) = RInt (fun t => g
  (PI/2 - t)) 0 (PI/2).
Proof.
intros C. assert (HC := RInt_comp (V:=R_CompleteNormedModule) g (fun y => PI/2 - y) (fun _ => -1) 0
  (PI/2)).
cbv beta in HC. rewrite Rminus_0_r, Rminus_eq_0 in HC.
assert (I : forall x y, ex_RInt g x y) by (intros; apply (@ex_RInt_continuous
  R_CompleteNormedModule); intros; apply C).
assert (E : RInt (fun y => scal (-1) (g (PI/2 - y))) 0 (PI/2) = - RInt (fun y => g (PI/2 - y)) 0
  (PI/2)).
{ rewrite (RInt_scal (V:=R_CompleteNormedModule)).
  - unfold scal; simpl; unfold mult; simpl.
  match goal with |- @eq _ ?l ?r => change (@eq R l r) end. ring.
  - apply (@ex_RInt_continuous R_CompleteNormedModule). intros z _.
  apply (continuous_comp (fun y => PI/2 - y) g); [|apply C].
    apply (ex_derive_continuous (fun y => PI/2 - y)). auto_derive; trivial. }
assert (H : - RInt (fun y => g (PI/2 - y)) 0 (PI/2) = RInt g (PI/2) 0).
{ rewrite <- E. apply HC.
  - intros; apply C.
  - intros x _. split; [auto_derive; auto; ring | apply continuous_const]. }
rewrite <- (opp_RInt_swap g (PI/2) 0), <- H by apply I. unfold opp; simpl.
match goal with |- @eq _ ?l ?r => change (@eq R l r) end. ring.
Qed.

Lemma over_common_denominator p q r s u v n : n <> 0 -> r*u + s*v <> 0 -> (p*(u/n) + q*(v/n)) /
  (r*(u/n) + s*(v/n)) = (p*u + q*v) / (r*u + s*v).
Proof.
intros Hn H. replace (p*(u/n) + q*(v/n)) with ((p*u + q*v)/n) by (field; trivial).
replace (r*(u/n) + s*(v/n)) with ((r*u + s*v)/n) by (field; trivial).
field. split; trivial.
Qed.

Section Step.
Variables x y A B C D : R.
Hypothesis Hx : 0 < x.
Hypothesis Hy : 0 < y.
Hypothesis HC : 0 < C.
Hypothesis HD : 0 < D.

(** T with w at the angle of tangent (x/y) cot t *)
Lemma third_kind_mirror : third_kind x y A B C D = third_kind x y (B * x^2) (A * y^2) (D * x^2) (C *
  y^2).
Proof.
assert (X2 : 0 < x^2) by (apply pow_lt; lra). assert (Y2 : 0 < y^2) by (apply pow_lt; lra).
unfold third_kind. rewrite (stretch_substitution _ (x/y)).
2: now apply Rdiv_lt_0_compat. 2: intros t; now apply third_kind_continuous.
rewrite reflection.
2:{ intros t. apply (continuous_mult (stretch_rate (x/y)) (fun t => weight A B C D (stretched (x/y)
  t) * integrand x y (stretched (x/y) t))).
    - apply (ex_derive_continuous (stretch_rate (x/y))). unfold stretch_rate. auto_derive.
      assert (P := form_pos 1 ((x/y)^2) t ltac:(lra) ltac:(apply pow_lt, Rdiv_lt_0_compat; lra)).
      simpl in P |- *. lra.
    - apply (continuous_comp (stretched (x/y)) (fun t => weight A B C D t * integrand x y t)).
      apply (ex_derive_continuous (stretched (x/y))). eexists. apply stretched_derive.
      now apply Rdiv_lt_0_compat. now apply third_kind_continuous. }
apply RInt_ext. intros t _.
destruct (squares_at_stretched (x/y) (PI/2 - t) ltac:(now apply Rdiv_lt_0_compat)) as [Q1 Q2].
assert (P0 := form_pos 1 ((x/y)^2) (PI/2 - t) ltac:(lra) ltac:(apply pow_lt, Rdiv_lt_0_compat;
  lra)). rewrite Rmult_1_l in P0.
rewrite cos_shift, sin_shift in *.
unfold integrand, weight, radicand, stretch_rate.
rewrite !Rpow_mult_distr, Q1, Q2, cos_shift, sin_shift.
assert (P1 := form_pos (x^2) (y^2) t X2 Y2).
assert (P2 := form_pos (D * x^2) (C * y^2) t ltac:(now apply Rmult_lt_0_compat) ltac:(now apply
  Rmult_lt_0_compat)).
set (n := x^2 * cos t^2 + y^2 * sin t^2) in *.
assert (E0 : sin t^2 + (x/y)^2 * cos t^2 = n / y^2) by (unfold n; field; lra). rewrite E0 in *.
replace (x^2 * (sin t^2 / (n/y^2)) + y^2 * ((x/y)^2 * cos t^2 / (n/y^2))) with ((x*y)^2 * (sin t^2 +
  cos t^2) / n) by (field; lra).
replace (sin t^2 + cos t^2) with 1 by (generalize (sin2_cos2 t); unfold Rsqr; simpl; lra).
rewrite Rmult_1_r, sqrt_div_alt, sqrt_pow2 by first [exact P1 | apply Rmult_le_pos; lra].
assert (S := sqrt_lt_R0 _ P1). assert (S2 := sqrt_sqrt _ (Rlt_le _ _ P1)). set (r := sqrt n) in *.
match goal with |- @eq _ ?l ?r => change (@eq R l r) end. rewrite <- S2. field.
repeat split; try lra; try nra.
Qed.

Let d := (C*y + D*x) / (x + y).
Lemma landen_weight_pos : 0 < d.
Proof. unfold d. apply Rdiv_lt_0_compat; [|lra].
apply Rplus_lt_0_compat; now apply Rmult_lt_0_compat. Qed.

Lemma weight_at_landen_angle t :
  weight A B C D t + weight (B * x^2) (A * y^2) (D * x^2) (C * y^2) t =
  2 * weight ((A*D + B*C) / (2*d)) ((A*y + B*x) / (x + y)) (C*D / d) d (landen_angle x y t).
Proof.
assert (X2 : 0 < x^2) by (apply pow_lt; lra). assert (Y2 : 0 < y^2) by (apply pow_lt; lra).
assert (Pd := landen_weight_pos).
destruct (squares_at_landen_angle x y Hx Hy t) as [Q1 Q2]. assert (R := radicand_pos x y t Hx Hy).
unfold weight. rewrite Q1, Q2.
assert (P1 := form_pos C D t HC HD). assert (P2 := form_pos (D * x^2) (C * y^2) t ltac:(now apply
  Rmult_lt_0_compat) ltac:(now apply Rmult_lt_0_compat)).
assert (E : 0 < C*D/d * (x * cos t^2 - y * sin t^2)^2 + d * ((x+y) * (sin t * cos t))^2).
{ replace (C*D/d * (x * cos t^2 - y * sin t^2)^2 + d * ((x+y) * (sin t * cos t))^2) with
    ((C * cos t^2 + D * sin t^2) * (D * x^2 * cos t^2 + C * y^2 * sin t^2) / d).
  apply Rdiv_lt_0_compat; trivial. now apply Rmult_lt_0_compat.
  replace (d * ((x+y) * (sin t * cos t))^2) with (d^2 * (x+y)^2 * (sin t * cos t)^2 / d) by (field;
    lra).
  replace (d^2 * (x+y)^2) with ((C*y + D*x)^2) by (unfold d; field; lra). field. lra. }
set (v := cos t^2) in *. set (w := sin t^2) in *.
assert (VW : ((x+y) * (sin t * cos t))^2 = (x+y)^2 * (v*w)) by (unfold v, w; ring). rewrite VW in *.
transitivity (2 * (((A*D + B*C) / (2*d) * (x*v - y*w)^2 + (A*y + B*x) / (x + y) * ((x+y)^2 * (v*w)))
  / (C*D/d * (x*v - y*w)^2 + d * ((x+y)^2 * (v*w))))).
2:{ apply Rmult_eq_compat_l. symmetry. apply over_common_denominator; lra. }
assert (ED : C*D/d * (x*v - y*w)^2 + d * ((x+y)^2 * (v*w)) = (C*v + D*w) * (D*x^2*v + C*y^2*w) / d).
{ replace (d * ((x+y)^2 * (v*w))) with (d^2 * (x+y)^2 * (v*w) / d) by (field; lra).
  replace (d^2 * (x+y)^2) with ((C*y + D*x)^2) by (unfold d; field; lra). field. lra. }
assert (EN : (A*D + B*C) / (2*d) * (x*v - y*w)^2 + (A*y + B*x) / (x + y) * ((x+y)^2 * (v*w)) =
  ((A*v + B*w) * (D*x^2*v + C*y^2*w) + (B*x^2*v + A*y^2*w) * (C*v + D*w)) / (2*d)).
{ replace ((A*y + B*x) / (x + y) * ((x+y)^2 * (v*w))) with ((A*y + B*x) * (d*(x+y)) * (v*w) / d) by
  (field; lra).
  replace (d*(x+y)) with (C*y + D*x) by (unfold d; field; lra). field. lra. }
rewrite ED, EN. field. repeat split; lra.
Qed.

Theorem third_kind_step : third_kind x y A B C D =
  third_kind ((x+y)/2) (sqrt (x*y)) ((A*D + B*C) / (2*d)) ((A*y + B*x) / (x + y)) (C*D / d) d.
Proof.
assert (X2 : 0 < x^2) by (apply pow_lt; lra). assert (Y2 : 0 < y^2) by (apply pow_lt; lra).
assert (Pd := landen_weight_pos).
assert (XY : 0 < sqrt (x*y)) by (apply sqrt_lt_R0; now apply Rmult_lt_0_compat).
assert (CDd : 0 < C*D/d) by (apply Rdiv_lt_0_compat; trivial; now apply Rmult_lt_0_compat).
set (A' := (A*D + B*C) / (2*d)). set (B' := (A*y + B*x) / (x + y)). set (C' := C*D/d) in *.
set (g := fun t => weight A' B' C' d t * integrand ((x+y)/2) (sqrt (x*y)) t).
assert (Cg : forall t, continuous g t) by (intros; apply third_kind_continuous; lra).
assert (Eg : forall t, g (PI - t) = g t).
{ intros t. unfold g, weight, integrand, radicand. rewrite cos_minus, sin_minus, cos_PI, sin_PI.
  replace (-1 * cos t + 0 * sin t) with (- cos t) by ring.
  replace (0 * cos t - -1 * sin t) with (sin t) by ring.
  rewrite !Rpow_mult_distr. replace ((- cos t)^2) with (cos t^2) by ring. reflexivity. }
assert (L := landen_substitution x y Hx Hy g Cg). rewrite (integral_to_pi g Cg Eg) in L.
change (RInt g 0 (PI/2)) with (third_kind ((x+y)/2) (sqrt (x*y)) A' B' C' d) in L.
assert (S : RInt (fun t => landen_rate x y t * g (landen_angle x y t)) 0 (PI/2) =
  third_kind x y A B C D + third_kind x y (B * x^2) (A * y^2) (D * x^2) (C * y^2)).
2:{ rewrite <- third_kind_mirror in S. lra. }
unfold third_kind. rewrite <- (RInt_plus (V:=R_CompleteNormedModule)).
- apply RInt_ext. intros t _.
  change (landen_rate x y t * g (landen_angle x y t) =
    weight A B C D t * integrand x y t + weight (B * x^2) (A * y^2) (D * x^2) (C * y^2) t *
      integrand x y t).
  unfold g. assert (W := weight_at_landen_angle t). fold A' B' C' in W.
  assert (I := landen_integrand x y Hx Hy t).
  rewrite <- Rmult_plus_distr_r, W.
  transitivity (weight A' B' C' d (landen_angle x y t) * (landen_rate x y t * integrand ((x+y)/2)
    (sqrt (x*y)) (landen_angle x y t))); [ring|].
  rewrite I. ring.
- apply (@ex_RInt_continuous R_CompleteNormedModule). intros z _. now apply third_kind_continuous.
- apply (@ex_RInt_continuous R_CompleteNormedModule). intros z _.
apply third_kind_continuous; trivial; now apply Rmult_lt_0_compat.
Qed.
End Step.

(** It decreases in x, y, C and D, and increases in A and B. *)
Lemma third_kind_monotone x y A B C D x' y' A' B' C' D' : 0 < x' <= x -> 0 < y' <= y -> 0 <= A <= A'
  -> 0 <= B <= B' -> 0 < C' <= C -> 0 < D' <= D ->
  third_kind x y A B C D <= third_kind x' y' A' B' C' D'.
Proof.
intros Hx Hy HA HB HC HD. assert (P := PI_RGT_0). unfold third_kind. apply RInt_le; try lra.
- apply (@ex_RInt_continuous R_CompleteNormedModule). intros z _. apply third_kind_continuous; lra.
- apply (@ex_RInt_continuous R_CompleteNormedModule). intros z _. apply third_kind_continuous; lra.
- intros t _. assert (Q := form_pos C D t ltac:(lra) ltac:(lra)).
assert (Q' := form_pos C' D' t ltac:(lra) ltac:(lra)).
  assert (C2 : 0 <= cos t^2) by apply pow2_ge_0. assert (S2 : 0 <= sin t^2) by apply pow2_ge_0.
  unfold weight, integrand, radicand, Rdiv. apply Rmult_le_compat.
  + apply Rmult_le_pos; [|now apply Rlt_le, Rinv_0_lt_compat].
  apply Rplus_le_le_0_compat; apply Rmult_le_pos; lra.
  + apply Rlt_le, Rinv_0_lt_compat, sqrt_lt_R0, radicand_pos; lra.
  + apply Rmult_le_compat.
    * apply Rplus_le_le_0_compat; apply Rmult_le_pos; lra.
    * now apply Rlt_le, Rinv_0_lt_compat.
    * apply Rplus_le_compat; apply Rmult_le_compat_r; lra.
    * apply Rinv_le_contravar; trivial. apply Rplus_le_compat; apply Rmult_le_compat_r; lra.
  + apply Rinv_le_contravar; [apply sqrt_lt_R0, radicand_pos; lra|]. apply sqrt_le_1_alt.
  rewrite !Rpow_mult_distr.
    apply Rplus_le_compat; apply Rmult_le_compat_r; trivial; apply pow_incr; lra.
Qed.

Lemma third_kind_constant x k : 0 < x -> third_kind x x k k 1 1 = k * (PI/2/x).
Proof.
intros Hx. unfold third_kind. rewrite (RInt_ext _ (fun _ => k / x)).
- rewrite RInt_const. unfold scal; simpl; unfold mult; simpl.
match goal with |- @eq _ ?l ?r => change (@eq R l r) end. field. lra.
- intros t _. assert (E : sin t^2 + cos t^2 = 1) by (generalize (sin2_cos2 t); unfold Rsqr; simpl;
  lra).
  unfold weight, integrand, radicand. rewrite !Rpow_mult_distr.
  replace (k * cos t^2 + k * sin t^2) with (k * (sin t^2 + cos t^2)) by ring.
  replace (1 * cos t^2 + 1 * sin t^2) with (sin t^2 + cos t^2) by ring.
  replace (x^2 * cos t^2 + x^2 * sin t^2) with (x^2 * (sin t^2 + cos t^2)) by ring.
  rewrite E, !Rmult_1_r, sqrt_pow2 by lra.
  match goal with |- @eq _ ?l ?r => change (@eq R l r) end. field. lra.
Qed.

(** Homogeneity *)
Lemma third_kind_scale x y A B C D r : 0 < r -> 0 < C -> 0 < D -> third_kind x y (r*A) (r*B) (r*C)
  (r*D) = third_kind x y A B C D.
Proof.
intros Hr HC HD. apply RInt_ext. intros t _.
match goal with |- @eq _ ?l ?r => change (@eq R l r) end. f_equal.
assert (P := form_pos C D t HC HD). assert (P' : 0 < r*C * cos t^2 + r*D * sin t^2).
{ replace (r*C * cos t^2 + r*D * sin t^2) with (r * (C * cos t^2 + D * sin t^2)) by ring.
now apply Rmult_lt_0_compat. }
unfold weight. field. split; lra.
Qed.

(** Between its bounds, at the end *)
Lemma third_kind_ge x y A B C D z k : 0 < x <= z -> 0 < y <= z -> 0 <= k -> 0 < C -> 0 < D -> k*C <=
  A -> k*D <= B -> k * (PI/2/z) <= third_kind x y A B C D.
Proof.
intros Hx Hy Hk HC HD HA HB.
assert (kC : 0 <= k*C) by (apply Rmult_le_pos; lra).
assert (kD : 0 <= k*D) by (apply Rmult_le_pos; lra).
apply Rle_trans with (third_kind z z (k*C) (k*D) C D).
2: apply third_kind_monotone; lra.
rewrite <- third_kind_constant by lra. right. apply RInt_ext. intros t _.
match goal with |- @eq _ ?l ?r => change (@eq R l r) end. f_equal.
assert (P := form_pos C D t HC HD). assert (P1 := form_pos 1 1 t ltac:(lra) ltac:(lra)).
unfold weight. field. split; lra.
Qed.

Lemma third_kind_le x y A B C D z k : 0 < z <= x -> 0 < z <= y -> 0 < C -> 0 < D -> 0 <= A <= k*C ->
  0 <= B <= k*D -> third_kind x y A B C D <= k * (PI/2/z).
Proof.
intros Hx Hy HC HD HA HB.
apply Rle_trans with (third_kind z z (k*C) (k*D) C D).
apply third_kind_monotone; lra.
rewrite <- third_kind_constant by lra. right. apply RInt_ext. intros t _.
match goal with |- @eq _ ?l ?r => change (@eq R l r) end. f_equal.
assert (P := form_pos C D t HC HD). assert (P1 := form_pos 1 1 t ltac:(lra) ltac:(lra)).
unfold weight. field. split; lra.
Qed.
