// Light and air of the moment and what follows from them. Put before every other file here, after #version and the
// preset's #defines. Axes: x east, y up, z south; the eye is the origin. Colours are as the screen gets them.

uniform vec4 u_sun;        // xyz: towards the sun
uniform vec4 u_sunColour;  // direct light
uniform vec4 u_sky;        // light from everywhere
uniform vec4 u_zenith;
uniform vec4 u_horizon;    // w: extinction of the air, 1/m
uniform vec4 u_glow;       // around the sun
uniform vec4 u_moon;       // xyz: towards the moon, w: share lit
uniform vec4 u_moonColour;
uniform vec4 u_lamp;       // xyz: towards the sun or, at night, the moon: what glitters on the water
uniform vec4 u_lampColour;
uniform vec4 u_eye;        // x: height of the eye, y: seconds (wrapped), z: curvature of the earth, w: night
uniform vec4 u_cloud;      // x: cover, yz: drift, w: rain

/// A point relative to the eye, lower by the curve of the earth.
vec4 overTheHorizon(vec4 p) {
    p.y -= dot(p.xz, p.xz) * u_eye.z;
    return p;
}

vec3 skyColour(vec3 d) {
    float low = 1.0 - clamp(d.y, 0.0, 1.0);
    float low2 = low * low;
    vec3 c = mix(u_zenith.rgb, u_horizon.rgb, low2 * low2 * low);
    float s = max(dot(d, u_sun.xyz), 0.0);
    float s2 = s * s;
    float s8 = s2 * s2 * s2 * s2;
    return c + u_glow.rgb * (0.25 * s2 * low2 + 0.5 * s8 + s8 * s8 * s8);
}

/// What a rough water mirrors of the sky: without the brightest around the sun, and towards the fog's colour by `haze`.
vec3 mirroredSky(vec3 d, float haze) {
    float low = 1.0 - clamp(d.y, 0.0, 1.0);
    float low2 = low * low;
    float s = max(dot(d, u_sun.xyz), 0.0);
    float s2 = s * s;
    float s4 = s2 * s2;
    vec3 c = mix(u_zenith.rgb, u_horizon.rgb, mix(low2 * low2 * low, 1.0, haze));
    return c + u_glow.rgb * (0.25 * s2 * mix(low2, 1.0, haze) + 0.5 * s4 * s4 * (1.0 - haze));
}

vec3 fogColour(vec3 d) {
    float s = max(dot(d, u_sun.xyz), 0.0);
    return u_horizon.rgb + u_glow.rgb * (0.25 * s * s);
}

/// `d`: unit vector from the eye.
vec3 throughAir(vec3 colour, vec3 d, float distance) {
    return mix(fogColour(d), colour, exp(-u_horizon.w * distance));
}
