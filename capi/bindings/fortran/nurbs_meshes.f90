! SPDX-License-Identifier: MIT
! Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
!> Shapes made of what is straight and flat, within a proven distance. Conventions: see the module nurbs.
module nurbs_meshes
    use, intrinsic :: iso_c_binding
    use nurbs_constants
    use nurbs_c, only: nurbs_mesh_curve, nurbs_mesh_curve_with
    use nurbs_support
    use nurbs_calls
    use nurbs_splines
    implicit none
    private
    public :: mesh_curve

contains

    !> params(n) and points(n, dim) of a polyline in place of a curve, within chord of it as proven; angle between
    !> tangents in a segment and length of segments are no larger than these, if present.
    subroutine mesh_curve(g, chord, params, points, bound, reached, angle, longest, status, call)
        class(nurbs_spline), intent(in) :: g
        real(c_double), intent(in) :: chord
        real(c_double), allocatable, intent(inout) :: params(:), points(:, :)
        real(c_double), intent(inout), optional :: bound
        logical, intent(inout), optional :: reached
        real(c_double), intent(in), optional :: angle, longest
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code, answer
        integer(c_int64_t) :: n
        real(c_double), allocatable :: points_c(:, :)
        n = 0
        answer = 0
        if (present(call)) then
            code = nurbs_mesh_curve_with(g%handle, chord, given(angle, 0d0), given(longest, 0d0), 0_c_int64_t, &
                count=n, call=watched(call))
        else
            code = nurbs_mesh_curve(g%handle, chord, given(angle, 0d0), given(longest, 0d0), 0_c_int64_t, count=n)
        end if
        if (allocated(params)) deallocate (params)
        allocate (params(n), points_c(dim_of(g%handle), n))
        if (code == NURBS_OK) then
            if (present(call)) then
                code = nurbs_mesh_curve_with(g%handle, chord, given(angle, 0d0), given(longest, 0d0), n, params, &
                    points_c, bound, answer, call=watched(call))
            else
                code = nurbs_mesh_curve(g%handle, chord, given(angle, 0d0), given(longest, 0d0), n, params, points_c, &
                    bound, answer)
            end if
        end if
        points = transpose(points_c)
        if (present(reached)) reached = answer /= 0
        call settle(code, status)
    end subroutine mesh_curve
end module nurbs_meshes
