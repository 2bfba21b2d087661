# What scripts/check-coq makes of the axioms that Coq prints: an axiom beyond those allowed, or a line that is not understood, fails.
#   bash coq_axioms.bash scripts/lib/coq.sh
set -euo pipefail
source "$1"
file=$(mktemp)
trap 'rm -f "$file"' EXIT
allowed='Reals\.sig_dec|Classical\.classic'
good='Axioms:
Reals.sig_dec : forall P : nat -> Prop, P 0
Classical.classic : forall P : Prop, P \/ ~ P'

takes() {
  printf '%s\n' "$2" >"$file"
  expect_axioms "$file" "$1" "$allowed" >/dev/null
}
must_take() { takes "$@" || { echo "refused: $2" && exit 1; }; }
must_refuse() { ! takes "$@" || { echo "taken: $2" && exit 1; }; }

must_take 1 "$good"
must_take 1 'Closed under the global context'
must_take 2 "$good
Closed under the global context"
must_take 1 "Fetching opaque proofs from disk for Coq.Reals.Rseries
$good"
must_refuse 1 ''
must_refuse 2 "$good"
must_refuse 1 "$good
Closed under the global context"
for more in 'cheat : False' 'cheat' 'Reals.sig_dec2 : True' 'Reals_sig_dec : True' 'My.Reals.sig_dec : True' \
  'Reals.sig_dec cheat : False' "$(printf 'x\303\251 : False')" 'Section Variables:' 'Error: nothing' 'Set is impredicative' ''; do
  must_refuse 1 "$good
$more"
done
must_refuse 1 'Axioms:
  : False'
must_refuse 1 'cheat : False'
# A type on lines of its own may hide another axiom.
must_refuse 1 "$good
  cheat : False"
must_refuse 1 'Axioms:
Reals.sig_dec
  : forall P : nat -> Prop, P 0'
: >"$file"
! expect_axioms "$file" 1 "$allowed" >/dev/null || { echo "an empty file is taken" && exit 1; }
! expect_axioms "$file.none" 1 "$allowed" >/dev/null 2>&1 || { echo "a missing file is taken" && exit 1; }
echo "only what is allowed is taken"
