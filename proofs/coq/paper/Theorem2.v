(** Theorem 2 of the paper for the half phase of the rotating motions: F(c,0) decreases in c on (0, a), and its
    greatest lower bound pi J is not attained. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
Open Scope R_scope.
Section Rotating.
Variables a b : R.
Hypothesis Ha : 0 < a.
Hypothesis Hb : 0 < b < 1.
Definition x (t : R) := cos t ^ 2.
Definition k (c t : R) := (1 - b * x t) / sqrt ((a + b * x t) * (c + b * x t)).
(** F(c,0), eq. (22) with u = 0 and x = cos^2 psi. *)
Definition F (c : R) := 2 * RInt (fun t => k c t) 0 (PI/2).
Definition second_constant := (a + 1) / sqrt (a * (a + b)) - 1.

Lemma x_range t : 0 <= x t <= 1.
Proof. unfold x. generalize (COS_bound t). intros [H1 H2]. nra. Qed.

Lemma k_continuous c t : 0 < c -> continuous (fun t => k c t) t.
Proof.
intros Hc. assert (Hx := x_range t). unfold x in Hx. 
apply (ex_derive_continuous (fun t => k c t)). unfold k, x. auto_derive.
set (u := cos t) in *.
assert (P : 0 < (a + b * (u * (u * 1))) * (c + b * (u * (u * 1)))).
{ simpl in Hx. apply Rmult_lt_0_compat; nra. }
repeat split; trivial. apply Rgt_not_eq, sqrt_lt_R0, P.
Qed.
Lemma k_integrable c u v : 0 < c -> ex_RInt (fun t => k c t) u v.
Proof. intros Hc. apply (@ex_RInt_continuous R_CompleteNormedModule). intros z _. now apply k_continuous. Qed.

Lemma F_decreasing c d : 0 < c -> c < d -> F d < F c.
Proof.
intros Hc Hd. assert (HPI := PI_RGT_0). unfold F. apply Rmult_lt_compat_l; [lra|].
apply RInt_lt; try lra.
- intros t _. apply k_continuous; lra.
- intros t _. apply k_continuous; lra.
- intros t _. assert (Hx := x_range t). unfold k. set (y := x t) in *.
  assert (B0 : 0 <= b*y) by (apply Rmult_le_pos; lra). assert (0 < 1 - b * y) by nra. assert (P : 0 < (a + b*y)*(c+b*y)) by (apply Rmult_lt_0_compat; lra).
  assert (P' : 0 < (a + b*y)*(d+b*y)) by (apply Rmult_lt_0_compat; lra).
  unfold Rdiv. apply Rmult_lt_compat_l; [lra|]. apply Rinv_lt_contravar.
  + apply Rmult_lt_0_compat; apply sqrt_lt_R0; assumption.
  + apply sqrt_lt_1_alt. split; [lra|]. apply Rmult_lt_compat_l; lra.
Qed.

(** (a + bX)/(c + bX) <= a/c *)
Lemma F_upper c : 0 < c -> c < a -> F c <= sqrt (a/c) * F a.
Proof.
intros Hc Hca. assert (HPI := PI_RGT_0). unfold F.
assert (E : RInt (fun t => sqrt (a/c) * k a t) 0 (PI/2) = sqrt (a/c) * RInt (fun t => k a t) 0 (PI/2)).
{ apply (RInt_scal (V:=R_CompleteNormedModule)). apply k_integrable; lra. }
apply Rle_trans with (2 * RInt (fun t => sqrt (a/c) * k a t) 0 (PI/2)).
2:{ rewrite E. apply Req_le. match goal with |- @eq _ ?l ?r => change (@eq R l r) end. ring. }
clear E. apply Rmult_le_compat_l; [lra|]. apply RInt_le; try lra.
- apply k_integrable; lra.
- apply (@ex_RInt_scal R_NormedModule). apply k_integrable; lra.
- intros t _. assert (Hx := x_range t). unfold k. set (y := x t) in *.
  assert (B0 : 0 <= b*y) by (apply Rmult_le_pos; lra). assert (0 < 1 - b * y) by nra.
  assert (P : 0 < (a + b*y)*(c+b*y)) by (apply Rmult_lt_0_compat; lra). assert (P2 : 0 < (a + b*y)*(a+b*y)) by (apply Rmult_lt_0_compat; lra).
  assert (S1 := sqrt_lt_R0 _ P). assert (S2 := sqrt_lt_R0 _ P2). 
  assert (Hac : 0 < a/c) by (apply Rdiv_lt_0_compat; lra).
  assert (L : sqrt ((a + b*y)*(a+b*y)) <= sqrt (a/c) * sqrt ((a + b*y)*(c+b*y))).
  { rewrite <- sqrt_mult_alt by lra. apply sqrt_le_1_alt. apply (Rmult_le_reg_r c); [lra|].
    replace (a / c * ((a + b*y)*(c + b*y))*c) with ((a+b*y)*(a*(c+b*y))) by (field; lra).
    rewrite Rmult_assoc. apply Rmult_le_compat_l; [lra|]. nra. }
  set (S := sqrt ((a + b*y)*(c+b*y))) in *. set (T := sqrt ((a + b*y)*(a+b*y))) in *. set (r := sqrt (a/c)) in *.
  apply (Rmult_le_reg_r (S*T)). { now apply Rmult_lt_0_compat. }
  replace ((1-b*y)/S*(S*T)) with ((1-b*y)*T) by (field; lra).
  replace (r*((1-b*y)/T)*(S*T)) with ((1-b*y)*(r*S)) by (field; lra).
  apply Rmult_le_compat_l; lra.
Qed.

(** An antiderivative of 1/(a + b cos^2) that is smooth on the whole line. *)
Definition q := sqrt (a/(a+b)).
Lemma q_range : 0 < q < 1.
Proof.
unfold q. split. apply sqrt_lt_R0, Rdiv_lt_0_compat; lra.
rewrite <- sqrt_1. apply sqrt_lt_1_alt. split. apply Rlt_le, Rdiv_lt_0_compat; lra.
apply (Rmult_lt_reg_r (a+b)); [lra|]. field_simplify; lra.
Qed.
Definition w t := t + atan ((q - 1) * sin t * cos t / (cos t ^2 + q * sin t ^2)).
Lemma w_derive t : is_derive w t (q / (cos t ^2 + q^2 * sin t ^2)).
Proof.
assert (Q := q_range). assert (E := sin2_cos2 t). unfold Rsqr in E.
assert (D : 0 < cos t ^2 + q * sin t ^2) by (simpl; nra).
assert (D2 : 0 < cos t ^2 + q^2 * sin t ^2).
{ simpl. assert (0 < q*q) by nra. nra. }
unfold w. auto_derive. simpl in *. lra.
set (s := sin t) in *. set (u := cos t) in *. simpl in *.
assert (N : (u*(u*1) + q*(s*(s*1)))^2 + ((q-1)*s*u)^2 = (u*u+s*s)*(u*u + q*q*(s*s))) by ring.
assert (0 < 1 + ((q-1)*s*u/(u*(u*1) + q*(s*(s*1))))^2) by (assert (H0 := pow2_ge_0 ((q-1)*s*u/(u*(u*1) + q*(s*(s*1))))); lra).
simpl in *.
assert (U : u*u = 1 - s*s) by lra.
field_simplify_eq. 
2:{ repeat split; try lra. 
    assert (0 < (u*u+s*s)*(u*u + q*q*(s*s))). { replace (u*u+s*s) with 1 by lra. lra. } nra. }
simpl. ring [U].
Qed.

Lemma F_at_a : F a = PI * second_constant.
Proof.
assert (HPI := PI_RGT_0). assert (Q := q_range).
assert (Q2 : q^2 = a/(a+b)). { unfold q. apply pow2_sqrt. apply Rlt_le, Rdiv_lt_0_compat; lra. }
assert (W : is_RInt (fun t => q / (cos t ^2 + q^2 * sin t ^2)) 0 (PI/2) (PI/2)).
{ replace (PI/2) with (minus (w (PI/2)) (w 0)) at 2.
  2:{ unfold w, minus, plus, opp; simpl. rewrite cos_PI2, sin_0, !Rmult_0_r. unfold Rdiv at 3. rewrite !Rmult_0_l, ?Rmult_0_r. unfold Rdiv. rewrite !Rmult_0_l, atan_0. ring. }
  apply (is_RInt_derive (V:=R_CompleteNormedModule) w).
  - intros t _. apply w_derive.
  - intros t _. assert (E := sin2_cos2 t). unfold Rsqr in E.
    apply (ex_derive_continuous (fun t => q / (cos t ^2 + q^2 * sin t ^2))). auto_derive. simpl.
    assert (0 < q*q) by nra. nra. }
assert (S1 : 0 < sqrt (a*(a+b))) by (apply sqrt_lt_R0; nra).
unfold F. rewrite (RInt_ext _ (fun t => minus (scal ((1+a)/sqrt (a*(a+b))) (q / (cos t ^2 + q^2 * sin t ^2))) 1)).
2:{ intros t _. unfold minus, plus, opp, scal; simpl; unfold mult; simpl.
    unfold k. assert (Hx := x_range t). unfold x in *. assert (E := sin2_cos2 t). unfold Rsqr in E.
    set (u := cos t) in *. set (v := sin t) in *. 
    assert (B0 : 0 <= b * u^2) by (apply Rmult_le_pos; lra).
    rewrite sqrt_square by lra.
    replace (q * (q * 1)) with (q^2) by ring. rewrite Q2.
    assert (E1 : q / sqrt (a*(a+b)) = / (a+b)).
    { unfold q. rewrite sqrt_div_alt by lra. rewrite (sqrt_mult_alt a) by lra.
      assert (0 < sqrt a) by (apply sqrt_lt_R0; lra). assert (0 < sqrt (a+b)) by (apply sqrt_lt_R0; lra).
      rewrite <- (sqrt_sqrt (a+b)) at 3 by lra. field. lra. }
    assert (D : u*(u*1) + a/(a+b)*(v*(v*1)) = (a + b*u^2)/(a+b)).
    { replace (v*(v*1)) with (1 - u*u) by lra. field. lra. }
    rewrite D. replace ((1+a)/sqrt (a*(a+b)) * (q/((a+b*u^2)/(a+b)))) with ((1+a) * (q / sqrt (a*(a+b))) * ((a+b)/(a+b*u^2))).
    2:{ field. simpl in *. repeat split; lra. }
    rewrite E1. match goal with |- @eq _ ?l ?r => change (@eq R l r) end. field. simpl in *. repeat split; lra. }
assert (HR : is_RInt (fun t => minus (scal ((1+a)/sqrt (a*(a+b))) (q / (cos t ^2 + q^2 * sin t ^2))) 1) 0 (PI/2)
   (minus (scal ((1+a)/sqrt (a*(a+b))) (PI/2)) (scal (PI/2 - 0) 1))).
{ apply (is_RInt_minus (V:=R_NormedModule)). apply (is_RInt_scal (V:=R_NormedModule)). exact W. apply (is_RInt_const (V:=R_NormedModule)). }
rewrite (is_RInt_unique _ _ _ _ HR). unfold second_constant, minus, plus, opp, scal; simpl; unfold mult; simpl.
match goal with |- @eq _ ?l ?r => change (@eq R l r) end. field. lra.
Qed.

(** Theorem 2 of the paper, for F = half the phase. *)
Theorem rotating_infimum :
  is_glb_Rbar (fun y => exists c, 0 < c < a /\ y = F c) (PI * second_constant) /\
  forall c, 0 < c < a -> PI * second_constant < F c.
Proof.
rewrite <- F_at_a. split.
- split.
  + intros y [c [Hc ->]]. simpl. left. apply F_decreasing; lra.
  + intros m Hm. destruct m as [m| |]; simpl.
    * apply Rnot_lt_le. intros L.
      assert (P : 0 < F a).
      { assert (HPI := PI_RGT_0). unfold F. apply Rmult_lt_0_compat; [lra|]. apply RInt_gt_0; try lra.
        - intros t _. assert (Hx := x_range t). unfold k. assert (B0 : 0 <= b * x t) by (apply Rmult_le_pos; lra).
          assert (b * x t < 1) by nra. apply Rdiv_lt_0_compat; [lra|]. apply sqrt_lt_R0. apply Rmult_lt_0_compat; lra.
        - intros t _. apply k_continuous; lra. }
      (* sqrt (a/c) <= a/c, so that c = a F(a)/m' is near enough *)
      set (m' := (F a + m)/2). assert (F a < m' < m) by (unfold m'; lra).
      set (c := a * (F a / m')). 
      assert (R1 : 0 < F a / m' < 1). { split. apply Rdiv_lt_0_compat; lra. apply (Rmult_lt_reg_r m'); [lra|]. field_simplify; lra. }
      assert (Hc : 0 < c < a) by (unfold c; nra).
      assert (U := F_upper c ltac:(lra) ltac:(lra)).
      assert (AC : a/c = m'/F a). { unfold c. field. repeat split; lra. }
      rewrite AC in U. 
      assert (V : sqrt (m'/F a) <= m'/F a).
      { assert (1 <= m'/F a). { apply (Rmult_le_reg_r (F a)); trivial. field_simplify; lra. }
        rewrite <- (sqrt_square (m'/F a)) at 2 by lra. apply sqrt_le_1_alt. nra. }
      assert (F c <= m'). { apply Rle_trans with (1:=U). apply (Rmult_le_compat_r (F a)) in V; [|lra]. replace (m'/F a*F a) with m' in V by (field; lra). exact V. }
      assert (B := Hm (F c)). simpl in B. assert (m <= F c) by (apply B; exists c; split; [lra|reflexivity]). lra.
    * exfalso. apply (Hm (F (a/2))). exists (a/2). split; [lra|reflexivity].
    * exact I.
- intros c Hc. apply F_decreasing; lra.
Qed.
End Rotating.
