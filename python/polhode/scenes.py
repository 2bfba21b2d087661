"""Scenes: a body, its motion and the effects that are wanted of it; and tables of balls."""

import contextlib
import decimal
import fractions
import html
import json
import math
import pathlib
import tempfile

from ._polhode import ball
from .program import answer_of, options_of, run, text_of

__all__ = ["Page", "Scene", "SceneAnswer", "Table"]


def _as_toml(value):
    """The value as TOML in one line. Numbers that are no floats keep their exact value."""
    if isinstance(value, dict):
        return "{" + ", ".join(f"{json.dumps(str(key))} = {_as_toml(x)}"
                               for key, x in value.items()) + "}"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(map(_as_toml, value)) + "]"
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return json.dumps(value)
    if isinstance(value, int):
        return str(value)
    if isinstance(value, (float, fractions.Fraction, decimal.Decimal, ball)):
        return json.dumps(text_of(value))
    raise TypeError(f"{value!r} of type {type(value).__name__} has no place in a scene: write a "
                    "text, a number, a list or a dict")


def _as_float(number):
    """The float that is nearest to the middle of a ball, or to a number, and a bound of the
    distance of that float from everything in the ball."""
    middle, radius = (number.mid, number.rad) if isinstance(number, ball) else (number, 0)
    try:
        nearest = float(middle)
        distance = abs(fractions.Fraction(nearest) - middle) + radius
        bound = float(distance)
    except OverflowError:
        return math.nan, math.inf
    if bound < distance:
        bound = math.nextafter(bound, math.inf)
    return nearest, bound


class Table:
    """Rows of numbers by their columns.

    >>> from polhode import Body
    >>> curve = Body(moments=[3, 2, 1]).table(points=5)
    >>> curve.columns
    ['c', 'epsilon', 'epsilon_of_s']
    >>> curve["c"].round(3).tolist(), bool(curve.radii("epsilon").max() < 1e-13)
    ([-0.267, -0.133, 0.0, 0.133, 0.267], True)
    >>> curve.exact("c")[3]
    Fraction(2, 15)
    """

    def __init__(self, rows, title=""):
        self.rows = list(rows)
        self.title = title
        self.columns = list(dict.fromkeys(name for row in self.rows for name in row))

    def exact(self, column):
        """The numbers of a column as they are: balls, and Fractions where they are known exactly.
        None where a row has none."""
        if column not in self.columns:
            raise KeyError(f"there is no column {column!r}; there are {', '.join(self.columns)}")
        return [row.get(column) for row in self.rows]

    def _floats(self, column):
        nothing = (math.nan, math.inf)
        return [nothing if x is None or isinstance(x, str) else _as_float(x)
                for x in self.exact(column)]

    def __getitem__(self, column):
        """The middles of a column as an array of NumPy's; NaN where there is no number."""
        import numpy
        return numpy.array([x for x, _ in self._floats(column)])

    def radii(self, column):
        """Bounds of the distance of each middle from the true number, its rounding included."""
        import numpy
        return numpy.array([radius for _, radius in self._floats(column)])

    def frame(self):
        """The middles as a DataFrame of pandas."""
        import pandas
        return pandas.DataFrame({name: self[name] for name in self.columns})

    def plot(self, x=None, y=None, ax=None):
        """Draws columns over another, the first one unless told, with matplotlib; returns the
        axes."""
        x = x or self.columns[0]
        y = [y] if isinstance(y, str) else y or [name for name in self.columns if name != x]
        ax = ax or _axes()
        for name in y:
            ax.plot(self[x], self[name], label=name, linewidth=1.2)
        ax.set_xlabel(x)
        if len(y) == 1:
            ax.set_ylabel(y[0])
        else:
            ax.legend(frameon=False)
        if self.title:
            ax.set_title(self.title)
        return ax

    def __len__(self):
        return len(self.rows)

    def __repr__(self):
        return f"<table of {len(self)} rows: {', '.join(self.columns)}>"


def _axes():
    from matplotlib import pyplot
    return pyplot.subplots()[1]


class SceneAnswer(dict):
    """What a scene answers: the program's JSON with balls for numbers."""

    def table(self, effect):
        """The table of an effect that has one: a curve, or a series of samples."""
        effects = self["effects"]
        if effect not in effects or "table" not in effects[effect]:
            with_table = [name for name in effects if "table" in effects[name]]
            raise KeyError(f"{effect!r} has no table here; these have: {', '.join(with_table)}")
        return Table(effects[effect]["table"]["rows"], effect)

    def numbers(self):
        """The numbers of all effects, by effect and name."""
        return {effect: answer["numbers"] for effect, answer in self["effects"].items()
                if "numbers" in answer}

    def plot(self, *effects):
        """Draws the tables of these effects, of all unless told, one below the other; columns with
        a common stem (j_1, j_2, j_3) share axes. Returns the figure of matplotlib."""
        from matplotlib import pyplot
        effects = effects or [name for name, answer in self["effects"].items()
                              if "table" in answer]
        if not effects:
            raise ValueError("this scene has no table to draw: it wants no curve and no series")
        drawn = []
        for table in map(self.table, effects):
            x, *others = table.columns
            stems = dict.fromkeys(name.partition("_")[0] for name in others)
            drawn += [(table, x, [name for name in others if name.partition("_")[0] == stem])
                      for stem in stems]
        figure, all_axes = pyplot.subplots(len(drawn), squeeze=False, layout="constrained",
                                           figsize=(6.4, 2.4 * len(drawn) + 0.4))
        for (table, x, columns), ax in zip(drawn, all_axes[:, 0]):
            table.plot(x, columns, ax)
        return figure

    def __repr__(self):
        return f"<scene {self.get('title', '')!r}: {self['verdict']}, " \
               f"effects {', '.join(self['effects'])}>"


class Page:
    """A page of a scene, in which the body turns. A notebook shows it."""

    def __init__(self, text):
        self.text = text

    def save(self, path):
        """Writes the page to a file of its own."""
        pathlib.Path(path).write_text(self.text, encoding="utf-8")

    def _repr_html_(self):
        return (f'<iframe srcdoc="{html.escape(self.text)}" width="100%" height="560" '
                'style="border: 0"></iframe>')

    def __repr__(self):
        return f"<page of {len(self.text)} characters: save(path) writes it>"


class Scene:
    """A scene, of a file, a text in TOML, or a dict of the same form (docs/scenes.md).

    >>> from polhode import Scene
    >>> scene = Scene.from_dict({
    ...     "title": "A book", "body": {"moments": [3, 2, 1]},
    ...     "state": {"omega": ["0.01", 2, 0], "unit": "rad/s"},
    ...     "time": {"to": 10, "samples": 5}, "effects": {"want": ["regime", "momentum"]}})
    >>> answer = scene.run()
    >>> answer
    <scene 'A book': certified, effects regime, momentum>
    >>> answer.table("momentum")["t"].tolist()
    [0.0, 2.5, 5.0, 7.5, 10.0]
    """

    def __init__(self, text, path=None):
        self._text = text
        self._path = path

    @classmethod
    def from_file(cls, path):
        """The scene of a file, whose own files are found beside it."""
        return cls(pathlib.Path(path).read_text(encoding="utf-8"), pathlib.Path(path))

    @classmethod
    def from_text(cls, text):
        """The scene of a text in TOML."""
        return cls(text)

    @classmethod
    def from_dict(cls, scene):
        """The scene of a dict. Write numbers that are no whole ones as texts, Fractions or
        Decimals."""
        return cls("".join(f"{json.dumps(str(key))} = {_as_toml(value)}\n"
                           for key, value in scene.items()))

    @contextlib.contextmanager
    def _file(self):
        if self._path is not None:
            yield self._path
            return
        with tempfile.TemporaryDirectory() as directory:
            path = pathlib.Path(directory) / "scene.toml"
            path.write_text(self._text, encoding="utf-8")
            yield path

    def run(self, **options):
        """Computes the effects that the scene wants, and no others: a SceneAnswer, or a list of
        them, one for each point of a sweep. Options are those of the command scene."""
        with self._file() as path:
            answer = answer_of("scene", path, *options_of(options))
        if isinstance(answer, list):
            return [SceneAnswer(point) for point in answer]
        return SceneAnswer(answer)

    def page(self, **options):
        """The page of the scene: drawn in a browser, the body turns as it does. Of a sweep a list
        of pages, one for each point."""
        with self._file() as path, tempfile.TemporaryDirectory() as directory:
            run("scene", path, "--page", "--out", directory, *options_of(options))
            pages = [Page(page.read_text(encoding="utf-8"))
                     for page in sorted(pathlib.Path(directory).rglob("*.html"))]
            return pages[0] if len(pages) == 1 else pages

    def __repr__(self):
        return f"<scene {self._path}>" if self._path else f"<scene of {len(self._text)} characters>"
