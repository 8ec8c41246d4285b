"""The catalogue of known mistakes: wrong solutions written by us, and what each computes.

A failing answer is explained by the mistake whose results err like its own. A mistake is kept as the edits
that turn the reference's file into the wrong one (grading/mutants/stageNN.toml), so that it cannot fall
behind the reference unnoticed: an edit that no longer applies is an error of `./lab selftest`.
"""

import dataclasses
import functools
import hashlib
import json
import pathlib
import tempfile
import tomllib
from collections.abc import Callable, Iterable
from typing import Any

from grading import evaluate, jail
from grading.errors import GradingError
from grading.evaluate import Outcome, Verdict
from grading.kit import Kit
from grading.manifest import ROOT, Exercise

# A mistake is named when at least this share of what is wrong agrees with it.
NAMED_FROM = 0.6


@dataclasses.dataclass(frozen=True)
class Mistake:
    id: str
    exercise: str
    title: str  # what was done wrong, as one would tell a student
    breaks: str  # the sentence of the contract that is broken
    edits: tuple[tuple[str, str], ...]


@dataclasses.dataclass(frozen=True)
class Explanation:
    mistake: Mistake
    likeness: float


@dataclasses.dataclass(frozen=True)
class KnownMistake:
    """What a mistake computes: by scene number its result file and its verdict."""

    mistake: Mistake
    results: dict[int, pathlib.Path]
    verdicts: dict[int, Verdict]


@functools.cache
def mistakes(stage: str) -> tuple[Mistake, ...]:
    path = ROOT / "grading" / "mutants" / f"stage{stage[:2]}.toml"
    if not path.exists():
        return ()
    entries: list[dict[str, Any]] = tomllib.loads(path.read_text()).get("mutant", [])
    try:
        return tuple(Mistake(e["id"], e["exercise"], e["title"], e["breaks"],
                             tuple((find, replace) for find, replace in e["edits"])) for e in entries)
    except (KeyError, ValueError) as error:
        raise GradingError(f"{path}: expected id, exercise, title, breaks and edits: {error}") from error


def wrong_file(mistake: Mistake, exercise: Exercise) -> bytes:
    """The wrong solution: the reference's file with the edits made."""
    text = (ROOT / exercise.file).read_text()
    for find, replace in mistake.edits:
        if text.count(find) != 1:
            raise GradingError(f"mutant {mistake.id}: {exercise.file} holds {text.count(find)} times, "
                               f"expected once: {find!r}")
        text = text.replace(find, replace)
    return text.encode()


def known_mistakes(kit: Kit, exercise: Exercise) -> list[KnownMistake]:
    """Those of an exercise, each compiled and run once and kept."""
    return [_known(kit, exercise, mistake) for mistake in mistakes(exercise.stage)
            if mistake.exercise == exercise.id]


def _known(kit: Kit, exercise: Exercise, mistake: Mistake) -> KnownMistake:
    source = wrong_file(mistake, exercise)
    reference = kit.reference(exercise.stage).read_bytes()
    key = hashlib.sha256(source + b"\0" + reference).hexdigest()[:20]
    folder = kit.folder / "mistakes" / f"{mistake.id}-{key}"
    numbers = [scene.number for scene in kit.scenes(exercise)]
    verdicts_file = folder / f"verdicts-{hashlib.sha256(str(numbers).encode()).hexdigest()[:8]}.json"
    if not verdicts_file.exists():
        folder.mkdir(parents=True, exist_ok=True)
        with jail.scratch_folder() as scratch:
            own = pathlib.Path(scratch, "own")
            own.write_bytes(source)
            outcome = evaluate.evaluate(kit, exercise, {exercise.file: own}, pathlib.Path(scratch), {}, None)
            if outcome.verdict is Verdict.GRADER_ERROR:
                raise GradingError(outcome.message)
            for scene in outcome.scenes:
                if scene.result is not None and scene.result.exists():
                    (folder / f"{scene.scene.number}.result").write_bytes(scene.result.read_bytes())
        verdicts = {str(s.scene.number): s.verdict.value for s in outcome.scenes}
        with tempfile.NamedTemporaryFile("w", dir=folder, delete=False) as file:
            json.dump(verdicts, file)
        pathlib.Path(file.name).rename(verdicts_file)
    read = {int(number): Verdict(verdict) for number, verdict in json.loads(verdicts_file.read_text()).items()}
    results = {number: folder / f"{number}.result" for number in read
               if (folder / f"{number}.result").exists()}
    return KnownMistake(mistake, results, read)


def results_by_scene(known: Iterable[KnownMistake]) -> dict[int, dict[str, pathlib.Path]]:
    by_scene: dict[int, dict[str, pathlib.Path]] = {}
    for entry in known:
        for number, path in entry.results.items():
            by_scene.setdefault(number, {})[entry.mistake.id] = path
    return by_scene


def explain(outcome: Outcome, known: list[KnownMistake]) -> Explanation | None:
    """The known mistake whose results err most like the answer's, if any does."""
    if outcome.verdict in (Verdict.RIGHT, Verdict.GRADER_ERROR) or not outcome.scenes:
        return None
    best: Explanation | None = None
    for entry in known:
        likeness = _likeness(outcome, entry)
        if likeness >= NAMED_FROM and (best is None or likeness > best.likeness):
            best = Explanation(entry.mistake, likeness)
    return best


def _likeness(outcome: Outcome, known: KnownMistake) -> float:
    likenesses: list[float] = []
    computed = (Verdict.RIGHT, Verdict.WRONG)
    for scene in outcome.scenes:
        other = known.verdicts.get(scene.scene.number)
        if other is None or scene.result is None:
            continue
        if scene.verdict in computed and other in computed:
            likeness = scene.likeness.get(known.mistake.id, -1.0)
            if likeness >= 0:  # below: both are right there
                likenesses.append(likeness)
        else:
            likenesses.append(1.0 if scene.verdict is other else 0.0)
    return sum(likenesses) / len(likenesses) if likenesses else 0.0


def prepare(kit: Kit, run_all: Callable[[Callable[[Exercise], Any], list[Exercise]], Any]) -> None:
    """Computes all known mistakes of a kit before the first submission needs them."""
    run_all(lambda exercise: known_mistakes(kit, exercise), kit.graded_exercises)
