(** Uniqueness of the motion. Coquelicot has no theorem on differential equations, so this file proves what is needed:
    Groenwall's lemma for a non-negative function that vanishes at one point, uniqueness for y' = f (y, z), z' = g (y, z) with
    Lipschitz f and g, and from this uniqueness for the paper's reduced system (18), (19).

    Why (18), (19) and not (9): at a turning point the right side of (9) is a square root that vanishes, it is not Lipschitz there,
    and uniqueness fails for (9) itself (the constant psi = psi* satisfies (9) too, theorem [rest_satisfies_equation_9]). The field of
    (18), (19) is smooth in (psi, theta), also where cos theta = 0, and globally Lipschitz because 1 - b cos^2 psi >= 1 - b > 0.
    The motions of the body satisfy (18), (19) at every phi, turning points included: they are quotients of the equations (6), whose
    denominator dphi/dt = (1 - b cos^2 psi)/I_y never vanishes. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
Open Scope R_scope.

(** * Groenwall's lemma *)
Section Gronwall.
Variables E dE : R -> R.
Variables K alpha beta : R.
Hypothesis differentiable : forall t, alpha <= t <= beta -> is_derive E t (dE t).
Hypothesis non_negative : forall t, alpha <= t <= beta -> 0 <= E t.
Hypothesis growth : forall t, alpha <= t <= beta -> Rabs (dE t) <= K * E t.

Lemma weighted_derive k t : alpha <= t <= beta -> is_derive (fun t => E t * exp (k * t)) t ((dE t + k * E t) * exp (k * t)).
Proof.
intros T. auto_derive. repeat split; trivial. eexists; now apply differentiable.
change (fun x => E x) with E. rewrite (is_derive_unique E _ _ (differentiable t T)). ring.
Qed.
Lemma weighted_mvt k s t : alpha <= s -> s < t -> t <= beta ->
  exists x, s <= x <= t /\ E t * exp (k * t) - E s * exp (k * s) = (dE x + k * E x) * exp (k * x) * (t - s).
Proof.
intros A L B.
destruct (MVT_gen (fun t => E t * exp (k * t)) s t (fun x => (dE x + k * E x) * exp (k * x))) as [x [Hx Ex]].
- rewrite Rmin_left, Rmax_right by lra. intros x Hx. apply weighted_derive. lra.
- rewrite Rmin_left, Rmax_right by lra. intros x Hx. apply continuity_pt_filterlim, (ex_derive_continuous (fun t => E t * exp (k * t))).
  eexists. apply weighted_derive. lra.
- rewrite Rmin_left, Rmax_right in Hx by lra. exists x. split; [exact Hx|exact Ex].
Qed.

(** A non-negative function that grows at most in proportion to itself and vanishes at one point of an interval vanishes on it. *)
Theorem gronwall t0 : alpha <= t0 <= beta -> E t0 = 0 -> forall t, alpha <= t <= beta -> E t = 0.
Proof.
intros T0 Z t T. destruct (Rtotal_order t t0) as [L|[->|L]]; trivial.
- destruct (weighted_mvt K t t0) as [x [Hx Ex]]; try lra. rewrite Z in Ex.
  assert (N := non_negative t T). assert (M := growth x ltac:(lra)). apply Rabs_le_between in M.
  assert (P : 0 < exp (K * t)) by apply exp_pos. assert (Q : 0 < exp (K * x)) by apply exp_pos.
  assert (0 <= (dE x + K * E x) * exp (K * x) * (t0 - t)). { apply Rmult_le_pos; [|lra]. apply Rmult_le_pos; lra. }
  assert (E t * exp (K * t) <= 0) by lra. nra.
- destruct (weighted_mvt (-K) t0 t) as [x [Hx Ex]]; try lra. rewrite Z in Ex.
  assert (N := non_negative t T). assert (M := growth x ltac:(lra)). apply Rabs_le_between in M.
  assert (P : 0 < exp (- K * t)) by apply exp_pos. assert (Q : 0 < exp (- K * x)) by apply exp_pos.
  assert (0 <= - ((dE x + - K * E x) * exp (- K * x) * (t - t0))).
  { rewrite <- Ropp_mult_distr_l_reverse. apply Rmult_le_pos; [|lra]. rewrite <- Ropp_mult_distr_l_reverse. apply Rmult_le_pos; lra. }
  assert (E t * exp (- K * t) <= 0) by lra. nra.
Qed.
End Gronwall.

(** * Uniqueness for a Lipschitz field in the plane *)
Definition lipschitz (D : R -> R -> Prop) (K : R) (f : R -> R -> R) :=
  forall y z y' z', D y z -> D y' z' -> Rabs (f y z - f y' z') <= K * (Rabs (y - y') + Rabs (z - z')).
Definition solution_on (alpha beta : R) (f g : R -> R -> R) (y z : R -> R) :=
  forall t, alpha <= t <= beta -> is_derive y t (f (y t) (z t)) /\ is_derive z t (g (y t) (z t)).

Lemma energy_bound K d e p q : 0 <= K -> Rabs p <= K * (Rabs d + Rabs e) -> Rabs q <= K * (Rabs d + Rabs e) ->
  Rabs (2 * d * p + 2 * e * q) <= 4 * K * (d^2 + e^2).
Proof.
intros HK Hp Hq. apply Rle_trans with (1 := Rabs_triang _ _). rewrite !Rabs_mult, (Rabs_pos_eq 2) by lra.
rewrite <- (pow2_abs d), <- (pow2_abs e).
assert (D := Rabs_pos d). assert (E := Rabs_pos e). set (x := Rabs d) in *. set (y := Rabs e) in *.
assert (A : x * Rabs p <= x * (K * (x + y))) by (apply Rmult_le_compat_l; lra).
assert (B : y * Rabs q <= y * (K * (x + y))) by (apply Rmult_le_compat_l; lra).
assert (C : 0 <= K * (x - y)^2) by (apply Rmult_le_pos; [lra|apply pow2_ge_0]). simpl in C. simpl. lra.
Qed.

(** Two solutions of y' = f (y, z), z' = g (y, z) in a set where f and g are Lipschitz, that agree at t0, agree on the interval. *)
Theorem lipschitz_uniqueness D K f g alpha beta t0 y z y' z' : 0 <= K -> lipschitz D K f -> lipschitz D K g ->
  alpha <= t0 <= beta -> solution_on alpha beta f g y z -> solution_on alpha beta f g y' z' ->
  (forall t, alpha <= t <= beta -> D (y t) (z t)) -> (forall t, alpha <= t <= beta -> D (y' t) (z' t)) ->
  y t0 = y' t0 -> z t0 = z' t0 -> forall t, alpha <= t <= beta -> y t = y' t /\ z t = z' t.
Proof.
intros HK Lf Lg T0 S S' I I' Ey Ez t T.
set (E := fun t => (y t - y' t)^2 + (z t - z' t)^2).
set (dE := fun t => 2 * (y t - y' t) * (f (y t) (z t) - f (y' t) (z' t)) + 2 * (z t - z' t) * (g (y t) (z t) - g (y' t) (z' t))).
assert (Z : E t = 0).
{ apply (gronwall E dE (4 * K) alpha beta) with (t0 := t0); trivial.
  - intros s Hs. destruct (S s Hs) as [A B]. destruct (S' s Hs) as [A' B']. unfold E, dE. auto_derive.
    + repeat split; eexists; eassumption.
    + change (fun x => y x) with y. change (fun x => z x) with z. change (fun x => y' x) with y'. change (fun x => z' x) with z'.
      rewrite (is_derive_unique y _ _ A), (is_derive_unique z _ _ B), (is_derive_unique y' _ _ A'), (is_derive_unique z' _ _ B'). ring.
  - intros s Hs. unfold E. apply Rplus_le_le_0_compat; apply pow2_ge_0.
  - intros s Hs. apply energy_bound; trivial; [apply Lf|apply Lg]; auto.
  - unfold E. rewrite Ey, Ez. ring. }
unfold E in Z. assert (A := pow2_ge_0 (y t - y' t)). assert (B := pow2_ge_0 (z t - z' t)).
split; apply Rminus_diag_uniq; apply Rsqr_0_uniq; unfold Rsqr; simpl in *; lra.
Qed.

(** * The reduced system *)
(** The right sides of (18) and (19), and the first integral c. *)
Definition psi_rate (a b p q : R) := (a + b * cos p ^2) * cos q / (1 - b * cos p ^2).
Definition theta_rate (a b p q : R) := b * sin q * sin p * cos p / (1 - b * cos p ^2).
Definition first_integral (a b p q : R) := a - sin q ^2 * (a + b * cos p ^2).
(** psi and theta, as functions of phi, satisfy (18) and (19) for all phi. *)
Definition reduced_motion (a b : R) (psi theta : R -> R) :=
  forall phi, is_derive psi phi (psi_rate a b (psi phi) (theta phi)) /\ is_derive theta phi (theta_rate a b (psi phi) (theta phi)).

Lemma cos_lipschitz x y : Rabs (cos x - cos y) <= Rabs (x - y).
Proof.
destruct (MVT_gen cos y x (fun x => - sin x)) as [z [_ E]].
- intros z _. apply is_derive_Reals, derivable_pt_lim_cos.
- intros z _. apply derivable_continuous_pt, derivable_pt_cos.
- rewrite E, Rabs_mult, Rabs_Ropp. rewrite <- (Rmult_1_l (Rabs (x - y))) at 2. apply Rmult_le_compat_r. apply Rabs_pos.
  apply Rabs_le. apply SIN_bound.
Qed.
Lemma sin_lipschitz x y : Rabs (sin x - sin y) <= Rabs (x - y).
Proof.
destruct (MVT_gen sin y x cos) as [z [_ E]].
- intros z _. apply is_derive_Reals, derivable_pt_lim_sin.
- intros z _. apply derivable_continuous_pt, derivable_pt_sin.
- rewrite E, Rabs_mult. rewrite <- (Rmult_1_l (Rabs (x - y))) at 2. apply Rmult_le_compat_r. apply Rabs_pos.
  apply Rabs_le. apply COS_bound.
Qed.
Lemma product_bound x y x' y' A B d e : Rabs x <= A -> Rabs y' <= B -> Rabs (x - x') <= d -> Rabs (y - y') <= e ->
  Rabs (x * y - x' * y') <= A * e + B * d.
Proof.
intros Hx Hy Hd He. replace (x * y - x' * y') with (x * (y - y') + y' * (x - x')) by ring.
apply Rle_trans with (1 := Rabs_triang _ _). rewrite !Rabs_mult.
apply Rplus_le_compat; apply Rmult_le_compat; trivial using Rabs_pos.
Qed.
Lemma sin_abs x : Rabs (sin x) <= 1. Proof. apply Rabs_le, SIN_bound. Qed.
Lemma cos_abs x : Rabs (cos x) <= 1. Proof. apply Rabs_le, COS_bound. Qed.
Lemma cos2_bound p : 0 <= cos p ^2 <= 1.
Proof. assert (H := sin2_cos2 p). unfold Rsqr in H. assert (0 <= sin p * sin p) by apply Rle_0_sqr. assert (0 <= cos p * cos p) by apply Rle_0_sqr. simpl. lra. Qed.
Lemma cos2_lipschitz p p' : Rabs (cos p ^2 - cos p' ^2) <= 2 * Rabs (p - p').
Proof.
replace (cos p ^2 - cos p' ^2) with (cos p * cos p - cos p' * cos p') by ring.
replace (2 * Rabs (p - p')) with (1 * Rabs (p - p') + 1 * Rabs (p - p')) by ring.
apply product_bound; trivial using cos_abs, cos_lipschitz.
Qed.

Section Reduced.
Variables a b : R.
Hypothesis Ha : 0 < a.
Hypothesis Hb : 0 < b < 1.
Notation m := (/ (1 - b)).
Lemma m_ge_1 : 1 <= m.
Proof. rewrite <- Rinv_1 at 1. apply Rinv_le_contravar; lra. Qed.
Lemma denominator p : 1 - b <= 1 - b * cos p ^2 <= 1.
Proof. assert (H := cos2_bound p). nra. Qed.
Lemma inverse_bound p : Rabs (/ (1 - b * cos p ^2)) <= m.
Proof. assert (H := denominator p). rewrite Rabs_pos_eq. apply Rinv_le_contravar; lra. left. apply Rinv_0_lt_compat. lra. Qed.
Lemma inverse_lipschitz p p' : Rabs (/ (1 - b * cos p ^2) - / (1 - b * cos p' ^2)) <= 2 * m^2 * Rabs (p - p').
Proof.
assert (H := denominator p). assert (H' := denominator p').
replace (/ (1 - b * cos p ^2) - / (1 - b * cos p' ^2)) with (/ (1 - b * cos p ^2) * / (1 - b * cos p' ^2) * (b * (cos p ^2 - cos p' ^2))) by (field; lra).
rewrite !Rabs_mult, (Rabs_pos_eq b) by lra.
assert (A := inverse_bound p). assert (A' := inverse_bound p'). assert (C := cos2_lipschitz p p').
assert (M := m_ge_1).
replace (2 * m^2 * Rabs (p - p')) with (m * m * (1 * (2 * Rabs (p - p')))) by ring.
assert (P := Rabs_pos (p - p')).
apply Rmult_le_compat. apply Rmult_le_pos; apply Rabs_pos. apply Rmult_le_pos; [lra|apply Rabs_pos].
apply Rmult_le_compat; trivial using Rabs_pos. apply Rmult_le_compat; trivial using Rabs_pos; lra.
Qed.
(** (18) is -cos theta + (a + 1) cos theta/(1 - b cos^2 psi). *)
Lemma psi_rate_split p q : psi_rate a b p q = - cos q + (a + 1) * (/ (1 - b * cos p ^2) * cos q).
Proof. unfold psi_rate. assert (H := denominator p). field. lra. Qed.

Notation K := (8 * (a + 1) * m^2).
Lemma K_pos : 0 <= K.
Proof. assert (M := m_ge_1). apply Rmult_le_pos; [lra|apply pow2_ge_0]. Qed.
Lemma m_le_m2 : 1 <= m <= m^2.
Proof. assert (M := m_ge_1). split; trivial. simpl. rewrite Rmult_1_r. rewrite <- (Rmult_1_l m) at 1. apply Rmult_le_compat_r; lra. Qed.

Theorem psi_rate_lipschitz : lipschitz (fun _ _ => True) K (psi_rate a b).
Proof.
intros p q p' q' _ _. rewrite !psi_rate_split.
assert (A : Rabs (/ (1 - b * cos p ^2) * cos q - / (1 - b * cos p' ^2) * cos q') <= m * Rabs (q - q') + 1 * (2 * m^2 * Rabs (p - p'))).
{ apply product_bound; trivial using inverse_bound, inverse_lipschitz, cos_lipschitz, cos_abs. }
assert (B := cos_lipschitz q q'). assert (M := m_le_m2). assert (P := Rabs_pos (p - p')). assert (Q := Rabs_pos (q - q')).
replace (- cos q + (a + 1) * (/ (1 - b * cos p ^2) * cos q) - (- cos q' + (a + 1) * (/ (1 - b * cos p' ^2) * cos q')))
  with (- (cos q - cos q') + (a + 1) * (/ (1 - b * cos p ^2) * cos q - / (1 - b * cos p' ^2) * cos q')) by ring.
apply Rle_trans with (1 := Rabs_triang _ _). rewrite Rabs_Ropp, Rabs_mult, (Rabs_pos_eq (a + 1)) by lra.
set (dp := Rabs (p - p')) in *. set (dq := Rabs (q - q')) in *. set (n := m) in *.
apply Rle_trans with (dq + (a + 1) * (n * dq + 1 * (2 * n^2 * dp))).
{ apply Rplus_le_compat; trivial. apply Rmult_le_compat_l; lra. }
assert (0 <= (a + 1) * (n^2 - n) * dq) by (repeat apply Rmult_le_pos; lra).
assert (0 <= (a + 1) * (n^2 - 1) * dq) by (repeat apply Rmult_le_pos; lra).
assert (0 <= a * dq) by (apply Rmult_le_pos; lra).
assert (0 <= (a + 1) * n^2 * dp) by (repeat apply Rmult_le_pos; lra).
assert (0 <= (a + 1) * n^2 * dq) by (repeat apply Rmult_le_pos; lra). lra.
Qed.
Theorem theta_rate_lipschitz : lipschitz (fun _ _ => True) K (theta_rate a b).
Proof.
intros p q p' q' _ _.
assert (Q1 : Rabs (sin p * cos p - sin p' * cos p') <= 1 * Rabs (p - p') + 1 * Rabs (p - p')).
{ apply product_bound; trivial using sin_abs, cos_abs, sin_lipschitz, cos_lipschitz. }
assert (S1 : Rabs (sin p * cos p) <= 1).
{ rewrite Rabs_mult. rewrite <- (Rmult_1_l 1). apply Rmult_le_compat; trivial using Rabs_pos, sin_abs, cos_abs. }
assert (S1' : Rabs (sin p' * cos p') <= 1).
{ rewrite Rabs_mult. rewrite <- (Rmult_1_l 1). apply Rmult_le_compat; trivial using Rabs_pos, sin_abs, cos_abs. }
assert (Q2 : Rabs (/ (1 - b * cos p ^2) * (sin p * cos p) - / (1 - b * cos p' ^2) * (sin p' * cos p'))
  <= m * (1 * Rabs (p - p') + 1 * Rabs (p - p')) + 1 * (2 * m^2 * Rabs (p - p'))).
{ apply product_bound; trivial using inverse_bound, inverse_lipschitz. }
assert (S2 : Rabs (/ (1 - b * cos p' ^2) * (sin p' * cos p')) <= m).
{ rewrite Rabs_mult. rewrite <- (Rmult_1_r m). apply Rmult_le_compat; trivial using Rabs_pos, inverse_bound. }
assert (Q3 := product_bound _ _ _ _ _ _ _ _ (sin_abs q) S2 (sin_lipschitz q q') Q2).
assert (M := m_le_m2). assert (P := Rabs_pos (p - p')). assert (Q := Rabs_pos (q - q')).
unfold theta_rate. assert (H := denominator p). assert (H' := denominator p').
replace (b * sin q * sin p * cos p / (1 - b * cos p ^2) - b * sin q' * sin p' * cos p' / (1 - b * cos p' ^2))
  with (b * (sin q * (/ (1 - b * cos p ^2) * (sin p * cos p)) - sin q' * (/ (1 - b * cos p' ^2) * (sin p' * cos p')))) by (field; lra).
rewrite Rabs_mult, (Rabs_pos_eq b) by lra.
set (dp := Rabs (p - p')) in *. set (dq := Rabs (q - q')) in *. set (n := m) in *.
set (big := Rabs (sin q * _ - _)) in *.
apply Rle_trans with (1 * big). { apply Rmult_le_compat_r; [apply Rabs_pos|lra]. }
assert (0 <= (n^2 - n) * dp) by (repeat apply Rmult_le_pos; lra).
assert (0 <= (n^2 - n) * dq) by (repeat apply Rmult_le_pos; lra).
assert (0 <= n^2 * dq) by (repeat apply Rmult_le_pos; lra).
assert (0 <= n^2 * dp) by (repeat apply Rmult_le_pos; lra).
assert (0 <= a * n^2 * dp) by (repeat apply Rmult_le_pos; lra).
assert (0 <= a * n^2 * dq) by (repeat apply Rmult_le_pos; lra). lra.
Qed.

(** Uniqueness for the reduced system (18), (19): two motions that agree at one phi are the same motion. *)
Theorem motion_unique psi theta psi' theta' phi0 : reduced_motion a b psi theta -> reduced_motion a b psi' theta' ->
  psi phi0 = psi' phi0 -> theta phi0 = theta' phi0 -> forall phi, psi phi = psi' phi /\ theta phi = theta' phi.
Proof.
intros M M' E1 E2 phi.
apply (lipschitz_uniqueness (fun _ _ => True) K (psi_rate a b) (theta_rate a b) (Rmin phi0 phi) (Rmax phi0 phi) phi0); trivial.
- apply K_pos.
- apply psi_rate_lipschitz.
- apply theta_rate_lipschitz.
- split; [apply Rmin_l|apply Rmax_l].
- intros t _. apply M.
- intros t _. apply M'.
- split; [apply Rmin_r|apply Rmax_r].
Qed.

(** c = a - sin^2 theta (a + b cos^2 psi) is a first integral of (18), (19). *)
Theorem first_integral_constant psi theta : reduced_motion a b psi theta ->
  forall phi phi0, first_integral a b (psi phi) (theta phi) = first_integral a b (psi phi0) (theta phi0).
Proof.
intros M phi phi0.
assert (D : forall t, is_derive (fun t => first_integral a b (psi t) (theta t)) t 0).
{ intros t. destruct (M t) as [A B]. unfold first_integral. auto_derive.
  - repeat split; eexists; eassumption.
  - change (fun x => psi x) with psi. change (fun x => theta x) with theta.
    rewrite (is_derive_unique psi _ _ A), (is_derive_unique theta _ _ B). unfold psi_rate, theta_rate.
    assert (H := denominator (psi t)). simpl in H. simpl. field. lra. }
destruct (MVT_gen (fun t => first_integral a b (psi t) (theta t)) phi0 phi (fun _ => 0)) as [z [_ E]].
- intros t _. apply D.
- intros t _. apply continuity_pt_filterlim, (ex_derive_continuous (fun t => first_integral a b (psi t) (theta t))). eexists. apply D.
- lra.
Qed.

(** (20): cos^2 theta (a + b cos^2 psi) = c + b cos^2 psi. *)
Lemma equation_20 p q : cos q ^2 * (a + b * cos p ^2) = first_integral a b p q + b * cos p ^2.
Proof. unfold first_integral. assert (H := sin2_cos2 q). unfold Rsqr in H. replace (cos q ^2) with (1 - sin q ^2) by (simpl; lra). ring. Qed.

(** (9), squared: every motion with the first integral c satisfies it. *)
Theorem equation_9 p q : (psi_rate a b p q * (1 - b * cos p ^2))^2 = (a + b * cos p ^2) * (first_integral a b p q + b * cos p ^2).
Proof.
rewrite <- equation_20. unfold psi_rate. assert (H := denominator p).
replace ((a + b * cos p ^2) * cos q / (1 - b * cos p ^2) * (1 - b * cos p ^2)) with ((a + b * cos p ^2) * cos q) by (field; lra). ring.
Qed.

(** (9) alone does not determine the motion: at rest in a turning point, c + b cos^2 psi = 0, it is satisfied as well. *)
Theorem rest_satisfies_equation_9 c p : c + b * cos p ^2 = 0 ->
  (Derive (fun _ : R => p) 0 * (1 - b * cos p ^2))^2 = (a + b * cos p ^2) * (c + b * cos p ^2).
Proof. intros E. rewrite Derive_const, E. ring. Qed.
End Reduced.
