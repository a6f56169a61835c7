#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Carries out docs/your_own_agent.md in the home of a user who has installed Caravan in ~/caravan: runs each command in one shell, writes the
controller that the page prints where it prints it, and runs a scenario with the table that it prints."""

import argparse
import os
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[3]
PAGE = ROOT / "docs/your_own_agent.md"


def blocks(kind: str) -> list[tuple[str, str]]:
    """Kind and text of each block of these kinds, in the order of the page."""
    return re.findall(rf"^```({kind})\n(.*?)^```$", PAGE.read_text(encoding="utf-8"), re.M | re.S)


def script() -> str:
    lines = ["set -ev"]
    for kind, text in blocks("sh|cpp|toml"):
        if kind == "sh":
            lines.append(text)
        elif kind == "cpp":
            lines.append(f"cat > spinner.cpp <<'END'\n{text}END")
        else:
            lines.append(f"cat ~/caravan/share/caravan/scenarios/small.toml - > mine.toml <<'END'\n{text}END")
            lines.append("caravan run mine.toml --engine embedded --items 0 --max-time 20 --quiet --out ~/mine")
    return "\n".join(lines)


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("--build", type=pathlib.Path, required=True)
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        home = pathlib.Path(name)
        environment = dict(os.environ, LC_ALL="C", HOME=name, PATH=f"{name}/caravan/bin:{os.environ['PATH']}")
        installed = subprocess.run(["cmake", "--install", str(arguments.build), "--prefix", str(home / "caravan")], stdout=subprocess.DEVNULL, check=False)
        if installed.returncode != 0:
            return 1
        done = subprocess.run(["/bin/bash", "-c", script()], cwd=home, env=environment, check=False)
        if done.returncode != 0:
            print(f"exit code {done.returncode}")
            return 1
        if '"controller": "spinner"' not in (home / "mine/metrics.json").read_text(encoding="utf-8"):
            print("the scenario's controller did not run")
            return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
