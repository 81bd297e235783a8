# SPDX-License-Identifier: MIT
"""layout.c pins every constant of the header, and size and fields of every struct; growing.suppr knows the structs that say
their size.

usage: check_layout.py TOP_FOLDER
"""

import re
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "cmake/interface"))

import header  # noqa: E402 - from the project


def promised(manual):
    """What compiled programs hold, as layout.c writes it."""
    yield from (name for name in manual.constants if not name.startswith("NURBS_VERSION"))
    for struct in manual.structs:
        yield f"sizeof({struct.name})"
        yield from (f"offsetof({struct.name}, {entry.name})" for entry in struct.fields)


def problems(top):
    manual = header.read(top)
    pinned = set(re.findall(r"PIN\((.*), [^,]*\);", (top / "tests/abi/layout.c").read_text(encoding="utf-8")))
    yield from (f"layout.c does not pin {name}" for name in promised(manual) if name not in pinned)
    growing = re.findall(r"name = (\w+)", (top / "tests/abi/growing.suppr").read_text(encoding="utf-8"))
    yield from (f"growing.suppr lacks {struct.name}" for struct in manual.structs if struct.name not in growing)


def main():
    top = Path(sys.argv[1])
    found = list(problems(top))
    print("\n".join(found) or f"{sum(1 for _ in promised(header.read(top)))} numbers are pinned")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
