"""English: the first minute, drills, diamonds, and shots that are kept and shared."""

WORDS = {
    "event.of.strike": "{ball} struck",
    "event.of.cushion": "{ball} → {said}",
    "event.of.rest": "{ball} {said}",
    "launch.speed": "ball leaves at",
    "launch.spin": "spin",
    "launch.squirt": "squirt",
    "launch.rise": "hops at",
    "launch.left": "left",
    "launch.right": "right",
    "unit.spin": "turns/s",
    "key.full": "full screen, window",
    "hall.points": "{points} points",
    "hall.handicap": "handicap {hall}",
    "menu.hint.hall": (
        "{points} points: in a Korean hall a 수지 of {hall} · ← → by 1, PgUp PgDn by 10"
    ),
}
