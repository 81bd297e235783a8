! SPDX-License-Identifier: MIT
! Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
!> Distances and closest points. states(n) receives sums of the NURBS_CLOSEST_ bits; range(2, axes) is the part of the
!> domain that is searched, range(:, k) of domain(k). Conventions: see the module nurbs.
module nurbs_closest
    use, intrinsic :: iso_c_binding
    use nurbs_constants
    use nurbs_c, only: nurbs_closest_points, nurbs_farthest_points, nurbs_closest_local, nurbs_closest_all, &
        nurbs_critical_points, nurbs_curve_signed_distances, nurbs_distance, nurbs_hausdorff_distance, &
        nurbs_closest_all_with, nurbs_critical_points_with, nurbs_distance_with, nurbs_hausdorff_distance_with
    use nurbs_support
    use nurbs_calls
    use nurbs_splines
    implicit none
    private
    public :: closest_points, farthest_points, closest_local, closest_all, critical_points, signed_distances
    public :: spline_distance, hausdorff_distance

contains

    !> params(n, axes), feet(n, dim) and distances(n) of the points that are nearest to points(n, dim); in a volume this
    !> is inversion.
    subroutine closest_points(g, points, params, feet, distances, states, range, tolerance, budget, flags, status, call)
        class(nurbs_spline), intent(in) :: g
        real(c_double), intent(in) :: points(:, :)
        real(c_double), intent(inout), optional :: params(:, :), feet(:, :), distances(:)
        integer(c_int32_t), intent(inout), optional :: states(:)
        real(c_double), intent(in), optional :: range(:, :), tolerance
        integer(c_int32_t), intent(in), optional :: budget, flags
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n, dim, axes
        n = size(points, 1, c_int64_t)
        dim = dim_of(g%handle)
        axes = axes_of(g%handle)
        code = fitting([fits(points, n, dim), fits(params, n, axes), fits(feet, n, dim), fits(distances, n), &
            fits(states, n), fits(range, 2_c_int64_t, axes)])
        if (code == NURBS_OK) then
            if (present(call)) then
                code = closest_points_watched(g%handle, n, points, step(points), column(points), range, &
                    given(tolerance, 0d0), int(given(budget, 0), c_int64_t), params, step(params), column(params), &
                    feet, step(feet), column(feet), distances, 0_c_int64_t, states, given(flags, 0), watched(call))
            else
                code = nurbs_closest_points(g%handle, n, points, step(points), column(points), range, &
                    given(tolerance, 0d0), int(given(budget, 0), c_int64_t), params, step(params), column(params), &
                    feet, step(feet), column(feet), distances, 0_c_int64_t, states, given(flags, 0))
            end if
        end if
        call settle(code, status)
    end subroutine closest_points

    !> The same of the points that are farthest.
    subroutine farthest_points(g, points, params, feet, distances, states, range, tolerance, budget, flags, status, &
            call)
        class(nurbs_spline), intent(in) :: g
        real(c_double), intent(in) :: points(:, :)
        real(c_double), intent(inout), optional :: params(:, :), feet(:, :), distances(:)
        integer(c_int32_t), intent(inout), optional :: states(:)
        real(c_double), intent(in), optional :: range(:, :), tolerance
        integer(c_int32_t), intent(in), optional :: budget, flags
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n, dim, axes
        n = size(points, 1, c_int64_t)
        dim = dim_of(g%handle)
        axes = axes_of(g%handle)
        code = fitting([fits(points, n, dim), fits(params, n, axes), fits(feet, n, dim), fits(distances, n), &
            fits(states, n), fits(range, 2_c_int64_t, axes)])
        if (code == NURBS_OK) then
            if (present(call)) then
                code = farthest_points_watched(g%handle, n, points, step(points), column(points), range, &
                    given(tolerance, 0d0), int(given(budget, 0), c_int64_t), params, step(params), column(params), &
                    feet, step(feet), column(feet), distances, 0_c_int64_t, states, given(flags, 0), watched(call))
            else
                code = nurbs_farthest_points(g%handle, n, points, step(points), column(points), range, &
                    given(tolerance, 0d0), int(given(budget, 0), c_int64_t), params, step(params), column(params), &
                    feet, step(feet), column(feet), distances, 0_c_int64_t, states, given(flags, 0))
            end if
        end if
        call settle(code, status)
    end subroutine farthest_points

    !> Local minima of the distance, each the one that a descent from guesses(n, axes) comes to.
    subroutine closest_local(g, points, guesses, params, feet, distances, states, flags, status, call)
        class(nurbs_spline), intent(in) :: g
        real(c_double), intent(in) :: points(:, :), guesses(:, :)
        real(c_double), intent(inout), optional :: params(:, :), feet(:, :), distances(:)
        integer(c_int32_t), intent(inout), optional :: states(:)
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n, dim, axes
        n = size(points, 1, c_int64_t)
        dim = dim_of(g%handle)
        axes = axes_of(g%handle)
        code = fitting([fits(points, n, dim), fits(guesses, n, axes), fits(params, n, axes), fits(feet, n, dim), &
            fits(distances, n), fits(states, n)])
        if (code == NURBS_OK) then
            if (present(call)) then
                code = closest_local_watched(g%handle, n, points, step(points), column(points), guesses, &
                    step(guesses), column(guesses), params, step(params), column(params), feet, step(feet), &
                    column(feet), distances, 0_c_int64_t, states, given(flags, 0), watched(call))
            else
                code = nurbs_closest_local(g%handle, n, points, step(points), column(points), guesses, step(guesses), &
                    column(guesses), params, step(params), column(params), feet, step(feet), column(feet), distances, &
                    0_c_int64_t, states, given(flags, 0))
            end if
        end if
        call settle(code, status)
    end subroutine closest_local

    !> params(n, axes) and distances(n) of all points that are local minima of the distance and as near as the nearest
    !> one to the tolerance; state: the bits of the search.
    subroutine closest_all(g, point, params, distances, state, range, tolerance, budget, status, call)
        class(nurbs_spline), intent(in) :: g
        real(c_double), intent(in) :: point(:)
        real(c_double), allocatable, intent(inout) :: params(:, :), distances(:)
        integer(c_int32_t), intent(inout), optional :: state
        real(c_double), intent(in), optional :: range(:, :), tolerance
        integer(c_int32_t), intent(in), optional :: budget
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        integer(c_int64_t) :: axes, n
        real(c_double), allocatable :: params_c(:, :)
        axes = axes_of(g%handle)
        n = 0
        code = fitting([fits(point, dim_of(g%handle)), fits(range, 2_c_int64_t, axes)])
        if (code == NURBS_OK) then
            if (present(call)) then
                code = nurbs_closest_all_with(g%handle, point, range, given(tolerance, 0d0), &
                    int(given(budget, 0), c_int64_t), 0_c_int64_t, count=n, call=watched(call))
            else
                code = nurbs_closest_all(g%handle, point, range, given(tolerance, 0d0), &
                    int(given(budget, 0), c_int64_t), 0_c_int64_t, count=n)
            end if
        end if
        if (allocated(distances)) deallocate (distances)
        allocate (params_c(axes, n), distances(n))
        if (code == NURBS_OK) then
            if (present(call)) then
                code = nurbs_closest_all_with(g%handle, point, range, given(tolerance, 0d0), &
                    int(given(budget, 0), c_int64_t), n, params_c, distances, status=state, call=watched(call))
            else
                code = nurbs_closest_all(g%handle, point, range, given(tolerance, 0d0), &
                    int(given(budget, 0), c_int64_t), n, params_c, distances, status=state)
            end if
        end if
        params = transpose(params_c)
        call settle(code, status)
    end subroutine closest_all

    !> The same of all critical points of the distance, with NURBS_CRITICAL_ constants kinds(n).
    subroutine critical_points(g, point, params, distances, kinds, state, range, tolerance, budget, status, call)
        class(nurbs_spline), intent(in) :: g
        real(c_double), intent(in) :: point(:)
        real(c_double), allocatable, intent(inout) :: params(:, :), distances(:)
        integer(c_int32_t), allocatable, intent(inout) :: kinds(:)
        integer(c_int32_t), intent(inout), optional :: state
        real(c_double), intent(in), optional :: range(:, :), tolerance
        integer(c_int32_t), intent(in), optional :: budget
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        integer(c_int64_t) :: axes, n
        real(c_double), allocatable :: params_c(:, :)
        axes = axes_of(g%handle)
        n = 0
        code = fitting([fits(point, dim_of(g%handle)), fits(range, 2_c_int64_t, axes)])
        if (code == NURBS_OK) then
            if (present(call)) then
                code = nurbs_critical_points_with(g%handle, point, range, given(tolerance, 0d0), &
                    int(given(budget, 0), c_int64_t), 0_c_int64_t, count=n, call=watched(call))
            else
                code = nurbs_critical_points(g%handle, point, range, given(tolerance, 0d0), &
                    int(given(budget, 0), c_int64_t), 0_c_int64_t, count=n)
            end if
        end if
        if (allocated(distances)) deallocate (distances)
        if (allocated(kinds)) deallocate (kinds)
        allocate (params_c(axes, n), distances(n), kinds(n))
        if (code == NURBS_OK) then
            if (present(call)) then
                code = nurbs_critical_points_with(g%handle, point, range, given(tolerance, 0d0), &
                    int(given(budget, 0), c_int64_t), n, params_c, distances, kinds, status=state, call=watched(call))
            else
                code = nurbs_critical_points(g%handle, point, range, given(tolerance, 0d0), &
                    int(given(budget, 0), c_int64_t), n, params_c, distances, kinds, status=state)
            end if
        end if
        params = transpose(params_c)
        call settle(code, status)
    end subroutine critical_points

    !> distances(n) of points(n, 2) from a curve in the plane, positive to its left, and params(n).
    subroutine signed_distances(g, points, distances, params, states, tolerance, budget, flags, status, call)
        class(nurbs_spline), intent(in) :: g
        real(c_double), intent(in) :: points(:, :)
        real(c_double), intent(inout) :: distances(:)
        real(c_double), intent(inout), optional :: params(:)
        integer(c_int32_t), intent(inout), optional :: states(:)
        real(c_double), intent(in), optional :: tolerance
        integer(c_int32_t), intent(in), optional :: budget, flags
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        n = size(points, 1, c_int64_t)
        code = fitting([fits(points, n, dim_of(g%handle)), fits(distances, n), fits(params, n), fits(states, n)])
        if (code == NURBS_OK) then
            if (present(call)) then
                code = curve_signed_distances_watched(g%handle, n, points, step(points), column(points), &
                    given(tolerance, 0d0), int(given(budget, 0), c_int64_t), distances, 0_c_int64_t, params, &
                    0_c_int64_t, states, given(flags, 0), watched(call))
            else
                code = nurbs_curve_signed_distances(g%handle, n, points, step(points), column(points), &
                    given(tolerance, 0d0), int(given(budget, 0), c_int64_t), distances, 0_c_int64_t, params, &
                    0_c_int64_t, states, given(flags, 0))
            end if
        end if
        call settle(code, status)
    end subroutine signed_distances

    !> The smallest distance of two splines, enclosed; the points at params_a(axes of a) and params_b(axes of b) are
    !> at_most apart.
    subroutine spline_distance(a, b, tolerance, at_least, at_most, params_a, params_b, state, budget, status, call)
        class(nurbs_spline), intent(in) :: a, b
        real(c_double), intent(in) :: tolerance
        real(c_double), intent(inout), optional :: at_least, at_most, params_a(:), params_b(:)
        integer(c_int32_t), intent(inout), optional :: state
        integer(c_int32_t), intent(in), optional :: budget
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        code = fitting([fits(params_a, axes_of(a%handle)), fits(params_b, axes_of(b%handle))])
        if (code == NURBS_OK) then
            if (present(call)) then
                code = nurbs_distance_with(a%handle, b%handle, tolerance, int(given(budget, 0), c_int64_t), at_least, &
                    at_most, params_a, params_b, state, watched(call))
            else
                code = nurbs_distance(a%handle, b%handle, tolerance, int(given(budget, 0), c_int64_t), at_least, &
                    at_most, params_a, params_b, state)
            end if
        end if
        call settle(code, status)
    end subroutine spline_distance

    !> Bounds of the distances of the farthest points: (1) from a to b, (2) from b to a.
    subroutine hausdorff_distance(a, b, tolerance, at_least, at_most, params_a, params_b, state, budget, status, call)
        class(nurbs_spline), intent(in) :: a, b
        real(c_double), intent(in) :: tolerance
        real(c_double), intent(inout) :: at_least(2), at_most(2)
        real(c_double), intent(inout), optional :: params_a(:), params_b(:)
        integer(c_int32_t), intent(inout), optional :: state
        integer(c_int32_t), intent(in), optional :: budget
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        code = fitting([fits(params_a, axes_of(a%handle)), fits(params_b, axes_of(b%handle))])
        if (code == NURBS_OK) then
            if (present(call)) then
                code = nurbs_hausdorff_distance_with(a%handle, b%handle, tolerance, int(given(budget, 0), c_int64_t), &
                    at_least, at_most, params_a, params_b, state, watched(call))
            else
                code = nurbs_hausdorff_distance(a%handle, b%handle, tolerance, int(given(budget, 0), c_int64_t), &
                    at_least, at_most, params_a, params_b, state)
            end if
        end if
        call settle(code, status)
    end subroutine hausdorff_distance
end module nurbs_closest
