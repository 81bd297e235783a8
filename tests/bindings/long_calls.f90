! SPDX-License-Identifier: MIT
! Long calls of the Fortran binding: progress, calls that are stopped, limits of work; and the watched form of each
! procedure gives what the plain one gives.
module watchers
    use, intrinsic :: iso_c_binding
    use nurbs
    implicit none
    integer :: told = 0
    real(c_double) :: last = 0
    logical :: rising = .true.

    type :: patience
        integer :: left = 2
    end type patience

contains

    logical function count_calls(done, user) result(stop)
        real(c_double), intent(in) :: done
        class(*), intent(inout), optional :: user
        rising = rising .and. done >= last .and. done <= 1
        last = done
        told = told + 1
        stop = .false.
        if (present(user)) stop = .true. ! which none of these has
    end function count_calls

    logical function stop_at_once(done, user) result(stop)
        real(c_double), intent(in) :: done
        class(*), intent(inout), optional :: user
        stop = done >= 0 .and. .not. present(user)
    end function stop_at_once

    !> A callback with data of its own: stops at the second call.
    logical function stop_later(done, user) result(stop)
        real(c_double), intent(in) :: done
        class(*), intent(inout), optional :: user
        stop = done > 1
        select type (user)
        type is (patience)
            user%left = user%left - 1
            stop = user%left == 0
        end select
    end function stop_later
end module watchers

program long_calls
    use, intrinsic :: iso_c_binding
    use nurbs
    use expectations
    use watchers
    implicit none
    type(nurbs_call) :: watch
    type(nurbs_spline) :: long, g, other, sheet, ball, ring

    call shapes()
    call progress()
    call stops()
    watch = nurbs_call(progress=count_calls)
    call splines()
    call measures()
    call places()
    call answers()
    call changes()
    call surfaces()
    call files()
    call finish()

contains

    ! A curve that runs to and fro, so that its length takes a while.
    subroutine winding(curve, n)
        type(nurbs_spline), intent(inout) :: curve
        integer, intent(in) :: n
        real(c_double), allocatable :: knots(:)
        real(c_double) :: points(n, 2)
        integer :: i
        call knots_open_uniform(3, n, knots)
        do i = 1, n
            points(i, :) = [sin(real(i, c_double)**2), cos(3 * real(i, c_double)**2)]
        end do
        call curve%create([3], [n], knots, points)
    end subroutine winding

    subroutine shapes()
        call winding(long, 200000)
        call winding(g, 40)
        call g%transform(reshape([1d0, 0d0, 0d0, 1d0], [2, 2]), other, [3d0, 0d0])
        call sheet%create_bezier([1, 1], reshape([0d0, 0d0, 1d0, 1d0, 0d0, 1d0, 0d0, 1d0], [4, 2]))
        call create_sphere(ball, 1d0)
        call create_circle(ring, 1d0)
    end subroutine shapes

    subroutine progress()
        real(c_double) :: alone, watched
        call curve_length(long, alone, tolerance=1d-9)
        call curve_length(long, watched, tolerance=1d-9, call=nurbs_call(progress=count_calls))
        call expect(abs(watched - alone) <= 0, 'the same length')
        call expect(told > 0 .and. rising, 'progress is told')
    end subroutine progress

    subroutine stops()
        real(c_double) :: length
        integer(c_int32_t) :: code
        type(patience), target :: own
        type(nurbs_call) :: waiting
        length = -1
        call curve_length(long, length, tolerance=1d-9, status=code, call=nurbs_call(progress=stop_at_once))
        call expect(code == NURBS_ERROR_CANCELLED .and. length < 0, 'a call that is stopped')
        call curve_length(long, length, tolerance=1d-9, status=code, call=nurbs_call(work=1_c_int64_t))
        call expect(code == NURBS_ERROR_WORK .and. length < 0, 'a limit of work')
        call curve_length(long, length, tolerance=1d-9, status=code, call=nurbs_call())
        call expect(code == NURBS_OK .and. length > 0, 'no wishes')
        waiting = nurbs_call(progress=stop_later)
        waiting%user => own
        call curve_length(long, length, tolerance=1d-9, status=code, call=waiting)
        call expect(code == NURBS_ERROR_CANCELLED .and. own%left == 0, 'a callback with data of its own')
    end subroutine stops

    logical function same(a, b)
        type(nurbs_spline), intent(in) :: a, b
        real(c_double), allocatable :: p(:, :), q(:, :)
        call a%points(p)
        call b%points(q)
        same = equal([p], [q])
    end function same

    logical function equal(a, b)
        real(c_double), intent(in) :: a(:), b(:)
        equal = near(a, b, 0d0) .and. size(a) > 0
    end function equal

    subroutine splines()
        type(nurbs_spline) :: a, b, map
        real(c_double) :: p, q
        call map%create_bezier([1], reshape([0d0, 1d0], [2, 1]))
        call spline_product(g, g, a, NURBS_PRODUCT_DOT)
        call spline_product(g, g, b, NURBS_PRODUCT_DOT, call=watch)
        call expect(same(a, b), 'product')
        call spline_compose(g, map, a)
        call spline_compose(g, map, b, call=watch)
        call expect(same(a, b), 'composition')
        call reduce_knots(g, 1, 0.1d0, a, p)
        call reduce_knots(g, 1, 0.1d0, b, q, call=watch)
        call expect(same(a, b) .and. equal([p], [q]), 'fewer knots')
        call reduce_degree(g, 1, 1, a, p)
        call reduce_degree(g, 1, 1, b, q, call=watch)
        call expect(same(a, b) .and. equal([p], [q]), 'a lower degree')
        call simplify(g, 0.1d0, a, p)
        call simplify(g, 0.1d0, b, q, call=watch)
        call expect(same(a, b) .and. equal([p], [q]), 'the simplest spline')
    end subroutine splines

    subroutine measures()
        real(c_double) :: p(2), q(2), a, b, c(3), d(3)
        real(c_double), allocatable :: parts(:), again(:)
        call curve_lengths(g, [0.3d0, 0.7d0], p)
        call curve_lengths(g, [0.3d0, 0.7d0], q, call=watch)
        call expect(equal(p, q), 'lengths')
        call params_at_lengths(g, [0.3d0, 0.7d0], p)
        call params_at_lengths(g, [0.3d0, 0.7d0], q, call=watch)
        call expect(equal(p, q), 'parameters at lengths')
        call divide_curve(g, 5, parts)
        call divide_curve(g, 5, again, call=watch)
        call expect(equal(parts, again), 'parts of equal length')
        call spline_moments(g, a, p, tolerance=1d-6)
        call spline_moments(g, b, q, tolerance=1d-6, call=watch)
        call expect(equal([a, p], [b, q]), 'moments')
        call surface_area(ball, a, tolerance=1d-6)
        call surface_area(ball, b, tolerance=1d-6, call=watch)
        call expect(equal([a], [b]), 'an area')
        call enclosed_area([ring], a, p)
        call enclosed_area([ring], b, q, call=watch)
        call expect(equal([a, p], [b, q]), 'an area that a curve encloses')
        call enclosed_volume([ball], a, c)
        call enclosed_volume([ball], b, d, call=watch)
        call expect(equal([a, c], [b, d]), 'a volume')
    end subroutine measures

    ! Every other point of an array, so that the compiler packs what is passed.
    subroutine places()
        real(c_double) :: points(4, 2), p(2, 1), q(2, 1), feet(2, 2), others(2, 2), d(2), e(2)
        integer(c_int32_t) :: s(2), t(2)
        points = reshape([0.3d0, 9d0, -0.2d0, 9d0, 0.7d0, 9d0, 0.5d0, 9d0], [4, 2])
        call closest_points(g, points(::2, :), p, feet, d, s, tolerance=1d-6)
        call closest_points(g, points(::2, :), q, others, e, t, tolerance=1d-6, call=watch)
        call expect(equal([p, feet, d], [q, others, e]) .and. all(s == t), 'closest points')
        call farthest_points(g, points(::2, :), p, feet, d, s, range=reshape([0.25d0, 0.75d0], [2, 1]))
        call farthest_points(g, points(::2, :), q, others, e, t, range=reshape([0.25d0, 0.75d0], [2, 1]), call=watch)
        call expect(equal([p, feet, d], [q, others, e]) .and. all(s == t), 'farthest points')
        call closest_local(g, points(::2, :), reshape([0.2d0, 0.8d0], [2, 1]), p, feet, d, s)
        call closest_local(g, points(::2, :), reshape([0.2d0, 0.8d0], [2, 1]), q, distances=e, call=watch)
        call expect(equal([p, d], [q, e]), 'local minima')
        call signed_distances(g, points(::2, :), d, p(:, 1), s)
        call signed_distances(g, points(::2, :), e, states=t, call=watch)
        call expect(equal(d, e) .and. all(s == t), 'signed distances')
        call closest_points(g, points(::2, :), q, budget=1, call=watch)
    end subroutine places

    subroutine answers()
        real(c_double), allocatable :: p(:, :), q(:, :), d(:), e(:), u(:), v(:)
        integer(c_int32_t), allocatable :: kinds(:), found(:)
        real(c_double) :: least(2), most(2), low(2), high(2)
        call closest_all(g, [0.3d0, 0.7d0], p, d)
        call closest_all(g, [0.3d0, 0.7d0], q, e, call=watch)
        call expect(equal([p], [q]) .and. equal(d, e), 'all closest points')
        call critical_points(g, [0.3d0, 0.7d0], p, d, kinds)
        call critical_points(g, [0.3d0, 0.7d0], q, e, found, call=watch)
        call expect(equal([p], [q]) .and. all(kinds == found), 'critical points')
        call spline_distance(g, other, 0d0, least(1), most(1))
        call spline_distance(g, other, 0d0, low(1), high(1), call=watch)
        call expect(equal([least(1), most(1)], [low(1), high(1)]), 'a distance')
        call hausdorff_distance(g, other, 0.1d0, least, most)
        call hausdorff_distance(g, other, 0.1d0, low, high, call=watch)
        call expect(equal([least, most], [low, high]), 'a Hausdorff distance')
        call curve_features(g, NURBS_FEATURE_INFLECTION, d, kinds, e)
        call curve_features(g, NURBS_FEATURE_INFLECTION, u, found, v, call=watch)
        call expect(equal(d, u) .and. equal(e, v) .and. all(kinds == found), 'features')
    end subroutine answers

    subroutine changes()
        type(nurbs_spline) :: a, b
        real(c_double) :: p, q, r(1), s(1)
        integer(c_int64_t) :: rank, ranks
        call fair(g, 2, 0.1d0, a, bound=p)
        call fair(g, 2, 0.1d0, b, bound=q, call=watch)
        call expect(same(a, b) .and. equal([p], [q]), 'a fair curve')
        call constrain(g, reshape([0.5d0], [1, 1]), reshape([1d0, 2d0], [1, 2]), a, residuals=r, rank=rank, moved=p)
        call constrain(g, reshape([0.5d0], [1, 1]), reshape([1d0, 2d0], [1, 2]), b, residuals=s, rank=ranks, moved=q, &
            call=watch)
        call expect(same(a, b) .and. equal([p, r], [q, s]) .and. rank == ranks, 'constraints')
        call bend(g, [0d0, 0d0], [1d0, 0d0], [0d0, 1d0], 0.1d0, 1d-3, a, deviation=p)
        call bend(g, [0d0, 0d0], [1d0, 0d0], [0d0, 1d0], 0.1d0, 1d-3, b, deviation=q, call=watch)
        call expect(same(a, b) .and. equal([p], [q]), 'a bend')
        call free_form_deform(sheet, sheet, [0d0, 0d0], [1d0, 1d0], 1d-6, a)
        call free_form_deform(sheet, sheet, [0d0, 0d0], [1d0, 1d0], 1d-6, b, call=watch)
        call expect(same(a, b), 'a deformation')
    end subroutine changes

    subroutine surfaces()
        type(recognized_shape) :: a, b
        integer(c_int32_t) :: fold, folds
        call recognize_spline(ball, 1d-6, a)
        call recognize_spline(ball, 1d-6, b, call=watch)
        call expect(a%shape == b%shape .and. equal(a%origin, b%origin), 'a shape')
        call fold_test(sheet, fold)
        call fold_test(sheet, folds, call=watch)
        call expect(fold == folds, 'folds')
    end subroutine surfaces

    subroutine files()
        type(nurbs_list) :: list
        integer(c_int32_t) :: code
        call list%read('', status=code, call=watch)
        call expect(code /= NURBS_OK, 'an empty file')
        call list%read_file('none', status=code, call=watch)
        call expect(code == NURBS_ERROR_FILE, 'no file')
    end subroutine files
end program long_calls
