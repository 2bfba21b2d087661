(** How often the half phase G(u), 0 < u < 1, takes a value: once above pi I, never at or below it. Theorem 4
    counts its meeting points with this. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Polhode Require Import HalfPhase Theorem1 Values.
Open Scope R_scope.
(** The analytic half of lemma 2, lemma 3 and theorem 4 (sharp): for which k the equation of the k-th meeting point, or the k-th crossing, has its one root. *)
Section Count.
Variables a b : R.
Hypothesis Ha : 0 < a.
Hypothesis Hb : 0 < b < 1.
Notation I := (geometric_constant a b).
Lemma I_pos : 0 < I.
Proof. unfold geometric_constant. apply Rdiv_lt_0_compat; [lra|]. apply sqrt_lt_R0, Rmult_lt_0_compat; lra. Qed.
Definition one_root v := exists u, 0 < u < 1 /\ G a b u = v /\ forall w, 0 < w < 1 -> G a b w = v -> w = u.
Theorem meeting_points k : (1 <= k)%nat -> (one_root (2*PI/(2*INR k - 1)) <-> INR k < 1/I + 1/2).
Proof.
intros Hk. assert (K : 1 <= INR k) by (apply (le_INR 1); exact Hk). assert (P := PI_RGT_0). assert (J := I_pos).
unfold one_root. rewrite <- takes_each_value_once by assumption.
assert (E1 : 2*PI/(2*INR k - 1) = PI * (2/(2*INR k - 1))) by (field; lra). rewrite E1.
split; intros H.
- apply Rmult_lt_reg_l in H; [|lra]. apply (Rmult_lt_compat_r (2*INR k - 1)) in H; [|lra].
  replace (2/(2*INR k - 1)*(2*INR k - 1)) with 2 in H by (field; lra).
  apply (Rmult_lt_reg_l I); [lra|]. replace (I*(1/I + 1/2)) with (1 + I/2) by (field; lra). lra.
- apply Rmult_lt_compat_l; [lra|]. apply (Rmult_lt_reg_r (2*INR k - 1)); [lra|].
  replace (2/(2*INR k - 1)*(2*INR k - 1)) with 2 by (field; lra).
  apply (Rmult_lt_compat_l I) in H; [|lra]. replace (I*(1/I + 1/2)) with (1 + I/2) in H by (field; lra). lra.
Qed.
Theorem crossings k : (1 <= k)%nat -> (one_root (PI/INR k) <-> INR k < 1/I).
Proof.
intros Hk. assert (K : 1 <= INR k) by (apply (le_INR 1); exact Hk). assert (P := PI_RGT_0). assert (J := I_pos).
unfold one_root. rewrite <- takes_each_value_once by assumption. unfold Rdiv at 1.
split; intros H.
- apply Rmult_lt_reg_l in H; [|lra]. apply (Rmult_lt_compat_r (INR k)) in H; [|lra]. rewrite Rinv_l in H by lra.
  apply (Rmult_lt_reg_l I); [lra|]. replace (I*(1/I)) with 1 by (field; lra). lra.
- apply Rmult_lt_compat_l; [lra|]. apply (Rmult_lt_reg_r (INR k)); [lra|]. rewrite Rinv_l by lra.
  apply (Rmult_lt_compat_l I) in H; [|lra]. replace (I*(1/I)) with 1 in H by (field; lra). lra.
Qed.
End Count.
