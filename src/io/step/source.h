// SPDX-License-Identifier: MIT
// The common base of the readers of STEP: the units, names and notes of a file, and the curves and surfaces
// that belong to no face.
#pragma once

#include "base/watch.h"
#include "io/read_settings.h"
#include "io/step/contexts.h"
#include "io/step/geometry/geometry.h"
#include "io/step/layers.h"
#include "io/step/structure/exchange.h"
#include "model/model.h"
#include "model/shapes/surface_spline.h"

#include <string>
#include <vector>

namespace nrb::io::step {

class Source {
public:
    // Throws Status::format for schemas of other kinds, options for a unit that cannot be reached. The file
    // must outlive this object.
    Source(const Exchange &file, const ReadSettings &settings);

protected:
    // Calls add(place) for the instances for which wants(place) is true. An error that it throws becomes a
    // note.
    template <class Wants, class Add>
    void read_all(Wants &&wants, Add &&add) {
        Steps steps(instances_.size());
        for (int64_t place = 0; place < instances_.size(); ++place) {
            const bool wanted = wants(place);
            if (wanted) {
                try {
                    add(place);
                } catch (const Error &error) {
                    note_error(instances_[place], error);
                }
            }
            steps.next(wanted ? work_of_an_entity : 1);
        }
    }
    [[nodiscard]] bool is(int64_t place, Kind kind) const noexcept {
        return instances_[place].kind() == kind;
    }

    // The measures of the instance at a place, as factors to the unit of the model.
    [[nodiscard]] Units units_of(int64_t place) const;

    // Returns what make() returns. The size of a spline is counted before it is kept, even if it shares its
    // points.
    template <class Make>
    SplinePtr made(const Instance &instance, Make &&make) {
        return naming(instances_, instance, [&] {
            entities_.spend(Entities::size_of_a_shape);
            SplinePtr spline = make();
            entities_.spend(spline->point_count() * spline->width());
            return spline;
        });
    }
    // The same for a surface, which is noted if it is only an approximation.
    template <class Make>
    SplinePtr made_surface(const Instance &instance, Make &&make) {
        double distance = 0;
        SplinePtr spline = made(instance, [&] {
            model::MadeSurface surface = make();
            distance = surface.distance;
            return surface.spline;
        });
        note_approximation(instance, distance, units_of(instances_.find(instance.number())).tolerance);
        return spline;
    }

    // The curves and surfaces that are not parts of others.
    std::vector<model::NamedSpline> free_splines(const Layers &layers);

    // Notes the items of shapes that are not read and, unless placements are read, the instances that place
    // parts.
    void note_items(bool placements_read);
    void note_unread(const Instance &instance, const char *what);
    // Notes an error. The label of the instance comes before the message, unless the message begins with its
    // number.
    void note_error(const Instance &instance, const Error &error);
    // Notes a surface that is only near the one in the file; a distance of 0 is not noted. `stated`: the
    // tolerance that the file states.
    void note_approximation(const Instance &instance, double distance, double stated);
    void add_note(int64_t number, Status reason, const char *text);
    // The model, with its notes in the order of their instances.
    model::Model finished();

    const Instances &instances_;
    Entities entities_;
    ReadSettings settings_;
    Contexts contexts_;
    std::vector<bool> part_; // find_parts()
    model::Model model_;

private:
    static constexpr int64_t work_of_an_entity = 1000; // besides that of its numbers
    void note_item(const Instance &owner, int64_t number);

    double tolerance_; // 0: those of the contexts
};

} // namespace nrb::io::step
