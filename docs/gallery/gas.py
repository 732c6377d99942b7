# %% [markdown]
# # A gas, and its pressure
#
# Take away the cloth's friction and every loss, and billiard balls are a gas of hard discs. Nothing
# is put in but collisions; Maxwell's distribution, the ideal gas law and its correction for
# crowding come out.

# %%
import matplotlib.pyplot as plt
import numpy as np

from physics import Ball, Cloth, EventDriven, Wall, World, laws

SIDE = 12  # so many balls squared  # quick: 3
TIME = 5.0  # s  # quick: 0.5
SIZES = (0.004, 0.008, 0.014, 0.02, 0.026, 0.03)  # m: radii  # quick: (0.02,)


def gas(radius, seed=0):
    """A box of 1 m x 1 m with balls on a grid, all at 1 m/s, each in a direction by chance."""
    chance = np.random.default_rng(seed)
    ice, lossless = Cloth(slide=0.0, roll=0.0, spin_decay=0.0), laws.SmoothBall(e=1.0)
    world = World(ice, lossless, laws.RigidCushion(e=1.0, mu=0.0, nose=1.0), discs=True,
                  engine=EventDriven(vmin=0.0, budget=10**7))
    for normal in (1, 1j, -1, -1j):
        world.add(Wall.line(normal.real, normal.imag, 0.5))
    for x in (np.arange(SIDE) + 0.5) / SIDE - 0.5:
        for y in (np.arange(SIDE) + 0.5) / SIDE - 0.5:
            way = np.exp(2j * np.pi * chance.uniform())
            world.add(Ball(f"{x:.3f} {y:.3f}", at=(x, y), velocity=(way.real, way.imag),
                           radius=radius, mass=1.0))
    return world


# %% [markdown]
# ## From one speed to Maxwell's
# All balls begin with 1 m/s. After a few collisions each, their speeds are spread as Maxwell and
# Boltzmann say, in two dimensions p(v) = (v/T) exp(−v²/2T), with T the energy of a ball.

# %%
world = gas(0.014)
before = world.energy
world.run(until=TIME)
print(f"{len(world.log)} collisions; energy changed by {world.energy / before - 1:.0e}")

times = np.linspace(TIME / 4, TIME, 60)
speeds = np.hypot(*np.concatenate([ball.velocity for ball in world.log.at(times).values()]).T)
v, T = np.linspace(0, 3.2, 200), 0.5
figure, ax = plt.subplots()
ax.hist(speeds, bins=40, density=True, color="#A8CBE3", label="the balls")
ax.plot(v, v / T * np.exp(-(v**2) / (2 * T)), label="Maxwell and Boltzmann")
ax.axvline(1.0, color="#8A949E", ls=":", label="the speed of all at the start")
ax.set(title="Speeds, after a few collisions each", xlabel="speed, m/s", xlim=(0, 3.2))
ax.legend();

# %% [markdown]
# ## Pressure
# Pressure is the momentum that the walls are given, per second and metre. An ideal gas of N discs
# has p = n T, n being how many there are in a square metre. Real ones are in each other's way and
# press harder: by Z = (1 + φ²/8)/(1 − φ)², says Henderson, φ being the part of the area that they
# fill. They also crowd at the walls, so n is counted in the middle of the box.

# %%
def pressure(radius):
    """What is measured, over what an ideal gas would have; and the part of the area filled."""
    world = gas(radius)
    world.run(until=TIME)
    places = world.log.at(np.linspace(TIME / 4, TIME, 200)).values()
    inside = [(np.abs(ball.position) < 0.35).all(axis=1).mean() for ball in places]
    density = sum(inside) / 0.7**2
    hits = [event for event in world.log.all("cushion") if event.time > TIME / 4]
    force = sum(event.impulse for event in hits) / (0.75 * TIME)
    length = 4.0 - 8.0 * radius  # of the square in which the centres are
    return force / length / (density * 0.5), density * np.pi * radius**2


measured, filled = np.array([pressure(radius) for radius in SIZES]).T
phi = np.linspace(0, 0.45, 100)
figure, ax = plt.subplots()
ax.plot(phi, (1 + phi**2 / 8) / (1 - phi) ** 2, label="Henderson")
ax.axhline(1.0, color="#8A949E", ls=":", label="ideal gas")
ax.plot(filled, measured, "o", ms=8, color="#1C222B", label="measured at the walls")
ax.set(title="Pressure against crowding", xlabel="part of the area that balls fill",
       ylabel="p / n T")
ax.legend()
print("measured over Henderson:", (measured / ((1 + filled**2 / 8) / (1 - filled) ** 2)).round(3))

# %% [markdown]
# **Try:** give every second ball eight times the mass. In the mean it has the same energy as a
# light one, so it is slower: equipartition. Let the balls be rough (`laws.RoughBall(e=1.0,
# mu=1.0)`), and their spin takes a share, too.
