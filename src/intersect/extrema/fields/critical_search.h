// SPDX-License-Identifier: MIT
// Where the gradient of a function on a stratum vanishes.
#pragma once

#include "intersect/extrema/fields/field_box.h"
#include "intersect/extrema/fields/krawczyk.h"

#include <array>
#include <optional>
#include <vector>

namespace nrb::intersect {

// The only one in a part of the stratum, proven. All in coordinates of a piece.
struct CriticalPlace {
    PieceIndex home{};
    Part core{};   // it is in here,
    Part unique{}; // and alone in here
    std::array<double, max_axes> at{};
    uint32_t kinds = 0; // what it is on the stratum
};

struct CriticalPlaces {
    std::vector<CriticalPlace> found;
    std::vector<Part> open; // of parameters, where nothing is known
};

// Along N axes that are free. Halves pieces away where a derivative has a sign, until Krawczyk's operator proves that what
// is left has one critical place or none. Derivatives are continuous across smooth joints, and differences of them are those
// of places times matrices in the hull of all second derivatives between, so that what is proven holds there too.
template <size_t N>
class CriticalSearch {
public:
    CriticalSearch(const GradientField &field, const Stratum &stratum);

    void run(const PieceIndex &index, CriticalPlaces &out);

private:
    struct Cell {
        std::array<RoundedPolynomial, N> slopes;
        Part box;
    };
    enum class Verdict : unsigned char { open, none, one, at_border };
    bool start();
    void look(Cell &cell);
    [[nodiscard]] bool may_be_single(const Cell &cell) const;
    Verdict judge(const Part &box, CriticalPlace &place);
    Verdict verdict_at(const Krawczyk<N> &krawczyk, const Part &box, const Part &wide, CriticalPlace &place);
    Verdict verdict_in(const Part &box, CriticalPlace &place);
    bool narrow(CriticalPlace &place);
    [[nodiscard]] Part widened(const Part &box) const;
    [[nodiscard]] bool ends_there(int k, bool upper) const;
    [[nodiscard]] bool goes_on(size_t j, bool upper) const;
    [[nodiscard]] IntervalMatrix<N> second_derivatives(const std::vector<CoveredPart> &parts) const;
    bool steps_from(const Krawczyk<N> &krawczyk, const Part &wide, Place<N> &z, Place<N> &step,
                    double &near) const;
    bool step_at(const Krawczyk<N> &krawczyk, const Place<N> &z, Place<N> &step, double &near) const;
    [[nodiscard]] Part part_of(const Box<N> &box) const;
    void halve(Cell &cell);
    void leave(const Part &box);
    void gather();

    const GradientField &field_;
    const Stratum &stratum_;
    std::array<int, N> free_{};
    PieceIndex index_{};
    GradientPiecePtr home_;
    bool divided_ = false;
    std::vector<Cell> cells_;
    size_t next_ = 0;
    std::vector<Part> unique_, left_;
    CriticalPlaces *out_ = nullptr;
};

} // namespace nrb::intersect
