"""English: labs, graphs of a shot, laws compared, a shot as data."""

WORDS = {
    "key.sheet labs": "labs: worksheets",
    "key.graphs": "graphs of the shot, or its log",
    "graphs.title": "Graphs",
    "graphs.speed": "speed, m/s",
    "graphs.momentum": "momentum, kg m/s: x, y (lilac)",
    "graphs.energy": "energy, J: all, of moving (faint)",
    "key.compare": "the shot by other laws and engines",
    "compare.row": "{name}: cue ball {cue} cm off, at most {most} cm",
    "compare.none": "There is nothing to compare with",
    "key.export": "the shot as CSV and picture",
    "notice.exported": "CSV and picture written: {about}",
    "notice.unexported": "The shot cannot be written: {about}",
    "help.shelf": "set-ups · labs: worksheets",
    "help.laws": "next laws · the shot by all of them",
    "help.log": "log: two languages, graphs, files",
    "labs.title": "Labs",
    "labs.hint": (
        "Enter opens the scene · Tab to the answers · PgUp PgDn other numbers · "
        "P a page to print · Esc closes"
    ),
    "labs.open": "Open the scene",
    "labs.check": "Check",
    "labs.print": "Page to print",
    "labs.usual": "usual numbers",
    "labs.seed": "numbers {seed}",
    "labs.right": "right",
    "labs.large": "too large",
    "labs.small": "too small",
    "labs.checked": "{0} of {1} right",
    "labs.unanswered": "Type an answer first",
    "labs.unread": "“{word}” is no number",
    "labs.printed": "Written to {word}",
    "labs.unprinted": "The page cannot be written: {word}",
}
