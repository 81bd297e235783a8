/* SPDX-License-Identifier: MIT */
/* One side of a ship's hull, for hull.c and sections.c. */
#ifndef GALLERY_HULL_H
#define GALLERY_HULL_H

#include "draw.h"

enum { STATIONS = 8, WATERLINES = 5 };

/* Control points: stations from bow to stern, on each the waterlines from the keel to the deck. */
static inline nurbs *make_hull(void) {
    static const double beam[STATIONS] = {0, 0.35, 0.9, 1.25, 1.3, 1.2, 0.9, 0.6};
    static const double height[WATERLINES] = {-1.2, -1.1, -0.5, 0.3, 0.9};
    static const double fullness[WATERLINES] = {0, 0.6, 0.9, 1, 1.05};
    static const int32_t degrees[2] = {3, 3};
    static const int64_t counts[2] = {STATIONS, WATERLINES};
    double knots[STATIONS + WATERLINES + 8], points[3 * STATIONS * WATERLINES], *p = points;
    nurbs *hull;
    int i, j;
    for (i = 0; i < STATIONS; ++i) {
        for (j = 0; j < WATERLINES; ++j) {
            *p++ = beam[i] * fullness[j];
            *p++ = 4 - 8.0 * i / (STATIONS - 1) + (i == 0 ? 0.4 * height[j] : 0); /* the stem is raked */
            *p++ = height[j];
        }
    }
    check(nurbs_knots_open_uniform(3, STATIONS, 0, 1, STATIONS + 4, knots));
    check(nurbs_knots_open_uniform(3, WATERLINES, 0, 1, WATERLINES + 4, knots + STATIONS + 4));
    check(nurbs_create(2, degrees, counts, knots, STATIONS + WATERLINES + 8, 3, points, 0, 0, NULL, 0, 0,
                       &hull));
    return hull;
}

#endif
