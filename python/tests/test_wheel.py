"""The wheel of `pip install .`: what is in it, and that it works in an environment of its own."""

import pathlib
import subprocess
import sys
import zipfile

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]


def test_it_is_installed_without_downloads(tmp_path):
    pytest.importorskip("ensurepip")
    sys.path.insert(0, str(ROOT / "python"))
    try:
        import wheel_builder
    finally:
        sys.path.pop(0)
    name = wheel_builder.build_wheel(tmp_path)
    names = zipfile.ZipFile(tmp_path / name).namelist()
    assert "polhode/__init__.py" in names
    assert any(entry.endswith("/scripts/polhode") for entry in names)
    environment = tmp_path / "env"
    subprocess.run([sys.executable, "-m", "venv", environment], check=True)
    python = environment / "bin" / "python"
    subprocess.run([python, "-m", "pip", "install", "--quiet", "--no-index", tmp_path / name],
                   check=True, cwd=tmp_path)
    program = ("import polhode; print(polhode.program.path()); "
               "print(polhode.integrate('x^2', 0, 3, 20)); print(polhode.constants('beta') != {})")
    done = subprocess.run([python, "-c", program], check=True, cwd=tmp_path, capture_output=True,
                          text=True, env={"PATH": "/usr/bin:/bin"})
    lines = done.stdout.split()
    assert lines[0] == str(environment / "bin" / "polhode")
    assert lines[-1] == "True"
