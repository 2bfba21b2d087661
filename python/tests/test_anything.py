"""Whatever is handed over, the answer is a value or an exception, and never a crash."""

import doctest
import fractions
import math
import random

import pytest

import polhode
from polhode import _polhode, ball

THINGS = [None, True, 0, 1, -1, 7, 2**70, -(10**30), 0.5, -3.0, math.nan, math.inf, -math.inf, "x",
          "", "sin(x)", "1/3", "-0.1", "inf", "nan", "pi", "((", [], {}, (), object(), b"x",
          fractions.Fraction(1, 3), ball(2), ball("0.1", 20), ball.hull_of(-1, 1),
          ball(0) / ball(0), polhode.complex_ball(1, "0.5"), 1 + 2j, [1, ball(2)], (0, (1, 1)),
          {"k": (1, 2)}, polhode.Path.circle(), polhode.pi, polhode.Symbol, lambda x: x,
          lambda x: 1 / (x - x),
          lambda: 1, polhode.sin]
NUMBERS = list(polhode.functions)


@pytest.mark.parametrize("seed", range(20))
def test_functions_of_anything(seed):
    source = random.Random(seed)
    for _ in range(200):
        f = getattr(polhode, source.choice(NUMBERS))
        arguments = [source.choice(THINGS) for _ in range(source.choice([0, 1, 1, 1, 2, 2, 3]))]
        try:
            str(f(*arguments))
        except (TypeError, ValueError, OverflowError, ZeroDivisionError):
            pass


@pytest.mark.parametrize("seed", range(20))
def test_operators_of_anything(seed):
    source = random.Random(seed)
    operations = [lambda x, y: x + y, lambda x, y: x - y, lambda x, y: x * y, lambda x, y: x / y,
                  lambda x, y: x < y, lambda x, y: x == y, lambda x, y: x >= y,
                  lambda x, y: format(x, str(y)), lambda x, y: ball(x, y),
                  lambda x, y: ball.hull_of(x, y), lambda x, y: ball(x).contains(y)]
    for _ in range(200):
        try:
            str(source.choice(operations)(source.choice(THINGS), source.choice(THINGS)))
        except (TypeError, ValueError, OverflowError, ZeroDivisionError):
            pass


@pytest.mark.parametrize("seed", range(10))
def test_computations_of_anything(seed):
    source = random.Random(seed)
    limit = {"time_limit": 0.2}
    computations = [lambda x, y, z: polhode.integrate(x, y, z, 5, **limit),
                    lambda x, y, z: polhode.roots(x, y, z, 5, **limit),
                    lambda x, y, z: polhode.eval(x, 5, **limit),
                    lambda x, y, z: polhode.integrate_along(x, y, 5, **limit),
                    lambda x, y, z: polhode.integrate_along(x, [y, z], 5, **limit),
                    lambda x, y, z: polhode.integrate_box(x, y, 1, z, 5, **limit),
                    lambda x, y, z: polhode.complex_ball(x, y).contains(z),
                    lambda x, y, z: polhode.formula(x)(y),
                    lambda x, y, z: polhode.solve_system([x], [(y, z)], digits=5, **limit),
                    lambda x, y, z: polhode.solve_system(x, y, z)]
    for _ in range(30):
        try:
            repr(source.choice(computations)(*(source.choice(THINGS) for _ in range(3))))
        except (TypeError, ValueError, OverflowError, ZeroDivisionError, TimeoutError):
            pass


def test_the_examples_of_the_docstrings():
    parser = doctest.DocTestParser()
    runner = doctest.DocTestRunner()
    examples = 0
    for name in dir(_polhode):
        text = getattr(getattr(_polhode, name), "__doc__", None) or ""
        test = parser.get_doctest(text, {}, name, None, None)
        examples += len(test.examples)
        runner.run(test)
    assert examples >= 8 and runner.failures == 0
