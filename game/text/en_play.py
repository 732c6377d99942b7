"""English: aiming and time."""

WORDS = {
    "state.replay": "showing it once more",
    "aids.off": "off",
    "aids.short": "short",
    "aids.full": "full",
    "tip.elevation": "elevation",
    "spread.made": "at ±{angle}°",
    "law.mathavan": "Mathavan cushion",
    "set.law.mathavan": "Mathavan",
    "law.creates": "adds energy",
    "notice.miscue": "Held at the ring: beyond it, a miscue",
    "notice.power": "Choose the power first",
    "notice.undo": "Nothing to undo",
    "notice.redo": "Nothing to redo",
    "notice.thickness.none": "No ball in the way",
    "notice.thickness.blocked": "No line to the ball so thick",
    "key.home": "beginning of the shot",
    "key.back": "one frame back; Shift: event",
    "key.faster -1": "time: slower",
    "key.faster 1": "time: faster",
    "key.undo": "undo",
    "key.redo": "redo",
    "key.turn 1": "turn the aim left",
    "key.turn -1": "turn the aim right",
    "key.push 0.5": "more power",
    "key.push -0.5": "less power",
    "key.thicker 1": "next exact eighth; Shift: back",
    "key.centre": "strike in the middle",
    "key.fan": "spread of the shot",
    "help.aim": "Aiming",
    "help.turn": "turn by 1° · Shift 0.1° · Ctrl 0.01°",
    "help.finer": "turn by 0.1° · 0.01°",
    "help.push": "power 0.5 · Shift 0.1 · Ctrl 0.01 m/s",
    "help.tip": "tip point by 0.05 R · Shift 0.01 R",
    "help.tilt": "raise the cue by 5° · Shift 1°: it hops",
    "help.centre": "centre, level cue; squirt",
    "help.thick": "next eighth, leftwards · Shift right",
    "key.squirt": "squirt of the cue ball on, off",
    "squirt.off": "squirt off",
    "squirt.left": "squirt {n}° left",
    "squirt.right": "squirt {n}° right",
    "help.aids": "aiming aids: off, short, full",
    "help.fan": "spread: ±0.05°, 2 %, 0.01 R",
    "help.time": "Time",
    "help.rate": "slower, faster: ×1/8 … ×8",
    "help.event": "to the event before, after",
    "help.undo": "undo, redo",
    "help.mouse.aim": (
        "Mouse · drag on the table to aim, Shift: ten times finer; "
        "wheel: turn, as @[turn 1] and @[turn -1] · pull the cue back for power"
    ),
    "help.mouse.cue": (
        "Drag tip point, elevation and power; the wheel works there too · "
        "click an eighth of the thickness · click a box to edit it"
    ),
    "help.mouse.time": (
        "After the shot · drag the timeline, click a row "
        "of the log · click beside ×1 for slower and faster"
    ),
}
