// SPDX-License-Identifier: GPL-3.0-or-later
// Robots on a parade ground, after the scene "Robots" of GMNPR 2007, Figures 7 and 8. One unit is a metre, the ground is y = 0;
// the robots face +z, towards the viewer.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <string>

#include "scene/builtin_scenes.h"
#include "scene/builtin_shapes.h"

namespace psm {
namespace {

using glm::dmat4, glm::dvec2, glm::dvec3;
using shapes::Outline, shapes::Section, shapes::Solid;

enum MaterialIndex { kGround, kSlab, kShell, kAccent, kJoint, kEye };

/// What a robot holds in its pose, radians; left and right as it sees them.
struct Pose {
  double yaw, left_arm, right_arm, left_elbow, right_elbow, stride, head;
};

dmat4 moved(const dvec3& by) { return glm::translate(dmat4(1.0), by); }
dmat4 turned(double angle, const dvec3& axis) { return glm::rotate(dmat4(1.0), angle, axis); }

/// A limb that hangs down from the origin.
Solid limb(double length, double top, double bottom, int sides) {
  return shapes::transformed(
      shapes::lathe(
          Outline().to(bottom, 0.0).to(bottom, 0.05 * length).to(top, 0.95 * length).to(0.8 * top, length).to(0, length).points(),
          sides),
      moved({0, -length, 0}));
}

Solid ball(double radius, int steps, int sides) {
  return shapes::transformed(shapes::lathe(Outline().ball(radius, steps).points(), sides), moved({0, -radius, 0}));
}

/// Rounded boxes: lofts run along their own x and y, and are turned upright here.
Solid rounded_box(const dvec3& half, double squareness, int sides, int rings) {
  std::vector<Section> sections;
  for (int i = 0; i <= rings; ++i) {
    const double t = -1.0 + 2.0 * i / rings, bulge = std::pow(1.0 - std::pow(std::abs(t), 6.0), 1.0 / 6.0);
    const double w = 0.55 + 0.45 * bulge;
    sections.push_back({{half.x * w, half.y * t}, {-half.x * w, half.y * t}, half.z * w});
  }
  return shapes::loft(sections, sides, squareness);
}

/// The parts of one robot, by material.
struct Robot {
  Solid shell, accent, joint, eye;
};

void add_arm(Robot& robot, double side, double swing, double elbow) {
  const dmat4 shoulder = moved({side * 0.46, 1.50, 0}) * turned(-swing, {1, 0, 0}) * turned(side * 0.16, {0, 0, 1});
  const dmat4 forearm = shoulder * moved({0, -0.42, 0}) * turned(-elbow, {1, 0, 0});
  shapes::append(robot.joint, shapes::transformed(ball(0.13, 6, 12), shoulder));
  shapes::append(robot.shell, shapes::transformed(limb(0.42, 0.085, 0.07, 10), shoulder));
  shapes::append(robot.joint, shapes::transformed(ball(0.085, 4, 8), forearm));
  shapes::append(robot.accent, shapes::transformed(limb(0.40, 0.075, 0.095, 10), forearm));
  for (const double finger : {-1.0, 1.0}) {
    const dmat4 grip = forearm * moved({finger * 0.055, -0.40, 0}) * turned(finger * 0.25, {0, 0, 1});
    shapes::append(robot.joint, shapes::transformed(limb(0.16, 0.028, 0.018, 6), grip));
  }
}

void add_leg(Robot& robot, double side, double swing) {
  const dmat4 hip = moved({side * 0.19, 0.86, 0}) * turned(-swing, {1, 0, 0});
  const dmat4 knee = hip * moved({0, -0.40, 0}) * turned(std::abs(swing) * 0.5, {1, 0, 0});
  shapes::append(robot.joint, shapes::transformed(ball(0.12, 6, 12), hip));
  shapes::append(robot.shell, shapes::transformed(limb(0.40, 0.105, 0.08, 10), hip));
  shapes::append(robot.joint, shapes::transformed(ball(0.09, 4, 8), knee));
  shapes::append(robot.accent, shapes::transformed(limb(0.38, 0.08, 0.11, 10), knee));
  shapes::append(robot.shell, shapes::transformed(rounded_box({0.13, 0.07, 0.21}, 0.6, 10, 3), knee * moved({0, -0.39, 0.06})));
}

void add_head(Robot& robot, double turn) {
  const dmat4 neck = moved({0, 1.68, 0}) * turned(turn, {0, 1, 0});
  shapes::append(robot.joint, shapes::transformed(shapes::lathe(Outline().to(0.08, 0).to(0.08, 0.2).to(0, 0.2).points(), 10),
                                                  neck * moved({0, -0.08, 0})));
  shapes::append(robot.shell, shapes::transformed(rounded_box({0.21, 0.17, 0.19}, 0.55, 14, 6), neck * moved({0, 0.25, 0})));
  for (const double side : {-1.0, 1.0}) {
    const dmat4 socket = neck * moved({side * 0.085, 0.28, 0.175}) * turned(glm::half_pi<double>(), {1, 0, 0});
    shapes::append(robot.eye,
                   shapes::transformed(shapes::lathe(Outline().to(0.05, 0).to(0.05, 0.04).to(0, 0.04).points(), 12), socket));
    const dmat4 ear = neck * moved({side * 0.2, 0.25, 0}) * turned(-side * glm::half_pi<double>(), {0, 0, 1});
    shapes::append(robot.accent,
                   shapes::transformed(shapes::lathe(Outline().to(0.06, 0).to(0.045, 0.06).to(0, 0.06).points(), 10), ear));
  }
  const dmat4 mast = neck * moved({0, 0.40, 0});
  shapes::append(robot.joint,
                 shapes::transformed(shapes::lathe(Outline().to(0.014, 0).to(0.010, 0.28).to(0, 0.28).points(), 6), mast));
  shapes::append(robot.accent, shapes::transformed(ball(0.04, 4, 6), mast * moved({0, 0.30, 0})));
}

Robot make_robot(const Pose& pose) {
  Robot robot;
  shapes::append(robot.shell, shapes::transformed(rounded_box({0.36, 0.34, 0.24}, 0.5, 16, 8), moved({0, 1.30, 0})));
  shapes::append(robot.accent, shapes::transformed(rounded_box({0.17, 0.11, 0.05}, 0.5, 10, 3), moved({0, 1.36, 0.22})));
  shapes::append(robot.joint, shapes::transformed(rounded_box({0.24, 0.11, 0.17}, 0.6, 12, 3), moved({0, 0.90, 0})));
  add_head(robot, pose.head);
  add_arm(robot, 1.0, pose.left_arm, pose.left_elbow);
  add_arm(robot, -1.0, pose.right_arm, pose.right_elbow);
  add_leg(robot, 1.0, pose.stride);
  add_leg(robot, -1.0, -pose.stride);
  return robot;
}

/// Where they stand: each about as much farther away as the last, so that near and far shadows can be compared.
struct Place {
  double x, z;
  Pose pose;
};
const std::array<Place, 4> kPlaces{{{-1.25, -3.4, {0.35, 0.5, -0.35, 0.5, 0.3, 0.35, 0.25}},
                                    {1.6, -5.6, {-0.3, -0.3, 2.7, 0.4, 0.5, 0.0, -0.3}},
                                    {-0.4, -9.0, {0.6, 0.4, -0.5, 0.8, 0.2, -0.4, 0.0}},
                                    {-8.6, -16.0, {-0.2, 2.6, 1.5, 0.3, 0.1, 0.3, 0.2}}}};

/// Of the feet, which belong to the shell.
double lowest(const Robot& robot) {
  double y = robot.shell.positions.front().y;
  for (const dvec3& p : robot.shell.positions) y = std::min(y, p.y);
  return y;
}

void add_robots(Scene& scene) {
  for (std::size_t i = 0; i < kPlaces.size(); ++i) {
    const Place& place = kPlaces[i];
    const Robot robot = make_robot(place.pose);
    const dmat4 world = moved({place.x, -lowest(robot), place.z}) * turned(place.pose.yaw, {0, 1, 0});
    const std::string name = "robot_" + std::to_string(i + 1) + "_";
    const auto add = [&](const Solid& part, const char* what, int material) {
      Mesh mesh = shapes::shaded(shapes::transformed(part, world), glm::radians(45.0));
      mesh.name = name + what, mesh.material = material;
      scene.meshes.push_back(std::move(mesh));
    };
    add(robot.shell, "shell", kShell);
    add(robot.accent, "accent", kAccent);
    add(robot.joint, "joints", kJoint);
    add(robot.eye, "eyes", kEye);
  }
}

/// Concrete slabs five metres wide, in two tones.
void add_ground(Scene& scene) {
  constexpr int kColumns = 16, kRows = 20;
  constexpr double kSize = 5.0, kNearest = 10.0;
  Mesh tones[2];
  for (int row = 0; row < kRows; ++row)
    for (int column = 0; column < kColumns; ++column) {
      const double x = (column - kColumns / 2) * kSize, near_z = kNearest - row * kSize;
      shapes::append_tile(tones[(row + column) % 2], {x, near_z - kSize}, {x + kSize, near_z});
    }
  tones[0].name = "ground", tones[0].material = kGround;
  tones[1].name = "slabs", tones[1].material = kSlab;
  for (Mesh& mesh : tones) scene.meshes.push_back(std::move(mesh));
}

}  // namespace

Scene make_robots() {
  Scene scene;
  scene.materials = shapes::plain_materials({0xE6E6E2u, 0xD5D5D0u, 0xC9D3DCu, 0xD9772Bu, 0x5C646Cu, 0x1F3A4Du});
  add_robots(scene);
  add_ground(scene);

  // As the paper has it: 60 degrees, n = 1 m and a far distance that nothing reaches.
  scene.camera = CameraSettings{
      .position = {0.0, 1.75, 0.0}, .target = {0.0, 1.1, -8.0}, .vertical_fov_deg = 60.0, .near = 1.0, .far = 800.0};

  scene.light = LightSettings{.type = LightType::directional, .to_light = {-0.8, 0.85, -0.55}};
  return scene;
}

}  // namespace psm
