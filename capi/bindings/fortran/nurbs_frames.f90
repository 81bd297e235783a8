! SPDX-License-Identifier: MIT
!> Frames and curvature. Every output is optional; states(n) receives sums of the NURBS_FRAME_ bits. Conventions: see
!> the module nurbs.
module nurbs_frames
    use, intrinsic :: iso_c_binding
    use nurbs_constants
    use nurbs_c
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
        integer(c_int64_t) :: rows
        rows = size(params, 1, c_int64_t)
        code = fitting([has_shape(rows, 3, points), has_shape(rows, 3, du), has_shape(rows, 3, dv), &
                        has_shape(rows, 3, normals), has_length(rows, states), size(params, 2) == 2])
        if (code == NURBS_OK) code = nurbs_surface_eval_frames(g%handle, rows, params, step(params), &
            column(params), points, apart(rows), rows, du, apart(rows), rows, dv, apart(rows), rows, normals, &
            apart(rows), rows, states, bits(flags))
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
        integer(c_int64_t) :: rows
        rows = product(int(counts, c_int64_t))
        code = fitting([has_shape(rows, 3, points), has_shape(rows, 3, du), has_shape(rows, 3, dv), &
                        has_shape(rows, 3, normals), has_length(rows, states), &
                        size(params, kind=c_int64_t) == sum(int(counts, c_int64_t))])
        if (code == NURBS_OK) code = nurbs_surface_eval_grid_frames(g%handle, int(counts, c_int64_t), params, &
            points, apart(rows), rows, du, apart(rows), rows, dv, apart(rows), rows, normals, apart(rows), rows, &
            states, bits(flags))
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
        integer(c_int64_t) :: rows
        rows = size(params, 1, c_int64_t)
        code = fitting([has_shape(rows, 2, principal), has_shape(rows, 6, directions), has_size(rows, mean), &
                        has_size(rows, gaussian), has_length(rows, states), size(params, 2) == 2])
        if (code == NURBS_OK) code = nurbs_surface_eval_curvatures(g%handle, rows, params, step(params), &
            column(params), principal, apart(rows), rows, directions, apart(rows), rows, mean, 0_c_int64_t, &
            gaussian, 0_c_int64_t, states, bits(flags))
        call settle(code, status)
    end subroutine surface_curvatures

    !> Vectors (n, dim), curvatures(n) and torsions(n) at params(n).
    subroutine curve_frames(g, params, points, tangents, normals, binormals, curvatures, torsions, states, &
                            flags, status)
        class(nurbs_spline), intent(in) :: g
        real(c_double), intent(in) :: params(:)
        real(c_double), intent(inout), optional :: points(:, :), tangents(:, :), normals(:, :), binormals(:, :), &
            curvatures(:), torsions(:)
        integer(c_int32_t), intent(inout), optional :: states(:)
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: rows
        integer :: dim
        rows = size(params, kind=c_int64_t)
        dim = dim_of(g%handle)
        code = fitting([has_shape(rows, dim, points), has_shape(rows, dim, tangents), &
                        has_shape(rows, dim, normals), has_shape(rows, 3, binormals), has_size(rows, curvatures), &
                        has_size(rows, torsions), has_length(rows, states)])
        if (code == NURBS_OK) code = nurbs_curve_eval_frames(g%handle, rows, params, 0_c_int64_t, points, &
            apart(rows), rows, tangents, apart(rows), rows, normals, apart(rows), rows, binormals, apart(rows), &
            rows, curvatures, 0_c_int64_t, torsions, 0_c_int64_t, states, bits(flags))
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
        integer(c_int64_t) :: rows
        rows = size(params, kind=c_int64_t)
        code = fitting([has_shape(rows, 3, points), has_shape(rows, 3, tangents), has_shape(rows, 3, normals), &
                        has_shape(rows, 3, binormals), has_length(rows, states)])
        if (code == NURBS_OK) code = nurbs_curve_rotation_minimizing_frames(g%handle, rows, params, 0_c_int64_t, &
            first_normal, points, apart(rows), rows, tangents, apart(rows), rows, normals, apart(rows), rows, &
            binormals, apart(rows), rows, states, bits(flags))
        call settle(code, status)
    end subroutine rotation_minimizing_frames
end module nurbs_frames
