"""Compiles the loop of Taylor's method."""

import ast
import ctypes
import inspect
import math
import struct
from functools import lru_cache, partial
from typing import NamedTuple

from tam570.integrate.compiled import taylor_loop
from tam570.integrate.compiled.ir import Array, Operand, Value, number
from tam570.integrate.compiled.llvm import assembled
from tam570.integrate.compiled.series import FAST, HIGHEST, padded_size, strides, vector_width
from tam570.integrate.compiled.translate import Translator, functions_of
from tam570.values import Json

KINDS = (ctypes.c_void_p,)  # one address: converting thirteen arguments takes longer than a short run
ARGUMENTS = {
    **dict.fromkeys(("z", "work", "time", "c", "times"), "ptr"),
    **{"rows": "i64", "out": "ptr", "members": "ptr", "several": "i64"},
    **{"origin": "double", "rtol": "double", "order": "i64", "budget": "i64"},
}  # the arguments at that address, eight bytes each
CALL = struct.Struct("=5Qq2Qq2d2q")  # their format
LOWEST = 8  # lowest order


@lru_cache(maxsize=64)
def order_for(rtol: float, lanes: int = 1) -> int:
    """Return the cheapest order, 1 - a log(rtol), odd. Jorba and Zou use a = 0.5, for work that grows as its square.

    Here a sum in a register costs the same at every order: a = 1.2 reaches an error in 0.8 to 0.9 of the time of 0.6
    (mean of twelve problems, from 1e-3 to 1e-9). Below LOWEST, the fixed cost of a step dominates.
    """
    return min(HIGHEST, max(LOWEST, math.ceil(1 - (1.2 if lanes == 1 else 0.6) * math.log(rtol))) | 1)


class Loop(NamedTuple):
    """Parameters of the loop over the steps; right-hand sides with equal ones share its code."""

    size: int
    lanes: int
    saturates: bool
    timed: bool


def loop_module(loop: Loop) -> str:
    """Return LLVM text of the loop over the steps, which calls the functions of `series_module`."""
    size, lanes = loop.size, loop.lanes
    padded = padded_size(size) if lanes == 1 else size
    across, along = strides(size, lanes)
    integers = {"SIZE": size, "PADDED": padded, "ORDER": "%order", "ACROSS": across, "ALONG": along}
    names: Json = {
        **{name: value for name, value in vars(taylor_loop).items() if name.isupper()},
        **{name: index * lanes for index, name in enumerate(taylor_loop.PLACES)},
        **{name: Value("i64", str(value)) for name, value in integers.items()},
        **{name: Value("double", f"%{name}") for name in ("origin", "rtol")},
        **{name: Array(f"%{name}") for name in ("work", "time")},
        "times": Array("%times", None, Value("i64", "%rows")),
        "members": Array("%members", 1 + 2 * size, Value("i64", "%several")),
        **{name: partial(_call_of, name) for name in ("coefficients", "rates", "roundoff", "reach")},
        "LANES": lanes if lanes == 1 else Value("i64", str(lanes)),
        "MEMORY": taylor_loop.memory(size),
        "SATURATES": loop.saturates,
        "TIMED": loop.timed,
        **{"wide": _wide, "logarithm": _logarithm, "power_of_2": _power_of_2},
        **{"largest": _largest if lanes == 1 else _same, "summed": _summed if lanes == 1 else _same},
        "largest_of_all": _same if lanes == 1 else _largest,
        "each": _same if lanes == 1 else lambda writer, k: Value("lanes", writer.text(k, "i64")),
        "shifted": lambda writer, array, k: Array(writer.element(array.text, k), array.row, array.length),
    }
    translator = Translator(functions_of(inspect.getsource(taylor_loop)), names)
    translator.flags, translator.components = " contract", padded
    translator.width = vector_width(size) if lanes == 1 else lanes
    translator.together = translator.width if lanes == 1 else 1
    arguments = [Array("%z"), Array("%out", size), Value("i64", "%budget")]
    translator.call(translator.globals["advance" if lanes == 1 else "advance_all"], arguments)
    preamble = ["define void @advance(ptr %arguments) {", "entry:"]
    for position, (name, ir_type) in enumerate(ARGUMENTS.items()):
        preamble += [f"  %{name}.at = getelementptr i64, ptr %arguments, i64 {position}"]
        preamble += [f"  %{name} = load {ir_type}, ptr %{name}.at"]
    body = [*translator.allocations, *translator.lines, "  ret void", "}"]
    return assembled([*translator.constants(), *preamble, *body])


def _call_of(name: str, writer: Operand) -> int:
    writer.do(f"call void @{name}(ptr %work, ptr %c, ptr %time, i64 %order)")
    return 0


def _same(_: Operand, x: Operand) -> Operand:
    return x


def _wide(writer: Operand, x: Operand) -> Operand:
    return x if writer.width == 1 else Value(f"<{writer.width} x double>", writer.text(x, f"<{writer.width} x double>"))


def _largest(writer: Operand, x: Operand) -> Operand:
    return x if writer.width == 1 else _reduced(writer, "nnan", f"fmax.v{writer.width}f64({x.ir_type} {x.text})")


def _summed(writer: Operand, x: Operand) -> Operand:
    if writer.width == 1:
        return x
    return _reduced(writer, FAST, f"fadd.v{writer.width}f64(double {number(0.0)}, {x.ir_type} {x.text})")


def _reduced(writer: Operand, flags: str, call: str) -> Value:
    return Value("double", writer.emit("double", f"call {flags} double @llvm.vector.reduce.{call}").text)


def _logarithm(writer: Operand, x: Value) -> Value:
    """Return log2(x) to 0.09: the bits of a double, read as an integer, are nearly proportional to it."""
    integers = x.ir_type.replace("double", "i64")
    bits = writer.emit(integers, f"bitcast {x.ir_type} {x.text} to {integers}").text
    bias = writer.text(Value("i64", str(1023 << 52)), integers)
    shifted = writer.emit(integers, f"sub {integers} {bits}, {bias}").text
    exact = writer.emit(x.ir_type, f"sitofp {integers} {shifted} to {x.ir_type}")
    return Value(x.ir_type, writer.arithmetic(ast.Mult(), exact, 2.0**-52).text)


def _power_of_2(writer: Operand, x: Value) -> Value:
    """Return 2**x for |x| <= 1000: the integer part becomes the exponent, a parabola approximates the rest."""
    limited = writer.extreme("max", [writer.extreme("min", [x, 1000.0]), -1000.0])
    ir_type, integers = x.ir_type, x.ir_type.replace("double", "i64")
    floor = writer.call("floor", [limited])
    integer = writer.emit(integers, f"fptosi {ir_type} {floor.text} to {integers}").text
    bias, bits = (writer.text(Value("i64", str(k)), integers) for k in (1023, 52))
    biased = writer.emit(integers, f"add {integers} {integer}, {bias}").text
    exponent = writer.emit(integers, f"shl {integers} {biased}, {bits}").text
    power = writer.emit(ir_type, f"bitcast {integers} {exponent} to {ir_type}")
    rest = writer.arithmetic(ast.Sub(), limited, floor)
    slope = writer.arithmetic(ast.Add(), writer.arithmetic(ast.Mult(), rest, 0.34), 0.66)
    factor = writer.arithmetic(ast.Add(), writer.arithmetic(ast.Mult(), rest, slope), 1.0)
    return Value(ir_type, writer.arithmetic(ast.Mult(), power, factor).text)
