"""A program that learns three-cushion in minutes, with NumPy alone: REINFORCE with Adam.

It sees where the balls lie and says how to strike; what scored more often than the rest of that
moment becomes likelier. `python docs/learning.py` prints the share of strokes that score.
"""

from itertools import pairwise

import gymnasium
import numpy as np

import danggu.envs  # noqa: F401  (registers the games)

TABLES, HIDDEN, RATE = 2048, 64, 0.003


def learned(updates, name="danggu/ThreeCushion-v0", noise="expert", tables=TABLES, seed=0):
    """Yields the share of the strokes that scored, update by update."""
    env = gymnasium.make_vec(name, num_envs=tables, noise=noise, autoreset_mode="SameStep")
    rng, (seen, _) = np.random.default_rng(seed), env.reset(seed=seed)
    sizes = (seen.shape[1], HIDDEN, HIDDEN, 5)
    weights = [rng.normal(0.0, a**-0.5, (a + 1, b)) for a, b in pairwise(sizes)]
    weights[-1] *= 0.1
    weights.append(np.full((1, 5), -0.5))  # log of how far actions are spread
    moments = [(np.zeros_like(w), np.zeros_like(w)) for w in weights]
    one = np.ones((tables, 1))
    for k in range(1, updates + 1):
        layers = [np.hstack([seen, one])]
        for w in weights[:2]:
            layers.append(np.hstack([np.tanh(layers[-1] @ w), one]))
        spread, chance = np.exp(weights[3]), rng.normal(size=(tables, 5))
        seen, reward, *_ = env.step(layers[-1] @ weights[2] + spread * chance)
        better = ((reward - reward.mean()) / (reward.std() + 1e-9))[:, None] / tables
        back = better * chance / spread
        slopes = [(better * (chance**2 - 1.0)).sum(axis=0, keepdims=True)]
        for w, layer in zip(weights[2::-1], layers[::-1], strict=True):
            slopes.insert(0, layer.T @ back)
            back = (back @ w.T * (1.0 - layer**2))[:, :-1]
        for w, slope, (mean, square) in zip(weights, slopes, moments, strict=True):
            mean += 0.1 * (slope - mean)
            square += 0.001 * (slope**2 - square)
            size = np.sqrt(square / (1.0 - 0.999**k)) + 1e-9
            w += RATE * mean / (1.0 - 0.9**k) / size
        yield reward.mean()


if __name__ == "__main__":
    shares = []
    for share in learned(1500):
        shares.append(share)
        if len(shares) % 100 == 0:
            print(f"{len(shares)} updates: {100 * np.mean(shares[-100:]):.1f} % score", flush=True)
