#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes corpus/read, the seeds of fuzz_read: small IGES files that use all that the reader knows.

    make_read_corpus.py            writes the files
    make_read_corpus.py --check    exits with 1 if they are not what this script writes
"""

import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent.parent / "capi" / "examples" / "models"))

import make_models  # noqa: E402

CORPUS = HERE / "corpus" / "read"


def one(add):
    iges = make_models.IgesFile()
    add(iges)
    return iges.text()


def add_patch(iges):
    net = [[(x, y, x * y) for y in range(3)] for x in range(2)]
    weights = [[1, 0.5, 1], [1, 0.75, 1]]
    iges.add_surface("patch", (1, 2), ([0, 0, 1, 1], [0, 0, 0, 2, 2, 2]), net, weights)


def add_short_range(iges):
    fields = "1,1,0,0,1,0,0.,0.,1.,1.,1.,1.,0.,0.,0.,1.D1,2.,3.,.25,.75,0.,0.,1.".split(",")
    iges.add(make_models.CURVE, fields)


def add_trimmed(iges):
    """Curves in the parameter plane: by status, through a composite curve and through a boundary."""
    line = "1,1,0,0,1,0,0.,0.,1.,1.,1.,1.,0.,0.,0.,1.,2.,3.,0.,1.,0.,0.,1.".split(",")
    for status in ("00000500", "00000000", "00000000", "00000000"):
        iges.add(make_models.CURVE, line, status=status)
    add_patch(iges)
    composite = iges.add(102, ["2", "1", "3"])
    iges.add(142, ["0", "9", str(composite), "7", "2"])
    iges.add(141, ["1", "3", "9", "1", "7", "1", "1", "5"])


def add_matrix_chain(iges):
    identity = "1.,0.,0.,5.,0.,1.,0.,6.,0.,0.,1.,7.".split(",")
    outer = iges.add(make_models.MATRIX, identity)
    inner = iges.add(make_models.MATRIX, identity, transform=outer)
    iges.add(make_models.CURVE, "0,0,0,0,1,0,0.,1.,1.,1.,2.,3.,0.,1.,0.,0.,1.".split(","), transform=inner)


def seeds():
    loop_and_others = one(make_models.add_polynomial_curves)
    return {
        "circle.igs": one(make_models.add_circle),
        "curves.igs": loop_and_others,
        "curves_crlf.igs": loop_and_others.replace("\n", "\r\n"),
        "empty.igs": one(lambda iges: None),
        "matrix_chain.igs": one(add_matrix_chain),
        "other_unit.igs": one(add_patch).replace(",1.,2,2HMM,", ",2.,3,2HIN,"),
        "patch.igs": one(add_patch),
        "short_range.igs": one(add_short_range),
        "transformed.igs": one(make_models.add_transformed_curve),
        "trimmed.igs": one(add_trimmed),
    }


def main(arguments):
    if arguments not in ([], ["--check"]):
        print("usage: make_read_corpus.py [--check]", file=sys.stderr)
        return 2
    wrong = 0
    CORPUS.mkdir(parents=True, exist_ok=True)
    for name, text in seeds().items():
        path = CORPUS / name
        if not arguments:
            path.write_bytes(text.encode("ascii"))
        elif not path.is_file() or path.read_bytes() != text.encode("ascii"):
            print(f"{name} is NOT what make_read_corpus.py writes")
            wrong = 1
    return wrong


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
