"""What a JSON file must hold, said in one line where it does not."""

import json
import pathlib
from typing import Any, TypeVar

from grading.errors import GradingError

Kind = TypeVar("Kind")


def read_json(path: pathlib.Path, expected: str) -> dict[str, Any]:
    """The file's object; `expected` says what it should be."""
    try:
        data = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError, RecursionError) as error:
        raise GradingError(f"{path}: expected {expected}: {error}") from error
    if not isinstance(data, dict):
        raise GradingError(f"{path}: expected {expected}")
    return data


def field(entry: Any, key: str, kind: type[Kind], default: Kind | None = None) -> Kind:
    """entry[key], or the default where it is absent; a number may be whole where a float is asked for."""
    if not isinstance(entry, dict):
        raise GradingError(f"expected an object with \"{key}\"")
    value = entry.get(key, default)
    if kind is float and isinstance(value, int) and not isinstance(value, bool) and abs(value) < 2**53:
        value = float(value)
    if not isinstance(value, kind) or (isinstance(value, bool) and kind is not bool):
        raise GradingError(f"expected \"{key}\" of type {kind.__name__}")
    if isinstance(value, float) and abs(value) >= 2**53 or value != value:
        raise GradingError(f"expected \"{key}\" to be a finite number")
    return value


def strings(entry: Any, key: str) -> tuple[str, ...]:
    """entry[key], an array of strings, which may be absent."""
    values = field(entry, key, list, [])
    if not all(isinstance(value, str) for value in values):
        raise GradingError(f"expected \"{key}\" to hold strings")
    return tuple(values)
