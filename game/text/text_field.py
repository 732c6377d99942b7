"""A line of text with a caret and a selection: every text field of the window is one."""

from __future__ import annotations

import unicodedata
from dataclasses import dataclass

END = 1 << 30


@dataclass(slots=True)
class TextField:
    """A text that is being edited; at first all of it is selected, and replaced by what is typed.

    text     what it says now
    longest  characters it takes
    caret    place between characters, from 0 to the length
    anchor   such a place too: what lies between it and the caret is selected
    """

    text: str = ""
    longest: int = END
    caret: int = END
    anchor: int = 0

    def __post_init__(self) -> None:
        self.caret = min(self.caret, len(self.text))

    @property
    def selection(self) -> tuple[int, int]:
        """Where the selected part begins and ends."""
        low, high = sorted((self.caret, self.anchor))
        return low, high

    @property
    def selected(self) -> str:
        """The selected part."""
        low, high = self.selection
        return self.text[low:high]

    def type(self, text: str) -> bool:
        """Put characters in place of the selection; returns whether there was room for all.

        Syllables that come in pieces are put together: 16 characters are 16 that can be seen.
        """
        low, high = self.selection
        behind = self.text[high:]
        before = unicodedata.normalize("NFC", self.text[:low] + text)
        room = max(self.longest - len(behind), 0)
        self._set(before[:room] + behind, min(len(before), room))
        return len(before) <= room

    def erase(self) -> None:
        """Delete the selection, or else the character before the caret."""
        self._delete(-1)

    def delete(self) -> None:
        """Delete the selection, or else the character after the caret."""
        self._delete(1)

    def go(self, to: str | int) -> None:
        """Move the caret: "left" "right" "home" "end", "back" or "ahead" by a word, or to a place.

        With "+" before it the selection follows; "all" selects everything.
        """
        if to == "all":
            self.anchor, self.caret = 0, len(self.text)
            return
        keep, step = str(to).startswith("+"), str(to).removeprefix("+")
        low, high = self.selection
        if low < high and not keep and step in ("left", "right"):
            self.caret = low if step == "left" else high
        else:
            self.caret = self._place(step)
        self.anchor = self.anchor if keep else self.caret

    def _place(self, step: str) -> int:
        before, after = self.text[: self.caret], self.text[self.caret :]
        match step:
            case "left" | "right":
                to = self.caret + (1 if step == "right" else -1)
            case "home" | "end":
                to = 0 if step == "home" else len(self.text)
            case "back":
                to = before.rstrip().rfind(" ") + 1
            case "ahead":
                to = len(self.text) - len(after.lstrip().partition(" ")[2])
            case _:
                to = int(step)
        return min(max(to, 0), len(self.text))

    def _delete(self, way: int) -> None:
        low, high = self.selection
        if low == high:
            low, high = max(min(low, low + way), 0), max(high, high + way)
        self._set(self.text[:low] + self.text[high:], low)

    def _set(self, text: str, caret: int) -> None:
        self.text = text
        self.caret = self.anchor = caret
