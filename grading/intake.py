"""Takes the exercise files out of what a student handed in, and nothing else.

A submission is a folder, a zip or a tar, in the starter's layout or flat. Nothing is unpacked: the files on
the allow-list are read, everything else is counted and left alone.
"""

import dataclasses
import functools
import os
import pathlib
import stat
import tarfile
import zipfile
from collections.abc import Iterable, Iterator
from typing import IO, Callable

MAX_FILE = 256 * 1024
MAX_MEMBERS = 5000
MAX_PATH = 1000


@dataclasses.dataclass
class Submission:
    name: str
    files: dict[str, bytes] = dataclasses.field(default_factory=dict)  # repository path to content
    notes: list[str] = dataclasses.field(default_factory=list)  # what was refused and why
    ignored: int = 0  # files that no exercise asks for


@dataclasses.dataclass(frozen=True)
class _Member:
    path: str
    is_plain: bool
    size: int
    open: Callable[[], IO[bytes]]


class _Unreadable(Exception):
    pass


def submission_name(path: pathlib.Path) -> str:
    """The name of a submission: that of its folder or archive, without what says archive."""
    name = path.name
    for ending in (".tar.gz", ".tgz", ".tar.xz", ".tar.bz2", ".tar", ".zip"):
        if name.lower().endswith(ending):
            name = name[: -len(ending)]
    return safe_name(name)


def safe_name(name: str) -> str:
    """A name that stands for no other folder and needs no quotes."""
    return "".join(c if c.isalnum() or c in "-_.@+" else "_" for c in name).lstrip(".") or "submission"


def take(path: pathlib.Path, allowed: Iterable[str]) -> Submission:
    """Reads the allowed files of a submission. What is wrong with it becomes a note, never an exception:
    a submission nobody can read is one without files."""
    submission = Submission(submission_name(path))
    try:
        _take_members(submission, _members(path), tuple(allowed))
    except (_Unreadable, OSError, ValueError, EOFError, zipfile.BadZipFile, tarfile.TarError, RuntimeError,
            NotImplementedError) as error:
        submission.files.clear()
        submission.notes.append(f"The submission cannot be read: {error}")
    return submission


def _members(path: pathlib.Path) -> Iterator[_Member]:
    status = path.lstat()
    if stat.S_ISDIR(status.st_mode):
        yield from _folder_members(path)
    elif not stat.S_ISREG(status.st_mode):
        raise _Unreadable("expected a folder, a zip or a tar file")
    elif zipfile.is_zipfile(path):
        yield from _zip_members(path)
    elif tarfile.is_tarfile(path):
        yield from _tar_members(path)
    else:
        raise _Unreadable("expected a folder, a zip or a tar file")


def _folder_members(root: pathlib.Path) -> Iterator[_Member]:
    for folder, _, names in os.walk(root, followlinks=False):
        for name in sorted(names):
            path = pathlib.Path(folder, name)
            status = path.lstat()
            yield _Member(path.relative_to(root).as_posix(), stat.S_ISREG(status.st_mode), status.st_size,
                          functools.partial(_open_plain, path))


def _open_plain(path: pathlib.Path) -> IO[bytes]:
    return os.fdopen(os.open(path, os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK), "rb")


def _zip_members(path: pathlib.Path) -> Iterator[_Member]:
    with zipfile.ZipFile(path) as archive:
        for info in archive.infolist():
            if info.is_dir():
                continue
            kind = stat.S_IFMT(info.external_attr >> 16)
            yield _Member(info.filename, kind in (0, stat.S_IFREG), info.file_size,
                          functools.partial(archive.open, info))


def _tar_members(path: pathlib.Path) -> Iterator[_Member]:
    with tarfile.open(path) as archive:
        for info in archive:
            if info.isdir():
                continue
            yield _Member(info.name, info.isreg(), info.size,
                          functools.partial(_open_tar, archive, info))


def _open_tar(archive: tarfile.TarFile, info: tarfile.TarInfo) -> IO[bytes]:
    stream = archive.extractfile(info)
    if stream is None:
        raise _Unreadable(f"{info.name} cannot be read")
    return stream


def _exercise_file(path: str, allowed: tuple[str, ...]) -> tuple[str, bool] | None:
    """The exercise file that a path in a submission stands for, and whether it is in the starter's layout."""
    parts = [part for part in path.replace("\\", "/").split("/") if part not in ("", ".")]
    if not parts or ".." in parts or "__MACOSX" in parts:
        return None
    clean = "/".join(parts)
    for file in allowed:
        if clean == file or clean.endswith("/" + file):
            return file, True
    named = [file for file in allowed if file.rsplit("/", 1)[-1] == parts[-1]]
    # Flat: the file lies at the top or in one folder, and its name is that of one exercise only.
    return (named[0], False) if len(named) == 1 and len(parts) <= 2 else None


def _take_members(submission: Submission, members: Iterator[_Member], allowed: tuple[str, ...]) -> None:
    in_layout: dict[str, bool] = {}
    for count, member in enumerate(members):
        if count >= MAX_MEMBERS:
            raise _Unreadable(f"it holds more than {MAX_MEMBERS} files")
        found = _exercise_file(member.path, allowed) if len(member.path) <= MAX_PATH else None
        if found is None:
            submission.ignored += 1
            continue
        file, layout = found
        content = _read_plain(submission, member, file)
        if content is None:
            continue
        if file in submission.files and submission.files[file] != content:
            if in_layout[file] == layout:
                submission.notes.append(f"{file}: two different files claim to be it; the first was taken")
                continue
            submission.notes.append(f"{file}: two different files claim to be it; the one in the starter's "
                                    "layout was taken")
            if in_layout[file]:
                continue
        submission.files[file] = content
        in_layout[file] = layout


def _read_plain(submission: Submission, member: _Member, file: str) -> bytes | None:
    """The content of a member, or None with a note why it is refused."""
    reason = ""
    content = b""
    if not member.is_plain:
        reason = "it is a link or a special file, not a plain one"
    elif member.size > MAX_FILE:
        reason = f"it is larger than {MAX_FILE // 1024} KiB"
    else:
        with member.open() as stream:
            content = stream.read(MAX_FILE + 1)  # a header may lie about the size
        if len(content) > MAX_FILE:
            reason = f"it is larger than {MAX_FILE // 1024} KiB"
        elif b"\0" in content:
            reason = "it is not a text"
    if reason:
        submission.notes.append(f"{file}: refused, because {reason}")
        return None
    return content
