# SPDX-License-Identifier: Apache-2.0
"""The common style of all figures."""

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt  # noqa: E402  (after the choice of the backend)
from matplotlib.axes import Axes  # noqa: E402
from matplotlib.figure import Figure  # noqa: E402

COLUMN_IN = 3.5  # width of one column of a paper, and of two
PAGE_IN = 7.16
PNG_DPI = 300

# Fifteen colours that remain distinguishable in protanopia, deuteranopia and tritanopia; report_test.py measures them.
ROBOT_COLOURS = ("#2f8e4e", "#1f3ffa", "#380942", "#b9bcf9", "#f7b804", "#7d409a", "#85ccac", "#460701", "#445453",
                 "#0c0e98", "#b87b10", "#12db71", "#931a02", "#af7bf6", "#828da5")
ROBOT_DASHES = ("solid", (0, (4, 1.5)), (0, (1, 1.2)), (0, (5, 1.5, 1, 1.5)))  # the next one when the colours are used up

# Okabe and Ito's colours, which colour-blind people can distinguish, with different dashes for print without colour.
MODE_COLOURS = {"none": "#0072b2", "partial": "#e69f00", "full": "#009e73"}
MODE_DASHES = {"none": "solid", "partial": (0, (5, 1.5)), "full": (0, (1.2, 1.2))}
MODE_NAMES = {"none": "no communication", "partial": "partial communication", "full": "full communication"}
ACTIVITY_COLOURS = {"driving": "#56b4e9", "exchanging": "#009e73", "avoiding": "#e69f00", "stuck": "#d55e00",
                    "idle": "#999999"}
OBSTACLE = "#d4d4d4"
INK = "#222222"


def robot_colour(robot: int) -> str:
    return ROBOT_COLOURS[(robot - 1) % len(ROBOT_COLOURS)]


def robot_dash(robot: int):
    return ROBOT_DASHES[((robot - 1) // len(ROBOT_COLOURS)) % len(ROBOT_DASHES)]


def set_up() -> None:
    plt.rcParams.update({
        "font.family": "DejaVu Sans", "font.size": 8, "axes.titlesize": 8.5, "axes.labelsize": 8, "legend.fontsize": 7,
        "xtick.labelsize": 7, "ytick.labelsize": 7, "axes.linewidth": 0.7, "lines.linewidth": 1.4,
        "axes.spines.top": False, "axes.spines.right": False, "axes.edgecolor": INK, "text.color": INK,
        "axes.labelcolor": INK, "xtick.color": INK, "ytick.color": INK, "xtick.major.width": 0.7,
        "ytick.major.width": 0.7, "axes.grid": True, "grid.color": "#e6e6e6", "grid.linewidth": 0.6,
        "axes.axisbelow": True, "legend.frameon": False, "legend.handlelength": 2.6, "savefig.bbox": "tight",
        "savefig.pad_inches": 0.04, "figure.constrained_layout.use": True, "svg.hashsalt": "caravan",
        "svg.fonttype": "path", "image.cmap": "viridis"})


def figure(width_in: float, height_in: float, columns: int = 1, rows: int = 1, **options) -> tuple[Figure, list[Axes]]:
    """A figure and its axes, row by row."""
    fig, axes = plt.subplots(rows, columns, figsize=(width_in, height_in), squeeze=False, **options)
    return fig, list(axes.flat)


def mosaic(width_in: float, height_in: float, plan: list[list[str]]) -> tuple[Figure, dict[str, Axes]]:
    """A figure whose axes are named in a plan of rows; a name repeated is one wide axes."""
    return plt.subplot_mosaic(plan, figsize=(width_in, height_in))


def minutes_axis(axes: Axes, end_s: float) -> None:
    """Simulated minutes, for data in minutes."""
    axes.set_xlabel("simulated time (min)")
    axes.set_xlim(0, end_s / 60)
