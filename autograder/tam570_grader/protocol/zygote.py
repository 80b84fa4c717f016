"""The zygote imports once what the assignments need, then forks monitors, which fork a process for each submission.

They are told of a submission only by a socket, the channel to its process; the submission itself goes through that,
so that no later fork can find an earlier student's work in memory.
"""

import builtins
import functools
import gc
import importlib
import json
import os
import select
import shutil
import signal
import socket
import struct
import sys
import tempfile
import time
import traceback
from collections.abc import Callable
from types import ModuleType
from typing import Any

from tam570.values import Json

from . import jail
from .answer import answers, error_report, evaluate_a_formula, seed_generators
from .cells import plain_cells, python, statements
from .load import compiled, load
from .picture import blank_axes
from .refusals import program
from .wire import packed, stacked, unpacked

__builtins__ = dict(vars(builtins))  # type: ignore[assignment]  # as in wire

LENGTH = struct.Struct(">I")
LONGEST_ORDER = 2**14  # bytes
LONGEST_TEXT, MOST_TOLD = 300, 50  # of what is told of a notebook's cells
HOLD = 0.02  # s that a reply may wait for the next one
READINGS = {"cells": plain_cells, "python": python, "statements": statements}


def main() -> None:
    """Serve the supervisor at the other end of the socket that the last argument names."""
    control = socket.socket(fileno=int(sys.argv[-1]))
    header = control.recv(LENGTH.size, socket.MSG_WAITALL)
    if not header:
        return
    (size,) = LENGTH.unpack(header)
    settings = json.loads(control.recv(size, socket.MSG_WAITALL))
    _import(settings["preload"])
    _warm_up(settings["preload"])
    settings["limits"]["memory"] += jail.address_space()
    program(**jail.Limits(cpu=0, user=None, **settings["limits"]).refusals)
    jail.hidden_from_debuggers()
    signal.signal(signal.SIGCHLD, signal.SIG_IGN)  # monitors are reaped by the kernel
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the supervisor decides what an interrupt ends
    gc.freeze()
    gc.enable()
    lifeline, held = os.pipe()
    control.sendall(b"ready")
    while True:
        order, leashes, _, _ = socket.recv_fds(control, 1, 1)
        if not order:
            return
        if not leashes:
            _compile_step(order[0])
            continue
        if os.fork() == 0:
            control.close()
            os.close(held)
            _watch_all(socket.socket(fileno=leashes[0]), lifeline, settings["limits"])
        os.close(leashes[0])


def _import(preload: list[str]) -> None:
    """Import libraries; Matplotlib without the properties in its docstrings and signatures: half of its time."""
    if "matplotlib.figure" in preload:
        artist: Any = importlib.import_module("matplotlib.artist")
        artist.kwdoc = lambda _: ""
        artist.Artist._update_set_signature_and_docstring = lambda: None
    for name in preload:
        importlib.import_module(name)


def _warm_up(preload: list[str]) -> None:
    """Have the libraries import and compute what they do at their first use, once for all submissions."""
    if "tam570.integrate" in preload:
        _compile_step(2)
    if "matplotlib.figure" in preload:
        blank_axes.prepare()
    if "sympy" in preload:
        evaluate_a_formula()


@functools.cache
def _compile_step(size: int) -> None:
    """Have the integrator compile a step of so many components, if it is imported."""
    if "tam570.integrate" in sys.modules:
        sys.modules["tam570.integrate"].solve(lambda t, y: tuple(y), [0.0, 0.1, 0.2], [1.0] * size)
        gc.freeze()


def _watch_all(leash: socket.socket, lifeline: int, settings: Json) -> None:
    """Fork a sandbox process at each order on the leash, and watch it to its end; never return."""
    signal.signal(signal.SIGCHLD, signal.SIG_DFL)
    has_seceded = not settings["namespaces"]
    try:
        while lifeline not in select.select([leash.fileno(), lifeline], [], [])[0]:
            order, channels, _, _ = socket.recv_fds(leash, LONGEST_ORDER, 1)
            if not order:
                break
            if not channels:  # it is about a process that has ended
                continue
            of_submission = json.loads(order.lstrip(jail.ORDERS))
            for size in of_submission.pop("states"):
                _compile_step(size)
            limits = jail.Limits(**settings, **of_submission)
            if not has_seceded:
                jail.secede(limits)
                has_seceded = True
            _watch(channels[0], leash, lifeline, limits)
    except Exception:
        traceback.print_exc()
    finally:
        os._exit(0)


def _watch(channel: int, leash: socket.socket, lifeline: int, limits: jail.Limits) -> None:
    """Fork a sandbox process and watch it to its end."""
    folder = jail.SCRATCH if limits.namespaces else tempfile.mkdtemp(prefix="tam570-")
    try:
        if not limits.namespaces and limits.user is not None:
            os.chown(folder, limits.user, limits.user)
        if (child := jail.fork(limits)) == 0:
            _serve(channel, limits, folder)
        os.close(channel)
        jail.watch(child, leash, lifeline, limits)
    finally:
        if not limits.namespaces:
            shutil.rmtree(folder, ignore_errors=True)


def _serve(channel: int, limits: jail.Limits, folder: str) -> None:
    """Be the sandbox process: load the submission, then answer calls; never returns."""
    try:
        _confined(limits, channel, folder)
        seed_generators()
        module = None
        while True:
            request = _received()
            if "read" in request:
                _send(_read(READINGS[request["read"]], request["text"]))
            elif "source" in request:
                module = _loaded(request)
            else:
                _answer_all(module, request)
    except Exception:
        traceback.print_exc()  # a fault of ours; after the jail is shut nobody hears it
    finally:
        os._exit(0)


def _confined(limits: jail.Limits, channel: int, folder: str) -> None:
    """Confine this process and say so before it is sent a submission; or say what was in the way, and end."""
    try:
        jail.confine(limits, channel, folder)
    except Exception as error:
        _send({"confined": str(error)})
        os._exit(0)
    _send({"confined": True})


def _read(reading: Callable[[bytes], object], text: bytes) -> Json:
    """Return what is read of a notebook or a module, nothing of which is run."""
    try:
        return {"read": reading(text)}
    except Exception as error:
        return {"error": error_report(error)}


def _loaded(request: Json) -> ModuleType | None:
    """Import the submission, and report the contract's functions that it defines.

    The first reply, on whether it is Python, is sent before any of it runs.
    """
    source, name, notebook = request["source"], request["name"], request["notebook"]
    try:
        pieces, broken = compiled(source, name, notebook=notebook)
        _send({"names": [text[:LONGEST_TEXT] for text in broken[:MOST_TOLD]]})
        bans = {"forbidden": request["forbidden"], "uncallable": request["uncallable"]}
        module, skipped = load(pieces, source, name, notebook=notebook, **bans)
        defined = [name for name in request["functions"] if callable(getattr(module, name, None))]
        _send({"names": defined, "skipped": [text[:LONGEST_TEXT] for text in skipped[:MOST_TOLD]]})
        return module
    except BaseException as error:
        _send({"error": error_report(error)})
        return None


def _answer_all(module: Any, request: Json) -> None:
    """One reply for each call; after an error the rest is not computed, unless every one is asked for.

    Replies to quick calls travel in one message, results alike as one array.
    """
    unsent, sent = list[Json](), time.monotonic()
    for reply in answers(module, request):
        unsent.append(reply)
        if "error" in reply and not request.get("every"):
            break
        if time.monotonic() - sent > HOLD:
            _send(_together(unsent))
            unsent, sent = [], time.monotonic()
    if unsent:
        _send(_together(unsent))


def _together(replies: list[Json]) -> Json:
    good = all(reply.get("changed") is False for reply in replies)
    values = stacked([reply["value"] for reply in replies]) if good else None
    return {"replies": replies} if values is None else {"values": values}


def _received() -> Json:
    (size,) = LENGTH.unpack(_exactly(LENGTH.size))
    request: Json = unpacked(_exactly(size))
    return request


def _exactly(size: int) -> bytes:
    data = bytearray()
    while len(data) < size:
        chunk = os.read(jail.CHANNEL, size - len(data))
        if not chunk:
            os._exit(0)  # the supervisor has gone
        data += chunk
    return bytes(data)


def _send(reply: Json) -> None:
    data = packed(reply)
    unsent = memoryview(LENGTH.pack(len(data)) + data)
    while unsent:
        unsent = unsent[os.write(jail.CHANNEL, unsent) :]


if __name__ == "__main__":
    main()
