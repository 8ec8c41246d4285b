"""The pages people read: one per student, one for the class. Whatever comes from a student is escaped."""

import collections
import html
import pathlib
import urllib.parse

from grading.exports import words
from grading.record import Json, Record

_STYLE = """
:root { color-scheme: light dark; }
body { font: 16px/1.5 system-ui, sans-serif; max-width: 60rem; margin: 2rem auto; padding: 0 1rem; }
h1, h2, h3 { line-height: 1.2; }
pre { overflow-x: auto; background: #8881; padding: .6rem; border-radius: 4px; font-size: 13px; line-height: 1.25; }
table { border-collapse: collapse; display: block; overflow-x: auto; }
td, th { padding: .2rem .7rem; text-align: left; border-bottom: 1px solid #8884; }
td.number, th.number { text-align: right; white-space: nowrap; font-variant-numeric: tabular-nums; }
.right { color: #1a7f37; } .wrong { color: #cf222e; } .failed { color: #9a6700; }
figure { display: inline-block; width: 258px; margin: .5rem 1rem .5rem 0; vertical-align: top; }
figcaption { font-size: 14px; line-height: 1.3; }
figure img { width: 256px; image-rendering: pixelated; border: 1px solid #8888; display: block; }
.swap { position: relative; } .swap img + img { position: absolute; inset: 0; opacity: 0; }
.swap:hover img + img, .swap:focus img + img { opacity: 1; }
.mistake { border-left: 4px solid #bf8700; padding: .2rem .8rem; background: #bf870018; }
.column { background: #0969da; width: .7rem; min-height: 1px; display: inline-block; margin-right: 2px; }
.bar { background: #0969da; height: .8rem; display: inline-block; border-radius: 2px; }
"""

# How many wrong results of a scene a student sees without asking for more.
SHOWN_AT_ONCE = 3

_COLORS = {"right": "right", "grader error": "failed", "by hand": "failed"}


def _page(title: str, body: str) -> str:
    policy = "default-src 'none'; img-src 'self'; style-src 'unsafe-inline'"
    return (f'<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
            f'<meta http-equiv="Content-Security-Policy" content="{policy}">\n'
            f'<meta name="viewport" content="width=device-width">\n<title>{html.escape(title)}</title>\n'
            f"<style>{_STYLE}</style>\n</head>\n<body>\n{body}</body>\n</html>\n")


def _verdict(verdict: str) -> str:
    return f'<span class="{_COLORS.get(verdict, "wrong")}">{html.escape(verdict)}</span>'


def _pre(text: str) -> str:
    return f"<pre>{html.escape(text)}</pre>\n" if text else ""


def _paragraph(text: str, kind: str = "") -> str:
    attribute = f' class="{kind}"' if kind else ""
    return f"<p{attribute}>{html.escape(text)}</p>\n" if text else ""


# --- a student's page ---------------------------------------------------------------------------


def student(record: Record) -> str:
    body = f"<h1>{html.escape(record.name)}</h1>\n"
    body += f"<p><strong>{words.points(record.score)}</strong> of {record.max_score:g} points</p>\n"
    if not record.complete:
        body += _paragraph("The grader failed on an exercise. This is not a zero: it will be graded again.", "failed")
    body += "".join(_paragraph(note) for note in record.data["notes"])
    body += _overview(record)
    body += "".join(_exercise(entry) for entry in record.exercises if entry["verdict"] != "by hand")
    whole = record.data["whole"]
    body += f"<h2>All files together</h2>\n<p>Not scored: {_verdict(whole['verdict'])}</p>\n" + _pre(whole["message"])
    return _page(f"{record.name}: RasterLab", body)


def _overview(record: Record) -> str:
    rows = "".join(
        f'<tr><td><a href="#e{html.escape(e["id"])}">{html.escape(e["id"])}</a></td><td>{html.escape(e["title"])}</td>'
        f'<td>{_verdict(e["verdict"])}</td><td class="number">{words.points(e["score"])} / {e["max_score"]:g}</td></tr>\n'
        for e in record.exercises)
    return ('<table>\n<tr><th></th><th>exercise</th><th>verdict</th><th class="number">points</th></tr>\n'
            f"{rows}</table>\n")


def _exercise(entry: Json) -> str:
    body = (f'<h2 id="e{html.escape(entry["id"])}">{html.escape(entry["id"])} {html.escape(entry["title"])}</h2>\n'
            f'<p>{_verdict(entry["verdict"])}, {words.points(entry["score"])} of {entry["max_score"]:g} points; '
            f'<code>{html.escape(entry["file"])}</code></p>\n')
    if entry["verdict"] != "right":
        body += _paragraph(entry["message"])
    if mistake := entry["mistake"]:
        body += (f'<div class="mistake"><p><strong>This looks like: {html.escape(mistake["title"])}.</strong></p>\n'
                 f'<p>The contract says: “{html.escape(mistake["breaks"])}”</p></div>\n')
    if entry["verdict"] not in ("right", "by hand"):
        body += _paragraph(f"Read {entry['section']}, and the contract {entry['contract']}.")
    body += _pre(entry["compiler"])
    body += "".join(_scene(entry, scene) for scene in entry["scenes"] if not scene["hidden"])
    return body + _hidden_scenes([scene for scene in entry["scenes"] if scene["hidden"]])


def _hidden_scenes(scenes: list[Json]) -> str:
    if not scenes:
        return ""
    passed = ", ".join('<span class="right">pass</span>' if scene["verdict"] == "right"
                       else '<span class="wrong">fail</span>' for scene in scenes)
    return f"<h3>hidden scenes: {passed}</h3>\n"


def _scene(entry: Json, scene: Json) -> str:
    body = f"<h3>{html.escape(scene['name'])}: {_verdict(scene['verdict'])}</h3>\n"
    wrong = [_wrong_result(entry, scene, result) for result in scene["results"] if not result["right"]]
    body += "".join(wrong[:SHOWN_AT_ONCE])
    if rest := wrong[SHOWN_AT_ONCE:]:
        body += f"<details><summary>and {len(rest)} more</summary>\n{''.join(rest)}</details>\n"
    if not scene["results"]:
        body += _paragraph(scene["message"])
    if scene["printed"] and scene["verdict"] != "right":
        body += "<details><summary>what the program printed</summary>\n" + _pre(scene["printed"]) + "</details>\n"
    return body


def _wrong_result(entry: Json, scene: Json, result: Json) -> str:
    body = f"<p><strong>{html.escape(result['name'])}.</strong> {html.escape(result['message'])}</p>\n"
    if kind := result.get("kind_of_wrong"):
        body += _paragraph(f"Kind of wrong: {kind}.")
    body += _pictures(f"{entry['id']}/{scene['number']}", result.get("pictures", {}))
    if grid := result.get("grid"):
        body += _paragraph("Each pixel: # drawn, . empty, ? missing, ! extra, x another value.") + _pre(grid)
    return body


def _pictures(folder: str, names: dict[str, str]) -> str:
    if "actual" not in names or "expected" not in names:
        return ""

    def image(what: str) -> str:
        source = urllib.parse.quote(f"pictures/{folder}/{names[what]}")
        return f'<img src="{source}" alt="{what}">'

    swap = (f'<figure><div class="swap" tabindex="0">{image("actual")}{image("expected")}</div>'
            "<figcaption>yours; point at it to see what is expected</figcaption></figure>\n")
    difference = ""
    if "difference" in names:
        difference = (f'<figure>{image("difference")}<figcaption>difference: red missing, yellow extra, '
                      "magenta another value</figcaption></figure>\n")
    return swap + f'<figure>{image("expected")}<figcaption>expected</figcaption></figure>\n' + difference


# --- the class ----------------------------------------------------------------------------------


def class_page(records: list[Record]) -> str:
    body = "<h1>The class</h1>\n" + _grader_failures(records) + _distribution(records)
    body += _commonest_mistakes(records) + _students(records) + _limits(records)
    return _page("The class: RasterLab", body)


def _grader_failures(records: list[Record]) -> str:
    failures = [(record.name, entry) for record in records for entry in record.exercises
                if entry["verdict"] == "grader error"]
    if not failures:
        return "<p>No failure of the grader.</p>\n"
    rows = "".join(f"<tr><td>{html.escape(name)}</td><td>{html.escape(entry['id'])}</td>"
                   f"<td><pre>{html.escape(entry['message'])}</pre></td></tr>\n" for name, entry in failures)
    return (f'<h2 class="failed">Failures of the grader: {len(failures)}</h2>\n<p>These have no score, not a zero; '
            f"run the same command again.</p>\n<table>\n{rows}</table>\n")


def _columns(shares: list[float]) -> str:
    """How many answers got each fifth of the points, a column for each; all of them are in the last."""
    counts = [0] * 5
    for share in shares:
        counts[min(int(share * 5), 4)] += 1
    return "".join(
        f'<span class="column" style="height:{1.2 * count / max(counts):.2f}rem" '
        f'title="{20 * fifth} to {20 * fifth + 20} %: {count}"></span>'
        for fifth, count in enumerate(counts)) if shares else ""


def _distribution(records: list[Record]) -> str:
    verdicts: dict[str, collections.Counter[str]] = {}
    titles: dict[str, str] = {}
    shares: dict[str, list[float]] = collections.defaultdict(list)
    for record in records:
        for entry in record.exercises:
            if entry["verdict"] == "by hand":
                continue
            titles[entry["id"]] = entry["title"]
            verdicts.setdefault(entry["id"], collections.Counter())[entry["verdict"]] += 1
            if entry["score"] is not None and entry["max_score"]:
                shares[entry["id"]].append(entry["score"] / entry["max_score"])
    rows = ""
    for exercise, counts in verdicts.items():
        share = sum(shares[exercise]) / len(shares[exercise]) if shares[exercise] else 0.0
        right_first = sorted(counts.items(), key=lambda item: (item[0] != "right", -item[1]))
        spread = ", ".join(f"{count} {html.escape(verdict)}" for verdict, count in right_first)
        rows += (f"<tr><td>{html.escape(exercise)}</td><td>{html.escape(titles[exercise])}</td>"
                 f'<td><span class="bar" style="width:{share * 8:.2f}rem"></span> {share:.0%}</td>'
                 f"<td>{_columns(shares[exercise])}</td><td>{spread}</td></tr>\n")
    return ("<h2>Each exercise</h2>\n<table>\n<tr><th></th><th>exercise</th><th>mean of the points</th>"
            f"<th>from none to all</th><th>verdicts</th></tr>\n{rows}</table>\n")


def _commonest_mistakes(records: list[Record]) -> str:
    counts = collections.Counter((entry["id"], entry["mistake"]["title"]) for record in records
                                 for entry in record.exercises if entry["mistake"])
    if not counts:
        return ""
    rows = "".join(f'<tr><td class="number">{count}</td><td>{html.escape(exercise)}</td>'
                   f"<td>{html.escape(title)}</td></tr>\n" for (exercise, title), count in counts.most_common(20))
    return ('<h2>Commonest mistakes</h2>\n<table>\n<tr><th class="number">answers</th><th></th><th>looks like</th></tr>\n'
            f"{rows}</table>\n")


def _students(records: list[Record]) -> str:
    rows = "".join(
        f'<tr><td><a href="students/{urllib.parse.quote(r.name)}/index.html">{html.escape(r.name)}</a></td>'
        f'<td class="number">{words.points(r.score)} / {r.max_score:g}</td>'
        f"<td>{html.escape('; '.join(r.data['notes']))}</td></tr>\n" for r in records)
    return ('<h2>Submissions</h2>\n<table>\n<tr><th>submission</th><th class="number">points</th><th>notes</th></tr>\n'
            f"{rows}</table>\n")


def _limits(records: list[Record]) -> str:
    limits = sorted({limit for record in records for limit in record.data["limits_not_enforced"]})
    if not limits:
        return ""
    return ("<h2>What this machine does not enforce</h2>\n<ul>\n"
            + "".join(f"<li>{html.escape(limit)}</li>\n" for limit in limits) + "</ul>\n")


def student_folder(out: pathlib.Path, name: str) -> pathlib.Path:
    return out / "students" / name
