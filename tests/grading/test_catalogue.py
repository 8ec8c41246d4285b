"""The catalogue of known mistakes against the reference as it is now."""

import functools
import re
import tomllib

import pytest

from grading import catalogue, manifest, selftest
from grading.kit import is_header, scene_source
from grading.manifest import ROOT

STAGES = selftest.graded_stages()


@pytest.mark.parametrize("stage", STAGES)
def test_every_mistake_still_applies(stage: str) -> None:
    exercises = {exercise.id: exercise for exercise in manifest.exercises(stage)}
    for mistake in catalogue.mistakes(stage):
        exercise = exercises[mistake.exercise]
        assert catalogue.wrong_file(mistake, exercise) != (ROOT / exercise.file).read_bytes()


@pytest.mark.parametrize("stage", STAGES)
def test_every_graded_exercise_has_a_mistake(stage: str) -> None:
    known = {mistake.exercise for mistake in catalogue.mistakes(stage)}
    assert known == {exercise.id for exercise in manifest.exercises(stage) if not exercise.grading.by_hand}


@functools.cache
def contract(header: str) -> str:
    """What the comments of a header, and of those that it includes, say."""
    text = (ROOT / header).read_text()
    comments = " ".join(re.findall(r"//[/<]*(.*)", text))
    included = re.findall(r'#include "(common/.*\.h)"', text)
    return " ".join([*comments.split(), *map(contract, included)])


@pytest.mark.parametrize("stage", STAGES)
def test_mistakes_quote_the_contract_they_break(stage: str) -> None:
    headers = {exercise.id: exercise.header for exercise in manifest.exercises(stage)}
    for mistake in catalogue.mistakes(stage):
        assert mistake.breaks in contract(headers[mistake.exercise]), mistake.id


@pytest.mark.parametrize("stage", STAGES)
def test_every_exercise_has_three_right_answers_written_differently(stage: str) -> None:
    for exercise in manifest.exercises(stage):
        answers = [path.read_text().partition("namespace rasterlab")[2] for path in selftest.RIGHT.glob(f"*/{exercise.file}")]
        own = (ROOT / exercise.file).read_text().partition("namespace rasterlab")[2]
        assert exercise.grading.by_hand or len({"".join(text.split()) for text in [own, *answers]}) >= 4, exercise.id


def test_names_are_unique() -> None:
    names = [mistake.id for stage in STAGES for mistake in catalogue.mistakes(stage)]
    assert len(names) == len(set(names))


def test_answers_in_other_words_name_known_mistakes() -> None:
    names = {mistake.id for stage in manifest.STAGES for mistake in catalogue.mistakes(stage)}
    answers = tomllib.loads((ROOT / "grading/mutants/in_other_words.toml").read_text())["answer"]
    assert {answer["named"] for answer in answers} <= names


@pytest.mark.parametrize("stage", STAGES)
def test_answers_that_are_headers_are_tried_in_files_of_their_own(stage: str) -> None:
    tried = {scene_source(exercise) for exercise in manifest.exercises(stage)
             if is_header(exercise.file) and not exercise.grading.by_hand}
    assert {path.relative_to(ROOT).as_posix() for path in (ROOT / f"grading/probes/stage{stage[:2]}").glob("*")} == tried
