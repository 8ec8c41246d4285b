"""PrairieLearn's results.json for external graders (https://prairielearn.readthedocs.io, "External grading")."""

import json

from grading.exports import words
from grading.record import Json, Record


def export(record: Record) -> str:
    results: Json = {"gradable": record.complete, "message": " ".join(record.data["notes"]),
                     "tests": [_test(entry) for entry in record.exercises if entry["verdict"] != "by hand"]}
    if record.score is not None:
        results["score"] = record.score / record.max_score if record.max_score else 0.0
    else:
        results["format_errors"] = ["The grader failed; this submission is not graded yet."]
    return json.dumps(results, indent=1, ensure_ascii=False) + "\n"


def _test(entry: Json) -> Json:
    test: Json = {"name": f"{entry['id']} {entry['title']}", "description": entry["file"],
                  "max_points": entry["max_score"], "message": entry["verdict"], "output": words.explanation(entry)}
    return test if entry["score"] is None else {**test, "points": entry["score"]}
