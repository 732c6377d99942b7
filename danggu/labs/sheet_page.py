"""The printable page of a worksheet: one file of HTML for paper of size A4."""

from __future__ import annotations

from collections.abc import Iterable
from html import escape

from . import line_drawing, text
from .shape import Rows
from .worksheet import Worksheet

STYLE = """
@page { size: A4; margin: 14mm 16mm; }
* { box-sizing: border-box; }
body { font: 10.5pt/1.5 "Noto Sans KR", "Malgun Gothic", "Apple SD Gothic Neo", sans-serif;
  color: #111; background: #fff; max-width: 178mm; margin: 8mm auto; }
h1 { font-size: 18pt; margin: 0 0 2mm; line-height: 1.2; }
h2 { font-size: 11.5pt; margin: 5mm 0 1.5mm; break-after: avoid; }
p { margin: 0 0 2mm; }
.who { display: flex; gap: 6mm; border-bottom: 0.4mm solid #111; padding-bottom: 3mm;
  margin-bottom: 4mm; font-size: 9.5pt; }
.who span { flex: 2; border-bottom: 0.2mm solid #888; } .who span.short { flex: 1; }
.who em { font-style: normal; color: #555; }
table { border-collapse: collapse; width: 100%; font-variant-numeric: tabular-nums; }
th, td { border: 0.2mm solid #888; padding: 0.6mm 2mm; text-align: right; font-size: 9.5pt; }
th { background: #f0f0f0; font-weight: 600; } th:first-child, td:first-child { text-align: left; }
.answers td { height: 8.5mm; } .answers th, .answers td { text-align: left; }
.answers td.blank { width: 42mm; } .answers code { color: #555; font-size: 8.5pt; }
svg { display: block; width: 100%; height: auto; font-family: inherit; }
.note { font-size: 8.5pt; color: #555; }
section { break-inside: avoid; }
.work { height: 40mm; border: 0.2mm solid #888;
  background: repeating-linear-gradient(#fff 0 7.6mm, #ccc 7.6mm 8mm); }
@media print { body { margin: 0; } }
"""


def page(sheet: Worksheet, language: str = "en") -> str:
    """The page as text; it needs no other file. ValueError for a language that there is not."""
    say = text.of(language)
    parts = [
        _head(sheet, language),
        f"<h1>{escape(sheet.title(language))}</h1>",
        *(f"<p>{escape(part)}</p>" for part in sheet.question(language).split("\n\n")),
        _section(say["page.picture"], _picture(sheet, language)),
        _section(say["page.measured"], _table(sheet.table(), language)),
        *_graph(sheet, language),
        _section(say["page.answers"], _answers(sheet, language)),
        _section(say["page.work"], '<div class="work"></div>'),
    ]
    return (
        f'<!DOCTYPE html>\n<html lang="{language}"><head><meta charset="utf-8">'
        f"<title>{escape(sheet.title(language))}</title><style>{STYLE}</style></head>\n"
        f"<body>{''.join(parts)}</body></html>\n"
    )


def _section(head: str, inside: str) -> str:
    return f"<section><h2>{escape(head)}</h2>{inside}</section>\n"


def _head(sheet: Worksheet, language: str) -> str:
    """Lines for the student's name, and which sheet this is."""
    say = text.of(language)
    numbers = say["page.usual"] if sheet.seed is None else say["page.seed"].format(seed=sheet.seed)
    which = f"{say['page.sheet']} {sheet.name}, {numbers}"
    return (
        f'<div class="who"><em>{say["page.name"]}</em><span></span><em>{say["page.class"]}</em>'
        f'<span class="short"></span><em>{say["page.date"]}</em><span class="short"></span>'
        f"<em>{escape(which)}</em></div>\n"
    )


def _picture(sheet: Worksheet, language: str) -> str:
    scale = text.of(language)["page.scale"].format(step=line_drawing.flash(sheet.after))
    drawn = line_drawing.picture(sheet.figure(), language)
    return f'{drawn}<p class="note">{escape(scale)}</p>'


def _table(rows: Rows, language: str) -> str:
    heads = _row("th", (text.word(head, language) for head in rows.heads))
    body = (_row("td", (text.figure(cell, language) for cell in row)) for row in rows.rows)
    return f"<table>{heads}{''.join(body)}</table>"


def _row(tag: str, cells: Iterable[str]) -> str:
    return "<tr>" + "".join(f"<{tag}>{escape(cell)}</{tag}>" for cell in cells) + "</tr>"


def _graph(sheet: Worksheet, language: str) -> list[str]:
    """Paper to draw on, where a graph is asked for."""
    if not sheet.lab.axes:
        return []
    across, up = (escape(text.word(axis, language)) for axis in sheet.lab.axes)
    return [_section(text.of(language)["page.graph"], line_drawing.paper(across, up))]


def _answers(sheet: Worksheet, language: str) -> str:
    """A line for each field, and how the answers are checked."""
    say = text.of(language)
    rows = "".join(
        f"<tr><td>{escape(sheet.label(field.name, language))} <code>{field.name}</code></td>"
        f'<td class="blank"></td><td>{escape(field.unit)}</td></tr>'
        for field in sheet.fields
    )
    call = sheet.name if sheet.seed is None else f"{sheet.name} --seed {sheet.seed}"
    note = escape(say["page.checked"].format(call=call))
    head = f"<tr><th>{say['page.asked']}</th><th>{say['page.answer']}</th><th></th></tr>"
    return f'<table class="answers">{head}{rows}</table><p class="note">{note}</p>'
