in vec3 v_position;
in vec4 v_water;
in vec4 v_air;

uniform sampler2D u_surface0;
uniform sampler2D u_surface1;
uniform sampler2D u_surface2;
uniform vec4 u_tile0;
uniform vec4 u_tile1;
uniform vec4 u_tile2;
uniform vec4 u_slopeScale;         // of the three tiles
uniform vec4 u_accelerationScale;  // of the three tiles
uniform vec4 u_foam;               // x: acceleration at which crests break, y: width of the change
uniform vec4 u_light;              // x: haze in what is reflected, y: daylight
uniform vec4 u_deepWater;
uniform vec4 u_shallowWater;

out vec4 o_colour;

void main() {
    vec2 en = vec2(v_position.x, -v_position.z);
    vec3 d = normalize(v_position);

    vec4 a = texture(u_surface0, u_tile0.xy + en * u_tile0.z);
    vec4 b = texture(u_surface1, u_tile1.xy + en * u_tile1.z);
    vec2 slope = (a.rg * 2.0 - 1.0) * u_slopeScale.x + (b.rg * 2.0 - 1.0) * u_slopeScale.y;
    float mean2 = a.a * u_slopeScale.x * u_slopeScale.x + b.a * u_slopeScale.y * u_slopeScale.y;
    float breaking = (a.b * 2.0 - 1.0) * u_accelerationScale.x + (b.b * 2.0 - 1.0) * u_accelerationScale.y;
#ifdef SHORT_WAVES
    vec4 c = texture(u_surface2, u_tile2.xy + en * u_tile2.z);
    slope += (c.rg * 2.0 - 1.0) * u_slopeScale.z;
    mean2 += c.a * u_slopeScale.z * u_slopeScale.z;
#else
    vec4 c = vec4(0.5);
    mean2 += 0.5 * u_slopeScale.z * u_slopeScale.z;
#endif
    slope *= v_water.x;
    // Roughness that the mipmaps have averaged away.
    float hidden = max(mean2 * v_water.x * v_water.x - dot(slope, slope), 0.0008);
    vec3 n = normalize(vec3(-slope.y, 1.0, slope.x));

    // Facets that lean away from the eye are not seen: the rough sea far off looks steeper than it is.
    float facing = max(dot(n, -d), 0.02);
    float rough = sqrt(hidden);
    float f = facing + 0.45 * rough * (1.0 - facing);
    float away = 1.0 - min(f, 1.0);
    float away2 = away * away;
    float fresnel = 0.02 + 0.98 * away2 * away2 * away / (1.0 + 6.0 * rough);

    vec3 r = reflect(d, n);
    r.y = abs(r.y) + 0.35 * rough;
    vec3 sky = mirroredSky(r, u_light.x);

    // Sun or moon on the facets: a distribution of slopes with long tails.
    vec3 h = u_lamp.xyz - d;
    float m2 = 2.0 * hidden + 0.0015;
    vec2 off = h.xz / max(h.y, 0.04) - n.xz / n.y;
    float q = 1.0 + 0.5 * dot(off, off) / m2;
    q *= q;
    float glint = 1.0 / (q * q * (m2 * 14.0 + 0.02));
    vec3 shine = u_lampColour.rgb * (min(glint, 3.5) * (0.15 + 0.85 * fresnel));

    float daylight = u_light.y;
    float shallow = max(0.0, 1.0 - v_water.y * 4.0);
    shallow *= shallow * shallow;
    vec3 body = mix(u_deepWater.rgb, u_shallowWater.rgb, shallow) * daylight * 1.5;
    // Light through the crests.
    body += u_shallowWater.rgb * daylight * 0.35 * clamp(v_water.z * 0.35, 0.0, 0.5);

    vec3 colour = mix(body, sky, clamp(fresnel, 0.0, 1.0)) + shine;
#ifdef FOAM
    float low = -breaking * v_water.x * v_water.x;
    float amount = smoothstep(u_foam.x, u_foam.x + u_foam.y, low);
    // Torn by the shorter waves: streaks and holes behind the crest, whole only where it breaks hardest.
    float torn = 0.5 + 1.3 * (c.r + c.g + c.b - 1.5) + 0.9 * (b.r + b.g - 1.0);
    float foam = amount * smoothstep(0.68 - 0.5 * amount, 1.2 - 0.6 * amount, torn);
    colour = mix(colour, (u_sky.rgb * 1.25 + u_sunColour.rgb * (0.2 + 0.5 * max(u_sun.y, 0.0))) * 0.85, foam * 0.85);
#endif
    o_colour = vec4(colour * v_air.a + v_air.rgb, 1.0);
}
