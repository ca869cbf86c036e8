in vec4 vertex;
uniform mat4 u_viewProjection;
out vec3 v_direction;
out vec3 v_sky;  // clear, and what the air adds before it
out vec4 v_air;  // colour of the air, and the share it leaves

void main() {
    vec3 d = vertex.xyz * 0.01;
    v_direction = d;
    v_sky = skyColour(d);
    // Fog lies in the lowest 300 m, so straight up one looks through less of it.
    float left = exp(-u_horizon.w * min(300.0 / max(d.y, 0.003), 1e5));
    v_air = vec4(fogColour(normalize(vec3(d.x, 1e-4, d.z))) * (1.0 - left), left);
    vec4 p = u_viewProjection * vertex;
    gl_Position = vec4(p.xy, p.w * 0.9999995, p.w);  // behind everything
}
