! SPDX-License-Identifier: MIT
! Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
!> Shapes made of what is straight and flat, within a proven distance. Conventions: see the module nurbs.
module nurbs_meshes
    use, intrinsic :: iso_c_binding
    use nurbs_constants
    use nurbs_c, only: nurbs_mesh_curve, nurbs_mesh_surface, nurbs_mesh_face, nurbs_mesh_model, nurbs_mesh_volume, &
        nurbs_mesh_counts, nurbs_mesh_bound, nurbs_mesh_points, nurbs_mesh_points_f32, nurbs_mesh_vertices, &
        nurbs_mesh_vertices_f32, nurbs_mesh_triangles, nurbs_mesh_triangles_i32, nurbs_mesh_quads, nurbs_mesh_faces, &
        nurbs_mesh_edges, nurbs_mesh_edge_points, nurbs_mesh_write_file, nurbs_mesh_hexahedra, nurbs_bezier_cells, &
        nurbs_bezier_cell_points, nurbs_mesh_curve_with, nurbs_mesh_surface_with, nurbs_mesh_face_with, &
        nurbs_mesh_model_with, nurbs_mesh_volume_with, nurbs_mesh_write_file_with, nurbs_mesh_options, &
        nurbs_write_options
    use nurbs_support
    use nurbs_calls
    use nurbs_handles
    use nurbs_splines
    use nurbs_faces
    use nurbs_models
    implicit none
    private
    public :: mesh_curve, bezier_cells, bezier_cell_points

    !> Triangles in place of shapes; an assignment makes another handle on the same triangles.
    type, extends(nurbs_mesh_handle), public :: nurbs_mesh
    contains
        procedure :: of_surface, of_face, of_model, of_volume, counts, bound, points, points_f32, vertices, vertices_f32
        procedure :: triangles, triangles_i32, quads, faces, edges, edge_points, write_file, hexahedra
    end type nurbs_mesh

contains

    !> params(n) and points(n, dim) of a polyline in place of a curve, within chord of it as proven; angle between
    !> tangents in a segment and length of segments are no larger than these, if present.
    subroutine mesh_curve(g, chord, params, points, bound, reached, angle, longest, status, call)
        class(nurbs_spline), intent(in) :: g
        real(c_double), intent(in) :: chord
        real(c_double), allocatable, intent(inout) :: params(:), points(:, :)
        real(c_double), intent(inout), optional :: bound
        logical, intent(inout), optional :: reached
        real(c_double), intent(in), optional :: angle, longest
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code, answer
        integer(c_int64_t) :: n
        real(c_double), allocatable :: points_c(:, :)
        n = 0
        answer = 0
        if (present(call)) then
            code = nurbs_mesh_curve_with(g%handle, chord, given(angle, 0d0), given(longest, 0d0), 0_c_int64_t, &
                count=n, call=watched(call))
        else
            code = nurbs_mesh_curve(g%handle, chord, given(angle, 0d0), given(longest, 0d0), 0_c_int64_t, count=n)
        end if
        if (allocated(params)) deallocate (params)
        allocate (params(n), points_c(dim_of(g%handle), n))
        if (code == NURBS_OK) then
            if (present(call)) then
                code = nurbs_mesh_curve_with(g%handle, chord, given(angle, 0d0), given(longest, 0d0), n, params, &
                    points_c, bound, answer, call=watched(call))
            else
                code = nurbs_mesh_curve(g%handle, chord, given(angle, 0d0), given(longest, 0d0), n, params, points_c, &
                    bound, answer)
            end if
        end if
        points = transpose(points_c)
        if (present(reached)) reached = answer /= 0
        call settle(code, status)
    end subroutine mesh_curve

    !> Triangles in place of a whole surface, within a proven distance, both ways.
    subroutine of_surface(this, g, options, status, call)
        class(nurbs_mesh), intent(inout) :: this
        class(nurbs_spline), intent(in) :: g
        type(nurbs_mesh_options), intent(in), optional :: options
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        if (present(call)) then
            code = nurbs_mesh_surface_with(g%handle, options, watched(call), made)
        else
            code = nurbs_mesh_surface(g%handle, options, made)
        end if
        call this%replace(made)
        call settle(code, status)
    end subroutine of_surface

    !> Triangles in place of a trimmed face, within a proven distance, both ways.
    subroutine of_face(this, face, options, status, call)
        class(nurbs_mesh), intent(inout) :: this
        class(nurbs_face), intent(in) :: face
        type(nurbs_mesh_options), intent(in), optional :: options
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        if (present(call)) then
            code = nurbs_mesh_face_with(face%handle, options, watched(call), made)
        else
            code = nurbs_mesh_face(face%handle, options, made)
        end if
        call this%replace(made)
        call settle(code, status)
    end subroutine of_face

    !> Triangles in place of all faces of a model, with common points along common edges.
    subroutine of_model(this, model, options, status, call)
        class(nurbs_mesh), intent(inout) :: this
        class(nurbs_model), intent(in) :: model
        type(nurbs_mesh_options), intent(in), optional :: options
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        if (present(call)) then
            code = nurbs_mesh_model_with(model%handle, options, watched(call), made)
        else
            code = nurbs_mesh_model(model%handle, options, made)
        end if
        call this%replace(made)
        call settle(code, status)
    end subroutine of_model

    !> Hexahedra in place of a volume, within a proven distance, on a grid of lines along its axes; at most so many, if
    !> limit is present.
    subroutine of_volume(this, g, options, limit, status, call)
        class(nurbs_mesh), intent(inout) :: this
        class(nurbs_spline), intent(in) :: g
        type(nurbs_mesh_options), intent(in), optional :: options
        integer(c_int32_t), intent(in), optional :: limit
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        if (present(call)) then
            code = nurbs_mesh_volume_with(g%handle, options, int(given(limit, 0), c_int64_t), watched(call), made)
        else
            code = nurbs_mesh_volume(g%handle, options, int(given(limit, 0), c_int64_t), made)
        end if
        call this%replace(made)
        call settle(code, status)
    end subroutine of_volume

    !> How much it holds.
    subroutine counts(this, points, vertices, triangles, faces, edges, edge_points, status)
        class(nurbs_mesh), intent(in) :: this
        integer(c_int64_t), intent(inout), optional :: points, vertices, triangles, faces, edges, edge_points
        integer(c_int32_t), intent(out), optional :: status
        call settle(nurbs_mesh_counts(this%handle, points, vertices, triangles, faces, edges, edge_points), status)
    end subroutine counts

    !> How far the mesh and its shape are from each other, as proven.
    subroutine bound(this, from_shape, from_mesh, reached, status)
        class(nurbs_mesh), intent(in) :: this
        real(c_double), intent(inout), optional :: from_shape, from_mesh
        logical, intent(inout), optional :: reached
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: answer
        answer = 0
        call settle(nurbs_mesh_bound(this%handle, from_shape, from_mesh, answer), status)
        if (present(reached)) reached = answer /= 0
    end subroutine bound

    !> points(n, 3) in space.
    subroutine points(this, values, status)
        class(nurbs_mesh), intent(in) :: this
        real(c_double), allocatable, intent(inout) :: values(:, :)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        real(c_double), allocatable :: values_c(:, :)
        n = 0
        code = nurbs_mesh_points(this%handle, 0_c_int64_t, count=n)
        allocate (values_c(3, n))
        if (code == NURBS_OK) code = nurbs_mesh_points(this%handle, n, values_c)
        values = transpose(values_c)
        call settle(code, status)
    end subroutine points

    !> points(n, 3) in single precision.
    subroutine points_f32(this, values, status)
        class(nurbs_mesh), intent(in) :: this
        real(c_float), allocatable, intent(inout) :: values(:, :)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        real(c_float), allocatable :: values_c(:, :)
        n = 0
        code = nurbs_mesh_points_f32(this%handle, 0_c_int64_t, count=n)
        allocate (values_c(3, n))
        if (code == NURBS_OK) code = nurbs_mesh_points_f32(this%handle, n, values_c)
        values = transpose(values_c)
        call settle(code, status)
    end subroutine points_f32

    !> Of each vertex the point at which it is, params(n, 2) of the surface of its face, and normals(n, 3), NaN where
    !> there is none.
    subroutine vertices(this, own_points, params, normals, status)
        class(nurbs_mesh), intent(in) :: this
        integer(c_int64_t), allocatable, intent(inout) :: own_points(:)
        real(c_double), allocatable, intent(inout) :: params(:, :), normals(:, :)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        real(c_double), allocatable :: params_c(:, :), normals_c(:, :)
        n = 0
        code = nurbs_mesh_vertices(this%handle, 0_c_int64_t, count=n)
        if (allocated(own_points)) deallocate (own_points)
        allocate (own_points(n), params_c(2, n), normals_c(3, n))
        if (code == NURBS_OK) code = nurbs_mesh_vertices(this%handle, n, own_points, params_c, normals_c)
        params = transpose(params_c)
        normals = transpose(normals_c)
        if (code == NURBS_OK) own_points = own_points + 1
        call settle(code, status)
    end subroutine vertices

    !> points(n, 3), params(n, 2) and normals(n, 3) of the vertices, in single precision.
    subroutine vertices_f32(this, points, params, normals, status)
        class(nurbs_mesh), intent(in) :: this
        real(c_float), allocatable, intent(inout) :: points(:, :), params(:, :), normals(:, :)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        real(c_float), allocatable :: points_c(:, :), params_c(:, :), normals_c(:, :)
        n = 0
        code = nurbs_mesh_vertices_f32(this%handle, 0_c_int64_t, count=n)
        allocate (points_c(3, n), params_c(2, n), normals_c(3, n))
        if (code == NURBS_OK) code = nurbs_mesh_vertices_f32(this%handle, n, points_c, params_c, normals_c)
        points = transpose(points_c)
        params = transpose(params_c)
        normals = transpose(normals_c)
        call settle(code, status)
    end subroutine vertices_f32

    !> corners(n, 3) of the triangles: vertices, or with NURBS_MESH_WELDED points.
    subroutine triangles(this, corners, flags, status)
        class(nurbs_mesh), intent(in) :: this
        integer(c_int64_t), allocatable, intent(inout) :: corners(:, :)
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        integer(c_int64_t), allocatable :: corners_c(:, :)
        n = 0
        code = nurbs_mesh_triangles(this%handle, given(flags, 0), 0_c_int64_t, count=n)
        allocate (corners_c(3, n))
        if (code == NURBS_OK) code = nurbs_mesh_triangles(this%handle, given(flags, 0), n, corners_c)
        if (code == NURBS_OK) corners = transpose(corners_c) + 1
        call settle(code, status)
    end subroutine triangles

    !> corners(n, 3) of the triangles in 32 bits: vertices, or with NURBS_MESH_WELDED points.
    subroutine triangles_i32(this, corners, flags, status)
        class(nurbs_mesh), intent(in) :: this
        integer(c_int32_t), allocatable, intent(inout) :: corners(:, :)
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        integer(c_int32_t), allocatable :: corners_c(:, :)
        n = 0
        code = nurbs_mesh_triangles_i32(this%handle, given(flags, 0), 0_c_int64_t, count=n)
        allocate (corners_c(3, n))
        if (code == NURBS_OK) code = nurbs_mesh_triangles_i32(this%handle, given(flags, 0), n, corners_c)
        if (code == NURBS_OK) corners = transpose(corners_c) + 1
        call settle(code, status)
    end subroutine triangles_i32

    !> corners(n, 4) of pairs of triangles that are all of a cell: vertices, or with NURBS_MESH_WELDED points; and the
    !> first of the two triangles of each.
    subroutine quads(this, corners, own_triangles, flags, status)
        class(nurbs_mesh), intent(in) :: this
        integer(c_int64_t), allocatable, intent(inout) :: corners(:, :), own_triangles(:)
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        integer(c_int64_t), allocatable :: corners_c(:, :)
        n = 0
        code = nurbs_mesh_quads(this%handle, given(flags, 0), 0_c_int64_t, count=n)
        if (allocated(own_triangles)) deallocate (own_triangles)
        allocate (corners_c(4, n), own_triangles(n))
        if (code == NURBS_OK) code = nurbs_mesh_quads(this%handle, given(flags, 0), n, corners_c, own_triangles)
        if (code == NURBS_OK) then
            corners = transpose(corners_c) + 1
            own_triangles = own_triangles + 1
        end if
        call settle(code, status)
    end subroutine quads

    !> What of it stands for which face, and how far that is from the face.
    subroutine faces(this, first_vertices, vertex_counts, first_triangles, triangle_counts, from_shape, from_mesh, &
            reaches, status)
        class(nurbs_mesh), intent(in) :: this
        integer(c_int64_t), allocatable, intent(inout) :: first_vertices(:), vertex_counts(:), first_triangles(:)
        integer(c_int64_t), allocatable, intent(inout) :: triangle_counts(:)
        real(c_double), allocatable, intent(inout) :: from_shape(:), from_mesh(:)
        integer(c_int32_t), allocatable, intent(inout) :: reaches(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        n = 0
        code = nurbs_mesh_faces(this%handle, 0_c_int64_t, count=n)
        if (allocated(first_vertices)) deallocate (first_vertices)
        if (allocated(vertex_counts)) deallocate (vertex_counts)
        if (allocated(first_triangles)) deallocate (first_triangles)
        if (allocated(triangle_counts)) deallocate (triangle_counts)
        if (allocated(from_shape)) deallocate (from_shape)
        if (allocated(from_mesh)) deallocate (from_mesh)
        if (allocated(reaches)) deallocate (reaches)
        allocate (first_vertices(n), vertex_counts(n), first_triangles(n), triangle_counts(n), from_shape(n), &
            from_mesh(n), reaches(n))
        if (code == NURBS_OK) code = nurbs_mesh_faces(this%handle, n, first_vertices, vertex_counts, first_triangles, &
            triangle_counts, from_shape, from_mesh, reaches)
        if (code == NURBS_OK) then
            first_vertices = first_vertices + 1
            first_triangles = first_triangles + 1
        end if
        call settle(code, status)
    end subroutine faces

    !> Of each polyline the edge of the model, 0 for one that belongs to one face only, its first vertex among those of
    !> all, the number of vertices, a proven bound of the distance, and whether all that was asked for is proven.
    subroutine edges(this, own_edges, firsts, sizes, bounds, reaches, status)
        class(nurbs_mesh), intent(in) :: this
        integer(c_int64_t), allocatable, intent(inout) :: own_edges(:), firsts(:), sizes(:)
        real(c_double), allocatable, intent(inout) :: bounds(:)
        integer(c_int32_t), allocatable, intent(inout) :: reaches(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        n = 0
        code = nurbs_mesh_edges(this%handle, 0_c_int64_t, count=n)
        if (allocated(own_edges)) deallocate (own_edges)
        if (allocated(firsts)) deallocate (firsts)
        if (allocated(sizes)) deallocate (sizes)
        if (allocated(bounds)) deallocate (bounds)
        if (allocated(reaches)) deallocate (reaches)
        allocate (own_edges(n), firsts(n), sizes(n), bounds(n), reaches(n))
        if (code == NURBS_OK) code = nurbs_mesh_edges(this%handle, n, own_edges, firsts, sizes, bounds, reaches)
        if (code == NURBS_OK) then
            own_edges = own_edges + 1
            firsts = firsts + 1
        end if
        call settle(code, status)
    end subroutine edges

    !> The points of the mesh that polylines of edges have, one polyline after the other.
    subroutine edge_points(this, own_points, status)
        class(nurbs_mesh), intent(in) :: this
        integer(c_int64_t), allocatable, intent(inout) :: own_points(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        n = 0
        code = nurbs_mesh_edge_points(this%handle, 0_c_int64_t, count=n)
        if (allocated(own_points)) deallocate (own_points)
        allocate (own_points(n))
        if (code == NURBS_OK) code = nurbs_mesh_edge_points(this%handle, n, own_points)
        if (code == NURBS_OK) own_points = own_points + 1
        call settle(code, status)
    end subroutine edge_points

    !> Writes it to a file, which is replaced whole or not at all.
    subroutine write_file(this, path, format, options, status, call)
        class(nurbs_mesh), intent(in) :: this
        character(kind=c_char, len=*), intent(in) :: path
        integer(c_int32_t), intent(in) :: format
        type(nurbs_write_options), intent(in), optional :: options
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        if (present(call)) then
            code = nurbs_mesh_write_file_with(this%handle, path//c_null_char, format, options, watched(call))
        else
            code = nurbs_mesh_write_file(this%handle, path//c_null_char, format, options)
        end if
        call settle(code, status)
    end subroutine write_file

    !> Of each hexahedron corners(8), points in the order of VTK_HEXAHEDRON, domains(2, 3), its ends along each axis of
    !> the volume, whether that folds there, and the sign of its Jacobian there, if it is proven to be one, else 0.
    subroutine hexahedra(this, corners, domains, folds, signs, status)
        class(nurbs_mesh), intent(in) :: this
        integer(c_int64_t), allocatable, intent(inout) :: corners(:, :)
        real(c_double), allocatable, intent(inout) :: domains(:, :, :)
        integer(c_int32_t), allocatable, intent(inout) :: folds(:), signs(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        integer(c_int64_t), allocatable :: corners_c(:, :)
        n = 0
        code = nurbs_mesh_hexahedra(this%handle, 0_c_int64_t, count=n)
        if (allocated(domains)) deallocate (domains)
        if (allocated(folds)) deallocate (folds)
        if (allocated(signs)) deallocate (signs)
        allocate (corners_c(8, n), domains(2, 3, n), folds(n), signs(n))
        if (code == NURBS_OK) code = nurbs_mesh_hexahedra(this%handle, n, corners_c, domains, folds, signs)
        if (code == NURBS_OK) corners = transpose(corners_c) + 1
        call settle(code, status)
    end subroutine hexahedra

    !> The polynomial pieces as Bezier cells in the order of VTK, by places in bezier_cell_points.
    subroutine bezier_cells(g, cells, kind, point_count, status)
        class(nurbs_spline), intent(in) :: g
        integer(c_int64_t), allocatable, intent(inout) :: cells(:, :)
        integer(c_int32_t), intent(inout), optional :: kind
        integer(c_int64_t), intent(inout), optional :: point_count
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        integer(c_int64_t), allocatable :: cells_c(:, :)
        n = 0
        code = nurbs_bezier_cells(g%handle, 0_c_int64_t, count=n)
        allocate (cells_c(active_of(g%handle), n))
        if (code == NURBS_OK) code = nurbs_bezier_cells(g%handle, n, cells_c, kind, point_count)
        if (code == NURBS_OK) cells = transpose(cells_c) + 1
        call settle(code, status)
    end subroutine bezier_cells

    !> The control points of the Bezier cells, each once, and their weights.
    subroutine bezier_cell_points(g, points, weights, status)
        class(nurbs_spline), intent(in) :: g
        real(c_double), allocatable, intent(inout) :: points(:, :), weights(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        real(c_double), allocatable :: points_c(:, :)
        n = 0
        code = nurbs_bezier_cell_points(g%handle, 0_c_int64_t, count=n)
        if (allocated(weights)) deallocate (weights)
        allocate (points_c(dim_of(g%handle), n), weights(n))
        if (code == NURBS_OK) code = nurbs_bezier_cell_points(g%handle, n, points_c, weights)
        points = transpose(points_c)
        call settle(code, status)
    end subroutine bezier_cell_points
end module nurbs_meshes
