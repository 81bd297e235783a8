// SISL: s1953, s1954 and s1240; its fast routines s1957 and s1958, which guarantee nothing.
#include "bench/queries/question.h"
#include "bench/rational.h"

#include <cstdlib>
#include <limits>
#include <memory>
#include <sisl.h>
#include <stdexcept>

namespace {

using namespace bench;
using support::SplineData;
using Curve = std::shared_ptr<SISLCurve>;
using Surface = std::shared_ptr<SISLSurf>;
constexpr int rational_kind = 2; // coefficients (w x, w y, w z, w)
constexpr int copy_arrays = 1;
constexpr double computing = 0, resolution = 1e-9; // the first is not used by SISL
constexpr double none = std::numeric_limits<double>::quiet_NaN();

void require(int status) {
    if (status < 0) {
        throw std::runtime_error("SISL: status " + std::to_string(status));
    }
}

Curve make_curve(const SplineData &data) {
    std::vector<double> knots = data.knots[0], points = homogeneous(data);
    return {newCurve(static_cast<int>(data.counts[0]), data.degrees[0] + 1, knots.data(), points.data(),
                     rational_kind, data.dim, copy_arrays),
            freeCurve};
}

// SISL's first direction varies fastest: it is axis 1 here, and the second is axis 0.
Surface make_surface(const SplineData &data) {
    std::vector<double> u = data.knots[0], v = data.knots[1], points = homogeneous(data);
    return {newSurf(static_cast<int>(data.counts[1]), static_cast<int>(data.counts[0]), data.degrees[1] + 1,
                    data.degrees[0] + 1, v.data(), u.data(), points.data(), rational_kind, data.dim,
                    copy_arrays),
            freeSurf};
}

// Calls answer(point, where) for every point, which adds a parameter in the order of SISL.
template <class F>
Ask each(const Question &question, F &&answer) {
    return [points = question.points, answer] {
        std::vector<double> params;
        for (size_t i = 0; i < points.size(); i += 3) {
            std::vector<double> point(points.begin() + static_cast<std::ptrdiff_t>(i),
                                      points.begin() + static_cast<std::ptrdiff_t>(i + 3));
            answer(point.data(), params);
        }
        return params;
    };
}

// The points and curves that s1953 and s1954 give; one of them is the answer.
class Found {
public:
    Found() = default;
    Found(const Found &) = delete;
    Found &operator=(const Found &) = delete;
    ~Found() {
        free(params);
        if (curves != nullptr) {
            freeIntcrvlist(curves, curve_count);
        }
    }
    [[nodiscard]] double param(int k) const {
        return count > 0 ? params[k] : curve_count > 0 ? curves[0]->epar1[k] : none;
    }

    int count = 0, curve_count = 0, status = 0;
    double *params = nullptr;
    SISLIntcurve **curves = nullptr;
};

double length(const Curve &curve, double tolerance) {
    double length = 0;
    int status = 0;
    s1240(curve.get(), tolerance, &length, &status);
    require(status);
    return length;
}

Ask robust(const Question &question) {
    if (question.kind == Kind::length) {
        const Curve curve = make_curve(question.shape);
        const double tolerance = question.tolerance * length(curve, 1e-3);
        return [=] { return std::vector{length(curve, tolerance)}; };
    }
    if (question.shape.axes() == 2) {
        return each(question, [surface = make_surface(question.shape)](double *point, auto &params) {
            Found found;
            s1954(surface.get(), point, 3, computing, resolution, &found.count, &found.params,
                  &found.curve_count, &found.curves, &found.status);
            require(found.status);
            params.insert(params.end(), {found.param(1), found.param(0)});
        });
    }
    return each(question, [curve = make_curve(question.shape)](double *point, auto &params) {
        Found found;
        s1953(curve.get(), point, 3, computing, resolution, &found.count, &found.params, &found.curve_count,
              &found.curves, &found.status);
        require(found.status);
        params.push_back(found.param(0));
    });
}

Ask fast(const Question &question) {
    if (question.kind == Kind::length) {
        return {};
    }
    if (question.shape.axes() == 2) {
        return each(question, [surface = make_surface(question.shape)](double *point, auto &params) {
            double param[2] = {none, none}, distance = 0;
            int status = 0;
            s1958(surface.get(), point, 3, computing, resolution, param, &distance, &status);
            require(status);
            params.insert(params.end(), {param[1], param[0]});
        });
    }
    return each(question, [curve = make_curve(question.shape)](double *point, auto &params) {
        double param = none, distance = 0;
        int status = 0;
        s1957(curve.get(), point, 3, computing, resolution, &param, &distance, &status);
        require(status);
        params.push_back(param);
    });
}

} // namespace

int main(int argc, char **argv) {
    return bench::run(argc, argv, {{"SISL", robust}, {"SISL, fast routines", fast}});
}
