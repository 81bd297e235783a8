! SPDX-License-Identifier: MIT
! Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
!> Where shapes meet; every answer says whether it is complete. Conventions: see the module nurbs.
module nurbs_intersections
    use, intrinsic :: iso_c_binding
    use nurbs_constants
    use nurbs_c, only: nurbs_roots, nurbs_curve_level, nurbs_curve_intersections, nurbs_curve_self_intersections, &
        nurbs_curve_surface_intersections, nurbs_surfaces_common_points, nurbs_surface_rays, nurbs_surface_ray_hits, &
        nurbs_roots_with, nurbs_curve_level_with, nurbs_curve_intersections_with, nurbs_curve_self_intersections_with, &
        nurbs_curve_surface_intersections_with, nurbs_surfaces_common_points_with, nurbs_surface_rays_with
    use nurbs_support
    use nurbs_calls
    use nurbs_splines
    implicit none
    private
    public :: roots, curve_level, curve_intersections, self_intersections, surface_intersections, common_points, rays
    public :: ray_hits

contains

    !> params(n) in rising order where a scalar curve has a value, kinds(n) one NURBS_HIT_ constant each, and ranges(2,
    !> n) outside of which there is no root.
    subroutine roots(g, params, kinds, ranges, complete, value, tolerance, status, call)
        class(nurbs_spline), intent(in) :: g
        real(c_double), allocatable, intent(inout) :: params(:), ranges(:, :)
        integer(c_int32_t), allocatable, intent(inout) :: kinds(:)
        logical, intent(inout), optional :: complete
        real(c_double), intent(in), optional :: value, tolerance
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code, answer
        integer(c_int64_t) :: n
        real(c_double), allocatable :: ranges_c(:, :)
        n = 0
        answer = 0
        if (present(call)) then
            code = nurbs_roots_with(g%handle, given(value, 0d0), given(tolerance, 0d0), 0_c_int64_t, count=n, &
                call=watched(call))
        else
            code = nurbs_roots(g%handle, given(value, 0d0), given(tolerance, 0d0), 0_c_int64_t, count=n)
        end if
        if (allocated(params)) deallocate (params)
        if (allocated(kinds)) deallocate (kinds)
        allocate (params(n), kinds(n), ranges_c(2, n))
        if (code == NURBS_OK) then
            if (present(call)) then
                code = nurbs_roots_with(g%handle, given(value, 0d0), given(tolerance, 0d0), n, params, kinds, &
                    ranges_c, complete=answer, call=watched(call))
            else
                code = nurbs_roots(g%handle, given(value, 0d0), given(tolerance, 0d0), n, params, kinds, ranges_c, &
                    complete=answer)
            end if
        end if
        ranges = transpose(ranges_c)
        if (present(complete)) complete = answer /= 0
        call settle(code, status)
    end subroutine roots

    !> Where a curve meets a line, a plane, a conic, a quadric or another set on which a polynomial of a degree is 0;
    !> its coefficients are those of products x_i x_j ... with i <= j <= ..., in lexicographic order, where x_dim stands
    !> for 1.
    subroutine curve_level(g, degree, coefficients, params, kinds, ranges, complete, tolerance, status, call)
        class(nurbs_spline), intent(in) :: g
        integer(c_int32_t), intent(in) :: degree
        real(c_double), intent(in) :: coefficients(:)
        real(c_double), allocatable, intent(inout) :: params(:), ranges(:, :)
        integer(c_int32_t), allocatable, intent(inout) :: kinds(:)
        logical, intent(inout), optional :: complete
        real(c_double), intent(in), optional :: tolerance
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code, answer
        integer(c_int64_t) :: n
        real(c_double), allocatable :: ranges_c(:, :)
        n = 0
        answer = 0
        code = fitting([fits(coefficients, monomials(dim_of(g%handle), degree))])
        if (code == NURBS_OK) then
            if (present(call)) then
                code = nurbs_curve_level_with(g%handle, degree, coefficients, given(tolerance, 0d0), 0_c_int64_t, &
                    count=n, call=watched(call))
            else
                code = nurbs_curve_level(g%handle, degree, coefficients, given(tolerance, 0d0), 0_c_int64_t, count=n)
            end if
        end if
        if (allocated(params)) deallocate (params)
        if (allocated(kinds)) deallocate (kinds)
        allocate (params(n), kinds(n), ranges_c(2, n))
        if (code == NURBS_OK) then
            if (present(call)) then
                code = nurbs_curve_level_with(g%handle, degree, coefficients, given(tolerance, 0d0), n, params, kinds, &
                    ranges_c, complete=answer, call=watched(call))
            else
                code = nurbs_curve_level(g%handle, degree, coefficients, given(tolerance, 0d0), n, params, kinds, &
                    ranges_c, complete=answer)
            end if
        end if
        ranges = transpose(ranges_c)
        if (present(complete)) complete = answer /= 0
        call settle(code, status)
    end subroutine curve_level

    !> Where two curves meet, with proof that there are no other places.
    subroutine curve_intersections(a, b, params_a, params_b, kinds, ranges_a, ranges_b, complete, tolerance, status, &
            call)
        class(nurbs_spline), intent(in) :: a, b
        real(c_double), allocatable, intent(inout) :: params_a(:), params_b(:), ranges_a(:, :), ranges_b(:, :)
        integer(c_int32_t), allocatable, intent(inout) :: kinds(:)
        logical, intent(inout), optional :: complete
        real(c_double), intent(in), optional :: tolerance
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code, answer
        integer(c_int64_t) :: n
        real(c_double), allocatable :: ranges_a_c(:, :), ranges_b_c(:, :)
        n = 0
        answer = 0
        if (present(call)) then
            code = nurbs_curve_intersections_with(a%handle, b%handle, given(tolerance, 0d0), 0_c_int64_t, count=n, &
                call=watched(call))
        else
            code = nurbs_curve_intersections(a%handle, b%handle, given(tolerance, 0d0), 0_c_int64_t, count=n)
        end if
        if (allocated(params_a)) deallocate (params_a)
        if (allocated(params_b)) deallocate (params_b)
        if (allocated(kinds)) deallocate (kinds)
        allocate (params_a(n), params_b(n), kinds(n), ranges_a_c(2, n), ranges_b_c(2, n))
        if (code == NURBS_OK) then
            if (present(call)) then
                code = nurbs_curve_intersections_with(a%handle, b%handle, given(tolerance, 0d0), n, params_a, &
                    params_b, kinds, ranges_a_c, ranges_b_c, complete=answer, call=watched(call))
            else
                code = nurbs_curve_intersections(a%handle, b%handle, given(tolerance, 0d0), n, params_a, params_b, &
                    kinds, ranges_a_c, ranges_b_c, complete=answer)
            end if
        end if
        ranges_a = transpose(ranges_a_c)
        ranges_b = transpose(ranges_b_c)
        if (present(complete)) complete = answer /= 0
        call settle(code, status)
    end subroutine curve_intersections

    !> Where a curve meets itself, with proof that there are no other places.
    subroutine self_intersections(g, params_a, params_b, kinds, ranges_a, ranges_b, complete, tolerance, status, call)
        class(nurbs_spline), intent(in) :: g
        real(c_double), allocatable, intent(inout) :: params_a(:), params_b(:), ranges_a(:, :), ranges_b(:, :)
        integer(c_int32_t), allocatable, intent(inout) :: kinds(:)
        logical, intent(inout), optional :: complete
        real(c_double), intent(in), optional :: tolerance
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code, answer
        integer(c_int64_t) :: n
        real(c_double), allocatable :: ranges_a_c(:, :), ranges_b_c(:, :)
        n = 0
        answer = 0
        if (present(call)) then
            code = nurbs_curve_self_intersections_with(g%handle, given(tolerance, 0d0), 0_c_int64_t, count=n, &
                call=watched(call))
        else
            code = nurbs_curve_self_intersections(g%handle, given(tolerance, 0d0), 0_c_int64_t, count=n)
        end if
        if (allocated(params_a)) deallocate (params_a)
        if (allocated(params_b)) deallocate (params_b)
        if (allocated(kinds)) deallocate (kinds)
        allocate (params_a(n), params_b(n), kinds(n), ranges_a_c(2, n), ranges_b_c(2, n))
        if (code == NURBS_OK) then
            if (present(call)) then
                code = nurbs_curve_self_intersections_with(g%handle, given(tolerance, 0d0), n, params_a, params_b, &
                    kinds, ranges_a_c, ranges_b_c, complete=answer, call=watched(call))
            else
                code = nurbs_curve_self_intersections(g%handle, given(tolerance, 0d0), n, params_a, params_b, kinds, &
                    ranges_a_c, ranges_b_c, complete=answer)
            end if
        end if
        ranges_a = transpose(ranges_a_c)
        ranges_b = transpose(ranges_b_c)
        if (present(complete)) complete = answer /= 0
        call settle(code, status)
    end subroutine self_intersections

    !> params_curve(n) in rising order and params_surface(n, 2) where a curve meets a surface, kinds(n) one NURBS_HIT_
    !> constant each, and ranges_curve(n, 2) and ranges_surface(2, 2, n) of lower and upper ends along each axis.
    subroutine surface_intersections(curve, surface, params_curve, params_surface, kinds, ranges_curve, &
            ranges_surface, complete, tolerance, status, call)
        class(nurbs_spline), intent(in) :: curve, surface
        real(c_double), allocatable, intent(inout) :: params_curve(:), params_surface(:, :), ranges_curve(:, :)
        real(c_double), allocatable, intent(inout) :: ranges_surface(:, :, :)
        integer(c_int32_t), allocatable, intent(inout) :: kinds(:)
        logical, intent(inout), optional :: complete
        real(c_double), intent(in), optional :: tolerance
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code, answer
        integer(c_int64_t) :: n
        real(c_double), allocatable :: params_surface_c(:, :), ranges_curve_c(:, :)
        n = 0
        answer = 0
        if (present(call)) then
            code = nurbs_curve_surface_intersections_with(curve%handle, surface%handle, given(tolerance, 0d0), &
                0_c_int64_t, count=n, call=watched(call))
        else
            code = nurbs_curve_surface_intersections(curve%handle, surface%handle, given(tolerance, 0d0), 0_c_int64_t, &
                count=n)
        end if
        if (allocated(params_curve)) deallocate (params_curve)
        if (allocated(kinds)) deallocate (kinds)
        if (allocated(ranges_surface)) deallocate (ranges_surface)
        allocate (params_curve(n), params_surface_c(2, n), kinds(n), ranges_curve_c(2, n), ranges_surface(2, 2, n))
        if (code == NURBS_OK) then
            if (present(call)) then
                code = nurbs_curve_surface_intersections_with(curve%handle, surface%handle, given(tolerance, 0d0), n, &
                    params_curve, params_surface_c, kinds, ranges_curve_c, ranges_surface, complete=answer, &
                    call=watched(call))
            else
                code = nurbs_curve_surface_intersections(curve%handle, surface%handle, given(tolerance, 0d0), n, &
                    params_curve, params_surface_c, kinds, ranges_curve_c, ranges_surface, complete=answer)
            end if
        end if
        params_surface = transpose(params_surface_c)
        ranges_curve = transpose(ranges_curve_c)
        if (present(complete)) complete = answer /= 0
        call settle(code, status)
    end subroutine surface_intersections

    !> The points that three surfaces have in common, with proof that there are no others.
    subroutine common_points(a, b, c, params, points, kinds, ranges, complete, tolerance, status, call)
        class(nurbs_spline), intent(in) :: a, b, c
        real(c_double), allocatable, intent(inout) :: params(:, :), points(:, :), ranges(:, :, :)
        integer(c_int32_t), allocatable, intent(inout) :: kinds(:)
        logical, intent(inout), optional :: complete
        real(c_double), intent(in), optional :: tolerance
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code, answer
        integer(c_int64_t) :: n
        real(c_double), allocatable :: params_c(:, :), points_c(:, :), ranges_c(:, :, :)
        n = 0
        answer = 0
        if (present(call)) then
            code = nurbs_surfaces_common_points_with(a%handle, b%handle, c%handle, given(tolerance, 0d0), 0_c_int64_t, &
                count=n, call=watched(call))
        else
            code = nurbs_surfaces_common_points(a%handle, b%handle, c%handle, given(tolerance, 0d0), 0_c_int64_t, &
                count=n)
        end if
        if (allocated(kinds)) deallocate (kinds)
        allocate (params_c(6, n), points_c(3, n), kinds(n), ranges_c(2, 6, n))
        if (code == NURBS_OK) then
            if (present(call)) then
                code = nurbs_surfaces_common_points_with(a%handle, b%handle, c%handle, given(tolerance, 0d0), n, &
                    params_c, points_c, kinds, ranges_c, complete=answer, call=watched(call))
            else
                code = nurbs_surfaces_common_points(a%handle, b%handle, c%handle, given(tolerance, 0d0), n, params_c, &
                    points_c, kinds, ranges_c, complete=answer)
            end if
        end if
        params = transpose(params_c)
        points = transpose(points_c)
        ranges = reshape(ranges_c, [size(ranges_c, 3), size(ranges_c, 1), size(ranges_c, 2)], order=[2, 3, 1])
        if (present(complete)) complete = answer /= 0
        call settle(code, status)
    end subroutine common_points

    !> Where rays meet a surface first, with proof.
    subroutine rays(g, origins, directions, params, distances, states, status, call)
        class(nurbs_spline), intent(in) :: g
        real(c_double), intent(in) :: origins(:, :), directions(:, :)
        real(c_double), intent(inout), optional :: params(:, :), distances(:)
        integer(c_int32_t), intent(inout), optional :: states(:)
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        real(c_double), allocatable :: params_c(:, :)
        n = size(origins, 1, c_int64_t)
        allocate (params_c(2, n))
        code = fitting([fits(origins, n, 3_c_int64_t), fits(directions, n, 3_c_int64_t), fits(params, n, 2_c_int64_t), &
            fits(distances, n), fits(states, n)])
        if (code == NURBS_OK) then
            if (present(call)) then
                code = nurbs_surface_rays_with(g%handle, n, origins, step(origins), column(origins), directions, &
                    step(directions), column(directions), params_c, distances, states, watched(call))
            else
                code = nurbs_surface_rays(g%handle, n, origins, step(origins), column(origins), directions, &
                    step(directions), column(directions), params_c, distances, states)
            end if
        end if
        if (code == NURBS_OK) then
            if (present(params)) params = transpose(params_c)
        end if
        call settle(code, status)
    end subroutine rays

    !> All places where a ray meets a surface, by rising t.
    subroutine ray_hits(g, origin, direction, params, distances, kinds, complete, range, status)
        class(nurbs_spline), intent(in) :: g
        real(c_double), intent(in) :: origin(:), direction(3)
        real(c_double), allocatable, intent(inout) :: params(:, :), distances(:)
        integer(c_int32_t), allocatable, intent(inout) :: kinds(:)
        logical, intent(inout), optional :: complete
        real(c_double), intent(in), optional :: range(2)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code, answer
        integer(c_int64_t) :: n
        real(c_double), allocatable :: params_c(:, :)
        n = 0
        answer = 0
        code = fitting([fits(origin, 3_c_int64_t)])
        if (code == NURBS_OK) code = nurbs_surface_ray_hits(g%handle, origin, direction, range, 0_c_int64_t, count=n)
        if (allocated(distances)) deallocate (distances)
        if (allocated(kinds)) deallocate (kinds)
        allocate (params_c(2, n), distances(n), kinds(n))
        if (code == NURBS_OK) code = nurbs_surface_ray_hits(g%handle, origin, direction, range, n, params_c, &
            distances, kinds, complete=answer)
        params = transpose(params_c)
        if (present(complete)) complete = answer /= 0
        call settle(code, status)
    end subroutine ray_hits
end module nurbs_intersections
