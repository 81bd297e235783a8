// SPDX-License-Identifier: MIT
#include "io/binary/model_bytes.h"

#include "base/error.h"
#include "io/binary/checked_numbers.h"
#include "io/binary/shape_reader.h"
#include "model/cycles.h"
#include "model/numbering.h"
#include "spline/kind.h"

#include <algorithm>

namespace nrb::io {

namespace {

constexpr uint64_t normal_against = 1, has_colour = 2, in_void = 4;
constexpr size_t at_named = 256;
constexpr size_t words_of_use = 14, words_of_attributes = 7, words_of_edge = 5, words_of_vertex = 3;

size_t part_size(size_t count, size_t words) noexcept {
    return aligned(8 * count * words);
}

} // namespace

ModelBytes::ModelBytes(const model::Model &model) : model_(model) {
    for (const model::NamedSpline &named : model.splines) {
        named_.push_back(splines_.add(named.spline));
    }
    for (const model::ModelFace &face : model.faces) {
        faces_.add(*face.face, splines_);
        face_shapes_.push_back(shapes_.add(face.shape, splines_));
    }
    add_edges();
    add_texts();
    size_ = sum_of_sizes();
}

void ModelBytes::add_texts() {
    for (const model::NamedSpline &named : model_.splines) {
        texts_.add(named.name);
    }
    for (const model::Note &note : model_.notes) {
        texts_.add(note.text);
    }
    for (const model::ModelPart &part : model_.parts) {
        texts_.add(part.name);
    }
    for (const model::Use &use : model_.uses) {
        texts_.add(use.name);
    }
    for (const model::ModelFace &face : model_.faces) {
        texts_.add(face.name);
    }
    for (const std::string &layer : model_.layers) {
        texts_.add(layer);
    }
}

size_t ModelBytes::count_in_layers() const noexcept {
    size_t count = 0;
    model::for_each_in_layers(model_, [&](const std::vector<int64_t> &layers) { count += layers.size(); });
    return count;
}

void ModelBytes::add_edges() {
    std::vector<std::vector<int64_t>> first; // for each loop of each face: its first curve among all
    int64_t next = 0;
    for (const model::ModelFace &face : model_.faces) {
        first.emplace_back();
        for (const face::Loop &loop : face.face->loops()) {
            first.back().push_back(next);
            next += std::ssize(loop);
        }
    }
    coedge_edges_.assign(static_cast<size_t>(next), -1);
    for (const model::Edge &edge : model_.edges) {
        for (const model::EdgeUse &use : edge.uses) {
            const int64_t start = first[static_cast<size_t>(use.face)][static_cast<size_t>(use.loop)];
            coedge_edges_[static_cast<size_t>(start + use.index)] = std::ssize(edges_);
        }
        edges_.push_back({splines_.add(edge.curve), shapes_.add(edge.shape, splines_)});
    }
}

size_t ModelBytes::sum_of_sizes() const noexcept {
    return at_named + part_size(named_.size(), 1) + part_size(model_.notes.size(), 3) +
           part_size(model_.uses.size(), words_of_use) + part_size(model_.faces.size() + named_.size(), 1) +
           part_size(count_in_layers(), 1) + part_size(model_.faces.size(), words_of_attributes) +
           faces_.size_in_bytes() + part_size(coedge_edges_.size(), 1) +
           part_size(edges_.size(), words_of_edge) + part_size(model_.vertices.size(), words_of_vertex) +
           shapes_.size_in_bytes() + texts_.size_in_bytes() + splines_.size_in_bytes();
}

void ModelBytes::write(std::span<unsigned char> out) const noexcept {
    ByteWriter writer(Kind::model, {}, out);
    write_sizes(writer);
    for (const int64_t index : named_) {
        writer.put(index);
    }
    writer.align();
    write_notes(model_.notes, writer);
    write_uses(writer);
    write_faces(writer);
    write_layers(writer);
    faces_.write(writer);
    write_edges(writer);
    shapes_.write(writer);
    texts_.write(writer);
    splines_.write(writer);
    writer.finish();
}

void ModelBytes::write_sizes(ByteWriter &writer) const noexcept {
    const FaceSizes faces = faces_.sizes();
    const ShapeSizes shapes = shapes_.sizes();
    for (const int64_t size :
         {std::ssize(named_), std::ssize(model_.notes), std::ssize(model_.parts), std::ssize(model_.uses),
          faces.faces, faces.loops, faces.coedges, std::ssize(edges_), std::ssize(model_.vertices),
          shapes.pieces, shapes.curves, shapes.surfaces, static_cast<int64_t>(texts_.bytes()),
          splines_.count(), std::ssize(model_.layers), static_cast<int64_t>(count_in_layers())}) {
        writer.put(size);
    }
    writer.put(model_.metres_per_unit + 0.0); // -0 is the same unit
    writer.align();
}

void ModelBytes::write_uses(ByteWriter &writer) const noexcept {
    for (const model::Use &use : model_.uses) {
        writer.put(use.parent);
        writer.put(use.part);
        writer.put(std::span<const double>(use.placement));
    }
    writer.align();
}

void ModelBytes::write_faces(ByteWriter &writer) const noexcept {
    for (size_t i = 0; i < model_.faces.size(); ++i) {
        const model::ModelFace &face = model_.faces[i];
        writer.put(face_shapes_[i]);
        writer.put(face.part);
        writer.put((face.against ? normal_against : 0) | (face.colour ? has_colour : 0) |
                   (face.in_void ? in_void : 0));
        const std::array<double, 3> black{0, 0, 0};
        writer.put(std::span<const double>(face.colour ? *face.colour : black));
        writer.put(face.solid);
    }
    writer.align();
}

void ModelBytes::write_layers(ByteWriter &writer) const noexcept {
    model::for_each_in_layers(model_,
                              [&](const std::vector<int64_t> &layers) { writer.put(std::ssize(layers)); });
    writer.align();
    model::for_each_in_layers(model_, [&](const std::vector<int64_t> &layers) {
        for (const int64_t layer : layers) {
            writer.put(layer);
        }
    });
    writer.align();
}

void ModelBytes::write_edges(ByteWriter &writer) const noexcept {
    for (const int64_t edge : coedge_edges_) {
        writer.put(edge);
    }
    writer.align();
    for (size_t i = 0; i < edges_.size(); ++i) {
        const model::Edge &edge = model_.edges[i];
        for (const int64_t number :
             {edges_[i].curve, edges_[i].shape, edge.vertices[0], edge.vertices[1], edge.part}) {
            writer.put(number);
        }
    }
    writer.align();
    for (const Vector3 &vertex : model_.vertices) {
        for (const double x : {vertex.x, vertex.y, vertex.z}) {
            writer.put(x);
        }
    }
    writer.align();
}

namespace {

struct ModelSizes {
    int64_t named, notes, parts, uses;
    FaceSizes faces;
    int64_t edges, vertices;
    ShapeSizes shapes;
    int64_t text, splines, layers, in_layers;
};

ModelSizes sizes_from(ByteReader &reader) {
    ModelSizes sizes{};
    sizes.named = size_from(reader, "number of splines by name");
    sizes.notes = size_from(reader, "number of notes");
    sizes.parts = size_from(reader, "number of parts");
    sizes.uses = size_from(reader, "number of uses");
    sizes.faces.faces = size_from(reader, "number of faces");
    sizes.faces.loops = size_from(reader, "number of loops");
    sizes.faces.coedges = size_from(reader, "number of curves of loops");
    sizes.edges = size_from(reader, "number of edges");
    sizes.vertices = size_from(reader, "number of vertices");
    sizes.shapes.pieces = size_from(reader, "number of pieces");
    sizes.shapes.curves = size_from(reader, "number of shapes of curves");
    sizes.shapes.surfaces = size_from(reader, "number of shapes of surfaces");
    sizes.text = size_from(reader, "number of bytes of text");
    sizes.splines = size_from(reader, "number of splines");
    sizes.layers = size_from(reader, "number of layers");
    sizes.in_layers = size_from(reader, "number of places in layers");
    return sizes;
}

// Throws Status::syntax if a chain of uses places a part in itself.
void check_acyclic(const std::vector<model::Use> &uses, int64_t parts) {
    std::vector<model::Use> inner;
    std::copy_if(uses.begin(), uses.end(), std::back_inserter(inner),
                 [](const model::Use &use) { return use.parent >= 0; });
    const std::vector<bool> cyclic = model::uses_in_cycles(static_cast<size_t>(parts), inner);
    const auto found = std::find(cyclic.begin(), cyclic.end(), true);
    if (found != cyclic.end()) {
        const model::Use &use = inner[static_cast<size_t>(found - cyclic.begin())];
        fail(Status::syntax, "part %lld is placed in part %lld, which is in it",
             static_cast<long long>(use.part), static_cast<long long>(use.parent));
    }
}

// Reads a model. The constructor takes the parts of the body in their order, which is that of the members.
class ModelParser {
public:
    explicit ModelParser(std::span<const unsigned char> bytes)
        : reader_(bytes, Kind::model), sizes_(sizes_from(reader_)), metres_(reader_.take_double()),
          named_(after_head(sizes_.named, 1)), notes_(notes_from(reader_, sizes_.notes)),
          uses_(reader_.part(sizes_.uses, words_of_use)),
          attributes_(reader_.part(sizes_.faces.faces, words_of_attributes)),
          layer_counts_(reader_.part(sizes_.faces.faces + sizes_.named, 1)),
          layers_(reader_.part(sizes_.in_layers, 1)), faces_(reader_, sizes_.faces),
          coedges_(reader_.part(sizes_.faces.coedges, 1)), edges_(reader_.part(sizes_.edges, words_of_edge)),
          vertices_(reader_.part(sizes_.vertices, words_of_vertex)), shapes_(reader_, sizes_.shapes),
          texts_(texts_from(reader_,
                            sizes_.named + sizes_.notes + sizes_.parts + sizes_.uses + sizes_.faces.faces +
                                sizes_.layers,
                            sizes_.text)),
          text_(texts_.begin()), splines_(splines_from(reader_, sizes_.splines)) {
        reader_.end();
        shapes_.make(splines_);
    }

    model::Model run() {
        model_.metres_per_unit = metres_;
        model::check_metres(metres_);
        take_splines();
        take_parts();
        take_faces();
        take_layers();
        take_edges();
        take_uses_of_edges();
        return std::move(model_);
    }

private:
    ByteReader after_head(int64_t count, size_t words) {
        reader_.align();
        return reader_.part(count, words);
    }
    [[nodiscard]] const SplinePtr &spline(ByteReader &reader, const char *what) const {
        return splines_[static_cast<size_t>(index_from(reader, 0, sizes_.splines, what))];
    }

    void take_splines() {
        for (int64_t i = 0; i < sizes_.named; ++i) {
            model_.splines.push_back({std::move(*text_++), spline(named_, "a spline")});
        }
        for (model::Note &note : notes_) {
            note.text = std::move(*text_++);
        }
        model_.notes = std::move(notes_);
    }

    void take_parts() {
        for (int64_t i = 0; i < sizes_.parts; ++i) {
            model_.parts.push_back({std::move(*text_++)});
        }
        for (int64_t i = 0; i < sizes_.uses; ++i) {
            model::Use use;
            use.parent = index_from(uses_, -1, sizes_.parts, "the parent of a use");
            use.part = index_from(uses_, 0, sizes_.parts, "the part of a use");
            finite_from(uses_, use.placement, "a number of a placement");
            use.name = std::move(*text_++);
            model_.uses.push_back(std::move(use));
        }
        check_acyclic(model_.uses, sizes_.parts);
    }

    void take_faces() {
        for (int64_t i = 0; i < sizes_.faces.faces; ++i) {
            model::ModelFace face;
            face.shape =
                shapes_.surface(index_from(attributes_, -1, sizes_.shapes.surfaces, "the shape of a face"));
            face.part = index_from(attributes_, 0, sizes_.parts, "the part of a face");
            const uint64_t flags =
                flags_from(attributes_, normal_against | has_colour | in_void, "flags of a face");
            face.against = (flags & normal_against) != 0;
            face.in_void = (flags & in_void) != 0;
            const std::array<double, 3> colour = next_colour();
            // There are no more solids than faces, since each solid has a face.
            face.solid = index_from(attributes_, -1, sizes_.faces.faces, "the solid of a face");
            if ((flags & has_colour) != 0) {
                face.colour = colour;
            }
            face.name = std::move(*text_++);
            face.face = next_face(i);
            model_.faces.push_back(std::move(face));
        }
        faces_.end();
    }
    void take_layers() {
        for (int64_t i = 0; i < sizes_.layers; ++i) {
            model_.layers.push_back(std::move(*text_++));
        }
        left_in_layers_ = sizes_.in_layers;
        model::for_each_in_layers(model_, [&](std::vector<int64_t> &layers) { layers = next_layers(); });
        if (left_in_layers_ != 0) {
            fail(Status::syntax, "number of places in layers %lld more than faces and splines have",
                 static_cast<long long>(left_in_layers_));
        }
    }
    // The layers of the next face or spline, ascending.
    std::vector<int64_t> next_layers() {
        const int64_t count = index_from(layer_counts_, 0, left_in_layers_ + 1, "a number of layers");
        left_in_layers_ -= count;
        std::vector<int64_t> layers;
        for (int64_t i = 0; i < count; ++i) {
            layers.push_back(
                index_from(layers_, layers.empty() ? 0 : layers.back() + 1, sizes_.layers, "a layer"));
        }
        return layers;
    }
    std::array<double, 3> next_colour() {
        std::array<double, 3> colour;
        finite_from(attributes_, colour, "a colour");
        for (const double part : colour) {
            if (part < 0 || part > 1) {
                fail(Status::syntax, "a colour %s, expected 0 to 1", Number(part).text);
            }
        }
        return colour;
    }
    face::FacePtr next_face(int64_t number) {
        try {
            face::FacePtr face = faces_.next(splines_);
            check_dimension(*face->surface(), 3, 3, "its surface");
            return face;
        } catch (const Error &error) {
            fail(error.status(), "face %lld: %s", static_cast<long long>(number), error.what());
        }
    }

    void take_edges() {
        for (int64_t i = 0; i < sizes_.edges; ++i) {
            model::Edge edge;
            edge.curve = spline(edges_, "the curve of an edge");
            check_kind(*edge.curve, 1, "the curve of an edge");
            check_dimension(*edge.curve, 3, 3, "the curve of an edge");
            edge.shape = shapes_.curve(index_from(edges_, -1, sizes_.shapes.curves, "the shape of an edge"));
            for (int64_t &vertex : edge.vertices) {
                vertex = index_from(edges_, -1, sizes_.vertices, "the vertex of an edge");
            }
            edge.part = index_from(edges_, 0, sizes_.parts, "the part of an edge");
            model_.edges.push_back(std::move(edge));
        }
        for (int64_t i = 0; i < sizes_.vertices; ++i) {
            double x[3];
            finite_from(vertices_, x, "a coordinate of a vertex");
            model_.vertices.push_back({x[0], x[1], x[2]});
        }
    }

    void take_uses_of_edges() {
        for (int64_t f = 0; f < sizes_.faces.faces; ++f) {
            const std::vector<face::Loop> &loops = model_.faces[static_cast<size_t>(f)].face->loops();
            for (int64_t loop = 0; loop < std::ssize(loops); ++loop) {
                for (int64_t i = 0; i < std::ssize(loops[static_cast<size_t>(loop)]); ++i) {
                    const int64_t edge = index_from(coedges_, -1, sizes_.edges, "the edge of a curve");
                    if (edge >= 0) {
                        model_.edges[static_cast<size_t>(edge)].uses.push_back({f, loop, i});
                    }
                }
            }
        }
    }

    ByteReader reader_;
    ModelSizes sizes_;
    double metres_;
    ByteReader named_;
    std::vector<model::Note> notes_;
    ByteReader uses_, attributes_, layer_counts_, layers_;
    FaceReader faces_;
    ByteReader coedges_, edges_, vertices_;
    ShapeReader shapes_;
    std::vector<std::string> texts_;
    std::vector<std::string>::iterator text_;
    std::vector<SplinePtr> splines_;
    int64_t left_in_layers_ = 0;
    model::Model model_{};
};

} // namespace

model::Model model_from(std::span<const unsigned char> bytes) {
    return ModelParser(bytes).run();
}

} // namespace nrb::io
