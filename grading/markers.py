"""The markers that say what is solution, what replaces it, and what is for teachers only.

In C++ (after //), CMake (after #) and Markdown (in <!-- -->), each alone on its line:

    // <solution>                              solution: left out of a starter
    return a + b;
    // <starter> throw NotWritten("01.6", a);  what stands there instead, as text of the marker
    // </solution>

    // <teacher>                               for teachers only: left out of every hand-out
    // </teacher>

A starter of several lines is several <starter> markers. Blocks do not nest.
"""

import dataclasses
import pathlib
import re

from grading.errors import GradingError

MARKED = {".cpp", ".h", ".inl", ".txt", ".cmake", ".md"}

_MARKER = re.compile(
    r"^(?P<indent>[ \t]*)(?://|#|<!--)[ \t]*<(?P<name>/?(?:solution|starter|teacher))>[ ]?"
    r"(?P<text>.*?)[ \t]*(?:-->)?[ \t]*$")


@dataclasses.dataclass
class Stripped:
    text: str
    removed: list[list[str]]  # the lines of each block that was left out


def is_marked(path: pathlib.PurePath) -> bool:
    return path.suffix in MARKED or str(path) == "lab"


def strip(text: str, as_starter: bool, name: str = "text") -> Stripped:
    """Removes the markers, the teachers' parts and, for a starter, the solutions, which are replaced."""
    kept: list[str] = []
    removed: list[list[str]] = []
    block = ""
    for number, line in enumerate(text.splitlines(keepends=True), 1):
        marker = _MARKER.match(line.rstrip("\r\n"))
        if marker is None:
            if block == "teacher" or (block == "solution" and as_starter):
                removed[-1].append(line.rstrip("\r\n"))
            else:
                kept.append(line)
            continue
        kind = marker["name"]
        if kind == "starter":
            _expect(block == "solution", name, number, "<starter> inside a <solution>")
            if as_starter:
                kept.append(f"{marker['indent']}{marker['text']}".rstrip() + "\n")
        elif kind.startswith("/"):
            _expect(block == kind[1:], name, number, f"no <{kind}> without its beginning")
            block = ""
        else:
            _expect(not block, name, number, f"the end of <{block}> before <{kind}>")
            block = kind
            removed.append([])
    _expect(not block, name, len(text.splitlines()), f"the end of <{block}>")
    return Stripped("".join(kept), [lines for lines in removed if lines])


def _expect(condition: bool, name: str, line: int, expected: str) -> None:
    if not condition:
        raise GradingError(f"{name}:{line}: expected {expected}")
