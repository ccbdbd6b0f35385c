// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "random_experiment.h"
#include "scene/experiment_file.h"

namespace psm {
namespace {

using ::testing::HasSubstr;
using testing::RandomExperiment;

/// Values that no member of this kind takes; each names what it breaks.
struct Outside {
  const Field& field;
  std::vector<std::string> operator()(const NumberRef&) const {
    std::vector<std::string> bad{"", "x", "1,2", "nan", "1e999", "0x10", "1 2", "-inf"};
    if (!field.may_be_infinite) bad.push_back("inf");
    bad.push_back(field.open_min ? number_text(field.min) : number_text(std::nextafter(field.min, -HUGE_VAL)));
    bad.push_back(field.open_max ? number_text(field.max) : number_text(std::nextafter(field.max, HUGE_VAL)));
    return bad;
  }
  std::vector<std::string> operator()(const IntRef&) const {
    std::vector<std::string> bad{
        "", "x", "1.5", "inf", "99999999999999999999", number_text(field.min - 1), number_text(field.max + 1)};
    if (field.odd) bad.push_back(number_text(field.min + 1));
    return bad;
  }
  std::vector<std::string> operator()(const Vec2Ref&) const { return {"", "1", "1,2,3", "1,x", "1,inf", "1,1e300"}; }
  std::vector<std::string> operator()(const Vec3Ref&) const {
    std::vector<std::string> bad{"", "1,2", "1,2,3,4", "1,2,x", "1,,2", "1,nan,2", "1,2,inf", "1,2,1e300"};
    if (field.nonzero) bad.push_back("0,0,0");
    return bad;
  }
  std::vector<std::string> operator()(const TextRef&) const { return {"", "a\nb", std::string(5000, 'a')}; }
  std::vector<std::string> operator()(const ShiftRef&) const { return {"", "Auto", "infront", "inf", "-1", "1,2"}; }
  std::vector<std::string> operator()(const TilesRef&) const {
    return {"", "none", "world,", ",world", "world,world", "world,cube,map,eye,body", "World", "world;cube", "[world]"};
  }
  std::vector<std::string> operator()(const AutoPixelRef&) const { return {"", "none", "1", "1,2,3", "-1,0", "1,inf"}; }
  std::vector<std::string> operator()(const AutoPlaneRef&) const { return {"", "none", "1,2,3", "0,0,0,1", "1,2,3,inf"}; }
  std::vector<std::string> operator()(const Choice& choice) const { return {"", "?", "0", choice.names[0] + " ", "UNIFORM"}; }
};

TEST(ExperimentTable, EveryRowIsExplained) {
  std::set<std::string> paths;
  for (const Field& field : experiment_fields()) {
    SCOPED_TRACE(field.path);
    EXPECT_TRUE(paths.insert(field.path).second);
    EXPECT_EQ(find_field(field.path), &field);
    ASSERT_FALSE(field.help.empty());
    EXPECT_EQ(field.help.back(), '.');
    EXPECT_FALSE(allowed_values(field).empty());
    EXPECT_LT(field.min, field.max);
  }
  EXPECT_EQ(find_field("camera"), nullptr);
  EXPECT_EQ(find_field(""), nullptr);
}

TEST(ExperimentTable, TheContractsMembersAreThere) {
  for (const char* path :
       {"scene.source",       "camera.position",   "camera.target",         "camera.up",           "camera.vertical_fov_deg",
        "camera.near",        "camera.far",        "image.width",           "image.height",        "light.type",
        "light.to_light",     "light.position",    "light.target",          "light.cone_deg",      "shadow.technique",
        "shadow.resolution",  "shadow.filter",     "shadow.depth_bias",     "shadow.camera_shift", "shadow.near_fit",
        "shadow.focus",       "shadow.warp_range", "shadow.receiver_plane", "shadow.plane",        "shadow.slope_bias",
        "shadow.normal_bias", "shadow.cull",       "shadow.filter_size",    "light.radius"})
    EXPECT_NE(find_field(path), nullptr) << path;
}

TEST(ExperimentTable, TheDefaultIsWithinItsRanges) {
  const auto error = check_experiment({});
  EXPECT_FALSE(error) << error->text;
}

TEST(ExperimentTable, SetTakesEveryMemberBackBitForBit) {
  RandomExperiment random(1);
  for (int round = 0; round < 200; ++round) {
    const Experiment wanted = random();
    Experiment built = wanted;
    for (const Field& field : experiment_fields()) {
      const Experiment other = random();
      if (field.path == "light.type" || field.path.starts_with("camera.") || field.path.starts_with("light.")) continue;
      const std::string text = value_text(field, other);
      const auto error = set_field(built, field.path + "=" + text);
      ASSERT_FALSE(error) << error->text;
      EXPECT_EQ(value_text(field, built), text);
    }
  }
}

TEST(ExperimentTable, OverridesRebuildAnExperimentBitForBit) {
  RandomExperiment random(2);
  for (int round = 0; round < 100; ++round) {
    const Experiment wanted = random();
    std::vector<std::string> overrides;
    for (const Field& field : experiment_fields()) overrides.push_back(field.path + "=" + value_text(field, wanted));
    const auto loaded = load_experiment("", overrides);
    ASSERT_TRUE(loaded) << loaded.error().text;
    EXPECT_EQ(loaded->experiment, wanted);
    for (const Field& field : experiment_fields())
      EXPECT_EQ(value_text(field, loaded->experiment), value_text(field, wanted)) << field.path;  // tells -0 from 0
  }
}

TEST(ExperimentTable, EveryValueOutsideIsRefusedByName) {
  for (const Field& field : experiment_fields()) {
    for (const std::string& value : std::visit(Outside{field}, field.member)) {
      SCOPED_TRACE(field.path + "=" + value);
      Experiment experiment;
      experiment.light.type = LightType::spot;
      const Experiment before = experiment;
      const auto error = set_field(experiment, field.path + "=" + value);
      ASSERT_TRUE(error);
      EXPECT_EQ(experiment, before);
      EXPECT_THAT(error->text, HasSubstr(field.path + ": "));
      EXPECT_THAT(error->text, HasSubstr("allowed: " + allowed_values(field)));
      EXPECT_EQ(error->text.find('\n'), std::string::npos);
    }
  }
}

TEST(ExperimentTable, MembersThatContradictEachOtherAreRefused) {
  const std::pair<const char*, const char*> cases[] = {
      {"camera.far=0.05", "camera.far"},          {"camera.far=0.1", "camera.far"},   {"camera.near=200", "camera.far"},
      {"camera.target=0,1.7,6", "camera.target"}, {"camera.up=0,0.7,6", "camera.up"}, {"camera.up=0,-0.07,-0.6", "camera.up"}};
  for (const auto& [text, path] : cases) {
    Experiment experiment;
    const auto error = set_field(experiment, text);
    ASSERT_TRUE(error) << text;
    EXPECT_THAT(error->text, ::testing::StartsWith(path)) << text;
    EXPECT_EQ(experiment, Experiment());
  }
  Experiment spot;
  spot.light.type = LightType::spot;
  EXPECT_TRUE(set_field(spot, "light.target=0,4,0"));
  EXPECT_FALSE(set_field(spot, "light.target=0,4,1e-9"));
}

TEST(ExperimentTable, DirectionsOfAnyLengthAreTaken) {
  Experiment experiment;
  for (const char* text : {"light.to_light=1e-30,2e-30,0", "light.to_light=1e30,-1e30,3e30", "camera.up=0,1e-30,0"}) {
    const auto error = set_field(experiment, text);
    EXPECT_FALSE(error) << error->text;
  }
}

TEST(ExperimentTable, UnknownPathsNameWhatTheyCouldBe) {
  Experiment experiment;
  const auto message = [&](const std::string& text) { return set_field(experiment, text).value_or(InputError{}).text; };
  EXPECT_THAT(message("camera.fov=60"), HasSubstr("camera.vertical_fov_deg"));
  EXPECT_THAT(message("lihgt.type=spot"), HasSubstr("allowed: scene, camera, image, light, shadow, view"));
  EXPECT_THAT(message("view.world.roll=1"), HasSubstr("view.world.yaw_deg"));
  EXPECT_THAT(message("camera.near.x=1"), HasSubstr("camera.near"));
  EXPECT_THAT(message("camera.near"), HasSubstr("PATH=VALUE"));
  EXPECT_THAT(message("=3"), HasSubstr("PATH=VALUE"));
  EXPECT_THAT(message("a\nb\x01=3"), HasSubstr("a?b?"));
}

TEST(ExperimentTable, NamesAndValuesOfEnumsAgree) {
  EXPECT_STREQ(name_of(Technique::custom), "custom");
  EXPECT_STREQ(name_of(Technique::lispsm_reference), "lispsm_reference");
  EXPECT_STREQ(name_of(LightType::spot), "spot");
  EXPECT_STREQ(name_of(ViewId::eye), "eye");
  for (const std::string& name : technique_names()) EXPECT_EQ(name_of(technique_from_name(name).value()), name);
  EXPECT_FALSE(technique_from_name("shadow"));
  Experiment experiment;
  ASSERT_FALSE(set_field(experiment, "view.maximised=eye"));
  EXPECT_EQ(experiment.view.maximised, ViewId::eye);
  ASSERT_FALSE(set_field(experiment, "view.maximised=none"));
  EXPECT_EQ(experiment.view.maximised, std::nullopt);
}

}  // namespace
}  // namespace psm
