! SPDX-License-Identifier: MIT
! What the tests of the Fortran binding share: counted failures, comparison of values, points of splines.
module expectations
    use, intrinsic :: iso_c_binding
    use nurbs
    implicit none
    private
    public :: expect, finish, near, at, on

    real(c_double), parameter, public :: eps = epsilon(1.0_c_double), pi = acos(-1.0_c_double)
    integer :: failures = 0

contains

    subroutine expect(condition, what)
        logical, intent(in) :: condition
        character(len=*), intent(in) :: what
        if (condition) return
        print '(2a)', 'failed: ', what
        failures = failures + 1
    end subroutine expect

    !> The end of a test.
    subroutine finish()
        if (failures > 0) error stop 'failures, see above'
    end subroutine finish

    !> Whether the values are those expected, to within 1e-12 unless given.
    logical function near(a, b, by)
        real(c_double), intent(in) :: a(:), b(:)
        real(c_double), intent(in), optional :: by
        real(c_double) :: allowed
        allowed = 1e-12_c_double
        if (present(by)) allowed = by
        near = size(a) == size(b)
        if (near) near = all(abs(a - b) <= allowed)
    end function near

    !> Whether the point at the parameters is the expected one, to within 1e-14 unless given.
    logical function at(g, params, expected, by)
        type(nurbs_spline), intent(in) :: g
        real(c_double), intent(in) :: params(:), expected(:)
        real(c_double), intent(in), optional :: by
        real(c_double) :: point(1, size(expected)), allowed
        allowed = 1e-14_c_double
        if (present(by)) allowed = by
        call g%eval(reshape(params, [1, size(params)]), point)
        at = near(point(1, :), expected, allowed)
    end function at

    !> The same on a curve.
    logical function on(g, param, expected, by)
        type(nurbs_spline), intent(in) :: g
        real(c_double), intent(in) :: param, expected(:)
        real(c_double), intent(in), optional :: by
        on = at(g, [param], expected, by)
    end function on
end module expectations
