! SPDX-License-Identifier: MIT
!> What splines are evaluated to: points, derivatives, grids, basis functions and their adjoints.
module nurbs_evaluation
    use, intrinsic :: iso_c_binding
    use nurbs_constants
    use nurbs_c
    use nurbs_support
    use nurbs_handles
    implicit none
    private
    public :: derivative_slots

    !> A handle that can be evaluated. What extends it says what an assignment does.
    type, extends(nurbs_handle), public :: nurbs_shape
    contains
        procedure :: eval_grid, eval_grid_derivs, eval_grid_f32
        procedure :: rational_basis, rational_collocation, bezier_extraction, eval_adjoint
        procedure, private :: hull_size_1, hull_size_n, eval_1, eval_n, eval_f32_1, eval_f32_n
        procedure, private :: eval_derivs_1, eval_derivs_n
        generic :: hull_size => hull_size_1, hull_size_n
        generic :: eval => eval_1, eval_n
        generic :: eval_f32 => eval_f32_1, eval_f32_n
        generic :: eval_derivs => eval_derivs_1, eval_derivs_n
    end type nurbs_shape

contains

    !> Columns of derivatives of orders 0 to `order`: binomial(order + axes, axes).
    integer(c_int64_t) function derivative_slots(axes, order, status)
        integer(c_int32_t), intent(in) :: axes, order
        integer(c_int32_t), intent(out), optional :: status
        derivative_slots = 0
        call settle(nurbs_derivative_slots(axes, order, derivative_slots), status)
    end function derivative_slots

    subroutine hull_size_1(this, params, sizes, flags, status)
        class(nurbs_shape), intent(in) :: this
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
        class(nurbs_shape), intent(in) :: this
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
        class(nurbs_shape), intent(in) :: this
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
        class(nurbs_shape), intent(in) :: this
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
        class(nurbs_shape), intent(in) :: this
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
        class(nurbs_shape), intent(in) :: this
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
        class(nurbs_shape), intent(in) :: this
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
        class(nurbs_shape), intent(in) :: this
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
        class(nurbs_shape), intent(in) :: this
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
        class(nurbs_shape), intent(in) :: this
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
        class(nurbs_shape), intent(in) :: this
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
        class(nurbs_shape), intent(in) :: this
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
        class(nurbs_shape), intent(in) :: this
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
        class(nurbs_shape), intent(in) :: this
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
        class(nurbs_shape), intent(in) :: this
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

end module nurbs_evaluation
