// A point of light: four corners at one place, moved apart on the screen.
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
    vec4 p = overTheHorizon(u_world * vertex);
    v_colour = colour.rgb;
    v_corner = uv0;
    vec4 q = u_viewProjection * p;
    q.xy += uv0 * uv1 * u_screen.xy * q.w;
    gl_Position = q;
}
