"""Rigid bodies and the claims of the paper: the commands of the program."""

import io
import json
import pathlib
import tempfile

from ._polhode import ball, link_tensors
from .program import PolhodeError, answer_of, joined, options_of, run, run_for_bytes
from .scenes import Table

__all__ = ["Body", "PolhodeError", "certify", "check", "constants", "cost", "figures", "grid",
           "merged", "table"]


class Body:
    """A rigid body: by its principal moments, its tensor (xx, yy, zz, xy, xz, yz), the paper's
    numbers a and b, its rotational constants, or a JSON file of one of these.

    >>> from polhode import Body
    >>> phase = Body(moments=[3, 2, 1]).phase("0.1", digits=20)
    >>> print(f"{phase['phase']:.20}")
    10.898904589739345035...
    """

    def __init__(self, *, moments=None, tensor=None, ab=None, rotational_constants=None,
                 file=None):
        ways = {"moments": moments, "tensor": tensor, "ab": ab,
                "rotational": rotational_constants, "body": file}
        given = {name: value for name, value in ways.items() if value is not None}
        if len(given) != 1:
            raise TypeError("a body is given in one way: moments, tensor, ab, rotational_constants "
                            "or file")
        (name, value), = given.items()
        self._options = ["--" + name, str(value) if name == "body" else joined(value)]

    @classmethod
    def from_urdf(cls, path, link):
        """The body of a link of a URDF, SDF or MuJoCo file."""
        links = link_tensors(pathlib.Path(path).read_text(encoding="utf-8"))
        chosen = [(tensor, problem) for name, tensor, problem in links if name == link]
        if len(chosen) != 1:
            names = ", ".join(name for name, _, _ in links)
            raise PolhodeError(f"{path}: there are {len(chosen)} links {link!r} with an inertia; "
                               f"the links are {names}")
        (tensor, problem), = chosen
        if problem:
            raise PolhodeError(f"{path}: {problem}")
        return cls(tensor=tensor)

    def describe(self, **options):
        """What kind of body it is, its constants, and what exists: the command body."""
        return answer_of("body", *self._options, *options_of(options))

    @property
    def kind(self):
        """'physical', 'planar' or 'non-physical'."""
        return self.describe()["kind"]

    def phase(self, c, **options):
        """The Montgomery phase at c: the command phase."""
        return answer_of("phase", *self._options, "--c", c, *options_of(options))

    def racket(self, **options):
        """The twists of the tennis racket effect: the command racket."""
        return answer_of("racket", *self._options, *options_of(options))

    def curve(self, **options):
        """The curve C beside S: the command curve."""
        return answer_of("curve", *self._options, *options_of(options))

    def table(self, **options):
        """The points of the curves C and S as a Table; options are those of the command curve."""
        return Table(self.curve(**options)["points"], " ".join(self._options).lstrip("-"))

    def plot(self, ax=None, **options):
        """Draws C and S, epsilon over c, with matplotlib; returns the axes."""
        ax = self.table(**options).plot("c", ["epsilon", "epsilon_of_s"], ax)
        ax.set_ylabel("epsilon")
        ax.legend(["C", "S"], frameon=False)
        return ax

    def __repr__(self):
        return f"<body {' '.join(self._options)}>"


def constants(name=None, digits=50):
    """The constants of the paper: one ball, or a dict of all.

    >>> import polhode
    >>> print(f"{polhode.constants('beta', 20):.20}")
    0.028973228037839460089...
    """
    answer = answer_of("constants", *([name] if name else []), "--digits", digits)
    if name:
        return answer[name]
    return {key: value for key, value in answer.items() if isinstance(value, ball)}


def certify(*claims, out=None, **options):
    """Proves claims of the paper, all where none is named: the command certify."""
    return answer_of("certify", *claims, *options_of({"out": out, **options}))


def check(*certificates, **options):
    """Checks certificates, files or dicts, with the independent checker: the command check.

    >>> import polhode
    >>> found = polhode.integrate("4/(1+x^2)", 0, 1, digits=20)
    >>> polhode.check(found.certificate())["verified"]
    True
    """
    with tempfile.TemporaryDirectory() as directory:
        paths = []
        for number, certificate in enumerate(certificates):
            if isinstance(certificate, dict):
                path = pathlib.Path(directory) / f"certificate-{number}.json"
                path.write_text(json.dumps(certificate), encoding="utf-8")
                certificate = path
            paths.append(certificate)
        return answer_of("check", *paths, *options_of(options))


def table(quantity, **options):
    """A table of a quantity of free rotations, as its rows: the command table."""
    return answer_of("table", quantity, *options_of(options))


def grid(*quantities, a=None, b=None, c=None, moments=None, chi=None, beta=None, **options):
    """Quantities over a grid of bodies, as an array [quantity][value, radius][a][b][c] of NumPy's:
    the command map. In place of a and b: moments, one number and two ranges; or chi and beta. The
    radius holds the rounding to a float too; NaN stands where a quantity does not exist or is not
    certified.

    >>> import polhode
    >>> polhode.grid("meetings", a="1..9/2", b="0.1..0.5/1")[0, 0].tolist()
    [[0.0, 3.0], [1.0, 6.0], [2.0, 8.0]]
    """
    import numpy
    given = {"a": a, "b": b, "c": c, "moments": moments, "chi": chi, "beta": beta, **options}
    return numpy.load(io.BytesIO(run_for_bytes("map", *quantities, "--format", "npy",
                                               *options_of(given))))


def merged(blocks):
    """The same array from a directory of blocks that shards have made: the command merge."""
    import numpy
    return numpy.load(io.BytesIO(run_for_bytes("merge", blocks, "--format", "npy")))


def cost(*arguments, **options):
    """What accuracy costs in time: the command cost."""
    return answer_of("cost", *arguments, *options_of(options))


def figures(out, *arguments, **options):
    """Draws the figures of the paper into a directory: the command figures."""
    return run("figures", *arguments, "--out", out, *options_of(options))
