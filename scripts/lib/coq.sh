# Sourced by scripts/check-coq, and by its test. It offers
#   page_of_statements TABLE           the page proofs/coq/paper/STATEMENTS.md, from what Coq printed as statement<row>.out
#   expect_axioms FILE COUNT PATTERN   that FILE holds what COUNT times `Print Assumptions` prints, with no axiom but those of the pattern

# Every line must be understood: an axiom with its type, or the beginning of a theorem's list. Coq
# has to print with a width that leaves no type on a line of its own (Set Printing Width). Prints
# what is not understood, and fails.
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

page_of_statements() {
  local n=0 item theorem words before=
  echo "# What Coq proves of the paper"
  echo
  echo "Each theorem as Coq prints it, after the statement of the paper that it is. \`scripts/check-coq\`"
  echo "compares this page with the compiled theories. [README.md](../README.md) explains the names."
  while IFS=$'\t' read -r item theorem words; do
    if [[ $item != "$before" ]]; then printf '\n## %s\n' "${item^}"; fi
    before=$item
    printf '\n%s `%s`:\n\n```coq\n' "$words" "$theorem"
    cat "statement$n.out"
    printf '```\n'
    n=$((n + 1))
  done <"$1"
}
