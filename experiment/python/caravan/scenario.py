# SPDX-License-Identifier: Apache-2.0
"""A scenario and its changes."""

import pathlib
import tomllib

from caravan import _engine


class Scenario:
    """A scenario whose every key has been checked, as `caravan check` does. It does not change."""

    def __init__(self, text, file="scenario.toml"):
        """`file` names it in messages, and a relative path of a controller starts from its folder.

        Raises ScenarioError: file:line: key: reason."""
        self.text = text
        self.file = str(file)
        _engine.check(self.text, self.file)

    @classmethod
    def load(cls, file):
        return cls(pathlib.Path(file).read_text(encoding="utf-8"), pathlib.Path(file).resolve())

    def changed(self, changes):
        """The same with some keys changed: {"radio.range_m": 3.0}. A table is a dict, a list of tables a list of dicts.

        Raises ScenarioError for a key that no scenario has, and for a value that its reader refuses."""
        name = self.file if self.file.endswith(" with changes") else self.file + " with changes"
        return Scenario(_engine.changed(self.text, self.file, changes), name)

    @property
    def tables(self):
        """Its keys as a dict of dicts. A key that it does not have has its default (docs/scenario.md)."""
        return tomllib.loads(self.text)
