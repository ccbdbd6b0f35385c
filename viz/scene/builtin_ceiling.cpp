// SPDX-License-Identifier: GPL-3.0-or-later
// A hall under a coffered ceiling that is open to the sky, after the scene "Ceiling" of GMNPR 2007, Figures 7 and 9: beams,
// joists and ribs cast a fine lattice of shadows over floor, benches and columns. One unit is a metre; the floor's top is y = 0.
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <string>

#include "scene/builtin_scenes.h"
#include "scene/builtin_shapes.h"

namespace psm {
namespace {

using glm::dvec2, glm::dvec3;

enum MaterialIndex { kFloor, kBorder, kColumn, kBeam, kRosette, kBench };

constexpr double kHalfWidth = 6.0, kLength = 36.0, kHeight = 6.0, kBay = 3.0;  // the hall runs from z = 0 to -kLength
constexpr int kBays = int(kLength / kBay), kAcross = 4;                        // coffers along and across

shapes::Solid box(const dvec3& min, const dvec3& max) {
  const dvec3 middle = 0.5 * (min + max), half = 0.5 * (max - min);
  const std::vector<dvec2> contour{{-half.x, -half.y}, {half.x, -half.y}, {half.x, half.y}, {-half.x, half.y}};
  return shapes::transformed(shapes::extrude(contour, 2.0 * half.z), glm::translate(glm::dmat4(1.0), middle));
}

void add(Scene& scene, const shapes::Solid& solid, const std::string& name, int material) {
  Mesh mesh = shapes::shaded(solid, glm::radians(40.0));
  mesh.name = name, mesh.material = material;
  scene.meshes.push_back(std::move(mesh));
}

shapes::Solid at(const shapes::Solid& solid, const dvec3& where) {
  return shapes::transformed(solid, glm::translate(glm::dmat4(1.0), where));
}

void add_floor(Scene& scene) {
  add(scene, box({-kHalfWidth, -0.3, -kLength}, {kHalfWidth, 0, 0}), "floor", kFloor);
  shapes::Solid plinths;
  for (const double side : {-1.0, 1.0}) {
    const double x = side * (kHalfWidth + 0.4);
    shapes::append(plinths, box({x - 0.4, -0.3, -kLength}, {x + 0.4, 0.12, 0}));
  }
  add(scene, plinths, "plinths", kBorder);
}

/// Base, shaft that tapers, and capital.
shapes::Solid column() {
  const shapes::Outline outline = shapes::Outline()
                                      .to(0.36, 0.0)
                                      .to(0.36, 0.14)
                                      .bead(0.04, 0.12, 3)
                                      .curve({0.27, 0.30}, {0.26, 0.6}, 2)
                                      .to(0.22, 4.9)
                                      .bead(0.04, 0.1, 3)
                                      .curve({0.25, 5.2}, {0.40, 5.35}, 3)
                                      .to(0.40, 5.5)
                                      .to(0.0, 5.5);
  return shapes::lathe(outline.points(), 10);
}

void add_columns(Scene& scene) {
  const shapes::Solid one = column();
  for (const double side : {-1.0, 1.0}) {
    shapes::Solid row;
    for (int bay = 0; bay <= kBays; bay += 2) shapes::append(row, at(one, {side * (kHalfWidth + 0.4), 0.12, -bay * kBay}));
    add(scene, row, side < 0 ? "columns_left" : "columns_right", kColumn);
  }
}

/// Beams across and along, and a frame that steps inwards in each coffer.
void add_beams(Scene& scene) {
  shapes::Solid across, along, coffers;
  const double half = kHalfWidth + 0.7, low = kHeight - 0.38, bay_width = 2.0 * kHalfWidth / kAcross;
  for (int bay = 0; bay <= kBays; ++bay) {
    const double z = -bay * kBay;
    shapes::append(across, box({-half, low, z - 0.15}, {half, kHeight, z + 0.15}));
  }
  for (int i = 0; i <= kAcross; ++i) {
    const double x = -kHalfWidth + i * bay_width;
    shapes::append(along, box({x - 0.12, low + 0.04, -kLength - 0.3}, {x + 0.12, kHeight + 0.05, 0.3}));
  }
  const shapes::Solid frame =
      shapes::square_frame(1.12, {{0.0, 0.0}, {0.08, -0.06}, {0.16, -0.06}, {0.26, 0.02}, {0.26, 0.10}, {0.0, 0.10}});
  for (int bay = 0; bay < kBays; ++bay)
    for (int i = 0; i < kAcross; ++i)
      shapes::append(coffers, at(frame, {-kHalfWidth + (i + 0.5) * bay_width, kHeight - 0.14, -(bay + 0.5) * kBay}));
  add(scene, across, "beams_across", kBeam);
  add(scene, along, "beams_along", kBeam);
  add(scene, coffers, "coffers", kBeam);
}

/// A ring with ribs and a boss in the middle of a coffer: shadows of every width.
shapes::Solid rosette() {
  const double turn = glm::two_pi<double>();
  shapes::Solid solid = shapes::lathe(shapes::Outline().to(0.10, 0.02).ball(0.16, 3).points(), 8);
  for (int i = 0; i < 8; ++i) {
    const glm::dmat4 pose = glm::rotate(glm::dmat4(1.0), turn * i / 8, dvec3(0, 1, 0));
    shapes::append(solid, shapes::transformed(box({0.1, 0.02, -0.025}, {1.16, 0.08, 0.025}), pose));
  }
  // Four quarters, a hair's breadth apart: each is closed.
  for (int i = 0; i < 4; ++i)
    shapes::append(solid, shapes::ring_sector({0.62, 0.72}, {0.0, 0.1}, {turn * (i + 0.002) / 4, turn * (i + 0.998) / 4}, 4));
  return solid;
}

void add_rosettes(Scene& scene) {
  const shapes::Solid one = rosette();
  const double bay_width = 2.0 * kHalfWidth / kAcross;
  for (int i = 0; i < kAcross; ++i) {
    shapes::Solid row;
    for (int bay = 0; bay < kBays; ++bay)
      shapes::append(row, at(one, {-kHalfWidth + (i + 0.5) * bay_width, kHeight - 0.12, -(bay + 0.5) * kBay}));
    add(scene, row, "rosettes_" + std::to_string(i + 1), kRosette);
  }
}

/// Something to walk around: a bench before every other pair of columns.
void add_benches(Scene& scene) {
  shapes::Solid benches;
  for (int bay = 1; bay < kBays; bay += 2)
    for (const double side : {-1.0, 1.0}) {
      const double x = side * 3.6, z = -(bay + 0.5) * kBay;
      shapes::append(benches, box({x - 0.28, 0.42, z - 0.95}, {x + 0.28, 0.50, z + 0.95}));
      for (const double end : {-0.75, 0.75})
        shapes::append(benches, box({x - 0.22, 0.0, z + end - 0.06}, {x + 0.22, 0.42, z + end + 0.06}));
    }
  add(scene, benches, "benches", kBench);
}

}  // namespace

Scene make_ceiling() {
  Scene scene;
  scene.materials = shapes::plain_materials({0xE6E2D8u, 0xB9AE9Cu, 0xDCD6C8u, 0x9C6B44u, 0xC99A5Bu, 0x5F4632u});
  add_floor(scene);
  add_columns(scene);
  add_beams(scene);
  add_rosettes(scene);
  add_benches(scene);

  // As the papers have it: 60 degrees, n = 1 m and a far distance that nothing reaches.
  scene.camera = CameraSettings{
      .position = {0.6, 1.7, 1.6}, .target = {0.0, 1.9, -10.0}, .vertical_fov_deg = 60.0, .near = 1.0, .far = 800.0};

  scene.light = LightSettings{.type = LightType::directional, .to_light = {-0.45, 1.0, -0.42}};
  return scene;
}

}  // namespace psm
