// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line.h"

#include <fcntl.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <exception>

#include "app/commands.h"
#include "app/figure.h"
#include "app/lessons.h"
#include "app/measure.h"
#include "app/report.h"

namespace psm {
namespace {

constexpr const char* kExperimentHelp =
    "An experiment file (.psm.json), a .gltf or .glb file, a built-in scene's id, or a copied line, 'psmlab:...'; without it, "
    "the "
    "chessboard";

/// Everything that can be typed. CLI11 keeps references to it while it parses.
struct Arguments {
  ExperimentArguments experiment;  // of the window and of analyze
  bool texels = false, present = false;
  std::string matrices, convention = "opengl";
  CurvesText curves;
  RenderArguments render;
  FigureArguments figure;
  std::string scenes_folder;
  MeasureArguments measure;
  ReportArguments report;
  std::vector<std::string> lesson_files;
  std::string lesson;  // of the window
};

CLI::Option* add_experiment(CLI::App& app, ExperimentArguments& arguments) {
  // One value for each --set: what follows it is an argument of its own.
  app.add_option("--set", arguments.overrides, "Sets one member, such as light.to_light=0,1,-0.2; may be given again")
      ->type_name("PATH=VALUE")
      ->allow_extra_args(false);
  return app.add_option("EXPERIMENT", arguments.source, kExperimentHelp)->type_name("");
}

void add_analyze(CLI::App& app, Arguments& arguments) {
  add_experiment(app, arguments.experiment);
  auto* texels = app.add_flag("--texels", arguments.texels, "Asks for the statistics of texels on the image");
  auto* matrices =
      app.add_option("--matrices", arguments.matrices, "Prints the matrices instead, ready to paste: glsl, cpp or json")
          ->type_name("LANGUAGE")
          ->excludes(texels);
  app.add_option("--convention", arguments.convention, "Their clip space: opengl, d3d or reversed_z")
      ->type_name("NAME")
      ->needs(matrices);
}

void add_curves(CLI::App& app, CurvesText& curves) {
  app.add_option("--n", curves.n, "Distance of the nearest receiver")->type_name("N")->required();
  app.add_option("--f", curves.f, "Distance of the farthest receiver")->type_name("F")->required();
  app.add_option("--phi-deg", curves.phi_deg, "Half the vertical opening angle, in (0, 90)")->type_name("P")->required();
  app.add_option("--theta-deg", curves.theta_deg,
                 "Angles between light and view: A:B:STEP, or a comma-separated list, in [0, 180]")
      ->type_name("LIST")
      ->required();
  app.add_option("--techniques", curves.techniques,
                 "Comma-separated list of SSM, LISPSM, LISPSM_GENERAL, GLPR, GMNPR, GMNPR_EQ4, MINIMAX, MINIMAX_FRUSTUM; "
                 "without it, all but the last")
      ->type_name("LIST");
}

CLI::Option* add_sweep(CLI::App& app, std::optional<std::string>& sweep) {
  return app
      .add_option(
          "--sweep", sweep,
          "Takes a number of the experiment from A to B in COUNT pictures, numbered from NAME_0001, or as a film (.mp4, .gif, "
          "by ffmpeg): camera.near, light.position.x, light.theta_deg ...")
      ->type_name("PATH=A:B:COUNT");
}

void add_render(CLI::App& app, RenderArguments& render) {
  CLI::Option* experiment = add_experiment(app, render.experiment);
  auto* lesson = app.add_option("--lesson", render.lesson,
                                "Draws a step of a lesson as it begins: its name or folder, /3 behind it for its third step")
                     ->type_name("NAME")
                     ->excludes(experiment);
  app.add_option("--view", render.views,
                 "Comma-separated list of " + view_names() + "; without it, the first four, or those of the lesson's step")
      ->type_name("LIST");
  app.add_option("--out", render.out, "The picture to write, .png, .svg or .pdf; several views share it in two columns")
      ->type_name("FILE")
      ->required();
  app.add_option("--size", render.size, "Size of the whole picture in pixels; without it, the experiment's image")
      ->type_name("WxH");
  app.add_option("--scale", render.scale, "Enlarges lines and type, in [0.25, 8]")->type_name("S");
  app.add_option("--theme", render.theme, "light or dark")->type_name("THEME");
  app.add_flag("--transparent", render.transparent, "Leaves out the background");
  CLI::Option* sweep = add_sweep(app, render.sweep);
  app.add_flag("--animation", render.animation,
               "Plays the animation of the lesson's step, in pictures numbered from NAME_0001; a film (.mp4, .gif) plays it "
               "without being told")
      ->needs(lesson)
      ->excludes(sweep);
}

void add_figure(CLI::App& app, FigureArguments& figure) {
  app.add_option("ID", figure.id, "A figure's name, or a .figure.json file")->type_name("");
  app.add_flag("--list", figure.list, "Lists the figures: name, source, what it shows");
  auto* all = app.add_flag("--all", figure.all, "Writes every figure into the folder that --out names");
  app.add_option("--out", figure.out, "The picture to write, .png, .svg or .pdf; with --all, the folder")->type_name("FILE");
  app.add_option("--format", figure.format, "What --all writes: png, svg or pdf")->type_name("ENDING")->needs(all);
  app.add_option("--size", figure.size, "Size in pixels; lines and type grow with it")->type_name("WxH");
  app.add_option("--theme", figure.theme, "light or dark")->type_name("THEME");
  app.add_flag("--transparent", figure.transparent, "Leaves out the background");
  app.add_option("--set", figure.overrides, "Sets one member in every panel's experiment; may be given again")
      ->type_name("PATH=VALUE")
      ->allow_extra_args(false);
  add_sweep(app, figure.sweep);
}

void add_measure(CLI::App& app, MeasureArguments& measure) {
  add_experiment(app, measure.experiment);
  app.add_option("--techniques", measure.techniques, "Comma-separated list, or all; without it, the experiment's own")
      ->type_name("LIST");
  app.add_option("--resolutions", measure.resolutions,
                 "Comma-separated list of texels along a side of the map; without it, the experiment's own")
      ->type_name("LIST");
  app.add_option(
         "--theta-deg", measure.theta_deg,
         "Angles between the view direction and a directional light, which is turned in the plane of the two: A:B:STEP, or "
         "a comma-separated list, in [0, 180]")
      ->type_name("LIST");
  app.add_option("--far", measure.far, "Comma-separated list of the camera's far distances")->type_name("LIST");
  app.add_flag("--equal-error", measure.equal_error,
               "Also looks for the smallest uniform map with no larger error, by bisection");
  app.add_flag("--hard-cases", measure.hard_cases,
               "Runs the table of hard cases instead: float, double, exact, error in texels, verdict, time of each");
  app.add_flag("--csv", measure.csv, "As CSV");
  app.add_flag("--json", measure.json, "As JSON; without either flag runs are printed as JSON, hard cases as aligned text");
}

void add_report(CLI::App& app, ReportArguments& report) {
  app.add_option("--out", report.out, "The folder for the report; finished rows in it are kept, and not measured again")
      ->type_name("DIR")
      ->required();
  app.add_flag("--quick", report.quick, "A small part of the study, in seconds instead of minutes");
  app.add_option("--shard", report.shard, "Measures only the I-th of N parts of the study, for several machines")
      ->type_name("I/N");
  app.add_option("--merge", report.merge, "Measures nothing: puts the rows of these reports' folders together")
      ->type_name("DIR ...");
}

/// CLI11's own message, in one line; it names the flag but not what is allowed.
int refuse(const CLI::ParseError& error, const CLI::App& app) {
  const auto used = app.get_subcommands();
  const std::string command = used.empty() ? "psmlab" : "psmlab " + used.front()->get_name();
  complain(std::string(error.what()) + "; allowed: see " + command + " --help");
  return kBadInput;
}

int parse_and_run(int argc, char** argv) {
  Arguments arguments;
  CLI::App app("psmlab: perspective shadow maps, to look at and to measure. Without a command it opens the window.", "psmlab");
  app.set_version_flag("--version", "psmlab " PSMLAB_VERSION);
  app.require_subcommand(0, 1);
  CLI::Option* window_experiment = add_experiment(app, arguments.experiment);
  app.add_flag("--present", arguments.present, "Opens the window in front of a class: large type, no controls (key F11)");
  CLI::Option* lesson_option = app.add_option("--lesson", arguments.lesson,
                                              "Opens the window in a lesson: its name or folder, /3 behind it for its third step")
                                   ->type_name("NAME");
  CLI::App& analyze = *app.add_subcommand("analyze", "Prints the analysis of an experiment as JSON");
  add_analyze(analyze, arguments);
  CLI::App& curves = *app.add_subcommand("curves", "Prints the error model as CSV, a row for each angle and technique");
  add_curves(curves, arguments.curves);
  CLI::App& render = *app.add_subcommand("render", "Writes views as a picture, without a display");
  add_render(render, arguments.render);
  CLI::App& figures = *app.add_subcommand("figure", "Writes figures of the source texts, each from a live experiment");
  add_figure(figures, arguments.figure);
  CLI::App& measured = *app.add_subcommand("measure", "Measures the error of shadow maps, and what they cost");
  add_measure(measured, arguments.measure);
  CLI::App& reported = *app.add_subcommand("report", "Writes the speed-against-error study: rows, plots, one HTML page");
  add_report(reported, arguments.report);
  CLI::App& scenes = *app.add_subcommand("scenes", "Lists the built-in scenes, or writes them as .glb");
  CLI::Option* write = scenes.add_option("--write", arguments.scenes_folder, "The folder to write them to")->type_name("DIR");
  CLI::App& lesson = *app.add_subcommand("lesson", "Lists and checks lessons");
  lesson.require_subcommand(1);
  lesson.add_subcommand("list", "Prints the shipped lessons, one a line");
  CLI::App& lesson_check = *lesson.add_subcommand(
      "check", "Checks lessons: what is wrong, with file and line, what is allowed; whether tasks can be done and claims hold");
  lesson_check
      .add_option("FILE", arguments.lesson_files,
                  "A lesson's folder, its lesson.json, or a shipped lesson's name; without it, all shipped lessons")
      ->type_name("");

  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForVersion& version) {
    return print(std::string(version.what()) + "\n") && std::fflush(stdout) == 0 ? kDone : kOtherFailure;
  } catch (const CLI::CallForHelp&) {
    const CLI::App* asked = &app;
    std::string before;
    for (auto used = app.get_subcommands(); !used.empty(); used = asked->get_subcommands()) {
      before += (before.empty() ? "" : " ") + asked->get_name();
      asked = used.front();
    }
    const std::string help = asked->help(before);
    return print(help) && std::fflush(stdout) == 0 ? kDone : kOtherFailure;
  } catch (const CLI::ParseError& error) {
    return refuse(error, app);
  }
  // An experiment before the command's name would be lost without a word.
  if (!app.get_subcommands().empty() &&
      (window_experiment->count() > 0 || app.count("--set") > 0 || arguments.present || lesson_option->count() > 0)) {
    complain("EXPERIMENT, --set, --present and --lesson: not before the command's name; allowed: after it");
    return kBadInput;
  }
  if (analyze.parsed() && analyze.count("--matrices") > 0)
    return print_matrices(arguments.experiment, arguments.matrices, arguments.convention);
  if (analyze.parsed()) return print_analysis(arguments.experiment, arguments.texels);
  if (curves.parsed()) return print_curves(arguments.curves);
  if (render.parsed()) return render_views(arguments.render);
  if (figures.parsed()) return figure(arguments.figure);
  if (measured.parsed()) return measure(arguments.measure);
  if (reported.parsed()) return report(arguments.report);
  if (scenes.parsed()) return write->count() > 0 ? write_scenes(arguments.scenes_folder) : list_scenes();
  if (lesson.parsed()) return lesson_check.parsed() ? check_lessons(arguments.lesson_files) : list_lessons();
  return show_window(arguments.experiment, arguments.lesson, arguments.present);
}

/// A program started with closed standard streams must not find its own files under their numbers.
void reserve_standard_streams() {
  for (int stream = 0; stream <= 2; ++stream)
    if (fcntl(stream, F_GETFD) == -1) (void)!open("/dev/null", O_RDONLY);
}

}  // namespace

int run_command_line(int argc, char** argv) {
  reserve_standard_streams();
  std::signal(SIGPIPE, SIG_IGN);  // a reader that left is a failed write, not a sudden end
  try {
    return parse_and_run(argc, argv);
  } catch (const std::bad_alloc&) {
    complain("out of memory");
  } catch (const std::exception& error) {
    complain(std::string("internal error: ") + error.what());
  }
  return kOtherFailure;
}

}  // namespace psm
