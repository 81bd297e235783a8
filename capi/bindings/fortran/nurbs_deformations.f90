! SPDX-License-Identifier: MIT
! Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
!> Deformations of a shape or of a region of it; range(2, axes) is a part of the domain, range(:, k) of domain(k).
!> Conventions: see the module nurbs.
module nurbs_deformations
    use, intrinsic :: iso_c_binding
    use nurbs_constants
    use nurbs_c, only: nurbs_warp, nurbs_flatten, nurbs_bend, nurbs_free_form_deform, nurbs_fair, nurbs_snap_boundary, &
        nurbs_bend_with, nurbs_free_form_deform_with, nurbs_fair_with
    use nurbs_support
    use nurbs_calls
    use nurbs_splines
    implicit none
    private
    public :: warp, flatten, bend, free_form_deform, fair, snap_boundary

contains

    !> A region raised by a distance along a direction(dim); `order` derivatives stay at its ends.
    subroutine warp(g, direction, distance, order, out, range, status)
        class(nurbs_spline), intent(in) :: g
        real(c_double), intent(in) :: direction(:), distance
        integer(c_int32_t), intent(in) :: order
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(in), optional :: range(:, :)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        made = c_null_ptr
        code = fitting([fits(direction, dim_of(g%handle)), fits(range, 2_c_int64_t, axes_of(g%handle))])
        if (code == NURBS_OK) code = nurbs_warp(g%handle, range, direction, distance, order, made)
        call out%replace(made)
        call settle(code, status)
    end subroutine warp

    !> A region flattened to the plane through point(dim) with normal(dim), along a direction or else the normal.
    subroutine flatten(g, point, normal, out, direction, moved, range, status)
        class(nurbs_spline), intent(in) :: g
        real(c_double), intent(in) :: point(:), normal(:)
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(in), optional :: direction(:), range(:, :)
        real(c_double), intent(inout), optional :: moved
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: dim
        type(c_ptr) :: made
        dim = dim_of(g%handle)
        made = c_null_ptr
        code = fitting([fits(point, dim), fits(normal, dim), fits(direction, dim), &
            fits(range, 2_c_int64_t, axes_of(g%handle))])
        if (code == NURBS_OK) code = nurbs_flatten(g%handle, range, point, normal, direction, moved, made)
        call out%replace(made)
        call settle(code, status)
    end subroutine flatten

    !> The part between lower and upper bent about an axis across the plane of along(dim) and across(dim). deviation:
    !> from the exact image, a bound if proven, else of samples.
    subroutine bend(g, origin, along, across, curvature, tolerance, out, lower, upper, deviation, proven, status, call)
        class(nurbs_spline), intent(in) :: g
        real(c_double), intent(in) :: origin(:), along(:), across(:), curvature, tolerance
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(in), optional :: lower, upper
        real(c_double), intent(inout), optional :: deviation
        logical, intent(inout), optional :: proven
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code, answer
        integer(c_int64_t) :: dim
        type(c_ptr) :: made
        dim = dim_of(g%handle)
        answer = 0
        made = c_null_ptr
        code = fitting([fits(origin, dim), fits(along, dim), fits(across, dim)])
        if (code == NURBS_OK) then
            if (present(call)) then
                code = nurbs_bend_with(g%handle, origin, along, across, curvature, given(lower, -infinity()), &
                    given(upper, infinity()), tolerance, deviation, answer, watched(call), made)
            else
                code = nurbs_bend(g%handle, origin, along, across, curvature, given(lower, -infinity()), &
                    given(upper, infinity()), tolerance, deviation, answer, made)
            end if
        end if
        if (present(proven)) proven = answer /= 0
        call out%replace(made)
        call settle(code, status)
    end subroutine bend

    !> A shape in the box from lower(m) to upper(m) mapped by a volume of m axes.
    subroutine free_form_deform(g, volume, lower, upper, tolerance, out, deviation, proven, status, call)
        class(nurbs_spline), intent(in) :: g, volume
        real(c_double), intent(in) :: lower(:), upper(:), tolerance
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(inout), optional :: deviation
        logical, intent(inout), optional :: proven
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code, answer
        integer(c_int64_t) :: axes_volume
        type(c_ptr) :: made
        axes_volume = axes_of(volume%handle)
        answer = 0
        made = c_null_ptr
        code = fitting([fits(lower, axes_volume), fits(upper, axes_volume)])
        if (code == NURBS_OK) then
            if (present(call)) then
                code = nurbs_free_form_deform_with(g%handle, volume%handle, lower, upper, tolerance, deviation, &
                    answer, watched(call), made)
            else
                code = nurbs_free_form_deform(g%handle, volume%handle, lower, upper, tolerance, deviation, answer, made)
            end if
        end if
        if (present(proven)) proven = answer /= 0
        call out%replace(made)
        call settle(code, status)
    end subroutine free_form_deform

    !> Small energy within a tolerance: order 1 (membrane), 2 (thin plate) or 3. keep(1, k) and keep(2, k): order of the
    !> derivatives that stay at the start and end of axis k, absent: positions; energies: before and after.
    subroutine fair(g, order, tolerance, out, keep, energies, bound, status, call)
        class(nurbs_spline), intent(in) :: g
        integer(c_int32_t), intent(in) :: order
        real(c_double), intent(in) :: tolerance
        type(nurbs_spline), intent(inout) :: out
        integer(c_int32_t), intent(in), optional :: keep(:, :)
        real(c_double), intent(inout), optional :: energies(2), bound
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        made = c_null_ptr
        code = fitting([fits(keep, 2_c_int64_t, axes_of(g%handle))])
        if (code == NURBS_OK) then
            if (present(call)) then
                code = nurbs_fair_with(g%handle, order, keep, tolerance, energies, bound, watched(call), made)
            else
                code = nurbs_fair(g%handle, order, keep, tolerance, energies, bound, made)
            end if
        end if
        call out%replace(made)
        call settle(code, status)
    end subroutine fair

    !> The boundary at an end, NURBS_START or NURBS_END, of an axis moved onto one of another spline, with order 1
    !> tangents too; flags: 0 or NURBS_REVERSED.
    subroutine snap_boundary(g, axis, end, other, other_axis, other_end, out, order, flags, bound, status)
        class(nurbs_spline), intent(in) :: g, other
        integer(c_int32_t), intent(in) :: axis, end, other_axis, other_end
        type(nurbs_spline), intent(inout) :: out
        integer(c_int32_t), intent(in), optional :: order, flags
        real(c_double), intent(inout), optional :: bound
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        code = nurbs_snap_boundary(g%handle, axis - 1, end, other%handle, other_axis - 1, other_end, given(order, 0), &
            given(flags, 0), bound, made)
        call out%replace(made)
        call settle(code, status)
    end subroutine snap_boundary
end module nurbs_deformations
