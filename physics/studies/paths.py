"""Where the balls of a finished shot are at given moments, and how that depends on its inputs."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from physics.kernel.leg import travelled
from physics.shot import Shot
from physics.world import World

from .dual import value
from .sensitivity import Replay

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

    Places = npt.NDArray[np.complex128]


def places(world: World, times: npt.NDArray[np.float64]) -> Places:
    """(T, balls), complex, m: at so many seconds after the epoch; before it, as it began."""
    import numpy as np

    return np.stack([course(world, ball.name, times) for ball in world.balls], axis=1)


def course(world: World, ball: str, times: npt.NDArray[np.float64]) -> Places:
    """(T,) of one ball."""
    import numpy as np

    legs = world.log.legs(ball)
    since, p, v, a = np.array(
        [(leg.since, leg.position, leg.velocity, leg.acceleration) for leg in legs]
    ).T
    k, t = _on_legs(since.real, times)
    found: Places = travelled(p[k], v[k], a[k], t)
    return found


def _on_legs(since: Any, times: Any) -> tuple[Any, Any]:
    """The leg at each moment, and how far into it."""
    import numpy as np

    k = np.maximum(np.searchsorted(since, times, side="right") - 1, 0)
    return k, np.maximum(times - since[k], 0.0)


class Paths(Replay):
    """A replay that remembers its legs."""

    def __init__(self, world: World, struck: str, shot: Shot, by: tuple[str, ...]) -> None:
        self.legs: dict[int, list[tuple[Any, ...]]] = {}
        super().__init__(world, struck, shot, by)
        for _ in self.events():
            pass

    def plan(self, body: Any) -> None:
        super().plan(body)
        leg = body.since, body.position, body.velocity, body.acceleration
        self.legs.setdefault(id(body), []).append(leg)

    def slopes(self, ball: int, times: npt.NDArray[np.float64]) -> tuple[Places, Places, Places]:
        """(T,) places, (T, N) their slopes by the inputs, (T,) velocities, at fixed times."""
        import numpy as np

        legs = self.legs[id(self.balls[ball])]
        since, p, v, a = np.array([[value(x) for x in leg] for leg in legs]).T
        late, p_by, v_by, a_by = (
            np.array([self.slope(leg[part]) for leg in legs]) for part in range(4)
        )
        k, t = _on_legs(since.real, times)
        speed, wide = v[k] + t * a[k], t[:, None]
        found = travelled(p_by[k], v_by[k], a_by[k], wide) - speed[:, None] * late[k]
        return travelled(p[k], v[k], a[k], t), found, np.where(times > 0.0, speed, 0j)
