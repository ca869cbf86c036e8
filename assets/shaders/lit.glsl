/// A surface in the light and air of the moment. `colour` in white light; `glow`: what it gives by itself at night;
/// `position` from the eye. Normals may point either way.
vec4 lit(vec3 colour, float glow, vec3 position, vec3 normal) {
    vec3 n = normalize(normal);
    float distance = length(position);
    vec3 d = position / distance;
    if (dot(n, d) > 0.0) n = -n;
    vec3 light = u_sky.rgb * (0.72 + 0.28 * n.y) + u_sunColour.rgb * max(dot(n, u_sun.xyz), 0.0) +
                 u_moonColour.rgb * max(dot(n, u_moon.xyz), 0.0);
    vec3 c = colour * light;
    c += glow * u_eye.w * vec3(1.0, 0.78, 0.45);
    return vec4(throughAir(c, d, distance), 1.0);
}
