#include "measure/nested_rule.h"

#include "measure/speed_kernel.h"
#include "numeric/binomial.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace nrb::measure {

namespace {

// Computed with 160 digits: new nodes from the orthogonality of their polynomial times that of the old ones
// to all lower powers, weights by integrating the Lagrange polynomials. Index 15 fills a vector up.
constexpr double places[] = {0.11270166537925831148,     0.5,
                             0.88729833462074168852,     0.019754365645989858288,
                             0.282878125326598721,       0.717121874673401279,
                             0.98024563435401014171,     0.0030840183936224888957,
                             0.055770383563871500555,    0.18944852663138679853,
                             0.38830665678551655919,     0.61169334321448344081,
                             0.81055147336861320147,     0.94422961643612849945,
                             0.9969159816063775111,      0.5,
                             0.00045093751616620116889,  0.0092344252231299465663,
                             0.035172571285129971665,    0.081637030915565632249,
                             0.1487518967542364607,      0.23434012817781218801,
                             0.33443230337101158345,     0.44375552843340668713,
                             0.55624447156659331287,     0.66556769662898841655,
                             0.76565987182218781199,     0.8512481032457635393,
                             0.91836296908443436775,     0.96482742871487002834,
                             0.99076557477687005343,     0.99954906248383379883,
                             0.000063555939821194031022, 0.0013968703138890204618,
                             0.0056576212262852600307,   0.013908562625709101711,
                             0.026828570813298547426,    0.044814421521497853751,
                             0.068046030903154761427,    0.096529734024891194072,
                             0.13012197782365262066,     0.16854516998760970227,
                             0.21140214497397709258,     0.25819098652707948622,
                             0.30832033790063482654,     0.36112508898908784247,
                             0.41588237422389626751,     0.47182784347670360501,
                             0.52817215652329639499,     0.58411762577610373249,
                             0.63887491101091215753,     0.69167966209936517346,
                             0.74180901347292051378,     0.78859785502602290742,
                             0.83145483001239029773,     0.86987802217634737934,
                             0.90347026597510880593,     0.93195396909684523857,
                             0.95518557847850214625,     0.97317142918670145257,
                             0.98609143737429089829,     0.99434237877371473997,
                             0.99860312968611097954,     0.99993644406017880597};
constexpr double rests[] = {0.88729833462074168852,   0.5,
                            0.11270166537925831148,   0.98024563435401014171,
                            0.717121874673401279,     0.282878125326598721,
                            0.019754365645989858288,  0.9969159816063775111,
                            0.94422961643612849945,   0.81055147336861320147,
                            0.61169334321448344081,   0.38830665678551655919,
                            0.18944852663138679853,   0.055770383563871500555,
                            0.0030840183936224888957, 0.5,
                            0.99954906248383379883,   0.99076557477687005343,
                            0.96482742871487002834,   0.91836296908443436775,
                            0.8512481032457635393,    0.76565987182218781199,
                            0.66556769662898841655,   0.55624447156659331287,
                            0.44375552843340668713,   0.33443230337101158345,
                            0.23434012817781218801,   0.1487518967542364607,
                            0.081637030915565632249,  0.035172571285129971665,
                            0.0092344252231299465663, 0.00045093751616620116889,
                            0.99993644406017880597,   0.99860312968611097954,
                            0.99434237877371473997,   0.98609143737429089829,
                            0.97317142918670145257,   0.95518557847850214625,
                            0.93195396909684523857,   0.90347026597510880593,
                            0.86987802217634737934,   0.83145483001239029773,
                            0.78859785502602290742,   0.74180901347292051378,
                            0.69167966209936517346,   0.63887491101091215753,
                            0.58411762577610373249,   0.52817215652329639499,
                            0.47182784347670360501,   0.41588237422389626751,
                            0.36112508898908784247,   0.30832033790063482654,
                            0.25819098652707948622,   0.21140214497397709258,
                            0.16854516998760970227,   0.13012197782365262066,
                            0.096529734024891194072,  0.068046030903154761427,
                            0.044814421521497853751,  0.026828570813298547426,
                            0.013908562625709101711,  0.0056576212262852600307,
                            0.0013968703138890204618, 0.000063555939821194031022};
constexpr double weights_3[] = {0.27777777777777777778,
                                0.44444444444444444444,
                                0.27777777777777777778,
                                0,
                                0,
                                0,
                                0,
                                0,
                                0,
                                0,
                                0,
                                0,
                                0,
                                0,
                                0,
                                0};
constexpr double weights_7[] = {0.13424404493416672036,
                                0.22545826932923707117,
                                0.13424404493416672036,
                                0.052328113013233632597,
                                0.20069870738798111145,
                                0.20069870738798111145,
                                0.052328113013233632597,
                                0,
                                0,
                                0,
                                0,
                                0,
                                0,
                                0,
                                0,
                                0};
constexpr double weights_15[] = {
    0.06720762762189211018,  0.11275524989910334369,  0.06720762762189211018,   0.025801641498539869848,
    0.10031426468849451052,  0.10031426468849451052,  0.025801641498539869848,  0.0085008598149701301695,
    0.046463597657562268843, 0.085755954568195690394, 0.1095784292007937482,    0.1095784292007937482,
    0.085755954568195690394, 0.046463597657562268843, 0.0085008598149701301695, 0};
constexpr double weights_31[] = {
    0.03360387714799535177,   0.056377628360384345804,  0.03360387714799535177,   0.012903799048088326782,
    0.050157139305897789386,  0.050157139305897789386,  0.012903799048088326782,  0.0042172828696605531232,
    0.023231446630878993271,  0.042877960024995175577,  0.054789210527962319118,  0.054789210527962319118,
    0.042877960024995175577,  0.023231446630878993271,  0.0042172828696605531232, 0,
    0.0012723903957809372077, 0.0082230249271939054669, 0.017978551653564661048,  0.028489754747061678706,
    0.038439810249501765521,  0.046813554990632236808,  0.052834946790117404872,  0.05597843651047672844,
    0.05597843651047672844,   0.052834946790117404872,  0.046813554990632236808,  0.038439810249501765521,
    0.028489754747061678706,  0.017978551653564661048,  0.0082230249271939054669, 0.0012723903957809372077};
constexpr double weights_63[] = {
    0.016801938574103865271,   0.028188814180192358694,  0.016801938574103865271,  0.006451900050175632813,
    0.025078569652949768707,   0.025078569652949768707,  0.006451900050175632813,  0.0021088152207794274195,
    0.011615723319955134722,   0.021438980012503867246,  0.027394605263981432516,  0.027394605263981432516,
    0.021438980012503867246,   0.011615723319955134722,  0.0021088152207794274195, 0,
    0.00063257827811503400569, 0.0041115039786179648346, 0.0089892757840641351664, 0.014244877372916774306,
    0.019219905124727766019,   0.023406777495314006201,  0.026417473395058259931,  0.027989218255238159704,
    0.027989218255238159704,   0.026417473395058259931,  0.023406777495314006201,  0.019219905124727766019,
    0.014244877372916774306,   0.0089892757840641351664, 0.0041115039786179648346, 0.00063257827811503400569,
    0.00018161074092276532985, 0.0012895248973428441362, 0.0030577534110586231698, 0.0052491234548106609491,
    0.0077033752332797489011,  0.010297116957956355575,  0.012934839663607373455,  0.01553677555584398244,
    0.01803221639039128632,    0.020357755058472159467,  0.022457265826816098707,  0.024282165203336599358,
    0.025791626976024229388,   0.026952749667633031963,  0.027740702178279681994,  0.028138849915627150636,
    0.028138849915627150636,   0.027740702178279681994,  0.026952749667633031963,  0.025791626976024229388,
    0.024282165203336599358,   0.022457265826816098707,  0.020357755058472159467,  0.01803221639039128632,
    0.01553677555584398244,    0.012934839663607373455,  0.010297116957956355575,  0.0077033752332797489011,
    0.0052491234548106609491,  0.0030577534110586231698, 0.0012895248973428441362, 0.00018161074092276532985};

constexpr std::array<const double *, rule_levels> weight_tables = {weights_3, weights_7, weights_15,
                                                                   weights_31, weights_63};

// For each level the factors (2 k + 1) P_k(x_i) w_i of six Legendre coefficients: three high ones, up to half
// the exactness, and three about half as high.
class DecayRows {
public:
    constexpr DecayRows() {
        for (size_t level = 1; level < rule_levels; ++level) {
            for (size_t row = 0; row < 6; ++row) {
                for (size_t i = 0; i < static_cast<size_t>(rule_size(static_cast<int>(level))); ++i) {
                    const int k = degrees[level][row];
                    rows_[level][row][i] =
                        (2 * k + 1) * legendre(k, 2 * places[i] - 1) * weight_tables[level][i];
                }
            }
        }
    }
    [[nodiscard]] const double *row(int level, size_t row) const noexcept {
        return rows_[static_cast<size_t>(level)][row].data();
    }

private:
    static constexpr int degrees[rule_levels][6] = {{0, 0, 0, 0, 0, 0},
                                                    {5, 4, 3, 3, 2, 1},
                                                    {11, 10, 9, 6, 5, 4},
                                                    {23, 22, 21, 12, 11, 10},
                                                    {47, 46, 45, 24, 23, 22}};

    static constexpr double legendre(int n, double x) {
        double before = 1, value = x;
        for (int k = 1; k < n; ++k) {
            const double next = ((2 * k + 1) * x * value - k * before) / (k + 1);
            before = value;
            value = next;
        }
        return value;
    }

    std::array<std::array<std::array<double, rule_capacity>, 6>, rule_levels> rows_{};
};

constexpr DecayRows decay_rows;

// u^0, ..., u^degree.
void powers(double u, int degree, double *out) noexcept {
    out[0] = 1;
    for (int i = 1; i <= degree; ++i) {
        out[i] = out[i - 1] * u;
    }
}

} // namespace

const double *rule_places() noexcept {
    return places;
}

const double *rule_rests() noexcept {
    return rests;
}

const double *rule_weights(int level) noexcept {
    return weight_tables[static_cast<size_t>(level)];
}

void rule_basis(int degree, double *values) noexcept {
    const double *choose = binomials(degree);
    double low[max_product_degree + 1], high[max_product_degree + 1];
    for (int node = 0; node < rule_capacity; ++node) {
        powers(places[node], degree, high);
        powers(rests[node], degree, low);
        for (int i = 0; i <= degree; ++i) {
            values[i * rule_capacity + node] = choose[i] * high[i] * low[degree - i];
        }
    }
}

void rule_basis_derivatives(int degree, double *derivatives) noexcept {
    std::fill_n(derivatives, (degree + 1) * rule_capacity, 0.0);
    if (degree == 0) {
        return;
    }
    double *lower = derivatives + rule_capacity; // B_(i - 1) of degree - 1 in row i
    rule_basis(degree - 1, lower);
    for (int i = 0; i <= degree; ++i) {
        double *row = derivatives + i * rule_capacity;
        for (int node = 0; node < rule_capacity; ++node) {
            const double next = i < degree ? row[rule_capacity + node] : 0;
            row[node] = degree * (row[node] - next);
        }
    }
}

double RuleDecay::one_higher() const noexcept {
    const double square = rate * rate, fourth = square * square;
    return fourth * fourth;
}

double RuleDecay::two_higher() const noexcept {
    const double one = one_higher();
    return one * one;
}

namespace {

std::array<const double *, 7> rows_of(int level) noexcept {
    return {rule_weights(level),      decay_rows.row(level, 0), decay_rows.row(level, 1),
            decay_rows.row(level, 2), decay_rows.row(level, 3), decay_rows.row(level, 4),
            decay_rows.row(level, 5)};
}

RuleDecay decay_of(const std::array<double, 7> &sums) noexcept {
    const double last = std::max({std::abs(sums[1]), std::abs(sums[2]), std::abs(sums[3])});
    const double low = std::max({std::abs(sums[4]), std::abs(sums[5]), std::abs(sums[6])});
    return {sums[0], last, last < low ? last / low : 1};
}

} // namespace

RuleDecay rule_decay(int level, const double *values) noexcept {
    std::array<double, 7> sums;
    rule_sums(rows_of(level).data(), values, std::max(8, rule_size(level)), sums.data());
    return decay_of(sums);
}

RuleDecay speed_decay(const SpeedForm &form, const double *net, int first, int level,
                      double *values) noexcept {
    std::array<double, 7> sums;
    speeds_and_sums(form, net, first, rule_size(level) - first, values, rows_of(level).data(), sums.data());
    return decay_of(sums);
}

} // namespace nrb::measure
