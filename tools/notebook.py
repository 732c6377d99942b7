"""A notebook kept as a script: its cells, run, as a page, as an .ipynb file, or quickly in a test.

`# %% [markdown]` begins a cell of words, `# %%` one of code (editors know these marks). A line that
ends in `# quick: 50` has that value instead where a test runs it.
"""

import ast
import base64
import contextlib
import io
import json
import re
from collections.abc import Iterator
from html import escape
from pathlib import Path
from typing import Any, NamedTuple

MARK = re.compile(r"(?m)^# %%(.*)\n")
QUICK = re.compile(r"(?m)^([\w, ]+ = )(.*?)  # quick: (.*)$")
STYLE = Path(__file__).parent.parent / "docs" / "gallery" / "gallery.mplstyle"
COLOURS = 64  # of a picture: a third of the size, and no difference to be seen


class Output(NamedTuple):
    """What a cell has shown: kind is "text", "html" or "png"."""

    kind: str
    data: Any


class Cell(NamedTuple):
    """A cell, and what it has shown."""

    words: bool
    text: str
    outputs: tuple[Output, ...] = ()


def cells(script: str, quick: bool = False) -> list[Cell]:
    """The cells of a script, with the small numbers of a test if it is to be quick."""
    script = QUICK.sub(r"\1\3" if quick else r"\1\2", script)
    parts = MARK.split(script)[1:]
    return [_cell(*pair) for pair in zip(parts[::2], parts[1::2], strict=True)]


def _cell(mark: str, text: str) -> Cell:
    words = "[markdown]" in mark
    text = re.sub(r"(?m)^# ?", "", text) if words else text
    return Cell(words, text.strip())


def run(script: str, quick: bool = False) -> Iterator[Cell]:
    """Its cells in their order, each with what it shows; an error of a cell is raised as it is."""
    from matplotlib import pyplot

    names: dict[str, Any] = {"__name__": "__main__"}
    with pyplot.rc_context(), contextlib.ExitStack() as closing:
        pyplot.switch_backend("agg")
        pyplot.style.use(STYLE)
        if quick:
            pyplot.rcParams["figure.dpi"] = 20
        closing.callback(pyplot.close, "all")
        for cell in cells(script, quick):
            yield cell if cell.words else cell._replace(outputs=(*_shown(cell.text, names),))


def _shown(text: str, names: dict[str, Any]) -> Iterator[Output]:
    """What it prints, then its last expression, then its figures, as a notebook shows them."""
    body = ast.parse(text).body
    last = ast.Expression(body.pop().value) if isinstance(body[-1], ast.Expr) else None
    with contextlib.redirect_stdout(io.StringIO()) as printed:
        exec(compile(ast.Module(body, []), "cell", "exec"), names)
        value = eval(compile(last, "cell", "eval"), names) if last else None
    if printed.getvalue():
        yield Output("text", printed.getvalue().rstrip())
    pictures = [*_figures()]
    if value is not None and not pictures:
        yield _picture_of(value)
    yield from pictures


def _picture_of(value: Any) -> Output:
    for way in ("_repr_html_", "_repr_svg_"):
        if hasattr(value, way):
            return Output("html", getattr(value, way)())
    return Output("text", repr(value))


def _figures() -> Iterator[Output]:
    from matplotlib import pyplot
    from PIL import Image

    for number in pyplot.get_fignums():
        drawn, small = io.BytesIO(), io.BytesIO()
        pyplot.figure(number).savefig(drawn, format="png")
        Image.open(drawn).convert("RGB").quantize(COLOURS).save(small, "png", optimize=True)
        yield Output("png", small.getvalue())
    pyplot.close("all")


def page(done: list[Cell], name: str) -> tuple[str, dict[str, bytes]]:
    """As Markdown, and the pictures that it shows, by their file names."""
    parts, pictures = [], {}
    for cell in done:
        parts.append(cell.text if cell.words else f"```python\n{cell.text}\n```")
        for kind, data in cell.outputs:
            if kind == "png":
                file = f"{name}-{len(pictures) + 1}.png"
                pictures[file] = data
                parts.append(f"![What the code above draws]({file})")
            elif kind == "html":
                parts.append(f'<div class="output">{re.sub(chr(10) + "+", chr(10), data)}</div>')
            else:
                parts.append(f'<pre class="output">{escape(data)}</pre>')
    return "\n\n".join(parts) + "\n", pictures


def ipynb(done: list[Cell]) -> str:
    """As Jupyter keeps a notebook, with what it has shown."""
    made = [
        {"cell_type": "markdown", "metadata": {}, "source": cell.text}
        if cell.words
        else {
            "cell_type": "code", "metadata": {}, "execution_count": None, "source": cell.text,
            "outputs": [_kept(output) for output in cell.outputs],
        }
        for cell in done
    ]  # fmt: skip
    kernel = {"name": "python3", "display_name": "Python 3", "language": "python"}
    book = {"nbformat": 4, "nbformat_minor": 4, "metadata": {"kernelspec": kernel}, "cells": made}
    return json.dumps(book, ensure_ascii=False, indent=1) + "\n"


def _kept(output: Output) -> dict[str, Any]:
    form = {"text": "text/plain", "html": "text/html", "png": "image/png"}[output.kind]
    data = base64.b64encode(output.data).decode() if output.kind == "png" else output.data
    return {"output_type": "display_data", "metadata": {}, "data": {form: data}}
