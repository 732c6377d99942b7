"""What is in a world: balls and walls, put in, taken out and looked up."""

from dataclasses import replace
from math import fsum
from typing import Any, TypeVar

from .ball import Ball, Clock
from .kernel.body import Scene, no_ties
from .log import Log
from .room import check_room
from .wall import Obstacle

Thing = TypeVar("Thing", bound=Ball | Obstacle)


class Contents:
    """The part of a World that knows what is in it."""

    __slots__ = ()  # World has them

    _balls: list[Ball]
    _checked: int
    _clock: Clock
    _discs: bool
    _index: dict[str, int]
    _table: Any
    _walls: list[Obstacle]
    log: Log
    scene: Scene

    def __repr__(self) -> str:
        return f"<World of {len(self._balls)} balls at t = {self.time!r} s>"

    def add(self, thing: Thing) -> Thing:
        """Put a ball, a wall, a post or a pocket into the world; returns it."""
        self._refuse_laws("add")
        if isinstance(thing, Ball):
            if thing.name in self._index:
                raise ValueError(f"there is a ball {thing.name!r} already")
            thing.join(self._clock, self._table)
            self._enlist(thing)
        elif isinstance(thing, Obstacle):
            check_room(thing, self._walls)
            self._walls.append(thing)
            self.scene.walls.append(thing.shape)
            self._renew_rules()
        else:
            raise ValueError(f"a world takes a Ball or a Wall, Post or Pocket, not {thing!r}")
        self._clock.moved = True
        self._disturb()
        return thing

    def remove(self, thing: Ball | str | Obstacle) -> Ball | Obstacle:
        """Take a ball, or the one of that name, or a wall out of the world; returns it.

        The ball keeps its motion, and may be added again, here or elsewhere. All else goes on as it
        was; but the log begins again, since it speaks of all that was there. ValueError for what is
        not in the world.
        """
        self._refuse_laws("remove")
        found = thing if isinstance(thing, Obstacle) else self.ball(thing)
        if isinstance(found, Obstacle):
            if all(wall is not found for wall in self._walls):
                raise ValueError(f"there is no {found.noun} {found!r} in this world")
        elif isinstance(thing, Ball) and thing is not found:
            raise ValueError(f"{thing!r} is not in this world, but another ball of its name is")
        self._disturb()
        kept = [ball for ball in self._balls if ball is not found]
        walls = [wall for wall in self._walls if wall is not found]
        if isinstance(found, Ball):
            found.leave()
        self._balls.clear()
        self._index.clear()
        self._walls[:] = walls
        self.log = Log()  # type: ignore[misc]
        self.log.watch(self._walls)
        self.scene = self.scene._replace(  # type: ignore[misc]
            balls=[], walls=[wall.shape for wall in walls], meetings=[], ties=no_ties(0)
        )
        for ball in kept:
            self._enlist(ball)
        self._checked = min(self._checked, len(walls))  # type: ignore[misc]
        self._clock.moved = True
        self._renew_rules()
        return found

    @property
    def balls(self) -> tuple[Ball, ...]:
        """In the order in which they were added."""
        return tuple(self._balls)

    @property
    def walls(self) -> tuple[Obstacle, ...]:
        """In the order in which they were added."""
        return tuple(self._walls)

    def ball(self, ball: Ball | str) -> Ball:
        """This world's ball of that name (or of that ball's name); ValueError if it has none."""
        name = ball.name if isinstance(ball, Ball) else ball
        if name not in self._index:
            raise ValueError(f"there is no ball {name!r} in this world")
        return self._balls[self._index[name]]

    @property
    def discs(self) -> bool:
        """Are its balls flat?  Radii r and R then touch r + R apart, else 2 √(r R)."""
        return self._discs

    @property
    def table(self) -> Any:
        """The `tables.Table` it stands on, with its spots and racks, or None.

        Cloth and laws that are assigned to the world become the table's too.
        """
        return self._table

    def _give_table(self, **mine: Any) -> None:
        """A table that has cloth and laws gets those that the world was given."""
        table: Any = self._table
        if mine.keys() <= {*getattr(table, "__dataclass_fields__", ())}:
            self._table = replace(table, **mine)

    @property
    def energy(self) -> float:
        """Of all balls now, J: of moving and turning, and what gravity has stored in them."""
        return fsum(ball.energy for ball in self._balls)

    # -- what the rest of the world does with it -----------------------------------------------

    @property
    def time(self) -> float:
        raise NotImplementedError

    def _refuse_laws(self, call: str) -> None:
        raise NotImplementedError

    def _renew_rules(self) -> None:
        raise NotImplementedError

    def _disturb(self) -> None:
        raise NotImplementedError

    def _enlist(self, ball: Ball) -> None:
        raise NotImplementedError
