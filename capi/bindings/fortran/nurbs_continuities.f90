! SPDX-License-Identifier: MIT
! Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
!> Continuity at knots and between ends. Conventions: see the module nurbs.
module nurbs_continuities
    use, intrinsic :: iso_c_binding
    use nurbs_constants
    use nurbs_c, only: nurbs_continuity, nurbs_continuity_between
    use nurbs_support
    use nurbs_splines
    implicit none
    private
    public :: knot_continuity, end_continuity

    !> How two pieces meet.
    type, public :: spline_continuity
        integer(c_int32_t) :: order = -1 ! Of the derivatives
        integer(c_int32_t) :: geometric = -1 ! Of the shape
        real(c_double) :: position_gap = 0d0 ! The distance of the points
        real(c_double) :: angle = 0d0 ! The angle between the tangents or normals
        real(c_double) :: curvature_gap = 0d0 ! The difference of the curvatures
    end type spline_continuity

contains

    !> One entry for each knot inside the domain, and for the seam. tolerances: of positions, derivatives and angles.
    subroutine knot_continuity(spline, axis, tolerances, knots, knot_orders, found, status)
        class(nurbs_spline), intent(in) :: spline
        integer(c_int32_t), intent(in) :: axis
        real(c_double), intent(in) :: tolerances(3)
        real(c_double), allocatable, intent(inout) :: knots(:)
        integer(c_int32_t), allocatable, intent(inout) :: knot_orders(:)
        type(spline_continuity), allocatable, intent(inout) :: found(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        integer(c_int32_t), allocatable :: orders_c(:), geometric_orders_c(:)
        real(c_double), allocatable :: position_gaps_c(:), angles_c(:), curvature_gaps_c(:)
        n = 0
        code = nurbs_continuity(spline%handle, axis - 1, tolerances(1), tolerances(2), tolerances(3), 0_c_int64_t, &
            count=n)
        if (allocated(knots)) deallocate (knots)
        if (allocated(knot_orders)) deallocate (knot_orders)
        if (allocated(found)) deallocate (found)
        allocate (knots(n), knot_orders(n), orders_c(n), geometric_orders_c(n), position_gaps_c(n), angles_c(n), &
            curvature_gaps_c(n), found(n))
        if (code == NURBS_OK) code = nurbs_continuity(spline%handle, axis - 1, tolerances(1), tolerances(2), &
            tolerances(3), n, knots, knot_orders, orders_c, geometric_orders_c, position_gaps_c, angles_c, &
            curvature_gaps_c)
        if (code == NURBS_OK) then
            found%order = orders_c
            found%geometric = geometric_orders_c
            found%position_gap = position_gaps_c
            found%angle = angles_c
            found%curvature_gap = curvature_gaps_c
        end if
        call settle(code, status)
    end subroutine knot_continuity

    !> Two curves at one end of each, NURBS_START or NURBS_END. tolerances: of positions, derivatives and angles.
    subroutine end_continuity(a, end_a, b, end_b, tolerances, found, status)
        class(nurbs_spline), intent(in) :: a, b
        integer(c_int32_t), intent(in) :: end_a, end_b
        real(c_double), intent(in) :: tolerances(3)
        type(spline_continuity), intent(inout) :: found
        integer(c_int32_t), intent(out), optional :: status
        call settle(nurbs_continuity_between(a%handle, end_a, b%handle, end_b, tolerances(1), tolerances(2), &
            tolerances(3), found%order, found%geometric, found%position_gap, found%angle, found%curvature_gap), status)
    end subroutine end_continuity
end module nurbs_continuities
