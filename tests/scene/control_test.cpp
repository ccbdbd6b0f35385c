// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/control.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/light_angles.h"

namespace psm {
namespace {

using ::testing::HasSubstr;

/// What the control makes of the default experiment.
Experiment with(const std::string& path, double value) {
  Experiment experiment;
  const auto control = find_control(path, experiment);
  EXPECT_TRUE(control) << control.error().text;
  const auto error = (*control)(experiment, value);
  EXPECT_FALSE(error) << error->text;
  return experiment;
}

TEST(Control, SetsNumbersAndComponents) {
  EXPECT_EQ(with("camera.near", 0.5).camera.near, 0.5);
  EXPECT_EQ(with("shadow.resolution", 511.6).shadow.resolution, 512);
  EXPECT_EQ(std::get<double>(with("shadow.camera_shift", 2.5).shadow.camera_shift), 2.5);
  EXPECT_EQ(with("light.to_light.x", -3).light.to_light, glm::dvec3(-3, 1.0, 0.2));
  EXPECT_EQ(with("light.to_light.1", -3).light.to_light, glm::dvec3(0.3, -3, 0.2));
  EXPECT_EQ(with("view.map_center.y", 0.25).view.map_center.y, 0.25);
}

TEST(Control, ReadsWhatItSets) {
  for (const char* path : {"camera.near", "shadow.camera_shift", "light.to_light.x", "view.map_center.y", "light.theta_deg"})
    EXPECT_NEAR(find_control(path, Experiment())->value(with(path, 0.75)), 0.75, 1e-12) << path;
  EXPECT_EQ(find_control("shadow.resolution", Experiment())->value(with("shadow.resolution", 511.6)), 512.0);
  EXPECT_TRUE(std::isnan(find_control("shadow.camera_shift", Experiment())->value(Experiment()))) << "a rule is no number";
}

TEST(Control, KnowsItsNumbersRange) {
  EXPECT_EQ(control_range("light.theta_deg")->highest, 180.0);
  EXPECT_EQ(control_range("light.cone_deg")->highest, find_field("light.cone_deg")->max) << "in some experiment";
  EXPECT_EQ(control_range("view.probe.x") ? "a number" : control_range("view.probe.x").error().text,
            find_control("view.probe.x", Experiment()).error().text);
}

TEST(Control, TurnsADirectionalLightInThePlaneItStartedIn) {
  Experiment experiment;
  const auto control = find_control("light.theta_deg", experiment);
  ASSERT_TRUE(control);
  const glm::dvec3 normal = glm::cross(view_forward(experiment.camera), experiment.light.to_light);
  for (const double degrees : {90.0, 20.0, 0.0, 35.0, 180.0, 120.0}) {
    ASSERT_FALSE((*control)(experiment, degrees));
    EXPECT_NEAR(glm::degrees(light_theta(experiment)), degrees, 1e-12);
    EXPECT_NEAR(glm::dot(normal, experiment.light.to_light), 0.0, 1e-14);
    EXPECT_NEAR(glm::length(experiment.light.to_light), glm::length(Experiment().light.to_light), 1e-14);
  }
  EXPECT_EQ(with("light.theta_deg", 90).light.to_light.x > 0, Experiment().light.to_light.x > 0) << "it changed sides";
}

TEST(Control, RefusesInOneLine) {
  Experiment experiment;
  const auto refusal = [&](const std::string& path) {
    const auto control = find_control(path, experiment);
    return control ? "nothing" : control.error().text;
  };
  EXPECT_THAT(refusal("camera.bear"), HasSubstr("no such member"));
  EXPECT_THAT(refusal("light.to_light"), HasSubstr("not one number"));
  EXPECT_THAT(refusal("light.to_light.w"), HasSubstr("no such member"));
  EXPECT_THAT(refusal("camera.near.x"), HasSubstr("not one number"));
  EXPECT_THAT(refusal("view.map_center.z"), HasSubstr("not one number"));
  EXPECT_THAT(refusal("shadow.technique"), HasSubstr("not one number"));
  EXPECT_THAT(refusal("light.cone_deg"), HasSubstr("no meaning"));
  experiment.light.type = LightType::point;
  EXPECT_THAT(refusal("light.theta_deg"), HasSubstr("directional"));
}

TEST(Control, LeavesTheExperimentAloneWhereTheValueIsNotAllowed) {
  Experiment experiment;
  for (const double value : {-1.0, 1e9, HUGE_VAL, -HUGE_VAL, double(NAN)}) {
    const auto error = (*find_control("camera.near", experiment))(experiment, value);
    ASSERT_TRUE(error) << value;
    EXPECT_THAT(error->text, HasSubstr("camera.near"));
    EXPECT_EQ(experiment, Experiment());
  }
}

}  // namespace
}  // namespace psm
