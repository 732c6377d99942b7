# %% [markdown]
# # Draw distance
#
# Strike low, and the cue ball comes back. How far? That depends on three things in a row: on the
# spin that the tip gives, on how much of it the cloth takes on the way, and on the full hit.

# %%
import matplotlib.pyplot as plt
import numpy as np

from physics import Ball, CueStroke, simulate, tables

HEIGHTS = np.linspace(-0.5, 0.0, 26)  # radii below the centre  # quick: np.array([-0.4])
DISTANCES = np.linspace(0.1, 2.0, 39)  # m  # quick: np.array([0.5, 1.0])
SPEEDS = (1.5, 2.0, 3.0, 4.0)  # of the cue, m/s


def drawn_back(distance, speed, height):
    """How far behind the place of the hit the cue ball rests, m, on a table without end."""
    world = tables.pool_9ft()
    for wall in list(world.walls):
        world.remove(wall)
    white = world.add(Ball("white", at=(0.0, 0.0)))
    world.add(Ball("red", at=(distance + 2 * white.radius, 0.0)))
    after = simulate(world, white, CueStroke(speed, height=height).shot(white))
    hit = after.log.first("ball", "white", "red")
    return hit.before["white"].position[0] - after.ball("white").position[0] if hit else np.nan


# %% [markdown]
# ## By the tip

# %%
figure, ax = plt.subplots()
for speed in SPEEDS:
    back = [drawn_back(0.5, speed, height) for height in HEIGHTS]
    ax.plot(-HEIGHTS, back, label=f"cue at {speed} m/s")
ax.axhline(0, color="#8A949E", lw=0.8)
ax.set(title="Half a metre to the object ball", xlabel="tip below the centre, radii",
       ylabel="comes back, m")
ax.legend();

# %% [markdown]
# Below zero the ball follows on: it had turned to rolling before it hit. Where a curve meets zero
# the cue ball arrives without spin and stops dead. Half a radius is the end: beyond it the tip
# slips.
#
# ## By the distance

# %%
figure, ax = plt.subplots()
for speed in SPEEDS:
    back = [drawn_back(distance, speed, -0.4) for distance in DISTANCES]
    ax.plot(DISTANCES, back, label=f"cue at {speed} m/s")
ax.axhline(0, color="#8A949E", lw=0.8)
ax.set(title="Tip 0.4 radii low", xlabel="to the object ball, m", ylabel="comes back, m")
ax.legend();

# %% [markdown]
# The cloth takes the same spin from a fast ball as from a slow one *per second*, and a fast ball is
# there sooner. That is why the long draw shot is a matter of speed, and the short one of the tip.
#
# ## The whole budget
# Where did the energy of one such stroke go?

# %%
from physics import ledger

world = tables.pool_9ft()
white = world.add(Ball("white", at=(-0.6, 0.0)))
world.add(Ball("red", at=(0.0, 0.0)))
after = simulate(world, white, CueStroke(4.0, height=-0.4).shot(white))
for cause, energy in ledger(after.log).lost().items():
    if energy > 1e-3:
        print(f"{cause:8} {energy:6.3f} J")

# %%
after

# %% [markdown]
# **Try:** new cloth is `slide=0.15`, old cloth 0.25: `world.cloth = Cloth(slide=0.15)`.
