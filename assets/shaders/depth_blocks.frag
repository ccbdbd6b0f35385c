// SPDX-License-Identifier: GPL-3.0-or-later
// The range of depths in each block of texels that holds a caster, in all layers, as bits.
uniform sampler2DArray u_map;
uniform int u_step;  // every so many-th texel along both sides
out uvec2 o_bits;

const int kBlocks = 16;  // along a side, as in shadow_pass.cpp and map_depth.vert

void main() {
  ivec3 size = textureSize(u_map, 0);
  int block = (size.x + kBlocks - 1) / kBlocks;
  ivec2 first = ivec2(gl_FragCoord.xy) * block, last = min(first + block, size.xy);
  vec2 range = vec2(1.0, 0.0);
  for (int layer = 0; layer < size.z; ++layer) {
    for (int y = first.y; y < last.y; y += u_step) {
      for (int x = first.x; x < last.x; x += u_step) {
        float depth = texelFetch(u_map, ivec3(x, y, layer), 0).r;
        if (depth < 1.0) range = vec2(min(range.x, depth), max(range.y, depth));
      }
    }
  }
  o_bits = uvec2(floatBitsToUint(range.x), floatBitsToUint(range.y));
}
