// SPDX-License-Identifier: MIT
// Version, statuses and the calling thread's last message.
#include "guard.h"

#include "base/error.h"

#include <algorithm>
#include <cstring>
#include <cxxabi.h>
#include <new>
#include <stdexcept>

namespace {

// A plain array: thread-local without constructor or destructor, so that it works when memory is short and as
// threads end.
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

#define NURBS_NAME_CASE(status)                                                                              \
    case status:                                                                                             \
        return #status

const char *nurbs_status_name(nurbs_status status) {
    switch (status) {
        NURBS_NAME_CASE(NURBS_OK);
        NURBS_NAME_CASE(NURBS_ERROR_NULL);
        NURBS_NAME_CASE(NURBS_ERROR_AXES);
        NURBS_NAME_CASE(NURBS_ERROR_AXIS);
        NURBS_NAME_CASE(NURBS_ERROR_DEGREE);
        NURBS_NAME_CASE(NURBS_ERROR_COUNT);
        NURBS_NAME_CASE(NURBS_ERROR_TOO_FEW_POINTS);
        NURBS_NAME_CASE(NURBS_ERROR_OVERFLOW);
        NURBS_NAME_CASE(NURBS_ERROR_SIZE);
        NURBS_NAME_CASE(NURBS_ERROR_DIMENSION);
        NURBS_NAME_CASE(NURBS_ERROR_STRIDE);
        NURBS_NAME_CASE(NURBS_ERROR_OVERLAP);
        NURBS_NAME_CASE(NURBS_ERROR_FLAGS);
        NURBS_NAME_CASE(NURBS_ERROR_ORDER);
        NURBS_NAME_CASE(NURBS_ERROR_KNOT_NOT_FINITE);
        NURBS_NAME_CASE(NURBS_ERROR_KNOTS_DECREASING);
        NURBS_NAME_CASE(NURBS_ERROR_END_MULTIPLICITY);
        NURBS_NAME_CASE(NURBS_ERROR_MULTIPLICITY);
        NURBS_NAME_CASE(NURBS_ERROR_EMPTY_DOMAIN);
        NURBS_NAME_CASE(NURBS_ERROR_POINT_NOT_FINITE);
        NURBS_NAME_CASE(NURBS_ERROR_WEIGHT_NOT_FINITE);
        NURBS_NAME_CASE(NURBS_ERROR_WEIGHT_NEGATIVE);
        NURBS_NAME_CASE(NURBS_ERROR_WEIGHTS_VANISH);
        NURBS_NAME_CASE(NURBS_ERROR_PARAMETER_NOT_FINITE);
        NURBS_NAME_CASE(NURBS_ERROR_PERIODIC_KNOTS);
        NURBS_NAME_CASE(NURBS_ERROR_PERIODIC_POINTS);
        NURBS_NAME_CASE(NURBS_ERROR_TIMES);
        NURBS_NAME_CASE(NURBS_ERROR_OPTIONS);
        NURBS_NAME_CASE(NURBS_ERROR_INDEX);
        NURBS_NAME_CASE(NURBS_ERROR_DIRECTION);
        NURBS_NAME_CASE(NURBS_ERROR_END_KNOT);
        NURBS_NAME_CASE(NURBS_ERROR_NOT_A_KNOT);
        NURBS_NAME_CASE(NURBS_ERROR_MATRIX);
        NURBS_NAME_CASE(NURBS_ERROR_RATIONAL);
        NURBS_NAME_CASE(NURBS_ERROR_INCOMPATIBLE);
        NURBS_NAME_CASE(NURBS_ERROR_GAP);
        NURBS_NAME_CASE(NURBS_ERROR_TOLERANCE);
        NURBS_NAME_CASE(NURBS_ERROR_NOT_PERIODIC);
        NURBS_NAME_CASE(NURBS_ERROR_END_WEIGHTS);
        NURBS_NAME_CASE(NURBS_ERROR_FACTOR);
        NURBS_NAME_CASE(NURBS_ERROR_PERIODIC);
        NURBS_NAME_CASE(NURBS_ERROR_END);
        NURBS_NAME_CASE(NURBS_ERROR_BASIS);
        NURBS_NAME_CASE(NURBS_ERROR_NOT_MONOTONE);
        NURBS_NAME_CASE(NURBS_ERROR_ANGLE);
        NURBS_NAME_CASE(NURBS_ERROR_LENGTH);
        NURBS_NAME_CASE(NURBS_ERROR_COLLINEAR);
        NURBS_NAME_CASE(NURBS_ERROR_CONIC);
        NURBS_NAME_CASE(NURBS_ERROR_FORM);
        NURBS_NAME_CASE(NURBS_ERROR_TANGENT);
        NURBS_NAME_CASE(NURBS_ERROR_TWIST);
        NURBS_NAME_CASE(NURBS_ERROR_TWIST_RULE);
        NURBS_NAME_CASE(NURBS_ERROR_INFLUENCE);
        NURBS_NAME_CASE(NURBS_ERROR_CONTRADICTION);
        NURBS_NAME_CASE(NURBS_ERROR_CONSTRAINT);
        NURBS_NAME_CASE(NURBS_ERROR_OFF_POLYGON);
        NURBS_NAME_CASE(NURBS_ERROR_RULE);
        NURBS_NAME_CASE(NURBS_ERROR_SCHOENBERG_WHITNEY);
        NURBS_NAME_CASE(NURBS_ERROR_RANK);
        NURBS_NAME_CASE(NURBS_ERROR_SCALE);
        NURBS_NAME_CASE(NURBS_ERROR_ORIENTATION);
        NURBS_NAME_CASE(NURBS_ERROR_CONTINUITY);
        NURBS_NAME_CASE(NURBS_ERROR_WEIGHT_SIGN);
        NURBS_NAME_CASE(NURBS_ERROR_OUTSIDE_DOMAIN);
        NURBS_NAME_CASE(NURBS_ERROR_NOT_REPRESENTABLE);
        NURBS_NAME_CASE(NURBS_ERROR_KNOTS_MERGE);
        NURBS_NAME_CASE(NURBS_ERROR_NOT_CONVERGED);
        NURBS_NAME_CASE(NURBS_ERROR_MEMORY);
        NURBS_NAME_CASE(NURBS_ERROR_FILE);
        NURBS_NAME_CASE(NURBS_ERROR_TOO_LARGE);
        NURBS_NAME_CASE(NURBS_ERROR_CANCELLED);
        NURBS_NAME_CASE(NURBS_ERROR_WORK);
        NURBS_NAME_CASE(NURBS_ERROR_FORMAT);
        NURBS_NAME_CASE(NURBS_ERROR_TRUNCATED);
        NURBS_NAME_CASE(NURBS_ERROR_SYNTAX);
        NURBS_NAME_CASE(NURBS_ERROR_UNSUPPORTED);
        NURBS_NAME_CASE(NURBS_ERROR_CHECKSUM);
        NURBS_NAME_CASE(NURBS_ERROR_VERSION);
        NURBS_NAME_CASE(NURBS_ERROR_INTERNAL);
    default:
        return "NURBS_ERROR_UNKNOWN";
    }
}
