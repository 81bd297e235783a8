"""Every type of src and capi that other files can see is defined once.

usage: check_types.py SOURCE

Two classes of one name in two files that never include each other compile and link, and the program then destroys
objects of the one by the destructor of the other, or does not, as the optimizer pleases.
"""

import re
import sys
from collections import defaultdict
from pathlib import Path

OPENING = re.compile(r"(?:inline )?namespace ?((?:inline |[\w:])*) ?\{")
CLOSING = re.compile(r"\} // namespace")
# At the beginning of a line, which is where clang-format puts what is in namespaces only. Members of a class, written
# as class::member, and specializations are no new names.
DEFINITION = re.compile(r"(?:template <.*> )?(?:struct|class|union|enum class|enum) (\w+)(?![\w<:])(?! ?::)[^;(]*$")


def types_of(path):
    """(qualified name, line) of the types that a file defines outside unnamed namespaces."""
    spaces = []
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        opening = OPENING.match(line)
        if opening:
            spaces.append(opening[1])
        elif CLOSING.match(line):
            spaces.pop()
        elif "" not in spaces:
            definition = DEFINITION.match(line)
            if definition:
                yield "::".join([*spaces, definition[1]]), number


def main():
    source = Path(sys.argv[1])
    places = defaultdict(list)
    for path in sorted([*source.glob("src/**/*"), *source.glob("capi/*")]):
        if path.suffix in (".h", ".cpp"):
            for name, line in types_of(path):
                places[name].append(f"{path.relative_to(source)}:{line}")
    doubled = {name: found for name, found in places.items() if len(found) > 1}
    for name, found in doubled.items():
        print(f"{name} is defined in {' and '.join(found)}")
    print(f"{len(places)} types")
    return 1 if doubled or not places else 0


if __name__ == "__main__":
    sys.exit(main())
