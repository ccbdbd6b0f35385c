// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/host.h"

#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>

namespace psm {
namespace {

/// ImGui's own keys by our numbers.
void name_keys(ImGuiIO& io) {
  constexpr struct {
    ImGuiKey imgui;
    int ours;
  } keys[] = {{ImGuiKey_Tab, key::tab},
              {ImGuiKey_LeftArrow, key::left},
              {ImGuiKey_RightArrow, key::right},
              {ImGuiKey_UpArrow, key::up},
              {ImGuiKey_DownArrow, key::down},
              {ImGuiKey_PageUp, key::page_up},
              {ImGuiKey_PageDown, key::page_down},
              {ImGuiKey_Home, key::home},
              {ImGuiKey_End, key::end},
              {ImGuiKey_Insert, key::insert},
              {ImGuiKey_Delete, key::del},
              {ImGuiKey_Backspace, key::backspace},
              {ImGuiKey_Space, ' '},
              {ImGuiKey_Enter, key::enter},
              {ImGuiKey_Escape, key::escape},
              {ImGuiKey_KeyPadEnter, key::keypad_enter},
              {ImGuiKey_A, 'A'},
              {ImGuiKey_C, 'C'},
              {ImGuiKey_V, 'V'},
              {ImGuiKey_X, 'X'},
              {ImGuiKey_Y, 'Y'},
              {ImGuiKey_Z, 'Z'}};
  for (const auto& k : keys) io.KeyMap[k.imgui] = k.ours;
}

}  // namespace

Host::Host(Screen::Target target) : screen_(target), context_(ImGui::CreateContext()) {
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;  // nothing is left in the working folder
  io.LogFilename = nullptr;
  io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
  io.ConfigDragClickToInputText = true;   // a click on a number is meant to type: its keys must not fire shortcuts
  io.ConfigInputTextCursorBlink = false;  // idle means idle
  name_keys(io);
  ImGui_ImplOpenGL3_Init(Screen::glsl_version());
}

Host::~Host() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui::DestroyContext(context_);
}

// Between frames: the old atlas must not be in use.
void Host::update_look(const LookKey& look, const std::filesystem::path& font) {
  if (look == look_) return;
  look_ = look;
  apply_look(look, font);
  ImGui_ImplOpenGL3_DestroyFontsTexture();
  ImGui_ImplOpenGL3_CreateFontsTexture();
}

void Host::frame(Workbench& workbench, InputQueue& input, glm::ivec2 size, double display_scale, double seconds_since_last) {
  size = glm::max(size, glm::ivec2(1));
  ImGui_ImplOpenGL3_NewFrame();
  update_look(workbench.look(size, display_scale), workbench.font());
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {float(size.x), float(size.y)};
  io.DisplayFramebufferScale = {1.0f, 1.0f};
  io.DeltaTime = float(std::clamp(seconds_since_last, 1e-4, 60.0));
  const auto presses = input.feed(io, workbench.holds_input());
  ImGui::NewFrame();
  workbench.frame(size, display_scale, presses);
  ImGui::Render();
  screen_.begin(size, ground_color(workbench.settings().theme));
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  if (workbench.wants_screen()) workbench.take_screen(screen_.read());
}

}  // namespace psm
