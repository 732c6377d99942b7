"""What a notebook shows instead of a repr: small tables, as HTML."""

from collections.abc import Iterable, Sequence
from html import escape
from math import isfinite


def table(head: Sequence[str], rows: Iterable[Sequence[object]], note: str = "") -> str:
    """An HTML table; numbers with five digits."""
    body = "".join(f"<tr>{_cells(row, 'td')}</tr>" for row in rows)
    last = f'<tfoot><tr><td colspan="{len(head)}">{escape(note)}</td></tr></tfoot>' if note else ""
    return f"<table><thead><tr>{_cells(head, 'th')}</tr></thead><tbody>{body}</tbody>{last}</table>"


def _cells(row: Sequence[object], tag: str) -> str:
    return "".join(f"<{tag}>{escape(_word(value))}</{tag}>" for value in row)


def _word(value: object) -> str:
    if isinstance(value, float):
        return f"{value:.5g}" if isfinite(value) else "–"
    return "" if value is None else str(value)
