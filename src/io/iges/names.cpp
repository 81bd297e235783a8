// SPDX-License-Identifier: MIT
#include "io/iges/names.h"

#include "base/error.h"
#include "io/iges/text.h"
#include "io/iges/types.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace nrb::io::iges {
namespace {

constexpr int64_t name_form = 15;

// In increasing order.
constexpr std::pair<int, const char *> type_names[] = {
    {0, "null"},
    {100, "circular arc"},
    {102, "composite curve"},
    {104, "conic arc"},
    {106, "copious data"},
    {108, "plane"},
    {110, "line"},
    {112, "parametric spline curve"},
    {114, "parametric spline surface"},
    {116, "point"},
    {118, "ruled surface"},
    {120, "surface of revolution"},
    {122, "tabulated cylinder"},
    {123, "direction"},
    {124, "transformation matrix"},
    {126, "rational B-spline curve"},
    {128, "rational B-spline surface"},
    {130, "offset curve"},
    {140, "offset surface"},
    {141, "boundary"},
    {142, "curve on a parametric surface"},
    {143, "bounded surface"},
    {144, "trimmed surface"},
    {186, "manifold solid"},
    {190, "plane surface"},
    {192, "cylindrical surface"},
    {194, "conical surface"},
    {196, "spherical surface"},
    {198, "toroidal surface"},
    {212, "general note"},
    {308, "subfigure definition"},
    {314, "color definition"},
    {402, "associativity"},
    {404, "drawing"},
    {406, "property"},
    {408, "subfigure instance"},
    {410, "view"},
    {502, "vertex list"},
    {504, "edge list"},
    {508, "loop"},
    {510, "face"},
    {514, "shell"},
};

std::string label_name(const Entry &entry) {
    std::string name = printable(entry.label);
    return entry.subscript == 0 ? name : name + "(" + std::to_string(entry.subscript) + ")";
}

} // namespace

const char *type_name(int type) noexcept {
    const auto *found = std::lower_bound(std::begin(type_names), std::end(type_names), type,
                                         [](const auto &known, int wanted) { return known.first < wanted; });
    return found != std::end(type_names) && found->first == type ? found->second : "entity";
}

// The record holds the number of properties, then the name. An unreadable property gives no name.
const std::string &Names::read_property(size_t index) {
    const auto known = properties_.find(index);
    if (known != properties_.end()) {
        return known->second;
    }
    std::string &name = properties_[index];
    const Entry &entry = directory_.entries()[index];
    if (entry.type != property_type || entry.form != name_form || !entry.damage.empty()) {
        return name;
    }
    try {
        Record record = data_.take(entry);
        record.skip(1);
        name = printable(trim(record.string("name")));
    } catch (const Error &) {
        name.clear();
    }
    return name;
}

// Two groups end a record: the number of associativities and their pointers, then the number of properties
// and their pointers.
std::string Names::property_name(Record &record) {
    record.skip(record.integer("number of associativities"));
    const int64_t count = std::min(record.integer("number of properties"), record.remaining());
    for (int64_t i = 0; i < count; ++i) {
        const std::optional<size_t> index = directory_.find(record.integer("property", i));
        std::string name = index ? read_property(*index) : std::string();
        if (!name.empty()) {
            return name;
        }
    }
    return {};
}

bool Names::used(size_t index) const noexcept {
    const auto found = properties_.find(index);
    return found != properties_.end() && !found->second.empty();
}

std::string Names::name(const Entry &entry, Record &record) {
    std::string name;
    try {
        name = property_name(record);
    } catch (const Error &) {
        name.clear(); // trailing garbage does not invalidate the geometry before it
    }
    if (!name.empty()) {
        return name;
    }
    return entry.label.empty() ? std::to_string(entry.type) + "#" + std::to_string(entry.line)
                               : label_name(entry);
}

} // namespace nrb::io::iges
