import nurbs

# A quarter of the unit circle: points, tangents, the same points after inserting a knot, and a mistake.
arc = nurbs.Spline(degrees=2, knots=[0, 0, 0, 1, 1, 1], points=[[1, 0], [1, 1], [0, 1]], weights=[1, 0.5**0.5, 1])
params = [0, 0.25, 0.5, 0.75, 1]
derivs = arc.eval_derivs(params, order=1)  # an array of shape (5, 2, 2)
after = arc.insert_knot(0.3)(params)  # one of shape (5, 2)
for u, ((x, y), (dx, dy)), (fx, fy) in zip(params, derivs, after):
    print(f"C({u:.2f}) = ({x:.12f}, {y:.12f}), C' = ({dx:.3f}, {dy:.3f}), with a knot more ({fx:.12f}, {fy:.12f})")
try:
    arc(1.5)
except nurbs.NurbsError as error:
    print(f"a bad call says: {error.message}")
