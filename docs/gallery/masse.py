# %% [markdown]
# # Massé
#
# Raise the cue and strike down beside the centre, and the ball runs along a curve. Coriolis knew in
# 1835 where to: let A be where the ball touches the cloth, and B where the line of the cue would go
# through the cloth. When the curve is over, the ball rolls on *parallel to AB*. So massé is aimed
# with a ruler, and we can check the theorem against the engine.

# %%
import matplotlib.pyplot as plt
import numpy as np

from physics import Ball, CueStroke, simulate, tables

RIGHT = np.linspace(0.02, 0.45, 25)  # radii  # quick: np.array([0.2])
STIFF = {"end_ratio": 1e9}  # a cue that does not squirt, as in Coriolis's time

table = tables.match_carom()
ball = table.add(Ball("white", at=(-1.2, 0.35)))


def played(right, up, elevation, speed):
    """The world after a stroke; right and up: of the centre, as seen along the cue."""
    stroke = CueStroke.along(speed, right=right, up=up, elevation=elevation, **STIFF)
    return simulate(table, "white", stroke.shot(ball))


def coriolis(right, up, elevation):
    """The direction of AB, degrees: where the cue, from this tip point, pierces the cloth."""
    th = np.radians(elevation)
    along = np.array([np.cos(th), 0.0, -np.sin(th)])
    above = np.array([np.sin(th), 0.0, np.cos(th)])
    tip = np.array([0.0, -right, 0.0]) + up * above - np.sqrt(1 - right**2 - up**2) * along
    b = tip + (tip[2] + 1) / np.sin(th) * along  # in radii, from the centre of the ball
    return np.degrees(np.arctan2(b[1], b[0]))


# %% [markdown]
# ## The curve
# The same tip point, 0.35 radii to the right and a little low, with the cue raised more and more.
# The dotted lines are Coriolis's directions.

# %%
figure, ax = plt.subplots(figsize=(9, 5))
for elevation in (30, 45, 60, 70):
    after = played(0.35, -0.1, elevation, speed=1.9)
    after.plot(ax, label=f"{elevation}°")
    rolls = after.log.first("roll", "white").after["white"]
    way = np.radians(coriolis(0.35, -0.1, elevation))
    x, y = np.array(rolls.position)
    ax.plot([x, x + 0.5 * np.cos(way)], [y, y + 0.5 * np.sin(way)], "k:", lw=1.5, zorder=9)
ax.legend(loc="upper center", bbox_to_anchor=(0.5, 0.0), ncols=4);

# %% [markdown]
# ## The theorem
# Over tip points and elevations: the dots are the engine, the lines Coriolis.

# %%
figure, ax = plt.subplots()
worst = 0.0
for elevation in (30, 50, 70):
    rule = [coriolis(right, -0.1, elevation) for right in RIGHT]
    ends = [played(right, -0.1, elevation, 1.2).log.first("roll", "white") for right in RIGHT]
    seen = [end.after["white"].heading for end in ends]
    (line,) = ax.plot(RIGHT, rule, lw=1.5)
    ax.plot(RIGHT, seen, "o", color=line.get_color(), label=f"cue raised by {elevation}°")
    worst = max(worst, np.abs(np.subtract(rule, seen)).max())
print(f"they differ by at most {worst:.1e} degrees")
ax.set(title="Where the ball rolls in the end", xlabel="tip right of the centre, radii",
       ylabel="direction, degrees")
ax.legend();

# %% [markdown]
# The agreement is exact, since nothing in it depends on how strong the friction of the cloth is:
# that only says how soon the curve is over. The engine knows nothing of AB; it integrates sliding
# friction.
#
# ## Speed
# How far the ball runs before it has turned depends on the speed; the direction does not.

# %%
figure, ax = plt.subplots(figsize=(9, 5))
for speed in (1.5, 2.0, 2.5, 3.0):
    played(0.3, -0.25, 65, speed).plot(ax, label=f"{speed} m/s")
ax.legend(loc="upper center", bbox_to_anchor=(0.5, 0.0), ncols=4);

# %% [markdown]
# **Try:** go around a ball at (-0.6, 0.35) and hit one at (-0.3, 0.2). A drawn path will do:
# [recover a drawn path](../howto/recover.md).
