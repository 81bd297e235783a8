// SPDX-License-Identifier: MIT
// Bounds the distances of a triangle T by its star, as MeshBound does, but looks at each of the triangles U of the
// star instead of at the worst values of all. Everything is seen along the normal n of T.
//
// Let a be the largest angle between n and a normal of the star, and a_U that of U. On each U consider the function
// that is 1 at the corners of T and 0 at others: its gradient is 1 / m_U, where m_U is the altitude of the corner of
// U that is alone in having its value. With the least m of all m_U, every path from T out of the star is at least
// m cos a long. So the images of the outer sides of the star wind once around each point of T if they are nearer to
// these sides than that.
// - A point x of S(T) that comes out over side k, at height h and by r < m cos a, is over the star, whose distance
//   from the plane of T is at most r tan a there. If it comes out over the triangle across that side only, it is at
//   most r tan b, where b is the angle between both. So the distance of x is at most h + r tan a, or h + r tan b.
// - Over each point p of T there is a point x of the surface that belongs to the star. If it belongs to S(T), its
//   distance is at most the height over T. Else it belongs to an S(U), and comes out of U.
//   If U shares a side with T, the distance is that of MeshBound by sides.
//   If U shares one corner P only, x may be excluded: if S(U) comes out over both sides at P within angles that are
//   smaller than those of the triangles between U and T around P, no point of S(U) is over T.
//   Else, let f be where the line along n through x and p meets the plane of U. It is at most h' / cos a_U from x,
//   and at most r = r' + h' tan a_U from U, where h' bounds the height and r' how far S(U) comes out. The way from
//   there to p, no longer than r, stays in the star, and the plane of U parts from the star with a slope of at most
//   t = max |n_U - n_V| / cos^2 a over all triangles V of the star: for unit vectors whose third components are at
//   least c, the gradients of the planes differ by at most |n_U - n_V| / c^2. So |px| <= h' / cos a_U + r t.
#pragma once

#include "mesh/proof/neighbours.h"
#include "mesh/proof/triangle_bound.h"

#include <span>

namespace nrb::mesh {

// Precondition: no corner of the triangle is on the border of the mesh, and the star does not cover the plane more
// than once where its normals are near that of the triangle. Infinite where nothing is proven.
// Bounds of at most `enough` are not improved any further.
Distances star_bound(const Neighbours &neighbours, std::span<const TriangleBound> bounds, size_t triangle,
                     double enough);

} // namespace nrb::mesh
