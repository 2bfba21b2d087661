"""Balls: exact numbers in, enclosures out, and no silent floats."""

import decimal
import fractions
import pickle
import random

import pytest

import polhode
from polhode import ball

F = fractions.Fraction


def holds(x, q):
    """The ball holds the Fraction."""
    return x.lower <= q <= x.upper


def test_is_made_of_exact_numbers():
    for given, value in [(2, F(2)), (F(1, 3), F(1, 3)), (decimal.Decimal("0.1"), F(1, 10)),
                         ("0.1", F(1, 10)), ("-1/7", F(-1, 7)), (10**400, F(10**400)),
                         (-(2**70), F(-(2**70))), (3.0, F(3))]:
        x = ball(given)
        assert holds(x, value)
        assert x.rad <= abs(value) / 10**50


def test_refuses_floats_that_are_no_integers():
    for f in [lambda: ball(0.1), lambda: ball(1) + 0.1, lambda: 0.1 * ball(1),
              lambda: ball(1) < 0.1, lambda: polhode.exp(0.1), lambda: ball(float("nan")),
              lambda: ball(float("inf"))]:
        with pytest.raises(TypeError, match="float"):
            f()
    assert ball.exactly(0.1).mid == F(0.1)
    for wrong in [None, [], {}, object(), "abc", "", "1/0", True]:
        with pytest.raises((TypeError, ValueError)):
            ball(wrong)
    for digits in [0, -1, 10**9]:
        with pytest.raises(ValueError):
            ball(1, digits)


def test_takes_numbers_of_mpmath_and_numpy():
    mpmath = pytest.importorskip("mpmath")
    numpy = pytest.importorskip("numpy")
    assert ball(mpmath.mpf("0.5")).mid == F(1, 2)
    assert ball(-mpmath.mpf(3) * 2**80).mid == -3 * 2**80
    assert ball(numpy.int64(-7)).mid == -7
    with pytest.raises(TypeError):
        ball(mpmath.inf)


def test_arithmetic_holds_that_of_fractions():
    source = random.Random(1)
    for _ in range(300):
        p, q = (F(source.randint(-99, 99), source.randint(1, 99)) for _ in range(2))
        x, y = ball(p, 30), ball(q, 30)
        assert holds(x + y, p + q) and holds(x - q, p - q) and holds(p * y, p * q)
        assert holds(p - y, p - q) and holds(2 + y, 2 + q)
        assert holds(-x, -p) and holds(abs(x), abs(p))
        if q:
            assert holds(x / y, p / q) and holds(1 / y, 1 / q)
        assert holds(x**3, p**3)
        if p:
            assert holds(x**-2, p**-2)


def test_division_by_what_may_be_zero_is_undefined():
    assert (ball(1) / ball.hull_of(-1, 1)).is_undefined


def test_comparisons_raise_where_undecided():
    wide = ball.hull_of(0, 1)
    assert ball(1) < 2 and not ball(3) <= 2 and ball(2) == 2 and ball(2) != 3
    assert wide < 2 and wide >= 0 and not wide > 1
    for f in [lambda: wide < F(1, 2), lambda: wide == F(1, 2), lambda: wide > 0,
              lambda: bool(wide), lambda: ball(F(1, 3)) == F(1, 3)]:
        with pytest.raises(polhode.Undecided):
            f()
    assert polhode.certainly_less(wide, 2) and not polhode.certainly_less(wide, 1)
    with pytest.raises(TypeError):
        hash(wide)


def test_is_shown_with_certain_digits():
    x = ball(F(1, 3), 20)
    assert str(x).startswith("0.33333333333333333333")
    assert f"{x:.5}" == "0.33333..."
    assert repr(ball(2)) == "<ball 2>"
    assert ball(F(1, 3), 10)._repr_latex_().startswith("$0.333333333")
    with pytest.raises(ValueError, match="digits"):
        f"{x:abc}"
    assert ball("0.1").digits() >= 50


def test_is_pickled():
    for x in [ball(F(1, 3)), ball.hull_of(-1, F(1, 7)), ball(2)]:
        y = pickle.loads(pickle.dumps(x))
        assert (y.lower, y.upper, y.precision) == (x.lower, x.upper, x.precision)


def test_functions_are_those_of_formulas():
    for name in polhode.functions:
        assert callable(getattr(polhode, name))
    assert holds(polhode.cbrt(27), 3) and holds(polhode.root(32, 5), 2)
    assert holds(polhode.sqrt(ball(F(9, 4))), F(3, 2))
    assert polhode.exp(1).overlaps(polhode.eval("exp(1)"))
    assert polhode.ellipticK(F(1, 2)).overlaps(polhode.eval("ellipticK(1/2)"))
    assert polhode.log(ball(-1)).is_undefined
    with pytest.raises(TypeError, match="takes 1 argument"):
        polhode.exp(1, 2)
    with pytest.raises(TypeError):
        polhode.exp("one two", None)


def test_agrees_with_mpmath():
    mpmath = pytest.importorskip("mpmath")
    mpmath.mp.dps = 60
    for name, theirs in [("exp", mpmath.exp), ("log", mpmath.log), ("atan", mpmath.atan),
                         ("gamma", mpmath.gamma), ("erf", mpmath.erf), ("tanh", mpmath.tanh)]:
        for q in [F(1, 3), F(7, 5), F(9)]:
            x = getattr(polhode, name)(q)
            value = theirs(mpmath.mpf(q.numerator) / q.denominator)
            assert abs(F(x.mid) - ball(value).mid) < F(1, 10**48) * max(1, abs(x.mid))


def test_formats_are_a_width_and_digits():
    x = ball(2)
    assert f"{x:.3}" == "2"
    assert f"{ball('1/3', digits=30):.3}" == "0.333..."
    assert f"{ball('1/3', digits=30):>10.3}" == "  0.333..."
    assert f"{ball('1/3', digits=30):*<10.3}" == "0.333...**"
    assert f"{x:>4}" == "   2" and f"{x:4}" == "2   "
    for wrong in [".", ".x", ">.x", "q3.2", ".3f", ".9999999999"]:
        with pytest.raises(ValueError, match="width"):
            format(x, wrong)
