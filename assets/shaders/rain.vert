// Rain: streaks in a box about the eye through which they fall for ever.
in vec4 vertex;  // 0 to 1 in the box; one end of a streak and the other share it
in vec2 uv0;     // x: side, -1 or 1; y: 0 lower end, 1 upper end

uniform mat4 u_viewProjection;
uniform vec4 u_place;   // xyz: where the eye is in the box
uniform vec4 u_screen;  // xy: 2 / size in pixels

out float v_strength;

const float kBox = 24.0;

void main() {
    vec3 p = (fract(vertex.xyz - u_place.xyz) - 0.5) * kBox;
    float away = length(p);
    p.y += uv0.y * 0.55;
    p.xz += uv0.y * vec2(0.05, 0.03);
    vec4 q = u_viewProjection * vec4(p, 1.0);
    q.x += uv0.x * 0.55 * u_screen.x * q.w;
    v_strength = u_cloud.w * clamp(1.3 - away / 11.0, 0.0, 1.0) * smoothstep(1.0, 2.5, away);
    gl_Position = q;
}
