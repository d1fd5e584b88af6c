"""The hand as MuJoCo's own reader of URDF sees it: all 19 joints, the world is the frame of the link `hand`."""

import math
import xml.etree.ElementTree as xml

import mujoco
import numpy as np

from mujoco_hand import FINGERS, palm_frame
from mujoco_state import controlled_joints, mass_matrix


class UrdfHand:
    """`hand_settings` are the section [hand], which says at which angles the distal joints are held."""

    def __init__(self, urdf, hand_settings):
        self.model = mujoco.MjModel.from_xml_path(str(urdf))
        self.X_hand_palm = palm_frame(xml.parse(urdf).getroot())
        self.data = mujoco.MjData(self.model)
        self.joints = controlled_joints(self.model)
        for finger in FINGERS:
            for held in (f"{finger}_2", f"{finger}_3"):
                self.data.joint(held).qpos = math.radians(hand_settings[f"{finger}_distal_deg"])

    def set_angles(self, angle_rad):
        self.data.qpos[self.joints] = angle_rad
        mujoco.mj_forward(self.model, self.data)

    def tip_m(self, finger):
        """In the palm frame: the centre of the sphere that is furthest along the last link."""
        link = self.data.body(f"hand_{finger}_3")
        spheres = [
            geom
            for geom in range(self.model.ngeom)
            if self.model.geom_bodyid[geom] == link.id and self.model.geom_type[geom] == mujoco.mjtGeom.mjGEOM_SPHERE
        ]
        tip = max(spheres, key=lambda geom: self.model.geom_pos[geom][0])
        p_hand_tip_m = np.append(self.data.geom_xpos[tip], 1)
        return (np.linalg.inv(self.X_hand_palm) @ p_hand_tip_m)[:3]

    def mass(self):
        return mass_matrix(self.model, self.data, self.joints)
