! SPDX-License-Identifier: MIT
!> Reflections and projections. Conventions: see the module nurbs.
module nurbs_projections
    use, intrinsic :: iso_c_binding
    use nurbs_constants
    use nurbs_c
    use nurbs_support
    use nurbs_splines
    implicit none
    private
    public :: mirror_spline, project_spline_to_plane, project_spline_from

contains

    subroutine mirror_spline(spline, point, normal, out, status)
        class(nurbs_spline), intent(in) :: spline
        real(c_double), intent(in) :: point(:), normal(:)
        type(nurbs_spline), intent(inout) :: out
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        made = c_null_ptr
        code = vectors_fit(spline, [size(point), size(normal)])
        if (code == NURBS_OK) code = nurbs_mirror(spline%handle, point, normal, made)
        call out%replace(made)
        call settle(code, status)
    end subroutine mirror_spline

    !> Along a direction, or along the normal.
    subroutine project_spline_to_plane(spline, point, normal, out, direction, status)
        class(nurbs_spline), intent(in) :: spline
        real(c_double), intent(in) :: point(:), normal(:)
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(in), optional :: direction(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        made = c_null_ptr
        code = vectors_fit(spline, [size(point), size(normal)])
        if (present(direction)) then
            if (code == NURBS_OK) code = vectors_fit(spline, [size(direction)])
        end if
        if (code == NURBS_OK) code = nurbs_project_to_plane(spline%handle, point, normal, direction, made)
        call out%replace(made)
        call settle(code, status)
    end subroutine project_spline_to_plane

    subroutine project_spline_from(spline, eye, point, normal, out, status)
        class(nurbs_spline), intent(in) :: spline
        real(c_double), intent(in) :: eye(:), point(:), normal(:)
        type(nurbs_spline), intent(inout) :: out
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        made = c_null_ptr
        code = vectors_fit(spline, [size(eye), size(point), size(normal)])
        if (code == NURBS_OK) code = nurbs_project_from(spline%handle, eye, point, normal, made)
        call out%replace(made)
        call settle(code, status)
    end subroutine project_spline_from

    integer(c_int32_t) function vectors_fit(spline, sizes)
        class(nurbs_spline), intent(in) :: spline
        integer, intent(in) :: sizes(:)
        vectors_fit = NURBS_OK
        if (any(sizes /= dim_of(spline%handle))) vectors_fit = shape_error
    end function vectors_fit
end module nurbs_projections
