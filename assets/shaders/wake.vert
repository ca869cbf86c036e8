// Foam that ships leave on the water: ribbons laid on the sea.
#include "lift.glsl"
in vec4 vertex;  // relative to the eye; y unused
in vec2 uv0;     // x: across, -1 to 1; y: metres along
in vec2 uv1;     // x: strength, y: width in metres

uniform mat4 u_viewProjection;

out vec3 v_position;
out vec4 v_foam;

void main() {
    vec3 p = vertex.xyz;
    vec2 en = vec2(p.x, -p.z);
    float away = length(en);
    p.y = seaHeight(en, max(0.3, away * 0.02)) * waterAt(en).x + 0.06 - u_eye.x;
    vec4 q = overTheHorizon(vec4(p, 1.0));
    v_position = q.xyz;
    v_foam = vec4(uv0, uv1);
    gl_Position = u_viewProjection * q;
    // Nearer than the sea it lies on, whose net is another.
    gl_Position.z -= (0.0004 + 0.004 / (1.0 + away * 0.01)) * gl_Position.w * min(1.0, 30.0 / max(away, 1.0));
}
