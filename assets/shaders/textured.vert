// As solid, with a texture.
in vec4 vertex;
in vec3 normal;
in vec4 colour;
in vec2 uv0;

uniform mat4 u_world;
uniform mat4 u_viewProjection;

out vec3 v_position;
out vec3 v_normal;
out vec4 v_colour;
out vec2 v_place;

void main() {
    vec4 p = overTheHorizon(u_world * vertex);
    v_position = p.xyz;
    v_normal = mat3(u_world) * normal;
    v_colour = colour;
    v_place = uv0;
    gl_Position = u_viewProjection * p;
}
