# SPDX-License-Identifier: MIT
"""Line breaks of generated code are those of the formatter of its language, where it is installed.

Whether a file is up to date does not depend on them: two texts are the same if they differ in white space only. That the
files are formatted is tested elsewhere, together with those that are written by hand.
"""

import shutil
import subprocess

FORMATTERS = {".hpp": ("clang-format", "--assume-filename")}


def suffix(path):
    return str(path)[str(path).rfind("."):]


def same(path, found, wanted):
    if suffix(path) in FORMATTERS:
        return "".join(found.split()) == "".join(wanted.split())
    return found == wanted


def formatted(path, text):
    """As it is written to the path, whose folder decides on the style."""
    command, option = FORMATTERS.get(suffix(path), ("", ""))
    program = shutil.which(command) if command else None
    if not program:
        return text
    return subprocess.run([program, option, str(path)], input=text, capture_output=True, text=True, check=True).stdout
