# %% [markdown]
# # Training an agent
#
# The games are Gymnasium environments. This agent sees where three balls lie, strikes, and is told
# whether it has scored; it tries nothing beforehand. A linear policy and REINFORCE, in thirty lines
# of NumPy, are enough to see it learn straight rail within seconds.

# %%
import gymnasium
import matplotlib.pyplot as plt
import numpy as np

from danggu.envs import IDS

TABLES, UPDATES = 1024, 150  # quick: 4, 2

print(*IDS)  # which importing danggu.envs has registered
env = gymnasium.make_vec(
    "danggu/StraightRail-v0", num_envs=TABLES, noise="club", autoreset_mode="SameStep"
)
env.single_observation_space, env.single_action_space

# %% [markdown]
# An action is five numbers from −1 to 1: which ball, how thick and on which side, how hard, and
# where the tip meets the cue ball ([environments](../environments.md)). The policy draws each from
# a normal distribution around a function of what is seen, and shifts it towards what scored more
# often than the rest.

# %%
def features(seen):
    """What the policy is linear in: places, their squares, and one."""
    return np.hstack([seen, seen**2, np.ones((len(seen), 1))])


chance = np.random.default_rng(0)
seen, _ = env.reset(seed=0)
weights, spread = np.zeros((features(seen).shape[1], 5)), np.full(5, 0.6)
shares, first = [], None
for update in range(UPDATES):
    x = features(seen)
    noise = chance.normal(size=(TABLES, 5))
    actions = x @ weights + spread * noise
    first = actions if update == 0 else first
    seen, reward, *_ = env.step(actions)
    better = (reward - reward.mean()) / (reward.std() + 1e-9)
    weights += 0.05 * x.T @ (better[:, None] * noise) / TABLES
    spread *= np.exp(0.02 * (better[:, None] * (noise**2 - 1)).mean(axis=0))
    shares.append(100 * (reward > 0).mean())

# %%
def smooth(shares, over=10):
    return np.convolve(shares, np.full(over, 1 / over), "valid") if len(shares) > over else shares


figure, ax = plt.subplots()
ax.plot(np.arange(len(shares)) * TABLES, shares, ".", color="#A8CBE3", label="each update")
ax.plot(np.arange(len(smooth(shares))) * TABLES, smooth(shares), label="mean of ten")
ax.set(title="Straight rail, with the errors of a club player", xlabel="strokes played",
       ylabel="% that score", ylim=(0, None))
ax.legend(loc="lower right");

# %% [markdown]
# ## What has it learnt?
# Thickness and speed of its strokes, before and after:

# %%
figure, axes = plt.subplots(1, 2, figsize=(9.6, 3.6))
names = {1: "thickness: −1 right edge, 0 full, 1 left edge", 2: "speed: −1 soft, 1 hard"}
for ax, (k, name) in zip(axes, names.items(), strict=True):
    for drawn, label, colour in ((first, "before", "#A8CBE3"), (actions, "after", "#D6202F")):
        ax.hist(drawn[:, k].clip(-1, 1), bins=30, range=(-1, 1), density=True, histtype="step",
                color=colour, lw=2, label=label)
    ax.set(xlabel=name, yticks=[])
axes[0].legend();

# %% [markdown]
# It has found what beginners find: hit hard, and something will happen. To look at the table before
# it strikes takes a network: [learning.py](../learning.py) has one of two layers, in forty lines,
# and learns three-cushion in half a minute.
#
# **Try:** `"danggu/OneCushion-v0"`, or a noise of `"master"`. What would you have it see besides
# places?
