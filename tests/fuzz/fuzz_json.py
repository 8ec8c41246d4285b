#!/usr/bin/env python3
"""Fuzzes what reads manifests and recipes in Python: good files with damage done to their values or their bytes must
be read, or be refused with one line. `fuzz_json.py manifests|recipes --seconds S --seed N --out DIR`; a file that
breaks this is left in DIR and named.
"""
import argparse
import copy
import json
import pathlib
import random
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path[:0] = [str(ROOT), str(ROOT / "tools")]

import make_gallery  # noqa: E402
from grading import bless, manifest  # noqa: E402
from grading.errors import GradingError, UsageError  # noqa: E402

ODD_VALUES = (None, True, False, 0, -1, 1e308, float("nan"), float("inf"), 10**400, "", "\n", "\0", "é" * 300, [], {},
              [[]], {"": None}, "OUT", "'", "../../x")
LONGEST_FILE = 200_000


def nodes(value, path=()):
    """Where every value of a JSON document stands."""
    yield path
    children = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, child in children:
        yield from nodes(child, (*path, key))


def damage_values(document, rng):
    """Puts an odd value in a value's place, or leaves it out, or repeats it."""
    *above, last = rng.choice([path for path in nodes(document) if path])
    parent = document
    for key in above:
        parent = parent[key]
    what = rng.randrange(3)
    if what == 0:
        parent[last] = copy.deepcopy(rng.choice(ODD_VALUES))  # which may be damaged in its turn
    elif what == 1:
        del parent[last]
    elif isinstance(parent, list):
        parent.insert(last, copy.deepcopy(parent[last]))
    else:
        parent[str(last) + "x"] = copy.deepcopy(parent[last])


def damage_bytes(data, rng):
    """Changes, drops or repeats some bytes, or nests the whole deeply."""
    if rng.random() < 0.02:
        depth = rng.randrange(1, 100_000)
        return (b"[" * depth + data)[:LONGEST_FILE]
    for _ in range(rng.randrange(1, 9)):
        at = rng.randrange(len(data) + 1)
        length = rng.randrange(1, 40)
        what = rng.randrange(3)
        if what == 0:
            data = data[:at] + rng.randbytes(length) + data[at + length:]
        elif what == 1:
            data = data[:at] + data[at + length:]
        else:
            data = data[:at] + data[at:at + length] * rng.randrange(2, 5) + data[at + length:]
    return data[:LONGEST_FILE]


def small(data):
    """Good files of one entry each, which damage reaches sooner."""
    for key, entries in json.loads(data).items():
        if isinstance(entries, list):
            for entry in entries:
                yield json.dumps({key: [entry]}).encode()


def damaged(seeds, rng):
    data = rng.choice(seeds)
    if rng.random() < 0.7:
        document = json.loads(data)
        for _ in range(rng.randrange(1, 4)):
            if len(list(nodes(document))) > 1:
                damage_values(document, rng)
        data = json.dumps(document, ensure_ascii=rng.random() < 0.5).encode("utf-8", "surrogatepass")
    return damage_bytes(data, rng) if rng.random() < 0.4 else data


def require(holds, promise):
    if not holds:
        raise AssertionError(promise)


def read_manifests(path):
    """With each reader; each must do, or say what is wrong."""
    must_return(lambda: check_exercises(manifest.exercises.__wrapped__(path.parent.name, path.parent.parent)))
    must_return(lambda: make_gallery.read_manifest(path))


def check_exercises(exercises):
    for exercise in exercises:
        require(all(isinstance(text, str) for text in (exercise.id, exercise.title, exercise.file, exercise.function,
                                                       *exercise.tests, *exercise.writes)), "texts are texts")
        require(abs(exercise.points) < 2**53, "points are a number")


def read_recipes(path):
    must_return(lambda: check_recipes(bless.read_recipes(path)))


def check_recipes(recipes):
    for recipe in recipes:
        require(isinstance(recipe.command, str) and abs(recipe.max_difference) < 2**53, "a recipe is one")


def must_return(read):
    try:
        read()
    except (GradingError, UsageError, make_gallery.BadInput) as error:
        require("\n" not in str(error), f"an error is one line: {error}")


KINDS = {"manifests": (read_manifests, "[0-9][0-9]_*/exercises.json", "exercises.json"),
         "recipes": (read_recipes, "[0-9][0-9]_*/expected/recipes.json", "recipes.json")}


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("kind", choices=KINDS)
    parser.add_argument("--seconds", type=float, default=20)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--out", type=pathlib.Path, required=True)
    options = parser.parse_args()
    read, pattern, name = KINDS[options.kind]
    whole = [path.read_bytes() for path in sorted(ROOT.glob(pattern))]
    seeds = whole + [entry for data in whole for entry in small(data)]
    require(seeds, f"there are {options.kind}")
    rng = random.Random(options.seed)
    stage = options.out / options.kind / "01_lines"
    stage.mkdir(parents=True, exist_ok=True)
    path = stage / name
    count = 0
    end = time.monotonic() + options.seconds
    while time.monotonic() < end:
        path.write_bytes(damaged(seeds, rng))
        try:
            read(path)
        except Exception:
            print(f"seed {options.seed}, file {count + 1}: left in {path}", file=sys.stderr)
            raise
        count += 1
    print(f"{count} damaged {options.kind} were read or refused")


if __name__ == "__main__":
    main()
