(** The curve C of the tennis racket effect: lemma 1 (in the convention below), lemma 2, lemma 3 and theorem 4 of the paper, sharp, for all
    a > 0, 0 < b < 1.

    For the paper's definition, psi_i = -pi/2 + eps and psi_f = pi/2 - eps are symmetric and 2 pi apart in phi; put phi = 0 in the
    middle. C is here the set of (c, eps) with eps = pi/2 - psi_c (pi), where psi_c is the motion with the first integral c that passes psi = 0
    at phi = 0 with cos theta > 0. Convention.v compares this with the definition as printed. *)
Require Import Reals Lra Lia Psatz List.
From Coquelicot Require Import Coquelicot.
From Polhode Require Import HalfPhase Theorem1 Values Count Uniqueness Oscillation Symmetry.
Open Scope R_scope.

(** * Counting *)
(** A set of reals with exactly N members. *)
Definition has_exactly (N : nat) (S : R -> Prop) :=
  exists l : list R, NoDup l /\ length l = N /\ forall c, In c l <-> S c.
Lemma has_exactly_unique N N' S : has_exactly N S -> has_exactly N' S -> N = N'.
Proof.
intros [l [D [<- H]]] [l' [D' [<- H']]]. apply Nat.le_antisymm; apply NoDup_incl_length; trivial; intros c Hc.
now apply H', H. now apply H, H'.
Qed.
(** The least integer that is not below x. *)
Definition ceiling (x : R) : Z := (1 - up (- x))%Z.
Lemma ceiling_spec x : x <= IZR (ceiling x) < x + 1.
Proof. unfold ceiling. rewrite minus_IZR. destruct (archimed (- x)). lra. Qed.
(** The number of k = 1, 2, ... below x. *)
Definition count_below (x : R) : nat := Z.to_nat (ceiling x - 1).
Lemma count_below_spec x k : (1 <= k)%nat -> (INR k < x <-> (k <= count_below x)%nat).
Proof.
intros Hk. assert (C := ceiling_spec x). unfold count_below. rewrite INR_IZR_INZ. split; intros H.
- assert (L : IZR (Z.of_nat k) < IZR (ceiling x)) by lra. apply lt_IZR in L. lia.
- assert (L : (Z.of_nat k <= ceiling x - 1)%Z) by lia. apply IZR_le in L. rewrite minus_IZR in L. lra.
Qed.
(** One member for every k = 1, ..., N, different ones for different k: N members. *)
Lemma enumerate (T : nat -> R -> Prop) N :
  (forall k, (1 <= k <= N)%nat -> exists c, T k c /\ forall d, T k d -> d = c) -> (forall k l c, T k c -> T l c -> k = l) ->
  has_exactly N (fun c => exists k, (1 <= k <= N)%nat /\ T k c).
Proof.
intros E I. induction N as [|N IH].
- exists nil. repeat split. constructor. intros []. intros [k [Hk _]]. lia.
- destruct IH as [l [D [L H]]]. { intros k Hk. apply E. lia. }
  destruct (E (S N)) as [c [Hc U]]; [lia|]. exists (c :: l). split; [|split].
  + constructor; trivial. intros C. apply H in C. destruct C as [k [Hk Tk]]. assert (k = S N) by now apply (I k (S N) c). lia.
  + simpl. now rewrite L.
  + intros d. simpl. rewrite H. split.
    * intros [<-|[k [Hk Tk]]]. exists (S N). split; [lia|trivial]. exists k. split; [lia|trivial].
    * intros [k [Hk Tk]]. destruct (Nat.eq_dec k (S N)) as [->|N']. left. symmetry. now apply U. right. exists k. split; [lia|trivial].
Qed.
Lemma has_exactly_ext N (S S' : R -> Prop) : (forall c, S c <-> S' c) -> has_exactly N S -> has_exactly N S'.
Proof. intros E [l [D [L H]]]. exists l. repeat split; trivial; intros C. now apply E, H. now apply H, E. Qed.

Section Curve.
Variables a b : R.
Hypothesis Ha : 0 < a.
Hypothesis Hb : 0 < b < 1.
Notation I := (geometric_constant a b).

(** * The curves C and S *)
Definition curve_C (c eps : R) := exists psi theta, centred_motion a b c psi theta /\ eps = PI/2 - psi PI.
Definition curve_S (c eps : R) := c = - b * sin eps ^2.
(** Lemma 1, in this convention: C is the graph of a function of c. *)
Theorem lemma_1 c eps eps' : curve_C c eps -> curve_C c eps' -> eps = eps'.
Proof.
intros [psi [theta [M ->]]] [psi' [theta' [M' ->]]]. destruct (centred_motion_unique a b Ha Hb c psi theta psi' theta' M M' PI) as [-> _]. reflexivity.
Qed.
(** This function, for the oscillating motions. *)
Definition epsilon (c : R) := PI/2 - oscillation_psi a b (- c / b) PI.
Theorem curve_C_epsilon c eps : -b < c < 0 -> (curve_C c eps <-> eps = epsilon c).
Proof.
intros H. destruct (oscillation_of_c b Hb c H) as [Hu E].
assert (M := centred_oscillation a b Ha Hb (- c / b) Hu). rewrite E in M.
assert (C : curve_C c (epsilon c)) by (eexists; eexists; split; [exact M|reflexivity]).
split; [|now intros ->]. intros C'. exact (lemma_1 c _ _ C' C).
Qed.

(** C meets S at c; C crosses eps = pi/2 at c. *)
Definition meeting (c : R) := -b < c < 0 /\ exists eps, curve_C c eps /\ curve_S c eps.
Definition crossing (c : R) := -b < c < 0 /\ curve_C c (PI/2).
(** C meets S at c, with psi_c (pi) at the first turning point: the part of C of the first implicit equation, cos theta > 0. *)
Definition first_meeting (c : R) := -b < c < 0 /\
  exists psi theta, centred_motion a b c psi theta /\ curve_S c (PI/2 - psi PI) /\ forall phi, 0 <= phi < PI -> 0 < cos (theta phi).

(** On S, the motion is at a turning point: c + b cos^2 psi = 0 exactly where cos theta = 0. *)
Theorem on_S_iff_turning c psi theta phi : reduced_motion a b psi theta -> first_integral a b (psi phi) (theta phi) = c ->
  (curve_S c (PI/2 - psi phi) <-> cos (theta phi) = 0).
Proof.
intros M E. unfold curve_S. rewrite sin_shift. assert (Q := equation_20 a b (psi phi) (theta phi)). rewrite E in Q.
assert (B := cos2_bound (psi phi)). assert (0 <= b * cos (psi phi) ^2) by (apply Rmult_le_pos; lra). split; intros H0.
- rewrite H0 in Q. assert (Z : cos (theta phi) ^2 * (a + b * cos (psi phi) ^2) = 0) by lra.
  apply Rmult_integral in Z. destruct Z as [Z|Z]; [|lra]. apply Rsqr_0_uniq. unfold Rsqr. simpl in Z. lra.
- rewrite H0 in Q. lra.
Qed.
Lemma first_integral_at c psi theta phi : centred_motion a b c psi theta -> first_integral a b (psi phi) (theta phi) = c.
Proof. intros [M [_ [_ E]]]. rewrite <- E. now apply first_integral_constant. Qed.

(** C lies on one side of S, where c + b sin^2 eps = (a + b cos^2 psi) cos^2 theta is not negative, and touches it at the meeting points. *)
Theorem C_beside_S c eps : curve_C c eps -> 0 <= c + b * sin eps ^2.
Proof.
intros [psi [theta [M ->]]]. rewrite sin_shift, <- (first_integral_at c psi theta PI M), <- equation_20.
apply Rmult_le_pos; [apply pow2_ge_0|]. assert (0 <= b * cos (psi PI) ^2) by (apply Rmult_le_pos; [lra|apply pow2_ge_0]). lra.
Qed.
Lemma half_integer_positive g (k : Z) : 0 < g -> PI = (IZR k + 1/2) * g -> (0 <= k)%Z.
Proof.
intros Hg E. assert (P := PI_RGT_0). assert (L : IZR (-1) < IZR k). { assert (0 < IZR k + 1/2). { apply (Rmult_lt_reg_r g); lra. } lra. }
apply lt_IZR in L. lia.
Qed.
(** C meets S exactly where G u = 2 pi/(2k-1) for a k >= 1, *)
Theorem meeting_iff u : 0 < u < 1 -> (meeting (- b * u) <-> exists k, (1 <= k)%nat /\ G a b u = 2*PI/(2*INR k - 1)).
Proof.
intros Hu. assert (GP := G_pos a b u Ha Hb Hu). assert (P := PI_RGT_0). split.
- intros [_ [eps [[psi [theta [M ->]]] S]]].
  apply (on_S_iff_turning _ psi theta PI) in S; [|apply M|now apply first_integral_at].
  apply (theta_turning_points a b Ha Hb u Hu psi theta M) in S. destruct S as [k Hk].
  assert (K := half_integer_positive _ k GP Hk). exists (Z.to_nat (k + 1)). split; [lia|].
  rewrite INR_IZR_INZ, Z2Nat.id, plus_IZR by lia. apply IZR_le in K. rewrite Hk at 1. field. lra.
- intros [k [Hk E]]. assert (K : 1 <= INR k) by (apply (le_INR 1); exact Hk).
  split; [split; [nra|assert (0 < b * u) by (apply Rmult_lt_0_compat; lra); lra]|].
  assert (M := centred_oscillation a b Ha Hb u Hu). set (psi := oscillation_psi a b u) in *. set (theta := oscillation_theta a b u) in *.
  exists (PI/2 - psi PI). split. { exists psi, theta. now split. }
  apply (on_S_iff_turning _ psi theta PI); [apply M|now apply first_integral_at|].
  apply (theta_turning_points a b Ha Hb u Hu psi theta M). exists (Z.of_nat k - 1)%Z. rewrite minus_IZR, <- INR_IZR_INZ, E. field. lra.
Qed.
(** it crosses eps = pi/2 exactly where G u = pi/k for a k >= 1, *)
Theorem crossing_iff u : 0 < u < 1 -> (crossing (- b * u) <-> exists k, (1 <= k)%nat /\ G a b u = PI/INR k).
Proof.
intros Hu. assert (GP := G_pos a b u Ha Hb Hu). assert (P := PI_RGT_0). split.
- intros [_ [psi [theta [M E]]]]. assert (Z : psi PI = 0) by lra.
  apply (psi_passages a b Ha Hb u Hu psi theta M) in Z. destruct Z as [k Hk].
  assert (K : (0 < k)%Z). { apply lt_IZR. apply (Rmult_lt_reg_r (G a b u)); lra. }
  exists (Z.to_nat k). split; [lia|]. rewrite INR_IZR_INZ, Z2Nat.id by lia. apply IZR_lt in K. rewrite Hk at 1. field. lra.
- intros [k [Hk E]]. assert (K : 1 <= INR k) by (apply (le_INR 1); exact Hk).
  split; [split; [nra|assert (0 < b * u) by (apply Rmult_lt_0_compat; lra); lra]|].
  assert (M := centred_oscillation a b Ha Hb u Hu). eexists. eexists. split; [exact M|].
  assert (Z : oscillation_psi a b u PI = 0). { apply (passages a b u Ha Hb Hu). exists (Z.of_nat k). rewrite <- INR_IZR_INZ, E. field. lra. }
  rewrite Z. ring.
Qed.
(** and it meets S at the first turning point exactly where G u = 2 pi. *)
Theorem first_meeting_iff u : 0 < u < 1 -> (first_meeting (- b * u) <-> G a b u = 2*PI).
Proof.
intros Hu. assert (GP := G_pos a b u Ha Hb Hu). assert (P := PI_RGT_0). split.
- intros [_ [psi [theta [M [S F]]]]].
  apply (on_S_iff_turning _ psi theta PI) in S; [|apply M|now apply first_integral_at].
  apply (theta_turning_points a b Ha Hb u Hu psi theta M) in S. destruct S as [k Hk].
  assert (K := half_integer_positive _ k GP Hk). destruct (Z.eq_dec k 0) as [->|N]; [lra|]. exfalso.
  assert (K1 : 1 <= IZR k) by (apply IZR_le; lia). assert (L : G a b u / 2 < PI) by nra.
  specialize (F (G a b u / 2) ltac:(lra)). rewrite (first_turning_point a b Ha Hb u Hu psi theta M), cos_PI2 in F. lra.
- intros E. assert (M := centred_oscillation a b Ha Hb u Hu).
  set (psi := oscillation_psi a b u) in *. set (theta := oscillation_theta a b u) in *.
  split; [split; [nra|assert (0 < b * u) by (apply Rmult_lt_0_compat; lra); lra]|].
  exists psi, theta. split; [exact M|]. assert (E' : PI = G a b u / 2) by lra. split.
  + apply (on_S_iff_turning _ psi theta PI); [apply M|now apply first_integral_at|].
    rewrite E' at 1. rewrite (first_turning_point a b Ha Hb u Hu psi theta M). apply cos_PI2.
  + intros phi L. apply (rises_to_first_turning_point a b Ha Hb u Hu psi theta M). lra.
Qed.

(** * The count *)
Lemma G_value_unique u v : 0 < u < 1 -> 0 < v < 1 -> G a b u = G a b v -> u = v.
Proof.
intros Hu Hv E. destruct (Rtotal_order u v) as [L|[L|L]]; trivial; [assert (D := G_decreasing a b Ha Hb u v)|assert (D := G_decreasing a b Ha Hb v u)]; lra.
Qed.
(** c is the k-th meeting point, or the k-th crossing. *)
Definition solves (v c : R) := -b < c < 0 /\ G a b (- c / b) = v.
Lemma solves_iff_root v : one_root a b v <-> exists c, solves v c /\ forall d, solves v d -> d = c.
Proof.
split.
- intros [u [Hu [E U]]]. exists (- b * u).
  assert (B0 : -b < - b * u < 0). { split; [nra|]. assert (0 < b * u) by (apply Rmult_lt_0_compat; lra). lra. }
  assert (B1 : - (- b * u) / b = u) by (field; lra). split. { split; [exact B0|]. now rewrite B1. }
  intros d [Hd Ed]. destruct (oscillation_of_c b Hb d Hd) as [Hw W]. rewrite <- W. f_equal. now apply U.
- intros [c [[Hc E] _]]. destruct (oscillation_of_c b Hb c Hc) as [Hu W]. exists (- c / b). repeat split; try apply Hu; trivial.
  intros w Hw Ew. apply G_value_unique; trivial. lra.
Qed.
Lemma solves_some v c : solves v c -> one_root a b v.
Proof.
intros [Hc E]. destruct (oscillation_of_c b Hb c Hc) as [Hu W]. exists (- c / b). repeat split; try apply Hu; trivial.
intros w Hw Ew. apply G_value_unique; trivial. lra.
Qed.
Lemma meeting_values k l : (1 <= k)%nat -> (1 <= l)%nat -> 2*PI/(2*INR k - 1) = 2*PI/(2*INR l - 1) -> k = l.
Proof.
intros Hk Hl E. assert (K : 1 <= INR k) by (apply (le_INR 1); exact Hk). assert (L : 1 <= INR l) by (apply (le_INR 1); exact Hl).
assert (P := PI_RGT_0). apply INR_eq. unfold Rdiv in E. apply Rmult_eq_reg_l in E; [|lra]. apply (f_equal Rinv) in E. rewrite !Rinv_inv in E. lra.
Qed.
Lemma crossing_values k l : (1 <= k)%nat -> (1 <= l)%nat -> PI/INR k = PI/INR l -> k = l.
Proof.
intros Hk Hl E. assert (P := PI_RGT_0). apply INR_eq. unfold Rdiv in E. apply Rmult_eq_reg_l in E; [|lra]. apply (f_equal Rinv) in E. rewrite !Rinv_inv in E. exact E.
Qed.
Lemma meeting_c c : meeting c <-> exists k, (1 <= k)%nat /\ solves (2*PI/(2*INR k - 1)) c.
Proof.
split.
- intros M. assert (Hc := proj1 M). destruct (oscillation_of_c b Hb c Hc) as [Hu W]. rewrite <- W in M. apply meeting_iff in M; trivial.
  destruct M as [k [Hk E]]. exists k. repeat split; trivial; apply Hc.
- intros [k [Hk [Hc E]]]. destruct (oscillation_of_c b Hb c Hc) as [Hu W]. rewrite <- W. apply meeting_iff; trivial. exists k. now split.
Qed.
Lemma crossing_c c : crossing c <-> exists k, (1 <= k)%nat /\ solves (PI/INR k) c.
Proof.
split.
- intros M. assert (Hc := proj1 M). destruct (oscillation_of_c b Hb c Hc) as [Hu W]. rewrite <- W in M. apply crossing_iff in M; trivial.
  destruct M as [k [Hk E]]. exists k. repeat split; trivial; apply Hc.
- intros [k [Hk [Hc E]]]. destruct (oscillation_of_c b Hb c Hc) as [Hu W]. rewrite <- W. apply crossing_iff; trivial. exists k. now split.
Qed.

(** Theorem 4, sharp: C and S meet in exactly ceiling (1/I + 1/2) - 1 points with -b < c < 0. *)
Theorem theorem_4_sharp : has_exactly (count_below (1/I + 1/2)) meeting.
Proof.
apply (has_exactly_ext _ (fun c => exists k, (1 <= k <= count_below (1/I + 1/2))%nat /\ ((1 <= k)%nat /\ solves (2*PI/(2*INR k - 1)) c))).
- intros c. rewrite meeting_c. split.
  + intros [k [_ S]]. now exists k.
  + intros [k [Hk S]]. exists k. split; [|now split]. split; trivial. apply count_below_spec; trivial. apply (meeting_points a b Ha Hb k Hk). now apply (solves_some _ c).
- apply enumerate.
  + intros k Hk. destruct (proj1 (solves_iff_root (2*PI/(2*INR k - 1)))) as [c [S U]].
    * apply (meeting_points a b Ha Hb k); [lia|]. apply count_below_spec; lia.
    * exists c. split. split; [lia|trivial]. intros d [_ Sd]. now apply U.
  + intros k l c [Hk [_ E]] [Hl [_ E']]. apply meeting_values; trivial. now rewrite <- E, <- E'.
Qed.
(** Lemma 3, sharp: C crosses eps = pi/2 in exactly ceiling (1/I) - 1 points with -b < c < 0. *)
Theorem lemma_3_sharp : has_exactly (count_below (1/I)) crossing.
Proof.
apply (has_exactly_ext _ (fun c => exists k, (1 <= k <= count_below (1/I))%nat /\ ((1 <= k)%nat /\ solves (PI/INR k) c))).
- intros c. rewrite crossing_c. split.
  + intros [k [_ S]]. now exists k.
  + intros [k [Hk S]]. exists k. split; [|now split]. split; trivial. apply count_below_spec; trivial. apply (crossings a b Ha Hb k Hk). now apply (solves_some _ c).
- apply enumerate.
  + intros k Hk. destruct (proj1 (solves_iff_root (PI/INR k))) as [c [S U]].
    * apply (crossings a b Ha Hb k); [lia|]. apply count_below_spec; lia.
    * exists c. split. split; [lia|trivial]. intros d [_ Sd]. now apply U.
  + intros k l c [Hk [_ E]] [Hl [_ E']]. apply crossing_values; trivial. now rewrite <- E, <- E'.
Qed.

(** * Order along C *)
(** A larger value of G is taken at a larger c. *)
Lemma solves_order v w c d : solves v c -> solves w d -> v < w -> c < d.
Proof.
intros [Hc E] [Hd F] L. destruct (oscillation_of_c b Hb c Hc) as [Hu U]. destruct (oscillation_of_c b Hb d Hd) as [Hw W].
apply Rnot_le_lt. intros [N|N].
- assert (- c / b < - d / b). { unfold Rdiv. apply Rmult_lt_compat_r; [apply Rinv_0_lt_compat|]; lra. }
  assert (D := G_decreasing a b Ha Hb (- c / b) (- d / b)). lra.
- rewrite N in F. lra.
Qed.
Lemma solves_order_back v w c d : solves v c -> solves w d -> c < d -> v < w.
Proof.
intros S T L. destruct (Rtotal_order v w) as [N|[N|N]]; trivial.
- rewrite N in S. destruct S as [Hc E], T as [Hd F].
  destruct (oscillation_of_c b Hb c Hc) as [Hu U]. destruct (oscillation_of_c b Hb d Hd) as [Hw W].
  assert (- c / b = - d / b) by (apply G_value_unique; trivial; lra). assert (c = d) by (rewrite <- U, <- W; now f_equal). lra.
- assert (d < c) by now apply (solves_order w v). lra.
Qed.
Lemma solves_function v c d : solves v c -> solves v d -> c = d.
Proof. intros S T. destruct (Rtotal_order c d) as [N|[N|N]]; trivial; [assert (v < v) by now apply (solves_order_back v v c d)|assert (v < v) by now apply (solves_order_back v v d c)]; lra. Qed.
Lemma meeting_value_order k l : (1 <= k)%nat -> (k < l)%nat -> 2*PI/(2*INR l - 1) < 2*PI/(2*INR k - 1).
Proof.
intros Hk Hl. assert (K : 1 <= INR k) by (apply (le_INR 1); exact Hk). apply lt_INR in Hl. assert (P := PI_RGT_0).
unfold Rdiv. apply Rmult_lt_compat_l; [lra|]. apply Rinv_lt_contravar; [|lra]. apply Rmult_lt_0_compat; lra.
Qed.
Lemma root_above v w : one_root a b v -> v <= w -> one_root a b w.
Proof.
intros H L. apply (takes_each_value_once a b Ha Hb) in H. apply (takes_each_value_once a b Ha Hb). lra.
Qed.

(** c is the n-th meeting point, counted from c = 0 downwards: exactly n of them are not below c. *)
Definition nth_meeting (n : nat) (c : R) := meeting c /\ has_exactly n (fun d => meeting d /\ c <= d).
Lemma nth_meeting_of_solves n c : (1 <= n)%nat -> solves (2*PI/(2*INR n - 1)) c -> nth_meeting n c.
Proof.
intros Hn S. split. { apply meeting_c. now exists n. }
apply (has_exactly_ext _ (fun d => exists k, (1 <= k <= n)%nat /\ ((1 <= k)%nat /\ solves (2*PI/(2*INR k - 1)) d))).
- intros d. rewrite meeting_c. split.
  + intros [k [Hk [Hk1 T]]]. split. now exists k. destruct (Nat.eq_dec k n) as [->|N].
    * right. now apply (solves_function (2*PI/(2*INR n - 1))).
    * left. apply (solves_order _ _ _ _ S T). apply meeting_value_order; lia.
  + intros [[k [Hk T]] L]. exists k. split; [|now split]. split; trivial. apply Nat.nlt_ge. intros N.
    assert (d < c). { apply (solves_order _ _ _ _ T S). now apply meeting_value_order. } lra.
- apply enumerate.
  + intros k Hk. destruct (proj1 (solves_iff_root (2*PI/(2*INR k - 1)))) as [d [T U]].
    * apply (root_above (2*PI/(2*INR n - 1))); [now apply (solves_some _ c)|]. destruct (Nat.eq_dec k n) as [->|N]; [lra|]. left. apply meeting_value_order; lia.
    * exists d. split. split; [lia|trivial]. intros e [_ Se]. now apply U.
  + intros k l d [Hk [_ E]] [Hl [_ E']]. apply meeting_values; trivial. now rewrite <- E, <- E'.
Qed.
(** The n-th meeting point is where G u = 2 pi/(2n-1). *)
Theorem nth_meeting_iff n c : (1 <= n)%nat -> (nth_meeting n c <-> solves (2*PI/(2*INR n - 1)) c).
Proof.
intros Hn. split; [|now apply nth_meeting_of_solves]. intros [M H]. assert (M' := M). apply meeting_c in M'. destruct M' as [k [Hk S]].
destruct (nth_meeting_of_solves k c Hk S) as [_ H']. assert (n = k) by exact (has_exactly_unique _ _ _ H H'). now subst k.
Qed.

(** * The paper's statements *)
Lemma I_positive : 0 < I.
Proof. now apply I_pos. Qed.
Lemma first_meeting_c c : first_meeting c <-> solves (2*PI) c.
Proof.
split.
- intros M. assert (Hc := proj1 M). destruct (oscillation_of_c b Hb c Hc) as [Hu W]. rewrite <- W in M. apply first_meeting_iff in M; trivial.
  split; [apply Hc|trivial].
- intros [Hc E]. destruct (oscillation_of_c b Hb c Hc) as [Hu W]. rewrite <- W. now apply first_meeting_iff.
Qed.
Lemma first_is_first c : first_meeting c <-> nth_meeting 1 c.
Proof. rewrite first_meeting_c, nth_meeting_iff by lia. replace (2*PI/(2*INR 1 - 1)) with (2*PI) by (simpl; field). reflexivity. Qed.
(** Lemma 2: the part of C of the first implicit equation meets S, with -b < c < 0, exactly if I < 2, and then in one point. (The paper's
    I <= 2 counts the limit u = 1, the equilibrium c = -b, as a point.) *)
Theorem lemma_2 : (exists c, first_meeting c) <-> I < 2.
Proof.
assert (P := PI_RGT_0). split.
- intros [c M]. apply first_meeting_c, solves_some in M. apply (takes_each_value_once a b Ha Hb) in M.
  apply (Rmult_lt_reg_l PI); lra.
- intros H. destruct (proj1 (solves_iff_root (2*PI))) as [c [S _]].
  + apply (takes_each_value_once a b Ha Hb). rewrite (Rmult_comm 2). apply Rmult_lt_compat_l; lra.
  + exists c. now apply first_meeting_c.
Qed.
Theorem lemma_2_unique c d : first_meeting c -> first_meeting d -> c = d.
Proof. rewrite !first_meeting_c. apply solves_function. Qed.
(** Lemma 3: C crosses eps = pi/2 exactly if I < 1, *)
Theorem lemma_3_crossing : (exists c, crossing c) <-> I < 1.
Proof.
assert (P := PI_RGT_0). split.
- intros [c M]. apply crossing_c in M. destruct M as [k [Hk S]]. apply solves_some in S. apply (takes_each_value_once a b Ha Hb) in S.
  assert (K : 1 <= INR k) by (apply (le_INR 1); exact Hk). apply (Rmult_lt_reg_l PI); [lra|]. apply Rlt_le_trans with (1 := S).
  apply (Rmult_le_reg_r (INR k)); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. nra.
- intros H. destruct (proj1 (solves_iff_root (PI/INR 1))) as [c [S _]].
  + apply (takes_each_value_once a b Ha Hb). simpl. unfold Rdiv. rewrite Rinv_1. apply Rmult_lt_compat_l; lra.
  + exists c. apply crossing_c. exists 1%nat. now split.
Qed.
(** and then at a c* between the first meeting point and the second, or between the first and -b if there is no second. *)
Theorem lemma_3 : (exists c1 cs, first_meeting c1 /\ crossing cs /\ cs < c1 /\ forall c2, meeting c2 -> c2 < c1 -> c2 < cs) <-> I < 1.
Proof.
assert (P := PI_RGT_0). split.
- intros [_ [cs [_ [C _]]]]. apply lemma_3_crossing. now exists cs.
- intros H. destruct (proj2 lemma_2 ltac:(lra)) as [c1 F]. apply first_meeting_c in F.
  destruct (proj1 (solves_iff_root (PI/INR 1))) as [cs [S _]].
  { apply (takes_each_value_once a b Ha Hb). simpl. unfold Rdiv. rewrite Rinv_1. apply Rmult_lt_compat_l; lra. }
  exists c1, cs. split; [now apply first_meeting_c|]. split; [apply crossing_c; exists 1%nat; now split|].
  assert (E : PI/INR 1 = PI) by (simpl; field). rewrite E in S. split.
  + apply (solves_order PI (2*PI)); trivial. lra.
  + intros c2 M L. apply meeting_c in M. destruct M as [k [Hk T]]. assert (V := solves_order_back _ _ _ _ T F L).
    apply (solves_order _ _ _ _ T S).
    destruct (Nat.eq_dec k 1) as [->|N]; [simpl in V; exfalso; unfold Rdiv in V; replace (2*1-1) with 1 in V by ring; rewrite Rinv_1 in V; lra|].
    assert (K : 2 <= INR k) by (apply (le_INR 2); lia). apply (Rmult_lt_reg_r (2*INR k - 1)); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. nra.
Qed.

(** Theorem 4 as printed, with the places in order: if I < 2/(2n+1), there are an n-th meeting point c_n, a crossing c* of eps = pi/2 below it,
    and the next meeting point below that. *)
Theorem theorem_4 n : (1 <= n)%nat -> I < 2/(2*INR n + 1) ->
  exists cn cs cint, nth_meeting n cn /\ crossing cs /\ nth_meeting (S n) cint /\ -b < cint < cs /\ cs < cn.
Proof.
intros Hn H. assert (P := PI_RGT_0). assert (N : 1 <= INR n) by (apply (le_INR 1); exact Hn). assert (J := I_positive).
assert (V : 2*PI/(2*INR (S n) - 1) = PI * (2/(2*INR n + 1))) by (rewrite S_INR; field; lra).
assert (R1 : one_root a b (2*PI/(2*INR (S n) - 1))).
{ apply (takes_each_value_once a b Ha Hb). rewrite V. apply Rmult_lt_compat_l; lra. }
assert (L1 : 2*PI/(2*INR (S n) - 1) < PI/INR n).
{ rewrite S_INR. apply (Rmult_lt_reg_r ((2*(INR n + 1) - 1) * INR n)); [apply Rmult_lt_0_compat; lra|].
  replace (2*PI/(2*(INR n + 1) - 1)*((2*(INR n + 1) - 1)*INR n)) with (2*PI*INR n) by (field; lra).
  replace (PI/INR n*((2*(INR n + 1) - 1)*INR n)) with (PI*(2*(INR n + 1) - 1)) by (field; lra). nra. }
assert (L2 : PI/INR n < 2*PI/(2*INR n - 1)).
{ apply (Rmult_lt_reg_r ((2*INR n - 1) * INR n)); [apply Rmult_lt_0_compat; lra|].
  replace (2*PI/(2*INR n - 1)*((2*INR n - 1)*INR n)) with (2*PI*INR n) by (field; lra).
  replace (PI/INR n*((2*INR n - 1)*INR n)) with (PI*(2*INR n - 1)) by (field; lra). nra. }
assert (R2 : one_root a b (PI/INR n)) by (apply (root_above _ _ R1); lra).
assert (R3 : one_root a b (2*PI/(2*INR n - 1))) by (apply (root_above _ _ R2); lra).
apply solves_iff_root in R1. apply solves_iff_root in R2. apply solves_iff_root in R3.
destruct R1 as [cint [S1 _]], R2 as [cs [S2 _]], R3 as [cn [S3 _]]. exists cn, cs, cint.
split; [now apply nth_meeting_iff|]. split; [apply crossing_c; now exists n|]. split; [apply nth_meeting_iff; [lia|trivial]|].
split; [split; [apply S1|now apply (solves_order _ _ _ _ S1 S2)]|now apply (solves_order _ _ _ _ S2 S3)].
Qed.
(** The sharp form by ranges of I: n + 1 meeting points exactly for 2/(2n+3) <= I < 2/(2n+1), none exactly for I >= 2. *)
Lemma below_half k : (1 <= k)%nat -> (INR k < 1/I + 1/2 <-> I < 2/(2*INR k - 1)).
Proof.
intros Hk. assert (K : 1 <= INR k) by (apply (le_INR 1); exact Hk). assert (J := I_positive). split; intros H.
- apply (Rmult_lt_compat_l I) in H; [|lra]. replace (I*(1/I + 1/2)) with (1 + I/2) in H by (field; lra).
  apply (Rmult_lt_reg_r (2*INR k - 1)); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra.
- apply (Rmult_lt_compat_r (2*INR k - 1)) in H; [|lra]. unfold Rdiv in H at 1. rewrite Rmult_assoc, Rinv_l in H by lra.
  apply (Rmult_lt_reg_l I); [lra|]. replace (I*(1/I + 1/2)) with (1 + I/2) by (field; lra). lra.
Qed.
Theorem theorem_4_ranges n : has_exactly (S n) meeting <-> 2/(2*INR n + 3) <= I < 2/(2*INR n + 1).
Proof.
assert (E : has_exactly (S n) meeting <-> count_below (1/I + 1/2) = S n).
{ split; intros H; [|rewrite <- H; apply theorem_4_sharp]. apply (has_exactly_unique _ _ _ theorem_4_sharp H). }
rewrite E. assert (A := count_below_spec (1/I + 1/2) (S n) ltac:(lia)). assert (B := count_below_spec (1/I + 1/2) (S (S n)) ltac:(lia)).
rewrite (below_half (S n)) in A by lia. rewrite (below_half (S (S n))) in B by lia. rewrite S_INR in A. rewrite !S_INR in B.
replace (2*(INR n + 1) - 1) with (2*INR n + 1) in A by ring. replace (2*(INR n + 1 + 1) - 1) with (2*INR n + 3) in B by ring. split.
- intros C. rewrite C in A, B. split; [apply Rnot_lt_le; intros N; apply B in N; lia|apply A; lia].
- intros [L U]. apply A in U. assert (N : ~ (S (S n) <= count_below (1/I + 1/2))%nat) by (rewrite <- B; lra). lia.
Qed.
Theorem no_meeting : (forall c, ~ meeting c) <-> 2 <= I.
Proof.
split.
- intros N. apply Rnot_lt_le. intros L. apply lemma_2 in L. destruct L as [c M]. apply (N c). apply first_is_first in M. apply M.
- intros L c M. apply meeting_c in M. destruct M as [k [Hk S]]. apply solves_some in S. apply (meeting_points a b Ha Hb k Hk) in S. apply below_half in S; trivial.
  assert (K : 1 <= INR k) by (apply (le_INR 1); exact Hk).
  assert (2/(2*INR k - 1) <= 2). { apply (Rmult_le_reg_r (2*INR k - 1)); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra. } lra.
Qed.
End Curve.
