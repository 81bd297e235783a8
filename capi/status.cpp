// SPDX-License-Identifier: MIT
// The version, the translation of exceptions to statuses, and the last error message of the calling thread.
#include "guard.h"

#include "base/error.h"

#include <algorithm>
#include <cstring>
#include <cxxabi.h>
#include <iterator>
#include <new>
#include <stdexcept>

namespace {

// A plain array, which has neither constructor nor destructor, so that it can be used when memory is
// exhausted and while a thread ends.
thread_local char last_message[nrb::Error::capacity];

void remember(const char *message) noexcept {
    const size_t length = std::min(std::strlen(message), sizeof last_message - 1);
    std::memcpy(last_message, message, length);
    last_message[length] = '\0';
}

} // namespace

namespace nrb::capi {

nurbs_status translate_exception() {
    try {
        throw;
    } catch (abi::__forced_unwind &) {
        throw;
    } catch (const Error &error) {
        remember(error.what());
        return static_cast<nurbs_status>(error.status());
    } catch (const CallEnded &end) {
        remember(end.why.what());
        return static_cast<nurbs_status>(end.why.status());
    } catch (const std::bad_alloc &) {
        remember("an allocation failed");
        return NURBS_ERROR_MEMORY;
    } catch (const std::length_error &) {
        remember("an allocation exceeds what a container can hold");
        return NURBS_ERROR_MEMORY;
    } catch (const std::exception &error) {
        remember(error.what());
        return NURBS_ERROR_INTERNAL;
    } catch (...) {
        remember("unknown exception");
        return NURBS_ERROR_INTERNAL;
    }
}

} // namespace nrb::capi

int32_t nurbs_version(void) {
    return NURBS_VERSION;
}

int64_t nurbs_last_error(char *buf, int64_t cap) {
    const auto length = static_cast<int64_t>(std::strlen(last_message));
    if (buf != nullptr && cap > 0) {
        const int64_t copied = std::min(length, cap - 1);
        std::memcpy(buf, last_message, static_cast<size_t>(copied));
        buf[copied] = '\0';
    }
    return length;
}

#define NURBS_NAMED(status)                                                                                  \
    { status, #status }

namespace {

struct NamedStatus {
    nurbs_status status;
    const char *name;
};

constexpr NamedStatus status_names[] = {
    NURBS_NAMED(NURBS_OK),
    NURBS_NAMED(NURBS_ERROR_NULL),
    NURBS_NAMED(NURBS_ERROR_AXES),
    NURBS_NAMED(NURBS_ERROR_AXIS),
    NURBS_NAMED(NURBS_ERROR_DEGREE),
    NURBS_NAMED(NURBS_ERROR_COUNT),
    NURBS_NAMED(NURBS_ERROR_TOO_FEW_POINTS),
    NURBS_NAMED(NURBS_ERROR_OVERFLOW),
    NURBS_NAMED(NURBS_ERROR_SIZE),
    NURBS_NAMED(NURBS_ERROR_DIMENSION),
    NURBS_NAMED(NURBS_ERROR_STRIDE),
    NURBS_NAMED(NURBS_ERROR_OVERLAP),
    NURBS_NAMED(NURBS_ERROR_FLAGS),
    NURBS_NAMED(NURBS_ERROR_ORDER),
    NURBS_NAMED(NURBS_ERROR_KNOT_NOT_FINITE),
    NURBS_NAMED(NURBS_ERROR_KNOTS_DECREASING),
    NURBS_NAMED(NURBS_ERROR_END_MULTIPLICITY),
    NURBS_NAMED(NURBS_ERROR_MULTIPLICITY),
    NURBS_NAMED(NURBS_ERROR_EMPTY_DOMAIN),
    NURBS_NAMED(NURBS_ERROR_POINT_NOT_FINITE),
    NURBS_NAMED(NURBS_ERROR_WEIGHT_NOT_FINITE),
    NURBS_NAMED(NURBS_ERROR_WEIGHT_NEGATIVE),
    NURBS_NAMED(NURBS_ERROR_WEIGHTS_VANISH),
    NURBS_NAMED(NURBS_ERROR_PARAMETER_NOT_FINITE),
    NURBS_NAMED(NURBS_ERROR_PERIODIC_KNOTS),
    NURBS_NAMED(NURBS_ERROR_PERIODIC_POINTS),
    NURBS_NAMED(NURBS_ERROR_TIMES),
    NURBS_NAMED(NURBS_ERROR_OPTIONS),
    NURBS_NAMED(NURBS_ERROR_INDEX),
    NURBS_NAMED(NURBS_ERROR_DIRECTION),
    NURBS_NAMED(NURBS_ERROR_END_KNOT),
    NURBS_NAMED(NURBS_ERROR_NOT_A_KNOT),
    NURBS_NAMED(NURBS_ERROR_MATRIX),
    NURBS_NAMED(NURBS_ERROR_RATIONAL),
    NURBS_NAMED(NURBS_ERROR_INCOMPATIBLE),
    NURBS_NAMED(NURBS_ERROR_GAP),
    NURBS_NAMED(NURBS_ERROR_TOLERANCE),
    NURBS_NAMED(NURBS_ERROR_NOT_PERIODIC),
    NURBS_NAMED(NURBS_ERROR_END_WEIGHTS),
    NURBS_NAMED(NURBS_ERROR_FACTOR),
    NURBS_NAMED(NURBS_ERROR_PERIODIC),
    NURBS_NAMED(NURBS_ERROR_END),
    NURBS_NAMED(NURBS_ERROR_BASIS),
    NURBS_NAMED(NURBS_ERROR_NOT_MONOTONE),
    NURBS_NAMED(NURBS_ERROR_ANGLE),
    NURBS_NAMED(NURBS_ERROR_LENGTH),
    NURBS_NAMED(NURBS_ERROR_COLLINEAR),
    NURBS_NAMED(NURBS_ERROR_CONIC),
    NURBS_NAMED(NURBS_ERROR_FORM),
    NURBS_NAMED(NURBS_ERROR_TANGENT),
    NURBS_NAMED(NURBS_ERROR_TWIST),
    NURBS_NAMED(NURBS_ERROR_TWIST_RULE),
    NURBS_NAMED(NURBS_ERROR_INFLUENCE),
    NURBS_NAMED(NURBS_ERROR_CONTRADICTION),
    NURBS_NAMED(NURBS_ERROR_CONSTRAINT),
    NURBS_NAMED(NURBS_ERROR_OFF_POLYGON),
    NURBS_NAMED(NURBS_ERROR_RULE),
    NURBS_NAMED(NURBS_ERROR_SCHOENBERG_WHITNEY),
    NURBS_NAMED(NURBS_ERROR_RANK),
    NURBS_NAMED(NURBS_ERROR_SCALE),
    NURBS_NAMED(NURBS_ERROR_ORIENTATION),
    NURBS_NAMED(NURBS_ERROR_SAME),
    NURBS_NAMED(NURBS_ERROR_CROSSING),
    NURBS_NAMED(NURBS_ERROR_CONTINUITY),
    NURBS_NAMED(NURBS_ERROR_WEIGHT_SIGN),
    NURBS_NAMED(NURBS_ERROR_OUTSIDE_DOMAIN),
    NURBS_NAMED(NURBS_ERROR_NOT_REPRESENTABLE),
    NURBS_NAMED(NURBS_ERROR_KNOTS_MERGE),
    NURBS_NAMED(NURBS_ERROR_NOT_CONVERGED),
    NURBS_NAMED(NURBS_ERROR_MEMORY),
    NURBS_NAMED(NURBS_ERROR_FILE),
    NURBS_NAMED(NURBS_ERROR_TOO_LARGE),
    NURBS_NAMED(NURBS_ERROR_CANCELLED),
    NURBS_NAMED(NURBS_ERROR_WORK),
    NURBS_NAMED(NURBS_ERROR_FORMAT),
    NURBS_NAMED(NURBS_ERROR_TRUNCATED),
    NURBS_NAMED(NURBS_ERROR_SYNTAX),
    NURBS_NAMED(NURBS_ERROR_UNSUPPORTED),
    NURBS_NAMED(NURBS_ERROR_CHECKSUM),
    NURBS_NAMED(NURBS_ERROR_VERSION),
    NURBS_NAMED(NURBS_ERROR_CYCLE),
    NURBS_NAMED(NURBS_ERROR_INTERNAL),
};

} // namespace

#undef NURBS_NAMED

const char *nurbs_status_name(nurbs_status status) {
    const auto *const found = std::ranges::find(status_names, status, &NamedStatus::status);
    return found == std::end(status_names) ? "NURBS_ERROR_UNKNOWN" : found->name;
}
