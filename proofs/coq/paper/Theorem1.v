(** Theorem 1 of the paper for the half phase: the greatest lower bound of G(u) over 0 < u < 1 is pi I, and it is
    not attained. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Polhode Require Import HalfPhase.
Open Scope R_scope.
Definition geometric_constant (a b : R) := (1 - b) / sqrt (b * (a + b)).

Lemma G_at_one a b : 0 < a -> 0 < b < 1 -> G a b 1 = PI * geometric_constant a b.
Proof.
intros Ha Hb. unfold G, geometric_constant.
rewrite (RInt_ext _ (fun _ => h a b 1)).
2:{ intros t _. unfold X. f_equal. ring. }
rewrite RInt_const. unfold scal; simpl; unfold mult; simpl.
unfold h, Q.
assert (E : sqrt (b*(a+b)) = sqrt (a*b) * sqrt (1 * (1 + b*1/a))).
{ rewrite <- sqrt_mult_alt by nra. f_equal. field. lra. }
rewrite E. assert (P1 : 0 < sqrt (a*b)) by (apply sqrt_lt_R0; nra).
assert (P2 : 0 < sqrt (1 * (1 + b*1/a))).
{ apply sqrt_lt_R0. assert (0 < b*1/a) by (apply Rdiv_lt_0_compat; lra). lra. }
field. lra.
Qed.

(** Theorem 1 of the paper, for the half phase: the greatest lower bound over 0 < u < 1, i.e. -b < c < 0, and not attained. *)
Theorem half_phase_infimum a b : 0 < a -> 0 < b < 1 ->
  is_glb_Rbar (fun y => exists u, 0 < u < 1 /\ y = G a b u) (PI * geometric_constant a b) /\
  forall u, 0 < u < 1 -> PI * geometric_constant a b < G a b u.
Proof.
intros Ha Hb. rewrite <- G_at_one by assumption. split.
- split.
  + intros y [u [Hu ->]]. simpl. left. apply G_decreasing; lra.
  + intros m Hm. 
    assert (C : continuous (G a b) 1).
    { apply (ex_derive_continuous (G a b)). eexists. apply G_derive; lra. }
    destruct m as [m| |]; simpl in *.
    * apply Rnot_lt_le. intros L.
      assert (N : locally 1 (fun u => G a b u < m)).
      { apply (C (fun y => y < m)). apply (open_lt m); exact L. }
      destruct N as [e He]. set (u := 1 - Rmin (1/2) (e/2)).
      assert (He0 := cond_pos e).
      assert (M : 0 < Rmin (1/2) (e/2)) by (apply Rmin_pos; lra).
      assert (M1 := Rmin_l (1/2) (e/2)). assert (M2 := Rmin_r (1/2) (e/2)).
      assert (B : G a b u < m).
      { apply He. unfold ball; simpl; unfold AbsRing_ball, abs, minus, plus, opp; simpl. unfold u. rewrite Rabs_left; lra. }
      assert (B2 := Hm (G a b u)). simpl in B2.
      assert (m <= G a b u). { apply B2. exists u. split; [unfold u; lra|reflexivity]. } lra.
    * exfalso. apply (Hm (G a b (1/2))). exists (1/2). split; [lra|reflexivity].
    * exact I.
- intros u Hu. apply G_decreasing; lra.
Qed.

Theorem theorem_1_second_part a b : 0 < a -> 0 < b < 1 ->
  (2 * PI <= 2 * (PI * geometric_constant a b) <-> 1 <= geometric_constant a b).
Proof. intros Ha Hb. assert (P := PI_RGT_0). split; intros; nra. Qed.
