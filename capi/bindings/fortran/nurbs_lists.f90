! SPDX-License-Identifier: MIT
! Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
!> The type of what a file held. Conventions: see the module nurbs.
module nurbs_lists
    use, intrinsic :: iso_c_binding
    use nurbs_constants
    use nurbs_c, only: nurbs_decompose, nurbs_split_at_knots, nurbs_read, nurbs_read_file, nurbs_list_count, &
        nurbs_list_get, nurbs_list_name, nurbs_list_note_count, nurbs_list_note, nurbs_list_unit, &
        nurbs_list_from_bytes, nurbs_bytes_kind, nurbs_list_write_file, nurbs_read_with, nurbs_read_file_with, &
        nurbs_list_write_file_with, nurbs_read_options, nurbs_write_options
    use nurbs_support
    use nurbs_calls
    use nurbs_handles
    use nurbs_splines
    implicit none
    private
    public :: bytes_kind

    !> Splines with names: parts of one, or what a file held, with notes on the rest. A list cannot be copied.
    type, extends(nurbs_list_handle), public :: nurbs_list
    contains
        procedure :: decompose, split_at_knots, read, read_file, count => get_count, get, name, note_count, note, unit
        procedure :: from_bytes, write_file
    end type nurbs_list

contains

    ! Splines taken apart into lists, and joined again

    !> The polynomial pieces of a spline as Bezier splines over their own domains, last axis fastest.
    subroutine decompose(this, spline, status)
        class(nurbs_list), intent(inout) :: this
        class(nurbs_spline), intent(in) :: spline
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        code = nurbs_decompose(spline%handle, made)
        call this%replace(made)
        call settle(code, status)
    end subroutine decompose

    !> The parts of a spline between the knots at which its order of continuity is less than `order`.
    subroutine split_at_knots(this, spline, axis, order, status)
        class(nurbs_list), intent(inout) :: this
        class(nurbs_spline), intent(in) :: spline
        integer(c_int32_t), intent(in) :: axis, order
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        code = nurbs_split_at_knots(spline%handle, axis - 1, order, made)
        call this%replace(made)
        call settle(code, status)
    end subroutine split_at_knots

    ! Files: the splines that one held, their names, and notes on the rest; and writing them

    !> Reads the contents of a file from memory.
    subroutine read(this, contents, options, status, call)
        class(nurbs_list), intent(inout) :: this
        character(kind=c_char, len=*), intent(in), target :: contents
        type(nurbs_read_options), intent(in), optional :: options
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        integer(c_int64_t) :: size_c
        type(c_ptr) :: made
        size_c = len(contents, c_int64_t)
        if (present(call)) then
            code = nurbs_read_with(c_loc(contents), size_c, options, watched(call), made)
        else
            code = nurbs_read(c_loc(contents), size_c, options, made)
        end if
        call this%replace(made)
        call settle(code, status)
    end subroutine read

    !> Reads a file by its path.
    subroutine read_file(this, path, options, status, call)
        class(nurbs_list), intent(inout) :: this
        character(kind=c_char, len=*), intent(in) :: path
        type(nurbs_read_options), intent(in), optional :: options
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        if (present(call)) then
            code = nurbs_read_file_with(path//c_null_char, options, watched(call), made)
        else
            code = nurbs_read_file(path//c_null_char, options, made)
        end if
        call this%replace(made)
        call settle(code, status)
    end subroutine read_file

    !> Number of splines.
    integer(c_int64_t) function get_count(this, status) result(value)
        class(nurbs_list), intent(in) :: this
        integer(c_int32_t), intent(out), optional :: status
        value = 0
        call settle(nurbs_list_count(this%handle, value), status)
    end function get_count

    !> Spline `index` = 1, ..., count; it outlives the list.
    subroutine get(this, index, out, status)
        class(nurbs_list), intent(in) :: this
        integer(c_int32_t), intent(in) :: index
        type(nurbs_spline), intent(inout) :: out
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        code = nurbs_list_get(this%handle, index - 1_c_int64_t, made)
        call out%replace(made)
        call settle(code, status)
    end subroutine get

    !> The name of a spline.
    subroutine name(this, index, text, status)
        class(nurbs_list), intent(in) :: this
        integer(c_int32_t), intent(in) :: index
        character(len=:), allocatable, intent(out) :: text
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: length
        character(kind=c_char), allocatable :: buffer(:)
        length = 0
        code = nurbs_list_name(this%handle, index - 1_c_int64_t, cap=0_c_int64_t, length=length)
        allocate (buffer(length + 1))
        if (code == NURBS_OK) code = nurbs_list_name(this%handle, index - 1_c_int64_t, buffer, length + 1)
        text = string(buffer(:length))
        call settle(code, status)
    end subroutine name

    !> Number of notes.
    integer(c_int64_t) function note_count(this, status) result(value)
        class(nurbs_list), intent(in) :: this
        integer(c_int32_t), intent(out), optional :: status
        value = 0
        call settle(nurbs_list_note_count(this%handle, value), status)
    end function note_count

    !> Note `index` = 1, ..., note_count: which entity, where, and why it did not become a spline.
    subroutine note(this, index, entity_type, line, reason, text, status)
        class(nurbs_list), intent(in) :: this
        integer(c_int32_t), intent(in) :: index
        integer(c_int32_t), intent(out) :: entity_type, reason
        integer(c_int64_t), intent(out) :: line
        character(len=:), allocatable, intent(out) :: text
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: length
        character(kind=c_char), allocatable :: buffer(:)
        length = 0
        entity_type = 0
        line = 0
        reason = 0
        code = nurbs_list_note(this%handle, index - 1_c_int64_t, cap=0_c_int64_t, length=length)
        allocate (buffer(length + 1))
        if (code == NURBS_OK) code = nurbs_list_note(this%handle, index - 1_c_int64_t, entity_type, line, reason, &
            buffer, length + 1)
        text = string(buffer(:length))
        call settle(code, status)
    end subroutine note

    !> Metres per unit of length; 0 if the file does not say.
    real(c_double) function unit(this, status) result(value)
        class(nurbs_list), intent(in) :: this
        integer(c_int32_t), intent(out), optional :: status
        value = 0
        call settle(nurbs_list_unit(this%handle, value), status)
    end function unit

    !> The list of what to_bytes() made of it.
    subroutine from_bytes(this, contents, status)
        class(nurbs_list), intent(inout) :: this
        character(kind=c_char, len=*), intent(in), target :: contents
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        code = nurbs_list_from_bytes(c_loc(contents), len(contents, c_int64_t), made)
        call this%replace(made)
        call settle(code, status)
    end subroutine from_bytes

    !> Of which kind bytes are, and in which version of the form.
    subroutine bytes_kind(contents, kind, major, minor, status)
        character(kind=c_char, len=*), intent(in), target :: contents
        integer(c_int32_t), intent(inout) :: kind, major, minor
        integer(c_int32_t), intent(out), optional :: status
        call settle(nurbs_bytes_kind(c_loc(contents), len(contents, c_int64_t), kind, major, minor), status)
    end subroutine bytes_kind

    !> Writes the curves and surfaces to a file, which is replaced whole or not at all.
    subroutine write_file(this, path, format, options, status, call)
        class(nurbs_list), intent(in) :: this
        character(kind=c_char, len=*), intent(in) :: path
        integer(c_int32_t), intent(in) :: format
        type(nurbs_write_options), intent(in), optional :: options
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        if (present(call)) then
            code = nurbs_list_write_file_with(this%handle, path//c_null_char, format, options, watched(call))
        else
            code = nurbs_list_write_file(this%handle, path//c_null_char, format, options)
        end if
        call settle(code, status)
    end subroutine write_file
end module nurbs_lists
