# %% [markdown]
# # A fitted table
#
# Which cloth is this, and which cushions? A camera over the table sees where the balls are, fifty
# times a second, to half a millimetre. `fit` finds the coefficients with which the engine's balls
# run along those tracks, and says how well they are known.

# %%
from dataclasses import replace

import matplotlib.pyplot as plt
import numpy as np

from physics import Ball, Shot, fit, simulate, tables, tracks

STROKES = 6  # filmed  # quick: 3
UNKNOWN = ("cloth.slide", "cloth.roll", "cushion.e", "cushion.mu")

# %% [markdown]
# ## Tracks
# Yours come from a file, `tracks.read("tracks.csv", world)`. Here we film a table of which we know
# the truth, so that we can tell afterwards whether it was found. One sample in twenty is lost.

# %%
chance = np.random.default_rng(7)
truth = tables.match_carom()
truth.cloth = replace(truth.cloth, slide=0.19, roll=0.0062)
truth.cushion_law = replace(truth.cushion_law, e=0.86, mu=0.20)
truth.add(Ball("white", at=(-0.9, -0.4)))
filmed = []
for _ in range(STROKES):
    speed, angle, follow = chance.uniform((1.5, 20.0, -1.0), (3.0, 70.0, 1.5))
    shot = Shot(speed, angle, follow=follow, side=chance.normal())
    filmed.append(tracks.filmed(truth, "white", shot, chance, lost=0.05, until=4.0))
filmed[0]

# %% [markdown]
# ## The fit
# It begins with the table as it is in the presets, a world with the same balls. How each stroke was
# played is unknown, too: it is found along with the rest.

# %%
world = tables.match_carom()
world.add(Ball("white", at=(0.0, 0.0)))
found = fit(world, filmed, UNKNOWN)
known = dict(zip(UNKNOWN, (0.19, 0.0062, 0.86, 0.20), strict=True))
print(f"{'':12} {'before':>8} {'found':>8} {'±':>8} {'truth':>8}")
cloth, cushion = world.cloth, world.cushion_law
before = (cloth.slide, cloth.roll, cushion.e, cushion.mu)
errors = np.sqrt(np.diag(found.covariance))
for name, old, value, error in zip(UNKNOWN, before, found.values, errors, strict=True):
    print(f"{name:12} {old:8.4f} {value:8.4f} {error:8.5f} {known[name]:8.4f}")

# %% [markdown]
# What the preset table would have done with the same stroke, and what the fitted one does:

# %%
stroke, track = found.strokes[0], filmed[0]
figure, ax = plt.subplots(figsize=(9, 5))
for table, name in ((world, "as in the presets"), (found.world, "fitted")):
    lie = table.copy()
    lie.ball("white").position = stroke.positions[0]
    simulate(lie, "white", stroke.shot).plot(ax, label=name)
ax.plot(*track.positions[:, 0].T, "k.", ms=3, zorder=8, label="seen")
ax.legend(loc="upper center", bbox_to_anchor=(0.5, 0.0), ncols=3);

# %% [markdown]
# ## Is it a good fit?
# What is left should be noise: half a millimetre, without a trend.

# %%
figure, ax = plt.subplots(figsize=(8.4, 3.2))
for stroke, track in zip(found.strokes, filmed, strict=True):
    ax.plot(track.times - stroke.start, 1e3 * stroke.residuals[:, 0, 0], ".", ms=2.5)
ax.set(title=f"Seen less expected: {1e3 * found.misfit:.2f} mm", xlabel="since the stroke, s",
       ylabel="x, mm", ylim=(-3, 3));

# %% [markdown]
# A table of one's own is kept in a file, from which the game plays, too: `tables.save(found.world,
# "my-table.json")`. How many strokes such a fit needs, and what it found on real tracks, is in [the
# physics](../physics.md#fitting-a-table).
#
# **Try:** leave out `"cushion.mu"` from `UNKNOWN`. The fit then blames the others; the residuals
# show it.
