(** Where the first implicit equation has a solution, and how its branch of the curve begins at S.
    On S, c = -b u with u = sin^2 e, the integral F(c,f), f > e, tends to G(u) = F(-bu,u) as f tends to e: G is the improper integral of the paper.
    So for -b < c < 0 the equation F(c,f) = 2 pi has its one solution if and only if G(-c/b) > 2 pi, and for 0 <= c always. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Polhode Require HalfPhase.
From Polhode Require Import Theorem1 FirstEquation Separatrix.
Open Scope R_scope.
Notation h := HalfPhase.h.
Notation X := HalfPhase.X.
Notation G := HalfPhase.G.

Section Ends.
Variables a b : R.
Hypothesis Ha : 0 < a.
Hypothesis Hb : 0 < b < 1.

Section OnS.
Variable e : R.
Hypothesis He : 0 < e < PI/2.
Let r := cos e.
Let u := sin e ^2.

Lemma r_range : 0 < r < 1.
Proof. unfold r. split. apply cos_gt_0; lra. rewrite <- cos_0. apply cos_decreasing_1; lra. Qed.

Lemma u_r : u = 1 - r^2.
Proof. unfold u, r. generalize (sin2_cos2 e). unfold Rsqr. lra. Qed.

Lemma u_range : 0 < u < 1.
Proof. assert (Rr := r_range). rewrite u_r. nra. Qed.

Lemma X_r t : X u (sin t) = 1 - r^2 * cos t ^2.
Proof. unfold HalfPhase.X. rewrite u_r. generalize (sin2_cos2 t). unfold Rsqr. intros E. replace (sin t ^2) with (1 - cos t ^2) by lra. ring. Qed.

Lemma X_positive t : 0 < X u (sin t).
Proof. assert (Rr := u_range). apply HalfPhase.X_pos_any; lra. Qed.

(** The substitution sin psi = cos e cos t, by its angle psi. *)
Definition psi (t : R) := atan (r * cos t / sqrt (1 - r^2 * cos t ^2)).
Definition dpsi (t : R) := - (r * sin t / sqrt (1 - r^2 * cos t ^2)).

Lemma psi_derive t : is_derive psi t (dpsi t).
Proof.
assert (P := X_positive t). rewrite X_r in P.
unfold psi, dpsi. auto_derive.
- simpl in *. repeat split; trivial. apply Rgt_not_eq. apply sqrt_lt_R0, P.
- replace (1 - r*(r*1)*(cos t*(cos t*1))) with (1 - r^2 * cos t ^2) by ring.
  assert (S := sqrt_lt_R0 _ P). assert (Q := sqrt_sqrt _ (Rlt_le _ _ P)).
  set (s := sqrt (1 - r^2 * cos t ^2)) in *. unfold Rsqr.
  set (x := cos t) in *. set (y := sin t) in *.
  assert (D : 1 + (r*x/s)^2 = / (s*s)).
  { apply Rminus_diag_uniq. replace (1 + (r*x/s)^2 - /(s*s)) with ((s*s - (1 - r^2*x^2))/(s*s)) by (field; lra). rewrite Q. unfold Rdiv. ring. }
  match goal with |- context [/ (1 + ?z)] => replace (1 + z) with (/ (s*s)) by (rewrite <- D; simpl; field; lra) end.
  replace (1 + - (r * (r * 1) * (x * (x * 1)))) with (1 - r^2*x^2) by ring. fold s.
  apply Rminus_diag_uniq.
  match goal with |- ?l = 0 => replace l with (r*y/s*(1 - r^2*x^2 - s*s)) by (field; lra) end. rewrite Q. ring.
Qed.

Lemma psi_cos2 t : cos (psi t) ^2 = X u (sin t).
Proof.
assert (P := X_positive t). rewrite X_r in P |- *.
assert (S := sqrt_lt_R0 _ P). assert (Q := sqrt_sqrt _ (Rlt_le _ _ P)).
unfold psi. rewrite cos_atan. set (s := sqrt (1 - r^2 * cos t ^2)) in *. set (x := cos t) in *.
assert (D : 1 + (r*x/s)² = / (s*s)).
{ apply Rminus_diag_uniq. unfold Rsqr. replace (1 + (r*x/s)*(r*x/s) - /(s*s)) with ((s*s - (1 - r^2*x^2))/(s*s)) by (field; lra). rewrite Q. unfold Rdiv. ring. }
rewrite D, <- Q. rewrite sqrt_inv, sqrt_square by lra. field. lra.
Qed.

Lemma psi_PI2 : psi (PI/2) = 0.
Proof. unfold psi. rewrite cos_PI2, Rmult_0_r. unfold Rdiv. rewrite Rmult_0_l. apply atan_0. Qed.

Lemma psi_0 : psi 0 = PI/2 - e.
Proof.
unfold psi. rewrite cos_0. replace (1 - r^2 * 1^2) with (sin e ^2) by (rewrite <- u_r || (unfold r; generalize (sin2_cos2 e); unfold Rsqr; intros E; lra); unfold u; ring).
assert (0 < sin e) by (apply sin_gt_0; lra). rewrite sqrt_pow2 by lra.
rewrite <- (atan_tan (PI/2 - e)) by lra. f_equal. unfold tan. rewrite sin_shift, cos_shift. unfold r. field. lra.
Qed.

Lemma psi_decreasing s t : 0 <= s -> s < t -> t <= PI/2 -> psi t < psi s.
Proof.
intros Hs L Ht. destruct (MVT_cor2 psi dpsi s t L) as [z [E Hz]].
{ intros z Hz. apply is_derive_Reals, psi_derive. }
assert (D : dpsi z < 0); [|nra].
assert (Rr := r_range). assert (P := X_positive z). rewrite X_r in P. unfold dpsi.
assert (0 < r * sin z / sqrt (1 - r^2 * cos z ^2)); [|lra].
apply Rdiv_lt_0_compat. apply Rmult_lt_0_compat; [lra|]. apply sin_gt_0; lra. now apply sqrt_lt_R0.
Qed.

Lemma psi_range s : 0 < s < PI/2 -> 0 < psi s < PI/2 - e.
Proof.
intros Hs. rewrite <- psi_0. rewrite <- psi_PI2 at 1. split; apply psi_decreasing; lra.
Qed.

Lemma psi_onto f : e < f < PI/2 -> exists s, 0 < s < PI/2 /\ psi s = PI/2 - f.
Proof.
intros Hf. assert (P := PI_RGT_0).
destruct (Ranalysis5.IVT_interv (fun s => PI/2 - f - psi s) 0 (PI/2)) as [s [Hs Es]]; try lra.
- intros s _. apply continuity_pt_minus. apply continuity_pt_const; now intros ? ?.
  apply continuity_pt_filterlim, (ex_derive_continuous psi). eexists. apply psi_derive.
- rewrite psi_0. lra.
- rewrite psi_PI2. lra.
- exists s. split; [|lra]. split.
  + destruct (Req_dec s 0) as [Z|Z]; [|lra]. rewrite Z, psi_0 in Es. lra.
  + destruct (Req_dec s (PI/2)) as [Z|Z]; [|lra]. rewrite Z, psi_PI2 in Es. lra.
Qed.

(** The smooth form of the integral on S; at s = 0 it is G(u). *)
Definition Phi (s : R) := 2 / sqrt (a*b) * RInt (fun t => h a b (X u (sin t))) s (PI/2).

Lemma hX_continuous t : continuous (fun t => h a b (X u (sin t))) t.
Proof.
apply (continuous_comp (fun t => X u (sin t)) (h a b)). apply HalfPhase.X_continuous. apply HalfPhase.h_continuous; trivial. apply X_positive.
Qed.

Lemma hX_integrable s t : ex_RInt (fun t => h a b (X u (sin t))) s t.
Proof. apply (@ex_RInt_continuous R_CompleteNormedModule). intros z _. apply hX_continuous. Qed.

Lemma hX_pos t : 0 < h a b (X u (sin t)).
Proof.
assert (P := X_positive t). assert (U := u_range). unfold HalfPhase.h. apply Rdiv_lt_0_compat.
- assert (X u (sin t) <= 1). { unfold HalfPhase.X. generalize (SIN_bound t). intros. assert (sin t ^2 <= 1) by nra. nra. } nra.
- apply sqrt_lt_R0. now apply HalfPhase.Q_pos.
Qed.

Lemma Phi_derive s : is_derive Phi s (- (2 / sqrt (a*b) * h a b (X u (sin s)))).
Proof.
unfold Phi. evar_last. apply is_derive_scal.
apply (is_derive_RInt' (fun t => h a b (X u (sin t))) _ s (PI/2)).
- exists (mkposreal 1 Rlt_0_1). intros t _. apply (RInt_correct (V:=R_CompleteNormedModule)). apply hX_integrable.
- apply hX_continuous.
- unfold opp; simpl. match goal with |- @eq _ ?l ?r => change (@eq R l r) end. ring.
Qed.

Lemma Phi_0 : Phi 0 = G a b u.
Proof. reflexivity. Qed.

Lemma Phi_PI2 : Phi (PI/2) = 0.
Proof. unfold Phi. rewrite RInt_point. apply Rmult_0_r. Qed.

Lemma Phi_decreasing s t : s < t -> Phi t < Phi s.
Proof.
intros L. destruct (MVT_cor2 Phi (fun s => - (2 / sqrt (a*b) * h a b (X u (sin s)))) s t L) as [z [E Hz]].
{ intros z Hz. apply is_derive_Reals, Phi_derive. }
assert (0 < 2 / sqrt (a*b) * h a b (X u (sin z))); [|nra].
apply Rmult_lt_0_compat; [|apply hX_pos]. apply Rdiv_lt_0_compat; [lra|]. now apply sqrt_ab_pos.
Qed.

(** F on S, by the substitution *)
Lemma F_psi s : 0 < s < PI/2 -> F a b (- b * u) (PI/2 - psi s) = Phi s.
Proof.
intros Hs. assert (Rr := r_range). assert (U := u_range). assert (SAB := sqrt_ab_pos a b Ha Hb).
assert (Y : forall t, - b * u + b * cos (psi t) ^2 = b * (r * sin t)^2).
{ intros t. rewrite psi_cos2. unfold HalfPhase.X. rewrite u_r. simpl. ring. }
assert (Ypos : forall t, s <= t <= PI/2 -> 0 < - b * u + b * cos (psi t) ^2).
{ intros t Ht. rewrite Y. assert (0 < sin t) by (apply sin_gt_0; lra). apply Rmult_lt_0_compat; [lra|]. assert (0 < r * sin t) by (apply Rmult_lt_0_compat; lra). nra. }
assert (Hr := psi_range s Hs).
assert (Rg : regular b (- b * u) (PI/2 - psi s)).
{ apply regular_iff; [lra|lra|]. assert (Z := Ypos s ltac:(lra)). rewrite sin_shift. lra. }
assert (C := RInt_comp (V:=R_CompleteNormedModule) (k a b (- b * u)) psi dpsi s (PI/2)).
rewrite Rmin_left, Rmax_right in C by lra. rewrite psi_PI2 in C.
unfold F, Phi. replace (PI/2 - (PI/2 - psi s)) with (psi s) by ring.
rewrite <- (opp_RInt_swap (k a b (- b * u)) (psi s) 0).
2:{ apply ex_RInt_swap. apply (k_integrable a b Ha Hb (- b * u) (PI/2 - psi s)); trivial; lra. }
rewrite <- C; clear C.
- rewrite (RInt_ext _ (fun t => scal (- / sqrt (a*b)) (h a b (X u (sin t))))).
  + rewrite (RInt_scal (V:=R_CompleteNormedModule)) by apply hX_integrable.
    unfold scal, opp; simpl; unfold mult; simpl. match goal with |- @eq _ ?l ?r => change (@eq R l r) end. field. lra.
  + rewrite Rmin_left, Rmax_right by lra. intros t Ht.
    assert (S : 0 < sin t) by (apply sin_gt_0; lra). assert (RS : 0 < r * sin t) by (apply Rmult_lt_0_compat; lra).
    unfold scal; simpl; unfold mult; simpl. unfold k, dpsi. rewrite Y, psi_cos2, <- X_r.
    assert (P := X_positive t). unfold HalfPhase.h, HalfPhase.Q. set (x := X u (sin t)) in *.
    assert (SX := sqrt_lt_R0 _ P). assert (BX : 0 < b * x) by (apply Rmult_lt_0_compat; lra).
    assert (PB : 0 < b*(a + b*x)) by (apply Rmult_lt_0_compat; lra). assert (SB := sqrt_lt_R0 _ PB).
    assert (E1 : sqrt ((a + b*x) * (b * (r * sin t)^2)) = r * sin t * sqrt (b*(a+b*x))).
    { replace ((a + b*x) * (b * (r * sin t)^2)) with ((r * sin t)^2 * (b*(a+b*x))) by ring.
      rewrite sqrt_mult_alt by apply pow2_ge_0. rewrite sqrt_pow2 by lra. reflexivity. }
    assert (BA : 0 < b*x/a) by (apply Rdiv_lt_0_compat; lra).
    assert (E2 : sqrt (a*b) * sqrt (x*(1 + b*x/a)) = sqrt x * sqrt (b*(a+b*x))).
    { assert (0 < a*b) by (apply Rmult_lt_0_compat; lra). rewrite <- !sqrt_mult_alt by lra. f_equal. field. lra. }
    assert (PQ : 0 < sqrt (x*(1 + b*x/a))) by (apply sqrt_lt_R0, Rmult_lt_0_compat; lra).
    rewrite E1. 
    match goal with |- @eq _ ?l ?r => change (@eq R l r) end.
    transitivity (- ((1 - b*x) / (sqrt x * sqrt (b*(a+b*x))))). field; lra. rewrite <- E2. field. lra.
- intros t Ht. apply k_continuous; trivial. now apply Ypos.
- intros t Ht. split. apply psi_derive.
  assert (P := X_positive t). rewrite X_r in P.
  apply (ex_derive_continuous dpsi). unfold dpsi. auto_derive. simpl in *. repeat split; trivial. apply Rgt_not_eq, sqrt_lt_R0, P.
Qed.

Lemma regular_on_S f : e < f < PI/2 -> regular b (- b * u) f.
Proof.
intros Hf. apply regular_iff; [lra|lra|]. unfold u. assert (0 < sin e) by (apply sin_gt_0; lra).
assert (sin e < sin f) by (apply sin_increasing_1; lra).
assert (b * sin e ^2 < b * sin f ^2) by (apply Rmult_lt_compat_l; [lra|]; nra). lra.
Qed.

Lemma F_on_S_below_G f : e < f < PI/2 -> F a b (- b * u) f < G a b u.
Proof.
intros Hf. destruct (psi_onto f Hf) as [s [Hs Es]]. replace f with (PI/2 - psi s) by lra.
rewrite F_psi by trivial. rewrite <- Phi_0. now apply Phi_decreasing.
Qed.

Lemma F_on_S_values v : 0 < v < G a b u -> exists f, e < f < PI/2 /\ F a b (- b * u) f = v.
Proof.
intros Hv. assert (P := PI_RGT_0).
destruct (Ranalysis5.IVT_interv (fun s => v - Phi s) 0 (PI/2)) as [s [Hs Es]]; try lra.
- intros s _. apply continuity_pt_minus. apply continuity_pt_const; now intros ? ?.
  apply continuity_pt_filterlim, (ex_derive_continuous Phi). eexists. apply Phi_derive.
- rewrite Phi_0. lra.
- rewrite Phi_PI2. lra.
- assert (s <> 0) by (intros Z; rewrite Z, Phi_0 in Es; lra).
  assert (s <> PI/2) by (intros Z; rewrite Z, Phi_PI2 in Es; lra).
  assert (Hp := psi_range s ltac:(lra)). exists (PI/2 - psi s). split; [lra|]. rewrite F_psi; lra.
Qed.
End OnS.

(** At the point of S with the defect e (c = -b sin^2 e), G is the improper integral: the limit of F(c,f) as f decreases to e. *)
Theorem G_improper_integral e : 0 < e < PI/2 ->
  filterlim (F a b (- b * sin e ^2)) (at_right e) (locally (G a b (sin e ^2))).
Proof.
intros He. apply filterlim_locally. intros d. assert (D := cond_pos d).
assert (Gp : 0 < G a b (sin e ^2)).
{ assert (N := F_on_S_below_G e He ((e + PI/2)/2) ltac:(lra)). 
  assert (M := F_pos a b Ha Hb _ _ (regular_on_S e He ((e + PI/2)/2) ltac:(lra))). lra. }
set (v := Rmax (G a b (sin e ^2) - d/2) (G a b (sin e ^2) / 2)).
assert (V1 := Rmax_l (G a b (sin e ^2) - d/2) (G a b (sin e ^2) / 2)). assert (V2 := Rmax_r (G a b (sin e ^2) - d/2) (G a b (sin e ^2) / 2)). fold v in V1, V2.
assert (V3 : v < G a b (sin e ^2)) by (unfold v; apply Rmax_lub_lt; lra).
destruct (F_on_S_values e He v ltac:(lra)) as [g [Hg Eg]].
assert (GE : 0 < g - e) by lra. exists (mkposreal _ GE). intros f Hf Lf.
unfold ball in Hf; simpl in Hf; unfold AbsRing_ball, abs, minus, plus, opp in Hf; simpl in Hf. apply Rabs_def2 in Hf.
change (Rabs (F a b (- b * sin e ^2) f - G a b (sin e ^2)) < d).
assert (N := F_on_S_below_G e He f ltac:(lra)).
assert (M := F_decreasing_e a b Ha Hb (- b * sin e ^2) f g (regular_on_S e He f ltac:(lra)) ltac:(lra)).
rewrite Rabs_left; lra.
Qed.

(** Off S, F is smaller: F(c,e) < G(sin^2 e) for c > -b sin^2 e. *)
Theorem F_below_G c e : 0 < e < PI/2 -> - b * sin e ^2 < c -> F a b c e < G a b (sin e ^2).
Proof.
intros He Hc. set (u := sin e ^2) in *. set (c' := (c - b*u)/2).
assert (Rc : regular b c' e) by (apply regular_iff; [lra|lra|]; fold u; unfold c'; lra).
assert (N := F_decreasing_c a b Ha Hb c' c e Rc ltac:(unfold c'; lra)).
apply Rlt_le_trans with (1 := N). apply Rnot_lt_le. intros L.
assert (C := F_continuity_e a b Ha Hb c' e Rc (F a b c' e - G a b u) ltac:(lra)). destruct C as [d [Hd C]]. 
set (m := Rmin (d/2) ((PI/2 - e)/2)). assert (M0 : 0 < m) by (apply Rmin_pos; lra).
assert (M1 := Rmin_l (d/2) ((PI/2 - e)/2)). assert (M2 := Rmin_r (d/2) ((PI/2 - e)/2)). fold m in M1, M2.
specialize (C (e + m)). simpl in C. unfold R_dist in C.
assert (A : Rabs (F a b c' (e + m) - F a b c' e) < F a b c' e - G a b u).
{ apply C. split. split; [exact Logic.I|lra]. rewrite Rabs_right; lra. }
apply Rabs_def2 in A.
assert (B := F_on_S_below_G e He (e + m) ltac:(lra)). fold u in B.
assert (D := F_decreasing_c a b Ha Hb (- b * u) c' (e + m) (regular_on_S e He (e+m) ltac:(lra)) ltac:(unfold c'; lra)). lra.
Qed.

(** Proposition 2 up to the meeting point of C and S: a solution (c,e) of the first implicit equation to the right of a meeting point
    (c1,e1), G(sin^2 e1) = 2 pi and c1 = -b sin^2 e1, has a smaller defect. *)
Theorem proposition_2_from_S c e e1 : 0 < e1 < PI/2 -> G a b (sin e1 ^2) = 2*PI -> - b * sin e1 ^2 < c ->
  regular b c e -> F a b c e = 2*PI -> e < e1.
Proof.
intros H1 E1 Hc H E. apply Rnot_le_lt. intros L.
assert (N := F_below_G c e1 H1 Hc). 
assert (F a b c e <= F a b c e1).
{ destruct L as [L|<-]; [|lra]. left. apply F_decreasing_e; trivial. apply regular_iff; lra. destruct H; lra. }
lra.
Qed.

(** The angle of S at c = -b u *)
Lemma angle_of_u u : 0 < u < 1 -> exists e, 0 < e < PI/2 /\ sin e ^2 = u.
Proof.
intros Hu. assert (S : 0 < sqrt u) by (apply sqrt_lt_R0; lra). 
assert (S2 : sqrt u < 1) by (rewrite <- sqrt_1; apply sqrt_lt_1_alt; lra).
assert (SA := sin_asin (sqrt u) ltac:(lra)). assert (AB := asin_bound (sqrt u)).
exists (asin (sqrt u)). split; [|rewrite SA; apply pow2_sqrt; lra]. split. 
- apply Rnot_le_lt. intros N. assert (sin (asin (sqrt u)) <= sin 0) by (apply sin_incr_1; lra). rewrite sin_0 in *. lra.
- apply Rnot_le_lt. intros N. assert (H : asin (sqrt u) = PI/2) by lra. rewrite H, sin_PI2 in SA. lra.
Qed.

(** For c > 0, F(c,e) takes every positive value over e < pi/2. *)
Lemma k_bounds c t : 0 < c -> (1-b) / sqrt ((a+b)*(c+b)) <= k a b c t <= / sqrt (a*c).
Proof.
intros Hc. assert (B := bcos2_range b Hb t). assert (X1 := cos2_range t). unfold k. set (y := b * cos t ^2) in *.
assert (Y : y <= b) by (unfold y; rewrite <- (Rmult_1_r b) at 2; apply Rmult_le_compat_l; lra).
assert (P0 : 0 < a*c) by (apply Rmult_lt_0_compat; lra). assert (P1 : 0 < (a+y)*(c+y)) by (apply Rmult_lt_0_compat; lra).
assert (L1 : sqrt (a*c) <= sqrt ((a+y)*(c+y))) by (apply sqrt_le_1_alt, Rmult_le_compat; lra).
assert (L2 : sqrt ((a+y)*(c+y)) <= sqrt ((a+b)*(c+b))) by (apply sqrt_le_1_alt, Rmult_le_compat; lra).
assert (S0 := sqrt_lt_R0 _ P0). assert (S1 := sqrt_lt_R0 _ P1). split; unfold Rdiv.
- apply Rmult_le_compat; try lra. apply Rlt_le, Rinv_0_lt_compat; lra. apply Rinv_le_contravar; lra.
- rewrite <- (Rmult_1_l (/ sqrt (a*c))). apply Rmult_le_compat; try lra. apply Rlt_le, Rinv_0_lt_compat; lra. apply Rinv_le_contravar; lra.
Qed.

Lemma F_rotating_bounds c e : 0 < c -> e < PI/2 ->
  2 * ((PI/2 - e) * ((1-b) / sqrt ((a+b)*(c+b)))) <= F a b c e <= 2 * ((PI/2 - e) * / sqrt (a*c)).
Proof.
intros Hc He. assert (Rg := regular_rotating b c e ltac:(lra) Hc He).
assert (E : forall m, (PI/2 - e) * m = RInt (fun _ => m) 0 (PI/2 - e)).
{ intros m. rewrite RInt_const. unfold scal; simpl; unfold mult; simpl. ring. }
assert (KI : ex_RInt (k a b c) 0 (PI/2 - e)) by (apply (k_integrable a b Ha Hb c e); trivial; lra).
unfold F. rewrite !E. split; (apply Rmult_le_compat_l; [lra|]); apply RInt_le; try lra; try exact KI; try apply (@ex_RInt_const R_NormedModule).
- intros t _. now apply k_bounds.
- intros t _. now apply k_bounds.
Qed.

Lemma F_rotating_values c v : 0 < c -> 0 < v -> exists e, regular b c e /\ F a b c e = v.
Proof.
intros Hc Hv.
set (p := (1-b) / sqrt ((a+b)*(c+b))). set (q := / sqrt (a*c)).
assert (Pp : 0 < p). { unfold p. apply Rdiv_lt_0_compat; [lra|]. apply sqrt_lt_R0, Rmult_lt_0_compat; lra. }
assert (Pq : 0 < q). { unfold q. apply Rinv_0_lt_compat, sqrt_lt_R0, Rmult_lt_0_compat; lra. }
set (e1 := PI/2 - v/p). set (e2 := PI/2 - v/q/4).
assert (V1 : 0 < v/p) by (apply Rdiv_lt_0_compat; lra). assert (V2 : 0 < v/q) by (apply Rdiv_lt_0_compat; lra).
destruct (F_rotating_bounds c e1 Hc ltac:(unfold e1; lra)) as [B1 _]. fold p in B1.
destruct (F_rotating_bounds c e2 Hc ltac:(unfold e2; lra)) as [_ B2]. fold q in B2.
replace (2 * ((PI/2 - e1) * p)) with (2*v) in B1 by (unfold e1; field; lra).
replace (2 * ((PI/2 - e2) * q)) with (v/2) in B2 by (unfold e2; field; lra).
assert (Rg : forall e, e < PI/2 -> regular b c e) by (intros e He; apply regular_rotating; lra).
assert (O : e1 < e2).
{ apply Rnot_le_lt. intros [L|L]. assert (N := F_decreasing_e a b Ha Hb c e2 e1 (Rg e2 ltac:(unfold e2; lra)) ltac:(unfold e1 in *; lra)). lra. rewrite L in B2. lra. }
destruct (Ranalysis5.IVT_interv (fun e => v - F a b c e) e1 e2) as [e [He Ee]]; try lra.
- intros e He. apply continuity_pt_minus. apply continuity_pt_const; now intros ? ?. apply F_continuity_e, Rg; trivial. unfold e2 in He. lra.
- exists e. split; [apply Rg; unfold e2 in He; lra|lra].
Qed.

(** The region of the first implicit equation for -b < c < 0: e > arcsin sqrt (-c/b). *)
Lemma regular_oscillating e f : 0 < e < PI/2 -> regular b (- b * sin e ^2) f -> e < f < PI/2.
Proof.
intros He [H1 H2]. split; trivial. assert (S : 0 < sin e) by (apply sin_gt_0; lra).
assert (Q : 0 < b * sin e ^2) by (apply Rmult_lt_0_compat; [lra|nra]).
destruct (Rle_dec f 0) as [N|N].
- specialize (H2 (PI/2) ltac:(lra)). rewrite cos_PI2 in H2. lra.
- specialize (H2 (PI/2 - f) ltac:(lra)). rewrite cos_shift in H2.
  apply Rnot_le_lt. intros L. assert (sin f <= sin e) by (apply sin_incr_1; lra). assert (0 <= sin f) by (apply sin_ge_0; lra).
  assert (b * sin f ^2 <= b * sin e ^2) by (apply Rmult_le_compat_l; [lra|]; nra). lra.
Qed.

(** The first implicit equation has a solution (and by one_defect only one) exactly for 0 <= c, and for those c < 0 at which half the
    phase G is greater than 2 pi, that is, to the right of the meeting point with S. *)
Theorem first_equation_solvable c : - b < c ->
  ((exists e, regular b c e /\ F a b c e = 2*PI) <-> 0 <= c \/ 2*PI < G a b (- c / b)).
Proof.
intros Hc. assert (P := PI_RGT_0). destruct (Rtotal_order c 0) as [L|[->|L]].
- assert (U : 0 < - c/b < 1).
  { split. apply Rdiv_lt_0_compat; lra. apply (Rmult_lt_reg_r b); [lra|]. replace (- c/b*b) with (- c) by (field; lra). lra. }
  destruct (angle_of_u _ U) as [e [He Ee]]. rewrite <- Ee.
  assert (Ec : c = - b * sin e ^2) by (rewrite Ee; field; lra). split.
  + intros [f [Hf Ef]]. right. rewrite Ec in Hf, Ef. assert (Hf2 := regular_oscillating e f He Hf).
    assert (N := F_on_S_below_G e He f Hf2). lra.
  + intros [Z|Z]; [lra|]. destruct (F_on_S_values e He (2*PI) ltac:(lra)) as [f [Hf Ef]]. rewrite Ec. exists f. split; trivial. now apply regular_on_S.
- split; [intros _; left; lra|intros _]. destruct (proposition_3_1 a b Ha Hb) as [e [He [E _]]]. exists e. split; trivial. apply regular_separatrix; lra.
- split; [intros _; left; lra|intros _]. apply F_rotating_values; lra.
Qed.
End Ends.
