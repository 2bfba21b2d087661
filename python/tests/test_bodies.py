"""Bodies, scenes and claims: the program's commands with balls for numbers."""

import fractions
import pathlib
import re

import pytest

import polhode
from polhode import Body, PolhodeError

F = fractions.Fraction
ROOT = pathlib.Path(__file__).resolve().parents[2]


def test_a_body_is_given_in_one_way():
    planar = Body(moments=[3, 2, 1])
    assert planar.kind == "planar"
    assert Body(moments=["2.6", F(2), 1]).kind == "physical"
    assert Body(tensor=[2, 3, 4, "0.1", 0, "-0.2"]).kind == "physical"
    assert Body(ab=[1, F(1, 4)]).kind == "physical"
    assert "moments" in repr(planar)
    for wrong in [{}, {"moments": [3, 2, 1], "ab": [1, F(1, 4)]}]:
        with pytest.raises(TypeError, match="one way"):
            Body(**wrong)
    with pytest.raises(PolhodeError, match="positive"):
        Body(moments=[3, 2, -1]).describe()
    with pytest.raises(TypeError, match="float"):
        Body(moments=[3, 2, 0.1])


def test_phase_and_racket():
    phase = Body(moments=[3, 2, 1]).phase("0.1", digits=30)
    assert phase["verdict"] == "certified" and phase["regime"] == "rotating"
    assert phase["phase"] > phase["greatest_lower_bound"] > 0
    assert phase["c"] == F(1, 10)
    racket = Body(moments=[3, 2, 1]).racket(digits=20)
    assert racket["verdict"] == "certified"
    curve = Body(moments=[3, 2, 1]).curve(points=5)
    assert curve


def test_a_link_of_a_file():
    robot = ROOT / "scenes" / "robot_arm.urdf"
    assert Body.from_urdf(robot, "upper_arm").kind == "physical"
    with pytest.raises(PolhodeError, match="forearm"):
        Body.from_urdf(robot, "nose")


def test_constants():
    beta = polhode.constants("beta", 40)
    assert beta.digits() >= 40 and beta < F(29, 1000)
    assert set(polhode.constants(digits=15)) >= {"beta", "epsilon0_min"}


def test_claims_are_proved_and_checked(tmp_path):
    report = polhode.certify("beta", out=tmp_path / "certificates")
    assert report
    assert polhode.check(tmp_path / "certificates")


def test_tables():
    assert polhode.table("epsilon0", moments=["3", "2", "1"])


def test_grids(tmp_path):
    numpy = pytest.importorskip("numpy")
    whole = polhode.grid("epsilon0", "c0", a="1..9/3", b="0.1..0.5/1", digits=12)
    assert whole.shape == (2, 2, 4, 2)
    assert (whole[0, 1] < 1e-12).all()
    assert abs(whole[0, 0, 0, 0] - float(polhode.table("epsilon0", ab="1,0.1", digits=20)["rows"][0]
                                         ["epsilon0"].mid)) < 1e-12
    moments = polhode.grid("epsilon0", moments="3,2..5/2,1..4/2", digits=12)
    assert moments.shape == (1, 2, 3, 3)
    assert abs(moments[0, 0, 0, 0] - polhode.grid("epsilon0", a=1, b="1/3")[0, 0, 0, 0]) < 1e-12
    assert polhode.grid("epsilon", chi="1..2/2", beta="0..1/2").shape == (1, 2, 3, 3)
    for shard in ("1/2", "2/2"):
        polhode.run("map", "epsilon0", "c0", "--a", "1..9/3", "--b", "0.1..0.5/1", "--digits", 12,
                    "--blocks", tmp_path / "blocks", "--shard", shard)
    numpy.testing.assert_array_equal(polhode.merged(tmp_path / "blocks"), whole)


def test_errors_are_the_programs_sentences():
    with pytest.raises(PolhodeError, match="beta"):
        polhode.constants("bta")


def test_every_command_of_the_program_has_a_counterpart():
    listing = polhode.run("--help")
    commands = re.search(r"Subcommands:\n(.*?)\n\n", listing, re.DOTALL).group(1)
    names = {line.split()[0] for line in commands.splitlines()}
    counterparts = {"certify": polhode.certify, "check": polhode.check,
                    "constants": polhode.constants, "eval": polhode.eval,
                    "integrate": polhode.integrate, "roots": polhode.roots,
                    "body": Body.describe, "phase": Body.phase, "racket": Body.racket,
                    "curve": Body.curve, "table": polhode.table, "map": polhode.grid,
                    "merge": polhode.merged, "scene": polhode.Scene.run,
                    "figures": polhode.figures, "cost": polhode.cost}
    assert names == set(counterparts)


# What stands for an option of the program: a parameter of a function, or why there is none.
OF_FORMULAS = {"--from": "a", "--to": "b", "--in": "a", "--digits": "digits",
               "--time-limit": "time_limit", "--variable": "f", "--let": "f",
               "--certificate": polhode.Integral.certificate,
               "--format": "objects, in place of text and JSON",
               "--memory-limit": "digits are bounded instead", "--help": "help()",
               "--verify": "the program gives second opinions"}
OPTIONS = {
    "integrate": {**OF_FORMULAS, "--rule": "rule", "--threads": "threads",
                  "--along": polhode.integrate_along, "--circle": polhode.Path.circle,
                  "--boxes": polhode.integrate_box},
    "roots": {**OF_FORMULAS, "--threads": "threads", "--complex": polhode.complex_roots,
              "--rectangle": polhode.complex_roots, "--certificate": polhode.Roots.certificate},
    "eval": {**OF_FORMULAS, "--functions": "polhode.functions"}}


@pytest.mark.parametrize("command", OPTIONS)
def test_every_option_of_formulas_has_a_counterpart(command):
    shown = set(re.findall(r"^ +(?:-\w,)?(--[a-z-]+)", polhode.run(command, "--help"), re.M))
    known = OPTIONS[command]
    assert shown and shown <= set(known)
    signature = getattr(polhode, command).__doc__.partition("\n")[0]
    for option in shown:
        if isinstance(known[option], str) and known[option].isidentifier():
            name = known[option]
            assert f"{name}:" in signature, (option, signature)
