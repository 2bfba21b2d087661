(** The geometric constant of a body, I = (1-b)/sqrt (b (a+b)), is at least 1 exactly where the body is physical: ab + 2b <= 1. *)
Require Import Reals Lra Psatz.
Open Scope R_scope.
Theorem physical_iff a b : 0 < a -> 0 < b < 1 -> (1 <= (1-b)/sqrt (b*(a+b)) <-> 2*b + a*b <= 1).
Proof.
intros Ha Hb. assert (P : 0 < b*(a+b)) by nra.
assert (S := sqrt_lt_R0 _ P). assert (Q := sqrt_sqrt _ (Rlt_le _ _ P)).
set (s := sqrt (b*(a+b))) in *.
assert (E : 1 <= (1-b)/s <-> s <= 1-b).
{ split; intros H.
  - apply (Rmult_le_compat_r s) in H; [|lra]. replace ((1-b)/s*s) with (1-b) in H by (field; lra). lra.
  - apply (Rmult_le_reg_r s); trivial. replace ((1-b)/s*s) with (1-b) by (field; lra). lra. }
rewrite E. split; intros H; nra.
Qed.
