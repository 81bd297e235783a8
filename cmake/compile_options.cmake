# Options of the library and its tests, as two interface targets.

# Results must be the same on every compiler: no multiplication and addition is fused unless the source says so.
# errno is never read after a mathematical function.
add_library(nurbs_arithmetic INTERFACE)
target_compile_options(nurbs_arithmetic INTERFACE -ffp-contract=off -fno-math-errno)

add_library(nurbs_warnings INTERFACE)
target_compile_options(nurbs_warnings INTERFACE
    -Wall -Wextra -Wpedantic -Wconversion $<$<BOOL:${NURBS_WERROR}>:-Werror>)
# Two false alarms of g++ 12 when it optimises: it believes that unrolled loops over the axes pass the end of arrays of
# three, and that std::string's operator+ copies overlapping text (GCC bug 105651). The unoptimised builds keep both warnings.
target_compile_options(nurbs_warnings INTERFACE
    $<$<AND:$<CXX_COMPILER_ID:GNU>,$<NOT:$<CONFIG:Debug>>>:-Wno-array-bounds;-Wno-restrict>)
# A third false alarm of g++ when a sanitizer instruments memory accesses: it believes that the value of an empty
# std::optional is read.
if(NURBS_SANITIZE)
    target_compile_options(nurbs_warnings INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
endif()
# Files that are compiled together see the names of each other's unnamed namespaces: a local name may be one of those, and
# g++ takes every file but the first for a header. The builds that compile each file alone have both warnings.
if(NURBS_UNITY)
    target_compile_options(nurbs_warnings INTERFACE
        $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-Wshadow=local;-Wno-subobject-linkage>)
else()
    target_compile_options(nurbs_warnings INTERFACE -Wshadow)
endif()
