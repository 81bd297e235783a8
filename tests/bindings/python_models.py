# SPDX-License-Identifier: MIT
"""Models in Python: sequences of faces and edges, copies, and what is wrong is said."""

import copy
import math
import pathlib
import pickle
import re
import tempfile
import unittest

import nurbs
from helpers import np, status_of

BUSHING = pathlib.Path(__file__).resolve().parents[2] / "capi/examples/models/bushing.step"
MODELS = BUSHING.with_name("models.igs")


class Models(unittest.TestCase):
    def setUp(self):
        self.model = nurbs.Model.read_file(BUSHING)

    def test_faces_are_a_sequence_of_faces(self):
        faces = self.model.faces
        self.assertEqual([face.name for face in faces], ["outside", "bore", "bottom", "top"])
        self.assertEqual((len(faces), faces[-1].name, [face.name for face in faces[1:3]]), (4, "top", ["bore", "bottom"]))
        for face, area in zip(faces, (40, 24, 16, 16)):
            self.assertIsInstance(face, nurbs.Face)
            self.assertAlmostEqual(face.area(1e-12).value, area * math.pi, 9)
        bore = faces[1]
        self.assertEqual((bore.shape, bore.against, bore.colour, bore.part), (nurbs.NURBS_SHAPE_CYLINDER, True, None, 0))
        self.assertEqual((copy.copy(bore).name, repr(bore)), ("bore", "<ModelFace 'bore' of 1 loop with 4 curves>"))
        with self.assertRaises(IndexError):
            faces[4]
        with self.assertRaises(TypeError):
            nurbs.ModelFace()

    def test_edges_know_their_vertices_and_uses(self):
        seam = self.model.edges[4]
        self.assertEqual((seam.vertices, seam.shape, seam.part), ((0, 1), nurbs.NURBS_SHAPE_LINE, 0))
        self.assertEqual(seam.uses, (nurbs.EdgeUse(0, 0, 1), nurbs.EdgeUse(0, 0, 3)))
        np.testing.assert_array_equal(self.model.vertices, [[5, 0, 0], [5, 0, 4], [3, 0, 0], [3, 0, 4]])
        np.testing.assert_array_equal(self.model.vertex(1), [5, 0, 4])
        self.assertEqual(seam.spline([0, 1]).shape, (2, 3))

    def test_parts_and_the_rest(self):
        model = self.model
        self.assertEqual(model.counts, nurbs.ModelCounts(1, 1, 4, 6, 4))
        self.assertEqual(list(model.parts), [model.part(0)])
        self.assertEqual((model.uses[0].parent, model.uses[0].part), (-1, 0))
        np.testing.assert_array_equal(model.uses[0].placement, np.eye(3, 4))
        self.assertEqual((model.unit, model.notes, len(model.splines)), (0.001, [], 0))

    def test_solids_layers_and_kinds(self):
        text = BUSHING.read_text()
        bore, = re.findall(r"#(\d+) ?= ?ADVANCED_FACE\('bore'", text)
        layers = "".join(f"#{9000 + i}=PRESENTATION_LAYER_ASSIGNMENT('{name}','',(#{bore}));\n" for i, name in enumerate("ab"))
        end = text.rindex("ENDSEC;")
        contents = (text[:end] + layers + text[end:]).encode()
        model = nurbs.Model.read(contents)
        self.assertEqual((list(model.layers), model.layer_count(), model.layer(1)), (["a", "b"], 2, "b"))
        self.assertEqual([model.face_layers(i) for i in range(4)], [(), (0, 1), (), ()])
        self.assertEqual([model.face_solid(i) for i in range(4)], [nurbs.FaceSolid(0, False)] * 4)
        self.assertEqual(list(nurbs.Model.read(model.write()).layers), ["a", "b"])
        self.assertEqual(len(nurbs.Model.read(contents, kinds=nurbs.NURBS_READ_CURVES).faces), 0)
        with self.assertRaises(IndexError):
            model.spline_layers(0)

    def test_the_same_from_bytes_and_in_metres(self):
        model = nurbs.Model.read(bytearray(BUSHING.read_bytes()), unit=1.0)
        self.assertAlmostEqual(model.faces[1].area(1e-12).value, 24e-6 * math.pi, 15)

    def test_what_is_written_reads_back(self):
        contents = self.model.write()
        self.assertEqual(contents, nurbs.Model.read(contents).write())
        self.assertEqual([face.name for face in nurbs.Model.read(contents).faces], ["outside", "bore", "bottom", "top"])
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "copy.STP"
            self.model.write_file(path, unit=0.0254, tolerance=1e-6)
            copy_of = nurbs.Model.read_file(path)
            self.assertEqual(copy_of.unit, 0.0254)
            self.assertAlmostEqual(copy_of.faces[1].area(1e-12).value * 25.4**2, 24 * math.pi, 9)
            with self.assertRaises(ValueError):
                self.model.write_file(path.with_suffix(".txt"))
            with self.assertRaises(ValueError):
                self.model.write_file("a\0.step")
            with self.assertRaises(nurbs.FileError):
                self.model.write_file(pathlib.Path(folder) / "none" / "a.step")
            self.assertEqual([entry.name for entry in pathlib.Path(folder).iterdir()], ["copy.STP"])
            nurbs.SplineList.create([self.model.edges[0].spline], ["rim"], 1.0).write_file(path)
            self.assertEqual((nurbs.read_file(path).names, nurbs.read_file(path).unit), (["rim"], 1.0))
        self.assertEqual(nurbs.read(nurbs.read(contents).write(progress=lambda done: True)).unit, 0.001)
        with self.assertRaises(nurbs.ContentsError):
            self.model.write(99)
        with self.assertRaises(nurbs.WorkError):
            self.model.write(work=1)

    def test_triangles_are_written_by_suffix(self):
        mesh = self.model.mesh()
        contents = mesh.write()
        self.assertEqual(len(contents), 84 + 50 * mesh.counts.triangles)
        begin = {"stl": b"Written by", "obj": b"# Written", "ply": b"ply", "glb": b"glTF", "VTU": b"<?xml"}
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "mesh"
            for suffix, start in begin.items():
                mesh.write_file(path.with_suffix("." + suffix))
                self.assertTrue(path.with_suffix("." + suffix).read_bytes().startswith(start))
            mesh.write_file(path.with_suffix(".stl"), nurbs.NURBS_FORMAT_STL_TEXT, 0.0254)
            self.assertTrue(path.with_suffix(".stl").read_bytes().startswith(b"solid"))
            for name in ("mesh.step", "a\0.stl"):
                with self.assertRaises(ValueError):
                    mesh.write_file(f"{folder}/{name}")
            with self.assertRaises(nurbs.FileError):
                mesh.write_file(path / "none.stl")
        self.assertEqual(mesh.write(nurbs.NURBS_FORMAT_GLB, progress=lambda done: True)[:4], b"glTF")
        with self.assertRaises(nurbs.ContentsError):
            mesh.write(nurbs.NURBS_FORMAT_STEP)
        with self.assertRaises(nurbs.WorkError):
            mesh.write(work=1)

    def test_faces_of_an_iges_file(self):
        model = nurbs.Model.read_file(MODELS)
        faces = {face.name: face for face in model.faces}
        self.assertEqual((len(model.faces), len(model.splines), model.notes), (31, 7, []))
        self.assertAlmostEqual(faces["torus"].area(1e-12).value, 4 * math.pi**2 * 60 * 20, 6)
        self.assertAlmostEqual(faces["cylinder"].area(1e-12).value, 2 * math.pi * 30 * 80, 7)
        self.assertEqual((faces["torus"].loops, faces["cylinder"].loops, faces["hull"].loops), ((), (1, 1), (4,)))
        self.assertEqual(nurbs.Model.read(MODELS.read_bytes(), unit=1.0).unit, 1.0)

    def test_rays(self):
        found = self.model.rays([[9, 0.1, 2], [0, 0.1, 9]], [[-1, 0, 0], [0, 0, -1]])
        self.assertEqual(found.status.tolist(), [nurbs.NURBS_RAY_HIT | nurbs.NURBS_RAY_CERTIFIED, nurbs.NURBS_RAY_CERTIFIED])
        self.assertAlmostEqual(found.distances[0], 9 - math.sqrt(25 - 0.01), 12)
        self.assertEqual((found.places.tolist(), found.params.shape), ([[0, 0], [-1, -1]], (2, 2)))
        self.assertEqual(self.model.rays([9, 0.1, 2], [-1, 0, 0]).distances.shape, ())
        hits = self.model.ray_hits([9, 0.1, 2], [-1, 0, 0])
        self.assertEqual((hits.places[:, 0].tolist(), hits.complete), ([0, 1, 1, 0], True))
        self.assertEqual([kind & nurbs.NURBS_RAY_BACK for kind in hits.kinds.tolist()], [0, nurbs.NURBS_RAY_BACK] * 2)
        self.assertEqual(len(self.model.ray_hits([9, 0.1, 2], [-1, 0, 0], part=[0, 5]).distances), 1)
        sides = self.model.classify([[4, 0.1, 2], [0, 0.1, 2], [4, 0, 4.0005]], 1e-3)
        self.assertEqual(sides.tolist(), [nurbs.NURBS_SIDE_INSIDE, nurbs.NURBS_SIDE_OUTSIDE, nurbs.NURBS_SIDE_ON])
        whole = self.model.instances()
        self.assertEqual([list(whole.parents), list(whole.uses), list(whole.parts)], [[-1], [0], [0]])
        np.testing.assert_array_equal(whole.placements, [np.eye(3, 4)])
        self.assertEqual(status_of(lambda: self.model.rays([0, 0, 0], [0, 0, 0])), nurbs.NURBS_ERROR_DIRECTION)
        self.assertEqual(status_of(lambda: nurbs.Model(self.model.faces[:2]).classify([0, 0, 0])), nurbs.NURBS_ERROR_GAP)
        with self.assertRaises(ValueError):
            self.model.rays([1, 2], [3, 4])

    def test_closest_points(self):
        points = np.array([[[9, 0.1, 2], [0, 0.1, 9]], [[0.5, 0.5, 0.5], [-1, -1, -1]]])
        found = self.model.closest_points(points, 1e-9)
        self.assertEqual((found.params.shape, found.places.shape), ((2, 2, 2), (2, 2, 2)))
        np.testing.assert_allclose(np.linalg.norm(found.points - points, axis=-1), found.distances, atol=1e-12)
        for point, distance, place in zip(points.reshape(-1, 3), found.distances.flat, found.places.reshape(-1, 2)):
            of_faces = [float(face.closest_points(point, 1e-9).distances) for face in self.model.faces]
            self.assertAlmostEqual(distance, min(of_faces), 8)
            self.assertAlmostEqual(of_faces[place[0]], min(of_faces), 8)
        self.assertTrue(np.all(found.status & nurbs.NURBS_CLOSEST_CERTIFIED))

    def test_sections(self):
        meet = self.model.sections([0, 0, 1], [2, 9], 1e-6)
        self.assertEqual((meet.ways.levels.tolist(), meet.ways.closed.tolist()), ([0, 0], [1, 1]))
        self.assertEqual((meet.ways.firsts[0], meet.ways.firsts[1]), (0, meet.ways.sizes[0]))
        self.assertEqual((meet.faces.faces[0], meet.faces.faces[-1], set(meet.faces.instances)), (0, 1, {0}))
        self.assertEqual((set(meet.joints.instances), meet.joints.gaps.max() < 1e-6), ({0}, True))
        self.assertEqual(self.model.sections([[1, 0, 0], [0, 1, 0]], [0, 0], 1e-6, work=10**9).ways.closed.tolist(), [1] * 4)
        self.assertEqual(self.model.sections([[1, 0, 0]], [0], 1e-6, work=1).counts.complete, False)
        with self.assertRaises(nurbs.NurbsError):
            self.model.sections([0, 0, 0], 1, 1e-6)

    def test_area_and_volume(self):
        area, volume = self.model.area(1e-12), self.model.volume(1e-12)
        self.assertAlmostEqual(area.value, 96 * math.pi, 9)
        self.assertAlmostEqual(volume.volume, 64 * math.pi, 9)
        np.testing.assert_allclose(volume.centroid, [0, 0, 2], atol=1e-12)
        self.assertAlmostEqual(volume.inertia[2, 2], 64 * math.pi * (25 + 9) / 2, 7)
        self.assertTrue(0 <= volume.openness < 1e-10 and 0 <= volume.error < 1e-9 and 0 <= area.error < 1e-9)
        self.assertEqual(nurbs.Model().volume().volume, 0)
        self.assertTrue(np.all(np.isnan(nurbs.Model().volume().centroid)))
        self.assertEqual(status_of(lambda: nurbs.Model(self.model.faces[:2]).volume()), nurbs.NURBS_ERROR_GAP)
        self.assertEqual(status_of(lambda: self.model.volume(work=1)), nurbs.NURBS_ERROR_WORK)

    def test_sewing(self):
        faces = [nurbs.Face(face.surface, face.curves, tolerance=1e-6) for face in self.model.faces]
        gaps = nurbs.Model(faces).edge_gaps()
        self.assertEqual(set(gaps.uses.tolist()), {1})
        sewn = nurbs.Model.sew(faces, 1e-6, 0.001)
        found = sewn.edge_gaps()
        self.assertEqual((set(found.uses.tolist()), set(found.bounded.tolist()), sewn.unit), ({2}, {1}, 0.001))
        self.assertTrue(np.all(found.gaps < 1e-6))
        self.assertAlmostEqual(sewn.volume(1e-9).volume, 64 * math.pi, 6)
        self.assertEqual(status_of(lambda: nurbs.Model.sew([], 1e-6)), nurbs.NURBS_ERROR_COUNT)
        self.assertEqual(status_of(lambda: nurbs.Model.sew(faces, 0)), nurbs.NURBS_ERROR_TOLERANCE)
        self.assertEqual(status_of(lambda: nurbs.Model.sew(faces + faces[:1], 1e-6)), nurbs.NURBS_ERROR_SAME)
        self.assertEqual(status_of(lambda: nurbs.Model.sew(faces, 1e-6, work=1)), nurbs.NURBS_ERROR_WORK)
        with self.assertRaises(TypeError):
            nurbs.Model.sew([BUSHING], 1e-6)

    def test_regions(self):
        plate = nurbs.Model.region([nurbs.circle(2, [0, 0]), nurbs.circle(1, [0, 0])], nurbs.NURBS_FILL_EVEN_ODD)
        disk = nurbs.Model.region([nurbs.circle(1, [2, 0])])
        self.assertEqual((len(plate.faces), len(plate.faces[0].loops)), (1, 2))
        self.assertAlmostEqual(plate.faces[0].area().value, 3 * math.pi, 9)
        areas = [sum(face.area().value for face in nurbs.Model.combine(rule, plate.faces, disk.faces).faces)
                 for rule in (nurbs.NURBS_REGION_UNION, nurbs.NURBS_REGION_INTERSECTION)]
        self.assertAlmostEqual(sum(areas), 4 * math.pi, 9)
        self.assertEqual(len(nurbs.Model.combine(nurbs.NURBS_REGION_DIFFERENCE, disk.faces, disk.faces).faces), 0)
        across = nurbs.line([-3, 0.5], [3, 0.5])
        halves = disk.faces[0].split([across])
        self.assertEqual((len(halves.faces), sorted(halves.edge_gaps().uses.tolist())), (2, [1, 1, 1, 2]))
        self.assertEqual(len(nurbs.Model.split(disk.faces[0], []).faces), 1)
        self.assertEqual(status_of(lambda: nurbs.Model.region([across])), nurbs.NURBS_ERROR_GAP)
        self.assertEqual(status_of(lambda: nurbs.Model.combine(0, disk.faces)), nurbs.NURBS_ERROR_RULE)
        self.assertEqual(status_of(lambda: disk.faces[0].split([across], work=1)), nurbs.NURBS_ERROR_WORK)

    def test_faces_trimmed_by_surfaces(self):
        ball, plane = nurbs.Face(nurbs.sphere()), nurbs.plane([4, 0, 0], [0, 4, 0], [-2, -2, 0.5])
        cap, rest = (ball.trim(plane, side, 1e-9) for side in (nurbs.NURBS_TRIM_FRONT, nurbs.NURBS_TRIM_BACK))
        self.assertAlmostEqual(cap.faces[0].area(1e-9).value, math.pi, 6)
        self.assertAlmostEqual(rest.faces[0].area(1e-9).value, 3 * math.pi, 6)
        self.assertEqual(len(nurbs.Model.trim(ball, nurbs.sphere(1, [9, 0, 0]), nurbs.NURBS_TRIM_FRONT, 1e-9).faces), 1)
        self.assertEqual(status_of(lambda: ball.trim(plane, 0, 1e-9)), nurbs.NURBS_ERROR_RULE)
        self.assertEqual(status_of(lambda: ball.trim(plane, nurbs.NURBS_TRIM_FRONT, 0)), nurbs.NURBS_ERROR_TOLERANCE)
        self.assertEqual(status_of(lambda: ball.trim(plane, 1, 1e-9, work=1)), nurbs.NURBS_ERROR_WORK)

    def test_models_that_meet(self):
        floor, wall = (nurbs.Model.create([nurbs.Face(nurbs.plane(*vectors))])
                       for vectors in (([2, 0, 0], [0, 4, 0]), ([0, 4, 0], [0, 0, 2], [1, 0, -1])))
        line = floor.meet(wall, 1e-9)
        self.assertEqual((line.counts.branches, line.counts.complete), (1, True))
        self.assertAlmostEqual(line.branch(0).space.length().value, 4, 8)
        self.assertEqual((line.faces.faces.tolist(), line.faces_second.faces.tolist()), ([0], [0]))
        self.assertRaises(nurbs.ArgumentError, floor.meet, wall, -1.0)

    def test_models_of_faces(self):
        two = nurbs.Model(self.model.faces[:2], 0.001)
        self.assertEqual(([face.name for face in two.faces], two.unit), (["0", "1"], 0.001))
        self.assertEqual(nurbs.Model().counts.faces, 0)
        self.assertEqual(repr(two), "<Model of 2 faces, 6 edges and 4 vertices>")
        del self.model
        self.assertEqual(copy.deepcopy(two).counts, two.copy().counts)

    def test_pickles(self):
        for protocol in range(pickle.HIGHEST_PROTOCOL + 1):
            again, bore = pickle.loads(pickle.dumps((self.model, self.model.faces[1]), protocol))
            self.assertEqual(again.to_bytes(), self.model.to_bytes())
            self.assertIs(type(bore), nurbs.ModelFace)
            self.assertEqual((bore.name, bore.shape, bore.area()), ("bore", nurbs.NURBS_SHAPE_CYLINDER, again.faces[1].area()))

    def test_what_is_wrong_is_said(self):
        self.assertEqual(status_of(lambda: nurbs.Model.read(b"solid")), nurbs.NURBS_ERROR_FORMAT)
        self.assertEqual(status_of(lambda: nurbs.Model([], -1)), nurbs.NURBS_ERROR_FACTOR)
        self.assertEqual(status_of(lambda: self.model.face(4)), nurbs.NURBS_ERROR_INDEX)
        with self.assertRaises(OSError):
            nurbs.Model.read_file("/no/such/file")
        with self.assertRaises(TypeError):
            nurbs.Model([BUSHING])
        with self.assertRaises(AttributeError):
            self.model.faces = []


if __name__ == "__main__":
    unittest.main()
