"""What a starter tree holds, before it is built."""

import os
import pathlib
import re
import subprocess

import pytest

from grading import archive, handout, manifest, selftest
from grading.errors import GradingError
from grading.kit import Kit

STAGES = selftest.graded_stages()


@pytest.mark.parametrize("stage", STAGES)
def test_every_exercise_has_a_starter(stage: str) -> None:
    handout.check_markers(handout.make_starter([stage]), list(manifest.exercises(stage)))


@pytest.mark.parametrize("stage", STAGES)
def test_no_answer_is_left(stage: str) -> None:
    handout.check_leaks(handout.make_starter([stage]), Kit([stage], "secret"))


@pytest.mark.parametrize("stage", STAGES)
def test_sources_include_only_what_is_handed_out(stage: str) -> None:
    files = handout.make_starter([stage]).files
    there = {*files, "common/engine/compiled_simd_targets.h", *(n.removesuffix(".in") for n in files if n.endswith(".h.in"))}
    # What stage 03 compiles for its own tests is of no use before it.
    pending = [name for name in files if name.endswith(".cpp") and name != "tests/oracle/exact_visibility.cpp"]
    seen = set(pending)
    while pending:
        name = pending.pop()
        found = re.findall(r'^#include "((?:common|bench|tests|0\d_\w+)/.+)"', files.get(name, b"").decode(), re.MULTILINE)
        assert set(found) <= there, name
        pending += set(found) - seen
        seen.update(found)


@pytest.mark.parametrize("stage", STAGES)
def test_documents_name_no_command_that_is_not_handed_out(stage: str) -> None:
    for name, content in handout.make_starter([stage]).files.items():
        if name.endswith(".md"):
            commands = re.findall(r"\./lab (handout|grade|bless|selftest|stage 0\d)", content.decode())
            assert all(command.startswith("stage") and command[6:] <= stage[:2] for command in commands), name


def test_a_leak_is_found() -> None:
    starter = handout.make_starter([STAGES[0]])
    line = "  const int direction = to.y() < from.y() ? -1 : 1;"
    assert line in starter.removed["common/lines/bresenham.cpp"][0]
    starter.files["docs/extra.md"] = line.replace(" ", "   ").encode()
    assert ["docs/extra.md" in leak for leak in handout.leaks(starter)] == [True]


def test_later_stages_and_teachers_parts_are_absent() -> None:
    files = handout.make_starter(["02_triangles"]).files
    assert "02_triangles/main.cpp" in files and "01_lines/main.cpp" in files
    assert not [f for f in files if f.startswith(("03_", "grading/", "common/zbuffer", "tests/grading", "tests/stage03",
                                                  "common/engine"))]
    assert "docs/teaching.md" not in files
    assert b"selftest" not in files["lab"]


def test_earlier_stages_are_solved() -> None:
    starter = handout.make_starter(["02_triangles"])
    assert not [file for file in starter.removed if file.startswith("common/lines")]
    assert b"NotWritten" not in starter.files["common/lines/bresenham.cpp"]


def test_archive_is_reproducible(tmp_path: pathlib.Path) -> None:
    packed = []
    for name in ("a", "b"):
        (tmp_path / name / "x").mkdir(parents=True)
        (tmp_path / name / "x" / "run").write_text("#!/bin/sh\n")
        (tmp_path / name / "x" / "run").chmod(0o755)
        (tmp_path / name / "y").write_text("text")
        packed.append(archive.tar_gz(tmp_path / name, "starter"))
    assert packed[0] == packed[1]


def test_checksums_are_sha256sums(tmp_path: pathlib.Path) -> None:
    (tmp_path / "a").write_text("text")
    (tmp_path / archive.CHECKSUMS).write_text(archive.checksums(tmp_path))
    subprocess.run(["sha256sum", "--check", "--quiet", archive.CHECKSUMS], cwd=tmp_path, check=True)


@pytest.mark.skipif("RASTERLAB_LONG_TESTS" not in os.environ, reason="builds a starter: set RASTERLAB_LONG_TESTS=1")
def test_a_starter_is_proved_before_it_is_handed_out(tmp_path: pathlib.Path) -> None:
    out = tmp_path / "starter"
    assert handout.main(["--stage", "01", "--out", str(out), "--archive", str(tmp_path / "a.tar.gz"), "--quick", "-q"]) == 0
    subprocess.run(["sha256sum", "--check", "--quiet", archive.CHECKSUMS], cwd=out, check=True)
    assert not (out / "build").exists() and not (out / ".git").exists()
    assert (tmp_path / "a.tar.gz").read_bytes() == archive.tar_gz(out, "rasterlab")


def test_tests_that_fail_otherwise_stop_the_hand_out() -> None:
    exercises = [e for e in manifest.exercises("01_lines") if e.id == "01.7"]
    unwritten = {"stage01.draw_line.ends": ("fail", 'C++ exception: "exercise 01.7 is not written yet"')}
    assert "1 say" in handout.check_tests(unwritten, exercises)
    with pytest.raises(GradingError, match="fails otherwise"):
        handout.check_tests({**unwritten, "image.size": ("fail", "expected 3")}, exercises)
    with pytest.raises(GradingError, match="no test of 01.7"):
        handout.check_tests({"image.size": ("run", "")}, exercises)


def test_stages_that_say_nothing_stop_the_hand_out() -> None:
    exercises = [e for e in manifest.exercises("01_lines") if e.id in ("01.7", "01.8")]
    said = "01.7: needs 01.8, which is not written yet\n"
    with pytest.raises(GradingError, match="of 01.8"):
        handout.check_stages(said, exercises)
    handout.check_stages(said + "01.8: not written yet\n", exercises)


def test_lines_that_link_to_later_stages_are_left_out() -> None:
    readme = handout.make_starter(["02_triangles"]).files["README.md"].decode()
    assert "](02_triangles/README.md)" in readme and "03_zbuffer/" not in readme
