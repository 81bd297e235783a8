"""The version is the same wherever it is written: the header's macros are what the others are compared with.

usage: check_versions.py TOP_FOLDER
"""

import re
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "cmake/interface"))

import exports  # noqa: E402 - from the project
import header  # noqa: E402 - from the project

# (file, pattern, parts of the version, whether the file has to be there)
PLACES = (
    ("README.md", r"libnurbs contributors,\s+libnurbs ([\d.]+),", 3, True),
    ("capi/nurbs.map", r"^NURBS_([\d.]+) \{", 2, True),
    ("capi/bindings/rust/Cargo.toml", r'^version = "(.*)"', 3, True),
    ("capi/bindings/python/pyproject.toml", r'^version = "(.*)"', 3, False),
    ("capi/bindings/python/nurbs/__init__.py", r'^__version__ = "(.*)"', 3, False),
    ("capi/bindings/python/nurbs/_library.py", r"libnurbs\.so\.(\d+)", 1, True),
    ("cmake/debian/changelog", r"\A\S+ \(([\d.]+)[-~)]", 3, False),
    ("cmake/debian/libnurbs1.symbols", r"^libnurbs\.so\.(\d+) ", 1, True),
)

# Files where every name of the shared library or of its package has the major version.
PACKAGES = ("cmake/debian/control", "cmake/debian/tests/c", "tests/install/packages")


def in_tree(top, path):
    """A file of the project; in the source of a Debian package cmake/debian is debian."""
    file = top / path
    return file if file.exists() else top / path.replace("cmake/debian/", "debian/")


def numbers(version):
    return [int(part) for part in version.split(".")]


def place_problem(top, version, path, pattern, parts, needed):
    """What is wrong in a file; the last match is the newest where there are several."""
    file = in_tree(top, path)
    if not file.exists():
        return f"{path} is missing" if needed else None
    found = re.findall(pattern, file.read_text(encoding="utf-8"), flags=re.M)
    if not found:
        return f"{path} names no version" if needed else None
    wanted = ".".join(version.split(".")[:parts])
    return None if found[-1] == wanted else f"{path} has the version {found[-1]}, not {wanted}"


def problems(top):
    manual = header.read(top)
    major, minor, patch = numbers(manual.version)
    if manual.constants["NURBS_VERSION"].value != major * 10000 + minor * 100 + patch:
        yield "NURBS_VERSION does not follow from its parts"
    for function in manual.functions:
        newest = exports.newest_feature(manual, function)
        if numbers(newest) > [major, minor]:
            yield f"{function.name} is said to be newer than the header, or a part of it: {newest}"
    for path in PACKAGES:
        names = set(re.findall(r"libnurbs\.?(?:so\.)?(\d+)", in_tree(top, path).read_text(encoding="utf-8")))
        if names != {str(major)}:
            yield f"{path} names libnurbs {' and '.join(sorted(names))}, not {major}"
    for place in PLACES:
        problem = place_problem(top, manual.version, *place)
        if problem:
            yield problem


def main():
    top = Path(sys.argv[1])
    found = list(problems(top))
    print("\n".join(found) or f"version {header.read(top).version} in all places")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
