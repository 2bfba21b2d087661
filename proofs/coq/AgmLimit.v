(** Gauss's theorem: both sequences of the arithmetic-geometric mean of a and b tend to pi / (2 I(a,b)). *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Polhode Require Import GaussIntegral.
Open Scope R_scope.

Fixpoint agm (n : nat) (a b : R) : R * R :=
 match n with O => (a,b) | S n => let p := agm n a b in ((fst p + snd p)/2, sqrt (fst p * snd p)) end.

Lemma agm_invariant n a b : 0 < b -> b <= a ->
  let p := agm n a b in 0 < snd p /\ snd p <= fst p /\ gauss_integral (fst p) (snd p) = gauss_integral a b /\ fst p - snd p <= (a - b) * (/2)^n.
Proof.
intros Hb Ha. induction n as [|n IH].
- cbn [agm fst snd pow]. repeat split; lra.
- cbn [agm pow]. destruct (agm n a b) as [x y]. cbn [fst snd pow] in IH |- *. destruct IH as [H1 [H2 [H3 H4]]].
  assert (P : 0 < x * y) by nra. assert (S := sqrt_lt_R0 _ P). assert (Q := sqrt_sqrt _ (Rlt_le _ _ P)).
  set (s := sqrt (x*y)) in *. repeat split.
  + exact S.
  + nra.
  + rewrite <- H3. symmetry. apply gauss_invariance; lra.
  + assert (y <= s) by nra. replace ((a-b)*(/2*(/2)^n)) with ((a-b)*(/2)^n/2) by field. lra.
Qed.

Theorem agm_limit a b : 0 < b -> b <= a ->
  is_lim_seq (fun n => fst (agm n a b)) (PI / (2 * gauss_integral a b)) /\
  is_lim_seq (fun n => snd (agm n a b)) (PI / (2 * gauss_integral a b)).
Proof.
intros Hb Ha. assert (HPI := PI_RGT_0).
assert (I0 : 0 < gauss_integral a b). { destruct (gauss_integral_bounds a b Hb Ha) as [H _]. eapply Rlt_le_trans; [|exact H]. repeat apply Rdiv_lt_0_compat; lra. }
set (M := PI / (2 * gauss_integral a b)).
assert (B : forall n, snd (agm n a b) <= M <= fst (agm n a b)).
{ intros n. destruct (agm_invariant n a b Hb Ha) as [H1 [H2 [H3 H4]]]. destruct (agm n a b) as [x y]. cbn [fst snd] in *.
  destruct (gauss_integral_bounds x y H1 H2) as [L U]. rewrite H3 in L, U. unfold M. split.
  - apply (Rmult_le_reg_r (2 * gauss_integral a b)); [lra|]. apply (Rmult_le_compat_r y) in U; [|lra].
    replace (PI / (2*gauss_integral a b) * (2 * gauss_integral a b)) with PI by (field; lra). replace (PI/2/y*y) with (PI/2) in U by (field; lra). lra.
  - apply (Rmult_le_reg_r (2 * gauss_integral a b)); [lra|]. apply (Rmult_le_compat_r x) in L; [|lra].
    replace (PI / (2*gauss_integral a b) * (2 * gauss_integral a b)) with PI by (field; lra). replace (PI/2/x*x) with (PI/2) in L by (field; lra). lra. }
assert (G0 : is_lim_seq (fun n => (a-b) * (/2)^n) 0).
{ replace (Finite 0) with (Rbar_mult (a-b) 0) by (cbn; f_equal; ring). apply is_lim_seq_scal_l.
  apply is_lim_seq_geom. rewrite Rabs_right; lra. }
split.
- apply (is_lim_seq_le_le (fun _ => M) _ (fun n => M + (a-b) * (/2)^n)).
  + intros n. specialize (B n). destruct (agm_invariant n a b Hb Ha) as [H1 [H2 [H3 H4]]]. lra.
  + apply is_lim_seq_const.
  + replace (Finite M) with (Rbar_plus M 0) by (cbn; f_equal; ring).
    apply is_lim_seq_plus'; trivial. apply is_lim_seq_const.
- apply (is_lim_seq_le_le (fun n => M - (a-b) * (/2)^n) _ (fun _ => M)).
  + intros n. specialize (B n). destruct (agm_invariant n a b Hb Ha) as [H1 [H2 [H3 H4]]]. lra.
  + replace (Finite M) with (Finite (M - 0)) by (f_equal; ring).
    apply is_lim_seq_minus'; trivial. apply is_lim_seq_const.
  + apply is_lim_seq_const.
Qed.
