(** The hypotheses of Brackets.twist_between and Brackets.meeting_between by integers: both phases
    are complete elliptic integrals of the third kind, which ThirdKindBounds.v compares with a
    multiple of pi. The body's parameters and the point are na/N, nb/N and nc/N or nu/N. The scale s
    and the number n of steps may be any: they decide only whether the test succeeds. *)
Require Import Reals Lra Psatz ZArith Bool.
From Coquelicot Require Import Coquelicot.
From Polhode Require HalfPhase.
From Polhode Require Import GaussIntegral ThirdKind ThirdKindBounds Brackets.
Open Scope R_scope.

(** Started with the roots of z and w over N^2 and a weight of integers, all over C *)
Definition starts_above (n : nat) (s N z w A B C D p q : Z) : bool :=
  (0 <? s)%Z && (0 <? N)%Z && (0 <? z)%Z && (0 <? w)%Z && (0 <? C)%Z && (0 <? D)%Z && (0 <=? A)%Z &&
    (0 <=? B)%Z && (0 <? p)%Z && (0 <? q)%Z &&
  is_above n s (Z.sqrt_up (ceiling_div (s*s*z) (N*N))) (Z.sqrt_up (ceiling_div (s*s*w) (N*N)))
    (s*A / C) (s*B / C) s (ceiling_div (s*D) C) p q.
Definition starts_below (n : nat) (s N z w A B C D p q : Z) : bool :=
  (0 <? s)%Z && (0 <? N)%Z && (0 <? z)%Z && (0 <? w)%Z && (0 <? C)%Z && (0 <? D)%Z && (0 <=? A)%Z &&
    (0 <=? B)%Z && (0 <? p)%Z && (0 <? q)%Z &&
  (0 <? s*s*z / (N*N))%Z && (0 <? s*s*w / (N*N))%Z && (0 <? s*D / C)%Z &&
  is_below n s (Z.sqrt (s*s*z / (N*N))) (Z.sqrt (s*s*w / (N*N))) (ceiling_div (s*A) C) (ceiling_div
    (s*B) C) s (s*D / C) p q.

Lemma root_over s v : (0 < s)%Z -> 0 <= v -> sqrt v = sqrt (IZR s * IZR s * v) / IZR s.
Proof.
intros Hs Hv. apply IZR_lt in Hs. rewrite sqrt_mult_alt, sqrt_square by first [apply Rmult_le_pos;
  lra | lra]. field. lra.
Qed.

Lemma third_kind_over x y A B C D s : (0 < s)%Z -> 0 < C -> 0 < D ->
  third_kind x y A B C D = third_kind x y (IZR s * A / C) (IZR s * B / C) (IZR s) (IZR s * D / C).
Proof.
intros Hs HC HD. apply IZR_lt in Hs. rewrite <- (third_kind_scale x y A B C D (IZR s / C)); trivial;
  [|now apply Rdiv_lt_0_compat].
f_equal; field; lra.
Qed.

Lemma starts_above_sound n s N z w A B C D p q : starts_above n s N z w A B C D p q = true ->
  IZR p / IZR q * PI < third_kind (sqrt (IZR z / IZR (N*N))) (sqrt (IZR w / IZR (N*N))) (IZR A) (IZR
    B) (IZR C) (IZR D).
Proof.
unfold starts_above. rewrite !andb_true_iff, !Z.ltb_lt, !Z.leb_le.
intros [[[[[[[[[[Hs HN] Hz] Hw] HC] HD] HA] HB] Hp] Hq] H].
assert (NN : (0 < N*N)%Z) by now apply Z.mul_pos_pos.
assert (ss : (0 < s*s)%Z) by now apply Z.mul_pos_pos.
apply is_above_sound in H; trivial. apply Rlt_le_trans with (1 := H).
assert (Rs := IZR_lt _ _ Hs). assert (RN := IZR_lt _ _ NN). assert (RC := IZR_lt _ _ HC).
assert (RD := IZR_lt _ _ HD).
rewrite (third_kind_over _ _ (IZR A) (IZR B) (IZR C) (IZR D) s Hs RC RD). rewrite <- !mult_IZR.
assert (Q : forall v, (0 < v)%Z -> 0 < sqrt (IZR v / IZR (N*N)) <= IZR (Z.sqrt_up (ceiling_div
  (s*s*v) (N*N))) / IZR s).
{ intros v Hv. assert (SV : (0 < s*s*v)%Z) by now apply Z.mul_pos_pos. assert (RV := IZR_lt _ _ Hv).
  assert (P : 0 < IZR v / IZR (N*N)) by now apply Rdiv_lt_0_compat.
  assert (L := ceiling_ge (s*s*v) _ NN).
  split; [now apply sqrt_lt_R0|]. rewrite (root_over s) by (trivial; lra).
  apply Rmult_le_compat_r. now apply Rlt_le, Rinv_0_lt_compat.
  replace (IZR s * IZR s * (IZR v / IZR (N*N))) with (IZR (s*s*v) / IZR (N*N)) by (rewrite (mult_IZR
    (s*s) v), (mult_IZR s s); field; lra).
  apply Rle_trans with (1 := sqrt_le_1_alt _ _ L). apply sqrt_ceiling.
  apply lt_IZR. apply Rlt_le_trans with (2 := L). apply Rdiv_lt_0_compat; trivial. now apply IZR_lt.
  }
assert (F := fun v => floor_le (s*v) C HC).
assert (PD : 0 < IZR (s*D) / IZR C) by (apply Rdiv_lt_0_compat; trivial; apply IZR_lt; now apply
  Z.mul_pos_pos).
apply third_kind_monotone; try (now apply Q); try lra.
- split; [|apply F]. apply IZR_le, Z.div_pos; trivial. apply Z.mul_nonneg_nonneg; lia.
- split; [|apply F]. apply IZR_le, Z.div_pos; trivial. apply Z.mul_nonneg_nonneg; lia.
- split; trivial. now apply ceiling_ge.
Qed.

Lemma starts_below_sound n s N z w A B C D p q : starts_below n s N z w A B C D p q = true ->
  third_kind (sqrt (IZR z / IZR (N*N))) (sqrt (IZR w / IZR (N*N))) (IZR A) (IZR B) (IZR C) (IZR D) <
    IZR p / IZR q * PI.
Proof.
unfold starts_below. rewrite !andb_true_iff, !Z.ltb_lt, !Z.leb_le.
intros [[[[[[[[[[[[[Hs HN] Hz] Hw] HC] HD] HA] HB] Hp] Hq] Rz] Rw] RfD] H].
assert (NN : (0 < N*N)%Z) by now apply Z.mul_pos_pos.
assert (ss : (0 < s*s)%Z) by now apply Z.mul_pos_pos.
apply is_below_sound in H; trivial. apply Rle_lt_trans with (2 := H).
assert (Rs := IZR_lt _ _ Hs). assert (RN := IZR_lt _ _ NN). assert (RC := IZR_lt _ _ HC).
assert (RD := IZR_lt _ _ HD).
rewrite (third_kind_over _ _ (IZR A) (IZR B) (IZR C) (IZR D) s Hs RC RD). rewrite <- !mult_IZR.
assert (Q : forall v, (0 < v)%Z -> (0 < s*s*v / (N*N))%Z -> 0 < IZR (Z.sqrt (s*s*v / (N*N))) / IZR s
  <= sqrt (IZR v / IZR (N*N))).
{ intros v Hv Fv. assert (RV := IZR_lt _ _ Hv).
assert (P : 0 < IZR v / IZR (N*N)) by now apply Rdiv_lt_0_compat.
  assert (L := floor_le (s*s*v) _ NN). split.
  - apply Rdiv_lt_0_compat; trivial. apply IZR_lt. now apply Z.sqrt_pos.
  - rewrite (root_over s (IZR v / IZR (N*N))) by (trivial; lra). apply Rmult_le_compat_r.
  now apply Rlt_le, Rinv_0_lt_compat.
    replace (IZR s * IZR s * (IZR v / IZR (N*N))) with (IZR (s*s*v) / IZR (N*N)) by (rewrite
      (mult_IZR (s*s) v), (mult_IZR s s); field; lra).
    apply Rle_trans with (2 := sqrt_le_1_alt _ _ L). apply sqrt_floor. lia. }
assert (PA : forall v, (0 <= v)%Z -> 0 <= IZR (s*v) / IZR C).
{ intros v Hv. apply Rmult_le_pos; [|now apply Rlt_le, Rinv_0_lt_compat].
apply IZR_le, Z.mul_nonneg_nonneg; lia. }
apply third_kind_monotone; try (now apply Q); try lra.
- split; [now apply PA|now apply ceiling_ge].
- split; [now apply PA|now apply ceiling_ge].
- split; [now apply IZR_lt|now apply floor_le].
Qed.

(** The phase of rotating motions *)
Lemma rotating_phase_third_kind a b c : 0 < a -> 0 < b -> 0 < c ->
  rotating_phase a b c = 2 * third_kind (sqrt (c*(a + b))) (sqrt (a*(c + b))) ((1 - b)*c) (1*(c +
    b)) (1*c) (1*(c + b)).
Proof.
intros Ha Hb Hc. unfold rotating_phase. rewrite <- third_kind_of_product by lra. f_equal.
apply RInt_ext. intros t _.
assert (E : sin t^2 + cos t^2 = 1) by (generalize (sin2_cos2 t); unfold Rsqr; simpl; lra).
assert (E2 : sin t^2 = 1 - cos t^2) by lra. unfold weight. rewrite !E2.
match goal with |- @eq _ ?l ?r => change (@eq R l r) end.
unfold Rdiv. f_equal; [|f_equal; f_equal; ring].
replace (1 * cos t^2 + 1 * (1 - cos t^2)) with 1 by ring. rewrite Rinv_1. ring.
Qed.

Definition twist_test (test : nat -> Z -> Z -> Z -> Z -> Z -> Z -> Z -> Z -> Z -> Z -> bool) (n :
  nat) (s N na nb nc : Z) : bool :=
  (0 <? na)%Z && (0 <? nb)%Z && (0 <? nc)%Z && (0 <? N)%Z &&
  test n s N (nc*(na + nb))%Z (na*(nc + nb))%Z ((N - nb)*nc)%Z (N*(nc + nb))%Z (N*nc)%Z (N*(nc +
    nb))%Z 1%Z 1%Z.

Lemma twist_in_integers N na nb nc : (0 < na)%Z -> (0 < nb)%Z -> (0 < nc)%Z -> (0 < N)%Z ->
  rotating_phase (IZR na / IZR N) (IZR nb / IZR N) (IZR nc / IZR N) = 2 * third_kind (sqrt (IZR
    (nc*(na + nb)) / IZR (N*N))) (sqrt (IZR (na*(nc + nb)) / IZR (N*N)))
    (IZR ((N - nb)*nc)) (IZR (N*(nc + nb))) (IZR (N*nc)) (IZR (N*(nc + nb))).
Proof.
intros Ha Hb Hc HN. apply IZR_lt in Ha, Hb, Hc, HN.
rewrite rotating_phase_third_kind by now apply Rdiv_lt_0_compat. f_equal.
repeat rewrite ?mult_IZR, ?plus_IZR, ?minus_IZR.
rewrite <- (third_kind_scale _ _ ((1 - _) * _) _ _ _ (IZR N * IZR N)).
- f_equal; [f_equal; field; lra | f_equal; field; lra | field; lra ..].
- now apply Rmult_lt_0_compat.
- rewrite Rmult_1_l. now apply Rdiv_lt_0_compat.
- rewrite Rmult_1_l. apply Rplus_lt_0_compat; now apply Rdiv_lt_0_compat.
Qed.

Theorem twist_is_above n s N na nb nc a b c : a = IZR na / IZR N -> b = IZR nb / IZR N -> c = IZR nc
  / IZR N ->
  twist_test starts_above n s N na nb nc = true -> 2*PI < rotating_phase a b c.
Proof.
intros -> -> ->. unfold twist_test. rewrite !andb_true_iff, !Z.ltb_lt. intros [[[[Ha Hb] Hc] HN] H].
rewrite twist_in_integers by trivial. apply starts_above_sound in H. lra.
Qed.
Theorem twist_is_below n s N na nb nc a b c : a = IZR na / IZR N -> b = IZR nb / IZR N -> c = IZR nc
  / IZR N ->
  twist_test starts_below n s N na nb nc = true -> rotating_phase a b c < 2*PI.
Proof.
intros -> -> ->. unfold twist_test. rewrite !andb_true_iff, !Z.ltb_lt. intros [[[[Ha Hb] Hc] HN] H].
rewrite twist_in_integers by trivial. apply starts_below_sound in H. lra.
Qed.

(** The half phase on S *)
Lemma third_kind_of_multiples x y A B C D r : 0 < r -> 0 < x -> 0 < y -> 0 < C -> 0 < D ->
  third_kind (r*x) (r*y) A B C D = / r * third_kind x y A B C D.
Proof.
intros Hr Hx Hy HC HD. unfold third_kind.
assert (S := RInt_scal (V:=R_CompleteNormedModule) (fun t => weight A B C D t * integrand x y t) 0
  (PI/2) (/ r)).
transitivity (RInt (fun t => / r * (weight A B C D t * integrand x y t)) 0 (PI/2)).
- apply RInt_ext. intros t _. match goal with |- @eq _ ?l ?r => change (@eq R l r) end.
unfold integrand.
  assert (P := radicand_pos x y t Hx Hy). assert (Q := sqrt_lt_R0 _ P).
  replace (radicand (r*x) (r*y) t) with (r^2 * radicand x y t) by (unfold radicand; ring).
  rewrite sqrt_mult_alt, sqrt_pow2 by first [apply pow2_ge_0 | lra]. field. lra.
- apply S. apply (@ex_RInt_continuous R_CompleteNormedModule). intros z _.
now apply third_kind_continuous.
Qed.

Lemma half_phase_third_kind a b u : 0 < a -> 0 < b < 1 -> 0 < u <= 1 ->
  HalfPhase.G a b u = 2 * third_kind (sqrt (b*((a + b)*u))) (sqrt (b*(a + b*u))) ((1 - b*u)*(a + b))
    ((1 - b)*(a + b*u)) (1*(a + b)) (1*(a + b*u)).
Proof.
intros Ha Hb Hu. assert (B0 := sqrt_lt_R0 b ltac:(lra)). assert (A0 := sqrt_lt_R0 a Ha).
assert (P : 0 < b*u) by (apply Rmult_lt_0_compat; lra).
assert (P2 : 0 < (a+b)*u) by (apply Rmult_lt_0_compat; lra).
rewrite (sqrt_mult_alt b ((a+b)*u)), (sqrt_mult_alt b (a + b*u)), third_kind_of_multiples; try lra;
  try (apply sqrt_lt_R0; lra).
replace (a + b*u) with (1*(a + b*u)) at 1 by ring. rewrite <- third_kind_of_product by lra.
unfold HalfPhase.G. transitivity (2 / sqrt (a*b) * (sqrt a * RInt (fun t => weight (1 - b*u) (1 - b)
  1 1 t / sqrt ((u * cos t^2 + 1 * sin t^2) * ((a + b*u) * cos t^2 + (a + b) * sin t^2))) 0
  (PI/2))).
2:{ rewrite sqrt_mult_alt by lra. field. lra. }
f_equal. symmetry.
assert (S := RInt_scal (V:=R_CompleteNormedModule) (fun t => weight (1 - b*u) (1 - b) 1 1 t / sqrt
  ((u * cos t^2 + 1 * sin t^2) * ((a + b*u) * cos t^2 + (a + b) * sin t^2))) 0 (PI/2) (sqrt a)).
assert (Pos : forall t, 0 < (u * cos t^2 + 1 * sin t^2) * ((a + b*u) * cos t^2 + (a + b) * sin t^2))
  by (intros t; apply Rmult_lt_0_compat; apply form_pos; lra).
etransitivity. symmetry. apply S.
- apply (@ex_RInt_continuous R_CompleteNormedModule). intros t _.
  apply (continuous_mult (weight (1 - b*u) (1 - b) 1 1) (fun t => / sqrt ((u * cos t^2 + 1 * sin
    t^2) * ((a + b*u) * cos t^2 + (a + b) * sin t^2)))).
  apply weight_continuous; lra.
  apply (ex_derive_continuous (fun t => / sqrt ((u * cos t^2 + 1 * sin t^2) * ((a + b*u) * cos t^2 +
    (a + b) * sin t^2)))).
  assert (F := Pos t). assert (SF := sqrt_lt_R0 _ F). auto_derive. simpl in F, SF.
  repeat split; lra.
- apply RInt_ext. intros t _. assert (F := Pos t).
  assert (E : sin t^2 + cos t^2 = 1) by (generalize (sin2_cos2 t); unfold Rsqr; simpl; lra).
  assert (E2 : cos t^2 = 1 - sin t^2) by lra.
  change (sqrt a * (weight (1 - b*u) (1 - b) 1 1 t / sqrt ((u * cos t^2 + 1 * sin t^2) * ((a + b*u)
    * cos t^2 + (a + b) * sin t^2))) = HalfPhase.h a b (HalfPhase.X u (sin t))).
  unfold HalfPhase.h, HalfPhase.Q.
  assert (EX : HalfPhase.X u (sin t) = u * cos t^2 + 1 * sin t^2) by (unfold HalfPhase.X; rewrite
    E2; ring).
  replace (HalfPhase.X u (sin t) * (1 + b * HalfPhase.X u (sin t) / a)) with ((u * cos t^2 + 1 * sin
    t^2) * ((a + b*u) * cos t^2 + (a + b) * sin t^2) / a).
  2:{ rewrite EX, E2. field. lra. }
  rewrite sqrt_div_alt by lra. assert (SF := sqrt_lt_R0 _ F). unfold weight.
  replace (1 * cos t^2 + 1 * sin t^2) with 1 by lra.
  replace ((1 - b*u) * cos t^2 + (1 - b) * sin t^2) with (1 - b * HalfPhase.X u (sin t)) by (rewrite
    EX, E2; ring).
  field. lra.
Qed.

Definition meeting_test (test : nat -> Z -> Z -> Z -> Z -> Z -> Z -> Z -> Z -> Z -> Z -> bool) (n :
  nat) (s N na nb nu m : Z) : bool :=
  (0 <? na)%Z && (0 <? nb)%Z && (nb <? N)%Z && (0 <? nu)%Z && (nu <=? N)%Z && (0 <? m)%Z &&
  test n s (N*N)%Z (N*(nb*((na + nb)*nu)))%Z (N*(nb*(N*na + nb*nu)))%Z ((N*N - nb*nu)*(na + nb))%Z
    ((N - nb)*(N*na + nb*nu))%Z
    (N*N*(na + nb))%Z (N*(N*na + nb*nu))%Z 1%Z m.

Lemma meeting_in_integers N na nb nu : (0 < na)%Z -> (0 < nb)%Z -> (nb < N)%Z -> (0 < nu)%Z -> (nu
  <= N)%Z ->
  HalfPhase.G (IZR na / IZR N) (IZR nb / IZR N) (IZR nu / IZR N) = 2 * third_kind (sqrt (IZR
    (N*(nb*((na + nb)*nu))) / IZR (N*N*(N*N))))
    (sqrt (IZR (N*(nb*(N*na + nb*nu))) / IZR (N*N*(N*N)))) (IZR ((N*N - nb*nu)*(na + nb))) (IZR ((N
      - nb)*(N*na + nb*nu))) (IZR (N*N*(na + nb))) (IZR (N*(N*na + nb*nu))).
Proof.
intros Ha Hb HbN Hu HuN. assert (HN : (0 < N)%Z) by lia. apply IZR_lt in Ha, Hb, HbN, Hu, HN.
apply IZR_le in HuN.
assert (Pa : 0 < IZR na / IZR N) by now apply Rdiv_lt_0_compat.
assert (Pb : 0 < IZR nb / IZR N) by now apply Rdiv_lt_0_compat.
assert (Pu : 0 < IZR nu / IZR N) by now apply Rdiv_lt_0_compat.
rewrite half_phase_third_kind; trivial.
- f_equal. repeat rewrite ?mult_IZR, ?plus_IZR, ?minus_IZR.
  rewrite <- (third_kind_scale _ _ ((1 - _) * _) _ _ _ (IZR N * IZR N * IZR N)).
  + f_equal; [f_equal; field; lra | f_equal; field; lra | field; lra ..].
  + repeat apply Rmult_lt_0_compat; trivial.
  + lra.
  + rewrite Rmult_1_l. apply Rplus_lt_0_compat; trivial. now apply Rmult_lt_0_compat.
- split; trivial. apply (Rmult_lt_reg_r (IZR N)); trivial. unfold Rdiv.
rewrite Rmult_assoc, Rinv_l; lra.
- split; trivial. apply (Rmult_le_reg_r (IZR N)); trivial. unfold Rdiv.
rewrite Rmult_assoc, Rinv_l; lra.
Qed.

Theorem meeting_is_above n s N na nb nu m a b u : a = IZR na / IZR N -> b = IZR nb / IZR N -> u =
  IZR nu / IZR N ->
  meeting_test starts_above n s N na nb nu m = true -> 2*PI/IZR m < HalfPhase.G a b u.
Proof.
intros -> -> ->. unfold meeting_test. rewrite !andb_true_iff, !Z.ltb_lt, !Z.leb_le.
intros [[[[[[Ha Hb] HbN] Hu] HuN] Hm] H].
rewrite meeting_in_integers by trivial. apply starts_above_sound in H. lra.
Qed.
Theorem meeting_is_below n s N na nb nu m a b u : a = IZR na / IZR N -> b = IZR nb / IZR N -> u =
  IZR nu / IZR N ->
  meeting_test starts_below n s N na nb nu m = true -> HalfPhase.G a b u < 2*PI/IZR m.
Proof.
intros -> -> ->. unfold meeting_test. rewrite !andb_true_iff, !Z.ltb_lt, !Z.leb_le.
intros [[[[[[Ha Hb] HbN] Hu] HuN] Hm] H].
rewrite meeting_in_integers by trivial. apply starts_below_sound in H. lra.
Qed.
