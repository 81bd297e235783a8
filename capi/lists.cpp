// Lists of splines: what a file held, or the parts of a spline.
#include "lists.h"

#include "guard.h"
#include "outputs.h"

#include "base/checked.h"

#include <cstring>

namespace nrb::capi {

void give_list(std::vector<SplinePtr> splines, nurbs_list **out) {
    model::Document document;
    document.splines.reserve(splines.size());
    for (SplinePtr &spline : splines) {
        document.splines.push_back({std::to_string(document.splines.size()), std::move(spline)});
    }
    *out = new nurbs_list{std::move(document)};
}

std::vector<SplinePtr> splines_of(int64_t count, const nurbs *const *handles, const char *name) {
    check_at_least(count, 1, "count");
    checked_array(count, name);
    require(handles, name);
    std::vector<SplinePtr> splines;
    for (int64_t i = 0; i < count; ++i) {
        if (handles[i] == nullptr) {
            fail(Status::null, "%s[%lld] is NULL", name, static_cast<long long>(i));
        }
        splines.push_back(handles[i]->spline);
    }
    return splines;
}

} // namespace nrb::capi

using namespace nrb;
using namespace nrb::capi;

int64_t nurbs_list::size() const noexcept {
    return parts ? parts->size() : std::ssize(document.splines);
}

SplinePtr nurbs_list::spline(int64_t index) const {
    return parts ? parts->part(index) : document.splines[static_cast<size_t>(index)].spline;
}

// Of a part: "2" for a curve, "2,0" for a surface.
std::string nurbs_list::name(int64_t index) const {
    if (!parts) {
        return document.splines[static_cast<size_t>(index)].name;
    }
    if (!named_by_axes) {
        return std::to_string(index);
    }
    std::string name;
    for (int k = parts->axes(); k-- > 0; index /= parts->parts(k)) {
        name.insert(0, std::to_string(index % parts->parts(k)) + (name.empty() ? "" : ","));
    }
    return name;
}

namespace {

const nurbs_list &checked(const nurbs_list *list) {
    require(list, "list");
    return *list;
}

void check_index(int64_t index, int64_t size) {
    if (index < 0 || index >= size) {
        fail(Status::index, "index = %lld, expected 0 to %lld", static_cast<long long>(index),
             static_cast<long long>(size) - 1);
    }
}

void check_buffer(const char *buf, int64_t cap) {
    check_length(cap, "cap");
    if (cap > 0) {
        require(buf, "buf");
    }
}

void copy_text(const std::string &text, char *buf, int64_t cap, int64_t *length) noexcept {
    if (cap > 0) {
        const auto copied = std::min(static_cast<int64_t>(text.size()), cap - 1);
        std::memcpy(buf, text.data(), static_cast<size_t>(copied));
        buf[copied] = '\0';
    }
    if (length != nullptr) {
        *length = static_cast<int64_t>(text.size());
    }
}

} // namespace

nurbs_status nurbs_list_count(const nurbs_list *list, int64_t *count) {
    return guard([&] {
        const int64_t size = checked(list).size();
        require(count, "count");
        *count = size;
    });
}

nurbs_status nurbs_list_get(const nurbs_list *list, int64_t index, nurbs **out) {
    return guard([&] {
        require_out(out);
        check_index(index, checked(list).size());
        give(list->spline(index), out);
    });
}

nurbs_status nurbs_list_name(const nurbs_list *list, int64_t index, char *buf, int64_t cap, int64_t *length) {
    return guard([&] {
        check_index(index, checked(list).size());
        check_buffer(buf, cap);
        copy_text(list->name(index), buf, cap, length);
    });
}

nurbs_status nurbs_list_note_count(const nurbs_list *list, int64_t *count) {
    return guard([&] {
        const model::Document &document = checked(list).document;
        require(count, "count");
        *count = static_cast<int64_t>(document.notes.size());
    });
}

nurbs_status nurbs_list_note(const nurbs_list *list, int64_t index, int32_t *entity_type, int64_t *line,
                             nurbs_status *reason, char *buf, int64_t cap, int64_t *length) {
    return guard([&] {
        const std::vector<model::Note> &notes = checked(list).document.notes;
        check_index(index, std::ssize(notes));
        const model::Note &note = notes[static_cast<size_t>(index)];
        check_buffer(buf, cap);
        put(entity_type, int32_t{note.entity_type});
        put(line, note.line);
        put(reason, static_cast<nurbs_status>(note.reason));
        copy_text(note.text, buf, cap, length);
    });
}

nurbs_status nurbs_list_unit(const nurbs_list *list, double *metres) {
    return guard([&] {
        const model::Document &document = checked(list).document;
        require(metres, "metres");
        *metres = document.metres_per_unit;
    });
}

void nurbs_list_destroy(nurbs_list *list) {
    delete list;
}
