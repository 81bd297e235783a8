! SPDX-License-Identifier: MIT
!> Boxes and cones that contain a spline, proven. range(2, axes) is a part of the domain, range(:, k) of domain(k).
!> Conventions: see the module nurbs.
module nurbs_bounds
    use, intrinsic :: iso_c_binding
    use nurbs_constants
    use nurbs_c
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
        code = fitting([size(lower) == dim_of(g%handle), size(upper) == dim_of(g%handle), in_domain(g, range)])
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
        integer :: dim
        dim = dim_of(g%handle)
        code = fitting([size(center) == dim, shape(axes) == dim, size(half) == dim])
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
        code = fitting([size(direction) == dim_of(g%handle), in_domain(g, range)])
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
        code = fitting([size(direction) == dim_of(g%handle), in_domain(g, range), &
                        has_size(int(axes_of(g%handle), c_int64_t), params)])
        if (code == NURBS_OK) code = nurbs_extreme_point(g%handle, direction, range, tolerance, params, value, bound)
        call settle(code, status)
    end subroutine extreme_point

    logical function in_domain(g, range)
        class(nurbs_spline), intent(in) :: g
        real(c_double), intent(in), optional :: range(:, :)
        in_domain = has_shape(2_c_int64_t, axes_of(g%handle), range)
    end function in_domain
end module nurbs_bounds
