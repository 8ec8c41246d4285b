"""What ends a command with one line on standard error."""


class UsageError(Exception):
    """A command line that asks for what is not there: exit status 2."""


class GradingError(Exception):
    """Bad input, or a machine that cannot do what was asked: exit status 1."""
