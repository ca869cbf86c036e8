// The moon: a square of its size in the sky, square to the line of sight.
in vec4 vertex;  // xy: corner, -1 to 1
uniform mat4 u_viewProjection;
out vec2 v_corner;

void main() {
    vec3 right = normalize(cross(vec3(0.0, 1.0, 0.0), u_moon.xyz));
    vec3 up = cross(u_moon.xyz, right);
    v_corner = vertex.xy;
    vec4 p = u_viewProjection * vec4(1000.0 * u_moon.xyz + 5.2 * (vertex.x * right + vertex.y * up), 1.0);
    gl_Position = vec4(p.xy, p.w * 0.9999998, p.w);  // before the sky, behind the rest
}
