! SPDX-License-Identifier: MIT
!> Hermite data. Conventions: see the module nurbs; nurbs_basis_matrix() is called by its own name, and gives the
!> matrix by rows.
module nurbs_segments
    use, intrinsic :: iso_c_binding
    use nurbs_constants
    use nurbs_c
    use nurbs_support
    use nurbs_splines
    implicit none
    private
    public :: create_hermite_spline

contains

    !> points(n, dim) and tangents(n, dim) at params(n).
    subroutine create_hermite_spline(out, params, points, tangents, status)
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(in) :: params(:), points(:, :), tangents(:, :)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        made = c_null_ptr
        code = NURBS_OK
        if (size(points, 1) /= size(params) .or. any(shape(tangents) /= shape(points))) code = shape_error
        if (code == NURBS_OK) code = nurbs_create_hermite(size(params, kind=c_int64_t), params, size(points, 2), points, &
            step(points), column(points), tangents, step(tangents), column(tangents), made)
        call out%replace(made)
        call settle(code, status)
    end subroutine create_hermite_spline
end module nurbs_segments
