#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Installs the build, moves the installed tree, hides the source and build trees, and does with it what the README of a new project says, in an
empty folder."""

import argparse
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[3]
HIDE = 'for folder in "$SOURCE" "$BUILD"; do [ ! -d "$folder" ] || mount -t tmpfs tmpfs "$folder" || exit 1; done; exec "$@"'
FILES = ["CMakeLists.txt", "README.md", "flock.cpp", "flock.toml", "flock_test.cpp"]
HEADERS = ["condition.hpp", "controller.hpp", "deployment.hpp", "deployment_test.hpp", "parameters.hpp", "random.hpp", "robot.hpp", "seen.hpp",
           "types.hpp"]


class Failure(Exception):
    pass


def expect(condition: bool, text: str) -> None:
    if not condition:
        raise Failure(text)


class User:
    """Runs commands in a folder, as somebody who has only the installed tree."""

    def __init__(self, build: pathlib.Path, prefix: pathlib.Path, folder: pathlib.Path) -> None:
        self.folder = folder
        self.environment = {"PATH": f"{prefix}/bin:/usr/local/bin:/usr/bin:/bin", "HOME": str(folder), "LC_ALL": "C",
                            "SOURCE": str(ROOT), "BUILD": str(build)}
        self.hidden = self.way_to_hide()
        print("source and build trees are hidden" if self.hidden else "nothing can be mounted: source and build trees stay visible", flush=True)

    def way_to_hide(self) -> list[str]:
        for options in (["--mount"], ["--user", "--map-root-user", "--mount"]):
            words = ["/usr/bin/unshare", *options, "/bin/sh", "-c", HIDE, "sh"]
            tried = subprocess.run([*words, "test", "!", "-e", str(ROOT / "CMakeLists.txt")], env=self.environment, cwd=self.folder, check=False,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            if tried.returncode == 0:
                return words
        return []

    def run(self, command: str, exit_code: int = 0) -> str:
        print(f"$ {command}", flush=True)
        done = subprocess.run([*self.hidden, "/bin/sh", "-c", command], cwd=self.folder, env=self.environment, check=False, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL)
        expect(done.returncode == exit_code, f"{command}: exit code {done.returncode}\n{done.stdout}")
        return done.stdout


def install(build: pathlib.Path, prefix: pathlib.Path) -> None:
    done = subprocess.run(["cmake", "--install", str(build), "--prefix", str(prefix), "--strip"], check=False, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    expect(done.returncode == 0, done.stdout)


def check_paths(build: pathlib.Path, prefix: pathlib.Path) -> None:
    """Nothing names the folders of the source or build tree."""
    names = [f"{ROOT}/{entry}".encode() for entry in os.listdir(ROOT)] + [f"{build}/".encode()]
    found = [f"{file}: {name.decode()}" for file in prefix.rglob("*") if file.is_file() for name in names if name in file.read_bytes()]
    expect(not found, "\n".join(found))


def check_headers(user: User, prefix: pathlib.Path) -> None:
    """The headers are in a folder of their own, and each can be included alone."""
    expect(os.listdir(prefix / "include") == ["caravan"], "include has more than the folder caravan")
    expect(sorted(os.listdir(prefix / "include/caravan")) == HEADERS, str(os.listdir(prefix / "include/caravan")))
    for header in HEADERS:
        user.run(f"echo '#include <caravan/{header}>' | g++ -std=c++20 -fsyntax-only -I {prefix}/include -x c++ -")


def check_errors(user: User) -> None:
    for name, reason in (("flock", "flock exists already"), ("My-Swarm", '"My-Swarm" is not a name for a project'), ("test", '"test" is reserved')):
        said = user.run(f"caravan new {name}", exit_code=2)
        expect(said.startswith(f"caravan new: {reason}") and said.count("\n") == 1, said)


def commands_of(readme: pathlib.Path) -> list[str]:
    return [line for block in re.findall(r"^```sh\n(.*?)^```$", readme.read_text(encoding="utf-8"), re.M | re.S) for line in block.splitlines()]


def check_runs(folder: pathlib.Path) -> list[pathlib.Path]:
    """Both engines gave the same run of the project's controller."""
    runs = sorted(folder.glob("runs/flock-*"))
    results = [json.loads((run / "metrics.json").read_text(encoding="utf-8")) for run in runs]
    expect(sorted(result["engine"] for result in results) == ["dds", "embedded"], str(runs))
    expect({result["controller"] for result in results} == {"flock"}, str([result["controller"] for result in results]))
    expect(len({result["digest"] for result in results}) == 1, "the engines give different digests")
    return runs


def check_links(prefix: pathlib.Path) -> None:
    """What the pages link to is installed."""
    texts = {page: re.sub(r"^```.*?^```$", "", page.read_text(encoding="utf-8"), flags=re.M | re.S) for page in prefix.rglob("*.md")}
    links = [(page, link) for page, text in texts.items() for link in re.findall(r"\]\(([^)#\s]+)", text)]
    inner = [(page, link) for page, link in links if "://" not in link]
    expect(len(inner) > 100, f"only {len(inner)} links in the installed pages")
    broken = [f"{page}: {link}" for page, link in inner
              if not (page.parent / link).exists() or not (page.parent / link).resolve().is_relative_to(prefix.resolve())]
    expect(not broken, "\n".join(broken))


def check_named_files(build: pathlib.Path, prefix: pathlib.Path) -> None:
    """What the pages name as ~/caravan/... is there in the installed tree, and in the build tree, which can take its place."""
    pages = "".join(page.read_text(encoding="utf-8") for page in prefix.rglob("*.md"))
    named = sorted(set(re.findall(r"~/caravan/([\w./-]*\w)", pages)))
    expect(len(named) > 8, str(named))
    missing = [f"{tree}/{name}" for name in named for tree in (prefix, build) if not (tree / name).exists() and not (tree == build and name.startswith("include"))]
    expect(not missing, "\n".join(missing))


def check_texts(user: User, prefix: pathlib.Path) -> None:
    """Files that help, advice, units and containers name are installed."""
    texts = "".join(user.run(f"{prefix}/bin/{command} --help") for command in ("caravan run", "caravan", "caravan ctl", "agent_contract"))
    profile = (prefix / "share/caravan/fastdds/discovery.xml").read_text(encoding="utf-8")
    (user.folder / "mine.xml").write_text(profile.replace("11811", "11789"), encoding="utf-8")
    texts += user.run(f"{prefix}/bin/caravan doctor --transport mine.xml || true")
    named = re.findall(r"/\S+\.md", texts) + re.findall(r"-x (\S+\.xml)", texts)
    expect(len(named) >= 6 and named[-1].endswith(".xml"), texts)
    for file in [*(prefix / "share/caravan/systemd").glob("*.service"), *(ROOT / "deploy/container").iterdir()]:
        named += [f"{prefix}/{name}" for name in re.findall(r"/opt/caravan/([^\s:,]+)", file.read_text(encoding="utf-8"))]
    missing = [name for name in named if not pathlib.Path(name).exists()]
    expect(not missing, "\n".join(missing))


def check_contract(user: User, prefix: pathlib.Path) -> None:
    """The agent contract suite judges an agent of the package, and one that is a program of the user's."""
    said = user.run(f"{prefix}/bin/agent_contract --gtest_filter=*P50* -- --controller {prefix}/lib/caravan/controllers/braitenberg.so")
    expect("[  PASSED  ] 1 test." in said, said)
    user.run("printf '#!/bin/sh\\nexec sleep 60\\n' > silent && chmod +x silent")
    said = user.run(f"TMPDIR=$HOME {prefix}/bin/agent_contract --agent ./silent --patience 1 --gtest_filter=*P53*", exit_code=1)
    expect("tests/contract/agent/step_rules.cpp:" in said and "[  FAILED  ] 1 test" in said, said)


def test(build: pathlib.Path, folder: pathlib.Path) -> None:
    install(build, folder / "first")
    prefix = (folder / "first").rename(folder / "second")
    check_paths(build, prefix)
    check_links(prefix)
    check_named_files(build, prefix)
    (folder / "work").mkdir()
    user = User(build, prefix, folder / "work")
    check_headers(user, prefix)
    user.run("caravan new flock")
    expect(sorted(os.listdir(folder / "work/flock")) == FILES, str(os.listdir(folder / "work/flock")))
    check_errors(user)
    user.folder = folder / "work/flock"
    commands = commands_of(user.folder / "README.md")
    expect(len(commands) >= 5, "the README has no commands")
    for command in commands:
        user.run(command)
    runs = check_runs(user.folder)
    user.run(f"caravan report {runs[0]}")
    expect((runs[0] / "report/report.html").is_file(), "there is no report")
    # What the package finds without PATH, and the other files that are installed.
    user.environment["PATH"] = "/usr/local/bin:/usr/bin:/bin"
    user.run(f"cmake -B other -DCMAKE_PREFIX_PATH={prefix}")
    caravan, share = f"{prefix}/bin/caravan", f"{prefix}/share/caravan"
    user.run(f"{caravan} run {share}/scenarios/small.toml --engine embedded --items 0 --max-time 5 --quiet"
             f" --controller {prefix}/lib/caravan/controllers/braitenberg.so")
    user.run(f"{caravan} deploy {share}/scripts/robot_killed.toml --check")
    check_texts(user, prefix)
    check_contract(user, prefix)


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("--build", type=pathlib.Path, required=True)
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="caravan_package_") as name:
        try:
            test(arguments.build.resolve(), pathlib.Path(name))
        except Failure as failure:
            print(failure)
            return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
