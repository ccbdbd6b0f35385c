// SPDX-License-Identifier: GPL-3.0-or-later
// An OpenGL context without any display: EGL surfaceless.
#pragma once

#include <memory>
#include <optional>

#include "scene/result.h"

namespace psm {

/// What to ask for: core 3.3, or ES 3.0 where there is no such thing; or ES 3.0 at once, as the browser has it.
enum class GlProfile { core_or_es, es };

/// Made current on construction; destroyed with the object.
class HeadlessContext {
 public:
  static Result<std::unique_ptr<HeadlessContext>> create(GlProfile profile = GlProfile::core_or_es);
  ~HeadlessContext();
  HeadlessContext(const HeadlessContext&) = delete;
  HeadlessContext& operator=(const HeadlessContext&) = delete;

 private:
  HeadlessContext() = default;
  void* display_ = nullptr;
  void* context_ = nullptr;
};

}  // namespace psm
