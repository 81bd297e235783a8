! SPDX-License-Identifier: MIT
!> The handles that splines and lists of splines own: how they are replaced, copied and freed.
module nurbs_handles
    use, intrinsic :: iso_c_binding
    use nurbs_c, only: nurbs_clone, nurbs_destroy, nurbs_list_destroy, nurbs_read_options, nurbs_read_options_init
    use nurbs_support
    implicit none
    private
    public :: handles_of, default_read_options

    !> The handle of a spline. An assignment makes another handle on the same data.
    type, public :: nurbs_handle
        type(c_ptr) :: handle = c_null_ptr
    contains
        procedure :: destroy => destroy_spline, replace => replace_spline
        procedure, private :: copy
        generic :: assignment(=) => copy
        final :: finish_spline
    end type nurbs_handle

    !> The handle of a list of splines, which cannot be copied.
    type, public :: nurbs_list_handle
        type(c_ptr) :: handle = c_null_ptr
    contains
        procedure :: destroy => destroy_list, replace => replace_list
        procedure, private :: refuse_copy
        generic :: assignment(=) => refuse_copy
        final :: finish_list
    end type nurbs_list_handle

contains

    ! Splines

    subroutine destroy_spline(this)
        class(nurbs_handle), intent(inout) :: this
        call replace_spline(this, c_null_ptr)
    end subroutine destroy_spline

    impure elemental subroutine finish_spline(this)
        type(nurbs_handle), intent(inout) :: this
        call destroy_spline(this)
    end subroutine finish_spline

    !> Puts a handle in place of the old one.
    subroutine replace_spline(this, handle)
        class(nurbs_handle), intent(inout) :: this
        type(c_ptr), intent(in) :: handle
        call nurbs_destroy(this%handle)
        this%handle = handle
    end subroutine replace_spline

    !> Elemental, so that arrays are not assigned bit by bit, which would free their handles twice.
    impure elemental subroutine copy(this, other)
        class(nurbs_handle), intent(inout) :: this
        class(nurbs_handle), intent(in) :: other
        type(c_ptr) :: made
        made = c_null_ptr
        if (c_associated(other%handle)) call settle(nurbs_clone(other%handle, made))
        call this%replace(made)
    end subroutine copy

    !> As the library takes an array of splines.
    function handles_of(splines) result(handles)
        class(nurbs_handle), intent(in) :: splines(:)
        type(c_ptr) :: handles(size(splines))
        integer :: i
        do i = 1, size(splines)
            handles(i) = splines(i)%handle
        end do
    end function handles_of

    ! Lists

    subroutine destroy_list(this)
        class(nurbs_list_handle), intent(inout) :: this
        call replace_list(this, c_null_ptr)
    end subroutine destroy_list

    impure elemental subroutine finish_list(this)
        type(nurbs_list_handle), intent(inout) :: this
        call destroy_list(this)
    end subroutine finish_list

    subroutine replace_list(this, handle)
        class(nurbs_list_handle), intent(inout) :: this
        type(c_ptr), intent(in) :: handle
        call nurbs_list_destroy(this%handle)
        this%handle = handle
    end subroutine replace_list

    impure elemental subroutine refuse_copy(this, other)
        class(nurbs_list_handle), intent(inout) :: this
        class(nurbs_list_handle), intent(in) :: other
        if (.not. c_associated(this%handle, other%handle)) error stop 'a nurbs_list cannot be copied'
    end subroutine refuse_copy

    !> The settings that read() and read_file() have without options, to change some of them.
    subroutine default_read_options(options, status)
        type(nurbs_read_options), intent(out) :: options
        integer(c_int32_t), intent(out), optional :: status
        call settle(nurbs_read_options_init(options, int(c_sizeof(options), c_int64_t)), status)
    end subroutine default_read_options
end module nurbs_handles
