in float v_strength;
out vec4 o_colour;

void main() {
    o_colour = vec4(u_horizon.rgb * 1.1, 0.38 * v_strength);
}
