"""`./lab handout`: makes a starter tree, and proves it before it is handed out."""

import argparse
import dataclasses
import fcntl
import fnmatch
import json
import os
import pathlib
import posixpath
import re
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ET

from grading import archive, evaluate, jail, manifest, markers
from grading.errors import GradingError, UsageError
from grading.kit import Kit
from grading.manifest import ROOT, Exercise

# Whole files and folders that students never get: the teachers', and the checks this repository makes of itself.
TEACHERS = ("grading/", "tests/grading/", "tests/house/", "tests/stress/", "tests/fuzz/", "docs/teaching.md",
            "docs/grading-safety.md", "docs/stress.md", ".ci/", ".github/")

# Where starters are built to prove them.
PROOFS = ROOT / "build" / "handout"

# A line of a solution that says something: shorter ones, as `}` or `return line;`, stand everywhere.
TELLING_LENGTH = 24

# The presets that only the grader uses; JSON has no comments for markers to stand in.
TEACHERS_PRESETS = ("judging", "grade")

# What links to another file in Markdown: [text](path) and <img src="path">.
_LINK = re.compile(r'\]\(([^)#\s]+)|(?:src|href)="([^"#]+)"')


@dataclasses.dataclass
class Starter:
    """A starter tree in memory."""

    files: dict[str, bytes]
    executable: set[str]
    removed: dict[str, list[list[str]]]  # file to the blocks that were left out of it


def project_files() -> list[str]:
    """The files that version control knows: what else lies about in this tree is nobody else's business."""
    done = subprocess.run(["git", "ls-files", "-z", "--cached"], cwd=ROOT, capture_output=True, check=False)
    if done.returncode != 0:
        raise GradingError("expected a git clone of RasterLab: the hand-out is made of the files git knows")
    names = done.stdout.decode().split("\0")
    return sorted(name for name in names if name and (ROOT / name).is_file())


def is_handed_out(name: str, last_stage: int) -> bool:
    return not name.startswith(TEACHERS) and manifest.path_stage(name) <= last_stage


def make_starter(stages: list[str]) -> Starter:
    """The tree with the given stages as starters, earlier ones solved and later ones absent."""
    chosen = {manifest.stage_number(stage) for stage in stages}
    starter = Starter({}, set(), {})
    for name in project_files():
        path = ROOT / name
        if not is_handed_out(name, max(chosen)):
            continue
        content = path.read_bytes()
        if markers.is_marked(pathlib.PurePath(name)):
            stripped = markers.strip(content.decode(), manifest.path_stage(name) in chosen, name)
            content = stripped.text.encode()
            if stripped.removed:
                starter.removed[name] = stripped.removed
        starter.files[name] = without_teachers_presets(content) if name == "CMakePresets.json" else content
        if os.access(path, os.X_OK):
            starter.executable.add(name)
    _drop_dead_links(starter)
    return starter


def without_teachers_presets(content: bytes) -> bytes:
    presets = json.loads(content)
    for key, entries in presets.items():
        if isinstance(entries, list):
            presets[key] = [entry for entry in entries if entry["name"] not in TEACHERS_PRESETS]
    return (json.dumps(presets, indent=2) + "\n").encode()


def _drop_dead_links(starter: Starter) -> None:
    """Leaves out the lines of Markdown that link to what was left out: later stages in lists and tables."""
    there = {str(parent) for name in starter.files for parent in (pathlib.PurePosixPath(name), *pathlib.PurePosixPath(name).parents)}
    for name in starter.files:
        if not name.endswith(".md"):
            continue
        lines = starter.files[name].decode().splitlines(keepends=True)
        starter.files[name] = "".join(
            line for line in lines
            if all("://" in link or _target(name, link) in there
                   for found in _LINK.findall(line) for link in found if link)).encode()


def _target(document: str, link: str) -> str:
    return posixpath.normpath(posixpath.join(posixpath.dirname(document), link))


def write_starter(starter: Starter, out: pathlib.Path) -> None:
    for name, content in starter.files.items():
        path = out / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)
        path.chmod(0o755 if name in starter.executable else 0o644)
    (out / archive.CHECKSUMS).write_text(archive.checksums(out))


# --- what is proved -----------------------------------------------------------------------------


def check_markers(starter: Starter, exercises: list[Exercise]) -> None:
    """Every exercise has a starter in its file."""
    for exercise in exercises:
        text = starter.files.get(exercise.file, b"").decode()
        if not exercise.grading.by_hand and f'NotWritten("{exercise.id}"' not in text:
            raise GradingError(f"{exercise.file}: expected a <solution> with the starter "
                               f"throw NotWritten(\"{exercise.id}\", …)")


def leaks(starter: Starter) -> list[str]:
    """Lines of a removed solution that stand anywhere in the starter."""
    lines: dict[str, str] = {}
    for name, content in starter.files.items():
        if pathlib.PurePath(name).suffix in (".cpp", ".h", ".inl", ".md", ".txt", ".json", ".py"):
            for line in content.decode("utf-8", "replace").splitlines():
                lines.setdefault(_bare(line), name)
    idioms = {_bare(line) for line in (ROOT / "grading" / "idioms.txt").read_text().splitlines()}
    found = []
    for name, blocks in starter.removed.items():
        for line in (line for block in blocks for line in block):
            if _is_telling(line) and _bare(line) not in idioms and (place := lines.get(_bare(line))):
                found.append(f"{place}: holds a line of the solution in {name}: {line.strip()}")
    return found


def _bare(line: str) -> str:
    return re.sub(r"\s+", "", line.split("//")[0])


def _is_telling(line: str) -> bool:
    """Whether a line could give an answer away: long enough, and neither a comment, an include, a loop's head nor
    a variable without a value, which the contracts and the code around show anyway."""
    says_nothing = re.match(r"#include|//|for \(|[\w:<>, ]+;$", line.strip())
    return not says_nothing and len(_bare(line)) >= TELLING_LENGTH


def check_leaks(starter: Starter, kit: Kit) -> None:
    if found := leaks(starter):
        raise GradingError("the starter would give answers away:\n" + "\n".join(found[:20]))
    hidden = [str(scene.number).encode() for exercise in kit.graded_exercises for scene in kit.scenes(exercise)
              if scene.hidden]
    for name, content in starter.files.items():
        if any(number in content for number in hidden):
            raise GradingError(f"{name}: holds the number of a hidden scene")
        if b"<solution>" in content or b"<teacher>" in content:
            raise GradingError(f"{name}: holds a marker")
    if (b"./lab grade" in starter.files.get("lab", b"")) or any(n.startswith("grading/") for n in starter.files):
        raise GradingError("the grader is in the starter")
    if any(".git" in pathlib.PurePath(name).parts for name in starter.files):
        raise GradingError("a history is in the starter")


def prove_build(out: pathlib.Path, stages: list[str], exercises: list[Exercise], jobs: int, quick: bool) -> str:
    """Builds a copy of the starter, runs its stages and tests, and says what was seen. A quick proof does so for the
    chosen stages alone and for one instruction set. The copy is kept, so that the next proof builds only what has
    changed."""
    numbers = "|".join(stage[:2] for stage in stages)
    settings = ["-DRASTERLAB_SIMD_TARGETS=scalar"] if quick else []
    targets = ["--target", *stages, *(f"stage{stage[:2]}_tests" for stage in stages)] if quick else []
    labels = ["-L", f"^stage({numbers})$"] if quick else ["-LE", "^(stress|fuzz)$"]
    copy = PROOFS / "_".join(stage[:2] for stage in stages)
    copy.mkdir(parents=True, exist_ok=True)
    with open(copy.with_suffix(".lock"), "w", encoding="utf-8") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        mirror(out, copy)
        _tool(["cmake", "--preset", "release", *settings], copy, "configuring the starter")
        _tool(["cmake", "--build", "--preset", "release", "-j", str(jobs), *targets], copy, "building the starter")
        said = "".join(_tool([f"build/release/bin/{stage}", "--out", f"out/{stage}"], copy,
                             f"running the starter of {stage}") for stage in stages)
        check_stages(said, exercises)
        results = _run_tests(copy, labels, jobs)
    return check_tests(results, exercises)


def mirror(source: pathlib.Path, copy: pathlib.Path) -> None:
    """Makes `copy` hold the same files, but for its build folder; what is the same already is not touched."""
    names = {path.relative_to(source) for path in source.rglob("*") if path.is_file()}
    for path in [p for p in copy.rglob("*") if p.is_file() and "build" != p.relative_to(copy).parts[0]]:
        if path.relative_to(copy) not in names:
            path.unlink()
    for name in names:
        if not (copy / name).exists() or (copy / name).read_bytes() != (source / name).read_bytes():
            (copy / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(source / name, copy / name)


def check_stages(said: str, exercises: list[Exercise]) -> None:
    """A starter's stages run to the end and say what is missing."""
    silent = [exercise.id for exercise in exercises
              if not re.search(rf"^{re.escape(exercise.id)}: .*not written yet$", said, re.MULTILINE)]
    if silent:
        raise GradingError(f"the starter's stages do not say \"not written yet\" of {', '.join(silent)}; they say:\n{said}")


def _tool(command: list[str], folder: pathlib.Path, what: str) -> str:
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise GradingError(f"{what} failed:\n{(done.stdout + done.stderr)[-4000:]}")
    return done.stdout + done.stderr


def _run_tests(folder: pathlib.Path, labels: list[str], jobs: int) -> dict[str, tuple[str, str]]:
    """Test name to its status ("run", "fail", …) and what it printed."""
    report = folder / "tests.xml"
    subprocess.run(["ctest", "--test-dir", "build/release", *labels, "-j", str(jobs),
                    "--output-junit", str(report)], cwd=folder, capture_output=True, check=False)
    if not report.exists():
        raise GradingError("the starter's tests did not run")
    return {case.get("name", ""): (case.get("status", ""), "".join(case.itertext()))
            for case in ET.parse(report).getroot().iter("testcase")}


def check_tests(results: dict[str, tuple[str, str]], exercises: list[Exercise]) -> str:
    """In a starter the tests of its exercises say "not written yet" and nothing else fails."""
    patterns = [(exercise, pattern) for exercise in exercises for pattern in exercise.tests]
    seen: dict[str, int] = {exercise.id: 0 for exercise in exercises}
    wrong = []
    for name, (status, output) in results.items():
        owners = [exercise for exercise, pattern in patterns if fnmatch.fnmatchcase(name, pattern)]
        unwritten = "not written yet" in output
        if status == "fail" and not unwritten:
            wrong.append(f"{name} fails otherwise than with \"not written yet\":\n{output[-600:]}")
        for exercise in owners if unwritten else []:
            seen[exercise.id] += 1
    wrong += [f"no test of {exercise.id} says \"not written yet\"" for exercise in exercises
              if not seen[exercise.id] and exercise.tests and not exercise.grading.by_hand]
    if wrong:
        raise GradingError(f"{len(wrong)} tests of the starter are not as they should be:\n" + "\n".join(wrong[:10]))
    failing = sum(status == "fail" for status, _ in results.values())
    return f"{len(results)} tests: {failing} say \"not written yet\", {len(results) - failing} pass or are left out"


def check_scores(out: pathlib.Path, kit: Kit) -> str:
    """Grades the starter as if it were handed in: every exercise gets what the manifest says of an empty one."""
    kit.prepare()
    for exercise in kit.graded_exercises:
        with jail.scratch_folder() as folder:
            own = pathlib.Path(folder, "own")
            own.write_bytes((out / exercise.file).read_bytes())
            own.chmod(0o644)
            outcome = evaluate.evaluate(kit, exercise, {exercise.file: own}, pathlib.Path(folder), {}, None)
        if outcome.score != exercise.grading.empty:
            raise GradingError(f"the starter of {exercise.id} scores {outcome.score}, expected "
                               f"{exercise.grading.empty}: {outcome.verdict.value}, {outcome.message}")
    return f"{len(kit.graded_exercises)} exercises score what an empty answer scores"


# --- the command --------------------------------------------------------------------------------


def options_of(arguments: list[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="./lab handout",
        description="Makes a starter tree: earlier stages solved, the chosen ones to be written, later ones absent. "
                    "Builds and tests it before it says it is there.")
    parser.add_argument("--stage", required=True, metavar="NN[,NN…]", help="the stages to be written")
    parser.add_argument("--out", required=True, type=pathlib.Path, metavar="DIR", help="folder to make, not there yet")
    parser.add_argument("--archive", type=pathlib.Path, metavar="FILE.tar.gz", help="also pack it: same bytes each time")
    parser.add_argument("--jobs", type=int, default=2, metavar="N", help="how many compilers at once (default 2)")
    parser.add_argument("--quick", action="store_true",
                        help="build and test the chosen stages only, and for one instruction set")
    parser.add_argument("--secret", default="rasterlab", metavar="TEXT", help="that of ./lab grade")
    parser.add_argument("-q", "--quiet", action="store_true", help="print nothing but errors")
    return parser.parse_args(arguments)


def main(arguments: list[str]) -> int:
    options = options_of(arguments)
    stages = manifest.find_stages(options.stage)
    out: pathlib.Path = options.out
    if out.exists() and any(out.iterdir()):
        raise UsageError(f"--out {out}: expected a folder that is not there yet or is empty")
    if options.archive and not options.archive.name.endswith(".tar.gz"):
        raise UsageError(f"--archive {options.archive}: expected a name that ends in .tar.gz")

    def say(text: str) -> None:
        if not options.quiet:
            print(text, flush=True)

    kit = Kit(stages, options.secret)
    starter = make_starter(stages)
    check_markers(starter, kit.exercises)
    check_leaks(starter, kit)
    unproved = pathlib.Path(tempfile.mkdtemp(prefix=f".{out.name}-", dir=out.resolve().parent))
    try:
        write_starter(starter, unproved)
        say(f"{len(starter.files)} files, no line of {sum(map(len, starter.removed.values()))} removed blocks")
        say(prove_build(unproved, stages, kit.graded_exercises, options.jobs, options.quick))
        say(check_scores(unproved, kit))
        unproved.chmod(0o755)
        if out.exists():
            out.rmdir()
        unproved.rename(out)
    except BaseException:
        shutil.rmtree(unproved, ignore_errors=True)
        raise
    say(f"wrote {out}")
    if options.archive:
        temporary = options.archive.with_name(f".{options.archive.name}.tmp")
        temporary.write_bytes(archive.tar_gz(out, "rasterlab"))
        temporary.rename(options.archive)
        say(f"wrote {options.archive}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
