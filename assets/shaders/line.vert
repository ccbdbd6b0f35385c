// SPDX-License-Identifier: GPL-3.0-or-later
layout(location = 0) in vec3 a_position;
layout(location = 1) in vec4 a_place;
layout(location = 2) in vec4 a_color;
layout(location = 3) in vec4 a_shape;
out vec4 v_place;
flat out vec4 v_color;
flat out vec4 v_shape;

void main() {
  gl_Position = vec4(a_position, 1.0);
  v_place = a_place;
  v_color = a_color;
  v_shape = a_shape;
}
