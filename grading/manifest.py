"""The exercises of the stages, as their exercises.json say, and which files belong to which stage."""

import dataclasses
import functools
import pathlib
import re
from typing import Any

from grading.errors import GradingError, UsageError
from grading.fields import field, read_json, strings

ROOT = pathlib.Path(__file__).resolve().parent.parent

STAGES = ("01_lines", "02_triangles", "03_zbuffer", "04_projection", "05_lighting", "06_texture", "07_shaders")

# The stage that brings each topic of common; topics not named here are given from the start. The engine is
# the fast renderer: what the stages before 04 ask for could be read there. Its benchmarks draw textures.
TOPIC_STAGE = {"lines": 1, "triangles": 2, "zbuffer": 3, "projection": 4, "viewer": 4, "engine": 4,
               "bench/engine": 6, "bench/engine_ladders": 6, "lighting": 5, "texture": 6, "data": 6, "shaders": 7}


@dataclasses.dataclass(frozen=True)
class Grading:
    """The optional object "grading" of an exercise: docs/teaching.md says what each means."""

    by_hand: str = ""  # why a machine does not grade it; empty: it does
    empty: float = 0.0  # points of an empty answer
    hidden: int = 4  # how many hidden scenes
    picture_credit: float = 0.5  # of a scene's points, given by the share of it that is right


@dataclasses.dataclass(frozen=True)
class Exercise:
    id: str
    stage: str
    title: str
    file: str
    function: str
    points: float
    tests: tuple[str, ...]
    writes: tuple[str, ...]
    grading: Grading

    @property
    def section(self) -> str:
        """Where the lab sheet explains it."""
        return f"{self.stage}/README.md, exercise {self.id}"

    @property
    def header(self) -> str:
        """The contract: the header beside the file; where rungs of a ladder share one, that which declares them."""
        beside = ROOT / pathlib.PurePosixPath(self.file).with_suffix(".h")
        if not beside.exists():
            beside = next(path for path in sorted(beside.parent.glob("*.h"))
                          if re.search(rf"\b{self.function}\(", path.read_text()))
        return beside.relative_to(ROOT).as_posix()


def stage_number(stage: str) -> int:
    return int(stage[:2])


def find_stages(text: str) -> list[str]:
    """"02,03" to ["02_triangles", "03_zbuffer"]."""
    found = []
    for part in text.split(","):
        matches = [stage for stage in STAGES if part.strip() in (stage, stage[:2], stage[1:2])]
        if not matches:
            raise UsageError(f"stage '{part}': expected 01 to 07, several with commas between")
        found += matches
    return sorted(set(found))


def path_stage(path: str) -> int:
    """The stage that brings a file of the repository; 0 for what is there from the start."""
    if match := re.search(r"(?:^|/)(?:stage)?(0[1-7])(?:_|/|\.|$)", path):
        return int(match.group(1))
    if match := re.match(r"((?:common|tests|bench|docs)/([a-z_]+))(?:/|\.md$)", path):
        return TOPIC_STAGE.get(match[1], TOPIC_STAGE.get(match[2], 0))
    return 0


def _grading(entry: dict[str, Any]) -> Grading:
    known = {entry_field.name for entry_field in dataclasses.fields(Grading)}
    if unknown := set(entry) - known:
        raise GradingError(f"\"grading\" has {sorted(unknown)}; expected some of {sorted(known)}")
    usual = Grading()
    return Grading(by_hand=field(entry, "by_hand", str, usual.by_hand), empty=field(entry, "empty", float, usual.empty),
                   hidden=field(entry, "hidden", int, usual.hidden),
                   picture_credit=field(entry, "picture_credit", float, usual.picture_credit))


def _exercise(stage: str, entry: Any) -> Exercise:
    return Exercise(id=field(entry, "id", str), stage=stage, title=field(entry, "title", str),
                    file=field(entry, "file", str), function=field(entry, "function", str, ""),
                    points=field(entry, "points", float), tests=strings(entry, "tests"),
                    writes=strings(entry, "writes"), grading=_grading(field(entry, "grading", dict, {})))


@functools.cache
def exercises(stage: str, root: pathlib.Path = ROOT) -> tuple[Exercise, ...]:
    path = root / stage / "exercises.json"
    manifest = read_json(path, "a stage's manifest")
    found: list[Exercise] = []
    try:
        for entry in field(manifest, "exercises", list):
            found.append(_exercise(stage, entry))
    except GradingError as error:
        raise GradingError(f"{path}: exercise {len(found) + 1}: {error}") from error
    return tuple(found)
