"""Many balls: which are near, by cells of a grid, and which event is next, by a tournament.

Every ball is listed in the cell that its centre is in; it can only touch balls of that cell and of
the eight around. Leaving the cell is an event of the calendar, not of physics: the leg goes on.
The outer cells have no outer edge. A new leg notifies no one; an event predicted from an older leg
is discarded when it comes due.
"""

from .contact import meeting
from .kinds import RESTING
from .leg import first_fall, place
from .subset import inf, kernel

MISSING = -1  # no ball, wall or cell
EAST, WEST, NORTH, SOUTH = 0, 1, 2, 3


@kernel
def neighbours(i, balls, grid):
    """The balls that may touch ball i: how many, in grid.near.  Without cells, all of them."""
    count = 0
    if len(grid.head) == 0:
        for k in range(len(balls)):
            if k != i:
                grid.near[count] = k
                count += 1
        return count
    column, row = grid.seats[i].column, grid.seats[i].row
    for c in range(max(column - 1, 0), min(column + 2, grid.columns)):
        for r in range(max(row - 1, 0), min(row + 2, grid.rows)):
            k = grid.head[c * grid.rows + r]
            while k != MISSING:
                if k != i:
                    grid.near[count] = k
                    count += 1
                k = grid.seats[k].after
    return count


@kernel
def leave(i, grid):
    """Take ball i off its cell's list."""
    seat = grid.seats[i]
    after, before = seat.after, seat.before
    if after != MISSING:
        grid.seats[after].before = before
    if before != MISSING:
        grid.seats[before].after = after
    else:
        grid.head[seat.column * grid.rows + seat.row] = after


@kernel
def enter(i, column, row, grid):
    """Put ball i on a cell's list."""
    cell, seat = column * grid.rows + row, grid.seats[i]
    first = grid.head[cell]
    seat.after, seat.before = first, MISSING
    if first != MISSING:
        grid.seats[first].before = i
    grid.head[cell] = i
    seat.column, seat.row = column, row


@kernel
def cell_of(x, low, size, cells):
    """The number of the cell along one axis; the outer cells have no outer edge."""
    if x <= low:
        return 0
    cell = (x - low) / size
    return int(cell) if cell < cells - 1 else cells - 1


@kernel
def locate(i, ball, grid):
    """Ball i has been put somewhere."""
    if grid.seats[i].column != MISSING:
        leave(i, grid)
    column = cell_of(ball.position.real, grid.west, grid.size, grid.columns)
    row = cell_of(ball.position.imag, grid.south, grid.size, grid.rows)
    enter(i, column, row, grid)


@kernel
def plan_crossing(i, ball, time, grid):
    """When, after `time`, will the ball leave its cell, and over which edge?"""
    seat = grid.seats[i]
    seat.cross = inf
    if ball.phase == RESTING:
        return
    column, row = seat.column, seat.row
    t = time - ball.since
    p, v, a = place(ball, t), ball.velocity + t * ball.acceleration, ball.acceleration
    x, y, size, wait = p.real - grid.west, p.imag - grid.south, grid.size, inf
    if column + 1 < grid.columns:
        fall = first_fall((column + 1) * size - x, -v.real, -a.real)
        if fall < wait:
            wait, seat.edge = fall, EAST
    if column > 0:
        fall = first_fall(x - column * size, v.real, a.real)
        if fall < wait:
            wait, seat.edge = fall, WEST
    if row + 1 < grid.rows:
        fall = first_fall((row + 1) * size - y, -v.imag, -a.imag)
        if fall < wait:
            wait, seat.edge = fall, NORTH
    if row > 0:
        fall = first_fall(y - row * size, v.imag, a.imag)
        if fall < wait:
            wait, seat.edge = fall, SOUTH
    seat.cross = time + wait


@kernel
def cross(i, ball, grid):
    """The ball goes over to the next cell, on the leg it is on."""
    seat = grid.seats[i]
    time, edge, column, row = seat.cross, seat.edge, seat.column, seat.row
    leave(i, grid)
    if edge == EAST:
        column += 1
    elif edge == WEST:
        column -= 1
    elif edge == NORTH:
        row += 1
    else:
        row -= 1
    enter(i, column, row, grid)
    plan_crossing(i, ball, time, grid)


@kernel
def rank(i, balls, grid):
    """Ball i has a new next event: play its matches again; of equals the lower number wins."""
    tree = grid.tree
    node = (len(tree) // 2 + i) // 2
    while node > 0:
        left, right = tree[2 * node], tree[2 * node + 1]
        tree[node] = left if right == MISSING or balls[left].next <= balls[right].next else right
        node //= 2


@kernel
def sooner(when, i, ball):
    """Would the ball meet ball i before its partner?  Of two at once the lower number wins."""
    return when < ball.meets or (when == ball.meets and i < ball.partner)


@kernel
def plan_near(i, balls, grid):
    """The near ball that ball i will meet first, and the balls that will meet ball i first."""
    ball = balls[i]
    west, east, south, north = ball.west, ball.east, ball.south, ball.north
    ball.meets, ball.partner = inf, MISSING
    for m in range(neighbours(i, balls, grid)):
        j = grid.near[m]
        other = balls[j]
        if other.west > east or other.east < west or other.south > north or other.north < south:
            continue
        when = meeting(ball, other)
        if sooner(when, j, ball):
            ball.meets, ball.partner = when, j
            grid.seats[i].promise = grid.seats[j].turn
        if sooner(when, i, other):
            other.meets, other.partner = when, i
            grid.seats[j].promise = grid.seats[i].turn
            wait_for(j, balls, grid)
    wait_for(i, balls, grid)


@kernel
def wait_for(i, balls, grid):
    """Enter in the tournament what ball i waits for."""
    ball = balls[i]
    ball.next = min(ball.meets, ball.leg_end, grid.seats[i].cross)
    rank(i, balls, grid)


@kernel
def pass_by(i, balls, grid):
    """Is what ball i waits for no event of physics?  Then that is settled: True."""
    ball, seat = balls[i], grid.seats[i]
    if ball.meets <= ball.leg_end and ball.meets <= seat.cross:
        if seat.promise == grid.seats[ball.partner].turn:
            return False
    elif seat.cross < ball.leg_end:
        cross(i, ball, grid)
    else:
        return False
    plan_near(i, balls, grid)
    return True
