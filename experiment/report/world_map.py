# SPDX-License-Identifier: Apache-2.0
"""The world of a run, drawn from its scenario."""

import math

from matplotlib.axes import Axes
from matplotlib.patches import Circle, Polygon, Rectangle

import style


def arena_m(scenario: dict) -> tuple[float, float]:
    width, height = scenario.get("world", {}).get("arena_m", (50.0, 50.0))
    return float(width), float(height)


def corners(box: dict) -> list[tuple[float, float]]:
    half_x, half_y = (size / 2 for size in box["size_m"])
    yaw, (middle_x, middle_y) = box.get("yaw_rad", 0.0), box["centre_m"]
    return [(middle_x + x * math.cos(yaw) - y * math.sin(yaw), middle_y + x * math.sin(yaw) + y * math.cos(yaw))
            for x, y in ((half_x, half_y), (-half_x, half_y), (-half_x, -half_y), (half_x, -half_y))]


def draw(axes: Axes, scenario: dict) -> None:
    """Walls, obstacles, source and destination; axes in metres."""
    width, height = arena_m(scenario)
    world, robots = scenario.get("world", {}), scenario.get("robots", {})
    solid = {"facecolor": style.OBSTACLE, "edgecolor": "#8c8c8c", "linewidth": 0.5, "zorder": 2}
    for box in world.get("box", []):
        axes.add_patch(Polygon(corners(box), **solid))
    for outline in world.get("outline", []):
        axes.add_patch(Polygon(outline["points_m"], **solid))
    for cylinder in world.get("cylinder", []):
        axes.add_patch(Circle(cylinder["centre_m"], cylinder["radius_m"], **solid))
    axes.add_patch(Rectangle((-width / 2, -height / 2), width, height, fill=False, edgecolor=style.INK, linewidth=1.0,
                             zorder=3))
    axes.grid(False)
    for spine in axes.spines.values():
        spine.set_visible(False)
    for name, key, marker in (("source", "source_m", "s"), ("destination", "destination_m", "*")):
        x, y = robots.get(key, (0.0, 0.0))
        axes.plot(x, y, marker, color=style.INK, markersize=6.5, markeredgecolor="white", markeredgewidth=0.7, zorder=9)
        inwards = -1 if x > 0 else 1
        label = axes.annotate(name, (x, y), textcoords="offset points", xytext=(5 * inwards, 6), fontsize=6.5,
                              zorder=10, ha="left" if inwards > 0 else "right")
        label.set_bbox({"facecolor": "white", "alpha": 0.75, "pad": 0.8, "edgecolor": "none"})
    axes.set_aspect("equal")
    axes.set_xlim(-width / 2 - 0.4, width / 2 + 0.4)
    axes.set_ylim(-height / 2 - 0.4, height / 2 + 0.4)
    axes.set_xlabel("x, east (m)")
