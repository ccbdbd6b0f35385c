// SPDX-License-Identifier: GPL-3.0-or-later
// MAPS: how many shadow maps there are; not defined without any.
layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
layout(location = 2) in vec2 a_texcoord;
layout(location = 3) in vec4 a_color;
uniform mat4 u_clip_from_local;
uniform float u_sign;  // -1: the other side of w = 0
uniform float u_point_size;
out vec3 v_position;
out vec3 v_normal;
out vec2 v_texcoord;
out vec4 v_color;
#ifdef MAPS
uniform mat4 u_map_from_local[MAPS];
out vec4 v_in_map[MAPS];
#endif

invariant gl_Position;  // the same in all programs: what is drawn over a surface meets its depth

void main() {
  gl_Position = u_sign * (u_clip_from_local * vec4(a_position, 1.0));
  gl_PointSize = u_point_size;
  v_position = a_position;
  v_normal = a_normal;
  v_texcoord = a_texcoord;
  v_color = a_color;
#ifdef MAPS
  for (int i = 0; i < MAPS; ++i) v_in_map[i] = u_map_from_local[i] * vec4(a_position, 1.0);
#endif
}
