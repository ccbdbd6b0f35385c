// SPDX-License-Identifier: GPL-3.0-or-later
#include <imgui.h>

#include "harness.h"
#include "scene/matrix_text.h"

namespace psm::test {
namespace {

TEST(Matrices, KeyMCopiesThemInTheChosenLanguageAndClipSpace) {
  Bench bench;
  bench.key('M');
  EXPECT_EQ(std::string(ImGui::GetClipboardText()),
            matrices_text(bench.analysis(), MatrixLanguage::glsl, ClipConvention::opengl));
  bench.click(bench.at("matrices.language"));
  bench.click(bench.at("matrices.language=cpp"));
  bench.click(bench.at("matrices.convention"));
  bench.click(bench.at("matrices.convention=reversed_z"));
  bench.click(bench.at("matrices.copy"));
  EXPECT_EQ(std::string(ImGui::GetClipboardText()),
            matrices_text(bench.analysis(), MatrixLanguage::cpp, ClipConvention::reversed_z));
  const Settings kept = read_settings(bench.folder() / "config" / "settings.txt");
  EXPECT_EQ(kept.matrix_language, MatrixLanguage::cpp);
  EXPECT_EQ(kept.clip_convention, ClipConvention::reversed_z);
}

}  // namespace
}  // namespace psm::test
