// SPDX-License-Identifier: GPL-3.0-or-later
// A picture over the scene.
in vec2 v_map;
uniform sampler2D u_cover;
out vec4 o_color;

void main() { o_color = texture(u_cover, vec2(v_map.x, 1.0 - v_map.y)); }
