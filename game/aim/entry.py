"""The one aim state: five texts, the numbers they mean, and which box is being edited.

A cue raised by hand adds a sixth text, its elevation: the ball is then driven into the cloth, and
hops. Without it the five numbers are all that there is.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import lru_cache
from math import isfinite

from game.text.numerals import MINUS, hopeless, plain, shown, typed, value
from game.text.text_field import TextField
from physics import Shot, direction

from .tip import Tip, squirt, tip_of

__all__ = ["BOXES", "MINUS", "MOST", "Aim", "Fault", "fault", "plain", "shown", "typed", "value"]

BOXES = ("speed", "follow", "masse", "side", "angle")
"""V, Wx·R, Wy·R, Wz·R and the angle, as `physics.Shot` calls them, in the order of the boxes."""
MOST = {"speed": 50.0, "follow": 100.0, "masse": 100.0, "side": 100.0, "angle": 3600.0}
"""Largest size of each number: far beyond any cue, and what the window can still follow."""
LEAST = 0.01
"""The slowest speed that a box can say, m/s."""
LONGEST = 16
"""Characters a box takes."""
CUT = "…"
"""What a text ends with that did not fit: so it is no number, and says why."""
START = ("3.5", "1", "0", "2", "34.5")
"""What the boxes hold at first: on the medium table it makes both reds, over five cushions."""


@dataclass(frozen=True, slots=True)
class Fault:
    """Why a box has no usable number: "empty" "number" "finite" "positive" or "most"."""

    box: int
    reason: str


@lru_cache(maxsize=256)
def fault(box: int, text: str) -> Fault | None:
    """Return what is wrong with the text of a box, or None."""
    if not text.strip():
        return Fault(box, "empty")
    try:
        number = value(text)
    except ValueError:
        return Fault(box, "number")
    if not isfinite(number):
        return Fault(box, "finite")
    if BOXES[box] == "speed" and number <= 0.0:
        return Fault(box, "positive")
    if abs(number) > MOST[BOXES[box]]:
        return Fault(box, "most")
    return None


@dataclass(slots=True)
class Aim:
    """What the next shot will be.

    texts     of the five boxes, and the elevation of a cue that is raised by hand, degrees
    box       the one being edited, None in play
    complete  may RETURN shoot?  Once for each entry
    wrong     has an entry been refused, and no good shot followed yet?
    strongest  speed to which it can be raised by hand, m/s: the boxes take any
    left      boxes that have been left since editing began: only their faults are shown
    hops      does a cue that is raised by hand make the ball hop?
    squirts   does the cue stay where it points while the tip is moved, and the ball leave it?
    forced    the elevation that the cue was given for want of room, and the one it had before
    _held     the tip point that was set last, what was then written, and the power
    """

    texts: list[str] = field(default_factory=lambda: list(START))
    box: int | None = None
    complete: bool = True
    wrong: bool = False
    left: set[int] = field(default_factory=set)
    strongest: float = 8.0
    hops: bool = True
    squirts: bool = False
    forced: tuple[str, float] | None = None
    _edited: TextField = field(default_factory=TextField)
    _held: tuple[Tip, list[str], float] | None = None

    @property
    def faults(self) -> list[Fault]:
        """Everything that keeps the entry from being a shot, in the order of the boxes."""
        found = (fault(i, text) for i, text in enumerate(self.texts[: len(BOXES)]))
        return [f for f in found if f is not None]

    @property
    def shown_faults(self) -> list[Fault]:
        """The faults to point at: not those of boxes the player has not come to yet.

        Nor that of the box being edited, as long as more characters may make a number of it.
        """
        if self.wrong:
            return self.faults
        return [fault for fault in self.faults if self._shows(fault)]

    def _shows(self, fault: Fault) -> bool:
        if fault.box == self.box:
            return hopeless(self.texts[fault.box])
        return fault.box in self.left

    @property
    def shot(self) -> Shot | None:
        """The shot that the five texts mean, or None."""
        if self.faults:
            return None
        return self._shot(len(BOXES))

    def _shot(self, boxes: int) -> Shot:
        """The shot of the first boxes, which have no faults."""
        given = dict(zip(BOXES[:boxes], map(value, self.texts[:boxes]), strict=True))
        cue = direction(self.raised)
        return Shot(**given, climb=0.0 - given["speed"] * cue.imag / cue.real)

    @property
    def raised(self) -> float:
        """The elevation of the cue that makes the ball hop, degrees; 0 without a sixth text."""
        return value(self.texts[len(BOXES)]) if len(self.texts) > len(BOXES) else 0.0

    def lower(self) -> None:
        """The five boxes are all that there is again."""
        del self.texts[len(BOXES) :]

    def number(self, name: str) -> float | None:
        """The number in one box, while the rest of the entry may still be missing."""
        box = BOXES.index(name)
        return None if fault(box, self.texts[box]) else value(self.texts[box])

    @property
    def angle(self) -> float | None:
        """The angle alone, degrees."""
        return self.number("angle")

    @property
    def squirt(self) -> float:
        """By how many degrees the ball leaves the cue's line, + to the left; 0 without squirt."""
        tip = self.tip if self.squirts else None
        return 0.0 if tip is None else squirt(tip.right)

    @property
    def cue_angle(self) -> float | None:
        """The direction of the cue, degrees: with squirt not quite that of the ball."""
        return None if self.angle is None else self.angle - self.squirt

    @property
    def edited(self) -> TextField | None:
        """The text of the box being edited, with its caret; None in play."""
        if self.box is None:
            return None
        if self._edited.text != self.texts[self.box]:
            self._edited = TextField(self.texts[self.box], LONGEST)
        return self._edited

    def edit(self, box: int = 0, clear: bool = False) -> None:
        """Begin or go on editing at `box`, all of it selected; `clear` empties all five first."""
        if clear:
            self.texts = [""] * len(BOXES)
        if self.box is None:
            self.left = set()
        else:
            self.left.add(self.box)
        self.box, self.complete = box % len(BOXES), False
        self._edited = TextField(self.texts[self.box], LONGEST)

    def type(self, text: str) -> bool:
        """Put characters at the caret, or in place of what is selected.

        Returns whether there was room for all: a longer text ends so that it can be no number.
        """
        edited, added = self.edited, typed(text)
        if edited is None or not added:
            return True
        room = LONGEST - len(edited.text) + len(edited.selected)
        fits = len(added) <= room
        if not fits and len(added) > 1:
            added = added[: max(room - len(CUT), 0)] + CUT
        self._change(lambda field: field.type(added[:room]) if room else None)
        return fits

    def erase(self) -> None:
        """Delete the character before the caret, or what is selected."""
        self._change(TextField.erase)

    def delete(self) -> None:
        """Delete the character after the caret, or what is selected."""
        self._change(TextField.delete)

    def go(self, to: str | int) -> None:
        """Move the caret, as `TextField.go` does."""
        self._change(lambda field: field.go(to))

    def _change(self, change: Callable[[TextField], object]) -> None:
        edited = self.edited
        if edited is not None and self.box is not None:
            change(edited)
            if edited.text != self.texts[self.box] and BOXES[self.box] != "angle":
                self.lower()
            self.texts[self.box] = edited.text

    def enter(self) -> None:
        """Go to the next box; after the last one the entry is complete, if it can be read."""
        if self.box is None:
            return
        if self.box < len(BOXES) - 1:
            self.edit(self.box + 1)
        else:
            self.leave()
            self.finish()

    def leave(self) -> None:
        """Stop editing."""
        if self.box is not None:
            self.left.add(self.box)
        self.box = None

    def finish(self) -> bool:
        """Declare the entry complete; returns whether it can be shot."""
        self.complete = not self.faults
        self.wrong = self.wrong or not self.complete
        return self.complete

    def put(self, places: int = 2, /, **numbers: float) -> None:
        """Write numbers into boxes by name, rounded to so many places."""
        for name, number in numbers.items():
            self.texts[BOXES.index(name)] = plain(number, places)

    @property
    def tip(self) -> Tip | None:
        """Where the tip must meet the ball for the speed and the spins; None while one is missing.

        The boxes are rounded: while they hold what `hold` has written, it is what was held.
        """
        if self._held and self._held[1] == self._written():
            return self._held[0]
        if any(BOXES[fault.box] != "angle" for fault in self.faults):
            return None
        return tip_of(self._shot(4))

    def _written(self) -> list[str]:
        return self.texts[:4] + self.texts[len(BOXES) :]

    @property
    def power(self) -> float | None:
        """The speed along the cue, m/s: what the same cue gives a ball if it is level."""
        if self.raised and self._held and self._held[1] == self._written():
            return self._held[2]
        speed, tip = self.number("speed"), self.tip
        if speed is None or tip is None:
            return speed
        return speed / self._cosine(tip)

    def _cosine(self, tip: Tip) -> float:
        return direction(tip.elevation or 0.0).real if self.hops else 1.0

    def hold(self, tip: Tip, power: float | None = None) -> bool:
        """Write what a tip point gives for the power, which stays if it is None.

        Returns whether there is a speed: without one a tip point gives no spins.
        """
        was, known = self.tip or Tip(0.0, 0.0), self.power if power is None else power
        if known is None:
            return False
        if power is not None or self._cosine(tip) != self._cosine(was):
            self.put(speed=max(LEAST, known * self._cosine(tip)) if self.hops else known)
        self.lower()
        if self.hops and tip.elevation:
            self.texts.append(plain(tip.elevation, 2))
        self.put(**tip.spins(value(self.texts[0])))
        if self.squirts and self.angle is not None:
            self.put(4, angle=self.angle + squirt(tip.right) - squirt(was.right))
        self._held = tip, self._written(), known
        return True

    def speed(self, power: float) -> None:
        """Write a power, and the spins that the same tip point then gives."""
        tip = self.tip
        if tip is None:
            self.put(speed=power)
        elif tip.elevation is not None:
            self.hold(tip, power)
        else:
            now, *spins = map(value, self.texts[:4])
            share = power / now
            self.put(speed=power, **{n: share * w for n, w in zip(BOXES[1:4], spins, strict=True)})

    def spent(self) -> None:
        """The shot has been played: the next one needs a new entry."""
        self.complete = self.wrong = False
        self.left = set()
