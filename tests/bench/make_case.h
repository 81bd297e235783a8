// Splines and parameters from a fixed seed, with exact results.
#pragma once

#include "bench/case.h"
#include "bench/jobs.h"

namespace bench {

Case make_case(const Job &job);

} // namespace bench
