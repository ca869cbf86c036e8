in vec2 v_corner;
out vec4 o_colour;

void main() {
    // A ball lit by the sun.
    vec3 right = normalize(cross(vec3(0.0, 1.0, 0.0), u_moon.xyz));
    vec3 up = cross(u_moon.xyz, right);
    float r2 = dot(v_corner, v_corner);
    if (r2 > 1.0) discard;
    vec3 n = v_corner.x * right + v_corner.y * up - sqrt(1.0 - r2) * u_moon.xyz;
    float lit = smoothstep(-0.05, 0.15, dot(n, u_sun.xyz)) * (1.0 - smoothstep(0.85, 1.0, r2));
    float clear = (1.0 - smoothstep(0.55, 0.9, u_cloud.x)) * exp(-300.0 * u_horizon.w / max(u_moon.y, 0.003));
    o_colour = vec4(vec3(0.95, 0.93, 0.86) * lit * clear * (0.25 + 0.75 * u_eye.w), 1.0);
}
