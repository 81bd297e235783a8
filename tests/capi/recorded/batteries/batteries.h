/* SPDX-License-Identifier: MIT */
// Calls for any spline, of every function that takes one, most of them with several choices of the other
// arguments. What does not suit a spline is refused, which is an answer too.
#ifndef NURBS_TESTS_CAPI_RECORDED_BATTERIES_H
#define NURBS_TESTS_CAPI_RECORDED_BATTERIES_H

#include "recorded/outputs.h"
#include "recorded/subject.h"

namespace recorded {

void call_getters(const Subject &s);
void call_points(const Subject &s);
void call_frames(const Subject &s);
void call_bases(const Subject &s);
void call_conversions(const Subject &s);
void call_refinement(const Subject &s);
void call_forms(const Subject &s);
void call_algebra(const Subject &s);
void call_shapes(const Subject &s);
void call_reduction(const Subject &s);
void call_closest(const Subject &s);
void call_distances(const Subject &s);
void call_measures(const Subject &s);
void call_features(const Subject &s);
void call_weights(const Subject &s);
void call_deformation(const Subject &s);

} // namespace recorded

#endif
