"""Writes the meshes beside this file with Gmsh: python write.py (package gmsh 4.15.2).

A quarter of a ring in the plane (inner radius 1, outer radius 2, physical curves inner, outer, start, end and surface ring; its
surface is seen from below, so that its elements turn to the right) and a box of 3 x 2 x 1 (physical surfaces left and right, a curve
edge, a point corner, a volume without a name). In format 4.1, and with 22 in the name in format 2.2.
"""

import pathlib

import gmsh

HERE = pathlib.Path(__file__).parent


def quarter_ring(quadrilaterals):
    geo = gmsh.model.geo
    centre = geo.addPoint(0, 0, 0)
    points = [geo.addPoint(*place, 0) for place in [(1, 0), (2, 0), (0, 2), (0, 1)]]
    start = geo.addLine(points[0], points[1])
    outer = geo.addCircleArc(points[1], centre, points[2])
    end = geo.addLine(points[2], points[3])
    inner = geo.addCircleArc(points[3], centre, points[0])
    ring = geo.addPlaneSurface([geo.addCurveLoop([-inner, -end, -outer, -start])])
    for curve, nodes in {start: 3, outer: 5, end: 3, inner: 5}.items():
        geo.mesh.setTransfiniteCurve(curve, nodes)
    geo.mesh.setTransfiniteSurface(ring)
    if quadrilaterals:
        geo.mesh.setRecombine(2, ring)
    geo.synchronize()
    for name, curve in {"start": start, "outer": outer, "end": end, "inner": inner}.items():
        gmsh.model.addPhysicalGroup(1, [curve], name=name)
    gmsh.model.addPhysicalGroup(2, [ring], name="ring")


def in_two_groups(quadrilaterals):
    """The ring once more, its surface also in the group `all`, its outer curve also in `rim`: 2.2 writes each element twice."""
    quarter_ring(quadrilaterals)
    (_, ring), = gmsh.model.getEntities(2)
    outer = gmsh.model.getEntitiesForPhysicalName("outer")
    gmsh.model.addPhysicalGroup(2, [ring], name="all")
    gmsh.model.addPhysicalGroup(1, [tag for _, tag in outer], name="rim")


def box(bricks):
    geo = gmsh.model.geo
    corners = [geo.addPoint(*place, 0) for place in [(0, 0), (3, 0), (3, 2), (0, 2)]]
    sides = [geo.addLine(corners[k], corners[(k + 1) % 4]) for k in range(4)]
    bottom = geo.addPlaneSurface([geo.addCurveLoop(sides)])
    geo.mesh.setTransfiniteCurve(sides[0], 3)
    geo.mesh.setTransfiniteCurve(sides[2], 3)
    geo.mesh.setTransfiniteCurve(sides[1], 2)
    geo.mesh.setTransfiniteCurve(sides[3], 2)
    geo.mesh.setTransfiniteSurface(bottom)
    if bricks:
        geo.mesh.setRecombine(2, bottom)
    made = geo.extrude([(2, bottom)], 0, 0, 1, numElements=[1], recombine=bricks)
    geo.synchronize()
    _, volume, _, right, _, left = [tag for _, tag in made]
    gmsh.model.addPhysicalGroup(2, [left], name="left")
    gmsh.model.addPhysicalGroup(2, [right], name="right")
    gmsh.model.addPhysicalGroup(1, [sides[0]], name="edge")
    gmsh.model.addPhysicalGroup(0, [corners[0]], name="corner")
    gmsh.model.addPhysicalGroup(3, [volume], tag=7)


def write(name, build, first, dimension, order, binary=False, version=4.1):
    gmsh.clear()
    build(first)
    gmsh.option.setNumber("Mesh.MshFileVersion", version)
    gmsh.model.mesh.generate(dimension)
    gmsh.model.mesh.setOrder(order)
    gmsh.option.setNumber("Mesh.Binary", int(binary))
    gmsh.write(str(HERE / name))


gmsh.initialize()
gmsh.option.setNumber("General.Terminal", 0)
gmsh.option.setNumber("Mesh.SecondOrderIncomplete", 1)
for name, quadrilaterals, order in [("quad4", True, 1), ("quad8", True, 2), ("triangle6", False, 2)]:
    write(f"{name}.msh", quarter_ring, quadrilaterals, 2, order)
for name, bricks, order in [("hexahedron8", True, 1), ("hexahedron20", True, 2), ("tetrahedron10", False, 2)]:
    write(f"{name}.msh", box, bricks, 3, order)
write("quad8_binary.msh", quarter_ring, True, 2, 2, binary=True)
write("hexahedron20_binary.msh", box, True, 3, 2, binary=True)
write("quad8_22.msh", quarter_ring, True, 2, 2, version=2.2)
write("quad8_22_binary.msh", quarter_ring, True, 2, 2, binary=True, version=2.2)
write("tetrahedron10_22.msh", box, False, 3, 2, version=2.2)
write("hexahedron20_22_binary.msh", box, True, 3, 2, binary=True, version=2.2)
write("two_groups.msh", in_two_groups, True, 2, 1)
write("two_groups_22.msh", in_two_groups, True, 2, 1, version=2.2)
write("two_groups_22_binary.msh", in_two_groups, True, 2, 1, binary=True, version=2.2)
