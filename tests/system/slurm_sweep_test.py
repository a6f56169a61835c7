#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Starts Slurm as a cluster of one node in a separate folder, submits a small sweep with deploy/slurm/submit, and compares its tables
with those of a sweep without Slurm. Does not touch a Slurm that the machine may run. Exit code 77: skipped, because a program is missing."""

import argparse
import contextlib
import os
import pathlib
import pwd
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCENARIO = ROOT / "deploy/scenarios/small.toml"
OPTIONS = ["--seeds", "1-2", "--modes", "none,full", "--items", "0", "--max-time", "60"]
SKIPPED = 77
PATIENCE_S = 1200.0  # enough for a busy machine

CONFIGURATION = """\
ClusterName=one
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={controller_port}
SlurmdPort={node_port}
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
CredType=cred/munge
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
ProctrackType=proctrack/{tracking}
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
ReturnToService=2
NodeName={host} NodeAddr=127.0.0.1 CPUs={cpus} RealMemory=1000 State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""


def free_ports(count: int) -> list[int]:
    with contextlib.ExitStack() as stack:
        sockets = [stack.enter_context(socket.socket()) for _ in range(count)]
        for one in sockets:
            one.bind(("127.0.0.1", 0))
        return [one.getsockname()[1] for one in sockets]


def program(name: str) -> str | None:
    return shutil.which(name, path=os.environ.get("PATH", "") + ":/usr/sbin:/sbin")


def until(what: str, holds) -> None:
    deadline = time.monotonic() + PATIENCE_S
    while not holds():
        if time.monotonic() > deadline:
            raise TimeoutError(f"{what}: not within {PATIENCE_S:.0f} s")
        time.sleep(0.2)


class Cluster:
    """munged, slurmctld and slurmd as our children; ended in reverse order."""

    def __init__(self, folder: pathlib.Path):
        self.folder = folder
        self.daemons: list[subprocess.Popen] = []
        self.environment = {**os.environ, "SLURM_CONF": str(folder / "slurm.conf")}

    def __enter__(self) -> "Cluster":
        host = socket.gethostname().split(".")[0]
        controller_port, node_port = free_ports(2)
        (self.folder / "state").mkdir()
        (self.folder / "spool").mkdir()
        key = self.folder / "munge.key"
        key.write_bytes(os.urandom(1024))
        key.chmod(0o400)
        (self.folder / "slurm.conf").write_text(CONFIGURATION.format(
            host=host, controller_port=controller_port, node_port=node_port, folder=self.folder, cpus=os.cpu_count(),
            user=pwd.getpwuid(os.getuid()).pw_name, tracking="linuxproc" if os.getuid() == 0 else "pgid"))
        (self.folder / "cgroup.conf").write_text("CgroupPlugin=cgroup/v1\n")  # unlike v2 it does nothing unless asked
        try:
            self.start("munged", "--foreground", "--force", "--key-file", key, "--socket", self.folder / "munge.socket", "--pid-file",
                       self.folder / "munged.pid", "--log-file", self.folder / "munged.log", "--seed-file", self.folder / "munged.seed")
            until("munged", (self.folder / "munge.socket").exists)
            self.start("slurmctld", "-D", "-f", self.folder / "slurm.conf")
            self.start("slurmd", "-D", "-f", self.folder / "slurm.conf", "-N", host)
            until("an idle node", lambda: self.ask("sinfo", "--noheader", "--format=%T") == "idle")
        except BaseException:
            self.__exit__()
            raise
        return self

    def __exit__(self, *_) -> None:
        for daemon in reversed(self.daemons):
            daemon.send_signal(signal.SIGTERM)
            try:
                daemon.wait(10)
            except subprocess.TimeoutExpired:
                daemon.kill()
                daemon.wait()

    def start(self, name: str, *arguments) -> None:
        with open(self.folder / f"{name}.out", "wb") as log:
            self.daemons.append(subprocess.Popen([program(name), *map(str, arguments)], stdout=log, stderr=subprocess.STDOUT,
                                                 env=self.environment))

    def ask(self, name: str, *arguments) -> str:
        asked = subprocess.run([program(name), *arguments], capture_output=True, text=True, check=False, env=self.environment)
        return asked.stdout.strip()

    def has_no_jobs(self) -> bool:
        asked = subprocess.run([program("squeue"), "--noheader"], capture_output=True, text=True, check=False, env=self.environment)
        return asked.returncode == 0 and not asked.stdout.strip()


def sweep_on(cluster: Cluster, caravan: pathlib.Path, out: pathlib.Path) -> None:
    submitted = subprocess.run([ROOT / "deploy/slurm/submit", "--caravan", caravan, SCENARIO, *OPTIONS, "--out", out], text=True,
                               capture_output=True, check=False, env=cluster.environment)
    print(submitted.stdout + submitted.stderr, end="")
    if submitted.returncode != 0:
        raise RuntimeError(f"submit: exit code {submitted.returncode}")
    until("the jobs' end", cluster.has_no_jobs)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--caravan", type=pathlib.Path, default=ROOT / "build/release/bin/caravan")
    caravan = parser.parse_args().caravan.resolve()
    missing = [name for name in ("munged", "slurmctld", "slurmd", "sbatch", "squeue", "sinfo") if program(name) is None]
    if missing:
        print(f"skipped: {', '.join(missing)} not found (apt-get install slurm-wlm munge)")
        return SKIPPED
    folder = pathlib.Path(tempfile.mkdtemp(prefix="caravan_slurm_"))
    alone, array = folder / "alone", folder / "array"
    with Cluster(folder) as cluster:
        sweep_on(cluster, caravan, array)
        sweep_on(cluster, caravan, array)  # again: everything is already done
    subprocess.run([caravan, "sweep", SCENARIO, *OPTIONS, "--out", alone, "--quiet"], check=True)
    for name in ("summary.csv", "sweep.json"):
        if not (array / name).exists() or (array / name).read_bytes() != (alone / name).read_bytes():
            print(f"{name} differs from that of a sweep without Slurm; everything is kept in {folder}")
            return 1
    print((array / "logs/slurm_tables.txt").read_text(), end="")
    print("the same tables as without Slurm")
    shutil.rmtree(folder)
    return 0


if __name__ == "__main__":
    sys.exit(main())
