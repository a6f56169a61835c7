# SPDX-License-Identifier: Apache-2.0
"""One run over DDS and its floor: the data of the tables in this folder."""

import contextlib
import dataclasses
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator

ROOT = pathlib.Path(__file__).resolve().parents[2]
STEP_S = 0.032
RECEIVING_SHARE = 0.3  # fraction of the robots that receive in each step, in the floor and in still_world.cpp


@dataclasses.dataclass(frozen=True)
class Setting:
    robots: int = 15
    agents_per_process: int = 1
    transport: str = "shm"
    still: bool = False  # without physics
    scenario: str = "scaling.toml"


@dataclasses.dataclass(frozen=True)
class Pair:
    """A run and the pipe floor right after it."""

    pipes: float  # steps/s
    dds: float  # steps/s
    world_us: float  # physics and sensors, per step
    cpu_us: float  # processor time of all processes, per step
    pipes_cpu_us: float

    @property
    def ratio(self) -> float:
        return self.dds / self.pipes


def receiving_share(robots: int) -> float:
    return 2 * round(RECEIVING_SHARE * robots / 2) / robots


def cpu_seconds_of(line: list) -> tuple[str, float]:
    """The output of a command, and the processor time of it and its children."""
    before = os.times()
    done = subprocess.run(line, stdout=subprocess.PIPE, text=True)  # its errors are shown
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, line))} ended with exit code {done.returncode}")
    after = os.times()
    return done.stdout, after.children_user + after.children_system - before.children_user - before.children_system


def pipe_run(programs: pathlib.Path, robots: int, steps: int, world_us: float) -> tuple[float, float]:
    """Steps per second, and processor seconds."""
    line = [programs / "pipe_floor", "--robots", str(robots), "--world-us", str(round(world_us)), "--steps", str(steps),
            "--receiving-share", str(receiving_share(robots))]
    text, cpu_s = cpu_seconds_of(line)
    return float(text), cpu_s


@contextlib.contextmanager
def with_still_world(programs: pathlib.Path) -> Iterator[pathlib.Path]:
    """The programs in a separate folder, with still_world in place of the world server: caravan starts the programs
    beside it."""
    with tempfile.TemporaryDirectory() as folder:
        there = pathlib.Path(folder)
        for name, source in {"caravan": "caravan", "robot_agent": "robot_agent", "radio_emulator": "radio_emulator",
                             "world_server": "still_world"}.items():
            shutil.copy2(programs / source, there / name)
        yield there


def dds_run(programs: pathlib.Path, setting: Setting, steps: int) -> tuple[dict, float]:
    """metrics.json of a run of `steps` steps, and the processor time of all its processes, start and end included."""
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "run"
        line = [programs / "caravan", "run", ROOT / "deploy/scenarios" / setting.scenario, "--robots", str(setting.robots),
                "--items", "0", "--max-time", str(steps * STEP_S), "--agents-per-process", str(setting.agents_per_process),
                "--transport", setting.transport, "--quiet", "--out", out]
        _, cpu_s = cpu_seconds_of(line)
        return json.loads((out / "metrics.json").read_text()), cpu_s


@contextlib.contextmanager
def place_of(programs: pathlib.Path, setting: Setting) -> Iterator[pathlib.Path]:
    with contextlib.ExitStack() as stack:
        yield stack.enter_context(with_still_world(programs)) if setting.still else programs


def start_cpu_s(programs: pathlib.Path, setting: Setting) -> float:
    """Processor time of a run with very few steps, that is, of its start and end."""
    with place_of(programs, setting) as place:
        return dds_run(place, setting, 10)[1]


def measure(programs: pathlib.Path, setting: Setting, steps: int, start_s: float) -> Pair:
    with place_of(programs, setting) as place:
        run, cpu_s = dds_run(place, setting, steps)
    world_us = 1e6 * (run["time_split"]["physics"] + run["time_split"]["sensors"]) / steps
    floor_us = 0.0 if setting.still else world_us
    pipes, pipes_cpu_s = pipe_run(programs, setting.robots, steps, floor_us)
    return Pair(pipes, steps / run["wall_time_s"], world_us, 1e6 * (cpu_s - start_s) / steps, 1e6 * pipes_cpu_s / steps)
