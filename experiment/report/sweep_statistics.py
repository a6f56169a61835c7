#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the statistics of a sweep: summary.csv, comparisons.csv, and a table for the terminal."""

import argparse
import concurrent.futures
import csv
import decimal
import fcntl
import io
import os
import pathlib
import sys

sys.dont_write_bytecode = True  # leaves the source tree unchanged

try:
    from comparisons import Comparison, Summary, compare_all, summarise
except ImportError as missing:
    print(f"caravan sweep: statistics are left out, they need python3-scipy ({missing}); runs.csv is whole, summary.csv has no "
          "intervals, and there is no comparisons.csv", file=sys.stderr)
    sys.exit(2)

from estimates import Estimate  # noqa: E402  (after the check above)
from sweep_runs import TIME_TO_FINISH, BrokenSweep, Sweep, read_sweep  # noqa: E402

FIVE = ("minimum", "lower_quartile", "median", "upper_quartile", "maximum")
SUMMARY = ("quantity", "n", *FIVE, "used", "censored", "missing", "statistic", "estimate", "relation", "low_95", "high_95")
COMPARISONS = ("quantity", "factor", "level", "reference", "where", "pairs", "unpaired", "equal", "censored", "difference", "relation",
               "low_95", "high_95", "test", "p_value", "p_holm", "rank_biserial")
MOST_LINES = 24  # of each part of the table


def number_text(number: float | None) -> str:
    """The shortest text that reads back as the same number, as in the tables that the sweep writes itself; empty for none."""
    if number is None:
        return ""
    if number in (float("inf"), float("-inf")):
        return str(number)
    if number == 0:
        return "0"
    exact = decimal.Decimal(repr(float(number))).normalize()
    sign, digits, exponent = exact.as_tuple()
    power = len(digits) - 1 + exponent
    all_digits = "".join(map(str, digits))
    fraction = f".{all_digits[1:]}" if len(digits) > 1 else ""
    scientific = f"{'-' if sign else ''}{all_digits[0]}{fraction}e{'-' if power < 0 else '+'}{abs(power):02d}"
    return min(f"{exact:f}", scientific, key=len)


def five_numbers(ordered: tuple[float, ...]) -> list[float | None]:
    """Quantile p of n sorted numbers is at position p (n - 1), counted from 0."""
    if not ordered:
        return [None] * 5
    found = []
    for quarter in range(5):
        below, part = divmod(quarter * (len(ordered) - 1), 4)
        step = part / 4 * (ordered[below + 1] - ordered[below]) if part else 0.0
        found.append(ordered[below] + step)
    return found


def csv_text(rows: list[list[str]]) -> str:
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerows(rows)
    return text.getvalue()


def rounded(number: float | None) -> float | None:
    """Ten digits: the last ones of a bootstrap's interpolation say nothing and may differ between versions of NumPy."""
    return None if number is None else float(f"{number:.10g}")


def estimate_fields(estimate: Estimate) -> list[str]:
    numbers = [number_text(rounded(number)) for number in (estimate.number, estimate.low, estimate.high)]
    return [numbers[0], estimate.relation, *numbers[1:]]


def summary_csv(sweep: Sweep, summaries: list[Summary]) -> str:
    rows = [[*sweep.factors, *SUMMARY]]
    for one in summaries:
        rows.append([*one.cell, one.quantity, str(len(one.plain)), *map(number_text, five_numbers(one.plain)), str(one.used),
                     str(one.censored), str(one.missing), one.estimate.statistic, *estimate_fields(one.estimate)])
    return csv_text(rows)


def comparisons_csv(sweep: Sweep, comparisons: list[Comparison]) -> str:
    rows = [list(COMPARISONS)]
    for one in comparisons:
        tail = [number_text(rounded(number)) for number in (one.result.p_value, one.p_holm, one.result.rank_biserial)]
        rows.append([one.quantity, one.contrast.factor, *one.contrast.names(sweep.factors), one.contrast.where, str(one.pairs),
                     str(one.unpaired), str(one.equal), str(one.censored), *estimate_fields(one.difference), one.result.test, *tail])
    return csv_text(rows)


def with_interval(estimate: Estimate) -> str:
    decimals = 2 if "proportion" in estimate.statistic else 1

    def text(number: float | None) -> str:
        return "-" if number is None else f"{round(number, decimals) + 0.0:.{decimals}f}".replace("-inf", "inf").replace("inf", "unbounded")

    number = " ".join(part for part in (estimate.relation.replace("=", ""), text(estimate.number)) if part)
    return number if estimate.low is None else f"{number} ({text(estimate.low)} to {text(estimate.high)})"


def setting_text(sweep: Sweep, cell: tuple[str, ...]) -> str:
    varied = sweep.varied()
    return " ".join([cell[0], *(f"{name}={cell[i]}" for i, name in enumerate(sweep.factors) if i > 0 and name in varied)])


def lined_up(rows: list[list[str]], note: str) -> str:
    """The first column is aligned left, the others right. Only so many rows."""
    shown = rows[:MOST_LINES + 1]
    widths = [max(len(row[i]) for row in shown) for i in range(len(rows[0]))]
    lines = ["  ".join([row[0].ljust(widths[0]), *(field.rjust(width) for field, width in zip(row[1:], widths[1:]))]).rstrip()
             for row in shown]
    if len(rows) > len(shown):
        lines.append(f"... and {len(rows) - len(shown)} more in {note}")
    return "\n".join(lines) + "\n"


def table(sweep: Sweep, summaries: list[Summary], comparisons: list[Comparison]) -> str:
    """The time to finish; the files have every quantity."""
    rows = [["time to finish, s", "runs", "not finished", "no result", "median (95 % interval)"]]
    rows += [[setting_text(sweep, one.cell), str(one.used), str(one.censored), str(one.missing), with_interval(one.estimate)]
             for one in summaries if one.quantity == TIME_TO_FINISH]
    text = lined_up(rows, "summary.csv")
    chosen = [one for one in comparisons if one.quantity == TIME_TO_FINISH]
    if not chosen:
        return text
    rows = [["difference at the same seed, s", "pairs", "median (95 % interval)", "p", "p (Holm)", "rank-biserial"]]
    for one in chosen:
        level, reference = one.contrast.names(sweep.factors)
        name = " ".join(part for part in (f"{one.contrast.factor} {level} - {reference}", one.contrast.where) if part)
        numbers = ["-" if number is None else f"{number:.2g}" for number in (one.result.p_value, one.p_holm)]
        effect = one.result.rank_biserial
        rows.append([name, str(one.pairs), with_interval(one.difference), *numbers, "-" if effect is None else f"{effect:+.2f}"])
    return (text + "\n" + lined_up(rows, "comparisons.csv")
            + f"p: Wilcoxon's signed-rank test, two-sided; p (Holm): corrected for the {len(chosen)} comparisons of this quantity\n")


def of_quantity(task: tuple[Sweep, str]) -> tuple[list[Summary], list[Comparison]]:
    sweep, quantity = task
    return [summarise(sweep, cell, quantity) for cell in sweep.cells()], compare_all(sweep, quantity)


def statistics_of(sweep: Sweep) -> tuple[list[Summary], list[Comparison]]:
    """Setting by setting, and within it quantity by quantity; comparisons quantity by quantity."""
    with concurrent.futures.ProcessPoolExecutor(max_workers=os.cpu_count()) as pool:
        found = list(pool.map(of_quantity, [(sweep, quantity) for quantity in sweep.quantities]))
    summaries = [found[j][0][i] for i in range(len(sweep.cells())) for j in range(len(found))]
    return summaries, [one for _, comparisons in found for one in comparisons]


def replace(file: pathlib.Path, text: str) -> None:
    fresh = file.with_name(f".{file.name}.fresh")
    fresh.write_text(text, encoding="utf-8")
    os.replace(fresh, file)


def write_statistics(folder: pathlib.Path, quiet: bool) -> int:
    sweep = read_sweep(folder)
    with open(folder / ".tables.lock", "a", encoding="utf-8") as lock:
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            raise BrokenSweep(f"{folder}: another sweep is writing its tables") from None
        except OSError:
            pass  # a file system without locks
        summaries, comparisons = statistics_of(sweep)
        replace(folder / "summary.csv", summary_csv(sweep, summaries))
        replace(folder / "comparisons.csv", comparisons_csv(sweep, comparisons))
    if not quiet:
        print(table(sweep, summaries, comparisons))
    return 0


def main() -> int:
    parser = argparse.ArgumentParser(prog="caravan sweep", description=__doc__)
    parser.add_argument("folder", type=pathlib.Path, help="the folder of a sweep")
    parser.add_argument("--quiet", action="store_true", help="without the table")
    arguments = parser.parse_args()
    try:
        return write_statistics(arguments.folder, arguments.quiet)
    except BrokenSweep as error:
        print(f"caravan sweep: {error}", file=sys.stderr)
        return 2
    except OSError as error:
        print(f"caravan sweep: {error.filename or arguments.folder}: {error.strerror}", file=sys.stderr)
        return 1


if __name__ == "__main__":
    sys.exit(main())
