# The rows of two reports of scripts/bench, $now[0] and $before[0], whose times differ by 10 % or
# more: the times of both, their ratio, and by what factor the times beside the peers' have changed,
# on which the speed of the machine has no part.

def rows:
  [to_entries[] | .key as $program | .value.benchmarks[]? | select(.real_time > 0)
   | {key: ($program + ": " + (.name | sub("/iterations:.*"; ""))), value: .}]
  | from_entries;
def machine: [to_entries[].value.context | "\(.machine), compiler \(.compiler), GMP \(.GMP), MPFR \(.MPFR)"] | unique | join("; ");
def text:
  if . < 1e3 then [., "ns"] elif . < 1e6 then [. / 1e3, "us"] elif . < 1e9 then [. / 1e6, "ms"] else [. / 1e9, "s "] end
  | (.[0] | if . < 10 then . * 100 | round / 100 elif . < 100 then . * 10 | round / 10 else round end | tostring) + " " + .[1];
def two_places: . * 100 | round / 100 | tostring;
def left(n): . + " " * (n - length);
def right(n): (" " * (n - length) // "") + .;
def beside_peers(now; before):
  [now | to_entries[] | select(.key | startswith("ratio, /")) | .key as $k | select(before[$k] != null and before[$k] > 0)
   | .value / before[$k]]
  | if length == 0 then "-" else sort | .[length / 2 | floor] | two_places end;

($now[0] | rows) as $a | ($before[0] | rows) as $b
| [$a | keys_unsorted[] | select($b[.] != null)] as $both
| ($now[0] | machine) as $machine | ($before[0] | machine) as $machine_then
| (if $machine != $machine_then then "measured elsewhere\n  now:  \($machine)\n  then: \($machine_then)" else empty end),
  ("row" | left(52)) + ("now" | right(12)) + ("then" | right(12)) + ("ratio" | right(8)) + ("beside peers" | right(14)),
  ([$both[] | . as $k | ($a[$k].real_time / $b[$k].real_time) as $r | select($r >= 1.1 or $r <= 1 / 1.1)
    | ($k | left(52)) + ($a[$k].real_time | text | right(12)) + ($b[$k].real_time | text | right(12))
      + ($r | two_places | right(8)) + (beside_peers($a[$k]; $b[$k]) | right(14))]
   | (.[], "\(length) of \($both | length) times differ by 10 % or more")),
  ([$a | keys[] | select($b[.] == null)] | if length > 0 then "new: \(length) rows" else empty end),
  ([$b | keys[] | select($a[.] == null)] | if length > 0 then "not measured now: \(length) rows" else empty end)
