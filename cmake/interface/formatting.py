# SPDX-License-Identifier: MIT
"""Line breaks of generated code are those of the formatter of its language, where it is installed.

Whether a file is up to date does not depend on them: two texts are the same if they differ in white space only, and in
the commas that formatters put behind the last of several lines. That the files are formatted is tested elsewhere, together
with those that are written by hand.
"""

import re
import shutil
import subprocess
from pathlib import Path

FORMATTERS = {
    ".hpp": ["clang-format", "--assume-filename"],
    ".rs": ["rustfmt", "--edition", "2021"],
}


def same(path, found, wanted):
    if Path(path).suffix in FORMATTERS:
        return plain(found) == plain(wanted)
    return found == wanted


def plain(text):
    return re.sub(r",([)}\]])", r"\1", "".join(text.split()))


def formatted(path, text):
    """As it is written to the path, whose folder decides on the style."""
    command = FORMATTERS.get(path.suffix, [""])
    if not shutil.which(command[0]):
        return text
    named = [path.name] if command[-1].startswith("--assume") else []
    return subprocess.run([*command, *named], cwd=path.parent, input=text, capture_output=True, text=True,
                          check=True).stdout
