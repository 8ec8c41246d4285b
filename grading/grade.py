"""`./lab grade`: grades submissions and writes a report."""

import argparse
import concurrent.futures
import hashlib
import pathlib
import shlex
import shutil
import sys
from collections.abc import Callable, Iterable
from typing import Any, TypeVar

from grading import catalogue, evaluate, intake, jail, manifest, record
from grading.errors import GradingError, UsageError
from grading.evaluate import Outcome, Verdict
from grading.exports import grades, gradescope, html, junit, prairielearn
from grading.intake import Submission
from grading.kit import Kit, is_header
from grading.manifest import Exercise
from grading.record import Json, Record

Argument = TypeVar("Argument")
Result = TypeVar("Result")


class Grader:
    """Grades submissions against one kit and keeps what it found under `out`."""

    def __init__(self, kit: Kit, out: pathlib.Path, jobs: int) -> None:
        self.kit = kit
        self.out = out
        self.unenforced = jail.unenforced()
        self._pool = concurrent.futures.ThreadPoolExecutor(jobs)

    def prepare(self) -> None:
        self.kit.prepare()
        catalogue.prepare(self.kit, self.run_all)

    def run_all(self, work: Callable[[Argument], Result], items: Iterable[Argument]) -> list[Result]:
        futures = [self._pool.submit(work, item) for item in items]
        try:
            return [future.result() for future in futures]
        except BaseException:
            # What has begun still writes to folders that the caller is about to remove.
            for future in futures:
                future.cancel()
            concurrent.futures.wait(futures)
            raise

    def record_path(self, name: str) -> pathlib.Path:
        return self.out / "records" / f"{name}.json"

    def grade(self, path: pathlib.Path, name: str) -> tuple[Record, bool]:
        """The record of a submission, and whether it had to be graded now."""
        submission = intake.take(path, [exercise.file for exercise in self.kit.graded_exercises])
        submission.name = name
        digest = submission_digest(submission, self.kit)
        kept = record.load(self.record_path(name))
        if kept is not None and kept.complete and kept.data["digest"] == digest:
            return kept, False
        graded = self._grade_now(submission, digest)
        record.save(graded, self.record_path(name))
        return graded, True

    def _grade_now(self, submission: Submission, digest: str) -> Record:
        folder = html.student_folder(self.out, submission.name)
        shutil.rmtree(folder, ignore_errors=True)
        with jail.scratch_folder() as scratch_name:
            scratch = pathlib.Path(scratch_name)
            own = write_own(submission, scratch)

            def one(exercise: Exercise) -> Json:
                return self._exercise_entry(exercise, own, scratch / exercise.id, folder / "pictures" / exercise.id)

            entries = self.run_all(one, self.kit.exercises)
            whole = check_whole(self.kit, own, scratch)
        return record.make(submission.name, digest, self.kit.stages, submission.notes, self.unenforced, entries, whole)

    def _exercise_entry(self, exercise: Exercise, own: dict[str, pathlib.Path], scratch: pathlib.Path,
                        pictures: pathlib.Path) -> Json:
        if exercise.grading.by_hand:
            return record.exercise_entry(Outcome(exercise, Verdict.BY_HAND, message=exercise.grading.by_hand), None)
        outcome, explanation = evaluate_and_explain(self.kit, exercise, own, scratch, pictures)
        return record.exercise_entry(outcome, explanation)


def evaluate_and_explain(kit: Kit, exercise: Exercise, own: dict[str, pathlib.Path], scratch: pathlib.Path,
                         pictures: pathlib.Path | None) -> tuple[Outcome, catalogue.Explanation | None]:
    """Grades one exercise in a folder of its own and compares a failing answer with the known mistakes."""
    scratch.mkdir(mode=0o711, exist_ok=True)
    scratch.chmod(0o711)
    try:
        known = catalogue.known_mistakes(kit, exercise)
    except GradingError as error:
        return Outcome(exercise, Verdict.GRADER_ERROR, None, str(error)), None
    outcome = evaluate.evaluate(kit, exercise, own, scratch, catalogue.results_by_scene(known), pictures)
    return outcome, catalogue.explain(outcome, known)


def write_own(submission: Submission, scratch: pathlib.Path) -> dict[str, pathlib.Path]:
    """The taken files as files of ours, which jails mount."""
    own: dict[str, pathlib.Path] = {}
    for i, (name, content) in enumerate(sorted(submission.files.items())):
        own[name] = scratch / f"own{i}"
        own[name].write_bytes(content)
        own[name].chmod(0o644)
    return own


def check_whole(kit: Kit, own: dict[str, pathlib.Path], scratch: pathlib.Path) -> Json:
    """Whether all files of a submission link into one program, stage by stage. Reported, not scored."""
    for stage in kit.stages:
        objects: list[pathlib.Path] = []
        replaced: set[str] = set()
        for exercise in kit.graded_exercises:
            if exercise.stage != stage or exercise.file not in own or exercise.file in replaced:
                continue
            built = sorted((scratch / exercise.id).glob("*.o"))
            units = kit.units(exercise)
            if len(built) != len(units) or any(path.stat().st_size == 0 for path in built):
                return {"verdict": "compile error", "message": f"{exercise.file} does not compile"}
            if is_header(exercise.file):
                continue  # two headers may be compiled into one source; each was checked alone
            objects += built
            replaced |= {unit.source for unit in units}
        ended = evaluate.link(kit, stage, objects, replaced, scratch / "whole")
        if ended.status != 0:
            return {"verdict": "does not link", "message": ended.printed[:8000]}
    return {"verdict": "right", "message": ""}


def submission_digest(submission: Submission, kit: Kit) -> str:
    digest = hashlib.sha256(kit.digest.encode())
    for name, content in sorted(submission.files.items()):
        digest.update(f"\0{name}\0{len(content)}\0".encode() + content)
    digest.update("\0".join(submission.notes).encode())
    return digest.hexdigest()


def name_submissions(paths: list[pathlib.Path], given: str | None = None) -> list[tuple[pathlib.Path, str]]:
    """Every submission with a name of its own, in the order of the names, or with the name that is given."""
    named: list[tuple[pathlib.Path, str]] = []
    taken: set[str] = set()
    for path in sorted(set(paths)):
        if not path.exists() and not path.is_symlink():
            raise UsageError(f"{path}: no such submission")
        name = base = given or intake.submission_name(path)
        count = 2
        while name in taken:
            name, count = f"{base}_{count}", count + 1
        taken.add(name)
        named.append((path, name))
    return named


def publish_student(out: pathlib.Path, graded: Record) -> None:
    folder = html.student_folder(out, graded.name)
    record.write_text(folder / "index.html", html.student(graded))
    record.write_text(folder / "results.json", gradescope.export(graded))
    record.write_text(folder / "prairielearn.json", prairielearn.export(graded))


def publish_class(out: pathlib.Path, records: list[Record]) -> None:
    record.write_text(out / "grades.csv", grades.export(records))
    record.write_text(out / "junit.xml", junit.export(records))
    record.write_text(out / "index.html", html.class_page(records))


def parse_shard(text: str) -> tuple[int, int]:
    try:
        index, count = (int(part) for part in text.split("/"))
    except ValueError:
        index = count = 0
    if not 1 <= index <= count:
        raise UsageError(f"--shard {text}: expected I/N with 1 ≤ I ≤ N, as in 2/8")
    return index, count


def write_jobs(out: pathlib.Path, named: list[tuple[pathlib.Path, str]], options: argparse.Namespace) -> None:
    """jobs.tsv: a line per submission with the command that grades it alone, for GNU parallel or a cluster. What is
    of the whole class the command without --name makes, once they are done."""
    lines = []
    for path, name in named:
        command = ["./lab", "grade", "--kit", options.kit, "--out", str(out), "--jobs", "1", "--secret",
                   options.secret, "--name", name, str(path)]
        lines.append(f"{name}\t{path}\t{shlex.join(command)}\n")
    record.write_text(out / "jobs.tsv", "".join(lines))


def options_of(arguments: list[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="./lab grade", description="Grades submissions: folders, zip or tar files with the exercise files.")
    parser.add_argument("submissions", nargs="+", type=pathlib.Path, metavar="SUBMISSION")
    parser.add_argument("--kit", required=True, metavar="STAGES", help="which stages to grade: 02 or 02,03")
    parser.add_argument("--out", required=True, type=pathlib.Path, metavar="DIR", help="folder for the report")
    parser.add_argument("--jobs", type=int, default=2, metavar="N", help="how many jails at once (default 2)")
    parser.add_argument("--shard", metavar="I/N", help="grade only the I-th of N parts of the submissions")
    parser.add_argument("--list", action="store_true", help="grade nothing: write jobs.tsv, a command per submission")
    parser.add_argument("--name", help="what the only submission given is called, as in jobs.tsv; leaves the class's files alone")
    parser.add_argument("--secret", default="rasterlab", metavar="TEXT",
                        help="what the hidden scenes are made from; keep it to yourself, and the same for a class")
    parser.add_argument("-q", "--quiet", action="store_true", help="print nothing but errors")
    options = parser.parse_args(arguments)
    if options.jobs < 1:
        raise UsageError(f"--jobs {options.jobs}: expected at least 1")
    if options.name and (len(options.submissions) != 1 or options.shard):
        raise UsageError(f"--name {options.name}: expected one submission, and no --shard")
    if options.name and intake.safe_name(options.name) != options.name:
        raise UsageError(f"--name {options.name}: expected letters, digits and -_.@+ with no dot in front")
    return options


def _progress(options: argparse.Namespace, done: int, total: int, text: str, end: bool) -> None:
    if not options.quiet and sys.stderr.isatty():
        print(f"\r\033[K{done}/{total} {text}", end="\n" if end else "", file=sys.stderr, flush=True)


def main(arguments: list[str]) -> int:
    options = options_of(arguments)
    kit = Kit(manifest.find_stages(options.kit), options.secret)
    named = name_submissions(options.submissions, options.name)
    chosen = named
    if options.shard:
        index, count = parse_shard(options.shard)
        chosen = named[index - 1:: count]
    if not options.name:
        write_jobs(options.out, named, options)
    if options.list:
        return 0
    grader = Grader(kit, options.out, options.jobs)
    _progress(options, 0, len(chosen), "building the reference and the known mistakes", False)
    grader.prepare()
    failed = 0
    for done, (path, name) in enumerate(chosen, 1):
        _progress(options, done - 1, len(chosen), name, False)
        graded, now = grader.grade(path, name)
        publish_student(options.out, graded)
        failed += not graded.complete
        if not options.quiet:
            points = f"{graded.score:g} of {graded.max_score:g}" if graded.score is not None else "grader error"
            print(f"{name}\t{points}{'' if now else chr(9) + 'unchanged'}", flush=True)
    if not options.name:
        _publish(options.out, grader, named)
    _progress(options, len(chosen), len(chosen), "graded", True)
    if failed:
        raise GradingError(f"{failed} submissions are not fully graded; see {options.out / 'index.html'}")
    return 0


def _publish(out: pathlib.Path, grader: Grader, named: list[tuple[pathlib.Path, str]]) -> None:
    """The class's files, from all records there are: those of other shards too."""
    records: list[Any] = [record.load(grader.record_path(name)) for _, name in named]
    publish_class(out, [entry for entry in records if entry is not None])
