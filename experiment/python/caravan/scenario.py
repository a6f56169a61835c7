# SPDX-License-Identifier: Apache-2.0
"""A scenario and its changes."""

import os
import tomllib

from caravan import _engine

_CHANGED = " with changes"


class Scenario:
    """A scenario that has been checked as `caravan check` does. It does not change.

    Keys of [controller] belong to the controller: a Run checks them, when it makes one."""

    def __init__(self, text, file="scenario.toml"):
        """`file` names it in messages, and a relative path of a controller starts from its folder.

        Raises ScenarioError: file:line: key: reason."""
        self.text = text
        self.file = os.fspath(file)
        self.name, self.robots, self.items = _engine.check(self.text, self.file)

    @classmethod
    def load(cls, file):
        """Raises ScenarioError, also when the file cannot be read."""
        return cls(_engine.read(os.fspath(file)), file)

    def changed(self, changes):
        """The same with some keys changed: {"radio.range_m": 3.0}. A dict changes a table key by key, a list of dicts replaces a
        list of tables. Raises ScenarioError as if the keys stood in the file."""
        name = self.file if self.file.endswith(_CHANGED) else self.file + _CHANGED
        return Scenario(_engine.changed(self.text, self.file, changes, name), name)

    @property
    def tables(self):
        """Its keys as a dict of dicts. A key that it does not have has its default (docs/scenario.md)."""
        return tomllib.loads(self.text)
