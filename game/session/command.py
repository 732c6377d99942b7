"""What a command is: its name, what it does, what it takes, and the keys and words that lead to it.

The table of all of them is `commands.TABLE`; keys, the page of keys, the settings page, records,
the question before a match ends and the computer's turn ask it.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

from .action import Action
from .values import NOTHING, Value


class Key(NamedTuple):
    """A key by pygame's name for it, and the value of the command that it does.

    always  does it work while text is typed and while a page is open, too?
    shift   what it does with Shift held, if that is another command
    """

    name: str
    value: str | int | None = None
    always: bool = False
    shift: Action | None = None


class HelpRow(NamedTuple):
    """A row of the page of keys.

    section  "play" "box" "aim" "time" "always" "shots" "practice"
    place    of the row in its section
    keys     as they are written: a key of the texts, or "@" and the command whose key it is
    text     key of the texts for what they do
    """

    section: str
    place: float
    keys: str
    text: str


class Command(NamedTuple):
    """Something that a player, a record or the computer can have done.

    name          what actions, records and settings call it
    do            does it, given the session, or the player's settings if it is `own`, and the value
    value         what it takes
    keys          what does it, unless the player has chosen another key
    rows          of the page of keys; None: one of its own for each key, at the end
    own           is it about the player's settings, and so in no record?
    kept          do the player's settings remember what it has chosen?
    step          is it a step to undo?
    drags         are many in a row one step?
    writes        does it write boxes that a player may want back, so that this is a step too?
    keeps_notice  does the notice that is on show stay?
    aims          is it about the coming stroke, and so refused on the computer's turn?
    hurries       does it make the computer strike, on its turn?
    repeats       does it go on while its key is held?
    finer         the steps that its keys take with Shift and with Ctrl
    ends_match    why a running match asks first: "always" "begun" (once a stroke has been played)
                  "terms" (if it changes what is played with), or "" for never
    """

    name: str
    do: Callable[..., None]
    value: Value = NOTHING
    keys: tuple[Key, ...] = ()
    rows: tuple[HelpRow, ...] | None = None
    own: bool = False
    kept: bool = False
    step: bool = True
    drags: bool = False
    writes: bool = False
    keeps_notice: bool = False
    aims: bool = False
    hurries: bool = False
    repeats: bool = False
    finer: tuple[str, str] | None = None
    ends_match: str = ""

    def fault(self, value: object) -> str:
        """Say what it takes instead of a value, or "" if it takes that."""
        return self.value.fault(value)

    def written(self) -> str:
        """The command and what it takes: "turn DEGREES"."""
        return f"{self.name} {self.value.label}".rstrip()
