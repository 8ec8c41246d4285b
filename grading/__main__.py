"""python3 -m grading COMMAND: what `./lab handout`, `grade`, `bless` and `selftest` run."""

import importlib
import signal
import sys

from grading.errors import GradingError, UsageError

COMMANDS = ("handout", "grade", "bless", "selftest")


def main(arguments: list[str]) -> int:
    if not arguments or arguments[0] not in COMMANDS:
        print(f"usage: python3 -m grading {{{','.join(COMMANDS)}}} …", file=sys.stderr)
        return 2
    command = arguments[0]
    # A cluster that takes a machine back asks with SIGTERM: nothing is to be left behind then either.
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    try:
        module = importlib.import_module(f"grading.{command}")
        return int(module.main(arguments[1:]))
    except UsageError as error:
        print(f"{command}: {error}", file=sys.stderr)
        return 2
    except (GradingError, OSError) as error:
        print(f"{command}: {error}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print(f"{command}: interrupted; a graded submission is kept and not graded again", file=sys.stderr)
        return 130


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
