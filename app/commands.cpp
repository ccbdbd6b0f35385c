// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>

#include "app/command_line.h"
#include "app/film.h"
#include "app/headless_context.h"
#include "app/lessons.h"
#include "app/numbers.h"
#include "app/picture_file.h"
#include "app/render.h"
#include "app/window.h"
#include "measure/texel_analysis.h"
#include "measure/visible_image.h"
#include "scene/analysis.h"
#include "scene/experiment_file.h"
#include "scene/matrix_text.h"

namespace psm {
namespace {

namespace fs = std::filesystem;

Result<std::vector<ViewId>> parse_views(const std::string& names) {
  std::vector<ViewId> views;
  for (const std::string& name : split(names, ',')) {
    const auto view = view_from_name(name);
    if (!view) return flag_error("--view", name, "a list of: " + view_names());
    views.push_back(*view);
  }
  if (views.size() > 16) return InputError{"--view: " + std::to_string(views.size()) + " views; allowed: up to 16"};
  return views;
}

Result<glm::ivec2> check_size(double width, double height, const std::string& shown) {
  const auto whole = [](double side) { return side >= 1 && side <= kLargestSide && std::trunc(side) == side; };
  if (!whole(width) || !whole(height) || width * height > double(kMostPixels))
    return flag_error("--size", shown, "WIDTHxHEIGHT in pixels, each in [1, 16384], together at most 67108864 pixels");
  return glm::ivec2(int(width), int(height));
}

Result<glm::ivec2> size_of(const ImageSettings& image) {
  return check_size(image.width, image.height, std::to_string(image.width) + "x" + std::to_string(image.height));
}

/// An experiment with the first four views, or a step of a lesson with its own.
Result<LessonPicture> subject_of(const RenderArguments& arguments) {
  if (arguments.lesson) return lesson_picture(*arguments.lesson, arguments.experiment.overrides);
  auto loaded = load(arguments.experiment);
  if (!loaded) return loaded.error();
  return LessonPicture{std::move(*loaded), {kMainViews.begin(), kMainViews.end()}, {}, std::nullopt};
}

Result<RenderRequest> parse_request(const RenderArguments& arguments, const LessonPicture& subject) {
  RenderRequest request;
  request.emphasis = subject.emphasis;
  const auto views = arguments.views ? parse_views(*arguments.views) : subject.views;
  if (!views) return views.error();
  request.views = *views;
  const auto size = arguments.size ? parse_size(*arguments.size) : size_of(subject.loaded.experiment.image);
  if (!size) return size.error();
  request.size = *size;
  const auto scale = number_from_text(arguments.scale);
  if (!scale || !(*scale >= 0.25 && *scale <= 8)) return flag_error("--scale", arguments.scale, "a number in [0.25, 8]");
  request.scale = *scale;
  if (arguments.theme != "light" && arguments.theme != "dark") return flag_error("--theme", arguments.theme, "light or dark");
  request.theme = arguments.theme == "dark" ? Theme::dark : Theme::light;
  request.transparent = arguments.transparent;
  return request;
}

int draw_to_file(const LoadedExperiment& loaded, const RenderRequest& request, const std::optional<PictureSweep>& sweep,
                 const fs::path& out) {
  const auto layout = lay_out(request);
  if (!layout) return bad_input(layout.error());
  const auto context = HeadlessContext::create();
  if (!context) return other_failure(context.error());
  SheetPainter painter;
  const auto error = write_pictures(painter, sheet_of(loaded, request, *layout), sweep, out);
  return error ? bad_input(*error) : kDone;
}

/// Where a picture may be left without being asked where: the current folder, or else the one for temporary files.
fs::path place_for_views() {
  const fs::path here = fs::absolute("psmlab-views.png");
  const fs::path probe = here.parent_path() / ".psmlab-probe.tmp";
  std::error_code error;
  if (write_file_atomically(probe, "")) return fs::temp_directory_path(error) / here.filename();
  fs::remove(probe, error);
  return here;
}

int draw_without_display(const LoadedExperiment& loaded) {
  complain("no display: no window can be opened, so the four views are written as a picture instead");
  RenderRequest request;
  request.views.assign(kMainViews.begin(), kMainViews.end());
  request.size = {1920, 1080};
  const fs::path out = place_for_views();
  const int code = draw_to_file(loaded, request, std::nullopt, out);
  return code == kDone ? finish_printing(print(out.string() + "\n")) : code;
}

}  // namespace

std::optional<InputError> check_rays(const ImageSettings& image, const std::string& asker) {
  if (std::int64_t(image.width) * image.height <= kMostPixels) return std::nullopt;
  return InputError{"image: " + asker + " traces a ray for each of its " + std::to_string(image.width) + " x " +
                    std::to_string(image.height) + " pixels; allowed: up to " + std::to_string(kMostPixels) + " pixels"};
}

int bad_input(const InputError& error) {
  complain(error.text);
  return kBadInput;
}

int other_failure(const InputError& error) {
  complain(error.text);
  return kOtherFailure;
}

int finish_printing(bool printed) {
  if (printed && std::fflush(stdout) == 0) return kDone;
  return other_failure({std::string("standard output: cannot be written: ") + std::strerror(errno ? errno : EIO)});
}

Result<glm::ivec2> parse_size(const std::string& text) {
  const std::vector<std::string> sides = split(text, 'x');
  const auto width = number_from_text(sides[0]), height = number_from_text(sides.back());
  return check_size(sides.size() == 2 ? width.value_or(0) : 0, height.value_or(0), text);
}

Result<LoadedExperiment> load(const ExperimentArguments& arguments) {
  if (arguments.source && arguments.source->empty())
    return InputError{
        "EXPERIMENT: an empty name; allowed: an experiment file (.psm.json), a .gltf or .glb file, or a built-in scene's id"};
  return load_experiment(arguments.source.value_or(""), arguments.overrides);
}

std::string view_names() {
  std::string names;
  for (const ViewId id : kAllViews) names += (names.empty() ? "" : ", ") + std::string(name_of(id));
  return names;
}

bool print(const std::string& text) {
  errno = 0;
  return std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
}

void complain(const std::string& line) { std::fprintf(stderr, "%s\n", one_line(line).c_str()); }

int show_window(const ExperimentArguments& arguments, const std::string& lesson, bool present) {
  const auto loaded = load(arguments);
  if (!loaded) return bad_input(loaded.error());
  if (!lesson.empty())
    if (const auto error = check_lesson_argument(lesson)) return bad_input(*error);
  if (!display_available()) return draw_without_display(*loaded);
  const bool nothing = !arguments.source && arguments.overrides.empty() && lesson.empty() && !present;
  const auto error = run_window(*loaded, {lesson, present, nothing});
  return error ? other_failure(*error) : kDone;
}

int print_analysis(const ExperimentArguments& arguments, bool texels) {
  const auto loaded = load(arguments);
  if (!loaded) return bad_input(loaded.error());
  if (texels)
    if (const auto error = check_rays(loaded->experiment.image, "--texels")) return bad_input(*error);
  const Analysis analysis = texels ? analyze_with_texels(loaded->experiment, loaded->scene)
                                   : analyze(loaded->experiment, loaded->scene, RayTracer(loaded->scene));
  return finish_printing(print(analysis_to_json(analysis, loaded->scene)));
}

int print_matrices(const ExperimentArguments& arguments, const std::string& language, const std::string& convention) {
  const auto language_used = matrix_language_from_name(language);
  if (!language_used) return bad_input(flag_error("--matrices", language, "glsl, cpp or json"));
  const auto convention_used = clip_convention_from_name(convention);
  if (!convention_used) return bad_input(flag_error("--convention", convention, "opengl, d3d or reversed_z"));
  const auto loaded = load(arguments);
  if (!loaded) return bad_input(loaded.error());
  const Analysis analysis = analyze(loaded->experiment, loaded->scene, RayTracer(loaded->scene));
  return finish_printing(print(matrices_text(analysis, *language_used, *convention_used)));
}

int print_curves(const CurvesText& text) {
  const auto curves = parse_curves(text);
  if (!curves) return bad_input(curves.error());
  return finish_printing(write_curves(*curves, print));
}

int render_views(const RenderArguments& arguments) {
  auto sweep = parse_sweep(arguments.sweep);
  if (!sweep) return bad_input(sweep.error());
  const bool plays = arguments.animation || (arguments.lesson && !*sweep && is_film(arguments.out));
  if (auto error = check_picture_name(arguments.out, plays || sweep->has_value())) return bad_input(*error);
  const auto subject = subject_of(arguments);
  if (!subject) return bad_input(subject.error());
  if (plays && !subject->animation)
    return bad_input(flag_error("--lesson", *arguments.lesson,
                                "a step that has an animation; of one without, a .png, .svg or .pdf, or a --sweep"));
  if (plays) *sweep = frames_of(*subject->animation);
  const auto request = parse_request(arguments, *subject);
  if (!request) return bad_input(request.error());
  return draw_to_file(subject->loaded, *request, *sweep, arguments.out);
}

int list_scenes() {
  std::string text;
  for (const std::string& id : builtin_scene_ids()) text += id + "\n";
  return finish_printing(print(text));
}

int write_scenes(const std::string& folder) {
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (failed || folder.empty()) return bad_input(flag_error("--write", folder, "a folder that exists or can be made"));
  std::string written;
  for (const std::string& id : builtin_scene_ids()) {
    const fs::path file = fs::path(folder) / (id + ".glb");
    const auto scene = builtin_scene(id);
    if (!scene) return bad_input(scene.error());
    if (auto error = write_glb(*scene, file)) return bad_input(*error);
    written += file.string() + "\n";
  }
  return finish_printing(print(written));
}

}  // namespace psm
