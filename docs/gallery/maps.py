# %% [markdown]
# # Probability maps
#
# How likely is a shot to come off? Play it in every direction and with every spin, ask the rules
# each time, and blur the picture by the player's error. What stays bright is what a player should
# play.

# %%
import matplotlib.pyplot as plt
import numpy as np

from danggu import rules
from physics import Ball, Shot, simulate, simulate_many, tables

STEP, SIDES = 0.25, 41  # degrees of a column; rows  # quick: 90.0, 2
GRID, STROKES = 60, 150  # places along the table; strokes from each  # quick: 3, 2

# %% [markdown]
# ## Three-cushion: every way at once
# All strokes at 4.5 m/s with some follow: 1440 directions by 41 tip points from left to right.

# %%
world = tables.match_carom()
for name, at in (("white", (-0.9, -0.4)), ("yellow", (0.95, 0.3)), ("red", (0.2, -0.35))):
    world.add(Ball(name, at=at))
angle, side = np.meshgrid(np.arange(0, 360, STEP), np.linspace(-3, 3, SIDES))
played = simulate_many(
    world, "white", speed=4.5, angle=angle.ravel(), follow=1.5, side=side.ravel(), contacts=40
)
game = rules.GAMES["three-cushion"]()
scores = game.verdicts(played, rules.Turn("white")).made.reshape(angle.shape)
print(f"{scores.size} strokes, of which {100 * scores.mean():.1f} % score")


def blurred(hits, error):
    """The share of hits, if the direction has this error: a standard deviation, degrees."""
    turn = np.arange(hits.shape[1]) * STEP
    bell = np.exp(-0.5 * (np.minimum(turn, 360 - turn) / error) ** 2)
    waves = np.fft.fft(hits, axis=1) * np.fft.fft(bell / bell.sum())
    return np.fft.ifft(waves, axis=1).real


chances = blurred(scores, 0.6)  # a good club player
figure, axes = plt.subplots(2, 1, figsize=(9.2, 5.4), sharex=True)
for ax, picture, title in zip(
    axes, (scores, chances), ("Strokes that score", "For a player who errs by 0.6°"), strict=True
):
    image = ax.imshow(
        picture, aspect="auto", origin="lower", extent=(0, 360, -3, 3), cmap="magma", vmax=1
    )
    ax.set(title=title, ylabel="side, m/s")
    ax.grid(False)
axes[1].set_xlabel("direction, degrees")
figure.colorbar(image, ax=axes, label="chance");

# %% [markdown]
# The thin threads of the upper map are shots for machines. Blurred, a few remain, and the best of
# them is this:

# %%
best = np.unravel_index(chances.argmax(), chances.shape)
shot = Shot(4.5, float(angle[best]), follow=1.5, side=float(side[best]))
print(f"{shot}: {100 * chances[best]:.0f} %")
simulate(world, "white", shot)

# %% [markdown]
# ## Pool: where should the cue ball lie?
# The red is to go into the north-east pocket. From each place on the table the stroke aims at the
# ghost ball at 2 m/s, and errs by 0.3°, dozens of times: all of it is one batch, since `positions`
# may differ from shot to shot.

# %%
pool = tables.pool_9ft()
white = pool.add(Ball("white", at=(-0.5, 0.0)))
red = pool.add(Ball("red", at=(0.5, 0.05)))
pocket = np.array([1.25, 0.615])  # between the noses of the mouth
line = pocket - red.position
ghost = red.position - 2 * white.radius * line / np.hypot(*line)

x, y = np.meshgrid(np.linspace(-1.2, 1.2, GRID), np.linspace(-0.59, 0.59, GRID // 2 + 1))
places = np.stack([x, y], axis=-1).reshape(-1, 2)
way = ghost - places
cut = np.abs(np.angle(complex(*line) / (way @ [1, 1j]), deg=True))
free = (np.hypot(*(places - red.position).T) > 2.05 * white.radius) & (cut < 85)
places = places[free]
lies = np.zeros((len(places), STROKES, 2, 2))
lies[:, :, 0], lies[:, :, 1] = places[:, None], red.position
aims = np.angle(way[free] @ [1, 1j], deg=True)
errors = np.random.default_rng(0).normal(0.0, 0.3, (len(places), STROKES))
played = simulate_many(
    pool, white, speed=2.0, angle=(aims[:, None] + errors).ravel(), positions=lies.reshape(-1, 2, 2)
)
potted = np.isnan(played.positions[:, 1, 0]).reshape(len(places), STROKES).mean(axis=1)

figure, ax = plt.subplots(figsize=(9, 5))
pool.plot(ax)
chance = np.full(x.size, np.nan)
chance[free] = potted
levels = np.linspace(0, 1, 11)
shade = ax.contourf(x, y, chance.reshape(x.shape), levels, cmap="YlGn", zorder=3, alpha=0.9)
ax.plot(*np.array([red.position, pocket]).T, color="#D6202F", zorder=5)
ax.plot(*red.position, "o", color="#D6202F", ms=11, zorder=6)
figure.colorbar(shade, label="chance to pot the red", shrink=0.7);

# %% [markdown]
# The fan opens behind the red, along the line from the pocket: a straight shot forgives most, and a
# near ball more than a far one. That is the whole of position play: get into the fan.
#
# **Try:** put a blocker on the table, or let the player err by 0.1° as a master does.
