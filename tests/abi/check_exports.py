"""The header, the export map and the shared library name the same functions and the versions that brought them, and the
library shows nothing else.

usage: check_exports.py nurbs.h nurbs.map libnurbs.so
"""

import re
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "cmake/interface"))

import exports  # noqa: E402 - from the project
import header  # noqa: E402 - from the project

ALLOWED_LIBRARIES = re.compile(
    r"(libc|libm|libgcc_s|libstdc\+\+|ld-linux[-\w]*)\.so(\.\d+)*$")


def output(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def without_comments(text):
    return re.sub(r"/\*.*?\*/", "", text, flags=re.DOTALL)


def map_functions(text):
    """Functions of all nodes of the export map, as a list of (function, node)."""
    found = []
    for node, body in re.findall(r"(\w[\w.]*)\s*\{(.*?)\}", without_comments(text), flags=re.DOTALL):
        body = re.sub(r"local:.*", "", body, flags=re.DOTALL).replace("global:", "")
        found += [(name, node) for name in re.findall(r"[^;\s]+", body)]
    return found


def exported(library):
    """Defined dynamic symbols as a list of (name, node); the nodes' own absolute symbols are left out."""
    symbols = []
    for line in output("nm", "-D", "--defined-only", "--with-symbol-versions", library).splitlines():
        kind, name = line.split()[-2:]
        name, _, node = name.partition("@@")
        if not (kind == "A" and node in ("", name)):
            symbols.append((name, node))
    return symbols


def dynamic_entries(library, tag):
    return re.findall(rf"\({tag}\).*\[(.*)\]", output("readelf", "-d", "--wide", library))


def differences(kind, left, right):
    left, right = set(left), set(right)
    return [f"{kind}: only in the first: {x}" for x in sorted(left - right)] + \
           [f"{kind}: only in the second: {x}" for x in sorted(right - left)]


def repeated(kind, names):
    return [f"{kind}: {name} occurs more than once" for name in sorted(set(names)) if names.count(name) > 1]


def problems(header_path, map_path, library):
    manual = header.parse(Path(header_path).read_text(encoding="utf-8"))
    map_text = Path(map_path).read_text(encoding="utf-8")
    in_map = map_functions(map_text)
    declared = [function.name for function in manual.functions]
    promised = [(function.name, f"NURBS_{exports.node(manual, function)}") for function in manual.functions]
    major, minor, _ = manual.version.split(".")
    found = repeated("header", declared) + repeated("map", [name for name, _ in in_map])
    found += differences("header and map", promised, in_map)
    found += differences("map and library", in_map, exported(library))
    found += [f"the map has no node for this version, NURBS_{major}.{minor}"] * \
        (f"\nNURBS_{major}.{minor} {{" not in map_text)
    found += differences("wanted and actual SONAME", [f"libnurbs.so.{major}"], dynamic_entries(library, "SONAME"))
    found += [f"needs {name}" for name in dynamic_entries(library, "NEEDED") if not ALLOWED_LIBRARIES.match(name)]
    found += [f"has the search path {path}" for path in dynamic_entries(library, "R(?:UN)?PATH")]
    return declared, found


def main():
    declared, found = problems(*sys.argv[1:])
    if not declared:
        found.append("the header declares nothing")
    print("\n".join(found) or f"{len(declared)} functions: header, map and library agree")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
