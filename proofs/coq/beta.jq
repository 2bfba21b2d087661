# A certificate of beta, as `polhode certify beta --out DIR` writes it -> a Coq file that has it checked.
# --arg integers BigZ | Z, --argjson digits N: how many digits beta must have.
#
# Every text of the certificate that goes into the file is decimal digits and nothing else: no other text can become a command of Coq's.
# (No regular expression decides that: in jq's, ^ and $ match at every line of a text.)
def is_whole: type == "string" and length > 0 and length < 2000000 and (explode | all(.[]; . >= 48 and . <= 57));
def whole: if is_whole then . else error("\(tojson[:80]): it must be decimal digits") end;
def decimal:
  if type == "string" and startswith("0.") and (.[2:] | is_whole) then .[2:]
  else error("\(tojson[:80]): it must be a decimal between 0 and 1, as 0.028") end;
def pair:
  if type == "array" and length == 2 then "(\(.[0] | whole), \(.[1] | whole))"
  else error("\(tojson[:80]): it must be a pair") end;
def pairs:
  if type != "array" then error("\(tojson[:80]): it must be a list of pairs")
  elif length == 0 then "[]" else "[\n    " + (map(pair) | join(";\n    ")) + "]" end;
# Decimals end with no zero: "0.0289" to 6 places is 28900.
def to_places($places):
  ($places - length) as $missing
  | (if $missing > 0 then . + ("0" * $missing) else . end)
  | explode | until(length == 1 or .[0] != 48; .[1:]) | implode;

if $integers == "Z" or $integers == "BigZ" then . else error("integers must be Z or BigZ") end
| if ($digits | type) == "number" and $digits > 0 and $digits == ($digits | floor) and $digits < 10000000
  then . else error("digits must be a whole number") end
| .witness as $w
| .numbers.beta as $beta
| if .claim != "beta" then error("the certificate is not one of beta") else . end
| if $w.kind != "agm_bracket" then error("the witness is not an agm_bracket") else . end
| if $beta.digits == $digits then . else error("beta must have \($digits) digits") end
| ([$beta.lower, $beta.upper] | map(decimal)) as $ends
| ($ends | map(length) | max) as $places
| (if $integers == "Z" then "(fun z : Z => z)" else "BigZ.to_Z" end) as $value
| (if $integers == "Z" then "Z" else "BigZ.t" end) as $type
| "Require Import Reals List ZArith.
From Bignums Require Import BigZ.
From Coquelicot Require Import Coquelicot.
From Polhode Require Import AgmLimit AgmCertificate.
Import ListNotations.

Definition beta_certificate : certificate \($type) := (Build_certificate \($type)
  \($w.scale | whole)
  \($w.below.argument | whole) \($w.below.start | pair) \($w.below.steps | pairs)
  \($w.above.argument | whole) \($w.above.start | pair) \($w.above.steps | pairs)
  \($ends[0] | to_places($places)) \($ends[1] | to_places($places)) (10 ^ \($places)))%\(if $integers == "Z" then "Z" else "bigZ" end).

Open Scope R_scope.

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
Qed.

(** The ends above are nearer to each other than 10^-\($digits). *)
Theorem beta_width :
  ((\($value) (greatest _ beta_certificate) - \($value) (least _ beta_certificate)) * 10 ^ \($digits) < \($value) (unit _ beta_certificate))%Z.
Proof.
apply Z.ltb_lt.
vm_cast_no_check (eq_refl true).
Qed."
