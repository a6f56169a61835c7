#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Cost of waiting: processor time of all processes of a run of 15 robots that has nothing to do, in percent of one core.

Three ways to wait: before the start, for a robot that is missing; in the middle of a run that is paused (`caravan ctl pause`); and in
real time, with `--pacing realtime`, for comparison: there 31 steps a second are executed."""

import argparse
import contextlib
import pathlib
import signal
import subprocess
import tempfile
import time
from collections.abc import Iterator

from dds_runs import ROOT

SCENARIO = ROOT / "deploy/scenarios/paper.toml"
ROBOTS = 15
SETTLE_S = 5.0


def command_line() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seconds", type=float, default=20.0, help="to measure over")
    parser.add_argument("--domain", type=int, default=231)
    parser.add_argument("--bin", type=pathlib.Path, default=ROOT / "build/release/bin")
    return parser.parse_args()


def cpu_seconds(pid: int) -> float:
    """Processor time of all its threads, to the nanosecond: /proc/PID/stat counts clock ticks, which miss short wake-ups."""
    return sum(int(one.read_text().split()[0]) for one in pathlib.Path(f"/proc/{pid}/task").glob("*/schedstat")) / 1e9


def descendants(pid: int) -> list[int]:
    children = pathlib.Path(f"/proc/{pid}/task/{pid}/children").read_text().split()
    return [pid] + [one for child in children for one in descendants(int(child))]


def percent(pids: list[int], seconds: float) -> float:
    before, began = sum(map(cpu_seconds, pids)), time.monotonic()
    time.sleep(seconds)
    return 100.0 * (sum(map(cpu_seconds, pids)) - before) / (time.monotonic() - began)


@contextlib.contextmanager
def processes(lines: list[list[str | pathlib.Path]]) -> Iterator[list[int]]:
    running = [subprocess.Popen(line, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) for line in lines]
    try:
        yield [one.pid for one in running]
    finally:
        for one in running:
            one.send_signal(signal.SIGINT)
        for one in running:
            one.wait(timeout=20)


def before_the_start(options: argparse.Namespace) -> float:
    common = ["--scenario", SCENARIO, "--domain", str(options.domain)]
    lines = [[options.bin / "world_server", *common], [options.bin / "radio_emulator", *common]]
    lines += [[options.bin / "robot_agent", *common, "--robot", str(robot)] for robot in range(1, ROBOTS)]
    with processes(lines) as pids:
        time.sleep(SETTLE_S)
        return percent(pids, options.seconds)


def in_a_run(options: argparse.Namespace, arguments: list[str], pause: bool) -> float:
    with tempfile.TemporaryDirectory() as folder:
        line = [options.bin / "caravan", "run", SCENARIO, "--domain", str(options.domain), "--quiet", "--out",
                pathlib.Path(folder) / "run", *arguments]
        with processes([line]) as launcher:
            time.sleep(SETTLE_S)
            if pause:
                subprocess.run([options.bin / "caravan", "ctl", "--domain", str(options.domain), "pause"], check=True)
                time.sleep(SETTLE_S)
            return percent(descendants(launcher[0]), options.seconds)


def main() -> None:
    options = command_line()
    print(f"before the start, one robot missing  {before_the_start(options):.2f} % of one core", flush=True)
    print(f"paused in the middle of a run        {in_a_run(options, [], pause=True):.2f} %", flush=True)
    print(f"at the clock (--pacing realtime)     {in_a_run(options, ['--pacing', 'realtime'], pause=False):.2f} %")


if __name__ == "__main__":
    main()
