#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Prints how easily the tree changes: files that a new sensor, radio model, metric and scenario key touch, `const Config&` in
the core, layers and dependencies of the folders, the longest classes. Numbers to compare two states of the tree; no check.

Files to touch are those that declare, read or convert an existing example of the kind today, without tests.
"""

import pathlib
import re
import signal
import sys
from collections import defaultdict

from check_includes import ALLOWED, INCLUDE, rule_for

# An example of each kind: a pattern of its declarations, readers, conversions and rows in tables, which no other has.
EXEMPLARS = {
    # On the wire; in a controller's Sensors, which the world fills; in those of the paper's agent.
    "sensor (the compass)": r"compass_yaw_rad|compass: counter-clockwise|yaw_WB_rad = sensors\.yaw_rad|sensors\.yaw_rad = seen|append\(bytes_, sensors\.yaw_rad",
    # PropagationConfig has it; `link` is what a model returns, and `loss_probability()` is a request's, not the model's.
    "radio model (loss by chance)": r"(?<!link)\.loss_probability\b(?!\()|double loss_probability =|`loss_probability`",
    "metric (contacts with something static)": r"robot_static",
    # step_m is its member of struct Exploration.
    "scenario key (exploration_step_m)": r"exploration_step_m|double step_m\b",
}
SOURCES = ("idl", "runtime", "robot_agent", "world_server", "radio_emulator", "hardware_bridge", "experiment", "deploy", "docs")
SUFFIXES = {".cpp", ".hpp", ".py", ".idl", ".md"}
CLASS = re.compile(r"^(?:class|struct) (\w+)(?: final)?(?: :[^{;]*)? \{", re.M)


def texts_of(root, suffixes):
    for top in SOURCES:
        for file in sorted((root / top).rglob("*")):
            if file.suffix in suffixes and "decisions" not in file.parts:
                yield file.relative_to(root).as_posix(), file.read_text(encoding="utf-8")


def files_to_touch(pattern, texts):
    return [path for path, text in texts.items() if re.search(pattern, text)]


def print_files_to_touch(texts):
    for kind, pattern in EXEMPLARS.items():
        files = files_to_touch(pattern, texts)
        code = [path for path in files if not path.startswith("docs/")]
        print(f"{kind}: {len(code)} files, {len(files) - len(code)} pages")
        for path in files:
            print(f"  {path}")


def folder_of(path):
    """The folder as in check_includes.py; a rule for one file counts as its folder."""
    rule = rule_for(path) or str(pathlib.PurePosixPath(path).parent)
    return rule if pathlib.PurePosixPath(rule).suffix == "" else str(pathlib.PurePosixPath(rule).parent)


def arrows_of(texts):
    arrows = defaultdict(set)
    for path, text in texts.items():
        here = folder_of(path)
        arrows[here].update(())
        for bracket, name in INCLUDE.findall(text):
            if bracket == '"' and (name in texts or rule_for(name)) and folder_of(name) != here:
                arrows[here].add(folder_of(name))
    return arrows


def reach_of(folder, arrows):
    seen, open_ = set(), [folder]
    while open_:
        for below in arrows.get(open_.pop(), ()):
            if below not in seen:
                seen.add(below)
                open_.append(below)
    return seen


def floors_of(arrows):
    """0: includes no other folder. Folders that include each other share a layer."""
    reach = {folder: reach_of(folder, arrows) for folder in arrows}
    floors = {}

    def floor(folder):
        if folder not in floors:
            below = [one for one in reach.get(folder, ()) if folder not in reach.get(one, ())]
            floors[folder] = 1 + max((floor(one) for one in below), default=-1)
        return floors[folder]

    for folder in arrows:
        floor(folder)
    return floors


def print_floors(arrows):
    floors = floors_of(arrows)
    for folder in sorted(arrows, key=lambda one: (floors[one], one)):
        below = ", ".join(sorted(arrows[folder]))
        print(f"{floors[folder]:2} {folder}{' -> ' + below if below else ''}")
    print(f"{len(arrows)} folders, {sum(len(below) for below in arrows.values())} dependencies, highest layer {max(floors.values())}")


def body_lines(text, opening):
    """Number of lines between the brace that opens here and its closing brace."""
    depth = 0
    for place in range(opening, len(text)):
        depth += {"{": 1, "}": -1}.get(text[place], 0)
        if depth == 0:
            return text.count("\n", opening, place) + 1
    return 0


def lines_of_classes(texts):
    """(lines of the class and of its members elsewhere in its folder, members elsewhere) by file and name."""
    found = {}
    for path, text in texts.items():
        for match in CLASS.finditer(text):
            name, folder = match.group(1), str(pathlib.PurePosixPath(path).parent)
            lines, members = body_lines(text, match.end() - 1), 0
            member = re.compile(rf"^(?! )[^\n;#]*\b{name}::~?\w+\([^;{{]*\{{", re.M)
            for other, code in texts.items():
                if other.endswith(".cpp") and str(pathlib.PurePosixPath(other).parent) == folder:
                    for part in member.finditer(code):
                        members += 1
                        lines += body_lines(code, part.end() - 1)
            found[f"{path}: {name}"] = (lines, members)
    return found


def main():
    signal.signal(signal.SIGPIPE, signal.SIG_DFL)  # end without a message when the reader closes the pipe
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parents[2]).resolve()
    texts = dict(texts_of(root, SUFFIXES))
    code = {path: text for path, text in texts.items() if path.endswith((".cpp", ".hpp"))}
    print("Files to touch for a new")
    print_files_to_touch(texts)
    core = [text for path, text in code.items() if path.startswith("robot_agent/core/")]
    print(f"\nconst Config& in robot_agent/core: {sum(len(re.findall(r'const Config&', text)) for text in core)}")
    print("\nLayers and dependencies")
    print_floors(arrows_of(code))
    print("\nLongest classes (lines with their members)")
    classes = sorted(lines_of_classes(code).items(), key=lambda one: -one[1][0])
    for name, (lines, members) in classes[:5]:
        print(f"{lines:4} {name}, {members} members defined outside")
    return 0 if code and classes and ALLOWED else 1


if __name__ == "__main__":
    sys.exit(main())
