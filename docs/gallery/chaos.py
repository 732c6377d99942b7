# %% [markdown]
# # Uncertainty and chaos
#
# A player errs by a tenth of a degree. A hit between balls makes more of it: the error of direction
# grows by about the distance rolled over the ball's diameter, five- to twentyfold, *at each hit*.
# After three hits nobody knows anything, and that is why carom is hard, and the weather, too.

# %%
import matplotlib.pyplot as plt
import numpy as np

from physics import Cloth, Shot, laws, scenes, sensitivity, simulate_many, trace

SHOTS = 4000  # that err  # quick: 20
ERRORS = {"speed": 0.01, "angle": 0.02, "side": 0.01}  # standard deviations: m/s, degrees, m/s
SHOT = Shot(3.0, 39.5, follow=1.0, side=0.5)

world = scenes.carom()
seen = sensitivity(world, "white", SHOT)
seen

# %% [markdown]
# `sensitivity` differentiates the shot through all of its events. The table says how far a ball's
# place of rest moves, in metres for a unit of each number: for a metre per second, for a degree.
# And this is what each hit of two balls multiplies an error of direction by:

# %%
seen.amplification().round(1)

# %% [markdown]
# From the derivatives and the errors of the stroke follows where the balls may come to rest:
# `covariance`, in metres squared.

# %%
spread = seen.covariance(ERRORS)
for ball, block in zip(seen.world.balls, spread, strict=True):
    print(f"{ball.name:7} rests within {100 * np.sqrt(np.trace(block)):5.1f} cm")

# %% [markdown]
# Is that so? Play the shot thousands of times, with those errors.

# %%
chance = np.random.default_rng(0)
numbers = {
    name: getattr(SHOT, name) + chance.normal(0.0, ERRORS.get(name, 0.0), SHOTS)
    for name in ("speed", "angle", "follow", "side")
}
cloud = simulate_many(world, "white", **numbers).positions
figure, ax = plt.subplots(figsize=(9, 5))
seen.world.plot(ax)
colours = ("#4A5561", "#D99A00", "#D6202F", "#2A7FB8")
for k, colour in enumerate(colours):
    ax.plot(*cloud[:, k].T, ".", color=colour, ms=1.5, alpha=0.4, zorder=4)
    around = np.exp(1j * np.linspace(0, 2 * np.pi, 80))
    root = np.linalg.cholesky(spread[k] + 1e-9 * np.eye(2))
    ring = 2 * root @ np.array([around.real, around.imag])
    ax.plot(*(ring.T + seen.world.balls[k].position).T, color=colour, lw=1.5, zorder=6)
ax.set(xlim=(0.0, 0.9), ylim=(-0.45, 0.15))
ax.set_title("Shots that err, and the ellipses that the derivatives foretell");

# %% [markdown]
# This is the part of the table where the balls come to rest; the ellipses hold 86 % of the
# outcomes, if the linear law is right. It is where an ellipse is small. Where it is long, the
# outcomes lie along a curve, and no ellipse can say so.
#
# ## Exponential growth
# Without friction the game never ends, and the error grows until it is as large as the table. Two
# worlds that differ by a tenth of a nanometre in one coordinate:

# %%
def endless(shift):
    """Four balls on ice, nothing lost, one of them moved by so little."""
    world = scenes.carom()
    world.cloth = Cloth(slide=0.0, roll=0.0, spin_decay=0.0)
    world.ball_law, world.cushion_law = laws.SmoothBall(e=1.0), laws.RigidCushion(1.0, 0.0, 1.0)
    x, y = world.ball("red").position
    world.ball("red").position = x + shift, y
    world.strike("white", SHOT)
    world.run(until=20.0)
    return world


times = np.linspace(0.0, 20.0, 2001)
one, other = (trace(endless(shift), times=times)[1] for shift in (0.0, 1e-10))
apart = np.linalg.norm(one - other, axis=2)
figure, ax = plt.subplots()
for k, ball in enumerate(world.balls):
    ax.semilogy(times, np.maximum(apart[:, k], 1e-13), color=colours[k], label=ball.name, lw=1.5)
ax.axhline(1.42, color="#8A949E", ls=":")
ax.set(title="From an atom to the table", xlabel="time, s", ylabel="the two worlds are apart, m")
ax.legend();

# %% [markdown]
# A straight line on this scale is the mark of chaos. The engine itself errs by 1e-16 of a metre an
# event: by the same law it is right for about a dozen hits of balls, and no longer
# ([accuracy](../accuracy.md)). A shot in play has three or four.
#
# **Try:** which of the five numbers matters most? `sensitivity(world, "white", SHOT,
# by=["angle"])`, and so on; names such as `"cloth.slide"` and `"cushion.e"` work, too.
