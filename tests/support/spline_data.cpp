#include "support/spline_data.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nurbs/nurbs.h>
#include <sstream>

namespace support {

int64_t SplineData::point_count() const {
    int64_t product = 1;
    for (const int64_t count : counts) {
        product *= count;
    }
    return product;
}

bool SplineData::periodic(int axis) const {
    return (flags & NURBS_ON_AXIS(axis, NURBS_PERIODIC)) != 0;
}

std::vector<double> SplineData::all_knots() const {
    std::vector<double> all;
    for (const auto &axis : knots) {
        all.insert(all.end(), axis.begin(), axis.end());
    }
    return all;
}

double SplineData::lower(int axis) const {
    const auto k = static_cast<size_t>(axis);
    return knots[k][static_cast<size_t>(degrees[k])];
}

double SplineData::upper(int axis) const {
    const auto k = static_cast<size_t>(axis);
    return knots[k][static_cast<size_t>(counts[k])];
}

double extent(const SplineData &data) {
    double size = 0;
    for (const double x : data.points) {
        size = std::max(size, std::fabs(x));
    }
    return size;
}

SplineData scaled(SplineData data, double size, double speed) {
    for (double &x : data.points) {
        x *= size;
    }
    for (auto &knots : data.knots) {
        for (double &t : knots) {
            t *= speed;
        }
    }
    return data;
}

namespace {

void append_of_order(int axes, int order, const MultiIndex &head, std::vector<MultiIndex> &out) {
    if (axes == 1) {
        out.push_back(head);
        out.back().push_back(order);
        return;
    }
    for (int first = order; first >= 0; --first) {
        MultiIndex longer = head;
        longer.push_back(first);
        append_of_order(axes - 1, order - first, longer, out);
    }
}

} // namespace

std::vector<MultiIndex> graded_indices(int axes, int order) {
    std::vector<MultiIndex> out;
    for (int s = 0; s <= order; ++s) {
        append_of_order(axes, s, {}, out);
    }
    return out;
}

int64_t slot_of(const MultiIndex &index) {
    if (index.size() == 1) {
        return index[0];
    }
    const int64_t j = index[1];
    if (index.size() == 2) {
        const int64_t s = index[0] + j;
        return s * (s + 1) / 2 + j;
    }
    const int64_t r = j + index[2];
    const int64_t s = index[0] + r;
    return s * (s + 1) * (s + 2) / 6 + r * (r + 1) / 2 + index[2];
}

int64_t binomial(int n, int k) {
    int64_t value = 1;
    for (int i = 1; i <= k; ++i) {
        value = value * (n - k + i) / i;
    }
    return value;
}

std::vector<LeibnizTerm> leibniz_terms(const MultiIndex &a) {
    std::vector<LeibnizTerm> terms = {{{}, {}, 1}};
    for (const int order : a) {
        std::vector<LeibnizTerm> longer;
        for (const auto &term : terms) {
            for (int b = 0; b <= order; ++b) {
                longer.push_back(term);
                longer.back().b.push_back(b);
                longer.back().rest.push_back(order - b);
                longer.back().factor *= binomial(order, b);
            }
        }
        terms = std::move(longer);
    }
    terms.erase(terms.begin()); // b = 0
    return terms;
}

std::string hex(double x) {
    char text[40];
    std::snprintf(text, sizeof text, "%a", x);
    return text;
}

std::string hex(const std::vector<double> &values) {
    std::string text = "{";
    for (size_t i = 0; i < values.size(); ++i) {
        text += (i == 0 ? "" : ", ") + hex(values[i]);
    }
    return text + "}";
}

std::string describe(const SplineData &data) {
    std::ostringstream text;
    for (size_t k = 0; k < data.degrees.size(); ++k) {
        text << "\naxis " << k << ": degree " << data.degrees[k] << ", count " << data.counts[k] << ", knots "
             << hex(data.knots[k]);
    }
    text << "\ndim " << data.dim << ", flags " << data.flags << ", points " << hex(data.points);
    text << "\nweights " << (data.rational() ? hex(data.weights) : "none") << "\n";
    return text.str();
}

} // namespace support
