! SPDX-License-Identifier: MIT
! Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
!> Trimmed faces: the part of a surface that loops of curves bound. Conventions: see the module nurbs.
module nurbs_faces
    use, intrinsic :: iso_c_binding
    use nurbs_constants
    use nurbs_c, only: nurbs_face_create, nurbs_face_surface, nurbs_face_loops, nurbs_face_curve, nurbs_face_edge, &
        nurbs_face_deviation, nurbs_face_tolerance, nurbs_face_classify, nurbs_face_rays, nurbs_face_closest_points, &
        nurbs_face_distance, nurbs_face_hausdorff_distance, nurbs_face_area, nurbs_face_moments, &
        nurbs_face_quadrature, nurbs_face_box, nurbs_face_from_bytes, nurbs_face_create_with, &
        nurbs_face_classify_with, nurbs_face_rays_with, nurbs_face_closest_points_with, nurbs_face_distance_with, &
        nurbs_face_hausdorff_distance_with, nurbs_face_area_with, nurbs_face_moments_with, nurbs_face_quadrature_with, &
        nurbs_face_box_with
    use nurbs_support
    use nurbs_calls
    use nurbs_handles
    use nurbs_splines
    implicit none
    private

    !> A trimmed face; an assignment makes another handle on the same face.
    type, extends(nurbs_face_handle), public :: nurbs_face
    contains
        procedure :: create, surface, loops, curve, edge, deviation, get_tolerance, classify, rays, closest_points
        procedure :: distance, hausdorff_distance, get_area, moments, quadrature, box, from_bytes
    end type nurbs_face

contains

    !> A face of a surface and loops of curves in its domain, edges in space, or both; sizes are the numbers of curves
    !> of the loops. Where a curve or an edge is missing, it is made. Without loops it is the whole surface.
    subroutine create(this, surface, sizes, curves, edges, keys, tolerance, flags, gaps, status, call)
        class(nurbs_face), intent(inout) :: this
        class(nurbs_spline), intent(in) :: surface
        integer(c_int32_t), intent(in) :: sizes(:)
        type(nurbs_spline), intent(in), optional :: curves(:), edges(:)
        integer(c_int64_t), intent(in), optional :: keys(:)
        real(c_double), intent(in), optional :: tolerance
        integer(c_int32_t), intent(in), optional :: flags
        real(c_double), intent(inout), optional :: gaps(:)
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        integer(c_int64_t) :: loops, sum_sizes
        type(c_ptr), allocatable :: curves_c(:), edges_c(:)
        type(c_ptr) :: made
        loops = size(sizes, kind=c_int64_t)
        sum_sizes = sum(int(sizes, c_int64_t))
        made = c_null_ptr
        code = fitting([as_many(curves, sum_sizes), as_many(edges, sum_sizes), fits(keys, sum_sizes), &
            fits(gaps, loops)])
        if (present(curves)) curves_c = handles_of(curves)
        if (present(edges)) edges_c = handles_of(edges)
        if (code == NURBS_OK) then
            if (present(call)) then
                code = nurbs_face_create_with(surface%handle, loops, int(sizes, c_int64_t), curves_c, edges_c, keys, &
                    given(tolerance, 0d0), given(flags, 0), gaps, watched(call), made)
            else
                code = nurbs_face_create(surface%handle, loops, int(sizes, c_int64_t), curves_c, edges_c, keys, &
                    given(tolerance, 0d0), given(flags, 0), gaps, made)
            end if
        end if
        call this%replace(made)
        call settle(code, status)
    end subroutine create

    !> Its surface.
    subroutine surface(this, out, status)
        class(nurbs_face), intent(in) :: this
        type(nurbs_spline), intent(inout) :: out
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        code = nurbs_face_surface(this%handle, made)
        call out%replace(made)
        call settle(code, status)
    end subroutine surface

    !> The number of curves of each loop.
    subroutine loops(this, sizes, status)
        class(nurbs_face), intent(in) :: this
        integer(c_int64_t), allocatable, intent(inout) :: sizes(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        n = 0
        code = nurbs_face_loops(this%handle, 0_c_int64_t, count=n)
        if (allocated(sizes)) deallocate (sizes)
        allocate (sizes(n))
        if (code == NURBS_OK) code = nurbs_face_loops(this%handle, n, sizes)
        call settle(code, status)
    end subroutine loops

    !> A curve of a loop in the domain of the surface, as it runs with the inside to its left.
    subroutine curve(this, loop, index, out, status)
        class(nurbs_face), intent(in) :: this
        integer(c_int32_t), intent(in) :: loop, index
        type(nurbs_spline), intent(inout) :: out
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        code = nurbs_face_curve(this%handle, loop - 1_c_int64_t, index - 1_c_int64_t, made)
        call out%replace(made)
        call settle(code, status)
    end subroutine curve

    !> The edge in space that belongs to a curve of a loop: the one that was given, or one that is made.
    subroutine edge(this, loop, index, out, key, status)
        class(nurbs_face), intent(in) :: this
        integer(c_int32_t), intent(in) :: loop, index
        type(nurbs_spline), intent(inout) :: out
        integer(c_int64_t), intent(inout), optional :: key
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        code = nurbs_face_edge(this%handle, loop - 1_c_int64_t, index - 1_c_int64_t, key, made)
        call out%replace(made)
        call settle(code, status)
    end subroutine edge

    !> How far a curve of a loop, mapped by the surface, and its edge are apart.
    subroutine deviation(this, loop, index, distance, proven, status)
        class(nurbs_face), intent(in) :: this
        integer(c_int32_t), intent(in) :: loop, index
        real(c_double), intent(inout) :: distance
        logical, intent(inout), optional :: proven
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: answer
        answer = 0
        call settle(nurbs_face_deviation(this%handle, loop - 1_c_int64_t, index - 1_c_int64_t, distance, answer), &
            status)
        if (present(proven)) proven = answer /= 0
    end subroutine deviation

    !> The tolerance that it was created with.
    real(c_double) function get_tolerance(this, status) result(value)
        class(nurbs_face), intent(in) :: this
        integer(c_int32_t), intent(out), optional :: status
        value = 0
        call settle(nurbs_face_tolerance(this%handle, value), status)
    end function get_tolerance

    !> On which side of the boundary parameters lie: 1 inside, 0 on the boundary, -1 outside.
    subroutine classify(this, params, sides, tolerance, status, call)
        class(nurbs_face), intent(in) :: this
        real(c_double), intent(in) :: params(:, :)
        integer(c_int32_t), intent(inout) :: sides(:)
        real(c_double), intent(in), optional :: tolerance
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        n = size(params, 1, c_int64_t)
        code = held(this%handle)
        if (code == NURBS_OK) code = fitting([fits(params, n, 2_c_int64_t), fits(sides, n)])
        if (code == NURBS_OK) then
            if (present(call)) then
                code = nurbs_face_classify_with(this%handle, n, params, step(params), column(params), &
                    given(tolerance, 0d0), sides, watched(call))
            else
                code = nurbs_face_classify(this%handle, n, params, step(params), column(params), &
                    given(tolerance, 0d0), sides)
            end if
        end if
        call settle(code, status)
    end subroutine classify

    !> Where rays meet it first, with proof.
    subroutine rays(this, origins, directions, params, distances, states, status, call)
        class(nurbs_face), intent(in) :: this
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
        code = held(this%handle)
        if (code == NURBS_OK) code = fitting([fits(origins, n, 3_c_int64_t), fits(directions, n, 3_c_int64_t), &
            fits(params, n, 2_c_int64_t), fits(distances, n), fits(states, n)])
        if (code == NURBS_OK) then
            if (present(call)) then
                code = nurbs_face_rays_with(this%handle, n, origins, step(origins), column(origins), directions, &
                    step(directions), column(directions), params_c, distances, states, watched(call))
            else
                code = nurbs_face_rays(this%handle, n, origins, step(origins), column(origins), directions, &
                    step(directions), column(directions), params_c, distances, states)
            end if
        end if
        if (code == NURBS_OK) then
            if (present(params)) params = transpose(params_c)
        end if
        call settle(code, status)
    end subroutine rays

    !> Its points that are nearest to given points, with proof.
    subroutine closest_points(this, points, params, feet, distances, states, tolerance, status, call)
        class(nurbs_face), intent(in) :: this
        real(c_double), intent(in) :: points(:, :)
        real(c_double), intent(inout), optional :: params(:, :), feet(:, :), distances(:)
        integer(c_int32_t), intent(inout), optional :: states(:)
        real(c_double), intent(in), optional :: tolerance
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n, dim
        real(c_double), allocatable :: params_c(:, :), feet_c(:, :)
        n = size(points, 1, c_int64_t)
        dim = face_dim_of(this%handle)
        allocate (params_c(2, n), feet_c(dim, n))
        code = held(this%handle)
        if (code == NURBS_OK) code = fitting([fits(points, n, dim), fits(params, n, 2_c_int64_t), fits(feet, n, dim), &
            fits(distances, n), fits(states, n)])
        if (code == NURBS_OK) then
            if (present(call)) then
                code = nurbs_face_closest_points_with(this%handle, n, points, step(points), column(points), &
                    given(tolerance, 0d0), params_c, feet_c, distances, states, watched(call))
            else
                code = nurbs_face_closest_points(this%handle, n, points, step(points), column(points), &
                    given(tolerance, 0d0), params_c, feet_c, distances, states)
            end if
        end if
        if (code == NURBS_OK) then
            if (present(params)) params = transpose(params_c)
            if (present(feet)) feet = transpose(feet_c)
        end if
        call settle(code, status)
    end subroutine closest_points

    !> The smallest distance to another face, with proof; the points are at_most apart.
    subroutine distance(this, other, at_least, at_most, params_a, params_b, state, tolerance, status, call)
        class(nurbs_face), intent(in) :: this, other
        real(c_double), intent(inout), optional :: at_least, at_most, params_a(2), params_b(2)
        integer(c_int32_t), intent(inout), optional :: state
        real(c_double), intent(in), optional :: tolerance
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        if (present(call)) then
            code = nurbs_face_distance_with(this%handle, other%handle, given(tolerance, 0d0), at_least, at_most, &
                params_a, params_b, state, watched(call))
        else
            code = nurbs_face_distance(this%handle, other%handle, given(tolerance, 0d0), at_least, at_most, params_a, &
                params_b, state)
        end if
        call settle(code, status)
    end subroutine distance

    !> How far the points that are farthest from another face are from it, and the other way round.
    subroutine hausdorff_distance(this, other, tolerance, at_least, at_most, params_a, params_b, state, status, call)
        class(nurbs_face), intent(in) :: this, other
        real(c_double), intent(in) :: tolerance
        real(c_double), intent(inout) :: at_least(2), at_most(2)
        real(c_double), intent(inout), optional :: params_a(2), params_b(2)
        integer(c_int32_t), intent(inout), optional :: state
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        if (present(call)) then
            code = nurbs_face_hausdorff_distance_with(this%handle, other%handle, tolerance, at_least, at_most, &
                params_a, params_b, state, watched(call))
        else
            code = nurbs_face_hausdorff_distance(this%handle, other%handle, tolerance, at_least, at_most, params_a, &
                params_b, state)
        end if
        call settle(code, status)
    end subroutine hausdorff_distance

    !> Its area.
    subroutine get_area(this, area, error, tolerance, status, call)
        class(nurbs_face), intent(in) :: this
        real(c_double), intent(inout) :: area
        real(c_double), intent(inout), optional :: error
        real(c_double), intent(in), optional :: tolerance
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        if (present(call)) then
            code = nurbs_face_area_with(this%handle, given(tolerance, 0d0), area, error, watched(call))
        else
            code = nurbs_face_area(this%handle, given(tolerance, 0d0), area, error)
        end if
        call settle(code, status)
    end subroutine get_area

    !> Area, centroid and inertia about the centroid.
    subroutine moments(this, content, centroid, inertia, error, tolerance, status, call)
        class(nurbs_face), intent(in) :: this
        real(c_double), intent(inout) :: content
        real(c_double), intent(inout), optional :: centroid(:), inertia(:, :), error
        real(c_double), intent(in), optional :: tolerance
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        integer(c_int64_t) :: dim
        dim = face_dim_of(this%handle)
        code = held(this%handle)
        if (code == NURBS_OK) code = fitting([fits(centroid, dim), fits(inertia, dim, dim)])
        if (code == NURBS_OK) then
            if (present(call)) then
                code = nurbs_face_moments_with(this%handle, given(tolerance, 0d0), content, centroid, inertia, error, &
                    watched(call))
            else
                code = nurbs_face_moments(this%handle, given(tolerance, 0d0), content, centroid, inertia, error)
            end if
        end if
        call settle(code, status)
    end subroutine moments

    !> Points and weights for integrals of any function over it: so many nodes along each axis of a cell, 0 for one more
    !> than the degree.
    subroutine quadrature(this, params, weights, measures, nodes, status, call)
        class(nurbs_face), intent(in) :: this
        real(c_double), allocatable, intent(inout) :: params(:, :), weights(:), measures(:)
        integer(c_int32_t), intent(in), optional :: nodes
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        real(c_double), allocatable :: params_c(:, :)
        n = 0
        if (present(call)) then
            code = nurbs_face_quadrature_with(this%handle, given(nodes, 0), 0_c_int64_t, count=n, call=watched(call))
        else
            code = nurbs_face_quadrature(this%handle, given(nodes, 0), 0_c_int64_t, count=n)
        end if
        if (allocated(weights)) deallocate (weights)
        if (allocated(measures)) deallocate (measures)
        allocate (params_c(2, n), weights(n), measures(n))
        if (code == NURBS_OK) then
            if (present(call)) then
                code = nurbs_face_quadrature_with(this%handle, given(nodes, 0), n, params_c, weights, measures, &
                    call=watched(call))
            else
                code = nurbs_face_quadrature(this%handle, given(nodes, 0), n, params_c, weights, measures)
            end if
        end if
        params = transpose(params_c)
        call settle(code, status)
    end subroutine quadrature

    !> An axis-aligned box that contains it; no side is farther from it than the tolerance.
    subroutine box(this, lower, upper, gap, tolerance, status, call)
        class(nurbs_face), intent(in) :: this
        real(c_double), intent(inout) :: lower(:), upper(:)
        real(c_double), intent(inout), optional :: gap
        real(c_double), intent(in), optional :: tolerance
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        integer(c_int64_t) :: dim
        dim = face_dim_of(this%handle)
        code = held(this%handle)
        if (code == NURBS_OK) code = fitting([fits(lower, dim), fits(upper, dim)])
        if (code == NURBS_OK) then
            if (present(call)) then
                code = nurbs_face_box_with(this%handle, given(tolerance, 0d0), lower, upper, gap, watched(call))
            else
                code = nurbs_face_box(this%handle, given(tolerance, 0d0), lower, upper, gap)
            end if
        end if
        call settle(code, status)
    end subroutine box

    !> The face of what to_bytes() made of it.
    subroutine from_bytes(this, contents, status)
        class(nurbs_face), intent(inout) :: this
        character(kind=c_char, len=*), intent(in), target :: contents
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        code = nurbs_face_from_bytes(c_loc(contents), len(contents, c_int64_t), made)
        call this%replace(made)
        call settle(code, status)
    end subroutine from_bytes
end module nurbs_faces
