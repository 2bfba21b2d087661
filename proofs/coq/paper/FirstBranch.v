(** From the motion to the first implicit equation, (21): as long as cos theta > 0 up to phi = pi, eps = pi/2 - psi_c (pi) is the solution of F (c, eps) = 2 pi.
    That is so for every c >= 0 (the separatrix and the rotating motions) and for -b < c < 0 where G (-c/b) > 2 pi (before the first meeting with S). *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Polhode Require HalfPhase FirstEquation.
From Polhode Require Import Uniqueness Oscillation Symmetry Curve.
Open Scope R_scope.
Local Notation k := FirstEquation.k.
Local Notation F := FirstEquation.F.
Local Notation regular := FirstEquation.regular.
Local Notation G := HalfPhase.G.

Section FirstBranch.
Variables a b : R.
Hypothesis Ha : 0 < a.
Hypothesis Hb : 0 < b < 1.

(** For c >= 0 a motion with cos theta = 0 somewhere is at rest there, at cos psi = 0. *)
Lemma turning_is_rest c psi theta z : reduced_motion a b psi theta -> 0 <= c -> first_integral a b (psi z) (theta z) = c -> cos (theta z) = 0 ->
  cos (psi z) = 0 /\ forall phi, psi phi = psi z /\ theta phi = theta z.
Proof.
intros M Hc E Z. assert (Q := equation_20 a b (psi z) (theta z)). rewrite E, Z in Q.
assert (C2 : 0 <= b * cos (psi z) ^2) by (apply Rmult_le_pos; [lra|apply pow2_ge_0]).
assert (Z2 : b * cos (psi z) ^2 = 0) by (replace (0 ^2) with 0 in Q by ring; lra).
assert (Z3 : cos (psi z) = 0). { apply Rsqr_0_uniq. unfold Rsqr. apply Rmult_integral in Z2. destruct Z2 as [Z2|Z2]; simpl in Z2; lra. }
split; [exact Z3|]. apply (motion_unique a b Ha Hb psi theta (fun _ => psi z) (fun _ => theta z) z); trivial.
intros x. unfold psi_rate, theta_rate. rewrite Z, Z3. split.
- replace ((a + b * 0 ^2) * 0 / (1 - b * 0 ^2)) with 0 by (field; lra). apply (is_derive_const (K:=R_AbsRing) (V:=R_NormedModule)).
- replace (b * sin (theta z) * sin (psi z) * 0 / (1 - b * 0 ^2)) with 0 by (field; lra). apply (is_derive_const (K:=R_AbsRing) (V:=R_NormedModule)).
Qed.

Section Rising.
Variable c : R.
Variables psi theta : R -> R.
Hypothesis M : centred_motion a b c psi theta.

Lemma motion_eq_20 phi : c + b * cos (psi phi) ^2 = cos (theta phi) ^2 * (a + b * cos (psi phi) ^2).
Proof. rewrite equation_20. now rewrite (first_integral_at a b Hb c psi theta phi M). Qed.
Lemma a_bcos2_pos p : 0 < a + b * cos p ^2.
Proof. assert (0 <= b * cos p ^2) by (apply Rmult_le_pos; [lra|apply pow2_ge_0]). lra. Qed.
Lemma one_bcos2_pos p : 0 < 1 - b * cos p ^2.
Proof. assert (B := cos2_bound p). nra. Qed.
(** dphi/dpsi = k where cos theta > 0, equation (9). *)
Lemma rate_times_k phi : 0 < cos (theta phi) -> psi_rate a b (psi phi) (theta phi) * k a b c (psi phi) = 1.
Proof.
intros H. assert (A := a_bcos2_pos (psi phi)). assert (B := one_bcos2_pos (psi phi)). unfold k. rewrite motion_eq_20.
replace ((a + b * cos (psi phi) ^2) * (cos (theta phi) ^2 * (a + b * cos (psi phi) ^2))) with ((cos (theta phi) * (a + b * cos (psi phi) ^2)) ^2) by ring.
rewrite sqrt_pow2 by (apply Rmult_le_pos; lra). unfold psi_rate. field. lra.
Qed.
Lemma psi_continuous phi : continuity_pt psi phi.
Proof. apply continuity_pt_filterlim, (ex_derive_continuous psi). exact (ex_intro _ _ (proj1 (proj1 M phi))). Qed.
Lemma theta_continuous phi : continuity_pt theta phi.
Proof. apply continuity_pt_filterlim, (ex_derive_continuous theta). exact (ex_intro _ _ (proj2 (proj1 M phi))). Qed.
Lemma psi_rate_continuous phi : continuous (fun phi => psi_rate a b (psi phi) (theta phi)) phi.
Proof.
apply continuity_pt_filterlim. unfold psi_rate.
assert (C : continuity_pt (fun phi => cos (psi phi) ^2) phi).
{ apply (continuity_pt_comp (fun phi => cos (psi phi)) (fun x => x ^2)).
  apply (continuity_pt_comp psi cos); [apply psi_continuous|apply continuity_cos]. apply derivable_continuous_pt, derivable_pt_pow. }
assert (D : continuity_pt (fun phi => b * cos (psi phi) ^2) phi).
{ apply (continuity_pt_mult (fun _ => b) (fun phi => cos (psi phi) ^2)); trivial. apply continuity_pt_const. now intros ? ?. }
apply (continuity_pt_div (fun phi => (a + b * cos (psi phi) ^2) * cos (theta phi)) (fun phi => 1 - b * cos (psi phi) ^2)).
- apply (continuity_pt_mult (fun phi => a + b * cos (psi phi) ^2) (fun phi => cos (theta phi))).
  + apply (continuity_pt_plus (fun _ => a) (fun phi => b * cos (psi phi) ^2)); trivial. apply continuity_pt_const. now intros ? ?.
  + apply (continuity_pt_comp theta cos); [apply theta_continuous|apply continuity_cos].
- apply (continuity_pt_minus (fun _ => 1) (fun phi => b * cos (psi phi) ^2)); trivial. apply continuity_pt_const. now intros ? ?.
- apply Rgt_not_eq, one_bcos2_pos.
Qed.

(** The first implicit equation, up to any phi = T > 0 before the first turning point: F (c, pi/2 - psi_c (T)) = 2 T. *)
Theorem rising_sweep T : 0 < T -> (forall phi, 0 <= phi <= T -> 0 < cos (theta phi)) ->
  regular b c (PI/2 - psi T) /\ F a b c (PI/2 - psi T) = 2*T.
Proof.
intros PT H. assert (P0 : psi 0 = 0) by apply M.
assert (Q : forall phi, 0 <= phi <= T -> 0 < c + b * cos (psi phi) ^2).
{ intros phi Hp. rewrite motion_eq_20. apply Rmult_lt_0_compat; [apply pow_lt; now apply H|apply a_bcos2_pos]. }
assert (U : 0 < psi T).
{ destruct (MVT_gen psi 0 T (fun phi => psi_rate a b (psi phi) (theta phi))) as [z [Hz E]].
  - intros z _. apply (proj1 M z).
  - intros z _. apply psi_continuous.
  - rewrite Rmin_left, Rmax_right in Hz by lra. rewrite P0 in E.
    assert (0 < psi_rate a b (psi z) (theta z)).
    { unfold psi_rate. apply Rdiv_lt_0_compat; [|apply one_bcos2_pos]. apply Rmult_lt_0_compat; [apply a_bcos2_pos|now apply H]. } nra. }
assert (E0 : PI/2 - (PI/2 - psi T) = psi T) by ring. split.
- split; [lra|]. intros t Ht. rewrite E0 in Ht. destruct (IVT_gen psi 0 T t) as [phi [Hp E]].
  + intros phi. apply psi_continuous.
  + rewrite P0, Rmin_left, Rmax_right by lra. exact Ht.
  + rewrite Rmin_left, Rmax_right in Hp by lra. rewrite <- E. now apply Q.
- unfold F. rewrite E0.
  assert (S : is_RInt (fun y => psi_rate a b (psi y) (theta y) * k a b c (psi y)) 0 T (RInt (k a b c) (psi 0) (psi T))).
  { apply (is_RInt_comp (V:=R_CompleteNormedModule) (k a b c) psi (fun y => psi_rate a b (psi y) (theta y))); intros x Hx; rewrite Rmin_left, Rmax_right in Hx by lra.
    - apply FirstEquation.k_continuous; trivial. now apply Q.
    - split; [apply (proj1 M x)|apply psi_rate_continuous]. }
  rewrite P0 in S.
  assert (W : is_RInt (fun y => psi_rate a b (psi y) (theta y) * k a b c (psi y)) 0 T ((T - 0) * 1)).
  { apply (is_RInt_ext (fun _ => 1)); [|exact (is_RInt_const (V:=R_NormedModule) 0 T 1)]. intros y Hy. rewrite Rmin_left, Rmax_right in Hy by lra. symmetry. apply rate_times_k. apply H. lra. }
  assert (E := is_RInt_unique _ _ _ _ S). assert (E' := is_RInt_unique _ _ _ _ W). rewrite E in E'. rewrite E'. ring.
Qed.
(** At T = pi it is equation (21). *)
Corollary first_implicit_equation : (forall phi, 0 <= phi <= PI -> 0 < cos (theta phi)) ->
  regular b c (PI/2 - psi PI) /\ F a b c (PI/2 - psi PI) = 2*PI.
Proof. exact (rising_sweep PI PI_RGT_0). Qed.

(** For c >= 0, cos theta never vanishes: the motion would be at rest at cos psi = 0. *)
Lemma cos_theta_not_0 phi : 0 <= c -> cos (theta phi) <> 0.
Proof.
intros Hc Z. destruct (turning_is_rest c psi theta phi (proj1 M) Hc (first_integral_at a b Hb c psi theta phi M) Z) as [Z3 R].
destruct (R 0) as [E0 _]. rewrite <- E0 in Z3. destruct M as [_ [P0 _]]. rewrite P0, cos_0 in Z3. lra.
Qed.
Theorem cos_theta_positive phi : 0 <= c -> 0 < cos (theta phi).
Proof.
intros Hc. apply Rnot_le_lt. intros N. assert (C0 : 0 < cos (theta 0)). { destruct M as [_ [_ [T _]]]. apply cos_gt_0; lra. }
destruct (IVT_gen (fun phi => cos (theta phi)) 0 phi 0) as [z [_ E]].
- intros x. apply (continuity_pt_comp theta cos); [apply theta_continuous|apply continuity_cos].
- split; [apply Rle_trans with (1 := Rmin_r _ _); lra|apply Rle_trans with (2 := Rmax_l _ _); lra].
- now apply (cos_theta_not_0 z Hc).
Qed.
End Rising.

(** The curve C lies on the first implicit equation for c >= 0, *)
Theorem curve_C_non_negative c eps : 0 <= c -> curve_C a b c eps -> regular b c eps /\ F a b c eps = 2*PI.
Proof.
intros Hc [psi [theta [M ->]]]. apply (first_implicit_equation c psi theta M). intros phi _. now apply (cos_theta_positive c psi theta M).
Qed.
(** and before the first meeting with S. *)
Theorem curve_C_before_meeting c eps : -b < c < 0 -> 2*PI < G a b (- c / b) -> curve_C a b c eps -> regular b c eps /\ F a b c eps = 2*PI.
Proof.
intros Hc H [psi [theta [M ->]]]. apply (first_implicit_equation c psi theta M). intros phi Hp.
destruct (oscillation_of_c b Hb c Hc) as [Hu E]. rewrite <- E in M.
apply (rises_to_first_turning_point a b Ha Hb (- c / b) Hu psi theta M). lra.
Qed.
End FirstBranch.
