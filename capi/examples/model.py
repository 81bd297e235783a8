#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Opens a STEP or IGES file, lists its faces with their areas, takes the first one apart, and writes a copy in
inches, as IGES if its name ends with .igs.

usage: model.py [FILE.step [COPY.igs]]
"""

import pathlib
import sys

import nurbs

path = sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).with_name("models") / "bushing.step"
model = nurbs.Model.read_file(path)
print(f"{model.counts.faces} faces, {model.counts.edges} edges, {model.counts.vertices} vertices")
for face in model.faces:
    print(f"{face.name}: area {face.area(1e-9).value:.6f}")
face = model.faces[0]
for loop, size in enumerate(face.loops):
    for index in range(size):
        curve, key = face.edge(loop, index)
        users = " and ".join(model.faces[use.face].name for use in model.edges[abs(key) - 1].uses)
        print(f"loop {loop}, edge {abs(key)}: length {curve.length(1e-9).value:.6f}, of {users}")
if len(sys.argv) > 2:
    model.write_file(sys.argv[2], unit=0.0254)
