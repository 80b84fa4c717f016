"""The end of a command by a signal, as by Ctrl-C: what it has begun is put away."""

import contextlib
import signal


def end_as_by_ctrl_c() -> None:
    """Let SIGTERM, and SIGHUP of a window that is closed, raise KeyboardInterrupt; under nohup SIGHUP stays ignored."""
    with contextlib.suppress(ValueError):  # not the main thread
        for number in {signal.SIGTERM, getattr(signal, "SIGHUP", signal.SIGTERM)}:
            if signal.getsignal(number) == signal.SIG_DFL:
                signal.signal(number, signal.default_int_handler)
