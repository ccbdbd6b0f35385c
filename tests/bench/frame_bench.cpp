// SPDX-License-Identifier: GPL-3.0-or-later
// A full frame (the shadow map and all four views afresh, without a window) beside bare draws of the same triangles in the same
// run: the map's, and those of world, cube and eye once each, in one draw call, into framebuffers of the same sizes and samples,
// cleared and resolved alike. `ratio`: beside bare draws in one grey. `ratio_lit`: beside bare draws with the least shading that
// shows shadows (Lambert's cosine, one comparison with the map, gamma), written down here and not taken from the renderer.
// `ratio_own`: beside the frame's own pictures without what is drawn over them. One row a scene; they take turns, medians over
// the iterations. All times wait until everything is drawn. The renderer is named in the context above the rows.
//   frame_bench [--benchmark_filter=chessboard]
#include <benchmark/benchmark.h>
#include <epoxy/gl.h>

#include <algorithm>
#include <array>

#include "app/assets.h"
#include "app/headless_context.h"
#include "gl/gl_objects.h"
#include "gl/gl_state.h"
#include "gl/pass_timer.h"
#include "gl/renderer.h"
#include "gl/view_target.h"

namespace psm {
namespace {

constexpr glm::ivec2 kSize(640, 360);  // of each view
constexpr int kIterations = 25;

constexpr const char* kFlatVertex =
    "layout(location = 0) in vec3 a; uniform mat4 m; void main() { gl_Position = m * vec4(a, 1.0); }";
constexpr const char* kFlatFragment = "out vec4 o; void main() { o = vec4(0.5, 0.5, 0.5, 1.0); }";

constexpr const char* kLitVertex = R"(
layout(location = 0) in vec3 a; layout(location = 1) in vec3 b; layout(location = 2) in vec3 c;
uniform mat4 m; out vec3 position, normal, color;
void main() { gl_Position = m * vec4(a, 1.0); position = a; normal = b; color = c; })";
constexpr const char* kLitFragment = R"(
in vec3 position, normal, color; uniform mat4 map; uniform vec4 light; uniform highp sampler2DShadow shadow; out vec4 o;
void main() {
  vec4 q = map * vec4(position, 1.0);
  vec3 at = 0.5 * q.xyz / q.w + 0.5;
  at.z -= 0.001;
  float lit = all(lessThan(abs(at - 0.5), vec3(0.5))) ? texture(shadow, at) : 1.0;
  vec3 n = normalize(gl_FrontFacing ? normal : -normal), l = normalize(light.xyz - light.w * position);
  o = vec4(pow(color * (0.2 + 0.05 * n.y + 0.7 * lit * max(dot(n, l), 0.0)), vec3(1.0 / 2.2)), 1.0);
})";

GLuint compiled(GLenum kind, const char* body) {
  const std::string source =
      std::string(epoxy_is_desktop_gl() ? "#version 330 core\n" : "#version 300 es\nprecision highp float;\n") + body;
  const char* text = source.c_str();
  const GLuint shader = glCreateShader(kind);
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  return shader;
}

GLuint linked(const char* vertex, const char* fragment) {
  const GLuint program = glCreateProgram();
  glAttachShader(program, compiled(GL_VERTEX_SHADER, vertex));
  glAttachShader(program, compiled(GL_FRAGMENT_SHADER, fragment));
  glLinkProgram(program);
  GLint ok = 0;
  glGetProgramiv(program, GL_LINK_STATUS, &ok);
  if (!ok) gl::fail("frame_bench: the bare shaders do not link");
  return program;
}

struct BareVertex {
  glm::vec3 position, normal, color;
};

/// All triangles of the scene in one draw call, as one would write it down.
class Bare {
 public:
  Bare(const Scene& scene, int resolution)
      : flat_(linked(kFlatVertex, kFlatFragment)), lit_(linked(kLitVertex, kLitFragment)), resolution_(resolution) {
    std::vector<BareVertex> vertices;
    std::vector<std::uint32_t> indices;
    for (const Mesh& mesh : scene.meshes) {
      for (const std::uint32_t i : mesh.triangles) indices.push_back(std::uint32_t(vertices.size()) + i);
      const glm::vec3 color(scene.materials[std::size_t(mesh.material)].base_color);
      for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        vertices.push_back({mesh.positions[i], mesh.normals.empty() ? glm::vec3(0.0f, 1.0f, 0.0f) : mesh.normals[i], color});
    }
    count_ = GLsizei(indices.size());
    glBindVertexArray(array_.get());
    glBindBuffer(GL_ARRAY_BUFFER, vertices_.get());
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(vertices.size() * sizeof(BareVertex)), vertices.data(), GL_STATIC_DRAW);
    const gl::Attribute attributes[] = {
        {0, 3, offsetof(BareVertex, position)}, {1, 3, offsetof(BareVertex, normal)}, {2, 3, offsetof(BareVertex, color)}};
    gl::declare_attributes(sizeof(BareVertex), attributes);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.get());
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(indices.size() * sizeof(std::uint32_t)), indices.data(), GL_STATIC_DRAW);
    glBindVertexArray(0);
    glBindTexture(GL_TEXTURE_2D, map_.get());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, resolution, resolution, 0, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glBindFramebuffer(GL_FRAMEBUFFER, map_framebuffer_.get());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, map_.get(), 0);
    const GLenum none = GL_NONE;
    glDrawBuffers(1, &none);
    multisample_.reserve(kSize);
    for (gl::ViewTarget& view : views_) view.resize(kSize);
  }
  ~Bare() {
    glDeleteProgram(flat_);
    glDeleteProgram(lit_);
  }

  void draw(const Analysis& analysis, const std::array<ViewPicture, 4>& pictures, bool lit) {
    glEnable(GL_DEPTH_TEST);
    glBindFramebuffer(GL_FRAMEBUFFER, map_framebuffer_.get());
    glViewport(0, 0, resolution_, resolution_);
    glClear(GL_DEPTH_BUFFER_BIT);
    triangles(flat_, *analysis.map_from_world);
    if (lit) set_light(analysis);
    for (std::size_t i = 0; i < pictures.size(); ++i) {
      glBindFramebuffer(GL_FRAMEBUFFER, multisample_.framebuffer());
      glViewport(0, 0, kSize.x, kSize.y);
      glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
      if (pictures[i].scene != ScenePicture::map_depth) triangles(lit ? lit_ : flat_, pictures[i].clip_from_world);
      views_[i].resolve_from(multisample_, {0, 0, kSize.x, kSize.y});
    }
  }

 private:
  void set_light(const Analysis& analysis) const {
    const auto map = gl::narrow(*analysis.map_from_world);
    if (!map) return;
    const glm::vec4 light(analysis.light);
    glUseProgram(lit_);
    glUniformMatrix4fv(glGetUniformLocation(lit_, "map"), 1, GL_FALSE, &(*map)[0][0]);
    glUniform4fv(glGetUniformLocation(lit_, "light"), 1, &light.x);
    glBindTexture(GL_TEXTURE_2D, map_.get());
  }

  void triangles(GLuint program, const glm::dmat4& clip_from_world) const {
    const auto matrix = gl::narrow(clip_from_world);
    if (!matrix) return;
    glUseProgram(program);
    glUniformMatrix4fv(glGetUniformLocation(program, "m"), 1, GL_FALSE, &(*matrix)[0][0]);
    glBindVertexArray(array_.get());
    glDrawElements(GL_TRIANGLES, count_, GL_UNSIGNED_INT, nullptr);
  }

  GLuint flat_, lit_;
  int resolution_;
  GLsizei count_ = 0;
  gl::VertexArray array_;
  gl::Buffer vertices_, indices_;
  gl::GlTexture map_;
  gl::Framebuffer map_framebuffer_;
  gl::MultisampleTarget multisample_;
  std::array<gl::ViewTarget, 4> views_;
};

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + std::ptrdiff_t(values.size() / 2), values.end());
  return values[values.size() / 2];
}

/// Milliseconds by the wall clock of each part, one entry an iteration.
using Times = std::array<std::vector<double>, 9>;
constexpr std::array<const char*, 9> kParts{"map", "world", "cube", "mapview", "eye", "frame", "bare", "bare_lit", "own"};

std::array<ViewPicture, 4> described(const Analysis& analysis) {
  std::array<ViewPicture, 4> pictures;
  for (ViewId id : kMainViews) pictures[std::size_t(id)] = describe_view(id, analysis, kSize);
  return pictures;
}

double frame(Renderer& renderer, const Analysis& analysis, const PassTimer& timer) {
  return timer
             .time([&] {
               renderer.draw_shadow_map(analysis);
               for (ViewId id : kMainViews)
                 renderer.draw_view(describe_view(id, analysis, kSize), analysis, kSize, 1.0, Theme::light);
             })
             .wall *
         1e3;
}

/// The same with nothing over the scenes: no lines, bodies, symbols, labels.
double shaded(Renderer& renderer, const Analysis& analysis, std::array<ViewPicture, 4> pictures, const PassTimer& timer) {
  for (ViewPicture& picture : pictures) picture.list = {}, picture.legend = {}, picture.title.clear();
  return timer
             .time([&] {
               renderer.draw_shadow_map(analysis);
               for (const ViewPicture& picture : pictures) renderer.draw_view(picture, analysis, kSize, 1.0, Theme::light);
             })
             .wall *
         1e3;
}

/// Each part by itself, waited for: more than their share of a frame in which they overlap.
void time_parts(Renderer& renderer, const Analysis& analysis, const PassTimer& timer, Times& times) {
  times[0].push_back(timer.time([&] { renderer.draw_shadow_map(analysis); }).wall * 1e3);
  for (ViewId id : kMainViews) {
    const auto view = [&] { renderer.draw_view(describe_view(id, analysis, kSize), analysis, kSize, 1.0, Theme::light); };
    times[1 + std::size_t(id)].push_back(timer.time(view).wall * 1e3);
  }
}

void four_views(benchmark::State& state, const std::string& id) {
  const Scene scene = *builtin_scene(id);
  Experiment x;
  if (scene.camera) x.camera = *scene.camera;
  if (scene.light) x.light = *scene.light;
  const Analysis analysis = analyze(x, scene);
  if (!analysis.map_from_world) return state.SkipWithError("needs six maps");
  Renderer renderer(assets_folder(), font_file());
  renderer.set_scene(scene);
  Bare bare(scene, x.shadow.resolution);
  const PassTimer timer;
  const auto pictures = described(analysis);
  frame(renderer, analysis, timer);  // shaders compile, glyphs are drawn
  Times times;
  for (auto _ : state) {
    times[5].push_back(frame(renderer, analysis, timer));
    gl::reset_state();
    times[6].push_back(timer.time([&] { bare.draw(analysis, pictures, false); }).wall * 1e3);
    gl::reset_state();
    times[7].push_back(timer.time([&] { bare.draw(analysis, pictures, true); }).wall * 1e3);
    gl::reset_state();
    times[8].push_back(shaded(renderer, analysis, pictures, timer));
    time_parts(renderer, analysis, timer, times);
    state.SetIterationTime(times[5].back() * 1e-3);
  }
  for (std::size_t i = 0; i < kParts.size(); ++i) state.counters[kParts[i]] = median(times[i]);
  state.counters["ratio"] = median(times[5]) / median(times[6]);
  state.counters["ratio_lit"] = median(times[5]) / median(times[7]);
  state.counters["ratio_own"] = median(times[5]) / median(times[8]);
}

}  // namespace
}  // namespace psm

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  const auto context = psm::HeadlessContext::create();
  if (!context) psm::gl::fail(context.error().text);
  benchmark::AddCustomContext("renderer", psm::gl_renderer_name());
  for (const std::string& id : psm::builtin_scene_ids())
    benchmark::RegisterBenchmark(id.c_str(), [id](benchmark::State& state) { psm::four_views(state, id); })
        ->Iterations(psm::kIterations)
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
