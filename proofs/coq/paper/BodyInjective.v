(** Theorem 3 from the moments of inertia: epsilon (c) is injective on (-b, a) if and only if the moments satisfy the triangle inequalities (proposition 1). *)
Require Import Reals Lra.
From Polhode Require Prop1.
From Polhode Require Import Theorem1 Curve Theorem3.
Open Scope R_scope.
Theorem theorem_3_of_the_body Ix Iy Iz : 0 < Iz -> Iz < Iy -> Iy < Ix ->
  let a := Iy/Iz - 1 in let b := 1 - Iy/Ix in
  ((forall c d, -b < c < a -> -b < d < a -> flip_defect a b c = flip_defect a b d -> c = d) <-> (Ix <= Iy + Iz /\ Iy <= Ix + Iz /\ Iz <= Ix + Iy)).
Proof.
intros Hz Hy Hx a b. destruct (Prop1.proposition_1 Ix Iy Iz Hz Hy Hx) as [A [B E]]. fold a in A, E. fold b in B, E.
rewrite E. exact (theorem_3 a b A B).
Qed.
(** A physical body has no point of C on eps = pi/2 with -b < c < 0; every other body has one. *)
Theorem proposition_4_of_the_body Ix Iy Iz : 0 < Iz -> Iz < Iy -> Iy < Ix ->
  let a := Iy/Iz - 1 in let b := 1 - Iy/Ix in
  ((exists cs, -b < cs < 0 /\ curve_C a b cs (PI/2)) <-> Iy + Iz < Ix).
Proof.
intros Hz Hy Hx a b. destruct (Prop1.proposition_1 Ix Iy Iz Hz Hy Hx) as [A [B E]]. fold a in A, E. fold b in B, E.
rewrite <- (proposition_4 a b A B), (not_injective_iff a b A B). fold (geometric_constant a b) in E. split; intros L.
- apply Rnot_le_lt. intros N. assert (1 <= geometric_constant a b) by (apply E; repeat split; lra). lra.
- apply Rnot_le_lt. intros N. apply E in N. lra.
Qed.
