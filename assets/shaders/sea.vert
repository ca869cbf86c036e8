// The sea: a polar grid about the eye, lifted by the three tiles of core's waves.
in vec4 vertex;   // xz: unit direction; y unused
in vec2 uv0;      // x: distance from the eye, y: distance to the next ring

uniform mat4 u_world;  // turns the sector
uniform mat4 u_viewProjection;
uniform sampler2D u_height0;
uniform sampler2D u_height1;
uniform sampler2D u_height2;
uniform sampler2D u_water;    // red: shelter factor, green: depth
uniform sampler2D u_waterNear;
uniform vec4 u_tile0;  // xy: place of the eye in the tile (east, north), z: 1 / tile, w: points of the finest mipmap / tile
uniform vec4 u_tile1;
uniform vec4 u_tile2;
uniform vec4 u_waterPlace;      // xy: place of the eye in the map, zw: 1 / size
uniform vec4 u_waterNearPlace;
uniform vec4 u_grid;  // x: factor on distances

out vec3 v_position;
out vec4 v_water;  // x: shelter, y: depth, z: height above still water

float lift(sampler2D height, vec4 tile, vec2 p, float spacing) {
    // The mipmap whose points stand as far apart as the vertices; beyond it waves would only flicker.
    float level = log2(max(spacing * tile.w, 1.0));
    return textureLod(height, tile.xy + p * tile.z, level).r;
}

void main() {
    vec3 direction = mat3(u_world) * vertex.xyz;
    float r = uv0.x * u_grid.x;
    vec3 p = direction * r;
    vec2 en = vec2(p.x, -p.z);
    vec2 near = u_waterNearPlace.xy + en * u_waterNearPlace.zw;
    vec2 water = all(greaterThan(near, vec2(0.01))) && all(lessThan(near, vec2(0.99)))
                     ? textureLod(u_waterNear, near, 0.0).rg
                     : textureLod(u_water, u_waterPlace.xy + en * u_waterPlace.zw, 0.0).rg;
    float spacing = uv0.y * u_grid.x * 0.5;
    float h = lift(u_height0, u_tile0, en, spacing);
    if (spacing < 20.0) h += lift(u_height1, u_tile1, en, spacing);
    if (spacing < 1.5) h += lift(u_height2, u_tile2, en, spacing);
    h *= water.r;
    p.y = h - u_eye.x;
    vec4 q = overTheHorizon(vec4(p, 1.0));
    v_position = q.xyz;
    v_water = vec4(water, h, r);
    gl_Position = u_viewProjection * q;
}
