! SPDX-License-Identifier: MIT
! A circle is a rational curve: create it, evaluate a batch, insert a knot, and see that the radius did not change.
! Compile the modules of bindings/fortran, in the order that nurbs.f90 states, then this; link with -lnurbs.
program circle
    use, intrinsic :: iso_c_binding, only: c_double
    use nurbs
    implicit none
    type(nurbs_spline) :: curve, finer
    real(c_double) :: points(9, 2), weights(9)
    real(c_double), parameter :: knots(12) = [0d0, 0d0, 0d0, 0.25d0, 0.25d0, 0.5d0, 0.5d0, 0.75d0, 0.75d0, &
                                              1d0, 1d0, 1d0]

    points(:, 1) = [1, 1, 0, -1, -1, -1, 0, 1, 1]
    points(:, 2) = [0, 1, 1, 1, 0, -1, -1, -1, 0]
    weights = 1
    weights(2:8:2) = sqrt(0.5d0)
    call curve%create([2], [9], knots, points, weights)
    call curve%insert_knot(1, 0.3d0, 2, finer)
    call report(curve)
    call report(finer)

contains

    ! The largest distance of 1000 points of the curve from the unit circle.
    subroutine report(curve)
        type(nurbs_spline), intent(in) :: curve
        real(c_double) :: params(1000), points(1000, 2)
        integer :: i
        params = [(i / 999d0, i=0, 999)]
        call curve%eval(params, points)
        print '(i0, a, es8.1)', curve%count(1), ' control points, radius 1 to within', &
            maxval(abs(hypot(points(:, 1), points(:, 2)) - 1))
    end subroutine report
end program circle
