"""Whatever is handed over, the answer is a value or an exception, and never a crash: 10,000 cases
over the whole surface, by hypothesis."""

import decimal
import doctest
import math

import pytest

import polhode
from polhode import _polhode, ball

pytest.importorskip("hypothesis")
from hypothesis import HealthCheck, given, settings, strategies as some  # noqa: E402

REFUSALS = (TypeError, ValueError, OverflowError, ZeroDivisionError, TimeoutError, IndexError,
            KeyError)
FUNCTIONS = list(polhode.functions)
WORDS = ["x", "z", "i", "pi", "e", "inf", "-inf", "nan", "((", "", "1/3", "-0.1", "1e999999999",
         "sin(x)", "1/x", "x^2-2", "exp(-x^2)", "sqrt(x)*log(x)", "gamma(z)", "floor(x)", "x = 2",
         "x y", "2**3", "0/0", "\0", "é", "abs(x)-1", "tan(z)-z", "1/(1+x^2)", "x!", "\n"]


def in_order(ends):
    """The ball between two numbers."""
    return ball.hull_of(min(ends), max(ends))


EXACT = some.one_of(some.integers(-9, 9), some.integers(-2**70, 2**70),
                    some.fractions(max_denominator=10**6),
                    some.decimals(allow_nan=True, allow_infinity=True))
BALLS = some.one_of(
    some.builds(ball, some.integers(-99, 99), some.integers(1, 60)),
    some.builds(in_order, some.tuples(some.integers(-9, 9), some.integers(-9, 9))),
    some.just(ball(0) / ball(0)), some.just(polhode.sqrt(ball(2))))
COMPLEX = some.one_of(some.builds(polhode.complex_ball, BALLS, BALLS),
                      some.complex_numbers(allow_nan=True))
LAMBDAS = some.sampled_from([
    lambda x: x, lambda x: 1 / (x - x), lambda: 1, lambda x, y: x + y, lambda *all: 2,
    lambda x: math.sin(x), lambda x: 1 if x > 0 else 2, lambda x: None, lambda x: x ** x,
    lambda x: [x], lambda x: polhode.exp(polhode.exp(x)), len, polhode.sin])
OBJECTS = some.sampled_from([
    object(), polhode.Symbol, polhode.pi, polhode.oo, ball, polhode.Path.circle(),
    polhode.formula("sin(x)/x"), polhode.integrate("exp(x)", 0, 1, 5),
    polhode.integrate("1/x", 0, 1, 5), polhode.integrate_along("1/z", [1, "i"], 5),
    polhode.integrate_box("k*x", 0, 1, {"k": (1, 2)}, 5), polhode.roots("x^2-2", 0, 2, 5),
    polhode.roots("sin(x)", 0, polhode.oo, 5), polhode.roots("x^2-2", 0, 2, 5)[0],
    polhode.complex_roots("z^3-1", digits=5), polhode.complex_roots("z^3-1", digits=5)[0],
    polhode.solve_system(["x^2-2"], [(0, 2)], digits=5)])
PLAIN = some.one_of(some.none(), some.booleans(), EXACT, some.floats(), some.sampled_from(WORDS),
                    some.text(max_size=8), some.binary(max_size=4), BALLS, COMPLEX, LAMBDAS,
                    OBJECTS)
THINGS = some.recursive(
    PLAIN, lambda part: some.one_of(some.lists(part, max_size=3), some.tuples(part, part),
                                    some.dictionaries(some.sampled_from(["k", "x", ""]), part,
                                                      max_size=2)), max_leaves=4)


def cases(count):
    """So many cases, the same each time."""
    return settings(max_examples=count, deadline=None, derandomize=True, database=None,
                    suppress_health_check=list(HealthCheck))


@cases(4000)
@given(some.sampled_from(FUNCTIONS), some.lists(THINGS, max_size=3))
def test_functions_of_anything(name, arguments):
    try:
        str(getattr(polhode, name)(*arguments))
    except REFUSALS:
        pass


OPERATIONS = [lambda x, y: x + y, lambda x, y: x - y, lambda x, y: x * y, lambda x, y: x / y,
              lambda x, y: x < y, lambda x, y: x == y, lambda x, y: x >= y, lambda x, y: x != y,
              lambda x, y: -x, lambda x, y: abs(x), lambda x, y: bool(x), lambda x, y: float(x),
              lambda x, y: complex(x), lambda x, y: x ** y if -99 < y < 99 else x,
              lambda x, y: format(x, str(y)), lambda x, y: ball(x, y), lambda x, y: x[y],
              lambda x, y: ball.hull_of(x, y), lambda x, y: ball(x).contains(y),
              lambda x, y: polhode.certainly_less(x, y), lambda x, y: polhode.complex_ball(x, y)]


@cases(3000)
@given(some.sampled_from(OPERATIONS), THINGS, THINGS)
def test_operators_of_anything(operation, x, y):
    try:
        str(operation(x, y))
    except (*REFUSALS, AttributeError, decimal.InvalidOperation):
        pass


@cases(2200)
@given(some.one_of(OBJECTS, BALLS, COMPLEX), some.integers(0, 99), some.lists(THINGS, max_size=3))
def test_members_of_anything(thing, which, arguments):
    names = [name for name in dir(type(thing)) if name not in ("__class__", "__new__", "__init__")]
    name = names[which % len(names)]
    try:
        member = getattr(thing, name)
        str(member(*arguments) if callable(member) else member)
    except (*REFUSALS, AttributeError):
        pass


LIMIT = {"time_limit": 0.1}
COMPUTATIONS = [
    lambda x, y, z: polhode.integrate(x, y, z, 5, **LIMIT),
    lambda x, y, z: polhode.integrate(x, 0, 1, 5, rule=y, progress=z, **LIMIT),
    lambda x, y, z: polhode.integrate(x, 0, 1, 5, threads=y, absolute_exponent=z, **LIMIT),
    lambda x, y, z: polhode.roots(x, y, z, 5, **LIMIT),
    lambda x, y, z: polhode.roots(x, 0, 1, y, threads=z, **LIMIT),
    lambda x, y, z: polhode.eval(x, 5, **LIMIT),
    lambda x, y, z: polhode.eval("pi", x, time_limit=y),
    lambda x, y, z: polhode.integrate_along(x, y, 5, **LIMIT),
    lambda x, y, z: polhode.integrate_along(x, [y, z], 5, **LIMIT),
    lambda x, y, z: polhode.integrate_box(x, y, 1, z, 5, **LIMIT),
    lambda x, y, z: polhode.integrate_box(x, 0, 1, {"k": y}, 5, **LIMIT),
    lambda x, y, z: polhode.complex_ball(x, y).contains(z),
    lambda x, y, z: polhode.complex_roots(x, y, 5, **LIMIT),
    lambda x, y, z: polhode.complex_roots(x, (y, z), 5, **LIMIT),
    lambda x, y, z: polhode.formula(x)(y),
    lambda x, y, z: polhode.Path.arc(x, y, 0, z),
    lambda x, y, z: polhode.solve_system([x], [(y, z)], digits=5, **LIMIT),
    lambda x, y, z: polhode.solve_system(x, y, z, **LIMIT)]


@cases(600)
@given(some.sampled_from(COMPUTATIONS), THINGS, THINGS, THINGS)
def test_computations_of_anything(computation, x, y, z):
    try:
        repr(computation(x, y, z))
    except REFUSALS:
        pass


# Formulas that are often read, and ends of ranges.
FORMULAS = some.recursive(
    some.sampled_from(["x", "1", "2", "1/3", "pi", "e", "k"]),
    lambda part: some.one_of(
        some.builds("({} {} {})".format, part, some.sampled_from("+-*/^"), part),
        some.builds("{}({})".format, some.sampled_from(FUNCTIONS), part)), max_leaves=5)
ENDS = some.one_of(some.integers(-3, 3), some.sampled_from(["inf", "-inf", "pi", "1/2", "sqrt(2)"]))
OF_FORMULAS = [
    lambda f, g, a, b: polhode.integrate(f, a, b, 5, **LIMIT),
    lambda f, g, a, b: polhode.integrate(f, a, b, 5, **LIMIT).certificate(**LIMIT),
    lambda f, g, a, b: polhode.roots(f, a, b, 5, **LIMIT),
    lambda f, g, a, b: polhode.roots(f, a, b, 5, **LIMIT).certificate(**LIMIT),
    lambda f, g, a, b: polhode.eval(f.replace("x", "2"), 5, **LIMIT),
    lambda f, g, a, b: polhode.integrate_along(f.replace("x", "z"), [a, (b, 1), g], 5, **LIMIT),
    lambda f, g, a, b: polhode.integrate_box(f, a, b, {"k": (1, 2)}, 5, **LIMIT),
    lambda f, g, a, b: polhode.complex_roots(f.replace("x", "z"), ((-2, -1), (2, 1)), 5, **LIMIT),
    lambda f, g, a, b: polhode.solve_system([f, g], [(a, 2), (-1, b)], ["x", "k"], 5, **LIMIT),
    lambda f, g, a, b: polhode.solve_system([f, g], [(-2, 2), (-1, 1)], ["x", "k"], 5,
                                            **LIMIT).certificate(**LIMIT)]


@cases(800)
@given(some.sampled_from(OF_FORMULAS), FORMULAS, FORMULAS, ENDS, ENDS)
def test_computations_of_formulas(computation, f, g, a, b):
    try:
        repr(computation(f, g, a, b))
    except REFUSALS:
        pass


COMMANDS = [lambda x, y: polhode.Body(moments=x).describe(),
            lambda x, y: polhode.Body(tensor=x).describe(),
            lambda x, y: polhode.Body(ab=[x, y]).racket(digits=5),
            lambda x, y: polhode.Body(moments=[3, 2, 1]).phase(x, digits=y),
            lambda x, y: polhode.Body(moments=[3, 2, 1]).table(points=x),
            lambda x, y: polhode.Scene.from_dict({"body": x, "state": y}).run(),
            lambda x, y: polhode.Scene.from_text(x).run(),
            lambda x, y: polhode.constants(x, digits=y), lambda x, y: polhode.check(x, y),
            lambda x, y: polhode.table(x, moments=y)]


@cases(200)
@given(some.sampled_from(COMMANDS), THINGS, THINGS)
def test_commands_of_anything(command, x, y):
    try:
        repr(command(x, y))
    except (*REFUSALS, AttributeError):
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
