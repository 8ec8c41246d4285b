"""How a record's parts are said, the same in every format."""

from grading.record import Json


# Characters of what the compiler says: PrairieLearn takes a file of 1 MB.
COMPILER = 8000


def explanation(entry: Json) -> str:
    """What a student reads of an exercise, as plain text."""
    lines = [entry["message"]] if entry["message"] else []
    if mistake := entry["mistake"]:
        lines += [f"This looks like: {mistake['title']}.", f"The contract says: “{mistake['breaks']}”"]
    if entry["verdict"] not in ("right", "by hand"):
        lines.append(f"Read {entry['section']}, and {entry['contract']}.")
    if entry["compiler"]:
        lines.append(entry["compiler"][:COMPILER])
    return "\n".join(lines)


def points(score: float | None) -> str:
    return "not graded" if score is None else f"{score:g}"
