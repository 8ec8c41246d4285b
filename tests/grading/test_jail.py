"""What a jail holds back."""

import pathlib

from grading import jail

LIMITS = jail.Limits(cpu_seconds=1, wall_seconds=2, memory=256 * jail.MIB, file_size=8 * jail.MIB,
                     temporary=16 * jail.MIB, processes=8, output=10000)
PYTHON = ["/usr/bin/python3", "-c"]


def run(script: str, limits: jail.Limits = LIMITS) -> jail.Ended:
    return jail.run([*PYTHON, script], {}, limits)


def test_nothing_of_the_environment() -> None:
    printed = run("import os; print(sorted(os.environ), os.listdir('/'))").printed
    assert "HOME" not in printed and "root" not in printed and "home" not in printed


def test_time_is_limited() -> None:
    assert run("while True: pass").stopped is jail.Stopped.TIME
    assert run("import time; time.sleep(60)").stopped is jail.Stopped.TIME


def test_output_is_limited() -> None:
    ended = run("while True: print('x' * 1000)")
    assert ended.stopped is jail.Stopped.OUTPUT
    assert len(ended.printed) <= 10000


def test_memory_is_limited() -> None:
    assert run("x = bytearray(2**29)").status != 0


def test_other_processes_are_not_seen() -> None:
    assert int(run("import os; print(max(int(p) for p in os.listdir('/proc') if p.isdigit()))").printed) < 20


def test_killing_everything_kills_the_jail_only() -> None:
    ended = run("import os; os.kill(-1, 9)")
    assert ended.stopped is jail.Stopped.NO


def test_result_stays_a_regular_file(tmp_path: pathlib.Path) -> None:
    with jail.scratch_folder() as folder:
        result = pathlib.Path(folder, "result")
        result.write_bytes(b"")
        result.chmod(0o666)
        jail.run([*PYTHON, "import os\ntry: os.unlink('/out')\nexcept OSError: pass\nopen('/out', 'w').write('hello')"],
                 {}, LIMITS, result)
        assert result.is_file() and not result.is_symlink()
        assert result.read_text() == "hello"


def test_result_is_limited_in_size() -> None:
    with jail.scratch_folder() as folder:
        result = pathlib.Path(folder, "result")
        result.write_bytes(b"")
        result.chmod(0o666)
        jail.run([*PYTHON, "f = open('/out', 'wb')\nfor i in range(99): f.write(bytes(2**20))"], {}, LIMITS, result)
        assert result.stat().st_size <= LIMITS.file_size


def test_every_limit_is_enforced_or_said() -> None:
    said = jail.unenforced()
    assert any("each process" in text for text in said)


def test_network_is_away() -> None:
    assert run("import socket; print(len(socket.if_nameindex()))").printed.strip() in ("0", "1")  # loopback alone


