! SPDX-License-Identifier: MIT
! Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
!> Recognition of shapes. Conventions: see the module nurbs.
module nurbs_recognition
    use, intrinsic :: iso_c_binding
    use nurbs_constants
    use nurbs_c, only: nurbs_recognize, nurbs_recognize_with
    use nurbs_support
    use nurbs_calls
    use nurbs_splines
    implicit none
    private
    public :: recognize_spline

    !> A shape, its placement and sizes as nurbs_recognize() describes them, and a proven bound of the distance from it.
    type, public :: recognized_shape
        integer(c_int32_t) :: shape = 0 ! One of the NURBS_SHAPE_ constants
        real(c_double) :: origin(3) = 0d0 ! Centre, vertex, apex or another point
        real(c_double) :: axis(3) = 0d0 ! Normal or axis
        real(c_double) :: x(3) = 0d0 ! The direction where angles start
        real(c_double) :: sizes(3) = 0d0 ! Radii, semi-axes, a focal length or half an opening angle
        real(c_double) :: deviation = 0d0 ! A proven bound of the distance from it
    end type recognized_shape

contains

    !> The first shape of the list of nurbs_recognize() from which no point is farther than the tolerance.
    subroutine recognize_spline(g, tolerance, found, status, call)
        class(nurbs_spline), intent(in) :: g
        real(c_double), intent(in) :: tolerance
        type(recognized_shape), intent(inout) :: found
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        real(c_double) :: placement_c(9)
        if (present(call)) then
            code = nurbs_recognize_with(g%handle, tolerance, found%shape, placement_c, found%sizes, found%deviation, &
                watched(call))
        else
            code = nurbs_recognize(g%handle, tolerance, found%shape, placement_c, found%sizes, found%deviation)
        end if
        if (code == NURBS_OK) then
            found%origin = placement_c(1:3)
            found%axis = placement_c(4:6)
            found%x = placement_c(7:9)
        end if
        call settle(code, status)
    end subroutine recognize_spline
end module nurbs_recognition
