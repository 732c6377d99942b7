"""Two players taking turns at one table, as a PettingZoo environment."""

from __future__ import annotations

from typing import Any, ClassVar

import numpy as np

from .kept import kept

with kept("SDL_AUDIODRIVER", "PYGAME_HIDE_SUPPORT_PROMPT"):  # it takes the sound from all of SDL
    from pettingzoo import AECEnv

from .match_hall import RACK_GAMES, MatchHall, worth
from .setup import Setup
from .single import ONE, action_space, key_of, observation_space

PLAYERS = ("player_0", "player_1")


def env(game: str = "three-cushion", target: int = 10, **given: Any) -> VersusEnv:
    """A match of two, as PettingZoo's own environments are made."""
    return VersusEnv(game, target, **given)


class VersusEnv(AECEnv):  # type: ignore[misc]
    """A match of two: whose turn it is, the rules say.

    game: a name in `danggu.rules.GAMES`.
    target: points that win, in games without pockets; others end with the rack or frame.
    given: as for `Setup`, but for `inning`; ValueError for what cannot be.
    """

    metadata: ClassVar[dict[str, Any]] = {
        "name": "danggu_v0", "render_modes": [], "is_parallelizable": False,
    }  # fmt: skip

    def __init__(self, game: str = "three-cushion", target: int = 10, **given: Any) -> None:
        super().__init__()
        self.setup = Setup(game, inning=False, **given)
        self.hall = MatchHall(self.setup, 1, players=2, target=target)
        self.possible_agents = [*PLAYERS]
        self.agents = [*PLAYERS]
        self.observation_spaces = {one: observation_space(self.hall) for one in PLAYERS}
        self.action_spaces = {one: action_space() for one in PLAYERS}
        self.render_mode = None
        self._begun = False

    def observation_space(self, agent: str) -> Any:
        return self.observation_spaces[agent]

    def action_space(self, agent: str) -> Any:
        return self.action_spaces[agent]

    def reset(self, seed: int | None = None, options: Any = None) -> None:
        """Begin another match."""
        if seed is not None or not self._begun:
            self.hall.seed(ONE, key_of(seed))
        self._begun = True
        self.hall.deal(ONE)
        self.agents = [*PLAYERS]
        self.rewards = dict.fromkeys(PLAYERS, 0.0)
        self._cumulative_rewards = dict.fromkeys(PLAYERS, 0.0)
        self.terminations = dict.fromkeys(PLAYERS, False)
        self.truncations = dict.fromkeys(PLAYERS, False)
        self._turn("")

    def observe(self, agent: str) -> Any:
        """The table, with the cue ball of the player whose turn it is first."""
        return self.hall.seen(ONE)[0]

    def render(self) -> None:
        """Nothing: there are no pictures of it."""

    def close(self) -> None:
        """Nothing is held."""

    def step(self, action: Any) -> None:
        """The stroke of the player whose turn it is."""
        agent = self.agent_selection
        if self.terminations[agent] or self.truncations[agent]:
            self._was_dead_step(action)
            return
        self._cumulative_rewards[agent] = 0.0
        struck = self.hall.strike(ONE, np.asarray(action)[None])
        self._reward(agent)
        self.terminations = dict.fromkeys(PLAYERS, bool(struck.terminated[0]))
        self.truncations = dict.fromkeys(PLAYERS, bool(struck.truncated[0]))
        self._turn(str(struck.reasons[0]))
        self._accumulate_rewards()

    def _reward(self, agent: str) -> None:
        """Points of the player who struck and of the other; a rack won is lost by the other."""
        verdict, key = self.hall.sittings[0].verdict, self.hall.rules.key
        own = worth(key, verdict)
        other = -own if key in RACK_GAMES else float(verdict.gift)
        self.rewards = {one: own if one == agent else other for one in PLAYERS}

    def _turn(self, reason: str) -> None:
        """Whose turn it is now, and what both may know."""
        sitting = self.hall.sittings[0]
        match, balls = sitting.match, sitting.world.balls
        # by name, and not NaN for a ball that is down: PettingZoo compares infos by equality
        state = {ball.name: ball.position for ball in balls if not ball.gone}
        self.agent_selection = PLAYERS[match.at]
        self.infos = {
            one: {"state": state, "reason": reason, "score": sheet.score}
            for one, sheet in zip(PLAYERS, match.sheets, strict=True)
        }
