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
body { font: 15px/1.5 system-ui, sans-serif; margin: 2em auto; max-width: 78em; color: #222; background: #fff }
table { border-collapse: collapse; margin: 1em 0; font-size: 13px } td, th { padding: 2px 10px; text-align: right }
td:first-child, th:first-child { text-align: left; white-space: nowrap }
.words { text-align: left; min-width: 18em } tr:nth-child(even) { background: #f4f4f4 }
.front { font-weight: bold } .dominated { color: #999 } .note { color: #555 } figure { margin: 1em 0; overflow-x: auto }
.scroll { overflow-x: auto } nav { columns: 3; font-size: 13px } nav a { display: block }
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


# The title of the column that holds sentences.
WORDS = "known fault"

# The plot in pixels: the whole, and where its axes begin and end.
WIDTH, HEIGHT = 760, 400
LEFT, RIGHT, TOP, BOTTOM = 90, 745, 15, 320


def log_range(values, padding):
    """From a little below the least to a little above the largest, at least a decade apart."""
    low, high = math.log10(min(values)) - padding, math.log10(max(values)) + padding
    missing = max(0, 1 - (high - low)) / 2
    return low - missing, high + missing


def labels(marks):
    """Where the numbers of points at [(x, y, number)], in pixels, are written so that none covers another or a point: a
    list of (x, y, text), the text's centre. Points on one spot share a label."""
    spots = []
    for x, y, number in marks:
        for spot in spots:
            if math.hypot(spot[0] - x, spot[1] - y) < 7:
                spot[2].append(number)
                break
        else:
            spots.append((x, y, [number]))
    taken = [(x - 5, y - 5, x + 5, y + 5) for x, y, _ in spots]
    placed = []
    for x, y, numbers in spots:
        text = ", ".join(map(str, sorted(numbers)))
        half = 4 * len(text) + 1
        places = [(x + side * (8 + half + far), y + down) for far in (0, 12, 30)
                  for down in (-9, 9, 0, -18, 18) for side in (1, -1)]
        places += [(x, y + down) for down in (-15, 15, -28, 28)]
        def box(place):
            return place[0] - half, place[1] - 8, place[0] + half, place[1] + 8
        def free(place):
            left, top, right, bottom = box(place)
            inside = LEFT < left and right < RIGHT and TOP < top and bottom < BOTTOM
            return inside and not any(left < r and l < right and top < b and t < bottom for l, t, r, b in taken)
        place = next(filter(free, places), places[0])
        taken.append(box(place))
        placed.append((*place, text))
    return placed


def tics(first, last):
    """The numbers to write on a log axis: 1, 2 and 5 of every decade, or the decades alone where there are many."""
    steps = (1, 2, 5) if last - first < 2.5 else (1,)
    values = [step * 10.0 ** decade for decade in range(math.floor(first), math.ceil(last) + 1) for step in steps]
    return "(" + ", ".join(f'"{value:g}" {value}' for value in values) + ")"


def decades(first, last):
    """Powers of ten within a range, a dozen at the most."""
    exponents = range(math.ceil(first), math.floor(last) + 1)
    return "(" + ", ".join(f'"1e{n}" 1e{n}' for n in exponents[::math.ceil(max(len(exponents), 1) / 12)]) + ")"


class Axes:
    """Where a ladder's points are in its plot: time to the right, error upward, both by their logarithms; an error of 0 is on
    a line of its own, at `zero`."""

    def __init__(self, points):
        errors = [error for _, _, error in points if error > 0] or [1]
        low, self.top = log_range(errors, 0.2)
        self.zero = 10 ** (math.floor(low) - 1)
        self.has_zero = any(error == 0 for _, _, error in points)
        self.bottom = math.log10(self.zero) - 0.4 if self.has_zero else low
        self.left, self.right = log_range([time for _, time, _ in points], 0.15)

    def shown(self, error):
        return error if error > 0 else self.zero

    def in_pixels(self, time, error):
        return (LEFT + (RIGHT - LEFT) * (math.log10(time) - self.left) / (self.right - self.left),
                BOTTOM - (BOTTOM - TOP) * (math.log10(self.shown(error)) - self.bottom) / (self.top - self.bottom))

    def script(self):
        zero = f'set ytics add ("0" {self.zero})' if self.has_zero else ""
        return f"""
set lmargin at screen {LEFT / WIDTH}
set rmargin at screen {RIGHT / WIDTH}
set tmargin at screen {1 - TOP / HEIGHT}
set bmargin at screen {1 - BOTTOM / HEIGHT}
set logscale xy
set xrange [{10 ** self.left}:{10 ** self.right}]
set yrange [{10 ** self.bottom}:{10 ** self.top}]
set xtics {tics(self.left, self.right)}
set ytics {decades(max(self.bottom, math.log10(self.zero) + 0.5), self.top)}
{zero}
set grid"""


def plot_script(rungs, number):
    """What gnuplot is told: the front drawn, what is off it hollow; rungs are numbered as in the table."""
    points = plotted(rungs)
    axes = Axes(points)
    front = sorted(pareto_front(points), key=lambda point: point[1])
    groups = [(front, "linespoints pt 7 lw 2", "#1f6fb4", "Pareto front"),
              ([point for point in points if point not in front], "points pt 6", "#888888", "dominated")]
    marks = [(*axes.in_pixels(time, error), rungs.index(rung) + 1) for rung, time, error in points]
    lines = [f'set terminal svg size {WIDTH},{HEIGHT} noenhanced font "sans-serif,13" background "white" name "plot{number}"',
             axes.script(),
             f"set xlabel {text('nanoseconds per ' + rungs[0]['unit'] + ' (median)')}",
             f"set ylabel {text(rungs[0]['plotted_error'])} offset -1",
             "set key at screen 0.55,0.03 center horizontal"]
    lines += [f"set label {text(name)} at screen {x / WIDTH},{1 - y / HEIGHT} center front" for x, y, name in labels(marks)]
    curves = []
    for index, (group, style, color, title) in enumerate(groups):
        if group:
            lines += [f"$group{index} << END", *(f"{time} {axes.shown(error)}" for _, time, error in group), "END"]
            curves.append(f'$group{index} using 1:2 with {style} ps 0.9 lc rgb "{color}" title "{title}"')
    return "\n".join(lines + ["plot " + ", ".join(curves)]) + "\n"


def plot(title, rungs, number):
    """The SVG of a ladder."""
    try:
        result = subprocess.run(["gnuplot"], input=plot_script(rungs, number), capture_output=True, text=True, check=False)
    except FileNotFoundError as error:
        raise BadInput("gnuplot is not installed (Debian: gnuplot-nox)") from error
    if result.returncode != 0 or "<svg" not in result.stdout:
        raise BadInput(f"gnuplot cannot plot {title}: {result.stderr.strip()}")
    return result.stdout[result.stdout.index("<svg"):]


def table(header, rows):
    def cells(tag, row):
        return "".join(f'<{tag} class="words">{html.escape(value)}</{tag}>' if title == WORDS else f"<{tag}>{html.escape(value)}</{tag}>"
                       for title, value in zip(header, row))
    body = "".join(f'<tr class="{kind}">{cells("td", row)}</tr>\n' for kind, row in rows)
    return f'<div class="scroll"><table><tr>{cells("th", header)}</tr>\n{body}</table></div>'


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
    return table(header + names + [WORDS], rows)


def engine_section(results):
    rows = [("", [f"{r['scene']}, {r['shading']}", str(r["threads"]), f"{r['ours_ms']:.2f}", f"{r['peer_ms']:.2f}",
                  f"{r['ratio']:.1f}", f"{r['cpu_ratio']:.1f}", f"{r['coverage_difference_per_million']:.1f}",
                  f"{r['color_difference_per_million']:.1f}"]) for r in results]
    return ("<h2 id=\"engine\">The engine against llvmpipe</h2>\n" +
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
    links = [(f"ladder{number}", name) for number, (_, name) in enumerate(ladders)]
    if engine.is_file():
        links.append(("engine", "The engine against llvmpipe"))
    parts.append("<nav>" + "".join(f'<a href="#{to}">{html.escape(name)}</a>' for to, name in links) + "</nav>")
    for number, ((_, name), rungs) in enumerate(ladders.items()):
        parts.append(f'<section id="ladder{number}"><h2>{html.escape(name)}</h2>')
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
