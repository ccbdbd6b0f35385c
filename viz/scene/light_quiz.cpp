// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/light_quiz.h"

#include <algorithm>
#include <cmath>

#include "math/light_case.h"
#include "scene/eye_and_light.h"
#include "scene/light_angles.h"

namespace psm {
namespace {

constexpr double kInPlane = 0.2;  // of the lights: exactly in the camera plane

/// In [0, 1); the library's distributions may differ from one platform to the next.
double fraction(std::mt19937& random) { return double(random()) / 4294967296.0; }

glm::dvec3 random_direction(std::mt19937& random) {
  const double z = 2.0 * fraction(random) - 1.0, angle = glm::radians(360.0 * fraction(random));
  const double across = std::sqrt(std::max(0.0, 1.0 - z * z));
  return {across * std::cos(angle), across * std::sin(angle), z};
}

const std::vector<std::string> kCases{"a directional light", "a point light", "an inverted point light"};

int case_index(int sign) { return sign == 0 ? 0 : sign > 0 ? 1 : 2; }

std::string sign_text(int sign) { return sign == 0 ? " = 0" : sign > 0 ? " > 0" : " < 0"; }

std::string rounded(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

std::string value_text(double w, int sign) { return sign == 0 ? " = 0" : " = " + rounded(w) + sign_text(sign); }

QuizQuestion case_question(bool is_direction, const PostLightCase<double>& now) {
  QuizQuestion q{"What is this light after the eye's projection?", kCases, case_index(now.sign), ""};
  const std::string w = is_direction ? "w = v·l" : "w = v·(l − e)";
  q.why = w + value_text(now.w, now.sign) + ": the light " +
          (now.sign == 0  ? "lies in the camera plane, which the projection sends to infinity."
           : now.sign > 0 ? "lies in front of the camera plane: it lands at a finite point, and its rays leave from there."
                          : "lies behind the camera plane: it lands at a finite point, and its rays run towards that point.");
  return q;
}

QuizQuestion order_question(const PostLightCase<double>& now) {
  QuizQuestion q{"If l is divided by its w, which of two points on a light ray seems nearer to the light?",
                 {"the one that is nearer", "the one that is farther"},
                 now.reversed ? 1 : 0,
                 ""};
  q.why = now.reversed ? "w < 0: dividing by it turns the rays around, so the naive depth order is reversed. M l = (0, 0, −k, 0) "
                         "with k > 0 never divides, and keeps the order."
                       : "w is not negative: the order along rays stays as it is in the world.";
  return q;
}

QuizQuestion shift_question(const glm::dvec4& light, const ViewFrame& view, double w_now, double shift) {
  const auto after = classify_light<double>(light, view.eye - shift * view.forward, view.forward);
  QuizQuestion q{"The eye moves back until everything that can cast a shadow is in front of it. What is the light then?", kCases,
                 case_index(after.sign), ""};
  if (light.w == 0.0)
    q.why = "A direction has the same w = v·l from every eye on the line of sight: moving back changes nothing.";
  else if (shift == 0.0)
    q.why = "Nothing that casts is behind the eye: it need not move, and w stays" + value_text(after.w, after.sign) + ".";
  else
    q.why = "A position gains the shift: w = " + rounded(w_now) + " + " + rounded(shift) + value_text(after.w, after.sign) + ".";
  return q;
}

}  // namespace

LightSettings random_light(std::mt19937& random, const Experiment& experiment, double reach) {
  Experiment e = experiment;
  const bool direction = fraction(random) < 0.5, in_plane = fraction(random) < kInPlane;
  const glm::dvec3 towards = random_direction(random);
  e.light.type = direction ? LightType::directional : LightType::point;
  e.light.to_light = towards;
  e.light.position = e.camera.position + reach * std::cbrt(0.02 + 0.98 * fraction(random)) * towards;
  if (in_plane && direction) e.light.to_light = to_light_at(e, std::acos(0.0), theta_side(e));
  if (in_plane) e.light.position = position_at_depth(e, 0.0);
  return e.light;
}

std::array<QuizQuestion, 3> light_questions(const Experiment& experiment, const Scene& scene) {
  Experiment shifted = experiment;
  shifted.shadow.technique = Technique::psm_divided;  // the technique of the paper that moves the eye
  shifted.shadow.camera_shift = ShiftRule::in_front;
  const Analysis moved = analyze(shifted, scene);
  const ViewFrame view = camera_frame(experiment);
  const glm::dvec4 light = homogeneous_light(experiment.light);
  const auto now = classify_light<double>(light, view.eye, view.forward);
  return {case_question(light.w == 0.0, now), order_question(now), shift_question(light, view, now.w, moved.camera_shift)};
}

void LightQuiz::next(const Experiment& experiment, const Scene& scene) {
  ++asked_;
  chosen_ = -1;
  if (asked_ > 1 && !is_last_of_light()) {
    ++question_;
    return;
  }
  question_ = 0;
  const glm::dvec3 size = scene.bounds.empty() ? glm::dvec3(1.0) : scene.bounds.max - scene.bounds.min;
  Experiment asked = experiment;
  asked.light = light_ = random_light(random_, experiment, std::max(glm::length(size), experiment.camera.near));
  questions_ = light_questions(asked, scene);
}

void LightQuiz::answer(int choice) {
  if (answered() || choice < 0 || choice >= int(question().choices.size())) return;
  chosen_ = choice;
  ++score_.answers;
  score_.right += was_right();
}

}  // namespace psm
