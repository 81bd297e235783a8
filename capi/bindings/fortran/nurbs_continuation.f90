! SPDX-License-Identifier: MIT
! Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
!> Splines beyond their ends: extension, unclamped and periodic forms. Conventions: see the module nurbs.
module nurbs_continuation
    use, intrinsic :: iso_c_binding
    use nurbs_constants
    use nurbs_c, only: nurbs_extend, nurbs_unclamp, nurbs_make_periodic, nurbs_detect_periodic
    use nurbs_support
    use nurbs_splines
    implicit none
    private
    public :: extend_spline, unclamp_spline, make_spline_periodic, detect_periodic

contains

    !> The end is NURBS_START or NURBS_END.
    subroutine extend_spline(spline, axis, end, amount, order, out, status)
        class(nurbs_spline), intent(in) :: spline
        integer(c_int32_t), intent(in) :: axis, end, order
        real(c_double), intent(in) :: amount
        type(nurbs_spline), intent(inout) :: out
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        code = nurbs_extend(spline%handle, axis - 1, end, amount, order, made)
        call out%replace(made)
        call settle(code, status)
    end subroutine extend_spline

    !> Without flags both ends are unclamped; NURBS_HOMOGENEOUS allows weights of any sign.
    subroutine unclamp_spline(spline, axis, out, flags, status)
        class(nurbs_spline), intent(in) :: spline
        integer(c_int32_t), intent(in) :: axis
        type(nurbs_spline), intent(inout) :: out
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        code = nurbs_unclamp(spline%handle, axis - 1, given(flags, &
            ior(NURBS_FORM_CLAMPED_START, NURBS_FORM_CLAMPED_END)), made)
        call out%replace(made)
        call settle(code, status)
    end subroutine unclamp_spline

    !> deviation: a proved bound of how far the shape moved; order: that of the seam.
    subroutine make_spline_periodic(spline, axis, tolerance, out, deviation, order, status)
        class(nurbs_spline), intent(in) :: spline
        integer(c_int32_t), intent(in) :: axis
        real(c_double), intent(in) :: tolerance
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(inout), optional :: deviation
        integer(c_int32_t), intent(inout), optional :: order
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        code = nurbs_make_periodic(spline%handle, axis - 1, tolerance, deviation, order, made)
        call out%replace(made)
        call settle(code, status)
    end subroutine make_spline_periodic

    !> Whether the axis is periodic in fact.
    logical function detect_periodic(spline, axis, status) result(value)
        class(nurbs_spline), intent(in) :: spline
        integer(c_int32_t), intent(in) :: axis
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: answer
        answer = 0
        call settle(nurbs_detect_periodic(spline%handle, axis - 1, answer), status)
        value = answer /= 0
    end function detect_periodic
end module nurbs_continuation
