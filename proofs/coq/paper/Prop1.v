(** Proposition 1 of the paper, from the moments of inertia. *)
Require Import Reals Lra Psatz.
From Polhode Require Import Physical.
Open Scope R_scope.
(** Proposition 1 from the moments. *)
Theorem proposition_1 x y z : 0 < z -> z < y -> y < x ->
  let a := y/z - 1 in let b := 1 - y/x in
  0 < a /\ 0 < b < 1 /\ ((x <= y + z /\ y <= x + z /\ z <= x + y) <-> 1 <= (1-b) / sqrt (b*(a+b))).
Proof.
intros Hz Hy Hx a b.
assert (A : 0 < a). { unfold a. apply (Rmult_lt_reg_r z); trivial. field_simplify; lra. }
assert (B : 0 < b < 1). { unfold b. split; apply (Rmult_lt_reg_r x); try lra; field_simplify; lra. }
split; [exact A|]. split; [exact B|].
rewrite physical_iff by assumption.
assert (E : 1 - (2*b + a*b) = y*(y+z-x)/(z*x)). { unfold a, b. field. lra. }
assert (P : 0 < y/(z*x)). { apply Rdiv_lt_0_compat; nra. }
replace (y*(y+z-x)/(z*x)) with (y/(z*x)*(y+z-x)) in E by (field; lra).
split.
- intros [H _]. assert (0 <= y/(z*x)*(y+z-x)) by (apply Rmult_le_pos; lra). lra.
- intros H. repeat split; try lra. apply Rnot_lt_le. intros L. assert (y/(z*x)*(y+z-x) < 0) by nra. lra.
Qed.
(** The body is planar, I_x = I_y + I_z, if and only if I = 1. *)
Theorem planar x y z : 0 < z -> z < y -> y < x -> let a := y/z - 1 in let b := 1 - y/x in (x = y + z <-> (1-b) / sqrt (b*(a+b)) = 1).
Proof.
intros Hz Hy Hx a b. destruct (proposition_1 x y z Hz Hy Hx) as [A [B _]]. fold a in A. fold b in B.
assert (Q : 0 < b*(a+b)) by (apply Rmult_lt_0_compat; lra). assert (S := sqrt_lt_R0 _ Q). assert (S2 := sqrt_sqrt _ (Rlt_le _ _ Q)).
assert (E : (1-b)*(1-b) - b*(a+b) = y/(z*x)*(y+z-x)) by (unfold a, b; field; lra).
assert (P : 0 < y/(z*x)). { apply Rdiv_lt_0_compat; nra. }
split.
- intros H. assert (Z : (1-b)*(1-b) = sqrt (b*(a+b)) * sqrt (b*(a+b))). { rewrite S2. replace (y+z-x) with 0 in E by lra. lra. }
  assert (R1 : 1 - b = sqrt (b*(a+b))) by nra. rewrite R1. field. lra.
- intros H. assert (R1 : 1 - b = sqrt (b*(a+b))). { apply (Rmult_eq_reg_r (/ sqrt (b*(a+b)))); [|apply Rinv_neq_0_compat; lra]. rewrite Rinv_r by lra. exact H. }
  rewrite R1, S2 in E. assert (Z : y/(z*x)*(y+z-x) = 0) by lra. apply Rmult_integral in Z. destruct Z; lra.
Qed.
