#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs the shell commands of a page of docs/ as printed, in a folder that looks like this tree with a release build. Each must end with exit
code 0 and print or write something."""

import argparse
import os
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[3]


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("--page", type=pathlib.Path, required=True)
    parser.add_argument("--build", type=pathlib.Path, required=True)
    arguments = parser.parse_args()
    blocks = re.findall(r"^```sh\n(.*?)^```$", arguments.page.read_text(encoding="utf-8"), re.M | re.S)
    commands = [line for block in blocks for line in block.splitlines()]
    if not commands:
        print(f"{arguments.page}: has no command")
        return 1
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "deploy").symlink_to(ROOT / "deploy")
        (folder / "build").mkdir()
        (folder / "build/release").symlink_to(arguments.build)
        for command in commands:
            print(command, flush=True)
            done = subprocess.run(command, shell=True, cwd=folder, check=False, env=dict(os.environ, LC_ALL="C"), stdout=subprocess.PIPE)
            sys.stdout.buffer.write(done.stdout)
            if done.returncode != 0 or not done.stdout:
                print(f"exit code {done.returncode}, {len(done.stdout)} bytes of output")
                return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
