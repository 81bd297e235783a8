# SPDX-License-Identifier: MIT
"""The examples of nurbs.h are C99, every group has one, and they run.

usage: check_examples.py TOP_FOLDER C_COMPILER libnurbs.so

An example is what stands between \\code and \\endcode. That of the preamble is a whole program; those of the groups are
bodies of functions, in which `curve` and `surface` are splines in space. All but those that show a failing call must succeed:
nurbs_last_error() is as empty after them as before.
"""

import re
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "cmake/interface"))

import header  # noqa: E402 - from the project

FLAGS = ("-std=c99", "-Wall", "-Wextra", "-Wno-unused-but-set-variable", "-Werror")
FAILING = ("errors", "read", "model", "write")  # a parameter outside the domain; files that are not there
BEGINNING = "#include <nurbs/nurbs.h>\n#include <stdio.h>\n"
MAIN = """
static void check(const char *group, void example(const nurbs *, const nurbs *), const nurbs *curve, const nurbs *surface,
                  int *failures) {
    char message[256];
    example(curve, surface);
    if (nurbs_last_error(message, sizeof message) > 0) {
        printf("%s: %s\\n", group, message);
        *failures = 1;
    }
}

int main(void) {
    const int32_t degrees[] = {2, 2};
    const int64_t counts[] = {4, 4};
    const double knots[] = {0, 0, 0, 0.5, 1, 1, 1, 0, 0, 0, 0.5, 1, 1, 1};
    double points[16][3];
    int failures = 0;
    nurbs *curve = NULL, *surface = NULL;
    for (int i = 0; i < 16; ++i) {
        points[i][0] = i / 4;
        points[i][1] = i % 4;
        points[i][2] = (i * i) % 3;
    }
    nurbs_create(1, degrees, counts, knots, 7, 3, points[0], 0, 0, NULL, 0, 0, &curve);
    nurbs_create(2, degrees, counts, knots, 14, 3, points[0], 0, 0, NULL, 0, 0, &surface);
CALLS
    nurbs_destroy(curve);
    nurbs_destroy(surface);
    return failures;
}
"""


def code(text):
    return re.findall(r"^\\code\n(.*?)\n\\endcode$", text, flags=re.M | re.S)


def function(name, body):
    lines = "\n".join(f"    {line}" for line in body.split("\n"))
    return (f"\nstatic void example_{name}(const nurbs *curve, const nurbs *surface) {{\n{lines}\n"
            "    (void)curve;\n    (void)surface;\n}\n")


def program(examples):
    """All examples of groups, those that have to succeed first."""
    order = sorted(examples, key=lambda name: name in FAILING)
    calls = [f"    example_{name}(curve, surface);" if name in FAILING
             else f'    check("{name}", example_{name}, curve, surface, &failures);' for name in order]
    functions = "".join(function(name, examples[name]) for name in order)
    return BEGINNING + functions + MAIN.replace("CALLS", "\n".join(calls))


def outcome(top, compiler, library, text):
    """Compiles and runs a program: what was said, empty if all is well."""
    with tempfile.TemporaryDirectory() as folder:
        source, binary = Path(folder) / "example.c", Path(folder) / "example"
        source.write_text(text, encoding="utf-8")
        commands = ([compiler, *FLAGS, f"-I{top / 'include'}", str(source), "-o", str(binary), library,
                     f"-Wl,-rpath,{Path(library).resolve().parent}"], [str(binary)])
        for command in commands:
            done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
            if done.returncode != 0:
                return done.stdout + done.stderr or f"exit code {done.returncode}"
    return ""


def main():
    top, compiler, library = Path(sys.argv[1]).resolve(), sys.argv[2], str(Path(sys.argv[3]).resolve())
    manual = header.read(top)
    messages, examples = [], {}
    for module in manual.modules:
        found = code(module.text)
        if len(found) != 1 or not module.text.startswith("\\code"):
            messages.append(f"group {module.name} does not begin with one example")
        examples.update({module.name: "\n".join(found)} if found else {})
    programs = code(manual.preamble)
    if len(programs) != 1:
        messages.append("the preamble has not one example")
    messages += filter(None, [outcome(top, compiler, library, text) for text in (*programs, program(examples))])
    print("\n".join(messages) or f"{len(examples) + 1} examples compile and run")
    return 1 if messages else 0


if __name__ == "__main__":
    sys.exit(main())
