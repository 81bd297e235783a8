# The installed files, and how other builds find them: CMake package and pkg-config file. Both are relocatable, except for
# nurbs.pc below /usr.
include(CMakePackageConfigHelpers)

install(TARGETS nurbs nurbs_static EXPORT nurbs-targets
    LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}"
    ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}")
install(DIRECTORY "${PROJECT_SOURCE_DIR}/include/nurbs" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}"
    FILES_MATCHING PATTERN "*.h" PATTERN "*.hpp")

# The other languages' modules are installed as sources: compiled Fortran modules and Rust crates belong to one compiler
# each, and Python's package goes where a packager's interpreter looks for it.
install(DIRECTORY "${PROJECT_SOURCE_DIR}/capi/bindings/" DESTINATION "${CMAKE_INSTALL_DATADIR}/nurbs"
    FILES_MATCHING PATTERN "*.f90" PATTERN "*.py" PATTERN "py.typed" PATTERN "*.rs" PATTERN "Cargo.toml"
    PATTERN "__pycache__" EXCLUDE PATTERN "build" EXCLUDE PATTERN "*.egg-info" EXCLUDE PATTERN "target" EXCLUDE)
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION "${CMAKE_INSTALL_DOCDIR}")

set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/nurbs")
set(NURBS_FORTRAN_DIR "${CMAKE_INSTALL_DATADIR}/nurbs/fortran")
install(EXPORT nurbs-targets NAMESPACE nurbs:: DESTINATION "${package_dir}")
configure_package_config_file("${PROJECT_SOURCE_DIR}/cmake/nurbs-config.cmake.in"
    "${PROJECT_BINARY_DIR}/nurbs-config.cmake"
    INSTALL_DESTINATION "${package_dir}" PATH_VARS NURBS_FORTRAN_DIR NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file("${PROJECT_BINARY_DIR}/nurbs-config-version.cmake"
    COMPATIBILITY SameMajorVersion)
install(FILES "${PROJECT_BINARY_DIR}/nurbs-config.cmake" "${PROJECT_BINARY_DIR}/nurbs-config-version.cmake"
    DESTINATION "${package_dir}")

# pkg-config: directories are relative to the .pc file, unless the installer asked for absolute ones. The system's own
# directories are absolute, too: pkg-config leaves them out of its answers only if it knows them by their names.
foreach(kind LIB INCLUDE)
    string(TOLOWER "${kind}" name)
    if(IS_ABSOLUTE "${CMAKE_INSTALL_${kind}DIR}")
        set(pc_${name}dir "${CMAKE_INSTALL_${kind}DIR}")
    else()
        set(pc_${name}dir "\${prefix}/${CMAKE_INSTALL_${kind}DIR}")
    endif()
endforeach()
if(IS_ABSOLUTE "${CMAKE_INSTALL_LIBDIR}" OR CMAKE_INSTALL_PREFIX STREQUAL "/usr")
    set(pc_prefix "${CMAKE_INSTALL_PREFIX}")
else()
    file(RELATIVE_PATH pc_up "/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/")
    string(REGEX REPLACE "/$" "" pc_up "${pc_up}")
    set(pc_prefix "\${pcfiledir}/${pc_up}")
endif()
configure_file("${PROJECT_SOURCE_DIR}/cmake/nurbs.pc.in" "${PROJECT_BINARY_DIR}/nurbs.pc" @ONLY)
install(FILES "${PROJECT_BINARY_DIR}/nurbs.pc" DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig")
