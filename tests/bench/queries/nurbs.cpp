// libnurbs, through its C API, all points in one call.
#include "bench/queries/nurbs_work.h"

int main(int argc, char **argv) {
    return bench::run(argc, argv, {{"libnurbs", bench::nurbs_ask}});
}
