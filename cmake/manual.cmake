# The manual consists of the comments of the header: HTML by doxygen (target manual), and pages for man(1) (target man).
# Both depend on the header only: no dates, no paths.
find_program(NURBS_DOXYGEN doxygen)
# The interpreter of the distribution comes before any other on the PATH, because the tests need its packages.
find_program(NURBS_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH)
find_program(NURBS_PYTHON python3)

set(NURBS_MANUAL_DIR "${PROJECT_BINARY_DIR}/manual")
set(NURBS_DOXYFILE "${PROJECT_BINARY_DIR}/Doxyfile")
file(MAKE_DIRECTORY "${NURBS_MANUAL_DIR}")
configure_file("${PROJECT_SOURCE_DIR}/cmake/Doxyfile.in" "${NURBS_DOXYFILE}" @ONLY)

if(NURBS_DOXYGEN)
    add_custom_target(manual COMMAND "${NURBS_DOXYGEN}" "${NURBS_DOXYFILE}"
        COMMENT "The manual: ${NURBS_MANUAL_DIR}/index.html" VERBATIM)
endif()
if(NURBS_PYTHON)
    add_custom_target(man COMMAND "${NURBS_PYTHON}" -B "${PROJECT_SOURCE_DIR}/cmake/interface/man.py"
        "${PROJECT_SOURCE_DIR}" "${PROJECT_BINARY_DIR}/man/man3" VERBATIM)
endif()
