# SPDX-License-Identifier: Apache-2.0
"""Makes controllers from a Python file. Called by the host."""

import itertools
import os
import re
import sys
import traceback
import types

_numbers = itertools.count(1)
_PACKAGES = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
_codes = {}  # file -> its code, compiled once for a process


def _code_of(file):
    if file not in _codes:
        with open(file, "rb") as text:
            _codes[file] = compile(text.read(), file, "exec")
    return _codes[file]


def _is_from(folder, name):
    """Whether a module, or the package that it is in, lies in the folder as Python's text."""
    file = getattr(sys.modules.get(name.partition(".")[0]), "__file__", None)
    if not isinstance(file, str) or not file.endswith(".py"):
        return False
    place = os.path.dirname(os.path.abspath(file))
    return folder == (os.path.dirname(place) if os.path.basename(file) == "__init__.py" else place)


def _run(file):
    """Runs the file as a new module. It and the modules that it imports from its folder belong to one controller only."""
    folder = os.path.dirname(os.path.abspath(file))
    if folder not in sys.path and not folder.startswith(_PACKAGES + os.sep):
        sys.path.insert(0, folder)
    name = f"{os.path.splitext(os.path.basename(file))[0]}:{next(_numbers)}"
    module = types.ModuleType(name)
    module.__file__ = file
    before = set(sys.modules)
    sys.modules[name] = module
    try:
        exec(_code_of(file), vars(module))
    finally:
        own = [other for other in set(sys.modules) - before - {name} if _is_from(folder, other)]
        for other in own:
            del sys.modules[other]
    return module


def _class_in(module):
    classes = [name for name, value in vars(module).items()
               if isinstance(value, type) and value.__module__ == module.__name__ and not name.startswith("_")
               and callable(getattr(value, "step", None))]
    if len(classes) == 1:
        return getattr(module, classes[0])
    if not classes:
        raise TypeError("there is no class with a function step(self, inputs)")
    raise TypeError(f"there is more than one class with a function step: {', '.join(classes)}; begin the names of all but "
                    "one with an underscore")


def make(file, robot, parameters):
    """A new controller for `robot`."""
    return _class_in(_run(file))(robot, parameters)


def _in_one_line(text):
    """The text of an error. That of a call of the host with wrong arguments has many lines: this call, and all that are possible."""
    call = re.match(r"(\w+)\(\): incompatible \w+ arguments\..*?1\. [\w.]*\((?:self: [^,)]*(?:, )?)?(.*?)\)(?: ->|\n)", text, re.DOTALL)
    return f"wrong arguments, {call[1]}() takes ({call[2]})" if call else text


def describe(error, file):
    """mine.py:12: ValueError: too far. The line is the last one in the controller's own file: that of its outermost call."""
    place = os.path.basename(file)
    calls = [(frame.f_code.co_filename, line) for frame, line in traceback.walk_tb(error.__traceback__)
             if not frame.f_code.co_filename.startswith(_PACKAGES + os.sep)]
    if calls:
        own = calls[0][0]
        place = f"{os.path.basename(own)}:{[line for name, line in calls if name == own][-1]}"
    try:
        text = _in_one_line(str(error))
    except Exception:  # pylint: disable=broad-exception-caught
        text = "(its text cannot be had)"
    if isinstance(error, SyntaxError) and error.filename == file:
        place, text = f"{os.path.basename(file)}:{error.lineno}", error.msg
    return f"{place}: {type(error).__name__}" + (f": {text}" if text else "")
