# SPDX-License-Identifier: Apache-2.0
"""One recorded run, read from its folder. docs/outputs.md describes the files."""

import csv
import io
import json
import pathlib
import tomllib
from dataclasses import dataclass, field

import numpy as np

MODES = ("none", "partial", "full")
SAME_SESSION_S = 60.0  # a pair may use a session's number again; reports further apart are two sessions

NUMBER, OR_NULL = (int, float), (int, float, type(None))
# The content of metrics.json, as far as it is used here.
METRICS = {"mode": (str,), "seed": (int,), "robots": (int,), "sim_time_s": NUMBER, "completed": (bool,),
           "items_delivered": (int,), "routes": (int,), "exchanges": (dict,), "contacts": (dict,), "per_robot": (list,),
           "scenario": (str,)}
EXCHANGES = {"completed": (int,), "failed": (int,), "mean_duration_s": NUMBER}
CONTACTS = {"robot_robot": (int,), "robot_static": (int,)}
ROBOT = {"items": (int,), "found_s": OR_NULL, "received_s": OR_NULL, "path_length_m": OR_NULL, "driving_s": NUMBER,
         "exchanging_s": NUMBER, "avoiding_s": NUMBER, "stuck_s": NUMBER, "idle_s": NUMBER}


class BrokenRun(Exception):
    """The folder holds no readable run; the text gives the reason."""


@dataclass
class Trip:
    robot: int
    picked_up_s: float
    delivered_s: float | None
    next_pick_up_s: float | None


@dataclass
class Run:
    """Times in simulated seconds, lengths in metres. Robots are numbered from 1; arrays by robot start with robot 1."""

    folder: pathlib.Path
    metrics: dict
    scenario: dict
    track_times: np.ndarray  # (steps)
    tracks: np.ndarray  # (steps, robots, 2)
    trips: list[Trip]
    deliveries: np.ndarray  # times
    exchanges: np.ndarray  # (sessions and lone attempts, 2): time of the end, completed
    reports: np.ndarray  # (reports of attempts, 2): time of the end, time the robot stood
    contacts: np.ndarray  # times of contacts between robots
    paths: dict[int, np.ndarray]
    path_lengths: list[tuple[np.ndarray, np.ndarray]] = field(default_factory=list)  # by robot: times, lengths
    activities: list[tuple[np.ndarray, list[str]]] = field(default_factory=list)  # by robot: start times, activities

    @property
    def mode(self) -> str:
        return self.metrics["mode"]

    @property
    def seed(self) -> int:
        return self.metrics["seed"]

    @property
    def robots(self) -> int:
        return self.metrics["robots"]

    @property
    def end_s(self) -> float:
        return self.metrics["sim_time_s"]

    @property
    def items_wanted(self) -> int:
        return self.scenario.get("experiment", {}).get("items", 100)

    @property
    def state(self) -> str:
        """"completed", or the reason why not."""
        if self.metrics["completed"]:
            return "completed"
        if self.metrics.get("failure"):
            return "failed"
        if not self.metrics.get("ended", True):
            return "killed"
        return "interrupted" if self.metrics.get("interrupted") else "time limit reached"

    def got_path_s(self) -> list[float | None]:
        """Time at which each robot got its first path, found or received."""
        return [robot["found_s"] if robot["found_s"] is not None else robot["received_s"]
                for robot in self.metrics["per_robot"]]


def read_run(folder: pathlib.Path) -> Run:
    """Raises BrokenRun. A file whose last row is incomplete is read up to that row."""
    metrics = _read_metrics(folder / "metrics.json")
    try:
        scenario = tomllib.loads((folder / "scenario.toml").read_text(encoding="utf-8"))
        times, tracks = _read_tracks(folder / "tracks.csv", metrics["robots"])
        events = _rows(folder / "events.csv", 4)
        exchanges, reports = _exchanges(events)
        return Run(folder, metrics, scenario, times, tracks, _read_trips(folder / "trips.csv"),
                   np.array([float(row[0]) for row in events if row[2] == "delivery"]), exchanges, reports,
                   _contacts(events), _read_paths(folder / "paths.csv"),
                   _read_path_lengths(folder / "path_lengths.csv", metrics["robots"]),
                   _read_activities(folder / "activities.csv", metrics["robots"]))
    except OSError as error:
        raise BrokenRun(f"{pathlib.Path(error.filename or '').name}: {error.strerror}") from error
    except (ValueError, KeyError, IndexError) as error:
        raise BrokenRun(f"cannot be read: {error}") from error


def _read_metrics(file: pathlib.Path) -> dict:
    try:
        metrics = json.loads(file.read_text(encoding="utf-8"))
    except OSError as error:
        raise BrokenRun(f"{file.name}: {error.strerror}") from error
    except ValueError as error:
        raise BrokenRun(f"{file.name} is cut off or no JSON: {error}") from error
    _check_kinds(file.name, metrics, METRICS)
    for table, kinds in (("exchanges", EXCHANGES), ("contacts", CONTACTS)):
        _check_kinds(f"{file.name}: {table}", metrics[table], kinds)
    if len(metrics["per_robot"]) != metrics["robots"] or metrics["robots"] < 1 or metrics["mode"] not in MODES:
        raise BrokenRun(f"{file.name} contradicts itself")
    for number, robot in enumerate(metrics["per_robot"], start=1):
        _check_kinds(f"{file.name}: per_robot, robot {number},", robot, ROBOT)
    return metrics


def _check_kinds(where: str, table: object, kinds: dict[str, tuple[type, ...]]) -> None:
    """Raises BrokenRun unless `table` has a value of one of its kinds for each key. A bool does not count as a number."""
    if not isinstance(table, dict):
        raise BrokenRun(f"{where} is no table")
    for key, wanted in kinds.items():
        if key not in table:
            raise BrokenRun(f"{where} has no {key}")
        value = table[key]
        is_other = not isinstance(value, wanted) or (isinstance(value, bool) and bool not in wanted)
        if is_other or (isinstance(value, (int, float)) and not abs(value) < 2**63):
            raise BrokenRun(f"{where} has a {key} that no run writes: {str(value)[:40]}")


def _rows(file: pathlib.Path, fields: int) -> list[list[str]]:
    """The rows below the header, without an incomplete last one."""
    text = file.read_text(encoding="utf-8")
    whole = text[:text.rfind("\n") + 1]
    rows = list(csv.reader(io.StringIO(whole)))[1:]
    for number, row in enumerate(rows, start=2):
        if len(row) < fields:
            raise BrokenRun(f"{file.name}:{number}: {len(row)} fields instead of {fields}")
    return rows


def _read_tracks(file: pathlib.Path, robots: int) -> tuple[np.ndarray, np.ndarray]:
    with open(file, "rb") as stream:
        whole = stream.read()
    whole = whole[:whole.rfind(b"\n") + 1]
    if whole.count(b"\n") < 1 + robots:
        raise BrokenRun(f"{file.name} is empty")
    table = np.loadtxt(io.BytesIO(whole), delimiter=",", skiprows=1, usecols=(0, 1, 2, 3), ndmin=2)
    steps = len(table) // robots
    table = table[:steps * robots].reshape(steps, robots, 4)
    if not np.array_equal(table[:, :, 1], np.broadcast_to(np.arange(1, robots + 1), (steps, robots))):
        raise BrokenRun(f"{file.name}: not one row for each robot and second")
    return table[:, 0, 0].copy(), table[:, :, 2:].copy()


def _read_trips(file: pathlib.Path) -> list[Trip]:
    def or_none(text: str) -> float | None:
        return float(text) if text else None

    return [Trip(int(row[0]), float(row[2]), or_none(row[3]), or_none(row[4])) for row in _rows(file, 5)]


def _detail(text: str) -> dict[str, str]:
    return dict(part.split("=", 1) for part in text.split() if "=" in part)


def _exchanges(events: list[list[str]]) -> tuple[np.ndarray, np.ndarray]:
    """Each session once, as in the run's own count, and every robot's reports of its attempts."""
    counted: list[list[float]] = []
    reports = []
    known: dict[tuple[int, int, int], tuple[float, int]] = {}  # pair and number: began, row in `counted`
    for row in events:
        if row[2] != "exchange":
            continue
        told = _detail(row[3])
        completed = told["completed"] == "true"
        began, ended = float(told["began_s"]), float(told["ended_s"])
        reports.append((ended, ended - began))
        low, high = sorted((int(row[1]), int(told["partner"])))
        key = (low, high, int(told["session"]))
        if key[2] != 0 and key in known and abs(began - known[key][0]) <= SAME_SESSION_S:
            session = counted[known[key][1]]
            session[1] = max(session[1], float(completed))
            continue
        known[key] = (began, len(counted))
        counted.append([ended, float(completed)])
    return np.array(counted).reshape(-1, 2), np.array(reports).reshape(-1, 2)


def _contacts(events: list[list[str]]) -> np.ndarray:
    return np.array([float(row[0]) for row in events if row[2] == "contact" and row[3] != "with=static"])


def _read_paths(file: pathlib.Path) -> dict[int, np.ndarray]:
    points: dict[int, list[tuple[float, float]]] = {}
    for row in _rows(file, 4):
        points.setdefault(int(row[0]), []).append((float(row[2]), float(row[3])))
    return {robot: np.array(places) for robot, places in sorted(points.items())}


def _read_path_lengths(file: pathlib.Path, robots: int) -> list[tuple[np.ndarray, np.ndarray]]:
    """Empty for a run that was recorded before this file existed."""
    if not file.exists():
        return []
    by_robot: list[tuple[list[float], list[float]]] = [([], []) for _ in range(robots)]
    for row in _rows(file, 3):
        times, lengths = by_robot[int(row[1]) - 1]
        times.append(float(row[0]))
        lengths.append(float(row[2]))
    return [(np.array(times), np.array(lengths)) for times, lengths in by_robot]


def _read_activities(file: pathlib.Path, robots: int) -> list[tuple[np.ndarray, list[str]]]:
    """Empty for a run that was recorded before this file existed."""
    if not file.exists():
        return []
    by_robot: list[tuple[list[float], list[str]]] = [([], []) for _ in range(robots)]
    for row in _rows(file, 3):
        times, names = by_robot[int(row[1]) - 1]
        times.append(float(row[0]))
        names.append(row[2])
    return [(np.array(times), names) for times, names in by_robot]
