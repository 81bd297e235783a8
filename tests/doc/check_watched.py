"""What counts work may end the call with an exception: neither it nor what calls it is noexcept.

usage: check_watched.py FOLDER...

Functions are told apart by their names alone: one of those that count is one of which every definition does.
"""

import re
import sys
from pathlib import Path

COUNTS = {"count_work", "require_work", "end_for_work", "grow_watched", "copied_watched"}
WORDS = {"if", "for", "while", "switch", "return", "sizeof", "catch", "noexcept", "static_assert", "decltype", "alignof"}

# A name, its parameters, what follows them, and initializers or the type that is returned.
DEFINITION = re.compile(
    r"([~\w]+)\s*(\([^;{}]*?\))\s*((?:const|noexcept|override|final|&|\s)*)"
    r"(?::[^;{}]*(?:\{[^{}]*\}[^;{}]*)*?)?(?:->[^;{]*)?\{"
)
STEP = re.compile(r"\bsteps_?\.next\(")  # Steps::next()
CALL = re.compile(r"([~\w]+)\s*(?:<[^<>;(){}]*>)?\(")


def without_comments(text):
    text = re.sub(r"//[^\n]*", "", text)
    text = re.sub(r"/\*.*?\*/", lambda match: "\n" * match[0].count("\n"), text, flags=re.S)
    return re.sub(r'"(\\.|[^"\\\n])*"', '""', text)


def end_of_body(text, brace):
    depth = 0
    for i in range(brace, len(text)):
        depth += {"{": 1, "}": -1}.get(text[i], 0)
        if depth == 0:
            return i
    return len(text)


def definitions(path):
    """(name, whether it is noexcept, the names of what it calls, line) of each function."""
    text = without_comments(path.read_text(encoding="utf-8"))
    for match in DEFINITION.finditer(text):
        name, parameters, after = match.groups()
        if name in WORDS or parameters.count("(") != parameters.count(")"):
            continue
        body = text[match.start(3) : end_of_body(text, match.end() - 1)]
        calls = {call for call in CALL.findall(body) if call not in WORDS}
        calls |= {"count_work"} if STEP.search(body) else set()
        yield name, "noexcept" in after, calls, text.count("\n", 0, match.start()) + 1


def names_that_count(found):
    by_name = {}
    for name, is_noexcept, calls, _ in found:
        by_name.setdefault(name, []).append((is_noexcept, calls))
    counts, before = set(COUNTS), 0
    while len(counts) > before:
        before = len(counts)
        counts |= {
            name
            for name, same in by_name.items()
            if all(not is_noexcept and calls & counts for is_noexcept, calls in same)
        }
    return counts


def main():
    folders = [Path(folder) for folder in sys.argv[1:]]
    files = sorted(path for folder in folders for path in folder.rglob("*") if path.suffix in (".h", ".cpp"))
    found = {path: list(definitions(path)) for path in files}
    counts = names_that_count([definition for own in found.values() for definition in own])
    messages = [
        f"{path}:{line}: {name}() is noexcept and calls {', '.join(sorted(calls & counts))}, which may end the call"
        for path, own in found.items()
        for name, is_noexcept, calls, line in own
        if is_noexcept and calls & counts
    ]
    print("\n".join(messages) or f"{len(files)} files, {len(counts)} names that count work")
    return 1 if messages or len(counts) == len(COUNTS) else 0


if __name__ == "__main__":
    sys.exit(main())
