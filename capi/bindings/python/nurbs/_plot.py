# SPDX-License-Identifier: MIT
"""Pictures of splines, meshes, faces and models, with Matplotlib, which is needed here only."""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any, Iterable, List, Optional, Tuple, cast

import numpy

from ._base import SplineBase

if TYPE_CHECKING:
    from ._arrays import Floats, Int64s
    from ._mesh import Mesh
    from ._spline import Spline

_COLOR, _NET = "#2f6db0", "#808080"
_PIECES = 32  # of a curve between two knots
_FACETS = 24  # along the longest axis, about
_SIDE = 4  # pieces of a side of a facet
_LIGHT = numpy.array([0.35, -0.5, 0.79])


def _matplotlib(name: str) -> Any:
    """A module of Matplotlib."""
    try:
        return import_module(f"matplotlib.{name}")
    except ImportError as error:
        raise ImportError("plot() needs Matplotlib: install python3-matplotlib, or nurbs[plot] with pip") from error


def _new_axes(dim: int) -> Any:
    pyplot = _matplotlib("pyplot")
    if dim == 2:
        return pyplot.figure(layout="constrained").add_subplot()
    with pyplot.rc_context({"grid.color": "#e4e4e4", "grid.linewidth": 0.5}):
        ax = pyplot.figure().add_axes((0.02, 0.02, 0.94, 0.96), projection="3d")
    for axis in (ax.xaxis, ax.yaxis, ax.zaxis):
        axis.set_pane_color((1.0, 1.0, 1.0, 0.0))
    return ax


def _without_jumps(spline: Spline) -> List[Spline]:
    """The parts between jumps, each of which is evaluated up to its ends."""
    parts = [spline]
    for axis in range(spline.axes):
        parts = [part for whole in parts for part in whole.split_at_knots(0, axis=axis)]
    return parts


def _breaks(spline: Spline, axis: int) -> Floats:
    """The knots of an axis in its domain."""
    (low, high), knots = spline.domain[axis], spline.distinct_knots[axis].knots
    inside: Floats = knots[(knots >= low) & (knots <= high)]
    return inside


def _divided(breaks: Floats, pieces: int) -> Floats:
    """Each span in equal pieces."""
    parts = numpy.linspace(breaks[:-1], breaks[1:], pieces, endpoint=False, axis=1)
    return numpy.append(parts, breaks[-1])


def _placed(spline: Spline, params: Tuple[Floats, ...], values: Floats) -> Floats:
    """Points on a grid as they are drawn: numbers above their parameters."""
    if spline.dimension > 1:
        return values
    return numpy.concatenate([*(p[..., None] for p in numpy.meshgrid(*params, indexing="ij")), values], axis=-1)


def _net(spline: Spline) -> Floats:
    """Control points as they are drawn: numbers above their Greville abscissae."""
    return _placed(spline, spline.greville, spline.points)


def _draw_net(ax: Any, net: Floats) -> None:
    for axis in range(net.ndim - 1):
        for row in numpy.moveaxis(net, axis, -2).reshape(-1, net.shape[axis], net.shape[-1]):
            ax.plot(*row.T, color=_NET, linewidth=0.8, linestyle="--", marker="s", markersize=3.5, zorder=1.5)


def _draw_curve(ax: Any, curve: Spline, color: Any, knots: bool) -> None:
    for part in _without_jumps(curve):
        breaks = _breaks(part, 0)
        params = _divided(breaks, _PIECES)
        ax.plot(*_placed(part, (params,), part.eval(params)).T, color=color, linewidth=1.8, zorder=2.5)
        if knots:
            ax.plot(*_placed(part, (breaks,), part.eval(breaks)).T, linestyle="none", marker="o", markersize=4.5,
                    markerfacecolor="white", markeredgecolor=color, zorder=3)


def _sizes(surface: Spline) -> List[float]:
    """About how long a surface is along its axes."""
    net = numpy.nan_to_num(_net(surface), posinf=0, neginf=0)
    steps = (numpy.linalg.norm(numpy.diff(net, axis=axis), axis=-1) for axis in range(2))
    return [float(step.sum(axis=axis).mean()) for axis, step in enumerate(steps)]


def _facets(surface: Spline, side: float) -> Floats:
    """Facets with sides of about one length, bounded by iso-curves: (facets, points once around, coordinates)."""
    params = []
    for axis, size in enumerate(_sizes(surface)):
        breaks, wanted = _breaks(surface, axis), size / side
        params.append(_divided(breaks, _SIDE * max(1, round(wanted / (len(breaks) - 1)))))
    grid = _placed(surface, (params[0], params[1]), surface.eval_grid(*params))
    steps = range(_SIDE)
    around = [(0, j) for j in steps] + [(j, _SIDE) for j in steps]
    around += [(_SIDE, _SIDE - j) for j in steps] + [(_SIDE - j, 0) for j in steps]
    ends = [size - 1 for size in grid.shape[:2]]
    sides = [grid[i:ends[0] - _SIDE + i + 1:_SIDE, j:ends[1] - _SIDE + j + 1:_SIDE] for i, j in around]
    facets: Floats = numpy.stack(sides, axis=-2).reshape(-1, len(around), grid.shape[-1])
    return facets


def _across(facets: Floats) -> Floats:
    """Normals of facets, by their diagonals."""
    normals: Floats = numpy.cross(facets[:, 2 * _SIDE] - facets[:, 0], facets[:, 3 * _SIDE] - facets[:, _SIDE])
    return normals


def _shades(normals: Floats, base: Floats, alpha: float) -> Floats:
    """Colours of facets in space with these normals, lit from both sides."""
    lengths = numpy.linalg.norm(normals, axis=-1)
    lit = numpy.abs(normals @ _LIGHT) / numpy.where(lengths > 0, lengths, 1)
    shade = (0.5 + 0.5 * lit)[:, None]
    # Bright places tend to white, dark ones to black.
    rgb = base * shade + 0.55 * (1 - base) * shade**3
    return numpy.concatenate([numpy.clip(rgb, 0, 1), numpy.full((len(normals), 1), alpha)], axis=1)


def _draw_surfaces(ax: Any, surfaces: Iterable[Spline], color: Any, alpha: float) -> None:
    parts = [part for surface in surfaces for part in _without_jumps(surface)]
    side = max(1e-300, *(size for part in parts for size in _sizes(part))) / _FACETS
    facets = numpy.concatenate([_facets(part, side) for part in parts])
    facets = facets[numpy.isfinite(facets).all(axis=(1, 2))]
    edges = {"edgecolors": "#00000060", "linewidths": 0.3}
    if facets.shape[-1] == 2:
        faces = _matplotlib("colors").to_rgba(color, 0.35 * alpha)
        ax.add_collection(_matplotlib("collections").PolyCollection(facets, facecolors=faces, **edges))
        ax.autoscale_view()
        return
    _add_facets(ax, facets, facecolors=_shades(_across(facets), _rgb(color), alpha), **edges)


def _rgb(color: Any) -> Floats:
    return numpy.array(_matplotlib("colors").to_rgb(color))


def _add_facets(ax: Any, facets: Floats, **looks: Any) -> None:
    """Facets (n, corners, 3) in space."""
    toolkit = import_module("mpl_toolkits.mplot3d.art3d")
    had_data = ax.has_data()  # without the facets: else the limits of empty axes stay in view
    ax.add_collection3d(toolkit.Poly3DCollection(facets, **looks))
    ax.auto_scale_xyz(*facets.reshape(-1, 3).T, had_data=had_data)


def _even_scales(ax: Any, dim: int) -> None:
    if dim == 2:
        ax.set_aspect("equal", adjustable="datalim")
    else:
        sizes = [numpy.ptp(limits) for limits in (ax.get_xlim(), ax.get_ylim(), ax.get_zlim())]
        ax.set_box_aspect(sizes, zoom=0.95)
        for name, size in zip("xyz", sizes):
            ax.locator_params(axis=name, nbins=max(2, round(7 * size / max(sizes))))


class _Picture:
    """What plot() draws of a mesh: triangles, and the segments of the polylines of edges."""

    def __init__(self, mesh: Mesh) -> None:
        self.points, self.triangles, self.faces, edges = mesh.points, mesh.triangles, mesh.faces, mesh.edges
        every, ends = mesh.edge_points, edges.firsts + edges.sizes - 1
        starts = numpy.setdiff1d(numpy.arange(len(every)), ends)
        self.segments: Int64s = numpy.stack([every[starts], every[starts + 1]], axis=-1)

    def draw(self, ax: Any, colors: Floats, edges: bool, alpha: float, parts: Any = None, instances: Any = None) -> Any:
        """Draws it with a colour (faces, 3) of each face; of a model, whose faces belong to `parts` (faces,), each part
        where its instances stand."""
        facets, lines, tints = self.points[self.triangles], self.points[self.segments], self._of_triangles(colors)
        if instances is not None:
            facets, lines, tints = self._placed(facets, lines, tints, self._of_triangles(parts), instances)
        ax = _new_axes(3) if ax is None else ax
        if ax.name == "3d":
            _draw_triangles(ax, facets, lines if edges else lines[:0], tints, alpha)
        else:
            _draw_flat(ax, facets[..., :2], lines[..., :2] if edges else lines[:0, :, :2], tints, alpha)
        _even_scales(ax, 3 if ax.name == "3d" else 2)
        return ax

    def _of_triangles(self, values: Any) -> Any:
        """For each triangle what is given for its face."""
        return numpy.repeat(values, self.faces.triangle_counts, axis=0)

    def _placed(self, facets: Floats, lines: Floats, tints: Floats, parts: Int64s, instances: Any) -> Tuple[Floats, ...]:
        of_points = numpy.full(len(self.points), -1)
        of_points[self.triangles] = parts[:, None]
        of_lines, placed = of_points[self.segments[:, 0]], []
        for part, placement in zip(instances.parts, instances.placements):
            here, move = parts == part, placement[:, :3].T
            placed.append((facets[here] @ move + placement[:, 3], lines[of_lines == part] @ move + placement[:, 3],
                           tints[here]))
        return tuple(numpy.concatenate(arrays) for arrays in zip(*placed))


def _draw_triangles(ax: Any, triangles: Floats, lines: Floats, tints: Floats, alpha: float) -> None:
    """Triangles with lines in one collection, sorted by what is farthest of each: the lines come after triangles that they
    are sides of, and before those in front."""
    normals = numpy.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    faces = _shades(normals, tints, alpha)
    inks = numpy.tile(numpy.array([0.05, 0.1, 0.15, alpha]), (len(lines), 1))
    # A triangle has sides of its own colour, so that nothing shines through between two of them.
    sides = faces if alpha == 1 else numpy.zeros_like(faces)
    _add_facets(ax, numpy.concatenate([triangles, lines[:, [0, 1, 1]]]), facecolors=numpy.concatenate([faces, inks]),
                edgecolors=numpy.concatenate([sides, inks]), zsort="max",
                linewidths=numpy.repeat([0.2, 0.8], [len(triangles), len(lines)]))


def _draw_flat(ax: Any, triangles: Floats, lines: Floats, tints: Floats, alpha: float) -> None:
    collections = _matplotlib("collections")
    faces = numpy.concatenate([tints, numpy.full((len(tints), 1), 0.35 * alpha)], axis=1)
    ax.add_collection(collections.PolyCollection(triangles, facecolors=faces, edgecolors="#00000060", linewidths=0.3))
    ax.add_collection(collections.LineCollection(lines, colors="black", linewidths=0.8))
    ax.autoscale_view()


def plot_mesh(mesh: Mesh, ax: Any, color: Any, edges: bool, alpha: float, dim: int = 3) -> Any:
    """Draws a mesh in one colour, in the plane or in space; returns the axes."""
    picture = _Picture(mesh)
    ax = _new_axes(dim) if ax is None else ax
    return picture.draw(ax, numpy.tile(_rgb(color), (len(picture.faces.triangle_counts), 1)), edges, alpha)


def plot_model(mesh: Mesh, ax: Any, color: Any, edges: bool, alpha: float, known: Any, parts: Any, instances: Any) -> Any:
    """Draws the mesh of a model where its parts stand, in the colours that are known of its faces, rows of NaN where none
    is, or in one colour, if that is not None."""
    rgb = _rgb(_COLOR if color is None else color)
    colors = numpy.where(numpy.isnan(known) | (color is not None), rgb, known)
    return _Picture(mesh).draw(ax, colors, edges, alpha, parts, instances)


class Plots(SplineBase):
    """Pictures."""

    def plot(self, ax: Any = None, *, color: Any = _COLOR, control: Optional[bool] = None, knots: bool = True,
             alpha: float = 1.0) -> Any:
        """Draws the spline into Matplotlib axes, new ones if None, and returns them.

        A curve is drawn with its control polygon and a ring at each knot, a surface as shaded facets between
        iso-curves, all knot lines among them, a volume by its faces; a spline of dimension 1 as a graph over its
        parameters. `control` draws the control net, by default of curves only, `knots` the rings. Raises ImportError
        without Matplotlib, ValueError if it cannot be drawn in the plane or in space.
        """
        spline = cast("Spline", self)
        dim = self.axes + 1 if self.dimension == 1 else self.dimension
        if dim not in (2, 3):
            raise ValueError(f"{self!r} cannot be drawn in the plane or in space")
        ax = _new_axes(dim) if ax is None else ax
        if self.axes == 1:
            _draw_curve(ax, spline, color, knots)
        else:
            _draw_surfaces(ax, [spline] if self.axes == 2 else spline.boundaries(), color, alpha)
        if control or (control is None and self.axes == 1):
            _draw_net(ax, _net(spline))
        if self.dimension > 1:
            _even_scales(ax, dim)
        return ax
