! SPDX-License-Identifier: MIT
! Changes of weights and points, constraints and deformations in Fortran: one known value of each.
program edits
    use, intrinsic :: iso_c_binding
    use, intrinsic :: ieee_arithmetic
    use nurbs
    use expectations
    implicit none
    ! A parabola with its top (1, 1) in the middle, where R = (1/4, 1/2, 1/4); a line along x from 0 to 1.
    type(nurbs_spline) :: arch, bar

    call arch%create_bezier([2], reshape([0d0, 1d0, 2d0, 0d0, 2d0, 0d0], [3, 2]))
    call create_line(bar, [0d0, 0d0], [1d0, 0d0])
    call weight_edits()
    call cross_ratios()
    call point_edits()
    call legs()
    call constraints()
    call kinds_of_constraints()
    call regions()
    call deformations()
    call fairing()
    call snapping()
    call finish()

contains

    ! Whether these are the control points, x first.
    logical function has_points(g, expected, by)
        type(nurbs_spline), intent(in) :: g
        real(c_double), intent(in) :: expected(:)
        real(c_double), intent(in), optional :: by
        real(c_double), allocatable :: points(:, :)
        call g%points(points)
        has_points = near([points], expected, by)
    end function has_points

    subroutine weight_edits()
        type(nurbs_spline) :: g
        real(c_double) :: weight
        real(c_double), allocatable :: weights(:)
        integer(c_int32_t) :: code
        call pull_weight(arch, 2, [0.5d0], 0.5d0, g, weight)
        call expect(on(g, 0.5d0, [1d0, 1.5d0]) .and. near([weight], [3d0]), 'a pulled weight')
        call pull_weights(arch, [1, 3], [0.5d0], 0.5d0, g, weight)
        call expect(on(g, 0.5d0, [1d0, 0.5d0]) .and. near([weight], [3d0]), 'two pulled weights')
        call set_weights(arch, [2, 3], [3d0, 1d0], g)
        call g%weights(weights)
        call expect(near(weights, [1d0, 3d0, 1d0]), 'weights set')
        call pull_weight(arch, 2, [0d0], 0.5d0, g, status=code)
        call expect(code == NURBS_ERROR_INFLUENCE, 'no influence')
        call pull_weight(arch, 2, [0.5d0], -1d0, g, status=code)
        call expect(code == NURBS_ERROR_WEIGHT_SIGN, 'a weight of 0')
        call pull_weight(arch, 2, [0.5d0, 0.5d0], 1d0, g, status=code)
        call expect(code == NURBS_ERROR_SIZE, 'two parameters')
    end subroutine weight_edits

    subroutine cross_ratios()
        type(nurbs_spline) :: g, heavy
        real(c_double) :: zero(2), one(2), now(2), weight
        integer(c_int32_t) :: code
        call set_weights(arch, [2], [3d0], heavy)
        call weight_points(heavy, 2, [0.5d0], zero, one, now)
        call expect(near([zero, one, now], [1d0, 0d0, 1d0, 1d0, 1d0, 1.5d0]), 'points of a weight')
        call weight_cross_ratio([1d0, 2d0], zero, one, now, weight)
        call expect(near([weight], [3d0]), 'a cross ratio')
        call weight_through(arch, 2, [0.5d0], [1d0, 1.5d0], 1d-9, g, weight)
        call expect(on(g, 0.5d0, [1d0, 1.5d0]) .and. near([weight], [3d0]), 'a weight by its point')
        call weight_cross_ratio([0d0], [0d0], [1d0], [2d0], weight, status=code)
        call expect(code == NURBS_ERROR_COLLINEAR, 'no ratio')
    end subroutine cross_ratios

    subroutine point_edits()
        type(nurbs_spline) :: g
        real(c_double) :: moved, influences(2)
        integer :: most(2)
        call pull_point(arch, 2, [0.5d0], [0d0, 2d0], 0.5d0, g, moved)
        call expect(has_points(g, [0d0, 1d0, 2d0, 0d0, 3d0, 0d0]) .and. near([moved], [1d0]), 'a pulled point')
        call most_influential(arch, reshape([0.5d0, 0d0], [2, 1]), most, influences)
        call expect(all(most == [2, 1]) .and. near(influences, [0.5d0, 1d0]), 'influences')
    end subroutine point_edits

    subroutine legs()
        type(nurbs_spline) :: g, longer
        real(c_double) :: ratio, knot
        integer :: leg
        integer(c_int32_t) :: code
        call insert_on_leg(arch, 1, 1, 0.5d0, g, knot)
        call expect(has_points(g, [0d0, 0.5d0, 1.5d0, 2d0, 0d0, 1d0, 1d0, 0d0]) .and. near([knot], [0.5d0]), 'a leg')
        call arch%reparametrize(1, 0d0, 2d0, longer)
        call insert_at_point(longer, 1, [1.25d0, 1.5d0], 1d-9, g, leg, ratio, knot)
        call expect(leg == 2 .and. near([ratio, knot], [0.25d0, 0.5d0]), 'a point of a leg')
        call expect(has_points(g, [0d0, 0.25d0, 1.25d0, 2d0, 0d0, 0.5d0, 1.5d0, 0d0]), 'its control points')
        call insert_at_point(arch, 1, [5d0, 5d0], 0.1d0, g, status=code)
        call expect(code == NURBS_ERROR_OFF_POLYGON, 'a point elsewhere')
    end subroutine legs

    subroutine constraints()
        type(nurbs_spline) :: g
        real(c_double) :: param(1, 1), target(1, 2), residuals(1), moved, optimality
        real(c_double), parameter :: held(6) = [0d0, 1d0, 2d0, 0d0, 4d0, 0d0]
        integer(c_int64_t) :: rank
        integer(c_int32_t) :: code
        real(c_double) :: far
        far = ieee_value(far, ieee_positive_inf)
        param = 0.5d0
        target(1, :) = [1d0, 2d0]
        call constrain(arch, param, target, g, residuals=residuals, rank=rank, moved=moved, optimality=optimality)
        call expect(has_points(g, [0d0, 1d0, 2d0, 2d0 / 3, 10d0 / 3, 2d0 / 3]), 'a point')
        call expect(near([residuals, moved], [0d0, 4d0 / 3]) .and. optimality <= 1d-9 .and. rank > 0, 'what is told')
        call constrain(arch, param, target, g, keep=reshape([0, 0], [2, 1]))
        call expect(has_points(g, held), 'ends that stay')
        call constrain(arch, param, target, g, costs=[far, 1d0, far])
        call expect(has_points(g, held), 'points that stay')
        call constrain(arch, param, target, g, costs=[1d0, 1d0], status=code)
        call expect(code == NURBS_ERROR_SIZE, 'too few costs')
    end subroutine constraints

    subroutine kinds_of_constraints()
        type(nurbs_spline) :: g
        real(c_double) :: params(2, 1), targets(2, 2), derivs(1, 2, 2), far
        real(c_double), allocatable :: weights(:)
        integer(c_int32_t) :: code
        far = ieee_value(far, ieee_positive_inf)
        params = 0.5d0
        targets = 1
        call constrain(arch, params, targets, g, kinds=[NURBS_CONSTRAIN_VALUE, NURBS_CONSTRAIN_DIRECTION], &
                       orders=reshape([0, 1], [2, 1]))
        call g%eval_derivs(1, [0.5d0], derivs)
        call expect(near(derivs(1, :, 1), [1d0, 1d0]) .and. near(derivs(1, 1:1, 2), derivs(1, 2:2, 2)), 'a direction')
        call constrain(arch, params(:1, :), reshape([1d0, 1.5d0], [1, 2]), g, costs=[far, far, far], &
                       weight_costs=[far, 1d0, far], tolerance=1d-9)
        call g%weights(weights)
        call expect(near(weights, [1d0, 3d0, 1d0], 1d-7), 'a weight')
        call constrain(arch, params, targets, g, kinds=[7, 0], status=code)
        call expect(code == NURBS_ERROR_CONSTRAINT, 'no kind')
        targets(2, 2) = 2
        call constrain(arch, params, targets, g, status=code)
        call expect(code == NURBS_ERROR_CONTRADICTION, 'a contradiction')
    end subroutine kinds_of_constraints

    subroutine regions()
        type(nurbs_spline) :: g
        real(c_double) :: moved
        integer(c_int32_t) :: code
        call warp(arch, [0d0, 1d0], 0.5d0, 1, g)
        call expect(on(g, 0.5d0, [1d0, 1.5d0]), 'a warp')
        call expect(on(g, 1d0, [2d0, 0d0]), 'its end')
        call warp(arch, [0d0, 1d0], 0.5d0, 0, g, range=reshape([0.5d0, 1d0], [2, 1]))
        call expect(on(g, 0.75d0, [1.5d0, 1.25d0]), 'a part of it')
        call expect(on(g, 0.25d0, [0.5d0, 0.75d0]), 'the rest')
        call warp(arch, [0d0, 0d0], 0.5d0, 1, g, status=code)
        call expect(code == NURBS_ERROR_DIRECTION, 'no direction')
        call flatten(arch, [0d0, 1d0], [0d0, 1d0], g, moved=moved)
        call expect(has_points(g, [0d0, 1d0, 2d0, 1d0, 1d0, 1d0]) .and. near([moved], [1d0]), 'flat')
        call flatten(arch, [0d0, 1d0], [0d0, 1d0], g, direction=[1d0, 1d0])
        call expect(has_points(g, [1d0, 0d0, 3d0, 1d0, 1d0, 1d0]), 'flat along a direction')
    end subroutine regions

    subroutine deformations()
        type(nurbs_spline) :: g, doubled, diagonal
        real(c_double) :: deviation
        logical :: proven
        call bend(bar, [0d0, 0d0], [1d0, 0d0], [0d0, 1d0], 1d0, 1d-6, g, deviation=deviation, proven=proven)
        call expect(on(g, 1d0, [sin(1d0), cos(1d0) - 1], 1d-6) .and. deviation <= 1d-6, 'a bend')
        call bend(bar, [0d0, 0d0], [1d0, 0d0], [0d0, 1d0], 1d0, 1d-6, g, lower=0d0, upper=0.5d0)
        call expect(on(g, 1d0, [sin(0.5d0) + 0.5d0 * cos(0.5d0), cos(0.5d0) - 1 - 0.5d0 * sin(0.5d0)], 2d-6), 'a part')
        call create_bilinear(doubled, reshape([0d0, 0d0, 2d0, 2d0, 0d0, 2d0, 0d0, 2d0], [4, 2]))
        call create_line(diagonal, [0d0, 0d0], [1d0, 1d0])
        call free_form_deform(diagonal, doubled, [0d0, 0d0], [1d0, 1d0], 1d-9, g)
        call expect(on(g, 0.5d0, [1d0, 1d0], 1d-9), 'a free form')
    end subroutine deformations

    subroutine fairing()
        type(nurbs_spline) :: g, wave
        real(c_double), parameter :: points(8) = [0d0, 1d0, 2d0, 3d0, 0d0, 1d0, -1d0, 0d0]
        real(c_double) :: energies(2), bound
        integer(c_int32_t) :: code
        call wave%create_bezier([3], reshape(points, [4, 2]))
        call fair(wave, 2, 10d0, g, energies=energies, bound=bound)
        call expect(on(g, 0.5d0, [1.5d0, 0d0], 1d-9), 'a fair curve')
        call expect(on(g, 1d0, [3d0, 0d0]), 'its end')
        call expect(energies(2) < 1d-9 .and. energies(1) > 1d-9 .and. bound <= 10, 'its energy')
        call fair(wave, 2, 10d0, g, keep=reshape([1, 1], [2, 1]))
        call expect(has_points(g, points, 1d-9), 'tangents that stay')
        call fair(wave, 2, -1d0, g, status=code)
        call expect(code == NURBS_ERROR_TOLERANCE, 'a negative tolerance')
    end subroutine fairing

    subroutine snapping()
        type(nurbs_spline) :: g, other
        real(c_double) :: bound
        call create_line(other, [2d0, 2d0], [3d0, 3d0])
        call snap_boundary(bar, 1, NURBS_END, other, 1, NURBS_START, g, bound=bound)
        call expect(has_points(g, [0d0, 2d0, 0d0, 2d0]) .and. bound >= sqrt(5d0), 'a snapped end')
    end subroutine snapping
end program edits
