"""The laws of clusters: what happens when three balls or more touch."""

from dataclasses import dataclass

from .checks import fraction, keep, nonnegative, positive


@dataclass(frozen=True, slots=True)
class HertzCluster:
    """The accurate law for clusters of touching balls: contacts that are springs of Hertz.

    Its equations are in physics/engines/hertz.py. Friction between the balls is the ball law's.
    e: restitution, above 0; None is the ball law's own.
    gap: balls closer than that, m, count as touching; real ones do below 0.1 to 0.4 mm, as a
    contact takes time.
    World.cluster_law takes it, with the engine EventDriven; a pair alone goes by the ball law.
    """

    e: float | None = None
    gap: float = 1e-8

    def __post_init__(self) -> None:
        keep(self, nonnegative, "gap")
        if self.e is not None:
            keep(self, fraction, "e")
            positive("HertzCluster.e", self.e)


def cluster_law(law: "str | HertzCluster | None") -> HertzCluster | None:
    """The law itself; None stays None: groups of tied contacts under the ball law."""
    if law == "hertz":
        return HertzCluster()
    if law is None or isinstance(law, HertzCluster):
        return law
    raise ValueError(f'cluster law must be None, "hertz" or a HertzCluster, not {law!r}')
