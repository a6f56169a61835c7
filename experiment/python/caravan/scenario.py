# SPDX-License-Identifier: Apache-2.0
"""A scenario and its changes."""

import json
import os
import tomllib

from caravan import _engine

_CHANGED = " with changes"


class Scenario:
    """A scenario that has been checked as `caravan check` does. It does not change.

    Keys of [controller] belong to the controller: a Run checks them, when it makes one."""

    def __init__(self, text, file="scenario.toml", changes=None):
        """`file` names it in messages, and a relative path of a controller starts from its folder. `changes`: as changed() takes.

        Raises ScenarioError: file:line: key: reason."""
        self.file = os.fspath(file)
        settings = [(key, _toml(key, value)) for key, value in (changes or {}).items()]
        self.text, self.name, self.robots, self.items = _engine.check(text, self.file, settings)
        if settings and not self.file.endswith(_CHANGED):
            self.file += _CHANGED  # its lines are others

    @classmethod
    def load(cls, file):
        """Raises ScenarioError, also when the file cannot be read."""
        return cls(_engine.read(os.fspath(file)), file)

    def changed(self, changes):
        """The same with some keys changed: {"radio.range_m": 3.0}. A dict changes a table key by key, a list of dicts replaces a
        list of tables. Values and arrays of NumPy will do. Raises ScenarioError, as for the option --set of the programs."""
        return Scenario(self.text, self.file, changes)

    @property
    def tables(self):
        """Its keys as a dict of dicts. A key that it does not have has its default (docs/scenario.md)."""
        return tomllib.loads(self.text)


def _toml(key, value):
    """A value as TOML."""
    if hasattr(value, "tolist"):  # NumPy's
        value = value.tolist()
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, (int, float)):
        return repr(value)
    if isinstance(value, (str, os.PathLike)):
        return json.dumps(os.fspath(value), ensure_ascii=False)
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(_toml(key, one) for one in value) + "]"
    if isinstance(value, dict):
        return "{" + ", ".join(f"{name} = {_toml(f'{key}.{name}', one)}" for name, one in value.items()) + "}"
    raise _engine.ScenarioError(f"changed {key}={value}: must be a number, True or False, a string, a path, a list or a dict")
