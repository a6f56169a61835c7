#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Draws a run: obstacles of its scenario, thin tracks of the robots, thick lines for the paths in use at the end."""

import argparse
import csv
import math
import pathlib
import tomllib

MARGIN_M = 1.0
SCALE = 18.0  # pixels for a metre


def colour(robot, robots):
    return f"hsl({360.0 * (robot - 1) / max(robots, 1):.0f},75%,42%)"


def points(places):
    return " ".join(f"{x:.3f},{-y:.3f}" for x, y in places)


def polygon(places, style):
    return f'<polygon points="{points(places)}" {style}/>'


def polyline(places, style):
    return f'<polyline points="{points(places)}" fill="none" {style}/>'


def corners(box):
    half_x, half_y = (size / 2 for size in box.get("size_m", [1.0, 1.0]))
    yaw = box.get("yaw_rad", 0.0)
    for x, y in ((half_x, half_y), (-half_x, half_y), (-half_x, -half_y), (half_x, -half_y)):
        yield (box["centre_m"][0] + x * math.cos(yaw) - y * math.sin(yaw),
               box["centre_m"][1] + x * math.sin(yaw) + y * math.cos(yaw))


def read_lines(file, begin_s, end_s):
    """Robot -> its places in order."""
    lines = {}
    if file.is_file():
        with open(file, newline="", encoding="utf-8") as rows:
            for row in csv.DictReader(rows):
                if begin_s <= float(row.get("time_s", begin_s)) <= end_s:
                    lines.setdefault(int(row["robot"]), []).append((float(row["x_m"]), float(row["y_m"])))
    return lines


def scene(scenario):
    world, robots = scenario["world"], scenario["robots"]
    solid = 'fill="#8a8f98"'
    for box in world.get("box", []):
        yield polygon(corners(box), solid)
    for outline in world.get("outline", []):
        yield polygon(outline["points_m"], solid)
    for cylinder in world.get("cylinder", []):
        x, y = cylinder["centre_m"]
        yield f'<circle cx="{x:.3f}" cy="{-y:.3f}" r="{cylinder.get("radius_m", 0.5):.3f}" {solid}/>'
    for name, (x, y) in (("S", robots["source_m"]), ("D", robots["destination_m"])):
        radius = robots.get("service_radius_m", 1.5)
        yield f'<circle cx="{x}" cy="{-y}" r="{radius}" fill="none" stroke="#111" stroke-width="0.08"/>'
        yield f'<text x="{x}" y="{-y + 0.35}" font-size="1" text-anchor="middle" font-family="sans-serif">{name}</text>'


def drawing(folder, begin_s, end_s):
    scenario = tomllib.loads((folder / "scenario.toml").read_text())
    size_x, size_y = scenario["world"].get("arena_m", [50.0, 50.0])
    robots = scenario["robots"].get("count", 15)
    left, top = -size_x / 2 - MARGIN_M, -size_y / 2 - MARGIN_M
    width, height = size_x + 2 * MARGIN_M, size_y + 2 * MARGIN_M
    yield (f'<svg xmlns="http://www.w3.org/2000/svg" width="{width * SCALE:.0f}" height="{height * SCALE:.0f}" '
           f'viewBox="{left} {top} {width} {height}">')
    yield f'<rect x="{left}" y="{top}" width="{width}" height="{height}" fill="#fff"/>'
    yield (f'<rect x="{-size_x / 2}" y="{-size_y / 2}" width="{size_x}" height="{size_y}" fill="none" stroke="#333" '
           'stroke-width="0.15"/>')
    yield from scene(scenario)
    tracks = read_lines(folder / "tracks.csv", begin_s, end_s)
    for robot, places in sorted(tracks.items()):
        yield polyline(places, f'stroke="{colour(robot, robots)}" stroke-width="0.05" stroke-opacity="0.55"')
    for robot, places in sorted(read_lines(folder / "paths.csv", begin_s, end_s).items()):
        yield polyline(places, f'stroke="{colour(robot, robots)}" stroke-width="0.22"')
    for robot, places in sorted(tracks.items()):
        x, y = places[-1]
        yield f'<circle cx="{x:.3f}" cy="{-y:.3f}" r="0.25" fill="{colour(robot, robots)}"/>'
        yield f'<text x="{x + 0.3:.3f}" y="{-y - 0.2:.3f}" font-size="0.7" font-family="sans-serif">{robot}</text>'
    yield "</svg>"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=pathlib.Path, help="folder of a run")
    parser.add_argument("--out", type=pathlib.Path, help="SVG file; without it FOLDER/run.svg")
    parser.add_argument("--from", dest="begin_s", type=float, default=0.0, help="tracks from this simulated second")
    parser.add_argument("--to", dest="end_s", type=float, default=math.inf, help="tracks up to this one")
    arguments = parser.parse_args()
    out = arguments.out or arguments.folder / "run.svg"
    out.write_text("\n".join(drawing(arguments.folder, arguments.begin_s, arguments.end_s)) + "\n", encoding="utf-8")
    print(out)


if __name__ == "__main__":
    main()
