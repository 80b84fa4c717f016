"""Let signals end a command as Ctrl-C does, so that it cleans up."""

import contextlib
import signal


def end_as_by_ctrl_c() -> None:
    """Let SIGTERM, and SIGHUP of a closed terminal, raise KeyboardInterrupt; under nohup SIGHUP stays ignored."""
    with contextlib.suppress(ValueError):  # outside the main thread
        for number in {signal.SIGTERM, getattr(signal, "SIGHUP", signal.SIGTERM)}:
            if signal.getsignal(number) == signal.SIG_DFL:
                signal.signal(number, signal.default_int_handler)
