"""The record of one graded submission: a versioned JSON file, from which everything published is made.

docs/teaching.md describes its fields. Version 1.
"""

import dataclasses
import json
import os
import pathlib
import tempfile
from typing import Any

from grading.catalogue import Explanation
from grading.evaluate import Outcome, SceneOutcome, Verdict

VERSION = 1

Json = dict[str, Any]


@dataclasses.dataclass(frozen=True)
class Record:
    """A record read back; its fields are those of the file."""

    data: Json

    @property
    def name(self) -> str:
        return str(self.data["submission"])

    @property
    def score(self) -> float | None:
        """Points, or None when the grader failed somewhere: never a silent zero."""
        score = self.data["score"]
        return None if score is None else float(score)

    @property
    def max_score(self) -> float:
        return float(self.data["max_score"])

    @property
    def exercises(self) -> list[Json]:
        return list(self.data["exercises"])

    @property
    def complete(self) -> bool:
        return self.score is not None


def scene_entry(outcome: SceneOutcome, points: float) -> Json:
    entry: Json = {"name": outcome.scene.title, "hidden": outcome.scene.hidden, "verdict": outcome.verdict.value,
                   "score": round(points * outcome.score, 3), "max_score": round(points, 3)}
    if not outcome.scene.hidden:  # of a hidden scene nobody learns more than how it ended
        entry |= {"message": outcome.message, "printed": outcome.printed, "results": outcome.records,
                  "number": outcome.scene.number}
    return entry


def exercise_entry(outcome: Outcome, explanation: Explanation | None) -> Json:
    exercise = outcome.exercise
    by_hand = outcome.verdict is Verdict.BY_HAND
    shown = next((s for s in outcome.scenes if s.verdict is not Verdict.RIGHT and not s.scene.hidden), None)
    message = outcome.message
    if outcome.scenes and outcome.verdict not in (Verdict.RIGHT, Verdict.GRADER_ERROR):
        message = shown.message if shown else "The public scenes are right, a hidden one is not."
    entry: Json = {"id": exercise.id, "title": exercise.title, "file": exercise.file, "contract": exercise.header,
                   "section": exercise.section, "verdict": outcome.verdict.value, "score": outcome.score,
                   "max_score": 0.0 if by_hand else exercise.points, "message": message,
                   "compiler": outcome.compiler, "mistake": None, "scenes": []}
    if explanation is not None:
        entry["mistake"] = {"id": explanation.mistake.id, "title": explanation.mistake.title,
                            "breaks": explanation.mistake.breaks, "likeness": round(explanation.likeness, 3)}
    if outcome.scenes:
        entry["scenes"] = [scene_entry(scene, exercise.points / len(outcome.scenes)) for scene in outcome.scenes]
    return entry


def make(name: str, digest: str, stages: list[str], notes: list[str], unenforced: tuple[str, ...],
         entries: list[Json], whole: Json) -> Record:
    failed = any(entry["score"] is None for entry in entries)
    return Record({
        "version": VERSION, "submission": name, "digest": digest, "stages": stages, "notes": notes,
        "limits_not_enforced": list(unenforced),
        "score": None if failed else round(sum(entry["score"] for entry in entries), 2),
        "max_score": sum(entry["max_score"] for entry in entries), "exercises": entries, "whole": whole})


def write_text(path: pathlib.Path, text: str) -> None:
    """Writes a file whole or not at all."""
    path.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.NamedTemporaryFile("w", dir=path.parent, delete=False, encoding="utf-8",
                                     errors="replace") as file:
        file.write(text)
    os.chmod(file.name, 0o644)
    os.replace(file.name, path)


def save(record: Record, path: pathlib.Path) -> None:
    write_text(path, json.dumps(record.data, indent=1, ensure_ascii=False) + "\n")


def load(path: pathlib.Path) -> Record | None:
    """A record read back; None where there is none of this version."""
    try:
        data = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return None
    return Record(data) if isinstance(data, dict) and data.get("version") == VERSION else None
