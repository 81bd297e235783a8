#include "lists.h"

namespace nrb::capi {

std::string place_name(int64_t index, const std::vector<int64_t> &counts) {
    std::string name;
    for (size_t k = counts.size(); k-- > 0; index /= counts[k]) {
        name = std::to_string(index % counts[k]) + (name.empty() ? "" : ",") + name;
    }
    return name;
}

void give_list(const std::vector<SplinePtr> &pieces, const std::vector<int64_t> &counts, nurbs_list **out) {
    auto list = std::make_unique<nurbs_list>();
    list->document.splines.reserve(pieces.size());
    for (const SplinePtr &piece : pieces) {
        list->document.splines.push_back({place_name(std::ssize(list->document.splines), counts), piece});
    }
    *out = list.release();
}

std::vector<SplinePtr> splines_of(int64_t count, const nurbs *const *handles, const char *name) {
    if (count < 1) {
        fail(NURBS_ERROR_COUNT, "count = %lld, expected at least 1", static_cast<long long>(count));
    }
    require(handles, name);
    std::vector<SplinePtr> splines;
    for (int64_t i = 0; i < count; ++i) {
        if (handles[i] == nullptr) {
            fail(NURBS_ERROR_NULL, "%s[%lld] is NULL", name, static_cast<long long>(i));
        }
        splines.push_back(handles[i]->spline);
    }
    return splines;
}

} // namespace nrb::capi
