// Everything solid: ships, land, marks. Colour by vertex; its alpha below 1 means it glows at night.
in vec4 vertex;
in vec3 normal;
in vec4 colour;

uniform mat4 u_world;
uniform mat4 u_viewProjection;

out vec3 v_position;
out vec3 v_normal;
out vec4 v_colour;

void main() {
    vec4 p = overTheHorizon(u_world * vertex);
    v_position = p.xyz;
    v_normal = mat3(u_world) * normal;
    v_colour = colour;
    gl_Position = u_viewProjection * p;
}
