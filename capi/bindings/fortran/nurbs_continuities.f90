! SPDX-License-Identifier: MIT
!> Continuity at knots and between ends. Conventions: see the module nurbs.
module nurbs_continuities
    use, intrinsic :: iso_c_binding
    use nurbs_constants
    use nurbs_c
    use nurbs_support
    use nurbs_splines
    implicit none
    private

    !> How two pieces meet.
    type, public :: spline_continuity
        integer(c_int32_t) :: order = -1, geometric = -1
        real(c_double) :: position_gap = 0, angle = 0, curvature_gap = 0
    end type spline_continuity
    public :: knot_continuity, end_continuity

contains

    !> One entry for each knot inside the domain, and for the seam.
    subroutine knot_continuity(spline, axis, tolerances, knots, knot_orders, found, status)
        class(nurbs_spline), intent(in) :: spline
        integer(c_int32_t), intent(in) :: axis
        real(c_double), intent(in) :: tolerances(3) ! of positions, derivatives and angles
        real(c_double), allocatable, intent(inout) :: knots(:)
        integer(c_int32_t), allocatable, intent(inout) :: knot_orders(:)
        type(spline_continuity), allocatable, intent(inout) :: found(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        n = 0
        code = nurbs_continuity(spline%handle, axis - 1, tolerances(1), tolerances(2), tolerances(3), 0_c_int64_t, &
            count=n)
        if (allocated(knots)) deallocate (knots)
        if (allocated(knot_orders)) deallocate (knot_orders)
        if (allocated(found)) deallocate (found)
        allocate (knots(n), knot_orders(n), found(n))
        block
            integer(c_int32_t) :: orders(n), geometric(n)
            real(c_double) :: gaps(n), angles(n), curvatures(n)
            if (code == NURBS_OK) code = nurbs_continuity(spline%handle, axis - 1, tolerances(1), tolerances(2), &
                tolerances(3), n, knots, knot_orders, orders, geometric, gaps, angles, curvatures)
            if (code == NURBS_OK) then
                found%order = orders
                found%geometric = geometric
                found%position_gap = gaps
                found%angle = angles
                found%curvature_gap = curvatures
            end if
        end block
        call settle(code, status)
    end subroutine knot_continuity

    !> Two curves at one end of each, NURBS_START or NURBS_END.
    subroutine end_continuity(a, end_a, b, end_b, tolerances, found, status)
        class(nurbs_spline), intent(in) :: a, b
        integer(c_int32_t), intent(in) :: end_a, end_b
        real(c_double), intent(in) :: tolerances(3) ! of positions, derivatives and angles
        type(spline_continuity), intent(inout) :: found
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        code = nurbs_continuity_between(a%handle, end_a, b%handle, end_b, tolerances(1), tolerances(2), tolerances(3), &
            found%order, found%geometric, found%position_gap, found%angle, found%curvature_gap)
        call settle(code, status)
    end subroutine end_continuity
end module nurbs_continuities
