"""The stub names what the module has, and the page of the docs shows what it prints."""

import ast
import doctest
import pathlib

from polhode import _polhode

ROOT = pathlib.Path(__file__).resolve().parents[2]


def named_in(body):
    """The names that statements of a stub define, with the members of classes."""
    for node in body:
        if isinstance(node, ast.AnnAssign):
            yield node.target.id
        elif isinstance(node, (ast.FunctionDef, ast.ClassDef)):
            yield node.name
            if isinstance(node, ast.ClassDef):
                yield from (f"{node.name}.{name}" for name in named_in(node.body))


def test_the_stub_has_the_names_of_the_module():
    text = (ROOT / "python" / "polhode" / "_polhode.pyi").read_text(encoding="utf-8")
    stub = set(named_in(ast.parse(text).body))
    public = {name for name in dir(_polhode) if not name.startswith("_")}
    for name in list(public):
        if isinstance(getattr(_polhode, name), type):
            public |= {f"{name}.{member}" for member in vars(getattr(_polhode, name))
                       if not member.startswith("_")}
    if "besselJ" not in public:  # built without Arb
        stub -= {"besselJ", "besselY", "besselI", "besselK", "besselIx", "besselKx",
                 "airyAi", "airyAiPrime", "airyBi", "airyBiPrime", "expint", "expintx", "Ei",
                 "Si", "Ci", "lambertW", "dilog", "digamma",
                 "polylog", "erfi", "erfcx", "dawson", "fresnelS", "fresnelC", "Shi", "Chi",
                 "gammaUpper", "gammaLower", "polygamma"}
    types_of_the_stub = {"Exact", "Number", "ComplexNumber", "Point", "Function", "End"}
    assert {name for name in stub if not name.rpartition(".")[2].startswith("_")} \
        - types_of_the_stub == public


def test_the_page_of_the_docs():
    failures, examples = doctest.testfile(str(ROOT / "docs" / "python.md"), module_relative=False,
                                          optionflags=doctest.IGNORE_EXCEPTION_DETAIL)
    assert examples >= 15 and failures == 0
