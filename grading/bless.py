"""`./lab bless ID`: the only way a reference picture changes.

Makes the pictures of an exercise anew by their recipes, shows before, after and difference, and refuses a
tolerance under which a wrong picture would pass: an empty one, a known mistake's, another exercise's.
"""

import argparse
import dataclasses
import os
import pathlib
import shlex
import shutil
import subprocess
import sys
import tempfile

from grading import catalogue, manifest, markers
from grading.errors import GradingError, UsageError
from grading.fields import field, read_json
from grading.manifest import ROOT, Exercise
from grading.ninja import CompiledObject, compiled_objects, included_files, link_command, run_tool

# Where the stages' programs are; tests of other builds say theirs.
BUILD = pathlib.Path(os.environ.get("RASTERLAB_BUILD", ROOT / "build" / "release"))


@dataclasses.dataclass(frozen=True)
class Recipe:
    file: str
    command: str
    max_difference: float
    total_pixels: int
    why: str


@dataclasses.dataclass(frozen=True)
class WrongFile:
    """An exercise's file with a wrong answer in it."""

    what: str  # "the known mistake 01.5_step_before_plot"
    text: bytes


@dataclasses.dataclass(frozen=True)
class WrongPicture:
    what: str
    path: pathlib.Path


def find_exercise(identity: str) -> Exercise:
    for stage in manifest.STAGES:
        if (ROOT / stage).is_dir():
            for exercise in manifest.exercises(stage):
                if exercise.id == identity:
                    return exercise
    raise UsageError(f"exercise '{identity}': expected an id as 01.5 that is in a stage's exercises.json")


def read_recipes(path: pathlib.Path) -> list[Recipe]:
    """The recipe of each reference picture beside the file."""
    data = read_json(path, "the recipes of a stage's reference pictures")
    try:
        return [Recipe(field(p, "file", str), field(p, "command", str), field(p, "max_difference", float),
                       field(p, "total_pixels", int), field(p, "why", str)) for p in field(data, "pictures", list)]
    except GradingError as error:
        raise GradingError(f"{path}: {error} of each picture") from error


def recipes(exercise: Exercise) -> list[Recipe]:
    path = ROOT / exercise.stage / "expected" / "recipes.json"
    found = [recipe for recipe in read_recipes(path) if recipe.file.startswith(exercise.id + "_")]
    if not found:
        raise UsageError(f"exercise {exercise.id} has no reference picture; give it a recipe in {path}")
    return found


def make_picture(recipe: Recipe, folder: pathlib.Path, program: pathlib.Path | None = None) -> pathlib.Path | None:
    """Runs a recipe, with another program in the stage's place if given. None where no picture comes out."""
    folder.mkdir(parents=True, exist_ok=True)
    command = shlex.split(recipe.command.replace("OUT", shlex.quote(str(folder))))
    command[0] = str(program or BUILD / "bin" / command[0])
    environment = {**os.environ, "RASTERLAB_DATA": str(ROOT / "data")}
    try:
        subprocess.run(command, cwd=folder, capture_output=True, check=False, timeout=60, env=environment)
    except subprocess.TimeoutExpired:
        return None
    path = folder / recipe.file
    return path if path.exists() else None


def passes(actual: pathlib.Path, expected: pathlib.Path, max_difference: float, total_pixels: int) -> bool:
    done = subprocess.run([str(BUILD / "bin" / "imgdiff"), str(actual), str(expected), "--max-difference",
                           f"{max_difference:g}", "--total-pixels", str(total_pixels)],
                          capture_output=True, text=True, check=False)
    if done.returncode not in (0, 1):
        raise GradingError(f"imgdiff {actual} {expected}: {done.stderr.strip()}")
    return done.returncode == 0


def differs(actual: pathlib.Path, expected: pathlib.Path) -> bool:
    return not passes(actual, expected, 0, 0)


# --- pictures that must not pass ------------------------------------------------------------------


def wrong_files(exercise: Exercise) -> list[WrongFile]:
    """The starter, and the known mistakes."""
    starter = markers.strip((ROOT / exercise.file).read_text(), as_starter=True, name=exercise.file)
    return [WrongFile("the starter", starter.text.encode())] + [
        WrongFile(f"the known mistake {mistake.id}", catalogue.wrong_file(mistake, exercise))
        for mistake in catalogue.mistakes(exercise.stage) if mistake.exercise == exercise.id]


def wrong_program(exercise: Exercise, wrong: WrongFile, folder: pathlib.Path) -> pathlib.Path:
    """The stage's program with a wrong answer in it: what is made of the exercise's file is compiled anew with a
    folder that holds the wrong one before all others, and linked first. The engine draws no exercise and stays."""
    own = folder / "own" / exercise.file
    own.parent.mkdir(parents=True)
    own.write_bytes(wrong.text)
    link = link_command(BUILD, exercise.stage)
    included = included_files(BUILD)
    for compiled in compiled_objects(BUILD):
        concerns = exercise.file in (compiled.source, *included.get(compiled.output, ()))
        in_stage = compiled.output in link
        if not concerns or compiled.source.endswith(".simd.cpp") or not (in_stage or _is_of_library(compiled)):
            continue
        made = folder / (compiled.source.replace("/", ".") + ".o")
        run_tool(_compile_command(compiled, exercise, folder / "own", made), f"compiling {wrong.what}", BUILD)
        if in_stage:
            link[link.index(compiled.output)] = str(made)
        else:
            link.insert(link.index("-o"), str(made))  # the library's own is then not asked for
    program = folder / exercise.stage
    link[link.index("-o") + 1] = str(program)
    run_tool(link, f"linking {wrong.what}", BUILD)
    return program


def _is_of_library(compiled: CompiledObject) -> bool:
    return compiled.output.startswith("common/CMakeFiles/common.dir/")


def _compile_command(compiled: CompiledObject, exercise: Exercise, own: pathlib.Path, made: pathlib.Path) -> list[str]:
    command = [word for word in compiled.command if word != "-Werror"]
    command[command.index("-o") + 1] = str(made)
    if compiled.source == exercise.file:
        command[command.index("-c") + 1] = str(own / exercise.file)
    return [command[0], f"-I{own}", *command[1:]]


def wrong_pictures(exercise: Exercise, chosen: list[Recipe], folder: pathlib.Path) -> dict[str, list[WrongPicture]]:
    """By picture file: what the starter and each known mistake of the exercise draw."""
    found: dict[str, list[WrongPicture]] = {recipe.file: [] for recipe in chosen}
    for i, wrong in enumerate(wrong_files(exercise)):
        program = wrong_program(exercise, wrong, folder / str(i))
        for recipe in chosen:
            picture = make_picture(recipe, folder / str(i) / "out", program)
            if picture is not None:
                found[recipe.file].append(WrongPicture(wrong.what, picture))
    return found


def other_pictures(exercise: Exercise, folder: pathlib.Path, after: pathlib.Path) -> list[WrongPicture]:
    """An empty picture of the same size, and the references of that size of all other exercises."""
    empty = folder / "empty.png"
    run_tool([str(BUILD / "bin" / "imgdiff"), str(after), str(after), "--out", str(empty)], "making an empty picture")
    wrong = [WrongPicture("an empty picture", empty)]
    for stage in manifest.STAGES:
        for path in sorted((ROOT / stage / "expected").glob("*.png")):
            if not path.name.startswith(exercise.id + "_") and _png_size(path) == _png_size(after):
                wrong.append(WrongPicture(f"the picture {path.name} of another exercise", path))
    return wrong


def _png_size(path: pathlib.Path) -> bytes:
    """Width and height as they stand in the file's head."""
    with path.open("rb") as file:
        return file.read(24)[16:]


def unseen(after: pathlib.Path, wrong: list[WrongPicture]) -> list[str]:
    """Wrong answers that draw the very same picture: it does not show them."""
    return [picture.what for picture in wrong if not differs(picture.path, after)]


def refused(recipe: Recipe, after: pathlib.Path, wrong: list[WrongPicture]) -> list[str]:
    """The wrong pictures that the recipe's tolerance would let pass though they differ."""
    return [f"{recipe.file}: max_difference {recipe.max_difference:g} in {recipe.total_pixels} pixels would let "
            f"pass {picture.what}" for picture in wrong
            if passes(picture.path, after, recipe.max_difference, recipe.total_pixels) and differs(picture.path, after)]


# --- the command ----------------------------------------------------------------------------------


def show(recipe: Recipe, before: pathlib.Path, after: pathlib.Path, out: pathlib.Path) -> bool:
    """Copies before, after and difference to where one can look at them. Returns whether anything differs."""
    stem = pathlib.PurePath(recipe.file).stem
    out.mkdir(parents=True, exist_ok=True)
    shutil.copyfile(after, out / f"{stem}_after.png")
    if not before.exists():
        print(f"{recipe.file}: new\n  after       {out / f'{stem}_after.png'}")
        return True
    shutil.copyfile(before, out / f"{stem}_before.png")
    done = subprocess.run([str(BUILD / "bin" / "imgdiff"), str(after), str(before), "--out",
                           str(out / f"{stem}_difference.png")], capture_output=True, text=True, check=False)
    if done.returncode == 0:
        print(f"{recipe.file}: the same")
        return False
    print(f"{recipe.file}: {(done.stdout + done.stderr).strip()}")
    for what in ("before", "after", "difference"):
        print(f"  {what:<11} {out / f'{stem}_{what}.png'}")
    return True


def confirmed(options: argparse.Namespace) -> bool:
    if options.yes:
        return True
    if not sys.stdin.isatty():
        print("nothing was changed; look at the pictures, then run again with --yes")
        return False
    return input("make these the reference pictures? [y/N] ").strip().lower() in ("y", "yes")


def options_of(arguments: list[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="./lab bless", description="Makes an exercise's reference pictures anew, shows what changes, and refuses "
                                        "a tolerance under which a wrong picture would pass.")
    parser.add_argument("exercise", metavar="ID", help="the exercise: 02.4")
    parser.add_argument("--yes", action="store_true", help="replace the references without asking")
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "out" / "bless", metavar="DIR",
                        help="where before, after and difference go (default out/bless)")
    return parser.parse_args(arguments)


def build(stage: str) -> None:
    if not (BUILD / "build.ninja").exists():
        run_tool(["cmake", "--preset", "release", "-B", str(BUILD)], "configuring")
    run_tool(["ninja", "-C", str(BUILD), stage, "imgdiff"], f"building {stage}")


def make_pictures(chosen: list[Recipe], folder: pathlib.Path) -> dict[str, pathlib.Path]:
    pictures: dict[str, pathlib.Path] = {}
    for recipe in chosen:
        made = make_picture(recipe, folder)
        if made is None:
            raise GradingError(f"{recipe.command}: expected it to write {recipe.file}")
        pictures[recipe.file] = made
    return pictures


def check_tolerances(exercise: Exercise, chosen: list[Recipe], pictures: dict[str, pathlib.Path],
                     folder: pathlib.Path) -> None:
    """Throws where a wrong picture would pass for a reference, and says which mistakes a reference does not show."""
    wrong = wrong_pictures(exercise, chosen, folder)
    faults: list[str] = []
    for recipe in chosen:
        after = pictures[recipe.file]
        faults += refused(recipe, after, [*other_pictures(exercise, folder, after), *wrong[recipe.file]])
        for what in unseen(after, wrong[recipe.file]):
            print(f"{recipe.file}: {what} draws the same")
    if faults:
        raise GradingError("refused:\n" + "\n".join(faults))


def replace(pictures: list[pathlib.Path], expected: pathlib.Path) -> None:
    for picture in pictures:
        unfinished = expected / f".{picture.name}"
        shutil.copyfile(picture, unfinished)
        unfinished.rename(expected / picture.name)
        print(f"wrote {expected / picture.name}")


def main(arguments: list[str]) -> int:
    options = options_of(arguments)
    exercise = find_exercise(options.exercise)
    chosen = recipes(exercise)
    build(exercise.stage)
    with tempfile.TemporaryDirectory(prefix="rasterlab-bless-") as name:
        folder = pathlib.Path(name)
        pictures = make_pictures(chosen, folder / "out")
        check_tolerances(exercise, chosen, pictures, folder)
        expected = ROOT / exercise.stage / "expected"
        changed = [pictures[recipe.file] for recipe in chosen
                   if show(recipe, expected / recipe.file, pictures[recipe.file], options.out / exercise.id)]
        if changed and confirmed(options):
            replace(changed, expected)
    return 0
