"""A room of src/ includes only itself, the rooms before it, the public C header and the system.

usage: check_rooms.py src

The order is that of `set(rooms ...)` in src/CMakeLists.txt, so that a room which is not built is not allowed either.
"""

import re
import sys
from pathlib import Path

PUBLIC_HEADER = "nurbs/nurbs.h"


def rooms_in_order(src):
    text = (src / "CMakeLists.txt").read_text(encoding="utf-8")
    return re.findall(r"^ +([a-z]+)\b(?!/)", re.search(r"set\(rooms\n([^)]*)\)", text)[1], re.M)


def includes(path):
    """(line number, whether in angle brackets, target) of each include directive."""
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        match = re.match(r"\s*#\s*include\s*([<\"])([^>\"]+)", line)
        if match:
            yield number, match[1] == "<", match[2]


def include_problem(src, room, rooms, angled, target):
    first = target.split("/")[0]
    if angled:
        ours = (src / target).is_file() or (first == "nurbs" and target != PUBLIC_HEADER)
        return f"<{target}> is not a header of the system" if ours else None
    if first not in rooms:
        return f'"{target}" does not begin with the name of a room'
    if rooms.index(first) > rooms.index(room):
        return f"room {room} includes the later room {first}"
    return None if (src / target).is_file() else f'"{target}" does not exist'


def file_problems(src, path, rooms):
    room = path.relative_to(src).parts[0]
    if room not in rooms:
        yield f"{path}: not a file of a room"
        return
    for number, angled, target in includes(path):
        problem = include_problem(src, room, rooms, angled, target)
        if problem:
            yield f"{path}:{number}: {problem}"


def main():
    src = Path(sys.argv[1])
    rooms = rooms_in_order(src)
    files = sorted(path for path in src.rglob("*") if path.suffix in (".h", ".hpp", ".cpp", ".inc"))
    messages = [message for path in files for message in file_problems(src, path, rooms)]
    print("\n".join(messages) or f"{len(files)} files keep the order {' '.join(rooms)}")
    return 1 if messages or not files else 0


if __name__ == "__main__":
    sys.exit(main())
