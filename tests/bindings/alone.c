/* SPDX-License-Identifier: MIT */
/* The header stands alone, may be included twice, and needs nothing before it. */
#include <nurbs/nurbs.h>

int main(void) {
    return nurbs_version() == NURBS_VERSION ? 0 : 1;
}
