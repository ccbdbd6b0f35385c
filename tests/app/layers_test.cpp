// SPDX-License-Identifier: GPL-3.0-or-later
// The rooms of the house: who may include whom, where third-party libraries may be seen, and the licence line of every file.
// math <- geom <- scene <- measure, draw <- lesson <- gl, ui, figure <- app
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// What each room may include besides itself. A widget shows what the renderer drew, so ui also sees gl.
const std::map<std::string, std::set<std::string>>& rooms_seen_from() {
  static const std::map<std::string, std::set<std::string>> seen{
      {"math", {}},
      {"geom", {"math"}},
      {"scene", {"math", "geom"}},
      {"measure", {"math", "geom", "scene"}},
      {"draw", {"math", "geom", "scene"}},
      {"lesson", {"math", "geom", "scene", "draw"}},
      {"gl", {"math", "geom", "scene", "measure", "draw"}},
      {"figure", {"math", "geom", "scene", "measure", "draw"}},
      {"ui", {"math", "geom", "scene", "measure", "draw", "lesson", "gl"}},
      {"app", {"math", "geom", "scene", "measure", "draw", "lesson", "gl", "figure", "ui"}}};
  return seen;
}

struct Quarantine {
  const char* library;
  std::regex header, allowed_file;
};

const std::vector<Quarantine>& quarantines() {
  static const std::vector<Quarantine> list{
      {"OpenGL", std::regex("(epoxy|GL|GLES2|GLES3|EGL)/.*"), std::regex("viz/gl/.*|app/headless_context\\.cpp")},
      {"GLFW", std::regex("GLFW/.*"), std::regex("app/.*\\.cpp")},
      {"Dear ImGui", std::regex("imgui.*"), std::regex("(viz/ui|app)/.*")},
      {"tinygltf", std::regex("tiny_gltf.*"), std::regex("viz/scene/.*\\.cpp")},
      {"nlohmann-json", std::regex("nlohmann/.*"), std::regex("viz/(scene|lesson|figure)/.*\\.cpp")},
      {"Cairo", std::regex("cairo.*"), std::regex("viz/figure/page_pdf\\.cpp")},
      {"md4c", std::regex("md4c.*"), std::regex("viz/lesson/.*\\.cpp")},
      {"CGAL", std::regex("CGAL/.*"), std::regex("viz/(geom/.*|measure/ray_engine_cgal)\\.cpp")},
      {"Embree", std::regex("embree.*"), std::regex("viz/measure/.*\\.cpp")},
      {"Boost", std::regex("boost/.*"), std::regex("viz/measure/wide\\.cpp")},
      {"CLI11", std::regex("CLI/.*"), std::regex("app/.*\\.cpp")},
      {"stb", std::regex("stb.*"), std::regex("viz/(scene|draw|gl|figure)/.*\\.cpp")}};
  return list;
}

/// "math" for viz/math/x.cpp, "app" for app/x.cpp.
std::string room_of(const std::string& path) {
  if (path.rfind("app/", 0) == 0) return "app";
  return path.substr(4, path.find('/', 4) - 4);
}

/// Empty where the line is no include, or a good one.
std::string include_fault(const std::string& path, const std::string& line) {
  static const std::regex include("\\s*#\\s*include\\s*([<\"])([^>\"]+)[>\"].*");
  std::smatch match;
  if (!std::regex_match(line, match, include)) return "";
  const std::string header = match[2];
  for (const Quarantine& q : quarantines())
    if (std::regex_match(header, q.header) && !std::regex_match(path, q.allowed_file))
      return std::string(q.library) + " may not be seen from here: " + header;
  if (match[1] == "<") return "";
  const std::string from = room_of(path), to = header.substr(0, header.find('/'));
  if (header.find('/') == std::string::npos || !rooms_seen_from().count(to)) return "not written as ROOM/header: " + header;
  const auto seen = rooms_seen_from().find(from);
  if (seen == rooms_seen_from().end()) return "no rule says what the room " + from + " may include";
  return to == from || seen->second.count(to) ? "" : from + " may not include from " + to + ": " + header;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::vector<std::string> include_faults(const std::string& path, const std::string& text) {
  std::vector<std::string> faults;
  const std::vector<std::string> lines = lines_of(text);
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (const std::string fault = include_fault(path, lines[i]); !fault.empty())
      faults.push_back(path + ":" + std::to_string(i + 1) + ": " + fault);
  return faults;
}

/// The types that a header defines outside of others.
std::vector<std::string> types_of(const std::string& text) {
  static const std::regex definition("(?:struct|class|enum class) ([A-Za-z0-9]+)(?: final)? ?(?:\\{|:[^:]).*");
  std::vector<std::string> types;
  std::smatch match;
  for (const std::string& line : lines_of(text))
    if (std::regex_match(line, match, definition)) types.push_back(match[1]);
  return types;
}

/// The first line holds the licence, but for scripts and shaders, which must begin with something else.
std::vector<std::string> licence_faults(const std::string& path, const std::string& text) {
  const std::vector<std::string> lines = lines_of(text);
  const bool second = !lines.empty() && (lines[0].rfind("#!", 0) == 0 || lines[0].rfind("#version", 0) == 0);
  const std::size_t at = second ? 1 : 0;
  static const std::regex licence("(//|#) SPDX-License-Identifier: GPL-3\\.0-or-later");
  if (at < lines.size() && std::regex_match(lines[at], licence)) return {};
  return {path + ":" + std::to_string(at + 1) + ": the line \"SPDX-License-Identifier: GPL-3.0-or-later\" is missing"};
}

const fs::path& root() {
  static const fs::path folder = fs::path(PSMLAB_TEST_DATA).parent_path();
  return folder;
}

bool is_source(const fs::path& file) {
  static const std::set<std::string> endings{".cpp", ".h", ".cmake", ".sh", ".vert", ".frag", ".glsl"};
  return endings.count(file.extension().string()) || file.filename() == "CMakeLists.txt" || file.filename() == "run";
}

/// Paths from the root, with their contents.
std::map<std::string, std::string> sources(const std::vector<std::string>& folders) {
  std::map<std::string, std::string> files;
  for (const std::string& folder : folders)
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root() / folder)) {
      if (!entry.is_regular_file() || !is_source(entry.path())) continue;
      std::ostringstream text;
      text << std::ifstream(entry.path()).rdbuf();
      files[fs::relative(entry.path(), root()).generic_string()] = text.str();
    }
  return files;
}

bool is_cpp(const std::string& path) {
  const std::string ending = fs::path(path).extension().string();
  return ending == ".cpp" || ending == ".h";
}

TEST(Layers, EveryIncludePointsTheRightWay) {
  int files = 0;
  for (const auto& [path, text] : sources({"viz", "app"})) {
    if (!is_cpp(path)) continue;
    ++files;
    for (const std::string& fault : include_faults(path, text)) ADD_FAILURE() << fault;
  }
  EXPECT_GT(files, 40);
}

TEST(Layers, EverySourceFileNamesItsLicence) {
  for (const auto& [path, text] : sources({"viz", "app", "tests", "assets", ".ci"}))
    for (const std::string& fault : licence_faults(path, text)) ADD_FAILURE() << fault;
}

// Two definitions of one name link without a word, and share the constructors and containers of either.
TEST(Layers, NoTwoHeadersDefineTheSameType) {
  std::map<std::string, std::string> first;
  for (const auto& [path, text] : sources({"viz", "app"})) {
    if (fs::path(path).extension() != ".h") continue;
    for (const std::string& type : types_of(text))
      if (const auto [place, added] = first.emplace(type, path); !added)
        ADD_FAILURE() << type << ": " << place->second << ", " << path;
  }
  EXPECT_GT(first.size(), 100u);
}

// ---- the rules themselves ---------------------------------------------------------------------------------------------

TEST(LayerRules, NameFileAndLineOfAWrongArrow) {
  EXPECT_THAT(include_faults("viz/math/warp.h", "#pragma once\n#include \"scene/scene.h\"\n"),
              ElementsAre("viz/math/warp.h:2: math may not include from scene: scene/scene.h"));
  EXPECT_THAT(include_faults("viz/draw/a.cpp", "#include \"gl/renderer.h\""),
              ElementsAre(HasSubstr("viz/draw/a.cpp:1: draw may not")));
  EXPECT_THAT(include_faults("viz/gl/a.cpp", "#include \"ui/panel.h\""), ElementsAre(HasSubstr("gl may not include from ui")));
  EXPECT_THAT(include_faults("viz/ui/a.cpp", "  # include \"app/window.h\""),
              ElementsAre(HasSubstr("ui may not include from app")));
}

TEST(LayerRules, LetGoodArrowsPass) {
  EXPECT_THAT(include_faults("viz/scene/a.cpp", "#include <vector>\n#include \"scene/b.h\"\n#include \"math/warp.h\"\n"),
              IsEmpty());
  EXPECT_THAT(include_faults("app/main.cpp", "#include \"app/render.h\"\n#include \"ui/panel.h\"\n// #include \"no/such.h\"\n"),
              IsEmpty());
}

TEST(LayerRules, WantIncludesRootedAtARoom) {
  EXPECT_THAT(include_faults("viz/gl/a.cpp", "#include \"renderer.h\""), ElementsAre(HasSubstr("not written as ROOM/header")));
  EXPECT_THAT(include_faults("viz/gl/a.cpp", "#include \"../draw/view.h\""),
              ElementsAre(HasSubstr("not written as ROOM/header")));
}

TEST(LayerRules, KeepLibrariesInTheirRooms) {
  const auto faults = [](const char* path, const char* header) {
    return include_faults(path, "#include <" + std::string(header) + ">").size();
  };
  EXPECT_EQ(faults("viz/gl/renderer.cpp", "epoxy/gl.h"), 0u);
  EXPECT_EQ(faults("app/headless_context.cpp", "epoxy/egl.h"), 0u);
  EXPECT_EQ(faults("app/window.cpp", "epoxy/gl.h"), 1u);
  EXPECT_EQ(faults("viz/draw/view.cpp", "imgui.h"), 1u);
  EXPECT_EQ(faults("viz/ui/panel.cpp", "imgui.h"), 0u);
  EXPECT_EQ(faults("viz/scene/gltf.h", "tiny_gltf.h"), 1u);
  EXPECT_EQ(faults("viz/scene/gltf.cpp", "nlohmann/json.hpp"), 0u);
  EXPECT_EQ(faults("viz/lesson/markdown.cpp", "md4c.h"), 0u);
  EXPECT_EQ(faults("viz/ui/panel.cpp", "md4c.h"), 1u);
  EXPECT_EQ(faults("viz/geom/body.h", "CGAL/Interval_nt.h"), 1u);
  EXPECT_EQ(faults("viz/geom/body.cpp", "CGAL/Interval_nt.h"), 0u);
  EXPECT_EQ(faults("viz/measure/ray_engine_cgal.cpp", "CGAL/AABB_tree.h"), 0u);
  EXPECT_EQ(faults("viz/measure/ray_tracer.cpp", "CGAL/AABB_tree.h"), 1u);
  EXPECT_EQ(faults("viz/measure/ray_engine_embree.cpp", "embree3/rtcore.h"), 0u);
  EXPECT_EQ(faults("viz/measure/ray_tracer.h", "embree3/rtcore.h"), 1u);
  EXPECT_EQ(faults("viz/measure/wide.h", "boost/multiprecision/cpp_int.hpp"), 1u);
  EXPECT_EQ(faults("viz/measure/wide.cpp", "boost/multiprecision/cpp_int.hpp"), 0u);
}

TEST(LayerRules, FindTheTypesOfAHeader) {
  EXPECT_THAT(types_of("struct A {\nstruct B;\nclass C : public A {\nstruct C::D {\n  struct E {\nenum class F { g };\n"),
              ElementsAre("A", "C", "F"));
}

TEST(LayerRules, WantTheLicenceFirst) {
  const std::string line = "SPDX-License-Identifier: GPL-3.0-or-later\n";
  EXPECT_THAT(licence_faults("a.cpp", "// " + line), IsEmpty());
  EXPECT_THAT(licence_faults("app/run", "#!/bin/sh\n# " + line), IsEmpty());
  EXPECT_THAT(licence_faults("a.cpp", "\n// " + line), ElementsAre(HasSubstr("a.cpp:1:")));
  EXPECT_THAT(licence_faults("app/run", "#!/bin/sh\necho\n"), ElementsAre(HasSubstr("app/run:2:")));
  EXPECT_THAT(licence_faults("a.cpp", ""), ElementsAre(HasSubstr("a.cpp:1:")));
}

}  // namespace
