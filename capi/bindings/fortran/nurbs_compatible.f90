! SPDX-License-Identifier: MIT
! Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
!> Near-equal knots made equal, and sets of splines brought to one form. Conventions: see the module nurbs.
module nurbs_compatible
    use, intrinsic :: iso_c_binding
    use nurbs_constants
    use nurbs_c, only: nurbs_snap_knots, nurbs_make_compatible
    use nurbs_support
    use nurbs_handles
    use nurbs_splines
    use nurbs_lists
    implicit none
    private
    public :: snap_spline_knots, make_splines_compatible

contains

    !> deviation: a proved bound of how far the shape moved.
    subroutine snap_spline_knots(spline, axis, tolerance, out, deviation, status)
        class(nurbs_spline), intent(in) :: spline
        integer(c_int32_t), intent(in) :: axis
        real(c_double), intent(in) :: tolerance
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(inout), optional :: deviation
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        code = nurbs_snap_knots(spline%handle, axis - 1, tolerance, deviation, made)
        call out%replace(made)
        call settle(code, status)
    end subroutine snap_spline_knots

    !> Splines brought to one degree, domain and knot vector on every axis.
    subroutine make_splines_compatible(splines, list, tolerance, flags, deviation, status)
        type(nurbs_spline), intent(in) :: splines(:)
        type(nurbs_list), intent(inout) :: list
        real(c_double), intent(in), optional :: tolerance
        integer(c_int32_t), intent(in), optional :: flags
        real(c_double), intent(inout), optional :: deviation
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        code = nurbs_make_compatible(size(splines, kind=c_int64_t), handles_of(splines), given(tolerance, 0d0), &
            given(flags, 0), deviation, made)
        call list%replace(made)
        call settle(code, status)
    end subroutine make_splines_compatible
end module nurbs_compatible
