#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Carries out docs/your_own_agent.md: writes the controller that it prints, runs each command, and a scenario with the table
that it prints."""

import argparse
import os
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[3]
PAGE = ROOT / "docs/your_own_agent.md"


def blocks(kind: str) -> list[str]:
    return re.findall(rf"^```{kind}\n(.*?)^```$", PAGE.read_text(encoding="utf-8"), re.M | re.S)


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("--binaries", type=pathlib.Path, required=True)
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for part in ("runtime", "deploy"):
            (folder / part).symlink_to(ROOT / part)
        (folder / "build/release").mkdir(parents=True)
        (folder / "build/release/bin").symlink_to(arguments.binaries)
        (folder / "spinner.cpp").write_text(blocks("cpp")[0], encoding="utf-8")
        scenario = (ROOT / "deploy/scenarios/small.toml").read_text(encoding="utf-8")
        (folder / "mine.toml").write_text(scenario + blocks("toml")[0], encoding="utf-8")
        commands = [line for block in blocks("sh") for line in block.splitlines()]
        commands.append("build/release/bin/caravan run mine.toml --engine embedded --items 0 --max-time 20 --quiet --out mine")
        for command in commands:
            print(command, flush=True)
            done = subprocess.run(command, shell=True, cwd=folder, check=False, env=dict(os.environ, LC_ALL="C"))
            if done.returncode != 0:
                print(f"exit code {done.returncode}")
                return 1
        if '"controller": "spinner"' not in (folder / "mine/metrics.json").read_text(encoding="utf-8"):
            print("the scenario's controller did not run")
            return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
