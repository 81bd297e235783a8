// SPDX-License-Identifier: MIT
// Generated from tests/capi/calls/*.toml, include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
//! Every good call, see smoke_reference.cpp.

#[path = "../smoke_support.rs"]
mod smoke_support;

use nurbs::{Call, Face, List, Meet, Mesh, Model, Spline, Statistics};
use smoke_support::{begin, by_hand, show, written};

const FILE: &str = r#"a file of the test programs                                             S      1
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
"#;

const SOLID: &str = r#"ISO-10303-21;
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
"#;

const LAYERS: &str = r#"ISO-10303-21;
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
"#;

const REPLACED: &str = r#"an older file
"#;

const NO_DATA: &[u8] = &[
    137, 78, 85, 82, 13, 10, 26, 10, 1, 0, 0, 0, 3, 0, 0, 0, 192, 0, 0, 0, 0, 0, 0, 0, 114, 160,
    102, 241, 94, 129, 142, 24, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 7, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0,
    0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 240, 63, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
];

const LOOP_BYTES: &[u8] = &[
    137, 78, 85, 82, 13, 10, 26, 10, 1, 0, 0, 0, 1, 0, 0, 0, 96, 1, 0, 0, 0, 0, 0, 0, 97, 220, 175,
    73, 171, 169, 167, 134, 1, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 6, 0, 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 240, 63, 0, 0, 0, 0, 0, 0, 0,
    64, 0, 0, 0, 0, 0, 0, 8, 64, 0, 0, 0, 0, 0, 0, 16, 64, 0, 0, 0, 0, 0, 0, 20, 64, 0, 0, 0, 0, 0,
    0, 24, 64, 0, 0, 0, 0, 0, 0, 28, 64, 0, 0, 0, 0, 0, 0, 32, 64, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 240, 63, 0, 0, 0, 0, 0, 0, 240, 63, 0,
    0, 0, 0, 0, 0, 240, 191, 0, 0, 0, 0, 0, 0, 240, 63, 0, 0, 0, 0, 0, 0, 240, 191, 0, 0, 0, 0, 0,
    0, 240, 191, 0, 0, 0, 0, 0, 0, 240, 63, 0, 0, 0, 0, 0, 0, 240, 191, 0, 0, 0, 0, 0, 0, 240, 63,
    0, 0, 0, 0, 0, 0, 240, 63, 0, 0, 0, 0, 0, 0, 240, 191, 0, 0, 0, 0, 0, 0, 240, 63,
];

const LIST_BYTES: &[u8] = &[
    137, 78, 85, 82, 13, 10, 26, 10, 1, 0, 0, 0, 2, 0, 0, 0, 128, 2, 0, 0, 0, 0, 0, 0, 115, 101,
    65, 29, 65, 41, 203, 126, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 2, 0, 0, 0, 0, 0, 0, 0, 252, 169, 241, 210, 77, 98, 80, 63, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 97, 98, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 128, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 137, 78, 85, 82, 13, 10, 26, 10, 1, 0, 0, 0, 1, 0,
    0, 0, 200, 0, 0, 0, 0, 0, 0, 0, 235, 190, 19, 224, 60, 109, 135, 43, 1, 0, 0, 0, 1, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 192, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 240, 63, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    20, 64, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
];

const FACE_BYTES: &[u8] = &[
    137, 78, 85, 82, 13, 10, 26, 10, 1, 0, 0, 0, 4, 0, 0, 0, 192, 3, 0, 0, 0, 0, 0, 0, 56, 218, 45,
    130, 130, 9, 70, 207, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 255, 255, 255, 255, 255, 255, 255, 255, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 128, 1, 0, 0, 0, 0, 0, 0, 192, 2, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 137, 78, 85, 82, 13, 10, 26, 10, 1, 0, 0, 0, 1,
    0, 0, 0, 32, 1, 0, 0, 0, 0, 0, 0, 169, 227, 47, 52, 97, 141, 100, 180, 2, 0, 0, 0, 3, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0,
    1, 0, 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 192, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 240, 63, 0, 0, 0, 0, 0, 0, 240, 63, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 240, 63, 0, 0, 0, 0, 0, 0, 240, 63, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 8, 64, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 64, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 64, 0, 0, 0, 0, 0, 0, 8, 64, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    137, 78, 85, 82, 13, 10, 26, 10, 1, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 236, 145, 236,
    61, 80, 26, 21, 238, 1, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 4, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 192, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 240,
    63, 0, 0, 0, 0, 0, 0, 0, 64, 0, 0, 0, 0, 0, 0, 8, 64, 0, 0, 0, 0, 0, 0, 8, 64, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 240, 63, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 240, 63, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
];

const MODEL_BYTES: &[u8] = &[
    137, 78, 85, 82, 13, 10, 26, 10, 1, 0, 0, 0, 5, 0, 0, 0, 64, 8, 0, 0, 0, 0, 0, 0, 7, 61, 156,
    237, 55, 224, 208, 143, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0,
    1, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0,
    1, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 3, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 252, 169, 241, 210, 77, 98, 80, 63, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 255, 255, 255, 255, 255, 255, 255, 255, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 240, 63, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 240, 63, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 240, 63, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 255, 255, 255, 255, 255, 255,
    255, 255, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 255, 255, 255, 255, 255, 255, 255, 255, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 255, 255, 255, 255, 255, 255, 255, 255, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 255, 255, 255, 255, 255, 255, 255, 255, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 48, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 64, 4, 0, 0, 0, 0, 0, 0, 128, 5, 0, 0, 0, 0, 0, 0,
    128, 6, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 137, 78, 85, 82, 13, 10, 26, 10, 1, 0, 0, 0,
    1, 0, 0, 0, 32, 1, 0, 0, 0, 0, 0, 0, 169, 227, 47, 52, 97, 141, 100, 180, 2, 0, 0, 0, 3, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0,
    0, 1, 0, 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 192, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 240, 63, 0, 0, 0, 0, 0, 0, 240, 63, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 240, 63, 0, 0, 0, 0, 0, 0, 240, 63, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 8, 64, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 64, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 64, 0, 0, 0, 0, 0, 0, 8, 64, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    137, 78, 85, 82, 13, 10, 26, 10, 1, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 236, 145, 236,
    61, 80, 26, 21, 238, 1, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 4, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 192, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 240,
    63, 0, 0, 0, 0, 0, 0, 0, 64, 0, 0, 0, 0, 0, 0, 8, 64, 0, 0, 0, 0, 0, 0, 8, 64, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 240, 63, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 240, 63, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 137, 78, 85, 82, 13, 10, 26, 10, 1, 0, 0, 0, 1, 0, 0, 0,
    168, 1, 0, 0, 0, 0, 0, 0, 150, 234, 15, 242, 87, 183, 219, 255, 1, 0, 0, 0, 3, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 7, 0, 0, 0, 0, 0, 0, 0, 2, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 240, 63, 0, 0, 0, 0, 0, 0, 240, 63,
    0, 0, 0, 0, 0, 0, 0, 64, 0, 0, 0, 0, 0, 0, 0, 64, 0, 0, 0, 0, 0, 0, 8, 64, 0, 0, 0, 0, 0, 0, 8,
    64, 0, 0, 0, 0, 0, 0, 8, 64, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 240, 63, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 64, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 240, 63, 0, 0, 0, 0, 0, 0, 248, 63, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 8, 64, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 248, 63, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
];

struct Given {
    curve: Spline,
    r#loop: Spline,
    surface: Spline,
    volume: Spline,
    solid: Spline,
    homogeneous: Spline,
    twist: Spline,
    segment: Spline,
    list: List,
    no_statistics: Statistics,
    statistics: Statistics,
    outline: Spline,
    face: Face,
    model: Model,
    layered: Model,
    meet: Meet,
    mesh: Mesh,
    block: Mesh,
}

fn given() -> nurbs::Result<Given> {
    let curve = Spline::create(
        &[2],
        &[9],
        &[
            0.0, 0.0, 0.0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1.0, 1.0, 1.0,
        ],
        2,
        &[
            1.0, 0.0, 1.0, 1.0, 0.0, 1.0, -1.0, 1.0, -1.0, 0.0, -1.0, -1.0, 0.0, -1.0, 1.0, -1.0,
            1.0, 0.0,
        ],
        Some(&[
            1.0,
            0.7071067811865476,
            1.0,
            0.7071067811865476,
            1.0,
            0.7071067811865476,
            1.0,
            0.7071067811865476,
            1.0,
        ]),
        0,
    )?;
    let r#loop = Spline::create(
        &[2],
        &[6],
        &[0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0],
        2,
        &[
            1.0, 1.0, -1.0, 1.0, -1.0, -1.0, 1.0, -1.0, 1.0, 1.0, -1.0, 1.0,
        ],
        None,
        1,
    )?;
    let surface = Spline::create(
        &[2, 1],
        &[3, 4],
        &[0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 0.0, 0.0, 1.0, 2.0, 3.0, 3.0],
        3,
        &[
            0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 2.0, 2.0, 0.0, 3.0, 3.0, 0.5, 0.0, 0.0, 0.5, 1.0,
            1.0, 0.5, 2.0, 2.0, 0.5, 3.0, 3.0, 1.0, 0.0, 1.0, 1.0, 1.0, 2.0, 1.0, 2.0, 3.0, 1.0,
            3.0, 4.0,
        ],
        None,
        0,
    )?;
    let volume = Spline::create(
        &[1, 1, 1],
        &[2, 2, 2],
        &[0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 1.0],
        4,
        &[
            0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 1.0,
            0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0,
        ],
        None,
        0,
    )?;
    let solid = Spline::create(
        &[1, 2, 1],
        &[3, 3, 2],
        &[
            0.0, 0.0, 0.5, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 0.0, 0.0, 1.0, 1.0,
        ],
        3,
        &[
            0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.5, 0.0, 0.0, 0.5, 1.0, 0.25, 1.0, 0.0, 0.25, 1.0,
            1.0, 0.5, 0.0, 0.0, 0.5, 0.0, 1.0, 0.5, 0.5, 0.0, 0.5, 0.5, 1.0, 0.75, 1.0, 0.0, 0.75,
            1.0, 1.0, 1.0, 0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.5, 0.0, 1.0, 0.5, 1.0, 1.25, 1.0, 0.0,
            1.25, 1.0, 1.0,
        ],
        None,
        0,
    )?;
    let homogeneous = Spline::create_homogeneous(
        &[2],
        &[3],
        &[0.0, 0.0, 0.0, 1.0, 1.0, 1.0],
        2,
        &[1.0, 0.0, 1.0, 0.0, 1.0, 0.0, -1.0, 0.0, 1.0],
        0,
    )?;
    let twist = Spline::create(
        &[3],
        &[4],
        &[0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0],
        3,
        &[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 2.0, 1.0, 0.0, 3.0, 3.0, 3.0],
        None,
        0,
    )?;
    let segment = Spline::create(
        &[2],
        &[3],
        &[0.0, 1.0, 2.0, 3.0, 4.0, 5.0],
        2,
        &[0.0, 0.0, 1.0, 1.0, 2.0, 0.0],
        Some(&[1.0, 3.0, 5.0]),
        0,
    )?;
    let list = List::read(FILE.as_bytes(), None)?;
    let no_statistics = Statistics::create(&[2], &[3], &[0.0, 0.5, 1.0], 1, 4.0, 1.0)?;
    let statistics = no_statistics.add(&nurbs::Data::new(
        1,
        1,
        &[0.0, 0.25, 0.5, 0.75, 1.0],
        &[0.0, 1.0, 2.0, 1.0, 0.0],
    )?)?;
    let outline = Spline::create(
        &[1],
        &[4],
        &[0.0, 0.0, 1.0, 2.0, 3.0, 3.0],
        2,
        &[0.25, 1.0, 0.75, 1.0, 0.5, 2.0, 0.25, 1.0],
        None,
        0,
    )?;
    let face = Face::create(&surface, &[1], &[Some(&outline)], &[], &[], 0.001, 0)?;
    let model = Model::create(&[&face, &face], 0.001)?;
    let layered = Model::read(LAYERS.as_bytes(), None)?;
    let meet = Meet::sections(&surface, &[0.0, 0.0, 1.0], &[0.5, 2.0], 0.001)?;
    let mesh = Mesh::of_face(
        &face,
        Some(&nurbs::MeshOptions::new()?.chord(1.0).relative_chord(0.0)),
    )?;
    let block = Mesh::of_volume(
        &solid,
        Some(&nurbs::MeshOptions::new()?.chord(0.1).relative_chord(0.0)),
        100,
    )?;
    Ok(Given {
        curve,
        r#loop,
        surface,
        volume,
        solid,
        homogeneous,
        twist,
        segment,
        list,
        no_statistics,
        statistics,
        outline,
        face,
        model,
        layered,
        meet,
        mesh,
        block,
    })
}

fn data(given: &Given) -> nurbs::Result<()> {
    begin("clone");
    {
        let found = given.curve.try_clone()?;
        show("out", &found);
    }
    by_hand("destroy");
    begin("with_points");
    {
        let found = given.curve.with_points(
            &[
                1.0, 0.0, 1.0, 1.0, 0.0, 1.0, -1.0, 1.0, -1.0, 0.0, -1.0, -1.0, 0.0, -1.0, 1.0,
                -1.0, 1.0, 0.0,
            ],
            None,
        )?;
        show("out", &found);
    }
    begin("with_points rational");
    {
        let found = given.curve.with_points(
            &[
                1.0, 0.0, 1.0, 1.0, 0.0, 1.0, -1.0, 1.0, -1.0, 0.0, -1.0, -1.0, 0.0, -1.0, 1.0,
                -1.0, 1.0, 0.0,
            ],
            Some(&[
                1.0,
                0.7071067811865476,
                1.0,
                0.7071067811865476,
                1.0,
                0.7071067811865476,
                1.0,
                0.7071067811865476,
                1.0,
            ]),
        )?;
        show("out", &found);
    }
    begin("create_bezier");
    {
        let found = Spline::bezier(&[3], 2, &[0.0, 0.0, 1.0, 2.0, 3.0, 2.0, 4.0, 0.0], None)?;
        show("out", &found);
    }
    begin("create_hermite");
    {
        let found = Spline::hermite(&[0.3, 0.6], 2, &[0.1, 0.9, 0.3, 0.7], &[0.1, 0.9, 0.3, 0.7])?;
        show("out", &found);
    }
    begin("parametrize");
    {
        let found = nurbs::parametrize(
            &[4],
            2,
            &[0.0, 0.0, 1.0, 2.0, 3.0, 2.0, 4.0, 0.0],
            4,
            0.0,
            0,
        )?;
        show("params", &found);
    }
    begin("params_universal");
    {
        let found = nurbs::params_universal(3, 7)?;
        show("params", &found);
    }
    begin("tangents");
    {
        let found = nurbs::tangents(2, &[0.0, 1.0, 3.0, 4.0], 1, &[0.0, 1.0, 2.0, 4.0], 0)?;
        show("tangents", &found);
    }
    begin("tangents monotone");
    {
        let found = nurbs::tangents(3, &[0.0, 1.0, 3.0, 4.0], 1, &[0.0, 1.0, 2.0, 0.0], 1)?;
        show("tangents", &found);
    }
    begin("parametrize surface");
    {
        let found = nurbs::parametrize(
            &[2, 2],
            2,
            &[0.0, 0.0, 1.0, 2.0, 3.0, 2.0, 4.0, 0.0],
            1,
            0.0,
            0,
        )?;
        show("params", &found);
    }
    begin("read");
    {
        let found = List::read(FILE.as_bytes(), None)?;
        show("out", &found);
    }
    begin("read in millimetres");
    {
        let found = List::read(
            FILE.as_bytes(),
            Some(&nurbs::ReadOptions::new()?.unit(0.001)),
        )?;
        show("out", &found);
    }
    begin("read_file");
    {
        let found = List::read_file(written("smoke_calls_rust.file", FILE), None)?;
        show("out", &found);
    }
    begin("read_file in millimetres");
    {
        let found = List::read_file(
            written("smoke_calls_rust.file", FILE),
            Some(&nurbs::ReadOptions::new()?.unit(0.001)),
        )?;
        show("out", &found);
    }
    begin("list_get");
    {
        let found = given.list.get(0)?;
        show("out", &found);
    }
    by_hand("list_destroy");
    begin("knots_uniform");
    {
        let found = nurbs::knots_uniform(2, 5, 0.0, 1.0)?;
        show("knots", &found);
    }
    begin("knots_open_uniform");
    {
        let found = nurbs::knots_open_uniform(2, 5, 0.0, 1.0)?;
        show("knots", &found);
    }
    begin("knots_bezier");
    {
        let found = nurbs::knots_bezier(2, 2)?;
        show("knots", &found);
    }
    begin("knots_bezier with breaks");
    {
        let found = nurbs::knots_bezier_breaks(2, &[0.3, 0.6])?;
        show("knots", &found);
    }
    begin("knots_averaged");
    {
        let found = nurbs::knots_averaged(2, &[0.0, 1.0, 2.0, 3.0, 4.0])?;
        show("knots", &found);
    }
    begin("knots_periodic");
    {
        let found = nurbs::knots_periodic(2, &[0.0, 1.0, 2.0, 3.0], None)?;
        show("knots", &found);
    }
    begin("knots_periodic twice");
    {
        let found = nurbs::knots_periodic(2, &[0.3, 0.6], Some(&[2, 2]))?;
        show("knots", &found);
    }
    begin("knots");
    {
        let found = given.curve.knots(0)?;
        show("knots", &found);
    }
    begin("short_knots");
    {
        let found = given.curve.short_knots(0)?;
        show("knots", &found);
    }
    begin("unwrapped_knots");
    {
        let found = given.r#loop.unwrapped_knots(0)?;
        show("knots", &found);
    }
    begin("unwrapped_points");
    {
        let found = given.r#loop.unwrapped_points()?;
        show("points", &found.points);
        show("weights", &found.weights);
    }
    by_hand("to_bytes");
    begin("from_bytes");
    {
        let found = Spline::from_bytes(LOOP_BYTES)?;
        show("out", &found);
    }
    begin("bytes_kind");
    {
        let found = nurbs::bytes_kind(LOOP_BYTES)?;
        show("kind", &found.kind);
        show("major", &found.major);
        show("minor", &found.minor);
    }
    by_hand("list_to_bytes");
    begin("list_from_bytes");
    {
        let found = List::from_bytes(LIST_BYTES)?;
        show("out", &found);
    }
    by_hand("face_to_bytes");
    begin("face_from_bytes");
    {
        let found = Face::from_bytes(FACE_BYTES)?;
        show("out", &found);
    }
    by_hand("model_to_bytes");
    begin("model_from_bytes");
    {
        let found = Model::from_bytes(MODEL_BYTES)?;
        show("out", &found);
    }
    begin("list_create");
    {
        let found = List::create(&[&given.curve, &given.r#loop, &given.curve], &[], 0.001)?;
        show("out", &found);
    }
    begin("distinct_knots");
    {
        let found = given.curve.distinct_knots(0)?;
        show("knots", &found.knots);
        show("multiplicities", &found.multiplicities);
    }
    begin("greville");
    {
        let found = given.curve.greville(0)?;
        show("abscissae", &found);
    }
    begin("points");
    {
        let found = given.homogeneous.points()?;
        show("points", &found);
    }
    begin("weights");
    {
        let found = given.curve.weights()?;
        show("weights", &found);
    }
    begin("homogeneous_points");
    {
        let found = given.curve.homogeneous_points()?;
        show("points", &found);
    }
    begin("detect_periodic");
    {
        let found = given.curve.detect_periodic(0)?;
        show("periodic", &found);
    }
    begin("eval_knot_derivative");
    {
        let found = given.curve.knot_derivative(0, 4)?;
        show("out", &found);
    }
    begin("eval_knot_derivative of a period");
    {
        let found = given.r#loop.knot_derivative(0, 1)?;
        show("out", &found);
    }
    begin("to_hermite");
    {
        let found = given.twist.to_hermite()?;
        show("params", &found.params);
        show("points", &found.points);
        show("tangents", &found.tangents);
    }
    begin("to_power");
    {
        let found = given.curve.to_power()?;
        show("coefficients", &found.coefficients);
        show("breaks", &found.breaks);
        show("piece_counts", &found.piece_counts);
    }
    begin("to_power surface");
    {
        let found = given.surface.to_power()?;
        show("coefficients", &found.coefficients);
        show("breaks", &found.breaks);
        show("piece_counts", &found.piece_counts);
    }
    begin("bezier_extraction");
    {
        let found = given.curve.bezier_extraction(0)?;
        show("operators", &found.operators);
        show("firsts", &found.firsts);
        show("domains", &found.domains);
    }
    begin("refinement_matrix");
    {
        let found = given.curve.refinement_matrix(0, &[0.3, 0.6])?;
        show("values", &found.values);
        show("columns", &found.columns);
        show("row_pointers", &found.row_pointers);
    }
    begin("basis_matrix");
    {
        let found = nurbs::basis_matrix(0, 3, 3)?;
        show("matrix", &found);
    }
    begin("decompose");
    {
        let found = given.surface.decompose()?;
        show("out", &found);
    }
    begin("bezier_pieces");
    {
        let found = given.surface.bezier_pieces()?;
        show("points", &found.points);
        show("weights", &found.weights);
        show("domains", &found.domains);
        show("piece_counts", &found.piece_counts);
    }
    begin("bezier_pieces rational");
    {
        let found = given.curve.bezier_pieces()?;
        show("points", &found.points);
        show("weights", &found.weights);
        show("domains", &found.domains);
        show("piece_counts", &found.piece_counts);
    }
    begin("bezier_cells");
    {
        let found = given.surface.bezier_cells()?;
        show("own_points", &found.cells);
        show("kind", &found.kind);
        show("points", &found.point_count);
    }
    begin("bezier_cells closed");
    {
        let found = given.r#loop.bezier_cells()?;
        show("own_points", &found.cells);
        show("kind", &found.kind);
        show("points", &found.point_count);
    }
    begin("bezier_cell_points");
    {
        let found = given.surface.bezier_cell_points()?;
        show("points", &found.points);
        show("weights", &found.weights);
    }
    begin("bezier_cell_points rational");
    {
        let found = given.curve.bezier_cell_points()?;
        show("points", &found.points);
        show("weights", &found.weights);
    }
    begin("split_at_knots");
    {
        let found = given.curve.split_at_knots(0, 1)?;
        show("out", &found);
    }
    begin("boundaries");
    {
        let found = given.volume.boundaries()?;
        show("out", &found);
    }
    begin("create curve");
    {
        let found = Spline::create(
            &[2],
            &[9],
            &[
                0.0, 0.0, 0.0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1.0, 1.0, 1.0,
            ],
            2,
            &[
                1.0, 0.0, 1.0, 1.0, 0.0, 1.0, -1.0, 1.0, -1.0, 0.0, -1.0, -1.0, 0.0, -1.0, 1.0,
                -1.0, 1.0, 0.0,
            ],
            Some(&[
                1.0,
                0.7071067811865476,
                1.0,
                0.7071067811865476,
                1.0,
                0.7071067811865476,
                1.0,
                0.7071067811865476,
                1.0,
            ]),
            0,
        )?;
        show("out", &found);
    }
    begin("create loop");
    {
        let found = Spline::create(
            &[2],
            &[6],
            &[0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0],
            2,
            &[
                1.0, 1.0, -1.0, 1.0, -1.0, -1.0, 1.0, -1.0, 1.0, 1.0, -1.0, 1.0,
            ],
            None,
            1,
        )?;
        show("out", &found);
    }
    begin("create volume");
    {
        let found = Spline::create(
            &[1, 1, 1],
            &[2, 2, 2],
            &[0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 1.0],
            4,
            &[
                0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0,
                1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0,
            ],
            None,
            0,
        )?;
        show("out", &found);
    }
    begin("create_homogeneous");
    {
        let found = Spline::create_homogeneous(
            &[2],
            &[6],
            &[0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0],
            1,
            &[
                1.0, 1.0, 1.0, 2.0, -1.0, 1.0, -1.0, -1.0, 1.0, -1.0, 1.0, 2.0,
            ],
            0,
        )?;
        show("out", &found);
    }
    begin("create_periodic");
    {
        let found = Spline::create_periodic(
            &[2],
            &[4],
            &[2.0, 3.0, 4.0, 5.0, 6.0],
            2,
            &[1.0, 1.0, -1.0, 1.0, -1.0, -1.0, 1.0, -1.0],
            Some(&[1.0, 2.0, 1.0, 0.5]),
            1,
        )?;
        show("out", &found);
    }
    begin("create_short");
    {
        let found = Spline::create_short(
            &[2],
            &[9],
            &[0.0, 0.0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1.0, 1.0],
            2,
            &[
                1.0, 0.0, 1.0, 1.0, 0.0, 1.0, -1.0, 1.0, -1.0, 0.0, -1.0, -1.0, 0.0, -1.0, 1.0,
                -1.0, 1.0, 0.0,
            ],
            Some(&[
                1.0,
                0.7071067811865476,
                1.0,
                0.7071067811865476,
                1.0,
                0.7071067811865476,
                1.0,
                0.7071067811865476,
                1.0,
            ]),
            0,
        )?;
        show("out", &found);
    }
    begin("create_multiplicities");
    {
        let found = Spline::create_multiplicities(
            &[2],
            &[9],
            &[(&[0.0, 0.25, 0.5, 0.75, 1.0], &[3, 2, 2, 2, 3])],
            2,
            &[
                1.0, 0.0, 1.0, 1.0, 0.0, 1.0, -1.0, 1.0, -1.0, 0.0, -1.0, -1.0, 0.0, -1.0, 1.0,
                -1.0, 1.0, 0.0,
            ],
            Some(&[
                1.0,
                0.7071067811865476,
                1.0,
                0.7071067811865476,
                1.0,
                0.7071067811865476,
                1.0,
                0.7071067811865476,
                1.0,
            ]),
            0,
        )?;
        show("out", &found);
    }
    begin("create_power");
    {
        let found = Spline::power(
            &[1, 0],
            2,
            &nurbs::PowerForm {
                coefficients: vec![0.1, 0.9, 0.3, 0.7],
                breaks: vec![0.0, 1.0, 0.0, 1.0],
                piece_counts: vec![1, 1],
            },
            0,
        )?;
        show("out", &found);
    }
    begin("refinement_matrix size");
    {
        let found = given.curve.refinement_matrix(0, &[0.3, 0.6])?;
        show("values", &found.values);
        show("columns", &found.columns);
        show("row_pointers", &found.row_pointers);
    }
    begin("create_bezier rational");
    {
        let found = Spline::bezier(
            &[3],
            2,
            &[0.0, 0.0, 1.0, 2.0, 3.0, 2.0, 4.0, 0.0],
            Some(&[1.0, 0.7071067811865476, 1.0, 0.7071067811865476]),
        )?;
        show("out", &found);
    }
    begin("interpolate");
    {
        let found = Spline::interpolate(
            &[3],
            &[5],
            &[0.0, 0.25, 0.5, 0.75, 1.0],
            2,
            &[0.0, 0.0, 1.0, 2.0, 3.0, 2.0, 4.0, 0.0, 5.0, 5.0],
            None,
            0,
        )?;
        show("out", &found.spline);
        show("residual", &found.residual);
    }
    begin("interpolate natural");
    {
        let found = Spline::interpolate(
            &[3],
            &[3],
            &[0.0, 0.5, 1.0],
            2,
            &[0.0, 0.0, 1.0, 2.0, 3.0, 2.0],
            Some(&[1, 1]),
            0,
        )?;
        show("out", &found.spline);
        show("residual", &found.residual);
    }
    begin("interpolate loop");
    {
        let found = Spline::interpolate(
            &[2],
            &[5],
            &[0.0, 0.25, 0.5, 0.75, 1.0],
            1,
            &[0.0, 1.0, 0.0, -1.0, 0.0],
            None,
            1,
        )?;
        show("out", &found.spline);
        show("residual", &found.residual);
    }
    begin("interpolate_over_knots");
    {
        let found = Spline::interpolate_over_knots(
            &[1, 2],
            &[2, 3],
            &[0.0, 1.0, 0.0, 0.5, 1.0],
            &[0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0],
            1,
            &[0.0, 1.0, 2.0, 3.0, 4.0, 5.0],
            0,
        )?;
        show("out", &found);
    }
    begin("interpolate_derivatives");
    {
        let found = Spline::interpolate_derivatives(
            &[3, 2],
            &[5, 3],
            &[0.0, 0.0, 0.5, 1.0, 1.0, 0.0, 0.5, 1.0],
            &[0, 1, 0, 0, 1, 0, 0, 0],
            1,
            &[
                0.0, 1.0, 2.0, 1.0, 1.0, 1.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 0.0, 0.0, 0.0,
            ],
            None,
            0,
        )?;
        show("out", &found);
    }
    begin("interpolate_derivatives ends");
    {
        let found = Spline::interpolate_derivatives(
            &[3, 3],
            &[4, 4],
            &[0.0, 0.0, 1.0, 1.0, 0.0, 0.5, 0.75, 1.0],
            &[0, 1, 0, 1, 0, 0, 0, 0],
            1,
            &[
                0.0, 1.0, 2.0, 1.0, 1.0, 1.0, 3.0, 0.5, 5.0, 6.0, 7.0, 8.0, 1.0, 0.0, 0.0, 1.0,
            ],
            Some(&[0, 0, 1, 1]),
            0,
        )?;
        show("out", &found);
    }
    begin("curve_interpolate");
    {
        let found = Spline::curve_interpolate(
            3,
            &[0.0, 0.0, 1.0, 1.0],
            2,
            &[0.0, 0.0, 1.0, 0.0, 2.0, 1.0, 1.0, 1.0],
            &[0, 1, 0, 1],
            &[],
            0,
        )?;
        show("out", &found);
    }
    begin("curve_interpolate directions");
    {
        let found = Spline::curve_interpolate(
            3,
            &[0.0, 0.0, 1.0, 1.0],
            2,
            &[0.0, 0.0, 1.0, 0.0, 2.0, 1.0, 1.0, 1.0],
            &[0, -1, 0, -1],
            &[],
            0,
        )?;
        show("out", &found);
    }
    begin("curve_interpolate over knots");
    {
        let found = Spline::curve_interpolate(
            2,
            &[0.0, 0.5, 1.0],
            1,
            &[0.0, 1.0, 0.0],
            &[],
            &[0.0, 0.0, 0.0, 1.0, 1.0, 1.0],
            0,
        )?;
        show("out", &found);
    }
    begin("tangent_lengths");
    {
        let found = nurbs::tangent_lengths(
            3,
            &[0.0, 0.0, 1.0, 1.0],
            2,
            &[0.0, 0.0, 1.0, 0.0, 2.0, 1.0, 1.0, 1.0],
            &[0, -1, 0, -1],
            &[],
            0,
        )?;
        show("lengths", &found);
    }
    begin("tangent_lengths over knots");
    {
        let found = nurbs::tangent_lengths(
            2,
            &[0.0, 0.0, 1.0],
            2,
            &[0.0, 0.0, 1.0, 0.0, 2.0, 1.0],
            &[0, -1, 0],
            &[0.0, 0.0, 0.0, 1.0, 1.0, 1.0],
            0,
        )?;
        show("lengths", &found);
    }
    by_hand("data_init");
    begin("statistics_create");
    {
        let found = Statistics::create(&[1, 1], &[2, 3], &[0.0, 1.0, 0.0, 1.0, 2.0], 2, 1.0, 1.0)?;
        show("out", &found);
    }
    begin("statistics_add");
    {
        let found = given
            .statistics
            .add(&nurbs::Data::new(1, 1, &[0.25, 0.75], &[1.0, 2.0])?.weights(&[1.0, 0.5])?)?;
        show("out", &found);
    }
    begin("statistics_merge");
    {
        let found = Statistics::merge(
            &[&given.statistics, &given.statistics, &given.no_statistics],
            &[1, -1, 1],
        )?;
        show("out", &found);
    }
    by_hand("statistics_clone");
    by_hand("statistics_destroy");
    begin("statistics_size");
    {
        let found = given.statistics.size()?;
        show("axes", &found.axes);
        show("dim", &found.dim);
        show("count", &found.count);
        show("cells", &found.cells);
        show("weight", &found.weight);
    }
    by_hand("statistics_to_bytes");
    begin("statistics_from_bytes");
    {
        let found = Statistics::from_bytes(NO_DATA)?;
        show("out", &found);
    }
    by_hand("fit_options_init");
    begin("fit");
    {
        let found = given.statistics.fit(
            &[2],
            &[4],
            &[0.0, 0.0, 0.0, 0.5, 1.0, 1.0, 1.0],
            Some(&nurbs::FitOptions::new()?.smoothing(1, 0.5).penalty_order(1)),
            0,
        )?;
        show("out", &found.spline);
    }
    begin("fit_errors");
    {
        let ramp = Spline::bezier(&[2], 1, &[0.0, 0.25, 1.0], None)?;
        let found = given
            .statistics
            .fit_errors(&ramp, 1, 0.5, 1.0, &[0.0, 0.25, 1.0], 0)?;
        show("errors", &found);
    }
    begin("fit_criteria");
    {
        let ramp = Spline::bezier(&[2], 1, &[0.0, 0.25, 1.0], None)?;
        let found = given.statistics.fit_criteria(&ramp, 1, &[0.5, 2.0])?;
        show("values", &found);
    }
    begin("fit_points");
    {
        let found = nurbs::fit_points(
            &nurbs::Data::new(
                2,
                1,
                &[0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 1.0, 0.5, 0.5, 0.25, 0.5],
                &[0.0, 1.0, 2.0, 1.0, 0.0, 1.0],
            )?,
            &[1, 1],
            &[2, 2],
            &[0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 1.0],
            Some(&nurbs::FitOptions::new()?.smoothing(2, 0.0).penalty_order(1)),
            0,
        )?;
        show("out", &found.spline);
    }
    begin("fit_tolerance");
    {
        let found = nurbs::fit_tolerance(
            &nurbs::Data::new(
                1,
                2,
                &[0.0, 0.25, 0.5, 0.75, 1.0],
                &[0.0, 1.0, 2.0, 1.0, 0.0, 0.0, 1.0, 1.0, 2.0, 1.0],
            )?,
            &[2],
            0.01,
            &[0.0, 1.0],
            0,
            Some(&nurbs::FitOptions::new()?.smoothing(0, 0.0).penalty_order(2)),
            0,
        )?;
        show("out", &found.spline);
    }
    begin("cloud_start");
    {
        let found = Spline::cloud_start(
            &[1],
            &[3],
            &[0.0, 0.0, 0.5, 1.0, 1.0],
            2,
            &[0.0, 0.0, 1.0, 1.0, 2.0, 1.0],
            0,
        )?;
        show("out", &found);
    }
    by_hand("cloud_options_init");
    begin("fit_cloud");
    {
        let found = given.twist.fit_cloud(
            &[0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 2.0, 1.0, 2.0],
            Some(&[1.0, 2.0, 1.0]),
            Some(
                &nurbs::CloudOptions::new()?
                    .penalty_order(2)
                    .rounds(3)
                    .lambda(0.5)
                    .first_lambda(1.0)
                    .tolerance(0.001),
            ),
        )?;
        show("out", &found.spline);
    }
    begin("approximate");
    {
        let found = given.curve.approximate(0.3, &[3], 0)?;
        show("out", &found.spline);
        show("bound", &found.bound);
    }
    begin("face_create");
    {
        let south = Spline::bezier(&[1], 2, &[0.0, 0.0, 1.0, 0.0], None)?;
        let east = Spline::bezier(&[1], 2, &[1.0, 0.0, 1.0, 3.0], None)?;
        let north = Spline::bezier(&[1], 2, &[1.0, 3.0, 0.0, 3.0], None)?;
        let west = Spline::bezier(&[1], 2, &[0.0, 3.0, 0.0, 0.0], None)?;
        let found = Face::create(
            &given.surface,
            &[1, 4],
            &[
                Some(&given.outline),
                Some(&south),
                Some(&east),
                Some(&north),
                Some(&west),
            ],
            &[],
            &[0, 7, -8, 0, 9],
            0.001,
            67108864,
        )?;
        show("out", &found);
    }
    begin("face_create without crossings");
    {
        let south = Spline::bezier(&[1], 2, &[0.0, 0.0, 1.0, 0.0], None)?;
        let east = Spline::bezier(&[1], 2, &[1.0, 0.0, 1.0, 3.0], None)?;
        let north = Spline::bezier(&[1], 2, &[1.0, 3.0, 0.0, 3.0], None)?;
        let west = Spline::bezier(&[1], 2, &[0.0, 3.0, 0.0, 0.0], None)?;
        let found = Face::create(
            &given.surface,
            &[4],
            &[Some(&south), Some(&east), Some(&north), Some(&west)],
            &[],
            &[],
            0.001,
            33554432,
        )?;
        show("out", &found);
    }
    begin("face_create of edges");
    {
        let first_edge = Spline::bezier(
            &[2],
            3,
            &[0.25, 1.0, 1.0625, 0.5, 1.0, 1.1875, 0.75, 1.0, 1.5625],
            None,
        )?;
        let second_edge = Spline::bezier(
            &[2],
            3,
            &[0.75, 1.0, 1.5625, 0.625, 1.5, 1.875, 0.5, 2.0, 2.25],
            None,
        )?;
        let third_edge = Spline::bezier(
            &[2],
            3,
            &[0.5, 2.0, 2.25, 0.375, 1.5, 1.625, 0.25, 1.0, 1.0625],
            None,
        )?;
        let found = Face::create(
            &given.surface,
            &[3],
            &[],
            &[Some(&first_edge), Some(&second_edge), Some(&third_edge)],
            &[1, 2, 3],
            1e-09,
            0,
        )?;
        show("out", &found);
    }
    begin("face_create whole");
    {
        let found = Face::create(&given.surface, &[], &[], &[], &[], 0.0, 0)?;
        show("out", &found);
    }
    by_hand("face_clone");
    by_hand("face_destroy");
    begin("face_surface");
    {
        let found = given.face.surface()?;
        show("out", &found);
    }
    begin("face_loops");
    {
        let found = given.face.loops()?;
        show("sizes", &found);
    }
    begin("face_curve");
    {
        let found = given.face.curve(0, 0)?;
        show("out", &found);
    }
    begin("face_edge");
    {
        let found = given.face.edge(0, 0)?;
        show("out", &found.spline);
        show("key", &found.key);
    }
    begin("face_deviation");
    {
        let found = given.face.deviation(0, 0)?;
        show("distance", &found.distance);
        show("proven", &found.proven);
    }
    begin("face_tolerance");
    {
        let found = given.face.tolerance()?;
        show("tolerance", &found);
    }
    begin("face_classify");
    {
        let found = given.face.classify(&[0.1, 0.9, 0.3, 0.7, 0.2, 0.6], 0.0)?;
        show("sides", &found);
    }
    begin("face_area");
    {
        let found = given.face.area(1e-06)?;
        show("area", &found.value);
        show("error", &found.error);
    }
    begin("face_moments");
    {
        let found = given.face.moments(1e-06)?;
        show("content", &found.content);
        show("centroid", &found.centroid);
        show("inertia", &found.inertia);
        show("error", &found.error);
    }
    begin("face_quadrature");
    {
        let found = given.face.quadrature(1)?;
        show("params", &found.params);
        show("weights", &found.weights);
        show("measures", &found.measures);
    }
    begin("face_box");
    {
        let found = given.face.bounding_box(0.001)?;
        show("lower", &found.lower);
        show("upper", &found.upper);
        show("gap", &found.gap);
    }
    begin("read_model");
    {
        let found = Model::read(SOLID.as_bytes(), None)?;
        show("out", &found);
    }
    begin("read_model in millimetres");
    {
        let found = Model::read(
            SOLID.as_bytes(),
            Some(&nurbs::ReadOptions::new()?.unit(0.001)),
        )?;
        show("out", &found);
    }
    begin("read_model_file");
    {
        let found = Model::read_file(written("smoke_calls_rust.solid", SOLID), None)?;
        show("out", &found);
    }
    begin("read_model_file in millimetres");
    {
        let found = Model::read_file(
            written("smoke_calls_rust.solid", SOLID),
            Some(&nurbs::ReadOptions::new()?.unit(0.001)),
        )?;
        show("out", &found);
    }
    begin("model_create");
    {
        let found = Model::create(&[&given.face, &given.face], 0.001)?;
        show("out", &found);
    }
    begin("model_sew");
    {
        let sphere = Spline::sphere(
            nurbs::Placement {
                ..Default::default()
            },
            1.0,
            0,
        )?;
        let ball_face = Face::create(&sphere, &[], &[], &[], &[], 1e-09, 0)?;
        let found = Model::sew(&[&given.face, &ball_face], 1e-06, 0.001)?;
        show("out", &found);
    }
    begin("region_create");
    {
        let found = Model::region(&[&given.outline], 1, 0.0)?;
        show("out", &found);
    }
    begin("region_combine");
    {
        let moved_outline = Spline::create(
            &[1],
            &[4],
            &[0.0, 0.0, 1.0, 2.0, 3.0, 3.0],
            2,
            &[0.25, 1.25, 0.75, 1.25, 0.5, 2.25, 0.25, 1.25],
            None,
            0,
        )?;
        let moved_face = Face::create(
            &given.surface,
            &[1],
            &[Some(&moved_outline)],
            &[],
            &[],
            0.001,
            0,
        )?;
        let found = Model::combine(3, &[&given.face], &[&moved_face], 0.0)?;
        show("out", &found);
    }
    begin("face_split");
    {
        let divider = Spline::bezier(&[1], 2, &[0.0, 1.5, 1.0, 1.75], None)?;
        let found = Model::split(&given.face, &[&divider], 0.0)?;
        show("out", &found);
    }
    begin("face_trim");
    {
        let cutter = Spline::create(
            &[1, 1],
            &[2, 2],
            &[0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 1.0],
            3,
            &[
                -1.0, 1.625, -9.0, -1.0, 1.625, 9.0, 2.0, 1.625, -9.0, 2.0, 1.625, 9.0,
            ],
            None,
            0,
        )?;
        let found = Model::trim(&given.face, &cutter, 1, 1e-06)?;
        show("out", &found);
    }
    begin("model_edge_gaps");
    {
        let found = given.model.edge_gaps()?;
        show("uses", &found.uses);
        show("gaps", &found.gaps);
        show("bounded", &found.bounded);
    }
    by_hand("model_clone");
    by_hand("model_destroy");
    begin("model_face");
    {
        let found = given.model.face(1)?;
        show("out", &found.face);
        show("part", &found.part);
        show("shape", &found.shape);
        show("against", &found.against);
        show("colour", &found.colour);
    }
    begin("model_edge");
    {
        let found = given.model.edge(1)?;
        show("out", &found.spline);
        show("part", &found.part);
        show("end_vertices", &found.vertices);
        show("shape", &found.shape);
    }
    begin("model_splines");
    {
        let found = given.model.splines()?;
        show("out", &found);
    }
    by_hand("write_options_init");
    by_hand("model_write");
    by_hand("model_write in inches");
    by_hand("model_write as IGES");
    begin("model_write_file");
    {
        given
            .model
            .write_file(written("smoke_calls_rust.replaced", REPLACED), 1, None)?;
    }
    begin("model_write_file in inches");
    {
        given.model.write_file(
            written("smoke_calls_rust.replaced", REPLACED),
            1,
            Some(&nurbs::WriteOptions::new()?.unit(0.0254)),
        )?;
    }
    by_hand("list_write");
    by_hand("list_write as IGES");
    begin("list_write_file");
    {
        let edges = given.surface.boundaries()?;
        edges.write_file(
            written("smoke_calls_rust.replaced", REPLACED),
            1,
            Some(&nurbs::WriteOptions::new()?.unit(0.0254)),
        )?;
    }
    begin("surface_sections in two planes");
    {
        let found = Meet::sections(&given.surface, &[0.0, 0.5, 2.0], &[1.0, 3.0], 0.01)?;
        show("out", &found);
    }
    begin("surface_sections");
    {
        let found = Meet::sections(&given.surface, &[0.0, 0.0, 1.0], &[1.5], 0.0001)?;
        show("out", &found);
    }
    begin("surface_contours along a direction");
    {
        let found = Meet::contours(&given.surface, 1, Some(&[0.2, 0.1, 1.0]), &[], 0.01)?;
        show("out", &found);
    }
    begin("surface_contours");
    {
        let found = Meet::contours(&given.surface, 3, Some(&[0.0, 0.0, 2.0]), &[0.9], 0.01)?;
        show("out", &found);
    }
    begin("surface_reflections of normals");
    {
        let found = Meet::reflections(
            &given.surface,
            1,
            None,
            &[0.0, 0.0, 1.0],
            &[0.5, 0.25, 0.0],
            0.01,
        )?;
        show("out", &found);
    }
    begin("surface_reflections");
    {
        let found = Meet::reflections(
            &given.surface,
            2,
            Some(&[0.1, 0.0, -1.0]),
            &[1.0, 0.0, 0.0],
            &[0.0, 0.5, 6.0, 0.0, 1.0, 6.0],
            0.01,
        )?;
        show("out", &found);
    }
    begin("surface_level");
    {
        let found = Meet::level(&given.surface, 1, &[0.0, 0.0, 1.0, -1.5], 0.01)?;
        show("out", &found);
    }
    begin("surface_level_curves");
    {
        let heights = Spline::create(
            &[1, 1],
            &[2, 2],
            &[0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 3.0, 3.0],
            1,
            &[0.0, 1.0, 1.0, 2.0],
            None,
            0,
        )?;
        let found = Meet::level_curves(&given.surface, &heights, &[0.5], 0.01)?;
        show("out", &found);
    }
    begin("surface_intersections");
    {
        let wall = Spline::bezier(
            &[1, 1],
            3,
            &[
                0.3, -1.0, -1.0, 0.3, -1.0, 9.0, 0.4, 9.0, -1.0, 0.4, 9.0, 9.0,
            ],
            None,
        )?;
        let found = Meet::surfaces(&wall, &given.surface, 0.1)?;
        show("out", &found);
    }
    begin("surface_self_intersections");
    {
        let found = Meet::of_itself(&given.surface, 0.1)?;
        show("out", &found);
    }
    begin("face_intersections");
    {
        let wall = Spline::bezier(
            &[1, 1],
            3,
            &[
                0.3, -1.0, -1.0, 0.3, -1.0, 9.0, 0.4, 9.0, -1.0, 0.4, 9.0, 9.0,
            ],
            None,
        )?;
        let upright_outline = Spline::create(
            &[1],
            &[4],
            &[0.0, 0.0, 1.0, 2.0, 3.0, 3.0],
            2,
            &[0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0],
            None,
            0,
        )?;
        let upright = Face::create(&wall, &[1], &[Some(&upright_outline)], &[], &[], 0.001, 0)?;
        let found = Meet::of_faces(&given.face, &upright, 0.1)?;
        show("out", &found);
    }
    begin("meet_kinds");
    {
        let found = given.meet.kinds()?;
        show("kinds", &found);
    }
    begin("surface_project_curve");
    {
        let wall = Spline::bezier(
            &[1, 1],
            3,
            &[
                0.3, -1.0, -1.0, 0.3, -1.0, 9.0, 0.4, 9.0, -1.0, 0.4, 9.0, 9.0,
            ],
            None,
        )?;
        let found = Meet::projection(&wall, &given.twist, &[1.0, 0.2, 0.1], 0.01)?;
        show("out", &found);
    }
    begin("face_project_curve");
    {
        let found = Meet::face_projection(&given.face, &given.twist, &[0.0, 0.0, 1.0], 0.1)?;
        show("out", &found);
    }
    begin("model_sections");
    {
        let sphere = Spline::sphere(
            nurbs::Placement {
                ..Default::default()
            },
            1.0,
            0,
        )?;
        let ball_face = Face::create(&sphere, &[], &[], &[], &[], 1e-09, 0)?;
        let ball = Model::create(&[&ball_face], 1.0)?;
        let found = Meet::model_sections(&ball, &[0.0, 0.0, 1.0], &[0.1], 0.1)?;
        show("out", &found);
    }
    begin("model_intersections");
    {
        let sphere = Spline::sphere(
            nurbs::Placement {
                ..Default::default()
            },
            1.0,
            0,
        )?;
        let ball_face = Face::create(&sphere, &[], &[], &[], &[], 1e-09, 0)?;
        let ball = Model::create(&[&ball_face], 1.0)?;
        let found = Meet::of_models(&given.model, &ball, 0.1)?;
        show("out", &found);
    }
    begin("meet_faces_second");
    {
        let found = given.meet.faces_second()?;
        show("own_faces", &found.faces);
        show("own_instances", &found.instances);
    }
    begin("meet_joints_second");
    {
        let found = given.meet.joints_second()?;
        show("own_faces", &found.faces);
        show("own_instances", &found.instances);
    }
    begin("meet_ways");
    {
        let found = given.meet.ways()?;
        show("levels", &found.levels);
        show("firsts", &found.firsts);
        show("sizes", &found.sizes);
        show("closes", &found.closed);
        show("gaps", &found.gaps);
    }
    begin("meet_ways closed");
    {
        let found = given.meet.ways()?;
        show("levels", &found.levels);
        show("firsts", &found.firsts);
        show("sizes", &found.sizes);
        show("closes", &found.closed);
        show("gaps", &found.gaps);
    }
    begin("meet_faces");
    {
        let found = given.meet.faces()?;
        show("own_faces", &found.faces);
        show("own_instances", &found.instances);
    }
    begin("meet_joints");
    {
        let found = given.meet.joints()?;
        show("next_nodes", &found.next_nodes);
        show("gaps", &found.gaps);
        show("own_faces", &found.faces);
        show("own_instances", &found.instances);
    }
    begin("meet_trim");
    {
        let found = Meet::trimmed(&given.meet, &given.face)?;
        show("out", &found);
    }
    begin("meet_trim_second");
    {
        let wall = Spline::bezier(
            &[1, 1],
            3,
            &[
                0.3, -1.0, -1.0, 0.3, -1.0, 9.0, 0.4, 9.0, -1.0, 0.4, 9.0, 9.0,
            ],
            None,
        )?;
        let crossing = Meet::surfaces(&given.surface, &wall, 0.01)?;
        let found = Meet::trimmed_second(&crossing, &given.face)?;
        show("out", &found);
    }
    by_hand("mesh_options_init");
    begin("mesh_surface");
    {
        let found = Mesh::of_surface(
            &given.surface,
            Some(&nurbs::MeshOptions::new()?.chord(1.0).relative_chord(0.0)),
        )?;
        show("out", &found);
    }
    begin("mesh_surface by length");
    {
        let found = Mesh::of_surface(
            &given.surface,
            Some(
                &nurbs::MeshOptions::new()?
                    .chord(10.0)
                    .relative_chord(0.0)
                    .longest(1.5),
            ),
        )?;
        show("out", &found);
    }
    begin("mesh_surface by angle");
    {
        let found = Mesh::of_surface(
            &given.surface,
            Some(
                &nurbs::MeshOptions::new()?
                    .chord(10.0)
                    .relative_chord(0.0)
                    .angle(0.5),
            ),
        )?;
        show("out", &found);
    }
    begin("mesh_face");
    {
        let found = Mesh::of_face(
            &given.face,
            Some(&nurbs::MeshOptions::new()?.chord(1.0).relative_chord(0.0)),
        )?;
        show("out", &found);
    }
    begin("mesh_model");
    {
        let found = Mesh::of_model(
            &given.model,
            Some(&nurbs::MeshOptions::new()?.chord(1.0).relative_chord(0.0)),
        )?;
        show("out", &found);
    }
    begin("mesh_surface without small angles");
    {
        let found = Mesh::of_surface(
            &given.surface,
            Some(
                &nurbs::MeshOptions::new()?
                    .chord(10.0)
                    .relative_chord(0.0)
                    .minimum_angle(0.4),
            ),
        )?;
        show("out", &found);
    }
    by_hand("mesh_surface_levels");
    by_hand("mesh_face_levels");
    by_hand("mesh_model_levels");
    begin("mesh_volume");
    {
        let found = Mesh::of_volume(
            &given.solid,
            Some(&nurbs::MeshOptions::new()?.chord(0.1).relative_chord(0.0)),
            100,
        )?;
        show("out", &found);
    }
    begin("mesh_points");
    {
        let found = given.mesh.points()?;
        show("points", &found);
    }
    begin("mesh_points_f32");
    {
        let found = given.mesh.points_f32()?;
        show("points", &found);
    }
    begin("mesh_vertices");
    {
        let found = given.mesh.vertices()?;
        show("own_points", &found.points);
        show("params", &found.params);
        show("normals", &found.normals);
    }
    begin("mesh_vertices normals");
    {
        let found = given.mesh.vertices()?;
        show("own_points", &found.points);
        show("params", &found.params);
        show("normals", &found.normals);
    }
    begin("mesh_vertices_f32");
    {
        let found = given.mesh.vertices_f32()?;
        show("points", &found.points);
        show("params", &found.params);
        show("normals", &found.normals);
    }
    begin("mesh_triangles");
    {
        let found = given.mesh.triangles(0)?;
        show("corners", &found);
    }
    begin("mesh_triangles welded");
    {
        let found = given.mesh.triangles(16777216)?;
        show("corners", &found);
    }
    begin("mesh_triangles_i32");
    {
        let found = given.mesh.triangles_i32(0)?;
        show("corners", &found);
    }
    begin("mesh_quads");
    {
        let found = given.mesh.quads(0)?;
        show("corners", &found.corners);
        show("own_triangles", &found.triangles);
    }
    begin("mesh_quads welded");
    {
        let found = given.mesh.quads(16777216)?;
        show("corners", &found.corners);
        show("own_triangles", &found.triangles);
    }
    begin("mesh_faces");
    {
        let found = given.mesh.faces()?;
        show("first_vertices", &found.first_vertices);
        show("vertex_counts", &found.vertex_counts);
        show("first_triangles", &found.first_triangles);
        show("triangle_counts", &found.triangle_counts);
        show("from_shape", &found.from_shape);
        show("from_mesh", &found.from_mesh);
        show("reaches", &found.reached);
    }
    begin("mesh_edges");
    {
        let found = given.mesh.edges()?;
        show("own_edges", &found.edges);
        show("firsts", &found.firsts);
        show("sizes", &found.sizes);
        show("bounds", &found.bounds);
        show("reaches", &found.reached);
    }
    begin("mesh_edge_points");
    {
        let found = given.mesh.edge_points()?;
        show("own_points", &found);
    }
    by_hand("mesh_write");
    by_hand("mesh_write as text");
    by_hand("mesh_write as OBJ");
    by_hand("mesh_write as PLY");
    by_hand("mesh_write as GLB");
    by_hand("mesh_write as VTU");
    begin("mesh_write_file");
    {
        given
            .mesh
            .write_file(written("smoke_calls_rust.replaced", REPLACED), 8, None)?;
    }
    begin("mesh_write_file in inches");
    {
        given.mesh.write_file(
            written("smoke_calls_rust.replaced", REPLACED),
            3,
            Some(&nurbs::WriteOptions::new()?.unit(0.0254)),
        )?;
    }
    begin("mesh_hexahedra");
    {
        let found = given.block.hexahedra()?;
        show("corners", &found.corners);
        show("domains", &found.domains);
        show("folds", &found.folds);
        show("signs", &found.signs);
    }
    by_hand("mesh_clone");
    by_hand("meet_clone");
    by_hand("meet_destroy");
    by_hand("mesh_destroy");
    begin("meet_branches");
    {
        let found = given.meet.branches()?;
        show("levels", &found.levels);
        show("end_nodes", &found.end_nodes);
        show("loops", &found.loops);
        show("deviations", &found.deviations);
    }
    begin("meet_branches levels");
    {
        let found = given.meet.branches()?;
        show("levels", &found.levels);
        show("end_nodes", &found.end_nodes);
        show("loops", &found.loops);
        show("deviations", &found.deviations);
    }
    begin("meet_branch");
    {
        let found = given.meet.branch(1)?;
        show("space", &found.0);
        show("on_surface", &found.1);
    }
    begin("meet_branch_second");
    {
        let wall = Spline::bezier(
            &[1, 1],
            3,
            &[
                0.3, -1.0, -1.0, 0.3, -1.0, 9.0, 0.4, 9.0, -1.0, 0.4, 9.0, 9.0,
            ],
            None,
        )?;
        let crossing = Meet::surfaces(&given.surface, &wall, 0.01)?;
        let found = crossing.branch_second(0)?;
        show("on_second", &found);
    }
    begin("meet_nodes");
    {
        let found = given.meet.nodes()?;
        show("levels", &found.levels);
        show("kinds", &found.kinds);
        show("params", &found.params);
        show("ranges", &found.ranges);
    }
    begin("meet_nodes_second");
    {
        let wall = Spline::bezier(
            &[1, 1],
            3,
            &[
                0.3, -1.0, -1.0, 0.3, -1.0, 9.0, 0.4, 9.0, -1.0, 0.4, 9.0, 9.0,
            ],
            None,
        )?;
        let crossing = Meet::surfaces(&given.surface, &wall, 0.01)?;
        let found = crossing.nodes_second()?;
        show("params", &found.params);
        show("ranges", &found.ranges);
    }
    begin("read_with");
    {
        let found = List::read_with(FILE.as_bytes(), None, &mut Call::new().progress(|_| true))?;
        show("out", &found);
    }
    begin("read_with in millimetres");
    {
        let found = List::read_with(
            FILE.as_bytes(),
            Some(&nurbs::ReadOptions::new()?.unit(0.001)),
            &mut Call::new().progress(|_| true),
        )?;
        show("out", &found);
    }
    begin("read_file_with");
    {
        let found = List::read_file_with(
            written("smoke_calls_rust.file", FILE),
            None,
            &mut Call::new().progress(|_| true),
        )?;
        show("out", &found);
    }
    begin("read_file_with in millimetres");
    {
        let found = List::read_file_with(
            written("smoke_calls_rust.file", FILE),
            Some(&nurbs::ReadOptions::new()?.unit(0.001)),
            &mut Call::new().progress(|_| true),
        )?;
        show("out", &found);
    }
    begin("statistics_add_with");
    {
        let found = given.statistics.add_with(
            &nurbs::Data::new(1, 1, &[0.25, 0.75], &[1.0, 2.0])?.weights(&[1.0, 0.5])?,
            &mut Call::new().progress(|_| true),
        )?;
        show("out", &found);
    }
    begin("fit_with");
    {
        let found = given.statistics.fit_with(
            &[2],
            &[4],
            &[0.0, 0.0, 0.0, 0.5, 1.0, 1.0, 1.0],
            Some(&nurbs::FitOptions::new()?.smoothing(1, 0.5).penalty_order(1)),
            0,
            &mut Call::new().progress(|_| true),
        )?;
        show("out", &found.spline);
    }
    begin("fit_errors_with");
    {
        let ramp = Spline::bezier(&[2], 1, &[0.0, 0.25, 1.0], None)?;
        let found = given.statistics.fit_errors_with(
            &ramp,
            1,
            0.5,
            1.0,
            &[0.0, 0.25, 1.0],
            0,
            &mut Call::new().progress(|_| true),
        )?;
        show("errors", &found);
    }
    begin("fit_criteria_with");
    {
        let ramp = Spline::bezier(&[2], 1, &[0.0, 0.25, 1.0], None)?;
        let found = given.statistics.fit_criteria_with(
            &ramp,
            1,
            &[0.5, 2.0],
            &mut Call::new().progress(|_| true),
        )?;
        show("values", &found);
    }
    begin("fit_points_with");
    {
        let found = nurbs::fit_points_with(
            &nurbs::Data::new(
                2,
                1,
                &[0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 1.0, 0.5, 0.5, 0.25, 0.5],
                &[0.0, 1.0, 2.0, 1.0, 0.0, 1.0],
            )?,
            &[1, 1],
            &[2, 2],
            &[0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 1.0],
            Some(&nurbs::FitOptions::new()?.smoothing(2, 0.0).penalty_order(1)),
            0,
            &mut Call::new().progress(|_| true),
        )?;
        show("out", &found.spline);
    }
    begin("fit_tolerance_with");
    {
        let found = nurbs::fit_tolerance_with(
            &nurbs::Data::new(
                1,
                2,
                &[0.0, 0.25, 0.5, 0.75, 1.0],
                &[0.0, 1.0, 2.0, 1.0, 0.0, 0.0, 1.0, 1.0, 2.0, 1.0],
            )?,
            &[2],
            0.01,
            &[0.0, 1.0],
            0,
            Some(&nurbs::FitOptions::new()?.smoothing(0, 0.0).penalty_order(2)),
            0,
            &mut Call::new().progress(|_| true),
        )?;
        show("out", &found.spline);
    }
    begin("fit_cloud_with");
    {
        let found = given.twist.fit_cloud_with(
            &[0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 2.0, 1.0, 2.0],
            Some(&[1.0, 2.0, 1.0]),
            Some(
                &nurbs::CloudOptions::new()?
                    .penalty_order(2)
                    .rounds(3)
                    .lambda(0.5)
                    .first_lambda(1.0)
                    .tolerance(0.001),
            ),
            &mut Call::new().progress(|_| true),
        )?;
        show("out", &found.spline);
    }
    begin("approximate_with");
    {
        let found =
            given
                .curve
                .approximate_with(0.3, &[3], 0, &mut Call::new().progress(|_| true))?;
        show("out", &found.spline);
        show("bound", &found.bound);
    }
    begin("face_create_with");
    {
        let south = Spline::bezier(&[1], 2, &[0.0, 0.0, 1.0, 0.0], None)?;
        let east = Spline::bezier(&[1], 2, &[1.0, 0.0, 1.0, 3.0], None)?;
        let north = Spline::bezier(&[1], 2, &[1.0, 3.0, 0.0, 3.0], None)?;
        let west = Spline::bezier(&[1], 2, &[0.0, 3.0, 0.0, 0.0], None)?;
        let found = Face::create_with(
            &given.surface,
            &[1, 4],
            &[
                Some(&given.outline),
                Some(&south),
                Some(&east),
                Some(&north),
                Some(&west),
            ],
            &[],
            &[0, 7, -8, 0, 9],
            0.001,
            67108864,
            &mut Call::new().progress(|_| true),
        )?;
        show("out", &found);
    }
    begin("face_create_with without crossings");
    {
        let south = Spline::bezier(&[1], 2, &[0.0, 0.0, 1.0, 0.0], None)?;
        let east = Spline::bezier(&[1], 2, &[1.0, 0.0, 1.0, 3.0], None)?;
        let north = Spline::bezier(&[1], 2, &[1.0, 3.0, 0.0, 3.0], None)?;
        let west = Spline::bezier(&[1], 2, &[0.0, 3.0, 0.0, 0.0], None)?;
        let found = Face::create_with(
            &given.surface,
            &[4],
            &[Some(&south), Some(&east), Some(&north), Some(&west)],
            &[],
            &[],
            0.001,
            33554432,
            &mut Call::new().progress(|_| true),
        )?;
        show("out", &found);
    }
    begin("face_create_with of edges");
    {
        let first_edge = Spline::bezier(
            &[2],
            3,
            &[0.25, 1.0, 1.0625, 0.5, 1.0, 1.1875, 0.75, 1.0, 1.5625],
            None,
        )?;
        let second_edge = Spline::bezier(
            &[2],
            3,
            &[0.75, 1.0, 1.5625, 0.625, 1.5, 1.875, 0.5, 2.0, 2.25],
            None,
        )?;
        let third_edge = Spline::bezier(
            &[2],
            3,
            &[0.5, 2.0, 2.25, 0.375, 1.5, 1.625, 0.25, 1.0, 1.0625],
            None,
        )?;
        let found = Face::create_with(
            &given.surface,
            &[3],
            &[],
            &[Some(&first_edge), Some(&second_edge), Some(&third_edge)],
            &[1, 2, 3],
            1e-09,
            0,
            &mut Call::new().progress(|_| true),
        )?;
        show("out", &found);
    }
    begin("face_create_with whole");
    {
        let found = Face::create_with(
            &given.surface,
            &[],
            &[],
            &[],
            &[],
            0.0,
            0,
            &mut Call::new().progress(|_| true),
        )?;
        show("out", &found);
    }
    begin("face_classify_with");
    {
        let found = given.face.classify_with(
            &[0.1, 0.9, 0.3, 0.7, 0.2, 0.6],
            0.0,
            &mut Call::new().progress(|_| true),
        )?;
        show("sides", &found);
    }
    begin("face_area_with");
    {
        let found = given
            .face
            .area_with(1e-06, &mut Call::new().progress(|_| true))?;
        show("area", &found.value);
        show("error", &found.error);
    }
    begin("face_moments_with");
    {
        let found = given
            .face
            .moments_with(1e-06, &mut Call::new().progress(|_| true))?;
        show("content", &found.content);
        show("centroid", &found.centroid);
        show("inertia", &found.inertia);
        show("error", &found.error);
    }
    begin("face_quadrature_with");
    {
        let found = given
            .face
            .quadrature_with(1, &mut Call::new().progress(|_| true))?;
        show("params", &found.params);
        show("weights", &found.weights);
        show("measures", &found.measures);
    }
    begin("face_box_with");
    {
        let found = given
            .face
            .bounding_box_with(0.001, &mut Call::new().progress(|_| true))?;
        show("lower", &found.lower);
        show("upper", &found.upper);
        show("gap", &found.gap);
    }
    begin("read_model_with");
    {
        let found = Model::read_with(SOLID.as_bytes(), None, &mut Call::new().progress(|_| true))?;
        show("out", &found);
    }
    begin("read_model_with in millimetres");
    {
        let found = Model::read_with(
            SOLID.as_bytes(),
            Some(&nurbs::ReadOptions::new()?.unit(0.001)),
            &mut Call::new().progress(|_| true),
        )?;
        show("out", &found);
    }
    begin("read_model_file_with");
    {
        let found = Model::read_file_with(
            written("smoke_calls_rust.solid", SOLID),
            None,
            &mut Call::new().progress(|_| true),
        )?;
        show("out", &found);
    }
    begin("read_model_file_with in millimetres");
    {
        let found = Model::read_file_with(
            written("smoke_calls_rust.solid", SOLID),
            Some(&nurbs::ReadOptions::new()?.unit(0.001)),
            &mut Call::new().progress(|_| true),
        )?;
        show("out", &found);
    }
    begin("model_sew_with");
    {
        let sphere = Spline::sphere(
            nurbs::Placement {
                ..Default::default()
            },
            1.0,
            0,
        )?;
        let ball_face = Face::create(&sphere, &[], &[], &[], &[], 1e-09, 0)?;
        let found = Model::sew_with(
            &[&given.face, &ball_face],
            1e-06,
            0.001,
            &mut Call::new().progress(|_| true),
        )?;
        show("out", &found);
    }
    begin("region_create_with");
    {
        let found = Model::region_with(
            &[&given.outline],
            1,
            0.0,
            &mut Call::new().progress(|_| true),
        )?;
        show("out", &found);
    }
    begin("region_combine_with");
    {
        let moved_outline = Spline::create(
            &[1],
            &[4],
            &[0.0, 0.0, 1.0, 2.0, 3.0, 3.0],
            2,
            &[0.25, 1.25, 0.75, 1.25, 0.5, 2.25, 0.25, 1.25],
            None,
            0,
        )?;
        let moved_face = Face::create(
            &given.surface,
            &[1],
            &[Some(&moved_outline)],
            &[],
            &[],
            0.001,
            0,
        )?;
        let found = Model::combine_with(
            3,
            &[&given.face],
            &[&moved_face],
            0.0,
            &mut Call::new().progress(|_| true),
        )?;
        show("out", &found);
    }
    begin("face_split_with");
    {
        let divider = Spline::bezier(&[1], 2, &[0.0, 1.5, 1.0, 1.75], None)?;
        let found = Model::split_with(
            &given.face,
            &[&divider],
            0.0,
            &mut Call::new().progress(|_| true),
        )?;
        show("out", &found);
    }
    begin("face_trim_with");
    {
        let cutter = Spline::create(
            &[1, 1],
            &[2, 2],
            &[0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 1.0],
            3,
            &[
                -1.0, 1.625, -9.0, -1.0, 1.625, 9.0, 2.0, 1.625, -9.0, 2.0, 1.625, 9.0,
            ],
            None,
            0,
        )?;
        let found = Model::trim_with(
            &given.face,
            &cutter,
            1,
            1e-06,
            &mut Call::new().progress(|_| true),
        )?;
        show("out", &found);
    }
    by_hand("model_write_with");
    by_hand("model_write_with in inches");
    by_hand("model_write_with as IGES");
    begin("model_write_file_with");
    {
        given.model.write_file_with(
            written("smoke_calls_rust.replaced", REPLACED),
            1,
            None,
            &mut Call::new().progress(|_| true),
        )?;
    }
    begin("model_write_file_with in inches");
    {
        given.model.write_file_with(
            written("smoke_calls_rust.replaced", REPLACED),
            1,
            Some(&nurbs::WriteOptions::new()?.unit(0.0254)),
            &mut Call::new().progress(|_| true),
        )?;
    }
    by_hand("list_write_with");
    by_hand("list_write_with as IGES");
    begin("list_write_file_with");
    {
        let edges = given.surface.boundaries()?;
        edges.write_file_with(
            written("smoke_calls_rust.replaced", REPLACED),
            1,
            Some(&nurbs::WriteOptions::new()?.unit(0.0254)),
            &mut Call::new().progress(|_| true),
        )?;
    }
    begin("surface_sections_with in two planes");
    {
        let found = Meet::sections_with(
            &given.surface,
            &[0.0, 0.5, 2.0],
            &[1.0, 3.0],
            0.01,
            &mut Call::new().progress(|_| true),
        )?;
        show("out", &found);
    }
    begin("surface_sections_with");
    {
        let found = Meet::sections_with(
            &given.surface,
            &[0.0, 0.0, 1.0],
            &[1.5],
            0.0001,
            &mut Call::new().progress(|_| true),
        )?;
        show("out", &found);
    }
    begin("surface_contours_with along a direction");
    {
        let found = Meet::contours_with(
            &given.surface,
            1,
            Some(&[0.2, 0.1, 1.0]),
            &[],
            0.01,
            &mut Call::new().progress(|_| true),
        )?;
        show("out", &found);
    }
    begin("surface_contours_with");
    {
        let found = Meet::contours_with(
            &given.surface,
            3,
            Some(&[0.0, 0.0, 2.0]),
            &[0.9],
            0.01,
            &mut Call::new().progress(|_| true),
        )?;
        show("out", &found);
    }
    begin("surface_reflections_with of normals");
    {
        let found = Meet::reflections_with(
            &given.surface,
            1,
            None,
            &[0.0, 0.0, 1.0],
            &[0.5, 0.25, 0.0],
            0.01,
            &mut Call::new().progress(|_| true),
        )?;
        show("out", &found);
    }
    begin("surface_reflections_with");
    {
        let found = Meet::reflections_with(
            &given.surface,
            2,
            Some(&[0.1, 0.0, -1.0]),
            &[1.0, 0.0, 0.0],
            &[0.0, 0.5, 6.0, 0.0, 1.0, 6.0],
            0.01,
            &mut Call::new().progress(|_| true),
        )?;
        show("out", &found);
    }
    begin("surface_level_with");
    {
        let found = Meet::level_with(
            &given.surface,
            1,
            &[0.0, 0.0, 1.0, -1.5],
            0.01,
            &mut Call::new().progress(|_| true),
        )?;
        show("out", &found);
    }
    begin("surface_level_curves_with");
    {
        let heights = Spline::create(
            &[1, 1],
            &[2, 2],
            &[0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 3.0, 3.0],
            1,
            &[0.0, 1.0, 1.0, 2.0],
            None,
            0,
        )?;
        let found = Meet::level_curves_with(
            &given.surface,
            &heights,
            &[0.5],
            0.01,
            &mut Call::new().progress(|_| true),
        )?;
        show("out", &found);
    }
    begin("surface_intersections_with");
    {
        let wall = Spline::bezier(
            &[1, 1],
            3,
            &[
                0.3, -1.0, -1.0, 0.3, -1.0, 9.0, 0.4, 9.0, -1.0, 0.4, 9.0, 9.0,
            ],
            None,
        )?;
        let found = Meet::surfaces_with(
            &wall,
            &given.surface,
            0.1,
            &mut Call::new().progress(|_| true),
        )?;
        show("out", &found);
    }
    begin("surface_self_intersections_with");
    {
        let found = Meet::of_itself_with(&given.surface, 0.1, &mut Call::new().progress(|_| true))?;
        show("out", &found);
    }
    begin("face_intersections_with");
    {
        let wall = Spline::bezier(
            &[1, 1],
            3,
            &[
                0.3, -1.0, -1.0, 0.3, -1.0, 9.0, 0.4, 9.0, -1.0, 0.4, 9.0, 9.0,
            ],
            None,
        )?;
        let upright_outline = Spline::create(
            &[1],
            &[4],
            &[0.0, 0.0, 1.0, 2.0, 3.0, 3.0],
            2,
            &[0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0],
            None,
            0,
        )?;
        let upright = Face::create(&wall, &[1], &[Some(&upright_outline)], &[], &[], 0.001, 0)?;
        let found = Meet::of_faces_with(
            &given.face,
            &upright,
            0.1,
            &mut Call::new().progress(|_| true),
        )?;
        show("out", &found);
    }
    begin("surface_project_curve_with");
    {
        let wall = Spline::bezier(
            &[1, 1],
            3,
            &[
                0.3, -1.0, -1.0, 0.3, -1.0, 9.0, 0.4, 9.0, -1.0, 0.4, 9.0, 9.0,
            ],
            None,
        )?;
        let found = Meet::projection_with(
            &wall,
            &given.twist,
            &[1.0, 0.2, 0.1],
            0.01,
            &mut Call::new().progress(|_| true),
        )?;
        show("out", &found);
    }
    begin("face_project_curve_with");
    {
        let found = Meet::face_projection_with(
            &given.face,
            &given.twist,
            &[0.0, 0.0, 1.0],
            0.1,
            &mut Call::new().progress(|_| true),
        )?;
        show("out", &found);
    }
    begin("model_sections_with");
    {
        let sphere = Spline::sphere(
            nurbs::Placement {
                ..Default::default()
            },
            1.0,
            0,
        )?;
        let ball_face = Face::create(&sphere, &[], &[], &[], &[], 1e-09, 0)?;
        let ball = Model::create(&[&ball_face], 1.0)?;
        let found = Meet::model_sections_with(
            &ball,
            &[0.0, 0.0, 1.0],
            &[0.1],
            0.1,
            &mut Call::new().progress(|_| true),
        )?;
        show("out", &found);
    }
    begin("model_intersections_with");
    {
        let sphere = Spline::sphere(
            nurbs::Placement {
                ..Default::default()
            },
            1.0,
            0,
        )?;
        let ball_face = Face::create(&sphere, &[], &[], &[], &[], 1e-09, 0)?;
        let ball = Model::create(&[&ball_face], 1.0)?;
        let found = Meet::of_models_with(
            &given.model,
            &ball,
            0.1,
            &mut Call::new().progress(|_| true),
        )?;
        show("out", &found);
    }
    begin("meet_trim_with");
    {
        let found = Meet::trimmed_with(
            &given.meet,
            &given.face,
            &mut Call::new().progress(|_| true),
        )?;
        show("out", &found);
    }
    begin("meet_trim_second_with");
    {
        let wall = Spline::bezier(
            &[1, 1],
            3,
            &[
                0.3, -1.0, -1.0, 0.3, -1.0, 9.0, 0.4, 9.0, -1.0, 0.4, 9.0, 9.0,
            ],
            None,
        )?;
        let crossing = Meet::surfaces(&given.surface, &wall, 0.01)?;
        let found =
            Meet::trimmed_second_with(&crossing, &given.face, &mut Call::new().progress(|_| true))?;
        show("out", &found);
    }
    begin("mesh_surface_with");
    {
        let found = Mesh::of_surface_with(
            &given.surface,
            Some(&nurbs::MeshOptions::new()?.chord(1.0).relative_chord(0.0)),
            &mut Call::new().progress(|_| true),
        )?;
        show("out", &found);
    }
    begin("mesh_surface_with by length");
    {
        let found = Mesh::of_surface_with(
            &given.surface,
            Some(
                &nurbs::MeshOptions::new()?
                    .chord(10.0)
                    .relative_chord(0.0)
                    .longest(1.5),
            ),
            &mut Call::new().progress(|_| true),
        )?;
        show("out", &found);
    }
    begin("mesh_surface_with by angle");
    {
        let found = Mesh::of_surface_with(
            &given.surface,
            Some(
                &nurbs::MeshOptions::new()?
                    .chord(10.0)
                    .relative_chord(0.0)
                    .angle(0.5),
            ),
            &mut Call::new().progress(|_| true),
        )?;
        show("out", &found);
    }
    begin("mesh_face_with");
    {
        let found = Mesh::of_face_with(
            &given.face,
            Some(&nurbs::MeshOptions::new()?.chord(1.0).relative_chord(0.0)),
            &mut Call::new().progress(|_| true),
        )?;
        show("out", &found);
    }
    begin("mesh_model_with");
    {
        let found = Mesh::of_model_with(
            &given.model,
            Some(&nurbs::MeshOptions::new()?.chord(1.0).relative_chord(0.0)),
            &mut Call::new().progress(|_| true),
        )?;
        show("out", &found);
    }
    begin("mesh_surface_with without small angles");
    {
        let found = Mesh::of_surface_with(
            &given.surface,
            Some(
                &nurbs::MeshOptions::new()?
                    .chord(10.0)
                    .relative_chord(0.0)
                    .minimum_angle(0.4),
            ),
            &mut Call::new().progress(|_| true),
        )?;
        show("out", &found);
    }
    by_hand("mesh_surface_levels_with");
    by_hand("mesh_face_levels_with");
    by_hand("mesh_model_levels_with");
    begin("mesh_volume_with");
    {
        let found = Mesh::of_volume_with(
            &given.solid,
            Some(&nurbs::MeshOptions::new()?.chord(0.1).relative_chord(0.0)),
            100,
            &mut Call::new().progress(|_| true),
        )?;
        show("out", &found);
    }
    by_hand("mesh_write_with");
    by_hand("mesh_write_with as text");
    by_hand("mesh_write_with as OBJ");
    by_hand("mesh_write_with as PLY");
    by_hand("mesh_write_with as GLB");
    by_hand("mesh_write_with as VTU");
    begin("mesh_write_file_with");
    {
        given.mesh.write_file_with(
            written("smoke_calls_rust.replaced", REPLACED),
            8,
            None,
            &mut Call::new().progress(|_| true),
        )?;
    }
    begin("mesh_write_file_with in inches");
    {
        given.mesh.write_file_with(
            written("smoke_calls_rust.replaced", REPLACED),
            3,
            Some(&nurbs::WriteOptions::new()?.unit(0.0254)),
            &mut Call::new().progress(|_| true),
        )?;
    }
    Ok(())
}

fn edit(given: &Given) -> nurbs::Result<()> {
    begin("transform");
    {
        let found = given
            .curve
            .transform(2, &[0.0, 1.0, -1.0, 0.0], Some(&[0.0, 1.0]))?;
        show("out", &found);
    }
    begin("transform_projective");
    {
        let found = given
            .curve
            .transform_projective(2, &[1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 2.0])?;
        show("out", &found);
    }
    begin("mirror");
    {
        let found = given.curve.mirror(&[0.1, 0.9], &[0.1, 0.9])?;
        show("out", &found);
    }
    begin("project_to_plane");
    {
        let found = given
            .curve
            .project_to_plane(&[0.1, 0.9], &[0.1, 0.9], None)?;
        show("out", &found);
    }
    begin("project_to_plane along");
    {
        let found = given
            .curve
            .project_to_plane(&[0.1, 0.9], &[0.1, 0.9], Some(&[0.1, 0.9]))?;
        show("out", &found);
    }
    begin("project_from");
    {
        let found = given
            .curve
            .project_from(&[0.3, 0.7], &[0.1, 0.9], &[0.1, 0.9])?;
        show("out", &found);
    }
    begin("make_rational");
    {
        let found = given.r#loop.make_rational()?;
        show("out", &found);
    }
    begin("to_homogeneous");
    {
        let found = given.curve.to_homogeneous()?;
        show("out", &found);
    }
    begin("from_homogeneous");
    {
        let found = given.volume.from_homogeneous()?;
        show("out", &found);
    }
    begin("normalize_weights");
    {
        let found = given.homogeneous.normalize_weights()?;
        show("out", &found);
    }
    begin("equalize_end_weights");
    {
        let found = given.curve.equalize_end_weights(0)?;
        show("out", &found);
    }
    begin("pull_weight");
    {
        let found = given.curve.pull_weight(3, &[0.3], 0.01)?;
        show("out", &found.0);
        show("weight", &found.1);
    }
    begin("pull_weights");
    {
        let found = given.curve.pull_weights(&[2, 3], &[0.3], 0.01)?;
        show("out", &found.0);
        show("factor", &found.1);
    }
    begin("set_weights");
    {
        let found = given.r#loop.set_weights(&[2, 3], &[0.3, 0.6])?;
        show("out", &found);
    }
    begin("weight_through");
    {
        let found = given
            .curve
            .weight_through(1, &[0.125], &[0.75, 0.75], 1.0)?;
        show("out", &found.0);
        show("weight", &found.1);
    }
    begin("pull_point");
    {
        let found = given
            .volume
            .pull_point(0, &[0.1, 0.9, 0.3], &[0.1, 0.9, 0.3, 0.7], 1.0)?;
        show("out", &found.0);
        show("moved", &found.1);
    }
    begin("insert_on_leg");
    {
        let found = given.segment.insert_on_leg(0, 0, 0.5)?;
        show("out", &found.spline);
        show("index", &found.index);
        show("ratio", &found.ratio);
        show("knot", &found.knot);
    }
    begin("insert_at_point");
    {
        let found = given.r#loop.insert_at_point(0, &[0.0, 1.0], 1.0)?;
        show("out", &found.spline);
        show("index", &found.index);
        show("ratio", &found.ratio);
        show("knot", &found.knot);
    }
    begin("constrain");
    {
        let found = given.curve.constrain(
            nurbs::Constraints {
                params: &[0.3, 0.6],
                targets: &[0.1, 0.9, 0.3, 0.7],
                ..Default::default()
            },
            nurbs::ConstrainOptions {
                keep: &[0, 0],
                tolerance: 0.0,
                ..Default::default()
            },
        )?;
        show("out", &found.spline);
        show("residuals", &found.residuals);
        show("rank", &found.rank);
        show("moved", &found.moved);
        show("optimality", &found.optimality);
    }
    begin("warp");
    {
        let found = given.curve.warp(&[0.1, 0.9], 1.0, 1, &[0.3, 0.6])?;
        show("out", &found);
    }
    begin("warp periodic");
    {
        let found = given.r#loop.warp(&[0.1, 0.9], 1.0, 1, &[])?;
        show("out", &found);
    }
    begin("flatten");
    {
        let found = given
            .curve
            .flatten(&[0.1, 0.9], &[0.1, 0.9], &[], &[0.3, 0.6])?;
        show("out", &found.0);
        show("moved", &found.1);
    }
    begin("flatten along");
    {
        let found = given
            .curve
            .flatten(&[0.1, 0.9], &[0.1, 0.9], &[0.1, 0.9], &[0.3, 0.6])?;
        show("out", &found.0);
        show("moved", &found.1);
    }
    begin("free_form_deform");
    {
        let square = Spline::bezier(&[1, 1], 2, &[0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 1.0, 2.0], None)?;
        let found = given
            .curve
            .free_form_deform(&square, &[-1.0, -1.0], &[1.0, 1.0], 0.1)?;
        show("out", &found.spline);
        show("deviation", &found.deviation);
        show("proven", &found.proven);
    }
    begin("fair");
    {
        let found = given.curve.fair(2, 1000.0, &[])?;
        show("out", &found.spline);
        show("energies", &found.energies);
        show("bound", &found.bound);
    }
    begin("fair surface");
    {
        let found = given.surface.fair(1, 1000.0, &[-1, -1, -1, -1])?;
        show("out", &found.spline);
        show("energies", &found.energies);
        show("bound", &found.bound);
    }
    begin("constrain directions");
    {
        let found = given.surface.constrain(
            nurbs::Constraints {
                params: &[0.1, 0.9, 0.3, 0.7],
                targets: &[0.1, 0.9, 0.3, 0.7, 0.2, 0.6],
                kinds: &[2, 0],
                ..Default::default()
            },
            nurbs::ConstrainOptions {
                tolerance: 0.0,
                ..Default::default()
            },
        )?;
        show("out", &found.spline);
        show("residuals", &found.residuals);
        show("rank", &found.rank);
        show("moved", &found.moved);
        show("optimality", &found.optimality);
    }
    begin("constrain curvature");
    {
        let found = given.curve.constrain(
            nurbs::Constraints {
                params: &[0.1],
                targets: &[-1.0, 0.1],
                kinds: &[3],
                ..Default::default()
            },
            nurbs::ConstrainOptions {
                weight_costs: &[1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0],
                tolerance: 1e-09,
                ..Default::default()
            },
        )?;
        show("out", &found.spline);
        show("residuals", &found.residuals);
        show("rank", &found.rank);
        show("moved", &found.moved);
        show("optimality", &found.optimality);
    }
    begin("constrain with costs");
    {
        let found = given.curve.constrain(
            nurbs::Constraints {
                params: &[0.3, 0.6],
                targets: &[0.1, 0.9, 0.3, 0.7],
                kinds: &[0, 0],
                orders: &[0, 1],
            },
            nurbs::ConstrainOptions {
                keep: &[0, 0],
                costs: &[1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0],
                weight_costs: &[1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0],
                tolerance: 1e-06,
            },
        )?;
        show("out", &found.spline);
        show("residuals", &found.residuals);
        show("rank", &found.rank);
        show("moved", &found.moved);
        show("optimality", &found.optimality);
    }
    begin("bend");
    {
        let found = given.curve.bend(
            nurbs::Bend {
                origin: &[0.1, 0.9],
                along: &[1.0, 0.0],
                across: &[0.0, 1.0],
                curvature: 1.0,
                lower: -9.0,
                upper: 9.0,
            },
            0.1,
        )?;
        show("out", &found.spline);
        show("deviation", &found.deviation);
        show("proven", &found.proven);
    }
    begin("snap_boundary");
    {
        let found = given
            .curve
            .snap_boundary((0, 1), (&given.segment, 0, 0), 1, 0)?;
        show("out", &found.spline);
        show("bound", &found.bound);
    }
    begin("snap_boundary surface");
    {
        let found = given
            .surface
            .snap_boundary((0, 1), (&given.surface, 1, 0), 1, 67108864)?;
        show("out", &found.spline);
        show("bound", &found.bound);
    }
    begin("constrain_with");
    {
        let found = given.curve.constrain_with(
            nurbs::Constraints {
                params: &[0.3, 0.6],
                targets: &[0.1, 0.9, 0.3, 0.7],
                ..Default::default()
            },
            nurbs::ConstrainOptions {
                keep: &[0, 0],
                tolerance: 0.0,
                ..Default::default()
            },
            &mut Call::new().progress(|_| true),
        )?;
        show("out", &found.spline);
        show("residuals", &found.residuals);
        show("rank", &found.rank);
        show("moved", &found.moved);
        show("optimality", &found.optimality);
    }
    begin("free_form_deform_with");
    {
        let square = Spline::bezier(&[1, 1], 2, &[0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 1.0, 2.0], None)?;
        let found = given.curve.free_form_deform_with(
            &square,
            &[-1.0, -1.0],
            &[1.0, 1.0],
            0.1,
            &mut Call::new().progress(|_| true),
        )?;
        show("out", &found.spline);
        show("deviation", &found.deviation);
        show("proven", &found.proven);
    }
    begin("fair_with");
    {
        let found = given
            .curve
            .fair_with(2, 1000.0, &[], &mut Call::new().progress(|_| true))?;
        show("out", &found.spline);
        show("energies", &found.energies);
        show("bound", &found.bound);
    }
    begin("fair_with surface");
    {
        let found = given.surface.fair_with(
            1,
            1000.0,
            &[-1, -1, -1, -1],
            &mut Call::new().progress(|_| true),
        )?;
        show("out", &found.spline);
        show("energies", &found.energies);
        show("bound", &found.bound);
    }
    begin("constrain_with directions");
    {
        let found = given.surface.constrain_with(
            nurbs::Constraints {
                params: &[0.1, 0.9, 0.3, 0.7],
                targets: &[0.1, 0.9, 0.3, 0.7, 0.2, 0.6],
                kinds: &[2, 0],
                ..Default::default()
            },
            nurbs::ConstrainOptions {
                tolerance: 0.0,
                ..Default::default()
            },
            &mut Call::new().progress(|_| true),
        )?;
        show("out", &found.spline);
        show("residuals", &found.residuals);
        show("rank", &found.rank);
        show("moved", &found.moved);
        show("optimality", &found.optimality);
    }
    begin("constrain_with curvature");
    {
        let found = given.curve.constrain_with(
            nurbs::Constraints {
                params: &[0.1],
                targets: &[-1.0, 0.1],
                kinds: &[3],
                ..Default::default()
            },
            nurbs::ConstrainOptions {
                weight_costs: &[1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0],
                tolerance: 1e-09,
                ..Default::default()
            },
            &mut Call::new().progress(|_| true),
        )?;
        show("out", &found.spline);
        show("residuals", &found.residuals);
        show("rank", &found.rank);
        show("moved", &found.moved);
        show("optimality", &found.optimality);
    }
    begin("constrain_with with costs");
    {
        let found = given.curve.constrain_with(
            nurbs::Constraints {
                params: &[0.3, 0.6],
                targets: &[0.1, 0.9, 0.3, 0.7],
                kinds: &[0, 0],
                orders: &[0, 1],
            },
            nurbs::ConstrainOptions {
                keep: &[0, 0],
                costs: &[1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0],
                weight_costs: &[1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0],
                tolerance: 1e-06,
            },
            &mut Call::new().progress(|_| true),
        )?;
        show("out", &found.spline);
        show("residuals", &found.residuals);
        show("rank", &found.rank);
        show("moved", &found.moved);
        show("optimality", &found.optimality);
    }
    begin("bend_with");
    {
        let found = given.curve.bend_with(
            nurbs::Bend {
                origin: &[0.1, 0.9],
                along: &[1.0, 0.0],
                across: &[0.0, 1.0],
                curvature: 1.0,
                lower: -9.0,
                upper: 9.0,
            },
            0.1,
            &mut Call::new().progress(|_| true),
        )?;
        show("out", &found.spline);
        show("deviation", &found.deviation);
        show("proven", &found.proven);
    }
    Ok(())
}

fn evaluation(given: &Given) -> nurbs::Result<()> {
    begin("find_spans");
    {
        let found = nurbs::find_spans(
            2,
            &[
                0.0, 0.0, 0.0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1.0, 1.0, 1.0,
            ],
            &[0.1, 0.9, 0.3, 0.7, 0.2, 0.6],
            0,
        )?;
        show("spans", &found);
    }
    begin("bernstein");
    {
        let found = nurbs::bernstein(5, 3, &[0.1, 0.9, 0.3, 0.7, 0.2, 0.6])?;
        show("values", &found);
    }
    begin("basis");
    {
        let found = nurbs::basis(
            2,
            &[
                0.0, 0.0, 0.0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1.0, 1.0, 1.0,
            ],
            4,
            &[0.1, 0.9, 0.3, 0.7, 0.2, 0.6],
            0,
        )?;
        show("spans", &found.spans);
        show("values", &found.values);
    }
    begin("rational_basis");
    {
        let found = given
            .curve
            .rational_basis(&[0.1, 0.9, 0.3, 0.7, 0.2, 0.6], 0)?;
        show("spans", &found.spans);
        show("values", &found.values);
    }
    begin("rational_basis surface");
    {
        let found = given
            .surface
            .rational_basis(&[0.1, 0.9, 0.3, 0.7, 0.2, 0.6], 0)?;
        show("spans", &found.spans);
        show("values", &found.values);
    }
    begin("basis_gradients");
    {
        let found = given
            .curve
            .basis_gradients(&[0.1, 0.9, 0.3, 0.7, 0.2, 0.6], 0)?;
        show("spans", &found.spans);
        show("gradients", &found.gradients);
    }
    begin("basis_gradients surface");
    {
        let found = given
            .surface
            .basis_gradients(&[0.1, 0.9, 0.3, 0.7, 0.2, 0.6], 0)?;
        show("spans", &found.spans);
        show("gradients", &found.gradients);
    }
    begin("eval");
    {
        let found = given.curve.eval(&[0.1, 0.9, 0.3, 0.7, 0.2, 0.6], 0)?;
        show("points", &found);
    }
    begin("eval surface");
    {
        let found = given.surface.eval(&[0.1, 0.9, 0.3, 0.7, 0.2, 0.6], 0)?;
        show("points", &found);
    }
    begin("eval volume");
    {
        let found = given.volume.eval(&[0.1, 0.9, 0.3, 0.7, 0.2, 0.6], 0)?;
        show("points", &found);
    }
    begin("eval_derivs");
    {
        let found = given
            .curve
            .eval_derivs(5, &[0.1, 0.9, 0.3, 0.7, 0.2, 0.6], 0)?;
        show("derivs", &found);
    }
    begin("eval_derivs volume");
    {
        let found = given
            .volume
            .eval_derivs(4, &[0.1, 0.9, 0.3, 0.7, 0.2, 0.6], 0)?;
        show("derivs", &found);
    }
    begin("eval_grid");
    {
        let found = given.surface.eval_grid(&[&[0.1, 0.9], &[0.3, 0.7]], 0)?;
        show("points", &found);
    }
    begin("eval_grid_derivs");
    {
        let found =
            given
                .volume
                .eval_grid_derivs(2, &[&[0.1, 0.9], &[0.3, 0.7], &[0.2, 0.6]], 0)?;
        show("derivs", &found);
    }
    begin("eval_f32");
    {
        let found = given.curve.eval_f32(&[0.1, 0.9, 0.3, 0.7, 0.2, 0.6], 0)?;
        show("points", &found);
    }
    begin("eval_grid_f32");
    {
        let found = given
            .volume
            .eval_grid_f32(&[&[0.1, 0.9], &[0.3, 0.7], &[0.2, 0.6]], 0)?;
        show("points", &found);
    }
    begin("rational_collocation");
    {
        let found = given
            .curve
            .rational_collocation(&[], &[0.1, 0.9, 0.3, 0.7, 0.2, 0.6], 0)?;
        show("values", &found.values);
        show("columns", &found.columns);
        show("row_pointers", &found.row_pointers);
    }
    begin("rational_collocation of derivatives");
    {
        let found = given
            .curve
            .rational_collocation(&[2], &[0.1, 0.9, 0.3, 0.7, 0.2, 0.6], 0)?;
        show("values", &found.values);
        show("columns", &found.columns);
        show("row_pointers", &found.row_pointers);
    }
    begin("hull_size");
    {
        let found = given.curve.hull_size(&[0.1, 0.9, 0.3, 0.7, 0.2, 0.6], 0)?;
        show("sizes", &found);
    }
    begin("hull_size signed");
    {
        let found = given
            .homogeneous
            .hull_size(&[0.1, 0.9, 0.3, 0.7, 0.2, 0.6], 0)?;
        show("sizes", &found);
    }
    begin("surface_eval_frames");
    {
        let found = given
            .surface
            .surface_frames(&[0.1, 0.9, 0.3, 0.7, 0.2, 0.6], 0)?;
        show("points", &found.points);
        show("du", &found.du);
        show("dv", &found.dv);
        show("normals", &found.normals);
        show("status", &found.status);
    }
    begin("surface_eval_grid_frames");
    {
        let found = given
            .surface
            .surface_grid_frames(&[&[0.1, 0.9], &[0.3, 0.7]], 0)?;
        show("points", &found.points);
        show("du", &found.du);
        show("dv", &found.dv);
        show("normals", &found.normals);
        show("status", &found.status);
    }
    begin("surface_eval_curvatures");
    {
        let found = given
            .surface
            .surface_curvatures(&[0.1, 0.9, 0.3, 0.7, 0.2, 0.6], 0)?;
        show("principal", &found.principal);
        show("directions", &found.directions);
        show("mean", &found.mean);
        show("gaussian", &found.gaussian);
        show("status", &found.status);
    }
    begin("curve_eval_frames");
    {
        let found = given
            .curve
            .curve_frames(&[0.1, 0.9, 0.3, 0.7, 0.2, 0.6], 0)?;
        show("points", &found.points);
        show("tangents", &found.tangents);
        show("normals", &found.normals);
        show("binormals", &found.binormals);
        show("curvatures", &found.curvatures);
        show("torsions", &found.torsions);
        show("status", &found.status);
    }
    begin("curve_eval_frames in space");
    {
        let found = given
            .twist
            .curve_frames(&[0.1, 0.9, 0.3, 0.7, 0.2, 0.6], 0)?;
        show("points", &found.points);
        show("tangents", &found.tangents);
        show("normals", &found.normals);
        show("binormals", &found.binormals);
        show("curvatures", &found.curvatures);
        show("torsions", &found.torsions);
        show("status", &found.status);
    }
    begin("curve_rotation_minimizing_frames");
    {
        let found = given.twist.rotation_minimizing_frames(
            &[0.1, 0.9, 0.3, 0.7, 0.2, 0.6],
            Some(&[0.0, 1.0, 2.0]),
            0,
        )?;
        show("points", &found.points);
        show("tangents", &found.tangents);
        show("normals", &found.normals);
        show("binormals", &found.binormals);
        show("status", &found.status);
    }
    begin("weight_points");
    {
        let found = given.surface.weight_points(1, &[0.1, 0.9])?;
        show("at_zero", &found.at_zero);
        show("at_one", &found.at_one);
        show("at_weight", &found.at_weight);
    }
    begin("weight_cross_ratio");
    {
        let found = nurbs::weight_cross_ratio(&[0.1], &[0.9], &[0.3], &[0.7])?;
        show("weight", &found);
    }
    begin("most_influential");
    {
        let found = given
            .surface
            .most_influential(&[0.1, 0.9, 0.3, 0.7, 0.2, 0.6])?;
        for row in &found {
            show("indices", &row.index);
            show("influences", &row.influence);
        }
    }
    begin("blossom");
    {
        let found = given.curve.blossom(&[0.1], &[0.3, 0.6], 0)?;
        show("values", &found);
    }
    begin("collocation");
    {
        let found = nurbs::collocation(
            &[2, 1],
            &[
                &[0.0, 0.0, 0.0, 1.0, 1.0, 1.0],
                &[0.0, 0.0, 1.0, 2.0, 3.0, 3.0],
            ],
            &[],
            &[0.1, 0.9, 0.3, 0.7, 0.2, 0.6],
            0,
        )?;
        show("values", &found.values);
        show("columns", &found.columns);
        show("row_pointers", &found.row_pointers);
    }
    begin("collocation of derivatives");
    {
        let found = nurbs::collocation(
            &[2, 1],
            &[
                &[0.0, 0.0, 0.0, 1.0, 1.0, 1.0],
                &[0.0, 0.0, 1.0, 2.0, 3.0, 3.0],
            ],
            &[1, 0],
            &[0.1, 0.9, 0.3, 0.7, 0.2, 0.6],
            0,
        )?;
        show("values", &found.values);
        show("columns", &found.columns);
        show("row_pointers", &found.row_pointers);
    }
    begin("eval_adjoint");
    {
        let found = given.curve.eval_adjoint(
            0,
            &[0.1, 0.9, 0.3, 0.7, 0.2, 0.6],
            &[1.0, 2.0, 3.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
            0,
        )?;
        show("grad_points", &found.points);
        show("grad_weights", &found.weights);
        show("grad_params", &found.params);
    }
    begin("eval_adjoint points");
    {
        let found = given.surface.eval_adjoint(
            1,
            &[0.1, 0.9, 0.3, 0.7, 0.2, 0.6],
            &[
                1.0, 2.0, 3.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
                0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
            ],
            0,
        )?;
        show("grad_points", &found.points);
        show("grad_weights", &found.weights);
        show("grad_params", &found.params);
    }
    begin("eval_adjoint_knots");
    {
        let found = given.curve.eval_adjoint_knots(
            0,
            0,
            &[0.1, 0.9, 0.3, 0.7, 0.2, 0.6],
            &[1.0, 2.0, 3.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
            0,
        )?;
        show("grad_knots", &found);
    }
    begin("eval_adjoint_knots surface");
    {
        let found = given.surface.eval_adjoint_knots(
            1,
            1,
            &[0.1, 0.9, 0.3, 0.7, 0.2, 0.6],
            &[
                1.0, 2.0, 3.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
                0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
            ],
            0,
        )?;
        show("grad_knots", &found);
    }
    Ok(())
}

fn form(given: &Given) -> nurbs::Result<()> {
    begin("iso curve");
    {
        let found = given.surface.iso(0, 0.3, 0)?;
        show("out", &found);
    }
    begin("iso surface");
    {
        let found = given.volume.iso(1, 0.3, 0)?;
        show("out", &found);
    }
    begin("insert_knot");
    {
        let found = given.curve.insert_knot(0, 0.3, 2)?;
        show("out", &found);
    }
    begin("insert_knot periodic");
    {
        let found = given.r#loop.insert_knot(0, 2.5, 2)?;
        show("out", &found);
    }
    begin("insert_knot surface");
    {
        let found = given.surface.insert_knot(1, 1.5, 1)?;
        show("out", &found);
    }
    begin("insert_knot 0 times");
    {
        let found = given.surface.insert_knot(1, 1.5, 0)?;
        show("out", &found);
    }
    begin("refine");
    {
        let found = given.curve.refine(0, &[0.3, 0.6])?;
        show("out", &found);
    }
    begin("refine_uniform");
    {
        let found = given.r#loop.refine_uniform(0, 3)?;
        show("out", &found);
    }
    begin("extract");
    {
        let found = given.curve.extract(&[0.3], &[0.6])?;
        show("out", &found);
    }
    begin("split");
    {
        let found = given.curve.split(0, 0.3)?;
        show("lower", &found.0);
        show("upper", &found.1);
    }
    begin("clamp_ends");
    {
        let found = given.r#loop.clamp(0, 3)?;
        show("out", &found);
    }
    begin("unclamp");
    {
        let found = given.volume.unclamp(2, 3)?;
        show("out", &found);
    }
    begin("move_seam");
    {
        let found = given.r#loop.move_seam(0, 2.5)?;
        show("out", &found);
    }
    begin("join");
    {
        let found = nurbs::join(&[&given.curve, &given.curve], 0, 9.0, 0)?;
        show("out", &found.spline);
        show("gap", &found.gap);
    }
    begin("join with gaps");
    {
        let found = nurbs::join(&[&given.curve, &given.curve], 0, 9.0, 67108864)?;
        show("out", &found.spline);
        show("gap", &found.gap);
    }
    begin("snap_knots");
    {
        let found = given.r#loop.snap_knots(0, 0.26)?;
        show("out", &found.0);
        show("deviation", &found.1);
    }
    begin("extend");
    {
        let found = given.surface.extend(0, 0, 1.0, 1)?;
        show("out", &found);
    }
    begin("make_periodic");
    {
        let found = given.curve.make_periodic(0, 1.0)?;
        show("out", &found.spline);
        show("deviation", &found.deviation);
        show("order", &found.order);
    }
    begin("make_compatible");
    {
        let found = nurbs::make_compatible(&[&given.curve, &given.r#loop], 0.01, 1073741824)?;
        show("out", &found.0);
        show("deviation", &found.1);
    }
    begin("remove_knot");
    {
        let found = given.curve.remove_knot(0, 0.5, 1, 9.0)?;
        show("out", &found.spline);
        show("removed", &found.removed);
        show("bound", &found.bound);
    }
    begin("remove_knot periodic");
    {
        let found = given.r#loop.remove_knot(0, 3.0, 1, 9.0)?;
        show("out", &found.spline);
        show("removed", &found.removed);
        show("bound", &found.bound);
    }
    begin("reduce_knots");
    {
        let found = given.curve.reduce_knots(-1, 9.0)?;
        show("out", &found.spline);
        show("bound", &found.bound);
    }
    begin("reduce_degree");
    {
        let found = given.r#loop.reduce_degree(0, 1)?;
        show("out", &found.spline);
        show("bound", &found.bound);
    }
    begin("simplify");
    {
        let found = given.curve.simplify(9.0)?;
        show("out", &found.spline);
        show("bound", &found.bound);
    }
    begin("elevate");
    {
        let found = given.curve.elevate(0, 2)?;
        show("out", &found);
    }
    begin("elevate periodic");
    {
        let found = given.r#loop.elevate(0, 2)?;
        show("out", &found);
    }
    begin("elevate homogeneous");
    {
        let found = given.homogeneous.elevate(0, 1)?;
        show("out", &found);
    }
    begin("reverse");
    {
        let found = given.curve.reverse(0, 33554432)?;
        show("out", &found);
    }
    begin("transpose");
    {
        let found = given.volume.transpose(&[2, 0, 1])?;
        show("out", &found);
    }
    begin("reparametrize");
    {
        let found = given.r#loop.reparametrize(0, 0.0, 1.0)?;
        show("out", &found);
    }
    begin("reparametrize_moebius");
    {
        let found = given.curve.reparametrize_moebius(0, 2.0)?;
        show("out", &found);
    }
    begin("derivative");
    {
        let found = given.r#loop.derivative(0, 1)?;
        show("out", &found);
    }
    begin("derivative rational");
    {
        let found = given.curve.derivative(0, 2)?;
        show("out", &found);
    }
    begin("derivative beyond the degree");
    {
        let found = given.r#loop.derivative(0, 9)?;
        show("out", &found);
    }
    begin("antiderivative");
    {
        let found = given.volume.antiderivative(1)?;
        show("out", &found);
    }
    begin("product");
    {
        let found = given.curve.product(&given.curve, 0)?;
        show("out", &found);
    }
    begin("product periodic");
    {
        let found = given.r#loop.product(&given.r#loop, 0)?;
        show("out", &found);
    }
    begin("product volume");
    {
        let found = given.volume.product(&given.volume, 134217728)?;
        show("out", &found);
    }
    begin("compose");
    {
        let ramp = Spline::bezier(&[2], 1, &[0.0, 0.25, 1.0], None)?;
        let found = given.curve.compose(&ramp)?;
        show("out", &found);
    }
    begin("compose around a loop");
    {
        let round = Spline::bezier(&[2], 1, &[0.0, 2.0, 9.0], None)?;
        let found = given.r#loop.compose(&round)?;
        show("out", &found);
    }
    begin("compose on a surface");
    {
        let diagonal = Spline::bezier(&[2], 2, &[0.0, 0.0, 1.0, 0.0, 1.0, 1.0], None)?;
        let found = given.surface.compose(&diagonal)?;
        show("out", &found);
    }
    begin("sum");
    {
        let found = given.r#loop.sum(1.0, &given.r#loop, 2.0)?;
        show("out", &found);
    }
    begin("sum rational");
    {
        let half = given.curve.reparametrize_moebius(0, 2.0)?;
        let found = given.curve.sum(1.0, &half, 1.0)?;
        show("out", &found);
    }
    begin("reduce_knots_with");
    {
        let found = given
            .curve
            .reduce_knots_with(-1, 9.0, &mut Call::new().progress(|_| true))?;
        show("out", &found.spline);
        show("bound", &found.bound);
    }
    begin("reduce_degree_with");
    {
        let found = given
            .r#loop
            .reduce_degree_with(0, 1, &mut Call::new().progress(|_| true))?;
        show("out", &found.spline);
        show("bound", &found.bound);
    }
    begin("simplify_with");
    {
        let found = given
            .curve
            .simplify_with(9.0, &mut Call::new().progress(|_| true))?;
        show("out", &found.spline);
        show("bound", &found.bound);
    }
    begin("product_with");
    {
        let found =
            given
                .curve
                .product_with(&given.curve, 0, &mut Call::new().progress(|_| true))?;
        show("out", &found);
    }
    begin("product_with periodic");
    {
        let found =
            given
                .r#loop
                .product_with(&given.r#loop, 0, &mut Call::new().progress(|_| true))?;
        show("out", &found);
    }
    begin("product_with volume");
    {
        let found = given.volume.product_with(
            &given.volume,
            134217728,
            &mut Call::new().progress(|_| true),
        )?;
        show("out", &found);
    }
    begin("compose_with");
    {
        let ramp = Spline::bezier(&[2], 1, &[0.0, 0.25, 1.0], None)?;
        let found = given
            .curve
            .compose_with(&ramp, &mut Call::new().progress(|_| true))?;
        show("out", &found);
    }
    begin("compose_with around a loop");
    {
        let round = Spline::bezier(&[2], 1, &[0.0, 2.0, 9.0], None)?;
        let found = given
            .r#loop
            .compose_with(&round, &mut Call::new().progress(|_| true))?;
        show("out", &found);
    }
    begin("compose_with on a surface");
    {
        let diagonal = Spline::bezier(&[2], 2, &[0.0, 0.0, 1.0, 0.0, 1.0, 1.0], None)?;
        let found = given
            .surface
            .compose_with(&diagonal, &mut Call::new().progress(|_| true))?;
        show("out", &found);
    }
    Ok(())
}

fn query(given: &Given) -> nurbs::Result<()> {
    begin("deviation");
    {
        let found = given.surface.deviation(&given.surface)?;
        show("at_least", &found.0);
        show("at_most", &found.1);
    }
    begin("curve_shape_factor");
    {
        let found = given.segment.shape_factor()?;
        show("factor", &found.0);
        show("type", &found.1);
    }
    begin("conic_axes");
    {
        let found = nurbs::conic_axes(&[1.0, 0.0, 4.0, 0.0, 0.0, -4.0])?;
        show("type", &found.kind);
        show("origin", &found.origin);
        show("x", &found.x);
        show("sizes", &found.sizes);
    }
    begin("box");
    {
        let found = given.volume.bounding_box(0.001, &[])?;
        show("lower", &found.lower);
        show("upper", &found.upper);
        show("gap", &found.gap);
    }
    begin("box of a part");
    {
        let found = given.surface.bounding_box(0.001, &[0.0, 1.0, 0.0, 3.0])?;
        show("lower", &found.lower);
        show("upper", &found.upper);
        show("gap", &found.gap);
    }
    begin("oriented_box");
    {
        let found = given.surface.oriented_box(0.001)?;
        show("center", &found.center);
        show("axes", &found.axes);
        show("half", &found.half);
    }
    begin("tangent_cone");
    {
        let found = given.segment.tangent_cone(0, 0.1, &[])?;
        show("direction", &found.direction);
        show("angle", &found.angle);
    }
    begin("tangent_cone of a part");
    {
        let found = given.curve.tangent_cone(0, 0.1, &[0.3, 0.6])?;
        show("direction", &found.direction);
        show("angle", &found.angle);
    }
    begin("normal_cone");
    {
        let found = given.surface.normal_cone(0.1, &[])?;
        show("direction", &found.direction);
        show("angle", &found.angle);
    }
    begin("normal_cone of a part");
    {
        let found = given.surface.normal_cone(0.1, &[0.0, 1.0, 0.0, 3.0])?;
        show("direction", &found.direction);
        show("angle", &found.angle);
    }
    begin("extreme_point");
    {
        let found = given.curve.extreme_point(&[0.1, 0.9], 1e-06, &[])?;
        show("params", &found.params);
        show("value", &found.value);
        show("bound", &found.bound);
    }
    begin("extreme_point of a part");
    {
        let found = given.curve.extreme_point(&[0.1, 0.9], 1e-06, &[0.3, 0.6])?;
        show("params", &found.params);
        show("value", &found.value);
        show("bound", &found.bound);
    }
    begin("closest_points");
    {
        let found = given.curve.closest_points(
            &[0.1, 0.9],
            nurbs::Search {
                tolerance: 0.0,
                budget: 0,
                flags: 0,
                ..Default::default()
            },
        )?;
        show("params", &found.params);
        show("feet", &found.points);
        show("distances", &found.distances);
        show("status", &found.status);
    }
    begin("closest_adjoint");
    {
        let found =
            given
                .curve
                .closest_adjoint(&[0.1, 0.9], &[0.3], &[1.0], &[1.0, 2.0], &[1.0], 0)?;
        show("grad_points", &found.points);
        show("grad_weights", &found.weights);
        show("grad_queries", &found.queries);
        show("status", &found.status);
    }
    begin("closest_points of a part");
    {
        let found = given.surface.closest_points(
            &[0.1, 0.9, 0.3, 0.7, 0.2, 0.6],
            nurbs::Search {
                range: &[0.0, 1.0, 0.0, 3.0],
                tolerance: 0.0,
                budget: 0,
                flags: 0,
            },
        )?;
        show("params", &found.params);
        show("feet", &found.points);
        show("distances", &found.distances);
        show("status", &found.status);
    }
    begin("farthest_points");
    {
        let found = given.curve.farthest_points(
            &[0.1, 0.9],
            nurbs::Search {
                tolerance: 0.0,
                budget: 0,
                flags: 0,
                ..Default::default()
            },
        )?;
        show("params", &found.params);
        show("feet", &found.points);
        show("distances", &found.distances);
        show("status", &found.status);
    }
    begin("farthest_points of a part");
    {
        let found = given.curve.farthest_points(
            &[0.1, 0.9, 0.3, 0.7, 0.2, 0.6],
            nurbs::Search {
                range: &[0.3, 0.6],
                tolerance: 0.0,
                budget: 0,
                flags: 0,
            },
        )?;
        show("params", &found.params);
        show("feet", &found.points);
        show("distances", &found.distances);
        show("status", &found.status);
    }
    begin("closest_local");
    {
        let found =
            given
                .curve
                .closest_local(&[0.1, 0.9, 0.3, 0.7, 0.2, 0.6], &[0.1, 0.9, 0.3], 0)?;
        show("params", &found.params);
        show("feet", &found.points);
        show("distances", &found.distances);
        show("status", &found.status);
    }
    begin("closest_local params");
    {
        let found = given.curve.closest_local(&[0.1, 0.9], &[0.1], 0)?;
        show("params", &found.params);
        show("feet", &found.points);
        show("distances", &found.distances);
        show("status", &found.status);
    }
    begin("curve_signed_distances");
    {
        let found = given.curve.signed_distances(
            &[0.1, 0.9, 0.3, 0.7, 0.2, 0.6],
            nurbs::Search {
                tolerance: 0.0,
                budget: 0,
                flags: 0,
                ..Default::default()
            },
        )?;
        show("distances", &found.distances);
        show("params", &found.params);
        show("status", &found.status);
    }
    begin("curve_signed_distances alone");
    {
        let found = given.curve.signed_distances(
            &[0.1, 0.9],
            nurbs::Search {
                tolerance: 0.0,
                budget: 0,
                flags: 0,
                ..Default::default()
            },
        )?;
        show("distances", &found.distances);
        show("params", &found.params);
        show("status", &found.status);
    }
    begin("closest_all");
    {
        let found = given.curve.closest_all(
            &[0.1, 0.9],
            nurbs::Search {
                tolerance: 0.0,
                budget: 0,
                ..Default::default()
            },
        )?;
        show("params", &found.params);
        show("distances", &found.distances);
        show("status", &found.status);
    }
    begin("closest_all inside");
    {
        let found = given.curve.closest_all(
            &[0.1, 0.9],
            nurbs::Search {
                range: &[0.0, 1.0],
                tolerance: 0.0,
                budget: 0,
                ..Default::default()
            },
        )?;
        show("params", &found.params);
        show("distances", &found.distances);
        show("status", &found.status);
    }
    begin("critical_points");
    {
        let found = given.curve.critical_points(
            &[0.1, 0.9],
            nurbs::Search {
                tolerance: 0.0,
                budget: 0,
                ..Default::default()
            },
        )?;
        show("params", &found.params);
        show("distances", &found.distances);
        show("kinds", &found.kinds);
        show("status", &found.status);
    }
    begin("critical_points inside");
    {
        let found = given.curve.critical_points(
            &[0.1, 0.9],
            nurbs::Search {
                range: &[0.0, 1.0],
                tolerance: 0.0,
                budget: 0,
                ..Default::default()
            },
        )?;
        show("params", &found.params);
        show("distances", &found.distances);
        show("kinds", &found.kinds);
        show("status", &found.status);
    }
    begin("distance");
    {
        let found = given.curve.distance(&given.r#loop, 1e-06, 0)?;
        show("at_least", &found.at_least);
        show("at_most", &found.at_most);
        show("params_a", &found.params[0]);
        show("params_b", &found.params[1]);
        show("status", &found.status);
    }
    begin("hausdorff_distance");
    {
        let found = given.curve.hausdorff_distance(&given.r#loop, 0.1, 0)?;
        show("at_least", &found.at_least);
        show("at_most", &found.at_most);
        show("params_a", &found.params[0]);
        show("params_b", &found.params[1]);
        show("status", &found.status);
    }
    begin("curve_features count");
    {
        let found = given.twist.features(127)?;
        for row in &found.found {
            show("params", &row.param);
            show("found", &row.kind);
            show("values", &row.value);
        }
        show("complete", &found.complete);
    }
    begin("curve_features periodic");
    {
        let found = given.r#loop.features(63)?;
        for row in &found.found {
            show("params", &row.param);
            show("found", &row.kind);
            show("values", &row.value);
        }
        show("complete", &found.complete);
    }
    begin("extrema");
    {
        let heights = Spline::create(
            &[1, 1],
            &[2, 2],
            &[0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 3.0, 3.0],
            1,
            &[0.0, 1.0, 1.0, 2.0],
            None,
            0,
        )?;
        let found = heights.extrema(31)?;
        show("params", &found.params);
        show("values", &found.values);
        show("found", &found.found);
        show("boxes", &found.boxes);
        show("complete", &found.complete);
    }
    begin("extrema count");
    {
        let ramp = Spline::bezier(&[2], 1, &[0.0, 0.25, 1.0], None)?;
        let found = ramp.extrema(3)?;
        show("params", &found.params);
        show("values", &found.values);
        show("found", &found.found);
        show("boxes", &found.boxes);
        show("complete", &found.complete);
    }
    begin("mesh_curve");
    {
        let found = given.curve.mesh_curve(1.0, 2.0, 3.0)?;
        show("params", &found.params);
        show("points", &found.points);
        show("bound", &found.bound);
        show("reached", &found.reached);
    }
    begin("mesh_curve count");
    {
        let found = given.r#loop.mesh_curve(0.5, 0.0, 0.0)?;
        show("params", &found.params);
        show("points", &found.points);
        show("bound", &found.bound);
        show("reached", &found.reached);
    }
    begin("curve_monotone_pieces");
    {
        let found = given.curve.monotone_pieces(&[0.1, 0.9])?;
        for row in &found.pieces {
            show("starts", &row.0);
            show("signs", &row.1);
        }
        show("complete", &found.complete);
    }
    begin("curve_convexity");
    {
        let found = given.curve.convexity()?;
        show("convexity", &found);
    }
    begin("straightness");
    {
        let found = given.segment.straightness()?;
        show("origin", &found.origin);
        show("direction", &found.direction);
        show("bound", &found.bound);
    }
    begin("planarity");
    {
        let found = given.surface.planarity()?;
        show("origin", &found.origin);
        show("normal", &found.normal);
        show("bound", &found.bound);
    }
    begin("boundary_contacts");
    {
        let found = given.surface.boundary_contacts(0.1)?;
        show("closed", &found.closed);
        show("gaps", &found.gaps);
        show("collapsed", &found.collapsed);
        show("sizes", &found.sizes);
    }
    begin("singular_points");
    {
        let found = given.surface.singular_points(0.1)?;
        show("params", &found.params);
        show("boxes", &found.boxes);
        show("complete", &found.complete);
    }
    begin("fold_test");
    {
        let found = given.surface.fold_test(&[])?;
        show("result", &found.result);
        show("positive", &found.positive);
        show("negative", &found.negative);
    }
    begin("fold_pieces");
    {
        let found = given.surface.fold_pieces(&[])?;
        show("folds", &found.folds);
        show("signs", &found.signs);
    }
    begin("roots");
    {
        let ramp = Spline::bezier(&[2], 1, &[0.0, 0.25, 1.0], None)?;
        let found = ramp.roots(0.5, 0.0)?;
        show("params", &found.params);
        show("kinds", &found.kinds);
        show("ranges", &found.ranges);
        show("complete", &found.complete);
    }
    begin("roots count");
    {
        let round = Spline::bezier(&[2], 1, &[0.0, 2.0, 9.0], None)?;
        let found = round.roots(3.0, 1e-09)?;
        show("params", &found.params);
        show("kinds", &found.kinds);
        show("ranges", &found.ranges);
        show("complete", &found.complete);
    }
    begin("curve_level");
    {
        let found = given.curve.curve_level(1, &[0.1, 0.9, -0.3], 1e-09)?;
        show("params", &found.params);
        show("kinds", &found.kinds);
        show("ranges", &found.ranges);
        show("complete", &found.complete);
    }
    begin("surface_rays");
    {
        let found = given.surface.rays(
            &[0.1, 0.2, 5.0, 0.3, 0.4, 6.0],
            &[0.0, 0.0, -1.0, 0.1, 0.1, -1.0],
        )?;
        show("params", &found.params);
        show("distances", &found.distances);
        show("status", &found.status);
    }
    begin("surface_rays distances");
    {
        let found = given.surface.rays(&[0.1, 0.2, 5.0], &[0.0, 0.0, -1.0])?;
        show("params", &found.params);
        show("distances", &found.distances);
        show("status", &found.status);
    }
    begin("surface_ray_hits within");
    {
        let found = given
            .surface
            .ray_hits(&[0.1, 0.2, 5.0], &[0.0, 0.0, -1.0], &[-1.0, 20.0])?;
        show("params", &found.params);
        show("distances", &found.distances);
        show("kinds", &found.kinds);
        show("complete", &found.complete);
    }
    begin("surface_ray_hits");
    {
        let found = given
            .surface
            .ray_hits(&[0.1, 0.2, 5.0], &[0.0, 0.0, -1.0], &[])?;
        show("params", &found.params);
        show("distances", &found.distances);
        show("kinds", &found.kinds);
        show("complete", &found.complete);
    }
    begin("surfaces_common_points");
    {
        let wall = Spline::bezier(
            &[1, 1],
            3,
            &[
                0.3, -1.0, -1.0, 0.3, -1.0, 9.0, 0.4, 9.0, -1.0, 0.4, 9.0, 9.0,
            ],
            None,
        )?;
        let sphere = Spline::sphere(
            nurbs::Placement {
                ..Default::default()
            },
            1.0,
            0,
        )?;
        let found = wall.common_points(&given.surface, &sphere, 0.001)?;
        show("params", &found.params);
        show("points", &found.points);
        show("kinds", &found.kinds);
        show("ranges", &found.ranges);
        show("complete", &found.complete);
    }
    begin("curve_surface_intersections");
    {
        let sphere = Spline::sphere(
            nurbs::Placement {
                ..Default::default()
            },
            1.0,
            0,
        )?;
        let found = given.twist.surface_intersections(&sphere, 1e-09)?;
        show("params_curve", &found.params_curve);
        show("params_surface", &found.params_surface);
        show("kinds", &found.kinds);
        show("ranges_curve", &found.ranges_curve);
        show("ranges_surface", &found.ranges_surface);
        show("complete", &found.complete);
    }
    begin("face_rays");
    {
        let found = given.face.rays(
            &[0.5, 1.2, 9.0, 0.3, 0.4, 6.0],
            &[0.0, 0.0, -1.0, 0.1, 0.1, -1.0],
        )?;
        show("params", &found.params);
        show("distances", &found.distances);
        show("status", &found.status);
    }
    begin("face_rays distances");
    {
        let found = given.face.rays(&[0.5, 1.2, 9.0], &[0.0, 0.0, -1.0])?;
        show("params", &found.params);
        show("distances", &found.distances);
        show("status", &found.status);
    }
    begin("face_closest_points");
    {
        let found = given
            .face
            .closest_points(&[0.5, 1.2, 9.0, 0.3, 0.4, 6.0], 1e-06)?;
        show("params", &found.params);
        show("feet", &found.points);
        show("distances", &found.distances);
        show("status", &found.status);
    }
    begin("face_closest_points alone");
    {
        let found = given.face.closest_points(&[0.1, 0.2, 0.3], 0.0)?;
        show("params", &found.params);
        show("feet", &found.points);
        show("distances", &found.distances);
        show("status", &found.status);
    }
    begin("face_distance");
    {
        let sphere = Spline::sphere(
            nurbs::Placement {
                ..Default::default()
            },
            1.0,
            0,
        )?;
        let ball_face = Face::create(&sphere, &[], &[], &[], &[], 1e-09, 0)?;
        let found = given.face.distance(&ball_face, 4.0)?;
        show("at_least", &found.at_least);
        show("at_most", &found.at_most);
        show("params_a", &found.params_a);
        show("params_b", &found.params_b);
        show("status", &found.status);
    }
    begin("face_hausdorff_distance");
    {
        let sphere = Spline::sphere(
            nurbs::Placement {
                ..Default::default()
            },
            1.0,
            0,
        )?;
        let ball_face = Face::create(&sphere, &[], &[], &[], &[], 1e-09, 0)?;
        let found = given.face.hausdorff_distance(&ball_face, 4.0)?;
        show("at_least", &found.at_least);
        show("at_most", &found.at_most);
        show("params_a", &found.params_a);
        show("params_b", &found.params_b);
        show("status", &found.status);
    }
    begin("model_instances");
    {
        let found = given.model.instances()?;
        show("parents", &found.parents);
        show("last_uses", &found.uses);
        show("own_parts", &found.parts);
        show("placements", &found.placements);
    }
    begin("model_rays");
    {
        let found = given.model.rays(
            &[0.5, 1.2, 9.0, 0.3, 0.4, 6.0],
            &[0.0, 0.0, -1.0, 0.1, 0.1, -1.0],
        )?;
        show("params", &found.params);
        show("distances", &found.distances);
        show("status", &found.status);
        show("places", &found.places);
    }
    begin("model_rays places");
    {
        let sphere = Spline::sphere(
            nurbs::Placement {
                ..Default::default()
            },
            1.0,
            0,
        )?;
        let ball_face = Face::create(&sphere, &[], &[], &[], &[], 1e-09, 0)?;
        let ball = Model::create(&[&ball_face], 1.0)?;
        let found = ball.rays(&[0.1, 0.2, 5.0], &[0.0, 0.0, -1.0])?;
        show("params", &found.params);
        show("distances", &found.distances);
        show("status", &found.status);
        show("places", &found.places);
    }
    begin("model_ray_hits within");
    {
        let found = given
            .model
            .ray_hits(&[0.5, 1.2, 9.0], &[0.0, 0.0, -1.0], &[-1.0, 20.0])?;
        show("params", &found.params);
        show("distances", &found.distances);
        show("kinds", &found.kinds);
        show("places", &found.places);
        show("complete", &found.complete);
    }
    begin("model_ray_hits");
    {
        let sphere = Spline::sphere(
            nurbs::Placement {
                ..Default::default()
            },
            1.0,
            0,
        )?;
        let ball_face = Face::create(&sphere, &[], &[], &[], &[], 1e-09, 0)?;
        let ball = Model::create(&[&ball_face], 1.0)?;
        let found = ball.ray_hits(&[0.1, 0.2, 5.0], &[0.0, 0.0, -1.0], &[])?;
        show("params", &found.params);
        show("distances", &found.distances);
        show("kinds", &found.kinds);
        show("places", &found.places);
        show("complete", &found.complete);
    }
    begin("model_closest_points");
    {
        let found = given
            .model
            .closest_points(&[0.5, 1.2, 9.0, 0.3, 0.4, 6.0], 1e-06)?;
        show("params", &found.params);
        show("feet", &found.points);
        show("distances", &found.distances);
        show("status", &found.status);
        show("places", &found.places);
    }
    begin("model_closest_points alone");
    {
        let sphere = Spline::sphere(
            nurbs::Placement {
                ..Default::default()
            },
            1.0,
            0,
        )?;
        let ball_face = Face::create(&sphere, &[], &[], &[], &[], 1e-09, 0)?;
        let ball = Model::create(&[&ball_face], 1.0)?;
        let found = ball.closest_points(&[0.1, 0.2, 3.0], 0.0)?;
        show("params", &found.params);
        show("feet", &found.points);
        show("distances", &found.distances);
        show("status", &found.status);
        show("places", &found.places);
    }
    begin("model_classify");
    {
        let sphere = Spline::sphere(
            nurbs::Placement {
                ..Default::default()
            },
            1.0,
            0,
        )?;
        let ball_face = Face::create(&sphere, &[], &[], &[], &[], 1e-09, 0)?;
        let ball = Model::create(&[&ball_face], 1.0)?;
        let found = ball.classify(&[0.1, 0.2, 0.3, 1.0, 1.0, 1.0], 0.0)?;
        show("sides", &found);
    }
    begin("model_classify near");
    {
        let sphere = Spline::sphere(
            nurbs::Placement {
                ..Default::default()
            },
            1.0,
            0,
        )?;
        let ball_face = Face::create(&sphere, &[], &[], &[], &[], 1e-09, 0)?;
        let ball = Model::create(&[&ball_face], 1.0)?;
        let found = ball.classify(&[0.1, 0.2, 0.3, 0.0, 0.6, 0.8], 0.001)?;
        show("sides", &found);
    }
    begin("model_area");
    {
        let sphere = Spline::sphere(
            nurbs::Placement {
                ..Default::default()
            },
            1.0,
            0,
        )?;
        let ball_face = Face::create(&sphere, &[], &[], &[], &[], 1e-09, 0)?;
        let ball = Model::create(&[&ball_face], 1.0)?;
        let found = ball.area(1e-06)?;
        show("area", &found.value);
        show("error", &found.error);
    }
    begin("model_volume");
    {
        let sphere = Spline::sphere(
            nurbs::Placement {
                ..Default::default()
            },
            1.0,
            0,
        )?;
        let ball_face = Face::create(&sphere, &[], &[], &[], &[], 1e-09, 0)?;
        let ball = Model::create(&[&ball_face], 1.0)?;
        let found = ball.volume(1e-06)?;
        show("volume", &found.volume);
        show("centroid", &found.centroid);
        show("inertia", &found.inertia);
        show("openness", &found.openness);
        show("error", &found.error);
    }
    begin("model_volume alone");
    {
        let sphere = Spline::sphere(
            nurbs::Placement {
                ..Default::default()
            },
            1.0,
            0,
        )?;
        let ball_face = Face::create(&sphere, &[], &[], &[], &[], 1e-09, 0)?;
        let ball = Model::create(&[&ball_face], 1.0)?;
        let found = ball.volume(1e-06)?;
        show("volume", &found.volume);
        show("centroid", &found.centroid);
        show("inertia", &found.inertia);
        show("openness", &found.openness);
        show("error", &found.error);
    }
    begin("curve_self_intersections");
    {
        let found = given.curve.self_intersections(1e-09)?;
        show("params_a", &found.params_a);
        show("params_b", &found.params_b);
        show("kinds", &found.kinds);
        show("ranges_a", &found.ranges_a);
        show("ranges_b", &found.ranges_b);
        show("complete", &found.complete);
    }
    begin("curve_intersections");
    {
        let found = given.curve.curve_intersections(&given.segment, 1e-09)?;
        show("params_a", &found.params_a);
        show("params_b", &found.params_b);
        show("kinds", &found.kinds);
        show("ranges_a", &found.ranges_a);
        show("ranges_b", &found.ranges_b);
        show("complete", &found.complete);
    }
    begin("curve_level conic");
    {
        let found = given
            .r#loop
            .curve_level(2, &[1.0, 0.0, 0.0, 1.0, 0.0, -0.5], 0.0)?;
        show("params", &found.params);
        show("kinds", &found.kinds);
        show("ranges", &found.ranges);
        show("complete", &found.complete);
    }
    begin("fold_test seen from above");
    {
        let found = given.surface.fold_test(&[1.0, 2.0, 3.0])?;
        show("result", &found.result);
        show("positive", &found.positive);
        show("negative", &found.negative);
    }
    begin("fold_pieces seen from above");
    {
        let found = given.surface.fold_pieces(&[1.0, 2.0, 3.0])?;
        show("folds", &found.folds);
        show("signs", &found.signs);
    }
    begin("recognize curve");
    {
        let found = given.curve.recognize(1e-09)?;
        show("shape", &found.shape);
        show("placement", &found.origin);
        show("placement", &found.axis);
        show("placement", &found.x);
        show("sizes", &found.sizes);
        show("deviation", &found.deviation);
    }
    begin("recognize surface");
    {
        let found = given.surface.recognize(0.2)?;
        show("shape", &found.shape);
        show("placement", &found.origin);
        show("placement", &found.axis);
        show("placement", &found.x);
        show("sizes", &found.sizes);
        show("deviation", &found.deviation);
    }
    begin("length_adjoint");
    {
        let found = given.curve.length_adjoint(1e-06, 1.0, &[], 0)?;
        show("grad_points", &found.points);
        show("grad_weights", &found.weights);
        show("error", &found.error);
    }
    begin("length_adjoint of a part");
    {
        let found = given.curve.length_adjoint(1e-06, 1.0, &[0.3, 0.6], 0)?;
        show("grad_points", &found.points);
        show("grad_weights", &found.weights);
        show("error", &found.error);
    }
    begin("curve_length");
    {
        let found = given.curve.length(1e-09, &[])?;
        show("length", &found.value);
        show("error", &found.error);
    }
    begin("curve_length of a part");
    {
        let found = given.curve.length(1e-09, &[0.3, 0.6])?;
        show("length", &found.value);
        show("error", &found.error);
    }
    begin("curve_lengths");
    {
        let found = given.r#loop.lengths(&[4.0], 1e-09)?;
        show("lengths", &found);
    }
    begin("curve_params_at_lengths");
    {
        let found = given.curve.params_at_lengths(&[4.0], 1e-09, 0)?;
        show("params", &found);
    }
    begin("curve_divide");
    {
        let found = given.curve.divide(5, 1e-09, 0, &[])?;
        show("params", &found.params);
        show("size", &found.size);
    }
    begin("curve_divide a part");
    {
        let found = given.curve.divide(5, 1e-09, 0, &[0.3, 0.6])?;
        show("params", &found.params);
        show("size", &found.size);
    }
    begin("curve_divide chords");
    {
        let found = given.curve.divide(5, 1e-09, 33554432, &[])?;
        show("params", &found.params);
        show("size", &found.size);
    }
    begin("surface_area");
    {
        let found = given.surface.area(1e-09, &[])?;
        show("area", &found.value);
        show("error", &found.error);
    }
    begin("surface_area of a part");
    {
        let found = given.surface.area(1e-09, &[0.0, 1.0, 0.0, 3.0])?;
        show("area", &found.value);
        show("error", &found.error);
    }
    begin("moments");
    {
        let found = given.surface.moments(1e-09)?;
        show("content", &found.content);
        show("centroid", &found.centroid);
        show("inertia", &found.inertia);
        show("error", &found.error);
    }
    begin("enclosed_area");
    {
        let found = nurbs::enclosed_area(&[&given.r#loop], 1e-09, 1e-09)?;
        show("area", &found.area);
        show("centroid", &found.centroid);
        show("inertia", &found.inertia);
        show("error", &found.error);
    }
    begin("enclosed_volume");
    {
        let found = nurbs::enclosed_volume(&[&given.surface], 1e-09)?;
        show("volume", &found.volume);
        show("centroid", &found.centroid);
        show("inertia", &found.inertia);
        show("openness", &found.openness);
        show("error", &found.error);
    }
    begin("enclosed_volume sphere");
    {
        let sphere = Spline::sphere(
            nurbs::Placement {
                ..Default::default()
            },
            1.0,
            0,
        )?;
        let found = nurbs::enclosed_volume(&[&sphere], 1e-06)?;
        show("volume", &found.volume);
        show("centroid", &found.centroid);
        show("inertia", &found.inertia);
        show("openness", &found.openness);
        show("error", &found.error);
    }
    begin("quadrature");
    {
        let found = given.curve.quadrature(2)?;
        show("params", &found.params);
        show("weights", &found.weights);
        show("measures", &found.measures);
    }
    begin("quadrature surface");
    {
        let found = given.surface.quadrature(1)?;
        show("params", &found.params);
        show("weights", &found.weights);
        show("measures", &found.measures);
    }
    begin("coons_gaps");
    {
        let found = nurbs::coons_gaps(
            [&given.curve, &given.curve, &given.r#loop, &given.r#loop],
            Some([&given.curve, &given.curve, &given.r#loop, &given.r#loop]),
        )?;
        show("positions", &found.positions);
        show("tangents", &found.tangents);
        show("twists", &found.twists);
    }
    begin("continuity");
    {
        let found = given.curve.continuity(
            0,
            nurbs::ContinuityTolerances {
                position: 0.0,
                derivative: 0.0,
                angle: 0.0,
            },
        )?;
        for row in &found {
            show("knots", &row.knot);
            show("knot_orders", &row.knot_order);
            show("orders", &row.found.order);
            show("geometric_orders", &row.found.geometric);
            show("position_gaps", &row.found.position_gap);
            show("angles", &row.found.angle);
            show("curvature_gaps", &row.found.curvature_gap);
        }
    }
    begin("continuity count");
    {
        let found = given.surface.continuity(
            1,
            nurbs::ContinuityTolerances {
                position: 0.0,
                derivative: 0.0,
                angle: 0.0,
            },
        )?;
        for row in &found {
            show("knots", &row.knot);
            show("knot_orders", &row.knot_order);
            show("orders", &row.found.order);
            show("geometric_orders", &row.found.geometric);
            show("position_gaps", &row.found.position_gap);
            show("angles", &row.found.angle);
            show("curvature_gaps", &row.found.curvature_gap);
        }
    }
    begin("continuity_between");
    {
        let found = nurbs::continuity_between(
            (&given.curve, 1),
            (&given.curve, 0),
            nurbs::ContinuityTolerances {
                position: 0.0,
                derivative: 0.0,
                angle: 0.0,
            },
        )?;
        show("order", &found.order);
        show("geometric", &found.geometric);
        show("position_gap", &found.position_gap);
        show("angle", &found.angle);
        show("curvature_gap", &found.curvature_gap);
    }
    begin("closest_points_with");
    {
        let found = given.curve.closest_points_with(
            &[0.1, 0.9],
            nurbs::Search {
                tolerance: 0.0,
                budget: 0,
                flags: 0,
                ..Default::default()
            },
            &mut Call::new().progress(|_| true),
        )?;
        show("params", &found.params);
        show("feet", &found.points);
        show("distances", &found.distances);
        show("status", &found.status);
    }
    begin("closest_points_with of a part");
    {
        let found = given.surface.closest_points_with(
            &[0.1, 0.9, 0.3, 0.7, 0.2, 0.6],
            nurbs::Search {
                range: &[0.0, 1.0, 0.0, 3.0],
                tolerance: 0.0,
                budget: 0,
                flags: 0,
            },
            &mut Call::new().progress(|_| true),
        )?;
        show("params", &found.params);
        show("feet", &found.points);
        show("distances", &found.distances);
        show("status", &found.status);
    }
    begin("farthest_points_with");
    {
        let found = given.curve.farthest_points_with(
            &[0.1, 0.9],
            nurbs::Search {
                tolerance: 0.0,
                budget: 0,
                flags: 0,
                ..Default::default()
            },
            &mut Call::new().progress(|_| true),
        )?;
        show("params", &found.params);
        show("feet", &found.points);
        show("distances", &found.distances);
        show("status", &found.status);
    }
    begin("farthest_points_with of a part");
    {
        let found = given.curve.farthest_points_with(
            &[0.1, 0.9, 0.3, 0.7, 0.2, 0.6],
            nurbs::Search {
                range: &[0.3, 0.6],
                tolerance: 0.0,
                budget: 0,
                flags: 0,
            },
            &mut Call::new().progress(|_| true),
        )?;
        show("params", &found.params);
        show("feet", &found.points);
        show("distances", &found.distances);
        show("status", &found.status);
    }
    begin("closest_local_with");
    {
        let found = given.curve.closest_local_with(
            &[0.1, 0.9, 0.3, 0.7, 0.2, 0.6],
            &[0.1, 0.9, 0.3],
            0,
            &mut Call::new().progress(|_| true),
        )?;
        show("params", &found.params);
        show("feet", &found.points);
        show("distances", &found.distances);
        show("status", &found.status);
    }
    begin("closest_local_with params");
    {
        let found = given.curve.closest_local_with(
            &[0.1, 0.9],
            &[0.1],
            0,
            &mut Call::new().progress(|_| true),
        )?;
        show("params", &found.params);
        show("feet", &found.points);
        show("distances", &found.distances);
        show("status", &found.status);
    }
    begin("curve_signed_distances_with");
    {
        let found = given.curve.signed_distances_with(
            &[0.1, 0.9, 0.3, 0.7, 0.2, 0.6],
            nurbs::Search {
                tolerance: 0.0,
                budget: 0,
                flags: 0,
                ..Default::default()
            },
            &mut Call::new().progress(|_| true),
        )?;
        show("distances", &found.distances);
        show("params", &found.params);
        show("status", &found.status);
    }
    begin("curve_signed_distances_with alone");
    {
        let found = given.curve.signed_distances_with(
            &[0.1, 0.9],
            nurbs::Search {
                tolerance: 0.0,
                budget: 0,
                flags: 0,
                ..Default::default()
            },
            &mut Call::new().progress(|_| true),
        )?;
        show("distances", &found.distances);
        show("params", &found.params);
        show("status", &found.status);
    }
    begin("closest_all_with");
    {
        let found = given.curve.closest_all_with(
            &[0.1, 0.9],
            nurbs::Search {
                tolerance: 0.0,
                budget: 0,
                ..Default::default()
            },
            &mut Call::new().progress(|_| true),
        )?;
        show("params", &found.params);
        show("distances", &found.distances);
        show("status", &found.status);
    }
    begin("closest_all_with inside");
    {
        let found = given.curve.closest_all_with(
            &[0.1, 0.9],
            nurbs::Search {
                range: &[0.0, 1.0],
                tolerance: 0.0,
                budget: 0,
                ..Default::default()
            },
            &mut Call::new().progress(|_| true),
        )?;
        show("params", &found.params);
        show("distances", &found.distances);
        show("status", &found.status);
    }
    begin("critical_points_with");
    {
        let found = given.curve.critical_points_with(
            &[0.1, 0.9],
            nurbs::Search {
                tolerance: 0.0,
                budget: 0,
                ..Default::default()
            },
            &mut Call::new().progress(|_| true),
        )?;
        show("params", &found.params);
        show("distances", &found.distances);
        show("kinds", &found.kinds);
        show("status", &found.status);
    }
    begin("critical_points_with inside");
    {
        let found = given.curve.critical_points_with(
            &[0.1, 0.9],
            nurbs::Search {
                range: &[0.0, 1.0],
                tolerance: 0.0,
                budget: 0,
                ..Default::default()
            },
            &mut Call::new().progress(|_| true),
        )?;
        show("params", &found.params);
        show("distances", &found.distances);
        show("kinds", &found.kinds);
        show("status", &found.status);
    }
    begin("distance_with");
    {
        let found = given.curve.distance_with(
            &given.r#loop,
            1e-06,
            0,
            &mut Call::new().progress(|_| true),
        )?;
        show("at_least", &found.at_least);
        show("at_most", &found.at_most);
        show("params_a", &found.params[0]);
        show("params_b", &found.params[1]);
        show("status", &found.status);
    }
    begin("hausdorff_distance_with");
    {
        let found = given.curve.hausdorff_distance_with(
            &given.r#loop,
            0.1,
            0,
            &mut Call::new().progress(|_| true),
        )?;
        show("at_least", &found.at_least);
        show("at_most", &found.at_most);
        show("params_a", &found.params[0]);
        show("params_b", &found.params[1]);
        show("status", &found.status);
    }
    begin("curve_features_with count");
    {
        let found = given
            .twist
            .features_with(127, &mut Call::new().progress(|_| true))?;
        for row in &found.found {
            show("params", &row.param);
            show("found", &row.kind);
            show("values", &row.value);
        }
        show("complete", &found.complete);
    }
    begin("curve_features_with periodic");
    {
        let found = given
            .r#loop
            .features_with(63, &mut Call::new().progress(|_| true))?;
        for row in &found.found {
            show("params", &row.param);
            show("found", &row.kind);
            show("values", &row.value);
        }
        show("complete", &found.complete);
    }
    begin("extrema_with");
    {
        let heights = Spline::create(
            &[1, 1],
            &[2, 2],
            &[0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 3.0, 3.0],
            1,
            &[0.0, 1.0, 1.0, 2.0],
            None,
            0,
        )?;
        let found = heights.extrema_with(31, &mut Call::new().progress(|_| true))?;
        show("params", &found.params);
        show("values", &found.values);
        show("found", &found.found);
        show("boxes", &found.boxes);
        show("complete", &found.complete);
    }
    begin("extrema_with count");
    {
        let ramp = Spline::bezier(&[2], 1, &[0.0, 0.25, 1.0], None)?;
        let found = ramp.extrema_with(3, &mut Call::new().progress(|_| true))?;
        show("params", &found.params);
        show("values", &found.values);
        show("found", &found.found);
        show("boxes", &found.boxes);
        show("complete", &found.complete);
    }
    begin("mesh_curve_with");
    {
        let found =
            given
                .curve
                .mesh_curve_with(1.0, 2.0, 3.0, &mut Call::new().progress(|_| true))?;
        show("params", &found.params);
        show("points", &found.points);
        show("bound", &found.bound);
        show("reached", &found.reached);
    }
    begin("mesh_curve_with count");
    {
        let found =
            given
                .r#loop
                .mesh_curve_with(0.5, 0.0, 0.0, &mut Call::new().progress(|_| true))?;
        show("params", &found.params);
        show("points", &found.points);
        show("bound", &found.bound);
        show("reached", &found.reached);
    }
    begin("fold_test_with");
    {
        let found = given
            .surface
            .fold_test_with(&[], &mut Call::new().progress(|_| true))?;
        show("result", &found.result);
        show("positive", &found.positive);
        show("negative", &found.negative);
    }
    begin("fold_pieces_with");
    {
        let found = given
            .surface
            .fold_pieces_with(&[], &mut Call::new().progress(|_| true))?;
        show("folds", &found.folds);
        show("signs", &found.signs);
    }
    begin("roots_with");
    {
        let ramp = Spline::bezier(&[2], 1, &[0.0, 0.25, 1.0], None)?;
        let found = ramp.roots_with(0.5, 0.0, &mut Call::new().progress(|_| true))?;
        show("params", &found.params);
        show("kinds", &found.kinds);
        show("ranges", &found.ranges);
        show("complete", &found.complete);
    }
    begin("roots_with count");
    {
        let round = Spline::bezier(&[2], 1, &[0.0, 2.0, 9.0], None)?;
        let found = round.roots_with(3.0, 1e-09, &mut Call::new().progress(|_| true))?;
        show("params", &found.params);
        show("kinds", &found.kinds);
        show("ranges", &found.ranges);
        show("complete", &found.complete);
    }
    begin("curve_level_with");
    {
        let found = given.curve.curve_level_with(
            1,
            &[0.1, 0.9, -0.3],
            1e-09,
            &mut Call::new().progress(|_| true),
        )?;
        show("params", &found.params);
        show("kinds", &found.kinds);
        show("ranges", &found.ranges);
        show("complete", &found.complete);
    }
    begin("surface_rays_with");
    {
        let found = given.surface.rays_with(
            &[0.1, 0.2, 5.0, 0.3, 0.4, 6.0],
            &[0.0, 0.0, -1.0, 0.1, 0.1, -1.0],
            &mut Call::new().progress(|_| true),
        )?;
        show("params", &found.params);
        show("distances", &found.distances);
        show("status", &found.status);
    }
    begin("surface_rays_with distances");
    {
        let found = given.surface.rays_with(
            &[0.1, 0.2, 5.0],
            &[0.0, 0.0, -1.0],
            &mut Call::new().progress(|_| true),
        )?;
        show("params", &found.params);
        show("distances", &found.distances);
        show("status", &found.status);
    }
    begin("surfaces_common_points_with");
    {
        let wall = Spline::bezier(
            &[1, 1],
            3,
            &[
                0.3, -1.0, -1.0, 0.3, -1.0, 9.0, 0.4, 9.0, -1.0, 0.4, 9.0, 9.0,
            ],
            None,
        )?;
        let sphere = Spline::sphere(
            nurbs::Placement {
                ..Default::default()
            },
            1.0,
            0,
        )?;
        let found = wall.common_points_with(
            &given.surface,
            &sphere,
            0.001,
            &mut Call::new().progress(|_| true),
        )?;
        show("params", &found.params);
        show("points", &found.points);
        show("kinds", &found.kinds);
        show("ranges", &found.ranges);
        show("complete", &found.complete);
    }
    begin("curve_surface_intersections_with");
    {
        let sphere = Spline::sphere(
            nurbs::Placement {
                ..Default::default()
            },
            1.0,
            0,
        )?;
        let found = given.twist.surface_intersections_with(
            &sphere,
            1e-09,
            &mut Call::new().progress(|_| true),
        )?;
        show("params_curve", &found.params_curve);
        show("params_surface", &found.params_surface);
        show("kinds", &found.kinds);
        show("ranges_curve", &found.ranges_curve);
        show("ranges_surface", &found.ranges_surface);
        show("complete", &found.complete);
    }
    begin("face_rays_with");
    {
        let found = given.face.rays_with(
            &[0.5, 1.2, 9.0, 0.3, 0.4, 6.0],
            &[0.0, 0.0, -1.0, 0.1, 0.1, -1.0],
            &mut Call::new().progress(|_| true),
        )?;
        show("params", &found.params);
        show("distances", &found.distances);
        show("status", &found.status);
    }
    begin("face_rays_with distances");
    {
        let found = given.face.rays_with(
            &[0.5, 1.2, 9.0],
            &[0.0, 0.0, -1.0],
            &mut Call::new().progress(|_| true),
        )?;
        show("params", &found.params);
        show("distances", &found.distances);
        show("status", &found.status);
    }
    begin("face_closest_points_with");
    {
        let found = given.face.closest_points_with(
            &[0.5, 1.2, 9.0, 0.3, 0.4, 6.0],
            1e-06,
            &mut Call::new().progress(|_| true),
        )?;
        show("params", &found.params);
        show("feet", &found.points);
        show("distances", &found.distances);
        show("status", &found.status);
    }
    begin("face_closest_points_with alone");
    {
        let found = given.face.closest_points_with(
            &[0.1, 0.2, 0.3],
            0.0,
            &mut Call::new().progress(|_| true),
        )?;
        show("params", &found.params);
        show("feet", &found.points);
        show("distances", &found.distances);
        show("status", &found.status);
    }
    begin("face_distance_with");
    {
        let sphere = Spline::sphere(
            nurbs::Placement {
                ..Default::default()
            },
            1.0,
            0,
        )?;
        let ball_face = Face::create(&sphere, &[], &[], &[], &[], 1e-09, 0)?;
        let found =
            given
                .face
                .distance_with(&ball_face, 4.0, &mut Call::new().progress(|_| true))?;
        show("at_least", &found.at_least);
        show("at_most", &found.at_most);
        show("params_a", &found.params_a);
        show("params_b", &found.params_b);
        show("status", &found.status);
    }
    begin("face_hausdorff_distance_with");
    {
        let sphere = Spline::sphere(
            nurbs::Placement {
                ..Default::default()
            },
            1.0,
            0,
        )?;
        let ball_face = Face::create(&sphere, &[], &[], &[], &[], 1e-09, 0)?;
        let found = given.face.hausdorff_distance_with(
            &ball_face,
            4.0,
            &mut Call::new().progress(|_| true),
        )?;
        show("at_least", &found.at_least);
        show("at_most", &found.at_most);
        show("params_a", &found.params_a);
        show("params_b", &found.params_b);
        show("status", &found.status);
    }
    begin("model_rays_with");
    {
        let found = given.model.rays_with(
            &[0.5, 1.2, 9.0, 0.3, 0.4, 6.0],
            &[0.0, 0.0, -1.0, 0.1, 0.1, -1.0],
            &mut Call::new().progress(|_| true),
        )?;
        show("params", &found.params);
        show("distances", &found.distances);
        show("status", &found.status);
        show("places", &found.places);
    }
    begin("model_rays_with places");
    {
        let sphere = Spline::sphere(
            nurbs::Placement {
                ..Default::default()
            },
            1.0,
            0,
        )?;
        let ball_face = Face::create(&sphere, &[], &[], &[], &[], 1e-09, 0)?;
        let ball = Model::create(&[&ball_face], 1.0)?;
        let found = ball.rays_with(
            &[0.1, 0.2, 5.0],
            &[0.0, 0.0, -1.0],
            &mut Call::new().progress(|_| true),
        )?;
        show("params", &found.params);
        show("distances", &found.distances);
        show("status", &found.status);
        show("places", &found.places);
    }
    begin("model_ray_hits_with within");
    {
        let found = given.model.ray_hits_with(
            &[0.5, 1.2, 9.0],
            &[0.0, 0.0, -1.0],
            &[-1.0, 20.0],
            &mut Call::new().progress(|_| true),
        )?;
        show("params", &found.params);
        show("distances", &found.distances);
        show("kinds", &found.kinds);
        show("places", &found.places);
        show("complete", &found.complete);
    }
    begin("model_ray_hits_with");
    {
        let sphere = Spline::sphere(
            nurbs::Placement {
                ..Default::default()
            },
            1.0,
            0,
        )?;
        let ball_face = Face::create(&sphere, &[], &[], &[], &[], 1e-09, 0)?;
        let ball = Model::create(&[&ball_face], 1.0)?;
        let found = ball.ray_hits_with(
            &[0.1, 0.2, 5.0],
            &[0.0, 0.0, -1.0],
            &[],
            &mut Call::new().progress(|_| true),
        )?;
        show("params", &found.params);
        show("distances", &found.distances);
        show("kinds", &found.kinds);
        show("places", &found.places);
        show("complete", &found.complete);
    }
    begin("model_closest_points_with");
    {
        let found = given.model.closest_points_with(
            &[0.5, 1.2, 9.0, 0.3, 0.4, 6.0],
            1e-06,
            &mut Call::new().progress(|_| true),
        )?;
        show("params", &found.params);
        show("feet", &found.points);
        show("distances", &found.distances);
        show("status", &found.status);
        show("places", &found.places);
    }
    begin("model_closest_points_with alone");
    {
        let sphere = Spline::sphere(
            nurbs::Placement {
                ..Default::default()
            },
            1.0,
            0,
        )?;
        let ball_face = Face::create(&sphere, &[], &[], &[], &[], 1e-09, 0)?;
        let ball = Model::create(&[&ball_face], 1.0)?;
        let found =
            ball.closest_points_with(&[0.1, 0.2, 3.0], 0.0, &mut Call::new().progress(|_| true))?;
        show("params", &found.params);
        show("feet", &found.points);
        show("distances", &found.distances);
        show("status", &found.status);
        show("places", &found.places);
    }
    begin("model_classify_with");
    {
        let sphere = Spline::sphere(
            nurbs::Placement {
                ..Default::default()
            },
            1.0,
            0,
        )?;
        let ball_face = Face::create(&sphere, &[], &[], &[], &[], 1e-09, 0)?;
        let ball = Model::create(&[&ball_face], 1.0)?;
        let found = ball.classify_with(
            &[0.1, 0.2, 0.3, 1.0, 1.0, 1.0],
            0.0,
            &mut Call::new().progress(|_| true),
        )?;
        show("sides", &found);
    }
    begin("model_classify_with near");
    {
        let sphere = Spline::sphere(
            nurbs::Placement {
                ..Default::default()
            },
            1.0,
            0,
        )?;
        let ball_face = Face::create(&sphere, &[], &[], &[], &[], 1e-09, 0)?;
        let ball = Model::create(&[&ball_face], 1.0)?;
        let found = ball.classify_with(
            &[0.1, 0.2, 0.3, 0.0, 0.6, 0.8],
            0.001,
            &mut Call::new().progress(|_| true),
        )?;
        show("sides", &found);
    }
    begin("model_area_with");
    {
        let sphere = Spline::sphere(
            nurbs::Placement {
                ..Default::default()
            },
            1.0,
            0,
        )?;
        let ball_face = Face::create(&sphere, &[], &[], &[], &[], 1e-09, 0)?;
        let ball = Model::create(&[&ball_face], 1.0)?;
        let found = ball.area_with(1e-06, &mut Call::new().progress(|_| true))?;
        show("area", &found.value);
        show("error", &found.error);
    }
    begin("model_volume_with");
    {
        let sphere = Spline::sphere(
            nurbs::Placement {
                ..Default::default()
            },
            1.0,
            0,
        )?;
        let ball_face = Face::create(&sphere, &[], &[], &[], &[], 1e-09, 0)?;
        let ball = Model::create(&[&ball_face], 1.0)?;
        let found = ball.volume_with(1e-06, &mut Call::new().progress(|_| true))?;
        show("volume", &found.volume);
        show("centroid", &found.centroid);
        show("inertia", &found.inertia);
        show("openness", &found.openness);
        show("error", &found.error);
    }
    begin("model_volume_with alone");
    {
        let sphere = Spline::sphere(
            nurbs::Placement {
                ..Default::default()
            },
            1.0,
            0,
        )?;
        let ball_face = Face::create(&sphere, &[], &[], &[], &[], 1e-09, 0)?;
        let ball = Model::create(&[&ball_face], 1.0)?;
        let found = ball.volume_with(1e-06, &mut Call::new().progress(|_| true))?;
        show("volume", &found.volume);
        show("centroid", &found.centroid);
        show("inertia", &found.inertia);
        show("openness", &found.openness);
        show("error", &found.error);
    }
    begin("curve_self_intersections_with");
    {
        let found = given
            .curve
            .self_intersections_with(1e-09, &mut Call::new().progress(|_| true))?;
        show("params_a", &found.params_a);
        show("params_b", &found.params_b);
        show("kinds", &found.kinds);
        show("ranges_a", &found.ranges_a);
        show("ranges_b", &found.ranges_b);
        show("complete", &found.complete);
    }
    begin("curve_intersections_with");
    {
        let found = given.curve.curve_intersections_with(
            &given.segment,
            1e-09,
            &mut Call::new().progress(|_| true),
        )?;
        show("params_a", &found.params_a);
        show("params_b", &found.params_b);
        show("kinds", &found.kinds);
        show("ranges_a", &found.ranges_a);
        show("ranges_b", &found.ranges_b);
        show("complete", &found.complete);
    }
    begin("curve_level_with conic");
    {
        let found = given.r#loop.curve_level_with(
            2,
            &[1.0, 0.0, 0.0, 1.0, 0.0, -0.5],
            0.0,
            &mut Call::new().progress(|_| true),
        )?;
        show("params", &found.params);
        show("kinds", &found.kinds);
        show("ranges", &found.ranges);
        show("complete", &found.complete);
    }
    begin("fold_test_with seen from above");
    {
        let found = given
            .surface
            .fold_test_with(&[1.0, 2.0, 3.0], &mut Call::new().progress(|_| true))?;
        show("result", &found.result);
        show("positive", &found.positive);
        show("negative", &found.negative);
    }
    begin("fold_pieces_with seen from above");
    {
        let found = given
            .surface
            .fold_pieces_with(&[1.0, 2.0, 3.0], &mut Call::new().progress(|_| true))?;
        show("folds", &found.folds);
        show("signs", &found.signs);
    }
    begin("recognize_with curve");
    {
        let found = given
            .curve
            .recognize_with(1e-09, &mut Call::new().progress(|_| true))?;
        show("shape", &found.shape);
        show("placement", &found.origin);
        show("placement", &found.axis);
        show("placement", &found.x);
        show("sizes", &found.sizes);
        show("deviation", &found.deviation);
    }
    begin("recognize_with surface");
    {
        let found = given
            .surface
            .recognize_with(0.2, &mut Call::new().progress(|_| true))?;
        show("shape", &found.shape);
        show("placement", &found.origin);
        show("placement", &found.axis);
        show("placement", &found.x);
        show("sizes", &found.sizes);
        show("deviation", &found.deviation);
    }
    begin("curve_length_with");
    {
        let found = given
            .curve
            .length_with(1e-09, &[], &mut Call::new().progress(|_| true))?;
        show("length", &found.value);
        show("error", &found.error);
    }
    begin("curve_length_with of a part");
    {
        let found =
            given
                .curve
                .length_with(1e-09, &[0.3, 0.6], &mut Call::new().progress(|_| true))?;
        show("length", &found.value);
        show("error", &found.error);
    }
    begin("curve_lengths_with");
    {
        let found =
            given
                .r#loop
                .lengths_with(&[4.0], 1e-09, &mut Call::new().progress(|_| true))?;
        show("lengths", &found);
    }
    begin("curve_params_at_lengths_with");
    {
        let found = given.curve.params_at_lengths_with(
            &[4.0],
            1e-09,
            0,
            &mut Call::new().progress(|_| true),
        )?;
        show("params", &found);
    }
    begin("curve_divide_with");
    {
        let found =
            given
                .curve
                .divide_with(5, 1e-09, 0, &[], &mut Call::new().progress(|_| true))?;
        show("params", &found.params);
        show("size", &found.size);
    }
    begin("curve_divide_with a part");
    {
        let found = given.curve.divide_with(
            5,
            1e-09,
            0,
            &[0.3, 0.6],
            &mut Call::new().progress(|_| true),
        )?;
        show("params", &found.params);
        show("size", &found.size);
    }
    begin("curve_divide_with chords");
    {
        let found = given.curve.divide_with(
            5,
            1e-09,
            33554432,
            &[],
            &mut Call::new().progress(|_| true),
        )?;
        show("params", &found.params);
        show("size", &found.size);
    }
    begin("surface_area_with");
    {
        let found = given
            .surface
            .area_with(1e-09, &[], &mut Call::new().progress(|_| true))?;
        show("area", &found.value);
        show("error", &found.error);
    }
    begin("surface_area_with of a part");
    {
        let found = given.surface.area_with(
            1e-09,
            &[0.0, 1.0, 0.0, 3.0],
            &mut Call::new().progress(|_| true),
        )?;
        show("area", &found.value);
        show("error", &found.error);
    }
    begin("moments_with");
    {
        let found = given
            .surface
            .moments_with(1e-09, &mut Call::new().progress(|_| true))?;
        show("content", &found.content);
        show("centroid", &found.centroid);
        show("inertia", &found.inertia);
        show("error", &found.error);
    }
    begin("enclosed_area_with");
    {
        let found = nurbs::enclosed_area_with(
            &[&given.r#loop],
            1e-09,
            1e-09,
            &mut Call::new().progress(|_| true),
        )?;
        show("area", &found.area);
        show("centroid", &found.centroid);
        show("inertia", &found.inertia);
        show("error", &found.error);
    }
    begin("enclosed_volume_with");
    {
        let found = nurbs::enclosed_volume_with(
            &[&given.surface],
            1e-09,
            &mut Call::new().progress(|_| true),
        )?;
        show("volume", &found.volume);
        show("centroid", &found.centroid);
        show("inertia", &found.inertia);
        show("openness", &found.openness);
        show("error", &found.error);
    }
    begin("enclosed_volume_with sphere");
    {
        let sphere = Spline::sphere(
            nurbs::Placement {
                ..Default::default()
            },
            1.0,
            0,
        )?;
        let found =
            nurbs::enclosed_volume_with(&[&sphere], 1e-06, &mut Call::new().progress(|_| true))?;
        show("volume", &found.volume);
        show("centroid", &found.centroid);
        show("inertia", &found.inertia);
        show("openness", &found.openness);
        show("error", &found.error);
    }
    Ok(())
}

fn scalar(given: &Given) -> nurbs::Result<()> {
    begin("axes");
    {
        let found = given.curve.axes()?;
        show("axes", &found);
    }
    begin("dimension");
    {
        let found = given.curve.dimension()?;
        show("dim", &found);
    }
    begin("point_count");
    {
        let found = given.curve.point_count()?;
        show("count", &found);
    }
    begin("is_rational");
    {
        let found = given.curve.is_rational()?;
        show("rational", &found);
    }
    begin("is_homogeneous");
    {
        let found = given.curve.is_homogeneous()?;
        show("homogeneous", &found);
    }
    begin("degree");
    {
        let found = given.surface.degree(1)?;
        show("degree", &found);
    }
    begin("count");
    {
        let found = given.surface.count(1)?;
        show("count", &found);
    }
    begin("knot_form");
    {
        let found = given.surface.knot_form(1)?;
        show("form", &found);
    }
    begin("domain");
    {
        let found = given.surface.domain(1)?;
        show("domain", &found);
    }
    begin("derivative_slots");
    {
        let found = nurbs::derivative_slots(3, 9)?;
        show("slots", &found);
    }
    begin("unwrapped_count");
    {
        let found = given.r#loop.unwrapped_count(0)?;
        show("count", &found);
    }
    by_hand("list_count");
    begin("list_note_count");
    {
        let found = given.list.note_count()?;
        show("count", &found);
    }
    begin("list_unit");
    {
        let found = given.list.unit()?;
        show("metres", &found);
    }
    begin("list_name");
    {
        let found = given.list.name(0)?;
        show("buf", &found);
    }
    begin("list_note");
    {
        let found = given.list.note(0)?;
        show("entity_type", &found.entity_type);
        show("line", &found.line);
        show("reason", &found.reason);
        show("buf", &found.text);
    }
    begin("model_counts");
    {
        let found = given.model.counts()?;
        show("parts", &found.parts);
        show("uses", &found.uses);
        show("faces", &found.faces);
        show("edges", &found.edges);
        show("vertices", &found.vertices);
    }
    begin("meet_counts");
    {
        let found = given.meet.counts()?;
        show("branches", &found.branches);
        show("nodes", &found.nodes);
        show("complete", &found.complete);
    }
    begin("mesh_counts");
    {
        let found = given.mesh.counts()?;
        show("points", &found.points);
        show("vertices", &found.vertices);
        show("triangles", &found.triangles);
        show("faces", &found.faces);
        show("edges", &found.edges);
        show("edge_points", &found.edge_points);
    }
    begin("mesh_bound");
    {
        let found = given.mesh.bound()?;
        show("from_shape", &found.from_shape);
        show("from_mesh", &found.from_mesh);
        show("reached", &found.reached);
    }
    begin("model_face_name");
    {
        let found = given.model.face_name(1)?;
        show("buf", &found);
    }
    begin("model_face_solid");
    {
        let found = given.model.face_solid(1)?;
        show("solid", &found.solid);
        show("in_void", &found.in_void);
    }
    begin("model_face_layers");
    {
        let found = given.layered.face_layers(0)?;
        show("layers", &found);
    }
    begin("model_spline_layers");
    {
        let found = given.layered.spline_layers(0)?;
        show("layers", &found);
    }
    begin("model_layer_count");
    {
        let found = given.layered.layer_count()?;
        show("count", &found);
    }
    begin("model_layer");
    {
        let found = given.layered.layer(0)?;
        show("buf", &found);
    }
    begin("model_edge_uses");
    {
        let found = given.model.edge_uses(1)?;
        show("places", &found);
    }
    begin("model_vertex");
    {
        let found = given.model.vertex(0)?;
        show("point", &found);
    }
    begin("model_part");
    {
        let found = given.model.part(0)?;
        show("buf", &found);
    }
    begin("model_use");
    {
        let found = given.model.part_use(0)?;
        show("parent", &found.parent);
        show("part", &found.part);
        show("placement", &found.placement);
    }
    by_hand("read_options_init");
    by_hand("call_options_init");
    by_hand("version");
    by_hand("status_name");
    by_hand("last_error");
    Ok(())
}

fn shape(given: &Given) -> nurbs::Result<()> {
    begin("curve_line");
    {
        let found = Spline::line(&[0.1, 0.9], &[0.3, 0.7])?;
        show("out", &found);
    }
    begin("curve_polyline");
    {
        let found = Spline::polyline(2, &[0.1, 0.9, 0.3, 0.7, 0.2, 0.6], None)?;
        show("out", &found);
    }
    begin("curve_polyline with params");
    {
        let found = Spline::polyline(3, &[0.1, 0.9, 0.3, 0.7, 0.2, 0.6], Some(&[0.3, 0.6]))?;
        show("out", &found);
    }
    begin("curve_polygon");
    {
        let found = Spline::polygon(
            nurbs::Placement {
                ..Default::default()
            },
            1.0,
            5,
        )?;
        show("out", &found);
    }
    begin("curve_polygon placed");
    {
        let found = Spline::polygon(
            nurbs::Placement {
                origin: &[1.0, 2.0, 3.0],
                axis: &[0.0, 1.0, 0.0],
                x: &[1.0, 0.0, 0.0],
            },
            1.0,
            5,
        )?;
        show("out", &found);
    }
    begin("curve_rounded_rectangle");
    {
        let found = Spline::rounded_rectangle(
            nurbs::Placement {
                ..Default::default()
            },
            3.0,
            2.0,
            0.5,
        )?;
        show("out", &found);
    }
    begin("curve_circle");
    {
        let found = Spline::circle(
            nurbs::Placement {
                ..Default::default()
            },
            1.0,
            2,
        )?;
        show("out", &found);
    }
    begin("curve_circle placed");
    {
        let found = Spline::circle(
            nurbs::Placement {
                origin: &[1.0, 2.0, 3.0],
                axis: &[0.0, 1.0, 0.0],
                x: &[1.0, 0.0, 0.0],
            },
            1.0,
            2,
        )?;
        show("out", &found);
    }
    begin("curve_arc");
    {
        let found = Spline::arc(
            nurbs::Placement {
                ..Default::default()
            },
            1.0,
            nurbs::Turn {
                start: 0.0,
                sweep: 4.0,
            },
            0,
        )?;
        show("out", &found);
    }
    begin("curve_arc_through");
    {
        let found = Spline::arc_through(&[0.1, 0.9], &[0.3, 0.7], &[0.2, 0.6], 0)?;
        show("out", &found);
    }
    begin("curve_arc_tangent");
    {
        let found = Spline::arc_tangent(&[0.0, 0.0], &[0.0, 1.0], &[1.0, 1.0], 0)?;
        show("out", &found);
    }
    begin("curve_ellipse");
    {
        let found = Spline::ellipse(
            nurbs::Placement {
                ..Default::default()
            },
            [2.0, 1.0],
            nurbs::Turn {
                start: 0.0,
                sweep: 4.0,
            },
            2,
        )?;
        show("out", &found);
    }
    begin("curve_parabola");
    {
        let found = Spline::parabola(
            nurbs::Placement {
                ..Default::default()
            },
            1.0,
            -1.0,
            2.0,
        )?;
        show("out", &found);
    }
    begin("curve_parabola placed");
    {
        let found = Spline::parabola(
            nurbs::Placement {
                origin: &[1.0, 2.0, 3.0],
                axis: &[0.0, 1.0, 0.0],
                x: &[1.0, 0.0, 0.0],
            },
            1.0,
            -1.0,
            2.0,
        )?;
        show("out", &found);
    }
    begin("curve_hyperbola");
    {
        let found = Spline::hyperbola(
            nurbs::Placement {
                ..Default::default()
            },
            [1.0, 1.0],
            0.0,
            9.0,
        )?;
        show("out", &found);
    }
    begin("curve_hyperbola placed");
    {
        let found = Spline::hyperbola(
            nurbs::Placement {
                origin: &[1.0, 2.0, 3.0],
                axis: &[0.0, 1.0, 0.0],
                x: &[1.0, 0.0, 0.0],
            },
            [1.0, 1.0],
            0.0,
            9.0,
        )?;
        show("out", &found);
    }
    begin("curve_conic_triangle");
    {
        let found = Spline::conic_triangle(&[0.1, 0.9], &[0.3, 0.7], &[0.2, 0.6], 0.4)?;
        show("out", &found);
    }
    begin("curve_conic_shoulder");
    {
        let found =
            Spline::conic_shoulder(&[0.0, 0.0], &[1.0, 1.0], &[1.0, 0.0], &[1.0, -1.0], 0.4)?;
        show("out", &found);
    }
    begin("curve_conic_through");
    {
        let found =
            Spline::conic_through(2, &[-2.0, 4.0, -1.0, 1.0, 0.0, 0.0, 1.0, 1.0, 2.0, 4.0], 0)?;
        show("out", &found);
    }
    begin("curve_conic_implicit");
    {
        let found = Spline::conic_implicit(&[1.0, 0.0, 4.0, 0.0, 0.0, -4.0], 0.0, 3.0, 0)?;
        show("out", &found);
    }
    begin("curve_helix");
    {
        let found = Spline::helix(
            nurbs::Placement {
                ..Default::default()
            },
            nurbs::HelixShape {
                radius: 1.0,
                growth: 1.0,
                pitch: 1.0,
                start: 0.0,
                turns: 1.0,
            },
            0.1,
        )?;
        show("out", &found.0);
        show("error", &found.1);
    }
    begin("extrude");
    {
        let found = given.twist.extrude(&[0.0, 0.0, 1.0])?;
        show("out", &found);
    }
    begin("revolve");
    {
        let found = given.twist.revolve(&[], &[], 6.0, 0)?;
        show("out", &found);
    }
    begin("revolve about an axis");
    {
        let found = given
            .twist
            .revolve(&[1.0, 2.0, 3.0], &[0.0, 1.0, 0.0], 6.0, 0)?;
        show("out", &found);
    }
    begin("ruled");
    {
        let found = given.curve.ruled(&given.r#loop, 0)?;
        show("out", &found);
    }
    begin("ruled Cartesian");
    {
        let found = given.curve.ruled(&given.r#loop, 2147483648)?;
        show("out", &found);
    }
    begin("tensor_sum");
    {
        let found = given.curve.tensor_sum(1.0, &given.r#loop, 2.0)?;
        show("out", &found);
    }
    begin("tensor_sum homogeneous");
    {
        let found = given.homogeneous.tensor_sum(1.0, &given.r#loop, 2.0)?;
        show("out", &found);
    }
    begin("tensor_product");
    {
        let found = given.twist.tensor_product(&given.surface)?;
        show("out", &found);
    }
    begin("surface_swung");
    {
        let found = Spline::swung(&given.curve, &given.r#loop, 1.0)?;
        show("out", &found);
    }
    begin("surface_coons");
    {
        let edges = given.surface.boundaries()?;
        let found = Spline::coons(
            [
                &edges.get(0)?,
                &edges.get(1)?,
                &edges.get(2)?,
                &edges.get(3)?,
            ],
            0.0,
        )?;
        show("out", &found);
    }
    begin("surface_coons_hermite");
    {
        let edges = given.surface.boundaries()?;
        let found = Spline::coons_hermite(
            nurbs::HermiteBoundaries {
                curves: [
                    &edges.get(0)?,
                    &edges.get(1)?,
                    &edges.get(2)?,
                    &edges.get(3)?,
                ],
                cross: None,
                twist: 5,
                twists: None,
            },
            0.0,
        )?;
        show("out", &found.0);
        show("bound", &found.1);
    }
    begin("volume_coons");
    {
        let faces = given.volume.boundaries()?;
        let found = Spline::coons_volume(
            [
                &faces.get(0)?,
                &faces.get(1)?,
                &faces.get(2)?,
                &faces.get(3)?,
                &faces.get(4)?,
                &faces.get(5)?,
            ],
            0.0,
        )?;
        show("out", &found);
    }
    begin("surface_plane");
    {
        let found = Spline::plane(&[], &[0.3, 0.6], &[0.1, 0.9])?;
        show("out", &found);
    }
    begin("surface_plane placed");
    {
        let found = Spline::plane(&[1.0, 2.0, 3.0], &[0.0, 1.0, 0.0], &[1.0, 0.0, 0.0])?;
        show("out", &found);
    }
    begin("surface_bilinear");
    {
        let found = Spline::bilinear(1, &[0.1, 0.9, 0.3, 0.7])?;
        show("out", &found);
    }
    begin("volume_trilinear");
    {
        let found = Spline::trilinear(1, &[0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0])?;
        show("out", &found);
    }
    begin("surface_sphere");
    {
        let found = Spline::sphere(
            nurbs::Placement {
                axis: &[0.1, 0.9, 0.3],
                ..Default::default()
            },
            1.0,
            2,
        )?;
        show("out", &found);
    }
    begin("surface_sphere placed");
    {
        let found = Spline::sphere(
            nurbs::Placement {
                origin: &[1.0, 2.0, 3.0],
                axis: &[0.0, 1.0, 0.0],
                x: &[1.0, 0.0, 0.0],
            },
            1.0,
            2,
        )?;
        show("out", &found);
    }
    begin("surface_spherical_patch");
    {
        let found = Spline::spherical_patch(
            nurbs::Placement {
                ..Default::default()
            },
            1.0,
            nurbs::Turn {
                start: 0.0,
                sweep: 4.0,
            },
            0.0,
            1.0,
            0,
        )?;
        show("out", &found);
    }
    begin("surface_sphere_patches");
    {
        let found = Spline::sphere_patches(
            nurbs::Placement {
                ..Default::default()
            },
            1.0,
            16777216,
        )?;
        show("out", &found);
    }
    begin("surface_sphere_patches placed");
    {
        let found = Spline::sphere_patches(
            nurbs::Placement {
                origin: &[1.0, 2.0, 3.0],
                axis: &[0.0, 1.0, 0.0],
                x: &[1.0, 0.0, 0.0],
            },
            1.0,
            16777216,
        )?;
        show("out", &found);
    }
    begin("surface_ellipsoid");
    {
        let found = Spline::ellipsoid(
            nurbs::Placement {
                ..Default::default()
            },
            [1.0, 2.0, 3.0],
            1,
        )?;
        show("out", &found);
    }
    begin("surface_cylinder");
    {
        let found = Spline::cylinder(
            nurbs::Placement {
                ..Default::default()
            },
            1.0,
            2.0,
            nurbs::Turn {
                start: 0.0,
                sweep: 3.0,
            },
            0,
        )?;
        show("out", &found);
    }
    begin("surface_cone");
    {
        let found = Spline::cone(
            nurbs::Placement {
                ..Default::default()
            },
            [1.0, 0.0],
            2.0,
            nurbs::Turn {
                start: 0.0,
                sweep: 3.0,
            },
            0,
        )?;
        show("out", &found);
    }
    begin("surface_paraboloid");
    {
        let found = Spline::paraboloid(
            nurbs::Placement {
                ..Default::default()
            },
            [3.0, 1.0],
            1.0,
            nurbs::Turn {
                start: 0.0,
                sweep: 3.0,
            },
            0,
        )?;
        show("out", &found);
    }
    begin("surface_saddle");
    {
        let found = Spline::saddle(
            nurbs::Placement {
                ..Default::default()
            },
            [3.0, 1.0],
            1.0,
        )?;
        show("out", &found);
    }
    begin("surface_saddle placed");
    {
        let found = Spline::saddle(
            nurbs::Placement {
                origin: &[1.0, 2.0, 3.0],
                axis: &[0.0, 1.0, 0.0],
                x: &[1.0, 0.0, 0.0],
            },
            [3.0, 1.0],
            1.0,
        )?;
        show("out", &found);
    }
    begin("curve_rounded_rectangle placed");
    {
        let found = Spline::rounded_rectangle(
            nurbs::Placement {
                origin: &[1.0, 2.0, 3.0],
                axis: &[0.0, 1.0, 0.0],
                x: &[1.0, 0.0, 0.0],
            },
            3.0,
            2.0,
            0.5,
        )?;
        show("out", &found);
    }
    begin("curve_arc placed");
    {
        let found = Spline::arc(
            nurbs::Placement {
                origin: &[1.0, 2.0, 3.0],
                axis: &[0.0, 1.0, 0.0],
                x: &[1.0, 0.0, 0.0],
            },
            1.0,
            nurbs::Turn {
                start: 0.0,
                sweep: 4.0,
            },
            0,
        )?;
        show("out", &found);
    }
    begin("curve_ellipse placed");
    {
        let found = Spline::ellipse(
            nurbs::Placement {
                origin: &[1.0, 2.0, 3.0],
                axis: &[0.0, 1.0, 0.0],
                x: &[1.0, 0.0, 0.0],
            },
            [2.0, 1.0],
            nurbs::Turn {
                start: 0.0,
                sweep: 4.0,
            },
            0,
        )?;
        show("out", &found);
    }
    begin("curve_conic_point");
    {
        let found = Spline::conic_point(
            &[0.0, 0.0],
            &[1.0, 1.0],
            &[1.0, 0.0],
            &[1.0, -1.0],
            &[0.5, 0.25],
            0,
        )?;
        show("out", &found);
    }
    begin("curve_conic_focus");
    {
        let found = Spline::conic_focus(
            &[0.0, 0.0],
            &[],
            &[1.0, 0.0],
            0.5,
            nurbs::Turn {
                start: 0.0,
                sweep: 6.0,
            },
            0,
        )?;
        show("out", &found);
    }
    begin("curve_conic_focus in space");
    {
        let found = Spline::conic_focus(
            &[1.0, 2.0, 3.0],
            &[0.0, 1.0, 0.0],
            &[2.0, 2.0, 3.0],
            0.5,
            nurbs::Turn {
                start: 0.0,
                sweep: 6.0,
            },
            0,
        )?;
        show("out", &found);
    }
    begin("curve_helix placed");
    {
        let found = Spline::helix(
            nurbs::Placement {
                origin: &[1.0, 2.0, 3.0],
                axis: &[0.0, 1.0, 0.0],
                x: &[1.0, 0.0, 0.0],
            },
            nurbs::HelixShape {
                radius: 1.0,
                growth: 1.0,
                pitch: 1.0,
                start: 0.0,
                turns: 1.0,
            },
            0.1,
        )?;
        show("out", &found.0);
        show("error", &found.1);
    }
    begin("surface_coons_hermite with twists");
    {
        let found = Spline::coons_hermite(
            nurbs::HermiteBoundaries {
                curves: [&given.twist, &given.twist, &given.twist, &given.twist],
                cross: Some([&given.twist, &given.twist, &given.twist, &given.twist]),
                twist: 2,
                twists: Some(&[0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0]),
            },
            99.0,
        )?;
        show("out", &found.0);
        show("bound", &found.1);
    }
    begin("surface_spherical_patch placed");
    {
        let found = Spline::spherical_patch(
            nurbs::Placement {
                origin: &[1.0, 2.0, 3.0],
                axis: &[0.0, 1.0, 0.0],
                x: &[1.0, 0.0, 0.0],
            },
            1.0,
            nurbs::Turn {
                start: 0.0,
                sweep: 4.0,
            },
            0.0,
            1.0,
            0,
        )?;
        show("out", &found);
    }
    begin("surface_ellipsoid placed");
    {
        let found = Spline::ellipsoid(
            nurbs::Placement {
                origin: &[1.0, 2.0, 3.0],
                axis: &[0.0, 1.0, 0.0],
                x: &[1.0, 0.0, 0.0],
            },
            [1.0, 2.0, 3.0],
            1,
        )?;
        show("out", &found);
    }
    begin("surface_cylinder placed");
    {
        let found = Spline::cylinder(
            nurbs::Placement {
                origin: &[1.0, 2.0, 3.0],
                axis: &[0.0, 1.0, 0.0],
                x: &[1.0, 0.0, 0.0],
            },
            1.0,
            2.0,
            nurbs::Turn {
                start: 0.0,
                sweep: 3.0,
            },
            0,
        )?;
        show("out", &found);
    }
    begin("surface_cone placed");
    {
        let found = Spline::cone(
            nurbs::Placement {
                origin: &[1.0, 2.0, 3.0],
                axis: &[0.0, 1.0, 0.0],
                x: &[1.0, 0.0, 0.0],
            },
            [1.0, 0.0],
            2.0,
            nurbs::Turn {
                start: 0.0,
                sweep: 3.0,
            },
            0,
        )?;
        show("out", &found);
    }
    begin("surface_torus");
    {
        let found = Spline::torus(
            nurbs::Placement {
                ..Default::default()
            },
            [3.0, 1.0],
            nurbs::Turn {
                start: 0.0,
                sweep: 3.0,
            },
            nurbs::Turn {
                start: 0.0,
                sweep: 6.0,
            },
            2,
        )?;
        show("out", &found);
    }
    begin("surface_torus placed");
    {
        let found = Spline::torus(
            nurbs::Placement {
                origin: &[1.0, 2.0, 3.0],
                axis: &[0.0, 1.0, 0.0],
                x: &[1.0, 0.0, 0.0],
            },
            [3.0, 1.0],
            nurbs::Turn {
                start: 0.0,
                sweep: 3.0,
            },
            nurbs::Turn {
                start: 0.0,
                sweep: 6.0,
            },
            2,
        )?;
        show("out", &found);
    }
    begin("surface_paraboloid placed");
    {
        let found = Spline::paraboloid(
            nurbs::Placement {
                origin: &[1.0, 2.0, 3.0],
                axis: &[0.0, 1.0, 0.0],
                x: &[1.0, 0.0, 0.0],
            },
            [3.0, 1.0],
            1.0,
            nurbs::Turn {
                start: 0.0,
                sweep: 3.0,
            },
            0,
        )?;
        show("out", &found);
    }
    begin("surface_hyperboloid");
    {
        let found = Spline::hyperboloid(
            nurbs::Placement {
                ..Default::default()
            },
            [3.0, 1.0, 1.0],
            [-9.0, 9.0],
            nurbs::Turn {
                start: 0.0,
                sweep: 3.0,
            },
            0,
            0,
        )?;
        show("out", &found);
    }
    begin("surface_hyperboloid placed");
    {
        let found = Spline::hyperboloid(
            nurbs::Placement {
                origin: &[1.0, 2.0, 3.0],
                axis: &[0.0, 1.0, 0.0],
                x: &[1.0, 0.0, 0.0],
            },
            [3.0, 1.0, 1.0],
            [-9.0, 9.0],
            nurbs::Turn {
                start: 0.0,
                sweep: 3.0,
            },
            0,
            0,
        )?;
        show("out", &found);
    }
    Ok(())
}

fn main() -> nurbs::Result<()> {
    let given = given()?;
    data(&given)?;
    edit(&given)?;
    evaluation(&given)?;
    form(&given)?;
    query(&given)?;
    scalar(&given)?;
    shape(&given)?;
    Ok(())
}
