! SPDX-License-Identifier: MIT
!> Knot vectors, and what needs knots but no spline: spans, bases, collocation. Spans count from 1, so that the
!> degree + 1 basis functions of span s are those from s - degree to s. Conventions: see the module nurbs.
module nurbs_knot_vectors
    use, intrinsic :: iso_c_binding
    use nurbs_constants
    use nurbs_c
    use nurbs_support
    use nurbs_placements, only: given
    implicit none
    private
    public :: knots_uniform, knots_open_uniform, knots_bezier, knots_averaged, knots_periodic
    public :: find_spans, bernstein, basis, collocation

contains

    ! Knot vectors, of count + degree + 1 knots

    !> Evenly spaced, with the domain from a to b, 0 and 1 unless given.
    subroutine knots_uniform(degree, count, knots, a, b, status)
        integer(c_int32_t), intent(in) :: degree, count
        real(c_double), allocatable, intent(out) :: knots(:)
        real(c_double), intent(in), optional :: a, b
        integer(c_int32_t), intent(out), optional :: status
        call make_room(degree, int(count, c_int64_t), knots)
        call settle(nurbs_knots_uniform(degree, int(count, c_int64_t), given(a, 0d0), given(b, 1d0), &
            size(knots, kind=c_int64_t), knots), status)
    end subroutine knots_uniform

    !> Clamped, and evenly spaced from a to b, 0 and 1 unless given.
    subroutine knots_open_uniform(degree, count, knots, a, b, status)
        integer(c_int32_t), intent(in) :: degree, count
        real(c_double), allocatable, intent(out) :: knots(:)
        real(c_double), intent(in), optional :: a, b
        integer(c_int32_t), intent(out), optional :: status
        call make_room(degree, int(count, c_int64_t), knots)
        call settle(nurbs_knots_open_uniform(degree, int(count, c_int64_t), given(a, 0d0), given(b, 1d0), &
            size(knots, kind=c_int64_t), knots), status)
    end subroutine knots_open_uniform

    !> Those of joined Bezier pieces, with breaks(pieces + 1), or evenly spaced from 0 to 1.
    subroutine knots_bezier(degree, pieces, knots, breaks, status)
        integer(c_int32_t), intent(in) :: degree, pieces
        real(c_double), allocatable, intent(out) :: knots(:)
        real(c_double), intent(in), optional :: breaks(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        call make_room(degree, merge(int(pieces, c_int64_t), int(pieces, c_int64_t) * degree + 1, degree == 0), knots)
        code = fitting([has_size(pieces + 1_c_int64_t, breaks)])
        if (code == NURBS_OK) code = nurbs_knots_bezier(degree, int(pieces, c_int64_t), breaks, &
            size(knots, kind=c_int64_t), knots)
        call settle(code, status)
    end subroutine knots_bezier

    !> Clamped, with inner knots that are averages of degree consecutive params(count).
    subroutine knots_averaged(degree, params, knots, status)
        integer(c_int32_t), intent(in) :: degree
        real(c_double), intent(in) :: params(:)
        real(c_double), allocatable, intent(out) :: knots(:)
        integer(c_int32_t), intent(out), optional :: status
        call make_room(degree, size(params, kind=c_int64_t), knots)
        call settle(nurbs_knots_averaged(degree, size(params, kind=c_int64_t), params, &
            size(knots, kind=c_int64_t), knots), status)
    end subroutine knots_averaged

    !> Those of a closed spline, with breaks(n), each once or multiplicities(n) times.
    subroutine knots_periodic(degree, breaks, knots, multiplicities, status)
        integer(c_int32_t), intent(in) :: degree
        real(c_double), intent(in) :: breaks(:)
        real(c_double), allocatable, intent(out) :: knots(:)
        integer(c_int32_t), intent(in), optional :: multiplicities(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n, inner
        n = size(breaks, kind=c_int64_t)
        inner = n - 1
        code = fitting([has_length(n, multiplicities)])
        if (present(multiplicities) .and. code == NURBS_OK) inner = sum(int(multiplicities(:inner), c_int64_t))
        call make_room(degree, inner + degree, knots)
        if (code == NURBS_OK) &
            code = nurbs_knots_periodic(degree, n, breaks, multiplicities, size(knots, kind=c_int64_t), knots)
        call settle(code, status)
    end subroutine knots_periodic

    ! Spans and bases

    !> spans(n) of params(n) in a full knot vector.
    subroutine find_spans(degree, knots, params, spans, flags, status)
        integer(c_int32_t), intent(in) :: degree
        real(c_double), intent(in) :: knots(:), params(:)
        integer(c_int64_t), intent(inout) :: spans(:)
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        code = fitting([size(spans) == size(params)])
        if (code == NURBS_OK) code = nurbs_find_spans(degree, control_points(degree, knots), knots, &
            size(knots, kind=c_int64_t), size(params, kind=c_int64_t), params, 0_c_int64_t, spans, bits(flags))
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
        code = fitting([shape(values) == [size(params), degree + 1, order + 1]])
        if (code == NURBS_OK) code = nurbs_bernstein(degree, order, size(params, kind=c_int64_t), params, &
            0_c_int64_t, values, step(values), column(values))
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
        code = fitting([[size(spans), shape(values)] == [size(params), size(params), degree + 1, order + 1]])
        if (code == NURBS_OK) code = nurbs_basis(degree, control_points(degree, knots), knots, &
            size(knots, kind=c_int64_t), order, size(params, kind=c_int64_t), params, 0_c_int64_t, spans, values, &
            step(values), column(values), bits(flags))
        if (code == NURBS_OK) spans = spans + 1
        call settle(code, status)
    end subroutine basis

    !> Compressed sparse rows of the derivative `orders` of products of basis functions at params(n, axes), all indices
    !> from 1; knots holds those of the first axis, then those of the next. Like the binding of a spline of that name.
    subroutine collocation(degrees, counts, knots, params, values, columns, row_pointers, orders, flags, status)
        integer(c_int32_t), intent(in) :: degrees(:), counts(:)
        real(c_double), intent(in) :: knots(:), params(:, :)
        real(c_double), allocatable, intent(inout) :: values(:)
        integer(c_int64_t), allocatable, intent(inout) :: columns(:), row_pointers(:)
        integer(c_int32_t), intent(in), optional :: orders(:), flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code, axes
        integer(c_int64_t) :: n, entries
        axes = size(degrees)
        n = size(params, 1, c_int64_t)
        code = fitting([size(counts) == axes, size(params, 2) == axes, has_length(int(axes, c_int64_t), orders)])
        if (code == NURBS_OK) code = nurbs_collocation(axes, degrees, int(counts, c_int64_t), knots, &
            size(knots, kind=c_int64_t), orders, n, params, step(params), column(params), 0_c_int64_t, &
            entries=entries, flags=bits(flags))
        if (code == NURBS_OK) then
            call make_sparse(entries, n, values, columns, row_pointers)
            code = nurbs_collocation(axes, degrees, int(counts, c_int64_t), knots, size(knots, kind=c_int64_t), &
                orders, n, params, step(params), column(params), entries, values, columns, row_pointers, &
                flags=bits(flags))
            columns = columns + 1
            row_pointers = row_pointers + 1
        end if
        call settle(code, status)
    end subroutine collocation

    !> Room for the knots of `count` control points; none where the library will refuse the numbers.
    subroutine make_room(degree, count, knots)
        integer(c_int32_t), intent(in) :: degree
        integer(c_int64_t), intent(in) :: count
        real(c_double), allocatable, intent(out) :: knots(:)
        if (degree >= 0 .and. degree <= NURBS_MAX_DEGREE .and. count >= 0) then
            allocate (knots(count + degree + 1))
        else
            allocate (knots(0))
        end if
    end subroutine make_room

    pure integer(c_int64_t) function control_points(degree, knots)
        integer(c_int32_t), intent(in) :: degree
        real(c_double), intent(in) :: knots(:)
        control_points = size(knots, kind=c_int64_t) - degree - 1
    end function control_points
end module nurbs_knot_vectors
