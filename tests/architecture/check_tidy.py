#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks that clang-tidy with .clang-tidy finds nothing. Prints its findings; exit code 1 when there are any.

    check_tidy.py                  the source files that differ from HEAD
    check_tidy.py --since main     those that differ from a revision
    check_tidy.py --all            every source file
    check_tidy.py FILE...          these

Headers are checked with the sources that include them. The build folder must have been built, for its generated types."""

import argparse
import concurrent.futures
import json
import os
import pathlib
import shutil
import subprocess
import sys

import sources


def changed_since(revision):
    command = ["git", "-C", sources.ROOT, "diff", "--name-only", "--diff-filter=d", revision]
    names = subprocess.run(command, check=True, capture_output=True, text=True).stdout.split()
    return {sources.ROOT / name for name in names}


def chosen(arguments):
    """The requested files, as far as the build compiles them."""
    database = json.loads((arguments.build / "compile_commands.json").read_text())
    compiled = {pathlib.Path(entry["file"]) for entry in database}
    wanted = set(sources.files_ending_in(".cpp"))
    if arguments.files:
        wanted &= {file.resolve() for file in arguments.files}
    elif not arguments.all:
        wanted &= changed_since(arguments.since)
    return sorted(wanted & compiled)


def complaints_about(file, arguments):
    command = [arguments.tool, "--quiet", "-p", arguments.build, file]
    done = subprocess.run(command, check=False, capture_output=True, text=True)
    # Its output on standard error matters only when it could not run at all.
    return (done.stdout or done.stderr) if done.returncode else ""


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("files", nargs="*", type=pathlib.Path)
    parser.add_argument("--all", action="store_true")
    parser.add_argument("--since", default="HEAD", metavar="REVISION")
    parser.add_argument("--build", type=pathlib.Path, default=sources.ROOT / "build/dev")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    arguments = parser.parse_args()
    arguments.tool = shutil.which("clang-tidy-14") or shutil.which("clang-tidy")
    if arguments.tool is None:
        print("clang-tidy is not installed (cmake/debian_packages.txt)")
        return 1
    files, bad = chosen(arguments), 0
    with concurrent.futures.ThreadPoolExecutor(max_workers=arguments.jobs) as pool:
        for text in pool.map(lambda file: complaints_about(file, arguments), files):
            if text:
                bad += 1
                print(text, flush=True)
    print(f"{len(files)} files, complaints about {bad}")
    return 1 if bad or (arguments.all and not files) else 0


if __name__ == "__main__":
    sys.exit(main())
