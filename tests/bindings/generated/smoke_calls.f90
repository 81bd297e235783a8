! SPDX-License-Identifier: MIT
! Generated from tests/capi/calls/*.toml, include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
program smoke_calls
    use, intrinsic :: iso_c_binding
    use, intrinsic :: ieee_arithmetic
    use nurbs
    use smoke_support
    implicit none
    character(len=*), parameter :: file_text = &
        'a file of the test programs                                             S      1'//new_line('a')//&
        '1H,,1H;,4Htest,8Htest.igs,4Hnone,4Hnone,32,38,6,308,15,4Htest,1.,2,2HMM,G      1'//new_line('a')//&
        '1,0.01,15H20260101.000000,1.E-6,10.,2Hme,4Hhere,11,0,15H20260101.000000;G      2'//new_line('a')//&
        '     126       1       0       1       0       0       0       000000000D      1'//new_line('a')//&
        '     126       0       0       2       0                                D      2'//new_line('a')//&
        '     116       3       0       1       0       0       0       000000000D      3'//new_line('a')//&
        '     116       0       0       1       0                                D      4'//new_line('a')//&
        '     126       4       0       1       0       0       0       000000000D      5'//new_line('a')//&
        '     126       0       0       1       0                     BOW        D      6'//new_line('a')//&
        '126,3,3,0,0,1,0,0,0,0,0,1,1,1,1,1,1,1,1,                               1P      1'//new_line('a')//&
        '0,0,0,1,2,0,3,2,0,4,0,0,0,1;                                           1P      2'//new_line('a')//&
        '116,0,0,0,0;                                                           3P      3'//new_line('a')//&
        '126,1,1,0,0,0,0,0,0,1,1,1,2,0,0,0,1,1,1,0,1;                           5P      4'//new_line('a')//&
        'S      1G      2D      6P      4                                        T      1'//new_line('a')
    character(len=*), parameter :: solid_text = &
        'ISO-10303-21;'//new_line('a')//&
        'HEADER;'//new_line('a')//&
        'FILE_SCHEMA((''AUTOMOTIVE_DESIGN''));'//new_line('a')//&
        'ENDSEC;'//new_line('a')//&
        'DATA;'//new_line('a')//&
        '#1=CARTESIAN_POINT('''',(0.,0.,0.));'//new_line('a')//&
        '#2=DIRECTION('''',(0.,0.,1.));'//new_line('a')//&
        '#3=DIRECTION('''',(1.,0.,0.));'//new_line('a')//&
        '#4=AXIS2_PLACEMENT_3D('''',#1,#2,#3);'//new_line('a')//&
        '#5=CARTESIAN_POINT('''',(1.,0.,0.));'//new_line('a')//&
        '#6=VERTEX_POINT('''',#5);'//new_line('a')//&
        '#7=CIRCLE('''',#4,1.);'//new_line('a')//&
        '#8=EDGE_CURVE('''',#6,#6,#7,.T.);'//new_line('a')//&
        '#9=PLANE('''',#4);'//new_line('a')//&
        '#10=SPHERICAL_SURFACE('''',#4,1.);'//new_line('a')//&
        '#11=ORIENTED_EDGE('''',*,*,#8,.F.);'//new_line('a')//&
        '#12=EDGE_LOOP('''',(#11));'//new_line('a')//&
        '#13=FACE_OUTER_BOUND('''',#12,.T.);'//new_line('a')//&
        '#14=ADVANCED_FACE(''disk'',(#13),#9,.F.);'//new_line('a')//&
        '#15=ORIENTED_EDGE('''',*,*,#8,.T.);'//new_line('a')//&
        '#16=EDGE_LOOP('''',(#15));'//new_line('a')//&
        '#17=FACE_OUTER_BOUND('''',#16,.T.);'//new_line('a')//&
        '#18=ADVANCED_FACE(''half ball'',(#17),#10,.T.);'//new_line('a')//&
        '#19=CLOSED_SHELL('''',(#14,#18));'//new_line('a')//&
        '#20=MANIFOLD_SOLID_BREP('''',#19);'//new_line('a')//&
        '#21=BLOCK('''',#4,1.,1.,1.);'//new_line('a')//&
        '#22=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));'//new_line('a')//&
        '#23=(GEOMETRIC_REPRESENTATION_CONTEXT(3)'//new_line('a')//&
        'GLOBAL_UNIT_ASSIGNED_CONTEXT((#22))REPRESENTATION_CONTEXT('''',''''));'//new_line('a')//&
        '#24=SHAPE_REPRESENTATION('''',(#20,#21),#23);'//new_line('a')//&
        'ENDSEC;'//new_line('a')//&
        'END-ISO-10303-21;'//new_line('a')
    character(len=*), parameter :: layers_text = &
        'ISO-10303-21;'//new_line('a')//&
        'HEADER;'//new_line('a')//&
        'FILE_SCHEMA((''AUTOMOTIVE_DESIGN''));'//new_line('a')//&
        'ENDSEC;'//new_line('a')//&
        'DATA;'//new_line('a')//&
        '#1=CARTESIAN_POINT('''',(0.,0.,0.));'//new_line('a')//&
        '#2=CARTESIAN_POINT('''',(2.,0.,0.));'//new_line('a')//&
        '#3=CARTESIAN_POINT('''',(0.,4.,0.));'//new_line('a')//&
        '#4=DIRECTION('''',(0.,0.,1.));'//new_line('a')//&
        '#5=DIRECTION('''',(1.,0.,0.));'//new_line('a')//&
        '#6=AXIS2_PLACEMENT_3D('''',#1,#4,#5);'//new_line('a')//&
        '#7=PLANE('''',#6);'//new_line('a')//&
        '#8=POLY_LOOP('''',(#1,#2,#3));'//new_line('a')//&
        '#9=FACE_OUTER_BOUND('''',#8,.T.);'//new_line('a')//&
        '#10=ADVANCED_FACE('''',(#9),#7,.T.);'//new_line('a')//&
        '#11=POLYLINE('''',(#1,#2));'//new_line('a')//&
        '#12=PRESENTATION_LAYER_ASSIGNMENT(''sheet'','''',(#10,#11));'//new_line('a')//&
        '#13=PRESENTATION_LAYER_ASSIGNMENT(''axis'','''',(#10,#11));'//new_line('a')//&
        'ENDSEC;'//new_line('a')//&
        'END-ISO-10303-21;'//new_line('a')
    character(len=*), parameter :: replaced_text = &
        'an older file'//new_line('a')
    character(len=*), parameter :: no_data_part_1 = &
        char(137)//char(78)//char(85)//char(82)//char(13)//char(10)//char(26)//char(10)//&
        char(1)//char(0)//char(0)//char(0)//char(3)//char(0)//char(0)//char(0)//&
        char(192)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(114)//char(160)//char(102)//char(241)//char(94)//char(129)//char(142)//char(24)//&
        char(1)//char(0)//char(0)//char(0)//char(1)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(7)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(1)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(2)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(240)//char(63)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)
    character(len=*), parameter :: no_data_text = no_data_part_1
    character(len=*), parameter :: loop_bytes_part_1 = &
        char(137)//char(78)//char(85)//char(82)//char(13)//char(10)//char(26)//char(10)//&
        char(1)//char(0)//char(0)//char(0)//char(1)//char(0)//char(0)//char(0)//&
        char(96)//char(1)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(97)//char(220)//char(175)//char(73)//char(171)//char(169)//char(167)//char(134)//&
        char(1)//char(0)//char(0)//char(0)//char(2)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(6)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(2)//char(0)//char(0)//char(0)//char(1)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(1)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(240)//char(63)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(64)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(8)//char(64)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(16)//char(64)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(20)//char(64)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(24)//char(64)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(28)//char(64)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(32)//char(64)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(240)//char(63)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(240)//char(63)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(240)//char(191)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(240)//char(63)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(240)//char(191)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(240)//char(191)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(240)//char(63)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(240)//char(191)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(240)//char(63)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(240)//char(63)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(240)//char(191)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(240)//char(63)
    character(len=*), parameter :: loop_bytes_text = loop_bytes_part_1
    character(len=*), parameter :: list_bytes_part_1 = &
        char(137)//char(78)//char(85)//char(82)//char(13)//char(10)//char(26)//char(10)//&
        char(1)//char(0)//char(0)//char(0)//char(2)//char(0)//char(0)//char(0)//&
        char(128)//char(2)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(115)//char(101)//char(65)//char(29)//char(65)//char(41)//char(203)//char(126)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(2)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(1)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(2)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(252)//char(169)//char(241)//char(210)//char(77)//char(98)//char(80)//char(63)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(1)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(2)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(97)//char(98)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(128)//char(1)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(137)//char(78)//char(85)//char(82)//char(13)//char(10)//char(26)//char(10)//&
        char(1)//char(0)//char(0)//char(0)//char(1)//char(0)//char(0)//char(0)//&
        char(200)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(235)//char(190)//char(19)//char(224)//char(60)//char(109)//char(135)//char(43)//&
        char(1)//char(0)//char(0)//char(0)//char(1)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(1)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(192)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(240)//char(63)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(20)//char(64)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)
    character(len=*), parameter :: list_bytes_text = list_bytes_part_1
    character(len=*), parameter :: face_bytes_part_1 = &
        char(137)//char(78)//char(85)//char(82)//char(13)//char(10)//char(26)//char(10)//&
        char(1)//char(0)//char(0)//char(0)//char(4)//char(0)//char(0)//char(0)//&
        char(192)//char(3)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(56)//char(218)//char(45)//char(130)//char(130)//char(9)//char(70)//char(207)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(1)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(1)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(2)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(1)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(1)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(1)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(255)//char(255)//char(255)//char(255)//char(255)//char(255)//char(255)//char(255)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(128)//char(1)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(192)//char(2)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(137)//char(78)//char(85)//char(82)//char(13)//char(10)//char(26)//char(10)//&
        char(1)//char(0)//char(0)//char(0)//char(1)//char(0)//char(0)//char(0)//&
        char(32)//char(1)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(169)//char(227)//char(47)//char(52)//char(97)//char(141)//char(100)//char(180)//&
        char(2)//char(0)//char(0)//char(0)//char(3)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(2)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(1)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(2)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(1)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(192)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(240)//char(63)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(240)//char(63)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(240)//char(63)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(240)//char(63)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(8)//char(64)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(64)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(64)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(8)//char(64)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(137)//char(78)//char(85)//char(82)//char(13)//char(10)//char(26)//char(10)//&
        char(1)//char(0)//char(0)//char(0)//char(1)//char(0)//char(0)//char(0)//&
        char(0)//char(1)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(236)//char(145)//char(236)//char(61)//char(80)//char(26)//char(21)//char(238)//&
        char(1)//char(0)//char(0)//char(0)//char(2)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(4)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(1)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(192)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(240)//char(63)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(64)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(8)//char(64)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(8)//char(64)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(240)//char(63)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(240)//char(63)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)
    character(len=*), parameter :: face_bytes_text = face_bytes_part_1
    character(len=*), parameter :: model_bytes_part_1 = &
        char(137)//char(78)//char(85)//char(82)//char(13)//char(10)//char(26)//char(10)//&
        char(1)//char(0)//char(0)//char(0)//char(5)//char(0)//char(0)//char(0)//&
        char(64)//char(8)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(7)//char(61)//char(156)//char(237)//char(55)//char(224)//char(208)//char(143)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(1)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(1)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(1)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(1)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(1)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(1)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(1)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(1)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(3)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(252)//char(169)//char(241)//char(210)//char(77)//char(98)//char(80)//char(63)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(255)//char(255)//char(255)//char(255)//char(255)//char(255)//char(255)//char(255)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(240)//char(63)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(240)//char(63)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(240)//char(63)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(255)//char(255)//char(255)//char(255)//char(255)//char(255)//char(255)//char(255)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(255)//char(255)//char(255)//char(255)//char(255)//char(255)//char(255)//char(255)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(1)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(1)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(1)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(255)//char(255)//char(255)//char(255)//char(255)//char(255)//char(255)//char(255)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(2)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(255)//char(255)//char(255)//char(255)//char(255)//char(255)//char(255)//char(255)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(1)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(48)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(64)//char(4)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(128)//char(5)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(128)//char(6)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(137)//char(78)//char(85)//char(82)//char(13)//char(10)//char(26)//char(10)//&
        char(1)//char(0)//char(0)//char(0)//char(1)//char(0)//char(0)//char(0)//&
        char(32)//char(1)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(169)//char(227)//char(47)//char(52)//char(97)//char(141)//char(100)//char(180)//&
        char(2)//char(0)//char(0)//char(0)//char(3)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(2)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(1)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(2)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(1)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(192)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(240)//char(63)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(240)//char(63)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(240)//char(63)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(240)//char(63)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(8)//char(64)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(64)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(64)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(8)//char(64)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(137)//char(78)//char(85)//char(82)//char(13)//char(10)//char(26)//char(10)//&
        char(1)//char(0)//char(0)//char(0)//char(1)//char(0)//char(0)//char(0)//&
        char(0)//char(1)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(236)//char(145)//char(236)//char(61)//char(80)//char(26)//char(21)//char(238)//&
        char(1)//char(0)//char(0)//char(0)//char(2)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(4)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(1)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(192)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(240)//char(63)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(64)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(8)//char(64)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(8)//char(64)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)
    character(len=*), parameter :: model_bytes_part_2 = &
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(240)//char(63)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(240)//char(63)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(137)//char(78)//char(85)//char(82)//char(13)//char(10)//char(26)//char(10)//&
        char(1)//char(0)//char(0)//char(0)//char(1)//char(0)//char(0)//char(0)//&
        char(168)//char(1)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(150)//char(234)//char(15)//char(242)//char(87)//char(183)//char(219)//char(255)//&
        char(1)//char(0)//char(0)//char(0)//char(3)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(7)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(2)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(1)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(240)//char(63)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(240)//char(63)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(64)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(64)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(8)//char(64)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(8)//char(64)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(8)//char(64)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(240)//char(63)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(64)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(240)//char(63)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(248)//char(63)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(8)//char(64)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(248)//char(63)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//&
        char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)//char(0)
    character(len=*), parameter :: model_bytes_text = model_bytes_part_1//model_bytes_part_2
    type(nurbs_spline) :: curve
    type(nurbs_spline) :: loop
    type(nurbs_spline) :: surface
    type(nurbs_spline) :: volume
    type(nurbs_spline) :: solid
    type(nurbs_spline) :: homogeneous
    type(nurbs_spline) :: twist
    type(nurbs_spline) :: segment
    type(nurbs_list) :: list
    type(nurbs_statistics) :: no_statistics
    type(nurbs_statistics) :: statistics
    type(nurbs_spline) :: outline
    type(nurbs_face) :: face
    type(nurbs_model) :: model
    type(nurbs_model) :: layered
    type(nurbs_meet) :: meet
    type(nurbs_mesh) :: mesh
    type(nurbs_mesh) :: block
    type(nurbs_data) :: data_given
    real(c_double), target :: data_params(5, 1)
    real(c_double), target :: data_values(5, 1)
    type(nurbs_spline) :: curves_given(1)
    type(nurbs_face) :: faces_given(2)
    type(nurbs_mesh_options) :: options_given

    call curve%create(degrees=[2], counts=[9], knots=[0.0d0, 0.0d0, 0.0d0, 0.25d0, 0.25d0, 0.5d0, 0.5d0, 0.75d0, &
        0.75d0, 1.0d0, 1.0d0, 1.0d0], points=reshape([1.0d0, 0.0d0, 1.0d0, 1.0d0, 0.0d0, 1.0d0, -1.0d0, 1.0d0, -1.0d0, &
        0.0d0, -1.0d0, -1.0d0, 0.0d0, -1.0d0, 1.0d0, -1.0d0, 1.0d0, 0.0d0], [9, 2], order=[2, 1]), weights=[1.0d0, &
        0.7071067811865476d0, 1.0d0, 0.7071067811865476d0, 1.0d0, 0.7071067811865476d0, 1.0d0, 0.7071067811865476d0, &
        1.0d0], flags=0)
    call loop%create(degrees=[2], counts=[6], knots=[0.0d0, 1.0d0, 2.0d0, 3.0d0, 4.0d0, 5.0d0, 6.0d0, 7.0d0, 8.0d0], &
        points=reshape([1.0d0, 1.0d0, -1.0d0, 1.0d0, -1.0d0, -1.0d0, 1.0d0, -1.0d0, 1.0d0, 1.0d0, -1.0d0, 1.0d0], [6, &
        2], order=[2, 1]), flags=1)
    call surface%create(degrees=[2, 1], counts=[3, 4], knots=[0.0d0, 0.0d0, 0.0d0, 1.0d0, 1.0d0, 1.0d0, 0.0d0, 0.0d0, &
        1.0d0, 2.0d0, 3.0d0, 3.0d0], points=reshape([0.0d0, 0.0d0, 0.0d0, 0.0d0, 1.0d0, 1.0d0, 0.0d0, 2.0d0, 2.0d0, &
        0.0d0, 3.0d0, 3.0d0, 0.5d0, 0.0d0, 0.0d0, 0.5d0, 1.0d0, 1.0d0, 0.5d0, 2.0d0, 2.0d0, 0.5d0, 3.0d0, 3.0d0, &
        1.0d0, 0.0d0, 1.0d0, 1.0d0, 1.0d0, 2.0d0, 1.0d0, 2.0d0, 3.0d0, 1.0d0, 3.0d0, 4.0d0], [12, 3], order=[2, 1]), &
        flags=0)
    call volume%create(degrees=[1, 1, 1], counts=[2, 2, 2], knots=[0.0d0, 0.0d0, 1.0d0, 1.0d0, 0.0d0, 0.0d0, 1.0d0, &
        1.0d0, 0.0d0, 0.0d0, 1.0d0, 1.0d0], points=reshape([0.0d0, 0.0d0, 0.0d0, 0.0d0, 0.0d0, 0.0d0, 1.0d0, 0.0d0, &
        0.0d0, 1.0d0, 0.0d0, 0.0d0, 0.0d0, 1.0d0, 1.0d0, 0.0d0, 1.0d0, 0.0d0, 0.0d0, 0.0d0, 1.0d0, 0.0d0, 1.0d0, &
        0.0d0, 1.0d0, 1.0d0, 0.0d0, 0.0d0, 1.0d0, 1.0d0, 1.0d0, 1.0d0], [8, 4], order=[2, 1]), flags=0)
    call solid%create(degrees=[1, 2, 1], counts=[3, 3, 2], knots=[0.0d0, 0.0d0, 0.5d0, 1.0d0, 1.0d0, 0.0d0, 0.0d0, &
        0.0d0, 1.0d0, 1.0d0, 1.0d0, 0.0d0, 0.0d0, 1.0d0, 1.0d0], &
        points=reshape([0.0d0, 0.0d0, 0.0d0, 0.0d0, 0.0d0, 1.0d0, 0.0d0, 0.5d0, 0.0d0, 0.0d0, 0.5d0, 1.0d0, 0.25d0, &
        1.0d0, 0.0d0, 0.25d0, 1.0d0, 1.0d0, 0.5d0, 0.0d0, 0.0d0, 0.5d0, 0.0d0, 1.0d0, 0.5d0, 0.5d0, 0.0d0, 0.5d0, &
        0.5d0, 1.0d0, 0.75d0, 1.0d0, 0.0d0, 0.75d0, 1.0d0, 1.0d0, 1.0d0, 0.0d0, 0.0d0, 1.0d0, 0.0d0, 1.0d0, 1.0d0, &
        0.5d0, 0.0d0, 1.0d0, 0.5d0, 1.0d0, 1.25d0, 1.0d0, 0.0d0, 1.25d0, 1.0d0, 1.0d0], [18, 3], order=[2, 1]), flags=0)
    call homogeneous%create_homogeneous(degrees=[2], counts=[3], knots=[0.0d0, 0.0d0, 0.0d0, 1.0d0, 1.0d0, 1.0d0], &
        points=reshape([1.0d0, 0.0d0, 1.0d0, 0.0d0, 1.0d0, 0.0d0, -1.0d0, 0.0d0, 1.0d0], [3, 3], order=[2, 1]), flags=0)
    call twist%create(degrees=[3], counts=[4], knots=[0.0d0, 0.0d0, 0.0d0, 0.0d0, 1.0d0, 1.0d0, 1.0d0, 1.0d0], &
        points=reshape([0.0d0, 0.0d0, 0.0d0, 1.0d0, 0.0d0, 0.0d0, 2.0d0, 1.0d0, 0.0d0, 3.0d0, 3.0d0, 3.0d0], [4, 3], &
        order=[2, 1]), flags=0)
    call segment%create(degrees=[2], counts=[3], knots=[0.0d0, 1.0d0, 2.0d0, 3.0d0, 4.0d0, 5.0d0], &
        points=reshape([0.0d0, 0.0d0, 1.0d0, 1.0d0, 2.0d0, 0.0d0], [3, 2], order=[2, 1]), weights=[1.0d0, 3.0d0, &
        5.0d0], flags=0)
    call list%read(contents=file_text)
    call no_statistics%create(degrees=[2], break_counts=[3], breaks=[0.0d0, 0.5d0, 1.0d0], dim=1, value_scale=4.0d0, &
        weight_scale=1.0d0)
    data_params = reshape([0.0d0, 0.25d0, 0.5d0, 0.75d0, 1.0d0], [5, 1], order=[2, 1])
    data_values = reshape([0.0d0, 1.0d0, 2.0d0, 1.0d0, 0.0d0], [5, 1], order=[2, 1])
    call data_for_fits(data_given, params=data_params, values=data_values)
    call no_statistics%add(data=data_given, out=statistics)
    call outline%create(degrees=[1], counts=[4], knots=[0.0d0, 0.0d0, 1.0d0, 2.0d0, 3.0d0, 3.0d0], &
        points=reshape([0.25d0, 1.0d0, 0.75d0, 1.0d0, 0.5d0, 2.0d0, 0.25d0, 1.0d0], [4, 2], order=[2, 1]), flags=0)
    curves_given(1) = outline
    call face%create(surface=surface, sizes=[1], curves=curves_given, tolerance=0.001d0, flags=0)
    faces_given(1) = face
    faces_given(2) = face
    call model%create(faces=faces_given, metres=0.001d0)
    call layered%read(contents=layers_text)
    call meet%sections(g=surface, normal=[0.0d0, 0.0d0, 1.0d0], offsets=[0.5d0, 2.0d0], tolerance=0.001d0)
    call default_mesh_options(options_given)
    options_given%chord = 1.0d0
    options_given%relative_chord = 0.0d0
    call mesh%of_face(face=face, options=options_given)
    call default_mesh_options(options_given)
    options_given%chord = 0.1d0
    options_given%relative_chord = 0.0d0
    call block%of_volume(g=solid, options=options_given, limit=100)
    call calls_of_data()
    call calls_of_edit()
    call calls_of_evaluation()
    call calls_of_form()
    call calls_of_query()
    call calls_of_scalar()
    call calls_of_shape()

contains

    subroutine calls_of_data()
        call by_hand('clone')
        call by_hand('destroy')
        call begin('with_points')
        block
            type(nurbs_spline) :: out_found
            call curve%with_points(points=reshape([1.0d0, 0.0d0, 1.0d0, 1.0d0, 0.0d0, 1.0d0, -1.0d0, 1.0d0, -1.0d0, &
                0.0d0, -1.0d0, -1.0d0, 0.0d0, -1.0d0, 1.0d0, -1.0d0, 1.0d0, 0.0d0], [9, 2], order=[2, 1]), &
                out=out_found)
            call show('out', out_found)
        end block
        call begin('with_points rational')
        block
            type(nurbs_spline) :: out_found
            call curve%with_points(points=reshape([1.0d0, 0.0d0, 1.0d0, 1.0d0, 0.0d0, 1.0d0, -1.0d0, 1.0d0, -1.0d0, &
                0.0d0, -1.0d0, -1.0d0, 0.0d0, -1.0d0, 1.0d0, -1.0d0, 1.0d0, 0.0d0], [9, 2], order=[2, 1]), &
                out=out_found, weights=[1.0d0, 0.7071067811865476d0, 1.0d0, 0.7071067811865476d0, 1.0d0, &
                0.7071067811865476d0, 1.0d0, 0.7071067811865476d0, 1.0d0])
            call show('out', out_found)
        end block
        call begin('create_bezier')
        block
            type(nurbs_spline) :: found
            call found%create_bezier(degrees=[3], points=reshape([0.0d0, 0.0d0, 1.0d0, 2.0d0, 3.0d0, 2.0d0, 4.0d0, &
                0.0d0], [4, 2], order=[2, 1]))
            call show('out', found)
        end block
        call begin('create_hermite')
        block
            type(nurbs_spline) :: out_found
            call create_hermite_spline(out=out_found, params=[0.3d0, 0.6d0], &
                points=reshape([0.1d0, 0.9d0, 0.3d0, 0.7d0], [2, 2], order=[2, 1]), &
                tangents=reshape([0.1d0, 0.9d0, 0.3d0, 0.7d0], [2, 2], order=[2, 1]))
            call show('out', out_found)
        end block
        call begin('parametrize')
        block
            real(c_double), allocatable :: params_found(:)
            allocate (params_found(4))
            call parametrize(counts=[4], points=reshape([0.0d0, 0.0d0, 1.0d0, 2.0d0, 3.0d0, 2.0d0, 4.0d0, 0.0d0], [4, &
                2], order=[2, 1]), rule=4, params=params_found, exponent=0.0d0, flags=0)
            call show('params', params_found)
        end block
        call begin('params_universal')
        block
            real(c_double), allocatable :: params_found(:)
            allocate (params_found(7))
            call params_universal(degree=3, params=params_found)
            call show('params', params_found)
        end block
        call begin('tangents')
        block
            real(c_double), allocatable :: tangents_found(:, :)
            allocate (tangents_found(4, 1))
            call tangents_at(rule=2, params=[0.0d0, 1.0d0, 3.0d0, 4.0d0], &
                points=reshape([0.0d0, 1.0d0, 2.0d0, 4.0d0], [4, 1], order=[2, 1]), tangents=tangents_found, flags=0)
            call show('tangents', flat(reshape(tangents_found, [size(tangents_found, 2), size(tangents_found, 1)], &
                order=[2, 1])))
        end block
        call begin('tangents monotone')
        block
            real(c_double), allocatable :: tangents_found(:, :)
            allocate (tangents_found(4, 1))
            call tangents_at(rule=3, params=[0.0d0, 1.0d0, 3.0d0, 4.0d0], &
                points=reshape([0.0d0, 1.0d0, 2.0d0, 0.0d0], [4, 1], order=[2, 1]), tangents=tangents_found, flags=1)
            call show('tangents', flat(reshape(tangents_found, [size(tangents_found, 2), size(tangents_found, 1)], &
                order=[2, 1])))
        end block
        call begin('parametrize surface')
        block
            real(c_double), allocatable :: params_found(:)
            allocate (params_found(4))
            call parametrize(counts=[2, 2], points=reshape([0.0d0, 0.0d0, 1.0d0, 2.0d0, 3.0d0, 2.0d0, 4.0d0, 0.0d0], &
                [4, 2], order=[2, 1]), rule=1, params=params_found, exponent=0.0d0, flags=0)
            call show('params', params_found)
        end block
        call begin('read')
        block
            type(nurbs_list) :: found
            call found%read(contents=file_text)
            call show('out', found)
        end block
        call begin('read in millimetres')
        block
            type(nurbs_read_options) :: options_given
            type(nurbs_list) :: found
            call default_read_options(options_given)
            options_given%unit = 0.001d0
            call found%read(contents=file_text, options=options_given)
            call show('out', found)
        end block
        call begin('read_file')
        block
            type(nurbs_list) :: found
            call found%read_file(path=written('smoke_calls_fortran.file', file_text))
            call show('out', found)
        end block
        call begin('read_file in millimetres')
        block
            type(nurbs_read_options) :: options_given
            type(nurbs_list) :: found
            call default_read_options(options_given)
            options_given%unit = 0.001d0
            call found%read_file(path=written('smoke_calls_fortran.file', file_text), options=options_given)
            call show('out', found)
        end block
        call begin('list_get')
        block
            type(nurbs_spline) :: out_found
            call list%get(index=1, out=out_found)
            call show('out', out_found)
        end block
        call by_hand('list_destroy')
        call begin('knots_uniform')
        block
            real(c_double), allocatable :: knots_found(:)
            call knots_uniform(degree=2, count=5, knots=knots_found, a=0.0d0, b=1.0d0)
            call show('knots', knots_found)
        end block
        call begin('knots_open_uniform')
        block
            real(c_double), allocatable :: knots_found(:)
            call knots_open_uniform(degree=2, count=5, knots=knots_found, a=0.0d0, b=1.0d0)
            call show('knots', knots_found)
        end block
        call begin('knots_bezier')
        block
            real(c_double), allocatable :: knots_found(:)
            call knots_bezier(degree=2, pieces=2, knots=knots_found)
            call show('knots', knots_found)
        end block
        call begin('knots_bezier with breaks')
        block
            real(c_double), allocatable :: knots_found(:)
            call knots_bezier(degree=2, pieces=1, knots=knots_found, breaks=[0.3d0, 0.6d0])
            call show('knots', knots_found)
        end block
        call begin('knots_averaged')
        block
            real(c_double), allocatable :: knots_found(:)
            call knots_averaged(degree=2, params=[0.0d0, 1.0d0, 2.0d0, 3.0d0, 4.0d0], knots=knots_found)
            call show('knots', knots_found)
        end block
        call begin('knots_periodic')
        block
            real(c_double), allocatable :: knots_found(:)
            call knots_periodic(degree=2, breaks=[0.0d0, 1.0d0, 2.0d0, 3.0d0], knots=knots_found)
            call show('knots', knots_found)
        end block
        call begin('knots_periodic twice')
        block
            real(c_double), allocatable :: knots_found(:)
            call knots_periodic(degree=2, breaks=[0.3d0, 0.6d0], knots=knots_found, multiplicities=[2, 2])
            call show('knots', knots_found)
        end block
        call begin('knots')
        block
            real(c_double), allocatable :: values_found(:)
            call curve%knots(axis=1, values=values_found)
            call show('knots', values_found)
        end block
        call begin('short_knots')
        block
            real(c_double), allocatable :: values_found(:)
            call curve%short_knots(axis=1, values=values_found)
            call show('knots', values_found)
        end block
        call begin('unwrapped_knots')
        block
            real(c_double), allocatable :: values_found(:)
            call loop%unwrapped_knots(axis=1, values=values_found)
            call show('knots', values_found)
        end block
        call begin('unwrapped_points')
        block
            real(c_double), allocatable :: values_found(:, :)
            real(c_double), allocatable :: weights_found(:)
            call loop%unwrapped_points(values=values_found, weights=weights_found)
            call show('points', flat(reshape(values_found, [size(values_found, 2), size(values_found, 1)], order=[2, &
                1])))
            call show('weights', weights_found)
        end block
        call by_hand('to_bytes')
        call begin('from_bytes')
        block
            type(nurbs_spline) :: found
            call found%from_bytes(contents=loop_bytes_text)
            call show('out', found)
        end block
        call begin('bytes_kind')
        block
            integer(c_int32_t) :: kind_found
            integer(c_int32_t) :: major_found
            integer(c_int32_t) :: minor_found
            call bytes_kind(contents=loop_bytes_text, kind=kind_found, major=major_found, minor=minor_found)
            call show('kind', kind_found)
            call show('major', major_found)
            call show('minor', minor_found)
        end block
        call by_hand('list_to_bytes')
        call begin('list_from_bytes')
        block
            type(nurbs_list) :: found
            call found%from_bytes(contents=list_bytes_text)
            call show('out', found)
        end block
        call by_hand('face_to_bytes')
        call begin('face_from_bytes')
        block
            type(nurbs_face) :: found
            call found%from_bytes(contents=face_bytes_text)
            call show('out', found)
        end block
        call by_hand('model_to_bytes')
        call begin('model_from_bytes')
        block
            type(nurbs_model) :: found
            call found%from_bytes(contents=model_bytes_text)
            call show('out', found)
        end block
        call by_hand('list_create')
        call begin('distinct_knots')
        block
            real(c_double), allocatable :: values_found(:)
            integer(c_int32_t), allocatable :: multiplicities_found(:)
            call curve%distinct_knots(axis=1, values=values_found, multiplicities=multiplicities_found)
            call show('knots', values_found)
            call show('multiplicities', multiplicities_found)
        end block
        call begin('greville')
        block
            real(c_double), allocatable :: values_found(:)
            call curve%greville(axis=1, values=values_found)
            call show('abscissae', values_found)
        end block
        call begin('points')
        block
            real(c_double), allocatable :: values_found(:, :)
            call homogeneous%points(values=values_found)
            call show('points', flat(reshape(values_found, [size(values_found, 2), size(values_found, 1)], order=[2, &
                1])))
        end block
        call begin('weights')
        block
            real(c_double), allocatable :: values_found(:)
            call curve%weights(values=values_found)
            call show('weights', values_found)
        end block
        call begin('homogeneous_points')
        block
            real(c_double), allocatable :: values_found(:, :)
            call curve%homogeneous_points(values=values_found)
            call show('points', flat(reshape(values_found, [size(values_found, 2), size(values_found, 1)], order=[2, &
                1])))
        end block
        call begin('detect_periodic')
        block
            call show('periodic', detect_periodic(spline=curve, axis=1))
        end block
        call begin('eval_knot_derivative')
        block
            type(nurbs_spline) :: out_found
            call spline_knot_derivative(g=curve, axis=1, knot=4, out=out_found)
            call show('out', out_found)
        end block
        call begin('eval_knot_derivative of a period')
        block
            type(nurbs_spline) :: out_found
            call spline_knot_derivative(g=loop, axis=1, knot=1, out=out_found)
            call show('out', out_found)
        end block
        call begin('to_hermite')
        block
            real(c_double), allocatable :: params_found(:)
            real(c_double), allocatable :: points_found(:, :)
            real(c_double), allocatable :: tangents_found(:, :)
            call hermite_data(g=twist, params=params_found, points=points_found, tangents=tangents_found)
            call show('params', params_found)
            call show('points', flat(reshape(points_found, [size(points_found, 2), size(points_found, 1)], order=[2, &
                1])))
            call show('tangents', flat(reshape(tangents_found, [size(tangents_found, 2), size(tangents_found, 1)], &
                order=[2, 1])))
        end block
        call begin('to_power')
        block
            real(c_double), allocatable :: coefficients_found(:, :)
            real(c_double), allocatable :: breaks_found(:)
            integer(c_int64_t), allocatable :: piece_counts_found(:)
            call power_form(g=curve, coefficients=coefficients_found, breaks=breaks_found, &
                piece_counts=piece_counts_found)
            call show('coefficients', flat(coefficients_found))
            call show('breaks', breaks_found)
            call show('piece_counts', piece_counts_found)
        end block
        call begin('to_power surface')
        block
            real(c_double), allocatable :: coefficients_found(:, :)
            real(c_double), allocatable :: breaks_found(:)
            integer(c_int64_t), allocatable :: piece_counts_found(:)
            call power_form(g=surface, coefficients=coefficients_found, breaks=breaks_found, &
                piece_counts=piece_counts_found)
            call show('coefficients', flat(coefficients_found))
            call show('breaks', breaks_found)
            call show('piece_counts', piece_counts_found)
        end block
        call begin('bezier_extraction')
        block
            real(c_double), allocatable :: operators_found(:, :, :)
            integer(c_int64_t), allocatable :: firsts_found(:)
            real(c_double), allocatable :: domains_found(:, :)
            call curve%bezier_extraction(axis=1, operators=operators_found, firsts=firsts_found, domains=domains_found)
            call show('operators', flat(operators_found))
            call show('firsts', firsts_found - 1)
            call show('domains', flat(domains_found))
        end block
        call begin('refinement_matrix')
        block
            real(c_double), allocatable :: values_found(:)
            integer(c_int64_t), allocatable :: columns_found(:)
            integer(c_int64_t), allocatable :: row_pointers_found(:)
            call curve%refinement_matrix(axis=1, knots=[0.3d0, 0.6d0], values=values_found, columns=columns_found, &
                row_pointers=row_pointers_found)
            call show('values', values_found)
            call show('columns', columns_found - 1)
            call show('row_pointers', row_pointers_found - 1)
        end block
        call begin('basis_matrix')
        block
            real(c_double), allocatable :: matrix_found(:, :)
            allocate (matrix_found(4, 4))
            call basis_matrix(from=0, to=3, matrix=matrix_found)
            call show('matrix', flat(reshape(matrix_found, [size(matrix_found, 2), size(matrix_found, 1)], order=[2, &
                1])))
        end block
        call begin('decompose')
        block
            type(nurbs_list) :: found
            call found%decompose(spline=surface)
            call show('out', found)
        end block
        call begin('bezier_pieces')
        block
            real(c_double), allocatable :: points_found(:, :)
            real(c_double), allocatable :: weights_found(:)
            real(c_double), allocatable :: domains_found(:, :, :)
            integer(c_int64_t), allocatable :: piece_counts_found(:)
            call surface%bezier_pieces(points=points_found, weights=weights_found, domains=domains_found, &
                piece_counts=piece_counts_found)
            call show('points', flat(reshape(points_found, [size(points_found, 2), size(points_found, 1)], order=[2, &
                1])))
            call show('weights', weights_found)
            call show('domains', flat(domains_found))
            call show('piece_counts', piece_counts_found)
        end block
        call begin('bezier_pieces rational')
        block
            real(c_double), allocatable :: points_found(:, :)
            real(c_double), allocatable :: weights_found(:)
            real(c_double), allocatable :: domains_found(:, :, :)
            integer(c_int64_t), allocatable :: piece_counts_found(:)
            call curve%bezier_pieces(points=points_found, weights=weights_found, domains=domains_found, &
                piece_counts=piece_counts_found)
            call show('points', flat(reshape(points_found, [size(points_found, 2), size(points_found, 1)], order=[2, &
                1])))
            call show('weights', weights_found)
            call show('domains', flat(domains_found))
            call show('piece_counts', piece_counts_found)
        end block
        call begin('bezier_cells')
        block
            integer(c_int64_t), allocatable :: cells_found(:, :)
            integer(c_int32_t) :: kind_found
            integer(c_int64_t) :: point_count_found
            call bezier_cells(g=surface, cells=cells_found, kind=kind_found, point_count=point_count_found)
            call show('own_points', flat(reshape(cells_found, [size(cells_found, 2), size(cells_found, 1)], order=[2, &
                1])) - 1)
            call show('kind', kind_found)
            call show('points', point_count_found)
        end block
        call begin('bezier_cells closed')
        block
            integer(c_int64_t), allocatable :: cells_found(:, :)
            call bezier_cells(g=loop, cells=cells_found)
            call show('own_points', flat(reshape(cells_found, [size(cells_found, 2), size(cells_found, 1)], order=[2, &
                1])) - 1)
        end block
        call begin('bezier_cell_points')
        block
            real(c_double), allocatable :: points_found(:, :)
            real(c_double), allocatable :: weights_found(:)
            call bezier_cell_points(g=surface, points=points_found, weights=weights_found)
            call show('points', flat(reshape(points_found, [size(points_found, 2), size(points_found, 1)], order=[2, &
                1])))
            call show('weights', weights_found)
        end block
        call begin('bezier_cell_points rational')
        block
            real(c_double), allocatable :: points_found(:, :)
            real(c_double), allocatable :: weights_found(:)
            call bezier_cell_points(g=curve, points=points_found, weights=weights_found)
            call show('points', flat(reshape(points_found, [size(points_found, 2), size(points_found, 1)], order=[2, &
                1])))
            call show('weights', weights_found)
        end block
        call begin('split_at_knots')
        block
            type(nurbs_list) :: found
            call found%split_at_knots(spline=curve, axis=1, order=1)
            call show('out', found)
        end block
        call begin('boundaries')
        block
            type(nurbs_list) :: list_found
            call spline_boundaries(g=volume, list=list_found)
            call show('out', list_found)
        end block
        call begin('create curve')
        block
            type(nurbs_spline) :: found
            call found%create(degrees=[2], counts=[9], knots=[0.0d0, 0.0d0, 0.0d0, 0.25d0, 0.25d0, 0.5d0, 0.5d0, &
                0.75d0, 0.75d0, 1.0d0, 1.0d0, 1.0d0], points=reshape([1.0d0, 0.0d0, 1.0d0, 1.0d0, 0.0d0, 1.0d0, &
                -1.0d0, 1.0d0, -1.0d0, 0.0d0, -1.0d0, -1.0d0, 0.0d0, -1.0d0, 1.0d0, -1.0d0, 1.0d0, 0.0d0], [9, 2], &
                order=[2, 1]), weights=[1.0d0, 0.7071067811865476d0, 1.0d0, 0.7071067811865476d0, 1.0d0, &
                0.7071067811865476d0, 1.0d0, 0.7071067811865476d0, 1.0d0], flags=0)
            call show('out', found)
        end block
        call begin('create loop')
        block
            type(nurbs_spline) :: found
            call found%create(degrees=[2], counts=[6], knots=[0.0d0, 1.0d0, 2.0d0, 3.0d0, 4.0d0, 5.0d0, 6.0d0, 7.0d0, &
                8.0d0], points=reshape([1.0d0, 1.0d0, -1.0d0, 1.0d0, -1.0d0, -1.0d0, 1.0d0, -1.0d0, 1.0d0, 1.0d0, &
                -1.0d0, 1.0d0], [6, 2], order=[2, 1]), flags=1)
            call show('out', found)
        end block
        call begin('create volume')
        block
            type(nurbs_spline) :: found
            call found%create(degrees=[1, 1, 1], counts=[2, 2, 2], knots=[0.0d0, 0.0d0, 1.0d0, 1.0d0, 0.0d0, 0.0d0, &
                1.0d0, 1.0d0, 0.0d0, 0.0d0, 1.0d0, 1.0d0], points=reshape([0.0d0, 0.0d0, 0.0d0, 0.0d0, 0.0d0, 0.0d0, &
                1.0d0, 0.0d0, 0.0d0, 1.0d0, 0.0d0, 0.0d0, 0.0d0, 1.0d0, 1.0d0, 0.0d0, 1.0d0, 0.0d0, 0.0d0, 0.0d0, &
                1.0d0, 0.0d0, 1.0d0, 0.0d0, 1.0d0, 1.0d0, 0.0d0, 0.0d0, 1.0d0, 1.0d0, 1.0d0, 1.0d0], [8, 4], order=[2, &
                1]), flags=0)
            call show('out', found)
        end block
        call begin('create_homogeneous')
        block
            type(nurbs_spline) :: found
            call found%create_homogeneous(degrees=[2], counts=[6], knots=[0.0d0, 1.0d0, 2.0d0, 3.0d0, 4.0d0, 5.0d0, &
                6.0d0, 7.0d0, 8.0d0], points=reshape([1.0d0, 1.0d0, 1.0d0, 2.0d0, -1.0d0, 1.0d0, -1.0d0, -1.0d0, &
                1.0d0, -1.0d0, 1.0d0, 2.0d0], [6, 2], order=[2, 1]), flags=0)
            call show('out', found)
        end block
        call begin('create_periodic')
        block
            type(nurbs_spline) :: found
            call found%create_periodic(degrees=[2], counts=[4], knots=[2.0d0, 3.0d0, 4.0d0, 5.0d0, 6.0d0], &
                points=reshape([1.0d0, 1.0d0, -1.0d0, 1.0d0, -1.0d0, -1.0d0, 1.0d0, -1.0d0], [4, 2], order=[2, 1]), &
                weights=[1.0d0, 2.0d0, 1.0d0, 0.5d0], flags=1)
            call show('out', found)
        end block
        call begin('create_short')
        block
            type(nurbs_spline) :: found
            call found%create_short(degrees=[2], counts=[9], knots=[0.0d0, 0.0d0, 0.25d0, 0.25d0, 0.5d0, 0.5d0, &
                0.75d0, 0.75d0, 1.0d0, 1.0d0], points=reshape([1.0d0, 0.0d0, 1.0d0, 1.0d0, 0.0d0, 1.0d0, -1.0d0, &
                1.0d0, -1.0d0, 0.0d0, -1.0d0, -1.0d0, 0.0d0, -1.0d0, 1.0d0, -1.0d0, 1.0d0, 0.0d0], [9, 2], order=[2, &
                1]), weights=[1.0d0, 0.7071067811865476d0, 1.0d0, 0.7071067811865476d0, 1.0d0, 0.7071067811865476d0, &
                1.0d0, 0.7071067811865476d0, 1.0d0], flags=0)
            call show('out', found)
        end block
        call begin('create_multiplicities')
        block
            type(nurbs_spline) :: found
            call found%create_multiplicities(degrees=[2], counts=[9], distinct_counts=[5], distinct_knots=[0.0d0, &
                0.25d0, 0.5d0, 0.75d0, 1.0d0], multiplicities=[3, 2, 2, 2, 3], &
                points=reshape([1.0d0, 0.0d0, 1.0d0, 1.0d0, 0.0d0, 1.0d0, -1.0d0, 1.0d0, -1.0d0, 0.0d0, -1.0d0, &
                -1.0d0, 0.0d0, -1.0d0, 1.0d0, -1.0d0, 1.0d0, 0.0d0], [9, 2], order=[2, 1]), weights=[1.0d0, &
                0.7071067811865476d0, 1.0d0, 0.7071067811865476d0, 1.0d0, 0.7071067811865476d0, 1.0d0, &
                0.7071067811865476d0, 1.0d0], flags=0)
            call show('out', found)
        end block
        call begin('create_power')
        block
            type(nurbs_spline) :: out_found
            call create_power_spline(out=out_found, degrees=[1, 0], piece_counts=[1_c_int64_t, 1_c_int64_t], &
                breaks=[0.0d0, 1.0d0, 0.0d0, 1.0d0], coefficients=reshape([0.1d0, 0.9d0, 0.3d0, 0.7d0], [2, 2]), &
                flags=0)
            call show('out', out_found)
        end block
        call begin('refinement_matrix size')
        block
            real(c_double), allocatable :: values_found(:)
            integer(c_int64_t), allocatable :: columns_found(:)
            integer(c_int64_t), allocatable :: row_pointers_found(:)
            call curve%refinement_matrix(axis=1, knots=[0.3d0, 0.6d0], values=values_found, columns=columns_found, &
                row_pointers=row_pointers_found)
            call show('values', values_found)
            call show('columns', columns_found - 1)
            call show('row_pointers', row_pointers_found - 1)
        end block
        call begin('create_bezier rational')
        block
            type(nurbs_spline) :: found
            call found%create_bezier(degrees=[3], points=reshape([0.0d0, 0.0d0, 1.0d0, 2.0d0, 3.0d0, 2.0d0, 4.0d0, &
                0.0d0], [4, 2], order=[2, 1]), weights=[1.0d0, 0.7071067811865476d0, 1.0d0, 0.7071067811865476d0])
            call show('out', found)
        end block
        call begin('interpolate')
        block
            type(nurbs_spline) :: out_found
            real(c_double) :: residual_found
            call interpolate(degrees=[3], counts=[5], params=[0.0d0, 0.25d0, 0.5d0, 0.75d0, 1.0d0], &
                points=reshape([0.0d0, 0.0d0, 1.0d0, 2.0d0, 3.0d0, 2.0d0, 4.0d0, 0.0d0, 5.0d0, 5.0d0], [5, 2], &
                order=[2, 1]), out=out_found, residual=residual_found, flags=0)
            call show('out', out_found)
            call show('residual', residual_found)
        end block
        call begin('interpolate natural')
        block
            type(nurbs_spline) :: out_found
            real(c_double) :: residual_found
            call interpolate(degrees=[3], counts=[3], params=[0.0d0, 0.5d0, 1.0d0], &
                points=reshape([0.0d0, 0.0d0, 1.0d0, 2.0d0, 3.0d0, 2.0d0], [3, 2], order=[2, 1]), out=out_found, &
                ends=reshape([1, 1], [1, 2], order=[2, 1]), residual=residual_found, flags=0)
            call show('out', out_found)
            call show('residual', residual_found)
        end block
        call begin('interpolate loop')
        block
            type(nurbs_spline) :: out_found
            real(c_double) :: residual_found
            call interpolate(degrees=[2], counts=[5], params=[0.0d0, 0.25d0, 0.5d0, 0.75d0, 1.0d0], &
                points=reshape([0.0d0, 1.0d0, 0.0d0, -1.0d0, 0.0d0], [5, 1], order=[2, 1]), out=out_found, &
                residual=residual_found, flags=1)
            call show('out', out_found)
            call show('residual', residual_found)
        end block
        call begin('interpolate_over_knots')
        block
            type(nurbs_spline) :: out_found
            call interpolate_over_knots(degrees=[1, 2], counts=[2, 3], params=[0.0d0, 1.0d0, 0.0d0, 0.5d0, 1.0d0], &
                knots=[0.0d0, 0.0d0, 1.0d0, 1.0d0, 0.0d0, 0.0d0, 0.0d0, 1.0d0, 1.0d0, 1.0d0], &
                points=reshape([0.0d0, 1.0d0, 2.0d0, 3.0d0, 4.0d0, 5.0d0], [6, 1], order=[2, 1]), out=out_found, &
                flags=0)
            call show('out', out_found)
        end block
        call begin('interpolate_derivatives')
        block
            type(nurbs_spline) :: out_found
            call interpolate_derivatives(degrees=[3, 2], counts=[5, 3], params=[0.0d0, 0.0d0, 0.5d0, 1.0d0, 1.0d0, &
                0.0d0, 0.5d0, 1.0d0], orders=[0, 1, 0, 0, 1, 0, 0, 0], &
                values=reshape([0.0d0, 1.0d0, 2.0d0, 1.0d0, 1.0d0, 1.0d0, 3.0d0, 4.0d0, 5.0d0, 6.0d0, 7.0d0, 8.0d0, &
                0.0d0, 0.0d0, 0.0d0], [15, 1], order=[2, 1]), out=out_found, flags=0)
            call show('out', out_found)
        end block
        call begin('interpolate_derivatives ends')
        block
            type(nurbs_spline) :: out_found
            call interpolate_derivatives(degrees=[3, 3], counts=[4, 4], params=[0.0d0, 0.0d0, 1.0d0, 1.0d0, 0.0d0, &
                0.5d0, 0.75d0, 1.0d0], orders=[0, 1, 0, 1, 0, 0, 0, 0], &
                values=reshape([0.0d0, 1.0d0, 2.0d0, 1.0d0, 1.0d0, 1.0d0, 3.0d0, 0.5d0, 5.0d0, 6.0d0, 7.0d0, 8.0d0, &
                1.0d0, 0.0d0, 0.0d0, 1.0d0], [16, 1], order=[2, 1]), out=out_found, &
                ends=reshape([0, 0, 1, 1], [2, 2], order=[2, 1]), flags=0)
            call show('out', out_found)
        end block
        call begin('curve_interpolate')
        block
            type(nurbs_spline) :: out_found
            call curve_interpolate(degree=3, params=[0.0d0, 0.0d0, 1.0d0, 1.0d0], &
                targets=reshape([0.0d0, 0.0d0, 1.0d0, 0.0d0, 2.0d0, 1.0d0, 1.0d0, 1.0d0], [4, 2], order=[2, 1]), &
                out=out_found, orders=[0, 1, 0, 1], flags=0)
            call show('out', out_found)
        end block
        call begin('curve_interpolate directions')
        block
            type(nurbs_spline) :: out_found
            call curve_interpolate(degree=3, params=[0.0d0, 0.0d0, 1.0d0, 1.0d0], &
                targets=reshape([0.0d0, 0.0d0, 1.0d0, 0.0d0, 2.0d0, 1.0d0, 1.0d0, 1.0d0], [4, 2], order=[2, 1]), &
                out=out_found, orders=[0, (-1), 0, (-1)], flags=0)
            call show('out', out_found)
        end block
        call begin('curve_interpolate over knots')
        block
            type(nurbs_spline) :: out_found
            call curve_interpolate(degree=2, params=[0.0d0, 0.5d0, 1.0d0], &
                targets=reshape([0.0d0, 1.0d0, 0.0d0], [3, 1], order=[2, 1]), out=out_found, knots=[0.0d0, 0.0d0, &
                0.0d0, 1.0d0, 1.0d0, 1.0d0], flags=0)
            call show('out', out_found)
        end block
        call begin('tangent_lengths')
        block
            real(c_double), allocatable :: lengths_found(:)
            allocate (lengths_found(4))
            call tangent_lengths(degree=3, params=[0.0d0, 0.0d0, 1.0d0, 1.0d0], &
                targets=reshape([0.0d0, 0.0d0, 1.0d0, 0.0d0, 2.0d0, 1.0d0, 1.0d0, 1.0d0], [4, 2], order=[2, 1]), &
                orders=[0, (-1), 0, (-1)], lengths=lengths_found, flags=0)
            call show('lengths', lengths_found)
        end block
        call begin('tangent_lengths over knots')
        block
            real(c_double), allocatable :: lengths_found(:)
            allocate (lengths_found(3))
            call tangent_lengths(degree=2, params=[0.0d0, 0.0d0, 1.0d0], &
                targets=reshape([0.0d0, 0.0d0, 1.0d0, 0.0d0, 2.0d0, 1.0d0], [3, 2], order=[2, 1]), orders=[0, (-1), &
                0], lengths=lengths_found, knots=[0.0d0, 0.0d0, 0.0d0, 1.0d0, 1.0d0, 1.0d0], flags=0)
            call show('lengths', lengths_found)
        end block
        call by_hand('data_init')
        call begin('statistics_create')
        block
            type(nurbs_statistics) :: found
            call found%create(degrees=[1, 1], break_counts=[2, 3], breaks=[0.0d0, 1.0d0, 0.0d0, 1.0d0, 2.0d0], dim=2, &
                value_scale=1.0d0, weight_scale=1.0d0)
            call show('out', found)
        end block
        call begin('statistics_add')
        block
            type(nurbs_data) :: data_given
            real(c_double), target :: data_params(2, 1)
            real(c_double), target :: data_values(2, 1)
            real(c_double), target :: data_weights(2)
            type(nurbs_statistics) :: out_found
            data_params = reshape([0.25d0, 0.75d0], [2, 1], order=[2, 1])
            data_values = reshape([1.0d0, 2.0d0], [2, 1], order=[2, 1])
            data_weights = [1.0d0, 0.5d0]
            call data_for_fits(data_given, params=data_params, values=data_values, weights=data_weights)
            call statistics%add(data=data_given, out=out_found)
            call show('out', out_found)
        end block
        call begin('statistics_merge')
        block
            type(nurbs_statistics) :: parts_given(3)
            type(nurbs_statistics) :: found
            parts_given(1) = statistics
            parts_given(2) = statistics
            parts_given(3) = no_statistics
            call found%merge(parts=parts_given, signs=[1, (-1), 1])
            call show('out', found)
        end block
        call by_hand('statistics_clone')
        call by_hand('statistics_destroy')
        call begin('statistics_size')
        block
            integer(c_int32_t) :: axes_found
            integer(c_int32_t) :: dim_found
            integer(c_int64_t) :: count_found
            integer(c_int64_t) :: cells_found
            real(c_double) :: weight_found
            call statistics%get_size(axes=axes_found, dim=dim_found, count=count_found, cells=cells_found, &
                weight=weight_found)
            call show('axes', axes_found)
            call show('dim', dim_found)
            call show('count', count_found)
            call show('cells', cells_found)
            call show('weight', weight_found)
        end block
        call by_hand('statistics_to_bytes')
        call begin('statistics_from_bytes')
        block
            type(nurbs_statistics) :: found
            call found%from_bytes(contents=no_data_text)
            call show('out', found)
        end block
        call by_hand('fit_options_init')
        call begin('fit')
        block
            type(nurbs_spline) :: out_found
            type(nurbs_fit_options) :: options_given
            type(nurbs_fit_report) :: report_found
            call default_fit_options(options_given)
            options_given%smoothing = 1
            options_given%penalty_order = 1
            options_given%lambda = 0.5d0
            call statistics%fit(degrees=[2], counts=[4], knots=[0.0d0, 0.0d0, 0.0d0, 0.5d0, 1.0d0, 1.0d0, 1.0d0], &
                out=out_found, options=options_given, report=report_found, flags=0)
            call show('out', out_found)
        end block
        call begin('fit_errors')
        block
            type(nurbs_spline) :: ramp
            real(c_double), allocatable :: errors_found(:)
            call ramp%create_bezier(degrees=[2], points=reshape([0.0d0, 0.25d0, 1.0d0], [3, 1], order=[2, 1]))
            allocate (errors_found(3))
            call statistics%fit_errors(g=ramp, penalty_order=1, lambda=0.5d0, sigma=1.0d0, &
                params=reshape([0.0d0, 0.25d0, 1.0d0], [3, 1], order=[2, 1]), errors=errors_found, flags=0)
            call show('errors', errors_found)
        end block
        call begin('fit_criteria')
        block
            type(nurbs_spline) :: ramp
            real(c_double), allocatable :: values_found(:, :)
            call ramp%create_bezier(degrees=[2], points=reshape([0.0d0, 0.25d0, 1.0d0], [3, 1], order=[2, 1]))
            allocate (values_found(2, 4))
            call statistics%fit_criteria(g=ramp, penalty_order=1, lambdas=[0.5d0, 2.0d0], values=values_found)
            call show('values', flat(reshape(values_found, [size(values_found, 2), size(values_found, 1)], order=[2, &
                1])))
        end block
        call begin('fit_points')
        block
            type(nurbs_data) :: data_given
            real(c_double), target :: data_params(6, 2)
            real(c_double), target :: data_values(6, 1)
            type(nurbs_spline) :: out_found
            type(nurbs_fit_options) :: options_given
            type(nurbs_fit_report) :: report_found
            data_params = reshape([0.0d0, 0.0d0, 1.0d0, 0.0d0, 0.0d0, 1.0d0, 1.0d0, 1.0d0, 0.5d0, 0.5d0, 0.25d0, &
                0.5d0], [6, 2], order=[2, 1])
            data_values = reshape([0.0d0, 1.0d0, 2.0d0, 1.0d0, 0.0d0, 1.0d0], [6, 1], order=[2, 1])
            call data_for_fits(data_given, params=data_params, values=data_values)
            call default_fit_options(options_given)
            options_given%smoothing = 2
            options_given%penalty_order = 1
            call fit_points(data=data_given, degrees=[1, 1], counts=[2, 2], knots=[0.0d0, 0.0d0, 1.0d0, 1.0d0, 0.0d0, &
                0.0d0, 1.0d0, 1.0d0], out=out_found, options=options_given, report=report_found, flags=0)
            call show('out', out_found)
        end block
        call begin('fit_tolerance')
        block
            type(nurbs_data) :: data_given
            real(c_double), target :: data_params(5, 1)
            real(c_double), target :: data_values(5, 2)
            type(nurbs_spline) :: out_found
            type(nurbs_fit_options) :: options_given
            type(nurbs_fit_report) :: report_found
            data_params = reshape([0.0d0, 0.25d0, 0.5d0, 0.75d0, 1.0d0], [5, 1], order=[2, 1])
            data_values = reshape([0.0d0, 1.0d0, 2.0d0, 1.0d0, 0.0d0, 0.0d0, 1.0d0, 1.0d0, 2.0d0, 1.0d0], [5, 2], &
                order=[2, 1])
            call data_for_fits(data_given, params=data_params, values=data_values)
            call default_fit_options(options_given)
            options_given%smoothing = 0
            options_given%penalty_order = 2
            call fit_tolerance(data=data_given, degrees=[2], tolerance=0.01d0, out=out_found, &
                domain=reshape([0.0d0, 1.0d0], [1, 2], order=[2, 1]), max_count=0, options=options_given, &
                report=report_found, flags=0)
            call show('out', out_found)
        end block
        call begin('cloud_start')
        block
            type(nurbs_spline) :: out_found
            call cloud_start(degrees=[1], counts=[3], knots=[0.0d0, 0.0d0, 0.5d0, 1.0d0, 1.0d0], &
                points=reshape([0.0d0, 0.0d0, 1.0d0, 1.0d0, 2.0d0, 1.0d0], [3, 2], order=[2, 1]), out=out_found, &
                flags=0)
            call show('out', out_found)
        end block
        call by_hand('cloud_options_init')
        call begin('fit_cloud')
        block
            type(nurbs_spline) :: out_found
            type(nurbs_cloud_options) :: options_given
            type(nurbs_cloud_report) :: report_found
            call default_cloud_options(options_given)
            options_given%penalty_order = 2
            options_given%rounds = 3
            options_given%lambda = 0.5d0
            options_given%first_lambda = 1.0d0
            options_given%tolerance = 0.001d0
            call fit_cloud(g=twist, points=reshape([0.0d0, 0.0d0, 0.0d0, 1.0d0, 1.0d0, 0.0d0, 2.0d0, 1.0d0, 2.0d0], &
                [3, 3], order=[2, 1]), out=out_found, weights=[1.0d0, 2.0d0, 1.0d0], options=options_given, &
                report=report_found)
            call show('out', out_found)
        end block
        call begin('approximate')
        block
            type(nurbs_spline) :: out_found
            real(c_double) :: bound_found
            call approximate(g=curve, tolerance=0.3d0, out=out_found, degrees=[3], max_count=0, bound=bound_found)
            call show('out', out_found)
            call show('bound', bound_found)
        end block
        call begin('face_create')
        block
            type(nurbs_spline) :: south
            type(nurbs_spline) :: east
            type(nurbs_spline) :: north
            type(nurbs_spline) :: west
            type(nurbs_spline) :: curves_given(5)
            type(nurbs_face) :: found
            call south%create_bezier(degrees=[1], points=reshape([0.0d0, 0.0d0, 1.0d0, 0.0d0], [2, 2], order=[2, 1]))
            call east%create_bezier(degrees=[1], points=reshape([1.0d0, 0.0d0, 1.0d0, 3.0d0], [2, 2], order=[2, 1]))
            call north%create_bezier(degrees=[1], points=reshape([1.0d0, 3.0d0, 0.0d0, 3.0d0], [2, 2], order=[2, 1]))
            call west%create_bezier(degrees=[1], points=reshape([0.0d0, 3.0d0, 0.0d0, 0.0d0], [2, 2], order=[2, 1]))
            curves_given(1) = outline
            curves_given(2) = south
            curves_given(3) = east
            curves_given(4) = north
            curves_given(5) = west
            call found%create(surface=surface, sizes=[1, 4], curves=curves_given, keys=[0_c_int64_t, 7_c_int64_t, &
                (-8_c_int64_t), 0_c_int64_t, 9_c_int64_t], tolerance=0.001d0, flags=67108864)
            call show('out', found)
        end block
        call begin('face_create without crossings')
        block
            type(nurbs_spline) :: south
            type(nurbs_spline) :: east
            type(nurbs_spline) :: north
            type(nurbs_spline) :: west
            type(nurbs_spline) :: curves_given(4)
            type(nurbs_face) :: found
            call south%create_bezier(degrees=[1], points=reshape([0.0d0, 0.0d0, 1.0d0, 0.0d0], [2, 2], order=[2, 1]))
            call east%create_bezier(degrees=[1], points=reshape([1.0d0, 0.0d0, 1.0d0, 3.0d0], [2, 2], order=[2, 1]))
            call north%create_bezier(degrees=[1], points=reshape([1.0d0, 3.0d0, 0.0d0, 3.0d0], [2, 2], order=[2, 1]))
            call west%create_bezier(degrees=[1], points=reshape([0.0d0, 3.0d0, 0.0d0, 0.0d0], [2, 2], order=[2, 1]))
            curves_given(1) = south
            curves_given(2) = east
            curves_given(3) = north
            curves_given(4) = west
            call found%create(surface=surface, sizes=[4], curves=curves_given, tolerance=0.001d0, flags=33554432)
            call show('out', found)
        end block
        call begin('face_create of edges')
        block
            type(nurbs_spline) :: first_edge
            type(nurbs_spline) :: second_edge
            type(nurbs_spline) :: third_edge
            type(nurbs_spline) :: edges_given(3)
            type(nurbs_face) :: found
            call first_edge%create_bezier(degrees=[2], points=reshape([0.25d0, 1.0d0, 1.0625d0, 0.5d0, 1.0d0, &
                1.1875d0, 0.75d0, 1.0d0, 1.5625d0], [3, 3], order=[2, 1]))
            call second_edge%create_bezier(degrees=[2], points=reshape([0.75d0, 1.0d0, 1.5625d0, 0.625d0, 1.5d0, &
                1.875d0, 0.5d0, 2.0d0, 2.25d0], [3, 3], order=[2, 1]))
            call third_edge%create_bezier(degrees=[2], points=reshape([0.5d0, 2.0d0, 2.25d0, 0.375d0, 1.5d0, 1.625d0, &
                0.25d0, 1.0d0, 1.0625d0], [3, 3], order=[2, 1]))
            edges_given(1) = first_edge
            edges_given(2) = second_edge
            edges_given(3) = third_edge
            call found%create(surface=surface, sizes=[3], edges=edges_given, keys=[1_c_int64_t, 2_c_int64_t, &
                3_c_int64_t], tolerance=1d-09, flags=0)
            call show('out', found)
        end block
        call begin('face_create whole')
        block
            type(nurbs_face) :: found
            call found%create(surface=surface, sizes=[integer(c_int32_t) ::], tolerance=0.0d0, flags=0)
            call show('out', found)
        end block
        call by_hand('face_clone')
        call by_hand('face_destroy')
        call begin('face_surface')
        block
            type(nurbs_spline) :: out_found
            call face%surface(out=out_found)
            call show('out', out_found)
        end block
        call begin('face_loops')
        block
            integer(c_int64_t), allocatable :: sizes_found(:)
            call face%loops(sizes=sizes_found)
            call show('sizes', sizes_found)
        end block
        call begin('face_curve')
        block
            type(nurbs_spline) :: out_found
            call face%curve(loop=1, index=1, out=out_found)
            call show('out', out_found)
        end block
        call begin('face_edge')
        block
            type(nurbs_spline) :: out_found
            integer(c_int64_t) :: key_found
            call face%edge(loop=1, index=1, out=out_found, key=key_found)
            call show('out', out_found)
            call show('key', key_found)
        end block
        call begin('face_deviation')
        block
            real(c_double) :: distance_found
            logical :: proven_found
            call face%deviation(loop=1, index=1, distance=distance_found, proven=proven_found)
            call show('distance', distance_found)
            call show('proven', proven_found)
        end block
        call begin('face_tolerance')
        block
            call show('tolerance', face%get_tolerance())
        end block
        call begin('face_classify')
        block
            integer(c_int32_t), allocatable :: sides_found(:)
            allocate (sides_found(3))
            call face%classify(params=reshape([0.1d0, 0.9d0, 0.3d0, 0.7d0, 0.2d0, 0.6d0], [3, 2], order=[2, 1]), &
                sides=sides_found, tolerance=0.0d0)
            call show('sides', sides_found)
        end block
        call begin('face_area')
        block
            real(c_double) :: area_found
            real(c_double) :: error_found
            call face%get_area(area=area_found, error=error_found, tolerance=1d-06)
            call show('area', area_found)
            call show('error', error_found)
        end block
        call begin('face_moments')
        block
            real(c_double) :: content_found
            real(c_double), allocatable :: centroid_found(:)
            real(c_double), allocatable :: inertia_found(:, :)
            real(c_double) :: error_found
            allocate (centroid_found(3))
            allocate (inertia_found(3, 3))
            call face%moments(content=content_found, centroid=centroid_found, inertia=inertia_found, &
                error=error_found, tolerance=1d-06)
            call show('content', content_found)
            call show('centroid', centroid_found)
            call show('inertia', flat(inertia_found))
            call show('error', error_found)
        end block
        call begin('face_quadrature')
        block
            real(c_double), allocatable :: params_found(:, :)
            real(c_double), allocatable :: weights_found(:)
            real(c_double), allocatable :: measures_found(:)
            call face%quadrature(params=params_found, weights=weights_found, measures=measures_found, nodes=1)
            call show('params', flat(reshape(params_found, [size(params_found, 2), size(params_found, 1)], order=[2, &
                1])))
            call show('weights', weights_found)
            call show('measures', measures_found)
        end block
        call begin('face_box')
        block
            real(c_double), allocatable :: lower_found(:)
            real(c_double), allocatable :: upper_found(:)
            real(c_double) :: gap_found
            allocate (lower_found(3))
            allocate (upper_found(3))
            call face%box(lower=lower_found, upper=upper_found, gap=gap_found, tolerance=0.001d0)
            call show('lower', lower_found)
            call show('upper', upper_found)
            call show('gap', gap_found)
        end block
        call begin('read_model')
        block
            type(nurbs_model) :: found
            call found%read(contents=solid_text)
            call show('out', found)
        end block
        call begin('read_model in millimetres')
        block
            type(nurbs_read_options) :: options_given
            type(nurbs_model) :: found
            call default_read_options(options_given)
            options_given%unit = 0.001d0
            call found%read(contents=solid_text, options=options_given)
            call show('out', found)
        end block
        call begin('read_model_file')
        block
            type(nurbs_model) :: found
            call found%read_file(path=written('smoke_calls_fortran.solid', solid_text))
            call show('out', found)
        end block
        call begin('read_model_file in millimetres')
        block
            type(nurbs_read_options) :: options_given
            type(nurbs_model) :: found
            call default_read_options(options_given)
            options_given%unit = 0.001d0
            call found%read_file(path=written('smoke_calls_fortran.solid', solid_text), options=options_given)
            call show('out', found)
        end block
        call begin('model_create')
        block
            type(nurbs_face) :: faces_given(2)
            type(nurbs_model) :: found
            faces_given(1) = face
            faces_given(2) = face
            call found%create(faces=faces_given, metres=0.001d0)
            call show('out', found)
        end block
        call begin('model_sew')
        block
            type(nurbs_spline) :: sphere
            type(nurbs_face) :: ball_face
            type(nurbs_face) :: faces_given(2)
            type(nurbs_model) :: found
            call create_sphere(out=sphere, radius=1.0d0, form=0)
            call ball_face%create(surface=sphere, sizes=[integer(c_int32_t) ::], tolerance=1d-09, flags=0)
            faces_given(1) = face
            faces_given(2) = ball_face
            call found%sew(faces=faces_given, tolerance=1d-06, metres=0.001d0)
            call show('out', found)
        end block
        call begin('region_create')
        block
            type(nurbs_spline) :: curves_given(1)
            type(nurbs_model) :: found
            curves_given(1) = outline
            call found%region(curves=curves_given, rule=1, tolerance=0.0d0)
            call show('out', found)
        end block
        call begin('region_combine')
        block
            type(nurbs_spline) :: moved_outline
            type(nurbs_face) :: moved_face
            type(nurbs_spline) :: curves_given(1)
            type(nurbs_face) :: a_given(1)
            type(nurbs_face) :: b_given(1)
            type(nurbs_model) :: found
            call moved_outline%create(degrees=[1], counts=[4], knots=[0.0d0, 0.0d0, 1.0d0, 2.0d0, 3.0d0, 3.0d0], &
                points=reshape([0.25d0, 1.25d0, 0.75d0, 1.25d0, 0.5d0, 2.25d0, 0.25d0, 1.25d0], [4, 2], order=[2, 1]), &
                flags=0)
            curves_given(1) = moved_outline
            call moved_face%create(surface=surface, sizes=[1], curves=curves_given, tolerance=0.001d0, flags=0)
            a_given(1) = face
            b_given(1) = moved_face
            call found%combine(rule=3, a=a_given, b=b_given, tolerance=0.0d0)
            call show('out', found)
        end block
        call begin('face_split')
        block
            type(nurbs_spline) :: divider
            type(nurbs_spline) :: curves_given(1)
            type(nurbs_model) :: found
            call divider%create_bezier(degrees=[1], points=reshape([0.0d0, 1.5d0, 1.0d0, 1.75d0], [2, 2], order=[2, 1]))
            curves_given(1) = divider
            call found%split(face=face, curves=curves_given, tolerance=0.0d0)
            call show('out', found)
        end block
        call begin('face_trim')
        block
            type(nurbs_spline) :: cutter
            type(nurbs_model) :: found
            call cutter%create(degrees=[1, 1], counts=[2, 2], knots=[0.0d0, 0.0d0, 1.0d0, 1.0d0, 0.0d0, 0.0d0, 1.0d0, &
                1.0d0], points=reshape([-1.0d0, 1.625d0, -9.0d0, -1.0d0, 1.625d0, 9.0d0, 2.0d0, 1.625d0, -9.0d0, &
                2.0d0, 1.625d0, 9.0d0], [4, 3], order=[2, 1]), flags=0)
            call found%trim(face=face, surface=cutter, side=1, tolerance=1d-06)
            call show('out', found)
        end block
        call begin('model_edge_gaps')
        block
            integer(c_int64_t), allocatable :: uses_found(:)
            real(c_double), allocatable :: gaps_found(:)
            integer(c_int32_t), allocatable :: bounded_found(:)
            call model%edge_gaps(uses=uses_found, gaps=gaps_found, bounded=bounded_found)
            call show('uses', uses_found)
            call show('gaps', gaps_found)
            call show('bounded', bounded_found)
        end block
        call by_hand('model_clone')
        call by_hand('model_destroy')
        call begin('model_face')
        block
            type(nurbs_face) :: out_found
            integer(c_int64_t) :: part_found
            integer(c_int32_t) :: shape_found
            logical :: against_found
            real(c_double), allocatable :: colour_found(:)
            allocate (colour_found(3))
            call model%face(index=2, out=out_found, part=part_found, shape=shape_found, against=against_found, &
                colour=colour_found)
            call show('out', out_found)
            call show('part', part_found - 1)
            call show('shape', shape_found)
            call show('against', against_found)
            call show('colour', colour_found)
        end block
        call begin('model_edge')
        block
            type(nurbs_spline) :: out_found
            integer(c_int64_t) :: part_found
            integer(c_int64_t), allocatable :: end_vertices_found(:)
            integer(c_int32_t) :: shape_found
            allocate (end_vertices_found(2))
            call model%edge(index=2, out=out_found, part=part_found, end_vertices=end_vertices_found, shape=shape_found)
            call show('out', out_found)
            call show('part', part_found - 1)
            call show('end_vertices', end_vertices_found - 1)
            call show('shape', shape_found)
        end block
        call begin('model_splines')
        block
            type(nurbs_list) :: out_found
            call model%splines(out=out_found)
            call show('out', out_found)
        end block
        call by_hand('write_options_init')
        call by_hand('model_write')
        call by_hand('model_write in inches')
        call by_hand('model_write as IGES')
        call begin('model_write_file')
        block
            call model%write_file(path=written('smoke_calls_fortran.replaced', replaced_text), format=1)
        end block
        call begin('model_write_file in inches')
        block
            type(nurbs_write_options) :: options_given
            call default_write_options(options_given)
            options_given%unit = 0.0254d0
            call model%write_file(path=written('smoke_calls_fortran.replaced', replaced_text), format=1, &
                options=options_given)
        end block
        call by_hand('list_write')
        call by_hand('list_write as IGES')
        call begin('list_write_file')
        block
            type(nurbs_list) :: edges
            type(nurbs_write_options) :: options_given
            call spline_boundaries(g=surface, list=edges)
            call default_write_options(options_given)
            options_given%unit = 0.0254d0
            call edges%write_file(path=written('smoke_calls_fortran.replaced', replaced_text), format=1, &
                options=options_given)
        end block
        call begin('surface_sections in two planes')
        block
            type(nurbs_meet) :: found
            call found%sections(g=surface, normal=[0.0d0, 0.5d0, 2.0d0], offsets=[1.0d0, 3.0d0], tolerance=0.01d0)
            call show('out', found)
        end block
        call begin('surface_sections')
        block
            type(nurbs_meet) :: found
            call found%sections(g=surface, normal=[0.0d0, 0.0d0, 1.0d0], offsets=[1.5d0], tolerance=0.0001d0)
            call show('out', found)
        end block
        call begin('surface_contours along a direction')
        block
            type(nurbs_meet) :: found
            call found%contours(g=surface, kind=1, d=[0.2d0, 0.1d0, 1.0d0], cosines=[real(c_double) ::], &
                tolerance=0.01d0)
            call show('out', found)
        end block
        call begin('surface_contours')
        block
            type(nurbs_meet) :: found
            call found%contours(g=surface, kind=3, d=[0.0d0, 0.0d0, 2.0d0], cosines=[0.9d0], tolerance=0.01d0)
            call show('out', found)
        end block
        call begin('surface_reflections of normals')
        block
            type(nurbs_meet) :: found
            call found%reflections(g=surface, kind=1, direction=[0.0d0, 0.0d0, 1.0d0], &
                points=reshape([0.5d0, 0.25d0, 0.0d0], [1, 3], order=[2, 1]), tolerance=0.01d0)
            call show('out', found)
        end block
        call begin('surface_reflections')
        block
            type(nurbs_meet) :: found
            call found%reflections(g=surface, kind=2, eye=[0.1d0, 0.0d0, -1.0d0], direction=[1.0d0, 0.0d0, 0.0d0], &
                points=reshape([0.0d0, 0.5d0, 6.0d0, 0.0d0, 1.0d0, 6.0d0], [2, 3], order=[2, 1]), tolerance=0.01d0)
            call show('out', found)
        end block
        call begin('surface_level')
        block
            type(nurbs_meet) :: found
            call found%level(g=surface, degree=1, coefficients=[0.0d0, 0.0d0, 1.0d0, -1.5d0], tolerance=0.01d0)
            call show('out', found)
        end block
        call begin('surface_level_curves')
        block
            type(nurbs_spline) :: heights
            type(nurbs_meet) :: found
            call heights%create(degrees=[1, 1], counts=[2, 2], knots=[0.0d0, 0.0d0, 1.0d0, 1.0d0, 0.0d0, 0.0d0, 3.0d0, &
                3.0d0], points=reshape([0.0d0, 1.0d0, 1.0d0, 2.0d0], [4, 1], order=[2, 1]), flags=0)
            call found%level_curves(g=surface, scalar=heights, values=[0.5d0], tolerance=0.01d0)
            call show('out', found)
        end block
        call begin('surface_intersections')
        block
            type(nurbs_spline) :: wall
            type(nurbs_meet) :: found
            call wall%create_bezier(degrees=[1, 1], points=reshape([0.3d0, -1.0d0, -1.0d0, 0.3d0, -1.0d0, 9.0d0, &
                0.4d0, 9.0d0, -1.0d0, 0.4d0, 9.0d0, 9.0d0], [4, 3], order=[2, 1]))
            call found%surfaces(a=wall, b=surface, tolerance=0.1d0)
            call show('out', found)
        end block
        call begin('surface_self_intersections')
        block
            type(nurbs_meet) :: found
            call found%of_itself(g=surface, tolerance=0.1d0)
            call show('out', found)
        end block
        call begin('face_intersections')
        block
            type(nurbs_spline) :: wall
            type(nurbs_spline) :: upright_outline
            type(nurbs_face) :: upright
            type(nurbs_spline) :: curves_given(1)
            type(nurbs_meet) :: found
            call wall%create_bezier(degrees=[1, 1], points=reshape([0.3d0, -1.0d0, -1.0d0, 0.3d0, -1.0d0, 9.0d0, &
                0.4d0, 9.0d0, -1.0d0, 0.4d0, 9.0d0, 9.0d0], [4, 3], order=[2, 1]))
            call upright_outline%create(degrees=[1], counts=[4], knots=[0.0d0, 0.0d0, 1.0d0, 2.0d0, 3.0d0, 3.0d0], &
                points=reshape([0.0d0, 0.0d0, 1.0d0, 0.0d0, 0.0d0, 1.0d0, 0.0d0, 0.0d0], [4, 2], order=[2, 1]), flags=0)
            curves_given(1) = upright_outline
            call upright%create(surface=wall, sizes=[1], curves=curves_given, tolerance=0.001d0, flags=0)
            call found%of_faces(a=face, b=upright, tolerance=0.1d0)
            call show('out', found)
        end block
        call begin('meet_kinds')
        block
            integer(c_int32_t), allocatable :: kinds_found(:)
            call meet%branch_kinds(kinds=kinds_found)
            call show('kinds', kinds_found)
        end block
        call begin('surface_project_curve')
        block
            type(nurbs_spline) :: wall
            type(nurbs_meet) :: found
            call wall%create_bezier(degrees=[1, 1], points=reshape([0.3d0, -1.0d0, -1.0d0, 0.3d0, -1.0d0, 9.0d0, &
                0.4d0, 9.0d0, -1.0d0, 0.4d0, 9.0d0, 9.0d0], [4, 3], order=[2, 1]))
            call found%projection(g=wall, curve=twist, direction=[1.0d0, 0.2d0, 0.1d0], tolerance=0.01d0)
            call show('out', found)
        end block
        call begin('face_project_curve')
        block
            type(nurbs_meet) :: found
            call found%face_projection(face=face, curve=twist, direction=[0.0d0, 0.0d0, 1.0d0], tolerance=0.1d0)
            call show('out', found)
        end block
        call begin('model_sections')
        block
            type(nurbs_spline) :: sphere
            type(nurbs_face) :: ball_face
            type(nurbs_model) :: ball
            type(nurbs_face) :: faces_given(1)
            type(nurbs_meet) :: found
            call create_sphere(out=sphere, radius=1.0d0, form=0)
            call ball_face%create(surface=sphere, sizes=[integer(c_int32_t) ::], tolerance=1d-09, flags=0)
            faces_given(1) = ball_face
            call ball%create(faces=faces_given, metres=1.0d0)
            call found%model_sections(model=ball, normals=reshape([0.0d0, 0.0d0, 1.0d0], [1, 3], order=[2, 1]), &
                offsets=[0.1d0], tolerance=0.1d0)
            call show('out', found)
        end block
        call begin('model_intersections')
        block
            type(nurbs_spline) :: sphere
            type(nurbs_face) :: ball_face
            type(nurbs_model) :: ball
            type(nurbs_face) :: faces_given(1)
            type(nurbs_meet) :: found
            call create_sphere(out=sphere, radius=1.0d0, form=0)
            call ball_face%create(surface=sphere, sizes=[integer(c_int32_t) ::], tolerance=1d-09, flags=0)
            faces_given(1) = ball_face
            call ball%create(faces=faces_given, metres=1.0d0)
            call found%of_models(a=model, b=ball, tolerance=0.1d0)
            call show('out', found)
        end block
        call begin('meet_faces_second')
        block
            integer(c_int64_t), allocatable :: own_faces_found(:)
            integer(c_int64_t), allocatable :: own_instances_found(:)
            call meet%faces_second(own_faces=own_faces_found, own_instances=own_instances_found)
            call show('own_faces', own_faces_found - 1)
            call show('own_instances', own_instances_found - 1)
        end block
        call begin('meet_joints_second')
        block
            integer(c_int64_t), allocatable :: own_faces_found(:)
            integer(c_int64_t), allocatable :: own_instances_found(:)
            call meet%joints_second(own_faces=own_faces_found, own_instances=own_instances_found)
            call show('own_faces', own_faces_found - 1)
            call show('own_instances', own_instances_found - 1)
        end block
        call begin('meet_ways')
        block
            integer(c_int64_t), allocatable :: levels_found(:)
            integer(c_int64_t), allocatable :: firsts_found(:)
            integer(c_int64_t), allocatable :: sizes_found(:)
            integer(c_int32_t), allocatable :: closes_found(:)
            real(c_double), allocatable :: gaps_found(:)
            call meet%ways(levels=levels_found, firsts=firsts_found, sizes=sizes_found, closes=closes_found, &
                gaps=gaps_found)
            call show('levels', levels_found - 1)
            call show('firsts', firsts_found - 1)
            call show('sizes', sizes_found)
            call show('closes', closes_found)
            call show('gaps', gaps_found)
        end block
        call begin('meet_ways closed')
        block
            integer(c_int64_t), allocatable :: levels_found(:)
            integer(c_int64_t), allocatable :: firsts_found(:)
            integer(c_int64_t), allocatable :: sizes_found(:)
            integer(c_int32_t), allocatable :: closes_found(:)
            real(c_double), allocatable :: gaps_found(:)
            call meet%ways(levels=levels_found, firsts=firsts_found, sizes=sizes_found, closes=closes_found, &
                gaps=gaps_found)
            call show('levels', levels_found - 1)
            call show('firsts', firsts_found - 1)
            call show('sizes', sizes_found)
            call show('closes', closes_found)
            call show('gaps', gaps_found)
        end block
        call begin('meet_faces')
        block
            integer(c_int64_t), allocatable :: own_faces_found(:)
            integer(c_int64_t), allocatable :: own_instances_found(:)
            call meet%faces(own_faces=own_faces_found, own_instances=own_instances_found)
            call show('own_faces', own_faces_found - 1)
            call show('own_instances', own_instances_found - 1)
        end block
        call begin('meet_joints')
        block
            integer(c_int64_t), allocatable :: next_nodes_found(:)
            real(c_double), allocatable :: gaps_found(:)
            integer(c_int64_t), allocatable :: own_faces_found(:)
            integer(c_int64_t), allocatable :: own_instances_found(:)
            call meet%joints(next_nodes=next_nodes_found, gaps=gaps_found, own_faces=own_faces_found, &
                own_instances=own_instances_found)
            call show('next_nodes', next_nodes_found - 1)
            call show('gaps', gaps_found)
            call show('own_faces', own_faces_found - 1)
            call show('own_instances', own_instances_found - 1)
        end block
        call begin('meet_trim')
        block
            type(nurbs_meet) :: found
            call found%trimmed(meet=meet, face=face)
            call show('out', found)
        end block
        call begin('meet_trim_second')
        block
            type(nurbs_spline) :: wall
            type(nurbs_meet) :: crossing
            type(nurbs_meet) :: found
            call wall%create_bezier(degrees=[1, 1], points=reshape([0.3d0, -1.0d0, -1.0d0, 0.3d0, -1.0d0, 9.0d0, &
                0.4d0, 9.0d0, -1.0d0, 0.4d0, 9.0d0, 9.0d0], [4, 3], order=[2, 1]))
            call crossing%surfaces(a=surface, b=wall, tolerance=0.01d0)
            call found%trimmed_second(meet=crossing, face=face)
            call show('out', found)
        end block
        call by_hand('mesh_options_init')
        call begin('mesh_surface')
        block
            type(nurbs_mesh_options) :: options_given
            type(nurbs_mesh) :: found
            call default_mesh_options(options_given)
            options_given%chord = 1.0d0
            options_given%relative_chord = 0.0d0
            call found%of_surface(g=surface, options=options_given)
            call show('out', found)
        end block
        call begin('mesh_surface by length')
        block
            type(nurbs_mesh_options) :: options_given
            type(nurbs_mesh) :: found
            call default_mesh_options(options_given)
            options_given%chord = 10.0d0
            options_given%relative_chord = 0.0d0
            options_given%longest = 1.5d0
            call found%of_surface(g=surface, options=options_given)
            call show('out', found)
        end block
        call begin('mesh_surface by angle')
        block
            type(nurbs_mesh_options) :: options_given
            type(nurbs_mesh) :: found
            call default_mesh_options(options_given)
            options_given%chord = 10.0d0
            options_given%relative_chord = 0.0d0
            options_given%angle = 0.5d0
            call found%of_surface(g=surface, options=options_given)
            call show('out', found)
        end block
        call begin('mesh_face')
        block
            type(nurbs_mesh_options) :: options_given
            type(nurbs_mesh) :: found
            call default_mesh_options(options_given)
            options_given%chord = 1.0d0
            options_given%relative_chord = 0.0d0
            call found%of_face(face=face, options=options_given)
            call show('out', found)
        end block
        call begin('mesh_model')
        block
            type(nurbs_mesh_options) :: options_given
            type(nurbs_mesh) :: found
            call default_mesh_options(options_given)
            options_given%chord = 1.0d0
            options_given%relative_chord = 0.0d0
            call found%of_model(model=model, options=options_given)
            call show('out', found)
        end block
        call begin('mesh_surface without small angles')
        block
            type(nurbs_mesh_options) :: options_given
            type(nurbs_mesh) :: found
            call default_mesh_options(options_given)
            options_given%chord = 10.0d0
            options_given%relative_chord = 0.0d0
            options_given%minimum_angle = 0.4d0
            call found%of_surface(g=surface, options=options_given)
            call show('out', found)
        end block
        call by_hand('mesh_surface_levels')
        call by_hand('mesh_face_levels')
        call by_hand('mesh_model_levels')
        call begin('mesh_volume')
        block
            type(nurbs_mesh_options) :: options_given
            type(nurbs_mesh) :: found
            call default_mesh_options(options_given)
            options_given%chord = 0.1d0
            options_given%relative_chord = 0.0d0
            call found%of_volume(g=solid, options=options_given, limit=100)
            call show('out', found)
        end block
        call begin('mesh_points')
        block
            real(c_double), allocatable :: values_found(:, :)
            call mesh%points(values=values_found)
            call show('points', flat(reshape(values_found, [size(values_found, 2), size(values_found, 1)], order=[2, &
                1])))
        end block
        call begin('mesh_points_f32')
        block
            real(c_float), allocatable :: values_found(:, :)
            call mesh%points_f32(values=values_found)
            call show('points', flat(reshape(values_found, [size(values_found, 2), size(values_found, 1)], order=[2, &
                1])))
        end block
        call begin('mesh_vertices')
        block
            integer(c_int64_t), allocatable :: own_points_found(:)
            real(c_double), allocatable :: params_found(:, :)
            real(c_double), allocatable :: normals_found(:, :)
            call mesh%vertices(own_points=own_points_found, params=params_found, normals=normals_found)
            call show('own_points', own_points_found - 1)
            call show('params', flat(reshape(params_found, [size(params_found, 2), size(params_found, 1)], order=[2, &
                1])))
            call show('normals', flat(reshape(normals_found, [size(normals_found, 2), size(normals_found, 1)], &
                order=[2, 1])))
        end block
        call begin('mesh_vertices normals')
        block
            integer(c_int64_t), allocatable :: own_points_found(:)
            real(c_double), allocatable :: params_found(:, :)
            real(c_double), allocatable :: normals_found(:, :)
            call mesh%vertices(own_points=own_points_found, params=params_found, normals=normals_found)
            call show('own_points', own_points_found - 1)
            call show('params', flat(reshape(params_found, [size(params_found, 2), size(params_found, 1)], order=[2, &
                1])))
            call show('normals', flat(reshape(normals_found, [size(normals_found, 2), size(normals_found, 1)], &
                order=[2, 1])))
        end block
        call begin('mesh_vertices_f32')
        block
            real(c_float), allocatable :: points_found(:, :)
            real(c_float), allocatable :: params_found(:, :)
            real(c_float), allocatable :: normals_found(:, :)
            call mesh%vertices_f32(points=points_found, params=params_found, normals=normals_found)
            call show('points', flat(reshape(points_found, [size(points_found, 2), size(points_found, 1)], order=[2, &
                1])))
            call show('params', flat(reshape(params_found, [size(params_found, 2), size(params_found, 1)], order=[2, &
                1])))
            call show('normals', flat(reshape(normals_found, [size(normals_found, 2), size(normals_found, 1)], &
                order=[2, 1])))
        end block
        call begin('mesh_triangles')
        block
            integer(c_int64_t), allocatable :: corners_found(:, :)
            call mesh%triangles(corners=corners_found, flags=0)
            call show('corners', flat(reshape(corners_found, [size(corners_found, 2), size(corners_found, 1)], &
                order=[2, 1])) - 1)
        end block
        call begin('mesh_triangles welded')
        block
            integer(c_int64_t), allocatable :: corners_found(:, :)
            call mesh%triangles(corners=corners_found, flags=16777216)
            call show('corners', flat(reshape(corners_found, [size(corners_found, 2), size(corners_found, 1)], &
                order=[2, 1])) - 1)
        end block
        call begin('mesh_triangles_i32')
        block
            integer(c_int32_t), allocatable :: corners_found(:, :)
            call mesh%triangles_i32(corners=corners_found, flags=0)
            call show('corners', flat(reshape(corners_found, [size(corners_found, 2), size(corners_found, 1)], &
                order=[2, 1])) - 1)
        end block
        call begin('mesh_quads')
        block
            integer(c_int64_t), allocatable :: corners_found(:, :)
            integer(c_int64_t), allocatable :: own_triangles_found(:)
            call mesh%quads(corners=corners_found, own_triangles=own_triangles_found, flags=0)
            call show('corners', flat(reshape(corners_found, [size(corners_found, 2), size(corners_found, 1)], &
                order=[2, 1])) - 1)
            call show('own_triangles', own_triangles_found - 1)
        end block
        call begin('mesh_quads welded')
        block
            integer(c_int64_t), allocatable :: corners_found(:, :)
            integer(c_int64_t), allocatable :: own_triangles_found(:)
            call mesh%quads(corners=corners_found, own_triangles=own_triangles_found, flags=16777216)
            call show('corners', flat(reshape(corners_found, [size(corners_found, 2), size(corners_found, 1)], &
                order=[2, 1])) - 1)
            call show('own_triangles', own_triangles_found - 1)
        end block
        call begin('mesh_faces')
        block
            integer(c_int64_t), allocatable :: first_vertices_found(:)
            integer(c_int64_t), allocatable :: vertex_counts_found(:)
            integer(c_int64_t), allocatable :: first_triangles_found(:)
            integer(c_int64_t), allocatable :: triangle_counts_found(:)
            real(c_double), allocatable :: from_shape_found(:)
            real(c_double), allocatable :: from_mesh_found(:)
            integer(c_int32_t), allocatable :: reaches_found(:)
            call mesh%faces(first_vertices=first_vertices_found, vertex_counts=vertex_counts_found, &
                first_triangles=first_triangles_found, triangle_counts=triangle_counts_found, &
                from_shape=from_shape_found, from_mesh=from_mesh_found, reaches=reaches_found)
            call show('first_vertices', first_vertices_found - 1)
            call show('vertex_counts', vertex_counts_found)
            call show('first_triangles', first_triangles_found - 1)
            call show('triangle_counts', triangle_counts_found)
            call show('from_shape', from_shape_found)
            call show('from_mesh', from_mesh_found)
            call show('reaches', reaches_found)
        end block
        call begin('mesh_edges')
        block
            integer(c_int64_t), allocatable :: own_edges_found(:)
            integer(c_int64_t), allocatable :: firsts_found(:)
            integer(c_int64_t), allocatable :: sizes_found(:)
            real(c_double), allocatable :: bounds_found(:)
            integer(c_int32_t), allocatable :: reaches_found(:)
            call mesh%edges(own_edges=own_edges_found, firsts=firsts_found, sizes=sizes_found, bounds=bounds_found, &
                reaches=reaches_found)
            call show('own_edges', own_edges_found - 1)
            call show('firsts', firsts_found - 1)
            call show('sizes', sizes_found)
            call show('bounds', bounds_found)
            call show('reaches', reaches_found)
        end block
        call begin('mesh_edge_points')
        block
            integer(c_int64_t), allocatable :: own_points_found(:)
            call mesh%edge_points(own_points=own_points_found)
            call show('own_points', own_points_found - 1)
        end block
        call by_hand('mesh_write')
        call by_hand('mesh_write as text')
        call by_hand('mesh_write as OBJ')
        call by_hand('mesh_write as PLY')
        call by_hand('mesh_write as GLB')
        call by_hand('mesh_write as VTU')
        call begin('mesh_write_file')
        block
            call mesh%write_file(path=written('smoke_calls_fortran.replaced', replaced_text), format=8)
        end block
        call begin('mesh_write_file in inches')
        block
            type(nurbs_write_options) :: options_given
            call default_write_options(options_given)
            options_given%unit = 0.0254d0
            call mesh%write_file(path=written('smoke_calls_fortran.replaced', replaced_text), format=3, &
                options=options_given)
        end block
        call begin('mesh_hexahedra')
        block
            integer(c_int64_t), allocatable :: corners_found(:, :)
            real(c_double), allocatable :: domains_found(:, :, :)
            integer(c_int32_t), allocatable :: folds_found(:)
            integer(c_int32_t), allocatable :: signs_found(:)
            call block%hexahedra(corners=corners_found, domains=domains_found, folds=folds_found, signs=signs_found)
            call show('corners', flat(reshape(corners_found, [size(corners_found, 2), size(corners_found, 1)], &
                order=[2, 1])) - 1)
            call show('domains', flat(domains_found))
            call show('folds', folds_found)
            call show('signs', signs_found)
        end block
        call by_hand('mesh_clone')
        call by_hand('meet_clone')
        call by_hand('meet_destroy')
        call by_hand('mesh_destroy')
        call begin('meet_branches')
        block
            integer(c_int64_t), allocatable :: levels_found(:)
            integer(c_int64_t), allocatable :: end_nodes_found(:, :)
            integer(c_int64_t), allocatable :: loops_found(:)
            real(c_double), allocatable :: deviations_found(:)
            call meet%branches(levels=levels_found, end_nodes=end_nodes_found, loops=loops_found, &
                deviations=deviations_found)
            call show('levels', levels_found - 1)
            call show('end_nodes', flat(reshape(end_nodes_found, [size(end_nodes_found, 2), size(end_nodes_found, 1)], &
                order=[2, 1])) - 1)
            call show('loops', loops_found)
            call show('deviations', deviations_found)
        end block
        call begin('meet_branches levels')
        block
            integer(c_int64_t), allocatable :: levels_found(:)
            integer(c_int64_t), allocatable :: end_nodes_found(:, :)
            integer(c_int64_t), allocatable :: loops_found(:)
            real(c_double), allocatable :: deviations_found(:)
            call meet%branches(levels=levels_found, end_nodes=end_nodes_found, loops=loops_found, &
                deviations=deviations_found)
            call show('levels', levels_found - 1)
            call show('end_nodes', flat(reshape(end_nodes_found, [size(end_nodes_found, 2), size(end_nodes_found, 1)], &
                order=[2, 1])) - 1)
            call show('loops', loops_found)
            call show('deviations', deviations_found)
        end block
        call begin('meet_branch')
        block
            type(nurbs_spline) :: space_found
            type(nurbs_spline) :: on_surface_found
            call meet%branch(index=2, space=space_found, on_surface=on_surface_found)
            call show('space', space_found)
            call show('on_surface', on_surface_found)
        end block
        call begin('meet_branch_second')
        block
            type(nurbs_spline) :: wall
            type(nurbs_meet) :: crossing
            type(nurbs_spline) :: on_second_found
            call wall%create_bezier(degrees=[1, 1], points=reshape([0.3d0, -1.0d0, -1.0d0, 0.3d0, -1.0d0, 9.0d0, &
                0.4d0, 9.0d0, -1.0d0, 0.4d0, 9.0d0, 9.0d0], [4, 3], order=[2, 1]))
            call crossing%surfaces(a=surface, b=wall, tolerance=0.01d0)
            call crossing%branch_second(index=1, on_second=on_second_found)
            call show('on_second', on_second_found)
        end block
        call begin('meet_nodes')
        block
            integer(c_int64_t), allocatable :: levels_found(:)
            integer(c_int32_t), allocatable :: kinds_found(:)
            real(c_double), allocatable :: params_found(:, :)
            real(c_double), allocatable :: ranges_found(:, :)
            call meet%nodes(levels=levels_found, kinds=kinds_found, params=params_found, ranges=ranges_found)
            call show('levels', levels_found - 1)
            call show('kinds', kinds_found)
            call show('params', flat(reshape(params_found, [size(params_found, 2), size(params_found, 1)], order=[2, &
                1])))
            call show('ranges', flat(reshape(ranges_found, [size(ranges_found, 2), size(ranges_found, 1)], order=[2, &
                1])))
        end block
        call begin('meet_nodes_second')
        block
            type(nurbs_spline) :: wall
            type(nurbs_meet) :: crossing
            real(c_double), allocatable :: params_found(:, :)
            real(c_double), allocatable :: ranges_found(:, :)
            call wall%create_bezier(degrees=[1, 1], points=reshape([0.3d0, -1.0d0, -1.0d0, 0.3d0, -1.0d0, 9.0d0, &
                0.4d0, 9.0d0, -1.0d0, 0.4d0, 9.0d0, 9.0d0], [4, 3], order=[2, 1]))
            call crossing%surfaces(a=surface, b=wall, tolerance=0.01d0)
            call crossing%nodes_second(params=params_found, ranges=ranges_found)
            call show('params', flat(reshape(params_found, [size(params_found, 2), size(params_found, 1)], order=[2, &
                1])))
            call show('ranges', flat(reshape(ranges_found, [size(ranges_found, 2), size(ranges_found, 1)], order=[2, &
                1])))
        end block
        call begin('read_with')
        block
            type(nurbs_call) :: watching
            type(nurbs_list) :: found
            call found%read(contents=file_text, call=watching)
            call show('out', found)
        end block
        call begin('read_with in millimetres')
        block
            type(nurbs_read_options) :: options_given
            type(nurbs_call) :: watching
            type(nurbs_list) :: found
            call default_read_options(options_given)
            options_given%unit = 0.001d0
            call found%read(contents=file_text, options=options_given, call=watching)
            call show('out', found)
        end block
        call begin('read_file_with')
        block
            type(nurbs_call) :: watching
            type(nurbs_list) :: found
            call found%read_file(path=written('smoke_calls_fortran.file', file_text), call=watching)
            call show('out', found)
        end block
        call begin('read_file_with in millimetres')
        block
            type(nurbs_read_options) :: options_given
            type(nurbs_call) :: watching
            type(nurbs_list) :: found
            call default_read_options(options_given)
            options_given%unit = 0.001d0
            call found%read_file(path=written('smoke_calls_fortran.file', file_text), options=options_given, &
                call=watching)
            call show('out', found)
        end block
        call begin('statistics_add_with')
        block
            type(nurbs_data) :: data_given
            real(c_double), target :: data_params(2, 1)
            real(c_double), target :: data_values(2, 1)
            real(c_double), target :: data_weights(2)
            type(nurbs_statistics) :: out_found
            type(nurbs_call) :: watching
            data_params = reshape([0.25d0, 0.75d0], [2, 1], order=[2, 1])
            data_values = reshape([1.0d0, 2.0d0], [2, 1], order=[2, 1])
            data_weights = [1.0d0, 0.5d0]
            call data_for_fits(data_given, params=data_params, values=data_values, weights=data_weights)
            call statistics%add(data=data_given, out=out_found, call=watching)
            call show('out', out_found)
        end block
        call begin('fit_with')
        block
            type(nurbs_spline) :: out_found
            type(nurbs_fit_options) :: options_given
            type(nurbs_fit_report) :: report_found
            type(nurbs_call) :: watching
            call default_fit_options(options_given)
            options_given%smoothing = 1
            options_given%penalty_order = 1
            options_given%lambda = 0.5d0
            call statistics%fit(degrees=[2], counts=[4], knots=[0.0d0, 0.0d0, 0.0d0, 0.5d0, 1.0d0, 1.0d0, 1.0d0], &
                out=out_found, options=options_given, report=report_found, flags=0, call=watching)
            call show('out', out_found)
        end block
        call begin('fit_errors_with')
        block
            type(nurbs_spline) :: ramp
            real(c_double), allocatable :: errors_found(:)
            type(nurbs_call) :: watching
            call ramp%create_bezier(degrees=[2], points=reshape([0.0d0, 0.25d0, 1.0d0], [3, 1], order=[2, 1]))
            allocate (errors_found(3))
            call statistics%fit_errors(g=ramp, penalty_order=1, lambda=0.5d0, sigma=1.0d0, &
                params=reshape([0.0d0, 0.25d0, 1.0d0], [3, 1], order=[2, 1]), errors=errors_found, flags=0, &
                call=watching)
            call show('errors', errors_found)
        end block
        call begin('fit_criteria_with')
        block
            type(nurbs_spline) :: ramp
            real(c_double), allocatable :: values_found(:, :)
            type(nurbs_call) :: watching
            call ramp%create_bezier(degrees=[2], points=reshape([0.0d0, 0.25d0, 1.0d0], [3, 1], order=[2, 1]))
            allocate (values_found(2, 4))
            call statistics%fit_criteria(g=ramp, penalty_order=1, lambdas=[0.5d0, 2.0d0], values=values_found, &
                call=watching)
            call show('values', flat(reshape(values_found, [size(values_found, 2), size(values_found, 1)], order=[2, &
                1])))
        end block
        call begin('fit_points_with')
        block
            type(nurbs_data) :: data_given
            real(c_double), target :: data_params(6, 2)
            real(c_double), target :: data_values(6, 1)
            type(nurbs_spline) :: out_found
            type(nurbs_fit_options) :: options_given
            type(nurbs_fit_report) :: report_found
            type(nurbs_call) :: watching
            data_params = reshape([0.0d0, 0.0d0, 1.0d0, 0.0d0, 0.0d0, 1.0d0, 1.0d0, 1.0d0, 0.5d0, 0.5d0, 0.25d0, &
                0.5d0], [6, 2], order=[2, 1])
            data_values = reshape([0.0d0, 1.0d0, 2.0d0, 1.0d0, 0.0d0, 1.0d0], [6, 1], order=[2, 1])
            call data_for_fits(data_given, params=data_params, values=data_values)
            call default_fit_options(options_given)
            options_given%smoothing = 2
            options_given%penalty_order = 1
            call fit_points(data=data_given, degrees=[1, 1], counts=[2, 2], knots=[0.0d0, 0.0d0, 1.0d0, 1.0d0, 0.0d0, &
                0.0d0, 1.0d0, 1.0d0], out=out_found, options=options_given, report=report_found, flags=0, call=watching)
            call show('out', out_found)
        end block
        call begin('fit_tolerance_with')
        block
            type(nurbs_data) :: data_given
            real(c_double), target :: data_params(5, 1)
            real(c_double), target :: data_values(5, 2)
            type(nurbs_spline) :: out_found
            type(nurbs_fit_options) :: options_given
            type(nurbs_fit_report) :: report_found
            type(nurbs_call) :: watching
            data_params = reshape([0.0d0, 0.25d0, 0.5d0, 0.75d0, 1.0d0], [5, 1], order=[2, 1])
            data_values = reshape([0.0d0, 1.0d0, 2.0d0, 1.0d0, 0.0d0, 0.0d0, 1.0d0, 1.0d0, 2.0d0, 1.0d0], [5, 2], &
                order=[2, 1])
            call data_for_fits(data_given, params=data_params, values=data_values)
            call default_fit_options(options_given)
            options_given%smoothing = 0
            options_given%penalty_order = 2
            call fit_tolerance(data=data_given, degrees=[2], tolerance=0.01d0, out=out_found, &
                domain=reshape([0.0d0, 1.0d0], [1, 2], order=[2, 1]), max_count=0, options=options_given, &
                report=report_found, flags=0, call=watching)
            call show('out', out_found)
        end block
        call begin('fit_cloud_with')
        block
            type(nurbs_spline) :: out_found
            type(nurbs_cloud_options) :: options_given
            type(nurbs_cloud_report) :: report_found
            type(nurbs_call) :: watching
            call default_cloud_options(options_given)
            options_given%penalty_order = 2
            options_given%rounds = 3
            options_given%lambda = 0.5d0
            options_given%first_lambda = 1.0d0
            options_given%tolerance = 0.001d0
            call fit_cloud(g=twist, points=reshape([0.0d0, 0.0d0, 0.0d0, 1.0d0, 1.0d0, 0.0d0, 2.0d0, 1.0d0, 2.0d0], &
                [3, 3], order=[2, 1]), out=out_found, weights=[1.0d0, 2.0d0, 1.0d0], options=options_given, &
                report=report_found, call=watching)
            call show('out', out_found)
        end block
        call begin('approximate_with')
        block
            type(nurbs_spline) :: out_found
            real(c_double) :: bound_found
            type(nurbs_call) :: watching
            call approximate(g=curve, tolerance=0.3d0, out=out_found, degrees=[3], max_count=0, bound=bound_found, &
                call=watching)
            call show('out', out_found)
            call show('bound', bound_found)
        end block
        call begin('face_create_with')
        block
            type(nurbs_spline) :: south
            type(nurbs_spline) :: east
            type(nurbs_spline) :: north
            type(nurbs_spline) :: west
            type(nurbs_spline) :: curves_given(5)
            type(nurbs_call) :: watching
            type(nurbs_face) :: found
            call south%create_bezier(degrees=[1], points=reshape([0.0d0, 0.0d0, 1.0d0, 0.0d0], [2, 2], order=[2, 1]))
            call east%create_bezier(degrees=[1], points=reshape([1.0d0, 0.0d0, 1.0d0, 3.0d0], [2, 2], order=[2, 1]))
            call north%create_bezier(degrees=[1], points=reshape([1.0d0, 3.0d0, 0.0d0, 3.0d0], [2, 2], order=[2, 1]))
            call west%create_bezier(degrees=[1], points=reshape([0.0d0, 3.0d0, 0.0d0, 0.0d0], [2, 2], order=[2, 1]))
            curves_given(1) = outline
            curves_given(2) = south
            curves_given(3) = east
            curves_given(4) = north
            curves_given(5) = west
            call found%create(surface=surface, sizes=[1, 4], curves=curves_given, keys=[0_c_int64_t, 7_c_int64_t, &
                (-8_c_int64_t), 0_c_int64_t, 9_c_int64_t], tolerance=0.001d0, flags=67108864, call=watching)
            call show('out', found)
        end block
        call begin('face_create_with without crossings')
        block
            type(nurbs_spline) :: south
            type(nurbs_spline) :: east
            type(nurbs_spline) :: north
            type(nurbs_spline) :: west
            type(nurbs_spline) :: curves_given(4)
            type(nurbs_call) :: watching
            type(nurbs_face) :: found
            call south%create_bezier(degrees=[1], points=reshape([0.0d0, 0.0d0, 1.0d0, 0.0d0], [2, 2], order=[2, 1]))
            call east%create_bezier(degrees=[1], points=reshape([1.0d0, 0.0d0, 1.0d0, 3.0d0], [2, 2], order=[2, 1]))
            call north%create_bezier(degrees=[1], points=reshape([1.0d0, 3.0d0, 0.0d0, 3.0d0], [2, 2], order=[2, 1]))
            call west%create_bezier(degrees=[1], points=reshape([0.0d0, 3.0d0, 0.0d0, 0.0d0], [2, 2], order=[2, 1]))
            curves_given(1) = south
            curves_given(2) = east
            curves_given(3) = north
            curves_given(4) = west
            call found%create(surface=surface, sizes=[4], curves=curves_given, tolerance=0.001d0, flags=33554432, &
                call=watching)
            call show('out', found)
        end block
        call begin('face_create_with of edges')
        block
            type(nurbs_spline) :: first_edge
            type(nurbs_spline) :: second_edge
            type(nurbs_spline) :: third_edge
            type(nurbs_spline) :: edges_given(3)
            type(nurbs_call) :: watching
            type(nurbs_face) :: found
            call first_edge%create_bezier(degrees=[2], points=reshape([0.25d0, 1.0d0, 1.0625d0, 0.5d0, 1.0d0, &
                1.1875d0, 0.75d0, 1.0d0, 1.5625d0], [3, 3], order=[2, 1]))
            call second_edge%create_bezier(degrees=[2], points=reshape([0.75d0, 1.0d0, 1.5625d0, 0.625d0, 1.5d0, &
                1.875d0, 0.5d0, 2.0d0, 2.25d0], [3, 3], order=[2, 1]))
            call third_edge%create_bezier(degrees=[2], points=reshape([0.5d0, 2.0d0, 2.25d0, 0.375d0, 1.5d0, 1.625d0, &
                0.25d0, 1.0d0, 1.0625d0], [3, 3], order=[2, 1]))
            edges_given(1) = first_edge
            edges_given(2) = second_edge
            edges_given(3) = third_edge
            call found%create(surface=surface, sizes=[3], edges=edges_given, keys=[1_c_int64_t, 2_c_int64_t, &
                3_c_int64_t], tolerance=1d-09, flags=0, call=watching)
            call show('out', found)
        end block
        call begin('face_create_with whole')
        block
            type(nurbs_call) :: watching
            type(nurbs_face) :: found
            call found%create(surface=surface, sizes=[integer(c_int32_t) ::], tolerance=0.0d0, flags=0, call=watching)
            call show('out', found)
        end block
        call begin('face_classify_with')
        block
            integer(c_int32_t), allocatable :: sides_found(:)
            type(nurbs_call) :: watching
            allocate (sides_found(3))
            call face%classify(params=reshape([0.1d0, 0.9d0, 0.3d0, 0.7d0, 0.2d0, 0.6d0], [3, 2], order=[2, 1]), &
                sides=sides_found, tolerance=0.0d0, call=watching)
            call show('sides', sides_found)
        end block
        call begin('face_area_with')
        block
            real(c_double) :: area_found
            real(c_double) :: error_found
            type(nurbs_call) :: watching
            call face%get_area(area=area_found, error=error_found, tolerance=1d-06, call=watching)
            call show('area', area_found)
            call show('error', error_found)
        end block
        call begin('face_moments_with')
        block
            real(c_double) :: content_found
            real(c_double), allocatable :: centroid_found(:)
            real(c_double), allocatable :: inertia_found(:, :)
            real(c_double) :: error_found
            type(nurbs_call) :: watching
            allocate (centroid_found(3))
            allocate (inertia_found(3, 3))
            call face%moments(content=content_found, centroid=centroid_found, inertia=inertia_found, &
                error=error_found, tolerance=1d-06, call=watching)
            call show('content', content_found)
            call show('centroid', centroid_found)
            call show('inertia', flat(inertia_found))
            call show('error', error_found)
        end block
        call begin('face_quadrature_with')
        block
            real(c_double), allocatable :: params_found(:, :)
            real(c_double), allocatable :: weights_found(:)
            real(c_double), allocatable :: measures_found(:)
            type(nurbs_call) :: watching
            call face%quadrature(params=params_found, weights=weights_found, measures=measures_found, nodes=1, &
                call=watching)
            call show('params', flat(reshape(params_found, [size(params_found, 2), size(params_found, 1)], order=[2, &
                1])))
            call show('weights', weights_found)
            call show('measures', measures_found)
        end block
        call begin('face_box_with')
        block
            real(c_double), allocatable :: lower_found(:)
            real(c_double), allocatable :: upper_found(:)
            real(c_double) :: gap_found
            type(nurbs_call) :: watching
            allocate (lower_found(3))
            allocate (upper_found(3))
            call face%box(lower=lower_found, upper=upper_found, gap=gap_found, tolerance=0.001d0, call=watching)
            call show('lower', lower_found)
            call show('upper', upper_found)
            call show('gap', gap_found)
        end block
        call begin('read_model_with')
        block
            type(nurbs_call) :: watching
            type(nurbs_model) :: found
            call found%read(contents=solid_text, call=watching)
            call show('out', found)
        end block
        call begin('read_model_with in millimetres')
        block
            type(nurbs_read_options) :: options_given
            type(nurbs_call) :: watching
            type(nurbs_model) :: found
            call default_read_options(options_given)
            options_given%unit = 0.001d0
            call found%read(contents=solid_text, options=options_given, call=watching)
            call show('out', found)
        end block
        call begin('read_model_file_with')
        block
            type(nurbs_call) :: watching
            type(nurbs_model) :: found
            call found%read_file(path=written('smoke_calls_fortran.solid', solid_text), call=watching)
            call show('out', found)
        end block
        call begin('read_model_file_with in millimetres')
        block
            type(nurbs_read_options) :: options_given
            type(nurbs_call) :: watching
            type(nurbs_model) :: found
            call default_read_options(options_given)
            options_given%unit = 0.001d0
            call found%read_file(path=written('smoke_calls_fortran.solid', solid_text), options=options_given, &
                call=watching)
            call show('out', found)
        end block
        call begin('model_sew_with')
        block
            type(nurbs_spline) :: sphere
            type(nurbs_face) :: ball_face
            type(nurbs_face) :: faces_given(2)
            type(nurbs_call) :: watching
            type(nurbs_model) :: found
            call create_sphere(out=sphere, radius=1.0d0, form=0)
            call ball_face%create(surface=sphere, sizes=[integer(c_int32_t) ::], tolerance=1d-09, flags=0)
            faces_given(1) = face
            faces_given(2) = ball_face
            call found%sew(faces=faces_given, tolerance=1d-06, metres=0.001d0, call=watching)
            call show('out', found)
        end block
        call begin('region_create_with')
        block
            type(nurbs_spline) :: curves_given(1)
            type(nurbs_call) :: watching
            type(nurbs_model) :: found
            curves_given(1) = outline
            call found%region(curves=curves_given, rule=1, tolerance=0.0d0, call=watching)
            call show('out', found)
        end block
        call begin('region_combine_with')
        block
            type(nurbs_spline) :: moved_outline
            type(nurbs_face) :: moved_face
            type(nurbs_spline) :: curves_given(1)
            type(nurbs_face) :: a_given(1)
            type(nurbs_face) :: b_given(1)
            type(nurbs_call) :: watching
            type(nurbs_model) :: found
            call moved_outline%create(degrees=[1], counts=[4], knots=[0.0d0, 0.0d0, 1.0d0, 2.0d0, 3.0d0, 3.0d0], &
                points=reshape([0.25d0, 1.25d0, 0.75d0, 1.25d0, 0.5d0, 2.25d0, 0.25d0, 1.25d0], [4, 2], order=[2, 1]), &
                flags=0)
            curves_given(1) = moved_outline
            call moved_face%create(surface=surface, sizes=[1], curves=curves_given, tolerance=0.001d0, flags=0)
            a_given(1) = face
            b_given(1) = moved_face
            call found%combine(rule=3, a=a_given, b=b_given, tolerance=0.0d0, call=watching)
            call show('out', found)
        end block
        call begin('face_split_with')
        block
            type(nurbs_spline) :: divider
            type(nurbs_spline) :: curves_given(1)
            type(nurbs_call) :: watching
            type(nurbs_model) :: found
            call divider%create_bezier(degrees=[1], points=reshape([0.0d0, 1.5d0, 1.0d0, 1.75d0], [2, 2], order=[2, 1]))
            curves_given(1) = divider
            call found%split(face=face, curves=curves_given, tolerance=0.0d0, call=watching)
            call show('out', found)
        end block
        call begin('face_trim_with')
        block
            type(nurbs_spline) :: cutter
            type(nurbs_call) :: watching
            type(nurbs_model) :: found
            call cutter%create(degrees=[1, 1], counts=[2, 2], knots=[0.0d0, 0.0d0, 1.0d0, 1.0d0, 0.0d0, 0.0d0, 1.0d0, &
                1.0d0], points=reshape([-1.0d0, 1.625d0, -9.0d0, -1.0d0, 1.625d0, 9.0d0, 2.0d0, 1.625d0, -9.0d0, &
                2.0d0, 1.625d0, 9.0d0], [4, 3], order=[2, 1]), flags=0)
            call found%trim(face=face, surface=cutter, side=1, tolerance=1d-06, call=watching)
            call show('out', found)
        end block
        call by_hand('model_write_with')
        call by_hand('model_write_with in inches')
        call by_hand('model_write_with as IGES')
        call begin('model_write_file_with')
        block
            type(nurbs_call) :: watching
            call model%write_file(path=written('smoke_calls_fortran.replaced', replaced_text), format=1, call=watching)
        end block
        call begin('model_write_file_with in inches')
        block
            type(nurbs_write_options) :: options_given
            type(nurbs_call) :: watching
            call default_write_options(options_given)
            options_given%unit = 0.0254d0
            call model%write_file(path=written('smoke_calls_fortran.replaced', replaced_text), format=1, &
                options=options_given, call=watching)
        end block
        call by_hand('list_write_with')
        call by_hand('list_write_with as IGES')
        call begin('list_write_file_with')
        block
            type(nurbs_list) :: edges
            type(nurbs_write_options) :: options_given
            type(nurbs_call) :: watching
            call spline_boundaries(g=surface, list=edges)
            call default_write_options(options_given)
            options_given%unit = 0.0254d0
            call edges%write_file(path=written('smoke_calls_fortran.replaced', replaced_text), format=1, &
                options=options_given, call=watching)
        end block
        call begin('surface_sections_with in two planes')
        block
            type(nurbs_call) :: watching
            type(nurbs_meet) :: found
            call found%sections(g=surface, normal=[0.0d0, 0.5d0, 2.0d0], offsets=[1.0d0, 3.0d0], tolerance=0.01d0, &
                call=watching)
            call show('out', found)
        end block
        call begin('surface_sections_with')
        block
            type(nurbs_call) :: watching
            type(nurbs_meet) :: found
            call found%sections(g=surface, normal=[0.0d0, 0.0d0, 1.0d0], offsets=[1.5d0], tolerance=0.0001d0, &
                call=watching)
            call show('out', found)
        end block
        call begin('surface_contours_with along a direction')
        block
            type(nurbs_call) :: watching
            type(nurbs_meet) :: found
            call found%contours(g=surface, kind=1, d=[0.2d0, 0.1d0, 1.0d0], cosines=[real(c_double) ::], &
                tolerance=0.01d0, call=watching)
            call show('out', found)
        end block
        call begin('surface_contours_with')
        block
            type(nurbs_call) :: watching
            type(nurbs_meet) :: found
            call found%contours(g=surface, kind=3, d=[0.0d0, 0.0d0, 2.0d0], cosines=[0.9d0], tolerance=0.01d0, &
                call=watching)
            call show('out', found)
        end block
        call begin('surface_reflections_with of normals')
        block
            type(nurbs_call) :: watching
            type(nurbs_meet) :: found
            call found%reflections(g=surface, kind=1, direction=[0.0d0, 0.0d0, 1.0d0], &
                points=reshape([0.5d0, 0.25d0, 0.0d0], [1, 3], order=[2, 1]), tolerance=0.01d0, call=watching)
            call show('out', found)
        end block
        call begin('surface_reflections_with')
        block
            type(nurbs_call) :: watching
            type(nurbs_meet) :: found
            call found%reflections(g=surface, kind=2, eye=[0.1d0, 0.0d0, -1.0d0], direction=[1.0d0, 0.0d0, 0.0d0], &
                points=reshape([0.0d0, 0.5d0, 6.0d0, 0.0d0, 1.0d0, 6.0d0], [2, 3], order=[2, 1]), tolerance=0.01d0, &
                call=watching)
            call show('out', found)
        end block
        call begin('surface_level_with')
        block
            type(nurbs_call) :: watching
            type(nurbs_meet) :: found
            call found%level(g=surface, degree=1, coefficients=[0.0d0, 0.0d0, 1.0d0, -1.5d0], tolerance=0.01d0, &
                call=watching)
            call show('out', found)
        end block
        call begin('surface_level_curves_with')
        block
            type(nurbs_spline) :: heights
            type(nurbs_call) :: watching
            type(nurbs_meet) :: found
            call heights%create(degrees=[1, 1], counts=[2, 2], knots=[0.0d0, 0.0d0, 1.0d0, 1.0d0, 0.0d0, 0.0d0, 3.0d0, &
                3.0d0], points=reshape([0.0d0, 1.0d0, 1.0d0, 2.0d0], [4, 1], order=[2, 1]), flags=0)
            call found%level_curves(g=surface, scalar=heights, values=[0.5d0], tolerance=0.01d0, call=watching)
            call show('out', found)
        end block
        call begin('surface_intersections_with')
        block
            type(nurbs_spline) :: wall
            type(nurbs_call) :: watching
            type(nurbs_meet) :: found
            call wall%create_bezier(degrees=[1, 1], points=reshape([0.3d0, -1.0d0, -1.0d0, 0.3d0, -1.0d0, 9.0d0, &
                0.4d0, 9.0d0, -1.0d0, 0.4d0, 9.0d0, 9.0d0], [4, 3], order=[2, 1]))
            call found%surfaces(a=wall, b=surface, tolerance=0.1d0, call=watching)
            call show('out', found)
        end block
        call begin('surface_self_intersections_with')
        block
            type(nurbs_call) :: watching
            type(nurbs_meet) :: found
            call found%of_itself(g=surface, tolerance=0.1d0, call=watching)
            call show('out', found)
        end block
        call begin('face_intersections_with')
        block
            type(nurbs_spline) :: wall
            type(nurbs_spline) :: upright_outline
            type(nurbs_face) :: upright
            type(nurbs_spline) :: curves_given(1)
            type(nurbs_call) :: watching
            type(nurbs_meet) :: found
            call wall%create_bezier(degrees=[1, 1], points=reshape([0.3d0, -1.0d0, -1.0d0, 0.3d0, -1.0d0, 9.0d0, &
                0.4d0, 9.0d0, -1.0d0, 0.4d0, 9.0d0, 9.0d0], [4, 3], order=[2, 1]))
            call upright_outline%create(degrees=[1], counts=[4], knots=[0.0d0, 0.0d0, 1.0d0, 2.0d0, 3.0d0, 3.0d0], &
                points=reshape([0.0d0, 0.0d0, 1.0d0, 0.0d0, 0.0d0, 1.0d0, 0.0d0, 0.0d0], [4, 2], order=[2, 1]), flags=0)
            curves_given(1) = upright_outline
            call upright%create(surface=wall, sizes=[1], curves=curves_given, tolerance=0.001d0, flags=0)
            call found%of_faces(a=face, b=upright, tolerance=0.1d0, call=watching)
            call show('out', found)
        end block
        call begin('surface_project_curve_with')
        block
            type(nurbs_spline) :: wall
            type(nurbs_call) :: watching
            type(nurbs_meet) :: found
            call wall%create_bezier(degrees=[1, 1], points=reshape([0.3d0, -1.0d0, -1.0d0, 0.3d0, -1.0d0, 9.0d0, &
                0.4d0, 9.0d0, -1.0d0, 0.4d0, 9.0d0, 9.0d0], [4, 3], order=[2, 1]))
            call found%projection(g=wall, curve=twist, direction=[1.0d0, 0.2d0, 0.1d0], tolerance=0.01d0, call=watching)
            call show('out', found)
        end block
        call begin('face_project_curve_with')
        block
            type(nurbs_call) :: watching
            type(nurbs_meet) :: found
            call found%face_projection(face=face, curve=twist, direction=[0.0d0, 0.0d0, 1.0d0], tolerance=0.1d0, &
                call=watching)
            call show('out', found)
        end block
        call begin('model_sections_with')
        block
            type(nurbs_spline) :: sphere
            type(nurbs_face) :: ball_face
            type(nurbs_model) :: ball
            type(nurbs_face) :: faces_given(1)
            type(nurbs_call) :: watching
            type(nurbs_meet) :: found
            call create_sphere(out=sphere, radius=1.0d0, form=0)
            call ball_face%create(surface=sphere, sizes=[integer(c_int32_t) ::], tolerance=1d-09, flags=0)
            faces_given(1) = ball_face
            call ball%create(faces=faces_given, metres=1.0d0)
            call found%model_sections(model=ball, normals=reshape([0.0d0, 0.0d0, 1.0d0], [1, 3], order=[2, 1]), &
                offsets=[0.1d0], tolerance=0.1d0, call=watching)
            call show('out', found)
        end block
        call begin('model_intersections_with')
        block
            type(nurbs_spline) :: sphere
            type(nurbs_face) :: ball_face
            type(nurbs_model) :: ball
            type(nurbs_face) :: faces_given(1)
            type(nurbs_call) :: watching
            type(nurbs_meet) :: found
            call create_sphere(out=sphere, radius=1.0d0, form=0)
            call ball_face%create(surface=sphere, sizes=[integer(c_int32_t) ::], tolerance=1d-09, flags=0)
            faces_given(1) = ball_face
            call ball%create(faces=faces_given, metres=1.0d0)
            call found%of_models(a=model, b=ball, tolerance=0.1d0, call=watching)
            call show('out', found)
        end block
        call begin('meet_trim_with')
        block
            type(nurbs_call) :: watching
            type(nurbs_meet) :: found
            call found%trimmed(meet=meet, face=face, call=watching)
            call show('out', found)
        end block
        call begin('meet_trim_second_with')
        block
            type(nurbs_spline) :: wall
            type(nurbs_meet) :: crossing
            type(nurbs_call) :: watching
            type(nurbs_meet) :: found
            call wall%create_bezier(degrees=[1, 1], points=reshape([0.3d0, -1.0d0, -1.0d0, 0.3d0, -1.0d0, 9.0d0, &
                0.4d0, 9.0d0, -1.0d0, 0.4d0, 9.0d0, 9.0d0], [4, 3], order=[2, 1]))
            call crossing%surfaces(a=surface, b=wall, tolerance=0.01d0)
            call found%trimmed_second(meet=crossing, face=face, call=watching)
            call show('out', found)
        end block
        call begin('mesh_surface_with')
        block
            type(nurbs_mesh_options) :: options_given
            type(nurbs_call) :: watching
            type(nurbs_mesh) :: found
            call default_mesh_options(options_given)
            options_given%chord = 1.0d0
            options_given%relative_chord = 0.0d0
            call found%of_surface(g=surface, options=options_given, call=watching)
            call show('out', found)
        end block
        call begin('mesh_surface_with by length')
        block
            type(nurbs_mesh_options) :: options_given
            type(nurbs_call) :: watching
            type(nurbs_mesh) :: found
            call default_mesh_options(options_given)
            options_given%chord = 10.0d0
            options_given%relative_chord = 0.0d0
            options_given%longest = 1.5d0
            call found%of_surface(g=surface, options=options_given, call=watching)
            call show('out', found)
        end block
        call begin('mesh_surface_with by angle')
        block
            type(nurbs_mesh_options) :: options_given
            type(nurbs_call) :: watching
            type(nurbs_mesh) :: found
            call default_mesh_options(options_given)
            options_given%chord = 10.0d0
            options_given%relative_chord = 0.0d0
            options_given%angle = 0.5d0
            call found%of_surface(g=surface, options=options_given, call=watching)
            call show('out', found)
        end block
        call begin('mesh_face_with')
        block
            type(nurbs_mesh_options) :: options_given
            type(nurbs_call) :: watching
            type(nurbs_mesh) :: found
            call default_mesh_options(options_given)
            options_given%chord = 1.0d0
            options_given%relative_chord = 0.0d0
            call found%of_face(face=face, options=options_given, call=watching)
            call show('out', found)
        end block
        call begin('mesh_model_with')
        block
            type(nurbs_mesh_options) :: options_given
            type(nurbs_call) :: watching
            type(nurbs_mesh) :: found
            call default_mesh_options(options_given)
            options_given%chord = 1.0d0
            options_given%relative_chord = 0.0d0
            call found%of_model(model=model, options=options_given, call=watching)
            call show('out', found)
        end block
        call begin('mesh_surface_with without small angles')
        block
            type(nurbs_mesh_options) :: options_given
            type(nurbs_call) :: watching
            type(nurbs_mesh) :: found
            call default_mesh_options(options_given)
            options_given%chord = 10.0d0
            options_given%relative_chord = 0.0d0
            options_given%minimum_angle = 0.4d0
            call found%of_surface(g=surface, options=options_given, call=watching)
            call show('out', found)
        end block
        call by_hand('mesh_surface_levels_with')
        call by_hand('mesh_face_levels_with')
        call by_hand('mesh_model_levels_with')
        call begin('mesh_volume_with')
        block
            type(nurbs_mesh_options) :: options_given
            type(nurbs_call) :: watching
            type(nurbs_mesh) :: found
            call default_mesh_options(options_given)
            options_given%chord = 0.1d0
            options_given%relative_chord = 0.0d0
            call found%of_volume(g=solid, options=options_given, limit=100, call=watching)
            call show('out', found)
        end block
        call by_hand('mesh_write_with')
        call by_hand('mesh_write_with as text')
        call by_hand('mesh_write_with as OBJ')
        call by_hand('mesh_write_with as PLY')
        call by_hand('mesh_write_with as GLB')
        call by_hand('mesh_write_with as VTU')
        call begin('mesh_write_file_with')
        block
            type(nurbs_call) :: watching
            call mesh%write_file(path=written('smoke_calls_fortran.replaced', replaced_text), format=8, call=watching)
        end block
        call begin('mesh_write_file_with in inches')
        block
            type(nurbs_write_options) :: options_given
            type(nurbs_call) :: watching
            call default_write_options(options_given)
            options_given%unit = 0.0254d0
            call mesh%write_file(path=written('smoke_calls_fortran.replaced', replaced_text), format=3, &
                options=options_given, call=watching)
        end block
    end subroutine calls_of_data

    subroutine calls_of_edit()
        call begin('transform')
        block
            type(nurbs_spline) :: out_found
            call curve%transform(matrix=reshape([0.0d0, 1.0d0, -1.0d0, 0.0d0], [2, 2], order=[2, 1]), out=out_found, &
                translation=[0.0d0, 1.0d0])
            call show('out', out_found)
        end block
        call begin('transform_projective')
        block
            type(nurbs_spline) :: out_found
            call curve%transform_projective(matrix=reshape([1.0d0, 0.0d0, 0.0d0, 0.0d0, 1.0d0, 0.0d0, 0.0d0, 0.0d0, &
                2.0d0], [3, 3], order=[2, 1]), out=out_found)
            call show('out', out_found)
        end block
        call begin('mirror')
        block
            type(nurbs_spline) :: out_found
            call mirror_spline(spline=curve, point=[0.1d0, 0.9d0], normal=[0.1d0, 0.9d0], out=out_found)
            call show('out', out_found)
        end block
        call begin('project_to_plane')
        block
            type(nurbs_spline) :: out_found
            call project_spline_to_plane(spline=curve, point=[0.1d0, 0.9d0], normal=[0.1d0, 0.9d0], out=out_found)
            call show('out', out_found)
        end block
        call begin('project_to_plane along')
        block
            type(nurbs_spline) :: out_found
            call project_spline_to_plane(spline=curve, point=[0.1d0, 0.9d0], normal=[0.1d0, 0.9d0], out=out_found, &
                direction=[0.1d0, 0.9d0])
            call show('out', out_found)
        end block
        call begin('project_from')
        block
            type(nurbs_spline) :: out_found
            call project_spline_from(spline=curve, eye=[0.3d0, 0.7d0], point=[0.1d0, 0.9d0], normal=[0.1d0, 0.9d0], &
                out=out_found)
            call show('out', out_found)
        end block
        call begin('make_rational')
        block
            type(nurbs_spline) :: out_found
            call loop%make_rational(out=out_found)
            call show('out', out_found)
        end block
        call begin('to_homogeneous')
        block
            type(nurbs_spline) :: out_found
            call curve%to_homogeneous(out=out_found)
            call show('out', out_found)
        end block
        call begin('from_homogeneous')
        block
            type(nurbs_spline) :: out_found
            call volume%from_homogeneous(out=out_found)
            call show('out', out_found)
        end block
        call begin('normalize_weights')
        block
            type(nurbs_spline) :: out_found
            call normalize_weights(g=homogeneous, out=out_found)
            call show('out', out_found)
        end block
        call begin('equalize_end_weights')
        block
            type(nurbs_spline) :: out_found
            call equalize_end_weights(g=curve, axis=1, out=out_found)
            call show('out', out_found)
        end block
        call begin('pull_weight')
        block
            type(nurbs_spline) :: out_found
            real(c_double) :: weight_found
            call pull_weight(g=curve, index=4, params=[0.3d0], distance=0.01d0, out=out_found, weight=weight_found)
            call show('out', out_found)
            call show('weight', weight_found)
        end block
        call begin('pull_weights')
        block
            type(nurbs_spline) :: out_found
            real(c_double) :: factor_found
            call pull_weights(g=curve, indices=[3, 4], params=[0.3d0], distance=0.01d0, out=out_found, &
                factor=factor_found)
            call show('out', out_found)
            call show('factor', factor_found)
        end block
        call begin('set_weights')
        block
            type(nurbs_spline) :: out_found
            call set_weights(g=loop, indices=[3, 4], weights=[0.3d0, 0.6d0], out=out_found)
            call show('out', out_found)
        end block
        call begin('weight_through')
        block
            type(nurbs_spline) :: out_found
            real(c_double) :: weight_found
            call weight_through(g=curve, index=2, params=[0.125d0], target=[0.75d0, 0.75d0], tolerance=1.0d0, &
                out=out_found, weight=weight_found)
            call show('out', out_found)
            call show('weight', weight_found)
        end block
        call begin('pull_point')
        block
            type(nurbs_spline) :: out_found
            real(c_double) :: moved_found
            call pull_point(g=volume, index=1, params=[0.1d0, 0.9d0, 0.3d0], direction=[0.1d0, 0.9d0, 0.3d0, 0.7d0], &
                distance=1.0d0, out=out_found, moved=moved_found)
            call show('out', out_found)
            call show('moved', moved_found)
        end block
        call begin('insert_on_leg')
        block
            type(nurbs_spline) :: out_found
            real(c_double) :: knot_found
            call insert_on_leg(g=segment, axis=1, index=1, ratio=0.5d0, out=out_found, knot=knot_found)
            call show('out', out_found)
            call show('knot', knot_found)
        end block
        call begin('insert_at_point')
        block
            type(nurbs_spline) :: out_found
            integer(c_int32_t) :: index_found
            real(c_double) :: ratio_found
            real(c_double) :: knot_found
            call insert_at_point(g=loop, axis=1, point=[0.0d0, 1.0d0], tolerance=1.0d0, out=out_found, &
                index=index_found, ratio=ratio_found, knot=knot_found)
            call show('out', out_found)
            call show('index', index_found - 1)
            call show('ratio', ratio_found)
            call show('knot', knot_found)
        end block
        call begin('constrain')
        block
            type(nurbs_spline) :: out_found
            real(c_double), allocatable :: residuals_found(:)
            integer(c_int64_t) :: rank_found
            real(c_double) :: moved_found
            real(c_double) :: optimality_found
            allocate (residuals_found(2))
            call constrain(g=curve, params=reshape([0.3d0, 0.6d0], [2, 1], order=[2, 1]), &
                targets=reshape([0.1d0, 0.9d0, 0.3d0, 0.7d0], [2, 2], order=[2, 1]), out=out_found, &
                keep=reshape([0, 0], [2, 1]), tolerance=0.0d0, residuals=residuals_found, rank=rank_found, &
                moved=moved_found, optimality=optimality_found)
            call show('out', out_found)
            call show('residuals', residuals_found)
            call show('rank', rank_found)
            call show('moved', moved_found)
            call show('optimality', optimality_found)
        end block
        call begin('warp')
        block
            type(nurbs_spline) :: out_found
            call warp(g=curve, direction=[0.1d0, 0.9d0], distance=1.0d0, order=1, out=out_found, &
                range=reshape([0.3d0, 0.6d0], [2, 1]))
            call show('out', out_found)
        end block
        call begin('warp periodic')
        block
            type(nurbs_spline) :: out_found
            call warp(g=loop, direction=[0.1d0, 0.9d0], distance=1.0d0, order=1, out=out_found)
            call show('out', out_found)
        end block
        call begin('flatten')
        block
            type(nurbs_spline) :: out_found
            real(c_double) :: moved_found
            call flatten(g=curve, point=[0.1d0, 0.9d0], normal=[0.1d0, 0.9d0], out=out_found, moved=moved_found, &
                range=reshape([0.3d0, 0.6d0], [2, 1]))
            call show('out', out_found)
            call show('moved', moved_found)
        end block
        call begin('flatten along')
        block
            type(nurbs_spline) :: out_found
            real(c_double) :: moved_found
            call flatten(g=curve, point=[0.1d0, 0.9d0], normal=[0.1d0, 0.9d0], out=out_found, direction=[0.1d0, &
                0.9d0], moved=moved_found, range=reshape([0.3d0, 0.6d0], [2, 1]))
            call show('out', out_found)
            call show('moved', moved_found)
        end block
        call begin('free_form_deform')
        block
            type(nurbs_spline) :: square
            type(nurbs_spline) :: out_found
            real(c_double) :: deviation_found
            logical :: proven_found
            call square%create_bezier(degrees=[1, 1], points=reshape([0.0d0, 0.0d0, 0.0d0, 1.0d0, 1.0d0, 0.0d0, 1.0d0, &
                2.0d0], [4, 2], order=[2, 1]))
            call free_form_deform(g=curve, volume=square, lower=[-1.0d0, -1.0d0], upper=[1.0d0, 1.0d0], &
                tolerance=0.1d0, out=out_found, deviation=deviation_found, proven=proven_found)
            call show('out', out_found)
            call show('deviation', deviation_found)
            call show('proven', proven_found)
        end block
        call begin('fair')
        block
            type(nurbs_spline) :: out_found
            real(c_double), allocatable :: energies_found(:)
            real(c_double) :: bound_found
            allocate (energies_found(2))
            call fair(g=curve, order=2, tolerance=1000.0d0, out=out_found, energies=energies_found, bound=bound_found)
            call show('out', out_found)
            call show('energies', energies_found)
            call show('bound', bound_found)
        end block
        call begin('fair surface')
        block
            type(nurbs_spline) :: out_found
            real(c_double), allocatable :: energies_found(:)
            real(c_double) :: bound_found
            allocate (energies_found(2))
            call fair(g=surface, order=1, tolerance=1000.0d0, out=out_found, &
                keep=reshape([(-1), (-1), (-1), (-1)], [2, 2]), energies=energies_found, bound=bound_found)
            call show('out', out_found)
            call show('energies', energies_found)
            call show('bound', bound_found)
        end block
        call begin('constrain directions')
        block
            type(nurbs_spline) :: out_found
            real(c_double), allocatable :: residuals_found(:)
            integer(c_int64_t) :: rank_found
            real(c_double) :: moved_found
            real(c_double) :: optimality_found
            allocate (residuals_found(2))
            call constrain(g=surface, params=reshape([0.1d0, 0.9d0, 0.3d0, 0.7d0], [2, 2], order=[2, 1]), &
                targets=reshape([0.1d0, 0.9d0, 0.3d0, 0.7d0, 0.2d0, 0.6d0], [2, 3], order=[2, 1]), out=out_found, &
                kinds=[2, 0], tolerance=0.0d0, residuals=residuals_found, rank=rank_found, moved=moved_found, &
                optimality=optimality_found)
            call show('out', out_found)
            call show('residuals', residuals_found)
            call show('rank', rank_found)
            call show('moved', moved_found)
            call show('optimality', optimality_found)
        end block
        call begin('constrain curvature')
        block
            type(nurbs_spline) :: out_found
            real(c_double), allocatable :: residuals_found(:)
            integer(c_int64_t) :: rank_found
            real(c_double) :: moved_found
            real(c_double) :: optimality_found
            allocate (residuals_found(1))
            call constrain(g=curve, params=reshape([0.1d0], [1, 1], order=[2, 1]), &
                targets=reshape([-1.0d0, 0.1d0], [1, 2], order=[2, 1]), out=out_found, kinds=[3], weight_costs=[1.0d0, &
                1.0d0, 1.0d0, 1.0d0, 1.0d0, 1.0d0, 1.0d0, 1.0d0, 1.0d0], tolerance=1d-09, residuals=residuals_found, &
                rank=rank_found, moved=moved_found, optimality=optimality_found)
            call show('out', out_found)
            call show('residuals', residuals_found)
            call show('rank', rank_found)
            call show('moved', moved_found)
            call show('optimality', optimality_found)
        end block
        call begin('constrain with costs')
        block
            type(nurbs_spline) :: out_found
            real(c_double), allocatable :: residuals_found(:)
            integer(c_int64_t) :: rank_found
            real(c_double) :: moved_found
            real(c_double) :: optimality_found
            allocate (residuals_found(2))
            call constrain(g=curve, params=reshape([0.3d0, 0.6d0], [2, 1], order=[2, 1]), &
                targets=reshape([0.1d0, 0.9d0, 0.3d0, 0.7d0], [2, 2], order=[2, 1]), out=out_found, kinds=[0, 0], &
                orders=reshape([0, 1], [2, 1], order=[2, 1]), keep=reshape([0, 0], [2, 1]), costs=[1.0d0, 1.0d0, &
                1.0d0, 1.0d0, 1.0d0, 1.0d0, 1.0d0, 1.0d0, 1.0d0], weight_costs=[1.0d0, 1.0d0, 1.0d0, 1.0d0, 1.0d0, &
                1.0d0, 1.0d0, 1.0d0, 1.0d0], tolerance=1d-06, residuals=residuals_found, rank=rank_found, &
                moved=moved_found, optimality=optimality_found)
            call show('out', out_found)
            call show('residuals', residuals_found)
            call show('rank', rank_found)
            call show('moved', moved_found)
            call show('optimality', optimality_found)
        end block
        call begin('bend')
        block
            type(nurbs_spline) :: out_found
            real(c_double) :: deviation_found
            logical :: proven_found
            call bend(g=curve, origin=[0.1d0, 0.9d0], along=[1.0d0, 0.0d0], across=[0.0d0, 1.0d0], curvature=1.0d0, &
                tolerance=0.1d0, out=out_found, lower=-9.0d0, upper=9.0d0, deviation=deviation_found, &
                proven=proven_found)
            call show('out', out_found)
            call show('deviation', deviation_found)
            call show('proven', proven_found)
        end block
        call begin('snap_boundary')
        block
            type(nurbs_spline) :: out_found
            real(c_double) :: bound_found
            call snap_boundary(g=curve, axis=1, end=1, other=segment, other_axis=1, other_end=0, out=out_found, &
                order=1, flags=0, bound=bound_found)
            call show('out', out_found)
            call show('bound', bound_found)
        end block
        call begin('snap_boundary surface')
        block
            type(nurbs_spline) :: out_found
            real(c_double) :: bound_found
            call snap_boundary(g=surface, axis=1, end=1, other=surface, other_axis=2, other_end=0, out=out_found, &
                order=1, flags=67108864, bound=bound_found)
            call show('out', out_found)
            call show('bound', bound_found)
        end block
        call begin('constrain_with')
        block
            type(nurbs_spline) :: out_found
            real(c_double), allocatable :: residuals_found(:)
            integer(c_int64_t) :: rank_found
            real(c_double) :: moved_found
            real(c_double) :: optimality_found
            type(nurbs_call) :: watching
            allocate (residuals_found(2))
            call constrain(g=curve, params=reshape([0.3d0, 0.6d0], [2, 1], order=[2, 1]), &
                targets=reshape([0.1d0, 0.9d0, 0.3d0, 0.7d0], [2, 2], order=[2, 1]), out=out_found, &
                keep=reshape([0, 0], [2, 1]), tolerance=0.0d0, residuals=residuals_found, rank=rank_found, &
                moved=moved_found, optimality=optimality_found, call=watching)
            call show('out', out_found)
            call show('residuals', residuals_found)
            call show('rank', rank_found)
            call show('moved', moved_found)
            call show('optimality', optimality_found)
        end block
        call begin('free_form_deform_with')
        block
            type(nurbs_spline) :: square
            type(nurbs_spline) :: out_found
            real(c_double) :: deviation_found
            logical :: proven_found
            type(nurbs_call) :: watching
            call square%create_bezier(degrees=[1, 1], points=reshape([0.0d0, 0.0d0, 0.0d0, 1.0d0, 1.0d0, 0.0d0, 1.0d0, &
                2.0d0], [4, 2], order=[2, 1]))
            call free_form_deform(g=curve, volume=square, lower=[-1.0d0, -1.0d0], upper=[1.0d0, 1.0d0], &
                tolerance=0.1d0, out=out_found, deviation=deviation_found, proven=proven_found, call=watching)
            call show('out', out_found)
            call show('deviation', deviation_found)
            call show('proven', proven_found)
        end block
        call begin('fair_with')
        block
            type(nurbs_spline) :: out_found
            real(c_double), allocatable :: energies_found(:)
            real(c_double) :: bound_found
            type(nurbs_call) :: watching
            allocate (energies_found(2))
            call fair(g=curve, order=2, tolerance=1000.0d0, out=out_found, energies=energies_found, bound=bound_found, &
                call=watching)
            call show('out', out_found)
            call show('energies', energies_found)
            call show('bound', bound_found)
        end block
        call begin('fair_with surface')
        block
            type(nurbs_spline) :: out_found
            real(c_double), allocatable :: energies_found(:)
            real(c_double) :: bound_found
            type(nurbs_call) :: watching
            allocate (energies_found(2))
            call fair(g=surface, order=1, tolerance=1000.0d0, out=out_found, &
                keep=reshape([(-1), (-1), (-1), (-1)], [2, 2]), energies=energies_found, bound=bound_found, &
                call=watching)
            call show('out', out_found)
            call show('energies', energies_found)
            call show('bound', bound_found)
        end block
        call begin('constrain_with directions')
        block
            type(nurbs_spline) :: out_found
            real(c_double), allocatable :: residuals_found(:)
            integer(c_int64_t) :: rank_found
            real(c_double) :: moved_found
            real(c_double) :: optimality_found
            type(nurbs_call) :: watching
            allocate (residuals_found(2))
            call constrain(g=surface, params=reshape([0.1d0, 0.9d0, 0.3d0, 0.7d0], [2, 2], order=[2, 1]), &
                targets=reshape([0.1d0, 0.9d0, 0.3d0, 0.7d0, 0.2d0, 0.6d0], [2, 3], order=[2, 1]), out=out_found, &
                kinds=[2, 0], tolerance=0.0d0, residuals=residuals_found, rank=rank_found, moved=moved_found, &
                optimality=optimality_found, call=watching)
            call show('out', out_found)
            call show('residuals', residuals_found)
            call show('rank', rank_found)
            call show('moved', moved_found)
            call show('optimality', optimality_found)
        end block
        call begin('constrain_with curvature')
        block
            type(nurbs_spline) :: out_found
            real(c_double), allocatable :: residuals_found(:)
            integer(c_int64_t) :: rank_found
            real(c_double) :: moved_found
            real(c_double) :: optimality_found
            type(nurbs_call) :: watching
            allocate (residuals_found(1))
            call constrain(g=curve, params=reshape([0.1d0], [1, 1], order=[2, 1]), &
                targets=reshape([-1.0d0, 0.1d0], [1, 2], order=[2, 1]), out=out_found, kinds=[3], weight_costs=[1.0d0, &
                1.0d0, 1.0d0, 1.0d0, 1.0d0, 1.0d0, 1.0d0, 1.0d0, 1.0d0], tolerance=1d-09, residuals=residuals_found, &
                rank=rank_found, moved=moved_found, optimality=optimality_found, call=watching)
            call show('out', out_found)
            call show('residuals', residuals_found)
            call show('rank', rank_found)
            call show('moved', moved_found)
            call show('optimality', optimality_found)
        end block
        call begin('constrain_with with costs')
        block
            type(nurbs_spline) :: out_found
            real(c_double), allocatable :: residuals_found(:)
            integer(c_int64_t) :: rank_found
            real(c_double) :: moved_found
            real(c_double) :: optimality_found
            type(nurbs_call) :: watching
            allocate (residuals_found(2))
            call constrain(g=curve, params=reshape([0.3d0, 0.6d0], [2, 1], order=[2, 1]), &
                targets=reshape([0.1d0, 0.9d0, 0.3d0, 0.7d0], [2, 2], order=[2, 1]), out=out_found, kinds=[0, 0], &
                orders=reshape([0, 1], [2, 1], order=[2, 1]), keep=reshape([0, 0], [2, 1]), costs=[1.0d0, 1.0d0, &
                1.0d0, 1.0d0, 1.0d0, 1.0d0, 1.0d0, 1.0d0, 1.0d0], weight_costs=[1.0d0, 1.0d0, 1.0d0, 1.0d0, 1.0d0, &
                1.0d0, 1.0d0, 1.0d0, 1.0d0], tolerance=1d-06, residuals=residuals_found, rank=rank_found, &
                moved=moved_found, optimality=optimality_found, call=watching)
            call show('out', out_found)
            call show('residuals', residuals_found)
            call show('rank', rank_found)
            call show('moved', moved_found)
            call show('optimality', optimality_found)
        end block
        call begin('bend_with')
        block
            type(nurbs_spline) :: out_found
            real(c_double) :: deviation_found
            logical :: proven_found
            type(nurbs_call) :: watching
            call bend(g=curve, origin=[0.1d0, 0.9d0], along=[1.0d0, 0.0d0], across=[0.0d0, 1.0d0], curvature=1.0d0, &
                tolerance=0.1d0, out=out_found, lower=-9.0d0, upper=9.0d0, deviation=deviation_found, &
                proven=proven_found, call=watching)
            call show('out', out_found)
            call show('deviation', deviation_found)
            call show('proven', proven_found)
        end block
    end subroutine calls_of_edit

    subroutine calls_of_evaluation()
        call begin('find_spans')
        block
            integer(c_int64_t), allocatable :: spans_found(:)
            allocate (spans_found(6))
            call find_spans(degree=2, knots=[0.0d0, 0.0d0, 0.0d0, 0.25d0, 0.25d0, 0.5d0, 0.5d0, 0.75d0, 0.75d0, 1.0d0, &
                1.0d0, 1.0d0], params=[0.1d0, 0.9d0, 0.3d0, 0.7d0, 0.2d0, 0.6d0], spans=spans_found, flags=0)
            call show('spans', spans_found - 1)
        end block
        call begin('bernstein')
        block
            real(c_double), allocatable :: values_found(:, :, :)
            allocate (values_found(6, 6, 4))
            call bernstein(degree=5, order=3, params=[0.1d0, 0.9d0, 0.3d0, 0.7d0, 0.2d0, 0.6d0], values=values_found)
            call show('values', flat(reshape(values_found, [size(values_found, 2), size(values_found, 3), &
                size(values_found, 1)], order=[3, 1, 2])))
        end block
        call begin('basis')
        block
            integer(c_int64_t), allocatable :: spans_found(:)
            real(c_double), allocatable :: values_found(:, :, :)
            allocate (spans_found(6))
            allocate (values_found(6, 3, 5))
            call basis(degree=2, knots=[0.0d0, 0.0d0, 0.0d0, 0.25d0, 0.25d0, 0.5d0, 0.5d0, 0.75d0, 0.75d0, 1.0d0, &
                1.0d0, 1.0d0], order=4, params=[0.1d0, 0.9d0, 0.3d0, 0.7d0, 0.2d0, 0.6d0], spans=spans_found, &
                values=values_found, flags=0)
            call show('spans', spans_found - 1)
            call show('values', flat(reshape(values_found, [size(values_found, 2), size(values_found, 3), &
                size(values_found, 1)], order=[3, 1, 2])))
        end block
        call begin('rational_basis')
        block
            integer(c_int64_t), allocatable :: spans_found(:, :)
            real(c_double), allocatable :: values_found(:, :)
            allocate (spans_found(6, 1))
            allocate (values_found(6, 3))
            call curve%rational_basis(params=reshape([0.1d0, 0.9d0, 0.3d0, 0.7d0, 0.2d0, 0.6d0], [6, 1], order=[2, &
                1]), spans=spans_found, values=values_found, flags=0)
            call show('spans', flat(reshape(spans_found, [size(spans_found, 2), size(spans_found, 1)], order=[2, 1])) &
                - 1)
            call show('values', flat(reshape(values_found, [size(values_found, 2), size(values_found, 1)], order=[2, &
                1])))
        end block
        call begin('rational_basis surface')
        block
            integer(c_int64_t), allocatable :: spans_found(:, :)
            real(c_double), allocatable :: values_found(:, :)
            allocate (spans_found(3, 2))
            allocate (values_found(3, 6))
            call surface%rational_basis(params=reshape([0.1d0, 0.9d0, 0.3d0, 0.7d0, 0.2d0, 0.6d0], [3, 2], order=[2, &
                1]), spans=spans_found, values=values_found, flags=0)
            call show('spans', flat(reshape(spans_found, [size(spans_found, 2), size(spans_found, 1)], order=[2, 1])) &
                - 1)
            call show('values', flat(reshape(values_found, [size(values_found, 2), size(values_found, 1)], order=[2, &
                1])))
        end block
        call begin('basis_gradients')
        block
            integer(c_int64_t), allocatable :: spans_found(:, :)
            real(c_double), allocatable :: gradients_found(:, :, :)
            allocate (spans_found(6, 1))
            allocate (gradients_found(6, 2, 3))
            call curve%basis_gradients(params=reshape([0.1d0, 0.9d0, 0.3d0, 0.7d0, 0.2d0, 0.6d0], [6, 1], order=[2, &
                1]), spans=spans_found, gradients=gradients_found, flags=0)
            call show('spans', flat(reshape(spans_found, [size(spans_found, 2), size(spans_found, 1)], order=[2, 1])) &
                - 1)
            call show('gradients', flat(reshape(gradients_found, [size(gradients_found, 2), size(gradients_found, 3), &
                size(gradients_found, 1)], order=[3, 1, 2])))
        end block
        call begin('basis_gradients surface')
        block
            integer(c_int64_t), allocatable :: spans_found(:, :)
            real(c_double), allocatable :: gradients_found(:, :, :)
            allocate (spans_found(3, 2))
            allocate (gradients_found(3, 3, 6))
            call surface%basis_gradients(params=reshape([0.1d0, 0.9d0, 0.3d0, 0.7d0, 0.2d0, 0.6d0], [3, 2], order=[2, &
                1]), spans=spans_found, gradients=gradients_found, flags=0)
            call show('spans', flat(reshape(spans_found, [size(spans_found, 2), size(spans_found, 1)], order=[2, 1])) &
                - 1)
            call show('gradients', flat(reshape(gradients_found, [size(gradients_found, 2), size(gradients_found, 3), &
                size(gradients_found, 1)], order=[3, 1, 2])))
        end block
        call begin('eval')
        block
            real(c_double), allocatable :: points_found(:, :)
            allocate (points_found(6, 2))
            call curve%eval(params=reshape([0.1d0, 0.9d0, 0.3d0, 0.7d0, 0.2d0, 0.6d0], [6, 1], order=[2, 1]), &
                points=points_found, flags=0)
            call show('points', flat(reshape(points_found, [size(points_found, 2), size(points_found, 1)], order=[2, &
                1])))
        end block
        call begin('eval surface')
        block
            real(c_double), allocatable :: points_found(:, :)
            allocate (points_found(3, 3))
            call surface%eval(params=reshape([0.1d0, 0.9d0, 0.3d0, 0.7d0, 0.2d0, 0.6d0], [3, 2], order=[2, 1]), &
                points=points_found, flags=0)
            call show('points', flat(reshape(points_found, [size(points_found, 2), size(points_found, 1)], order=[2, &
                1])))
        end block
        call begin('eval volume')
        block
            real(c_double), allocatable :: points_found(:, :)
            allocate (points_found(2, 4))
            call volume%eval(params=reshape([0.1d0, 0.9d0, 0.3d0, 0.7d0, 0.2d0, 0.6d0], [2, 3], order=[2, 1]), &
                points=points_found, flags=0)
            call show('points', flat(reshape(points_found, [size(points_found, 2), size(points_found, 1)], order=[2, &
                1])))
        end block
        call begin('eval_derivs')
        block
            real(c_double), allocatable :: derivs_found(:, :, :)
            allocate (derivs_found(6, 2, 6))
            call curve%eval_derivs(order=5, params=reshape([0.1d0, 0.9d0, 0.3d0, 0.7d0, 0.2d0, 0.6d0], [6, 1], &
                order=[2, 1]), derivs=derivs_found, flags=0)
            call show('derivs', flat(reshape(derivs_found, [size(derivs_found, 2), size(derivs_found, 3), &
                size(derivs_found, 1)], order=[3, 1, 2])))
        end block
        call begin('eval_derivs volume')
        block
            real(c_double), allocatable :: derivs_found(:, :, :)
            allocate (derivs_found(2, 4, 35))
            call volume%eval_derivs(order=4, params=reshape([0.1d0, 0.9d0, 0.3d0, 0.7d0, 0.2d0, 0.6d0], [2, 3], &
                order=[2, 1]), derivs=derivs_found, flags=0)
            call show('derivs', flat(reshape(derivs_found, [size(derivs_found, 2), size(derivs_found, 3), &
                size(derivs_found, 1)], order=[3, 1, 2])))
        end block
        call begin('eval_grid')
        block
            real(c_double), allocatable :: points_found(:, :)
            allocate (points_found(4, 3))
            call surface%eval_grid(counts=[2, 2], params=[0.1d0, 0.9d0, 0.3d0, 0.7d0], points=points_found, flags=0)
            call show('points', flat(reshape(points_found, [size(points_found, 2), size(points_found, 1)], order=[2, &
                1])))
        end block
        call begin('eval_grid_derivs')
        block
            real(c_double), allocatable :: derivs_found(:, :, :)
            allocate (derivs_found(8, 4, 10))
            call volume%eval_grid_derivs(order=2, counts=[2, 2, 2], params=[0.1d0, 0.9d0, 0.3d0, 0.7d0, 0.2d0, 0.6d0], &
                derivs=derivs_found, flags=0)
            call show('derivs', flat(reshape(derivs_found, [size(derivs_found, 2), size(derivs_found, 3), &
                size(derivs_found, 1)], order=[3, 1, 2])))
        end block
        call begin('eval_f32')
        block
            real(c_float), allocatable :: points_found(:, :)
            allocate (points_found(6, 2))
            call curve%eval_f32(params=reshape([0.1d0, 0.9d0, 0.3d0, 0.7d0, 0.2d0, 0.6d0], [6, 1], order=[2, 1]), &
                points=points_found, flags=0)
            call show('points', flat(reshape(points_found, [size(points_found, 2), size(points_found, 1)], order=[2, &
                1])))
        end block
        call begin('eval_grid_f32')
        block
            real(c_float), allocatable :: points_found(:, :)
            allocate (points_found(8, 4))
            call volume%eval_grid_f32(counts=[2, 2, 2], params=[0.1d0, 0.9d0, 0.3d0, 0.7d0, 0.2d0, 0.6d0], &
                points=points_found, flags=0)
            call show('points', flat(reshape(points_found, [size(points_found, 2), size(points_found, 1)], order=[2, &
                1])))
        end block
        call begin('rational_collocation')
        block
            real(c_double), allocatable :: values_found(:)
            integer(c_int64_t), allocatable :: columns_found(:)
            integer(c_int64_t), allocatable :: row_pointers_found(:)
            call curve%rational_collocation(params=reshape([0.1d0, 0.9d0, 0.3d0, 0.7d0, 0.2d0, 0.6d0], [6, 1], &
                order=[2, 1]), values=values_found, columns=columns_found, row_pointers=row_pointers_found, flags=0)
            call show('values', values_found)
            call show('columns', columns_found - 1)
            call show('row_pointers', row_pointers_found - 1)
        end block
        call begin('rational_collocation of derivatives')
        block
            real(c_double), allocatable :: values_found(:)
            integer(c_int64_t), allocatable :: columns_found(:)
            integer(c_int64_t), allocatable :: row_pointers_found(:)
            call curve%rational_collocation(params=reshape([0.1d0, 0.9d0, 0.3d0, 0.7d0, 0.2d0, 0.6d0], [6, 1], &
                order=[2, 1]), values=values_found, columns=columns_found, row_pointers=row_pointers_found, &
                orders=[2], flags=0)
            call show('values', values_found)
            call show('columns', columns_found - 1)
            call show('row_pointers', row_pointers_found - 1)
        end block
        call begin('hull_size')
        block
            real(c_double), allocatable :: sizes_found(:)
            allocate (sizes_found(6))
            call curve%hull_size(params=reshape([0.1d0, 0.9d0, 0.3d0, 0.7d0, 0.2d0, 0.6d0], [6, 1], order=[2, 1]), &
                sizes=sizes_found, flags=0)
            call show('sizes', sizes_found)
        end block
        call begin('hull_size signed')
        block
            real(c_double), allocatable :: sizes_found(:)
            allocate (sizes_found(6))
            call homogeneous%hull_size(params=reshape([0.1d0, 0.9d0, 0.3d0, 0.7d0, 0.2d0, 0.6d0], [6, 1], order=[2, &
                1]), sizes=sizes_found, flags=0)
            call show('sizes', sizes_found)
        end block
        call begin('surface_eval_frames')
        block
            real(c_double), allocatable :: points_found(:, :)
            real(c_double), allocatable :: du_found(:, :)
            real(c_double), allocatable :: dv_found(:, :)
            real(c_double), allocatable :: normals_found(:, :)
            integer(c_int32_t), allocatable :: states_found(:)
            allocate (points_found(3, 3))
            allocate (du_found(3, 3))
            allocate (dv_found(3, 3))
            allocate (normals_found(3, 3))
            allocate (states_found(3))
            call surface_frames(g=surface, params=reshape([0.1d0, 0.9d0, 0.3d0, 0.7d0, 0.2d0, 0.6d0], [3, 2], &
                order=[2, 1]), points=points_found, du=du_found, dv=dv_found, normals=normals_found, &
                states=states_found, flags=0)
            call show('points', flat(reshape(points_found, [size(points_found, 2), size(points_found, 1)], order=[2, &
                1])))
            call show('du', flat(reshape(du_found, [size(du_found, 2), size(du_found, 1)], order=[2, 1])))
            call show('dv', flat(reshape(dv_found, [size(dv_found, 2), size(dv_found, 1)], order=[2, 1])))
            call show('normals', flat(reshape(normals_found, [size(normals_found, 2), size(normals_found, 1)], &
                order=[2, 1])))
            call show('status', states_found)
        end block
        call begin('surface_eval_grid_frames')
        block
            real(c_double), allocatable :: points_found(:, :)
            real(c_double), allocatable :: du_found(:, :)
            real(c_double), allocatable :: dv_found(:, :)
            real(c_double), allocatable :: normals_found(:, :)
            integer(c_int32_t), allocatable :: states_found(:)
            allocate (points_found(4, 3))
            allocate (du_found(4, 3))
            allocate (dv_found(4, 3))
            allocate (normals_found(4, 3))
            allocate (states_found(4))
            call surface_grid_frames(g=surface, counts=[2, 2], params=[0.1d0, 0.9d0, 0.3d0, 0.7d0], &
                points=points_found, du=du_found, dv=dv_found, normals=normals_found, states=states_found, flags=0)
            call show('points', flat(reshape(points_found, [size(points_found, 2), size(points_found, 1)], order=[2, &
                1])))
            call show('du', flat(reshape(du_found, [size(du_found, 2), size(du_found, 1)], order=[2, 1])))
            call show('dv', flat(reshape(dv_found, [size(dv_found, 2), size(dv_found, 1)], order=[2, 1])))
            call show('normals', flat(reshape(normals_found, [size(normals_found, 2), size(normals_found, 1)], &
                order=[2, 1])))
            call show('status', states_found)
        end block
        call begin('surface_eval_curvatures')
        block
            real(c_double), allocatable :: principal_found(:, :)
            real(c_double), allocatable :: directions_found(:, :)
            real(c_double), allocatable :: mean_found(:)
            real(c_double), allocatable :: gaussian_found(:)
            integer(c_int32_t), allocatable :: states_found(:)
            allocate (principal_found(3, 2))
            allocate (directions_found(3, 6))
            allocate (mean_found(3))
            allocate (gaussian_found(3))
            allocate (states_found(3))
            call surface_curvatures(g=surface, params=reshape([0.1d0, 0.9d0, 0.3d0, 0.7d0, 0.2d0, 0.6d0], [3, 2], &
                order=[2, 1]), principal=principal_found, directions=directions_found, mean=mean_found, &
                gaussian=gaussian_found, states=states_found, flags=0)
            call show('principal', flat(reshape(principal_found, [size(principal_found, 2), size(principal_found, 1)], &
                order=[2, 1])))
            call show('directions', flat(reshape(directions_found, [size(directions_found, 2), &
                size(directions_found, 1)], order=[2, 1])))
            call show('mean', mean_found)
            call show('gaussian', gaussian_found)
            call show('status', states_found)
        end block
        call begin('curve_eval_frames')
        block
            real(c_double), allocatable :: points_found(:, :)
            real(c_double), allocatable :: tangents_found(:, :)
            real(c_double), allocatable :: normals_found(:, :)
            real(c_double), allocatable :: curvatures_found(:)
            integer(c_int32_t), allocatable :: states_found(:)
            allocate (points_found(6, 2))
            allocate (tangents_found(6, 2))
            allocate (normals_found(6, 2))
            allocate (curvatures_found(6))
            allocate (states_found(6))
            call curve_frames(g=curve, params=[0.1d0, 0.9d0, 0.3d0, 0.7d0, 0.2d0, 0.6d0], points=points_found, &
                tangents=tangents_found, normals=normals_found, curvatures=curvatures_found, states=states_found, &
                flags=0)
            call show('points', flat(reshape(points_found, [size(points_found, 2), size(points_found, 1)], order=[2, &
                1])))
            call show('tangents', flat(reshape(tangents_found, [size(tangents_found, 2), size(tangents_found, 1)], &
                order=[2, 1])))
            call show('normals', flat(reshape(normals_found, [size(normals_found, 2), size(normals_found, 1)], &
                order=[2, 1])))
            call show('curvatures', curvatures_found)
            call show('status', states_found)
        end block
        call begin('curve_eval_frames in space')
        block
            real(c_double), allocatable :: points_found(:, :)
            real(c_double), allocatable :: tangents_found(:, :)
            real(c_double), allocatable :: normals_found(:, :)
            real(c_double), allocatable :: binormals_found(:, :)
            real(c_double), allocatable :: curvatures_found(:)
            real(c_double), allocatable :: torsions_found(:)
            integer(c_int32_t), allocatable :: states_found(:)
            allocate (points_found(6, 3))
            allocate (tangents_found(6, 3))
            allocate (normals_found(6, 3))
            allocate (binormals_found(6, 3))
            allocate (curvatures_found(6))
            allocate (torsions_found(6))
            allocate (states_found(6))
            call curve_frames(g=twist, params=[0.1d0, 0.9d0, 0.3d0, 0.7d0, 0.2d0, 0.6d0], points=points_found, &
                tangents=tangents_found, normals=normals_found, binormals=binormals_found, &
                curvatures=curvatures_found, torsions=torsions_found, states=states_found, flags=0)
            call show('points', flat(reshape(points_found, [size(points_found, 2), size(points_found, 1)], order=[2, &
                1])))
            call show('tangents', flat(reshape(tangents_found, [size(tangents_found, 2), size(tangents_found, 1)], &
                order=[2, 1])))
            call show('normals', flat(reshape(normals_found, [size(normals_found, 2), size(normals_found, 1)], &
                order=[2, 1])))
            call show('binormals', flat(reshape(binormals_found, [size(binormals_found, 2), size(binormals_found, 1)], &
                order=[2, 1])))
            call show('curvatures', curvatures_found)
            call show('torsions', torsions_found)
            call show('status', states_found)
        end block
        call begin('curve_rotation_minimizing_frames')
        block
            real(c_double), allocatable :: points_found(:, :)
            real(c_double), allocatable :: tangents_found(:, :)
            real(c_double), allocatable :: normals_found(:, :)
            real(c_double), allocatable :: binormals_found(:, :)
            integer(c_int32_t), allocatable :: states_found(:)
            allocate (points_found(6, 3))
            allocate (tangents_found(6, 3))
            allocate (normals_found(6, 3))
            allocate (binormals_found(6, 3))
            allocate (states_found(6))
            call rotation_minimizing_frames(g=twist, params=[0.1d0, 0.9d0, 0.3d0, 0.7d0, 0.2d0, 0.6d0], &
                first_normal=[0.0d0, 1.0d0, 2.0d0], points=points_found, tangents=tangents_found, &
                normals=normals_found, binormals=binormals_found, states=states_found, flags=0)
            call show('points', flat(reshape(points_found, [size(points_found, 2), size(points_found, 1)], order=[2, &
                1])))
            call show('tangents', flat(reshape(tangents_found, [size(tangents_found, 2), size(tangents_found, 1)], &
                order=[2, 1])))
            call show('normals', flat(reshape(normals_found, [size(normals_found, 2), size(normals_found, 1)], &
                order=[2, 1])))
            call show('binormals', flat(reshape(binormals_found, [size(binormals_found, 2), size(binormals_found, 1)], &
                order=[2, 1])))
            call show('status', states_found)
        end block
        call begin('weight_points')
        block
            real(c_double), allocatable :: at_zero_found(:)
            real(c_double), allocatable :: at_one_found(:)
            real(c_double), allocatable :: at_weight_found(:)
            allocate (at_zero_found(3))
            allocate (at_one_found(3))
            allocate (at_weight_found(3))
            call weight_points(g=surface, index=2, params=[0.1d0, 0.9d0], at_zero=at_zero_found, at_one=at_one_found, &
                at_weight=at_weight_found)
            call show('at_zero', at_zero_found)
            call show('at_one', at_one_found)
            call show('at_weight', at_weight_found)
        end block
        call begin('weight_cross_ratio')
        block
            real(c_double) :: weight_found
            call weight_cross_ratio(control_point=[0.1d0], at_zero=[0.9d0], at_one=[0.3d0], at_weight=[0.7d0], &
                weight=weight_found)
            call show('weight', weight_found)
        end block
        call begin('most_influential')
        block
            integer(c_int32_t), allocatable :: indices_found(:)
            real(c_double), allocatable :: influences_found(:)
            allocate (indices_found(3))
            allocate (influences_found(3))
            call most_influential(g=surface, params=reshape([0.1d0, 0.9d0, 0.3d0, 0.7d0, 0.2d0, 0.6d0], [3, 2], &
                order=[2, 1]), indices=indices_found, influences=influences_found)
            call show('indices', indices_found - 1)
            call show('influences', influences_found)
        end block
        call begin('blossom')
        block
            real(c_double), allocatable :: values_found(:)
            allocate (values_found(3))
            call spline_blossom(g=curve, params=[0.1d0], args=[0.3d0, 0.6d0], values=values_found, flags=0)
            call show('values', values_found)
        end block
        call begin('collocation')
        block
            real(c_double), allocatable :: values_found(:)
            integer(c_int64_t), allocatable :: columns_found(:)
            integer(c_int64_t), allocatable :: row_pointers_found(:)
            call collocation(degrees=[2, 1], counts=[3, 4], knots=[0.0d0, 0.0d0, 0.0d0, 1.0d0, 1.0d0, 1.0d0, 0.0d0, &
                0.0d0, 1.0d0, 2.0d0, 3.0d0, 3.0d0], params=reshape([0.1d0, 0.9d0, 0.3d0, 0.7d0, 0.2d0, 0.6d0], [3, 2], &
                order=[2, 1]), values=values_found, columns=columns_found, row_pointers=row_pointers_found, flags=0)
            call show('values', values_found)
            call show('columns', columns_found - 1)
            call show('row_pointers', row_pointers_found - 1)
        end block
        call begin('collocation of derivatives')
        block
            real(c_double), allocatable :: values_found(:)
            integer(c_int64_t), allocatable :: columns_found(:)
            integer(c_int64_t), allocatable :: row_pointers_found(:)
            call collocation(degrees=[2, 1], counts=[3, 4], knots=[0.0d0, 0.0d0, 0.0d0, 1.0d0, 1.0d0, 1.0d0, 0.0d0, &
                0.0d0, 1.0d0, 2.0d0, 3.0d0, 3.0d0], params=reshape([0.1d0, 0.9d0, 0.3d0, 0.7d0, 0.2d0, 0.6d0], [3, 2], &
                order=[2, 1]), values=values_found, columns=columns_found, row_pointers=row_pointers_found, orders=[1, &
                0], flags=0)
            call show('values', values_found)
            call show('columns', columns_found - 1)
            call show('row_pointers', row_pointers_found - 1)
        end block
        call begin('eval_adjoint')
        block
            real(c_double), allocatable :: grad_points_found(:, :)
            real(c_double), allocatable :: grad_weights_found(:)
            real(c_double), allocatable :: grad_params_found(:, :)
            allocate (grad_points_found(9, 2))
            grad_points_found = 0
            allocate (grad_weights_found(9))
            grad_weights_found = 0
            allocate (grad_params_found(6, 1))
            grad_params_found = 0
            call curve%eval_adjoint(order=0, params=reshape([0.1d0, 0.9d0, 0.3d0, 0.7d0, 0.2d0, 0.6d0], [6, 1], &
                order=[2, 1]), cotangents=reshape([1.0d0, 2.0d0, 3.0d0, 0.0d0, 0.0d0, 0.0d0, 0.0d0, 0.0d0, 0.0d0, &
                0.0d0, 0.0d0, 0.0d0], [6, 2, 1], order=[2, 3, 1]), grad_points=grad_points_found, &
                grad_weights=grad_weights_found, grad_params=grad_params_found, flags=0)
            call show('grad_points', flat(reshape(grad_points_found, [size(grad_points_found, 2), &
                size(grad_points_found, 1)], order=[2, 1])))
            call show('grad_weights', grad_weights_found)
            call show('grad_params', flat(reshape(grad_params_found, [size(grad_params_found, 2), &
                size(grad_params_found, 1)], order=[2, 1])))
        end block
        call begin('eval_adjoint points')
        block
            real(c_double), allocatable :: grad_points_found(:, :)
            real(c_double), allocatable :: grad_weights_found(:)
            real(c_double), allocatable :: grad_params_found(:, :)
            allocate (grad_points_found(12, 3))
            grad_points_found = 0
            allocate (grad_weights_found(12))
            grad_weights_found = 0
            allocate (grad_params_found(3, 2))
            grad_params_found = 0
            call surface%eval_adjoint(order=1, params=reshape([0.1d0, 0.9d0, 0.3d0, 0.7d0, 0.2d0, 0.6d0], [3, 2], &
                order=[2, 1]), cotangents=reshape([1.0d0, 2.0d0, 3.0d0, 0.0d0, 0.0d0, 0.0d0, 0.0d0, 0.0d0, 0.0d0, &
                0.0d0, 0.0d0, 0.0d0, 0.0d0, 0.0d0, 0.0d0, 0.0d0, 0.0d0, 0.0d0, 0.0d0, 0.0d0, 0.0d0, 0.0d0, 0.0d0, &
                0.0d0, 0.0d0, 0.0d0, 0.0d0], [3, 3, 3], order=[2, 3, 1]), grad_points=grad_points_found, &
                grad_weights=grad_weights_found, grad_params=grad_params_found, flags=0)
            call show('grad_points', flat(reshape(grad_points_found, [size(grad_points_found, 2), &
                size(grad_points_found, 1)], order=[2, 1])))
            call show('grad_weights', grad_weights_found)
            call show('grad_params', flat(reshape(grad_params_found, [size(grad_params_found, 2), &
                size(grad_params_found, 1)], order=[2, 1])))
        end block
        call begin('eval_adjoint_knots')
        block
            real(c_double), allocatable :: grad_knots_found(:)
            allocate (grad_knots_found(12))
            grad_knots_found = 0
            call curve%eval_adjoint_knots(axis=1, order=0, params=reshape([0.1d0, 0.9d0, 0.3d0, 0.7d0, 0.2d0, 0.6d0], &
                [6, 1], order=[2, 1]), cotangents=reshape([1.0d0, 2.0d0, 3.0d0, 0.0d0, 0.0d0, 0.0d0, 0.0d0, 0.0d0, &
                0.0d0, 0.0d0, 0.0d0, 0.0d0], [6, 2, 1], order=[2, 3, 1]), grad_knots=grad_knots_found, flags=0)
            call show('grad_knots', grad_knots_found)
        end block
        call begin('eval_adjoint_knots surface')
        block
            real(c_double), allocatable :: grad_knots_found(:)
            allocate (grad_knots_found(6))
            grad_knots_found = 0
            call surface%eval_adjoint_knots(axis=2, order=1, params=reshape([0.1d0, 0.9d0, 0.3d0, 0.7d0, 0.2d0, &
                0.6d0], [3, 2], order=[2, 1]), cotangents=reshape([1.0d0, 2.0d0, 3.0d0, 0.0d0, 0.0d0, 0.0d0, 0.0d0, &
                0.0d0, 0.0d0, 0.0d0, 0.0d0, 0.0d0, 0.0d0, 0.0d0, 0.0d0, 0.0d0, 0.0d0, 0.0d0, 0.0d0, 0.0d0, 0.0d0, &
                0.0d0, 0.0d0, 0.0d0, 0.0d0, 0.0d0, 0.0d0], [3, 3, 3], order=[2, 3, 1]), grad_knots=grad_knots_found, &
                flags=0)
            call show('grad_knots', grad_knots_found)
        end block
    end subroutine calls_of_evaluation

    subroutine calls_of_form()
        call begin('iso curve')
        block
            type(nurbs_spline) :: out_found
            call surface%iso(axis=1, param=0.3d0, out=out_found, flags=0)
            call show('out', out_found)
        end block
        call begin('iso surface')
        block
            type(nurbs_spline) :: out_found
            call volume%iso(axis=2, param=0.3d0, out=out_found, flags=0)
            call show('out', out_found)
        end block
        call begin('insert_knot')
        block
            type(nurbs_spline) :: out_found
            call curve%insert_knot(axis=1, knot=0.3d0, times=2, out=out_found)
            call show('out', out_found)
        end block
        call begin('insert_knot periodic')
        block
            type(nurbs_spline) :: out_found
            call loop%insert_knot(axis=1, knot=2.5d0, times=2, out=out_found)
            call show('out', out_found)
        end block
        call begin('insert_knot surface')
        block
            type(nurbs_spline) :: out_found
            call surface%insert_knot(axis=2, knot=1.5d0, times=1, out=out_found)
            call show('out', out_found)
        end block
        call begin('insert_knot 0 times')
        block
            type(nurbs_spline) :: out_found
            call surface%insert_knot(axis=2, knot=1.5d0, times=0, out=out_found)
            call show('out', out_found)
        end block
        call begin('refine')
        block
            type(nurbs_spline) :: out_found
            call curve%refine(axis=1, knots=[0.3d0, 0.6d0], out=out_found)
            call show('out', out_found)
        end block
        call begin('refine_uniform')
        block
            type(nurbs_spline) :: out_found
            call loop%refine_uniform(axis=1, parts=3, out=out_found)
            call show('out', out_found)
        end block
        call begin('extract')
        block
            type(nurbs_spline) :: out_found
            call curve%extract(lower=[0.3d0], upper=[0.6d0], out=out_found)
            call show('out', out_found)
        end block
        call begin('split')
        block
            type(nurbs_spline) :: lower_found
            type(nurbs_spline) :: upper_found
            call curve%split(axis=1, param=0.3d0, lower=lower_found, upper=upper_found)
            call show('lower', lower_found)
            call show('upper', upper_found)
        end block
        call begin('clamp_ends')
        block
            type(nurbs_spline) :: out_found
            call loop%clamp(axis=1, out=out_found, flags=3)
            call show('out', out_found)
        end block
        call begin('unclamp')
        block
            type(nurbs_spline) :: out_found
            call unclamp_spline(spline=volume, axis=3, out=out_found, flags=3)
            call show('out', out_found)
        end block
        call begin('move_seam')
        block
            type(nurbs_spline) :: out_found
            call loop%move_seam(axis=1, param=2.5d0, out=out_found)
            call show('out', out_found)
        end block
        call begin('join')
        block
            type(nurbs_spline) :: parts_given(2)
            real(c_double) :: gap_found
            type(nurbs_spline) :: found
            parts_given(1) = curve
            parts_given(2) = curve
            call found%join(parts=parts_given, axis=1, tolerance=9.0d0, flags=0, gap=gap_found)
            call show('gap', gap_found)
            call show('out', found)
        end block
        call begin('join with gaps')
        block
            type(nurbs_spline) :: parts_given(2)
            real(c_double) :: gap_found
            type(nurbs_spline) :: found
            parts_given(1) = curve
            parts_given(2) = curve
            call found%join(parts=parts_given, axis=1, tolerance=9.0d0, flags=67108864, gap=gap_found)
            call show('gap', gap_found)
            call show('out', found)
        end block
        call begin('snap_knots')
        block
            type(nurbs_spline) :: out_found
            real(c_double) :: deviation_found
            call snap_spline_knots(spline=loop, axis=1, tolerance=0.26d0, out=out_found, deviation=deviation_found)
            call show('out', out_found)
            call show('deviation', deviation_found)
        end block
        call begin('extend')
        block
            type(nurbs_spline) :: out_found
            call extend_spline(spline=surface, axis=1, end=0, amount=1.0d0, order=1, out=out_found)
            call show('out', out_found)
        end block
        call begin('make_periodic')
        block
            type(nurbs_spline) :: out_found
            real(c_double) :: deviation_found
            integer(c_int32_t) :: order_found
            call make_spline_periodic(spline=curve, axis=1, tolerance=1.0d0, out=out_found, deviation=deviation_found, &
                order=order_found)
            call show('out', out_found)
            call show('deviation', deviation_found)
            call show('order', order_found)
        end block
        call begin('make_compatible')
        block
            type(nurbs_spline) :: splines_given(2)
            type(nurbs_list) :: list_found
            real(c_double) :: deviation_found
            splines_given(1) = curve
            splines_given(2) = loop
            call make_splines_compatible(splines=splines_given, list=list_found, tolerance=0.01d0, flags=1073741824, &
                deviation=deviation_found)
            call show('out', list_found)
            call show('deviation', deviation_found)
        end block
        call begin('remove_knot')
        block
            type(nurbs_spline) :: out_found
            integer(c_int32_t) :: removed_found
            real(c_double) :: bound_found
            call remove_knot(g=curve, axis=1, knot=0.5d0, times=1, tolerance=9.0d0, out=out_found, &
                removed=removed_found, bound=bound_found)
            call show('out', out_found)
            call show('removed', removed_found)
            call show('bound', bound_found)
        end block
        call begin('remove_knot periodic')
        block
            type(nurbs_spline) :: out_found
            integer(c_int32_t) :: removed_found
            real(c_double) :: bound_found
            call remove_knot(g=loop, axis=1, knot=3.0d0, times=1, tolerance=9.0d0, out=out_found, &
                removed=removed_found, bound=bound_found)
            call show('out', out_found)
            call show('removed', removed_found)
            call show('bound', bound_found)
        end block
        call begin('reduce_knots')
        block
            type(nurbs_spline) :: out_found
            real(c_double) :: bound_found
            call reduce_knots(g=curve, axis=0, tolerance=9.0d0, out=out_found, bound=bound_found)
            call show('out', out_found)
            call show('bound', bound_found)
        end block
        call begin('reduce_degree')
        block
            type(nurbs_spline) :: out_found
            real(c_double) :: bound_found
            call reduce_degree(g=loop, axis=1, times=1, out=out_found, bound=bound_found)
            call show('out', out_found)
            call show('bound', bound_found)
        end block
        call begin('simplify')
        block
            type(nurbs_spline) :: out_found
            real(c_double) :: bound_found
            call simplify(g=curve, tolerance=9.0d0, out=out_found, bound=bound_found)
            call show('out', out_found)
            call show('bound', bound_found)
        end block
        call begin('elevate')
        block
            type(nurbs_spline) :: out_found
            call curve%elevate(axis=1, times=2, out=out_found)
            call show('out', out_found)
        end block
        call begin('elevate periodic')
        block
            type(nurbs_spline) :: out_found
            call loop%elevate(axis=1, times=2, out=out_found)
            call show('out', out_found)
        end block
        call begin('elevate homogeneous')
        block
            type(nurbs_spline) :: out_found
            call homogeneous%elevate(axis=1, times=1, out=out_found)
            call show('out', out_found)
        end block
        call begin('reverse')
        block
            type(nurbs_spline) :: out_found
            call curve%reverse(axis=1, out=out_found, flags=33554432)
            call show('out', out_found)
        end block
        call begin('transpose')
        block
            type(nurbs_spline) :: out_found
            call volume%transpose_axes(permutation=[3, 1, 2], out=out_found)
            call show('out', out_found)
        end block
        call begin('reparametrize')
        block
            type(nurbs_spline) :: out_found
            call loop%reparametrize(axis=1, lower=0.0d0, upper=1.0d0, out=out_found)
            call show('out', out_found)
        end block
        call begin('reparametrize_moebius')
        block
            type(nurbs_spline) :: out_found
            call reparametrize_moebius(g=curve, axis=1, ratio=2.0d0, out=out_found)
            call show('out', out_found)
        end block
        call begin('derivative')
        block
            type(nurbs_spline) :: out_found
            call spline_derivative(g=loop, axis=1, order=1, out=out_found)
            call show('out', out_found)
        end block
        call begin('derivative rational')
        block
            type(nurbs_spline) :: out_found
            call spline_derivative(g=curve, axis=1, order=2, out=out_found)
            call show('out', out_found)
        end block
        call begin('derivative beyond the degree')
        block
            type(nurbs_spline) :: out_found
            call spline_derivative(g=loop, axis=1, order=9, out=out_found)
            call show('out', out_found)
        end block
        call begin('antiderivative')
        block
            type(nurbs_spline) :: out_found
            call spline_antiderivative(g=volume, axis=2, out=out_found)
            call show('out', out_found)
        end block
        call begin('product')
        block
            type(nurbs_spline) :: out_found
            call spline_product(a=curve, b=curve, out=out_found, flags=0)
            call show('out', out_found)
        end block
        call begin('product periodic')
        block
            type(nurbs_spline) :: out_found
            call spline_product(a=loop, b=loop, out=out_found, flags=0)
            call show('out', out_found)
        end block
        call begin('product volume')
        block
            type(nurbs_spline) :: out_found
            call spline_product(a=volume, b=volume, out=out_found, flags=134217728)
            call show('out', out_found)
        end block
        call begin('compose')
        block
            type(nurbs_spline) :: ramp
            type(nurbs_spline) :: out_found
            call ramp%create_bezier(degrees=[2], points=reshape([0.0d0, 0.25d0, 1.0d0], [3, 1], order=[2, 1]))
            call spline_compose(g=curve, f=ramp, out=out_found)
            call show('out', out_found)
        end block
        call begin('compose around a loop')
        block
            type(nurbs_spline) :: round
            type(nurbs_spline) :: out_found
            call round%create_bezier(degrees=[2], points=reshape([0.0d0, 2.0d0, 9.0d0], [3, 1], order=[2, 1]))
            call spline_compose(g=loop, f=round, out=out_found)
            call show('out', out_found)
        end block
        call begin('compose on a surface')
        block
            type(nurbs_spline) :: diagonal
            type(nurbs_spline) :: out_found
            call diagonal%create_bezier(degrees=[2], points=reshape([0.0d0, 0.0d0, 1.0d0, 0.0d0, 1.0d0, 1.0d0], [3, &
                2], order=[2, 1]))
            call spline_compose(g=surface, f=diagonal, out=out_found)
            call show('out', out_found)
        end block
        call begin('sum')
        block
            type(nurbs_spline) :: out_found
            call spline_sum(a=loop, alpha=1.0d0, b=loop, beta=2.0d0, out=out_found)
            call show('out', out_found)
        end block
        call begin('sum rational')
        block
            type(nurbs_spline) :: half
            type(nurbs_spline) :: out_found
            call reparametrize_moebius(g=curve, axis=1, ratio=2.0d0, out=half)
            call spline_sum(a=curve, alpha=1.0d0, b=half, beta=1.0d0, out=out_found)
            call show('out', out_found)
        end block
        call begin('reduce_knots_with')
        block
            type(nurbs_spline) :: out_found
            real(c_double) :: bound_found
            type(nurbs_call) :: watching
            call reduce_knots(g=curve, axis=0, tolerance=9.0d0, out=out_found, bound=bound_found, call=watching)
            call show('out', out_found)
            call show('bound', bound_found)
        end block
        call begin('reduce_degree_with')
        block
            type(nurbs_spline) :: out_found
            real(c_double) :: bound_found
            type(nurbs_call) :: watching
            call reduce_degree(g=loop, axis=1, times=1, out=out_found, bound=bound_found, call=watching)
            call show('out', out_found)
            call show('bound', bound_found)
        end block
        call begin('simplify_with')
        block
            type(nurbs_spline) :: out_found
            real(c_double) :: bound_found
            type(nurbs_call) :: watching
            call simplify(g=curve, tolerance=9.0d0, out=out_found, bound=bound_found, call=watching)
            call show('out', out_found)
            call show('bound', bound_found)
        end block
        call begin('product_with')
        block
            type(nurbs_spline) :: out_found
            type(nurbs_call) :: watching
            call spline_product(a=curve, b=curve, out=out_found, flags=0, call=watching)
            call show('out', out_found)
        end block
        call begin('product_with periodic')
        block
            type(nurbs_spline) :: out_found
            type(nurbs_call) :: watching
            call spline_product(a=loop, b=loop, out=out_found, flags=0, call=watching)
            call show('out', out_found)
        end block
        call begin('product_with volume')
        block
            type(nurbs_spline) :: out_found
            type(nurbs_call) :: watching
            call spline_product(a=volume, b=volume, out=out_found, flags=134217728, call=watching)
            call show('out', out_found)
        end block
        call begin('compose_with')
        block
            type(nurbs_spline) :: ramp
            type(nurbs_spline) :: out_found
            type(nurbs_call) :: watching
            call ramp%create_bezier(degrees=[2], points=reshape([0.0d0, 0.25d0, 1.0d0], [3, 1], order=[2, 1]))
            call spline_compose(g=curve, f=ramp, out=out_found, call=watching)
            call show('out', out_found)
        end block
        call begin('compose_with around a loop')
        block
            type(nurbs_spline) :: round
            type(nurbs_spline) :: out_found
            type(nurbs_call) :: watching
            call round%create_bezier(degrees=[2], points=reshape([0.0d0, 2.0d0, 9.0d0], [3, 1], order=[2, 1]))
            call spline_compose(g=loop, f=round, out=out_found, call=watching)
            call show('out', out_found)
        end block
        call begin('compose_with on a surface')
        block
            type(nurbs_spline) :: diagonal
            type(nurbs_spline) :: out_found
            type(nurbs_call) :: watching
            call diagonal%create_bezier(degrees=[2], points=reshape([0.0d0, 0.0d0, 1.0d0, 0.0d0, 1.0d0, 1.0d0], [3, &
                2], order=[2, 1]))
            call spline_compose(g=surface, f=diagonal, out=out_found, call=watching)
            call show('out', out_found)
        end block
    end subroutine calls_of_form

    subroutine calls_of_query()
        call begin('deviation')
        block
            real(c_double) :: at_least_found
            real(c_double) :: at_most_found
            call deviation(f=surface, g=surface, at_least=at_least_found, at_most=at_most_found)
            call show('at_least', at_least_found)
            call show('at_most', at_most_found)
        end block
        call begin('curve_shape_factor')
        block
            real(c_double) :: factor_found
            integer(c_int32_t) :: kind_of_conic_found
            call shape_factor(g=segment, factor=factor_found, kind_of_conic=kind_of_conic_found)
            call show('factor', factor_found)
            call show('type', kind_of_conic_found)
        end block
        call begin('conic_axes')
        block
            integer(c_int32_t) :: kind_of_conic_found
            real(c_double), allocatable :: origin_found(:)
            real(c_double), allocatable :: x_found(:)
            real(c_double), allocatable :: sizes_found(:)
            allocate (origin_found(2))
            allocate (x_found(2))
            allocate (sizes_found(2))
            call conic_axes(coefficients=[1.0d0, 0.0d0, 4.0d0, 0.0d0, 0.0d0, -4.0d0], &
                kind_of_conic=kind_of_conic_found, origin=origin_found, x=x_found, sizes=sizes_found)
            call show('type', kind_of_conic_found)
            call show('origin', origin_found)
            call show('x', x_found)
            call show('sizes', sizes_found)
        end block
        call begin('box')
        block
            real(c_double), allocatable :: lower_found(:)
            real(c_double), allocatable :: upper_found(:)
            real(c_double) :: gap_found
            allocate (lower_found(4))
            allocate (upper_found(4))
            call bounding_box(g=volume, tolerance=0.001d0, lower=lower_found, upper=upper_found, gap=gap_found)
            call show('lower', lower_found)
            call show('upper', upper_found)
            call show('gap', gap_found)
        end block
        call begin('box of a part')
        block
            real(c_double), allocatable :: lower_found(:)
            real(c_double), allocatable :: upper_found(:)
            real(c_double) :: gap_found
            allocate (lower_found(3))
            allocate (upper_found(3))
            call bounding_box(g=surface, tolerance=0.001d0, lower=lower_found, upper=upper_found, gap=gap_found, &
                range=reshape([0.0d0, 1.0d0, 0.0d0, 3.0d0], [2, 2]))
            call show('lower', lower_found)
            call show('upper', upper_found)
            call show('gap', gap_found)
        end block
        call begin('oriented_box')
        block
            real(c_double), allocatable :: center_found(:)
            real(c_double), allocatable :: axes_found(:, :)
            real(c_double), allocatable :: half_found(:)
            allocate (center_found(3))
            allocate (axes_found(3, 3))
            allocate (half_found(3))
            call oriented_box(g=surface, tolerance=0.001d0, center=center_found, axes=axes_found, half=half_found)
            call show('center', center_found)
            call show('axes', flat(axes_found))
            call show('half', half_found)
        end block
        call begin('tangent_cone')
        block
            real(c_double), allocatable :: direction_found(:)
            real(c_double) :: angle_found
            allocate (direction_found(2))
            call tangent_cone(g=segment, axis=1, tolerance=0.1d0, direction=direction_found, angle=angle_found)
            call show('direction', direction_found)
            call show('angle', angle_found)
        end block
        call begin('tangent_cone of a part')
        block
            real(c_double), allocatable :: direction_found(:)
            real(c_double) :: angle_found
            allocate (direction_found(2))
            call tangent_cone(g=curve, axis=1, tolerance=0.1d0, direction=direction_found, angle=angle_found, &
                range=reshape([0.3d0, 0.6d0], [2, 1]))
            call show('direction', direction_found)
            call show('angle', angle_found)
        end block
        call begin('normal_cone')
        block
            real(c_double), allocatable :: direction_found(:)
            real(c_double) :: angle_found
            allocate (direction_found(3))
            call normal_cone(g=surface, tolerance=0.1d0, direction=direction_found, angle=angle_found)
            call show('direction', direction_found)
            call show('angle', angle_found)
        end block
        call begin('normal_cone of a part')
        block
            real(c_double), allocatable :: direction_found(:)
            real(c_double) :: angle_found
            allocate (direction_found(3))
            call normal_cone(g=surface, tolerance=0.1d0, direction=direction_found, angle=angle_found, &
                range=reshape([0.0d0, 1.0d0, 0.0d0, 3.0d0], [2, 2]))
            call show('direction', direction_found)
            call show('angle', angle_found)
        end block
        call begin('extreme_point')
        block
            real(c_double), allocatable :: params_found(:)
            real(c_double) :: value_found
            real(c_double) :: bound_found
            allocate (params_found(1))
            call extreme_point(g=curve, direction=[0.1d0, 0.9d0], tolerance=1d-06, params=params_found, &
                value=value_found, bound=bound_found)
            call show('params', params_found)
            call show('value', value_found)
            call show('bound', bound_found)
        end block
        call begin('extreme_point of a part')
        block
            real(c_double), allocatable :: params_found(:)
            real(c_double) :: value_found
            real(c_double) :: bound_found
            allocate (params_found(1))
            call extreme_point(g=curve, direction=[0.1d0, 0.9d0], tolerance=1d-06, params=params_found, &
                value=value_found, bound=bound_found, range=reshape([0.3d0, 0.6d0], [2, 1]))
            call show('params', params_found)
            call show('value', value_found)
            call show('bound', bound_found)
        end block
        call begin('closest_points')
        block
            real(c_double), allocatable :: params_found(:, :)
            real(c_double), allocatable :: feet_found(:, :)
            real(c_double), allocatable :: distances_found(:)
            integer(c_int32_t), allocatable :: states_found(:)
            allocate (params_found(1, 1))
            allocate (feet_found(1, 2))
            allocate (distances_found(1))
            allocate (states_found(1))
            call closest_points(g=curve, points=reshape([0.1d0, 0.9d0], [1, 2], order=[2, 1]), params=params_found, &
                feet=feet_found, distances=distances_found, states=states_found, tolerance=0.0d0, budget=0, flags=0)
            call show('params', flat(reshape(params_found, [size(params_found, 2), size(params_found, 1)], order=[2, &
                1])))
            call show('feet', flat(reshape(feet_found, [size(feet_found, 2), size(feet_found, 1)], order=[2, 1])))
            call show('distances', distances_found)
            call show('status', states_found)
        end block
        call begin('closest_adjoint')
        block
            real(c_double), allocatable :: grad_points_found(:, :)
            real(c_double), allocatable :: grad_weights_found(:)
            real(c_double), allocatable :: grad_queries_found(:, :)
            integer(c_int32_t), allocatable :: states_found(:)
            allocate (grad_points_found(9, 2))
            allocate (grad_weights_found(9))
            allocate (grad_queries_found(1, 2))
            allocate (states_found(1))
            call curve%closest_adjoint(points=reshape([0.1d0, 0.9d0], [1, 2], order=[2, 1]), &
                params=reshape([0.3d0], [1, 1], order=[2, 1]), &
                param_cotangents=reshape([1.0d0], [1, 1], order=[2, 1]), &
                foot_cotangents=reshape([1.0d0, 2.0d0], [1, 2], order=[2, 1]), distance_cotangents=[1.0d0], &
                grad_points=grad_points_found, grad_weights=grad_weights_found, grad_queries=grad_queries_found, &
                states=states_found, flags=0)
            call show('grad_points', flat(reshape(grad_points_found, [size(grad_points_found, 2), &
                size(grad_points_found, 1)], order=[2, 1])))
            call show('grad_weights', grad_weights_found)
            call show('grad_queries', flat(reshape(grad_queries_found, [size(grad_queries_found, 2), &
                size(grad_queries_found, 1)], order=[2, 1])))
            call show('status', states_found)
        end block
        call begin('closest_points of a part')
        block
            real(c_double), allocatable :: params_found(:, :)
            real(c_double), allocatable :: feet_found(:, :)
            real(c_double), allocatable :: distances_found(:)
            integer(c_int32_t), allocatable :: states_found(:)
            allocate (params_found(2, 2))
            allocate (feet_found(2, 3))
            allocate (distances_found(2))
            allocate (states_found(2))
            call closest_points(g=surface, points=reshape([0.1d0, 0.9d0, 0.3d0, 0.7d0, 0.2d0, 0.6d0], [2, 3], &
                order=[2, 1]), params=params_found, feet=feet_found, distances=distances_found, states=states_found, &
                range=reshape([0.0d0, 1.0d0, 0.0d0, 3.0d0], [2, 2]), tolerance=0.0d0, budget=0, flags=0)
            call show('params', flat(reshape(params_found, [size(params_found, 2), size(params_found, 1)], order=[2, &
                1])))
            call show('feet', flat(reshape(feet_found, [size(feet_found, 2), size(feet_found, 1)], order=[2, 1])))
            call show('distances', distances_found)
            call show('status', states_found)
        end block
        call begin('farthest_points')
        block
            real(c_double), allocatable :: params_found(:, :)
            real(c_double), allocatable :: feet_found(:, :)
            real(c_double), allocatable :: distances_found(:)
            integer(c_int32_t), allocatable :: states_found(:)
            allocate (params_found(1, 1))
            allocate (feet_found(1, 2))
            allocate (distances_found(1))
            allocate (states_found(1))
            call farthest_points(g=curve, points=reshape([0.1d0, 0.9d0], [1, 2], order=[2, 1]), params=params_found, &
                feet=feet_found, distances=distances_found, states=states_found, tolerance=0.0d0, budget=0, flags=0)
            call show('params', flat(reshape(params_found, [size(params_found, 2), size(params_found, 1)], order=[2, &
                1])))
            call show('feet', flat(reshape(feet_found, [size(feet_found, 2), size(feet_found, 1)], order=[2, 1])))
            call show('distances', distances_found)
            call show('status', states_found)
        end block
        call begin('farthest_points of a part')
        block
            real(c_double), allocatable :: params_found(:, :)
            real(c_double), allocatable :: feet_found(:, :)
            real(c_double), allocatable :: distances_found(:)
            integer(c_int32_t), allocatable :: states_found(:)
            allocate (params_found(3, 1))
            allocate (feet_found(3, 2))
            allocate (distances_found(3))
            allocate (states_found(3))
            call farthest_points(g=curve, points=reshape([0.1d0, 0.9d0, 0.3d0, 0.7d0, 0.2d0, 0.6d0], [3, 2], order=[2, &
                1]), params=params_found, feet=feet_found, distances=distances_found, states=states_found, &
                range=reshape([0.3d0, 0.6d0], [2, 1]), tolerance=0.0d0, budget=0, flags=0)
            call show('params', flat(reshape(params_found, [size(params_found, 2), size(params_found, 1)], order=[2, &
                1])))
            call show('feet', flat(reshape(feet_found, [size(feet_found, 2), size(feet_found, 1)], order=[2, 1])))
            call show('distances', distances_found)
            call show('status', states_found)
        end block
        call begin('closest_local')
        block
            real(c_double), allocatable :: params_found(:, :)
            real(c_double), allocatable :: feet_found(:, :)
            real(c_double), allocatable :: distances_found(:)
            integer(c_int32_t), allocatable :: states_found(:)
            allocate (params_found(3, 1))
            allocate (feet_found(3, 2))
            allocate (distances_found(3))
            allocate (states_found(3))
            call closest_local(g=curve, points=reshape([0.1d0, 0.9d0, 0.3d0, 0.7d0, 0.2d0, 0.6d0], [3, 2], order=[2, &
                1]), guesses=reshape([0.1d0, 0.9d0, 0.3d0], [3, 1], order=[2, 1]), params=params_found, &
                feet=feet_found, distances=distances_found, states=states_found, flags=0)
            call show('params', flat(reshape(params_found, [size(params_found, 2), size(params_found, 1)], order=[2, &
                1])))
            call show('feet', flat(reshape(feet_found, [size(feet_found, 2), size(feet_found, 1)], order=[2, 1])))
            call show('distances', distances_found)
            call show('status', states_found)
        end block
        call begin('closest_local params')
        block
            real(c_double), allocatable :: params_found(:, :)
            allocate (params_found(1, 1))
            call closest_local(g=curve, points=reshape([0.1d0, 0.9d0], [1, 2], order=[2, 1]), &
                guesses=reshape([0.1d0], [1, 1], order=[2, 1]), params=params_found, flags=0)
            call show('params', flat(reshape(params_found, [size(params_found, 2), size(params_found, 1)], order=[2, &
                1])))
        end block
        call begin('curve_signed_distances')
        block
            real(c_double), allocatable :: distances_found(:)
            real(c_double), allocatable :: params_found(:)
            integer(c_int32_t), allocatable :: states_found(:)
            allocate (distances_found(3))
            allocate (params_found(3))
            allocate (states_found(3))
            call signed_distances(g=curve, points=reshape([0.1d0, 0.9d0, 0.3d0, 0.7d0, 0.2d0, 0.6d0], [3, 2], &
                order=[2, 1]), distances=distances_found, params=params_found, states=states_found, tolerance=0.0d0, &
                budget=0, flags=0)
            call show('distances', distances_found)
            call show('params', params_found)
            call show('status', states_found)
        end block
        call begin('curve_signed_distances alone')
        block
            real(c_double), allocatable :: distances_found(:)
            allocate (distances_found(1))
            call signed_distances(g=curve, points=reshape([0.1d0, 0.9d0], [1, 2], order=[2, 1]), &
                distances=distances_found, tolerance=0.0d0, budget=0, flags=0)
            call show('distances', distances_found)
        end block
        call begin('closest_all')
        block
            real(c_double), allocatable :: params_found(:, :)
            real(c_double), allocatable :: distances_found(:)
            integer(c_int32_t) :: state_found
            call closest_all(g=curve, point=[0.1d0, 0.9d0], params=params_found, distances=distances_found, &
                state=state_found, tolerance=0.0d0, budget=0)
            call show('params', flat(reshape(params_found, [size(params_found, 2), size(params_found, 1)], order=[2, &
                1])))
            call show('distances', distances_found)
            call show('status', state_found)
        end block
        call begin('closest_all inside')
        block
            real(c_double), allocatable :: params_found(:, :)
            real(c_double), allocatable :: distances_found(:)
            integer(c_int32_t) :: state_found
            call closest_all(g=curve, point=[0.1d0, 0.9d0], params=params_found, distances=distances_found, &
                state=state_found, range=reshape([0.0d0, 1.0d0], [2, 1]), tolerance=0.0d0, budget=0)
            call show('params', flat(reshape(params_found, [size(params_found, 2), size(params_found, 1)], order=[2, &
                1])))
            call show('distances', distances_found)
            call show('status', state_found)
        end block
        call begin('critical_points')
        block
            real(c_double), allocatable :: params_found(:, :)
            real(c_double), allocatable :: distances_found(:)
            integer(c_int32_t), allocatable :: kinds_found(:)
            integer(c_int32_t) :: state_found
            call critical_points(g=curve, point=[0.1d0, 0.9d0], params=params_found, distances=distances_found, &
                kinds=kinds_found, state=state_found, tolerance=0.0d0, budget=0)
            call show('params', flat(reshape(params_found, [size(params_found, 2), size(params_found, 1)], order=[2, &
                1])))
            call show('distances', distances_found)
            call show('kinds', kinds_found)
            call show('status', state_found)
        end block
        call begin('critical_points inside')
        block
            real(c_double), allocatable :: params_found(:, :)
            real(c_double), allocatable :: distances_found(:)
            integer(c_int32_t), allocatable :: kinds_found(:)
            integer(c_int32_t) :: state_found
            call critical_points(g=curve, point=[0.1d0, 0.9d0], params=params_found, distances=distances_found, &
                kinds=kinds_found, state=state_found, range=reshape([0.0d0, 1.0d0], [2, 1]), tolerance=0.0d0, budget=0)
            call show('params', flat(reshape(params_found, [size(params_found, 2), size(params_found, 1)], order=[2, &
                1])))
            call show('distances', distances_found)
            call show('kinds', kinds_found)
            call show('status', state_found)
        end block
        call begin('distance')
        block
            real(c_double) :: at_least_found
            real(c_double) :: at_most_found
            real(c_double), allocatable :: params_a_found(:)
            real(c_double), allocatable :: params_b_found(:)
            integer(c_int32_t) :: state_found
            allocate (params_a_found(1))
            allocate (params_b_found(1))
            call spline_distance(a=curve, b=loop, tolerance=1d-06, at_least=at_least_found, at_most=at_most_found, &
                params_a=params_a_found, params_b=params_b_found, state=state_found, budget=0)
            call show('at_least', at_least_found)
            call show('at_most', at_most_found)
            call show('params_a', params_a_found)
            call show('params_b', params_b_found)
            call show('status', state_found)
        end block
        call begin('hausdorff_distance')
        block
            real(c_double), allocatable :: at_least_found(:)
            real(c_double), allocatable :: at_most_found(:)
            real(c_double), allocatable :: params_a_found(:)
            real(c_double), allocatable :: params_b_found(:)
            integer(c_int32_t) :: state_found
            allocate (at_least_found(2))
            allocate (at_most_found(2))
            allocate (params_a_found(1))
            allocate (params_b_found(1))
            call hausdorff_distance(a=curve, b=loop, tolerance=0.1d0, at_least=at_least_found, at_most=at_most_found, &
                params_a=params_a_found, params_b=params_b_found, state=state_found, budget=0)
            call show('at_least', at_least_found)
            call show('at_most', at_most_found)
            call show('params_a', params_a_found)
            call show('params_b', params_b_found)
            call show('status', state_found)
        end block
        call begin('curve_features count')
        block
            real(c_double), allocatable :: params_found(:)
            integer(c_int32_t), allocatable :: found_found(:)
            real(c_double), allocatable :: values_found(:)
            logical :: complete_found
            call curve_features(g=twist, kinds=127, params=params_found, found=found_found, values=values_found, &
                complete=complete_found)
            call show('params', params_found)
            call show('found', found_found)
            call show('values', values_found)
            call show('complete', complete_found)
        end block
        call begin('curve_features periodic')
        block
            real(c_double), allocatable :: params_found(:)
            integer(c_int32_t), allocatable :: found_found(:)
            real(c_double), allocatable :: values_found(:)
            logical :: complete_found
            call curve_features(g=loop, kinds=63, params=params_found, found=found_found, values=values_found, &
                complete=complete_found)
            call show('params', params_found)
            call show('found', found_found)
            call show('values', values_found)
            call show('complete', complete_found)
        end block
        call begin('extrema')
        block
            type(nurbs_spline) :: heights
            real(c_double), allocatable :: params_found(:, :)
            real(c_double), allocatable :: values_found(:)
            integer(c_int32_t), allocatable :: found_found(:)
            real(c_double), allocatable :: boxes_found(:, :, :)
            logical :: complete_found
            call heights%create(degrees=[1, 1], counts=[2, 2], knots=[0.0d0, 0.0d0, 1.0d0, 1.0d0, 0.0d0, 0.0d0, 3.0d0, &
                3.0d0], points=reshape([0.0d0, 1.0d0, 1.0d0, 2.0d0], [4, 1], order=[2, 1]), flags=0)
            call extrema(g=heights, kinds=31, params=params_found, values=values_found, found=found_found, &
                boxes=boxes_found, complete=complete_found)
            call show('params', flat(reshape(params_found, [size(params_found, 2), size(params_found, 1)], order=[2, &
                1])))
            call show('values', values_found)
            call show('found', found_found)
            call show('boxes', flat(boxes_found))
            call show('complete', complete_found)
        end block
        call begin('extrema count')
        block
            type(nurbs_spline) :: ramp
            real(c_double), allocatable :: params_found(:, :)
            real(c_double), allocatable :: values_found(:)
            integer(c_int32_t), allocatable :: found_found(:)
            real(c_double), allocatable :: boxes_found(:, :, :)
            logical :: complete_found
            call ramp%create_bezier(degrees=[2], points=reshape([0.0d0, 0.25d0, 1.0d0], [3, 1], order=[2, 1]))
            call extrema(g=ramp, kinds=3, params=params_found, values=values_found, found=found_found, &
                boxes=boxes_found, complete=complete_found)
            call show('params', flat(reshape(params_found, [size(params_found, 2), size(params_found, 1)], order=[2, &
                1])))
            call show('values', values_found)
            call show('found', found_found)
            call show('boxes', flat(boxes_found))
            call show('complete', complete_found)
        end block
        call begin('mesh_curve')
        block
            real(c_double), allocatable :: params_found(:)
            real(c_double), allocatable :: points_found(:, :)
            real(c_double) :: bound_found
            logical :: reached_found
            call mesh_curve(g=curve, chord=1.0d0, params=params_found, points=points_found, bound=bound_found, &
                reached=reached_found, angle=2.0d0, longest=3.0d0)
            call show('params', params_found)
            call show('points', flat(reshape(points_found, [size(points_found, 2), size(points_found, 1)], order=[2, &
                1])))
            call show('bound', bound_found)
            call show('reached', reached_found)
        end block
        call begin('mesh_curve count')
        block
            real(c_double), allocatable :: params_found(:)
            real(c_double), allocatable :: points_found(:, :)
            real(c_double) :: bound_found
            logical :: reached_found
            call mesh_curve(g=loop, chord=0.5d0, params=params_found, points=points_found, bound=bound_found, &
                reached=reached_found, angle=0.0d0, longest=0.0d0)
            call show('params', params_found)
            call show('points', flat(reshape(points_found, [size(points_found, 2), size(points_found, 1)], order=[2, &
                1])))
            call show('bound', bound_found)
            call show('reached', reached_found)
        end block
        call begin('curve_monotone_pieces')
        block
            real(c_double), allocatable :: starts_found(:)
            integer(c_int32_t), allocatable :: signs_found(:)
            logical :: complete_found
            call monotone_pieces(g=curve, direction=[0.1d0, 0.9d0], starts=starts_found, signs=signs_found, &
                complete=complete_found)
            call show('starts', starts_found)
            call show('signs', signs_found)
            call show('complete', complete_found)
        end block
        call begin('curve_convexity')
        block
            integer(c_int32_t) :: convexity_found
            call curve_convexity(g=curve, convexity=convexity_found)
            call show('convexity', convexity_found)
        end block
        call begin('straightness')
        block
            real(c_double) :: bound_found
            real(c_double), allocatable :: origin_found(:)
            real(c_double), allocatable :: direction_found(:)
            allocate (origin_found(2))
            allocate (direction_found(2))
            call straightness(g=segment, bound=bound_found, origin=origin_found, direction=direction_found)
            call show('bound', bound_found)
            call show('origin', origin_found)
            call show('direction', direction_found)
        end block
        call begin('planarity')
        block
            real(c_double) :: bound_found
            real(c_double), allocatable :: origin_found(:)
            real(c_double), allocatable :: normal_found(:)
            allocate (origin_found(3))
            allocate (normal_found(3))
            call planarity(g=surface, bound=bound_found, origin=origin_found, normal=normal_found)
            call show('bound', bound_found)
            call show('origin', origin_found)
            call show('normal', normal_found)
        end block
        call begin('boundary_contacts')
        block
            logical, allocatable :: closed_found(:)
            real(c_double), allocatable :: gaps_found(:)
            logical, allocatable :: collapsed_found(:, :)
            real(c_double), allocatable :: sizes_found(:, :)
            call boundary_contacts(g=surface, closed=closed_found, gaps=gaps_found, collapsed=collapsed_found, &
                sizes=sizes_found, tolerance=0.1d0)
            call show('closed', closed_found)
            call show('gaps', gaps_found)
            call show('collapsed', flat(collapsed_found))
            call show('sizes', flat(sizes_found))
        end block
        call begin('singular_points')
        block
            real(c_double), allocatable :: params_found(:, :)
            real(c_double), allocatable :: boxes_found(:, :, :)
            logical :: complete_found
            call singular_points(g=surface, tolerance=0.1d0, params=params_found, boxes=boxes_found, &
                complete=complete_found)
            call show('params', flat(reshape(params_found, [size(params_found, 2), size(params_found, 1)], order=[2, &
                1])))
            call show('boxes', flat(boxes_found))
            call show('complete', complete_found)
        end block
        call begin('fold_test')
        block
            integer(c_int32_t) :: fold_found
            real(c_double), allocatable :: positive_found(:)
            real(c_double), allocatable :: negative_found(:)
            allocate (positive_found(2))
            allocate (negative_found(2))
            call fold_test(g=surface, fold=fold_found, positive=positive_found, negative=negative_found)
            call show('result', fold_found)
            call show('positive', positive_found)
            call show('negative', negative_found)
        end block
        call begin('fold_pieces')
        block
            integer(c_int32_t), allocatable :: folds_found(:)
            integer(c_int32_t), allocatable :: signs_found(:)
            call fold_pieces(g=surface, folds=folds_found, signs=signs_found)
            call show('folds', folds_found)
            call show('signs', signs_found)
        end block
        call begin('roots')
        block
            type(nurbs_spline) :: ramp
            real(c_double), allocatable :: params_found(:)
            integer(c_int32_t), allocatable :: kinds_found(:)
            real(c_double), allocatable :: ranges_found(:, :)
            logical :: complete_found
            call ramp%create_bezier(degrees=[2], points=reshape([0.0d0, 0.25d0, 1.0d0], [3, 1], order=[2, 1]))
            call roots(g=ramp, params=params_found, kinds=kinds_found, ranges=ranges_found, complete=complete_found, &
                value=0.5d0, tolerance=0.0d0)
            call show('params', params_found)
            call show('kinds', kinds_found)
            call show('ranges', flat(reshape(ranges_found, [size(ranges_found, 2), size(ranges_found, 1)], order=[2, &
                1])))
            call show('complete', complete_found)
        end block
        call begin('roots count')
        block
            type(nurbs_spline) :: round
            real(c_double), allocatable :: params_found(:)
            integer(c_int32_t), allocatable :: kinds_found(:)
            real(c_double), allocatable :: ranges_found(:, :)
            logical :: complete_found
            call round%create_bezier(degrees=[2], points=reshape([0.0d0, 2.0d0, 9.0d0], [3, 1], order=[2, 1]))
            call roots(g=round, params=params_found, kinds=kinds_found, ranges=ranges_found, complete=complete_found, &
                value=3.0d0, tolerance=1d-09)
            call show('params', params_found)
            call show('kinds', kinds_found)
            call show('ranges', flat(reshape(ranges_found, [size(ranges_found, 2), size(ranges_found, 1)], order=[2, &
                1])))
            call show('complete', complete_found)
        end block
        call begin('curve_level')
        block
            real(c_double), allocatable :: params_found(:)
            integer(c_int32_t), allocatable :: kinds_found(:)
            real(c_double), allocatable :: ranges_found(:, :)
            logical :: complete_found
            call curve_level(g=curve, degree=1, coefficients=[0.1d0, 0.9d0, -0.3d0], params=params_found, &
                kinds=kinds_found, ranges=ranges_found, complete=complete_found, tolerance=1d-09)
            call show('params', params_found)
            call show('kinds', kinds_found)
            call show('ranges', flat(reshape(ranges_found, [size(ranges_found, 2), size(ranges_found, 1)], order=[2, &
                1])))
            call show('complete', complete_found)
        end block
        call begin('surface_rays')
        block
            real(c_double), allocatable :: params_found(:, :)
            real(c_double), allocatable :: distances_found(:)
            integer(c_int32_t), allocatable :: states_found(:)
            allocate (params_found(2, 2))
            allocate (distances_found(2))
            allocate (states_found(2))
            call rays(g=surface, origins=reshape([0.1d0, 0.2d0, 5.0d0, 0.3d0, 0.4d0, 6.0d0], [2, 3], order=[2, 1]), &
                directions=reshape([0.0d0, 0.0d0, -1.0d0, 0.1d0, 0.1d0, -1.0d0], [2, 3], order=[2, 1]), &
                params=params_found, distances=distances_found, states=states_found)
            call show('params', flat(reshape(params_found, [size(params_found, 2), size(params_found, 1)], order=[2, &
                1])))
            call show('distances', distances_found)
            call show('status', states_found)
        end block
        call begin('surface_rays distances')
        block
            real(c_double), allocatable :: distances_found(:)
            allocate (distances_found(1))
            call rays(g=surface, origins=reshape([0.1d0, 0.2d0, 5.0d0], [1, 3], order=[2, 1]), &
                directions=reshape([0.0d0, 0.0d0, -1.0d0], [1, 3], order=[2, 1]), distances=distances_found)
            call show('distances', distances_found)
        end block
        call begin('surface_ray_hits within')
        block
            real(c_double), allocatable :: params_found(:, :)
            real(c_double), allocatable :: distances_found(:)
            integer(c_int32_t), allocatable :: kinds_found(:)
            logical :: complete_found
            call ray_hits(g=surface, origin=[0.1d0, 0.2d0, 5.0d0], direction=[0.0d0, 0.0d0, -1.0d0], &
                params=params_found, distances=distances_found, kinds=kinds_found, complete=complete_found, &
                range=[-1.0d0, 20.0d0])
            call show('params', flat(reshape(params_found, [size(params_found, 2), size(params_found, 1)], order=[2, &
                1])))
            call show('distances', distances_found)
            call show('kinds', kinds_found)
            call show('complete', complete_found)
        end block
        call begin('surface_ray_hits')
        block
            real(c_double), allocatable :: params_found(:, :)
            real(c_double), allocatable :: distances_found(:)
            integer(c_int32_t), allocatable :: kinds_found(:)
            logical :: complete_found
            call ray_hits(g=surface, origin=[0.1d0, 0.2d0, 5.0d0], direction=[0.0d0, 0.0d0, -1.0d0], &
                params=params_found, distances=distances_found, kinds=kinds_found, complete=complete_found)
            call show('params', flat(reshape(params_found, [size(params_found, 2), size(params_found, 1)], order=[2, &
                1])))
            call show('distances', distances_found)
            call show('kinds', kinds_found)
            call show('complete', complete_found)
        end block
        call begin('surfaces_common_points')
        block
            type(nurbs_spline) :: wall
            type(nurbs_spline) :: sphere
            real(c_double), allocatable :: params_found(:, :)
            real(c_double), allocatable :: points_found(:, :)
            integer(c_int32_t), allocatable :: kinds_found(:)
            real(c_double), allocatable :: ranges_found(:, :, :)
            logical :: complete_found
            call wall%create_bezier(degrees=[1, 1], points=reshape([0.3d0, -1.0d0, -1.0d0, 0.3d0, -1.0d0, 9.0d0, &
                0.4d0, 9.0d0, -1.0d0, 0.4d0, 9.0d0, 9.0d0], [4, 3], order=[2, 1]))
            call create_sphere(out=sphere, radius=1.0d0, form=0)
            call common_points(a=wall, b=surface, c=sphere, params=params_found, points=points_found, &
                kinds=kinds_found, ranges=ranges_found, complete=complete_found, tolerance=0.001d0)
            call show('params', flat(reshape(params_found, [size(params_found, 2), size(params_found, 1)], order=[2, &
                1])))
            call show('points', flat(reshape(points_found, [size(points_found, 2), size(points_found, 1)], order=[2, &
                1])))
            call show('kinds', kinds_found)
            call show('ranges', flat(reshape(ranges_found, [size(ranges_found, 2), size(ranges_found, 3), &
                size(ranges_found, 1)], order=[3, 1, 2])))
            call show('complete', complete_found)
        end block
        call begin('curve_surface_intersections')
        block
            type(nurbs_spline) :: sphere
            real(c_double), allocatable :: params_curve_found(:)
            real(c_double), allocatable :: params_surface_found(:, :)
            integer(c_int32_t), allocatable :: kinds_found(:)
            real(c_double), allocatable :: ranges_curve_found(:, :)
            real(c_double), allocatable :: ranges_surface_found(:, :, :)
            logical :: complete_found
            call create_sphere(out=sphere, radius=1.0d0, form=0)
            call surface_intersections(curve=twist, surface=sphere, params_curve=params_curve_found, &
                params_surface=params_surface_found, kinds=kinds_found, ranges_curve=ranges_curve_found, &
                ranges_surface=ranges_surface_found, complete=complete_found, tolerance=1d-09)
            call show('params_curve', params_curve_found)
            call show('params_surface', flat(reshape(params_surface_found, [size(params_surface_found, 2), &
                size(params_surface_found, 1)], order=[2, 1])))
            call show('kinds', kinds_found)
            call show('ranges_curve', flat(reshape(ranges_curve_found, [size(ranges_curve_found, 2), &
                size(ranges_curve_found, 1)], order=[2, 1])))
            call show('ranges_surface', flat(ranges_surface_found))
            call show('complete', complete_found)
        end block
        call begin('face_rays')
        block
            real(c_double), allocatable :: params_found(:, :)
            real(c_double), allocatable :: distances_found(:)
            integer(c_int32_t), allocatable :: states_found(:)
            allocate (params_found(2, 2))
            allocate (distances_found(2))
            allocate (states_found(2))
            call face%rays(origins=reshape([0.5d0, 1.2d0, 9.0d0, 0.3d0, 0.4d0, 6.0d0], [2, 3], order=[2, 1]), &
                directions=reshape([0.0d0, 0.0d0, -1.0d0, 0.1d0, 0.1d0, -1.0d0], [2, 3], order=[2, 1]), &
                params=params_found, distances=distances_found, states=states_found)
            call show('params', flat(reshape(params_found, [size(params_found, 2), size(params_found, 1)], order=[2, &
                1])))
            call show('distances', distances_found)
            call show('status', states_found)
        end block
        call begin('face_rays distances')
        block
            real(c_double), allocatable :: distances_found(:)
            allocate (distances_found(1))
            call face%rays(origins=reshape([0.5d0, 1.2d0, 9.0d0], [1, 3], order=[2, 1]), &
                directions=reshape([0.0d0, 0.0d0, -1.0d0], [1, 3], order=[2, 1]), distances=distances_found)
            call show('distances', distances_found)
        end block
        call begin('face_closest_points')
        block
            real(c_double), allocatable :: params_found(:, :)
            real(c_double), allocatable :: feet_found(:, :)
            real(c_double), allocatable :: distances_found(:)
            integer(c_int32_t), allocatable :: states_found(:)
            allocate (params_found(2, 2))
            allocate (feet_found(2, 3))
            allocate (distances_found(2))
            allocate (states_found(2))
            call face%closest_points(points=reshape([0.5d0, 1.2d0, 9.0d0, 0.3d0, 0.4d0, 6.0d0], [2, 3], order=[2, 1]), &
                params=params_found, feet=feet_found, distances=distances_found, states=states_found, tolerance=1d-06)
            call show('params', flat(reshape(params_found, [size(params_found, 2), size(params_found, 1)], order=[2, &
                1])))
            call show('feet', flat(reshape(feet_found, [size(feet_found, 2), size(feet_found, 1)], order=[2, 1])))
            call show('distances', distances_found)
            call show('status', states_found)
        end block
        call begin('face_closest_points alone')
        block
            real(c_double), allocatable :: distances_found(:)
            allocate (distances_found(1))
            call face%closest_points(points=reshape([0.1d0, 0.2d0, 0.3d0], [1, 3], order=[2, 1]), &
                distances=distances_found, tolerance=0.0d0)
            call show('distances', distances_found)
        end block
        call begin('face_distance')
        block
            type(nurbs_spline) :: sphere
            type(nurbs_face) :: ball_face
            real(c_double) :: at_least_found
            real(c_double) :: at_most_found
            real(c_double), allocatable :: params_a_found(:)
            real(c_double), allocatable :: params_b_found(:)
            integer(c_int32_t) :: state_found
            call create_sphere(out=sphere, radius=1.0d0, form=0)
            call ball_face%create(surface=sphere, sizes=[integer(c_int32_t) ::], tolerance=1d-09, flags=0)
            allocate (params_a_found(2))
            allocate (params_b_found(2))
            call face%distance(other=ball_face, at_least=at_least_found, at_most=at_most_found, &
                params_a=params_a_found, params_b=params_b_found, state=state_found, tolerance=4.0d0)
            call show('at_least', at_least_found)
            call show('at_most', at_most_found)
            call show('params_a', params_a_found)
            call show('params_b', params_b_found)
            call show('status', state_found)
        end block
        call begin('face_hausdorff_distance')
        block
            type(nurbs_spline) :: sphere
            type(nurbs_face) :: ball_face
            real(c_double), allocatable :: at_least_found(:)
            real(c_double), allocatable :: at_most_found(:)
            real(c_double), allocatable :: params_a_found(:)
            real(c_double), allocatable :: params_b_found(:)
            integer(c_int32_t) :: state_found
            call create_sphere(out=sphere, radius=1.0d0, form=0)
            call ball_face%create(surface=sphere, sizes=[integer(c_int32_t) ::], tolerance=1d-09, flags=0)
            allocate (at_least_found(2))
            allocate (at_most_found(2))
            allocate (params_a_found(2))
            allocate (params_b_found(2))
            call face%hausdorff_distance(other=ball_face, tolerance=4.0d0, at_least=at_least_found, &
                at_most=at_most_found, params_a=params_a_found, params_b=params_b_found, state=state_found)
            call show('at_least', at_least_found)
            call show('at_most', at_most_found)
            call show('params_a', params_a_found)
            call show('params_b', params_b_found)
            call show('status', state_found)
        end block
        call begin('model_instances')
        block
            integer(c_int64_t), allocatable :: parents_found(:)
            integer(c_int64_t), allocatable :: uses_found(:)
            integer(c_int64_t), allocatable :: parts_found(:)
            real(c_double), allocatable :: placements_found(:, :)
            call model%instances(parents=parents_found, uses=uses_found, parts=parts_found, placements=placements_found)
            call show('parents', parents_found - 1)
            call show('last_uses', uses_found - 1)
            call show('own_parts', parts_found - 1)
            call show('placements', flat(reshape(placements_found, [size(placements_found, 2), &
                size(placements_found, 1)], order=[2, 1])))
        end block
        call begin('model_rays')
        block
            real(c_double), allocatable :: params_found(:, :)
            real(c_double), allocatable :: distances_found(:)
            integer(c_int32_t), allocatable :: states_found(:)
            integer(c_int64_t), allocatable :: places_found(:, :)
            allocate (params_found(2, 2))
            allocate (distances_found(2))
            allocate (states_found(2))
            allocate (places_found(2, 2))
            call model%rays(origins=reshape([0.5d0, 1.2d0, 9.0d0, 0.3d0, 0.4d0, 6.0d0], [2, 3], order=[2, 1]), &
                directions=reshape([0.0d0, 0.0d0, -1.0d0, 0.1d0, 0.1d0, -1.0d0], [2, 3], order=[2, 1]), &
                params=params_found, distances=distances_found, states=states_found, places=places_found)
            call show('params', flat(reshape(params_found, [size(params_found, 2), size(params_found, 1)], order=[2, &
                1])))
            call show('distances', distances_found)
            call show('status', states_found)
            call show('places', flat(reshape(places_found, [size(places_found, 2), size(places_found, 1)], order=[2, &
                1])) - 1)
        end block
        call begin('model_rays places')
        block
            type(nurbs_spline) :: sphere
            type(nurbs_face) :: ball_face
            type(nurbs_model) :: ball
            type(nurbs_face) :: faces_given(1)
            real(c_double), allocatable :: distances_found(:)
            integer(c_int64_t), allocatable :: places_found(:, :)
            call create_sphere(out=sphere, radius=1.0d0, form=0)
            call ball_face%create(surface=sphere, sizes=[integer(c_int32_t) ::], tolerance=1d-09, flags=0)
            faces_given(1) = ball_face
            call ball%create(faces=faces_given, metres=1.0d0)
            allocate (distances_found(1))
            allocate (places_found(1, 2))
            call ball%rays(origins=reshape([0.1d0, 0.2d0, 5.0d0], [1, 3], order=[2, 1]), &
                directions=reshape([0.0d0, 0.0d0, -1.0d0], [1, 3], order=[2, 1]), distances=distances_found, &
                places=places_found)
            call show('distances', distances_found)
            call show('places', flat(reshape(places_found, [size(places_found, 2), size(places_found, 1)], order=[2, &
                1])) - 1)
        end block
        call begin('model_ray_hits within')
        block
            real(c_double), allocatable :: params_found(:, :)
            real(c_double), allocatable :: distances_found(:)
            integer(c_int32_t), allocatable :: kinds_found(:)
            integer(c_int64_t), allocatable :: places_found(:, :)
            logical :: complete_found
            call model%ray_hits(origin=[0.5d0, 1.2d0, 9.0d0], direction=[0.0d0, 0.0d0, -1.0d0], params=params_found, &
                distances=distances_found, kinds=kinds_found, places=places_found, complete=complete_found, &
                range=[-1.0d0, 20.0d0])
            call show('params', flat(reshape(params_found, [size(params_found, 2), size(params_found, 1)], order=[2, &
                1])))
            call show('distances', distances_found)
            call show('kinds', kinds_found)
            call show('places', flat(reshape(places_found, [size(places_found, 2), size(places_found, 1)], order=[2, &
                1])) - 1)
            call show('complete', complete_found)
        end block
        call begin('model_ray_hits')
        block
            type(nurbs_spline) :: sphere
            type(nurbs_face) :: ball_face
            type(nurbs_model) :: ball
            type(nurbs_face) :: faces_given(1)
            real(c_double), allocatable :: params_found(:, :)
            real(c_double), allocatable :: distances_found(:)
            integer(c_int32_t), allocatable :: kinds_found(:)
            integer(c_int64_t), allocatable :: places_found(:, :)
            logical :: complete_found
            call create_sphere(out=sphere, radius=1.0d0, form=0)
            call ball_face%create(surface=sphere, sizes=[integer(c_int32_t) ::], tolerance=1d-09, flags=0)
            faces_given(1) = ball_face
            call ball%create(faces=faces_given, metres=1.0d0)
            call ball%ray_hits(origin=[0.1d0, 0.2d0, 5.0d0], direction=[0.0d0, 0.0d0, -1.0d0], params=params_found, &
                distances=distances_found, kinds=kinds_found, places=places_found, complete=complete_found)
            call show('params', flat(reshape(params_found, [size(params_found, 2), size(params_found, 1)], order=[2, &
                1])))
            call show('distances', distances_found)
            call show('kinds', kinds_found)
            call show('places', flat(reshape(places_found, [size(places_found, 2), size(places_found, 1)], order=[2, &
                1])) - 1)
            call show('complete', complete_found)
        end block
        call begin('model_closest_points')
        block
            real(c_double), allocatable :: params_found(:, :)
            real(c_double), allocatable :: feet_found(:, :)
            real(c_double), allocatable :: distances_found(:)
            integer(c_int32_t), allocatable :: states_found(:)
            integer(c_int64_t), allocatable :: places_found(:, :)
            allocate (params_found(2, 2))
            allocate (feet_found(2, 3))
            allocate (distances_found(2))
            allocate (states_found(2))
            allocate (places_found(2, 2))
            call model%closest_points(points=reshape([0.5d0, 1.2d0, 9.0d0, 0.3d0, 0.4d0, 6.0d0], [2, 3], order=[2, &
                1]), params=params_found, feet=feet_found, distances=distances_found, states=states_found, &
                places=places_found, tolerance=1d-06)
            call show('params', flat(reshape(params_found, [size(params_found, 2), size(params_found, 1)], order=[2, &
                1])))
            call show('feet', flat(reshape(feet_found, [size(feet_found, 2), size(feet_found, 1)], order=[2, 1])))
            call show('distances', distances_found)
            call show('status', states_found)
            call show('places', flat(reshape(places_found, [size(places_found, 2), size(places_found, 1)], order=[2, &
                1])) - 1)
        end block
        call begin('model_closest_points alone')
        block
            type(nurbs_spline) :: sphere
            type(nurbs_face) :: ball_face
            type(nurbs_model) :: ball
            type(nurbs_face) :: faces_given(1)
            real(c_double), allocatable :: distances_found(:)
            integer(c_int64_t), allocatable :: places_found(:, :)
            call create_sphere(out=sphere, radius=1.0d0, form=0)
            call ball_face%create(surface=sphere, sizes=[integer(c_int32_t) ::], tolerance=1d-09, flags=0)
            faces_given(1) = ball_face
            call ball%create(faces=faces_given, metres=1.0d0)
            allocate (distances_found(1))
            allocate (places_found(1, 2))
            call ball%closest_points(points=reshape([0.1d0, 0.2d0, 3.0d0], [1, 3], order=[2, 1]), &
                distances=distances_found, places=places_found, tolerance=0.0d0)
            call show('distances', distances_found)
            call show('places', flat(reshape(places_found, [size(places_found, 2), size(places_found, 1)], order=[2, &
                1])) - 1)
        end block
        call begin('model_classify')
        block
            type(nurbs_spline) :: sphere
            type(nurbs_face) :: ball_face
            type(nurbs_model) :: ball
            type(nurbs_face) :: faces_given(1)
            integer(c_int32_t), allocatable :: sides_found(:)
            call create_sphere(out=sphere, radius=1.0d0, form=0)
            call ball_face%create(surface=sphere, sizes=[integer(c_int32_t) ::], tolerance=1d-09, flags=0)
            faces_given(1) = ball_face
            call ball%create(faces=faces_given, metres=1.0d0)
            allocate (sides_found(2))
            call ball%classify(points=reshape([0.1d0, 0.2d0, 0.3d0, 1.0d0, 1.0d0, 1.0d0], [2, 3], order=[2, 1]), &
                sides=sides_found, tolerance=0.0d0)
            call show('sides', sides_found)
        end block
        call begin('model_classify near')
        block
            type(nurbs_spline) :: sphere
            type(nurbs_face) :: ball_face
            type(nurbs_model) :: ball
            type(nurbs_face) :: faces_given(1)
            integer(c_int32_t), allocatable :: sides_found(:)
            call create_sphere(out=sphere, radius=1.0d0, form=0)
            call ball_face%create(surface=sphere, sizes=[integer(c_int32_t) ::], tolerance=1d-09, flags=0)
            faces_given(1) = ball_face
            call ball%create(faces=faces_given, metres=1.0d0)
            allocate (sides_found(2))
            call ball%classify(points=reshape([0.1d0, 0.2d0, 0.3d0, 0.0d0, 0.6d0, 0.8d0], [2, 3], order=[2, 1]), &
                sides=sides_found, tolerance=0.001d0)
            call show('sides', sides_found)
        end block
        call begin('model_area')
        block
            type(nurbs_spline) :: sphere
            type(nurbs_face) :: ball_face
            type(nurbs_model) :: ball
            type(nurbs_face) :: faces_given(1)
            real(c_double) :: area_found
            real(c_double) :: error_found
            call create_sphere(out=sphere, radius=1.0d0, form=0)
            call ball_face%create(surface=sphere, sizes=[integer(c_int32_t) ::], tolerance=1d-09, flags=0)
            faces_given(1) = ball_face
            call ball%create(faces=faces_given, metres=1.0d0)
            call ball%get_area(area=area_found, error=error_found, tolerance=1d-06)
            call show('area', area_found)
            call show('error', error_found)
        end block
        call begin('model_volume')
        block
            type(nurbs_spline) :: sphere
            type(nurbs_face) :: ball_face
            type(nurbs_model) :: ball
            type(nurbs_face) :: faces_given(1)
            real(c_double) :: volume_found
            real(c_double), allocatable :: centroid_found(:)
            real(c_double), allocatable :: inertia_found(:, :)
            real(c_double) :: openness_found
            real(c_double) :: error_found
            call create_sphere(out=sphere, radius=1.0d0, form=0)
            call ball_face%create(surface=sphere, sizes=[integer(c_int32_t) ::], tolerance=1d-09, flags=0)
            faces_given(1) = ball_face
            call ball%create(faces=faces_given, metres=1.0d0)
            allocate (centroid_found(3))
            allocate (inertia_found(3, 3))
            call ball%get_volume(volume=volume_found, centroid=centroid_found, inertia=inertia_found, &
                openness=openness_found, error=error_found, tolerance=1d-06)
            call show('volume', volume_found)
            call show('centroid', centroid_found)
            call show('inertia', flat(inertia_found))
            call show('openness', openness_found)
            call show('error', error_found)
        end block
        call begin('model_volume alone')
        block
            type(nurbs_spline) :: sphere
            type(nurbs_face) :: ball_face
            type(nurbs_model) :: ball
            type(nurbs_face) :: faces_given(1)
            real(c_double) :: volume_found
            real(c_double) :: error_found
            call create_sphere(out=sphere, radius=1.0d0, form=0)
            call ball_face%create(surface=sphere, sizes=[integer(c_int32_t) ::], tolerance=1d-09, flags=0)
            faces_given(1) = ball_face
            call ball%create(faces=faces_given, metres=1.0d0)
            call ball%get_volume(volume=volume_found, error=error_found, tolerance=1d-06)
            call show('volume', volume_found)
            call show('error', error_found)
        end block
        call begin('curve_self_intersections')
        block
            real(c_double), allocatable :: params_a_found(:)
            real(c_double), allocatable :: params_b_found(:)
            integer(c_int32_t), allocatable :: kinds_found(:)
            real(c_double), allocatable :: ranges_a_found(:, :)
            real(c_double), allocatable :: ranges_b_found(:, :)
            logical :: complete_found
            call self_intersections(g=curve, params_a=params_a_found, params_b=params_b_found, kinds=kinds_found, &
                ranges_a=ranges_a_found, ranges_b=ranges_b_found, complete=complete_found, tolerance=1d-09)
            call show('params_a', params_a_found)
            call show('params_b', params_b_found)
            call show('kinds', kinds_found)
            call show('ranges_a', flat(reshape(ranges_a_found, [size(ranges_a_found, 2), size(ranges_a_found, 1)], &
                order=[2, 1])))
            call show('ranges_b', flat(reshape(ranges_b_found, [size(ranges_b_found, 2), size(ranges_b_found, 1)], &
                order=[2, 1])))
            call show('complete', complete_found)
        end block
        call begin('curve_intersections')
        block
            real(c_double), allocatable :: params_a_found(:)
            real(c_double), allocatable :: params_b_found(:)
            integer(c_int32_t), allocatable :: kinds_found(:)
            real(c_double), allocatable :: ranges_a_found(:, :)
            real(c_double), allocatable :: ranges_b_found(:, :)
            logical :: complete_found
            call curve_intersections(a=curve, b=segment, params_a=params_a_found, params_b=params_b_found, &
                kinds=kinds_found, ranges_a=ranges_a_found, ranges_b=ranges_b_found, complete=complete_found, &
                tolerance=1d-09)
            call show('params_a', params_a_found)
            call show('params_b', params_b_found)
            call show('kinds', kinds_found)
            call show('ranges_a', flat(reshape(ranges_a_found, [size(ranges_a_found, 2), size(ranges_a_found, 1)], &
                order=[2, 1])))
            call show('ranges_b', flat(reshape(ranges_b_found, [size(ranges_b_found, 2), size(ranges_b_found, 1)], &
                order=[2, 1])))
            call show('complete', complete_found)
        end block
        call begin('curve_level conic')
        block
            real(c_double), allocatable :: params_found(:)
            integer(c_int32_t), allocatable :: kinds_found(:)
            real(c_double), allocatable :: ranges_found(:, :)
            logical :: complete_found
            call curve_level(g=loop, degree=2, coefficients=[1.0d0, 0.0d0, 0.0d0, 1.0d0, 0.0d0, -0.5d0], &
                params=params_found, kinds=kinds_found, ranges=ranges_found, complete=complete_found, tolerance=0.0d0)
            call show('params', params_found)
            call show('kinds', kinds_found)
            call show('ranges', flat(reshape(ranges_found, [size(ranges_found, 2), size(ranges_found, 1)], order=[2, &
                1])))
            call show('complete', complete_found)
        end block
        call begin('fold_test seen from above')
        block
            integer(c_int32_t) :: fold_found
            real(c_double), allocatable :: positive_found(:)
            real(c_double), allocatable :: negative_found(:)
            allocate (positive_found(2))
            allocate (negative_found(2))
            call fold_test(g=surface, fold=fold_found, positive=positive_found, negative=negative_found, &
                reference=[1.0d0, 2.0d0, 3.0d0])
            call show('result', fold_found)
            call show('positive', positive_found)
            call show('negative', negative_found)
        end block
        call begin('fold_pieces seen from above')
        block
            integer(c_int32_t), allocatable :: folds_found(:)
            integer(c_int32_t), allocatable :: signs_found(:)
            call fold_pieces(g=surface, folds=folds_found, signs=signs_found, reference=[1.0d0, 2.0d0, 3.0d0])
            call show('folds', folds_found)
            call show('signs', signs_found)
        end block
        call begin('recognize curve')
        block
            type(recognized_shape) :: found_found
            call recognize_spline(g=curve, tolerance=1d-09, found=found_found)
            call show('shape', found_found%shape)
            call show('placement', found_found%origin)
            call show('placement', found_found%axis)
            call show('placement', found_found%x)
            call show('sizes', found_found%sizes)
            call show('deviation', found_found%deviation)
        end block
        call begin('recognize surface')
        block
            type(recognized_shape) :: found_found
            call recognize_spline(g=surface, tolerance=0.2d0, found=found_found)
            call show('shape', found_found%shape)
            call show('placement', found_found%origin)
            call show('placement', found_found%axis)
            call show('placement', found_found%x)
            call show('sizes', found_found%sizes)
            call show('deviation', found_found%deviation)
        end block
        call begin('length_adjoint')
        block
            real(c_double), allocatable :: grad_points_found(:, :)
            real(c_double), allocatable :: grad_weights_found(:)
            real(c_double) :: error_found
            allocate (grad_points_found(9, 2))
            grad_points_found = 0
            allocate (grad_weights_found(9))
            grad_weights_found = 0
            call curve%length_adjoint(relative_tolerance=1d-06, cotangent=1.0d0, grad_points=grad_points_found, &
                grad_weights=grad_weights_found, error=error_found, flags=0)
            call show('grad_points', flat(reshape(grad_points_found, [size(grad_points_found, 2), &
                size(grad_points_found, 1)], order=[2, 1])))
            call show('grad_weights', grad_weights_found)
            call show('error', error_found)
        end block
        call begin('length_adjoint of a part')
        block
            real(c_double), allocatable :: grad_points_found(:, :)
            real(c_double), allocatable :: grad_weights_found(:)
            real(c_double) :: error_found
            allocate (grad_points_found(9, 2))
            grad_points_found = 0
            allocate (grad_weights_found(9))
            grad_weights_found = 0
            call curve%length_adjoint(relative_tolerance=1d-06, cotangent=1.0d0, grad_points=grad_points_found, &
                grad_weights=grad_weights_found, error=error_found, range=[0.3d0, 0.6d0], flags=0)
            call show('grad_points', flat(reshape(grad_points_found, [size(grad_points_found, 2), &
                size(grad_points_found, 1)], order=[2, 1])))
            call show('grad_weights', grad_weights_found)
            call show('error', error_found)
        end block
        call begin('curve_length')
        block
            real(c_double) :: length_found
            real(c_double) :: error_found
            call curve_length(g=curve, length=length_found, error=error_found, tolerance=1d-09)
            call show('length', length_found)
            call show('error', error_found)
        end block
        call begin('curve_length of a part')
        block
            real(c_double) :: length_found
            real(c_double) :: error_found
            call curve_length(g=curve, length=length_found, error=error_found, range=[0.3d0, 0.6d0], tolerance=1d-09)
            call show('length', length_found)
            call show('error', error_found)
        end block
        call begin('curve_lengths')
        block
            real(c_double), allocatable :: lengths_found(:)
            allocate (lengths_found(1))
            call curve_lengths(g=loop, params=[4.0d0], lengths=lengths_found, tolerance=1d-09)
            call show('lengths', lengths_found)
        end block
        call begin('curve_params_at_lengths')
        block
            real(c_double), allocatable :: params_found(:)
            allocate (params_found(1))
            call params_at_lengths(g=curve, lengths=[4.0d0], params=params_found, tolerance=1d-09, flags=0)
            call show('params', params_found)
        end block
        call begin('curve_divide')
        block
            real(c_double), allocatable :: params_found(:)
            real(c_double) :: size_found
            call divide_curve(g=curve, parts=5, params=params_found, size=size_found, tolerance=1d-09, flags=0)
            call show('params', params_found)
            call show('size', size_found)
        end block
        call begin('curve_divide a part')
        block
            real(c_double), allocatable :: params_found(:)
            real(c_double) :: size_found
            call divide_curve(g=curve, parts=5, params=params_found, size=size_found, range=[0.3d0, 0.6d0], &
                tolerance=1d-09, flags=0)
            call show('params', params_found)
            call show('size', size_found)
        end block
        call begin('curve_divide chords')
        block
            real(c_double), allocatable :: params_found(:)
            real(c_double) :: size_found
            call divide_curve(g=curve, parts=5, params=params_found, size=size_found, tolerance=1d-09, flags=33554432)
            call show('params', params_found)
            call show('size', size_found)
        end block
        call begin('surface_area')
        block
            real(c_double) :: area_found
            real(c_double) :: error_found
            call surface_area(g=surface, area=area_found, error=error_found, tolerance=1d-09)
            call show('area', area_found)
            call show('error', error_found)
        end block
        call begin('surface_area of a part')
        block
            real(c_double) :: area_found
            real(c_double) :: error_found
            call surface_area(g=surface, area=area_found, error=error_found, &
                range=reshape([0.0d0, 1.0d0, 0.0d0, 3.0d0], [2, 2]), tolerance=1d-09)
            call show('area', area_found)
            call show('error', error_found)
        end block
        call begin('moments')
        block
            real(c_double) :: content_found
            real(c_double), allocatable :: centroid_found(:)
            real(c_double), allocatable :: inertia_found(:, :)
            real(c_double) :: error_found
            allocate (centroid_found(3))
            allocate (inertia_found(3, 3))
            call spline_moments(g=surface, content=content_found, centroid=centroid_found, inertia=inertia_found, &
                error=error_found, tolerance=1d-09)
            call show('content', content_found)
            call show('centroid', centroid_found)
            call show('inertia', flat(inertia_found))
            call show('error', error_found)
        end block
        call begin('enclosed_area')
        block
            type(nurbs_spline) :: curves_given(1)
            real(c_double) :: area_found
            real(c_double), allocatable :: centroid_found(:)
            real(c_double), allocatable :: inertia_found(:, :)
            real(c_double) :: error_found
            curves_given(1) = loop
            allocate (centroid_found(2))
            allocate (inertia_found(2, 2))
            call enclosed_area(curves=curves_given, area=area_found, centroid=centroid_found, inertia=inertia_found, &
                error=error_found, gap=1d-09, tolerance=1d-09)
            call show('area', area_found)
            call show('centroid', centroid_found)
            call show('inertia', flat(inertia_found))
            call show('error', error_found)
        end block
        call begin('enclosed_volume')
        block
            type(nurbs_spline) :: surfaces_given(1)
            real(c_double) :: volume_found
            real(c_double) :: openness_found
            real(c_double) :: error_found
            surfaces_given(1) = surface
            call enclosed_volume(surfaces=surfaces_given, volume=volume_found, openness=openness_found, &
                error=error_found, tolerance=1d-09)
            call show('volume', volume_found)
            call show('openness', openness_found)
            call show('error', error_found)
        end block
        call begin('enclosed_volume sphere')
        block
            type(nurbs_spline) :: sphere
            type(nurbs_spline) :: surfaces_given(1)
            real(c_double) :: volume_found
            real(c_double), allocatable :: centroid_found(:)
            real(c_double), allocatable :: inertia_found(:, :)
            real(c_double) :: openness_found
            real(c_double) :: error_found
            call create_sphere(out=sphere, radius=1.0d0, form=0)
            surfaces_given(1) = sphere
            allocate (centroid_found(3))
            allocate (inertia_found(3, 3))
            call enclosed_volume(surfaces=surfaces_given, volume=volume_found, centroid=centroid_found, &
                inertia=inertia_found, openness=openness_found, error=error_found, tolerance=1d-06)
            call show('volume', volume_found)
            call show('centroid', centroid_found)
            call show('inertia', flat(inertia_found))
            call show('openness', openness_found)
            call show('error', error_found)
        end block
        call begin('quadrature')
        block
            real(c_double), allocatable :: params_found(:, :)
            real(c_double), allocatable :: weights_found(:)
            real(c_double), allocatable :: measures_found(:)
            call quadrature(g=curve, params=params_found, weights=weights_found, measures=measures_found, nodes=2)
            call show('params', flat(reshape(params_found, [size(params_found, 2), size(params_found, 1)], order=[2, &
                1])))
            call show('weights', weights_found)
            call show('measures', measures_found)
        end block
        call begin('quadrature surface')
        block
            real(c_double), allocatable :: params_found(:, :)
            real(c_double), allocatable :: weights_found(:)
            real(c_double), allocatable :: measures_found(:)
            call quadrature(g=surface, params=params_found, weights=weights_found, measures=measures_found, nodes=1)
            call show('params', flat(reshape(params_found, [size(params_found, 2), size(params_found, 1)], order=[2, &
                1])))
            call show('weights', weights_found)
            call show('measures', measures_found)
        end block
        call begin('coons_gaps')
        block
            type(nurbs_spline) :: curves_given(4)
            real(c_double), allocatable :: positions_found(:)
            type(nurbs_spline) :: cross_given(4)
            real(c_double), allocatable :: tangents_found(:, :)
            real(c_double), allocatable :: twists_found(:)
            curves_given(1) = curve
            curves_given(2) = curve
            curves_given(3) = loop
            curves_given(4) = loop
            allocate (positions_found(4))
            cross_given(1) = curve
            cross_given(2) = curve
            cross_given(3) = loop
            cross_given(4) = loop
            allocate (tangents_found(4, 2))
            allocate (twists_found(4))
            call coons_gaps(curves=curves_given, positions=positions_found, cross=cross_given, &
                tangents=tangents_found, twists=twists_found)
            call show('positions', positions_found)
            call show('tangents', flat(reshape(tangents_found, [size(tangents_found, 2), size(tangents_found, 1)], &
                order=[2, 1])))
            call show('twists', twists_found)
        end block
        call begin('continuity')
        block
            real(c_double), allocatable :: knots_found(:)
            integer(c_int32_t), allocatable :: knot_orders_found(:)
            type(spline_continuity), allocatable :: found_found(:)
            call knot_continuity(spline=curve, axis=1, tolerances=[0.0d0, 0.0d0, 0.0d0], knots=knots_found, &
                knot_orders=knot_orders_found, found=found_found)
            call show('knots', knots_found)
            call show('knot_orders', knot_orders_found)
            call show('orders', found_found%order)
            call show('geometric_orders', found_found%geometric)
            call show('position_gaps', found_found%position_gap)
            call show('angles', found_found%angle)
            call show('curvature_gaps', found_found%curvature_gap)
        end block
        call begin('continuity count')
        block
            real(c_double), allocatable :: knots_found(:)
            integer(c_int32_t), allocatable :: knot_orders_found(:)
            type(spline_continuity), allocatable :: found_found(:)
            call knot_continuity(spline=surface, axis=2, tolerances=[0.0d0, 0.0d0, 0.0d0], knots=knots_found, &
                knot_orders=knot_orders_found, found=found_found)
            call show('knots', knots_found)
            call show('knot_orders', knot_orders_found)
            call show('orders', found_found%order)
            call show('geometric_orders', found_found%geometric)
            call show('position_gaps', found_found%position_gap)
            call show('angles', found_found%angle)
            call show('curvature_gaps', found_found%curvature_gap)
        end block
        call begin('continuity_between')
        block
            type(spline_continuity) :: found_found
            call end_continuity(a=curve, end_a=1, b=curve, end_b=0, tolerances=[0.0d0, 0.0d0, 0.0d0], found=found_found)
            call show('order', found_found%order)
            call show('geometric', found_found%geometric)
            call show('position_gap', found_found%position_gap)
            call show('angle', found_found%angle)
            call show('curvature_gap', found_found%curvature_gap)
        end block
        call begin('closest_points_with')
        block
            real(c_double), allocatable :: params_found(:, :)
            real(c_double), allocatable :: feet_found(:, :)
            real(c_double), allocatable :: distances_found(:)
            integer(c_int32_t), allocatable :: states_found(:)
            type(nurbs_call) :: watching
            allocate (params_found(1, 1))
            allocate (feet_found(1, 2))
            allocate (distances_found(1))
            allocate (states_found(1))
            call closest_points(g=curve, points=reshape([0.1d0, 0.9d0], [1, 2], order=[2, 1]), params=params_found, &
                feet=feet_found, distances=distances_found, states=states_found, tolerance=0.0d0, budget=0, flags=0, &
                call=watching)
            call show('params', flat(reshape(params_found, [size(params_found, 2), size(params_found, 1)], order=[2, &
                1])))
            call show('feet', flat(reshape(feet_found, [size(feet_found, 2), size(feet_found, 1)], order=[2, 1])))
            call show('distances', distances_found)
            call show('status', states_found)
        end block
        call begin('closest_points_with of a part')
        block
            real(c_double), allocatable :: params_found(:, :)
            real(c_double), allocatable :: feet_found(:, :)
            real(c_double), allocatable :: distances_found(:)
            integer(c_int32_t), allocatable :: states_found(:)
            type(nurbs_call) :: watching
            allocate (params_found(2, 2))
            allocate (feet_found(2, 3))
            allocate (distances_found(2))
            allocate (states_found(2))
            call closest_points(g=surface, points=reshape([0.1d0, 0.9d0, 0.3d0, 0.7d0, 0.2d0, 0.6d0], [2, 3], &
                order=[2, 1]), params=params_found, feet=feet_found, distances=distances_found, states=states_found, &
                range=reshape([0.0d0, 1.0d0, 0.0d0, 3.0d0], [2, 2]), tolerance=0.0d0, budget=0, flags=0, call=watching)
            call show('params', flat(reshape(params_found, [size(params_found, 2), size(params_found, 1)], order=[2, &
                1])))
            call show('feet', flat(reshape(feet_found, [size(feet_found, 2), size(feet_found, 1)], order=[2, 1])))
            call show('distances', distances_found)
            call show('status', states_found)
        end block
        call begin('farthest_points_with')
        block
            real(c_double), allocatable :: params_found(:, :)
            real(c_double), allocatable :: feet_found(:, :)
            real(c_double), allocatable :: distances_found(:)
            integer(c_int32_t), allocatable :: states_found(:)
            type(nurbs_call) :: watching
            allocate (params_found(1, 1))
            allocate (feet_found(1, 2))
            allocate (distances_found(1))
            allocate (states_found(1))
            call farthest_points(g=curve, points=reshape([0.1d0, 0.9d0], [1, 2], order=[2, 1]), params=params_found, &
                feet=feet_found, distances=distances_found, states=states_found, tolerance=0.0d0, budget=0, flags=0, &
                call=watching)
            call show('params', flat(reshape(params_found, [size(params_found, 2), size(params_found, 1)], order=[2, &
                1])))
            call show('feet', flat(reshape(feet_found, [size(feet_found, 2), size(feet_found, 1)], order=[2, 1])))
            call show('distances', distances_found)
            call show('status', states_found)
        end block
        call begin('farthest_points_with of a part')
        block
            real(c_double), allocatable :: params_found(:, :)
            real(c_double), allocatable :: feet_found(:, :)
            real(c_double), allocatable :: distances_found(:)
            integer(c_int32_t), allocatable :: states_found(:)
            type(nurbs_call) :: watching
            allocate (params_found(3, 1))
            allocate (feet_found(3, 2))
            allocate (distances_found(3))
            allocate (states_found(3))
            call farthest_points(g=curve, points=reshape([0.1d0, 0.9d0, 0.3d0, 0.7d0, 0.2d0, 0.6d0], [3, 2], order=[2, &
                1]), params=params_found, feet=feet_found, distances=distances_found, states=states_found, &
                range=reshape([0.3d0, 0.6d0], [2, 1]), tolerance=0.0d0, budget=0, flags=0, call=watching)
            call show('params', flat(reshape(params_found, [size(params_found, 2), size(params_found, 1)], order=[2, &
                1])))
            call show('feet', flat(reshape(feet_found, [size(feet_found, 2), size(feet_found, 1)], order=[2, 1])))
            call show('distances', distances_found)
            call show('status', states_found)
        end block
        call begin('closest_local_with')
        block
            real(c_double), allocatable :: params_found(:, :)
            real(c_double), allocatable :: feet_found(:, :)
            real(c_double), allocatable :: distances_found(:)
            integer(c_int32_t), allocatable :: states_found(:)
            type(nurbs_call) :: watching
            allocate (params_found(3, 1))
            allocate (feet_found(3, 2))
            allocate (distances_found(3))
            allocate (states_found(3))
            call closest_local(g=curve, points=reshape([0.1d0, 0.9d0, 0.3d0, 0.7d0, 0.2d0, 0.6d0], [3, 2], order=[2, &
                1]), guesses=reshape([0.1d0, 0.9d0, 0.3d0], [3, 1], order=[2, 1]), params=params_found, &
                feet=feet_found, distances=distances_found, states=states_found, flags=0, call=watching)
            call show('params', flat(reshape(params_found, [size(params_found, 2), size(params_found, 1)], order=[2, &
                1])))
            call show('feet', flat(reshape(feet_found, [size(feet_found, 2), size(feet_found, 1)], order=[2, 1])))
            call show('distances', distances_found)
            call show('status', states_found)
        end block
        call begin('closest_local_with params')
        block
            real(c_double), allocatable :: params_found(:, :)
            type(nurbs_call) :: watching
            allocate (params_found(1, 1))
            call closest_local(g=curve, points=reshape([0.1d0, 0.9d0], [1, 2], order=[2, 1]), &
                guesses=reshape([0.1d0], [1, 1], order=[2, 1]), params=params_found, flags=0, call=watching)
            call show('params', flat(reshape(params_found, [size(params_found, 2), size(params_found, 1)], order=[2, &
                1])))
        end block
        call begin('curve_signed_distances_with')
        block
            real(c_double), allocatable :: distances_found(:)
            real(c_double), allocatable :: params_found(:)
            integer(c_int32_t), allocatable :: states_found(:)
            type(nurbs_call) :: watching
            allocate (distances_found(3))
            allocate (params_found(3))
            allocate (states_found(3))
            call signed_distances(g=curve, points=reshape([0.1d0, 0.9d0, 0.3d0, 0.7d0, 0.2d0, 0.6d0], [3, 2], &
                order=[2, 1]), distances=distances_found, params=params_found, states=states_found, tolerance=0.0d0, &
                budget=0, flags=0, call=watching)
            call show('distances', distances_found)
            call show('params', params_found)
            call show('status', states_found)
        end block
        call begin('curve_signed_distances_with alone')
        block
            real(c_double), allocatable :: distances_found(:)
            type(nurbs_call) :: watching
            allocate (distances_found(1))
            call signed_distances(g=curve, points=reshape([0.1d0, 0.9d0], [1, 2], order=[2, 1]), &
                distances=distances_found, tolerance=0.0d0, budget=0, flags=0, call=watching)
            call show('distances', distances_found)
        end block
        call begin('closest_all_with')
        block
            real(c_double), allocatable :: params_found(:, :)
            real(c_double), allocatable :: distances_found(:)
            integer(c_int32_t) :: state_found
            type(nurbs_call) :: watching
            call closest_all(g=curve, point=[0.1d0, 0.9d0], params=params_found, distances=distances_found, &
                state=state_found, tolerance=0.0d0, budget=0, call=watching)
            call show('params', flat(reshape(params_found, [size(params_found, 2), size(params_found, 1)], order=[2, &
                1])))
            call show('distances', distances_found)
            call show('status', state_found)
        end block
        call begin('closest_all_with inside')
        block
            real(c_double), allocatable :: params_found(:, :)
            real(c_double), allocatable :: distances_found(:)
            integer(c_int32_t) :: state_found
            type(nurbs_call) :: watching
            call closest_all(g=curve, point=[0.1d0, 0.9d0], params=params_found, distances=distances_found, &
                state=state_found, range=reshape([0.0d0, 1.0d0], [2, 1]), tolerance=0.0d0, budget=0, call=watching)
            call show('params', flat(reshape(params_found, [size(params_found, 2), size(params_found, 1)], order=[2, &
                1])))
            call show('distances', distances_found)
            call show('status', state_found)
        end block
        call begin('critical_points_with')
        block
            real(c_double), allocatable :: params_found(:, :)
            real(c_double), allocatable :: distances_found(:)
            integer(c_int32_t), allocatable :: kinds_found(:)
            integer(c_int32_t) :: state_found
            type(nurbs_call) :: watching
            call critical_points(g=curve, point=[0.1d0, 0.9d0], params=params_found, distances=distances_found, &
                kinds=kinds_found, state=state_found, tolerance=0.0d0, budget=0, call=watching)
            call show('params', flat(reshape(params_found, [size(params_found, 2), size(params_found, 1)], order=[2, &
                1])))
            call show('distances', distances_found)
            call show('kinds', kinds_found)
            call show('status', state_found)
        end block
        call begin('critical_points_with inside')
        block
            real(c_double), allocatable :: params_found(:, :)
            real(c_double), allocatable :: distances_found(:)
            integer(c_int32_t), allocatable :: kinds_found(:)
            integer(c_int32_t) :: state_found
            type(nurbs_call) :: watching
            call critical_points(g=curve, point=[0.1d0, 0.9d0], params=params_found, distances=distances_found, &
                kinds=kinds_found, state=state_found, range=reshape([0.0d0, 1.0d0], [2, 1]), tolerance=0.0d0, &
                budget=0, call=watching)
            call show('params', flat(reshape(params_found, [size(params_found, 2), size(params_found, 1)], order=[2, &
                1])))
            call show('distances', distances_found)
            call show('kinds', kinds_found)
            call show('status', state_found)
        end block
        call begin('distance_with')
        block
            real(c_double) :: at_least_found
            real(c_double) :: at_most_found
            real(c_double), allocatable :: params_a_found(:)
            real(c_double), allocatable :: params_b_found(:)
            integer(c_int32_t) :: state_found
            type(nurbs_call) :: watching
            allocate (params_a_found(1))
            allocate (params_b_found(1))
            call spline_distance(a=curve, b=loop, tolerance=1d-06, at_least=at_least_found, at_most=at_most_found, &
                params_a=params_a_found, params_b=params_b_found, state=state_found, budget=0, call=watching)
            call show('at_least', at_least_found)
            call show('at_most', at_most_found)
            call show('params_a', params_a_found)
            call show('params_b', params_b_found)
            call show('status', state_found)
        end block
        call begin('hausdorff_distance_with')
        block
            real(c_double), allocatable :: at_least_found(:)
            real(c_double), allocatable :: at_most_found(:)
            real(c_double), allocatable :: params_a_found(:)
            real(c_double), allocatable :: params_b_found(:)
            integer(c_int32_t) :: state_found
            type(nurbs_call) :: watching
            allocate (at_least_found(2))
            allocate (at_most_found(2))
            allocate (params_a_found(1))
            allocate (params_b_found(1))
            call hausdorff_distance(a=curve, b=loop, tolerance=0.1d0, at_least=at_least_found, at_most=at_most_found, &
                params_a=params_a_found, params_b=params_b_found, state=state_found, budget=0, call=watching)
            call show('at_least', at_least_found)
            call show('at_most', at_most_found)
            call show('params_a', params_a_found)
            call show('params_b', params_b_found)
            call show('status', state_found)
        end block
        call begin('curve_features_with count')
        block
            real(c_double), allocatable :: params_found(:)
            integer(c_int32_t), allocatable :: found_found(:)
            real(c_double), allocatable :: values_found(:)
            logical :: complete_found
            type(nurbs_call) :: watching
            call curve_features(g=twist, kinds=127, params=params_found, found=found_found, values=values_found, &
                complete=complete_found, call=watching)
            call show('params', params_found)
            call show('found', found_found)
            call show('values', values_found)
            call show('complete', complete_found)
        end block
        call begin('curve_features_with periodic')
        block
            real(c_double), allocatable :: params_found(:)
            integer(c_int32_t), allocatable :: found_found(:)
            real(c_double), allocatable :: values_found(:)
            logical :: complete_found
            type(nurbs_call) :: watching
            call curve_features(g=loop, kinds=63, params=params_found, found=found_found, values=values_found, &
                complete=complete_found, call=watching)
            call show('params', params_found)
            call show('found', found_found)
            call show('values', values_found)
            call show('complete', complete_found)
        end block
        call begin('extrema_with')
        block
            type(nurbs_spline) :: heights
            real(c_double), allocatable :: params_found(:, :)
            real(c_double), allocatable :: values_found(:)
            integer(c_int32_t), allocatable :: found_found(:)
            real(c_double), allocatable :: boxes_found(:, :, :)
            logical :: complete_found
            type(nurbs_call) :: watching
            call heights%create(degrees=[1, 1], counts=[2, 2], knots=[0.0d0, 0.0d0, 1.0d0, 1.0d0, 0.0d0, 0.0d0, 3.0d0, &
                3.0d0], points=reshape([0.0d0, 1.0d0, 1.0d0, 2.0d0], [4, 1], order=[2, 1]), flags=0)
            call extrema(g=heights, kinds=31, params=params_found, values=values_found, found=found_found, &
                boxes=boxes_found, complete=complete_found, call=watching)
            call show('params', flat(reshape(params_found, [size(params_found, 2), size(params_found, 1)], order=[2, &
                1])))
            call show('values', values_found)
            call show('found', found_found)
            call show('boxes', flat(boxes_found))
            call show('complete', complete_found)
        end block
        call begin('extrema_with count')
        block
            type(nurbs_spline) :: ramp
            real(c_double), allocatable :: params_found(:, :)
            real(c_double), allocatable :: values_found(:)
            integer(c_int32_t), allocatable :: found_found(:)
            real(c_double), allocatable :: boxes_found(:, :, :)
            logical :: complete_found
            type(nurbs_call) :: watching
            call ramp%create_bezier(degrees=[2], points=reshape([0.0d0, 0.25d0, 1.0d0], [3, 1], order=[2, 1]))
            call extrema(g=ramp, kinds=3, params=params_found, values=values_found, found=found_found, &
                boxes=boxes_found, complete=complete_found, call=watching)
            call show('params', flat(reshape(params_found, [size(params_found, 2), size(params_found, 1)], order=[2, &
                1])))
            call show('values', values_found)
            call show('found', found_found)
            call show('boxes', flat(boxes_found))
            call show('complete', complete_found)
        end block
        call begin('mesh_curve_with')
        block
            real(c_double), allocatable :: params_found(:)
            real(c_double), allocatable :: points_found(:, :)
            real(c_double) :: bound_found
            logical :: reached_found
            type(nurbs_call) :: watching
            call mesh_curve(g=curve, chord=1.0d0, params=params_found, points=points_found, bound=bound_found, &
                reached=reached_found, angle=2.0d0, longest=3.0d0, call=watching)
            call show('params', params_found)
            call show('points', flat(reshape(points_found, [size(points_found, 2), size(points_found, 1)], order=[2, &
                1])))
            call show('bound', bound_found)
            call show('reached', reached_found)
        end block
        call begin('mesh_curve_with count')
        block
            real(c_double), allocatable :: params_found(:)
            real(c_double), allocatable :: points_found(:, :)
            real(c_double) :: bound_found
            logical :: reached_found
            type(nurbs_call) :: watching
            call mesh_curve(g=loop, chord=0.5d0, params=params_found, points=points_found, bound=bound_found, &
                reached=reached_found, angle=0.0d0, longest=0.0d0, call=watching)
            call show('params', params_found)
            call show('points', flat(reshape(points_found, [size(points_found, 2), size(points_found, 1)], order=[2, &
                1])))
            call show('bound', bound_found)
            call show('reached', reached_found)
        end block
        call begin('fold_test_with')
        block
            integer(c_int32_t) :: fold_found
            real(c_double), allocatable :: positive_found(:)
            real(c_double), allocatable :: negative_found(:)
            type(nurbs_call) :: watching
            allocate (positive_found(2))
            allocate (negative_found(2))
            call fold_test(g=surface, fold=fold_found, positive=positive_found, negative=negative_found, call=watching)
            call show('result', fold_found)
            call show('positive', positive_found)
            call show('negative', negative_found)
        end block
        call begin('fold_pieces_with')
        block
            integer(c_int32_t), allocatable :: folds_found(:)
            integer(c_int32_t), allocatable :: signs_found(:)
            type(nurbs_call) :: watching
            call fold_pieces(g=surface, folds=folds_found, signs=signs_found, call=watching)
            call show('folds', folds_found)
            call show('signs', signs_found)
        end block
        call begin('roots_with')
        block
            type(nurbs_spline) :: ramp
            real(c_double), allocatable :: params_found(:)
            integer(c_int32_t), allocatable :: kinds_found(:)
            real(c_double), allocatable :: ranges_found(:, :)
            logical :: complete_found
            type(nurbs_call) :: watching
            call ramp%create_bezier(degrees=[2], points=reshape([0.0d0, 0.25d0, 1.0d0], [3, 1], order=[2, 1]))
            call roots(g=ramp, params=params_found, kinds=kinds_found, ranges=ranges_found, complete=complete_found, &
                value=0.5d0, tolerance=0.0d0, call=watching)
            call show('params', params_found)
            call show('kinds', kinds_found)
            call show('ranges', flat(reshape(ranges_found, [size(ranges_found, 2), size(ranges_found, 1)], order=[2, &
                1])))
            call show('complete', complete_found)
        end block
        call begin('roots_with count')
        block
            type(nurbs_spline) :: round
            real(c_double), allocatable :: params_found(:)
            integer(c_int32_t), allocatable :: kinds_found(:)
            real(c_double), allocatable :: ranges_found(:, :)
            logical :: complete_found
            type(nurbs_call) :: watching
            call round%create_bezier(degrees=[2], points=reshape([0.0d0, 2.0d0, 9.0d0], [3, 1], order=[2, 1]))
            call roots(g=round, params=params_found, kinds=kinds_found, ranges=ranges_found, complete=complete_found, &
                value=3.0d0, tolerance=1d-09, call=watching)
            call show('params', params_found)
            call show('kinds', kinds_found)
            call show('ranges', flat(reshape(ranges_found, [size(ranges_found, 2), size(ranges_found, 1)], order=[2, &
                1])))
            call show('complete', complete_found)
        end block
        call begin('curve_level_with')
        block
            real(c_double), allocatable :: params_found(:)
            integer(c_int32_t), allocatable :: kinds_found(:)
            real(c_double), allocatable :: ranges_found(:, :)
            logical :: complete_found
            type(nurbs_call) :: watching
            call curve_level(g=curve, degree=1, coefficients=[0.1d0, 0.9d0, -0.3d0], params=params_found, &
                kinds=kinds_found, ranges=ranges_found, complete=complete_found, tolerance=1d-09, call=watching)
            call show('params', params_found)
            call show('kinds', kinds_found)
            call show('ranges', flat(reshape(ranges_found, [size(ranges_found, 2), size(ranges_found, 1)], order=[2, &
                1])))
            call show('complete', complete_found)
        end block
        call begin('surface_rays_with')
        block
            real(c_double), allocatable :: params_found(:, :)
            real(c_double), allocatable :: distances_found(:)
            integer(c_int32_t), allocatable :: states_found(:)
            type(nurbs_call) :: watching
            allocate (params_found(2, 2))
            allocate (distances_found(2))
            allocate (states_found(2))
            call rays(g=surface, origins=reshape([0.1d0, 0.2d0, 5.0d0, 0.3d0, 0.4d0, 6.0d0], [2, 3], order=[2, 1]), &
                directions=reshape([0.0d0, 0.0d0, -1.0d0, 0.1d0, 0.1d0, -1.0d0], [2, 3], order=[2, 1]), &
                params=params_found, distances=distances_found, states=states_found, call=watching)
            call show('params', flat(reshape(params_found, [size(params_found, 2), size(params_found, 1)], order=[2, &
                1])))
            call show('distances', distances_found)
            call show('status', states_found)
        end block
        call begin('surface_rays_with distances')
        block
            real(c_double), allocatable :: distances_found(:)
            type(nurbs_call) :: watching
            allocate (distances_found(1))
            call rays(g=surface, origins=reshape([0.1d0, 0.2d0, 5.0d0], [1, 3], order=[2, 1]), &
                directions=reshape([0.0d0, 0.0d0, -1.0d0], [1, 3], order=[2, 1]), distances=distances_found, &
                call=watching)
            call show('distances', distances_found)
        end block
        call begin('surfaces_common_points_with')
        block
            type(nurbs_spline) :: wall
            type(nurbs_spline) :: sphere
            real(c_double), allocatable :: params_found(:, :)
            real(c_double), allocatable :: points_found(:, :)
            integer(c_int32_t), allocatable :: kinds_found(:)
            real(c_double), allocatable :: ranges_found(:, :, :)
            logical :: complete_found
            type(nurbs_call) :: watching
            call wall%create_bezier(degrees=[1, 1], points=reshape([0.3d0, -1.0d0, -1.0d0, 0.3d0, -1.0d0, 9.0d0, &
                0.4d0, 9.0d0, -1.0d0, 0.4d0, 9.0d0, 9.0d0], [4, 3], order=[2, 1]))
            call create_sphere(out=sphere, radius=1.0d0, form=0)
            call common_points(a=wall, b=surface, c=sphere, params=params_found, points=points_found, &
                kinds=kinds_found, ranges=ranges_found, complete=complete_found, tolerance=0.001d0, call=watching)
            call show('params', flat(reshape(params_found, [size(params_found, 2), size(params_found, 1)], order=[2, &
                1])))
            call show('points', flat(reshape(points_found, [size(points_found, 2), size(points_found, 1)], order=[2, &
                1])))
            call show('kinds', kinds_found)
            call show('ranges', flat(reshape(ranges_found, [size(ranges_found, 2), size(ranges_found, 3), &
                size(ranges_found, 1)], order=[3, 1, 2])))
            call show('complete', complete_found)
        end block
        call begin('curve_surface_intersections_with')
        block
            type(nurbs_spline) :: sphere
            real(c_double), allocatable :: params_curve_found(:)
            real(c_double), allocatable :: params_surface_found(:, :)
            integer(c_int32_t), allocatable :: kinds_found(:)
            real(c_double), allocatable :: ranges_curve_found(:, :)
            real(c_double), allocatable :: ranges_surface_found(:, :, :)
            logical :: complete_found
            type(nurbs_call) :: watching
            call create_sphere(out=sphere, radius=1.0d0, form=0)
            call surface_intersections(curve=twist, surface=sphere, params_curve=params_curve_found, &
                params_surface=params_surface_found, kinds=kinds_found, ranges_curve=ranges_curve_found, &
                ranges_surface=ranges_surface_found, complete=complete_found, tolerance=1d-09, call=watching)
            call show('params_curve', params_curve_found)
            call show('params_surface', flat(reshape(params_surface_found, [size(params_surface_found, 2), &
                size(params_surface_found, 1)], order=[2, 1])))
            call show('kinds', kinds_found)
            call show('ranges_curve', flat(reshape(ranges_curve_found, [size(ranges_curve_found, 2), &
                size(ranges_curve_found, 1)], order=[2, 1])))
            call show('ranges_surface', flat(ranges_surface_found))
            call show('complete', complete_found)
        end block
        call begin('face_rays_with')
        block
            real(c_double), allocatable :: params_found(:, :)
            real(c_double), allocatable :: distances_found(:)
            integer(c_int32_t), allocatable :: states_found(:)
            type(nurbs_call) :: watching
            allocate (params_found(2, 2))
            allocate (distances_found(2))
            allocate (states_found(2))
            call face%rays(origins=reshape([0.5d0, 1.2d0, 9.0d0, 0.3d0, 0.4d0, 6.0d0], [2, 3], order=[2, 1]), &
                directions=reshape([0.0d0, 0.0d0, -1.0d0, 0.1d0, 0.1d0, -1.0d0], [2, 3], order=[2, 1]), &
                params=params_found, distances=distances_found, states=states_found, call=watching)
            call show('params', flat(reshape(params_found, [size(params_found, 2), size(params_found, 1)], order=[2, &
                1])))
            call show('distances', distances_found)
            call show('status', states_found)
        end block
        call begin('face_rays_with distances')
        block
            real(c_double), allocatable :: distances_found(:)
            type(nurbs_call) :: watching
            allocate (distances_found(1))
            call face%rays(origins=reshape([0.5d0, 1.2d0, 9.0d0], [1, 3], order=[2, 1]), &
                directions=reshape([0.0d0, 0.0d0, -1.0d0], [1, 3], order=[2, 1]), distances=distances_found, &
                call=watching)
            call show('distances', distances_found)
        end block
        call begin('face_closest_points_with')
        block
            real(c_double), allocatable :: params_found(:, :)
            real(c_double), allocatable :: feet_found(:, :)
            real(c_double), allocatable :: distances_found(:)
            integer(c_int32_t), allocatable :: states_found(:)
            type(nurbs_call) :: watching
            allocate (params_found(2, 2))
            allocate (feet_found(2, 3))
            allocate (distances_found(2))
            allocate (states_found(2))
            call face%closest_points(points=reshape([0.5d0, 1.2d0, 9.0d0, 0.3d0, 0.4d0, 6.0d0], [2, 3], order=[2, 1]), &
                params=params_found, feet=feet_found, distances=distances_found, states=states_found, tolerance=1d-06, &
                call=watching)
            call show('params', flat(reshape(params_found, [size(params_found, 2), size(params_found, 1)], order=[2, &
                1])))
            call show('feet', flat(reshape(feet_found, [size(feet_found, 2), size(feet_found, 1)], order=[2, 1])))
            call show('distances', distances_found)
            call show('status', states_found)
        end block
        call begin('face_closest_points_with alone')
        block
            real(c_double), allocatable :: distances_found(:)
            type(nurbs_call) :: watching
            allocate (distances_found(1))
            call face%closest_points(points=reshape([0.1d0, 0.2d0, 0.3d0], [1, 3], order=[2, 1]), &
                distances=distances_found, tolerance=0.0d0, call=watching)
            call show('distances', distances_found)
        end block
        call begin('face_distance_with')
        block
            type(nurbs_spline) :: sphere
            type(nurbs_face) :: ball_face
            real(c_double) :: at_least_found
            real(c_double) :: at_most_found
            real(c_double), allocatable :: params_a_found(:)
            real(c_double), allocatable :: params_b_found(:)
            integer(c_int32_t) :: state_found
            type(nurbs_call) :: watching
            call create_sphere(out=sphere, radius=1.0d0, form=0)
            call ball_face%create(surface=sphere, sizes=[integer(c_int32_t) ::], tolerance=1d-09, flags=0)
            allocate (params_a_found(2))
            allocate (params_b_found(2))
            call face%distance(other=ball_face, at_least=at_least_found, at_most=at_most_found, &
                params_a=params_a_found, params_b=params_b_found, state=state_found, tolerance=4.0d0, call=watching)
            call show('at_least', at_least_found)
            call show('at_most', at_most_found)
            call show('params_a', params_a_found)
            call show('params_b', params_b_found)
            call show('status', state_found)
        end block
        call begin('face_hausdorff_distance_with')
        block
            type(nurbs_spline) :: sphere
            type(nurbs_face) :: ball_face
            real(c_double), allocatable :: at_least_found(:)
            real(c_double), allocatable :: at_most_found(:)
            real(c_double), allocatable :: params_a_found(:)
            real(c_double), allocatable :: params_b_found(:)
            integer(c_int32_t) :: state_found
            type(nurbs_call) :: watching
            call create_sphere(out=sphere, radius=1.0d0, form=0)
            call ball_face%create(surface=sphere, sizes=[integer(c_int32_t) ::], tolerance=1d-09, flags=0)
            allocate (at_least_found(2))
            allocate (at_most_found(2))
            allocate (params_a_found(2))
            allocate (params_b_found(2))
            call face%hausdorff_distance(other=ball_face, tolerance=4.0d0, at_least=at_least_found, &
                at_most=at_most_found, params_a=params_a_found, params_b=params_b_found, state=state_found, &
                call=watching)
            call show('at_least', at_least_found)
            call show('at_most', at_most_found)
            call show('params_a', params_a_found)
            call show('params_b', params_b_found)
            call show('status', state_found)
        end block
        call begin('model_rays_with')
        block
            real(c_double), allocatable :: params_found(:, :)
            real(c_double), allocatable :: distances_found(:)
            integer(c_int32_t), allocatable :: states_found(:)
            integer(c_int64_t), allocatable :: places_found(:, :)
            type(nurbs_call) :: watching
            allocate (params_found(2, 2))
            allocate (distances_found(2))
            allocate (states_found(2))
            allocate (places_found(2, 2))
            call model%rays(origins=reshape([0.5d0, 1.2d0, 9.0d0, 0.3d0, 0.4d0, 6.0d0], [2, 3], order=[2, 1]), &
                directions=reshape([0.0d0, 0.0d0, -1.0d0, 0.1d0, 0.1d0, -1.0d0], [2, 3], order=[2, 1]), &
                params=params_found, distances=distances_found, states=states_found, places=places_found, call=watching)
            call show('params', flat(reshape(params_found, [size(params_found, 2), size(params_found, 1)], order=[2, &
                1])))
            call show('distances', distances_found)
            call show('status', states_found)
            call show('places', flat(reshape(places_found, [size(places_found, 2), size(places_found, 1)], order=[2, &
                1])) - 1)
        end block
        call begin('model_rays_with places')
        block
            type(nurbs_spline) :: sphere
            type(nurbs_face) :: ball_face
            type(nurbs_model) :: ball
            type(nurbs_face) :: faces_given(1)
            real(c_double), allocatable :: distances_found(:)
            integer(c_int64_t), allocatable :: places_found(:, :)
            type(nurbs_call) :: watching
            call create_sphere(out=sphere, radius=1.0d0, form=0)
            call ball_face%create(surface=sphere, sizes=[integer(c_int32_t) ::], tolerance=1d-09, flags=0)
            faces_given(1) = ball_face
            call ball%create(faces=faces_given, metres=1.0d0)
            allocate (distances_found(1))
            allocate (places_found(1, 2))
            call ball%rays(origins=reshape([0.1d0, 0.2d0, 5.0d0], [1, 3], order=[2, 1]), &
                directions=reshape([0.0d0, 0.0d0, -1.0d0], [1, 3], order=[2, 1]), distances=distances_found, &
                places=places_found, call=watching)
            call show('distances', distances_found)
            call show('places', flat(reshape(places_found, [size(places_found, 2), size(places_found, 1)], order=[2, &
                1])) - 1)
        end block
        call begin('model_ray_hits_with within')
        block
            real(c_double), allocatable :: params_found(:, :)
            real(c_double), allocatable :: distances_found(:)
            integer(c_int32_t), allocatable :: kinds_found(:)
            integer(c_int64_t), allocatable :: places_found(:, :)
            logical :: complete_found
            type(nurbs_call) :: watching
            call model%ray_hits(origin=[0.5d0, 1.2d0, 9.0d0], direction=[0.0d0, 0.0d0, -1.0d0], params=params_found, &
                distances=distances_found, kinds=kinds_found, places=places_found, complete=complete_found, &
                range=[-1.0d0, 20.0d0], call=watching)
            call show('params', flat(reshape(params_found, [size(params_found, 2), size(params_found, 1)], order=[2, &
                1])))
            call show('distances', distances_found)
            call show('kinds', kinds_found)
            call show('places', flat(reshape(places_found, [size(places_found, 2), size(places_found, 1)], order=[2, &
                1])) - 1)
            call show('complete', complete_found)
        end block
        call begin('model_ray_hits_with')
        block
            type(nurbs_spline) :: sphere
            type(nurbs_face) :: ball_face
            type(nurbs_model) :: ball
            type(nurbs_face) :: faces_given(1)
            real(c_double), allocatable :: params_found(:, :)
            real(c_double), allocatable :: distances_found(:)
            integer(c_int32_t), allocatable :: kinds_found(:)
            integer(c_int64_t), allocatable :: places_found(:, :)
            logical :: complete_found
            type(nurbs_call) :: watching
            call create_sphere(out=sphere, radius=1.0d0, form=0)
            call ball_face%create(surface=sphere, sizes=[integer(c_int32_t) ::], tolerance=1d-09, flags=0)
            faces_given(1) = ball_face
            call ball%create(faces=faces_given, metres=1.0d0)
            call ball%ray_hits(origin=[0.1d0, 0.2d0, 5.0d0], direction=[0.0d0, 0.0d0, -1.0d0], params=params_found, &
                distances=distances_found, kinds=kinds_found, places=places_found, complete=complete_found, &
                call=watching)
            call show('params', flat(reshape(params_found, [size(params_found, 2), size(params_found, 1)], order=[2, &
                1])))
            call show('distances', distances_found)
            call show('kinds', kinds_found)
            call show('places', flat(reshape(places_found, [size(places_found, 2), size(places_found, 1)], order=[2, &
                1])) - 1)
            call show('complete', complete_found)
        end block
        call begin('model_closest_points_with')
        block
            real(c_double), allocatable :: params_found(:, :)
            real(c_double), allocatable :: feet_found(:, :)
            real(c_double), allocatable :: distances_found(:)
            integer(c_int32_t), allocatable :: states_found(:)
            integer(c_int64_t), allocatable :: places_found(:, :)
            type(nurbs_call) :: watching
            allocate (params_found(2, 2))
            allocate (feet_found(2, 3))
            allocate (distances_found(2))
            allocate (states_found(2))
            allocate (places_found(2, 2))
            call model%closest_points(points=reshape([0.5d0, 1.2d0, 9.0d0, 0.3d0, 0.4d0, 6.0d0], [2, 3], order=[2, &
                1]), params=params_found, feet=feet_found, distances=distances_found, states=states_found, &
                places=places_found, tolerance=1d-06, call=watching)
            call show('params', flat(reshape(params_found, [size(params_found, 2), size(params_found, 1)], order=[2, &
                1])))
            call show('feet', flat(reshape(feet_found, [size(feet_found, 2), size(feet_found, 1)], order=[2, 1])))
            call show('distances', distances_found)
            call show('status', states_found)
            call show('places', flat(reshape(places_found, [size(places_found, 2), size(places_found, 1)], order=[2, &
                1])) - 1)
        end block
        call begin('model_closest_points_with alone')
        block
            type(nurbs_spline) :: sphere
            type(nurbs_face) :: ball_face
            type(nurbs_model) :: ball
            type(nurbs_face) :: faces_given(1)
            real(c_double), allocatable :: distances_found(:)
            integer(c_int64_t), allocatable :: places_found(:, :)
            type(nurbs_call) :: watching
            call create_sphere(out=sphere, radius=1.0d0, form=0)
            call ball_face%create(surface=sphere, sizes=[integer(c_int32_t) ::], tolerance=1d-09, flags=0)
            faces_given(1) = ball_face
            call ball%create(faces=faces_given, metres=1.0d0)
            allocate (distances_found(1))
            allocate (places_found(1, 2))
            call ball%closest_points(points=reshape([0.1d0, 0.2d0, 3.0d0], [1, 3], order=[2, 1]), &
                distances=distances_found, places=places_found, tolerance=0.0d0, call=watching)
            call show('distances', distances_found)
            call show('places', flat(reshape(places_found, [size(places_found, 2), size(places_found, 1)], order=[2, &
                1])) - 1)
        end block
        call begin('model_classify_with')
        block
            type(nurbs_spline) :: sphere
            type(nurbs_face) :: ball_face
            type(nurbs_model) :: ball
            type(nurbs_face) :: faces_given(1)
            integer(c_int32_t), allocatable :: sides_found(:)
            type(nurbs_call) :: watching
            call create_sphere(out=sphere, radius=1.0d0, form=0)
            call ball_face%create(surface=sphere, sizes=[integer(c_int32_t) ::], tolerance=1d-09, flags=0)
            faces_given(1) = ball_face
            call ball%create(faces=faces_given, metres=1.0d0)
            allocate (sides_found(2))
            call ball%classify(points=reshape([0.1d0, 0.2d0, 0.3d0, 1.0d0, 1.0d0, 1.0d0], [2, 3], order=[2, 1]), &
                sides=sides_found, tolerance=0.0d0, call=watching)
            call show('sides', sides_found)
        end block
        call begin('model_classify_with near')
        block
            type(nurbs_spline) :: sphere
            type(nurbs_face) :: ball_face
            type(nurbs_model) :: ball
            type(nurbs_face) :: faces_given(1)
            integer(c_int32_t), allocatable :: sides_found(:)
            type(nurbs_call) :: watching
            call create_sphere(out=sphere, radius=1.0d0, form=0)
            call ball_face%create(surface=sphere, sizes=[integer(c_int32_t) ::], tolerance=1d-09, flags=0)
            faces_given(1) = ball_face
            call ball%create(faces=faces_given, metres=1.0d0)
            allocate (sides_found(2))
            call ball%classify(points=reshape([0.1d0, 0.2d0, 0.3d0, 0.0d0, 0.6d0, 0.8d0], [2, 3], order=[2, 1]), &
                sides=sides_found, tolerance=0.001d0, call=watching)
            call show('sides', sides_found)
        end block
        call begin('model_area_with')
        block
            type(nurbs_spline) :: sphere
            type(nurbs_face) :: ball_face
            type(nurbs_model) :: ball
            type(nurbs_face) :: faces_given(1)
            real(c_double) :: area_found
            real(c_double) :: error_found
            type(nurbs_call) :: watching
            call create_sphere(out=sphere, radius=1.0d0, form=0)
            call ball_face%create(surface=sphere, sizes=[integer(c_int32_t) ::], tolerance=1d-09, flags=0)
            faces_given(1) = ball_face
            call ball%create(faces=faces_given, metres=1.0d0)
            call ball%get_area(area=area_found, error=error_found, tolerance=1d-06, call=watching)
            call show('area', area_found)
            call show('error', error_found)
        end block
        call begin('model_volume_with')
        block
            type(nurbs_spline) :: sphere
            type(nurbs_face) :: ball_face
            type(nurbs_model) :: ball
            type(nurbs_face) :: faces_given(1)
            real(c_double) :: volume_found
            real(c_double), allocatable :: centroid_found(:)
            real(c_double), allocatable :: inertia_found(:, :)
            real(c_double) :: openness_found
            real(c_double) :: error_found
            type(nurbs_call) :: watching
            call create_sphere(out=sphere, radius=1.0d0, form=0)
            call ball_face%create(surface=sphere, sizes=[integer(c_int32_t) ::], tolerance=1d-09, flags=0)
            faces_given(1) = ball_face
            call ball%create(faces=faces_given, metres=1.0d0)
            allocate (centroid_found(3))
            allocate (inertia_found(3, 3))
            call ball%get_volume(volume=volume_found, centroid=centroid_found, inertia=inertia_found, &
                openness=openness_found, error=error_found, tolerance=1d-06, call=watching)
            call show('volume', volume_found)
            call show('centroid', centroid_found)
            call show('inertia', flat(inertia_found))
            call show('openness', openness_found)
            call show('error', error_found)
        end block
        call begin('model_volume_with alone')
        block
            type(nurbs_spline) :: sphere
            type(nurbs_face) :: ball_face
            type(nurbs_model) :: ball
            type(nurbs_face) :: faces_given(1)
            real(c_double) :: volume_found
            real(c_double) :: error_found
            type(nurbs_call) :: watching
            call create_sphere(out=sphere, radius=1.0d0, form=0)
            call ball_face%create(surface=sphere, sizes=[integer(c_int32_t) ::], tolerance=1d-09, flags=0)
            faces_given(1) = ball_face
            call ball%create(faces=faces_given, metres=1.0d0)
            call ball%get_volume(volume=volume_found, error=error_found, tolerance=1d-06, call=watching)
            call show('volume', volume_found)
            call show('error', error_found)
        end block
        call begin('curve_self_intersections_with')
        block
            real(c_double), allocatable :: params_a_found(:)
            real(c_double), allocatable :: params_b_found(:)
            integer(c_int32_t), allocatable :: kinds_found(:)
            real(c_double), allocatable :: ranges_a_found(:, :)
            real(c_double), allocatable :: ranges_b_found(:, :)
            logical :: complete_found
            type(nurbs_call) :: watching
            call self_intersections(g=curve, params_a=params_a_found, params_b=params_b_found, kinds=kinds_found, &
                ranges_a=ranges_a_found, ranges_b=ranges_b_found, complete=complete_found, tolerance=1d-09, &
                call=watching)
            call show('params_a', params_a_found)
            call show('params_b', params_b_found)
            call show('kinds', kinds_found)
            call show('ranges_a', flat(reshape(ranges_a_found, [size(ranges_a_found, 2), size(ranges_a_found, 1)], &
                order=[2, 1])))
            call show('ranges_b', flat(reshape(ranges_b_found, [size(ranges_b_found, 2), size(ranges_b_found, 1)], &
                order=[2, 1])))
            call show('complete', complete_found)
        end block
        call begin('curve_intersections_with')
        block
            real(c_double), allocatable :: params_a_found(:)
            real(c_double), allocatable :: params_b_found(:)
            integer(c_int32_t), allocatable :: kinds_found(:)
            real(c_double), allocatable :: ranges_a_found(:, :)
            real(c_double), allocatable :: ranges_b_found(:, :)
            logical :: complete_found
            type(nurbs_call) :: watching
            call curve_intersections(a=curve, b=segment, params_a=params_a_found, params_b=params_b_found, &
                kinds=kinds_found, ranges_a=ranges_a_found, ranges_b=ranges_b_found, complete=complete_found, &
                tolerance=1d-09, call=watching)
            call show('params_a', params_a_found)
            call show('params_b', params_b_found)
            call show('kinds', kinds_found)
            call show('ranges_a', flat(reshape(ranges_a_found, [size(ranges_a_found, 2), size(ranges_a_found, 1)], &
                order=[2, 1])))
            call show('ranges_b', flat(reshape(ranges_b_found, [size(ranges_b_found, 2), size(ranges_b_found, 1)], &
                order=[2, 1])))
            call show('complete', complete_found)
        end block
        call begin('curve_level_with conic')
        block
            real(c_double), allocatable :: params_found(:)
            integer(c_int32_t), allocatable :: kinds_found(:)
            real(c_double), allocatable :: ranges_found(:, :)
            logical :: complete_found
            type(nurbs_call) :: watching
            call curve_level(g=loop, degree=2, coefficients=[1.0d0, 0.0d0, 0.0d0, 1.0d0, 0.0d0, -0.5d0], &
                params=params_found, kinds=kinds_found, ranges=ranges_found, complete=complete_found, tolerance=0.0d0, &
                call=watching)
            call show('params', params_found)
            call show('kinds', kinds_found)
            call show('ranges', flat(reshape(ranges_found, [size(ranges_found, 2), size(ranges_found, 1)], order=[2, &
                1])))
            call show('complete', complete_found)
        end block
        call begin('fold_test_with seen from above')
        block
            integer(c_int32_t) :: fold_found
            real(c_double), allocatable :: positive_found(:)
            real(c_double), allocatable :: negative_found(:)
            type(nurbs_call) :: watching
            allocate (positive_found(2))
            allocate (negative_found(2))
            call fold_test(g=surface, fold=fold_found, positive=positive_found, negative=negative_found, &
                reference=[1.0d0, 2.0d0, 3.0d0], call=watching)
            call show('result', fold_found)
            call show('positive', positive_found)
            call show('negative', negative_found)
        end block
        call begin('fold_pieces_with seen from above')
        block
            integer(c_int32_t), allocatable :: folds_found(:)
            integer(c_int32_t), allocatable :: signs_found(:)
            type(nurbs_call) :: watching
            call fold_pieces(g=surface, folds=folds_found, signs=signs_found, reference=[1.0d0, 2.0d0, 3.0d0], &
                call=watching)
            call show('folds', folds_found)
            call show('signs', signs_found)
        end block
        call begin('recognize_with curve')
        block
            type(recognized_shape) :: found_found
            type(nurbs_call) :: watching
            call recognize_spline(g=curve, tolerance=1d-09, found=found_found, call=watching)
            call show('shape', found_found%shape)
            call show('placement', found_found%origin)
            call show('placement', found_found%axis)
            call show('placement', found_found%x)
            call show('sizes', found_found%sizes)
            call show('deviation', found_found%deviation)
        end block
        call begin('recognize_with surface')
        block
            type(recognized_shape) :: found_found
            type(nurbs_call) :: watching
            call recognize_spline(g=surface, tolerance=0.2d0, found=found_found, call=watching)
            call show('shape', found_found%shape)
            call show('placement', found_found%origin)
            call show('placement', found_found%axis)
            call show('placement', found_found%x)
            call show('sizes', found_found%sizes)
            call show('deviation', found_found%deviation)
        end block
        call begin('curve_length_with')
        block
            real(c_double) :: length_found
            real(c_double) :: error_found
            type(nurbs_call) :: watching
            call curve_length(g=curve, length=length_found, error=error_found, tolerance=1d-09, call=watching)
            call show('length', length_found)
            call show('error', error_found)
        end block
        call begin('curve_length_with of a part')
        block
            real(c_double) :: length_found
            real(c_double) :: error_found
            type(nurbs_call) :: watching
            call curve_length(g=curve, length=length_found, error=error_found, range=[0.3d0, 0.6d0], tolerance=1d-09, &
                call=watching)
            call show('length', length_found)
            call show('error', error_found)
        end block
        call begin('curve_lengths_with')
        block
            real(c_double), allocatable :: lengths_found(:)
            type(nurbs_call) :: watching
            allocate (lengths_found(1))
            call curve_lengths(g=loop, params=[4.0d0], lengths=lengths_found, tolerance=1d-09, call=watching)
            call show('lengths', lengths_found)
        end block
        call begin('curve_params_at_lengths_with')
        block
            real(c_double), allocatable :: params_found(:)
            type(nurbs_call) :: watching
            allocate (params_found(1))
            call params_at_lengths(g=curve, lengths=[4.0d0], params=params_found, tolerance=1d-09, flags=0, &
                call=watching)
            call show('params', params_found)
        end block
        call begin('curve_divide_with')
        block
            real(c_double), allocatable :: params_found(:)
            real(c_double) :: size_found
            type(nurbs_call) :: watching
            call divide_curve(g=curve, parts=5, params=params_found, size=size_found, tolerance=1d-09, flags=0, &
                call=watching)
            call show('params', params_found)
            call show('size', size_found)
        end block
        call begin('curve_divide_with a part')
        block
            real(c_double), allocatable :: params_found(:)
            real(c_double) :: size_found
            type(nurbs_call) :: watching
            call divide_curve(g=curve, parts=5, params=params_found, size=size_found, range=[0.3d0, 0.6d0], &
                tolerance=1d-09, flags=0, call=watching)
            call show('params', params_found)
            call show('size', size_found)
        end block
        call begin('curve_divide_with chords')
        block
            real(c_double), allocatable :: params_found(:)
            real(c_double) :: size_found
            type(nurbs_call) :: watching
            call divide_curve(g=curve, parts=5, params=params_found, size=size_found, tolerance=1d-09, flags=33554432, &
                call=watching)
            call show('params', params_found)
            call show('size', size_found)
        end block
        call begin('surface_area_with')
        block
            real(c_double) :: area_found
            real(c_double) :: error_found
            type(nurbs_call) :: watching
            call surface_area(g=surface, area=area_found, error=error_found, tolerance=1d-09, call=watching)
            call show('area', area_found)
            call show('error', error_found)
        end block
        call begin('surface_area_with of a part')
        block
            real(c_double) :: area_found
            real(c_double) :: error_found
            type(nurbs_call) :: watching
            call surface_area(g=surface, area=area_found, error=error_found, &
                range=reshape([0.0d0, 1.0d0, 0.0d0, 3.0d0], [2, 2]), tolerance=1d-09, call=watching)
            call show('area', area_found)
            call show('error', error_found)
        end block
        call begin('moments_with')
        block
            real(c_double) :: content_found
            real(c_double), allocatable :: centroid_found(:)
            real(c_double), allocatable :: inertia_found(:, :)
            real(c_double) :: error_found
            type(nurbs_call) :: watching
            allocate (centroid_found(3))
            allocate (inertia_found(3, 3))
            call spline_moments(g=surface, content=content_found, centroid=centroid_found, inertia=inertia_found, &
                error=error_found, tolerance=1d-09, call=watching)
            call show('content', content_found)
            call show('centroid', centroid_found)
            call show('inertia', flat(inertia_found))
            call show('error', error_found)
        end block
        call begin('enclosed_area_with')
        block
            type(nurbs_spline) :: curves_given(1)
            real(c_double) :: area_found
            real(c_double), allocatable :: centroid_found(:)
            real(c_double), allocatable :: inertia_found(:, :)
            real(c_double) :: error_found
            type(nurbs_call) :: watching
            curves_given(1) = loop
            allocate (centroid_found(2))
            allocate (inertia_found(2, 2))
            call enclosed_area(curves=curves_given, area=area_found, centroid=centroid_found, inertia=inertia_found, &
                error=error_found, gap=1d-09, tolerance=1d-09, call=watching)
            call show('area', area_found)
            call show('centroid', centroid_found)
            call show('inertia', flat(inertia_found))
            call show('error', error_found)
        end block
        call begin('enclosed_volume_with')
        block
            type(nurbs_spline) :: surfaces_given(1)
            real(c_double) :: volume_found
            real(c_double) :: openness_found
            real(c_double) :: error_found
            type(nurbs_call) :: watching
            surfaces_given(1) = surface
            call enclosed_volume(surfaces=surfaces_given, volume=volume_found, openness=openness_found, &
                error=error_found, tolerance=1d-09, call=watching)
            call show('volume', volume_found)
            call show('openness', openness_found)
            call show('error', error_found)
        end block
        call begin('enclosed_volume_with sphere')
        block
            type(nurbs_spline) :: sphere
            type(nurbs_spline) :: surfaces_given(1)
            real(c_double) :: volume_found
            real(c_double), allocatable :: centroid_found(:)
            real(c_double), allocatable :: inertia_found(:, :)
            real(c_double) :: openness_found
            real(c_double) :: error_found
            type(nurbs_call) :: watching
            call create_sphere(out=sphere, radius=1.0d0, form=0)
            surfaces_given(1) = sphere
            allocate (centroid_found(3))
            allocate (inertia_found(3, 3))
            call enclosed_volume(surfaces=surfaces_given, volume=volume_found, centroid=centroid_found, &
                inertia=inertia_found, openness=openness_found, error=error_found, tolerance=1d-06, call=watching)
            call show('volume', volume_found)
            call show('centroid', centroid_found)
            call show('inertia', flat(inertia_found))
            call show('openness', openness_found)
            call show('error', error_found)
        end block
    end subroutine calls_of_query

    subroutine calls_of_scalar()
        call begin('axes')
        block
            call show('axes', curve%axes())
        end block
        call begin('dimension')
        block
            call show('dim', curve%dimension())
        end block
        call begin('point_count')
        block
            call show('count', curve%point_count())
        end block
        call begin('is_rational')
        block
            call show('rational', curve%is_rational())
        end block
        call begin('is_homogeneous')
        block
            call show('homogeneous', curve%is_homogeneous())
        end block
        call begin('degree')
        block
            call show('degree', surface%degree(axis=2))
        end block
        call begin('count')
        block
            call show('count', surface%count(axis=2))
        end block
        call begin('knot_form')
        block
            call show('form', surface%knot_form(axis=2))
        end block
        call begin('domain')
        block
            call show('domain', surface%domain(axis=2))
        end block
        call begin('derivative_slots')
        block
            call show('slots', derivative_slots(axes=3, order=9))
        end block
        call begin('unwrapped_count')
        block
            call show('count', loop%unwrapped_count(axis=1))
        end block
        call begin('list_count')
        block
            call show('count', list%count())
        end block
        call begin('list_note_count')
        block
            call show('count', list%note_count())
        end block
        call begin('list_unit')
        block
            call show('metres', list%unit())
        end block
        call begin('list_name')
        block
            character(len=:), allocatable :: text_found
            call list%name(index=1, text=text_found)
            call show('buf', text_found)
        end block
        call begin('list_note')
        block
            integer(c_int32_t) :: entity_type_found
            integer(c_int64_t) :: line_found
            integer(c_int32_t) :: reason_found
            character(len=:), allocatable :: text_found
            call list%note(index=1, entity_type=entity_type_found, line=line_found, reason=reason_found, &
                text=text_found)
            call show('entity_type', entity_type_found)
            call show('line', line_found)
            call show('reason', reason_found)
            call show('buf', text_found)
        end block
        call begin('model_counts')
        block
            integer(c_int64_t) :: parts_found
            integer(c_int64_t) :: uses_found
            integer(c_int64_t) :: faces_found
            integer(c_int64_t) :: edges_found
            integer(c_int64_t) :: vertices_found
            call model%counts(parts=parts_found, uses=uses_found, faces=faces_found, edges=edges_found, &
                vertices=vertices_found)
            call show('parts', parts_found)
            call show('uses', uses_found)
            call show('faces', faces_found)
            call show('edges', edges_found)
            call show('vertices', vertices_found)
        end block
        call begin('meet_counts')
        block
            integer(c_int64_t) :: branches_found
            integer(c_int64_t) :: nodes_found
            logical :: complete_found
            call meet%counts(branches=branches_found, nodes=nodes_found, complete=complete_found)
            call show('branches', branches_found)
            call show('nodes', nodes_found)
            call show('complete', complete_found)
        end block
        call begin('mesh_counts')
        block
            integer(c_int64_t) :: points_found
            integer(c_int64_t) :: vertices_found
            integer(c_int64_t) :: triangles_found
            integer(c_int64_t) :: faces_found
            integer(c_int64_t) :: edges_found
            integer(c_int64_t) :: edge_points_found
            call mesh%counts(points=points_found, vertices=vertices_found, triangles=triangles_found, &
                faces=faces_found, edges=edges_found, edge_points=edge_points_found)
            call show('points', points_found)
            call show('vertices', vertices_found)
            call show('triangles', triangles_found)
            call show('faces', faces_found)
            call show('edges', edges_found)
            call show('edge_points', edge_points_found)
        end block
        call begin('mesh_bound')
        block
            real(c_double) :: from_shape_found
            real(c_double) :: from_mesh_found
            logical :: reached_found
            call mesh%bound(from_shape=from_shape_found, from_mesh=from_mesh_found, reached=reached_found)
            call show('from_shape', from_shape_found)
            call show('from_mesh', from_mesh_found)
            call show('reached', reached_found)
        end block
        call begin('model_face_name')
        block
            character(len=:), allocatable :: text_found
            call model%face_name(index=2, text=text_found)
            call show('buf', text_found)
        end block
        call begin('model_face_solid')
        block
            integer(c_int64_t) :: solid_found
            integer(c_int32_t) :: in_void_found
            call model%face_solid(index=2, solid=solid_found, in_void=in_void_found)
            call show('solid', solid_found)
            call show('in_void', in_void_found)
        end block
        call begin('model_face_layers')
        block
            integer(c_int64_t), allocatable :: layers_found(:)
            call layered%face_layers(index=1, layers=layers_found)
            call show('layers', layers_found)
        end block
        call begin('model_spline_layers')
        block
            integer(c_int64_t), allocatable :: layers_found(:)
            call layered%spline_layers(index=1, layers=layers_found)
            call show('layers', layers_found)
        end block
        call begin('model_layer_count')
        block
            call show('count', layered%layer_count())
        end block
        call begin('model_layer')
        block
            character(len=:), allocatable :: text_found
            call layered%layer(index=1, text=text_found)
            call show('buf', text_found)
        end block
        call begin('model_edge_uses')
        block
            integer(c_int64_t), allocatable :: places_found(:, :)
            call model%edge_uses(index=2, places=places_found)
            call show('places', flat(reshape(places_found, [size(places_found, 2), size(places_found, 1)], order=[2, &
                1])) - 1)
        end block
        call begin('model_vertex')
        block
            real(c_double), allocatable :: point_found(:)
            allocate (point_found(3))
            call model%vertex(index=1, point=point_found)
            call show('point', point_found)
        end block
        call begin('model_part')
        block
            character(len=:), allocatable :: text_found
            call model%part(index=1, text=text_found)
            call show('buf', text_found)
        end block
        call begin('model_use')
        block
            integer(c_int64_t) :: parent_found
            integer(c_int64_t) :: part_found
            real(c_double), allocatable :: placement_found(:, :)
            allocate (placement_found(3, 4))
            call model%get_use(index=1, parent=parent_found, part=part_found, placement=placement_found)
            call show('parent', parent_found - 1)
            call show('part', part_found - 1)
            call show('placement', flat(reshape(placement_found, [size(placement_found, 2), size(placement_found, 1)], &
                order=[2, 1])))
        end block
        call by_hand('read_options_init')
        call by_hand('call_options_init')
        call by_hand('version')
        call by_hand('status_name')
        call by_hand('last_error')
    end subroutine calls_of_scalar

    subroutine calls_of_shape()
        call begin('curve_line')
        block
            type(nurbs_spline) :: out_found
            call create_line(out=out_found, a=[0.1d0, 0.9d0], b=[0.3d0, 0.7d0])
            call show('out', out_found)
        end block
        call begin('curve_polyline')
        block
            type(nurbs_spline) :: out_found
            call create_polyline(out=out_found, points=reshape([0.1d0, 0.9d0, 0.3d0, 0.7d0, 0.2d0, 0.6d0], [3, 2], &
                order=[2, 1]))
            call show('out', out_found)
        end block
        call begin('curve_polyline with params')
        block
            type(nurbs_spline) :: out_found
            call create_polyline(out=out_found, points=reshape([0.1d0, 0.9d0, 0.3d0, 0.7d0, 0.2d0, 0.6d0], [2, 3], &
                order=[2, 1]), params=[0.3d0, 0.6d0])
            call show('out', out_found)
        end block
        call begin('curve_polygon')
        block
            type(nurbs_spline) :: out_found
            call create_polygon(out=out_found, sides=5, radius=1.0d0)
            call show('out', out_found)
        end block
        call begin('curve_polygon placed')
        block
            type(nurbs_spline) :: out_found
            call create_polygon(out=out_found, sides=5, radius=1.0d0, center=[1.0d0, 2.0d0, 3.0d0], axis=[0.0d0, &
                1.0d0, 0.0d0], x=[1.0d0, 0.0d0, 0.0d0])
            call show('out', out_found)
        end block
        call begin('curve_rounded_rectangle')
        block
            type(nurbs_spline) :: out_found
            call create_rounded_rectangle(out=out_found, width=3.0d0, height=2.0d0, corner_radius=0.5d0)
            call show('out', out_found)
        end block
        call begin('curve_circle')
        block
            type(nurbs_spline) :: out_found
            call create_circle(out=out_found, radius=1.0d0, form=2)
            call show('out', out_found)
        end block
        call begin('curve_circle placed')
        block
            type(nurbs_spline) :: out_found
            call create_circle(out=out_found, radius=1.0d0, center=[1.0d0, 2.0d0, 3.0d0], axis=[0.0d0, 1.0d0, 0.0d0], &
                x=[1.0d0, 0.0d0, 0.0d0], form=2)
            call show('out', out_found)
        end block
        call begin('curve_arc')
        block
            type(nurbs_spline) :: out_found
            call create_arc(out=out_found, radius=1.0d0, start=0.0d0, sweep=4.0d0, form=0)
            call show('out', out_found)
        end block
        call begin('curve_arc_through')
        block
            type(nurbs_spline) :: out_found
            call create_arc_through(out=out_found, a=[0.1d0, 0.9d0], b=[0.3d0, 0.7d0], c=[0.2d0, 0.6d0], form=0)
            call show('out', out_found)
        end block
        call begin('curve_arc_tangent')
        block
            type(nurbs_spline) :: out_found
            call create_arc_tangent(out=out_found, a=[0.0d0, 0.0d0], tangent=[0.0d0, 1.0d0], b=[1.0d0, 1.0d0], form=0)
            call show('out', out_found)
        end block
        call begin('curve_ellipse')
        block
            type(nurbs_spline) :: out_found
            call create_ellipse(out=out_found, radius_x=2.0d0, radius_y=1.0d0, start=0.0d0, sweep=4.0d0, form=2)
            call show('out', out_found)
        end block
        call begin('curve_parabola')
        block
            type(nurbs_spline) :: out_found
            call create_parabola(out=out_found, focal_length=1.0d0, start=-1.0d0, finish=2.0d0)
            call show('out', out_found)
        end block
        call begin('curve_parabola placed')
        block
            type(nurbs_spline) :: out_found
            call create_parabola(out=out_found, focal_length=1.0d0, start=-1.0d0, finish=2.0d0, vertex=[1.0d0, 2.0d0, &
                3.0d0], axis=[0.0d0, 1.0d0, 0.0d0], x=[1.0d0, 0.0d0, 0.0d0])
            call show('out', out_found)
        end block
        call begin('curve_hyperbola')
        block
            type(nurbs_spline) :: out_found
            call create_hyperbola(out=out_found, radius_x=1.0d0, radius_y=1.0d0, start=0.0d0, finish=9.0d0)
            call show('out', out_found)
        end block
        call begin('curve_hyperbola placed')
        block
            type(nurbs_spline) :: out_found
            call create_hyperbola(out=out_found, radius_x=1.0d0, radius_y=1.0d0, start=0.0d0, finish=9.0d0, &
                center=[1.0d0, 2.0d0, 3.0d0], axis=[0.0d0, 1.0d0, 0.0d0], x=[1.0d0, 0.0d0, 0.0d0])
            call show('out', out_found)
        end block
        call begin('curve_conic_triangle')
        block
            type(nurbs_spline) :: out_found
            call create_conic_triangle(out=out_found, p0=[0.1d0, 0.9d0], p1=[0.3d0, 0.7d0], p2=[0.2d0, 0.6d0], &
                factor=0.4d0)
            call show('out', out_found)
        end block
        call begin('curve_conic_shoulder')
        block
            type(nurbs_spline) :: out_found
            call create_conic_shoulder(out=out_found, a=[0.0d0, 0.0d0], tangent_a=[1.0d0, 1.0d0], b=[1.0d0, 0.0d0], &
                tangent_b=[1.0d0, -1.0d0], rho=0.4d0)
            call show('out', out_found)
        end block
        call begin('curve_conic_through')
        block
            type(nurbs_spline) :: out_found
            call create_conic_through(out=out_found, points=reshape([-2.0d0, 4.0d0, -1.0d0, 1.0d0, 0.0d0, 0.0d0, &
                1.0d0, 1.0d0, 2.0d0, 4.0d0], [5, 2], order=[2, 1]), form=0)
            call show('out', out_found)
        end block
        call begin('curve_conic_implicit')
        block
            type(nurbs_spline) :: out_found
            call create_conic_implicit(out=out_found, coefficients=[1.0d0, 0.0d0, 4.0d0, 0.0d0, 0.0d0, -4.0d0], &
                start=0.0d0, finish=3.0d0, form=0)
            call show('out', out_found)
        end block
        call begin('curve_helix')
        block
            type(nurbs_spline) :: out_found
            real(c_double) :: error_found
            call create_helix(out=out_found, radius=1.0d0, pitch=1.0d0, turns=1.0d0, tolerance=0.1d0, growth=1.0d0, &
                start=0.0d0, error=error_found)
            call show('out', out_found)
            call show('error', error_found)
        end block
        call begin('extrude')
        block
            type(nurbs_spline) :: out_found
            call extrude_spline(g=twist, vector=[0.0d0, 0.0d0, 1.0d0], out=out_found)
            call show('out', out_found)
        end block
        call begin('revolve')
        block
            type(nurbs_spline) :: out_found
            call revolve_spline(g=twist, out=out_found, sweep=6.0d0, form=0)
            call show('out', out_found)
        end block
        call begin('revolve about an axis')
        block
            type(nurbs_spline) :: out_found
            call revolve_spline(g=twist, out=out_found, sweep=6.0d0, point=[1.0d0, 2.0d0, 3.0d0], axis=[0.0d0, 1.0d0, &
                0.0d0], form=0)
            call show('out', out_found)
        end block
        call begin('ruled')
        block
            type(nurbs_spline) :: out_found
            call create_ruled(a=curve, b=loop, out=out_found, flags=0)
            call show('out', out_found)
        end block
        call begin('ruled Cartesian')
        block
            type(nurbs_spline) :: out_found
            call create_ruled(a=curve, b=loop, out=out_found, flags=int(z'80000000', c_int32_t))
            call show('out', out_found)
        end block
        call begin('tensor_sum')
        block
            type(nurbs_spline) :: out_found
            call tensor_sum(a=curve, alpha=1.0d0, b=loop, beta=2.0d0, out=out_found)
            call show('out', out_found)
        end block
        call begin('tensor_sum homogeneous')
        block
            type(nurbs_spline) :: out_found
            call tensor_sum(a=homogeneous, alpha=1.0d0, b=loop, beta=2.0d0, out=out_found)
            call show('out', out_found)
        end block
        call begin('tensor_product')
        block
            type(nurbs_spline) :: out_found
            call tensor_product(a=twist, b=surface, out=out_found)
            call show('out', out_found)
        end block
        call begin('surface_swung')
        block
            type(nurbs_spline) :: out_found
            call create_swung(trajectory=curve, profile=loop, out=out_found, scale=1.0d0)
            call show('out', out_found)
        end block
        call begin('surface_coons')
        block
            type(nurbs_list) :: edges
            type(nurbs_spline) :: out_found
            type(nurbs_spline) :: curves_given(4)
            call spline_boundaries(g=surface, list=edges)
            call edges%get(1, curves_given(1))
            call edges%get(2, curves_given(2))
            call edges%get(3, curves_given(3))
            call edges%get(4, curves_given(4))
            call create_coons(out=out_found, curves=curves_given, tolerance=0.0d0)
            call show('out', out_found)
        end block
        call begin('surface_coons_hermite')
        block
            type(nurbs_list) :: edges
            type(nurbs_spline) :: out_found
            type(nurbs_spline) :: curves_given(4)
            real(c_double) :: bound_found
            call spline_boundaries(g=surface, list=edges)
            call edges%get(1, curves_given(1))
            call edges%get(2, curves_given(2))
            call edges%get(3, curves_given(3))
            call edges%get(4, curves_given(4))
            call create_coons_hermite(out=out_found, curves=curves_given, twist=5, tolerance=0.0d0, bound=bound_found)
            call show('out', out_found)
            call show('bound', bound_found)
        end block
        call begin('volume_coons')
        block
            type(nurbs_list) :: faces
            type(nurbs_spline) :: out_found
            type(nurbs_spline) :: faces_given(6)
            call spline_boundaries(g=volume, list=faces)
            call faces%get(1, faces_given(1))
            call faces%get(2, faces_given(2))
            call faces%get(3, faces_given(3))
            call faces%get(4, faces_given(4))
            call faces%get(5, faces_given(5))
            call faces%get(6, faces_given(6))
            call create_coons_volume(out=out_found, faces=faces_given, tolerance=0.0d0)
            call show('out', out_found)
        end block
        call begin('surface_plane')
        block
            type(nurbs_spline) :: out_found
            call create_plane(out=out_found, u=[0.3d0, 0.6d0], v=[0.1d0, 0.9d0])
            call show('out', out_found)
        end block
        call begin('surface_plane placed')
        block
            type(nurbs_spline) :: out_found
            call create_plane(out=out_found, u=[0.0d0, 1.0d0, 0.0d0], v=[1.0d0, 0.0d0, 0.0d0], origin=[1.0d0, 2.0d0, &
                3.0d0])
            call show('out', out_found)
        end block
        call begin('surface_bilinear')
        block
            type(nurbs_spline) :: out_found
            call create_bilinear(out=out_found, corners=reshape([0.1d0, 0.9d0, 0.3d0, 0.7d0], [4, 1], order=[2, 1]))
            call show('out', out_found)
        end block
        call begin('volume_trilinear')
        block
            type(nurbs_spline) :: out_found
            call create_trilinear(out=out_found, corners=reshape([0.0d0, 0.0d0, 0.0d0, 0.0d0, 0.0d0, 0.0d0, 1.0d0, &
                0.0d0], [8, 1], order=[2, 1]))
            call show('out', out_found)
        end block
        call begin('surface_sphere')
        block
            type(nurbs_spline) :: out_found
            call create_sphere(out=out_found, radius=1.0d0, axis=[0.1d0, 0.9d0, 0.3d0], form=2)
            call show('out', out_found)
        end block
        call begin('surface_sphere placed')
        block
            type(nurbs_spline) :: out_found
            call create_sphere(out=out_found, radius=1.0d0, center=[1.0d0, 2.0d0, 3.0d0], axis=[0.0d0, 1.0d0, 0.0d0], &
                x=[1.0d0, 0.0d0, 0.0d0], form=2)
            call show('out', out_found)
        end block
        call begin('surface_spherical_patch')
        block
            type(nurbs_spline) :: out_found
            call create_spherical_patch(out=out_found, radius=1.0d0, start=0.0d0, sweep=4.0d0, south=0.0d0, &
                north=1.0d0, form=0)
            call show('out', out_found)
        end block
        call begin('surface_sphere_patches')
        block
            type(nurbs_list) :: list_found
            call create_sphere_patches(list=list_found, radius=1.0d0, flags=16777216)
            call show('out', list_found)
        end block
        call begin('surface_sphere_patches placed')
        block
            type(nurbs_list) :: list_found
            call create_sphere_patches(list=list_found, radius=1.0d0, center=[1.0d0, 2.0d0, 3.0d0], axis=[0.0d0, &
                1.0d0, 0.0d0], x=[1.0d0, 0.0d0, 0.0d0], flags=16777216)
            call show('out', list_found)
        end block
        call begin('surface_ellipsoid')
        block
            type(nurbs_spline) :: out_found
            call create_ellipsoid(out=out_found, radii=[1.0d0, 2.0d0, 3.0d0], form=1)
            call show('out', out_found)
        end block
        call begin('surface_cylinder')
        block
            type(nurbs_spline) :: out_found
            call create_cylinder(out=out_found, radius=1.0d0, height=2.0d0, start=0.0d0, sweep=3.0d0, form=0)
            call show('out', out_found)
        end block
        call begin('surface_cone')
        block
            type(nurbs_spline) :: out_found
            call create_cone(out=out_found, base_radius=1.0d0, top_radius=0.0d0, height=2.0d0, start=0.0d0, &
                sweep=3.0d0, form=0)
            call show('out', out_found)
        end block
        call begin('surface_paraboloid')
        block
            type(nurbs_spline) :: out_found
            call create_paraboloid(out=out_found, radii=[3.0d0, 1.0d0], height=1.0d0, start=0.0d0, sweep=3.0d0, form=0)
            call show('out', out_found)
        end block
        call begin('surface_saddle')
        block
            type(nurbs_spline) :: out_found
            call create_saddle(out=out_found, radii=[3.0d0, 1.0d0], height=1.0d0)
            call show('out', out_found)
        end block
        call begin('surface_saddle placed')
        block
            type(nurbs_spline) :: out_found
            call create_saddle(out=out_found, radii=[3.0d0, 1.0d0], height=1.0d0, center=[1.0d0, 2.0d0, 3.0d0], &
                axis=[0.0d0, 1.0d0, 0.0d0], x=[1.0d0, 0.0d0, 0.0d0])
            call show('out', out_found)
        end block
        call begin('curve_rounded_rectangle placed')
        block
            type(nurbs_spline) :: out_found
            call create_rounded_rectangle(out=out_found, width=3.0d0, height=2.0d0, corner_radius=0.5d0, &
                center=[1.0d0, 2.0d0, 3.0d0], axis=[0.0d0, 1.0d0, 0.0d0], x=[1.0d0, 0.0d0, 0.0d0])
            call show('out', out_found)
        end block
        call begin('curve_arc placed')
        block
            type(nurbs_spline) :: out_found
            call create_arc(out=out_found, radius=1.0d0, start=0.0d0, sweep=4.0d0, center=[1.0d0, 2.0d0, 3.0d0], &
                axis=[0.0d0, 1.0d0, 0.0d0], x=[1.0d0, 0.0d0, 0.0d0], form=0)
            call show('out', out_found)
        end block
        call begin('curve_ellipse placed')
        block
            type(nurbs_spline) :: out_found
            call create_ellipse(out=out_found, radius_x=2.0d0, radius_y=1.0d0, start=0.0d0, sweep=4.0d0, &
                center=[1.0d0, 2.0d0, 3.0d0], axis=[0.0d0, 1.0d0, 0.0d0], x=[1.0d0, 0.0d0, 0.0d0], form=0)
            call show('out', out_found)
        end block
        call begin('curve_conic_point')
        block
            type(nurbs_spline) :: out_found
            call create_conic_point(out=out_found, a=[0.0d0, 0.0d0], tangent_a=[1.0d0, 1.0d0], b=[1.0d0, 0.0d0], &
                tangent_b=[1.0d0, -1.0d0], point=[0.5d0, 0.25d0], form=0)
            call show('out', out_found)
        end block
        call begin('curve_conic_focus')
        block
            type(nurbs_spline) :: out_found
            call create_conic_focus(out=out_found, focus=[0.0d0, 0.0d0], foot=[1.0d0, 0.0d0], eccentricity=0.5d0, &
                start=0.0d0, sweep=6.0d0, form=0)
            call show('out', out_found)
        end block
        call begin('curve_conic_focus in space')
        block
            type(nurbs_spline) :: out_found
            call create_conic_focus(out=out_found, focus=[1.0d0, 2.0d0, 3.0d0], foot=[2.0d0, 2.0d0, 3.0d0], &
                eccentricity=0.5d0, start=0.0d0, sweep=6.0d0, axis=[0.0d0, 1.0d0, 0.0d0], form=0)
            call show('out', out_found)
        end block
        call begin('curve_helix placed')
        block
            type(nurbs_spline) :: out_found
            real(c_double) :: error_found
            call create_helix(out=out_found, radius=1.0d0, pitch=1.0d0, turns=1.0d0, tolerance=0.1d0, growth=1.0d0, &
                start=0.0d0, origin=[1.0d0, 2.0d0, 3.0d0], axis=[0.0d0, 1.0d0, 0.0d0], x=[1.0d0, 0.0d0, 0.0d0], &
                error=error_found)
            call show('out', out_found)
            call show('error', error_found)
        end block
        call begin('surface_coons_hermite with twists')
        block
            type(nurbs_spline) :: out_found
            type(nurbs_spline) :: curves_given(4)
            type(nurbs_spline) :: cross_given(4)
            real(c_double) :: bound_found
            curves_given(1) = twist
            curves_given(2) = twist
            curves_given(3) = twist
            curves_given(4) = twist
            cross_given(1) = twist
            cross_given(2) = twist
            cross_given(3) = twist
            cross_given(4) = twist
            call create_coons_hermite(out=out_found, curves=curves_given, twist=2, cross=cross_given, &
                twists=reshape([0.0d0, 0.0d0, 0.0d0, 0.0d0, 0.0d0, 0.0d0, 1.0d0, 0.0d0, 0.0d0, 1.0d0, 0.0d0, 0.0d0], &
                [4, 3], order=[2, 1]), tolerance=99.0d0, bound=bound_found)
            call show('out', out_found)
            call show('bound', bound_found)
        end block
        call begin('surface_spherical_patch placed')
        block
            type(nurbs_spline) :: out_found
            call create_spherical_patch(out=out_found, radius=1.0d0, start=0.0d0, sweep=4.0d0, south=0.0d0, &
                north=1.0d0, center=[1.0d0, 2.0d0, 3.0d0], axis=[0.0d0, 1.0d0, 0.0d0], x=[1.0d0, 0.0d0, 0.0d0], form=0)
            call show('out', out_found)
        end block
        call begin('surface_ellipsoid placed')
        block
            type(nurbs_spline) :: out_found
            call create_ellipsoid(out=out_found, radii=[1.0d0, 2.0d0, 3.0d0], center=[1.0d0, 2.0d0, 3.0d0], &
                axis=[0.0d0, 1.0d0, 0.0d0], x=[1.0d0, 0.0d0, 0.0d0], form=1)
            call show('out', out_found)
        end block
        call begin('surface_cylinder placed')
        block
            type(nurbs_spline) :: out_found
            call create_cylinder(out=out_found, radius=1.0d0, height=2.0d0, start=0.0d0, sweep=3.0d0, center=[1.0d0, &
                2.0d0, 3.0d0], axis=[0.0d0, 1.0d0, 0.0d0], x=[1.0d0, 0.0d0, 0.0d0], form=0)
            call show('out', out_found)
        end block
        call begin('surface_cone placed')
        block
            type(nurbs_spline) :: out_found
            call create_cone(out=out_found, base_radius=1.0d0, top_radius=0.0d0, height=2.0d0, start=0.0d0, &
                sweep=3.0d0, center=[1.0d0, 2.0d0, 3.0d0], axis=[0.0d0, 1.0d0, 0.0d0], x=[1.0d0, 0.0d0, 0.0d0], form=0)
            call show('out', out_found)
        end block
        call begin('surface_torus')
        block
            type(nurbs_spline) :: out_found
            call create_torus(out=out_found, major_radius=3.0d0, minor_radius=1.0d0, start=0.0d0, sweep=3.0d0, &
                tube_start=0.0d0, tube_sweep=6.0d0, form=2)
            call show('out', out_found)
        end block
        call begin('surface_torus placed')
        block
            type(nurbs_spline) :: out_found
            call create_torus(out=out_found, major_radius=3.0d0, minor_radius=1.0d0, start=0.0d0, sweep=3.0d0, &
                tube_start=0.0d0, tube_sweep=6.0d0, center=[1.0d0, 2.0d0, 3.0d0], axis=[0.0d0, 1.0d0, 0.0d0], &
                x=[1.0d0, 0.0d0, 0.0d0], form=2)
            call show('out', out_found)
        end block
        call begin('surface_paraboloid placed')
        block
            type(nurbs_spline) :: out_found
            call create_paraboloid(out=out_found, radii=[3.0d0, 1.0d0], height=1.0d0, start=0.0d0, sweep=3.0d0, &
                vertex=[1.0d0, 2.0d0, 3.0d0], axis=[0.0d0, 1.0d0, 0.0d0], x=[1.0d0, 0.0d0, 0.0d0], form=0)
            call show('out', out_found)
        end block
        call begin('surface_hyperboloid')
        block
            type(nurbs_spline) :: out_found
            call create_hyperboloid(out=out_found, radii=[3.0d0, 1.0d0, 1.0d0], bottom=-9.0d0, top=9.0d0, start=0.0d0, &
                sweep=3.0d0, form=0, flags=0)
            call show('out', out_found)
        end block
        call begin('surface_hyperboloid placed')
        block
            type(nurbs_spline) :: out_found
            call create_hyperboloid(out=out_found, radii=[3.0d0, 1.0d0, 1.0d0], bottom=-9.0d0, top=9.0d0, start=0.0d0, &
                sweep=3.0d0, center=[1.0d0, 2.0d0, 3.0d0], axis=[0.0d0, 1.0d0, 0.0d0], x=[1.0d0, 0.0d0, 0.0d0], &
                form=0, flags=0)
            call show('out', out_found)
        end block
    end subroutine calls_of_shape

end program smoke_calls
