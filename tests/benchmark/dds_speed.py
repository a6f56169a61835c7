#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures how fast the lockstep runs over DDS, compared with the same messages and barrier over pipes with one process per agent.

One table. Each row runs some pairs, a DDS run and then the floor, all rows in turn; medians are printed. `still` has no
physics: the world server's shell around a static world, compared with pipes alone. `world` is the real world server,
compared with pipes whose world spends the time that physics and sensors took in the DDS run of the pair. CPU is the processor time of
all processes per step, without start and end; it says more than steps/s where the machine has other work, too."""

import argparse
import pathlib
import statistics

from dds_runs import ROOT, Pair, Setting, measure, start_cpu_s

PLACEMENTS = [Setting(agents_per_process=k, still=still) for still in (True, False) for k in (1, 2, 15)]
TRANSPORT = [Setting(transport="udp")]
SIZES = [Setting(robots=n) for n in (1, 5, 30, 60)] + [Setting(robots=60, agents_per_process=10)]


def command_line() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--pairs", type=int, default=5)
    parser.add_argument("--steps", type=int, default=4000)
    parser.add_argument("--only", choices=["placements", "sizes", "all"], default="all")
    parser.add_argument("--bin", type=pathlib.Path, default=ROOT / "build/release/bin")
    return parser.parse_args()


def show(setting: Setting, pairs: list[Pair]) -> None:
    def median(name: str) -> float:
        return statistics.median(getattr(pair, name) for pair in pairs)

    ratios = sorted(pair.ratio for pair in pairs)
    dds = median("dds")
    print(f"| {setting.robots} | {setting.agents_per_process} | {setting.transport} | {'still' if setting.still else 'world'} | "
          f"{dds:.0f} | {dds * 0.032:.1f} | {median('world_us'):.0f} | {median('cpu_us'):.0f} | {median('pipes'):.0f} | "
          f"{median('pipes_cpu_us'):.0f} | "
          f"**{median('ratio'):.2f}** ({ratios[0]:.2f} to {ratios[-1]:.2f}) |", flush=True)


def main() -> None:
    options = command_line()
    rows = {"placements": PLACEMENTS, "sizes": SIZES, "all": PLACEMENTS + TRANSPORT + SIZES}[options.only]
    pairs: dict[Setting, list[Pair]] = {setting: [] for setting in rows}
    start_s = {setting: start_cpu_s(options.bin, setting) for setting in rows}
    for _ in range(options.pairs):
        for setting in rows:
            pairs[setting].append(measure(options.bin, setting, options.steps, start_s[setting]))
    print("| robots | agents a process | transport | world | steps/s | x real time | world, us | CPU, us | pipes, steps/s | pipes' "
          "CPU, us | DDS / pipes |\n|---|---|---|---|---|---|---|---|---|---|---|")
    for setting in rows:
        show(setting, pairs[setting])


if __name__ == "__main__":
    main()
