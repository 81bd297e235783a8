// SPDX-License-Identifier: MIT
// Patches that are given twice.
#pragma once

#include "face/face.h"

#include <vector>

namespace nrb::model {

// Throws Status::same, naming both, if two faces are one, or equal bit for bit in their surfaces and curves.
void refuse_twice(const std::vector<face::FacePtr> &faces);

} // namespace nrb::model
