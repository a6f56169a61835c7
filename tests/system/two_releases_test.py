#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The programs of this build and of the build that deploy/chroot made on the other Debian release: the same digests, and one swarm over
UDP with processes of both. Exit code 77: skipped, because there is no such build."""

import argparse
import contextlib
import fcntl
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCENARIO = "deploy/scenarios/small.toml"
RELEASES = ("bookworm", "trixie")
SKIPPED = 77
PATIENCE_S = 600.0  # ends only a run that is stuck


class Build:
    """Programs of one release, started from the top of the tree."""

    def __init__(self, name: str, prefix: list, programs: str):
        self.name, self.prefix, self.programs = name, prefix, programs

    def line(self, program: str, *options: str) -> list:
        return [*self.prefix, f"{self.programs}/{program}", *options]


def builds(folder: pathlib.Path | None, preset: str) -> list:
    """The build of this machine and, if there is one, that of the other release."""
    programs = f"build/{preset}/bin"
    found = [Build("this release", [], programs)] if (ROOT / programs / "caravan").exists() else []
    for release in RELEASES:
        place = folder or ROOT / "build/chroot" / release
        if not (place / programs / "caravan").exists() or os.geteuid() != 0:
            continue
        version = (place / "root/etc/os-release").read_text()
        if f"VERSION_CODENAME={release}" in version:
            found.append(Build(release, ["deploy/chroot", "--folder", str(place), release], programs))
    return found


def embedded_digest(build: Build, seconds: str, seed: str) -> str:
    out = f"/tmp/two_releases_{os.getpid()}_{seed}"
    run = f"{build.programs}/caravan run {SCENARIO} --engine embedded --items 0 --max-time {seconds} --seed {seed} --out {out} && rm -r {out}"
    done = subprocess.run([*build.prefix, "sh", "-c", run], cwd=ROOT, check=True, capture_output=True, text=True, timeout=PATIENCE_S)
    return re.search(r"^digest\s+([0-9a-f]+)$", done.stdout, re.M)[1]


@contextlib.contextmanager
def free_domain():
    """A DDS domain that no run of this machine uses; locked in the same way as runtime/host/domain_lock.cpp does."""
    for domain in range(229, 99, -1):
        with open(f"{tempfile.gettempdir()}/caravan_domain_{domain}.lock", "a", encoding="ascii") as lock:
            try:
                fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except OSError:
                continue
            yield str(domain)
            return
    sys.exit("no free DDS domain")


def swarm_digest(world: Build, radio: Build, agents: dict) -> str:
    """The digest of the whole scenario over UDP. agents: robots such as "1,2" and the build of their agents."""
    with free_domain() as domain, tempfile.TemporaryDirectory() as folder, contextlib.ExitStack() as ended:

        def start(build: Build, program: str, *options: str) -> pathlib.Path:
            log = pathlib.Path(folder) / f"{program}{'_'.join(options)}.log"
            line = build.line(program, "--scenario", SCENARIO, "--domain", domain, "--transport", "udp", *options)
            process = subprocess.Popen(line, cwd=ROOT, stdout=log.open("w"), stderr=subprocess.STDOUT)
            ended.callback(process.wait)
            # A program in a chroot ends with its namespace; the others remove their files in shared memory.
            ended.callback(process.send_signal, signal.SIGKILL if build.prefix else signal.SIGTERM)
            return log

        log = start(world, "world_server")
        others = [start(radio, "radio_emulator")]
        others += [start(build, "robot_agent", "--robots", robots) for robots, build in agents.items()]
        deadline = time.monotonic() + PATIENCE_S
        while time.monotonic() < deadline:
            if found := re.search(r"finished sim_s=.* digest=([0-9a-f]+)", log.read_text()):
                return found[1]
            time.sleep(0.2)
        return "no end:\n" + "".join(path.read_text() for path in [log, *others])


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--folder", type=pathlib.Path, help="of deploy/chroot; build/chroot/RELEASE when not given")
    parser.add_argument("--preset", default="dev")
    arguments = parser.parse_args()
    both = builds(arguments.folder, arguments.preset)
    if len(both) < 2:
        print("no build of the other Debian release in build/chroot (deploy/chroot): nothing to compare")
        return SKIPPED
    this, other = both[:2]
    # A build older than the tree would differ from the other because of later changes.
    subprocess.run([*other.prefix, "cmake", "--build", "--preset", arguments.preset, "--target", "caravan", "world_server",
                    "radio_emulator", "robot_agent"], cwd=ROOT, check=True, stdout=subprocess.DEVNULL)
    results = {}
    for seed in ("1", "7"):
        results[f"embedded, seed {seed}"] = {build.name: embedded_digest(build, "600", seed) for build in both}
    results["one swarm"] = {
        f"world of {this.name}": swarm_digest(this, other, {"1,2": this, "3,4": other}),
        f"world of {other.name}": swarm_digest(other, this, {"1,2": other, "3,4": this}),
    }
    for what, digests in results.items():
        print(what, digests)
    return 0 if all(len(set(digests.values())) == 1 for digests in results.values()) else 1


if __name__ == "__main__":
    sys.exit(main())
