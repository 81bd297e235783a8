! SPDX-License-Identifier: MIT
! Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
!> Lines, conics and helices. Conventions: see the module nurbs.
module nurbs_curves
    use, intrinsic :: iso_c_binding
    use nurbs_constants
    use nurbs_c, only: nurbs_curve_line, nurbs_curve_polyline, nurbs_curve_polygon, nurbs_curve_rounded_rectangle, &
        nurbs_curve_circle, nurbs_curve_arc, nurbs_curve_arc_through, nurbs_curve_arc_tangent, nurbs_curve_ellipse, &
        nurbs_curve_parabola, nurbs_curve_hyperbola, nurbs_curve_conic_triangle, nurbs_curve_conic_shoulder, &
        nurbs_curve_conic_point, nurbs_curve_conic_through, nurbs_conic_axes, nurbs_curve_conic_implicit, &
        nurbs_curve_conic_focus, nurbs_curve_shape_factor, nurbs_curve_helix
    use nurbs_support
    use nurbs_splines
    implicit none
    private
    public :: create_line, create_polyline, create_polygon, create_rounded_rectangle, create_circle, create_arc
    public :: create_arc_through, create_arc_tangent, create_ellipse, create_parabola, create_hyperbola
    public :: create_conic_triangle, create_conic_shoulder, create_conic_point, create_conic_through, conic_axes
    public :: create_conic_implicit, create_conic_focus, shape_factor, create_helix

contains

    ! Lines

    !> The segment from a to b.
    subroutine create_line(out, a, b, status)
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(in) :: a(:), b(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: dim
        type(c_ptr) :: made
        dim = size(a, kind=c_int64_t)
        made = c_null_ptr
        code = fitting([fits(b, dim)])
        if (code == NURBS_OK) code = nurbs_curve_line(int(dim), a, b, made)
        call out%replace(made)
        call settle(code, status)
    end subroutine create_line

    !> Through points(n, dim), at 0, 1, ..., n - 1 unless parameters are given.
    subroutine create_polyline(out, points, params, status)
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(in) :: points(:, :)
        real(c_double), intent(in), optional :: params(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        type(c_ptr) :: made
        n = size(points, 1, c_int64_t)
        made = c_null_ptr
        code = fitting([fits(params, n)])
        if (code == NURBS_OK) code = nurbs_curve_polyline(n, size(points, 2), points, step(points), column(points), &
            params, 0_c_int64_t, made)
        call out%replace(made)
        call settle(code, status)
    end subroutine create_polyline

    !> A closed regular polygon; the radius is that of its corners.
    subroutine create_polygon(out, sides, radius, center, axis, x, status)
        type(nurbs_spline), intent(inout) :: out
        integer(c_int32_t), intent(in) :: sides
        real(c_double), intent(in) :: radius
        real(c_double), intent(in), optional :: center(:), axis(:), x(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: dim
        type(c_ptr) :: made
        dim = dimension_of(2, center, axis, x)
        made = c_null_ptr
        code = fitting([dim > 0])
        if (code == NURBS_OK) code = nurbs_curve_polygon(int(dim), center, axis, x, radius, int(sides, c_int64_t), made)
        call out%replace(made)
        call settle(code, status)
    end subroutine create_polygon

    !> A closed rectangle about a centre, its corners quarter circles.
    subroutine create_rounded_rectangle(out, width, height, corner_radius, center, axis, x, status)
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(in) :: width, height, corner_radius
        real(c_double), intent(in), optional :: center(:), axis(:), x(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: dim
        type(c_ptr) :: made
        dim = dimension_of(2, center, axis, x)
        made = c_null_ptr
        code = fitting([dim > 0])
        if (code == NURBS_OK) code = nurbs_curve_rounded_rectangle(int(dim), center, axis, x, width, height, &
            corner_radius, made)
        call out%replace(made)
        call settle(code, status)
    end subroutine create_rounded_rectangle

    ! Circles

    !> The full circle, counterclockwise about the axis from the direction x.
    subroutine create_circle(out, radius, center, axis, x, form, status)
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(in) :: radius
        real(c_double), intent(in), optional :: center(:), axis(:), x(:)
        integer(c_int32_t), intent(in), optional :: form
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: dim
        type(c_ptr) :: made
        dim = dimension_of(2, center, axis, x)
        made = c_null_ptr
        code = fitting([dim > 0])
        if (code == NURBS_OK) code = nurbs_curve_circle(int(dim), center, axis, x, radius, &
            given(form, NURBS_ARC_QUARTERS), made)
        call out%replace(made)
        call settle(code, status)
    end subroutine create_circle

    !> From the angle start to start + sweep.
    subroutine create_arc(out, radius, start, sweep, center, axis, x, form, status)
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(in) :: radius, start, sweep
        real(c_double), intent(in), optional :: center(:), axis(:), x(:)
        integer(c_int32_t), intent(in), optional :: form
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: dim
        type(c_ptr) :: made
        dim = dimension_of(2, center, axis, x)
        made = c_null_ptr
        code = fitting([dim > 0])
        if (code == NURBS_OK) code = nurbs_curve_arc(int(dim), center, axis, x, radius, start, sweep, &
            given(form, NURBS_ARC_QUARTERS), made)
        call out%replace(made)
        call settle(code, status)
    end subroutine create_arc

    !> From a through b to c.
    subroutine create_arc_through(out, a, b, c, form, status)
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(in) :: a(:), b(:), c(:)
        integer(c_int32_t), intent(in), optional :: form
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: dim
        type(c_ptr) :: made
        dim = size(a, kind=c_int64_t)
        made = c_null_ptr
        code = fitting([fits(b, dim), fits(c, dim)])
        if (code == NURBS_OK) code = nurbs_curve_arc_through(int(dim), a, b, c, given(form, NURBS_ARC_QUARTERS), made)
        call out%replace(made)
        call settle(code, status)
    end subroutine create_arc_through

    !> From a in the direction of a tangent to b.
    subroutine create_arc_tangent(out, a, tangent, b, form, status)
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(in) :: a(:), tangent(:), b(:)
        integer(c_int32_t), intent(in), optional :: form
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: dim
        type(c_ptr) :: made
        dim = size(a, kind=c_int64_t)
        made = c_null_ptr
        code = fitting([fits(tangent, dim), fits(b, dim)])
        if (code == NURBS_OK) code = nurbs_curve_arc_tangent(int(dim), a, tangent, b, given(form, NURBS_ARC_QUARTERS), &
            made)
        call out%replace(made)
        call settle(code, status)
    end subroutine create_arc_tangent

    ! Conics

    !> The whole ellipse, or an arc between eccentric angles.
    subroutine create_ellipse(out, radius_x, radius_y, start, sweep, center, axis, x, form, status)
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(in) :: radius_x, radius_y
        real(c_double), intent(in), optional :: start, sweep, center(:), axis(:), x(:)
        integer(c_int32_t), intent(in), optional :: form
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: dim
        type(c_ptr) :: made
        dim = dimension_of(2, center, axis, x)
        made = c_null_ptr
        code = fitting([dim > 0])
        if (code == NURBS_OK) code = nurbs_curve_ellipse(int(dim), center, axis, x, radius_x, radius_y, &
            given(start, 0d0), given(sweep, full_turn), given(form, NURBS_ARC_QUARTERS), made)
        call out%replace(made)
        call settle(code, status)
    end subroutine create_ellipse

    !> Over [start, finish], the coordinates across; x points from the vertex to the focus.
    subroutine create_parabola(out, focal_length, start, finish, vertex, axis, x, status)
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(in) :: focal_length, start, finish
        real(c_double), intent(in), optional :: vertex(:), axis(:), x(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: dim
        type(c_ptr) :: made
        dim = dimension_of(2, vertex, axis, x)
        made = c_null_ptr
        code = fitting([dim > 0])
        if (code == NURBS_OK) code = nurbs_curve_parabola(int(dim), vertex, axis, x, focal_length, start, finish, made)
        call out%replace(made)
        call settle(code, status)
    end subroutine create_parabola

    !> The branch that opens to x.
    subroutine create_hyperbola(out, radius_x, radius_y, start, finish, center, axis, x, status)
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(in) :: radius_x, radius_y, start, finish
        real(c_double), intent(in), optional :: center(:), axis(:), x(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: dim
        type(c_ptr) :: made
        dim = dimension_of(2, center, axis, x)
        made = c_null_ptr
        code = fitting([dim > 0])
        if (code == NURBS_OK) code = nurbs_curve_hyperbola(int(dim), center, axis, x, radius_x, radius_y, start, &
            finish, made)
        call out%replace(made)
        call settle(code, status)
    end subroutine create_hyperbola

    !> By a control triangle and its shape factor w1^2 / (w0 w2).
    subroutine create_conic_triangle(out, p0, p1, p2, factor, status)
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(in) :: p0(:), p1(:), p2(:), factor
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: dim
        type(c_ptr) :: made
        dim = size(p0, kind=c_int64_t)
        made = c_null_ptr
        code = fitting([fits(p1, dim), fits(p2, dim)])
        if (code == NURBS_OK) code = nurbs_curve_conic_triangle(int(dim), p0, p1, p2, factor, made)
        call out%replace(made)
        call settle(code, status)
    end subroutine create_conic_triangle

    !> By two points with tangents and the shoulder point.
    subroutine create_conic_shoulder(out, a, tangent_a, b, tangent_b, rho, status)
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(in) :: a(:), tangent_a(:), b(:), tangent_b(:), rho
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: dim
        type(c_ptr) :: made
        dim = size(a, kind=c_int64_t)
        made = c_null_ptr
        code = fitting([fits(tangent_a, dim), fits(b, dim), fits(tangent_b, dim)])
        if (code == NURBS_OK) code = nurbs_curve_conic_shoulder(int(dim), a, tangent_a, b, tangent_b, rho, made)
        call out%replace(made)
        call settle(code, status)
    end subroutine create_conic_shoulder

    !> By two points with tangent lines, and a third point between them.
    subroutine create_conic_point(out, a, tangent_a, b, tangent_b, point, form, status)
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(in) :: a(:), tangent_a(:), b(:), tangent_b(:), point(:)
        integer(c_int32_t), intent(in), optional :: form
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: dim
        type(c_ptr) :: made
        dim = size(a, kind=c_int64_t)
        made = c_null_ptr
        code = fitting([fits(tangent_a, dim), fits(b, dim), fits(tangent_b, dim), fits(point, dim)])
        if (code == NURBS_OK) code = nurbs_curve_conic_point(int(dim), a, tangent_a, b, tangent_b, point, &
            given(form, NURBS_ARC_QUARTERS), made)
        call out%replace(made)
        call settle(code, status)
    end subroutine create_conic_point

    !> Through points(5, dim).
    subroutine create_conic_through(out, points, form, status)
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(in) :: points(:, :)
        integer(c_int32_t), intent(in), optional :: form
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: dim
        type(c_ptr) :: made
        dim = size(points, 2, c_int64_t)
        made = c_null_ptr
        code = fitting([fits(points, 5_c_int64_t, dim)])
        if (code == NURBS_OK) code = nurbs_curve_conic_through(int(dim), points, step(points), column(points), &
            given(form, NURBS_ARC_QUARTERS), made)
        call out%replace(made)
        call settle(code, status)
    end subroutine create_conic_through

    !> Of the conic A x^2 + B x y + C y^2 + D x + E y + F = 0.
    subroutine conic_axes(coefficients, kind_of_conic, origin, x, sizes, status)
        real(c_double), intent(in) :: coefficients(6)
        integer(c_int32_t), intent(inout) :: kind_of_conic
        real(c_double), intent(inout) :: origin(2), x(2), sizes(2)
        integer(c_int32_t), intent(out), optional :: status
        call settle(nurbs_conic_axes(coefficients, kind_of_conic, origin, x, sizes), status)
    end subroutine conic_axes

    !> An arc of that conic.
    subroutine create_conic_implicit(out, coefficients, start, finish, form, status)
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(in) :: coefficients(6), start, finish
        integer(c_int32_t), intent(in), optional :: form
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        code = nurbs_curve_conic_implicit(coefficients, start, finish, given(form, NURBS_ARC_QUARTERS), made)
        call out%replace(made)
        call settle(code, status)
    end subroutine create_conic_implicit

    !> By a focus, the nearest point of the directrix, and the eccentricity; in space also by the axis.
    subroutine create_conic_focus(out, focus, foot, eccentricity, start, sweep, axis, form, status)
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(in) :: focus(:), foot(:), eccentricity, start, sweep
        real(c_double), intent(in), optional :: axis(:)
        integer(c_int32_t), intent(in), optional :: form
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: dim
        type(c_ptr) :: made
        dim = dimension_of(2, focus, foot, axis)
        made = c_null_ptr
        code = fitting([dim > 0])
        if (code == NURBS_OK) code = nurbs_curve_conic_focus(int(dim), focus, axis, foot, eccentricity, start, sweep, &
            given(form, NURBS_ARC_QUARTERS), made)
        call out%replace(made)
        call settle(code, status)
    end subroutine create_conic_focus

    !> C_sf and the kind, a NURBS_CONIC_ constant, of a conic segment of degree 2.
    subroutine shape_factor(g, factor, kind_of_conic, status)
        class(nurbs_spline), intent(in) :: g
        real(c_double), intent(inout) :: factor
        integer(c_int32_t), intent(inout) :: kind_of_conic
        integer(c_int32_t), intent(out), optional :: status
        call settle(nurbs_curve_shape_factor(g%handle, factor, kind_of_conic), status)
    end subroutine shape_factor

    ! Helices

    !> A helix or, in the plane, a spiral; error: a proven bound of the distance from the true one.
    subroutine create_helix(out, radius, pitch, turns, tolerance, growth, start, origin, axis, x, error, status)
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(in) :: radius, pitch, turns, tolerance
        real(c_double), intent(in), optional :: growth, start, origin(:), axis(:), x(:)
        real(c_double), intent(inout), optional :: error
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: dim
        type(c_ptr) :: made
        dim = dimension_of(3, origin, axis, x)
        made = c_null_ptr
        code = fitting([dim > 0])
        if (code == NURBS_OK) code = nurbs_curve_helix(int(dim), origin, axis, x, radius, given(growth, 0d0), pitch, &
            given(start, 0d0), turns, tolerance, error, made)
        call out%replace(made)
        call settle(code, status)
    end subroutine create_helix
end module nurbs_curves
