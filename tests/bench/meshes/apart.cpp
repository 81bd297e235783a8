// SPDX-License-Identifier: MIT
// How far a mesh is from its shape, by samples, in the same way for all libraries.
//   bench_meshes_apart SHAPE MESH SAMPLES    {"from_shape", "from_mesh"}: the largest distance of a sample of the shape from the
//                                            mesh, and of a sample of the mesh from the shape
// Samples of the mesh are the middles of triangles and of their sides, and as many random places in each triangle; those of the
// shape are random. Only what may be farther than all before is looked at closely.
#include "bench/meshes/nurbs_handles.h"
#include "bench/meshes/triangles.h"

#include <functional>

namespace {

using namespace bench::meshes;

struct Shape {
    std::function<Point(Numbers &)> sample;
    // Of a place of the mesh, with its parameters, from the shape: no less, and not more if that is > enough.
    std::function<double(const Point &, const Param &, double enough)> distance;
};

// Of the nearest point of all, where Newton's method does not find one that is near.
double distance_from(const nurbs *surface, const Domain &domain, const Point &x, const Param &at,
                     double enough) {
    const double found =
        foot_distance(x, at, domain, enough, 4, [&](const Param &param) { return jet_of(surface, param); });
    if (found <= enough) {
        return found;
    }
    double least = 0;
    good(nurbs_closest_points(surface, 1, x.data(), 0, 0, nullptr, 1e-6 * found, 0, nullptr, 0, 0, nullptr, 0,
                              0, &least, 0, nullptr, 0));
    return std::min(found, least);
}

Shape spline(const Kind &kind) {
    const auto surface = std::make_shared<Surface>(surface_of(kind.surface));
    const auto face =
        std::make_shared<Face>(kind.trim == Trim::none ? nullptr : face_of(surface->get(), kind.trim));
    const Domain domain = domain_of(surface->get());
    const auto inside = [=](const Param &at) {
        int32_t side = 1;
        if (*face) {
            good(nurbs_face_classify(face->get(), 1, at.data(), 0, 0, 0, &side));
        }
        return side > 0;
    };
    return {[=](Numbers &numbers) {
                Param at{};
                do {
                    for (size_t k = 0; k < 2; ++k) {
                        at[k] = numbers.between(domain.lower[k], domain.upper[k]);
                    }
                } while (!inside(at));
                Point x{};
                good(nurbs_eval(surface->get(), 1, at.data(), 0, 0, x.data(), 0, 0, 0));
                return x;
            },
            [=](const Point &x, const Param &at, double enough) {
                return distance_from(surface->get(), domain, x, at, enough);
            }};
}

// Their samples are dense everywhere, but not equally so.
Shape quadric(Kind::Surface surface) {
    constexpr double whole = 2 * std::numbers::pi;
    if (surface == Kind::Surface::sphere) {
        return {[](Numbers &numbers) {
                    const double a = numbers.between(0, whole), z = numbers.between(-1, 1),
                                 r = std::sqrt(1 - z * z);
                    return Point{r * std::cos(a), r * std::sin(a), z};
                },
                [](const Point &x, const Param &, double) { return std::fabs(length(x) - 1); }};
    }
    if (surface == Kind::Surface::torus) {
        return {[](Numbers &numbers) {
                    const double a = numbers.between(0, whole), b = numbers.between(0, whole),
                                 r = major + minor * std::cos(b);
                    return Point{r * std::cos(a), r * std::sin(a), minor * std::sin(b)};
                },
                [](const Point &x, const Param &, double) {
                    return std::fabs(std::hypot(std::hypot(x[0], x[1]) - major, x[2]) - minor);
                }};
    }
    return {[](Numbers &numbers) {
                const double a = numbers.between(0, whole);
                return Point{std::cos(a), std::sin(a), numbers.between(0, height)};
            },
            [](const Point &x, const Param &, double) { return std::fabs(std::hypot(x[0], x[1]) - 1); }};
}

Shape shape_of(const Kind &kind) {
    using enum Kind::Surface;
    return kind.surface == patch || kind.surface == plane ? spline(kind) : quadric(kind.surface);
}

double from_mesh(const Shape &shape, const Mesh &mesh, int64_t samples) {
    Numbers numbers(1);
    double most = 0;
    const auto see = [&](size_t triangle, const Point &shares) {
        most =
            std::max(most, shape.distance(mesh.point(triangle, shares), mesh.param(triangle, shares), most));
    };
    const auto count = static_cast<int64_t>(mesh.triangles.size());
    for (size_t i = 0; i < mesh.triangles.size(); ++i) {
        for (const Point &shares : middles) {
            see(i, shares);
        }
        for (int64_t k = std::ssize(middles); k < (samples + count - 1) / count; ++k) {
            const double root = std::sqrt(numbers.unit()), part = numbers.unit() * root;
            see(i, {1 - root, root - part, part});
        }
    }
    return most;
}

double from_shape(const Shape &shape, const Mesh &mesh, int64_t samples) {
    Numbers numbers(2);
    const Triangles triangles(mesh);
    double most = 0;
    for (int64_t i = 0; i < samples; ++i) {
        most = std::max(most, triangles.distance(shape.sample(numbers), most));
    }
    return most;
}

} // namespace

int main(int count, char **arguments) {
    if (count != 4) {
        std::fprintf(stderr, "usage: %s SHAPE MESH SAMPLES\n", arguments[0]);
        return 2;
    }
    const Shape shape = shape_of(kind_of(arguments[1]));
    const Mesh mesh = read(arguments[2]);
    const auto samples = static_cast<int64_t>(std::strtod(arguments[3], nullptr));
    if (mesh.triangles.empty()) {
        std::fprintf(stderr, "there are no triangles\n");
        return 1;
    }
    std::printf("{\"from_shape\": %.17g, \"from_mesh\": %.17g}\n", from_shape(shape, mesh, samples),
                from_mesh(shape, mesh, samples));
    return 0;
}
