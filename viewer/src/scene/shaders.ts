// SPDX-License-Identifier: BSD-3-Clause
// All geometry is made of places in textures: a vertex knows its node, its cell and its part, and fetches where it
// is and what it shows. A new frame thus costs one small texture and no vertex data.

const common = /* glsl */ `
precision highp float;
precision highp int;
precision highp usampler2D;
precision highp sampler2D;
`;

export const vertexShader = /* glsl */ `
${common}
in uvec4 items;  // node, cell, part, face
in vec2 life;    // first frame in which this is seen, first one in which it is not
uniform usampler2D positions;       // codes of the frame before
uniform usampler2D nextPositions;   // and of the one after
uniform float share;                // 0 is the frame before, 1 the one after
uniform vec3 codeStep;
uniform vec3 codeOrigin;
uniform float frame;
uniform sampler2D values;
uniform sampler2D parts;            // colour; alpha 0 is hidden
uniform bool valuesByNode;
uniform float depthShift;
uniform float pointSize;
out vec3 place;
out vec3 viewPlace;
out float value;
flat out vec4 partColour;
flat out uint face;

ivec2 texel(uint item, int width) {
  return ivec2(int(item) % width, int(item) / width);
}

vec3 decoded(usampler2D codes) {
  return (vec3(texelFetch(codes, texel(items.x, textureSize(codes, 0).x), 0).xyz) - 1.0) * codeStep;
}

void main() {
  place = codeOrigin + mix(decoded(positions), decoded(nextPositions), share);
  partColour = texelFetch(parts, texel(items.z, textureSize(parts, 0).x), 0);
  value = texelFetch(values, texel(valuesByNode ? items.x : items.y, textureSize(values, 0).x), 0).r;
  face = items.w;
  vec4 seen = modelViewMatrix * vec4(place, 1.0);
  viewPlace = seen.xyz;
  gl_Position = projectionMatrix * seen;
  gl_Position.z -= depthShift * gl_Position.w;
  gl_PointSize = pointSize;
  bool there = frame >= life.x && frame < life.y && partColour.a > 0.0;
  if (!there) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
}
`;

const fragmentHead = /* glsl */ `
${common}
in vec3 place;
in vec3 viewPlace;
in float value;
flat in vec4 partColour;
flat in uint face;
uniform vec4 section;  // cut away where the plane's distance is positive
out vec4 colour;
void cut() {
  if (dot(section.xyz, place) > section.w) discard;
}
`;

/** Faces and beams: colour of the part or of the fringe, lit from the viewer's shoulder. */
export const surfaceFragment = /* glsl */ `
${fragmentHead}
uniform bool fringed;
uniform vec2 range;
uniform sampler2D fringe;
uniform bool lit;
uniform vec3 noValue;
vec3 base() {
  if (!fringed) return partColour.rgb;
  if (value > 1e38) return noValue;
  float width = range.y - range.x;
  float x = width > 0.0 ? clamp((value - range.x) / width, 0.0, 1.0) : 0.0;
  return texture(fringe, vec2(x * 0.996 + 0.002, 0.5)).rgb;
}
void main() {
  cut();
  vec3 shade = base();
  if (lit) {
    vec3 normal = normalize(cross(dFdx(viewPlace), dFdy(viewPlace)));
    float key = abs(dot(normal, normalize(vec3(-0.35, 0.55, 0.76))));
    float front = abs(normal.z);
    shade *= 0.52 + 0.34 * key + 0.2 * front;
  }
  colour = vec4(shade, 1.0);
}
`;

/** Edges, the undeformed ghost, marks of what was picked. */
export const plainFragment = /* glsl */ `
${fragmentHead}
uniform vec4 tint;
uniform bool round;
void main() {
  cut();
  if (round && length(gl_PointCoord - 0.5) > 0.5) discard;
  colour = tint;
}
`;

/** The number of the face, from 1, in three bytes. */
export const pickFragment = /* glsl */ `
${fragmentHead}
void main() {
  cut();
  uint number = face + 1u;
  colour = vec4(float(number & 255u), float((number >> 8u) & 255u), float((number >> 16u) & 255u), 255.0) / 255.0;
}
`;
