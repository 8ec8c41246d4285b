"""What is published: the published schemas, and nothing of a student's unescaped."""

import csv
import io
import json
import xml.etree.ElementTree as ET

from grading.exports import grades, gradescope, html, junit, prairielearn
from grading.record import Json, Record

EVIL = "</pre><script>alert(1)</script>\x00\x1b[31m"


def entry(identity: str, verdict: str, score: float | None, **more: object) -> Json:
    return {"id": identity, "title": "A title", "file": "common/x.cpp", "contract": "common/x.h",
            "section": "01_lines/README.md, exercise 01.5", "verdict": verdict, "score": score, "max_score": 3.0,
            "message": EVIL, "compiler": EVIL, "mistake": None, "scenes": [
                {"name": "scene 1", "number": 1, "hidden": False, "verdict": verdict, "score": 0, "max_score": 1.5,
                 "message": EVIL, "printed": EVIL,
                 "results": [{"name": EVIL, "right": False, "message": EVIL, "grid": EVIL, "score": 0,
                              "pictures": {"actual": "a.png", "expected": "b.png"}}]},
                {"name": "hidden scene", "hidden": True, "verdict": "wrong", "score": 0, "max_score": 1.5}], **more}


def record(*entries: Json) -> Record:
    failed = any(e["score"] is None for e in entries)
    return Record({"version": 1, "submission": "=cmd|<b>", "digest": "", "stages": ["01_lines"], "notes": [EVIL],
                   "limits_not_enforced": [EVIL], "max_score": 3.0 * len(entries), "exercises": list(entries),
                   "score": None if failed else sum(e["score"] for e in entries),
                   "whole": {"verdict": "right", "message": EVIL}})


def test_html_escapes_everything() -> None:
    graded = record(entry("01.5", "wrong", 1.0))
    for page in (html.student(graded), html.class_page([graded])):
        assert "<script" not in page and "<b>" not in page
        assert "default-src 'none'" in page


def test_class_page_counts_the_answers_that_got_each_fifth_of_the_points() -> None:
    page = html.class_page([record(entry("01.5", "wrong", score)) for score in (0.0, 0.5, 1.0, 3.0, 3.0)])
    counts = [f'title="{20 * fifth} to {20 * fifth + 20} %: {count}"' for fifth, count in enumerate((2, 1, 0, 0, 2))]
    assert all(count in page for count in counts)
    assert page.count('class="column"') == 5


def test_hidden_scene_is_pass_or_fail_only() -> None:
    one = entry("01.5", "wrong", 1.0)
    one["scenes"][1]["verdict"] = "crash"
    page = html.student(record(one))
    assert page.count("hidden scene") == 1
    assert "fail" in page and "crash" not in page


def test_gradescope_schema() -> None:
    results = json.loads(gradescope.export(record(entry("01.5", "wrong", 1.0), entry("01.6", "right", 3.0))))
    assert results["score"] == 4.0
    assert set(results) <= {"score", "execution_time", "output", "output_format", "test_output_format", "test_name_format",
                            "visibility", "stdout_visibility", "extra_data", "tests", "leaderboard"}
    assert results["stdout_visibility"] in {"hidden", "after_due_date", "after_published", "visible"}
    allowed = {"score", "max_score", "status", "name", "name_format", "number", "output", "output_format", "tags",
               "visibility", "extra_data"}
    assert all(set(test) <= allowed for test in results["tests"])
    assert {test["output_format"] for test in results["tests"]} == {results["output_format"]} == {"text"}
    assert {test["visibility"] for test in results["tests"]} == {results["visibility"]} == {"visible"}
    assert [test["status"] for test in results["tests"] if "score" in test] == ["failed", "passed"]
    assert {test["status"] for test in results["tests"]} == {"passed", "failed"}
    assert all(isinstance(test[key], str) for test in results["tests"] for key in ("name", "number", "output"))
    assert all(isinstance(tag, str) for test in results["tests"] for tag in test["tags"])
    assert sum(test.get("score", 0) for test in results["tests"]) == results["score"]
    assert all({"name", "value"} <= set(column) <= {"name", "value", "order"} for column in results["leaderboard"])


def test_grader_error_is_no_zero() -> None:
    graded = record(entry("01.5", "grader error", None), entry("01.6", "right", 3.0))
    gradescope_results = json.loads(gradescope.export(graded))
    assert "score" not in gradescope_results
    assert not any("score" in test for test in gradescope_results["tests"])
    prairielearn_results = json.loads(prairielearn.export(graded))
    assert prairielearn_results["gradable"] is False
    assert ["points" in test for test in prairielearn_results["tests"]] == [False, True]
    row = list(csv.DictReader(io.StringIO(grades.export([graded]))))[0]
    assert row["score"] == "" and row["01.5"] == "" and row["complete"] == "no"
    assert "not a zero" in html.student(graded)
    assert "Failures of the grader: 1" in html.class_page([graded])


def test_prairielearn_score_is_a_share() -> None:
    assert json.loads(prairielearn.export(record(entry("01.5", "wrong", 1.5))))["score"] == 0.5


def test_prairielearn_takes_the_file_whatever_a_compiler_says() -> None:
    said = "\x1b" * 20000  # what JSON needs most room for
    entries = [entry(f"01.{i}", "compile error", 0.0, compiler=said) for i in range(15)]
    assert len(prairielearn.export(record(*entries)).encode()) < 10**6


def test_junit_is_well_formed() -> None:
    root = ET.fromstring(junit.export([record(entry("01.5", "wrong", 1.0), entry("01.6", "grader error", None))]))
    suite = root[0]
    assert suite.get("failures") == "1" and suite.get("errors") == "1"


def test_csv_cell_is_no_formula() -> None:
    assert list(csv.reader(io.StringIO(grades.export([record(entry("01.5", "wrong", 1.0))]))))[1][0].startswith("'=")
