! SPDX-License-Identifier: MIT
! Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
!> Operations that move the shape, each with a proven bound. Conventions: see the module nurbs.
module nurbs_reduction
    use, intrinsic :: iso_c_binding
    use nurbs_constants
    use nurbs_c, only: nurbs_deviation, nurbs_remove_knot, nurbs_reduce_knots, nurbs_reduce_degree, nurbs_simplify, &
        nurbs_approximate, nurbs_reduce_knots_with, nurbs_reduce_degree_with, nurbs_simplify_with, &
        nurbs_approximate_with
    use nurbs_support
    use nurbs_calls
    use nurbs_splines
    implicit none
    private
    public :: deviation, remove_knot, reduce_knots, reduce_degree, simplify, approximate

contains

    !> Proven bounds of the largest distance of two splines over the same domain.
    subroutine deviation(f, g, at_least, at_most, status)
        class(nurbs_spline), intent(in) :: f, g
        real(c_double), intent(inout), optional :: at_least, at_most
        integer(c_int32_t), intent(out), optional :: status
        call settle(nurbs_deviation(f%handle, g%handle, at_least, at_most), status)
    end subroutine deviation

    !> Copies of a knot removed, as many as the tolerance allows.
    subroutine remove_knot(g, axis, knot, times, tolerance, out, removed, bound, status)
        class(nurbs_spline), intent(in) :: g
        integer(c_int32_t), intent(in) :: axis, times
        real(c_double), intent(in) :: knot, tolerance
        type(nurbs_spline), intent(inout) :: out
        integer(c_int32_t), intent(inout), optional :: removed
        real(c_double), intent(inout), optional :: bound
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        code = nurbs_remove_knot(g%handle, axis - 1, knot, times, tolerance, removed, bound, made)
        call out%replace(made)
        call settle(code, status)
    end subroutine remove_knot

    !> As few knots as the tolerance allows, on one axis or on every one (0).
    subroutine reduce_knots(g, axis, tolerance, out, bound, status, call)
        class(nurbs_spline), intent(in) :: g
        integer(c_int32_t), intent(in) :: axis
        real(c_double), intent(in) :: tolerance
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(inout), optional :: bound
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        if (present(call)) then
            code = nurbs_reduce_knots_with(g%handle, axis - 1, tolerance, bound, watched(call), made)
        else
            code = nurbs_reduce_knots(g%handle, axis - 1, tolerance, bound, made)
        end if
        call out%replace(made)
        call settle(code, status)
    end subroutine reduce_knots

    !> The closest spline of lower degree.
    subroutine reduce_degree(g, axis, times, out, bound, status, call)
        class(nurbs_spline), intent(in) :: g
        integer(c_int32_t), intent(in) :: axis, times
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(inout), optional :: bound
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        if (present(call)) then
            code = nurbs_reduce_degree_with(g%handle, axis - 1, times, bound, watched(call), made)
        else
            code = nurbs_reduce_degree(g%handle, axis - 1, times, bound, made)
        end if
        call out%replace(made)
        call settle(code, status)
    end subroutine reduce_degree

    !> The simplest spline within the tolerance.
    subroutine simplify(g, tolerance, out, bound, status, call)
        class(nurbs_spline), intent(in) :: g
        real(c_double), intent(in) :: tolerance
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(inout), optional :: bound
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        if (present(call)) then
            code = nurbs_simplify_with(g%handle, tolerance, bound, watched(call), made)
        else
            code = nurbs_simplify(g%handle, tolerance, bound, made)
        end if
        call out%replace(made)
        call settle(code, status)
    end subroutine simplify

    !> A polynomial spline of given degrees with few control points, proven to be within the tolerance.
    subroutine approximate(g, tolerance, out, degrees, max_count, bound, status, call)
        class(nurbs_spline), intent(in) :: g
        real(c_double), intent(in) :: tolerance
        type(nurbs_spline), intent(inout) :: out
        integer(c_int32_t), intent(in), optional :: degrees(:), max_count
        real(c_double), intent(inout), optional :: bound
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        made = c_null_ptr
        code = fitting([fits(degrees, axes_of(g%handle))])
        if (code == NURBS_OK) then
            if (present(call)) then
                code = nurbs_approximate_with(g%handle, degrees, tolerance, int(given(max_count, 0), c_int64_t), &
                    bound, watched(call), made)
            else
                code = nurbs_approximate(g%handle, degrees, tolerance, int(given(max_count, 0), c_int64_t), bound, made)
            end if
        end if
        call out%replace(made)
        call settle(code, status)
    end subroutine approximate
end module nurbs_reduction
