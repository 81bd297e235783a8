! SPDX-License-Identifier: MIT
!> What shapes and edits share: the dimension of vectors some of which may be left out, defaults, and the end of a call.
module nurbs_placements
    use, intrinsic :: iso_c_binding
    use nurbs_constants
    use nurbs_support
    use nurbs_splines
    implicit none
    private
    public :: full_turn, dimension_of, given, arc_form, hand_over, handles_of

    real(c_double), parameter :: full_turn = 8 * atan(1.0_c_double)

contains

    !> The length of the vectors that are present, or another dimension if none is; 0 if they differ.
    pure integer(c_int32_t) function dimension_of(otherwise, a, b, c) result(dim)
        integer(c_int32_t), intent(in) :: otherwise
        real(c_double), intent(in), optional :: a(:), b(:), c(:)
        integer :: sizes(3)
        sizes = [length(a), length(b), length(c)]
        dim = maxval(sizes)
        if (dim < 0) then
            dim = otherwise
        else if (any(sizes >= 0 .and. sizes /= dim)) then
            dim = 0
        end if
    end function dimension_of

    pure integer function length(vector)
        real(c_double), intent(in), optional :: vector(:)
        length = -1
        if (present(vector)) length = size(vector)
    end function length

    pure real(c_double) function given(value, otherwise)
        real(c_double), intent(in), optional :: value
        real(c_double), intent(in) :: otherwise
        given = otherwise
        if (present(value)) given = value
    end function given

    pure integer(c_int32_t) function arc_form(form)
        integer(c_int32_t), intent(in), optional :: form
        arc_form = NURBS_ARC_QUARTERS
        if (present(form)) arc_form = form
    end function arc_form

    subroutine hand_over(code, made, out, status)
        integer(c_int32_t), intent(in) :: code
        type(c_ptr), intent(in) :: made
        type(nurbs_spline), intent(inout) :: out
        integer(c_int32_t), intent(out), optional :: status
        call out%replace(made)
        call settle(code, status)
    end subroutine hand_over

    function handles_of(splines) result(handles)
        type(nurbs_spline), intent(in) :: splines(:)
        type(c_ptr) :: handles(size(splines))
        integer :: i
        do i = 1, size(splines)
            handles(i) = splines(i)%handle
        end do
    end function handles_of
end module nurbs_placements
