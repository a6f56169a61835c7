# SPDX-License-Identifier: Apache-2.0
"""Figures over the map of the world."""

import numpy as np
from matplotlib.colors import LogNorm
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

import style
import world_map
from picture import ByMode, Picture
from quantities import typical
from traffic import lost_to_traffic_map

CELLS = 50  # number of cells along the longer side of the arena


def map_row(count: int) -> tuple[Figure, list]:
    width = style.PAGE_IN if count > 1 else style.COLUMN_IN
    fig, axes = style.figure(width, width / count + 0.55, columns=count, sharey=True)
    axes[0].set_ylabel("y, north (m)")
    return fig, axes


def draw_final_paths(runs: ByMode) -> Figure:
    fig, all_axes = map_row(len(runs))
    robots = 0
    for axes, (mode, those) in zip(all_axes, runs.items()):
        run = typical(those)
        robots = max(robots, run.robots)
        world_map.draw(axes, run.scenario)
        for robot, path in run.paths.items():
            axes.plot(path[:, 0], path[:, 1], color=style.robot_colour(robot), linestyle=style.robot_dash(robot),
                      linewidth=1.1, zorder=5, solid_joinstyle="round")
        routes = run.metrics["routes"]
        without = run.robots - len(run.paths)
        axes.set_title(f"{style.MODE_NAMES[mode]}\n{routes} route{'s' if routes != 1 else ''}"
                       + (f", {without} without a path" if without else ""))
    robot_legend(fig, robots)
    return fig


def robot_legend(fig: Figure, robots: int) -> None:
    shown = min(robots, len(style.ROBOT_COLOURS) * len(style.ROBOT_DASHES))
    handles = [Line2D([], [], color=style.robot_colour(robot), linestyle=style.robot_dash(robot), label=str(robot))
               for robot in range(1, shown + 1)]
    fig.legend(handles=handles, loc="upper center", ncol=min(15, shown), handlelength=1.1, columnspacing=1.0,
               bbox_to_anchor=(0.5, 0.0), title="robot", title_fontsize=7)


def draw_all_paths(runs: ByMode) -> Figure:
    fig, all_axes = map_row(len(runs))
    for axes, (mode, those) in zip(all_axes, runs.items()):
        world_map.draw(axes, those[0].scenario)
        paths = [path for run in those for path in run.paths.values()]
        for path in paths:
            axes.plot(path[:, 0], path[:, 1], color=style.MODE_COLOURS[mode], linewidth=0.8,
                      alpha=max(0.05, min(0.6, 12 / len(paths))), zorder=5)
        axes.set_title(f"{style.MODE_NAMES[mode]}\n{len(paths)} paths of {len(those)} runs")
    return fig


def draw_tracks(runs: ByMode) -> Figure:
    fig, all_axes = map_row(len(runs))
    robots = 0
    for axes, (mode, those) in zip(all_axes, runs.items()):
        run = typical(those)
        robots = max(robots, run.robots)
        world_map.draw(axes, run.scenario)
        for index in range(run.robots):
            axes.plot(run.tracks[:, index, 0], run.tracks[:, index, 1], color=style.robot_colour(index + 1),
                      linewidth=0.35, alpha=0.8, zorder=5, rasterized=True)
        axes.set_title(f"{style.MODE_NAMES[mode]}\n{run.end_s / 60:.0f} minutes")
    robot_legend(fig, robots)
    return fig


def draw_traffic_map(runs: ByMode) -> Figure:
    fig, all_axes = map_row(len(runs))
    maps = {}
    for mode, those in runs.items():
        width, height = world_map.arena_m(those[0].scenario)
        cell = max(width, height) / CELLS
        edges_x = np.linspace(-width / 2, width / 2, max(2, round(width / cell)) + 1)
        edges_y = np.linspace(-height / 2, height / 2, max(2, round(height / cell)) + 1)
        area = (edges_x[1] - edges_x[0]) * (edges_y[1] - edges_y[0])
        maps[mode] = (edges_x, edges_y, lost_to_traffic_map(those, edges_x, edges_y), area)
    most = max(float(np.max(lost / area)) for _, _, lost, area in maps.values())
    norm = LogNorm(vmin=max(most, 1e-3) / 1000, vmax=max(most, 1e-3))
    for axes, (mode, (edges_x, edges_y, lost, area)) in zip(all_axes, maps.items()):
        world_map.draw(axes, runs[mode][0].scenario)
        shown = np.ma.masked_less_equal(lost / area, norm.vmin)
        mesh = axes.pcolormesh(edges_x, edges_y, shown, norm=norm, cmap="viridis_r", zorder=4, rasterized=True)
        axes.set_title(f"{style.MODE_NAMES[mode]}\n{np.sum(lost) / 60:.0f} robot minutes a run")
    bar = fig.colorbar(mesh, ax=all_axes, shrink=0.62 if len(runs) > 1 else 0.75, aspect=16, pad=0.01)
    bar.set_label("time lost near another robot\n(robot seconds per m² and run)")
    return fig


def typical_seeds(runs: ByMode) -> str:
    return ", ".join(f"{mode} seed {typical(those).seed}" for mode, those in runs.items())


PICTURES = (
    Picture("final_paths", "Paths at the end of the run",
            lambda runs: "The path that each robot used when the run ended, for the run with the median time in each mode "
            f"({typical_seeds(runs)}). Coinciding paths overlap.", draw_final_paths),
    Picture("final_paths_all_runs", "Paths at the end of all runs",
            lambda runs: "The paths in use at the end of every run; darker where more of them overlap.", draw_all_paths,
            lambda runs: any(len(those) > 1 for those in runs.values())),
    Picture("tracks", "Where the robots drove",
            lambda runs: f"The tracks of all robots, for the run with the median time in each mode ({typical_seeds(runs)}).",
            draw_tracks),
    Picture("traffic_map", "Where robots lose time near each other",
            lambda runs: "Time by which robots with a path fell short of cruise speed while another robot was within "
            "the radio's range, mean over the runs of each mode. White: less than a thousandth of the maximum.",
            draw_traffic_map),
)
