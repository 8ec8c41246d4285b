"""What a build folder knows: how each object is compiled, what it includes, how a program is linked."""

import dataclasses
import json
import os
import pathlib
import shlex
import subprocess

from grading.errors import GradingError
from grading.manifest import ROOT


@dataclasses.dataclass(frozen=True)
class CompiledObject:
    """Paths of sources are those of the repository, of objects those below the build folder."""

    source: str
    output: str
    command: tuple[str, ...]


def run_tool(command: list[str], what: str, folder: pathlib.Path = ROOT) -> str:
    """Runs a trusted program of ours; its failure is the grader's. Returns its standard output."""
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise GradingError(f"{what} failed:\n{done.stdout}{done.stderr}"[-4000:])
    return done.stdout


def compiled_objects(build: pathlib.Path) -> list[CompiledObject]:
    """All objects made of this tree's sources."""
    found = []
    for entry in json.loads((build / "compile_commands.json").read_text()):
        if (file := pathlib.Path(entry["file"])).is_relative_to(ROOT):
            command = tuple(shlex.split(entry["command"]))
            found.append(CompiledObject(file.relative_to(ROOT).as_posix(), command[command.index("-o") + 1], command))
    return found


def included_files(build: pathlib.Path) -> dict[str, frozenset[str]]:
    """Object to the files of this tree that it was made of, as the compiler told ninja."""
    found: dict[str, frozenset[str]] = {}
    for block in run_tool(["ninja", "-C", str(build), "-t", "deps"], "ninja").split("\n\n"):
        head, *lines = block.strip().splitlines() or [""]
        paths = (pathlib.Path(os.path.normpath(build / line.strip())) for line in lines)
        found[head.split(":")[0]] = frozenset(p.relative_to(ROOT).as_posix() for p in paths if p.is_relative_to(ROOT))
    return found


def link_command(build: pathlib.Path, target: str) -> list[str]:
    """The words of the command that links a program."""
    lines = run_tool(["ninja", "-C", str(build), "-t", "commands", target], "ninja").strip().splitlines()
    return [word for word in shlex.split(lines[-1]) if word not in (":", "&&")]
