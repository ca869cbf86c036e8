in vec3 v_position;
in vec4 v_colour;
in vec2 v_across;

out vec4 o_colour;

void main() {
    float distance = length(v_position);
    // Round: the middle looks up to the sky, the edges aside.
    float round = 1.0 - 0.35 * abs(v_across.x);
    vec3 light = u_sky.rgb * 0.85 * round + u_sunColour.rgb * (0.25 + 0.35 * max(u_sun.y, 0.0)) + u_moonColour.rgb * 0.4;
    float edge = clamp((1.0 - abs(v_across.x)) * v_across.y, 0.0, 1.0);
    o_colour = vec4(throughAir(v_colour.rgb * light, v_position / distance, distance), edge * v_colour.a);
}
