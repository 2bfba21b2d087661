(** Lemmas 4 and 5 of the paper: the perfect twist c0(a,b) and the defect on the separatrix e0(a,b) decrease as a increases; so do all
    points of the curve that the first implicit equation describes. *)
Require Import Reals Lra Psatz.
From Polhode Require Import FirstEquation.
Open Scope R_scope.

(** The parameter c of a given defect decreases as a increases. *)
Theorem c_decreases_in_a a a' b c c' e : 0 < a -> a < a' -> 0 < b < 1 -> regular b c e -> regular b c' e ->
  F a b c e = 2*PI -> F a' b c' e = 2*PI -> c' < c.
Proof.
intros Ha L Hb H H' E E'. apply Rnot_le_lt. intros M.
assert (N := F_decreasing_a a a' b c e Ha Hb H L).
assert (F a' b c' e <= F a' b c e).
{ destruct M as [M|<-]; [|lra]. left. apply F_decreasing_c; trivial; lra. }
lra.
Qed.

(** The defect at a given c decreases as a increases. *)
Theorem defect_decreases_in_a a a' b c e e' : 0 < a -> a < a' -> 0 < b < 1 -> regular b c e -> regular b c e' ->
  F a b c e = 2*PI -> F a' b c e' = 2*PI -> e' < e.
Proof.
intros Ha L Hb H H' E E'. apply Rnot_le_lt. intros M.
assert (N := F_decreasing_a a a' b c e Ha Hb H L).
assert (F a' b c e' <= F a' b c e).
{ destruct M as [M|<-]; [|lra]. left. apply F_decreasing_e; trivial; try lra. destruct H'; lra. }
lra.
Qed.

(** Lemma 4: c0(a') < c0(a) for a < a'. *)
Theorem lemma_4 a a' b c0 c0' : 0 < a -> a < a' -> 0 < b < 1 -> 0 < c0 -> 0 < c0' ->
  F a b c0 0 = 2*PI -> F a' b c0' 0 = 2*PI -> c0' < c0.
Proof.
intros Ha L Hb H H'. assert (P := PI_RGT_0). apply c_decreases_in_a; trivial; apply regular_rotating; lra.
Qed.

(** Lemma 5: e0(a') < e0(a) for a < a'. *)
Theorem lemma_5 a a' b e0 e0' : 0 < a -> a < a' -> 0 < b < 1 -> 0 < e0 < PI/2 -> 0 < e0' < PI/2 ->
  F a b 0 e0 = 2*PI -> F a' b 0 e0' = 2*PI -> e0' < e0.
Proof.
intros Ha L Hb H H'. apply defect_decreases_in_a; trivial; apply regular_separatrix; lra.
Qed.
