// SPDX-License-Identifier: GPL-3.0-or-later
// What is wrong with a lesson, each in one line that names file, line and what is allowed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lesson_fixture.h"

namespace psm::testing {
namespace {

struct Broken {
  const char *from, *to, *fault;
};

TEST(ALesson, ThatIsFineHasNoFaults) { EXPECT_EQ(first_fault(kGoodJson, kGoodText), ""); }

TEST(ALesson, MayAnimateAnyNumber) {
  for (const char* path : {"light.to_light.x", "shadow.camera_shift", "shadow.resolution", "view.map_zoom"}) {
    const std::string json = replaced(kGoodJson, "\"path\": \"light.theta_deg\"", "\"path\": \"" + std::string(path) + "\"");
    EXPECT_EQ(first_fault(json, kGoodText), "") << path;
  }
}

TEST(ABrokenLessonJson, NamesItsLineAndWhatIsAllowed) {
  const Broken table[] = {
      {"\"title\": \"A small lesson\",", "\"title\": \"A small lesson\"",
       "lesson.json:4: not JSON: unexpected \"summary\"; allowed: ',' or '}'"},
      {"\"to_light\": [0, 1, -0.5]", "\"to_light\": [0, NaN, -0.5]",
       "lesson.json:10: not JSON: NaN is no value; allowed: a finite number, a text in double quotes, true, false, null, a list "
       "or "
       "an object"},
      {"\"psmlab_lesson\": 1", "\"psmlab_lesson\": 2",
       "lesson.json:2: psmlab_lesson: 2 is not allowed; allowed: 1, the version that this program reads"},
      {"\"summary\"", "\"sumary\"", "lesson.json:4: sumary: no such member; allowed: psmlab_lesson, title, summary, base, steps"},
      {"\"summary\": \"Where the light stands decides its case.\",", "",
       "lesson.json:1: summary: is missing; allowed: a value, it is required"},
      {"\"title\": \"A small lesson\"", "\"title\": \"Another\"",
       "text.md:1: \"A small lesson\" is not the title of lesson.json; allowed: \"Another\""},
      {"\"views\": [\"world\", \"cube\"]", "\"views\": [\"world\", \"cub\"]",
       "lesson.json:11: steps.0.views.1: \"cub\" is not allowed; allowed: world, cube, map, eye, body, curves, explorer"},
      {"\"views\": [\"world\", \"cube\"]", "\"views\": []", "lesson.json:11: steps.0.views: 0 names; allowed: 1 to 4"},
      {"\"views\": [\"world\", \"cube\"]", "\"views\": [\"world\", \"world\"]",
       "lesson.json:11: steps.0.views: a name given twice; allowed: once"},
      {"\"to_light\": [0, 1, -0.5]", "\"to_light\": [0, 0, 0]",
       "lesson.json:10: steps.0.experiment.light.to_light: [0,0,0] is not allowed; allowed: three numbers in [-1e+100, 1e+100], "
       "not all of them (nearly) zero"},
      {"\"shadow.resolution\"", "\"shadow.resolutoin\"",
       "lesson.json:12: steps.0.controls.1: shadow.resolutoin: no such member; allowed: shadow.technique, shadow.resolution, "
       "shadow.camera_shift, shadow.near_fit, shadow.focus, shadow.warp_range, shadow.scene_body, shadow.receiver_plane, "
       "shadow.plane, shadow.depth_bias, shadow.slope_bias, shadow.normal_bias, shadow.cull, shadow.filter, shadow.filter_size"},
      {"\"shadow.resolution\"", "\"light.cone_deg\"",
       "lesson.json:7: step 1: light.cone_deg: has no meaning for this step's directional light; allowed: a control that has"},
      {"\"highlight\": [\"light\"]", "\"highlight\": [\"lamp\"]",
       "lesson.json:13: steps.0.highlight.0: \"lamp\" is not allowed; allowed: frustum, light, caster_body, receivers_body, "
       "vanishing_plane, map_window, infinity, texel_grid, scene_bounds"},
      {"\"answer\": 0", "\"answer\": 2",
       "lesson.json:19: steps.0.questions.0.answer: 2 is not allowed; allowed: a number in [0, 1]"},
      {"\"answer\": 0", "\"answer\": 0.5",
       "lesson.json:19: steps.0.questions.0.answer: is not a whole number; allowed: the number of a choice, from 0"},
      {"\"kind\": \"number\"", "\"kind\": \"guess\"",
       "lesson.json:25: steps.0.questions.1.kind: \"guess\" is not allowed; allowed: choice, number"},
      {"\"cover\": [\"cube\"]", "\"cover\": [\"eye\"]",
       "lesson.json:15: step 1: cover: eye is not among the step's views; allowed: one of its views"},
      {"{\"value\": \"theta_deg\"}", "{\"value\": \"theta\"}",
       "lesson.json:24: step 1: answer: \"theta\" leads to no value; allowed: a path to a number, a text, true, false or null in "
       "what psmlab analyze prints"},
      {"{\"value\": \"theta_deg\"}", "{\"value\": \"technique_used\"}",
       "lesson.json:24: step 1: answer: is no finite number on this step's experiment; allowed: one that is"},
      {"{\"value\": \"theta_deg\"}", "\"45\"",
       "lesson.json:28: steps.0.questions.1.answer: no quantity; allowed: a number, {\"value\": PATH} or {\"curve\": {...}, "
       "\"column\": NAME}"},
      {"\"source\": \"PSM 2002, section 3.1\",", "",
       "lesson.json:7: step 1: source: is missing; allowed: where the formulas of this step come from"},
      {"\"says\": \"far below 4\"", "\"says\": \"far above 4\"",
       "lesson.json:34: step 1: claim \"far above 4\": does not stand in the step's section, questions or tasks; allowed: the "
       "text as written there"},
      {"\"below\": 4", "\"below\": 0.1",
       "lesson.json:34: step 1: claim \"far below 4\": does not hold: 0.11111111111111112 is not below 0.1"},
      {"\"below\": 4", "\"below\": 4, \"above\": 2",
       "lesson.json:34: steps.0.claims.0: needs exactly one test; allowed: is, above, below or between"},
      {"\"column\": \"lambda\"", "\"column\": \"mu\"",
       "lesson.json:37: steps.0.claims.0.column: \"mu\" is not allowed; allowed: lambda, F_n, F_f, F_max, z_at_min, F_min"},
      {"\"f\": 100", "\"f\": 0.5",
       "lesson.json:36: steps.0.claims.0.curve.f: not greater than n; allowed: a number greater than n"},
      {"\"is\": \"inverted_point\"", "\"is\": \"directional\"",
       "lesson.json:50: step 2: solution: does not reach the goal: inverted_point is not directional"},
      {"{\"value\": \"light_case.w\", \"below\": 0}", "{\"value\": \"light_case.v\", \"below\": 0}",
       "lesson.json:50: step 2: goal: \"light_case.v\" leads to no value; allowed: a path to a number, a text, true, false or "
       "null in what psmlab analyze prints"},
      {"{\"to_light\": [0, 1, 1]}", "{\"to_light\": [0, 1, -0.5]}",
       "lesson.json:50: step 2: solution: does not reach the goal: point is not inverted_point"},
      {"\"done\": \"It is inverted.\",", "",
       "lesson.json:48: steps.1.tasks.0.done: is missing; allowed: a value, it is required"},
      {"\"continues\": true", "\"continues\": 1", "lesson.json:44: steps.1.continues: 1 is not allowed; allowed: true or false"},
      {"\"to\": 160", "\"to\": 200", "lesson.json:46: steps.1.animation.to: 200 is not allowed; allowed: a number in [0, 180]"},
      {"\"path\": \"light.theta_deg\"", "\"path\": \"light.type\"",
       "lesson.json:46: steps.1.animation.path: light.type: not one number; allowed: a member that is a number, a vector's "
       "component such as light.position.x, or light.theta_deg"},
      {"\"path\": \"light.theta_deg\"", "\"path\": \"light.cone_deg\"",
       "lesson.json:42: step 2: animation: light.cone_deg: has no meaning for this experiment; allowed: a member that has"},
      {"\"path\": \"light.theta_deg\"", "\"path\": \"camera.near\"",
       "lesson.json:42: step 2: animation: camera.far: 100 is not allowed; allowed: a number greater than camera.near (160), or "
       "inf"},
      {"$w \\\\ne 0$", "$w \\\\not 0$",
       "lesson.json:21: steps.0.questions.0.why: formula \"w \\not 0\": \\not: no such command; allowed: \\frac \\sqrt \\text "
       "\\mathbf \\hat \\bar \\left \\right \\quad \\, \\; Greek letters, and the signs and functions that lessons/README.md "
       "lists"},
      {"It is inverted.", "It is [inverted](lesson:02_no).",
       "lesson.json:52: step 2: link lesson:02_no: there is no such lesson; allowed: 00_small, 01_other"},
  };
  for (const Broken& broken : table) {
    const std::string fault = first_fault(replaced(kGoodJson, broken.from, broken.to), kGoodText);
    EXPECT_EQ(fault, broken.fault) << broken.from << " -> " << broken.to;
  }
}

TEST(ABrokenLessonJson, HasListsThatAreTooLong) {
  std::string many = "\"light\"";
  for (int i = 1; i < 101; ++i) many += ", \"light\"";
  EXPECT_EQ(first_fault(replaced(kGoodJson, "\"highlight\": [\"light\"]", "\"highlight\": [" + many + "]"), kGoodText),
            "lesson.json:13: steps.0.highlight: 101 elements; allowed: up to 100");
}

TEST(ABrokenText, NamesItsLineAndWhatIsAllowed) {
  const Broken table[] = {
      {"# A small lesson", "# A smaller lesson",
       "text.md:1: \"A smaller lesson\" is not the title of lesson.json; allowed: \"A small lesson\""},
      {"# A small lesson\n", "", "text.md:2: no title; allowed: \"# A small lesson\" comes first"},
      {"## The sun", "## The moon", "text.md:5: \"The moon\" is not the heading of step 1 in lesson.json; allowed: \"The sun\""},
      {"## Behind the eye", "### Behind the eye",
       "text.md:16: step 2 of lesson.json has no section; allowed: \"## Behind the eye\""},
      {"Now", "## More\n\nNow", "text.md:14: no text below this heading; allowed: at least a paragraph"},
      {"\\frac{\\sqrt{n f} + n}{f - n}", "\\frac{\\sqrt{n f} + n}",
       "text.md:7: formula \"\\lambda = \\frac{\\sqrt{n f} + n}\": '{' is missing after \\frac{}"},
      {"\\lambda", "\\lamda",
       "text.md:7: formula \"\\lamda = \\frac{\\sqrt{n f} + n}{f - n}\": \\lamda: no such command; allowed: \\frac \\sqrt \\text "
       "\\mathbf \\hat \\bar \\left \\right \\quad \\, \\; Greek letters, and the signs and functions that lessons/README.md "
       "lists"},
      {"- two", "- two ![picture](a.png)",
       "text.md:12: an image; allowed: headings, paragraphs, bullet and numbered lists, quotes, emphasis, links, inline code, "
       "$formulas$"},
      {"- two", "- two <b>bold</b>",
       "text.md:12: HTML; allowed: headings, paragraphs, bullet and numbered lists, quotes, emphasis, links, inline code, "
       "$formulas$"},
      {"- two", "- two $5",
       "text.md:12: a $ without its partner; allowed: headings, paragraphs, bullet and numbered lists, quotes, emphasis, links, "
       "inline code, $formulas$"},
      {"- two", "- two \u4e2d", "text.md:12: the font has no glyph U+4E2D; allowed: what DejaVu Sans shows"},
      {"What this is about.", "| a | b |\n| --- | --- |\n| 1 | 2 |",
       "text.md:3: a table; allowed: headings, paragraphs, bullet and numbered lists, quotes, emphasis, links, inline code, "
       "$formulas$"},
      {"lesson:01_other", "lesson:01_another",
       "text.md:12: link lesson:01_another: there is no such lesson; allowed: 00_small, 01_other"},
      {"- two", "- two\n  - three\n    - four",
       "text.md:14: a list three levels deep; allowed: headings, paragraphs, bullet and numbered lists, quotes, emphasis, links, "
       "inline code, $formulas$"},
      {"- two", "- two\n\n~~~\ncode\n~~~\n",
       "text.md:15: a block of code; allowed: headings, paragraphs, bullet and numbered lists, quotes, emphasis, links, inline "
       "code, $formulas$"},
      {"lesson:01_other", "http://example.org",
       "text.md:12: link http://example.org: leads nowhere; allowed: lesson:NAME, set:PATH=VALUE, https://..."},
      {"shadow.resolution=512", "shadow.resolution=8",
       "text.md:12: link shadow.resolution: 8 is not allowed; allowed: a whole number in [16, 8192]"},
      {"set:light.to_light=0,1,0", "set:camera.far=0.01",
       "text.md:12: link: camera.far: 0.01 is not allowed; allowed: a number greater than camera.near (1), or inf"},
      {"=light_case.w", "=light_case.x",
       "text.md:16: live value \"light_case.x\" leads to no value; allowed: a path to a number, a text, true, false or null in "
       "what psmlab analyze prints"},
      {"=light_case.w", "=light_case",
       "text.md:16: live value \"light_case\" leads to no value; allowed: a path to a number, a text, true, false or null in "
       "what psmlab analyze prints"},
      {"**negative**", "\x01", "text.md:16: a byte that is no text; allowed: UTF-8"},
  };
  for (const Broken& broken : table) {
    const std::string fault = first_fault(kGoodJson, replaced(kGoodText, broken.from, broken.to));
    EXPECT_EQ(fault, broken.fault) << broken.from << " -> " << broken.to;
  }
}

TEST(AText, MayBeginWithTheMarkOfUtf8) { EXPECT_EQ(first_fault(kGoodJson, "\xEF\xBB\xBF" + std::string(kGoodText)), ""); }

TEST(AStepsNumber, CountsFromOne) {
  std::string third = "a/3", none = "a/0";
  EXPECT_EQ(take_lesson_step(third), 2u);
  EXPECT_EQ(third, "a");
  take_lesson_step(none);
  EXPECT_EQ(none, "a/0") << "a name that no lesson has";
}

TEST(AMissingFile, IsNamed) {
  const LessonFolder folder;
  std::filesystem::remove(folder.path() / "text.md");
  const auto lesson = read_lesson(folder.path());
  ASSERT_FALSE(lesson);
  EXPECT_THAT(lesson.error().text,
              ::testing::EndsWith("text.md: cannot be read: No such file or directory; allowed: a file of a lesson"));
}

}  // namespace
}  // namespace psm::testing
