// Unstructured grids of any cells.
#include "io/mesh_formats/vtu.h"
#include "support/mesh_files.h"

#include <gtest/gtest.h>

namespace vtu_test {
namespace {

using namespace nrb::io;
using support::mesh_files::read_vtu;
using support::mesh_files::Vtu;

std::string text_of(const vtu::Grid &grid) {
    std::string text;
    source_of([&grid](Blocks &out) { vtu::write(grid, out); })(
        [&text](std::string_view block) { text += block; });
    return text;
}

std::vector<double> doubles(const auto &values) {
    return {values.begin(), values.end()};
}

// A trilinear cell of Bezier kind with weights, and a hexahedron of the same points.
TEST(Vtu, has_bezier_cells_with_weights_and_degrees) {
    std::vector<double> points, weights(8, 2.5);
    for (int i = 0; i < 24; ++i) {
        points.push_back(i / 7.0);
    }
    const std::vector<int64_t> corners{0, 1, 2, 3, 4, 5, 6, 7, 7, 6, 5, 4, 3, 2, 1, 0}, offsets{8, 16};
    const std::vector<uint8_t> types{vtu::bezier_hexahedron, vtu::hexahedron};
    const std::vector<int32_t> degrees{1, 1, 1, 1, 1, 1};
    vtu::Grid grid{vtu::array_of<double>("Points", 3, points),
                   vtu::array_of<int64_t>("connectivity", 1, corners),
                   vtu::array_of<int64_t>("offsets", 1, offsets), vtu::array_of<uint8_t>("types", 1, types)};
    grid.point_data.push_back(vtu::array_of<double>("weights", 1, weights, "RationalWeights"));
    grid.cell_data.push_back(vtu::array_of<int32_t>("degrees", 3, degrees, "HigherOrderDegrees"));
    grid.higher_order = true;
    const Vtu read = read_vtu(text_of(grid));
    EXPECT_EQ(read.points, 8U);
    EXPECT_EQ(read.cells, 2U);
    EXPECT_EQ(read.arrays.at("Points"), points);
    EXPECT_EQ(read.arrays.at("weights"), weights);
    EXPECT_EQ(read.arrays.at("connectivity"), doubles(corners));
    EXPECT_EQ(read.arrays.at("offsets"), doubles(offsets));
    EXPECT_EQ(read.arrays.at("types"), doubles(types));
    EXPECT_EQ(read.arrays.at("degrees"), doubles(degrees));
    EXPECT_EQ(read.sections.at("PointData").at("RationalWeights"), "weights");
    EXPECT_EQ(read.sections.at("CellData").at("HigherOrderDegrees"), "degrees");
    EXPECT_EQ(read.sections.at("VTKFile").at("version"), "2.2");
}

// Of more bytes than a block, so that numbers go over its end.
TEST(Vtu, may_be_longer_than_a_block) {
    const int64_t cells = 100001;
    std::vector<double> points;
    for (int64_t i = 0; i < 3 * cells; ++i) {
        points.push_back(1.0 / static_cast<double>(i + 1));
    }
    const vtu::Array connectivity{"connectivity", vtu::NumberType::int64, 1, cells, [](Blocks &out) {
                                      for (int64_t i = 0; i < cells; ++i) {
                                          out.bytes(i);
                                      }
                                  }};
    const Vtu read = read_vtu(text_of({vtu::array_of<double>("Points", 3, points), connectivity,
                                       vtu::even_offsets(cells, 1), vtu::even_types(cells, 1)}));
    EXPECT_EQ(read.arrays.at("Points"), points);
    EXPECT_EQ(read.arrays.at("types"), std::vector<double>(static_cast<size_t>(cells), 1.0));
    EXPECT_EQ(read.arrays.at("connectivity").back(), static_cast<double>(cells - 1));
    EXPECT_EQ(read.arrays.at("offsets").front(), 1.0);
    EXPECT_EQ(read.arrays.at("offsets").back(), static_cast<double>(cells));
}

} // namespace
} // namespace vtu_test
