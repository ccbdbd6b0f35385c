// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/figure.h"

#include <cmath>

#include "app/assets.h"
#include "app/command_line.h"
#include "app/commands.h"
#include "app/headless_context.h"
#include "app/numbers.h"
#include "app/picture_file.h"
#include "app/render.h"
#include "figure/figure_file.h"

namespace psm {
namespace {

namespace fs = std::filesystem;

constexpr int kGap = 12;  // between panels, pixels at scale 1
constexpr int kSmallestPanel = 16;

fs::path figures_folder() { return assets_folder() / "figures"; }

/// The file of an id, or the file itself.
Result<fs::path> find_figure(const std::string& id) {
  if (id.ends_with(".json")) return fs::path(id);
  for (const fs::path& file : figure_files(figures_folder()))
    if (file.filename() == id + ".figure.json") return file;
  return flag_error("ID", id, "one of those that psmlab figure --list shows, or a .figure.json file");
}

/// Panels with the same members share one experiment.
Result<std::vector<SheetPanel>> load_panels(const FigureFile& figure, const fs::path& file,
                                            const std::vector<std::string>& overrides) {
  std::vector<SheetPanel> panels;
  for (std::size_t i = 0; i < figure.panels.size(); ++i) {
    const FigurePanel& panel = figure.panels[i];
    if (i > 0 && panel.experiment == figure.panels[i - 1].experiment) {
      panels.push_back({panels.back().loaded, panel.view, panel.title, {{}, panel.hidden}});
      continue;
    }
    const std::string name = file.string() + ": panels[" + std::to_string(i) + "]";
    auto loaded = parse_experiment(panel.experiment, name, file.parent_path(), overrides);
    if (!loaded) return loaded.error();
    panels.push_back({std::make_shared<const LoadedExperiment>(std::move(*loaded)), panel.view, panel.title, {{}, panel.hidden}});
  }
  return panels;
}

/// The size that the file gives, or this one, whose lines and type grow with it.
void place_panels(const FigureFile& figure, const std::optional<glm::ivec2>& size, Sheet& sheet) {
  const int columns = figure.columns, rows = (int(figure.panels.size()) + columns - 1) / columns;
  const glm::ivec2 grid(columns, rows), natural = grid * figure.panel_size + (grid - 1) * kGap;
  sheet.size = size.value_or(natural);
  sheet.scale = std::min(double(sheet.size.x) / natural.x, double(sheet.size.y) / natural.y);
  const int gap = int(std::lround(kGap * sheet.scale));
  const glm::ivec2 panel = (sheet.size - (grid - 1) * gap) / grid;
  for (int i = 0; i < int(sheet.panels.size()); ++i) {
    sheet.panels[std::size_t(i)].top_left = glm::ivec2(i % columns, i / columns) * (panel + gap);
    sheet.panels[std::size_t(i)].size = panel;
  }
}

Result<Sheet> make_sheet(const fs::path& file, const FigureArguments& arguments) {
  const auto figure = read_figure(file);
  if (!figure) return figure.error();
  Sheet sheet;
  sheet.theme = arguments.theme == "dark" ? Theme::dark : Theme::light;
  sheet.background = picture_ground(sheet.theme);
  sheet.transparent = arguments.transparent;
  sheet.supersampled = true;
  sheet.title = figure->title + " (" + figure->source + ")";
  auto panels = load_panels(*figure, file, arguments.overrides);
  if (!panels) return panels.error();
  sheet.panels = std::move(*panels);
  std::optional<glm::ivec2> size;
  if (arguments.size) {
    const auto parsed = parse_size(*arguments.size);
    if (!parsed) return parsed.error();
    size = *parsed;
  }
  place_panels(*figure, size, sheet);
  if (std::int64_t(sheet.size.x) * sheet.size.y > kMostPixels)
    return InputError{file.string() + ": panel_size: " + std::to_string(sheet.size.x) + "x" + std::to_string(sheet.size.y) +
                      " pixels for all panels; allowed: together at most " + std::to_string(kMostPixels) +
                      ", or a smaller --size"};
  const glm::ivec2 panel = sheet.panels.front().size;
  if (std::min(panel.x, panel.y) >= kSmallestPanel) return sheet;
  const std::string least = "16 pixels or more";
  if (size) return flag_error("--size", *arguments.size, "a size that leaves each of the figure's panels " + least);
  return InputError{file.string() + ": panel_size: a panel of " + std::to_string(panel.x) + "x" + std::to_string(panel.y) +
                    " pixels; allowed: " + least};
}

int list_figures() {
  std::string text;
  for (const fs::path& file : figure_files(figures_folder())) {
    const auto figure = read_figure(file);
    if (!figure) return bad_input(figure.error());
    text += figure->id + "\t" + figure->source + "\t" + figure->title + "\n";
  }
  return finish_printing(print(text));
}

int write_figure(SheetPainter& painter, const fs::path& file, const FigureArguments& arguments,
                 const std::optional<PictureSweep>& sweep, const fs::path& out) {
  const auto sheet = make_sheet(file, arguments);
  if (!sheet) return bad_input(sheet.error());
  const auto error = write_pictures(painter, *sheet, sweep, out);
  return error ? bad_input(*error) : kDone;
}

/// Each is written as soon as it is drawn, and named.
int write_all(const FigureArguments& arguments) {
  if (check_picture_name("x." + arguments.format, false))
    return bad_input(flag_error("--format", arguments.format, "png, svg, or pdf where this program was built with Cairo"));
  std::error_code failed;
  fs::create_directories(arguments.out, failed);
  if (failed || arguments.out.empty())
    return bad_input(flag_error("--out", arguments.out, "a folder that exists or can be made"));
  const auto context = HeadlessContext::create();
  if (!context) return other_failure(context.error());
  SheetPainter painter;
  for (const fs::path& file : figure_files(figures_folder())) {
    const fs::path name = file.filename().stem().stem();
    const fs::path out = fs::path(arguments.out) / (name.string() + "." + arguments.format);
    const int code = write_figure(painter, file, arguments, std::nullopt, out);
    if (code != kDone) return code;
    if (!print(out.string() + "\n")) return finish_printing(false);
  }
  return finish_printing(true);
}

int write_one(const FigureArguments& arguments) {
  if (!arguments.id) return bad_input({"figure: no ID; allowed: an ID with --out, --list, or --all with --out"});
  const auto sweep = parse_sweep(arguments.sweep);
  if (!sweep) return bad_input(sweep.error());
  if (const auto error = check_picture_name(arguments.out, sweep->has_value())) return bad_input(*error);
  const auto file = find_figure(*arguments.id);
  if (!file) return bad_input(file.error());
  const auto context = HeadlessContext::create();
  if (!context) return other_failure(context.error());
  SheetPainter painter;
  return write_figure(painter, *file, arguments, *sweep, arguments.out);
}

}  // namespace

int figure(const FigureArguments& arguments) {
  if (arguments.list) return list_figures();
  if (arguments.theme != "light" && arguments.theme != "dark")
    return bad_input(flag_error("--theme", arguments.theme, "light or dark"));
  if (!arguments.all) return write_one(arguments);
  if (arguments.id || arguments.sweep)
    return bad_input({"figure --all: together with an ID or --sweep; allowed: with --out alone"});
  return write_all(arguments);
}

}  // namespace psm
