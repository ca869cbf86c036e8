#include "lit.glsl"
in vec3 v_position;
in vec3 v_normal;
in vec4 v_colour;

out vec4 o_colour;

void main() { o_colour = lit(v_colour.rgb, 1.0 - v_colour.a, v_position, v_normal); }
