// All critical points of the distance from a point on a surface or volume.
//
// A part of a piece on which the distance rises or falls throughout along some axis has no critical point. A
// part on which the matrix of the second derivatives is regular has at most one, which Newton's method finds.
// All others are halved (Sherbrooke & Patrikalakis, "Computation of the solutions of nonlinear polynomial
// systems", CAGD 10, 1993).
#pragma once

#include "closest/locator.h"
#include "closest/patch/patch_descent.h"
#include "closest/patch/patch_slopes.h"

#include <limits>
#include <vector>

namespace nrb::closest {

class PatchCritical {
public:
    PatchCritical(const PatchPieces &pieces, const Query &query);

    CriticalSet run();

    // The places in some pieces where the distance, if it is at most a limit, may have a minimum: critical
    // points of the pieces, of their faces and edges, and corners.
    struct Spot {
        int64_t piece;
        AxisValues at;
        double distance;
        bool certain = false; // it is a minimum, by second derivatives in all pieces around
    };
    struct Spots {
        std::vector<Spot> spots;
        bool incomplete;
        bool connected; // not all are isolated
        bool doubtful;  // one may be missing
    };
    Spots minima(const std::vector<int64_t> &pieces, double limit);

private:
    // The faces of the part that is searched: side[k] of axis k of the shape is 0, 1, or -1 for all of it.
    struct Face {
        std::array<int, max_axes> side{};
        std::array<int, max_axes> axis{}; // of the shape, for each axis of the face
        PatchShape shape;
        std::unique_ptr<const PatchSquares> squares;
    };
    struct Part {
        double *values;
        AxisValues lower, length; // in the piece, along the axes of the face
        int depth;
    };
    // What one piece says of a point of it: whether it is a minimum there.
    enum class Answer { no, unknown, yes };
    struct Testimony {
        std::vector<double> point;
        int64_t piece;
        Answer answer;
    };
    // An edge that is a point, and how near to it distances do not tell points apart. Kind: a
    // critical_ constant, 0 if it is not critical as far as is known.
    struct Pole {
        std::vector<double> point;
        double radius;
        double height; // of a strip of parameters along the edge, no more than a radius wide
        int axis;      // it is the side of the domain, or of the range, where this one ends
        int64_t piece;
        AxisValues at;
        int32_t kind;
    };
    void find_poles();
    void find_pole(const Face &face);
    bool set_kind(const Face &face, const std::vector<int64_t> &pieces, Pole &pole) const;
    [[nodiscard]] bool proven(const std::vector<int64_t> &pieces, const Pole &pole);
    [[nodiscard]] PatchItem piece_in_range(int64_t piece) const;
    [[nodiscard]] bool at_pole(const PatchSlopes &slopes, bool flat);
    [[nodiscard]] bool at_pole(const std::vector<double> &point);
    void open_pole(const double *point);
    [[nodiscard]] bool is_pole(const Face &face) const noexcept;
    void testify(const std::vector<double> &point, int64_t piece, int32_t kind);
    void hear_all();
    [[nodiscard]] int face_count() const noexcept;
    [[nodiscard]] bool make_face(int code, Face &face) const;
    void search_faces();
    void search_face(const Face &face);
    void search_piece(const Face &face, int64_t piece);
    [[nodiscard]] bool touches(const Face &face, int64_t piece) const noexcept;
    void examine(const Face &face, const PatchItem &whole, Part &part);
    bool settled(const Face &face, const PatchItem &whole, const Part &part, int &axis);
    void split(const Face &face, const PatchItem &whole, Part &part, int axis);
    [[nodiscard]] AxisValues middle(const Face &face, const Part &part) const noexcept;
    void add_all(const Face &face, const PatchItem &whole, const Part &part, const PatchSlopes &slopes);
    // A critical point in the part, by Newton's method; false if it leaves the part, or comes to a pole where
    // the matrix is singular for no other reason.
    bool find(const Face &face, const PatchItem &whole, const Part &part, bool singular);
    // Whether a place is at a pole: a critical one, or any.
    [[nodiscard]] bool is_at_pole(const PatchItem &whole, const AxisValues &at, bool any = false) const;
    void add(const Face &face, const PatchItem &whole, const AxisValues &at, bool isolated);
    void add_point(const PatchItem &whole, const AxisValues &at, int32_t kind);
    [[nodiscard]] int32_t kind(const Face &face, const PatchItem &whole, const AxisValues &at) const;
    [[nodiscard]] bool is_point(const PatchItem &whole, AxisValues at, size_t axis) const;
    [[nodiscard]] bool is_critical_point(const Face &face, const PatchItem &whole, AxisValues at,
                                         size_t axis) const;
    [[nodiscard]] bool is_real(const Face &face, const PatchItem &whole, const AxisValues &at);

    const PatchPieces &pieces_;
    const Query &query_;
    mutable PatchMemory memory_;
    double *x_;
    PatchItems items_;
    PatchDescent descent_;
    double noise_ = 0;
    double near_ = 0; // points nearer to each other are one
    int64_t cost_ = 1, spent_ = 0, budget_ = 0;
    bool incomplete_ = false, connected_ = false;
    bool doubtful_ = false; // double precision does not tell whether a point is critical
    bool minima_ = false;   // the others are not wanted
    double limit_ = std::numeric_limits<double>::infinity();
    std::vector<Pole> poles_;
    std::vector<CriticalPoint> found_;
    std::vector<Testimony> testimonies_;
    std::vector<Spot> spots_;                 // of those found
    std::vector<std::vector<double>> points_; // the same
};

} // namespace nrb::closest
