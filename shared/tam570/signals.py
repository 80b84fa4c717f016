"""Let signals end a command as Ctrl-C does, so that it cleans up; before it runs, let Ctrl-C end it at once."""

import contextlib
import signal


def end_at_once() -> None:
    """Let Ctrl-C end the process without a traceback, until `end_as_by_ctrl_c`: nothing has begun yet."""
    if signal.getsignal(signal.SIGINT) is signal.default_int_handler:  # background jobs of a shell ignore it
        signal.signal(signal.SIGINT, signal.SIG_DFL)


def end_as_by_ctrl_c() -> None:
    """Let Ctrl-C, SIGTERM, and SIGHUP of a closed terminal raise KeyboardInterrupt; ignored ones stay ignored."""
    with contextlib.suppress(ValueError):  # outside the main thread
        for number in {signal.SIGINT, signal.SIGTERM, getattr(signal, "SIGHUP", signal.SIGTERM)}:
            if signal.getsignal(number) == signal.SIG_DFL:
                signal.signal(number, signal.default_int_handler)
