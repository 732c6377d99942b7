"""Custom laws as machine code: each is compiled by itself, in a fraction of a second, and the
kernel, which takes twenty to compile, calls it by its address."""

from collections.abc import Callable
from functools import cache
from typing import Any

from llvmlite import ir
from numba import cfunc, njit, types
from numba.core import cgutils
from numba.extending import intrinsic

NUMBER = types.float64
OUT = types.CPointer(NUMBER)


def caller(given: int, returned: int) -> Any:
    """What calls the function at an address with so many numbers, for compiled code: it writes its
    answer, so many numbers, where a last argument points. So no structure crosses the border, which
    every platform passes in its own way."""
    answer = types.UniTuple(NUMBER, returned)
    signature = answer(types.int64, types.UniTuple(NUMBER, given))

    @intrinsic  # type: ignore[untyped-decorator]
    def call(context: Any, address: Any, numbers: Any) -> Any:
        def code(context: Any, builder: Any, signature: Any, args: Any) -> Any:
            double = ir.DoubleType()
            room = cgutils.alloca_once(builder, double, size=ir.Constant(ir.IntType(64), returned))
            kind = ir.FunctionType(ir.VoidType(), [double] * given + [double.as_pointer()])
            function = builder.inttoptr(args[0], kind.as_pointer())
            values = cgutils.unpack_tuple(builder, args[1], given)
            builder.call(function, [*values, room])
            written = [
                builder.load(cgutils.gep_inbounds(builder, room, k)) for k in range(returned)
            ]
            return context.make_tuple(builder, answer, written)

        return signature, code

    return call


def custom_cushion() -> Any:
    """The kernel's way to a custom cushion law."""
    call = caller(5, 5)

    def function(v: complex, roll: complex, side: float, rule: Any) -> Any:
        numbers = (v.real, v.imag, roll.real, roll.imag, side)
        vx, vy, rx, ry, spun = call(rule.address, numbers)
        return complex(vx, vy), complex(rx, ry), spun

    return function


def custom_ball() -> Any:
    """The kernel's way to a custom ball law."""
    call = caller(6, 3)

    def function(v: complex, roll: complex, side: float, mass: float, rule: Any) -> Any:
        numbers = (v.real, v.imag, roll.real, roll.imag, side, mass)
        push, along, upward = call(rule.address, numbers)
        return push, complex(along, upward)

    return function


def _cushion(law: Any) -> Any:
    def function(vx: float, vy: float, rx: float, ry: float, side: float, out: Any) -> None:
        v, roll, spun = law(complex(vx, vy), complex(rx, ry), side)
        out[0], out[1] = complex(v).real, complex(v).imag
        out[2], out[3] = complex(roll).real, complex(roll).imag
        out[4] = spun

    return function


def _ball(law: Any) -> Any:
    def function(
        vx: float, vy: float, rx: float, ry: float, side: float, mass: float, out: Any
    ) -> None:
        push, rub = law(complex(vx, vy), complex(rx, ry), side, mass)
        out[0], out[1], out[2] = push, complex(rub).real, complex(rub).imag

    return function


@cache
def _machine_code(law: Callable[..., Any], ball: bool) -> Any:
    """The law compiled, kept as long as the process lasts."""
    inner = law if hasattr(law, "py_func") else njit(error_model="numpy")(law)
    given, made = (6, _ball(inner)) if ball else (5, _cushion(inner))
    return cfunc(types.void(*[NUMBER] * given, OUT))(made)


def address(law: Callable[..., Any], ball: bool) -> int:
    """Where the law's machine code is; ValueError, with numba's reason, if there can be none."""
    from numba.core.errors import NumbaError

    try:
        return int(_machine_code(law, ball).address)
    except NumbaError as error:
        name = getattr(law, "__name__", repr(law))
        reasons = [line for line in str(error).splitlines() if line and "nopython" not in line]
        raise ValueError(
            f"the law {name} cannot be compiled: {reasons[0] if reasons else error}; without"
            " @laws.compiled it runs interpreted"
        ) from error
