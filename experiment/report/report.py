#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Draws the report of recorded runs: report.html, one self-contained page, and its figures as SVG and PNG."""

import argparse
import concurrent.futures
import os
import pathlib
import sys

sys.dont_write_bytecode = True  # leaves the source tree unchanged

try:
    import style
except ImportError as missing:
    print(f"caravan report: needs python3-matplotlib ({missing})", file=sys.stderr)
    sys.exit(2)

import matplotlib.pyplot as plt  # noqa: E402  (after the check above)

import figures_map  # noqa: E402
import figures_robots  # noqa: E402
import figures_time  # noqa: E402
from find_runs import Skipped, find_sweeps, read_all  # noqa: E402
from page import drawing_text, page  # noqa: E402
from picture import ByMode, Picture  # noqa: E402
from quantities import by_mode  # noqa: E402
from sweep_runs import BrokenSweep, read_sweep  # noqa: E402

try:
    import sweep_page
except ImportError as missing:
    sweep_page = None
    WITHOUT_STATISTICS = f"statistics are left out: they need python3-scipy ({missing})"

# In the order of the paper's figures 8 to 13, then those that it does not have.
ORDER = ("final_paths", "final_paths_all_runs", "tracks", "items_per_robot", "robots_with_path", "items_over_time",
         "traffic_map", "exchanges_over_time", "path_length_over_time", "round_trips", "time_budget")
PICTURES = {picture.name: picture
            for picture in (*figures_map.PICTURES, *figures_time.PICTURES, *figures_robots.PICTURES)}


def draw(picture: Picture, runs: ByMode, folder: pathlib.Path) -> pathlib.Path:
    """@return the SVG file; the PNG is next to it"""
    style.set_up()
    fig = picture.draw(runs)
    file = folder / f"{picture.name}.svg"
    fig.savefig(file, metadata={"Date": None})
    fig.savefig(file.with_suffix(".png"), dpi=style.PNG_DPI)
    plt.close(fig)
    return file


def title_of(runs: ByMode) -> str:
    names = sorted({run.metrics["scenario"] for those in runs.values() for run in those})
    return "Caravan: " + ", ".join(names)


def write_report(given: list[pathlib.Path], out: pathlib.Path) -> int:
    """@return the exit code: 0 written, 1 no run could be read"""
    read, skipped = read_all(given)
    for one in skipped:
        print(f"skipped     {one.folder}: {one.reason}", file=sys.stderr)
    if not read:
        print("caravan report: no run to report on", file=sys.stderr)
        return 1
    runs = by_mode(read)
    figures = out / "figures"
    figures.mkdir(parents=True, exist_ok=True)
    chosen = [PICTURES[name] for name in ORDER if PICTURES[name].can_be_drawn(runs)]
    # Forked, so that the workers already have the runs. A picture is passed by name because its functions cannot be sent.
    global shared_runs, shared_folder
    shared_runs, shared_folder = runs, figures
    with concurrent.futures.ProcessPoolExecutor(max_workers=os.cpu_count()) as pool:
        files = list(pool.map(draw_by_name, [picture.name for picture in chosen]))
    statistics = statistics_of_sweeps(find_sweeps(given), figures, skipped)
    text = page(title_of(runs), runs, skipped, list(zip(chosen, files)), statistics)
    (out / "report.html").write_text(text, encoding="utf-8")
    print(f"report      {(out / 'report.html').resolve()}")
    return 0


def statistics_of_sweeps(sweeps: list[pathlib.Path], figures: pathlib.Path, skipped: list[Skipped]) -> str:
    """The part of the page about sweeps; sweeps that cannot be read are added to `skipped`."""
    if sweeps and sweep_page is None:
        print(f"caravan report: {WITHOUT_STATISTICS}", file=sys.stderr)
        skipped.extend(Skipped(folder, WITHOUT_STATISTICS) for folder in sweeps)
        return ""
    text = ""
    for number, folder in enumerate(sweeps, start=1):
        name = "statistics" if number == 1 else f"statistics_{number}"
        try:
            sweep = read_sweep(folder)
        except BrokenSweep as error:
            print(f"caravan report: statistics are left out: {error}", file=sys.stderr)
            skipped.append(Skipped(folder, f"statistics are left out: {error}"))
            continue
        text += sweep_page.section(name, folder, sweep)
        text += "".join(drawing_text(one.name, one.title, one.caption, one.file)
                        for one in sweep_page.draw_effects(name, sweep, figures))
    return text


shared_runs: ByMode = {}
shared_folder = pathlib.Path()


def draw_by_name(name: str) -> pathlib.Path:
    return draw(PICTURES[name], shared_runs, shared_folder)


def main() -> int:
    parser = argparse.ArgumentParser(prog="caravan report", description=__doc__)
    parser.add_argument("folders", nargs="+", type=pathlib.Path, help="folders of runs, or with runs in them")
    parser.add_argument("--out", type=pathlib.Path, help="where to write; without it report/ in the first folder")
    arguments = parser.parse_args()
    out = arguments.out or arguments.folders[0] / "report"
    try:
        return write_report(arguments.folders, out)
    except OSError as error:
        print(f"caravan report: {error}", file=sys.stderr)
        return 2
    except Exception as error:  # pylint: disable=broad-except  # a modified file may cause any error
        print(f"caravan report: the records hold something that no run writes ({type(error).__name__}: {error})",
              file=sys.stderr)
        return 1


if __name__ == "__main__":
    sys.exit(main())
