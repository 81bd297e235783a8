/* SPDX-License-Identifier: MIT */
#ifndef NURBS_TESTS_CAPI_GUARDED_BATCHES_H
#define NURBS_TESTS_CAPI_GUARDED_BATCHES_H

#include "calls/calls.h"

// What is evaluated for many points at once, for one to 17 of them, in several layouts.
void evaluate_batches();

// The same for none, with pointers that are NULL.
void evaluate_nothing(const calls::Inputs &in);

#endif
