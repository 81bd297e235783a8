# SPDX-License-Identifier: MIT
"""Splines, lists, faces and models as bytes in Python: by the layout that the manual publishes, in pickles, and from them."""

import base64
import pathlib
import pickle
import re
import struct
import unittest

import nurbs
from helpers import circle, np, patch, random_splines

TOP = pathlib.Path(__file__).resolve().parents[2]
SPLINES = random_splines(60, 20260301)

# Of version 1.0: a periodic curve, and one that was built homogeneous.
OLD_PICKLES = (
    "fCQCw0RR910001t1#We6Vsn&?314z$b98TVWn`3-lqiWy0)>=}6>fEHaCt6cZ*pZWZFOvPX<>45VR@8{3}13(V{dMAbaHiLbd-~nj0J9WZE$"
    "&%j0bLHVRCX|d6bisO8|wGLjhuxhm=y3C`$oL35Aqs2aE+|ba`-Pl#`T<0%kariHL`kQj{o51B?MYluk}gO8@`=|4RS=|Nlz>bd+L=Lr4Gs0"
    "00000000000000@IL?m0000006+i$000002tWV;000005I_I`000006hHs~000007(f630000096$g700000AV8FKlwyUHXa;BrO8|wGXbXp"
    "wQj{o50ZRr;0)~`m6Ny7$00000008hm00000008hm00000008j600000008hm00000008j600000008j600000008hm00000008j60000000"
    "8hm00000008hm00000008j600000008hmlysD0PD=rFlv0!~",
    "fCQBt0RR910001t1#We6Vsn&?314z$b98TVWn`3-lqiTx0fm%|6>fEHaCt6cZ*pZWZFOvPX<>45VR@8{3}13(V{dMAbaHiLbd-~nj0J9WZE$"
    "&%j0bLHVRCX|d6bisO8|wGLjhuxhm=y3C`$oL1cj7n2aE+|ba`-Pl#`T<0%kariHL`kQj{o51B?MYluk}gO8@`=|4RS=|Nlz>bd+L=Lm&VE0"
    "000000000000000000000000@IL?m00000@IRDvlwyUHXa;BrO8|wGXbXpwQj{o50ZRf)1BR4n6Ny7G00000008hm000000000000000008h"
    "m000000000000000008hm0000000000lysD0PD=oElv0!~")


def square():
    """Periodic, around the square (+-1, +-1)."""
    return nurbs.Spline(2, range(9), [[1, 1], [-1, 1], [-1, -1], [1, -1], [1, 1], [-1, 1]], flags=nurbs.NURBS_PERIODIC)


def half_circle():
    return nurbs.Spline.create_homogeneous(1, [0, 0, 1, 1], [[1, 0, 1], [0, 1, 0]])


def status_of(call, *arguments):
    try:
        call(*arguments)
    except nurbs.NurbsError as error:
        return error.status
    return nurbs.NURBS_OK


# --- What a program of another maker writes, by the page of the manual.

def checksum(contents):
    total = 2**64 - 1
    for byte in contents:
        total ^= byte
        for _ in range(8):
            total = total >> 1 ^ (0xC96C5795D7870F42 if total & 1 else 0)
    return total ^ (2**64 - 1)


def aligned(part):
    return part + bytes(-len(part) % 64)


def sealed(kind, integers, body):
    head = b"\x89NUR\r\n\x1a\n" + struct.pack("<HHIQ", 1, 0, kind, 64 + len(body))
    rest = struct.pack("<8i", *integers, *[0] * (8 - len(integers))) + body
    return head + struct.pack("<Q", checksum(head + rest)) + rest


def written(spline):
    form = 2 if spline.is_homogeneous else 1 if spline.rational else 0
    points = (spline.homogeneous_points if form == 2 else spline.points).astype("<f8").tobytes()
    weights = spline.weights.astype("<f8").tobytes() if form == 1 else b""
    knots = aligned(b"".join(axis.astype("<f8").tobytes() for axis in spline.knots))
    axes = b"".join(struct.pack("<qii", *axis) for axis in zip(spline.counts, spline.degrees, spline.periodic))
    first = 128 + len(knots)
    behind = first + len(aligned(points)) if form == 1 else 0
    places = struct.pack("<qq", first, behind)
    body = axes.ljust(48, b"\0") + places + knots + (aligned(points) if form == 1 else points) + weights
    return sealed(nurbs.NURBS_BYTES_SPLINE, [spline.axes, spline.dimension, form], body)


def written_list(splines, names, unit):
    different = list(dict.fromkeys(splines))
    texts = [name.encode() for name in names]
    numbers = [len(splines), len(different), 0, sum(map(len, texts))]
    body = aligned(struct.pack("<4qd", *numbers, unit))
    body += aligned(struct.pack(f"<{len(splines)}q", *map(different.index, splines)))
    body += aligned(np.cumsum([len(text) for text in texts]).astype("<i8").tobytes()) + aligned(b"".join(texts))
    records = [aligned(written(spline)) for spline in different]
    first = 64 + len(body) + len(aligned(bytes(8 * len(records))))
    places = first + np.cumsum([0, *map(len, records)])[:-1]
    return sealed(nurbs.NURBS_BYTES_LIST, [], body + aligned(places.astype("<i8").tobytes()) + b"".join(records))


class Layout(unittest.TestCase):
    def test_checksum(self):
        self.assertEqual(checksum(b"123456789"), 0x995DC9BBDF1939FA)

    def test_splines(self):
        for spline in [*SPLINES, square(), half_circle(), circle()]:
            contents = spline.to_bytes()
            self.assertIsInstance(contents, bytes)
            self.assertEqual(contents, written(spline))
            self.assertEqual(nurbs.Spline.from_bytes(written(spline)), spline)

    def test_lists(self):
        splines = [circle(), patch(), circle(), square(), *SPLINES[:5]]
        names = [str(i) * i for i in range(len(splines))]
        made = nurbs.SplineList.create(splines, names, 0.0254)
        self.assertEqual(made.to_bytes(), written_list(splines, names, 0.0254))
        again = nurbs.SplineList.from_bytes(written_list(splines, names, 0.0254))
        self.assertEqual((list(again), again.names, again.unit), (splines, names, 0.0254))

    def test_examples_of_the_manual(self):
        blocks = re.findall(r"\\code\{\.py\}\n(.*?) \* \\endcode", (TOP / "capi/doc/bytes.dox").read_text(), flags=re.S)
        self.assertEqual(len(blocks), 4)
        names = {}
        for block in blocks:
            exec("\n".join(line.removeprefix(" * ") for line in block.splitlines()), names)
        self.assertTrue((names["points"] == names["spline"].points).all())
        self.assertFalse(names["points"].flags.owndata)
        self.assertEqual(names["back"], names["spline"].reverse())
        np.testing.assert_array_equal(names["vertices"], names["model"].vertices)
        self.assertEqual(names["again"], names["spline"])

    def test_views_in_place(self):
        for spline in SPLINES:
            contents = spline.to_bytes()
            axes, dim, form = np.frombuffer(contents, "<i4", 3, 32)
            counts = np.ndarray(axes, "<i8", contents, 64, 16)
            first, = np.frombuffer(contents, "<i8", 1, 112)
            points = np.ndarray((*counts, dim + (form == 2)), "<f8", contents, first)
            self.assertEqual(points.tobytes(), (spline.homogeneous_points if form == 2 else spline.points).tobytes())


class Contents(unittest.TestCase):
    def test_any_memory(self):
        contents = square().to_bytes()
        shifted = bytearray(b"." + contents)  # not aligned
        for given in (contents, bytearray(contents), memoryview(shifted)[1:], memoryview(contents[::-1])[::-1],
                      np.frombuffer(contents, np.uint8), np.frombuffer(contents, np.float64)):
            self.assertEqual(nurbs.Spline.from_bytes(given), square())

    def test_other_contents(self):
        splines, face = nurbs.SplineList.create([circle()]), nurbs.Face(patch())
        for contents, read in ((circle().to_bytes(), nurbs.Spline.from_bytes),
                               (splines.to_bytes(), nurbs.SplineList.from_bytes),
                               (face.to_bytes(), nurbs.Face.from_bytes),
                               (nurbs.Model([face]).to_bytes(), nurbs.Model.from_bytes)):
            spoiled = bytearray(contents)
            spoiled[-1] ^= 1
            for status, given in ((nurbs.NURBS_ERROR_TRUNCATED, b""), (nurbs.NURBS_ERROR_TRUNCATED, contents[:-1]),
                                  (nurbs.NURBS_ERROR_FORMAT, b"x" * 100), (nurbs.NURBS_ERROR_CHECKSUM, spoiled)):
                self.assertRaises(nurbs.ContentsError, read, given)
                self.assertEqual(status_of(read, given), status)
            for given in ("text", 5, [1, 2]):
                self.assertRaisesRegex(TypeError, "bytes-like", read, given)
        self.assertEqual(status_of(nurbs.Spline.from_bytes, splines.to_bytes()), nurbs.NURBS_ERROR_FORMAT)

    def test_kinds(self):
        for contents, kind in ((circle().to_bytes(), nurbs.NURBS_BYTES_SPLINE),
                               (nurbs.SplineList.create([]).to_bytes(), nurbs.NURBS_BYTES_LIST),
                               (nurbs.Face(patch()).to_bytes(), nurbs.NURBS_BYTES_FACE),
                               (nurbs.Model().to_bytes(), nurbs.NURBS_BYTES_MODEL)):
            self.assertEqual(nurbs.bytes_kind(contents), (kind, 1, 0))
            self.assertEqual(nurbs.bytes_kind(memoryview(contents)[:64]).kind, kind)
        self.assertEqual(status_of(nurbs.bytes_kind, circle().to_bytes()[:63]), nurbs.NURBS_ERROR_TRUNCATED)


class Pickles(unittest.TestCase):
    def test_old_ones(self):
        for text, wanted in zip(OLD_PICKLES, (square(), half_circle())):
            again = pickle.loads(base64.b85decode(text))
            self.assertIs(type(again), nurbs.Spline)
            self.assertEqual(again, wanted)

    def test_functions_are_found_by_name(self):
        for value in (circle(), nurbs.SplineList.create([circle()]), nurbs.Face(patch()), nurbs.Model()):
            restore = value.__reduce_ex__(5)[0]
            self.assertIs(getattr(nurbs, restore.__name__), restore)
            self.assertNotIn(b"nurbs._", pickle.dumps(value, 0))

    def test_out_of_band(self):
        for value in (circle(), nurbs.SplineList.create([circle(), patch()]), nurbs.Model([nurbs.Face(patch())])):
            buffers = []
            head = pickle.dumps(value, 5, buffer_callback=buffers.append)
            self.assertLess(len(head), 100)
            self.assertEqual([bytes(buffer) for buffer in buffers], [value.to_bytes()])
            self.assertEqual(pickle.loads(head, buffers=buffers).to_bytes(), value.to_bytes())

    def test_lists(self):
        made = nurbs.SplineList.create([circle(), patch()], ["a", "b"], 1e-3)
        for protocol in range(pickle.HIGHEST_PROTOCOL + 1):
            again = pickle.loads(pickle.dumps(made, protocol))
            self.assertEqual((list(again), again.names, again.unit), (list(made), ["a", "b"], 1e-3))

    def test_spoiled(self):
        buffers = []
        head = pickle.dumps(circle(), 5, buffer_callback=buffers.append)
        spoiled = bytearray(buffers[0])
        spoiled[200] ^= 4
        self.assertRaises(nurbs.ContentsError, pickle.loads, head, buffers=[spoiled])


class Lists(unittest.TestCase):
    def test_create(self):
        given = [circle(), patch()]
        for made in (nurbs.SplineList.create(given), nurbs.SplineList.create(iter(given), iter(["0", "1"]))):
            self.assertEqual((list(made), made.names, made.unit, made.notes), (given, ["0", "1"], 0, []))
        self.assertEqual(len(nurbs.SplineList.create([])), 0)

    def test_refused(self):
        for error, arguments in ((ValueError, ([circle()], ["a", "b"])), (ValueError, ([circle()], ["a\0"])),
                                 (TypeError, ([3],)), (TypeError, ([circle()], [3])),
                                 (nurbs.ArgumentError, ([circle()], None, -1))):
            self.assertRaises(error, nurbs.SplineList.create, *arguments)


class Periodic(unittest.TestCase):
    def test_each_point_once(self):
        made = nurbs.Spline.create_periodic(2, range(2, 7), [[1, 1], [-1, 1], [-1, -1], [1, -1]])
        self.assertEqual(made, square())
        self.assertEqual(made.unwrapped_counts, (4,))
        self.assertIsNone(made.unwrapped_weights)

    def test_round_trips(self):
        for spline in (spline for spline in SPLINES if not spline.is_homogeneous):
            flags = sum(nurbs.on_axis(k, nurbs.NURBS_PERIODIC) for k, periodic in enumerate(spline.periodic) if periodic)
            made = nurbs.Spline.create_periodic(spline.degrees, spline.unwrapped_knots, spline.unwrapped_points,
                                                spline.unwrapped_weights, flags)
            for wanted, found in zip(spline.unwrapped_knots, made.unwrapped_knots):
                self.assertTrue((wanted == found).all())
            self.assertTrue((made.points == spline.points).all())
            self.assertEqual((made.periodic, made.counts), (spline.periodic, spline.counts))

    def test_short_knots(self):
        for short, full in zip(patch().short_knots, patch().knots):
            self.assertTrue((short == full[1:-1]).all())
        constant = nurbs.Spline(0, [0, 1], [[5.0]])
        self.assertRaises(nurbs.ArgumentError, lambda: constant.short_knots)


if __name__ == "__main__":
    unittest.main()
