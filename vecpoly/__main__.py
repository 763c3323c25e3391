"""python -m vecpoly."""

from __future__ import annotations

import gc
import sys

# new ones between two looks for garbage: a command lives for a second, and hardly leaves any in circles
_OBJECTS = 250_000


def main() -> None:
    """Run the command line."""
    gc.set_threshold(_OBJECTS)
    try:
        from .cli import main as run

        run()
    except KeyboardInterrupt:  # while still importing
        sys.exit(130)


if __name__ == "__main__":
    main()
