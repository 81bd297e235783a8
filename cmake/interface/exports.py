# SPDX-License-Identifier: MIT
"""What the shared library exports: the linker's version script, and the symbols file of the Debian package.

The version that brought a function is the node of its symbol: \\since 1.0 is NURBS_1.0.
"""

import header


def by_version(manual):
    """[(version, names)], oldest first."""
    versions = {}
    for function in manual.functions:
        versions.setdefault(function.since, []).append(function.name)
    return sorted(versions.items(), key=lambda entry: [int(part) for part in entry[0].split(".")])


def version_script(manual):
    lines = [f"/* {header.NOTICE} */"]
    before = None
    for version, names in by_version(manual):
        lines += [f"NURBS_{version} {{", "    global:"]
        lines += [f"        {name};" for name in names]
        lines += [f"}} NURBS_{before};"] if before else ["    local:", "        *;", "};"]
        before = version
    return "\n".join(lines) + "\n"


def debian_symbols(manual):
    major = manual.version.split(".")[0]
    lines = [f"# {header.NOTICE}", f"libnurbs.so.{major} libnurbs{major} #MINVER#",
             "* Build-Depends-Package: libnurbs-dev"]
    for version, names in by_version(manual):
        lines += [f" {name}@NURBS_{version} {version}.0" for name in (f"NURBS_{version}", *sorted(names))]
    return "\n".join(lines) + "\n"


FILES = {"capi/nurbs.map": version_script, "cmake/debian/libnurbs1.symbols": debian_symbols}
