// libnurbs, through its C API.
#include "bench/operations/nurbs_work.h"

int main(int argc, char **argv) {
    return bench::run(argc, argv, "libnurbs", bench::nurbs_work);
}
