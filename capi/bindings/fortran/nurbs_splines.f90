! SPDX-License-Identifier: MIT
! Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
!> The type of curves, surfaces and volumes. Conventions: see the module nurbs.
module nurbs_splines
    use, intrinsic :: iso_c_binding
    use nurbs_constants
    use nurbs_c, only: nurbs_create, nurbs_create_homogeneous, nurbs_create_short, nurbs_create_multiplicities, &
        nurbs_create_periodic, nurbs_create_bezier, nurbs_with_points, nurbs_from_bytes, nurbs_iso, nurbs_insert_knot, &
        nurbs_refine, nurbs_refine_uniform, nurbs_split, nurbs_extract, nurbs_clamp_ends, nurbs_move_seam, &
        nurbs_elevate, nurbs_reverse, nurbs_transpose, nurbs_reparametrize, nurbs_make_rational, nurbs_to_homogeneous, &
        nurbs_from_homogeneous, nurbs_transform, nurbs_transform_projective, nurbs_bezier_pieces, nurbs_join, &
        nurbs_refinement_matrix
    use nurbs_support
    use nurbs_handles
    use nurbs_evaluation
    implicit none
    private

    !> A spline; an assignment makes another handle on the same data.
    type, extends(nurbs_shape), public :: nurbs_spline
    contains
        procedure :: create, create_homogeneous, create_short, create_multiplicities, create_periodic, create_bezier
        procedure :: with_points, from_bytes, iso, insert_knot, refine, refine_uniform, split, extract, clamp, move_seam
        procedure :: elevate, reverse, transpose_axes, reparametrize, make_rational, to_homogeneous, from_homogeneous
        procedure :: transform, transform_projective, bezier_pieces, join, refinement_matrix
    end type nurbs_spline

contains

    ! Construction

    !> A spline from full knot vectors, all axes one after the other; the last axis of the points is the fastest.
    subroutine create(this, degrees, counts, knots, points, weights, flags, status)
        class(nurbs_spline), intent(inout) :: this
        integer(c_int32_t), intent(in) :: degrees(:), counts(:)
        real(c_double), intent(in) :: knots(:), points(:, :)
        real(c_double), intent(in), optional :: weights(:)
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: axes, dim, product_counts
        type(c_ptr) :: made
        axes = size(degrees, kind=c_int64_t)
        dim = size(points, 2, c_int64_t)
        product_counts = net_size(int(counts, c_int64_t))
        made = c_null_ptr
        code = fitting([fits(counts, axes), fits(points, product_counts, dim), fits(weights, product_counts)])
        if (code == NURBS_OK) code = nurbs_create(int(axes), degrees, int(counts, c_int64_t), knots, &
            size(knots, kind=c_int64_t), int(dim), points, step(points), column(points), weights, 0_c_int64_t, &
            given(flags, 0), made)
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
        integer(c_int64_t) :: axes, dim
        type(c_ptr) :: made
        axes = size(degrees, kind=c_int64_t)
        dim = size(points, 2, c_int64_t) - 1
        made = c_null_ptr
        code = fitting([fits(counts, axes), fits(points, net_size(int(counts, c_int64_t)), dim + 1)])
        if (code == NURBS_OK) code = nurbs_create_homogeneous(int(axes), degrees, int(counts, c_int64_t), knots, &
            size(knots, kind=c_int64_t), int(dim), points, step(points), column(points), given(flags, 0), made)
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
        integer(c_int64_t) :: axes, dim, product_counts
        type(c_ptr) :: made
        axes = size(degrees, kind=c_int64_t)
        dim = size(points, 2, c_int64_t)
        product_counts = net_size(int(counts, c_int64_t))
        made = c_null_ptr
        code = fitting([fits(counts, axes), fits(points, product_counts, dim), fits(weights, product_counts)])
        if (code == NURBS_OK) code = nurbs_create_short(int(axes), degrees, int(counts, c_int64_t), knots, &
            size(knots, kind=c_int64_t), int(dim), points, step(points), column(points), weights, 0_c_int64_t, &
            given(flags, 0), made)
        call this%replace(made)
        call settle(code, status)
    end subroutine create_short

    !> A spline from distinct knots with multiplicities, one pair of vectors for each axis.
    subroutine create_multiplicities(this, degrees, counts, distinct_counts, distinct_knots, multiplicities, points, &
            weights, flags, status)
        class(nurbs_spline), intent(inout) :: this
        integer(c_int32_t), intent(in) :: degrees(:), counts(:), distinct_counts(:), multiplicities(:)
        real(c_double), intent(in) :: distinct_knots(:), points(:, :)
        real(c_double), intent(in), optional :: weights(:)
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: axes, dim, sum_distinct_counts, product_counts
        type(c_ptr) :: made
        axes = size(degrees, kind=c_int64_t)
        dim = size(points, 2, c_int64_t)
        sum_distinct_counts = sum(int(distinct_counts, c_int64_t))
        product_counts = net_size(int(counts, c_int64_t))
        made = c_null_ptr
        code = fitting([fits(counts, axes), fits(distinct_counts, axes), fits(distinct_knots, sum_distinct_counts), &
            fits(multiplicities, sum_distinct_counts), fits(points, product_counts, dim), &
            fits(weights, product_counts)])
        if (code == NURBS_OK) code = nurbs_create_multiplicities(int(axes), degrees, int(counts, c_int64_t), &
            int(distinct_counts, c_int64_t), distinct_knots, multiplicities, int(dim), points, step(points), &
            column(points), weights, 0_c_int64_t, given(flags, 0), made)
        call this%replace(made)
        call settle(code, status)
    end subroutine create_multiplicities

    !> Each control point once, and the knots of one period with its end, on periodic axes.
    subroutine create_periodic(this, degrees, counts, knots, points, weights, flags, status)
        class(nurbs_spline), intent(inout) :: this
        integer(c_int32_t), intent(in) :: degrees(:), counts(:)
        real(c_double), intent(in) :: knots(:), points(:, :)
        real(c_double), intent(in), optional :: weights(:)
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: axes, dim, product_counts
        type(c_ptr) :: made
        axes = size(degrees, kind=c_int64_t)
        dim = size(points, 2, c_int64_t)
        product_counts = net_size(int(counts, c_int64_t))
        made = c_null_ptr
        code = fitting([fits(counts, axes), fits(points, product_counts, dim), fits(weights, product_counts)])
        if (code == NURBS_OK) code = nurbs_create_periodic(int(axes), degrees, int(counts, c_int64_t), knots, &
            size(knots, kind=c_int64_t), int(dim), points, step(points), column(points), weights, 0_c_int64_t, &
            given(flags, 0), made)
        call this%replace(made)
        call settle(code, status)
    end subroutine create_periodic

    !> A Bezier spline over [0, 1] on every axis.
    subroutine create_bezier(this, degrees, points, weights, status)
        class(nurbs_spline), intent(inout) :: this
        integer(c_int32_t), intent(in) :: degrees(:)
        real(c_double), intent(in) :: points(:, :)
        real(c_double), intent(in), optional :: weights(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: dim, product_degrees
        type(c_ptr) :: made
        dim = size(points, 2, c_int64_t)
        product_degrees = net_size(degrees + 1_c_int64_t)
        made = c_null_ptr
        code = fitting([fits(points, product_degrees, dim), fits(weights, product_degrees)])
        if (code == NURBS_OK) code = nurbs_create_bezier(size(degrees), degrees, int(dim), points, step(points), &
            column(points), weights, 0_c_int64_t, made)
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
        integer(c_int32_t) :: code
        integer(c_int64_t) :: points_n
        type(c_ptr) :: made
        points_n = points_of(this%handle)
        made = c_null_ptr
        code = held(this%handle)
        if (code == NURBS_OK) code = fitting([fits(points, points_n, dim_of(this%handle)), fits(weights, points_n)])
        if (code == NURBS_OK) code = nurbs_with_points(this%handle, points, step(points), column(points), weights, &
            0_c_int64_t, made)
        call out%replace(made)
        call settle(code, status)
    end subroutine with_points

    !> The spline of what to_bytes() made of it, bit for bit.
    subroutine from_bytes(this, contents, status)
        class(nurbs_spline), intent(inout) :: this
        character(kind=c_char, len=*), intent(in), target :: contents
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        code = nurbs_from_bytes(c_loc(contents), len(contents, c_int64_t), made)
        call this%replace(made)
        call settle(code, status)
    end subroutine from_bytes

    ! Exact refinement, and parts of a spline

    !> The spline of one axis less on which the parameter of `axis` is fixed.
    subroutine iso(this, axis, param, out, flags, status)
        class(nurbs_spline), intent(in) :: this
        integer(c_int32_t), intent(in) :: axis
        real(c_double), intent(in) :: param
        type(nurbs_spline), intent(inout) :: out
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        code = nurbs_iso(this%handle, axis - 1, param, given(flags, 0), made)
        call out%replace(made)
        call settle(code, status)
    end subroutine iso

    !> The same shape with a knot inserted.
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

    !> The same shape with a list of knots inserted, in any order.
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

    !> The same shape with every non-empty span divided into equal parts.
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

    !> The parts below and above a parameter.
    subroutine split(this, axis, param, lower, upper, status)
        class(nurbs_spline), intent(in) :: this
        integer(c_int32_t), intent(in) :: axis
        real(c_double), intent(in) :: param
        type(nurbs_spline), intent(inout) :: lower, upper
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made_lower, made_upper
        code = nurbs_split(this%handle, axis - 1, param, made_lower, made_upper)
        call lower%replace(made_lower)
        call upper%replace(made_upper)
        call settle(code, status)
    end subroutine split

    !> lower(axes), upper(axes): the ends of the part on each axis.
    subroutine extract(this, lower, upper, out, status)
        class(nurbs_spline), intent(in) :: this
        real(c_double), intent(in) :: lower(:), upper(:)
        type(nurbs_spline), intent(inout) :: out
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: axes
        type(c_ptr) :: made
        axes = axes_of(this%handle)
        made = c_null_ptr
        code = held(this%handle)
        if (code == NURBS_OK) code = fitting([fits(lower, axes), fits(upper, axes)])
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
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        code = nurbs_clamp_ends(this%handle, axis - 1, given(flags, &
            ior(NURBS_FORM_CLAMPED_START, NURBS_FORM_CLAMPED_END)), made)
        call out%replace(made)
        call settle(code, status)
    end subroutine clamp

    !> The same shape on a periodic axis over [param, param + period].
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

    ! Degree, form and transformations

    !> The same shape with the degree of an axis raised by `times`.
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

    !> The axis turned round; flags: 0 or NURBS_KEEP_DOMAIN.
    subroutine reverse(this, axis, out, flags, status)
        class(nurbs_spline), intent(in) :: this
        integer(c_int32_t), intent(in) :: axis
        type(nurbs_spline), intent(inout) :: out
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        code = nurbs_reverse(this%handle, axis - 1, given(flags, 0), made)
        call out%replace(made)
        call settle(code, status)
    end subroutine reverse

    !> Axis k of the result is axis permutation(k).
    subroutine transpose_axes(this, permutation, out, status)
        class(nurbs_spline), intent(in) :: this
        integer(c_int32_t), intent(in) :: permutation(:)
        type(nurbs_spline), intent(inout) :: out
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        made = c_null_ptr
        code = held(this%handle)
        if (code == NURBS_OK) code = fitting([fits(permutation, axes_of(this%handle))])
        if (code == NURBS_OK) code = nurbs_transpose(this%handle, permutation - 1, made)
        call out%replace(made)
        call settle(code, status)
    end subroutine transpose_axes

    !> The same shape over another domain.
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

    !> The same spline with weights.
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

    !> The polynomial spline of the points (w x, w y, ..., w).
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

    !> The rational spline whose homogeneous points these are.
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
        integer(c_int32_t) :: code
        integer(c_int64_t) :: out_dim
        type(c_ptr) :: made
        out_dim = size(matrix, 1, c_int64_t)
        made = c_null_ptr
        code = held(this%handle)
        if (code == NURBS_OK) code = fitting([fits(matrix, out_dim, dim_of(this%handle)), fits(translation, out_dim)])
        if (code == NURBS_OK) code = nurbs_transform(this%handle, int(out_dim), transpose(matrix), translation, made)
        call out%replace(made)
        call settle(code, status)
    end subroutine transform

    !> matrix(out_dim + 1, dim + 1)
    subroutine transform_projective(this, matrix, out, status)
        class(nurbs_spline), intent(in) :: this
        real(c_double), intent(in) :: matrix(:, :)
        type(nurbs_spline), intent(inout) :: out
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: out_dim
        type(c_ptr) :: made
        out_dim = size(matrix, 1, c_int64_t) - 1
        made = c_null_ptr
        code = held(this%handle)
        if (code == NURBS_OK) code = fitting([fits(matrix, out_dim + 1, dim_of(this%handle) + 1)])
        if (code == NURBS_OK) code = nurbs_transform_projective(this%handle, int(out_dim), transpose(matrix), made)
        call out%replace(made)
        call settle(code, status)
    end subroutine transform_projective

    ! Splines taken apart into lists, and joined again

    !> points(active * pieces, dim) and weights(active * pieces) of the polynomial pieces, one piece after the other,
    !> their domains(2, axes, pieces), and how many there are along each axis.
    subroutine bezier_pieces(this, points, weights, domains, piece_counts, status)
        class(nurbs_spline), intent(in) :: this
        real(c_double), allocatable, intent(inout) :: points(:, :), weights(:), domains(:, :, :)
        integer(c_int64_t), allocatable, intent(inout) :: piece_counts(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: active, axes, n
        real(c_double), allocatable :: points_c(:, :)
        active = active_of(this%handle)
        axes = axes_of(this%handle)
        n = 0
        code = nurbs_bezier_pieces(this%handle, 0_c_int64_t, count=n)
        if (code == NURBS_OK) then
            if (allocated(weights)) deallocate (weights)
            if (allocated(domains)) deallocate (domains)
            if (allocated(piece_counts)) deallocate (piece_counts)
            allocate (points_c(dim_of(this%handle), n * active), weights(n * active), domains(2, axes, n), &
                piece_counts(axes))
            code = nurbs_bezier_pieces(this%handle, n, points_c, weights, domains, piece_counts, n)
        end if
        if (code == NURBS_OK) points = transpose(points_c)
        call settle(code, status)
    end subroutine bezier_pieces

    !> This spline becomes the parts joined end to end, of which it is none.
    subroutine join(this, parts, axis, tolerance, flags, gap, status)
        class(nurbs_spline), intent(inout) :: this
        type(nurbs_spline), intent(in) :: parts(:)
        integer(c_int32_t), intent(in) :: axis
        real(c_double), intent(in), optional :: tolerance
        integer(c_int32_t), intent(in), optional :: flags
        real(c_double), intent(inout), optional :: gap
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        code = nurbs_join(size(parts, kind=c_int64_t), handles_of(parts), axis - 1, given(tolerance, 0d0), &
            given(flags, 0), gap, made)
        call this%replace(made)
        call settle(code, status)
    end subroutine join

    ! Derivatives with respect to data: collocation matrices, Bezier extraction, gradients

    !> Compressed sparse rows of what refine() does along the axis, all indices from 1.
    subroutine refinement_matrix(this, axis, knots, values, columns, row_pointers, status)
        class(nurbs_spline), intent(in) :: this
        integer(c_int32_t), intent(in) :: axis
        real(c_double), intent(in) :: knots(:)
        real(c_double), allocatable, intent(inout) :: values(:)
        integer(c_int64_t), allocatable, intent(inout) :: columns(:), row_pointers(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: count, entries
        count = size(knots, kind=c_int64_t)
        entries = 0
        code = nurbs_refinement_matrix(this%handle, axis - 1, count, knots, 0_c_int64_t, entries=entries)
        if (code == NURBS_OK) then
            if (allocated(values)) deallocate (values)
            if (allocated(columns)) deallocate (columns)
            if (allocated(row_pointers)) deallocate (row_pointers)
            allocate (values(entries), columns(entries), row_pointers(count_of(this%handle, axis - 1) + count + 1))
            code = nurbs_refinement_matrix(this%handle, axis - 1, count, knots, entries, values, columns, row_pointers)
        end if
        if (code == NURBS_OK) then
            columns = columns + 1
            row_pointers = row_pointers + 1
        end if
        call settle(code, status)
    end subroutine refinement_matrix
end module nurbs_splines
