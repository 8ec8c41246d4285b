"""`./lab bless ID`: the only way a reference picture changes.

Makes the pictures of an exercise anew by their recipes, shows before, after and difference, and refuses a
tolerance under which a wrong picture would pass: an empty one, a known mistake's, another exercise's.
"""

import argparse
import dataclasses
import json
import os
import pathlib
import shlex
import shutil
import subprocess
import sys
import tempfile
from typing import Any

from grading import catalogue, manifest
from grading.errors import GradingError, UsageError
from grading.manifest import ROOT, Exercise

BUILD = ROOT / "build" / "release"


@dataclasses.dataclass(frozen=True)
class Recipe:
    file: str
    command: str
    max_difference: float
    total_pixels: int
    why: str


@dataclasses.dataclass(frozen=True)
class WrongPicture:
    what: str  # "the known mistake 01.5_step_before_plot"
    path: pathlib.Path


def find_exercise(identity: str) -> Exercise:
    for stage in manifest.STAGES:
        if (ROOT / stage).is_dir():
            for exercise in manifest.exercises(stage):
                if exercise.id == identity:
                    return exercise
    raise UsageError(f"exercise '{identity}': expected an id as 01.5 that is in a stage's exercises.json")


def recipes(exercise: Exercise) -> list[Recipe]:
    path = ROOT / exercise.stage / "expected" / "recipes.json"
    try:
        pictures: list[dict[str, Any]] = json.loads(path.read_text())["pictures"]
        found = [Recipe(p["file"], p["command"], float(p["max_difference"]), int(p["total_pixels"]), p["why"])
                 for p in pictures if p["file"].startswith(exercise.id + "_")]
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise GradingError(f"{path}: expected file, command, max_difference, total_pixels and why of each "
                           f"picture: {error}") from error
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


def mistake_program(exercise: Exercise, mistake: catalogue.Mistake, folder: pathlib.Path) -> pathlib.Path | None:
    """The stage's program with a known mistake in it; None where it is in no source file of its own."""
    if not exercise.file.endswith(".cpp"):
        return None
    entries = json.loads((BUILD / "compile_commands.json").read_text())
    command = next((shlex.split(e["command"]) for e in entries if e["file"] == str(ROOT / exercise.file)), None)
    if command is None:
        raise GradingError(f"{exercise.file} is not part of build/release")
    source = folder / pathlib.PurePath(exercise.file).name
    source.write_bytes(catalogue.wrong_file(mistake, exercise))
    command[command.index("-o") + 1] = str(folder / "wrong.o")
    command[command.index("-c") + 1] = str(source)
    _run([token for token in command if token != "-Werror"], f"compiling {mistake.id}")
    lines = subprocess.run(["ninja", "-C", str(BUILD), "-t", "commands", exercise.stage], capture_output=True,
                           text=True, check=True).stdout.strip().splitlines()
    tokens = [token for token in shlex.split(lines[-1]) if token not in (":", "&&")]
    tokens.insert(tokens.index("-o"), str(folder / "wrong.o"))
    program = folder / "stage"
    tokens[tokens.index("-o") + 1] = str(program)
    _run(tokens, f"linking {mistake.id}")
    return program


def _run(command: list[str], what: str) -> None:
    done = subprocess.run(command, cwd=BUILD, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise GradingError(f"{what} failed:\n{done.stderr[-2000:]}")


def mistake_pictures(exercise: Exercise, chosen: list[Recipe], folder: pathlib.Path) -> dict[str, list[WrongPicture]]:
    """By picture file: what each known mistake of the exercise draws."""
    found: dict[str, list[WrongPicture]] = {recipe.file: [] for recipe in chosen}
    for mistake in catalogue.mistakes(exercise.stage):
        if mistake.exercise != exercise.id:
            continue
        own = folder / mistake.id
        own.mkdir(parents=True)
        program = mistake_program(exercise, mistake, own)
        for recipe in chosen if program else []:
            picture = make_picture(recipe, own / "out", program)
            if picture is not None:
                found[recipe.file].append(WrongPicture(f"the known mistake {mistake.id}", picture))
    return found


def other_pictures(exercise: Exercise, folder: pathlib.Path, after: pathlib.Path) -> list[WrongPicture]:
    """An empty picture of the same size, and the references of all other exercises."""
    empty = folder / "empty.png"
    _run([str(BUILD / "bin" / "imgdiff"), str(after), str(after), "--out", str(empty)], "making an empty picture")
    wrong = [WrongPicture("an empty picture, which is what a starter leaves", empty)]
    for stage in manifest.STAGES:
        for path in sorted((ROOT / stage / "expected").glob("*.png")):
            if not path.name.startswith(exercise.id + "_"):
                wrong.append(WrongPicture(f"the picture {path.name} of another exercise", path))
    return wrong


def refused(recipe: Recipe, after: pathlib.Path, wrong: list[WrongPicture]) -> list[str]:
    """The wrong pictures that the recipe's tolerance would let pass though they differ."""
    return [f"{recipe.file}: max_difference {recipe.max_difference:g} in {recipe.total_pixels} pixels would let "
            f"pass {picture.what}" for picture in wrong
            if differs(picture.path, after) and passes(picture.path, after, recipe.max_difference, recipe.total_pixels)]


# --- the command ----------------------------------------------------------------------------------


def show(recipe: Recipe, after: pathlib.Path, out: pathlib.Path, stage: str) -> bool:
    """Copies before, after and difference to where one can look at them. Returns whether anything differs."""
    before = ROOT / stage / "expected" / recipe.file
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


def main(arguments: list[str]) -> int:
    options = options_of(arguments)
    exercise = find_exercise(options.exercise)
    chosen = recipes(exercise)
    with tempfile.TemporaryDirectory(prefix="rasterlab-bless-") as name:
        folder = pathlib.Path(name)
        pictures: dict[str, pathlib.Path] = {}
        for recipe in chosen:
            made = make_picture(recipe, folder / "out")
            if made is None:
                raise GradingError(f"{recipe.command}: expected it to write {recipe.file}")
            pictures[recipe.file] = made
        mistakes = mistake_pictures(exercise, chosen, folder)
        faults = [fault for recipe in chosen
                  for fault in refused(recipe, pictures[recipe.file],
                                       other_pictures(exercise, folder, pictures[recipe.file]) + mistakes[recipe.file])]
        if faults:
            raise GradingError("refused:\n" + "\n".join(faults))
        changed = [recipe for recipe in chosen
                   if show(recipe, pictures[recipe.file], options.out / exercise.id, exercise.stage)]
        if changed and confirmed(options):
            for recipe in changed:
                target = ROOT / exercise.stage / "expected" / recipe.file
                shutil.copyfile(pictures[recipe.file], target.with_name("." + target.name))
                target.with_name("." + target.name).rename(target)
                print(f"wrote {target.relative_to(ROOT)}")
    return 0
