# SPDX-License-Identifier: Apache-2.0
"""A figure of the report before it is drawn."""

from collections.abc import Callable
from dataclasses import dataclass

from matplotlib.figure import Figure

from records import Run

ByMode = dict[str, list[Run]]


@dataclass(frozen=True)
class Picture:
    name: str  # name of its files
    title: str
    caption: Callable[[ByMode], str]
    draw: Callable[[ByMode], Figure]
    can_be_drawn: Callable[[ByMode], bool] = lambda runs: True
