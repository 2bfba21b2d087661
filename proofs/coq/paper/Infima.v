(** The least values over physical bodies (section 6 of the paper), without the paper's limit formula.
    - The defect on the separatrix: e0 > pi - 2 arctan exp pi for every physical body, and this is the infimum; it is not attained.
    - The perfect twist: c0/b > beta for every physical body, beta being the root of K (1/(1+beta)) = pi sqrt (1+beta), and this is the
      infimum; it is not attained.
    For planar bodies (ab + 2b = 1) both lie below what tends to these numbers as b tends to 0. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Polhode Require Beta Theorem2 FreeBody Theorems.
From Polhode Require Import GaussIntegral Physical Theorem1 FirstEquation Separatrix.
Open Scope R_scope.

(** The a and b of physical bodies: a > 0, 0 < b < 1 and I >= 1, by proposition 1. *)
Definition physical_parameters (a b : R) : Prop := 0 < a /\ 0 < b < 1 /\ 1 <= geometric_constant a b.
Theorem physical_parameters_iff a b : physical_parameters a b <->
  exists moment, Theorems.body moment /\ Theorems.physical moment /\ FreeBody.par_a moment = a /\ FreeBody.par_b moment = b.
Proof.
split.
- intros [Ha [Hb I]]. set (moment := fun i => match i with FreeBody.x_axis => / (1 - b) | FreeBody.y_axis => 1 | FreeBody.z_axis => / (1 + a) end).
  assert (B : Theorems.body moment).
  { unfold Theorems.body, moment. assert (0 < / (1 + a)) by (apply Rinv_0_lt_compat; lra).
    assert (/ (1 + a) < 1) by (rewrite <- Rinv_1; apply Rinv_lt_contravar; lra). assert (1 < / (1 - b)) by (rewrite <- Rinv_1; apply Rinv_lt_contravar; lra). lra. }
  assert (Ea : FreeBody.par_a moment = a) by (unfold FreeBody.par_a, moment; field; lra).
  assert (Eb : FreeBody.par_b moment = b) by (unfold FreeBody.par_b, moment; field; lra).
  exists moment. split; [exact B|]. split; [|now split]. apply Theorems.proposition_1; trivial. unfold Theorems.constant_I. rewrite Ea, Eb. exact I.
- intros [moment [B [P [<- <-]]]]. split; [now apply Theorems.body_a_positive|]. split; [now apply Theorems.body_b_range|].
  now apply (Theorems.proposition_1 moment B).
Qed.
(** e is the defect on the separatrix; c is a perfect twist. *)
Definition defect_on_separatrix (a b e : R) : Prop := 0 < e < PI/2 /\ F a b 0 e = 2*PI.
Definition perfect_twist (a b c : R) : Prop := 0 < c < a /\ F a b c 0 = 2*PI.
(** The paper's constant *)
Definition epsilon0_min : R := PI - 2 * atan (exp PI).

Lemma epsilon0_min_other_form : epsilon0_min = 2 * atan (exp (- PI)).
Proof. unfold epsilon0_min. rewrite exp_Ropp, atan_inv by apply exp_pos. field. Qed.

(** The planar body with ab = s^2: b = (1 - s^2)/2, a = s^2/b. *)
Lemma planar s : 0 < s < 1 -> let b := (1 - s^2)/2 in let a := s^2/b in 0 < a /\ 0 < b < 1/2 /\ a*b = 1 - 2*b /\ sqrt (a*b) = s /\ physical_parameters a b.
Proof.
intros Hs b a. assert (0 < s^2 < 1) by nra. assert (B : 0 < b < 1/2) by (unfold b; lra).
assert (A : 0 < a) by (unfold a; apply Rdiv_lt_0_compat; lra).
assert (E : a*b = s^2) by (unfold a; field; lra).
assert (E2 : a*b = 1 - 2*b) by (rewrite E; unfold b; field).
split; [lra|]. split; [lra|]. split; [lra|]. split; [|split; [lra|split; [lra|]]].
- rewrite E. apply sqrt_pow2; lra.
- apply (proj2 (physical_iff a b A ltac:(lra))). lra.
Qed.

(** Every physical body stays above. *)
Theorem defect_above_minimum a b e : physical_parameters a b -> defect_on_separatrix a b e -> epsilon0_min < e.
Proof.
intros [Ha [Hb HI]] [He E]. assert (P := PI_RGT_0). rewrite epsilon0_min_other_form.
destruct (defect_on_separatrix_bounds a b Ha Hb e He E) as [L _].
apply Rle_lt_trans with (2 := L). apply Rmult_le_compat_l; [lra|].
assert (PI / geometric_constant a b <= PI).
{ apply (Rmult_le_reg_r (geometric_constant a b)); [lra|]. 
  replace (PI / geometric_constant a b * geometric_constant a b) with (PI * 1) by (field; lra). apply Rmult_le_compat_l; lra. }
destruct H as [H|H]; [|rewrite H; lra]. left. apply atan_increasing, exp_increasing. lra.
Qed.

(** Planar bodies: e0 < 2 arctan exp (-pi sqrt (1 - 2b)). *)
Theorem planar_defect_below a b e : 0 < a -> 0 < b < 1 -> a*b = 1 - 2*b -> defect_on_separatrix a b e ->
  e < 2 * atan (exp (- (PI * sqrt (1 - 2*b)))).
Proof. intros Ha Hb H [He E]. rewrite <- H. now apply defect_on_separatrix_bounds. Qed.

(** The infimum of the defect on the separatrix over physical bodies; by the theorem above it is not attained. *)
Theorem epsilon0_infimum : is_glb_Rbar (fun e => exists a b, physical_parameters a b /\ defect_on_separatrix a b e) epsilon0_min.
Proof.
assert (P := PI_RGT_0). split.
- intros e [a [b [H1 H2]]]. simpl. left. now apply (defect_above_minimum a b).
- intros m Hm.
  assert (Some_body : forall s, 0 < s < 1 -> exists a b e, physical_parameters a b /\ defect_on_separatrix a b e /\ e < 2 * atan (exp (- (PI * s)))).
  { intros s Hs. destruct (planar s Hs) as [A [B [E1 [E2 Ph]]]]. set (b := (1-s^2)/2) in *. set (a := s^2/b) in *.
    destruct (proposition_3_1 a b A ltac:(lra)) as [e [He [E _]]].
    exists a, b, e. split; trivial. split; [now split|]. rewrite <- E2. apply defect_on_separatrix_bounds; trivial; lra. }
  destruct m as [m| |]; simpl.
  + apply Rnot_lt_le. intros L.
    assert (C : continuous (fun s => 2 * atan (exp (- (PI * s)))) 1).
    { apply (ex_derive_continuous (fun s => 2 * atan (exp (- (PI * s))))). auto_derive; trivial. }
    assert (N : locally 1 (fun s => 2 * atan (exp (- (PI * s))) < m)).
    { apply (C (fun y => y < m)). apply (open_lt m). simpl. replace (- (PI * 1)) with (- PI) by ring. rewrite <- epsilon0_min_other_form. exact L. }
    destruct N as [d Hd]. assert (D := cond_pos d). set (s := 1 - Rmin (1/2) (d/2)).
    assert (M : 0 < Rmin (1/2) (d/2)) by (apply Rmin_pos; lra). assert (M1 := Rmin_l (1/2) (d/2)). assert (M2 := Rmin_r (1/2) (d/2)).
    assert (B : 2 * atan (exp (- (PI * s))) < m).
    { apply Hd. unfold ball; simpl; unfold AbsRing_ball, abs, minus, plus, opp; simpl. unfold s. rewrite Rabs_left; lra. }
    destruct (Some_body s ltac:(unfold s; lra)) as [a [b [e [H1 [H2 H3]]]]].
    assert (B2 := Hm e). simpl in B2. assert (m <= e) by (apply B2; exists a, b; now split). lra.
  + destruct (Some_body (1/2) ltac:(lra)) as [a [b [e [H1 [H2 H3]]]]]. apply (Hm e). exists a, b; now split.
  + exact Logic.I.
Qed.

(** The perfect twist. F(c,0) between two multiples of the integral that defines beta. *)
Theorem rotating_bounds a b c : 0 < a -> 0 < b < 1 -> 0 < c ->
  2 * (geometric_constant a b * Beta.G (c/b)) < F a b c 0 /\ F a b c 0 < 2 * (/ sqrt (a*b) * Beta.G (c/b)).
Proof.
intros Ha Hb Hc. assert (P := PI_RGT_0). assert (Hcb : 0 < c/b) by (apply Rdiv_lt_0_compat; lra).
assert (Rg := regular_rotating b c 0 ltac:(lra) Hc ltac:(lra)).
assert (CS : forall m t, 0 <= t <= PI/2 - 0 -> continuous (fun t => scal m (/ sqrt (c/b + cos t ^2)) : R) t).
{ intros m t _. apply (continuous_scal_r m (fun t => / sqrt (c/b + cos t ^2))). now apply Beta.kernel_continuous. }
assert (CK : forall t, 0 <= t <= PI/2 - 0 -> continuous (k a b c) t).
{ intros t Ht. apply k_continuous; trivial. now apply Rg. }
assert (E : forall m, m * Beta.G (c/b) = RInt (fun t => scal m (/ sqrt (c/b + cos t ^2))) 0 (PI/2 - 0)).
{ intros m. rewrite (RInt_scal (V:=R_CompleteNormedModule)). unfold Beta.G. rewrite Rminus_0_r. reflexivity. now apply Beta.kernel_integrable. }
unfold F. rewrite !E. split; (apply Rmult_lt_compat_l; [lra|]); apply RInt_lt.
- lra.
- exact CK.
- exact (CS (geometric_constant a b)).
- intros t Ht. destruct (cos_inside t ltac:(lra)) as [C1 [C2 C3]].
  unfold scal; simpl; unfold mult; simpl. apply (k_lower a b Ha Hb c t); trivial. apply Rg; lra.
- lra.
- exact (CS (/ sqrt (a*b))).
- exact CK.
- intros t Ht. destruct (cos_inside t ltac:(lra)) as [C1 [C2 C3]].
  unfold scal; simpl; unfold mult; simpl. apply (k_upper a b Ha Hb c t); trivial. apply Rg; lra.
Qed.

(** For a perfect twist, pi sqrt (ab) < G (c0/b) < pi / I. *)
Theorem perfect_twist_bounds a b c : 0 < a -> 0 < b < 1 -> perfect_twist a b c ->
  PI * sqrt (a*b) < Beta.G (c/b) < PI / geometric_constant a b.
Proof.
intros Ha Hb [Hc E]. destruct (rotating_bounds a b c Ha Hb ltac:(lra)) as [L U]. rewrite E in L, U.
assert (I0 := geometric_constant_pos a b Ha Hb). assert (S := sqrt_ab_pos a b Ha Hb). split.
- apply (Rmult_lt_reg_r (/ sqrt (a*b))). now apply Rinv_0_lt_compat.
  replace (PI * sqrt (a*b) * / sqrt (a*b)) with PI by (field; lra). lra.
- apply (Rmult_lt_reg_r (geometric_constant a b)); trivial.
  replace (PI / geometric_constant a b * geometric_constant a b) with PI by (field; lra). lra.
Qed.

Lemma G_smaller x y : 0 < x -> 0 < y -> Beta.G x < Beta.G y -> y < x.
Proof.
intros Hx Hy L. apply Rnot_le_lt. intros [M|<-]; [|lra]. assert (N := Beta.G_decreasing x y Hx M). lra.
Qed.

(** The equation of beta, and that it has one root *)
Definition is_beta (beta : R) : Prop := 0 < beta /\ Beta.K (1/(1+beta)) = PI * sqrt (1+beta).

Lemma is_beta_G beta : is_beta beta -> 0 < beta /\ Beta.G beta = PI.
Proof.
intros [H E]. split; trivial. rewrite Beta.K_G in E by trivial. assert (0 < sqrt (1+beta)) by (apply sqrt_lt_R0; lra).
apply (Rmult_eq_reg_l (sqrt (1+beta))); lra.
Qed.

Lemma G_logarithmic_bound x : 0 < x -> ln (sqrt x + PI/2) - ln (sqrt x) <= Beta.G x.
Proof.
intros Hx. assert (P := PI_RGT_0). assert (S : 0 < sqrt x) by (apply sqrt_lt_R0; lra).
assert (W : is_RInt (fun t => / (sqrt x + (PI/2 - t))) 0 (PI/2) (minus (- ln (sqrt x + (PI/2 - PI/2))) (- ln (sqrt x + (PI/2 - 0))))).
{ apply (is_RInt_derive (V:=R_CompleteNormedModule) (fun t => - ln (sqrt x + (PI/2 - t)))); rewrite Rmin_left, Rmax_right by lra; intros t Ht.
  - auto_derive. lra. field. lra.
  - apply (ex_derive_continuous (fun t => / (sqrt x + (PI/2 - t)))). auto_derive. lra. }
replace (ln (sqrt x + PI/2) - ln (sqrt x)) with (minus (- ln (sqrt x + (PI/2 - PI/2))) (- ln (sqrt x + (PI/2 - 0)))).
2:{ unfold minus, plus, opp; simpl. replace (PI/2 - PI/2) with 0 by ring. rewrite Rplus_0_r, Rminus_0_r. 
    match goal with |- @eq _ ?l ?r => change (@eq R l r) end. ring. }
rewrite <- (is_RInt_unique _ _ _ _ W). unfold Beta.G. apply RInt_le; try lra.
- eexists; exact W.
- now apply Beta.kernel_integrable.
- intros t Ht. assert (C : 0 < cos t) by (apply cos_gt_0; lra).
  apply Rinv_le_contravar. apply sqrt_lt_R0. nra.
  rewrite <- (sqrt_pow2 (sqrt x + (PI/2 - t))) by lra. apply sqrt_le_1_alt.
  assert (cos t < PI/2 - t). { rewrite <- sin_shift. apply sin_lt_x. lra. }
  assert (sqrt x * sqrt x = x) by (apply sqrt_sqrt; lra). 
  assert (0 < sqrt x * (PI/2 - t)) by (apply Rmult_lt_0_compat; lra). nra.
Qed.

Theorem beta_exists : exists beta, is_beta beta /\ forall x, is_beta x -> x = beta.
Proof.
assert (P := PI_RGT_0). assert (P2 := PI2_1). assert (P4 := PI_4).
assert (S1 : sqrt (1/10000) = 1/100). { replace (1/10000) with ((1/100)^2) by field. apply sqrt_pow2. lra. }
destruct (Beta.beta_exists_unique (1/10000) 1) as [x [[H1 H2] H3]]; try lra.
- apply Rlt_le_trans with (2 := G_logarithmic_bound (1/10000) ltac:(lra)). rewrite S1.
  assert (E : ln (1/100 + PI/2) - ln (1/100) = ln (1 + 50*PI)).
  { unfold Rminus. rewrite <- ln_Rinv by lra. rewrite <- ln_mult by lra. f_equal. field. }
  rewrite E. apply Rle_lt_trans with 4; [lra|]. rewrite <- (ln_exp 4). apply ln_increasing. apply exp_pos.
  apply Rle_lt_trans with 81; [|lra].
  replace 4 with (1+1+1+1) by ring. rewrite !exp_plus. assert (X := exp_le_3). assert (Y := exp_pos 1).
  replace 81 with (3*3*3*3) by ring. repeat apply Rmult_le_compat; try lra; repeat apply Rmult_le_pos; lra.
- rewrite Beta.G_gauss_integral by lra. apply Rle_lt_trans with (PI/2/1).
  + apply gauss_integral_le; try lra. rewrite <- sqrt_1 at 1. apply sqrt_le_1_alt. lra. rewrite sqrt_1. lra.
  + lra.
- exists x. split. split; [lra|exact H2]. intros y [Hy E]. now apply H3.
Qed.

(** Every physical body stays above. *)
Theorem perfect_twist_above_beta a b c beta : physical_parameters a b -> perfect_twist a b c -> is_beta beta -> beta < c/b.
Proof.
intros [Ha [Hb HI]] Hc HB. assert (P := PI_RGT_0). destruct (is_beta_G beta HB) as [B0 B1].
destruct (perfect_twist_bounds a b c Ha Hb Hc) as [_ U].
apply G_smaller; trivial. apply Rdiv_lt_0_compat; [apply Hc|lra].
rewrite B1. apply Rlt_le_trans with (1 := U).
apply (Rmult_le_reg_r (geometric_constant a b)); [lra|]. 
replace (PI / geometric_constant a b * geometric_constant a b) with (PI * 1) by (field; lra). apply Rmult_le_compat_l; lra.
Qed.

(** Planar bodies: c0/b lies below the root t of K (1/(1+t)) = pi sqrt ((1-2b)(1+t)). *)
Theorem planar_perfect_twist_below a b c t : 0 < a -> 0 < b < 1 -> a*b = 1 - 2*b -> perfect_twist a b c ->
  0 < t -> Beta.K (1/(1+t)) = PI * sqrt ((1-2*b)*(1+t)) -> c/b < t.
Proof.
intros Ha Hb H Hc Ht E. assert (0 < a*b) by (apply Rmult_lt_0_compat; lra).
destruct (perfect_twist_bounds a b c Ha Hb Hc) as [L _]. rewrite H in L.
rewrite Beta.K_G, (sqrt_mult_alt (1-2*b)) in E by lra. assert (S : 0 < sqrt (1+t)) by (apply sqrt_lt_R0; lra).
assert (E2 : Beta.G t = PI * sqrt (1-2*b)) by (apply (Rmult_eq_reg_l (sqrt (1+t))); lra).
apply G_smaller; trivial. apply Rdiv_lt_0_compat; [apply Hc|lra]. lra.
Qed.

(** A perfect twist exists wherever a > 1/2. *)
Lemma perfect_twist_exists a b : 1/2 < a -> 0 < b < 1 -> exists c, perfect_twist a b c.
Proof.
intros Ha Hb. destruct (proj1 (proposition_3_2 a b ltac:(lra) Hb)) as [c [H1 [H2 _]]].
- unfold Theorem2.second_constant. assert (S : a < sqrt (a*(a+b))).
  { rewrite <- (sqrt_square a) at 1 by lra. apply sqrt_lt_1_alt. nra. }
  assert ((a+1)/sqrt (a*(a+b)) < 3); [|lra]. apply (Rmult_lt_reg_r (sqrt (a*(a+b)))); [lra|].
  replace ((a+1)/sqrt (a*(a+b)) * sqrt (a*(a+b))) with (a+1) by (field; lra). lra.
- exists c. now split.
Qed.

(** The infimum of c0/b over the physical bodies that have a perfect twist; by the theorem above it is not attained. *)
Theorem beta_infimum beta : is_beta beta ->
  is_glb_Rbar (fun r => exists a b c, physical_parameters a b /\ perfect_twist a b c /\ r = c/b) beta.
Proof.
intros HB. assert (P := PI_RGT_0). destruct (is_beta_G beta HB) as [B0 B1]. split.
- intros r [a [b [c [H1 [H2 ->]]]]]. simpl. left. now apply (perfect_twist_above_beta a b).
- intros m Hm.
  assert (Some_body : forall x, beta < x -> exists a b c, physical_parameters a b /\ perfect_twist a b c /\ c/b < x).
  { intros x Hx. assert (L := Beta.G_decreasing beta x B0 Hx). rewrite B1 in L. assert (GP := Beta.G_pos x ltac:(lra)).
    set (r := Beta.G x / PI). set (s := (r + 1)/2).
    assert (R1 : 0 < r < 1). { unfold r. split. apply Rdiv_lt_0_compat; lra. apply (Rmult_lt_reg_r PI); trivial. replace (Beta.G x/PI*PI) with (Beta.G x) by (field; lra). lra. }
    assert (Hs : 1/2 < s < 1) by (unfold s; lra).
    destruct (planar s ltac:(lra)) as [A [B [E1 [E2 Ph]]]]. set (b := (1-s^2)/2) in *. set (a := s^2/b) in *.
    destruct (perfect_twist_exists a b) as [c Hc]; [|lra|].
    { assert (b < 3/8) by (unfold b; nra). assert (E3 : a*b = s^2) by (unfold a; field; lra). assert (1/4 < s^2) by nra. apply Rnot_le_lt. intros N. assert (a*b <= 1/2*b) by (apply Rmult_le_compat_r; lra). lra. }
    exists a, b, c. split; trivial. split; trivial. apply G_smaller; [lra| |].
    - apply Rdiv_lt_0_compat; [apply Hc|lra].
    - destruct (perfect_twist_bounds a b c A ltac:(lra) Hc) as [U _]. rewrite E2 in U.
      apply Rlt_trans with (2 := U). replace (Beta.G x) with (PI * r) by (unfold r; field; lra). apply Rmult_lt_compat_l; unfold s; lra. }
  destruct m as [m| |]; simpl.
  + apply Rnot_lt_le. intros L. destruct (Some_body m L) as [a [b [c [H1 [H2 H3]]]]].
    assert (B2 := Hm (c/b)). simpl in B2. assert (m <= c/b) by (apply B2; exists a, b, c; split; [exact H1|split; [exact H2|reflexivity]]). lra.
  + destruct (Some_body (beta+1) ltac:(lra)) as [a [b [c [H1 [H2 H3]]]]]. apply (Hm (c/b)). exists a, b, c; split; [exact H1|split; [exact H2|reflexivity]].
  + exact Logic.I.
Qed.
