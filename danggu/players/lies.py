"""Where balls lie on a table at rest, and which of them may be hit first."""

from __future__ import annotations

from danggu.rules.match import Match
from physics import World


def lying(world: World, match: Match, spot: tuple[str, ...] = ()) -> dict[str, complex]:
    """Where balls lie in a world at rest, m; those that are to be spotted on their spots."""
    lie = {ball.name: complex(*ball.position) for ball in world.balls if not ball.gone}
    spots = world.table.spots
    for name in spot:
        lie[name] = complex(*spots.get(name, spots.get("foot", (0.0, 0.0))))
    if match.state.left:
        kept = {*match.state.left, match.cue}
        return {name: at for name, at in lie.items() if name in kept}
    return lie


def lie_and_targets(world: World, match: Match) -> tuple[dict[str, complex], list[str]]:
    """Where all balls but the one that is played lie, m, and the names of those that are on."""
    lie = lying(world, match)
    lie.pop(match.cue, None)
    return lie, [name for name in match.rules.targets(match.turn) if name in lie]
