// Every exact operation on every curve and surface of real CAD files leaves the shape where it is. The folder
// of the files is named by the environment variable NURBS_TEST_DATA. Those in JSON need nlohmann-json.
#include "property/real_files.h"

#include <functional>

namespace real_files_test {

using namespace support;

namespace {

// Parameters inside the domain of a part, away from knots, as fractions of it on each axis.
std::vector<double> sample(const SplineData &data) {
    constexpr double places[] = {0.0317, 0.271, 0.4999, 0.618, 0.77, 0.9683};
    std::vector<double> params;
    for (const double x : places) {
        for (const double y : places) {
            const double fractions[] = {x, y};
            for (int k = 0; k < data.axes(); ++k) {
                params.push_back(data.lower(k) + (data.upper(k) - data.lower(k)) * fractions[k]);
            }
        }
    }
    return params;
}

// Control points move by 2 eps of the largest one for each step, at most `degree` of them along an axis;
// evaluation, before and after, by less than 4 (degree + 1) eps each; all times the ratio of the weights.
long double allowance(const SplineData &data) {
    double largest = 0, ratio = 1;
    for (const double x : data.points) {
        largest = std::max(largest, std::abs(x));
    }
    if (data.rational()) {
        const auto [low, high] = std::ranges::minmax(data.weights);
        ratio = high / low;
    }
    int degrees = 0;
    for (const int degree : data.degrees) {
        degrees += degree + 1;
    }
    return 10 * degrees * eps * largest * ratio;
}

using Unary = std::function<Handle(const nurbs *, int axis)>;

Handle taken(nurbs_status status, nurbs *const &out) {
    require_ok(status);
    return Handle(out);
}

void expect_same(const RealSpline &original, const nurbs *made, const char *operation, int axis) {
    const SplineData part = read_back(made);
    const std::vector<double> params = sample(part);
    const std::vector<double> before = eval(original.handle.get(), params), after = eval(made, params);
    double worst = 0;
    for (size_t i = 0; i < before.size(); ++i) {
        worst = std::max(worst, std::abs(before[i] - after[i]));
    }
    EXPECT_LE(worst, allowance(original.data)) << original.name << ", " << operation << " on axis " << axis;
}

double inside(const nurbs *g, int axis, double fraction) {
    double domain[2];
    require_ok(nurbs_domain(g, axis, domain));
    return domain[0] + (domain[1] - domain[0]) * fraction;
}

Handle split_and_joined(const nurbs *g, int axis) {
    nurbs *lower = nullptr, *upper = nullptr, *out = nullptr;
    require_ok(nurbs_split(g, axis, inside(g, axis, 0.37), &lower, &upper));
    const Handle first(lower), second(upper);
    const nurbs *parts[] = {lower, upper};
    const nurbs_status status = nurbs_join(2, parts, axis, 0, 0, nullptr, &out);
    return taken(status, out);
}

Handle extracted(const nurbs *g, int /*axis*/) {
    nurbs *out = nullptr;
    std::vector<double> lower, upper;
    for (int k = 0; k < read_back(g).axes(); ++k) {
        lower.push_back(inside(g, k, 0.21));
        upper.push_back(inside(g, k, 0.83));
    }
    const nurbs_status status = nurbs_extract(g, lower.data(), upper.data(), &out);
    return taken(status, out);
}

template <class Function, class... Arguments>
Handle call(Function &&function, Arguments... arguments) {
    nurbs *out = nullptr;
    const nurbs_status status = function(arguments..., &out);
    return taken(status, out);
}

const std::vector<std::pair<const char *, Unary>> &operations() {
    static const std::vector<std::pair<const char *, Unary>> list = {
        {"insert", [](const nurbs *g, int k) { return call(nurbs_insert_knot, g, k, inside(g, k, 0.5), 1); }},
        {"refine", [](const nurbs *g, int k) { return call(nurbs_refine_uniform, g, k, 2); }},
        {"elevate", [](const nurbs *g, int k) { return call(nurbs_elevate, g, k, 1); }},
        {"reverse", [](const nurbs *g,
                       int k) { return call(nurbs_reverse, call(nurbs_reverse, g, k, 0U).get(), k, 0U); }},
        {"clamp", [](const nurbs *g, int k) { return call(nurbs_clamp_ends, g, k, 3U); }},
        {"unclamp", [](const nurbs *g,
                       int k) { return call(nurbs_clamp_ends, call(nurbs_unclamp, g, k, 3U).get(), k, 3U); }},
        {"split", split_and_joined},
        {"extract", extracted},
        {"rational", [](const nurbs *g, int) { return call(nurbs_make_rational, g); }},
    };
    return list;
}

void expect_shapes_kept(const std::vector<RealSpline> &splines) {
    EXPECT_FALSE(splines.empty());
    for (const RealSpline &spline : splines) {
        for (const auto &[name, operation] : operations()) {
            for (int k = 0; k < spline.data.axes(); ++k) {
                expect_same(spline, operation(spline.handle.get(), k).get(), name, k);
            }
        }
    }
}

void expect_pieces_kept(const std::vector<RealSpline> &splines) {
    for (const RealSpline &spline : splines) {
        nurbs_list *list = nullptr;
        require_ok(nurbs_decompose(spline.handle.get(), &list));
        const std::vector<Handle> pieces = items(List(list, nurbs_list_destroy));
        for (size_t i = 0; i < pieces.size(); i += pieces.size() / 20 + 1) {
            expect_same(spline, pieces[i].get(), "decompose", 0);
        }
    }
}

TEST_F(RealFiles, exact_operations_keep_the_shape) {
    expect_shapes_kept(iges());
}

TEST_F(RealFiles, exact_operations_keep_the_shape_of_json_files) {
    if (!reads_json) {
        GTEST_SKIP() << "nlohmann-json is not installed";
    }
    expect_shapes_kept(json());
}

TEST_F(RealFiles, pieces_keep_the_shape) {
    expect_pieces_kept(iges());
    expect_pieces_kept(json());
}

} // namespace

} // namespace real_files_test
