"""What is read of a build folder."""

from grading import bless, ninja


def test_objects_include_their_own_header() -> None:
    compiled = [c for c in ninja.compiled_objects(bless.BUILD) if c.source == "common/lines/bresenham.cpp"]
    included = ninja.included_files(bless.BUILD)[compiled[0].output]
    assert {"common/lines/bresenham.cpp", "common/lines/line_discrete.h"} <= included


def test_link_command_names_the_program() -> None:
    command = ninja.link_command(bless.BUILD, "01_lines")
    assert command[command.index("-o") + 1] == "bin/01_lines"
