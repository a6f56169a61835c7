#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks that the presets dev and release give the same digests. Exit code 77: skipped, because one of them is not built."""

import json
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
RUNS = [("small.toml", "dds", "150"), ("small.toml", "embedded", "600"), ("paper.toml", "embedded", "1200")]


def digest(preset: str, scenario: str, engine: str, seconds: str) -> str:
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "run"
        line = [ROOT / "build" / preset / "bin/caravan", "run", ROOT / "deploy/scenarios" / scenario, "--engine", engine,
                "--items", "0", "--max-time", seconds, "--quiet", "--out", out]
        subprocess.run(line, check=True)
        return json.loads((out / "metrics.json").read_text())["digest"]


def main() -> int:
    for preset in ("dev", "release"):
        if not (ROOT / "build" / preset / "bin/caravan").exists():
            print(f"build/{preset} is not built: nothing to compare")
            return 77
    differing = 0
    for run in RUNS:
        digests = {preset: digest(preset, *run) for preset in ("dev", "release")}
        differing += len(set(digests.values())) != 1
        print(*run, digests)
    return 1 if differing else 0


if __name__ == "__main__":
    sys.exit(main())
