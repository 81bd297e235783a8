// This library, through its C interface, as a user calls it.
#pragma once

#include "bench/harness.h"

namespace bench {

Work nurbs_work(const Job &job, const Case &data, Output &output);

} // namespace bench
