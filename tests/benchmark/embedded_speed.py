#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures how fast the embedded engine runs scaling.toml, how it spends its time, and compares it with floors.

Each line comes from one process that runs the parts of a step and the whole step in turns, medians of the repetitions, in
processor time: other processes on the machine hardly change it. `/ physics` compares the whole step with physics alone on
the same motions. Memory is the peak of a `caravan run`. Then a jam of robots that all touch each other, and the lockstep's
messages over pipes without any computation."""

import argparse
import json
import os
import pathlib
import statistics
import subprocess
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
STEP_S = 0.032
PARTS = ("physics", "sonar", "radio_medium", "agent_steps")


def command_line() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--robots", type=int, nargs="+", default=[1, 5, 15, 50, 100, 500, 1000])
    parser.add_argument("--repetitions", type=int, default=5)
    parser.add_argument("--bin", type=pathlib.Path, default=ROOT / "build/release/bin")
    return parser.parse_args()


def medians_us(options: argparse.Namespace, pattern: str) -> dict[str, float]:
    """Median processor time of each benchmark that the pattern names, one step of all robots."""
    line = [options.bin / "embedded_benchmark", f"--benchmark_filter={pattern}", "--benchmark_format=json",
            f"--benchmark_repetitions={options.repetitions}", "--benchmark_enable_random_interleaving=true",
            "--benchmark_min_time=0.2"]
    answer = subprocess.run(line, check=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True).stdout
    times: dict[str, list[float]] = {}
    for one in json.loads(answer)["benchmarks"]:
        if one["run_type"] == "iteration":
            times.setdefault(one["run_name"].split("/")[0], []).append(one["cpu_time"])
    return {name: statistics.median(values) for name, values in times.items()}


def peak_memory_mb(options: argparse.Namespace, robots: int) -> float:
    with tempfile.TemporaryDirectory() as folder:
        line = [options.bin / "caravan", "run", ROOT / "deploy/scenarios/scaling.toml", "--engine", "embedded", "--robots",
                str(robots), "--max-time", "5", "--quiet", "--out", pathlib.Path(folder) / "run"]
        process = subprocess.Popen([str(word) for word in line])
        _, _, usage = os.wait4(process.pid, 0)
        return usage.ru_maxrss / 1024


def pipe_steps_per_s(options: argparse.Namespace, robots: int) -> float:
    line = [options.bin / "pipe_floor", "--robots", str(robots)]
    return float(subprocess.run(line, check=True, capture_output=True, text=True).stdout)


def show_line(options: argparse.Namespace, robots: int) -> None:
    time = medians_us(options, f"^({'|'.join(PARTS)}|whole_step)/{robots}$")
    whole = time["whole_step"]
    shares = [100 * time[part] / whole for part in PARTS]
    print(f"{robots:6d} {1e6 / whole:9.0f} {1e6 * STEP_S / whole:8.1f} {whole / robots:9.2f} {whole / time['physics']:10.2f}"
          + "".join(f" {share:7.0f}" for share in [*shares, 100 - sum(shares)])
          + f" {peak_memory_mb(options, robots):7.0f}", flush=True)


def main() -> None:
    options = command_line()
    print(f"{'robots':>6} {'steps/s':>9} {'x real':>8} {'us/robot':>9} {'/ physics':>10} {'phys %':>7} {'sonar %':>7}"
          f" {'radio %':>7} {'agent %':>7} {'rest %':>7} {'MB':>7}")
    for robots in options.robots:
        show_line(options, robots)
    jam_us = medians_us(options, "^jam/100$")["jam"]
    print(f"jam of 100 robots: {jam_us:.0f} us a step, {1e6 * STEP_S / jam_us:.0f} x real time")
    pipes = [pipe_steps_per_s(options, 15) for _ in range(options.repetitions)]
    print(f"pipes, 15 robots, nothing computed: {statistics.median(pipes):.0f} steps/s (wall time)")


if __name__ == "__main__":
    main()
