#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What other programs read of the files of meshes: as many triangles, closed and seen from outside, with the same volume.

    check_mesh_files.py admesh|meshio|vtk|gltf OUTPUT_FOLDER MODEL...

MODEL: a file of a solid. Those of the folder NURBS_TEST_DATA are taken too, where they are.
"""

import importlib
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

import nurbs
import numpy

#: Solids among the real files, and a model of open shells.
REAL = ["countersunk_screw.step", "satellite_mainbody.stp", "nacelle.stp"]
FORMATS = {"stl": nurbs.NURBS_FORMAT_STL, "ascii.stl": nurbs.NURBS_FORMAT_STL_TEXT, "obj": nurbs.NURBS_FORMAT_OBJ,
           "ply": nurbs.NURBS_FORMAT_PLY, "glb": nurbs.NURBS_FORMAT_GLB, "vtu": nurbs.NURBS_FORMAT_VTU}

VALIDATE = """
const validator = require('gltf-validator'), fs = require('fs');
validator.validateBytes(new Uint8Array(fs.readFileSync(process.argv[1]))).then(r => console.log(JSON.stringify(r)));
"""


def skip(reason):
    print(f"SKIPPED: {reason}")
    sys.exit(77)


def module(name):
    try:
        return importlib.import_module(name)
    except ImportError as error:
        return skip(error)


def volume(points, triangles):
    a, b, c = (points[triangles[:, k]] - points[triangles[0, 0]] for k in range(3))
    return float(numpy.einsum("ij,ij->i", a, numpy.cross(b, c)).sum() / 6)


class Written:
    """A model as files of all formats; what a binary STL file says of it is what the others are compared with."""

    def __init__(self, source, folder):
        self.name, self.folder = pathlib.Path(source).stem, folder
        self.mesh = nurbs.Model.read(pathlib.Path(source).read_bytes()).mesh(relative=1e-3)
        for suffix, form in FORMATS.items():
            self.mesh.write_file(self.path(suffix), form)
        facets = numpy.frombuffer(self.path("stl").read_bytes()[84:],
                                  numpy.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("no", "<u2")]))
        self.count = len(facets)
        self.corners = facets["corners"].astype(float)
        self.volume = volume(self.corners.reshape(-1, 3), numpy.arange(3 * self.count).reshape(-1, 3))

    def path(self, suffix):
        return self.folder / f"{self.name}.{suffix}"

    @property
    def closed(self):
        """Whether each side has one the other way."""
        ends = self.corners[:, [0, 1, 2]], self.corners[:, [1, 2, 0]]
        sides, back = (numpy.concatenate(pair, axis=2).reshape(-1, 6) for pair in (ends, ends[::-1]))
        return numpy.array_equal(*(numpy.sort(array.copy().view("f8,f8,f8,f8,f8,f8").ravel()) for array in (sides, back)))

    def expect(self, what, points, triangles):
        enclosed = volume(points, triangles)
        print(f"{self.name}.{what}: {len(triangles)} triangles, volume {enclosed:.6g}")
        # Those that vanish in single precision are in other files than STL.
        assert self.count <= len(triangles) and (what[-3:] != "stl" or len(triangles) == self.count), self.count
        assert abs(enclosed - self.volume) <= 1e-4 * abs(self.volume), self.volume
        assert enclosed > 0 or not self.closed


def check_admesh(written):
    if not shutil.which("admesh"):
        skip("admesh is not installed")
    for suffix in ("stl", "ascii.stl"):
        done = subprocess.run(["admesh", str(written.path(suffix))], capture_output=True, text=True, check=True)
        found = {key: float(number) for key, number in re.findall(r"(\w[\w ]*\w) *: *(-?[\d.]+)", done.stdout)}
        print(f"{written.name}.{suffix}: {found['Number of facets']:.0f} facets, volume {found['Volume']:.6g}, closed: "
              f"{written.closed}")
        assert found["Number of facets"] == written.count or not written.closed
        if written.closed:
            wrong = ("Total disconnected facets", "Facets reversed", "Backwards edges", "Edges fixed", "Facets added")
            assert not any(found[what] for what in wrong), done.stdout
            assert abs(found["Volume"] - written.volume) <= 1e-3 * written.volume, done.stdout


def check_meshio(written):
    meshio = module("meshio")
    for suffix in ("stl", "ascii.stl", "ply", "vtu"):  # of OBJ it reads only files with as many normals as points
        read = meshio.read(written.path(suffix))
        triangles = numpy.vstack([block.data for block in read.cells if block.type == "triangle"])
        written.expect(suffix, read.points, triangles)


def check_vtk(written):
    vtk = module("vtk")
    to_numpy = module("vtk.util.numpy_support").vtk_to_numpy
    readers = {"stl": vtk.vtkSTLReader, "obj": vtk.vtkOBJReader, "ply": vtk.vtkPLYReader, "vtu": vtk.vtkXMLUnstructuredGridReader}
    for suffix, reader in readers.items():
        made = reader()
        made.SetFileName(str(written.path(suffix)))
        made.Update()
        data = made.GetOutput()
        cells = data.GetCells() if suffix == "vtu" else data.GetPolys()
        triangles = to_numpy(cells.GetConnectivityArray()).reshape(-1, 3)
        written.expect(suffix, to_numpy(data.GetPoints().GetData()).astype(float), triangles)
        if suffix == "vtu":
            assert data.GetPointData().GetNormals().GetNumberOfTuples() == data.GetNumberOfPoints()
            assert to_numpy(data.GetCellData().GetArray("face")).max() < written.mesh.counts.faces


def check_gltf(written):
    if not shutil.which("node"):
        skip("node is not installed")
    done = subprocess.run(["node", "-e", VALIDATE, str(written.path("glb"))], capture_output=True, text=True)
    if "Cannot find module" in done.stderr:
        skip("gltf-validator is not installed")
    report = json.loads(done.stdout)
    print(written.name, report["issues"]["numErrors"], "errors", report["issues"]["numWarnings"], "warnings",
          report["info"]["totalTriangleCount"], "triangles", [message["message"] for message in report["issues"]["messages"][:5]])
    assert report["issues"]["numErrors"] == 0 and report["issues"]["numWarnings"] == 0
    assert report["info"]["totalTriangleCount"] >= written.count


def main(tool, folder, *models):
    check = {"admesh": check_admesh, "meshio": check_meshio, "vtk": check_vtk, "gltf": check_gltf}[tool]
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    data = pathlib.Path(os.environ.get("NURBS_TEST_DATA", ""))
    for source in [*models, *(data / name for name in REAL if (data / name).is_file())]:
        check(Written(source, folder))


if __name__ == "__main__":
    main(*sys.argv[1:])
