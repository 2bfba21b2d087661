(** A checker of certificates of beta, by rounded steps of the arithmetic-geometric mean in integers: it multiplies, adds and
    compares, and takes no root.

    With a scale S, the certificate that n/S is below beta is a list of pairs of integers that starts with a pair A, B of
    A^2 >= (S+n) S, B^2 >= n S, each next one A', B' of 2A' >= A+B, B'^2 >= A B, the last with 2A < S, 2B < S; that it is
    above beta, the same with all signs turned. A certificate is made by `polhode certify beta`; how, is of no matter here.

    The integers are of any type with these operations: Z, or BigZ, which is fast but rests on the axioms of
    the machine's 63-bit integers. *)
Require Import Reals Lra Psatz List ZArith Bool.
From Bignums Require Import BigZ.
From Coquelicot Require Import Coquelicot.
From Polhode Require Import GaussIntegral AgmLimit Beta.
Import ListNotations.
Open Scope R_scope.

Section Checker.
Variable T : Type.
Variable value : T -> Z.
Variables zero two : T.
Variables add mul : T -> T -> T.
Variables leb ltb : T -> T -> bool.
Hypothesis value_zero : value zero = 0%Z.
Hypothesis value_two : value two = 2%Z.
Hypothesis value_add : forall x y, value (add x y) = (value x + value y)%Z.
Hypothesis value_mul : forall x y, value (mul x y) = (value x * value y)%Z.
Hypothesis value_leb : forall x y, leb x y = (value x <=? value y)%Z.
Hypothesis value_ltb : forall x y, ltb x y = (value x <? value y)%Z.

Definition pos (x : T) : bool := ltb zero x.
Definition double (x : T) : T := mul two x.

Fixpoint steps_up (S A B : T) (l : list (T*T)) : bool :=
 match l with
 | [] => ltb (double A) S && ltb (double B) S
 | (A',B')::l => pos A' && pos B' && leb (add A B) (double A') && leb (mul A B) (mul B' B') && steps_up S A' B' l
 end.
Fixpoint steps_down (S A B : T) (l : list (T*T)) : bool :=
 match l with
 | [] => ltb S (double A) && ltb S (double B)
 | (A',B')::l => pos A' && pos B' && leb (double A') (add A B) && leb (mul B' B') (mul A B) && steps_down S A' B' l
 end.
Definition is_below_beta (S nb A0 B0 : T) l : bool :=
 pos S && pos nb && pos A0 && pos B0 && leb (mul (add S nb) S) (mul A0 A0) && leb (mul nb S) (mul B0 B0) && steps_up S A0 B0 l.
Definition is_above_beta (S nb A0 B0 : T) l : bool :=
 pos S && pos nb && pos A0 && pos B0 && leb (mul A0 A0) (mul (add S nb) S) && leb (mul B0 B0) (mul nb S) && steps_down S A0 B0 l.

Definition in_R (x : T) : R := IZR (value x).

Lemma in_R_add x y : in_R (add x y) = in_R x + in_R y.
Proof. unfold in_R. now rewrite value_add, plus_IZR. Qed.
Lemma in_R_mul x y : in_R (mul x y) = in_R x * in_R y.
Proof. unfold in_R. now rewrite value_mul, mult_IZR. Qed.
Lemma in_R_leb x y : leb x y = true -> in_R x <= in_R y.
Proof. unfold in_R. rewrite value_leb. intros H. apply IZR_le. now apply Z.leb_le. Qed.
Lemma in_R_ltb x y : ltb x y = true -> in_R x < in_R y.
Proof. unfold in_R. rewrite value_ltb. intros H. apply IZR_lt. now apply Z.ltb_lt. Qed.
Lemma in_R_pos x : pos x = true -> 0 < in_R x.
Proof. intros H. apply in_R_ltb in H. unfold in_R at 1 in H. now rewrite value_zero in H. Qed.
Lemma in_R_double x : in_R (double x) = 2 * in_R x.
Proof. unfold double. rewrite in_R_mul. unfold in_R at 1. now rewrite value_two. Qed.

Lemma steps_up_sound S l : 0 < in_R S -> forall A B, 0 < in_R A -> 0 < in_R B ->
  steps_up S A B l = true -> PI < gauss_integral (in_R A / in_R S) (in_R B / in_R S).
Proof.
intros HS. assert (HPI := PI_RGT_0).
assert (Hd : forall x, 0 < x -> 0 < x / in_R S) by (intros; now apply Rdiv_lt_0_compat).
induction l as [|[A' B'] l IH]; intros A B HA HB; cbn [steps_up]; rewrite ?andb_true_iff.
- intros [H1 H2]. apply in_R_ltb in H1, H2. rewrite in_R_double in H1, H2.
  set (c := Rmax (in_R A / in_R S) (in_R B / in_R S)).
  assert (Hc : c < 1/2).
  { apply Rmax_lub_lt; apply (Rmult_lt_reg_r (in_R S)); trivial; unfold Rdiv at 1;
    rewrite Rmult_assoc, Rinv_l by lra; lra. }
  assert (0 < c) by (eapply Rlt_le_trans; [apply (Hd _ HA)|apply Rmax_l]).
  apply Rlt_le_trans with (PI/2/c).
  + apply (Rmult_lt_reg_r c); trivial. replace (PI/2/c*c) with (PI*(1/2)) by (field; lra).
    apply Rmult_lt_compat_l; lra.
  + apply gauss_integral_ge; [apply Hd|apply Hd|apply Rmax_l|apply Rmax_r]; trivial.
- intros [[[[H1 H2] H3] H4] H5].
  apply in_R_pos in H1, H2. apply in_R_leb in H3, H4.
  rewrite in_R_add, in_R_double in H3. rewrite !in_R_mul in H4.
  apply Rlt_le_trans with (gauss_integral (in_R A' / in_R S) (in_R B' / in_R S)).
  { now apply IH. }
  assert (Hi : 0 < / in_R S) by now apply Rinv_0_lt_compat.
  apply (agm_step_ge (in_R A / in_R S) (in_R B / in_R S) (in_R A' / in_R S) (in_R B' / in_R S)); try (now apply Hd); try lra.
  + apply (Rmult_le_compat_r (/ in_R S)) in H3; [|lra]. unfold Rdiv. lra.
  + apply (Rmult_le_compat_r (/ in_R S * / in_R S)) in H4; [|nra]. unfold Rdiv. lra.
Qed.

Lemma steps_down_sound S l : 0 < in_R S -> forall A B, 0 < in_R A -> 0 < in_R B ->
  steps_down S A B l = true -> gauss_integral (in_R A / in_R S) (in_R B / in_R S) < PI.
Proof.
intros HS. assert (HPI := PI_RGT_0).
assert (Hd : forall x, 0 < x -> 0 < x / in_R S) by (intros; now apply Rdiv_lt_0_compat).
induction l as [|[A' B'] l IH]; intros A B HA HB; cbn [steps_down]; rewrite ?andb_true_iff.
- intros [H1 H2]. apply in_R_ltb in H1, H2. rewrite in_R_double in H1, H2.
  set (c := Rmin (in_R A / in_R S) (in_R B / in_R S)).
  assert (Hc : 1/2 < c).
  { apply Rmin_glb_lt; apply (Rmult_lt_reg_r (in_R S)); trivial; unfold Rdiv at 2;
    rewrite Rmult_assoc, Rinv_l by lra; lra. }
  apply Rle_lt_trans with (PI/2/c).
  + apply gauss_integral_le; [lra|apply Rmin_l|apply Rmin_r].
  + apply (Rmult_lt_reg_r c); try lra. replace (PI/2/c*c) with (PI*(1/2)) by (field; lra).
    apply Rmult_lt_compat_l; lra.
- intros [[[[H1 H2] H3] H4] H5].
  apply in_R_pos in H1, H2. apply in_R_leb in H3, H4.
  rewrite in_R_add, in_R_double in H3. rewrite !in_R_mul in H4.
  apply Rle_lt_trans with (gauss_integral (in_R A' / in_R S) (in_R B' / in_R S)).
  2:{ now apply IH. }
  assert (Hi : 0 < / in_R S) by now apply Rinv_0_lt_compat.
  apply (agm_step_le (in_R A / in_R S) (in_R B / in_R S) (in_R A' / in_R S) (in_R B' / in_R S)); try (now apply Hd); try lra.
  + apply (Rmult_le_compat_r (/ in_R S)) in H3; [|lra]. unfold Rdiv. lra.
  + apply (Rmult_le_compat_r (/ in_R S * / in_R S)) in H4; [|nra]. unfold Rdiv. lra.
Qed.

Lemma is_below_beta_sound S nb A0 B0 l : is_below_beta S nb A0 B0 l = true -> PI < G (in_R nb / in_R S).
Proof.
unfold is_below_beta. rewrite !andb_true_iff. intros [[[[[[H1 H2] H3] H4] H5] H6] H7].
apply in_R_pos in H1, H2, H3, H4. apply in_R_leb in H5, H6. rewrite !in_R_mul in H5, H6. rewrite in_R_add in H5.
assert (Hd : forall x, 0 < x -> 0 < x / in_R S) by (intros; now apply Rdiv_lt_0_compat).
assert (Hb := Hd _ H2). 
apply Rlt_le_trans with (gauss_integral (in_R A0 / in_R S) (in_R B0 / in_R S)).
- now apply (steps_up_sound S l).
- rewrite G_gauss_integral by exact Hb. assert (Hi : 0 < / in_R S) by now apply Rinv_0_lt_compat. apply gauss_integral_decreasing.
  + apply sqrt_lt_R0; lra.
  + apply sqrt_lt_R0; lra.
  + rewrite <- (sqrt_square (in_R A0 / in_R S)) by (left; now apply Hd). apply sqrt_le_1_alt.
    apply (Rmult_le_compat_r (/ in_R S * / in_R S)) in H5; [|nra]. 
    replace (1 + in_R nb / in_R S) with ((in_R S + in_R nb) * in_R S * (/ in_R S * / in_R S)) by (field; lra).
    unfold Rdiv. lra.
  + rewrite <- (sqrt_square (in_R B0 / in_R S)) by (left; now apply Hd). apply sqrt_le_1_alt.
    apply (Rmult_le_compat_r (/ in_R S * / in_R S)) in H6; [|nra]. 
    replace (in_R nb / in_R S) with (in_R nb * in_R S * (/ in_R S * / in_R S)) by (field; lra).
    unfold Rdiv. lra.
Qed.

Lemma is_above_beta_sound S nb A0 B0 l : is_above_beta S nb A0 B0 l = true -> G (in_R nb / in_R S) < PI.
Proof.
unfold is_above_beta. rewrite !andb_true_iff. intros [[[[[[H1 H2] H3] H4] H5] H6] H7].
apply in_R_pos in H1, H2, H3, H4. apply in_R_leb in H5, H6. rewrite !in_R_mul in H5, H6. rewrite in_R_add in H5.
assert (Hd : forall x, 0 < x -> 0 < x / in_R S) by (intros; now apply Rdiv_lt_0_compat).
assert (Hb := Hd _ H2). 
apply Rle_lt_trans with (gauss_integral (in_R A0 / in_R S) (in_R B0 / in_R S)).
2: now apply (steps_down_sound S l).
rewrite G_gauss_integral by exact Hb. assert (Hi : 0 < / in_R S) by now apply Rinv_0_lt_compat. apply gauss_integral_decreasing.
  + now apply Hd.
  + now apply Hd.
  + rewrite <- (sqrt_square (in_R A0 / in_R S)) by (left; now apply Hd). apply sqrt_le_1_alt.
    apply (Rmult_le_compat_r (/ in_R S * / in_R S)) in H5; [|nra]. 
    replace (1 + in_R nb / in_R S) with ((in_R S + in_R nb) * in_R S * (/ in_R S * / in_R S)) by (field; lra).
    unfold Rdiv. lra.
  + rewrite <- (sqrt_square (in_R B0 / in_R S)) by (left; now apply Hd). apply sqrt_le_1_alt.
    apply (Rmult_le_compat_r (/ in_R S * / in_R S)) in H6; [|nra]. 
    replace (in_R nb / in_R S) with (in_R nb * in_R S * (/ in_R S * / in_R S)) by (field; lra).
    unfold Rdiv. lra.
Qed.

(** What is claimed: N/D <= beta <= M/D; what is checked: the certificates of lo/S and hi/S, and that N/D and M/D are not between. *)
Record certificate := {
  scale : T;
  below : T; below_start : T * T; below_steps : list (T*T);
  above : T; above_start : T * T; above_steps : list (T*T);
  least : T; greatest : T; unit : T }.

Definition is_valid (c : certificate) : bool :=
  is_below_beta (scale c) (below c) (fst (below_start c)) (snd (below_start c)) (below_steps c) &&
  is_above_beta (scale c) (above c) (fst (above_start c)) (snd (above_start c)) (above_steps c) &&
  ltb (below c) (above c) && pos (unit c) &&
  leb (mul (least c) (scale c)) (mul (below c) (unit c)) &&
  leb (mul (above c) (unit c)) (mul (greatest c) (scale c)).

Theorem certificate_sound c : is_valid c = true -> exists beta : R,
  (in_R (least c) / in_R (unit c) <= beta <= in_R (greatest c) / in_R (unit c)) /\
  0 < beta /\
  RInt (fun t => 1 / sqrt (1 - 1/(1+beta) * sin t ^2)) 0 (PI/2) = PI * sqrt (1+beta) /\
  is_lim_seq (fun n => fst (agm n (sqrt (1+beta)) (sqrt beta))) (1/2) /\
  forall c, 0 < c -> RInt (fun t => 1 / sqrt (1 - 1/(1+c) * sin t ^2)) 0 (PI/2) = PI * sqrt (1+c) -> c = beta.
Proof.
unfold is_valid. rewrite !andb_true_iff. intros [[[[[H1 H2] H3] H4] H5] H6].
assert (HS : 0 < in_R (scale c) /\ 0 < in_R (below c)).
{ unfold is_below_beta in H1. rewrite !andb_true_iff in H1. split; apply in_R_pos; tauto. }
destruct HS as [HS Hl].
apply is_below_beta_sound in H1. apply is_above_beta_sound in H2. apply in_R_ltb in H3.
apply in_R_pos in H4. apply in_R_leb in H5, H6. rewrite !in_R_mul in H5, H6.
assert (P : 0 < in_R (below c) / in_R (scale c)) by now apply Rdiv_lt_0_compat.
destruct (beta_exists_unique (in_R (below c) / in_R (scale c)) (in_R (above c) / in_R (scale c))) as [b [[[B1 B2] E] U]]; trivial.
{ apply Rmult_lt_compat_r; [now apply Rinv_0_lt_compat|trivial]. }
exists b. assert (0 < b) by lra.
split; [split|split; [trivial|split; [exact E|split; [now apply (proj2 (beta_agm b H))|exact U]]]].
- apply Rle_trans with (in_R (below c) / in_R (scale c)); [|lra].
  apply (Rmult_le_reg_r (in_R (unit c) * in_R (scale c))); [now apply Rmult_lt_0_compat|].
  replace (in_R (least c) / in_R (unit c) * (in_R (unit c) * in_R (scale c))) with (in_R (least c) * in_R (scale c)) by (field; lra).
  replace (in_R (below c) / in_R (scale c) * (in_R (unit c) * in_R (scale c))) with (in_R (below c) * in_R (unit c)) by (field; lra).
  exact H5.
- apply Rle_trans with (in_R (above c) / in_R (scale c)); [lra|].
  apply (Rmult_le_reg_r (in_R (unit c) * in_R (scale c))); [now apply Rmult_lt_0_compat|].
  replace (in_R (greatest c) / in_R (unit c) * (in_R (unit c) * in_R (scale c))) with (in_R (greatest c) * in_R (scale c)) by (field; lra).
  replace (in_R (above c) / in_R (scale c) * (in_R (unit c) * in_R (scale c))) with (in_R (above c) * in_R (unit c)) by (field; lra).
  exact H6.
Qed.
End Checker.

Definition is_valid_Z := is_valid Z 0%Z 2%Z Z.add Z.mul Z.leb Z.ltb.
Definition certificate_sound_Z := certificate_sound Z (fun z => z) 0%Z 2%Z Z.add Z.mul Z.leb Z.ltb
  eq_refl eq_refl (fun _ _ => eq_refl) (fun _ _ => eq_refl) (fun _ _ => eq_refl) (fun _ _ => eq_refl).

Definition is_valid_BigZ := is_valid BigZ.t 0%bigZ 2%bigZ BigZ.add BigZ.mul BigZ.leb BigZ.ltb.
Definition certificate_sound_BigZ := certificate_sound BigZ.t BigZ.to_Z 0%bigZ 2%bigZ BigZ.add BigZ.mul BigZ.leb BigZ.ltb
  eq_refl eq_refl BigZ.spec_add BigZ.spec_mul BigZ.spec_leb BigZ.spec_ltb.
