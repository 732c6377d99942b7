"""English: labs, graphs of a shot, laws compared, a shot as data."""

WORDS = {
    "key.sheet labs": "labs: worksheets",
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
