(** The defect on the separatrix, the perfect twist and the points where C meets S of one body, between two numbers.
    The hypotheses are inequalities between explicit expressions, which coq-interval decides for numbers:
    `polhode certify --coq` writes them for a body. *)
Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Polhode Require Physical Theorem2 HalfPhase Values.
From Polhode Require Import Theorem1 FirstEquation Separatrix SeparatrixClosedForm Infima Symmetry Curve.
Open Scope R_scope.

(** F(0,e) in elementary functions, as SeparatrixClosedForm.separatrix_closed_form has it. *)
Definition separatrix_phase (a b e : R) : R :=
  let y := sqrt ((1 - sin e ^2) / (a + b * sin e ^2)) in
  2 / sqrt (a*b) * ((ln (1 + sqrt a * y) - ln (1 - sqrt a * y)) / 2) - 2 * atan (sqrt b * y).

Theorem defect_between a b lo hi : 0 < a -> 0 < b < 1 -> 0 < lo < PI/2 -> 0 < hi < PI/2 ->
  2*PI < separatrix_phase a b lo -> separatrix_phase a b hi < 2*PI ->
  exists e, defect_on_separatrix a b e /\ lo < e < hi /\ forall f, defect_on_separatrix a b f -> f = e.
Proof.
intros Ha Hb Hlo Hhi L U.
assert (C : forall e, 0 < e < PI/2 -> separatrix_phase a b e = F a b 0 e).
{ intros e He. symmetry. exact (separatrix_closed_form a b Ha Hb e He). }
destruct (proposition_3_1 a b Ha Hb) as [e [He [Ee Un]]].
assert (R0 : forall x, 0 < x < PI/2 -> regular b 0 x) by (intros x Hx; apply regular_separatrix; lra).
exists e. split; [now split|]. split.
- split.
  + apply Rnot_le_lt. intros N. rewrite (C lo Hlo) in L.
    destruct N as [N|N]; [|rewrite N in Ee; lra].
    assert (D := F_decreasing_e a b Ha Hb 0 e lo (R0 e He) ltac:(lra)). lra.
  + apply Rnot_le_lt. intros N. rewrite (C hi Hhi) in U.
    destruct N as [N|N]; [|rewrite <- N in Ee; lra].
    assert (D := F_decreasing_e a b Ha Hb 0 hi e (R0 hi Hhi) ltac:(lra)). lra.
- intros f [Hf Ef]. now apply Un.
Qed.

(** F(c,0) as an integral that coq-interval knows. *)
Definition rotating_phase (a b c : R) : R :=
  2 * RInt (fun t => (1 - b * cos t ^2) / sqrt ((a + b * cos t ^2) * (c + b * cos t ^2))) 0 (PI/2).

Theorem twist_between a b lo hi : 0 < a -> 0 < b < 1 -> 0 < lo -> 0 < hi <= a ->
  2*PI < rotating_phase a b lo -> rotating_phase a b hi < 2*PI ->
  exists c, perfect_twist a b c /\ lo < c < hi /\ forall d, perfect_twist a b d -> d = c.
Proof.
intros Ha Hb Hlo Hhi L U. assert (P := PI_RGT_0).
assert (E : forall c, rotating_phase a b c = F a b c 0).
{ intros c. unfold rotating_phase, F, k. now rewrite Rminus_0_r. }
rewrite E in L, U.
assert (Reg : forall c, 0 < c -> regular b c 0) by (intros c Hc; apply regular_rotating; lra).
assert (D : forall c d, 0 < c -> c < d -> F a b d 0 < F a b c 0) by (intros c d Hc Hd; apply (F_decreasing_c a b Ha Hb); [now apply Reg|exact Hd]).
assert (A : F a b a 0 < 2*PI).
{ destruct Hhi as [Hh [Hl|He]]; [assert (X := D hi a Hh Hl); lra | rewrite He in U; exact U]. }
rewrite F_rotating, (Theorem2.F_at_a a b Ha Hb) in A.
destruct (proj1 (proposition_3_2 a b Ha Hb)) as [c [Hc [Ec Un]]]; [nra|].
exists c. split; [now split|]. split.
- split; apply Rnot_le_lt; intros [N|N].
  + assert (X := D c lo ltac:(lra) N). lra.
  + rewrite N in Ec. lra.
  + assert (X := D hi c ltac:(lra) N). lra.
  + rewrite <- N in Ec. lra.
- intros d [Hd Ed]. now apply Un.
Qed.

Theorem no_twist a b : 0 < a -> 0 < b < 1 -> 9*a*(a + b) <= (a + 1)^2 -> forall c, ~ perfect_twist a b c.
Proof.
intros Ha Hb H c [Hc Ec]. assert (P := PI_RGT_0).
assert (D := F_decreasing_c a b Ha Hb c a 0 ltac:(apply regular_rotating; lra) (proj2 Hc)).
rewrite F_rotating, (Theorem2.F_at_a a b Ha Hb) in D. unfold Theorem2.second_constant in D.
assert (Q : 0 < a*(a+b)) by (apply Rmult_lt_0_compat; lra).
assert (S := sqrt_lt_R0 _ Q). assert (E := sqrt_sqrt _ (Rlt_le _ _ Q)). set (s := sqrt (a*(a+b))) in *.
assert (L : 3*s <= a + 1) by nra.
assert (3 <= (a+1)/s). { apply (Rmult_le_reg_r s); trivial. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra. }
nra.
Qed.

(** Infima.physical_parameters from numbers. *)
Theorem is_physical a b : 0 < a -> 0 < b < 1 -> 2*b + a*b <= 1 -> physical_parameters a b.
Proof. intros Ha Hb H. repeat split; try lra. unfold geometric_constant. now apply Physical.physical_iff. Qed.
Theorem is_not_physical a b : 0 < a -> 0 < b < 1 -> 1 < 2*b + a*b -> ~ physical_parameters a b.
Proof.
intros Ha Hb H [_ [_ N]]. unfold geometric_constant in N. apply Physical.physical_iff in N; trivial. lra.
Qed.

(** C meets S for the n-th time, counted from c = 0 down, at c = -b u. *)
Definition meeting_at (a b : R) (n : nat) (u : R) : Prop := nth_meeting a b n (- b * u).
Lemma meeting_at_iff a b n u : 0 < a -> 0 < b < 1 -> (1 <= n)%nat -> (meeting_at a b n u <-> 0 < u < 1 /\ HalfPhase.G a b u = 2*PI/(2*INR n - 1)).
Proof.
intros Ha Hb Hn. unfold meeting_at. rewrite (nth_meeting_iff a b Ha Hb n _ Hn). unfold solves. replace (- (- b * u) / b) with u by (field; lra).
split; intros [H1 H2]; (split; [|exact H2]).
- split; apply (Rmult_lt_reg_l b); lra.
- assert (0 < b * u) by (apply Rmult_lt_0_compat; lra). assert (0 < b * (1 - u)) by (apply Rmult_lt_0_compat; lra). lra.
Qed.
Theorem meeting_between a b n m lo hi : 0 < a -> 0 < b < 1 -> (1 <= n)%nat -> m = 2*INR n - 1 -> 0 < lo -> lo < 1 -> 0 < hi -> hi < 1 ->
  2*PI/m < HalfPhase.G a b lo -> HalfPhase.G a b hi < 2*PI/m ->
  exists u, meeting_at a b n u /\ lo < u < hi /\ forall v, meeting_at a b n v -> v = u.
Proof.
intros Ha Hb Hn -> L0 L1 H0 H1 L U. set (v := 2*PI/(2*INR n - 1)) in *.
assert (V : PI * geometric_constant a b < v).
{ rewrite <- (G_at_one a b Ha Hb). apply Rlt_trans with (2 := U). apply (HalfPhase.G_decreasing a b Ha Hb); lra. }
apply (Values.takes_each_value_once a b Ha Hb) in V. destruct V as [u [Hu [E Un]]]. exists u. split; [|split].
- now apply meeting_at_iff.
- assert (D := HalfPhase.G_decreasing a b Ha Hb). split; apply Rnot_le_lt; intros [N|N].
  + assert (X := D u lo ltac:(lra) N ltac:(lra)). lra.
  + rewrite N in E. lra.
  + assert (X := D hi u ltac:(lra) N ltac:(lra)). lra.
  + rewrite <- N in E. lra.
- intros w W. apply meeting_at_iff in W; trivial. now apply Un.
Qed.
(** How often, by rational numbers: m^2 (1-b)^2 against 4 b (a+b), m = 2n - 1. *)
Lemma constant_below a b m : 0 < a -> 0 < b < 1 -> 0 < m -> (geometric_constant a b < 2/m <-> m^2*(1-b)^2 < 4*b*(a+b)).
Proof.
intros Ha Hb Hm. unfold geometric_constant. assert (Q : 0 < b*(a+b)) by (apply Rmult_lt_0_compat; lra). assert (S := sqrt_lt_R0 _ Q). assert (S2 := sqrt_sqrt _ (Rlt_le _ _ Q)).
set (s := sqrt (b*(a+b))) in *. assert (E : (1-b)/s < 2/m <-> m*(1-b) < 2*s).
{ split; intros H.
  - apply (Rmult_lt_compat_r (s*m)) in H; [|now apply Rmult_lt_0_compat]. replace ((1-b)/s*(s*m)) with (m*(1-b)) in H by (field; lra). replace (2/m*(s*m)) with (2*s) in H by (field; lra). exact H.
  - apply (Rmult_lt_reg_r (s*m)); [now apply Rmult_lt_0_compat|]. replace ((1-b)/s*(s*m)) with (m*(1-b)) by (field; lra). replace (2/m*(s*m)) with (2*s) by (field; lra). exact H. }
rewrite E. replace (4*b*(a+b)) with ((2*s)^2) by (simpl; lra). replace (m^2*(1-b)^2) with ((m*(1-b))^2) by ring.
assert (P : 0 < m*(1-b)) by (apply Rmult_lt_0_compat; lra). split; intros H; simpl in *; nra.
Qed.
Theorem meets_exactly a b n m : 0 < a -> 0 < b < 1 -> m = 2*INR n + 1 -> m^2*(1-b)^2 < 4*b*(a+b) -> 4*b*(a+b) <= (m+2)^2*(1-b)^2 ->
  has_exactly (S n) (meeting a b).
Proof.
intros Ha Hb -> L U. assert (N := pos_INR n). apply (theorem_4_ranges a b Ha Hb n). split.
- replace (2*INR n + 3) with (2*INR n + 1 + 2) by ring. apply Rnot_lt_le. intros H. apply constant_below in H; trivial; lra.
- apply constant_below; trivial; lra.
Qed.
Theorem never_meets a b : 0 < a -> 0 < b < 1 -> 4*b*(a+b) <= (1-b)^2 -> forall c, ~ meeting a b c.
Proof.
intros Ha Hb H. apply (no_meeting a b Ha Hb). apply Rnot_lt_le. intros L. replace 2 with (2/1) in L by field. apply constant_below in L; trivial; lra.
Qed.
