#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks that every C++ file is formatted by clang-format 14 with .clang-format. Prints each place that is not; exit code 1 when
there is one, 77 (skipped) when the machine has another version, which would format some lines differently. `--fix` writes the files
instead."""

import shutil
import subprocess
import sys

import sources


def main():
    tool = shutil.which("clang-format-14") or shutil.which("clang-format")
    if tool is None:
        print("clang-format is not installed (cmake/debian_packages.txt)")
        return 1
    version = subprocess.run([tool, "--version"], capture_output=True, text=True, check=True).stdout.strip()
    if " version 14." not in version:
        print(f"not clang-format 14, as Debian 12 has it: {version}")
        return 77
    how = ["-i"] if "--fix" in sys.argv[1:] else ["--dry-run", "-Werror", "--ferror-limit=1"]
    files = sources.files_ending_in(".cpp", ".hpp")
    print(f"{len(files)} files")
    return 1 if not files or subprocess.run([tool, *how, *files], check=False).returncode else 0


if __name__ == "__main__":
    sys.exit(main())
