! SPDX-License-Identifier: MIT
!> The type of what a file held. Conventions: see the module nurbs.
module nurbs_lists
    use, intrinsic :: iso_c_binding
    use nurbs_constants
    use nurbs_c
    use nurbs_support
    use nurbs_splines
    implicit none
    private
    public :: default_read_options

    !> Splines with names: parts of one, or what a file held, with notes on the rest. A list cannot be copied.
    type, public :: nurbs_list
        type(c_ptr) :: handle = c_null_ptr
    contains
        procedure :: read, read_file, decompose, split_at_knots, destroy
        procedure :: count => get_count, get, name, note_count, note, unit
        procedure, private :: refuse_copy
        generic :: assignment(=) => refuse_copy
        final :: finish
    end type nurbs_list

contains

    !> The settings that read() and read_file() have without options, to change some of them.
    subroutine default_read_options(options, status)
        type(nurbs_read_options), intent(out) :: options
        integer(c_int32_t), intent(out), optional :: status
        call settle(nurbs_read_options_init(options, int(c_sizeof(options), c_int64_t)), status)
    end subroutine default_read_options

    !> Reads the contents of a file from memory.
    subroutine read(this, contents, options, status)
        class(nurbs_list), intent(inout) :: this
        character(kind=c_char, len=*), intent(in), target :: contents
        type(nurbs_read_options), intent(in), optional :: options
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        code = nurbs_read(c_loc(contents), len(contents, c_int64_t), options, made)
        call this%destroy()
        this%handle = made
        call settle(code, status)
    end subroutine read

    subroutine read_file(this, path, options, status)
        class(nurbs_list), intent(inout) :: this
        character(kind=c_char, len=*), intent(in) :: path
        type(nurbs_read_options), intent(in), optional :: options
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        code = nurbs_read_file(path//c_null_char, options, made)
        call this%destroy()
        this%handle = made
        call settle(code, status)
    end subroutine read_file

    !> The polynomial pieces of a spline as Bezier splines over their own domains, last axis fastest.
    subroutine decompose(this, spline, status)
        class(nurbs_list), intent(inout) :: this
        class(nurbs_spline), intent(in) :: spline
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        code = nurbs_decompose(spline%handle, made)
        call this%destroy()
        this%handle = made
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
        call this%destroy()
        this%handle = made
        call settle(code, status)
    end subroutine split_at_knots

    subroutine destroy(this)
        class(nurbs_list), intent(inout) :: this
        call nurbs_list_destroy(this%handle)
        this%handle = c_null_ptr
    end subroutine destroy

    impure elemental subroutine finish(this)
        type(nurbs_list), intent(inout) :: this
        call destroy(this)
    end subroutine finish

    impure elemental subroutine refuse_copy(this, other)
        class(nurbs_list), intent(inout) :: this
        class(nurbs_list), intent(in) :: other
        if (.not. c_associated(this%handle, other%handle)) error stop 'a nurbs_list cannot be copied'
    end subroutine refuse_copy

    integer(c_int64_t) function get_count(this, status)
        class(nurbs_list), intent(in) :: this
        integer(c_int32_t), intent(out), optional :: status
        get_count = 0
        call settle(nurbs_list_count(this%handle, get_count), status)
    end function get_count

    !> Spline `index` = 1, ..., count; it outlives the list.
    subroutine get(this, index, out, status)
        class(nurbs_list), intent(in) :: this
        integer, intent(in) :: index
        type(nurbs_spline), intent(inout) :: out
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        code = nurbs_list_get(this%handle, index - 1_c_int64_t, made)
        call out%replace(made)
        call settle(code, status)
    end subroutine get

    subroutine name(this, index, text, status)
        class(nurbs_list), intent(in) :: this
        integer, intent(in) :: index
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

    integer(c_int64_t) function note_count(this, status)
        class(nurbs_list), intent(in) :: this
        integer(c_int32_t), intent(out), optional :: status
        note_count = 0
        call settle(nurbs_list_note_count(this%handle, note_count), status)
    end function note_count

    !> Note `index` = 1, ..., note_count: which entity, where, and why it did not become a spline.
    subroutine note(this, index, entity_type, line, reason, text, status)
        class(nurbs_list), intent(in) :: this
        integer, intent(in) :: index
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
        reason = NURBS_OK
        code = nurbs_list_note(this%handle, index - 1_c_int64_t, entity_type, line, reason, &
                               cap=0_c_int64_t, length=length)
        allocate (buffer(length + 1))
        if (code == NURBS_OK) &
            code = nurbs_list_note(this%handle, index - 1_c_int64_t, buf=buffer, cap=length + 1)
        text = string(buffer(:length))
        call settle(code, status)
    end subroutine note

    !> Metres per unit of length; 0 if the file does not say.
    real(c_double) function unit(this, status)
        class(nurbs_list), intent(in) :: this
        integer(c_int32_t), intent(out), optional :: status
        unit = 0
        call settle(nurbs_list_unit(this%handle, unit), status)
    end function unit
end module nurbs_lists
