# SPDX-License-Identifier: MIT
"""The shared library: where it is found, the types of its functions, how they are called."""

from __future__ import annotations

import ctypes
import operator
import os
from typing import Any

from ._errors import error_class
from .constants import NURBS_OK


def _integer(ctype: Any, low: int, high: int) -> Any:
    """An argument type that refuses what does not fit, where ctypes would cut it off, and takes NumPy's integers."""

    class Argument:
        @staticmethod
        def from_param(value: Any) -> Any:
            number = operator.index(value)
            if not low <= number <= high:
                raise OverflowError(f"{number} does not fit {ctype.__name__}")
            return ctype(number)

    return Argument


class _Double:
    @staticmethod
    def from_param(value: Any) -> ctypes.c_double:
        return ctypes.c_double(value)


# Each function: the type of the result, then one letter for each argument.
_RESULTS = {"i": ctypes.c_int32, "l": ctypes.c_int64, "s": ctypes.c_char_p, "v": None}
_ARGUMENTS = {
    "i": _integer(ctypes.c_int32, -(2**31), 2**31 - 1),
    "u": _integer(ctypes.c_uint32, 0, 2**32 - 1),
    "l": _integer(ctypes.c_int64, -(2**63), 2**63 - 1),
    "d": _Double,
    "p": ctypes.c_void_p,
}
PROTOTYPES = {
    "nurbs_version": "i ",
    "nurbs_status_name": "s i",
    "nurbs_last_error": "l pl",
    "nurbs_create": "i ippplipllplup",
    "nurbs_create_homogeneous": "i ippplipllup",
    "nurbs_create_short": "i ippplipllplup",
    "nurbs_create_multiplicities": "i ipppppipllplup",
    "nurbs_create_bezier": "i ipipllplp",
    "nurbs_with_points": "i ppllplp",
    "nurbs_clone": "i pp",
    "nurbs_destroy": "v p",
    "nurbs_knots_uniform": "i ilddlp",
    "nurbs_knots_open_uniform": "i ilddlp",
    "nurbs_knots_bezier": "i ilplp",
    "nurbs_knots_averaged": "i ilplp",
    "nurbs_knots_periodic": "i ilpplp",
    "nurbs_axes": "i pp",
    "nurbs_dimension": "i pp",
    "nurbs_degree": "i pip",
    "nurbs_count": "i pip",
    "nurbs_point_count": "i pp",
    "nurbs_is_rational": "i pp",
    "nurbs_knots": "i pilp",
    "nurbs_distinct_knots": "i pilppp",
    "nurbs_knot_form": "i pip",
    "nurbs_domain": "i pip",
    "nurbs_greville": "i pilp",
    "nurbs_points": "i plpll",
    "nurbs_weights": "i plpl",
    "nurbs_homogeneous_points": "i plpll",
    "nurbs_hull_size": "i plpllplu",
    "nurbs_find_spans": "i ilpllplpu",
    "nurbs_bernstein": "i iilplpll",
    "nurbs_basis": "i ilplilplppllu",
    "nurbs_rational_basis": "i plpllppllu",
    "nurbs_eval": "i plpllpllu",
    "nurbs_derivative_slots": "i iip",
    "nurbs_eval_derivs": "i pilpllpllu",
    "nurbs_eval_grid": "i ppppllu",
    "nurbs_eval_grid_derivs": "i pipppllu",
    "nurbs_eval_f32": "i plpllpllu",
    "nurbs_eval_grid_f32": "i ppppllu",
    "nurbs_iso": "i pidup",
    "nurbs_surface_eval_frames": "i plpllpllpllpllpllpu",
    "nurbs_surface_eval_grid_frames": "i ppppllpllpllpllpu",
    "nurbs_surface_eval_curvatures": "i plpllpllpllplplpu",
    "nurbs_curve_eval_frames": "i plplpllpllpllpllplplpu",
    "nurbs_curve_rotation_minimizing_frames": "i plplppllpllpllpllpu",
    "nurbs_insert_knot": "i pidip",
    "nurbs_elevate": "i piip",
    "nurbs_reverse": "i piup",
    "nurbs_transpose": "i ppp",
    "nurbs_reparametrize": "i piddp",
    "nurbs_make_rational": "i pp",
    "nurbs_to_homogeneous": "i pp",
    "nurbs_from_homogeneous": "i pp",
    "nurbs_normalize_weights": "i pp",
    "nurbs_reparametrize_moebius": "i pidp",
    "nurbs_equalize_end_weights": "i pip",
    "nurbs_blossom": "i pplppu",
    "nurbs_derivative": "i piip",
    "nurbs_antiderivative": "i pip",
    "nurbs_product": "i ppup",
    "nurbs_compose": "i ppp",
    "nurbs_sum": "i pdpdp",
    "nurbs_create_hermite": "i lpipllpllp",
    "nurbs_to_hermite": "i plpppp",
    "nurbs_to_power": "i plpppp",
    "nurbs_create_power": "i ippplipllup",
    "nurbs_basis_matrix": "i iiilp",
    "nurbs_transform": "i pippp",
    "nurbs_transform_projective": "i pipp",
    "nurbs_mirror": "i pppp",
    "nurbs_project_to_plane": "i ppppp",
    "nurbs_project_from": "i ppppp",
    "nurbs_refine": "i pilpp",
    "nurbs_refine_uniform": "i pilp",
    "nurbs_refinement_matrix": "i pilplpppp",
    "nurbs_split": "i pidpp",
    "nurbs_extract": "i pppp",
    "nurbs_decompose": "i pp",
    "nurbs_split_at_knots": "i piip",
    "nurbs_clamp_ends": "i piup",
    "nurbs_move_seam": "i pidp",
    "nurbs_join": "i lpidupp",
    "nurbs_snap_knots": "i pidpp",
    "nurbs_make_compatible": "i lpdupp",
    "nurbs_extend": "i piidip",
    "nurbs_unclamp": "i piup",
    "nurbs_make_periodic": "i pidppp",
    "nurbs_detect_periodic": "i pip",
    "nurbs_continuity": "i pidddlpppppppp",
    "nurbs_continuity_between": "i pipidddppppp",
    "nurbs_deviation": "i pppp",
    "nurbs_remove_knot": "i pididppp",
    "nurbs_reduce_knots": "i pidpp",
    "nurbs_reduce_degree": "i piipp",
    "nurbs_simplify": "i pdpp",
    "nurbs_curve_line": "i ippp",
    "nurbs_curve_polyline": "i lipllplp",
    "nurbs_curve_polygon": "i ipppdlp",
    "nurbs_curve_rounded_rectangle": "i ipppdddp",
    "nurbs_curve_circle": "i ipppdip",
    "nurbs_curve_arc": "i ipppdddip",
    "nurbs_curve_arc_through": "i ipppip",
    "nurbs_curve_arc_tangent": "i ipppip",
    "nurbs_curve_ellipse": "i ipppddddip",
    "nurbs_curve_parabola": "i ipppdddp",
    "nurbs_curve_hyperbola": "i ipppddddp",
    "nurbs_curve_conic_triangle": "i ipppdp",
    "nurbs_curve_conic_shoulder": "i ippppdp",
    "nurbs_curve_conic_point": "i ipppppip",
    "nurbs_curve_conic_through": "i ipllip",
    "nurbs_conic_axes": "i ppppp",
    "nurbs_curve_conic_implicit": "i pddip",
    "nurbs_curve_conic_focus": "i ipppdddip",
    "nurbs_curve_shape_factor": "i ppp",
    "nurbs_curve_helix": "i ipppddddddpp",
    "nurbs_extrude": "i ppp",
    "nurbs_revolve": "i pppdip",
    "nurbs_ruled": "i ppup",
    "nurbs_tensor_sum": "i pdpdp",
    "nurbs_tensor_product": "i ppp",
    "nurbs_surface_swung": "i ppdp",
    "nurbs_surface_plane": "i ipppp",
    "nurbs_surface_bilinear": "i ipllp",
    "nurbs_volume_trilinear": "i ipllp",
    "nurbs_surface_sphere": "i pppdip",
    "nurbs_surface_spherical_patch": "i pppdddddip",
    "nurbs_surface_sphere_patches": "i pppdup",
    "nurbs_surface_ellipsoid": "i pppdddip",
    "nurbs_surface_cylinder": "i pppddddip",
    "nurbs_surface_cone": "i pppdddddip",
    "nurbs_surface_torus": "i pppddddddip",
    "nurbs_surface_paraboloid": "i pppdddddip",
    "nurbs_surface_saddle": "i pppdddp",
    "nurbs_surface_hyperboloid": "i pppdddddddiup",
    "nurbs_boundaries": "i pp",
    "nurbs_surface_coons": "i pdp",
    "nurbs_surface_coons_hermite": "i ppipdpp",
    "nurbs_coons_gaps": "i ppppp",
    "nurbs_volume_coons": "i pdp",
    "nurbs_recognize": "i pdpppp",
    "nurbs_closest_points": "i plpllpdlpllpllplpu",
    "nurbs_farthest_points": "i plpllpdlpllpllplpu",
    "nurbs_closest_local": "i plpllpllpllpllplpu",
    "nurbs_closest_all": "i pppdllpppp",
    "nurbs_critical_points": "i pppdllppppp",
    "nurbs_curve_signed_distances": "i plplldlplplpu",
    "nurbs_distance": "i ppdlppppp",
    "nurbs_hausdorff_distance": "i ppdlppppp",
    "nurbs_curve_length": "i ppdpp",
    "nurbs_curve_lengths": "i plpldpl",
    "nurbs_curve_params_at_lengths": "i plpldplu",
    "nurbs_curve_divide": "i ppldupp",
    "nurbs_surface_area": "i ppdpp",
    "nurbs_moments": "i pdpppp",
    "nurbs_enclosed_area": "i lpddpppp",
    "nurbs_enclosed_volume": "i lpdppppp",
    "nurbs_box": "i ppdppp",
    "nurbs_oriented_box": "i pdppp",
    "nurbs_tangent_cone": "i pipdpp",
    "nurbs_normal_cone": "i ppdpp",
    "nurbs_extreme_point": "i pppdppp",
    "nurbs_curve_features": "i pulppppp",
    "nurbs_curve_monotone_pieces": "i pplpppp",
    "nurbs_curve_convexity": "i pp",
    "nurbs_straightness": "i pppp",
    "nurbs_planarity": "i pppp",
    "nurbs_boundary_contacts": "i pdpppp",
    "nurbs_singular_points": "i pdlpppp",
    "nurbs_fold_test": "i ppppp",
    "nurbs_pull_weight": "i plpdpp",
    "nurbs_pull_weights": "i plppdpp",
    "nurbs_set_weights": "i plppp",
    "nurbs_weight_points": "i plpppp",
    "nurbs_weight_cross_ratio": "i ippppp",
    "nurbs_weight_through": "i plppdpp",
    "nurbs_pull_point": "i plppdpp",
    "nurbs_most_influential": "i plpllpp",
    "nurbs_insert_on_leg": "i pildpp",
    "nurbs_insert_at_point": "i pipdpppp",
    "nurbs_constrain": "i plpppppppdppppp",
    "nurbs_warp": "i pppdip",
    "nurbs_flatten": "i ppppppp",
    "nurbs_bend": "i ppppddddppp",
    "nurbs_free_form_deform": "i ppppdppp",
    "nurbs_fair": "i pipdppp",
    "nurbs_snap_boundary": "i piipiiiupp",
    "nurbs_collocation": "i ippplplplllppppu",
    "nurbs_rational_collocation": "i pplplllppppu",
    "nurbs_bezier_extraction": "i pilpppp",
    "nurbs_eval_adjoint": "i pilpllpllpllplpllu",
    "nurbs_read_options_init": "i pl",
    "nurbs_read": "i plpp",
    "nurbs_read_file": "i ppp",
    "nurbs_list_count": "i pp",
    "nurbs_list_get": "i plp",
    "nurbs_list_name": "i plplp",
    "nurbs_list_note_count": "i pp",
    "nurbs_list_note": "i plpppplp",
    "nurbs_list_unit": "i pp",
    "nurbs_list_destroy": "v p",
}


def _load() -> ctypes.CDLL:
    name = os.environ.get("NURBS_LIBRARY") or "libnurbs.so.1"
    try:
        # CDLL, unlike PyDLL, releases the interpreter's lock during calls.
        library = ctypes.CDLL(name)
    except OSError as error:
        raise ImportError(f"the library {name} cannot be loaded ({error}); install libnurbs, or set NURBS_LIBRARY to "
                          "the path of libnurbs.so") from error
    for function, types in PROTOTYPES.items():
        result, arguments = types.split(" ")
        entry = getattr(library, function)
        entry.restype = _RESULTS[result]
        entry.argtypes = [_ARGUMENTS[letter] for letter in arguments]
    return library


#: The C functions themselves, by their names in nurbs.h.
lib = _load()


def version() -> int:
    """Version of the library that is loaded: major * 10000 + minor * 100 + patch."""
    return int(lib.nurbs_version())


def status_name(status: int) -> str:
    """Name of a status, such as "NURBS_ERROR_NULL"."""
    return str(lib.nurbs_status_name(status).decode())


def last_error() -> str:
    """Message of the last failed call in this thread."""
    size = lib.nurbs_last_error(None, 0) + 1
    text = ctypes.create_string_buffer(size)
    lib.nurbs_last_error(text, size)
    return text.value.decode(errors="replace")


def call(function: Any, *arguments: Any) -> None:
    """Calls a function of the library; raises NurbsError unless its status is success."""
    try:
        status = function(*arguments)
    except ctypes.ArgumentError as error:
        kind = OverflowError if "OverflowError" in str(error) else TypeError
        raise kind(f"{function.__name__}(), {error}") from None
    if status != NURBS_OK:
        raise error_class(status)(status, status_name(status), last_error())


def get(ctype: Any, function: Any, *arguments: Any) -> Any:
    """The one value that a function writes through its last argument."""
    value = ctype()
    call(function, *arguments, ctypes.byref(value))
    return value.value


def text(function: Any, *arguments: Any) -> str:
    """The text that a function writes to (buf, cap, length), its last arguments."""
    length = ctypes.c_int64()
    call(function, *arguments, None, 0, ctypes.byref(length))
    buffer = ctypes.create_string_buffer(length.value + 1)
    call(function, *arguments, buffer, length.value + 1, None)
    return buffer.value.decode(errors="replace")
