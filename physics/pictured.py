"""How a world is shown: its picture in a notebook, and on the axes of a figure."""


class Pictured:
    """The part of a World that shows it."""

    __slots__ = ()
