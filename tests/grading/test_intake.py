"""What is taken of a submission."""

import io
import pathlib
import tarfile
import zipfile

import pytest

from grading import intake

ALLOWED = ("common/lines/bresenham.cpp", "common/lines/draw_line.cpp")


def submit(folder: pathlib.Path, files: dict[str, str]) -> pathlib.Path:
    for name, text in files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text)
    return folder


def test_starter_layout_and_flat(tmp_path: pathlib.Path) -> None:
    nested = submit(tmp_path / "a", {"rasterlab/common/lines/bresenham.cpp": "1", "CMakeLists.txt": "x"})
    flat = submit(tmp_path / "b", {"draw_line.cpp": "2"})
    assert intake.take(nested, ALLOWED).files == {ALLOWED[0]: b"1"}
    assert intake.take(nested, ALLOWED).ignored == 1
    assert intake.take(flat, ALLOWED).files == {ALLOWED[1]: b"2"}


def test_zip_and_tar_give_the_same(tmp_path: pathlib.Path) -> None:
    with zipfile.ZipFile(tmp_path / "s.zip", "w") as archive:
        archive.writestr("me/draw_line.cpp", "int x;")
    with tarfile.open(tmp_path / "s.tar.gz", "w:gz") as tar:
        info = tarfile.TarInfo("me/draw_line.cpp")
        info.size = 6
        tar.addfile(info, io.BytesIO(b"int x;"))
    for name in ("s.zip", "s.tar.gz"):
        assert intake.take(tmp_path / name, ALLOWED).files == {ALLOWED[1]: b"int x;"}
        assert intake.submission_name(tmp_path / name) == "s"


def test_links_are_refused(tmp_path: pathlib.Path) -> None:
    (tmp_path / "draw_line.cpp").symlink_to("/etc/passwd")
    taken = intake.take(tmp_path, ALLOWED)
    assert not taken.files
    assert "link" in taken.notes[0]


@pytest.mark.parametrize("content", [b"x" * (intake.MAX_FILE + 1), b"a\0b"])
def test_too_large_or_binary_is_refused(tmp_path: pathlib.Path, content: bytes) -> None:
    (tmp_path / "draw_line.cpp").write_bytes(content)
    taken = intake.take(tmp_path, ALLOWED)
    assert not taken.files
    assert taken.notes


def test_exact_limit_is_taken(tmp_path: pathlib.Path) -> None:
    (tmp_path / "draw_line.cpp").write_bytes(b" " * intake.MAX_FILE)
    assert len(intake.take(tmp_path, ALLOWED).files[ALLOWED[1]]) == intake.MAX_FILE


def test_layout_wins_over_flat(tmp_path: pathlib.Path) -> None:
    submit(tmp_path, {"draw_line.cpp": "flat", "common/lines/draw_line.cpp": "layout"})
    taken = intake.take(tmp_path, ALLOWED)
    assert taken.files == {ALLOWED[1]: b"layout"}
    assert "two different files" in taken.notes[0]


def test_what_is_no_archive_is_noted(tmp_path: pathlib.Path) -> None:
    (tmp_path / "essay.zip").write_text("dear teacher")
    taken = intake.take(tmp_path / "essay.zip", ALLOWED)
    assert not taken.files
    assert "expected a folder, a zip or a tar" in taken.notes[0]


def test_backslashes_and_dots(tmp_path: pathlib.Path) -> None:
    with zipfile.ZipFile(tmp_path / "s.zip", "w") as archive:
        archive.writestr("./common\\lines\\draw_line.cpp", "1")
        archive.writestr("../../common/lines/bresenham.cpp", "2")
    taken = intake.take(tmp_path / "s.zip", ALLOWED)
    assert taken.files == {ALLOWED[1]: b"1"}
    assert taken.ignored == 1
