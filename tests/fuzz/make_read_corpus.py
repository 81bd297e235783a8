#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes corpus/read, the seeds of fuzz_read: small IGES and STEP files that use all that the readers know; faces and
solids for fuzz_model and fuzz_write; and read.dict, model.dict and write.dict, the words of STEP, which libFuzzer would not
find by itself.

    make_read_corpus.py            writes the files
    make_read_corpus.py --check    exits with 1 if they are not what this script writes
"""

import pathlib
import re
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent.parent / "capi" / "examples" / "models"))

import make_models  # noqa: E402

CORPUS = HERE / "corpus"
DICTIONARIES = [HERE / "read.dict", HERE / "model.dict", HERE / "write.dict"]
KEYWORDS = HERE.parent.parent / "src" / "io" / "step" / "structure" / "keywords.cpp"


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


def numbers(*values):
    return [str(value) for value in values]


def corners(*points):
    return [f"{c:.1f}" for point in points for c in point]


def add_square(iges, a, b, c, d):
    """The bilinear patch with corners a, b (along u), c (along v), d."""
    knots = "0.,0.,1.,1.,0.,0.,1.,1.,1.,1.,1.,1.".split(",")
    return iges.add(make_models.SURFACE, numbers(1, 1, 1, 1, 0, 0, 1, 0, 0) + knots + corners(a, b, c, d) +
                    ["0.", "1.", "0.", "1."])


def add_polygon(iges, points):
    sides = [iges.add(110, corners(a, b)) for a, b in zip(points, points[1:] + points[:1])]
    return iges.add(102, numbers(len(sides), *sides))


def add_plate(iges):
    """With a hole, in space and in the domain, whose outer boundary is that of the domain; and a bounded surface."""
    surface = add_square(iges, (0, 0, 0), (4, 0, 0), (0, 4, 0), (4, 4, 0))
    space = add_polygon(iges, [(1, 1, 0), (3, 1, 0), (3, 2, 0)])
    domain = iges.add(102, numbers(3, *(iges.add(110, side.split(",")) for side in (
        ".25,.25,0.,.75,.25,0.", ".75,.25,0.,.75,.5,0.", ".75,.5,0.,.25,.25,0."))))
    hole = iges.add(142, numbers(0, surface, domain, space, 1))
    iges.add(144, numbers(surface, 0, 1, 0, hole), form=0)
    boundary = iges.add(141, numbers(0, 1, surface, 1, space, 2, 1, domain))
    iges.add(143, numbers(0, surface, 1, boundary))


def add_tube(iges):
    """The side of a cylinder, cut open by its parameters."""
    axis, side = iges.add(110, corners((0, 0, 0), (0, 0, 1))), iges.add(110, corners((2, 0, 0), (2, 0, 3)))
    surface = iges.add(120, numbers(axis, side) + ["0.", "6.283185307"])
    turn = 6.283185307
    loop = [(0, 0, 0), (1, 0, 0), (1, turn, 0), (0, turn, 0)]
    sides = [iges.add(110, [f"{c:.9f}" for c in a + b]) for a, b in zip(loop, loop[1:] + loop[:1])]
    boundary = iges.add(102, numbers(4, *sides))
    iges.add(144, numbers(surface, 1, 0, iges.add(142, numbers(0, surface, boundary, 0, 1))))


def add_wedge(iges):
    """Two squares that share an edge, in a shell of a solid, which an instance places."""
    points = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0), (0, 0, 1), (1, 0, 1)]
    vertices = iges.add(502, numbers(6) + corners(*points))
    ends = [(0, 1), (1, 3), (3, 2), (2, 0), (1, 5), (5, 4), (4, 0)]
    lines = [iges.add(110, corners(points[a], points[b])) for a, b in ends]
    edges = iges.add(504, numbers(7, *(x for line, (a, b) in zip(lines, ends) for x in (line, vertices, a + 1, vertices, b + 1))))
    faces = []
    for corner, loop in (((0, 1, 2, 3), ((1, 1), (2, 1), (3, 1), (4, 1))), ((0, 1, 4, 5), ((1, 1), (5, 1), (6, 1), (7, 1)))):
        surface = add_square(iges, *(points[k] for k in corner))
        ring = iges.add(508, numbers(4, *(x for number, way in loop for x in (0, edges, number, way, 0))))
        faces += [iges.add(510, numbers(surface, 1, 1, ring)), 1]
    solid = iges.add(186, numbers(iges.add(514, numbers(2, *faces)), 1, 0))
    matrix = iges.add(make_models.MATRIX, "1.,0.,0.,5.,0.,1.,0.,6.,0.,0.,1.,7.".split(","))
    iges.add(430, numbers(solid), transform=matrix)


def add_subfigures(iges):
    """One that lists a group, its instance in another one, and one that lists itself."""
    patch = add_square(iges, (0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0))
    group = iges.add(402, numbers(1, patch), form=7)
    bolt = iges.add(308, ["0", "4Hbolt"] + numbers(1, group))
    instance = iges.add(408, numbers(bolt) + ["1.", "2.", "3.", ".5"])
    iges.add(308, ["1", "4Hnuts"] + numbers(2, instance, patch))
    ring = iges.next_pointer()
    iges.add(408, numbers(ring + 2) + ["0.", "0.", "0."])
    iges.add(308, ["1", "4Hring"] + numbers(1, ring))


def add_all_curves(iges):
    """One of each kind of curve, and surfaces that are made of them."""
    entities = [
        (110, "0.,0.,0.,0.,0.,1.", 0), (100, "0.,5.,0.,7.,0.,5.,2.", 0),
        (104, "4.,0.,9.,0.,0.,-36.,7.,3.,0.,0.,2.", 1), (104, "1.,0.,0.,0.,-4.,0.,0.,-2.,1.,4.,4.", 3),
        (104, ".25,0.,-1.,0.,0.,-1.,0.,2.,0.,2.5,.75", 2), (106, "1,3,5.,0.,0.,1.,0.,1.,2.", 11),
        (112, "3,2,3,1,0.,1.,0.,1.,0.,1.,0.,0.,1.,0.,0.,0.,0.,1.,0.,0.,0.,0.", 0),
        (118, "1,3,0,0", 0), (120, "1,11,0.,3.", 0), (122, "3,3.,1.,5.", 0), (102, "1,3", 0), (140, "0.,0.,1.,.5,17", 0),
        (130, "3,1,0,0,0,.5,0.,0.,0.,0.,0.,1.,0.,0.", 0), (130, "13,1,0,0,0,.5,0.,0.,0.,0.,1.,0.,0.,.5", 0),
    ]
    for entity_type, data, form in entities:
        iges.add(entity_type, data.split(","), form)


def add_elementary_surfaces(iges):
    iges.add(116, "1.,2.,3.,0".split(","))
    iges.add(123, "0.,0.,1.".split(","))
    iges.add(123, "1.,0.,0.".split(","))
    for entity_type, data in [(190, "1,3,5"), (192, "1,3,2.,5"), (194, "1,3,2.,30.,5"), (196, "1,2.,3,5"), (198, "1,3,5.,2.,5")]:
        iges.add(entity_type, data.split(","), 1)
    iges.add(106, "1,4,0.,0.,0.,1.,0.,1.,1.,0.,0.".split(","), 63)
    iges.add(108, "0.,0.,1.,0.,17,0.,0.,0.,0.".split(","), 1)
    iges.add(114, ["3", "1", "1", "1", "0.", "1.", "0.", "1."] + ["0.", "1.", "0.", "0."] * 12)


class StepFile:
    """Instances in the order in which they are added; add() returns the name of one."""

    def __init__(self):
        self.instances = []

    def add(self, entity):
        self.instances.append(entity)
        return f"#{len(self.instances)}"

    def point(self, *coordinates):
        return self.add("CARTESIAN_POINT('',(" + ",".join(f"{c:.1f}" for c in coordinates) + "))")

    def placement(self):
        axis, x = self.add("DIRECTION('',(0.,0.,1.))"), self.add("DIRECTION('',(1.,0.,0.))")
        return self.add(f"AXIS2_PLACEMENT_3D('',{self.point(1, 2, 3)},{axis},{x})")

    def vector(self):
        return self.add(f"VECTOR('',{self.add('DIRECTION($,(0.,1.,1.))')},2.)")

    def face(self, surface, edges, sense):
        oriented = ",".join(self.add(f"ORIENTED_EDGE('',*,*,{edge},{way})") for edge, way in edges)
        loop = self.add(f"EDGE_LOOP('',({oriented}))")
        bound = self.add(f"FACE_OUTER_BOUND('',{loop},.T.)")
        return self.add(f"ADVANCED_FACE('',({bound}),{self.add(surface)},{sense})")

    def solid(self, faces):
        """The whole file."""
        shell = self.add(f"CLOSED_SHELL('',({','.join(faces)}))")
        metre = self.add("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))")
        context = self.add(f"(GLOBAL_UNIT_ASSIGNED_CONTEXT(({metre})))")
        self.add(f"ADVANCED_BREP_SHAPE_REPRESENTATION('',({self.add(f'MANIFOLD_SOLID_BREP($,{shell})')}),{context})")
        return self.text()

    def text(self):
        data = "".join(f"#{i}={entity};\n" for i, entity in enumerate(self.instances, 1))
        return ("ISO-10303-21;\nHEADER;\nFILE_SCHEMA(('AUTOMOTIVE_DESIGN'));\nENDSEC;\nDATA;\n" + data +
                "ENDSEC;\nEND-ISO-10303-21;\n")


def step_curves():
    step = StepFile()
    place = step.placement()
    parts = []
    for conic in (f"CIRCLE('\\X2\\00E9\\X0\\',{place},2.)", f"ELLIPSE('',{place},2.,1.)", f"PARABOLA('',{place},1.)",
                  f"HYPERBOLA('',{place},2.,1.)", f"LINE('',{step.point(0, 0, 0)},{step.vector()})"):
        parts.append(step.add(f"TRIMMED_CURVE('',{step.add(conic)},(PARAMETER_VALUE(0.)),(PARAMETER_VALUE(1.)),.T.,"
                              ".PARAMETER.)"))
    segment = step.add(f"COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.F.,{parts[0]})")
    step.add(f"COMPOSITE_CURVE('',({segment}),.U.)")
    points = ",".join(step.point(i, i * i, 0) for i in range(4))
    step.add(f"POLYLINE('',({points}))")
    step.add(f"B_SPLINE_CURVE_WITH_KNOTS('',2,({points}),.U.,.F.,.F.,(3,1,3),(0.,.5,1.),.U.)")
    way = step.add("DIRECTION('',(0.,0.,1.))")
    arch = step.add(f"QUASI_UNIFORM_CURVE('',2,({points}),.U.,.F.,.F.)")
    for basis in (arch, step.add(f"CIRCLE('',{place},2.)")):
        offset = step.add(f"OFFSET_CURVE_3D('',{basis},.25,.F.,{way})")
        step.add(f"TRIMMED_CURVE('',{offset},(PARAMETER_VALUE(.25)),(PARAMETER_VALUE(.5)),.T.,.PARAMETER.)")
    move = step.add(f"CARTESIAN_TRANSFORMATION_OPERATOR_3D('','','',{way},$,{step.point(1, 2, 3)},2.,$)")
    step.add(f"CURVE_REPLICA('',{arch},{move})")
    flat = ",".join(step.add(f"CARTESIAN_POINT('',({i}.,{i * i}.))") for i in range(3))
    plane = step.add(f"BEZIER_CURVE('',2,({flat}),.U.,.F.,.F.)")
    step.add(f"OFFSET_CURVE_2D('',{plane},.25,.F.)")
    step.add(f"(BEZIER_CURVE()B_SPLINE_CURVE(3,({points}),.U.,.F.,.F.)RATIONAL_B_SPLINE_CURVE((1.,2.,2.,1.))"
             "REPRESENTATION_ITEM('x'))")
    return step.text()


def step_surfaces():
    step = StepFile()
    place, circle = step.placement(), None
    circle = step.add(f"CIRCLE('',{place},1.)")
    axis = step.add(f"AXIS1_PLACEMENT('',{step.point(5, 0, 0)},$)")
    surfaces = [step.add(text) for text in (
        f"PLANE('',{place})", f"CYLINDRICAL_SURFACE('',{place},2.)", f"CONICAL_SURFACE('',{place},2.,.5)",
        f"SPHERICAL_SURFACE('',{place},2.)", f"TOROIDAL_SURFACE('',{place},3.,1.)",
        f"DEGENERATE_TOROIDAL_SURFACE('',{place},1.,3.,.F.)", f"SURFACE_OF_REVOLUTION('',{circle},{axis})",
        f"SURFACE_OF_LINEAR_EXTRUSION('',{circle},{step.vector()})")]
    step.add(f"RECTANGULAR_TRIMMED_SURFACE('',{surfaces[1]},0.,1.,2.,3.,.T.,.F.)")
    step.add(f"OFFSET_SURFACE('',{surfaces[3]},1.,.F.)")
    down = step.add("DIRECTION('',(0.,-1.,0.))")
    move = step.add(f"CARTESIAN_TRANSFORMATION_OPERATOR_3D('','','',$,{down},{step.point(1, 2, 3)},2.,$)")
    step.add(f"SURFACE_REPLICA('',{surfaces[4]},{move})")
    rows = ",".join(f"({step.point(x, 0, 0)},{step.point(x, 1, x)})" for x in range(3))
    step.add(f"QUASI_UNIFORM_SURFACE('',1,1,({rows}),.U.,.F.,.F.,.F.)")
    vertex = step.add(f"VERTEX_POINT('',{step.point(2, 2, 3)})")
    seam = step.add(f"SEAM_CURVE('',{circle},(),.CURVE_3D.)")
    edge = step.add(f"EDGE_CURVE('',{vertex},{vertex},{seam},.T.)")
    loop = step.add(f"EDGE_LOOP('',({step.add(f'ORIENTED_EDGE($,*,*,{edge},.F.)')}))")
    bound = step.add(f"FACE_OUTER_BOUND('',{loop},.T.)")
    faces = [step.add(f"ADVANCED_FACE('f',({bound}),{surface},.T.)") for surface in surfaces]
    shell = step.add("CLOSED_SHELL('',(" + ",".join(faces) + "))")
    metre = step.add("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))")
    inch = step.add(f"(CONVERSION_BASED_UNIT('INCH',{step.add(f'LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4),{metre})')})"
                    "LENGTH_UNIT()NAMED_UNIT(*))")
    error = step.add(f"UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-5),{metre},'','')")
    context = step.add(f"(GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT(({error}))GLOBAL_UNIT_ASSIGNED_CONTEXT(({inch})))")
    other = step.add(f"(GLOBAL_UNIT_ASSIGNED_CONTEXT(({metre})))")
    step.add(f"ADVANCED_BREP_SHAPE_REPRESENTATION('',({step.add(f'MANIFOLD_SOLID_BREP($,{shell})')}),{context})")
    step.add(f"SHAPE_REPRESENTATION('',({circle},{step.add('BLOCK($)')}),{other})")
    return step.text()


def step_half_ball():
    """A disk and the half ball over it, which share their circle."""
    step = StepFile()
    place = step.placement()
    vertex = step.add(f"VERTEX_POINT('',{step.point(3, 2, 3)})")
    circle = step.add(f"CIRCLE('',{place},2.)")
    edge = step.add(f"EDGE_CURVE('',{vertex},{vertex},{circle},.T.)")
    faces = [step.face(f"PLANE('',{place})", [(edge, ".F.")], ".F."),
             step.face(f"SPHERICAL_SURFACE('',{place},2.)", [(edge, ".T.")], ".T.")]
    return step.solid(faces)


def step_tube():
    """The side of a cylinder with a seam, and one disk."""
    step = StepFile()
    place = step.placement()
    low, high = (step.add(f"VERTEX_POINT('',{step.point(3, 2, z)})") for z in (3, 7))
    circle = step.add(f"CIRCLE('',{place},2.)")
    other = step.add(f"AXIS2_PLACEMENT_3D('',{step.point(1, 2, 7)},$,$)")
    upper = step.add(f"CIRCLE('',{other},2.)")
    up = step.add(f"VECTOR('',{step.add('DIRECTION($,(0.,0.,1.))')},1.)")
    seam = step.add(f"LINE('',{step.point(3, 2, 3)},{up})")
    edges = [step.add(f"EDGE_CURVE('',{a},{b},{curve},.T.)") for a, b, curve in
             ((low, low, circle), (high, high, upper), (low, high, seam))]
    side = [(edges[0], ".T."), (edges[2], ".T."), (edges[1], ".F."), (edges[2], ".F.")]
    faces = [step.face(f"CYLINDRICAL_SURFACE('',{place},2.)", side, ".T."),
             step.face(f"PLANE('',{place})", [(edges[0], ".F.")], ".F.")]
    return step.solid(faces)


def dictionary():
    """The entities that the reader knows, and the words of the structure."""
    words = re.findall(r'\{"([A-Z0-9_]+)", Kind', KEYWORDS.read_text(encoding="utf-8"))
    parts = ["REPRESENTATION_ITEM", "PLACEMENT", "CONIC", "EDGE", "FACE", "PATH", "ELEMENTARY_SURFACE", "SWEPT_SURFACE",
             "NAMED_UNIT", "RATIONAL_B_SPLINE_CURVE", "RATIONAL_B_SPLINE_SURFACE", "LENGTH_MEASURE(", "PARAMETER_VALUE(",
             "GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT", "HEADER;", "DATA;", "ENDSEC;", "END-ISO-10303-21;", "ISO-10303-21;"]
    lines = ["# Words of STEP files; made by make_read_corpus.py"]
    lines += [f'"{word}"' for word in words + parts]
    lines += ['".T."', '".F."', '".CARTESIAN."', '"*"', '"$"', '"/*"', '"*/"', '"\\\\X2\\\\"', '"\\\\X0\\\\"']
    return "\n".join(lines) + "\n"


def seeds():
    loop_and_others = one(make_models.add_polynomial_curves)
    return {
        "all_curves.igs": one(add_all_curves),
        "circle.igs": one(make_models.add_circle),
        "curves.igs": loop_and_others,
        "curves_crlf.igs": loop_and_others.replace("\n", "\r\n"),
        "elementary_surfaces.igs": one(add_elementary_surfaces),
        "empty.igs": one(lambda iges: None),
        "matrix_chain.igs": one(add_matrix_chain),
        "other_unit.igs": one(add_patch).replace(",1.,2,2HMM,", ",2.,3,2HIN,"),
        "patch.igs": one(add_patch),
        "short_range.igs": one(add_short_range),
        "transformed.igs": one(make_models.add_transformed_curve),
        "trimmed.igs": one(add_trimmed),
        "curves.stp": step_curves(),
        "surfaces.stp": step_surfaces(),
    }


def solids():
    return {
        "half_ball.stp": step_half_ball(),
        "tube.stp": step_tube(),
        "surfaces.stp": step_surfaces(),
        "plate.igs": one(add_plate),
        "tube.igs": one(add_tube),
        "wedge.igs": one(add_wedge),
        "subfigures.igs": one(add_subfigures),
    }


def main(arguments):
    if arguments not in ([], ["--check"]):
        print("usage: make_read_corpus.py [--check]", file=sys.stderr)
        return 2
    wrong = 0
    files = {CORPUS / "read" / name: text for name, text in seeds().items()}
    files |= {CORPUS / folder / name: text for folder in ("model", "write") for name, text in solids().items()}
    files |= dict.fromkeys(DICTIONARIES, dictionary())
    for path, text in files.items():
        path.parent.mkdir(parents=True, exist_ok=True)
        if not arguments:
            path.write_bytes(text.encode("ascii"))
        elif not path.is_file() or path.read_bytes() != text.encode("ascii"):
            print(f"{path.name} is NOT what make_read_corpus.py writes")
            wrong = 1
    return wrong


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
