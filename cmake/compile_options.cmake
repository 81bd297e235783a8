# Options of the library and its tests, as two interface targets.

# Results must be the same on every compiler: no contraction into fused multiply-adds but those written explicitly.
# errno is never read after a mathematical function.
add_library(nurbs_arithmetic INTERFACE)
target_compile_options(nurbs_arithmetic INTERFACE -ffp-contract=off -fno-math-errno)

add_library(nurbs_warnings INTERFACE)
target_compile_options(nurbs_warnings INTERFACE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion $<$<BOOL:${NURBS_WERROR}>:-Werror>)
# Two false alarms of g++ 12 when it optimises: unrolled loops over the axes seem to pass the end of arrays of three, and
# std::string's operator+ seems to copy overlapping text (GCC bug 105651). The unoptimised builds keep both warnings.
target_compile_options(nurbs_warnings INTERFACE
    $<$<AND:$<CXX_COMPILER_ID:GNU>,$<NOT:$<CONFIG:Debug>>>:-Wno-array-bounds;-Wno-restrict>)
# A third one where memory accesses are instrumented: what an empty std::optional does not hold seems to be read.
if(NURBS_SANITIZE)
    target_compile_options(nurbs_warnings INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
endif()
