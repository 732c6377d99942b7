"""A tour of the physics package, run by the tests."""

from math import hypot

from physics import (
    Ball,
    Shot,
    TimeStepping,
    Wall,
    aim,
    ledger,
    simulate,
    simulate_many,
    tables,
    trace,
)

world = tables.medium_carom()  # table, cloth, laws and coefficients in one preset
white = world.add(Ball("white", at=(-0.6, 0.0)))  # one line a ball
red = world.add(Ball("red", at=(0.6, 0.01)))
world.add(Wall.through((0.9, -0.635), (1.27, -0.3)))  # one line a wall; balls on its left

# a shot: speed in m/s, angle in degrees, and three spins as surface speeds in m/s: + is follow, a
# curve to the right, right english (anticlockwise from above)
world.strike(white, Shot(speed=3.0, angle=1.0, follow=1.5, masse=0.0, side=0.5))
for _ in range(60):
    for _ in range(6):  # n calls a frame: any n, the same outcome, bit for bit
        world.step(1 / 60 / 6)
world.run()  # to rest; world.log tells what happened

for event in world.log[:5]:
    print(f"{event.time:7.4f} s  {event.kind:8} {' '.join(event.balls):10} {event.wall or ''}")
assert world.at_rest
assert any(event.kind == "ball" for event in world.log)

# state can be read and assigned at any moment
white.position, red.position = (-0.6, 0.0), (0.6, 0.01)

# the same shot under other laws
shot = Shot(3.0, angle=1.0)
for law in ("rigid", "thesis"):
    world.cushion_law = law
    after = simulate(world, white, shot)  # pure: copies, runs, returns
    x, y = after.balls[1].position
    print(f"{law:9} red rests at ({x:.6f}, {y:.6f})")

# the thesis's way, in steps of 1/180 s, is a quarter of a metre off
exact = simulate(world, white, shot)
world.engine = TimeStepping(dt=1 / 180)
late = simulate(world, white, shot)
print("stepping is off by", hypot(*(a - b for a, b in zip(
    exact.balls[1].position, late.balls[1].position, strict=True))), "m")  # fmt: skip

# a thousand shots at once: arrays out
world = tables.medium_carom()
white, red = world.add(Ball("white", at=(-0.6, 0.0))), world.add(Ball("red", at=(0.6, 0.01)))
many = simulate_many(world, white, [Shot(3.0, angle=0.36 * k) for k in range(1000)])
assert many.positions.shape == (1000, 2, 2)

# aim, play, ask: cut the red by 30 degrees to the player's left
half = aim.at(world, "white", "red", cut=30.0)
after = simulate(world, white, half.shot(2.0, follow=2.0))
hit = after.log.first("ball", "white", "red")
print(f"{half.eighths:.0f}/8 thick; the red leaves at {hit.after['red'].heading:.1f}°, not at"
      f" {half.line:.1f}°; the cloth takes {ledger(after.log).lost()['cloth']:.3f} J")  # fmt: skip
assert half.refined(world, Shot(2.0, follow=2.0)).angle < half.angle  # throw is made up for

times, paths = trace(exact, rate=60)  # for plots: (frames, balls, 2), metres
assert paths.shape == (len(times), 2, 2)

# with a sixth number, m/s upward, the ball jumps; CueStroke.jump says what a raised cue gives
jump = simulate(world, white, Shot(2.0, climb=1.0))
print(f"the white comes down after {jump.log[0].time:.3f} s")
