/* SPDX-License-Identifier: MIT */
/* Every construction of a shape that is one call, drawn into one picture: gallery.svg, or the file that is
 * named.
 * Compile: cc -std=c99 gallery.c $(pkg-config --cflags --libs nurbs) -lm -o gallery */
#include "gallery/boundaries.h"
#include "gallery/curves.h"
#include "gallery/data.h"
#include "gallery/fits.h"
#include "gallery/quadrics.h"
#include "gallery/sweeps.h"

enum { COLUMNS = 7, ROWS = 10 };

int main(int argc, char **argv) {
    static gallery picture;
    if (argc > 2) {
        fprintf(stderr, "usage: gallery [PICTURE.svg]\n");
        return 2;
    }
    open_picture(&picture, argc == 2 ? argv[1] : "gallery.svg", COLUMNS, ROWS);
    show_curves(&picture);
    show_sweeps(&picture);
    show_quadrics(&picture);
    show_boundaries(&picture);
    show_fits(&picture);
    show_data(&picture);
    close_picture(&picture);
    printf("%d constructions\n", picture.cells);
    return 0;
}
