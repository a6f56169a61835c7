# SPDX-License-Identifier: Apache-2.0
"""The report as one self-contained page."""

import datetime
import html
import pathlib
import re

from find_runs import Skipped
from picture import ByMode, Picture
from quantities import QUANTITIES, summary
from style import MODE_NAMES

LOOKS = """
body { font: 15px/1.5 system-ui, sans-serif; color: #222; max-width: 62rem; margin: 2rem auto; padding: 0 1rem; }
h1 { font-size: 1.6rem; margin-bottom: 0; } h2 { font-size: 1.15rem; margin: 2.2rem 0 0.4rem; }
figure { margin: 0; } figure svg { max-width: 100%; height: auto; }
figcaption, .note { color: #555; font-size: 0.88rem; }
table { border-collapse: collapse; font-size: 0.85rem; font-variant-numeric: tabular-nums; }
th, td { padding: 0.2rem 0.8rem 0.2rem 0; text-align: left; border-bottom: 1px solid #e2e2e2; vertical-align: top; }
.bad { color: #a3290b; } nav a { margin-right: 1em; } .wide { overflow-x: auto; }
"""


def inline_svg(file: pathlib.Path) -> str:
    """The drawing without the header of an SVG file."""
    text = file.read_text(encoding="utf-8")
    return text[text.index("<svg"):]


def named_apart(svg: str, name: str) -> str:
    """Prefixes its inner names with `name`, so that those of several drawings on one page do not clash."""
    svg = re.sub(r'\bid="', f'id="{name}-', svg)
    return re.sub(r'(url\(#|href="#)', rf"\g<1>{name}-", svg)


def number_table(runs: ByMode) -> str:
    head = "".join(f"<th>{html.escape(MODE_NAMES[mode])}</th>" for mode in runs)
    rows = [f"<tr><td>runs (completed)</td>{''.join(_counts(those) for those in runs.values())}</tr>"]
    for quantity in QUANTITIES:
        cells = "".join(f"<td>{html.escape(summary(quantity, those))}</td>" for those in runs.values())
        rows.append(f"<tr><td>{html.escape(quantity.name)}</td>{cells}</tr>")
    return f'<div class="wide"><table><tr><th>median (least to most)</th>{head}</tr>{"".join(rows)}</table></div>'


def _counts(runs) -> str:
    completed = sum(run.metrics["completed"] for run in runs)
    mark = "" if completed == len(runs) else ' class="bad"'
    return f"<td{mark}>{len(runs)} ({completed})</td>"


def run_table(runs: ByMode) -> str:
    names = ("mode", "seed", "state", "items", "time, min", "found", "received", "without", "exchanges", "failed",
             "routes", "folder")
    rows = [f"<tr>{''.join(f'<th>{name}</th>' for name in names)}</tr>"]
    for mode, those in runs.items():
        for run in those:
            robots = run.metrics["per_robot"]
            found = sum(robot["found_s"] is not None for robot in robots)
            received = sum(robot["received_s"] is not None for robot in robots)
            state = run.state + (", disturbed" if run.metrics.get("disturbed") else "")
            cells = (mode, run.seed, state, f"{run.metrics['items_delivered']} of {run.items_wanted}",
                     f"{run.end_s / 60:.1f}", found, received, len(robots) - found - received,
                     run.metrics["exchanges"]["completed"], run.metrics["exchanges"]["failed"], run.metrics["routes"],
                     run.folder)
            mark = "" if run.metrics["completed"] else ' class="bad"'
            rows.append(f"<tr{mark}>{''.join(f'<td>{html.escape(str(cell))}</td>' for cell in cells)}</tr>")
    return f'<div class="wide"><table>{"".join(rows)}</table></div>'


def skipped_list(skipped: list[Skipped]) -> str:
    if not skipped:
        return ""
    items = "".join(f"<li>{html.escape(str(one.folder))}: {html.escape(one.reason)}</li>" for one in skipped)
    return f'<h2 id="skipped">Skipped</h2><p class="bad">{len(skipped)} without a readable run:</p><ul>{items}</ul>'


def drawing_text(name: str, title: str, caption: str, file: pathlib.Path) -> str:
    return (f'<h2 id="{name}">{html.escape(title)}</h2><figure>{named_apart(inline_svg(file), name)}'
            f"<figcaption>{html.escape(caption)} Files: figures/{name}.svg and .png</figcaption></figure>")


def page(title: str, runs: ByMode, skipped: list[Skipped], drawn: list[tuple[Picture, pathlib.Path]],
         statistics: str = "") -> str:
    """@param statistics  the part about sweeps, in HTML"""
    count = sum(len(those) for those in runs.values())
    written = datetime.datetime.now().strftime("%Y-%m-%d %H:%M")
    links = "".join(f'<a href="#{picture.name}">{html.escape(picture.title)}</a>' for picture, _ in drawn)
    figures = "".join(drawing_text(picture.name, picture.title, picture.caption(runs), file) for picture, file in drawn)
    links += '<a href="#statistics">Statistics</a>' if statistics else ""
    left_out = f', <a class="bad" href="#skipped">{len(skipped)} skipped</a>' if skipped else ""
    return (f'<!DOCTYPE html><html lang="en"><head><meta charset="utf-8"><title>{html.escape(title)}</title>'
            f'<meta name="viewport" content="width=device-width"><style>{LOOKS}</style></head><body>'
            f'<h1>{html.escape(title)}</h1><p class="note">{count} run{"s" if count != 1 else ""}{left_out}; '
            f"written by caravan report, {written}. Times are simulated.</p><nav>{links}</nav>"
            f'<h2 id="numbers">Numbers</h2>{number_table(runs)}{statistics}{figures}'
            f'<h2 id="runs">Runs</h2>{run_table(runs)}{skipped_list(skipped)}</body></html>\n')
