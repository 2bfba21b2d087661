"""Scenes, their tables, pictures and pages."""

import decimal
import fractions
import math
import pathlib

import pytest

from polhode import Body, PolhodeError, Scene, SceneAnswer, Table, ball

F = fractions.Fraction
ROOT = pathlib.Path(__file__).resolve().parents[2]
BOOK = {
    "title": "A book with \"quotes\" and \\",
    "body": {"moments": ["2.5", F(2), decimal.Decimal(1)]},
    "state": {"omega": ["0.01", 2, 0], "unit": "rad/s"}, "time": {"to": 10, "samples": 5},
    "effects": {"want": ["period", "momentum", "attitude"]},
}


def test_the_scenes_that_are_shipped_run():
    for path in sorted((ROOT / "scenes").glob("*.toml"))[:4]:
        answer = Scene.from_file(path).run()
        for point in answer if isinstance(answer, list) else [answer]:
            assert point["verdict"] == "certified", path


def test_a_dict_is_the_same_scene_as_its_file(tmp_path):
    text = ('''title = "A book"
[body]
moments = ["2.5", "2", "1"]
[state]
omega = ["0.01", 2, 0]
[time]
to = 10
samples = 5
[effects]
want = ["period", "momentum"]
''')
    path = tmp_path / "book.toml"
    path.write_text(text, encoding="utf-8")
    of_file = Scene.from_file(path).run()
    of_text = Scene.from_text(text).run()
    of_dict = Scene.from_dict({**BOOK, "effects": {"want": ["period", "momentum"]}}).run()
    period = of_file.numbers()["period"]["period"]
    assert period.lower == of_text.numbers()["period"]["period"].lower
    assert period.lower == of_dict.numbers()["period"]["period"].lower
    assert of_dict["title"] == BOOK["title"]


def test_a_sweep_has_an_answer_for_each_point():
    answers = Scene.from_dict({**BOOK, "sweep": {"state.omega[0]": ["0.01", F(1, 50)]}}).run()
    assert [type(x) for x in answers] == [SceneAnswer, SceneAnswer]


def test_tables_hold_the_numbers():
    pytest.importorskip("numpy")
    table = Scene.from_dict(BOOK).run().table("momentum")
    assert len(table) == 5 and table.columns[0] == "t"
    for column in table.columns:
        for middle, radius, exact in zip(table[column], table.radii(column), table.exact(column)):
            lower = exact.lower if isinstance(exact, ball) else exact
            upper = exact.upper if isinstance(exact, ball) else exact
            assert F(middle) - F(radius) <= lower <= upper <= F(middle) + F(radius)
            assert radius <= 1e-15 * max(1, abs(middle))
    with pytest.raises(KeyError, match="omega_1"):
        table["nothing"]


def test_a_table_keeps_what_a_float_does_not():
    pytest.importorskip("numpy")
    table = Table([{"x": F(1, 3)}, {"x": ball.hull_of(0, 1)}, {"y": 2}, {"x": F(10)**400}])
    assert table.exact("x") == [F(1, 3), table.rows[1]["x"], None, F(10)**400]
    assert table.radii("x")[0] >= abs(F(float(F(1, 3))) - F(1, 3)) > 0
    assert table.radii("x")[1] == 0.5
    assert math.isnan(table["x"][2]) and math.isinf(table.radii("x")[3])


def test_frames():
    pytest.importorskip("pandas")
    assert list(Body(moments=[3, 2, 1]).table(points=5).frame()) == ["c", "epsilon", "epsilon_of_s"]


def test_pictures():
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    figure = Scene.from_dict(BOOK).run().plot()
    assert [len(ax.lines) for ax in figure.axes] == [3, 3, 4, 1]
    assert len(Body(moments=[3, 2, 1]).plot(points=20).lines) == 2
    with pytest.raises(ValueError, match="no table"):
        Scene.from_dict({**BOOK, "effects": {"want": ["period"]}}).run().plot()


def test_pages(tmp_path):
    try:
        page = Scene.from_dict(BOOK).page()
    except PolhodeError as error:
        pytest.skip(str(error))
    page.save(tmp_path / "book.html")
    assert "<html" in (tmp_path / "book.html").read_text(encoding="utf-8")
    assert "iframe" in page._repr_html_() and "</iframe>" in page._repr_html_()


def test_what_is_no_scene_is_refused():
    with pytest.raises(TypeError, match="float"):
        Scene.from_dict({**BOOK, "body": {"moments": [3, 2, 0.1]}})
    with pytest.raises(TypeError, match="no place"):
        Scene.from_dict({**BOOK, "time": {"to": object()}})
    with pytest.raises(PolhodeError, match="effects"):
        Scene.from_dict({"body": {"moments": [3, 2, 1]}}).run()
    with pytest.raises(PolhodeError, match="twist"):
        Scene.from_dict({**BOOK, "effects": {"want": ["twits"]}}).run()
    with pytest.raises(KeyError, match="momentum"):
        Scene.from_dict(BOOK).run().table("period")
