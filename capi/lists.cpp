// SPDX-License-Identifier: MIT
// Lists of splines: the contents of a file, the parts of one spline, or any splines put together.
#include "lists.h"

#include "guard.h"
#include "outputs.h"

#include "base/checked.h"

#include <algorithm>
#include <cstring>
#include <string>

namespace nrb::capi {

void give_list(std::vector<SplinePtr> splines, nurbs_list **out) {
    NamedSplines named;
    named.reserve(splines.size());
    for (SplinePtr &spline : splines) {
        named.push_back({std::to_string(named.size()), std::move(spline)});
    }
    give_list(std::move(named), out);
}

void give_list(NamedSplines splines, nurbs_list **out) {
    *out = new nurbs_list{std::move(splines)};
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

} // namespace nrb::capi

using namespace nrb;
using namespace nrb::capi;

namespace {

// The name of a part: "2" for a curve, "2,0" for a surface.
std::string name_by_axes(const refine::PartedSpline &parts, int64_t index) {
    std::string name;
    for (int k = parts.axes(); k-- > 0; index /= parts.parts(k)) {
        name.insert(0, std::to_string(index % parts.parts(k)) + (name.empty() ? "" : ","));
    }
    return name;
}

// The same queries for each kind of contents.

int64_t size_of(const NamedSplines &splines) noexcept {
    return std::ssize(splines);
}
int64_t size_of(const Parts &parts) noexcept {
    return parts.spline.size();
}
int64_t size_of(const model::Model &model) noexcept {
    return size_of(model.splines);
}

SplinePtr spline_at(const NamedSplines &splines, int64_t index) {
    return splines[static_cast<size_t>(index)].spline;
}
SplinePtr spline_at(const Parts &parts, int64_t index) {
    return parts.spline.part(index);
}
SplinePtr spline_at(const model::Model &model, int64_t index) {
    return spline_at(model.splines, index);
}

std::string name_at(const NamedSplines &splines, int64_t index) {
    return splines[static_cast<size_t>(index)].name;
}
std::string name_at(const Parts &parts, int64_t index) {
    return parts.named_by_axes ? name_by_axes(parts.spline, index) : std::to_string(index);
}
std::string name_at(const model::Model &model, int64_t index) {
    return name_at(model.splines, index);
}

const nurbs_list &checked(const nurbs_list *list) {
    require(list, "list");
    return *list;
}

int64_t checked_size(const nurbs_list *list) {
    return std::visit([](const auto &contents) { return size_of(contents); }, checked(list).contents);
}

// The contents of a list that has notes and a unit: one from a file, from bytes or from nurbs_list_create().
// An empty model for any other list.
const model::Model &model_of(const nurbs_list *list) {
    static const model::Model nothing;
    const auto *const model = std::get_if<model::Model>(&checked(list).contents);
    return model == nullptr ? nothing : *model;
}

void check_index(int64_t index, int64_t size) {
    if (index < 0 || index >= size) {
        fail(Status::index, "index = %lld, expected 0 to %lld", static_cast<long long>(index),
             static_cast<long long>(size) - 1);
    }
}

const char *checked_name(const char *const *names, int64_t index) {
    if (names[index] == nullptr) {
        fail(Status::null, "names[%lld] is NULL", static_cast<long long>(index));
    }
    return names[index];
}

} // namespace

namespace nrb::capi {

const model::Model &contents_of(const nurbs_list *list, model::Model &room) {
    if (const auto *const model = std::get_if<model::Model>(&checked(list).contents)) {
        return *model;
    }
    std::visit(
        [&](const auto &contents) {
            for (int64_t i = 0; i < size_of(contents); ++i) {
                room.splines.push_back({name_at(contents, i), spline_at(contents, i)});
            }
        },
        list->contents);
    return room;
}

} // namespace nrb::capi

nurbs_status nurbs_list_create(int64_t count, const nurbs *const *splines, const char *const *names,
                               double metres, nurbs_list **out) {
    return guard([&] {
        require_out(out);
        check_length(count, "count");
        std::vector<SplinePtr> given;
        if (count > 0) {
            given = splines_of(count, splines, "splines");
        }
        model::Model made{{}, {}, metres};
        for (SplinePtr &spline : given) {
            const int64_t index = size_of(made);
            std::string name = names == nullptr ? std::to_string(index) : checked_name(names, index);
            made.splines.push_back({std::move(name), std::move(spline)});
        }
        model::check_metres(metres);
        *out = new nurbs_list{std::move(made)};
    });
}

nurbs_status nurbs_list_count(const nurbs_list *list, int64_t *count) {
    return guard([&] {
        const int64_t size = checked_size(list);
        require(count, "count");
        *count = size;
    });
}

nurbs_status nurbs_list_get(const nurbs_list *list, int64_t index, nurbs **out) {
    return guard([&] {
        require_out(out);
        check_index(index, checked_size(list));
        give(std::visit([&](const auto &contents) { return spline_at(contents, index); }, list->contents),
             out);
    });
}

nurbs_status nurbs_list_name(const nurbs_list *list, int64_t index, char *buf, int64_t cap, int64_t *length) {
    return guard([&] {
        check_index(index, checked_size(list));
        check_buffer(buf, cap);
        const std::string name =
            std::visit([&](const auto &contents) { return name_at(contents, index); }, list->contents);
        copy_text(name, buf, cap, length);
    });
}

nurbs_status nurbs_list_note_count(const nurbs_list *list, int64_t *count) {
    return guard([&] {
        const model::Model &model = model_of(list);
        require(count, "count");
        *count = static_cast<int64_t>(model.notes.size());
    });
}

nurbs_status nurbs_list_note(const nurbs_list *list, int64_t index, int32_t *entity_type, int64_t *line,
                             nurbs_status *reason, char *buf, int64_t cap, int64_t *length) {
    return guard([&] {
        const std::vector<model::Note> &notes = model_of(list).notes;
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
        const model::Model &model = model_of(list);
        require(metres, "metres");
        *metres = model.metres_per_unit;
    });
}

void nurbs_list_destroy(nurbs_list *list) {
    delete list;
}
