# SPDX-License-Identifier: MIT
"""Calls that can take long: every one can be interrupted, and those who ask for it are told how much is done, or set a
limit of work.

watched() gives a function of the library as one that is called with the same arguments, in its form that ends with
_with. Its callback is made once for each thread and depth of nested calls, and not for every call.
"""

from __future__ import annotations

import ctypes
import threading
from typing import TYPE_CHECKING, Any, Callable, Dict, Generator, List, Optional, Sequence, Tuple, TypeVar, Union

import numpy

from ._bars import new_bar
from ._library import call, int64, lib
from .constants import NURBS_OK

if TYPE_CHECKING:
    from ._bars import Bar

    #: Called now and then with the part that is done, from 0 to 1; returns False to end the call, True or None to go
    #: on. True: a bar.
    Progress = Union[Callable[[float], object], bool, None]
    #: Calls the long form: from the arguments of the plain one, and the options of the call.
    _Form = Callable[[Tuple[Any, ...], Any], Any]

# `user`, the second argument, is left out: C functions may be passed more than they take, and what receives the call,
# the method send() of a generator, takes one.
_Callback = ctypes.CFUNCTYPE(ctypes.c_int32, ctypes.c_double)


class _CallOptions(ctypes.Structure):
    _fields_ = [("struct_size", ctypes.c_int64), ("work", ctypes.c_int64), ("progress", _Callback),
                ("user", ctypes.c_void_p)]


# --- The callback ---

class _Listener:
    """Who is told, and what went wrong meanwhile: no exception may leave a callback."""

    __slots__ = ("progress", "failure")

    def __init__(self) -> None:
        self.progress: Optional[Callable[[float], object]] = None
        self.failure: Optional[BaseException] = None

    def answer(self, done: float) -> int:
        """1 if the call is to end."""
        if self.progress is None:
            return 0
        try:
            wish = self.progress(done)
            if wish is None or isinstance(wish, (bool, numpy.bool_)):
                return int(wish is not None and not wish)
            raise TypeError(f"progress is to return False to end the call, True or None, not {wish!r}")
        except BaseException as failure:
            self.failure = failure
            return 1


def _listening(listener: _Listener) -> Generator[int, float, None]:
    """Receives the calls. Python runs the handlers of signals when it enters a function, before any `try` in it: what
    they raise, as KeyboardInterrupt, would be lost there. A generator is resumed inside its `try`."""
    answer = 0
    try:
        while True:
            answer = listener.answer((yield answer))
    except GeneratorExit:
        return
    except BaseException as failure:
        # No call and no jump before the answer: another signal would be handled there.
        listener.failure = failure
        yield 1


class _Watch:
    """A callback, and the options that name it."""

    __slots__ = ("listener", "options", "reference")

    def __init__(self) -> None:
        self.listener = _Listener()
        self.options = _CallOptions()
        self.reference = ctypes.byref(self.options)
        call(lib.nurbs_call_options_init, self.reference, ctypes.sizeof(self.options))
        receiver = _listening(self.listener)
        next(receiver)
        self.options.progress = _Callback(receiver.send)


class _Thread(threading.local):
    def __init__(self) -> None:
        #: Those that no call uses; a call that a progress makes takes another one.
        self.free: List[_Watch] = []
        self.handles_signals = threading.current_thread() is threading.main_thread()


_thread = _Thread()


def _run(form: _Form, arguments: Tuple[Any, ...], progress: Optional[Callable[[float], object]], work: int) -> Any:
    """The status of a call; raises what was raised in its callback."""
    free = _thread.free
    try:
        watch = free.pop()
    except IndexError:
        watch = _Watch()
    watch.listener.progress, watch.options.work = progress, work
    status = form(arguments, watch.reference)
    watch.listener.progress = None
    failure = watch.listener.failure
    if failure is None:
        free.append(watch)
        return status
    try:
        raise failure  # the generator may have ended: the watch is not used again
    finally:
        del failure, watch


# --- The forms: where `call` stands, and structs that take the place of many arguments ---

def _last(_plain: Any, long: Any) -> _Form:
    return lambda arguments, options: long(*arguments, options)


def _before_out(_plain: Any, long: Any) -> _Form:
    return lambda arguments, options: long(*arguments[:-1], options, arguments[-1])


class _Query(ctypes.Structure):
    _fields_ = [("struct_size", ctypes.c_int64), ("n", ctypes.c_int64), ("points", ctypes.c_void_p),
                ("point_stride", ctypes.c_int64), ("point_component_stride", ctypes.c_int64),
                ("guesses", ctypes.c_void_p), ("guess_stride", ctypes.c_int64),
                ("guess_component_stride", ctypes.c_int64), ("range", ctypes.c_void_p), ("tolerance", ctypes.c_double),
                ("budget", ctypes.c_int64), ("flags", ctypes.c_uint32), ("reserved", ctypes.c_uint32)]


class _Answer(ctypes.Structure):
    _fields_ = [("struct_size", ctypes.c_int64), ("params", ctypes.c_void_p), ("param_stride", ctypes.c_int64),
                ("param_component_stride", ctypes.c_int64), ("feet", ctypes.c_void_p), ("foot_stride", ctypes.c_int64),
                ("foot_component_stride", ctypes.c_int64), ("distances", ctypes.c_void_p),
                ("distance_stride", ctypes.c_int64), ("status", ctypes.c_void_p)]


class _Constraints(ctypes.Structure):
    _fields_ = [("struct_size", ctypes.c_int64), ("count", ctypes.c_int64), ("kinds", ctypes.c_void_p),
                ("orders", ctypes.c_void_p), ("params", ctypes.c_void_p), ("targets", ctypes.c_void_p),
                ("keep", ctypes.c_void_p), ("costs", ctypes.c_void_p), ("weight_costs", ctypes.c_void_p),
                ("tolerance", ctypes.c_double)]


class _Report(ctypes.Structure):
    _fields_ = [("struct_size", ctypes.c_int64), ("residuals", ctypes.c_void_p), ("rank", ctypes.c_int64),
                ("moved", ctypes.c_double), ("optimality", ctypes.c_double)]


_QUERY, _ANSWER = ctypes.sizeof(_Query), ctypes.sizeof(_Answer)


def _of_structs(called: Callable[[Any, Tuple[Any, ...], Any], Any], *numbers: int) -> Callable[[Any, Any], _Form]:
    """Forms with structs: called(long, arguments, options). Structs would cut off what does not fit their fields: the
    arguments that a user gives as `numbers` are converted before, and where that fails the plain form says so."""
    def made(plain: Any, long: Any) -> _Form:
        kinds = [(place, plain.argtypes[place].from_param) for place in numbers]

        def form(arguments: Tuple[Any, ...], options: Any) -> Any:
            given = list(arguments)
            try:
                for place, converted in kinds:
                    given[place] = converted(given[place]).value
            except Exception:
                return plain(*arguments)
            return called(long, tuple(given), options)

        return form

    return made


def _extremal(long: Any, a: Tuple[Any, ...], options: Any) -> Any:
    query, answer = _Query(_QUERY, *a[1:5], None, 0, 0, *a[5:8], a[17]), _Answer(_ANSWER, *a[8:17])
    return long(a[0], ctypes.byref(query), ctypes.byref(answer), options)


def _local(long: Any, a: Tuple[Any, ...], options: Any) -> Any:
    query, answer = _Query(_QUERY, *a[1:8], flags=a[17]), _Answer(_ANSWER, *a[8:17])
    return long(a[0], ctypes.byref(query), ctypes.byref(answer), options)


def _signed(long: Any, a: Tuple[Any, ...], options: Any) -> Any:
    query = _Query(_QUERY, *a[1:5], None, 0, 0, None, *a[5:7], a[12])
    answer = _Answer(_ANSWER, a[9], a[10], distances=a[7], distance_stride=a[8], status=a[11])
    return long(a[0], ctypes.byref(query), ctypes.byref(answer), options)


def _constrain(long: Any, a: Tuple[Any, ...], options: Any) -> Any:
    wanted, report = _Constraints(ctypes.sizeof(_Constraints), *a[1:10]), _Report(ctypes.sizeof(_Report), a[10])
    status = long(a[0], ctypes.byref(wanted), ctypes.byref(report), options, a[14])
    if status == NURBS_OK:
        for reference, value in zip(a[11:14], (report.rank, report.moved, report.optimality)):
            reference._obj.value = value
    return status


_LONG: List[Tuple[Callable[[Any, Any], _Form], List[Tuple[Any, Any]]]] = [
    (_last, [
        (lib.nurbs_recognize, lib.nurbs_recognize_with),
        (lib.nurbs_closest_all, lib.nurbs_closest_all_with),
        (lib.nurbs_critical_points, lib.nurbs_critical_points_with),
        (lib.nurbs_distance, lib.nurbs_distance_with),
        (lib.nurbs_hausdorff_distance, lib.nurbs_hausdorff_distance_with),
        (lib.nurbs_curve_length, lib.nurbs_curve_length_with),
        (lib.nurbs_curve_lengths, lib.nurbs_curve_lengths_with),
        (lib.nurbs_curve_params_at_lengths, lib.nurbs_curve_params_at_lengths_with),
        (lib.nurbs_curve_divide, lib.nurbs_curve_divide_with),
        (lib.nurbs_surface_area, lib.nurbs_surface_area_with),
        (lib.nurbs_moments, lib.nurbs_moments_with),
        (lib.nurbs_enclosed_area, lib.nurbs_enclosed_area_with),
        (lib.nurbs_enclosed_volume, lib.nurbs_enclosed_volume_with),
        (lib.nurbs_curve_features, lib.nurbs_curve_features_with),
        (lib.nurbs_extrema, lib.nurbs_extrema_with),
        (lib.nurbs_mesh_curve, lib.nurbs_mesh_curve_with),
        (lib.nurbs_fold_test, lib.nurbs_fold_test_with),
        (lib.nurbs_fold_pieces, lib.nurbs_fold_pieces_with),
        (lib.nurbs_roots, lib.nurbs_roots_with),
        (lib.nurbs_curve_level, lib.nurbs_curve_level_with),
        (lib.nurbs_curve_intersections, lib.nurbs_curve_intersections_with),
        (lib.nurbs_curve_surface_intersections, lib.nurbs_curve_surface_intersections_with),
        (lib.nurbs_surfaces_common_points, lib.nurbs_surfaces_common_points_with),
        (lib.nurbs_curve_self_intersections, lib.nurbs_curve_self_intersections_with),
        (lib.nurbs_surface_rays, lib.nurbs_surface_rays_with),
        (lib.nurbs_face_rays, lib.nurbs_face_rays_with),
        (lib.nurbs_face_closest_points, lib.nurbs_face_closest_points_with),
        (lib.nurbs_face_distance, lib.nurbs_face_distance_with),
        (lib.nurbs_face_hausdorff_distance, lib.nurbs_face_hausdorff_distance_with),
        (lib.nurbs_model_closest_points, lib.nurbs_model_closest_points_with),
        (lib.nurbs_model_rays, lib.nurbs_model_rays_with),
        (lib.nurbs_model_ray_hits, lib.nurbs_model_ray_hits_with),
        (lib.nurbs_model_classify, lib.nurbs_model_classify_with),
        (lib.nurbs_model_area, lib.nurbs_model_area_with),
        (lib.nurbs_model_volume, lib.nurbs_model_volume_with),
        (lib.nurbs_fit_errors, lib.nurbs_fit_errors_with),
        (lib.nurbs_fit_criteria, lib.nurbs_fit_criteria_with),
        (lib.nurbs_face_classify, lib.nurbs_face_classify_with),
        (lib.nurbs_face_area, lib.nurbs_face_area_with),
        (lib.nurbs_face_moments, lib.nurbs_face_moments_with),
        (lib.nurbs_face_quadrature, lib.nurbs_face_quadrature_with),
        (lib.nurbs_face_box, lib.nurbs_face_box_with),
        (lib.nurbs_model_write, lib.nurbs_model_write_with),
        (lib.nurbs_model_write_file, lib.nurbs_model_write_file_with),
        (lib.nurbs_list_write, lib.nurbs_list_write_with),
        (lib.nurbs_list_write_file, lib.nurbs_list_write_file_with),
        (lib.nurbs_mesh_write, lib.nurbs_mesh_write_with),
        (lib.nurbs_mesh_write_file, lib.nurbs_mesh_write_file_with),
    ]),
    (_before_out, [
        (lib.nurbs_product, lib.nurbs_product_with),
        (lib.nurbs_compose, lib.nurbs_compose_with),
        (lib.nurbs_statistics_add, lib.nurbs_statistics_add_with),
        (lib.nurbs_fit, lib.nurbs_fit_with),
        (lib.nurbs_fit_points, lib.nurbs_fit_points_with),
        (lib.nurbs_fit_tolerance, lib.nurbs_fit_tolerance_with),
        (lib.nurbs_fit_cloud, lib.nurbs_fit_cloud_with),
        (lib.nurbs_face_create, lib.nurbs_face_create_with),
        (lib.nurbs_surface_sections, lib.nurbs_surface_sections_with),
        (lib.nurbs_surface_contours, lib.nurbs_surface_contours_with),
        (lib.nurbs_surface_reflections, lib.nurbs_surface_reflections_with),
        (lib.nurbs_surface_intersections, lib.nurbs_surface_intersections_with),
        (lib.nurbs_surface_self_intersections, lib.nurbs_surface_self_intersections_with),
        (lib.nurbs_face_intersections, lib.nurbs_face_intersections_with),
        (lib.nurbs_surface_project_curve, lib.nurbs_surface_project_curve_with),
        (lib.nurbs_face_project_curve, lib.nurbs_face_project_curve_with),
        (lib.nurbs_meet_trim, lib.nurbs_meet_trim_with),
        (lib.nurbs_meet_trim_second, lib.nurbs_meet_trim_second_with),
        (lib.nurbs_model_sections, lib.nurbs_model_sections_with),
        (lib.nurbs_model_intersections, lib.nurbs_model_intersections_with),
        (lib.nurbs_mesh_surface, lib.nurbs_mesh_surface_with),
        (lib.nurbs_mesh_face, lib.nurbs_mesh_face_with),
        (lib.nurbs_mesh_model, lib.nurbs_mesh_model_with),
        (lib.nurbs_mesh_surface_levels, lib.nurbs_mesh_surface_levels_with),
        (lib.nurbs_mesh_face_levels, lib.nurbs_mesh_face_levels_with),
        (lib.nurbs_mesh_model_levels, lib.nurbs_mesh_model_levels_with),
        (lib.nurbs_mesh_volume, lib.nurbs_mesh_volume_with),
        (lib.nurbs_surface_level, lib.nurbs_surface_level_with),
        (lib.nurbs_surface_level_curves, lib.nurbs_surface_level_curves_with),
        (lib.nurbs_reduce_knots, lib.nurbs_reduce_knots_with),
        (lib.nurbs_reduce_degree, lib.nurbs_reduce_degree_with),
        (lib.nurbs_simplify, lib.nurbs_simplify_with),
        (lib.nurbs_approximate, lib.nurbs_approximate_with),
        (lib.nurbs_bend, lib.nurbs_bend_with),
        (lib.nurbs_free_form_deform, lib.nurbs_free_form_deform_with),
        (lib.nurbs_fair, lib.nurbs_fair_with),
        (lib.nurbs_read, lib.nurbs_read_with),
        (lib.nurbs_read_file, lib.nurbs_read_file_with),
        (lib.nurbs_model_sew, lib.nurbs_model_sew_with),
        (lib.nurbs_region_create, lib.nurbs_region_create_with),
        (lib.nurbs_region_combine, lib.nurbs_region_combine_with),
        (lib.nurbs_face_split, lib.nurbs_face_split_with),
        (lib.nurbs_face_trim, lib.nurbs_face_trim_with),
        (lib.nurbs_read_model, lib.nurbs_read_model_with),
        (lib.nurbs_read_model_file, lib.nurbs_read_model_file_with),
    ]),
    (_of_structs(_extremal, 6, 7), [
        (lib.nurbs_closest_points, lib.nurbs_closest_points_with),
        (lib.nurbs_farthest_points, lib.nurbs_farthest_points_with),
    ]),
    (_of_structs(_local), [(lib.nurbs_closest_local, lib.nurbs_closest_local_with)]),
    (_of_structs(_signed, 5, 6), [(lib.nurbs_curve_signed_distances, lib.nurbs_curve_signed_distances_with)]),
    (_of_structs(_constrain, 9), [(lib.nurbs_constrain, lib.nurbs_constrain_with)]),
]


# --- What methods call ---

class _Interruptible:
    """A function in its long form, whose callback only lets signals interrupt it. That is of use in the main thread
    alone: in others it would wait for the interpreter every time."""

    __slots__ = ("__name__", "plain", "form")

    def __init__(self, plain: Any, form: _Form) -> None:
        self.__name__ = plain.__name__
        self.plain, self.form = plain, form

    def __call__(self, *arguments: Any) -> Any:
        return _run(self.form, arguments, None, 0) if _thread.handles_signals else self.plain(*arguments)


class _Watched:
    """A function in its long form with the wishes of its user, to whom some number of calls is one."""

    def __init__(self, function: _Interruptible, progress: Progress, work: int, calls: int) -> None:
        self.__name__ = function.__name__
        self._form, self._progress, self._work, self._calls = function.form, progress, work, calls
        self._ended, self._done = 0, 0.0
        self._bar: Optional[Bar] = None

    def __call__(self, *arguments: Any) -> Any:
        status = None
        try:
            status = _run(self._form, arguments, self._tell if self._progress else None, self._work)
        finally:
            self._ended += 1
            if self._bar is not None and (status != NURBS_OK or self._ended >= self._calls):
                self._bar.close(status == NURBS_OK)
                self._bar = None
        return status

    def _tell(self, done: float) -> object:
        # A method may call more often than it expects to, where a first answer does not suffice.
        self._done = max(self._done, min((self._ended + done) / self._calls, 1.0))
        if callable(self._progress):
            return self._progress(self._done)
        if self._bar is None:
            self._bar = new_bar(self.__name__)
        self._bar.show(self._done)
        return True


_FUNCTIONS = {plain.__name__: _Interruptible(plain, form(plain, long)) for form, pairs in _LONG for plain, long in pairs}


_Found = TypeVar("_Found")


def watched(function: Any, progress: Progress, work: Optional[int], calls: int = 1) -> Any:
    """A function of the library to be called with its plain arguments, as many as `calls` times, each with the limit of
    `work`: in its long form, if it is one that has one and that nobody has replaced."""
    long = _FUNCTIONS.get(function.__name__)
    if long is None or long.plain is not function:
        return function
    if progress is None and work is None:
        return long
    if not isinstance(progress, (bool, type(None))) and not callable(progress):
        raise TypeError(f"progress is to be a function, True or None, not {type(progress).__name__}")
    return _Watched(long, progress, 0 if work is None else int64(work), calls)


def listed(result: Callable[..., _Found], arrays: Callable[[int], Sequence[Any]], function: Any,
           *arguments: Any) -> _Found:
    """What function(arguments..., cap, arrays..., count, complete) lists in arrays(count)."""
    count, complete = ctypes.c_int64(), ctypes.c_int32()
    ends = ctypes.byref(count), ctypes.byref(complete)
    call(function, *arguments, 0, *[None] * len(arrays(0)), *ends)
    found = arrays(count.value)
    call(function, *arguments, count.value, *(array.ctypes.data for array in found), *ends)
    return result(*found, bool(complete.value))
