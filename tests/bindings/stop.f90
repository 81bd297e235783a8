! SPDX-License-Identifier: MIT
! A failing call without a status: ends the program, and does not come back.
program stop_at_failure
    use, intrinsic :: iso_c_binding, only: c_double
    use nurbs
    implicit none
    type(nurbs_spline) :: line
    real(c_double) :: points(1, 1)
    call line%create_bezier([1], reshape([0d0, 1d0], [2, 1]))
    call line%eval([2d0], points)
    print '(a)', 'not reached'
end program stop_at_failure
