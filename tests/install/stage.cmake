# Installs, then moves the prefix: what is used afterwards must not know where it was installed to.
set(first "${PREFIX}.first")
file(REMOVE_RECURSE "${first}" "${PREFIX}")
execute_process(COMMAND "${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${first}" COMMAND_ERROR_IS_FATAL ANY)
file(RENAME "${first}" "${PREFIX}")
# The path must not stand in any text that is installed.
file(GLOB_RECURSE texts "${PREFIX}/*.cmake" "${PREFIX}/*.pc")
foreach(text IN LISTS texts)
    file(STRINGS "${text}" lines)
    string(FIND "${lines}" "${PREFIX}" at)
    if(NOT at EQUAL -1)
        message(FATAL_ERROR "${text} contains the path of the prefix")
    endif()
endforeach()
