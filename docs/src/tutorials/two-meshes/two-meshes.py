"""Makes two meshes of a brake, in millimetres: disc.msh and pad.msh, in the folder that is named, else here.

Needs gmsh: pip install gmsh.
"""

import math
import pathlib
import sys

import gmsh

FOLDER = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")
NEAR = 1e-6


def swept(radii, heights, angles, cells):
    """Bricks between two radii, heights and angles about the z-axis: so many along the radius, up, and around in each quarter."""
    geo = gmsh.model.geo
    start, end = angles
    turned = [(r * math.cos(start), r * math.sin(start)) for r in radii]
    (x, y), (far_x, far_y) = turned
    corners = [
        geo.addPoint(x, y, heights[0]),
        geo.addPoint(far_x, far_y, heights[0]),
        geo.addPoint(far_x, far_y, heights[1]),
        geo.addPoint(x, y, heights[1]),
    ]
    sides = [geo.addLine(corners[k], corners[(k + 1) % 4]) for k in range(4)]
    section = (2, geo.addPlaneSurface([geo.addCurveLoop(sides)]))
    for k, side in enumerate(sides):
        geo.mesh.setTransfiniteCurve(side, cells[k % 2] + 1)
    geo.mesh.setTransfiniteSurface(section[1])
    geo.mesh.setRecombine(2, section[1])
    parts = math.ceil((end - start) / (0.5 * math.pi) - NEAR)
    for _ in range(parts):
        step = (end - start) / parts
        made = geo.revolve([section], 0, 0, 0, 0, 0, 1, step, numElements=[cells[2]], recombine=True)
        section = made[0]
    geo.synchronize()


def named(sets):
    """Gives every surface whose nodes all lie where a set is the name of that set, and all bricks one material."""
    for name, is_there in sets.items():
        own = []
        for _, surface in gmsh.model.getEntities(2):
            _, places, _ = gmsh.model.mesh.getNodes(2, surface, includeBoundary=True)
            if all(is_there(*places[k : k + 3]) for k in range(0, len(places), 3)):
                own.append(surface)
        gmsh.model.addPhysicalGroup(2, own, name=name)
    gmsh.model.addPhysicalGroup(3, [volume for _, volume in gmsh.model.getEntities(3)], name="body")


def write(name, body, sets):
    gmsh.clear()
    swept(*body)
    gmsh.model.mesh.generate(3)
    gmsh.model.mesh.removeDuplicateNodes()
    named(sets)
    gmsh.write(str(FOLDER / name))


def at_radius(radius):
    return lambda x, y, z: abs(math.hypot(x, y) - radius) < NEAR * radius


def at_height(height):
    return lambda x, y, z: abs(z - height) < NEAR


def at_angle(angle):
    return lambda x, y, z: abs(math.atan2(y, x) - angle) < NEAR


gmsh.initialize()
gmsh.option.setNumber("General.Terminal", 0)
gmsh.option.setNumber("Mesh.MshFileVersion", 4.1)
FOLDER.mkdir(parents=True, exist_ok=True)
# a disc whose inner edge sits on its hub, in four quarters
write(
    "disc.msh",
    ((60.0, 120.0), (0.0, 10.0), (0.0, 2.0 * math.pi), (6, 2, 16)),
    {"hub": at_radius(60.0), "face": at_height(10.0)},
)
# a pad on it, whose end in the direction of sliding stands against an abutment
half = math.radians(25.0)
write(
    "pad.msh",
    ((76.0, 114.0), (10.0, 22.0), (-half, half), (5, 3, 9)),
    {"lining": at_height(10.0), "back": at_height(22.0), "abutment": at_angle(half)},
)
gmsh.finalize()
