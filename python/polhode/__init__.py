"""Verified arbitrary-precision numerics, and the free rotation of rigid bodies.

Numbers are balls: sets that are proved to hold the true value. Functions are texts, or functions of
a symbol, which are called once. Bodies, scenes and claims are those of the program `polhode`.

>>> import polhode
>>> print(polhode.integrate("sqrt(x)*exp(-x)", 0, polhode.oo, digits=20))
0.88622692545275801364...
>>> polhode.Body(moments=[3, 2, 1]).kind
'planar'
"""

import math as _math

from . import _polhode
from ._polhode import *  # noqa: F403: the functions of formulas, by their names
from ._polhode import (Formula, Integral, Root, Roots, Symbol, SystemRoots, Undecided, __version__,
                       ball, certainly_less, eval, formula, functions, integrate, roots,
                       solve_system)
from .bodies import (Body, PolhodeError, certify, check, constants, cost, figures, grid, merged,
                     run_scene, table)
from .program import run

oo = _math.inf

__all__ = [
    "Body", "Formula", "Integral", "PolhodeError", "Root", "Roots", "Symbol", "SystemRoots",
    "Undecided", "ball", "certainly_less", "certify", "check", "constants", "cost", "eval",
    "figures", "formula", "functions", "integrate", "oo", "roots", "run", "run_scene",
    "grid", "merged", "solve_system", "table", "pi", "e", "euler_gamma", "catalan", *functions,
]
