! SPDX-License-Identifier: MIT
! Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
!> What splines are evaluated to: points, derivatives, grids, basis functions and their adjoints. Conventions: see the
!> module nurbs.
module nurbs_evaluation
    use, intrinsic :: iso_c_binding
    use nurbs_constants
    use nurbs_c, only: nurbs_hull_size, nurbs_derivative_slots, nurbs_eval, nurbs_eval_derivs, nurbs_eval_grid, &
        nurbs_eval_grid_derivs, nurbs_eval_f32, nurbs_eval_grid_f32, nurbs_rational_basis, nurbs_basis_gradients, &
        nurbs_rational_collocation, nurbs_bezier_extraction, nurbs_eval_adjoint, nurbs_eval_adjoint_knots, &
        nurbs_closest_adjoint, nurbs_length_adjoint
    use nurbs_support
    use nurbs_inspection
    implicit none
    private
    public :: derivative_slots

    !> A handle that can be evaluated.
    type, extends(nurbs_inspected), public :: nurbs_shape
    contains
        procedure :: eval_grid, eval_grid_derivs, eval_grid_f32, rational_basis, basis_gradients, rational_collocation
        procedure :: bezier_extraction, eval_adjoint, eval_adjoint_knots, closest_adjoint, length_adjoint
        procedure, private :: hull_size_1, hull_size_n, eval_1, eval_n, eval_derivs_1, eval_derivs_n, eval_f32_1
        procedure, private :: eval_f32_n
        generic :: hull_size => hull_size_1, hull_size_n
        generic :: eval => eval_1, eval_n
        generic :: eval_derivs => eval_derivs_1, eval_derivs_n
        generic :: eval_f32 => eval_f32_1, eval_f32_n
    end type nurbs_shape

contains

    ! Questions about a spline

    !> The `hull` of the accuracy contract at params(n) of a curve.
    subroutine hull_size_1(this, params, sizes, flags, status)
        class(nurbs_shape), intent(in) :: this
        real(c_double), intent(in) :: params(:)
        real(c_double), intent(inout) :: sizes(:)
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        n = size(params, kind=c_int64_t)
        code = held(this%handle)
        if (code == NURBS_OK) code = fitting([fits(sizes, n), axes_of(this%handle) == 1])
        if (code == NURBS_OK) code = nurbs_hull_size(this%handle, n, params, step(params), column(params), sizes, &
            0_c_int64_t, given(flags, 0))
        call settle(code, status)
    end subroutine hull_size_1

    !> The `hull` of the accuracy contract at params(n, axes).
    subroutine hull_size_n(this, params, sizes, flags, status)
        class(nurbs_shape), intent(in) :: this
        real(c_double), intent(in) :: params(:, :)
        real(c_double), intent(inout) :: sizes(:)
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        n = size(params, 1, c_int64_t)
        code = held(this%handle)
        if (code == NURBS_OK) code = fitting([fits(params, n, axes_of(this%handle)), fits(sizes, n)])
        if (code == NURBS_OK) code = nurbs_hull_size(this%handle, n, params, step(params), column(params), sizes, &
            0_c_int64_t, given(flags, 0))
        call settle(code, status)
    end subroutine hull_size_n

    ! Evaluation

    !> Columns of derivatives of orders 0 to `order`: binomial(order + axes, axes).
    integer(c_int64_t) function derivative_slots(axes, order, status) result(value)
        integer(c_int32_t), intent(in) :: axes, order
        integer(c_int32_t), intent(out), optional :: status
        value = 0
        call settle(nurbs_derivative_slots(axes, order, value), status)
    end function derivative_slots

    !> points(n, dim) of a curve at params(n).
    subroutine eval_1(this, params, points, flags, status)
        class(nurbs_shape), intent(in) :: this
        real(c_double), intent(in) :: params(:)
        real(c_double), intent(inout) :: points(:, :)
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        n = size(params, kind=c_int64_t)
        code = held(this%handle)
        if (code == NURBS_OK) code = fitting([fits(points, n, dim_of(this%handle)), axes_of(this%handle) == 1])
        if (code == NURBS_OK) code = nurbs_eval(this%handle, n, params, step(params), column(params), points, &
            step(points), column(points), given(flags, 0))
        call settle(code, status)
    end subroutine eval_1

    !> points(n, dim) at params(n, axes).
    subroutine eval_n(this, params, points, flags, status)
        class(nurbs_shape), intent(in) :: this
        real(c_double), intent(in) :: params(:, :)
        real(c_double), intent(inout) :: points(:, :)
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        n = size(params, 1, c_int64_t)
        code = held(this%handle)
        if (code == NURBS_OK) code = fitting([fits(params, n, axes_of(this%handle)), &
            fits(points, n, dim_of(this%handle))])
        if (code == NURBS_OK) code = nurbs_eval(this%handle, n, params, step(params), column(params), points, &
            step(points), column(points), given(flags, 0))
        call settle(code, status)
    end subroutine eval_n

    !> derivs(n, dim, slots) of a curve at params(n).
    subroutine eval_derivs_1(this, order, params, derivs, flags, status)
        class(nurbs_shape), intent(in) :: this
        integer(c_int32_t), intent(in) :: order
        real(c_double), intent(in) :: params(:)
        real(c_double), intent(inout) :: derivs(:, :, :)
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        n = size(params, kind=c_int64_t)
        code = held(this%handle)
        if (code == NURBS_OK) code = fitting([fits(derivs, n, dim_of(this%handle), slots_of(this%handle, order)), &
            axes_of(this%handle) == 1])
        if (code == NURBS_OK) code = nurbs_eval_derivs(this%handle, order, n, params, step(params), column(params), &
            derivs, step(derivs), column(derivs), given(flags, 0))
        call settle(code, status)
    end subroutine eval_derivs_1

    !> derivs(n, dim, slots) at params(n, axes).
    subroutine eval_derivs_n(this, order, params, derivs, flags, status)
        class(nurbs_shape), intent(in) :: this
        integer(c_int32_t), intent(in) :: order
        real(c_double), intent(in) :: params(:, :)
        real(c_double), intent(inout) :: derivs(:, :, :)
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        n = size(params, 1, c_int64_t)
        code = held(this%handle)
        if (code == NURBS_OK) code = fitting([fits(params, n, axes_of(this%handle)), &
            fits(derivs, n, dim_of(this%handle), slots_of(this%handle, order))])
        if (code == NURBS_OK) code = nurbs_eval_derivs(this%handle, order, n, params, step(params), column(params), &
            derivs, step(derivs), column(derivs), given(flags, 0))
        call settle(code, status)
    end subroutine eval_derivs_n

    !> points(product(counts), dim) on the grid of counts(k) parameters on axis k; params holds those of the first axis,
    !> then those of the next.
    subroutine eval_grid(this, counts, params, points, flags, status)
        class(nurbs_shape), intent(in) :: this
        integer(c_int32_t), intent(in) :: counts(:)
        real(c_double), intent(in) :: params(:)
        real(c_double), intent(inout) :: points(:, :)
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        code = held(this%handle)
        if (code == NURBS_OK) code = fitting([fits(counts, axes_of(this%handle)), &
            fits(params, sum(int(counts, c_int64_t))), fits(points, product(int(counts, c_int64_t)), &
            dim_of(this%handle))])
        if (code == NURBS_OK) code = nurbs_eval_grid(this%handle, int(counts, c_int64_t), params, points, &
            step(points), column(points), given(flags, 0))
        call settle(code, status)
    end subroutine eval_grid

    !> derivs(product(counts), dim, slots) on a grid.
    subroutine eval_grid_derivs(this, order, counts, params, derivs, flags, status)
        class(nurbs_shape), intent(in) :: this
        integer(c_int32_t), intent(in) :: order, counts(:)
        real(c_double), intent(in) :: params(:)
        real(c_double), intent(inout) :: derivs(:, :, :)
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        code = held(this%handle)
        if (code == NURBS_OK) code = fitting([fits(counts, axes_of(this%handle)), &
            fits(params, sum(int(counts, c_int64_t))), fits(derivs, product(int(counts, c_int64_t)), &
            dim_of(this%handle), slots_of(this%handle, order))])
        if (code == NURBS_OK) code = nurbs_eval_grid_derivs(this%handle, order, int(counts, c_int64_t), params, &
            derivs, step(derivs), column(derivs), given(flags, 0))
        call settle(code, status)
    end subroutine eval_grid_derivs

    !> points(n, dim) of a curve at params(n), rounded once to single precision.
    subroutine eval_f32_1(this, params, points, flags, status)
        class(nurbs_shape), intent(in) :: this
        real(c_double), intent(in) :: params(:)
        real(c_float), intent(inout) :: points(:, :)
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        n = size(params, kind=c_int64_t)
        code = held(this%handle)
        if (code == NURBS_OK) code = fitting([fits(points, n, dim_of(this%handle)), axes_of(this%handle) == 1])
        if (code == NURBS_OK) code = nurbs_eval_f32(this%handle, n, params, step(params), column(params), points, &
            step(points), column(points), given(flags, 0))
        call settle(code, status)
    end subroutine eval_f32_1

    !> points(n, dim) at params(n, axes), rounded once to single precision.
    subroutine eval_f32_n(this, params, points, flags, status)
        class(nurbs_shape), intent(in) :: this
        real(c_double), intent(in) :: params(:, :)
        real(c_float), intent(inout) :: points(:, :)
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        n = size(params, 1, c_int64_t)
        code = held(this%handle)
        if (code == NURBS_OK) code = fitting([fits(params, n, axes_of(this%handle)), &
            fits(points, n, dim_of(this%handle))])
        if (code == NURBS_OK) code = nurbs_eval_f32(this%handle, n, params, step(params), column(params), points, &
            step(points), column(points), given(flags, 0))
        call settle(code, status)
    end subroutine eval_f32_n

    !> points(product(counts), dim) on a grid, rounded once to single precision.
    subroutine eval_grid_f32(this, counts, params, points, flags, status)
        class(nurbs_shape), intent(in) :: this
        integer(c_int32_t), intent(in) :: counts(:)
        real(c_double), intent(in) :: params(:)
        real(c_float), intent(inout) :: points(:, :)
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        code = held(this%handle)
        if (code == NURBS_OK) code = fitting([fits(counts, axes_of(this%handle)), &
            fits(params, sum(int(counts, c_int64_t))), fits(points, product(int(counts, c_int64_t)), &
            dim_of(this%handle))])
        if (code == NURBS_OK) code = nurbs_eval_grid_f32(this%handle, int(counts, c_int64_t), params, points, &
            step(points), column(points), given(flags, 0))
        call settle(code, status)
    end subroutine eval_grid_f32

    !> values(n, product of degree + 1) of the active points, which on axis k start at spans(:, k) - degree(k).
    subroutine rational_basis(this, params, spans, values, flags, status)
        class(nurbs_shape), intent(in) :: this
        real(c_double), intent(in) :: params(:, :)
        integer(c_int64_t), intent(inout) :: spans(:, :)
        real(c_double), intent(inout) :: values(:, :)
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n, axes
        integer(c_int64_t), allocatable :: spans_c(:, :)
        n = size(params, 1, c_int64_t)
        axes = axes_of(this%handle)
        allocate (spans_c(axes, n))
        code = held(this%handle)
        if (code == NURBS_OK) code = fitting([fits(params, n, axes), fits(spans, n, axes), &
            fits(values, n, active_of(this%handle))])
        if (code == NURBS_OK) code = nurbs_rational_basis(this%handle, n, params, step(params), column(params), &
            spans_c, values, step(values), column(values), given(flags, 0))
        if (code == NURBS_OK) spans = transpose(spans_c) + 1
        call settle(code, status)
    end subroutine rational_basis

    !> gradients(n, dim, product of degree + 1) of the active points, which on axis k start at spans(:, k) - degree(k).
    subroutine basis_gradients(this, params, spans, gradients, flags, status)
        class(nurbs_shape), intent(in) :: this
        real(c_double), intent(in) :: params(:, :)
        integer(c_int64_t), intent(inout) :: spans(:, :)
        real(c_double), intent(inout) :: gradients(:, :, :)
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n, axes
        integer(c_int64_t), allocatable :: spans_c(:, :)
        n = size(params, 1, c_int64_t)
        axes = axes_of(this%handle)
        allocate (spans_c(axes, n))
        code = held(this%handle)
        if (code == NURBS_OK) code = fitting([fits(params, n, axes), fits(spans, n, axes), &
            fits(gradients, n, dim_of(this%handle), active_of(this%handle))])
        if (code == NURBS_OK) code = nurbs_basis_gradients(this%handle, n, params, step(params), column(params), &
            spans_c, gradients, step(gradients), column(gradients), given(flags, 0))
        if (code == NURBS_OK) spans = transpose(spans_c) + 1
        call settle(code, status)
    end subroutine basis_gradients

    ! Derivatives with respect to data: collocation matrices, Bezier extraction, gradients

    !> Compressed sparse rows of the derivative `orders` of the rational basis functions, all indices from 1: values and
    !> columns of row i are those from row_pointers(i) to row_pointers(i + 1) - 1.
    subroutine rational_collocation(this, params, values, columns, row_pointers, orders, flags, status)
        class(nurbs_shape), intent(in) :: this
        real(c_double), intent(in) :: params(:, :)
        real(c_double), allocatable, intent(inout) :: values(:)
        integer(c_int64_t), allocatable, intent(inout) :: columns(:), row_pointers(:)
        integer(c_int32_t), intent(in), optional :: orders(:), flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n, axes, entries
        n = size(params, 1, c_int64_t)
        axes = axes_of(this%handle)
        entries = 0
        code = held(this%handle)
        if (code == NURBS_OK) code = fitting([fits(params, n, axes), fits(orders, axes)])
        if (code == NURBS_OK) code = nurbs_rational_collocation(this%handle, orders, n, params, step(params), &
            column(params), 0_c_int64_t, entries=entries, flags=given(flags, 0))
        if (code == NURBS_OK) then
            if (allocated(values)) deallocate (values)
            if (allocated(columns)) deallocate (columns)
            if (allocated(row_pointers)) deallocate (row_pointers)
            allocate (values(entries), columns(entries), row_pointers(n + 1))
            code = nurbs_rational_collocation(this%handle, orders, n, params, step(params), column(params), entries, &
                values, columns, row_pointers, flags=given(flags, 0))
        end if
        if (code == NURBS_OK) then
            columns = columns + 1
            row_pointers = row_pointers + 1
        end if
        call settle(code, status)
    end subroutine rational_collocation

    !> operators(degree + 1, degree + 1, spans): function firsts(e) - 1 + j on span e, from domains(1, e) to domains(2,
    !> e), is the sum over k of operators(k, j, e) times Bernstein polynomial k.
    subroutine bezier_extraction(this, axis, operators, firsts, domains, status)
        class(nurbs_shape), intent(in) :: this
        integer(c_int32_t), intent(in) :: axis
        real(c_double), allocatable, intent(inout) :: operators(:, :, :), domains(:, :)
        integer(c_int64_t), allocatable, intent(inout) :: firsts(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: degree_axis, n
        degree_axis = degree_of(this%handle, axis - 1)
        n = 0
        code = nurbs_bezier_extraction(this%handle, axis - 1, 0_c_int64_t, count=n)
        if (code == NURBS_OK) then
            if (allocated(operators)) deallocate (operators)
            if (allocated(firsts)) deallocate (firsts)
            if (allocated(domains)) deallocate (domains)
            allocate (operators(degree_axis + 1, degree_axis + 1, n), firsts(n), domains(2, n))
            code = nurbs_bezier_extraction(this%handle, axis - 1, n, operators, firsts, domains, n)
        end if
        if (code == NURBS_OK) firsts = firsts + 1
        call settle(code, status)
    end subroutine bezier_extraction

    !> Gradients of a function of points and derivatives, from its cotangents(n, dim, slots) at params(n, axes).
    subroutine eval_adjoint(this, order, params, cotangents, grad_points, grad_weights, grad_params, flags, status)
        class(nurbs_shape), intent(in) :: this
        integer(c_int32_t), intent(in) :: order
        real(c_double), intent(in) :: params(:, :), cotangents(:, :, :)
        real(c_double), intent(inout) :: grad_points(:, :), grad_weights(:), grad_params(:, :)
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n, axes, dim, points_n
        n = size(params, 1, c_int64_t)
        axes = axes_of(this%handle)
        dim = dim_of(this%handle)
        points_n = points_of(this%handle)
        code = held(this%handle)
        if (code == NURBS_OK) code = fitting([fits(params, n, axes), &
            fits(cotangents, n, dim, slots_of(this%handle, order)), fits(grad_points, points_n, dim), &
            fits(grad_weights, points_n), fits(grad_params, n, axes)])
        if (code == NURBS_OK) code = nurbs_eval_adjoint(this%handle, order, n, params, step(params), column(params), &
            cotangents, step(cotangents), column(cotangents), grad_points, step(grad_points), column(grad_points), &
            grad_weights, 0_c_int64_t, grad_params, step(grad_params), column(grad_params), given(flags, 0))
        call settle(code, status)
    end subroutine eval_adjoint

    !> Gradients with respect to the knots of an axis of a function of points and derivatives, from its cotangents(n,
    !> dim, slots) at params(n, axes).
    subroutine eval_adjoint_knots(this, axis, order, params, cotangents, grad_knots, flags, status)
        class(nurbs_shape), intent(in) :: this
        integer(c_int32_t), intent(in) :: axis, order
        real(c_double), intent(in) :: params(:, :), cotangents(:, :, :)
        real(c_double), intent(inout) :: grad_knots(:)
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        n = size(params, 1, c_int64_t)
        code = held(this%handle)
        if (code == NURBS_OK) code = fitting([fits(params, n, axes_of(this%handle)), &
            fits(cotangents, n, dim_of(this%handle), slots_of(this%handle, order)), &
            fits(grad_knots, count_of(this%handle, axis - 1) + degree_of(this%handle, axis - 1) + 1)])
        if (code == NURBS_OK) code = nurbs_eval_adjoint_knots(this%handle, axis - 1, order, n, params, step(params), &
            column(params), cotangents, step(cotangents), column(cotangents), grad_knots, given(flags, 0))
        call settle(code, status)
    end subroutine eval_adjoint_knots

    !> Gradients through the closest points of query points, whose parameters are given, from cotangents of parameters,
    !> points and distances; empty ones are 0.
    subroutine closest_adjoint(this, points, params, param_cotangents, foot_cotangents, distance_cotangents, &
            grad_points, grad_weights, grad_queries, states, flags, status)
        class(nurbs_shape), intent(in) :: this
        real(c_double), intent(in) :: points(:, :), params(:, :)
        real(c_double), intent(in), optional :: param_cotangents(:, :), foot_cotangents(:, :), distance_cotangents(:)
        real(c_double), intent(inout), optional :: grad_points(:, :), grad_weights(:), grad_queries(:, :)
        integer(c_int32_t), intent(inout), optional :: states(:)
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n, dim, axes, points_n
        real(c_double), allocatable :: param_cotangents_c(:, :), foot_cotangents_c(:, :), grad_points_c(:, :)
        real(c_double), allocatable :: grad_queries_c(:, :)
        n = size(points, 1, c_int64_t)
        dim = dim_of(this%handle)
        axes = axes_of(this%handle)
        points_n = points_of(this%handle)
        allocate (grad_points_c(dim, points_n), grad_queries_c(dim, n))
        code = held(this%handle)
        if (code == NURBS_OK) code = fitting([fits(points, n, dim), fits(params, n, axes), &
            fits(param_cotangents, n, axes), fits(foot_cotangents, n, dim), fits(distance_cotangents, n), &
            fits(grad_points, points_n, dim), fits(grad_weights, points_n), fits(grad_queries, n, dim), &
            fits(states, n)])
        if (present(param_cotangents)) param_cotangents_c = transpose(param_cotangents)
        if (present(foot_cotangents)) foot_cotangents_c = transpose(foot_cotangents)
        if (code == NURBS_OK) code = nurbs_closest_adjoint(this%handle, n, transpose(points), transpose(params), &
            param_cotangents_c, foot_cotangents_c, distance_cotangents, grad_points_c, grad_weights, grad_queries_c, &
            states, given(flags, 0))
        if (code == NURBS_OK) then
            if (present(grad_points)) grad_points = transpose(grad_points_c)
            if (present(grad_queries)) grad_queries = transpose(grad_queries_c)
        end if
        call settle(code, status)
    end subroutine closest_adjoint

    !> Gradients of the length of a curve over a range [2] of its domain, or all of it.
    subroutine length_adjoint(this, relative_tolerance, cotangent, grad_points, grad_weights, error, range, flags, &
            status)
        class(nurbs_shape), intent(in) :: this
        real(c_double), intent(in) :: relative_tolerance, cotangent
        real(c_double), intent(inout), optional :: grad_points(:, :), grad_weights(:), error
        real(c_double), intent(in), optional :: range(2)
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: points_n
        points_n = points_of(this%handle)
        code = held(this%handle)
        if (code == NURBS_OK) code = fitting([fits(grad_points, points_n, dim_of(this%handle)), &
            fits(grad_weights, points_n)])
        if (code == NURBS_OK) code = nurbs_length_adjoint(this%handle, range, relative_tolerance, cotangent, &
            grad_points, step(grad_points), column(grad_points), grad_weights, 0_c_int64_t, error, given(flags, 0))
        call settle(code, status)
    end subroutine length_adjoint
end module nurbs_evaluation
