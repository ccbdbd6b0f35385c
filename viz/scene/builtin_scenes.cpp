// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/builtin_scenes.h"

#include <array>

namespace psm {
namespace {

struct Builtin {
  const char* id;
  Scene (*make)();
};

constexpr std::array kBuiltins{Builtin{"chessboard", make_chessboard}, Builtin{"ground", make_ground}, Builtin{"ball", make_ball},
                               Builtin{"robots", make_robots}, Builtin{"ceiling", make_ceiling}};

}  // namespace

std::vector<std::string> builtin_scene_ids() {
  std::vector<std::string> ids;
  for (const Builtin& builtin : kBuiltins) ids.push_back(builtin.id);
  return ids;
}

Result<Scene> builtin_scene(const std::string& id) {
  std::string known;
  for (const Builtin& builtin : kBuiltins) {
    if (builtin.id != id) {
      known += (known.empty() ? "" : ", ") + std::string(builtin.id);
      continue;
    }
    Scene scene = builtin.make();
    scene.id = id;
    update_bounds(scene);
    return scene;
  }
  return InputError{"scene \"" + id + "\": no built-in scene has this name; allowed: " + known};
}

}  // namespace psm
