// SPDX-License-Identifier: MIT
// Refuses patches that are given twice.
#pragma once

#include "face/face.h"

#include <vector>

namespace nrb::model {

// Throws Status::same, naming both, if two faces are the same object, or have surfaces and curves of loops
// that are equal bit for bit.
void refuse_twice(const std::vector<face::FacePtr> &faces);

} // namespace nrb::model
