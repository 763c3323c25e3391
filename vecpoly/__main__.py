"""python -m vecpoly."""

from __future__ import annotations

import os
import signal
import sys

from .foundation.running.rubbish import seldom_looked_for


def main() -> None:
    """Run the command line."""
    seldom_looked_for()
    os.environ.setdefault("PYDANTIC_DISABLE_PLUGINS", "__all__")  # else it reads what every package here says of itself
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # for small matrices threads do nothing but wait for each other
    try:
        from .cli import main as run

        run()
    except KeyboardInterrupt:  # while still importing
        sys.exit(130)
    finally:
        _past_interrupts()


def _past_interrupts() -> None:
    """From here on the exit code is settled, and Ctrl-C comes too late to change it.

    Python notes an interrupt that met it in `exec` or `eval` of a text, which is how dataclasses are made, and in the
    end dies of the signal (-2) although the interrupt was caught; the next text that is evaluated clears the note.
    """
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    eval("0")


if __name__ == "__main__":
    main()
