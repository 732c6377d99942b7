"""English: a shot from a drawn path, and a table from tracks."""

WORDS = {
    "key.sketch": "draw the cue ball's path",
    "help.sketch": "draw a path, get its shot · show a shot",
    "hint.sketch": "Draw the cue ball's path · Esc ends",
    "notice.sketch.start": "Begin the path at the cue ball",
    "notice.sketch.short": "The path is too short",
    "notice.sketch.searching": "Looking for the shot … · Esc stops",
    "notice.sketch.cancelled": "The search was stopped",
    "notice.sketch.none": "No shot runs there: {0} cm off at best",
    "notice.sketch.failed": "No shot can be found for this path",
    "notice.sketch.found": "Off {0} cm · V ±{1} ±{2}° · spin ±{3}",
    "notice.sketch.partly": "{4} % of it, {0} cm off · V ±{1} ±{2}°",
    "key.sheet tracks": "my table, from tracks",
    "table.own": "My table",
    "tracks.title": "My table",
    "tracks.hint": "Enter fits · ↑ ↓ file · PgUp PgDn table to begin with · Esc closes",
    "tracks.hint.running": "Enter or Esc stops · the page may be closed meanwhile",
    "tracks.folder": "Your folder for tracks: {folder}",
    "tracks.box": "Path of a file of tracks (.csv), or of a table (.json): type or paste it",
    "tracks.files": "Files in your folder “tracks”",
    "tracks.nofiles": "Your folder “tracks” is empty",
    "tracks.base": "From: {table}",
    "tracks.fit": "Fit",
    "tracks.stop": "Stop",
    "tracks.save": "Save as my table",
    "tracks.play": "Play on my table",
    "tracks.about": (
        "A file of tracks has a line of names: track, time, white x, white y, yellow x, … and "
        "then a line for each picture of the camera: seconds, and metres from the middle of the "
        "table. A place that was not seen stays empty."
    ),
    "tracks.about.2": (
        "The friction of the cloth and the bounce of the cushions are found with which the balls "
        "run along these tracks. Four strokes or more are needed to tell them well."
    ),
    "tracks.own": "There is a table of yours: it is in the game menu too.",
    "tracks.noown": "There is no table of yours yet.",
    "tracks.running": "Fitting … {seconds} s",
    "tracks.looking": "{count} tracks; looking for {names}",
    "tracks.misfit": "{count} tracks, misfit {misfit} mm",
    "tracks.before": "before",
    "tracks.found": "found",
    "tracks.cloth.slide": "sliding friction",
    "tracks.cloth.roll": "rolling resistance",
    "tracks.cushion.e": "cushion bounce",
    "tracks.cushion.mu": "cushion friction",
    "tracks.unseen": "Not shown by these tracks, so left as it was: {name}",
    "tracks.fitted": "Found · Enter saves it as your table",
    "tracks.loaded": "A table has been read · Enter saves it as yours",
    "tracks.saved": "Saved · Enter plays on it",
    "tracks.unsaved": "It cannot be saved",
    "tracks.stopped": "Stopped",
    "tracks.none": "Choose a file, or type its path",
    "tracks.unfit": "The path is too long",
    "tracks.failed": "Nothing has been found",
    "tracks.broken": "Your saved table cannot be read; saving another one keeps it as .broken",
}
