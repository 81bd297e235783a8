/* SPDX-License-Identifier: MIT */
/// \file nurbs.hpp
/// \brief libnurbs for C++20: the C interface of nurbs.h with RAII, spans and exceptions or results, and nothing else.
///
/// nurbs.h is the manual; this header keeps its names, its argument order and its layouts. What differs:
/// - a failure throws libnurbs::Error, which carries the status and the message. Where NURBS_CPP_RESULTS is defined
///   before this header is included, and with -fno-exceptions, nothing throws: what is declared Returned<T> below is a
///   Result<T>, which holds the value or the Error, and T otherwise. A source file has one of the two, a program may
///   have both. The memory of a std::vector is not spoken of here: without it, the standard library does what it does;
///
///       #define NURBS_CPP_RESULTS
///       #include <nurbs/nurbs.hpp>
///       ...
///       if (const auto circle = libnurbs::circle({}, 1); !circle) {
///           std::puts(circle.error().what());
///       } else if (const auto length = libnurbs::length(*circle); length) {
///           std::printf("%g\n", length->value);
///       }
///
/// - arrays are Input and Output. Any contiguous range of doubles converts to them and is taken as packed records;
///   `Input(values, n, stride, component_stride)` describes any other layout. Their lengths are known here, so an array
///   that is too short is a failure as well, with NURBS_ERROR_SIZE;
/// - every function that fills an array also exists in a form that returns a std::vector;
/// - the namespace is libnurbs. It cannot be nurbs, the C type of handles, beside which C++ allows no namespace of that
///   name. `namespace nurbs = libnurbs;` works inside a namespace or a function of one's own. NURBS_CPP_ALIAS, defined
///   before this header is included, is another name for all of a file: `#define NURBS_CPP_ALIAS nb` gives nb::circle().
///
/// All of it is compiled into its user. Within a major version the classes keep their members, so that libraries that
/// were compiled with different minor versions can pass Spline, List and Error to each other.
#ifndef NURBS_NURBS_HPP
#define NURBS_NURBS_HPP

#include <nurbs/cpp/analysis.hpp>
#include <nurbs/cpp/arrays.hpp>
#include <nurbs/cpp/bounds.hpp>
#include <nurbs/cpp/calculus.hpp>
#include <nurbs/cpp/closest.hpp>
#include <nurbs/cpp/compatible.hpp>
#include <nurbs/cpp/constrain.hpp>
#include <nurbs/cpp/continuation.hpp>
#include <nurbs/cpp/continuity.hpp>
#include <nurbs/cpp/coons.hpp>
#include <nurbs/cpp/curves.hpp>
#include <nurbs/cpp/deform.hpp>
#include <nurbs/cpp/edit.hpp>
#include <nurbs/cpp/face.hpp>
#include <nurbs/cpp/fit.hpp>
#include <nurbs/cpp/fitting.hpp>
#include <nurbs/cpp/frames.hpp>
#include <nurbs/cpp/handles.hpp>
#include <nurbs/cpp/intersections.hpp>
#include <nurbs/cpp/knots.hpp>
#include <nurbs/cpp/levels.hpp>
#include <nurbs/cpp/linear.hpp>
#include <nurbs/cpp/list.hpp>
#include <nurbs/cpp/measure.hpp>
#include <nurbs/cpp/meets.hpp>
#include <nurbs/cpp/mesh.hpp>
#include <nurbs/cpp/model.hpp>
#include <nurbs/cpp/parts.hpp>
#include <nurbs/cpp/placement.hpp>
#include <nurbs/cpp/projections.hpp>
#include <nurbs/cpp/recognize.hpp>
#include <nurbs/cpp/reduce.hpp>
#include <nurbs/cpp/result.hpp>
#include <nurbs/cpp/segments.hpp>
#include <nurbs/cpp/shapes.hpp>
#include <nurbs/cpp/sizes.hpp>
#include <nurbs/cpp/spline.hpp>
#include <nurbs/cpp/status.hpp>

#include <string_view>

#ifdef NURBS_CPP_ALIAS
#define NURBS_CPP_QUOTED(name) #name
#define NURBS_CPP_TEXT(name) NURBS_CPP_QUOTED(name)
static_assert(std::string_view(NURBS_CPP_TEXT(NURBS_CPP_ALIAS)) != "nurbs",
              "nurbs is the C type of handles, so that NURBS_CPP_ALIAS has to be another name; "
              "inside a namespace or a function `namespace nurbs = libnurbs;` works");
namespace NURBS_CPP_ALIAS = libnurbs;
#endif

#endif // NURBS_NURBS_HPP
