// libnurbs, through its C API, all points in one call.
#pragma once

#include "bench/queries/question.h"

namespace bench {

Ask nurbs_ask(const Question &question);

} // namespace bench
