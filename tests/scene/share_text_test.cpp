// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/share_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "random_experiment.h"
#include "scene/experiment_file.h"

namespace psm {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using testing::RandomExperiment;

Scene ground() { return *builtin_scene("ground"); }

std::string error_of(const std::string& text) {
  const auto loaded = experiment_from_text(text);
  return loaded ? "" : loaded.error().text;
}

TEST(ShareText, RandomExperimentsComeBackBitForBitFromOnePlainLine) {
  const Scene scene = ground();
  RandomExperiment random(11);
  for (int round = 0; round < 100; ++round) {
    Experiment wanted = random();
    wanted.scene.source = "ground";
    const std::string text = share_text(wanted, scene);
    EXPECT_TRUE(is_share_text(text));
    EXPECT_EQ(text.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-._~/,:+%?&="),
              std::string::npos)
        << text;
    const auto loaded = experiment_from_text(text);
    ASSERT_TRUE(loaded) << loaded.error().text << "\n" << text;
    EXPECT_EQ(experiment_to_json(loaded->experiment), experiment_to_json(wanted));
    EXPECT_EQ(share_text(loaded->experiment, loaded->scene), text);
  }
}

TEST(ShareText, NamesOnlyWhatDiffersFromTheSceneAsItComes) {
  auto loaded = load_experiment("ground", {});
  ASSERT_TRUE(loaded);
  EXPECT_EQ(share_text(loaded->experiment, loaded->scene), "psmlab:ground");
  loaded->experiment.shadow.resolution = 512;
  loaded->experiment.shadow.technique = Technique::psm;
  EXPECT_EQ(share_text(loaded->experiment, loaded->scene), "psmlab:ground?shadow.technique=psm&shadow.resolution=512");
}

TEST(ShareText, APathOfAnyCharactersSurvives) {
  Experiment experiment;
  experiment.scene.source = "/my scenes/50% of & = ? # ä.glb";
  const std::string text = share_text(experiment, ground());
  EXPECT_EQ(text.find(' '), std::string::npos);
  const auto members = members_from_share_text(text);
  ASSERT_TRUE(members) << members.error().text;
  EXPECT_EQ(members->values.scene.source, experiment.scene.source);
}

TEST(ShareText, BlanksAroundItAndLineBreaksOfAMailDoNoHarm) {
  const auto loaded = experiment_from_text("  \npsmlab:ground?shadow.resol\r\nution=256&camera.near=0.5\n ");
  ASSERT_TRUE(loaded) << loaded.error().text;
  EXPECT_EQ(loaded->experiment.shadow.resolution, 256);
  EXPECT_EQ(loaded->experiment.camera.near, 0.5);
}

TEST(ShareText, IsAnExperimentOnTheCommandLineToo) {
  const auto loaded = load_experiment("psmlab:ground?shadow.resolution=256", {"shadow.resolution=64"});
  ASSERT_TRUE(loaded) << loaded.error().text;
  EXPECT_EQ(loaded->scene.id, "ground");
  EXPECT_EQ(loaded->experiment.shadow.resolution, 64) << "--set goes over it";
  EXPECT_EQ(load_experiment("psmlab:", {})->experiment, load_experiment("", {})->experiment);
}

TEST(ShareText, JsonPastesAsWell) {
  const auto loaded = experiment_from_text(" \n{\"scene\": {\"source\": \"ground\"}, \"shadow\": {\"resolution\": 32}}");
  ASSERT_TRUE(loaded) << loaded.error().text;
  EXPECT_EQ(loaded->experiment.shadow.resolution, 32);
  EXPECT_THAT(error_of("{\"shadow\": {\"resolution\": 1}}"), HasSubstr("shadow.resolution: 1 is not allowed; allowed: "));
}

TEST(ShareText, EachMistakeIsNamedInOneLineWithWhatIsAllowed) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"", "empty"},
      {"hello\nworld", "hello?world: is no experiment"},
      {"psmlab:none", "none"},
      {"psmlab:ground?shadow.resolution=1", "shadow.resolution: 1 is not allowed"},
      {"psmlab:ground?shadow.resolution", "PATH=VALUE"},
      {"psmlab:ground?=1", "PATH=VALUE"},
      {"psmlab:ground?&", "member 1 of \"&\" is empty; allowed: PATH=VALUE"},
      {"psmlab:ground?camera.near=1&&camera.far=9", "member 2 of \"camera.near=1&&camera.far=9\" is empty"},
      {"psmlab:ground?camera.near=1&", "member 2 of"},
      {"psmlab:ground&camera.near=1", "& before any ?; allowed: psmlab:SCENE?PATH=VALUE"},
      {"psmlab:ground?no.such=1", "no.such: no such member"},
      {"psmlab:ground?camera.near=1&camera.near=2", "camera.near: given twice"},
      {"psmlab:ground?scene.source=chessboard", "scene.source: given twice"},
      {"psmlab:ground?camera.near=%4", "%4: no such escape"},
      {"psmlab:gro%zzund", "%zz: no such escape"},
      {"psmlab:ground?camera.near=5&camera.far=1", "camera.far: 1 is not allowed"},
      {"psmlab:%0a", "scene.source"},
  };
  for (const auto& [text, expected] : cases) {
    const std::string error = error_of(text);
    EXPECT_THAT(error, HasSubstr(expected)) << text;
    EXPECT_THAT(error, Not(HasSubstr("\n"))) << text;
    EXPECT_THAT(error, ::testing::AnyOf(HasSubstr("allowed"), HasSubstr("is neither"))) << text;
  }
}

TEST(ShareText, DamagedTextIsRefusedOrReadButNeverHalfRead) {
  RandomExperiment random(5);
  const std::string letters = "%&=?,.:0z-\n\xC3";
  for (int round = 0; round < 300; ++round) {
    std::string text = share_text(random(), ground());
    text[std::size_t(7 + random.below(int(text.size()) - 7))] = letters[std::size_t(random.below(int(letters.size())))];
    const auto members = members_from_share_text(text);
    if (!members) {
      EXPECT_FALSE(members.error().text.empty());
      EXPECT_EQ(members.error().text.find('\n'), std::string::npos);
      continue;
    }
    for (const Field* field : members->set) EXPECT_FALSE(check_field(*field, members->values)) << text;
  }
}

}  // namespace
}  // namespace psm
