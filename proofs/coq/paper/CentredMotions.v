(** The centred motion psi_c exists for every -b < c < a: oscillating (Oscillation.v, in closed form), on the separatrix c = 0 and rotating, 0 < c < a. So
    epsilon (c) is defined on all of (-b, a), and C is the graph of a function there (lemma 1 with existence). *)
Require Import Reals Lra Psatz Ratan.
From Coquelicot Require Import Coquelicot.
From Polhode Require Autonomous.
From Polhode Require Import Uniqueness Oscillation Symmetry Curve.
Open Scope R_scope.

(** y' = f (y) has a solution on the whole line from y 0 = 0, for f continuous between two positive bounds. *)
Lemma autonomous_from_0 f m B : (forall y, continuous f y) -> 0 < m -> (forall y, m <= f y <= B) ->
  exists y : R -> R, y 0 = 0 /\ forall t, is_derive y t (f (y t)).
Proof.
intros Hf Hm H. destruct (Autonomous.autonomous_solution f B Hf) as [y D].
- intros z. specialize (H z). lra.
- intros z. apply H.
- assert (Cy : forall t, continuity_pt y t). { intros t. apply continuity_pt_filterlim, (ex_derive_continuous y). exact (ex_intro _ _ (D t)). }
  assert (G : forall s t, s < t -> m * (t - s) <= y t - y s).
  { intros s t L. destruct (MVT_gen y s t (fun t => f (y t))) as [z [_ E]]; [intros z _; apply D|intros z _; apply Cy|].
    rewrite E. apply Rmult_le_compat_r; [lra|apply H]. }
  set (T := (Rabs (y 0) + 1) / m). assert (A := Rabs_pos (y 0)). assert (T0 : 0 < T) by (apply Rdiv_lt_0_compat; lra).
  assert (E : m * T = Rabs (y 0) + 1) by (unfold T; field; lra).
  assert (A1 := Rle_abs (y 0)). assert (A2 := Rle_abs (- y 0)). rewrite Rabs_Ropp in A2.
  assert (G1 := G 0 T T0). assert (G2 := G (-T) 0 ltac:(lra)).
  destruct (IVT_gen y (-T) T 0) as [t0 [_ E0]]; [exact Cy| |].
  + split; [apply Rle_trans with (1 := Rmin_l _ _); lra|apply Rle_trans with (2 := Rmax_r _ _); lra].
  + exists (fun t => y (t + t0)). split; [now rewrite Rplus_0_l|]. intros t. apply (shifted_derive y t0 t). apply D.
Qed.
Lemma acos_derive y : -1 < y < 1 -> is_derive acos y (-1 / sqrt (1 - y²)).
Proof. intros H. apply is_derive_Reals. apply (derive_pt_eq_1 acos y _ (derivable_pt_acos y H)). apply derive_pt_acos. Qed.

Section CentredMotions.
Variables a b : R.
Hypothesis Ha : 0 < a.
Hypothesis Hb : 0 < b < 1.

(** psi' of equation (9) with the plus sign, and theta from cos theta = sqrt ((c + b cos^2 psi)/(a + b cos^2 psi)), are a motion. *)
Section Build.
Variable c : R.
Hypothesis Hc : c < a.
Variable psi : R -> R.
Definition cosine (phi : R) := sqrt ((c + b * cos (psi phi) ^2) / (a + b * cos (psi phi) ^2)).
Hypothesis Hpos : forall phi, 0 < c + b * cos (psi phi) ^2.
Hypothesis Dpsi : forall phi, is_derive psi phi ((a + b * cos (psi phi) ^2) * cosine phi / (1 - b * cos (psi phi) ^2)).
Hypothesis H0 : psi 0 = 0.
Lemma BX phi : 0 <= b * cos (psi phi) ^2 < 1.
Proof. assert (B := cos2_bound (psi phi)). split; [apply Rmult_le_pos; lra|nra]. Qed.
Lemma quotient_bounds phi : 0 < (c + b * cos (psi phi) ^2) / (a + b * cos (psi phi) ^2) < 1.
Proof.
assert (B := BX phi). assert (P := Hpos phi). split; [apply Rdiv_lt_0_compat; lra|].
apply (Rmult_lt_reg_r (a + b * cos (psi phi) ^2)); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra.
Qed.
Lemma cosine_bounds phi : 0 < cosine phi < 1.
Proof.
assert (Q := quotient_bounds phi). unfold cosine. split; [apply sqrt_lt_R0, Q|]. rewrite <- sqrt_1. apply sqrt_lt_1_alt. lra.
Qed.
Lemma cosine_square phi : cosine phi * cosine phi = (c + b * cos (psi phi) ^2) / (a + b * cos (psi phi) ^2).
Proof. apply sqrt_sqrt. assert (Q := quotient_bounds phi). lra. Qed.
Lemma cosine_derive phi : is_derive cosine phi (- (b * sin (psi phi) * cos (psi phi) * (1 - cosine phi * cosine phi) / (1 - b * cos (psi phi) ^2))).
Proof.
assert (B := BX phi). assert (C0 := cosine_bounds phi). assert (C2 := cosine_square phi). evar_last.
- apply (is_derive_comp sqrt (fun phi => (c + b * cos (psi phi) ^2) / (a + b * cos (psi phi) ^2))).
  + instantiate (1 := / (2 * cosine phi)). unfold cosine. auto_derive. apply quotient_bounds. simpl. field. apply Rgt_not_eq. apply C0.
  + auto_derive. repeat split; try (exact (ex_intro _ _ (Dpsi phi))). simpl in B. lra. reflexivity.
- change (Derive (fun y => psi y) phi) with (Derive psi phi). rewrite (is_derive_unique psi _ _ (Dpsi phi)). unfold scal; simpl; unfold mult; simpl.
  rewrite C2. simpl in *.
  match goal with |- @eq _ ?l ?r => change (@eq R l r) end. field. lra.
Qed.
Lemma sine_positive phi : 0 < 1 - (cosine phi)².
Proof. assert (C := cosine_bounds phi). unfold Rsqr. nra. Qed.
Theorem build_motion : centred_motion a b c psi (fun phi => acos (cosine phi)).
Proof.
assert (Co : forall phi, cos (acos (cosine phi)) = cosine phi). { intros phi. apply cos_acos. assert (C := cosine_bounds phi). lra. }
assert (Si : forall phi, sin (acos (cosine phi)) = sqrt (1 - (cosine phi)²)). { intros phi. apply sin_acos. assert (C := cosine_bounds phi). lra. }
split; [|split; [exact H0|split]].
- intros phi. assert (B := BX phi). unfold psi_rate, theta_rate. rewrite Co, Si. split; [apply Dpsi|]. evar_last.
  + apply (is_derive_comp acos cosine); [|apply cosine_derive]. apply acos_derive. assert (C := cosine_bounds phi). lra.
  + unfold scal; simpl; unfold mult; simpl. assert (S := sqrt_lt_R0 _ (sine_positive phi)).
    assert (S2 : sqrt (1 - (cosine phi)²) * sqrt (1 - (cosine phi)²) = 1 - (cosine phi)²). { apply sqrt_sqrt. left. apply sine_positive. }
    replace (1 - cosine phi * cosine phi) with (sqrt (1 - (cosine phi)²) * sqrt (1 - (cosine phi)²)) by (rewrite S2; unfold Rsqr; ring).
    simpl in B. match goal with |- @eq _ ?l ?r => change (@eq R l r) end. field. lra.
- assert (C := cosine_bounds 0). assert (A := acos_bound (cosine 0)). assert (E := Co 0). set (q := acos (cosine 0)) in *. split.
  + destruct (Req_dec q 0) as [Z|Z]; [|lra]. rewrite Z, cos_0 in E. lra.
  + apply Rnot_le_lt. intros L. assert (cos q <= cos (PI/2)) by (apply cos_decr_1; lra). rewrite cos_PI2 in H. lra.
- unfold first_integral. rewrite Si. assert (S2 : sqrt (1 - (cosine 0)²) ^2 = 1 - cosine 0 * cosine 0). { unfold Rsqr. simpl. rewrite Rmult_1_r. apply sqrt_sqrt. left. apply (sine_positive 0). }
  rewrite S2, cosine_square. assert (B := BX 0). field. lra.
Qed.
End Build.

Lemma cos2_denominator p : 0 <= b * cos p ^2 <= b.
Proof. assert (B := cos2_bound p). split; [apply Rmult_le_pos; lra|nra]. Qed.
(** Rotating motions. *)
Theorem rotating_centred_motion c : 0 < c < a -> exists psi theta, centred_motion a b c psi theta.
Proof.
intros Hc. set (f := fun p => (a + b * cos p ^2) * sqrt ((c + b * cos p ^2) / (a + b * cos p ^2)) / (1 - b * cos p ^2)).
assert (BX' := cos2_denominator).
assert (Q : forall p, c / (a + b) <= (c + b * cos p ^2) / (a + b * cos p ^2) <= 1).
{ intros p. specialize (BX' p). split.
  - unfold Rdiv. apply Rmult_le_compat; [lra|left; apply Rinv_0_lt_compat; lra|lra|]. apply Rinv_le_contravar; lra.
  - apply (Rmult_le_reg_r (a + b * cos p ^2)); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra. }
assert (Q0 : 0 < c / (a + b)) by (apply Rdiv_lt_0_compat; lra). assert (S0 : 0 < sqrt (c / (a + b))) by now apply sqrt_lt_R0.
destruct (autonomous_from_0 f (a * sqrt (c / (a + b))) ((a + b) / (1 - b))) as [psi [P0 D]].
- intros p. apply (ex_derive_continuous f). unfold f. specialize (BX' p). specialize (Q p). auto_derive. simpl in *. repeat split; lra.
- apply Rmult_lt_0_compat; lra.
- intros p. specialize (BX' p). specialize (Q p).
  assert (S1 : sqrt (c / (a + b)) <= sqrt ((c + b * cos p ^2) / (a + b * cos p ^2))) by (apply sqrt_le_1_alt; lra).
  assert (S2 : sqrt ((c + b * cos p ^2) / (a + b * cos p ^2)) <= 1) by (rewrite <- sqrt_1; apply sqrt_le_1_alt; lra).
  unfold f. set (s := sqrt ((c + b * cos p ^2) / (a + b * cos p ^2))) in *. split.
  + apply Rle_trans with (a * s); [apply Rmult_le_compat_l; lra|]. apply (Rmult_le_reg_r (1 - b * cos p ^2)); [lra|].
    replace ((a + b * cos p ^2) * s / (1 - b * cos p ^2) * (1 - b * cos p ^2)) with ((a + b * cos p ^2) * s) by (field; lra).
    assert (0 <= a * s) by (apply Rmult_le_pos; lra). assert (0 <= b * cos p ^2 * s) by (apply Rmult_le_pos; lra). nra.
  + unfold Rdiv. apply Rmult_le_compat; [apply Rmult_le_pos; lra|left; apply Rinv_0_lt_compat; lra| |apply Rinv_le_contravar; lra].
    rewrite <- (Rmult_1_r (a + b)). apply Rmult_le_compat; lra.
- exists psi, (fun phi => acos (cosine c psi phi)). apply build_motion; [lra| |exact D|exact P0].
  intros phi. specialize (BX' (psi phi)). lra.
Qed.

(** The separatrix: tan psi = sinh s, cos psi = 1/cosh s, and s' is between two positive bounds. *)
Let sh (s : R) := (exp s - exp (- s)) / 2.
Let ch (s : R) := (exp s + exp (- s)) / 2.
Lemma hyperbolic s : 1 + sh s * sh s = ch s * ch s.
Proof. unfold sh, ch. assert (E : exp s * exp (- s) = 1) by (rewrite <- exp_plus, Rplus_opp_r; apply exp_0). nra. Qed.
Lemma ch_positive s : 1 <= ch s.
Proof.
assert (0 < ch s). { unfold ch. assert (A := exp_pos s). assert (B := exp_pos (- s)). lra. }
assert (H1 := hyperbolic s). assert (0 <= sh s * sh s) by (apply Rle_0_sqr). nra.
Qed.
Lemma cos_atan_sh s : cos (atan (sh s)) = / ch s.
Proof.
rewrite cos_atan. unfold Rsqr. rewrite hyperbolic, sqrt_square. unfold Rdiv. now rewrite Rmult_1_l. assert (C := ch_positive s). lra.
Qed.
Theorem separatrix_centred_motion : exists psi theta, centred_motion a b 0 psi theta.
Proof.
set (x := fun s => / ch s ^2).
assert (X : forall s, 0 < x s <= 1).
{ intros s. unfold x. assert (C := ch_positive s). assert (1 <= ch s ^2) by (simpl; nra). split; [apply Rinv_0_lt_compat; lra|]. rewrite <- Rinv_1. apply Rinv_le_contravar; lra. }
assert (BX' : forall s, 0 < b * x s <= b). { intros s. specialize (X s). split; [apply Rmult_lt_0_compat; lra|nra]. }
set (g := fun s => sqrt b * sqrt (a + b * x s) / (1 - b * x s)).
assert (Sb : 0 < sqrt b) by (apply sqrt_lt_R0; lra). assert (Sa : 0 < sqrt a) by now apply sqrt_lt_R0.
destruct (autonomous_from_0 g (sqrt b * sqrt a) (sqrt b * sqrt (a + b) / (1 - b))) as [s [S0 D]].
- intros s. apply (ex_derive_continuous g). unfold g, x. specialize (BX' s). assert (C := ch_positive s). unfold x, ch in *. auto_derive. simpl in *.
  assert (N : (exp s + exp (- s)) / 2 * ((exp s + exp (- s)) / 2 * 1) <> 0) by (apply Rgt_not_eq; nra). repeat split; trivial; lra.
- now apply Rmult_lt_0_compat.
- intros s. specialize (BX' s). unfold g.
  assert (S1 : sqrt a <= sqrt (a + b * x s)) by (apply sqrt_le_1_alt; lra). assert (S2 : sqrt (a + b * x s) <= sqrt (a + b)) by (apply sqrt_le_1_alt; lra). split.
  + apply Rle_trans with (sqrt b * sqrt (a + b * x s)); [apply Rmult_le_compat_l; lra|].
    rewrite <- (Rmult_1_r (sqrt b * sqrt (a + b * x s))) at 1. unfold Rdiv. apply Rmult_le_compat_l; [apply Rmult_le_pos; lra|].
    rewrite <- Rinv_1. apply Rinv_le_contravar; lra.
  + unfold Rdiv. apply Rmult_le_compat; [apply Rmult_le_pos; lra|left; apply Rinv_0_lt_compat; lra|apply Rmult_le_compat_l; lra|apply Rinv_le_contravar; lra].
- set (psi := fun phi => atan (sh (s phi))).
  assert (C2 : forall phi, cos (psi phi) ^2 = x (s phi)).
  { intros phi. unfold psi. rewrite cos_atan_sh. unfold x. assert (C := ch_positive (s phi)). field. lra. }
  exists psi, (fun phi => acos (cosine 0 psi phi)). apply build_motion; trivial.
  + intros phi. rewrite C2. specialize (BX' (s phi)). lra.
  + intros phi. assert (B := BX' (s phi)). assert (C := ch_positive (s phi)). evar_last.
    * apply (is_derive_comp (fun s => atan (sh s)) s phi (/ ch (s phi)) (g (s phi))); [|apply D].
      evar_last. { apply (is_derive_comp atan sh (s phi) (/ (1 + sh (s phi) ^2)) (ch (s phi))). apply is_derive_Reals, derivable_pt_lim_atan. unfold sh, ch. auto_derive; trivial. field. }
      change (ch (s phi) * / (1 + sh (s phi) ^2) = / ch (s phi)). replace (1 + sh (s phi) ^2) with (ch (s phi) * ch (s phi)) by (rewrite <- hyperbolic; ring). field. lra.
    * change (g (s phi) * / ch (s phi) = (a + b * cos (psi phi) ^2) * cosine 0 psi phi / (1 - b * cos (psi phi) ^2)). unfold cosine. rewrite C2.
      assert (E : sqrt ((0 + b * x (s phi)) / (a + b * x (s phi))) = sqrt b * / ch (s phi) / sqrt (a + b * x (s phi))).
      { rewrite sqrt_div_alt by lra. f_equal. rewrite Rplus_0_l, sqrt_mult_alt by lra. f_equal. unfold x.
        replace (/ ch (s phi) ^2) with ((/ ch (s phi)) ^2) by (field; lra). apply sqrt_pow2. left. apply Rinv_0_lt_compat. lra. }
      rewrite E. unfold g. assert (S3 : 0 < sqrt (a + b * x (s phi))) by (apply sqrt_lt_R0; lra).
      assert (S4 : a + b * x (s phi) = sqrt (a + b * x (s phi)) * sqrt (a + b * x (s phi))) by (symmetry; apply sqrt_sqrt; lra).
      set (q := sqrt (a + b * x (s phi))) in *. rewrite S4. field. lra.
  + unfold psi. rewrite S0. unfold sh. rewrite Ropp_0, Rminus_eq_0. unfold Rdiv. rewrite Rmult_0_l. apply atan_0.
Qed.

(** Every -b < c < a has its centred motion, and C is the graph of a function on (-b, a). *)
Theorem centred_motion_every_c c : -b < c < a -> exists psi theta, centred_motion a b c psi theta.
Proof.
intros Hc. destruct (Rtotal_order c 0) as [L|[->|L]].
- apply centred_motion_exists; trivial. lra.
- apply separatrix_centred_motion.
- apply rotating_centred_motion. lra.
Qed.
Theorem lemma_1_graph c : -b < c < a -> exists eps, curve_C a b c eps /\ forall eps', curve_C a b c eps' -> eps' = eps.
Proof.
intros Hc. destruct (centred_motion_every_c c Hc) as [psi [theta M]]. exists (PI/2 - psi PI). assert (C : curve_C a b c (PI/2 - psi PI)) by (exists psi, theta; now split).
split; trivial. intros eps' C'. exact (lemma_1 a b Ha Hb c _ _ C' C).
Qed.
End CentredMotions.
