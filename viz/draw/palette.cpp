// SPDX-License-Identifier: GPL-3.0-or-later
// The one palette: Okabe and Ito's colours, which stay apart for the common kinds of colour blindness.
#include <array>

#include "draw/draw_list.h"

namespace psm {
namespace {

struct RoleColors {
  Role role;
  const char* name;
  unsigned fill, line, text;  // 0xRRGGBB
};

// The map's window shares the texel grid's hue, darker: it is that grid's border.
constexpr std::array<RoleColors, 21> palette{{
    {Role::frustum, "frustum", 0x0072B2, 0x0072B2, 0x004E7C},
    {Role::light, "light", 0xE69F00, 0xC28100, 0x7A5100},
    {Role::caster_body, "caster_body", 0xF0E442, 0x8F8500, 0x645D00},
    {Role::receivers_body, "receivers_body", 0x56B4E9, 0x2F8FC6, 0x1F5F86},
    {Role::vanishing_plane, "vanishing_plane", 0xCC79A7, 0xBF6597, 0x8F3F6B},
    {Role::map_window, "map_window", 0x00694C, 0x00694C, 0x005A41},
    {Role::infinity, "infinity", 0xD55E00, 0xD55E00, 0x9A4400},
    {Role::texel_grid, "texel_grid", 0x009E73, 0x009E73, 0x006048},
    {Role::scene_bounds, "scene_bounds", 0x8A8A8A, 0x767676, 0x555555},
    {Role::light_point, "light_point", 0x6FBF9B, 0x2E8562, 0x1F6247},
    {Role::light_inverted, "light_inverted", 0xA58BC8, 0x7D5FA8, 0x5E4487},
    {Role::curve_uniform, "curve_uniform", 0x333333, 0x333333, 0x333333},
    {Role::curve_lispsm, "curve_lispsm", 0xC65A11, 0xB85000, 0x8F3F00},
    {Role::curve_lispsm_reference, "curve_lispsm_reference", 0xD88A55, 0xC06A2A, 0x94501C},
    {Role::curve_glpr, "curve_glpr", 0xB06A9A, 0x9A4F84, 0x7A3A68},
    {Role::curve_gmnpr, "curve_gmnpr", 0x0A6FB0, 0x0A66A6, 0x074C7C},
    {Role::curve_gmnpr_eq4, "curve_gmnpr_eq4", 0x5E9CCB, 0x3F84B8, 0x285F88},
    {Role::curve_minimax, "curve_minimax", 0x0B9A72, 0x078A64, 0x05664A},
    {Role::curve_minimax_frustum, "curve_minimax_frustum", 0x55B89A, 0x2C9478, 0x1B6B56},
    {Role::neutral, "neutral", 0x999999, 0x6B6B6B, 0x4A4A4A},
    {Role::text, "text", 0x222222, 0x222222, 0x222222},
}};

const RoleColors& colors_of(Role role) { return palette[static_cast<std::size_t>(role)]; }

constexpr bool palette_in_role_order() {
  for (std::size_t i = 0; i < palette.size(); ++i) {
    if (static_cast<std::size_t>(palette[i].role) != i) return false;
  }
  return true;
}
static_assert(palette_in_role_order());

glm::vec3 rgb(unsigned hex) { return glm::vec3((hex >> 16) & 255, (hex >> 8) & 255, hex & 255) / 255.0f; }

}  // namespace

const char* name_of(Role role) { return colors_of(role).name; }

std::optional<Role> role_from_name(const std::string& name) {
  for (const RoleColors& colors : palette)
    if (name == colors.name) return colors.role;
  return std::nullopt;
}

glm::vec3 role_color(Role role) { return rgb(colors_of(role).fill); }
glm::vec3 role_line_color(Role role) { return rgb(colors_of(role).line); }
glm::vec3 role_text_color(Role role) { return rgb(colors_of(role).text); }

}  // namespace psm
