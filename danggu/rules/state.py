"""What stays between two strokes besides the score, what a player declares, what may be chosen."""

from __future__ import annotations

from dataclasses import dataclass

BREAK, SECOND, PLAY = "break", "second", ""
ANYWHERE, HEAD, D, HOUSE, AS_IT_LIES = "anywhere", "head_string", "d", "house", ""


@dataclass(frozen=True, slots=True)
class State:
    """How a game stands, whichever it is: a game reads and writes the fields it needs.

    phase     of the coming stroke: BREAK, SECOND (the stroke after it: a push out may be played)
    left      object balls on the table
    groups    the group of each player, () while the table is open
    on        in snooker "red", "colour" (any of them) or the colour that is on
    free      whether a free ball may be nominated
    fouls     consecutive fouls of each player
    warned    whether each player has been warned that the next foul is the third
    region    where the cue ball may be placed: ANYWHERE, HEAD (behind the head string), D, HOUSE
    touching  pairs of balls that touch as the stroke begins
    zone      how the object balls lie in balkline: "", "come_in", "in_there" or "astride"
    anchor    the same among the anchors
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

    ball, pocket  nominated, or "": where a free ball may be, `ball` is it
    safety, push  a safety, a push out
    cue           the ball that is played, where any ball may be; "" for the usual one
    """

    ball: str = ""
    pocket: str = ""
    safety: bool = False
    push: bool = False
    cue: str = ""


FRESH, NO_CALL = State(), Call()


@dataclass(frozen=True, slots=True)
class Option:
    """One answer: its key, whether the player asked `plays` (or the other), and what follows.

    rack     how many balls are racked, 0 for none
    spot     balls that are spotted
    restore  whether all balls go back to where they lay before the stroke
    """

    key: str
    plays: bool
    state: State
    rack: int = 0
    spot: tuple[str, ...] = ()
    restore: bool = False


@dataclass(frozen=True, slots=True)
class Question:
    """What a player may choose: the opponent of the one who played, or the shooter.

    optional  the first option holds unless another one is claimed, so the next stroke may be
              played without an answer
    """

    options: tuple[Option, ...]
    shooter: bool = False
    optional: bool = False

    def option(self, key: str) -> Option:
        """The option of that key; ValueError, naming those there are, for another."""
        for option in self.options:
            if option.key == key:
                return option
        keys = ", ".join(option.key for option in self.options)
        raise ValueError(f"answer one of {keys}, not {key!r:.60}")
