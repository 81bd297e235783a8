! SPDX-License-Identifier: MIT
!> The handles that splines, lists of splines, statistics, faces, models, meets and
!> meshes own: how they are replaced, copied and freed.
module nurbs_handles
    use, intrinsic :: iso_c_binding
    use nurbs_constants
    use nurbs_c, only: nurbs_clone, nurbs_cloud_options, nurbs_cloud_options_init, nurbs_data, nurbs_data_init, &
        nurbs_destroy, nurbs_face_clone, nurbs_face_destroy, nurbs_face_to_bytes, nurbs_fit_options, &
        nurbs_fit_options_init, nurbs_list_create, nurbs_list_destroy, nurbs_list_to_bytes, nurbs_list_write, &
        nurbs_list_write_with, nurbs_meet_clone, nurbs_meet_destroy, nurbs_mesh_clone, nurbs_mesh_destroy, &
        nurbs_mesh_options, nurbs_mesh_options_init, nurbs_mesh_write, nurbs_mesh_write_with, nurbs_model_clone, &
        nurbs_model_destroy, &
        nurbs_model_to_bytes, nurbs_model_write, nurbs_model_write_with, nurbs_read_options, &
        nurbs_read_options_init, nurbs_statistics_clone, nurbs_statistics_destroy, nurbs_statistics_to_bytes, &
        nurbs_to_bytes, &
        nurbs_write_options, nurbs_write_options_init
    use nurbs_calls, only: nurbs_call, watched
    use nurbs_support
    implicit none
    private
    public :: handles_of, as_many, default_read_options, default_write_options, default_fit_options
    public :: default_cloud_options, default_mesh_options, data_for_fits

    !> As the library takes an array of handles.
    interface handles_of
        module procedure handles_of_splines, handles_of_statistics, handles_of_faces
    end interface handles_of

    !> The handle of a spline. An assignment makes another handle on the same data.
    type, public :: nurbs_handle
        type(c_ptr) :: handle = c_null_ptr
    contains
        procedure :: destroy => destroy_spline, replace => replace_spline, to_bytes => spline_to_bytes
        procedure, private :: copy
        generic :: assignment(=) => copy
        final :: finish_spline
    end type nurbs_handle

    !> The handle of a list of splines, which cannot be copied.
    type, public :: nurbs_list_handle
        type(c_ptr) :: handle = c_null_ptr
    contains
        procedure :: destroy => destroy_list, replace => replace_list, create => create_list
        procedure :: to_bytes => list_to_bytes, write => write_list
        procedure, private :: refuse_copy
        generic :: assignment(=) => refuse_copy
        final :: finish_list
    end type nurbs_list_handle

    !> The handle of statistics. An assignment makes another handle on the same sums.
    type, public :: nurbs_statistics_handle
        type(c_ptr) :: handle = c_null_ptr
    contains
        procedure :: destroy => destroy_statistics, replace => replace_statistics, to_bytes => statistics_to_bytes
        procedure, private :: copy_statistics
        generic :: assignment(=) => copy_statistics
        final :: finish_statistics
    end type nurbs_statistics_handle

    !> The handle of a face. An assignment makes another handle on the same face.
    type, public :: nurbs_face_handle
        type(c_ptr) :: handle = c_null_ptr
    contains
        procedure :: destroy => destroy_face, replace => replace_face, to_bytes => face_to_bytes
        procedure, private :: copy_face
        generic :: assignment(=) => copy_face
        final :: finish_face
    end type nurbs_face_handle

    !> What nurbs_to_bytes() and those like it are.
    abstract interface
        function writer_of_bytes(handle, cap, bytes, length) bind(c) result(r)
            import
            type(c_ptr), value :: handle, bytes
            integer(c_int64_t), value :: cap
            integer(c_int64_t), intent(inout), optional :: length
            integer(c_int32_t) :: r
        end function writer_of_bytes
    end interface

    !> The handle of a model. An assignment makes another handle on the same model.
    type, public :: nurbs_model_handle
        type(c_ptr) :: handle = c_null_ptr
    contains
        procedure :: destroy => destroy_model, replace => replace_model, write => write_model, to_bytes => model_to_bytes
        procedure, private :: copy_model
        generic :: assignment(=) => copy_model
        final :: finish_model
    end type nurbs_model_handle

    !> The handle of what is found where shapes meet. An assignment makes another handle on the same.
    type, public :: nurbs_meet_handle
        type(c_ptr) :: handle = c_null_ptr
    contains
        procedure :: destroy => destroy_meet, replace => replace_meet
        procedure, private :: copy_meet
        generic :: assignment(=) => copy_meet
        final :: finish_meet
    end type nurbs_meet_handle

    !> The handle of triangles in place of shapes. An assignment makes another handle on the same.
    type, public :: nurbs_mesh_handle
        type(c_ptr) :: handle = c_null_ptr
    contains
        procedure :: destroy => destroy_mesh, replace => replace_mesh, write => write_mesh
        procedure, private :: copy_mesh
        generic :: assignment(=) => copy_mesh
        final :: finish_mesh
    end type nurbs_mesh_handle

contains

    !> The bytes that one of them makes of a handle.
    subroutine write_bytes(writer, handle, bytes, status)
        procedure(writer_of_bytes) :: writer
        type(c_ptr), intent(in) :: handle
        character(kind=c_char, len=:), allocatable, target, intent(out) :: bytes
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int64_t) :: length
        integer(c_int32_t) :: code
        length = 0
        code = writer(handle, 0_c_int64_t, c_null_ptr, length)
        allocate (character(kind=c_char, len=length) :: bytes)
        if (code == NURBS_OK) code = writer(handle, length, c_loc(bytes))
        call settle(code, status)
    end subroutine write_bytes

    ! Splines

    !> The same bytes on every machine for the same spline.
    subroutine spline_to_bytes(this, bytes, status)
        class(nurbs_handle), intent(in) :: this
        character(kind=c_char, len=:), allocatable, target, intent(out) :: bytes
        integer(c_int32_t), intent(out), optional :: status
        call write_bytes(nurbs_to_bytes, this%handle, bytes, status)
    end subroutine spline_to_bytes

    subroutine destroy_spline(this)
        class(nurbs_handle), intent(inout) :: this
        call replace_spline(this, c_null_ptr)
    end subroutine destroy_spline

    impure elemental subroutine finish_spline(this)
        type(nurbs_handle), intent(inout) :: this
        call destroy_spline(this)
    end subroutine finish_spline

    !> Puts a handle in place of the old one.
    subroutine replace_spline(this, handle)
        class(nurbs_handle), intent(inout) :: this
        type(c_ptr), intent(in) :: handle
        call nurbs_destroy(this%handle)
        this%handle = handle
    end subroutine replace_spline

    !> Elemental, so that arrays are not assigned bit by bit, which would free their handles twice.
    impure elemental subroutine copy(this, other)
        class(nurbs_handle), intent(inout) :: this
        class(nurbs_handle), intent(in) :: other
        type(c_ptr) :: made
        made = c_null_ptr
        if (c_associated(other%handle)) call settle(nurbs_clone(other%handle, made))
        call this%replace(made)
    end subroutine copy

    function handles_of_splines(splines) result(handles)
        class(nurbs_handle), intent(in) :: splines(:)
        type(c_ptr) :: handles(size(splines))
        integer :: i
        do i = 1, size(splines)
            handles(i) = splines(i)%handle
        end do
    end function handles_of_splines

    !> Whether there are so many, if they are present.
    pure logical function as_many(splines, n)
        class(nurbs_handle), intent(in), optional :: splines(:)
        integer(c_int64_t), intent(in) :: n
        as_many = .true.
        if (present(splines)) as_many = size(splines, kind=c_int64_t) == n
    end function as_many

    ! Statistics

    subroutine destroy_statistics(this)
        class(nurbs_statistics_handle), intent(inout) :: this
        call replace_statistics(this, c_null_ptr)
    end subroutine destroy_statistics

    impure elemental subroutine finish_statistics(this)
        type(nurbs_statistics_handle), intent(inout) :: this
        call destroy_statistics(this)
    end subroutine finish_statistics

    subroutine replace_statistics(this, handle)
        class(nurbs_statistics_handle), intent(inout) :: this
        type(c_ptr), intent(in) :: handle
        call nurbs_statistics_destroy(this%handle)
        this%handle = handle
    end subroutine replace_statistics

    impure elemental subroutine copy_statistics(this, other)
        class(nurbs_statistics_handle), intent(inout) :: this
        class(nurbs_statistics_handle), intent(in) :: other
        type(c_ptr) :: made
        made = c_null_ptr
        if (c_associated(other%handle)) call settle(nurbs_statistics_clone(other%handle, made))
        call this%replace(made)
    end subroutine copy_statistics

    function handles_of_statistics(statistics) result(handles)
        class(nurbs_statistics_handle), intent(in) :: statistics(:)
        type(c_ptr) :: handles(size(statistics))
        integer :: i
        do i = 1, size(statistics)
            handles(i) = statistics(i)%handle
        end do
    end function handles_of_statistics

    !> The same bytes on every machine for the same data, whatever their order.
    subroutine statistics_to_bytes(this, bytes, status)
        class(nurbs_statistics_handle), intent(in) :: this
        character(kind=c_char, len=:), allocatable, target, intent(out) :: bytes
        integer(c_int32_t), intent(out), optional :: status
        call write_bytes(nurbs_statistics_to_bytes, this%handle, bytes, status)
    end subroutine statistics_to_bytes

    !> values(n, dim) at params(n, axes), with weights(n) or without. It refers to these arrays, which have to be
    !> contiguous, and to stay as long as it is used.
    subroutine data_for_fits(data, params, values, weights, flags)
        type(nurbs_data), intent(out) :: data
        real(c_double), intent(in), target, contiguous :: params(:, :), values(:, :)
        real(c_double), intent(in), target, contiguous, optional :: weights(:)
        integer(c_int32_t), intent(in), optional :: flags
        call settle(nurbs_data_init(data, int(c_sizeof(data), c_int64_t)))
        data%n = size(params, 1, c_int64_t)
        data%axes = size(params, 2, c_int32_t)
        data%dim = size(values, 2, c_int32_t)
        data%params = c_loc(params)
        data%param_stride = step(params)
        data%param_component_stride = column(params)
        data%values = c_loc(values)
        data%value_stride = step(values)
        data%value_component_stride = column(values)
        if (present(weights)) data%weights = c_loc(weights)
        if (present(flags)) data%flags = flags
        if (size(values, 1) /= size(params, 1)) data%n = -1
        if (present(weights)) then
            if (size(weights) /= size(params, 1)) data%n = -1
        end if
    end subroutine data_for_fits

    !> The settings that fits have without options, to change some of them.
    subroutine default_fit_options(options, status)
        type(nurbs_fit_options), intent(out) :: options
        integer(c_int32_t), intent(out), optional :: status
        call settle(nurbs_fit_options_init(options, int(c_sizeof(options), c_int64_t)), status)
    end subroutine default_fit_options

    !> The settings that fits of points without parameters have without options, to change some of them.
    subroutine default_cloud_options(options, status)
        type(nurbs_cloud_options), intent(out) :: options
        integer(c_int32_t), intent(out), optional :: status
        call settle(nurbs_cloud_options_init(options, int(c_sizeof(options), c_int64_t)), status)
    end subroutine default_cloud_options

    ! Faces

    !> The same bytes on every machine for the same face.
    subroutine face_to_bytes(this, bytes, status)
        class(nurbs_face_handle), intent(in) :: this
        character(kind=c_char, len=:), allocatable, target, intent(out) :: bytes
        integer(c_int32_t), intent(out), optional :: status
        call write_bytes(nurbs_face_to_bytes, this%handle, bytes, status)
    end subroutine face_to_bytes

    subroutine destroy_face(this)
        class(nurbs_face_handle), intent(inout) :: this
        call replace_face(this, c_null_ptr)
    end subroutine destroy_face

    impure elemental subroutine finish_face(this)
        type(nurbs_face_handle), intent(inout) :: this
        call destroy_face(this)
    end subroutine finish_face

    subroutine replace_face(this, handle)
        class(nurbs_face_handle), intent(inout) :: this
        type(c_ptr), intent(in) :: handle
        call nurbs_face_destroy(this%handle)
        this%handle = handle
    end subroutine replace_face

    impure elemental subroutine copy_face(this, other)
        class(nurbs_face_handle), intent(inout) :: this
        class(nurbs_face_handle), intent(in) :: other
        type(c_ptr) :: made
        made = c_null_ptr
        if (c_associated(other%handle)) call settle(nurbs_face_clone(other%handle, made))
        call this%replace(made)
    end subroutine copy_face

    function handles_of_faces(faces) result(handles)
        class(nurbs_face_handle), intent(in) :: faces(:)
        type(c_ptr) :: handles(size(faces))
        integer :: i
        do i = 1, size(faces)
            handles(i) = faces(i)%handle
        end do
    end function handles_of_faces

    ! Meets

    subroutine destroy_meet(this)
        class(nurbs_meet_handle), intent(inout) :: this
        call replace_meet(this, c_null_ptr)
    end subroutine destroy_meet

    impure elemental subroutine finish_meet(this)
        type(nurbs_meet_handle), intent(inout) :: this
        call destroy_meet(this)
    end subroutine finish_meet

    subroutine replace_meet(this, handle)
        class(nurbs_meet_handle), intent(inout) :: this
        type(c_ptr), intent(in) :: handle
        call nurbs_meet_destroy(this%handle)
        this%handle = handle
    end subroutine replace_meet

    impure elemental subroutine copy_meet(this, other)
        class(nurbs_meet_handle), intent(inout) :: this
        class(nurbs_meet_handle), intent(in) :: other
        type(c_ptr) :: made
        made = c_null_ptr
        if (c_associated(other%handle)) call settle(nurbs_meet_clone(other%handle, made))
        call this%replace(made)
    end subroutine copy_meet

    ! Meshes

    subroutine destroy_mesh(this)
        class(nurbs_mesh_handle), intent(inout) :: this
        call replace_mesh(this, c_null_ptr)
    end subroutine destroy_mesh

    impure elemental subroutine finish_mesh(this)
        type(nurbs_mesh_handle), intent(inout) :: this
        call destroy_mesh(this)
    end subroutine finish_mesh

    subroutine replace_mesh(this, handle)
        class(nurbs_mesh_handle), intent(inout) :: this
        type(c_ptr), intent(in) :: handle
        call nurbs_mesh_destroy(this%handle)
        this%handle = handle
    end subroutine replace_mesh

    impure elemental subroutine copy_mesh(this, other)
        class(nurbs_mesh_handle), intent(inout) :: this
        class(nurbs_mesh_handle), intent(in) :: other
        type(c_ptr) :: made
        made = c_null_ptr
        if (c_associated(other%handle)) call settle(nurbs_mesh_clone(other%handle, made))
        call this%replace(made)
    end subroutine copy_mesh

    ! Models

    !> The same bytes on every machine for the same model.
    subroutine model_to_bytes(this, bytes, status)
        class(nurbs_model_handle), intent(in) :: this
        character(kind=c_char, len=:), allocatable, target, intent(out) :: bytes
        integer(c_int32_t), intent(out), optional :: status
        call write_bytes(nurbs_model_to_bytes, this%handle, bytes, status)
    end subroutine model_to_bytes

    subroutine destroy_model(this)
        class(nurbs_model_handle), intent(inout) :: this
        call replace_model(this, c_null_ptr)
    end subroutine destroy_model

    impure elemental subroutine finish_model(this)
        type(nurbs_model_handle), intent(inout) :: this
        call destroy_model(this)
    end subroutine finish_model

    subroutine replace_model(this, handle)
        class(nurbs_model_handle), intent(inout) :: this
        type(c_ptr), intent(in) :: handle
        call nurbs_model_destroy(this%handle)
        this%handle = handle
    end subroutine replace_model

    impure elemental subroutine copy_model(this, other)
        class(nurbs_model_handle), intent(inout) :: this
        class(nurbs_model_handle), intent(in) :: other
        type(c_ptr) :: made
        made = c_null_ptr
        if (c_associated(other%handle)) call settle(nurbs_model_clone(other%handle, made))
        call this%replace(made)
    end subroutine copy_model

    ! Lists

    !> A list of splines; names without the blanks at their ends, absent for "0", "1", ...; metres per unit of length, absent
    !> if that is not known.
    subroutine create_list(this, splines, names, metres, status)
        class(nurbs_list_handle), intent(inout) :: this
        class(nurbs_handle), intent(in) :: splines(:)
        character(len=*), intent(in), optional :: names(:)
        real(c_double), intent(in), optional :: metres
        integer(c_int32_t), intent(out), optional :: status
        character(kind=c_char), allocatable, target :: texts(:, :)
        type(c_ptr), allocatable :: places(:)
        type(c_ptr) :: made
        integer(c_int32_t) :: code
        integer :: i, k
        made = c_null_ptr
        code = NURBS_OK
        if (present(names)) then
            if (size(names) /= size(splines)) code = shape_error
            allocate (texts(len(names) + 1, size(names)), source=c_null_char)
            allocate (places(size(names)))
            do i = 1, size(names)
                do k = 1, len_trim(names(i))
                    texts(k, i) = names(i)(k:k)
                end do
                places(i) = c_loc(texts(1, i))
            end do
        end if
        if (code == NURBS_OK) code = nurbs_list_create(size(splines, kind=c_int64_t), handles_of_splines(splines), places, &
            given(metres, 0.0_c_double), made)
        call this%replace(made)
        call settle(code, status)
    end subroutine create_list

    subroutine destroy_list(this)
        class(nurbs_list_handle), intent(inout) :: this
        call replace_list(this, c_null_ptr)
    end subroutine destroy_list

    impure elemental subroutine finish_list(this)
        type(nurbs_list_handle), intent(inout) :: this
        call destroy_list(this)
    end subroutine finish_list

    subroutine replace_list(this, handle)
        class(nurbs_list_handle), intent(inout) :: this
        type(c_ptr), intent(in) :: handle
        call nurbs_list_destroy(this%handle)
        this%handle = handle
    end subroutine replace_list

    !> The same bytes on every machine for the same list, with names, notes and unit.
    subroutine list_to_bytes(this, bytes, status)
        class(nurbs_list_handle), intent(in) :: this
        character(kind=c_char, len=:), allocatable, target, intent(out) :: bytes
        integer(c_int32_t), intent(out), optional :: status
        call write_bytes(nurbs_list_to_bytes, this%handle, bytes, status)
    end subroutine list_to_bytes

    !> The contents of a file that holds the splines: of a format such as NURBS_FORMAT_STEP.
    subroutine write_list(this, format, bytes, options, status, call)
        class(nurbs_list_handle), intent(in) :: this
        integer(c_int32_t), intent(in) :: format
        character(kind=c_char, len=:), allocatable, target, intent(out) :: bytes
        type(nurbs_write_options), intent(in), optional :: options
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int64_t) :: length
        integer(c_int32_t) :: code
        length = 0
        code = written(0_c_int64_t, c_null_ptr)
        allocate (character(kind=c_char, len=length) :: bytes)
        if (code == NURBS_OK) code = written(length, c_loc(bytes))
        call settle(code, status)

    contains

        integer(c_int32_t) function written(cap, place)
            integer(c_int64_t), intent(in) :: cap
            type(c_ptr), intent(in) :: place
            if (present(call)) then
                written = nurbs_list_write_with(this%handle, format, options, cap, place, length, watched(call))
            else
                written = nurbs_list_write(this%handle, format, options, cap, place, length)
            end if
        end function written
    end subroutine write_list

    !> The contents of a file that holds the model: of a format such as NURBS_FORMAT_STEP.
    subroutine write_model(this, format, bytes, options, status, call)
        class(nurbs_model_handle), intent(in) :: this
        integer(c_int32_t), intent(in) :: format
        character(kind=c_char, len=:), allocatable, target, intent(out) :: bytes
        type(nurbs_write_options), intent(in), optional :: options
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int64_t) :: length
        integer(c_int32_t) :: code
        length = 0
        code = written(0_c_int64_t, c_null_ptr)
        allocate (character(kind=c_char, len=length) :: bytes)
        if (code == NURBS_OK) code = written(length, c_loc(bytes))
        call settle(code, status)

    contains

        integer(c_int32_t) function written(cap, place)
            integer(c_int64_t), intent(in) :: cap
            type(c_ptr), intent(in) :: place
            if (present(call)) then
                written = nurbs_model_write_with(this%handle, format, options, cap, place, length, watched(call))
            else
                written = nurbs_model_write(this%handle, format, options, cap, place, length)
            end if
        end function written
    end subroutine write_model

    !> The contents of a file that holds the mesh: of a format such as NURBS_FORMAT_STL.
    subroutine write_mesh(this, format, bytes, options, status, call)
        class(nurbs_mesh_handle), intent(in) :: this
        integer(c_int32_t), intent(in) :: format
        character(kind=c_char, len=:), allocatable, target, intent(out) :: bytes
        type(nurbs_write_options), intent(in), optional :: options
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int64_t) :: length
        integer(c_int32_t) :: code
        length = 0
        code = written(0_c_int64_t, c_null_ptr)
        allocate (character(kind=c_char, len=length) :: bytes)
        if (code == NURBS_OK) code = written(length, c_loc(bytes))
        call settle(code, status)

    contains

        integer(c_int32_t) function written(cap, place)
            integer(c_int64_t), intent(in) :: cap
            type(c_ptr), intent(in) :: place
            if (present(call)) then
                written = nurbs_mesh_write_with(this%handle, format, options, cap, place, length, watched(call))
            else
                written = nurbs_mesh_write(this%handle, format, options, cap, place, length)
            end if
        end function written
    end subroutine write_mesh

    impure elemental subroutine refuse_copy(this, other)
        class(nurbs_list_handle), intent(inout) :: this
        class(nurbs_list_handle), intent(in) :: other
        if (.not. c_associated(this%handle, other%handle)) error stop 'a nurbs_list cannot be copied'
    end subroutine refuse_copy

    !> The settings that read() and read_file() have without options, to change some of them.
    subroutine default_read_options(options, status)
        type(nurbs_read_options), intent(out) :: options
        integer(c_int32_t), intent(out), optional :: status
        call settle(nurbs_read_options_init(options, int(c_sizeof(options), c_int64_t)), status)
    end subroutine default_read_options

    !> The settings that write() and write_file() have without options, to change some of them.
    subroutine default_write_options(options, status)
        type(nurbs_write_options), intent(out) :: options
        integer(c_int32_t), intent(out), optional :: status
        call settle(nurbs_write_options_init(options, int(c_sizeof(options), c_int64_t)), status)
    end subroutine default_write_options

    !> The limits that meshes have without options, to change some of them.
    subroutine default_mesh_options(options, status)
        type(nurbs_mesh_options), intent(out) :: options
        integer(c_int32_t), intent(out), optional :: status
        call settle(nurbs_mesh_options_init(options, int(c_sizeof(options), c_int64_t)), status)
    end subroutine default_mesh_options
end module nurbs_handles
