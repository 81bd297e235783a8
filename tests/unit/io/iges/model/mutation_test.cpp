// No file makes the reader of models crash: whatever bytes are changed, and whichever entity a pointer names, comes out as a
// model whose numbers name what it holds, or as an Error that says something.
#include "support/iges_solids.h"

#include <algorithm>

namespace iges_model_mutation_test {

namespace {

using namespace iges_test;
using nrb::model::Model;

// One of everything that the reader looks into.
const IgesBuilder &everything() {
    static const IgesBuilder file = [] {
        FacesBuilder builder;
        const int64_t shift = builder.matrix("1.,0.,0.,5.,0.,1.,0.,0.,0.,0.,1.,0.");
        const int64_t colour = builder.add(314, "9.,8.,7.,1Hc"),
                      patch = builder.square(2, {.colour = -colour});
        const int64_t ring =
            builder.composite({builder.line({0, 0, 0}, {1, 0, 0}), builder.line({1, 0, 0}, {0, 1, 0}),
                               builder.line({0, 1, 0}, {0, 0, 0})});
        const int64_t curve = builder.curve_on_surface(patch, ring, ring, 3);
        const int64_t trimmed = builder.trimmed(patch, curve, {}, {.transform = shift});
        const int64_t boundary =
            builder.add(141, "1,0,5,1," + builder.name(ring) + ",1,1," + builder.name(ring));
        builder.add(143, "1,5,1," + builder.name(boundary));
        const int64_t vertex = builder.add(502, "1,1.5,1.,0."),
                      circle = builder.add(100, "0.,1.,1.,1.5,1.,1.5,1.");
        const std::string at = builder.name(vertex);
        const int64_t edges = builder.add(504, "1," + builder.name(circle) + "," + at + ",1," + at + ",1");
        const int64_t loop = builder.add(508, "1,0," + builder.name(edges) + ",1,1,0");
        const int64_t face = builder.add(510, "5,1,1," + builder.name(loop));
        const int64_t shell = builder.add(514, "1," + builder.name(face) + ",0");
        const int64_t solid = builder.add(186, builder.name(shell) + ",1,0");
        const int64_t group = builder.add(402, "1," + builder.name(trimmed), {.form = 7});
        builder.instance(builder.subfigure("s", {group}), "1.,2.,3.", "2.");
        builder.add(430, builder.name(solid));
        return static_cast<IgesBuilder>(builder);
    }();
    return file;
}

bool among(int64_t index, size_t count) {
    return index >= 0 && index < static_cast<int64_t>(count);
}

bool is_whole(const Model &found) {
    const bool faces =
        std::all_of(found.faces.begin(), found.faces.end(), [&](const nrb::model::ModelFace &face) {
            return face.face != nullptr && among(face.part, found.parts.size()) && !face.name.empty();
        });
    const bool edges = std::all_of(found.edges.begin(), found.edges.end(), [&](const nrb::model::Edge &edge) {
        return edge.curve != nullptr && among(edge.part, found.parts.size()) &&
               among(edge.vertices[0], found.vertices.size()) &&
               among(edge.vertices[1], found.vertices.size()) &&
               std::all_of(edge.uses.begin(), edge.uses.end(), [&](const nrb::model::EdgeUse &use) {
                   return among(use.face, found.faces.size());
               });
    });
    const bool uses = std::all_of(found.uses.begin(), found.uses.end(), [&](const nrb::model::Use &use) {
        return among(use.part, found.parts.size()) && among(use.parent + 1, found.parts.size() + 1);
    });
    const bool notes = std::all_of(found.notes.begin(), found.notes.end(), [](const nrb::model::Note &note) {
        return note.line > 0 && !note.text.empty() && note.reason != nrb::Status::ok;
    });
    return faces && edges && uses && notes;
}

bool reads_or_throws(const std::string &text) {
    try {
        return is_whole(read_model(text, {.unit = 1}));
    } catch (const nrb::Error &error) {
        const bool expected =
            (error.status() >= nrb::Status::format && error.status() <= nrb::Status::syntax) ||
            error.status() == nrb::Status::options;
        return expected && error.what()[0] != '\0';
    }
}

TEST(IgesModelMutation, the_file_itself_is_good) {
    const Model found = read_model(everything());
    for (const nrb::model::Note &note : found.notes) {
        ADD_FAILURE() << note.text;
    }
    EXPECT_TRUE(is_whole(found));
    EXPECT_EQ(found.faces.size(), 3U);
    EXPECT_EQ(found.parts.size(), 4U);
}

TEST(IgesModelMutation, every_byte_changed) {
    const std::string original = everything().text(), values("\0;,9-", 5);
    for (size_t at = 0; at < original.size(); ++at) {
        if (original[at] == ' ') {
            continue;
        }
        std::string text = original;
        for (const char value : values) {
            text[at] = value;
            ASSERT_TRUE(reads_or_throws(text)) << "byte " << at << " = " << static_cast<int>(value);
        }
    }
}

TEST(IgesModelMutation, every_truncation) {
    const std::string original = everything().text();
    for (size_t length = 0; length < original.size(); ++length) {
        ASSERT_TRUE(reads_or_throws(original.substr(0, length))) << "cut at " << length;
    }
}

// Each parameter in turn names each entity, and one that is not there: cycles and wrong kinds.
TEST(IgesModelMutation, every_parameter_names_everything) {
    std::vector<std::string> lines = everything().lines();
    for (std::string &line : lines) {
        if (line[72] != 'P') {
            continue;
        }
        const std::string original = line;
        for (size_t at = original.find(','); at < 64; at = original.find(',', at + 1)) {
            const size_t end = original.find_first_of(",;", at + 1);
            for (int64_t pointer = -1; end < 64 && pointer <= everything().next(); pointer += 2) {
                std::string data =
                    original.substr(0, at + 1) + std::to_string(pointer) + original.substr(end, 64 - end);
                data.resize(64, ' ');
                line = data + original.substr(64);
                ASSERT_TRUE(reads_or_throws(IgesBuilder::join(lines))) << line;
            }
        }
        line = original;
    }
}

} // namespace

} // namespace iges_model_mutation_test
