// The sea: a polar grid about the eye, lifted by the three tiles of core's waves.
#include "lift.glsl"
in vec4 vertex;   // xz: unit direction; y unused
in vec2 uv0;      // x: distance from the eye, y: distance to the next ring

uniform mat4 u_world;  // turns the sector
uniform mat4 u_viewProjection;
uniform vec4 u_grid;  // x: factor on distances

out vec3 v_position;
out vec4 v_water;  // x: factor on the waves, y: depth, z: height above still water
out vec4 v_air;    // what the air adds, and the share it leaves: the net is fine enough on the screen

void main() {
    vec3 direction = mat3(u_world) * vertex.xyz;
    float r = uv0.x * u_grid.x;
    vec3 p = direction * r;
    vec2 en = vec2(p.x, -p.z);
    vec2 water = waterAt(en);
    float h = seaHeight(en, uv0.y * u_grid.x * 0.5) * water.x;
    p.y = h - u_eye.x;
    vec4 q = overTheHorizon(vec4(p, 1.0));
    v_position = q.xyz;
    v_water = vec4(water, h, r);
    float left = exp(-u_horizon.w * length(q.xyz));
    v_air = vec4(fogColour(normalize(q.xyz)) * (1.0 - left), left);
    gl_Position = u_viewProjection * q;
}
