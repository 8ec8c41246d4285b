"""Grading a class: what is graded, and what is not graded again."""

import os
import pathlib
import shlex
import subprocess
import sys
import threading
import time
import types
from typing import Any

import pytest

from grading import grade, jail, kit, manifest, record
from grading.errors import UsageError
from grading.evaluate import Outcome, Verdict
from grading.grade import Grader
from grading.manifest import ROOT, Exercise

EXERCISE = next(e for e in manifest.exercises("01_lines") if e.id == "01.7")


class Class:
    """A kit of one exercise whose reference is never built: answers get the verdicts listed, one after the other."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch, folder: pathlib.Path) -> None:
        self.verdicts: list[Verdict] = []
        self.folder = folder
        self.kit: Any = types.SimpleNamespace(digest="kit", stages=["01_lines"], exercises=[EXERCISE],
                                              graded_exercises=[EXERCISE])
        monkeypatch.setattr(jail, "unenforced", lambda: ())
        monkeypatch.setattr(grade, "check_whole", lambda *_: {"verdict": "right", "message": ""})
        monkeypatch.setattr(grade, "evaluate_and_explain", self._evaluate)
        (folder / "anna").mkdir()
        self.hand_in("one answer")

    def _evaluate(self, _kit: Any, exercise: Exercise, *_: object) -> tuple[Outcome, None]:
        verdict = self.verdicts.pop(0)
        return Outcome(exercise, verdict, None if verdict is Verdict.GRADER_ERROR else 2.0), None

    def hand_in(self, text: str) -> None:
        (self.folder / "anna" / "draw_line.cpp").write_text(text)

    def grade(self, *verdicts: Verdict) -> bool:
        """Whether the submission had to be graded now."""
        self.verdicts = list(verdicts)
        _, now = Grader(self.kit, self.folder / "report", 1).grade(self.folder / "anna", "anna")
        assert not self.verdicts
        return now


def test_unchanged_submission_is_not_graded_again(tmp_path: pathlib.Path, monkeypatch: pytest.MonkeyPatch) -> None:
    lab = Class(monkeypatch, tmp_path)
    assert lab.grade(Verdict.RIGHT)
    assert not lab.grade()


def test_changed_submission_or_kit_is_graded_again(tmp_path: pathlib.Path, monkeypatch: pytest.MonkeyPatch) -> None:
    lab = Class(monkeypatch, tmp_path)
    lab.grade(Verdict.RIGHT)
    lab.hand_in("another answer")
    assert lab.grade(Verdict.WRONG)
    lab.kit.digest = "another kit"
    assert lab.grade(Verdict.WRONG)


def test_failure_of_the_grader_is_tried_again(tmp_path: pathlib.Path, monkeypatch: pytest.MonkeyPatch) -> None:
    lab = Class(monkeypatch, tmp_path)
    assert lab.grade(Verdict.GRADER_ERROR)
    assert lab.grade(Verdict.RIGHT)


def test_record_that_was_cut_off_is_made_again(tmp_path: pathlib.Path, monkeypatch: pytest.MonkeyPatch) -> None:
    lab = Class(monkeypatch, tmp_path)
    lab.grade(Verdict.RIGHT)
    (tmp_path / "report/records/anna.json").write_text('{"version": 1, "dig')
    assert lab.grade(Verdict.RIGHT)


class Term:
    """A class of five whose answers are evaluated by what they say, through the command itself."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch, folder: pathlib.Path) -> None:
        self.evaluated: list[str] = []
        self.interrupted_at = ""
        self.folder = folder
        kit = types.SimpleNamespace(digest="kit", stages=["01_lines"], exercises=[EXERCISE], graded_exercises=[EXERCISE])
        monkeypatch.setattr(grade, "Kit", lambda *_: kit)
        monkeypatch.setattr(Grader, "prepare", lambda _: None)
        monkeypatch.setattr(jail, "unenforced", lambda: ())
        monkeypatch.setattr(grade, "check_whole", lambda *_: {"verdict": "right", "message": ""})
        monkeypatch.setattr(grade, "evaluate_and_explain", self._evaluate)
        for name in ("anna", "ben", "carla", "dora", "emil"):
            (folder / name).mkdir()
            (folder / name / "draw_line.cpp").write_text(name)

    def _evaluate(self, _kit: Any, exercise: Exercise, own: dict[str, pathlib.Path],
                  *_: object) -> tuple[Outcome, None]:
        text = own[exercise.file].read_text()
        if text == self.interrupted_at:
            raise KeyboardInterrupt
        self.evaluated.append(text)
        return Outcome(exercise, Verdict.WRONG if "a" in text else Verdict.RIGHT, len(text) / 4), None

    def grade(self, out: str, *options: str) -> list[str]:
        """Whose answers were evaluated."""
        self.evaluated = []
        submissions = [str(path) for path in self.folder.iterdir() if (path / "draw_line.cpp").exists()]
        try:
            grade.main(["--kit", "01", "-q", *submissions, "--out", str(self.folder / out), *options])
        except KeyboardInterrupt:
            pass
        return sorted(self.evaluated)

    def report(self, out: str) -> dict[str, bytes]:
        """Every file of a report but the list of commands, which names its folder."""
        return {str(path.relative_to(self.folder / out)): path.read_bytes()
                for path in (self.folder / out).rglob("*") if path.is_file() and path.name != "jobs.tsv"}


def test_interrupted_run_goes_on_where_it_stopped(tmp_path: pathlib.Path, monkeypatch: pytest.MonkeyPatch) -> None:
    term = Term(monkeypatch, tmp_path)
    term.grade("whole")
    term.interrupted_at = "carla"
    assert term.grade("stopped") == ["anna", "ben"]
    term.interrupted_at = ""
    assert term.grade("stopped") == ["carla", "dora", "emil"]
    assert term.report("stopped") == term.report("whole")


def test_shards_together_are_the_whole_run(tmp_path: pathlib.Path, monkeypatch: pytest.MonkeyPatch) -> None:
    term = Term(monkeypatch, tmp_path)
    term.grade("whole")
    assert term.grade("parts", "--shard", "1/2") == ["anna", "carla", "emil"]
    assert term.grade("parts", "--shard", "2/2") == ["ben", "dora"]
    assert term.report("parts") == term.report("whole")


def test_an_interrupt_waits_for_what_has_begun(tmp_path: pathlib.Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(jail, "unenforced", lambda: ())
    grader = Grader(types.SimpleNamespace(), tmp_path, jobs=2)  # type: ignore[arg-type]
    begun = threading.Event()
    ended: list[int] = []

    def work(item: int) -> None:
        if item == 0:
            begun.wait()
            raise KeyboardInterrupt
        begun.set()
        time.sleep(0.1)
        ended.append(item)

    with pytest.raises(KeyboardInterrupt):
        grader.run_all(work, [0, 1])
    assert ended == [1]


def test_jobs_grade_each_alone_and_the_command_collects(tmp_path: pathlib.Path, monkeypatch: pytest.MonkeyPatch) -> None:
    term = Term(monkeypatch, tmp_path)
    term.grade("whole")
    assert term.grade("jobs", "--list") == []
    for line in (tmp_path / "jobs/jobs.tsv").read_text().splitlines():
        name, path, command = line.split("\t")
        assert len(command) < 200 + 2 * len(str(tmp_path))  # however large the class
        term.evaluated = []
        assert grade.main([*shlex.split(command)[2:], "-q"]) == 0
        assert term.evaluated == [name] == [pathlib.Path(path).name]
    assert not (tmp_path / "jobs/index.html").exists()
    assert term.grade("jobs") == []
    assert term.report("jobs") == term.report("whole")


@pytest.mark.parametrize("options", [["--name", "anna", "x", "y"], ["--name", "anna", "x", "--shard", "1/2"],
                                     ["--name", "../anna", "x"]])
def test_name_of_a_job_is_that_of_one_submission(options: list[str]) -> None:
    with pytest.raises(UsageError, match="expected"):
        grade.main(["--kit", "01", "--out", "report", *options])


def test_digest_holds_all_that_grades_and_nothing_that_publishes() -> None:
    script = "import sys, grading.record, grading.catalogue, grading.intake; print(*sys.modules)"
    done = subprocess.run([sys.executable, "-c", script], cwd=ROOT, capture_output=True, text=True, check=True)
    grades = {ROOT / (name.replace(".", "/") + ".py") for name in done.stdout.split() if name.startswith("grading.")}
    files = set(kit.tool_files())
    assert len(grades) > 8 and grades <= files and ROOT / "grading/grade.py" in files
    assert ROOT / "grading/mutants/stage02.toml" in files
    assert not [path for path in files if path.parent.name == "exports" or path.name == "selftest.py"]


@pytest.mark.skipif("RASTERLAB_LONG_TESTS" not in os.environ, reason="builds the reference: set RASTERLAB_LONG_TESTS=1")
def test_examples_are_graded_as_they_deserve(tmp_path: pathlib.Path, capsys: pytest.CaptureFixture[str]) -> None:
    examples = sorted(str(path) for path in (ROOT / "grading/examples").iterdir())
    command = ["--kit", "02", *examples, "--out", str(tmp_path)]
    assert grade.main([*command, "--shard", "1/2"]) == 0
    assert capsys.readouterr().out.count("\n") == 2
    assert grade.main(command) == 0
    assert capsys.readouterr().out.count("unchanged") == 2
    anna, ben, carla = (record.load(tmp_path / f"records/{name}.json") for name in ("anna", "ben", "carla"))
    assert anna and ben and carla
    assert anna.score == sum(e["max_score"] for e in anna.exercises if e["verdict"] != "no output") == 12
    assert {e["mistake"]["id"] for e in ben.exercises if e["mistake"]} == {
        "02.1_left_open", "02.4_no_top_left_rule", "02.5_weights_of_other_corners", "02.7_back_faces_drawn"}
    assert {e["verdict"] for e in carla.exercises} == {"compile error", "time", "no output"}
