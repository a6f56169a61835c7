#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""docs/scenario.md has a row for each key that a reader reads from a scenario, and for no other."""

import pathlib
import re
import sys

READERS = ("runtime/scenario", "robot_agent/config", "robot_agent/controller", "world_server/config", "radio_emulator/config", "hardware_bridge/config",
           "deploy/cli/overrides.cpp")
READ = re.compile(r'\bread\w*\([^"();]*"([a-z_0-9]+)"')
KEY = re.compile(r"`([a-z][a-z_0-9]*)`")


def keys_of_readers(root):
    keys = set()
    for place in READERS:
        for file in (root / place).rglob("*.cpp") if (root / place).is_dir() else [root / place]:
            keys.update(READ.findall(file.read_text(encoding="utf-8")))
    return keys


def keys_of_page(root):
    """First column of each table of keys; the second column for solids, whose first column is the table."""
    keys, is_of_keys = set(), False
    for line in (root / "docs/scenario.md").read_text(encoding="utf-8").splitlines():
        cells = [cell.strip() for cell in re.split(r"(?<!\\)\|", line)[1:-1]]
        if not cells or set("".join(cells)) <= set("-: "):
            is_of_keys = is_of_keys and bool(cells)
        elif "key" in cells[:2] or "keys" in cells[:2]:
            is_of_keys = True
        elif is_of_keys:
            keys.update(KEY.findall(" ".join(cells[:2]) if cells[0].startswith("`[[") or not cells[0] else cells[0]))
    return keys


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parents[2])
    read, told = keys_of_readers(root), keys_of_page(root)
    for key in sorted(read - told):
        print(f"docs/scenario.md has no row for {key}")
    for key in sorted(told - read):
        print(f"docs/scenario.md: no reader takes {key}")
    print(f"{len(read)} keys")
    return 1 if read != told or not read else 0


if __name__ == "__main__":
    sys.exit(main())
