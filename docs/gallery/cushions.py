# %% [markdown]
# # Cushion laws side by side
#
# What a cushion does to a spinning ball is the least known law of billiards. The engine has four
# answers, from the thesis that this project began with to a model that integrates friction all
# through the hit. One shot shows how much the choice matters.

# %%
import matplotlib.pyplot as plt
import numpy as np

from physics import Ball, Shot, simulate, tables

ANGLES = np.linspace(5, 85, 41)  # degrees  # quick: np.array([30.0, 60.0])
SIDES = np.linspace(-1.5, 1.5, 61)  # parts of the speed  # quick: np.array([-1.0, 1.0])
LAWS = {
    "rigid (Han), fitted to real hits": "rigid",
    "Mathavan": "mathavan",
    "the thesis's": "thesis",
    "the thesis's, capped": "capped",
}

# %% [markdown]
# ## One shot
# A ball with right english, at 3 m/s: its first two seconds.

# %%
world = tables.match_carom()
world.add(Ball("white", at=(-1.0, -0.4)))
figure, ax = plt.subplots(figsize=(9, 5))
for name, law in LAWS.items():
    world.cushion_law = law
    after = world.copy()
    after.strike("white", Shot(3.0, angle=40.0, follow=3.0, side=2.0))
    after.run(until=1.9)
    after.plot(ax, label=name)
    x, y = simulate(world, "white", Shot(3.0, angle=40.0, follow=3.0, side=2.0)).balls[0].position
    print(f"{name:33} would come to rest at ({x:+.2f}, {y:+.2f}) m")
ax.legend(loc="upper center", bbox_to_anchor=(0.5, 0.0), ncols=2);

# %% [markdown]
# The two models of a real cushion agree to a few centimetres here; the thesis's push, which keeps a
# rolling ball rolling, leads elsewhere from the second cushion on. And after seven cushions even
# the first two rest half a metre apart. So a shot is a sharp test of a law. The numbers of the
# rigid one were found from the tracks of 109 real hits ([accuracy](../accuracy.md)).
#
# ## One hit
# Let a ball roll into the cushion, and look at the angle at which it leaves and at what is left of
# its speed.

# %%
def rebound(law, angle, side=0.0):
    """Angle from the cushion, degrees, and the speed that is left, after rolling in at 2 m/s."""
    world = tables.match_carom()
    world.cushion_law = law
    wall = world.table.width / 2 - world.table.radius
    world.add(Ball("white", at=(-0.02, wall - 0.02 * np.tan(np.radians(angle)))))
    after = simulate(world, "white", Shot(2.0, angle, follow=2.0, side=2.0 * side))
    out = after.log.first("cushion", "white").after["white"]
    return -out.heading, out.speed / 2.0


figure, (left, right) = plt.subplots(1, 2, figsize=(9.6, 4.2))
for name, law in LAWS.items():
    angles, speeds = np.array([rebound(law, angle) for angle in ANGLES]).T
    left.plot(ANGLES, angles, label=name)
    right.plot(ANGLES, speeds, label=name)
left.plot([0, 90], [0, 90], ":", color="#8A949E", lw=1.2, label="a mirror")
left.set(title="Out against in", xlabel="in, degrees from the cushion", ylabel="out, degrees")
right.set(title="Speed that is left", xlabel="in, degrees from the cushion", ylim=(0, 1))
left.legend(fontsize=8.5);

# %% [markdown]
# ## With side
# Running english (right, at this cushion) lets the ball run along it, reverse english stands it up.
# The thesis's friction has no cap, so where the slip changes its sign the outcome jumps.

# %%
figure, ax = plt.subplots()
for name, law in LAWS.items():
    ax.plot(SIDES, [rebound(law, 45.0, side)[0] for side in SIDES], label=name)
ax.axhline(45, color="#8A949E", lw=1.2, ls=":")
ax.set(title="A ball that comes at 45°, by its side", xlabel="side, in parts of the speed",
       ylabel="out, degrees from the cushion")
ax.legend(fontsize=9);

# %% [markdown]
# **Try:** a law of your own is a function, `def felt(v, roll, side): …` ([how](../howto/law.md)).
# Add it to `LAWS`.
