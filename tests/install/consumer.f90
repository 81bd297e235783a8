! SPDX-License-Identifier: MIT
! A program that knows the library by its package only.
program consumer
    use, intrinsic :: iso_c_binding, only: c_double
    use nurbs
    implicit none
    type(nurbs_spline) :: line
    real(c_double) :: point(1, 2)
    if (nurbs_version() /= NURBS_HEADER_VERSION) error stop 'another version than the modules'
    call create_line(line, [0d0, 0d0], [2d0, 4d0])
    call line%eval([0.5d0], point)
    if (any(abs(point(1, :) - [1d0, 2d0]) > 0)) error stop 'another point than the middle'
end program consumer
