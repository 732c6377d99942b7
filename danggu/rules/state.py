"""The state of a game besides the score, what a player declares, and what may be chosen."""

from __future__ import annotations

from dataclasses import dataclass

BREAK, SECOND, PLAY = "break", "second", ""
# regions: but for the last, those of a `physics.tables.Table`
ANYWHERE, KITCHEN, D, HOUSE, AS_IT_LIES = "anywhere", "kitchen", "D", "house", ""


@dataclass(frozen=True, slots=True)
class GameState:
    """The state of any game between strokes; each game uses the fields it needs.

    phase: of the coming stroke: BREAK, SECOND (the one after it, which may be a push out) or PLAY.
    left: names of the object balls on the table.
    groups: the group of each player, () while the table is open.
    on: in snooker "red", "colour" (any of them) or the name of the colour that is on.
    free: whether a free ball may be nominated.
    fouls: consecutive fouls of each player.
    warned: whether each player has been warned that the next foul is the third.
    region: where the cue ball may be placed: ANYWHERE, KITCHEN (behind the head string), D,
    HOUSE, or AS_IT_LIES if it is not in hand.
    touching: pairs of balls that touch as the stroke begins.
    zone: how the object balls lie in balkline: "", "come_in", "in_there" or "astride".
    anchor: the same for the anchors.
    """

    phase: str = PLAY
    left: tuple[str, ...] = ()
    groups: tuple[str, ...] = ()
    on: str = ""
    free: bool = False
    fouls: tuple[int, ...] = ()
    warned: tuple[bool, ...] = ()
    region: str = AS_IT_LIES
    touching: tuple[tuple[str, str], ...] = ()
    zone: str = ""
    anchor: str = ""

    def group(self, player: int) -> str:
        """The group of a player, "" while the table is open."""
        return self.groups[player % len(self.groups)] if self.groups else ""


@dataclass(frozen=True, slots=True)
class Call:
    """What a player declares before a stroke.

    ball, pocket: names of those nominated, or ""; `ball` is also the free ball.
    safety, push: whether the stroke is a safety, or a push out.
    cue: name of the ball that is played, where any ball may be; "" for the usual one.
    """

    ball: str = ""
    pocket: str = ""
    safety: bool = False
    push: bool = False
    cue: str = ""


FRESH, NO_CALL = GameState(), Call()


@dataclass(frozen=True, slots=True)
class Option:
    """One answer to a question, and what follows from it.

    key: in the texts.
    plays: whether the player who answers plays next, not the other.
    state: of the game afterwards.
    rack: how many balls are racked, 0 for none.
    spot: names of the balls that are spotted.
    restore: whether all balls go back to where they lay before the stroke.
    """

    key: str
    plays: bool
    state: GameState
    rack: int = 0
    spot: tuple[str, ...] = ()
    restore: bool = False


@dataclass(frozen=True, slots=True)
class Question:
    """What a player may choose.

    options: the possible answers.
    shooter: whether the shooter answers, not the opponent.
    optional: whether the next stroke may be played without an answer, as if the first option had
    been chosen.
    """

    options: tuple[Option, ...]
    shooter: bool = False
    optional: bool = False

    def option(self, key: str) -> Option:
        """The option with that key; ValueError, naming the keys, if there is none."""
        for option in self.options:
            if option.key == key:
                return option
        keys = ", ".join(option.key for option in self.options)
        raise ValueError(f"answer one of {keys}, not {key!r:.60}")
