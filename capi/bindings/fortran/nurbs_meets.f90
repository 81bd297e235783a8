! SPDX-License-Identifier: MIT
! Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
!> Curves where shapes meet, and the nodes where these end; every answer says whether it is complete. Conventions: see
!> the module nurbs.
module nurbs_meets
    use, intrinsic :: iso_c_binding
    use nurbs_constants
    use nurbs_c, only: nurbs_surface_sections, nurbs_surface_contours, nurbs_surface_reflections, nurbs_surface_level, &
        nurbs_surface_level_curves, nurbs_surface_intersections, nurbs_surface_self_intersections, &
        nurbs_face_intersections, nurbs_surface_project_curve, nurbs_face_project_curve, nurbs_meet_counts, &
        nurbs_meet_branches, nurbs_meet_kinds, nurbs_meet_branch, nurbs_meet_branch_second, nurbs_meet_nodes, &
        nurbs_meet_nodes_second, nurbs_meet_ways, nurbs_meet_faces, nurbs_meet_faces_second, nurbs_meet_joints, &
        nurbs_meet_joints_second, nurbs_model_sections, nurbs_model_intersections, nurbs_meet_trim, &
        nurbs_meet_trim_second, nurbs_surface_sections_with, nurbs_surface_contours_with, &
        nurbs_surface_reflections_with, nurbs_surface_level_with, nurbs_surface_level_curves_with, &
        nurbs_surface_intersections_with, nurbs_surface_self_intersections_with, nurbs_face_intersections_with, &
        nurbs_surface_project_curve_with, nurbs_face_project_curve_with, nurbs_model_sections_with, &
        nurbs_model_intersections_with, nurbs_meet_trim_with, nurbs_meet_trim_second_with
    use nurbs_support
    use nurbs_calls
    use nurbs_handles
    use nurbs_splines
    use nurbs_faces
    use nurbs_models
    implicit none
    private

    !> Curves where shapes meet; an assignment makes another handle on the same curves.
    type, extends(nurbs_meet_handle), public :: nurbs_meet
    contains
        procedure :: sections, contours, reflections, level, level_curves, surfaces, of_itself, of_faces, projection
        procedure :: face_projection, counts, branches, branch_kinds, branch, branch_second, nodes, nodes_second, ways
        procedure :: faces, faces_second, joints, joints_second, model_sections, of_models, trimmed, trimmed_second
    end type nurbs_meet

contains

    !> Where planes normal . x = offset cut a surface: all curves to within a tolerance, proven to be all.
    subroutine sections(this, g, normal, offsets, tolerance, status, call)
        class(nurbs_meet), intent(inout) :: this
        class(nurbs_spline), intent(in) :: g
        real(c_double), intent(in) :: normal(3), offsets(:), tolerance
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        type(c_ptr) :: made
        n = size(offsets, kind=c_int64_t)
        if (present(call)) then
            code = nurbs_surface_sections_with(g%handle, normal, n, offsets, tolerance, watched(call), made)
        else
            code = nurbs_surface_sections(g%handle, normal, n, offsets, tolerance, made)
        end if
        call this%replace(made)
        call settle(code, status)
    end subroutine sections

    !> Silhouettes, isophotes of some angles, and parabolic curves of a surface: all of them, proven to be all.
    subroutine contours(this, g, kind, d, cosines, tolerance, status, call)
        class(nurbs_meet), intent(inout) :: this
        class(nurbs_spline), intent(in) :: g
        integer(c_int32_t), intent(in) :: kind
        real(c_double), intent(in), optional :: d(3)
        real(c_double), intent(in) :: cosines(:), tolerance
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        type(c_ptr) :: made
        n = size(cosines, kind=c_int64_t)
        if (present(call)) then
            code = nurbs_surface_contours_with(g%handle, kind, d, n, cosines, tolerance, watched(call), made)
        else
            code = nurbs_surface_contours(g%handle, kind, d, n, cosines, tolerance, made)
        end if
        call this%replace(made)
        call settle(code, status)
    end subroutine contours

    !> Lines of light that a surface mirrors, or that its normals meet: all of them, proven to be all.
    subroutine reflections(this, g, kind, eye, direction, points, tolerance, status, call)
        class(nurbs_meet), intent(inout) :: this
        class(nurbs_spline), intent(in) :: g
        integer(c_int32_t), intent(in) :: kind
        real(c_double), intent(in), optional :: eye(3)
        real(c_double), intent(in) :: direction(3), points(:, :), tolerance
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        type(c_ptr) :: made
        n = size(points, 1, c_int64_t)
        made = c_null_ptr
        code = fitting([fits(points, n, 3_c_int64_t)])
        if (code == NURBS_OK) then
            if (present(call)) then
                code = nurbs_surface_reflections_with(g%handle, kind, eye, direction, n, points, step(points), &
                    column(points), tolerance, watched(call), made)
            else
                code = nurbs_surface_reflections(g%handle, kind, eye, direction, n, points, step(points), &
                    column(points), tolerance, made)
            end if
        end if
        call this%replace(made)
        call settle(code, status)
    end subroutine reflections

    !> Where an implicit polynomial of space vanishes on a surface, proven to be all.
    subroutine level(this, g, degree, coefficients, tolerance, status, call)
        class(nurbs_meet), intent(inout) :: this
        class(nurbs_spline), intent(in) :: g
        integer(c_int32_t), intent(in) :: degree
        real(c_double), intent(in) :: coefficients(:), tolerance
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        made = c_null_ptr
        code = fitting([fits(coefficients, monomials(dim_of(g%handle), degree))])
        if (code == NURBS_OK) then
            if (present(call)) then
                code = nurbs_surface_level_with(g%handle, degree, coefficients, tolerance, watched(call), made)
            else
                code = nurbs_surface_level(g%handle, degree, coefficients, tolerance, made)
            end if
        end if
        call this%replace(made)
        call settle(code, status)
    end subroutine level

    !> Where a scalar spline over a surface has given values, proven to be all.
    subroutine level_curves(this, g, scalar, values, tolerance, status, call)
        class(nurbs_meet), intent(inout) :: this
        class(nurbs_spline), intent(in) :: g, scalar
        real(c_double), intent(in) :: values(:), tolerance
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        type(c_ptr) :: made
        n = size(values, kind=c_int64_t)
        if (present(call)) then
            code = nurbs_surface_level_curves_with(g%handle, scalar%handle, n, values, tolerance, watched(call), made)
        else
            code = nurbs_surface_level_curves(g%handle, scalar%handle, n, values, tolerance, made)
        end if
        call this%replace(made)
        call settle(code, status)
    end subroutine level_curves

    !> Where two surfaces meet in curves, proven to be all.
    subroutine surfaces(this, a, b, tolerance, status, call)
        class(nurbs_meet), intent(inout) :: this
        class(nurbs_spline), intent(in) :: a, b
        real(c_double), intent(in) :: tolerance
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        if (present(call)) then
            code = nurbs_surface_intersections_with(a%handle, b%handle, tolerance, watched(call), made)
        else
            code = nurbs_surface_intersections(a%handle, b%handle, tolerance, made)
        end if
        call this%replace(made)
        call settle(code, status)
    end subroutine surfaces

    !> Where a surface meets itself in curves, proven to be all; without any it is proven to be simple.
    subroutine of_itself(this, g, tolerance, status, call)
        class(nurbs_meet), intent(inout) :: this
        class(nurbs_spline), intent(in) :: g
        real(c_double), intent(in) :: tolerance
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        if (present(call)) then
            code = nurbs_surface_self_intersections_with(g%handle, tolerance, watched(call), made)
        else
            code = nurbs_surface_self_intersections(g%handle, tolerance, made)
        end if
        call this%replace(made)
        call settle(code, status)
    end subroutine of_itself

    !> Where two faces meet: in the edges that they share, and in curves inside of both.
    subroutine of_faces(this, a, b, tolerance, status, call)
        class(nurbs_meet), intent(inout) :: this
        class(nurbs_face), intent(in) :: a, b
        real(c_double), intent(in) :: tolerance
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        if (present(call)) then
            code = nurbs_face_intersections_with(a%handle, b%handle, tolerance, watched(call), made)
        else
            code = nurbs_face_intersections(a%handle, b%handle, tolerance, made)
        end if
        call this%replace(made)
        call settle(code, status)
    end subroutine of_faces

    !> A curve projected onto a surface along a direction, or normally: all curves on it, proven to be all.
    subroutine projection(this, g, curve, direction, tolerance, status, call)
        class(nurbs_meet), intent(inout) :: this
        class(nurbs_spline), intent(in) :: g, curve
        real(c_double), intent(in) :: direction(3), tolerance
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        if (present(call)) then
            code = nurbs_surface_project_curve_with(g%handle, curve%handle, direction, tolerance, watched(call), made)
        else
            code = nurbs_surface_project_curve(g%handle, curve%handle, direction, tolerance, made)
        end if
        call this%replace(made)
        call settle(code, status)
    end subroutine projection

    !> A curve projected onto a face along a direction, or normally: all curves inside of its loops.
    subroutine face_projection(this, face, curve, direction, tolerance, status, call)
        class(nurbs_meet), intent(inout) :: this
        class(nurbs_face), intent(in) :: face
        class(nurbs_spline), intent(in) :: curve
        real(c_double), intent(in) :: direction(3), tolerance
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        if (present(call)) then
            code = nurbs_face_project_curve_with(face%handle, curve%handle, direction, tolerance, watched(call), made)
        else
            code = nurbs_face_project_curve(face%handle, curve%handle, direction, tolerance, made)
        end if
        call this%replace(made)
        call settle(code, status)
    end subroutine face_projection

    !> How much it holds.
    subroutine counts(this, branches, nodes, complete, status)
        class(nurbs_meet), intent(in) :: this
        integer(c_int64_t), intent(inout), optional :: branches, nodes
        logical, intent(inout), optional :: complete
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: answer
        answer = 0
        call settle(nurbs_meet_counts(this%handle, branches, nodes, answer), status)
        if (present(complete)) complete = answer /= 0
    end subroutine counts

    !> Of each branch its plane, the nodes at which it begins and ends, end_nodes(n, 2), 0 where it closes, the closed
    !> way that it is a part of, counted from 0, -1 for none, and a proven bound of the distances of its curves from the
    !> section.
    subroutine branches(this, levels, end_nodes, loops, deviations, status)
        class(nurbs_meet), intent(in) :: this
        integer(c_int64_t), allocatable, intent(inout) :: levels(:), end_nodes(:, :), loops(:)
        real(c_double), allocatable, intent(inout) :: deviations(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        integer(c_int64_t), allocatable :: end_nodes_c(:, :)
        n = 0
        code = nurbs_meet_branches(this%handle, 0_c_int64_t, count=n)
        if (allocated(levels)) deallocate (levels)
        if (allocated(loops)) deallocate (loops)
        if (allocated(deviations)) deallocate (deviations)
        allocate (levels(n), end_nodes_c(2, n), loops(n), deviations(n))
        if (code == NURBS_OK) code = nurbs_meet_branches(this%handle, n, levels, end_nodes_c, loops, deviations)
        if (code == NURBS_OK) then
            levels = levels + 1
            end_nodes = transpose(end_nodes_c) + 1
        end if
        call settle(code, status)
    end subroutine branches

    !> What the branches are, one of the NURBS_BRANCH_ constants each.
    subroutine branch_kinds(this, kinds, status)
        class(nurbs_meet), intent(in) :: this
        integer(c_int32_t), allocatable, intent(inout) :: kinds(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        n = 0
        code = nurbs_meet_kinds(this%handle, 0_c_int64_t, count=n)
        if (allocated(kinds)) deallocate (kinds)
        allocate (kinds(n))
        if (code == NURBS_OK) code = nurbs_meet_kinds(this%handle, n, kinds)
        call settle(code, status)
    end subroutine branch_kinds

    !> The curves of a branch, with common knots: in space, and in the parameter domain.
    subroutine branch(this, index, space, on_surface, status)
        class(nurbs_meet), intent(in) :: this
        integer(c_int32_t), intent(in) :: index
        type(nurbs_spline), intent(inout) :: space, on_surface
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made_space, made_on_surface
        code = nurbs_meet_branch(this%handle, index - 1_c_int64_t, made_space, made_on_surface)
        call space%replace(made_space)
        call on_surface%replace(made_on_surface)
        call settle(code, status)
    end subroutine branch

    !> The curve of a branch in the parameter domain of the second of two surfaces.
    subroutine branch_second(this, index, on_second, status)
        class(nurbs_meet), intent(in) :: this
        integer(c_int32_t), intent(in) :: index
        type(nurbs_spline), intent(inout) :: on_second
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        code = nurbs_meet_branch_second(this%handle, index - 1_c_int64_t, made)
        call on_second%replace(made)
        call settle(code, status)
    end subroutine branch_second

    !> Of each node its plane, one of the NURBS_NODE_ constants, params(n, 2) of the surface, and ranges(n, 4): the
    !> lower and upper end of the part on the first axis, and on the second one.
    subroutine nodes(this, levels, kinds, params, ranges, status)
        class(nurbs_meet), intent(in) :: this
        integer(c_int64_t), allocatable, intent(inout) :: levels(:)
        integer(c_int32_t), allocatable, intent(inout) :: kinds(:)
        real(c_double), allocatable, intent(inout) :: params(:, :), ranges(:, :)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        real(c_double), allocatable :: params_c(:, :), ranges_c(:, :)
        n = 0
        code = nurbs_meet_nodes(this%handle, 0_c_int64_t, count=n)
        if (allocated(levels)) deallocate (levels)
        if (allocated(kinds)) deallocate (kinds)
        allocate (levels(n), kinds(n), params_c(2, n), ranges_c(4, n))
        if (code == NURBS_OK) code = nurbs_meet_nodes(this%handle, n, levels, kinds, params_c, ranges_c)
        params = transpose(params_c)
        ranges = transpose(ranges_c)
        if (code == NURBS_OK) levels = levels + 1
        call settle(code, status)
    end subroutine nodes

    !> Of each node params(n, 2) of the second surface, and ranges(n, 4): the lower and upper end of the part on the
    !> first axis, and on the second one.
    subroutine nodes_second(this, params, ranges, status)
        class(nurbs_meet), intent(in) :: this
        real(c_double), allocatable, intent(inout) :: params(:, :), ranges(:, :)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        real(c_double), allocatable :: params_c(:, :), ranges_c(:, :)
        n = 0
        code = nurbs_meet_nodes_second(this%handle, 0_c_int64_t, count=n)
        allocate (params_c(2, n), ranges_c(4, n))
        if (code == NURBS_OK) code = nurbs_meet_nodes_second(this%handle, n, params_c, ranges_c)
        params = transpose(params_c)
        ranges = transpose(ranges_c)
        call settle(code, status)
    end subroutine nodes_second

    !> Of each way its plane, the first branch and the number of branches, 1 if it closes, and the largest distance of
    !> ends that go on in each other.
    subroutine ways(this, levels, firsts, sizes, closes, gaps, status)
        class(nurbs_meet), intent(in) :: this
        integer(c_int64_t), allocatable, intent(inout) :: levels(:), firsts(:), sizes(:)
        integer(c_int32_t), allocatable, intent(inout) :: closes(:)
        real(c_double), allocatable, intent(inout) :: gaps(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        n = 0
        code = nurbs_meet_ways(this%handle, 0_c_int64_t, count=n)
        if (allocated(levels)) deallocate (levels)
        if (allocated(firsts)) deallocate (firsts)
        if (allocated(sizes)) deallocate (sizes)
        if (allocated(closes)) deallocate (closes)
        if (allocated(gaps)) deallocate (gaps)
        allocate (levels(n), firsts(n), sizes(n), closes(n), gaps(n))
        if (code == NURBS_OK) code = nurbs_meet_ways(this%handle, n, levels, firsts, sizes, closes, gaps)
        if (code == NURBS_OK) then
            levels = levels + 1
            firsts = firsts + 1
        end if
        call settle(code, status)
    end subroutine ways

    !> The faces of a model on which the branches are.
    subroutine faces(this, own_faces, own_instances, status)
        class(nurbs_meet), intent(in) :: this
        integer(c_int64_t), allocatable, intent(inout) :: own_faces(:), own_instances(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        n = 0
        code = nurbs_meet_faces(this%handle, 0_c_int64_t, count=n)
        if (allocated(own_faces)) deallocate (own_faces)
        if (allocated(own_instances)) deallocate (own_instances)
        allocate (own_faces(n), own_instances(n))
        if (code == NURBS_OK) code = nurbs_meet_faces(this%handle, n, own_faces, own_instances)
        if (code == NURBS_OK) then
            own_faces = own_faces + 1
            own_instances = own_instances + 1
        end if
        call settle(code, status)
    end subroutine faces

    !> The faces of the second of two models on which the branches are.
    subroutine faces_second(this, own_faces, own_instances, status)
        class(nurbs_meet), intent(in) :: this
        integer(c_int64_t), allocatable, intent(inout) :: own_faces(:), own_instances(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        n = 0
        code = nurbs_meet_faces_second(this%handle, 0_c_int64_t, count=n)
        if (allocated(own_faces)) deallocate (own_faces)
        if (allocated(own_instances)) deallocate (own_instances)
        allocate (own_faces(n), own_instances(n))
        if (code == NURBS_OK) code = nurbs_meet_faces_second(this%handle, n, own_faces, own_instances)
        if (code == NURBS_OK) then
            own_faces = own_faces + 1
            own_instances = own_instances + 1
        end if
        call settle(code, status)
    end subroutine faces_second

    !> How ways go on at the nodes, and on which faces of a model these are.
    subroutine joints(this, next_nodes, gaps, own_faces, own_instances, status)
        class(nurbs_meet), intent(in) :: this
        integer(c_int64_t), allocatable, intent(inout) :: next_nodes(:), own_faces(:), own_instances(:)
        real(c_double), allocatable, intent(inout) :: gaps(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        n = 0
        code = nurbs_meet_joints(this%handle, 0_c_int64_t, count=n)
        if (allocated(next_nodes)) deallocate (next_nodes)
        if (allocated(gaps)) deallocate (gaps)
        if (allocated(own_faces)) deallocate (own_faces)
        if (allocated(own_instances)) deallocate (own_instances)
        allocate (next_nodes(n), gaps(n), own_faces(n), own_instances(n))
        if (code == NURBS_OK) code = nurbs_meet_joints(this%handle, n, next_nodes, gaps, own_faces, own_instances)
        if (code == NURBS_OK) then
            next_nodes = next_nodes + 1
            own_faces = own_faces + 1
            own_instances = own_instances + 1
        end if
        call settle(code, status)
    end subroutine joints

    !> The faces of the second of two models on which the nodes are.
    subroutine joints_second(this, own_faces, own_instances, status)
        class(nurbs_meet), intent(in) :: this
        integer(c_int64_t), allocatable, intent(inout) :: own_faces(:), own_instances(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        n = 0
        code = nurbs_meet_joints_second(this%handle, 0_c_int64_t, count=n)
        if (allocated(own_faces)) deallocate (own_faces)
        if (allocated(own_instances)) deallocate (own_instances)
        allocate (own_faces(n), own_instances(n))
        if (code == NURBS_OK) code = nurbs_meet_joints_second(this%handle, n, own_faces, own_instances)
        if (code == NURBS_OK) then
            own_faces = own_faces + 1
            own_instances = own_instances + 1
        end if
        call settle(code, status)
    end subroutine joints_second

    !> Where planes cut the faces of a model, joined to ways over the edges that faces share.
    subroutine model_sections(this, model, normals, offsets, tolerance, status, call)
        class(nurbs_meet), intent(inout) :: this
        class(nurbs_model), intent(in) :: model
        real(c_double), intent(in) :: normals(:, :), offsets(:), tolerance
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        type(c_ptr) :: made
        n = size(normals, 1, c_int64_t)
        made = c_null_ptr
        code = fitting([fits(normals, n, 3_c_int64_t), fits(offsets, n)])
        if (code == NURBS_OK) then
            if (present(call)) then
                code = nurbs_model_sections_with(model%handle, n, transpose(normals), offsets, tolerance, &
                    watched(call), made)
            else
                code = nurbs_model_sections(model%handle, n, transpose(normals), offsets, tolerance, made)
            end if
        end if
        call this%replace(made)
        call settle(code, status)
    end subroutine model_sections

    !> Where the faces of two models meet, joined to ways over the edges that faces share.
    subroutine of_models(this, a, b, tolerance, status, call)
        class(nurbs_meet), intent(inout) :: this
        class(nurbs_model), intent(in) :: a, b
        real(c_double), intent(in) :: tolerance
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        if (present(call)) then
            code = nurbs_model_intersections_with(a%handle, b%handle, tolerance, watched(call), made)
        else
            code = nurbs_model_intersections(a%handle, b%handle, tolerance, made)
        end if
        call this%replace(made)
        call settle(code, status)
    end subroutine of_models

    !> What of the branches lies in a face of the surface that they are on.
    subroutine trimmed(this, meet, face, status, call)
        class(nurbs_meet), intent(inout) :: this
        class(nurbs_meet), intent(in) :: meet
        class(nurbs_face), intent(in) :: face
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        if (present(call)) then
            code = nurbs_meet_trim_with(meet%handle, face%handle, watched(call), made)
        else
            code = nurbs_meet_trim(meet%handle, face%handle, made)
        end if
        call this%replace(made)
        call settle(code, status)
    end subroutine trimmed

    !> What of the branches of two surfaces lies in a face of the second one.
    subroutine trimmed_second(this, meet, face, status, call)
        class(nurbs_meet), intent(inout) :: this
        class(nurbs_meet), intent(in) :: meet
        class(nurbs_face), intent(in) :: face
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        if (present(call)) then
            code = nurbs_meet_trim_second_with(meet%handle, face%handle, watched(call), made)
        else
            code = nurbs_meet_trim_second(meet%handle, face%handle, made)
        end if
        call this%replace(made)
        call settle(code, status)
    end subroutine trimmed_second
end module nurbs_meets
