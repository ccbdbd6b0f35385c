// SPDX-License-Identifier: GPL-3.0-or-later
layout(location = 0) in vec4 a_position;
layout(location = 1) in vec4 a_color;
flat out vec4 v_color;

void main() {
  gl_Position = a_position;
  v_color = a_color;
}
