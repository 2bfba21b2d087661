(** The paper's epsilon_{0,min}, to a thousand digits. *)
Require Import Reals Lra ZArith.
From Interval Require Import Tactic.
Open Scope R_scope.

Definition epsilon0_min : R := PI - 2 * atan (exp PI).

Lemma epsilon0_min_by_exp : epsilon0_min = 2 * atan (exp (- PI)).
Proof.
unfold epsilon0_min. rewrite exp_Ropp, atan_inv by apply exp_pos. lra.
Qed.

(** Fractions are compared as integers, after [interval_intro] has enclosed the number once. *)
Lemma fraction_le (p q r s : Z) :
  (0 < q)%Z -> (0 < s)%Z -> (p * s <= r * q)%Z -> IZR p / IZR q <= IZR r / IZR s.
Proof.
intros Hq Hs H. apply IZR_lt in Hq, Hs. apply IZR_le in H. rewrite !mult_IZR in H.
apply Rmult_le_reg_r with (IZR q * IZR s). { now apply Rmult_lt_0_compat. }
replace (IZR p / IZR q * (IZR q * IZR s)) with (IZR p * IZR s) by (field; lra).
replace (IZR r / IZR s * (IZR q * IZR s)) with (IZR r * IZR q) by (field; lra).
exact H.
Qed.

Lemma digits_of_enclosure (x : R) (l m u k digits scale error : Z) :
  IZR l / IZR m <= x <= IZR u / IZR k ->
  (0 < m)%Z -> (0 < k)%Z -> (0 < scale)%Z -> (0 < error)%Z ->
  ((digits * error - scale) * m <= l * (scale * error))%Z ->
  (u * (scale * error) <= (digits * error + scale) * k)%Z ->
  Rabs (x - IZR digits / IZR scale) <= 1 / IZR error.
Proof.
intros [Hl Hu] Hm Hk Hs He Hlow Hhigh.
assert (Hse : (0 < scale * error)%Z) by now apply Z.mul_pos_pos.
apply (fraction_le _ _ _ _ Hse Hm) in Hlow. apply (fraction_le _ _ _ _ Hk Hse) in Hhigh.
apply IZR_lt in Hs, He.
rewrite minus_IZR, !mult_IZR in Hlow. rewrite plus_IZR, !mult_IZR in Hhigh.
replace ((IZR digits * IZR error - IZR scale) / (IZR scale * IZR error))
  with (IZR digits / IZR scale - 1 / IZR error) in Hlow by (field; lra).
replace ((IZR digits * IZR error + IZR scale) / (IZR scale * IZR error))
  with (IZR digits / IZR scale + 1 / IZR error) in Hhigh by (field; lra).
apply Rabs_le. lra.
Qed.

Theorem epsilon0_min_digits : Rabs (epsilon0_min -
  86374097049564252270224897673712903476876773026671502671089828201745686614781745032295077480053585738768973525339726880597690674690283161830562865873987285423843945843603242488825289936588884519970727018000139854942159232137408231909916440890341114428479939254281010078615930401703125258494189755859543961686154973479338190878947252000086644384109653678417759858977402758800108960260786279890335853919929990019728190645928278657694238328396156482291982349947144781499462336416724346816512939355267654262915616191162290064335382305093994696324169142132427237141687912331275769830465288988571732627262628013718389916016654673146937287356876336995831471911059675513277175396155041029080005275880424553672226651245479420786543684882821085324368161945647207871154848823103740698437491942847775895158586605911549930851915383736464240390512347382154359682446073767246283453246554934972938240131227126866171263980623581601021794622421875167906982743803712355142160122722171392670132392303714716122706610145258
  / IZR (10^1002)) <= 1 / IZR (10^1001).
Proof.
rewrite epsilon0_min_by_exp.
interval_intro (2 * atan (exp (- PI))) with (i_prec 3360) as enclosure.
apply (digits_of_enclosure _ _ _ _ _ _ _ _ enclosure);
  (apply Z.leb_le || apply Z.ltb_lt); vm_cast_no_check (eq_refl true).
Qed.
