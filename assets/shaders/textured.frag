#include "lit.glsl"
in vec3 v_position;
in vec3 v_normal;
in vec4 v_colour;
in vec2 v_place;

uniform sampler2D u_texture;

out vec4 o_colour;

void main() {
    vec3 paint = texture(u_texture, v_place).rgb;
    o_colour = lit(v_colour.rgb * paint, 1.0 - v_colour.a, v_position, v_normal);
}
