! SPDX-License-Identifier: MIT
!> Changes of weights and control points, and the smallest change that meets constraints. Control points count from 1,
!> the last axis fastest; params(axes) is a parameter. Conventions: see the module nurbs.
module nurbs_edits
    use, intrinsic :: iso_c_binding
    use nurbs_constants
    use nurbs_c
    use nurbs_support
    use nurbs_splines
    use nurbs_placements, only: given, hand_over
    implicit none
    private
    public :: pull_weight, pull_weights, set_weights, weight_points, weight_cross_ratio, weight_through, pull_point
    public :: most_influential, insert_on_leg, insert_at_point, constrain

contains

    !> A weight changed so that the point at a parameter moves by a distance towards the control point.
    subroutine pull_weight(g, index, params, distance, out, weight, status)
        class(nurbs_spline), intent(in) :: g
        integer, intent(in) :: index
        real(c_double), intent(in) :: params(:), distance
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(inout), optional :: weight
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        made = c_null_ptr
        code = fitting([size(params) == axes_of(g%handle)])
        if (code == NURBS_OK) code = nurbs_pull_weight(g%handle, index - 1_c_int64_t, params, distance, weight, made)
        call hand_over(code, made, out, status)
    end subroutine pull_weight

    !> Several weights multiplied by one factor, so that the point moves towards their common centre.
    subroutine pull_weights(g, indices, params, distance, out, factor, status)
        class(nurbs_spline), intent(in) :: g
        integer, intent(in) :: indices(:)
        real(c_double), intent(in) :: params(:), distance
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(inout), optional :: factor
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        made = c_null_ptr
        code = fitting([size(params) == axes_of(g%handle)])
        if (code == NURBS_OK) code = nurbs_pull_weights(g%handle, size(indices, kind=c_int64_t), &
            indices - 1_c_int64_t, params, distance, factor, made)
        call hand_over(code, made, out, status)
    end subroutine pull_weights

    subroutine set_weights(g, indices, weights, out, status)
        class(nurbs_spline), intent(in) :: g
        integer, intent(in) :: indices(:)
        real(c_double), intent(in) :: weights(:)
        type(nurbs_spline), intent(inout) :: out
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        made = c_null_ptr
        code = fitting([size(weights) == size(indices)])
        if (code == NURBS_OK) code = nurbs_set_weights(g%handle, size(indices, kind=c_int64_t), indices - 1_c_int64_t, &
            weights, made)
        call hand_over(code, made, out, status)
    end subroutine set_weights

    !> The points (dim) at a parameter for the weights 0, 1 and the present one.
    subroutine weight_points(g, index, params, at_zero, at_one, at_weight, status)
        class(nurbs_spline), intent(in) :: g
        integer, intent(in) :: index
        real(c_double), intent(in) :: params(:)
        real(c_double), intent(inout), optional :: at_zero(:), at_one(:), at_weight(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: dim
        dim = dim_of(g%handle)
        code = fitting([size(params) == axes_of(g%handle), has_size(dim, at_zero), has_size(dim, at_one), &
                        has_size(dim, at_weight)])
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
        integer :: dim
        dim = size(control_point)
        code = fitting([size(at_zero) == dim, size(at_one) == dim, size(at_weight) == dim])
        if (code == NURBS_OK) code = nurbs_weight_cross_ratio(dim, control_point, at_zero, at_one, at_weight, weight)
        call settle(code, status)
    end subroutine weight_cross_ratio

    !> A weight set so that the point at a parameter becomes the target(dim).
    subroutine weight_through(g, index, params, target, tolerance, out, weight, status)
        class(nurbs_spline), intent(in) :: g
        integer, intent(in) :: index
        real(c_double), intent(in) :: params(:), target(:), tolerance
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(inout), optional :: weight
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        made = c_null_ptr
        code = fitting([size(params) == axes_of(g%handle), size(target) == dim_of(g%handle)])
        if (code == NURBS_OK) code = nurbs_weight_through(g%handle, index - 1_c_int64_t, params, target, tolerance, &
            weight, made)
        call hand_over(code, made, out, status)
    end subroutine weight_through

    !> A control point moved so that the point at a parameter moves by a distance along a direction(dim).
    subroutine pull_point(g, index, params, direction, distance, out, moved, status)
        class(nurbs_spline), intent(in) :: g
        integer, intent(in) :: index
        real(c_double), intent(in) :: params(:), direction(:), distance
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(inout), optional :: moved
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        made = c_null_ptr
        code = fitting([size(params) == axes_of(g%handle), size(direction) == dim_of(g%handle)])
        if (code == NURBS_OK) code = nurbs_pull_point(g%handle, index - 1_c_int64_t, params, direction, distance, &
            moved, made)
        call hand_over(code, made, out, status)
    end subroutine pull_point

    !> The control points indices(n) that act most at params(n, axes), and their influences(n).
    subroutine most_influential(g, params, indices, influences, status)
        class(nurbs_spline), intent(in) :: g
        real(c_double), intent(in) :: params(:, :)
        integer, intent(inout) :: indices(:)
        real(c_double), intent(inout), optional :: influences(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n, found(size(params, 1))
        n = size(params, 1, c_int64_t)
        code = fitting([size(params, 2) == axes_of(g%handle), size(indices) == n, has_size(n, influences)])
        if (code == NURBS_OK) code = nurbs_most_influential(g%handle, n, params, step(params), column(params), found, &
            influences)
        if (code == NURBS_OK) indices = int(found) + 1
        call settle(code, status)
    end subroutine most_influential

    !> The knot inserted that makes a point of a leg of the control polygon, which starts at control point `index`, one
    !> itself.
    subroutine insert_on_leg(g, axis, index, ratio, out, knot, status)
        class(nurbs_spline), intent(in) :: g
        integer(c_int32_t), intent(in) :: axis
        integer, intent(in) :: index
        real(c_double), intent(in) :: ratio
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(inout), optional :: knot
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        code = nurbs_insert_on_leg(g%handle, axis - 1, index - 1_c_int64_t, ratio, knot, made)
        call hand_over(code, made, out, status)
    end subroutine insert_on_leg

    !> The same for the point on the leg that is nearest to point(dim).
    subroutine insert_at_point(g, axis, point, tolerance, out, index, ratio, knot, status)
        class(nurbs_spline), intent(in) :: g
        integer(c_int32_t), intent(in) :: axis
        real(c_double), intent(in) :: point(:), tolerance
        type(nurbs_spline), intent(inout) :: out
        integer, intent(inout), optional :: index
        real(c_double), intent(inout), optional :: ratio, knot
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: leg
        type(c_ptr) :: made
        made = c_null_ptr
        code = fitting([size(point) == dim_of(g%handle)])
        if (code == NURBS_OK) code = nurbs_insert_at_point(g%handle, axis - 1, point, tolerance, leg, ratio, knot, made)
        if (present(index) .and. code == NURBS_OK) index = int(leg) + 1
        call hand_over(code, made, out, status)
    end subroutine insert_at_point

    !> The smallest change by which constraints hold at params(n, axes) with targets(n, dim). kinds(n): NURBS_CONSTRAIN_
    !> constants, absent: values; orders(n, axes) of derivatives; keep(1, k) and keep(2, k): order of the derivatives
    !> that stay at the start and end of axis k; costs and weight_costs: one for each control point.
    subroutine constrain(g, params, targets, out, kinds, orders, keep, costs, weight_costs, tolerance, residuals, &
                         rank, moved, optimality, status)
        class(nurbs_spline), intent(in) :: g
        real(c_double), intent(in) :: params(:, :), targets(:, :)
        type(nurbs_spline), intent(inout) :: out
        integer(c_int32_t), intent(in), optional :: kinds(:), orders(:, :), keep(:, :)
        real(c_double), intent(in), optional :: costs(:), weight_costs(:), tolerance
        real(c_double), intent(inout), optional :: residuals(:), moved, optimality
        integer(c_int64_t), intent(inout), optional :: rank
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t), allocatable :: rows(:, :)
        integer(c_int32_t) :: code, dim
        integer(c_int64_t) :: n, points
        type(c_ptr) :: made
        made = c_null_ptr
        n = size(params, 1, c_int64_t)
        code = sizes_of(g%handle, points, dim)
        if (code == NURBS_OK) code = fitting([has_shape(n, axes_of(g%handle), params), has_shape(n, dim, targets), &
            has_length(n, kinds), has_size(points, costs), has_size(points, weight_costs), has_size(n, residuals)])
        if (present(orders)) then
            rows = transpose(orders)
            if (any(shape(orders) /= shape(params))) code = shape_error
        end if
        if (present(keep)) then
            if (any(shape(keep) /= [2, axes_of(g%handle)])) code = shape_error
        end if
        if (code == NURBS_OK) code = nurbs_constrain(g%handle, n, kinds, rows, transpose(params), transpose(targets), &
            keep, costs, weight_costs, given(tolerance, 0d0), residuals, rank, moved, optimality, made)
        call hand_over(code, made, out, status)
    end subroutine constrain
end module nurbs_edits
