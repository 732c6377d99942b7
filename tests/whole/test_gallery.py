"""The notebooks of the gallery run, and are taken apart and shown as they should be."""

import json
import re
from pathlib import Path

import pytest

pytest.importorskip("matplotlib")
pytest.importorskip("PIL")

from tools import notebook

GALLERY = Path(__file__).parents[2] / "docs" / "gallery"
SCRIPTS = sorted(GALLERY.glob("*.py"))
SCRIPT = """# %% [markdown]
# # Title
#
# Words.

# %%
COUNT = 5000  # shots  # quick: 2
A, B = 1, 2  # quick: 3, 4
print(f"{COUNT} <b>")

# %%
A + B

# %%
import matplotlib.pyplot as plt

plt.plot([1, 2])

# %%
class Shown:
    def _repr_svg_(self):
        return "<svg>\\n\\n</svg>"


Shown()
"""


@pytest.mark.parametrize("path", SCRIPTS, ids=lambda path: path.stem)
def test_a_notebook_runs_quickly_and_draws(path):
    done = [*notebook.run(path.read_text(encoding="utf-8"), quick=True)]
    assert done[0].text.startswith("# ")
    assert any(output.kind == "png" for cell in done for output in cell.outputs)


def test_every_notebook_has_a_small_number_for_a_quick_run_and_is_on_the_page_of_all():
    index = (GALLERY / "index.md").read_text(encoding="utf-8")
    for path in SCRIPTS:
        assert notebook.QUICK.search(path.read_text(encoding="utf-8")), path
    assert re.findall(r"\]\((\w+\.py)\)", index) == sorted(
        (path.name for path in SCRIPTS), key=index.index
    )


def test_a_script_is_taken_apart_into_cells_of_words_and_of_code():
    first, second, *_ = notebook.cells(SCRIPT)
    assert first == notebook.Cell(True, "# Title\n\nWords.")
    assert second == notebook.Cell(
        False, 'COUNT = 5000  # shots\nA, B = 1, 2\nprint(f"{COUNT} <b>")'
    )
    quick = notebook.cells(SCRIPT, quick=True)[1]
    assert quick.text == 'COUNT = 2\nA, B = 3, 4\nprint(f"{COUNT} <b>")'


def test_a_cell_shows_what_it_prints_its_last_value_and_its_pictures():
    done = [*notebook.run(SCRIPT)]
    assert [[output.kind for output in cell.outputs] for cell in done] == [
        [], ["text"], ["text"], ["png"], ["html"],
    ]  # fmt: skip
    assert [cell.outputs[0].data for cell in done[1:3]] == ["5000 <b>", "3"]
    text, pictures = notebook.page(done, "name")
    assert text.startswith("# Title\n\nWords.\n\n```python\nCOUNT = 5000  # shots\n")
    assert '<pre class="output">5000 &lt;b&gt;</pre>' in text
    assert '<div class="output"><svg>\n</svg></div>' in text
    assert "](name-1.png)" in text
    assert pictures["name-1.png"][:4] == b"\x89PNG"


def test_a_notebook_is_kept_as_jupyter_keeps_one():
    book = json.loads(notebook.ipynb([*notebook.run(SCRIPT)]))
    assert [cell["cell_type"] for cell in book["cells"]] == ["markdown", *["code"] * 4]
    shown = [[*output["data"]] for cell in book["cells"][1:] for output in cell["outputs"]]
    assert shown == [["text/plain"], ["text/plain"], ["image/png"], ["text/html"]]


def test_what_a_cell_raises_is_raised_and_leaves_no_figures_behind():
    from matplotlib import pyplot

    with pytest.raises(ZeroDivisionError):
        list(notebook.run("# %%\nimport matplotlib.pyplot as plt\nplt.figure()\n1 / 0\n"))
    assert pyplot.get_fignums() == []
