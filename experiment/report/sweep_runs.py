# SPDX-License-Identifier: Apache-2.0
"""The runs of a sweep as values, read from its runs.csv. docs/outputs.md describes the file."""

import csv
import io
import math
import pathlib
from dataclasses import dataclass

BEFORE_QUANTITIES = ("index", "mode", "seed", "state", "reason", "digest")
WALL_TIME = ("wall_time_s", "real_time_factor")  # differ from repetition to repetition
YES_OR_NO = ("completed", "disturbed")
TIME_TO_FINISH = "sim_time_s"  # censored where `completed` is 0: the run reached its time limit
ZERO_IS_NONE = ("round_trip_mean_s", "exchange_mean_s")  # 0 where nothing happened that has a duration

Cell = tuple[str, ...]  # a level of each factor, in the order of Sweep.factors


class BrokenSweep(Exception):
    """The folder holds no readable sweep; the text gives the file, the place and the reason."""


@dataclass(frozen=True)
class Value:
    """A number of one run."""

    number: float
    known: bool = True  # False: censored, the true number is larger


@dataclass(frozen=True)
class SweepRun:
    cell: Cell
    seed: int
    done: bool
    numbers: dict[str, float]  # by quantity, those that it has

    def value(self, quantity: str) -> Value | None:
        """None: the run has no such number."""
        number = self.numbers.get(quantity)
        if number is None or (quantity in ZERO_IS_NONE and number == 0):
            return None
        return Value(number, quantity != TIME_TO_FINISH or self.numbers.get("completed") != 0)


@dataclass(frozen=True)
class Sweep:
    factors: tuple[str, ...]  # `mode`, then the keys that are axes
    quantities: tuple[str, ...]  # without those that are wall time
    runs: tuple[SweepRun, ...]

    def cells(self) -> list[Cell]:
        """The settings of the factors, each once, in order of appearance."""
        return list(dict.fromkeys(run.cell for run in self.runs))

    def of(self, cell: Cell) -> list[SweepRun]:
        return [run for run in self.runs if run.cell == cell]

    def levels(self, factor: str) -> list[str]:
        """In order of appearance."""
        place = self.factors.index(factor)
        return list(dict.fromkeys(run.cell[place] for run in self.runs))

    def varied(self) -> list[str]:
        """The factors with more than one level."""
        return [factor for factor in self.factors if len(self.levels(factor)) > 1]


def is_axis(column: str) -> bool:
    """Axes are named after keys of the scenario, which stand in tables."""
    return "." in column


def read_sweep(folder: pathlib.Path) -> Sweep:
    """@raises BrokenSweep"""
    file = folder / "runs.csv"
    try:
        text = file.read_text(encoding="utf-8")
    except FileNotFoundError as error:
        raise BrokenSweep(f"{folder}: is not the folder of a sweep: it has no runs.csv") from error
    except OSError as error:
        raise BrokenSweep(f"{file}: {error.strerror}") from error
    except ValueError as error:
        raise BrokenSweep(f"{file}: is not text in UTF-8") from error
    if not text.endswith("\n"):
        raise BrokenSweep(f"{file}: its last row is cut off; write it again with caravan sweep ... --summarise")
    rows = list(csv.reader(io.StringIO(text)))
    header = rows[0]
    lacking = [name for name in BEFORE_QUANTITIES if name not in header]
    if lacking or len(set(header)) != len(header):
        raise BrokenSweep(f"{file}:1: is not the heading of a sweep: "
                          + (f"column {lacking[0]} is missing" if lacking else "a column stands there twice"))
    axes = tuple(name for name in header if is_axis(name))
    quantities = tuple(name for name in header if name not in BEFORE_QUANTITIES and not is_axis(name))
    runs = tuple(_run(f"{file}: row {number}", header, row, axes, quantities)
                 for number, row in enumerate(rows[1:], start=2))
    if not runs:
        raise BrokenSweep(f"{file}: has no run")
    seen = set()
    for number, run in enumerate(runs, start=2):
        if (run.cell, run.seed) in seen:
            raise BrokenSweep(f"{file}: row {number}: the same settings and seed stand in an earlier row")
        seen.add((run.cell, run.seed))
    return Sweep(("mode", *axes), tuple(name for name in quantities if name not in WALL_TIME), runs)


def _run(where: str, header: list[str], row: list[str], axes: tuple[str, ...], quantities: tuple[str, ...]) -> SweepRun:
    if len(row) != len(header):
        raise BrokenSweep(f"{where}: {len(row)} fields instead of {len(header)}")
    fields = dict(zip(header, row))
    if not fields["seed"].isdigit():
        raise BrokenSweep(f"{where}: seed {fields['seed'][:40]!r} is not a whole number")
    done = fields["state"] == "done"
    numbers = {name: _number(where, name, fields[name]) for name in quantities if done and fields[name] != ""}
    for name in YES_OR_NO:
        if numbers.get(name, 0.0) not in (0.0, 1.0):
            raise BrokenSweep(f"{where}: {name} {fields[name][:40]!r} is neither 0 nor 1")
    return SweepRun((fields["mode"], *(fields[axis] for axis in axes)), int(fields["seed"]), done, numbers)


def _number(where: str, name: str, text: str) -> float:
    try:
        number = float(text)
    except ValueError:
        number = math.nan
    if not math.isfinite(number):
        raise BrokenSweep(f"{where}: {name} {text[:40]!r} is not a number")
    return number
