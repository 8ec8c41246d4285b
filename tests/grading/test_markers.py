"""What the hand-out makes of marked files."""

import pytest

from grading import markers
from grading.errors import GradingError

TEXT = """int f(int a) {
  // <solution>
  return a + 1;
  // <starter> throw NotWritten("01.1", a);
  // </solution>
}
// <teacher>
// The trap is the sign.
// </teacher>
"""


def test_starter_replaces_solution() -> None:
    stripped = markers.strip(TEXT, as_starter=True)
    assert stripped.text == 'int f(int a) {\n  throw NotWritten("01.1", a);\n}\n'
    assert stripped.removed == [["  return a + 1;"], ["// The trap is the sign."]]


def test_solved_keeps_solution() -> None:
    stripped = markers.strip(TEXT, as_starter=False)
    assert stripped.text == "int f(int a) {\n  return a + 1;\n}\n"
    assert stripped.removed == [["// The trap is the sign."]]


def test_cmake_and_markdown() -> None:
    assert markers.strip("# <teacher>\nx\n# </teacher>\ny\n", True).text == "y\n"
    assert markers.strip("<!-- <solution> -->\n42\n<!-- <starter> ? -->\n<!-- </solution> -->\n", True).text == "?\n"


def test_starter_keeps_indentation() -> None:
    text = "  // <solution>\n  // <starter> if (a) {\n  // <starter>   b();\n  // <starter> }\n  // </solution>\n"
    assert markers.strip(text, True).text == "  if (a) {\n    b();\n  }\n"


@pytest.mark.parametrize("text", ["// <solution>\nx\n", "// </solution>\n", "// <starter> x\n",
                                  "// <solution>\n// <solution>\n", "// <solution>\n// </teacher>\n"])
def test_unpaired_marker_is_an_error(text: str) -> None:
    with pytest.raises(GradingError, match="expected"):
        markers.strip(text, True, "file.cpp")


def test_unmarked_text_stays() -> None:
    text = "a < b; // <not> a marker\r\n#include <solution>\nno end of line"
    assert markers.strip(text, True).text == text
