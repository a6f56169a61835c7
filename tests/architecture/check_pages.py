#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The pages are finished and agree with what they describe: no placeholder is left, every link leads to a file and to a heading of it, and
the table of the sonars is that of the robot model."""

import functools
import pathlib
import re
import sys

PLACEHOLDER = re.compile(r"\b(MEASURED|TODO|TBD|FIXME|XXX)\b")
LINK = re.compile(r"\]\(([^)\s]*)\)")
HEADING = re.compile(r"^#+ (.*)$", re.M)
MOUNT = re.compile(r"sonar_mount\((-?\d+), (-?\d+), (-?\d+)\)")
FOLDERS = ("docs", "deploy", "robot_agent", "experiment")


def pages(root):
    return [*root.glob("*.md"), *(page for folder in FOLDERS for page in (root / folder).rglob("*.md"))]


@functools.cache
def anchors(page):
    """The names that readers of Markdown give to the headings of a page."""
    text = re.sub(r"^```.*?^```$", "", page.read_text(encoding="utf-8"), flags=re.M | re.S)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in HEADING.findall(text)}


def faults_of(page):
    text = page.read_text(encoding="utf-8")
    faults = [f"has the placeholder {word}" for word in PLACEHOLDER.findall(text)]
    for link in LINK.findall(re.sub(r"^```.*?^```$", "", text, flags=re.M | re.S)):
        file, _, anchor = link.partition("#")
        target = (page.parent / file).resolve() if file else page
        if "://" in link:
            continue
        if not target.exists():
            faults.append(f"links to {file}, which does not exist")
        elif anchor and target.suffix == ".md" and anchor not in anchors(target):
            faults.append(f"links to {link}, which is not a heading there")
    return faults


def sonar_faults(root):
    model = MOUNT.findall((root / "runtime/pure/robot_model.hpp").read_text(encoding="utf-8"))
    wanted = "".join(f"| {sonar} | {x} | {y} | {heading} |\n" for sonar, (x, y, heading) in enumerate(model))
    told = (root / "docs/scenario.md").read_text(encoding="utf-8").partition("| sonar | x, mm | y, mm | direction, degrees |\n|---|---|---|---|\n")[2]
    return [] if model and told.startswith(wanted + "\n") else [f"docs/scenario.md: the table of the sonars must be\n{wanted}"]


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parents[2]).resolve()
    faults = [f"{page.relative_to(root)}: {fault}" for page in pages(root) for fault in faults_of(page)] + sonar_faults(root)
    print("\n".join(faults) if faults else f"{len(pages(root))} pages")
    return 1 if faults or len(pages(root)) < 20 else 0


if __name__ == "__main__":
    sys.exit(main())
