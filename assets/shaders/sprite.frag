in vec3 v_colour;
in vec2 v_corner;
out vec4 o_colour;

void main() {
    float r2 = dot(v_corner, v_corner);
    float core = exp(-6.0 * r2);
    o_colour = vec4(v_colour * core + vec3(0.5) * max(max(v_colour.r, v_colour.g), v_colour.b) * exp(-22.0 * r2), 1.0);
}
