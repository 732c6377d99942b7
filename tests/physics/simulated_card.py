"""A batch on numba's simulator of a card beside the CPU's; exit status 1 if a bit differs.

`NUMBA_ENABLE_CUDASIM=1 python -m tests.physics.simulated_card SCENE SHOTS`
"""

import sys

from benchmarks.cuda import SCENES, differing, shots
from physics import simulate_many


def read_fields_as_a_card_does() -> None:
    """The simulator takes the field `size` of a record for the size of an array."""
    from numba.cuda.simulator.cudadrv import devicearray

    inside, outside = devicearray.FakeWithinKernelCUDAArray, devicearray.FakeCUDAArray
    plain = inside.__getattr__

    def read(array, name):
        item = array._item
        if item.dtype.names and name in item.dtype.names:
            found = item[name]
            return inside(found) if isinstance(found, outside) else found
        return plain(array, name)

    inside.__getattr__ = read


def main(scene: str, count: str) -> int:
    from numba import config

    assert config.ENABLE_CUDASIM
    read_fields_as_a_card_does()
    make, ball, _ = SCENES[scene]
    world, table = make(), shots(int(count))
    card = simulate_many(world, ball, table, contacts=40, device="cuda")
    cpu = simulate_many(world, ball, table, contacts=40, compiled=False)
    print(f"{scene}: {int(card.events.sum())} events, {differing(cpu, card)} shots differ")
    return int(differing(cpu, card) > 0)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
