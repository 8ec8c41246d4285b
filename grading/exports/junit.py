"""JUnit XML, as continuous integration reads it: a suite per submission, a case per exercise."""

import re
import xml.etree.ElementTree as ET

from grading.exports import words
from grading.record import Record

# What XML 1.0 cannot hold, even escaped.
_NO_XML = re.compile("[^\t\n\r\u0020-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")


def export(records: list[Record]) -> str:
    suites = ET.Element("testsuites", name="RasterLab")
    for record in records:
        graded = [e for e in record.exercises if e["verdict"] != "by hand"]
        suite = ET.SubElement(
            suites, "testsuite", name=_text(record.name), tests=str(len(graded)),
            failures=str(sum(e["verdict"] not in ("right", "grader error") for e in graded)),
            errors=str(sum(e["verdict"] == "grader error" for e in graded)))
        for entry in graded:
            case = ET.SubElement(suite, "testcase", classname=f"stage{entry['id'][:2]}",
                                 name=_text(f"{entry['id']} {entry['title']}"))
            if entry["verdict"] != "right":
                kind = "error" if entry["verdict"] == "grader error" else "failure"
                ET.SubElement(case, kind, type=entry["verdict"], message=_text(
                    f"{words.points(entry['score'])} of {entry['max_score']:g} points")).text = _text(
                        words.explanation(entry))
    ET.indent(suites)
    return ET.tostring(suites, encoding="unicode", xml_declaration=True) + "\n"


def _text(text: str) -> str:
    return _NO_XML.sub("�", text)
