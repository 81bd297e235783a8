! SPDX-License-Identifier: MIT
! Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
!> Hermite data and the power basis of pieces, and changes of basis. Conventions: see the module nurbs.
module nurbs_segments
    use, intrinsic :: iso_c_binding
    use nurbs_constants
    use nurbs_c, only: nurbs_create_hermite, nurbs_to_hermite, nurbs_to_power, nurbs_create_power, nurbs_basis_matrix
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
        integer(c_int64_t) :: n, dim
        type(c_ptr) :: made
        n = size(params, kind=c_int64_t)
        dim = size(points, 2, c_int64_t)
        made = c_null_ptr
        code = fitting([fits(points, n, dim), fits(tangents, n, dim)])
        if (code == NURBS_OK) code = nurbs_create_hermite(n, params, int(dim), points, step(points), column(points), &
            tangents, step(tangents), column(tangents), made)
        call out%replace(made)
        call settle(code, status)
    end subroutine create_hermite_spline

    !> params(n), points(n, dim) and tangents(n, dim) of a piecewise cubic, as create_hermite_spline() takes them.
    subroutine hermite_data(g, params, points, tangents, status)
        class(nurbs_spline), intent(in) :: g
        real(c_double), allocatable, intent(inout) :: params(:), points(:, :), tangents(:, :)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: dim, n
        real(c_double), allocatable :: points_c(:, :), tangents_c(:, :)
        dim = dim_of(g%handle)
        n = 0
        code = nurbs_to_hermite(g%handle, 0_c_int64_t, count=n)
        if (code == NURBS_OK) then
            if (allocated(params)) deallocate (params)
            allocate (params(n), points_c(dim, n), tangents_c(dim, n))
            code = nurbs_to_hermite(g%handle, n, params, points_c, tangents_c)
        end if
        if (code == NURBS_OK) then
            points = transpose(points_c)
            tangents = transpose(tangents_c)
        end if
        call settle(code, status)
    end subroutine hermite_data

    !> The power basis of all pieces: coefficients(width, n), the powers of the last axis fastest, then those of the
    !> others, then the pieces in the same manner; breaks of the axes one after the other; pieces along each axis.
    subroutine power_form(g, coefficients, breaks, piece_counts, status)
        class(nurbs_spline), intent(in) :: g
        real(c_double), allocatable, intent(inout) :: coefficients(:, :), breaks(:)
        integer(c_int64_t), allocatable, intent(inout) :: piece_counts(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: axes, n
        integer(c_int64_t), allocatable :: piece_counts_c(:)
        axes = axes_of(g%handle)
        allocate (piece_counts_c(axes))
        n = 0
        code = nurbs_to_power(g%handle, 0_c_int64_t, piece_counts=piece_counts_c, count=n)
        if (code == NURBS_OK) then
            if (allocated(coefficients)) deallocate (coefficients)
            if (allocated(breaks)) deallocate (breaks)
            allocate (coefficients(dim_of(g%handle) + rational_of(g%handle), product(piece_counts_c) * &
                active_of(g%handle)), breaks(sum(piece_counts_c) + axes))
            code = nurbs_to_power(g%handle, n, coefficients, breaks)
        end if
        if (code == NURBS_OK) piece_counts = piece_counts_c
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
        integer(c_int32_t) :: code
        integer(c_int64_t) :: axes, dim
        type(c_ptr) :: made
        axes = size(degrees, kind=c_int64_t)
        dim = size(coefficients, 1, c_int64_t) - homogeneous(given(flags, 0))
        made = c_null_ptr
        code = fitting([fits(piece_counts, axes), fits(coefficients, dim + homogeneous(given(flags, 0)), &
            product(piece_counts) * product(degrees + 1_c_int64_t))])
        if (code == NURBS_OK) code = nurbs_create_power(int(axes), degrees, piece_counts, breaks, &
            size(breaks, kind=c_int64_t), int(dim), coefficients, 0_c_int64_t, 0_c_int64_t, given(flags, 0), made)
        call out%replace(made)
        call settle(code, status)
    end subroutine create_power_spline

    !> coefficients(to) = matmul(matrix, coefficients(from)) at degree size(matrix, 1) - 1.
    subroutine basis_matrix(from, to, matrix, status)
        integer(c_int32_t), intent(in) :: from, to
        real(c_double), intent(inout) :: matrix(:, :)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: degree
        real(c_double), allocatable :: matrix_c(:, :)
        degree = size(matrix, 1, c_int64_t) - 1
        allocate (matrix_c(degree + 1, degree + 1))
        code = fitting([fits(matrix, degree + 1, degree + 1)])
        if (code == NURBS_OK) code = nurbs_basis_matrix(from, to, int(degree), matrix_size(degree), matrix_c)
        if (code == NURBS_OK) matrix = transpose(matrix_c)
        call settle(code, status)
    end subroutine basis_matrix
end module nurbs_segments
