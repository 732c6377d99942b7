"""A value in a file and where it is there, so that an error can say so."""

from dataclasses import dataclass
from math import inf
from typing import Any

from physics.checks import finite, vector
from physics.wall import Point


@dataclass(frozen=True, slots=True)
class Node:
    """A value in the file, and where it is."""

    value: Any
    where: str

    def __getitem__(self, key: Any) -> "Node":
        where = f"{self.where}.{key}" if self.where else str(key)
        if not isinstance(self.value, dict):
            raise ValueError(
                f"{self.where or 'the whole'} must be an object, not {self.value!r:.60}"
            )
        if key not in self.value:
            raise ValueError(f"{where} is missing")
        return Node(self.value[key], where)

    def items(self) -> "list[Node]":
        if not isinstance(self.value, list):
            raise ValueError(f"{self.where} must be a list, not {self.value!r:.60}")
        return [Node(value, f"{self.where}[{k}]") for k, value in enumerate(self.value)]

    def number(self) -> float:
        if isinstance(self.value, str | bool):
            raise ValueError(f"{self.where} must be a number, not {self.value!r:.60}")
        return finite(self.where, self.value)

    def number_or_inf(self) -> float:
        """JSON has no infinity: null stands for it."""
        return inf if self.value is None else self.number()

    def complex(self) -> complex:
        return complex(*vector(self.where, [node.number() for node in self.items()], 2))

    def point(self) -> Point:
        z = self.complex()
        return z.real, z.imag

    def truth(self) -> bool:
        if not isinstance(self.value, bool):
            raise ValueError(f"{self.where} must be true or false, not {self.value!r:.60}")
        return self.value

    def text(self) -> str:
        if not isinstance(self.value, str):
            raise ValueError(f"{self.where} must be text, not {self.value!r:.60}")
        return self.value
