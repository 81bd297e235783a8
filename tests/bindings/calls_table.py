#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The good calls (cmake/interface/calls_reader.py): what becomes of an entry, and what is said of a wrong one.

    calls_table.py TOP     TOP is the folder of the project
"""

import pathlib
import sys
import tomllib
import unittest

TOP = pathlib.Path(sys.argv.pop(1))
sys.path.insert(0, str(TOP / "cmake/interface"))

import calls  # noqa: E402 - from the project
import calls_reader  # noqa: E402 - from the project
import header  # noqa: E402 - from the project
from calls_model import (Bytes, CallsError, Handle, Handles, Items, NewHandle, NewStruct, Null, Number,  # noqa: E402
                         Numbers, Path, Slot, Struct, StructSize)

MANUAL = header.read(TOP)
INPUTS = tomllib.loads((TOP / "tests/capi/calls/inputs.toml").read_text(encoding="utf-8"))


def read(entry, inputs=""):
    """The model of one file, with the inputs of the project and more of them."""
    more = tomllib.loads(inputs)
    given = {key: INPUTS.get(key, {}) | more.get(key, {}) for key in INPUTS.keys() | more.keys()}
    return calls_reader.parse(MANUAL, {"inputs": given, "some": tomllib.loads(entry)})


def call(entry, inputs=""):
    """The call itself; what follows it is its watched form."""
    return read(entry, inputs).groups["some"][0]


def values(entry):
    return [value for _, value in call(entry).arguments]


def numbers(*given):
    return tuple(map(Number, given))


class Rules(unittest.TestCase):
    def test_numbers_follow_from_arrays_and_outputs_have_places(self):
        self.assertEqual(values('eval = {g = "surface", params = "params"}'), [
            Handle("surface"), Number(3), Numbers(numbers(0.1, 0.9, 0.3, 0.7, 0.2, 0.6), "params"), Number(0), Number(0),
            Slot("values", 0, 9), Number(0), Number(0), Number(0)])

    def test_arrays_of_an_input_are_taken_from_its_call(self):
        made = call('find_spans = {degree = 2, count = 9, knots = "curve.knots", params = [0.5]}')
        self.assertEqual(made.value("knot_count"), Number(12))
        self.assertEqual(made.value("knots").values[3], Number(0.25))
        self.assertEqual(made.value("spans"), Slot("spans", 0, 1))

    def test_places_of_one_type_follow_each_other(self):
        made = call('closest_all = {g = "surface", point = "center", tolerance = 0, cap = 4, without = ["count"]}')
        self.assertEqual([made.value(name) for name in ("range", "budget", "params", "distances", "count", "status")],
                         [Null(), Number(0), Slot("values", 0, 8), Slot("values", 8, 4), Null(), Slot("states", 0, 1)])

    def test_strides_count(self):
        made = call('eval = {g = "curve", params = "params", point_stride = 5}')
        self.assertEqual(made.value("points"), Slot("values", 0, 5 * 5 + 2))

    def test_lengths_depend_on_the_spline(self):
        made = call('to_power = {g = "surface", cap = 54}')
        self.assertEqual([made.value(name).length for name in ("coefficients", "breaks", "piece_counts", "count")],
                         [3 * 3 * 2 * 3, 2 + 4, 2, 1])
        self.assertEqual(call('blossom = {g = "curve", params = [0.1], args = "new_knots"}').value("values").length, 3)
        self.assertEqual(call('blossom = {g = "homogeneous", params = [0.1], args = "new_knots"}').value("values").length, 3)
        self.assertEqual(call('blossom = {g = "twist", params = [0.1], args = "center"}').value("values").length, 3)
        self.assertEqual(call('eval_derivs = {g = "volume", order = 4, params = "center"}').value("derivs").length, 35 * 4)

    def test_handles(self):
        self.assertEqual(values('join = {parts = ["curve", "loop"], axis = 0, tolerance = 9}')[:2],
                         [Number(2), Handles(("curve", "loop"))])
        self.assertEqual(values('volume_coons = {faces = "faces", tolerance = 0}'),
                         [Items("faces", 6), Number(0), NewHandle("out")])
        self.assertEqual(values('split = {g = "curve", axis = 0, param = 0.5}')[-2:], [NewHandle("out"), NewHandle("other")])

    def test_inputs_are_made_after_those_that_they_need(self):
        inputs = '[made]\nthird = {function = "clone", g = "half"}'
        self.assertEqual(call('sum = {a = "third", alpha = 1, b = "curve", beta = 1}', inputs).made, ["half", "third"])

    def test_files_and_structs(self):
        self.assertEqual(values('read = {bytes = "file", options = {unit = 1e-3}}'), [
            Bytes("file"), Number(len(INPUTS["texts"]["file"])), Struct("nurbs_read_options", (("unit", Number(1e-3)),)),
            NewHandle("list")])
        self.assertEqual(values('read_file = {path = "file"}'), [Path("file"), Null(), NewHandle("list")])
        self.assertEqual(values("read_options_init = {}"),
                         [NewStruct("nurbs_read_options"), StructSize("nurbs_read_options")])

    def test_constants(self):
        flags = "NURBS_FORM_CLAMPED_START | NURBS_FORM_CLAMPED_END"
        self.assertEqual(values(f'clamp_ends = {{g = "loop", axis = 0, flags = "{flags}"}}')[2], Number(3, flags))

    def test_answers_have_places_too(self):
        self.assertEqual(call("version = {}").result, Slot("states", 0, 1))
        self.assertIsNone(call('destroy = {g = "copy"}').result)


class Messages(unittest.TestCase):
    def check(self, entry, message, inputs=""):
        with self.assertRaises(CallsError) as caught:
            read(entry, inputs)
        self.assertIn(message, str(caught.exception))

    def test_names(self):
        self.check("evall = {}", "some.toml: evall: there is no function nurbs_evall; there is eval")
        self.check('eval = {g = "curve", parms = "params", params = "params"}',
                   "some.toml: eval: nurbs_eval has no parameter parms; it has g, n, params")
        self.check('clone = {g = "curv"}', "clone: g: 'curv' is no spline of inputs.toml, which has curve, loop")
        self.check('clone = {g = "list"}', "'list' is no spline")
        self.check('eval = {g = "curve", params = "parms"}', "params: 'parms' is no array of inputs.toml")
        self.check('eval = {g = "curve", params = "curve.knot"}', "params: curve is made without an array knot; it has")
        self.check('iso = {g = "surface", axis = 0, param = 0, flags = "NURBS_CLAMPED"}', "no constant NURBS_CLAMPED")
        self.check('read = {bytes = "file", options = {units = 1}}', "options: nurbs_read_options has no field units")
        self.check('read = {bytes = "files"}', "bytes: 'files' is no text")
        self.check("axes = 1", "some.toml: axes is no table")

    def test_what_is_needed(self):
        self.check('eval = {g = "curve"}', "params: is needed")
        self.check('iso = {g = "surface", axis = 0}', "param: is needed")

    def test_lengths(self):
        self.check('eval = {g = "surface", params = "center"}', "n: params has 3 numbers, no multiple of 2: [n][axes]")
        self.check('mirror = {g = "curve", point = [1], normal = [1, 0]}',
                   "point: has 1 elements, but [dim] asks for 2 here")
        self.check('eval = {g = "curve", n = 7, params = "params"}', "params: has 6 elements, but [n][axes] asks for 7 here")
        self.check('extract = {g = "half", lower = [0], upper = [1]}', "a length depends on half, which only the library")
        self.check('eval_derivs = {g = "volume", order = 30, params = "center"}', "do not fit into Output::values")

    def test_types(self):
        self.check('iso = {g = "surface", axis = 0.5, param = 0}', "axis: 0.5 is no int32_t")
        self.check('iso = {g = "surface", axis = true, param = 0}', "axis: True is no int32_t")
        self.check('set_weights = {g = "loop", indices = [0.5], weights = [1]}', "indices: 0.5 is no int64_t")

    def test_outputs(self):
        self.check('axes = {g = "curve", axes = 1}', "axes: is an output")
        self.check('axes = {g = "curve", without = ["axes"]}', "without axes, which is no output that may be NULL")
        self.check('surface_coons = {boundaries = ["edges"], tolerance = 0}', "'edges' is no spline")
        self.check('join = {parts = "edges", axis = 0, tolerance = 0}', "the number [count] of splines does not follow")

    def test_what_is_shared_stays(self):
        self.check('destroy = {g = "curve"}', "g: is destroyed by the call, but curve is shared")
        self.check("", "other: g: 'copy' is no spline", '[shared]\nother = {function = "clone", g = "copy"}')

    def test_inputs(self):
        self.check("", "inputs.toml: other: there is no function nurbs_", '[made]\nother = {g = "curve"}')
        self.check("", "inputs.toml: other: count: cannot be NULL",
                   '[made]\nother = {function = "list_count", list = "list"}')
        self.check("", "inputs.toml: other is none of arrays", "[other]")

    def test_all_problems_are_told(self):
        self.check("evall = {}\naxes = {}", "evall")
        self.check("evall = {}\naxes = {}", "axes: g: is needed")

    def test_a_name_stands_once(self):
        with self.assertRaisesRegex(CallsError, "version stands in two files"):
            calls_reader.parse(MANUAL, {"inputs": INPUTS, "some": {"version": {}}, "other": {"version": {}}})


class Cpp(unittest.TestCase):
    def test_numbers_are_exact(self):
        written = [calls.number(Number(value)) for value in (3, -0.0, 0.1, 1e-3, 5e-324, float("inf"), -float("inf"))]
        self.assertEqual(written, ["3", "-0.0", "0.1", "0.001", "5e-324", "HUGE_VAL", "-HUGE_VAL"])
        self.assertEqual(calls.number(Number(float("nan"))), "NAN")

    def body(self, entry):
        model = read(entry)
        return "\n".join(calls.body(model, model.groups["some"][0], "o."))

    def test_a_call_of_its_own_inputs(self):
        self.assertEqual(self.body('destroy = {g = "copy"}'), """\
Made made_copy(in, make_copy);
if (made_copy.status() != NURBS_OK) {
    return made_copy.status();
}
nurbs_destroy(made_copy.release());
return NURBS_OK;""")

    def test_arrays_and_slots(self):
        self.assertEqual(self.body('eval = {g = "curve", params = [0.1, 0.5]}'), """\
static constexpr double params[] = {0.1, 0.5};
return nurbs_eval(in.curve, 2, params, 0, 0, o.values, 0, 0, 0);""")

    def test_an_array_of_nothing_is_null(self):
        self.assertEqual(self.body('refine = {g = "curve", axis = 0, knots = []}'),
                         "return nurbs_refine(in.curve, 0, 0, nullptr, &o.out);")


if __name__ == "__main__":
    unittest.main()
