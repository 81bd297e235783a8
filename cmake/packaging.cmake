# The target `deb`: Debian packages of this source, in the folder deb of the build.
add_custom_target(deb
    COMMAND "${PROJECT_SOURCE_DIR}/cmake/debian_build.sh" "${PROJECT_SOURCE_DIR}" "${PROJECT_BINARY_DIR}/deb"
    USES_TERMINAL VERBATIM
    COMMENT "Building Debian packages in ${PROJECT_BINARY_DIR}/deb")
