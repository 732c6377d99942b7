# %% [markdown]
# # The rules of 90° and 30°
#
# Two rules are all that most players know about where the cue ball goes. Stunned, it leaves at a
# right angle to the object ball. Rolling, it turns from its course by about 30°, if it hits between
# a quarter and three quarters of the ball. Both are theorems, and both are a little wrong on a real
# table. How much?

# %%
import matplotlib.pyplot as plt
import numpy as np

from physics import Ball, aim, laws, simulate, tables

CUTS = np.arange(2.0, 88.0, 1.0)  # degrees  # quick: np.array([30.0, 60.0])


def hit(cut, follow, law):
    """The world after the cue ball, coming along +x, has hit the red with this cut."""
    world = tables.pool_9ft()
    world.ball_law = law
    world.add(Ball("red", at=(0.0, 0.0)))
    world.add(Ball("white", at=(-0.1, 0.0)))
    half = aim.at(world, "white", "red", cut=cut)
    return simulate(world, "white", half.shot(2.0, follow=follow)), half.angle


# %% [markdown]
# ## Stun: a right angle
# A ball without spin that meets another of its mass gives away its whole velocity along the line of
# centres, if nothing is lost, and keeps what lies across. So the two part at 90°. With a
# restitution of 0.946 a little of the first part is kept, and friction pulls both balls a little
# out of line.

# %%
def parting(cut, law):
    """The angle between the two balls just after they have met, degrees."""
    after, _ = hit(cut, 0.0, law)
    state = after.log.first("ball", "white", "red").after
    return abs(state["red"].heading - state["white"].heading)


figure, ax = plt.subplots()
for law, name in (
    (laws.SmoothBall(e=1.0), "nothing lost, smooth"),
    (laws.SmoothBall(e=0.946), "restitution 0.946, smooth"),
    (laws.RoughBall(), "restitution 0.946, rough: real balls"),
):
    ax.plot(CUTS, [parting(cut, law) for cut in CUTS], label=name)
ax.set(xlabel="cut, degrees (0 is full)", ylabel="angle between the balls, degrees",
       title="A stunned cue ball leaves at nearly a right angle", ylim=(60, 92))
ax.legend();

# %% [markdown]
# The rule is right for thin hits and wrong for full ones, where the cue ball hardly moves, and the
# little that it keeps turns it a lot. The kink at 21° is where friction begins to slip: fuller hits
# gear like cogs.
#
# ## Rolling: thirty degrees
# A rolling cue ball leaves at the same right angle, but its spin is still the old one. The cloth
# bends its path into a parabola, and once it rolls again it has turned by
#
# tan θ = sin c cos c / (sin² c + 2/5)
#
# from its course, c being the cut. That has a broad maximum: 33.7° at a cut of 28°.

# %%
def deflection(cut, law):
    """By how much the cue ball has turned when it rolls again, degrees."""
    after, course = hit(cut, 2.0, law)
    met = after.log.first("ball", "white", "red").time
    again = next(e for e in after.log.all("roll", "white") if e.time > met)
    return abs(again.after["white"].heading - course)


eighths = 8 * (1 - np.sin(np.radians(CUTS)))
c = np.radians(CUTS)
rule = np.degrees(np.arctan2(np.sin(c) * np.cos(c), np.sin(c) ** 2 + 0.4))

figure, ax = plt.subplots()
ax.axvspan(2, 6, color="#EFEAD8", label="a quarter to three quarters of the ball")
for law, name in ((laws.SmoothBall(e=1.0), "ideal balls"), (laws.RoughBall(), "real balls")):
    ax.plot(eighths, [deflection(cut, law) for cut in CUTS], label=name)
ax.plot(eighths, rule, "k:", lw=1.5, label="the formula")
ax.axhline(30, color="#8A949E", lw=0.8)
ax.set(xlabel="thickness of the hit, eighths (8 is full)", ylabel="turned by, degrees",
       title="A rolling cue ball turns by about 30°", xlim=(0, 8), ylim=(0, 40))
ax.legend(loc="lower center");

# %% [markdown]
# Ideal balls follow the formula to the last digit that can be drawn. Real ones turn by up to a
# degree less. Either way the rule of thumb holds: spread your index and middle finger to a relaxed
# V, which is about 30°; if one finger points along the shot, the other points to where the cue ball
# goes.
#
# **Try:** draw the same with half of the roll (`follow=1.0`), or with a cue ball that is 5 %
# lighter: `Ball("white", at=(-0.1, 0.0), mass=0.155)`.
