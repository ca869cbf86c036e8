in vec3 v_direction;
in vec3 v_sky;
in vec4 v_air;
uniform sampler2D u_clouds;
out vec4 o_colour;

void main() {
    vec3 d = v_direction * inversesqrt(dot(v_direction, v_direction));
    float s = dot(d, u_sun.xyz);
    vec3 c = v_sky + (u_sunColour.rgb + u_glow.rgb) * smoothstep(0.99996, 0.999985, s) * (1.6 * (1.0 - smoothstep(0.55, 0.9, u_cloud.x)));
#ifdef CLOUDS
    // Cumulus on a flat ceiling.
    vec2 p = d.xz * (0.11 / (max(d.y, 0.0) + 0.035)) + u_cloud.yz;
    float n = texture(u_clouds, p).r;
    float edge = 1.02 - u_cloud.x;
    float cover = smoothstep(edge - 0.10, edge + 0.16, n);
    float thick = clamp((n - edge) * 2.5, 0.0, 1.0);
    float towards = max(s, 0.0);
    vec3 lit = u_sky.rgb * 1.25 + u_sunColour.rgb * (0.42 + 0.35 * towards * towards) + u_glow.rgb * (0.35 * towards) +
               u_moonColour.rgb * 0.5;
    vec3 shade = u_sky.rgb * 1.05 + u_sunColour.rgb * 0.10;
    vec3 cloud = min(mix(lit, shade, thick * 0.8), vec3(1.0));
    c = mix(c, cloud, cover * clamp((d.y - 0.012) * 8.0, 0.0, 0.92));
#endif
    o_colour = vec4(c * v_air.a + v_air.rgb, 1.0);
}
