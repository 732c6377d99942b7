"""What the player has chosen for seeing and hearing: no action here changes what the balls do."""

from __future__ import annotations

from game.input.bindings import Keys
from game.session.action import Action
from game.session.commands import COMMANDS
from game.session.session import Session
from game.sound.audio import Audio

from .settings import CHOICES, LOUDEST, Settings, Store


class Preferences:
    """Settings in use, and the file they are kept in, if there is one.

    The commands that are a player's `own` are methods here, by the same names.
    """

    def __init__(self, settings: Settings | None = None, store: Store | None = None) -> None:
        self.settings = settings or Settings()
        self.store = store
        self.keys = Keys(self.settings.keys)
        self.audio = Audio()
        self.refused: tuple[str, str, str] | None = None
        """Why the last key that was wished could not be had: reason, action, key."""
        self._sound()

    def guided(self) -> None:
        """The guide is over: it is never shown again."""
        self.settings.guided = True
        self.save()

    def note(self, action: Action, session: Session) -> None:
        """Remember what an action of the game has chosen."""
        if action == Action("engine") and session.engine != "exact":
            return  # the key compares for a moment, and goes back; the settings page is for good
        if COMMANDS[action.name].kept:
            setattr(self.settings, action.name, getattr(session, action.name))
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

    def mute(self) -> None:
        """Sound on or off."""
        self.settings.muted = not self.settings.muted
        self._sound()

    def still(self) -> None:
        """Motion that only decorates on or off."""
        self.settings.still = not self.settings.still

    def both(self) -> None:
        """Events in one language or in both."""
        self.settings.both = not self.settings.both

    def fan(self) -> None:
        """The spread of the shot on or off."""
        self.settings.fan = not self.settings.fan

    def full(self) -> None:
        """Fill the screen, or show a window."""
        self.settings.full = not self.settings.full

    def graphs(self) -> None:
        """Curves of the shot, or its log."""
        self.settings.graphs = not self.settings.graphs

    def compare(self) -> None:
        """The shot by other laws and the other engine, over it, or not."""
        self.settings.compare = not self.settings.compare

    def export(self) -> None:
        """Nothing that is chosen: the app, which has the picture, writes the shot."""

    def volume(self, value: int) -> None:
        """Set the volume, 0 to LOUDEST."""
        self.settings.volume = min(max(value, 0), LOUDEST)
        self._sound()

    def aids(self, key: str = "") -> None:
        """Show so many aiming aids, or take the next setting."""
        keys = CHOICES["aids"]
        after = keys[(keys.index(self.settings.aids) + 1) % len(keys)]
        self.settings.aids = key or after

    def diamonds(self, key: str = "") -> None:
        """Show where strokes over the diamonds lead: none, one's own, or the corner system's."""
        keys = CHOICES["diamonds"]
        after = keys[(keys.index(self.settings.diamonds) + 1) % len(keys)]
        self.settings.diamonds = key or after

    def colours(self, key: str) -> None:
        """Take a set of balls."""
        self.settings.colours = key

    def level(self, key: str) -> None:
        """Let the coach count with this error of a stroke."""
        self.settings.level = key

    def bind(self, value: str) -> None:
        """Give an action another key ("ACTION KEY"), unless it cannot have it."""
        name, key = value.rsplit(" ", 1)
        try:
            self._use(self.keys.with_key(name, key))
        except ValueError as why:
            self.refused = str(why), name, key

    def unbind(self, name: str) -> None:
        """Give an action its usual key again, unless another one has that now."""
        rest = {n: k for n, k in self.keys.changed.items() if n != name}
        default = Keys().names[name]
        if self.keys.owner(default) in (None, name):
            self._use(Keys(rest))
        else:
            self.refused = "taken", name, default

    def _use(self, keys: Keys) -> None:
        self.keys, self.settings.keys = keys, keys.changed
