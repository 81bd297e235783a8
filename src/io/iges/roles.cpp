// SPDX-License-Identifier: MIT
#include "io/iges/roles.h"

#include "base/error.h"
#include "io/iges/types.h"

namespace nrb::io::iges {
namespace {

class PlaneMarker {
public:
    PlaneMarker(const Directory &directory, ParameterData &data)
        : directory_(directory), data_(data), marked_(directory.entries().size(), false) {}

    std::vector<bool> run() {
        for (size_t i = 0; i < marked_.size(); ++i) {
            start_from(i);
        }
        while (!pending_.empty()) {
            const size_t next = pending_.back();
            pending_.pop_back();
            const bool composite = directory_.entries()[next].type == composite_type;
            read_entry(next, composite ? &PlaneMarker::read_composite : &PlaneMarker::read_offset_curve);
        }
        return std::move(marked_);
    }

private:
    using Reader = void (PlaneMarker::*)(Record &);

    void start_from(size_t index) {
        const Entry &entry = directory_.entries()[index];
        if (entry.type == curve_on_surface_type) {
            read_entry(index, &PlaneMarker::read_curve_on_surface);
        } else if (entry.type == boundary_type) {
            read_entry(index, &PlaneMarker::read_boundary);
        } else if (entry.parameter_plane) {
            mark(entry.line);
        }
    }

    // These entities become notes in any case, so that errors in them need no report here.
    void read_entry(size_t index, Reader reader) {
        const Entry &entry = directory_.entries()[index];
        if (!entry.damage.empty()) {
            return;
        }
        try {
            Record record = data_.take(entry);
            (this->*reader)(record);
        } catch (const Error &) {
            return;
        }
    }

    // Each entry is marked at most once, so that cycles of composite curves end.
    void mark(int64_t pointer) {
        const std::optional<size_t> index = directory_.find(pointer);
        if (!index || marked_[*index]) {
            return;
        }
        marked_[*index] = true;
        if (const int type = directory_.entries()[*index].type;
            type == composite_type || type == offset_curve_type) {
            pending_.push_back(*index);
        }
    }

    // How created, surface, curve in the parameter plane, curve in space, preference.
    void read_curve_on_surface(Record &record) {
        record.skip(2);
        mark(record.integer("parameter-plane curve"));
    }

    // Type, preference, surface, number of curves; for each: curve in space, sense, number of parameter-plane
    // curves, their pointers.
    void read_boundary(Record &record) {
        record.skip(3);
        for (int64_t curves = record.integer("number of curves"); curves > 0 && record.remaining() > 0;
             --curves) {
            record.skip(2);
            mark_list(record);
        }
    }

    void read_composite(Record &record) { mark_list(record); }
    void read_offset_curve(Record &record) { mark(record.integer("curve")); }

    void mark_list(Record &record) {
        for (int64_t n = record.integer("number of curves"); n > 0 && record.remaining() > 0; --n) {
            mark(record.integer("curve"));
        }
    }

    const Directory &directory_;
    ParameterData &data_;
    std::vector<bool> marked_;
    std::vector<size_t> pending_;
};

} // namespace

std::vector<bool> find_parameter_plane_curves(const Directory &directory, ParameterData &data) {
    return PlaneMarker(directory, data).run();
}

} // namespace nrb::io::iges
