// SPDX-License-Identifier: GPL-3.0-or-later
// Every member of the experiment can be edited by its widget, and no edit leads out of what a file may say.
#include "harness.h"
#include "ui/field_widgets.h"

namespace psm::test {
namespace {

constexpr Modifiers kControl{true, false, false};

/// Drags the widget, then types nonsense into it; the value moves and stays valid.
void edit_number(Bench& bench, const std::string& path, const std::string& widget) {
  const Field& field = *find_field(path);
  const std::string before = value_text(field, bench.experiment());
  bench.drag(bench.at(widget, 0.45), bench.at(widget, 0.85), 0, 2);
  EXPECT_NE(value_text(field, bench.experiment()), before) << widget << " does not answer to dragging";
  for (const char* text : {"1e300", "-1e300", "0"}) {
    bench.input().key(key::control, true);
    bench.click(bench.at(widget, 0.5));
    bench.input().key(key::control, false);
    bench.settle();
    bench.type(text);
    bench.key(key::enter);
    const auto error = check_experiment(bench.experiment());
    EXPECT_FALSE(error) << widget << " = " << text << ": " << error->text;
  }
}

void choose(Bench& bench, const std::string& path, const Choice& choice) {
  if (choice.names.size() < 2) return;
  const int other = choice.get(bench.experiment()) == 1 ? 0 : 1;
  const std::string item = path + "=" + choice.names[std::size_t(other)];
  if (!bench.on_screen(item)) bench.click(bench.at(path));
  bench.click(bench.at(item));
  EXPECT_EQ(choice.get(bench.experiment()), other) << path;
}

struct Edit {
  Bench& bench;
  const Field& field;
  void operator()(const NumberRef&) const { edit_number(bench, field.path, field.path); }
  void operator()(const IntRef&) const { edit_number(bench, field.path, field.path); }
  void operator()(const Vec2Ref&) const { components(".x", ".y"); }
  void operator()(const Vec3Ref&) const { components(".x", ".z"); }
  void operator()(const ShiftRef&) const {
    bench.click(bench.at(field.path + ".rule", 0.1));
    bench.click(bench.at(field.path + "=number", 0.1));
    edit_number(bench, field.path, field.path);
  }
  void operator()(const TilesRef&) const {
    bench.click(bench.at(field.path + ".0"));
    bench.click(bench.at(field.path + ".0=eye"));
    EXPECT_EQ(value_text(field, bench.experiment()), "eye,cube,map,world");  // the two change places
    bench.click(bench.at(field.path + ".1"));
    bench.click(bench.at(field.path + ".1=none"));
    EXPECT_EQ(value_text(field, bench.experiment()), "eye,map,world");
    bench.click(bench.at(field.path + ".3"));
    bench.click(bench.at(field.path + ".3=body"));
    EXPECT_EQ(value_text(field, bench.experiment()), "eye,map,world,body");
  }
  void operator()(const AutoPixelRef&) const {
    bench.click(bench.at(field.path + ".absent", 0.1));
    components(".x", ".y");
  }
  void operator()(const AutoPlaneRef&) const {
    bench.click(bench.at(field.path + ".absent", 0.1));
    components(".x", ".w");
  }
  void operator()(const TextRef&) const { EXPECT_TRUE(bench.on_screen(field.path)) << field.path; }
  void operator()(const Choice& choice) const { choose(bench, field.path, choice); }
  void components(const char* first, const char* last) const {
    edit_number(bench, field.path, field.path + first);
    edit_number(bench, field.path, field.path + last);
  }
};

/// A wide pane and small views: what is tested here is the widgets.
void widen_pane(Bench& bench) {
  Settings settings = bench.work().settings();
  settings.layout.pane = 0.6;
  bench.work().set_settings(settings);
  bench.settle();
}

void edit_all(const std::string& group, std::vector<std::string> overrides) {
  overrides.push_back("view.maximised=map");
  for (const Field& field : experiment_fields()) {
    if (field.path.rfind(group + ".", 0) != 0) continue;
    Bench bench("ground", overrides, {600, 520});
    widen_pane(bench);
    if (!field.applies(bench.experiment())) {
      EXPECT_FALSE(bench.on_screen(field.path)) << field.path << " means nothing here";
      continue;
    }
    const std::string heading = field_group(field);
    if (heading == "image" || heading == "view" || heading == "bias and filter") bench.click(bench.at("group." + heading));
    SCOPED_TRACE(field.path);
    std::visit(Edit{bench, field}, field.member);
    const auto error = check_experiment(bench.experiment());
    EXPECT_FALSE(error) << error->text;
  }
}

TEST(Fields, Scene) { edit_all("scene", {}); }
TEST(Fields, Camera) { edit_all("camera", {}); }
TEST(Fields, Image) { edit_all("image", {}); }
TEST(Fields, DirectionalLight) { edit_all("light", {}); }
TEST(Fields, SpotLight) { edit_all("light", {"light.type=spot", "light.position=-6,9,-8", "light.target=0,0,-12"}); }
TEST(Fields, Shadow) { edit_all("shadow", {"shadow.filter=pcf"}); }
TEST(Fields, View) { edit_all("view", {}); }

TEST(Fields, NearAndFarKeepTheirOrder) {
  Bench bench;
  bench.drag(bench.at("camera.near", 0.3), bench.at("camera.near", 1.0));
  EXPECT_LT(bench.experiment().camera.near, bench.experiment().camera.far);
  bench.drag(bench.at("camera.far", 0.5), bench.at("camera.far", 0.0));
  EXPECT_LT(bench.experiment().camera.near, bench.experiment().camera.far);
  bench.click(bench.at("camera.far.infinite", 0.1));
  EXPECT_TRUE(std::isinf(bench.experiment().camera.far));
}

TEST(Fields, ResetGoesBackToTheScenesOwnValue) {
  Bench bench;
  const double before = bench.experiment().camera.vertical_fov_deg;
  bench.drag(bench.at("camera.vertical_fov_deg", 0.3), bench.at("camera.vertical_fov_deg", 0.9));
  ASSERT_NE(bench.experiment().camera.vertical_fov_deg, before);
  bench.click(bench.at("camera.vertical_fov_deg.reset"));
  EXPECT_EQ(bench.experiment().camera.vertical_fov_deg, before);
}

TEST(Fields, TypingOneComponentIsOneEntry) {
  Bench bench;
  const glm::dvec2 field = bench.at("camera.position.y");  // first: with Control down the wheel does not scroll
  bench.input().key(key::control, true);
  bench.click(field);
  bench.input().key(key::control, false);
  bench.settle();
  bench.type("12.5");
  bench.key(key::enter);
  EXPECT_EQ(bench.experiment().camera.position.y, 12.5);
  EXPECT_EQ(bench.work().model().history().undo_count(), 1u);
}

TEST(Fields, TheDialTurnsTheLight) {
  Bench bench;
  const glm::dvec3 before = bench.experiment().light.to_light;
  bench.drag(bench.at("dial", 0.3), bench.at("dial", 0.6));
  EXPECT_NE(bench.experiment().light.to_light, before);
  EXPECT_NEAR(glm::length(bench.experiment().light.to_light), glm::length(before), 1e-12);
}

TEST(Fields, EveryTechniqueCanBeChosen) {
  Bench bench;
  for (Technique technique : offered_techniques()) {
    bench.click(bench.at(std::string("shadow.technique=") + name_of(technique), 0.1));
    EXPECT_EQ(bench.experiment().shadow.technique, technique);
  }
}

}  // namespace
}  // namespace psm::test
