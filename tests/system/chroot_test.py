#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""deploy/chroot: its refusals, one line each, and that a command leaves nothing mounted and no process running. Tests that need an
existing Debian (build/chroot) are skipped without one. tests/run --both: the other release counts as skipped if none can be made."""

import fcntl
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
CHROOT = ROOT / "deploy/chroot"
MADE = [name for name in ("bookworm", "trixie") if (ROOT / "build/chroot" / name / "root").exists()]
IS_ROOT = os.geteuid() == 0


def run(line: list, **more) -> subprocess.CompletedProcess:
    return subprocess.run([str(word) for word in line], capture_output=True, text=True, check=False, timeout=600, **more)


def mounts() -> str:
    """Mounts, without those that other tests make meanwhile."""
    return "\n".join(line for line in pathlib.Path("/proc/self/mountinfo").read_text().splitlines() if "chroot" in line)


def programs_without_debootstrap(folder: str) -> pathlib.Path:
    programs = pathlib.Path(folder) / "bin"
    programs.mkdir()
    for name in ("bash", "id", "dirname", "mkdir", "flock", "realpath", "apt-get", "mktemp", "timeout", "tail", "rm"):
        (programs / name).symlink_to(shutil.which(name) or "/nowhere")
    return programs


class Refusals(unittest.TestCase):

    def check_refusal(self, line: list, words: str):
        result = run(line)
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertEqual(result.stdout, "")
        self.assertEqual(len(result.stderr.splitlines()), 1, result.stderr)
        self.assertIn(words, result.stderr)

    def test_names_the_releases_that_it_knows(self):
        self.check_refusal([CHROOT], "RELEASE is 12, 13, bookworm or trixie")
        self.check_refusal([CHROOT, "11", "true"], "RELEASE is 12, 13, bookworm or trixie")

    def test_wants_a_command(self):
        self.check_refusal([CHROOT, "13"], "no command given")
        self.check_refusal([CHROOT, "--folder"], "--folder needs a path")

    @unittest.skipUnless(IS_ROOT and shutil.which("setpriv"), "needs root, to become somebody else")
    def test_wants_root(self):
        self.check_refusal(["setpriv", "--reuid", "65534", CHROOT, "13", "true"], "only root")

    @unittest.skipUnless(IS_ROOT, "needs root")
    def test_wants_debootstrap(self):
        with tempfile.TemporaryDirectory() as folder:
            self.check_refusal(["env", f"PATH={programs_without_debootstrap(folder)}", CHROOT, "--folder", folder, "13", "true"], "debootstrap is not installed")

    @unittest.skipUnless(IS_ROOT and shutil.which("debootstrap"), "needs root and debootstrap")
    def test_says_that_the_mirror_is_out_of_reach(self):
        with tempfile.TemporaryDirectory() as folder:
            self.check_refusal(["unshare", "--net", CHROOT, "--folder", folder, "13", "true"], "cannot be reached")


@unittest.skipUnless(IS_ROOT, "needs root")
class OtherRelease(unittest.TestCase):
    """tests/run --both where it cannot test the other release: it gives the reason, and nothing fails."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def check_skipped(self, before: list, words: str, end_s: str = ""):
        count = '. tests/other_release.sh; passed=0 failed=0 skipped=0; test_other_release "$1" "$2"; echo $passed $failed $skipped'
        result = run([*before, "bash", "-euo", "pipefail", "-c", count, "bash", end_s, self.folder], cwd=ROOT)
        self.assertEqual(result.returncode, 0, result.stderr)
        lines = result.stdout.splitlines()
        self.assertEqual(lines[-1], "0 0 1", result.stdout + result.stderr)
        self.assertRegex(lines[-2], f"^Skipped on the other Debian release: .*{words}")

    def test_is_skipped_without_debootstrap(self):
        self.check_skipped(["env", f"PATH={programs_without_debootstrap(self.folder)}"], "debootstrap is not installed")

    @unittest.skipUnless(shutil.which("debootstrap"), "needs debootstrap")
    def test_is_skipped_when_the_mirror_is_out_of_reach(self):
        self.check_skipped(["unshare", "--net"], "cannot be reached")

    @unittest.skipUnless(shutil.which("setpriv"), "needs setpriv")
    def test_is_skipped_for_one_who_is_not_root(self):
        self.check_skipped(["setpriv", "--reuid", "65534"], "only root")

    @unittest.skipUnless(shutil.which("setpriv"), "needs setpriv")
    def test_is_skipped_where_nothing_can_be_mounted(self):
        os.makedirs(f"{self.folder}/root/etc")
        self.check_skipped(["setpriv", "--bounding-set", "-sys_admin"], "Operation not permitted")

    def test_is_skipped_when_its_time_is_over(self):
        # Creating it now takes forever, as with a mirror that sends nothing.
        with open(f"{self.folder}/lock", "w", encoding="ascii") as lock:
            fcntl.flock(lock, fcntl.LOCK_EX)
            self.check_skipped([], "did not come within 1 s", end_s="1")


@unittest.skipUnless(MADE and IS_ROOT, "no Debian is made in build/chroot, or not root")
class Command(unittest.TestCase):

    def test_has_its_exit_code_its_tree_and_its_file_systems(self):
        script = "test -f CMakeLists.txt && test $PWD = /caravan && python3 -c 'import os; os.openpty()' && mountpoint -q /dev/shm && exit 7"
        result = run([CHROOT, MADE[0], "sh", "-c", script])
        self.assertEqual(result.returncode, 7, result.stderr)

    def test_leaves_nothing_mounted_and_nobody_running(self):
        before = mounts()
        # 86399 s: a time that no other process sleeps
        result = run([CHROOT, MADE[0], "sh", "-c", "sleep 86399 > /dev/null 2>&1 & touch /dev/shm/left"])
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(mounts(), before)
        self.assertFalse("sleep 86399" in run(["ps", "-eo", "args"]).stdout)
        self.assertFalse((ROOT / "build/chroot" / MADE[0] / "root/dev/shm/left").exists())


if __name__ == "__main__":
    unittest.main()
