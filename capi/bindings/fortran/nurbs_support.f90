! SPDX-License-Identifier: MIT
!> What the types share: messages, errors, and Fortran's shapes as the library's strides.
module nurbs_support
    use, intrinsic :: iso_c_binding
    use, intrinsic :: ieee_arithmetic, only: ieee_positive_inf, ieee_value
    use nurbs_constants
    use nurbs_c, only: nurbs_axes, nurbs_count, nurbs_degree, nurbs_derivative_slots, nurbs_destroy, &
        nurbs_dimension, nurbs_face_surface, nurbs_is_rational, nurbs_last_error, nurbs_point_count, &
        nurbs_statistics_size, nurbs_status_name
    implicit none
    private
    public :: nurbs_message, nurbs_status_text, nurbs_on_axis, nurbs_on_all_axes
    public :: shape_error, full_turn, any_size, given, settle, string, infinity, dimension_of, step, column, fits
    public :: size_if_given, statistics_axes_of, face_dim_of
    public :: fitting, held, axes_of, dim_of, points_of, rational_of, count_of, degree_of, slots_of, active_of, net_size
    public :: knot_count, bezier_count, periodic_count, matrix_size, monomials, homogeneous

    !> NURBS_ERROR_SIZE found on this side, where the library has no message for it.
    integer(c_int32_t), parameter :: shape_error = -NURBS_ERROR_SIZE

    real(c_double), parameter :: full_turn = 8 * atan(1.0_c_double)

    !> In place of a size, where the library is to say what is wrong.
    integer(c_int64_t), parameter :: any_size = -huge(0_c_int64_t)

    !> An optional argument, or what it is if it is absent.
    interface given
        module procedure given_real, given_number
    end interface given

contains

    !> Of an optional array; 0 if it is absent.
    pure function size_if_given(values) result(n)
        real(c_double), intent(in), optional :: values(:)
        integer(c_int64_t) :: n
        n = 0
        if (present(values)) n = size(values, kind=c_int64_t)
    end function size_if_given

    !> Message of the last failed call in this thread.
    function nurbs_message() result(text)
        character(len=:), allocatable :: text
        character(kind=c_char), allocatable :: buffer(:)
        integer(c_int64_t) :: length
        length = nurbs_last_error(cap=0_c_int64_t)
        allocate (buffer(length + 1))
        length = nurbs_last_error(buffer, length + 1)
        text = string(buffer(:length))
    end function nurbs_message

    !> Name of a status, such as "NURBS_ERROR_NULL".
    function nurbs_status_text(status) result(text)
        integer(c_int32_t), intent(in) :: status
        character(len=:), allocatable :: text
        character(kind=c_char), pointer :: chars(:)
        integer :: length
        call c_f_pointer(nurbs_status_name(status), chars, [64])
        length = 0
        do while (chars(length + 1) /= c_null_char)
            length = length + 1
        end do
        text = string(chars(:length))
    end function nurbs_status_text

    !> The bits `flags` moved to those of `axis` = 1, 2 or 3: the macro NURBS_ON_AXIS.
    pure integer(c_int32_t) function nurbs_on_axis(axis, flags)
        integer(c_int32_t), intent(in) :: axis, flags
        nurbs_on_axis = shiftl(flags, 8 * (axis - 1))
    end function nurbs_on_axis

    !> The bits `flags` for the first `axes` axes: the macro NURBS_ON_ALL_AXES.
    pure integer(c_int32_t) function nurbs_on_all_axes(axes, flags)
        integer(c_int32_t), intent(in) :: axes, flags
        integer(c_int32_t) :: axis
        nurbs_on_all_axes = 0
        do axis = 1, axes
            nurbs_on_all_axes = ior(nurbs_on_all_axes, nurbs_on_axis(axis, flags))
        end do
    end function nurbs_on_all_axes

    !> Hands the status out if it is wanted, otherwise ends the program on a failure.
    subroutine settle(code, status)
        integer(c_int32_t), intent(in) :: code
        integer(c_int32_t), intent(out), optional :: status
        character(len=:), allocatable :: text
        if (present(status)) then
            status = abs(code)
        else if (code == shape_error) then
            error stop 'NURBS_ERROR_SIZE: the shapes of the arrays do not suit each other or the spline'
        else if (code /= NURBS_OK) then
            text = nurbs_status_text(code)//': '//nurbs_message()
            error stop text
        end if
    end subroutine settle

    pure function string(chars)
        character(kind=c_char), intent(in) :: chars(:)
        character(len=size(chars)) :: string
        integer :: i
        do i = 1, size(chars)
            string(i:i) = chars(i)
        end do
    end function string

    ! Arguments that may be absent

    pure real(c_double) function given_real(value, otherwise)
        real(c_double), intent(in), optional :: value
        real(c_double), intent(in) :: otherwise
        given_real = otherwise
        if (present(value)) given_real = value
    end function given_real

    pure integer(c_int32_t) function given_number(value, otherwise)
        integer(c_int32_t), intent(in), optional :: value
        integer(c_int32_t), intent(in) :: otherwise
        given_number = otherwise
        if (present(value)) given_number = value
    end function given_number

    pure real(c_double) function infinity()
        infinity = ieee_value(1.0_c_double, ieee_positive_inf)
    end function infinity

    !> The length of the vectors that are present, or another dimension if none is; 0 if they differ.
    pure integer(c_int64_t) function dimension_of(otherwise, a, b, c) result(dim)
        integer(c_int32_t), intent(in) :: otherwise
        real(c_double), intent(in), optional :: a(:), b(:), c(:)
        integer(c_int64_t) :: sizes(3)
        sizes = [length(a), length(b), length(c)]
        dim = maxval(sizes)
        if (dim < 0) then
            dim = otherwise
        else if (any(sizes >= 0 .and. sizes /= dim)) then
            dim = 0
        end if
    end function dimension_of

    pure integer(c_int64_t) function length(vector)
        real(c_double), intent(in), optional :: vector(:)
        length = -1
        if (present(vector)) length = size(vector, kind=c_int64_t)
    end function length

    ! Arrays

    !> Stride between the records that are the rows of an array; single rows and vectors are simply packed.
    pure integer(c_int64_t) function step(array)
        type(*), intent(in), optional :: array(..)
        step = 0
        if (has_rows(array)) step = 1
    end function step

    !> Stride between the components of such a record.
    pure integer(c_int64_t) function column(array)
        type(*), intent(in), optional :: array(..)
        column = 0
        if (has_rows(array)) column = size(array, 1, c_int64_t)
    end function column

    pure logical function has_rows(array)
        type(*), intent(in), optional :: array(..)
        has_rows = .false.
        if (.not. present(array)) return
        if (rank(array) > 1) has_rows = size(array, 1) > 1
    end function has_rows

    !> Whether an array that is present has this shape.
    pure logical function fits(array, n, m, l)
        type(*), intent(in), optional :: array(..)
        integer(c_int64_t), intent(in) :: n
        integer(c_int64_t), intent(in), optional :: m, l
        fits = .true.
        if (.not. present(array)) return
        if (n /= any_size) fits = size(array, 1, c_int64_t) == n
        if (present(m)) fits = fits .and. size(array, 2, c_int64_t) == m
        if (present(l)) fits = fits .and. size(array, 3, c_int64_t) == l
    end function fits

    pure integer(c_int32_t) function fitting(conditions)
        logical, intent(in) :: conditions(:)
        fitting = merge(NURBS_OK, shape_error, all(conditions))
    end function fitting

    ! Numbers of a spline, 0 of a null handle and where an axis does not exist

    !> NURBS_OK, or what the library says of a null handle.
    integer(c_int32_t) function held(handle)
        type(c_ptr), intent(in) :: handle
        integer(c_int32_t) :: axes
        held = nurbs_axes(handle, axes)
    end function held

    integer(c_int64_t) function axes_of(handle)
        type(c_ptr), intent(in) :: handle
        integer(c_int32_t) :: axes
        axes_of = 0
        if (nurbs_axes(handle, axes) == NURBS_OK) axes_of = axes
    end function axes_of

    integer(c_int64_t) function statistics_axes_of(handle)
        type(c_ptr), intent(in) :: handle
        integer(c_int32_t) :: axes
        statistics_axes_of = 0
        if (nurbs_statistics_size(handle, axes=axes) == NURBS_OK) statistics_axes_of = axes
    end function statistics_axes_of

    !> The dimension of the surface of a face.
    integer(c_int64_t) function face_dim_of(handle)
        type(c_ptr), intent(in) :: handle
        type(c_ptr) :: surface
        face_dim_of = 0
        surface = c_null_ptr
        if (nurbs_face_surface(handle, surface) == NURBS_OK) face_dim_of = dim_of(surface)
        call nurbs_destroy(surface)
    end function face_dim_of

    integer(c_int64_t) function dim_of(handle)
        type(c_ptr), intent(in) :: handle
        integer(c_int32_t) :: dim
        dim_of = 0
        if (nurbs_dimension(handle, dim) == NURBS_OK) dim_of = dim
    end function dim_of

    !> Number of control points of all axes together.
    integer(c_int64_t) function points_of(handle)
        type(c_ptr), intent(in) :: handle
        integer(c_int64_t) :: n
        points_of = 0
        if (nurbs_point_count(handle, n) == NURBS_OK) points_of = n
    end function points_of

    !> 1 of a rational spline.
    integer(c_int64_t) function rational_of(handle)
        type(c_ptr), intent(in) :: handle
        integer(c_int32_t) :: rational
        rational_of = 0
        if (nurbs_is_rational(handle, rational) == NURBS_OK) rational_of = rational
    end function rational_of

    !> Number of control points along an axis, which counts from 0.
    integer(c_int64_t) function count_of(handle, axis)
        type(c_ptr), intent(in) :: handle
        integer(c_int32_t), intent(in) :: axis
        integer(c_int64_t) :: n
        count_of = 0
        if (nurbs_count(handle, axis, n) == NURBS_OK) count_of = n
    end function count_of

    !> Degree along an axis, which counts from 0; -1 where there is none, so that there is room for no basis function.
    integer(c_int64_t) function degree_of(handle, axis)
        type(c_ptr), intent(in) :: handle
        integer(c_int32_t), intent(in) :: axis
        integer(c_int32_t) :: degree
        degree_of = -1
        if (nurbs_degree(handle, axis, degree) == NURBS_OK) degree_of = degree
    end function degree_of

    !> Columns of derivatives: binomial(order + axes, axes), 0 where the library will refuse the order.
    integer(c_int64_t) function slots_of(handle, order)
        type(c_ptr), intent(in) :: handle
        integer(c_int32_t), intent(in) :: order
        integer(c_int64_t) :: slots
        slots_of = 0
        if (nurbs_derivative_slots(int(axes_of(handle)), order, slots) == NURBS_OK) slots_of = slots
    end function slots_of

    !> Basis functions that are not 0 at a parameter: the product of the degrees + 1.
    integer(c_int64_t) function active_of(handle)
        type(c_ptr), intent(in) :: handle
        integer(c_int32_t) :: axis
        active_of = 1
        do axis = 0, int(axes_of(handle)) - 1
            active_of = active_of * (degree_of(handle, axis) + 1)
        end do
    end function active_of

    ! Numbers that follow from others, 0 where the library will refuse them

    !> Control points of a net. Of negative numbers the library says what is wrong.
    pure integer(c_int64_t) function net_size(counts)
        integer(c_int64_t), intent(in) :: counts(:)
        net_size = merge(any_size, product(counts), any(counts < 0))
    end function net_size

    !> Knots of so many control points.
    pure integer(c_int64_t) function knot_count(degree, count)
        integer(c_int32_t), intent(in) :: degree
        integer(c_int64_t), intent(in) :: count
        knot_count = 0
        if (degree >= 0 .and. degree <= NURBS_MAX_DEGREE .and. count >= 0) knot_count = count + degree + 1
    end function knot_count

    !> Control points of joined Bezier pieces.
    pure integer(c_int64_t) function bezier_count(degree, pieces)
        integer(c_int32_t), intent(in) :: degree
        integer(c_int64_t), intent(in) :: pieces
        bezier_count = merge(pieces, pieces * degree + 1, degree == 0)
    end function bezier_count

    !> Control points of a closed spline with breaks, each once or as often as is said.
    pure integer(c_int64_t) function periodic_count(degree, breaks, multiplicities)
        integer(c_int32_t), intent(in) :: degree
        real(c_double), intent(in) :: breaks(:)
        integer(c_int32_t), intent(in), optional :: multiplicities(:)
        integer(c_int64_t) :: inner
        inner = size(breaks, kind=c_int64_t) - 1
        if (present(multiplicities)) then
            if (size(multiplicities) == size(breaks)) inner = sum(int(multiplicities(:inner), c_int64_t))
        end if
        periodic_count = inner + degree
    end function periodic_count

    !> Entries of a matrix between bases.
    pure integer(c_int64_t) function matrix_size(degree)
        integer(c_int64_t), intent(in) :: degree
        matrix_size = (degree + 1)**2
    end function matrix_size

    !> Coefficients of a polynomial in the coordinates; 0 where the library refuses the degree.
    pure integer(c_int64_t) function monomials(dim, degree)
        integer(c_int64_t), intent(in) :: dim
        integer(c_int32_t), intent(in) :: degree
        integer(c_int64_t) :: i
        monomials = merge(1_c_int64_t, 0_c_int64_t, degree >= 1 .and. degree <= 8)
        do i = 1, degree
            if (monomials > huge(i) / (dim + i)) monomials = 0
            monomials = monomials * (dim + i) / i
        end do
    end function monomials

    !> The column of weights that points have beside their dim coordinates.
    pure integer(c_int64_t) function homogeneous(flags)
        integer(c_int32_t), intent(in) :: flags
        homogeneous = merge(1_c_int64_t, 0_c_int64_t, iand(flags, NURBS_HOMOGENEOUS) /= 0)
    end function homogeneous
end module nurbs_support
