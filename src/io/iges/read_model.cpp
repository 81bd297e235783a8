// SPDX-License-Identifier: MIT
#include "io/iges/read_model.h"

#include "base/watch.h"
#include "bounds/box.h"
#include "io/faces/make_face.h"
#include "io/iges/geometry/shapes.h"
#include "io/iges/global.h"
#include "io/iges/lines.h"
#include "io/iges/model/assembly.h"
#include "io/iges/model/colours.h"
#include "io/iges/model/edges.h"
#include "io/iges/model/face_source.h"
#include "io/iges/model/levels.h"
#include "io/iges/model/uses.h"
#include "io/iges/source.h"
#include "io/iges/types.h"
#include "model/from_faces.h"
#include "model/numbering.h"

#include <algorithm>

namespace nrb::io {
namespace {

using iges::Entry;
using iges::FaceSource;
using iges::LoopReader;
using iges::LoopSource;

class ModelReader : public iges::Source {
public:
    ModelReader(std::span<const char> bytes, const iges::Sections &sections, const iges::Global &global,
                const ReadSettings &settings)
        : Source(bytes, sections, global, settings), colours_(entities_), levels_(entities_),
          used_(directory_.entries().size(), false), product_(global.product) {}

    model::Model run() {
        Steps steps(3);
        topology_ = iges::read_topology(entities_, geometry_.units().factor, damages_);
        assembly_ = iges::read_assembly(entities_, geometry_.units().factor, topology_, damages_);
        levels_.read(assembly_.told);
        iges::mark_used(topology_, directory_, used_);
        mark_orientations();
        if (settings_.wants(kind_faces)) {
            edges_ = iges::read_edges(geometry_, topology_, model_, damages_);
        }
        steps.next();
        read_shapes();
        steps.next();
        read_all([](const Entry &) { return true; }, [this](const Entry &entry) { read_entity(entry); });
        steps.next();
        model_.parts = std::move(assembly_.parts);
        model_.parts.front().name = product_;
        model_.uses = std::move(assembly_.uses);
        model::index_uses(model_);
        model::number_solids(model_);
        levels_.make_layers(model_);
        for (model::Edge &edge : model_.edges) {
            if (!edge.uses.empty()) {
                edge.part = model_.faces[static_cast<size_t>(edge.uses.front().face)].part;
            }
        }
        add_notes();
        return finished();
    }

private:
    void add_notes() {
        for (const iges::Damage &damage : damages_) {
            add_note(damage.pointer, damage.reason, damage.text);
        }
    }
    static bool is_topology(int type) noexcept {
        switch (type) {
        case iges::boundary_type:
        case iges::curve_on_surface_type:
        case iges::solid_type:
        case iges::vertex_list_type:
        case iges::edge_list_type:
        case iges::loop_type:
        case iges::shell_type:
        case iges::colour_type:
            return true;
        default:
            return false;
        }
    }

    // Reads all shapes, because which of them are parts of others is known only after that. Errors are
    // reported where the shape is needed.
    void read_shapes() {
        for (const Entry &entry : directory_.entries()) {
            try {
                if (iges::is_surface(entry.type)) {
                    mark_used(geometry_.surface(entry.line).boundary);
                } else if (iges::is_curve(entry.type) && !entry.parameter_plane) {
                    (void)geometry_.curve(entry.line);
                }
            } catch (const Error &) {
                continue;
            }
        }
    }

    void mark_used(int64_t pointer) {
        if (const std::optional<size_t> index = directory_.find(pointer)) {
            used_[*index] = true;
        }
    }

    void read_entity(const Entry &entry) {
        const size_t index = index_of(entry);
        if (entry.type == iges::trimmed_surface_type || entry.type == iges::bounded_surface_type ||
            entry.type == iges::face_type) {
            if (settings_.wants(kind_faces)) {
                read_face(entry);
            }
        } else if (used_[index] || geometry_.is_part(entry.line) || assembly_.told[index] ||
                   is_topology(entry.type)) {
            return;
        } else if (iges::is_surface(entry.type)) {
            if (settings_.wants(kind_faces)) {
                add_face(entry, untrimmed(entry));
            }
        } else if (iges::is_curve(entry.type)) {
            if (settings_.wants(kind_curves)) {
                add_curve(entry);
            }
        } else {
            if (entry.type == iges::matrix_type) {
                transforms_.check(entry.line);
            }
            fail(Status::unsupported, "is not read in this version");
        }
    }
    void add_curve(const Entry &entry) {
        const model::CurvePiece piece =
            entry.parameter_plane ? geometry_.parameter_curve(entry.line) : geometry_.curve(entry.line);
        entities_.spend(iges::Entities::size_of_a_shape + iges::size_of(piece));
        model_.splines.push_back({geometry_.name(entry.line), iges::spline_of(piece), levels_.of(entry)});
    }

    // Faces that could not be read have been reported already.
    void read_face(const Entry &entry) {
        if (const auto trimmed = topology_.trimmed.find(entry.line); trimmed != topology_.trimmed.end()) {
            add_face(entry, trimmed_surface(trimmed->second));
        } else if (const auto bounded = topology_.bounded.find(entry.line);
                   bounded != topology_.bounded.end()) {
            add_face(entry, bounded_surface(bounded->second));
        } else if (const auto face = topology_.faces.find(entry.line); face != topology_.faces.end()) {
            add_face(entry, face_of_shell(face->second));
        }
    }
    // Counts the size of the spline of a surface towards the limits before it is made.
    iges::Surface surface_at(int64_t pointer) {
        iges::Surface surface = geometry_.surface(pointer);
        entities_.spend(iges::Entities::size_of_a_shape + iges::size_of(*surface.shape));
        return surface;
    }
    FaceSource trimmed_surface(const iges::TrimmedSurface &trimmed) {
        const iges::Surface surface = surface_at(trimmed.surface);
        LoopReader reader(geometry_, topology_, surface);
        std::vector<LoopSource> loops;
        if (trimmed.outer != 0) {
            loops.push_back(reader.curve_on_surface(trimmed.outer));
        }
        for (const int64_t inner : trimmed.inner) {
            loops.push_back(reader.curve_on_surface(inner));
        }
        return iges::make_source(geometry_, surface, std::move(loops), trimmed.outer == 0, {});
    }
    FaceSource bounded_surface(const iges::BoundedSurface &bounded) {
        const iges::Surface surface = surface_at(bounded.surface);
        LoopReader reader(geometry_, topology_, surface);
        std::vector<LoopSource> loops;
        for (const int64_t boundary : bounded.boundaries) {
            loops.push_back(reader.boundary(boundary));
        }
        return iges::make_source(geometry_, surface, std::move(loops), bounded.boundaries.empty(), {});
    }
    FaceSource face_of_shell(const iges::FaceEntity &face) {
        const iges::Surface surface = surface_at(face.surface);
        LoopReader reader(geometry_, topology_, surface);
        std::vector<LoopSource> loops;
        for (const int64_t pointer : face.loops) {
            LoopSource loop = reader.loop(pointer, edges_);
            if (!loop.edges.empty() || !loop.curves.empty()) { // not just a pole
                loops.push_back(std::move(loop));
            }
        }
        const bool whole = loops.empty();
        return iges::make_source(geometry_, surface, std::move(loops), whole, reader.poles());
    }
    // A surface on its own, over its whole domain; a plane has a curve that bounds it.
    FaceSource untrimmed(const Entry &entry) {
        const iges::Surface surface = surface_at(entry.line);
        if (surface.hole) {
            fail(Status::unsupported, "is a hole in another plane, which is not read in this version");
        }
        LoopReader reader(geometry_, topology_, surface);
        std::vector<LoopSource> loops;
        if (surface.boundary != 0) {
            loops.push_back(reader.closed_curve(surface.boundary));
        } else if (!model::bounded(*surface.shape)) {
            fail(Status::length, "has no ends, and nothing bounds it");
        }
        return iges::make_source(geometry_, surface, std::move(loops), surface.boundary == 0, {});
    }

    // How the loops of a face are interpreted.
    struct Way {
        bool second;    // by the curves that the file does not prefer
        bool keep_gaps; // gaps are closed by segments in the domain
        const char *told;
    };
    // Tries the curves that the file prefers; else the others, if it has both kinds; else closes gaps. The
    // first error is reported.
    void add_face(const Entry &entry, const FaceSource &source) {
        static constexpr Way ways[] = {{false, false, ""},
                                       {true, false, "the curves are taken that the file does not prefer: "},
                                       {false, true, "loops that are open are closed in the domain: "}};
        std::optional<Error> first;
        for (const Way &way : ways) {
            const bool tried =
                !first || (way.second ? iges::has_two_ways(source) : first->status() == Status::gap);
            if (tried && added(entry, source, way, first)) {
                tell_approximation(entry, source.distance);
                return;
            }
        }
        throw Error(*first);
    }
    bool added(const Entry &entry, const FaceSource &source, const Way &way, std::optional<Error> &first) {
        try {
            add_face(entry, source, way);
        } catch (const Error &error) {
            if (error.status() == Status::too_large) {
                throw;
            }
            first = first ? first : error;
            return false;
        }
        if (first) {
            tell(entry, first->status(), way.told + std::string(first->what()));
        }
        return true;
    }
    void add_face(const Entry &entry, const FaceSource &source, const Way &way) {
        const double resolution = geometry_.units().resolution;
        const double stated = resolution > 0 ? resolution : usual_tolerance;
        const double most = std::max(most_of_stated * stated, iges::largest_gap(*source.surface));
        const double tolerance =
            least_tolerance(stated, most, [&](double wide) { add_face(entry, source, way, wide); });
        if (tolerance > stated) {
            tell(entry, Status::tolerance,
                 std::string("its edges need the tolerance ") + Number(tolerance).text);
        }
    }
    void add_face(const Entry &entry, const FaceSource &source, const Way &way, double tolerance) {
        iges::MadeParts made = iges::parts_of(source, way.second, tolerance, std::ssize(model_.edges) + 1);
        made.parts.keep_gaps = way.keep_gaps;
        model::ModelFace face;
        face.face = make_nested_face(std::move(made.parts), tolerance);
        spend(entities_, *face.face);
        face.name = name_of(entry);
        face.shape = source.shape;
        face.part = assembly_.part(entry.line);
        face.against = oriented(entry.line).against != source.mirrored;
        place_in_solid(entry.line, face);
        face.colour = around_face(entry, [this](const Entry &at) { return colours_.of(at); });
        face.layers = around_face(entry, [this](const Entry &at) {
                          std::vector<int64_t> levels = levels_.of(at);
                          return levels.empty() ? std::nullopt : std::optional(std::move(levels));
                      }).value_or(std::vector<int64_t>());
        iges::add_own_edges(geometry_, *face.face, made.own, face.part, model_);
        model_.faces.push_back(std::move(face));
    }
    [[nodiscard]] std::string name_of(const Entry &entry) const {
        const auto name = topology_.names.find(entry.line);
        return name != topology_.names.end() ? name->second : geometry_.name(entry.line);
    }

    // The shell or the solid around a face or a shell, whether it reverses the normal, and whether the shell
    // is a void.
    struct Around {
        int64_t owner = 0;
        bool against = false;
        bool in_void = false;
    };
    [[nodiscard]] Around around(int64_t pointer) const noexcept {
        const auto found = around_.find(pointer);
        return found == around_.end() ? Around{} : found->second;
    }
    [[nodiscard]] Around oriented(int64_t face) const noexcept {
        const Around shell = around(face);
        return {shell.owner, shell.against != around(shell.owner).against, false};
    }
    void place_in_solid(int64_t pointer, model::ModelFace &face) const {
        const Around shell = around(around(pointer).owner);
        const auto solid = solids_.find(shell.owner);
        if (solid != solids_.end()) {
            face.solid = solid->second;
            face.in_void = shell.in_void;
        }
    }
    void mark_orientations() {
        for (const auto &[owner, shells] : topology_.solids) {
            solids_.emplace(owner, std::ssize(solids_));
            for (const iges::Oriented &shell : shells) {
                around_.try_emplace(shell.pointer, Around{owner, shell.against, &shell != shells.data()});
            }
        }
        for (const auto &[owner, faces] : topology_.shells) {
            for (const iges::Oriented &face : faces) {
                around_.try_emplace(face.pointer, Around{owner, face.against, false});
            }
        }
    }
    // A property of a face itself, or else of its shell, or of its solid.
    template <class Get>
    auto around_face(const Entry &entry, const Get &get) -> decltype(get(entry)) {
        const Entry *at = &entry;
        for (int level = 0; level < 3; ++level) {
            auto own = get(*at);
            const std::optional<size_t> owner = directory_.find(around(at->line).owner);
            if (own || !owner) {
                return own;
            }
            at = &directory_.entries()[*owner];
        }
        return std::nullopt;
    }

    iges::Colours colours_;
    iges::Levels levels_;
    std::vector<bool> used_;
    const std::string &product_;
    std::vector<iges::Damage> damages_;
    iges::TopologyEntities topology_;
    iges::Assembly assembly_;
    iges::EdgeLists edges_;
    std::map<int64_t, Around> around_;  // of faces and shells
    std::map<int64_t, int64_t> solids_; // their numbers
};

} // namespace

double iges::largest_gap(const Spline &surface) {
    constexpr double share = 1e-2;
    return share * bounds::extent(surface);
}

model::Model read_iges_model(std::span<const char> bytes, const ReadSettings &settings) {
    const iges::Sections sections = iges::split_sections(bytes);
    const iges::Global global = iges::read_global(sections.global);
    return ModelReader(bytes, sections, global, settings).run();
}

} // namespace nrb::io
