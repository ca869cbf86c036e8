// What closes a low hull at its rail: only its depth is drawn, so that the sea is not seen inside.
in vec4 vertex;
uniform mat4 u_world;
uniform mat4 u_viewProjection;

void main() { gl_Position = u_viewProjection * overTheHorizon(u_world * vertex); }
