(** The paper's limit a -> infinity, b -> 0 with ab -> chi and c/b = beta fixed, equations (33)-(38), on the branch of the first implicit
    equation: the defect tends to the e with
      F (pi/2 - e | 1/(1+beta)) = pi sqrt (chi (1+beta)),   Legendre's integral of the first kind,
    that is e = pi/2 - am (pi sqrt (chi (1+beta)) | 1/(1+beta)). *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Polhode Require Import Theorem1 FirstEquation Separatrix.
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

Lemma limit_regular_open beta e : limit_regular beta e -> exists m, 0 < m /\ limit_regular beta (e - m).
Proof.
intros H. apply (limit_regular_iff 1) in H; [|lra]. destruct (regular_open_e _ _ _ H) as [m [Hm R0]]. exists m. split; trivial.
apply (limit_regular_iff 1); trivial; lra.
Qed.

Lemma geometric_constant_limit chi d : 0 < chi -> 0 < d -> exists m, 0 < m /\
  forall a b, 0 < a -> 0 < b < 1 -> b < m -> Rabs (a*b - chi) < m -> Rabs (geometric_constant a b - / sqrt chi) < d /\ Rabs (sqrt (a*b) - sqrt chi) < d.
Proof.
intros Hchi Hd. assert (S := sqrt_lt_R0 _ Hchi).
assert (C : continuity_2d_pt (fun p b => (1 - b) * / sqrt (p + b*b)) chi 0).
{ apply continuity_2d_pt_mult.
  - apply (continuity_1d_2d_pt_comp (fun b => 1 - b) (fun _ b => b)). 2: apply continuity_2d_pt_id2.
    apply continuity_pt_filterlim, (ex_derive_continuous (fun s => 1 - s)). auto_derive; trivial.
  - apply continuity_2d_pt_inv.
    + apply (continuity_1d_2d_pt_comp sqrt (fun p b => p + b*b)). apply continuity_pt_sqrt; lra.
      apply continuity_2d_pt_plus. apply continuity_2d_pt_id1. apply continuity_2d_pt_mult; apply continuity_2d_pt_id2.
    + replace (chi + 0*0) with chi by ring. lra. }
destruct (C (mkposreal d Hd)) as [m1 N1]. simpl in N1. assert (M1 := cond_pos m1).
destruct (continuity_pt_sqrt chi (Rlt_le _ _ Hchi) d Hd) as [m2 [M2 N2]].
exists (Rmin m1 m2). split; [apply Rmin_pos; lra|]. assert (L1 := Rmin_l m1 m2). assert (L2 := Rmin_r m1 m2).
intros a b Ha Hb Hm Hab. split.
- specialize (N1 (a*b) b ltac:(lra)). rewrite Rminus_0_r, Rabs_right in N1 by lra. specialize (N1 ltac:(lra)).
  replace ((1 - 0) * / sqrt (chi + 0*0)) with (/ sqrt chi) in N1. 2:{ replace (chi + 0*0) with chi by ring. ring. }
  unfold geometric_constant, Rdiv. replace (b*(a+b)) with (a*b + b*b) by ring. exact N1.
- destruct (Req_dec chi (a*b)) as [<-|Ne]. rewrite Rminus_eq_0, Rabs_R0. exact Hd.
  apply N2. split. split; [exact Logic.I|exact Ne]. simpl. unfold R_dist. lra.
Qed.

(** Equations (33)-(36): the limit of the defect. For every d > 0 the bodies with b small and ab near chi have, at c = beta b, one
    solution of the first implicit equation, and it is within d of the limit's e. *)
Theorem limit_formula chi beta e : 0 < chi -> limit_regular beta e -> limit_integral beta e = PI * sqrt chi ->
  forall d, 0 < d -> exists m, 0 < m /\ forall a b, 0 < a -> 0 < b < 1 -> b < m -> Rabs (a*b - chi) < m ->
    (exists f, regular b (beta*b) f /\ F a b (beta*b) f = 2*PI) /\
    (forall f, regular b (beta*b) f -> F a b (beta*b) f = 2*PI -> Rabs (f - e) < d).
Proof.
intros Hchi H E d Hd. assert (P := PI_RGT_0). assert (He : e < PI/2) by apply H. assert (S := sqrt_lt_R0 _ Hchi).
destruct (limit_regular_open beta e H) as [r0 [P0 Reg0]].
set (r := Rmin (d/2) (Rmin r0 ((PI/2 - e)/2))).
assert (Q1 := Rmin_l (d/2) (Rmin r0 ((PI/2 - e)/2))). assert (Q2 := Rmin_r (d/2) (Rmin r0 ((PI/2 - e)/2))). fold r in Q1, Q2.
assert (Q3 := Rmin_l r0 ((PI/2 - e)/2)). assert (Q4 := Rmin_r r0 ((PI/2 - e)/2)).
assert (Pr : 0 < r) by (unfold r; repeat apply Rmin_pos; lra).
assert (Reg : forall f, e - r <= f < PI/2 -> limit_regular beta f).
{ intros f Hf. split; [lra|]. intros t Ht. apply Reg0; lra. }
assert (N1 := limit_integral_decreasing beta (e - r) e (Reg (e-r) ltac:(lra)) ltac:(lra)).
assert (N2 := limit_integral_decreasing beta e (e + r) H ltac:(lra)). rewrite E in N1, N2.
set (E1 := limit_integral beta (e - r)) in *. set (E2 := limit_integral beta (e + r)) in *.
assert (E2p : 0 < E2) by (apply limit_integral_pos, Reg; lra).
assert (E1p : 0 < E1) by (apply limit_integral_pos, Reg; lra).
assert (D1 : 0 < / sqrt chi - PI/E1).
{ apply Rlt_Rminus. apply (Rmult_lt_reg_r (E1 * sqrt chi)). now apply Rmult_lt_0_compat.
  replace (PI/E1 * (E1 * sqrt chi)) with (PI * sqrt chi) by (field; lra). replace (/ sqrt chi * (E1 * sqrt chi)) with E1 by (field; lra). exact N1. }
assert (D2 : 0 < sqrt chi - E2/PI).
{ apply Rlt_Rminus. apply (Rmult_lt_reg_r PI); trivial. replace (E2/PI*PI) with E2 by (field; lra). lra. }
destruct (geometric_constant_limit chi (Rmin (/ sqrt chi - PI/E1) (sqrt chi - E2/PI)) Hchi ltac:(now apply Rmin_pos)) as [m [Hm N]].
assert (L1 := Rmin_l (/ sqrt chi - PI/E1) (sqrt chi - E2/PI)). assert (L2 := Rmin_r (/ sqrt chi - PI/E1) (sqrt chi - E2/PI)).
exists m. split; trivial. intros a b Ha Hb Hbm Hab. destruct (N a b Ha Hb Hbm Hab) as [NI NS]. apply Rabs_def2 in NI. apply Rabs_def2 in NS.
assert (I1 : PI/E1 < geometric_constant a b) by lra. assert (S1 : E2/PI < sqrt (a*b)) by lra.
assert (Sab := sqrt_ab_pos a b Ha Hb).
assert (B1 : 2*PI < F a b (beta*b) (e - r)).
{ destruct (F_limit_bounds a b beta (e - r) Ha Hb (Reg (e-r) ltac:(lra))) as [L _]. fold E1 in L. apply Rlt_le_trans with (2 := L).
  apply Rmult_lt_compat_l; [lra|]. replace PI with (PI/E1*E1) at 1 by (field; lra). now apply Rmult_lt_compat_r. }
assert (B2 : F a b (beta*b) (e + r) < 2*PI).
{ destruct (F_limit_bounds a b beta (e + r) Ha Hb (Reg (e+r) ltac:(lra))) as [_ U]. fold E2 in U. apply Rle_lt_trans with (1 := U).
  apply Rmult_lt_compat_l; [lra|]. apply (Rmult_lt_reg_l (sqrt (a*b))); trivial. replace (sqrt (a*b) * (/ sqrt (a*b) * E2)) with E2 by (field; lra).
  replace E2 with (E2/PI*PI) by (field; lra). now apply Rmult_lt_compat_r. }
assert (RegB : forall f, e - r <= f < PI/2 -> regular b (beta*b) f) by (intros f Hf; apply limit_regular_iff; [lra|now apply Reg]).
split.
- destruct (Ranalysis5.IVT_interv (fun f => 2*PI - F a b (beta*b) f) (e - r) (e + r)) as [f [Hf Ef]]; try lra.
  + intros f Hf. apply continuity_pt_minus. apply continuity_pt_const; now intros ? ?. apply F_continuity_e, RegB; trivial. lra.
  + exists f. split; [apply RegB; lra|lra].
- intros f Rf Ef. assert (Hf : f < PI/2) by apply Rf.
  assert (e - r < f).
  { apply Rnot_le_lt. intros [L|L]. assert (M := F_decreasing_e a b Ha Hb (beta*b) f (e - r) Rf ltac:(lra)). lra. rewrite L in Ef. lra. }
  assert (f < e + r).
  { apply Rnot_le_lt. intros [L|L]. assert (M := F_decreasing_e a b Ha Hb (beta*b) (e + r) f (RegB (e+r) ltac:(lra)) ltac:(lra)). lra. rewrite <- L in Ef. lra. }
  apply Rabs_def1; lra.
Qed.

(** The equation of the limit in Legendre's form, equation (35): F (pi/2 - e | 1/(1+beta)) = pi sqrt (chi (1+beta)). *)
Theorem limit_equation_legendre chi beta e : 0 < chi -> -1 < beta -> limit_regular beta e ->
  (limit_integral beta e = PI * sqrt chi <-> legendre_F (PI/2 - e) (1/(1+beta)) = PI * sqrt (chi * (1+beta))).
Proof.
intros Hchi Hbeta H. assert (S : 0 < sqrt (1+beta)) by (apply sqrt_lt_R0; lra).
rewrite (legendre_form beta e Hbeta H), sqrt_mult_alt by lra. split; intros E.
- apply (Rmult_eq_compat_r (sqrt (1+beta))) in E. replace (/ sqrt (1+beta) * legendre_F (PI/2 - e) (1/(1+beta)) * sqrt (1+beta)) with (legendre_F (PI/2 - e) (1/(1+beta))) in E by (field; lra). lra.
- rewrite E. field. lra.
Qed.
