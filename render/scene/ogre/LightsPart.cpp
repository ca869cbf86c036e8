#include "render/scene/ogre/LightsPart.h"

#include <OgreEntity.h>

#include <string>

#include "render/scene/light/MarkShape.h"
#include "render/scene/light/Visibility.h"
#include "render/scene/ogre/Axes.h"
#include "render/scene/ogre/Buffers.h"

namespace sagara::render {

LightsPart::LightsPart(const PartContext& context, const ShaderMaterial& solid, const SeaPart& sea)
    : m_sea(sea),
      m_material(context.materials.make("sprite", {Blending::Kind::Add, true, false})),
      m_sprites(context.scenes, m_material) {
    const core::Area& area = context.world.area;
    for (std::size_t i = 0; i < area.marks.size(); ++i) {
        const core::Mark& mark = area.marks[i];
        MarkInSea m{&mark, context.scenes.getRootSceneNode()->createChildSceneNode(), std::nullopt};
        if (mark.light) m.character = core::LightCharacter::parse(mark.light->character);
        const Solid shape = shapeOf(mark, area.ialaRegion == "B");
        if (!shape.indices.empty()) {
            auto* entity =
                context.scenes.createEntity(meshOf("mark-" + std::to_string(i), shape, solid.ogre()));
            entity->setRenderQueueGroup(kSolidQueue);
            m.node->attachObject(entity);
        }
        m_marks.push_back(std::move(m));
    }
    for (const ShipLook& ship : context.fleet.own) m_own.push_back(ship.form);
    for (const ShipLook& target : context.fleet.targets) m_targets.push_back(target.form);
}

void LightsPart::join(const Fleet& fleet, std::size_t fromTarget) {
    m_targets.resize(fromTarget);
    for (std::size_t i = fromTarget; i < fleet.targets.size(); ++i)
        m_targets.push_back(fleet.targets[i].form);
}

void LightsPart::advance(const Frame& frame) {
    const core::Area& area = frame.world.area;
    for (MarkInSea& m : m_marks) {
        const core::NorthEast p = m.mark->position;
        m.up_m = m.mark->floating ? m_sea.height_m(p) : area.meanTideLevel_m - frame.moment.tide_m;
    }
}

void LightsPart::shine(const Frame& frame, const View& view, core::NorthEast p, double up_m,
                       const Colour& colour, double strength_cd) {
    Ogre::Vector3 place = relativeTo(view.camera, p, up_m);
    const double away_m = static_cast<double>(place.length());
    const PointLook look =
        lookOf(illuminance_lux(strength_cd, away_m, frame.light.extinction_perM), frame.light.night);
    if (look.brightness <= 0.0) return;
    const auto scaled = [&](double f) { return Colour{f * colour[0], f * colour[1], f * colour[2]}; };
    // Out of its lantern or mast.
    place *= static_cast<float>(1.0 - std::min(0.05, 2.2 / std::max(1.0, away_m)));
    const double pixels = view.height / 720.0;
    const double size_px =
        std::max(1.6, look.size_px * pixels);  // smaller ones would miss the pixels' middles
    m_list.push_back({place, scaled(look.brightness), size_px, size_px});
    // Its path on the water, where the sight lines to it and from the eye are as steep.
    const double eye_m = view.camera.up_m;
    if (frame.light.night < 0.3 || up_m < 0.5 || away_m > 6000.0) return;
    Ogre::Vector3 water = place * static_cast<float>(eye_m / (eye_m + up_m));
    water.y = static_cast<float>(0.25 - eye_m);
    const double path_px = std::min(60.0, 900.0 * (eye_m + up_m) / away_m * 0.12) * pixels;
    m_list.push_back({water, scaled(0.30 * look.brightness * frame.light.night), 0.8 * size_px, path_px});
}

void LightsPart::shipLights(const Frame& frame, const View& view, const ShipForm& form,
                            const ShipPose& pose) {
    for (const ShipLight& light : lightsOf(form, pose.activity, pose.makingWay())) {
        const PlaceUp place = pointOnShip(pose, light.position.x, light.position.y, light.position.up);
        const double bearing = core::bearing_rad(place.position, view.camera.position) - pose.heading_rad;
        const double seen = light.seenFrom(bearing);
        if (seen > 0.0)
            shine(frame, view, place.position, place.up_m, light.colour, seen * candela(light.range_M));
    }
}

void LightsPart::look(const Frame& frame, const View& view) {
    m_list.clear();
    for (const MarkInSea& m : m_marks) {
        m.node->setPosition(relativeTo(view.camera, m.mark->position, m.up_m));
        if (!m.character || !m.character->lit(frame.moment.time)) continue;
        shine(frame, view, m.mark->position, m.up_m + m.mark->light->height_m, m.character->colour(),
              candela(m.mark->light->range_M));
    }
    for (std::size_t i = 0; i < std::min(m_own.size(), frame.moment.ships.size()); ++i)
        if (view.camera.inside != i) shipLights(frame, view, m_own[i], frame.moment.ships[i]);
    for (const TargetPose& target : frame.moment.targets)
        if (target.index < m_targets.size()) shipLights(frame, view, m_targets[target.index], target);
    m_sprites.fill(m_list);
    m_material.setVertex("u_screen", vector4(2.0 / view.width, 2.0 / view.height, 0.0, 0.0));
}

}  // namespace sagara::render
