"""The named laws of collision: their coefficients; their equations are in kernel/laws.py.

A law may also be any callable. A cushion law takes (v, roll, side) of the ball, with the wall along
x = 0 and the table at x > 0, and returns the three after the hit. A ball law takes the first ball's
relative velocity, the two balls' summed roll and side, and their reduced mass, with the second ball
towards +x, and returns (push, rub): the impulse along the line of centres, and the one across it as
(along the table) + i (upward) on the first ball; the engine applies them equal and opposite. All
are complex numbers in m/s; roll is -i R ω, side is R ω_z; impulses in N s. Between balls of two
sizes v and push are along the table, and roll and side turned as docs/physics.md says.

e and mu of RigidCushion, MathavanCushion, SmoothBall and RoughBall may depend on speed: they hold
at 1 m/s, and change by e_slope and mu_slope for each m/s more, within 0 and 1. The speed is that of
closing, as `Event.closing` has it; for the friction between balls it is that of their slip.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from math import sqrt
from typing import Any, ClassVar

from .checks import finite, fraction, keep, nonnegative
from .cluster_laws import HertzCluster, cluster_law
from .custom_laws import CustomRule as CustomRule
from .custom_laws import compiled
from .kernel import laws as kernel
from .kernel.body import Rule

__all__ = [
    "BallLaw", "CappedCushion", "CushionLaw", "HertzCluster", "MathavanCushion", "RigidCushion",
    "RoughBall", "SmoothBall", "ThesisBall", "ThesisCushion", "ball_law", "cluster_law",
    "compiled", "cushion_law",
]  # fmt: skip

MEASURED_SLIDE = 0.212  # the friction of the measured cloth, for a law tried without a cloth

CushionState = tuple[complex, complex, float]


def _nose_height(name: str, value: float) -> float:
    if not 0.0 < finite(name, value) < 2.0:
        raise ValueError(f"{name} (h/R) must be between 0 and 2, not {value!r}")
    return float(value)


def _keep_slopes(law: "RigidCushion | MathavanCushion | RoughBall") -> None:
    """Friction that depends on speed ends at 1, and so it must begin there too."""
    keep(law, finite, "e_slope", "mu_slope")
    if law.mu_slope:
        keep(law, fraction, "mu")


def _bent(kind: int, e: float, mu: float, nose: float) -> Rule:
    height = nose - 1.0
    return Rule(kind, e, mu, height, sqrt(1.0 - height * height))


def _sloping(rule: Rule, e_slope: float, mu_slope: float) -> Rule:
    """The rule has its coefficients at no speed, and slopes along the contact's normal."""
    rule.restitution -= e_slope
    rule.friction -= mu_slope
    rule.restitution_slope, rule.friction_slope = e_slope / rule.level, mu_slope / rule.level
    return rule


class _CushionLaw:
    """A cushion law, which can be called by hand.

    creates_energy: whether it may, by its nature.
    """

    __slots__ = ()
    creates_energy: ClassVar[bool] = False

    def rule(self) -> Rule:
        raise NotImplementedError

    def __call__(self, v: complex, roll: complex, side: float) -> CushionState:
        """The ball's v, roll and side after the hit; the wall is x = 0, the table x > 0; m/s."""
        result: CushionState = kernel.cushion(v, roll, side, self.rule())
        return result


class _BallLaw:
    """A ball law, which can be called by hand.

    loses_momentum: whether it may, by its nature.
    """

    __slots__ = ()
    loses_momentum: ClassVar[bool] = False

    def rule(self) -> Rule:
        raise NotImplementedError

    def __call__(
        self, v: complex, roll: complex, side: float, mass: float
    ) -> tuple[float, complex]:
        """(push, rub) on the first ball, N s; see the module."""
        result: tuple[float, complex] = kernel.ball_law(v, roll, side, mass, 1.0, self.rule())
        return result


@dataclass(frozen=True, slots=True)
class RigidCushion(_CushionLaw):
    """The rigid impulse law (Han 2005, corrected).

    e: restitution.
    mu: friction.
    nose: height h/R.
    e_slope, mu_slope: what e and mu gain for each m/s, s/m; see the module.
    """

    e: float = 0.891
    mu: float = 0.242
    nose: float = 1.203
    e_slope: float = 0.0
    mu_slope: float = 0.0

    def __post_init__(self) -> None:
        keep(self, fraction, "e")
        keep(self, nonnegative, "mu")
        keep(self, _nose_height, "nose")
        _keep_slopes(self)

    def rule(self) -> Rule:
        rule = _bent(kernel.RIGID_CUSHION, self.e, self.mu, self.nose)
        return _sloping(rule, self.e_slope, self.mu_slope)


@dataclass(frozen=True, slots=True)
class MathavanCushion(_CushionLaw):
    """Mathavan, Jackson and Parkin (2010): friction at nose and cloth, all through the hit.

    e: restitution.
    mu: friction at the cushion.
    slide: friction at the cloth; None is that of the world's own cloth, and 0.212 for a law that
    is called by hand.
    nose: height h/R.
    e_slope, mu_slope: what e and mu gain for each m/s, s/m; see the module. One speed, with which
    the ball comes, decides for the whole hit.
    ValueError also for coefficients at which the ball would jam between nose and cloth.
    """

    e: float = 0.901
    mu: float = 0.222
    slide: float | None = None
    nose: float = 1.203
    e_slope: float = 0.0
    mu_slope: float = 0.0

    def __post_init__(self) -> None:
        keep(self, fraction, "e", "mu", *(["slide"] if self.slide is not None else []))
        keep(self, _nose_height, "nose")
        _keep_slopes(self)
        rule = self.rule()
        mu = 1.0 if self.mu_slope > 0.0 else min(1.0, rule.friction)  # the most at any speed
        pressed = max(0.0, rule.height + rule.level * mu)
        if rule.level - abs(rule.height) * mu - rule.slide * pressed <= 0.0:
            raise ValueError(f"{self!r}: the ball would jam between nose and cloth")

    def rule(self) -> Rule:
        rule = _bent(kernel.MATHAVAN_CUSHION, self.e, self.mu, self.nose)
        rule.slide = MEASURED_SLIDE if self.slide is None else self.slide
        return _sloping(rule, self.e_slope, self.mu_slope)


@dataclass(frozen=True, slots=True)
class ThesisCushion(_CushionLaw):
    """The thesis's text: the push at 7R/5 keeps a rolling ball rolling, friction has no cap.

    It creates energy for balls that do not roll (docs/physics.md).
    e: restitution.
    mu: friction.
    """

    creates_energy: ClassVar[bool] = True

    e: float = 0.9
    mu: float = 0.1

    def __post_init__(self) -> None:
        keep(self, fraction, "e")
        keep(self, nonnegative, "mu")

    def rule(self) -> Rule:
        return _bent(kernel.THESIS_CUSHION, self.e, self.mu, 1.4)


@dataclass(frozen=True, slots=True)
class CappedCushion(_CushionLaw):
    """The thesis's push, with friction that has its whole lever arm and stops at sticking.

    The push creates energy for balls that do not roll (docs/physics.md).
    e: restitution.
    mu: friction.
    """

    creates_energy: ClassVar[bool] = True

    e: float = 0.9
    mu: float = 0.1

    def __post_init__(self) -> None:
        keep(self, fraction, "e")
        keep(self, nonnegative, "mu")

    def rule(self) -> Rule:
        return _bent(kernel.CAPPED_CUSHION, self.e, self.mu, 1.4)


@dataclass(frozen=True, slots=True)
class SmoothBall(_BallLaw):
    """No friction: spins stay as they are.

    e: restitution.
    e_slope: what e gains for each m/s, s/m; see the module.
    """

    e: float = 0.95
    e_slope: float = 0.0

    def __post_init__(self) -> None:
        keep(self, fraction, "e")
        keep(self, finite, "e_slope")

    def rule(self) -> Rule:
        return _sloping(Rule(kernel.SMOOTH_BALL, self.e), self.e_slope, 0.0)


@dataclass(frozen=True, slots=True)
class RoughBall(_BallLaw):
    """A push and friction.

    e: restitution.
    mu: friction, a number or "alciatore" for his fit to Marlow's data.
    e_slope, mu_slope: what e and mu gain for each m/s, s/m; see the module.
    """

    e: float = 0.946
    mu: float | str = "alciatore"
    e_slope: float = 0.0
    mu_slope: float = 0.0

    def __post_init__(self) -> None:
        keep(self, fraction, "e")
        if isinstance(self.mu, str):
            if self.mu != "alciatore":
                raise ValueError(f'RoughBall.mu must be a number or "alciatore", not {self.mu!r}')
            if self.mu_slope:
                raise ValueError(
                    f"RoughBall.mu_slope is {self.mu_slope!r}, but Alciatore's fit has its own"
                )
        else:
            keep(self, nonnegative, "mu")
        _keep_slopes(self)

    def rule(self) -> Rule:
        if isinstance(self.mu, str):
            return _sloping(Rule(kernel.ALCIATORE_BALL, self.e), self.e_slope, 0.0)
        return _sloping(Rule(kernel.ROUGH_BALL, self.e, self.mu), self.e_slope, self.mu_slope)


@dataclass(frozen=True, slots=True)
class ThesisBall:
    """The thesis's text: velocities along the line of centres swap, times e; so do spins across it.

    It loses momentum, which no other law here can.
    e: restitution.
    """

    loses_momentum: ClassVar[bool] = True

    e: float = 0.95

    def __post_init__(self) -> None:
        keep(self, fraction, "e")

    def rule(self) -> Rule:
        return Rule(kernel.THESIS_BALL, self.e)


BENT = RigidCushion | MathavanCushion  # laws that depend on the height of the nose

CushionLaw = _CushionLaw | Callable[[complex, complex, float], CushionState]
BallLaw = _BallLaw | ThesisBall | Callable[[complex, complex, float, float], tuple[float, complex]]


def cushion_law(law: "str | CushionLaw", before: "CushionLaw | None" = None) -> CushionLaw:
    """The law itself, from its name or as it is; ValueError for anything else.

    The nose belongs to the table: by name, a law keeps the height that the law before it had.
    """
    names: dict[str, Callable[[], CushionLaw]] = {
        "rigid": RigidCushion, "mathavan": MathavanCushion,
        "thesis": ThesisCushion, "capped": CappedCushion,
    }  # fmt: skip
    found: CushionLaw = _law("cushion law", law, names, (_BallLaw, ThesisBall))
    if isinstance(law, str) and isinstance(before, BENT) and isinstance(found, BENT):
        return replace(found, nose=before.nose)
    return found


def ball_law(law: "str | BallLaw") -> BallLaw:
    """The law itself, from its name or as it is; ValueError for anything else."""
    names: dict[str, Callable[[], BallLaw]] = {
        "smooth": SmoothBall, "rough": RoughBall, "thesis": ThesisBall
    }  # fmt: skip
    found: BallLaw = _law("ball law", law, names, (_CushionLaw,))
    return found


def _law(what: str, law: Any, names: dict[str, Callable[[], Any]], others: tuple[type, ...]) -> Any:
    if isinstance(law, str):
        if law not in names:
            known = ", ".join(sorted(names))
            raise ValueError(f"unknown {what} {law!r}: one of {known}, or a callable")
        return names[law]()
    ours = callable(law) or isinstance(law, ThesisBall)
    if not ours or isinstance(law, (type, *others)):
        raise ValueError(f"{what} must be a name, a law or a callable, not {law!r}")
    return law


def on_cloth(law: CushionLaw, slide: float) -> CushionLaw:
    """The law on a cloth with that friction; ValueError if the two do not go together."""
    if isinstance(law, MathavanCushion) and law.slide is None:
        return replace(law, slide=slide)
    return law


def cushion_rule(law: CushionLaw, parting: float, before: Rule | None = None) -> Rule:
    """The law as the kernel wants it; a custom one has the default's coefficients in the air, at
    the nose that was there before."""
    if isinstance(law, _CushionLaw):
        rule = law.rule()
    else:
        air = RigidCushion()
        nose = air.nose if before is None else 1.0 + before.height
        rule = CustomRule(_bent(kernel.CUSTOM_CUSHION, air.e, air.mu, nose), law)
    rule.parting = parting
    return rule


def cushion_rules(
    wanted: Sequence[CushionLaw | None], slide: float, parting: float, before: Rule | None
) -> list[Rule]:
    """The law of a world's cushions as the kernel wants it, and that of each wall, if one of them
    has its own: None has the world's."""
    laws = [None if law is None else on_cloth(law, slide) for law in wanted]
    common, *own = (None if law is None else cushion_rule(law, parting, before) for law in laws)
    assert common is not None
    return [common, *(rule or common for rule in own)] if any(own) else [common]


def ball_rule(law: BallLaw, parting: float) -> Rule:
    """The law as the kernel wants it."""
    if isinstance(law, _BallLaw | ThesisBall):
        rule = law.rule()
    else:
        rule = CustomRule(Rule(kernel.CUSTOM_BALL), law)
    rule.parting = parting
    return rule


def __dir__() -> list[str]:
    """The public names, so that completion finds no other."""
    return [*__all__]
