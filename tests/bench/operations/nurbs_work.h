// libnurbs, through its C API.
#pragma once

#include "bench/operations/task.h"

namespace bench {

Work nurbs_work(const Task &task);

} // namespace bench
