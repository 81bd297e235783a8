! SPDX-License-Identifier: MIT
!> Surfaces and volumes from curves. Conventions: see the module nurbs.
module nurbs_shapes
    use, intrinsic :: iso_c_binding
    use nurbs_constants
    use nurbs_c
    use nurbs_support
    use nurbs_splines
    use nurbs_lists
    use nurbs_placements
    implicit none
    private
    public :: extrude_spline, revolve_spline, create_ruled, tensor_sum, tensor_product, create_swung, create_plane, &
        create_bilinear, create_trilinear, create_sphere, create_spherical_patch, create_sphere_patches, &
        create_ellipsoid, create_cylinder, create_cone, create_torus, create_paraboloid, create_saddle, &
        create_hyperboloid

contains

    !> Moved along a vector, which becomes a new last axis.
    subroutine extrude_spline(g, vector, out, status)
        class(nurbs_spline), intent(in) :: g
        real(c_double), intent(in) :: vector(:)
        type(nurbs_spline), intent(inout) :: out
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        made = c_null_ptr
        code = shape_error
        if (size(vector) == dim_of(g%handle)) code = nurbs_extrude(g%handle, vector, made)
        call hand_over(code, made, out, status)
    end subroutine extrude_spline

    !> Turned about an axis through a point, the angle being a new first axis.
    subroutine revolve_spline(g, out, sweep, point, axis, form, status)
        class(nurbs_spline), intent(in) :: g
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(in), optional :: sweep
        real(c_double), intent(in), optional :: point(:), axis(:)
        integer(c_int32_t), intent(in), optional :: form
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        made = c_null_ptr
        code = shape_error
        if (dimension_of(3, point, axis) == 3) code = nurbs_revolve(g%handle, point, axis, given(sweep, full_turn), &
            arc_form(form), made)
        call hand_over(code, made, out, status)
    end subroutine revolve_spline

    !> Straight lines from a to b; flags: NURBS_RULED_CARTESIAN.
    subroutine create_ruled(a, b, out, flags, status)
        class(nurbs_spline), intent(in) :: a, b
        type(nurbs_spline), intent(inout) :: out
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        code = nurbs_ruled(a%handle, b%handle, bits(flags), made)
        call hand_over(code, made, out, status)
    end subroutine create_ruled

    !> alpha a(u) + beta b(v)
    subroutine tensor_sum(a, alpha, b, beta, out, status)
        class(nurbs_spline), intent(in) :: a, b
        real(c_double), intent(in) :: alpha, beta
        type(nurbs_spline), intent(inout) :: out
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        code = nurbs_tensor_sum(a%handle, alpha, b%handle, beta, made)
        call hand_over(code, made, out, status)
    end subroutine tensor_sum

    !> a(u) b(v), component by component
    subroutine tensor_product(a, b, out, status)
        class(nurbs_spline), intent(in) :: a, b
        type(nurbs_spline), intent(inout) :: out
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        code = nurbs_tensor_product(a%handle, b%handle, made)
        call hand_over(code, made, out, status)
    end subroutine tensor_product

    !> (scale r(v) x(u), scale r(v) y(u), z(v)) for the trajectory (x, y) and the profile (r, z)
    subroutine create_swung(trajectory, profile, out, scale, status)
        class(nurbs_spline), intent(in) :: trajectory, profile
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(in), optional :: scale
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        code = nurbs_surface_swung(trajectory%handle, profile%handle, given(scale, 1d0), made)
        call hand_over(code, made, out, status)
    end subroutine create_swung

    !> The parallelogram with two sides from an origin.
    subroutine create_plane(out, u, v, origin, status)
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(in) :: u(:), v(:)
        real(c_double), intent(in), optional :: origin(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code, dim
        type(c_ptr) :: made
        made = c_null_ptr
        dim = dimension_of(0, u, v, origin)
        code = shape_error
        if (dim > 0) code = nurbs_surface_plane(dim, origin, u, v, made)
        call hand_over(code, made, out, status)
    end subroutine create_plane

    !> Over corners(4, dim), the last axis fastest.
    subroutine create_bilinear(out, corners, status)
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(in) :: corners(:, :)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        made = c_null_ptr
        code = shape_error
        if (size(corners, 1) == 4) code = nurbs_surface_bilinear(size(corners, 2), corners, step(corners), &
            column(corners), made)
        call hand_over(code, made, out, status)
    end subroutine create_bilinear

    !> Over corners(8, dim), the last axis fastest.
    subroutine create_trilinear(out, corners, status)
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(in) :: corners(:, :)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        made = c_null_ptr
        code = shape_error
        if (size(corners, 1) == 8) code = nurbs_volume_trilinear(size(corners, 2), corners, step(corners), &
            column(corners), made)
        call hand_over(code, made, out, status)
    end subroutine create_trilinear

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
        code = shape_error
        if (dimension_of(3, center, axis, x) == 3) code = nurbs_surface_sphere(center, axis, x, radius, &
            arc_form(form), made)
        call hand_over(code, made, out, status)
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
        code = shape_error
        if (dimension_of(3, center, axis, x) == 3) code = nurbs_surface_spherical_patch(center, axis, x, radius, &
            start, sweep, south, north, arc_form(form), made)
        call hand_over(code, made, out, status)
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
        code = shape_error
        if (dimension_of(3, center, axis, x) == 3) code = nurbs_surface_sphere_patches(center, axis, x, radius, &
            bits(flags), made)
        call list%destroy()
        list%handle = made
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
        code = shape_error
        if (dimension_of(3, center, axis, x) == 3) code = nurbs_surface_ellipsoid(center, axis, x, radii(1), &
            radii(2), radii(3), arc_form(form), made)
        call hand_over(code, made, out, status)
    end subroutine create_ellipsoid

    !> The centre is that of the base.
    subroutine create_cylinder(out, radius, height, start, sweep, center, axis, x, form, status)
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(in) :: radius, height
        real(c_double), intent(in), optional :: start, sweep
        real(c_double), intent(in), optional :: center(:), axis(:), x(:)
        integer(c_int32_t), intent(in), optional :: form
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        made = c_null_ptr
        code = shape_error
        if (dimension_of(3, center, axis, x) == 3) code = nurbs_surface_cylinder(center, axis, x, radius, height, &
            given(start, 0d0), given(sweep, full_turn), arc_form(form), made)
        call hand_over(code, made, out, status)
    end subroutine create_cylinder

    !> The centre is that of the base.
    subroutine create_cone(out, base_radius, top_radius, height, start, sweep, center, axis, x, form, status)
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(in) :: base_radius, top_radius, height
        real(c_double), intent(in), optional :: start, sweep
        real(c_double), intent(in), optional :: center(:), axis(:), x(:)
        integer(c_int32_t), intent(in), optional :: form
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        made = c_null_ptr
        code = shape_error
        if (dimension_of(3, center, axis, x) == 3) code = nurbs_surface_cone(center, axis, x, base_radius, &
            top_radius, height, given(start, 0d0), given(sweep, full_turn), arc_form(form), made)
        call hand_over(code, made, out, status)
    end subroutine create_cone

    !> Angles about the axis, and about the tube.
    subroutine create_torus(out, major_radius, minor_radius, start, sweep, tube_start, tube_sweep, center, axis, x, &
        form, status)
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(in) :: major_radius, minor_radius
        real(c_double), intent(in), optional :: start, sweep, tube_start, tube_sweep
        real(c_double), intent(in), optional :: center(:), axis(:), x(:)
        integer(c_int32_t), intent(in), optional :: form
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        made = c_null_ptr
        code = shape_error
        if (dimension_of(3, center, axis, x) == 3) code = nurbs_surface_torus(center, axis, x, major_radius, &
            minor_radius, given(start, 0d0), given(sweep, full_turn), given(tube_start, 0d0), given(tube_sweep, &
            full_turn), arc_form(form), made)
        call hand_over(code, made, out, status)
    end subroutine create_torus

    !> A bowl from its vertex to a rim with two semi-axes.
    subroutine create_paraboloid(out, radii, height, start, sweep, vertex, axis, x, form, status)
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(in) :: radii(2)
        real(c_double), intent(in) :: height
        real(c_double), intent(in), optional :: start, sweep
        real(c_double), intent(in), optional :: vertex(:), axis(:), x(:)
        integer(c_int32_t), intent(in), optional :: form
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        made = c_null_ptr
        code = shape_error
        if (dimension_of(3, vertex, axis, x) == 3) code = nurbs_surface_paraboloid(vertex, axis, x, radii(1), &
            radii(2), height, given(start, 0d0), given(sweep, full_turn), arc_form(form), made)
        call hand_over(code, made, out, status)
    end subroutine create_paraboloid

    !> The hyperbolic paraboloid over a rectangle.
    subroutine create_saddle(out, radii, height, center, axis, x, status)
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(in) :: radii(2)
        real(c_double), intent(in) :: height
        real(c_double), intent(in), optional :: center(:), axis(:), x(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        made = c_null_ptr
        code = shape_error
        if (dimension_of(3, center, axis, x) == 3) code = nurbs_surface_saddle(center, axis, x, radii(1), radii(2), &
            height, made)
        call hand_over(code, made, out, status)
    end subroutine create_saddle

    !> Between two heights; flags: NURBS_TWO_SHEETS.
    subroutine create_hyperboloid(out, radii, bottom, top, start, sweep, center, axis, x, form, flags, status)
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(in) :: radii(3)
        real(c_double), intent(in) :: bottom, top
        real(c_double), intent(in), optional :: start, sweep
        real(c_double), intent(in), optional :: center(:), axis(:), x(:)
        integer(c_int32_t), intent(in), optional :: form, flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        made = c_null_ptr
        code = shape_error
        if (dimension_of(3, center, axis, x) == 3) code = nurbs_surface_hyperboloid(center, axis, x, radii(1), &
            radii(2), radii(3), bottom, top, given(start, 0d0), given(sweep, full_turn), arc_form(form), &
            bits(flags), made)
        call hand_over(code, made, out, status)
    end subroutine create_hyperboloid
end module nurbs_shapes
