// SPDX-License-Identifier: GPL-3.0-or-later
// How wide text is in the typeface that pages are set in, without anything that draws.
#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <memory>
#include <string>

#include "scene/result.h"

namespace psm {

class Font {
 public:
  static Result<Font> load(const std::filesystem::path& file);

  /// Of one line whose height, ascent plus descent, is given.
  glm::dvec2 text_size(const std::string& text, double height) const;

 private:
  struct State;
  std::shared_ptr<const State> state_;
};

}  // namespace psm
