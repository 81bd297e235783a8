! SPDX-License-Identifier: MIT
!> Recognition of shapes. Conventions: see the module nurbs.
module nurbs_recognition
    use, intrinsic :: iso_c_binding
    use nurbs_constants
    use nurbs_c
    use nurbs_support
    use nurbs_splines
    implicit none
    private
    public :: recognize_spline

    !> A NURBS_SHAPE_ constant, its placement and sizes, and a proven bound of the distance from it.
    type, public :: recognized_shape
        integer(c_int32_t) :: shape = NURBS_SHAPE_NONE
        real(c_double) :: origin(3) = 0, axis(3) = 0, x(3) = 0
        real(c_double) :: sizes(3) = 0
        real(c_double) :: deviation = 0
    end type recognized_shape

contains

    !> The first shape of the list of nurbs_recognize() from which no point is farther than the tolerance.
    subroutine recognize_spline(g, tolerance, found, status)
        class(nurbs_spline), intent(in) :: g
        real(c_double), intent(in) :: tolerance
        type(recognized_shape), intent(inout) :: found
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        real(c_double) :: placement(3, 3)
        code = nurbs_recognize(g%handle, tolerance, found%shape, placement, found%sizes, found%deviation)
        if (code == NURBS_OK) then
            found%origin = placement(:, 1)
            found%axis = placement(:, 2)
            found%x = placement(:, 3)
        end if
        call settle(code, status)
    end subroutine recognize_spline
end module nurbs_recognition
