(** The paper's limit a -> infinity, b -> 0 with ab -> chi and c/b = beta fixed, equations (33)-(38), with its rate: for every body the defect
    epsilon(c) at c = b beta is within sqrt (1+beta) pi max (|sqrt (ab) - sqrt chi|, |1/I - sqrt chi|) of the limit's e.
    Where the first implicit equation holds, so for every beta >= 0, e is given by
      F (pi/2 - e | 1/(1+beta)) = pi sqrt (chi (1+beta)),   Legendre's integral of the first kind,
    that is e = pi/2 - am (pi sqrt (chi (1+beta)) | 1/(1+beta)). For all -1 < beta < 0, beyond the turning points as well,
      e = pi/2 - arcsin (sqrt (1+beta) sn (pi sqrt chi | 1+beta)). *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Polhode Require Import Theorem1 FirstEquation Separatrix.
From Polhode Require HalfPhase Phase Uniqueness Symmetry Oscillation Curve FirstBranch.
Open Scope R_scope.

(** The integral of equation (34): E = integral over 0 .. pi/2 - e of d psi / sqrt (beta + cos^2 psi) *)
Definition limit_integral (beta e : R) : R := RInt (fun t => / sqrt (beta + cos t ^2)) 0 (PI/2 - e).
(** Where it is regular, that is, where cos theta stays positive: the region of the first implicit equation. *)
Definition limit_regular (beta e : R) : Prop := e < PI/2 /\ forall t, 0 <= t <= PI/2 - e -> 0 < beta + cos t ^2.
(** Legendre's F (phi | m), equation (37) *)
Definition legendre_F (phi m : R) : R := RInt (fun t => / sqrt (1 - m * sin t ^2)) 0 phi.

Lemma limit_regular_iff b beta e : 0 < b -> (limit_regular beta e <-> regular b (beta * b) e).
Proof.
intros Hb. split; intros [H1 H2]; split; trivial; intros t Ht; specialize (H2 t Ht).
- replace (beta*b + b * cos t ^2) with (b * (beta + cos t ^2)) by ring. now apply Rmult_lt_0_compat.
- apply (Rmult_lt_reg_l b); trivial. rewrite Rmult_0_r. replace (b * (beta + cos t ^2)) with (beta*b + b * cos t ^2) by ring. exact H2.
Qed.

Lemma limit_kernel_continuous beta t : 0 < beta + cos t ^2 -> continuous (fun t => / sqrt (beta + cos t ^2)) t.
Proof.
intros H. apply (ex_derive_continuous (fun t => / sqrt (beta + cos t ^2))). auto_derive. simpl in H.
split; [exact H|split; [|trivial]]. apply Rgt_not_eq, sqrt_lt_R0, H.
Qed.

Lemma limit_integrable beta e s t : limit_regular beta e -> 0 <= s -> s <= t -> t <= PI/2 - e -> ex_RInt (fun t => / sqrt (beta + cos t ^2)) s t.
Proof.
intros [H1 H2] Hs Hst Ht. apply (@ex_RInt_continuous R_CompleteNormedModule). intros z. rewrite Rmin_left, Rmax_right by lra. intros Hz.
apply limit_kernel_continuous, H2; lra.
Qed.

Lemma limit_integral_pos beta e : limit_regular beta e -> 0 < limit_integral beta e.
Proof.
intros [H1 H2]. unfold limit_integral. apply RInt_gt_0; [lra| |].
- intros t Ht. apply Rinv_0_lt_compat, sqrt_lt_R0, H2; lra.
- intros t Ht. apply limit_kernel_continuous, H2; lra.
Qed.

Lemma limit_integral_decreasing beta d e : limit_regular beta d -> d < e < PI/2 -> limit_integral beta e < limit_integral beta d.
Proof.
intros H He. unfold limit_integral. set (f := fun t => / sqrt (beta + cos t ^2)).
rewrite <- (RInt_Chasles f 0 (PI/2 - e) (PI/2 - d)).
2: apply (limit_integrable beta d); trivial; lra. 2: apply (limit_integrable beta d); trivial; lra.
unfold plus; simpl. assert (0 < RInt f (PI/2 - e) (PI/2 - d)); [|lra].
destruct H as [H1 H2]. apply RInt_gt_0; [lra| |]; unfold f.
- intros t Ht. apply Rinv_0_lt_compat, sqrt_lt_R0, H2; lra.
- intros t Ht. apply limit_kernel_continuous, H2; lra.
Qed.

(** Equation (35): the same in Legendre's form *)
Theorem legendre_form beta e : -1 < beta -> limit_regular beta e ->
  limit_integral beta e = / sqrt (1+beta) * legendre_F (PI/2 - e) (1/(1+beta)).
Proof.
intros Hbeta H. assert (S : 0 < sqrt (1+beta)) by (apply sqrt_lt_R0; lra).
unfold limit_integral, legendre_F. set (f := fun t => / sqrt (beta + cos t ^2)).
rewrite (RInt_ext (fun t => / sqrt (1 - 1/(1+beta) * sin t ^2)) (fun t => scal (sqrt (1+beta)) (f t))).
- rewrite (RInt_scal (V:=R_CompleteNormedModule)) by (apply (limit_integrable beta e); trivial; destruct H; lra).
  assert (Z : forall q : R, q = / sqrt (1+beta) * (sqrt (1+beta) * q)) by (intros q; field; lra). apply Z.
- destruct H as [H1 H2]. rewrite Rmin_left, Rmax_right by lra. intros t Ht. assert (P := H2 t ltac:(lra)).
  unfold f, scal; simpl; unfold mult; simpl. change (cos t * (cos t * 1)) with (cos t ^2). change (sin t * (sin t * 1)) with (sin t ^2).
  assert (E : 1 - 1/(1+beta) * sin t ^2 = (beta + cos t ^2) / (1+beta)).
  { generalize (sin2_cos2 t). unfold Rsqr. intros E. replace (cos t ^2) with (1 - sin t ^2) by (simpl; lra). field. lra. }
  assert (S2 := sqrt_lt_R0 _ P). rewrite E, sqrt_div_alt by lra. match goal with |- @eq _ ?l ?r => change (@eq R l r) end. field. lra.
Qed.

(** F of a body between multiples of the limit's integral *)
Lemma k_lower_weak a b c t : 0 < a -> 0 < b < 1 -> 0 < c/b + cos t ^2 -> geometric_constant a b * / sqrt (c/b + cos t ^2) <= k a b c t.
Proof.
intros Ha Hb P. assert (B := bcos2_range b Hb t). assert (X := cos2_range t). unfold k, geometric_constant. set (x := cos t ^2) in *.
assert (E : (a + b*x)*(c + b*x) = (b*(a + b*x)) * (c/b + x)) by (field; lra).
rewrite E, (sqrt_mult_alt (b*(a+b*x))) by (apply Rmult_le_pos; lra).
assert (S : 0 < sqrt (c/b + x)) by (apply sqrt_lt_R0; lra).
assert (S1 : 0 < sqrt (b*(a+b*x))) by (apply sqrt_lt_R0, Rmult_lt_0_compat; lra).
assert (S2 : 0 < sqrt (b*(a+b))) by (apply sqrt_lt_R0, Rmult_lt_0_compat; lra).
assert (BX : b*x <= b) by (rewrite <- (Rmult_1_r b) at 2; apply Rmult_le_compat_l; lra).
assert (L : sqrt (b*(a+b*x)) <= sqrt (b*(a+b))) by (apply sqrt_le_1_alt, Rmult_le_compat_l; lra).
apply (Rmult_le_reg_r (sqrt (c/b + x) * sqrt (b*(a+b*x)) * sqrt (b*(a+b)))). { repeat apply Rmult_lt_0_compat; lra. }
replace (_ * _) with ((1-b) * sqrt (b*(a+b*x))) by (field; lra).
replace ((1-b*x) / _ * _) with ((1-b*x) * sqrt (b*(a+b))) by (field; lra).
apply Rmult_le_compat; lra.
Qed.

Lemma k_upper_weak a b c t : 0 < a -> 0 < b < 1 -> 0 < c/b + cos t ^2 -> k a b c t <= / sqrt (a*b) * / sqrt (c/b + cos t ^2).
Proof.
intros Ha Hb P. assert (B := bcos2_range b Hb t). unfold k. set (x := cos t ^2) in *.
assert (E : (a + b*x)*(c + b*x) = (b*(a + b*x)) * (c/b + x)) by (field; lra).
rewrite E, (sqrt_mult_alt (b*(a+b*x))) by (apply Rmult_le_pos; lra).
assert (S : 0 < sqrt (c/b + x)) by (apply sqrt_lt_R0; lra).
assert (S1 : 0 < sqrt (b*(a+b*x))) by (apply sqrt_lt_R0, Rmult_lt_0_compat; lra).
assert (S2 := sqrt_ab_pos a b Ha Hb).
assert (L : sqrt (a*b) <= sqrt (b*(a+b*x))).
{ apply sqrt_le_1_alt. rewrite (Rmult_comm a b). apply Rmult_le_compat_l; lra. }
apply (Rmult_le_reg_r (sqrt (c/b + x) * sqrt (b*(a+b*x)) * sqrt (a*b))). { repeat apply Rmult_lt_0_compat; lra. }
replace ((1-b*x) / _ * _) with ((1-b*x) * sqrt (a*b)) by (field; lra).
replace (/ _ * / _ * _) with (1 * sqrt (b*(a+b*x))) by (field; lra).
apply Rmult_le_compat; lra.
Qed.

Theorem F_limit_bounds a b beta e : 0 < a -> 0 < b < 1 -> limit_regular beta e ->
  2 * (geometric_constant a b * limit_integral beta e) <= F a b (beta*b) e <= 2 * (/ sqrt (a*b) * limit_integral beta e).
Proof.
intros Ha Hb H. assert (Rg := proj1 (limit_regular_iff b beta e ltac:(lra)) H). assert (He : e < PI/2) by apply H.
set (f := fun t => / sqrt (beta + cos t ^2)).
assert (FI : ex_RInt f 0 (PI/2 - e)) by (apply (limit_integrable beta e); trivial; lra).
assert (KI : ex_RInt (k a b (beta*b)) 0 (PI/2 - e)) by (apply (k_integrable a b Ha Hb (beta*b) e); trivial; lra).
assert (E : forall m, m * limit_integral beta e = RInt (fun t => scal m (f t)) 0 (PI/2 - e)).
{ intros m. rewrite (RInt_scal (V:=R_CompleteNormedModule)) by exact FI. reflexivity. }
assert (BB : beta*b/b = beta) by (field; lra).
unfold F. rewrite !E. split; (apply Rmult_le_compat_l; [lra|]); apply RInt_le; try lra; try exact KI; try (apply (@ex_RInt_scal R_NormedModule); exact FI).
- intros t Ht. unfold scal; simpl; unfold mult; simpl. unfold f. assert (P := proj2 H t ltac:(lra)).
  assert (Q := k_lower_weak a b (beta*b) t Ha Hb). rewrite BB in Q. now apply Q.
- intros t Ht. unfold scal; simpl; unfold mult; simpl. unfold f. assert (P := proj2 H t ltac:(lra)).
  assert (Q := k_upper_weak a b (beta*b) t Ha Hb). rewrite BB in Q. now apply Q.
Qed.

(** Hence for a point (c,e) of the first implicit equation: pi sqrt (ab) <= E (c/b, e) <= pi / I, for every body. *)
Theorem solution_sandwich a b beta e : 0 < a -> 0 < b < 1 -> limit_regular beta e -> F a b (beta*b) e = 2*PI ->
  PI * sqrt (a*b) <= limit_integral beta e <= PI / geometric_constant a b.
Proof.
intros Ha Hb H E. destruct (F_limit_bounds a b beta e Ha Hb H) as [L U]. rewrite E in L, U.
assert (I0 := geometric_constant_pos a b Ha Hb). assert (S := sqrt_ab_pos a b Ha Hb). split.
- apply (Rmult_le_reg_r (/ sqrt (a*b))). now apply Rinv_0_lt_compat.
  replace (PI * sqrt (a*b) * / sqrt (a*b)) with PI by (field; lra). lra.
- apply (Rmult_le_reg_r (geometric_constant a b)); trivial.
  replace (PI / geometric_constant a b * geometric_constant a b) with PI by (field; lra). lra.
Qed.

(** The rate, and that it tends to 0. *)
Definition rate (a b chi : R) : R := PI * Rmax (Rabs (sqrt (a*b) - sqrt chi)) (Rabs (/ geometric_constant a b - sqrt chi)).
Theorem rate_vanishes chi d : 0 < chi -> 0 < d -> exists m, 0 < m /\
  forall a b, 0 < a -> 0 < b < 1 -> b < m -> Rabs (a*b - chi) < m -> rate a b chi < d.
Proof.
intros Hchi Hd. assert (P := PI_RGT_0). set (q := d / PI). assert (Q : 0 < q) by (apply Rdiv_lt_0_compat; lra).
assert (C : continuity_2d_pt (fun p b => sqrt (p + b*b) * / (1 - b)) chi 0).
{ apply continuity_2d_pt_mult.
  - apply (continuity_1d_2d_pt_comp sqrt (fun p b => p + b*b)). apply continuity_pt_sqrt; lra.
    apply continuity_2d_pt_plus. apply continuity_2d_pt_id1. apply continuity_2d_pt_mult; apply continuity_2d_pt_id2.
  - apply continuity_2d_pt_inv; [|lra].
    apply (continuity_1d_2d_pt_comp (fun b => 1 - b) (fun _ b => b)). 2: apply continuity_2d_pt_id2.
    apply continuity_pt_filterlim, (ex_derive_continuous (fun s => 1 - s)). auto_derive; trivial. }
destruct (C (mkposreal q Q)) as [m1 N1]. simpl in N1. assert (M1 := cond_pos m1).
destruct (continuity_pt_sqrt chi (Rlt_le _ _ Hchi) q Q) as [m2 [M2 N2]].
exists (Rmin m1 m2). split; [apply Rmin_pos; lra|]. assert (L1 := Rmin_l m1 m2). assert (L2 := Rmin_r m1 m2).
intros a b Ha Hb Hm Hab. unfold rate. apply (Rmult_lt_reg_l (/ PI)); [now apply Rinv_0_lt_compat|].
rewrite <- Rmult_assoc, Rinv_l, Rmult_1_l by lra. apply Rlt_le_trans with q; [|unfold q; right; field; lra]. apply Rmax_lub_lt.
- destruct (Req_dec chi (a*b)) as [<-|Ne]. rewrite Rminus_eq_0, Rabs_R0. exact Q.
  apply N2. split. split; [exact Logic.I|exact Ne]. simpl. unfold R_dist. lra.
- specialize (N1 (a*b) b ltac:(lra)). rewrite Rminus_0_r, Rabs_right in N1 by lra. specialize (N1 ltac:(lra)).
  replace (sqrt (chi + 0*0) * / (1 - 0)) with (sqrt chi) in N1. 2:{ replace (chi + 0*0) with chi by ring. field. }
  unfold geometric_constant. replace (/ ((1 - b) / sqrt (b*(a+b)))) with (sqrt (a*b + b*b) * / (1 - b)); [exact N1|].
  replace (a*b + b*b) with (b*(a+b)) by ring. assert (0 < sqrt (b*(a+b))) by (apply sqrt_lt_R0, Rmult_lt_0_compat; lra). field. lra.
Qed.
(** What lies between pi sqrt (ab) and pi/I is within the rate of pi sqrt chi. *)
Lemma within_rate a b chi v : PI * sqrt (a*b) <= v <= PI / geometric_constant a b -> Rabs (v - PI * sqrt chi) <= rate a b chi.
Proof.
intros H. assert (P := PI_RGT_0). unfold rate, Rdiv in *. set (p := sqrt (a*b)) in *. set (q := / geometric_constant a b) in *. set (s := sqrt chi) in *.
assert (L := Rmax_l (Rabs (p - s)) (Rabs (q - s))). assert (U := Rmax_r (Rabs (p - s)) (Rabs (q - s))). set (m := Rmax (Rabs (p - s)) (Rabs (q - s))) in *.
assert (A := Rle_abs (q - s)). assert (B := Rle_abs (- (p - s))). rewrite Rabs_Ropp in B.
apply Rabs_le. split; nra.
Qed.

(** * The branch of the first implicit equation *)
(** It moves e by at most sqrt (1+beta) times what the limit's integral changes. *)
Lemma limit_integral_apart beta d e : -1 < beta -> limit_regular beta d -> d <= e < PI/2 ->
  e - d <= sqrt (1+beta) * (limit_integral beta d - limit_integral beta e).
Proof.
intros Hbeta H He. assert (S : 0 < sqrt (1+beta)) by (apply sqrt_lt_R0; lra). unfold limit_integral. set (f := fun t => / sqrt (beta + cos t ^2)).
rewrite <- (RInt_Chasles f 0 (PI/2 - e) (PI/2 - d)).
2: apply (limit_integrable beta d); trivial; lra. 2: apply (limit_integrable beta d); trivial; lra.
unfold plus; simpl. set (v := RInt f 0 (PI/2 - e)). assert (Z : forall p q : R, p + q - p = q) by (intros; ring). rewrite Z.
assert (I : RInt (fun _ => / sqrt (1+beta)) (PI/2 - e) (PI/2 - d) <= RInt f (PI/2 - e) (PI/2 - d)).
{ apply RInt_le; [lra|apply (ex_RInt_const (V:=R_NormedModule))|apply (limit_integrable beta d); trivial; lra|].
  intros t Ht. unfold f. destruct H as [_ H]. assert (P := H t ltac:(lra)). apply Rinv_le_contravar; [now apply sqrt_lt_R0|].
  apply sqrt_le_1_alt. assert (C := cos2_range t). lra. }
rewrite (RInt_const (V:=R_CompleteNormedModule)) in I. unfold scal in I; simpl in I; unfold mult in I; simpl in I.
apply (Rmult_le_compat_l (sqrt (1+beta))) in I; [|lra].
replace (sqrt (1+beta) * ((PI/2 - d - (PI/2 - e)) * / sqrt (1+beta))) with (e - d) in I by (field; lra). exact I.
Qed.
(** Equations (33)-(36), for a solution f of the first implicit equation. *)
Theorem limit_on_first_branch a b chi beta e f : 0 < a -> 0 < b < 1 -> -1 < beta -> limit_regular beta e -> limit_integral beta e = PI * sqrt chi ->
  regular b (beta*b) f -> F a b (beta*b) f = 2*PI -> Rabs (f - e) <= sqrt (1+beta) * rate a b chi.
Proof.
intros Ha Hb Hbeta He E Rf Ef. assert (Hf := proj2 (limit_regular_iff b beta f ltac:(lra)) Rf).
assert (W := within_rate a b chi _ (solution_sandwich a b beta f Ha Hb Hf Ef)). rewrite <- E in W. assert (S := sqrt_pos (1+beta)).
apply Rle_trans with (sqrt (1+beta) * Rabs (limit_integral beta f - limit_integral beta e)); [|now apply Rmult_le_compat_l].
destruct (Rle_or_lt f e) as [L|L].
- assert (A := limit_integral_apart beta f e Hbeta Hf (conj L (proj1 He))). rewrite Rabs_left1 by lra.
  apply Rle_trans with (2 := Rmult_le_compat_l _ _ _ S (Rle_abs _)). lra.
- assert (A := limit_integral_apart beta e f Hbeta He (conj (Rlt_le _ _ L) (proj1 Hf))). rewrite Rabs_pos_eq by lra.
  rewrite Rabs_minus_sym. apply Rle_trans with (2 := Rmult_le_compat_l _ _ _ S (Rle_abs _)). lra.
Qed.
(** The same for the motions: epsilon(c), on the separatrix and for the rotating motions. *)
Theorem limit_formula_rotating a b chi beta e eps : 0 < a -> 0 < b < 1 -> 0 <= beta -> limit_regular beta e -> limit_integral beta e = PI * sqrt chi ->
  Curve.curve_C a b (beta*b) eps -> Rabs (eps - e) <= sqrt (1+beta) * rate a b chi.
Proof.
intros Ha Hb Hbeta He E C. destruct (FirstBranch.curve_C_non_negative a b Ha Hb (beta*b) eps) as [R Q]; [nra|exact C|].
apply limit_on_first_branch; trivial. lra.
Qed.

(** A function whose derivative is not below that of another grows at least as much. *)
Lemma grows_more (f g df dg : R -> R) s t : (forall z, is_derive f z (df z)) -> (forall z, is_derive g z (dg z)) -> (forall z, s <= z <= t -> df z <= dg z) ->
  s <= t -> f t - f s <= g t - g s.
Proof.
intros Df Dg L [H| ->]; [|lra]. destruct (MVT_gen (fun z => g z - f z) s t (fun z => dg z - df z)) as [z [Hz E]].
- intros z _. apply (is_derive_minus (V:=R_NormedModule) g f); [apply Dg|apply Df].
- intros z _. apply continuity_pt_filterlim, (ex_derive_continuous (fun z => g z - f z)). eexists. apply (is_derive_minus (V:=R_NormedModule) g f); [apply Dg|apply Df].
- rewrite Rmin_left, Rmax_right in Hz by lra. assert (Q := L z Hz). simpl in E. nra.
Qed.

(** The Gudermannian, and artanh: arcsin s = gd (artanh s). *)
Definition gd (y : R) : R := 2 * atan (exp y) - PI/2.
Definition artanh (s : R) : R := ln ((1 + s) / (1 - s)) / 2.
Lemma exp_artanh s : -1 < s < 1 -> exp (artanh s) * exp (artanh s) = (1 + s) / (1 - s).
Proof.
intros H. rewrite <- exp_plus. unfold artanh. replace (ln ((1 + s) / (1 - s)) / 2 + ln ((1 + s) / (1 - s)) / 2) with (ln ((1 + s) / (1 - s))) by field.
apply exp_ln, Rdiv_lt_0_compat; lra.
Qed.
Lemma gd_range y : - PI/2 < gd y < PI/2.
Proof.
unfold gd. assert (B := atan_bound (exp y)). assert (P := exp_pos y). assert (A := atan_increasing 0 (exp y) P). rewrite atan_0 in A. lra.
Qed.
Theorem gd_artanh s : -1 < s < 1 -> asin s = gd (artanh s).
Proof.
intros H. assert (E := exp_artanh s H). set (q := exp (artanh s)) in *. assert (R := gd_range (artanh s)).
assert (Q : sin (gd (artanh s)) = s).
{ unfold gd. fold q. rewrite sin_minus, sin_PI2, cos_PI2, Rmult_0_r, Rmult_1_r. replace (0 - cos (2 * atan q)) with (- cos (2 * atan q)) by ring.
  rewrite cos_2a_cos, cos_atan. assert (S : 0 < 1 + Rsqr q) by (unfold Rsqr; nra). assert (S2 := sqrt_lt_R0 _ S). assert (S3 := sqrt_sqrt _ (Rlt_le _ _ S)).
  replace (- (2 * (1 / sqrt (1 + Rsqr q)) * (1 / sqrt (1 + Rsqr q)) - 1)) with (1 - 2 / (sqrt (1 + Rsqr q) * sqrt (1 + Rsqr q))) by (field; lra).
  rewrite S3. unfold Rsqr. rewrite E. field. lra. }
rewrite <- Q at 1. apply asin_sin. lra.
Qed.
Lemma gd_derive y : is_derive gd y (/ cosh y).
Proof.
assert (P := exp_pos y). unfold gd. evar_last.
{ apply (is_derive_minus (V:=R_NormedModule) (fun y => 2 * atan (exp y)) (fun _ => PI/2)); [|apply (is_derive_const (K:=R_AbsRing) (V:=R_NormedModule))].
  apply (is_derive_scal (fun y => atan (exp y)) y 2). apply (is_derive_comp atan exp); [apply is_derive_atan|apply is_derive_exp]. }
unfold minus, plus, opp, zero, scal; simpl; unfold mult; simpl. unfold cosh. rewrite exp_Ropp. unfold Rsqr.
match goal with |- @eq _ ?l ?r => change (@eq R l r) end. field. nra.
Qed.
Lemma cosh_at_least_1 y : 1 <= cosh y.
Proof. unfold cosh. assert (P := exp_pos y). rewrite exp_Ropp. apply (Rmult_le_reg_r (2 * exp y)); [lra|]. replace (_ / 2 * _) with (exp y * exp y + 1) by (field; lra). assert (Q := pow2_ge_0 (exp y - 1)). simpl in Q. lra. Qed.
Lemma gd_apart x y : x <= y -> gd y - gd x <= y - x.
Proof.
intros L. apply (grows_more gd (fun z => z) (fun z => / cosh z) (fun _ => 1)); trivial.
- apply gd_derive.
- intros z. apply (is_derive_id (K:=R_AbsRing)).
- intros z _. assert (C := cosh_at_least_1 z). rewrite <- Rinv_1. apply Rinv_le_contravar; lra.
Qed.
Lemma gd_increases x y : x < y -> gd x < gd y.
Proof. intros L. unfold gd. assert (A := atan_increasing _ _ (exp_increasing _ _ L)). lra. Qed.
Lemma cosh_artanh s : -1 < s < 1 -> / sqrt (1 - s * s) = cosh (artanh s).
Proof.
intros H. assert (E := exp_artanh s H). assert (P := exp_pos (artanh s)). set (q := exp (artanh s)) in *.
assert (S : 0 < 1 - s*s) by nra. assert (S1 := sqrt_lt_R0 _ S). assert (S2 := sqrt_sqrt _ (Rlt_le _ _ S)).
assert (Q : sqrt (1 - s*s) * q = 1 + s).
{ apply Rsqr_inj; [apply Rmult_le_pos; lra|lra|]. unfold Rsqr. replace (sqrt (1 - s*s) * q * (sqrt (1 - s*s) * q)) with ((sqrt (1 - s*s) * sqrt (1 - s*s)) * (q * q)) by ring. rewrite S2, E. field. lra. }
unfold cosh. rewrite exp_Ropp. fold q. apply (Rmult_eq_reg_r (2 * q * sqrt (1 - s*s))); [|apply Rgt_not_eq, Rmult_lt_0_compat; lra].
replace (/ sqrt (1 - s*s) * (2 * q * sqrt (1 - s*s))) with (2 * q) by (field; lra).
replace ((q + / q) / 2 * (2 * q * sqrt (1 - s*s))) with (q * (sqrt (1 - s*s) * q) + sqrt (1 - s*s)) by (field; lra). rewrite Q.
apply (Rmult_eq_reg_r q); [|lra]. replace ((q * (1 + s) + sqrt (1 - s*s)) * q) with (q * q * (1 + s) + sqrt (1 - s*s) * q) by ring. rewrite Q.
replace (2 * q * q) with (2 * (q * q)) by ring. rewrite E. field. lra.
Qed.
Lemma cosh_le x y : 0 <= x <= y -> cosh x <= cosh y.
Proof.
intros [H1 [H2| ->]]; [|lra]. unfold cosh. assert (E := exp_increasing _ _ H2). assert (P := exp_pos x). rewrite !exp_Ropp.
assert (1 <= exp x). { rewrite <- exp_0. destruct H1 as [H1| <-]; [left; now apply exp_increasing|lra]. }
assert (Q : exp x + / exp x <= exp y + / exp y); [|lra]. apply (Rmult_le_reg_r (exp x * exp y)); [nra|].
replace ((exp x + / exp x) * (exp x * exp y)) with (exp x * exp x * exp y + exp y) by (field; lra).
replace ((exp y + / exp y) * (exp x * exp y)) with (exp x * (exp y * exp y) + exp x) by (field; lra).
assert (0 <= (exp y - exp x) * (exp x * exp y - 1)) by (apply Rmult_le_pos; [lra|nra]). lra.
Qed.

(** The limit's e exists for every beta >= 0; on the separatrix, beta = 0, it is pi/2 - gd (pi sqrt chi). *)
Lemma artanh_sin_derive t : -1 < sin t < 1 -> is_derive (fun t => artanh (sin t)) t (/ cos t).
Proof.
intros H. assert (E := sin2_cos2 t). unfold Rsqr in E. assert (C : cos t <> 0) by (intros Z; rewrite Z in E; nra).
unfold artanh. auto_derive. { repeat split; try lra. apply Rdiv_lt_0_compat; lra. }
assert (cos t * cos t = (1 + sin t) * (1 - sin t)) by lra. apply (Rmult_eq_reg_r (cos t)); trivial. rewrite Rinv_l by trivial.
match goal with |- ?l = _ => replace l with (cos t * cos t / ((1 + sin t) * (1 - sin t))) by (field; repeat split; lra) end. rewrite H0. field. lra.
Qed.
Theorem limit_on_separatrix v : 0 < v -> limit_regular 0 (PI/2 - gd v) /\ limit_integral 0 (PI/2 - gd v) = v.
Proof.
intros Hv. assert (B0 := gd_range v). assert (P := gd_increases 0 v Hv).
assert (G0 : gd 0 = 0) by (unfold gd; rewrite exp_0, atan_1; field). rewrite G0 in P.
assert (Co : forall t, 0 <= t <= gd v -> 0 < cos t) by (intros t Ht; apply cos_gt_0; lra).
assert (Si : forall t, 0 <= t <= gd v -> -1 < sin t < 1). { intros t Ht. assert (C := Co t Ht). assert (E := sin2_cos2 t). unfold Rsqr in E. split; nra. }
split.
- split; [lra|]. intros t Ht. rewrite Rplus_0_l. apply pow_lt, Co. lra.
- unfold limit_integral. replace (PI/2 - (PI/2 - gd v)) with (gd v) by ring.
  assert (I : is_RInt (fun t => / cos t) 0 (gd v) (minus (artanh (sin (gd v))) (artanh (sin 0)))).
  { apply (is_RInt_derive (V:=R_CompleteNormedModule) (fun t => artanh (sin t)) (fun t => / cos t)); intros t; rewrite Rmin_left, Rmax_right by lra; intros Ht.
    - apply artanh_sin_derive. now apply Si.
    - apply (ex_derive_continuous (fun t => / cos t)). auto_derive. apply Rgt_not_eq. now apply Co. }
  rewrite (RInt_ext _ (fun t => / cos t)).
  2:{ intros t. rewrite Rmin_left, Rmax_right by lra. intros Ht. rewrite Rplus_0_l, sqrt_pow2; trivial. left. apply Co. lra. }
  rewrite (is_RInt_unique _ _ _ _ I). rewrite sin_0. unfold minus, plus, opp; simpl.
  assert (S : artanh (sin (gd v)) = v).
  { assert (B := Si (gd v) ltac:(lra)). assert (A := gd_artanh (sin (gd v)) B). rewrite asin_sin in A by lra.
    destruct (Rtotal_order (artanh (sin (gd v))) v) as [L|[L|L]]; trivial; apply gd_increases in L; lra. }
  rewrite S. unfold artanh. rewrite Rplus_0_r, Rminus_0_r. replace (1/1) with 1 by field. rewrite ln_1.
  match goal with |- @eq _ ?l ?r => change (@eq R l r) end. field.
Qed.

(** * The oscillating motions, beyond the turning points as well *)
Section Oscillating.
Variables a b beta : R.
Hypothesis Ha : 0 < a.
Hypothesis Hb : 0 < b < 1.
Hypothesis Hbeta : -1 < beta < 0.
Notation u := (- beta).
Notation x t := (HalfPhase.X u (cos t)).
Lemma u_range : 0 < u < 1. Proof. lra. Qed.
Lemma x_sin t : 1 - (1+beta) * sin t ^2 = x t.
Proof. unfold HalfPhase.X. assert (E := sin2_cos2 t). unfold Rsqr in E. replace (sin t ^2) with (1 - cos t ^2) by (simpl; lra). ring. Qed.
Lemma x_bounds t : 0 < x t <= 1.
Proof. assert (B := Oscillation.x_bounds u u_range t). lra. Qed.
Lemma legendre_derive t : is_derive (fun t => legendre_F t (1+beta)) t (/ sqrt (x t)).
Proof.
rewrite <- x_sin. unfold legendre_F. apply (is_derive_RInt (fun t => / sqrt (1 - (1+beta) * sin t ^2)) (fun t => RInt (fun t => / sqrt (1 - (1+beta) * sin t ^2)) 0 t) 0).
- assert (C : forall t, continuous (fun t => / sqrt (1 - (1+beta) * sin t ^2)) t).
  { intros z. apply (ex_derive_continuous (fun t => / sqrt (1 - (1+beta) * sin t ^2))). assert (X := x_bounds z). rewrite <- x_sin in X.
    auto_derive. simpl in X. repeat split; try lra. apply Rgt_not_eq, sqrt_lt_R0. lra. }
  exists (mkposreal 1 Rlt_0_1). intros z _. apply (@RInt_correct R_CompleteNormedModule), (@ex_RInt_continuous R_CompleteNormedModule). intros y _. apply C.
- apply (ex_derive_continuous (fun t => / sqrt (1 - (1+beta) * sin t ^2))). assert (X := x_bounds t). rewrite <- x_sin in X.
  auto_derive. simpl in X. repeat split; try lra. apply Rgt_not_eq, sqrt_lt_R0. lra.
Qed.
Lemma legendre_0 : legendre_F 0 (1+beta) = 0.
Proof. unfold legendre_F. now rewrite (RInt_point (V:=R_CompleteNormedModule)). Qed.
Lemma inverse_root t : 1 <= / sqrt (x t).
Proof.
assert (X := x_bounds t). assert (S := sqrt_lt_R0 _ (proj1 X)). rewrite <- Rinv_1. apply Rinv_le_contravar; [exact S|].
rewrite <- sqrt_1. now apply sqrt_le_1_alt.
Qed.
Lemma legendre_apart s t : Rabs (t - s) <= Rabs (legendre_F t (1+beta) - legendre_F s (1+beta)).
Proof.
assert (W : forall s t, s <= t -> t - s <= legendre_F t (1+beta) - legendre_F s (1+beta)).
{ intros p q L. apply (grows_more (fun z => z) (fun z => legendre_F z (1+beta)) (fun _ => 1) (fun z => / sqrt (x z))); trivial.
  - intros z. apply (is_derive_id (K:=R_AbsRing)). - apply legendre_derive. - intros z _. apply inverse_root. }
destruct (Rle_or_lt s t) as [L|L].
- assert (Q := W s t L). rewrite !Rabs_pos_eq; lra.
- assert (Q := W t s ltac:(lra)). rewrite !Rabs_left1; lra.
Qed.
(** The amplitude: Legendre's integral takes every value once. *)
Theorem amplitude v : exists t, legendre_F t (1+beta) = v /\ forall s, legendre_F s (1+beta) = v -> s = t.
Proof.
assert (C : forall z, continuity_pt (fun t => legendre_F t (1+beta)) z).
{ intros z. apply continuity_pt_filterlim, (ex_derive_continuous (fun t => legendre_F t (1+beta))). eexists. apply legendre_derive. }
assert (G : forall s t, s <= t -> t - s <= legendre_F t (1+beta) - legendre_F s (1+beta)).
{ intros p q L. apply (grows_more (fun z => z) (fun z => legendre_F z (1+beta)) (fun _ => 1) (fun z => / sqrt (x z))); trivial.
  - intros z. apply (is_derive_id (K:=R_AbsRing)). - apply legendre_derive. - intros z _. apply inverse_root. }
assert (A := Rabs_pos v). assert (A1 := Rle_abs v). assert (A2 := Rle_abs (- v)). rewrite Rabs_Ropp in A2.
assert (G1 := G 0 (Rabs v) A). assert (G2 := G (- Rabs v) 0 ltac:(lra)). rewrite legendre_0 in G1, G2.
destruct (IVT_gen (fun t => legendre_F t (1+beta)) (- Rabs v) (Rabs v) v C) as [t [_ E]].
- split; [apply Rle_trans with (1 := Rmin_l _ _); lra|apply Rle_trans with (2 := Rmax_r _ _); lra].
- exists t. split; [exact E|]. intros s Es. assert (D := legendre_apart s t). rewrite E, Es, Rminus_eq_0, Rabs_R0 in D.
  assert (Q := Rabs_pos (t - s)). assert (Z : Rabs (t - s) = 0) by lra. destruct (Req_dec (t - s) 0) as [Y|Y]; [lra|]. now apply Rabs_no_R0 in Y.
Qed.

(** phi of the motion, between multiples of Legendre's integral. *)
Lemma kernel_bounds t : geometric_constant a b * / sqrt (x t) <= Phase.kernel a b u t <= / sqrt (a*b) * / sqrt (x t).
Proof.
assert (X := x_bounds t). set (y := x t) in *. rewrite (Oscillation.kernel_value a b u Ha Hb u_range). fold y. clearbody y.
assert (BY : 0 < b*y <= b) by (split; [apply Rmult_lt_0_compat; lra|rewrite <- (Rmult_1_r b) at 2; apply Rmult_le_compat_l; lra]).
assert (Sb : 0 < sqrt b) by (apply sqrt_lt_R0; lra). assert (Sy : 0 < sqrt y) by (apply sqrt_lt_R0; lra). assert (Sa : 0 < sqrt a) by (apply sqrt_lt_R0; lra).
assert (S1 : 0 < sqrt (a + b*y)) by (apply sqrt_lt_R0; lra). assert (S2 : 0 < sqrt (a + b)) by (apply sqrt_lt_R0; lra).
assert (L1 : sqrt a <= sqrt (a + b*y)) by (apply sqrt_le_1_alt; lra). assert (L2 : sqrt (a + b*y) <= sqrt (a + b)) by (apply sqrt_le_1_alt; lra).
unfold geometric_constant. rewrite (sqrt_mult_alt b (a+b)), (sqrt_mult_alt a b) by lra. split.
- apply (Rmult_le_reg_r (sqrt b * sqrt y * sqrt (a + b*y) * sqrt (a+b))). { repeat apply Rmult_lt_0_compat; lra. }
  replace (_ * (sqrt b * sqrt y * _ * _)) with ((1-b) * sqrt (a + b*y)) by (field; lra).
  replace ((1 - b*y) / _ * _) with ((1 - b*y) * sqrt (a+b)) by (field; lra). apply Rmult_le_compat; lra.
- apply (Rmult_le_reg_r (sqrt b * sqrt y * sqrt (a + b*y) * sqrt a)). { repeat apply Rmult_lt_0_compat; lra. }
  replace ((1 - b*y) / _ * _) with ((1 - b*y) * sqrt a) by (field; lra).
  replace (_ * (sqrt b * sqrt y * _ * _)) with (1 * sqrt (a + b*y)) by (field; lra). apply Rmult_le_compat; lra.
Qed.
Lemma turn_sandwich : PI * sqrt (a*b) <= legendre_F (Oscillation.turn a b u PI) (1+beta) <= PI / geometric_constant a b.
Proof.
set (t := Oscillation.turn a b u PI). assert (P := PI_RGT_0). assert (E : Phase.P a b u t = PI) by apply (Oscillation.P_turn a b u Ha Hb u_range).
assert (Z : Phase.P a b u 0 = 0) by apply (Oscillation.P_zero a b u). assert (DP := Oscillation.P_derive a b u Ha Hb u_range).
assert (T : 0 <= t). { apply Rnot_lt_le. intros L. assert (Q := Oscillation.P_increasing_strictly a b u Ha Hb u_range t 0 L). lra. }
assert (I0 := geometric_constant_pos a b Ha Hb). assert (S := sqrt_ab_pos a b Ha Hb). assert (L0 := legendre_0).
assert (D : forall m z, is_derive (fun z => m * legendre_F z (1+beta)) z (m * / sqrt (x z))).
{ intros m z. apply (is_derive_scal (fun z => legendre_F z (1+beta)) z m). apply legendre_derive. }
assert (A := grows_more _ _ _ _ 0 t (D (geometric_constant a b)) DP (fun z _ => proj1 (kernel_bounds z)) T).
assert (B := grows_more _ _ _ _ 0 t DP (D (/ sqrt (a*b))) (fun z _ => proj2 (kernel_bounds z)) T).
simpl in A, B. rewrite L0, E, Z in A, B. split.
- apply (Rmult_le_reg_l (/ sqrt (a*b))); [now apply Rinv_0_lt_compat|]. replace (/ sqrt (a*b) * (PI * sqrt (a*b))) with PI by (field; lra). lra.
- apply (Rmult_le_reg_l (geometric_constant a b)); trivial. replace (geometric_constant a b * (PI / geometric_constant a b)) with PI by (field; lra). lra.
Qed.
Lemma psi_of_apart s t : Rabs (Oscillation.psi_of u t - Oscillation.psi_of u s) <= sqrt (1+beta) * Rabs (t - s).
Proof.
destruct (MVT_gen (Oscillation.psi_of u) s t (fun t => sqrt (1 - u) * cos t / sqrt (x t))) as [z [_ E]].
- intros z _. apply (Oscillation.psi_of_derive u u_range).
- intros z _. apply continuity_pt_filterlim, (ex_derive_continuous (Oscillation.psi_of u)). eexists. apply (Oscillation.psi_of_derive u u_range).
- rewrite E, Rabs_mult. apply Rmult_le_compat_r; [apply Rabs_pos|]. assert (X := x_bounds z). assert (S := sqrt_lt_R0 _ (proj1 X)).
  assert (Er : forall q : R, 1 - - q = 1 + q) by (intros; ring). rewrite Er. assert (R0 := sqrt_pos (1+beta)).
  assert (C : Rabs (cos z) <= sqrt (x z)).
  { rewrite <- sqrt_Rsqr_abs. apply sqrt_le_1_alt. unfold Rsqr, HalfPhase.X. assert (B := Uniqueness.cos2_bound z). assert (0 <= u * (1 - cos z ^2)) by (apply Rmult_le_pos; lra). simpl in *. lra. }
  unfold Rdiv. rewrite !Rabs_mult, (Rabs_pos_eq (sqrt (1+beta))), (Rabs_pos_eq (/ sqrt (x z))) by (trivial; left; now apply Rinv_0_lt_compat).
  rewrite Rmult_assoc. rewrite <- (Rmult_1_r (sqrt (1+beta))) at 2. apply Rmult_le_compat_l; trivial.
  apply (Rmult_le_reg_r (sqrt (x z))); trivial. rewrite Rmult_assoc, Rinv_l; lra.
Qed.
(** The limit formula for -1 < beta < 0: t is the amplitude am (pi sqrt chi | 1+beta), sin t its sn. *)
Theorem limit_formula_oscillating chi t eps : legendre_F t (1+beta) = PI * sqrt chi -> Curve.curve_C a b (beta*b) eps ->
  Rabs (eps - (PI/2 - asin (sqrt (1+beta) * sin t))) <= sqrt (1+beta) * rate a b chi.
Proof.
intros E C. assert (S := sqrt_pos (1+beta)).
assert (Hc : -b < beta*b < 0) by (split; nra).
apply (Curve.curve_C_epsilon a b Ha Hb _ _ Hc) in C. subst eps. unfold Curve.epsilon, Oscillation.oscillation_psi.
replace (- (beta*b) / b) with u by (field; lra).
replace (asin (sqrt (1+beta) * sin t)) with (Oscillation.psi_of u t) by (unfold Oscillation.psi_of; do 3 f_equal; ring).
set (s := Oscillation.turn a b u PI). replace (PI/2 - Oscillation.psi_of u s - (PI/2 - Oscillation.psi_of u t)) with (Oscillation.psi_of u t - Oscillation.psi_of u s) by ring.
apply Rle_trans with (1 := psi_of_apart s t). apply Rmult_le_compat_l; trivial.
apply Rle_trans with (1 := legendre_apart s t). rewrite E, Rabs_minus_sym. apply within_rate, turn_sandwich.
Qed.

(** For chi <= 1 the limit is above pi - 2 arctan e^pi, as artanh (sin psi) grows by at most sqrt (1+beta) for each unit of Legendre's integral,
    and exceeds it by at most what the theorem says: it tends to it as chi -> 1, beta -> 0. *)
Notation r := (sqrt (1+beta)).
Notation s t := (r * sin t).
Lemma r_range : 0 < r < 1.
Proof. split; [apply sqrt_lt_R0; lra|]. rewrite <- sqrt_1 at 2. apply sqrt_lt_1_alt. lra. Qed.
Lemma s_range t : -1 < s t < 1.
Proof. assert (R := r_range). assert (B := SIN_bound t). split; nra. Qed.
Lemma x_of_s t : 1 - s t * s t = x t.
Proof. rewrite <- x_sin. assert (Q := sqrt_sqrt (1+beta) ltac:(lra)). replace (s t * s t) with (r * r * sin t ^2) by ring. now rewrite Q. Qed.
Lemma artanh_s_derive t : is_derive (fun t => artanh (s t)) t (r * cos t / x t).
Proof.
assert (B := s_range t). rewrite <- x_of_s. unfold artanh. auto_derive. { repeat split; try lra. apply Rdiv_lt_0_compat; lra. }
field. repeat split; try lra. nra.
Qed.
Lemma artanh_0 : artanh (s 0) = 0.
Proof. rewrite sin_0, Rmult_0_r. unfold artanh. rewrite Rplus_0_r, Rminus_0_r. replace (1/1) with 1 by field. rewrite ln_1. field. Qed.
Lemma cos_below_root z : Rabs (cos z) <= sqrt (x z).
Proof.
rewrite <- sqrt_Rsqr_abs. apply sqrt_le_1_alt. unfold Rsqr, HalfPhase.X. assert (B := Uniqueness.cos2_bound z).
assert (0 <= u * (1 - cos z ^2)) by (apply Rmult_le_pos; lra). simpl in *. lra.
Qed.
Lemma artanh_below t : 0 <= t -> artanh (s t) <= r * legendre_F t (1+beta).
Proof.
intros T. assert (R := r_range).
assert (A := grows_more (fun t => artanh (s t)) (fun t => r * legendre_F t (1+beta)) (fun t => r * cos t / x t) (fun t => r * / sqrt (x t)) 0 t artanh_s_derive).
cbv beta in A. rewrite artanh_0, legendre_0 in A. cut (artanh (s t) - 0 <= r * legendre_F t (1+beta) - r * 0); [lra|]. apply A; trivial.
- intros z. apply (is_derive_scal (fun t => legendre_F t (1+beta)) z r). apply legendre_derive.
- intros z _. assert (X := x_bounds z). assert (S := sqrt_lt_R0 _ (proj1 X)). assert (S2 := sqrt_sqrt _ (Rlt_le _ _ (proj1 X))).
  assert (C := cos_below_root z). assert (C' := Rle_abs (cos z)). unfold Rdiv. rewrite Rmult_assoc. apply Rmult_le_compat_l; [lra|].
  apply (Rmult_le_reg_r (x z)); [lra|]. rewrite Rmult_assoc, Rinv_l by lra. rewrite <- S2 at 2. replace (/ sqrt (x z) * (sqrt (x z) * sqrt (x z))) with (sqrt (x z)) by (field; lra). lra.
Qed.
Theorem limit_near_minimum chi t : 0 < chi <= 1 -> legendre_F t (1+beta) = PI * sqrt chi ->
  0 < (PI/2 - asin (s t)) - (PI - 2 * atan (exp PI)) <= PI * (1 - sqrt chi) + PI * cosh PI * sqrt (- beta * chi).
Proof.
intros Hchi E. assert (P := PI_RGT_0). assert (R := r_range). assert (B := s_range t).
assert (SC : 0 < sqrt chi <= 1). { split; [apply sqrt_lt_R0; lra|]. rewrite <- sqrt_1. apply sqrt_le_1_alt. lra. }
assert (V : 0 < PI * sqrt chi <= PI) by (split; nra).
assert (G : forall p q, p <= q -> legendre_F p (1+beta) <= legendre_F q (1+beta)).
{ intros p q L. assert (W := grows_more (fun z => z) (fun z => legendre_F z (1+beta)) (fun _ => 1) (fun z => / sqrt (x z)) p q (fun z => is_derive_id (K:=R_AbsRing) z) legendre_derive (fun z _ => inverse_root z) L).
  simpl in W. lra. }
assert (T : 0 < t). { apply Rnot_le_lt. intros L. assert (W := G t 0 L). rewrite legendre_0 in W. lra. }
assert (A := artanh_below t ltac:(lra)). rewrite E in A. assert (Y : artanh (s t) < PI) by nra.
rewrite (gd_artanh _ B). replace (PI/2 - gd (artanh (s t)) - (PI - 2 * atan (exp PI))) with (gd PI - gd (artanh (s t))) by (unfold gd at 1; field).
split; [assert (W := gd_increases _ _ Y); lra|].
rewrite (sqrt_mult_alt (- beta)) by lra. set (w := sqrt (- beta)). assert (W0 : 0 < w) by (apply sqrt_lt_R0; lra). assert (Ch := cosh_at_least_1 PI).
destruct (Rle_or_lt 1 (w * cosh PI)) as [Big|Small].
{ assert (G1 := gd_range PI). assert (G2 := gd_range (artanh (s t))). assert (PI * sqrt chi <= PI * cosh PI * (w * sqrt chi)); [|lra].
  replace (PI * cosh PI * (w * sqrt chi)) with (PI * sqrt chi * (w * cosh PI)) by ring. rewrite <- (Rmult_1_r (PI * sqrt chi)) at 1. apply Rmult_le_compat_l; lra. }
(** 1/sqrt x stays below cosh pi, so that the turning point is not reached. *)
assert (Root : forall z, 0 <= z <= t -> 0 <= sin z -> / sqrt (x z) <= cosh PI).
{ intros z Hz Sz. rewrite <- x_of_s, (cosh_artanh _ (s_range z)). apply cosh_le.
  assert (Az := artanh_below z ltac:(lra)). assert (Lz := G z t ltac:(lra)). rewrite E in Lz. split; [|nra].
  assert (Bz := s_range z). assert (S0 : 0 <= s z) by (apply Rmult_le_pos; lra). unfold artanh.
  assert (1 <= (1 + s z) / (1 - s z)). { apply (Rmult_le_reg_r (1 - s z)); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra. }
  assert (0 <= ln ((1 + s z) / (1 - s z))); [|lra]. rewrite <- ln_1. destruct H as [H| <-]; [left; apply ln_increasing; lra|lra]. }
assert (Early : t < PI/2).
{ apply Rnot_le_lt. intros L. assert (W := Root (PI/2) ltac:(lra) ltac:(rewrite sin_PI2; lra)). rewrite <- x_sin, sin_PI2 in W.
  replace (1 - (1+beta) * 1 ^2) with (- beta) in W by ring. fold w in W. apply (Rmult_le_compat_l w) in W; [|lra]. rewrite Rinv_r in W; lra. }
assert (Low : (1 - w * cosh PI) * (PI * sqrt chi) <= artanh (s t)).
{ assert (Q := grows_more (fun t => (1 - w * cosh PI) * legendre_F t (1+beta)) (fun t => artanh (s t)) (fun t => (1 - w * cosh PI) * / sqrt (x t)) (fun t => r * cos t / x t) 0 t).
  cbv beta in Q. rewrite artanh_0, legendre_0, E in Q. cut ((1 - w * cosh PI) * (PI * sqrt chi) - (1 - w * cosh PI) * 0 <= artanh (s t) - 0); [lra|]. apply Q; try lra.
  - intros z. apply (is_derive_scal (fun t => legendre_F t (1+beta)) z (1 - w * cosh PI)). apply legendre_derive.
  - apply artanh_s_derive.
  - intros z Hz. assert (X := x_bounds z). assert (S := sqrt_lt_R0 _ (proj1 X)). assert (S2 := sqrt_sqrt _ (Rlt_le _ _ (proj1 X))).
    assert (Cz : 0 <= cos z) by (apply cos_ge_0; lra). assert (W := Root z Hz ltac:(apply sin_ge_0; lra)).
    assert (C : sqrt (x z) - w <= r * cos z).
    { assert (K : 0 <= r * cos z) by (apply Rmult_le_pos; lra). assert (sqrt (x z) <= r * cos z + w); [|lra].
      apply Rsqr_incr_0; [|lra|lra]. unfold Rsqr. rewrite S2. replace ((r * cos z + w) * (r * cos z + w)) with (r * r * cos z ^2 + w * w + 2 * (r * cos z) * w) by ring.
      rewrite (sqrt_sqrt (1+beta)) by lra. unfold w at 1 2. rewrite (sqrt_sqrt (- beta)) by lra. unfold HalfPhase.X.
      assert (0 <= r * cos z * w) by (apply Rmult_le_pos; lra). replace (1 - - beta) with (1 + beta) by ring. lra. }
    apply (Rmult_le_reg_r (x z)); [lra|]. unfold Rdiv. rewrite Rmult_assoc, (Rmult_assoc _ (/ x z)), Rinv_l, Rmult_1_r by lra.
    rewrite <- S2 at 2. replace (/ sqrt (x z) * (sqrt (x z) * sqrt (x z))) with (sqrt (x z)) by (field; lra).
    apply Rle_trans with (2 := C). rewrite Rmult_minus_distr_r, Rmult_1_l. apply Rplus_le_compat_l, Ropp_le_contravar.
    rewrite Rmult_assoc. rewrite <- (Rmult_1_r w) at 1. apply Rmult_le_compat_l; [lra|].
    apply (Rmult_le_compat_r (sqrt (x z))) in W; [|lra]. rewrite Rinv_l in W; lra. }
assert (Z := gd_apart (artanh (s t)) PI ltac:(lra)). replace (PI * cosh PI * (w * sqrt chi)) with (w * cosh PI * (PI * sqrt chi)) by ring. lra.
Qed.
End Oscillating.

(** The equation of the limit in Legendre's form, equation (35): F (pi/2 - e | 1/(1+beta)) = pi sqrt (chi (1+beta)). *)
Theorem limit_equation_legendre chi beta e : 0 < chi -> -1 < beta -> limit_regular beta e ->
  (limit_integral beta e = PI * sqrt chi <-> legendre_F (PI/2 - e) (1/(1+beta)) = PI * sqrt (chi * (1+beta))).
Proof.
intros Hchi Hbeta H. assert (S : 0 < sqrt (1+beta)) by (apply sqrt_lt_R0; lra).
rewrite (legendre_form beta e Hbeta H), sqrt_mult_alt by lra. split; intros E.
- apply (Rmult_eq_compat_r (sqrt (1+beta))) in E. replace (/ sqrt (1+beta) * legendre_F (PI/2 - e) (1/(1+beta)) * sqrt (1+beta)) with (legendre_F (PI/2 - e) (1/(1+beta))) in E by (field; lra). lra.
- rewrite E. field. lra.
Qed.
