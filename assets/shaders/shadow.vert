// SPDX-License-Identifier: GPL-3.0-or-later
layout(location = 0) in vec3 a_position;
layout(location = 2) in vec2 a_texcoord;
layout(location = 3) in vec4 a_color;
uniform mat4 u_map_from_local;

#ifdef MAY_DISCARD
out vec2 v_texcoord;
out float v_alpha;
#endif

invariant gl_Position;  // what has holes and what has none fit together

void main() {
  gl_Position = u_map_from_local * vec4(a_position, 1.0);
#ifdef MAY_DISCARD
  v_texcoord = a_texcoord;
  v_alpha = a_color.a;
#endif
}
