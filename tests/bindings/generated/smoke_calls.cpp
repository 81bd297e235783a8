// SPDX-License-Identifier: MIT
// Generated from tests/capi/calls/*.toml, include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
// clang-format off
#include "smoke_support.hpp"

namespace {

namespace n = libnurbs;

const std::string file = R"(a file of the test programs                                             S      1
1H,,1H;,4Htest,8Htest.igs,4Hnone,4Hnone,32,38,6,308,15,4Htest,1.,2,2HMM,G      1
1,0.01,15H20260101.000000,1.E-6,10.,2Hme,4Hhere,11,0,15H20260101.000000;G      2
     126       1       0       1       0       0       0       000000000D      1
     126       0       0       2       0                                D      2
     116       3       0       1       0       0       0       000000000D      3
     116       0       0       1       0                                D      4
     126       4       0       1       0       0       0       000000000D      5
     126       0       0       1       0                     BOW        D      6
126,3,3,0,0,1,0,0,0,0,0,1,1,1,1,1,1,1,1,                               1P      1
0,0,0,1,2,0,3,2,0,4,0,0,0,1;                                           1P      2
116,0,0,0,0;                                                           3P      3
126,1,1,0,0,0,0,0,0,1,1,1,2,0,0,0,1,1,1,0,1;                           5P      4
S      1G      2D      6P      4                                        T      1
)";

std::string file_path() {
    return written("smoke_calls_cpp.file", file);
}

const std::string solid = R"(ISO-10303-21;
HEADER;
FILE_SCHEMA(('AUTOMOTIVE_DESIGN'));
ENDSEC;
DATA;
#1=CARTESIAN_POINT('',(0.,0.,0.));
#2=DIRECTION('',(0.,0.,1.));
#3=DIRECTION('',(1.,0.,0.));
#4=AXIS2_PLACEMENT_3D('',#1,#2,#3);
#5=CARTESIAN_POINT('',(1.,0.,0.));
#6=VERTEX_POINT('',#5);
#7=CIRCLE('',#4,1.);
#8=EDGE_CURVE('',#6,#6,#7,.T.);
#9=PLANE('',#4);
#10=SPHERICAL_SURFACE('',#4,1.);
#11=ORIENTED_EDGE('',*,*,#8,.F.);
#12=EDGE_LOOP('',(#11));
#13=FACE_OUTER_BOUND('',#12,.T.);
#14=ADVANCED_FACE('disk',(#13),#9,.F.);
#15=ORIENTED_EDGE('',*,*,#8,.T.);
#16=EDGE_LOOP('',(#15));
#17=FACE_OUTER_BOUND('',#16,.T.);
#18=ADVANCED_FACE('half ball',(#17),#10,.T.);
#19=CLOSED_SHELL('',(#14,#18));
#20=MANIFOLD_SOLID_BREP('',#19);
#21=BLOCK('',#4,1.,1.,1.);
#22=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));
#23=(GEOMETRIC_REPRESENTATION_CONTEXT(3)
GLOBAL_UNIT_ASSIGNED_CONTEXT((#22))REPRESENTATION_CONTEXT('',''));
#24=SHAPE_REPRESENTATION('',(#20,#21),#23);
ENDSEC;
END-ISO-10303-21;
)";

std::string solid_path() {
    return written("smoke_calls_cpp.solid", solid);
}

const std::string layers = R"(ISO-10303-21;
HEADER;
FILE_SCHEMA(('AUTOMOTIVE_DESIGN'));
ENDSEC;
DATA;
#1=CARTESIAN_POINT('',(0.,0.,0.));
#2=CARTESIAN_POINT('',(2.,0.,0.));
#3=CARTESIAN_POINT('',(0.,4.,0.));
#4=DIRECTION('',(0.,0.,1.));
#5=DIRECTION('',(1.,0.,0.));
#6=AXIS2_PLACEMENT_3D('',#1,#4,#5);
#7=PLANE('',#6);
#8=POLY_LOOP('',(#1,#2,#3));
#9=FACE_OUTER_BOUND('',#8,.T.);
#10=ADVANCED_FACE('',(#9),#7,.T.);
#11=POLYLINE('',(#1,#2));
#12=PRESENTATION_LAYER_ASSIGNMENT('sheet','',(#10,#11));
#13=PRESENTATION_LAYER_ASSIGNMENT('axis','',(#10,#11));
ENDSEC;
END-ISO-10303-21;
)";

const std::string replaced = R"(an older file
)";

std::string replaced_path() {
    return written("smoke_calls_cpp.replaced", replaced);
}

constexpr unsigned char no_data[] = {137, 78, 85, 82, 13, 10, 26, 10, 1, 0, 0, 0, 3, 0, 0, 0, 192, 0, 0, 0, 0, 0, 0, 0, 114, 160, 102, 241, 94, 129, 142, 24, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 7, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 240, 63, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};

constexpr unsigned char loop_bytes[] = {137, 78, 85, 82, 13, 10, 26, 10, 1, 0, 0, 0, 1, 0, 0, 0, 96, 1, 0, 0, 0, 0, 0, 0, 97, 220, 175, 73, 171, 169, 167, 134, 1, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 6, 0, 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 240, 63, 0, 0, 0, 0, 0, 0, 0, 64, 0, 0, 0, 0, 0, 0, 8, 64, 0, 0, 0, 0, 0, 0, 16, 64, 0, 0, 0, 0, 0, 0, 20, 64, 0, 0, 0, 0, 0, 0, 24, 64, 0, 0, 0, 0, 0, 0, 28, 64, 0, 0, 0, 0, 0, 0, 32, 64, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 240, 63, 0, 0, 0, 0, 0, 0, 240, 63, 0, 0, 0, 0, 0, 0, 240, 191, 0, 0, 0, 0, 0, 0, 240, 63, 0, 0, 0, 0, 0, 0, 240, 191, 0, 0, 0, 0, 0, 0, 240, 191, 0, 0, 0, 0, 0, 0, 240, 63, 0, 0, 0, 0, 0, 0, 240, 191, 0, 0, 0, 0, 0, 0, 240, 63, 0, 0, 0, 0, 0, 0, 240, 63, 0, 0, 0, 0, 0, 0, 240, 191, 0, 0, 0, 0, 0, 0, 240, 63};

constexpr unsigned char list_bytes[] = {137, 78, 85, 82, 13, 10, 26, 10, 1, 0, 0, 0, 2, 0, 0, 0, 128, 2, 0, 0, 0, 0, 0, 0, 115, 101, 65, 29, 65, 41, 203, 126, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 252, 169, 241, 210, 77, 98, 80, 63, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 97, 98, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 128, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 137, 78, 85, 82, 13, 10, 26, 10, 1, 0, 0, 0, 1, 0, 0, 0, 200, 0, 0, 0, 0, 0, 0, 0, 235, 190, 19, 224, 60, 109, 135, 43, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 192, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 240, 63, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 20, 64, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};

constexpr unsigned char face_bytes[] = {137, 78, 85, 82, 13, 10, 26, 10, 1, 0, 0, 0, 4, 0, 0, 0, 192, 3, 0, 0, 0, 0, 0, 0, 56, 218, 45, 130, 130, 9, 70, 207, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 255, 255, 255, 255, 255, 255, 255, 255, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 128, 1, 0, 0, 0, 0, 0, 0, 192, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 137, 78, 85, 82, 13, 10, 26, 10, 1, 0, 0, 0, 1, 0, 0, 0, 32, 1, 0, 0, 0, 0, 0, 0, 169, 227, 47, 52, 97, 141, 100, 180, 2, 0, 0, 0, 3, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 192, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 240, 63, 0, 0, 0, 0, 0, 0, 240, 63, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 240, 63, 0, 0, 0, 0, 0, 0, 240, 63, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 8, 64, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 64, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 64, 0, 0, 0, 0, 0, 0, 8, 64, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 137, 78, 85, 82, 13, 10, 26, 10, 1, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 236, 145, 236, 61, 80, 26, 21, 238, 1, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 4, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 192, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 240, 63, 0, 0, 0, 0, 0, 0, 0, 64, 0, 0, 0, 0, 0, 0, 8, 64, 0, 0, 0, 0, 0, 0, 8, 64, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 240, 63, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 240, 63, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};

constexpr unsigned char model_bytes[] = {137, 78, 85, 82, 13, 10, 26, 10, 1, 0, 0, 0, 5, 0, 0, 0, 64, 8, 0, 0, 0, 0, 0, 0, 7, 61, 156, 237, 55, 224, 208, 143, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 3, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 252, 169, 241, 210, 77, 98, 80, 63, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 255, 255, 255, 255, 255, 255, 255, 255, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 240, 63, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 240, 63, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 240, 63, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 255, 255, 255, 255, 255, 255, 255, 255, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 255, 255, 255, 255, 255, 255, 255, 255, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 255, 255, 255, 255, 255, 255, 255, 255, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 255, 255, 255, 255, 255, 255, 255, 255, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 48, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 64, 4, 0, 0, 0, 0, 0, 0, 128, 5, 0, 0, 0, 0, 0, 0, 128, 6, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 137, 78, 85, 82, 13, 10, 26, 10, 1, 0, 0, 0, 1, 0, 0, 0, 32, 1, 0, 0, 0, 0, 0, 0, 169, 227, 47, 52, 97, 141, 100, 180, 2, 0, 0, 0, 3, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 192, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 240, 63, 0, 0, 0, 0, 0, 0, 240, 63, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 240, 63, 0, 0, 0, 0, 0, 0, 240, 63, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 8, 64, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 64, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 64, 0, 0, 0, 0, 0, 0, 8, 64, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 137, 78, 85, 82, 13, 10, 26, 10, 1, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 236, 145, 236, 61, 80, 26, 21, 238, 1, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 4, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 192, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 240, 63, 0, 0, 0, 0, 0, 0, 0, 64, 0, 0, 0, 0, 0, 0, 8, 64, 0, 0, 0, 0, 0, 0, 8, 64, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 240, 63, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 240, 63, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 137, 78, 85, 82, 13, 10, 26, 10, 1, 0, 0, 0, 1, 0, 0, 0, 168, 1, 0, 0, 0, 0, 0, 0, 150, 234, 15, 242, 87, 183, 219, 255, 1, 0, 0, 0, 3, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 7, 0, 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 240, 63, 0, 0, 0, 0, 0, 0, 240, 63, 0, 0, 0, 0, 0, 0, 0, 64, 0, 0, 0, 0, 0, 0, 0, 64, 0, 0, 0, 0, 0, 0, 8, 64, 0, 0, 0, 0, 0, 0, 8, 64, 0, 0, 0, 0, 0, 0, 8, 64, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 240, 63, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 64, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 240, 63, 0, 0, 0, 0, 0, 0, 248, 63, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 8, 64, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 248, 63, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};

struct Inputs {
    n::Spline curve = n::Spline::create({2}, {9}, {0.0, 0.0, 0.0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1.0, 1.0, 1.0}, 2, {1.0, 0.0, 1.0, 1.0, 0.0, 1.0, -1.0, 1.0, -1.0, 0.0, -1.0, -1.0, 0.0, -1.0, 1.0, -1.0, 1.0, 0.0}, {1.0, 0.7071067811865476, 1.0, 0.7071067811865476, 1.0, 0.7071067811865476, 1.0, 0.7071067811865476, 1.0}, 0u);
    n::Spline loop = n::Spline::create({2}, {6}, {0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0}, 2, {1.0, 1.0, -1.0, 1.0, -1.0, -1.0, 1.0, -1.0, 1.0, 1.0, -1.0, 1.0}, {}, 1u);
    n::Spline surface = n::Spline::create({2, 1}, {3, 4}, {0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 0.0, 0.0, 1.0, 2.0, 3.0, 3.0}, 3, {0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 2.0, 2.0, 0.0, 3.0, 3.0, 0.5, 0.0, 0.0, 0.5, 1.0, 1.0, 0.5, 2.0, 2.0, 0.5, 3.0, 3.0, 1.0, 0.0, 1.0, 1.0, 1.0, 2.0, 1.0, 2.0, 3.0, 1.0, 3.0, 4.0}, {}, 0u);
    n::Spline volume = n::Spline::create({1, 1, 1}, {2, 2, 2}, {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 1.0}, 4, {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0}, {}, 0u);
    n::Spline solid = n::Spline::create({1, 2, 1}, {3, 3, 2}, {0.0, 0.0, 0.5, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 0.0, 0.0, 1.0, 1.0}, 3, {0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.5, 0.0, 0.0, 0.5, 1.0, 0.25, 1.0, 0.0, 0.25, 1.0, 1.0, 0.5, 0.0, 0.0, 0.5, 0.0, 1.0, 0.5, 0.5, 0.0, 0.5, 0.5, 1.0, 0.75, 1.0, 0.0, 0.75, 1.0, 1.0, 1.0, 0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.5, 0.0, 1.0, 0.5, 1.0, 1.25, 1.0, 0.0, 1.25, 1.0, 1.0}, {}, 0u);
    n::Spline homogeneous = n::Spline::create_homogeneous({2}, {3}, {0.0, 0.0, 0.0, 1.0, 1.0, 1.0}, 2, {1.0, 0.0, 1.0, 0.0, 1.0, 0.0, -1.0, 0.0, 1.0}, 0u);
    n::Spline twist = n::Spline::create({3}, {4}, {0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0}, 3, {0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 2.0, 1.0, 0.0, 3.0, 3.0, 3.0}, {}, 0u);
    n::Spline segment = n::Spline::create({2}, {3}, {0.0, 1.0, 2.0, 3.0, 4.0, 5.0}, 2, {0.0, 0.0, 1.0, 1.0, 2.0, 0.0}, {1.0, 3.0, 5.0}, 0u);
    n::List list = n::List::read(std::as_bytes(std::span(file)));
    n::Statistics no_statistics = n::Statistics::create({2}, {3}, {0.0, 0.5, 1.0}, 1, 4.0, 1.0);
    n::Statistics statistics = [&] { n::Data data; data.n = 5; data.axes = 1; data.dim = 1; static constexpr double data_params[] = {0.0, 0.25, 0.5, 0.75, 1.0}; data.params = data_params; static constexpr double data_values[] = {0.0, 1.0, 2.0, 1.0, 0.0}; data.values = data_values; return no_statistics.add(data); }();
    n::Spline outline = n::Spline::create({1}, {4}, {0.0, 0.0, 1.0, 2.0, 3.0, 3.0}, 2, {0.25, 1.0, 0.75, 1.0, 0.5, 2.0, 0.25, 1.0}, {}, 0u);
    n::Face face = n::Face::create(surface, {1}, std::vector<n::Spline>{outline}, {}, {}, 0.001, 0u);
    n::Model model = n::Model::create(std::vector<n::Face>{face, face}, 0.001);
    n::Model layered = n::Model::read(std::as_bytes(std::span(layers)));
    n::Meet meet = n::Meet::sections(surface, std::array<double, 3>{0.0, 0.0, 1.0}, {0.5, 2.0}, 0.001);
    n::Mesh mesh = [&] { n::MeshOptions options; options.chord = 1.0; options.relative_chord = 0.0; return n::Mesh::of_face(face, options); }();
    n::Mesh block = [&] { n::MeshOptions options; options.chord = 0.1; options.relative_chord = 0.0; return n::Mesh::of_volume(solid, options, 100); }();
};

void data(const Inputs &in) {
    {
        begin("clone");
        const auto found = in.curve.clone();
        show("out", found);
    }
    by_hand("destroy");
    {
        begin("with_points");
        const auto found = in.curve.with_points({1.0, 0.0, 1.0, 1.0, 0.0, 1.0, -1.0, 1.0, -1.0, 0.0, -1.0, -1.0, 0.0, -1.0, 1.0, -1.0, 1.0, 0.0});
        show("out", found);
    }
    {
        begin("with_points rational");
        const auto found = in.curve.with_points({1.0, 0.0, 1.0, 1.0, 0.0, 1.0, -1.0, 1.0, -1.0, 0.0, -1.0, -1.0, 0.0, -1.0, 1.0, -1.0, 1.0, 0.0}, {1.0, 0.7071067811865476, 1.0, 0.7071067811865476, 1.0, 0.7071067811865476, 1.0, 0.7071067811865476, 1.0});
        show("out", found);
    }
    {
        begin("create_bezier");
        const auto found = n::Spline::create_bezier({3}, 2, {0.0, 0.0, 1.0, 2.0, 3.0, 2.0, 4.0, 0.0});
        show("out", found);
    }
    {
        begin("create_hermite");
        const auto found = n::create_hermite({0.3, 0.6}, 2, {0.1, 0.9, 0.3, 0.7}, {0.1, 0.9, 0.3, 0.7});
        show("out", found);
    }
    {
        begin("parametrize");
        const auto found = n::parametrize({4}, 2, {0.0, 0.0, 1.0, 2.0, 3.0, 2.0, 4.0, 0.0}, 4, 0.0, 0u);
        show("params", found);
    }
    {
        begin("params_universal");
        const auto found = n::params_universal(3, 7);
        show("params", found);
    }
    {
        begin("tangents");
        const auto found = n::tangents(2, {0.0, 1.0, 3.0, 4.0}, 1, {0.0, 1.0, 2.0, 4.0}, 0u);
        show("tangents", found);
    }
    {
        begin("tangents monotone");
        const auto found = n::tangents(3, {0.0, 1.0, 3.0, 4.0}, 1, {0.0, 1.0, 2.0, 0.0}, 1u);
        show("tangents", found);
    }
    {
        begin("parametrize surface");
        const auto found = n::parametrize({2, 2}, 2, {0.0, 0.0, 1.0, 2.0, 3.0, 2.0, 4.0, 0.0}, 1, 0.0, 0u);
        show("params", found);
    }
    {
        begin("read");
        const auto found = n::List::read(std::as_bytes(std::span(file)));
        show("out", found);
    }
    {
        begin("read in millimetres");
        n::ReadOptions options;
        options.unit = 0.001;
        const auto found = n::List::read(std::as_bytes(std::span(file)), options);
        show("out", found);
    }
    {
        begin("read_file");
        const auto found = n::List::read_file(file_path());
        show("out", found);
    }
    {
        begin("read_file in millimetres");
        n::ReadOptions options;
        options.unit = 0.001;
        const auto found = n::List::read_file(file_path(), options);
        show("out", found);
    }
    {
        begin("list_get");
        const auto found = in.list.operator[](0);
        show("out", found);
    }
    by_hand("list_destroy");
    {
        begin("knots_uniform");
        const auto found = n::knots_uniform(2, 5, 0.0, 1.0);
        show("knots", found);
    }
    {
        begin("knots_open_uniform");
        const auto found = n::knots_open_uniform(2, 5, 0.0, 1.0);
        show("knots", found);
    }
    {
        begin("knots_bezier");
        const auto found = n::knots_bezier(2, 2);
        show("knots", found);
    }
    {
        begin("knots_bezier with breaks");
        const auto found = n::knots_bezier(2, {0.3, 0.6});
        show("knots", found);
    }
    {
        begin("knots_averaged");
        const auto found = n::knots_averaged(2, {0.0, 1.0, 2.0, 3.0, 4.0});
        show("knots", found);
    }
    {
        begin("knots_periodic");
        const auto found = n::knots_periodic(2, {0.0, 1.0, 2.0, 3.0});
        show("knots", found);
    }
    {
        begin("knots_periodic twice");
        const auto found = n::knots_periodic(2, {0.3, 0.6}, {2, 2});
        show("knots", found);
    }
    {
        begin("knots");
        const auto found = in.curve.knots(0);
        show("knots", found);
    }
    {
        begin("short_knots");
        const auto found = in.curve.short_knots(0);
        show("knots", found);
    }
    {
        begin("unwrapped_knots");
        const auto found = in.loop.unwrapped_knots(0);
        show("knots", found);
    }
    {
        begin("unwrapped_points");
        const auto found = in.loop.unwrapped_points();
        show("points", found.points);
        show("weights", found.weights);
    }
    by_hand("to_bytes");
    {
        begin("from_bytes");
        const auto found = n::Spline::from_bytes(std::as_bytes(std::span(loop_bytes)));
        show("out", found);
    }
    {
        begin("bytes_kind");
        const auto found = n::bytes_kind(std::as_bytes(std::span(loop_bytes)));
        show("kind", found.kind);
        show("major", found.major);
        show("minor", found.minor);
    }
    by_hand("list_to_bytes");
    {
        begin("list_from_bytes");
        const auto found = n::List::from_bytes(std::as_bytes(std::span(list_bytes)));
        show("out", found);
    }
    by_hand("face_to_bytes");
    {
        begin("face_from_bytes");
        const auto found = n::Face::from_bytes(std::as_bytes(std::span(face_bytes)));
        show("out", found);
    }
    by_hand("model_to_bytes");
    {
        begin("model_from_bytes");
        const auto found = n::Model::from_bytes(std::as_bytes(std::span(model_bytes)));
        show("out", found);
    }
    {
        begin("list_create");
        const auto found = n::List::create(std::vector<n::Spline>{in.curve, in.loop, in.curve}, {}, 0.001);
        show("out", found);
    }
    {
        begin("distinct_knots");
        const auto found = in.curve.distinct_knots(0);
        show("knots", found.knots);
        show("multiplicities", found.multiplicities);
    }
    {
        begin("greville");
        const auto found = in.curve.greville(0);
        show("abscissae", found);
    }
    {
        begin("points");
        const auto found = in.homogeneous.points();
        show("points", found);
    }
    {
        begin("weights");
        const auto found = in.curve.weights();
        show("weights", found);
    }
    {
        begin("homogeneous_points");
        const auto found = in.curve.homogeneous_points();
        show("points", found);
    }
    {
        begin("detect_periodic");
        const auto found = n::detect_periodic(in.curve, 0);
        show("periodic", found);
    }
    {
        begin("eval_knot_derivative");
        const auto found = n::knot_derivative(in.curve, 0, 4);
        show("out", found);
    }
    {
        begin("eval_knot_derivative of a period");
        const auto found = n::knot_derivative(in.loop, 0, 1);
        show("out", found);
    }
    {
        begin("to_hermite");
        const auto found = n::to_hermite(in.twist);
        show("params", found.params);
        show("points", found.points);
        show("tangents", found.tangents);
    }
    {
        begin("to_power");
        const auto found = n::to_power(in.curve);
        show("coefficients", found.coefficients);
        show("breaks", found.breaks);
        show("piece_counts", found.piece_counts);
    }
    {
        begin("to_power surface");
        const auto found = n::to_power(in.surface);
        show("coefficients", found.coefficients);
        show("breaks", found.breaks);
        show("piece_counts", found.piece_counts);
    }
    {
        begin("bezier_extraction");
        const auto found = n::bezier_extraction(in.curve, 0);
        show("operators", found.operators);
        show("firsts", found.firsts);
        show("domains", found.domains);
    }
    {
        begin("refinement_matrix");
        const auto found = n::refinement_matrix(in.curve, 0, {0.3, 0.6});
        show("values", found.values);
        show("columns", found.columns);
        show("row_pointers", found.row_pointers);
    }
    {
        begin("basis_matrix");
        const auto found = n::basis_matrix(0, 3, 3);
        show("matrix", found);
    }
    {
        begin("decompose");
        const auto found = n::decompose(in.surface);
        show("out", found);
    }
    {
        begin("bezier_pieces");
        const auto found = n::bezier_pieces(in.surface);
        show("points", found.points);
        show("weights", found.weights);
        show("domains", found.domains);
        show("piece_counts", found.piece_counts);
    }
    {
        begin("bezier_pieces rational");
        const auto found = n::bezier_pieces(in.curve);
        show("points", found.points);
        show("weights", found.weights);
        show("domains", found.domains);
        show("piece_counts", found.piece_counts);
    }
    {
        begin("bezier_cells");
        const auto found = n::bezier_cells(in.surface);
        show("own_points", found.cells);
        show("kind", found.kind);
        show("points", found.point_count);
    }
    {
        begin("bezier_cells closed");
        const auto found = n::bezier_cells(in.loop);
        show("own_points", found.cells);
        show("kind", found.kind);
        show("points", found.point_count);
    }
    {
        begin("bezier_cell_points");
        const auto found = n::bezier_cell_points(in.surface);
        show("points", found.points);
        show("weights", found.weights);
    }
    {
        begin("bezier_cell_points rational");
        const auto found = n::bezier_cell_points(in.curve);
        show("points", found.points);
        show("weights", found.weights);
    }
    {
        begin("split_at_knots");
        const auto found = n::split_at_knots(in.curve, 0, 1);
        show("out", found);
    }
    {
        begin("boundaries");
        const auto found = n::boundaries(in.volume);
        show("out", found);
    }
    {
        begin("create curve");
        const auto found = n::Spline::create({2}, {9}, {0.0, 0.0, 0.0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1.0, 1.0, 1.0}, 2, {1.0, 0.0, 1.0, 1.0, 0.0, 1.0, -1.0, 1.0, -1.0, 0.0, -1.0, -1.0, 0.0, -1.0, 1.0, -1.0, 1.0, 0.0}, {1.0, 0.7071067811865476, 1.0, 0.7071067811865476, 1.0, 0.7071067811865476, 1.0, 0.7071067811865476, 1.0}, 0u);
        show("out", found);
    }
    {
        begin("create loop");
        const auto found = n::Spline::create({2}, {6}, {0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0}, 2, {1.0, 1.0, -1.0, 1.0, -1.0, -1.0, 1.0, -1.0, 1.0, 1.0, -1.0, 1.0}, {}, 1u);
        show("out", found);
    }
    {
        begin("create volume");
        const auto found = n::Spline::create({1, 1, 1}, {2, 2, 2}, {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 1.0}, 4, {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0}, {}, 0u);
        show("out", found);
    }
    {
        begin("create_homogeneous");
        const auto found = n::Spline::create_homogeneous({2}, {6}, {0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0}, 1, {1.0, 1.0, 1.0, 2.0, -1.0, 1.0, -1.0, -1.0, 1.0, -1.0, 1.0, 2.0}, 0u);
        show("out", found);
    }
    {
        begin("create_periodic");
        const auto found = n::Spline::create_periodic({2}, {4}, {2.0, 3.0, 4.0, 5.0, 6.0}, 2, {1.0, 1.0, -1.0, 1.0, -1.0, -1.0, 1.0, -1.0}, {1.0, 2.0, 1.0, 0.5}, 1u);
        show("out", found);
    }
    {
        begin("create_short");
        const auto found = n::Spline::create_short({2}, {9}, {0.0, 0.0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1.0, 1.0}, 2, {1.0, 0.0, 1.0, 1.0, 0.0, 1.0, -1.0, 1.0, -1.0, 0.0, -1.0, -1.0, 0.0, -1.0, 1.0, -1.0, 1.0, 0.0}, {1.0, 0.7071067811865476, 1.0, 0.7071067811865476, 1.0, 0.7071067811865476, 1.0, 0.7071067811865476, 1.0}, 0u);
        show("out", found);
    }
    {
        begin("create_multiplicities");
        const auto found = n::Spline::create_multiplicities({2}, {9}, {5}, {0.0, 0.25, 0.5, 0.75, 1.0}, {3, 2, 2, 2, 3}, 2, {1.0, 0.0, 1.0, 1.0, 0.0, 1.0, -1.0, 1.0, -1.0, 0.0, -1.0, -1.0, 0.0, -1.0, 1.0, -1.0, 1.0, 0.0}, {1.0, 0.7071067811865476, 1.0, 0.7071067811865476, 1.0, 0.7071067811865476, 1.0, 0.7071067811865476, 1.0}, 0u);
        show("out", found);
    }
    {
        begin("create_power");
        n::PowerForm form;
        form.coefficients = {0.1, 0.9, 0.3, 0.7};
        form.breaks = {0.0, 1.0, 0.0, 1.0};
        form.piece_counts = {1, 1};
        const auto found = n::create_power({1, 0}, 2, form, 0u);
        show("out", found);
    }
    {
        begin("refinement_matrix size");
        const auto found = n::refinement_matrix(in.curve, 0, {0.3, 0.6});
        show("values", found.values);
        show("columns", found.columns);
        show("row_pointers", found.row_pointers);
    }
    {
        begin("create_bezier rational");
        const auto found = n::Spline::create_bezier({3}, 2, {0.0, 0.0, 1.0, 2.0, 3.0, 2.0, 4.0, 0.0}, {1.0, 0.7071067811865476, 1.0, 0.7071067811865476});
        show("out", found);
    }
    {
        begin("interpolate");
        const auto found = n::interpolate({3}, {5}, {0.0, 0.25, 0.5, 0.75, 1.0}, 2, {0.0, 0.0, 1.0, 2.0, 3.0, 2.0, 4.0, 0.0, 5.0, 5.0}, {}, 0u);
        show("out", found.spline);
        show("residual", found.residual);
    }
    {
        begin("interpolate natural");
        const auto found = n::interpolate({3}, {3}, {0.0, 0.5, 1.0}, 2, {0.0, 0.0, 1.0, 2.0, 3.0, 2.0}, {1, 1}, 0u);
        show("out", found.spline);
        show("residual", found.residual);
    }
    {
        begin("interpolate loop");
        const auto found = n::interpolate({2}, {5}, {0.0, 0.25, 0.5, 0.75, 1.0}, 1, {0.0, 1.0, 0.0, -1.0, 0.0}, {}, 1u);
        show("out", found.spline);
        show("residual", found.residual);
    }
    {
        begin("interpolate_over_knots");
        const auto found = n::interpolate_over_knots({1, 2}, {2, 3}, {0.0, 1.0, 0.0, 0.5, 1.0}, {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0}, 1, {0.0, 1.0, 2.0, 3.0, 4.0, 5.0}, 0u);
        show("out", found);
    }
    {
        begin("interpolate_derivatives");
        const auto found = n::interpolate_derivatives({3, 2}, {5, 3}, {0.0, 0.0, 0.5, 1.0, 1.0, 0.0, 0.5, 1.0}, {0, 1, 0, 0, 1, 0, 0, 0}, 1, {0.0, 1.0, 2.0, 1.0, 1.0, 1.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 0.0, 0.0, 0.0}, {}, 0u);
        show("out", found);
    }
    {
        begin("interpolate_derivatives ends");
        const auto found = n::interpolate_derivatives({3, 3}, {4, 4}, {0.0, 0.0, 1.0, 1.0, 0.0, 0.5, 0.75, 1.0}, {0, 1, 0, 1, 0, 0, 0, 0}, 1, {0.0, 1.0, 2.0, 1.0, 1.0, 1.0, 3.0, 0.5, 5.0, 6.0, 7.0, 8.0, 1.0, 0.0, 0.0, 1.0}, {0, 0, 1, 1}, 0u);
        show("out", found);
    }
    {
        begin("curve_interpolate");
        const auto found = n::curve_interpolate(3, {0.0, 0.0, 1.0, 1.0}, 2, {0.0, 0.0, 1.0, 0.0, 2.0, 1.0, 1.0, 1.0}, {0, 1, 0, 1}, {}, 0u);
        show("out", found);
    }
    {
        begin("curve_interpolate directions");
        const auto found = n::curve_interpolate(3, {0.0, 0.0, 1.0, 1.0}, 2, {0.0, 0.0, 1.0, 0.0, 2.0, 1.0, 1.0, 1.0}, {0, -1, 0, -1}, {}, 0u);
        show("out", found);
    }
    {
        begin("curve_interpolate over knots");
        const auto found = n::curve_interpolate(2, {0.0, 0.5, 1.0}, 1, {0.0, 1.0, 0.0}, {}, {0.0, 0.0, 0.0, 1.0, 1.0, 1.0}, 0u);
        show("out", found);
    }
    {
        begin("tangent_lengths");
        const auto found = n::tangent_lengths(3, {0.0, 0.0, 1.0, 1.0}, 2, {0.0, 0.0, 1.0, 0.0, 2.0, 1.0, 1.0, 1.0}, {0, -1, 0, -1}, {}, 0u);
        show("lengths", found);
    }
    {
        begin("tangent_lengths over knots");
        const auto found = n::tangent_lengths(2, {0.0, 0.0, 1.0}, 2, {0.0, 0.0, 1.0, 0.0, 2.0, 1.0}, {0, -1, 0}, {0.0, 0.0, 0.0, 1.0, 1.0, 1.0}, 0u);
        show("lengths", found);
    }
    by_hand("data_init");
    {
        begin("statistics_create");
        const auto found = n::Statistics::create({1, 1}, {2, 3}, {0.0, 1.0, 0.0, 1.0, 2.0}, 2, 1.0, 1.0);
        show("out", found);
    }
    {
        begin("statistics_add");
        n::Data data;
        data.n = 2;
        data.axes = 1;
        data.dim = 1;
        static constexpr double data_params[] = {0.25, 0.75};
        data.params = data_params;
        static constexpr double data_values[] = {1.0, 2.0};
        data.values = data_values;
        static constexpr double data_weights[] = {1.0, 0.5};
        data.weights = data_weights;
        const auto found = in.statistics.add(data);
        show("out", found);
    }
    {
        begin("statistics_merge");
        const auto found = n::Statistics::merge(std::vector<n::Statistics>{in.statistics, in.statistics, in.no_statistics}, {1, -1, 1});
        show("out", found);
    }
    by_hand("statistics_clone");
    by_hand("statistics_destroy");
    {
        begin("statistics_size");
        const auto found = in.statistics.size();
        show("axes", found.axes);
        show("dim", found.dim);
        show("count", found.count);
        show("cells", found.cells);
        show("weight", found.weight);
    }
    by_hand("statistics_to_bytes");
    {
        begin("statistics_from_bytes");
        const auto found = n::Statistics::from_bytes(std::as_bytes(std::span(no_data)));
        show("out", found);
    }
    by_hand("fit_options_init");
    {
        begin("fit");
        n::FitOptions options;
        options.smoothing = 1;
        options.penalty_order = 1;
        options.lambda = 0.5;
        const auto found = in.statistics.fit({2}, {4}, {0.0, 0.0, 0.0, 0.5, 1.0, 1.0, 1.0}, options, 0u);
        show("out", found.spline);
    }
    {
        begin("fit_errors");
        const n::Spline ramp = n::Spline::create_bezier({2}, 1, {0.0, 0.25, 1.0});
        const auto found = in.statistics.fit_errors(ramp, 1, 0.5, 1.0, {0.0, 0.25, 1.0}, 0u);
        show("errors", found);
    }
    {
        begin("fit_criteria");
        const n::Spline ramp = n::Spline::create_bezier({2}, 1, {0.0, 0.25, 1.0});
        const auto found = in.statistics.fit_criteria(ramp, 1, {0.5, 2.0});
        show("values", found);
    }
    {
        begin("fit_points");
        n::Data data;
        data.n = 6;
        data.axes = 2;
        data.dim = 1;
        static constexpr double data_params[] = {0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 1.0, 0.5, 0.5, 0.25, 0.5};
        data.params = data_params;
        static constexpr double data_values[] = {0.0, 1.0, 2.0, 1.0, 0.0, 1.0};
        data.values = data_values;
        n::FitOptions options;
        options.smoothing = 2;
        options.penalty_order = 1;
        const auto found = n::fit_points(data, {1, 1}, {2, 2}, {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 1.0}, options, 0u);
        show("out", found.spline);
    }
    {
        begin("fit_tolerance");
        n::Data data;
        data.n = 5;
        data.axes = 1;
        data.dim = 2;
        static constexpr double data_params[] = {0.0, 0.25, 0.5, 0.75, 1.0};
        data.params = data_params;
        static constexpr double data_values[] = {0.0, 1.0, 2.0, 1.0, 0.0, 0.0, 1.0, 1.0, 2.0, 1.0};
        data.values = data_values;
        n::FitOptions options;
        options.smoothing = 0;
        options.penalty_order = 2;
        const auto found = n::fit_tolerance(data, {2}, 0.01, {0.0, 1.0}, 0, options, 0u);
        show("out", found.spline);
    }
    {
        begin("cloud_start");
        const auto found = n::cloud_start({1}, {3}, {0.0, 0.0, 0.5, 1.0, 1.0}, 2, {0.0, 0.0, 1.0, 1.0, 2.0, 1.0}, 0u);
        show("out", found);
    }
    by_hand("cloud_options_init");
    {
        begin("fit_cloud");
        n::CloudOptions options;
        options.penalty_order = 2;
        options.rounds = 3;
        options.lambda = 0.5;
        options.first_lambda = 1.0;
        options.tolerance = 0.001;
        const auto found = n::fit_cloud(in.twist, {0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 2.0, 1.0, 2.0}, {1.0, 2.0, 1.0}, options);
        show("out", found.spline);
    }
    {
        begin("approximate");
        const auto found = n::approximate(in.curve, 0.3, {3}, 0);
        show("out", found.spline);
        show("bound", found.bound);
    }
    {
        begin("face_create");
        const n::Spline south = n::Spline::create_bezier({1}, 2, {0.0, 0.0, 1.0, 0.0});
        const n::Spline east = n::Spline::create_bezier({1}, 2, {1.0, 0.0, 1.0, 3.0});
        const n::Spline north = n::Spline::create_bezier({1}, 2, {1.0, 3.0, 0.0, 3.0});
        const n::Spline west = n::Spline::create_bezier({1}, 2, {0.0, 3.0, 0.0, 0.0});
        const auto found = n::Face::create(in.surface, {1, 4}, std::vector<n::Spline>{in.outline, south, east, north, west}, {}, {0, 7, -8, 0, 9}, 0.001, 67108864u);
        show("out", found);
    }
    {
        begin("face_create without crossings");
        const n::Spline south = n::Spline::create_bezier({1}, 2, {0.0, 0.0, 1.0, 0.0});
        const n::Spline east = n::Spline::create_bezier({1}, 2, {1.0, 0.0, 1.0, 3.0});
        const n::Spline north = n::Spline::create_bezier({1}, 2, {1.0, 3.0, 0.0, 3.0});
        const n::Spline west = n::Spline::create_bezier({1}, 2, {0.0, 3.0, 0.0, 0.0});
        const auto found = n::Face::create(in.surface, {4}, std::vector<n::Spline>{south, east, north, west}, {}, {}, 0.001, 33554432u);
        show("out", found);
    }
    {
        begin("face_create of edges");
        const n::Spline first_edge = n::Spline::create_bezier({2}, 3, {0.25, 1.0, 1.0625, 0.5, 1.0, 1.1875, 0.75, 1.0, 1.5625});
        const n::Spline second_edge = n::Spline::create_bezier({2}, 3, {0.75, 1.0, 1.5625, 0.625, 1.5, 1.875, 0.5, 2.0, 2.25});
        const n::Spline third_edge = n::Spline::create_bezier({2}, 3, {0.5, 2.0, 2.25, 0.375, 1.5, 1.625, 0.25, 1.0, 1.0625});
        const auto found = n::Face::create(in.surface, {3}, {}, std::vector<n::Spline>{first_edge, second_edge, third_edge}, {1, 2, 3}, 1e-09, 0u);
        show("out", found);
    }
    {
        begin("face_create whole");
        const auto found = n::Face::create(in.surface, {}, {}, {}, {}, 0.0, 0u);
        show("out", found);
    }
    by_hand("face_clone");
    by_hand("face_destroy");
    {
        begin("face_surface");
        const auto found = in.face.surface();
        show("out", found);
    }
    {
        begin("face_loops");
        const auto found = in.face.loops();
        show("sizes", found);
    }
    {
        begin("face_curve");
        const auto found = in.face.curve(0, 0);
        show("out", found);
    }
    {
        begin("face_edge");
        const auto found = in.face.edge(0, 0);
        show("out", found.spline);
        show("key", found.key);
    }
    {
        begin("face_deviation");
        const auto found = in.face.deviation(0, 0);
        show("distance", found.distance);
        show("proven", found.proven);
    }
    {
        begin("face_tolerance");
        const auto found = in.face.tolerance();
        show("tolerance", found);
    }
    {
        begin("face_classify");
        const auto found = in.face.classify({0.1, 0.9, 0.3, 0.7, 0.2, 0.6}, 0.0);
        show("sides", found);
    }
    {
        begin("face_area");
        const auto found = in.face.area(1e-06);
        show("area", found.value);
        show("error", found.error);
    }
    {
        begin("face_moments");
        const auto found = in.face.moments(1e-06);
        show("content", found.content);
        show("centroid", found.centroid);
        show("inertia", found.inertia);
        show("error", found.error);
    }
    {
        begin("face_quadrature");
        const auto found = in.face.quadrature(1);
        show("params", found.params);
        show("weights", found.weights);
        show("measures", found.measures);
    }
    {
        begin("face_box");
        const auto found = in.face.box(0.001);
        show("lower", found.lower);
        show("upper", found.upper);
        show("gap", found.gap);
    }
    {
        begin("read_model");
        const auto found = n::Model::read(std::as_bytes(std::span(solid)));
        show("out", found);
    }
    {
        begin("read_model in millimetres");
        n::ReadOptions options;
        options.unit = 0.001;
        const auto found = n::Model::read(std::as_bytes(std::span(solid)), options);
        show("out", found);
    }
    {
        begin("read_model_file");
        const auto found = n::Model::read_file(solid_path());
        show("out", found);
    }
    {
        begin("read_model_file in millimetres");
        n::ReadOptions options;
        options.unit = 0.001;
        const auto found = n::Model::read_file(solid_path(), options);
        show("out", found);
    }
    {
        begin("model_create");
        const auto found = n::Model::create(std::vector<n::Face>{in.face, in.face}, 0.001);
        show("out", found);
    }
    {
        begin("model_sew");
        n::Placement at;
        const n::Spline sphere = n::sphere(at, 1.0, 0);
        const n::Face ball_face = n::Face::create(sphere, {}, {}, {}, {}, 1e-09, 0u);
        const auto found = n::Model::sew(std::vector<n::Face>{in.face, ball_face}, 1e-06, 0.001);
        show("out", found);
    }
    {
        begin("region_create");
        const auto found = n::Model::region(std::vector<n::Spline>{in.outline}, 1, 0.0);
        show("out", found);
    }
    {
        begin("region_combine");
        const n::Spline moved_outline = n::Spline::create({1}, {4}, {0.0, 0.0, 1.0, 2.0, 3.0, 3.0}, 2, {0.25, 1.25, 0.75, 1.25, 0.5, 2.25, 0.25, 1.25}, {}, 0u);
        const n::Face moved_face = n::Face::create(in.surface, {1}, std::vector<n::Spline>{moved_outline}, {}, {}, 0.001, 0u);
        const auto found = n::Model::combine(3, std::vector<n::Face>{in.face}, std::vector<n::Face>{moved_face}, 0.0);
        show("out", found);
    }
    {
        begin("face_split");
        const n::Spline divider = n::Spline::create_bezier({1}, 2, {0.0, 1.5, 1.0, 1.75});
        const auto found = n::Model::split(in.face, std::vector<n::Spline>{divider}, 0.0);
        show("out", found);
    }
    {
        begin("face_trim");
        const n::Spline cutter = n::Spline::create({1, 1}, {2, 2}, {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 1.0}, 3, {-1.0, 1.625, -9.0, -1.0, 1.625, 9.0, 2.0, 1.625, -9.0, 2.0, 1.625, 9.0}, {}, 0u);
        const auto found = n::Model::trim(in.face, cutter, 1, 1e-06);
        show("out", found);
    }
    {
        begin("model_edge_gaps");
        const auto found = in.model.edge_gaps();
        show("uses", found.uses);
        show("gaps", found.gaps);
        show("bounded", found.bounded);
    }
    by_hand("model_clone");
    by_hand("model_destroy");
    {
        begin("model_face");
        const auto found = in.model.face(1);
        show("out", found.face);
        show("part", found.part);
        show("shape", found.shape);
        show("against", found.against);
        show("colour", found.colour);
    }
    {
        begin("model_edge");
        const auto found = in.model.edge(1);
        show("out", found.spline);
        show("part", found.part);
        show("end_vertices", found.vertices);
        show("shape", found.shape);
    }
    {
        begin("model_splines");
        const auto found = in.model.splines();
        show("out", found);
    }
    by_hand("write_options_init");
    by_hand("model_write");
    by_hand("model_write in inches");
    by_hand("model_write as IGES");
    {
        begin("model_write_file");
        in.model.write_file(replaced_path(), 1);
    }
    {
        begin("model_write_file in inches");
        n::WriteOptions options;
        options.unit = 0.0254;
        in.model.write_file(replaced_path(), 1, options);
    }
    by_hand("list_write");
    by_hand("list_write as IGES");
    {
        begin("list_write_file");
        const n::List edges = n::boundaries(in.surface);
        n::WriteOptions options;
        options.unit = 0.0254;
        edges.write_file(replaced_path(), 1, options);
    }
    {
        begin("surface_sections in two planes");
        const auto found = n::Meet::sections(in.surface, std::array<double, 3>{0.0, 0.5, 2.0}, {1.0, 3.0}, 0.01);
        show("out", found);
    }
    {
        begin("surface_sections");
        const auto found = n::Meet::sections(in.surface, std::array<double, 3>{0.0, 0.0, 1.0}, {1.5}, 0.0001);
        show("out", found);
    }
    {
        begin("surface_contours along a direction");
        const auto found = n::Meet::contours(in.surface, 1, std::array<double, 3>{0.2, 0.1, 1.0}, {}, 0.01);
        show("out", found);
    }
    {
        begin("surface_contours");
        const auto found = n::Meet::contours(in.surface, 3, std::array<double, 3>{0.0, 0.0, 2.0}, {0.9}, 0.01);
        show("out", found);
    }
    {
        begin("surface_reflections of normals");
        const auto found = n::Meet::reflections(in.surface, 1, {}, std::array<double, 3>{0.0, 0.0, 1.0}, {0.5, 0.25, 0.0}, 0.01);
        show("out", found);
    }
    {
        begin("surface_reflections");
        const auto found = n::Meet::reflections(in.surface, 2, std::array<double, 3>{0.1, 0.0, -1.0}, std::array<double, 3>{1.0, 0.0, 0.0}, {0.0, 0.5, 6.0, 0.0, 1.0, 6.0}, 0.01);
        show("out", found);
    }
    {
        begin("surface_level");
        const auto found = n::Meet::level(in.surface, 1, {0.0, 0.0, 1.0, -1.5}, 0.01);
        show("out", found);
    }
    {
        begin("surface_level_curves");
        const n::Spline heights = n::Spline::create({1, 1}, {2, 2}, {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 3.0, 3.0}, 1, {0.0, 1.0, 1.0, 2.0}, {}, 0u);
        const auto found = n::Meet::level_curves(in.surface, heights, {0.5}, 0.01);
        show("out", found);
    }
    {
        begin("surface_intersections");
        const n::Spline wall = n::Spline::create_bezier({1, 1}, 3, {0.3, -1.0, -1.0, 0.3, -1.0, 9.0, 0.4, 9.0, -1.0, 0.4, 9.0, 9.0});
        const auto found = n::Meet::surfaces(wall, in.surface, 0.1);
        show("out", found);
    }
    {
        begin("surface_self_intersections");
        const auto found = n::Meet::of_itself(in.surface, 0.1);
        show("out", found);
    }
    {
        begin("face_intersections");
        const n::Spline wall = n::Spline::create_bezier({1, 1}, 3, {0.3, -1.0, -1.0, 0.3, -1.0, 9.0, 0.4, 9.0, -1.0, 0.4, 9.0, 9.0});
        const n::Spline upright_outline = n::Spline::create({1}, {4}, {0.0, 0.0, 1.0, 2.0, 3.0, 3.0}, 2, {0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0}, {}, 0u);
        const n::Face upright = n::Face::create(wall, {1}, std::vector<n::Spline>{upright_outline}, {}, {}, 0.001, 0u);
        const auto found = n::Meet::of_faces(in.face, upright, 0.1);
        show("out", found);
    }
    {
        begin("meet_kinds");
        const auto found = in.meet.kinds();
        show("kinds", found);
    }
    {
        begin("surface_project_curve");
        const n::Spline wall = n::Spline::create_bezier({1, 1}, 3, {0.3, -1.0, -1.0, 0.3, -1.0, 9.0, 0.4, 9.0, -1.0, 0.4, 9.0, 9.0});
        const auto found = n::Meet::projection(wall, in.twist, {1.0, 0.2, 0.1}, 0.01);
        show("out", found);
    }
    {
        begin("face_project_curve");
        const auto found = n::Meet::face_projection(in.face, in.twist, {0.0, 0.0, 1.0}, 0.1);
        show("out", found);
    }
    {
        begin("model_sections");
        n::Placement at;
        const n::Spline sphere = n::sphere(at, 1.0, 0);
        const n::Face ball_face = n::Face::create(sphere, {}, {}, {}, {}, 1e-09, 0u);
        const n::Model ball = n::Model::create(std::vector<n::Face>{ball_face}, 1.0);
        const auto found = n::Meet::model_sections(ball, {0.0, 0.0, 1.0}, {0.1}, 0.1);
        show("out", found);
    }
    {
        begin("model_intersections");
        n::Placement at;
        const n::Spline sphere = n::sphere(at, 1.0, 0);
        const n::Face ball_face = n::Face::create(sphere, {}, {}, {}, {}, 1e-09, 0u);
        const n::Model ball = n::Model::create(std::vector<n::Face>{ball_face}, 1.0);
        const auto found = n::Meet::of_models(in.model, ball, 0.1);
        show("out", found);
    }
    {
        begin("meet_faces_second");
        const auto found = in.meet.faces_second();
        show("own_faces", found.faces);
        show("own_instances", found.instances);
    }
    {
        begin("meet_joints_second");
        const auto found = in.meet.joints_second();
        show("own_faces", found.faces);
        show("own_instances", found.instances);
    }
    {
        begin("meet_ways");
        const auto found = in.meet.ways();
        show("levels", found.levels);
        show("firsts", found.firsts);
        show("sizes", found.sizes);
        show("closes", found.closed);
        show("gaps", found.gaps);
    }
    {
        begin("meet_ways closed");
        const auto found = in.meet.ways();
        show("levels", found.levels);
        show("firsts", found.firsts);
        show("sizes", found.sizes);
        show("closes", found.closed);
        show("gaps", found.gaps);
    }
    {
        begin("meet_faces");
        const auto found = in.meet.faces();
        show("own_faces", found.faces);
        show("own_instances", found.instances);
    }
    {
        begin("meet_joints");
        const auto found = in.meet.joints();
        show("next_nodes", found.next_nodes);
        show("gaps", found.gaps);
        show("own_faces", found.faces);
        show("own_instances", found.instances);
    }
    {
        begin("meet_trim");
        const auto found = n::Meet::trimmed(in.meet, in.face);
        show("out", found);
    }
    {
        begin("meet_trim_second");
        const n::Spline wall = n::Spline::create_bezier({1, 1}, 3, {0.3, -1.0, -1.0, 0.3, -1.0, 9.0, 0.4, 9.0, -1.0, 0.4, 9.0, 9.0});
        const n::Meet crossing = n::Meet::surfaces(in.surface, wall, 0.01);
        const auto found = n::Meet::trimmed_second(crossing, in.face);
        show("out", found);
    }
    by_hand("mesh_options_init");
    {
        begin("mesh_surface");
        n::MeshOptions options;
        options.chord = 1.0;
        options.relative_chord = 0.0;
        const auto found = n::Mesh::of_surface(in.surface, options);
        show("out", found);
    }
    {
        begin("mesh_surface by length");
        n::MeshOptions options;
        options.chord = 10.0;
        options.relative_chord = 0.0;
        options.longest = 1.5;
        const auto found = n::Mesh::of_surface(in.surface, options);
        show("out", found);
    }
    {
        begin("mesh_surface by angle");
        n::MeshOptions options;
        options.chord = 10.0;
        options.relative_chord = 0.0;
        options.angle = 0.5;
        const auto found = n::Mesh::of_surface(in.surface, options);
        show("out", found);
    }
    {
        begin("mesh_face");
        n::MeshOptions options;
        options.chord = 1.0;
        options.relative_chord = 0.0;
        const auto found = n::Mesh::of_face(in.face, options);
        show("out", found);
    }
    {
        begin("mesh_model");
        n::MeshOptions options;
        options.chord = 1.0;
        options.relative_chord = 0.0;
        const auto found = n::Mesh::of_model(in.model, options);
        show("out", found);
    }
    {
        begin("mesh_surface without small angles");
        n::MeshOptions options;
        options.chord = 10.0;
        options.relative_chord = 0.0;
        options.minimum_angle = 0.4;
        const auto found = n::Mesh::of_surface(in.surface, options);
        show("out", found);
    }
    by_hand("mesh_surface_levels");
    by_hand("mesh_face_levels");
    by_hand("mesh_model_levels");
    {
        begin("mesh_volume");
        n::MeshOptions options;
        options.chord = 0.1;
        options.relative_chord = 0.0;
        const auto found = n::Mesh::of_volume(in.solid, options, 100);
        show("out", found);
    }
    {
        begin("mesh_points");
        const auto found = in.mesh.points();
        show("points", found);
    }
    {
        begin("mesh_points_f32");
        const auto found = in.mesh.points_f32();
        show("points", found);
    }
    {
        begin("mesh_vertices");
        const auto found = in.mesh.vertices();
        show("own_points", found.points);
        show("params", found.params);
        show("normals", found.normals);
    }
    {
        begin("mesh_vertices normals");
        const auto found = in.mesh.vertices();
        show("own_points", found.points);
        show("params", found.params);
        show("normals", found.normals);
    }
    {
        begin("mesh_vertices_f32");
        const auto found = in.mesh.vertices_f32();
        show("points", found.points);
        show("params", found.params);
        show("normals", found.normals);
    }
    {
        begin("mesh_triangles");
        const auto found = in.mesh.triangles(0u);
        show("corners", found);
    }
    {
        begin("mesh_triangles welded");
        const auto found = in.mesh.triangles(16777216u);
        show("corners", found);
    }
    {
        begin("mesh_triangles_i32");
        const auto found = in.mesh.triangles_i32(0u);
        show("corners", found);
    }
    {
        begin("mesh_quads");
        const auto found = in.mesh.quads(0u);
        show("corners", found.corners);
        show("own_triangles", found.triangles);
    }
    {
        begin("mesh_quads welded");
        const auto found = in.mesh.quads(16777216u);
        show("corners", found.corners);
        show("own_triangles", found.triangles);
    }
    {
        begin("mesh_faces");
        const auto found = in.mesh.faces();
        show("first_vertices", found.first_vertices);
        show("vertex_counts", found.vertex_counts);
        show("first_triangles", found.first_triangles);
        show("triangle_counts", found.triangle_counts);
        show("from_shape", found.from_shape);
        show("from_mesh", found.from_mesh);
        show("reaches", found.reached);
    }
    {
        begin("mesh_edges");
        const auto found = in.mesh.edges();
        show("own_edges", found.edges);
        show("firsts", found.firsts);
        show("sizes", found.sizes);
        show("bounds", found.bounds);
        show("reaches", found.reached);
    }
    {
        begin("mesh_edge_points");
        const auto found = in.mesh.edge_points();
        show("own_points", found);
    }
    by_hand("mesh_write");
    by_hand("mesh_write as text");
    by_hand("mesh_write as OBJ");
    by_hand("mesh_write as PLY");
    by_hand("mesh_write as GLB");
    by_hand("mesh_write as VTU");
    {
        begin("mesh_write_file");
        in.mesh.write_file(replaced_path(), 8);
    }
    {
        begin("mesh_write_file in inches");
        n::WriteOptions options;
        options.unit = 0.0254;
        in.mesh.write_file(replaced_path(), 3, options);
    }
    {
        begin("mesh_hexahedra");
        const auto found = in.block.hexahedra();
        show("corners", found.corners);
        show("domains", found.domains);
        show("folds", found.folds);
        show("signs", found.signs);
    }
    by_hand("mesh_clone");
    by_hand("meet_clone");
    by_hand("meet_destroy");
    by_hand("mesh_destroy");
    {
        begin("meet_branches");
        const auto found = in.meet.branches();
        show("levels", found.levels);
        show("end_nodes", found.end_nodes);
        show("loops", found.loops);
        show("deviations", found.deviations);
    }
    {
        begin("meet_branches levels");
        const auto found = in.meet.branches();
        show("levels", found.levels);
        show("end_nodes", found.end_nodes);
        show("loops", found.loops);
        show("deviations", found.deviations);
    }
    {
        begin("meet_branch");
        const auto found = in.meet.branch(1);
        show("space", found.first);
        show("on_surface", found.second);
    }
    {
        begin("meet_branch_second");
        const n::Spline wall = n::Spline::create_bezier({1, 1}, 3, {0.3, -1.0, -1.0, 0.3, -1.0, 9.0, 0.4, 9.0, -1.0, 0.4, 9.0, 9.0});
        const n::Meet crossing = n::Meet::surfaces(in.surface, wall, 0.01);
        const auto found = crossing.branch_second(0);
        show("on_second", found);
    }
    {
        begin("meet_nodes");
        const auto found = in.meet.nodes();
        show("levels", found.levels);
        show("kinds", found.kinds);
        show("params", found.params);
        show("ranges", found.ranges);
    }
    {
        begin("meet_nodes_second");
        const n::Spline wall = n::Spline::create_bezier({1, 1}, 3, {0.3, -1.0, -1.0, 0.3, -1.0, 9.0, 0.4, 9.0, -1.0, 0.4, 9.0, 9.0});
        const n::Meet crossing = n::Meet::surfaces(in.surface, wall, 0.01);
        const auto found = crossing.nodes_second();
        show("params", found.params);
        show("ranges", found.ranges);
    }
    {
        begin("read_with");
        const auto found = n::List::read(std::as_bytes(std::span(file)), {}, watched());
        show("out", found);
    }
    {
        begin("read_with in millimetres");
        n::ReadOptions options;
        options.unit = 0.001;
        const auto found = n::List::read(std::as_bytes(std::span(file)), options, watched());
        show("out", found);
    }
    {
        begin("read_file_with");
        const auto found = n::List::read_file(file_path(), {}, watched());
        show("out", found);
    }
    {
        begin("read_file_with in millimetres");
        n::ReadOptions options;
        options.unit = 0.001;
        const auto found = n::List::read_file(file_path(), options, watched());
        show("out", found);
    }
    {
        begin("statistics_add_with");
        n::Data data;
        data.n = 2;
        data.axes = 1;
        data.dim = 1;
        static constexpr double data_params[] = {0.25, 0.75};
        data.params = data_params;
        static constexpr double data_values[] = {1.0, 2.0};
        data.values = data_values;
        static constexpr double data_weights[] = {1.0, 0.5};
        data.weights = data_weights;
        const auto found = in.statistics.add(data, watched());
        show("out", found);
    }
    {
        begin("fit_with");
        n::FitOptions options;
        options.smoothing = 1;
        options.penalty_order = 1;
        options.lambda = 0.5;
        const auto found = in.statistics.fit({2}, {4}, {0.0, 0.0, 0.0, 0.5, 1.0, 1.0, 1.0}, options, 0u, watched());
        show("out", found.spline);
    }
    {
        begin("fit_errors_with");
        const n::Spline ramp = n::Spline::create_bezier({2}, 1, {0.0, 0.25, 1.0});
        const auto found = in.statistics.fit_errors(ramp, 1, 0.5, 1.0, {0.0, 0.25, 1.0}, 0u, watched());
        show("errors", found);
    }
    {
        begin("fit_criteria_with");
        const n::Spline ramp = n::Spline::create_bezier({2}, 1, {0.0, 0.25, 1.0});
        const auto found = in.statistics.fit_criteria(ramp, 1, {0.5, 2.0}, watched());
        show("values", found);
    }
    {
        begin("fit_points_with");
        n::Data data;
        data.n = 6;
        data.axes = 2;
        data.dim = 1;
        static constexpr double data_params[] = {0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 1.0, 0.5, 0.5, 0.25, 0.5};
        data.params = data_params;
        static constexpr double data_values[] = {0.0, 1.0, 2.0, 1.0, 0.0, 1.0};
        data.values = data_values;
        n::FitOptions options;
        options.smoothing = 2;
        options.penalty_order = 1;
        const auto found = n::fit_points(data, {1, 1}, {2, 2}, {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 1.0}, options, 0u, watched());
        show("out", found.spline);
    }
    {
        begin("fit_tolerance_with");
        n::Data data;
        data.n = 5;
        data.axes = 1;
        data.dim = 2;
        static constexpr double data_params[] = {0.0, 0.25, 0.5, 0.75, 1.0};
        data.params = data_params;
        static constexpr double data_values[] = {0.0, 1.0, 2.0, 1.0, 0.0, 0.0, 1.0, 1.0, 2.0, 1.0};
        data.values = data_values;
        n::FitOptions options;
        options.smoothing = 0;
        options.penalty_order = 2;
        const auto found = n::fit_tolerance(data, {2}, 0.01, {0.0, 1.0}, 0, options, 0u, watched());
        show("out", found.spline);
    }
    {
        begin("fit_cloud_with");
        n::CloudOptions options;
        options.penalty_order = 2;
        options.rounds = 3;
        options.lambda = 0.5;
        options.first_lambda = 1.0;
        options.tolerance = 0.001;
        const auto found = n::fit_cloud(in.twist, {0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 2.0, 1.0, 2.0}, {1.0, 2.0, 1.0}, options, watched());
        show("out", found.spline);
    }
    {
        begin("approximate_with");
        const auto found = n::approximate(in.curve, 0.3, {3}, 0, watched());
        show("out", found.spline);
        show("bound", found.bound);
    }
    {
        begin("face_create_with");
        const n::Spline south = n::Spline::create_bezier({1}, 2, {0.0, 0.0, 1.0, 0.0});
        const n::Spline east = n::Spline::create_bezier({1}, 2, {1.0, 0.0, 1.0, 3.0});
        const n::Spline north = n::Spline::create_bezier({1}, 2, {1.0, 3.0, 0.0, 3.0});
        const n::Spline west = n::Spline::create_bezier({1}, 2, {0.0, 3.0, 0.0, 0.0});
        const auto found = n::Face::create(in.surface, {1, 4}, std::vector<n::Spline>{in.outline, south, east, north, west}, {}, {0, 7, -8, 0, 9}, 0.001, 67108864u, watched());
        show("out", found);
    }
    {
        begin("face_create_with without crossings");
        const n::Spline south = n::Spline::create_bezier({1}, 2, {0.0, 0.0, 1.0, 0.0});
        const n::Spline east = n::Spline::create_bezier({1}, 2, {1.0, 0.0, 1.0, 3.0});
        const n::Spline north = n::Spline::create_bezier({1}, 2, {1.0, 3.0, 0.0, 3.0});
        const n::Spline west = n::Spline::create_bezier({1}, 2, {0.0, 3.0, 0.0, 0.0});
        const auto found = n::Face::create(in.surface, {4}, std::vector<n::Spline>{south, east, north, west}, {}, {}, 0.001, 33554432u, watched());
        show("out", found);
    }
    {
        begin("face_create_with of edges");
        const n::Spline first_edge = n::Spline::create_bezier({2}, 3, {0.25, 1.0, 1.0625, 0.5, 1.0, 1.1875, 0.75, 1.0, 1.5625});
        const n::Spline second_edge = n::Spline::create_bezier({2}, 3, {0.75, 1.0, 1.5625, 0.625, 1.5, 1.875, 0.5, 2.0, 2.25});
        const n::Spline third_edge = n::Spline::create_bezier({2}, 3, {0.5, 2.0, 2.25, 0.375, 1.5, 1.625, 0.25, 1.0, 1.0625});
        const auto found = n::Face::create(in.surface, {3}, {}, std::vector<n::Spline>{first_edge, second_edge, third_edge}, {1, 2, 3}, 1e-09, 0u, watched());
        show("out", found);
    }
    {
        begin("face_create_with whole");
        const auto found = n::Face::create(in.surface, {}, {}, {}, {}, 0.0, 0u, watched());
        show("out", found);
    }
    {
        begin("face_classify_with");
        const auto found = in.face.classify({0.1, 0.9, 0.3, 0.7, 0.2, 0.6}, 0.0, watched());
        show("sides", found);
    }
    {
        begin("face_area_with");
        const auto found = in.face.area(1e-06, watched());
        show("area", found.value);
        show("error", found.error);
    }
    {
        begin("face_moments_with");
        const auto found = in.face.moments(1e-06, watched());
        show("content", found.content);
        show("centroid", found.centroid);
        show("inertia", found.inertia);
        show("error", found.error);
    }
    {
        begin("face_quadrature_with");
        const auto found = in.face.quadrature(1, watched());
        show("params", found.params);
        show("weights", found.weights);
        show("measures", found.measures);
    }
    {
        begin("face_box_with");
        const auto found = in.face.box(0.001, watched());
        show("lower", found.lower);
        show("upper", found.upper);
        show("gap", found.gap);
    }
    {
        begin("read_model_with");
        const auto found = n::Model::read(std::as_bytes(std::span(solid)), {}, watched());
        show("out", found);
    }
    {
        begin("read_model_with in millimetres");
        n::ReadOptions options;
        options.unit = 0.001;
        const auto found = n::Model::read(std::as_bytes(std::span(solid)), options, watched());
        show("out", found);
    }
    {
        begin("read_model_file_with");
        const auto found = n::Model::read_file(solid_path(), {}, watched());
        show("out", found);
    }
    {
        begin("read_model_file_with in millimetres");
        n::ReadOptions options;
        options.unit = 0.001;
        const auto found = n::Model::read_file(solid_path(), options, watched());
        show("out", found);
    }
    {
        begin("model_sew_with");
        n::Placement at;
        const n::Spline sphere = n::sphere(at, 1.0, 0);
        const n::Face ball_face = n::Face::create(sphere, {}, {}, {}, {}, 1e-09, 0u);
        const auto found = n::Model::sew(std::vector<n::Face>{in.face, ball_face}, 1e-06, 0.001, watched());
        show("out", found);
    }
    {
        begin("region_create_with");
        const auto found = n::Model::region(std::vector<n::Spline>{in.outline}, 1, 0.0, watched());
        show("out", found);
    }
    {
        begin("region_combine_with");
        const n::Spline moved_outline = n::Spline::create({1}, {4}, {0.0, 0.0, 1.0, 2.0, 3.0, 3.0}, 2, {0.25, 1.25, 0.75, 1.25, 0.5, 2.25, 0.25, 1.25}, {}, 0u);
        const n::Face moved_face = n::Face::create(in.surface, {1}, std::vector<n::Spline>{moved_outline}, {}, {}, 0.001, 0u);
        const auto found = n::Model::combine(3, std::vector<n::Face>{in.face}, std::vector<n::Face>{moved_face}, 0.0, watched());
        show("out", found);
    }
    {
        begin("face_split_with");
        const n::Spline divider = n::Spline::create_bezier({1}, 2, {0.0, 1.5, 1.0, 1.75});
        const auto found = n::Model::split(in.face, std::vector<n::Spline>{divider}, 0.0, watched());
        show("out", found);
    }
    {
        begin("face_trim_with");
        const n::Spline cutter = n::Spline::create({1, 1}, {2, 2}, {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 1.0}, 3, {-1.0, 1.625, -9.0, -1.0, 1.625, 9.0, 2.0, 1.625, -9.0, 2.0, 1.625, 9.0}, {}, 0u);
        const auto found = n::Model::trim(in.face, cutter, 1, 1e-06, watched());
        show("out", found);
    }
    by_hand("model_write_with");
    by_hand("model_write_with in inches");
    by_hand("model_write_with as IGES");
    {
        begin("model_write_file_with");
        in.model.write_file(replaced_path(), 1, {}, watched());
    }
    {
        begin("model_write_file_with in inches");
        n::WriteOptions options;
        options.unit = 0.0254;
        in.model.write_file(replaced_path(), 1, options, watched());
    }
    by_hand("list_write_with");
    by_hand("list_write_with as IGES");
    {
        begin("list_write_file_with");
        const n::List edges = n::boundaries(in.surface);
        n::WriteOptions options;
        options.unit = 0.0254;
        edges.write_file(replaced_path(), 1, options, watched());
    }
    {
        begin("surface_sections_with in two planes");
        const auto found = n::Meet::sections(in.surface, std::array<double, 3>{0.0, 0.5, 2.0}, {1.0, 3.0}, 0.01, watched());
        show("out", found);
    }
    {
        begin("surface_sections_with");
        const auto found = n::Meet::sections(in.surface, std::array<double, 3>{0.0, 0.0, 1.0}, {1.5}, 0.0001, watched());
        show("out", found);
    }
    {
        begin("surface_contours_with along a direction");
        const auto found = n::Meet::contours(in.surface, 1, std::array<double, 3>{0.2, 0.1, 1.0}, {}, 0.01, watched());
        show("out", found);
    }
    {
        begin("surface_contours_with");
        const auto found = n::Meet::contours(in.surface, 3, std::array<double, 3>{0.0, 0.0, 2.0}, {0.9}, 0.01, watched());
        show("out", found);
    }
    {
        begin("surface_reflections_with of normals");
        const auto found = n::Meet::reflections(in.surface, 1, {}, std::array<double, 3>{0.0, 0.0, 1.0}, {0.5, 0.25, 0.0}, 0.01, watched());
        show("out", found);
    }
    {
        begin("surface_reflections_with");
        const auto found = n::Meet::reflections(in.surface, 2, std::array<double, 3>{0.1, 0.0, -1.0}, std::array<double, 3>{1.0, 0.0, 0.0}, {0.0, 0.5, 6.0, 0.0, 1.0, 6.0}, 0.01, watched());
        show("out", found);
    }
    {
        begin("surface_level_with");
        const auto found = n::Meet::level(in.surface, 1, {0.0, 0.0, 1.0, -1.5}, 0.01, watched());
        show("out", found);
    }
    {
        begin("surface_level_curves_with");
        const n::Spline heights = n::Spline::create({1, 1}, {2, 2}, {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 3.0, 3.0}, 1, {0.0, 1.0, 1.0, 2.0}, {}, 0u);
        const auto found = n::Meet::level_curves(in.surface, heights, {0.5}, 0.01, watched());
        show("out", found);
    }
    {
        begin("surface_intersections_with");
        const n::Spline wall = n::Spline::create_bezier({1, 1}, 3, {0.3, -1.0, -1.0, 0.3, -1.0, 9.0, 0.4, 9.0, -1.0, 0.4, 9.0, 9.0});
        const auto found = n::Meet::surfaces(wall, in.surface, 0.1, watched());
        show("out", found);
    }
    {
        begin("surface_self_intersections_with");
        const auto found = n::Meet::of_itself(in.surface, 0.1, watched());
        show("out", found);
    }
    {
        begin("face_intersections_with");
        const n::Spline wall = n::Spline::create_bezier({1, 1}, 3, {0.3, -1.0, -1.0, 0.3, -1.0, 9.0, 0.4, 9.0, -1.0, 0.4, 9.0, 9.0});
        const n::Spline upright_outline = n::Spline::create({1}, {4}, {0.0, 0.0, 1.0, 2.0, 3.0, 3.0}, 2, {0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0}, {}, 0u);
        const n::Face upright = n::Face::create(wall, {1}, std::vector<n::Spline>{upright_outline}, {}, {}, 0.001, 0u);
        const auto found = n::Meet::of_faces(in.face, upright, 0.1, watched());
        show("out", found);
    }
    {
        begin("surface_project_curve_with");
        const n::Spline wall = n::Spline::create_bezier({1, 1}, 3, {0.3, -1.0, -1.0, 0.3, -1.0, 9.0, 0.4, 9.0, -1.0, 0.4, 9.0, 9.0});
        const auto found = n::Meet::projection(wall, in.twist, {1.0, 0.2, 0.1}, 0.01, watched());
        show("out", found);
    }
    {
        begin("face_project_curve_with");
        const auto found = n::Meet::face_projection(in.face, in.twist, {0.0, 0.0, 1.0}, 0.1, watched());
        show("out", found);
    }
    {
        begin("model_sections_with");
        n::Placement at;
        const n::Spline sphere = n::sphere(at, 1.0, 0);
        const n::Face ball_face = n::Face::create(sphere, {}, {}, {}, {}, 1e-09, 0u);
        const n::Model ball = n::Model::create(std::vector<n::Face>{ball_face}, 1.0);
        const auto found = n::Meet::model_sections(ball, {0.0, 0.0, 1.0}, {0.1}, 0.1, watched());
        show("out", found);
    }
    {
        begin("model_intersections_with");
        n::Placement at;
        const n::Spline sphere = n::sphere(at, 1.0, 0);
        const n::Face ball_face = n::Face::create(sphere, {}, {}, {}, {}, 1e-09, 0u);
        const n::Model ball = n::Model::create(std::vector<n::Face>{ball_face}, 1.0);
        const auto found = n::Meet::of_models(in.model, ball, 0.1, watched());
        show("out", found);
    }
    {
        begin("meet_trim_with");
        const auto found = n::Meet::trimmed(in.meet, in.face, watched());
        show("out", found);
    }
    {
        begin("meet_trim_second_with");
        const n::Spline wall = n::Spline::create_bezier({1, 1}, 3, {0.3, -1.0, -1.0, 0.3, -1.0, 9.0, 0.4, 9.0, -1.0, 0.4, 9.0, 9.0});
        const n::Meet crossing = n::Meet::surfaces(in.surface, wall, 0.01);
        const auto found = n::Meet::trimmed_second(crossing, in.face, watched());
        show("out", found);
    }
    {
        begin("mesh_surface_with");
        n::MeshOptions options;
        options.chord = 1.0;
        options.relative_chord = 0.0;
        const auto found = n::Mesh::of_surface(in.surface, options, watched());
        show("out", found);
    }
    {
        begin("mesh_surface_with by length");
        n::MeshOptions options;
        options.chord = 10.0;
        options.relative_chord = 0.0;
        options.longest = 1.5;
        const auto found = n::Mesh::of_surface(in.surface, options, watched());
        show("out", found);
    }
    {
        begin("mesh_surface_with by angle");
        n::MeshOptions options;
        options.chord = 10.0;
        options.relative_chord = 0.0;
        options.angle = 0.5;
        const auto found = n::Mesh::of_surface(in.surface, options, watched());
        show("out", found);
    }
    {
        begin("mesh_face_with");
        n::MeshOptions options;
        options.chord = 1.0;
        options.relative_chord = 0.0;
        const auto found = n::Mesh::of_face(in.face, options, watched());
        show("out", found);
    }
    {
        begin("mesh_model_with");
        n::MeshOptions options;
        options.chord = 1.0;
        options.relative_chord = 0.0;
        const auto found = n::Mesh::of_model(in.model, options, watched());
        show("out", found);
    }
    {
        begin("mesh_surface_with without small angles");
        n::MeshOptions options;
        options.chord = 10.0;
        options.relative_chord = 0.0;
        options.minimum_angle = 0.4;
        const auto found = n::Mesh::of_surface(in.surface, options, watched());
        show("out", found);
    }
    by_hand("mesh_surface_levels_with");
    by_hand("mesh_face_levels_with");
    by_hand("mesh_model_levels_with");
    {
        begin("mesh_volume_with");
        n::MeshOptions options;
        options.chord = 0.1;
        options.relative_chord = 0.0;
        const auto found = n::Mesh::of_volume(in.solid, options, 100, watched());
        show("out", found);
    }
    by_hand("mesh_write_with");
    by_hand("mesh_write_with as text");
    by_hand("mesh_write_with as OBJ");
    by_hand("mesh_write_with as PLY");
    by_hand("mesh_write_with as GLB");
    by_hand("mesh_write_with as VTU");
    {
        begin("mesh_write_file_with");
        in.mesh.write_file(replaced_path(), 8, {}, watched());
    }
    {
        begin("mesh_write_file_with in inches");
        n::WriteOptions options;
        options.unit = 0.0254;
        in.mesh.write_file(replaced_path(), 3, options, watched());
    }
}

void edit(const Inputs &in) {
    {
        begin("transform");
        const auto found = in.curve.transform(2, {0.0, 1.0, -1.0, 0.0}, {0.0, 1.0});
        show("out", found);
    }
    {
        begin("transform_projective");
        const auto found = in.curve.transform_projective(2, {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 2.0});
        show("out", found);
    }
    {
        begin("mirror");
        const auto found = n::mirror(in.curve, {0.1, 0.9}, {0.1, 0.9});
        show("out", found);
    }
    {
        begin("project_to_plane");
        const auto found = n::project_to_plane(in.curve, {0.1, 0.9}, {0.1, 0.9});
        show("out", found);
    }
    {
        begin("project_to_plane along");
        const auto found = n::project_to_plane(in.curve, {0.1, 0.9}, {0.1, 0.9}, {0.1, 0.9});
        show("out", found);
    }
    {
        begin("project_from");
        const auto found = n::project_from(in.curve, {0.3, 0.7}, {0.1, 0.9}, {0.1, 0.9});
        show("out", found);
    }
    {
        begin("make_rational");
        const auto found = in.loop.make_rational();
        show("out", found);
    }
    {
        begin("to_homogeneous");
        const auto found = in.curve.to_homogeneous();
        show("out", found);
    }
    {
        begin("from_homogeneous");
        const auto found = in.volume.from_homogeneous();
        show("out", found);
    }
    {
        begin("normalize_weights");
        const auto found = n::normalize_weights(in.homogeneous);
        show("out", found);
    }
    {
        begin("equalize_end_weights");
        const auto found = n::equalize_end_weights(in.curve, 0);
        show("out", found);
    }
    {
        begin("pull_weight");
        const auto found = n::pull_weight(in.curve, 3, {0.3}, 0.01);
        show("out", found.spline);
        show("weight", found.weight);
    }
    {
        begin("pull_weights");
        const auto found = n::pull_weights(in.curve, {2, 3}, {0.3}, 0.01);
        show("out", found.spline);
        show("factor", found.factor);
    }
    {
        begin("set_weights");
        const auto found = n::set_weights(in.loop, {2, 3}, {0.3, 0.6});
        show("out", found);
    }
    {
        begin("weight_through");
        const auto found = n::weight_through(in.curve, 1, {0.125}, {0.75, 0.75}, 1.0);
        show("out", found.spline);
        show("weight", found.weight);
    }
    {
        begin("pull_point");
        const auto found = n::pull_point(in.volume, 0, {0.1, 0.9, 0.3}, {0.1, 0.9, 0.3, 0.7}, 1.0);
        show("out", found.spline);
        show("moved", found.moved);
    }
    {
        begin("insert_on_leg");
        const auto found = n::insert_on_leg(in.segment, 0, 0, 0.5);
        show("out", found.spline);
        show("index", found.index);
        show("ratio", found.ratio);
        show("knot", found.knot);
    }
    {
        begin("insert_at_point");
        const auto found = n::insert_at_point(in.loop, 0, {0.0, 1.0}, 1.0);
        show("out", found.spline);
        show("index", found.index);
        show("ratio", found.ratio);
        show("knot", found.knot);
    }
    {
        begin("constrain");
        n::Constraints given;
        given.params = {0.3, 0.6};
        given.targets = {0.1, 0.9, 0.3, 0.7};
        n::ConstrainOptions options;
        options.keep = {0, 0};
        options.tolerance = 0.0;
        const auto found = n::constrain(in.curve, given, options);
        show("out", found.spline);
        show("residuals", found.residuals);
        show("rank", found.rank);
        show("moved", found.moved);
        show("optimality", found.optimality);
    }
    {
        begin("warp");
        const auto found = n::warp(in.curve, {0.1, 0.9}, 1.0, 1, {0.3, 0.6});
        show("out", found);
    }
    {
        begin("warp periodic");
        const auto found = n::warp(in.loop, {0.1, 0.9}, 1.0, 1);
        show("out", found);
    }
    {
        begin("flatten");
        const auto found = n::flatten(in.curve, {0.1, 0.9}, {0.1, 0.9}, {}, {0.3, 0.6});
        show("out", found.spline);
        show("moved", found.moved);
    }
    {
        begin("flatten along");
        const auto found = n::flatten(in.curve, {0.1, 0.9}, {0.1, 0.9}, {0.1, 0.9}, {0.3, 0.6});
        show("out", found.spline);
        show("moved", found.moved);
    }
    {
        begin("free_form_deform");
        const n::Spline square = n::Spline::create_bezier({1, 1}, 2, {0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 1.0, 2.0});
        const auto found = n::free_form_deform(in.curve, square, {-1.0, -1.0}, {1.0, 1.0}, 0.1);
        show("out", found.spline);
        show("deviation", found.deviation);
        show("proven", found.proven);
    }
    {
        begin("fair");
        const auto found = n::fair(in.curve, 2, 1000.0);
        show("out", found.spline);
        show("energies", found.energies);
        show("bound", found.bound);
    }
    {
        begin("fair surface");
        const auto found = n::fair(in.surface, 1, 1000.0, {-1, -1, -1, -1});
        show("out", found.spline);
        show("energies", found.energies);
        show("bound", found.bound);
    }
    {
        begin("constrain directions");
        n::Constraints given;
        given.params = {0.1, 0.9, 0.3, 0.7};
        given.targets = {0.1, 0.9, 0.3, 0.7, 0.2, 0.6};
        given.kinds = {2, 0};
        n::ConstrainOptions options;
        options.tolerance = 0.0;
        const auto found = n::constrain(in.surface, given, options);
        show("out", found.spline);
        show("residuals", found.residuals);
        show("rank", found.rank);
        show("moved", found.moved);
        show("optimality", found.optimality);
    }
    {
        begin("constrain curvature");
        n::Constraints given;
        given.params = {0.1};
        given.targets = {-1.0, 0.1};
        given.kinds = {3};
        n::ConstrainOptions options;
        options.weight_costs = {1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0};
        options.tolerance = 1e-09;
        const auto found = n::constrain(in.curve, given, options);
        show("out", found.spline);
        show("residuals", found.residuals);
        show("rank", found.rank);
        show("moved", found.moved);
        show("optimality", found.optimality);
    }
    {
        begin("constrain with costs");
        n::Constraints given;
        given.params = {0.3, 0.6};
        given.targets = {0.1, 0.9, 0.3, 0.7};
        given.kinds = {0, 0};
        given.orders = {0, 1};
        n::ConstrainOptions options;
        options.keep = {0, 0};
        options.costs = {1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0};
        options.weight_costs = {1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0};
        options.tolerance = 1e-06;
        const auto found = n::constrain(in.curve, given, options);
        show("out", found.spline);
        show("residuals", found.residuals);
        show("rank", found.rank);
        show("moved", found.moved);
        show("optimality", found.optimality);
    }
    {
        begin("bend");
        n::Bend how;
        how.origin = {0.1, 0.9};
        how.along = {1.0, 0.0};
        how.across = {0.0, 1.0};
        how.curvature = 1.0;
        how.lower = -9.0;
        how.upper = 9.0;
        const auto found = n::bend(in.curve, how, 0.1);
        show("out", found.spline);
        show("deviation", found.deviation);
        show("proven", found.proven);
    }
    {
        begin("snap_boundary");
        n::Boundary own;
        own.axis = 0;
        own.end = 1;
        n::Boundary target;
        target.axis = 0;
        target.end = 0;
        const auto found = n::snap_boundary(in.curve, own, in.segment, target, 1, 0u);
        show("out", found.spline);
        show("bound", found.bound);
    }
    {
        begin("snap_boundary surface");
        n::Boundary own;
        own.axis = 0;
        own.end = 1;
        n::Boundary target;
        target.axis = 1;
        target.end = 0;
        const auto found = n::snap_boundary(in.surface, own, in.surface, target, 1, 67108864u);
        show("out", found.spline);
        show("bound", found.bound);
    }
    {
        begin("constrain_with");
        n::Constraints given;
        given.params = {0.3, 0.6};
        given.targets = {0.1, 0.9, 0.3, 0.7};
        n::ConstrainOptions options;
        options.keep = {0, 0};
        options.tolerance = 0.0;
        const auto found = n::constrain(in.curve, given, options, watched());
        show("out", found.spline);
        show("residuals", found.residuals);
        show("rank", found.rank);
        show("moved", found.moved);
        show("optimality", found.optimality);
    }
    {
        begin("free_form_deform_with");
        const n::Spline square = n::Spline::create_bezier({1, 1}, 2, {0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 1.0, 2.0});
        const auto found = n::free_form_deform(in.curve, square, {-1.0, -1.0}, {1.0, 1.0}, 0.1, watched());
        show("out", found.spline);
        show("deviation", found.deviation);
        show("proven", found.proven);
    }
    {
        begin("fair_with");
        const auto found = n::fair(in.curve, 2, 1000.0, {}, watched());
        show("out", found.spline);
        show("energies", found.energies);
        show("bound", found.bound);
    }
    {
        begin("fair_with surface");
        const auto found = n::fair(in.surface, 1, 1000.0, {-1, -1, -1, -1}, watched());
        show("out", found.spline);
        show("energies", found.energies);
        show("bound", found.bound);
    }
    {
        begin("constrain_with directions");
        n::Constraints given;
        given.params = {0.1, 0.9, 0.3, 0.7};
        given.targets = {0.1, 0.9, 0.3, 0.7, 0.2, 0.6};
        given.kinds = {2, 0};
        n::ConstrainOptions options;
        options.tolerance = 0.0;
        const auto found = n::constrain(in.surface, given, options, watched());
        show("out", found.spline);
        show("residuals", found.residuals);
        show("rank", found.rank);
        show("moved", found.moved);
        show("optimality", found.optimality);
    }
    {
        begin("constrain_with curvature");
        n::Constraints given;
        given.params = {0.1};
        given.targets = {-1.0, 0.1};
        given.kinds = {3};
        n::ConstrainOptions options;
        options.weight_costs = {1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0};
        options.tolerance = 1e-09;
        const auto found = n::constrain(in.curve, given, options, watched());
        show("out", found.spline);
        show("residuals", found.residuals);
        show("rank", found.rank);
        show("moved", found.moved);
        show("optimality", found.optimality);
    }
    {
        begin("constrain_with with costs");
        n::Constraints given;
        given.params = {0.3, 0.6};
        given.targets = {0.1, 0.9, 0.3, 0.7};
        given.kinds = {0, 0};
        given.orders = {0, 1};
        n::ConstrainOptions options;
        options.keep = {0, 0};
        options.costs = {1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0};
        options.weight_costs = {1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0};
        options.tolerance = 1e-06;
        const auto found = n::constrain(in.curve, given, options, watched());
        show("out", found.spline);
        show("residuals", found.residuals);
        show("rank", found.rank);
        show("moved", found.moved);
        show("optimality", found.optimality);
    }
    {
        begin("bend_with");
        n::Bend how;
        how.origin = {0.1, 0.9};
        how.along = {1.0, 0.0};
        how.across = {0.0, 1.0};
        how.curvature = 1.0;
        how.lower = -9.0;
        how.upper = 9.0;
        const auto found = n::bend(in.curve, how, 0.1, watched());
        show("out", found.spline);
        show("deviation", found.deviation);
        show("proven", found.proven);
    }
}

void evaluation(const Inputs &in) {
    {
        begin("find_spans");
        const auto found = n::find_spans(2, {0.0, 0.0, 0.0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1.0, 1.0, 1.0}, {0.1, 0.9, 0.3, 0.7, 0.2, 0.6}, 0u);
        show("spans", found);
    }
    {
        begin("bernstein");
        const auto found = n::bernstein(5, 3, {0.1, 0.9, 0.3, 0.7, 0.2, 0.6});
        show("values", found);
    }
    {
        begin("basis");
        const auto found = n::basis(2, {0.0, 0.0, 0.0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1.0, 1.0, 1.0}, 4, {0.1, 0.9, 0.3, 0.7, 0.2, 0.6}, 0u);
        show("spans", found.spans);
        show("values", found.values);
    }
    {
        begin("rational_basis");
        const auto found = in.curve.rational_basis({0.1, 0.9, 0.3, 0.7, 0.2, 0.6}, 0u);
        show("spans", found.spans);
        show("values", found.values);
    }
    {
        begin("rational_basis surface");
        const auto found = in.surface.rational_basis({0.1, 0.9, 0.3, 0.7, 0.2, 0.6}, 0u);
        show("spans", found.spans);
        show("values", found.values);
    }
    {
        begin("basis_gradients");
        const auto found = in.curve.basis_gradients({0.1, 0.9, 0.3, 0.7, 0.2, 0.6}, 0u);
        show("spans", found.spans);
        show("gradients", found.gradients);
    }
    {
        begin("basis_gradients surface");
        const auto found = in.surface.basis_gradients({0.1, 0.9, 0.3, 0.7, 0.2, 0.6}, 0u);
        show("spans", found.spans);
        show("gradients", found.gradients);
    }
    {
        begin("eval");
        const auto found = in.curve.eval({0.1, 0.9, 0.3, 0.7, 0.2, 0.6}, 0u);
        show("points", found);
    }
    {
        begin("eval surface");
        const auto found = in.surface.eval({0.1, 0.9, 0.3, 0.7, 0.2, 0.6}, 0u);
        show("points", found);
    }
    {
        begin("eval volume");
        const auto found = in.volume.eval({0.1, 0.9, 0.3, 0.7, 0.2, 0.6}, 0u);
        show("points", found);
    }
    {
        begin("eval_derivs");
        const auto found = in.curve.eval_derivs(5, {0.1, 0.9, 0.3, 0.7, 0.2, 0.6}, 0u);
        show("derivs", found);
    }
    {
        begin("eval_derivs volume");
        const auto found = in.volume.eval_derivs(4, {0.1, 0.9, 0.3, 0.7, 0.2, 0.6}, 0u);
        show("derivs", found);
    }
    {
        begin("eval_grid");
        const auto found = in.surface.eval_grid({2, 2}, {0.1, 0.9, 0.3, 0.7}, 0u);
        show("points", found);
    }
    {
        begin("eval_grid_derivs");
        const auto found = in.volume.eval_grid_derivs(2, {2, 2, 2}, {0.1, 0.9, 0.3, 0.7, 0.2, 0.6}, 0u);
        show("derivs", found);
    }
    {
        begin("eval_f32");
        const auto found = in.curve.eval_f32({0.1, 0.9, 0.3, 0.7, 0.2, 0.6}, 0u);
        show("points", found);
    }
    {
        begin("eval_grid_f32");
        const auto found = in.volume.eval_grid_f32({2, 2, 2}, {0.1, 0.9, 0.3, 0.7, 0.2, 0.6}, 0u);
        show("points", found);
    }
    {
        begin("rational_collocation");
        const auto found = n::rational_collocation(in.curve, {0.1, 0.9, 0.3, 0.7, 0.2, 0.6}, {}, 0u);
        show("values", found.values);
        show("columns", found.columns);
        show("row_pointers", found.row_pointers);
    }
    {
        begin("rational_collocation of derivatives");
        const auto found = n::rational_collocation(in.curve, {0.1, 0.9, 0.3, 0.7, 0.2, 0.6}, {2}, 0u);
        show("values", found.values);
        show("columns", found.columns);
        show("row_pointers", found.row_pointers);
    }
    {
        begin("hull_size");
        const auto found = in.curve.hull_size({0.1, 0.9, 0.3, 0.7, 0.2, 0.6}, 0u);
        show("sizes", found);
    }
    {
        begin("hull_size signed");
        const auto found = in.homogeneous.hull_size({0.1, 0.9, 0.3, 0.7, 0.2, 0.6}, 0u);
        show("sizes", found);
    }
    {
        begin("surface_eval_frames");
        const auto found = n::surface_frames(in.surface, {0.1, 0.9, 0.3, 0.7, 0.2, 0.6}, 0u);
        show("points", found.points);
        show("du", found.du);
        show("dv", found.dv);
        show("normals", found.normals);
        show("status", found.status);
    }
    {
        begin("surface_eval_grid_frames");
        const auto found = n::surface_grid_frames(in.surface, {2, 2}, {0.1, 0.9, 0.3, 0.7}, 0u);
        show("points", found.points);
        show("du", found.du);
        show("dv", found.dv);
        show("normals", found.normals);
        show("status", found.status);
    }
    {
        begin("surface_eval_curvatures");
        const auto found = n::surface_curvatures(in.surface, {0.1, 0.9, 0.3, 0.7, 0.2, 0.6}, 0u);
        show("principal", found.principal);
        show("directions", found.directions);
        show("mean", found.mean);
        show("gaussian", found.gaussian);
        show("status", found.status);
    }
    {
        begin("curve_eval_frames");
        const auto found = n::curve_frames(in.curve, {0.1, 0.9, 0.3, 0.7, 0.2, 0.6}, 0u);
        show("points", found.points);
        show("tangents", found.tangents);
        show("normals", found.normals);
        show("binormals", found.binormals);
        show("curvatures", found.curvatures);
        show("torsions", found.torsions);
        show("status", found.status);
    }
    {
        begin("curve_eval_frames in space");
        const auto found = n::curve_frames(in.twist, {0.1, 0.9, 0.3, 0.7, 0.2, 0.6}, 0u);
        show("points", found.points);
        show("tangents", found.tangents);
        show("normals", found.normals);
        show("binormals", found.binormals);
        show("curvatures", found.curvatures);
        show("torsions", found.torsions);
        show("status", found.status);
    }
    {
        begin("curve_rotation_minimizing_frames");
        const auto found = n::rotation_minimizing_frames(in.twist, {0.1, 0.9, 0.3, 0.7, 0.2, 0.6}, std::array<double, 3>{0.0, 1.0, 2.0}, 0u);
        show("points", found.points);
        show("tangents", found.tangents);
        show("normals", found.normals);
        show("binormals", found.binormals);
        show("status", found.status);
    }
    {
        begin("weight_points");
        const auto found = n::weight_points(in.surface, 1, {0.1, 0.9});
        show("at_zero", found.at_zero);
        show("at_one", found.at_one);
        show("at_weight", found.at_weight);
    }
    {
        begin("weight_cross_ratio");
        const auto found = n::weight_cross_ratio({0.1}, {0.9}, {0.3}, {0.7});
        show("weight", found);
    }
    {
        begin("most_influential");
        const auto found = n::most_influential(in.surface, {0.1, 0.9, 0.3, 0.7, 0.2, 0.6});
        show("indices", found.indices);
        show("influences", found.influences);
    }
    {
        begin("blossom");
        const auto found = n::blossom(in.curve, {0.1}, {0.3, 0.6}, 0u);
        show("values", found);
    }
    {
        begin("collocation");
        const auto found = n::collocation({2, 1}, {3, 4}, {0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 0.0, 0.0, 1.0, 2.0, 3.0, 3.0}, {0.1, 0.9, 0.3, 0.7, 0.2, 0.6}, {}, 0u);
        show("values", found.values);
        show("columns", found.columns);
        show("row_pointers", found.row_pointers);
    }
    {
        begin("collocation of derivatives");
        const auto found = n::collocation({2, 1}, {3, 4}, {0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 0.0, 0.0, 1.0, 2.0, 3.0, 3.0}, {0.1, 0.9, 0.3, 0.7, 0.2, 0.6}, {1, 0}, 0u);
        show("values", found.values);
        show("columns", found.columns);
        show("row_pointers", found.row_pointers);
    }
    {
        begin("eval_adjoint");
        const auto found = n::eval_adjoint(in.curve, 0, {0.1, 0.9, 0.3, 0.7, 0.2, 0.6}, {1.0, 2.0, 3.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0u);
        show("grad_points", found.points);
        show("grad_weights", found.weights);
        show("grad_params", found.params);
    }
    {
        begin("eval_adjoint points");
        const auto found = n::eval_adjoint(in.surface, 1, {0.1, 0.9, 0.3, 0.7, 0.2, 0.6}, {1.0, 2.0, 3.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0u);
        show("grad_points", found.points);
        show("grad_weights", found.weights);
        show("grad_params", found.params);
    }
    {
        begin("eval_adjoint_knots");
        const auto found = n::eval_adjoint_knots(in.curve, 0, 0, {0.1, 0.9, 0.3, 0.7, 0.2, 0.6}, {1.0, 2.0, 3.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0u);
        show("grad_knots", found);
    }
    {
        begin("eval_adjoint_knots surface");
        const auto found = n::eval_adjoint_knots(in.surface, 1, 1, {0.1, 0.9, 0.3, 0.7, 0.2, 0.6}, {1.0, 2.0, 3.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0u);
        show("grad_knots", found);
    }
}

void form(const Inputs &in) {
    {
        begin("iso curve");
        const auto found = in.surface.iso(0, 0.3, 0u);
        show("out", found);
    }
    {
        begin("iso surface");
        const auto found = in.volume.iso(1, 0.3, 0u);
        show("out", found);
    }
    {
        begin("insert_knot");
        const auto found = in.curve.insert_knot(0, 0.3, 2);
        show("out", found);
    }
    {
        begin("insert_knot periodic");
        const auto found = in.loop.insert_knot(0, 2.5, 2);
        show("out", found);
    }
    {
        begin("insert_knot surface");
        const auto found = in.surface.insert_knot(1, 1.5, 1);
        show("out", found);
    }
    {
        begin("insert_knot 0 times");
        const auto found = in.surface.insert_knot(1, 1.5, 0);
        show("out", found);
    }
    {
        begin("refine");
        const auto found = in.curve.refine(0, {0.3, 0.6});
        show("out", found);
    }
    {
        begin("refine_uniform");
        const auto found = in.loop.refine_uniform(0, 3);
        show("out", found);
    }
    {
        begin("extract");
        const auto found = in.curve.extract({0.3}, {0.6});
        show("out", found);
    }
    {
        begin("split");
        const auto found = in.curve.split(0, 0.3);
        show("lower", found.first);
        show("upper", found.second);
    }
    {
        begin("clamp_ends");
        const auto found = in.loop.clamp(0, 3u);
        show("out", found);
    }
    {
        begin("unclamp");
        const auto found = n::unclamp(in.volume, 2, 3u);
        show("out", found);
    }
    {
        begin("move_seam");
        const auto found = in.loop.move_seam(0, 2.5);
        show("out", found);
    }
    {
        begin("join");
        const auto found = n::join(std::vector<n::Spline>{in.curve, in.curve}, 0, 9.0, 0u);
        show("out", found.spline);
        show("gap", found.gap);
    }
    {
        begin("join with gaps");
        const auto found = n::join(std::vector<n::Spline>{in.curve, in.curve}, 0, 9.0, 67108864u);
        show("out", found.spline);
        show("gap", found.gap);
    }
    {
        begin("snap_knots");
        const auto found = n::snap_knots(in.loop, 0, 0.26);
        show("out", found.spline);
        show("deviation", found.deviation);
    }
    {
        begin("extend");
        const auto found = n::extend(in.surface, 0, 0, 1.0, 1);
        show("out", found);
    }
    {
        begin("make_periodic");
        const auto found = n::make_periodic(in.curve, 0, 1.0);
        show("out", found.spline);
        show("deviation", found.deviation);
        show("order", found.order);
    }
    {
        begin("make_compatible");
        const auto found = n::make_compatible(std::vector<n::Spline>{in.curve, in.loop}, 0.01, 1073741824u);
        show("out", found.splines);
        show("deviation", found.deviation);
    }
    {
        begin("remove_knot");
        const auto found = n::remove_knot(in.curve, 0, 0.5, 1, 9.0);
        show("out", found.spline);
        show("removed", found.removed);
        show("bound", found.bound);
    }
    {
        begin("remove_knot periodic");
        const auto found = n::remove_knot(in.loop, 0, 3.0, 1, 9.0);
        show("out", found.spline);
        show("removed", found.removed);
        show("bound", found.bound);
    }
    {
        begin("reduce_knots");
        const auto found = n::reduce_knots(in.curve, -1, 9.0);
        show("out", found.spline);
        show("bound", found.bound);
    }
    {
        begin("reduce_degree");
        const auto found = n::reduce_degree(in.loop, 0, 1);
        show("out", found.spline);
        show("bound", found.bound);
    }
    {
        begin("simplify");
        const auto found = n::simplify(in.curve, 9.0);
        show("out", found.spline);
        show("bound", found.bound);
    }
    {
        begin("elevate");
        const auto found = in.curve.elevate(0, 2);
        show("out", found);
    }
    {
        begin("elevate periodic");
        const auto found = in.loop.elevate(0, 2);
        show("out", found);
    }
    {
        begin("elevate homogeneous");
        const auto found = in.homogeneous.elevate(0, 1);
        show("out", found);
    }
    {
        begin("reverse");
        const auto found = in.curve.reverse(0, 33554432u);
        show("out", found);
    }
    {
        begin("transpose");
        const auto found = in.volume.transpose({2, 0, 1});
        show("out", found);
    }
    {
        begin("reparametrize");
        const auto found = in.loop.reparametrize(0, 0.0, 1.0);
        show("out", found);
    }
    {
        begin("reparametrize_moebius");
        const auto found = n::reparametrize_moebius(in.curve, 0, 2.0);
        show("out", found);
    }
    {
        begin("derivative");
        const auto found = n::derivative(in.loop, 0, 1);
        show("out", found);
    }
    {
        begin("derivative rational");
        const auto found = n::derivative(in.curve, 0, 2);
        show("out", found);
    }
    {
        begin("derivative beyond the degree");
        const auto found = n::derivative(in.loop, 0, 9);
        show("out", found);
    }
    {
        begin("antiderivative");
        const auto found = n::antiderivative(in.volume, 1);
        show("out", found);
    }
    {
        begin("product");
        const auto found = n::product(in.curve, in.curve, 0u);
        show("out", found);
    }
    {
        begin("product periodic");
        const auto found = n::product(in.loop, in.loop, 0u);
        show("out", found);
    }
    {
        begin("product volume");
        const auto found = n::product(in.volume, in.volume, 134217728u);
        show("out", found);
    }
    {
        begin("compose");
        const n::Spline ramp = n::Spline::create_bezier({2}, 1, {0.0, 0.25, 1.0});
        const auto found = n::compose(in.curve, ramp);
        show("out", found);
    }
    {
        begin("compose around a loop");
        const n::Spline round = n::Spline::create_bezier({2}, 1, {0.0, 2.0, 9.0});
        const auto found = n::compose(in.loop, round);
        show("out", found);
    }
    {
        begin("compose on a surface");
        const n::Spline diagonal = n::Spline::create_bezier({2}, 2, {0.0, 0.0, 1.0, 0.0, 1.0, 1.0});
        const auto found = n::compose(in.surface, diagonal);
        show("out", found);
    }
    {
        begin("sum");
        const auto found = n::sum(in.loop, 1.0, in.loop, 2.0);
        show("out", found);
    }
    {
        begin("sum rational");
        const n::Spline half = n::reparametrize_moebius(in.curve, 0, 2.0);
        const auto found = n::sum(in.curve, 1.0, half, 1.0);
        show("out", found);
    }
    {
        begin("reduce_knots_with");
        const auto found = n::reduce_knots(in.curve, -1, 9.0, watched());
        show("out", found.spline);
        show("bound", found.bound);
    }
    {
        begin("reduce_degree_with");
        const auto found = n::reduce_degree(in.loop, 0, 1, watched());
        show("out", found.spline);
        show("bound", found.bound);
    }
    {
        begin("simplify_with");
        const auto found = n::simplify(in.curve, 9.0, watched());
        show("out", found.spline);
        show("bound", found.bound);
    }
    {
        begin("product_with");
        const auto found = n::product(in.curve, in.curve, 0u, watched());
        show("out", found);
    }
    {
        begin("product_with periodic");
        const auto found = n::product(in.loop, in.loop, 0u, watched());
        show("out", found);
    }
    {
        begin("product_with volume");
        const auto found = n::product(in.volume, in.volume, 134217728u, watched());
        show("out", found);
    }
    {
        begin("compose_with");
        const n::Spline ramp = n::Spline::create_bezier({2}, 1, {0.0, 0.25, 1.0});
        const auto found = n::compose(in.curve, ramp, watched());
        show("out", found);
    }
    {
        begin("compose_with around a loop");
        const n::Spline round = n::Spline::create_bezier({2}, 1, {0.0, 2.0, 9.0});
        const auto found = n::compose(in.loop, round, watched());
        show("out", found);
    }
    {
        begin("compose_with on a surface");
        const n::Spline diagonal = n::Spline::create_bezier({2}, 2, {0.0, 0.0, 1.0, 0.0, 1.0, 1.0});
        const auto found = n::compose(in.surface, diagonal, watched());
        show("out", found);
    }
}

void query(const Inputs &in) {
    {
        begin("deviation");
        const auto found = n::deviation(in.surface, in.surface);
        show("at_least", found.at_least);
        show("at_most", found.at_most);
    }
    {
        begin("curve_shape_factor");
        const auto found = n::shape_factor(in.segment);
        show("factor", found.factor);
        show("type", found.type);
    }
    {
        begin("conic_axes");
        const auto found = n::conic_axes(std::array<double, 6>{1.0, 0.0, 4.0, 0.0, 0.0, -4.0});
        show("type", found.type);
        show("origin", found.origin);
        show("x", found.x);
        show("sizes", found.sizes);
    }
    {
        begin("box");
        const auto found = n::box(in.volume, 0.001);
        show("lower", found.lower);
        show("upper", found.upper);
        show("gap", found.gap);
    }
    {
        begin("box of a part");
        const auto found = n::box(in.surface, 0.001, {0.0, 1.0, 0.0, 3.0});
        show("lower", found.lower);
        show("upper", found.upper);
        show("gap", found.gap);
    }
    {
        begin("oriented_box");
        const auto found = n::oriented_box(in.surface, 0.001);
        show("center", found.center);
        show("axes", found.axes);
        show("half", found.half);
    }
    {
        begin("tangent_cone");
        const auto found = n::tangent_cone(in.segment, 0, 0.1);
        show("direction", found.direction);
        show("angle", found.angle);
    }
    {
        begin("tangent_cone of a part");
        const auto found = n::tangent_cone(in.curve, 0, 0.1, {0.3, 0.6});
        show("direction", found.direction);
        show("angle", found.angle);
    }
    {
        begin("normal_cone");
        const auto found = n::normal_cone(in.surface, 0.1);
        show("direction", found.direction);
        show("angle", found.angle);
    }
    {
        begin("normal_cone of a part");
        const auto found = n::normal_cone(in.surface, 0.1, {0.0, 1.0, 0.0, 3.0});
        show("direction", found.direction);
        show("angle", found.angle);
    }
    {
        begin("extreme_point");
        const auto found = n::extreme_point(in.curve, {0.1, 0.9}, 1e-06);
        show("params", found.params);
        show("value", found.value);
        show("bound", found.bound);
    }
    {
        begin("extreme_point of a part");
        const auto found = n::extreme_point(in.curve, {0.1, 0.9}, 1e-06, {0.3, 0.6});
        show("params", found.params);
        show("value", found.value);
        show("bound", found.bound);
    }
    {
        begin("closest_points");
        n::Search how;
        how.tolerance = 0.0;
        how.budget = 0;
        how.flags = 0u;
        const auto found = n::closest_points(in.curve, {0.1, 0.9}, how);
        show("params", found.params);
        show("feet", found.points);
        show("distances", found.distances);
        show("status", found.status);
    }
    {
        begin("closest_adjoint");
        const auto found = n::closest_adjoint(in.curve, {0.1, 0.9}, {0.3}, {1.0}, {1.0, 2.0}, {1.0}, 0u);
        show("grad_points", found.points);
        show("grad_weights", found.weights);
        show("grad_queries", found.queries);
        show("status", found.status);
    }
    {
        begin("closest_points of a part");
        n::Search how;
        how.range = {0.0, 1.0, 0.0, 3.0};
        how.tolerance = 0.0;
        how.budget = 0;
        how.flags = 0u;
        const auto found = n::closest_points(in.surface, {0.1, 0.9, 0.3, 0.7, 0.2, 0.6}, how);
        show("params", found.params);
        show("feet", found.points);
        show("distances", found.distances);
        show("status", found.status);
    }
    {
        begin("farthest_points");
        n::Search how;
        how.tolerance = 0.0;
        how.budget = 0;
        how.flags = 0u;
        const auto found = n::farthest_points(in.curve, {0.1, 0.9}, how);
        show("params", found.params);
        show("feet", found.points);
        show("distances", found.distances);
        show("status", found.status);
    }
    {
        begin("farthest_points of a part");
        n::Search how;
        how.range = {0.3, 0.6};
        how.tolerance = 0.0;
        how.budget = 0;
        how.flags = 0u;
        const auto found = n::farthest_points(in.curve, {0.1, 0.9, 0.3, 0.7, 0.2, 0.6}, how);
        show("params", found.params);
        show("feet", found.points);
        show("distances", found.distances);
        show("status", found.status);
    }
    {
        begin("closest_local");
        const auto found = n::closest_local(in.curve, {0.1, 0.9, 0.3, 0.7, 0.2, 0.6}, {0.1, 0.9, 0.3}, 0u);
        show("params", found.params);
        show("feet", found.points);
        show("distances", found.distances);
        show("status", found.status);
    }
    {
        begin("closest_local params");
        const auto found = n::closest_local(in.curve, {0.1, 0.9}, {0.1}, 0u);
        show("params", found.params);
        show("feet", found.points);
        show("distances", found.distances);
        show("status", found.status);
    }
    {
        begin("curve_signed_distances");
        n::Search how;
        how.tolerance = 0.0;
        how.budget = 0;
        how.flags = 0u;
        const auto found = n::signed_distances(in.curve, {0.1, 0.9, 0.3, 0.7, 0.2, 0.6}, how);
        show("distances", found.distances);
        show("params", found.params);
        show("status", found.status);
    }
    {
        begin("curve_signed_distances alone");
        n::Search how;
        how.tolerance = 0.0;
        how.budget = 0;
        how.flags = 0u;
        const auto found = n::signed_distances(in.curve, {0.1, 0.9}, how);
        show("distances", found.distances);
        show("params", found.params);
        show("status", found.status);
    }
    {
        begin("closest_all");
        n::Search how;
        how.tolerance = 0.0;
        how.budget = 0;
        const auto found = n::closest_all(in.curve, {0.1, 0.9}, how);
        show("params", found.params);
        show("distances", found.distances);
        show("status", found.status);
    }
    {
        begin("closest_all inside");
        n::Search how;
        how.range = {0.0, 1.0};
        how.tolerance = 0.0;
        how.budget = 0;
        const auto found = n::closest_all(in.curve, {0.1, 0.9}, how);
        show("params", found.params);
        show("distances", found.distances);
        show("status", found.status);
    }
    {
        begin("critical_points");
        n::Search how;
        how.tolerance = 0.0;
        how.budget = 0;
        const auto found = n::critical_points(in.curve, {0.1, 0.9}, how);
        show("params", found.params);
        show("distances", found.distances);
        show("kinds", found.kinds);
        show("status", found.status);
    }
    {
        begin("critical_points inside");
        n::Search how;
        how.range = {0.0, 1.0};
        how.tolerance = 0.0;
        how.budget = 0;
        const auto found = n::critical_points(in.curve, {0.1, 0.9}, how);
        show("params", found.params);
        show("distances", found.distances);
        show("kinds", found.kinds);
        show("status", found.status);
    }
    {
        begin("distance");
        const auto found = n::distance(in.curve, in.loop, 1e-06, 0);
        show("at_least", found.at_least);
        show("at_most", found.at_most);
        show("params_a", found.params_a);
        show("params_b", found.params_b);
        show("status", found.status);
    }
    {
        begin("hausdorff_distance");
        const auto found = n::hausdorff_distance(in.curve, in.loop, 0.1, 0);
        show("at_least", found.at_least);
        show("at_most", found.at_most);
        show("params_a", found.params_a);
        show("params_b", found.params_b);
        show("status", found.status);
    }
    {
        begin("curve_features count");
        const auto found = n::features(in.twist, 127u);
        show("params", found.params);
        show("found", found.found);
        show("values", found.values);
        show("complete", found.complete);
    }
    {
        begin("curve_features periodic");
        const auto found = n::features(in.loop, 63u);
        show("params", found.params);
        show("found", found.found);
        show("values", found.values);
        show("complete", found.complete);
    }
    {
        begin("extrema");
        const n::Spline heights = n::Spline::create({1, 1}, {2, 2}, {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 3.0, 3.0}, 1, {0.0, 1.0, 1.0, 2.0}, {}, 0u);
        const auto found = n::extrema(heights, 31u);
        show("params", found.params);
        show("values", found.values);
        show("found", found.found);
        show("boxes", found.boxes);
        show("complete", found.complete);
    }
    {
        begin("extrema count");
        const n::Spline ramp = n::Spline::create_bezier({2}, 1, {0.0, 0.25, 1.0});
        const auto found = n::extrema(ramp, 3u);
        show("params", found.params);
        show("values", found.values);
        show("found", found.found);
        show("boxes", found.boxes);
        show("complete", found.complete);
    }
    {
        begin("mesh_curve");
        const auto found = n::mesh_curve(in.curve, 1.0, 2.0, 3.0);
        show("params", found.params);
        show("points", found.points);
        show("bound", found.bound);
        show("reached", found.reached);
    }
    {
        begin("mesh_curve count");
        const auto found = n::mesh_curve(in.loop, 0.5, 0.0, 0.0);
        show("params", found.params);
        show("points", found.points);
        show("bound", found.bound);
        show("reached", found.reached);
    }
    {
        begin("curve_monotone_pieces");
        const auto found = n::monotone_pieces(in.curve, {0.1, 0.9});
        show("starts", found.starts);
        show("signs", found.signs);
        show("complete", found.complete);
    }
    {
        begin("curve_convexity");
        const auto found = n::convexity(in.curve);
        show("convexity", found);
    }
    {
        begin("straightness");
        const auto found = n::straightness(in.segment);
        show("origin", found.origin);
        show("direction", found.direction);
        show("bound", found.bound);
    }
    {
        begin("planarity");
        const auto found = n::planarity(in.surface);
        show("origin", found.origin);
        show("normal", found.normal);
        show("bound", found.bound);
    }
    {
        begin("boundary_contacts");
        const auto found = n::boundary_contacts(in.surface, 0.1);
        show("closed", found.closed);
        show("gaps", found.gaps);
        show("collapsed", found.collapsed);
        show("sizes", found.sizes);
    }
    {
        begin("singular_points");
        const auto found = n::singular_points(in.surface, 0.1);
        show("params", found.params);
        show("boxes", found.boxes);
        show("complete", found.complete);
    }
    {
        begin("fold_test");
        const auto found = n::fold_test(in.surface);
        show("result", found.result);
        show("positive", found.positive);
        show("negative", found.negative);
    }
    {
        begin("fold_pieces");
        const auto found = n::fold_pieces(in.surface);
        show("folds", found.folds);
        show("signs", found.signs);
    }
    {
        begin("roots");
        const n::Spline ramp = n::Spline::create_bezier({2}, 1, {0.0, 0.25, 1.0});
        const auto found = n::roots(ramp, 0.5, 0.0);
        show("params", found.params);
        show("kinds", found.kinds);
        show("ranges", found.ranges);
        show("complete", found.complete);
    }
    {
        begin("roots count");
        const n::Spline round = n::Spline::create_bezier({2}, 1, {0.0, 2.0, 9.0});
        const auto found = n::roots(round, 3.0, 1e-09);
        show("params", found.params);
        show("kinds", found.kinds);
        show("ranges", found.ranges);
        show("complete", found.complete);
    }
    {
        begin("curve_level");
        const auto found = n::curve_level(in.curve, 1, {0.1, 0.9, -0.3}, 1e-09);
        show("params", found.params);
        show("kinds", found.kinds);
        show("ranges", found.ranges);
        show("complete", found.complete);
    }
    {
        begin("surface_rays");
        const auto found = n::rays(in.surface, {0.1, 0.2, 5.0, 0.3, 0.4, 6.0}, {0.0, 0.0, -1.0, 0.1, 0.1, -1.0});
        show("params", found.params);
        show("distances", found.distances);
        show("status", found.status);
    }
    {
        begin("surface_rays distances");
        const auto found = n::rays(in.surface, {0.1, 0.2, 5.0}, {0.0, 0.0, -1.0});
        show("params", found.params);
        show("distances", found.distances);
        show("status", found.status);
    }
    {
        begin("surface_ray_hits within");
        const auto found = n::ray_hits(in.surface, std::array<double, 3>{0.1, 0.2, 5.0}, std::array<double, 3>{0.0, 0.0, -1.0}, {-1.0, 20.0});
        show("params", found.params);
        show("distances", found.distances);
        show("kinds", found.kinds);
        show("complete", found.complete);
    }
    {
        begin("surface_ray_hits");
        const auto found = n::ray_hits(in.surface, std::array<double, 3>{0.1, 0.2, 5.0}, std::array<double, 3>{0.0, 0.0, -1.0});
        show("params", found.params);
        show("distances", found.distances);
        show("kinds", found.kinds);
        show("complete", found.complete);
    }
    {
        begin("surfaces_common_points");
        const n::Spline wall = n::Spline::create_bezier({1, 1}, 3, {0.3, -1.0, -1.0, 0.3, -1.0, 9.0, 0.4, 9.0, -1.0, 0.4, 9.0, 9.0});
        n::Placement at;
        const n::Spline sphere = n::sphere(at, 1.0, 0);
        const auto found = n::common_points(wall, in.surface, sphere, 0.001);
        show("params", found.params);
        show("points", found.points);
        show("kinds", found.kinds);
        show("ranges", found.ranges);
        show("complete", found.complete);
    }
    {
        begin("curve_surface_intersections");
        n::Placement at;
        const n::Spline sphere = n::sphere(at, 1.0, 0);
        const auto found = n::surface_intersections(in.twist, sphere, 1e-09);
        show("params_curve", found.params_curve);
        show("params_surface", found.params_surface);
        show("kinds", found.kinds);
        show("ranges_curve", found.ranges_curve);
        show("ranges_surface", found.ranges_surface);
        show("complete", found.complete);
    }
    {
        begin("face_rays");
        const auto found = in.face.rays({0.5, 1.2, 9.0, 0.3, 0.4, 6.0}, {0.0, 0.0, -1.0, 0.1, 0.1, -1.0});
        show("params", found.params);
        show("distances", found.distances);
        show("status", found.status);
    }
    {
        begin("face_rays distances");
        const auto found = in.face.rays({0.5, 1.2, 9.0}, {0.0, 0.0, -1.0});
        show("params", found.params);
        show("distances", found.distances);
        show("status", found.status);
    }
    {
        begin("face_closest_points");
        const auto found = in.face.closest_points({0.5, 1.2, 9.0, 0.3, 0.4, 6.0}, 1e-06);
        show("params", found.params);
        show("feet", found.points);
        show("distances", found.distances);
        show("status", found.status);
    }
    {
        begin("face_closest_points alone");
        const auto found = in.face.closest_points({0.1, 0.2, 0.3}, 0.0);
        show("params", found.params);
        show("feet", found.points);
        show("distances", found.distances);
        show("status", found.status);
    }
    {
        begin("face_distance");
        n::Placement at;
        const n::Spline sphere = n::sphere(at, 1.0, 0);
        const n::Face ball_face = n::Face::create(sphere, {}, {}, {}, {}, 1e-09, 0u);
        const auto found = in.face.distance(ball_face, 4.0);
        show("at_least", found.at_least);
        show("at_most", found.at_most);
        show("params_a", found.params_a);
        show("params_b", found.params_b);
        show("status", found.status);
    }
    {
        begin("face_hausdorff_distance");
        n::Placement at;
        const n::Spline sphere = n::sphere(at, 1.0, 0);
        const n::Face ball_face = n::Face::create(sphere, {}, {}, {}, {}, 1e-09, 0u);
        const auto found = in.face.hausdorff_distance(ball_face, 4.0);
        show("at_least", found.at_least);
        show("at_most", found.at_most);
        show("params_a", found.params_a);
        show("params_b", found.params_b);
        show("status", found.status);
    }
    {
        begin("model_instances");
        const auto found = in.model.instances();
        show("parents", found.parents);
        show("last_uses", found.uses);
        show("own_parts", found.parts);
        show("placements", found.placements);
    }
    {
        begin("model_rays");
        const auto found = in.model.rays({0.5, 1.2, 9.0, 0.3, 0.4, 6.0}, {0.0, 0.0, -1.0, 0.1, 0.1, -1.0});
        show("params", found.params);
        show("distances", found.distances);
        show("status", found.status);
        show("places", found.places);
    }
    {
        begin("model_rays places");
        n::Placement at;
        const n::Spline sphere = n::sphere(at, 1.0, 0);
        const n::Face ball_face = n::Face::create(sphere, {}, {}, {}, {}, 1e-09, 0u);
        const n::Model ball = n::Model::create(std::vector<n::Face>{ball_face}, 1.0);
        const auto found = ball.rays({0.1, 0.2, 5.0}, {0.0, 0.0, -1.0});
        show("params", found.params);
        show("distances", found.distances);
        show("status", found.status);
        show("places", found.places);
    }
    {
        begin("model_ray_hits within");
        const auto found = in.model.ray_hits(std::array<double, 3>{0.5, 1.2, 9.0}, std::array<double, 3>{0.0, 0.0, -1.0}, {-1.0, 20.0});
        show("params", found.params);
        show("distances", found.distances);
        show("kinds", found.kinds);
        show("places", found.places);
        show("complete", found.complete);
    }
    {
        begin("model_ray_hits");
        n::Placement at;
        const n::Spline sphere = n::sphere(at, 1.0, 0);
        const n::Face ball_face = n::Face::create(sphere, {}, {}, {}, {}, 1e-09, 0u);
        const n::Model ball = n::Model::create(std::vector<n::Face>{ball_face}, 1.0);
        const auto found = ball.ray_hits(std::array<double, 3>{0.1, 0.2, 5.0}, std::array<double, 3>{0.0, 0.0, -1.0});
        show("params", found.params);
        show("distances", found.distances);
        show("kinds", found.kinds);
        show("places", found.places);
        show("complete", found.complete);
    }
    {
        begin("model_closest_points");
        const auto found = in.model.closest_points({0.5, 1.2, 9.0, 0.3, 0.4, 6.0}, 1e-06);
        show("params", found.params);
        show("feet", found.points);
        show("distances", found.distances);
        show("status", found.status);
        show("places", found.places);
    }
    {
        begin("model_closest_points alone");
        n::Placement at;
        const n::Spline sphere = n::sphere(at, 1.0, 0);
        const n::Face ball_face = n::Face::create(sphere, {}, {}, {}, {}, 1e-09, 0u);
        const n::Model ball = n::Model::create(std::vector<n::Face>{ball_face}, 1.0);
        const auto found = ball.closest_points({0.1, 0.2, 3.0}, 0.0);
        show("params", found.params);
        show("feet", found.points);
        show("distances", found.distances);
        show("status", found.status);
        show("places", found.places);
    }
    {
        begin("model_classify");
        n::Placement at;
        const n::Spline sphere = n::sphere(at, 1.0, 0);
        const n::Face ball_face = n::Face::create(sphere, {}, {}, {}, {}, 1e-09, 0u);
        const n::Model ball = n::Model::create(std::vector<n::Face>{ball_face}, 1.0);
        const auto found = ball.classify({0.1, 0.2, 0.3, 1.0, 1.0, 1.0}, 0.0);
        show("sides", found);
    }
    {
        begin("model_classify near");
        n::Placement at;
        const n::Spline sphere = n::sphere(at, 1.0, 0);
        const n::Face ball_face = n::Face::create(sphere, {}, {}, {}, {}, 1e-09, 0u);
        const n::Model ball = n::Model::create(std::vector<n::Face>{ball_face}, 1.0);
        const auto found = ball.classify({0.1, 0.2, 0.3, 0.0, 0.6, 0.8}, 0.001);
        show("sides", found);
    }
    {
        begin("model_area");
        n::Placement at;
        const n::Spline sphere = n::sphere(at, 1.0, 0);
        const n::Face ball_face = n::Face::create(sphere, {}, {}, {}, {}, 1e-09, 0u);
        const n::Model ball = n::Model::create(std::vector<n::Face>{ball_face}, 1.0);
        const auto found = ball.area(1e-06);
        show("area", found.value);
        show("error", found.error);
    }
    {
        begin("model_volume");
        n::Placement at;
        const n::Spline sphere = n::sphere(at, 1.0, 0);
        const n::Face ball_face = n::Face::create(sphere, {}, {}, {}, {}, 1e-09, 0u);
        const n::Model ball = n::Model::create(std::vector<n::Face>{ball_face}, 1.0);
        const auto found = ball.volume(1e-06);
        show("volume", found.volume);
        show("centroid", found.centroid);
        show("inertia", found.inertia);
        show("openness", found.openness);
        show("error", found.error);
    }
    {
        begin("model_volume alone");
        n::Placement at;
        const n::Spline sphere = n::sphere(at, 1.0, 0);
        const n::Face ball_face = n::Face::create(sphere, {}, {}, {}, {}, 1e-09, 0u);
        const n::Model ball = n::Model::create(std::vector<n::Face>{ball_face}, 1.0);
        const auto found = ball.volume(1e-06);
        show("volume", found.volume);
        show("centroid", found.centroid);
        show("inertia", found.inertia);
        show("openness", found.openness);
        show("error", found.error);
    }
    {
        begin("curve_self_intersections");
        const auto found = n::self_intersections(in.curve, 1e-09);
        show("params_a", found.params_a);
        show("params_b", found.params_b);
        show("kinds", found.kinds);
        show("ranges_a", found.ranges_a);
        show("ranges_b", found.ranges_b);
        show("complete", found.complete);
    }
    {
        begin("curve_intersections");
        const auto found = n::curve_intersections(in.curve, in.segment, 1e-09);
        show("params_a", found.params_a);
        show("params_b", found.params_b);
        show("kinds", found.kinds);
        show("ranges_a", found.ranges_a);
        show("ranges_b", found.ranges_b);
        show("complete", found.complete);
    }
    {
        begin("curve_level conic");
        const auto found = n::curve_level(in.loop, 2, {1.0, 0.0, 0.0, 1.0, 0.0, -0.5}, 0.0);
        show("params", found.params);
        show("kinds", found.kinds);
        show("ranges", found.ranges);
        show("complete", found.complete);
    }
    {
        begin("fold_test seen from above");
        const auto found = n::fold_test(in.surface, {1.0, 2.0, 3.0});
        show("result", found.result);
        show("positive", found.positive);
        show("negative", found.negative);
    }
    {
        begin("fold_pieces seen from above");
        const auto found = n::fold_pieces(in.surface, {1.0, 2.0, 3.0});
        show("folds", found.folds);
        show("signs", found.signs);
    }
    {
        begin("recognize curve");
        const auto found = n::recognize(in.curve, 1e-09);
        show("shape", found.shape);
        show("placement", found.origin);
        show("placement", found.axis);
        show("placement", found.x);
        show("sizes", found.sizes);
        show("deviation", found.deviation);
    }
    {
        begin("recognize surface");
        const auto found = n::recognize(in.surface, 0.2);
        show("shape", found.shape);
        show("placement", found.origin);
        show("placement", found.axis);
        show("placement", found.x);
        show("sizes", found.sizes);
        show("deviation", found.deviation);
    }
    {
        begin("length_adjoint");
        const auto found = n::length_adjoint(in.curve, 1e-06, 1.0, {}, 0u);
        show("grad_points", found.points);
        show("grad_weights", found.weights);
        show("error", found.error);
    }
    {
        begin("length_adjoint of a part");
        const auto found = n::length_adjoint(in.curve, 1e-06, 1.0, {0.3, 0.6}, 0u);
        show("grad_points", found.points);
        show("grad_weights", found.weights);
        show("error", found.error);
    }
    {
        begin("curve_length");
        const auto found = n::length(in.curve, 1e-09);
        show("length", found.value);
        show("error", found.error);
    }
    {
        begin("curve_length of a part");
        const auto found = n::length(in.curve, 1e-09, {0.3, 0.6});
        show("length", found.value);
        show("error", found.error);
    }
    {
        begin("curve_lengths");
        const auto found = n::lengths(in.loop, {4.0}, 1e-09);
        show("lengths", found);
    }
    {
        begin("curve_params_at_lengths");
        const auto found = n::params_at_lengths(in.curve, {4.0}, 1e-09, 0u);
        show("params", found);
    }
    {
        begin("curve_divide");
        const auto found = n::divide(in.curve, 5, 1e-09, 0u);
        show("params", found.params);
        show("size", found.size);
    }
    {
        begin("curve_divide a part");
        const auto found = n::divide(in.curve, 5, 1e-09, 0u, {0.3, 0.6});
        show("params", found.params);
        show("size", found.size);
    }
    {
        begin("curve_divide chords");
        const auto found = n::divide(in.curve, 5, 1e-09, 33554432u);
        show("params", found.params);
        show("size", found.size);
    }
    {
        begin("surface_area");
        const auto found = n::area(in.surface, 1e-09);
        show("area", found.value);
        show("error", found.error);
    }
    {
        begin("surface_area of a part");
        const auto found = n::area(in.surface, 1e-09, {0.0, 1.0, 0.0, 3.0});
        show("area", found.value);
        show("error", found.error);
    }
    {
        begin("moments");
        const auto found = n::moments(in.surface, 1e-09);
        show("content", found.content);
        show("centroid", found.centroid);
        show("inertia", found.inertia);
        show("error", found.error);
    }
    {
        begin("enclosed_area");
        const auto found = n::enclosed_area(std::vector<n::Spline>{in.loop}, 1e-09, 1e-09);
        show("area", found.area);
        show("centroid", found.centroid);
        show("inertia", found.inertia);
        show("error", found.error);
    }
    {
        begin("enclosed_volume");
        const auto found = n::enclosed_volume(std::vector<n::Spline>{in.surface}, 1e-09);
        show("volume", found.volume);
        show("centroid", found.centroid);
        show("inertia", found.inertia);
        show("openness", found.openness);
        show("error", found.error);
    }
    {
        begin("enclosed_volume sphere");
        n::Placement at;
        const n::Spline sphere = n::sphere(at, 1.0, 0);
        const auto found = n::enclosed_volume(std::vector<n::Spline>{sphere}, 1e-06);
        show("volume", found.volume);
        show("centroid", found.centroid);
        show("inertia", found.inertia);
        show("openness", found.openness);
        show("error", found.error);
    }
    {
        begin("quadrature");
        const auto found = n::quadrature(in.curve, 2);
        show("params", found.params);
        show("weights", found.weights);
        show("measures", found.measures);
    }
    {
        begin("quadrature surface");
        const auto found = n::quadrature(in.surface, 1);
        show("params", found.params);
        show("weights", found.weights);
        show("measures", found.measures);
    }
    {
        begin("coons_gaps");
        const auto found = n::coons_gaps(std::array<n::Spline, 4>{in.curve, in.curve, in.loop, in.loop}, std::array<n::Spline, 4>{in.curve, in.curve, in.loop, in.loop});
        show("positions", found.positions);
        show("tangents", found.tangents);
        show("twists", found.twists);
    }
    {
        begin("continuity");
        n::ContinuityTolerances allowed;
        allowed.position = 0.0;
        allowed.derivative = 0.0;
        allowed.angle = 0.0;
        const auto found = n::continuity(in.curve, 0, allowed);
        show("knots", found.knots);
        show("knot_orders", found.knot_orders);
        show("orders", found.orders);
        show("geometric_orders", found.geometric_orders);
        show("position_gaps", found.position_gaps);
        show("angles", found.angles);
        show("curvature_gaps", found.curvature_gaps);
    }
    {
        begin("continuity count");
        n::ContinuityTolerances allowed;
        allowed.position = 0.0;
        allowed.derivative = 0.0;
        allowed.angle = 0.0;
        const auto found = n::continuity(in.surface, 1, allowed);
        show("knots", found.knots);
        show("knot_orders", found.knot_orders);
        show("orders", found.orders);
        show("geometric_orders", found.geometric_orders);
        show("position_gaps", found.position_gaps);
        show("angles", found.angles);
        show("curvature_gaps", found.curvature_gaps);
    }
    {
        begin("continuity_between");
        n::ContinuityTolerances allowed;
        allowed.position = 0.0;
        allowed.derivative = 0.0;
        allowed.angle = 0.0;
        const auto found = n::continuity_between(in.curve, 1, in.curve, 0, allowed);
        show("order", found.order);
        show("geometric", found.geometric);
        show("position_gap", found.position_gap);
        show("angle", found.angle);
        show("curvature_gap", found.curvature_gap);
    }
    {
        begin("closest_points_with");
        n::Search how;
        how.tolerance = 0.0;
        how.budget = 0;
        how.flags = 0u;
        const auto found = n::closest_points(in.curve, {0.1, 0.9}, how, watched());
        show("params", found.params);
        show("feet", found.points);
        show("distances", found.distances);
        show("status", found.status);
    }
    {
        begin("closest_points_with of a part");
        n::Search how;
        how.range = {0.0, 1.0, 0.0, 3.0};
        how.tolerance = 0.0;
        how.budget = 0;
        how.flags = 0u;
        const auto found = n::closest_points(in.surface, {0.1, 0.9, 0.3, 0.7, 0.2, 0.6}, how, watched());
        show("params", found.params);
        show("feet", found.points);
        show("distances", found.distances);
        show("status", found.status);
    }
    {
        begin("farthest_points_with");
        n::Search how;
        how.tolerance = 0.0;
        how.budget = 0;
        how.flags = 0u;
        const auto found = n::farthest_points(in.curve, {0.1, 0.9}, how, watched());
        show("params", found.params);
        show("feet", found.points);
        show("distances", found.distances);
        show("status", found.status);
    }
    {
        begin("farthest_points_with of a part");
        n::Search how;
        how.range = {0.3, 0.6};
        how.tolerance = 0.0;
        how.budget = 0;
        how.flags = 0u;
        const auto found = n::farthest_points(in.curve, {0.1, 0.9, 0.3, 0.7, 0.2, 0.6}, how, watched());
        show("params", found.params);
        show("feet", found.points);
        show("distances", found.distances);
        show("status", found.status);
    }
    {
        begin("closest_local_with");
        const auto found = n::closest_local(in.curve, {0.1, 0.9, 0.3, 0.7, 0.2, 0.6}, {0.1, 0.9, 0.3}, 0u, watched());
        show("params", found.params);
        show("feet", found.points);
        show("distances", found.distances);
        show("status", found.status);
    }
    {
        begin("closest_local_with params");
        const auto found = n::closest_local(in.curve, {0.1, 0.9}, {0.1}, 0u, watched());
        show("params", found.params);
        show("feet", found.points);
        show("distances", found.distances);
        show("status", found.status);
    }
    {
        begin("curve_signed_distances_with");
        n::Search how;
        how.tolerance = 0.0;
        how.budget = 0;
        how.flags = 0u;
        const auto found = n::signed_distances(in.curve, {0.1, 0.9, 0.3, 0.7, 0.2, 0.6}, how, watched());
        show("distances", found.distances);
        show("params", found.params);
        show("status", found.status);
    }
    {
        begin("curve_signed_distances_with alone");
        n::Search how;
        how.tolerance = 0.0;
        how.budget = 0;
        how.flags = 0u;
        const auto found = n::signed_distances(in.curve, {0.1, 0.9}, how, watched());
        show("distances", found.distances);
        show("params", found.params);
        show("status", found.status);
    }
    {
        begin("closest_all_with");
        n::Search how;
        how.tolerance = 0.0;
        how.budget = 0;
        const auto found = n::closest_all(in.curve, {0.1, 0.9}, how, watched());
        show("params", found.params);
        show("distances", found.distances);
        show("status", found.status);
    }
    {
        begin("closest_all_with inside");
        n::Search how;
        how.range = {0.0, 1.0};
        how.tolerance = 0.0;
        how.budget = 0;
        const auto found = n::closest_all(in.curve, {0.1, 0.9}, how, watched());
        show("params", found.params);
        show("distances", found.distances);
        show("status", found.status);
    }
    {
        begin("critical_points_with");
        n::Search how;
        how.tolerance = 0.0;
        how.budget = 0;
        const auto found = n::critical_points(in.curve, {0.1, 0.9}, how, watched());
        show("params", found.params);
        show("distances", found.distances);
        show("kinds", found.kinds);
        show("status", found.status);
    }
    {
        begin("critical_points_with inside");
        n::Search how;
        how.range = {0.0, 1.0};
        how.tolerance = 0.0;
        how.budget = 0;
        const auto found = n::critical_points(in.curve, {0.1, 0.9}, how, watched());
        show("params", found.params);
        show("distances", found.distances);
        show("kinds", found.kinds);
        show("status", found.status);
    }
    {
        begin("distance_with");
        const auto found = n::distance(in.curve, in.loop, 1e-06, 0, watched());
        show("at_least", found.at_least);
        show("at_most", found.at_most);
        show("params_a", found.params_a);
        show("params_b", found.params_b);
        show("status", found.status);
    }
    {
        begin("hausdorff_distance_with");
        const auto found = n::hausdorff_distance(in.curve, in.loop, 0.1, 0, watched());
        show("at_least", found.at_least);
        show("at_most", found.at_most);
        show("params_a", found.params_a);
        show("params_b", found.params_b);
        show("status", found.status);
    }
    {
        begin("curve_features_with count");
        const auto found = n::features(in.twist, 127u, watched());
        show("params", found.params);
        show("found", found.found);
        show("values", found.values);
        show("complete", found.complete);
    }
    {
        begin("curve_features_with periodic");
        const auto found = n::features(in.loop, 63u, watched());
        show("params", found.params);
        show("found", found.found);
        show("values", found.values);
        show("complete", found.complete);
    }
    {
        begin("extrema_with");
        const n::Spline heights = n::Spline::create({1, 1}, {2, 2}, {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 3.0, 3.0}, 1, {0.0, 1.0, 1.0, 2.0}, {}, 0u);
        const auto found = n::extrema(heights, 31u, watched());
        show("params", found.params);
        show("values", found.values);
        show("found", found.found);
        show("boxes", found.boxes);
        show("complete", found.complete);
    }
    {
        begin("extrema_with count");
        const n::Spline ramp = n::Spline::create_bezier({2}, 1, {0.0, 0.25, 1.0});
        const auto found = n::extrema(ramp, 3u, watched());
        show("params", found.params);
        show("values", found.values);
        show("found", found.found);
        show("boxes", found.boxes);
        show("complete", found.complete);
    }
    {
        begin("mesh_curve_with");
        const auto found = n::mesh_curve(in.curve, 1.0, 2.0, 3.0, watched());
        show("params", found.params);
        show("points", found.points);
        show("bound", found.bound);
        show("reached", found.reached);
    }
    {
        begin("mesh_curve_with count");
        const auto found = n::mesh_curve(in.loop, 0.5, 0.0, 0.0, watched());
        show("params", found.params);
        show("points", found.points);
        show("bound", found.bound);
        show("reached", found.reached);
    }
    {
        begin("fold_test_with");
        const auto found = n::fold_test(in.surface, {}, watched());
        show("result", found.result);
        show("positive", found.positive);
        show("negative", found.negative);
    }
    {
        begin("fold_pieces_with");
        const auto found = n::fold_pieces(in.surface, {}, watched());
        show("folds", found.folds);
        show("signs", found.signs);
    }
    {
        begin("roots_with");
        const n::Spline ramp = n::Spline::create_bezier({2}, 1, {0.0, 0.25, 1.0});
        const auto found = n::roots(ramp, 0.5, 0.0, watched());
        show("params", found.params);
        show("kinds", found.kinds);
        show("ranges", found.ranges);
        show("complete", found.complete);
    }
    {
        begin("roots_with count");
        const n::Spline round = n::Spline::create_bezier({2}, 1, {0.0, 2.0, 9.0});
        const auto found = n::roots(round, 3.0, 1e-09, watched());
        show("params", found.params);
        show("kinds", found.kinds);
        show("ranges", found.ranges);
        show("complete", found.complete);
    }
    {
        begin("curve_level_with");
        const auto found = n::curve_level(in.curve, 1, {0.1, 0.9, -0.3}, 1e-09, watched());
        show("params", found.params);
        show("kinds", found.kinds);
        show("ranges", found.ranges);
        show("complete", found.complete);
    }
    {
        begin("surface_rays_with");
        const auto found = n::rays(in.surface, {0.1, 0.2, 5.0, 0.3, 0.4, 6.0}, {0.0, 0.0, -1.0, 0.1, 0.1, -1.0}, watched());
        show("params", found.params);
        show("distances", found.distances);
        show("status", found.status);
    }
    {
        begin("surface_rays_with distances");
        const auto found = n::rays(in.surface, {0.1, 0.2, 5.0}, {0.0, 0.0, -1.0}, watched());
        show("params", found.params);
        show("distances", found.distances);
        show("status", found.status);
    }
    {
        begin("surfaces_common_points_with");
        const n::Spline wall = n::Spline::create_bezier({1, 1}, 3, {0.3, -1.0, -1.0, 0.3, -1.0, 9.0, 0.4, 9.0, -1.0, 0.4, 9.0, 9.0});
        n::Placement at;
        const n::Spline sphere = n::sphere(at, 1.0, 0);
        const auto found = n::common_points(wall, in.surface, sphere, 0.001, watched());
        show("params", found.params);
        show("points", found.points);
        show("kinds", found.kinds);
        show("ranges", found.ranges);
        show("complete", found.complete);
    }
    {
        begin("curve_surface_intersections_with");
        n::Placement at;
        const n::Spline sphere = n::sphere(at, 1.0, 0);
        const auto found = n::surface_intersections(in.twist, sphere, 1e-09, watched());
        show("params_curve", found.params_curve);
        show("params_surface", found.params_surface);
        show("kinds", found.kinds);
        show("ranges_curve", found.ranges_curve);
        show("ranges_surface", found.ranges_surface);
        show("complete", found.complete);
    }
    {
        begin("face_rays_with");
        const auto found = in.face.rays({0.5, 1.2, 9.0, 0.3, 0.4, 6.0}, {0.0, 0.0, -1.0, 0.1, 0.1, -1.0}, watched());
        show("params", found.params);
        show("distances", found.distances);
        show("status", found.status);
    }
    {
        begin("face_rays_with distances");
        const auto found = in.face.rays({0.5, 1.2, 9.0}, {0.0, 0.0, -1.0}, watched());
        show("params", found.params);
        show("distances", found.distances);
        show("status", found.status);
    }
    {
        begin("face_closest_points_with");
        const auto found = in.face.closest_points({0.5, 1.2, 9.0, 0.3, 0.4, 6.0}, 1e-06, watched());
        show("params", found.params);
        show("feet", found.points);
        show("distances", found.distances);
        show("status", found.status);
    }
    {
        begin("face_closest_points_with alone");
        const auto found = in.face.closest_points({0.1, 0.2, 0.3}, 0.0, watched());
        show("params", found.params);
        show("feet", found.points);
        show("distances", found.distances);
        show("status", found.status);
    }
    {
        begin("face_distance_with");
        n::Placement at;
        const n::Spline sphere = n::sphere(at, 1.0, 0);
        const n::Face ball_face = n::Face::create(sphere, {}, {}, {}, {}, 1e-09, 0u);
        const auto found = in.face.distance(ball_face, 4.0, watched());
        show("at_least", found.at_least);
        show("at_most", found.at_most);
        show("params_a", found.params_a);
        show("params_b", found.params_b);
        show("status", found.status);
    }
    {
        begin("face_hausdorff_distance_with");
        n::Placement at;
        const n::Spline sphere = n::sphere(at, 1.0, 0);
        const n::Face ball_face = n::Face::create(sphere, {}, {}, {}, {}, 1e-09, 0u);
        const auto found = in.face.hausdorff_distance(ball_face, 4.0, watched());
        show("at_least", found.at_least);
        show("at_most", found.at_most);
        show("params_a", found.params_a);
        show("params_b", found.params_b);
        show("status", found.status);
    }
    {
        begin("model_rays_with");
        const auto found = in.model.rays({0.5, 1.2, 9.0, 0.3, 0.4, 6.0}, {0.0, 0.0, -1.0, 0.1, 0.1, -1.0}, watched());
        show("params", found.params);
        show("distances", found.distances);
        show("status", found.status);
        show("places", found.places);
    }
    {
        begin("model_rays_with places");
        n::Placement at;
        const n::Spline sphere = n::sphere(at, 1.0, 0);
        const n::Face ball_face = n::Face::create(sphere, {}, {}, {}, {}, 1e-09, 0u);
        const n::Model ball = n::Model::create(std::vector<n::Face>{ball_face}, 1.0);
        const auto found = ball.rays({0.1, 0.2, 5.0}, {0.0, 0.0, -1.0}, watched());
        show("params", found.params);
        show("distances", found.distances);
        show("status", found.status);
        show("places", found.places);
    }
    {
        begin("model_ray_hits_with within");
        const auto found = in.model.ray_hits(std::array<double, 3>{0.5, 1.2, 9.0}, std::array<double, 3>{0.0, 0.0, -1.0}, {-1.0, 20.0}, watched());
        show("params", found.params);
        show("distances", found.distances);
        show("kinds", found.kinds);
        show("places", found.places);
        show("complete", found.complete);
    }
    {
        begin("model_ray_hits_with");
        n::Placement at;
        const n::Spline sphere = n::sphere(at, 1.0, 0);
        const n::Face ball_face = n::Face::create(sphere, {}, {}, {}, {}, 1e-09, 0u);
        const n::Model ball = n::Model::create(std::vector<n::Face>{ball_face}, 1.0);
        const auto found = ball.ray_hits(std::array<double, 3>{0.1, 0.2, 5.0}, std::array<double, 3>{0.0, 0.0, -1.0}, {}, watched());
        show("params", found.params);
        show("distances", found.distances);
        show("kinds", found.kinds);
        show("places", found.places);
        show("complete", found.complete);
    }
    {
        begin("model_closest_points_with");
        const auto found = in.model.closest_points({0.5, 1.2, 9.0, 0.3, 0.4, 6.0}, 1e-06, watched());
        show("params", found.params);
        show("feet", found.points);
        show("distances", found.distances);
        show("status", found.status);
        show("places", found.places);
    }
    {
        begin("model_closest_points_with alone");
        n::Placement at;
        const n::Spline sphere = n::sphere(at, 1.0, 0);
        const n::Face ball_face = n::Face::create(sphere, {}, {}, {}, {}, 1e-09, 0u);
        const n::Model ball = n::Model::create(std::vector<n::Face>{ball_face}, 1.0);
        const auto found = ball.closest_points({0.1, 0.2, 3.0}, 0.0, watched());
        show("params", found.params);
        show("feet", found.points);
        show("distances", found.distances);
        show("status", found.status);
        show("places", found.places);
    }
    {
        begin("model_classify_with");
        n::Placement at;
        const n::Spline sphere = n::sphere(at, 1.0, 0);
        const n::Face ball_face = n::Face::create(sphere, {}, {}, {}, {}, 1e-09, 0u);
        const n::Model ball = n::Model::create(std::vector<n::Face>{ball_face}, 1.0);
        const auto found = ball.classify({0.1, 0.2, 0.3, 1.0, 1.0, 1.0}, 0.0, watched());
        show("sides", found);
    }
    {
        begin("model_classify_with near");
        n::Placement at;
        const n::Spline sphere = n::sphere(at, 1.0, 0);
        const n::Face ball_face = n::Face::create(sphere, {}, {}, {}, {}, 1e-09, 0u);
        const n::Model ball = n::Model::create(std::vector<n::Face>{ball_face}, 1.0);
        const auto found = ball.classify({0.1, 0.2, 0.3, 0.0, 0.6, 0.8}, 0.001, watched());
        show("sides", found);
    }
    {
        begin("model_area_with");
        n::Placement at;
        const n::Spline sphere = n::sphere(at, 1.0, 0);
        const n::Face ball_face = n::Face::create(sphere, {}, {}, {}, {}, 1e-09, 0u);
        const n::Model ball = n::Model::create(std::vector<n::Face>{ball_face}, 1.0);
        const auto found = ball.area(1e-06, watched());
        show("area", found.value);
        show("error", found.error);
    }
    {
        begin("model_volume_with");
        n::Placement at;
        const n::Spline sphere = n::sphere(at, 1.0, 0);
        const n::Face ball_face = n::Face::create(sphere, {}, {}, {}, {}, 1e-09, 0u);
        const n::Model ball = n::Model::create(std::vector<n::Face>{ball_face}, 1.0);
        const auto found = ball.volume(1e-06, watched());
        show("volume", found.volume);
        show("centroid", found.centroid);
        show("inertia", found.inertia);
        show("openness", found.openness);
        show("error", found.error);
    }
    {
        begin("model_volume_with alone");
        n::Placement at;
        const n::Spline sphere = n::sphere(at, 1.0, 0);
        const n::Face ball_face = n::Face::create(sphere, {}, {}, {}, {}, 1e-09, 0u);
        const n::Model ball = n::Model::create(std::vector<n::Face>{ball_face}, 1.0);
        const auto found = ball.volume(1e-06, watched());
        show("volume", found.volume);
        show("centroid", found.centroid);
        show("inertia", found.inertia);
        show("openness", found.openness);
        show("error", found.error);
    }
    {
        begin("curve_self_intersections_with");
        const auto found = n::self_intersections(in.curve, 1e-09, watched());
        show("params_a", found.params_a);
        show("params_b", found.params_b);
        show("kinds", found.kinds);
        show("ranges_a", found.ranges_a);
        show("ranges_b", found.ranges_b);
        show("complete", found.complete);
    }
    {
        begin("curve_intersections_with");
        const auto found = n::curve_intersections(in.curve, in.segment, 1e-09, watched());
        show("params_a", found.params_a);
        show("params_b", found.params_b);
        show("kinds", found.kinds);
        show("ranges_a", found.ranges_a);
        show("ranges_b", found.ranges_b);
        show("complete", found.complete);
    }
    {
        begin("curve_level_with conic");
        const auto found = n::curve_level(in.loop, 2, {1.0, 0.0, 0.0, 1.0, 0.0, -0.5}, 0.0, watched());
        show("params", found.params);
        show("kinds", found.kinds);
        show("ranges", found.ranges);
        show("complete", found.complete);
    }
    {
        begin("fold_test_with seen from above");
        const auto found = n::fold_test(in.surface, {1.0, 2.0, 3.0}, watched());
        show("result", found.result);
        show("positive", found.positive);
        show("negative", found.negative);
    }
    {
        begin("fold_pieces_with seen from above");
        const auto found = n::fold_pieces(in.surface, {1.0, 2.0, 3.0}, watched());
        show("folds", found.folds);
        show("signs", found.signs);
    }
    {
        begin("recognize_with curve");
        const auto found = n::recognize(in.curve, 1e-09, watched());
        show("shape", found.shape);
        show("placement", found.origin);
        show("placement", found.axis);
        show("placement", found.x);
        show("sizes", found.sizes);
        show("deviation", found.deviation);
    }
    {
        begin("recognize_with surface");
        const auto found = n::recognize(in.surface, 0.2, watched());
        show("shape", found.shape);
        show("placement", found.origin);
        show("placement", found.axis);
        show("placement", found.x);
        show("sizes", found.sizes);
        show("deviation", found.deviation);
    }
    {
        begin("curve_length_with");
        const auto found = n::length(in.curve, 1e-09, {}, watched());
        show("length", found.value);
        show("error", found.error);
    }
    {
        begin("curve_length_with of a part");
        const auto found = n::length(in.curve, 1e-09, {0.3, 0.6}, watched());
        show("length", found.value);
        show("error", found.error);
    }
    {
        begin("curve_lengths_with");
        const auto found = n::lengths(in.loop, {4.0}, 1e-09, watched());
        show("lengths", found);
    }
    {
        begin("curve_params_at_lengths_with");
        const auto found = n::params_at_lengths(in.curve, {4.0}, 1e-09, 0u, watched());
        show("params", found);
    }
    {
        begin("curve_divide_with");
        const auto found = n::divide(in.curve, 5, 1e-09, 0u, {}, watched());
        show("params", found.params);
        show("size", found.size);
    }
    {
        begin("curve_divide_with a part");
        const auto found = n::divide(in.curve, 5, 1e-09, 0u, {0.3, 0.6}, watched());
        show("params", found.params);
        show("size", found.size);
    }
    {
        begin("curve_divide_with chords");
        const auto found = n::divide(in.curve, 5, 1e-09, 33554432u, {}, watched());
        show("params", found.params);
        show("size", found.size);
    }
    {
        begin("surface_area_with");
        const auto found = n::area(in.surface, 1e-09, {}, watched());
        show("area", found.value);
        show("error", found.error);
    }
    {
        begin("surface_area_with of a part");
        const auto found = n::area(in.surface, 1e-09, {0.0, 1.0, 0.0, 3.0}, watched());
        show("area", found.value);
        show("error", found.error);
    }
    {
        begin("moments_with");
        const auto found = n::moments(in.surface, 1e-09, watched());
        show("content", found.content);
        show("centroid", found.centroid);
        show("inertia", found.inertia);
        show("error", found.error);
    }
    {
        begin("enclosed_area_with");
        const auto found = n::enclosed_area(std::vector<n::Spline>{in.loop}, 1e-09, 1e-09, watched());
        show("area", found.area);
        show("centroid", found.centroid);
        show("inertia", found.inertia);
        show("error", found.error);
    }
    {
        begin("enclosed_volume_with");
        const auto found = n::enclosed_volume(std::vector<n::Spline>{in.surface}, 1e-09, watched());
        show("volume", found.volume);
        show("centroid", found.centroid);
        show("inertia", found.inertia);
        show("openness", found.openness);
        show("error", found.error);
    }
    {
        begin("enclosed_volume_with sphere");
        n::Placement at;
        const n::Spline sphere = n::sphere(at, 1.0, 0);
        const auto found = n::enclosed_volume(std::vector<n::Spline>{sphere}, 1e-06, watched());
        show("volume", found.volume);
        show("centroid", found.centroid);
        show("inertia", found.inertia);
        show("openness", found.openness);
        show("error", found.error);
    }
}

void scalar(const Inputs &in) {
    {
        begin("axes");
        const auto found = in.curve.axes();
        show("axes", found);
    }
    {
        begin("dimension");
        const auto found = in.curve.dimension();
        show("dim", found);
    }
    {
        begin("point_count");
        const auto found = in.curve.point_count();
        show("count", found);
    }
    {
        begin("is_rational");
        const auto found = in.curve.is_rational();
        show("rational", found);
    }
    {
        begin("is_homogeneous");
        const auto found = in.curve.is_homogeneous();
        show("homogeneous", found);
    }
    {
        begin("degree");
        const auto found = in.surface.degree(1);
        show("degree", found);
    }
    {
        begin("count");
        const auto found = in.surface.count(1);
        show("count", found);
    }
    {
        begin("knot_form");
        const auto found = in.surface.knot_form(1);
        show("form", found);
    }
    {
        begin("domain");
        const auto found = in.surface.domain(1);
        show("domain", found);
    }
    {
        begin("derivative_slots");
        const auto found = n::derivative_slots(3, 9);
        show("slots", found);
    }
    {
        begin("unwrapped_count");
        const auto found = in.loop.unwrapped_count(0);
        show("count", found);
    }
    {
        begin("list_count");
        const auto found = in.list.size();
        show("count", found);
    }
    {
        begin("list_note_count");
        const auto found = in.list.note_count();
        show("count", found);
    }
    {
        begin("list_unit");
        const auto found = in.list.unit();
        show("metres", found);
    }
    {
        begin("list_name");
        const auto found = in.list.name(0);
        show("buf", found);
    }
    {
        begin("list_note");
        const auto found = in.list.note(0);
        show("entity_type", found.entity_type);
        show("line", found.line);
        show("reason", found.reason);
        show("buf", found.text);
    }
    {
        begin("model_counts");
        const auto found = in.model.counts();
        show("parts", found.parts);
        show("uses", found.uses);
        show("faces", found.faces);
        show("edges", found.edges);
        show("vertices", found.vertices);
    }
    {
        begin("meet_counts");
        const auto found = in.meet.counts();
        show("branches", found.branches);
        show("nodes", found.nodes);
        show("complete", found.complete);
    }
    {
        begin("mesh_counts");
        const auto found = in.mesh.counts();
        show("points", found.points);
        show("vertices", found.vertices);
        show("triangles", found.triangles);
        show("faces", found.faces);
        show("edges", found.edges);
        show("edge_points", found.edge_points);
    }
    {
        begin("mesh_bound");
        const auto found = in.mesh.bound();
        show("from_shape", found.from_shape);
        show("from_mesh", found.from_mesh);
        show("reached", found.reached);
    }
    {
        begin("model_face_name");
        const auto found = in.model.face_name(1);
        show("buf", found);
    }
    {
        begin("model_face_solid");
        const auto found = in.model.face_solid(1);
        show("solid", found.solid);
        show("in_void", found.in_void);
    }
    {
        begin("model_face_layers");
        const auto found = in.layered.face_layers(0);
        show("layers", found);
    }
    {
        begin("model_spline_layers");
        const auto found = in.layered.spline_layers(0);
        show("layers", found);
    }
    {
        begin("model_layer_count");
        const auto found = in.layered.layer_count();
        show("count", found);
    }
    {
        begin("model_layer");
        const auto found = in.layered.layer(0);
        show("buf", found);
    }
    {
        begin("model_edge_uses");
        const auto found = in.model.edge_uses(1);
        show("places", found);
    }
    {
        begin("model_vertex");
        const auto found = in.model.vertex(0);
        show("point", found);
    }
    {
        begin("model_part");
        const auto found = in.model.part(0);
        show("buf", found);
    }
    {
        begin("model_use");
        const auto found = in.model.use(0);
        show("parent", found.parent);
        show("part", found.part);
        show("placement", found.placement);
    }
    by_hand("read_options_init");
    by_hand("call_options_init");
    by_hand("version");
    by_hand("status_name");
    by_hand("last_error");
}

void shape(const Inputs &in) {
    {
        begin("curve_line");
        const auto found = n::line({0.1, 0.9}, {0.3, 0.7});
        show("out", found);
    }
    {
        begin("curve_polyline");
        const auto found = n::polyline(2, {0.1, 0.9, 0.3, 0.7, 0.2, 0.6});
        show("out", found);
    }
    {
        begin("curve_polyline with params");
        const auto found = n::polyline(3, {0.1, 0.9, 0.3, 0.7, 0.2, 0.6}, {0.3, 0.6});
        show("out", found);
    }
    {
        begin("curve_polygon");
        n::Placement at;
        const auto found = n::polygon(at, 1.0, 5);
        show("out", found);
    }
    {
        begin("curve_polygon placed");
        n::Placement at;
        at.origin = {1.0, 2.0, 3.0};
        at.axis = {0.0, 1.0, 0.0};
        at.x = {1.0, 0.0, 0.0};
        const auto found = n::polygon(at, 1.0, 5);
        show("out", found);
    }
    {
        begin("curve_rounded_rectangle");
        n::Placement at;
        const auto found = n::rounded_rectangle(at, 3.0, 2.0, 0.5);
        show("out", found);
    }
    {
        begin("curve_circle");
        n::Placement at;
        const auto found = n::circle(at, 1.0, 2);
        show("out", found);
    }
    {
        begin("curve_circle placed");
        n::Placement at;
        at.origin = {1.0, 2.0, 3.0};
        at.axis = {0.0, 1.0, 0.0};
        at.x = {1.0, 0.0, 0.0};
        const auto found = n::circle(at, 1.0, 2);
        show("out", found);
    }
    {
        begin("curve_arc");
        n::Placement at;
        const auto found = n::arc(at, 1.0, 0.0, 4.0, 0);
        show("out", found);
    }
    {
        begin("curve_arc_through");
        const auto found = n::arc_through({0.1, 0.9}, {0.3, 0.7}, {0.2, 0.6}, 0);
        show("out", found);
    }
    {
        begin("curve_arc_tangent");
        const auto found = n::arc_tangent({0.0, 0.0}, {0.0, 1.0}, {1.0, 1.0}, 0);
        show("out", found);
    }
    {
        begin("curve_ellipse");
        n::Placement at;
        const auto found = n::ellipse(at, 2.0, 1.0, 0.0, 4.0, 2);
        show("out", found);
    }
    {
        begin("curve_parabola");
        n::Placement at;
        const auto found = n::parabola(at, 1.0, -1.0, 2.0);
        show("out", found);
    }
    {
        begin("curve_parabola placed");
        n::Placement at;
        at.origin = {1.0, 2.0, 3.0};
        at.axis = {0.0, 1.0, 0.0};
        at.x = {1.0, 0.0, 0.0};
        const auto found = n::parabola(at, 1.0, -1.0, 2.0);
        show("out", found);
    }
    {
        begin("curve_hyperbola");
        n::Placement at;
        const auto found = n::hyperbola(at, 1.0, 1.0, 0.0, 9.0);
        show("out", found);
    }
    {
        begin("curve_hyperbola placed");
        n::Placement at;
        at.origin = {1.0, 2.0, 3.0};
        at.axis = {0.0, 1.0, 0.0};
        at.x = {1.0, 0.0, 0.0};
        const auto found = n::hyperbola(at, 1.0, 1.0, 0.0, 9.0);
        show("out", found);
    }
    {
        begin("curve_conic_triangle");
        const auto found = n::conic_triangle({0.1, 0.9}, {0.3, 0.7}, {0.2, 0.6}, 0.4);
        show("out", found);
    }
    {
        begin("curve_conic_shoulder");
        const auto found = n::conic_shoulder({0.0, 0.0}, {1.0, 1.0}, {1.0, 0.0}, {1.0, -1.0}, 0.4);
        show("out", found);
    }
    {
        begin("curve_conic_through");
        const auto found = n::conic_through(2, {-2.0, 4.0, -1.0, 1.0, 0.0, 0.0, 1.0, 1.0, 2.0, 4.0}, 0);
        show("out", found);
    }
    {
        begin("curve_conic_implicit");
        const auto found = n::conic_implicit(std::array<double, 6>{1.0, 0.0, 4.0, 0.0, 0.0, -4.0}, 0.0, 3.0, 0);
        show("out", found);
    }
    {
        begin("curve_helix");
        n::Placement at;
        n::HelixShape shape;
        shape.radius = 1.0;
        shape.growth = 1.0;
        shape.pitch = 1.0;
        shape.start = 0.0;
        shape.turns = 1.0;
        const auto found = n::helix(at, shape, 0.1);
        show("out", found.spline);
        show("error", found.error);
    }
    {
        begin("extrude");
        const auto found = n::extrude(in.twist, {0.0, 0.0, 1.0});
        show("out", found);
    }
    {
        begin("revolve");
        const auto found = n::revolve(in.twist, 6.0, {}, {}, 0);
        show("out", found);
    }
    {
        begin("revolve about an axis");
        const auto found = n::revolve(in.twist, 6.0, {1.0, 2.0, 3.0}, {0.0, 1.0, 0.0}, 0);
        show("out", found);
    }
    {
        begin("ruled");
        const auto found = n::ruled(in.curve, in.loop, 0u);
        show("out", found);
    }
    {
        begin("ruled Cartesian");
        const auto found = n::ruled(in.curve, in.loop, 2147483648u);
        show("out", found);
    }
    {
        begin("tensor_sum");
        const auto found = n::tensor_sum(in.curve, 1.0, in.loop, 2.0);
        show("out", found);
    }
    {
        begin("tensor_sum homogeneous");
        const auto found = n::tensor_sum(in.homogeneous, 1.0, in.loop, 2.0);
        show("out", found);
    }
    {
        begin("tensor_product");
        const auto found = n::tensor_product(in.twist, in.surface);
        show("out", found);
    }
    {
        begin("surface_swung");
        const auto found = n::swung(in.curve, in.loop, 1.0);
        show("out", found);
    }
    {
        begin("surface_coons");
        const n::List edges = n::boundaries(in.surface);
        const auto found = n::coons(std::array<n::Spline, 4>{edges[0], edges[1], edges[2], edges[3]}, 0.0);
        show("out", found);
    }
    {
        begin("surface_coons_hermite");
        const n::List edges = n::boundaries(in.surface);
        const auto found = n::coons_hermite(std::array<n::Spline, 4>{edges[0], edges[1], edges[2], edges[3]}, {}, 5, 0.0);
        show("out", found.spline);
        show("bound", found.bound);
    }
    {
        begin("volume_coons");
        const n::List faces = n::boundaries(in.volume);
        const auto found = n::coons_volume(std::array<n::Spline, 6>{faces[0], faces[1], faces[2], faces[3], faces[4], faces[5]}, 0.0);
        show("out", found);
    }
    {
        begin("surface_plane");
        const auto found = n::plane({0.3, 0.6}, {0.1, 0.9});
        show("out", found);
    }
    {
        begin("surface_plane placed");
        const auto found = n::plane({0.0, 1.0, 0.0}, {1.0, 0.0, 0.0}, {1.0, 2.0, 3.0});
        show("out", found);
    }
    {
        begin("surface_bilinear");
        const auto found = n::bilinear(1, {0.1, 0.9, 0.3, 0.7});
        show("out", found);
    }
    {
        begin("volume_trilinear");
        const auto found = n::trilinear(1, {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0});
        show("out", found);
    }
    {
        begin("surface_sphere");
        n::Placement at;
        at.axis = {0.1, 0.9, 0.3};
        const auto found = n::sphere(at, 1.0, 2);
        show("out", found);
    }
    {
        begin("surface_sphere placed");
        n::Placement at;
        at.origin = {1.0, 2.0, 3.0};
        at.axis = {0.0, 1.0, 0.0};
        at.x = {1.0, 0.0, 0.0};
        const auto found = n::sphere(at, 1.0, 2);
        show("out", found);
    }
    {
        begin("surface_spherical_patch");
        n::Placement at;
        const auto found = n::spherical_patch(at, 1.0, 0.0, 4.0, 0.0, 1.0, 0);
        show("out", found);
    }
    {
        begin("surface_sphere_patches");
        n::Placement at;
        const auto found = n::sphere_patches(at, 1.0, 16777216u);
        show("out", found);
    }
    {
        begin("surface_sphere_patches placed");
        n::Placement at;
        at.origin = {1.0, 2.0, 3.0};
        at.axis = {0.0, 1.0, 0.0};
        at.x = {1.0, 0.0, 0.0};
        const auto found = n::sphere_patches(at, 1.0, 16777216u);
        show("out", found);
    }
    {
        begin("surface_ellipsoid");
        n::Placement at;
        const auto found = n::ellipsoid(at, {1.0, 2.0, 3.0}, 1);
        show("out", found);
    }
    {
        begin("surface_cylinder");
        n::Placement at;
        const auto found = n::cylinder(at, 1.0, 2.0, 0.0, 3.0, 0);
        show("out", found);
    }
    {
        begin("surface_cone");
        n::Placement at;
        const auto found = n::cone(at, 1.0, 0.0, 2.0, 0.0, 3.0, 0);
        show("out", found);
    }
    {
        begin("surface_paraboloid");
        n::Placement at;
        const auto found = n::paraboloid(at, {3.0, 1.0}, 1.0, 0.0, 3.0, 0);
        show("out", found);
    }
    {
        begin("surface_saddle");
        n::Placement at;
        const auto found = n::saddle(at, {3.0, 1.0}, 1.0);
        show("out", found);
    }
    {
        begin("surface_saddle placed");
        n::Placement at;
        at.origin = {1.0, 2.0, 3.0};
        at.axis = {0.0, 1.0, 0.0};
        at.x = {1.0, 0.0, 0.0};
        const auto found = n::saddle(at, {3.0, 1.0}, 1.0);
        show("out", found);
    }
    {
        begin("curve_rounded_rectangle placed");
        n::Placement at;
        at.origin = {1.0, 2.0, 3.0};
        at.axis = {0.0, 1.0, 0.0};
        at.x = {1.0, 0.0, 0.0};
        const auto found = n::rounded_rectangle(at, 3.0, 2.0, 0.5);
        show("out", found);
    }
    {
        begin("curve_arc placed");
        n::Placement at;
        at.origin = {1.0, 2.0, 3.0};
        at.axis = {0.0, 1.0, 0.0};
        at.x = {1.0, 0.0, 0.0};
        const auto found = n::arc(at, 1.0, 0.0, 4.0, 0);
        show("out", found);
    }
    {
        begin("curve_ellipse placed");
        n::Placement at;
        at.origin = {1.0, 2.0, 3.0};
        at.axis = {0.0, 1.0, 0.0};
        at.x = {1.0, 0.0, 0.0};
        const auto found = n::ellipse(at, 2.0, 1.0, 0.0, 4.0, 0);
        show("out", found);
    }
    {
        begin("curve_conic_point");
        const auto found = n::conic_point({0.0, 0.0}, {1.0, 1.0}, {1.0, 0.0}, {1.0, -1.0}, {0.5, 0.25}, 0);
        show("out", found);
    }
    {
        begin("curve_conic_focus");
        const auto found = n::conic_focus({0.0, 0.0}, {1.0, 0.0}, 0.5, 0.0, 6.0, 0);
        show("out", found);
    }
    {
        begin("curve_conic_focus in space");
        const auto found = n::conic_focus({1.0, 2.0, 3.0}, {2.0, 2.0, 3.0}, 0.5, 0.0, 6.0, 0, {0.0, 1.0, 0.0});
        show("out", found);
    }
    {
        begin("curve_helix placed");
        n::Placement at;
        at.origin = {1.0, 2.0, 3.0};
        at.axis = {0.0, 1.0, 0.0};
        at.x = {1.0, 0.0, 0.0};
        n::HelixShape shape;
        shape.radius = 1.0;
        shape.growth = 1.0;
        shape.pitch = 1.0;
        shape.start = 0.0;
        shape.turns = 1.0;
        const auto found = n::helix(at, shape, 0.1);
        show("out", found.spline);
        show("error", found.error);
    }
    {
        begin("surface_coons_hermite with twists");
        const auto found = n::coons_hermite(std::array<n::Spline, 4>{in.twist, in.twist, in.twist, in.twist}, std::array<n::Spline, 4>{in.twist, in.twist, in.twist, in.twist}, 2, 99.0, {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0});
        show("out", found.spline);
        show("bound", found.bound);
    }
    {
        begin("surface_spherical_patch placed");
        n::Placement at;
        at.origin = {1.0, 2.0, 3.0};
        at.axis = {0.0, 1.0, 0.0};
        at.x = {1.0, 0.0, 0.0};
        const auto found = n::spherical_patch(at, 1.0, 0.0, 4.0, 0.0, 1.0, 0);
        show("out", found);
    }
    {
        begin("surface_ellipsoid placed");
        n::Placement at;
        at.origin = {1.0, 2.0, 3.0};
        at.axis = {0.0, 1.0, 0.0};
        at.x = {1.0, 0.0, 0.0};
        const auto found = n::ellipsoid(at, {1.0, 2.0, 3.0}, 1);
        show("out", found);
    }
    {
        begin("surface_cylinder placed");
        n::Placement at;
        at.origin = {1.0, 2.0, 3.0};
        at.axis = {0.0, 1.0, 0.0};
        at.x = {1.0, 0.0, 0.0};
        const auto found = n::cylinder(at, 1.0, 2.0, 0.0, 3.0, 0);
        show("out", found);
    }
    {
        begin("surface_cone placed");
        n::Placement at;
        at.origin = {1.0, 2.0, 3.0};
        at.axis = {0.0, 1.0, 0.0};
        at.x = {1.0, 0.0, 0.0};
        const auto found = n::cone(at, 1.0, 0.0, 2.0, 0.0, 3.0, 0);
        show("out", found);
    }
    {
        begin("surface_torus");
        n::Placement at;
        const auto found = n::torus(at, 3.0, 1.0, 0.0, 3.0, 0.0, 6.0, 2);
        show("out", found);
    }
    {
        begin("surface_torus placed");
        n::Placement at;
        at.origin = {1.0, 2.0, 3.0};
        at.axis = {0.0, 1.0, 0.0};
        at.x = {1.0, 0.0, 0.0};
        const auto found = n::torus(at, 3.0, 1.0, 0.0, 3.0, 0.0, 6.0, 2);
        show("out", found);
    }
    {
        begin("surface_paraboloid placed");
        n::Placement at;
        at.origin = {1.0, 2.0, 3.0};
        at.axis = {0.0, 1.0, 0.0};
        at.x = {1.0, 0.0, 0.0};
        const auto found = n::paraboloid(at, {3.0, 1.0}, 1.0, 0.0, 3.0, 0);
        show("out", found);
    }
    {
        begin("surface_hyperboloid");
        n::Placement at;
        const auto found = n::hyperboloid(at, {3.0, 1.0, 1.0}, -9.0, 9.0, 0.0, 3.0, 0, 0u);
        show("out", found);
    }
    {
        begin("surface_hyperboloid placed");
        n::Placement at;
        at.origin = {1.0, 2.0, 3.0};
        at.axis = {0.0, 1.0, 0.0};
        at.x = {1.0, 0.0, 0.0};
        const auto found = n::hyperboloid(at, {3.0, 1.0, 1.0}, -9.0, 9.0, 0.0, 3.0, 0, 0u);
        show("out", found);
    }
}

} // namespace

int main() {
    const Inputs in;
    data(in);
    edit(in);
    evaluation(in);
    form(in);
    query(in);
    scalar(in);
    shape(in);
    return 0;
}
