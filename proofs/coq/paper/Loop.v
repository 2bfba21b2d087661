(** Loops of the angular momentum in the body frame, and how to follow one: an angle alpha that always grows and determines the momentum
    up to whole turns. The momentum first returns when alpha has gained 2 pi. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Polhode Require Import FreeBody.
Open Scope R_scope.

Lemma equal_everywhere (f : R -> R) : (forall t, is_derive f t 0) -> forall s t, f s = f t.
Proof.
intros D s t. destruct (MVT_gen f s t (fun _ => 0)) as [z [_ E]]; try lra.
- intros v _. apply D.
- intros v _. apply continuity_pt_filterlim. apply (ex_derive_continuous f). eexists. apply D.
Qed.

Lemma growth (f df : R -> R) (m : R) : (forall t, is_derive f t (df t)) -> (forall t, m <= df t) -> forall s t, s <= t -> m * (t - s) <= f t - f s.
Proof.
intros D L s t H. destruct (MVT_gen f s t df) as [z [_ E]].
- intros v _. apply D.
- intros v _. apply continuity_pt_filterlim. apply (ex_derive_continuous f). eexists. apply D.
- rewrite E. apply Rmult_le_compat_r; [lra|apply L].
Qed.

(** A continuous function without a zero keeps its sign. *)
Lemma keeps_sign (f : R -> R) : (forall t, continuous f t) -> (forall t, f t <> 0) -> 0 < f 0 -> forall t, 0 < f t.
Proof.
intros C N H t. apply Rnot_le_lt. intros L.
destruct (IVT_gen f 0 t 0) as [z [_ E]].
- intros v. apply continuity_pt_filterlim, C.
- rewrite Rmin_right, Rmax_left by lra. lra.
- now apply (N z).
Qed.
Lemma sign_of (f : R -> R) : (forall t, continuous f t) -> (forall t, f t <> 0) -> exists k, k * k = 1 /\ forall t, 0 < k * f t.
Proof.
intros C N. destruct (Rtotal_order (f 0) 0) as [H|[H|H]].
- exists (-1). split; [lra|]. apply (keeps_sign (fun t => -1 * f t)); try lra.
  + intros t. apply (continuous_mult (fun _ => -1) f). apply continuous_const. apply C.
  + intros t E. apply (N t). lra.
- now destruct (N 0).
- exists 1. split; [lra|]. intros t. rewrite Rmult_1_l. now apply keeps_sign.
Qed.

Lemma full_turn d : 0 < d <= 2*PI -> cos d = 1 -> d = 2*PI.
Proof.
intros [H1 H2] E. destruct (Rle_lt_or_eq_dec _ _ H2) as [L|]; trivial. exfalso.
assert (S : 0 < sin (d/2)) by (apply sin_gt_0; lra).
replace d with (2*(d/2)) in E by field. rewrite cos_2a_sin in E. nra.
Qed.
Lemma angle_exists s q : s*s + q*q = 1 -> exists v, sin v = s /\ cos v = q.
Proof.
intros E. assert (S : -1 <= s <= 1) by (split; nra).
assert (C : cos (asin s) = Rabs q).
{ rewrite cos_asin by trivial. rewrite <- sqrt_Rsqr_abs. f_equal. unfold Rsqr. lra. }
destruct (Rle_dec 0 q) as [Q|Q].
- exists (asin s). rewrite sin_asin by trivial. rewrite C, Rabs_right by lra. split; reflexivity.
- exists (PI - asin s). rewrite sin_PI_x, sin_asin by trivial. split; [reflexivity|].
  replace (PI - asin s) with (- asin s + PI) by ring. rewrite neg_cos, cos_neg, C, Rabs_left by lra. ring.
Qed.

(** A differentiable point of the unit circle has a differentiable angle. *)
Lemma angle_lift (p q w : R -> R) : (forall t, p t * p t + q t * q t = 1) -> (forall t, continuous w t) ->
  (forall t, is_derive p t (- (w t * q t))) -> (forall t, is_derive q t (w t * p t)) ->
  exists al : R -> R, (forall t, is_derive al t (w t)) /\ forall t, cos (al t) = p t /\ sin (al t) = q t.
Proof.
intros C W Dp Dq. destruct (angle_exists (q 0) (p 0)) as [v [V1 V2]]. { rewrite <- (C 0). ring. }
set (al := fun t => v + RInt w 0 t). exists al.
assert (D : forall t, is_derive al t (w t)).
{ intros t. evar_last. apply (is_derive_plus (fun _ => v) (fun t => RInt w 0 t)). apply (is_derive_const (V:=R_NormedModule) v).
  apply (is_derive_RInt w _ 0). 2: apply W.
  exists (mkposreal 1 Rlt_0_1). intros z _. apply (@RInt_correct R_CompleteNormedModule). apply (@ex_RInt_continuous R_CompleteNormedModule). intros y _. apply W.
  unfold plus, zero; simpl. ring. }
split; [exact D|].
set (d := fun t => (q t - sin (al t))^2 + (p t - cos (al t))^2).
assert (Dd : forall t, is_derive d t 0).
{ intros t. assert (E1 := Dq t). assert (E2 := Dp t). assert (E3 := D t). unfold d. auto_derive.
  repeat split; eexists; [apply E1|apply E3|apply E2|apply E3].
  change (fun y => p y) with p. change (fun y => q y) with q. change (fun y => al y) with al.
  rewrite (is_derive_unique q _ _ E1), (is_derive_unique p _ _ E2), (is_derive_unique al _ _ E3). ring. }
intros t. assert (E := equal_everywhere d Dd t 0).
assert (d 0 = 0). { unfold d, al. rewrite (RInt_point (V:=R_CompleteNormedModule)). unfold zero; simpl. rewrite Rplus_0_r, V1, V2. ring. }
assert (Z : (q t - sin (al t))^2 + (p t - cos (al t))^2 = 0) by (change (d t = 0); lra).
assert (P1 := pow2_ge_0 (q t - sin (al t))). assert (P2 := pow2_ge_0 (p t - cos (al t))). split; nra.
Qed.

(** The momentum, in the body frame, at the times s and t is the same. *)
Definition same_momentum (th ps : R -> R) (s t : R) := forall i, momentum (th s) (ps s) i = momentum (th t) (ps t) i.
(** From t0 to t1 the momentum goes through one loop: t1 is its first return. *)
Definition one_loop (th ps : R -> R) (t0 t1 : R) :=
  t0 < t1 /\ same_momentum th ps t1 t0 /\ forall t, t0 < t < t1 -> ~ same_momentum th ps t t0.

(** With 0 < sin theta the momentum gives cos theta, sin theta, cos psi and sin psi. *)
Lemma same_momentum_angles th ps s t : 0 < sin (th s) -> 0 < sin (th t) ->
  same_momentum th ps s t <-> cos (th s) = cos (th t) /\ cos (ps s) = cos (ps t) /\ sin (ps s) = sin (ps t).
Proof.
intros S T. assert (ES := sin2_cos2 (th s)). assert (ET := sin2_cos2 (th t)). unfold Rsqr in ES, ET.
assert (Q : cos (th s) = cos (th t) -> sin (th s) = sin (th t)).
{ intros E. rewrite E in ES. nra. }
split.
- intros H. assert (Hz := H z_axis). assert (Hx := H x_axis). assert (Hy := H y_axis). simpl in *.
  rewrite (Q Hz) in Hx, Hy. repeat split; trivial; apply (Rmult_eq_reg_l (sin (th t))); lra.
- intros [H1 [H2 H3]] i. destruct i; simpl; rewrite ?H1, ?H2, ?H3, ?(Q H1); reflexivity.
Qed.

Section Lift.
Variables th ps al dal : R -> R.
Variable m : R.
Hypothesis Hm : 0 < m.
Hypothesis Dal : forall t, is_derive al t (dal t).
Hypothesis faster : forall t, m <= dal t.
Hypothesis determines : forall s t, same_momentum th ps s t <-> cos (al s) = cos (al t) /\ sin (al s) = sin (al t).

Lemma al_increases s t : s < t -> al s < al t.
Proof. intros H. assert (L := growth al dal m Dal faster s t ltac:(lra)). assert (0 < m * (t - s)) by (apply Rmult_lt_0_compat; lra). lra. Qed.
Lemma not_within_a_turn t0 t : al t0 < al t < al t0 + 2*PI -> ~ same_momentum th ps t t0.
Proof.
intros B E. apply determines in E. destruct E as [E1 E2].
assert (E : cos (al t - al t0) = 1). { rewrite cos_minus, E1, E2. assert (Q := sin2_cos2 (al t0)). unfold Rsqr in Q. lra. }
assert (al t - al t0 = 2*PI) by (apply full_turn; lra). lra.
Qed.
Lemma turn_is_loop t0 t1 : al t1 = al t0 + 2*PI -> one_loop th ps t0 t1.
Proof.
intros E. assert (HPI := PI_RGT_0). assert (L : t0 < t1).
{ apply Rnot_le_lt. intros [L|L]. assert (A := al_increases _ _ L). lra. rewrite L in E. lra. }
split; [exact L|]. split.
- apply determines. rewrite E. replace (al t0 + 2*PI) with (al t0 + 2 * INR 1 * PI) by (simpl; ring). split; [apply cos_period|apply sin_period].
- intros t [T0 T1]. apply not_within_a_turn. assert (A := al_increases _ _ T0). assert (B := al_increases _ _ T1). lra.
Qed.
(** alpha does gain 2 pi. *)
Lemma turn_exists t0 : exists t1, al t1 = al t0 + 2*PI.
Proof.
assert (HPI := PI_RGT_0). set (T := t0 + 2*PI/m). assert (0 < 2*PI/m) by (apply Rdiv_lt_0_compat; lra).
assert (L := growth al dal m Dal faster t0 T ltac:(unfold T; lra)). replace (m * (T - t0)) with (2*PI) in L by (unfold T; field; lra).
destruct (IVT_gen al t0 T (al t0 + 2*PI)) as [t1 [_ E]].
- intros v. apply continuity_pt_filterlim. apply (ex_derive_continuous al). eexists. apply Dal.
- rewrite Rmin_left, Rmax_right by lra. lra.
- now exists t1.
Qed.
(** From every time on the momentum goes through a loop, and over it alpha gains exactly 2 pi. *)
Lemma loop_exists t0 : exists t1, one_loop th ps t0 t1.
Proof. destruct (turn_exists t0) as [t1 E]. exists t1. now apply turn_is_loop. Qed.
Lemma loop_is_turn t0 t1 : one_loop th ps t0 t1 -> al t1 = al t0 + 2*PI.
Proof.
intros [L [S N]]. destruct (turn_exists t0) as [t2 E]. destruct (turn_is_loop _ _ E) as [L2 [S2 N2]].
destruct (Rtotal_order t1 t2) as [D|[D|D]].
- destruct (N2 t1); [lra|exact S].
- now rewrite D.
- destruct (N t2); [lra|exact S2].
Qed.
End Lift.

(** What an angle phi gains, when phi' = k(alpha) alpha' and P' = k. *)
Lemma gain_by_lift (ph al dal P k : R -> R) : (forall t, is_derive al t (dal t)) -> (forall y, is_derive P y (k y)) ->
  (forall t, is_derive ph t (k (al t) * dal t)) -> forall s t, ph t - ph s = P (al t) - P (al s).
Proof.
intros Da DP Dph s t. assert (E : ph s - P (al s) = ph t - P (al t)).
{ apply (equal_everywhere (fun t => ph t - P (al t))). intros v. evar_last. apply (is_derive_minus ph (fun t => P (al t))). apply Dph.
  apply (is_derive_comp P al). apply DP. apply Da. unfold minus, plus, opp, scal; simpl; unfold mult; simpl. ring. }
lra.
Qed.
(** The gain over a turn of alpha, when k has the period pi. *)
Lemma gain_of_half_turn (P k : R -> R) : (forall y, is_derive P y (k y)) -> (forall y, k (y + PI) = k y) -> forall y z, P (y + PI) - P y = P (z + PI) - P z.
Proof.
intros D Pe. apply (equal_everywhere (fun y => P (y + PI) - P y)). intros y.
evar_last. apply (is_derive_minus (fun y => P (y + PI)) P). apply (is_derive_comp P (fun y => y + PI)). apply D. instantiate (1 := 1). auto_derive; trivial. apply D.
unfold minus, plus, opp, scal; simpl; unfold mult; simpl. rewrite Pe. ring.
Qed.
Lemma gain_of_turn (P k : R -> R) : (forall y, is_derive P y (k y)) -> (forall y, k (y + PI) = k y) -> forall y z, P (y + 2*PI) - P y = 2 * (P (z + PI) - P z).
Proof.
intros D Pe y z. assert (E1 := gain_of_half_turn P k D Pe y z). assert (E2 := gain_of_half_turn P k D Pe (y + PI) z).
replace (y + PI + PI) with (y + 2*PI) in E2 by ring. lra.
Qed.
