// SPDX-License-Identifier: MIT
// Checks that the constants of the core have the values of those in the public interface, which the core does
// not include.
#include "analysis/convexity.h"
#include "analysis/features.h"
#include "analysis/folds.h"
#include "base/limits.h"
#include "base/status.h"
#include "build/conics/arc.h"
#include "build/coons/coons.h"
#include "closest/foot.h"
#include "eval/frames/frame_outputs.h"
#include "intersect/rays/rays.h"
#include "model/rays/classify.h"
#include "modify/constrain/condition.h"
#include "recognize/conic_type.h"
#include "recognize/shape_model.h"

#include <nurbs/nurbs.h>

namespace nrb {

static_assert(static_cast<int>(Status::ok) == NURBS_OK);
static_assert(static_cast<int>(Status::null) == NURBS_ERROR_NULL);
static_assert(static_cast<int>(Status::axes) == NURBS_ERROR_AXES);
static_assert(static_cast<int>(Status::axis) == NURBS_ERROR_AXIS);
static_assert(static_cast<int>(Status::degree) == NURBS_ERROR_DEGREE);
static_assert(static_cast<int>(Status::count) == NURBS_ERROR_COUNT);
static_assert(static_cast<int>(Status::too_few_points) == NURBS_ERROR_TOO_FEW_POINTS);
static_assert(static_cast<int>(Status::overflow) == NURBS_ERROR_OVERFLOW);
static_assert(static_cast<int>(Status::size) == NURBS_ERROR_SIZE);
static_assert(static_cast<int>(Status::dimension) == NURBS_ERROR_DIMENSION);
static_assert(static_cast<int>(Status::stride) == NURBS_ERROR_STRIDE);
static_assert(static_cast<int>(Status::overlap) == NURBS_ERROR_OVERLAP);
static_assert(static_cast<int>(Status::flags) == NURBS_ERROR_FLAGS);
static_assert(static_cast<int>(Status::order) == NURBS_ERROR_ORDER);
static_assert(static_cast<int>(Status::knot_not_finite) == NURBS_ERROR_KNOT_NOT_FINITE);
static_assert(static_cast<int>(Status::knots_decreasing) == NURBS_ERROR_KNOTS_DECREASING);
static_assert(static_cast<int>(Status::end_multiplicity) == NURBS_ERROR_END_MULTIPLICITY);
static_assert(static_cast<int>(Status::multiplicity) == NURBS_ERROR_MULTIPLICITY);
static_assert(static_cast<int>(Status::empty_domain) == NURBS_ERROR_EMPTY_DOMAIN);
static_assert(static_cast<int>(Status::point_not_finite) == NURBS_ERROR_POINT_NOT_FINITE);
static_assert(static_cast<int>(Status::weight_not_finite) == NURBS_ERROR_WEIGHT_NOT_FINITE);
static_assert(static_cast<int>(Status::weight_negative) == NURBS_ERROR_WEIGHT_NEGATIVE);
static_assert(static_cast<int>(Status::weights_vanish) == NURBS_ERROR_WEIGHTS_VANISH);
static_assert(static_cast<int>(Status::parameter_not_finite) == NURBS_ERROR_PARAMETER_NOT_FINITE);
static_assert(static_cast<int>(Status::periodic_knots) == NURBS_ERROR_PERIODIC_KNOTS);
static_assert(static_cast<int>(Status::periodic_points) == NURBS_ERROR_PERIODIC_POINTS);
static_assert(static_cast<int>(Status::times) == NURBS_ERROR_TIMES);
static_assert(static_cast<int>(Status::options) == NURBS_ERROR_OPTIONS);
static_assert(static_cast<int>(Status::index) == NURBS_ERROR_INDEX);
static_assert(static_cast<int>(Status::direction) == NURBS_ERROR_DIRECTION);
static_assert(static_cast<int>(Status::end_knot) == NURBS_ERROR_END_KNOT);
static_assert(static_cast<int>(Status::not_a_knot) == NURBS_ERROR_NOT_A_KNOT);
static_assert(static_cast<int>(Status::matrix) == NURBS_ERROR_MATRIX);
static_assert(static_cast<int>(Status::rational) == NURBS_ERROR_RATIONAL);
static_assert(static_cast<int>(Status::incompatible) == NURBS_ERROR_INCOMPATIBLE);
static_assert(static_cast<int>(Status::gap) == NURBS_ERROR_GAP);
static_assert(static_cast<int>(Status::tolerance) == NURBS_ERROR_TOLERANCE);
static_assert(static_cast<int>(Status::not_periodic) == NURBS_ERROR_NOT_PERIODIC);
static_assert(static_cast<int>(Status::end_weights) == NURBS_ERROR_END_WEIGHTS);
static_assert(static_cast<int>(Status::factor) == NURBS_ERROR_FACTOR);
static_assert(static_cast<int>(Status::continuity) == NURBS_ERROR_CONTINUITY);
static_assert(static_cast<int>(Status::weight_sign) == NURBS_ERROR_WEIGHT_SIGN);
static_assert(static_cast<int>(Status::periodic) == NURBS_ERROR_PERIODIC);
static_assert(static_cast<int>(Status::end) == NURBS_ERROR_END);
static_assert(static_cast<int>(Status::basis) == NURBS_ERROR_BASIS);
static_assert(static_cast<int>(Status::not_monotone) == NURBS_ERROR_NOT_MONOTONE);
static_assert(static_cast<int>(Status::angle) == NURBS_ERROR_ANGLE);
static_assert(static_cast<int>(Status::length) == NURBS_ERROR_LENGTH);
static_assert(static_cast<int>(Status::collinear) == NURBS_ERROR_COLLINEAR);
static_assert(static_cast<int>(Status::conic) == NURBS_ERROR_CONIC);
static_assert(static_cast<int>(Status::form) == NURBS_ERROR_FORM);
static_assert(static_cast<int>(Status::tangent) == NURBS_ERROR_TANGENT);
static_assert(static_cast<int>(Status::twist) == NURBS_ERROR_TWIST);
static_assert(static_cast<int>(Status::twist_rule) == NURBS_ERROR_TWIST_RULE);
static_assert(static_cast<int>(Status::influence) == NURBS_ERROR_INFLUENCE);
static_assert(static_cast<int>(Status::contradiction) == NURBS_ERROR_CONTRADICTION);
static_assert(static_cast<int>(Status::constraint) == NURBS_ERROR_CONSTRAINT);
static_assert(static_cast<int>(Status::off_polygon) == NURBS_ERROR_OFF_POLYGON);
static_assert(static_cast<int>(Status::rule) == NURBS_ERROR_RULE);
static_assert(static_cast<int>(Status::schoenberg_whitney) == NURBS_ERROR_SCHOENBERG_WHITNEY);
static_assert(static_cast<int>(Status::rank) == NURBS_ERROR_RANK);
static_assert(static_cast<int>(Status::scale) == NURBS_ERROR_SCALE);
static_assert(static_cast<int>(Status::orientation) == NURBS_ERROR_ORIENTATION);
static_assert(static_cast<int>(Status::same) == NURBS_ERROR_SAME);
static_assert(static_cast<int>(Status::crossing) == NURBS_ERROR_CROSSING);
static_assert(static_cast<int>(Status::outside_domain) == NURBS_ERROR_OUTSIDE_DOMAIN);
static_assert(static_cast<int>(Status::not_representable) == NURBS_ERROR_NOT_REPRESENTABLE);
static_assert(static_cast<int>(Status::knots_merge) == NURBS_ERROR_KNOTS_MERGE);
static_assert(static_cast<int>(Status::not_converged) == NURBS_ERROR_NOT_CONVERGED);
static_assert(static_cast<int>(Status::memory) == NURBS_ERROR_MEMORY);
static_assert(static_cast<int>(Status::file) == NURBS_ERROR_FILE);
static_assert(static_cast<int>(Status::too_large) == NURBS_ERROR_TOO_LARGE);
static_assert(static_cast<int>(Status::cancelled) == NURBS_ERROR_CANCELLED);
static_assert(static_cast<int>(Status::work) == NURBS_ERROR_WORK);
static_assert(static_cast<int>(Status::format) == NURBS_ERROR_FORMAT);
static_assert(static_cast<int>(Status::truncated) == NURBS_ERROR_TRUNCATED);
static_assert(static_cast<int>(Status::syntax) == NURBS_ERROR_SYNTAX);
static_assert(static_cast<int>(Status::unsupported) == NURBS_ERROR_UNSUPPORTED);
static_assert(static_cast<int>(Status::checksum) == NURBS_ERROR_CHECKSUM);
static_assert(static_cast<int>(Status::version) == NURBS_ERROR_VERSION);
static_assert(static_cast<int>(Status::cycle) == NURBS_ERROR_CYCLE);
static_assert(static_cast<int>(Status::internal) == NURBS_ERROR_INTERNAL);

static_assert(static_cast<int>(closest::closest_certified) == NURBS_CLOSEST_CERTIFIED);
static_assert(static_cast<int>(closest::closest_boundary) == NURBS_CLOSEST_BOUNDARY);
static_assert(static_cast<int>(closest::closest_not_unique) == NURBS_CLOSEST_NOT_UNIQUE);
static_assert(static_cast<int>(closest::closest_budget) == NURBS_CLOSEST_BUDGET);
static_assert(static_cast<int>(closest::closest_invalid) == NURBS_CLOSEST_INVALID);
static_assert(static_cast<int>(closest::closest_coarse) == NURBS_CLOSEST_COARSE);
static_assert(static_cast<int>(closest::closest_singular) == NURBS_CLOSEST_SINGULAR);
static_assert(static_cast<int>(closest::closest_left) == NURBS_CLOSEST_LEFT);

static_assert(static_cast<int>(closest::critical_minimum) == NURBS_CRITICAL_MINIMUM);
static_assert(static_cast<int>(closest::critical_maximum) == NURBS_CRITICAL_MAXIMUM);
static_assert(static_cast<int>(closest::critical_saddle) == NURBS_CRITICAL_SADDLE);
static_assert(static_cast<int>(closest::critical_undecided) == NURBS_CRITICAL_UNDECIDED);
static_assert(static_cast<int>(intersect::ray_hit) == NURBS_RAY_HIT);
static_assert(static_cast<int>(intersect::ray_certified) == NURBS_RAY_CERTIFIED);
static_assert(static_cast<int>(intersect::ray_touch) == NURBS_RAY_TOUCH);
static_assert(static_cast<int>(intersect::ray_back) == NURBS_RAY_BACK);
static_assert(static_cast<int>(model::side_inside) == NURBS_SIDE_INSIDE);
static_assert(static_cast<int>(model::side_on) == NURBS_SIDE_ON);
static_assert(static_cast<int>(model::side_outside) == NURBS_SIDE_OUTSIDE);
static_assert(static_cast<int>(model::side_undecided) == NURBS_SIDE_UNDECIDED);

static_assert(static_cast<int>(recognize::shape_none) == NURBS_SHAPE_NONE);
static_assert(static_cast<int>(recognize::shape_point) == NURBS_SHAPE_POINT);
static_assert(static_cast<int>(recognize::shape_line) == NURBS_SHAPE_LINE);
static_assert(static_cast<int>(recognize::shape_circle) == NURBS_SHAPE_CIRCLE);
static_assert(static_cast<int>(recognize::shape_ellipse) == NURBS_SHAPE_ELLIPSE);
static_assert(static_cast<int>(recognize::shape_parabola) == NURBS_SHAPE_PARABOLA);
static_assert(static_cast<int>(recognize::shape_hyperbola) == NURBS_SHAPE_HYPERBOLA);
static_assert(static_cast<int>(recognize::shape_plane) == NURBS_SHAPE_PLANE);
static_assert(static_cast<int>(recognize::shape_sphere) == NURBS_SHAPE_SPHERE);
static_assert(static_cast<int>(recognize::shape_cylinder) == NURBS_SHAPE_CYLINDER);
static_assert(static_cast<int>(recognize::shape_cone) == NURBS_SHAPE_CONE);
static_assert(static_cast<int>(recognize::shape_torus) == NURBS_SHAPE_TORUS);

static_assert(static_cast<int>(recognize::conic_ellipse) == NURBS_CONIC_ELLIPSE);
static_assert(static_cast<int>(recognize::conic_parabola) == NURBS_CONIC_PARABOLA);
static_assert(static_cast<int>(recognize::conic_hyperbola) == NURBS_CONIC_HYPERBOLA);
static_assert(static_cast<int>(recognize::conic_chord) == NURBS_CONIC_CHORD);
static_assert(static_cast<int>(recognize::conic_legs) == NURBS_CONIC_LEGS);
static_assert(static_cast<int>(recognize::conic_line) == NURBS_CONIC_LINE);

static_assert(static_cast<int>(build::arc_quarters) == NURBS_ARC_QUARTERS);
static_assert(static_cast<int>(build::arc_thirds) == NURBS_ARC_THIRDS);
static_assert(static_cast<int>(build::arc_smooth) == NURBS_ARC_SMOOTH);

static_assert(static_cast<int>(build::twist_compatible) == NURBS_TWIST_COMPATIBLE);
static_assert(static_cast<int>(build::twist_average) == NURBS_TWIST_AVERAGE);
static_assert(static_cast<int>(build::twist_given) == NURBS_TWIST_GIVEN);
static_assert(static_cast<int>(build::twist_zero) == NURBS_TWIST_ZERO);
static_assert(static_cast<int>(build::twist_bilinear) == NURBS_TWIST_BILINEAR);
static_assert(static_cast<int>(build::twist_adini) == NURBS_TWIST_ADINI);

static_assert(static_cast<int>(modify::constrain_value) == NURBS_CONSTRAIN_VALUE);
static_assert(static_cast<int>(modify::constrain_direction) == NURBS_CONSTRAIN_DIRECTION);
static_assert(static_cast<int>(modify::constrain_normal) == NURBS_CONSTRAIN_NORMAL);
static_assert(static_cast<int>(modify::constrain_curvature) == NURBS_CONSTRAIN_CURVATURE);

static_assert(static_cast<int>(analysis::feature_inflection) == NURBS_FEATURE_INFLECTION);
static_assert(static_cast<int>(analysis::feature_curvature_maximum) == NURBS_FEATURE_CURVATURE_MAXIMUM);
static_assert(static_cast<int>(analysis::feature_curvature_minimum) == NURBS_FEATURE_CURVATURE_MINIMUM);
static_assert(static_cast<int>(analysis::feature_cusp) == NURBS_FEATURE_CUSP);
static_assert(static_cast<int>(analysis::feature_kink) == NURBS_FEATURE_KINK);
static_assert(static_cast<int>(analysis::feature_jump) == NURBS_FEATURE_JUMP);
static_assert(static_cast<int>(analysis::feature_torsion) == NURBS_FEATURE_TORSION);

static_assert(static_cast<int>(analysis::convexity_none) == NURBS_CONVEXITY_NONE);
static_assert(static_cast<int>(analysis::convexity_left) == NURBS_CONVEXITY_LEFT);
static_assert(static_cast<int>(analysis::convexity_right) == NURBS_CONVEXITY_RIGHT);
static_assert(static_cast<int>(analysis::convexity_straight) == NURBS_CONVEXITY_STRAIGHT);
static_assert(static_cast<int>(analysis::convexity_undecided) == NURBS_CONVEXITY_UNDECIDED);

static_assert(static_cast<int>(analysis::fold_none) == NURBS_FOLD_NONE);
static_assert(static_cast<int>(analysis::fold_found) == NURBS_FOLD_FOUND);
static_assert(static_cast<int>(analysis::fold_undecided) == NURBS_FOLD_UNDECIDED);

static_assert(eval::frame_limit == NURBS_FRAME_LIMIT);
static_assert(eval::frame_normal_limit == NURBS_FRAME_NORMAL_LIMIT);
static_assert(eval::frame_rule == NURBS_FRAME_RULE);
static_assert(eval::frame_undefined == NURBS_FRAME_UNDEFINED);

static_assert(max_degree == NURBS_MAX_DEGREE);
static_assert(max_axes == NURBS_MAX_AXES);

} // namespace nrb
