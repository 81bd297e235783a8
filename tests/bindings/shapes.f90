! SPDX-License-Identifier: MIT
! Shapes in Fortran: one known value of each.
program shapes
    use, intrinsic :: iso_c_binding
    use, intrinsic :: ieee_arithmetic
    use nurbs
    use expectations
    implicit none
    real(c_double), parameter :: tiny_bit = 1e-14_c_double

    call lines()
    call circles()
    call conics()
    call more_conics()
    call helices()
    call from_curves()
    call patches()
    call spheres()
    call quadrics()
    call coons_surfaces()
    call coons_corners()
    call coons_volumes()
    call recognition()
    call finish()

contains

    subroutine lines()
        type(nurbs_spline) :: g
        real(c_double) :: corners(3, 2)
        integer(c_int32_t) :: code
        corners = reshape([0d0, 1d0, 1d0, 0d0, 0d0, 1d0], [3, 2])
        call create_line(g, [0d0, 0d0], [2d0, 4d0])
        call expect(on(g, 0.5d0, [1d0, 2d0]), 'a line')
        call create_line(g, [0d0, 0d0], [2d0], status=code)
        call expect(code == NURBS_ERROR_SIZE, 'ends of two dimensions')
        call create_polyline(g, corners)
        call expect(on(g, 1.5d0, [1d0, 0.5d0]), 'a polyline')
        call create_polyline(g, corners, [0d0, 2d0, 3d0])
        call expect(on(g, 1d0, [0.5d0, 0d0]), 'a polyline with parameters')
        call create_polygon(g, 4, 2d0)
        call expect(on(g, 0.25d0, [0d0, 2d0]), 'a square')
        call create_rounded_rectangle(g, 4d0, 2d0, 0.5d0, center=[0d0, 0d0, 1d0])
        call expect(on(g, 0d0, [-1.5d0, -1d0, 1d0]), 'a rounded rectangle')
    end subroutine lines

    subroutine circles()
        type(nurbs_spline) :: g
        integer(c_int32_t) :: code
        call create_circle(g, 2d0, center=[1d0, 1d0])
        call expect(on(g, 0.25d0, [1d0, 3d0]), 'a circle')
        call create_circle(g, 1d0, axis=[1d0, 0d0, 0d0], x=[0d0, 3d0, 0d0])
        call expect(on(g, 0.25d0, [0d0, 0d0, 1d0]), 'a circle in space')
        call create_circle(g, 1d0, form=NURBS_ARC_SMOOTH)
        call expect(g%count(1) == 6, 'a smooth circle')
        call create_arc(g, 1d0, 0d0, pi / 2)
        call expect(on(g, 1d0, [0d0, 1d0]), 'an arc')
        call create_arc_through(g, [1d0, 0d0], [0d0, 1d0], [-1d0, 0d0])
        call expect(on(g, 1d0, [-1d0, 0d0]), 'an arc through three points')
        call create_arc_tangent(g, [1d0, 0d0], [0d0, 1d0], [-1d0, 0d0])
        call expect(on(g, 0.5d0, [0d0, 1d0]), 'an arc with a tangent')
        call create_circle(g, -1d0, status=code)
        call expect(code == NURBS_ERROR_LENGTH, 'a negative radius')
        call create_circle(g, 1d0, form=7, status=code)
        call expect(code == NURBS_ERROR_FORM, 'no form')
        call create_arc(g, 1d0, 0d0, 7d0, status=code)
        call expect(code == NURBS_ERROR_ANGLE, 'more than a turn')
        call create_arc_through(g, [0d0, 0d0], [1d0, 1d0], [2d0, 2d0], status=code)
        call expect(code == NURBS_ERROR_COLLINEAR, 'three points on a line')
        call create_circle(g, 1d0, center=[0d0, 0d0], axis=[0d0, 0d0, 1d0], status=code)
        call expect(code == NURBS_ERROR_SIZE, 'a placement of two dimensions')
    end subroutine circles

    subroutine conics()
        type(nurbs_spline) :: g
        real(c_double) :: point(1, 2), five(5, 2), equation(6), origin(2), x(2), sizes(2)
        integer(c_int32_t) :: found, code
        call create_ellipse(g, 2d0, 1d0)
        call expect(on(g, 0.25d0, [0d0, 1d0]), 'an ellipse')
        call create_parabola(g, 1d0, -2d0, 2d0)
        call expect(on(g, 2d0, [1d0, 2d0]), 'a parabola')
        call create_hyperbola(g, 1d0, 2d0, 0d0, 1d0)
        call expect(on(g, 1d0, [cosh(1d0), 2 * sinh(1d0)]), 'a hyperbola')
        call create_circle(g, 1d0)
        call g%eval([0d0, 0.1d0, 0.2d0, 0.3d0, 0.4d0], five)
        call create_conic_through(g, five)
        call g%eval([0.3d0], point)
        call expect(abs(norm2(point) - 1) <= 1d-12, 'a conic through five points')
        equation = [1, 0, 4, 0, 0, -4]
        call conic_axes(equation, found, origin, x, sizes)
        call expect(found == NURBS_CONIC_ELLIPSE .and. all(abs(sizes - [2, 1]) <= tiny_bit), 'axes of a conic')
        call create_conic_implicit(g, equation, 0d0, 2 * pi)
        call g%eval([0.25d0], point)
        call expect(abs(abs(point(1, 2)) - 1) <= tiny_bit, 'a conic by its equation')
        equation(6) = 4
        call conic_axes(equation, found, origin, x, sizes, status=code)
        call expect(code == NURBS_ERROR_CONIC, 'no points')
    end subroutine conics

    subroutine more_conics()
        type(nurbs_spline) :: g
        real(c_double) :: point(1, 2), factor
        integer(c_int32_t) :: found
        call create_conic_shoulder(g, [0d0, 0d0], [1d0, 1d0], [2d0, 0d0], [1d0, -1d0], 0.5d0)
        call expect(on(g, 0.5d0, [1d0, 0.5d0]), 'a conic with a shoulder')
        call create_conic_point(g, [-1d0, 0d0], [0d0, 1d0], [1d0, 0d0], [0d0, 1d0], [0d0, 1d0])
        call g%eval([0.2d0], point)
        call expect(abs(norm2(point) - 1) <= tiny_bit, 'a conic through a point')
        call create_conic_focus(g, [0d0, 0d0], [1d0, 0d0], 1d0, -pi / 2, pi)
        call expect(on(g, 0.5d0, [0.5d0, 0d0]), 'a conic by its focus')
        call create_conic_triangle(g, [0d0, 0d0], [1d0, 1d0], [2d0, 0d0], ieee_value(factor, ieee_positive_inf))
        call expect(on(g, 0.5d0, [1d0, 1d0]), 'the legs of a triangle')
        call create_conic_triangle(g, [0d0, 0d0], [1d0, 1d0], [2d0, 0d0], 4d0)
        call shape_factor(g, factor, found)
        call expect(factor == 4 .and. found == NURBS_CONIC_HYPERBOLA, 'a shape factor')
    end subroutine more_conics

    subroutine helices()
        type(nurbs_spline) :: g
        real(c_double) :: error
        call create_helix(g, 1d0, 2d0, 3d0, 1d-6, origin=[0d0, 0d0, 1d0], error=error)
        call expect(on(g, 3d0, [1d0, 0d0, 7d0]) .and. error <= 1d-6, 'a helix')
        call create_helix(g, 0d0, 0d0, 1d0, 1d-6, growth=1d0, origin=[0d0, 0d0])
        call expect(on(g, 1d0, [1d0, 0d0]), 'a spiral')
    end subroutine helices

    subroutine from_curves()
        type(nurbs_spline) :: a, b, g
        call create_line(a, [0d0, 0d0, 0d0], [1d0, 0d0, 0d0])
        call create_line(b, [0d0, 1d0, 0d0], [1d0, 1d0, 2d0])
        call extrude_spline(a, [0d0, 2d0, 0d0], g)
        call expect(at(g, [0.5d0, 0.5d0], [0.5d0, 1d0, 0d0]), 'an extrusion')
        call create_ruled(a, b, g)
        call expect(at(g, [0.5d0, 0.5d0], [0.5d0, 0.5d0, 0.5d0]), 'a ruled surface')
        call create_ruled(a, b, g, NURBS_RULED_CARTESIAN)
        call expect(at(g, [0.5d0, 0.5d0], [0.5d0, 0.5d0, 0.5d0]), 'evenly ruled')
        call tensor_sum(a, 2d0, b, 3d0, g)
        call expect(at(g, [0.5d0, 0.5d0], [2.5d0, 3d0, 3d0]), 'a translational sweep')
        call create_line(a, [1d0, 0d0, 0d0], [1d0, 0d0, 1d0])
        call revolve_spline(a, g)
        call expect(at(g, [0.25d0, 0.5d0], [0d0, 1d0, 0.5d0]), 'a surface of revolution')
        call revolve_spline(a, g, pi, [2d0, 0d0, 0d0], [0d0, 0d0, 2d0])
        call expect(at(g, [1d0, 0.5d0], [3d0, 0d0, 0.5d0]), 'half a turn')
        call create_line(a, [1d0], [3d0])
        call create_line(b, [1d0, 2d0], [1d0, 4d0])
        call tensor_product(a, b, g)
        call expect(at(g, [0.5d0, 0.5d0], [2d0, 6d0]), 'a product')
        call create_circle(a, 1d0)
        call create_line(b, [1d0, 0d0], [2d0, 1d0])
        call create_swung(a, b, g, 2d0)
        call expect(at(g, [0.25d0, 0.5d0], [0d0, 3d0, 0.5d0]), 'a swung surface')
    end subroutine from_curves

    subroutine patches()
        type(nurbs_spline) :: g
        call create_plane(g, [2d0, 0d0, 0d0], [0d0, 1d0, 0d0], [1d0, 1d0, 1d0])
        call expect(at(g, [0.5d0, 0.5d0], [2d0, 1.5d0, 1d0]), 'a plane')
        call create_bilinear(g, reshape([0d0, 1d0, 2d0, 5d0], [4, 1]))
        call expect(at(g, [0.5d0, 0.5d0], [2d0]), 'a bilinear patch')
        call create_trilinear(g, reshape([0d0, 1d0, 2d0, 3d0, 4d0, 5d0, 6d0, 7d0], [8, 1]))
        call expect(at(g, [0.5d0, 0.5d0, 0.5d0], [3.5d0]), 'a trilinear volume')
    end subroutine patches

    subroutine spheres()
        type(nurbs_spline) :: g
        type(nurbs_list) :: list
        integer(c_int32_t) :: code
        character(len=:), allocatable :: text
        call create_sphere(g, 2d0, center=[1d0, 0d0, 0d0])
        call expect(at(g, [0.25d0, 0.5d0], [1d0, 2d0, 0d0]), 'a sphere')
        call create_sphere(g, 2d0, center=[1d0, 0d0], status=code)
        call expect(code == NURBS_ERROR_SIZE, 'a sphere in the plane')
        call create_spherical_patch(g, 1d0, 0d0, pi / 2, 0d0, pi / 2)
        call expect(at(g, [1d0, 0d0], [0d0, 1d0, 0d0]), 'a patch of a sphere')
        call create_sphere_patches(list, 1d0)
        call list%name(5, text)
        call expect(list%count() == 6 .and. text == '+Z', 'six patches')
        call create_sphere_patches(list, 1d0, flags=NURBS_HEMISPHERE)
        call expect(list%count() == 5, 'five patches')
        call create_ellipsoid(g, [1d0, 2d0, 3d0])
        call expect(at(g, [0.25d0, 0.5d0], [0d0, 2d0, 0d0]), 'an ellipsoid')
    end subroutine spheres

    subroutine quadrics()
        type(nurbs_spline) :: g
        real(c_double) :: p(1, 3)
        call create_cylinder(g, 2d0, 3d0)
        call expect(at(g, [0.25d0, 1d0], [0d0, 2d0, 3d0]), 'a cylinder')
        call create_cone(g, 1d0, 0d0, 2d0)
        call expect(at(g, [0.25d0, 0.5d0], [0d0, 0.5d0, 1d0]), 'a cone')
        call create_torus(g, 2d0, 0.5d0)
        call expect(at(g, [0.25d0, 0.5d0], [0d0, 1.5d0, 0d0]), 'a torus')
        call create_paraboloid(g, [1d0, 1d0], 1d0)
        call expect(at(g, [0.25d0, 0.5d0], [0d0, 0.5d0, 0.25d0]), 'a paraboloid')
        call create_saddle(g, [1d0, 1d0], 1d0)
        call expect(at(g, [1d0, 0.5d0], [1d0, 0d0, 1d0]), 'a saddle')
        call create_hyperboloid(g, [1d0, 1d0, 1d0], -1d0, 1d0)
        call g%eval(reshape([0.3d0, 0.7d0], [1, 2]), p)
        call expect(abs(p(1, 1)**2 + p(1, 2)**2 - p(1, 3)**2 - 1) <= tiny_bit, 'one sheet')
        call create_hyperboloid(g, [1d0, 1d0, 1d0], 1d0, 2d0, flags=NURBS_TWO_SHEETS)
        call g%eval(reshape([0.3d0, 0.7d0], [1, 2]), p)
        call expect(abs(p(1, 3)**2 - p(1, 1)**2 - p(1, 2)**2 - 1) <= tiny_bit, 'two sheets')
    end subroutine quadrics

    ! z = u v over the unit square: its boundaries and the derivatives across them.
    subroutine make_boundaries(curves, cross)
        type(nurbs_spline), intent(inout) :: curves(4), cross(4)
        type(nurbs_spline) :: patch, slopes
        type(nurbs_list) :: list
        integer :: i
        call create_bilinear(patch, reshape([0d0, 0d0, 1d0, 1d0, 0d0, 1d0, 0d0, 1d0, 0d0, 0d0, 0d0, 1d0], [4, 3]))
        call spline_boundaries(patch, list)
        do i = 1, 4
            call list%get(i, curves(i))
            call spline_derivative(patch, (i + 1) / 2, 1, slopes)
            call slopes%iso((i + 1) / 2, real(modulo(i + 1, 2), c_double), cross(i))
        end do
    end subroutine make_boundaries

    subroutine coons_surfaces()
        type(nurbs_spline) :: curves(4), cross(4), g
        real(c_double) :: twists(4, 3), bound
        integer(c_int32_t) :: code
        call make_boundaries(curves, cross)
        call create_coons(g, curves)
        call expect(at(g, [0.25d0, 0.5d0], [0.25d0, 0.5d0, 0.125d0]), 'a Coons surface')
        call create_coons_hermite(g, curves, NURBS_TWIST_BILINEAR)
        call expect(at(g, [0.25d0, 0.5d0], [0.25d0, 0.5d0, 0.125d0]), 'a bicubic one')
        call create_coons_hermite(g, curves, NURBS_TWIST_COMPATIBLE, cross, bound=bound)
        call expect(at(g, [0.25d0, 0.5d0], [0.25d0, 0.5d0, 0.125d0]) .and. bound == 0, 'with cross tangents')
        twists = 0
        twists(:, 3) = 1
        call create_coons_hermite(g, curves, NURBS_TWIST_GIVEN, twists=twists)
        call expect(at(g, [0.25d0, 0.5d0], [0.25d0, 0.5d0, 0.125d0]), 'with twists')
        call create_coons_hermite(g, curves, 9, cross, status=code)
        call expect(code == NURBS_ERROR_TWIST_RULE, 'no rule for twists')
        call create_coons_hermite(g, curves, NURBS_TWIST_GIVEN, twists=twists(:, :2), status=code)
        call expect(code == NURBS_ERROR_SIZE, 'twists of two dimensions')
    end subroutine coons_surfaces

    subroutine coons_corners()
        type(nurbs_spline) :: curves(4), cross(4), g
        real(c_double) :: positions(4), tangents(4, 2), twists(4)
        integer(c_int32_t) :: code
        call make_boundaries(curves, cross)
        call coons_gaps(curves, positions)
        call expect(all(positions == 0), 'no gaps')
        call create_line(cross(1), [2d0, 0d0, 0d0], [2d0, 0d0, 1d0])
        call coons_gaps(curves, positions, cross, tangents, twists)
        call expect(all(tangents(1, :) == [1, 0]) .and. all(twists == 0), 'gaps of tangents')
        call create_coons_hermite(g, curves, NURBS_TWIST_AVERAGE, cross, status=code)
        call expect(code == NURBS_ERROR_TANGENT, 'tangents that differ')
        call create_line(curves(4), [0d0, 1d0, 3d0], [1d0, 1d0, 1d0])
        call coons_gaps(curves, positions)
        call expect(all(positions == [0, 3, 0, 0]), 'a gap')
        call create_coons(g, curves, 1d0, status=code)
        call expect(code == NURBS_ERROR_GAP, 'a gap that is too large')
    end subroutine coons_corners

    subroutine coons_volumes()
        type(nurbs_spline) :: cube, faces(6), g
        type(nurbs_list) :: list
        real(c_double) :: corners(8, 3)
        integer :: i
        do i = 1, 8
            corners(i, :) = real([(i - 1) / 4, modulo((i - 1) / 2, 2), modulo(i - 1, 2)], c_double)
        end do
        call create_trilinear(cube, corners)
        call spline_boundaries(cube, list)
        do i = 1, 6
            call list%get(i, faces(i))
        end do
        call create_coons_volume(g, faces)
        call expect(at(g, [0.25d0, 0.5d0, 0.75d0], [0.25d0, 0.5d0, 0.75d0]), 'a Coons volume')
    end subroutine coons_volumes

    subroutine recognition()
        type(nurbs_spline) :: g
        type(recognized_shape) :: found
        call create_circle(g, 2d0, center=[1d0, 1d0])
        call recognize_spline(g, 1d-9, found)
        call expect(found%shape == NURBS_SHAPE_CIRCLE .and. all(found%axis == [0, 0, 1]), 'a circle is found')
        call expect(all(abs(found%origin - [1, 1, 0]) <= tiny_bit), 'its centre')
        call expect(abs(found%sizes(1) - 2) <= tiny_bit .and. found%deviation <= 1d-9, 'its radius')
        call g%create_bezier([3], reshape([0d0, 1d0, 2d0, 3d0, 0d0, 2d0, -2d0, 0d0], [4, 2]))
        call recognize_spline(g, 1d-3, found)
        call expect(found%shape == NURBS_SHAPE_NONE, 'nothing is found')
    end subroutine recognition
end program shapes
