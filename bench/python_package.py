#!/usr/bin/env python3
"""The Python package beside mpmath, and beside python-flint where it is installed.

    PYTHONPATH=build/release/python /usr/bin/python3 bench/python_package.py [--digits 15,50,100]

Prints the time to import, what Python adds to an operation and to an integral, and a table for each
number of digits: the least time of some rounds for Polhode and its peers, and their ratio. Polhode's
answers are proved; mpmath's are estimates. Each is told the same function, as its users write it.
"""

import argparse
import math
import os
import subprocess
import sys
import time

import mpmath

import polhode

try:
    import flint
except ImportError:
    flint = None

ROUNDS = 4


def least_time(f, least=0.01):
    """The seconds of a call of f: the least mean of some rounds, each of at least `least` s."""
    f()
    calls = 1
    while True:
        start = time.perf_counter()
        for _ in range(calls):
            f()
        took = time.perf_counter() - start
        if took >= least:
            break
        calls = max(2 * calls, math.ceil(calls * least / max(took, 1e-9)))
    best = took / calls
    for _ in range(ROUNDS - 1):
        start = time.perf_counter()
        for _ in range(calls):
            f()
        best = min(best, (time.perf_counter() - start) / calls)
    return best


def shown(seconds):
    """A time with its unit, of three digits."""
    for unit, size in (("s", 1), ("ms", 1e-3), ("us", 1e-6)):
        if seconds >= size:
            return f"{seconds / size:.3g} {unit}"
    return f"{seconds / 1e-9:.3g} ns"


def functions(digits):
    """Name, and the same value by Polhode and by mpmath; by flint where it has it."""
    x, y = polhode.ball("1.2345", digits), polhode.ball("0.6789", digits)
    p, q = mpmath.mpf("1.2345"), mpmath.mpf("0.6789")
    third = polhode.ball("0.321", digits)
    r = mpmath.mpf("0.321")
    one = polhode.ball(1, digits)
    rows = [("x*y", lambda: x * y, lambda: p * q, "x*y"),
            ("exp", lambda: polhode.exp(x), lambda: mpmath.exp(p), "exp"),
            ("log", lambda: polhode.log(x), lambda: mpmath.log(p), "log"),
            ("sin", lambda: polhode.sin(x), lambda: mpmath.sin(p), "sin"),
            ("atan", lambda: polhode.atan(x), lambda: mpmath.atan(p), "atan"),
            ("gamma", lambda: polhode.gamma(x), lambda: mpmath.gamma(p), "gamma"),
            ("erf", lambda: polhode.erf(y), lambda: mpmath.erf(q), "erf"),
            ("ellipk", lambda: polhode.ellipticK(y), lambda: mpmath.ellipk(q), None),
            ("elliprj", lambda: polhode.carlsonRJ(x, y, third, one),
             lambda: mpmath.elliprj(p, q, r, 1), None)]
    result = []
    for name, ours, theirs, of_flint in rows:
        peer = None
        if flint and of_flint:
            a, b = flint.arb("1.2345"), flint.arb("0.6789")
            peer = {"x*y": lambda: a * b, "erf": lambda: b.erf()}.get(
                of_flint, lambda a=a, of_flint=of_flint: getattr(a, of_flint)())
        result.append((name, ours, theirs, peer))
    return result


def computations(digits):
    """Integrals and roots, as users write them."""
    m, o = mpmath, polhode
    inf = mpmath.inf
    integrals = [
        ("4/(1+x^2), 0..1", lambda x: 4 / (1 + x * x), 0, 1, lambda x: 4 / (1 + x * x), [0, 1]),
        ("exp(-x^2), 0..oo", lambda x: o.exp(-x * x), 0, o.oo, lambda x: m.exp(-x * x), [0, inf]),
        ("sin(x+exp(x)), 0..8", lambda x: o.sin(x + o.exp(x)), 0, 8,
         lambda x: m.sin(x + m.exp(x)), list(range(9))),
        ("sqrt(x)*log(x), 0..1", lambda x: o.sqrt(x) * o.log(x), 0, 1,
         lambda x: m.sqrt(x) * m.log(x), [0, 1]),
        ("1/sqrt(1-x^2/2) etc., 0..1", lambda x: 1 / o.sqrt((1 - x * x / 2) * (2 - x)), 0, 1,
         lambda x: 1 / m.sqrt((1 - x * x / 2) * (2 - x)), [0, 1])]
    rows = [(f"quad {name}", lambda f=f, a=a, b=b: polhode.integrate(f, a, b, digits),
             lambda g=g, ends=ends: mpmath.quad(g, ends), None)
            for name, f, a, b, g, ends in integrals]
    roots = [("cos(x)-x", lambda x: o.cos(x) - x, lambda x: m.cos(x) - x, 0, 1, 0.7),
             ("exp(x)-3*x", lambda x: o.exp(x) - 3 * x, lambda x: m.exp(x) - 3 * x, 0, 1, 0.6),
             ("tan(x)-x", lambda x: o.tan(x) - x, lambda x: m.tan(x) - x, 4, "9/2", 4.49)]
    rows += [(f"root of {name}", lambda f=f, a=a, b=b: polhode.roots(f, a, b, digits),
              lambda g=g, start=start: mpmath.findroot(g, start), None)
             for name, f, g, a, b, start in roots]
    return rows


def overhead():
    """What Python adds: the time to import, that of an operation, and beside an integral's own."""
    code = "import time; start = time.perf_counter(); import polhode; print(time.perf_counter() - start)"
    times = [float(subprocess.run([sys.executable, "-c", code], capture_output=True, text=True,
                                  check=True, env=os.environ).stdout) for _ in range(ROUNDS)]
    print(f"import polhode: {shown(min(times))} (limit 100 ms)")
    x, y = polhode.ball("1.2345", 15), polhode.ball("0.6789", 15)
    print(f"x*y of balls, with all that C++ does: {shown(least_time(lambda: x * y))} (limit 5 us)")
    shares = []
    for digits in (100, 200, 300):
        def integral():
            return polhode.integrate("sin(x+exp(x))", 0, 8, digits)
        integral()
        for _ in range(ROUNDS):
            start = time.perf_counter()
            answer = integral()
            whole = time.perf_counter() - start
            shares.append((whole / answer.account["seconds"] - 1, whole))
    least, whole = min(shares)
    print(f"an integral of {shown(whole)}: {100 * least:.2f} % over C++ (limit 3 %)\n")


def compare(digits):
    """Prints the table of so many digits; returns the ratios of mpmath's times to Polhode's."""
    mpmath.mp.dps = digits
    if flint:
        flint.ctx.dps = digits
    print(f"{digits} digits" + " " * 30 + "Polhode    mpmath   ratio" +
          ("     flint   ratio" if flint else ""))
    ratios = []
    for name, ours, theirs, peer in functions(digits) + computations(digits):
        own, other = least_time(ours), least_time(theirs)
        ratios.append(other / own)
        line = f"  {name:32}{shown(own):>12}{shown(other):>10}{other / own:8.2f}"
        if peer:
            third = least_time(peer)
            line += f"{shown(third):>10}{third / own:8.2f}"
        print(line, flush=True)
    mean = math.exp(sum(map(math.log, ratios)) / len(ratios))
    print(f"  geometric mean of the ratios to mpmath: {mean:.1f}; the least: {min(ratios):.2f}\n")
    return ratios


def main():
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--digits", default="15,50,100,1000")
    arguments = parser.parse_args()
    overhead()
    for digits in arguments.digits.split(","):
        compare(int(digits))


if __name__ == "__main__":
    main()
