"""Environments for learning: games as Gymnasium and PettingZoo have them (extra `rl`).

`import danggu.envs` registers `danggu/ThreeCushion-v0` and the others of `IDS`; matches of two are
made by `danggu.envs.versus.env`. What is seen, done and rewarded: docs/environments.md.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

try:
    import gymnasium
except ImportError:
    raise ImportError("danggu.envs needs the extra `rl`: pip install 'danggu[rl]'") from None

if TYPE_CHECKING:
    from .noise import FASTFIZ, NOISES, Noise
    from .setup import Setup
    from .single import TableEnv
    from .vector import TableVectorEnv
    from .versus import VersusEnv

__all__ = [
    "FASTFIZ", "IDS", "NOISES", "Noise", "Setup", "TableEnv", "TableVectorEnv", "VersusEnv",
]  # fmt: skip

HOMES = {"FASTFIZ": "noise", "NOISES": "noise", "Noise": "noise", "Setup": "setup",
         "TableEnv": "single", "TableVectorEnv": "vector", "VersusEnv": "versus"}  # fmt: skip

IDS = {
    "danggu/ThreeCushion-v0": "three-cushion",
    "danggu/OneCushion-v0": "one-cushion",
    "danggu/StraightRail-v0": "straight-rail",
    "danggu/FourBall-v0": "four-ball",
    "danggu/EightBall-v0": "8-ball",
    "danggu/NineBall-v0": "9-ball",
    "danggu/Snooker-v0": "snooker",
}
"""The registered environments, and the game of each."""


def __getattr__(name: str) -> Any:
    """What needs NumPy and the rules is imported on first use."""
    if name in HOMES:
        return getattr(import_module(f".{HOMES[name]}", __name__), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    """The public names, so that completion finds no other."""
    return [*__all__]


for _id, _game in IDS.items():
    if _id not in gymnasium.registry:  # the module may be loaded again
        gymnasium.register(
            _id,
            entry_point="danggu.envs.single:TableEnv",
            vector_entry_point="danggu.envs.vector:TableVectorEnv",
            kwargs={"game": _game},
        )
