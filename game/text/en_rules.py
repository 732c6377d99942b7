"""English: the rules of pool, snooker, pyramid and the other games of carom."""

POOL_FOULS = (
    "A foul is: the cue ball down or off the table, a wrong ball hit first, none hit, or no ball "
    "driven to a cushion or into a pocket after the first contact."
)
CAROM_POINT = "A point for both other balls; the inning goes on until a stroke scores nothing."
BALKLINE = (
    "Lines divide the cloth. While both object balls lie in one zone, or in one anchor at a "
    "cushion, only {n} there."
)
ONE, TWO = "one stroke may score", "two strokes in a row may score"
OUT = "The stroke after that must drive a ball out of it; a ball that comes back counts as new."
WORDS = {
    "rule.one-cushion.1": "A point for both other balls, with a cushion before the second one.",
    "rule.one-cushion.2": "The opening stroke must hit the red first, unless chosen otherwise.",
    "rule.one-cushion.3": "A ball off the table is a foul: all balls go to the opening position.",
    "rule.straight-rail.1": CAROM_POINT,
    "rule.straight-rail.2": (
        "In each corner a triangle is barred: with both object balls in it only two strokes in a "
        "row may score."
    ),
    "rule.straight-rail.3": OUT,
    "rule.balkline-47/1.1": CAROM_POINT,
    "rule.balkline-47/1.2": BALKLINE.format(n=ONE),
    "rule.balkline-47/1.3": OUT,
    "rule.balkline-47/2.1": CAROM_POINT,
    "rule.balkline-47/2.2": BALKLINE.format(n=TWO),
    "rule.balkline-47/2.3": OUT,
    "rule.balkline-71/2.1": CAROM_POINT,
    "rule.balkline-71/2.2": BALKLINE.format(n=TWO),
    "rule.balkline-71/2.3": OUT,
    "rule.8-ball.1": "Pot the seven balls of your group, solids or stripes, and then the 8.",
    "rule.8-ball.2": (
        "The first ball potted as called after the break decides the groups. Call ball "
        "(@[ball 1]) and pocket (@[pocket 1]); uncalled, the ball that is hit first is meant."
    ),
    "rule.8-ball.3": POOL_FOULS,
    "rule.8-ball.4": "After a foul the opponent places the cue ball anywhere.",
    "rule.8-ball.5": "The 8 too early, in a pocket not called, or with a foul, loses the rack.",
    "rule.8-ball.6": (
        "The break must pot a ball or drive four to cushions; otherwise the opponent chooses."
    ),
    "rule.9-ball.1": "The lowest ball must be hit first; whoever pots the 9 in any way wins.",
    "rule.9-ball.2": POOL_FOULS,
    "rule.9-ball.3": "After a foul the opponent places the cue ball anywhere.",
    "rule.9-ball.4": (
        "Right after the break a push out (@[call push]) need hit nothing; then the opponent "
        "chooses which of the two shoots."
    ),
    "rule.9-ball.5": "Three fouls in a row lose the rack; the second one brings a warning.",
    "rule.10-ball.1": "The lowest ball must be hit first, and every ball is called.",
    "rule.10-ball.2": "The 10 wins when it is the last ball; earlier it is spotted, or as chosen.",
    "rule.10-ball.3": POOL_FOULS,
    "rule.10-ball.4": "A push out (@[call push]) and three fouls in a row are as in 9-ball.",
    "rule.10-ball.5": "If a ball drops uncalled, the opponent chooses which of the two shoots.",
    "rule.14.1.1": "Any ball is a point if it drops as called; the first to the target wins.",
    "rule.14.1.2": "When one ball is left, the other fourteen are racked again without the apex.",
    "rule.14.1.3": (
        "A foul costs a point, and three in a row fifteen more. The opening break must drive two "
        "balls and the cue ball to cushions: otherwise it costs two."
    ),
    "rule.14.1.4": "Call a safety (@[call safety]) to pass the turn without potting.",
    "rule.snooker.1": "A red, then a colour, and so on; while reds last, colours are spotted.",
    "rule.snooker.2": (
        "Red 1, yellow 2, green 3, brown 4, blue 5, pink 6, black 7. Name a colour with "
        "@[ball 1]; unnamed, the one that is hit first is meant."
    ),
    "rule.snooker.3": "At the end the colours go in this order and stay down.",
    "rule.snooker.4": (
        "A foul gives the opponent the value of the ball on or of the ball concerned, 4 at least."
    ),
    "rule.snooker.5": (
        "After a foul the opponent plays, has the other play again, or after a miss has the stroke "
        "repeated. Where no ball on can be hit on both edges, any ball is free."
    ),
    "rule.free-pyramid.1": "Any ball may be played with; eight balls that drop win.",
    "rule.free-pyramid.2": "Choose the ball to play with @[ball 1]; its own fall counts as well.",
    "rule.free-pyramid.3": "A stroke must pot a ball or drive one to a cushion.",
    "rule.free-pyramid.4": "A foul costs what is chosen in the menu.",
    "rule.dynamic-pyramid.1": "Only the cue ball is played; eight balls win.",
    "rule.dynamic-pyramid.2": (
        "If the cue ball drops off another ball, that counts: take any ball away, and place the "
        "cue ball anywhere."
    ),
    "rule.dynamic-pyramid.3": "A stroke must pot a ball or drive one to a cushion.",
    "rule.combined-pyramid.1": "Only the cue ball is played; eight balls win.",
    "rule.combined-pyramid.2": (
        "If the cue ball drops off another ball, that counts: take any ball away, and place the "
        "cue ball in the house."
    ),
    "rule.combined-pyramid.3": "A stroke must pot a ball or drive one to a cushion.",
}
