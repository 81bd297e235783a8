# Settings that apply only when this project is built by itself.

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
    set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()

set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

find_program(NURBS_CCACHE ccache)
if(NURBS_CCACHE)
    foreach(language C CXX)
        if(NOT DEFINED CMAKE_${language}_COMPILER_LAUNCHER)
            set(CMAKE_${language}_COMPILER_LAUNCHER "${NURBS_CCACHE}")
        endif()
    endforeach()
endif()

# libFuzzer needs coverage counted in every object, and finds little without the two sanitizers.
if(NURBS_FUZZ)
    if(NOT CMAKE_CXX_COMPILER_ID MATCHES "Clang")
        message(FATAL_ERROR "NURBS_FUZZ needs clang; other compilers replay the corpus instead")
    endif()
    set(NURBS_SANITIZE "address,undefined" CACHE STRING "" FORCE)
    add_compile_options(-fsanitize=fuzzer-no-link)
endif()

if(NURBS_SANITIZE)
    add_compile_definitions(NURBS_SANITIZED)
    add_compile_options(-fsanitize=${NURBS_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
    add_link_options(-fsanitize=${NURBS_SANITIZE} -fno-sanitize-recover=all)
    # clang leaves what the library's C++ needs of the sanitizer to the executables, of which many are in C.
    if(CMAKE_CXX_COMPILER_ID MATCHES "Clang" AND NURBS_SANITIZE MATCHES "undefined")
        add_link_options(-fsanitize-link-c++-runtime)
        link_libraries($<$<LINK_LANGUAGE:C>:stdc++>)
    endif()
endif()

# The library's objects count; every program that is linked with them writes the counts.
# If a kernel is compiled for several instruction sets, clang counts only one; so it is compiled for one.
if(NURBS_COVERAGE)
    add_compile_definitions(HWY_COMPILE_ONLY_STATIC)
    add_compile_options(-Wno-pass-failed) # a loop that counts is not unrolled
    add_link_options(-fprofile-instr-generate)
endif()
