(** Whether the complete elliptic integral of the third kind is above or below (p/q) pi, decided by
    integers: steps of ThirdKind.third_kind_step, rounded to the safe side, with the scale S for x
    and y. The weight is homogeneous and needs no scale. *)
Require Import Reals Lra Psatz ZArith Bool.
From Coquelicot Require Import Coquelicot.
From Polhode Require Import GaussIntegral ThirdKind.
Open Scope R_scope.

Definition ceiling_div (n d : Z) : Z := (- (- n / d))%Z.

Definition are_positive (x y C D : Z) : bool :=
  (0 <? x)%Z && (0 <? y)%Z && (0 <? C)%Z && (0 <? D)%Z.

Fixpoint is_above (n : nat) (S x y A B C D p q : Z) : bool :=
  are_positive x y C D && (0 <=? A)%Z && (0 <=? B)%Z &&
  match n with
  | O => let z := Z.max x y in (2*p*z*C <? q*S*A)%Z && (2*p*z*D <? q*S*B)%Z
  | S n => is_above n S (ceiling_div (x + y) 2) (Z.sqrt_up (x*y))
      ((A*D + B*C)*(x+y) / (2*(C*y + D*x))) ((A*y + B*x) / (x+y))
      (ceiling_div (C*D*(x+y)) (C*y + D*x)) (ceiling_div (C*y + D*x) (x+y)) p q
  end.
Fixpoint is_below (n : nat) (S x y A B C D p q : Z) : bool :=
  are_positive x y C D && (0 <=? A)%Z && (0 <=? B)%Z &&
  match n with
  | O => let z := Z.min x y in (q*S*A <? 2*p*z*C)%Z && (q*S*B <? 2*p*z*D)%Z
  | S n => is_below n S ((x + y) / 2) (Z.sqrt (x*y))
      (ceiling_div ((A*D + B*C)*(x+y)) (2*(C*y + D*x))) (ceiling_div (A*y + B*x) (x+y))
      (C*D*(x+y) / (C*y + D*x)) ((C*y + D*x) / (x+y)) p q
  end.

Lemma floor_le n d : (0 < d)%Z -> IZR (n / d) <= IZR n / IZR d.
Proof.
intros Hd. assert (L := Z.mul_div_le n d Hd). apply IZR_le in L. rewrite mult_IZR in L.
apply IZR_lt in Hd.
apply (Rmult_le_reg_r (IZR d)); trivial. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra.
Qed.
Lemma ceiling_ge n d : (0 < d)%Z -> IZR n / IZR d <= IZR (ceiling_div n d).
Proof.
intros Hd. assert (L := floor_le (- n) d Hd). unfold ceiling_div. rewrite opp_IZR.
rewrite opp_IZR in L. unfold Rdiv in *. lra.
Qed.
Lemma sqrt_floor n : (0 <= n)%Z -> IZR (Z.sqrt n) <= sqrt (IZR n).
Proof.
intros Hn. assert (H := Z.sqrt_spec n Hn). assert (P := Z.sqrt_nonneg n). destruct H as [H _].
apply IZR_le in H, P. rewrite mult_IZR in H.
rewrite <- (sqrt_square (IZR (Z.sqrt n))) by exact P. now apply sqrt_le_1_alt.
Qed.
Lemma sqrt_ceiling n : (0 < n)%Z -> sqrt (IZR n) <= IZR (Z.sqrt_up n).
Proof.
intros Hn. assert (H := Z.sqrt_up_spec n Hn). assert (P := Z.sqrt_up_nonneg n). destruct H as [_ H].
apply IZR_le in H, P. rewrite mult_IZR in H.
rewrite <- (sqrt_square (IZR (Z.sqrt_up n))) by exact P. now apply sqrt_le_1_alt.
Qed.

Lemma are_positive_spec x y C D :
  are_positive x y C D = true -> (0 < x /\ 0 < y /\ 0 < C /\ 0 < D)%Z.
Proof. unfold are_positive. rewrite !andb_true_iff, !Z.ltb_lt. tauto. Qed.

(** The next weight and the next x and y, exactly, with the scale taken out *)
Lemma scaled_step S x y A B C D : (0 < S)%Z -> (0 < x)%Z -> (0 < y)%Z -> (0 < C)%Z -> (0 < D)%Z ->
  third_kind (IZR x / IZR S) (IZR y / IZR S) (IZR A) (IZR B) (IZR C) (IZR D) =
  third_kind (IZR (x + y) / 2 / IZR S) (sqrt (IZR (x*y)) / IZR S) (IZR ((A*D + B*C)*(x+y)) / IZR
    (2*(C*y + D*x)))
    (IZR (A*y + B*x) / IZR (x+y)) (IZR (C*D*(x+y)) / IZR (C*y + D*x)) (IZR (C*y + D*x) / IZR (x+y)).
Proof.
intros HS Hx Hy HC HD. apply IZR_lt in HS, Hx, Hy, HC, HD.
rewrite third_kind_step; trivial; try (now apply Rdiv_lt_0_compat).
assert (P1 : 0 < IZR C * IZR y + IZR D * IZR x) by (apply Rplus_lt_0_compat; now apply
  Rmult_lt_0_compat).
repeat rewrite ?plus_IZR, ?mult_IZR. set (X := IZR x) in *. set (Y := IZR y) in *.
set (s := IZR S) in *.
assert (E : sqrt (X / s * (Y / s)) = sqrt (X*Y) / s).
{ replace (X/s*(Y/s)) with (X*Y/s^2) by (field; lra). rewrite sqrt_div_alt by (apply pow_lt; lra).
rewrite sqrt_pow2 by lra. reflexivity. }
rewrite E. f_equal; field; repeat split; try lra.
Qed.

Lemma quotients_lt a b c d : 0 < b -> 0 < d -> a*d < c*b -> a/b < c/d.
Proof.
intros Hb Hd H. apply (Rmult_lt_reg_r (b*d)). now apply Rmult_lt_0_compat.
replace (a/b*(b*d)) with (a*d) by (field; lra). replace (c/d*(b*d)) with (c*b) by (field; lra).
exact H.
Qed.

Section Soundness.
Variables S p q : Z.
Hypothesis HS : (0 < S)%Z.
Hypothesis Hp : (0 < p)%Z.
Hypothesis Hq : (0 < q)%Z.

Let over k := IZR k / IZR S.

Lemma over_le x y : x <= y -> x / IZR S <= y / IZR S.
Proof. intros H. apply Rmult_le_compat_r; trivial. apply Rlt_le, Rinv_0_lt_compat. now apply IZR_lt.
Qed.
Lemma over_pos x : 0 < x -> 0 < x / IZR S.
Proof. intros H. apply Rdiv_lt_0_compat; trivial. now apply IZR_lt. Qed.

Theorem is_above_sound n : forall x y A B C D, is_above n S x y A B C D p q = true ->
  IZR p / IZR q * PI < third_kind (over x) (over y) (IZR A) (IZR B) (IZR C) (IZR D).
Proof.
assert (Pi := PI_RGT_0). assert (RS := IZR_lt _ _ HS). assert (Rp := IZR_lt _ _ Hp).
assert (Rq := IZR_lt _ _ Hq).
induction n as [|n IH]; intros x y A B C D; cbn [is_above]; rewrite !andb_true_iff, !Z.leb_le.
- rewrite !Z.ltb_lt. intros [[[P HA] HB] [L1 L2]]. apply are_positive_spec in P.
destruct P as [Hx [Hy [HC HD]]].
  set (z := Z.max x y) in *. assert (Zx : (x <= z)%Z) by apply Z.le_max_l.
  assert (Zy : (y <= z)%Z) by apply Z.le_max_r.
  assert (Hz : (0 < z)%Z) by (apply Z.lt_le_trans with x; trivial).
  apply IZR_le in HA, HB, Zx, Zy. apply IZR_lt in Hx, Hy, HC, HD, L1, L2, Hz.
  rewrite !mult_IZR in L1, L2.
  set (k := Rmin (IZR A / IZR C) (IZR B / IZR D)).
  assert (K : 2 * IZR p * IZR z / (IZR q * IZR S) < k).
  { assert (QS : 0 < IZR q * IZR S) by now apply Rmult_lt_0_compat.
    apply Rmin_glb_lt; apply quotients_lt; trivial; lra. }
  assert (K0 : 0 <= k). { apply Rlt_le, Rle_lt_trans with (2 := K). apply Rmult_le_pos.
  repeat apply Rmult_le_pos; lra. apply Rlt_le, Rinv_0_lt_compat. now apply Rmult_lt_0_compat. }
  apply Rlt_le_trans with (k * (PI/2/over z)).
  + replace (IZR p / IZR q * PI) with (2 * IZR p * IZR z / (IZR q * IZR S) * (PI/2/over z)) by
    (unfold over; field; lra).
    apply Rmult_lt_compat_r; trivial. apply Rdiv_lt_0_compat; [lra|]. now apply over_pos.
  + apply third_kind_ge; trivial.
    * split. now apply over_pos. now apply over_le.
    * split. now apply over_pos. now apply over_le.
    * apply Rle_trans with (IZR A / IZR C * IZR C). apply Rmult_le_compat_r; [lra|apply Rmin_l].
    right. field. lra.
    * apply Rle_trans with (IZR B / IZR D * IZR D). apply Rmult_le_compat_r; [lra|apply Rmin_r].
    right. field. lra.
- intros [[[P HA] HB] H]. apply are_positive_spec in P. destruct P as [Hx [Hy [HC HD]]].
  unfold over. rewrite scaled_step by trivial. apply IH in H. apply Rlt_le_trans with (1 := H).
  assert (N0 : (0 < x + y)%Z) by lia. assert (N1 : (0 < C*y + D*x)%Z) by nia.
  assert (N2 : (0 < x*y)%Z) by nia. assert (N3 : (0 < C*D*(x+y))%Z) by (apply Z.mul_pos_pos; nia).
  assert (N4 : (0 <= (A*D + B*C)*(x+y))%Z) by (apply Z.mul_nonneg_nonneg; nia).
  assert (N5 : (0 <= A*y + B*x)%Z) by nia.
  apply third_kind_monotone; unfold over; try split.
  + apply over_pos. apply Rdiv_lt_0_compat; [|lra]. now apply IZR_lt.
  + apply over_le. now apply ceiling_ge.
  + apply over_pos, sqrt_lt_R0. now apply IZR_lt.
  + apply over_le. now apply sqrt_ceiling.
  + apply IZR_le. apply Z.div_pos; lia.
  + apply floor_le. lia.
  + apply IZR_le. now apply Z.div_pos.
  + now apply floor_le.
  + apply Rdiv_lt_0_compat; now apply IZR_lt.
  + now apply ceiling_ge.
  + apply Rdiv_lt_0_compat; now apply IZR_lt.
  + now apply ceiling_ge.
Qed.

Theorem is_below_sound n : forall x y A B C D, is_below n S x y A B C D p q = true ->
  third_kind (over x) (over y) (IZR A) (IZR B) (IZR C) (IZR D) < IZR p / IZR q * PI.
Proof.
assert (Pi := PI_RGT_0). assert (RS := IZR_lt _ _ HS). assert (Rp := IZR_lt _ _ Hp).
assert (Rq := IZR_lt _ _ Hq).
assert (First : forall n x y A B C D, is_below n S x y A B C D p q = true -> (0 < x /\ 0 < y /\ 0 <
  C /\ 0 < D)%Z).
{ intros m x y A B C D H. destruct m; cbn [is_below] in H; rewrite !andb_true_iff in H; apply
  are_positive_spec; tauto. }
induction n as [|n IH]; intros x y A B C D; cbn [is_below]; rewrite !andb_true_iff, !Z.leb_le.
- rewrite !Z.ltb_lt. intros [[[P HA] HB] [L1 L2]]. apply are_positive_spec in P.
destruct P as [Hx [Hy [HC HD]]].
  set (z := Z.min x y) in *. assert (Zx : (z <= x)%Z) by apply Z.le_min_l.
  assert (Zy : (z <= y)%Z) by apply Z.le_min_r.
  assert (Hz : (0 < z)%Z) by (apply Z.min_glb_lt; trivial).
  apply IZR_le in HA, HB, Zx, Zy. apply IZR_lt in Hx, Hy, HC, HD, L1, L2, Hz.
  rewrite !mult_IZR in L1, L2.
  set (k := Rmax (IZR A / IZR C) (IZR B / IZR D)).
  assert (K : k < 2 * IZR p * IZR z / (IZR q * IZR S)).
  { assert (QS : 0 < IZR q * IZR S) by now apply Rmult_lt_0_compat.
    apply Rmax_lub_lt; apply quotients_lt; trivial; lra. }
  apply Rle_lt_trans with (k * (PI/2/over z)).
  + apply third_kind_le; trivial.
    * split. now apply over_pos. now apply over_le.
    * split. now apply over_pos. now apply over_le.
    * split; [exact HA|]. apply Rle_trans with (IZR A / IZR C * IZR C). right. field. lra.
    apply Rmult_le_compat_r; [lra|apply Rmax_l].
    * split; [exact HB|]. apply Rle_trans with (IZR B / IZR D * IZR D). right. field. lra.
    apply Rmult_le_compat_r; [lra|apply Rmax_r].
  + replace (IZR p / IZR q * PI) with (2 * IZR p * IZR z / (IZR q * IZR S) * (PI/2/over z)) by
    (unfold over; field; lra).
    apply Rmult_lt_compat_r; trivial. apply Rdiv_lt_0_compat; [lra|]. now apply over_pos.
- intros [[[P HA] HB] H]. apply are_positive_spec in P. destruct P as [Hx [Hy [HC HD]]].
  destruct (First _ _ _ _ _ _ _ H) as [Hx' [Hy' [HC' HD']]].
  unfold over. rewrite scaled_step by trivial. apply IH in H. apply Rle_lt_trans with (2 := H).
  assert (N0 : (0 < x + y)%Z) by lia. assert (N1 : (0 < C*y + D*x)%Z) by nia.
  assert (N2 : (0 < x*y)%Z) by nia. assert (N3 : (0 < C*D*(x+y))%Z) by (apply Z.mul_pos_pos; nia).
  assert (N4 : (0 <= (A*D + B*C)*(x+y))%Z) by (apply Z.mul_nonneg_nonneg; nia).
  assert (N5 : (0 <= A*y + B*x)%Z) by nia.
  apply third_kind_monotone; unfold over; try split.
  + apply over_pos. now apply IZR_lt.
  + apply over_le. now apply floor_le.
  + apply over_pos. now apply IZR_lt.
  + apply over_le. apply sqrt_floor. lia.
  + apply Rmult_le_pos. now apply IZR_le. apply Rlt_le, Rinv_0_lt_compat, IZR_lt. lia.
  + apply ceiling_ge. lia.
  + apply Rmult_le_pos. now apply IZR_le. apply Rlt_le, Rinv_0_lt_compat. now apply IZR_lt.
  + now apply ceiling_ge.
  + now apply IZR_lt.
  + now apply floor_le.
  + now apply IZR_lt.
  + now apply floor_le.
Qed.
End Soundness.

(** The product of two quadratic forms under the root: the angle of tangent m tan t, m^2 = V/T,
  makes one of it. *)
Lemma third_kind_of_product P Q V T A B C D : 0 < P -> 0 < Q -> 0 < V -> 0 < T -> 0 < C -> 0 < D ->
  RInt (fun t => weight A B C D t / sqrt ((P * cos t^2 + Q * sin t^2) * (V * cos t^2 + T * sin
    t^2))) 0 (PI/2) =
  third_kind (sqrt (T*P)) (sqrt (Q*V)) (A*T) (B*V) (C*T) (D*V).
Proof.
intros HP HQ HV HT HC HD.
assert (M : 0 < V/T) by now apply Rdiv_lt_0_compat. assert (m := sqrt_lt_R0 _ M).
assert (M2 := pow2_sqrt _ (Rlt_le _ _ M)). set (r := sqrt (V/T)) in *.
rewrite (stretch_substitution _ r m).
2:{ intros t. apply (continuous_mult (weight A B C D) (fun t => / sqrt ((P * cos t^2 + Q * sin t^2)
  * (V * cos t^2 + T * sin t^2)))).
    - now apply weight_continuous.
    - assert (F := form_pos P Q t HP HQ). assert (F' := form_pos V T t HV HT).
    assert (FF := Rmult_lt_0_compat _ _ F F'). assert (SF := sqrt_lt_R0 _ FF).
      apply (ex_derive_continuous (fun t => / sqrt ((P * cos t^2 + Q * sin t^2) * (V * cos t^2 + T *
        sin t^2)))). auto_derive. simpl in FF, SF. repeat split; lra. }
apply RInt_ext. intros t _.
destruct (squares_at_stretched r t m) as [Q1 Q2].
assert (F := form_pos 1 (r^2) t ltac:(lra) ltac:(now apply pow_lt)). rewrite Rmult_1_l in F.
assert (F2 := form_pos (T*P) (Q*V) t ltac:(now apply Rmult_lt_0_compat) ltac:(now apply
  Rmult_lt_0_compat)). assert (S2 := sqrt_lt_R0 _ F2).
assert (F3 := form_pos (C*T) (D*V) t ltac:(now apply Rmult_lt_0_compat) ltac:(now apply
  Rmult_lt_0_compat)).
unfold integrand, radicand, weight, stretch_rate.
rewrite !Rpow_mult_distr, Q1, Q2, !pow2_sqrt by (apply Rmult_le_pos; lra).
set (n := cos t^2 + r^2 * sin t^2) in *.
assert (U : sin t^2 + cos t^2 = 1) by (generalize (sin2_cos2 t); unfold Rsqr; simpl; lra).
assert (En : n = (T * cos t^2 + V * sin t^2) / T) by (unfold n; rewrite M2; field; lra).
assert (FT : 0 < T * cos t^2 + V * sin t^2) by (apply form_pos; trivial).
assert (E : (P * (cos t^2 / n) + Q * (r^2 * sin t^2 / n)) * (V * (cos t^2 / n) + T * (r^2 * sin t^2
  / n)) =
  r^2 * (T*P * cos t^2 + Q*V * sin t^2) / n^2).
{ rewrite M2. replace (r^2 * (T * P * cos t^2 + Q * V * sin t^2)) with (V/T*(T * P * cos t^2 + Q * V
  * sin t^2)) by (now rewrite M2).
  transitivity (V * (P * cos t^2 + Q * (V/T * sin t^2)) * (sin t^2 + cos t^2) / n^2); [field; lra|].
  rewrite U. field. lra. }
rewrite E. rewrite sqrt_div_alt, sqrt_mult_alt, !sqrt_pow2 by first [apply pow_lt; lra | apply
  pow2_ge_0 | lra].
match goal with |- @eq _ ?l ?r => change (@eq R l r) end.
rewrite over_common_denominator.
- replace (C * cos t^2 + D * (r^2 * sin t^2)) with ((C*T * cos t^2 + D*V * sin t^2)/T) by (rewrite
  M2; field; lra).
  replace (A * cos t^2 + B * (r^2 * sin t^2)) with ((A*T * cos t^2 + B*V * sin t^2)/T) by (rewrite
    M2; field; lra).
  field. repeat split; lra.
- lra.
- replace (C * cos t^2 + D * (r^2 * sin t^2)) with ((C*T * cos t^2 + D*V * sin t^2)/T) by (rewrite
  M2; field; lra).
  apply Rgt_not_eq. now apply Rdiv_lt_0_compat.
Qed.
