"""Racks or frames: who has won how many, and who breaks the next."""

from __future__ import annotations

from dataclasses import dataclass, replace

ALTERNATE, WINNER, LOSER = "alternate", "winner", "loser"


@dataclass(frozen=True, slots=True)
class Race:
    """A race to a number of racks, or a best of frames.

    to: racks needed to win; in a best of n frames, (n + 1) / 2.
    won: racks won by each player.
    breaker: index of the player who breaks the current rack.
    breaks: which player breaks the next one: "alternate", the "winner" or the "loser" of the last.
    """

    to: int
    won: tuple[int, ...] = (0, 0)
    breaker: int = 0
    breaks: str = ALTERNATE

    def __post_init__(self) -> None:
        if type(self.to) is not int or self.to < 1:
            raise ValueError(f"a race is to a whole number, 1 or more, not {self.to!r:.60}")
        if self.breaks not in (ALTERNATE, WINNER, LOSER):
            known = f"{ALTERNATE}, {WINNER} or {LOSER}"
            raise ValueError(f"breaks must be {known}, not {self.breaks!r:.60}")

    @property
    def winner(self) -> int | None:
        """Index of the player who has won the race, or None."""
        return self.won.index(self.to) if self.to in self.won else None

    def after(self, winner: int) -> Race:
        """The race with one more rack won by this player; ValueError if it is over, or for a
        player that is none."""
        if self.winner is not None:
            raise ValueError("the race is over")
        if winner not in range(len(self.won)):
            raise ValueError(f"there is no player {winner!r:.60}: there are {len(self.won)}")
        won = tuple(count + (i == winner) for i, count in enumerate(self.won))
        players = len(self.won)
        follows = {
            ALTERNATE: (self.breaker + 1) % players,
            WINNER: winner,
            LOSER: (winner + 1) % players,
        }
        return replace(self, won=won, breaker=follows[self.breaks])
