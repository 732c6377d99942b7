"""Docstrings as Markdown: lines that explain a name become a list, examples become code."""

import re
from typing import Any

from griffe import Extension

NAMES = re.compile(r"(?:^|(?<=\.  ))([A-Za-z_]\w*(?:(?:, | and )[A-Za-z_]\w*)*): (?=\S)")

ERROR = re.compile(r"[A-Z]\w*(?:Error|Warning)\b")  # at the beginning of a sentence: what is raised


def as_markdown(text: str) -> str:
    """
    >>> print(as_markdown("at: where, m.\\ncut: degrees,\\nfrom -90.\\n\\n>>> 1 + 1\\n2"))
    - **at**: where, m.
    - **cut**: degrees,
      from -90.
    <BLANKLINE>
    ```pycon
    >>> 1 + 1
    2
    ```
    """
    return "\n\n".join(map(_block, re.split(r"\n\n+", text)))


def _block(block: str) -> str:
    if block.startswith(">>> "):
        return f"```pycon\n{block}\n```"
    lines: list[str] = []
    listed = False
    for line in block.split("\n"):
        if listed and ERROR.match(line) and lines[-1].endswith("."):
            lines.append("")
            listed = False
        if NAMES.match(line) and not line.startswith(("ValueError:", "Note:")):
            lines += [] if listed or not lines else [""]
            lines.append(NAMES.sub(r"- **\1**: ", line, count=1))
            listed = True
        else:
            lines.append(f"  {line.strip()}" if listed else line)
    return "\n".join(lines)


class Plain(Extension):
    """For mkdocstrings: this project's docstrings as they are meant."""

    def on_instance(self, *, obj: Any, **_: Any) -> None:
        if obj.docstring:
            obj.docstring.value = as_markdown(obj.docstring.value)
