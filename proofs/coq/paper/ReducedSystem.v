(** The reduced system, phi in place of the time: psi and theta are differentiable functions of phi on the whole line, and solve (18) and (19). *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Polhode Require Import FreeBody Loop Autonomous.
Open Scope R_scope.

Section Reduced.
Variable moment : axis -> R.
Variables th ps ph : R -> R.
Hypothesis M : motion moment th ps ph.
Notation Iy := (moment y_axis).
Notation a := (par_a moment).
Notation b := (par_b moment).
Notation x t := (cos (ps t) ^ 2).
Let f t := Iy / (1 - b * x t).

Lemma rate_bound t : (1 - b) / Iy <= Derive ph t.
Proof.
rewrite (phi_rate moment th ps ph M). destruct (b_range moment th ps ph M) as [B1 B2]. destruct (x_range ps t) as [X1 X2]. destruct (moments moment th ps ph M) as [_ [I _]].
unfold Rdiv. apply Rmult_le_compat_r. left; now apply Rinv_0_lt_compat. nra.
Qed.
(** The time as a function of phi. *)
Lemma time_of_phi : exists T : R -> R, (forall p, is_derive T p (f (T p))) /\ (forall p, ph (T p) = p) /\ forall t, T (ph t) = t.
Proof.
destruct (b_range moment th ps ph M) as [B1 B2]. destruct (moments moment th ps ph M) as [_ [I _]].
destruct (autonomous_solution f (Iy / (1 - b))) as [al D].
- intros t. apply (ex_derive_continuous f). assert (N := numerator_positive moment th ps ph M t). assert (X : ex_derive ps t) by apply (ps_differentiable _ _ _ _ M).
  unfold f. auto_derive. repeat match goal with |- _ /\ _ => split | |- True => trivial | |- ex_derive (fun y => ps y) _ => exact X end. apply Rgt_not_eq. exact N.
- intros t. apply Rdiv_lt_0_compat; trivial. apply (numerator_positive moment th ps ph M).
- intros t. unfold f, Rdiv. apply Rmult_le_compat_l; [lra|]. apply Rinv_le_contravar; [lra|]. destruct (x_range ps t) as [X1 X2]. nra.
- assert (E : forall p, ph (al p) - p = ph (al 0) - 0).
  { intros p. apply (equal_everywhere (fun p => ph (al p) - p)). intros v. evar_last. apply (is_derive_minus (fun p => ph (al p)) (fun p => p)).
    apply (is_derive_comp ph al). apply (ph_derive moment th ps ph M). apply D. apply (is_derive_id (K:=R_AbsRing)).
    rewrite (phi_rate moment th ps ph M). unfold minus, plus, opp, scal, one; simpl; unfold mult; simpl. unfold f. assert (N := numerator_positive moment th ps ph M (al v)).
    match goal with |- @eq _ ?l ?r => change (@eq R l r) end. field. lra. }
  set (p0 := ph (al 0)) in *. exists (fun p => al (p - p0)).
  assert (E' : forall p, ph (al (p - p0)) = p). { intros p. specialize (E (p - p0)). lra. }
  split; [|split; [exact E'|]].
  + intros p. evar_last. apply (is_derive_comp al (fun p => p - p0)). apply D. instantiate (1 := 1). auto_derive; trivial. unfold scal; simpl; unfold mult; simpl. apply Rmult_1_l.
  + intros t. assert (G : forall s t, s < t -> ph s < ph t).
    { intros s v L. assert (W := growth ph _ _ (ph_derive moment th ps ph M) rate_bound s v ltac:(lra)).
      assert (0 < (1 - b) / Iy * (v - s)) by (apply Rmult_lt_0_compat; [apply Rdiv_lt_0_compat; lra|lra]). lra. }
    assert (W := E' (ph t)). destruct (Rtotal_order (al (ph t - p0)) t) as [L|[L|L]]; trivial; assert (G' := G _ _ L); lra.
Qed.

(** Eqs. (18) and (19): dpsi/dphi and dtheta/dphi. *)
Theorem reduced_system : exists Theta Psi : R -> R, (forall t, Theta (ph t) = th t /\ Psi (ph t) = ps t) /\
  (forall p, is_derive Psi p ((a + b * cos (Psi p) ^ 2) * cos (Theta p) / (1 - b * cos (Psi p) ^ 2))) /\
  (forall p, is_derive Theta p (b * sin (Theta p) * sin (Psi p) * cos (Psi p) / (1 - b * cos (Psi p) ^ 2))).
Proof.
destruct time_of_phi as [T [D [E1 E2]]]. destruct (moments moment th ps ph M) as [_ [I _]]. exists (fun p => th (T p)), (fun p => ps (T p)). split; [|split].
- intros t. rewrite E2. split; reflexivity.
- intros p. assert (N := numerator_positive moment th ps ph M (T p)). evar_last. apply (is_derive_comp ps T). apply (ps_derive moment th ps ph M). apply D.
  rewrite (psi_rate moment th ps ph M). unfold scal; simpl; unfold mult; simpl. unfold f. match goal with |- @eq _ ?l ?r => change (@eq R l r) end. field. simpl in N. split; simpl; lra.
- intros p. assert (N := numerator_positive moment th ps ph M (T p)). evar_last. apply (is_derive_comp th T). apply (th_derive moment th ps ph M). apply D.
  rewrite (theta_rate moment th ps ph M). unfold scal; simpl; unfold mult; simpl. unfold f. match goal with |- @eq _ ?l ?r => change (@eq R l r) end. field. simpl in N. split; simpl; lra.
Qed.
End Reduced.
