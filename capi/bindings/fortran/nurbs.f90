! SPDX-License-Identifier: MIT
! Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
!> libnurbs for Fortran 2018: splines, lists of splines, statistics of data, trimmed faces and models of
!> them, where shapes meet, and meshes, as types that clean up after themselves.
!>
!> - Arrays have Fortran's order, one column for each coordinate: points(n, dim), params(n, axes) and
!>   derivs(n, dim, slots). Contiguous ones are used in place; the compiler packs others into a temporary.
!> - Control points and grids run through the last axis fastest: point (i, j) of a surface of counts (m, n) is
!>   row (i - 1) * n + j.
!> - Axes, spans and list entries count from 1. Only messages and the module nurbs_c count from 0.
!> - Each procedure has an optional status. Without it a failure ends the program with the library's message.
!>   An array whose shape does not suit is NURBS_ERROR_SIZE.
!> - Results are arguments, not function values, which compilers of today do not always finalize. The result of
!>   an operation must be another variable than its operand.
!> - An assignment makes another handle on the same data, also of arrays, which have to be allocated before, of the
!>   same shape. What copies bit by bit in its place would have handles freed twice: allocate() with source=, and
!>   in gfortran 12 assignments of types with splines in them; give such a type an assignment of its own, which
!>   assigns these.
!> - A procedure that can take long has an optional last argument, call: a nurbs_call with a limit of work, and with a
!>   function that is told how much is done and may end the call.
!>
!> A CMake project writes find_package(nurbs COMPONENTS Fortran) and links nurbs::fortran. By hand, nurbs_all.f90 is all
!> modules in one file:
!>
!>     gfortran -c nurbs_all.f90
module nurbs
    use nurbs_constants ! statuses, flags and limits
    use nurbs_c         ! the C functions as they stand, for what is not below: nurbs_version
    use nurbs_support, only: nurbs_message, nurbs_status_text, nurbs_on_axis, nurbs_on_all_axes
    use nurbs_handles, only: data_for_fits, default_cloud_options, default_fit_options, default_read_options, &
        default_mesh_options, default_write_options
    use nurbs_calls, only: nurbs_call, nurbs_progress
    use nurbs_evaluation, only: derivative_slots
    use nurbs_splines, only: nurbs_spline
    use nurbs_lists, only: bytes_kind, nurbs_list
    use nurbs_fittings, only: fit_points, fit_tolerance, cloud_start, fit_cloud, nurbs_statistics
    use nurbs_faces, only: nurbs_face
    use nurbs_models, only: nurbs_model
    use nurbs_meets, only: nurbs_meet
    use nurbs_meshes, only: mesh_curve, bezier_cells, bezier_cell_points, nurbs_mesh
    use nurbs_fits
    use nurbs_knot_vectors
    use nurbs_frames
    use nurbs_compatible
    use nurbs_continuation
    use nurbs_calculus
    use nurbs_continuities
    use nurbs_reduction
    use nurbs_projections
    use nurbs_curves
    use nurbs_shapes
    use nurbs_coons
    use nurbs_recognition
    use nurbs_closest
    use nurbs_measures
    use nurbs_bounds
    use nurbs_features
    use nurbs_intersections
    use nurbs_edits
    use nurbs_deformations
    use nurbs_segments
    use nurbs_levels
    implicit none
    public
end module nurbs
