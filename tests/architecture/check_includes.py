#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks which folder includes what, and that there are no cycles. Prints every breach; exit code 1 when there is one."""

import pathlib
import re
import sys

# The target of an include: a kind of outside header or a folder of the project.
STD, POSIX, EIGEN, ODE, DDS = "std posix Eigen ode dds".split()
CONTROLLER = "controller"  # the public headers: what a controller outside of this tree includes
ROBOT_TYPES, TRUTH_TYPES, GENERATED = "robot-types truth-types generated".split()
KIT = "kit"  # the public headers of the test kit: for tests outside of this tree as well
KIT_HEADERS = re.compile(r"caravan/(condition|deployment|deployment_test|seen)\.hpp")
TOML, JSON, LOG, CLI, GTEST, PYBIND = "toml++ json spdlog CLI11 gtest pybind11".split()
CONFIG = ["runtime/config", "runtime/scenario", "runtime/pure"]
PROCESS = [STD, POSIX, LOG, "runtime", "idl"]

# Folder -> what its files may include besides their own folder. The longest matching folder decides.
ALLOWED = {
    "runtime/controller/include": [STD, CONTROLLER],
    "runtime/controller": [STD, POSIX, CONTROLLER, "runtime/config", "runtime/pure", "runtime/trace"],
    "runtime/controller/python": [STD, POSIX, CONTROLLER, PYBIND],
    "runtime/pure": [STD, CONTROLLER],
    "runtime/config": [STD, TOML, "runtime/pure"],
    "runtime/scenario": [STD, "runtime/config", "runtime/pure"],
    "runtime/trace": [STD, "runtime/config"],
    "runtime/provenance": [STD, POSIX, JSON, "runtime/config", "runtime/process/version.hpp"],
    "runtime/process": [STD, POSIX, LOG, CLI, "runtime/config", "runtime/pure", "runtime/bus/transport.hpp"],
    "runtime/bus": [STD, POSIX, LOG, DDS, ROBOT_TYPES, "idl", "runtime/config", "runtime/pure"],
    "runtime/host": [STD, POSIX, "runtime/bus", "runtime/config"],
    "runtime/control": [STD, LOG, TRUTH_TYPES, "runtime/pure"],
    "idl": [STD, ROBOT_TYPES, TRUTH_TYPES, GENERATED],
    "robot_agent/core": [STD, EIGEN, CONTROLLER, "runtime/pure"],
    "robot_agent/config": [STD, EIGEN, *CONFIG, "robot_agent/core"],
    "robot_agent/controller": [STD, EIGEN, CONTROLLER, "runtime/config", "runtime/controller", "robot_agent/core", "robot_agent/config"],
    "robot_agent": [*PROCESS, CONTROLLER, EIGEN, DDS, ROBOT_TYPES, "robot_agent"],
    "world_server/physics": [STD, ODE, *CONFIG, "world_server"],
    "world_server/config": [STD, *CONFIG, "world_server"],
    "world_server/shell": [*PROCESS, DDS, ROBOT_TYPES, TRUTH_TYPES, "world_server"],
    "world_server": [STD, CONTROLLER, *CONFIG, "world_server"],
    "world_server/main.cpp": [*PROCESS, "world_server"],
    "radio_emulator/medium": [STD, "runtime/pure"],
    "radio_emulator/config": [STD, *CONFIG, "radio_emulator/medium"],
    "radio_emulator": [*PROCESS, DDS, ROBOT_TYPES, TRUTH_TYPES, "radio_emulator"],
    "hardware_bridge/core": [STD, "runtime/pure"],
    "hardware_bridge/config": [STD, *CONFIG, "hardware_bridge/core"],
    "hardware_bridge": [*PROCESS, DDS, ROBOT_TYPES, "hardware_bridge"],
    "experiment": [STD, "runtime/config", "runtime/process", "runtime/bus/transport.hpp", "experiment/metrics"],
    "experiment/metrics": [STD, POSIX, JSON, CONTROLLER, "runtime/config", "runtime/pure", "runtime/provenance"],
    "experiment/check": [STD, EIGEN, *CONFIG, "experiment/metrics", "robot_agent/config", "robot_agent/core", "world_server/config",
                         "world_server/types.hpp", "radio_emulator/config", "radio_emulator/medium", "hardware_bridge/config"],
    "experiment/embedded": [STD, EIGEN, CONTROLLER, *CONFIG, "runtime/process", "runtime/trace", "experiment/metrics",
                            "experiment/run_request.hpp", "robot_agent/controller", "robot_agent/core", "robot_agent/config", "runtime/controller", "world_server",
                            "radio_emulator/medium", "radio_emulator/config"],
    "experiment/python": [STD, TOML, PYBIND, *CONFIG, "experiment/check", "experiment/embedded", "experiment/metrics", "runtime/controller",
                          "robot_agent/controller", "world_server"],
    "experiment/trace": [STD, EIGEN, JSON, CONTROLLER, *CONFIG, "runtime/trace", "runtime/process", "experiment/metrics",
                         "experiment/run_request.hpp", "robot_agent/config", "robot_agent/controller", "runtime/controller"],
    "experiment/sweep": [STD, POSIX, JSON, TOML, "runtime/config", "runtime/pure", "runtime/process", "runtime/provenance/provenance.hpp", "runtime/host/children.hpp", "experiment/metrics"],
    "experiment/report": [STD, POSIX, "runtime/config", "runtime/process"],
    "deploy/observer": [*PROCESS, DDS, ROBOT_TYPES, TRUTH_TYPES, "experiment/metrics"],
    "deploy/launcher": [*PROCESS, DDS, TRUTH_TYPES, "deploy/observer", "experiment/metrics", "experiment/run_request.hpp"],
    "deploy/kit": [*PROCESS, DDS, ROBOT_TYPES, TRUTH_TYPES, TOML, KIT, "deploy/control", "deploy/observer",
                   "deploy/launcher/run_commands.hpp", "experiment/metrics", "robot_agent/core/radio/frames"],
    "deploy/kit/include": [STD, POSIX, GTEST, KIT],
    "deploy/templates": [STD, CONTROLLER, KIT],
    "deploy/control": [*PROCESS, DDS, ROBOT_TYPES, TRUTH_TYPES],
    "deploy/controllers": [STD, CONTROLLER],
    "deploy/doctor": [STD, POSIX, "runtime"],
    "deploy/cli": [STD, POSIX, EIGEN, TOML, CLI, *CONFIG, "runtime/controller", "runtime/process", "runtime/host", "runtime/provenance", "runtime/bus/transport.hpp", "deploy",
                   "experiment", "robot_agent/config", "robot_agent/controller", "robot_agent/core", "world_server", "radio_emulator/config",
                   "radio_emulator/medium", "hardware_bridge/config"],
}
SHELLS = ("robot_agent/shell", "world_server/shell", "radio_emulator/shell", "hardware_bridge/shell")

# A core is a function of values: no input other than its arguments is allowed.
CORES = ("runtime/controller/include", "robot_agent/core", "radio_emulator/medium", "hardware_bridge/core", "world_server/physics", "world_server/barrier", "world_server/control",
         "world_server/referee", "world_server/sensors", "world_server/shapes", "world_server/starts",
         "world_server/world.cpp", "world_server/world.hpp", "world_server/types.hpp", "runtime/pure")
NOT_IN_A_CORE = {"thread", "mutex", "condition_variable", "future", "atomic", "fstream", "iostream", "filesystem",
                 "random", "ctime", "unordered_map", "unordered_set"}
NO_CLOCK = re.compile(r"_clock::now\b")

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.M)
# The short names of the generated types; only these files may include the generated headers.
NAMES_FOR_ROBOTS = re.compile(r"idl/(robot|clock)_types\.hpp")
NAMES_OF_TRUTH = re.compile(r"idl/(world|control)_types\.hpp")
GENERATED_HEADERS = re.compile(r"(robot|stamp|clock|world|control)(PubSubTypes)?\.h")
POSIX_HEADERS = re.compile(r"(sys/.*|unistd|fcntl|dlfcn|poll|termios|sched|pthread|signal|dirent|spawn|netdb|ifaddrs|gnu/libc-version|arpa/.*|netinet/.*|pwd)\.h$")
OUTSIDE = {"caravan": CONTROLLER, "Eigen": EIGEN, "ode": ODE, "fastdds": DDS, "fastrtps": DDS, "fastcdr": DDS, "toml++": TOML,
           "nlohmann": JSON, "spdlog": LOG, "CLI": CLI, "gtest": GTEST, "pybind11": PYBIND}


def kind_of(bracket, name, top_folders):
    """The target of an include: a kind of outside header, or the path inside the project; None if unknown."""
    first = name.split("/")[0]
    if bracket == '"':
        if NAMES_OF_TRUTH.fullmatch(name):
            return TRUTH_TYPES
        if NAMES_FOR_ROBOTS.fullmatch(name):
            return ROBOT_TYPES
        if first in top_folders and "/" in name:
            return name
        return GENERATED if GENERATED_HEADERS.fullmatch(name) else None
    if KIT_HEADERS.fullmatch(name):
        return KIT
    if first in OUTSIDE and "/" in name:
        return OUTSIDE[first]
    if POSIX_HEADERS.fullmatch(name):
        return POSIX
    return STD if re.fullmatch(r"[a-z_0-9]+", name) else None


def rule_for(path):
    matches = [folder for folder in ALLOWED if path == folder or path.startswith(folder + "/")]
    return max(matches, key=len, default=None)


def is_inside(path, folder):
    return path == folder or path.startswith(folder + "/")


def breaches_of(path, text, top_folders):
    rule = rule_for(path)
    if rule is None:
        yield f"{path}: no rule says what this folder may include"
        return
    core = any(is_inside(path, folder) for folder in CORES)
    if core and NO_CLOCK.search(text):
        yield f"{path}: a core asks no clock"
    for bracket, name in INCLUDE.findall(text):
        kind = kind_of(bracket, name, top_folders)
        if kind is None:
            yield f"{path}: unknown include {name}"
        elif core and kind == STD and name in NOT_IN_A_CORE:
            yield f"{path}: <{name}> has no place in a core"
        elif "/" not in kind:
            if kind not in ALLOWED[rule]:
                yield f"{path}: {rule} must not include {name} ({kind})"
        elif not any(is_inside(kind, folder) for folder in [rule, *ALLOWED[rule]]):
            yield f"{path}: {rule} must not include {name}"
        elif any(is_inside(kind, shell) for shell in SHELLS) and path.split("/")[0] != kind.split("/")[0]:
            yield f"{path}: {name} belongs to another program"


def cycle_in(graph):
    """One cycle of the include graph as a list of files, or None."""
    state, trail = {}, []

    def visit(node):
        state[node] = "open"
        trail.append(node)
        for following in sorted(graph.get(node, ())):
            if state.get(following) == "open":
                return trail[trail.index(following):] + [following]
            if following not in state and (found := visit(following)):
                return found
        trail.pop()
        state[node] = "done"
        return None

    for node in sorted(graph):
        if node not in state and (found := visit(node)):
            return found
    return None


def check(root):
    top_folders = {"runtime", "idl", "robot_agent", "world_server", "radio_emulator", "hardware_bridge", "experiment", "deploy", "tests"}
    found, graph = [], {}
    for top in sorted(top_folders - {"tests"}):
        for file in sorted((root / top).rglob("*.[ch]pp")):
            path = file.relative_to(root).as_posix()
            text = file.read_text()
            found += breaches_of(path, text, top_folders)
            graph[path] = {name for bracket, name in INCLUDE.findall(text) if bracket == '"' and (root / name).is_file()}
    cycle = cycle_in(graph)
    if cycle:
        found.append("cycle: " + " -> ".join(cycle))
    return found, len(graph)


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parents[2]).resolve()
    found, files = check(root)
    for breach in found:
        print(breach)
    print(f"{files} files, {len(found)} breaches")
    return 1 if found or files == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
