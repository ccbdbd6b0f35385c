// SPDX-License-Identifier: GPL-3.0-or-later
in vec2 v_atlas;
flat in vec4 v_color;
uniform sampler2D u_atlas;
out vec4 o_color;

void main() { o_color = vec4(v_color.rgb, v_color.a * texture(u_atlas, v_atlas).r); }
