#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The obstacles of the paper's world, as in the scenario files.

The paper gives no coordinates. Its obstacles are reconstructed from published trajectories: the outlines below are
the lines that no robot centre ever crossed, so the solid behind each is CLEARANCE further inside. Frame: x right, y up as
in the paper's pictures, origin at the arena's centre, metres.

    paper_world.py            print the [[world.box]] and [[world.outline]] tables
    paper_world.py --check F  exit 1 unless the scenario file F holds exactly these obstacles
"""
import argparse
import math
import sys
import tomllib

CLEARANCE = 0.25  # m, robot centre to solid

# centre x, y, size x, y of the area never entered, degrees counter-clockwise
BOXES = {
    "G": (-19.20, -13.90, 5.8, 5.8, -6.0),
    "F": (-6.61, -19.73, 6.0, 5.7, -6.0),
    "E": (-3.01, 17.71, 5.9, 5.7, -7.0),
    "D": (17.40, 12.35, 5.8, 6.3, 0.0),
}

OUTLINES = {
    "A, the boomerang": [
        (-20.8, -4.6), (-20.7, -2.0), (-13.4, 7.3), (-12.0, 7.3), (-11.3, 3.0), (-10.8, -1.8), (-6.5, -5.4),
        (-3.6, -6.0), (-3.6, -7.6), (-6.4, -9.2), (-8.6, -10.0), (-11.2, -10.2), (-12.8, -7.8)],
    "B": [
        (-5.9, 5.6), (-5.3, 7.5), (-0.8, 9.7), (4.8, 9.3), (10.5, 7.6), (11.3, 6.9), (10.6, 4.2), (9.3, 3.0),
        (9.1, 1.7), (7.3, 1.2), (3.5, 1.4), (-1.2, -0.5), (-2.9, -0.6), (-3.8, 0.1)],
    "C": [
        (0.6, -6.7), (3.3, -6.3), (4.9, -6.4), (8.5, -9.1), (8.8, -11.4), (4.7, -17.1), (2.6, -17.2), (-0.5, -15.7),
        (-0.8, -13.5), (-0.1, -8.1)],
}


def inset(points, distance):
    """Every edge moved inwards by `distance` and cut with its neighbours; the vertex count stays."""
    area = sum(x0 * y1 - x1 * y0 for (x0, y0), (x1, y1) in zip(points, points[1:] + points[:1]))
    turn = 1.0 if area > 0 else -1.0
    lines = []  # unit normal n (inwards) and offset c: the moved edge is n . p = c
    for (x0, y0), (x1, y1) in zip(points, points[1:] + points[:1]):
        length = math.hypot(x1 - x0, y1 - y0)
        nx, ny = -turn * (y1 - y0) / length, turn * (x1 - x0) / length
        lines.append((nx, ny, nx * x0 + ny * y0 + distance))
    result = []
    for (ax, ay, ac), (bx, by, bc) in zip(lines[-1:] + lines[:-1], lines):
        det = ax * by - ay * bx
        result.append((round((ac * by - ay * bc) / det, 3), round((ax * bc - ac * bx) / det, 3)))
    return result


def edge_distance(point, a, b):
    dx, dy = b[0] - a[0], b[1] - a[1]
    along = ((point[0] - a[0]) * dx + (point[1] - a[1]) * dy) / (dx * dx + dy * dy)
    along = min(1.0, max(0.0, along))
    return math.hypot(point[0] - a[0] - along * dx, point[1] - a[1] - along * dy)


def inset_checked(name, points):
    """Refuses the inset if an edge reversed its direction, or a vertex is nearer to the old outline than it should be."""
    result = inset(points, CLEARANCE)
    edges = list(zip(points, points[1:] + points[:1]))
    for i, (a, b) in enumerate(edges):
        p, q = result[i], result[(i + 1) % len(result)]
        if (b[0] - a[0]) * (q[0] - p[0]) + (b[1] - a[1]) * (q[1] - p[1]) <= 0:
            sys.exit(f"outline {name}: edge {i} is too short to be inset by {CLEARANCE} m")
        if min(edge_distance(p, *edge) for edge in edges) < CLEARANCE - 0.002:
            sys.exit(f"outline {name}: vertex {i} is nearer than {CLEARANCE} m to the outline")
    return result


def obstacles():
    boxes = [(name, [x, y], [round(w - 2 * CLEARANCE, 3), round(h - 2 * CLEARANCE, 3)], round(math.radians(degrees), 6))
             for name, (x, y, w, h, degrees) in BOXES.items()]
    outlines = [(name, [list(point) for point in inset_checked(name, points)]) for name, points in OUTLINES.items()]
    return boxes, outlines


def as_toml():
    boxes, outlines = obstacles()
    text = ""
    for name, centre, size, yaw in boxes:
        text += f"\n[[world.box]]  # {name}\ncentre_m = {centre}\nsize_m = {size}\nyaw_rad = {yaw}\n"
    for name, points in outlines:
        text += f"\n[[world.outline]]  # {name}\npoints_m = [\n"
        for i in range(0, len(points), 5):
            text += "  " + ", ".join(str(point) for point in points[i:i + 5]) + ",\n"
        text += "]\n"
    return text


def check(file):
    with open(file, "rb") as handle:
        world = tomllib.load(handle)["world"]
    boxes, outlines = obstacles()
    expected = {
        "box": [{"centre_m": centre, "size_m": size, "yaw_rad": yaw} for _, centre, size, yaw in boxes],
        "outline": [{"points_m": points} for _, points in outlines],
    }
    wrong = [key for key in expected if world.get(key) != expected[key]]
    for key in wrong:
        print(f"{file}: [[world.{key}]] differs from what paper_world.py makes", file=sys.stderr)
    return 1 if wrong else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--check", metavar="FILE")
    arguments = parser.parse_args()
    if arguments.check:
        return check(arguments.check)
    print(as_toml(), end="")
    return 0


if __name__ == "__main__":
    sys.exit(main())
