"""Things by their names, of which more are known than are listed."""

from __future__ import annotations

from typing import TypeVar

Thing = TypeVar("Thing")


class Unlisted(dict[str, Thing]):
    """A dict whose `__missing__` makes what is not listed: that is in it too, and in no list."""

    def __contains__(self, key: object) -> bool:
        if dict.__contains__(self, key) or not isinstance(key, str):
            return dict.__contains__(self, key)
        try:
            return bool(self[key])
        except KeyError:
            return False
