# %% [markdown]
# # Throw
#
# Aim a ball at a pocket along the line of centres, and it goes a little past: the cue ball rubs
# over it and drags it along. Players call that throw. It depends on the cut, on the speed and on
# the spin, and at worst it is five degrees, a ball's width in sixty centimetres.

# %%
import matplotlib.pyplot as plt
import numpy as np

from physics import Ball, aim, simulate, tables

CUTS = np.arange(1.0, 85.0, 1.0)  # degrees  # quick: np.array([30.0, 60.0])
SIDES = np.linspace(-1.0, 1.0, 101)  # parts of the speed  # quick: np.array([-0.5, 0.5])


def throw(cut, speed, follow=0.0, side=0.0):
    """How far from the line of centres the red leaves, degrees; + along the cue ball's course."""
    world = tables.pool_9ft()
    world.add(Ball("red", at=(0.0, 0.0)))
    world.add(Ball("white", at=(-0.058, 0.0)))
    half = aim.at(world, "white", "red", cut=cut)
    after = simulate(world, "white", half.shot(speed, follow * speed, side=side * speed))
    return half.line - after.log.first("ball", "white", "red").after["red"].heading


# %% [markdown]
# ## By the cut
# Slow balls are thrown more, since friction between them falls with the speed at which they rub. A
# rolling cue ball throws less than a stunned one: part of its rub goes up and down.

# %%
figure, (left, right) = plt.subplots(1, 2, sharey=True, figsize=(9.6, 4.0))
for speed, name in ((0.45, "soft, 0.45 m/s"), (1.34, "medium, 1.34 m/s"), (3.13, "firm, 3.13 m/s")):
    left.plot(CUTS, [throw(cut, speed) for cut in CUTS], label=name)
    right.plot(CUTS, [throw(cut, speed, follow=1.0) for cut in CUTS], label=name)
left.set(title="Stun", xlabel="cut, degrees", ylabel="throw, degrees", ylim=(0, 7))
right.set(title="Rolling", xlabel="cut, degrees")
left.legend();

# %% [markdown]
# At a cut of 30° a soft stun shot throws five degrees, a firm one less than two. Below the peak the
# balls gear: friction has stopped the rub altogether, and then throw only depends on the cut. That
# is Alciatore's theory (TP A.14), and his measurements.
#
# ## By the side
# With *outside* english the cue ball's surface moves along with the red one's. If it rolls off it
# like a gear, nothing rubs, and nothing is thrown: that takes a side of sin c times the speed. More
# side throws the ball the other way.

# %%
figure, ax = plt.subplots()
for cut in (0.0, 15.0, 30.0, 45.0):
    thrown = [throw(cut, 1.0, side=side) for side in SIDES]
    (line,) = ax.plot(SIDES, thrown, label=f"cut {cut:.0f}°")
    ax.plot(np.sin(np.radians(cut)), 0.0, "o", color=line.get_color(), ms=8)
ax.axhline(0, color="#8A949E", lw=0.8)
ax.set(title="Gearing english: no throw where the side is sin c (dots)",
       xlabel="side, in parts of the speed (+ is right)", ylabel="throw, degrees")
ax.legend();

# %% [markdown]
# What players do with it: `refined` finds the angle at which throw is made up for.

# %%
world = tables.pool_9ft()
world.add(Ball("white", at=(0.0, -0.3)))
world.add(Ball("red", at=(0.3, -0.2)))
pot = aim.to(world, "white", "red", "north-east pocket")
naive = pot.shot(2.0)
right_angle = pot.refined(world, naive)
print(f"by geometry {naive.angle:.2f}°, with throw {right_angle.angle:.2f}°")
for shot in (naive, right_angle):
    down = simulate(world, "white", shot).log.first("pocket", "red")
    print("potted" if down else "missed")

# %% [markdown]
# **Try:** make the balls smooth (`world.ball_law = "smooth"`): throw is gone. Old, dirty balls are
# `laws.RoughBall(mu=0.12)`.
