# SPDX-License-Identifier: Apache-2.0
"""Tables of sweeps made by hand."""

import pathlib

LIMIT_S = 3600.0
QUANTITIES = ("completed", "disturbed", "sim_time_s", "wall_time_s", "round_trip_mean_s", "routes")


def row(mode: str, seed: int, sim_time_s: float | None, axes: tuple[str, ...] = (), routes: int = 1, state: str = "done") -> list[str]:
    """None: the run reached its time limit."""
    if state != "done":
        return [mode, str(seed), state, "crashed", "", *axes, "", "", "", "", "", ""]
    time_s = LIMIT_S if sim_time_s is None else sim_time_s
    return [mode, str(seed), state, "", "00", *axes, str(int(sim_time_s is not None)), "0", str(time_s), "1.5", "0", str(routes)]


def make_sweep(folder: pathlib.Path, rows: list[list[str]], axes: tuple[str, ...] = ()) -> pathlib.Path:
    folder.mkdir(parents=True, exist_ok=True)
    lines = [",".join(("index", "mode", "seed", "state", "reason", "digest", *axes, *QUANTITIES))]
    lines += [",".join((str(index), *fields)) for index, fields in enumerate(rows)]
    (folder / "runs.csv").write_text("\n".join(lines) + "\n", encoding="utf-8")
    return folder
