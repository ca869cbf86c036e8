// Height of the sea at a place seen from the eye, for every vertex that lies on it.

uniform sampler2D u_height0;
uniform sampler2D u_height1;
uniform sampler2D u_height2;
uniform sampler2D u_water;    // red: factor on the waves over 2, green: depth
uniform sampler2D u_waterNear;
uniform vec4 u_tile0;  // xy: place of the eye in the tile (east, north), z: 1 / tile, w: points of the finest mipmap / tile
uniform vec4 u_tile1;
uniform vec4 u_tile2;
uniform vec4 u_waterPlace;      // xy: place of the eye in the map, zw: 1 / size
uniform vec4 u_waterNearPlace;

float lift(sampler2D height, vec4 tile, vec2 p, float spacing) {
    // The mipmap whose points stand as far apart as the vertices; beyond it waves would only flicker.
    float level = log2(max(spacing * tile.w, 1.0));
    return textureLod(height, tile.xy + p * tile.z, level).r;
}

/// `en`: east and north of the eye. x: factor on the waves, y: depth.
vec2 waterAt(vec2 en) {
    vec2 near = u_waterNearPlace.xy + en * u_waterNearPlace.zw;
    vec2 water = all(greaterThan(near, vec2(0.01))) && all(lessThan(near, vec2(0.99)))
                     ? textureLod(u_waterNear, near, 0.0).rg
                     : textureLod(u_water, u_waterPlace.xy + en * u_waterPlace.zw, 0.0).rg;
    return vec2(2.0 * water.x, water.y);
}

/// Above still water, that factor not applied; `spacing`: between vertices.
float seaHeight(vec2 en, float spacing) {
    float h = lift(u_height0, u_tile0, en, spacing);
    if (spacing < 20.0) h += lift(u_height1, u_tile1, en, spacing);
    if (spacing < 1.5) h += lift(u_height2, u_tile2, en, spacing);
    return h;
}
