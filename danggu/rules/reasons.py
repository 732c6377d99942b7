"""Why strokes of cannon games and of 8-ball count or do not: keys of the texts; and the 8."""

CANNON, BANK = "cannon", "bank_cannon"
OPENING_NOT_RED, OPENING_BANK = "opening_not_red", "opening_bank"
INTO_CUSHION = "into_cushion"
BOTH_REDS, BOTH_REDS_3C, ONE_RED = "both_reds", "both_reds_3c", "one_red"
NO_RED, OPPONENT_BALL = "no_red", "opponent_ball"
EIGHT, ILLEGAL_BREAK, EIGHT_ON_BREAK = "8", "illegal_break", "eight_on_break"
