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
from ._polhode import (BoxIntegral, ComplexRoot, ComplexRoots, ContourIntegral, Formula, Integral,
                       Path, Root, Roots, Symbol, SystemRoots, Undecided, __version__, ball,
                       certainly_less, complex_ball, complex_roots, eval, formula, functions,
                       integrate, integrate_along, integrate_box, roots, solve_system)
from .bodies import (Body, PolhodeError, certify, check, constants, cost, figures, grid, merged,
                     table)
from .program import run
from .scenes import Page, Scene, SceneAnswer, Table

oo = _math.inf

__all__ = [
    "Body", "BoxIntegral", "ComplexRoot", "ComplexRoots", "ContourIntegral", "Formula", "Integral",
    "Page", "Path", "PolhodeError", "Root", "Roots", "Scene", "SceneAnswer", "Symbol",
    "SystemRoots", "Table", "Undecided", "ball", "catalan", "certainly_less", "certify", "check",
    "complex_ball", "complex_roots", "constants", "cost", "e", "euler_gamma", "eval", "figures",
    "formula", "functions", "grid", "integrate", "integrate_along", "integrate_box", "merged",
    "oo", "pi", "roots", "run", "solve_system", "table", *functions,
]
