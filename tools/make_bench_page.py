#!/usr/bin/env python3
"""Makes out/bench/index.html from the measurements beside it: for each ladder a plot of error against run time, drawn by
gnuplot, and its table; and, where it was measured, the engine against its peer.

A ladder's file is an array of rungs (bench/support/report.h says its fields), the engine's is engine/results.json
(bench/engine/report.h). The page needs no other file.
"""
import argparse
import html
import json
import math
import os
import pathlib
import subprocess
import sys

STYLE = """
body { font: 15px/1.5 system-ui, sans-serif; margin: 2em auto; max-width: 60em; color: #222; background: #fff }
table { border-collapse: collapse; margin: 1em 0 } td, th { padding: 2px 10px; text-align: right }
td:first-child, th:first-child { text-align: left; white-space: nowrap }
td.words { text-align: left; min-width: 18em } tr:nth-child(even) { background: #f4f4f4 }
.front { font-weight: bold } .dominated { color: #999 } .note { color: #555 } figure { margin: 1em 0; overflow-x: auto }
.scroll { overflow-x: auto }
"""


class BadInput(Exception):
    """What is wrong with a file or a program, said in one line."""


def read_json(path):
    try:
        return json.loads(path.read_text(encoding="utf-8"))
    except ValueError as error:
        raise BadInput(f"{path}: expected JSON: {error}") from error


def read_ladders(folder):
    """Lists of rungs by ladder, in the files' order."""
    ladders = {}
    for path in sorted(folder.glob("bench_*.json")):
        for rung in read_json(path):
            try:
                ladders.setdefault((rung["stage"], rung["ladder"]), []).append(rung)
                rung["ns_median"], rung["errors"], rung["plotted_error"], rung["role"]
            except (KeyError, TypeError) as error:
                raise BadInput(f"{path}: expected an array of rungs as bench/support/report.h says: {error!r}") from error
    return ladders


def plotted(rungs):
    """Time and error of the rungs that have the plotted error."""
    return [(rung, rung["ns_median"], rung["errors"][rung["plotted_error"]])
            for rung in rungs if rung["role"] != "limit" and rung["errors"].get(rung["plotted_error"]) is not None]


def pareto_front(points):
    """Those than which no other is at least as quick and as right and one of the two more."""
    def dominates(a, b):
        return a[1] <= b[1] and a[2] <= b[2] and (a[1] < b[1] or a[2] < b[2])
    return [point for point in points if not any(dominates(other, point) for other in points)]


def text(value):
    """A string as gnuplot reads it."""
    return '"' + value.replace("\\", "\\\\").replace('"', '\\"') + '"'


def plot(title, rungs, number):
    """An SVG: error on a log axis against time, 0 on a line of its own below; the front drawn, what is off it hollow. Rungs
    are numbered as in the table."""
    points = plotted(rungs)
    front = sorted(pareto_front(points), key=lambda point: point[1])
    errors = [error for _, _, error in points if error > 0]
    top = 10 ** math.ceil(math.log10(max(errors)) + 0.3) if errors else 1
    bottom = 10 ** math.floor(math.log10(min(errors))) if errors else 0.1
    zero = bottom / 10

    def rows(chosen):
        return "\n".join(f"{time} {error if error > 0 else zero} {rungs.index(rung) + 1}" for rung, time, error in chosen)
    off_front = [point for point in points if point not in front]
    times = [time for _, time, _ in points]
    script = f"""
set terminal svg size 760,380 noenhanced font "sans-serif,13" background "white" name "plot{number}"
set xlabel {text("nanoseconds per " + rungs[0]["unit"] + " (median)")}
set ylabel {text(rungs[0]["plotted_error"])}
set logscale xy
set xrange [{min(times) / 2}:{max(times) * 2}]
set yrange [{zero / 2}:{top * 2}]
set ytics add ("0" {zero})
set grid
set key below
$front << END
{rows(front)}
END
$off << END
{rows(off_front)}
END
plot $front using 1:2 with linespoints pt 7 ps 0.9 lw 2 lc rgb "#1f6fb4" title "Pareto front", \\
     $front using 1:2:3 with labels left offset 0.6,0.6 tc rgb "#1f6fb4" notitle"""
    if off_front:
        script += """, \\
     $off using 1:2 with points pt 6 ps 0.9 lc rgb "#888888" title "dominated", \\
     $off using 1:2:3 with labels left offset 0.6,0.6 tc rgb "#888888" notitle"""
    try:
        result = subprocess.run(["gnuplot"], input=script + "\n", capture_output=True, text=True, check=False)
    except FileNotFoundError as error:
        raise BadInput("gnuplot is not installed (Debian: gnuplot-nox)") from error
    if result.returncode != 0 or "<svg" not in result.stdout:
        raise BadInput(f"gnuplot cannot plot {title}: {result.stderr.strip()}")
    return result.stdout[result.stdout.index("<svg"):]


def table(header, rows):
    cells = "".join(f"<th>{html.escape(title)}</th>" for title in header)
    def cell(value):
        kind = ' class="words"' if value.count(" ") > 1 else ""
        return f"<td{kind}>{html.escape(value)}</td>"
    body = "".join(f'<tr class="{kind}">' + "".join(map(cell, row)) + "</tr>\n" for kind, row in rows)
    return f'<div class="scroll"><table><tr>{cells}</tr>\n{body}</table></div>'


def ladder_table(rungs):
    front = [point[0] for point in pareto_front(plotted(rungs))]
    names = list(rungs[-1]["errors"])
    with_ratio = any("ratio" in rung for rung in rungs)
    header = ["rung", f"ns per {rungs[0]['unit']}", "min", "spread"] + ["times as quick as the peer", "spread"] * with_ratio
    rows = []
    for number, rung in enumerate(rungs, 1):
        row = [f"{number} {rung['rung']}", f"{rung['ns_median']:.3f}", f"{rung['ns_min']:.3f}", f"{rung['ns_spread']:.0%}"]
        if with_ratio:
            row += [f"{rung['ratio']['median']:.2f}", f"{rung['ratio']['spread']:.0%}"]
        row += ["–" if rung["errors"].get(name) is None else f"{rung['errors'][name]:.4g}" for name in names]
        row.append(rung["fault"])
        rows.append(("front" if rung in front else "dominated" if rung["role"] == "rung" else "", row))
    return table(header + names + ["known fault"], rows)


def engine_section(results):
    rows = [("", [f"{r['scene']}, {r['shading']}", str(r["threads"]), f"{r['ours_ms']:.2f}", f"{r['peer_ms']:.2f}",
                  f"{r['ratio']:.1f}", f"{r['cpu_ratio']:.1f}", f"{r['coverage_difference_per_million']:.1f}",
                  f"{r['color_difference_per_million']:.1f}"]) for r in results]
    return ("<h2>The engine against llvmpipe</h2>\n" +
            table(["scene", "threads", "ms", "ms of the peer", "ratio", "ratio of CPU times", "coverage differs, ppm",
                   "colour differs, ppm"], rows))


def page(folder):
    ladders = read_ladders(folder)
    engine = folder / "engine" / "results.json"
    if not ladders and not engine.is_file():
        raise BadInput(f"{folder}: expected measurements, bench_*.json or engine/results.json")
    origins = sorted({f"commit {rung['commit']}, {rung['machine'].strip()}" for rungs in ladders.values() for rung in rungs})
    parts = ["<!doctype html><html lang=\"en\"><meta charset=\"utf-8\"><title>RasterLab: run time against error</title>"
             f"<style>{STYLE}</style><h1>Run time against error</h1>"
             f"<p class=\"note\">{html.escape('; '.join(origins))}. Times are of the processor, one thread; median of the "
             "repetitions, spread the distance of the quartiles by the median. <b>Bold</b>: on the Pareto front, no other "
             "rung is quicker and as right. Grey: dominated. The numbers in a plot are those of its table.</p>"]
    for number, ((stage, name), rungs) in enumerate(ladders.items()):
        parts.append(f"<section><h2>{html.escape(name)}</h2>")
        if plotted(rungs):
            parts.append(f"<figure>{plot(name, rungs, number)}</figure>")
        parts.append(ladder_table(rungs) + "</section>")
    if engine.is_file():
        parts.append(engine_section(read_json(engine)))
    return "\n".join(parts) + "</html>\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--data", type=pathlib.Path, default=pathlib.Path("out/bench"), help="folder of the measurements")
    parser.add_argument("--out", type=pathlib.Path, help="the page; default index.html in that folder")
    arguments = parser.parse_args()
    out = arguments.out or arguments.data / "index.html"
    try:
        content = page(arguments.data)
        part = out.with_name(out.name + ".part")
        part.write_text(content, encoding="utf-8")
        os.replace(part, out)
    except (BadInput, OSError) as error:
        print(f"make_bench_page: {error}", file=sys.stderr)
        return 1
    print(f"wrote {out}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
