"""How a shot of a batch begins: where the balls lie, and what the cue gives one of them."""

from .body import (
    ANGLE,
    CLIMB,
    ENGLISH,
    FOLLOW,
    HEIGHT,
    JUMP,
    MASSE,
    ROLL_X,
    ROLL_Y,
    SIDE,
    SPEED,
    VX,
    VY,
    X,
    Y,
)
from .elementary import direction
from .leg import DOWN
from .subset import complex, kernel


@kernel
def lay(balls, before, places, s):
    """The balls as they lie or move before a shot; or lying still at its places, if there are any,
    but for those with NaN, which are not on the table."""
    for i in range(len(balls)):
        x, ball = before[i], balls[i]
        ball.since, ball.side = 0.0, x[SIDE]
        ball.velocity, ball.roll = complex(x[VX], x[VY]), complex(x[ROLL_X], x[ROLL_Y])
        ball.position = complex(x[X], x[Y])
        ball.height, ball.climb = x[HEIGHT], x[CLIMB]
        if len(places) > 0:
            here = complex(places[s][i][X], places[s][i][Y])
            gone = here.real != here.real
            ball.position = 0j if gone else here
            ball.height = DOWN if gone else 0.0


@kernel
def strike(ball, shot):
    """Give the ball the velocity and the spin of a shot."""
    d = direction(shot[ANGLE])
    speed, follow, masse = shot[SPEED], shot[FOLLOW], shot[MASSE]
    ball.velocity = complex(speed * d.real, speed * d.imag)
    ball.roll = complex(follow * d.real + masse * d.imag, follow * d.imag - masse * d.real)
    ball.side, ball.climb = shot[ENGLISH], shot[JUMP]
