# A certificate of beta, as `polhode certify beta --out DIR` writes it -> a Coq file that has it checked.
# --arg integers BigZ | Z
def pair: "(\(.[0]), \(.[1]))";
def pairs: if length == 0 then "[]" else "[\n    " + (map(pair) | join(";\n    ")) + "]" end;
# Decimals end with no zero: "0.0289" to 6 places is 28900.
def decimals: sub("^0\\."; "");
def whole($places): decimals
  | ($places - length) as $missing
  | (if $missing > 0 then . + ("0" * $missing) else . end)
  | sub("^0*"; "");

.witness as $w
| .numbers.beta as $beta
| ([$beta.lower, $beta.upper] | map(decimals | length) | max) as $places
| if $w.kind != "agm_bracket" then error("the witness is not an agm_bracket") else . end
| (if $integers == "Z" then "(fun z : Z => z)" else "BigZ.to_Z" end) as $value
| (if $integers == "Z" then "Z" else "BigZ.t" end) as $type
| "Require Import Reals List ZArith.
From Bignums Require Import BigZ.
From Coquelicot Require Import Coquelicot.
From Polhode Require Import AgmLimit AgmCertificate.
Import ListNotations.

Definition beta_certificate : certificate \($type) := (Build_certificate \($type)
  \($w.scale)
  \($w.below.argument) \($w.below.start | pair) \($w.below.steps | pairs)
  \($w.above.argument) \($w.above.start | pair) \($w.above.steps | pairs)
  \($beta.lower | whole($places)) \($beta.upper | whole($places)) (10 ^ \($places)))%\(if $integers == "Z" then "Z" else "bigZ" end).

Open Scope R_scope.

(** \($beta.digits) digits. *)
Theorem beta_digits : exists beta : R,
  (in_R \($type) \($value) (least _ beta_certificate) / in_R \($type) \($value) (unit _ beta_certificate) <= beta
   <= in_R \($type) \($value) (greatest _ beta_certificate) / in_R \($type) \($value) (unit _ beta_certificate)) /\\
  0 < beta /\\
  RInt (fun t => 1 / sqrt (1 - 1/(1+beta) * sin t ^2)) 0 (PI/2) = PI * sqrt (1+beta) /\\
  is_lim_seq (fun n => fst (agm n (sqrt (1+beta)) (sqrt beta))) (1/2) /\\
  forall c, 0 < c -> RInt (fun t => 1 / sqrt (1 - 1/(1+c) * sin t ^2)) 0 (PI/2) = PI * sqrt (1+c) -> c = beta.
Proof.
apply (certificate_sound_\($integers) beta_certificate).
vm_cast_no_check (eq_refl true).
Qed."
