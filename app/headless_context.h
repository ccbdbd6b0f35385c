// SPDX-License-Identifier: GPL-3.0-or-later
// An OpenGL context without any display: EGL surfaceless.
#pragma once

#include <memory>
#include <optional>

#include "scene/result.h"

namespace psm {

/// Made current on construction; destroyed with the object.
class HeadlessContext {
 public:
  static Result<std::unique_ptr<HeadlessContext>> create();
  ~HeadlessContext();
  HeadlessContext(const HeadlessContext&) = delete;
  HeadlessContext& operator=(const HeadlessContext&) = delete;

 private:
  HeadlessContext() = default;
  void* display_ = nullptr;
  void* context_ = nullptr;
};

}  // namespace psm
