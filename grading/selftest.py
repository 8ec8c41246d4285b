"""`./lab selftest`: proves the grader on answers whose verdict is known.

The reference gets full marks, right answers written differently too; a starter gets what the manifest says of
an empty answer; every known mistake loses marks in its own exercise, in no other, and is named; every attack
gets its expected verdict and harms nothing.
"""

import argparse
import dataclasses
import hashlib
import os
import pathlib
import shutil
import subprocess
import sys
import tarfile
import time
import tomllib
import zipfile
from collections.abc import Callable

from grading import catalogue, grade, handout, intake, jail, manifest, record
from grading.catalogue import Explanation
from grading.errors import GradingError, UsageError
from grading.evaluate import Outcome, Verdict
from grading.exports import html
from grading.grade import Grader
from grading.kit import Kit
from grading.manifest import ROOT, Exercise

RIGHT = ROOT / "grading" / "right"
ATTACKS = ROOT / "grading" / "attacks"

Answer = dict[str, bytes]


@dataclasses.dataclass
class Report:
    """What was seen, and every expectation that did not hold."""

    caught: int = 0
    held: int = 0
    right: int = 0
    faults: list[str] = dataclasses.field(default_factory=list)

    def expect(self, condition: bool, text: str) -> bool:
        if not condition:
            self.faults.append(text)
        return condition


class SelfTest:
    def __init__(self, kit: Kit, folder: pathlib.Path, jobs: int, say: Callable[[str], None]) -> None:
        self.kit = kit
        self.folder = folder
        self.say = say
        self.report = Report()
        self.grader = Grader(kit, folder, jobs)
        self._seen: dict[tuple[str, bytes], tuple[Outcome, Explanation | None]] = {}

    # --- answers ----------------------------------------------------------------------------------

    def reference(self) -> Answer:
        return {e.file: (ROOT / e.file).read_bytes() for e in self.kit.graded_exercises}

    def outcomes(self, answer: Answer) -> dict[str, tuple[Outcome, Explanation | None]]:
        """Grades every exercise of an answer. An exercise is graded alone, so the same file of it is graded once."""
        new = [(exercise, answer[exercise.file]) for exercise in self.kit.graded_exercises
               if exercise.file in answer and (exercise.id, answer[exercise.file]) not in self._seen]
        for (exercise, content), outcome in zip(new, self.grader.run_all(self._grade_one, new)):
            self._seen[exercise.id, content] = outcome
        return {e.id: self._seen[e.id, answer[e.file]] for e in self.kit.graded_exercises if e.file in answer}

    def _grade_one(self, work: tuple[Exercise, bytes]) -> tuple[Outcome, Explanation | None]:
        exercise, content = work
        with jail.scratch_folder() as name:
            own = pathlib.Path(name, "own")
            own.write_bytes(content)
            own.chmod(0o644)
            outcome, explanation = grade.evaluate_and_explain(self.kit, exercise, {exercise.file: own},
                                                              pathlib.Path(name), None)
        return outcome, explanation

    # --- what is expected -------------------------------------------------------------------------

    def full_marks(self, name: str, answer: Answer) -> None:
        for outcome, _ in self.outcomes(answer).values():
            if self.report.expect(outcome.score == outcome.exercise.points,
                                  f"{name}: {outcome.exercise.id} gets {outcome.score} of {outcome.exercise.points}: "
                                  f"{outcome.verdict.value}, {outcome.message} {outcome.compiler[:500]}"):
                self.report.right += 1

    def right_answers(self) -> None:
        self.full_marks("the reference", self.reference())
        for path in sorted(RIGHT.rglob("*.*")):
            file = path.relative_to(RIGHT).as_posix().split("/", 1)[1]
            if file in self.kit.answers and any(e.file == file for e in self.kit.graded_exercises):
                self.full_marks(path.relative_to(RIGHT).as_posix(), {file: path.read_bytes()})

    def starter(self) -> None:
        files = handout.make_starter(self.kit.stages).files
        answer = {e.file: files[e.file] for e in self.kit.graded_exercises}
        for outcome, explanation in self.outcomes(answer).values():
            exercise = outcome.exercise
            self.report.expect(outcome.score == exercise.grading.empty and explanation is None,
                               f"the starter: {exercise.id} gets {outcome.score}, expected {exercise.grading.empty}: "
                               f"{outcome.verdict.value}, {outcome.message} {outcome.compiler[:500]}")

    def known_mistakes(self) -> None:
        exercises = {exercise.id: exercise for exercise in self.kit.graded_exercises}
        for stage in self.kit.stages:
            for mistake in catalogue.mistakes(stage):
                if self.report.expect(mistake.exercise in exercises, f"{mistake.id}: no exercise {mistake.exercise}"):
                    self._known_mistake(mistake, exercises[mistake.exercise])

    def _known_mistake(self, mistake: catalogue.Mistake, exercise: Exercise) -> None:
        outcomes = self.outcomes({**self.reference(), exercise.file: catalogue.wrong_file(mistake, exercise)})
        others = [i for i, (outcome, _) in outcomes.items()
                  if i != exercise.id and outcome.score != outcome.exercise.points]
        outcome, explanation = outcomes[exercise.id]
        named = explanation.mistake.id if explanation else "nothing"
        loses = outcome.score is not None and outcome.score < exercise.points
        good = self.report.expect(loses and outcome.verdict is not Verdict.COMPILE_ERROR,
                                  f"{mistake.id}: {outcome.verdict.value}, {outcome.score} of {exercise.points} "
                                  f"{outcome.compiler[:500]}")
        good &= self.report.expect(not others, f"{mistake.id}: also loses marks in {others}")
        good &= self.report.expect(named == mistake.id, f"{mistake.id}: named as {named}")
        self.report.caught += good

    def examples_of_mistakes(self) -> None:
        """Wrong answers in other words than the catalogue's, which must be named all the same."""
        path = ROOT / "grading" / "mutants" / "in_other_words.toml"
        exercises = {exercise.id: exercise for exercise in self.kit.graded_exercises}
        for entry in tomllib.loads(path.read_text()).get("answer", []):
            if exercise := exercises.get(entry["exercise"]):
                outcome, explanation = self.outcomes({exercise.file: entry["text"].encode()})[exercise.id]
                named = explanation.mistake.id if explanation else "nothing"
                self.report.expect(named == entry["named"], f"in other words: {entry['named']} is named {named} "
                                   f"({outcome.verdict.value}: {outcome.message} {outcome.compiler[:500]})")

    # --- attacks ----------------------------------------------------------------------------------

    def attacks(self) -> None:
        before = self._what_must_not_change()
        entries = tomllib.loads((ATTACKS / "attacks.toml").read_text())["attack"]
        exercises = {exercise.id: exercise for exercise in self.kit.graded_exercises}
        work = [entry for entry in entries if entry["exercise"] in exercises]
        answers = [(exercises[entry["exercise"]], self._attack_text(entry["file"]).encode()) for entry in work]
        for entry, (outcome, explanation) in zip(work, self.grader.run_all(self._grade_one, answers)):
            verdict = outcome.verdict.value
            good = self.report.expect(verdict in entry["verdicts"] and outcome.score == 0,
                                      f"attack {entry['file']}: {verdict} with {outcome.score}, expected "
                                      f"{entry['verdicts']} with 0: {outcome.message} {outcome.compiler[-800:]}")
            good &= self._page_is_harmless(entry["file"], outcome, explanation)
            self.report.held += good
        for name, attack in SUBMISSION_ATTACKS.items():
            self.report.held += self.report.expect(attack(self.folder / "submission", self.kit),
                                                   f"attack on the intake: {name}")
        self.report.expect(before == self._what_must_not_change(), "an attack changed the kit or the sources")
        self.report.expect(not _processes_of_nobody(), "an attack left a process behind")

    def _attack_text(self, name: str) -> str:
        """An attack's source; @ROOT@ stands for where this tree is, @KIT@ for where the reference is."""
        return (ATTACKS / name).read_text().replace("@ROOT@", str(ROOT)).replace("@KIT@", str(self.kit.folder))

    def _page_is_harmless(self, name: str, outcome: Outcome, explanation: Explanation | None) -> bool:
        entry = record.exercise_entry(outcome, explanation)
        made = record.make(name, "", self.kit.stages, [], (), [entry], {"verdict": "right", "message": ""})
        page = html.student(made).lower()
        return self.report.expect("<script" not in page and "<img src=x" not in page,
                                  f"attack {name}: its HTML is on the page")

    def _what_must_not_change(self) -> str:
        digest = hashlib.sha256()
        for folder in (*(self.kit.folder / name for name in ("expected", "archives", "include", "bin")),
                       ROOT / "common", ROOT / "grading"):
            for path in sorted(folder.rglob("*")):
                if path.is_file() and path.suffix != ".pyc":
                    digest.update(str(path).encode() + path.read_bytes())
        return digest.hexdigest()

    def run(self, parts: list[str]) -> Report:
        start = time.monotonic()
        self.grader.prepare()
        self.say(f"the kit is ready after {time.monotonic() - start:.0f} s")
        steps = {"right": self.right_answers, "starter": self.starter, "mutants": self.known_mistakes,
                 "words": self.examples_of_mistakes, "attacks": self.attacks}
        for part in parts:
            begun = time.monotonic()
            steps[part]()
            self.say(f"{part}: {time.monotonic() - begun:.0f} s")
        return self.report


def _processes_of_nobody() -> list[str]:
    """Processes that jails have left behind, when jails run as nobody."""
    if not jail.drops_root():
        return []
    done = subprocess.run(["ps", "-u", str(jail.NOBODY), "-o", "pid=,comm="], capture_output=True, text=True, check=False)
    return [line for line in done.stdout.splitlines() if "program" in line]


# --- attacks on the intake ------------------------------------------------------------------------


def _attack_links(folder: pathlib.Path, kit: Kit) -> bool:
    """Links in place of files, to a secret and to a folder."""
    _fresh(folder)
    file = kit.graded_exercises[0].file
    (folder / file).parent.mkdir(parents=True)
    (folder / file).symlink_to("/etc/passwd")
    (folder / "elsewhere").symlink_to("/etc")
    taken = intake.take(folder, kit.answers)
    return not taken.files and "link" in " ".join(taken.notes)


def _attack_fifo(folder: pathlib.Path, kit: Kit) -> bool:
    """A FIFO, which nobody writes to."""
    _fresh(folder)
    os.mkfifo(folder / pathlib.PurePath(kit.graded_exercises[0].file).name)
    taken = intake.take(folder, kit.answers)
    return not taken.files and bool(taken.notes)


def _attack_zip(folder: pathlib.Path, kit: Kit) -> bool:
    """A zip that unpacks to a gigabyte, climbs out of its folder and replaces a contract."""
    _fresh(folder)
    file = kit.graded_exercises[0].file
    with zipfile.ZipFile(folder / "bomb.zip", "w", zipfile.ZIP_DEFLATED) as archive:
        with archive.open(file, "w", force_zip64=True) as member:
            for _ in range(1024):
                member.write(b" " * 2**20)
        archive.writestr("../../" + kit.graded_exercises[1].file, "x")
        archive.writestr("common/image/image.h", "#error")
        archive.writestr("CMakeLists.txt", "message(FATAL_ERROR)")
    taken = intake.take(folder / "bomb.zip", kit.answers)
    return not taken.files and "larger" in " ".join(taken.notes) and taken.ignored == 3


def _attack_tar(folder: pathlib.Path, kit: Kit) -> bool:
    """A tar with links, a device and an absolute path."""
    _fresh(folder)
    with tarfile.open(folder / "evil.tar", "w") as archive:
        for kind, exercise in zip((tarfile.SYMTYPE, tarfile.LNKTYPE, tarfile.CHRTYPE), kit.graded_exercises):
            info = tarfile.TarInfo(exercise.file)
            info.type, info.linkname = kind, "/etc/passwd"
            archive.addfile(info)
    taken = intake.take(folder / "evil.tar", kit.answers)
    return not taken.files and len(taken.notes) == min(3, len(kit.graded_exercises))


def _attack_broken_archive(folder: pathlib.Path, kit: Kit) -> bool:
    """A zip that is cut off."""
    _fresh(folder)
    with zipfile.ZipFile(folder / "whole.zip", "w") as archive:
        archive.writestr(kit.graded_exercises[0].file, "int x;" * 1000)
    content = (folder / "whole.zip").read_bytes()
    (folder / "cut.zip").write_bytes(content[: len(content) // 2] + content[-30:])
    return not intake.take(folder / "cut.zip", kit.answers).files


def _attack_names(folder: pathlib.Path, kit: Kit) -> bool:
    """A submission whose name climbs out of the report."""
    return intake.submission_name(pathlib.Path("/x/..evil\n<script>.zip")) == "evil__script_"


SUBMISSION_ATTACKS: dict[str, Callable[[pathlib.Path, Kit], bool]] = {
    "links": _attack_links, "a FIFO": _attack_fifo, "a zip bomb": _attack_zip, "a tar of links": _attack_tar,
    "a broken zip": _attack_broken_archive, "names": _attack_names}


def _fresh(folder: pathlib.Path) -> None:
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)


# --- the command ----------------------------------------------------------------------------------

PARTS = ("right", "starter", "mutants", "words", "attacks")


def options_of(arguments: list[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="./lab selftest", description="Grades answers whose verdict is known: the reference, other right answers, "
                                           "the starter, known mistakes, attacks.")
    parser.add_argument("--kit", default="", metavar="STAGES", help="which stages (default: all that are graded)")
    parser.add_argument("--part", action="append", choices=PARTS, help="only this part; may be given several times")
    parser.add_argument("--jobs", type=int, default=2, metavar="N", help="how many jails at once (default 2)")
    return parser.parse_args(arguments)


def graded_stages() -> list[str]:
    return [stage for stage in manifest.STAGES
            if (ROOT / f"grading/probes/stage{stage[:2]}_probe.cpp").exists() and (ROOT / stage).is_dir()
            and manifest.exercises(stage)]


def main(arguments: list[str]) -> int:
    options = options_of(arguments)
    stages = manifest.find_stages(options.kit) if options.kit else graded_stages()
    if missing := [stage for stage in stages if stage not in graded_stages()]:
        raise UsageError(f"--kit {options.kit}: {missing[0]} is not graded by a machine")
    with jail.scratch_folder() as folder:
        test = SelfTest(Kit(stages, "rasterlab"), pathlib.Path(folder), options.jobs,
                        lambda text: print(text, file=sys.stderr, flush=True) if sys.stderr.isatty() else None)
        report = test.run(options.part or list(PARTS))
    for fault in report.faults:
        print(fault)
    for limit in test.grader.unenforced:
        print(f"not enforced on this machine: {limit}")
    marked_down = sum(fault.startswith(("the reference", "stage")) for fault in report.faults)
    print(f"{report.caught} mutants caught and named, {report.held} attacks held, {report.right} answers right, "
          f"{marked_down} right answers marked down")
    if report.faults:
        raise GradingError(f"{len(report.faults)} expectations do not hold")
    return 0
