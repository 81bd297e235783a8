! SPDX-License-Identifier: MIT
! Models in Fortran: bushing.step, the path of which is the argument. Everything counts from 1.
program models
    use, intrinsic :: iso_c_binding
    use nurbs
    use expectations
    implicit none
    type(nurbs_model) :: model, copy, two
    type(nurbs_face) :: faces(2)
    character(len=:), allocatable :: path, text
    integer(c_int64_t) :: n, parent, part
    integer(c_int32_t) :: code
    integer :: length, i

    call get_command_argument(1, length=length)
    allocate (character(len=length) :: path)
    call get_command_argument(1, path)
    call model%read_file(path)
    copy = model
    call is_the_bushing(model)
    call is_the_bushing(copy)
    call bytes_and_back(model)
    do i = 1, 2
        call model%face(i, faces(i))
    end do
    call two%create(faces, 0.001d0)
    call two%counts(faces=n)
    call expect(n == 2, 'two faces')
    call two%face_name(2, text)
    call expect(text == '1', 'a number as a name')
    call two%get_use(1, parent, part)
    call expect(parent == 0 .and. part == 1, 'the part in the whole')
    call sew_faces(model)
    call written()
    call levels()
    call triangles()
    call cast_rays()
    call cut()
    call two%read_file('/no/such/file', status=code)
    call expect(code == NURBS_ERROR_FILE, 'a file that is not there')
    call finish()

contains

    !> From the side through both walls: faces and instances count from 1.
    subroutine cast_rays()
        real(c_double) :: first(1), outside(1)
        real(c_double), allocatable :: params(:, :), distances(:), placements(:, :)
        integer(c_int32_t) :: states(1), sides(2)
        integer(c_int32_t), allocatable :: kinds(:)
        integer(c_int64_t) :: at(1, 2)
        integer(c_int64_t), allocatable :: places(:, :), parents(:), uses(:), parts(:)
        logical :: complete
        type(nurbs_face) :: wall
        call model%rays(reshape([9d0, 0.1d0, 2d0], [1, 3]), reshape([-1d0, 0d0, 0d0], [1, 3]), distances=first, &
            states=states, places=at)
        call expect(near(first, [9 - sqrt(24.99d0)]) .and. all(states == NURBS_RAY_HIT + NURBS_RAY_CERTIFIED) .and. &
            all(at == 1), 'a ray')
        call model%ray_hits([9d0, 0.1d0, 2d0], [-1d0, 0d0, 0d0], params, distances, kinds, places, complete)
        call expect(complete .and. size(distances) == 4 .and. places(2, 1) == 2, 'all hits of a ray')
        call model%classify(reshape([4d0, 0d0, 0.1d0, 0.1d0, 2d0, 2d0], [2, 3]), sides)
        call expect(all(sides == [NURBS_SIDE_INSIDE, NURBS_SIDE_OUTSIDE]), 'sides')
        call model%instances(parents, uses, parts, placements)
        call expect(all(parents == [0]) .and. all(uses == [1]) .and. all(parts == [1]) .and. &
            all(shape(placements) == [1, 12]), 'the whole')
        call model%face(1, wall)
        call wall%rays(reshape([9d0, 0.1d0, 2d0], [1, 3]), reshape([-1d0, 0d0, 0d0], [1, 3]), distances=outside)
        call expect(near(outside, first), 'a ray on a face')
        call wall%closest_points(reshape([9d0, 0d0, 2d0], [1, 3]), distances=outside, states=states, tolerance=1d-9)
        call expect(abs(outside(1) - 4) < 1d-8 .and. iand(states(1), NURBS_CLOSEST_CERTIFIED) /= 0, 'a nearest point')
    end subroutine cast_rays

    !> Around the wall outside and inside: planes, branches, faces and instances count from 1.
    subroutine cut()
        type(nurbs_meet) :: meet
        integer(c_int64_t), allocatable :: levels(:), firsts(:), sizes(:), own_faces(:), own_instances(:), next_nodes(:)
        integer(c_int32_t), allocatable :: closes(:)
        real(c_double), allocatable :: gaps(:)
        call meet%model_sections(model, reshape([0d0, 0d0, 0d0, 0d0, 1d0, 1d0], [2, 3]), [2d0, 9d0], 1d-6)
        call meet%ways(levels, firsts, sizes, closes, gaps)
        call expect(all(levels == [1, 1]) .and. all(closes == 1) .and. firsts(2) == 1 + sizes(1), 'ways')
        call meet%faces(own_faces, own_instances)
        call expect(own_faces(1) == 1 .and. own_faces(size(own_faces)) == 2 .and. all(own_instances == 1), 'faces of ways')
        call meet%joints(next_nodes, gaps, own_faces, own_instances)
        call expect(size(gaps) == size(next_nodes) .and. all(own_instances == 1), 'joints')
    end subroutine cut

    !> The same again of what is written, to memory and to a file.
    subroutine written()
        character(kind=c_char, len=:), allocatable, target :: bytes
        type(nurbs_write_options) :: options
        type(nurbs_model) :: again
        type(nurbs_list) :: splines, list
        call default_write_options(options)
        call model%write(NURBS_FORMAT_STEP, bytes, options)
        call again%read(bytes)
        call is_the_bushing(again)
        call model%write_file('models_fortran.step', NURBS_FORMAT_STEP)
        call again%read_file('models_fortran.step')
        call is_the_bushing(again)
        options%unit = 1
        call model%splines(splines)
        call splines%write(NURBS_FORMAT_STEP, bytes, options)
        call list%read(bytes)
        call expect(near([list%unit()], [1d0]), 'the unit of the file')
        call splines%write(NURBS_FORMAT_STEP, bytes, status=code, call=nurbs_call(work=1))
        call expect(code == NURBS_ERROR_WORK, 'a limit of work for a list')
        call splines%write_file('models_fortran.step', NURBS_FORMAT_STEP, options)
        call model%write(NURBS_FORMAT_STEP, bytes, status=code, call=nurbs_call(work=1))
        call expect(code == NURBS_ERROR_WORK, 'a limit of work')
        call model%write(99, bytes, status=code)
        call expect(code == NURBS_ERROR_FORMAT .and. len(bytes) == 0, 'no such format')
        call model%write_file('/no/such/file', NURBS_FORMAT_STEP, status=code)
        call expect(code == NURBS_ERROR_FILE, 'no such folder')
    end subroutine written

    !> Of all shapes, for two distances.
    subroutine levels()
        type(nurbs_face) :: wall
        type(nurbs_spline) :: floor
        type(nurbs_mesh), allocatable :: all(:), same(:), one(:), again(:)
        integer(c_int64_t) :: triangles(4)
        call model%face(1, wall)
        call wall%surface(floor)
        call mesh_levels(model, [1d-1, 1d-2], all)
        call mesh_levels(model, [1d-2], same, call=nurbs_call())
        call mesh_levels(wall, [1d-1], one)
        call mesh_levels(wall, [1d-1], again, call=nurbs_call())
        call all(2)%counts(triangles=triangles(1))
        call same(1)%counts(triangles=triangles(2))
        call one(1)%counts(triangles=triangles(3))
        call again(1)%counts(triangles=triangles(4))
        call expect(triangles(1) == triangles(2) .and. triangles(3) == triangles(4), 'levels of faces and models')
        call mesh_levels(floor, [1d-1], one, call=nurbs_call())
        call expect(size(one) == 1, 'levels of a surface, watched')
    end subroutine levels

    !> Its triangles as files.
    subroutine triangles()
        character(kind=c_char, len=:), allocatable, target :: bytes
        type(nurbs_mesh) :: mesh
        integer(c_int64_t) :: facets
        call mesh%of_model(model)
        call mesh%counts(triangles=facets)
        call mesh%write(NURBS_FORMAT_STL, bytes)
        call expect(len(bytes) == 84 + 50*facets, 'triangles as a file')
        call mesh%write(NURBS_FORMAT_GLB, bytes, call=nurbs_call())
        call expect(bytes(1:4) == 'glTF', 'a scene')
        call mesh%write_file('models_fortran.ply', NURBS_FORMAT_PLY)
        call mesh%write(NURBS_FORMAT_VTU, bytes, status=code, call=nurbs_call(work=1))
        call expect(code == NURBS_ERROR_WORK, 'a limit of work for triangles')
        call mesh%write(NURBS_FORMAT_STEP, bytes, status=code)
        call expect(code == NURBS_ERROR_FORMAT .and. len(bytes) == 0, 'no format of triangles')
        call mesh%write_file('/no/such/file', NURBS_FORMAT_OBJ, status=code)
        call expect(code == NURBS_ERROR_FILE, 'no folder for triangles')
    end subroutine triangles

    subroutine is_the_bushing(bushing)
        type(nurbs_model), intent(in) :: bushing
        type(nurbs_face) :: bore
        type(nurbs_spline) :: seam
        integer(c_int64_t) :: edges, vertices, ends(2)
        integer(c_int64_t), allocatable :: places(:, :)
        integer(c_int32_t) :: shape
        real(c_double) :: area, point(3)
        logical :: against
        call bushing%counts(edges=edges, vertices=vertices)
        call expect(edges == 6 .and. vertices == 4, 'its numbers')
        call bushing%face(2, bore, shape=shape, against=against)
        call expect(shape == NURBS_SHAPE_CYLINDER .and. against, 'its bore')
        call bore%get_area(area)
        call expect(near([area], [24 * pi]), 'the area of the bore')
        call bushing%edge(5, seam, end_vertices=ends)
        call expect(all(ends == [1, 2]), 'the ends of the seam')
        call bushing%edge_uses(5, places)
        call expect(all(places(1, :) == [1, 1, 2]) .and. all(places(2, :) == [1, 1, 4]), 'the uses of the seam')
        call bushing%vertex(2, point)
        call expect(near(point, [5d0, 0d0, 4d0]), 'a vertex')
        call bushing%face(5, bore, status=code)
        call expect(code == NURBS_ERROR_INDEX, 'no fifth face')
    end subroutine is_the_bushing

    subroutine sew_faces(bushing)
        type(nurbs_model), intent(in) :: bushing
        type(nurbs_model) :: again
        type(nurbs_face) :: all_faces(4)
        integer(c_int64_t), allocatable :: uses(:)
        real(c_double), allocatable :: gaps(:)
        integer(c_int32_t), allocatable :: bounded(:)
        integer :: k
        do k = 1, 4
            call bushing%face(k, all_faces(k))
        end do
        call again%sew(all_faces, 1d-6, 0.001d0)
        call again%edge_gaps(uses, gaps, bounded)
        call expect(size(uses) == 6 .and. all(uses == 2) .and. all(gaps < 1d-6) .and. all(bounded == 1), 'sewn faces')
        call again%sew(all_faces, 1d-6, call=nurbs_call(work=1), status=code)
        call expect(code == NURBS_ERROR_WORK, 'a limit of work for sewing')
        call again%sew(all_faces, 0d0, status=code)
        call expect(code == NURBS_ERROR_TOLERANCE, 'no tolerance')
    end subroutine sew_faces

    subroutine bytes_and_back(bushing)
        type(nurbs_model), intent(in) :: bushing
        type(nurbs_model) :: again
        type(nurbs_face) :: bore
        character(kind=c_char, len=:), allocatable :: whole, one, same
        integer(c_int32_t) :: kind, major, minor, status
        call bushing%to_bytes(whole)
        call bytes_kind(whole, kind, major, minor)
        call expect(kind == NURBS_BYTES_MODEL, 'the kind of bytes')
        call again%from_bytes(whole)
        call is_the_bushing(again)
        call bushing%face(2, bore)
        call bore%to_bytes(one)
        call bore%from_bytes(one)
        call bore%to_bytes(same)
        call expect(same == one, 'bytes of a face')
        call bore%from_bytes(whole, status)
        call expect(status == NURBS_ERROR_FORMAT, 'bytes of another kind')
    end subroutine bytes_and_back
end program models
