// SPDX-License-Identifier: GPL-3.0-or-later
layout(location = 0) in vec4 a_clip;
layout(location = 1) in vec2 a_map;
uniform highp usampler2D u_blocks;  // from depth_blocks.frag
out vec2 v_map;
flat out vec2 v_depth_range;  // in use; (0, 1) where nothing is

const int kBlocks = 16;

void main() {
  gl_Position = a_clip;
  v_map = a_map;
  vec2 range = vec2(1.0, 0.0);
  for (int i = 0; i < kBlocks * kBlocks; ++i) {
    uvec2 bits = texelFetch(u_blocks, ivec2(i % kBlocks, i / kBlocks), 0).rg;
    range = vec2(min(range.x, uintBitsToFloat(bits.r)), max(range.y, uintBitsToFloat(bits.g)));
  }
  v_depth_range = range.x <= range.y ? range : vec2(0.0, 1.0);
}
