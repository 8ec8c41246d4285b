"""grades.csv: a row per submission, a column per exercise. An exercise the grader failed on is empty."""

import csv
import io

from grading.record import Record


def export(records: list[Record]) -> str:
    ids = list(dict.fromkeys(e["id"] for r in records for e in r.exercises if e["verdict"] != "by hand"))
    text = io.StringIO()
    table = csv.writer(text, lineterminator="\n")
    table.writerow(["submission", "score", "max_score", "complete", *ids])
    for record in records:
        scores = {e["id"]: e["score"] for e in record.exercises}
        table.writerow([_cell(record.name), _number(record.score), f"{record.max_score:g}",
                        "yes" if record.complete else "no", *(_number(scores.get(i)) for i in ids)])
    return text.getvalue()


def _number(score: float | None) -> str:
    return "" if score is None else f"{score:g}"


def _cell(text: str) -> str:
    """A spreadsheet must not take a name for a formula."""
    return "'" + text if text[:1] in "=+-@\t\r" else text
