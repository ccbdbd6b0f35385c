// SPDX-License-Identifier: GPL-3.0-or-later
#include "figure/figure_file.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "scene/json_check.h"

namespace psm {
namespace {

namespace fs = std::filesystem;
using json = nlohmann::ordered_json;

constexpr const char* kEnding = ".figure.json";
constexpr int kMostColumns = 8, kMostPanels = 32, kLargestPanel = 4096;

/// Thrown while a file is read, caught where it is opened.
struct Refused {
  std::string text;
};

std::string shown(const json& value) {
  const std::string text = value.dump(-1, ' ', true, json::error_handler_t::replace);
  return text.size() <= 60 ? text : text.substr(0, 60) + "...";
}

[[noreturn]] void refuse(const std::string& place, const json& value, const std::string& allowed) {
  throw Refused{place + ": " + shown(value) + " is not allowed; allowed: " + allowed};
}

void allow_only(const json& object, const std::string& place, std::initializer_list<const char*> names) {
  std::string allowed;
  for (const char* name : names) allowed += (allowed.empty() ? "" : ", ") + std::string(name);
  if (!object.is_object()) refuse(place, object, "an object with " + allowed);
  for (const auto& [name, value] : object.items())
    if (std::find(names.begin(), names.end(), name) == names.end())
      throw Refused{place + "." + name.substr(0, 60) + ": no such member; allowed: " + allowed};
}

std::string text_in(const json& object, const char* name) {
  const auto found = object.find(name);
  if (found == object.end()) throw Refused{std::string(name) + ": missing; allowed: a line of text"};
  if (!found->is_string() || found->get_ref<const std::string&>().find_first_not_of(" \t\r\n") == std::string::npos)
    refuse(name, *found, "a line of text");
  return *found;
}

int whole_number(const json& value, const std::string& place, int most) {
  const std::string allowed = "a whole number in [1, " + std::to_string(most) + "]";
  if (!value.is_number_integer()) refuse(place, value, allowed);
  const auto number = value.get<double>();
  if (!(number >= 1 && number <= most)) refuse(place, value, allowed);
  return int(number);
}

std::string role_names() {
  std::string names = "any of:";
  for (int i = 0; i <= int(Role::text); ++i) names += std::string(i ? ", " : " ") + name_of(Role(i));
  return names;
}

json experiment_in(const json& object, const std::string& place) {
  const json members = object.value("experiment", json::object());
  if (!members.is_object()) refuse(place + "experiment", members, "an object with members of an experiment");
  return members;
}

std::vector<Role> roles_in(const json& object, const std::string& place, const std::vector<Role>& otherwise) {
  const auto names = object.find("hide");
  if (names == object.end()) return otherwise;
  if (!names->is_array()) refuse(place + "hide", *names, "a list of roles");
  std::vector<Role> roles;
  for (const json& name : *names) {
    const auto role = name.is_string() ? role_from_name(name) : std::nullopt;
    if (!role) refuse(place + "hide", name, role_names());
    roles.push_back(*role);
  }
  return roles;
}

FigurePanel read_panel(const json& object, const std::string& place, const json& shared, const std::vector<Role>& hidden) {
  allow_only(object, place, {"view", "title", "experiment", "hide"});
  FigurePanel panel;
  panel.hidden = roles_in(object, place + ".", hidden);
  const json view = object.value("view", json("world"));
  std::string names;
  bool known = false;
  for (const ViewId id : kAllViews) {
    names += (names.empty() ? "" : ", ") + std::string(name_of(id));
    if (view == name_of(id)) panel.view = id, known = true;
  }
  if (!known) refuse(place + ".view", view, "one of: " + names);
  if (const auto title = object.find("title"); title != object.end()) {
    if (!title->is_string()) refuse(place + ".title", *title, "a line of text");
    panel.title = *title;
  }
  json experiment = shared;
  experiment.merge_patch(experiment_in(object, place + "."));
  panel.experiment = experiment.dump();
  return panel;
}

FigureFile read(const json& root) {
  allow_only(root, "figure", {"psmlab_figure", "title", "source", "columns", "panel_size", "experiment", "hide", "panels"});
  if (root.value("psmlab_figure", json()) != 1) refuse("psmlab_figure", root.value("psmlab_figure", json()), "1");
  FigureFile figure;
  figure.title = text_in(root, "title");
  figure.source = text_in(root, "source");
  if (root.contains("columns")) figure.columns = whole_number(root["columns"], "columns", kMostColumns);
  if (const auto size = root.find("panel_size"); size != root.end()) {
    if (!size->is_array() || size->size() != 2) refuse("panel_size", *size, "[width, height] in pixels");
    for (int i = 0; i < 2; ++i) figure.panel_size[i] = whole_number((*size)[std::size_t(i)], "panel_size", kLargestPanel);
  }
  const json panels = root.value("panels", json());
  if (!panels.is_array() || panels.empty() || panels.size() > std::size_t(kMostPanels))
    refuse("panels", panels, "a list of 1 to " + std::to_string(kMostPanels) + " panels");
  const json shared = experiment_in(root, "");
  const std::vector<Role> hidden = roles_in(root, "", {});
  for (std::size_t i = 0; i < panels.size(); ++i)
    figure.panels.push_back(read_panel(panels[i], "panels[" + std::to_string(i) + "]", shared, hidden));
  return figure;
}

}  // namespace

Result<FigureFile> read_figure(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return InputError{file.string() + ": cannot be read; allowed: a figure file (.figure.json)"};
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (const auto error = check_json(text)) return InputError{file.string() + ": " + error->text};
  try {
    FigureFile figure = read(json::parse(text));
    const std::string name = file.filename().string();
    figure.id = name.ends_with(kEnding) ? name.substr(0, name.size() - std::string(kEnding).size()) : file.stem().string();
    return figure;
  } catch (const Refused& refused) {
    return InputError{file.string() + ": " + refused.text};
  }
}

std::vector<fs::path> figure_files(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
    if (entry.path().filename().string().ends_with(kEnding)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace psm
