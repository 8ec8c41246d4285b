"""Gradescope's results.json (https://gradescope-autograders.readthedocs.io/en/latest/specs/, "Output format").

Where the grader failed there is no score anywhere, which Gradescope asks for: better refused than a zero.
"""

import json

from grading.exports import words
from grading.record import Json, Record


def export(record: Record) -> str:
    results: Json = {"output": _summary(record), "output_format": "text", "visibility": "visible",
                     "stdout_visibility": "hidden", "tests": _tests(record)}
    if record.score is not None:
        results["score"] = record.score
        results["leaderboard"] = [{"name": "Points", "value": record.score, "order": "desc"},
                                  {"name": "Exercises solved", "order": "desc",
                                   "value": sum(e["verdict"] == "right" for e in record.exercises)}]
    return json.dumps(results, indent=1, ensure_ascii=False) + "\n"


def _summary(record: Record) -> str:
    lines = [f"{words.points(record.score)} of {record.max_score:g} points.", *record.data["notes"]]
    if not record.complete:
        lines.append("The grader failed on an exercise; your teacher has been told. This is not a zero.")
    return "\n".join(lines)


def _tests(record: Record) -> list[Json]:
    tests: list[Json] = []
    for entry in record.exercises:
        if entry["verdict"] == "by hand":
            continue
        test: Json = {"name": f"{entry['id']} {entry['title']}", "number": entry["id"],
                      "max_score": entry["max_score"], "output": words.explanation(entry), "output_format": "text",
                      "visibility": "visible", "tags": [f"stage{entry['id'][:2]}", entry["verdict"]]}
        if record.complete:  # without a score of its own Gradescope adds up those of the tests
            test["score"] = entry["score"]
        if entry["score"] is not None:
            test["status"] = "passed" if entry["verdict"] == "right" else "failed"
        tests.append(test)
        # What each scene gave, without points of its own: they are in the exercise's.
        for i, scene in enumerate(entry["scenes"], 1):
            tests.append({"name": f"{entry['id']} {scene['name']}", "number": f"{entry['id']}.{i}",
                          "status": "passed" if scene["verdict"] == "right" else "failed",
                          "output": "" if scene["hidden"] else scene["message"], "output_format": "text",
                          "visibility": "visible", "tags": ["hidden" if scene["hidden"] else "public"]})
    return tests
