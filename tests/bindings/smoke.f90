! SPDX-License-Identifier: MIT
! The Fortran binding: create, evaluate a batch, insert a knot, and be told what is wrong.
program smoke
    use, intrinsic :: iso_c_binding
    use nurbs
    use expectations
    implicit none
    integer, parameter :: samples = 1001

    call known_points()
    call insertion_keeps_the_circle()
    call forms_and_maps()
    call calculus_and_weights()
    call parts_of_the_circle()
    call circles_made_compatible()
    call continuity_of_the_circle()
    call beyond_the_ends()
    call images_in_a_plane()
    call segments()
    call reduction()
    call surfaces()
    call data_derivatives()
    call frames()
    call sections_and_copies()
    call copies_of_arrays()
    call inspection()
    call constructors_agree()
    call errors_name_what_is_wrong()
    call knot_vectors()
    call bases()
    call finish()

contains

    ! The unit circle as four rational quadratic quarters.
    subroutine make_circle(g)
        type(nurbs_spline), intent(inout) :: g
        real(c_double) :: points(9, 2), weights(9)
        real(c_double), allocatable :: knots(:)
        points(:, 1) = [1, 1, 0, -1, -1, -1, 0, 1, 1]
        points(:, 2) = [0, 1, 1, 1, 0, -1, -1, -1, 0]
        weights = 1
        weights(2:8:2) = sqrt(0.5_c_double)
        call knots_bezier(2, 4, knots)
        call g%create([2], [9], knots, points, weights)
    end subroutine make_circle

    function params() result(t)
        real(c_double) :: t(samples)
        integer :: i
        t = [(i / real(samples - 1, c_double), i=0, samples - 1)]
    end function params

    subroutine known_points()
        type(nurbs_spline) :: g
        real(c_double) :: points(4, 2)
        real(c_float) :: singles(2, 2)
        call make_circle(g)
        call g%eval([0.0_c_double, 0.25_c_double, 0.5_c_double, 0.75_c_double], points)
        call expect(all(points(:, 1) == [1, 0, -1, 0]) .and. all(points(:, 2) == [0, 1, 0, -1]), 'points')
        call g%eval_f32([0.1_c_double, 0.2_c_double], singles)
        call g%eval([0.1_c_double, 0.2_c_double], points(3:4, :))
        call expect(all(singles == real(points(3:4, :), c_float)), 'single precision')
        call g%eval_grid_f32([2], [0.1_c_double, 0.2_c_double], singles)
        call expect(all(singles == real(points(3:4, :), c_float)), 'single precision on a grid')
        call g%eval([0.5_c_double], points(2:2, :))
        call expect(all(points(2, :) == [-1, 0]) .and. points(1, 1) == 1, 'one point in a section')
    end subroutine known_points

    subroutine insertion_keeps_the_circle()
        type(nurbs_spline) :: g, finer
        real(c_double) :: before(samples, 2), after(samples, 2)
        call make_circle(g)
        call g%insert_knot(1, 0.3_c_double, 2, finer)
        call g%eval(params(), before)
        call finer%eval(params(), after)
        call expect(finer%count(1) == 11, 'two more control points')
        call expect(maxval(abs(after - before)) <= 8 * eps, 'the same shape')
        call expect(maxval(abs(hypot(after(:, 1), after(:, 2)) - 1)) <= 8 * eps, 'a circle')
    end subroutine insertion_keeps_the_circle

    subroutine forms_and_maps()
        type(nurbs_spline) :: g, h, k
        integer(c_int32_t) :: status
        real(c_double), allocatable :: points(:, :), again(:, :), weights(:), net(:, :)
        real(c_double) :: one(1, 2)
        call make_circle(g)
        call g%points(points)
        call g%elevate(1, 2, h)
        call expect(h%degree(1) == 4, 'degree 4')
        call g%reverse(1, h)
        call h%reverse(1, k)
        call k%points(again)
        call expect(all(again == points), 'reversed twice')
        call g%reverse(1, h, flags=NURBS_KEEP_DOMAIN)
        call h%eval([0.25_c_double], one)
        call expect(all(one(1, :) == [0, -1]), 'reversed on the same domain')
        call g%reparametrize(1, 1.0_c_double, 5.0_c_double, h)
        call h%eval([2.0_c_double], one)
        call expect(all(one(1, :) == [0, 1]), 'another domain')
        call g%to_homogeneous(h)
        call h%from_homogeneous(k)
        call k%weights(weights)
        call expect(weights(1) == 1, 'homogeneous and back')
        call g%make_rational(h)
        call expect(h%is_rational(), 'rational')
        call g%transform(reshape([0d0, 2d0, 1d0, 0d0], [2, 2]), h, translation=[10d0, 20d0]) ! (y, 2 x)
        call h%points(again)
        call expect(all(again(:, 1) == points(:, 2) + 10) .and. all(again(:, 2) == 2*points(:, 1) + 20), 'affine')
        call g%transform_projective(reshape([1d0, 0d0, 0d0, 0d0, 1d0, 0d0, 0d0, 0d0, 2d0], [3, 3]), h)
        call h%points(again)
        call expect(all(2*again == points), 'projective')
        call g%transform(reshape([1d0], [1, 1]), h, status=status)
        call expect(status == NURBS_ERROR_SIZE, 'a matrix of another size')
        net = reshape([0, 0, 1, 1, 0, 1, 0, 1, 0, 0, 0, 1], [4, 3])*1.0_c_double
        call g%create_bezier([1, 1], net)
        call g%transpose_axes([2, 1], h)
        call h%points(net)
        call expect(all(net(:, 1) == [0, 1, 0, 1]), 'transposed')
    end subroutine forms_and_maps

    subroutine calculus_and_weights()
        type(nurbs_spline) :: g, line, inner, made, moved
        real(c_double) :: one(1, 2), single(1, 1), values(2)
        real(c_double), allocatable :: weights(:)
        integer(c_int32_t) :: code
        call make_circle(g)
        call line%create_bezier([1], reshape([0d0, 1d0, 2d0, 4d0], [2, 2])) ! (t, 2 + 2 t)
        call spline_blossom(line, [0.5d0], [0.25d0], values)
        call expect(all(values == [0.25d0, 2.5d0]), 'a value of the polar form')
        call spline_derivative(line, 1, 1, made)
        call made%eval([0.3d0], one)
        call expect(all(one(1, :) == [1, 2]), 'derivative')
        call spline_antiderivative(line, 1, made)
        call made%eval([1d0], one)
        call expect(all(one(1, :) == [0.5d0, 3d0]), 'integral')
        call spline_product(line, line, made, flags=NURBS_PRODUCT_DOT)
        call made%eval([1d0], single)
        call expect(single(1, 1) == 17, 'dot product')
        call inner%create_bezier([2], reshape([0d0, 0d0, 1d0], [3, 1])) ! t^2
        call spline_compose(line, inner, made)
        call made%eval([0.5d0], one)
        call expect(all(one(1, :) == [0.25d0, 2.5d0]), 'composition')
        call spline_sum(line, 2d0, line, 1d0, made)
        call made%eval([1d0], one)
        call expect(all(one(1, :) == [3, 12]), 'sum')
        call line%make_rational(moved)
        call normalize_weights(moved, made)
        call expect(.not. made%is_rational(), 'weights dropped')
        allocate (weights(9))
        call reparametrize_moebius(g, 1, 4d0, moved)
        call moved%weights(weights)
        call expect(abs(weights(9) - 4) < 64 * eps, 'ratio of the end weights')
        call equalize_end_weights(moved, 1, made)
        call made%weights(weights)
        call expect(abs(weights(9) - 1) < 64 * eps, 'equal end weights')
        call spline_antiderivative(g, 1, made, status=code)
        call expect(code == NURBS_ERROR_RATIONAL, 'no integral of a rational curve')
    end subroutine calculus_and_weights

    subroutine parts_of_the_circle()
        type(nurbs_spline) :: g, made, halves(2)
        type(nurbs_list) :: pieces
        real(c_double) :: before(samples, 2), after(samples, 2), gap
        real(c_double), allocatable :: values(:)
        integer(c_int64_t), allocatable :: columns(:), rows(:)
        integer(c_int32_t) :: code
        call make_circle(g)
        call g%refine(1, [0.6_c_double, 0.3_c_double], made)
        call expect(made%count(1) == 11, 'a list of knots')
        call g%refine_uniform(1, 2, made)
        call expect(made%count(1) == 13, 'halved spans')
        call g%refinement_matrix(1, [0.1_c_double], values, columns, rows)
        call expect(size(rows) == 11 .and. rows(1) == 1, 'a refinement matrix')
        call g%split(1, 0.3_c_double, halves(1), halves(2))
        call made%join(halves, 1, gap=gap)
        call g%eval(params(), before)
        call made%eval(params(), after)
        call expect(gap == 0 .and. maxval(abs(after - before)) <= 8 * eps, 'halves joined')
        call g%extract([0.1_c_double], [0.2_c_double], made)
        call expect(made%count(1) == 3, 'an extract')
        call pieces%decompose(g)
        call expect(pieces%count() == 4, 'Bezier pieces')
        call pieces%split_at_knots(g, 1, 0)
        call expect(pieces%count() == 1, 'no jumps')
        call g%clamp(1, made)
        call expect(made%count(1) == 9, 'clamped as it was')
        call g%move_seam(1, 0.3_c_double, made, status=code)
        call expect(code == NURBS_ERROR_NOT_PERIODIC, 'no seam')
    end subroutine parts_of_the_circle

    subroutine circles_made_compatible()
        type(nurbs_spline) :: both(2), snapped
        type(nurbs_list) :: made
        real(c_double) :: moved
        call make_circle(both(1))
        call both(1)%insert_knot(1, 0.3_c_double, 1, both(2))
        call make_splines_compatible(both, made, deviation=moved)
        call expect(moved == 0, 'exactly compatible')
        call expect(made%count() == 2, 'compatible circles')
        call snap_spline_knots(both(2), 1, 0.06_c_double, snapped, moved)
        call expect(moved > 0, 'knots snapped together')
        call expect(snapped%count(1) == 10, 'as many control points')
    end subroutine circles_made_compatible

    subroutine continuity_of_the_circle()
        type(nurbs_spline) :: g, halves(2)
        type(spline_continuity), allocatable :: rows(:)
        type(spline_continuity) :: found
        real(c_double), allocatable :: knots(:)
        integer(c_int32_t), allocatable :: orders(:)
        call make_circle(g)
        call knot_continuity(g, 1, [0d0, 0d0, 0d0], knots, orders, rows)
        call expect(size(rows) == 4 .and. knots(1) == 0.25d0 .and. rows(1)%geometric == 2, 'a smooth circle')
        call g%split(1, 0.3_c_double, halves(1), halves(2))
        call end_continuity(halves(1), NURBS_END, halves(2), NURBS_START, [0d0, 0d0, 0d0], found)
        call expect(found%order == 2, 'smooth halves')
    end subroutine continuity_of_the_circle

    subroutine beyond_the_ends()
        type(nurbs_spline) :: g, made
        integer(c_int32_t) :: order
        call make_circle(g)
        call extend_spline(g, 1, NURBS_END, 0.5_c_double, 0, made)
        call expect(made%count(1) == 11, 'an extension')
        call unclamp_spline(g, 1, made)
        call expect(made%count(1) == 9, 'unclamped')
        call make_spline_periodic(g, 1, 1e-9_c_double, made, order=order)
        call expect(order == 0, 'a loop')
        call expect(detect_periodic(made, 1), 'that is periodic')
    end subroutine beyond_the_ends

    subroutine images_in_a_plane()
        type(nurbs_spline) :: g, made
        real(c_double) :: one(1, 2)
        call make_circle(g)
        call mirror_spline(g, [0d0, 0d0], [0d0, 2d0], made)
        call made%eval([0.25_c_double], one)
        call expect(all(one(1, :) == [0, -1]), 'a mirror image')
        call project_spline_to_plane(g, [0d0, 0d0], [0d0, 2d0], made, direction=[1d0, 1d0])
        call made%eval([0.25_c_double], one)
        call expect(all(one(1, :) == [-1, 0]), 'a shadow')
        call project_spline_from(g, [0d0, -4d0], [0d0, 0d0], [0d0, 1d0], made)
        call made%eval([0.0_c_double], one)
        call expect(all(one(1, :) == [1, 0]), 'a perspective')
    end subroutine images_in_a_plane

    subroutine segments()
        type(nurbs_spline) :: g
        real(c_double) :: one(1, 2), m(2, 2)
        real(c_double), allocatable :: params(:), points(:, :), tangents(:, :), coefficients(:, :), breaks(:)
        integer(c_int64_t), allocatable :: pieces(:)
        call create_hermite_spline(g, [0d0, 1d0], reshape([0d0, 1d0, 0d0, 1d0], [2, 2]), &
            reshape([3d0, 0d0, 0d0, 3d0], [2, 2]))
        call g%eval([1.0_c_double], one)
        call expect(all(one(1, :) == [1, 1]), 'the end of a Hermite curve')
        call hermite_data(g, params, points, tangents)
        call expect(all(tangents == reshape([3d0, 0d0, 0d0, 3d0], [2, 2])), 'the tangents of a Hermite curve')
        call power_form(g, coefficients, breaks, pieces)
        call expect(all(coefficients == reshape([0, 0, 3, 0, -3, 0, 1, 1], [2, 4])), 'the power basis')
        call create_power_spline(g, [3_c_int32_t], pieces, breaks, coefficients)
        call g%eval([1.0_c_double], one)
        call expect(all(one(1, :) == [1, 1]), 'a spline of the power basis')
        call basis_matrix(NURBS_BASIS_BERNSTEIN, NURBS_BASIS_POWER, m)
        call expect(all(m(1, :) == [1, 0]) .and. all(m(2, :) == [-1, 1]), 'from one basis to another')
    end subroutine segments

    subroutine reduction()
        type(nurbs_spline) :: g, more, made
        integer(c_int32_t) :: code, removed
        real(c_double) :: bound, upper
        call make_circle(g)
        call g%refine(1, [0.3_c_double, 0.3_c_double], more)
        call remove_knot(more, 1, 0.3_c_double, 5, 1e-12_c_double, made, removed, bound)
        call expect(made%count(1) == 9, 'a knot removed')
        call expect(removed == 2 .and. bound <= 1e-12_c_double, 'twice')
        call deviation(g, made, at_most=upper)
        call expect(upper <= 1e-12_c_double, 'as it was')
        call g%refine_uniform(1, 3, more)
        call reduce_knots(more, 0, 1e-12_c_double, made)
        call expect(made%count(1) == 9, 'knots removed')
        call g%elevate(1, 1, more)
        call reduce_degree(more, 1, 1, made)
        call expect(made%count(1) == 9, 'degree lowered')
        call simplify(more, 1e-12_c_double, made)
        call expect(made%count(1) == 9, 'simplified')
        call remove_knot(g, 1, 0.3_c_double, 1, 1.0_c_double, made, status=code)
        call expect(code == NURBS_ERROR_NOT_A_KNOT, 'no knot')
    end subroutine reduction

    ! z = u v over the unit square.
    subroutine surfaces()
        type(nurbs_spline) :: g, curve
        real(c_double) :: net(4, 3), derivs(1, 3, 6), grid(6, 3), grid_derivs(6, 3, 3), end_point(1, 3), values(1, 4)
        integer(c_int64_t) :: spans(1, 2)
        net = reshape([0, 0, 1, 1, 0, 1, 0, 1, 0, 0, 0, 1], [4, 3]) * 1.0_c_double
        call g%create_bezier([1, 1], net)
        call g%eval_derivs(2, reshape([0.25_c_double, 0.5_c_double], [1, 2]), derivs)
        call expect(all(derivs(1, 3, :) == [0.125d0, 0.5d0, 0.25d0, 0d0, 1d0, 0d0]), 'derivatives of u v')
        call g%eval_grid([3, 2], [0d0, 0.5d0, 1d0, 0.25d0, 1d0], grid)
        call expect(all(grid(:, 3) == [0d0, 0d0, 0.125d0, 0.5d0, 0.25d0, 1d0]), 'grid')
        call g%eval_grid_derivs(1, [3, 2], [0d0, 0.5d0, 1d0, 0.25d0, 1d0], grid_derivs)
        call expect(all(grid_derivs(:, 3, 2) == [0.25d0, 1d0, 0.25d0, 1d0, 0.25d0, 1d0]), 'derivatives on a grid')
        call g%iso(1, 0.5d0, curve)
        call curve%eval([1d0], end_point)
        call expect(all(end_point(1, :) == [0.5d0, 1d0, 0.5d0]), 'iso-curve')
        call g%rational_basis(reshape([0d0, 1d0], [1, 2]), spans, values)
        call expect(all(spans(1, :) == [2, 2]) .and. all(values(1, :) == [0, 1, 0, 0]), 'basis')
    end subroutine surfaces

    ! L = x + 2 y of a point of the circle at t = 0, the first control point.
    subroutine data_derivatives()
        type(nurbs_spline) :: g
        real(c_double), allocatable :: values(:), operators(:, :, :), domains(:, :)
        integer(c_int64_t), allocatable :: columns(:), rows(:), firsts(:)
        real(c_double) :: points(9, 2), weights(9), slopes(1, 1)
        call make_circle(g)
        call g%rational_collocation(reshape([0d0, 0.25d0], [2, 1]), values, columns, rows)
        call expect(all(rows == [1, 4, 7]) .and. all(columns == [1, 2, 3, 3, 4, 5]), 'sparse rows')
        call expect(all(values == [1, 0, 0, 1, 0, 0]), 'collocation')
        call g%bezier_extraction(1, operators, firsts, domains)
        call expect(all(firsts == [1, 3, 5, 7]) .and. all(domains(:, 2) == [0.25d0, 0.5d0]), 'spans')
        call expect(all(operators(:, 2, 3) == [0, 1, 0]), 'extraction')
        call g%eval_adjoint(0, reshape([0d0], [1, 1]), reshape([1d0, 2d0], [1, 2, 1]), points, weights, slopes)
        call expect(all(points(1, :) == [1, 2]) .and. all(points(2:, :) == 0) .and. all(weights == 0), 'gradients')
        call expect(abs(slopes(1, 1) - 2 * 8 * sqrt(0.5d0)) < 1d-14, 'slope')
    end subroutine data_derivatives

    subroutine frames()
        type(nurbs_spline) :: g, line
        real(c_double) :: net(4, 3), normals(2, 3), grid(1, 3), principal(1, 2), n(2, 3), curvature(1), at(2, 2)
        integer(c_int32_t) :: states(2), one(1), code
        net = reshape([0, 0, 1, 1, 0, 1, 0, 1, 0, 0, 0, 1], [4, 3]) * 1.0_c_double
        at = reshape([0d0, 0.5d0, 0d0, 0.25d0], [2, 2])
        call g%create_bezier([1, 1], net)
        call surface_frames(g, at, normals=normals, states=states)
        call expect(all(normals(1, :) == [0, 0, 1]) .and. all(states == 0), 'surface frames')
        call surface_grid_frames(g, [1, 1], [0.5d0, 0.25d0], normals=grid)
        call expect(all(grid(1, :) == normals(2, :)), 'frames on a grid')
        call surface_curvatures(g, at(1:1, :), principal)
        call expect(maxval(abs(principal(1, :) - [1, -1])) <= 4 * eps, 'principal curvatures')
        call line%create_bezier([1], reshape([0, 1, 0, 0, 0, 0], [2, 3]) * 1.0_c_double)
        call curve_frames(line, [0.5d0], curvatures=curvature, states=one)
        call expect(curvature(1) == 0 .and. one(1) == NURBS_FRAME_RULE, 'curve frames')
        call rotation_minimizing_frames(line, [0d0, 1d0], [0d0, 0d0, 2d0], normals=n)
        call expect(all(n(1, :) == [0, 0, 1]) .and. all(n(2, :) == [0, 0, 1]), 'rotation-minimizing frames')
        call rotation_minimizing_frames(line, [0d0, 1d0], [1d0, 0d0, 0d0], normals=n, status=code)
        call expect(code == NURBS_ERROR_DIRECTION, 'a bad direction')
        call surface_frames(g, at, normals=grid, status=code)
        call expect(code == NURBS_ERROR_SIZE, 'a bad shape')
    end subroutine frames

    subroutine sections_and_copies()
        type(nurbs_spline) :: g, copied, moved
        real(c_double) :: wide(8, 2), tight(4, 2)
        real(c_double), allocatable :: points(:, :)
        call make_circle(g)
        wide = 7
        call g%eval([0d0, 0.25d0, 0.5d0, 0.75d0], tight)
        call g%eval([0d0, 0.25d0, 0.5d0, 0.75d0], wide(1::2, :))
        call expect(all(wide(1::2, :) == tight) .and. all(wide(2::2, :) == 7), 'every other row')
        copied = g
        call g%destroy()
        call expect(copied%point_count() == 9, 'a copy outlives its original')
        call copied%points(points)
        call copied%with_points(points + 1, moved)
        call moved%eval([0d0], tight(1:1, :))
        call expect(all(tight(1, :) == [2, 1]), 'moved points')
        copied = copied
        call expect(copied%dimension() == 2, 'assignment to itself')
    end subroutine sections_and_copies

    subroutine copies_of_arrays()
        type(nurbs_spline) :: all_of_them(3)
        type(nurbs_spline), allocatable :: some(:)
        call make_circle(all_of_them(1))
        call make_circle(all_of_them(3))
        allocate (some(2))
        some = all_of_them(1:2)
        call expect(some(1)%point_count() == 9, 'an array')
        call expect(.not. c_associated(some(2)%handle), 'an empty element')
        call expect(.not. c_associated(some(1)%handle, all_of_them(1)%handle), 'handles of its own')
        some = all_of_them(3)
        call all_of_them(3)%destroy()
        call expect(some(1)%point_count() == 9, 'one to the first')
        call expect(some(2)%point_count() == 9, 'one to the second')
    end subroutine copies_of_arrays

    subroutine inspection()
        type(nurbs_spline) :: g
        real(c_double), allocatable :: knots(:), abscissae(:)
        integer(c_int32_t), allocatable :: times(:)
        real(c_double) :: sizes(1)
        call make_circle(g)
        call expect(g%axes() == 1, 'axes')
        call expect(g%degree(1) == 2, 'degree')
        call expect(g%is_rational(), 'rational')
        call expect(.not. g%is_homogeneous(), 'weights')
        call expect(all(g%domain(1) == [0, 1]), 'domain')
        call expect(g%knot_form(1) == NURBS_FORM_CLAMPED_START + NURBS_FORM_CLAMPED_END, 'form')
        call g%distinct_knots(1, knots, times)
        call expect(all(knots == [0d0, 0.25d0, 0.5d0, 0.75d0, 1d0]) .and. all(times == [3, 2, 2, 2, 3]), 'knots')
        call g%greville(1, abscissae)
        call expect(size(abscissae) == 9 .and. abscissae(2) == 0.125d0, 'Greville abscissae')
        call g%hull_size([0.1d0], sizes)
        call expect(sizes(1) == 1, 'hull size')
        call expect(nurbs_on_axis(3, NURBS_CLAMP) == int(z'020000'), 'flags of the third axis')
        call expect(nurbs_on_all_axes(2, NURBS_LEFT) == int(z'0101'), 'flags of two axes')
    end subroutine inspection

    subroutine constructors_agree()
        type(nurbs_spline) :: g, others(3)
        real(c_double), allocatable :: knots(:), distinct(:), points(:, :), weights(:), homogeneous(:, :)
        integer(c_int32_t), allocatable :: times(:)
        real(c_double) :: expected(1, 2), point(1, 2)
        integer :: i
        call make_circle(g)
        call g%knots(1, knots)
        call g%distinct_knots(1, distinct, times)
        call g%points(points)
        call g%weights(weights)
        call g%homogeneous_points(homogeneous)
        call others(1)%create_short([2], [9], knots(2:11), points, weights)
        call others(2)%create_multiplicities([2], [9], [5], distinct, times, points, weights)
        call others(3)%create_homogeneous([2], [9], knots, homogeneous)
        call g%eval([0.1d0], expected)
        do i = 1, 3
            call others(i)%eval([0.1d0], point)
            call expect(maxval(abs(point - expected)) <= 4 * eps, 'constructors agree')
        end do
    end subroutine constructors_agree

    subroutine errors_name_what_is_wrong()
        type(nurbs_spline) :: g
        real(c_double) :: t(20), points(20, 2)
        integer(c_int32_t) :: status
        character(len=:), allocatable :: text
        call make_circle(g)
        t = 0.5d0
        t(18) = 1.25d0
        points = 7
        call g%eval(t, points, status=status)
        text = nurbs_message()
        print '(3a)', nurbs_status_text(status), ': ', text
        call expect(status == NURBS_ERROR_OUTSIDE_DOMAIN, 'status')
        call expect(nurbs_status_text(status) == 'NURBS_ERROR_OUTSIDE_DOMAIN', 'name of the status')
        call expect(index(text, 'params[17]') > 0 .and. index(text, '1.25') > 0, 'array, index and value')
        call expect(all(points == 7), 'a failing call writes nothing')
        call g%eval(t(18:18), points(1:1, :), flags=NURBS_CLAMP)
        call expect(all(points(1, :) == [1, 0]), 'clamped')
        call g%eval(t, points(1:19, :), status=status)
        call expect(status == NURBS_ERROR_SIZE, 'output of a wrong shape')
        call g%create([1], [4], [0d0, 0d0, 2d0, 1d0, 3d0, 3d0], points(1:4, :), status=status)
        call expect(status == NURBS_ERROR_KNOTS_DECREASING, 'decreasing knots')
        call expect(.not. c_associated(g%handle), 'nothing is left after a failure')
    end subroutine errors_name_what_is_wrong

    subroutine knot_vectors()
        real(c_double), allocatable :: knots(:)
        integer(c_int32_t) :: code
        call knots_uniform(1, 3, knots)
        call expect(all(knots == [-0.5d0, 0d0, 0.5d0, 1d0, 1.5d0]), 'uniform knots')
        call knots_uniform(1, 3, knots, a=1d0, b=3d0)
        call expect(all(knots == [0, 1, 2, 3, 4]), 'uniform knots over a domain')
        call knots_open_uniform(2, 4, knots, b=2d0)
        call expect(all(knots == [0, 0, 0, 1, 2, 2, 2]), 'open uniform knots')
        call knots_bezier(1, 2, knots)
        call expect(all(knots == [0d0, 0d0, 0.5d0, 1d0, 1d0]), 'knots of Bezier pieces')
        call knots_bezier(1, 2, knots, breaks=[0d0, 2d0, 3d0])
        call expect(all(knots == [0, 0, 2, 3, 3]), 'knots of Bezier pieces between breaks')
        call knots_averaged(2, [0d0, 1d0, 2d0, 4d0], knots)
        call expect(all(knots == [0d0, 0d0, 0d0, 1.5d0, 4d0, 4d0, 4d0]), 'averaged knots')
        call knots_periodic(1, [0d0, 1d0, 2d0], knots)
        call expect(all(knots == [-1, 0, 1, 2, 3]), 'periodic knots')
        call knots_periodic(1, [0d0, 1d0, 2d0], knots, multiplicities=[1, 2, 1])
        call expect(size(knots) == 6 .and. count(abs(knots - 1) < eps) == 2, 'periodic knots, one of them twice')
        call knots_uniform(-1, 3, knots, status=code)
        call expect(code == NURBS_ERROR_DEGREE, 'knots of no degree')
        call knots_bezier(1, 2, knots, breaks=[0d0, 2d0], status=code)
        call expect(code == NURBS_ERROR_SIZE, 'too few breaks')
    end subroutine knot_vectors

    subroutine bases()
        real(c_double), parameter :: knots(7) = [0d0, 0d0, 0d0, 0.5d0, 1d0, 1d0, 1d0], t(3) = [0d0, 0.5d0, 1d0]
        real(c_double) :: values(3, 3, 2), curve(1, 3, 1)
        real(c_double), allocatable :: entries(:)
        integer(c_int64_t), allocatable :: columns(:), rows(:)
        integer(c_int64_t) :: spans(3), again(3)
        integer(c_int32_t) :: code
        call find_spans(2, knots, t, spans)
        call expect(all(spans == [3, 4, 4]), 'spans')
        call basis(2, knots, 1, t, again, values)
        call expect(all(again == spans), 'the same spans')
        call expect(all(values(2, :, 1) == [0.5d0, 0.5d0, 0d0]) .and. all(values(1, :, 2) == [-4, 4, 0]), 'a basis')
        call bernstein(2, 0, [0.5d0], curve)
        call expect(all(curve(1, :, 1) == [0.25d0, 0.5d0, 0.25d0]), 'Bernstein polynomials')
        call collocation([1, 1], [2, 2], [0d0, 0d0, 1d0, 1d0, 0d0, 0d0, 1d0, 1d0], reshape([0.25d0, 0.5d0], [1, 2]), &
                         entries, columns, rows, orders=[0, 1])
        call expect(all(entries == [-0.75d0, 0.75d0, -0.25d0, 0.25d0]), 'collocation')
        call expect(all(columns == [1, 2, 3, 4]) .and. all(rows == [1, 5]), 'its columns and rows')
        call expect(derivative_slots(2, 2) == 6, 'derivatives of a surface')
        call find_spans(2, knots, t, spans(:2), status=code)
        call expect(code == NURBS_ERROR_SIZE, 'too few spans')
        call bernstein(2, 1, [0.5d0], curve, code)
        call expect(code == NURBS_ERROR_SIZE, 'too few derivatives')
    end subroutine bases
end program smoke
