! SPDX-License-Identifier: MIT
!> The type of curves, surfaces and volumes. Conventions: see the module nurbs.
module nurbs_splines
    use, intrinsic :: iso_c_binding
    use nurbs_constants
    use nurbs_c
    use nurbs_support
    use nurbs_handles
    implicit none
    private
    public :: derivative_slots

    !> A spline; an assignment makes another handle on the same data.
    type, extends(nurbs_handle), public :: nurbs_spline
    contains
        procedure :: create, create_homogeneous, create_short, create_multiplicities, create_bezier
        procedure :: with_points, eval_grid, eval_grid_derivs, rational_basis, iso, insert_knot
        procedure :: elevate, reverse, transpose_axes, reparametrize, transform, transform_projective
        procedure :: make_rational, to_homogeneous, from_homogeneous
        procedure :: refine, refine_uniform, refinement_matrix, split, extract, clamp, move_seam, join
        procedure, private :: hull_size_1, hull_size_n, eval_1, eval_n, eval_derivs_1, eval_derivs_n
        generic :: hull_size => hull_size_1, hull_size_n
        generic :: eval => eval_1, eval_n
        procedure :: eval_grid_f32, rational_collocation, bezier_extraction, eval_adjoint
        procedure, private :: eval_f32_1, eval_f32_n
        generic :: eval_f32 => eval_f32_1, eval_f32_n
        generic :: eval_derivs => eval_derivs_1, eval_derivs_n
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

    !> Columns of derivatives of orders 0 to `order`: binomial(order + axes, axes).
    integer(c_int64_t) function derivative_slots(axes, order, status)
        integer(c_int32_t), intent(in) :: axes, order
        integer(c_int32_t), intent(out), optional :: status
        derivative_slots = 0
        call settle(nurbs_derivative_slots(axes, order, derivative_slots), status)
    end function derivative_slots

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

    ! Evaluation

    subroutine hull_size_1(this, params, sizes, flags, status)
        class(nurbs_spline), intent(in) :: this
        real(c_double), intent(in) :: params(:)
        real(c_double), intent(inout) :: sizes(:)
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        code = batch_shape(this%handle, [size(params), 1], shape(sizes), shape(params))
        if (code == NURBS_OK) code = nurbs_hull_size(this%handle, size(params, kind=c_int64_t), params, &
            0_c_int64_t, 0_c_int64_t, sizes, 0_c_int64_t, bits(flags))
        call settle(code, status)
    end subroutine hull_size_1

    subroutine hull_size_n(this, params, sizes, flags, status)
        class(nurbs_spline), intent(in) :: this
        real(c_double), intent(in) :: params(:, :)
        real(c_double), intent(inout) :: sizes(:)
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        code = batch_shape(this%handle, shape(params), shape(sizes), [size(params, 1)])
        if (code == NURBS_OK) code = nurbs_hull_size(this%handle, size(params, 1, c_int64_t), params, &
            step(params), column(params), sizes, 0_c_int64_t, bits(flags))
        call settle(code, status)
    end subroutine hull_size_n

    !> points(n, dim) of a curve at params(n).
    subroutine eval_1(this, params, points, flags, status)
        class(nurbs_spline), intent(in) :: this
        real(c_double), intent(in) :: params(:)
        real(c_double), intent(inout) :: points(:, :)
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        code = batch_shape(this%handle, [size(params), 1], shape(points), [size(params), dim_of(this%handle)])
        if (code == NURBS_OK) code = nurbs_eval(this%handle, size(params, kind=c_int64_t), params, &
            0_c_int64_t, 0_c_int64_t, points, step(points), column(points), bits(flags))
        call settle(code, status)
    end subroutine eval_1

    !> points(n, dim) at params(n, axes).
    subroutine eval_n(this, params, points, flags, status)
        class(nurbs_spline), intent(in) :: this
        real(c_double), intent(in) :: params(:, :)
        real(c_double), intent(inout) :: points(:, :)
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        code = batch_shape(this%handle, shape(params), shape(points), [size(params, 1), dim_of(this%handle)])
        if (code == NURBS_OK) code = nurbs_eval(this%handle, size(params, 1, c_int64_t), params, &
            step(params), column(params), points, step(points), column(points), bits(flags))
        call settle(code, status)
    end subroutine eval_n

    !> points(n, dim) of a curve at params(n), rounded once to single precision.
    subroutine eval_f32_1(this, params, points, flags, status)
        class(nurbs_spline), intent(in) :: this
        real(c_double), intent(in) :: params(:)
        real(c_float), intent(inout) :: points(:, :)
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        code = batch_shape(this%handle, [size(params), 1], shape(points), [size(params), dim_of(this%handle)])
        if (code == NURBS_OK) code = nurbs_eval_f32(this%handle, size(params, kind=c_int64_t), params, &
            0_c_int64_t, 0_c_int64_t, points, step(points), column(points), bits(flags))
        call settle(code, status)
    end subroutine eval_f32_1

    !> points(n, dim) at params(n, axes), rounded once to single precision.
    subroutine eval_f32_n(this, params, points, flags, status)
        class(nurbs_spline), intent(in) :: this
        real(c_double), intent(in) :: params(:, :)
        real(c_float), intent(inout) :: points(:, :)
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        code = batch_shape(this%handle, shape(params), shape(points), [size(params, 1), dim_of(this%handle)])
        if (code == NURBS_OK) code = nurbs_eval_f32(this%handle, size(params, 1, c_int64_t), params, &
            step(params), column(params), points, step(points), column(points), bits(flags))
        call settle(code, status)
    end subroutine eval_f32_n

    !> derivs(n, dim, slots) of a curve at params(n).
    subroutine eval_derivs_1(this, order, params, derivs, flags, status)
        class(nurbs_spline), intent(in) :: this
        integer(c_int32_t), intent(in) :: order
        real(c_double), intent(in) :: params(:)
        real(c_double), intent(inout) :: derivs(:, :, :)
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        code = batch_shape(this%handle, [size(params), 1], shape(derivs), &
                           [size(params), dim_of(this%handle), slots_of(this%handle, order)])
        if (code == NURBS_OK) code = nurbs_eval_derivs(this%handle, order, size(params, kind=c_int64_t), &
            params, 0_c_int64_t, 0_c_int64_t, derivs, step(derivs), column(derivs), bits(flags))
        call settle(code, status)
    end subroutine eval_derivs_1

    !> derivs(n, dim, slots) at params(n, axes).
    subroutine eval_derivs_n(this, order, params, derivs, flags, status)
        class(nurbs_spline), intent(in) :: this
        integer(c_int32_t), intent(in) :: order
        real(c_double), intent(in) :: params(:, :)
        real(c_double), intent(inout) :: derivs(:, :, :)
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        code = batch_shape(this%handle, shape(params), shape(derivs), &
                           [size(params, 1), dim_of(this%handle), slots_of(this%handle, order)])
        if (code == NURBS_OK) code = nurbs_eval_derivs(this%handle, order, size(params, 1, c_int64_t), &
            params, step(params), column(params), derivs, step(derivs), column(derivs), bits(flags))
        call settle(code, status)
    end subroutine eval_derivs_n

    !> points(product(counts), dim) on the grid of counts(k) parameters on axis k; params holds those of the first
    !> axis, then those of the next.
    subroutine eval_grid(this, counts, params, points, flags, status)
        class(nurbs_spline), intent(in) :: this
        integer(c_int32_t), intent(in) :: counts(:)
        real(c_double), intent(in) :: params(:)
        real(c_double), intent(inout) :: points(:, :)
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        code = batch_shape(this%handle, [0, size(counts)], [size(params), shape(points)], &
                           [sum(counts), product(counts), dim_of(this%handle)])
        if (code == NURBS_OK) code = nurbs_eval_grid(this%handle, int(counts, c_int64_t), params, points, &
            step(points), column(points), bits(flags))
        call settle(code, status)
    end subroutine eval_grid

    !> derivs(product(counts), dim, slots) on a grid.
    subroutine eval_grid_derivs(this, order, counts, params, derivs, flags, status)
        class(nurbs_spline), intent(in) :: this
        integer(c_int32_t), intent(in) :: order, counts(:)
        real(c_double), intent(in) :: params(:)
        real(c_double), intent(inout) :: derivs(:, :, :)
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        code = batch_shape(this%handle, [0, size(counts)], [size(params), shape(derivs)], &
                           [sum(counts), product(counts), dim_of(this%handle), slots_of(this%handle, order)])
        if (code == NURBS_OK) code = nurbs_eval_grid_derivs(this%handle, order, int(counts, c_int64_t), &
            params, derivs, step(derivs), column(derivs), bits(flags))
        call settle(code, status)
    end subroutine eval_grid_derivs

    !> points(product(counts), dim) on a grid, rounded once to single precision.
    subroutine eval_grid_f32(this, counts, params, points, flags, status)
        class(nurbs_spline), intent(in) :: this
        integer(c_int32_t), intent(in) :: counts(:)
        real(c_double), intent(in) :: params(:)
        real(c_float), intent(inout) :: points(:, :)
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        code = batch_shape(this%handle, [0, size(counts)], [size(params), shape(points)], &
                           [sum(counts), product(counts), dim_of(this%handle)])
        if (code == NURBS_OK) code = nurbs_eval_grid_f32(this%handle, int(counts, c_int64_t), params, points, &
            step(points), column(points), bits(flags))
        call settle(code, status)
    end subroutine eval_grid_f32

    !> values(n, product of degree + 1) of the active points, which on axis k start at spans(:, k) - degree(k).
    subroutine rational_basis(this, params, spans, values, flags, status)
        class(nurbs_spline), intent(in) :: this
        real(c_double), intent(in) :: params(:, :)
        integer(c_int64_t), intent(inout) :: spans(:, :)
        real(c_double), intent(inout) :: values(:, :)
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code, active, k, p
        integer(c_int64_t) :: packed(size(params, 2), size(params, 1))
        active = 1
        do k = 0, size(params, 2) - 1
            code = nurbs_degree(this%handle, k, p)
            if (code == NURBS_OK) active = active * (p + 1)
        end do
        code = batch_shape(this%handle, shape(params), [shape(spans), shape(values)], &
                           [shape(params), size(params, 1), active])
        if (code == NURBS_OK) code = nurbs_rational_basis(this%handle, size(params, 1, c_int64_t), params, &
            step(params), column(params), packed, values, step(values), column(values), bits(flags))
        if (code == NURBS_OK) spans = transpose(packed) + 1
        call settle(code, status)
    end subroutine rational_basis

    ! Derivatives with respect to data

    !> Compressed sparse rows of the derivative `orders` of the rational basis functions, all indices from 1:
    !> values and columns of row i are those from row_pointers(i) to row_pointers(i + 1) - 1.
    subroutine rational_collocation(this, params, values, columns, row_pointers, orders, flags, status)
        class(nurbs_spline), intent(in) :: this
        real(c_double), intent(in) :: params(:, :)
        real(c_double), allocatable, intent(inout) :: values(:)
        integer(c_int64_t), allocatable, intent(inout) :: columns(:), row_pointers(:)
        integer(c_int32_t), intent(in), optional :: orders(:), flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n, entries
        n = size(params, 1, c_int64_t)
        code = batch_shape(this%handle, shape(params), [0], [0])
        if (present(orders)) then
            if (code == NURBS_OK .and. size(orders) /= size(params, 2)) code = shape_error
        end if
        if (code == NURBS_OK) code = nurbs_rational_collocation(this%handle, orders, n, params, step(params), &
            column(params), 0_c_int64_t, entries=entries, flags=bits(flags))
        if (code == NURBS_OK) then
            call make_sparse(entries, n, values, columns, row_pointers)
            code = nurbs_rational_collocation(this%handle, orders, n, params, step(params), column(params), &
                entries, values, columns, row_pointers, flags=bits(flags))
            columns = columns + 1
            row_pointers = row_pointers + 1
        end if
        call settle(code, status)
    end subroutine rational_collocation

    !> operators(degree + 1, degree + 1, spans): function firsts(e) - 1 + j on span e, from domains(1, e) to
    !> domains(2, e), is the sum over k of operators(k, j, e) times Bernstein polynomial k.
    subroutine bezier_extraction(this, axis, operators, firsts, domains, status)
        class(nurbs_spline), intent(in) :: this
        integer(c_int32_t), intent(in) :: axis
        real(c_double), allocatable, intent(inout) :: operators(:, :, :), domains(:, :)
        integer(c_int64_t), allocatable, intent(inout) :: firsts(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code, p
        integer(c_int64_t) :: spans, filled
        code = nurbs_bezier_extraction(this%handle, axis - 1, 0_c_int64_t, count=spans)
        if (code == NURBS_OK) code = nurbs_degree(this%handle, axis - 1, p)
        if (code == NURBS_OK) then
            if (allocated(operators)) deallocate (operators)
            if (allocated(firsts)) deallocate (firsts)
            if (allocated(domains)) deallocate (domains)
            allocate (operators(p + 1, p + 1, spans), firsts(spans), domains(2, spans))
            code = nurbs_bezier_extraction(this%handle, axis - 1, spans, operators, firsts, domains, filled)
            firsts = firsts + 1
        end if
        call settle(code, status)
    end subroutine bezier_extraction

    !> Gradients of a function of points and derivatives, from its cotangents(n, dim, slots) at params(n, axes).
    subroutine eval_adjoint(this, order, params, cotangents, grad_points, grad_weights, grad_params, flags, status)
        class(nurbs_spline), intent(in) :: this
        integer(c_int32_t), intent(in) :: order
        real(c_double), intent(in) :: params(:, :), cotangents(:, :, :)
        real(c_double), intent(inout) :: grad_points(:, :), grad_weights(:), grad_params(:, :)
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code, dim
        integer(c_int64_t) :: points
        code = sizes_of(this%handle, points, dim)
        if (code == NURBS_OK) code = batch_shape(this%handle, shape(params), &
            [shape(cotangents), shape(grad_points), size(grad_weights), shape(grad_params)], &
            [size(params, 1), dim, slots_of(this%handle, order), int(points), dim, int(points), shape(params)])
        if (code == NURBS_OK) code = nurbs_eval_adjoint(this%handle, order, size(params, 1, c_int64_t), &
            params, step(params), column(params), cotangents, step(cotangents), column(cotangents), &
            grad_points, step(grad_points), column(grad_points), grad_weights, 0_c_int64_t, grad_params, &
            step(grad_params), column(grad_params), bits(flags))
        call settle(code, status)
    end subroutine eval_adjoint

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
