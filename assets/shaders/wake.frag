in vec3 v_position;
in vec4 v_foam;

uniform sampler2D u_surface1;
uniform sampler2D u_surface2;
uniform vec4 u_tile1;
uniform vec4 u_tile2;

out vec4 o_colour;

void main() {
    vec2 en = vec2(v_position.x, -v_position.z);
    float distance = length(v_position);
    vec3 d = v_position / distance;
    // Patches drift with the short waves; edges fray.
    float patches = texture(u_surface2, u_tile2.xy + en * u_tile2.z).r * 0.6 +
                    texture(u_surface1, u_tile1.xy + en * u_tile1.z * 3.0).g * 0.6;
    float edge = 1.0 - smoothstep(0.35, 1.0, abs(v_foam.x));
    float foam = v_foam.z * edge * smoothstep(0.62 - 0.45 * v_foam.z, 0.95 - 0.3 * v_foam.z, patches + 0.15 * edge);
    vec3 white = (u_sky.rgb * 1.2 + u_sunColour.rgb * (0.2 + 0.5 * max(u_sun.y, 0.0)) + u_moonColour.rgb) * 0.92;
    o_colour = vec4(throughAir(white, d, distance), clamp(foam, 0.0, 0.9));
}
