(** The complete elliptic integral in Gauss's form,
      I(a,b) = integral over 0..pi/2 of dt / sqrt ((a cos t)^2 + (b sin t)^2),
    is left unchanged by a step of the arithmetic-geometric mean, I(a,b) = I((a+b)/2, sqrt (ab)),
    and lies between pi/(2a) and pi/(2b); it decreases in a and in b. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
Open Scope R_scope.

Definition radicand (a b t : R) := (a * cos t)^2 + (b * sin t)^2.
Definition integrand (a b t : R) := / sqrt (radicand a b t).
Definition gauss_integral (a b : R) : R := RInt (integrand a b) 0 (PI/2).

Lemma cos_sq t : cos t * cos t = 1 - sin t * sin t.
Proof. generalize (sin2_cos2 t); unfold Rsqr; lra. Qed.

Lemma radicand_pos a b t : 0 < a -> 0 < b -> 0 < radicand a b t.
Proof.
intros Ha Hb; unfold radicand.
assert (H := cos_sq t).
destruct (Req_dec (sin t) 0) as [E|E].
- rewrite E in *. assert (cos t * cos t = 1) by lra.
  replace ((a * cos t)^2 + (b*0)^2) with (a*a*(cos t * cos t)) by ring.
  rewrite H0. nra.
- assert (0 < sin t * sin t) by (apply Rlt_0_sqr in E; exact E).
  assert (0 <= (a*cos t)^2) by apply pow2_ge_0.
  assert (0 < (b * sin t)^2). { replace ((b*sin t)^2) with ((b*b)*(sin t * sin t)) by ring.
    apply Rmult_lt_0_compat; nra. }
  lra.
Qed.

Lemma integrand_continuous a b t : 0 < a -> 0 < b -> continuous (integrand a b) t.
Proof.
intros Ha Hb. apply (ex_derive_continuous (integrand a b)).
unfold integrand, radicand. auto_derive.
assert (H := radicand_pos a b t Ha Hb). unfold radicand in H. simpl in H |- *.
split; [lra|split; [|easy]].
apply Rgt_not_eq, sqrt_lt_R0. lra.
Qed.

Lemma integrand_integrable a b x y : 0 < a -> 0 < b -> ex_RInt (integrand a b) x y.
Proof. intros Ha Hb. apply (@ex_RInt_continuous R_CompleteNormedModule). intros z _.
now apply integrand_continuous. Qed.

Lemma radicand_bounds a b t : 0 < b -> b <= a -> b^2 <= radicand a b t <= a^2.
Proof.
intros Hb Hab. unfold radicand. assert (H := cos_sq t).
replace ((a * cos t)^2 + (b * sin t)^2) with (a*a*(cos t * cos t) + b*b*(sin t*sin t)) by ring.
assert (0 <= sin t * sin t) by nra. assert (0 <= cos t * cos t) by nra.
assert (b*b <= a*a) by nra.
assert (b*b*(cos t * cos t) <= a*a*(cos t * cos t)) by (apply Rmult_le_compat_r; lra).
assert (b*b*(sin t * sin t) <= a*a*(sin t * sin t)) by (apply Rmult_le_compat_r; lra).
rewrite H in *. nra.
Qed.

Lemma integrand_bounds a b t : 0 < b -> b <= a -> / a <= integrand a b t <= / b.
Proof.
intros Hb Hab. destruct (radicand_bounds a b t Hb Hab) as [H1 H2]. unfold integrand.
assert (Hs1 : b <= sqrt (radicand a b t)).
{ apply Rle_trans with (sqrt (b^2)); [rewrite sqrt_pow2; lra | now apply sqrt_le_1_alt]. }
assert (Hs2 : sqrt (radicand a b t) <= a).
{ apply Rle_trans with (sqrt (a^2)); [now apply sqrt_le_1_alt | rewrite sqrt_pow2; lra]. }
split; apply Rinv_le_contravar; lra.
Qed.

Lemma gauss_integral_bounds a b : 0 < b -> b <= a -> PI/2 / a <= gauss_integral a b <= PI/2 / b.
Proof.
intros Hb Hab. assert (HPI := PI_RGT_0).
assert (E : forall c, PI/2/c = RInt (fun _ => / c) 0 (PI/2)).
{ intros c. rewrite RInt_const. unfold scal; simpl; unfold mult; simpl. rewrite Rminus_0_r.
reflexivity. }
assert (Hx := integrand_integrable a b 0 (PI/2)).
unfold gauss_integral; split; rewrite E; apply RInt_le.
- lra.
- apply (@ex_RInt_const R_NormedModule).
- apply Hx; lra.
- intros x _; apply integrand_bounds; lra.
- lra.
- apply Hx; lra.
- apply (@ex_RInt_const R_NormedModule).
- intros x _; apply integrand_bounds; lra.
Qed.

(** From 0 to pi, of a function that is even about pi/2 *)
Lemma integral_to_pi (g : R -> R) : (forall t, continuous g t) -> (forall t, g (PI - t) = g t) ->
  RInt g 0 PI = 2 * RInt g 0 (PI/2).
Proof.
intros C E.
assert (I : forall x y, ex_RInt g x y) by (intros; apply (@ex_RInt_continuous
  R_CompleteNormedModule); intros; apply C).
rewrite <- (RInt_Chasles g 0 (PI/2) PI) by apply I.
unfold plus; simpl. replace (2 * RInt g 0 (PI/2)) with (RInt g 0 (PI/2) + RInt g 0 (PI/2)) by ring.
f_equal.
assert (HC := RInt_comp (V:=R_CompleteNormedModule) g (fun y => PI - y) (fun _ => -1) 0 (PI/2)).
cbv beta in HC. replace (PI - 0) with PI in HC by ring.
replace (PI - PI/2) with (PI/2) in HC by field.
rewrite <- (opp_RInt_swap g PI (PI/2)) by apply I.
rewrite <- HC.
- rewrite (RInt_ext _ (fun y => scal (-1) (g y))) by (intros y _; now rewrite E).
  rewrite (RInt_scal (V:=R_CompleteNormedModule)) by apply I.
  unfold opp, scal; simpl; unfold mult; simpl.
  match goal with |- @eq _ ?l ?r => change (@eq R l r) end. ring.
- intros; apply C.
- intros x _. split; [auto_derive; auto; ring | apply continuous_const].
Qed.

Lemma gauss_integral_to_pi a b : 0 < a -> 0 < b -> RInt (integrand a b) 0 PI = 2 * gauss_integral a
  b.
Proof.
intros Ha Hb. apply integral_to_pi. intros t. now apply integrand_continuous.
intros t. unfold integrand. replace (radicand a b (PI - t)) with (radicand a b t). reflexivity.
unfold radicand. rewrite cos_minus, sin_minus, cos_PI, sin_PI. ring.
Qed.

(** Landen's angle, phi = 2 t - atan ((a-b) sin t cos t / (a cos^2 t + b sin^2 t)): it runs from 0
  to pi as t runs from 0 to
    pi/2, and (dphi/dt) times the integrand of the next step at phi is twice the integrand at t. *)
Section Landen.
Variables a b : R.
Hypothesis Ha : 0 < a.
Hypothesis Hb : 0 < b.
Let N t := (a-b) * sin t * cos t.
Let D t := a * (cos t * cos t) + b * (sin t * sin t).
Definition landen_angle t := 2*t - atan (N t / D t).
Definition landen_rate t := (a+b) * D t / radicand a b t.
Notation phi := landen_angle.
Notation dphi := landen_rate.

Lemma landen_denominator_pos t : 0 < D t.
Proof.
unfold D. rewrite cos_sq.
destruct (Req_dec (sin t) 0) as [E|E].
- rewrite E; lra.
- assert (0 < sin t * sin t) by (apply Rlt_0_sqr in E; exact E).
  assert (H1 := cos_sq t). assert (0 <= cos t * cos t) by nra.
  assert (0 < b * (sin t * sin t)) by nra.
  assert (0 <= a * (1 - sin t * sin t)) by (apply Rmult_le_pos; lra). lra.
Qed.

Lemma landen_sum_of_squares t : N t * N t + D t * D t = radicand a b t.
Proof. unfold N, D, radicand. assert (H := cos_sq t). ring [H]. Qed.

Lemma landen_angle_derive t : is_derive phi t (dphi t).
Proof.
unfold landen_angle.
assert (HD := landen_denominator_pos t). assert (HR := radicand_pos a b t Ha Hb).
assert (HND := landen_sum_of_squares t).
assert (Hq : is_derive (fun x => N x / D x) t
   (((a-b)*(cos t * cos t - sin t * sin t) * D t - N t * (2*(b-a)*sin t * cos t))/(D t)^2)).
{ unfold N, D. auto_derive. unfold D in HD; lra. unfold N, D in *. field. lra. }
evar_last.
apply (is_derive_minus (fun x => 2*x) (fun x => atan (N x / D x))).
auto_derive; [trivial|reflexivity].
apply (is_derive_comp atan (fun x => N x / D x)).
apply is_derive_atan. exact Hq.
unfold minus, plus, opp, scal; simpl; unfold mult; simpl.
unfold landen_rate. rewrite <- HND.
assert (0 < N t * N t + D t * D t) by (rewrite HND; exact HR).
apply Rminus_diag_uniq.
match goal with |- ?l = 0 => replace l with
 ((2 * (N t * N t + D t * D t) - ((a-b)*(cos t * cos t - sin t * sin t) * D t - N t * (2*(b-a)*sin t
   * cos t)) - (a+b)*D t) / (N t * N t + D t * D t)) end.
2:{ unfold Rsqr. field. split; nra. }
unfold Rdiv. apply Rmult_eq_0_compat_r.
unfold N, D. assert (Hs := cos_sq t). ring [Hs].
Qed.

Lemma squares_at_landen_angle t :
  cos (phi t)^2 = (a * cos t^2 - b * sin t^2)^2 / radicand a b t /\ sin (phi t)^2 = ((a+b) * (sin t
    * cos t))^2 / radicand a b t.
Proof.
assert (HD := landen_denominator_pos t). assert (HR := radicand_pos a b t Ha Hb).
assert (HND := landen_sum_of_squares t).
assert (Hs := cos_sq t).
unfold landen_angle. rewrite cos_minus, sin_minus, cos_atan, sin_atan.
set (q := sqrt (1 + (N t / D t)²)).
assert (Hq2 : q*q = radicand a b t / (D t * D t)).
{ unfold q. rewrite sqrt_sqrt. rewrite <- HND. unfold Rsqr. field. lra.
  unfold Rsqr. assert (0 <= N t / D t * (N t / D t)) by nra. lra. }
assert (Hq : 0 < q). { unfold q. apply sqrt_lt_R0. assert (0 <= (N t / D t)²) by apply Rle_0_sqr.
lra. }
assert (E1 : cos (2*t) * D t + sin (2*t) * N t = a * cos t^2 - b * sin t^2).
{ rewrite sin_2a, cos_2a. unfold N, D. ring [Hs]. }
assert (E2 : sin (2*t) * D t - cos (2*t) * N t = (a+b) * (sin t * cos t)).
{ rewrite sin_2a, cos_2a. unfold N, D. ring [Hs]. }
rewrite <- E1, <- E2. replace (radicand a b t) with (D t * D t * (q*q)) by (rewrite Hq2; field;
  lra). split; field; lra.
Qed.

Lemma radicand_at_landen_angle t : radicand ((a+b)/2) (sqrt (a*b)) (phi t) = ((a+b)/2 * D t)^2 /
  radicand a b t.
Proof.
assert (HR := radicand_pos a b t Ha Hb). destruct (squares_at_landen_angle t) as [C S].
unfold radicand at 1. rewrite !Rpow_mult_distr, (pow2_sqrt (a*b)) by nra. rewrite C, S.
unfold D. replace (cos t^2) with (cos t * cos t) by ring. field. lra.
Qed.

Lemma landen_integrand t : dphi t * integrand ((a+b)/2) (sqrt (a*b)) (phi t) = 2 * integrand a b t.
Proof.
assert (HD := landen_denominator_pos t). assert (HR := radicand_pos a b t Ha Hb).
unfold integrand. rewrite radicand_at_landen_angle.
assert (Hsq : 0 < sqrt (radicand a b t)) by now apply sqrt_lt_R0.
assert (E : sqrt (((a+b)/2 * D t)^2 / radicand a b t) = (a+b)/2 * D t / sqrt (radicand a b t)).
{ rewrite sqrt_div_alt by lra. rewrite sqrt_pow2. reflexivity. apply Rmult_le_pos; lra. }
rewrite E. unfold landen_rate.
rewrite <- (sqrt_sqrt (radicand a b t)) at 1 by lra.
field. repeat split; lra.
Qed.

Lemma landen_substitution (g : R -> R) : (forall t, continuous g t) -> RInt (fun t => dphi t * g
  (phi t)) 0 (PI/2) = RInt g 0 PI.
Proof.
intros C. assert (HC := RInt_comp (V:=R_CompleteNormedModule) g phi dphi 0 (PI/2)).
assert (P0 : phi 0 = 0). { unfold landen_angle, N, D. rewrite sin_0, cos_0.
  replace ((a-b)*0*1/(a*(1*1)+b*(0*0))) with 0 by (field; lra). rewrite atan_0. ring. }
assert (P1 : phi (PI/2) = PI). { unfold landen_angle, N, D. rewrite sin_PI2, cos_PI2.
  replace ((a-b)*1*0/(a*(0*0)+b*(1*1))) with 0 by (field; lra). rewrite atan_0. field. }
rewrite P0, P1 in HC. apply HC.
- intros x _. apply C.
- intros x _. split. apply landen_angle_derive.
  apply (ex_derive_continuous dphi). unfold landen_rate, D, radicand. auto_derive.
  assert (H := radicand_pos a b x Ha Hb). unfold radicand in H. simpl in H |- *. lra.
Qed.

Lemma gauss_invariance : gauss_integral a b = gauss_integral ((a+b)/2) (sqrt (a*b)).
Proof.
assert (Ha1 : 0 < (a+b)/2) by lra.
assert (Hb1 : 0 < sqrt (a*b)) by (apply sqrt_lt_R0; nra).
assert (HC := landen_substitution (integrand ((a+b)/2) (sqrt (a*b))) ltac:(intros; now apply
  integrand_continuous)).
rewrite gauss_integral_to_pi in HC by assumption.
assert (HL : RInt (fun t => dphi t * integrand ((a+b)/2) (sqrt (a*b)) (phi t)) 0 (PI/2) = 2 *
  gauss_integral a b); [|lra].
rewrite (RInt_ext _ (fun t => scal 2 (integrand a b t))) by (intros x _; apply landen_integrand).
rewrite (RInt_scal (V:=R_CompleteNormedModule)) by (now apply integrand_integrable). reflexivity.
Qed.
End Landen.

Lemma gauss_integral_decreasing a b A B : 0 < a -> 0 < b -> a <= A -> b <= B -> gauss_integral A B
  <= gauss_integral a b.
Proof.
intros Ha Hb HA HB. assert (HPI := PI_RGT_0).
unfold gauss_integral. apply RInt_le; try lra; try (apply integrand_integrable; lra).
intros x _. unfold integrand. apply Rinv_le_contravar.
- apply sqrt_lt_R0, radicand_pos; lra.
- apply sqrt_le_1_alt. unfold radicand. rewrite !Rpow_mult_distr.
  assert (0 <= cos x ^2) by apply pow2_ge_0. assert (0 <= sin x ^2) by apply pow2_ge_0.
  apply Rplus_le_compat; apply Rmult_le_compat_r; try assumption; nra.
Qed.

Lemma gauss_integral_ge a b c : 0 < a -> 0 < b -> a <= c -> b <= c -> PI/2/c <= gauss_integral a b.
Proof.
intros. apply Rle_trans with (gauss_integral c c).
- apply gauss_integral_bounds; lra.
- apply gauss_integral_decreasing; lra.
Qed.

Lemma gauss_integral_le a b c : 0 < c -> c <= a -> c <= b -> gauss_integral a b <= PI/2/c.
Proof.
intros. apply Rle_trans with (gauss_integral c c).
- apply gauss_integral_decreasing; lra.
- apply gauss_integral_bounds; lra.
Qed.

(** Steps that are rounded up, or down: what a certificate consists of. *)
Lemma agm_step_ge A B A' B' c : 0 < A -> 0 < B -> 0 < A' -> 0 < B' ->
  A + B <= 2 * A' -> A * B <= B' * B' -> c <= gauss_integral A' B' -> c <= gauss_integral A B.
Proof.
intros HA HB HA' HB' H1 H2 H3. rewrite gauss_invariance by assumption.
apply Rle_trans with (1 := H3). apply gauss_integral_decreasing; try lra.
- apply sqrt_lt_R0; nra.
- apply Rle_trans with (sqrt (B'*B')). now apply sqrt_le_1_alt. rewrite sqrt_square; lra.
Qed.

Lemma agm_step_le A B A' B' c : 0 < A -> 0 < B -> 0 < A' -> 0 < B' ->
  2 * A' <= A + B -> B' * B' <= A * B -> gauss_integral A' B' <= c -> gauss_integral A B <= c.
Proof.
intros HA HB HA' HB' H1 H2 H3. rewrite gauss_invariance by assumption.
apply Rle_trans with (2 := H3). apply gauss_integral_decreasing; try lra.
apply Rle_trans with (sqrt (B'*B')). rewrite sqrt_square; lra. now apply sqrt_le_1_alt.
Qed.
