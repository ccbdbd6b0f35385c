// SPDX-License-Identifier: GPL-3.0-or-later
layout(location = 0) in vec3 a_position;
layout(location = 1) in vec4 a_box;
layout(location = 2) in vec4 a_fill;
layout(location = 3) in vec4 a_outline;
layout(location = 4) in vec2 a_shape;
flat out vec4 v_box;
flat out vec4 v_fill;
flat out vec4 v_outline;
flat out vec2 v_shape;

void main() {
  gl_Position = vec4(a_position, 1.0);
  v_box = a_box;
  v_fill = a_fill;
  v_outline = a_outline;
  v_shape = a_shape;
}
