"""What a ball can be doing, and what can happen to it: two tables of names.

The kernel knows a phase or an event by the number of its row.
"""

from typing import NamedTuple


class Phase(NamedTuple):
    """What a ball does between two events."""

    name: str
    lies: bool = False  # does it stay as it is until something meets it?
    gone: bool = False  # has it left the table?  Then nothing ever does


RESTING, ROLLING, SLIDING, AIRBORNE, OFF, POCKETED = 0, 1, 2, 3, 4, 5
PHASES = (  # first those on the cloth, then those in the air, then those that are gone
    Phase("resting", lies=True),
    Phase("rolling"),
    Phase("sliding"),
    Phase("airborne"),
    Phase("off", lies=True, gone=True),
    Phase("pocketed", lies=True, gone=True),
)
PHASE_NAMES = {number: phase.name for number, phase in enumerate(PHASES)}


class Kind(NamedTuple):
    """What an event of a ball is."""

    name: str
    other: str = ""  # what else is in it: a "wall", a "ball" or the "cloth"
    closes: bool = False  # does the gap between them close, so that there is a closing speed?
    contact: bool = False  # do they push each other?


ROLL, REST, LAND, LEAVE, CUSHION, PAIR, DROP, SLOW = 0, 1, 2, 3, 4, 5, 6, 7
KINDS = (
    Kind("roll"),
    Kind("rest"),
    Kind("land", "cloth", closes=True, contact=True),
    Kind("off", "wall"),
    Kind("cushion", "wall", closes=True, contact=True),
    Kind("ball", "ball", closes=True, contact=True),
    Kind("pocket", "wall"),
    Kind("slow"),
)
# What happens at an instant may also be many of these, or none; and for some nothing was found.
CLUSTER, LASTING, NOTHING, UNSOLVED = 10, 11, 12, 13
