"""What the player has chosen for seeing and hearing: no action here changes what the balls do."""

from __future__ import annotations

from collections.abc import Callable
from typing import ClassVar

from game.input.bindings import Keys
from game.session.action import Action
from game.session.session import Game
from game.sound.audio import Audio

from .settings import CHOICES, LOUDEST, Settings, Store


class Preferences:
    """Settings in use, and the file they are kept in, if there is one.

    Its actions: mute · still · both · fan · volume 0..10 · aids KEY (no key: the next one) ·
    colours KEY · bind "ACTION KEY" · unbind ACTION.
    """

    def __init__(self, settings: Settings | None = None, store: Store | None = None) -> None:
        self.settings = settings or Settings()
        self.store = store
        self.keys = Keys(self.settings.keys)
        self.audio = Audio()
        self.refused: tuple[str, str, str] | None = None
        """Why the last key that was wished could not be had: reason, action, key."""
        self._sound()

    def perform(self, action: Action) -> bool:
        """Do an action that is one of these; returns whether it was."""
        handler = self._handlers.get(action.name)
        if handler is not None:
            self.refused = None
            handler(self, action.value)
        return handler is not None

    def note(self, action: Action, game: Game) -> None:
        """Remember what an action of the game has chosen."""
        if action == Action("engine") and game.engine != "exact":
            return  # the key compares for a moment, and goes back; the settings page is for good
        if action.name in ("language", "table", "cloth", "law", "engine"):
            setattr(self.settings, action.name, getattr(game, action.name))
        if action.name == "table":
            self.settings.law = self.settings.cloth = "table"

    def save(self) -> bool:
        """Write the file, if there is one and anything has changed; returns whether it is good."""
        return self.store is None or self.store.save(self.settings)

    def _sound(self) -> None:
        self.audio.volume = self.settings.volume / LOUDEST
        self.audio.muted = self.settings.muted
        if self.audio.silent:
            self.audio.close()

    def _mute(self, _: object) -> None:
        self.settings.muted = not self.settings.muted
        self._sound()

    def _still(self, _: object) -> None:
        self.settings.still = not self.settings.still

    def _both(self, _: object) -> None:
        self.settings.both = not self.settings.both

    def _fan(self, _: object) -> None:
        self.settings.fan = not self.settings.fan

    def _volume(self, value: int) -> None:
        self.settings.volume = min(max(value, 0), LOUDEST)
        self._sound()

    def _aids(self, key: str | None) -> None:
        keys = CHOICES["aids"]
        after = keys[(keys.index(self.settings.aids) + 1) % len(keys)]
        self.settings.aids = key if key is not None else after

    def _colours(self, key: str) -> None:
        self.settings.colours = key

    def _bind(self, value: str) -> None:
        name, key = value.rsplit(" ", 1)
        try:
            self._use(self.keys.with_key(name, key))
        except ValueError as why:
            self.refused = str(why), name, key

    def _unbind(self, name: str) -> None:
        rest = {n: k for n, k in self.keys.changed.items() if n != name}
        default = Keys().names[name]
        if self.keys.owner(default) in (None, name):
            self._use(Keys(rest))
        else:
            self.refused = "taken", name, default

    def _use(self, keys: Keys) -> None:
        self.keys, self.settings.keys = keys, keys.changed

    _handlers: ClassVar[dict[str, Callable[..., None]]] = {
        "mute": _mute, "still": _still, "both": _both, "fan": _fan, "volume": _volume,
        "aids": _aids, "colours": _colours, "bind": _bind, "unbind": _unbind,
    }  # fmt: skip
