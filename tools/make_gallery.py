#!/usr/bin/env python3
"""Makes out/index.html: one page that holds every stage's pictures, printouts and frames.

What belongs to an exercise is told by its file name, which starts with the exercise's id (01.5_bresenham.png), and
titled by the stage's exercises.json. The page is tools/gallery.html with the data in place; it needs no other file.
"""
import argparse
import base64
import json
import os
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
PICTURES = {".png": "image/png", ".jpg": "image/jpeg", ".gif": "image/gif", ".webp": "image/webp"}
LONGEST_TEXT = 20_000


class BadInput(Exception):
    """What is wrong with a file, said in one line."""


def read_manifest(path):
    try:
        exercises = json.loads(path.read_text(encoding="utf-8"))["exercises"]
        entries = [{"id": exercise["id"], "title": exercise["title"], "description": exercise.get("description", ""),
                    "writes": exercise.get("writes", []), "compare": exercise.get("compare", [])}
                   for exercise in exercises]
    except (AttributeError, ValueError, KeyError, RecursionError, TypeError) as error:
        raise BadInput(f"{path}: expected a stage's manifest, {{\"exercises\": [{{\"id\": …, \"title\": …}}]}}: "
                       f"{error!r}") from error
    for entry in entries:
        if not all(isinstance(entry[key], str) for key in ("id", "title", "description")):
            raise BadInput(f"{path}: expected strings as id, title and description of each exercise")
        if not is_list_of_strings(entry["writes"]):
            raise BadInput(f"{path}: expected a list of file names in \"writes\" of each exercise")
        if not isinstance(entry["compare"], list) or not all(is_list_of_strings(pair) for pair in entry["compare"]):
            raise BadInput(f"{path}: expected a list of lists of file names in \"compare\" of each exercise")
    return entries


def is_list_of_strings(value):
    return isinstance(value, list) and all(isinstance(item, str) for item in value)


def stage_title(folder):
    """The first heading of the lab sheet, else the folder's name."""
    sheet = folder / "README.md"
    if sheet.is_file():
        heading = re.search(r"^# +(.+)$", sheet.read_text(encoding="utf-8"), re.MULTILINE)
        if heading:
            return heading[1].strip()
    return folder.name


def caption(stem, exercise_id):
    """01.5_fixed_step of exercise 01.5 shows "fixed step"."""
    return stem.removeprefix(exercise_id).strip("_").replace("_", " ") or stem


def picture(path, exercise_id):
    data = base64.b64encode(path.read_bytes()).decode("ascii")
    return {"file": path.name, "caption": caption(path.stem, exercise_id),
            "source": f"data:{PICTURES[path.suffix]};base64,{data}"}


def split_sequences(paths):
    """Separates numbered frames (light_0000.png, light_0001.png …) from single files."""
    single, sequences = [], {}
    for path in paths:
        numbered = re.fullmatch(r"(.+)_\d{4}", path.stem)
        if numbered and path.suffix in PICTURES:
            sequences.setdefault(numbered[1], []).append(path)
        else:
            single.append(path)
    for name in [name for name, frames in sequences.items() if len(frames) == 1]:
        single += sequences.pop(name)
    return single, sequences


def collect(exercise, paths):
    """An exercise's part of the page, from its files."""
    place = {name: index for index, name in enumerate(exercise["writes"])}
    paths = sorted(paths, key=lambda path: (place.get(path.name, len(place)), path.name))
    single, sequences = split_sequences(paths)
    pictures = [path for path in single if path.suffix in PICTURES]
    texts = [path for path in single if path.suffix == ".txt"]
    written = {path.name for path in paths}
    return {
        "id": exercise["id"], "title": exercise["title"], "description": exercise["description"],
        "compare": exercise["compare"],
        "pictures": [picture(path, exercise["id"]) for path in pictures],
        "sequences": [{"caption": caption(name, exercise["id"]),
                       "frames": [picture(path, exercise["id"]) for path in frames]}
                      for name, frames in sequences.items()],
        "texts": [{"file": path.name, "text": path.read_text(encoding="utf-8", errors="replace")[:LONGEST_TEXT]}
                  for path in texts],
        "files": [path.name for path in single if path not in pictures and path not in texts],
        "missing": [name for name in exercise["writes"] if re.fullmatch(r"[\w.-]+", name) and name not in written],
    }


def belongs(path, exercise):
    """The manifest names the file, or its name starts with the id: 04.1 does not own 04.10_normals.png."""
    return path.name in exercise["writes"] or re.match(re.escape(exercise["id"]) + r"(?![0-9])", path.name) is not None


def collect_stage(folder, results):
    exercises = read_manifest(folder / "exercises.json")
    paths = sorted(path for path in results.iterdir() if path.is_file()) if results.is_dir() else []
    parts = []
    for exercise in exercises:
        parts.append(collect(exercise, [path for path in paths if belongs(path, exercise)]))
    others = [path for path in paths if not any(belongs(path, exercise) for exercise in exercises)]
    if others:
        more = {"id": "", "title": "Further pictures", "description": "", "writes": [], "compare": []}
        parts.append(collect(more, others))
    return {"name": folder.name, "title": stage_title(folder), "exercises": parts}


def write_whole(path, text):
    """The file is there as a whole or not at all."""
    path.parent.mkdir(parents=True, exist_ok=True)
    temporary = path.with_name(f".{path.name}.{os.getpid()}")
    try:
        temporary.write_text(text, encoding="utf-8")
        temporary.replace(path)
    finally:
        temporary.unlink(missing_ok=True)


def main():
    parser = argparse.ArgumentParser(description="Make one page of all that the stages drew.")
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "out" / "index.html", metavar="FILE",
                        help="the page (default out/index.html); the stages' folders are expected beside it")
    parser.add_argument("--stages", type=pathlib.Path, default=ROOT, metavar="DIR",
                        help="where the stages' exercises.json are (default: this repository)")
    parser.add_argument("-q", "--quiet", action="store_true", help="do not print the name of the file written")
    arguments = parser.parse_args()
    folders = sorted(path.parent for path in arguments.stages.glob("[0-9][0-9]_*/exercises.json"))
    if not folders:
        raise BadInput(f"{arguments.stages}: expected stage folders as 01_lines with an exercises.json")
    data = {"stages": [collect_stage(folder, arguments.out.parent / folder.name) for folder in folders]}
    template = (ROOT / "tools" / "gallery.html").read_text(encoding="utf-8")
    text = json.dumps(data, ensure_ascii=False).replace("</", "<\\/")
    write_whole(arguments.out, template.replace("GALLERY_DATA", text, 1))
    if not arguments.quiet:
        print(f"wrote {arguments.out}")


if __name__ == "__main__":
    try:
        main()
    except (BadInput, OSError) as error:
        print(f"make_gallery: {error}", file=sys.stderr)
        sys.exit(1)
