// Mooring lines and cables: ribbons already turned to the eye and at least about a pixel broad.
in vec4 vertex;
in vec4 colour;  // w: share of a pixel the rope covers where it is thinner than one
in vec2 uv0;     // x: across, -1 to 1; y: half its breadth in pixels

uniform mat4 u_world;
uniform mat4 u_viewProjection;

out vec3 v_position;
out vec4 v_colour;
out vec2 v_across;

void main() {
    vec4 p = overTheHorizon(u_world * vertex);
    v_position = p.xyz;
    v_colour = colour;
    v_across = uv0;
    gl_Position = u_viewProjection * p;
}
