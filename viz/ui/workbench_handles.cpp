// SPDX-License-Identifier: GPL-3.0-or-later
// The world view's handles by keyboard: N selects one after the other, the arrow keys move what is selected.
#include <imgui.h>

#include <algorithm>

#include "ui/workbench.h"

namespace psm {
namespace {

constexpr double kStep = 8.0, kFineStep = 1.0;  // pixels at scale 1

/// How far the arrow keys ask to go in this frame, in steps; y downwards. Held keys repeat.
glm::dvec2 arrow_steps() {
  const auto pressed = [](int code) { return ImGui::IsKeyPressed(code, true) ? 1.0 : 0.0; };
  return {pressed(key::right) - pressed(key::left), pressed(key::down) - pressed(key::up)};
}

bool any_arrow_down() {
  return ImGui::IsKeyDown(key::left) || ImGui::IsKeyDown(key::right) || ImGui::IsKeyDown(key::up) || ImGui::IsKeyDown(key::down);
}

}  // namespace

// Through all handles that the view shows, then none.
void Workbench::select_handle(int step) {
  if (images_.size(ViewId::world).x == 0 || !world_shown_) {
    message_ = "the handles are in the world view";
    return;
  }
  std::vector<std::optional<HandleKind>> kinds{std::nullopt};
  for (const Handle& handle : handles(images_.picture(ViewId::world), images_.analysis().experiment, images_.size(ViewId::world)))
    kinds.push_back(handle.kind);
  const auto now = std::find(kinds.begin(), kinds.end(), drag_.selected);
  const int count = int(kinds.size()), at = now == kinds.end() ? 0 : int(now - kinds.begin());
  drag_.selected = kinds[std::size_t((at + step + count) % count)];
  message_ = drag_.selected ? std::string(name_of(*drag_.selected)) + ": the arrow keys move it" : "";
}

// As the mouse would: in the plane of the picture, with Shift along the vertical; with Ctrl a pixel at a time.
void Workbench::move_selected_handle(const Rect& world, double scale, Experiment& edited, std::string& tag) {
  world_shown_ = !world.empty();
  if (!drag_.selected || !world_shown_ || dialogs_.shown() != Dialogs::Kind::none || is_typing()) return;
  if (any_arrow_down()) wake();
  const glm::dvec2 steps = arrow_steps();
  if (steps == glm::dvec2(0.0)) return;
  const ImGuiIO& io = ImGui::GetIO();
  const auto all = handles(images_.picture(ViewId::world), images_.analysis().experiment, world.size());
  const auto found = std::find_if(all.begin(), all.end(), [&](const Handle& h) { return h.kind == *drag_.selected; });
  if (found == all.end()) return;
  const double aspect = double(world.size().x) / std::max(1, world.size().y);
  const HandleDrag drag{*found,       edited,       view_camera(ViewId::world, images_.analysis(), aspect),
                        world.size(), found->pixel, shown_vanishing_plane(images_.analysis()).value_or(glm::dvec4(0.0))};
  const ViewSettings view = edited.view;
  edited = dragged(drag, found->pixel + steps * (io.KeyCtrl ? kFineStep : kStep) * scale, io.KeyShift);
  edited.view = view;
  tag = "arrow keys";
}

}  // namespace psm
