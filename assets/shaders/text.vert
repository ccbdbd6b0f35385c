// SPDX-License-Identifier: GPL-3.0-or-later
layout(location = 0) in vec3 a_position;
layout(location = 1) in vec2 a_atlas;
layout(location = 2) in vec4 a_color;
out vec2 v_atlas;
flat out vec4 v_color;

void main() {
  gl_Position = vec4(a_position, 1.0);
  v_atlas = a_atlas;
  v_color = a_color;
}
