// Numbers of fifty digits, for what has no exact value: roots, lengths, angles.
#pragma once

// Boost 1.74 shadows and converts inside its own headers.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#ifndef __clang__ // g++ with sanitizers loses track of what was set
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <boost/math/quadrature/gauss.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#pragma GCC diagnostic pop

namespace reference {

using Float50 = boost::multiprecision::cpp_bin_float_50;

} // namespace reference
