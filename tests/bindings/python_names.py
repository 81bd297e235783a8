# SPDX-License-Identifier: MIT
"""Names in Python: where the rule puts every C function, and what is said about each name."""

import inspect
import pathlib
import re
import unittest

import nurbs

HEADER = pathlib.Path(__file__).resolve().parents[2] / "include/nurbs/nurbs.h"
NAMESAKES = {"clone": "copy", "clamp_ends": "clamp", "is_rational": "rational", "knot_form": "knot_forms",
             "degree": "degrees", "count": "counts", "unwrapped_count": "unwrapped_counts", "region_create": "region", "region_combine": "combine",
             "surface_intersections": "meet", "surface_self_intersections": "meet_itself", "intersections": "meet",
             "surfaces_common_points": "common_points"}
#: What is no function of its own: handles, lists and structs.
INSIDE = {"nurbs_create", "nurbs_destroy", "nurbs_read_options_init", "nurbs_write_options_init", "nurbs_call_options_init", "nurbs_list_count",
          "nurbs_list_get",
          "nurbs_list_create", "nurbs_list_write", "nurbs_list_write_with", "nurbs_list_write_file",
          "nurbs_list_write_file_with", "nurbs_list_to_bytes", "nurbs_list_from_bytes",
          "nurbs_list_name", "nurbs_list_note_count", "nurbs_list_note", "nurbs_list_unit", "nurbs_list_destroy",
          "nurbs_data_init", "nurbs_statistics_create", "nurbs_statistics_destroy", "nurbs_statistics_size",
          "nurbs_fit_options_init", "nurbs_cloud_options_init", "nurbs_face_destroy", "nurbs_model_destroy",
          "nurbs_meet_destroy", "nurbs_mesh_options_init", "nurbs_mesh_destroy"}


def functions():
    """{name: the class of its first argument, if that is one handle that it only reads}; what else makes statistics,
    faces or models has them first too."""
    text = re.sub(r"/\*.*?\*/", " ", HEADER.read_text(), flags=re.S)
    found = {}
    for name, arguments in re.findall(r"NURBS_API[^;()]*?(\w+)\(([^)]*)\);", text):
        first = re.match(r"\s*const (nurbs|nurbs_statistics|nurbs_face|nurbs_model|nurbs_meet|nurbs_mesh) \*\w+(,|$)", arguments)
        own = re.match("nurbs_(?:read_(?=model))?(statistics|face|model|meet|region)", name)
        found[name] = f"nurbs_{own[1]}".replace("region", "model") if own else first[1] if first else ""
    return found


def names_of(function):
    """What a function may be called here."""
    name = re.sub("^nurbs_(statistics_|face_|model_|meet_|mesh_(?!curve|surface|(face|model)(_levels)?$|volume$))?", "",
                  function.removesuffix("_with"))
    name = re.sub(r"^mesh_(?!curve|volume)\w*?(_levels)?$", r"mesh\1", name).replace("read_model", "read")
    short = re.sub(r"^(curve|surface|volume)_(?!eval)", "", name)
    return {NAMESAKES.get(name, name), short, name.replace("_eval", ""), re.sub("^volume_(coons)", r"\1_volume", name),
            re.sub("^create_", "", name)}


def public(thing):
    return {name: value for name, value in vars(thing).items() if not name.startswith("_")}


def attributes(cls):
    """{name: value} of all public attributes of a class."""
    return {name: inspect.getattr_static(cls, name) for name in dir(cls) if not name.startswith("_")}


def own(cls):
    """Those that are not inherited from Python."""
    inherited = {name for base in cls.__mro__ if not base.__module__.startswith("nurbs") for name in vars(base)}
    return {name: value for name, value in attributes(cls).items() if name not in inherited}


def unwrapped(value):
    """The function behind a method, property or class method."""
    return getattr(value, "fget", None) or getattr(value, "func", None) or getattr(value, "__func__", value)


class Rule(unittest.TestCase):
    def test_methods_have_a_spline_first(self):
        functions_here, methods = public(nurbs), attributes(nurbs.Spline)
        found = functions()
        self.assertTrue(found)
        for function, first in found.items():
            if function not in INSIDE and first not in ("nurbs_statistics", "nurbs_face", "nurbs_model", "nurbs_meet",
                                                            "nurbs_mesh"):
                named = names_of(function)
                made = function.startswith("nurbs_create_") or function == "nurbs_from_bytes"
                self.assertEqual(bool(named & methods.keys()), first == "nurbs" or made, function)
                self.assertEqual(bool(named & functions_here.keys()), first != "nurbs" and not made, function)

    def test_methods_of_statistics(self):
        functions_here, methods = public(nurbs), attributes(nurbs.Statistics)
        found = {function for function, first in functions().items() if first == "nurbs_statistics"} - INSIDE
        self.assertGreaterEqual(found, {"nurbs_fit", "nurbs_statistics_add", "nurbs_statistics_merge"})
        for function in found:
            self.assertTrue(names_of(function) & methods.keys(), function)
            self.assertFalse(names_of(function) & functions_here.keys(), function)

    def test_methods_of_faces(self):
        methods = attributes(nurbs.Face)
        found = {function for function, first in functions().items() if first == "nurbs_face"} - INSIDE
        self.assertGreaterEqual(found, {"nurbs_face_create", "nurbs_face_area", "nurbs_face_classify_with"})
        for function in found:
            self.assertTrue(names_of(function) & methods.keys(), function)

    def test_methods_of_models(self):
        methods = attributes(nurbs.Model)
        found = {function for function, first in functions().items() if first == "nurbs_model"} - INSIDE
        self.assertGreaterEqual(found, {"nurbs_read_model", "nurbs_read_model_file_with", "nurbs_model_face"})
        for function in found:
            self.assertTrue(names_of(function) & methods.keys(), function)

    def test_methods_of_meets(self):
        methods = attributes(nurbs.Meet)
        found = {function for function, first in functions().items() if first == "nurbs_meet"} - INSIDE
        self.assertGreaterEqual(found, {"nurbs_meet_counts", "nurbs_meet_branch", "nurbs_meet_clone"})
        for function in found:
            self.assertTrue(names_of(function) & methods.keys(), function)

    def test_methods_of_meshes(self):
        methods = attributes(nurbs.Mesh)
        found = {function for function, first in functions().items() if first == "nurbs_mesh"} - INSIDE
        self.assertGreaterEqual(found, {"nurbs_mesh_counts", "nurbs_mesh_triangles_i32", "nurbs_mesh_clone"})
        for function in found:
            self.assertTrue(names_of(function) & methods.keys(), function)


class Documentation(unittest.TestCase):
    def names(self):
        """(name, value) of everything that a user sees and that can be described."""
        for name, value in public(nurbs).items():
            if inspect.isfunction(value):
                yield name, value
            elif inspect.isclass(value):
                yield name, value
                for attribute, what in own(value).items():
                    if attribute not in getattr(value, "_fields", ()):
                        yield f"{name}.{attribute}", unwrapped(what)

    def test_everything_is_described(self):
        names = dict(self.names())
        self.assertGreater(len(names), 260)
        for name, value in names.items():
            self.assertRegex(value.__doc__ or "", r"(?s)^\S.{8,}\.\s*$", name)
        for name, value in names.items():
            # The ones that NamedTuple writes say nothing.
            self.assertNotRegex(value.__doc__, r"^\w+\(", name)

    def test_everything_has_types(self):
        for name, value in self.names():
            if inspect.isclass(value):
                for field in getattr(value, "_fields", ()):
                    self.assertIn(field, value.__annotations__, name)
                continue
            signature = inspect.signature(value)
            self.assertIsNot(signature.return_annotation, signature.empty, name)
            for parameter in signature.parameters.values():
                self.assertTrue(parameter.name in ("self", "cls") or parameter.annotation is not parameter.empty,
                                (name, parameter.name))


if __name__ == "__main__":
    unittest.main()
