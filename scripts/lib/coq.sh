# Sourced by scripts/check-coq, and by its test. It offers
#   expect_axioms FILE COUNT PATTERN   that FILE holds what COUNT times `Print Assumptions` prints, with no axiom but those of the pattern

# Every line must be understood: an axiom with its type, or the beginning of a theorem's list. Coq has to print with a
# width that leaves no type on a line of its own (Set Printing Width). Prints what is not understood, and fails.
expect_axioms() {
  local file=$1 count=$2 allowed=$3
  awk -v count="$count" -v allowed="^($allowed)\$" '
    function wrong(what) { print what; bad = 1 }
    /^Fetching opaque proofs from disk for [A-Za-z0-9_.]+$/ { next }
    /^Axioms:$/ { ++theorems; inside = 1; next }
    /^Closed under the global context$/ { ++theorems; inside = 0; next }
    /^[^ \t]+ : [^ \t].*$/ && inside {
      if ($1 !~ allowed) wrong("an axiom beyond those allowed: " $1)
      next
    }
    { wrong("not understood: " $0) }
    END {
      if (theorems != count) wrong(theorems + 0 " theorems in place of " count)
      exit bad
    }' "$file"
}
