! SPDX-License-Identifier: MIT
! Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
!> Surfaces and volumes from their boundaries: curves(4) and faces(6), counted by axis, then by end. Conventions: see
!> the module nurbs.
module nurbs_coons
    use, intrinsic :: iso_c_binding
    use nurbs_constants
    use nurbs_c, only: nurbs_boundaries, nurbs_surface_coons, nurbs_surface_coons_hermite, nurbs_coons_gaps, &
        nurbs_volume_coons
    use nurbs_support
    use nurbs_handles
    use nurbs_splines
    use nurbs_lists
    implicit none
    private
    public :: spline_boundaries, create_coons, create_coons_hermite, coons_gaps, create_coons_volume

contains

    !> The four curves of a surface, or the six faces of a volume.
    subroutine spline_boundaries(g, list, status)
        class(nurbs_spline), intent(in) :: g
        type(nurbs_list), intent(inout) :: list
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        code = nurbs_boundaries(g%handle, made)
        call list%replace(made)
        call settle(code, status)
    end subroutine spline_boundaries

    !> The bilinear blend of four curves.
    subroutine create_coons(out, curves, tolerance, status)
        type(nurbs_spline), intent(inout) :: out
        type(nurbs_spline), intent(in) :: curves(4)
        real(c_double), intent(in), optional :: tolerance
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        code = nurbs_surface_coons(handles_of(curves), given(tolerance, 0d0), made)
        call out%replace(made)
        call settle(code, status)
    end subroutine create_coons

    !> The bicubic blend of four curves and, if present, derivatives across them; twists(4, dim) for NURBS_TWIST_GIVEN;
    !> bound: the largest difference between the twists and those of the cross tangents.
    subroutine create_coons_hermite(out, curves, twist, cross, twists, tolerance, bound, status)
        type(nurbs_spline), intent(inout) :: out
        type(nurbs_spline), intent(in) :: curves(4)
        integer(c_int32_t), intent(in) :: twist
        type(nurbs_spline), intent(in), optional :: cross(4)
        real(c_double), intent(in), optional :: twists(:, :), tolerance
        real(c_double), intent(inout), optional :: bound
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr), allocatable :: cross_c(:)
        real(c_double), allocatable :: twists_c(:, :)
        type(c_ptr) :: made
        made = c_null_ptr
        code = fitting([fits(twists, 4_c_int64_t, dim_of(curves(1)%handle))])
        if (present(cross)) cross_c = handles_of(cross)
        if (present(twists)) twists_c = transpose(twists)
        if (code == NURBS_OK) code = nurbs_surface_coons_hermite(handles_of(curves), cross_c, twist, twists_c, &
            given(tolerance, 0d0), bound, made)
        call out%replace(made)
        call settle(code, status)
    end subroutine create_coons_hermite

    !> Differences at the corners (1, 1), (1, 2), (2, 1), (2, 2): of positions, of tangents by u and by v, of twists.
    subroutine coons_gaps(curves, positions, cross, tangents, twists, status)
        type(nurbs_spline), intent(in) :: curves(4)
        real(c_double), intent(inout) :: positions(4)
        type(nurbs_spline), intent(in), optional :: cross(4)
        real(c_double), intent(inout), optional :: tangents(4, 2), twists(4)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr), allocatable :: cross_c(:)
        real(c_double) :: tangents_c(2, 4)
        if (present(cross)) cross_c = handles_of(cross)
        code = nurbs_coons_gaps(handles_of(curves), cross_c, positions, tangents_c, twists)
        if (code == NURBS_OK) then
            if (present(tangents)) tangents = transpose(tangents_c)
        end if
        call settle(code, status)
    end subroutine coons_gaps

    !> The linear blend of six faces.
    subroutine create_coons_volume(out, faces, tolerance, status)
        type(nurbs_spline), intent(inout) :: out
        type(nurbs_spline), intent(in) :: faces(6)
        real(c_double), intent(in), optional :: tolerance
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        code = nurbs_volume_coons(handles_of(faces), given(tolerance, 0d0), made)
        call out%replace(made)
        call settle(code, status)
    end subroutine create_coons_volume
end module nurbs_coons
