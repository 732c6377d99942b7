# %% [markdown]
# # Break statistics
#
# No two breaks are alike: the balls of a rack are a few hundredths of a millimetre apart, never the
# same, and each hit multiplies the difference. So a question about breaks is a question about
# thousands of them. `simulate_many` plays them in one call: 43 µs a break, once compiled.

# %%
import matplotlib.pyplot as plt
import numpy as np

from physics import Ball, Shot, aim, simulate, simulate_many, tables

BREAKS = 2000  # at each speed  # quick: 3
SPEEDS = np.arange(3.0, 12.1, 1.0)  # m/s  # quick: np.array([5.0, 9.0])

table = tables.pool(9)
world = table.world()
cue = world.add(Ball("cue", at=(-0.66, 0.05)))
for ball in table.rack("9-ball", gap=1e-4):
    world.add(ball)
full = aim.at(world, cue, "1").angle


def broken(speed, chance):
    """Outcomes of breaks at that speed: each with a rack and an aim of its own."""
    lie = np.array([ball.position for ball in world.balls])
    racks = lie + chance.uniform(-3e-5, 3e-5, (BREAKS, *lie.shape))  # m: none is perfect
    racks[:, 0] = lie[0]
    aims = full + chance.normal(0.0, 0.2, BREAKS)  # degrees
    return simulate_many(world, cue, speed=speed, angle=aims, positions=racks)


# %% [markdown]
# One of them, to see what we are counting:

# %%
simulate(world, cue, Shot(9.0, full))

# %% [markdown]
# ## How many go down?
# A ball that is down has no position: NaN.

# %%
chance = np.random.default_rng(1)
outcomes = [broken(speed, chance) for speed in SPEEDS]
down = [np.isnan(out.positions[:, 1:, 0]).sum(axis=1) for out in outcomes]
scratch = [np.isnan(out.positions[:, 0, 0]).mean() for out in outcomes]

figure, (left, right) = plt.subplots(1, 2, figsize=(9.6, 4.2))
for least in (1, 2, 3):
    left.plot(SPEEDS, [100 * (n >= least).mean() for n in down], "o-", label=f"{least} or more")
left.plot(SPEEDS, [100 * share for share in scratch], "o--", color="#8A949E", label="the cue ball")
left.set(title="Balls that go down", xlabel="speed, m/s", ylabel="% of the breaks", ylim=(0, 100))
left.legend()
names = [ball.name for ball in world.balls[1:]]
lost = np.isnan(outcomes[-1].positions[:, 1:, 0]).mean(axis=0)
order = np.argsort([int(name) for name in names])
right.bar([names[k] for k in order], 100 * lost[order], color="#A8CBE3")
right.set(title=f"Which, at {SPEEDS[-1]:.0f} m/s", xlabel="ball", ylabel="% of the breaks");

# %% [markdown]
# A rack has a memory: the balls at the ends of its middle row (4, 5) and at its back (8) have their
# favourite pockets, and the nine in the middle rarely goes. How hard to hit is a bargain: every
# metre per second brings balls, and brings the cue ball down as well.
#
# ## Where is the cue ball?
# The place from which the next shot is played, over all breaks at the three highest speeds: it
# comes back from the rack, and up or down the table by where it met the first ball.

# %%
rests = np.concatenate([out.positions[:, 0] for out in outcomes[-3:]])
rests = rests[~np.isnan(rests[:, 0])]
figure, ax = plt.subplots(figsize=(9, 5))
table.world().plot(ax)
ax.hexbin(*rests.T, gridsize=44, cmap="GnBu", mincnt=1, zorder=3, linewidths=0.2)
ax.set_title("Where the cue ball comes to rest");

# %% [markdown]
# **Try:** break from the side (`at=(-0.66, 0.5)`, and aim there with `aim.at`), or with a looser
# rack: `gap=1e-3`. In the compiled kernel a million breaks take a minute.
