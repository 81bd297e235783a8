! SPDX-License-Identifier: MIT
! Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
!> Reflections and projections. Conventions: see the module nurbs.
module nurbs_projections
    use, intrinsic :: iso_c_binding
    use nurbs_constants
    use nurbs_c, only: nurbs_mirror, nurbs_project_to_plane, nurbs_project_from
    use nurbs_support
    use nurbs_splines
    implicit none
    private
    public :: mirror_spline, project_spline_to_plane, project_spline_from

contains

    !> The mirror image in the plane (line, hyperplane) through a point.
    subroutine mirror_spline(spline, point, normal, out, status)
        class(nurbs_spline), intent(in) :: spline
        real(c_double), intent(in) :: point(:), normal(:)
        type(nurbs_spline), intent(inout) :: out
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: dim
        type(c_ptr) :: made
        dim = dim_of(spline%handle)
        made = c_null_ptr
        code = fitting([fits(point, dim), fits(normal, dim)])
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
        integer(c_int64_t) :: dim
        type(c_ptr) :: made
        dim = dim_of(spline%handle)
        made = c_null_ptr
        code = fitting([fits(point, dim), fits(normal, dim), fits(direction, dim)])
        if (code == NURBS_OK) code = nurbs_project_to_plane(spline%handle, point, normal, direction, made)
        call out%replace(made)
        call settle(code, status)
    end subroutine project_spline_to_plane

    !> Projected from an eye.
    subroutine project_spline_from(spline, eye, point, normal, out, status)
        class(nurbs_spline), intent(in) :: spline
        real(c_double), intent(in) :: eye(:), point(:), normal(:)
        type(nurbs_spline), intent(inout) :: out
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: dim
        type(c_ptr) :: made
        dim = dim_of(spline%handle)
        made = c_null_ptr
        code = fitting([fits(eye, dim), fits(point, dim), fits(normal, dim)])
        if (code == NURBS_OK) code = nurbs_project_from(spline%handle, eye, point, normal, made)
        call out%replace(made)
        call settle(code, status)
    end subroutine project_spline_from
end module nurbs_projections
