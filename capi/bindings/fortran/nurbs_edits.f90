! SPDX-License-Identifier: MIT
! Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
!> Changes of weights and control points, and the smallest change that meets constraints. Control points count from 1,
!> the last axis fastest; params(axes) is a parameter. Conventions: see the module nurbs.
module nurbs_edits
    use, intrinsic :: iso_c_binding
    use nurbs_constants
    use nurbs_c, only: nurbs_pull_weight, nurbs_pull_weights, nurbs_set_weights, nurbs_weight_points, &
        nurbs_weight_cross_ratio, nurbs_weight_through, nurbs_pull_point, nurbs_most_influential, nurbs_insert_on_leg, &
        nurbs_insert_at_point, nurbs_constrain
    use nurbs_support
    use nurbs_calls
    use nurbs_splines
    implicit none
    private
    public :: pull_weight, pull_weights, set_weights, weight_points, weight_cross_ratio, weight_through, pull_point
    public :: most_influential, insert_on_leg, insert_at_point, constrain

contains

    ! Changes of weights and control points, and knots that make points of the polygon control points

    !> A weight changed so that the point at a parameter moves by a distance towards the control point.
    subroutine pull_weight(g, index, params, distance, out, weight, status)
        class(nurbs_spline), intent(in) :: g
        integer(c_int32_t), intent(in) :: index
        real(c_double), intent(in) :: params(:), distance
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(inout), optional :: weight
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        made = c_null_ptr
        code = fitting([fits(params, axes_of(g%handle))])
        if (code == NURBS_OK) code = nurbs_pull_weight(g%handle, index - 1_c_int64_t, params, distance, weight, made)
        call out%replace(made)
        call settle(code, status)
    end subroutine pull_weight

    !> Several weights multiplied by one factor, so that the point moves towards their common centre.
    subroutine pull_weights(g, indices, params, distance, out, factor, status)
        class(nurbs_spline), intent(in) :: g
        integer(c_int32_t), intent(in) :: indices(:)
        real(c_double), intent(in) :: params(:), distance
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(inout), optional :: factor
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        made = c_null_ptr
        code = fitting([fits(params, axes_of(g%handle))])
        if (code == NURBS_OK) code = nurbs_pull_weights(g%handle, size(indices, kind=c_int64_t), indices - &
            1_c_int64_t, params, distance, factor, made)
        call out%replace(made)
        call settle(code, status)
    end subroutine pull_weights

    !> The weights of some control points set.
    subroutine set_weights(g, indices, weights, out, status)
        class(nurbs_spline), intent(in) :: g
        integer(c_int32_t), intent(in) :: indices(:)
        real(c_double), intent(in) :: weights(:)
        type(nurbs_spline), intent(inout) :: out
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: count
        type(c_ptr) :: made
        count = size(indices, kind=c_int64_t)
        made = c_null_ptr
        code = fitting([fits(weights, count)])
        if (code == NURBS_OK) code = nurbs_set_weights(g%handle, count, indices - 1_c_int64_t, weights, made)
        call out%replace(made)
        call settle(code, status)
    end subroutine set_weights

    !> The points (dim) at a parameter for the weights 0, 1 and the present one.
    subroutine weight_points(g, index, params, at_zero, at_one, at_weight, status)
        class(nurbs_spline), intent(in) :: g
        integer(c_int32_t), intent(in) :: index
        real(c_double), intent(in) :: params(:)
        real(c_double), intent(inout), optional :: at_zero(:), at_one(:), at_weight(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: dim
        dim = dim_of(g%handle)
        code = fitting([fits(params, axes_of(g%handle)), fits(at_zero, dim), fits(at_one, dim), fits(at_weight, dim)])
        if (code == NURBS_OK) code = nurbs_weight_points(g%handle, index - 1_c_int64_t, params, at_zero, at_one, &
            at_weight)
        call settle(code, status)
    end subroutine weight_points

    !> The weight from a control point and these three points.
    subroutine weight_cross_ratio(control_point, at_zero, at_one, at_weight, weight, status)
        real(c_double), intent(in) :: control_point(:), at_zero(:), at_one(:), at_weight(:)
        real(c_double), intent(inout) :: weight
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: dim
        dim = size(control_point, kind=c_int64_t)
        code = fitting([fits(at_zero, dim), fits(at_one, dim), fits(at_weight, dim)])
        if (code == NURBS_OK) code = nurbs_weight_cross_ratio(int(dim), control_point, at_zero, at_one, at_weight, &
            weight)
        call settle(code, status)
    end subroutine weight_cross_ratio

    !> A weight set so that the point at a parameter becomes the target(dim).
    subroutine weight_through(g, index, params, target, tolerance, out, weight, status)
        class(nurbs_spline), intent(in) :: g
        integer(c_int32_t), intent(in) :: index
        real(c_double), intent(in) :: params(:), target(:), tolerance
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(inout), optional :: weight
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        made = c_null_ptr
        code = fitting([fits(params, axes_of(g%handle)), fits(target, dim_of(g%handle))])
        if (code == NURBS_OK) code = nurbs_weight_through(g%handle, index - 1_c_int64_t, params, target, tolerance, &
            weight, made)
        call out%replace(made)
        call settle(code, status)
    end subroutine weight_through

    !> A control point moved so that the point at a parameter moves by a distance along a direction(dim).
    subroutine pull_point(g, index, params, direction, distance, out, moved, status)
        class(nurbs_spline), intent(in) :: g
        integer(c_int32_t), intent(in) :: index
        real(c_double), intent(in) :: params(:), direction(:), distance
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(inout), optional :: moved
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        made = c_null_ptr
        code = fitting([fits(params, axes_of(g%handle)), fits(direction, dim_of(g%handle))])
        if (code == NURBS_OK) code = nurbs_pull_point(g%handle, index - 1_c_int64_t, params, direction, distance, &
            moved, made)
        call out%replace(made)
        call settle(code, status)
    end subroutine pull_point

    !> The control points indices(n) that act most at params(n, axes), and their influences(n).
    subroutine most_influential(g, params, indices, influences, status)
        class(nurbs_spline), intent(in) :: g
        real(c_double), intent(in) :: params(:, :)
        integer(c_int32_t), intent(inout) :: indices(:)
        real(c_double), intent(inout), optional :: influences(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        integer(c_int64_t), allocatable :: indices_c(:)
        n = size(params, 1, c_int64_t)
        allocate (indices_c(n))
        code = fitting([fits(params, n, axes_of(g%handle)), fits(indices, n), fits(influences, n)])
        if (code == NURBS_OK) code = nurbs_most_influential(g%handle, n, params, step(params), column(params), &
            indices_c, influences)
        if (code == NURBS_OK) indices = int(indices_c) + 1
        call settle(code, status)
    end subroutine most_influential

    !> The knot inserted that makes a point of a leg of the control polygon, which starts at control point `index`, one
    !> itself.
    subroutine insert_on_leg(g, axis, index, ratio, out, knot, status)
        class(nurbs_spline), intent(in) :: g
        integer(c_int32_t), intent(in) :: axis, index
        real(c_double), intent(in) :: ratio
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(inout), optional :: knot
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        code = nurbs_insert_on_leg(g%handle, axis - 1, index - 1_c_int64_t, ratio, knot, made)
        call out%replace(made)
        call settle(code, status)
    end subroutine insert_on_leg

    !> The same for the point on the leg that is nearest to point(dim).
    subroutine insert_at_point(g, axis, point, tolerance, out, index, ratio, knot, status)
        class(nurbs_spline), intent(in) :: g
        integer(c_int32_t), intent(in) :: axis
        real(c_double), intent(in) :: point(:), tolerance
        type(nurbs_spline), intent(inout) :: out
        integer(c_int32_t), intent(inout), optional :: index
        real(c_double), intent(inout), optional :: ratio, knot
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: index_c
        type(c_ptr) :: made
        made = c_null_ptr
        code = fitting([fits(point, dim_of(g%handle))])
        if (code == NURBS_OK) code = nurbs_insert_at_point(g%handle, axis - 1, point, tolerance, index_c, ratio, knot, &
            made)
        if (code == NURBS_OK) then
            if (present(index)) index = int(index_c) + 1
        end if
        call out%replace(made)
        call settle(code, status)
    end subroutine insert_at_point

    ! The smallest change that makes a shape meet constraints

    !> The smallest change by which constraints hold at params(n, axes) with targets(n, dim). kinds(n): NURBS_CONSTRAIN_
    !> constants, absent: values; orders(n, axes) of derivatives; keep(1, k) and keep(2, k): order of the derivatives
    !> that stay at the start and end of axis k; costs and weight_costs: one for each control point.
    subroutine constrain(g, params, targets, out, kinds, orders, keep, costs, weight_costs, tolerance, residuals, &
            rank, moved, optimality, status, call)
        class(nurbs_spline), intent(in) :: g
        real(c_double), intent(in) :: params(:, :), targets(:, :)
        type(nurbs_spline), intent(inout) :: out
        integer(c_int32_t), intent(in), optional :: kinds(:), orders(:, :), keep(:, :)
        real(c_double), intent(in), optional :: costs(:), weight_costs(:), tolerance
        real(c_double), intent(inout), optional :: residuals(:), moved, optimality
        integer(c_int64_t), intent(inout), optional :: rank
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        integer(c_int64_t) :: count, axes, points_n
        integer(c_int32_t), allocatable :: orders_c(:, :)
        type(c_ptr) :: made
        count = size(params, 1, c_int64_t)
        axes = axes_of(g%handle)
        points_n = points_of(g%handle)
        made = c_null_ptr
        code = held(g%handle)
        if (code == NURBS_OK) code = fitting([fits(params, count, axes), fits(targets, count, dim_of(g%handle)), &
            fits(kinds, count), fits(orders, count, axes), fits(keep, 2_c_int64_t, axes), fits(costs, points_n), &
            fits(weight_costs, points_n), fits(residuals, count)])
        if (present(orders)) orders_c = transpose(orders)
        if (code == NURBS_OK) then
            if (present(call)) then
                code = constrain_watched(g%handle, count, kinds, orders_c, transpose(params), transpose(targets), &
                    keep, costs, weight_costs, given(tolerance, 0d0), residuals, rank, moved, optimality, &
                    watched(call), made)
            else
                code = nurbs_constrain(g%handle, count, kinds, orders_c, transpose(params), transpose(targets), keep, &
                    costs, weight_costs, given(tolerance, 0d0), residuals, rank, moved, optimality, made)
            end if
        end if
        call out%replace(made)
        call settle(code, status)
    end subroutine constrain
end module nurbs_edits
