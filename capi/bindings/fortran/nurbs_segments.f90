! SPDX-License-Identifier: MIT
!> Hermite data and the power basis of pieces, and changes of basis. Conventions: see the module nurbs.
module nurbs_segments
    use, intrinsic :: iso_c_binding
    use nurbs_constants
    use nurbs_c
    use nurbs_support
    use nurbs_splines
    implicit none
    private
    public :: create_hermite_spline, hermite_data, power_form, create_power_spline, basis_matrix

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

    !> params(n), points(n, dim) and tangents(n, dim) of a piecewise cubic, as create_hermite_spline() takes them.
    subroutine hermite_data(g, params, points, tangents, status)
        type(nurbs_spline), intent(in) :: g
        real(c_double), allocatable, intent(inout) :: params(:), points(:, :), tangents(:, :)
        integer(c_int32_t), intent(out), optional :: status
        real(c_double), allocatable :: t(:), p(:, :), v(:, :)
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        code = nurbs_to_hermite(g%handle, 0_c_int64_t, count=n)
        if (code == NURBS_OK) then
            allocate (t(n), p(dim_of(g%handle), n), v(dim_of(g%handle), n))
            code = nurbs_to_hermite(g%handle, n, t, p, v)
            params = t
            points = transpose(p)
            tangents = transpose(v)
        end if
        call settle(code, status)
    end subroutine hermite_data

    !> The power basis of all pieces: coefficients(width, n), the powers of the last axis fastest, then those of the
    !> others, then the pieces in the same manner; breaks of the axes one after the other; pieces along each axis.
    subroutine power_form(g, coefficients, breaks, piece_counts, status)
        type(nurbs_spline), intent(in) :: g
        real(c_double), allocatable, intent(inout) :: coefficients(:, :), breaks(:)
        integer(c_int64_t), allocatable, intent(inout) :: piece_counts(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code, axes, rational
        integer(c_int64_t) :: n, pieces(NURBS_MAX_AXES)
        integer :: width
        pieces = 0
        code = nurbs_to_power(g%handle, 0_c_int64_t, piece_counts=pieces, count=n)
        if (code == NURBS_OK) code = nurbs_axes(g%handle, axes)
        if (code == NURBS_OK) code = nurbs_is_rational(g%handle, rational)
        if (code == NURBS_OK) then
            width = dim_of(g%handle) + rational
            if (allocated(coefficients)) deallocate (coefficients)
            if (allocated(breaks)) deallocate (breaks)
            allocate (coefficients(width, n / width), breaks(sum(pieces) + axes))
            piece_counts = pieces(:axes)
            code = nurbs_to_power(g%handle, n, coefficients, breaks)
        end if
        call settle(code, status)
    end subroutine power_form

    !> The spline of the pieces that power_form() gives; flags: NURBS_HOMOGENEOUS.
    subroutine create_power_spline(out, degrees, piece_counts, breaks, coefficients, flags, status)
        type(nurbs_spline), intent(inout) :: out
        integer(c_int32_t), intent(in) :: degrees(:)
        integer(c_int64_t), intent(in) :: piece_counts(:)
        real(c_double), intent(in) :: breaks(:), coefficients(:, :)
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code, bits, dim
        type(c_ptr) :: made
        made = c_null_ptr
        code = NURBS_OK
        bits = 0
        if (present(flags)) bits = flags
        dim = size(coefficients, 1)
        if (iand(bits, NURBS_HOMOGENEOUS) /= 0) dim = dim - 1
        if (size(piece_counts) /= size(degrees)) code = shape_error
        if (size(coefficients, 2, c_int64_t) /= product((degrees + 1_c_int64_t) * piece_counts)) code = shape_error
        if (code == NURBS_OK) code = nurbs_create_power(size(degrees), degrees, piece_counts, breaks, &
            size(breaks, kind=c_int64_t), dim, coefficients, 0_c_int64_t, 0_c_int64_t, bits, made)
        call out%replace(made)
        call settle(code, status)
    end subroutine create_power_spline

    !> coefficients(to) = matmul(matrix, coefficients(from)) at degree size(matrix, 1) - 1.
    subroutine basis_matrix(from, to, matrix, status)
        integer(c_int32_t), intent(in) :: from, to
        real(c_double), intent(inout) :: matrix(:, :)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        real(c_double), allocatable :: rows(:, :)
        code = NURBS_OK
        if (size(matrix, 1) /= size(matrix, 2)) code = shape_error
        allocate (rows(size(matrix, 1), size(matrix, 1)))
        if (code == NURBS_OK) code = nurbs_basis_matrix(from, to, size(matrix, 1) - 1, size(rows, kind=c_int64_t), rows)
        if (code == NURBS_OK) matrix = transpose(rows)
        call settle(code, status)
    end subroutine basis_matrix
end module nurbs_segments
