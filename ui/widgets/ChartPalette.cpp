#include "ui/widgets/ChartPalette.h"

namespace sagara::ui {
namespace {

QColor rgb(unsigned value) { return QColor::fromRgb(value); }
QColor see(unsigned value, int alpha) {
    QColor colour = rgb(value);
    colour.setAlpha(alpha);
    return colour;
}

ChartPalette day() {
    ChartPalette p;
    p.noDepths = rgb(0xccd3d6);
    p.drying = rgb(0xa3c7a4);
    p.shallow = rgb(0x8fc3ee);
    p.unsafe = rgb(0xb2d8f6);
    p.safe = rgb(0xd5e9f4);
    p.deep = rgb(0xeff7fa);
    p.land = rgb(0xe9d9ab);
    p.shore = rgb(0x6b5a33);
    p.quay = rgb(0x2f2b22);
    p.berth = rgb(0xa0381c);
    p.contour = rgb(0x6f97b3);
    p.safetyContour = rgb(0x1f4a70);
    p.sounding = rgb(0x46545e);
    p.shoalSounding = rgb(0x101418);
    p.graticule = see(0x51626e, 90);
    p.ink = rgb(0x14181c);
    p.quiet = rgb(0x3d474f);
    p.halo = see(0xffffff, 205);
    p.place = rgb(0x86226f);
    p.panel = see(0xf8fafb, 240);
    p.panelBorder = rgb(0x97a3ab);
    p.panelInk = rgb(0x14181c);
    p.panelQuiet = rgb(0x49545c);
    p.ownShip = rgb(0x08090a);
    p.hull = see(0xffffff, 200);
    p.track = rgb(0x1f2429);
    p.prediction = rgb(0x0b6b50);
    p.target = rgb(0x1d5a38);
    p.hostile = rgb(0xb0102a);
    p.route = rgb(0xa8420a);
    p.corridor = see(0xe87a2f, 46);
    p.zone = rgb(0x86226f);
    p.zoneDone = rgb(0x23703c);
    p.limit = rgb(0xb0102a);
    p.tool = rgb(0x99320a);
    p.flareWhite = rgb(0xb63aa6);
    p.flareRed = rgb(0xd31a2c);
    p.flareGreen = rgb(0x0c8a3d);
    return p;
}

ChartPalette dusk() {
    ChartPalette p;
    p.noDepths = rgb(0x2c3135);
    p.drying = rgb(0x2d4436);
    p.shallow = rgb(0x2a4f74);
    p.unsafe = rgb(0x22405c);
    p.safe = rgb(0x1a2c3b);
    p.deep = rgb(0x131c23);
    p.land = rgb(0x4a4227);
    p.shore = rgb(0xa2946a);
    p.quay = rgb(0xd0c6a6);
    p.berth = rgb(0xf09a72);
    p.contour = rgb(0x4b6b84);
    p.safetyContour = rgb(0x8fc1ea);
    p.sounding = rgb(0xa3b4c0);
    p.shoalSounding = rgb(0xf0f4f6);
    p.graticule = see(0xa9bac6, 62);
    p.ink = rgb(0xe4e9ec);
    p.quiet = rgb(0xc2cbd1);
    p.halo = see(0x0c1013, 190);
    p.place = rgb(0xe3a3da);
    p.panel = see(0x1b2024, 240);
    p.panelBorder = rgb(0x4d565d);
    p.panelInk = rgb(0xe4e9ec);
    p.panelQuiet = rgb(0xaab4bb);
    p.ownShip = rgb(0xffffff);
    p.hull = see(0x0c1013, 190);
    p.track = rgb(0xdfe5e8);
    p.prediction = rgb(0x59d1ac);
    p.target = rgb(0x77d49a);
    p.hostile = rgb(0xff7d86);
    p.route = rgb(0xf09a4e);
    p.corridor = see(0xf09a4e, 40);
    p.zone = rgb(0xe3a3da);
    p.zoneDone = rgb(0x77d49a);
    p.limit = rgb(0xff7d86);
    p.tool = rgb(0xffb066);
    p.flareWhite = rgb(0xe08ad6);
    p.flareRed = rgb(0xf05561);
    p.flareGreen = rgb(0x35c06c);
    p.marks = {rgb(0x0a0d10), rgb(0xd7dde1), rgb(0xe04a50), rgb(0x2eaa5e), rgb(0xe0b92e)};
    return p;
}

ChartPalette night() {
    ChartPalette p;
    p.noDepths = rgb(0x0f1010);
    p.drying = rgb(0x0d1a12);
    p.shallow = rgb(0x0c2036);
    p.unsafe = rgb(0x091828);
    p.safe = rgb(0x060e16);
    p.deep = rgb(0x030507);
    p.land = rgb(0x191508);
    p.shore = rgb(0x5b5131);
    p.quay = rgb(0x86794b);
    p.berth = rgb(0xb06a45);
    p.contour = rgb(0x24394b);
    p.safetyContour = rgb(0x4f7fa8);
    p.sounding = rgb(0x7c8474);
    p.shoalSounding = rgb(0xa8a785);
    p.graticule = see(0x8b8b68, 45);
    p.ink = rgb(0xa09a6c);
    p.quiet = rgb(0x928e68);
    p.halo = see(0x000000, 190);
    p.place = rgb(0xa877a2);
    p.panel = see(0x060706, 240);
    p.panelBorder = rgb(0x35321f);
    p.panelInk = rgb(0xa09a6c);
    p.panelQuiet = rgb(0x858160);
    p.ownShip = rgb(0xc9c39a);
    p.hull = see(0x000000, 190);
    p.track = rgb(0x9b9672);
    p.prediction = rgb(0x2f8f71);
    p.target = rgb(0x479563);
    p.hostile = rgb(0xc75059);
    p.route = rgb(0xa9682c);
    p.corridor = see(0xa9682c, 34);
    p.zone = rgb(0xa877a2);
    p.zoneDone = rgb(0x479563);
    p.limit = rgb(0xc75059);
    p.tool = rgb(0xb57c3e);
    p.flareWhite = rgb(0x9a5493);
    p.flareRed = rgb(0xa5363e);
    p.flareGreen = rgb(0x217a45);
    p.marks = {rgb(0x050605), rgb(0x93906f), rgb(0x9c3138), rgb(0x1f7542), rgb(0x957a1e)};
    return p;
}

}  // namespace

const ChartPalette& chartPalette(PaletteName name) {
    static const ChartPalette kDay = day(), kDusk = dusk(), kNight = night();
    switch (name) {
        case PaletteName::Dusk:
            return kDusk;
        case PaletteName::Night:
            return kNight;
        case PaletteName::Day:
            break;
    }
    return kDay;
}

}  // namespace sagara::ui
