# SPDX-License-Identifier: MIT
"""The table of the bindings: what is said of mistakes in it, and what follows from an entry.

usage: table_checks.py TOP_FOLDER
"""

import re
import sys
import tomllib
import unittest
from pathlib import Path

TOP = Path(sys.argv.pop(1) if len(sys.argv) > 1 else Path(__file__).parents[2]).resolve()
sys.path.insert(0, str(TOP / "cmake/interface"))

import cpp  # noqa: E402 - from the project
import header  # noqa: E402 - from the project
import methods  # noqa: E402 - from the project
import rust_methods  # noqa: E402 - from the project
import signature  # noqa: E402 - from the project
import table  # noqa: E402 - from the project

HEADER = """
/** \\defgroup some Some functions
 * @{ */
typedef struct nurbs nurbs;
/** \\brief Adds two.
 * \\param[in] a,b splines
 * \\param[in] scale a factor
 * \\param[out] out the sum
 * \\return NURBS_OK */
NURBS_API nurbs_status nurbs_add(const nurbs *a, const nurbs *b, double scale, nurbs **out);
/** \\brief Points nearest to some.
 * \\param[in] g the spline
 * \\param[in] n number of points
 * \\param[in] points [n][dim] the points
 * \\param[in] point_stride,point_component_stride their strides
 * \\param[in] range [axes][2] or NULL for all of it: where
 * \\param[in] tolerance allowed
 * \\param[out] params [n][axes] where they are
 * \\param[out] gap or NULL: the largest
 * \\return NURBS_OK */
NURBS_API nurbs_status nurbs_near(const nurbs *g, int64_t n, const double *points, int64_t point_stride,
    int64_t point_component_stride, const double *range, double tolerance, double *params, double *gap);
MORE/** @} */
"""
WITH = """/** \\brief The same, watched.
 * \\return NURBS_OK */
NURBS_API nurbs_status nurbs_add_with(const nurbs *a, const nurbs *b, double scale,
    const nurbs_call_options *call, nurbs **out);
"""
GOOD = """
[group]
doc = "Some functions."

[Near]
doc = "Where, and how far."
params = "[n][axes]"
gap = "The largest."

[nurbs_add]
call = "add(a, b, scale = 1)"
fortran.call = "add_splines(a, b, out, scale?)"

[nurbs_near]
call = "near(g, points, tolerance = 0, range = {}) -> Near"
fortran.call = "near_points(g, points, params, gap?, range?, tolerance?)"
"""


def read(text=GOOD, more="", order=("some",)):
    manual = header.parse(HEADER.replace("MORE", more))
    general = {"order": list(order), "truths": [], "unsigned": [], "indices": []}
    return table.parse(manual, {"some": tomllib.loads(text), "general": general})


def changed(before, after):
    if before not in GOOD:
        raise ValueError(before)
    return GOOD.replace(before, after)


class Mistakes(unittest.TestCase):
    def expect(self, message, text=GOOD, **more):
        with self.assertRaises(table.TableError) as caught:
            read(text, **more)
        self.assertIn(message, str(caught.exception).split("\n"))

    def test_a_function_without_an_entry(self):
        self.expect("nurbs.h: nurbs_add: has no entry in capi/bindings/table: add [nurbs_add] with call = \"...\" to a file "
                    "there", GOOD.replace("[nurbs_add]", "[nurbs_near_]").split("[nurbs_near_]")[0]
                    + "[nurbs_near]" + GOOD.split("[nurbs_near]")[1])

    def test_an_entry_without_a_function(self):
        self.expect("some.toml: nurbs_ad: nurbs.h has no such function; did you mean nurbs_add?",
                    changed("[nurbs_add]", "[nurbs_ad]"))

    def test_no_call_for_a_language(self):
        self.expect("some.toml: nurbs_add: needs call = \"...\", or fortran.call, or by_hand = \"where\"",
                    changed("fortran.call = \"add_splines(a, b, out, scale?)\"\n", "cpp.call = \"add(a, b, scale)\"\n")
                    .replace("call = \"add(a, b, scale = 1)\"\ncpp", "rust.call = \"add(a, b, scale)\"\ncpp"))

    def test_an_unknown_parameter(self):
        self.expect("some.toml: nurbs_add: call: the function has no parameter scal; did you mean scale?",
                    changed("(a, b, scale = 1)", "(a, b, scal = 1)"))

    def test_a_parameter_that_nobody_gives(self):
        self.expect("some.toml: nurbs_add: call: nobody gives scale, and no array that is given has that length; make it an "
                    "argument, or define it: where.scale = \"...\"", changed("(a, b, scale = 1)", "(a, b)"))
        self.expect("some.toml: nurbs_add: call: nobody gives b, which must not be NULL",
                    changed("(a, b, scale = 1)", "(a, scale = 1)"))
        self.expect("some.toml: nurbs_add: call: a is given twice", changed("(a, b, scale = 1)", "(a, b, scale, a)"))

    def test_outputs_in_wrong_places(self):
        self.expect("some.toml: nurbs_near: call: gap is an output: it belongs after ->",
                    changed("range = {}) -> Near", "range = {}, gap = 0) -> Near"))
        self.expect("some.toml: nurbs_near: fortran.call: gap is an output and cannot have a default",
                    changed("gap?, range?", "gap? = 0, range?"))
        self.expect("some.toml: nurbs_near: call: the output gap is in no result", changed("-> Near", "-> params"))

    def test_unknown_keys(self):
        self.expect("some.toml: nurbs_add: unknown key dok; did you mean doc?", GOOD.replace("[nurbs_add]",
                                                                                             "[nurbs_add]\ndok = \"\""))
        self.expect("some.toml: [group]: unknown key files", changed("[group]", "[group]\nfiles = 1"))
        self.expect("some.toml: [some]: neither a function of nurbs.h nor a record (CamelCase)", GOOD + "[some]\n")

    def test_records(self):
        self.expect("some.toml: nurbs_near: call: there is no record [Neer]; did you mean Near?",
                    changed("-> Near", "-> Neer"))
        self.expect("some.toml: nurbs_near: call: [Near] has no field gaps; did you mean gap?",
                    changed("-> Near", "-> Near(params, gaps = gap)"))
        self.expect("some.toml: [Near]: defaults: there is no field gat; did you mean gap?",
                    changed("gap = \"The largest.\"", "gap = \"The largest.\"\ndefaults = {gat = 0}"))
        self.expect("some.toml: [Other]: no call uses it", GOOD + "[Other]\ndoc = \"\"\nx = \"\"\n")

    def test_shapes(self):
        self.expect("some.toml: nurbs_near: call: what is 'm'? It is no number among the parameters; define it: where.m = "
                    "...", changed("[nurbs_near]", "[nurbs_near]\nshape.params = \"[n][m]\""))
        self.expect("some.toml: nurbs_near: call: shape.param: there is no parameter param",
                    changed("[nurbs_near]", "[nurbs_near]\nshape.param = \"[n]\""))

    def test_files(self):
        self.expect("general.toml: order: some.toml is not among the files", order=())
        self.expect("general.toml: order: there is no file other.toml", order=("some", "other"))

    def test_forms_with_call_options(self):
        self.expect("nurbs.h: nurbs_add_with: has no entry in capi/bindings/table; if it is nurbs_add with call options, "
                    "put watched = true into the entry of nurbs_add", more=WITH)
        watched = changed("[nurbs_add]", "[nurbs_add]\nwatched = true")
        self.expect("some.toml: nurbs_add: watched: nurbs.h has no function nurbs_add_with", watched)
        self.expect("some.toml: nurbs_add: watched: nurbs_add_with has to have the parameters of nurbs_add, and const "
                    "nurbs_call_options *call last or before out", watched, more=WITH.replace("double scale,", ""))

    def test_all_problems_are_told(self):
        with self.assertRaises(table.TableError) as caught:
            read(changed("scale = 1", "scal = 1").replace("-> Near", "-> Neer"))
        self.assertGreaterEqual(len(str(caught.exception).split("\n")), 4)

    def test_lines_that_cannot_be_read(self):
        for line, problem in {"add(a b)": "expected ',', found 'b'", "add(a": "expected ',', found 'the end'",
                              "add(a) b": "'b' is left over", "add(a = ": "a default without an end",
                              "add(;)": "cannot read ';)'", "(a)": "expected a name after ''"}.items():
            with self.assertRaises(signature.SignatureError) as caught:
                signature.parse(line)
            self.assertEqual(str(caught.exception), problem)


class Consequences(unittest.TestCase):
    def methods(self, language, text=GOOD):
        return {method.entry.name: method for method in read(text).methods(language)}

    def test_receivers(self):
        rust, cplusplus = self.methods("rust")["nurbs_add"], self.methods("cpp")["nurbs_add"]
        self.assertEqual((rust.receiver, [argument.name for argument in rust.arguments]), ("a", ["other", "scale"]))
        self.assertEqual(cplusplus.receiver, "")
        self.assertEqual([argument.name for argument in cplusplus.arguments], ["a", "b", "scale"])

    def test_defaults_of_optional_arguments(self):
        scale = self.methods("fortran")["nurbs_add"].arguments[-1]
        self.assertEqual((scale.optional, scale.default), (True, "1"))

    def test_numbers_that_follow_from_arrays(self):
        near = self.methods("cpp")["nurbs_near"]
        self.assertEqual([value.name for value in near.computed], ["n"])
        self.assertEqual(near.sources("n")[0][0].name, "points")
        self.assertEqual(near.values["points"].strides, 2)

    def test_the_real_table(self):
        binding = table.read(header.read(TOP), TOP)
        by_hand = [entry.name for entry in binding.entries if entry.by_hand]
        self.assertEqual(len(binding.entries) + sum(entry.watched is not None for entry in binding.entries),
                         len(binding.manual.functions))
        owned = [name for name in by_hand if re.search("_(init|clone|destroy|to_bytes|levels|(list|model|mesh)_write)$", name)]  # what types do by themselves
        self.assertLess(len(by_hand) - len(owned), 6, by_hand)


class Cplusplus(unittest.TestCase):
    def text(self, text=GOOD, more=""):
        texts = cpp.files(read(text, more))
        return " ".join(texts["include/nurbs/cpp/some.hpp"].split())

    def test_a_function_of_splines(self):
        self.assertIn("/// Adds two. inline Returned<Spline> add(const Spline &a, const Spline &b, double scale = 1) { "
                      "return detail::made<Spline>(nurbs_add, a.get(), b.get(), scale); }", self.text())

    def test_checks_and_room(self):
        text = self.text()
        self.assertIn("struct Near { std::vector<double> params; ///< [n][axes] double gap; ///< The largest. };", text)
        self.assertIn("const std::int64_t n = detail::records(points, detail::dimension(g.get()), \"points\"); "
                      "const std::int64_t axes = detail::axes(g.get()); "
                      "detail::require_given(range, 2 * axes, \"range\"); Near found{detail::room(n, axes), 0};", text)
        self.assertIn("detail::call(nurbs_near, g.get(), n, points.data(), points.stride(), points.component_stride(), "
                      "detail::pointer(range), tolerance, found.params.data(), &found.gap); return found;", text)

    def test_a_form_with_call_options(self):
        text = self.text(changed("[nurbs_add]", "[nurbs_add]\nwatched = true"), WITH)
        self.assertIn("inline Returned<Spline> add(const Spline &a, const Spline &b, double scale, const CallOptions &call) "
                      "{ const detail::Watch watch(call); return detail::made<Spline>(nurbs_add_with, a.get(), b.get(), scale, "
                      "watch.get()); }", text)


class Rust(unittest.TestCase):
    def text(self, text=GOOD, more=""):
        texts = rust_methods.files(read(text, more))
        return " ".join(texts["capi/bindings/rust/src/some.rs"].split())

    def test_a_method_of_splines(self):
        text = self.text()
        self.assertIn("use crate::error::{check, Result}; use crate::spline::Spline; use crate::sys; ", text)
        self.assertIn("/// Adds two. pub fn add(&self, other: &Spline, scale: f64) -> Result<Spline> { "
                      "Spline::made(|out| unsafe { sys::nurbs_add(self.raw(), other.raw(), scale, out) }) }", text)

    def test_checks_and_room(self):
        text = self.text()
        self.assertIn("#[derive(Clone, Debug, Default, PartialEq)] #[non_exhaustive] pub struct Near { /// `[n][axes]` "
                      "pub params: Vec<f64>, /// The largest. pub gap: f64, }", text)
        self.assertIn("let points = points.into(); let n = points.count(self.dimension()? as usize, \"points\")?; "
                      "let axes = self.axes()? as usize; let range = if_given(range, 2 * axes, \"range\")?; "
                      "let mut params = vec![0.0; n * axes]; let mut gap = 0.0;", text)
        self.assertIn("check(unsafe { sys::nurbs_near(self.raw(), n as i64, points.pointer(), points.stride(), "
                      "points.component_stride(), range, tolerance, params.as_mut_ptr(), &mut gap) })?; "
                      "Ok(Near { params, gap })", text)

    def test_a_form_with_call_options(self):
        text = self.text(changed("[nurbs_add]", "[nurbs_add]\nwatched = true"), WITH)
        self.assertIn("pub fn add_with(&self, other: &Spline, scale: f64, call: &mut Call) -> Result<Spline> {", text)
        self.assertRegex(text, r"sys::nurbs_add_with\(self.raw\(\), other.raw\(\), scale, .*call.options\(\)")

    def test_numbers_are_not_hidden_by_pointers(self):
        hidden = changed("tolerance?)", "tolerance?)\"\nrust.call = \"g.near(points, cap: tolerance, range) -> Near")
        with self.assertRaisesRegex(methods.MethodError, "nurbs_near: rust.call has to rename cap"):
            self.text(hidden)

    def test_lengths_that_are_called_alike(self):
        """The points of a spline and the records of an array are two numbers."""
        grown = [method for method in table.read(header.read(TOP), TOP).methods("rust") if method.name == "eval_adjoint"]
        body = " ".join(rust_methods.Body(grown[0], table.read(header.read(TOP), TOP)).returning())
        self.assertIn("let count = self.point_count()?;", body)
        self.assertIn("let mut grad_params = vec![0.0; n * axes];", body)


if __name__ == "__main__":
    unittest.main()
