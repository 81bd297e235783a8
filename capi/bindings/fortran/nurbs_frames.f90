! SPDX-License-Identifier: MIT
! Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
!> Frames and curvature. Every output is optional; states(n) receives sums of the NURBS_FRAME_ bits. Conventions: see
!> the module nurbs.
module nurbs_frames
    use, intrinsic :: iso_c_binding
    use nurbs_constants
    use nurbs_c, only: nurbs_surface_eval_frames, nurbs_surface_eval_grid_frames, nurbs_surface_eval_curvatures, &
        nurbs_curve_eval_frames, nurbs_curve_rotation_minimizing_frames
    use nurbs_support
    use nurbs_splines
    implicit none
    private
    public :: surface_frames, surface_grid_frames, surface_curvatures, curve_frames, rotation_minimizing_frames

contains

    !> Points, derivatives and unit normals, each (n, 3), at params(n, 2).
    subroutine surface_frames(g, params, points, du, dv, normals, states, flags, status)
        class(nurbs_spline), intent(in) :: g
        real(c_double), intent(in) :: params(:, :)
        real(c_double), intent(inout), optional :: points(:, :), du(:, :), dv(:, :), normals(:, :)
        integer(c_int32_t), intent(inout), optional :: states(:)
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        n = size(params, 1, c_int64_t)
        code = fitting([fits(params, n, 2_c_int64_t), fits(points, n, 3_c_int64_t), fits(du, n, 3_c_int64_t), &
            fits(dv, n, 3_c_int64_t), fits(normals, n, 3_c_int64_t), fits(states, n)])
        if (code == NURBS_OK) code = nurbs_surface_eval_frames(g%handle, n, params, step(params), column(params), &
            points, step(points), column(points), du, step(du), column(du), dv, step(dv), column(dv), normals, &
            step(normals), column(normals), states, given(flags, 0))
        call settle(code, status)
    end subroutine surface_frames

    !> The same on the grid of counts(1) * counts(2) points.
    subroutine surface_grid_frames(g, counts, params, points, du, dv, normals, states, flags, status)
        class(nurbs_spline), intent(in) :: g
        integer(c_int32_t), intent(in) :: counts(2)
        real(c_double), intent(in) :: params(:)
        real(c_double), intent(inout), optional :: points(:, :), du(:, :), dv(:, :), normals(:, :)
        integer(c_int32_t), intent(inout), optional :: states(:)
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: product_counts
        product_counts = product(int(counts, c_int64_t))
        code = fitting([fits(params, sum(int(counts, c_int64_t))), fits(points, product_counts, 3_c_int64_t), &
            fits(du, product_counts, 3_c_int64_t), fits(dv, product_counts, 3_c_int64_t), &
            fits(normals, product_counts, 3_c_int64_t), fits(states, product_counts)])
        if (code == NURBS_OK) code = nurbs_surface_eval_grid_frames(g%handle, int(counts, c_int64_t), params, points, &
            step(points), column(points), du, step(du), column(du), dv, step(dv), column(dv), normals, step(normals), &
            column(normals), states, given(flags, 0))
        call settle(code, status)
    end subroutine surface_grid_frames

    !> principal(n, 2), directions(n, 6) with the first direction in columns 1 to 3, mean(n) and gaussian(n) at
    !> params(n, 2).
    subroutine surface_curvatures(g, params, principal, directions, mean, gaussian, states, flags, status)
        class(nurbs_spline), intent(in) :: g
        real(c_double), intent(in) :: params(:, :)
        real(c_double), intent(inout), optional :: principal(:, :), directions(:, :), mean(:), gaussian(:)
        integer(c_int32_t), intent(inout), optional :: states(:)
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        n = size(params, 1, c_int64_t)
        code = fitting([fits(params, n, 2_c_int64_t), fits(principal, n, 2_c_int64_t), &
            fits(directions, n, 6_c_int64_t), fits(mean, n), fits(gaussian, n), fits(states, n)])
        if (code == NURBS_OK) code = nurbs_surface_eval_curvatures(g%handle, n, params, step(params), column(params), &
            principal, step(principal), column(principal), directions, step(directions), column(directions), mean, &
            0_c_int64_t, gaussian, 0_c_int64_t, states, given(flags, 0))
        call settle(code, status)
    end subroutine surface_curvatures

    !> Vectors (n, dim), curvatures(n) and torsions(n) at params(n).
    subroutine curve_frames(g, params, points, tangents, normals, binormals, curvatures, torsions, states, flags, &
            status)
        class(nurbs_spline), intent(in) :: g
        real(c_double), intent(in) :: params(:)
        real(c_double), intent(inout), optional :: points(:, :), tangents(:, :), normals(:, :), binormals(:, :)
        real(c_double), intent(inout), optional :: curvatures(:), torsions(:)
        integer(c_int32_t), intent(inout), optional :: states(:)
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n, dim
        n = size(params, kind=c_int64_t)
        dim = dim_of(g%handle)
        code = fitting([fits(points, n, dim), fits(tangents, n, dim), fits(normals, n, dim), &
            fits(binormals, n, 3_c_int64_t), fits(curvatures, n), fits(torsions, n), fits(states, n)])
        if (code == NURBS_OK) code = nurbs_curve_eval_frames(g%handle, n, params, 0_c_int64_t, points, step(points), &
            column(points), tangents, step(tangents), column(tangents), normals, step(normals), column(normals), &
            binormals, step(binormals), column(binormals), curvatures, 0_c_int64_t, torsions, 0_c_int64_t, states, &
            given(flags, 0))
        call settle(code, status)
    end subroutine curve_frames

    !> Vectors (n, 3) along the sequence params(n).
    subroutine rotation_minimizing_frames(g, params, first_normal, points, tangents, normals, binormals, states, &
            flags, status)
        class(nurbs_spline), intent(in) :: g
        real(c_double), intent(in) :: params(:)
        real(c_double), intent(in), optional :: first_normal(3)
        real(c_double), intent(inout), optional :: points(:, :), tangents(:, :), normals(:, :), binormals(:, :)
        integer(c_int32_t), intent(inout), optional :: states(:)
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        n = size(params, kind=c_int64_t)
        code = fitting([fits(points, n, 3_c_int64_t), fits(tangents, n, 3_c_int64_t), fits(normals, n, 3_c_int64_t), &
            fits(binormals, n, 3_c_int64_t), fits(states, n)])
        if (code == NURBS_OK) code = nurbs_curve_rotation_minimizing_frames(g%handle, n, params, 0_c_int64_t, &
            first_normal, points, step(points), column(points), tangents, step(tangents), column(tangents), normals, &
            step(normals), column(normals), binormals, step(binormals), column(binormals), states, given(flags, 0))
        call settle(code, status)
    end subroutine rotation_minimizing_frames
end module nurbs_frames
