#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures how fast the embedded engine runs a controller in Python, beside the same one in C++ and the paper's agent.

Runs of paper.toml's arena, in turns; the median of each is printed: simulated time over wall time, and what one step of one
robot takes of the wall time, with the conversion of its values."""

import argparse
import json
import pathlib
import statistics
import subprocess
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
STEP_S = 0.032


def one_run(options, controller):
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "run"
        subprocess.run([options.bin / "caravan", "run", ROOT / "deploy/scenarios/paper.toml", "--engine", "embedded", "--robots",
                        str(options.robots), "--items", "0", "--max-time", str(options.seconds), "--quiet", "--out", out,
                        "--controller", controller], check=True)
        metrics = json.loads((out / "metrics.json").read_text())
    step_us = 1e6 * metrics["time_split"]["agents"] / (options.robots * metrics["sim_time_s"] / STEP_S)
    return metrics["sim_time_s"] / metrics["wall_time_s"], step_us, metrics["digest"]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--bin", type=pathlib.Path, default=ROOT / "build/release/bin")
    parser.add_argument("--robots", type=int, default=15)
    parser.add_argument("--seconds", type=int, default=120, help="simulated")
    parser.add_argument("--repetitions", type=int, default=5)
    options = parser.parse_args()
    controllers = {"paper": "paper", "braitenberg.so": options.bin.parent / "controllers/braitenberg.so",
                   "braitenberg.py": ROOT / "deploy/controllers/braitenberg.py"}
    runs = {name: [] for name in controllers}
    for _ in range(options.repetitions):
        for name, controller in controllers.items():
            runs[name].append(one_run(options, controller))
    print(f"{'controller':16} {'x real':>8} {'us/step':>8}  digest     {options.robots} robots")
    for name, results in runs.items():
        print(f"{name:16} {statistics.median(r[0] for r in results):8.1f} {statistics.median(r[1] for r in results):8.2f}"
              f"  {results[0][2]}")


if __name__ == "__main__":
    main()
