(** The defect on the separatrix and the perfect twist of one body, between two numbers.
    The hypotheses are inequalities between explicit expressions, which coq-interval decides for numbers:
    `polhode certify --coq` writes them for a body. *)
Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Polhode Require Physical Theorem2.
From Polhode Require Import Theorem1 FirstEquation Separatrix SeparatrixClosedForm Infima.
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

(** Infima.physical from numbers. *)
Theorem is_physical a b : 0 < a -> 0 < b < 1 -> 2*b + a*b <= 1 -> physical a b.
Proof. intros Ha Hb H. repeat split; try lra. unfold geometric_constant. now apply Physical.physical_iff. Qed.
Theorem is_not_physical a b : 0 < a -> 0 < b < 1 -> 1 < 2*b + a*b -> ~ physical a b.
Proof.
intros Ha Hb H [_ [_ N]]. unfold geometric_constant in N. apply Physical.physical_iff in N; trivial. lra.
Qed.
