in vec4 vertex;
uniform mat4 u_viewProjection;
out vec3 v_direction;

void main() {
    v_direction = vertex.xyz;
    vec4 p = u_viewProjection * vertex;
    gl_Position = vec4(p.xy, p.w * 0.9999995, p.w);  // behind everything
}
