! SPDX-License-Identifier: MIT
! Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
!> Surfaces and volumes from curves. Conventions: see the module nurbs.
module nurbs_shapes
    use, intrinsic :: iso_c_binding
    use nurbs_constants
    use nurbs_c, only: nurbs_extrude, nurbs_revolve, nurbs_ruled, nurbs_tensor_sum, nurbs_tensor_product, &
        nurbs_surface_swung, nurbs_surface_plane, nurbs_surface_bilinear, nurbs_volume_trilinear, &
        nurbs_surface_sphere, nurbs_surface_spherical_patch, nurbs_surface_sphere_patches, nurbs_surface_ellipsoid, &
        nurbs_surface_cylinder, nurbs_surface_cone, nurbs_surface_torus, nurbs_surface_paraboloid, &
        nurbs_surface_saddle, nurbs_surface_hyperboloid
    use nurbs_support
    use nurbs_splines
    use nurbs_lists
    implicit none
    private
    public :: extrude_spline, revolve_spline, create_ruled, tensor_sum, tensor_product, create_swung, create_plane
    public :: create_bilinear, create_trilinear, create_sphere, create_spherical_patch, create_sphere_patches
    public :: create_ellipsoid, create_cylinder, create_cone, create_torus, create_paraboloid, create_saddle
    public :: create_hyperboloid

contains

    ! From curves and surfaces

    !> Moved along a vector, which becomes a new last axis.
    subroutine extrude_spline(g, vector, out, status)
        class(nurbs_spline), intent(in) :: g
        real(c_double), intent(in) :: vector(:)
        type(nurbs_spline), intent(inout) :: out
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        made = c_null_ptr
        code = fitting([fits(vector, dim_of(g%handle))])
        if (code == NURBS_OK) code = nurbs_extrude(g%handle, vector, made)
        call out%replace(made)
        call settle(code, status)
    end subroutine extrude_spline

    !> Turned about an axis through a point, the angle being a new first axis.
    subroutine revolve_spline(g, out, sweep, point, axis, form, status)
        class(nurbs_spline), intent(in) :: g
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(in), optional :: sweep, point(:), axis(:)
        integer(c_int32_t), intent(in), optional :: form
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        made = c_null_ptr
        code = fitting([fits(point, 3_c_int64_t), fits(axis, 3_c_int64_t)])
        if (code == NURBS_OK) code = nurbs_revolve(g%handle, point, axis, given(sweep, full_turn), &
            given(form, NURBS_ARC_QUARTERS), made)
        call out%replace(made)
        call settle(code, status)
    end subroutine revolve_spline

    !> Straight lines from a to b; flags: NURBS_RULED_CARTESIAN.
    subroutine create_ruled(a, b, out, flags, status)
        class(nurbs_spline), intent(in) :: a, b
        type(nurbs_spline), intent(inout) :: out
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        code = nurbs_ruled(a%handle, b%handle, given(flags, 0), made)
        call out%replace(made)
        call settle(code, status)
    end subroutine create_ruled

    !> alpha a(u) + beta b(v).
    subroutine tensor_sum(a, alpha, b, beta, out, status)
        class(nurbs_spline), intent(in) :: a, b
        real(c_double), intent(in) :: alpha, beta
        type(nurbs_spline), intent(inout) :: out
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        code = nurbs_tensor_sum(a%handle, alpha, b%handle, beta, made)
        call out%replace(made)
        call settle(code, status)
    end subroutine tensor_sum

    !> a(u) b(v), component by component.
    subroutine tensor_product(a, b, out, status)
        class(nurbs_spline), intent(in) :: a, b
        type(nurbs_spline), intent(inout) :: out
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        code = nurbs_tensor_product(a%handle, b%handle, made)
        call out%replace(made)
        call settle(code, status)
    end subroutine tensor_product

    !> (scale r(v) x(u), scale r(v) y(u), z(v)) for the trajectory (x, y) and the profile (r, z).
    subroutine create_swung(trajectory, profile, out, scale, status)
        class(nurbs_spline), intent(in) :: trajectory, profile
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(in), optional :: scale
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        code = nurbs_surface_swung(trajectory%handle, profile%handle, given(scale, 1d0), made)
        call out%replace(made)
        call settle(code, status)
    end subroutine create_swung

    ! Patches

    !> The parallelogram with two sides from an origin.
    subroutine create_plane(out, u, v, origin, status)
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(in) :: u(:), v(:)
        real(c_double), intent(in), optional :: origin(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: dim
        type(c_ptr) :: made
        dim = dimension_of(2, u, v, origin)
        made = c_null_ptr
        code = fitting([dim > 0])
        if (code == NURBS_OK) code = nurbs_surface_plane(int(dim), origin, u, v, made)
        call out%replace(made)
        call settle(code, status)
    end subroutine create_plane

    !> Over corners(4, dim), the last axis fastest.
    subroutine create_bilinear(out, corners, status)
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(in) :: corners(:, :)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: dim
        type(c_ptr) :: made
        dim = size(corners, 2, c_int64_t)
        made = c_null_ptr
        code = fitting([fits(corners, 4_c_int64_t, dim)])
        if (code == NURBS_OK) code = nurbs_surface_bilinear(int(dim), corners, step(corners), column(corners), made)
        call out%replace(made)
        call settle(code, status)
    end subroutine create_bilinear

    !> Over corners(8, dim), the last axis fastest.
    subroutine create_trilinear(out, corners, status)
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(in) :: corners(:, :)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: dim
        type(c_ptr) :: made
        dim = size(corners, 2, c_int64_t)
        made = c_null_ptr
        code = fitting([fits(corners, 8_c_int64_t, dim)])
        if (code == NURBS_OK) code = nurbs_volume_trilinear(int(dim), corners, step(corners), column(corners), made)
        call out%replace(made)
        call settle(code, status)
    end subroutine create_trilinear

    ! Spheres

    !> By longitude and latitude, with poles.
    subroutine create_sphere(out, radius, center, axis, x, form, status)
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(in) :: radius
        real(c_double), intent(in), optional :: center(:), axis(:), x(:)
        integer(c_int32_t), intent(in), optional :: form
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        made = c_null_ptr
        code = fitting([fits(center, 3_c_int64_t), fits(axis, 3_c_int64_t), fits(x, 3_c_int64_t)])
        if (code == NURBS_OK) code = nurbs_surface_sphere(center, axis, x, radius, given(form, NURBS_ARC_QUARTERS), &
            made)
        call out%replace(made)
        call settle(code, status)
    end subroutine create_sphere

    !> Between two meridians and two circles of latitude.
    subroutine create_spherical_patch(out, radius, start, sweep, south, north, center, axis, x, form, status)
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(in) :: radius, start, sweep, south, north
        real(c_double), intent(in), optional :: center(:), axis(:), x(:)
        integer(c_int32_t), intent(in), optional :: form
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        made = c_null_ptr
        code = fitting([fits(center, 3_c_int64_t), fits(axis, 3_c_int64_t), fits(x, 3_c_int64_t)])
        if (code == NURBS_OK) code = nurbs_surface_spherical_patch(center, axis, x, radius, start, sweep, south, &
            north, given(form, NURBS_ARC_QUARTERS), made)
        call out%replace(made)
        call settle(code, status)
    end subroutine create_spherical_patch

    !> Six patches of degree 4 x 4 without poles; flags: NURBS_HEMISPHERE, five patches.
    subroutine create_sphere_patches(list, radius, center, axis, x, flags, status)
        type(nurbs_list), intent(inout) :: list
        real(c_double), intent(in) :: radius
        real(c_double), intent(in), optional :: center(:), axis(:), x(:)
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        made = c_null_ptr
        code = fitting([fits(center, 3_c_int64_t), fits(axis, 3_c_int64_t), fits(x, 3_c_int64_t)])
        if (code == NURBS_OK) code = nurbs_surface_sphere_patches(center, axis, x, radius, given(flags, 0), made)
        call list%replace(made)
        call settle(code, status)
    end subroutine create_sphere_patches

    !> Semi-axes along X, Y and Z.
    subroutine create_ellipsoid(out, radii, center, axis, x, form, status)
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(in) :: radii(3)
        real(c_double), intent(in), optional :: center(:), axis(:), x(:)
        integer(c_int32_t), intent(in), optional :: form
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        made = c_null_ptr
        code = fitting([fits(center, 3_c_int64_t), fits(axis, 3_c_int64_t), fits(x, 3_c_int64_t)])
        if (code == NURBS_OK) code = nurbs_surface_ellipsoid(center, axis, x, radii(1), radii(2), radii(3), &
            given(form, NURBS_ARC_QUARTERS), made)
        call out%replace(made)
        call settle(code, status)
    end subroutine create_ellipsoid

    ! Surfaces of revolution

    !> The centre is that of the base.
    subroutine create_cylinder(out, radius, height, start, sweep, center, axis, x, form, status)
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(in) :: radius, height
        real(c_double), intent(in), optional :: start, sweep, center(:), axis(:), x(:)
        integer(c_int32_t), intent(in), optional :: form
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        made = c_null_ptr
        code = fitting([fits(center, 3_c_int64_t), fits(axis, 3_c_int64_t), fits(x, 3_c_int64_t)])
        if (code == NURBS_OK) code = nurbs_surface_cylinder(center, axis, x, radius, height, given(start, 0d0), &
            given(sweep, full_turn), given(form, NURBS_ARC_QUARTERS), made)
        call out%replace(made)
        call settle(code, status)
    end subroutine create_cylinder

    !> The centre is that of the base.
    subroutine create_cone(out, base_radius, top_radius, height, start, sweep, center, axis, x, form, status)
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(in) :: base_radius, top_radius, height
        real(c_double), intent(in), optional :: start, sweep, center(:), axis(:), x(:)
        integer(c_int32_t), intent(in), optional :: form
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        made = c_null_ptr
        code = fitting([fits(center, 3_c_int64_t), fits(axis, 3_c_int64_t), fits(x, 3_c_int64_t)])
        if (code == NURBS_OK) code = nurbs_surface_cone(center, axis, x, base_radius, top_radius, height, &
            given(start, 0d0), given(sweep, full_turn), given(form, NURBS_ARC_QUARTERS), made)
        call out%replace(made)
        call settle(code, status)
    end subroutine create_cone

    !> Angles about the axis, and about the tube.
    subroutine create_torus(out, major_radius, minor_radius, start, sweep, tube_start, tube_sweep, center, axis, x, &
            form, status)
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(in) :: major_radius, minor_radius
        real(c_double), intent(in), optional :: start, sweep, tube_start, tube_sweep, center(:), axis(:), x(:)
        integer(c_int32_t), intent(in), optional :: form
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        made = c_null_ptr
        code = fitting([fits(center, 3_c_int64_t), fits(axis, 3_c_int64_t), fits(x, 3_c_int64_t)])
        if (code == NURBS_OK) code = nurbs_surface_torus(center, axis, x, major_radius, minor_radius, &
            given(start, 0d0), given(sweep, full_turn), given(tube_start, 0d0), given(tube_sweep, full_turn), &
            given(form, NURBS_ARC_QUARTERS), made)
        call out%replace(made)
        call settle(code, status)
    end subroutine create_torus

    ! Other quadrics

    !> A bowl from its vertex to a rim with two semi-axes.
    subroutine create_paraboloid(out, radii, height, start, sweep, vertex, axis, x, form, status)
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(in) :: radii(2), height
        real(c_double), intent(in), optional :: start, sweep, vertex(:), axis(:), x(:)
        integer(c_int32_t), intent(in), optional :: form
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        made = c_null_ptr
        code = fitting([fits(vertex, 3_c_int64_t), fits(axis, 3_c_int64_t), fits(x, 3_c_int64_t)])
        if (code == NURBS_OK) code = nurbs_surface_paraboloid(vertex, axis, x, radii(1), radii(2), height, &
            given(start, 0d0), given(sweep, full_turn), given(form, NURBS_ARC_QUARTERS), made)
        call out%replace(made)
        call settle(code, status)
    end subroutine create_paraboloid

    !> The hyperbolic paraboloid over a rectangle.
    subroutine create_saddle(out, radii, height, center, axis, x, status)
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(in) :: radii(2), height
        real(c_double), intent(in), optional :: center(:), axis(:), x(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        made = c_null_ptr
        code = fitting([fits(center, 3_c_int64_t), fits(axis, 3_c_int64_t), fits(x, 3_c_int64_t)])
        if (code == NURBS_OK) code = nurbs_surface_saddle(center, axis, x, radii(1), radii(2), height, made)
        call out%replace(made)
        call settle(code, status)
    end subroutine create_saddle

    !> Between two heights; flags: NURBS_TWO_SHEETS.
    subroutine create_hyperboloid(out, radii, bottom, top, start, sweep, center, axis, x, form, flags, status)
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(in) :: radii(3), bottom, top
        real(c_double), intent(in), optional :: start, sweep, center(:), axis(:), x(:)
        integer(c_int32_t), intent(in), optional :: form, flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        made = c_null_ptr
        code = fitting([fits(center, 3_c_int64_t), fits(axis, 3_c_int64_t), fits(x, 3_c_int64_t)])
        if (code == NURBS_OK) code = nurbs_surface_hyperboloid(center, axis, x, radii(1), radii(2), radii(3), bottom, &
            top, given(start, 0d0), given(sweep, full_turn), given(form, NURBS_ARC_QUARTERS), given(flags, 0), made)
        call out%replace(made)
        call settle(code, status)
    end subroutine create_hyperboloid
end module nurbs_shapes
