/* SPDX-License-Identifier: MIT */
// Generated from tests/capi/calls/*.toml and include/nurbs/nurbs.h by: python3 cmake/interface/generate.py . - do not edit.
// clang-format off
#ifndef NURBS_TESTS_CAPI_CALLS_GENERATED_TABLE_H
#define NURBS_TESTS_CAPI_CALLS_GENERATED_TABLE_H

#include <nurbs/nurbs.h>

#include <span>

namespace calls {

// What is made once for all calls.
struct Inputs {
    nurbs *curve, *loop, *surface, *volume, *homogeneous, *twist, *segment, *outline;
    nurbs_list *list;
    nurbs_statistics *no_statistics, *statistics;
    nurbs_face *face;
    nurbs_model *model;
};

inline constexpr nurbs *Inputs::*const splines[] = {&Inputs::curve, &Inputs::loop, &Inputs::surface,
    &Inputs::volume, &Inputs::homogeneous, &Inputs::twist, &Inputs::segment, &Inputs::outline};
inline constexpr nurbs_list *Inputs::*const lists[] = {&Inputs::list};
inline constexpr nurbs_statistics *Inputs::*const all_statistics[] = {&Inputs::no_statistics,
    &Inputs::statistics};
inline constexpr nurbs_face *Inputs::*const faces_made[] = {&Inputs::face};
inline constexpr nurbs_model *Inputs::*const models[] = {&Inputs::model};

namespace arrays {
inline constexpr double new_knots[] = {0.3, 0.6};
inline constexpr double params[] = {0.1, 0.9, 0.3, 0.7, 0.2, 0.6};
inline constexpr double center[] = {1, 2, 3};
inline constexpr double axis[] = {0, 1, 0};
inline constexpr double side[] = {1, 0, 0};
} // namespace arrays

namespace texts {
inline constexpr char file[] =
    "a file of the test programs                                             S      1\n"
    "1H,,1H;,4Htest,8Htest.igs,4Hnone,4Hnone,32,38,6,308,15,4Htest,1.,2,2HMM,G      1\n"
    "1,0.01,15H20260101.000000,1.E-6,10.,2Hme,4Hhere,11,0,15H20260101.000000;G      2\n"
    "     126       1       0       1       0       0       0       000000000D      1\n"
    "     126       0       0       2       0                                D      2\n"
    "     116       3       0       1       0       0       0       000000000D      3\n"
    "     116       0       0       1       0                                D      4\n"
    "     126       4       0       1       0       0       0       000000000D      5\n"
    "     126       0       0       1       0                     BOW        D      6\n"
    "126,3,3,0,0,1,0,0,0,0,0,1,1,1,1,1,1,1,1,                               1P      1\n"
    "0,0,0,1,2,0,3,2,0,4,0,0,0,1;                                           1P      2\n"
    "116,0,0,0,0;                                                           3P      3\n"
    "126,1,1,0,0,0,0,0,0,1,1,1,2,0,0,0,1,1,1,0,1;                           5P      4\n"
    "S      1G      2D      6P      4                                        T      1\n";
inline constexpr char solid[] =
    "ISO-10303-21;\n"
    "HEADER;\n"
    "FILE_SCHEMA(('AUTOMOTIVE_DESIGN'));\n"
    "ENDSEC;\n"
    "DATA;\n"
    "#1=CARTESIAN_POINT('',(0.,0.,0.));\n"
    "#2=DIRECTION('',(0.,0.,1.));\n"
    "#3=DIRECTION('',(1.,0.,0.));\n"
    "#4=AXIS2_PLACEMENT_3D('',#1,#2,#3);\n"
    "#5=CARTESIAN_POINT('',(1.,0.,0.));\n"
    "#6=VERTEX_POINT('',#5);\n"
    "#7=CIRCLE('',#4,1.);\n"
    "#8=EDGE_CURVE('',#6,#6,#7,.T.);\n"
    "#9=PLANE('',#4);\n"
    "#10=SPHERICAL_SURFACE('',#4,1.);\n"
    "#11=ORIENTED_EDGE('',*,*,#8,.F.);\n"
    "#12=EDGE_LOOP('',(#11));\n"
    "#13=FACE_OUTER_BOUND('',#12,.T.);\n"
    "#14=ADVANCED_FACE('disk',(#13),#9,.F.);\n"
    "#15=ORIENTED_EDGE('',*,*,#8,.T.);\n"
    "#16=EDGE_LOOP('',(#15));\n"
    "#17=FACE_OUTER_BOUND('',#16,.T.);\n"
    "#18=ADVANCED_FACE('half ball',(#17),#10,.T.);\n"
    "#19=CLOSED_SHELL('',(#14,#18));\n"
    "#20=MANIFOLD_SOLID_BREP('',#19);\n"
    "#21=BLOCK('',#4,1.,1.,1.);\n"
    "#22=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));\n"
    "#23=(GEOMETRIC_REPRESENTATION_CONTEXT(3)\n"
    "GLOBAL_UNIT_ASSIGNED_CONTEXT((#22))REPRESENTATION_CONTEXT('',''));\n"
    "#24=SHAPE_REPRESENTATION('',(#20,#21),#23);\n"
    "ENDSEC;\n"
    "END-ISO-10303-21;\n";
inline constexpr unsigned char no_data[] = {137, 78, 85, 82, 13, 10, 26, 10, 1, 0, 0, 0, 3, 0, 0, 0,
    192, 0, 0, 0, 0, 0, 0, 0, 114, 160, 102, 241, 94, 129, 142, 24, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 7, 0, 0, 0,
    0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    240, 63, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
inline constexpr unsigned char loop_bytes[] = {137, 78, 85, 82, 13, 10, 26, 10, 1, 0, 0, 0, 1, 0, 0,
    0, 96, 1, 0, 0, 0, 0, 0, 0, 97, 220, 175, 73, 171, 169, 167, 134, 1, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 6, 0, 0, 0, 0, 0, 0, 0, 2, 0, 0, 0,
    1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    240, 63, 0, 0, 0, 0, 0, 0, 0, 64, 0, 0, 0, 0, 0, 0, 8, 64, 0, 0, 0, 0, 0, 0, 16, 64, 0, 0, 0, 0,
    0, 0, 20, 64, 0, 0, 0, 0, 0, 0, 24, 64, 0, 0, 0, 0, 0, 0, 28, 64, 0, 0, 0, 0, 0, 0, 32, 64, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 240, 63, 0, 0, 0,
    0, 0, 0, 240, 63, 0, 0, 0, 0, 0, 0, 240, 191, 0, 0, 0, 0, 0, 0, 240, 63, 0, 0, 0, 0, 0, 0, 240,
    191, 0, 0, 0, 0, 0, 0, 240, 191, 0, 0, 0, 0, 0, 0, 240, 63, 0, 0, 0, 0, 0, 0, 240, 191, 0, 0, 0,
    0, 0, 0, 240, 63, 0, 0, 0, 0, 0, 0, 240, 63, 0, 0, 0, 0, 0, 0, 240, 191, 0, 0, 0, 0, 0, 0, 240,
    63};
inline constexpr unsigned char list_bytes[] = {137, 78, 85, 82, 13, 10, 26, 10, 1, 0, 0, 0, 2, 0, 0,
    0, 128, 2, 0, 0, 0, 0, 0, 0, 115, 101, 65, 29, 65, 41, 203, 126, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 252, 169, 241, 210, 77, 98, 80, 63, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 2, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 97, 98, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 128, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 137, 78, 85, 82, 13, 10, 26, 10, 1, 0, 0, 0, 1,
    0, 0, 0, 200, 0, 0, 0, 0, 0, 0, 0, 235, 190, 19, 224, 60, 109, 135, 43, 1, 0, 0, 0, 1, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 192, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 240, 63, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 20, 64, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
} // namespace texts

nurbs_status make_curve(const Inputs &in, nurbs **out);
nurbs_status make_loop(const Inputs &in, nurbs **out);
nurbs_status make_surface(const Inputs &in, nurbs **out);
nurbs_status make_volume(const Inputs &in, nurbs **out);
nurbs_status make_homogeneous(const Inputs &in, nurbs **out);
nurbs_status make_twist(const Inputs &in, nurbs **out);
nurbs_status make_segment(const Inputs &in, nurbs **out);
nurbs_status make_list(const Inputs &in, nurbs_list **out);
nurbs_status make_no_statistics(const Inputs &in, nurbs_statistics **out);
nurbs_status make_statistics(const Inputs &in, nurbs_statistics **out);
nurbs_status make_outline(const Inputs &in, nurbs **out);
nurbs_status make_face(const Inputs &in, nurbs_face **out);
nurbs_status make_model(const Inputs &in, nurbs_model **out);
nurbs_status make_copy(const Inputs &in, nurbs **out);
nurbs_status make_half(const Inputs &in, nurbs **out);
nurbs_status make_ramp(const Inputs &in, nurbs **out);
nurbs_status make_round(const Inputs &in, nurbs **out);
nurbs_status make_diagonal(const Inputs &in, nurbs **out);
nurbs_status make_square(const Inputs &in, nurbs **out);
nurbs_status make_sphere(const Inputs &in, nurbs **out);
nurbs_status make_edges(const Inputs &in, nurbs_list **out);
nurbs_status make_faces(const Inputs &in, nurbs_list **out);
nurbs_status make_more_statistics(const Inputs &in, nurbs_statistics **out);
nurbs_status make_another_model(const Inputs &in, nurbs_model **out);
nurbs_status make_another_face(const Inputs &in, nurbs_face **out);
nurbs_status make_south(const Inputs &in, nurbs **out);
nurbs_status make_east(const Inputs &in, nurbs **out);
nurbs_status make_north(const Inputs &in, nurbs **out);
nurbs_status make_west(const Inputs &in, nurbs **out);
nurbs_status make_first_edge(const Inputs &in, nurbs **out);
nurbs_status make_second_edge(const Inputs &in, nurbs **out);
nurbs_status make_third_edge(const Inputs &in, nurbs **out);

// Those of one kind.
struct Call;
std::span<const Call> data_calls();
std::span<const Call> edit_calls();
std::span<const Call> evaluation_calls();
std::span<const Call> form_calls();
std::span<const Call> query_calls();
std::span<const Call> scalar_calls();
std::span<const Call> shape_calls();

} // namespace calls

#endif
