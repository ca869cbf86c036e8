// A star: as a point of light, infinitely far; hidden below the horizon by what is drawn before.
in vec4 vertex;
in vec4 colour;
in vec2 uv0;  // corner
in vec2 uv1;  // size in pixels

uniform mat4 u_world;
uniform mat4 u_viewProjection;
uniform vec4 u_screen;  // xy: 2 / size in pixels

out vec3 v_colour;
out vec2 v_corner;

void main() {
    vec4 p = u_world * vertex;
    v_colour = colour.rgb;
    v_corner = uv0;
    vec4 q = u_viewProjection * p;
    q.xy += uv0 * uv1 * u_screen.xy * q.w;
    q.z = q.w * 0.9999999;
    gl_Position = q;
}
