"""Integrals, roots, systems and values."""

import fractions
import math
import os
import signal
import subprocess
import sys
import threading
import time

import pytest

import polhode
from polhode import ball

F = fractions.Fraction


def test_an_integral_of_a_text_and_of_a_function_are_one():
    for text, f, a, b in [
            ("exp(-x^2)", lambda x: polhode.exp(-x * x), 0, polhode.oo),
            ("sqrt(x)/(1+x)", lambda x: polhode.sqrt(x) / (1 + x), 0, 1),
            ("x^x", lambda x: x**x, 0, 1),
            ("0.1*x", lambda x: F(1, 10) * x, 0, "1/3"),
            ("1/(2+cos(x))", lambda x: 1 / (2 + polhode.cos(x)), 0, 2 * polhode.pi)]:
        one = polhode.integrate(text, a, b, 30)
        other = polhode.integrate(f, a, b, 30)
        assert one.certified and other.certified and bool(one)
        assert (one.value.lower, one.value.upper) == (other.value.lower, other.value.upper)


def test_the_answer_says_what_was_proved():
    found = polhode.integrate("exp(-x^2)", "-inf", "inf", digits=40)
    assert found.certified and found.reason == ""
    assert found.value.overlaps(polhode.eval("sqrt(pi)", 60))
    assert found.value.rad < F(1, 10**40) * found.value.mid
    assert found.account["panels"] >= 1 and found.account["rules"]
    assert repr(found).startswith("<integral 1.7724538509") and "certified" in repr(found)
    assert abs(float(found) - math.sqrt(math.pi)) < 1e-15
    refused = polhode.integrate("1/x", 0, 1)
    assert not refused.certified and "not integrable" in refused.reason
    assert not refused


def test_functions_that_hide_what_they_do_are_refused_with_what_to_write():
    for f, words in [
            (lambda x: math.sin(x), "polhode.sin"),
            (lambda x: x if x > 0 else -x, "cannot branch"),
            (lambda x: 0.1 * x, 'write "0.1"'),
            (lambda x: "x", "no formula"),
            (lambda x: None, "no formula"),
            (3.5, "float"),
            ([], "a function is given")]:
        with pytest.raises(TypeError, match=words):
            polhode.integrate(f, 0, 1)
    for text in ["sin(", "foo(x)", "1/0", "y*z"]:
        with pytest.raises(ValueError):
            polhode.integrate(text, 0, 1)
    with pytest.raises(ValueError):
        polhode.integrate("x", 0, 1, digits=0)
    with pytest.raises(ZeroDivisionError):
        polhode.integrate(lambda x: x + 1 // 0, 0, 1)


def test_sympy_expressions_are_read():
    sympy = pytest.importorskip("sympy")
    x = sympy.Symbol("x")
    found = polhode.integrate(sympy.exp(-(x**2)) * sympy.Abs(x), 0, sympy.oo, 20)
    assert found.value.overlaps(ball(F(1, 2)))


def test_the_only_name_is_the_variable():
    assert polhode.integrate("t^2", 0, 3).value.mid == 9
    assert len(polhode.roots("cos(t) = t", 0, 2, digits=10)) == 1
    assert len(polhode.complex_roots("exp(x) - x", ((-5, -5), (5, 5)), 10)) == 2
    with pytest.raises(ValueError, match="there is no"):
        polhode.integrate("k*t", 0, 1)


def test_complex_roots():
    found = polhode.complex_roots("exp(z) - z", ((-5, -5), (5, 5)), 20)
    assert found and found.certified and len(found) == 2
    assert abs(complex(found[0]) - (0.3181315052047641 - 1.3372357014306894j)) < 1e-15
    assert str(found[1]) == "0.31813150520476413531... + 1.3372357014306894089...j"
    cubic = polhode.complex_roots(lambda z: z**3 - 1, digits=10)
    assert len(cubic) == 3 and [r.multiplicity for r in cubic] == [1, 1, 1]
    assert cubic[2].real == 1 and cubic[2].imag == 0
    pole = polhode.complex_roots("sin(z)/z", ((-4, -1), (4, 1)), 15)
    assert pole and len(pole) == 2
    cut = polhode.complex_roots("sqrt(z) - i", ((-2, -1), (2, 1)), 10)
    assert not cut and cut.undecided
    for wrong, kind in [(("sin(z)",), ValueError), (("z", 3), TypeError),
                        (("z", ((0, 0), (1,))), TypeError), (("z", ((0.5, 0), (1, 1))), TypeError),
                        (("z", ((1, 1), (0, 0))), ValueError),
                        (("abs(z)", ((0, 0), (1, 1))), ValueError)]:
        with pytest.raises(kind):
            polhode.complex_roots(*wrong)


def test_systems_in_infinite_boxes():
    found = polhode.solve_system(["x*y - 1", "x - y"], [(-polhode.oo, polhode.oo)] * 2)
    assert found and len(found) == 2 and found[1][0] == 1


def test_roots_are_all_there_are():
    found = polhode.roots("x^3 - 3*x + 1", "-inf", "inf", 30)
    assert found.certified and len(found) == 3
    assert [r.verdict for r in found] == ["unique"] * 3
    assert found[-1].value.overlaps(polhode.eval("2*cos(2*pi/9)", 40))
    double = polhode.roots(lambda x: (x - F(1, 3))**2 * polhode.exp(x), -1, 1)
    assert len(double) == 1 and double[0].multiplicity == 2 and double[0].exact == F(1, 3)
    tangent = polhode.roots("tan(x)", 1, 4)
    assert len(tangent) == 1 and tangent.singular[0][1] == 1
    periodic = polhode.roots(polhode.sin, 0, polhode.oo)
    assert periodic.certified and periodic.period == "2*pi" and len(periodic) == 3
    assert [float(end) for end in periodic.period_range] == [0, 2 * math.pi]
    assert "in one period, 2*pi" in repr(periodic)
    endless = polhode.roots("tan(x) - x", 1, polhode.oo, 15)
    assert endless.certified and endless[-1].verdict == "infinitely many"
    zero = polhode.roots("x - x", 0, 1)
    assert zero.identically_zero and "0 everywhere" in repr(zero)
    flat = polhode.roots("max(x, 0)*(x - 1/2)", -1, 1)
    assert flat.certified and flat.zero_intervals == [(-1, 0)] and flat[0].exact == F(1, 2)
    assert "all of -1" in repr(flat)
    with pytest.raises(ValueError):
        polhode.roots("x", 1, 0)
    with pytest.raises(IndexError):
        found[3]


def test_systems():
    found = polhode.solve_system([lambda x, y: x * x + y * y - 1, lambda x, y: x - y],
                                 [(-2, 2), (-2, 2)], digits=30)
    assert found.certified and len(found) == 2 and not found.unresolved
    root = polhode.eval("sqrt(1/2)", 40)
    assert found[1][0].overlaps(root) and found[1][1].overlaps(root)
    with pytest.raises(ValueError):
        polhode.solve_system(["x"], [(0, 1), (0, 1)])
    with pytest.raises(TypeError):
        polhode.solve_system(["x"], [(0, 1, 2)])


def test_values():
    assert polhode.eval("1/3 + 1/6").mid == F(1, 2)
    x = polhode.eval(polhode.exp(polhode.pi * polhode.sqrt(163 + 0 * polhode.pi)), 40)
    assert str(x).startswith("262537412640768743.9999999999992")
    f = polhode.formula("x^2 + y", ["x", "y"])
    assert f(2, F(1, 2)).mid == F(9, 2) and f.variables == ["x", "y"]
    with pytest.raises(TypeError):
        f(1)
    with pytest.raises(ValueError):
        polhode.eval("x")


def test_greatest_and_least_of_many():
    assert polhode.max(1, 3, 2).mid == 3 and polhode.min(2, 3, 1, 4).mid == 1
    assert polhode.hypot(1, 2, 2).mid == 3
    of_three = polhode.integrate(lambda x: polhode.max(polhode.sin(x), polhode.cos(x), "1/2"), 0, 1)
    assert of_three.certified
    assert of_three.value.overlaps(polhode.integrate("max(sin(x),cos(x),1/2)", 0, 1).value)
    with pytest.raises(TypeError, match="argument"):
        polhode.max(1)


def test_threads_compute_at_once():
    results = []

    def work(n):
        results.append(polhode.integrate(f"sin(x)^{n}*exp(-x)", 0, 1, 100).certified)

    threads = [threading.Thread(target=work, args=(n,)) for n in range(1, 9)]
    for t in threads:
        t.start()
    for t in threads:
        t.join()
    assert results == [True] * 8


def test_the_interpreter_ends_beside_work_that_has_not_ended():
    program = """
import sys
import polhode
for text in ["sin(exp(x))", "cos(exp(x))", "sin(exp(x))*x"]:
    try:
        polhode.integrate(text, 0, 14, 4000, time_limit=0.05)
    except TimeoutError:
        pass
print("ends")
sys.exit(3)
"""
    for _ in range(5):
        done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True,
                              check=False)
        assert (done.returncode, done.stdout) == (3, "ends\n"), done.stderr


def test_a_time_limit_ends_long_work():
    start = time.monotonic()
    with pytest.raises(TimeoutError, match="0.2"):
        polhode.integrate("sin(exp(x))", 0, 14, 2000, time_limit=0.2)
    with pytest.raises(TimeoutError):
        polhode.roots("sin(x)", 0, 2**70, time_limit=0.2)
    assert time.monotonic() - start < 60
    for wrong in [0, -1, float("nan")]:
        with pytest.raises(ValueError, match="time_limit"):
            polhode.integrate("x", 0, 1, time_limit=wrong)


def test_control_c_ends_long_work_at_once():
    def interrupt():
        time.sleep(0.5)
        signal.raise_signal(signal.SIGINT)

    # A process in the background of a shell is started with the signal ignored.
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    threading.Thread(target=interrupt).start()
    start = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        polhode.integrate("sin(exp(x))", 0, 14, 2000)
    signal.signal(signal.SIGINT, before)
    assert time.monotonic() - start < 60  # and not the many minutes of the integral
    # The work that was left does not disturb what comes after it.
    assert polhode.integrate("exp(x)", 0, 1, 20).certified


def test_integrals_along_paths():
    around = polhode.integrate_along("1/z", [1, 1j, -1, (0, -1), "1"], digits=20)
    assert around.certified and complex(around) == pytest.approx(2j * math.pi)
    assert around.value.imag.overlaps(polhode.eval("2*pi", 30))
    circle = polhode.Path.circle("i", "1/2")
    assert polhode.integrate_along(lambda z: 1 / (z*z + 1), circle, 20).value.real.overlaps(
        polhode.eval("pi", 30))
    half = polhode.Path.arc(0, 1, 0, "pi")
    assert len(half + -half) == 2
    there_and_back = polhode.integrate_along("exp(z)*i", half + -half, 10)
    assert there_and_back and there_and_back.value.contains(0)
    with_unit = polhode.integrate_along(lambda z, i: polhode.exp(i*z), [0, "pi"], 20)
    assert with_unit.value.overlaps(2j)
    cut = polhode.integrate_along("sqrt(z)", [(1, 0), (-1, 1), (-1, -1)], 20)
    assert not cut and "branch cut of sqrt" in cut.reason and str(cut) == "undefined"
    for wrong in [5, "1+i", [(1, 2, 3)], [0.5, 1], [0.5j, 1], None]:
        with pytest.raises(TypeError):
            polhode.integrate_along("z", wrong)
    with pytest.raises(ValueError, match="join|start"):
        polhode.integrate_along("z", polhode.Path.circle(0, 1) + polhode.Path.circle(5, 1))


def test_integrals_over_boxes_of_parameters():
    spread = polhode.integrate_box("exp(-k*x)", 0, 1, {"k": (1, "1.1")})
    assert spread and spread.attained
    for k in ["1", "1.05", "1.1"]:
        assert spread.value.contains(polhode.integrate(f"exp(-{k}*x)", 0, 1, 10).value)
    more = polhode.integrate_box(lambda x, k, m: polhode.exp(-k*m*x), 0, 1,
                                 {"k": (1, 2), "m": ball.hull_of(1, 2)}, most_boxes=8)
    assert more.value.contains(polhode.integrate("exp(-3*x)", 0, 1, 10).value)
    assert more.boxes >= 1 and more.integrals >= more.boxes
    for wrong in [{"k": 5}, {"k": (1, 2, 3)}, {"k": (0.5, 1)}]:
        with pytest.raises(TypeError):
            polhode.integrate_box("k*x", 0, 1, wrong)
    for wrong in [{"k": (2, 1)}, {}, {"sin": (1, 2)}]:
        with pytest.raises(ValueError):
            polhode.integrate_box("k*x", 0, 1, wrong)


def test_a_rule_is_chosen_by_its_name():
    by = polhode.integrate("exp(-x)", 0, 1, 20, rule="gauss-legendre")
    assert by.account["rules"] == ["Gauss-Legendre"]
    assert by.value.overlaps(polhode.integrate("exp(-x)", 0, 1, 30).value)
    assert "turned rays need" in polhode.integrate("1/(1+x)", 0, 1, rule="turned-rays").reason
    with pytest.raises(ValueError, match="\"taylor-series\""):
        polhode.integrate("x", 0, 1, rule="simpson")


def test_progress_is_told_and_may_end_the_work():
    told = []
    polhode.integrate("exp(sin(x^2))*abs(sin(x))", 0, 60, 300,
                      progress=lambda done, panels: told.append((done, panels)))
    assert told == sorted(told) and all(done <= panels for done, panels in told)
    with pytest.raises(ZeroDivisionError):
        polhode.integrate("exp(sin(x^2))*abs(sin(x))", 0, 200, 400,
                          progress=lambda done, panels: 1 // 0)
    with pytest.raises(TypeError):
        polhode.integrate("x", 0, 1, progress=5)


def test_lists_are_taken_member_by_member():
    assert [str(y) for y in polhode.sqrt([1, 4, fractions.Fraction(9, 4)])] == ["1", "2", "1.5"]
    f = polhode.formula("x^2 + y", ["x", "y"])
    assert [int(float(v)) for v in f([1, 2, 3], 10)] == [11, 14, 19]
    assert [int(float(v)) for v in f([1, 2], (5, 6))] == [6, 10]
    assert polhode.exp([]) == []
    with pytest.raises(ValueError, match="2 and 3 members"):
        f([1, 2], [1, 2, 3])
    of_itself = []
    of_itself.append(of_itself)
    with pytest.raises(ValueError, match="nested too deeply"):
        polhode.sin(of_itself)
    numpy = pytest.importorskip("numpy")
    assert [float(y) for y in polhode.abs(numpy.arange(-2, 1))] == [2.0, 1.0, 0.0]


def test_certificates():
    found = polhode.integrate("4/(1+x^2)", 0, 1, digits=20)
    certificate = found.certificate()
    assert certificate["claim"] == "integral" and polhode.check(certificate)["verified"]
    to_pi = polhode.integrate(lambda x: polhode.exp(x), 0, polhode.pi, 15)
    roots = polhode.roots("cos(x) = x", 0, 1, digits=30)
    system = polhode.solve_system(["x^2 + y^2 - 1", "x = y^3"], [(-2, 2), (-2, 2)], digits=30)
    all_three = polhode.check(to_pi.certificate(), roots.certificate(), system.certificate())
    assert all_three["verified"] and len(all_three["files"]) == 3
    certificate["numbers"]["integral"] = {"lower": "3", "upper": "3.1"}
    with pytest.raises(polhode.PolhodeError, match="digest|number"):
        assert not polhode.check(certificate)["verified"]
        raise polhode.PolhodeError("its number is not shown")
    for refused, why in [
            (polhode.integrate("exp(-x)", 0, polhode.oo), "finite"),
            (polhode.integrate("1/x", 0, 1), "not certified"),
            (polhode.integrate("x", 0, polhode.ball.hull_of(1, 2)), "no single number"),
            (polhode.roots("x^2", -1, 1), "multiple"), (polhode.roots("sin(x)", 0, polhode.oo),
                                                        "finite"),
            (polhode.solve_system(["x^2", "y"], [(-1, 1), (-1, 1)]), "multiple"),
            (polhode.solve_system(["x-1", "y"], [(0, polhode.oo), (-1, 1)]), "bounded")]:
        with pytest.raises(ValueError, match=why):
            refused.certificate()


def test_boxes_are_stopped():
    start = time.monotonic()
    with pytest.raises(TimeoutError):
        polhode.integrate_box("exp(-k*x)*sin(x+exp(x))", 0, 8, {"k": (1, 2)}, 15,
                              most_boxes=10**6, time_limit=0.3)
    assert time.monotonic() - start < 30


def test_a_forked_process_computes():
    polhode.integrate("exp(x)", 0, 1, 5)
    child = os.fork()
    if child == 0:
        found = polhode.integrate("exp(x)", 0, 1, 5)
        os._exit(0 if found.certified else 1)
    deadline = time.monotonic() + 60
    while time.monotonic() < deadline:
        ended, status = os.waitpid(child, os.WNOHANG)
        if ended:
            assert os.waitstatus_to_exitcode(status) == 0
            return
        time.sleep(0.01)
    os.kill(child, signal.SIGKILL)
    os.waitpid(child, 0)
    raise AssertionError("the child waits for a thread that it has not")


def test_many_threads_of_python_compute_at_once():
    found = [None] * 8

    def compute(i):
        for _ in range(20):
            found[i] = polhode.integrate(f"exp({i + 1}*x)", 0, 1, 20)

    threads = [threading.Thread(target=compute, args=[i]) for i in range(len(found))]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for i, integral in enumerate(found):
        exact = (polhode.exp(ball(i + 1)) - 1) / (i + 1)
        assert integral.value.overlaps(exact)
