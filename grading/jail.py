"""A bubblewrap jail with limits: where a student's file is compiled, linked and run.

A jail sees Debian's /usr, the files it is given (read-only), a small /tmp and, where it may leave a
result, one regular file. It has no network, no environment, no other processes and no privileges.
"""

import dataclasses
import enum
import functools
import os
import pathlib
import selectors
import shutil
import subprocess
import tempfile
import time
from collections.abc import Mapping, Sequence

from grading.errors import GradingError

MIB = 1024 * 1024
NOBODY = 65534


@dataclasses.dataclass(frozen=True)
class Limits:
    cpu_seconds: int
    wall_seconds: int
    memory: int  # bytes of address space, each process
    file_size: int  # bytes, each file
    temporary: int  # bytes in /tmp, all files
    processes: int  # at once, bubblewrap's own two included
    output: int = MIB  # bytes printed


COMPILE = Limits(cpu_seconds=40, wall_seconds=90, memory=2048 * MIB, file_size=64 * MIB,
                 temporary=256 * MIB, processes=16)
LINK = dataclasses.replace(COMPILE, cpu_seconds=30)
RUN = Limits(cpu_seconds=4, wall_seconds=10, memory=1024 * MIB, file_size=32 * MIB,
             temporary=16 * MIB, processes=4)


class Stopped(enum.Enum):
    """Why a program did not end by itself."""

    NO = ""
    TIME = "time"
    OUTPUT = "output"


@dataclasses.dataclass(frozen=True)
class Ended:
    status: int  # as a shell gives it: 128 + signal when killed
    stopped: Stopped
    printed: str  # standard output and standard error together, cut at Limits.output
    seconds: float


def is_root() -> bool:
    return os.geteuid() == 0


def _mounts(read_only: Mapping[str, pathlib.Path], output: pathlib.Path | None, limits: Limits) -> list[str]:
    arguments = ["--ro-bind", "/usr", "/usr"]
    for link in ("bin", "lib", "lib64"):
        arguments += ["--symlink", f"usr/{link}", f"/{link}"]
    for path in ("/etc/ld.so.cache", "/etc/alternatives"):
        arguments += ["--ro-bind-try", path, path]
    arguments += ["--proc", "/proc", "--dev", "/dev", "--remount-ro", "/dev"]
    arguments += ["--size", str(limits.temporary), "--tmpfs", "/tmp"]
    for inside, outside in read_only.items():
        arguments += ["--ro-bind", str(outside), inside]
    if output is not None:
        arguments += ["--bind", str(output), "/out"]
    return arguments + ["--remount-ro", "/"]


def _command(command: Sequence[str], mounts: list[str], limits: Limits, run_as_nobody: bool) -> list[str]:
    # Processes are counted inside the jail's own user namespace, so the limits are set in there.
    limited = ["/usr/bin/prlimit", f"--cpu={limits.cpu_seconds}:{limits.cpu_seconds + 1}",
               f"--as={limits.memory}", f"--fsize={limits.file_size}", "--core=0", "--nofile=256",
               f"--nproc={limits.processes}", "--", *command]
    isolation = ["--unshare-all", "--unshare-user", "--new-session", "--die-with-parent", "--cap-drop", "ALL",
                 "--clearenv", "--setenv", "PATH", "/usr/bin", "--setenv", "LC_ALL", "C.UTF-8",
                 "--hostname", "jail"]
    if run_as_nobody or not is_root():
        isolation += ["--disable-userns"]
    return ["bwrap", *isolation, *mounts, "--chdir", "/tmp", "--", *limited]


def run(command: Sequence[str], read_only: Mapping[str, pathlib.Path], limits: Limits,
        output: pathlib.Path | None = None) -> Ended:
    """Runs a command in a jail. `read_only` maps paths in the jail to files or folders outside; `output`
    is an empty regular file that the jail has as /out."""
    nobody = drops_root()
    if output is not None and nobody:
        os.chown(output, NOBODY, NOBODY)
    arguments = _command(command, _mounts(read_only, output, limits), limits, nobody)
    start = time.monotonic()
    process = subprocess.Popen(
        arguments, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, env=dict[str, str](),
        executable=_bwrap(), user=NOBODY if nobody else None, group=NOBODY if nobody else None,
        extra_groups=[] if nobody else None)
    printed, stopped = _collect(process, limits, start)
    status = process.wait()
    seconds = time.monotonic() - start
    if stopped is Stopped.NO and status in (128 + 24, 128 + 9) and seconds >= limits.cpu_seconds * 0.9:
        stopped = Stopped.TIME
    return Ended(128 - status if status < 0 else status, stopped, printed, seconds)


def _collect(process: "subprocess.Popen[bytes]", limits: Limits, start: float) -> tuple[str, Stopped]:
    """Reads what the jail prints until it ends, prints too much or takes too long; then kills it."""
    assert process.stdout is not None
    printed = bytearray()
    stopped = Stopped.NO
    with selectors.DefaultSelector() as selector:
        selector.register(process.stdout, selectors.EVENT_READ)
        while True:
            left = start + limits.wall_seconds - time.monotonic()
            if left <= 0:
                stopped = Stopped.TIME
            elif selector.select(left):
                chunk = os.read(process.stdout.fileno(), 65536)
                printed += chunk
                if not chunk:
                    break
                if len(printed) > limits.output:
                    stopped = Stopped.OUTPUT
            if stopped is not Stopped.NO:
                process.kill()
                break
    process.stdout.close()
    return printed[: limits.output].decode("utf-8", "replace"), stopped


@functools.cache
def _bwrap() -> str:
    path = shutil.which("bwrap")
    if path is None:
        raise GradingError("bwrap is not installed; run: apt-get install --no-install-recommends bubblewrap")
    return path


@functools.cache
def drops_root() -> bool:
    """Whether jails are started as nobody: when we are root and nobody can reach bubblewrap and /tmp."""
    if not is_root():
        return False
    test = subprocess.run([_bwrap(), "--unshare-all", "--ro-bind", "/usr", "/usr", "--symlink", "usr/lib", "/lib",
                           "--symlink", "usr/lib64", "/lib64", "--ro-bind",
                           str(pathlib.Path(__file__).resolve().parent), "/x", "/usr/bin/true"],
                          user=NOBODY, group=NOBODY, extra_groups=[], capture_output=True, check=False)
    return test.returncode == 0


# What each limit is tried with: a program that must not succeed, and what is said where it does.
_TRIALS: dict[str, tuple[str, str]] = {
    "network": ("import socket; socket.create_connection(('1.1.1.1', 53), 2)", "the network can be reached"),
    "memory": ("x = bytearray(512 * 2**20)", "memory of a process is not limited"),
    "file size": ("open('/tmp/x', 'wb').write(b'x' * (9 * 2**20))", "the size of a file is not limited"),
    "disk": ("[open(f'/tmp/{i}', 'wb').write(b'x' * 2**20) for i in range(32)]", "/tmp is not limited"),
    "processes": ("import os, time\nfor i in range(64):\n  if os.fork() == 0: time.sleep(3); os._exit(0)",
                  "the number of processes is not limited"),
    "read-only": ("open('/usr/x', 'w')", "/usr can be written"),
    "root folder": ("open('/x', 'w')", "the jail's root can be written"),
    "other files": ("import os; assert os.path.exists('/root') or os.path.exists('/home')",
                    "folders of the machine can be seen"),
}


@functools.cache
def unenforced() -> tuple[str, ...]:
    """Tries every limit in a jail and says which this machine does not enforce. Throws GradingError when no
    jail can be had at all: nothing of a student's is ever run outside one."""
    limits = Limits(cpu_seconds=5, wall_seconds=10, memory=256 * MIB, file_size=8 * MIB, temporary=16 * MIB,
                    processes=8)
    alive = run(["/usr/bin/python3", "-c", "print('alive')"], {}, limits)
    if alive.status != 0 or alive.printed != "alive\n":
        raise GradingError(
            "no bubblewrap jail can be started, and nothing is graded outside one: "
            f"{alive.printed.strip() or alive.status}; unprivileged user namespaces must be allowed "
            "(sysctl kernel.unprivileged_userns_clone=1, or run as root)")
    missing = [text for script, text in _TRIALS.values()
               if run(["/usr/bin/python3", "-c", script], {}, limits).status == 0]
    if run(["/usr/bin/python3", "-c", "while True: pass"], {},
           dataclasses.replace(limits, cpu_seconds=1, wall_seconds=6)).seconds >= 5.5:
        missing.append("CPU time is not limited, only the time on the clock")
    missing.append("memory is limited for each process, not for all of a jail together: at most "
                   f"{RUN.processes - 1} × {RUN.memory // MIB} MiB when a program runs")
    return tuple(missing)


def scratch_folder() -> "tempfile.TemporaryDirectory[str]":
    """A folder for one jail's files; nobody may pass through it but not list it."""
    folder = tempfile.TemporaryDirectory(prefix="rasterlab-")
    os.chmod(folder.name, 0o711)
    return folder
