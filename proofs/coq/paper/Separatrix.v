(** Proposition 3 of the paper.
    1. On the separatrix c = 0 the defect e0 exists and is unique: F(0,e) = 2 pi has exactly one solution in (0, pi/2), for every body; and
         2 arctan exp (-pi/I) < e0 < 2 arctan exp (-pi sqrt (ab)),   I the geometric constant.
    2. A perfect twist F(c0,0) = 2 pi with 0 < c0 < a exists if and only if J < 2, and c0 is then unique. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Polhode Require Theorem2.
From Polhode Require Import Theorem1 FirstEquation.
Open Scope R_scope.

(** The integral of the secant. *)
Lemma secant_integral e : 0 < e < PI/2 -> is_RInt (fun t => / cos t) 0 (PI/2 - e) (- ln (tan (e/2))).
Proof.
intros He. 
set (g := fun t => ln (cos ((PI/2 - t)/2)) - ln (sin ((PI/2 - t)/2))).
assert (V : - ln (tan (e/2)) = minus (g (PI/2 - e)) (g 0)).
{ unfold g, minus, plus, opp; simpl. replace ((PI/2 - (PI/2 - e))/2) with (e/2) by field.
  replace ((PI/2 - 0)/2) with (PI/4) by field. rewrite cos_PI4, sin_PI4.
  assert (0 < cos (e/2)) by (apply cos_gt_0; lra). assert (0 < sin (e/2)) by (apply sin_gt_0; lra).
  unfold tan, Rdiv. rewrite ln_mult, ln_Rinv; trivial. match goal with |- @eq _ ?l ?r => change (@eq R l r) end. ring. now apply Rinv_0_lt_compat. }
rewrite V. apply (is_RInt_derive (V:=R_CompleteNormedModule) g); rewrite Rmin_left, Rmax_right by lra; intros t Ht.
- assert (C : 0 < cos ((PI/2 - t)/2)) by (apply cos_gt_0; lra). assert (S : 0 < sin ((PI/2 - t)/2)) by (apply sin_gt_0; lra).
  assert (D : cos t = 2 * sin ((PI/2 - t)/2) * cos ((PI/2 - t)/2)).
  { rewrite <- sin_2a. rewrite <- sin_shift. f_equal. field. }
  assert (E := sin2_cos2 ((PI/2 - t)/2)). unfold Rsqr in E.
  unfold g. auto_derive. repeat split; trivial. rewrite D. unfold Rminus, Rdiv in *. 
  set (u := cos ((PI * / 2 + - t) * / 2)) in *. set (v := sin ((PI * / 2 + - t) * / 2)) in *.
  field_simplify_eq; [|lra]. simpl. lra.
- assert (C : 0 < cos t) by (apply cos_gt_0; lra). apply (ex_derive_continuous (fun t => / cos t)). auto_derive. lra.
Qed.

Section Separatrix.
Variables a b : R.
Hypothesis Ha : 0 < a.
Hypothesis Hb : 0 < b < 1.
Notation I := (geometric_constant a b).

Lemma geometric_constant_pos : 0 < I.
Proof. unfold geometric_constant. apply Rdiv_lt_0_compat; [lra|]. apply sqrt_lt_R0, Rmult_lt_0_compat; lra. Qed.

Lemma sqrt_ab_pos : 0 < sqrt (a*b).
Proof. apply sqrt_lt_R0, Rmult_lt_0_compat; lra. Qed.

(** The integrand on any trajectory lies between multiples of 1 / sqrt (c/b + cos^2 psi), those of the paper's limit. *)
Lemma k_lower c t : 0 < c + b * cos t ^2 -> cos t ^2 < 1 -> I * / sqrt (c/b + cos t ^2) < k a b c t.
Proof.
intros H X. assert (B := bcos2_range b Hb t). unfold k, geometric_constant. set (x := cos t ^2) in *.
assert (P : 0 < c/b + x). { replace (c/b + x) with ((c + b*x)/b) by (field; lra). apply Rdiv_lt_0_compat; lra. }
assert (E : (a + b*x)*(c + b*x) = (b*(a + b*x)) * (c/b + x)) by (field; lra).
rewrite E, (sqrt_mult_alt (b*(a+b*x))) by (apply Rmult_le_pos; lra).
assert (S : 0 < sqrt (c/b + x)) by (apply sqrt_lt_R0; lra).
assert (S1 : 0 < sqrt (b*(a+b*x))) by (apply sqrt_lt_R0, Rmult_lt_0_compat; lra).
assert (S2 : 0 < sqrt (b*(a+b))) by (apply sqrt_lt_R0, Rmult_lt_0_compat; lra).
assert (L : sqrt (b*(a+b*x)) < sqrt (b*(a+b))).
{ apply sqrt_lt_1_alt. split. apply Rmult_le_pos; lra. apply Rmult_lt_compat_l; nra. }
apply (Rmult_lt_reg_r (sqrt (c/b + x) * sqrt (b*(a+b*x)) * sqrt (b*(a+b)))). { repeat apply Rmult_lt_0_compat; lra. }
replace (_ * _) with ((1-b) * sqrt (b*(a+b*x))) by (field; lra).
replace ((1-b*x) / _ * _) with ((1-b*x) * sqrt (b*(a+b))) by (field; lra).
apply Rmult_le_0_lt_compat; nra.
Qed.

Lemma k_upper c t : 0 < c + b * cos t ^2 -> 0 < cos t ^2 -> k a b c t < / sqrt (a*b) * / sqrt (c/b + cos t ^2).
Proof.
intros H X. assert (B := bcos2_range b Hb t). unfold k. set (x := cos t ^2) in *.
assert (P : 0 < c/b + x). { replace (c/b + x) with ((c + b*x)/b) by (field; lra). apply Rdiv_lt_0_compat; lra. }
assert (E : (a + b*x)*(c + b*x) = (b*(a + b*x)) * (c/b + x)) by (field; lra).
rewrite E, (sqrt_mult_alt (b*(a+b*x))) by (apply Rmult_le_pos; lra).
assert (S : 0 < sqrt (c/b + x)) by (apply sqrt_lt_R0; lra).
assert (S1 : 0 < sqrt (b*(a+b*x))) by (apply sqrt_lt_R0, Rmult_lt_0_compat; lra).
assert (S2 := sqrt_ab_pos).
assert (BX : 0 < b * x) by (apply Rmult_lt_0_compat; lra).
assert (L : sqrt (a*b) < sqrt (b*(a+b*x))).
{ apply sqrt_lt_1_alt. split. apply Rmult_le_pos; lra. rewrite (Rmult_comm a b). apply Rmult_lt_compat_l; lra. }
apply (Rmult_lt_reg_r (sqrt (c/b + x) * sqrt (b*(a+b*x)) * sqrt (a*b))). { repeat apply Rmult_lt_0_compat; lra. }
replace ((1-b*x) / _ * _) with ((1-b*x) * sqrt (a*b)) by (field; lra).
replace (/ _ * / _ * _) with (1 * sqrt (b*(a+b*x))) by (field; lra).
apply Rmult_le_0_lt_compat; lra.
Qed.

Lemma sqrt_cos2 t : 0 < cos t -> sqrt (0/b + cos t ^2) = cos t.
Proof. intros H. replace (0/b + cos t ^2) with (cos t ^2) by (field; lra). apply sqrt_pow2. lra. Qed.

Lemma cos_inside t : 0 < t < PI/2 -> 0 < cos t /\ 0 < cos t ^2 /\ cos t ^2 < 1.
Proof.
intros Ht. assert (0 < cos t) by (apply cos_gt_0; lra). 
assert (0 < sin t) by (apply sin_gt_0; lra). assert (E := sin2_cos2 t). unfold Rsqr in E. repeat split; nra.
Qed.

(** The two bounds of F on the separatrix, by the integral of the secant. *)
Lemma secant_continuous t : 0 < cos t -> continuous (fun t => / cos t) t.
Proof. intros H. apply (ex_derive_continuous (fun t => / cos t)). auto_derive. lra. Qed.

Theorem separatrix_bounds e : 0 < e < PI/2 ->
  2 * (I * - ln (tan (e/2))) < F a b 0 e /\ F a b 0 e < 2 * (/ sqrt (a*b) * - ln (tan (e/2))).
Proof.
intros He. assert (W := secant_integral e He).
assert (Rg := regular_separatrix b e ltac:(lra) He).
assert (CS : forall m t, 0 <= t <= PI/2 - e -> continuous (fun t => scal m (/ cos t) : R) t).
{ intros m t Ht. apply (continuous_scal_r m (fun t => / cos t)). apply secant_continuous. apply cos_gt_0; lra. }
assert (CK : forall t, 0 <= t <= PI/2 - e -> continuous (k a b 0) t).
{ intros t Ht. apply k_continuous; trivial. now apply Rg. }
assert (E : forall m, m * - ln (tan (e/2)) = RInt (fun t => scal m (/ cos t)) 0 (PI/2 - e)).
{ intros m. symmetry. apply is_RInt_unique. apply (is_RInt_scal (V:=R_NormedModule)). exact W. }
unfold F. rewrite !E. split; (apply Rmult_lt_compat_l; [lra|]); apply RInt_lt.
- lra.
- exact CK.
- exact (CS I).
- intros t Ht. destruct (cos_inside t ltac:(lra)) as [C1 [C2 C3]].
  unfold scal; simpl; unfold mult; simpl. rewrite <- (sqrt_cos2 t C1) at 1. apply k_lower; trivial. apply Rg; lra.
- lra.
- exact (CS (/ sqrt (a*b))).
- exact CK.
- intros t Ht. destruct (cos_inside t ltac:(lra)) as [C1 [C2 C3]].
  unfold scal; simpl; unfold mult; simpl. rewrite <- (sqrt_cos2 t C1) at 1. apply k_upper; trivial. apply Rg; lra.
Qed.

(** The angle e with -ln tan (e/2) = y *)
Definition angle (y : R) := 2 * atan (exp (- y)).
Lemma angle_range y : 0 < y -> 0 < angle y < PI/2.
Proof.
intros Hy. unfold angle. assert (0 < exp (-y)) by apply exp_pos.
assert (exp (-y) < 1) by (rewrite <- exp_0; apply exp_increasing; lra).
assert (atan 0 < atan (exp (-y))) by (apply atan_increasing; lra). assert (atan (exp (-y)) < atan 1) by (apply atan_increasing; lra).
rewrite atan_0 in *. rewrite atan_1 in *. lra.
Qed.
Lemma angle_ln_tan y : - ln (tan (angle y/2)) = y.
Proof. unfold angle. replace (2 * atan (exp (-y)) / 2) with (atan (exp (-y))) by field. rewrite tan_atan, ln_exp. ring. Qed.

Lemma F_continuity_e c e : regular b c e -> continuity_pt (F a b c) e.
Proof. intros H. apply continuity_pt_filterlim. apply (ex_derive_continuous (F a b c)). eexists. now apply F_derive_e. Qed.

Lemma F_continuity_c c e : regular b c e -> continuity_pt (fun c => F a b c e) c.
Proof. intros H. apply continuity_pt_filterlim. apply (ex_derive_continuous (fun c => F a b c e)). eexists. now apply F_derive_c. Qed.

(** F(0,e) takes every positive value once on (0, pi/2): it goes to infinity as e goes to 0, and to 0 as e goes to pi/2. *)
Theorem separatrix_takes_each_value_once v : 0 < v ->
  exists e, angle (v/2/I) < e < angle (v/2 * sqrt (a*b)) /\ 0 < e < PI/2 /\ F a b 0 e = v /\ forall f, 0 < f < PI/2 -> F a b 0 f = v -> f = e.
Proof.
intros Hv. assert (Ip := geometric_constant_pos). assert (Sp := sqrt_ab_pos).
set (y1 := v/2/I). set (y2 := v/2 * sqrt (a*b)).
assert (Y1 : 0 < y1) by (unfold y1; apply Rdiv_lt_0_compat; [lra|exact Ip]).
assert (Y2 : 0 < y2) by (unfold y2; apply Rmult_lt_0_compat; lra).
assert (A1 := angle_range y1 Y1). assert (A2 := angle_range y2 Y2).
destruct (separatrix_bounds _ A1) as [B1 _]. destruct (separatrix_bounds _ A2) as [_ B2]. rewrite angle_ln_tan in B1, B2.
replace (2 * (I * y1)) with v in B1 by (unfold y1; field; lra).
replace (2 * (/ sqrt (a*b) * y2)) with v in B2 by (unfold y2; field; lra).
assert (Reg : forall e, 0 < e < PI/2 -> regular b 0 e) by (intros e He; apply regular_separatrix; lra).
assert (O : angle y1 < angle y2).
{ apply Rnot_le_lt. intros [L|L]. assert (N := F_decreasing_e a b Ha Hb 0 _ (angle y1) (Reg _ A2) ltac:(lra)). lra. rewrite L in B2. lra. }
destruct (Ranalysis5.IVT_interv (fun e => v - F a b 0 e) (angle y1) (angle y2)) as [e [He Ee]]; try lra.
- intros e He. apply continuity_pt_minus. apply continuity_pt_const; now intros ? ?. apply F_continuity_e, Reg; lra.
- assert (e <> angle y1) by (intros E; rewrite E in Ee; lra). assert (e <> angle y2) by (intros E; rewrite E in Ee; lra).
  exists e. split; [lra|]. split; [lra|]. split; [lra|].
  intros f Hf Ef. destruct (Rtotal_order f e) as [L|[L|L]]; trivial.
  + assert (N := F_decreasing_e a b Ha Hb 0 f e (Reg _ Hf) ltac:(lra)). lra.
  + assert (N := F_decreasing_e a b Ha Hb 0 e f (Reg e ltac:(lra)) ltac:(lra)). lra.
Qed.

(** The two limits of proposition 3.1's proof *)
Theorem separatrix_diverges : filterlim (F a b 0) (at_right 0) (Rbar_locally p_infty).
Proof.
intros P [M HM]. assert (V1 := Rmax_l M 1). assert (V2 := Rmax_r M 1).
destruct (separatrix_takes_each_value_once (Rmax M 1) ltac:(lra)) as [d [_ [Hd [Ed _]]]].
destruct Hd as [D0 D1]. exists (mkposreal d D0). intros e He Le. apply HM.
unfold ball in He; simpl in He; unfold AbsRing_ball, abs, minus, plus, opp in He; simpl in He. apply Rabs_def2 in He.
assert (N := F_decreasing_e a b Ha Hb 0 e d (regular_separatrix b e ltac:(lra) ltac:(lra)) ltac:(lra)). lra.
Qed.

Theorem separatrix_vanishes : filterlim (F a b 0) (at_left (PI/2)) (locally 0).
Proof.
apply filterlim_locally. intros v. 
destruct (separatrix_takes_each_value_once v (cond_pos v)) as [d [_ [Hd [Ed _]]]].
assert (D : 0 < PI/2 - d) by lra. exists (mkposreal _ D). intros e He Le.
unfold ball in He; simpl in He; unfold AbsRing_ball, abs, minus, plus, opp in He; simpl in He. apply Rabs_def2 in He.
change (Rabs (F a b 0 e - 0) < v). rewrite Rminus_0_r.
assert (N := F_decreasing_e a b Ha Hb 0 d e (regular_separatrix b d ltac:(lra) ltac:(lra)) ltac:(lra)).
assert (Q := F_pos a b Ha Hb 0 e (regular_separatrix b e ltac:(lra) ltac:(lra))). rewrite Rabs_right; lra.
Qed.

(** Proposition 3.1, in the defect e and in the paper's u = sin^2 e. *)
Theorem proposition_3_1 :
  exists e, 0 < e < PI/2 /\ F a b 0 e = 2*PI /\ forall f, 0 < f < PI/2 -> F a b 0 f = 2*PI -> f = e.
Proof.
assert (P := PI_RGT_0). destruct (separatrix_takes_each_value_once (2*PI) ltac:(lra)) as [e [_ H]]. now exists e.
Qed.

Theorem proposition_3_1_u :
  exists u, 0 < u < 1 /\ F a b 0 (asin (sqrt u)) = 2*PI /\ forall v, 0 < v < 1 -> F a b 0 (asin (sqrt v)) = 2*PI -> v = u.
Proof.
destruct proposition_3_1 as [e [He [E U]]].
assert (S0 : 0 < sin e) by (apply sin_gt_0; lra).
assert (S1 : sin e < 1). { rewrite <- sin_PI2. apply sin_increasing_1; lra. }
exists (sin e ^2). split; [nra|]. rewrite sqrt_pow2, asin_sin by lra. split; [exact E|].
intros v Hv Ev. 
assert (V1 : 0 < sqrt v) by (apply sqrt_lt_R0; lra). 
assert (V2 : sqrt v < 1) by (rewrite <- sqrt_1; apply sqrt_lt_1_alt; lra).
assert (SA := sin_asin (sqrt v) ltac:(lra)). assert (AB := asin_bound (sqrt v)).
assert (0 < asin (sqrt v) < PI/2).
{ split. 
  - apply Rnot_le_lt. intros N. assert (sin (asin (sqrt v)) <= sin 0) by (apply sin_incr_1; lra). rewrite sin_0 in *. lra.
  - apply Rnot_le_lt. intros N. assert (asin (sqrt v) = PI/2) by lra. rewrite H, sin_PI2 in SA. lra. }
rewrite <- (U _ H Ev), SA. rewrite pow2_sqrt; lra.
Qed.

(** e0 lies between two bounds. *)
Theorem defect_on_separatrix_bounds e : 0 < e < PI/2 -> F a b 0 e = 2*PI ->
  2 * atan (exp (- (PI/I))) < e < 2 * atan (exp (- (PI * sqrt (a*b)))).
Proof.
intros He E. assert (P := PI_RGT_0). destruct (separatrix_takes_each_value_once (2*PI) ltac:(lra)) as [f [H1 [H2 [H3 H4]]]].
rewrite (H4 e He E). replace (2*PI/2) with PI in H1 by field. exact H1.
Qed.

(** The paper's F(c,0): half the phase of a rotating body. *)
Lemma F_rotating c : F a b c 0 = Theorem2.F a b c.
Proof. unfold F, Theorem2.F. rewrite Rminus_0_r. reflexivity. Qed.

(** F(c,0) takes every value above pi J once on (0,a), and no other. *)
Theorem rotating_takes_each_value_once v : PI * Theorem2.second_constant a b < v <->
  exists c, 0 < c < a /\ F a b c 0 = v /\ forall d, 0 < d < a -> F a b d 0 = v -> d = c.
Proof.
assert (P := PI_RGT_0).
assert (Reg : forall c e, 0 < c -> e < PI/2 -> regular b c e) by (intros; apply regular_rotating; lra).
rewrite <- (Theorem2.F_at_a a b Ha Hb), <- F_rotating. split.
- intros Hv. assert (V := F_pos a b Ha Hb a 0 (Reg a 0 Ha ltac:(lra))).
  destruct (separatrix_takes_each_value_once (v+1) ltac:(lra)) as [e [_ [He [Ee _]]]].
  assert (R0 := regular_separatrix b e ltac:(lra) He).
  destruct (F_continuity_c 0 e R0 1 ltac:(lra)) as [d [Hd C]]. 
  set (c1 := Rmin (d/2) (a/2)). assert (C1 : 0 < c1) by (apply Rmin_pos; lra). assert (L1 := Rmin_l (d/2) (a/2)). assert (L2 := Rmin_r (d/2) (a/2)). fold c1 in L1, L2.
  assert (N : v < F a b c1 e).
  { specialize (C c1). simpl in C. unfold R_dist in C. rewrite Ee in C.
    assert (A : Rabs (F a b c1 e - (v+1)) < 1).
    { apply C. split. split; [exact Logic.I|lra]. rewrite Rabs_right; lra. }
    apply Rabs_def2 in A. lra. }
  assert (N2 := F_decreasing_e a b Ha Hb c1 0 e (Reg c1 0 C1 ltac:(lra)) ltac:(lra)).
  destruct (Ranalysis5.IVT_interv (fun c => v - F a b c 0) c1 a) as [c [Hc Ec]]; try lra.
  + intros c Hc. apply continuity_pt_minus. apply continuity_pt_const; now intros ? ?. apply F_continuity_c, Reg; lra.
  + assert (c <> a) by (intros E; rewrite E in Ec; lra).
    exists c. split; [lra|]. split; [lra|].
    intros f Hf Ef. destruct (Rtotal_order f c) as [L|[L|L]]; trivial.
    * assert (M := F_decreasing_c a b Ha Hb f c 0 (Reg f 0 ltac:(lra) ltac:(lra)) L). lra.
    * assert (M := F_decreasing_c a b Ha Hb c f 0 (Reg c 0 ltac:(lra) ltac:(lra)) L). lra.
- intros [c [Hc [E _]]]. rewrite <- E. apply F_decreasing_c; trivial; try lra. apply Reg; lra.
Qed.

(** Proposition 3.2 *)
Theorem proposition_3_2 : Theorem2.second_constant a b < 2 <->
  exists c, 0 < c < a /\ F a b c 0 = 2*PI /\ forall d, 0 < d < a -> F a b d 0 = 2*PI -> d = c.
Proof. rewrite <- rotating_takes_each_value_once. assert (P := PI_RGT_0). split; intros; nra. Qed.

(** Without uniqueness on the right: a perfect twist requires J < 2. *)
Theorem perfect_twist_only_if c : 0 < c < a -> F a b c 0 = 2*PI -> Theorem2.second_constant a b < 2.
Proof.
intros Hc E. assert (P := PI_RGT_0). 
assert (N := F_decreasing_c a b Ha Hb c a 0 (regular_rotating b c 0 ltac:(lra) ltac:(lra) ltac:(lra)) ltac:(lra)).
rewrite E, F_rotating, (Theorem2.F_at_a a b Ha Hb) in N. nra.
Qed.
End Separatrix.
