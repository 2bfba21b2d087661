"""Balls: exact numbers in, enclosures out, and no silent floats."""

import cmath
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


def test_decimals_are_rounded_outward():
    third = ball(F(1, 3), 40)
    low, high = third.decimals(20)
    assert isinstance(low, decimal.Decimal) and F(low) <= third.lower and third.upper <= F(high)
    assert high - low < decimal.Decimal("1e-19")
    assert ball("0.25").decimals() == (decimal.Decimal("0.25"), decimal.Decimal("0.25"))
    with pytest.raises(ValueError, match="bounded"):
        (ball(1) / ball(0)).decimals()


def test_is_pickled():
    for x in [ball(F(1, 3)), ball.hull_of(-1, F(1, 7)), ball(2)]:
        for protocol in range(2, pickle.HIGHEST_PROTOCOL + 1):
            y = pickle.loads(pickle.dumps(x, protocol=protocol))
            assert (y.lower, y.upper, y.precision) == (x.lower, x.upper, x.precision)
    for protocol in (0, 1):
        with pytest.raises(TypeError, match="protocol 2"):
            pickle.dumps(ball(2), protocol=protocol)
    with pytest.raises(TypeError, match="pickle"):
        pickle.dumps(polhode.Path.circle())


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


def test_complex_balls():
    z = polhode.complex_ball("0.1", 2)
    assert complex(z) == 0.1 + 2j and z.real.contains(F(1, 10)) and z.imag.is_exact
    assert (z * z).overlaps(z**2) and (1 / z * z).overlaps(1) and (z - 2j).imag.contains(0)
    assert abs(polhode.complex_ball(3, 4)).contains(5)
    assert polhode.complex_ball(0, 1).arg().overlaps(polhode.eval("pi/2", 60))
    assert z.conjugate().imag.contains(-2)
    assert polhode.complex_ball(1, 2) == 1 + 2j and polhode.complex_ball(1, 2) != 3
    assert polhode.complex_ball(ball(1), ball(2)) == polhode.complex_ball(1 + 2j)
    with pytest.raises(polhode.Undecided):
        z == polhode.complex_ball("0.1", 2)
    assert (z == "a") is False
    assert repr(polhode.complex_ball(1, -2)) == "<complex_ball 1 - 2j>"
    copy = pickle.loads(pickle.dumps(z))
    assert copy.real.lower == z.real.lower and copy.imag.upper == z.imag.upper
    for wrong in [lambda: polhode.complex_ball(0.5 + 1j), lambda: polhode.complex_ball(1j, 2),
                  lambda: polhode.complex_ball(None), lambda: z < z, lambda: hash(z),
                  lambda: z + "a", lambda: z**None, lambda: z + 0.5j]:
        with pytest.raises(TypeError):
            wrong()


def test_functions_of_complex_balls_are_their_principal_values():
    z = polhode.complex_ball("0.1", 2)
    for name in ["exp", "log", "sin", "cos", "tan", "sinh", "cosh", "tanh", "sqrt", "asin", "acos",
                 "atan", "asinh", "acosh", "atanh"]:
        value = getattr(polhode, name)(z)
        expected = getattr(cmath, name)(0.1 + 2j)
        assert abs(complex(value) - expected) < 1e-14, name
    on_circle = polhode.complex_ball(polhode.cos(ball(1)), polhode.sin(ball(1)))
    assert polhode.exp(1j).overlaps(on_circle)
    assert polhode.sqrt(polhode.complex_ball(-4)).overlaps(2j)
    across = polhode.complex_ball(-1, ball.hull_of(-1, 1))
    assert polhode.log(across).imag.contains(polhode.eval("3*pi/4", 20))
    assert polhode.log(across).imag.contains(polhode.eval("-3*pi/4", 20))
    assert polhode.gamma(z + 1).overlaps(z * polhode.gamma(z))
    assert abs(complex(polhode.erf(polhode.complex_ball(0, 1))) - 1.6504257587975429j) < 1e-15
    assert str(polhode.log_gamma(polhode.complex_ball(-1, 1))) == "undefined"
    assert polhode.formula("z^2 + 1", ["z"])(1j) == 0


def test_mpmath_takes_the_middle():
    mpmath = pytest.importorskip("mpmath")
    with mpmath.workdps(40):
        assert abs(mpmath.mpf(polhode.eval("pi", 60)) - mpmath.pi) < mpmath.mpf(10)**-38
        assert mpmath.mpf(ball(0)) == 0 and mpmath.mpf(ball(-3)) == -3
