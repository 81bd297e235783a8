! SPDX-License-Identifier: MIT
!> What the types share: messages, errors, and Fortran's shapes as the library's strides.
module nurbs_support
    use, intrinsic :: iso_c_binding
    use nurbs_constants
    use nurbs_c
    implicit none
    public

    !> NURBS_ERROR_SIZE found on this side, where the library has no message for it.
    integer(c_int32_t), parameter :: shape_error = -NURBS_ERROR_SIZE

contains

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

    pure integer(c_int32_t) function bits(flags)
        integer(c_int32_t), intent(in), optional :: flags
        bits = 0
        if (present(flags)) bits = flags
    end function bits

    !> Stride between the records that are the rows of an array; a single row is simply packed.
    pure integer(c_int64_t) function step(array)
        class(*), intent(in) :: array(..)
        step = merge(1_c_int64_t, 0_c_int64_t, size(array, 1) > 1)
    end function step

    !> Stride between the components of such a record.
    pure integer(c_int64_t) function column(array)
        class(*), intent(in) :: array(..)
        column = merge(size(array, 1, c_int64_t), 0_c_int64_t, size(array, 1) > 1)
    end function column

    !> Whether the arrays of a control net are as long as degrees and counts say.
    pure integer(c_int32_t) function net_shape(degrees, counts, points, weights)
        integer(c_int32_t), intent(in) :: degrees(:), counts(:)
        real(c_double), intent(in) :: points(:, :)
        real(c_double), intent(in), optional :: weights(:)
        logical :: fits
        fits = size(degrees) == size(counts)
        fits = fits .and. (size(points, 1, c_int64_t) == product(int(counts, c_int64_t)) .or. any(counts < 0))
        if (present(weights)) fits = fits .and. size(weights) == size(points, 1)
        net_shape = merge(NURBS_OK, shape_error, fits)
    end function net_shape

    !> Number of control points and dimension; both 0 on failure.
    integer(c_int32_t) function sizes_of(handle, n, dim) result(code)
        type(c_ptr), intent(in) :: handle
        integer(c_int64_t), intent(out) :: n
        integer(c_int32_t), intent(out) :: dim
        n = 0
        dim = 0
        code = nurbs_point_count(handle, n)
        if (code == NURBS_OK) code = nurbs_dimension(handle, dim)
    end function sizes_of

    !> Whether params, of shape (n, axes), fit the spline, and whether an output has the shape that is wanted.
    integer(c_int32_t) function batch_shape(handle, params, output, wanted) result(code)
        type(c_ptr), intent(in) :: handle
        integer, intent(in) :: params(2), output(:), wanted(:)
        integer(c_int32_t) :: axes
        code = nurbs_axes(handle, axes)
        if (code /= NURBS_OK) return
        if (params(2) /= axes .or. any(output /= wanted)) code = shape_error
    end function batch_shape

    !> Columns of derivatives: binomial(order + axes, axes), 0 where the library will refuse the order.
    integer function slots_of(handle, order)
        type(c_ptr), intent(in) :: handle
        integer(c_int32_t), intent(in) :: order
        integer(c_int32_t) :: axes, code
        integer(c_int64_t) :: slots
        slots_of = 0
        code = nurbs_axes(handle, axes)
        if (code == NURBS_OK) code = nurbs_derivative_slots(axes, order, slots)
        if (code == NURBS_OK) slots_of = int(slots)
    end function slots_of

    !> Dimension of a spline, 0 for a null handle.
    integer function dim_of(handle)
        type(c_ptr), intent(in) :: handle
        integer(c_int32_t) :: code, dim
        code = nurbs_dimension(handle, dim)
        dim_of = merge(dim, 0, code == NURBS_OK)
    end function dim_of

    !> Number of axes of a spline, 0 for a null handle.
    integer function axes_of(handle)
        type(c_ptr), intent(in) :: handle
        integer(c_int32_t) :: code, axes
        code = nurbs_axes(handle, axes)
        axes_of = merge(axes, 0, code == NURBS_OK)
    end function axes_of

    ! Shapes of arrays that may be absent

    pure integer(c_int32_t) function fitting(conditions)
        logical, intent(in) :: conditions(:)
        fitting = merge(NURBS_OK, shape_error, all(conditions))
    end function fitting

    pure logical function has_shape(rows, columns, array)
        integer(c_int64_t), intent(in) :: rows
        integer, intent(in) :: columns
        real(c_double), intent(in), optional :: array(:, :)
        has_shape = .true.
        if (present(array)) has_shape = size(array, 1, c_int64_t) == rows .and. size(array, 2) == columns
    end function has_shape

    pure logical function has_size(rows, array)
        integer(c_int64_t), intent(in) :: rows
        real(c_double), intent(in), optional :: array(:)
        has_size = .true.
        if (present(array)) has_size = size(array, kind=c_int64_t) == rows
    end function has_size

    pure logical function has_length(rows, states)
        integer(c_int64_t), intent(in) :: rows
        integer(c_int32_t), intent(in), optional :: states(:)
        has_length = .true.
        if (present(states)) has_length = size(states, kind=c_int64_t) == rows
    end function has_length

    !> Arrays for `entries` of a matrix of so many rows, in place of what they held.
    subroutine make_sparse(entries, rows, values, columns, row_pointers)
        integer(c_int64_t), intent(in) :: entries, rows
        real(c_double), allocatable, intent(out) :: values(:)
        integer(c_int64_t), allocatable, intent(out) :: columns(:), row_pointers(:)
        allocate (values(entries), columns(entries), row_pointers(rows + 1))
    end subroutine make_sparse

    !> Stride between the rows of a column-wise array; a single row is simply packed.
    pure integer(c_int64_t) function apart(rows)
        integer(c_int64_t), intent(in) :: rows
        apart = merge(1_c_int64_t, 0_c_int64_t, rows > 1)
    end function apart
end module nurbs_support
