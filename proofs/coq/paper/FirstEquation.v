(** The first implicit equation of the tennis racket effect, F = 2 pi with
      F(c,e) = integral over -(pi/2 - e) .. pi/2 - e of (1 - b cos^2 psi) / sqrt ((a + b cos^2 psi)(c + b cos^2 psi)) d psi,
    where e is the twist defect epsilon: equations (21)-(24) of the paper and its proposition 2. The variable u of the paper is sin^2 e.
    F is positive, decreases strictly in c, in e and in a, and is continuous; so e decreases along the curve. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Polhode Require HalfPhase.
Open Scope R_scope.

Section Integrand.
Variables a b : R.
Hypothesis Ha : 0 < a.
Hypothesis Hb : 0 < b < 1.

(** The integrand of equation (21), d phi / d psi. *)
Definition k (c t : R) : R := (1 - b * cos t ^2) / sqrt ((a + b * cos t ^2) * (c + b * cos t ^2)).

Lemma cos2_range t : 0 <= cos t ^2 <= 1.
Proof. generalize (COS_bound t). intros [H1 H2]. nra. Qed.

Lemma bcos2_range t : 0 <= b * cos t ^2 < 1.
Proof. assert (H := cos2_range t). split; [apply Rmult_le_pos; lra|nra]. Qed.

Lemma k_pos c t : 0 < c + b * cos t ^2 -> 0 < k c t.
Proof.
intros H. assert (B := bcos2_range t). unfold k. apply Rdiv_lt_0_compat; [lra|].
apply sqrt_lt_R0, Rmult_lt_0_compat; lra.
Qed.

Lemma k_continuous c t : 0 < c + b * cos t ^2 -> continuous (k c) t.
Proof.
intros H. assert (B := bcos2_range t). apply (ex_derive_continuous (k c)). unfold k. auto_derive.
assert (P : 0 < (a + b * cos t ^2) * (c + b * cos t ^2)) by (apply Rmult_lt_0_compat; lra).
simpl in P. repeat split; trivial. apply Rgt_not_eq, sqrt_lt_R0, P.
Qed.

Lemma k_decreasing c d t : 0 < c + b * cos t ^2 -> c < d -> k d t < k c t.
Proof.
intros H L. assert (B := bcos2_range t). unfold k, Rdiv. apply Rmult_lt_compat_l; [lra|].
assert (P : 0 < (a + b * cos t ^2) * (c + b * cos t ^2)) by (apply Rmult_lt_0_compat; lra).
assert (P2 : (a + b * cos t ^2) * (c + b * cos t ^2) < (a + b * cos t ^2) * (d + b * cos t ^2)) by (apply Rmult_lt_compat_l; lra).
apply Rinv_lt_contravar.
- apply Rmult_lt_0_compat; apply sqrt_lt_R0; lra.
- apply sqrt_lt_1_alt. lra.
Qed.

(** The derivative of the integrand in c, the integrand of the numerator of equation (24) *)
Lemma k_derive c t : 0 < c + b * cos t ^2 -> is_derive (fun c => k c t) c (- (k c t / (2 * (c + b * cos t ^2)))).
Proof.
intros H. assert (B := bcos2_range t). unfold k. set (y := b * cos t ^2) in *.
assert (P : 0 < (a + y) * (c + y)) by (apply Rmult_lt_0_compat; lra).
assert (S := sqrt_lt_R0 _ P). assert (Q := sqrt_sqrt _ (Rlt_le _ _ P)).
auto_derive. repeat split; lra.
set (s := sqrt ((a + y) * (c + y))) in *. 
apply Rminus_diag_uniq.
match goal with |- ?l = 0 => replace l with ((1-y)/(2*s*(s*s)*(c+y)) * (s*s - (a+y)*(c+y))) by (field; lra) end. rewrite Q. ring.
Qed.
End Integrand.

(** The region in which equation (21) holds: c + b cos^2 psi > 0 on the way, that is, the curve S is not reached. *)
Definition regular (b c e : R) : Prop := e < PI/2 /\ forall t, 0 <= t <= PI/2 - e -> 0 < c + b * cos t ^2.

(** Equation (21): the right side is F(c,e), twice the integral of equation (23). *)
Definition F (a b c e : R) : R := 2 * RInt (k a b c) 0 (PI/2 - e).

(** S is the curve c = -b sin^2 e, so that for 0 <= e < pi/2 the region is c > -b u, with u = sin^2 e. *)
Lemma regular_iff b c e : 0 < b -> 0 <= e < PI/2 -> (regular b c e <-> - b * sin e ^2 < c).
Proof.
intros Hb He. split.
- intros [_ H]. specialize (H (PI/2 - e) ltac:(lra)). rewrite cos_shift in H. lra.
- intros H. split; [lra|]. intros t Ht.
  assert (C : sin e <= cos t). { rewrite <- cos_shift. apply cos_decr_1; lra. }
  assert (S : 0 <= sin e) by (apply sin_ge_0; lra).
  assert (b * sin e ^2 <= b * cos t ^2) by (apply Rmult_le_compat_l; [lra|]; nra). lra.
Qed.

Lemma regular_rotating b c e : 0 < b -> 0 < c -> e < PI/2 -> regular b c e.
Proof.
intros Hb Hc He. split; trivial. intros t _. 
assert (0 <= b * cos t ^2) by (apply Rmult_le_pos; [lra|apply pow2_ge_0]). lra.
Qed.

Lemma regular_separatrix b e : 0 < b -> 0 < e < PI/2 -> regular b 0 e.
Proof.
intros Hb He. apply regular_iff; try lra. assert (S : 0 < sin e) by (apply sin_gt_0; lra).
assert (0 < b * sin e ^2) by (apply Rmult_lt_0_compat; [lra|nra]). lra.
Qed.

Lemma regular_more_e b c e e' : regular b c e -> e <= e' < PI/2 -> regular b c e'.
Proof. intros [H1 H2] H. split; [lra|]. intros t Ht. apply H2; lra. Qed.

Lemma regular_more_c b c c' e : regular b c e -> c <= c' -> regular b c' e.
Proof. intros [H1 H2] H. split; trivial. intros t Ht. specialize (H2 t Ht). lra. Qed.

(** The region is open in each variable. *)
Lemma regular_open_c b c e : regular b c e -> exists m, 0 < m /\ regular b (c - m) e.
Proof.
intros [H1 H2].
destruct (continuity_ab_min (fun t => c + b * cos t ^2) 0 (PI/2 - e)) as [t [Ht1 Ht2]]; [lra| |].
- intros t _. apply continuity_pt_filterlim. apply (ex_derive_continuous (fun t => c + b * cos t ^2)). auto_derive; trivial.
- specialize (H2 t Ht2). exists ((c + b * cos t ^2)/2). split; [lra|]. split; trivial.
  intros s Hs. specialize (Ht1 s Hs). lra.
Qed.

Lemma regular_open_e b c e : regular b c e -> exists m, 0 < m /\ regular b c (e - m).
Proof.
intros [H1 H2].
assert (P := H2 (PI/2 - e) ltac:(lra)).
assert (C : continuous (fun t => c + b * cos t ^2) (PI/2 - e)).
{ apply (ex_derive_continuous (fun t => c + b * cos t ^2)). auto_derive; trivial. }
destruct (C (fun y => 0 < y) (open_gt 0 _ P)) as [d Hd].
assert (D := cond_pos d). exists (d/2). split; [lra|]. split; [lra|]. intros t Ht.
destruct (Rle_dec t (PI/2 - e)); [apply H2; lra|].
apply Hd. unfold ball; simpl; unfold AbsRing_ball, abs, minus, plus, opp; simpl. rewrite Rabs_right; lra.
Qed.

Section FirstEquation.
Variables a b : R.
Hypothesis Ha : 0 < a.
Hypothesis Hb : 0 < b < 1.

Lemma k_integrable c e s t : regular b c e -> 0 <= s -> s <= t -> t <= PI/2 - e -> ex_RInt (k a b c) s t.
Proof.
intros [H1 H2] Hs Hst Ht. apply (@ex_RInt_continuous R_CompleteNormedModule).
intros z. rewrite Rmin_left, Rmax_right by lra. intros Hz. apply k_continuous; trivial. apply H2; lra.
Qed.

Theorem F_pos c e : regular b c e -> 0 < F a b c e.
Proof.
intros [H1 H2]. unfold F. apply Rmult_lt_0_compat; [lra|]. apply RInt_gt_0; [lra| |].
- intros t Ht. apply (k_pos a b); trivial. apply H2; lra.
- intros t Ht. apply k_continuous; trivial. apply H2; lra.
Qed.

Theorem F_decreasing_c c d e : regular b c e -> c < d -> F a b d e < F a b c e.
Proof.
intros [H1 H2] L. unfold F. apply Rmult_lt_compat_l; [lra|]. apply RInt_lt; [lra| | |].
- intros t Ht. apply k_continuous; trivial. apply H2; lra.
- intros t Ht. apply k_continuous; trivial. specialize (H2 t Ht). lra.
- intros t Ht. apply (k_decreasing a b); trivial. apply H2; lra.
Qed.

Theorem F_decreasing_e c d e : regular b c d -> d < e < PI/2 -> F a b c e < F a b c d.
Proof.
intros H He. unfold F. apply Rmult_lt_compat_l; [lra|].
rewrite <- (RInt_Chasles (k a b c) 0 (PI/2 - e) (PI/2 - d)).
2: apply (k_integrable c d); trivial; lra. 2: apply (k_integrable c d); trivial; lra.
unfold plus; simpl. 
assert (0 < RInt (k a b c) (PI/2 - e) (PI/2 - d)); [|lra].
destruct H as [H1 H2]. apply RInt_gt_0; [lra| |].
- intros t Ht. apply (k_pos a b); trivial. apply H2; lra.
- intros t Ht. apply k_continuous; trivial. apply H2; lra.
Qed.

(** Differentiable in e, with the derivative of the paper (twice, since F is twice the integral of equation (23)). *)
Theorem F_derive_e c e : regular b c e -> is_derive (F a b c) e (- (2 * k a b c (PI/2 - e))).
Proof.
intros H. destruct (regular_open_e b c e H) as [m [Hm Reg]].
unfold F. evar_last. apply is_derive_scal.
apply (is_derive_comp (fun t => RInt (k a b c) 0 t) (fun e => PI/2 - e)).
- apply (is_derive_RInt (k a b c) _ 0).
  + assert (P : 0 < Rmin m (PI/2 - e)) by (apply Rmin_pos; destruct H; lra).
    exists (mkposreal _ P). intros t Ht. apply (RInt_correct (V:=R_CompleteNormedModule)).
    unfold ball in Ht; simpl in Ht; unfold AbsRing_ball, abs, minus, plus, opp in Ht; simpl in Ht. apply Rabs_def2 in Ht.
    assert (L1 := Rmin_l m (PI/2 - e)). assert (L2 := Rmin_r m (PI/2 - e)).
    apply (k_integrable c (e - m)); trivial; lra.
  + destruct H as [H1 H2]. apply k_continuous; trivial. apply H2; lra.
- auto_derive; trivial.
- unfold scal; simpl; unfold mult; simpl. match goal with |- @eq _ ?l ?r => change (@eq R l r) end. ring.
Qed.

(** Differentiable in c, under the integral sign: the numerator of equation (24). *)
Theorem F_derive_c c e : regular b c e ->
  is_derive (fun c => F a b c e) c (- RInt (fun t => k a b c t / (c + b * cos t ^2)) 0 (PI/2 - e)).
Proof.
intros H. destruct (regular_open_c b c e H) as [m [Hm Reg]]. assert (He : e < PI/2) by apply H.
assert (Loc : locally c (fun d => regular b d e)).
{ exists (mkposreal m Hm). intros d Hd. unfold ball in Hd; simpl in Hd; unfold AbsRing_ball, abs, minus, plus, opp in Hd; simpl in Hd.
  apply Rabs_def2 in Hd. apply (regular_more_c b (c - m)); trivial; lra. }
unfold F. evar_last. apply is_derive_scal.
apply (is_derive_RInt_param (fun c t => k a b c t)).
- revert Loc. apply filter_imp. intros d [_ Hd] t. rewrite Rmin_left, Rmax_right by lra. intros Ht.
  eexists. apply (k_derive a b); trivial. now apply Hd.
- rewrite Rmin_left, Rmax_right by lra. intros t Ht.
  assert (P : 0 < c + b * cos t ^2) by (apply H; lra).
  assert (C2 : continuity_2d_pt (fun c t => c + b * cos t ^2) c t).
  { apply continuity_2d_pt_plus. apply continuity_2d_pt_id1.
    apply (continuity_1d_2d_pt_comp (fun s => b * cos s ^2) (fun _ t => t)). 2: apply continuity_2d_pt_id2.
    apply continuity_pt_filterlim, (ex_derive_continuous (fun s => b * cos s ^2)). auto_derive; trivial. }
  assert (C1 : continuity_2d_pt (fun _ t => cos t ^2) c t).
  { apply (continuity_1d_2d_pt_comp (fun s => cos s ^2) (fun _ t => t)). 2: apply continuity_2d_pt_id2.
    apply continuity_pt_filterlim, (ex_derive_continuous (fun s => cos s ^2)). auto_derive; trivial. }
  apply (continuity_2d_pt_ext_loc (fun d s => - (k a b d s / (2 * (d + b * cos s ^2))))).
  + assert (Q : locally_2d (fun d s => 0 < d + b * cos s ^2) c t).
    { destruct (C2 (mkposreal _ P)) as [dl Hdl]. exists dl. intros x y Hx Hy. specialize (Hdl x y Hx Hy). simpl in Hdl.
      apply Rabs_def2 in Hdl. simpl. lra. }
    revert Q. apply locally_2d_impl. apply locally_2d_forall. intros d s Hds. symmetry. apply is_derive_unique. now apply (k_derive a b).
  + assert (B := bcos2_range b Hb t).
    assert (N : sqrt ((a + b * cos t ^2) * (c + b * cos t ^2)) <> 0).
    { apply Rgt_not_eq, sqrt_lt_R0, Rmult_lt_0_compat; lra. }
    apply (continuity_2d_pt_ext (fun d s => (-1) * ((1 - b * cos s ^2) * / sqrt ((a + b * cos s ^2) * (d + b * cos s ^2)) * / (2 * (d + b * cos s ^2))))).
    { intros x y. unfold k, Rdiv. ring. }
    apply continuity_2d_pt_mult. apply continuity_2d_pt_const.
    apply continuity_2d_pt_mult. apply continuity_2d_pt_mult.
    * apply (continuity_1d_2d_pt_comp (fun s => 1 - b * s) (fun _ t => cos t ^2)); trivial.
      apply continuity_pt_filterlim, (ex_derive_continuous (fun s => 1 - b * s)). auto_derive; trivial.
    * apply continuity_2d_pt_inv; [|exact N].
      apply (continuity_1d_2d_pt_comp sqrt (fun d s => (a + b * cos s ^2) * (d + b * cos s ^2))).
      { apply continuity_pt_sqrt. apply Rmult_le_pos; lra. }
      apply continuity_2d_pt_mult; trivial.
      apply (continuity_1d_2d_pt_comp (fun s => a + b * s) (fun _ t => cos t ^2)); trivial.
      apply continuity_pt_filterlim, (ex_derive_continuous (fun s => a + b * s)). auto_derive; trivial.
    * apply continuity_2d_pt_inv; [|lra]. apply continuity_2d_pt_mult; trivial. apply continuity_2d_pt_const.
- revert Loc. apply filter_imp. intros d Hd. apply (k_integrable d e); trivial; lra.
- rewrite (RInt_ext _ (fun t => scal (- /2) (k a b c t / (c + b * cos t ^2)))).
  2:{ rewrite Rmin_left, Rmax_right by lra. intros t Ht. assert (P : 0 < c + b * cos t ^2) by (apply H; lra).
      unfold scal; simpl; unfold mult; simpl. 
      transitivity (- (k a b c t / (2 * (c + b * cos t ^2)))).
      - apply is_derive_unique. now apply (k_derive a b).
      - simpl in *. match goal with |- @eq _ ?l ?r => change (@eq R l r) end. field. lra. }
  rewrite (RInt_scal (V:=R_CompleteNormedModule)).
  + unfold scal; simpl; unfold mult; simpl. match goal with |- @eq _ ?l ?r => change (@eq R l r) end. field.
  + apply (@ex_RInt_continuous R_CompleteNormedModule). rewrite Rmin_left, Rmax_right by lra. intros t Ht.
    assert (P : 0 < c + b * cos t ^2) by (apply H; lra).
    apply (continuous_mult (k a b c) (fun t => / (c + b * cos t ^2))). now apply k_continuous.
    apply (ex_derive_continuous (fun t => / (c + b * cos t ^2))). auto_derive. simpl in P. lra.
Qed.

(** Jointly continuous, by monotonicity. *)
Theorem F_continuous c e : regular b c e -> continuity_2d_pt (F a b) c e.
Proof.
intros H v. assert (V := cond_pos v). assert (He : e < PI/2) by apply H.
destruct (regular_open_c b c e H) as [m [Hm Reg]].
assert (C : continuous (fun c => F a b c e) c).
{ apply (ex_derive_continuous (fun c => F a b c e)). eexists. now apply F_derive_c. }
assert (NC : locally c (fun d => Rabs (F a b d e - F a b c e) < v/2)).
{ apply (C (fun y => Rabs (y - F a b c e) < v/2)). assert (V2 : 0 < v/2) by lra. exists (mkposreal _ V2). intros y Hy. exact Hy. }
destruct NC as [d1 Hd1]. assert (D1 := cond_pos d1).
set (d := Rmin (d1/2) m). assert (Dp : 0 < d) by (apply Rmin_pos; lra). assert (DL := Rmin_l (d1/2) m). assert (DR := Rmin_r (d1/2) m). fold d in DL, DR.
assert (U : Rabs (F a b (c - d) e - F a b c e) < v/2).
{ apply Hd1. unfold ball; simpl; unfold AbsRing_ball, abs, minus, plus, opp; simpl. rewrite Rabs_left; lra. }
assert (W : Rabs (F a b (c + d) e - F a b c e) < v/2).
{ apply Hd1. unfold ball; simpl; unfold AbsRing_ball, abs, minus, plus, opp; simpl. rewrite Rabs_right; lra. }
assert (R1 : regular b (c - d) e) by (apply (regular_more_c b (c - m)); trivial; lra).
assert (R2 : regular b (c + d) e) by (apply (regular_more_c b (c - m)); trivial; lra).
assert (NE : forall g, regular b g e -> exists r, 0 < r /\ regular b g (e - r) /\ e + r < PI/2 /\ forall f, e - r <= f <= e + r -> Rabs (F a b g f - F a b g e) < v/2).
{ intros g Rg. assert (Cg : continuous (F a b g) e).
  { apply (ex_derive_continuous (F a b g)). eexists. now apply F_derive_e. }
  assert (N : locally e (fun f => Rabs (F a b g f - F a b g e) < v/2)).
  { apply (Cg (fun y => Rabs (y - F a b g e) < v/2)). assert (V2 : 0 < v/2) by lra. exists (mkposreal _ V2). intros y Hy. exact Hy. }
  destruct N as [r1 Hr1]. assert (P1 := cond_pos r1). destruct (regular_open_e b g e Rg) as [r2 [P2 Rr2]].
  set (r := Rmin (r1/2) (Rmin r2 ((PI/2 - e)/2))).
  assert (Q1 := Rmin_l (r1/2) (Rmin r2 ((PI/2 - e)/2))). assert (Q2 := Rmin_r (r1/2) (Rmin r2 ((PI/2 - e)/2))). fold r in Q1, Q2.
  assert (Q3 := Rmin_l r2 ((PI/2 - e)/2)). assert (Q4 := Rmin_r r2 ((PI/2 - e)/2)).
  assert (Pr : 0 < r) by (unfold r; repeat apply Rmin_pos; lra).
  exists r. split; [lra|]. split; [apply (regular_more_e b g (e - r2)); trivial; lra|]. split; [lra|].
  intros f Hf. apply Hr1. unfold ball; simpl; unfold AbsRing_ball, abs, minus, plus, opp; simpl. apply Rabs_def1; lra. }
destruct (NE _ R1) as [r1 [P1 [S1 [T1 N1]]]]. destruct (NE _ R2) as [r2 [P2 [S2 [T2 N2]]]].
set (r := Rmin r1 r2). assert (RP : 0 < r) by (apply Rmin_pos; lra). assert (RL := Rmin_l r1 r2). assert (RR := Rmin_r r1 r2). fold r in RL, RR.
assert (DD : 0 < Rmin d r) by (apply Rmin_pos; lra).
exists (mkposreal _ DD). simpl. intros x y Hx Hy.
assert (L1 := Rmin_l d r). assert (L2 := Rmin_r d r).
apply Rabs_def2 in Hx. apply Rabs_def2 in Hy. apply Rabs_def2 in U. apply Rabs_def2 in W.
assert (X1 := N1 (e - r) ltac:(lra)). assert (X2 := N2 (e + r) ltac:(lra)). apply Rabs_def2 in X1. apply Rabs_def2 in X2.
assert (Y1 : regular b (c - d) (e - r)) by (apply (regular_more_e b _ (e - r1)); trivial; lra).
assert (Y2 : regular b x (e - r)) by (apply (regular_more_c b (c - d)); trivial; lra).
assert (Y3 : regular b x y) by (apply (regular_more_e b _ (e - r)); trivial; lra).
assert (Z1 := F_decreasing_c (c - d) x (e - r) Y1 ltac:(lra)). assert (Z2 := F_decreasing_e x (e - r) y Y2 ltac:(lra)).
assert (Z3 := F_decreasing_e x y (e + r) Y3 ltac:(lra)). 
assert (Z4 := F_decreasing_c x (c + d) (e + r) ltac:(apply (regular_more_e b _ y); trivial; lra) ltac:(lra)).
apply Rabs_def1; lra.
Qed.

(** Lemma 1 where the first implicit equation holds: one defect for one c, and one c for one defect. *)
Theorem one_defect c d e : regular b c d -> regular b c e -> F a b c d = 2*PI -> F a b c e = 2*PI -> d = e.
Proof.
intros H1 H2 E1 E2. destruct (Rtotal_order d e) as [L|[L|L]]; trivial.
- assert (N := F_decreasing_e c d e H1 ltac:(destruct H2; lra)). lra.
- assert (N := F_decreasing_e c e d H2 ltac:(destruct H1; lra)). lra.
Qed.

(** Proposition 2: the defect of the first implicit equation decreases (strictly, hence is injective) as c increases. *)
Theorem proposition_2 c d e f : regular b c e -> regular b d f -> F a b c e = 2*PI -> F a b d f = 2*PI -> c < d -> f < e.
Proof.
intros H1 H2 E1 E2 L. apply Rnot_le_lt. intros M.
assert (N := F_decreasing_c c d e H1 L).
assert (F a b d f <= F a b d e).
{ destruct M as [M|<-]; [|lra]. left. apply F_decreasing_e. apply (regular_more_c b c); trivial; lra. destruct H2; lra. }
lra.
Qed.
End FirstEquation.

(** F decreases strictly in a, too: the inequality of the proofs of lemmas 4 and 5. *)
Theorem F_decreasing_a a a' b c e : 0 < a -> 0 < b < 1 -> regular b c e -> a < a' -> F a' b c e < F a b c e.
Proof.
intros Ha Hb [H1 H2] L. unfold F. apply Rmult_lt_compat_l; [lra|]. apply RInt_lt; [lra| | |].
- intros t Ht. apply k_continuous; trivial. apply H2; lra.
- intros t Ht. apply k_continuous; trivial. lra. apply H2; lra.
- intros t Ht. specialize (H2 t ltac:(lra)). assert (B := bcos2_range b Hb t). unfold k, Rdiv. apply Rmult_lt_compat_l; [lra|].
  assert (P : 0 < (a + b * cos t ^2) * (c + b * cos t ^2)) by (apply Rmult_lt_0_compat; lra).
  assert (P2 : (a + b * cos t ^2) * (c + b * cos t ^2) < (a' + b * cos t ^2) * (c + b * cos t ^2)) by (apply Rmult_lt_compat_r; lra).
  apply Rinv_lt_contravar.
  + apply Rmult_lt_0_compat; apply sqrt_lt_R0; lra.
  + apply sqrt_lt_1_alt. lra.
Qed.
