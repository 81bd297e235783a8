! SPDX-License-Identifier: MIT
! Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
!> Features of curves and surfaces; complete tells that nothing was missed. Conventions: see the module nurbs.
module nurbs_features
    use, intrinsic :: iso_c_binding
    use nurbs_constants
    use nurbs_c, only: nurbs_curve_features, nurbs_extrema, nurbs_curve_monotone_pieces, nurbs_curve_convexity, &
        nurbs_straightness, nurbs_planarity, nurbs_boundary_contacts, nurbs_singular_points, nurbs_fold_pieces, &
        nurbs_fold_test, nurbs_curve_features_with, nurbs_extrema_with, nurbs_fold_pieces_with, nurbs_fold_test_with
    use nurbs_support
    use nurbs_calls
    use nurbs_splines
    implicit none
    private
    public :: curve_features, extrema, monotone_pieces, curve_convexity, straightness, planarity, boundary_contacts
    public :: singular_points, fold_pieces, fold_test

contains

    !> params(n) in rising order, found(n) one NURBS_FEATURE_ constant each, and values(n): curvature, turning angle or
    !> width there. kinds: a sum of NURBS_FEATURE_ constants.
    subroutine curve_features(g, kinds, params, found, values, complete, status, call)
        class(nurbs_spline), intent(in) :: g
        integer(c_int32_t), intent(in) :: kinds
        real(c_double), allocatable, intent(inout) :: params(:), values(:)
        integer(c_int32_t), allocatable, intent(inout) :: found(:)
        logical, intent(inout), optional :: complete
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code, answer
        integer(c_int64_t) :: n
        n = 0
        answer = 0
        if (present(call)) then
            code = nurbs_curve_features_with(g%handle, kinds, 0_c_int64_t, count=n, call=watched(call))
        else
            code = nurbs_curve_features(g%handle, kinds, 0_c_int64_t, count=n)
        end if
        if (allocated(params)) deallocate (params)
        if (allocated(found)) deallocate (found)
        if (allocated(values)) deallocate (values)
        allocate (params(n), found(n), values(n))
        if (code == NURBS_OK) then
            if (present(call)) then
                code = nurbs_curve_features_with(g%handle, kinds, n, params, found, values, complete=answer, &
                    call=watched(call))
            else
                code = nurbs_curve_features(g%handle, kinds, n, params, found, values, complete=answer)
            end if
        end if
        if (present(complete)) complete = answer /= 0
        call settle(code, status)
    end subroutine curve_features

    !> params(n, axes) where a scalar spline has extrema, saddles or plateaus, values(n) there, found(n) a sum of
    !> NURBS_EXTREMUM_ constants each, and boxes(2, axes, n), outside of which there is nothing. kinds: a sum of
    !> NURBS_EXTREMUM_ constants.
    subroutine extrema(g, kinds, params, values, found, boxes, complete, status, call)
        class(nurbs_spline), intent(in) :: g
        integer(c_int32_t), intent(in) :: kinds
        real(c_double), allocatable, intent(inout) :: params(:, :), values(:), boxes(:, :, :)
        integer(c_int32_t), allocatable, intent(inout) :: found(:)
        logical, intent(inout), optional :: complete
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code, answer
        integer(c_int64_t) :: axes, n
        real(c_double), allocatable :: params_c(:, :)
        axes = axes_of(g%handle)
        n = 0
        answer = 0
        if (present(call)) then
            code = nurbs_extrema_with(g%handle, kinds, 0_c_int64_t, count=n, call=watched(call))
        else
            code = nurbs_extrema(g%handle, kinds, 0_c_int64_t, count=n)
        end if
        if (allocated(values)) deallocate (values)
        if (allocated(found)) deallocate (found)
        if (allocated(boxes)) deallocate (boxes)
        allocate (params_c(axes, n), values(n), found(n), boxes(2, axes, n))
        if (code == NURBS_OK) then
            if (present(call)) then
                code = nurbs_extrema_with(g%handle, kinds, n, params_c, values, found, boxes, complete=answer, &
                    call=watched(call))
            else
                code = nurbs_extrema(g%handle, kinds, n, params_c, values, found, boxes, complete=answer)
            end if
        end if
        params = transpose(params_c)
        if (present(complete)) complete = answer /= 0
        call settle(code, status)
    end subroutine extrema

    !> Lower ends starts(n) of the pieces on which a curve runs one way along a direction(dim), with signs(n): 1, -1 or
    !> 0 where it rises, falls or stays.
    subroutine monotone_pieces(g, direction, starts, signs, complete, status)
        class(nurbs_spline), intent(in) :: g
        real(c_double), intent(in) :: direction(:)
        real(c_double), allocatable, intent(inout) :: starts(:)
        integer(c_int32_t), allocatable, intent(inout) :: signs(:)
        logical, intent(inout), optional :: complete
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code, answer
        integer(c_int64_t) :: n
        n = 0
        answer = 0
        code = fitting([fits(direction, dim_of(g%handle))])
        if (code == NURBS_OK) code = nurbs_curve_monotone_pieces(g%handle, direction, 0_c_int64_t, count=n)
        if (allocated(starts)) deallocate (starts)
        if (allocated(signs)) deallocate (signs)
        allocate (starts(n), signs(n))
        if (code == NURBS_OK) code = nurbs_curve_monotone_pieces(g%handle, direction, n, starts, signs, complete=answer)
        if (present(complete)) complete = answer /= 0
        call settle(code, status)
    end subroutine monotone_pieces

    !> A NURBS_CONVEXITY_ constant of a curve in the plane.
    subroutine curve_convexity(g, convexity, status)
        class(nurbs_spline), intent(in) :: g
        integer(c_int32_t), intent(inout) :: convexity
        integer(c_int32_t), intent(out), optional :: status
        call settle(nurbs_curve_convexity(g%handle, convexity), status)
    end subroutine curve_convexity

    !> A proven bound of the distance from the line through origin(dim) along direction(dim).
    subroutine straightness(g, bound, origin, direction, status)
        class(nurbs_spline), intent(in) :: g
        real(c_double), intent(inout) :: bound
        real(c_double), intent(inout), optional :: origin(:), direction(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: dim
        dim = dim_of(g%handle)
        code = fitting([fits(origin, dim), fits(direction, dim)])
        if (code == NURBS_OK) code = nurbs_straightness(g%handle, origin, direction, bound)
        call settle(code, status)
    end subroutine straightness

    !> A proven bound of the distance of a spline in space from a plane.
    subroutine planarity(g, bound, origin, normal, status)
        class(nurbs_spline), intent(in) :: g
        real(c_double), intent(inout) :: bound
        real(c_double), intent(inout), optional :: origin(3), normal(3)
        integer(c_int32_t), intent(out), optional :: status
        call settle(nurbs_planarity(g%handle, origin, normal, bound), status)
    end subroutine planarity

    !> closed(k) and gaps(k): whether axis k closes, and a bound of the gap; collapsed(1, k) and sizes(1, k): whether
    !> the boundary at its start collapses, and its size, (2, k) at its end.
    subroutine boundary_contacts(g, closed, gaps, collapsed, sizes, tolerance, status)
        class(nurbs_spline), intent(in) :: g
        logical, allocatable, intent(inout) :: closed(:), collapsed(:, :)
        real(c_double), allocatable, intent(inout) :: gaps(:), sizes(:, :)
        real(c_double), intent(in), optional :: tolerance
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int64_t) :: axes
        integer(c_int32_t), allocatable :: closed_c(:), collapsed_c(:, :)
        axes = axes_of(g%handle)
        if (allocated(gaps)) deallocate (gaps)
        if (allocated(sizes)) deallocate (sizes)
        allocate (closed_c(axes), gaps(axes), collapsed_c(2, axes), sizes(2, axes))
        closed_c = 0
        collapsed_c = 0
        call settle(nurbs_boundary_contacts(g%handle, given(tolerance, 0d0), closed_c, gaps, collapsed_c, sizes), &
            status)
        closed = closed_c /= 0
        collapsed = collapsed_c /= 0
    end subroutine boundary_contacts

    !> params(n, axes) where a curve or surface is singular, and boxes(2, axes, n) in which the singular sets lie; the
    !> tolerance is a part of the domain.
    subroutine singular_points(g, tolerance, params, boxes, complete, status)
        class(nurbs_spline), intent(in) :: g
        real(c_double), intent(in) :: tolerance
        real(c_double), allocatable, intent(inout) :: params(:, :), boxes(:, :, :)
        logical, intent(inout), optional :: complete
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code, answer
        integer(c_int64_t) :: axes, n
        real(c_double), allocatable :: params_c(:, :)
        axes = axes_of(g%handle)
        n = 0
        answer = 0
        code = nurbs_singular_points(g%handle, tolerance, 0_c_int64_t, count=n)
        if (allocated(boxes)) deallocate (boxes)
        allocate (params_c(axes, n), boxes(2, axes, n))
        if (code == NURBS_OK) code = nurbs_singular_points(g%handle, tolerance, n, params_c, boxes, complete=answer)
        params = transpose(params_c)
        if (present(complete)) complete = answer /= 0
        call settle(code, status)
    end subroutine singular_points

    !> A NURBS_FOLD_ constant for each polynomial piece by itself, and 1 or -1, the sign of its Jacobian, where that is
    !> proven to be one; reference as for fold_test.
    subroutine fold_pieces(g, folds, signs, reference, status, call)
        class(nurbs_spline), intent(in) :: g
        integer(c_int32_t), allocatable, intent(inout) :: folds(:), signs(:)
        real(c_double), intent(in), optional :: reference(3)
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        n = 0
        if (present(call)) then
            code = nurbs_fold_pieces_with(g%handle, reference, 0_c_int64_t, count=n, call=watched(call))
        else
            code = nurbs_fold_pieces(g%handle, reference, 0_c_int64_t, count=n)
        end if
        if (allocated(folds)) deallocate (folds)
        if (allocated(signs)) deallocate (signs)
        allocate (folds(n), signs(n))
        if (code == NURBS_OK) then
            if (present(call)) then
                code = nurbs_fold_pieces_with(g%handle, reference, n, folds, signs, call=watched(call))
            else
                code = nurbs_fold_pieces(g%handle, reference, n, folds, signs)
            end if
        end if
        call settle(code, status)
    end subroutine fold_pieces

    !> A NURBS_FOLD_ constant, and parameters positive(axes) and negative(axes) of either sign, NaN if none are known;
    !> reference: the direction that normals are compared with.
    subroutine fold_test(g, fold, positive, negative, reference, status, call)
        class(nurbs_spline), intent(in) :: g
        integer(c_int32_t), intent(inout) :: fold
        real(c_double), intent(inout), optional :: positive(:), negative(:)
        real(c_double), intent(in), optional :: reference(3)
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        integer(c_int64_t) :: axes
        axes = axes_of(g%handle)
        code = fitting([fits(positive, axes), fits(negative, axes)])
        if (code == NURBS_OK) then
            if (present(call)) then
                code = nurbs_fold_test_with(g%handle, reference, fold, positive, negative, watched(call))
            else
                code = nurbs_fold_test(g%handle, reference, fold, positive, negative)
            end if
        end if
        call settle(code, status)
    end subroutine fold_test
end module nurbs_features
