// SPDX-License-Identifier: GPL-3.0-or-later
// The scene's depth for what is drawn over it: farther by a line's width of the surface's slope, so that lines on a surface keep
// both halves of their width. Of the two differences along each axis the smaller one counts: the other may cross a silhouette.
uniform sampler2D u_depth;
uniform ivec2 u_first_pixel, u_last_pixel;  // of the scene; around it nothing hides anything

const float kPushBack = 2.0;            // pixels of slope; half a pixel of it since a sample is not at its pixel's centre
const float kStep = 1.0 / 16777216.0;  // of a 24-bit depth

float depth_at(ivec2 pixel) { return texelFetch(u_depth, clamp(pixel, u_first_pixel, u_last_pixel), 0).r; }

// Of the two neighbours along an axis, the card's derivative knows the one that shares this pixel's block of 2 x 2.
float overlay_depth() {
  ivec2 pixel = ivec2(gl_FragCoord.xy), other = 2 * (pixel & 1) - 1;
  float here = depth_at(pixel);
  float along_x = min(abs(dFdx(here)), abs(depth_at(pixel + ivec2(other.x, 0)) - here));
  float along_y = min(abs(dFdy(here)), abs(depth_at(pixel + ivec2(0, other.y)) - here));
  bool outside = any(lessThan(pixel, u_first_pixel)) || any(greaterThan(pixel, u_last_pixel));
  return outside ? 1.0 : min(here + kPushBack * max(along_x, along_y) + kStep, 1.0);
}
