(** The paper's own form of F, in x = cos^2 psi: with u = sin^2 e,
      F(c,u) = (1/sqrt (ab)) integral over u..1 of (1 - bx) / sqrt (x (1-x) (1 + bx/a) (x + c/b)) dx,
    equation (22), is an improper integral (x = 1, and x = u where c = -bu or u = 0). Here it is one in Coquelicot's sense, and its value is
    the F of FirstEquation.v for c > -bu, and the G of HalfPhase.v for c = -bu: the function F(-bu,u) of equation (14) and appendix A. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Polhode Require HalfPhase.
From Polhode Require Import FirstEquation Separatrix FirstEquationEnds.
Open Scope R_scope.

Section InX.
Variables a b : R.
Hypothesis Ha : 0 < a.
Hypothesis Hb : 0 < b < 1.

(** The integrand of equation (22), with its factor *)
Definition kx (c x : R) : R := / sqrt (a*b) * ((1 - b*x) / sqrt (x * (1 - x) * (1 + b/a*x) * (x + c/b))).

Lemma kx_continuous c x : 0 < x < 1 -> 0 < c + b*x -> continuous (kx c) x.
Proof.
intros Hx Hc. assert (0 < b/a*x) by (apply Rmult_lt_0_compat; [apply Rdiv_lt_0_compat; lra|lra]).
assert (Hc2 : 0 < x + c/b). { replace (x + c/b) with ((c + b*x)/b) by (field; lra). apply Rdiv_lt_0_compat; lra. }
assert (P : 0 < x * (1 - x) * (1 + b/a*x) * (x + c/b)) by (repeat apply Rmult_lt_0_compat; lra).
assert (S := sqrt_lt_R0 _ P). apply (ex_derive_continuous (kx c)). unfold kx. auto_derive.
unfold Rminus, Rdiv in *. split; [exact P|split; [|trivial]]. lra.
Qed.

(** The substitution x = cos^2 psi, inside *)
Lemma substitution c s t : 0 < s -> s <= t -> t < PI/2 -> 0 < c + b * cos t ^2 ->
  is_RInt (kx c) (cos t ^2) (cos s ^2) (2 * RInt (k a b c) s t).
Proof.
intros Hs Hst Ht Hc. assert (P := PI_RGT_0).
assert (CT : forall z, s <= z <= t -> 0 < cos z /\ 0 < sin z /\ 0 < cos z ^2 < 1 /\ 0 < c + b * cos z ^2).
{ intros z Hz. destruct (cos_inside z ltac:(lra)) as [C1 [C2 C3]]. split; [lra|]. split; [apply sin_gt_0; lra|]. split; [lra|].
  assert (CC : cos t <= cos z) by (apply cos_decr_1; lra). assert (0 < cos t) by (apply cos_gt_0; lra).
  assert (b * cos t ^2 <= b * cos z ^2) by (apply Rmult_le_compat_l; [lra|]; nra). lra. }
assert (KI : ex_RInt (k a b c) s t).
{ apply (@ex_RInt_continuous R_CompleteNormedModule). rewrite Rmin_left, Rmax_right by lra. intros z Hz. apply k_continuous; trivial. now apply CT. }
assert (C := RInt_comp (V:=R_CompleteNormedModule) (kx c) (fun z => cos z ^2) (fun z => - (2 * cos z * sin z)) t s).
rewrite Rmin_right, Rmax_left in C by lra.
replace (2 * RInt (k a b c) s t) with (RInt (kx c) (cos t ^2) (cos s ^2)).
{ apply (RInt_correct (V:=R_CompleteNormedModule)). apply (@ex_RInt_continuous R_CompleteNormedModule).
  assert (L : cos t ^2 <= cos s ^2). { destruct (CT s ltac:(lra)) as [Q1 _]. destruct (CT t ltac:(lra)) as [Q2 _]. assert (cos t <= cos s) by (apply cos_decr_1; lra). nra. }
  rewrite Rmin_left, Rmax_right by trivial. intros z Hz.
  destruct (CT s ltac:(lra)) as [_ [_ [Q3 _]]]. destruct (CT t ltac:(lra)) as [_ [_ [Q4 _]]].
  apply kx_continuous. lra. assert (b * cos t ^2 <= b * z) by (apply Rmult_le_compat_l; lra). lra. }
rewrite <- C; clear C.
- rewrite (RInt_ext _ (fun z => scal (-2) (k a b c z))).
  + rewrite (RInt_scal (V:=R_CompleteNormedModule)) by (apply ex_RInt_swap; exact KI).
    rewrite <- (opp_RInt_swap (k a b c) s t) by exact KI.
    unfold scal, opp; simpl; unfold mult; simpl. match goal with |- @eq _ ?l ?r => change (@eq R l r) end. ring.
  + rewrite Rmin_right, Rmax_left by lra. intros z Hz. destruct (CT z ltac:(lra)) as [Q1 [Q2 [Q3 Q4]]].
    unfold scal; simpl; unfold mult; simpl. unfold kx, k. change (cos z * (cos z * 1)) with (cos z ^2).
    assert (B := bcos2_range b Hb z). set (x := cos z ^2) in *.
    assert (P1 : 0 < (a + b*x) * (c + b*x)) by (apply Rmult_lt_0_compat; lra). assert (S1 := sqrt_lt_R0 _ P1).
    assert (Sab := sqrt_ab_pos a b Ha Hb).
    assert (X1 : x * (1 - x) = (cos z * sin z)^2). { unfold x. generalize (sin2_cos2 z). unfold Rsqr. intros E. replace (1 - cos z ^2) with (sin z ^2) by (simpl; lra). ring. }
    assert (E : sqrt (a*b) * sqrt (x * (1 - x) * (1 + b/a*x) * (x + c/b)) = cos z * sin z * sqrt ((a + b*x) * (c + b*x))).
    { rewrite <- sqrt_mult_alt by (apply Rmult_le_pos; lra).
      replace (a*b * (x * (1 - x) * (1 + b/a*x) * (x + c/b))) with (x * (1-x) * ((a + b*x) * (c + b*x))) by (field; lra).
      rewrite X1. rewrite sqrt_mult_alt by apply pow2_ge_0. rewrite sqrt_pow2; trivial. apply Rmult_le_pos; lra. }
    assert (S2 : 0 < sqrt (x * (1 - x) * (1 + b/a*x) * (x + c/b))).
    { apply (Rmult_lt_reg_l (sqrt (a*b))); trivial. rewrite Rmult_0_r, E. repeat apply Rmult_lt_0_compat; trivial. }
    match goal with |- @eq _ ?l ?r => change (@eq R l r) end.
    transitivity (- (2 * cos z * sin z) * ((1 - b*x) / (sqrt (a*b) * sqrt (x * (1 - x) * (1 + b/a*x) * (x + c/b))))).
    { field. lra. } rewrite E. field. lra.
- intros z Hz. destruct (CT z ltac:(lra)) as [Q1 [Q2 [Q3 Q4]]]. now apply kx_continuous.
- intros z Hz. split. auto_derive; trivial. ring. apply (ex_derive_continuous (fun z => - (2 * cos z * sin z))). auto_derive; trivial.
Qed.

(** The part of F near psi = 0 is small. *)
Lemma F_small c f d : 0 <= f -> regular b c f -> 0 < d -> exists g0, f < g0 < PI/2 /\ forall g, g0 <= g < PI/2 -> 0 < F a b c g < d.
Proof.
intros Hf Reg Hd. assert (He : f < PI/2) by apply Reg. assert (P := PI_RGT_0).
assert (M : 0 < c + b * sin f ^2) by (apply regular_iff in Reg; lra). set (m := c + b * sin f ^2) in *.
assert (AM : 0 < a*m) by (apply Rmult_lt_0_compat; lra). assert (S := sqrt_lt_R0 _ AM).
assert (KB : forall t, 0 <= t <= PI/2 - f -> k a b c t <= / sqrt (a*m)).
{ intros t Ht. assert (B := bcos2_range b Hb t). unfold k.
  assert (C : sin f <= cos t). { rewrite <- cos_shift. apply cos_decr_1; lra. } assert (0 <= sin f) by (apply sin_ge_0; lra).
  assert (b * sin f ^2 <= b * cos t ^2) by (apply Rmult_le_compat_l; [lra|]; nra).
  assert (L : sqrt (a*m) <= sqrt ((a + b * cos t ^2) * (c + b * cos t ^2))) by (apply sqrt_le_1_alt, Rmult_le_compat; unfold m in *; lra).
  unfold Rdiv. rewrite <- (Rmult_1_l (/ sqrt (a*m))). apply Rmult_le_compat; try lra. apply Rlt_le, Rinv_0_lt_compat; lra. apply Rinv_le_contravar; lra. }
set (r := Rmin ((PI/2 - f)/2) (d * sqrt (a*m) / 4)).
assert (DS : 0 < d * sqrt (a*m) / 4) by (apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat; lra|lra]).
assert (R0 : 0 < r) by (apply Rmin_pos; lra).
assert (L1 := Rmin_l ((PI/2 - f)/2) (d * sqrt (a*m) / 4)). assert (L2 := Rmin_r ((PI/2 - f)/2) (d * sqrt (a*m) / 4)). fold r in L1, L2.
exists (PI/2 - r). split; [lra|]. intros g Hg.
assert (Rg : regular b c g) by (apply (regular_more_e b c f); trivial; lra). split; [now apply F_pos|].
apply Rle_lt_trans with (2 * (/ sqrt (a*m) * (PI/2 - g))).
- unfold F. apply Rmult_le_compat_l; [lra|].
  replace (/ sqrt (a*m) * (PI/2 - g)) with (RInt (fun _ => / sqrt (a*m)) 0 (PI/2 - g)).
  2:{ rewrite RInt_const. unfold scal; simpl; unfold mult; simpl. ring. }
  apply RInt_le; [lra| | |].
  + apply (k_integrable a b Ha Hb c g); trivial; lra.
  + apply (@ex_RInt_const R_NormedModule).
  + intros t Ht. apply KB; lra.
- apply (Rmult_lt_reg_r (sqrt (a*m))); trivial. replace (2 * (/ sqrt (a*m) * (PI/2 - g)) * sqrt (a*m)) with (2 * (PI/2 - g)) by (field; lra). lra.
Qed.

Lemma sin2_increasing e f : 0 <= e -> f <= PI/2 -> e < f -> sin e ^2 < sin f ^2.
Proof. intros He Hf L. assert (P := PI_RGT_0). assert (0 <= sin e) by (apply sin_ge_0; lra). assert (sin e < sin f) by (apply sin_increasing_1; lra). nra. Qed.

Lemma sin2_increasing_inv e f : 0 <= f -> e <= PI/2 -> sin e ^2 < sin f ^2 -> e < f.
Proof.
intros He Hf L. apply Rnot_le_lt. intros [N|N]; [|subst; lra]. assert (M := sin2_increasing f e He Hf N). lra.
Qed.

(** The improper integral from the behaviour of F at the lower end *)
Lemma improper c e L : 0 <= e < PI/2 -> (forall f, e < f < PI/2 -> regular b c f) ->
  (forall d, 0 < d -> exists f0, e < f0 < PI/2 /\ forall f, e < f < f0 -> Rabs (F a b c f - L) < d) ->
  is_RInt_gen (kx c) (at_right (sin e ^2)) (at_left 1) L.
Proof.
intros He Reg Lim. assert (P := PI_RGT_0). intros Q [d HQ]. assert (D := cond_pos d).
destruct (Lim (d/2) ltac:(lra)) as [f0 [Hf0 N0]].
destruct (F_small c f0 (d/2) ltac:(lra) (Reg f0 Hf0) ltac:(lra)) as [g0 [Hg0 N1]].
assert (I0 := sin2_increasing e f0 ltac:(lra) ltac:(lra) ltac:(lra)).
assert (I1 := sin2_increasing g0 (PI/2) ltac:(lra) ltac:(lra) ltac:(lra)). rewrite sin_PI2 in I1. replace (1^2) with 1 in I1 by ring.
assert (D0 : 0 < sin f0 ^2 - sin e ^2) by lra. assert (D1 : 0 < 1 - sin g0 ^2) by lra.
apply (Filter_prod _ _ _ (fun x => sin e ^2 < x < sin f0 ^2) (fun y => sin g0 ^2 < y < 1)).
- exists (mkposreal _ D0). intros x Hx Lx. change (Rabs (x - sin e ^2) < sin f0 ^2 - sin e ^2) in Hx. apply Rabs_def2 in Hx. lra.
- exists (mkposreal _ D1). intros x Hx Lx. change (Rabs (x - 1) < 1 - sin g0 ^2) in Hx. apply Rabs_def2 in Hx. lra.
- intros x y Hx Hy. assert (X0 := pow2_ge_0 (sin e)). assert (Y0 := pow2_ge_0 (sin g0)).
  assert (X1 : sin f0 ^2 < 1). { assert (M := sin2_increasing f0 (PI/2) ltac:(lra) ltac:(lra) ltac:(lra)). rewrite sin_PI2 in M. lra. }
  destruct (angle_of_u x ltac:(lra)) as [f [Hf Ef]]. destruct (angle_of_u y ltac:(lra)) as [g [Hg Eg]].
  assert (F1 : e < f) by (apply sin2_increasing_inv; lra). assert (F2 : f < f0) by (apply sin2_increasing_inv; lra).
  assert (G1 : g0 < g) by (apply sin2_increasing_inv; lra).
  exists (F a b c f - F a b c g). split.
  + cbn [fst snd]. rewrite <- Ef, <- Eg, <- (cos_shift f), <- (cos_shift g).
    assert (Rf := Reg f ltac:(lra)).
    replace (F a b c f - F a b c g) with (2 * RInt (k a b c) (PI/2 - g) (PI/2 - f)).
    * apply substitution; try lra. apply Rf; lra.
    * unfold F. rewrite <- (RInt_Chasles (k a b c) 0 (PI/2 - g) (PI/2 - f)).
      2: apply (k_integrable a b Ha Hb c f); trivial; lra. 2: apply (k_integrable a b Ha Hb c f); trivial; lra.
      unfold plus; simpl. match goal with |- @eq _ ?l ?r => change (@eq R l r) end. ring.
  + apply HQ. change (Rabs (F a b c f - F a b c g - L) < d). assert (A := N0 f ltac:(lra)). assert (B := N1 g ltac:(lra)). apply Rabs_def2 in A. apply Rabs_def1; lra.
Qed.

(** Equation (22): before S, for 0 <= u = sin^2 e < 1 and c > -b u. *)
Theorem equation_22 c e : 0 <= e < PI/2 -> - b * sin e ^2 < c ->
  is_RInt_gen (kx c) (at_right (sin e ^2)) (at_left 1) (F a b c e).
Proof.
intros He Hc. assert (Reg : regular b c e) by (now apply regular_iff; [lra| |]).
apply improper; trivial.
- intros f Hf. apply (regular_more_e b c e); trivial; lra.
- intros d Hd. destruct (F_continuity_e a b Ha Hb c e Reg d Hd) as [m [Hm N]].
  assert (M1 := Rmin_l (m/2) ((PI/2 - e)/2)). assert (M2 := Rmin_r (m/2) ((PI/2 - e)/2)).
  assert (M0 : 0 < Rmin (m/2) ((PI/2 - e)/2)) by (apply Rmin_pos; lra).
  exists (e + Rmin (m/2) ((PI/2 - e)/2)). split; [lra|]. intros f Hf. apply N. split. split; [exact Logic.I|lra].
  simpl. unfold R_dist. rewrite Rabs_right; lra.
Qed.

(** Equations (14) and (41): on S, c = -b u. *)
Theorem equation_14 e : 0 < e < PI/2 ->
  is_RInt_gen (kx (- b * sin e ^2)) (at_right (sin e ^2)) (at_left 1) (HalfPhase.G a b (sin e ^2)).
Proof.
intros He. apply improper; [lra| |].
- intros f Hf. now apply regular_on_S.
- intros d Hd. assert (T := G_improper_integral a b Ha Hb e He).
  destruct (proj1 (filterlim_locally _ _) T (mkposreal d Hd)) as [m Hm]. assert (M := cond_pos m).
  assert (M1 := Rmin_l (m/2) ((PI/2 - e)/2)). assert (M2 := Rmin_r (m/2) ((PI/2 - e)/2)).
  assert (M0 : 0 < Rmin (m/2) ((PI/2 - e)/2)) by (apply Rmin_pos; lra).
  exists (e + Rmin (m/2) ((PI/2 - e)/2)). split; [lra|]. intros f Hf. apply (Hm f); [|lra].
  change (Rabs (f - e) < m). rewrite Rabs_right; lra.
Qed.

(** The same in u, with the integrand of appendix A: F(-bu,u) is G(u). *)
Theorem appendix_A_integral u : 0 < u < 1 ->
  is_RInt_gen (fun x => / sqrt (a*b) * ((1 - b*x) / sqrt (x * (1 - x) * (1 + b/a*x) * (x - u)))) (at_right u) (at_left 1) (HalfPhase.G a b u).
Proof.
intros Hu. destruct (angle_of_u u Hu) as [e [He Ee]]. assert (T := equation_14 e He). rewrite Ee in T.
revert T. apply is_RInt_gen_ext. 
apply (Filter_prod _ _ _ (fun _ => True) (fun _ => True)); try (apply filter_forall; trivial).
intros x y _ _ z _. unfold kx. replace (z + - b * u / b) with (z - u) by (field; lra). reflexivity.
Qed.
End InX.
