"""How a world is shown: its picture in a notebook, and on the axes of a figure."""

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from matplotlib.axes import Axes


class Pictured:
    """The part of a World that shows it."""

    __slots__ = ()

    def plot(
        self: Any, ax: "Axes | None" = None, label: str | None = None,
        balls: Iterable[str] | None = None,
    ) -> "Axes":  # fmt: skip
        """Draw the table and the paths of its log with matplotlib (extra `plot`); returns the axes.

        ax: where; new axes if None. What is drawn there already stays: so shots are laid over one
        another.
        label: for the legend; the paths then share one colour. Without it, balls have their own.
        balls: names of those to draw; all if None. ValueError for one that is not there.
        """
        from .studies.plot import onto

        named = None if balls is None else [self.ball(name).name for name in balls]
        return onto(self, ax, label, named)

    def _repr_svg_(self: Any) -> str:
        """The table with the balls, and the paths of the log."""
        from .studies.svg import picture

        return picture(self)
