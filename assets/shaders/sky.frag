in vec3 v_direction;
uniform sampler2D u_clouds;
out vec4 o_colour;

#ifdef CLOUDS
/// Cumulus on a flat ceiling; cover and thickness from two looks at the same noise.
vec3 withClouds(vec3 sky, vec3 d) {
    if (d.y < 0.012) return sky;
    vec2 p = d.xz * (0.11 / (d.y + 0.035)) + u_cloud.yz;
    float a = texture(u_clouds, p).r;
    float b = texture(u_clouds, p * 2.7 + vec2(0.31, 0.17)).r;
    float n = 0.68 * a + 0.32 * b;
    float edge = 1.02 - u_cloud.x;
    float cover = smoothstep(edge - 0.10, edge + 0.16, n);
    float thick = smoothstep(edge, edge + 0.4, n);
    float towards = max(dot(d, u_sun.xyz), 0.0);
    vec3 lit = u_sky.rgb * 1.25 + u_sunColour.rgb * (0.42 + 0.35 * towards * towards) + u_glow.rgb * 0.35 * towards +
               u_moonColour.rgb * 0.5;
    vec3 shade = u_sky.rgb * 1.05 + u_sunColour.rgb * 0.10;
    vec3 cloud = min(mix(lit, shade, thick * 0.8), vec3(1.0));
    return mix(sky, cloud, cover * smoothstep(0.012, 0.13, d.y) * 0.92);
}
#endif

void main() {
    vec3 d = normalize(v_direction);
    vec3 c = skyColour(d);
    float s = dot(d, u_sun.xyz);
    float clear = 1.0 - smoothstep(0.55, 0.9, u_cloud.x);
    c += (u_sunColour.rgb + u_glow.rgb) * 1.6 * smoothstep(0.99996, 0.999985, s) * clear;
#ifdef CLOUDS
    c = withClouds(c, d);
#endif
    // Fog lies in the lowest 300 m, so straight up one looks through less of it.
    o_colour = vec4(throughAir(c, normalize(vec3(d.x, 0.0, d.z) + vec3(0.0, 1e-4, 0.0)), min(300.0 / max(d.y, 0.003), 1e5)), 1.0);
}
