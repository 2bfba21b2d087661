"""Arb's functions, and Python where Arb is missing when they are called."""

import os
import pathlib
import subprocess
import sys

import pytest

import polhode

pytestmark = pytest.mark.skipif(not hasattr(polhode, "besselJ"), reason="built without Arb")


def test_values_integrals_and_roots():
    assert polhode.besselJ(0, polhode.ball(1)).overlaps(polhode.eval("besselJ(0, 1)"))
    weber = polhode.integrate(lambda x: polhode.besselK(0, x), 0, polhode.oo, digits=20)
    assert weber.value.overlaps(polhode.eval("pi/2"))
    assert len(polhode.roots(lambda x: polhode.airyAi(x), -5, 0)) == 2


def test_a_library_that_cannot_be_loaded_is_an_exception(tmp_path):
    for name in ["libflint-arb.so.2", "libarb.so.2"] + [f"libflint.so.{n}" for n in range(17, 30)]:
        (tmp_path / name).write_text("no library")
    program = ("import polhode\n"
               "for call in (lambda: polhode.besselJ(0, polhode.ball(1)),\n"
               "             lambda: polhode.integrate('besselJ(0, x)', 0, 1)):\n"
               "    try: call()\n"
               "    except RuntimeError as error: print(error)\n")
    package = str(pathlib.Path(polhode.__file__).parent.parent)
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True,
                          env=dict(os.environ, LD_LIBRARY_PATH=str(tmp_path), PYTHONPATH=package))
    assert done.returncode == 0, done.stderr
    assert done.stdout.count("Arb, which has special functions, cannot be loaded") == 2
