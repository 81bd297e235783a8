! SPDX-License-Identifier: MIT
! Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
!> Knot vectors, and what needs knots but no spline: spans, bases, collocation. Spans count from 1, so that the degree +
!> 1 basis functions of span s are those from s - degree to s. Conventions: see the module nurbs.
module nurbs_knot_vectors
    use, intrinsic :: iso_c_binding
    use nurbs_constants
    use nurbs_c, only: nurbs_knots_uniform, nurbs_knots_open_uniform, nurbs_knots_bezier, nurbs_knots_averaged, &
        nurbs_knots_periodic, nurbs_find_spans, nurbs_bernstein, nurbs_basis, nurbs_collocation
    use nurbs_support
    implicit none
    private
    public :: knots_uniform, knots_open_uniform, knots_bezier, knots_averaged, knots_periodic, find_spans, bernstein
    public :: basis, collocation

contains

    ! Knot generators, span search and basis functions: what needs knots but no spline

    !> Evenly spaced, with the domain from a to b, 0 and 1 unless given.
    subroutine knots_uniform(degree, count, knots, a, b, status)
        integer(c_int32_t), intent(in) :: degree, count
        real(c_double), allocatable, intent(out) :: knots(:)
        real(c_double), intent(in), optional :: a, b
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int64_t) :: knot_count_c
        knot_count_c = knot_count(degree, int(count, c_int64_t))
        allocate (knots(knot_count_c))
        call settle(nurbs_knots_uniform(degree, int(count, c_int64_t), given(a, 0d0), given(b, 1d0), knot_count_c, &
            knots), status)
    end subroutine knots_uniform

    !> Clamped, and evenly spaced from a to b, 0 and 1 unless given.
    subroutine knots_open_uniform(degree, count, knots, a, b, status)
        integer(c_int32_t), intent(in) :: degree, count
        real(c_double), allocatable, intent(out) :: knots(:)
        real(c_double), intent(in), optional :: a, b
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int64_t) :: knot_count_c
        knot_count_c = knot_count(degree, int(count, c_int64_t))
        allocate (knots(knot_count_c))
        call settle(nurbs_knots_open_uniform(degree, int(count, c_int64_t), given(a, 0d0), given(b, 1d0), &
            knot_count_c, knots), status)
    end subroutine knots_open_uniform

    !> Those of joined Bezier pieces, with breaks(pieces + 1), or evenly spaced from 0 to 1.
    subroutine knots_bezier(degree, pieces, knots, breaks, status)
        integer(c_int32_t), intent(in) :: degree, pieces
        real(c_double), allocatable, intent(out) :: knots(:)
        real(c_double), intent(in), optional :: breaks(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: knot_count_c
        knot_count_c = knot_count(degree, bezier_count(degree, int(pieces, c_int64_t)))
        allocate (knots(knot_count_c))
        code = fitting([fits(breaks, pieces + 1_c_int64_t)])
        if (code == NURBS_OK) code = nurbs_knots_bezier(degree, int(pieces, c_int64_t), breaks, knot_count_c, knots)
        call settle(code, status)
    end subroutine knots_bezier

    !> Clamped, with inner knots that are averages of degree consecutive params(count).
    subroutine knots_averaged(degree, params, knots, status)
        integer(c_int32_t), intent(in) :: degree
        real(c_double), intent(in) :: params(:)
        real(c_double), allocatable, intent(out) :: knots(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int64_t) :: count, knot_count_c
        count = size(params, kind=c_int64_t)
        knot_count_c = knot_count(degree, count)
        allocate (knots(knot_count_c))
        call settle(nurbs_knots_averaged(degree, count, params, knot_count_c, knots), status)
    end subroutine knots_averaged

    !> Those of a closed spline, with breaks(n), each once or multiplicities(n) times.
    subroutine knots_periodic(degree, breaks, knots, multiplicities, status)
        integer(c_int32_t), intent(in) :: degree
        real(c_double), intent(in) :: breaks(:)
        real(c_double), allocatable, intent(out) :: knots(:)
        integer(c_int32_t), intent(in), optional :: multiplicities(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n, knot_count_c
        n = size(breaks, kind=c_int64_t)
        knot_count_c = knot_count(degree, periodic_count(degree, breaks, multiplicities))
        allocate (knots(knot_count_c))
        code = fitting([fits(multiplicities, n)])
        if (code == NURBS_OK) code = nurbs_knots_periodic(degree, n, breaks, multiplicities, knot_count_c, knots)
        call settle(code, status)
    end subroutine knots_periodic

    !> spans(n) of params(n) in a full knot vector.
    subroutine find_spans(degree, knots, params, spans, flags, status)
        integer(c_int32_t), intent(in) :: degree
        real(c_double), intent(in) :: knots(:), params(:)
        integer(c_int64_t), intent(inout) :: spans(:)
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        n = size(params, kind=c_int64_t)
        code = fitting([fits(spans, n)])
        if (code == NURBS_OK) code = nurbs_find_spans(degree, size(knots, kind=c_int64_t) - degree - 1, knots, &
            size(knots, kind=c_int64_t), n, params, 0_c_int64_t, spans, given(flags, 0))
        if (code == NURBS_OK) spans = spans + 1
        call settle(code, status)
    end subroutine find_spans

    !> values(n, degree + 1, order + 1): Bernstein polynomials at params(n), and their derivatives up to an order.
    subroutine bernstein(degree, order, params, values, status)
        integer(c_int32_t), intent(in) :: degree, order
        real(c_double), intent(in) :: params(:)
        real(c_double), intent(inout) :: values(:, :, :)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        n = size(params, kind=c_int64_t)
        code = fitting([fits(values, n, degree + 1_c_int64_t, order + 1_c_int64_t)])
        if (code == NURBS_OK) code = nurbs_bernstein(degree, order, n, params, 0_c_int64_t, values, step(values), &
            column(values))
        call settle(code, status)
    end subroutine bernstein

    !> values(n, degree + 1, order + 1): the basis functions that are not 0 at params(n), and their derivatives up to an
    !> order; and the spans(n), which tell which ones they are.
    subroutine basis(degree, knots, order, params, spans, values, flags, status)
        integer(c_int32_t), intent(in) :: degree, order
        real(c_double), intent(in) :: knots(:), params(:)
        integer(c_int64_t), intent(inout) :: spans(:)
        real(c_double), intent(inout) :: values(:, :, :)
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        n = size(params, kind=c_int64_t)
        code = fitting([fits(spans, n), fits(values, n, degree + 1_c_int64_t, order + 1_c_int64_t)])
        if (code == NURBS_OK) code = nurbs_basis(degree, size(knots, kind=c_int64_t) - degree - 1, knots, &
            size(knots, kind=c_int64_t), order, n, params, 0_c_int64_t, spans, values, step(values), column(values), &
            given(flags, 0))
        if (code == NURBS_OK) spans = spans + 1
        call settle(code, status)
    end subroutine basis

    ! Derivatives with respect to data: collocation matrices, Bezier extraction, gradients

    !> Compressed sparse rows of the derivative `orders` of products of basis functions at params(n, axes), all indices
    !> from 1; knots holds those of the first axis, then those of the next. Like the binding of a spline of that name.
    subroutine collocation(degrees, counts, knots, params, values, columns, row_pointers, orders, flags, status)
        integer(c_int32_t), intent(in) :: degrees(:), counts(:)
        real(c_double), intent(in) :: knots(:), params(:, :)
        real(c_double), allocatable, intent(inout) :: values(:)
        integer(c_int64_t), allocatable, intent(inout) :: columns(:), row_pointers(:)
        integer(c_int32_t), intent(in), optional :: orders(:), flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: axes, knot_count_c, n, entries
        axes = size(degrees, kind=c_int64_t)
        knot_count_c = size(knots, kind=c_int64_t)
        n = size(params, 1, c_int64_t)
        entries = 0
        code = fitting([fits(counts, axes), fits(params, n, axes), fits(orders, axes)])
        if (code == NURBS_OK) code = nurbs_collocation(int(axes), degrees, int(counts, c_int64_t), knots, &
            knot_count_c, orders, n, params, step(params), column(params), 0_c_int64_t, entries=entries, &
            flags=given(flags, 0))
        if (code == NURBS_OK) then
            if (allocated(values)) deallocate (values)
            if (allocated(columns)) deallocate (columns)
            if (allocated(row_pointers)) deallocate (row_pointers)
            allocate (values(entries), columns(entries), row_pointers(n + 1))
            code = nurbs_collocation(int(axes), degrees, int(counts, c_int64_t), knots, knot_count_c, orders, n, &
                params, step(params), column(params), entries, values, columns, row_pointers, flags=given(flags, 0))
        end if
        if (code == NURBS_OK) then
            columns = columns + 1
            row_pointers = row_pointers + 1
        end if
        call settle(code, status)
    end subroutine collocation
end module nurbs_knot_vectors
