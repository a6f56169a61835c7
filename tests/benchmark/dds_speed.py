#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""How fast the lockstep runs over DDS, one process for each agent, against the same messages and barrier over pipes.

Runs pairs: the pipe floor, then the first simulated minutes of a scenario with `caravan run`, on the same machine one after the
other, and prints each pair and the medians. `ratio` has the world's physics on the DDS side only; in `ratio, world` the floor's
world spends the time that physics and sensors took."""

import argparse
import json
import pathlib
import statistics
import subprocess
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent


def command_line():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--pairs", type=int, default=5)
    parser.add_argument("--robots", type=int, default=15)
    parser.add_argument("--sim-seconds", type=float, default=180.0)
    parser.add_argument("--scenario", type=pathlib.Path, default=ROOT / "deploy/scenarios/paper.toml")
    parser.add_argument("--bin", type=pathlib.Path, default=ROOT / "build/release/bin")
    return parser.parse_args()


def pipe_steps_per_s(options, world_us=0):
    line = [options.bin / "pipe_floor", "--robots", str(options.robots), "--world-us", str(world_us)]
    return float(subprocess.run(line, check=True, capture_output=True, text=True).stdout)


def dds_run(options):
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "run"
        line = [options.bin / "caravan", "run", options.scenario, "--robots", str(options.robots), "--max-time",
                str(options.sim_seconds), "--quiet", "--out", out]
        subprocess.run(line, check=False)  # exit code 1: the time ran out, as it must
        return json.loads((out / "metrics.json").read_text())


def main():
    options = command_line()
    rows = []
    print(f"{'pipes/s':>9} {'dds/s':>8} {'x real':>7} {'ratio':>6} {'world us':>9} {'pipes+world/s':>14} {'ratio, world':>13}")
    for _ in range(options.pairs):
        pipes = pipe_steps_per_s(options)
        run = dds_run(options)
        steps = run["sim_time_s"] / 0.032
        dds = steps / run["wall_time_s"]
        world_us = round(1e6 * (run["time_split"]["physics"] + run["time_split"]["sensors"]) / steps)
        pipes_world = pipe_steps_per_s(options, world_us)
        row = (pipes, dds, run["real_time_factor"], dds / pipes, world_us, pipes_world, dds / pipes_world)
        rows.append(row)
        show(row)
    print("median of", options.pairs)
    show([statistics.median(column) for column in zip(*rows)])


def show(row):
    pipes, dds, factor, ratio, world_us, pipes_world, ratio_world = row
    print(f"{pipes:9.0f} {dds:8.0f} {factor:7.1f} {ratio:6.2f} {world_us:9.0f} {pipes_world:14.0f} {ratio_world:13.2f}")


if __name__ == "__main__":
    main()
