in vec3 v_colour;
in vec2 v_corner;
uniform vec4 u_brightness;
out vec4 o_colour;

void main() {
    float r2 = dot(v_corner, v_corner);
    float core = exp(-6.0 * r2);
    o_colour = vec4(v_colour * core * u_brightness.x, 1.0);
}
