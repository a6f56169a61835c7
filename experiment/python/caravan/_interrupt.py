# SPDX-License-Identifier: Apache-2.0
"""Ctrl-C between two steps of a run, not within one."""

import contextlib
import signal
import threading


@contextlib.contextmanager
def between_steps():
    """Gives a list that is empty until a Ctrl-C comes. That one is handled at the end, a second one at once.

    An exception inside of a step would end the run: a controller in Python would throw it."""
    came = []
    handler = signal.getsignal(signal.SIGINT)
    if threading.current_thread() is not threading.main_thread() or not callable(handler):
        yield came
        return

    def note(number, _):
        came.append(number)
        signal.signal(number, handler)

    signal.signal(signal.SIGINT, note)
    try:
        yield came
    finally:
        signal.signal(signal.SIGINT, handler)
        if came:
            signal.raise_signal(signal.SIGINT)
