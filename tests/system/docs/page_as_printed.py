#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Carries out a page of docs/ in the home of a user who has installed Caravan in ~/caravan: runs each command in one shell, writes the
controller or the cells of a notebook that the page prints where it prints them, and runs a scenario with the table that it prints. A block whose first
line names a file, as in ```cpp spinner_test.cpp, is written to that file."""

import argparse
import os
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[3]
# page -> the file for its code; None: only its commands are run
PAGES = {"your_own_agent.md": "spinner.cpp", "python.md": "spinner.py", "notebooks.md": "study.py", "agent_contract.md": None, "braitenberg.md": None,
         "deployment_tests.md": None, "flocking.md": None, "pheromone.md": None}


def blocks(page: str) -> list[tuple[str, str, str]]:
    """Kind, file and text of each block of code, in the order of the page. A block of the kind text is printed by what comes before."""
    found = re.findall(r"^```(sh|cpp|python|toml|text)(?: (\S+))?\n(.*?)^```$", (ROOT / "docs" / page).read_text(encoding="utf-8"), re.M | re.S)
    kinds = ("sh", "cpp", "python", "toml", "text") if PAGES[page] else ("sh", "text")
    return [(kind, file or PAGES[page], text) for kind, file, text in found if kind in kinds]


def script(page: str) -> str:
    lines = ["set -ev"]
    for kind, file, text in blocks(page):
        if kind == "sh":
            lines.append(text)
        elif kind in ("cpp", "python"):
            lines.append(f"cat >> {file} <<'END'\n{text}END")
        elif kind == "toml":
            lines.append(f"cat ~/caravan/share/caravan/scenarios/small.toml - > mine.toml <<'END'\n{text}END")
            lines.append("caravan run mine.toml --engine embedded --items 0 --max-time 20 --quiet --out ~/mine")
    return "\n".join(lines)


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("--build", type=pathlib.Path, required=True)
    parser.add_argument("--page", choices=PAGES, default="your_own_agent.md")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        home = pathlib.Path(name)
        environment = dict(os.environ, LC_ALL="C", HOME=name, PATH=f"{name}/caravan/bin:{os.environ['PATH']}")
        installed = subprocess.run(["cmake", "--install", str(arguments.build), "--prefix", str(home / "caravan")], stdout=subprocess.DEVNULL, check=False)
        if installed.returncode != 0:
            return 1
        done = subprocess.run(["/bin/bash", "-c", script(arguments.page)], cwd=home, env=environment, stdout=subprocess.PIPE, text=True, check=False)
        print(done.stdout)
        if done.returncode != 0:
            print(f"exit code {done.returncode}")
            return 1
        scenario_runs = any(kind == "toml" for kind, _, _ in blocks(arguments.page))
        if scenario_runs and '"controller": "spinner"' not in (home / "mine/metrics.json").read_text(encoding="utf-8"):
            print("the scenario's controller did not run")
            return 1
    missing = [line for kind, _, text in blocks(arguments.page) if kind == "text" for line in text.splitlines() if line not in done.stdout.splitlines()]
    for line in missing:
        print(f"not printed: {line}")
    return 1 if missing else 0


if __name__ == "__main__":
    sys.exit(main())
