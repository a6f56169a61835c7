#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The files of idl/ are for any DDS vendor: Cyclone's compiler accepts each, and generates the type names of the table of topics.

Exit code 77 (skipped) where idlc is not installed.
"""

import pathlib
import re
import shutil
import subprocess
import sys
import tempfile


def check(root):
    """The errors of idlc for the files, and the types of topics that none of them defines."""
    found, types = [], set()
    files = sorted((root / "idl").glob("*.idl"))
    with tempfile.TemporaryDirectory() as folder:
        for file in files:
            result = subprocess.run(["idlc", "-I", root / "idl", file], cwd=folder, capture_output=True, text=True)
            if result.returncode != 0 or result.stderr:
                found.append(f"idlc {file.name}: exit code {result.returncode} {result.stdout}{result.stderr}".strip())
                continue
            generated = pathlib.Path(folder, file.stem + ".c").read_text()
            types.update(re.findall(r'\.m_typename = "([^"]+)"', generated))
    wanted = re.findall(r'"(\w+(?:::\w+)+_)"', (root / "idl/topics.hpp").read_text())
    found += [f"idl/topics.hpp: no IDL file defines {name}" for name in sorted(set(wanted) - types)]
    if not files or not wanted:
        found.append(f"{root}/idl: nothing to check")
    return found


def main():
    if shutil.which("idlc") is None:
        print("Skipped: idlc (Debian: cyclonedds-tools) is not installed")
        return 77
    found = check(pathlib.Path(sys.argv[1]).resolve())
    for line in found:
        print(line)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
