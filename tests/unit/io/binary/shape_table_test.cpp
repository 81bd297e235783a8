// Shapes in bodies: those of every kind come back, each once, and shapes in shapes have an end.
#include "io/binary/shape_reader.h"

#include "base/error.h"
#include "build/polylines.h"

#include <gtest/gtest.h>

namespace shape_table_test {

namespace {

using namespace nrb;
using namespace nrb::model;
using io::ByteReader;
using io::ByteWriter;
using Bytes = std::vector<unsigned char>;

build::Placement frame(int dim) {
    const double origin[3] = {1, 2, 3}, z[3] = {1, -2, 0.5}, x[3] = {0.25, 1, 1};
    return build::make_placement(dim, origin, dim == 3 ? z : nullptr, x, "origin");
}

CurveShapePtr curve(CurveKind kind, double a, double b, int dim = 3) {
    return std::make_shared<const CurveShape>(CurveShape{kind, frame(dim), {a, b}, nullptr, {}});
}

SurfaceShape surface(SurfaceKind kind, double a = 0, double b = 0) {
    SurfaceShape shape{kind, frame(3), {a, b}, {{0, 0}, {0, 0}}, nullptr, {}, nullptr,
                       0,    true,     true,   nullptr};
    return shape;
}

SurfaceShapePtr shared(SurfaceShape shape) {
    return std::make_shared<const SurfaceShape>(std::move(shape));
}

SplinePtr sheet() {
    const KnotVectorPtr line = make_knot_vector(1, {0, 0, 1, 1});
    return make_result({line, line}, 3, Form::polynomial, {0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 1});
}

struct AllShapes {
    std::vector<CurveShapePtr> curves;
    std::vector<SurfaceShapePtr> surfaces;
};

// One of every kind.
AllShapes all_shapes() {
    AllShapes all;
    const SplinePtr way = build::polyline(3, {0, 0, 0, 1, 0, 0, 1, 2, 0}, {0, 1, 2});
    all.curves = {curve(CurveKind::line, 2, 0),      curve(CurveKind::circle, 2, 0, 2),
                  curve(CurveKind::ellipse, 2, 1),   curve(CurveKind::parabola, 0.5, 0),
                  curve(CurveKind::hyperbola, 2, 3), curve_of_spline(way)};
    all.curves.push_back(curve_of_piece({all.curves[2], {0.25, 7}, false}));
    all.curves.push_back(
        curve_of_pieces({{all.curves[0], {0, 1}, true}, {all.curves[6], {-2, -1}, false}}, way));
    for (const SurfaceKind kind : {SurfaceKind::plane, SurfaceKind::cylinder, SurfaceKind::cone,
                                   SurfaceKind::sphere, SurfaceKind::torus}) {
        all.surfaces.push_back(shared(surface(kind, 2, 0.5)));
    }
    SurfaceShape torus = surface(SurfaceKind::torus, 0.5, 2);
    torus.range.v = {-1.75, 1.75};
    all.surfaces.back() = shared(torus);
    SurfaceShape turned = surface(SurfaceKind::revolution), moved = surface(SurfaceKind::extrusion);
    turned.curve = moved.curve = all.curves[7];
    moved.vector = {1, 2, -3};
    SurfaceShape offset = surface(SurfaceKind::offset), net = surface(SurfaceKind::spline),
                 part = surface(SurfaceKind::trimmed);
    offset.basis = all.surfaces[3];
    offset.distance = -0.5;
    net.spline = sheet();
    part.basis = shared(offset);
    part.range = {{0, 1}, {-0.5, 0.5}};
    part.v_forward = false;
    for (const SurfaceShape &shape : {turned, moved, net, part}) {
        all.surfaces.push_back(shared(shape));
    }
    return all;
}

// A body of the splines and the shapes that a table has; they are asked for again, which adds nothing.
struct Body {
    io::SplineTable splines;
    io::ShapeTable shapes;
    Bytes bytes;

    explicit Body(const AllShapes &all) {
        for (int i = 0; i < 2; ++i) {
            for (const CurveShapePtr &shape : all.curves) {
                shapes.add(shape, splines);
            }
            for (const SurfaceShapePtr &shape : all.surfaces) {
                shapes.add(shape, splines);
            }
        }
        bytes.resize(io::header_size + shapes.size_in_bytes() + splines.size_in_bytes());
        ByteWriter writer(io::Kind::model, {}, bytes);
        shapes.write(writer);
        splines.write(writer);
        writer.finish();
    }
};

io::ShapeReader read(const Body &body) {
    ByteReader reader(body.bytes, io::Kind::model);
    io::ShapeReader shapes(reader, body.shapes.sizes());
    const std::vector<SplinePtr> splines = io::splines_from(reader, body.splines.count());
    reader.end();
    shapes.make(splines);
    return shapes;
}

AllShapes shapes_of(const Body &body) {
    const io::ShapeReader shapes = read(body);
    AllShapes all;
    for (int64_t i = 0; i < body.shapes.sizes().curves; ++i) {
        all.curves.push_back(shapes.curve(i));
    }
    for (int64_t i = 0; i < body.shapes.sizes().surfaces; ++i) {
        all.surfaces.push_back(shapes.surface(i));
    }
    return all;
}

TEST(ShapeTable, shapes_of_every_kind_come_back) {
    const Body body(all_shapes());
    EXPECT_EQ(body.shapes.sizes().curves, 8);
    EXPECT_EQ(body.shapes.sizes().surfaces, 10); // and the one that is offset
    EXPECT_EQ(body.shapes.sizes().pieces, 3);
    const AllShapes found = shapes_of(body);
    EXPECT_EQ(Body(found).bytes, body.bytes);
    const CurveShape &composite = *found.curves[7];
    EXPECT_EQ(composite.kind, CurveKind::composite);
    ASSERT_EQ(composite.pieces.size(), 2U);
    EXPECT_EQ(composite.pieces[1].curve, found.curves[6]);
    EXPECT_EQ(composite.pieces[1].range.lower, -2);
    EXPECT_FALSE(composite.pieces[1].forward);
    EXPECT_EQ(found.curves[2]->sizes[1], 1);
    EXPECT_EQ(found.curves[1]->place.dim, 2);
    EXPECT_EQ(found.curves[0]->place.z_rest.x, frame(3).z_rest.x);
    EXPECT_EQ(found.curves[0]->place.given_axis.y, -2);
    EXPECT_EQ(found.surfaces[3]->place.given_x.x, 0.25);
    const SurfaceShape &part = *found.surfaces[9];
    EXPECT_EQ(part.kind, SurfaceKind::trimmed);
    EXPECT_TRUE(part.u_forward && !part.v_forward);
    EXPECT_EQ(part.basis->distance, -0.5);
    EXPECT_EQ(part.basis->basis, found.surfaces[3]);
    EXPECT_EQ(found.surfaces[4]->range.v.upper, 1.75);
    EXPECT_EQ(found.surfaces[5]->curve, found.surfaces[6]->curve);
    EXPECT_EQ(found.surfaces[6]->vector.z, -3);
    EXPECT_EQ(found.surfaces[7]->spline->point_count(), 4);
}

TEST(ShapeTable, shapes_in_shapes_have_an_end) {
    for (const int depth : {64, 65}) {
        SurfaceShapePtr shape = shared(surface(SurfaceKind::plane));
        for (int i = 1; i < depth; ++i) {
            SurfaceShape more = surface(SurfaceKind::offset);
            more.basis = shape;
            more.distance = 1;
            shape = shared(more);
        }
        const Body body({{}, {shape}});
        if (depth == 64) {
            EXPECT_EQ(shapes_of(body).surfaces.size(), 64U);
            continue;
        }
        try {
            read(body);
            ADD_FAILURE() << "shapes in shapes";
        } catch (const Error &error) {
            EXPECT_EQ(error.status(), Status::syntax);
            EXPECT_STREQ(error.what(), "more than 64 shapes lie in one another");
        }
    }
}

} // namespace

} // namespace shape_table_test
