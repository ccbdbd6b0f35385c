// SPDX-License-Identifier: GPL-3.0-or-later
// A chessboard in the light of a spot, after Figure 1 of "Perspective Shadow Maps" (Stamminger and Drettakis 2002).
// One square is one unit; the board is centred at the origin, its top is y = 0, and white sits at +z.
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <map>

#include "scene/builtin_pieces.h"
#include "scene/builtin_scenes.h"

namespace psm {
namespace {

enum MaterialIndex { kIvory, kEbony, kLightSquare, kDarkSquare, kFrame, kTable };

constexpr double kTableTop = -0.35, kTableHalf = 14.0, kFrameWidth = 0.75;

/// Italian game after three moves: all 32 pieces are there, and the middle of the board catches shadows.
/// Rank 8 first, files a to h; capitals are white.
constexpr std::array<const char*, 8> kPosition{"r.bqk.nr", "pppp.ppp", "..n.....", "..b.p...",
                                               "..B.P...", ".....N..", "PPPP.PPP", "RNBQK..R"};

struct Kind {
  char letter;
  const char* name;
  shapes::Solid (*make)();
  double turn;  // away from facing the opponent, so that the shape shows
};

const std::array<Kind, 6> kKinds{{{'p', "pawn", shapes::pawn, 0.0},
                                  {'r', "rook", shapes::rook, 0.26},
                                  {'n', "knight", shapes::knight, 1.15},
                                  {'b', "bishop", shapes::bishop, 0.6},
                                  {'q', "queen", shapes::queen, 0.0},
                                  {'k', "king", shapes::king, 1.35}}};

Mesh placed(const Mesh& piece, const glm::dvec3& where, double yaw) {
  Mesh mesh = piece;
  const glm::dmat4 world_from_piece = glm::rotate(glm::translate(glm::dmat4(1.0), where), yaw, glm::dvec3(0, 1, 0));
  for (glm::dvec3& p : mesh.positions) p = glm::dvec3(world_from_piece * glm::dvec4(p, 1.0));
  for (glm::vec3& n : mesh.normals) n = glm::vec3(glm::normalize(glm::dmat3(world_from_piece) * glm::dvec3(n)));
  return mesh;
}

void add_pieces(Scene& scene) {
  const double crease = glm::radians(48.0), quarter = glm::half_pi<double>();
  std::map<char, Mesh> prototypes;
  for (const Kind& kind : kKinds) prototypes[kind.letter] = shapes::shaded(kind.make(), crease);
  for (int row = 0; row < 8; ++row)
    for (int file = 0; file < 8; ++file)
      for (const Kind& kind : kKinds) {
        const char letter = kPosition[std::size_t(row)][file];
        if (char(letter | 32) != kind.letter) continue;
        const bool white = letter != kind.letter;
        Mesh mesh =
            placed(prototypes[kind.letter], {file - 3.5, 0.0, row - 3.5}, white ? quarter + kind.turn : -quarter + kind.turn);
        mesh.name = std::string(white ? "white_" : "black_") + kind.name + "_" + char('a' + file) + char('8' - row);
        mesh.material = white ? kIvory : kEbony;
        scene.meshes.push_back(std::move(mesh));
      }
}

void add_floor(Mesh& mesh, glm::dvec2 min, glm::dvec2 max, double y) {
  const auto first = std::uint32_t(mesh.positions.size());
  for (const glm::dvec2& p : {min, {min.x, max.y}, max, {max.x, min.y}}) {
    mesh.positions.push_back({p.x, y, p.y});
    mesh.normals.push_back({0, 1, 0});
  }
  for (std::uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u}) mesh.triangles.push_back(first + i);
}

void add_board(Scene& scene) {
  Mesh light, dark, table;
  light.name = "light_squares", light.material = kLightSquare;
  dark.name = "dark_squares", dark.material = kDarkSquare;
  table.name = "table", table.material = kTable;
  for (int row = 0; row < 8; ++row)
    for (int file = 0; file < 8; ++file)
      add_floor((row + file) % 2 == 0 ? light : dark, {file - 4, row - 4}, {file - 3, row - 3}, 0.0);
  add_floor(table, glm::dvec2(-kTableHalf), glm::dvec2(kTableHalf), kTableTop);

  const double edge = 0.05, lip = 0.04;
  Mesh frame = shapes::shaded(
      shapes::square_frame(
          4.0,
          {{0, kTableTop}, {0, 0}, {lip, lip}, {kFrameWidth - edge, lip}, {kFrameWidth, lip - edge}, {kFrameWidth, kTableTop}}),
      glm::radians(30.0));
  frame.name = "frame", frame.material = kFrame;
  for (Mesh* mesh : {&light, &dark, &frame, &table}) scene.meshes.push_back(std::move(*mesh));
}

}  // namespace

Scene make_chessboard() {
  Scene scene;
  scene.materials = shapes::plain_materials({0xF3EAD6u, 0x4E3426u, 0xF0EBDFu, 0xA88362u, 0x7A5334u, 0xD8D8D6u});
  add_pieces(scene);
  add_board(scene);

  // Low behind the corner a1, just above the tallest piece: the receivers' depths span a factor of fifteen.
  scene.camera = CameraSettings{
      .position = {-3.6, 2.05, 6.1}, .target = {0.35, 0.0, -0.3}, .vertical_fov_deg = 52.0, .near = 1.0, .far = 60.0};

  // Behind the board on the left, so that shadows fall towards the viewer: there a uniform map is too coarse.
  scene.light =
      LightSettings{.type = LightType::spot, .position = {-5.0, 9.0, -9.0}, .target = {0.0, 0.0, 0.0}, .cone_deg = 60.0};
  return scene;
}

}  // namespace psm
