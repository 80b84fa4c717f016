"""The zygote imports the libraries once, then forks monitors, which fork a process for each submission.

Zygote and monitors never have a submission in memory, where a later fork could find it: they only pass on a socket,
the channel, through which the supervisor sends the submission to its process.
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
import sys
import tempfile
import time
import traceback
from collections.abc import Callable
from types import ModuleType
from typing import Any

from tam570.notebooks import text_of
from tam570.values import Json

from . import jail
from .answer import answers, error_report, evaluate_a_formula, seed_generators
from .cells import plain_cells, statements
from .load import compiled, load
from .picture import blank_axes
from .refusals import program
from .wire import LENGTH, LONGEST_TEXT, packed, stacked, unpacked

__builtins__ = dict(vars(builtins))  # type: ignore[assignment]  # as in wire

LONGEST_ORDER = 2**14  # bytes
MOST_TOLD = 50  # reports on a notebook's cells
HOLD = 0.02  # s that a reply may wait, to be sent together with the next ones
READINGS = {"cells": plain_cells, "python": lambda text: text_of(text, ".ipynb"), "statements": statements}


def main() -> None:
    """Run the zygote: serve the supervisor on the socket whose file descriptor is the last command line argument."""
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
    signal.signal(signal.SIGCHLD, signal.SIG_IGN)  # the kernel reaps monitors
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # on an interrupt, the supervisor ends the zygote
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
    """Import libraries; do not let Matplotlib add properties to its docstrings, which takes half of its import time."""
    if "matplotlib.figure" in preload:
        artist: Any = importlib.import_module("matplotlib.artist")
        artist.kwdoc = lambda _: ""
        artist.Artist._update_set_signature_and_docstring = lambda: None
    for name in preload:
        importlib.import_module(name)


def _warm_up(preload: list[str]) -> None:
    """Use the libraries once, so that their lazy imports and computations are done for all submissions."""
    if "tam570.integrate" in preload:
        _compile_step(2)
    if "matplotlib.figure" in preload:
        blank_axes.prepare()
    if "sympy" in preload:
        evaluate_a_formula()


@functools.cache
def _compile_step(size: int) -> None:
    """Let the integrator, if it is imported, compile its step for `size` components."""
    if "tam570.integrate" in sys.modules:
        sys.modules["tam570.integrate"].solve(lambda t, y: tuple(y), [0.0, 0.1, 0.2], [1.0] * size)
        gc.freeze()


def _watch_all(leash: socket.socket, lifeline: int, settings: Json) -> None:
    """Run a monitor: for each order on the leash, fork a sandbox process and watch it until it ends; never return."""
    signal.signal(signal.SIGCHLD, signal.SIG_DFL)
    has_seceded = not settings["namespaces"]
    try:
        while lifeline not in select.select([leash.fileno(), lifeline], [], [])[0]:
            order, channels, _, _ = socket.recv_fds(leash, LONGEST_ORDER, 1)
            if not order:
                break
            if not channels:  # an order about a process that has ended
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
    """Fork a sandbox process and watch it until it ends."""
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
    """Run the sandbox process: load the submission and answer calls until the process ends; never return."""
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
        traceback.print_exc()  # a fault of the grader; invisible after `confine`, which redirects stderr
    finally:
        os._exit(0)


def _confined(limits: jail.Limits, channel: int, folder: str) -> None:
    """Confine this process and report that, before it gets a submission; on failure, report the reason and exit."""
    try:
        jail.confine(limits, channel, folder)
    except Exception as error:
        _send({"confined": str(error)})
        os._exit(0)
    _send({"confined": True})


def _read(reading: Callable[[bytes], object], text: bytes) -> Json:
    """Return the result of parsing a notebook or a module, or the error; nothing of it is run."""
    try:
        return {"read": reading(text)}
    except Exception as error:
        return {"error": error_report(error)}


def _loaded(request: Json) -> ModuleType | None:
    """Import the submission, send the names of the contract's functions that it defines, and return the module.

    A first reply, on whether it is Python, is sent before any of it runs.
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
    """Send a reply for each call; stop after an error unless the request has `every`.

    Replies to fast calls share a message; if all are results of one form, it contains one array.
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
            os._exit(0)  # the supervisor has closed the channel
        data += chunk
    return bytes(data)


def _send(reply: Json) -> None:
    data = packed(reply)
    unsent = memoryview(LENGTH.pack(len(data)) + data)
    while unsent:
        unsent = unsent[os.write(jail.CHANNEL, unsent) :]
