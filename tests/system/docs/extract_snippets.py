#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the C++ snippets of a page, one after the other, into a source file: extract_snippets.py PAGE SOURCE"""

import pathlib
import re
import sys


def snippets_of(page):
    return re.findall(r"^```cpp\n(.*?)^```$", page, re.M | re.S)


def main():
    page, source = map(pathlib.Path, sys.argv[1:])
    snippets = snippets_of(page.read_text())
    if not snippets:
        sys.exit(f"{page}: has no C++ snippet")
    source.write_text("\n".join(snippets))


if __name__ == "__main__":
    main()
