! SPDX-License-Identifier: MIT
!> Distances and closest points. states(n) receives sums of the NURBS_CLOSEST_ bits; range(2, axes) is the part of the
!> domain that is searched, range(:, k) of domain(k). Conventions: see the module nurbs.
module nurbs_closest
    use, intrinsic :: iso_c_binding
    use nurbs_constants
    use nurbs_c
    use nurbs_support
    use nurbs_splines
    use nurbs_placements, only: given
    implicit none
    private
    public :: closest_points, farthest_points, closest_local, closest_all, critical_points, signed_distances
    public :: spline_distance, hausdorff_distance

contains

    !> params(n, axes), feet(n, dim) and distances(n) of the points that are nearest to points(n, dim); in a volume this
    !> is inversion.
    subroutine closest_points(g, points, params, feet, distances, states, range, tolerance, budget, flags, status)
        class(nurbs_spline), intent(in) :: g
        real(c_double), intent(in) :: points(:, :)
        real(c_double), intent(inout), optional :: params(:, :), feet(:, :), distances(:)
        integer(c_int32_t), intent(inout), optional :: states(:)
        real(c_double), intent(in), optional :: range(:, :), tolerance
        integer, intent(in), optional :: budget
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        n = size(points, 1, c_int64_t)
        code = search_shape(g, points, params, feet, distances, states, range)
        if (code == NURBS_OK) code = nurbs_closest_points(g%handle, n, points, step(points), column(points), range, &
            given(tolerance, 0d0), pieces(budget), params, apart(n), n, feet, apart(n), n, distances, 0_c_int64_t, &
            states, bits(flags))
        call settle(code, status)
    end subroutine closest_points

    !> The same of the points that are farthest.
    subroutine farthest_points(g, points, params, feet, distances, states, range, tolerance, budget, flags, status)
        class(nurbs_spline), intent(in) :: g
        real(c_double), intent(in) :: points(:, :)
        real(c_double), intent(inout), optional :: params(:, :), feet(:, :), distances(:)
        integer(c_int32_t), intent(inout), optional :: states(:)
        real(c_double), intent(in), optional :: range(:, :), tolerance
        integer, intent(in), optional :: budget
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        n = size(points, 1, c_int64_t)
        code = search_shape(g, points, params, feet, distances, states, range)
        if (code == NURBS_OK) code = nurbs_farthest_points(g%handle, n, points, step(points), column(points), range, &
            given(tolerance, 0d0), pieces(budget), params, apart(n), n, feet, apart(n), n, distances, 0_c_int64_t, &
            states, bits(flags))
        call settle(code, status)
    end subroutine farthest_points

    !> Local minima of the distance, each the one that a descent from guesses(n, axes) comes to.
    subroutine closest_local(g, points, guesses, params, feet, distances, states, flags, status)
        class(nurbs_spline), intent(in) :: g
        real(c_double), intent(in) :: points(:, :), guesses(:, :)
        real(c_double), intent(inout), optional :: params(:, :), feet(:, :), distances(:)
        integer(c_int32_t), intent(inout), optional :: states(:)
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        n = size(points, 1, c_int64_t)
        code = search_shape(g, points, params, feet, distances, states)
        if (.not. has_shape(n, axes_of(g%handle), guesses)) code = shape_error
        if (code == NURBS_OK) code = nurbs_closest_local(g%handle, n, points, step(points), column(points), guesses, &
            step(guesses), column(guesses), params, apart(n), n, feet, apart(n), n, distances, 0_c_int64_t, states, &
            bits(flags))
        call settle(code, status)
    end subroutine closest_local

    !> params(n, axes) and distances(n) of all points that are local minima of the distance and as near as the nearest
    !> one to the tolerance; state: the bits of the search.
    subroutine closest_all(g, point, params, distances, state, range, tolerance, budget, status)
        class(nurbs_spline), intent(in) :: g
        real(c_double), intent(in) :: point(:)
        real(c_double), allocatable, intent(inout) :: params(:, :), distances(:)
        integer(c_int32_t), intent(inout), optional :: state
        real(c_double), intent(in), optional :: range(:, :), tolerance
        integer, intent(in), optional :: budget
        integer(c_int32_t), intent(out), optional :: status
        real(c_double), allocatable :: columns(:, :)
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        n = 0
        code = point_shape(g, point, range)
        if (code == NURBS_OK) code = nurbs_closest_all(g%handle, point, range, given(tolerance, 0d0), pieces(budget), &
            0_c_int64_t, count=n)
        if (allocated(distances)) deallocate (distances)
        allocate (distances(n), columns(axes_of(g%handle), n))
        if (code == NURBS_OK) code = nurbs_closest_all(g%handle, point, range, given(tolerance, 0d0), pieces(budget), &
            n, columns, distances, status=state)
        params = transpose(columns)
        call settle(code, status)
    end subroutine closest_all

    !> The same of all critical points of the distance, with NURBS_CRITICAL_ constants kinds(n).
    subroutine critical_points(g, point, params, distances, kinds, state, range, tolerance, budget, status)
        class(nurbs_spline), intent(in) :: g
        real(c_double), intent(in) :: point(:)
        real(c_double), allocatable, intent(inout) :: params(:, :), distances(:)
        integer(c_int32_t), allocatable, intent(inout) :: kinds(:)
        integer(c_int32_t), intent(inout), optional :: state
        real(c_double), intent(in), optional :: range(:, :), tolerance
        integer, intent(in), optional :: budget
        integer(c_int32_t), intent(out), optional :: status
        real(c_double), allocatable :: columns(:, :)
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        n = 0
        code = point_shape(g, point, range)
        if (code == NURBS_OK) code = nurbs_critical_points(g%handle, point, range, given(tolerance, 0d0), &
            pieces(budget), 0_c_int64_t, count=n)
        if (allocated(distances)) deallocate (distances)
        if (allocated(kinds)) deallocate (kinds)
        allocate (distances(n), kinds(n), columns(axes_of(g%handle), n))
        if (code == NURBS_OK) code = nurbs_critical_points(g%handle, point, range, given(tolerance, 0d0), &
            pieces(budget), n, columns, distances, kinds, status=state)
        params = transpose(columns)
        call settle(code, status)
    end subroutine critical_points

    !> distances(n) of points(n, 2) from a curve in the plane, positive to its left, and params(n).
    subroutine signed_distances(g, points, distances, params, states, tolerance, budget, flags, status)
        class(nurbs_spline), intent(in) :: g
        real(c_double), intent(in) :: points(:, :)
        real(c_double), intent(inout) :: distances(:)
        real(c_double), intent(inout), optional :: params(:)
        integer(c_int32_t), intent(inout), optional :: states(:)
        real(c_double), intent(in), optional :: tolerance
        integer, intent(in), optional :: budget
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        n = size(points, 1, c_int64_t)
        code = fitting([size(points, 2) == dim_of(g%handle), has_size(n, distances), has_size(n, params), &
                        has_length(n, states)])
        if (code == NURBS_OK) code = nurbs_curve_signed_distances(g%handle, n, points, step(points), column(points), &
            given(tolerance, 0d0), pieces(budget), distances, 0_c_int64_t, params, 0_c_int64_t, states, bits(flags))
        call settle(code, status)
    end subroutine signed_distances

    !> The smallest distance of two splines, enclosed; the points at params_a(axes of a) and params_b(axes of b) are
    !> at_most apart.
    subroutine spline_distance(a, b, tolerance, at_least, at_most, params_a, params_b, state, budget, status)
        class(nurbs_spline), intent(in) :: a, b
        real(c_double), intent(in) :: tolerance
        real(c_double), intent(inout), optional :: at_least, at_most, params_a(:), params_b(:)
        integer(c_int32_t), intent(inout), optional :: state
        integer, intent(in), optional :: budget
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        code = pair_shape(a, b, params_a, params_b)
        if (code == NURBS_OK) code = nurbs_distance(a%handle, b%handle, tolerance, pieces(budget), at_least, at_most, &
            params_a, params_b, state)
        call settle(code, status)
    end subroutine spline_distance

    !> Bounds of the distances of the farthest points: (1) from a to b, (2) from b to a.
    subroutine hausdorff_distance(a, b, tolerance, at_least, at_most, params_a, params_b, state, budget, status)
        class(nurbs_spline), intent(in) :: a, b
        real(c_double), intent(in) :: tolerance
        real(c_double), intent(inout) :: at_least(2), at_most(2)
        real(c_double), intent(inout), optional :: params_a(:), params_b(:)
        integer(c_int32_t), intent(inout), optional :: state
        integer, intent(in), optional :: budget
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        code = pair_shape(a, b, params_a, params_b)
        if (code == NURBS_OK) code = nurbs_hausdorff_distance(a%handle, b%handle, tolerance, pieces(budget), at_least, &
            at_most, params_a, params_b, state)
        call settle(code, status)
    end subroutine hausdorff_distance

    pure integer(c_int64_t) function pieces(budget)
        integer, intent(in), optional :: budget
        pieces = 0
        if (present(budget)) pieces = budget
    end function pieces

    integer(c_int32_t) function search_shape(g, points, params, feet, distances, states, range) result(code)
        class(nurbs_spline), intent(in) :: g
        real(c_double), intent(in) :: points(:, :)
        real(c_double), intent(in), optional :: params(:, :), feet(:, :), distances(:), range(:, :)
        integer(c_int32_t), intent(in), optional :: states(:)
        integer(c_int64_t) :: n
        integer :: axes, dim
        n = size(points, 1, c_int64_t)
        axes = axes_of(g%handle)
        dim = dim_of(g%handle)
        code = fitting([size(points, 2) == dim, has_shape(n, axes, params), has_shape(n, dim, feet), &
                        has_size(n, distances), has_length(n, states), has_shape(2_c_int64_t, axes, range)])
    end function search_shape

    integer(c_int32_t) function point_shape(g, point, range) result(code)
        class(nurbs_spline), intent(in) :: g
        real(c_double), intent(in) :: point(:)
        real(c_double), intent(in), optional :: range(:, :)
        code = fitting([size(point) == dim_of(g%handle), has_shape(2_c_int64_t, axes_of(g%handle), range)])
    end function point_shape

    integer(c_int32_t) function pair_shape(a, b, params_a, params_b) result(code)
        class(nurbs_spline), intent(in) :: a, b
        real(c_double), intent(in), optional :: params_a(:), params_b(:)
        code = fitting([has_size(int(axes_of(a%handle), c_int64_t), params_a), &
                        has_size(int(axes_of(b%handle), c_int64_t), params_b)])
    end function pair_shape
end module nurbs_closest
