"""The command lines."""

import pathlib
import signal

import pytest

from grading import __main__, grade, manifest, record
from grading.errors import UsageError
from grading.record import Record


def test_shards_part_the_submissions() -> None:
    items = list(range(10))
    parts = [items[index - 1:: count] for index, count in (grade.parse_shard(f"{i}/3") for i in (1, 2, 3))]
    assert sorted(sum(parts, [])) == items


@pytest.mark.parametrize("text", ["0/3", "4/3", "1", "a/b", "1/0"])
def test_bad_shard_is_refused(text: str) -> None:
    with pytest.raises(UsageError, match="expected I/N"):
        grade.parse_shard(text)


def test_names_are_unique(tmp_path: pathlib.Path) -> None:
    for folder in ("a", "b"):
        (tmp_path / folder).mkdir()
        (tmp_path / folder / "work.zip").write_text("")
    named = grade.name_submissions([tmp_path / "a/work.zip", tmp_path / "b/work.zip"])
    assert [name for _, name in named] == ["work", "work_2"]


def test_unknown_stage_exits_with_2(capsys: pytest.CaptureFixture[str]) -> None:
    assert __main__.main(["grade", "--kit", "09", "--out", "/tmp/x", "y"]) == 2
    assert "expected 01 to 07" in capsys.readouterr().err


def test_missing_submission_exits_with_2(tmp_path: pathlib.Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert __main__.main(["grade", "--kit", "01", "--out", str(tmp_path), str(tmp_path / "nobody")]) == 2
    assert "no such submission" in capsys.readouterr().err


def test_a_request_to_end_is_an_interrupt(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    handler = signal.getsignal(signal.SIGTERM)
    monkeypatch.setattr(grade, "main", lambda _: signal.raise_signal(signal.SIGTERM))
    try:
        assert __main__.main(["grade"]) == 130
    finally:
        signal.signal(signal.SIGTERM, handler)
    assert "interrupted" in capsys.readouterr().err


def test_record_of_another_version_is_not_read(tmp_path: pathlib.Path) -> None:
    record.save(Record({"version": 999}), tmp_path / "r.json")
    assert record.load(tmp_path / "r.json") is None


def test_path_stage() -> None:
    stages = {"common/image/image.h": 0, "common/lines/octants.cpp": 1, "02_triangles/main.cpp": 2,
              "tests/stage03/CMakeLists.txt": 3, "common/engine/engine.h": 4, "common/shaders/x.h": 7, "lab": 0}
    assert {path: manifest.path_stage(path) for path in stages} == stages
