# SPDX-License-Identifier: MIT
"""plot() of meshes, faces and models in Python: what it draws, and where; skipped without Matplotlib."""

import pathlib
import sys
import unittest
import warnings
from unittest import mock

import nurbs
from helpers import near, np, same
from nurbs import _plot

try:
    # Matplotlib and what it imports may be older than the interpreter.
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        import matplotlib

        matplotlib.use("Agg")
        import matplotlib.pyplot as plt
        from mpl_toolkits.mplot3d import art3d
except ImportError:
    print("SKIPPED: Matplotlib is not installed")
    sys.exit(77)

BUSHING = pathlib.Path(__file__).resolve().parents[2] / "capi/examples/models/bushing.step"


def drawn(plot, *arguments, **options):
    """The axes, and what is drawn in them: triangles (n, 3, 3), segments (n, 2, 3), and the colours of the triangles."""
    with mock.patch.object(art3d, "Poly3DCollection", wraps=art3d.Poly3DCollection) as made:
        ax = plot(*arguments, **options)
    facets, colors = made.call_args.args[0], np.asarray(made.call_args.kwargs["facecolors"])
    lines = (facets[:, 1] == facets[:, 2]).all(axis=1)
    return ax, facets[~lines], facets[lines][:, :2], colors[~lines]


def picture(ax):
    """The picture is not empty."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        ax.figure.canvas.draw()
    return (np.asarray(ax.figure.canvas.buffer_rgba())[..., :3] < 250).any()


def area(triangles):
    crosses = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    return 0.5 * np.linalg.norm(crosses.reshape(len(triangles), -1), axis=1).sum()


def disc(hole=False):
    """A disc of radius 1 in the plane, with a hole of radius 1/2 or without."""
    square = nurbs.bilinear([[[-2, -2], [-2, 2]], [[2, -2], [2, 2]]]).reparametrize(-2, 2, axis=0).reparametrize(-2, 2, axis=1)
    return nurbs.Face(square, [nurbs.circle(1)] + [nurbs.circle(0.5)] * hole, tolerance=1e-9)


class FacePlots(unittest.TestCase):
    def tearDown(self):
        plt.close("all")

    def test_a_mesh(self):
        mesh = nurbs.sphere().mesh(relative=0.01)
        ax, triangles, lines, colors = drawn(mesh.plot, color="red")
        same(triangles, mesh.points[mesh.triangles])
        self.assertEqual(len(lines), mesh.counts.edge_points - mesh.counts.edges)
        self.assertTrue((colors[:, 0] > colors[:, 1]).all() and (colors[:, 3] == 1).all())
        self.assertTrue(picture(ax))
        self.assertIs(mesh.plot(ax, edges=False, alpha=0.5), ax)
        self.assertEqual(len(drawn(mesh.plot, edges=False)[2]), 0)

    def test_a_face_in_space(self):
        for face in nurbs.Model.read_file(BUSHING).faces:
            ax, triangles, lines, _ = drawn(face.plot)
            self.assertAlmostEqual(area(triangles) / face.area().value, 1, 2)
            near(face.closest_points(triangles.reshape(-1, 3)).distances, 0, by=1e-9)
            lengths = np.linalg.norm(lines[:, 1] - lines[:, 0], axis=1).sum()
            edges = [face.edge(loop, k) for loop, n in enumerate(face.loops) for k in range(n)]
            border = {abs(edge.key): edge.spline.length().value for edge in edges}  # a seam is there once
            self.assertAlmostEqual(lengths / sum(border.values()), 1, 2)
            self.assertTrue(picture(ax))

    def test_a_face_in_the_plane(self):
        for face in (disc(), disc(hole=True)):
            ax = face.plot()
            triangles, lines = ax.collections
            corners = np.array([path.vertices[:3] for path in triangles.get_paths()])
            self.assertAlmostEqual(area(corners) / face.area().value, 1, 2)
            near(np.hypot(*np.concatenate(lines.get_segments()).T).max(), 1)
            self.assertEqual((ax.name, ax.get_aspect()), ("rectilinear", 1))
            self.assertTrue(picture(ax))

    def test_a_model_with_its_colours(self):
        model = nurbs.Model.read_file(BUSHING)
        ax, triangles, lines, colors = drawn(model.plot)
        self.assertAlmostEqual(area(triangles) / (96 * np.pi), 1, 2)
        near([triangles.min(axis=(0, 1)), triangles.max(axis=(0, 1))], [[-5, -5, 0], [5, 5, 4]], by=1e-9)
        self.assertGreater(len(lines), 100)
        self.assertTrue((colors[:, 2] > colors[:, 0]).all())
        self.assertTrue(picture(ax))
        with mock.patch.object(nurbs.ModelFace, "colour", (1.0, 0.0, 0.0)):
            colors = drawn(model.plot)[3]
            self.assertTrue((colors[:, 0] > colors[:, 2]).all())
            colors = drawn(model.plot, color="lime")[3]
            self.assertTrue((colors[:, 1] > colors[:, 0]).all())

    def test_parts_where_they_stand(self):
        model = nurbs.Model.read_file(BUSHING)
        turned = np.array([[0, -2, 0, 100], [2, 0, 0, 0], [0, 0, 2, 0.0]])
        places = model.instances()
        here = nurbs.ModelInstances(*(np.concatenate([array, array]) for array in places[:3]),
                                    np.stack([places.placements[0], turned]))
        _, before, edges_before, _ = drawn(model.plot)
        with mock.patch.object(nurbs.Model, "instances", lambda self: here):
            _, after, edges_after, colors = drawn(model.plot)
        same(after[:len(before)], before)
        near(after[len(before):], before @ turned[:, :3].T + turned[:, 3])
        near(edges_after[len(edges_before):], edges_before @ turned[:, :3].T + turned[:, 3])
        self.assertEqual(len(colors), 2 * len(before))

    def test_faces_of_two_parts(self):
        tiles = [nurbs.bilinear([[[x, 0, 0], [x, 1, 0]], [[x + 1, 0, 0], [x + 1, 1, 0]]]) for x in (0, 5)]
        mesh = nurbs.Model.create([nurbs.Face(tile) for tile in tiles]).mesh()
        moves = np.stack([np.eye(3, 4), np.eye(3, 4)])
        moves[1, 2, 3] = 7  # the second part, and it alone, is lifted
        places = nurbs.ModelInstances(np.full(2, -1), np.arange(2), np.arange(2), moves)
        known = np.array([[1.0, 0, 0], [0, 1.0, 0]])
        _, triangles, lines, colors = drawn(_plot.plot_model, mesh, None, None, True, 1.0, known, np.arange(2), places)
        second = triangles[:, 0, 0] >= 5
        same(triangles[..., 2], np.where(second, 7.0, 0.0)[:, None] * np.ones(3))
        same(colors[:, 1] > colors[:, 0], second)
        same(lines[..., 2], np.where(lines[:, 0, 0] >= 5, 7.0, 0.0)[:, None] * np.ones(2))
        self.assertEqual((second.sum() * 2, len(lines)), (len(second), mesh.counts.edge_points - mesh.counts.edges))

    def test_a_model_without_faces(self):
        with self.assertRaisesRegex(ValueError, "no faces"):
            nurbs.Model.read(BUSHING.read_bytes(), kinds=nurbs.NURBS_READ_CURVES).plot()

    def test_without_matplotlib(self):
        with mock.patch.dict(sys.modules, {"matplotlib.pyplot": None, "matplotlib.colors": None, "matplotlib": None}):
            for shape in (disc(), nurbs.sphere().mesh(), nurbs.Model.read_file(BUSHING)):
                with self.assertRaisesRegex(ImportError, "plot.. needs Matplotlib"):
                    shape.plot()


if __name__ == "__main__":
    unittest.main()
