// SPDX-License-Identifier: MIT
// Watched calls: long calls whose progress the caller follows, whose work it limits, and which it may cancel.
#pragma once

#include "guard.h"
#include "outputs.h"

#include "base/watch.h"

#include <vector>

namespace nrb::capi {

Watch::Wishes wishes_of(const nurbs_call_options *call);

// Runs body(), which returns a status, under the watch that the call options describe.
template <class Body>
nurbs_status watched(const nurbs_call_options *call, Body &&body) {
    nurbs_status status = NURBS_OK;
    const nurbs_status wishes = guard([&] {
        const Watch watch(wishes_of(call));
        status = body();
    });
    return wishes == NURBS_OK ? status : wishes;
}

// The same for a body that makes a new handle, which is NULL also if the call options are wrong.
template <class Handle, class Body>
nurbs_status watched(const nurbs_call_options *call, Handle **out, Body &&body) {
    if (out != nullptr) {
        *out = nullptr;
    }
    return watched(call, body);
}

// The buffer to which a batch writes its results one after the other, and from which commit() copies them to
// the caller's array once all are known: any of them may run out of memory, or end a watched call.
class StagedRecords {
public:
    explicit StagedRecords(const Records &wanted);
    StagedRecords(const StagedRecords &) = delete;
    StagedRecords &operator=(const StagedRecords &) = delete;

    [[nodiscard]] const Records &view() const noexcept { return view_; }
    void commit() const noexcept;

private:
    Records wanted_, view_;
    std::vector<double> values_;
};

class StagedStatus {
public:
    StagedStatus(int32_t *wanted, int64_t count);
    StagedStatus(const StagedStatus &) = delete;
    StagedStatus &operator=(const StagedStatus &) = delete;

    [[nodiscard]] int32_t *data() noexcept { return values_.empty() ? wanted_ : values_.data(); }
    void commit() const noexcept { std::copy(values_.begin(), values_.end(), wanted_); }

private:
    int32_t *wanted_;
    std::vector<int32_t> values_;
};

} // namespace nrb::capi
