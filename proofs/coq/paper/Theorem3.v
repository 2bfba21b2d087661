(** Theorem 3 and proposition 4 of the paper, on the whole range -b < c < a, for all a > 0, 0 < b < 1: C, as the graph of epsilon (c), is injective if and only
    if I >= 1, and then epsilon strictly decreases. C is the set of the motions' (c, eps) (Curve.v); that it is the graph of a function is lemma 1. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Polhode Require FirstEquation Values.
From Polhode Require Import HalfPhase Theorem1 Uniqueness Oscillation Symmetry Curve SwingInC DecreasesOscillating NotInjective FirstBranch CentredMotions.
Open Scope R_scope.

Section Theorem3.
Variables a b : R.
Hypothesis Ha : 0 < a.
Hypothesis Hb : 0 < b < 1.
Notation I := (geometric_constant a b).
Notation C := (curve_C a b).

(** Near the separatrix G exceeds every bound. *)
Lemma near_separatrix c : -b < c < 0 -> exists c', c < c' < 0 /\ 2*PI < G a b (- c' / b).
Proof.
intros Hc. destruct (oscillation_of_c b Hb c Hc) as [Hu E]. set (u := - c / b) in *.
set (v := Rmax (PI * I) (2*PI) + 1). assert (V1 := Rmax_l (PI * I) (2*PI)). assert (V2 := Rmax_r (PI * I) (2*PI)).
destruct (proj1 (Values.takes_each_value_once a b Ha Hb v) ltac:(unfold v; lra)) as [w [Hw [Gw _]]].
set (x := Rmin w u / 2). assert (M1 := Rmin_l w u). assert (M2 := Rmin_r w u). assert (M0 : 0 < Rmin w u) by (apply Rmin_pos; lra).
assert (Hx : 0 < x /\ x < w /\ x < u) by (unfold x; lra). exists (- b * x).
assert (B : - (- b * x) / b = x) by (field; lra). rewrite B. split.
- rewrite <- E. assert (b * x < b * u) by (apply Rmult_lt_compat_l; lra). assert (0 < b * x) by (apply Rmult_lt_0_compat; lra). lra.
- assert (D := G_decreasing a b Ha Hb x w ltac:(lra) ltac:(lra) ltac:(lra)). rewrite Gw in D. unfold v in D. lra.
Qed.
(** epsilon strictly decreases from c* (where C crosses eps = pi/2; -b if it does not) upwards, in every body: where c >= 0 or G (-c/b) >= pi. *)
Theorem curve_decreases c d e f : -b < c -> (c < 0 -> PI <= G a b (- c / b)) -> c < d -> C c e -> C d f -> f < e.
Proof.
intros Hc H L Ce Df. destruct (Rlt_le_dec d 0) as [Hd|Hd].
- apply (curve_C_epsilon a b Ha Hb) in Ce; [|lra]. apply (curve_C_epsilon a b Ha Hb) in Df; [|lra]. subst e f.
  apply epsilon_decreases; trivial. apply H. lra.
- apply (curve_C_non_negative a b Ha Hb d f Hd) in Df. destruct Df as [Rd Fd]. destruct (Rlt_le_dec c 0) as [Hc0|Hc0].
  + destruct (near_separatrix c ltac:(lra)) as [c' [Hc' G']].
    assert (C' : C c' (epsilon a b c')) by (apply (curve_C_epsilon a b Ha Hb); [lra|reflexivity]).
    apply (curve_C_before_meeting a b Ha Hb c' _ ltac:(lra) G') in C'. destruct C' as [R' F'].
    assert (D := FirstEquation.proposition_2 a b Ha Hb c' d _ _ R' Rd F' Fd ltac:(lra)).
    apply (curve_C_epsilon a b Ha Hb) in Ce; [|lra]. subst e.
    assert (D' := epsilon_decreases a b Ha Hb c c' Hc (proj1 Hc') (proj2 Hc') (H Hc0)). lra.
  + apply (curve_C_non_negative a b Ha Hb c e Hc0) in Ce. destruct Ce as [Rc Fc].
    exact (FirstEquation.proposition_2 a b Ha Hb c d e f Rc Rd Fc Fd L).
Qed.
(** Theorem 3, I >= 1 (the physical bodies, proposition 1): epsilon strictly decreases on -b < c < a. *)
Theorem physical_curve_decreases c d e f : 1 <= I -> -b < c -> c < d -> C c e -> C d f -> f < e.
Proof.
intros H Hc L. apply curve_decreases; trivial. intros Hc0. left. apply physical_G; trivial. apply oscillation_of_c; trivial. lra.
Qed.
(** For 0 <= c < a, C is exactly the first implicit equation. *)
Theorem curve_C_iff_first_equation c eps : 0 <= c < a -> (C c eps <-> FirstEquation.regular b c eps /\ FirstEquation.F a b c eps = 2*PI).
Proof.
intros Hc. split; [apply curve_C_non_negative; trivial; lra|]. intros [Re Fe]. destruct (lemma_1_graph a b Ha Hb c ltac:(lra)) as [f [Cf _]].
assert (Cf' := Cf). apply (curve_C_non_negative a b Ha Hb c f (proj1 Hc)) in Cf'. destruct Cf' as [Rf Ff].
now rewrite (FirstEquation.one_defect a b Ha Hb c eps f Re Rf Fe Ff).
Qed.
(** The function epsilon (c) on -b < c < a. *)
Definition flip_defect (c : R) : R := real (Glb_Rbar (C c)).
Theorem flip_defect_on_C c : -b < c < a -> C c (flip_defect c).
Proof.
intros Hc. destruct (lemma_1_graph a b Ha Hb c Hc) as [e [Ce U]].
assert (E : Glb_Rbar (C c) = Finite e).
{ apply is_glb_Rbar_unique. split; [intros x Cx; rewrite (U x Cx); apply Rle_refl|intros m Hm; now apply Hm]. }
unfold flip_defect. rewrite E. exact Ce.
Qed.
(** C has two points with the same epsilon and different c in (-b, a). *)
Definition not_injective := exists c d e, -b < c < d /\ d < a /\ C c e /\ C d e.
Lemma not_injective_iff : not_injective <-> I < 1.
Proof.
split.
- intros [c [d [e [[Hc L] [_ [Ce De]]]]]]. apply Rnot_le_lt. intros H. assert (D := physical_curve_decreases c d e e H Hc L Ce De). lra.
- intros H. destruct (same_defect_twice a b Ha Hb H) as [c [d [Hc [L [Hd [E _]]]]]]. exists c, d, (epsilon a b c).
  split; [now split|]. split; [lra|]. split; apply (curve_C_epsilon a b Ha Hb); trivial; lra.
Qed.
(** Theorem 3 for the curve: no two points of C, -b < c < a, have the same eps if and only if I >= 1. *)
Theorem theorem_3_curve : (forall c d e, -b < c < a -> -b < d < a -> C c e -> C d e -> c = d) <-> 1 <= I.
Proof.
split.
- intros H. apply Rnot_lt_le. intros L. apply not_injective_iff in L. destruct L as [c [d [e [[Hc L] [Hd [Ce De]]]]]].
  assert (c = d) by (apply (H c d e); trivial; lra). lra.
- intros H c d e Hc Hd Ce De. destruct (Rtotal_order c d) as [L|[L|L]]; trivial.
  + assert (D := physical_curve_decreases c d e e H (proj1 Hc) L Ce De). lra.
  + assert (D := physical_curve_decreases d c e e H (proj1 Hd) L De Ce). lra.
Qed.
(** Theorem 3: epsilon (c), -b < c < a, is injective if and only if I >= 1. *)
Theorem theorem_3 : (forall c d, -b < c < a -> -b < d < a -> flip_defect c = flip_defect d -> c = d) <-> 1 <= I.
Proof.
rewrite <- theorem_3_curve. split; intros H.
- intros c d e Hc Hd Ce De. apply H; trivial.
  rewrite <- (lemma_1 a b Ha Hb c _ _ Ce (flip_defect_on_C c Hc)). exact (lemma_1 a b Ha Hb d _ _ De (flip_defect_on_C d Hd)).
- intros c d Hc Hd E. apply (H c d (flip_defect c)); trivial; [now apply flip_defect_on_C|]. rewrite E. now apply flip_defect_on_C.
Qed.
(** Proposition 4: epsilon (c) is not injective if and only if C has a point (c*, pi/2) with -b < c* < 0. *)
Theorem proposition_4 : not_injective <-> exists cs, -b < cs < 0 /\ C cs (PI/2).
Proof. rewrite not_injective_iff. rewrite <- (lemma_3_crossing a b Ha Hb). reflexivity. Qed.
End Theorem3.
