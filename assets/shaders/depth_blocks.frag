// SPDX-License-Identifier: GPL-3.0-or-later
// The range of depths in each block of texels that holds a caster, as bits; a block of one texel gives its depth.
uniform sampler2DArray u_map;
uniform int u_layer;
uniform int u_block;
out uvec4 o_bits;

void main() {
  int side = textureSize(u_map, 0).x;
  ivec2 first = ivec2(gl_FragCoord.xy) * u_block;
  ivec2 last = min(first + u_block, ivec2(side));
  vec2 range = u_block == 1 ? vec2(texelFetch(u_map, ivec3(first, u_layer), 0).r) : vec2(1.0, 0.0);
  for (int y = first.y; y < last.y; ++y) {
    for (int x = first.x; x < last.x; ++x) {
      float depth = texelFetch(u_map, ivec3(x, y, u_layer), 0).r;
      if (depth < 1.0) range = vec2(min(range.x, depth), max(range.y, depth));
    }
  }
  o_bits = uvec4(floatBitsToUint(range.x), floatBitsToUint(range.y), 0u, 0u);
}
