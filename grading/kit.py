"""What submissions are graded against: the reference, built and taken apart.

A kit is made from this very tree, in build/grade. It holds the headers a student's file may see,
the reference's objects (one archive per exercise, so that a student's file never meets the answer it
replaces) and what the reference computes for each scene.
"""

import dataclasses
import fcntl
import functools
import hashlib
import os
import pathlib
import re
import shutil
import sys
import threading

from grading import manifest, ninja
from grading.manifest import ROOT, Exercise
from grading.ninja import run_tool

BUILD = ROOT / "build" / "grade"  # where the preset "grade" builds
KIT = ROOT / "build" / "kit"

JUDGE_SOURCES = ("grading/judge/main.cpp", "grading/judge/compare.cpp", "grading/judge/records.cpp",
                 "grading/judge/segment.cpp")
PROBE_SOURCES = ("grading/probes/probe.cpp", "grading/judge/records.cpp")

# Parts of common that no exercise, probe or judge calls.
NOT_NEEDED = ("common/engine/", "common/viewer/")

# Files of this tool that no grade depends on: what is published of records, and the other commands.
NO_GRADE = ("exports/", "archive.py", "bless.py", "handout.py", "markers.py", "selftest.py")

# Templates' bodies stand in .inl files.
HEADERS = (".h", ".inl")


@dataclasses.dataclass(frozen=True)
class Scene:
    """One run of an exercise. Scene 0 is the course's own example; other numbers seed made-up inputs."""

    number: int
    hidden: bool

    @property
    def title(self) -> str:
        if self.hidden:
            return "hidden scene"
        return "the lab sheet's example" if self.number == 0 else f"scene {self.number}"


@dataclasses.dataclass(frozen=True)
class Unit:
    """A source file that must be compiled anew for an exercise, and the headers with answers it may see."""

    source: str
    headers: tuple[str, ...]


class Kit:
    def __init__(self, stages: list[str], secret: str) -> None:
        self.stages = stages
        self.last_stage = max(manifest.stage_number(stage) for stage in stages)
        self.folder = KIT / "_".join(stage[:2] for stage in stages)
        self.secret = secret
        self._lock = threading.Lock()

    # --- building -------------------------------------------------------------------------------

    def prepare(self) -> None:
        """Builds the reference and takes it apart. Quick when nothing has changed."""
        self.folder.mkdir(parents=True, exist_ok=True)
        with open(KIT / "lock", "w", encoding="utf-8") as lock:
            fcntl.flock(lock, fcntl.LOCK_EX)  # several shards may start at once, and kits share one build folder
            self._build()
            self._copy_headers()
            self._precompile_headers()
            self._make_archives()
            self._link()

    def _build(self) -> None:
        """Compiles what the probes and the judge need: neither engine nor viewer, which nobody is asked for."""
        if not (BUILD / "build.ninja").exists():
            run_tool(["cmake", "--preset", "grade"], "configuring the reference")
        # Re-runs CMake where files came or went; the list of what to compile is only good after that.
        run_tool(["ninja", "-C", str(BUILD), "build.ninja"], "configuring the reference")
        sources = [*self.library_sources, *JUDGE_SOURCES]
        objects = [str(object_path(source).relative_to(BUILD)) for source in sources]
        objects += [str(path.relative_to(BUILD)) for stage in self.stages for path in probe_objects(stage).values()]
        run_tool(["ninja", "-C", str(BUILD), "-j", str(os.cpu_count() or 1),
                  *dict.fromkeys(objects)], "building the reference")

    def _link(self) -> None:
        """The trusted programs: the judge, and a probe per stage with all of the reference's answers."""
        self._link_program(self.judge, [object_path(source) for source in JUDGE_SOURCES])
        for stage in self.stages:
            self._link_program(self.reference(stage), list(probe_objects(stage).values()))

    def _link_program(self, program: pathlib.Path, objects: list[pathlib.Path]) -> None:
        archives = sorted((self.folder / "archives").glob("*.a"))
        if program.exists() and program.stat().st_mtime >= max(p.stat().st_mtime for p in [*objects, *archives]):
            return
        program.parent.mkdir(exist_ok=True)
        unfinished = program.with_suffix(".new")  # where a linker was killed, half a program would look up to date
        run_tool(["c++", "-o", str(unfinished), *map(str, objects), "-Wl,--start-group", *map(str, archives),
                  "-Wl,--end-group", *self.libraries], f"linking {program.name}")
        unfinished.rename(program)

    @property
    def judge(self) -> pathlib.Path:
        return self.folder / "bin" / "judge"

    def reference(self, stage: str) -> pathlib.Path:
        return self.folder / "bin" / probe_name(stage)

    def _copy_headers(self) -> None:
        """include/: every header of common; those with an answer that is asked for are empty files to mount on."""
        fresh = self.folder / "include.new"
        shutil.rmtree(fresh, ignore_errors=True)
        for name, content in self.headers.items():
            (fresh / name).parent.mkdir(parents=True, exist_ok=True)
            (fresh / name).write_bytes(b"" if name in self.secret_headers else content)
        for path in [*(ROOT / "grading" / "judge").glob("records.h"), *(ROOT / "grading/probes").glob("*.h")]:
            target = fresh / path.relative_to(ROOT)
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_bytes(path.read_bytes())
        sources = self.answers | {unit.source for exercise in self.graded_exercises for unit in self.units(exercise)}
        for name in sources:
            (fresh / name).parent.mkdir(parents=True, exist_ok=True)
            (fresh / name).touch()
        if _tree_digest(fresh) == _tree_digest(self.include):
            shutil.rmtree(fresh)
        else:
            shutil.rmtree(self.include, ignore_errors=True)
            fresh.rename(self.include)

    def _precompile_headers(self) -> None:
        """The headers that every file of the library is compiled with, so that what compiles in a starter does
        here, and quickly."""
        text = (BUILD / "common/CMakeFiles/common.dir/cmake_pch.hxx").read_text()
        # By its name alone: where this tree is, is not for a student to read in what the compiler says.
        command = ["c++", *self.compile_flags, "-x", "c++-header", "headers.hxx", "-o", "headers.hxx.gch"]
        key = hashlib.sha256(f"{text}{command}{sys.version}".encode()).hexdigest()
        folder = self.folder / "precompiled"
        if (folder / "key").exists() and (folder / "key").read_text() == key:
            return
        folder.mkdir(exist_ok=True)
        (folder / "headers.hxx").write_text(text)
        run_tool(command, "precompiling headers", folder)
        (folder / "key").write_text(key)

    def _make_archives(self) -> None:
        (self.folder / "archives").mkdir(exist_ok=True)
        wanted = {"given": [source for source in self.library_sources if source not in self.answers]}
        wanted |= {archive_name(source): [source] for source in self.library_sources if source in self.answers}
        for stale in (self.folder / "archives").glob("*.a"):
            if stale.stem not in wanted:
                stale.unlink()
        for name, sources in wanted.items():
            self._archive(name, sources)

    def _archive(self, name: str, sources: list[str]) -> None:
        path = self.folder / "archives" / f"{name}.a"
        objects = [object_path(source) for source in sources]
        if path.exists() and path.stat().st_mtime >= max(o.stat().st_mtime for o in objects):
            return
        unfinished = path.with_suffix(".new")
        unfinished.unlink(missing_ok=True)
        run_tool(["ar", "qcs", str(unfinished), *map(str, objects)], "archiving the reference")
        unfinished.rename(path)

    # --- what there is --------------------------------------------------------------------------

    @property
    def include(self) -> pathlib.Path:
        return self.folder / "include"

    @functools.cached_property
    def all_exercises(self) -> list[Exercise]:
        return [exercise for stage in manifest.STAGES[: self.last_stage] if (ROOT / stage).is_dir()
                for exercise in manifest.exercises(stage)]

    @functools.cached_property
    def exercises(self) -> list[Exercise]:
        """Those of the kit's stages."""
        return [exercise for exercise in self.all_exercises if exercise.stage in self.stages]

    @functools.cached_property
    def graded_exercises(self) -> list[Exercise]:
        return [exercise for exercise in self.exercises if not exercise.grading.by_hand]

    @functools.cached_property
    def answers(self) -> frozenset[str]:
        """The files of all stages that hold an answer."""
        return frozenset(exercise.file for exercise in self.all_exercises if not exercise.grading.by_hand)

    @functools.cached_property
    def headers(self) -> dict[str, bytes]:
        """Those of common, up to the kit's last stage, with what they hold."""
        names = (path.relative_to(ROOT).as_posix() for path in sorted((ROOT / "common").rglob("*")) if is_header(path.name))
        return {name: (ROOT / name).read_bytes() for name in names if manifest.path_stage(name) <= self.last_stage}

    @functools.cached_property
    def secret_headers(self) -> frozenset[str]:
        """Headers with an answer that the students of the kit's stages are to write; of earlier stages they have it."""
        chosen = {manifest.stage_number(stage) for stage in self.stages}
        return frozenset(name for name, content in self.headers.items()
                         if manifest.path_stage(name) in chosen and b"<solution>" in content)

    @functools.cached_property
    def commands(self) -> dict[str, tuple[str, ...]]:
        """Source file to how it is compiled."""
        return {compiled.source: compiled.command for compiled in ninja.compiled_objects(BUILD)}

    @functools.cached_property
    def library_sources(self) -> list[str]:
        return [source for source in self.commands
                if source.startswith("common/") and not source.startswith(NOT_NEEDED)
                and manifest.path_stage(source) <= self.last_stage]

    @functools.cached_property
    def compile_flags(self) -> list[str]:
        """How the library is compiled, less the precompiled header, this tree's path and -Werror: a warning
        is shown to a student, not punished."""
        command = next(self.commands[source] for source in self.library_sources)
        flags: list[str] = []
        skip = 0
        for token in command[1:]:
            if skip:
                skip -= 1
            elif token in ("-o", "-c", "-include"):
                skip = 1
            elif token in ("-Werror", "-Winvalid-pch", "-fpch-preprocess") or str(ROOT) in token:
                pass
            elif not token.startswith("/") or flags and flags[-1] in ("-isystem", "-I"):
                flags.append(token)
        return flags

    @functools.cached_property
    def libraries(self) -> list[str]:
        """Debian's libraries that the reference links."""
        tokens = ninja.link_command(BUILD, "rasterlab_judge")
        # As needed: loading libraries that nothing calls would take longer than most scenes.
        return ["-Wl,--as-needed", *(t for t in tokens if t.startswith("/usr/lib/") or t.startswith("-l"))]

    def units(self, exercise: Exercise) -> list[Unit]:
        """What must be compiled for an exercise: its file; where that is a header, what tries it and includes it."""
        source = scene_source(exercise) if is_header(exercise.file) else exercise.file
        return [Unit(source, tuple(sorted(self.secret_headers & self.dependencies.get(source, frozenset()))))]

    @functools.cached_property
    def dependencies(self) -> dict[str, frozenset[str]]:
        """Source file to the files of ours that it includes."""
        included = ninja.included_files(BUILD)
        objects = {source: str(object_path(source).relative_to(BUILD)) for source in self.commands}
        return {source: included[name] for source, name in objects.items() if name in included}

    def scenes(self, exercise: Exercise) -> list[Scene]:
        public = [Scene(0, False), Scene(1, False)]
        hidden = [Scene(int.from_bytes(_hash(f"{self.secret}/{exercise.id}/{i}")[:6], "big") | 2, True)
                  for i in range(exercise.grading.hidden)]
        return public + hidden

    # --- what the reference computes -------------------------------------------------------------

    def expected(self, exercise: Exercise, scene: Scene) -> pathlib.Path:
        """The reference's result file."""
        program = self.reference(exercise.stage)
        path = self.folder / "expected" / self._program_digest(program) / exercise.id / f"{scene.number}.result"
        with self._lock:
            if not path.exists():
                path.parent.mkdir(parents=True, exist_ok=True)
                unfinished = path.with_suffix(f".{threading.get_native_id()}")
                run_tool([str(program), exercise.id, str(scene.number), str(unfinished)],
                         f"the reference on {exercise.id}, scene {scene.number},")
                unfinished.rename(path)
        return path

    @functools.cache
    def _program_digest(self, program: pathlib.Path) -> str:
        return hashlib.sha256(program.read_bytes()).hexdigest()[:16]

    @functools.cached_property
    def digest(self) -> str:
        """Changes when anything does that a grade depends on: reference, probes, judge, manifests, tool."""
        parts = [str(self.stages), self.secret, str(self.compile_flags), sys.version,
                 run_tool(["c++", "--version"], "c++"), _tree_digest(self.include)]
        for stage in self.stages:
            parts.append(self._program_digest(self.reference(stage)))
            parts.append((ROOT / stage / "exercises.json").read_text())
        parts.append(self._program_digest(self.judge))
        parts += [path.read_text() for path in tool_files()]
        return hashlib.sha256("\0".join(parts).encode()).hexdigest()


def tool_files() -> list[pathlib.Path]:
    """The files of this tool that a grade, or what is said of it, depends on."""
    folder = ROOT / "grading"
    return [path for path in sorted([*folder.rglob("*.py"), *(folder / "mutants").glob("*.toml")])
            if not path.relative_to(folder).as_posix().startswith(NO_GRADE)]


def is_header(name: str) -> bool:
    return pathlib.PurePath(name).suffix in HEADERS


def probe_name(stage: str) -> str:
    return f"stage{stage[:2]}_probe"


def archive_name(source: str) -> str:
    return source.removeprefix("common/").removesuffix(".cpp").replace("/", ".")


def scene_source(exercise: Exercise) -> str:
    """What tries an answer that is a header: a file of its own, so that no other answer is compiled with it."""
    return f"grading/probes/stage{exercise.stage[:2]}/{pathlib.PurePath(exercise.file).stem}.cpp"


def object_path(source: str) -> pathlib.Path:
    """Where CMake puts the object of a source file of the library, the judge or a probe."""
    if source.startswith("common/"):
        return BUILD / "common/CMakeFiles/common.dir" / (source.removeprefix("common/") + ".o")
    target = "rasterlab_judge"
    if match := re.match("grading/probes/(stage[0-9]{2})", source):
        target = f"{match.group(1)}_probe"
    return BUILD / f"grading/CMakeFiles/{target}.dir" / (source.removeprefix("grading/") + ".o")


def probe_objects(stage: str) -> dict[str, pathlib.Path]:
    """What the probe of a stage is linked of: source file to object."""
    own = [f"grading/probes/{probe_name(stage)}.cpp",
           *(path.relative_to(ROOT).as_posix() for path in sorted((ROOT / f"grading/probes/stage{stage[:2]}").glob("*.cpp")))]
    shared = BUILD / f"grading/CMakeFiles/{probe_name(stage)}.dir"
    return {source: object_path(source) for source in own} | {
        source: shared / (source.removeprefix("grading/") + ".o") for source in PROBE_SOURCES}


def _hash(text: str) -> bytes:
    return hashlib.sha256(text.encode()).digest()


def _tree_digest(folder: pathlib.Path) -> str:
    digest = hashlib.sha256()
    for path in sorted(folder.rglob("*")):
        if path.is_file():
            digest.update(path.relative_to(folder).as_posix().encode() + b"\0")
            digest.update(hashlib.sha256(path.read_bytes()).digest())
    return digest.hexdigest()
