(** What the theorems about beta say: printed, and compared with what they are meant to say, written out here once more, so
    that a certificate under which another theorem has their name is refused. *)
Require Import Reals ZArith.
From Bignums Require Import BigZ.
From Coquelicot Require Import Coquelicot.
From Polhode Require Import AgmLimit.
From Polhode Require AgmCertificate BetaDigits BetaManyDigits.
Open Scope R_scope.

(** There is exactly one beta > 0 with K(1/(1+beta)) = pi sqrt(1+beta); it lies between the fractions, and agm(sqrt(1+beta), sqrt(beta)) = 1/2. *)
Definition beta_lies_between (least greatest unit : Z) : Prop := exists beta : R,
  (IZR least / IZR unit <= beta <= IZR greatest / IZR unit) /\
  0 < beta /\
  RInt (fun t => 1 / sqrt (1 - 1/(1+beta) * sin t ^2)) 0 (PI/2) = PI * sqrt (1+beta) /\
  is_lim_seq (fun n => fst (agm n (sqrt (1+beta)) (sqrt beta))) (1/2) /\
  forall c, 0 < c -> RInt (fun t => 1 / sqrt (1 - 1/(1+c) * sin t ^2)) 0 (PI/2) = PI * sqrt (1+c) -> c = beta.

Theorem digits : beta_lies_between (AgmCertificate.least _ BetaDigits.beta_certificate)
  (AgmCertificate.greatest _ BetaDigits.beta_certificate) (AgmCertificate.unit _ BetaDigits.beta_certificate).
Proof. exact BetaDigits.beta_digits. Qed.

Theorem many_digits : beta_lies_between (BigZ.to_Z (AgmCertificate.least _ BetaManyDigits.beta_certificate))
  (BigZ.to_Z (AgmCertificate.greatest _ BetaManyDigits.beta_certificate))
  (BigZ.to_Z (AgmCertificate.unit _ BetaManyDigits.beta_certificate)).
Proof. exact BetaManyDigits.beta_digits. Qed.

Check BetaDigits.beta_digits.
Check BetaDigits.beta_width.
Print BetaDigits.beta_certificate.
Check BetaManyDigits.beta_digits.
