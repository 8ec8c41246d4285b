"""The self test's own housekeeping; what it proves is for `./lab selftest`."""

import pathlib
import tempfile

import pytest

from grading import jail, selftest
from grading.errors import GradingError
from grading.grade import Grader


def test_leaves_no_folder_when_it_fails(tmp_path: pathlib.Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def fail(grader: Grader) -> None:
        assert grader.out.parent == tmp_path and grader.out.is_dir()
        raise GradingError("the reference does not build")

    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    monkeypatch.setattr(jail, "unenforced", lambda: ())
    monkeypatch.setattr(Grader, "prepare", fail)
    with pytest.raises(GradingError, match="does not build"):
        selftest.main(["--kit", "01", "--jobs", "1"])
    assert not list(tmp_path.iterdir())
