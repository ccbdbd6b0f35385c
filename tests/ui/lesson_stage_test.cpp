// SPDX-License-Identifier: GPL-3.0-or-later
// A lesson in front of a class: every step of every lesson fits on its screens, and a clicker's keys go through them.
#include "ui/lesson_stage.h"

#include <gmock/gmock.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <fstream>

#include "app/assets.h"
#include "harness.h"

namespace psm::test {
namespace {

using ::testing::ElementsAre;

TEST(LessonStage, PartsGoOntoScreensInGroups) {
  const std::vector<PartSize> parts{{40, true}, {30}, {20, true}, {20}, {90, true}};
  EXPECT_THAT(*spread_over_screens(parts, 2, 300), ElementsAre(0u));
  EXPECT_THAT(*spread_over_screens(parts, 2, 100), ElementsAre(0u, 2u, 4u)) << "the second group stays together";
  EXPECT_THAT(*spread_over_screens(parts, 2, 116), ElementsAre(0u, 4u));
  EXPECT_FALSE(spread_over_screens(parts, 2, 80)) << "one part alone is higher";
  EXPECT_TRUE(stays_on_screens(parts, {0, 4}, 2, 116));
  EXPECT_FALSE(stays_on_screens(parts, {0, 4}, 2, 115));
  EXPECT_FALSE(stays_on_screens(parts, {0, 9}, 2, 1000)) << "there is no ninth part";
}

TEST(LessonStage, FewScreensComeBeforeLargeTypeAndThatBeforeWideViews) {
  const glm::ivec2 window(1000, 960);  // type of 32 to 40
  const auto of_area = [](double area) {
    return [=](double width, double size) { return std::optional(std::vector<PartSize>{{area * size * size / width, true}}); };
  };
  const StageFit little = fit_stage(window, 900, 10, 5, of_area(100));
  EXPECT_EQ(little.size, 40);
  EXPECT_EQ(little.column, 380) << "the narrowest";
  const StageFit more = fit_stage(window, 900, 10, 5, of_area(370));
  EXPECT_EQ(more.begins.size(), 1u);
  EXPECT_EQ(more.size, 36);
  EXPECT_EQ(more.column, 560);
  EXPECT_FALSE(fit_stage(window, 900, 10, 5, of_area(1e6)).fits);
}

/// ImGui without a renderer, in a window of this size, presenting.
class Stage {
 public:
  explicit Stage(glm::ivec2 window) : window_(window), context_(ImGui::CreateContext()) {
    ImGui::SetCurrentContext(context_);
    ImGui::GetIO().IniFilename = nullptr;
    const double scale = presenting_scale(window, 1.0);
    apply_look({int(largest_stage_type(window.y)), scale, Theme::light}, font_file());
    ImGui::GetIO().DisplaySize = {float(window.x), float(window.y)};
  }
  ~Stage() { ImGui::DestroyContext(context_); }
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

  void check_step(const Model& model, const LessonSession& session) {
    ImGui::SetCurrentContext(context_);
    while (panel_.turn_screen(-1)) {
    }
    std::size_t screens = 1;
    for (std::size_t screen = 0; screen < screens; ++screen) {
      // The second frame knows how much the first one drew.
      for (int frame = 0; frame < 2; ++frame) draw(model, session);
      screens = panel_.stage().begins.size();
      check_screen(session.run()->lesson().name + "/" + std::to_string(session.run()->index() + 1) + " screen " +
                   std::to_string(screen + 1) + " of " + std::to_string(screens) + " at " + std::to_string(window_.x) + "x" +
                   std::to_string(window_.y));
      EXPECT_EQ(panel_.turn_screen(+1), screen + 1 < screens) << "there is one more screen, or none";
    }
  }

 private:
  void draw(const Model& model, const LessonSession& session) {
    places_.clear();
    UiContext ui{model, Theme::light, presenting_scale(window_, 1.0), places_, none_};
    Experiment experiment = model.experiment();
    const int bar = int(std::ceil(1.75 * least_stage_type(window_.y)));
    ImGui::NewFrame();
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize(ImGui::GetIO().DisplaySize);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::Begin("workbench", nullptr, ImGuiWindowFlags_NoDecoration);
    const double column = panel_.set_stage(ui, session, window_, window_.y - bar, experiment);
    (void)panel_.draw_stage(ui, session, {{0, 0}, {int(column), window_.y - bar}}, experiment);
    ImGui::End();
    ImGui::PopStyleVar();
    ImGui::EndFrame();
  }

  void check_screen(const std::string& what) const {
    const StageFit& fit = panel_.stage();
    EXPECT_TRUE(fit.fits) << what;
    EXPECT_GE(fit.size, least_stage_type(window_.y)) << what;
    EXPECT_LE(fit.column, 0.6 * window_.x) << what << ": too little is left for the views";
    const Rect pane = places_.at("lesson.pane");
    int bottom = pane.min.y;
    for (std::size_t i = 0; i < 100; ++i) {
      const auto part = places_.find("lesson.part." + std::to_string(i));
      if (part == places_.end()) continue;
      EXPECT_GE(part->second.min.y, bottom) << what << ": part " << i << " begins in the one before";
      bottom = part->second.max.y;
    }
    EXPECT_GT(bottom, pane.min.y) << what << " is empty";
    EXPECT_LE(bottom, pane.max.y) << what << " is cut";
    for (const auto& [name, rect] : places_)
      EXPECT_TRUE(rect.min.x >= pane.min.x && rect.max.x <= pane.max.x && rect.max.y <= pane.max.y) << what << ": " << name;
    for (const ImGuiWindow* window : context_->Windows) {
      EXPECT_EQ(window->ScrollMax.x, 0.0f) << what << ": " << window->Name;
      EXPECT_EQ(window->ScrollMax.y, 0.0f) << what << ": " << window->Name;
    }
  }

  glm::ivec2 window_;
  ImGuiContext* context_;
  LessonPanel panel_;
  Places places_;
  std::vector<std::filesystem::path> none_;
};

class EveryLesson : public ::testing::TestWithParam<std::filesystem::path> {};

TEST_P(EveryLesson, FitsTheScreensOfAClass) {
  std::vector<std::unique_ptr<Stage>> stages;
  for (const glm::ivec2 size : {glm::ivec2(1024, 768), glm::ivec2(1280, 800), glm::ivec2(1920, 1080)}) {
    stages.push_back(std::make_unique<Stage>(size));
  }
  LessonSession session(GetParam().parent_path(), {});
  Model model(*load_experiment("ground", {}));
  const auto show = [&](const LessonCommand& command) {
    const auto next = session.perform(command, model);
    EXPECT_EQ(session.error(), "");
    if (next) model.commit(*next, "", 0.0);
    (void)session.update(model, 0.0);
    for (const auto& stage : stages) stage->check_step(model, session);
  };
  using Kind = LessonCommand::Kind;
  show({Kind::open, 0, GetParam().filename().string() + "/1", 0, 0.0});
  ASSERT_TRUE(session.run());
  for (std::size_t step = 0; step < session.run()->lesson().steps.size(); ++step) {
    if (step > 0) show({Kind::go_to, step, "", 0, 0.0});
    for (std::size_t i = 0; i < session.run()->step().questions.size(); ++i) show({Kind::show_answer, i, "", 0, 0.0});
    for (std::size_t i = 0; i < session.run()->step().tasks.size(); ++i) {
      for (std::size_t hint = 0; hint < session.run()->step().tasks[i].hints.size(); ++hint) show({Kind::hint, i, "", 0, 0.0});
      show({Kind::solve, i, "", 0, 0.0});
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Shipped, EveryLesson,
                         ::testing::ValuesIn(lesson_folders(std::filesystem::path(PSMLAB_TEST_DATA) / "../lessons")),
                         [](const auto& lesson) { return lesson.param.filename().string(); });

}  // namespace
}  // namespace psm::test
