"""The command ``judder``: the same as the program of that name."""

import sys

from judder._judder import command


def main() -> int:
    """Does what the command line says and returns the exit code."""
    return command(["judder", *sys.argv[1:]])


if __name__ == "__main__":
    sys.exit(main())
