! SPDX-License-Identifier: MIT
! Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
!> Parameters of data, and splines through them. Conventions: see the module nurbs.
module nurbs_fits
    use, intrinsic :: iso_c_binding
    use nurbs_constants
    use nurbs_c, only: nurbs_parametrize, nurbs_params_universal, nurbs_interpolate, nurbs_interpolate_over_knots, &
        nurbs_interpolate_derivatives, nurbs_curve_interpolate, nurbs_tangent_lengths, nurbs_tangents
    use nurbs_support
    use nurbs_splines
    implicit none
    private
    public :: parametrize, params_universal, interpolate, interpolate_over_knots, interpolate_derivatives
    public :: curve_interpolate, tangent_lengths, tangents_at

contains

    !> params of points on a grid from the distances between them, those of each axis from 0 to 1.
    subroutine parametrize(counts, points, rule, params, exponent, flags, status)
        integer(c_int32_t), intent(in) :: counts(:), rule
        real(c_double), intent(in) :: points(:, :)
        real(c_double), intent(inout) :: params(:)
        real(c_double), intent(in), optional :: exponent
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: dim
        dim = size(points, 2, c_int64_t)
        code = fitting([fits(points, product(int(counts, c_int64_t)), dim), fits(params, sum(int(counts, c_int64_t)))])
        if (code == NURBS_OK) code = nurbs_parametrize(size(counts), int(counts, c_int64_t), int(dim), points, &
            step(points), column(points), rule, given(exponent, 1d0), given(flags, 0), params)
        call settle(code, status)
    end subroutine parametrize

    !> params(count) where the basis functions over evenly spaced knots are largest, for interpolation over these.
    subroutine params_universal(degree, params, status)
        integer(c_int32_t), intent(in) :: degree
        real(c_double), intent(inout) :: params(:)
        integer(c_int32_t), intent(out), optional :: status
        call settle(nurbs_params_universal(degree, size(params, kind=c_int64_t), params), status)
    end subroutine params_universal

    !> The spline through points on a grid of parameters; without ends, not-a-knot.
    subroutine interpolate(degrees, counts, params, points, out, ends, residual, flags, status)
        integer(c_int32_t), intent(in) :: degrees(:), counts(:)
        real(c_double), intent(in) :: params(:), points(:, :)
        type(nurbs_spline), intent(inout) :: out
        integer(c_int32_t), intent(in), optional :: ends(:, :), flags
        real(c_double), intent(inout), optional :: residual
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: axes, dim
        integer(c_int32_t), allocatable :: ends_c(:, :)
        type(c_ptr) :: made
        axes = size(degrees, kind=c_int64_t)
        dim = size(points, 2, c_int64_t)
        made = c_null_ptr
        code = fitting([fits(counts, axes), fits(params, sum(int(counts, c_int64_t))), &
            fits(points, product(int(counts, c_int64_t)), dim), fits(ends, axes, 2_c_int64_t)])
        if (present(ends)) ends_c = transpose(ends)
        if (code == NURBS_OK) code = nurbs_interpolate(int(axes), degrees, int(counts, c_int64_t), params, int(dim), &
            points, step(points), column(points), ends_c, given(flags, 0), residual, made)
        call out%replace(made)
        call settle(code, status)
    end subroutine interpolate

    !> The spline over full knot vectors, all axes one after the other, through points on a grid of parameters.
    subroutine interpolate_over_knots(degrees, counts, params, knots, points, out, flags, status)
        integer(c_int32_t), intent(in) :: degrees(:), counts(:)
        real(c_double), intent(in) :: params(:), knots(:), points(:, :)
        type(nurbs_spline), intent(inout) :: out
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: axes, dim
        type(c_ptr) :: made
        axes = size(degrees, kind=c_int64_t)
        dim = size(points, 2, c_int64_t)
        made = c_null_ptr
        code = fitting([fits(counts, axes), fits(params, sum(int(counts, c_int64_t))), &
            fits(points, product(int(counts, c_int64_t)), dim)])
        if (code == NURBS_OK) code = nurbs_interpolate_over_knots(int(axes), degrees, int(counts, c_int64_t), params, &
            knots, size(knots, kind=c_int64_t), int(dim), points, step(points), column(points), given(flags, 0), made)
        call out%replace(made)
        call settle(code, status)
    end subroutine interpolate_over_knots

    !> The spline through layers of points and, at the ends of axes, of derivatives; mixed ones may be NaN.
    subroutine interpolate_derivatives(degrees, counts, params, orders, values, out, ends, flags, status)
        integer(c_int32_t), intent(in) :: degrees(:), counts(:), orders(:)
        real(c_double), intent(in) :: params(:), values(:, :)
        type(nurbs_spline), intent(inout) :: out
        integer(c_int32_t), intent(in), optional :: ends(:, :), flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: axes, dim, sum_counts
        integer(c_int32_t), allocatable :: ends_c(:, :)
        type(c_ptr) :: made
        axes = size(degrees, kind=c_int64_t)
        dim = size(values, 2, c_int64_t)
        sum_counts = sum(int(counts, c_int64_t))
        made = c_null_ptr
        code = fitting([fits(counts, axes), fits(params, sum_counts), fits(orders, sum_counts), &
            fits(values, product(int(counts, c_int64_t)), dim), fits(ends, axes, 2_c_int64_t)])
        if (present(ends)) ends_c = transpose(ends)
        if (code == NURBS_OK) code = nurbs_interpolate_derivatives(int(axes), degrees, int(counts, c_int64_t), params, &
            orders, int(dim), values, step(values), column(values), ends_c, given(flags, 0), made)
        call out%replace(made)
        call settle(code, status)
    end subroutine interpolate_derivatives

    !> The curve with given points and derivatives; without orders, points; without knots, averaged ones.
    subroutine curve_interpolate(degree, params, targets, out, orders, knots, flags, status)
        integer(c_int32_t), intent(in) :: degree
        real(c_double), intent(in) :: params(:), targets(:, :)
        type(nurbs_spline), intent(inout) :: out
        integer(c_int32_t), intent(in), optional :: orders(:), flags
        real(c_double), intent(in), optional :: knots(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n, dim
        type(c_ptr) :: made
        n = size(params, kind=c_int64_t)
        dim = size(targets, 2, c_int64_t)
        made = c_null_ptr
        code = fitting([fits(targets, n, dim), fits(orders, n)])
        if (code == NURBS_OK) code = nurbs_curve_interpolate(degree, n, params, orders, int(dim), targets, &
            step(targets), column(targets), knots, size_if_given(knots), given(flags, 0), made)
        call out%replace(made)
        call settle(code, status)
    end subroutine curve_interpolate

    !> The factors that make derivatives of targets of which curve_interpolate() is told the directions.
    subroutine tangent_lengths(degree, params, targets, orders, lengths, knots, flags, status)
        integer(c_int32_t), intent(in) :: degree, orders(:)
        real(c_double), intent(in) :: params(:), targets(:, :)
        real(c_double), intent(inout) :: lengths(:)
        real(c_double), intent(in), optional :: knots(:)
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n, dim
        n = size(params, kind=c_int64_t)
        dim = size(targets, 2, c_int64_t)
        code = fitting([fits(targets, n, dim), fits(orders, n), fits(lengths, n)])
        if (code == NURBS_OK) code = nurbs_tangent_lengths(degree, n, params, orders, int(dim), targets, &
            step(targets), column(targets), knots, size_if_given(knots), given(flags, 0), lengths)
        call settle(code, status)
    end subroutine tangent_lengths

    !> tangents(n, dim) at points(n, dim) from the points near them, as create_hermite_spline() takes them.
    subroutine tangents_at(rule, params, points, tangents, flags, status)
        integer(c_int32_t), intent(in) :: rule
        real(c_double), intent(in) :: params(:), points(:, :)
        real(c_double), intent(inout) :: tangents(:, :)
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n, dim
        n = size(params, kind=c_int64_t)
        dim = size(points, 2, c_int64_t)
        code = fitting([fits(points, n, dim), fits(tangents, n, dim)])
        if (code == NURBS_OK) code = nurbs_tangents(rule, n, params, int(dim), points, step(points), column(points), &
            given(flags, 0), tangents, step(tangents), column(tangents))
        call settle(code, status)
    end subroutine tangents_at
end module nurbs_fits
