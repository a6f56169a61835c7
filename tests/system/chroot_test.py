#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""deploy/chroot: what it refuses, in one line each, and that a command leaves nothing mounted and nobody running. What needs a Debian that
is made already (build/chroot) is skipped where there is none."""

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
    """Without what other tests mount meanwhile."""
    return "\n".join(line for line in pathlib.Path("/proc/self/mountinfo").read_text().splitlines() if "chroot" in line)


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
            programs = pathlib.Path(folder) / "bin"
            programs.mkdir()
            for name in ("bash", "id", "dirname", "mkdir", "flock", "realpath", "apt-get"):
                (programs / name).symlink_to(shutil.which(name) or "/nowhere")
            self.check_refusal(["env", f"PATH={programs}", CHROOT, "--folder", folder, "13", "true"], "debootstrap is not installed")

    @unittest.skipUnless(IS_ROOT and shutil.which("debootstrap"), "needs root and debootstrap")
    def test_says_that_the_mirror_is_out_of_reach(self):
        with tempfile.TemporaryDirectory() as folder:
            self.check_refusal(["unshare", "--net", CHROOT, "--folder", folder, "13", "true"], "cannot be reached")


@unittest.skipUnless(MADE and IS_ROOT, "no Debian is made in build/chroot, or not root")
class Command(unittest.TestCase):

    def test_has_its_exit_code_its_tree_and_its_file_systems(self):
        script = "test -f CMakeLists.txt && test $PWD = /caravan && python3 -c 'import os; os.openpty()' && mountpoint -q /dev/shm && exit 7"
        result = run([CHROOT, MADE[0], "sh", "-c", script])
        self.assertEqual(result.returncode, 7, result.stderr)

    def test_leaves_nothing_mounted_and_nobody_running(self):
        before = mounts()
        # 86399 s: a number that nobody else sleeps for
        result = run([CHROOT, MADE[0], "sh", "-c", "sleep 86399 > /dev/null 2>&1 & touch /dev/shm/left"])
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(mounts(), before)
        self.assertFalse("sleep 86399" in run(["ps", "-eo", "args"]).stdout)
        self.assertFalse((ROOT / "build/chroot" / MADE[0] / "root/dev/shm/left").exists())


if __name__ == "__main__":
    unittest.main()
