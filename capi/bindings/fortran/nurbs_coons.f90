! SPDX-License-Identifier: MIT
!> Surfaces and volumes from their boundaries: curves(4) and faces(6), counted by axis, then by end.
!> Conventions: see the module nurbs.
module nurbs_coons
    use, intrinsic :: iso_c_binding
    use nurbs_constants
    use nurbs_c
    use nurbs_support
    use nurbs_splines
    use nurbs_lists
    use nurbs_placements
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
        call list%destroy()
        list%handle = made
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
        call hand_over(code, made, out, status)
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
        type(c_ptr) :: made
        type(c_ptr), allocatable :: across(:)
        real(c_double), allocatable :: rows(:, :)
        made = c_null_ptr
        code = NURBS_OK
        if (present(cross)) across = handles_of(cross)
        if (present(twists)) then
            rows = transpose(twists)
            if (any(shape(twists) /= [4, dim_of(curves(1)%handle)])) code = shape_error
        end if
        ! A variable that is not allocated counts as an argument that is not present.
        if (code == NURBS_OK) code = nurbs_surface_coons_hermite(handles_of(curves), across, twist, rows, &
            given(tolerance, 0d0), bound, made)
        call hand_over(code, made, out, status)
    end subroutine create_coons_hermite

    !> Differences at the corners (1, 1), (1, 2), (2, 1), (2, 2): of positions, of tangents by u and by v, of twists.
    subroutine coons_gaps(curves, positions, cross, tangents, twists, status)
        type(nurbs_spline), intent(in) :: curves(4)
        real(c_double), intent(inout) :: positions(4)
        type(nurbs_spline), intent(in), optional :: cross(4)
        real(c_double), intent(inout), optional :: tangents(4, 2), twists(4)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr), allocatable :: across(:)
        real(c_double) :: rows(2, 4)
        if (present(cross)) across = handles_of(cross)
        code = nurbs_coons_gaps(handles_of(curves), across, positions, rows, twists)
        if (present(tangents) .and. code == NURBS_OK) tangents = transpose(rows)
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
        call hand_over(code, made, out, status)
    end subroutine create_coons_volume
end module nurbs_coons
