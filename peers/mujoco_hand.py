"""The welded hand and an object on its hinge as a MuJoCo model (MJCF), from the same URDFs and settings as ours.

The world is the palm frame. A link whose joint is held is merged with the link that carries it, as in
harness/sim/articulated_hand.cpp. What differs from our model: box and cylinder have sharp edges (ours are rounded by
[object] rounding_m), contacts begin at touch, and contacts, joint stops and hinge friction are MuJoCo's soft
constraints.
"""

import math
import xml.etree.ElementTree as xml
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

# The joints in the order of harness/sim/joints.hpp, and the object's hinge.
JOINTS = {"fei": "index_1", "aai": "index_0", "fet": "thumb_1", "ot": "thumb_0"}
HINGE = "hinge"
OBJECT = "object"
FINGERS = ("index", "thumb")

CONTROL_STEP_S = 0.01

# A constraint's time constant in time steps: the hardest that MuJoCo takes.
TIME_CONSTANT_STEPS = 2


@dataclass(frozen=True)
class Options:
    """MuJoCo's choices that our model does not settle. The defaults are the fastest that were as accurate as any
    (bench/README.md); solver, iterations, tolerance and impedance are MuJoCo's own defaults."""

    integrator: str = "implicitfast"
    cone: str = "elliptic"
    solver: str = "Newton"
    iterations: int = 100
    tolerance: float = 1e-8
    # Impedance at touch and at depth, and the depth in m: a constraint of impedance d gives way by a share 1 - d.
    impedance: tuple = (0.9, 0.95, 0.001)
    # How much harder friction is than the normal direction.
    friction_impedance_ratio: float = 10
    # There is one island at most: looking for it only costs time.
    flags: dict = field(default_factory=lambda: {"island": "disable"})


# --- poses: 4 x 4 matrices ---


def rotation(roll, pitch, yaw):
    """URDF's fixed-axis roll, pitch and yaw in rad."""
    cr, sr, cp, sp, cy, sy = (f(a) for a in (roll, pitch, yaw) for f in (math.cos, math.sin))
    return np.array(
        [
            [cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr],
            [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr],
            [-sp, cp * sr, cp * cr],
        ]
    )


def pose(xyz, rpy):
    X = np.eye(4)
    X[:3, :3] = rotation(*rpy)
    X[:3, 3] = xyz
    return X


def turn(angle_rad):
    """About z."""
    return pose((0, 0, 0), (0, 0, angle_rad))


def origin_of(element):
    origin = element.find("origin")
    read = lambda name: numbers_of(origin.get(name, "0 0 0")) if origin is not None else (0, 0, 0)
    return pose(read("xyz"), read("rpy"))


def numbers_of(text):
    return [float(number) for number in text.split()]


def text_of(numbers):
    return " ".join(repr(float(number)) for number in np.ravel(numbers))


def pose_attributes(X):
    """A pose as MJCF's pos, xaxis and yaxis."""
    return {"pos": text_of(X[:3, 3]), "xyaxes": text_of(X[:3, :2].T)}


def palm_frame(root):
    """The palm frame in `hand`, of a URDF's root element."""
    return origin_of(root.find("joint[@name='palm_frame']"))


# --- the hand ---


def inertia_about_origin(link, X_body_link):
    """Mass in kg, first moment in kg m, and inertia in kg m2 about the body's origin, of a URDF link."""
    inertial = link.find("inertial")
    X = X_body_link @ origin_of(inertial)
    mass = float(inertial.find("mass").get("value"))
    entry = {name: float(value) for name, value in inertial.find("inertia").items()}
    along_inertial = np.array(
        [
            [entry["ixx"], entry["ixy"], entry["ixz"]],
            [entry["ixy"], entry["iyy"], entry["iyz"]],
            [entry["ixz"], entry["iyz"], entry["izz"]],
        ]
    )
    R, p = X[:3, :3], X[:3, 3]
    return mass, mass * p, R @ along_inertial @ R.T + point_inertia(mass, p)


def point_inertia(mass, p):
    return mass * (p @ p * np.eye(3) - np.outer(p, p))


def add_inertial(body, parts):
    """One inertia about the centre of mass for all (mass, first moment, inertia) of `parts`."""
    mass = sum(part[0] for part in parts)
    centre = sum(part[1] for part in parts) / mass
    inertia = sum(part[2] for part in parts) - point_inertia(mass, centre)
    full = [inertia[i, j] for i, j in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))]
    xml.SubElement(body, "inertial", pos=text_of(centre), mass=repr(float(mass)), fullinertia=text_of(full))


def capsule_of(link):
    """Radius and length in m of a URDF link's capsule, which lies along x from the link's origin."""
    cylinder = link.find("collision/geometry/cylinder")
    return float(cylinder.get("radius")), float(cylinder.get("length"))


class HandWriter:
    """Adds the index and the thumb to a MJCF body."""

    def __init__(self, urdf, settings):
        self.root = xml.parse(urdf).getroot()
        self.X_hand_palm = palm_frame(self.root)
        self.links = {link.get("name"): link for link in self.root.findall("link")}
        self.settings = settings["hand"]

    def add_fingers(self, world):
        for finger in FINGERS:
            joint = self.root.find(f"joint[@name='{finger}_0']")
            self.add_link(world, np.linalg.inv(self.X_hand_palm), joint, finger)

    def add_link(self, parent, X_parent_urdf_parent, joint, finger):
        """The link of a moving joint as a body, with all links that are held on it."""
        X_parent_body = X_parent_urdf_parent @ origin_of(joint)
        name = joint.get("name")
        body = xml.SubElement(parent, "body", name=name, gravcomp="1", **pose_attributes(X_parent_body))
        link, X_body_link, parts = joint, np.eye(4), []
        while link is not None and (link is joint or link.get("name") not in JOINTS.values()):
            if link is not joint:
                held_rad = math.radians(self.settings[f"{finger}_distal_deg"])
                X_body_link = X_body_link @ origin_of(link) @ turn(held_rad)
            urdf_link = self.links[link.find("child").get("link")]
            parts.append(inertia_about_origin(urdf_link, X_body_link))
            self.add_capsule(body, urdf_link, X_body_link)
            last, link = urdf_link, self.joint_on(urdf_link)
        add_inertial(body, parts)
        self.add_joint(body, joint, len(parts))
        if link is not None:
            self.add_link(body, X_body_link, link, finger)
            return
        tip = X_body_link @ np.array([capsule_of(last)[1], 0, 0, 1])
        xml.SubElement(body, "site", name=f"{finger}_tip", pos=text_of(tip[:3]))

    def joint_on(self, link):
        return next((j for j in self.root.findall("joint") if j.find("parent").get("link") == link.get("name")), None)

    def add_joint(self, body, joint, links):
        # Our model adds the reflected inertia about z to every link of the body. With the two axes of a finger at right
        # angles, and held axes parallel to the moving one, it acts on this joint alone: an armature.
        limit = joint.find("limit")
        xml.SubElement(
            body,
            "joint",
            name=joint.get("name"),
            axis="0 0 1",
            range=f"{limit.get('lower')} {limit.get('upper')}",
            armature=repr(links * self.settings["reflected_inertia_kg_m2"]),
        )

    def add_capsule(self, body, link, X_body_link):
        radius, length = capsule_of(link)
        ends = X_body_link @ np.array([[0, 0, 0, 1], [length, 0, 0, 1]]).T
        xml.SubElement(
            body,
            "geom",
            type="capsule",
            fromto=text_of(ends[:3].T),
            size=repr(radius),
            name=link.get("name"),
        )


# --- the object ---


def object_shape(urdf, settings):
    """MJCF type and size, and the moment of inertia in kg m2 about the hinge."""
    shape = xml.parse(urdf).getroot().find("link/collision/geometry")[0]
    mass = settings["mass_kg"]
    if shape.tag == "sphere":
        radius = float(shape.get("radius"))
        return "sphere", [radius], 0.4 * mass * radius**2
    if shape.tag == "cylinder":
        radius = float(shape.get("radius"))
        return "cylinder", [radius, settings["cylinder_height_m"] / 2], 0.5 * mass * radius**2
    scale = 2 if settings["cube_size"] == "half-diagonal" else 1
    sides = scale * np.array(numbers_of(shape.get("size")))
    return "box", sides / 2, mass * (sides[0] ** 2 + sides[1] ** 2) / 12


def add_object(world, urdf, settings):
    kind, size, inertia = object_shape(urdf, settings)
    centre = [settings["hinge_x_m"], settings["hinge_y_m"], settings["centre_z_m"]]
    body = xml.SubElement(world, "body", name=OBJECT, pos=text_of(centre))
    # Only the moment about the hinge acts; the same value on the other axes is as good as any.
    xml.SubElement(
        body, "inertial", pos="0 0 0", mass=repr(settings["mass_kg"]), diaginertia=text_of([inertia] * 3)
    )
    xml.SubElement(
        body,
        "joint",
        name=HINGE,
        axis="0 0 1",
        limited="false",
        frictionloss=repr(settings["coulomb_nm"]),
        damping=repr(settings["viscous_nms_per_rad"]),
    )
    xml.SubElement(body, "geom", name=OBJECT, type=kind, size=text_of(size))


# --- the model ---


def add_actuators(root, settings):
    """The PD law, whose gravity term is the bodies' gravcomp."""
    actuators = xml.SubElement(root, "actuator")
    limit = settings["torque_limit_nm"]
    for name, joint in JOINTS.items():
        xml.SubElement(
            actuators,
            "position",
            name=name,
            joint=joint,
            kp=repr(settings["stiffness_nm_per_rad"][name]),
            kv=repr(settings["damping_nms_per_rad"][name]),
            forcerange=f"{-limit} {limit}",
            ctrllimited="false",
        )


def add_contacts(root, friction, error_reduction, timestep_s, options):
    """Each finger link with the object and nothing else: listed pairs need no search."""
    # In one time step ours corrects a share `error_reduction` of a penetration. MuJoCo's does
    # 1 / (2 damping_ratio^2 x impedance x time constant in steps).
    damping_ratio = math.sqrt(1 / (2 * error_reduction * options.impedance[1] * TIME_CONSTANT_STEPS))
    contact = xml.SubElement(root, "contact")
    for geom in [geom.get("name") for geom in root.iter("geom") if geom.get("type") == "capsule"]:
        xml.SubElement(
            contact,
            "pair",
            geom1=geom,
            geom2=OBJECT,
            condim="3",
            friction=f"{friction} {friction} 0 0 0",
            solref=f"{TIME_CONSTANT_STEPS * timestep_s!r} {damping_ratio!r}",
            solimp=text_of(options.impedance),
        )


def add_options(root, settings, timestep_s, options, X_hand_palm):
    gravity = X_hand_palm[:3, :3].T @ settings["gravity_direction"] * settings["gravity_m_s2"]
    option = xml.SubElement(
        root,
        "option",
        timestep=repr(timestep_s),
        gravity=text_of(gravity),
        integrator=options.integrator,
        cone=options.cone,
        solver=options.solver,
        iterations=str(options.iterations),
        tolerance=repr(options.tolerance),
        impratio=repr(options.friction_impedance_ratio),
    )
    xml.SubElement(option, "flag", **options.flags)


def add_defaults(root, timestep_s, options):
    stiff = {"ref": f"{TIME_CONSTANT_STEPS * timestep_s!r} 1", "imp": text_of(options.impedance)}
    default = xml.SubElement(root, "default")
    xml.SubElement(default, "geom", contype="0", conaffinity="0", mass="0")
    names = {f"sol{part}{what}": value for part, value in stiff.items() for what in ("limit", "friction")}
    xml.SubElement(default, "joint", **names)


def mjcf(models, object_name, settings, substeps, options=Options()):
    """The model as MJCF text, for steps of 10 ms / substeps. `models` is the folder models/, `settings` the merged
    ones."""
    if settings["contact"]["index_thumb_contact"]:
        raise ValueError(
            "the MuJoCo model has no contact between index and thumb; set contact.index_thumb_contact = false"
        )
    if settings["hand"]["pd_law"] != "plain":
        raise ValueError("the MuJoCo model has the plain PD law alone; set hand.pd_law = plain")
    timestep_s = CONTROL_STEP_S / substeps
    root = xml.Element("mujoco", model=object_name)
    xml.SubElement(root, "compiler", angle="radian", autolimits="true")
    hand = HandWriter(Path(models) / "icub_right_hand.urdf", settings)
    add_options(root, settings["physics"], timestep_s, options, hand.X_hand_palm)
    add_defaults(root, timestep_s, options)
    world = xml.SubElement(root, "worldbody")
    hand.add_fingers(world)
    add_object(world, Path(models) / "objects" / f"{object_name}.urdf", settings["object"])
    add_contacts(root, settings["contact"]["friction"], settings["physics"]["error_reduction"], timestep_s, options)
    add_actuators(root, settings["hand"])
    xml.indent(root)
    return xml.tostring(root, encoding="unicode")
