# SPDX-License-Identifier: MIT
"""Meshes in Python for other programs: meshio takes their arrays as they are; skipped without meshio."""

import pathlib
import sys
import tempfile
import unittest

import nurbs
from helpers import np, same

try:
    import meshio
except ImportError:
    print("SKIPPED: meshio is not installed")
    sys.exit(77)

BUSHING = pathlib.Path(__file__).resolve().parents[2] / "capi/examples/models/bushing.step"


class Meshio(unittest.TestCase):
    def test_arrays_are_taken_without_a_copy(self):
        for mesh in (nurbs.sphere().mesh(), nurbs.Model.read_file(BUSHING).mesh()):
            points, triangles = mesh.points, mesh.triangles
            given = meshio.Mesh(points, [("triangle", triangles)])
            self.assertTrue(np.shares_memory(given.points, points))
            self.assertTrue(np.shares_memory(given.cells[0].data, triangles))
            for array in (points, triangles):
                self.assertTrue(array.flags.owndata and array.flags.c_contiguous and array.flags.writeable)

    def test_files(self):
        mesh = nurbs.Model.read_file(BUSHING).mesh()
        with tempfile.TemporaryDirectory() as folder:
            for ending in ("vtk", "ply", "off", "obj"):
                path = pathlib.Path(folder, f"bushing.{ending}")
                meshio.Mesh(mesh.points, [("triangle", mesh.triangles)]).write(path)
                back = meshio.read(path)
                np.testing.assert_allclose(back.points, mesh.points, rtol=0, atol=1e-5)
                same(back.cells[0].data, mesh.triangles)

    def test_lines_of_edges_and_numbers_of_faces(self):
        mesh = nurbs.Model.read_file(BUSHING).mesh()
        edges, every = mesh.edges, mesh.edge_points
        lines = np.concatenate([np.stack([every[i:i + n - 1], every[i + 1:i + n]], axis=-1)
                                for i, n in zip(edges.firsts, edges.sizes)])
        faces = np.repeat(np.arange(mesh.counts.faces), mesh.faces.triangle_counts)
        whole = meshio.Mesh(mesh.points, [("triangle", mesh.triangles), ("line", lines)],
                            cell_data={"face": [faces, np.full(len(lines), -1)]})
        self.assertEqual([len(block.data) for block in whole.cells], [mesh.counts.triangles, len(lines)])


if __name__ == "__main__":
    unittest.main()
