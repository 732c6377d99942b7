"""Values made of fields as plain data and back, to the last bit: what a saved match is made of."""

from __future__ import annotations

from dataclasses import fields, is_dataclass
from functools import lru_cache
from types import NoneType, UnionType
from typing import Any, Union, get_args, get_origin, get_type_hints


def packed(value: Any) -> Any:
    """A value as JSON has it: fields by name, numbers that are not whole in hexadecimal."""
    if value is None or isinstance(value, str | bool | int):
        return value
    if isinstance(value, float):
        return value.hex()
    if isinstance(value, complex):
        return [value.real.hex(), value.imag.hex()]
    if is_dataclass(value):
        return {one.name: packed(getattr(value, one.name)) for one in fields(value)}
    if hasattr(value, "_asdict"):
        return {name: packed(one) for name, one in value._asdict().items()}
    if isinstance(value, tuple | list):
        return [packed(one) for one in value]
    raise TypeError(f"{type(value).__name__} cannot be packed")


def unpacked(kind: Any, data: Any) -> Any:
    """The value of that type; ValueError, naming what is wrong, if the data is none."""
    origin, args = get_origin(kind), get_args(kind)
    if origin in (UnionType, Union):
        inner = next(arg for arg in args if arg is not NoneType)
        return None if data is None else unpacked(inner, data)
    if origin is tuple:
        return _tuple(args, _is(data, list))
    if kind is float:
        return _float(data)
    if kind is complex:
        real, imaginary = _is(data, list)
        return complex(_float(real), _float(imaginary))
    if kind in (int, str, bool):
        return _is(data, kind)
    return _record(kind, _is(data, dict))


def _is(data: Any, kind: type) -> Any:
    if type(data) is not kind:
        raise ValueError(f"{kind.__name__} expected, not {data!r:.60}")
    return data


def _float(data: Any) -> float:
    return float.fromhex(_is(data, str))


def _tuple(args: tuple[Any, ...], data: list[Any]) -> tuple[Any, ...]:
    if args[-1:] == (...,):
        return tuple(unpacked(args[0], one) for one in data)
    if len(args) != len(data):
        raise ValueError(f"{len(args)} values expected, not {len(data)}")
    return tuple(unpacked(arg, one) for arg, one in zip(args, data, strict=True))


@lru_cache(maxsize=32)
def _hints(kind: Any) -> dict[str, Any]:
    found = get_type_hints(kind)
    names = getattr(kind, "_fields", None) or [one.name for one in fields(kind)]
    return {name: found[name] for name in names}


def _record(kind: Any, data: dict[str, Any]) -> Any:
    hints = _hints(kind)
    if unknown := set(data) - set(hints):
        raise ValueError(f"{kind.__name__} has no {min(unknown)!r:.60}")
    try:
        return kind(**{name: unpacked(hints[name], one) for name, one in data.items()})
    except TypeError as error:
        raise ValueError(f"{kind.__name__}: {error}") from None
