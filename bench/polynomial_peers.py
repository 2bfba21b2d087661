#!/usr/bin/env python3
"""Times the roots of polynomials beside PARI's polrootsreal and MPSolve, to 30 digits.

    bench/polynomial_peers.py [POLHODE] [--most-seconds S]

Needs Debian's pari-gp and mpsolve. Each program is run as a process of its own, which reads the
coefficients; the least of three runs counts, less the time of the program for x - 1. A ratio below
1 means that Polhode is faster; there is none where either takes less than a millisecond.
"""

import argparse
import math
import pathlib
import random
import subprocess
import tempfile
import time
from fractions import Fraction

DIGITS = 30


def times(p, q):
    result = [0] * (len(p) + len(q) - 1)
    for i, a in enumerate(p):
        for j, b in enumerate(q):
            result[i + j] += a * b
    return result


def power(p, n):
    result = [1]
    for _ in range(n):
        result = times(result, p)
    return result


def plus(p, q):
    n = max(len(p), len(q))
    return [(p[i] if i < len(p) else 0) + (q[i] if i < len(q) else 0) for i in range(n)]


def chebyshev(n):
    a, b = [1], [0, 1]
    for _ in range(n - 1):
        a, b = b, plus(times([0, 2], b), [-x for x in a])
    return b


def wilkinson(n):
    p = [1]
    for k in range(1, n + 1):
        p = times(p, [-k, 1])
    return p


def mignotte(n):
    return plus([0] * n + [1], [-2 * x for x in power([-1, 10 ** 10], 2)])


def divided(p, q):
    """The quotient of p by the monic q, which divides it."""
    p, result = p[:], []
    while len(p) >= len(q):
        lead = p[-1]
        result.append(lead)
        for i in range(len(q)):
            p[len(p) - len(q) + i] -= lead * q[i]
        p.pop()
    return result[::-1]


def cyclotomic(n):
    p = [-1] + [0] * (n - 1) + [1]
    for d in range(1, n):
        if n % d == 0:
            p = divided(p, cyclotomic(d))
    return p


def kameny(k):
    """((c x)^2 - 3)^2 + (c x)^2 x^7, c = 10^k: two pairs of roots near +-sqrt(3)/c."""
    c = 10 ** k
    return plus(power([-3, 0, c * c], 2), [0] * 9 + [c * c])


def bernoulli(n):
    numbers = [Fraction(1)]
    for m in range(1, n + 1):
        numbers.append(-sum(math.comb(m + 1, k) * numbers[k] for k in range(m)) / (m + 1))
    p = [math.comb(n, k) * numbers[n - k] for k in range(n + 1)]
    scale = math.lcm(*(Fraction(x).denominator for x in p))
    return [int(x * scale) for x in p]


def dense(n):
    source = random.Random(n)
    return [source.randint(-2 ** 30, 2 ** 30) or 1 for _ in range(n + 1)]


def expression(p):
    return "+".join(f"({c})*x^{k}" for k, c in enumerate(p) if c)


def seconds(command, text, most):
    best = math.inf
    for _ in range(3):
        start = time.perf_counter()
        try:
            done = subprocess.run(command, input=text, text=True, capture_output=True, timeout=most,
                                  check=False)
        except subprocess.TimeoutExpired:
            return math.inf
        if done.returncode != 0:
            raise SystemExit(f"{command[0]} ended with {done.returncode}: {done.stderr[:300]}")
        best = min(best, time.perf_counter() - start)
    return best


def polhode(program, p, kind):
    end = ["--complex"] if kind == "complex" else ["--in=-inf..inf"]
    return [program, "roots", expression(p), *end, "--digits", str(DIGITS)], ""


def pari(p, kind):
    roots = "polrootsreal" if kind == "real" else "polroots"
    return (["gp", "-fq"], f"default(realprecision,{DIGITS});default(parisize,\"1G\");\n"
                           f"print(#{roots}(Polrev({p})));\n")


def mpsolve(p, directory):
    file = pathlib.Path(directory) / "polynomial.txt"
    file.write_text("Monomial;\nDegree=%d;\nInteger;\nReal;\nDense;\n\n%s\n"
                    % (len(p) - 1, " ".join(str(c) for c in p)), encoding="utf-8")
    return ["mpsolve", "-Ga", f"-o{DIGITS}", str(file)], ""


def shown(x):
    if x == math.inf:
        return "> limit"
    return f"{1000 * x:.0f} ms" if x >= 0.001 else "< 1 ms"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("polhode", nargs="?", default="build/release/polhode")
    parser.add_argument("--most-seconds", type=float, default=60)
    options = parser.parse_args()
    cases = [("T_100", chebyshev(100)), ("T_200", chebyshev(200)), ("T_500", chebyshev(500)),
             ("Wilkinson 50", wilkinson(50)), ("Wilkinson 200", wilkinson(200)),
             ("Mignotte 50", mignotte(50)), ("Mignotte 100", mignotte(100)),
             ("cyclotomic 151", cyclotomic(151)), ("cyclotomic 420", cyclotomic(420)),
             ("Kameny 10", kameny(10)), ("Bernoulli 100", bernoulli(100)),
             ("Bernoulli 200", bernoulli(200)),
             ("dense 100", dense(100)), ("dense 200", dense(200)), ("dense 500", dense(500))]
    with tempfile.TemporaryDirectory() as directory:
        def measured(make):
            idle = seconds(*make([-1, 1]), options.most_seconds)
            return lambda p: max(seconds(*make(p), options.most_seconds) - idle, 1e-4)
        for kind, peers in [("real", [("PARI", lambda p: pari(p, "real"))]),
                            ("complex", [("MPSolve", lambda p: mpsolve(p, directory)),
                                         ("PARI", lambda p: pari(p, "complex"))])]:
            ours = measured(lambda p: polhode(options.polhode, p, kind))
            others = [(name, measured(make)) for name, make in peers]
            print(f"all {kind} roots to {DIGITS} digits")
            print(f"{'':16}{'Polhode':>10}" + "".join(f"{name:>10}{'ratio':>8}"
                                                      for name, _ in others), flush=True)
            for name, p in cases:
                own = ours(p)
                line = f"{name:16}{shown(own):>10}"
                for _, time_of in others:
                    peer = time_of(p)
                    is_measured = math.inf not in (own, peer) and min(own, peer) >= 0.001
                    ratio = f"{own / peer:.2f}" if is_measured else ""
                    line += f"{shown(peer):>10}{ratio:>8}"
                print(line, flush=True)


if __name__ == "__main__":
    main()
