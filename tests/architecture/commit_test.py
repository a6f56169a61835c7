#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What cmake/commit.cmake says about trees in several states of git."""

import argparse
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

SKIPPED = 77
CMAKE = SCRIPT = ""


class CommitOfTheTree(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name).resolve()
        self.tree = self.folder / "tree"
        self.tree.mkdir()
        self.out = self.folder / "commit.cpp"

    def git(self, *words):
        who = ["-c", "user.name=Test", "-c", "user.email=test@localhost", "-c", "commit.gpgsign=false"]
        clean = {name: value for name, value in os.environ.items() if not name.startswith("GIT_")}
        done = subprocess.run(["git", *who, "-C", self.tree, *words], check=True, capture_output=True, text=True, env=clean)
        return done.stdout.strip()

    def commit(self, text="one\n"):
        (self.tree / "file").write_text(text)
        if not (self.tree / ".git").exists():
            self.git("init", "-q")
        self.git("add", "file")
        self.git("commit", "-q", "-m", "Change a file")
        return self.git("rev-parse", "HEAD")

    def said(self, tree=None, program=None, **variables):
        """Commit and state in the source that the script writes."""
        git = shutil.which("git") if program is None else program
        words = [CMAKE, "-D", f"SOURCE={tree or self.tree}", "-D", f"OUT={self.out}", "-D", f"GIT={git}", "-P", SCRIPT]
        subprocess.run(words, check=True, capture_output=True, env={**os.environ, **variables})
        return re.search(r'\.id = "(.*)", \.dirty = ([a-z:]+)}', self.out.read_text()).groups()

    def test_a_commit_is_named_in_full(self):
        head = self.commit()
        self.assertRegex(head, "^[0-9a-f]{40}$")
        self.assertEqual(self.said(), (head, "false"))

    def test_the_next_commit_is_named_after_it(self):
        first = self.commit()
        self.said()
        second = self.commit("two\n")
        self.assertNotEqual(first, second)
        self.assertEqual(self.said(), (second, "false"))

    def test_a_changed_file_is_seen_whether_it_is_staged_or_not(self):
        head = self.commit()
        (self.tree / "file").write_text("changed\n")
        self.assertEqual(self.said(), (head, "true"))
        self.git("add", "file")
        self.assertEqual(self.said(), (head, "true"))

    def test_files_that_git_does_not_know_change_nothing(self):
        head = self.commit()
        (self.tree / "notes").write_text("mine\n")
        self.assertEqual(self.said(), (head, "false"))

    def test_a_file_that_was_touched_only_is_not_changed(self):
        head = self.commit()
        os.utime(self.tree / "file", (1, 1))
        self.assertEqual(self.said(), (head, "false"))

    def test_a_worktree_has_its_own_commit(self):
        first = self.commit()
        self.git("worktree", "add", "-q", "--detach", str(self.folder / "other"))
        self.commit("two\n")
        self.assertEqual(self.said(tree=self.folder / "other"), (first, "false"))

    def test_an_unpacked_archive_is_unknown_also_inside_another_repository(self):
        self.assertEqual(self.said(), ("unknown", "std::nullopt"))
        self.commit()
        (self.tree / "archive").mkdir()
        self.assertEqual(self.said(tree=self.tree / "archive"), ("unknown", "std::nullopt"))

    def test_without_git_it_is_unknown(self):
        self.commit()
        self.assertEqual(self.said(program=""), ("unknown", "std::nullopt"))

    def test_a_repository_without_a_commit_is_unknown(self):
        self.git("init", "-q")
        self.assertEqual(self.said(), ("unknown", "std::nullopt"))

    def test_variables_of_a_hook_in_another_repository_change_nothing(self):
        head = self.commit()
        self.assertEqual(self.said(GIT_DIR=str(self.folder / "nowhere"), GIT_INDEX_FILE="/nowhere"), (head, "false"))

    def test_what_is_unchanged_is_not_written_again(self):
        self.commit()
        self.said()
        os.utime(self.out, (1, 1))
        self.said()
        self.assertEqual(self.out.stat().st_mtime, 1, "everything that uses it would be built again")
        self.commit("two\n")
        self.said()
        self.assertNotEqual(self.out.stat().st_mtime, 1)


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--script", required=True)
    parser.add_argument("--cmake", required=True)
    options, rest = parser.parse_known_args()
    CMAKE, SCRIPT = options.cmake, options.script
    if shutil.which("git") is None:
        print("skipped: git is not installed")
        sys.exit(SKIPPED)
    unittest.main(argv=[sys.argv[0], *rest])
