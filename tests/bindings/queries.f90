! SPDX-License-Identifier: MIT
! Distances, measures, boxes and features in Fortran: one known value of each.
program queries
    use, intrinsic :: iso_c_binding
    use, intrinsic :: ieee_arithmetic
    use nurbs
    use expectations
    implicit none
    real(c_double), parameter :: small = 1e-8_c_double
    type(nurbs_spline) :: base, square, ring, floor_plane, ball

    call shapes()
    call closest()
    call closest_in_other_ways()
    call all_points()
    call distances_of_splines()
    call lengths_and_areas()
    call contents()
    call boxes()
    call cones()
    call curve_shapes()
    call flatness()
    call surface_shapes()
    call folds()
    call finish()

contains

    ! A line along x from 0 to 2 and a square about the origin, in the plane; a part of the plane z = 0; a ball.
    subroutine shapes()
        real(c_double) :: corners(5, 2)
        corners(:, 1) = [-1, 1, 1, -1, -1]
        corners(:, 2) = [-1, -1, 1, 1, -1]
        call create_line(base, [0d0, 0d0], [2d0, 0d0])
        call create_polyline(square, corners)
        call create_circle(ring, 1d0)
        call create_plane(floor_plane, [2d0, 0d0, 0d0], [0d0, 4d0, 0d0])
        call create_sphere(ball, 1d0, center=[1d0, 2d0, 3d0])
    end subroutine shapes

    subroutine closest()
        real(c_double) :: params(2, 1), feet(2, 2), distances(2), points(2, 2)
        integer(c_int32_t) :: states(2), code
        points(1, :) = [0.5d0, 1d0]
        points(2, :) = [3d0, 0d0]
        call closest_points(base, points, params, feet, distances, states)
        call expect(near(params(:, 1), [0.25d0, 1d0]) .and. near(distances, [1d0, 1d0]), 'closest points')
        call expect(near(feet(1, :), [0.5d0, 0d0]) .and. near(feet(2, :), [2d0, 0d0]), 'feet')
        call expect(states(1) == NURBS_CLOSEST_CERTIFIED, 'a state inside')
        call expect(states(2) == NURBS_CLOSEST_CERTIFIED + NURBS_CLOSEST_BOUNDARY, 'a state at an end')
        call closest_points(base, points(:1, :), params(:1, :), range=reshape([0.5d0, 1d0], [2, 1]))
        call expect(near(params(:1, 1), [0.5d0]), 'a part of the domain')
        points(1, 1) = ieee_value(1d0, ieee_quiet_nan)
        call closest_points(base, points, distances=distances, states=states, flags=NURBS_NAN_POINTS)
        call expect(states(1) == NURBS_CLOSEST_INVALID .and. ieee_is_nan(distances(1)), 'an invalid point')
        call closest_points(base, points, status=code)
        call expect(code == NURBS_ERROR_POINT_NOT_FINITE, 'a point that is not finite')
        call closest_points(base, points, feet=feet(:1, :), status=code)
        call expect(code == NURBS_ERROR_SIZE, 'too few feet')
    end subroutine closest

    subroutine closest_in_other_ways()
        real(c_double) :: params(2, 1), corner(1, 2), feet(2, 2), distances(2), points(2, 2)
        integer(c_int32_t) :: code
        call closest_points(floor_plane, reshape([0.5d0, 1d0, 3d0], [1, 3]), corner, distances=distances(:1))
        call expect(near(corner(1, :), [0.25d0, 0.25d0]) .and. near(distances(:1), [3d0]), 'on a surface')
        points(1, :) = [0.5d0, 1d0]
        points(2, :) = [2d0, 1d0]
        call farthest_points(base, points, params, distances=distances)
        call expect(near(params(:, 1), [1d0, 0d0]) .and. near(distances, sqrt([3.25d0, 5d0])), 'farthest points')
        points(:, 1) = 0
        points(:, 2) = 0.5d0
        call closest_local(square, points, reshape([0.3d0, 2.3d0], [2, 1]), params, feet)
        call expect(near(params(:, 1), [0.5d0, 2.5d0]) .and. near(feet(:, 2), [-1d0, 1d0]), 'from a guess')
        call closest_points(base, points, params, tolerance=-1d0, status=code)
        call expect(code == NURBS_ERROR_TOLERANCE, 'a negative tolerance')
    end subroutine closest_in_other_ways

    subroutine all_points()
        real(c_double), allocatable :: params(:, :), distances(:)
        real(c_double) :: signed(2), at(2), points(2, 2)
        integer(c_int32_t), allocatable :: kinds(:)
        integer(c_int32_t) :: state
        call closest_all(square, [0d0, 0d0], params, distances, state, tolerance=1d-9)
        call expect(near(params(:, 1), [0.5d0, 1.5d0, 2.5d0, 3.5d0]), 'all closest points')
        call expect(near(distances, [1d0, 1d0, 1d0, 1d0]), 'equally near ones')
        call expect(iand(state, NURBS_CLOSEST_CERTIFIED) /= 0, 'their state')
        call critical_points(base, [0.5d0, 1d0], params, distances, kinds, tolerance=1d-9)
        call expect(near(params(:, 1), [0d0, 0.25d0, 1d0]), 'critical points')
        call expect(near(distances, sqrt([1.25d0, 1d0, 3.25d0])), 'their distances')
        call expect(all(kinds == [NURBS_CRITICAL_MAXIMUM, NURBS_CRITICAL_MINIMUM, NURBS_CRITICAL_MAXIMUM]), 'kinds')
        points(1, :) = [1d0, 1d0]
        points(2, :) = [0.5d0, -2d0]
        call signed_distances(base, points, signed, at)
        call expect(near(signed, [1d0, -2d0]) .and. near(at, [0.5d0, 0.25d0]), 'signed distances')
    end subroutine all_points

    subroutine distances_of_splines()
        type(nurbs_spline) :: a, b
        real(c_double) :: low, high, lows(2), highs(2), at_a(1), at_b(1)
        integer(c_int32_t) :: state, code
        call create_line(a, [0d0, 0d0, 0d0], [2d0, 0d0, 0d0])
        call create_line(b, [1d0, -1d0, 1d0], [1d0, 1d0, 1d0])
        call spline_distance(a, b, 1d-9, low, high, at_a, at_b, state)
        call expect(low <= 1 .and. near([low, high], [1d0, 1d0], small), 'a distance')
        call expect(near([at_a, at_b], [0.5d0, 0.5d0], 1d-4) .and. state == NURBS_CLOSEST_CERTIFIED, 'where it is')
        call spline_distance(a, base, 0d0, low, status=code)
        call expect(code == NURBS_ERROR_INCOMPATIBLE, 'two dimensions')
        call create_line(b, [0d0, 1d0], [1d0, 1d0])
        call hausdorff_distance(base, b, 1d-9, lows, highs, at_a)
        call expect(near(lows, [sqrt(2d0), 1d0], small), 'Hausdorff distances')
        call expect(near(highs, [sqrt(2d0), 1d0], small), 'their upper bounds')
        call expect(near(at_a, [1d0], 1d-4), 'where they are')
    end subroutine distances_of_splines

    subroutine lengths_and_areas()
        real(c_double) :: value, error, two(2)
        real(c_double), allocatable :: params(:)
        integer(c_int32_t) :: code
        call curve_length(ring, value, error)
        call expect(near([value], [2 * pi]) .and. error <= 1d-10, 'a length')
        call curve_length(ring, value, range=[0d0, 0.25d0], tolerance=1d-9)
        call expect(near([value], [pi / 2], small), 'a part of it')
        call curve_lengths(base, [0.5d0, 1d0], two)
        call expect(near(two, [1d0, 2d0]), 'lengths at parameters')
        call params_at_lengths(base, [0d0, 1d0], two)
        call expect(near(two, [0d0, 0.5d0]), 'parameters at lengths')
        call params_at_lengths(base, [0d0, 5d0], two, flags=NURBS_CLAMP)
        call expect(near(two, [0d0, 1d0]), 'a length too large')
        call params_at_lengths(base, [0d0, 5d0], two, status=code)
        call expect(code == NURBS_ERROR_LENGTH, 'which is an error')
        call divide_curve(ring, 4, params, value)
        call expect(near(params, [0d0, 0.25d0, 0.5d0, 0.75d0, 1d0]) .and. near([value], [pi / 2]), 'equal lengths')
        call divide_curve(ring, 4, params, value, flags=NURBS_EQUAL_CHORDS)
        call expect(near([value], [sqrt(2d0)]), 'equal chords')
        call surface_area(ball, value)
        call expect(near([value], [4 * pi], 1d-11), 'an area')
        call surface_area(floor_plane, value, range=reshape([0d0, 0.5d0, 0d0, 0.25d0], [2, 2]))
        call expect(near([value], [1d0]), 'a part of it')
    end subroutine lengths_and_areas

    subroutine contents()
        type(nurbs_spline) :: disc
        real(c_double) :: value, center(2), inertia(2, 2), middle(3), tensor(3, 3), openness
        integer(c_int32_t) :: code
        call spline_moments(base, value, center, inertia)
        call expect(near([value, center], [2d0, 1d0, 0d0]), 'a wire')
        call expect(near([inertia], [0d0, 0d0, 0d0, 2d0 / 3]), 'its inertia')
        call create_circle(disc, 2d0, center=[1d0, 1d0])
        call enclosed_area([disc], value, center, inertia)
        call expect(near([value, center], [4 * pi, 1d0, 1d0]), 'a disc')
        call expect(near([inertia], [4 * pi, 0d0, 0d0, 4 * pi], 1d-11), 'its inertia')
        call enclosed_volume([ball], value, middle, tensor, openness)
        call expect(near([value, middle], [4 * pi / 3, 1d0, 2d0, 3d0], 1d-11), 'a ball')
        call expect(near([tensor(:, 3), openness], [0d0, 0d0, 8 * pi / 15, 0d0], 1d-10), 'its inertia')
        call enclosed_area([base], value, status=code)
        call expect(code == NURBS_ERROR_GAP, 'an open curve')
    end subroutine contents

    subroutine boxes()
        type(nurbs_spline) :: slant
        real(c_double) :: lower(2), upper(2), gap, center(2), axes(2, 2), half(2), params(1), value, bound
        integer(c_int32_t) :: code
        call bounding_box(ring, 1d-9, lower, upper, gap)
        call expect(near([lower, upper], [-1d0, -1d0, 1d0, 1d0], small) .and. gap <= small, 'a tight box')
        call bounding_box(base, 0d0, lower, upper, range=reshape([0d0, 0.5d0], [2, 1]))
        call expect(near(upper, [1d0, 0d0]), 'the box of a part')
        call create_line(slant, [0d0, 0d0], [3d0, 4d0])
        call oriented_box(slant, 1d-9, center, axes, half)
        call expect(near([center, half], [1.5d0, 2d0, 2.5d0, 0d0], small), 'an oriented box')
        call expect(near(abs(axes(:, 1)), [0.6d0, 0.8d0], small), 'its axes')
        call extreme_point(ring, [0d0, 1d0], 1d-9, params, value, bound)
        call expect(near([value, bound], [1d0, 1d0], small) .and. near(params, [0.25d0], 1d-4), 'an extreme point')
        call extreme_point(ring, [0d0, 0d0], 1d-9, status=code)
        call expect(code == NURBS_ERROR_DIRECTION, 'no direction')
    end subroutine boxes

    subroutine cones()
        real(c_double) :: tangent(2), normal(3), angle
        call tangent_cone(base, 1, 1d-3, tangent, angle)
        call expect(near(tangent, [1d0, 0d0]) .and. angle <= 1d-6, 'tangents')
        call normal_cone(floor_plane, 1d-3, normal, angle)
        call expect(near(normal, [0d0, 0d0, 1d0]) .and. angle <= 1d-6, 'normals')
    end subroutine cones

    subroutine curve_shapes()
        type(nurbs_spline) :: g
        real(c_double), allocatable :: params(:), values(:)
        integer(c_int32_t), allocatable :: found(:), signs(:)
        real(c_double), allocatable :: ranges(:, :), others(:, :)
        real(c_double), allocatable :: tops(:, :), boxes(:, :, :)
        real(c_double) :: corners(3, 2), bezier(4, 2), parabola(3, 1), reach
        logical :: complete
        bezier(:, 1) = [0, 1, 2, 3]
        bezier(:, 2) = [0, 2, -2, 0]
        call g%create_bezier([3], bezier)
        call curve_features(g, NURBS_FEATURE_INFLECTION, params, found, values, complete)
        call expect(near(params, [0.5d0]) .and. complete .and. all(found == NURBS_FEATURE_INFLECTION), 'an inflection')
        corners(:, 1) = [0, 1, 1]
        corners(:, 2) = [0, 0, 1]
        call create_polyline(g, corners)
        call curve_features(g, NURBS_FEATURE_KINK + NURBS_FEATURE_CUSP, params, found, values)
        call expect(near([params, values], [1d0, pi / 2]) .and. all(found == NURBS_FEATURE_KINK), 'a kink')
        parabola(:, 1) = [0.75d0, -1.25d0, 0.75d0]
        call g%create_bezier([2], parabola)
        call roots(g, params, signs, ranges, complete)
        call expect(near(params, [0.25d0, 0.75d0]) .and. complete .and. all(signs == NURBS_HIT_CROSSING), 'roots')
        call extrema(g, NURBS_EXTREMUM_MINIMUM, tops, values, found, boxes, complete)
        call expect(near(tops(:, 1), [0.5d0]) .and. complete .and. all(found == NURBS_EXTREMUM_MINIMUM), 'a minimum')
        call mesh_curve(ring, 1d-2, params, tops, reach, complete)
        call expect(complete .and. reach <= 1d-2 .and. all(shape(tops) == [size(params), 2]), 'a polyline')
        call curve_level(ring, 1, [1d0, 2d0, 0d0], params, signs, ranges, complete)
        call expect(size(params) == 2 .and. complete .and. all(shape(ranges) == [2, 2]), 'a line through a ring')
        call curve_intersections(ring, base, params, values, signs, ranges, others, complete, tolerance=1d-9)
        call expect(complete .and. size(params) == size(signs), 'a ring and another curve')
        call self_intersections(ring, params, values, signs, ranges, others, complete)
        call expect(size(params) == 0 .and. complete, 'a ring is simple')
        call monotone_pieces(ring, [1d0, 0d0], params, signs, complete)
        call expect(near(params, [0d0, 0.5d0]) .and. all(signs == [-1, 1]) .and. complete, 'monotone pieces')
    end subroutine curve_shapes

    subroutine flatness()
        type(nurbs_spline) :: g
        real(c_double) :: bound, origin(2), direction(2), at(3), normal(3)
        integer(c_int32_t) :: convexity
        call curve_convexity(ring, convexity)
        call expect(convexity == NURBS_CONVEXITY_LEFT, 'convexity')
        call straightness(base, bound, origin, direction)
        call expect(near([bound, origin(2), direction], [0d0, 0d0, 1d0, 0d0]), 'straightness')
        call create_circle(g, 1d0, center=[0d0, 0d0, 1d0])
        call planarity(g, bound, at, normal)
        call expect(near([bound, at(3), normal], [0d0, 1d0, 0d0, 0d0, 1d0]), 'planarity')
    end subroutine flatness

    subroutine surface_shapes()
        type(nurbs_spline) :: g
        logical, allocatable :: closed(:), collapsed(:, :)
        real(c_double), allocatable :: gaps(:), sizes(:, :), params(:, :), boxes(:, :, :)
        integer(c_int32_t), allocatable :: kinds(:)
        integer(c_int32_t) :: states(1)
        real(c_double) :: bezier(4, 2), first(1)
        logical :: complete
        call boundary_contacts(ball, closed, gaps, collapsed, sizes, tolerance=1d-9)
        call expect(all(closed .eqv. [.true., .false.]) .and. near(gaps(:1), [0d0]), 'a seam')
        call expect(all(collapsed(:, 2)) .and. .not. any(collapsed(:, 1)) .and. near(sizes(:, 2), [0d0, 0d0]), 'poles')
        bezier(:, 1) = [3, -1, -1, 3]
        bezier(:, 2) = [-1, 1, -1, 1]
        call g%create_bezier([3], bezier)
        call singular_points(g, 1d-3, params, boxes, complete)
        call expect(near(params(:, 1), [0.5d0], 1d-3) .and. complete, 'a cusp')
        call expect(boxes(1, 1, 1) <= 0.5d0 .and. 0.5d0 <= boxes(2, 1, 1), 'its box')
        call rays(floor_plane, reshape([0.5d0, 1d0, 3d0], [1, 3]), reshape([0d0, 0d0, -1d0], [1, 3]), &
            distances=first, states=states)
        call expect(near(first, [3d0]) .and. all(states == NURBS_RAY_HIT + NURBS_RAY_CERTIFIED), 'a ray')
        call ray_hits(floor_plane, [0.5d0, 1d0, 3d0], [0d0, 0d0, -1d0], params, gaps, kinds, complete)
        call expect(near(gaps, [3d0]) .and. near(params(1, :), [0.25d0, 0.25d0]) .and. complete, 'its hits')
        call create_line(g, [0.5d0, 1d0, 3d0], [0.5d0, 1d0, -1d0])
        call surface_intersections(g, floor_plane, gaps, params, kinds, sizes, boxes, complete)
        call expect(near(gaps, [0.75d0]) .and. near(params(1, :), [0.25d0, 0.25d0]) .and. complete, 'a line through a plane')
        call expect(all(kinds == NURBS_HIT_CROSSING) .and. all(shape(boxes) == [2, 2, 1]), 'its kind')
        call sections_of_the_ball()
        call triangles_of_the_ball()
        call cells_of_a_block()
        call singular_points(base, 1d-3, params, boxes)
        call expect(size(params, 1) == 0 .and. size(boxes, 3) == 0, 'none')
    end subroutine surface_shapes

    subroutine sections_of_the_ball()
        type(nurbs_meet) :: meet, copy
        type(nurbs_spline) :: space, on_surface
        integer(c_int64_t), allocatable :: levels(:), ends(:, :), loops(:), at(:)
        integer(c_int32_t), allocatable :: kinds(:)
        real(c_double), allocatable :: deviations(:), params(:, :), ranges(:, :)
        integer(c_int64_t) :: branches, nodes
        integer(c_int32_t) :: status
        real(c_double) :: turn
        logical :: complete
        call meet%sections(ball, [0d0, 0d0, 1d0], [3d0, 9d0], 1d-6)
        copy = meet
        call meet%destroy()
        call copy%counts(branches, nodes, complete)
        call expect(branches == 1 .and. nodes == 2 .and. complete, 'an equator')
        call copy%branches(levels, ends, loops, deviations)
        call expect(all(levels == 1) .and. all(loops == 0) .and. all(deviations <= 1d-6), 'its plane')
        call copy%nodes(at, kinds, params, ranges)
        call expect(all(kinds == NURBS_NODE_SEAM) .and. all(at == 1) .and. all(shape(ranges) == [2, 4]), 'its seam')
        call copy%branch(1, space, on_surface)
        call curve_length(space, turn)
        call expect(on_surface%dimension() == 2 .and. turn > 6d0, 'its curves')
        call copy%branch(2, space, on_surface, status)
        call expect(status == NURBS_ERROR_INDEX, 'no second branch')
    end subroutine sections_of_the_ball

    subroutine triangles_of_the_ball()
        type(nurbs_mesh) :: mesh, copy
        type(nurbs_mesh), allocatable :: levels(:)
        type(nurbs_mesh_options) :: options
        real(c_double), allocatable :: xyz(:, :), normals(:, :), params(:, :)
        integer(c_int64_t), allocatable :: corners(:, :), at(:)
        integer(c_int64_t) :: points, triangles
        integer(c_int32_t) :: status
        real(c_double) :: from_shape
        logical :: reached
        call default_mesh_options(options)
        options%chord = 1d-2
        call mesh%of_surface(ball, options)
        copy = mesh
        call mesh%destroy()
        call copy%counts(points, triangles=triangles)
        call copy%bound(from_shape, reached=reached)
        call expect(triangles == 2*points - 4 .and. reached .and. from_shape <= 1d-2, 'triangles around a ball')
        call copy%points(xyz)
        call copy%vertices(at, params, normals)
        call copy%triangles(corners, flags=NURBS_MESH_WELDED)
        call expect(all(shape(xyz) == [int(points), 3]) .and. minval(at) == 1 .and. maxval(at) == points, 'points of vertices')
        call expect(all(shape(corners) == [int(triangles), 3]) .and. maxval(corners) == points, 'corners')
        call expect(all(abs(sum(normals**2, dim=2) - 1) < 1d-14), 'normals')
        call copy%quads(corners, at)
        call expect(all(shape(corners) == [size(at), 4]) .and. minval(at) >= 1 .and. maxval(at) < triangles, 'quads')
        call copy%triangles(corners, flags=1, status=status)
        call expect(status == NURBS_ERROR_FLAGS, 'a flag that there is not')
        call mesh_levels(ball, [1d-1, 1d-2], levels, options)
        call levels(2)%counts(triangles=points)
        call expect(size(levels) == 2 .and. points > 100 .and. points < triangles, 'two levels')
        call mesh_levels(ball, [1d-1, 0d0], levels, status=status)
        call expect(status == NURBS_ERROR_TOLERANCE .and. .not. allocated(levels), 'no distance of 0')
        options%minimum_angle = 4d-1
        call mesh%of_surface(ball, options)
        call mesh%bound(reached=reached)
        call expect(reached, 'no small angles')
    end subroutine triangles_of_the_ball

    subroutine cells_of_a_block()
        type(nurbs_spline) :: block, ring
        type(nurbs_mesh) :: mesh
        real(c_double), allocatable :: domains(:, :, :), points(:, :), weights(:)
        integer(c_int64_t), allocatable :: corners(:, :), cells(:, :)
        integer(c_int32_t), allocatable :: folds(:), signs(:)
        integer(c_int64_t) :: n
        integer(c_int32_t) :: kind
        call extrude_spline(floor_plane, [0d0, 0d0, 1d0], block)
        call mesh%of_volume(block, limit=5)
        call mesh%hexahedra(corners, domains, folds, signs)
        call expect(all(shape(corners) == [1, 8]) .and. minval(corners) == 1 .and. maxval(corners) == 8, 'a hexahedron')
        call expect(all(domains(1, :, 1) == 0) .and. all(domains(2, :, 1) == 1), 'its ends')
        call expect(all(folds == NURBS_FOLD_NONE) .and. all(signs == 1), 'not folded')
        call fold_pieces(block, folds, signs)
        call expect(size(folds) == 1 .and. all(folds == NURBS_FOLD_NONE) .and. all(signs == 1), 'nor a piece')
        call create_circle(ring, 1d0)
        call bezier_cells(ring, cells, kind, n)
        call bezier_cell_points(ring, points, weights)
        call expect(all(shape(cells) == [4, 3]) .and. kind == 75 .and. n == 8 .and. cells(4, 2) == 1, 'arcs')
        call expect(all(shape(points) == [8, 2]) .and. size(weights) == 8, 'their points')
    end subroutine cells_of_a_block

    subroutine folds()
        type(nurbs_spline) :: g
        real(c_double) :: corners(4, 2), positive(2), negative(2)
        integer(c_int32_t) :: fold
        call fold_test(floor_plane, fold, reference=[0d0, 0d0, 1d0])
        call expect(fold == NURBS_FOLD_NONE, 'no fold')
        corners(:, 1) = [0, 0, 1, 1]
        corners(:, 2) = [0, 1, 1, 0]
        call create_bilinear(g, corners)
        call fold_test(g, fold, positive, negative)
        call expect(fold == NURBS_FOLD_FOUND .and. all(ieee_is_finite([positive, negative])), 'a fold')
    end subroutine folds
end program queries
