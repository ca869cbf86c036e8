in vec3 v_position;
in vec3 v_normal;
in vec4 v_colour;

out vec4 o_colour;

void main() {
    vec3 n = normalize(v_normal);
    float distance = length(v_position);
    vec3 d = v_position / distance;
    if (dot(n, d) > 0.0) n = -n;
    vec3 light = u_sky.rgb * (0.72 + 0.28 * n.y) + u_sunColour.rgb * max(dot(n, u_sun.xyz), 0.0) +
                 u_moonColour.rgb * max(dot(n, u_moon.xyz), 0.0);
    vec3 c = v_colour.rgb * light;
    c += (1.0 - v_colour.a) * u_eye.w * vec3(1.0, 0.78, 0.45);
    o_colour = vec4(throughAir(c, d, distance), 1.0);
}
