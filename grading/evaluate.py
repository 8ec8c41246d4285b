"""Grades one exercise of one submission: compile, link, run each scene, judge.

The student's file is compiled in a jail that holds headers only, linked in a second one with the reference's
other answers, and run in a third, one per scene. The judge sees only the file that run left behind.
"""

import dataclasses
import enum
import json
import pathlib
import shlex
import signal
import subprocess
from typing import Any

from grading import jail
from grading.errors import GradingError
from grading.kit import Kit, Scene, Unit, archive_name, probe_objects
from grading.manifest import ROOT, Exercise


class Verdict(str, enum.Enum):
    RIGHT = "right"
    WRONG = "wrong"
    COMPILE_ERROR = "compile error"
    CRASH = "crash"
    TIME = "time"
    MEMORY = "memory"
    NO_OUTPUT = "no output"
    GRADER_ERROR = "grader error"
    BY_HAND = "by hand"  # no machine grades this exercise


@dataclasses.dataclass
class SceneOutcome:
    scene: Scene
    verdict: Verdict
    score: float = 0.0  # 0…1
    message: str = ""
    records: list[dict[str, Any]] = dataclasses.field(default_factory=list)
    likeness: dict[str, float] = dataclasses.field(default_factory=dict)
    result: pathlib.Path | None = None  # what the program wrote
    printed: str = ""


@dataclasses.dataclass
class Outcome:
    exercise: Exercise
    verdict: Verdict
    score: float | None = 0.0  # points; None where the grader failed
    message: str = ""
    compiler: str = ""  # what the compiler said, in words
    scenes: list[SceneOutcome] = dataclasses.field(default_factory=list)


@dataclasses.dataclass
class Built:
    program: pathlib.Path | None
    verdict: Verdict = Verdict.RIGHT
    message: str = ""
    printed: str = ""
    objects: list[pathlib.Path] = dataclasses.field(default_factory=list)


def empty_file(path: pathlib.Path) -> pathlib.Path:
    path.write_bytes(b"")
    path.chmod(0o666)
    return path


def _tool_verdict(ended: jail.Ended, what: str) -> Built:
    reason = {jail.Stopped.TIME: f"{what} took longer than {jail.COMPILE.cpu_seconds} s and was stopped",
              jail.Stopped.OUTPUT: f"{what} printed more than 1 MiB and was stopped"}.get(ended.stopped)
    return Built(None, Verdict.COMPILE_ERROR, reason or f"{what} failed", ended.printed[:20000])


def compile_unit(kit: Kit, unit: Unit, own: dict[str, pathlib.Path], output: pathlib.Path) -> jail.Ended:
    """Compiles one source file in a jail that holds headers without answers and the student's own file."""
    mounts = {"/src": kit.include, "/precompiled": kit.folder / "precompiled"}
    for name in {unit.source, *unit.headers}:
        mounts[f"/src/{name}"] = own.get(name, ROOT / name)
    flags = shlex.join(kit.compile_flags)
    script = (f"c++ {flags} -fdiagnostics-color=never -include /precompiled/headers.hxx -I/src "
              f"-c /src/{unit.source} -o /tmp/o && cat /tmp/o >/out")
    return jail.run(["/bin/sh", "-c", script], mounts, jail.COMPILE, empty_file(output))


def link(kit: Kit, stage: str, objects: list[pathlib.Path], replaced: set[str],
         output: pathlib.Path) -> jail.Ended:
    """Links a probe with objects of a student and the reference's answers to all other exercises."""
    mounts = {f"/own/{i}.o": path for i, path in enumerate(objects)}
    for source, path in probe_objects(stage).items():
        if source not in replaced:
            mounts[f"/kit/{pathlib.PurePath(source).stem}.o"] = path
    archives = ["given"]
    for source in kit.library_sources:
        if source not in replaced and (kit.folder / f"archives/{archive_name(source)}.a").exists():
            archives.append(archive_name(source))
    mounts |= {f"/kit/{name}.a": kit.folder / f"archives/{name}.a" for name in archives}
    objects_inside = [path for path in mounts if path.endswith(".o")]
    inside = [path for path in mounts if path.endswith(".a")]
    script = " ".join(["c++ -o /tmp/program", *objects_inside, "-Wl,--start-group", *inside, "-Wl,--end-group",
                       *kit.libraries, "&& cat /tmp/program >/out"])
    return jail.run(["/bin/sh", "-c", script], mounts, jail.LINK, empty_file(output))


def build(kit: Kit, exercise: Exercise, own: dict[str, pathlib.Path], folder: pathlib.Path) -> Built:
    """The program that runs this exercise with the student's file among reference answers."""
    objects: list[pathlib.Path] = []
    printed = ""
    units = kit.units(exercise)
    for i, unit in enumerate(units):
        objects.append(folder / f"{i}.o")
        ended = compile_unit(kit, unit, own, objects[-1])
        if ended.status != 0 or ended.stopped is not jail.Stopped.NO:
            return _tool_verdict(ended, "Compiling")
        printed += ended.printed
    program = folder / "program"
    ended = link(kit, exercise.stage, objects, {unit.source for unit in units} | {exercise.file}, program)
    if ended.status != 0 or ended.stopped is not jail.Stopped.NO:
        return _tool_verdict(ended, "Linking")
    program.chmod(0o755)
    return Built(program, printed=printed[:20000], objects=objects)


def run_scene(program: pathlib.Path, exercise: Exercise, scene: Scene, result: pathlib.Path) -> SceneOutcome:
    """Runs the program on one scene in a jail of its own; what it left is not yet judged."""
    ended = jail.run(["/program", exercise.id, str(scene.number), "/out"], {"/program": program}, jail.RUN,
                     empty_file(result))
    outcome = SceneOutcome(scene, Verdict.WRONG, result=result, printed=ended.printed[:4000])
    if ended.stopped is jail.Stopped.TIME:
        outcome.verdict = Verdict.TIME
        outcome.message = f"Stopped after {jail.RUN.cpu_seconds} s of computing or {jail.RUN.wall_seconds} s in all."
    elif ended.stopped is jail.Stopped.OUTPUT:
        outcome.verdict = Verdict.CRASH
        outcome.message = "Stopped: it printed more than 1 MiB."
    elif ended.status == 3:
        outcome.verdict = Verdict.MEMORY
        outcome.message = f"It asked for more than {jail.RUN.memory // jail.MIB} MiB of memory."
    elif ended.status != 0:
        outcome.verdict = Verdict.CRASH
        outcome.message = f"The program ended with {_status_text(ended.status)}."
    elif result.stat().st_size == 0:
        outcome.verdict = Verdict.NO_OUTPUT
        outcome.message = "The program ended without a result."
    if outcome.verdict is not Verdict.WRONG:
        empty_file(result)
    return outcome


def _status_text(status: int) -> str:
    if status > 128:
        try:
            return f"signal {signal.Signals(status - 128).name}"
        except ValueError:
            pass
    return f"status {status}"


def judge(kit: Kit, exercise: Exercise, outcome: SceneOutcome, mistakes: dict[str, pathlib.Path],
          pictures: pathlib.Path | None) -> None:
    """Compares a scene's result with the reference's, outside all jails."""
    assert outcome.result is not None
    judged = outcome.verdict is Verdict.WRONG
    command = [str(kit.judge), "--expected", str(kit.expected(exercise, outcome.scene)),
               "--actual", str(outcome.result)]
    if pictures is not None and judged:
        pictures.mkdir(parents=True, exist_ok=True)
        command += ["--pictures", str(pictures)]
    for name, path in mistakes.items():
        command += ["--mistake", f"{name}={path}"]
    done = subprocess.run(command, capture_output=True, text=True, timeout=120, check=False)
    if done.returncode != 0:
        raise GradingError(f"the judge failed on {exercise.id}, scene {outcome.scene.number}: {done.stderr}")
    report = json.loads(done.stdout)
    outcome.likeness = report.get("likeness", {})
    if not judged:
        return
    outcome.records = report["records"]
    if report["malformed"]:
        outcome.message = f"What the program wrote cannot be read: {report['malformed']}"
        outcome.records = []
    elif "exception" in report:
        outcome.message = f"It throws: {report['exception']}"
        outcome.records = [record for record in outcome.records if record["right"]]
    elif report["right"]:
        outcome.verdict = Verdict.RIGHT
        outcome.score = 1.0
    else:
        outcome.score = exercise.grading.picture_credit * report["score"]
        wrong = [record for record in outcome.records if not record["right"]]
        outcome.message = f"{wrong[0]['name']}: {wrong[0]['message']}" if wrong else "There are results too many."


def combine(exercise: Exercise, scenes: list[SceneOutcome]) -> tuple[Verdict, float]:
    """An exercise's verdict is that of its first scene that is not right; its points are shared evenly."""
    if not scenes:
        raise GradingError(f"{exercise.id} has no scene")
    share = sum(scene.score for scene in scenes) / len(scenes)
    verdict = next((scene.verdict for scene in scenes if scene.verdict is not Verdict.RIGHT), Verdict.RIGHT)
    points = exercise.points if verdict is Verdict.RIGHT else min(round(exercise.points * share, 2),
                                                                  exercise.points - 0.01)
    return verdict, max(points, 0.0)


def evaluate(kit: Kit, exercise: Exercise, own: dict[str, pathlib.Path], folder: pathlib.Path,
             mistakes: dict[int, dict[str, pathlib.Path]], pictures: pathlib.Path | None) -> Outcome:
    """Grades one exercise. `own` maps exercise files to what stands in for them; `mistakes` holds, by scene
    number, what known wrong answers computed; `pictures` gets those of the public scenes."""
    if exercise.file not in own:
        return Outcome(exercise, Verdict.NO_OUTPUT, message=f"The submission has no {exercise.file}.")
    own = {exercise.file: own[exercise.file]}  # graded alone
    try:
        built = build(kit, exercise, own, folder)
        if built.program is None:
            return Outcome(exercise, built.verdict, message=built.message + ".", compiler=built.printed)
        scenes: list[SceneOutcome] = []
        for scene in kit.scenes(exercise):
            if sum(s.verdict is Verdict.TIME for s in scenes) == 2:
                # An endless loop costs the time of two scenes, not of all.
                scenes.append(SceneOutcome(scene, Verdict.TIME, message="Not run: two scenes took too long."))
                continue
            outcome = run_scene(built.program, exercise, scene, folder / f"{scene.number}.result")
            judge(kit, exercise, outcome, mistakes.get(scene.number, {}),
                  pictures / str(scene.number) if pictures and not scene.hidden else None)
            scenes.append(outcome)
        verdict, score = combine(exercise, scenes)
    except (GradingError, OSError, subprocess.SubprocessError, ValueError, KeyError) as error:
        return Outcome(exercise, Verdict.GRADER_ERROR, None, message=str(error))
    failed = next((s for s in scenes if s.verdict is not Verdict.RIGHT), None)
    return Outcome(exercise, verdict, score, failed.message if failed else "", built.printed, scenes)
