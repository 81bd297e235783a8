! SPDX-License-Identifier: MIT
! Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
!> Questions about a spline. Conventions: see the module nurbs.
module nurbs_inspection
    use, intrinsic :: iso_c_binding
    use nurbs_constants
    use nurbs_c, only: nurbs_axes, nurbs_dimension, nurbs_degree, nurbs_count, nurbs_point_count, nurbs_is_rational, &
        nurbs_is_homogeneous, nurbs_knot_form, nurbs_domain, nurbs_knots, nurbs_short_knots, nurbs_unwrapped_count, &
        nurbs_unwrapped_knots, nurbs_unwrapped_points, nurbs_distinct_knots, nurbs_greville, nurbs_points, &
        nurbs_weights, nurbs_homogeneous_points
    use nurbs_support
    use nurbs_handles
    implicit none
    private

    !> A handle that can be asked what it is.
    type, extends(nurbs_handle), public :: nurbs_inspected
    contains
        procedure :: axes, dimension => get_dimension, degree, count => get_count, point_count, is_rational
        procedure :: is_homogeneous, knot_form, domain, knots, short_knots, unwrapped_count, unwrapped_knots
        procedure :: unwrapped_points, distinct_knots, greville, points, weights, homogeneous_points
    end type nurbs_inspected

contains

    !> Number of parametric axes: 1, 2 or 3.
    integer(c_int32_t) function axes(this, status) result(value)
        class(nurbs_inspected), intent(in) :: this
        integer(c_int32_t), intent(out), optional :: status
        value = 0
        call settle(nurbs_axes(this%handle, value), status)
    end function axes

    !> Number of coordinates of a point.
    integer(c_int32_t) function get_dimension(this, status) result(value)
        class(nurbs_inspected), intent(in) :: this
        integer(c_int32_t), intent(out), optional :: status
        value = 0
        call settle(nurbs_dimension(this%handle, value), status)
    end function get_dimension

    !> Degree along an axis.
    integer(c_int32_t) function degree(this, axis, status) result(value)
        class(nurbs_inspected), intent(in) :: this
        integer(c_int32_t), intent(in) :: axis
        integer(c_int32_t), intent(out), optional :: status
        value = 0
        call settle(nurbs_degree(this%handle, axis - 1, value), status)
    end function degree

    !> Number of control points along an axis.
    integer(c_int64_t) function get_count(this, axis, status) result(value)
        class(nurbs_inspected), intent(in) :: this
        integer(c_int32_t), intent(in) :: axis
        integer(c_int32_t), intent(out), optional :: status
        value = 0
        call settle(nurbs_count(this%handle, axis - 1, value), status)
    end function get_count

    !> Number of control points of all axes together.
    integer(c_int64_t) function point_count(this, status) result(value)
        class(nurbs_inspected), intent(in) :: this
        integer(c_int32_t), intent(out), optional :: status
        value = 0
        call settle(nurbs_point_count(this%handle, value), status)
    end function point_count

    !> Whether it has weights.
    logical function is_rational(this, status) result(value)
        class(nurbs_inspected), intent(in) :: this
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: answer
        answer = 0
        call settle(nurbs_is_rational(this%handle, answer), status)
        value = answer /= 0
    end function is_rational

    !> Whether homogeneous points are stored, and not Cartesian ones with or without weights.
    logical function is_homogeneous(this, status) result(value)
        class(nurbs_inspected), intent(in) :: this
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: answer
        answer = 0
        call settle(nurbs_is_homogeneous(this%handle, answer), status)
        value = answer /= 0
    end function is_homogeneous

    !> Sum of NURBS_FORM_ bits.
    integer(c_int32_t) function knot_form(this, axis, status) result(value)
        class(nurbs_inspected), intent(in) :: this
        integer(c_int32_t), intent(in) :: axis
        integer(c_int32_t), intent(out), optional :: status
        value = 0
        call settle(nurbs_knot_form(this%handle, axis - 1, value), status)
    end function knot_form

    !> The ends of the domain of an axis.
    function domain(this, axis, status) result(value)
        class(nurbs_inspected), intent(in) :: this
        integer(c_int32_t), intent(in) :: axis
        integer(c_int32_t), intent(out), optional :: status
        real(c_double) :: value(2)
        value = 0
        call settle(nurbs_domain(this%handle, axis - 1, value), status)
    end function domain

    !> The full knot vector.
    subroutine knots(this, axis, values, status)
        class(nurbs_inspected), intent(in) :: this
        integer(c_int32_t), intent(in) :: axis
        real(c_double), allocatable, intent(out) :: values(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int64_t) :: knot_count_c
        knot_count_c = count_of(this%handle, axis - 1) + degree_of(this%handle, axis - 1) + 1
        allocate (values(knot_count_c))
        call settle(nurbs_knots(this%handle, axis - 1, knot_count_c, values), status)
    end subroutine knots

    !> The knot vector without its first and last knot.
    subroutine short_knots(this, axis, values, status)
        class(nurbs_inspected), intent(in) :: this
        integer(c_int32_t), intent(in) :: axis
        real(c_double), allocatable, intent(out) :: values(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        n = 0
        code = nurbs_short_knots(this%handle, axis - 1, 0_c_int64_t, count=n)
        allocate (values(n))
        if (code == NURBS_OK) code = nurbs_short_knots(this%handle, axis - 1, n, values)
        call settle(code, status)
    end subroutine short_knots

    !> Number of control points along an axis, each counted once.
    integer(c_int64_t) function unwrapped_count(this, axis, status) result(value)
        class(nurbs_inspected), intent(in) :: this
        integer(c_int32_t), intent(in) :: axis
        integer(c_int32_t), intent(out), optional :: status
        value = 0
        call settle(nurbs_unwrapped_count(this%handle, axis - 1, value), status)
    end function unwrapped_count

    !> The knots of one period with its end; of an axis that is not periodic all of them.
    subroutine unwrapped_knots(this, axis, values, status)
        class(nurbs_inspected), intent(in) :: this
        integer(c_int32_t), intent(in) :: axis
        real(c_double), allocatable, intent(out) :: values(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        n = 0
        code = nurbs_unwrapped_knots(this%handle, axis - 1, 0_c_int64_t, count=n)
        allocate (values(n))
        if (code == NURBS_OK) code = nurbs_unwrapped_knots(this%handle, axis - 1, n, values)
        call settle(code, status)
    end subroutine unwrapped_knots

    !> Control points and weights, each once.
    subroutine unwrapped_points(this, values, weights, status)
        class(nurbs_inspected), intent(in) :: this
        real(c_double), allocatable, intent(out) :: values(:, :), weights(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        real(c_double), allocatable :: values_c(:, :)
        n = 0
        code = nurbs_unwrapped_points(this%handle, 0_c_int64_t, count=n)
        allocate (values_c(dim_of(this%handle), n), weights(n))
        if (code == NURBS_OK) code = nurbs_unwrapped_points(this%handle, n, values_c, weights)
        values = transpose(values_c)
        call settle(code, status)
    end subroutine unwrapped_points

    !> The knots without repetition, and how often each occurs.
    subroutine distinct_knots(this, axis, values, multiplicities, status)
        class(nurbs_inspected), intent(in) :: this
        integer(c_int32_t), intent(in) :: axis
        real(c_double), allocatable, intent(out) :: values(:)
        integer(c_int32_t), allocatable, intent(out) :: multiplicities(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        n = 0
        code = nurbs_distinct_knots(this%handle, axis - 1, 0_c_int64_t, count=n)
        allocate (values(n), multiplicities(n))
        if (code == NURBS_OK) code = nurbs_distinct_knots(this%handle, axis - 1, n, values, multiplicities, n)
        call settle(code, status)
    end subroutine distinct_knots

    !> The Greville abscissa of each control point along an axis.
    subroutine greville(this, axis, values, status)
        class(nurbs_inspected), intent(in) :: this
        integer(c_int32_t), intent(in) :: axis
        real(c_double), allocatable, intent(out) :: values(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int64_t) :: count
        count = count_of(this%handle, axis - 1)
        allocate (values(count))
        call settle(nurbs_greville(this%handle, axis - 1, count, values), status)
    end subroutine greville

    !> Control points (n, dim).
    subroutine points(this, values, status)
        class(nurbs_inspected), intent(in) :: this
        real(c_double), allocatable, intent(out) :: values(:, :)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int64_t) :: count
        count = points_of(this%handle)
        allocate (values(count, dim_of(this%handle)))
        call settle(nurbs_points(this%handle, count, values, step(values), column(values)), status)
    end subroutine points

    !> Weights, all 1 for a polynomial spline.
    subroutine weights(this, values, status)
        class(nurbs_inspected), intent(in) :: this
        real(c_double), allocatable, intent(out) :: values(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int64_t) :: count
        count = points_of(this%handle)
        allocate (values(count))
        call settle(nurbs_weights(this%handle, count, values, 0_c_int64_t), status)
    end subroutine weights

    !> Homogeneous control points (n, dim + 1), the weight last.
    subroutine homogeneous_points(this, values, status)
        class(nurbs_inspected), intent(in) :: this
        real(c_double), allocatable, intent(out) :: values(:, :)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int64_t) :: count
        count = points_of(this%handle)
        allocate (values(count, dim_of(this%handle) + 1))
        call settle(nurbs_homogeneous_points(this%handle, count, values, step(values), column(values)), status)
    end subroutine homogeneous_points
end module nurbs_inspection
