# SPDX-License-Identifier: Apache-2.0
"""Finds the folders of runs among the given folders."""

import concurrent.futures
import json
import os
import pathlib
from collections.abc import Iterator
from dataclasses import dataclass

from records import BrokenRun, Run, read_run

MARKS = ("metrics.json", "tracks.csv")  # a folder with one of them is the folder of a run
DEPTH = 3  # levels below a given folder that are searched


@dataclass
class Skipped:
    folder: pathlib.Path
    reason: str


def find_folders(given: list[pathlib.Path]) -> tuple[list[pathlib.Path], list[Skipped]]:
    """The folders of runs in and below the given ones, each once, and the paths that cannot be one."""
    found: list[pathlib.Path] = []
    skipped: list[Skipped] = []
    for folder in given:
        if not folder.is_dir():
            skipped.append(Skipped(folder, "is no folder"))
            continue
        inside = list(_runs_below(folder, DEPTH))
        missing = list(_planned_without_run(folder))
        if not inside and not missing:
            skipped.append(Skipped(folder, "holds no run"))
        found += inside
        skipped += missing
    return list(dict.fromkeys(one.resolve() for one in found)), skipped


def find_sweeps(given: list[pathlib.Path]) -> list[pathlib.Path]:
    """The folders of sweeps: the given ones, and those directly in them."""
    candidates = [one for folder in given for one in (folder, *sorted(file.parent for file in folder.glob("*/runs.csv")))]
    return list(dict.fromkeys(one.resolve() for one in candidates if (one / "runs.csv").is_file()))


def _is_run(folder: pathlib.Path) -> bool:
    return any((folder / mark).exists() for mark in MARKS)


def _runs_below(folder: pathlib.Path, depth: int) -> Iterator[pathlib.Path]:
    if _is_run(folder):
        yield folder
        return
    try:
        below = sorted((one for one in folder.iterdir() if one.is_dir()), key=_natural) if depth > 0 else []
    except OSError:
        below = []
    inside = [run for one in below for run in _runs_below(one, depth - 1)]
    if not inside and (folder / "scenario.toml").exists() and not (folder / "sweep.json").exists():
        yield folder  # a run that ended before it recorded anything
    yield from inside


def _planned_without_run(sweep: pathlib.Path) -> Iterator[Skipped]:
    """The runs of a sweep without any files."""
    try:
        planned = json.loads((sweep / "sweep.json").read_text(encoding="utf-8"))["runs"]
        for run in planned:
            folder = sweep / run["folder"]
            if not _is_run(folder) and not (folder / "scenario.toml").exists():
                yield Skipped(folder, ": ".join(part for part in (run["state"], run.get("reason", "")) if part))
    except FileNotFoundError:
        return
    except (OSError, ValueError, KeyError, TypeError) as error:
        yield Skipped(sweep / "sweep.json", f"cannot be read: {error}")


def _natural(folder: pathlib.Path) -> list[tuple[int, str]]:
    """Sorts seed_2 before seed_10."""
    parts = "".join(letter if letter.isdigit() else f" {letter} " for letter in folder.name).split()
    return [(int(part), "") if part.isdigit() else (-1, part) for part in parts]


def _read(folder: pathlib.Path) -> Run | Skipped:
    try:
        return read_run(folder)
    except BrokenRun as broken:
        return Skipped(folder, str(broken))


def read_all(given: list[pathlib.Path]) -> tuple[list[Run], list[Skipped]]:
    """Every readable run, and what was skipped, with the reason."""
    folders, skipped = find_folders(given)
    if len(folders) > 1:
        with concurrent.futures.ProcessPoolExecutor(max_workers=os.cpu_count()) as pool:
            results = list(pool.map(_read, folders))
    else:
        results = [_read(folder) for folder in folders]
    runs = [one for one in results if isinstance(one, Run)]
    skipped += [one for one in results if isinstance(one, Skipped)]
    return runs, skipped
