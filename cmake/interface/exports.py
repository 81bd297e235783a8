# SPDX-License-Identifier: MIT
"""What the shared library exports: the linker's version script, and the symbols file of the Debian package.

The version that brought a function is the node of its symbol: \\since 1.0 is NURBS_1.0.
"""

import re

import header


def parts(version):
    return [int(part) for part in version.split(".")]


def node(manual, function):
    """The version in the symbol. A new major version begins anew: were both libraries in one process, two functions with
    the same name and node would be taken for each other."""
    major = manual.version.split(".")[0]
    return function.since if function.since.split(".")[0] == major else f"{major}.0"


def by_version(manual):
    """[(version, names)], oldest first."""
    major, minor, _ = manual.version.split(".")
    versions = {f"{major}.{minor}": []}
    for function in manual.functions:
        versions.setdefault(node(manual, function), []).append(function.name)
    return sorted(versions.items(), key=lambda entry: parts(entry[0]))


def version_script(manual):
    lines = [f"/* {header.NOTICE} */"]
    before = None
    for version, names in by_version(manual):
        lines += [f"NURBS_{version} {{", *["    global:"] * bool(names)]
        lines += [f"        {name};" for name in names]
        lines += [f"}} NURBS_{before};"] if before else ["    local:", "        *;", "};"]
        before = version
    return "\n".join(lines) + "\n"


def newest_feature(manual, function):
    """The version of the newest flag, status or field that a program can use in a function: "(since 1.1)" in its comment. A
    package needs a library of that version, though the function is older."""
    told = " ".join([function.text, function.returns, *(text for _, text in function.described.values())])
    return max([node(manual, function), *re.findall(r"\(since\s+(\d+\.\d+)\)", told)], key=parts)


def debian_symbols(manual):
    major = manual.version.split(".")[0]
    lines = [f"# {header.NOTICE}", f"libnurbs.so.{major} libnurbs{major} #MINVER#",
             "* Build-Depends-Package: libnurbs-dev"]
    needed = {function.name: newest_feature(manual, function) for function in manual.functions}
    for version, names in by_version(manual):
        lines += [f" {name}@NURBS_{version} {needed.get(name, version)}.0" for name in (f"NURBS_{version}", *sorted(names))]
    return "\n".join(lines) + "\n"


FILES = {"capi/nurbs.map": version_script, "cmake/debian/libnurbs1.symbols": debian_symbols}
