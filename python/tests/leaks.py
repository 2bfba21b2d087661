"""What the package does, fifty times: for the leak sanitizer, which then reports nothing.

    cmake --preset asan+ubsan && cmake --build build/asan+ubsan --target polhode_python
    PYTHONPATH=build/asan+ubsan/python PYTHONMALLOC=malloc ASAN_OPTIONS=detect_leaks=1 \\
      LD_PRELOAD="$(gcc -print-file-name=libasan.so) $(gcc -print-file-name=libubsan.so)" \\
      /usr/bin/python3 python/tests/leaks.py
"""

import gc

import polhode


def refused(f, *arguments):
    """Calls f, which has to raise an exception."""
    try:
        f(*arguments)
    except (TypeError, ValueError):
        return
    raise AssertionError(f"{f} took {arguments}")


def once():
    x = polhode.ball("0.1", 30)
    y = (x + 1) * polhode.exp(x) / 3
    assert str(y) and y.decimals(10) and y.mid and y < 2
    polhode.gamma(polhode.complex_ball(1, 2))
    refused(polhode.ball, 0.1)
    refused(polhode.integrate, "((", 0, 1)
    found = polhode.integrate(lambda t: polhode.exp(-t * t), 0, 1, 20)
    assert found.account and found.certificate()
    roots = polhode.roots("x^2-2", 0, 2, 20)
    assert [str(root) for root in roots] and roots.certificate()
    polhode.solve_system(["x^2+y^2-1", "x-y"], [(-2, 2), (-2, 2)], digits=10)
    polhode.complex_roots("z^3-1", digits=10)
    polhode.integrate_along("1/z", [1, "i", -1], 10)
    polhode.integrate_box("k*x", 0, 1, {"k": (1, 2)}, 5)
    polhode.formula("sin(x)")(x)
    polhode.sin([1, 2])


for _ in range(50):
    once()
gc.collect()
