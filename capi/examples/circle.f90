! SPDX-License-Identifier: MIT
! A circle is a rational curve: its points and tangents, a knot more, the point that is closest to another, its
! length, and what a bad call says. With CMake: find_package(nurbs COMPONENTS Fortran), and link nurbs::fortran.
program circle
    use, intrinsic :: iso_c_binding, only: c_double, c_int32_t
    use nurbs
    implicit none
    type(nurbs_spline) :: curve, finer
    real(c_double) :: t(1000), c(1000, 2, 2), after(1000, 2), foot(1, 2), distance(1), length, error
    integer(c_int32_t) :: i, found(1), status

    t = [(i / 999d0, i=0, 999)]
    call create_circle(curve, 1d0)
    call curve%eval_derivs(1, t, c) ! the points are c(:, :, 1), the derivatives c(:, :, 2)
    call curve%insert_knot(1, 0.3d0, 2, finer)
    call finer%eval(t, after)
    call report(curve, c(:, :, 1))
    print '(a, es8.1)', 'tangents at right angles to within', maxval(abs(sum(c(:, :, 1) * c(:, :, 2), 2)))
    call report(finer, after)
    print '(a, es8.1)', 'the points moved by at most', maxval(abs(after - c(:, :, 1)))
    call closest_points(curve, reshape([3d0, 4d0], [1, 2]), feet=foot, distances=distance, states=found)
    print '(3(a, f8.6), 2a)', 'closest to (3, 4): (', foot(1, 1), ', ', foot(1, 2), '), distance ', distance, ', ', &
        trim(merge('certified    ', 'not certified', iand(found(1), NURBS_CLOSEST_CERTIFIED) /= 0))
    call curve_length(curve, length, error)
    print '(a, f14.12, a, es8.1)', 'length ', length, ', error about', error
    call curve%eval([2d0], foot, status=status)
    if (status /= NURBS_OK) print '(2a)', 'a bad call says: ', nurbs_message()

contains

    subroutine report(curve, points)
        type(nurbs_spline), intent(in) :: curve
        real(c_double), intent(in) :: points(:, :)
        print '(i0, a, es8.1)', curve%count(1), ' control points, radius 1 to within', &
            maxval(abs(hypot(points(:, 1), points(:, 2)) - 1))
    end subroutine report
end program circle
