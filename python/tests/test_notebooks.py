"""The notebooks of docs/notebooks: run, they print what is in them.

With POLHODE_UPDATE_NOTEBOOKS=1 the notebooks are written anew with what they print. The output of a
cell with the tag "varies" (times, other libraries) and pictures are not compared.
"""

import os
import pathlib

import pytest

nbformat = pytest.importorskip("nbformat")
nbclient = pytest.importorskip("nbclient")
pytest.importorskip("ipykernel")

NOTEBOOKS = pathlib.Path(__file__).resolve().parents[2] / "docs" / "notebooks"


def joined(outputs):
    """The outputs, in which what came to standard output in pieces is one text."""
    result = []
    for output in outputs:
        if result and output.output_type == result[-1].output_type == "stream":
            result[-1].text += output.text
        else:
            result.append(output)
    return result


def texts(notebook):
    """What each cell prints and returns, but for pictures and what varies."""
    result = []
    for cell in notebook.cells:
        if cell.cell_type != "code" or "varies" in cell.metadata.get("tags", []):
            continue
        text = ""
        for output in cell.outputs:
            text += output.get("text", "")
            if "image/png" not in output.get("data", {}):
                text += output.get("data", {}).get("text/plain", "")
        result.append((cell.source, text))
    return result


@pytest.mark.parametrize("path", sorted(NOTEBOOKS.glob("*.ipynb")), ids=lambda path: path.stem)
def test_a_notebook_prints_what_is_in_it(path, monkeypatch):
    notebook = nbformat.read(path, as_version=4)
    source = "".join(cell.source for cell in notebook.cells)
    for name in ("matplotlib", "mpmath", "numpy"):
        if name in source or (name == "matplotlib" and "plot(" in source):
            pytest.importorskip(name)
    monkeypatch.setenv("PYDEVD_DISABLE_FILE_VALIDATION", "1")
    expected = texts(notebook)
    nbclient.NotebookClient(notebook, timeout=300, kernel_name="python3",
                            resources={"metadata": {"path": str(path.parent)}}).execute()
    if os.environ.get("POLHODE_UPDATE_NOTEBOOKS"):
        for cell in notebook.cells:
            cell.metadata.pop("execution", None)
            if cell.cell_type == "code":
                cell.outputs = joined(cell.outputs)
        notebook.metadata = {"kernelspec": notebook.metadata["kernelspec"],
                             "language_info": {"name": "python"}}
        nbformat.write(notebook, path)
    else:
        assert texts(notebook) == expected
