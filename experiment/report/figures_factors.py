# SPDX-License-Identifier: Apache-2.0
"""Figures of the factors of a sweep: main effects and interactions, medians over seeds with 95 % intervals."""

import math

from matplotlib.axes import Axes
from matplotlib.figure import Figure

import style
from effects import Effect
from estimates import Estimate

COLOURS = ("#0072b2", "#e69f00", "#009e73", "#cc79a7", "#56b4e9", "#d55e00")  # Okabe and Ito
MARKS = ("o", "s", "D", "v", "P", "X")
DASHES = ("solid", (0, (5, 1.5)), (0, (1.2, 1.2)))
PANEL_IN = (2.3, 1.9)


def places(levels: list[str]) -> list[float]:
    """Numbers where all levels are numbers, otherwise 0, 1, 2, ..."""
    try:
        return [float(level) for level in levels]
    except ValueError:
        return [float(place) for place in range(len(levels))]


def name_levels(axes: Axes, factor: str, levels: list[str]) -> None:
    axes.set_xlabel(factor)
    axes.set_xticks(places(levels), levels)
    span = max(places(levels)) - min(places(levels))
    axes.set_xlim(min(places(levels)) - 0.15 * span, max(places(levels)) + 0.15 * span)


def points(axes: Axes, at: list[float], estimates: list[Estimate], colour: str, mark: str, dash, label: str | None = None) -> None:
    """Hollow: only a lower bound. An interval without an upper end has an arrow at the top of the axes."""
    known = [(x, one) for x, one in zip(at, estimates) if one.number is not None]
    axes.plot([x for x, _ in known], [one.number for _, one in known], color=colour, linestyle=dash, marker=mark, markersize=4, label=label)
    for x, one in known:
        if one.relation != "=":
            axes.plot([x], [one.number], color=colour, marker=mark, markersize=4, markerfacecolor="white", linestyle="none")
        if one.low is None or one.high is None:
            continue
        if math.isinf(one.high):
            axes.annotate("", xy=(x, 1), xycoords=axes.get_xaxis_transform(), xytext=(x, one.low), textcoords="data",
                          arrowprops={"arrowstyle": "->", "color": colour, "linewidth": 0.9, "shrinkA": 0, "shrinkB": 0})
        else:
            axes.plot([x, x], [one.low, one.high], color=colour, linewidth=0.9, marker="_", markersize=5)


def main_effects(effects: list[Effect]) -> Figure:
    """A row for each quantity, a column for each factor."""
    quantities = list(dict.fromkeys(one.quantity for one in effects))
    factors = list(dict.fromkeys(one.factors[0] for one in effects))
    fig, axes = style.figure(max(style.COLUMN_IN, PANEL_IN[0] * len(factors)), PANEL_IN[1] * len(quantities), columns=len(factors),
                             rows=len(quantities), sharey="row")
    for one in effects:
        panel = axes[quantities.index(one.quantity) * len(factors) + factors.index(one.factors[0])]
        levels = [level for level, in one.at]
        points(panel, places(levels), list(one.at.values()), COLOURS[0], MARKS[0], DASHES[0])
        name_levels(panel, one.factors[0], levels)
        panel.margins(y=0.12)
        if one.factors[0] == factors[0]:
            panel.set_ylabel(one.quantity)
    return fig


def interactions(effects: list[Effect]) -> Figure:
    """A panel for each two factors: the first along x, a line for each level of the second. Parallel lines: no interaction."""
    columns = min(3, len(effects))
    rows = math.ceil(len(effects) / columns)
    fig, axes = style.figure(max(style.COLUMN_IN, 1.2 * PANEL_IN[0] * columns), 1.15 * PANEL_IN[1] * rows, columns=columns, rows=rows)
    for panel, one in zip(axes, effects):
        first, second = (list(dict.fromkeys(levels[i] for levels in one.at)) for i in (0, 1))
        span = max(places(first)) - min(places(first))
        for number, level in enumerate(second):
            shift = 0.02 * span * (number - (len(second) - 1) / 2)  # so that intervals do not hide each other
            points(panel, [x + shift for x in places(first)], [one.at[x, level] for x in first], COLOURS[number % len(COLOURS)],
                   MARKS[number % len(MARKS)], DASHES[number % len(DASHES)], level)
        name_levels(panel, one.factors[0], first)
        panel.set_ylabel(one.quantity)
        panel.margins(y=0.12)
        panel.legend(title=one.factors[1], title_fontsize=7, loc="lower left", bbox_to_anchor=(0, 1), ncols=min(4, len(second)))
    for panel in axes[len(effects):]:
        panel.set_visible(False)
    return fig
