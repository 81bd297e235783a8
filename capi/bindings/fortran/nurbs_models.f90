! SPDX-License-Identifier: MIT
! Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
!> Models: faces with the edges that they share, the vertices at which edges meet, and the parts to which they belong.
!> Conventions: see the module nurbs.
module nurbs_models
    use, intrinsic :: iso_c_binding
    use nurbs_constants
    use nurbs_c, only: nurbs_read_model, nurbs_read_model_file, nurbs_model_create, nurbs_model_sew, &
        nurbs_region_create, nurbs_region_combine, nurbs_face_split, nurbs_face_trim, nurbs_model_counts, &
        nurbs_model_face, nurbs_model_face_name, nurbs_model_face_solid, nurbs_model_face_layers, nurbs_model_edge, &
        nurbs_model_edge_uses, nurbs_model_edge_gaps, nurbs_model_vertex, nurbs_model_part, nurbs_model_use, &
        nurbs_model_instances, nurbs_model_rays, nurbs_model_ray_hits, nurbs_model_closest_points, &
        nurbs_model_classify, nurbs_model_area, nurbs_model_volume, nurbs_model_splines, nurbs_model_spline_layers, &
        nurbs_model_layer_count, nurbs_model_layer, nurbs_model_write_file, nurbs_model_from_bytes, &
        nurbs_read_model_with, nurbs_read_model_file_with, nurbs_model_sew_with, nurbs_region_create_with, &
        nurbs_region_combine_with, nurbs_face_split_with, nurbs_face_trim_with, nurbs_model_rays_with, &
        nurbs_model_ray_hits_with, nurbs_model_closest_points_with, nurbs_model_classify_with, nurbs_model_area_with, &
        nurbs_model_volume_with, nurbs_model_write_file_with, nurbs_read_options, nurbs_write_options
    use nurbs_support
    use nurbs_calls
    use nurbs_handles
    use nurbs_splines
    use nurbs_lists
    use nurbs_faces
    implicit none
    private

    !> Faces and the edges that they share, in parts; an assignment makes another handle on the same model.
    type, extends(nurbs_model_handle), public :: nurbs_model
    contains
        procedure :: read, read_file, create, sew, region, combine, split, trim, counts, face, face_name, face_solid
        procedure :: face_layers, edge, edge_uses, edge_gaps, vertex, part, get_use, instances, rays, ray_hits
        procedure :: closest_points, classify, get_area, get_volume, splines, spline_layers, layer_count, layer
        procedure :: write_file, from_bytes
    end type nurbs_model

contains

    !> Reads the faces, edges and vertices of a STEP or an IGES file from memory.
    subroutine read(this, contents, options, status, call)
        class(nurbs_model), intent(inout) :: this
        character(kind=c_char, len=*), intent(in), target :: contents
        type(nurbs_read_options), intent(in), optional :: options
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        integer(c_int64_t) :: size_c
        type(c_ptr) :: made
        size_c = len(contents, c_int64_t)
        if (present(call)) then
            code = nurbs_read_model_with(c_loc(contents), size_c, options, watched(call), made)
        else
            code = nurbs_read_model(c_loc(contents), size_c, options, made)
        end if
        call this%replace(made)
        call settle(code, status)
    end subroutine read

    !> Reads a STEP or an IGES file by its path.
    subroutine read_file(this, path, options, status, call)
        class(nurbs_model), intent(inout) :: this
        character(kind=c_char, len=*), intent(in) :: path
        type(nurbs_read_options), intent(in), optional :: options
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        if (present(call)) then
            code = nurbs_read_model_file_with(path//c_null_char, options, watched(call), made)
        else
            code = nurbs_read_model_file(path//c_null_char, options, made)
        end if
        call this%replace(made)
        call settle(code, status)
    end subroutine read_file

    !> A model of faces, with one part and one use of it. Faces with a common key share an edge.
    subroutine create(this, faces, metres, status)
        class(nurbs_model), intent(inout) :: this
        type(nurbs_face), intent(in) :: faces(:)
        real(c_double), intent(in), optional :: metres
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        code = nurbs_model_create(size(faces, kind=c_int64_t), handles_of(faces), given(metres, 0d0), made)
        call this%replace(made)
        call settle(code, status)
    end subroutine create

    !> A model of faces that do not know each other: pieces of their boundaries within the tolerance become common
    !> edges.
    subroutine sew(this, faces, tolerance, metres, status, call)
        class(nurbs_model), intent(inout) :: this
        type(nurbs_face), intent(in) :: faces(:)
        real(c_double), intent(in) :: tolerance
        real(c_double), intent(in), optional :: metres
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        integer(c_int64_t) :: count
        type(c_ptr) :: made
        count = size(faces, kind=c_int64_t)
        if (present(call)) then
            code = nurbs_model_sew_with(count, handles_of(faces), tolerance, given(metres, 0d0), watched(call), made)
        else
            code = nurbs_model_sew(count, handles_of(faces), tolerance, given(metres, 0d0), made)
        end if
        call this%replace(made)
        call settle(code, status)
    end subroutine sew

    !> The region that closed curves of the plane enclose, as faces without a common point inside: each curve begins
    !> where the one before it ends, or where that one closes a loop, a loop of its own. rule is one of the NURBS_FILL_
    !> constants.
    subroutine region(this, curves, rule, tolerance, status, call)
        class(nurbs_model), intent(inout) :: this
        type(nurbs_spline), intent(in) :: curves(:)
        integer(c_int32_t), intent(in), optional :: rule
        real(c_double), intent(in), optional :: tolerance
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        integer(c_int64_t) :: count
        type(c_ptr) :: made
        count = size(curves, kind=c_int64_t)
        if (present(call)) then
            code = nurbs_region_create_with(count, handles_of(curves), given(rule, NURBS_FILL_NON_ZERO), &
                given(tolerance, 0d0), watched(call), made)
        else
            code = nurbs_region_create(count, handles_of(curves), given(rule, NURBS_FILL_NON_ZERO), &
                given(tolerance, 0d0), made)
        end if
        call this%replace(made)
        call settle(code, status)
    end subroutine region

    !> The union, intersection or difference of two regions, each of which is what its faces cover. rule is one of the
    !> NURBS_REGION_ constants.
    subroutine combine(this, rule, a, b, tolerance, status, call)
        class(nurbs_model), intent(inout) :: this
        integer(c_int32_t), intent(in) :: rule
        type(nurbs_face), intent(in) :: a(:), b(:)
        real(c_double), intent(in), optional :: tolerance
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        integer(c_int64_t) :: count_a, count_b
        type(c_ptr) :: made
        count_a = size(a, kind=c_int64_t)
        count_b = size(b, kind=c_int64_t)
        if (present(call)) then
            code = nurbs_region_combine_with(rule, count_a, handles_of(a), count_b, handles_of(b), &
                given(tolerance, 0d0), watched(call), made)
        else
            code = nurbs_region_combine(rule, count_a, handles_of(a), count_b, handles_of(b), given(tolerance, 0d0), &
                made)
        end if
        call this%replace(made)
        call settle(code, status)
    end subroutine combine

    !> The parts of a face that curves in the domain of its surface divide it into; they share edges.
    subroutine split(this, face, curves, tolerance, status, call)
        class(nurbs_model), intent(inout) :: this
        class(nurbs_face), intent(in) :: face
        type(nurbs_spline), intent(in) :: curves(:)
        real(c_double), intent(in), optional :: tolerance
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        integer(c_int64_t) :: count
        type(c_ptr) :: made
        count = size(curves, kind=c_int64_t)
        if (present(call)) then
            code = nurbs_face_split_with(face%handle, count, handles_of(curves), given(tolerance, 0d0), watched(call), &
                made)
        else
            code = nurbs_face_split(face%handle, count, handles_of(curves), given(tolerance, 0d0), made)
        end if
        call this%replace(made)
        call settle(code, status)
    end subroutine split

    !> What of a face lies on one side of a surface, which divides it where both meet. side is one of the NURBS_TRIM_
    !> constants.
    subroutine trim(this, face, surface, side, tolerance, status, call)
        class(nurbs_model), intent(inout) :: this
        class(nurbs_face), intent(in) :: face
        class(nurbs_spline), intent(in) :: surface
        integer(c_int32_t), intent(in) :: side
        real(c_double), intent(in) :: tolerance
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        if (present(call)) then
            code = nurbs_face_trim_with(face%handle, surface%handle, side, tolerance, watched(call), made)
        else
            code = nurbs_face_trim(face%handle, surface%handle, side, tolerance, made)
        end if
        call this%replace(made)
        call settle(code, status)
    end subroutine trim

    !> How much it holds.
    subroutine counts(this, parts, uses, faces, edges, vertices, status)
        class(nurbs_model), intent(in) :: this
        integer(c_int64_t), intent(inout), optional :: parts, uses, faces, edges, vertices
        integer(c_int32_t), intent(out), optional :: status
        call settle(nurbs_model_counts(this%handle, parts, uses, faces, edges, vertices), status)
    end subroutine counts

    !> A face.
    subroutine face(this, index, out, part, shape, against, colour, status)
        class(nurbs_model), intent(in) :: this
        integer(c_int32_t), intent(in) :: index
        type(nurbs_face), intent(inout) :: out
        integer(c_int64_t), intent(inout), optional :: part
        integer(c_int32_t), intent(inout), optional :: shape
        logical, intent(inout), optional :: against
        real(c_double), intent(inout), optional :: colour(3)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code, answer
        type(c_ptr) :: made
        answer = 0
        code = nurbs_model_face(this%handle, index - 1_c_int64_t, part, shape, answer, colour, made)
        if (present(against)) against = answer /= 0
        if (code == NURBS_OK) then
            if (present(part)) part = part + 1
        end if
        call out%replace(made)
        call settle(code, status)
    end subroutine face

    !> The name of a face.
    subroutine face_name(this, index, text, status)
        class(nurbs_model), intent(in) :: this
        integer(c_int32_t), intent(in) :: index
        character(len=:), allocatable, intent(out) :: text
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: length
        character(kind=c_char), allocatable :: buffer(:)
        length = 0
        code = nurbs_model_face_name(this%handle, index - 1_c_int64_t, cap=0_c_int64_t, length=length)
        allocate (buffer(length + 1))
        if (code == NURBS_OK) code = nurbs_model_face_name(this%handle, index - 1_c_int64_t, buffer, length + 1)
        text = string(buffer(:length))
        call settle(code, status)
    end subroutine face_name

    !> The solid that a face bounds, -1 for none, and whether the face belongs to a void of it.
    subroutine face_solid(this, index, solid, in_void, status)
        class(nurbs_model), intent(in) :: this
        integer(c_int32_t), intent(in) :: index
        integer(c_int64_t), intent(inout), optional :: solid
        integer(c_int32_t), intent(inout), optional :: in_void
        integer(c_int32_t), intent(out), optional :: status
        call settle(nurbs_model_face_solid(this%handle, index - 1_c_int64_t, solid, in_void), status)
    end subroutine face_solid

    !> The layers that a face is in.
    subroutine face_layers(this, index, layers, status)
        class(nurbs_model), intent(in) :: this
        integer(c_int32_t), intent(in) :: index
        integer(c_int64_t), allocatable, intent(inout) :: layers(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        n = 0
        code = nurbs_model_face_layers(this%handle, index - 1_c_int64_t, 0_c_int64_t, count=n)
        if (allocated(layers)) deallocate (layers)
        allocate (layers(n))
        if (code == NURBS_OK) code = nurbs_model_face_layers(this%handle, index - 1_c_int64_t, n, layers)
        call settle(code, status)
    end subroutine face_layers

    !> An edge.
    subroutine edge(this, index, out, part, end_vertices, shape, status)
        class(nurbs_model), intent(in) :: this
        integer(c_int32_t), intent(in) :: index
        type(nurbs_spline), intent(inout) :: out
        integer(c_int64_t), intent(inout), optional :: part, end_vertices(2)
        integer(c_int32_t), intent(inout), optional :: shape
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        code = nurbs_model_edge(this%handle, index - 1_c_int64_t, part, end_vertices, shape, made)
        if (code == NURBS_OK) then
            if (present(part)) part = part + 1
            if (present(end_vertices)) end_vertices = end_vertices + 1
        end if
        call out%replace(made)
        call settle(code, status)
    end subroutine edge

    !> Where faces use an edge: face, loop, and place in the loop; once at a free boundary, twice inside a shell.
    subroutine edge_uses(this, index, places, status)
        class(nurbs_model), intent(in) :: this
        integer(c_int32_t), intent(in) :: index
        integer(c_int64_t), allocatable, intent(inout) :: places(:, :)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        integer(c_int64_t), allocatable :: places_c(:, :)
        n = 0
        code = nurbs_model_edge_uses(this%handle, index - 1_c_int64_t, 0_c_int64_t, count=n)
        allocate (places_c(3, n))
        if (code == NURBS_OK) code = nurbs_model_edge_uses(this%handle, index - 1_c_int64_t, n, places_c)
        if (code == NURBS_OK) places = transpose(places_c) + 1
        call settle(code, status)
    end subroutine edge_uses

    !> How well faces meet at its edges: the number of uses of each, and how far the curves of faces are from it.
    subroutine edge_gaps(this, uses, gaps, bounded, status)
        class(nurbs_model), intent(in) :: this
        integer(c_int64_t), allocatable, intent(inout) :: uses(:)
        real(c_double), allocatable, intent(inout) :: gaps(:)
        integer(c_int32_t), allocatable, intent(inout) :: bounded(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        n = 0
        code = nurbs_model_edge_gaps(this%handle, 0_c_int64_t, count=n)
        if (allocated(uses)) deallocate (uses)
        if (allocated(gaps)) deallocate (gaps)
        if (allocated(bounded)) deallocate (bounded)
        allocate (uses(n), gaps(n), bounded(n))
        if (code == NURBS_OK) code = nurbs_model_edge_gaps(this%handle, n, uses, gaps, bounded)
        call settle(code, status)
    end subroutine edge_gaps

    !> The point of a vertex.
    subroutine vertex(this, index, point, status)
        class(nurbs_model), intent(in) :: this
        integer(c_int32_t), intent(in) :: index
        real(c_double), intent(inout) :: point(3)
        integer(c_int32_t), intent(out), optional :: status
        call settle(nurbs_model_vertex(this%handle, index - 1_c_int64_t, point), status)
    end subroutine vertex

    !> The name of a part.
    subroutine part(this, index, text, status)
        class(nurbs_model), intent(in) :: this
        integer(c_int32_t), intent(in) :: index
        character(len=:), allocatable, intent(out) :: text
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: length
        character(kind=c_char), allocatable :: buffer(:)
        length = 0
        code = nurbs_model_part(this%handle, index - 1_c_int64_t, cap=0_c_int64_t, length=length)
        allocate (buffer(length + 1))
        if (code == NURBS_OK) code = nurbs_model_part(this%handle, index - 1_c_int64_t, buffer, length + 1)
        text = string(buffer(:length))
        call settle(code, status)
    end subroutine part

    !> A use of a part: where it is placed.
    subroutine get_use(this, index, parent, part, placement, status)
        class(nurbs_model), intent(in) :: this
        integer(c_int32_t), intent(in) :: index
        integer(c_int64_t), intent(inout), optional :: parent, part
        real(c_double), intent(inout), optional :: placement(3, 4)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        real(c_double) :: placement_c(4, 3)
        code = nurbs_model_use(this%handle, index - 1_c_int64_t, parent, part, placement_c)
        if (code == NURBS_OK) then
            if (present(parent)) parent = parent + 1
            if (present(part)) part = part + 1
            if (present(placement)) placement = transpose(placement_c)
        end if
        call settle(code, status)
    end subroutine get_use

    !> Where the parts stand in the whole: each way through uses of parts in parts.
    subroutine instances(this, parents, uses, parts, placements, status)
        class(nurbs_model), intent(in) :: this
        integer(c_int64_t), allocatable, intent(inout) :: parents(:), uses(:), parts(:)
        real(c_double), allocatable, intent(inout) :: placements(:, :)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        real(c_double), allocatable :: placements_c(:, :)
        n = 0
        code = nurbs_model_instances(this%handle, 0_c_int64_t, count=n)
        if (allocated(parents)) deallocate (parents)
        if (allocated(uses)) deallocate (uses)
        if (allocated(parts)) deallocate (parts)
        allocate (parents(n), uses(n), parts(n), placements_c(12, n))
        if (code == NURBS_OK) code = nurbs_model_instances(this%handle, n, parents, uses, parts, placements_c)
        placements = transpose(placements_c)
        if (code == NURBS_OK) then
            parents = parents + 1
            uses = uses + 1
            parts = parts + 1
        end if
        call settle(code, status)
    end subroutine instances

    !> Where rays meet its faces first, with proof.
    subroutine rays(this, origins, directions, params, distances, states, places, status, call)
        class(nurbs_model), intent(in) :: this
        real(c_double), intent(in) :: origins(:, :), directions(:, :)
        real(c_double), intent(inout), optional :: params(:, :), distances(:)
        integer(c_int32_t), intent(inout), optional :: states(:)
        integer(c_int64_t), intent(inout), optional :: places(:, :)
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        real(c_double), allocatable :: params_c(:, :)
        integer(c_int64_t), allocatable :: places_c(:, :)
        n = size(origins, 1, c_int64_t)
        allocate (params_c(2, n), places_c(2, n))
        code = held(this%handle)
        if (code == NURBS_OK) code = fitting([fits(origins, n, 3_c_int64_t), fits(directions, n, 3_c_int64_t), &
            fits(params, n, 2_c_int64_t), fits(distances, n), fits(states, n), fits(places, n, 2_c_int64_t)])
        if (code == NURBS_OK) then
            if (present(call)) then
                code = nurbs_model_rays_with(this%handle, n, transpose(origins), transpose(directions), params_c, &
                    distances, states, places_c, watched(call))
            else
                code = nurbs_model_rays(this%handle, n, transpose(origins), transpose(directions), params_c, &
                    distances, states, places_c)
            end if
        end if
        if (code == NURBS_OK) then
            if (present(params)) params = transpose(params_c)
            if (present(places)) places = transpose(places_c) + 1
        end if
        call settle(code, status)
    end subroutine rays

    !> All places where a ray meets its faces, by rising t.
    subroutine ray_hits(this, origin, direction, params, distances, kinds, places, complete, range, status, call)
        class(nurbs_model), intent(in) :: this
        real(c_double), intent(in) :: origin(:), direction(3)
        real(c_double), allocatable, intent(inout) :: params(:, :), distances(:)
        integer(c_int32_t), allocatable, intent(inout) :: kinds(:)
        integer(c_int64_t), allocatable, intent(inout) :: places(:, :)
        logical, intent(inout), optional :: complete
        real(c_double), intent(in), optional :: range(2)
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code, answer
        integer(c_int64_t) :: n
        real(c_double), allocatable :: params_c(:, :)
        integer(c_int64_t), allocatable :: places_c(:, :)
        n = 0
        answer = 0
        code = held(this%handle)
        if (code == NURBS_OK) code = fitting([fits(origin, 3_c_int64_t)])
        if (code == NURBS_OK) then
            if (present(call)) then
                code = nurbs_model_ray_hits_with(this%handle, origin, direction, range, 0_c_int64_t, count=n, &
                    call=watched(call))
            else
                code = nurbs_model_ray_hits(this%handle, origin, direction, range, 0_c_int64_t, count=n)
            end if
        end if
        if (allocated(distances)) deallocate (distances)
        if (allocated(kinds)) deallocate (kinds)
        allocate (params_c(2, n), distances(n), kinds(n), places_c(2, n))
        if (code == NURBS_OK) then
            if (present(call)) then
                code = nurbs_model_ray_hits_with(this%handle, origin, direction, range, n, params_c, distances, kinds, &
                    places_c, complete=answer, call=watched(call))
            else
                code = nurbs_model_ray_hits(this%handle, origin, direction, range, n, params_c, distances, kinds, &
                    places_c, complete=answer)
            end if
        end if
        params = transpose(params_c)
        if (present(complete)) complete = answer /= 0
        if (code == NURBS_OK) places = transpose(places_c) + 1
        call settle(code, status)
    end subroutine ray_hits

    !> The points of its faces that are nearest to given points, with proof.
    subroutine closest_points(this, points, params, feet, distances, states, places, tolerance, status, call)
        class(nurbs_model), intent(in) :: this
        real(c_double), intent(in) :: points(:, :)
        real(c_double), intent(inout), optional :: params(:, :), feet(:, :), distances(:)
        integer(c_int32_t), intent(inout), optional :: states(:)
        integer(c_int64_t), intent(inout), optional :: places(:, :)
        real(c_double), intent(in), optional :: tolerance
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        real(c_double), allocatable :: params_c(:, :), feet_c(:, :)
        integer(c_int64_t), allocatable :: places_c(:, :)
        n = size(points, 1, c_int64_t)
        allocate (params_c(2, n), feet_c(3, n), places_c(2, n))
        code = held(this%handle)
        if (code == NURBS_OK) code = fitting([fits(points, n, 3_c_int64_t), fits(params, n, 2_c_int64_t), &
            fits(feet, n, 3_c_int64_t), fits(distances, n), fits(states, n), fits(places, n, 2_c_int64_t)])
        if (code == NURBS_OK) then
            if (present(call)) then
                code = nurbs_model_closest_points_with(this%handle, n, points, step(points), column(points), &
                    given(tolerance, 0d0), params_c, feet_c, distances, states, places_c, watched(call))
            else
                code = nurbs_model_closest_points(this%handle, n, points, step(points), column(points), &
                    given(tolerance, 0d0), params_c, feet_c, distances, states, places_c)
            end if
        end if
        if (code == NURBS_OK) then
            if (present(params)) params = transpose(params_c)
            if (present(feet)) feet = transpose(feet_c)
            if (present(places)) places = transpose(places_c) + 1
        end if
        call settle(code, status)
    end subroutine closest_points

    !> Whether points are inside its solids: a NURBS_SIDE_ constant each.
    subroutine classify(this, points, sides, tolerance, status, call)
        class(nurbs_model), intent(in) :: this
        real(c_double), intent(in) :: points(:, :)
        integer(c_int32_t), intent(inout) :: sides(:)
        real(c_double), intent(in), optional :: tolerance
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        n = size(points, 1, c_int64_t)
        code = held(this%handle)
        if (code == NURBS_OK) code = fitting([fits(points, n, 3_c_int64_t), fits(sides, n)])
        if (code == NURBS_OK) then
            if (present(call)) then
                code = nurbs_model_classify_with(this%handle, n, points, step(points), column(points), &
                    given(tolerance, 0d0), sides, watched(call))
            else
                code = nurbs_model_classify(this%handle, n, points, step(points), column(points), &
                    given(tolerance, 0d0), sides)
            end if
        end if
        call settle(code, status)
    end subroutine classify

    !> The area of all its faces where they stand.
    subroutine get_area(this, area, error, tolerance, status, call)
        class(nurbs_model), intent(in) :: this
        real(c_double), intent(inout) :: area
        real(c_double), intent(inout), optional :: error
        real(c_double), intent(in), optional :: tolerance
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        if (present(call)) then
            code = nurbs_model_area_with(this%handle, given(tolerance, 0d0), area, error, watched(call))
        else
            code = nurbs_model_area(this%handle, given(tolerance, 0d0), area, error)
        end if
        call settle(code, status)
    end subroutine get_area

    !> The volume that its solids hold where they stand, with centroid and inertia.
    subroutine get_volume(this, volume, centroid, inertia, openness, error, tolerance, status, call)
        class(nurbs_model), intent(in) :: this
        real(c_double), intent(inout) :: volume
        real(c_double), intent(inout), optional :: centroid(3), inertia(3, 3), openness, error
        real(c_double), intent(in), optional :: tolerance
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        if (present(call)) then
            code = nurbs_model_volume_with(this%handle, given(tolerance, 0d0), volume, centroid, inertia, openness, &
                error, watched(call))
        else
            code = nurbs_model_volume(this%handle, given(tolerance, 0d0), volume, centroid, inertia, openness, error)
        end if
        call settle(code, status)
    end subroutine get_volume

    !> The curves and surfaces of a file that no face or edge consists of, with its unit and the notes on what was not
    !> read.
    subroutine splines(this, out, status)
        class(nurbs_model), intent(in) :: this
        type(nurbs_list), intent(inout) :: out
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        code = nurbs_model_splines(this%handle, made)
        call out%replace(made)
        call settle(code, status)
    end subroutine splines

    !> The layers that a curve or a surface is in which no face or edge consists of.
    subroutine spline_layers(this, index, layers, status)
        class(nurbs_model), intent(in) :: this
        integer(c_int32_t), intent(in) :: index
        integer(c_int64_t), allocatable, intent(inout) :: layers(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        n = 0
        code = nurbs_model_spline_layers(this%handle, index - 1_c_int64_t, 0_c_int64_t, count=n)
        if (allocated(layers)) deallocate (layers)
        allocate (layers(n))
        if (code == NURBS_OK) code = nurbs_model_spline_layers(this%handle, index - 1_c_int64_t, n, layers)
        call settle(code, status)
    end subroutine spline_layers

    !> How many layers faces and splines are in.
    integer(c_int64_t) function layer_count(this, status) result(value)
        class(nurbs_model), intent(in) :: this
        integer(c_int32_t), intent(out), optional :: status
        value = 0
        call settle(nurbs_model_layer_count(this%handle, value), status)
    end function layer_count

    !> The name of a layer.
    subroutine layer(this, index, text, status)
        class(nurbs_model), intent(in) :: this
        integer(c_int32_t), intent(in) :: index
        character(len=:), allocatable, intent(out) :: text
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: length
        character(kind=c_char), allocatable :: buffer(:)
        length = 0
        code = nurbs_model_layer(this%handle, index - 1_c_int64_t, cap=0_c_int64_t, length=length)
        allocate (buffer(length + 1))
        if (code == NURBS_OK) code = nurbs_model_layer(this%handle, index - 1_c_int64_t, buffer, length + 1)
        text = string(buffer(:length))
        call settle(code, status)
    end subroutine layer

    !> Writes it to a file, which is replaced whole or not at all.
    subroutine write_file(this, path, format, options, status, call)
        class(nurbs_model), intent(in) :: this
        character(kind=c_char, len=*), intent(in) :: path
        integer(c_int32_t), intent(in) :: format
        type(nurbs_write_options), intent(in), optional :: options
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        if (present(call)) then
            code = nurbs_model_write_file_with(this%handle, path//c_null_char, format, options, watched(call))
        else
            code = nurbs_model_write_file(this%handle, path//c_null_char, format, options)
        end if
        call settle(code, status)
    end subroutine write_file

    !> The model of what to_bytes() made of it.
    subroutine from_bytes(this, contents, status)
        class(nurbs_model), intent(inout) :: this
        character(kind=c_char, len=*), intent(in), target :: contents
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        code = nurbs_model_from_bytes(c_loc(contents), len(contents, c_int64_t), made)
        call this%replace(made)
        call settle(code, status)
    end subroutine from_bytes
end module nurbs_models
