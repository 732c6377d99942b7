"""Many threads side by side, each with room of its own: how a graphics card plays a batch.

Nothing in the kernel allocates, so a thread needs no more than its row of every array.
"""

from .body import Grid, Notes, Packed, Ties
from .calendar import many
from .subset import kernel, thread, threads


@kernel
def play(
    shots, places, before, struck, budget, most, until,
    rests, times, counts, kept, found,
    balls, meetings, member, contacts, chosen, blows, head, seats, tree, neighbours, ways, near,
    walls, cloth, ball_rule, cushion_rule, rules, frame, bands, openings,
    celled, lines, size, west, south, columns, lots,
):  # fmt: skip
    """The shots of this thread: every so many of them.

    First what `calendar.many` is given and what it writes, a shot in each row; then the scene: what
    events change, with a row for each thread, and what all threads share, laws as arrays of one.
    """
    mine = thread()
    if mine < len(balls):
        ties = Ties(member[mine], contacts[mine], chosen[mine], blows[mine])
        cells = head[mine], seats[mine], tree[mine], neighbours[mine]
        grid = Grid(size, west, south, columns, lots, *cells)
        scene = Packed(
            balls[mine], meetings[mine], walls, cloth[0], ball_rule[0], cushion_rule[0],
            ties, celled, grid, lines, rules, frame, bands, openings,
        )  # fmt: skip
        for s in range(mine, len(shots), threads()):
            only = slice(s, s + 1)  # of no places, none
            notes = Notes(most, kept[only], found[only], ways[mine], near[mine], until)
            many(
                before, places[only], shots[only], struck, rests[only], times[only], counts[only],
                budget, scene, notes,
            )  # fmt: skip
