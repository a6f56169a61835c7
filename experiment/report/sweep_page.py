# SPDX-License-Identifier: Apache-2.0
"""The statistics of sweeps as a part of the report."""

import html
import itertools
import pathlib
from dataclasses import dataclass

import matplotlib.pyplot as plt

import style
from comparisons import Comparison, Summary
from effects import Effect, effect
from figures_factors import interactions, main_effects
from sweep_runs import TIME_TO_FINISH, Sweep
from sweep_statistics import setting_text, statistics_of, with_interval

SHOWN = (TIME_TO_FINISH, "completed", "items_delivered", "round_trip_mean_s", "routes", "path_length_mean_m")
PLOTTED = (TIME_TO_FINISH, "round_trip_mean_s", "path_length_mean_m")


@dataclass(frozen=True)
class Drawing:
    name: str
    title: str
    caption: str
    file: pathlib.Path


def _table(heading: tuple[str, ...], rows: list[tuple[str, ...]]) -> str:
    lines = [f"<tr>{''.join(f'<th>{html.escape(name)}</th>' for name in heading)}</tr>"]
    lines += [f"<tr>{''.join(f'<td>{html.escape(field)}</td>' for field in row)}</tr>" for row in rows]
    return f'<div class="wide"><table>{"".join(lines)}</table></div>'


def estimates_table(sweep: Sweep, summaries: list[Summary]) -> str:
    rows = [(one.quantity, setting_text(sweep, one.cell), str(one.used), str(one.censored), str(one.missing), one.estimate.statistic,
             with_interval(one.estimate)) for quantity in SHOWN for one in summaries if one.quantity == quantity and one.used > 0]
    return _table(("quantity", "setting", "runs", "not finished", "no result", "estimate", "95 % interval in parentheses"), rows)


def comparisons_table(sweep: Sweep, comparisons: list[Comparison]) -> str:
    rows = []
    for one in (one for quantity in SHOWN for one in comparisons if one.quantity == quantity and one.pairs > 0):
        level, reference = one.contrast.names(sweep.factors)
        numbers = ["-" if number is None else f"{number:.2g}" for number in (one.result.p_value, one.p_holm)]
        effect_size = "-" if one.result.rank_biserial is None else f"{one.result.rank_biserial:+.2f}"
        rows.append((one.quantity, f"{one.contrast.factor}: {level} - {reference}", one.contrast.where, f"{one.pairs} ({one.unpaired})",
                     f"{one.equal}", f"{one.censored}", with_interval(one.difference), one.result.test, *numbers, effect_size))
    return _table(("quantity", "difference", "at", "pairs (without)", "equal", "not finished", "median (95 % interval)", "test", "p",
                   "p (Holm)", "rank-biserial"), rows)


def section(name: str, folder: pathlib.Path, sweep: Sweep) -> str:
    """Two tables; what is left out is in the files."""
    summaries, comparisons = statistics_of(sweep)
    counts = sorted({sum(one.quantity == quantity for one in comparisons) for quantity in SHOWN if quantity in sweep.quantities})
    text = (f'<h2 id="{name}">Statistics of {html.escape(folder.name)}</h2><p class="note">Medians over seeds with bootstrap intervals. A run '
            "that did not finish counts as longer than every run that did. Differences are taken seed by seed; p is that of Wilcoxon's "
            "signed-rank test (completed: of McNemar's). ")
    if comparisons:
        text += (f"p (Holm) is corrected for the {counts[-1]} comparisons of its quantity, not for the number of quantities: choose the "
                 "quantity before looking. ")
    if any(factor != "mode" for factor in sweep.varied()):
        text += "Numbers and figures outside of this part combine all settings of a mode. "
    text += f"All quantities: summary.csv and comparisons.csv in {html.escape(str(folder))}.</p>{estimates_table(sweep, summaries)}"
    return text + (f"<p></p>{comparisons_table(sweep, comparisons)}" if comparisons else "")


def effects_of(sweep: Sweep) -> tuple[list[Effect], list[Effect]]:
    """Main effects, and interactions of the time to finish."""
    varied = sweep.varied()
    alone = [found for quantity in PLOTTED if quantity in sweep.quantities for factor in varied
             if (found := effect(sweep, (factor,), quantity)) is not None]
    pairs = [found for one, other in itertools.combinations(varied, 2)
             if (found := effect(sweep, (other, one), TIME_TO_FINISH)) is not None]
    return alone, pairs


CAPTION = ("Medians over seeds with 95 % intervals, over the settings of the other factors that occur with every level; a seed counts once. "
           "Hollow marks are lower bounds, arrows intervals without an upper end: runs did not finish.")


def draw_effects(name: str, sweep: Sweep, folder: pathlib.Path) -> list[Drawing]:
    alone, pairs = effects_of(sweep)
    drawn = []
    for kind, title, effects, draw in (("main_effects", "Main effects", alone, main_effects),
                                       ("interactions", "Interactions", pairs, interactions)):
        if not effects:
            continue
        style.set_up()
        fig = draw(effects)
        file = folder / f"{kind}{name.removeprefix('statistics')}.svg"
        fig.savefig(file, metadata={"Date": None})
        fig.savefig(file.with_suffix(".png"), dpi=style.PNG_DPI)
        plt.close(fig)
        more = "" if kind == "main_effects" else " Parallel lines: the two factors do not interact."
        drawn.append(Drawing(file.stem, title, CAPTION + more, file))
    return drawn
