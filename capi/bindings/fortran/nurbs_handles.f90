! SPDX-License-Identifier: MIT
!> What splines are before anything is done with them: a handle, its copies and its end, and questions about it.
module nurbs_handles
    use, intrinsic :: iso_c_binding
    use nurbs_constants
    use nurbs_c
    use nurbs_support
    implicit none
    private

    !> An owned handle. What extends it says what an assignment does.
    type, public :: nurbs_handle
        type(c_ptr) :: handle = c_null_ptr
    contains
        procedure :: destroy, replace
        procedure :: axes, dimension => get_dimension, degree, count => get_count, point_count
        procedure :: is_rational, is_homogeneous, knot_form, domain, knots, distinct_knots, greville
        procedure :: points, weights, homogeneous_points
        final :: finish
    end type nurbs_handle

contains

    subroutine destroy(this)
        class(nurbs_handle), intent(inout) :: this
        call replace(this, c_null_ptr)
    end subroutine destroy

    impure elemental subroutine finish(this)
        type(nurbs_handle), intent(inout) :: this
        call destroy(this)
    end subroutine finish

    !> Puts a handle in place of the old one.
    subroutine replace(this, handle)
        class(nurbs_handle), intent(inout) :: this
        type(c_ptr), intent(in) :: handle
        call nurbs_destroy(this%handle)
        this%handle = handle
    end subroutine replace

    ! Inspection

    integer(c_int32_t) function axes(this, status)
        class(nurbs_handle), intent(in) :: this
        integer(c_int32_t), intent(out), optional :: status
        axes = 0
        call settle(nurbs_axes(this%handle, axes), status)
    end function axes

    integer(c_int32_t) function get_dimension(this, status)
        class(nurbs_handle), intent(in) :: this
        integer(c_int32_t), intent(out), optional :: status
        get_dimension = 0
        call settle(nurbs_dimension(this%handle, get_dimension), status)
    end function get_dimension

    integer(c_int32_t) function degree(this, axis, status)
        class(nurbs_handle), intent(in) :: this
        integer(c_int32_t), intent(in) :: axis
        integer(c_int32_t), intent(out), optional :: status
        degree = 0
        call settle(nurbs_degree(this%handle, axis - 1, degree), status)
    end function degree

    integer(c_int64_t) function get_count(this, axis, status)
        class(nurbs_handle), intent(in) :: this
        integer(c_int32_t), intent(in) :: axis
        integer(c_int32_t), intent(out), optional :: status
        get_count = 0
        call settle(nurbs_count(this%handle, axis - 1, get_count), status)
    end function get_count

    integer(c_int64_t) function point_count(this, status)
        class(nurbs_handle), intent(in) :: this
        integer(c_int32_t), intent(out), optional :: status
        point_count = 0
        call settle(nurbs_point_count(this%handle, point_count), status)
    end function point_count

    logical function is_rational(this, status)
        class(nurbs_handle), intent(in) :: this
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: answer
        answer = 0
        call settle(nurbs_is_rational(this%handle, answer), status)
        is_rational = answer /= 0
    end function is_rational

    !> Whether homogeneous points are stored, and not Cartesian ones with or without weights.
    logical function is_homogeneous(this, status)
        class(nurbs_handle), intent(in) :: this
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: answer
        answer = 0
        call settle(nurbs_is_homogeneous(this%handle, answer), status)
        is_homogeneous = answer /= 0
    end function is_homogeneous

    !> Sum of NURBS_FORM_ bits.
    integer(c_int32_t) function knot_form(this, axis, status)
        class(nurbs_handle), intent(in) :: this
        integer(c_int32_t), intent(in) :: axis
        integer(c_int32_t), intent(out), optional :: status
        knot_form = 0
        call settle(nurbs_knot_form(this%handle, axis - 1, knot_form), status)
    end function knot_form

    function domain(this, axis, status)
        class(nurbs_handle), intent(in) :: this
        integer(c_int32_t), intent(in) :: axis
        integer(c_int32_t), intent(out), optional :: status
        real(c_double) :: domain(2)
        domain = 0
        call settle(nurbs_domain(this%handle, axis - 1, domain), status)
    end function domain

    subroutine knots(this, axis, values, status)
        class(nurbs_handle), intent(in) :: this
        integer(c_int32_t), intent(in) :: axis
        real(c_double), allocatable, intent(out) :: values(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code, p
        integer(c_int64_t) :: n
        n = -1
        p = 0
        code = nurbs_count(this%handle, axis - 1, n)
        if (code == NURBS_OK) code = nurbs_degree(this%handle, axis - 1, p)
        allocate (values(n + p + 1))
        if (code == NURBS_OK) code = nurbs_knots(this%handle, axis - 1, n + p + 1, values)
        call settle(code, status)
    end subroutine knots

    subroutine distinct_knots(this, axis, values, multiplicities, status)
        class(nurbs_handle), intent(in) :: this
        integer(c_int32_t), intent(in) :: axis
        real(c_double), allocatable, intent(out) :: values(:)
        integer(c_int32_t), allocatable, intent(out) :: multiplicities(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n, found
        n = 0
        code = nurbs_distinct_knots(this%handle, axis - 1, 0_c_int64_t, count=n)
        allocate (values(n), multiplicities(n))
        if (code == NURBS_OK) code = nurbs_distinct_knots(this%handle, axis - 1, n, values, &
            multiplicities, found)
        call settle(code, status)
    end subroutine distinct_knots

    subroutine greville(this, axis, values, status)
        class(nurbs_handle), intent(in) :: this
        integer(c_int32_t), intent(in) :: axis
        real(c_double), allocatable, intent(out) :: values(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        n = 0
        code = nurbs_count(this%handle, axis - 1, n)
        allocate (values(n))
        if (code == NURBS_OK) code = nurbs_greville(this%handle, axis - 1, n, values)
        call settle(code, status)
    end subroutine greville

    !> Control points (n, dim).
    subroutine points(this, values, status)
        class(nurbs_handle), intent(in) :: this
        real(c_double), allocatable, intent(out) :: values(:, :)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code, dim
        integer(c_int64_t) :: n
        code = sizes_of(this%handle, n, dim)
        allocate (values(n, dim))
        if (code == NURBS_OK) code = nurbs_points(this%handle, n, values, step(values), column(values))
        call settle(code, status)
    end subroutine points

    subroutine weights(this, values, status)
        class(nurbs_handle), intent(in) :: this
        real(c_double), allocatable, intent(out) :: values(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code, dim
        integer(c_int64_t) :: n
        code = sizes_of(this%handle, n, dim)
        allocate (values(n))
        if (code == NURBS_OK) code = nurbs_weights(this%handle, n, values, 0_c_int64_t)
        call settle(code, status)
    end subroutine weights

    !> Homogeneous control points (n, dim + 1), the weight last.
    subroutine homogeneous_points(this, values, status)
        class(nurbs_handle), intent(in) :: this
        real(c_double), allocatable, intent(out) :: values(:, :)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code, dim
        integer(c_int64_t) :: n
        code = sizes_of(this%handle, n, dim)
        allocate (values(n, dim + 1))
        if (code == NURBS_OK) &
            code = nurbs_homogeneous_points(this%handle, n, values, step(values), column(values))
        call settle(code, status)
    end subroutine homogeneous_points
end module nurbs_handles
