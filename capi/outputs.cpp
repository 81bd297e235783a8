// SPDX-License-Identifier: MIT
#include "outputs.h"

#include "base/checked.h"

namespace nrb::capi {

Outputs::Outputs(int64_t count, const int32_t *status)
    : count_(checked_array(count, "status")), status_(memory("status", status, count)) {}

Records Outputs::add(const Wanted &wanted) {
    if (wanted.data == nullptr) {
        return {nullptr, count_, wanted.width, 0, 0};
    }
    const Records out =
        output(wanted.name, wanted.data, count_, wanted.width, wanted.stride, wanted.component_stride);
    check(wanted.name, read_only(out));
    outputs_[size_++] = {wanted.name, out};
    return out;
}

void Outputs::check(const char *name, const ConstRecords &input) const {
    for (size_t i = 0; i < size_; ++i) {
        check_overlap(outputs_[i].name, outputs_[i].records, name, input);
    }
    check_apart({status_}, {memory(name, input.data, input.extent())});
}

void Outputs::check(const Memory &input) const {
    for (size_t i = 0; i < size_; ++i) {
        check_apart({outputs_[i].memory()}, {input});
    }
    check_apart({status_}, {input});
}

} // namespace nrb::capi
