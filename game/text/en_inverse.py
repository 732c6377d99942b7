"""English: a shot from a drawn path, and a table from tracks."""

WORDS = {
    "key.sketch": "draw the cue ball's path",
    "help.sketch": "draw a path, get its shot",
    "hint.sketch": "Draw the cue ball's path · Esc ends",
    "notice.sketch.start": "Begin the path at the cue ball",
    "notice.sketch.short": "The path is too short",
    "notice.sketch.searching": "Looking for the shot … · Esc stops",
    "notice.sketch.cancelled": "The search was stopped",
    "notice.sketch.none": "No shot runs there: {0} cm off at best",
    "notice.sketch.failed": "No shot can be found for this path",
    "notice.sketch.found": "Off {0} cm · V ±{1} ±{2}° · spin ±{3}",
    "notice.sketch.partly": "{4} % of it, {0} cm off · V ±{1} ±{2}°",
}
