! SPDX-License-Identifier: MIT
!> The type of curves, surfaces and volumes. Conventions: see the module nurbs.
module nurbs_splines
    use, intrinsic :: iso_c_binding
    use nurbs_constants
    use nurbs_c
    use nurbs_support
    use nurbs_evaluation
    implicit none
    private

    !> A spline; an assignment makes another handle on the same data.
    type, extends(nurbs_shape), public :: nurbs_spline
    contains
        procedure :: create, create_homogeneous, create_short, create_multiplicities, create_bezier
        procedure :: with_points, iso, insert_knot
        procedure :: elevate, reverse, transpose_axes, reparametrize, transform, transform_projective
        procedure :: make_rational, to_homogeneous, from_homogeneous
        procedure :: refine, refine_uniform, refinement_matrix, split, extract, clamp, move_seam, join
        procedure, private :: copy
        generic :: assignment(=) => copy
    end type nurbs_spline

contains

    !> Elemental, so that arrays are not assigned bit by bit, which would free their handles twice.
    impure elemental subroutine copy(this, other)
        class(nurbs_spline), intent(inout) :: this
        class(nurbs_spline), intent(in) :: other
        type(c_ptr) :: made
        made = c_null_ptr
        if (c_associated(other%handle)) call settle(nurbs_clone(other%handle, made))
        call this%replace(made)
    end subroutine copy

    ! Construction

    subroutine create(this, degrees, counts, knots, points, weights, flags, status)
        class(nurbs_spline), intent(inout) :: this
        integer(c_int32_t), intent(in) :: degrees(:), counts(:)
        real(c_double), intent(in) :: knots(:), points(:, :)
        real(c_double), intent(in), optional :: weights(:)
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        made = c_null_ptr
        code = net_shape(degrees, counts, points, weights)
        if (code == NURBS_OK) code = nurbs_create(size(degrees), degrees, int(counts, c_int64_t), knots, &
            size(knots, kind=c_int64_t), size(points, 2), points, step(points), column(points), weights, &
            0_c_int64_t, bits(flags), made)
        call this%replace(made)
        call settle(code, status)
    end subroutine create

    !> points(n, dim + 1): (w x, w y, ..., w).
    subroutine create_homogeneous(this, degrees, counts, knots, points, flags, status)
        class(nurbs_spline), intent(inout) :: this
        integer(c_int32_t), intent(in) :: degrees(:), counts(:)
        real(c_double), intent(in) :: knots(:), points(:, :)
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        made = c_null_ptr
        code = net_shape(degrees, counts, points)
        if (code == NURBS_OK) code = nurbs_create_homogeneous(size(degrees), degrees, &
            int(counts, c_int64_t), knots, size(knots, kind=c_int64_t), size(points, 2) - 1, points, &
            step(points), column(points), bits(flags), made)
        call this%replace(made)
        call settle(code, status)
    end subroutine create_homogeneous

    !> Knot vectors without their first and last knot.
    subroutine create_short(this, degrees, counts, knots, points, weights, flags, status)
        class(nurbs_spline), intent(inout) :: this
        integer(c_int32_t), intent(in) :: degrees(:), counts(:)
        real(c_double), intent(in) :: knots(:), points(:, :)
        real(c_double), intent(in), optional :: weights(:)
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        made = c_null_ptr
        code = net_shape(degrees, counts, points, weights)
        if (code == NURBS_OK) code = nurbs_create_short(size(degrees), degrees, int(counts, c_int64_t), &
            knots, size(knots, kind=c_int64_t), size(points, 2), points, step(points), column(points), &
            weights, 0_c_int64_t, bits(flags), made)
        call this%replace(made)
        call settle(code, status)
    end subroutine create_short

    subroutine create_multiplicities(this, degrees, counts, distinct_counts, distinct_knots, multiplicities, &
                                     points, weights, flags, status)
        class(nurbs_spline), intent(inout) :: this
        integer(c_int32_t), intent(in) :: degrees(:), counts(:), distinct_counts(:), multiplicities(:)
        real(c_double), intent(in) :: distinct_knots(:), points(:, :)
        real(c_double), intent(in), optional :: weights(:)
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        made = c_null_ptr
        code = net_shape(degrees, counts, points, weights)
        if (size(distinct_counts) /= size(degrees) .or. size(distinct_knots) /= size(multiplicities) .or. &
            size(distinct_knots) /= sum(distinct_counts)) code = shape_error
        if (code == NURBS_OK) code = nurbs_create_multiplicities(size(degrees), degrees, &
            int(counts, c_int64_t), int(distinct_counts, c_int64_t), distinct_knots, multiplicities, &
            size(points, 2), points, step(points), column(points), weights, 0_c_int64_t, bits(flags), made)
        call this%replace(made)
        call settle(code, status)
    end subroutine create_multiplicities

    subroutine create_bezier(this, degrees, points, weights, status)
        class(nurbs_spline), intent(inout) :: this
        integer(c_int32_t), intent(in) :: degrees(:)
        real(c_double), intent(in) :: points(:, :)
        real(c_double), intent(in), optional :: weights(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        made = c_null_ptr
        code = net_shape(degrees, degrees + 1, points, weights)
        if (code == NURBS_OK) code = nurbs_create_bezier(size(degrees), degrees, size(points, 2), points, &
            step(points), column(points), weights, 0_c_int64_t, made)
        call this%replace(made)
        call settle(code, status)
    end subroutine create_bezier

    !> The same knots with other points; out is another variable than this.
    subroutine with_points(this, points, out, weights, status)
        class(nurbs_spline), intent(in) :: this
        real(c_double), intent(in) :: points(:, :)
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(in), optional :: weights(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code, dim
        integer(c_int64_t) :: n
        type(c_ptr) :: made
        made = c_null_ptr
        code = sizes_of(this%handle, n, dim)
        if (code == NURBS_OK .and. (size(points, 1) /= n .or. size(points, 2) /= dim)) code = shape_error
        if (present(weights)) then
            if (code == NURBS_OK .and. size(weights) /= n) code = shape_error
        end if
        if (code == NURBS_OK) code = nurbs_with_points(this%handle, points, step(points), column(points), &
            weights, 0_c_int64_t, made)
        call out%replace(made)
        call settle(code, status)
    end subroutine with_points

    ! Operations; out is another variable than this.

    subroutine iso(this, axis, param, out, flags, status)
        class(nurbs_spline), intent(in) :: this
        integer(c_int32_t), intent(in) :: axis
        real(c_double), intent(in) :: param
        type(nurbs_spline), intent(inout) :: out
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        code = nurbs_iso(this%handle, axis - 1, param, bits(flags), made)
        call out%replace(made)
        call settle(code, status)
    end subroutine iso

    subroutine insert_knot(this, axis, knot, times, out, status)
        class(nurbs_spline), intent(in) :: this
        integer(c_int32_t), intent(in) :: axis, times
        real(c_double), intent(in) :: knot
        type(nurbs_spline), intent(inout) :: out
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        code = nurbs_insert_knot(this%handle, axis - 1, knot, times, made)
        call out%replace(made)
        call settle(code, status)
    end subroutine insert_knot

    subroutine elevate(this, axis, times, out, status)
        class(nurbs_spline), intent(in) :: this
        integer(c_int32_t), intent(in) :: axis, times
        type(nurbs_spline), intent(inout) :: out
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        code = nurbs_elevate(this%handle, axis - 1, times, made)
        call out%replace(made)
        call settle(code, status)
    end subroutine elevate

    subroutine reverse(this, axis, out, flags, status)
        class(nurbs_spline), intent(in) :: this
        integer(c_int32_t), intent(in) :: axis
        integer(c_int32_t), intent(in), optional :: flags
        type(nurbs_spline), intent(inout) :: out
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        code = nurbs_reverse(this%handle, axis - 1, bits(flags), made)
        call out%replace(made)
        call settle(code, status)
    end subroutine reverse

    !> Axis k of the result is axis permutation(k).
    subroutine transpose_axes(this, permutation, out, status)
        class(nurbs_spline), intent(in) :: this
        integer(c_int32_t), intent(in) :: permutation(:)
        type(nurbs_spline), intent(inout) :: out
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code, axes
        type(c_ptr) :: made
        made = c_null_ptr
        code = nurbs_axes(this%handle, axes)
        if (code == NURBS_OK .and. size(permutation) /= axes) code = shape_error
        if (code == NURBS_OK) code = nurbs_transpose(this%handle, permutation - 1, made)
        call out%replace(made)
        call settle(code, status)
    end subroutine transpose_axes

    subroutine reparametrize(this, axis, lower, upper, out, status)
        class(nurbs_spline), intent(in) :: this
        integer(c_int32_t), intent(in) :: axis
        real(c_double), intent(in) :: lower, upper
        type(nurbs_spline), intent(inout) :: out
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        code = nurbs_reparametrize(this%handle, axis - 1, lower, upper, made)
        call out%replace(made)
        call settle(code, status)
    end subroutine reparametrize

    subroutine make_rational(this, out, status)
        class(nurbs_spline), intent(in) :: this
        type(nurbs_spline), intent(inout) :: out
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        code = nurbs_make_rational(this%handle, made)
        call out%replace(made)
        call settle(code, status)
    end subroutine make_rational

    subroutine to_homogeneous(this, out, status)
        class(nurbs_spline), intent(in) :: this
        type(nurbs_spline), intent(inout) :: out
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        code = nurbs_to_homogeneous(this%handle, made)
        call out%replace(made)
        call settle(code, status)
    end subroutine to_homogeneous

    subroutine from_homogeneous(this, out, status)
        class(nurbs_spline), intent(in) :: this
        type(nurbs_spline), intent(inout) :: out
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        code = nurbs_from_homogeneous(this%handle, made)
        call out%replace(made)
        call settle(code, status)
    end subroutine from_homogeneous

    !> matrix(out_dim, dim), translation(out_dim)
    subroutine transform(this, matrix, out, translation, status)
        class(nurbs_spline), intent(in) :: this
        real(c_double), intent(in) :: matrix(:, :)
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(in), optional :: translation(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code, dim
        type(c_ptr) :: made
        made = c_null_ptr
        code = nurbs_dimension(this%handle, dim)
        if (code == NURBS_OK .and. size(matrix, 2) /= dim) code = shape_error
        if (present(translation)) then
            if (size(translation) /= size(matrix, 1)) code = shape_error
        end if
        if (code == NURBS_OK) code = nurbs_transform(this%handle, size(matrix, 1), transpose(matrix), &
            translation, made)
        call out%replace(made)
        call settle(code, status)
    end subroutine transform

    !> matrix(out_dim + 1, dim + 1)
    subroutine transform_projective(this, matrix, out, status)
        class(nurbs_spline), intent(in) :: this
        real(c_double), intent(in) :: matrix(:, :)
        type(nurbs_spline), intent(inout) :: out
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code, dim
        type(c_ptr) :: made
        made = c_null_ptr
        code = nurbs_dimension(this%handle, dim)
        if (code == NURBS_OK .and. size(matrix, 2) /= dim + 1) code = shape_error
        if (code == NURBS_OK) code = nurbs_transform_projective(this%handle, size(matrix, 1) - 1, &
            transpose(matrix), made)
        call out%replace(made)
        call settle(code, status)
    end subroutine transform_projective

    subroutine refine(this, axis, knots, out, status)
        class(nurbs_spline), intent(in) :: this
        integer(c_int32_t), intent(in) :: axis
        real(c_double), intent(in) :: knots(:)
        type(nurbs_spline), intent(inout) :: out
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        code = nurbs_refine(this%handle, axis - 1, size(knots, kind=c_int64_t), knots, made)
        call out%replace(made)
        call settle(code, status)
    end subroutine refine

    subroutine refine_uniform(this, axis, parts, out, status)
        class(nurbs_spline), intent(in) :: this
        integer(c_int32_t), intent(in) :: axis, parts
        type(nurbs_spline), intent(inout) :: out
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        code = nurbs_refine_uniform(this%handle, axis - 1, int(parts, c_int64_t), made)
        call out%replace(made)
        call settle(code, status)
    end subroutine refine_uniform

    !> Compressed sparse rows of what refine() does along the axis, all indices from 1.
    subroutine refinement_matrix(this, axis, knots, values, columns, row_pointers, status)
        class(nurbs_spline), intent(in) :: this
        integer(c_int32_t), intent(in) :: axis
        real(c_double), intent(in) :: knots(:)
        real(c_double), allocatable, intent(inout) :: values(:)
        integer(c_int64_t), allocatable, intent(inout) :: columns(:), row_pointers(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n, rows, entries
        n = size(knots, kind=c_int64_t)
        code = nurbs_refinement_matrix(this%handle, axis - 1, n, knots, 0_c_int64_t, entries=entries)
        if (code == NURBS_OK) code = nurbs_count(this%handle, axis - 1, rows)
        if (code == NURBS_OK) then
            call make_sparse(entries, rows + n, values, columns, row_pointers)
            code = nurbs_refinement_matrix(this%handle, axis - 1, n, knots, entries, values, columns, row_pointers)
            columns = columns + 1
            row_pointers = row_pointers + 1
        end if
        call settle(code, status)
    end subroutine refinement_matrix

    subroutine split(this, axis, param, lower, upper, status)
        class(nurbs_spline), intent(in) :: this
        integer(c_int32_t), intent(in) :: axis
        real(c_double), intent(in) :: param
        type(nurbs_spline), intent(inout) :: lower, upper
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: below, above
        code = nurbs_split(this%handle, axis - 1, param, below, above)
        call lower%replace(below)
        call upper%replace(above)
        call settle(code, status)
    end subroutine split

    !> lower(axes), upper(axes): the ends of the part on each axis.
    subroutine extract(this, lower, upper, out, status)
        class(nurbs_spline), intent(in) :: this
        real(c_double), intent(in) :: lower(:), upper(:)
        type(nurbs_spline), intent(inout) :: out
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code, axes
        type(c_ptr) :: made
        made = c_null_ptr
        code = nurbs_axes(this%handle, axes)
        if (code == NURBS_OK .and. (size(lower) /= axes .or. size(upper) /= axes)) code = shape_error
        if (code == NURBS_OK) code = nurbs_extract(this%handle, lower, upper, made)
        call out%replace(made)
        call settle(code, status)
    end subroutine extract

    !> Without flags both ends are clamped.
    subroutine clamp(this, axis, out, flags, status)
        class(nurbs_spline), intent(in) :: this
        integer(c_int32_t), intent(in) :: axis
        type(nurbs_spline), intent(inout) :: out
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code, ends
        type(c_ptr) :: made
        ends = ior(NURBS_FORM_CLAMPED_START, NURBS_FORM_CLAMPED_END)
        if (present(flags)) ends = flags
        code = nurbs_clamp_ends(this%handle, axis - 1, ends, made)
        call out%replace(made)
        call settle(code, status)
    end subroutine clamp

    subroutine move_seam(this, axis, param, out, status)
        class(nurbs_spline), intent(in) :: this
        integer(c_int32_t), intent(in) :: axis
        real(c_double), intent(in) :: param
        type(nurbs_spline), intent(inout) :: out
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        code = nurbs_move_seam(this%handle, axis - 1, param, made)
        call out%replace(made)
        call settle(code, status)
    end subroutine move_seam

    !> This spline becomes the parts joined end to end, of which it is none.
    subroutine join(this, parts, axis, tolerance, flags, gap, status)
        class(nurbs_spline), intent(inout) :: this
        type(nurbs_spline), intent(in) :: parts(:)
        integer(c_int32_t), intent(in) :: axis
        real(c_double), intent(in), optional :: tolerance
        integer(c_int32_t), intent(in), optional :: flags
        real(c_double), intent(inout), optional :: gap
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code, i
        real(c_double) :: limit
        type(c_ptr) :: made, handles(size(parts))
        limit = 0
        if (present(tolerance)) limit = tolerance
        do i = 1, size(parts)
            handles(i) = parts(i)%handle
        end do
        code = nurbs_join(size(parts, kind=c_int64_t), handles, axis - 1, limit, bits(flags), gap, made)
        call this%replace(made)
        call settle(code, status)
    end subroutine join

end module nurbs_splines
