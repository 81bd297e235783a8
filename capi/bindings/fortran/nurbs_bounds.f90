! SPDX-License-Identifier: MIT
! Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
!> Boxes and cones that contain a spline, proven. range(2, axes) is a part of the domain, range(:, k) of domain(k).
!> Conventions: see the module nurbs.
module nurbs_bounds
    use, intrinsic :: iso_c_binding
    use nurbs_constants
    use nurbs_c, only: nurbs_box, nurbs_oriented_box, nurbs_tangent_cone, nurbs_normal_cone, nurbs_extreme_point
    use nurbs_support
    use nurbs_splines
    implicit none
    private
    public :: bounding_box, oriented_box, tangent_cone, normal_cone, extreme_point

contains

    !> lower(dim) and upper(dim), tight to the tolerance; gap: the largest distance of a face from the spline.
    subroutine bounding_box(g, tolerance, lower, upper, gap, range, status)
        class(nurbs_spline), intent(in) :: g
        real(c_double), intent(in) :: tolerance
        real(c_double), intent(inout) :: lower(:), upper(:)
        real(c_double), intent(inout), optional :: gap
        real(c_double), intent(in), optional :: range(:, :)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: dim
        dim = dim_of(g%handle)
        code = fitting([fits(lower, dim), fits(upper, dim), fits(range, 2_c_int64_t, axes_of(g%handle))])
        if (code == NURBS_OK) code = nurbs_box(g%handle, range, tolerance, lower, upper, gap)
        call settle(code, status)
    end subroutine bounding_box

    !> The box of center(dim) + sum of x(k) axes(:, k), abs(x(k)) <= half(k).
    subroutine oriented_box(g, tolerance, center, axes, half, status)
        class(nurbs_spline), intent(in) :: g
        real(c_double), intent(in) :: tolerance
        real(c_double), intent(inout) :: center(:), axes(:, :), half(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: dim
        dim = dim_of(g%handle)
        code = fitting([fits(center, dim), fits(axes, dim, dim), fits(half, dim)])
        if (code == NURBS_OK) code = nurbs_oriented_box(g%handle, tolerance, center, axes, half)
        call settle(code, status)
    end subroutine oriented_box

    !> A unit vector direction(dim), and half the opening of the cone of all derivatives along an axis.
    subroutine tangent_cone(g, axis, tolerance, direction, angle, range, status)
        class(nurbs_spline), intent(in) :: g
        integer(c_int32_t), intent(in) :: axis
        real(c_double), intent(in) :: tolerance
        real(c_double), intent(inout) :: direction(:), angle
        real(c_double), intent(in), optional :: range(:, :)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        code = fitting([fits(direction, dim_of(g%handle)), fits(range, 2_c_int64_t, axes_of(g%handle))])
        if (code == NURBS_OK) code = nurbs_tangent_cone(g%handle, axis - 1, range, tolerance, direction, angle)
        call settle(code, status)
    end subroutine tangent_cone

    !> The same of all normals of a surface in space.
    subroutine normal_cone(g, tolerance, direction, angle, range, status)
        class(nurbs_spline), intent(in) :: g
        real(c_double), intent(in) :: tolerance
        real(c_double), intent(inout) :: direction(3), angle
        real(c_double), intent(in), optional :: range(2, 2)
        integer(c_int32_t), intent(out), optional :: status
        call settle(nurbs_normal_cone(g%handle, range, tolerance, direction, angle), status)
    end subroutine normal_cone

    !> params(axes) of the point that is farthest in a direction(dim), value: its component along that, which of no
    !> point exceeds the bound.
    subroutine extreme_point(g, direction, tolerance, params, value, bound, range, status)
        class(nurbs_spline), intent(in) :: g
        real(c_double), intent(in) :: direction(:), tolerance
        real(c_double), intent(inout), optional :: params(:), value, bound
        real(c_double), intent(in), optional :: range(:, :)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: axes
        axes = axes_of(g%handle)
        code = fitting([fits(direction, dim_of(g%handle)), fits(params, axes), fits(range, 2_c_int64_t, axes)])
        if (code == NURBS_OK) code = nurbs_extreme_point(g%handle, direction, range, tolerance, params, value, bound)
        call settle(code, status)
    end subroutine extreme_point
end module nurbs_bounds
