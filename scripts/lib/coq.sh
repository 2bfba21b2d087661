# Sourced by scripts/check-coq, and by its test. It offers
#   expect_axioms FILE COUNT PATTERN   that FILE holds what COUNT times `Print Assumptions` prints, with no axiom but those of the pattern

# Every line must be understood: an axiom's name, a line that goes on with its type, or the beginning of a theorem's list. Prints what
# is not, and fails.
expect_axioms() {
  local file=$1 count=$2 allowed=$3
  awk -v count="$count" -v allowed="^($allowed)\$" '
    function wrong(what) { print what; bad = 1 }
    /^Fetching opaque proofs from disk for [A-Za-z0-9_.]+$/ { next }
    /^Axioms:$/ { ++theorems; inside = 1; named = 0; next }
    /^Closed under the global context$/ { ++theorems; inside = 0; next }
    /^[ \t]/ { if (!inside || !named) wrong("not understood: " $0); next }
    /^[^ \t]+( :.*)?$/ && inside {
      named = 1
      if ($1 !~ allowed) wrong("an axiom beyond those allowed: " $1)
      next
    }
    { wrong("not understood: " $0) }
    END {
      if (theorems != count) wrong(theorems + 0 " theorems in place of " count)
      exit bad
    }' "$file"
}
