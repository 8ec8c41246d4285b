"""Archives that are the same bytes whenever they hold the same files."""

import gzip
import hashlib
import io
import pathlib
import tarfile

CHECKSUMS = "SHA256SUMS"


def checksums(folder: pathlib.Path) -> str:
    """A line per file as sha256sum writes it, in the order of the paths."""
    lines = []
    for path in sorted(p for p in folder.rglob("*") if p.is_file()):
        name = path.relative_to(folder).as_posix()
        if name != CHECKSUMS:
            lines.append(f"{hashlib.sha256(path.read_bytes()).hexdigest()}  {name}\n")
    return "".join(lines)


def tar_gz(folder: pathlib.Path, top: str) -> bytes:
    """All files of a folder under the name `top`: sorted, owned by nobody in particular, dated 1980."""
    raw = io.BytesIO()
    with tarfile.open(fileobj=raw, mode="w", format=tarfile.USTAR_FORMAT) as archive:
        for path in sorted(p for p in folder.rglob("*") if p.is_file()):
            info = tarfile.TarInfo(f"{top}/{path.relative_to(folder).as_posix()}")
            info.size = path.stat().st_size
            info.mode = 0o755 if path.stat().st_mode & 0o100 else 0o644
            info.mtime = 315532800
            archive.addfile(info, io.BytesIO(path.read_bytes()))
    packed = io.BytesIO()
    with gzip.GzipFile(filename="", fileobj=packed, mode="wb", compresslevel=9, mtime=0) as stream:
        stream.write(raw.getvalue())
    return packed.getvalue()
